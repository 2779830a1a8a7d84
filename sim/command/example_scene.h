// One triangle: enough for the unit to say which numbers it reports.
#pragma once

#include "traces/frame.h"

namespace artu::sim {

traces::Scene example_scene();
traces::Frame example_frame();

}  // namespace artu::sim
