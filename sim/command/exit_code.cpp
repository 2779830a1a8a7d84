#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <system_error>

#include "sim/command/commands.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// File names and other libraries' texts may hold line breaks; an input error is one line.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

int exit_code_of(const std::function<int()>& command) {
  try {
    const int code = command();
    if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category());
    return code;
  } catch (const InputError& error) {
    fmt::print(stderr, "error: {}\n", one_line(error.what()));
    return exit_input;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "error: out of memory; a smaller --size or scene would be right\n");
    return exit_input;
  } catch (const std::system_error& error) {  // fmt could not print
    fmt::print(stderr, "error: standard output: {}; a place with room would be right\n", error.code().message());
    return exit_input;
  } catch (const DeadLock& error) {
    fmt::print(stderr, "error: dead-lock: {}\n", error.what());
    return exit_dead_lock;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: internal: {}\n", error.what());
    return exit_internal;
  }
}

}  // namespace artu::sim
