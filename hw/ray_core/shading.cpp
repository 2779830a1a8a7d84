#include "hw/ray_core/shading.h"

#include <algorithm>

#include "hw/datapath/color.h"

namespace artu::hw {

void Shading::reset() {
  fetch_queue_.clear();
  shade_queue_.clear();
  finish_queue_.clear();
  shader_free_ = 0;
  outstanding_ = 0;
  shaded_ = sky_ = lights_ = lights_skipped_ = textured_ = textures_skipped_ = pixels_ = 0;
}

void Shading::want(RayContext& context, Address line) {
  for (std::uint8_t i = 0; i < context.fetch_count; ++i) {
    if (context.fetch[i] == line) return;
  }
  context.fetch[context.fetch_count++] = line;
}

void Shading::fetch_material(Slot slot) {
  RayContext& context = contexts_[slot];
  context.fetch_count = context.fetch_issued = context.outstanding = 0;
  context.texels_fetched = false;
  want(context, context.material);
  want(context, context.material + line_bytes);
  fetch_queue_.push(slot);
}

/// True if the material has a texture, whose texels are now on the list.  Without the skip one that has none takes a
/// line too, the same for all of them.
bool Shading::fetch_texels(Slot slot) {
  RayContext& context = contexts_[slot];
  const auto& material = image_.at<MaterialRecord>(context.material);
  if (material.texels == 0) {
    if (registers_.skip.texture) {
      ++textures_skipped_;
      return false;
    }
    context.fetch_count = context.fetch_issued = 0;
    context.texels_fetched = true;
    want(context, registers_.descriptor.materials);
    fetch_queue_.push(slot);
    return true;
  }
  context.footprint = footprint(material, context.surface.u, context.surface.v);
  context.fetch_count = context.fetch_issued = 0;
  context.texels_fetched = true;
  for (int i = 0; i < 4; ++i) {
    want(context, line_of(texel_address(material.texels, material.width, context.footprint.x[i & 1],
                                        context.footprint.y[i >> 1])));
  }
  ++textured_;
  fetch_queue_.push(slot);
  return true;
}

/// A line for this context has arrived; the last one moves it on.
void Shading::answer(Slot slot) {
  RayContext& context = contexts_[slot];
  if (--context.outstanding != 0 || context.fetch_issued != context.fetch_count) return;
  if (context.texels_fetched || !fetch_texels(slot)) shade_queue_.push(slot);
}

bool Shading::request(bool& blocked) {
  if (fetch_queue_.empty()) return false;
  if (!ports_.memory->request.can_push()) {
    blocked = true;
    return false;
  }
  const Slot slot = fetch_queue_.front();
  RayContext& context = contexts_[slot];
  ports_.memory->request.push({context.fetch[context.fetch_issued++], 0, slot, 0});
  ++context.outstanding;
  ++outstanding_;
  if (context.fetch_issued == context.fetch_count) fetch_queue_.pop();
  return true;
}

void Shading::shade(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  const auto& material = image_.at<MaterialRecord>(context.material);
  const Vector base = steps_.begin_shading(registers_.shading, context.surface, material,
                                           texture_at(steps_, image_, material, context.footprint),
                                           context.ray.direction, context.weight, context.point);
  context.sum = steps_.add_weighted(context.sum, context.weight, base);
  context.light = 0;
  ++shaded_;
  lights(slot, now, pipelines_.texture + pipelines_.accumulate);
}

/// Goes on with the lights from context.light; the first that needs a shadow ray sends one off.
void Shading::lights(Slot slot, Cycle now, std::uint32_t latency) {
  RayContext& context = contexts_[slot];
  const std::uint32_t first = context.light;
  ShadowRay shadow;
  const bool found =
      next_shadow_ray(steps_, registers_.lights, context.point, context.light, shadow, registers_.skip.shadow);
  const std::uint32_t looked_at = context.light - first;
  lights_ += looked_at;
  lights_skipped_ += looked_at - (found ? 1 : 0);
  shader_free_ = now + std::max<std::uint32_t>(looked_at, 1);
  latency += pipelines_.light + looked_at;
  if (found) {
    context.contribution = shadow.contribution;
    context.ray.origin = context.point.outside;
    context.ray.direction = shadow.direction;
    context.ray.tmax = shadow.tmax;
    context.kind = RayKind::shadow;
    ports_.next_rays->push(slot, latency);
    return;
  }
  if (context.depth < registers_.shading.max_depth) {
    context.pending.add(steps_.next_rays(registers_.shading, context.point), context.point, context.depth);
  }
  next_ray(slot, now, latency + pipelines_.next_ray);
}

/// The next ray of the pixel, or its end.
void Shading::next_ray(Slot slot, Cycle now, std::uint32_t latency) {
  RayContext& context = contexts_[slot];
  if (context.pending.empty()) {
    context.finish_at = now + latency;
    finish_queue_.push(slot);
    return;
  }
  const PendingRay& ray = context.pending.take();
  context.ray.origin = ray.origin;
  context.ray.direction = ray.direction;
  context.ray.tmax = two_pow_100;
  context.weight = ray.weight;
  context.kind = ray.kind;
  context.depth = ray.depth;
  ports_.next_rays->push(slot, latency);
}

bool Shading::finish_pixel() {
  if (!ports_.pixels->can_push() || !ports_.freed->can_push()) return false;
  const Slot slot = finish_queue_.front();
  finish_queue_.pop();
  const RayContext& context = contexts_[slot];
  PixelToken token;
  token.x = context.pixel.x;
  token.y = context.pixel.y;
  token.r = static_cast<std::uint8_t>(encode(context.sum.x) ^ fault_);
  token.g = encode(context.sum.y);
  token.b = encode(context.sum.z);
  token.hit_class = context.hit_class;
  ports_.pixels->push(token);
  ports_.freed->push(slot);
  ++pixels_;
  if (records_ != nullptr) {
    PixelRecord& record = (*records_)[std::size_t{token.y} * registers_.descriptor.width + token.x];
    const bool hit = context.hit_class != HitClass::miss;
    record.primitive = hit ? static_cast<std::int64_t>(context.primary_primitive) : -1;
    record.t_bits = hit ? context.primary_t_bits : 0;
  }
  return true;
}

Activity Shading::tick(Cycle now) {
  bool moved = false, blocked_mem = false, blocked_out = false;
  // (1) A line from memory; (2) new hits join the queue for their material; (3) the next line request.
  if (ports_.memory->response.can_pop()) {
    const auto slot = static_cast<Slot>(ports_.memory->response.front().tag);
    ports_.memory->response.pop();
    --outstanding_;
    answer(slot);
    moved = true;
  }
  if (ports_.hits->can_pop()) {
    fetch_material(ports_.hits->front());
    ports_.hits->pop();
    moved = true;
  }
  if (request(blocked_mem)) moved = true;
  // (4) The shader: shadow rays that are back, misses, then hits whose texels are here.
  if (now >= shader_free_) {
    if (ports_.shadows->can_pop()) {
      const Slot slot = ports_.shadows->front();
      ports_.shadows->pop();
      RayContext& context = contexts_[slot];
      if (!context.found) context.sum = steps_.add(context.sum, context.contribution);
      lights(slot, now, pipelines_.accumulate);
      moved = true;
    } else if (ports_.misses->can_pop()) {
      const Slot slot = ports_.misses->front();
      ports_.misses->pop();
      RayContext& context = contexts_[slot];
      const Vector sky = steps_.sky(registers_.shading, context.ray.direction);
      context.sum = steps_.add_weighted(context.sum, context.weight, sky);
      ++sky_;
      shader_free_ = now + 1;
      next_ray(slot, now, pipelines_.accumulate);
      moved = true;
    } else if (!shade_queue_.empty()) {
      const Slot slot = shade_queue_.front();
      shade_queue_.pop();
      shade(slot, now);
      moved = true;
    }
  }
  // (5) Finished pixels leave, in order.
  const bool leaving = !finish_queue_.empty() && contexts_[finish_queue_.front()].finish_at <= now;
  if (leaving) {
    if (finish_pixel()) {
      moved = true;
    } else {
      blocked_out = true;
    }
  }
  if (moved) {
    const bool left = ports_.memory->response.can_pop() || ports_.hits->can_pop() || !fetch_queue_.empty() ||
                      ports_.shadows->can_pop() || ports_.misses->can_pop() || !shade_queue_.empty();
    if (left) return {State::busy, now + 1};
    if (!finish_queue_.empty()) return {State::busy, std::max(now + 1, contexts_[finish_queue_.front()].finish_at)};
    return Activity::once(State::busy, outstanding_ != 0 ? State::stall_mem : State::stall_in);
  }
  if (now < shader_free_ && (ports_.shadows->can_pop() || ports_.misses->can_pop() || !shade_queue_.empty())) {
    return {State::busy, shader_free_};
  }
  if (blocked_out) return {State::stall_out};
  if (!finish_queue_.empty() && !leaving) return {State::busy, contexts_[finish_queue_.front()].finish_at};
  if (blocked_mem || outstanding_ != 0) return {State::stall_mem};
  return {State::stall_in};
}

void Shading::report(Statistics& out) const {
  const std::string block = path();
  out.push_back({block, "hits_shaded", shaded_, "", "hits shaded"});
  out.push_back({block, "sky", sky_, "", "rays that missed and got the sky"});
  out.push_back({block, "lights", lights_, "", "lights looked at"});
  out.push_back({block, "lights_skipped", lights_skipped_, "", "lights that could add nothing: no shadow ray"});
  out.push_back({block, "textured", textured_, "", "hits with a texture"});
  out.push_back({block, "textures_skipped", textures_skipped_, "", "hits without one: no texel fetched"});
  out.push_back({block, "pixels", pixels_, "pixels", "pixels finished"});
}

std::string Shading::describe() const {
  return std::to_string(fetch_queue_.size()) + " wait for requests, " + std::to_string(shade_queue_.size()) +
         " to be shaded, " + std::to_string(finish_queue_.size()) + " to leave, " + std::to_string(outstanding_) +
         " lines outstanding";
}

}  // namespace artu::hw
