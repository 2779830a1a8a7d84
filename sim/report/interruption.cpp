#include "sim/report/interruption.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>

#include "sim/report/line_counts.h"

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

void on_broken_pipe(int) {
  kill(getpid(), broken_pipe);
  for (;;) pause();  // what the write returns is of no interest: the process ends
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
  if (!is_ignored(SIGPIPE)) std::signal(SIGPIPE, on_broken_pipe);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] { wait_for(signals); }).detach();
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
