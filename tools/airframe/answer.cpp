// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "airframe/summary.hpp"
#include "json/value.hpp"
#include "page/chart.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

using result::Cell;
using result::Digits;
using text::brief;
using text::fixed;
namespace u = result::units;

Cell value(const std::optional<double>& number) { return number ? Cell{*number} : Cell{}; }
Cell of(const std::optional<model::Estimate>& computed, double model::Estimate::* member) {
  return computed ? Cell{(*computed).*member} : Cell{};
}

using L = Line;
constexpr auto line_fields = result::fields<L>({
    {"what", "number", u::none, 0, &L::what, "what it is"},
    {"unit", "unit", u::none, 0, &L::unit, "unit of all that follows"},
    {"computed", "from shape", u::none, 3, [](const L& l) { return of(l.computed, &model::Estimate::value); },
     "from the shape and the parts; null: the file alone has it"},
    {"low", "low", u::none, 3, [](const L& l) { return of(l.computed, &model::Estimate::low); },
     "lower end of the method's error"},
    {"high", "high", u::none, 3, [](const L& l) { return of(l.computed, &model::Estimate::high); },
     "upper end of it; null: there is none"},
    {"file", "file", u::none, 3, [](const L& l) { return value(l.in_file); }, "in the vehicle's file; null: not there"},
});

Cell computed(const L& l) { return l.computed ? Cell{Digits{fixed(l.computed->value, l.decimals)}} : Cell{}; }
Cell range(const L& l) {
  return l.computed && l.computed->low < l.computed->high ? Cell{Digits{range_text(*l.computed, l.decimals)}} : Cell{};
}
Cell in_file(const L& l) { return l.in_file ? Cell{Digits{brief(*l.in_file, 5)}} : Cell{}; }
/// The same for people: each row has decimals of its own.
constexpr auto read_fields = result::fields<L>({
    {"what", "number", u::none, 0, &L::what, "what it is"},
    {"computed", "from shape", u::none, 0, computed, "as above", result::Worse::neither, nullptr, ""},
    {"range", "range", u::none, 0, range, "as above", result::Worse::neither, nullptr, ""},
    {"file", "file", u::none, 0, in_file, "as above", result::Worse::neither, nullptr, ""},
    {"unit", "unit", u::none, 0, &L::unit, "as above"},
});

constexpr result::Unit per_rad{"_per_rad", "1/rad"};
using P = model::Part;
constexpr auto part_fields = result::fields<P>({
    {"name", "part", u::none, 0, &P::name, "nose, fins or canards"},
    {"slope", "slope", per_rad, 2, &P::slope_per_rad, "slope of its normal force, on the cross-section of the body"},
    {"position", "acts at", u::m, 3, &P::position_m, "from the tip of the nose to where it acts"},
});

std::string name(Stability stability) {
  switch (stability) {
    case Stability::stable: return "stable";
    case Stability::marginal: return "marginal";
    case Stability::unstable: return "unstable";
    case Stability::doubtful: return "doubtful";
    case Stability::unknown: break;
  }
  return "not_judged";
}

result::Answer answer_of(const Summary& summary) {
  return summary.stability == Stability::stable && summary.agrees_with_design.value_or(true) ? result::Answer::yes
         : summary.stability == Stability::unstable                                          ? result::Answer::no
                                                    : result::Answer::undecided;
}

constexpr const char* method =
    "Ranges are the method's error: normal force 10 %, centre of pressure 3 % of its distance from the nose, roll a "
    "factor of two. Errors of the measurements come on top. Valid for small angles, well below the speed of sound.";

}  // namespace

std::vector<result::Listed> listed_fields() {
  return {result::listed("numbers[]", line_fields), result::listed("parts[]", part_fields)};
}

result::Document answer(const sim::Vehicle& vehicle, const Summary& summary, const result::Made& made) {
  using enum result::Readers;
  const sim::Geometry& shape = *vehicle.geometry;
  constexpr int decimals = 8;
  const auto rounded = [](double value) { return json::rounded(value, decimals); };
  const auto& agrees = summary.agrees_with_design;
  return {.kind = "airframe",
          .title = vehicle.name,
          .subtitle = fmt::format("{} m long, {} mm in diameter, {} kg", brief(shape.length_m, 3),
                                  brief(shape.diameter_m * 1000.0, 1), brief(vehicle.mass_kg, 3)),
          .verdict = {.answer = answer_of(summary),
                      .heading = summary.sentence.substr(0, summary.sentence.find(": ")),
                      .sentence = summary.sentence},
          .facts = {{"vehicle", "", vehicle.name},
                    {"length_m", "", rounded(shape.length_m)},
                    {"diameter_m", "", rounded(shape.diameter_m)},
                    {"stability", "", name(summary.stability)},
                    {"agrees_with_design", "", agrees ? json::Value{*agrees} : json::Value{}},
                    {"doubts", "", summary.doubts}},
          .sections = {{"From the side",
                        {result::Drawing{side_view(shape, summary, page::full_page),
                                         side_view(shape, summary, page::half_page),
                                         "To scale. The bar at the centre of pressure is its range."}}},
                       {"Static margin", margin_over_time(vehicle, summary), files},
                       {"Numbers", {result::table({}, summary.lines, read_fields), method}},
                       {"For programs", {result::table("numbers", summary.lines, line_fields)}, programs},
                       {"Normal force",
                        {result::table("parts", summary.build_up.parts, part_fields),
                         "For small angles, on the cross-section of the body."},
                        files},
                       {"Remarks", {result::Sentences{"remarks", summary.remarks}}},
                       {"Assumed", {result::Sentences{"assumed", vehicle.geometry_assumed}}}},
          .made = made,
          .json_decimals = decimals};
}

}  // namespace fantail::airframe
