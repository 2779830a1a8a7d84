// JSON files that somebody else may have written: every surprise is one line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace artu::sim {

using OrderedJson = nlohmann::ordered_json;

/// Throws InputError where the file cannot be read, is no JSON, or is nested deeper than any of ours.
OrderedJson read_json(const std::string& file);

/// What a file must have, or InputError with the file's name and the path of what is wrong.
class JsonShape {
 public:
  explicit JsonShape(std::string file) : file_(std::move(file)) {}
  enum class Kind { object, array, string, number, numbers, number_list };
  /// json[keys[0]][keys[1]]...; `numbers` is an object whose values are numbers, or null for what is not finite.
  const OrderedJson& need(const OrderedJson& json, const std::vector<std::string>& keys, Kind kind) const;
  /// `what` is wrong, `right` would not be.
  [[noreturn]] void fail(const std::string& what, const std::string& right) const;

 private:
  std::string file_;
};

}  // namespace artu::sim
