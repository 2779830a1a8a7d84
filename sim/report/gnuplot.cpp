#include "sim/report/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "sim/report/file.h"
#include "sim/report/interruption.h"
#include "traces/error.h"

extern char** environ;

namespace artu::sim {
namespace fs = std::filesystem;

std::string run_gnuplot(const std::string& folder, const std::string& script) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  }
  sigset_t none;  // ours are blocked: a thread waits for them
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);

  char program[] = "gnuplot";
  std::string argument = script;
  char* const words[] = {program, argument.data(), nullptr};
  int error = 0;
  const KillOnInterrupt child([&] {
    pid_t pid = -1;
    error = posix_spawnp(&pid, program, &files, &attributes, words, environ);
    return error == 0 ? pid : -1;
  });
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  if (error == ENOENT) return "gnuplot is not installed";
  if (error != 0) return fmt::format("gnuplot does not start: {}", std::strerror(error));
  int status = 0;
  while (waitpid(child.pid(), &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "gnuplot failed";
}

namespace {

/// gnuplot does not say when the disk is full.
bool ends_with(const std::string& file, const std::string& end) {
  constexpr std::streamoff look_at = 16;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(size - look_at, 0));
  const std::string tail{std::istreambuf_iterator<char>(in), {}};
  return tail.find(end) != std::string::npos;
}

}  // namespace

std::string draw_plot(const std::string& folder, const Plot& plot) {
  const auto file = [&](const std::string& name) { return folder + "/" + name; };
  write_file(file(plot.data_file()), plot.data);
  write_file(file(plot.script_file()), plot.script);
  const std::string problem = run_gnuplot(folder, plot.script_file());
  std::error_code ignored;
  if (problem.empty()) {
    for (const auto& [ending, end] : {std::pair{".svg", "</svg>"}, std::pair{".png", "IEND"}}) {
      const std::string name = plot.name + ending;
      if (fs::exists(file(name), ignored) && !ends_with(file(name), end)) {
        throw InputError(file(name), "gnuplot could not write all of it; a disk with room would be right");
      }
    }
    return "";
  }
  for (const char* begun : {".svg", ".png"}) fs::remove(file(plot.name + begun), ignored);
  return fmt::format("{}; {} is for it", problem, plot.script_file());
}

std::string gnuplot_literal(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += c;
    out += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return out + "'";
}

}  // namespace artu::sim
