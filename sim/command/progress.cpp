#include "sim/command/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <system_error>

namespace artu::sim {
namespace {

using Clock = std::chrono::steady_clock;

std::string minutes(double seconds) {
  const long whole = std::lround(seconds);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

Progress::Progress(std::uint64_t count, const char* what, bool quiet) : count_(count), what_(what) {
  if (quiet || !isatty(STDERR_FILENO)) return;
  try {
    thread_ = std::thread([this] { show(); });
  } catch (const std::system_error&) {  // no further thread: what was asked for goes on without a bar
  }
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    finished_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Progress::one_done() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++done_;
}

void Progress::show() {
  constexpr int width = 30;
  const auto start = Clock::now();
  std::unique_lock<std::mutex> lock(mutex_);
  std::uint64_t seen = 0;
  bool shown = false;
  auto next = std::chrono::milliseconds(2000);
  while (!changed_.wait_for(lock, next, [this] { return finished_; })) {
    next = std::chrono::milliseconds(500);
    const double now = std::chrono::duration<double>(Clock::now() - start).count();
    if (done_ != seen) {
      seen = done_;
      done_at_ = now;
    }
    std::string line = fmt::format("\r[{:-<{}}] {}/{} {}, {} elapsed", std::string(width * done_ / count_, '#'), width,
                                   done_, count_, what_, minutes(now));
    if (done_ > 0) {
      const double left = done_at_ * static_cast<double>(count_) / static_cast<double>(done_) - now;
      line += fmt::format(", about {} left", minutes(left > 0 ? left : 0));
    }
    std::fputs((line + "\033[K").c_str(), stderr);
    std::fflush(stderr);
    shown = true;
  }
  if (shown) std::fputs("\r\033[K", stderr);
}

}  // namespace artu::sim
