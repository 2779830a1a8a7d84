#include "sim/report/interruption.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

#include "sim/report/guarded_folder.h"
#include "sim/report/line_counts.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

struct Guarded {
  std::mutex mutex;
  std::set<std::string> paths;
  std::set<pid_t> processes;
};

/// Never destroyed: the waiting thread lives as long as the process.
Guarded*& instance() {
  static auto* one = new Guarded;
  return one;
}

Guarded& guarded() { return *instance(); }

/// Nobody reads any more what is written: the kernel tells the thread that wrote, and the waiting one hears of it so.
const int broken_pipe = SIGRTMIN;

void on_broken_pipe(int, siginfo_t* info, void*) {
  const int error = errno;
  kill(getpid(), broken_pipe);
  // A thread that wrote stops here: what its write returns is of no interest. One that another process's kill has
  // stopped goes on, for it may hold a lock (malloc's, say) that the waiting thread needs.
  while (info->si_pid == getpid()) pause();
  errno = error;
}

/// A thread of its own may use the file system, which a signal handler must not.
[[noreturn]] void wait_for(const sigset_t& signals) {
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) {
  }
  const std::lock_guard<std::mutex> lock(guarded().mutex);
  for (const pid_t process : guarded().processes) {
    kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
  }
  for (const std::string& path : guarded().paths) {
    std::error_code error;
    // Another thread may still put a file into the folder while it is removed.
    for (int attempt = 0; attempt < 10; ++attempt) {
      std::filesystem::remove_all(path, error);
      if (!error) break;
    }
  }
  write_line_counts();
  _exit(128 + (signal == broken_pipe ? SIGPIPE : signal));
}

}  // namespace

void handle_interruptions() {
  sigset_t signals;
  sigemptyset(&signals);
  const auto is_ignored = [](int signal) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    return action.sa_handler == SIG_IGN;
  };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    if (!is_ignored(signal)) sigaddset(&signals, signal);  // nohup stays in force
  }
  sigaddset(&signals, broken_pipe);
  if (!is_ignored(SIGPIPE)) {
    struct sigaction action {};
    action.sa_sigaction = on_broken_pipe;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    sigaction(SIGPIPE, &action, nullptr);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  // The waiting thread inherits that it never gets a broken pipe itself: while another forks, with all signals
  // blocked, it would be the only one to give it to, and stop in the handler.
  sigset_t pipe;
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, &pipe, &before);
  try {
    std::thread([signals] { wait_for(signals); }).detach();
  } catch (const std::system_error& error) {
    throw InputError("processes", fmt::format("no thread can be started: {}; a higher limit (ulimit -u), fewer other "
                                              "processes or more memory would be right",
                                              error.code().message()));
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

// The copy of the parent's mutex is locked, and nobody would unlock it.
void begin_forked_process() {
  instance() = new Guarded;
  std::signal(SIGPIPE, SIG_DFL);  // no thread waits here
}

RemoveOnInterrupt::RemoveOnInterrupt(std::string path) : path_(std::move(path)) {
  const std::lock_guard<std::mutex> lock(guarded().mutex);
  guarded().paths.insert(path_);
}

RemoveOnInterrupt::~RemoveOnInterrupt() {
  const std::lock_guard<std::mutex> lock(guarded().mutex);
  guarded().paths.erase(path_);
}

std::unique_ptr<RemoveOnInterrupt> make_guarded_folder(const std::string& path, std::error_code& error) {
  {
    const std::lock_guard<std::mutex> lock(guarded().mutex);
    if (!std::filesystem::create_directory(path, error)) return nullptr;
    guarded().paths.insert(path);
  }
  return std::make_unique<RemoveOnInterrupt>(path);
}

KillOnInterrupt::KillOnInterrupt(const std::function<pid_t()>& fork) {
  const std::lock_guard<std::mutex> lock(guarded().mutex);
  pid_ = fork();
  if (pid_ >= 0) guarded().processes.insert(pid_);
}

KillOnInterrupt::~KillOnInterrupt() {
  const std::lock_guard<std::mutex> lock(guarded().mutex);
  guarded().processes.erase(pid_);
}

}  // namespace artu::sim
