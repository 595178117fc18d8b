// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "campaign/landing.hpp"
#include "page/map.hpp"
#include "text/bearing.hpp"
#include "text/number.hpp"

namespace fantail::campaign {
namespace {

using page::Mark;
using page::Role;
using result::Cell;
namespace u = result::units;

page::Series series(std::string name, Role role, Mark mark, const std::vector<OverGround>& places) {
  page::Series one{.name = std::move(name), .role = role, .mark = mark};
  for (const OverGround& at : places) {
    one.x.push_back(at.east_m);
    one.y.push_back(at.north_m);
  }
  return one;
}

using L = Landings;
Cell of_ellipse(const L& l, double Ellipse::* member, double factor = 1.0) {
  return l.ellipse ? Cell{factor * (*l.ellipse).*member} : Cell{};
}

constexpr auto landing_fields = result::fields<L>({
    {"runs", "runs flown to the ground", u::none, 0, &L::runs,
     "the first of the runs; 0: without a parachute, or not in six degrees of freedom"},
    {"landed", "of these under the parachute", u::none, 0,
     [](const L& l) { return Cell{std::uint64_t{l.landed.size()}}; }, "how many landed under it"},
    {"centre_east", "centre of the ellipse, to the east", u::m, 0,
     [](const L& l) { return l.ellipse ? Cell{l.ellipse->centre.east_m} : Cell{}; },
     "mean landing, from the foot of the guide; null: fewer than ten landings"},
    {"centre_north", "centre of the ellipse, to the north", u::m, 0,
     [](const L& l) { return l.ellipse ? Cell{l.ellipse->centre.north_m} : Cell{}; }, "likewise"},
    {"length", "length of the ellipse", u::m, 0, [](const L& l) { return of_ellipse(l, &Ellipse::half_length_m, 2.0); },
     "of the area in which one more landing lies with 95 % probability, if landings are normally distributed"},
    {"width", "width of the ellipse", u::m, 0, [](const L& l) { return of_ellipse(l, &Ellipse::half_width_m, 2.0); },
     "likewise"},
    {"bearing", "direction of its length", u::deg, 0, [](const L& l) { return of_ellipse(l, &Ellipse::bearing_rad); },
     "from north over east"},
    {"inside", "landings inside it", u::none, 0,
     [](const L& l) { return l.ellipse ? Cell{std::uint64_t{l.inside}} : Cell{}; },
     "how many of these landings lie in it"},
    {"failed_canard", "a failed canard adds", u::m, 0, &L::failed_away_m,
     "largest distance between the landing of the scenario as it stands and the same with one canard at a stop; null: "
     "not known"},
});

std::string with_a_failed_canard(const Landings& of) {
  if (!of.why_no_failed.empty()) {
    return fmt::format("What a failed canard adds is not known: {}.", of.why_no_failed);
  }
  if (!of.failed_away_m) {
    return "What a failed canard adds is not known: none of the flights with one landed under the parachute, or the "
           "scenario itself did not.";
  }
  return fmt::format(
      "A canard that runs to a stop moves the landing of the scenario as it stands by up to {} m. That is the largest "
      "of {}: each canard, each stop, every {} s of the ascent. A failure between two of these instants can move it "
      "farther.{}{}",
      text::fixed(*of.failed_away_m, 0), text::counted(of.failed_flights, "flight"), text::brief(of.failed_step_s, 2),
      of.ellipse ? " The outer line lies that far outside the ellipse." : "",
      of.failed_without_landing == 0
          ? std::string{}
          : fmt::format(" {} of these flights did not land under the parachute and are not in it.",
                        of.failed_without_landing));
}

}  // namespace

page::Chart landing_map(const Landings& of) {
  constexpr double width = 640.0;
  page::Chart map{.label = "Where the runs land, seen from above",
                  .x_label = "to the east / m",
                  .y_label = "to the north / m",
                  .width = width,
                  .height = width + 45.0};  // for the legend and the ticks: the frame is about square
  if (of.ellipse && of.failed_away_m) {
    map.series.push_back(series("the ellipse and what a failed canard adds", Role::limit, Mark::line,
                                of.ellipse->line(*of.failed_away_m)));
  }
  if (of.ellipse) {
    map.series.push_back(
        series("95 % of landings, if normally distributed", Role::model, Mark::line, of.ellipse->line()));
  }
  map.series.push_back(series("runs", Role::measured, Mark::points, of.landed));
  if (of.healthy) {
    map.series.push_back(series("scenario as it stands", Role::second_model, Mark::ring, {*of.healthy}));
  }
  map.series.push_back(series("launch guide", Role::reference, Mark::cross, {OverGround{}}));
  std::erase_if(map.series, [](const page::Series& one) { return one.x.empty(); });
  page::give_one_scale(map);
  return map;
}

std::vector<std::string> landing_sentences(const Landings& of) {
  std::vector<std::string> all;
  const std::string flown =
      of.runs == 1 && of.landed.size() == 1 ? "The first run lands under the parachute"
      : of.landed.size() == of.runs
          ? fmt::format("All of the first {} land under the parachute", text::counted(of.runs, "run"))
          : fmt::format(
                "{} of the first {} land under the parachute; the others fall, and where is "
                "not computed",
                of.landed.size(), text::counted(of.runs, "run"));
  if (of.ellipse) {
    const OverGround& at = of.ellipse->centre;
    all.push_back(fmt::format(
        "{}, on average {} m from the launch guide, at a bearing of {} deg. The ellipse is {} m long, along {} deg, "
        "and {} "
        "m wide. If landings are normally distributed, one more lies in it with 95 % probability; {} of these {} do.",
        flown, text::fixed(std::hypot(at.east_m, at.north_m), 0), text::bearing_deg(std::atan2(at.east_m, at.north_m)),
        text::fixed(2.0 * of.ellipse->half_length_m, 0), text::bearing_deg(of.ellipse->bearing_rad),
        text::fixed(2.0 * of.ellipse->half_width_m, 0), of.inside, of.landed.size()));
  } else {
    all.push_back(fmt::format("{}. At least {} landings make an ellipse.", flown, fewest_landings));
  }
  all.push_back(with_a_failed_canard(of));
  all.emplace_back(
      "Each run has the wind, guide and parachute that its spreads draw in place of the scenario's own, which the "
      "scenario "
      "as it stands has. A parachute that opens late or not at all, and a fall in parts, are not in this map.");
  return all;
}

result::Figures landing_figures(const Landings& of) { return result::figures("landing", of, landing_fields); }

result::Listed listed_landing() { return result::listed("landing", landing_fields); }

}  // namespace fantail::campaign
