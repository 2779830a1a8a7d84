#include "sim/jobs/processes.h"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <memory>
#include <system_error>
#include <vector>

#include "sim/jobs/worker.h"

namespace artu::sim {
namespace {

class Pool {
 public:
  Pool(std::uint64_t count, std::uint32_t jobs, const Worker::Work& work)
      : count_(count), lead_(std::uint64_t{4} * jobs) {
    std::vector<int> fds;
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(count, jobs); ++i) {
      workers_.push_back(std::make_unique<Worker>(work, fds));
      fds.push_back(workers_.back()->fd());
    }
  }

  void run(const std::function<void(std::uint64_t, const std::string&)>& take) {
    while (taken_ < count_) {
      for (const auto& worker : workers_) {
        if (!worker->busy()) give(*worker);
      }
      const auto answer = answers_.find(taken_);
      if (answer == answers_.end()) {
        wait();
        continue;
      }
      take(taken_, answer->second.result());
      answers_.erase(answer);
      ++taken_;
    }
  }

 private:
  /// Not far ahead of what was taken: results that wait are memory.
  void give(Worker& worker) {
    if (given_ < count_ && given_ < taken_ + lead_) worker.give(given_++);
  }

  void wait() {
    std::vector<pollfd> polled;
    for (const auto& worker : workers_) polled.push_back({worker->fd(), POLLIN, 0});
    while (poll(polled.data(), polled.size(), -1) < 0) {
      if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "poll");
    }
    for (std::size_t i = 0; i < polled.size(); ++i) {
      if (polled[i].revents == 0) continue;
      const std::uint64_t task = workers_[i]->busy() ? workers_[i]->task() : count_;
      if (auto answer = workers_[i]->receive()) answers_.emplace(task, std::move(*answer));
    }
  }

  const std::uint64_t count_, lead_;
  std::uint64_t given_ = 0, taken_ = 0;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::map<std::uint64_t, WorkerAnswer> answers_;  // by task, those that are not taken yet
};

}  // namespace

void run_in_processes(std::uint64_t count, std::uint32_t jobs, const std::function<std::string(std::uint64_t)>& work,
                      const std::function<void(std::uint64_t, const std::string&)>& take) {
  Pool(count, jobs, work).run(take);
}

}  // namespace artu::sim
