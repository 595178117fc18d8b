// SPDX-License-Identifier: MIT
#include "listen/sensors.hpp"

#include <algorithm>

namespace fantail::listen {
namespace {

using core::SampleQuality;

core::Vector3 vector(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

}  // namespace

Channel::Channel(const Signal& signal, double longest_gap_s, double pad_end_s)
    : signal_{signal},
      positive_{range_end(signal, Side::positive)},
      negative_{range_end(signal, Side::negative)},
      between_{signal.time_s, longest_gap_s} {
  std::size_t count = 0;
  for (; count < signal.time_s.size() && (count == 0 || signal.time_s[count] < pad_end_s); ++count) {
    pad_ += signal.value[count];
  }
  pad_ /= static_cast<double>(std::max<std::size_t>(count, 1));
}

std::optional<Channel::Sample> Channel::at(double time_s) {
  if (!signal_.is_there()) {
    return Sample{};
  }
  if (time_s < signal_.time_s.front()) {
    return Sample{.value = pad_};
  }
  const auto place = between_.at(time_s);
  if (!place) {
    return std::nullopt;
  }
  const double value = place->of(signal_.value);
  return Sample{value, positive_ && positive_->holds(value), negative_ && negative_->holds(value)};
}

Sensors::Sensors(const ImuLog& log, double longest_gap_s, double pad_end_s, const core::FlightPlan& plan)
    : axial_{log.axial, longest_gap_s, pad_end_s},
      second_{log.second_axial, longest_gap_s, pad_end_s},
      y_{log.lateral_y, longest_gap_s, pad_end_s},
      z_{log.lateral_z, longest_gap_s, pad_end_s},
      roll_{log.roll_rate, longest_gap_s, pad_end_s},
      pitch_{log.pitch_rate, longest_gap_s, pad_end_s},
      yaw_{log.yaw_rate, longest_gap_s, pad_end_s},
      has_second_{log.second_axial.is_there()},
      two_gyros_{plan.sensors.gyros == core::GyroRule::two_agree} {}

void Sensors::read(double time_s, core::Microseconds now, core::Inputs& inputs) {
  inputs.time = now;
  const auto y = y_.at(time_s);
  const auto z = z_.at(time_s);
  const auto force = [&](Channel& axial, core::AccelerometerSample& sample) {
    if (const auto x = axial.at(time_s); x && y && z) {
      sample = {now, vector(x->value, y->value, z->value),
                x->at_positive_end ? SampleQuality::saturated : SampleQuality::valid};
    }
  };
  force(axial_, inputs.accelerometers[0]);
  if (has_second_) {
    force(second_, inputs.accelerometers[1]);
  } else {
    inputs.accelerometers[1] = inputs.accelerometers[0];
  }
  const auto roll = roll_.at(time_s);
  const auto pitch = pitch_.at(time_s);
  const auto yaw = yaw_.at(time_s);
  if (roll && pitch && yaw) {
    inputs.gyro = {now, vector(roll->value, pitch->value, yaw->value),
                   roll->at_positive_end || roll->at_negative_end ? SampleQuality::saturated : SampleQuality::valid};
  }
  if (two_gyros_) {
    inputs.second_gyro = inputs.gyro;
  }
}

}  // namespace fantail::listen
