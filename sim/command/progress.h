// A progress bar on a terminal, for what takes over two seconds.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace artu::sim {

class Progress {
 public:
  /// Of `count` frames, cases, ... as `what` says.  Shows nothing where stderr is no terminal, or `quiet`.
  Progress(std::uint64_t count, const char* what, bool quiet);
  ~Progress();  // clears the line
  void one_done();

 private:
  void show();

  const std::uint64_t count_;
  const char* const what_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t done_ = 0;
  double done_at_ = 0;  // seconds after the start
  bool finished_ = false;
  std::thread thread_;  // one can take minutes: the bar lives on its own
};

}  // namespace artu::sim
