#include "traces/error.h"

namespace artu {

std::string without_control_characters(const std::string& text) {
  const char* const digits = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if ((code >= 32 && code != 127) || c == '\n') {
      out += c;
    } else {
      out += {'\\', 'x', digits[code >> 4], digits[code & 15]};
    }
  }
  return out;
}

}  // namespace artu
