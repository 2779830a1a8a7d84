#include "sim/html/run_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "sim/config/configuration.h"
#include "sim/config/json.h"
#include "sim/config/parameter_list.h"
#include "sim/explain/explain.h"
#include "sim/explain/stored_run.h"
#include "sim/html/json_file.h"
#include "sim/html/page.h"
#include "sim/report/file.h"
#include "sim/report/picture_set.h"
#include "sim/report/stats_json.h"
#include "sim/report/timeline_json.h"
#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

using Kind = JsonShape::Kind;

OrderedJson read_manifest(const std::string& file) {
  OrderedJson manifest = read_json(file);
  const JsonShape shape(file);
  if (shape.need(manifest, {"program"}, Kind::string) != "artu") shape.fail("is of another program", "artu's");
  shape.need(manifest, {"version"}, Kind::string);
  for (const OrderedJson& word : shape.need(manifest, {"command"}, Kind::array)) {
    if (!word.is_string()) shape.fail("command holds what is no text", "the file as artu wrote it");
  }
  for (const char* key : {"file", "sha256", "kind"}) shape.need(manifest, {"input", key}, Kind::string);
  for (const char* key : {"first", "last"}) shape.need(manifest, {"frames", key}, Kind::number);
  for (const char* key : {"width", "height"}) shape.need(manifest, {"size", key}, Kind::number);
  shape.need(manifest, {"fidelity"}, Kind::string);
  return manifest;
}

/// What frames and totals both have.
void check_counts(const JsonShape& shape, const OrderedJson& json) {
  for (const char* key : {"rays", "pixels", "candidates", "triangles"}) shape.need(json, {key}, Kind::numbers);
  const OrderedJson& blocks = shape.need(json, {"blocks"}, Kind::object);
  for (const auto& [block, counters] : blocks.items()) shape.need(blocks, {block}, Kind::numbers);
}

OrderedJson read_stats(const std::string& file) {
  OrderedJson stats = read_json(file);
  const JsonShape shape(file);
  if (shape.need(stats, {"schema"}, Kind::number) != StatsJson::schema) {
    shape.fail(fmt::format("has schema {}", stats["schema"].dump()), fmt::format("schema {}", StatsJson::schema));
  }
  for (const OrderedJson& frame : shape.need(stats, {"frames"}, Kind::array)) {
    shape.need(frame, {"index"}, Kind::number);
    for (const OrderedJson& violation : shape.need(frame, {"violations"}, Kind::array)) {
      if (!violation.is_string()) shape.fail("violations holds what is no text", "the file as artu wrote it");
    }
    check_counts(shape, frame);
  }
  shape.need(stats, {"fidelity", "mode"}, Kind::string);
  shape.need(stats, {"totals", "frames"}, Kind::number);
  check_counts(shape, stats["totals"]);
  shape.need(stats, {"derived"}, Kind::object);
  for (const char* part : {"energy", "demand"}) {
    if (stats.contains(part) && !stats[part].is_null()) shape.need(stats, {part}, Kind::object);
  }
  return stats;
}

/// stats.txt has a unit and a text for every number: "name value unit # text".
OrderedJson read_meanings(const std::string& file) {
  OrderedJson meanings = OrderedJson::object();
  std::istringstream lines(read_file(file));
  bool numbers = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("# All numbers", 0) == 0) numbers = true;
    const std::size_t mark = line.find(" # ");
    if (!numbers || mark == std::string::npos || line[0] == '#') continue;
    std::istringstream words(line.substr(0, mark));
    std::string name, value, unit, more;
    words >> name >> value >> unit;
    while (words >> more) unit += " " + more;
    meanings[name] = {unit, line.substr(mark + 3)};
  }
  return meanings;
}

/// What `artu explain` prints, a list of [what, text]; or a text, why it cannot.
OrderedJson explanation_of(const std::string& folder) {
  std::istringstream text;
  try {
    const StoredRun run = read_run(folder);
    text.str(format_explanation(explain(run.totals, run.unit)));
  } catch (const InputError& error) {
    return error.what();
  } catch (const std::logic_error& error) {  // counters that this version does not know
    return error.what();
  }
  OrderedJson lines = OrderedJson::array();
  for (std::string line; std::getline(text, line);) {
    const std::size_t end = line.find("  "), begin = line.find_first_not_of(' ', end);
    if (begin == std::string::npos) continue;
    lines.push_back({line.substr(0, end), line.substr(begin)});
  }
  return lines;
}

/// A frame of timeline.json.
void check_timeline(const JsonShape& shape, const OrderedJson& frame) {
  for (const char* key : {"index", "cycles", "interval"}) shape.need(frame, {key}, Kind::number);
  const std::size_t looks = shape.need(frame, {"at"}, Kind::number_list).size();
  if (looks == 0) shape.fail("at is empty", "one look or more");
  const auto looked = [&](const std::vector<std::string>& keys) {
    if (shape.need(frame, keys, Kind::number_list).size() != looks) {
      shape.fail(keys.back() + " has not one value a look", "one");
    }
  };
  for (const OrderedJson& phase : shape.need(frame, {"phases"}, Kind::array)) {
    shape.need(phase, {"phase"}, Kind::string);
    for (const char* key : {"from", "to"}) shape.need(phase, {key}, Kind::number);
    shape.need(phase, {"blocks"}, Kind::object);
    for (const auto& [block, counters] : phase["blocks"].items()) shape.need(phase, {"blocks", block}, Kind::numbers);
  }
  for (const auto& [block, states] : shape.need(frame, {"blocks"}, Kind::object).items()) {
    for (std::size_t s = 0; s < hw::state_count; ++s) {
      looked({"blocks", block, hw::state_name(static_cast<hw::State>(s))});
    }
  }
  if (shape.need(frame, {"channels"}, Kind::object).empty()) shape.fail("has no channels", "those of the unit");
  for (const auto& [channel, of] : frame["channels"].items()) {
    shape.need(frame, {"channels", channel, "capacity"}, Kind::number);
    looked({"channels", channel, "level"});
  }
  for (const char* count : {"read_bytes", "write_bytes", "rays_begun", "rays_finished"}) looked({"counts", count});
  for (const auto& [kind, visits] : shape.need(frame, {"visits"}, Kind::object).items()) {
    shape.need(frame, {"visits", kind}, Kind::number_list);
  }
}

/// Null where the run has not recorded it.
OrderedJson read_timeline(const std::string& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  OrderedJson timeline = read_json(file);
  const JsonShape shape(file);
  if (shape.need(timeline, {"schema"}, Kind::number) != TimelineJson::schema) {
    shape.fail(fmt::format("has schema {}", timeline["schema"].dump()), fmt::format("schema {}", TimelineJson::schema));
  }
  if (shape.need(timeline, {"frames"}, Kind::array).empty()) shape.fail("has no frames", "one frame or more");
  for (const OrderedJson& frame : timeline["frames"]) check_timeline(shape, frame);
  return timeline;
}

void flatten(const OrderedJson& json, const std::string& path, std::map<std::string, OrderedJson>& values) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) flatten(value, path.empty() ? key : path + "." + key, values);
  } else {
    values[path] = json;
  }
}

std::map<std::string, OrderedJson> values_of(const hw::UnitConfig& unit) {
  std::map<std::string, OrderedJson> values;
  flatten(json_of(unit), "", values);
  return values;
}

/// Every parameter: [path, value, default, unit, range, text].
OrderedJson read_parameters(const std::string& file) {
  const auto values = values_of(Configuration::of({file}, {}).unit()), defaults = values_of({});
  OrderedJson list = OrderedJson::array();
  for (const ParameterInfo& p : parameter_list()) {
    list.push_back({p.path, values.at(p.path), defaults.at(p.path), p.unit, p.range, p.text});
  }
  return list;
}

struct PictureFile {
  std::size_t kind;
  std::uint32_t frame;
  fs::path file;
  std::uint64_t bytes;
};

/// "frame_0000.png" ...; strips and animations show again what the others show.
std::vector<PictureFile> picture_files(const std::string& folder) {
  std::vector<PictureFile> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    for (std::size_t kind = 0; kind < picture_count; ++kind) {
      if (kind == static_cast<std::size_t>(Picture::strip)) continue;
      const std::string begin = std::string(picture_names[kind]) + "_";
      if (name.rfind(begin, 0) != 0 || name.size() < begin.size() + 8 || entry.path().extension() != ".png") continue;
      const std::string digits = name.substr(begin.size(), name.size() - begin.size() - 4);
      if (digits.size() > 9 ||
          !std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c); }))
        continue;
      refuse_irregular(entry.path().string());
      files.push_back({kind, static_cast<std::uint32_t>(std::stoul(digits)), entry.path(), entry.file_size()});
    }
  }
  std::sort(files.begin(), files.end(), [](const PictureFile& a, const PictureFile& b) {
    return std::tie(a.kind, a.frame) < std::tie(b.kind, b.frame);
  });
  return files;
}

/// Every frame, or every second, or every third ... : the first of these that are no more than `bytes` together.
std::set<std::uint32_t> evenly(const std::map<std::uint32_t, std::uint64_t>& sizes, std::uint64_t bytes) {
  for (std::size_t stride = 1; stride <= sizes.size(); ++stride) {
    std::set<std::uint32_t> kept;
    std::uint64_t sum = 0;
    std::size_t number = 0;
    for (const auto& [frame, size] : sizes) {
      if (number++ % stride != 0) continue;
      kept.insert(frame);
      sum += size;
    }
    if (sum <= bytes) return kept;
  }
  return {};
}

}  // namespace

bool is_run_folder(const std::string& folder) {
  std::error_code ignored;
  return fs::exists(fs::path(folder) / "manifest.json", ignored) &&
         fs::exists(fs::path(folder) / "stats.json", ignored);
}

std::string folder_name(const std::string& folder) {
  fs::path name = fs::path(folder).lexically_normal();
  if (!name.has_filename()) name = name.parent_path();
  return name.filename().string();
}

nlohmann::ordered_json run_data(const std::string& folder) {
  if (!is_run_folder(folder)) {
    throw InputError(
        folder,
        "is no folder of a run (it lacks manifest.json or stats.json); one that artu run or artu sweep made "
        "would be right");
  }
  const auto file = [&folder](const char* name) { return (fs::path(folder) / name).string(); };
  OrderedJson run = {{"name", folder_name(folder)},
                     {"folder", folder},
                     {"manifest", read_manifest(file("manifest.json"))},
                     {"stats", read_stats(file("stats.json"))},
                     {"meanings", read_meanings(file("stats.txt"))},
                     {"parameters", read_parameters(file("config.toml"))},
                     {"explanation", explanation_of(folder)},
                     {"timeline", read_timeline(file("timeline.json"))},
                     {"pictures", OrderedJson::array()}};
  return run;
}

std::size_t add_pictures(nlohmann::ordered_json& run, const std::string& folder, std::uint64_t bytes) {
  const std::vector<PictureFile> files = picture_files(folder);
  std::map<std::uint32_t, std::uint64_t> sizes;  // by frame
  for (const PictureFile& file : files) sizes[file.frame] += file.bytes;
  const std::set<std::uint32_t> kept = evenly(sizes, bytes);
  for (const PictureFile& file : files) {
    if (kept.count(file.frame) == 0) continue;
    run["pictures"].push_back(
        {{"kind", picture_names[file.kind]}, {"frame", file.frame}, {"png", base64(read_file(file.file.string()))}});
  }
  run["frames_left_out"] = sizes.size() - kept.size();
  return sizes.size() - kept.size();
}

}  // namespace artu::sim
