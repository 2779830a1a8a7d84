#include "sim/config/toml_texts.h"

#include <fmt/format.h>

#include "traces/error.h"

namespace artu::sim {
namespace {

void refuse(std::string_view text, const toml::node& node, const PlaceOf& place_of) {
  if (text.find('\0') == std::string_view::npos) return;
  throw InputError(place_of(node),
                   fmt::format("\"{}\" has a zero byte in it; a text without would be right", text.substr(0, 80)));
}

void check(const toml::node& node, const PlaceOf& place_of) {
  if (const auto* text = node.as_string()) refuse(text->get(), node, place_of);
  if (const auto* array = node.as_array()) {
    for (const toml::node& item : *array) check(item, place_of);
  }
  if (const auto* table = node.as_table()) refuse_zero_bytes(*table, place_of);
}

}  // namespace

void refuse_zero_bytes(const toml::table& table, const PlaceOf& place_of) {
  for (const auto& [key, node] : table) {
    refuse(key.str(), node, place_of);
    check(node, place_of);
  }
}

}  // namespace artu::sim
