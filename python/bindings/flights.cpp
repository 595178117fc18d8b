// SPDX-License-Identifier: MIT
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "flight/fly_command.hpp"
#include "fly/fly_scenario.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/flown.hpp"
#include "python/bindings/scenario.hpp"
#include "runs/runner.hpp"

namespace nb = nanobind;

namespace fantail::python {
namespace {

Flown fly_one(const Scenario& asked, const fly::Look& look, fly::Log log) {
  flight::Flight flight = fly::fly_scenario(asked.scenario, look, {}, log);
  flight.changes = asked.all_changes();
  flight.command = flight::fly_command(asked.source, flight.changes);
  if (log == fly::Log::kept) {  // else only some columns are
    flight.without_control = fly::roll_without_control(asked.scenario, flight, look);
  }
  return Flown{std::move(flight)};
}

Flown fly(const Scenario& asked) {
  const nb::gil_scoped_release others_may_work;
  return fly_one(asked, [](double) { give_up_if_interrupted(); }, fly::Log::kept);
}

nb::list fly_many(const nb::list& scenarios, const std::optional<std::vector<std::string>>& columns, unsigned threads) {
  std::vector<const Scenario*> asked;
  for (const nb::handle each : scenarios) {
    asked.push_back(&nb::cast<const Scenario&>(each));
  }
  std::vector<std::optional<Flown>> flown(asked.size());
  {
    const nb::gil_scoped_release others_may_work;
    const auto work = [&](std::size_t i) {
      flown[i] = fly_one(*asked[i], {}, columns ? fly::Log::dropped : fly::Log::kept);
      if (columns) {
        flown[i]->keep_only(*columns);
      }
    };
    runs::parallel_for(asked.size(), threads, work, [](std::size_t) { give_up_if_interrupted(); });
  }
  nb::list all;
  for (std::optional<Flown>& each : flown) {
    all.append(nb::cast(std::move(*each)));
  }
  return all;
}

nb::object column(const Flown& flown, const std::string& name) {
  Flown::Column values = flown.column(name);
  switch (values.kind) {
    case Flown::Column::Kind::flags: return nb::cast(column_of<bool>(std::move(values.bytes)));
    case Flown::Column::Kind::phases: return nb::cast(column_of<std::uint8_t>(std::move(values.bytes)));
    case Flown::Column::Kind::numbers: break;
  }
  return nb::cast(column_of<double>(std::move(values.numbers)));
}

nb::dict events(const Flown& flown) {
  nb::dict all;
  for (const flight::NamedEvent& event : flight::named_events) {
    const std::optional<double>& time_s = flown.flight.events.*event.time_s;
    all[event.name] = time_s ? nb::cast(*time_s) : nb::none();
  }
  return all;
}

}  // namespace

void give_up_if_interrupted() {
  const nb::gil_scoped_acquire interpreter;
  if (PyErr_CheckSignals() != 0) {
    throw nb::python_error{};
  }
}

void bind_flights(nb::module_& m) {
  auto flight =
      nb::class_<Flown>(m, "Flight")
          .def_prop_ro("column_names", &Flown::column_names)
          .def("column", &column, nb::arg("name"))
          .def_prop_ro("events", &events)
          .def_prop_ro("summary_json", [](const Flown& f) { return result::json(f.results.document); })
          .def_prop_ro("verdict", [](const Flown& f) { return f.results.verdict.text; })
          .def_prop_ro("scenario", [](const Flown& f) { return f.flight.scenario; })
          .def_prop_ro("vehicle", [](const Flown& f) { return f.flight.vehicle; })
          .def_prop_ro("seed", [](const Flown& f) { return f.flight.seed; })
          .def_prop_ro("plan", [](const Flown& f) { return f.flight.plan; })
          .def_prop_ro("knows_plan", [](const Flown& f) { return f.flight.known.plan; })
          .def_prop_ro("notes", [](const Flown& f) { return f.flight.notes; })
          .def_prop_ro("log", [](const Flown& f) { return nb::bytes{f.flight.log.data(), f.flight.log.size()}; })
          .def("write", &Flown::write, nb::arg("folder"), nb::call_guard<nb::gil_scoped_release>());
  refuse_to_pickle(
      flight, "Flight",
      "pass dict(flight), its columns, or write(folder) and the folder, or the scenario's arguments and fly there");
  m.def("phase_names", [] {
    std::vector<std::string> names;
    names.reserve(core::phases);
    for (std::size_t i = 0; i < core::phases; ++i) {
      names.emplace_back(core::name(static_cast<core::Phase>(i)));
    }
    return names;
  });
  m.def("fly", &fly, nb::arg("scenario"));
  m.def("fly_many", &fly_many, nb::arg("scenarios"), nb::arg("columns").none(), nb::arg("threads"));
}

}  // namespace fantail::python
