#include "hw/ray_core/ray_core.h"

namespace artu::hw {

namespace {
std::string channel(const sc_core::sc_module& core, const char* name) {
  return std::string(core.basename()) + "." + name;
}
}  // namespace

RayCore::RayCore(sc_core::sc_module_name name, ClockDomain& domain, const UnitConfig& config,
                 const FrameRegisters& registers, const MemoryImage& image, std::uint32_t number)
    : sc_module(name),
      config_(config.core),
      pipelines_(config.operators),
      contexts_(config.core.contexts),
      ray_generator("ray_generator", domain, registers, contexts_, config.precision, config.core.ray_order),
      traversal("traversal", domain, registers, image, contexts_, config.core, pipelines_, config.precision, number),
      intersection("intersection", domain, registers, image, contexts_, config.precision,
                   config.core.triangle_interval),
      hit_point("hit_point", domain, registers, image, contexts_, config.precision),
      shading("shading", domain, registers, image, contexts_, pipelines_, config.precision),
      node_cache("node_cache", domain, config.core.node_cache),
      triangle_cache("triangle_cache", domain, config.core.triangle_cache),
      texture_cache("texture_cache", domain, config.core.texture_cache),
      // Channels with room for every context can never block: there are no more tokens than contexts.
      primary_(channel(*this, "primary"), config_.contexts, pipelines_.generate + pipelines_.set_up),
      others_(channel(*this, "others"), config_.contexts, pipelines_.set_up),
      tested_(channel(*this, "tested"), config_.contexts, pipelines_.triangle),
      hits_(channel(*this, "hits"), config_.queue_depth + 1, 1),
      misses_(channel(*this, "misses"), config_.queue_depth + 1, 1),
      shadows_(channel(*this, "shadows"), config_.queue_depth + 1, 1),
      surfaces_(channel(*this, "surfaces"), config_.contexts, pipelines_.hit_point),
      next_rays_(channel(*this, "next_rays"), config_.contexts, 1),
      freed_(channel(*this, "freed"), config_.contexts, 1),
      leaves_(channel(*this, "leaves"), config_.queue_depth + 1, 1),
      nodes_(channel(*this, "nodes"), config_.queue_depth, 1, config_.node_cache.hit_latency),
      triangles_(channel(*this, "triangles"), config_.queue_depth, 1, config_.triangle_cache.hit_latency),
      attributes_(channel(*this, "attributes"), config_.queue_depth, 1, config_.triangle_cache.hit_latency),
      texels_(channel(*this, "texels"), config_.queue_depth, 1, config_.texture_cache.hit_latency),
      node_misses_(channel(*this, "node_misses"), config_.node_cache.mshrs, config.memory.interconnect_latency,
                   config.memory.interconnect_latency),
      triangle_misses_(channel(*this, "triangle_misses"), config_.triangle_cache.mshrs,
                       config.memory.interconnect_latency, config.memory.interconnect_latency),
      texture_misses_(channel(*this, "texture_misses"), config_.texture_cache.mshrs, config.memory.interconnect_latency,
                      config.memory.interconnect_latency),
      spills_(channel(*this, "spills"), config_.queue_depth + 2, config.memory.interconnect_latency,
              config.memory.interconnect_latency) {
  primary_.bind(ray_generator, traversal);
  others_.bind(ray_generator, traversal);
  leaves_.bind(traversal, intersection);
  tested_.bind(intersection, traversal);
  hits_.bind(traversal, hit_point);
  misses_.bind(traversal, shading);
  shadows_.bind(traversal, shading);
  surfaces_.bind(hit_point, shading);
  next_rays_.bind(shading, ray_generator);
  freed_.bind(shading, ray_generator);
  nodes_.bind(traversal, node_cache);
  triangles_.bind(intersection, triangle_cache);
  attributes_.bind(hit_point, triangle_cache);
  texels_.bind(shading, texture_cache);
  node_cache.add_client(nodes_);
  triangle_cache.add_client(triangles_);
  triangle_cache.add_client(attributes_);
  texture_cache.add_client(texels_);
  intersection.bind(leaves_, tested_, triangles_);
  hit_point.bind(hits_, surfaces_, attributes_);

  channels_ = {&primary_, &others_, &tested_, &hits_, &misses_, &shadows_, &surfaces_, &next_rays_, &freed_, &leaves_};
  for (MemoryLink* link :
       {&nodes_, &triangles_, &attributes_, &texels_, &node_misses_, &triangle_misses_, &texture_misses_}) {
    channels_.push_back(&link->request);
    channels_.push_back(&link->response);
  }
  for (Block* block : std::initializer_list<Block*>{&ray_generator, &traversal, &intersection, &hit_point, &shading,
                                                    &node_cache, &triangle_cache, &texture_cache}) {
    block->takes_part_in(phase_first | phase_selective);
  }
}

RayPaths RayCore::ray_paths() const {
  return {&contexts_,  &primary_, &others_, &tested_, &hits_,      &misses_,     &shadows_, &surfaces_,
          &next_rays_, &freed_,   &leaves_, &nodes_,  &triangles_, &attributes_, &texels_};
}

void RayCore::bind(Interconnect& interconnect, Fifo<PixelJob>& jobs, Fifo<PixelToken>& pixels, Fifo<TreeBuilt>* built) {
  const bool spills = config_.stack_overflow == StackOverflow::spill;
  if (spills) {
    spills_.bind(traversal, interconnect);
    interconnect.add_master(spills_);
    channels_.push_back(&spills_.request);
    channels_.push_back(&spills_.response);
  }
  traversal.bind({&primary_, &others_, &tested_, &leaves_, &hits_, &misses_, &shadows_, &nodes_,
                  spills ? &spills_ : nullptr, built});
  ray_generator.bind(jobs, next_rays_, freed_, primary_, others_);
  shading.bind({&surfaces_, &misses_, &shadows_, &next_rays_, &freed_, &pixels, &texels_});
  const auto connect = [&interconnect](Cache& cache, MemoryLink& link) {
    link.bind(cache, interconnect);
    cache.bind_below(link);
    interconnect.add_master(link);
  };
  connect(node_cache, node_misses_);
  connect(triangle_cache, triangle_misses_);
  connect(texture_cache, texture_misses_);
}

}  // namespace artu::hw
