#include "end_to_end/processes.h"

#include <fcntl.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <stdexcept>

namespace artu::test {
namespace {

void redirect(int to, const std::string& file, int flags) {
  const int from = open(file.c_str(), flags | O_CLOEXEC, 0600);
  if (from < 0 || dup2(from, to) < 0) _exit(127);
}

void default_signals() {
  for (int signal = 1; signal <= SIGRTMAX; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

}  // namespace

void Running::collect(int options) {
  if (waited_for_) return;
  pid_t got = 0;
  do {
    got = waitpid(pid_, &status_, options);
  } while (got < 0 && errno == EINTR);
  if (got == 0) return;
  waited_for_ = true;
  if (got < 0) status_ = SIGKILL;  // there is none: Processes::end() was first
}

void Running::send(int signal) {
  if (!waited_for_) kill(pid_, signal);
}

bool Running::ended() {
  collect(WNOHANG);
  return waited_for_;
}

int Running::wait() {
  collect(0);
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
}

// Where it is ignored, nothing can be waited for.
Processes::Processes() { std::signal(SIGCHLD, SIG_DFL); }

void Processes::begin() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe for the test's processes");
  guard_ = fork();
  if (guard_ < 0) throw std::runtime_error("no process for the test");
  if (guard_ == 0) {
    setpgid(0, 0);
    close(ends[1]);
    char none = 0;
    while (read(ends[0], &none, 1) < 0 && errno == EINTR) {
    }
    kill(0, SIGKILL);
    _exit(0);
  }
  setpgid(guard_, guard_);  // here as well: whoever comes first
  close(ends[0]);
  alive_ = ends[1];
}

Running Processes::start(const std::string& binary, const std::vector<std::string>& args, const std::string& folder,
                         const std::string& out, const std::string& err) {
  if (guard_ < 0) begin();
  std::vector<char*> argv{const_cast<char*>(binary.c_str())};
  for (const std::string& arg : args) argv.push_back(const_cast<char*>(arg.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for " + binary);
  if (child == 0) {
    if (setpgid(0, guard_) != 0) _exit(127);
    default_signals();
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, err, O_WRONLY | O_CREAT | O_TRUNC);
    if (chdir(folder.c_str()) != 0) _exit(127);
    execv(binary.c_str(), argv.data());
    _exit(127);
  }
  return Running(child);
}

void Processes::end() {
  if (guard_ < 0) return;
  kill(-guard_, SIGKILL);  // while the guard is not waited for, the number is no other group's
  pid_t got = 0;
  do {
    got = waitpid(-guard_, nullptr, 0);
  } while (got > 0 || (got < 0 && errno == EINTR));
  close(alive_);
  guard_ = alive_ = -1;
}

}  // namespace artu::test
