#include "sim/jobs/worker.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "sim/driver/frame_simulator.h"
#include "sim/report/file.h"
#include "sim/report/line_counts.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

struct Header {
  WorkerAnswer::Kind kind;
  std::uint64_t size;
};

/// False where the other side is gone.
bool send_all(int fd, const void* bytes, std::size_t count) {
  const char* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = send(fd, at, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int fd, void* bytes, std::size_t count) {
  char* at = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = recv(fd, at, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

WorkerAnswer answer_to(std::uint64_t task, const Worker::Work& work) {
  try {
    return {WorkerAnswer::Kind::result, work(task)};
  } catch (const InputError& error) {
    return {WorkerAnswer::Kind::input_error, error.what()};
  } catch (const std::filesystem::filesystem_error& error) {
    return {WorkerAnswer::Kind::input_error, file_error_of(error).what()};
  } catch (const DeadLock& error) {
    return {WorkerAnswer::Kind::dead_lock, error.what()};
  } catch (const std::bad_alloc&) {
    return {WorkerAnswer::Kind::out_of_memory, ""};
  } catch (const std::exception& error) {
    return {WorkerAnswer::Kind::internal, error.what()};
  }
}

/// Ends without the destructors and buffers that belong to the process that forked.
[[noreturn]] void serve(int fd, pid_t parent, const Worker::Work& work) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // a long task must not outlive a parent that was killed
#endif
  if (getppid() != parent) _exit(0);
  begin_forked_process();
  for (std::uint64_t task; receive_all(fd, &task, sizeof task);) {
    const WorkerAnswer answer = answer_to(task, work);
    write_line_counts();  // who has the answer may kill us
    Header header;
    std::memset(&header, 0, sizeof header);
    header.kind = answer.kind;
    header.size = answer.bytes.size();
    if (!send_all(fd, &header, sizeof header) || !send_all(fd, answer.bytes.data(), answer.bytes.size())) break;
  }
  _exit(0);
}

}  // namespace

const std::string& WorkerAnswer::result() const {
  switch (kind) {
    case Kind::result:
      return bytes;
    case Kind::input_error:
      throw InputError("", bytes);
    case Kind::dead_lock:
      throw DeadLock(bytes);
    case Kind::out_of_memory:
      throw std::bad_alloc();
    default:
      throw std::runtime_error(bytes);
  }
}

Worker::Worker(const Work& work, const std::vector<int>& siblings_fds) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw InputError(
        "--jobs", std::string("no connection to a process: ") + std::strerror(errno) + "; fewer jobs would be right");
  }
  std::fflush(nullptr);
  const pid_t parent = getpid();
  int error = 0;
  guard_ = std::make_unique<KillOnInterrupt>([&] {
    const pid_t pid = fork();
    error = errno;
    if (pid != 0) return pid;
    close(ends[0]);
    for (const int fd : siblings_fds) close(fd);
    serve(ends[1], parent, work);
  });
  pid_ = guard_->pid();
  close(ends[1]);
  fd_ = ends[0];
  if (pid_ < 0) {
    close(fd_);
    throw InputError("--jobs",
                     std::string("no further process: ") + std::strerror(error) + "; fewer jobs would be right");
  }
}

Worker::~Worker() {
  guard_.reset();  // the number may be another process's as soon as this one is waited for
  close(fd_);
  if (pid_ < 0) return;
  kill(pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Worker::give(std::uint64_t task) {
  task_ = task;
  if (!send_all(fd_, &task, sizeof task)) ended();
}

std::optional<WorkerAnswer> Worker::receive() {
  char buffer[1 << 16];
  while (true) {
    const ssize_t got = recv(fd_, buffer, sizeof buffer, MSG_DONTWAIT);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return std::nullopt;
    if (got <= 0) ended();
    received_.append(buffer, static_cast<std::size_t>(got));
    Header header;
    if (received_.size() < sizeof header) continue;
    std::memcpy(&header, received_.data(), sizeof header);
    if (received_.size() - sizeof header < header.size) continue;
    WorkerAnswer answer{header.kind, received_.substr(sizeof header)};
    received_.clear();
    task_.reset();
    return answer;
  }
}

WorkerAnswer Worker::wait() {
  while (true) {
    pollfd polled{fd_, POLLIN, 0};
    if (poll(&polled, 1, -1) < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "poll");
    if (auto answer = receive()) return std::move(*answer);
  }
}

void Worker::ended() {
  guard_.reset();  // waits while an interruption ends the program: then the process was killed by it
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) {
    throw InputError("--jobs",
                     "one of the processes was killed, as happens when memory runs out; fewer jobs or a smaller scene "
                     "would be right");
  }
  throw std::runtime_error(WIFSIGNALED(status)
                               ? fmt::format("one of the processes of --jobs ended by signal {}", WTERMSIG(status))
                               : fmt::format("one of the processes of --jobs ended with code {}", WEXITSTATUS(status)));
}

}  // namespace artu::sim
