#include "sim/import/gltf_accessor.h"

#include <cmath>
#include <cstring>

#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr std::uint64_t max_numbers = std::uint64_t{1} << 30;  // decoded from one file
constexpr std::uint64_t max_zeros = std::uint64_t{1} << 22;    // elements of an accessor that has no bytes

double to_number(const unsigned char* p, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const auto v = static_cast<std::int8_t>(*p);
      return normalized ? std::max(v / 127.0, -1.0) : v;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalized ? *p / 255.0 : *p;
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      std::int16_t v;
      std::memcpy(&v, p, 2);
      return normalized ? std::max(v / 32767.0, -1.0) : v;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      std::uint16_t v;
      std::memcpy(&v, p, 2);
      return normalized ? v / 65535.0 : v;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: {
      std::uint32_t v;
      std::memcpy(&v, p, 4);
      return v;
    }
    default: {
      float v;
      std::memcpy(&v, p, 4);
      return v;
    }
  }
}

std::string number(std::uint64_t n) { return std::to_string(n); }

}  // namespace

const tinygltf::Accessor& GltfAccessors::get(int accessor, const std::string& where) const {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= file_.json.accessors.size())
    throw InputError(where, "accessor " + std::to_string(accessor) + " does not exist; there are " +
                                number(file_.json.accessors.size()));
  return file_.json.accessors[static_cast<std::size_t>(accessor)];
}

std::size_t GltfAccessors::count(int accessor, const std::string& where) const { return get(accessor, where).count; }

int GltfAccessors::components(int accessor, const std::string& where) const {
  return tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(get(accessor, where).type));
}

GltfAccessors::Bytes GltfAccessors::view(int index, const std::string& where) const {
  if (index < 0 || static_cast<std::size_t>(index) >= file_.json.bufferViews.size())
    throw InputError(where, "buffer view " + std::to_string(index) + " does not exist; there are " +
                                number(file_.json.bufferViews.size()));
  const tinygltf::BufferView& view = file_.json.bufferViews[static_cast<std::size_t>(index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= file_.json.buffers.size())
    throw InputError(where, "bufferViews[" + std::to_string(index) + "] is of buffer " + std::to_string(view.buffer) +
                                ", which does not exist");
  const auto& data = file_.json.buffers[static_cast<std::size_t>(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
    throw InputError(where, "bufferViews[" + std::to_string(index) + "] (offset " + number(view.byteOffset) +
                                ", length " + number(view.byteLength) + ") leaves its buffer of " +
                                number(data.size()) + " bytes");
  return {data.data() + view.byteOffset, view.byteLength};
}

template <typename T, typename Convert>
std::vector<T> GltfAccessors::read(const tinygltf::Accessor& a, Convert convert, const std::string& where) {
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(a.componentType));
  const int width = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type));
  if (size < 1 || size > 4 || width < 1 || a.componentType == TINYGLTF_COMPONENT_TYPE_INT)
    throw InputError(where, "component type " + std::to_string(a.componentType) + " is not one of glTF's");
  if (width == 4 && a.type == TINYGLTF_TYPE_MAT2) throw InputError(where, "2 x 2 matrices are not used by glTF");
  const std::uint64_t element = static_cast<std::uint64_t>(size) * static_cast<std::uint64_t>(width);

  const unsigned char* data = nullptr;
  std::uint64_t stride = element;
  if (a.bufferView >= 0) {
    const Bytes bytes = view(a.bufferView, where);
    const std::uint64_t declared = file_.json.bufferViews[static_cast<std::size_t>(a.bufferView)].byteStride;
    if (declared != 0) stride = declared;
    if (stride < element)
      throw InputError(where,
                       "byteStride " + number(stride) + " is less than an element's " + number(element) + " bytes");
    if (a.byteOffset > bytes.size || (a.count > 0 && (element > bytes.size - a.byteOffset ||
                                                      (a.count - 1) > (bytes.size - a.byteOffset - element) / stride)))
      throw InputError(where, number(a.count) + " elements of " + number(element) + " bytes at offset " +
                                  number(a.byteOffset) + ", stride " + number(stride) + ", leave the buffer view of " +
                                  number(bytes.size) + " bytes");
    data = bytes.data + a.byteOffset;
  } else if (a.count > max_zeros) {
    throw InputError(where, number(a.count) + " elements without a buffer view; the limit is " + number(max_zeros));
  }
  decoded_ += a.count * static_cast<std::uint64_t>(width);
  if (decoded_ > max_numbers)
    throw InputError(where, "the file's accessors hold more than " + number(max_numbers) + " numbers");

  std::vector<T> out(a.count * static_cast<std::size_t>(width));
  const auto store = [&](std::size_t element_index, const unsigned char* p) {
    for (int c = 0; c < width; ++c) out[element_index * static_cast<std::size_t>(width) + c] = convert(p + c * size);
  };
  for (std::size_t i = 0; data && i < a.count; ++i) store(i, data + i * stride);

  if (a.sparse.isSparse) {
    if (a.sparse.count < 0 || static_cast<std::uint64_t>(a.sparse.count) > a.count || a.sparse.indices.byteOffset < 0 ||
        a.sparse.values.byteOffset < 0)
      throw InputError(where, "sparse.count is not between 0 and the accessor's count");
    const auto n = static_cast<std::uint64_t>(a.sparse.count);
    const int index_type = a.sparse.indices.componentType;
    if (index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
      throw InputError(where, "sparse.indices have component type " + std::to_string(index_type) +
                                  "; unsigned byte, short or int is allowed");
    const auto index_size =
        static_cast<std::uint64_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(index_type)));
    const Bytes indices = view(a.sparse.indices.bufferView, where), values = view(a.sparse.values.bufferView, where);
    const auto index_at = static_cast<std::uint64_t>(a.sparse.indices.byteOffset);
    const auto value_at = static_cast<std::uint64_t>(a.sparse.values.byteOffset);
    if (index_at + n * index_size > indices.size || value_at + n * element > values.size)
      throw InputError(where, "sparse indices or values leave their buffer view");
    for (std::uint64_t i = 0; i < n; ++i) {
      const double at = to_number(indices.data + index_at + i * index_size, index_type, false);
      if (at >= static_cast<double>(a.count))
        throw InputError(where, "sparse index " + number(static_cast<std::uint64_t>(at)) + " is not below the count " +
                                    number(a.count));
      store(static_cast<std::size_t>(at), values.data + value_at + i * element);
    }
  }
  return out;
}

namespace {

/// `allowed` lists widths as characters: '1' ... '4', and '@' ('0' + 16) for a 4 x 4 matrix.
void check_width(int accessor, int width, const char* allowed, const std::string& where) {
  if (width < 1 || !std::strchr(allowed, '0' + width))
    throw InputError(where, "accessor " + std::to_string(accessor) + " has " + std::to_string(width) +
                                " numbers an element, which does not fit its use");
}

}  // namespace

std::vector<float> GltfAccessors::floats(int accessor, const char* allowed, const std::string& where) {
  const tinygltf::Accessor& a = get(accessor, where);
  const std::string place = where + " (accessors[" + std::to_string(accessor) + "])";
  check_width(accessor, components(accessor, where), allowed, where);
  const int type = a.componentType;
  const bool normalized = a.normalized;
  std::vector<float> out = read<float>(
      a, [=](const unsigned char* p) { return static_cast<float>(to_number(p, type, normalized)); }, place);
  const auto width = static_cast<std::size_t>(components(accessor, where));
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!std::isfinite(out[i])) throw InputError(place, "element " + number(i / width) + " is not a finite number");
  }
  return out;
}

std::vector<std::uint32_t> GltfAccessors::integers(int accessor, const char* allowed, const std::string& where) {
  const tinygltf::Accessor& a = get(accessor, where);
  const std::string place = where + " (accessors[" + std::to_string(accessor) + "])";
  check_width(accessor, components(accessor, where), allowed, where);
  const int type = a.componentType;
  if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
    throw InputError(place, "component type " + std::to_string(type) + "; unsigned byte, short or int is needed");
  return read<std::uint32_t>(
      a, [=](const unsigned char* p) { return static_cast<std::uint32_t>(to_number(p, type, false)); }, place);
}

}  // namespace artu::sim
