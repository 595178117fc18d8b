// SPDX-License-Identifier: MIT
#include "dormancy/launch.hpp"

#include <algorithm>
#include <limits>

#include "core/flight_plan_fields.hpp"

namespace fantail::dormancy {
namespace {

constexpr double tick_s = 1e-3;
constexpr double forever = std::numeric_limits<double>::infinity();

core::FlightPlan plan_for(const Planned& planned, core::RandomStream& random) {
  core::FlightPlan plan = core::default_plan();
  plan.run.tilt_limit = core::Angle::from_degrees(90.0F);
  plan.run.canard_fault = static_cast<core::CanardFaultPolicy>(random.whole(0, 2));
  plan.dormancy.until = static_cast<core::DormantUntil>(random.whole(1, 5));
  plan.dormancy.burn_time = core::from_seconds(static_cast<float>(planned.rocket.published_burn_s()));
  plan.dormancy.height_m = std::max(10.0F, static_cast<float>(planned.apogee_m) * random.between(0.1F, 0.7F));
  for (core::CanardPlan& canard : plan.canards.each) {
    canard.trim = core::Angle::from_degrees(random.between(-2.0F, 2.0F));
  }
  return plan;
}

/// The gate of each kind beside the law, with the motion that the law sees.
class Gates {
 public:
  Gates(const core::DormancyPlan& plan, const core::LaunchDetector& detector) : detector_{detector} {
    for (std::size_t i = 0; i < gates.size(); ++i) {
      core::DormancyPlan own = plan;
      own.until = gates[i];
      gates_[i].emplace(own);
    }
    own_.emplace(plan);
  }
  void follow(core::Phase before, const core::Inputs& inputs, const core::TickRecord& record) {
    if (before == core::Phase::armed) {
      detector_.update(inputs.time, inputs.accelerometers);
    }
    const bool asks_both = before == core::Phase::launched || before == core::Phase::dormant;
    const bool agree =
        !asks_both || detector_.agrees(inputs.time, inputs.accelerometers) || before == core::Phase::launched;
    if (before == core::Phase::launched && record.phase == core::Phase::armed) {
      detector_.reset();
    }
    if (before == core::Phase::armed && record.phase == core::Phase::launched) {
      own_->reset();
      for (auto& gate : gates_) {
        gate->reset();
      }
    }
    if (core::is_flight(before) || before == core::Phase::finished) {
      own_->update(record.time, record.motion, agree);
      for (auto& gate : gates_) {
        gate->update(record.time, record.motion, agree);
      }
    }
  }
  [[nodiscard]] bool is_open(std::size_t gate) const { return gates_[gate]->is_open(); }
  [[nodiscard]] bool own_is_open() const { return own_->is_open(); }

 private:
  core::LaunchDetector detector_;
  std::array<std::optional<core::DormancyGate>, gates.size()> gates_;
  std::optional<core::DormancyGate> own_;
};

/// What the truth says about the gates, as it is known so far.
struct Due {
  double largest_pressure = 0.0;
  double pressure_s = 0.0;
  double height_s = forever;

  void follow(const Ascent& ascent, const Burn& burn, double height_m) {
    const bool counts = burn.story != Story::second_burn || ascent.time_s() < ascent.pause_end_s();
    if (counts && ascent.pressure() > largest_pressure) {
      largest_pressure = ascent.pressure();
      pressure_s = ascent.time_s();
    }
    if (height_s == forever && ascent.height_m() > height_m) {
      height_s = ascent.time_s();
    }
  }
};

bool is_off_trim(const core::FlightPlan& plan, const core::TickRecord& record) {
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (record.canards[i].angle != plan.canards.each[i].trim) {
      return true;
    }
  }
  return false;
}

void watch_second_burn(const Ascent& ascent, const Burn& burn, bool is_open, Flown& flown) {
  const double since_s = ascent.time_s() - ascent.pause_end_s();
  if (burn.story != Story::second_burn || since_s < 0.0) {
    return;
  }
  if (!flown.closed_after_s && !is_open) {
    flown.closed_after_s = since_s;
  } else if (flown.closed_after_s && is_open && ascent.time_s() < ascent.last_thrust_s()) {
    flown.reopened_early = true;
  }
}

}  // namespace

Pad::Pad(core::RandomStream& random)
    : planned{draw_rocket(random)},
      errors{draw_errors(random)},
      plan{plan_for(planned, random)},
      law{plan},
      detector{plan.launch_detection, plan.motion.stale_time} {
  Senses senses{errors, {.white_m_s2 = 0.01 * g}, {}, 1.0, random};
  const Ascent ascent{planned.rocket, {.burn_s = 1.0, .thrust = 0.0}};
  for (int tick = 0; tick < 4'500; ++tick) {
    core::Inputs inputs = senses.read(now, ascent, g);
    inputs.arm_command = tick == 4'200;
    const core::TickRecord& record = law.step(inputs);
    if (tick > 4'200) {
      detector.update(now, inputs.accelerometers);
    }
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      senses.shafts[i] = record.canards[i].angle;
    }
    now += core::tick_period;
  }
}

Flown fly(const Pad& pad, const Burn& burn, const Fault& fault, core::RandomStream& random) {
  const double height_m = static_cast<double>(pad.plan.dormancy.height_m);
  core::Autopilot law = pad.law;
  core::Microseconds now = pad.now;
  Senses senses{pad.errors, draw_shaking(random), fault, pad.planned.top_m_s * pad.planned.top_m_s, random};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    senses.shafts[i] = pad.plan.canards.each[i].trim;
  }
  Ascent ascent{pad.planned.rocket, burn};
  Gates watched{pad.plan.dormancy, pad.detector};
  Due due;
  Flown flown;
  const double push_ends_s = burn.story == Story::second_burn ? ascent.last_thrust_s() + 0.5
                             : burn.story == Story::misfire   ? burn.push_s + 2.0
                                                              : 0.0;
  core::Phase before = law.phase();
  std::size_t opened = 0;
  double pressure_then = 0.0;  // the largest, when the gate for it opened
  while ((opened < gates.size() || ascent.time_s() < push_ends_s) && !ascent.is_over() &&
         (burn.story != Story::misfire || ascent.time_s() < push_ends_s)) {
    ascent.advance(tick_s);
    due.follow(ascent, burn, height_m);
    const core::Inputs& inputs = senses.read(now, ascent, 0.0);
    const core::TickRecord& record = law.step(inputs);
    now += core::tick_period;
    watched.follow(before, inputs, record);
    flown.left_guide =
        flown.left_guide || record.phase == core::Phase::dormant || record.phase == core::Phase::controlling;
    const bool may_move = record.phase == core::Phase::controlling && watched.own_is_open();
    flown.off_trim += !may_move && is_off_trim(pad.plan, record) ? 1 : 0;
    flown.control_without += record.phase == core::Phase::controlling && !watched.own_is_open() ? 1 : 0;
    for (std::size_t i = 0; i < gates.size(); ++i) {
      if (flown.left_guide && watched.is_open(i) && !flown.openings[i].opened_s) {
        flown.openings[i].opened_s = ascent.time_s();
        pressure_then = i == 1 ? due.largest_pressure : pressure_then;
        ++opened;
      }
    }
    watch_second_burn(ascent, burn, watched.is_open(0), flown);
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      senses.shafts[i] = record.canards[i].angle;
    }
    before = record.phase;
  }
  while (burn.story != Story::misfire && !ascent.is_over() &&
         (ascent.time_s() < ascent.last_thrust_s() || ascent.pressure() > 0.5 * due.largest_pressure ||
          due.height_s == forever)) {
    ascent.advance(tick_s);
    due.follow(ascent, burn, height_m);
  }
  const bool flies = burn.story != Story::misfire;
  flown.openings[0].due_s = flies ? ascent.last_thrust_s() : forever;
  flown.openings[1].due_s = flies ? due.pressure_s : forever;
  flown.openings[2].due_s = flies ? due.height_s : forever;
  for (Opening& opening : flown.openings) {
    opening.is_early = opening.opened_s && *opening.opened_s < opening.due_s;
  }
  flown.openings[1].is_early = flown.openings[1].is_early && (!flies || due.largest_pressure > 1.02 * pressure_then);
  return flown;
}

}  // namespace fantail::dormancy
