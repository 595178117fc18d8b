// SPDX-License-Identifier: MIT
// The flight law in any state that it can be restored to, with any samples: no canard leaves its limits, the roll
// command is zero outside Controlling, and nothing becomes a number that is none.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/autopilot.hpp"
#include "core/finite.hpp"
#include "core/flight_plan_fields.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/state_block.hpp"
#include "target.hpp"

namespace fantail::fuzz {
namespace {

using namespace core;

std::array<FlightPlan, 4> make_plans() {
  std::array<FlightPlan, 4> plans;
  plans.fill(default_plan());
  plans[1].sensors.gyros = GyroRule::two_agree;
  plans[1].offset = {
      .rejection = OffsetRejection::integral, .integral_gain_per_s = 0.5F, .observer_bandwidth_rad_s = 1.0F};
  plans[2].run.start = Start::tunnel;
  plans[2].motion.height_origin = HeightOrigin::velocity_only;
  plans[3].run.canard_fault = CanardFaultPolicy::end_control;
  plans[3].launch_detection.accelerometers = AccelerometerRule::one;
  return plans;
}

/// The bytes that are left, and zeros behind their end.
class Bytes {
 public:
  explicit Bytes(std::span<const std::byte> bytes) : bytes_{bytes} {}
  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  std::uint32_t word() {
    std::array<std::byte, 4> word{};
    const std::size_t taken = std::min(word.size(), bytes_.size());
    std::ranges::copy(bytes_.first(taken), word.begin());
    bytes_ = bytes_.subspan(taken);
    return static_cast<std::uint32_t>(protocol::get<4>(word, 0));
  }
  float number() { return std::bit_cast<float>(word()); }
  Vector3 vector() {
    const float x = number();
    const float y = number();
    return {x, y, number()};
  }

 private:
  std::span<const std::byte> bytes_;
};

Inputs inputs(Bytes& bytes, Microseconds& now) {
  const std::uint32_t flags = bytes.word();
  now += Microseconds{(flags & 1U) != 0 ? static_cast<std::int32_t>(bytes.word()) : 1000};
  const auto quality = [&flags](unsigned bit) { return static_cast<SampleQuality>((flags >> bit) & 3U); };
  Inputs in{.time = now};
  in.gyro = {now, bytes.vector(), quality(1)};
  in.second_gyro = GyroSample{now, bytes.vector(), quality(3)};
  in.accelerometers = {AccelerometerSample{now, bytes.vector(), quality(5)},
                       AccelerometerSample{now, bytes.vector(), quality(7)}};
  for (std::size_t i = 0; i < canard_count; ++i) {
    in.encoders[i] = (flags & (512U << i)) != 0 ? std::optional{Angle::from_radians(bytes.number())} : std::nullopt;
  }
  in.arm_switch_closed = (flags & (1U << 13U)) != 0;
  in.arm_command = (flags & (1U << 14U)) != 0;
  in.start_command = (flags & (1U << 15U)) != 0;
  if ((flags & (1U << 16U)) != 0) {
    in.canard_request.emplace();
    for (Angle& angle : *in.canard_request) {
      angle = Angle::from_radians(bytes.number());
    }
  }
  return in;
}

void check(const FlightPlan& plan, const TickRecord& record) {
  for (std::size_t i = 0; i < canard_count; ++i) {
    const Angle limit =
        std::min({plan.controller.canard_limit, hard_canard_limit, plan.canards.each[i].mechanical_stop});
    require(abs(record.canards[i].angle) <= limit);
    require(is_finite(record.canards[i].pulse_us));
  }
  require(abs(record.command) <= plan.controller.canard_limit);
  require(record.phase == Phase::controlling || record.command == Angle{});
}

}  // namespace

std::vector<std::string> seeds() {
  std::vector<std::string> list;
  const auto plans = make_plans();
  for (std::size_t i = 0; i < plans.size(); ++i) {
    Autopilot law{plans[i]};
    Bytes none{{}};
    Microseconds now{1'000'000};
    for (int tick = 0; tick < 20; ++tick) {
      (void)law.step(inputs(none, now));
    }
    std::vector<std::byte> state(4096);
    protocol::StateWriter writer{state};
    law.visit_state(writer);
    list.push_back(static_cast<char>(i) + std::string{reinterpret_cast<const char*>(state.data()), writer.size()} +
                   std::string(200, '\0'));
  }
  return list;
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fantail::fuzz;
  static const auto plans = make_plans();
  if (size == 0) {
    return 0;
  }
  const FlightPlan& plan = plans[data[0] % plans.size()];
  const auto bytes = std::as_bytes(std::span{data, size}).subspan(1);
  Autopilot law{plan};
  fantail::protocol::StateWriter whole{{}};
  law.visit_state(whole);
  if (bytes.size() < whole.size() || !fantail::protocol::restore_state(law, bytes.first(whole.size()))) {
    return 0;
  }
  Bytes rest{bytes.subspan(whole.size())};
  Microseconds now{1'020'000};
  for (int tick = 0; tick < 64 && !rest.empty(); ++tick) {
    check(plan, law.step(inputs(rest, now)));
  }
  return 0;
}
