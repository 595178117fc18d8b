// SPDX-License-Identifier: MIT
#include "core/flight_plan_fields.hpp"

#include "core/flight_plan_table.hpp"

namespace fantail::core {

std::span<const PlanField> flight_plan_fields() { return plan_table::flight_plan_table; }

std::string_view sentence(PlanRule rule) {
  switch (rule) {
    case PlanRule::too_many_values: return "too many values";
    case PlanRule::finite: return "must be a finite number";
    case PlanRule::in_range: return "out of range";
    case PlanRule::hold_is_replayed:
      return "must not exceed 0.5 s: height_origin \"replay\" and \"velocity_only\" look back no further";
    case PlanRule::excitation_ends_after_it_begins: return "must be later than begin_s";
    case PlanRule::trim_within_limit: return "must lie inside controller.canard_limit_deg";
    case PlanRule::stop_beyond_limit: return "must not be smaller than controller.canard_limit_deg";
    case PlanRule::pulse_turns_servo: return "must not be zero";
    case PlanRule::pulse_within_servo:
      return "with pulse_per_degree_us, some angle inside of controller.canard_limit_deg would need a pulse "
             "outside of 500 to 2500 us, which no servo is given";
    case PlanRule::lists_of_one_length: return "step_times_s and step_angles_deg must have the same length";
    case PlanRule::steps_are_there: return "kind = \"steps\" needs at least one step";
    case PlanRule::steps_increase: return "step times must increase";
    case PlanRule::schedule_of_one_length: return "speeds_m_s and factors must have the same length";
    case PlanRule::schedule_speeds_increase: return "speeds must increase";
    case PlanRule::speed_is_known:
      return "needs the rocket's speed, which is only known with run.start = \"launch\" and a motion.height_origin "
             "other "
             "than \"from_detection\"";
    case PlanRule::integral_beside_proportional:
      return "\"integral\" needs controller.proportional_gain above 0: an integral alone makes a roll swing ever more";
    case PlanRule::axes_differ: return "must be another axis than the one that points to the nose";
    case PlanRule::gate_is_measured:
      return "must be \"guide\", unless run.start is \"launch\" and motion.height_origin is not \"from_detection\"";
    case PlanRule::burn_out_has_time: return "must be above 0 with a gate by burn-out: the burn time of the motor";
    case PlanRule::height_beyond_guide: return "must be above guide.length_m and guide.clearance_m together";
    case PlanRule::capture_turns_back:
      return "\"capture\" needs controller.proportional_gain above 0 and controller.rate_reference \"zero\"";
    case PlanRule::capture_model_is_whole:
      return "\"capture\" needs roll_inertia_kg_m2, reference_area_m2, damping_m2 and torque_m of roll_model, or none "
             "of "
             "them";
    case PlanRule::observer_has_model: return "must be above 0 with offset.rejection = \"observer\"";
  }
  return "unknown rule";
}

}  // namespace fantail::core
