// Ctrl-C leaves nothing half-written.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

namespace artu::sim {

/// From now on SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGPIPE remove what is guarded and end the program with 128 + the
/// signal's number. Call once, before any thread is started. Throws InputError where there can be none.
void handle_interruptions();

/// For a process that KillOnInterrupt's `fork` has made: forgets what its parent guards, which is the parent's to
/// remove. Afterwards it may use what is below; signals stay blocked in it, so nothing of its own is removed either.
void begin_forked_process();

/// Guards a file or folder while it is incomplete.
class RemoveOnInterrupt {
 public:
  explicit RemoveOnInterrupt(std::string path);
  ~RemoveOnInterrupt();
  RemoveOnInterrupt(const RemoveOnInterrupt&) = delete;
  RemoveOnInterrupt& operator=(const RemoveOnInterrupt&) = delete;

 private:
  std::string path_;
};

/// Kills a process of ours before what it may write to is removed.
class KillOnInterrupt {
 public:
  /// `fork` returns the process's number, below 0 if there is none.  No interruption comes between: in the process
  /// itself, where `fork` must not return, nothing of this file may be used before
  /// begin_forked_process().
  explicit KillOnInterrupt(const std::function<pid_t()>& fork);
  ~KillOnInterrupt();
  KillOnInterrupt(const KillOnInterrupt&) = delete;
  KillOnInterrupt& operator=(const KillOnInterrupt&) = delete;
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_;
};

}  // namespace artu::sim
