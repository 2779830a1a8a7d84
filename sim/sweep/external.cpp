#include "sim/sweep/external.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "sim/report/interruption.h"

extern char** environ;

namespace artu::sim {
namespace {

struct Pipe {
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  void close_end(std::size_t end) {
    if (ends[end] >= 0) close(ends[end]);
    ends[end] = -1;
  }
  std::array<int, 2> ends{};
};

/// Both until they end: a program that fills one must not wait for the other to be read.
void read_both(Pipe& a, std::string& out, Pipe& b, std::string& err) {
  std::array<pollfd, 2> polled{{{a.ends[0], POLLIN, 0}, {b.ends[0], POLLIN, 0}}};
  while (polled[0].fd >= 0 || polled[1].fd >= 0) {
    if (poll(polled.data(), polled.size(), -1) < 0) {
      if (errno == EINTR) continue;
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (polled[i].fd < 0 || polled[i].revents == 0) continue;
      std::array<char, 4096> buffer{};
      const ssize_t got = read(polled[i].fd, buffer.data(), buffer.size());
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) polled[i].fd = -1;
      if (got > 0) (i == 0 ? out : err).append(buffer.data(), static_cast<std::size_t>(got));
    }
  }
}

}  // namespace

ProgramOutput run_program(const std::vector<std::string>& words) {
  Pipe out, err;
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, out.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, err.ends[1], STDERR_FILENO);
  sigset_t none;  // ours are blocked: a thread waits for them
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  std::vector<std::string> copies = words;
  std::vector<char*> argv;
  for (std::string& word : copies) argv.push_back(word.data());
  argv.push_back(nullptr);
  int error = 0;
  const KillOnInterrupt child([&] {
    pid_t pid = -1;
    error = posix_spawnp(&pid, argv[0], &files, &attributes, argv.data(), environ);
    return error == 0 ? pid : -1;
  });
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  ProgramOutput result;
  if (error != 0) {
    result.err = error == ENOENT ? "is not installed" : std::strerror(error);
    return result;
  }
  out.close_end(1);
  err.close_end(1);
  read_both(out, result.out, err, result.err);
  int status = 0;
  while (waitpid(child.pid(), &status, 0) < 0 && errno == EINTR) {
  }
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.err = result.err.substr(0, result.err.find('\n'));
  return result;
}

std::string shell_word(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

}  // namespace artu::sim
