#include "sim/config/dump.h"

#include <fmt/format.h>

#include "sim/config/path_visitor.h"
#include "sim/config/text.h"

namespace artu::sim {
namespace {

// Parameters of a group precede its subgroups in every `visit`, so a [header] at each enter() is enough.
class Dumper : public PathVisitor {
 public:
  std::string out = "# Configuration of the unit, resolved.  `artu run -c FILE` loads it.\n";

  void enter(const char* name, const char* text) override {
    PathVisitor::enter(name, text);
    out += fmt::format("\n# {}\n[{}]\n", text, group());
  }
  void integer(const char* name, std::uint32_t& value, hw::IntegerRange range, const char* unit,
               const char* text) override {
    line(name, integer_text(value), unit, range_text(range), text);
  }
  void real(const char* name, float& value, hw::RealRange range, const char* unit, const char* text) override {
    line(name, real_text(value), unit, range_text(range), text);
  }
  void flag(const char* name, bool& value, const char* text) override {
    line(name, flag_text(value), "", "true, false", text);
  }
  void table(const char* name, hw::TableValues values, hw::IntegerRange range, const char* unit,
             const char* text) override {
    line(name, table_text(values), unit, fmt::format("{} of {}", values.size, range_text(range)), text);
  }
  void choice(const char* name, unsigned& value, const std::vector<const char*>& names, const char* text) override {
    line(name, choice_text(names.at(value)), "", range_text(names), text);
  }

 private:
  void line(const char* name, const std::string& value, const std::string& unit, const std::string& range,
            const char* text) {
    out += fmt::format("{:<44}# {} [{}{}{}]\n", fmt::format("{} = {}", name, value), text, unit,
                       unit.empty() ? "" : ", ", range);
  }
};

}  // namespace

std::string dump_config(const hw::UnitConfig& config) {
  hw::UnitConfig copy = config;  // visit() hands out references to write to
  Dumper dumper;
  copy.visit(dumper);
  return dumper.out;
}

}  // namespace artu::sim
