// SPDX-License-Identifier: MIT
#include "dormancy/sentences.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "report/hold.hpp"
#include "text/apart.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::dormancy {
namespace {

using core::DormantUntil;
using text::brief;
using text::degrees;
using text::fixed;

// Ranges ask for no more, from the direction of the launch guide.
constexpr double largest_tilt_rad = text::radians(30.0);

bool waits_for_burn_out(const core::FlightPlan& plan) {
  return plan.dormancy.until == DormantUntil::burn_out || plan.dormancy.until == DormantUntil::burn_out_and_height;
}

bool waits_for_height(const core::FlightPlan& plan) {
  return plan.dormancy.until == DormantUntil::height || plan.dormancy.until == DormantUntil::burn_out_and_height ||
         plan.dormancy.until == DormantUntil::max_dynamic_pressure_and_height;
}

bool is_launch(const core::FlightPlan& plan) { return plan.run.start == core::Start::launch; }

bool waits_beyond_guide(const core::FlightPlan& plan) {
  return is_launch(plan) && plan.dormancy.until != DormantUntil::guide;
}

double seconds(core::Microseconds time) { return static_cast<double>(core::seconds(time)); }

std::string capture_clause(const CaptureForecast& forecast, const Opening& opening) {
  if (opening.reopenings > 0) {
    return "no capture time is promised, because the gate closes again";
  }
  if (forecast.within_s || forecast.from_any_angle_within_s) {
    const double within_s = std::max(forecast.within_s.value_or(0.0), forecast.from_any_angle_within_s.value_or(0.0));
    return fmt::format(
        "by calculation, the roll is captured within {} s{}{}", fixed(std::ceil(10.0 * within_s) / 10.0, 1),
        forecast.from_any_angle_within_s ? " from any roll angle" : "",
        within_s > report::longest_capture_s
            ? fmt::format(" (a verdict leaves out only the first {} s)", brief(report::longest_capture_s, 1))
            : "");
  }
  return fmt::format("no capture time is promised: {}", forecast.why_not);
}

std::string residual_clause(const Outlook& outlook, const std::optional<CaptureForecast>& forecast) {
  if (!forecast || !forecast->residual_rate_rad_s) {
    return {};
  }
  return fmt::format("the canards cannot stop the rotation: {} deg/s remain at {} m/s, as the gate opens",
                     fixed(std::abs(degrees(*forecast->residual_rate_rad_s)), 0),
                     fixed(outlook.opening.value().speed_m_s, 0));
}

/// From first thrust, as the flight code has it, to the end of the thrust curve.
double burn_to_end_s(const Outlook& outlook) {
  return outlook.burn_s.value() + outlook.thrust_end.value().time_s - outlook.last_thrust.value().time_s;
}

std::string on_early_burn_out(const core::FlightPlan& plan, const Outlook& outlook) {
  if (!outlook.burn_s || !outlook.thrust_end || !waits_for_burn_out(plan) || plan.dormancy.burn_time.count() <= 0) {
    return {};
  }
  constexpr double largest_factor = 5.0;
  const double to_end_s = burn_to_end_s(outlook);
  const double least = std::ceil(100.0 * to_end_s / seconds(plan.dormancy.burn_time)) / 100.0;
  return least > largest_factor
             ? fmt::format(". A dormancy.burn_time_s of {} would keep it closed to the end of this thrust curve",
                           fixed(std::ceil(100.0 * to_end_s) / 100.0, 2))
             : fmt::format(
                   ". A dormancy.burn_clock_factor of {} or more would keep it closed to the end of this thrust curve",
                   brief(least, 2));
}

/// The gate is open before the motor has burnt out.
std::string early(const core::FlightPlan& plan, const Outlook& outlook) {
  const auto after_s = outlook.opens_after_thrust_s();
  if (!after_s || *after_s > -0.005) {
    return {};
  }
  const std::string by_s = brief(-*after_s, 2);
  if (waits_for_burn_out(plan)) {
    return fmt::format("the gate opens {} s before the last thrust (2 % of its peak){}", by_s,
                       on_early_burn_out(plan, outlook));
  }
  return fmt::format("when the gate opens the motor still burns for {} s, to 2 % of its peak thrust", by_s);
}

std::string wrong_burn_time(const core::FlightPlan& plan, const Outlook& outlook) {
  if (!waits_for_burn_out(plan) || !outlook.burn_s || !outlook.thrust_end) {
    return {};
  }
  constexpr double tolerance = 0.02;
  const double stated_s = seconds(plan.dormancy.burn_time);
  const double to_end_s = burn_to_end_s(outlook);
  if (stated_s >= (1.0 - tolerance) * *outlook.burn_s && stated_s <= (1.0 + tolerance) * to_end_s) {
    return {};
  }
  return fmt::format(
      "dormancy.burn_time_s = {}, but this motor burns for {} s to 2 % of its peak thrust and for {} s in all",
      text::apart(stated_s, *outlook.burn_s, 2), fixed(*outlook.burn_s, 2), fixed(to_end_s, 2));
}

std::string beyond_gyro(const sim::Scenario& scenario, const Outlook& outlook) {
  constexpr double comfortable = 0.8;
  const sim::RollPlant& plant = scenario.vehicle.roll_plant;
  double offset_rad = 0.0;
  for (const sim::DisturbanceNode& node : scenario.disturbance) {
    offset_rad = std::max(offset_rad, std::abs(node.angle_rad));
  }
  const double range_rad_s = scenario.vehicle.imu.full_scale_rad_s;
  if (!(plant.damping_m2 > 0.0)) {
    return {};
  }
  const double spin_rad_s = plant.torque_m * offset_rad * outlook.top_speed_m_s / plant.damping_m2;
  if (spin_rad_s < comfortable * range_rad_s) {
    return {};
  }
  return fmt::format(
      "before control, the fin offset of {} deg can turn the rocket at {} deg/s (steady roll at {} m/s); the gyro "
      "measures up to {} deg/s",
      brief(degrees(offset_rad), 1), fixed(degrees(spin_rad_s), 0), fixed(outlook.top_speed_m_s, 0),
      fixed(degrees(range_rad_s), 0));
}

std::string wide_tilt(const core::RunPlan& run) {
  const auto limit_rad = static_cast<double>(run.tilt_limit.radians());
  const bool is_wide = limit_rad > largest_tilt_rad + 1e-6;
  const bool from_vertical = run.tilt_from == core::TiltOrigin::vertical;
  if (!is_wide && !from_vertical) {
    return {};
  }
  return fmt::format("run.tilt_limit_deg = {} from the {}: ranges allow at most 30 degrees from the launch guide",
                     brief(degrees(limit_rad), 1), from_vertical ? "vertical" : "launch guide");
}

}  // namespace

std::string opening_clause(const sim::Scenario& scenario, const Outlook& outlook,
                           const std::optional<CaptureForecast>& forecast) {
  const core::FlightPlan& plan = scenario.plan;
  if (!waits_beyond_guide(plan) || !outlook.opening) {
    return {};
  }
  const Opening& opening = *outlook.opening;
  std::string all = fmt::format("the gate opens at {} s, {} m, {} m/s through the air", fixed(opening.time_s, 2),
                                fixed(opening.height_m, 0), fixed(opening.speed_m_s, 0));
  if (!opening.was_waited_for) {
    all += ", where control begins in any case: it was open at the end of the guide";
  }
  all += fmt::format("; the rocket then turns at {} deg/s", fixed(degrees(opening.rate_rad_s), 0));
  if (const auto costs_s = outlook.height_costs_s(); costs_s && plan.dormancy.until == DormantUntil::height) {
    all += fmt::format("; the margin for the height's error costs {} s", fixed(*costs_s, 2));
  }
  const bool again = opening.reopenings > 0;
  if (again) {
    all += fmt::format("; in the simulated flight it closes and reopens {}", text::counted(opening.reopenings, "time"));
  }
  if (opening.captured_after_s) {
    all += fmt::format("; {} the roll is captured {} s later", again ? "after the last" : "in the simulated flight",
                       fixed(*opening.captured_after_s, 2));
  }
  if (forecast && !forecast->residual_rate_rad_s) {
    all += "; " + capture_clause(*forecast, opening);
  }
  return all;
}

std::string never_opened(const sim::Scenario& scenario, const Outlook& outlook) {
  const core::FlightPlan& plan = scenario.plan;
  const auto height_m = static_cast<double>(plan.dormancy.height_m);
  const bool is_above_apogee = waits_for_height(plan) && outlook.apogee && outlook.apogee->height_m < height_m;
  const bool was_waited_for = outlook.stayed_because == core::PhaseReason::gate_never_opened;
  if (outlook.opening || !waits_beyond_guide(plan) || (!was_waited_for && !is_above_apogee)) {
    return {};
  }
  const std::string asked = brief(height_m, 1);
  if (waits_for_height(plan) && outlook.apogee) {
    if (is_above_apogee) {
      return fmt::format(
          "the gate is not reached: the apogee of {} m is below dormancy.height_m = {}. Control never begins",
          text::apart(outlook.apogee->height_m, height_m, 0), asked);
    }
    if (plan.dormancy.until == DormantUntil::height && outlook.gyro_was_at_its_end) {
      return "the gate is not reached: the gyro was at the end of its range, so the height is not known. Control never "
             "begins";
    }
    if (plan.dormancy.until == DormantUntil::height) {
      return fmt::format(
          "the gate is not reached: at the apogee of {} m the height is not known well enough to be above "
          "dormancy.height_m = {}. Control never begins",
          text::apart(outlook.apogee->height_m, height_m, 0), asked);
    }
  }
  if (plan.dormancy.until == DormantUntil::burn_out) {
    const double clock_s = static_cast<double>(plan.dormancy.burn_clock_factor) * seconds(plan.dormancy.burn_time);
    if (outlook.apogee && clock_s >= outlook.apogee->time_s) {
      return fmt::format(
          "the gate is not reached: the burn clock of {} s (dormancy.burn_clock_factor times dormancy.burn_time_s) "
          "ends "
          "after apogee at {} s. Control never begins",
          fixed(clock_s, 2), fixed(outlook.apogee->time_s, 2));
    }
  }
  return "the gate is not reached before apogee: control never begins";
}

std::vector<std::string> doubts(const core::FlightPlan& plan) {
  std::vector<std::string> all;
  if (!is_launch(plan)) {
    return all;
  }
  all.push_back(wide_tilt(plan.run));
  const bool captures = plan.controller.entry == core::ControlEntry::capture;
  if (!captures && waits_beyond_guide(plan)) {
    all.emplace_back("controller.entry = \"as_published\": every turn that is made before control is turned back");
  }
  if (captures && plan.roll_model.torque_m <= 0.0F) {
    all.emplace_back(
        "controller.entry = \"capture\" without [roll_model]: the turn is chosen from gains and spin alone");
  }
  if (captures && plan.excitation.form != core::ExcitationForm::none &&
      seconds(plan.excitation.begin) < report::longest_capture_s) {
    all.push_back(fmt::format("excitation.begin_s = {}: it takes canard angle from capture. Begin at {} s or later",
                              brief(seconds(plan.excitation.begin), 3), brief(report::longest_capture_s, 1)));
  }
  std::erase(all, "");
  return all;
}

std::vector<std::string> doubts(const sim::Scenario& scenario, const Outlook& outlook,
                                const std::optional<CaptureForecast>& forecast) {
  const core::FlightPlan& plan = scenario.plan;
  std::vector<std::string> all;
  if (!waits_beyond_guide(plan)) {
    return all;
  }
  all.push_back(never_opened(scenario, outlook));
  all.push_back(early(plan, outlook));
  all.push_back(wrong_burn_time(plan, outlook));
  all.push_back(beyond_gyro(scenario, outlook));
  all.push_back(residual_clause(outlook, forecast));
  std::erase(all, "");
  return all;
}

}  // namespace fantail::dormancy
