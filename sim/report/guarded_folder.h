// A folder that is removed with an interruption from the moment on when it is there.
#pragma once

#include <memory>
#include <string>
#include <system_error>

#include "sim/report/interruption.h"

namespace artu::sim {

/// Makes the folder; none, and `error` empty, if it is there already and so another's. An interruption comes before, or
/// when it is guarded.
std::unique_ptr<RemoveOnInterrupt> make_guarded_folder(const std::string& path, std::error_code& error);

}  // namespace artu::sim
