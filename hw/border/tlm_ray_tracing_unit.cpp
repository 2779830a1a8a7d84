#include "hw/border/tlm_ray_tracing_unit.h"

namespace artu::hw {

TlmRayTracingUnit::TlmRayTracingUnit(sc_core::sc_module_name name, const UnitConfig& config, const RunMode& mode,
                                     const TlmWindow& window)
    : sc_module(name),
      unit_("unit", config, mode, image_, {},
            [this, window](ClockDomain& domain) {
              auto made = std::make_unique<TlmMemoryBridge>("memory_port", domain, image_, window);
              bridge_ = made.get();
              return made;
            }),
      skip_rebuild_(config.skip.rebuild),
      registers("registers"),
      memory(bridge_->socket),
      interrupt("interrupt"),
      control_(
          sc_core::sc_time(1.0 / config.clock_mhz, sc_core::SC_US),
          [this](const sc_core::sc_time& delay) { begin_.notify(delay); },
          [this] { changed_.notify(sc_core::SC_ZERO_TIME); }) {
  if (window.bytes < sizeof(FrameDescriptor) + line_bytes || window.bytes % line_bytes != 0) {
    SC_REPORT_FATAL("artu", "the memory window must be whole lines of 64 bytes, and hold a frame descriptor");
  }
  image_.allocate(window.bytes - image_.size());
  unit_.keep_to_kernel_time([this] { end_.notify(sc_core::SC_ZERO_TIME); });
  registers.register_b_transport(this, &TlmRayTracingUnit::b_transport);
  registers.register_transport_dbg(this, &TlmRayTracingUnit::transport_dbg);
  count(unit_.statistics());
  SC_HAS_PROCESS(TlmRayTracingUnit);
  SC_METHOD(begin);
  sensitive << begin_;
  dont_initialize();
  SC_METHOD(end);
  sensitive << end_;
  dont_initialize();
  SC_METHOD(drive);  // also at the start of the simulation
  sensitive << changed_;
}

/// Whole lines within the window, and their bytes as the memory has them now.
bool TlmRayTracingUnit::load(Address begin, std::uint64_t bytes) {
  if (begin % line_bytes != 0 || !bridge_->inside(begin, bytes)) return false;
  const std::uint64_t lines = (bytes + line_bytes - 1) / line_bytes;
  return bridge_->load(begin, lines * line_bytes);
}

/// Bytes that the unit itself will write.
bool TlmRayTracingUnit::take_over(Address begin, std::uint64_t bytes) {
  if (!load(begin, bytes)) return false;
  bridge_->produce(begin, bytes);
  return true;
}

bool TlmRayTracingUnit::fetch_descriptor() {
  bridge_->produce_nothing();
  const Address descriptor = control_.descriptor();
  if (!load(descriptor, sizeof(FrameDescriptor))) return false;
  const FrameDescriptor& f = image_.at<FrameDescriptor>(descriptor);
  if (f.width == 0 || f.height == 0 || f.width > 16384 || f.height > 16384 || f.pitch < f.width || f.pitch % 64 != 0) {
    return false;
  }
  if (f.light_count > maximum_lights || !load(f.lights, f.light_count * sizeof(LightRecord))) return false;
  const std::uint64_t pixels = std::uint64_t{f.pitch} * f.height;
  if (!take_over(f.frame_buffer, pixels * 4) || !take_over(f.hit_classes, pixels)) return false;
  if (f.dynamic_moved == 0 && skip_rebuild_) return true;
  return take_over(f.dynamic_nodes, std::uint64_t{f.dynamic_node_lines} * line_bytes) &&
         take_over(f.dynamic_triangles, f.dynamic_reference_count * sizeof(TriangleRecord)) &&
         take_over(f.dynamic_attributes, f.dynamic_triangle_count * sizeof(AttributeRecord));
}

void TlmRayTracingUnit::begin() {
  if (fetch_descriptor()) {
    unit_.begin_frame(control_.descriptor(), records_);
    return;
  }
  result_ = {};
  control_.finish(FrameError::descriptor, 0);
}

FrameError TlmRayTracingUnit::error_of(const FrameResult& result) const {
  if (bridge_->failure() == TlmMemoryBridge::Failure::address) return FrameError::memory_address;
  if (bridge_->failure() == TlmMemoryBridge::Failure::response) return FrameError::memory_response;
  if (result.dead_locked) return FrameError::dead_lock;
  return result.violations.empty() ? FrameError::none : FrameError::accounting;
}

/// A frame that broke off is over when the memory has nothing of it any more.
void TlmRayTracingUnit::end() {
  if (!control_.running()) return;
  bridge_->drain([this] {
    result_ = unit_.end_frame();
    if (!result_.dead_locked) count(result_.statistics);
    control_.finish(error_of(result_), result_.cycles);
  });
}

void TlmRayTracingUnit::count(const Statistics& statistics) {
  std::vector<std::uint64_t> values;
  values.reserve(statistics.size());
  for (const Statistic& s : statistics) values.push_back(s.value);
  control_.set_counters(std::move(values));
}

std::vector<std::string> TlmRayTracingUnit::counter_names() {
  std::vector<std::string> names;
  for (const Statistic& s : unit_.statistics()) names.push_back(s.block + "." + s.name);
  return names;
}

}  // namespace artu::hw
