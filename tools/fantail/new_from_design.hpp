// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "airframe/new_rocket.hpp"
#include "airframe/openrocket/read.hpp"
#include "input/rasp_file.hpp"

namespace fantail::tool {

/// By the end of its name. Throws text::Error (bad_data) for a design of another program.
[[nodiscard]] bool is_openrocket(const std::string& file);

/// The rocket of a design from a file of this name, with this motor in its mount. The numbers that the file has stored
/// of a flight with it go along, for comparison.
[[nodiscard]] airframe::NewRocket rocket_of_design(const airframe::openrocket::Design& design, const std::string& file,
                                                   const input::RaspMotor& motor);

}  // namespace fantail::tool
