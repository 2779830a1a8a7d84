// The one exception for bad input, in every room: a line that says what, where and what would be right.
#pragma once

#include <stdexcept>
#include <string>

namespace artu {

/// Ends the program with exit code 2 and `error: WHERE: WHAT`.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& where, const std::string& what)
      : std::runtime_error(where.empty() ? what : where + ": " + what) {}
};

}  // namespace artu
