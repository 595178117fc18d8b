// SPDX-License-Identifier: MIT
#include "sim/lean_board.hpp"

#include <optional>

#include "avionics/sensor_scaling.hpp"
#include "sim/inside_avionics.hpp"
#include "sim/simulated_board.hpp"

namespace fantail::sim {

namespace inside {

using core::Inputs;
using core::Microseconds;
using core::TickRecord;

struct LookForNewPlan {
  using Pointer = void (Avionics::*)();
  friend Pointer member(LookForNewPlan tag);
};
template struct Open<LookForNewPlan, &Avionics::look_for_new_plan>;
struct Listen {
  using Pointer = void (Avionics::*)(Microseconds);
  friend Pointer member(Listen tag);
};
template struct Open<Listen, &Avionics::listen>;
struct ReadDevices {
  using Pointer = Inputs (Avionics::*)(Microseconds);
  friend Pointer member(ReadDevices tag);
};
template struct Open<ReadDevices, &Avionics::read_devices>;
struct FlyingLaw {
  using Pointer = std::optional<core::Autopilot> Avionics::*;
  friend Pointer member(FlyingLaw tag);
};
template struct Open<FlyingLaw, &Avionics::autopilot_>;
struct Follow {
  using Pointer = void (Avionics::*)(const TickRecord&, const Inputs&, const avionics::FlashFacts&);
  friend Pointer member(Follow tag);
};
template struct Open<Follow, &Avionics::follow>;
struct Situation {
  using Pointer = avionics::Situation Avionics::*;
  friend Pointer member(Situation tag);
};
template struct Open<Situation, &Avionics::situation_>;
struct Flash {
  using Pointer = avionics::FlashService Avionics::*;
  friend Pointer member(Flash tag);
};
template struct Open<Flash, &Avionics::flash_>;
struct PlanMayChange {
  using Pointer = bool (Avionics::*)() const;
  friend Pointer member(PlanMayChange tag);
};
template struct Open<PlanMayChange, &Avionics::plan_may_change>;
struct Send {
  using Pointer = void (Avionics::*)(const TickRecord&, const Inputs&);
  friend Pointer member(Send tag);
};
template struct Open<Send, &Avionics::report>;

}  // namespace inside

namespace {

class LeanBoard final : public SimulatedBoard {
 public:
  using SimulatedBoard::SimulatedBoard;

  // As Avionics::tick(), in its order.
  const core::TickRecord& tick() override {
    devices_.arm_switch.update();
    devices_.abort_contact.update();
    avionics::Avionics& avionics = *avionics_;
    const core::Microseconds now = devices_.clock.now();
    avionics::Situation& situation = inside::of<inside::Situation>(avionics);
    // Somebody talks to it: self-test and arming, and in the tunnel the start.
    const bool on_pad = situation.phase == core::Phase::safe || situation.phase == core::Phase::armed;
    if (on_pad) {
      inside::call<inside::LookForNewPlan>(avionics);
      inside::call<inside::Listen>(avionics, now);
    }
    const core::Inputs inputs = inside::call<inside::ReadDevices>(avionics, now);
    const core::TickRecord& record = inside::of<inside::FlyingLaw>(avionics)->step(inputs);
    devices_.servo.write(avionics::pulses(record.canards));
    if (!on_pad) {
      situation.phase = record.phase;
      return record;
    }
    avionics::FlashService& flash = inside::of<inside::Flash>(avionics);
    inside::call<inside::Follow>(avionics, record, inputs, flash.facts());
    flash.update(now, inside::call<inside::PlanMayChange>(avionics), {.safe = false, .session = {}});
    inside::call<inside::Send>(avionics, record, inputs);
    return record;
  }
};

}  // namespace

MakeFlightComputer unrecorded_board(const Scenario& scenario) {
  if (!scenario.faults.empty()) {
    return simulated_board;
  }
  return [](const core::FlightPlan& plan, const BoardPorts& ports, const avionics::Identity& identity) {
    return std::make_unique<LeanBoard>(plan, ports, identity);
  };
}

}  // namespace fantail::sim
