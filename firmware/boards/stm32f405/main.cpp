// SPDX-License-Identifier: MIT
// The flight image: construct, look whether all is there, loop.
#include "avionics/avionics.hpp"
#include "avionics/backup_map.hpp"
#include "avionics/crash_record.hpp"
#include "avionics/flight_memory.hpp"
#include "boards/cortex_m4/forever.hpp"
#include "boards/cortex_m4/image.hpp"
#include "boards/stm32f405/crash.hpp"
#include "boards/stm32f405/hardware.hpp"
#include "core/flight_plan_members.hpp"

using namespace fantail;  // NOLINT(google-build-using-namespace): it all comes together here
using boards::stm32f405::Hardware;

namespace {

// From the last seal to the first look at the clock, for a board whose crystal of 32.768 kHz does not run: half of a
// seal's 10 ms, and 10 ms of reset and start; when the watchdog had to find out, its 50 ms. All of it is computed and
// nothing measured; docs/devices.md says how far it may be off.
hal::Microseconds assumed_gap(hal::ResetCause cause) {
  return hal::Microseconds{cause == hal::ResetCause::watchdog ? 65'000 : 15'000};
}

// In each tick: all of the image in some 60 of them, 0.08 ms each, long before a self-test has passed. At once it would
// take 3 ms, for which canards would wait after a reset in flight.
constexpr std::size_t image_part = 2'048;

void introduce(Hardware& hardware) {
  hal::Console& console = hardware.console();
  console.write("\nFantail ");
  console.write(avionics::firmware_version());
  console.write(", git ");
  console.write(avionics::git_hash());
  console.write("\n");
  const auto crash = avionics::take_crash(avionics::crash_place(hardware.backup_memory().bytes()));
  if (crash) {
    hardware.board().add(hal::BoardFault::crashed);
    avionics::tell(*crash, console);
  } else if (hardware.board().status().reset_cause == hal::ResetCause::software) {
    // This firmware resets itself when it has crashed and never else, so it was a probe: somebody flashes a board in
    // the middle of a tunnel run, and his canards must not go on where they were.
    hardware.board().was_reset_by(hal::ResetCause::pin);
  }
}

}  // namespace

int main() {
  static boards::Forever<Hardware> room_for_hardware;
  Hardware& hardware = room_for_hardware.make();
  introduce(hardware);
  const hal::ResetCause cause = hardware.board().status().reset_cause;
  const auto flight_time = avionics::clock_after_reset(hardware.backup_memory(), cause, assumed_gap(cause));
  if (flight_time) {
    hardware.clock().begin_at(*flight_time);
  }
  hardware.start(flight_time ? hal::stm32f4::SensorStart::in_flight : hal::stm32f4::SensorStart::power_up);

  static boards::Forever<avionics::Avionics> room_for_avionics;
  avionics::Avionics& avionics =
      room_for_avionics.make(hardware.devices(), core::default_plan(),
                             avionics::Identity{.firmware_version = avionics::firmware_version(),
                                                .git_hash = avionics::git_hash(),
                                                .vehicle = {},
                                                .sensors = "ICM-42688-P, KX134-1211"});
  boards::stm32f405::centre_on_crash(avionics);
  boards::ImageCheck image;
  for (;;) {
    hardware.wait_for_tick();
    avionics.tick();
    image.go_on(image_part);
    if (image.has_failed()) {
      hardware.board().add(hal::BoardFault::image_broken);
    }
  }
}
