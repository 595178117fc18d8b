// SPDX-License-Identifier: MIT
#include "protocol/bus_angle_frame.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "bus_rig.hpp"
#include "protocol/bus_frames.hpp"
#include "seed.hpp"

namespace fantail::protocol {
namespace {

// The signals by the database's own scale, packed by the functions that are generated from it.
BusFrame generated(std::uint16_t id, const PerCanard& angles, std::uint8_t counter) {
  CommandReportFrame::Raw raw{};
  raw.counter = counter;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (angles[i] && !std::isnan(angles[i]->radians())) {
      raw.*signals::driven.angle[i] = CanardAngle{}.raw(angles[i]->degrees());
      raw.*signals::driven.given[i] = 1;
    }
  }
  FrameBuilder frame{id};
  const BusFrame packed = CommandReportFrame::pack(raw);
  for (unsigned i = 0; i < packed.data.size(); ++i) {
    frame.put(8 * i, 8, packed.data[i]);
  }
  return frame.with_crc();
}

std::optional<core::Angle> any_angle(std::mt19937& random) {
  switch (std::uniform_int_distribution{0, 9}(random)) {
    case 0: return std::nullopt;
    case 1: return core::Angle::from_radians(std::numeric_limits<float>::quiet_NaN());
    case 2: return core::Angle::from_radians(-std::numeric_limits<float>::infinity());
    case 3: return core::Angle::from_degrees(std::uniform_real_distribution{-1e6F, 1e6F}(random));
    case 4:
      return core::Angle::from_degrees(0.005F * static_cast<float>(std::uniform_int_distribution{-4100, 4100}(random)));
    default: return core::Angle::from_degrees(std::uniform_real_distribution{-21.0F, 21.0F}(random));
  }
}

TEST(AngleFrame, IsBitForBitWhatTheGeneratedFunctionsMakeOfTheSameAngles) {
  std::mt19937 random{test::seed()};
  for (int i = 0; i < 100'000; ++i) {
    const PerCanard angles{any_angle(random), any_angle(random), any_angle(random), any_angle(random)};
    const auto counter = static_cast<std::uint8_t>(std::uniform_int_distribution{0, 15}(random));
    ASSERT_EQ(angle_frame(CommandReportFrame::id, angles, counter), generated(CommandReportFrame::id, angles, counter));
    ASSERT_EQ(angle_frame(EncoderReportFrame::id, angles, counter), generated(EncoderReportFrame::id, angles, counter));
    ASSERT_EQ(angle_frame(BenchRequestFrame::id, angles, counter, open_session),
              generated(BenchRequestFrame::id, angles, counter));
  }
}

}  // namespace
}  // namespace fantail::protocol
