// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "fantail/airframe_options.hpp"
#include "fantail/command_line.hpp"
#include "fantail/deliver.hpp"
#include "fantail/identify_options.hpp"
#include "fantail/log_info.hpp"
#include "fantail/log_options.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "identify/choices.hpp"
#include "identify/identification.hpp"
#include "identify/joint_fit.hpp"
#include "identify/make_record.hpp"
#include "identify/result/answer.hpp"
#include "identify/study.hpp"
#include "identify/validate.hpp"
#include "input/messages.hpp"
#include "input/shipped.hpp"
#include "logs/roll_log.hpp"

namespace fantail::tool {
namespace {

logs::RollLog read(const IdentifyOptions& o, const std::string& data) {
  return logs::read_roll_log(data, reading(o.log), {.canard = o.loop == "open", .speed = !o.speed_m_s});
}

std::vector<identify::Window> windows(const IdentifyOptions& o, const logs::RollLog& log) {
  if (o.from_s || o.to_s) {
    return {{.from_s = o.from_s, .to_s = o.to_s}};
  }
  return identify::find_windows(log, o.windows);
}

std::filesystem::path output_folder(const IdentifyOptions& o) {
  if (!o.out.empty()) {
    return o.out;
  }
  std::string name;
  for (const std::string& data : o.data) {
    name += fmt::format("{}{}", name.empty() ? "" : "+", name_of_log(data));
  }
  return std::filesystem::path{"out"} / (o.validate ? "validate" : "identify") / short_name(name);
}

identify::result::Study study_of(const IdentifyOptions& o, const std::string& data) {
  identify::Question q = question(o, data);
  const NamedAirframe rocket = named_airframe(o.airframe, data, reading(o.log));
  q.airframe = rocket.airframe;
  q.record.roll_inertia = rocket.flown_inertia;
  q.inertia_since_ignition = rocket.inertia_since_ignition;
  q.grows_with_mach = rocket.grows_with_mach;
  const identify::model::Grid published = identify::model::published_grid(q.airframe);
  q.options.grid.alpha_m2 = identify::parse_axis(o.grid_alpha).value_or(published.alpha_m2);
  q.options.grid.beta_m = identify::parse_axis(o.grid_beta).value_or(published.beta_m);
  const logs::RollLog log = read(o, data);
  save_columns(o.log, data);
  const identify::Air air = identify::choose_air(log, o.density, o.elevation_m);
  q.record.atmosphere = air.atmosphere;
  q.record.site_elevation_m = o.elevation_m.value_or(0.0);
  q.windows = windows(o, log);
  identify::result::Study result = study(log, q);
  const bool changes = !rocket.flown_inertia.empty() || !rocket.inertia_since_ignition.empty();
  result.vehicle = fmt::format("{}, I {} kg m2{}, A {} m2", rocket.name, input::about(rocket.airframe.inertia_kg_m2),
                               changes ? " at lift-off" : "", input::about(rocket.airframe.reference_area_m2));
  if (o.windows.empty() && log.phase.empty() && !o.from_s && !o.to_s) {
    result.warnings.emplace_back(
        "The log has no phases, so the window is the whole log, including the time before and after control.");
  }
  if (wants_flown_plan(o)) {
    result.warnings.emplace_back(
        "The law is that of the plan in the flight log, except for values given on the command line.");
  }
  result.warnings.insert(result.warnings.end(), rocket.warnings.begin(), rocket.warnings.end());
  result.density = air.description;
  result.speed = o.speed_m_s   ? input::plain_number(*o.speed_m_s) + " m/s throughout"
                 : o.log.truth ? "true_speed_m_s"
                               : "speed_m_s";
  return result;
}

/// What is read: logs, or folders of them, and what else the command names.
result::Made made(const IdentifyOptions& o) {
  std::vector<std::filesystem::path> files{o.data.begin(), o.data.end()};
  if (o.validate) {
    const std::filesystem::path model = *o.validate;
    files.push_back(std::filesystem::is_directory(model) ? model / "identification.json" : model);
  }
  if (o.airframe.vehicle) {
    files.push_back(input::find_input(input::Shipped::vehicle, *o.airframe.vehicle));
  }
  if (o.plan) {
    files.push_back(input::find_input(input::Shipped::plan, *o.plan));
  }
  return made_with(files);
}

void write(const result::Document& document, const IdentifyOptions& o, Chapters& chapters) {
  give_up_if_interrupted();
  const std::filesystem::path folder = output_folder(o);
  std::vector<std::string> shown{"page"};
  for (const result::Table& sheet : document.spreadsheets) {
    shown.push_back(*sheet.key);
  }
  std::vector<std::filesystem::path> inputs{o.data.begin(), o.data.end()};
  if (o.validate) {
    inputs.emplace_back(*o.validate);
  }
  deliver(document, {.folder = folder,
                     .name = o.validate ? "validation" : "identification",
                     .page = "report",
                     .inputs = inputs,
                     .removed = identify::result::stale_models(folder, document),
                     .json = o.json,
                     .yes_is_required = o.validate.has_value(),
                     .shown_files = shown,
                     .when_written = [&chapters] { chapters.end(); }});
}

void identify_one(const IdentifyOptions& o) {
  Chapters chapters{"identify", 2, "identifying " + o.data.front()};
  const result::Made how = made(o);
  const identify::result::Study study = study_of(o, o.data.front());
  chapters.next("writing the page");
  write(identify::result::answer(study, how), o, chapters);
}

void require_one_open_loop_fit(const IdentifyOptions& o, const std::string& option) {
  if (o.loop == "closed") {
    throw UsageError{option + " is for the open loop only; allowed with --loop open"};
  }
  if (o.method != "continuous") {
    throw UsageError{option + " does not use a grid; allowed with --method continuous"};
  }
  if (o.loss != "squares") {
    throw UsageError{option + " weights each window by least squares; allowed with --loss squares"};
  }
}

/// What is the same for all stands once, what is not is named with its log.
std::string of_all(const std::vector<identify::result::Study>& studies, std::string identify::result::Study::* what) {
  std::string all;
  for (const auto& study : studies) {
    if (study.*what != studies.front().*what) {
      for (const auto& each : studies) {
        all += fmt::format("{}{}: {}", all.empty() ? "" : "; ", each.data, each.*what);
      }
      return all;
    }
  }
  return studies.front().*what;
}

void identify_together(const IdentifyOptions& asked) {
  require_one_open_loop_fit(asked, "--shared");
  IdentifyOptions o = asked;
  o.fit_initial = true;
  std::vector<identify::result::Study> studies;
  std::size_t windows = 0;
  Chapters chapters{"identify", o.data.size() + 1, "identifying " + o.data.front()};
  const result::Made how = made(o);
  for (const std::string& data : o.data) {
    studies.push_back(study_of(o, data));
    chapters.next(studies.size() < o.data.size() ? "identifying " + o.data[studies.size()]
                                                 : "fitting one model to all");
    windows += studies.back().windows.size();
    give_up_if_interrupted();
  }
  if (windows < 2) {
    throw UsageError{"--shared needs two windows or more; give several logs, or --window several times"};
  }
  identify::result::JointFindings result = identify::fit_jointly(studies);
  result.vehicle = of_all(studies, &identify::result::Study::vehicle);
  result.density = of_all(studies, &identify::result::Study::density);
  result.speed = of_all(studies, &identify::result::Study::speed);
  for (const auto& study : studies) {
    for (const std::string& warning : study.warnings) {
      result.warnings.push_back(study.data + ": " + warning);
    }
  }
  if (result.vehicle != studies.front().vehicle) {
    result.warnings.emplace_back("The vehicles differ, but one common damping and torque is fitted.");
  }
  write(identify::result::answer(result, how), o, chapters);
}

void validate_model(const IdentifyOptions& o) {
  require_one_open_loop_fit(o, "--validate");
  const identify::result::KnownModel model = identify::result::read_model(*o.validate);
  Chapters chapters{"identify", 2, "identifying " + o.data.front()};
  const result::Made how = made(o);
  const identify::result::Study studied = study_of(o, o.data.front());
  identify::result::Validation result = identify::validate(
      model, studied, o.fit_initial ? identify::model::Start::fitted : identify::model::Start::measured);
  result.data = studied.data;
  result.vehicle = studied.vehicle;
  result.density = studied.density;
  result.speed = studied.speed;
  result.warnings = studied.warnings;
  if (model.reference_area_m2 != studied.airframe.reference_area_m2) {
    result.warnings.push_back(fmt::format("The model has a reference area of {} m2; it was converted to {} m2.",
                                          input::about(model.reference_area_m2),
                                          input::about(studied.airframe.reference_area_m2)));
  }
  chapters.next("writing the page");
  write(identify::result::answer(result, how), o, chapters);
}

void identify_data(const IdentifyOptions& o) {
  if (o.validate) {
    if (o.data.size() > 1) {
      throw UsageError{"--validate takes one log at a time"};
    }
    validate_model(o);
  } else if (!o.shared.empty()) {
    identify_together(o);
  } else if (o.data.size() == 1) {
    identify_one(o);
  } else {
    throw UsageError{fmt::format(
        "{} logs: name their common values with --shared alpha,beta, or identify each by itself", o.data.size())};
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<IdentifyOptions>();
  add_identify_options(verb, *options);
  verb.examples(
      "Examples:\n"
      "  fantail identify out/tasha3_launch2 --method both\n"
      "                                          a simulated flight, with the published grid and without\n"
      "  fantail identify run7.csv --columns time=t:ms,roll_rate=p:rad/s,canard=fin:deg --save-columns --speed 22 "
      "\\\n"
      "      --inertia 0.00393 --area 5.0265e-5 --elevation 1400 --window 0:5 --window 5:10\n"
      "                                          another logger's tunnel run, two steps, each by itself\n"
      "  fantail identify flight1 flight2 --shared alpha,beta\n"
      "                                          one roll model for several flights of one rocket; do they agree?\n"
      "  fantail identify flight3 --validate out/identify/flight1+flight2\n"
      "                                          does that model hold in another flight?\n"
      "  fantail identify out/tasha3_launch1 --nodes thrust:2,coast:2 --loop closed \\\n"
      "      --plan tasha3_launch1 --json        canards as commanded by the controller, for a script");
  verb.action([options] { identify_data(*options); });
}

const VerbCode code{"identify", fill};

}  // namespace
}  // namespace fantail::tool
