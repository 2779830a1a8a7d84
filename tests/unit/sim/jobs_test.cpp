// Tasks in several processes: results in order, errors as with one process, and a line where a process dies.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <new>
#include <numeric>
#include <set>

#include "sim/driver/frame_simulator.h"
#include "sim/jobs/processes.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

struct Part {
  std::uint32_t number = 0;
  std::string text;
};

template <class A>
void transfer(A& archive, Part& part) {
  pass_all(archive, part.number, part.text);
}

struct Whole {
  std::vector<Part> parts;
  std::map<std::string, std::vector<double>> map;
  std::optional<std::string> there, not_there;
  std::optional<int> number;
};

template <class A>
void transfer(A& archive, Whole& whole) {
  pass_all(archive, whole.parts, whole.map, whole.there, whole.not_there, whole.number);
}

TEST(Archive, ValuesComeBackAsTheyWere) {
  const Whole whole{{{1, "one"}, {2, ""}}, {{"a", {0.1, -0.0}}, {"b", {}}}, "here", {}, 7};
  const std::string bytes = to_bytes(whole);
  const Whole back = from_bytes<Whole>(bytes);
  ASSERT_EQ(back.parts.size(), 2u);
  EXPECT_EQ(back.parts[0].text, "one");
  EXPECT_EQ(back.parts[1].number, 2u);
  EXPECT_EQ(back.map, whole.map);
  EXPECT_TRUE(std::signbit(back.map.at("a")[1]));
  EXPECT_EQ(back.there, "here");
  EXPECT_FALSE(back.not_there.has_value());
  EXPECT_EQ(back.number, 7);
  EXPECT_THROW(from_bytes<Whole>(bytes.substr(0, bytes.size() - 1)), std::logic_error);
  EXPECT_THROW(from_bytes<Whole>(bytes + "x"), std::logic_error);
}

TEST(Jobs, ResultsComeInTheOrderOfTheTasks) {
  for (const std::uint32_t jobs : {1u, 2u, 7u, 40u}) {
    std::vector<std::uint64_t> taken;
    std::set<pid_t> processes;
    in_order<std::pair<std::uint64_t, pid_t>>(
        31, jobs,
        [&](std::uint64_t task) {
          if (jobs > 1) usleep(static_cast<useconds_t>(task % 5 * 3000));  // later ones are done first
          return std::pair(task * task, getpid());
        },
        [&](std::uint64_t task, const std::pair<std::uint64_t, pid_t>& result) {
          EXPECT_EQ(result.first, task * task);
          taken.push_back(task);
          processes.insert(result.second);
        });
    std::vector<std::uint64_t> all(31);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(taken, all) << jobs;
    if (jobs == 1) {
      EXPECT_EQ(processes, std::set<pid_t>{getpid()});
    } else {
      EXPECT_EQ(processes.count(getpid()), 0u);
      EXPECT_GT(processes.size(), 1u);
      EXPECT_LE(processes.size(), jobs);
    }
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process was left";
  }
}

TEST(Jobs, ResultsMayBeLarge) {
  in_order<std::string>(
      5, 2, [](std::uint64_t task) { return std::string(5'000'000 + task, static_cast<char>('a' + task)); },
      [](std::uint64_t task, const std::string& text) {
        EXPECT_EQ(text.size(), 5'000'000 + task);
        EXPECT_EQ(text.find_first_not_of(static_cast<char>('a' + task)), std::string::npos);
      });
}

TEST(Jobs, WhatWorkThrowsIsThrownAtItsPlace) {
  const auto thrown_by = [](const std::function<void()>& fail) {
    std::uint64_t taken = 0;
    const auto work = [&](std::uint64_t task) {
      if (task == 3) fail();
      if (task == 5) throw InputError("task 5", "must not be seen");
      return task;
    };
    try {
      in_order<std::uint64_t>(9, 4, work, [&](std::uint64_t, std::uint64_t) { ++taken; });
    } catch (const InputError& error) {
      EXPECT_EQ(taken, 3u);
      return std::string("input ") + error.what();
    } catch (const DeadLock& error) {
      EXPECT_EQ(taken, 3u);
      return std::string("dead-lock ") + error.what();
    } catch (const std::bad_alloc&) {
      EXPECT_EQ(taken, 3u);
      return std::string("memory");
    } catch (const std::exception& error) {
      EXPECT_EQ(taken, 3u);
      return std::string("internal ") + error.what();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(thrown_by([] { throw InputError("there", "bad"); }), "input there: bad");
  EXPECT_EQ(thrown_by([] { throw DeadLock("who waits"); }), "dead-lock who waits");
  EXPECT_EQ(thrown_by([] { throw std::bad_alloc(); }), "memory");
  EXPECT_EQ(thrown_by([] { throw std::logic_error("a law"); }), "internal a law");
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process was left";
}

TEST(Jobs, WhatTakeThrowsEndsTheProcesses) {
  EXPECT_THROW(in_order<int>(
                   100, 3, [](std::uint64_t) { return 1; },
                   [](std::uint64_t task, int) {
                     if (task == 2) throw InputError("disk", "full");
                   }),
               InputError);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process was left";
}

TEST(Jobs, AProcessThatDiesIsAnError) {
  const auto error_of = [](const std::function<void()>& die) {
    try {
      in_order<int>(
          6, 2,
          [&](std::uint64_t task) {
            if (task == 2) die();
            return 1;
          },
          [](std::uint64_t, int) {});
    } catch (const InputError& error) {
      return std::string("input ") + error.what();
    } catch (const std::exception& error) {
      return std::string("internal ") + error.what();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(error_of([] { raise(SIGKILL); }),
            "input --jobs: one of the processes was killed, as happens when memory runs out; fewer jobs or a smaller "
            "scene would be right");
  EXPECT_EQ(error_of([] { _exit(7); }), "internal one of the processes of --jobs ended with code 7");
  const auto segmentation_fault = [] {
    std::signal(SIGSEGV, SIG_DFL);
    raise(SIGSEGV);
  };
  EXPECT_EQ(error_of(segmentation_fault),
            "internal one of the processes of --jobs ended by signal " + std::to_string(SIGSEGV));
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process was left";
}

}  // namespace
}  // namespace artu::sim
