// SPDX-License-Identifier: MIT
#include "files/quantities.hpp"

#include <algorithm>

namespace fantail::files {
namespace {

using D = Dimension;
using Q = Quantity;

constexpr std::array all_quantities{
    KnownQuantity{"time", Q::time, D::time, "time_s"},
    KnownQuantity{"phase", Q::phase, {}, "phase"},
    KnownQuantity{"roll_angle", Q::roll_angle, D::angle, "roll_angle_deg"},
    KnownQuantity{"roll_rate", Q::roll_rate, D::angular_rate, "roll_rate_deg_s"},
    KnownQuantity{"reference", Q::reference, D::angle, "reference_deg"},
    KnownQuantity{"excitation", Q::excitation, D::angle, "excitation_deg"},
    KnownQuantity{"offset_estimate", Q::offset_estimate, D::angle, "offset_estimate_deg"},
    KnownQuantity{"command", Q::command, D::angle, "command_deg"},
    KnownQuantity{"saturated", Q::saturated, {}, "saturated"},
    KnownQuantity{"command_1", Q::command_1, D::angle, "command_1_deg"},
    KnownQuantity{"command_2", Q::command_2, D::angle, "command_2_deg"},
    KnownQuantity{"command_3", Q::command_3, D::angle, "command_3_deg"},
    KnownQuantity{"command_4", Q::command_4, D::angle, "command_4_deg"},
    KnownQuantity{"encoder_1", Q::encoder_1, D::angle, "encoder_1_deg"},
    KnownQuantity{"encoder_2", Q::encoder_2, D::angle, "encoder_2_deg"},
    KnownQuantity{"encoder_3", Q::encoder_3, D::angle, "encoder_3_deg"},
    KnownQuantity{"encoder_4", Q::encoder_4, D::angle, "encoder_4_deg"},
    KnownQuantity{"canard", Q::canard, D::angle, "canard_deg"},
    KnownQuantity{"axial", Q::axial, D::acceleration, "specific_force_m_s2"},
    KnownQuantity{"specific_force", Q::axial, D::acceleration, "specific_force_m_s2"},
    KnownQuantity{"axial_from_rest", Q::axial, D::acceleration, {}, true},
    KnownQuantity{"height", Q::height, D::length, "height_m"},
    KnownQuantity{"speed", Q::speed, D::speed, "speed_m_s"},
    KnownQuantity{"disturbance", Q::disturbance, D::angle, "disturbance_deg"},
    KnownQuantity{"geometric_roll", Q::geometric_roll, D::angle, "geometric_roll_deg"},
    KnownQuantity{"second_axial", Q::second_axial, D::acceleration},
    KnownQuantity{"second_axial_from_rest", Q::second_axial, D::acceleration, {}, true},
    KnownQuantity{"lateral_y", Q::lateral_y, D::acceleration},
    KnownQuantity{"lateral_z", Q::lateral_z, D::acceleration},
    KnownQuantity{"pitch_rate", Q::pitch_rate, D::angular_rate, "pitch_rate_deg_s"},
    KnownQuantity{"yaw_rate", Q::yaw_rate, D::angular_rate},
    KnownQuantity{"pitch", Q::pitch, D::angle, "pitch_deg"},
    KnownQuantity{"fan", Q::fan, {}, "fan_rpm"},
    KnownQuantity{"wind_speed", Q::wind_speed, D::speed, "wind_speed_m_s"},
    KnownQuantity{"height_above_the_sea", Q::height_above_the_sea, D::length},
    KnownQuantity{"total_speed", Q::total_speed, D::speed},
    KnownQuantity{"vertical_speed", Q::vertical_speed, D::speed},
    KnownQuantity{"horizontal_speed", Q::horizontal_speed, D::speed},
    KnownQuantity{"speed_to_the_east", Q::speed_to_the_east, D::speed},
    KnownQuantity{"speed_to_the_north", Q::speed_to_the_north, D::speed},
    KnownQuantity{"air_speed", Q::air_speed, D::speed},
    KnownQuantity{"angle_of_attack", Q::angle_of_attack, D::angle},
    KnownQuantity{"air_density", Q::air_density, D::density},
    KnownQuantity{"temperature", Q::temperature, D::temperature},
    KnownQuantity{"pressure", Q::pressure, D::pressure},
    KnownQuantity{"tilt", Q::tilt, D::angle},
    KnownQuantity{"acceleration_along_the_axis", Q::acceleration_along_the_axis, D::acceleration},
};

}  // namespace

std::span<const KnownQuantity> known_quantities() { return all_quantities; }

const KnownQuantity& known(Quantity quantity) {
  return *std::ranges::find(all_quantities, quantity, &KnownQuantity::quantity);
}

const KnownQuantity* of_own_column(std::string_view column) {
  const auto found = std::ranges::find(all_quantities, column, &KnownQuantity::column);
  return found == all_quantities.end() || column.empty() ? nullptr : &*found;
}

std::string word(Quantity quantity) {
  std::string words{known(quantity).name};
  std::ranges::replace(words, '_', ' ');
  return words;
}

}  // namespace fantail::files
