#include "hw/watch/ray_watch.h"

#include <algorithm>

namespace artu::hw {

namespace {

/// What a ray is shown as while its block's lines are on their way.
RayStage fetching(RayStage stage) {
  switch (stage) {
    case RayStage::traversal:
      return RayStage::node_fetch;
    case RayStage::intersection:
      return RayStage::triangle_fetch;
    case RayStage::hit_point_queue:  // it is taken from there with its last request
    case RayStage::hit_point:
      return RayStage::surface_fetch;
    case RayStage::shading:
      return RayStage::texture_fetch;
    default:
      return stage;
  }
}

}  // namespace

RayWatch::RayWatch(const RayPaths& paths, std::uint32_t core)
    : paths_(paths), core_(core), rays_(paths.contexts->size()) {
  reset();
}

void RayWatch::reset() {
  for (std::size_t slot = 0; slot < rays_.size(); ++slot) {
    rays_[slot] = {};
    rays_[slot].ray.core = core_;
    rays_[slot].ray.slot = static_cast<Slot>(slot);
  }
  changed_.clear();
  passing_.clear();
  for (Seen* seen : {&primary_, &others_, &tested_, &hits_, &misses_, &shadows_, &surfaces_, &next_rays_, &freed_,
                     &leaves_, &node_requests_, &node_responses_, &triangle_requests_, &triangle_responses_,
                     &attribute_requests_, &attribute_responses_, &texel_requests_, &texel_responses_}) {
    *seen = {};
  }
}

/// Once for each token that was taken from the channel since the last look.
template <class Token, class See>
void RayWatch::popped(const Fifo<Token>& channel, Seen& seen, See see) {
  for (; seen.pops != channel.pops(); ++seen.pops) see(channel.pushed(seen.pops));
}

/// Once for each that was put into it, with the cycle of its arrival.
template <class Token, class See>
void RayWatch::pushed(const Fifo<Token>& channel, Seen& seen, See see) {
  for (; seen.pushes != channel.pushes(); ++seen.pushes) {
    see(channel.pushed(seen.pushes), channel.arrival(seen.pushes));
  }
}

void RayWatch::change(Slot slot) {
  if (rays_[slot].changed) return;
  rays_[slot].changed = true;
  changed_.push_back(slot);
}

void RayWatch::enter(Slot slot, RayStage stage) {
  rays_[slot].stage = stage;
  rays_[slot].then_at = never;
  change(slot);
}

/// On its way through a pipeline and then in a queue.
void RayWatch::pass(Slot slot, RayStage until, RayStage then, Cycle at) {
  enter(slot, until);
  rays_[slot].then = then;
  rays_[slot].then_at = at;
  passing_.push_back(slot);
}

void RayWatch::ask(Slot slot) {
  ++rays_[slot].fetching;
  change(slot);
}

void RayWatch::answer(Slot slot) {
  --rays_[slot].fetching;
  change(slot);
}

void RayWatch::begin(Slot slot, Tick tick, const std::vector<ActivitySink*>& sinks, std::uint64_t& number) {
  Followed& followed = rays_[slot];
  const RayContext& context = (*paths_.contexts)[slot];
  RayInFlight& ray = followed.ray;
  ray.before = context.kind == RayKind::primary ? RayInFlight::none : ray.number;
  ray.number = number++;
  ray.kind = context.kind;
  ray.x = context.pixel.x;
  ray.y = context.pixel.y;
  followed.in_flight = true;
  followed.told = followed.stage = RayStage::set_up;
  for (ActivitySink* sink : sinks) {
    sink->ray_begins(tick, ray);
    sink->ray_enters(tick, ray, RayStage::set_up);
  }
}

void RayWatch::end(Slot slot, Tick tick, const std::vector<ActivitySink*>& sinks) {
  Followed& followed = rays_[slot];
  followed.in_flight = false;
  followed.then_at = never;
  for (ActivitySink* sink : sinks) sink->ray_ends(tick, followed.ray, false);
}

void RayWatch::pops(Tick tick, const std::vector<ActivitySink*>& sinks) {
  const auto to = [this](RayStage stage) { return [this, stage](Slot slot) { enter(slot, stage); }; };
  const auto back = [this](unsigned shift) {
    return [this, shift](const MemoryResponse& response) { answer(static_cast<Slot>(response.tag >> shift)); };
  };
  popped(paths_.nodes->response, node_responses_, back(0));
  popped(paths_.triangles->response, triangle_responses_, back(8));
  popped(paths_.attributes->response, attribute_responses_, back(0));
  popped(paths_.texels->response, texel_responses_, back(0));
  popped(*paths_.primary, primary_, to(RayStage::traversal));
  popped(*paths_.others, others_, to(RayStage::traversal));
  popped(*paths_.tested, tested_, to(RayStage::traversal));
  popped(*paths_.leaves, leaves_, [this](const LeafTask& task) { enter(task.slot, RayStage::intersection); });
  popped(*paths_.hits, hits_, to(RayStage::hit_point));
  popped(*paths_.surfaces, surfaces_, to(RayStage::shading));
  popped(*paths_.misses, misses_, to(RayStage::shading));
  popped(*paths_.shadows, shadows_, to(RayStage::shading));
  popped(*paths_.next_rays, next_rays_, [&](Slot slot) { end(slot, tick, sinks); });
}

void RayWatch::pushes(Cycle cycle, Tick tick, const std::vector<ActivitySink*>& sinks, std::uint64_t& number) {
  const auto set_up = [&](Slot slot, Cycle arrival) {
    begin(slot, tick, sinks, number);
    pass(slot, RayStage::set_up, RayStage::traversal_queue, arrival);
  };
  const auto queue = [this](RayStage stage) { return [this, stage](Slot slot, Cycle) { enter(slot, stage); }; };
  const auto through = [this](RayStage block, RayStage then) {
    return [this, block, then](Slot slot, Cycle arrival) { pass(slot, block, then, arrival); };
  };
  const auto asks = [this](unsigned shift) {
    return [this, shift](const MemoryRequest& request, Cycle) { ask(static_cast<Slot>(request.tag >> shift)); };
  };
  pushed(*paths_.primary, primary_, set_up);
  pushed(*paths_.others, others_, set_up);
  pushed(*paths_.leaves, leaves_,
         [this](const LeafTask& task, Cycle) { enter(task.slot, RayStage::intersection_queue); });
  pushed(*paths_.tested, tested_, through(RayStage::intersection, RayStage::traversal_queue));
  pushed(*paths_.hits, hits_, queue(RayStage::hit_point_queue));
  pushed(*paths_.misses, misses_, queue(RayStage::shading_queue));
  pushed(*paths_.shadows, shadows_, queue(RayStage::shading_queue));
  pushed(*paths_.surfaces, surfaces_, through(RayStage::hit_point, RayStage::shading_queue));
  pushed(*paths_.next_rays, next_rays_, through(RayStage::shading, RayStage::generator_queue));
  pushed(*paths_.freed, freed_, [&](Slot slot, Cycle) { end(slot, tick, sinks); });
  pushed(paths_.nodes->request, node_requests_, asks(0));
  pushed(paths_.triangles->request, triangle_requests_, asks(8));
  pushed(paths_.attributes->request, attribute_requests_, asks(0));
  pushed(paths_.texels->request, texel_requests_, asks(0));
}

void RayWatch::look(Cycle cycle, Tick tick, const std::vector<ActivitySink*>& sinks, std::uint64_t& number) {
  // What is pushed in a cycle is popped in a later one, so this order is that of things for every ray.
  pops(tick, sinks);
  pushes(cycle, tick, sinks, number);
  // Who waits in a queue from now on; the domain is awake when a token arrives.
  std::size_t kept = 0;
  for (const Slot slot : passing_) {
    Followed& followed = rays_[slot];
    if (followed.then_at == never) continue;
    if (followed.then_at > cycle) {
      passing_[kept++] = slot;
    } else {
      enter(slot, followed.then);
    }
  }
  passing_.resize(kept);
  std::sort(changed_.begin(), changed_.end());
  for (const Slot slot : changed_) {
    Followed& followed = rays_[slot];
    followed.changed = false;
    const RayStage shown = followed.fetching != 0 ? fetching(followed.stage) : followed.stage;
    if (!followed.in_flight || shown == followed.told) continue;
    followed.told = shown;
    for (ActivitySink* sink : sinks) sink->ray_enters(tick, followed.ray, shown);
  }
  changed_.clear();
}

void RayWatch::open(Tick tick, const std::vector<ActivitySink*>& sinks) const {
  for (const Followed& followed : rays_) {
    if (!followed.in_flight) continue;
    for (ActivitySink* sink : sinks) {
      sink->ray_begins(tick, followed.ray);
      sink->ray_enters(tick, followed.ray, followed.told);
    }
  }
}

void RayWatch::close(Tick tick, const std::vector<ActivitySink*>& sinks) const {
  for (const Followed& followed : rays_) {
    if (!followed.in_flight) continue;
    for (ActivitySink* sink : sinks) sink->ray_ends(tick, followed.ray, true);
  }
}

}  // namespace artu::hw
