// SPDX-License-Identifier: MIT
#include "flight/turning.hpp"

#include <array>

#include "flight/point_table.hpp"

namespace fantail::flight {
namespace {

using Column = PointColumn<TurnPoint>;

constexpr std::array columns{Column{"time_s", &TurnPoint::time_s},
                             Column{"true_roll_rate_deg_s", &TurnPoint::true_roll_rate_rad_s, true},
                             Column{"true_pitch_rate_deg_s", &TurnPoint::true_pitch_rate_rad_s, true},
                             Column{"true_yaw_rate_deg_s", &TurnPoint::true_yaw_rate_rad_s, true},
                             Column{"true_tilt_deg", &TurnPoint::true_tilt_rad, true},
                             Column{"gyro_roll_rate_deg_s", &TurnPoint::gyro_roll_rate_rad_s, true},
                             Column{"gyro_pitch_rate_deg_s", &TurnPoint::gyro_pitch_rate_rad_s, true},
                             Column{"gyro_yaw_rate_deg_s", &TurnPoint::gyro_yaw_rate_rad_s, true},
                             Column{"tilt_deg", &TurnPoint::tilt_rad, true}};

}  // namespace

std::string turning_csv(const std::vector<TurnPoint>& turning) { return write_points<TurnPoint>(turning, columns); }

std::vector<TurnPoint> read_turning(const Table& table) { return read_points<TurnPoint>(table, columns); }

}  // namespace fantail::flight
