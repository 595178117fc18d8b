// SPDX-License-Identifier: MIT

#include "avionics/board_rig.hpp"
#include "avionics/crash_record.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

// A tick that hangs in a device has not fed the watchdog. A device that never returns cannot be tested; that each call
// of every device comes before the tick's feed, and none after it, says the same.

/// Which tick it is, and how often the watchdog has been fed by the time of each call of a device.
struct Order {
  int ticks = 0;  ///< that have begun
  int fed = 0;
  int calls = 0;
  int too_late = 0;  ///< calls of a tick after its feed

  void called() {
    calls += 1;
    too_late += ticks > 0 && fed != ticks - 1 ? 1 : 0;
  }
};

struct Watchdog final : hal::Watchdog {
  explicit Watchdog(Order& order_) : order{order_} {}
  void feed() override { order.fed += 1; }
  Order& order;
};

template <typename Face, typename Device>
struct Watched : Face {
  Watched(Order& order_, Device& device_) : order{order_}, device{device_} {}
  Order& order;
  Device& device;
};

struct Clock final : Watched<hal::Clock, hal::Clock> {
  using Watched::Watched;
  [[nodiscard]] Microseconds now() const override { return order.called(), device.now(); }
};
struct Imu final : Watched<hal::Imu, hal::Imu> {
  using Watched::Watched;
  hal::ImuSample read() override { return order.called(), device.read(); }
  [[nodiscard]] hal::ImuScale scale() const override { return order.called(), device.scale(); }
};
struct Accelerometer final : Watched<hal::Accelerometer, hal::Accelerometer> {
  using Watched::Watched;
  hal::AccelerometerSample read() override { return order.called(), device.read(); }
  [[nodiscard]] float scale() const override { return order.called(), device.scale(); }
};
struct Servo final : Watched<hal::Servo, CountedServo> {
  using Watched::Watched;
  void write(const Pulses& pulses) override { order.called(), device.write(pulses); }
};
struct Encoder final : Watched<hal::Encoder, hal::Encoder> {
  using Watched::Watched;
  hal::EncoderReading read() override { return order.called(), device.read(); }
};
struct Contact final : Watched<hal::Contact, hal::Contact> {
  using Watched::Watched;
  [[nodiscard]] bool closed() const override { return order.called(), device.closed(); }
  [[nodiscard]] bool open() const override { return order.called(), device.open(); }
};
struct CanBus final : Watched<hal::CanBus, hal::CanBus> {
  using Watched::Watched;
  bool send(const hal::CanFrame& frame) override { return order.called(), device.send(frame); }
  std::optional<hal::CanFrame> receive() override { return order.called(), device.receive(); }
  [[nodiscard]] hal::CanState state() const override { return order.called(), device.state(); }
  [[nodiscard]] hal::CanCounters counters() const override { return order.called(), device.counters(); }
};
struct Flash final : Watched<hal::Flash, hal::Flash> {
  using Watched::Watched;
  [[nodiscard]] hal::FlashGeometry geometry() const override { return order.called(), device.geometry(); }
  hal::FlashResult read(std::uint32_t address, std::span<std::byte> out) override {
    return order.called(), device.read(address, out);
  }
  hal::FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override {
    return order.called(), device.program(address, bytes);
  }
  hal::FlashResult erase_sector(std::uint32_t address) override { return order.called(), device.erase_sector(address); }
  [[nodiscard]] bool busy() override { return order.called(), device.busy(); }
};
struct Console final : Watched<hal::Console, hal::Console> {
  using Watched::Watched;
  void write(std::string_view text) override { order.called(), device.write(text); }
};
struct Entropy final : Watched<hal::Entropy, hal::Entropy> {
  using Watched::Watched;
  std::uint32_t draw() override { return order.called(), device.draw(); }
};
struct Board final : Watched<hal::Board, hal::Board> {
  using Watched::Watched;
  [[nodiscard]] hal::BoardStatus status() override { return order.called(), device.status(); }
  std::optional<std::uint32_t> take_longest_tick_cycles() override {
    return order.called(), device.take_longest_tick_cycles();
  }
  void show(hal::Signal signal) override { order.called(), device.show(signal); }
};
struct BackupMemory final : Watched<hal::BackupMemory, hal::BackupMemory> {
  using Watched::Watched;
  [[nodiscard]] std::span<std::byte> bytes() override { return order.called(), device.bytes(); }
  [[nodiscard]] std::optional<Microseconds> running_time() override { return order.called(), device.running_time(); }
};

TEST(Watchdog, IsFedAfterTheLastCallOfADeviceInEveryTickAndSoByNoneThatHangsInOne) {
  hal::sim::Devices sim;
  sim.world.imu_scale = {.rate_rad_s = 0.001F, .specific_force_m_s2 = 9.80665F / counts_per_g};
  sim.world.accelerometer_scale_m_s2 = 9.80665F / counts_per_g;
  sim.world.imu.specific_force = sim.world.accelerometer.specific_force = {1000, 0, 0};
  sim.world.imu.status = sim.world.accelerometer.status = hal::Status::ok;
  CountedServo sim_servo;
  ReadConsole sim_console;
  SetEntropy sim_entropy;
  hal::sim::BackupMemory sim_backup;
  hal::sim::Flash sim_flash{{.size = 1U << 18U, .sector_size = 4096, .page_size = 256}};
  hal::sim::CanWire wire;
  hal::sim::CanBus sim_bus{wire};
  PcOnBus pc{wire};

  Order order;
  Clock clock{order, sim.clock};
  Imu imu{order, sim.imu};
  Accelerometer accelerometer{order, sim.accelerometer};
  Servo servo{order, sim_servo};
  Encoder encoder{order, sim.encoder};
  Contact arm_switch{order, sim.arm_switch};
  Contact abort_contact{order, sim.abort_contact};
  CanBus bus{order, sim_bus};
  Flash flash{order, sim_flash};
  Console console{order, sim_console};
  Watchdog watchdog{order};
  Entropy entropy{order, sim_entropy};
  Board board{order, sim.board};
  BackupMemory backup{order, sim_backup};
  Avionics avionics{{clock, imu, accelerometer, servo, encoder, arm_switch, abort_contact, bus, flash, console,
                     watchdog, entropy, board, backup},
                    core::default_plan()};
  ASSERT_EQ(order.fed, 0) << "nor before the first tick";

  // With something to do for each of them: reports, a self-test, an arming command, the boot counter in the flash.
  for (int i = 0; i < 9'000; ++i) {
    sim.world.time += millisecond;
    sim.world.imu.time = sim.world.accelerometer.time = sim.world.encoders.time = sim.world.time;
    for (std::size_t c = 0; c < hal::canards; ++c) {
      const auto& pulse = sim_servo.written[c];
      const double angle_deg = pulse ? static_cast<double>(pulse->count() - 1'500'000) / 10'000.0 : 0.0;
      const auto counts = static_cast<std::uint32_t>((angle_deg + 360.0) * 16384.0 / 360.0 + 0.5);
      sim.world.encoders.each[c] = {.counts = static_cast<std::uint16_t>(counts % 16384U), .status = hal::Status::ok};
    }
    if (i == 10) {
      pc.say(protocol::ArmAction::self_test);
    }
    sim.world.arm_switch_closed = i > 8'500;
    sim.arm_switch.update();
    if (i == 8'600) {
      pc.say(protocol::ArmAction::begin);
    }
    const int calls = order.calls;
    order.ticks += 1;
    avionics.tick();
    pc.listen();
    ASSERT_EQ(order.fed, order.ticks) << "once a tick";
    ASSERT_EQ(order.too_late, 0) << i;
    ASSERT_GT(order.calls, calls + 8) << i;
  }
  EXPECT_TRUE(pc.heard<protocol::ArmReply>()->nonce.has_value()) << "it never came to draw a number";
}

constexpr CrashRecord crash{.exception = 3,
                            .program_counter = 0x08001234,
                            .link_register = 0x08004321,
                            .stack_pointer = 0x20001FF0,
                            .program_status = 0x61000000,
                            .configurable_fault_status = 0x00000400,
                            .hard_fault_status = 0x40000000,
                            .fault_address = 0xE000ED38};

TEST(CrashRecord, ComesBackAsItWasLeft) { EXPECT_EQ(crash_in(seal(crash)), crash); }

TEST(CrashRecord, OfWhichOneBitHasFlippedIsNone) {
  const auto intact = seal(crash);
  for (std::size_t bit = 0; bit < 8 * intact.size(); ++bit) {
    auto bytes = intact;
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_FALSE(crash_in(bytes)) << "bit " << bit;
  }
}

TEST(CrashRecord, IsNotFoundInMemoryThatNobodyWrote) {
  std::array<std::byte, crash_record_size> bytes{};
  EXPECT_FALSE(crash_in(bytes));
  bytes.fill(std::byte{0xFF});
  EXPECT_FALSE(crash_in(bytes));
  // Zeros with the CRC of zeros, as from a seal around nothing.
  EXPECT_FALSE(crash_in(seal(std::array<std::uint32_t, crash_words>{})));
}

TEST(CrashRecord, IsTakenOnce) {
  std::array<std::byte, 256> place{};
  std::ranges::copy(seal(crash), place.begin());
  EXPECT_EQ(take_crash(place), crash);
  EXPECT_FALSE(take_crash(place));
  EXPECT_FALSE(take_crash({}));  // of a board without such memory
}

TEST(CrashRecord, IsToldWithThePlacesThatTheMapFileNames) {
  struct Listener final : hal::Console {
    std::string text;
    void write(std::string_view words) override { text += words; }
  } console;
  tell(crash, console);
  EXPECT_EQ(console.text,
            "crash: exception 0x00000003 at 0x08001234, called from 0x08004321, stack 0x20001ff0\n"
            "crash: CFSR 0x00000400, HFSR 0x40000000, fault address 0xe000ed38, xPSR 0x61000000\n");
}

}  // namespace

}  // namespace fantail::avionics
