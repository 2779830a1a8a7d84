#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include "sim/command/commands.h"
#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// File names and other libraries' texts may hold line breaks; an input error is one line.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// Not by fmt::print, which throws: where nobody can be told, the exit code still says what happened.
void say(const std::string& text) { std::fputs(("error: " + text + "\n").c_str(), stderr); }

/// What a descriptor of 0, 1, 2 that is closed would become is the first file that is opened: messages would end up in
/// it.  Standard output is opened for reading, so that writing to it fails as it would have: what a command was asked
/// for must not vanish with exit code 0.  Who closes standard error does not want to hear messages.
void fill_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // The lowest that is free is this one.
    if (open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

/// Of what fmt could not print, or of who else works for us.
int report(const std::system_error& error) {
  if (std::ferror(stdout) != 0) {
    say(fmt::format("standard output: {}; a place with room would be right", error.code().message()));
    return exit_input;
  }
  if (std::ferror(stderr) != 0) {
    say(fmt::format("standard error: {}; a place with room would be right", error.code().message()));
    return exit_input;
  }
  say(fmt::format("internal: {}", error.what()));
  return exit_internal;
}

}  // namespace

int exit_code_of(const std::function<int()>& command) {
  fill_standard_descriptors();
  try {
    const int code = command();
    if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category());
    return code == exit_fine && std::ferror(stderr) != 0 ? exit_input : code;  // a log that is not whole
  } catch (const InputError& error) {
    say(one_line(error.what()));
    return exit_input;
  } catch (const std::bad_alloc&) {
    std::fputs("error: out of memory; a smaller --size or scene would be right\n", stderr);
    return exit_input;
  } catch (const std::filesystem::filesystem_error& error) {
    say(one_line(file_error_of(error).what()));
    return exit_input;
  } catch (const std::system_error& error) {
    return report(error);
  } catch (const DeadLock& error) {
    say(fmt::format("dead-lock: {}", error.what()));
    return exit_dead_lock;
  } catch (const std::exception& error) {
    say(fmt::format("internal: {}", error.what()));
    return exit_internal;
  }
}

}  // namespace artu::sim
