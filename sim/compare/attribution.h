// Which decisions a picture's error comes from.
//
// A ray-traced pixel is that of the full render, so what differs was interpolated.  A pixel that was interpolated came
// from a pair (docs/selective-rendering.md, passes): what the pair and the pixel itself show in the full render says
// why it is wrong.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "sim/compare/full_render.h"
#include "sim/compare/regions.h"

namespace artu::sim {

enum class Cause : std::uint8_t {
  within,  // pair and pixel show the same class: texture, shading, an edge within one class
  edge,    // the pair's two show different classes: a silhouette runs between them
  missed,  // the pair shows one class, the pixel another: something thinner than the pair's distance
  traced,  // not interpolated: only a fault makes an error here
};
inline constexpr const char* cause_names[] = {"within", "edge", "missed", "traced"};

/// What is held apart.  Where no pair was interpolated its two areas are the pixel's own.
struct Decided {
  std::uint8_t pass = 0;
  Cause cause = Cause::traced;
  Area first = Area::whole, second = Area::whole;  // of the pair, in the order of Area
  Area pixel = Area::whole;                        // of the pixel itself

  std::string pair() const;  // "dynamic-static"
  bool operator<(const Decided& other) const {
    return std::tie(cause, pass, first, second, pixel) <
           std::tie(other.cause, other.pass, other.first, other.second, other.pixel);
  }
};

struct Share {
  std::uint64_t pixels = 0, squares = 0;  // squared differences over all channels
};

struct WrongPixel {
  std::uint32_t frame = 0, x = 0, y = 0;
  Decided decided;
  std::int16_t threshold = -1, difference = -1;
  std::array<std::uint8_t, 3> got{}, full{};
  std::uint64_t squares = 0;
};

/// The pixels that an interpolated one is the mean of: a pair, or two.
struct Sources {
  std::array<std::size_t, 4> pixels{};  // indices into the rows
  std::size_t count = 0;
};
/// Of a pixel that was interpolated its place alone says which they are, with any distance of the sampling pixels. With
/// `average` the centre of four is the mean of all of them (a pass of its own), else of those above and below.
Sources sources_of(std::size_t index, std::uint32_t width, bool average = false);

class Attribution {
 public:
  /// Keeps the `worst` pixels with the largest squares.
  explicit Attribution(std::size_t worst = 0, bool average = false) : kept_(worst), average_(average) {}
  void add(const FullRender& full, const FrameOutcome& outcome);
  /// Of later frames.
  void add(const Attribution& later);

  const std::map<Decided, Share>& shares() const { return shares_; }
  /// The worst first; among equal ones the order of frames, rows, columns.
  const std::vector<WrongPixel>& worst() const { return worst_; }
  std::uint64_t squares() const;

  /// sim/jobs/archive.h
  template <class A>
  friend void transfer(A& archive, Attribution& a) {
    pass(archive, a.kept_);
    pass(archive, a.average_);
    pass(archive, a.shares_);
    pass(archive, a.worst_);
  }

 private:
  void keep(const WrongPixel& pixel);

  std::size_t kept_;
  bool average_;
  std::map<Decided, Share> shares_;
  std::vector<WrongPixel> worst_;
};

}  // namespace artu::sim
