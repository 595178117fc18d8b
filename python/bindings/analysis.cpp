// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "identify/choices.hpp"
#include "identify/make_record.hpp"
#include "identify/model/roll_model.hpp"
#include "identify/result/answer.hpp"
#include "identify/study.hpp"
#include "input/messages.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "logs/flight_file.hpp"
#include "logs/roll_log.hpp"
#include "predict/answer.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/flown.hpp"
#include "python/bindings/scenario.hpp"
#include "result/document.hpp"
#include "sim/roll_inertia_course.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace nb = nanobind;

namespace fantail::python {
namespace {

/// What identify() in Python has arguments for.
struct Question {
  std::vector<std::string> windows;
  std::string nodes;
  std::string method;
  std::optional<std::string> vehicle;
  std::optional<double> inertia_kg_m2;
  std::optional<double> reference_area_m2;
  std::optional<std::string> density;
  std::optional<double> elevation_m;
  std::optional<double> speed_m_s;
  double lag_s = 0.0;
  bool fit_lag = false;
  bool fit_initial = false;
  bool truth = false;
};

identify::model::Airframe airframe_of(const Question& asked, const std::optional<flight::FlownAirframe>& flown) {
  identify::model::Airframe airframe;
  if (asked.vehicle) {
    const auto file = input::find_input(input::Shipped::vehicle, *asked.vehicle);
    const auto plant = input::read_vehicle(input::Document::load(file)).roll_plant;
    airframe = {.inertia_kg_m2 = plant.inertia_kg_m2, .reference_area_m2 = plant.reference_area_m2};
  } else if (flown) {
    airframe = {.inertia_kg_m2 = flown->roll_inertia_kg_m2, .reference_area_m2 = flown->reference_area_m2};
  } else if (!asked.inertia_kg_m2 || !asked.reference_area_m2) {
    throw text::Error{text::ErrorKind::usage,
                      "nothing says which rocket flew; allowed: vehicle, or inertia_kg_m2 and reference_area_m2"};
  }
  airframe.inertia_kg_m2 = asked.inertia_kg_m2.value_or(airframe.inertia_kg_m2);
  airframe.reference_area_m2 = asked.reference_area_m2.value_or(airframe.reference_area_m2);
  return airframe;
}

/// Which roll inertia held when: nothing where one was given, else that of the flight or of the vehicle that is named.
void add_inertia_course(identify::Question& q, const std::optional<flight::FlownAirframe>& flown,
                        const Question& asked) {
  if (flown) {
    q.simulation_grows_with_mach = flown->grows_with_mach;
  }
  if (asked.inertia_kg_m2) {
    return;
  }
  if (flown && std::abs(q.airframe.inertia_kg_m2 - flown->roll_inertia_kg_m2) <= 1e-6 * flown->roll_inertia_kg_m2) {
    q.record.roll_inertia = flown->roll_inertia_course;
  } else if (asked.vehicle) {
    const auto file = input::find_input(input::Shipped::vehicle, *asked.vehicle);
    q.inertia_since_ignition = sim::roll_inertia_course(input::read_vehicle(input::Document::load(file)));
  }
}

std::vector<identify::result::Method> methods(const std::string& word) {
  using identify::result::Method;
  if (word == "both") {
    return {Method::grid, Method::continuous};
  }
  if (word != "grid" && word != "continuous") {
    throw text::Error{text::ErrorKind::usage, "method: \"" + word + "\"; allowed: grid, continuous, both"};
  }
  return {word == "grid" ? Method::grid : Method::continuous};
}

std::string identify_log(const logs::RollLog& log, const std::optional<flight::FlownAirframe>& flown,
                         const Question& asked) {
  identify::Question q;
  q.methods = methods(asked.method);
  q.nodes = asked.nodes;
  q.fit_lag = asked.fit_lag;
  q.airframe = airframe_of(asked, flown);
  add_inertia_course(q, flown, asked);
  q.options.grid = identify::model::published_grid(q.airframe);
  q.options.start = asked.fit_initial ? identify::model::Start::fitted : identify::model::Start::measured;
  const identify::Air air = identify::choose_air(log, asked.density, asked.elevation_m);
  q.record.atmosphere = air.atmosphere;
  q.record.site_elevation_m = asked.elevation_m.value_or(0.0);
  q.record.lag_s = asked.lag_s;
  q.record.speed_m_s = asked.speed_m_s;
  q.windows = identify::find_windows(log, asked.windows);
  identify::result::Study study = identify::study(log, q);
  study.density = air.description;
  study.speed = asked.speed_m_s ? input::plain_number(*asked.speed_m_s) + " m/s throughout"
                : asked.truth   ? "true_speed_m_s"
                                : "speed_m_s";
  return result::json(identify::result::answer(study));
}

std::string identify_file(const std::string& path, const Question& asked) {
  const logs::RollLog log =
      logs::read_roll_log(path, {.truth = asked.truth}, {.canard = true, .speed = !asked.speed_m_s});
  return identify_log(log, logs::flown_airframe(path, {.truth = asked.truth}), asked);
}

std::string identify_flight(const Flown& flown, const Question& asked) {
  return identify_log(logs::roll_log(flown.flight, flown.flight.scenario, {.truth = asked.truth}),
                      flown.flight.airframe, asked);
}

/// What predict() in Python has arguments for.
struct Spread {
  std::optional<std::string> tunnel;
  std::optional<double> swirl_deg;
  std::pair<double, double> damping_factor;
  std::size_t runs = 200;
  unsigned threads = 0;
  std::optional<double> servo_lag_s;
  std::optional<double> servo_delay_s;
  bool other_vehicle = false;
};

std::string predict_launch(const Scenario& asked, const Spread& spread, double authority_percent, double held_percent,
                           double phase_margin_deg) {
  predict::require_launch(asked.scenario);
  std::optional<std::string> tunnel = asked.scenario.tunnel_result;
  if (spread.tunnel) {
    tunnel = input::find_input(input::Shipped::tunnel_result, *spread.tunnel).string();
  }
  if (!tunnel) {
    throw text::Error{text::ErrorKind::usage,
                      asked.scenario.name + ": names no tunnel_result; allowed: tunnel, a file or a shipped name"};
  }
  const std::optional<double> swirl_rad =
      spread.swirl_deg ? std::optional{text::radians(*spread.swirl_deg)} : std::nullopt;
  const predict::Options options{
      .runs = spread.runs,
      .threads = spread.threads,
      .damping = {.low = spread.damping_factor.first, .high = spread.damping_factor.second},
      .other_vehicle = spread.other_vehicle,
      .servo_lag_s = spread.servo_lag_s,
      .servo_delay_s = spread.servo_delay_s,
      .request = {.changes = asked.all_changes(), .command = "fantail predict " + asked.source}};
  const nb::gil_scoped_release others_may_work;
  const predict::Prediction prediction =
      predict::predict(asked.scenario, predict::read_tunnel_result(*tunnel, swirl_rad), options,
                       [](std::size_t) { give_up_if_interrupted(); });
  const predict::Decision decision = predict::decide(prediction, {.authority_share = 0.01 * authority_percent,
                                                                  .held_share = 0.01 * held_percent,
                                                                  .phase_margin_rad = text::radians(phase_margin_deg)});
  return result::json(predict::answer(
      prediction, decision, {.version = FANTAIL_VERSION, .seed = prediction.seed, .changes = options.request.changes}));
}

}  // namespace

void bind_analysis(nb::module_& m) {
  nb::class_<Question>(m, "Question")
      .def(nb::init<>())
      .def_rw("windows", &Question::windows)
      .def_rw("nodes", &Question::nodes)
      .def_rw("method", &Question::method)
      .def_rw("vehicle", &Question::vehicle, nb::arg().none())
      .def_rw("inertia_kg_m2", &Question::inertia_kg_m2, nb::arg().none())
      .def_rw("reference_area_m2", &Question::reference_area_m2, nb::arg().none())
      .def_rw("density", &Question::density, nb::arg().none())
      .def_rw("elevation_m", &Question::elevation_m, nb::arg().none())
      .def_rw("speed_m_s", &Question::speed_m_s, nb::arg().none())
      .def_rw("lag_s", &Question::lag_s)
      .def_rw("fit_lag", &Question::fit_lag)
      .def_rw("fit_initial", &Question::fit_initial)
      .def_rw("truth", &Question::truth);
  m.def("identify_file", &identify_file, nb::arg("path"), nb::arg("question"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def("identify_flight", &identify_flight, nb::arg("flight"), nb::arg("question"),
        nb::call_guard<nb::gil_scoped_release>());
  nb::class_<Spread>(m, "Spread")
      .def(nb::init<>())
      .def_rw("tunnel", &Spread::tunnel, nb::arg().none())
      .def_rw("swirl_deg", &Spread::swirl_deg, nb::arg().none())
      .def_rw("damping_factor", &Spread::damping_factor)
      .def_rw("runs", &Spread::runs)
      .def_rw("threads", &Spread::threads)
      .def_rw("servo_lag_s", &Spread::servo_lag_s, nb::arg().none())
      .def_rw("servo_delay_s", &Spread::servo_delay_s, nb::arg().none())
      .def_rw("other_vehicle", &Spread::other_vehicle);
  m.def("predict", &predict_launch, nb::arg("scenario"), nb::arg("spread"), nb::arg("authority_percent"),
        nb::arg("held_percent"), nb::arg("phase_margin_deg"));
}

}  // namespace fantail::python
