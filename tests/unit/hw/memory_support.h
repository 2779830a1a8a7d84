// A cache or interconnect with scripted clients above it and a scripted memory below.
#pragma once

#include "hw/memory/cache.h"
#include "unit/hw/support.h"

namespace artu::hw::test {

/// A requester with a response channel: the two ends of a memory link.
struct Client {
  Client(Bench& bench, const std::string& name, Block& memory, std::uint32_t depth, std::uint32_t request_latency,
         std::uint32_t response_latency)
      : link(bench.link(name.c_str(), depth, request_latency, response_latency)),
        requests(bench.block<Source<MemoryRequest>>((name + "_requests").c_str(), link.request)),
        responses(bench.block<Sink<MemoryResponse>>((name + "_responses").c_str(), link.response)) {
    link.request.bind(requests, memory);
    link.response.bind(memory, responses);
  }
  std::vector<std::uint32_t> tags() const {
    std::vector<std::uint32_t> result;
    for (const MemoryResponse& response : responses.tokens) result.push_back(response.tag);
    return result;
  }
  MemoryLink& link;
  Source<MemoryRequest>& requests;
  Sink<MemoryResponse>& responses;
};

/// Lines of a cache with `sets` sets that fall into the same one.
inline Address line_in_set(std::uint32_t set, std::uint32_t k, std::uint32_t sets) {
  return (Address{1 + k} * sets + set) * line_bytes;
}

/// One cache.  A request pushed in cycle c arrives in c + 1; its answer, on a hit, hit_latency later.  On a miss the
/// memory sees the request in the cycle after its arrival and answers memory_latency later.
struct CacheBench {
  static constexpr Cycle memory_latency = 20;
  explicit CacheBench(const CacheConfig& config, std::uint32_t clients = 1)
      : sets(config.size / 64 / config.ways),
        cache(bench.block<Cache>("cache", config)),
        below(bench.link("below", config.mshrs, 1, 1)),
        memory(bench.block<ScriptedMemory>("memory", below, 1, memory_latency)) {
    below.bind(cache, memory);
    cache.bind_below(below);
    for (std::uint32_t i = 0; i < clients; ++i) {
      this->clients.push_back(
          std::make_unique<Client>(bench, "client" + std::to_string(i), cache, 8, 1, config.hit_latency));
      cache.add_client(this->clients.back()->link);
    }
  }
  Address line(std::uint32_t set, std::uint32_t k) const { return line_in_set(set, k, sets); }
  Client& client(std::size_t i = 0) { return *clients[i]; }

  const std::uint32_t sets;
  Bench bench;
  Cache& cache;
  MemoryLink& below;
  ScriptedMemory& memory;
  std::vector<std::unique_ptr<Client>> clients;
};

}  // namespace artu::hw::test
