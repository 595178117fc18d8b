// SPDX-License-Identifier: MIT
#include "core/autopilot.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

#include "core/tick_record_fields.hpp"
#include "python/bindings/bind.hpp"
#include "text/error.hpp"

namespace nb = nanobind;

namespace fantail::python {
namespace {

using core::TickRecord;
using Vector = std::array<float, 3>;
using Four = std::array<std::optional<float>, core::canard_count>;

core::SampleQuality quality(const std::optional<Vector>& value, bool saturated) {
  return !value ? core::SampleQuality::absent : saturated ? core::SampleQuality::saturated : core::SampleQuality::valid;
}

core::Vector3 vector(const std::optional<Vector>& value) {
  return value ? core::Vector3{(*value)[0], (*value)[1], (*value)[2]} : core::Vector3{};
}

core::GyroSample gyro(std::int64_t time_us, const std::optional<Vector>& rate_rad_s, bool saturated) {
  return {
      .time = core::Microseconds{time_us}, .rate_rad_s = vector(rate_rad_s), .quality = quality(rate_rad_s, saturated)};
}

core::AccelerometerSample accelerometer(std::int64_t time_us, const std::optional<Vector>& force_m_s2, bool saturated) {
  return {.time = core::Microseconds{time_us},
          .specific_force_m_s2 = vector(force_m_s2),
          .quality = quality(force_m_s2, saturated)};
}

core::EncoderAngles angles(const Four& radians) {
  core::EncoderAngles all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = radians[i] ? std::optional{core::Angle::from_radians(*radians[i])} : std::nullopt;
  }
  return all;
}

void make_inputs(core::Inputs* made, std::int64_t time_us, const std::optional<Vector>& rate_rad_s,
                 const std::optional<Vector>& specific_force_m_s2, const Four& encoders_rad, bool arm_switch_closed,
                 bool arm_command, bool start_command, const std::optional<Vector>& second_rate_rad_s,
                 const std::optional<Vector>& second_specific_force_m_s2, std::optional<std::int64_t> sample_time_us,
                 bool rate_saturated, bool specific_force_saturated, bool abort) {
  const std::int64_t measured_us = sample_time_us.value_or(time_us);
  new (made) core::Inputs{
      .time = core::Microseconds{time_us},
      .gyro = gyro(measured_us, rate_rad_s, rate_saturated),
      .second_gyro = second_rate_rad_s ? std::optional{gyro(measured_us, second_rate_rad_s, false)} : std::nullopt,
      .accelerometers = {accelerometer(measured_us, specific_force_m_s2, specific_force_saturated),
                         accelerometer(measured_us, second_specific_force_m_s2, false)},
      .encoders = angles(encoders_rad),
      .arm_switch_closed = arm_switch_closed,
      .arm_command = arm_command,
      .start_command = start_command,
      .abort = abort};
}

/// A number, a flag, a word or None.
template <typename T>
nb::object plain(const T& value) {
  if constexpr (std::is_same_v<T, core::Angle>) {
    return nb::float_{static_cast<double>(value.radians())};
  } else if constexpr (std::is_same_v<T, std::optional<core::Angle>> ||
                       std::is_same_v<T, std::optional<core::GyroVote>> ||
                       std::is_same_v<T, std::optional<core::BarometerState>>) {
    return value ? plain(*value) : nb::object{nb::none()};
  } else if constexpr (std::is_same_v<T, core::Microseconds>) {
    return nb::int_{value.count()};
  } else if constexpr (std::is_enum_v<T>) {
    return nb::cast(core::name(value));
  } else {
    return nb::cast(value);
  }
}

nb::dict signals(const TickRecord& tick) {
  nb::dict all;
  core::visit_signals(tick, [&all](const core::SignalName& signal, const auto& value) {
    const std::string name = std::string{signal.name} + (signal.unit.empty() ? "" : "_") + std::string{signal.unit};
    all[name.c_str()] = plain(value);
  });
  return all;
}

/// The same of each canard.
template <auto of>
nb::tuple each_canard(const TickRecord& tick) {
  return nb::make_tuple(of(tick.canards[0]), of(tick.canards[1]), of(tick.canards[2]), of(tick.canards[3]));
}

constexpr const char* inputs_text =
    "Inputs of one step of the control law.\n\ntime_us: time of this step, on any clock that starts before the flight; "
    "a step is due every 1000 us.\nrate_rad_s: angular rate (x, y, z) in the body frame, x to the nose; None: no "
    "reading.\nspecific_force_m_s2: (x, y, z) likewise; x reads +9.80665 on the pad.\nencoders_rad: angle of each "
    "canard about its shaft; None: unknown.\narm_switch_closed, arm_command: together they arm; the command lasts one "
    "step.\nstart_command: starts control with run.start = \"tunnel\", one step long.\nabort: the abort input asks to "
    "end control, by the plan's "
    "run.abort_input.\nsecond_...: of a second gyro or "
    "accelerometer, if the plan requires one.\nsample_time_us: time of the measurement, if it is not time_us; a "
    "repeated sample keeps its time.\n..._saturated: the reading is at the end of its range.";

constexpr const char* autopilot_text =
    "The control law that flies in the rocket, for your own simulator.\n\nCall step() every millisecond from the pad "
    "on (3 s at rest give the gyro's bias), arm it, and move the canards to canards_rad of the result.";

}  // namespace

void bind_autopilot(nb::module_& m) {
  nb::class_<core::Inputs>(m, "Inputs", inputs_text)
      .def("__init__", &make_inputs, nb::arg("time_us"), nb::arg("rate_rad_s").none() = nb::none(),
           nb::arg("specific_force_m_s2").none() = nb::none(), nb::arg("encoders_rad") = Four{}, nb::kw_only(),
           nb::arg("arm_switch_closed") = false, nb::arg("arm_command") = false, nb::arg("start_command") = false,
           nb::arg("second_rate_rad_s").none() = nb::none(), nb::arg("second_specific_force_m_s2").none() = nb::none(),
           nb::arg("sample_time_us").none() = nb::none(), nb::arg("rate_saturated") = false,
           nb::arg("specific_force_saturated") = false, nb::arg("abort") = false)
      .def_prop_ro("time_us", [](const core::Inputs& inputs) { return inputs.time.count(); });

  nb::class_<TickRecord>(m, "Tick", "Result of one step of the control law.")
      .def_prop_ro("time_us", [](const TickRecord& t) { return t.time.count(); })
      .def_prop_ro(
          "phase", [](const TickRecord& t) { return core::name(t.phase); },
          "safe, armed, launched, dormant, controlling or finished")
      .def_prop_ro(
          "reason", [](const TickRecord& t) { return core::name(t.reason); }, "Reason for the phase")
      .def_prop_ro(
          "command_rad", [](const TickRecord& t) { return t.command.radians(); },
          "Roll command as a canard angle, within the plan's limit")
      .def_prop_ro(
          "saturated", [](const TickRecord& t) { return t.saturated; }, "The command was cut to its limit")
      .def_prop_ro("canards_rad", &each_canard<[](const core::CanardCommand& c) { return c.angle.radians(); }>,
                   "Shaft angle commanded to each canard, positive as its encoder counts")
      .def_prop_ro("pulses_us", &each_canard<[](const core::CanardCommand& c) { return c.pulse_us; }>,
                   "Pulse for each servo")
      .def_prop_ro("driven", &each_canard<[](const core::CanardCommand& c) { return c.driven; }>,
                   "False: this servo's output stays off")
      .def_prop_ro(
          "roll_angle_rad", [](const TickRecord& t) { return t.motion.roll_angle.radians(); },
          "Roll angle since launch detection, in the tunnel since control start; not wrapped")
      .def_prop_ro("roll_rate_rad_s", [](const TickRecord& t) { return t.motion.roll_rate_rad_s; })
      .def_prop_ro("reference_rad", [](const TickRecord& t) { return t.reference.radians(); })
      .def_prop_ro(
          "height_m", [](const TickRecord& t) { return t.motion.height_m; }, "Height above the place of lift-off")
      .def_prop_ro(
          "speed_m_s", [](const TickRecord& t) { return t.motion.speed_m_s; }, "Speed along the guide")
      .def_prop_ro("signals", &signals, "Every signal by its name with its unit; an enumeration as a word");

  auto bound_autopilot =
      nb::class_<core::Autopilot>(m, "Autopilot", autopilot_text)
          .def(nb::init<const core::FlightPlan&>(), nb::arg("plan"))
          .def(
              "step", [](core::Autopilot& law, const core::Inputs& inputs) { return law.step(inputs); },
              nb::arg("inputs"), "One step, nominally every millisecond.")
          .def_prop_ro(
              "phase", [](const core::Autopilot& law) { return core::name(law.phase()); },
              "safe, armed, launched, dormant, controlling or finished");
  refuse_to_pickle(bound_autopilot, "Autopilot",
                   "pass the arguments of Plan.load(), and make an Autopilot of that plan there");
}

}  // namespace fantail::python
