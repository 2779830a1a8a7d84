// The structs of frame.fbs and of frame.h are the same bytes, so arrays are copied whole.
#pragma once

#include <cstring>
#include <type_traits>

#include "frame_generated.h"
#include "traces/frame.h"

namespace artu::traces {

static_assert(FLATBUFFERS_LITTLEENDIAN, "arrays are copied as they lie in memory");

template <typename To, typename From>
To same_bytes(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  To to;
  std::memcpy(static_cast<void*>(&to), &from, sizeof(to));
  return to;
}

inline fb::Vec3 wire(const Vec3& v) { return same_bytes<fb::Vec3>(v); }
inline fb::Camera wire(const Camera& c) { return same_bytes<fb::Camera>(c); }
inline Vec3 plain(const fb::Vec3& v) { return same_bytes<Vec3>(v); }
inline Camera plain(const fb::Camera& c) { return same_bytes<Camera>(c); }

}  // namespace artu::traces
