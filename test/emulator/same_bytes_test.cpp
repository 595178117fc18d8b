// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/tick_record_fields.hpp"
#include "emulator/images.hpp"
#include "flight/write_csv.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "protocol/hil_codec.hpp"
#include "report/results.hpp"

namespace fantail::test {
namespace {

struct Case {
  std::string name;
  std::string scenario;
  std::vector<sim::Fault> faults{};
  std::vector<std::string> changes{};  ///< as after --set
};

void PrintTo(const Case& flown, std::ostream* out) { *out << flown.name; }

/// Every bit of every signal of every tick.
class Records {
 public:
  void add(const core::TickRecord& record) {
    std::array<std::byte, 512> bytes{};
    protocol::HilWriter writer{bytes};
    core::visit_signals(record, writer);
    size_ = writer.size();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size_));
  }
  [[nodiscard]] std::size_t ticks() const { return bytes_.size() / size_; }
  [[nodiscard]] std::size_t first_difference(const Records& other) const {
    const auto [here, there] = std::ranges::mismatch(bytes_, other.bytes_);
    return static_cast<std::size_t>(here - bytes_.begin()) / size_;
  }

 private:
  std::vector<std::byte> bytes_;
  std::size_t size_ = 1;
};

struct Flown {
  flight::Flight flight;
  Records records;
};

Flown fly(const sim::Scenario& scenario, const sim::MakeFlightComputer& make) {
  Flown flown;
  flown.flight =
      fly::fly_scenario(scenario, {}, [&](const auto& record) { flown.records.add(record); }, fly::Log::kept, make);
  return flown;
}

class Emulated : public testing::TestWithParam<Case> {};

TEST_P(Emulated, FlightIsThatOfTheHostTickByTickAndByteByByte) {
  if (const std::string objection = objection_to_images(); !objection.empty()) {
    GTEST_SKIP() << objection;
  }
  std::vector<input::Override> overrides;
  std::ranges::transform(GetParam().changes, std::back_inserter(overrides), input::parse_override);
  sim::Scenario scenario = input::load_scenario(GetParam().scenario, overrides);
  scenario.faults = GetParam().faults;
  hil::Target target{std::make_unique<hil::Emulator>(hil::EmulatorOptions{.image = image("fantail-emulator.elf")})};
  const Flown here = fly(scenario, sim::simulated_board);
  const Flown there = fly(scenario, target.maker());

  EXPECT_GT(here.records.ticks(), 15'000U);
  EXPECT_EQ(there.records.ticks(), here.records.ticks());
  EXPECT_EQ(there.records.first_difference(here.records), here.records.ticks()) << "the first tick that differs";
  EXPECT_FALSE(here.flight.log.empty());
  EXPECT_TRUE(there.flight.log == here.flight.log) << "flight.ftl";
  EXPECT_TRUE(flight::csv(there.flight) == flight::csv(here.flight)) << "flight.csv";
  EXPECT_EQ(result::json(report::results(there.flight).document), result::json(report::results(here.flight).document));
  EXPECT_EQ(target.times().overruns, 0U);
  EXPECT_EQ(target.link().damaged(), 0U);
}

// In the middle of control, in seconds after ignition.
const std::vector<sim::Fault> jammed_canard_and_dropouts{
    {.device = sim::Device::servo, .canard = 1, .how = sim::GearFault{sim::ServoFault::stuck}, .from_s = 2.0},
    {.device = sim::Device::accelerometer, .how = sim::Behaviour::hangs, .from_s = 1.0, .until_s = 1.3},
    {.device = sim::Device::imu, .how = sim::Behaviour::hangs, .from_s = 3.0, .until_s = 3.02}};

// With the rocket's own model (sim/vehicles/tasha3_launch2.toml).
const std::vector<std::string> observer_and_schedule{"offset.rejection=observer",
                                                     "roll_model.roll_inertia_kg_m2=0.00393",
                                                     "roll_model.reference_area_m2=5.0265e-5",
                                                     "roll_model.damping_m2=23",
                                                     "roll_model.torque_m=9",
                                                     "gain_schedule.speeds_m_s=[20,40,80]",
                                                     "gain_schedule.factors=[1.5,1.2,0.7]"};

INSTANTIATE_TEST_SUITE_P(All, Emulated,
                         testing::Values(Case{"FirstLaunch", "tasha3_launch1"}, Case{"SecondLaunch", "tasha3_launch2"},
                                         Case{"TunnelSteps", "tunnel_steps"},
                                         Case{"Integral", "tasha3_launch2_integral", jammed_canard_and_dropouts},
                                         Case{"ObserverAndSchedule", "tasha3_launch2", {}, observer_and_schedule},
                                         Case{"Faults", "tasha3_launch2", jammed_canard_and_dropouts}),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace fantail::test
