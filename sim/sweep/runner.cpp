#include "sim/sweep/runner.h"

#include <poll.h>

#include <cerrno>
#include <memory>
#include <system_error>

#include "sim/jobs/worker.h"

namespace artu::sim {

void run_points(std::size_t count, std::uint32_t jobs, const PointWork& points) {
  std::vector<std::unique_ptr<Worker>> workers;
  std::size_t given = 0;
  while (given < count || !workers.empty()) {
    while (given < count && workers.size() < jobs) {
      points.prepare(given);
      std::vector<int> fds;
      for (const auto& worker : workers) fds.push_back(worker->fd());
      const auto work = [&points](std::uint64_t point) {
        points.work(point);
        return std::string();
      };
      workers.push_back(std::make_unique<Worker>(work, fds));
      workers.back()->give(given++);
    }
    std::vector<pollfd> polled;
    for (const auto& worker : workers) polled.push_back({worker->fd(), POLLIN, 0});
    while (poll(polled.data(), polled.size(), -1) < 0) {
      if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "poll");
    }
    for (std::size_t i = polled.size(); i-- > 0;) {
      if (polled[i].revents == 0) continue;
      const std::uint64_t point = workers[i]->task();
      const auto answer = workers[i]->receive();
      if (!answer) continue;
      answer->result();
      workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(i));
      points.done(point);
    }
  }
}

}  // namespace artu::sim
