// One process that works on tasks, as the process that forked it sees it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/report/interruption.h"

namespace artu::sim {

/// What `work` made of a task, or threw.
struct WorkerAnswer {
  enum class Kind : std::uint8_t { result, input_error, dead_lock, out_of_memory, internal } kind = Kind::result;
  std::string bytes;  // the result, or what() of the exception

  /// Throws what `work` threw, if it did.
  const std::string& result() const;
};

class Worker {
 public:
  using Work = std::function<std::string(std::uint64_t)>;

  /// Forks.  `siblings_fds` are closed in the new process: it must not keep another's connection open.
  Worker(const Work& work, const std::vector<int>& siblings_fds);
  ~Worker();  // kills the process if it still runs
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  int fd() const { return fd_; }  // readable: call receive()
  bool busy() const { return task_.has_value(); }
  std::uint64_t task() const { return *task_; }
  void give(std::uint64_t task);
  /// Reads what has come, without waiting; the answer when it is whole.  Throws where the process has ended.
  std::optional<WorkerAnswer> receive();
  /// Until there is one.
  WorkerAnswer wait();

 private:
  [[noreturn]] void ended();

  int fd_ = -1;
  pid_t pid_ = -1;
  std::unique_ptr<KillOnInterrupt> guard_;
  std::optional<std::uint64_t> task_;
  std::string received_;
};

}  // namespace artu::sim
