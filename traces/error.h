// The one exception for bad input, in every room: a line that says what, where and what would be right.
#pragma once

#include <stdexcept>
#include <string>

namespace artu {

/// Names and words of files may hold anything: a zero byte would end a message, an escape sequence run in a terminal.
/// Line breaks stay.
std::string without_control_characters(const std::string& text);

/// Ends the program with exit code 2 and `error: WHERE: WHAT`.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& where, const std::string& what)
      : std::runtime_error(without_control_characters(where.empty() ? what : where + ": " + what)) {}
};

/// One that is the file system's, not that of what was asked for: at another time the same may work.
class FileError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace artu
