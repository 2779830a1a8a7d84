#include "sim/html/json_file.h"

#include <algorithm>
#include <stdexcept>

#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr int deepest = 16;  // ours are nested no more than 8 times; writing a value goes down by recursion

bool is(const OrderedJson& json, JsonShape::Kind kind) {
  switch (kind) {
    case JsonShape::Kind::object:
      return json.is_object();
    case JsonShape::Kind::array:
      return json.is_array();
    case JsonShape::Kind::string:
      return json.is_string();
    case JsonShape::Kind::number:
      return json.is_number();
    case JsonShape::Kind::number_list:
      return json.is_array() && std::all_of(json.begin(), json.end(), [](const auto& v) { return v.is_number(); });
    case JsonShape::Kind::numbers:
      if (!json.is_object()) return false;
      for (const auto& value : json) {
        if (!value.is_number() && !value.is_null()) return false;
      }
      return true;
  }
  throw std::logic_error("no such kind");
}

const char* name_of(JsonShape::Kind kind) {
  static const char* const names[] = {"an object",        "a list", "a text", "a number", "an object of numbers",
                                      "a list of numbers"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace

OrderedJson read_json(const std::string& file) {
  const std::string text = read_file(file);
  try {
    return OrderedJson::parse(text, [&file](int depth, OrderedJson::parse_event_t, OrderedJson&) {
      if (depth > deepest) throw InputError(file, "is nested too deeply; a file that artu wrote would be right");
      return true;
    });
  } catch (const OrderedJson::parse_error& error) {
    throw InputError(
        file, "is no JSON (near byte " + std::to_string(error.byte) + "); the file as artu wrote it would be right");
  } catch (const OrderedJson::exception&) {  // a number that is none
    throw InputError(file, "is no JSON that can be read; the file as artu wrote it would be right");
  }
}

const OrderedJson& JsonShape::need(const OrderedJson& json, const std::vector<std::string>& keys, Kind kind) const {
  const OrderedJson* value = &json;
  std::string path;
  for (const std::string& key : keys) {
    path += (path.empty() ? "" : ".") + key;
    if (!value->is_object() || !value->contains(key)) fail("has no " + path, "the file as artu wrote it");
    value = &(*value)[key];
  }
  if (!is(*value, kind)) fail(path + " is not " + name_of(kind), "the file as artu wrote it");
  return *value;
}

void JsonShape::fail(const std::string& what, const std::string& right) const {
  throw InputError(file_, what + "; " + right + " would be right");
}

}  // namespace artu::sim
