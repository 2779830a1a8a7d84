// Which pictures of a run's frames are written, each with a key to its colours.
#pragma once

#include <bitset>
#include <memory>
#include <string>

#include "sim/compare/full_render.h"
#include "sim/report/apng.h"

namespace artu::sim {

enum class Picture : std::uint8_t {
  frame,
  full,  // every pixel ray traced
  decision,
  hit_class,
  threshold,
  difference,
  error,      // frame against full
  cycles,     // from dispatch to write
  strip,      // frame, full, error, decision and threshold beside each other
  animation,  // of all frames: frame, error and decision beside each other
};
inline constexpr std::size_t picture_count = 10;
/// As in the files' names and in `--pictures`.
inline constexpr const char* picture_names[picture_count] = {"frame",      "full",  "decision", "class", "threshold",
                                                             "difference", "error", "cycles",   "strip", "animation"};

class PictureSet {
 public:
  PictureSet() = default;
  PictureSet(std::initializer_list<Picture> pictures) {
    for (const Picture picture : pictures) add(picture);
  }
  void add(Picture picture) { set_.set(static_cast<std::size_t>(picture)); }
  bool has(Picture picture) const { return set_.test(static_cast<std::size_t>(picture)); }
  bool any() const { return set_.any(); }
  /// Whether one of them shows the full render or compares with it.
  bool needs_full() const;

 private:
  std::bitset<picture_count> set_;
};

/// Of `animation` one of its frames.  `full` may be null for those that do not need it.
Image picture_of(Picture picture, const FrameOutcome& outcome, const FullRender* full);

/// Writes `prefix` + "frame_0000.png" and so on, with the frame's index, and `prefix` + "animation.png".
class PictureWriter {
 public:
  PictureWriter(const std::string& prefix, const PictureSet& set, std::uint32_t frames, double fps);
  /// Writes the files of a frame; returns its part of the animation, "" where there is none.  Any process may call it.
  std::string write(const FrameOutcome& outcome, const FullRender* full) const;
  /// What write() returned, frame after frame, in the process that has made the writer.
  void append(const std::string& part);
  void finish();

 private:
  std::string prefix_;
  PictureSet set_;
  std::unique_ptr<AnimatedPng> animation_;
};

}  // namespace artu::sim
