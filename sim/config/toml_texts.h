// What TOML lets a text hold, and no file name can.
#pragma once

#include "sim/config/toml_assigner.h"

namespace artu::sim {

/// Throws InputError where a key or a text in the table has a zero byte in it ("\u0000").
void refuse_zero_bytes(const toml::table& table, const PlaceOf& place_of);

}  // namespace artu::sim
