// Reuse distances: how many other lines were used since a line was used last.  A cache of so many lines or fewer, with
// the least recently used one replaced and every line allowed everywhere, misses it: so one pass over the requests
// tells the misses of all sizes.
// Sources: Mattson, Gecsei, Slutz, Traiger, IBM Systems Journal 9(2), 1970 (stack distances); Bennett and Kruskal, IBM
// J. Res. Dev. 19(4), 1975 (with a tree of counts, in logarithmic time).
#pragma once

#include <cstdint>
#include <set>
#include <unordered_map>
#include <vector>

namespace artu::sim {

class StackDistance {
 public:
  static constexpr std::uint64_t never_used = ~std::uint64_t{0};

  /// The distance of the line, or never_used; it is now the last that was used.
  std::uint64_t use(std::uint64_t line);
  /// The line leaves the caches that hold it: in each of them the place is free for the next line that is fetched.
  void forget(std::uint64_t line);
  void clear();

 private:
  void set(std::size_t time, int by);
  std::uint64_t up_to(std::size_t time) const;
  void compact();

  // A place of the stack is the time of its last use; the counts tell how many places there are up to a time.
  std::unordered_map<std::uint64_t, std::size_t> last_;
  std::set<std::size_t> free_;  // places whose line was forgotten
  std::vector<std::uint32_t> counts_;
  std::size_t now_ = 0, places_ = 0;
};

}  // namespace artu::sim
