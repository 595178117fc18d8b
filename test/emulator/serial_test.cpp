// SPDX-License-Identifier: MIT
#include <chrono>
#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/tick_record_fields.hpp"
#include "emulator/images.hpp"
#include "flight/write_csv.hpp"
#include "fly/fly_scenario.hpp"
#include "hil/wire.hpp"
#include "input/scenario_file.hpp"
#include "protocol/hil_codec.hpp"
#include "protocol/tick_digest.hpp"
#include "report/results.hpp"
#include "sim/world.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using testing::HasSubstr;

/// The board's own image for a serial line, on an emulated board whose serial port is a terminal of this PC.
class EmulatedBoard {
 public:
  EmulatedBoard() {
    int out[2];
    EXPECT_EQ(::pipe(out), 0);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(out[1], STDOUT_FILENO);
      ::dup2(out[1], STDERR_FILENO);
      ::close(out[0]);
      const std::string elf = image("fantail-hil.elf").string();
      ::execlp("qemu-system-arm", "qemu-system-arm", "-nodefaults", "-no-user-config", "-display", "none", "-M",
               "netduinoplus2", "-serial", "pty", "-kernel", elf.c_str(), nullptr);
      ::_exit(1);
    }
    ::close(out[1]);
    std::FILE* said = ::fdopen(out[0], "r");
    char line[256] = "";
    char name[128] = "";
    while (device.empty() && std::fgets(line, sizeof line, said) != nullptr) {
      if (std::sscanf(line, "char device redirected to %127s", name) == 1) {
        device = name;
      }
    }
    std::fclose(said);
  }
  ~EmulatedBoard() {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  EmulatedBoard(const EmulatedBoard&) = delete;
  EmulatedBoard& operator=(const EmulatedBoard&) = delete;

  std::string device;

 private:
  pid_t process_ = -1;
};

TEST(Serial, TheBoardAtTheEndOfASerialLineFliesAsTheHostDoesAndCanBeFlownAgain) {
  if (const std::string objection = objection_to_images(); !objection.empty()) {
    GTEST_SKIP() << objection;
  }
  const EmulatedBoard board;
  ASSERT_FALSE(board.device.empty());
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (int flight = 0; flight < 2; ++flight) {
    hil::Target target{std::make_unique<hil::SerialPort>(board.device)};
    EXPECT_EQ(target.identity().image, "fantail-hil");
    sim::World here{scenario};
    sim::World there{scenario, sim::World::small_flash, target.maker()};
    for (int tick = 0; tick < 150; ++tick) {
      ASSERT_EQ(protocol::tick_digest(there.tick()), protocol::tick_digest(here.tick())) << tick;
      here.advance();
      there.advance();
    }
    EXPECT_EQ(target.link().damaged(), 0U);
    EXPECT_GT(target.times().tick, 0U);
  }
}

std::string why_not(const std::string& device) {
  try {
    const hil::SerialPort port{device};
  } catch (const hil::TargetError& error) {
    return error.what();
  }
  return "it was opened";
}

TEST(Serial, ADeviceThatIsMissingIsNoPortOrIsInUseIsNamed) {
  EXPECT_THAT(why_not("/dev/there-is-no-such-device"), HasSubstr("there is no such device"));
  EXPECT_THAT(why_not("/dev/null"), HasSubstr("/dev/null: it is not a serial port"));
  int master = -1;
  int slave = -1;
  char name[128] = "";
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  {
    const hil::SerialPort first{name};
    EXPECT_THAT(why_not(name), HasSubstr("another program is using it"));
  }
  EXPECT_EQ(why_not(name), "it was opened");
  ::close(slave);
  ::close(master);
}

TEST(Serial, ALineOnWhichNobodyAnswersIsGivenUp) {
  int master = -1;
  int slave = -1;
  char name[128] = "";
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  const auto begin = [&] {
    const hil::Target target{std::make_unique<hil::SerialPort>(name),
                             {},
                             {.send_again = std::chrono::milliseconds{20}, .give_up = std::chrono::milliseconds{100}}};
  };
  try {
    begin();
    ADD_FAILURE() << "somebody answered";
  } catch (const hil::TargetError& error) {
    EXPECT_THAT(error.what(), HasSubstr("has sent nothing for 0.1 s"));
  }
  ::close(slave);
  ::close(master);
}

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
