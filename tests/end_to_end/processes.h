// Programs that a test starts, none of which outlives it.
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <string>
#include <vector>

namespace artu::test {

/// A program that runs beside the test.
class Running {
 public:
  explicit Running(pid_t pid) : pid_(pid) {}
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  Running(Running&&) = default;

  pid_t pid() const { return pid_; }
  void send(int signal);
  bool ended();
  /// Its exit code, or 128 + the signal.
  int wait();
  /// Waits until the condition holds, which it need not before the program ends: then it is false.
  template <class Condition>
  bool until(const Condition& condition) {
    while (!condition()) {
      if (ended()) return condition();
      usleep(200);
    }
    return true;
  }

 private:
  void collect(int options);

  pid_t pid_;
  bool waited_for_ = false;  // then the number may be another process's
  int status_ = 0;
};

/// All that a test starts, and what that starts in its turn: a process group of its own. A guard in the group kills it
/// when the test is no more, be it that ctest's time is up: otherwise a run without an end would go on for ever.
class Processes {
 public:
  Processes();
  ~Processes() { end(); }
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// In `folder`, with nothing on its standard input. Signals are as in a terminal, whatever this program was started
  /// with: nohup, a service or a background job ignore some, and `artu` leaves what is ignored ignored.
  Running start(const std::string& binary, const std::vector<std::string>& args, const std::string& folder,
                const std::string& out, const std::string& err);
  /// Kills all that still runs.
  void end();

 private:
  void begin();

  pid_t guard_ = -1;  // the group's number as well
  int alive_ = -1;    // a pipe that nobody writes to: the guard sees its end when this process is no more
};

}  // namespace artu::test
