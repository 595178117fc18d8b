// SPDX-License-Identifier: MIT
#include "fantail/compare_results.hpp"

#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "text/degrees.hpp"

namespace fantail::tool {
namespace {

using page::Role;
using result::Cell;
using result::Picture;
using text::degrees;
using text::in_degrees;
namespace u = result::units;
using R = CompareResults;

std::string too_large(std::string_view what, double mean_rad, double required_rad, std::string_view unit) {
  return fmt::format("mean {} difference {:.3g} {} is larger than the {:.3g} {} required", what, degrees(mean_rad),
                     unit, degrees(required_rad), unit);
}

/// Differences have any size.
std::string three_digits(double shown) { return fmt::format("{:.3g}", shown); }

template <auto of, auto which>
Cell difference(const R& r) {
  return r.comparison.*of.*which;
}
using C = logs::Comparison;
using D = logs::Difference;
using result::Worse;

constexpr auto comparison_fields = result::fields<R>({
    {"mean_abs_angle_difference", "angle, mean difference", u::deg, 3, difference<&C::angle, &D::mean_abs>,
     "mean absolute difference of the roll angles", Worse::neither, three_digits},
    {"rms_angle_difference", "angle, rms", u::deg, 3, difference<&C::angle, &D::rms>,
     "rms difference of the roll angles", Worse::neither, three_digits},
    {"max_abs_angle_difference", "angle, largest", u::deg, 3, difference<&C::angle, &D::max_abs>, "largest difference",
     Worse::neither, three_digits},
    {"max_angle_difference_at", "at", u::s, 3, difference<&C::angle, &D::max_at_s>, "its time, on A's clock"},
    {"mean_abs_rate_difference", "rate, mean difference", u::deg_s, 3, difference<&C::rate, &D::mean_abs>,
     "mean absolute difference of the roll rates", Worse::neither, three_digits},
    {"rms_rate_difference", "rate, rms", u::deg_s, 3, difference<&C::rate, &D::rms>, "likewise", Worse::neither,
     three_digits},
    {"max_abs_rate_difference", "rate, largest", u::deg_s, 3, difference<&C::rate, &D::max_abs>, "likewise",
     Worse::neither, three_digits},
    {"max_rate_difference_at", "at", u::s, 3, difference<&C::rate, &D::max_at_s>, "likewise"},
    {"samples", "samples", u::none, 0, [](const R& r) { return Cell{std::uint64_t{r.comparison.time_s.size()}}; },
     "samples of A that were compared"},
    {"from", "from", u::s, 3, [](const R& r) { return Cell{r.comparison.time_s.front()}; },
     "first sample compared, on A's clock"},
    {"to", "to", u::s, 3, [](const R& r) { return Cell{r.comparison.time_s.back()}; }, "last sample compared"},
    {"seconds", "length in seconds", u::none, 3,
     [](const R& r) { return Cell{r.comparison.time_s.back() - r.comparison.time_s.front()}; },
     "seconds from the first to the last sample"},
    {"shift", "B's clock at A's zero", u::s, 4, [](const R& r) { return Cell{r.comparison.shift_s}; },
     "reading of B's clock at A's zero"},
    {"offset", "added to B's angles", u::deg, 3, [](const R& r) { return Cell{r.comparison.offset_rad}; },
     "constant added to B's roll angles"},
    {"requirement_met", "requirement met", u::none, 0,
     [](const R& r) { return r.required() ? Cell{r.objections().empty()} : Cell{}; },
     "whether both means are no larger than required; null without a requirement"},
});

struct Sample {
  double time_s;
  double a_angle_rad;
  double b_angle_rad;
  double angle_difference_rad;
  double a_rate_rad_s;
  double b_rate_rad_s;
  double rate_difference_rad_s;
};
constexpr auto sample_fields = result::fields<Sample>({
    {"time", "time", u::s, 3, &Sample::time_s, "time on A's clock"},
    {"a_roll_angle", "roll angle of A", u::deg, 2, &Sample::a_angle_rad, "roll angle of A"},
    {"b_roll_angle", "roll angle of B", u::deg, 2, &Sample::b_angle_rad, "roll angle of B"},
    {"roll_angle_difference", "difference", u::deg, 2, &Sample::angle_difference_rad, "A minus B"},
    {"a_roll_rate", "roll rate of A", u::deg_s, 2, &Sample::a_rate_rad_s, "roll rate of A"},
    {"b_roll_rate", "roll rate of B", u::deg_s, 2, &Sample::b_rate_rad_s, "roll rate of B"},
    {"roll_rate_difference", "difference", u::deg_s, 2, &Sample::rate_difference_rad_s, "A minus B"},
});

result::Table samples(const C& c) {
  std::vector<Sample> all;
  all.reserve(c.time_s.size());
  for (std::size_t i = 0; i < c.time_s.size(); ++i) {
    all.push_back({c.time_s[i], c.a_angle_rad[i], c.b_angle_rad[i], c.angle_difference_rad[i], c.a_rate_rad_s[i],
                   c.b_rate_rad_s[i], c.rate_difference_rad_s[i]});
  }
  return result::table("differences", all, sample_fields);
}

page::Series curve(std::string name, Role role, const std::vector<double>& time_s, std::vector<double> values) {
  return {.name = std::move(name), .role = role, .x = time_s, .y = std::move(values)};
}

Picture over_time(const R& r, std::string_view what, std::string_view unit, double height,
                  std::vector<page::Series> series) {
  return {{.label = fmt::format("{} over time", what),
           .x_label = r.comparison.shift_s == 0.0 ? "time / s" : fmt::format("time of {} / s", r.names.a),
           .y_label = fmt::format("{} / {}", what, unit),
           .height = height,
           .series = std::move(series),
           .x_range = page::Range{r.comparison.time_s.front(), r.comparison.time_s.back()},
           .sampled = true}};
}

constexpr double tall = 280.0, flat = 190.0;

result::Section motion(std::string heading, std::string_view what, std::string_view unit, const R& r,
                       const std::vector<double>& of_a, const std::vector<double>& of_b,
                       const std::vector<double>& difference) {
  const std::vector<double>& time_s = r.comparison.time_s;
  Picture apart = over_time(r, "difference", unit, flat, {curve("", Role::measured, time_s, in_degrees(difference))});
  apart.caption = fmt::format("Difference: {} minus {}.", r.names.a, r.names.b);
  return {std::move(heading),
          {over_time(r, what, unit, tall,
                     {curve(r.names.a, Role::measured, time_s, in_degrees(of_a)),
                      curve(r.names.b, Role::model, time_s, in_degrees(of_b))}),
           std::move(apart)},
          result::Readers::files};
}

/// The means, and the largest, with what stands beside them.
result::Figures figures(const R& r) {
  const result::Figures all = result::figures("", r, comparison_fields);
  result::Figures some = result::only(all, {"mean_abs_angle_difference", "max_abs_angle_difference",
                                            "mean_abs_rate_difference", "max_abs_rate_difference", "samples"});
  some["mean_abs_angle_difference"].remark = fmt::format("rms {} deg", three_digits(degrees(r.comparison.angle.rms)));
  some["mean_abs_rate_difference"].remark = fmt::format("rms {} deg/s", three_digits(degrees(r.comparison.rate.rms)));
  some["max_abs_angle_difference"].remark = fmt::format("at {:.3f} s", r.comparison.angle.max_at_s);
  some["max_abs_rate_difference"].remark = fmt::format("at {:.3f} s", r.comparison.rate.max_at_s);
  some["samples"].remark =
      fmt::format("of {}, {:.3f} s to {:.3f} s", r.names.a, r.comparison.time_s.front(), r.comparison.time_s.back());
  return some;
}

std::string how(const R& r) {
  const C& c = r.comparison;
  std::string text = c.shift_s == 0.0
                         ? "Both logs are compared on their own clocks"
                         : fmt::format("{} shows {:+.4f} s at the zero of {}", r.names.b, c.shift_s, r.names.a);
  text += r.shift_found ? ", which makes the roll rates agree best. " : c.shift_s != 0.0 ? ", as stated. " : ". ";
  if (c.offset_rad != 0.0) {
    text += fmt::format("The roll angles of {} are shifted by {:+.3g} deg, so that both begin at the same angle. ",
                        r.names.b, degrees(c.offset_rad));
  }
  return text +
         fmt::format("For the differences, {} is interpolated linearly at the times of {}. ", r.names.b, r.names.a) +
         "Every sample that was compared is in differences.csv, every figure in compare.json.";
}

result::Verdict verdict_of(const R& r) {
  using enum result::Answer;
  const C& c = r.comparison;
  const std::string apart =
      fmt::format("The roll angles differ by {:.3g} deg on average and {:.3g} deg at most, the rates by {:.3g} deg/s.",
                  degrees(c.angle.mean_abs), degrees(c.angle.max_abs), degrees(c.rate.mean_abs));
  if (!r.required()) {
    return {.answer = none, .heading = "Compared", .sentence = apart};
  }
  std::string objections;
  for (const std::string& objection : r.objections()) {
    objections += (objections.empty() ? " The " : "; the ") + objection;
  }
  return {.answer = objections.empty() ? yes : no,
          .heading = objections.empty() ? "Close enough"
                     : r.is_known()     ? "Too far apart"
                                        : "Too little to compare",
          .sentence =
              apart + (objections.empty() ? " The mean differences are no larger than required." : objections + ".")};
}

struct Quantity {
  std::string_view heading;
  std::string_view what;
  std::string_view unit;
  std::vector<double> logs::RollLog::* values;
  double scale;
};

// A log that does not have the quantity is left out; so is the plot when none has it.
std::optional<result::Section> section_of(const Quantity& quantity, const CompareResults& results,
                                          const logs::RollLog& a, const logs::RollLog& b) {
  const page::Range stretch{results.comparison.time_s.front(), results.comparison.time_s.back()};
  std::vector<page::Series> series;
  const auto add = [&](const std::string& name, Role role, const logs::RollLog& log, double shift_s) {
    page::Series one = curve(name, role, log.time_s, log.*quantity.values);
    bool known = false;
    for (std::size_t i = 0; i < one.y.size(); ++i) {
      one.x[i] -= shift_s;
      one.y[i] *= quantity.scale;
      known = known || (std::isfinite(one.y[i]) && one.x[i] >= stretch.low && one.x[i] <= stretch.high);
    }
    if (known) {
      series.push_back(std::move(one));
    }
  };
  add(results.names.a, Role::measured, a, 0.0);
  add(results.names.b, Role::model, b, results.comparison.shift_s);
  if (series.empty()) {
    return {};
  }
  result::Section section{std::string{quantity.heading}, {}, result::Readers::files};
  const std::string without = series.size() > 1                        ? ""
                              : series.front().name == results.names.a ? results.names.b
                                                                       : results.names.a;
  section.blocks.emplace_back(over_time(results, quantity.what, quantity.unit, tall, std::move(series)));
  if (!without.empty()) {
    section.blocks.emplace_back(without + " does not have this quantity.");
  }
  return section;
}

result::Document document_of(const R& r, const result::Made& made, std::vector<result::Section> more) {
  const C& c = r.comparison;
  result::Document document{
      .verdict = verdict_of(r),
      .facts = {{"a", "first", r.a},
                {"b", "second", r.b},
                {"window", "window", json::text_or_null(r.window)},
                {"version", "", made.version}},
      .sections = {{"Absolute differences", {figures(r)}},
                   motion("Roll angle", "roll angle", "deg", r, c.a_angle_rad, c.b_angle_rad, c.angle_difference_rad),
                   motion("Roll rate", "roll rate", "deg/s", r, c.a_rate_rad_s, c.b_rate_rad_s,
                          c.rate_difference_rad_s)},
      .spreadsheets = {samples(c)},
      .made = made};
  for (result::Section& section : more) {
    document.sections.push_back(std::move(section));
  }
  document.sections.push_back({"How they were compared", {how(r), result::Sentences{"notes", r.warnings}}});
  document.sections.push_back({"For programs", {result::figures("", r, comparison_fields)}, result::Readers::programs});
  return document;
}

}  // namespace

void CompareResults::take_warnings(const logs::RollLog& log_a, const logs::RollLog& log_b) {
  for (const auto& [name, log] : {std::pair{names.a, &log_a}, std::pair{names.b, &log_b}}) {
    for (const std::string& warning : log->warnings) {
      warnings.push_back(fmt::format("{}: {}", name, warning));
    }
  }
  warnings.insert(warnings.end(), comparison.warnings.begin(), comparison.warnings.end());
}

std::vector<std::string> CompareResults::objections() const {
  std::vector<std::string> sentences;
  if (required() && !is_known()) {
    sentences.push_back(fmt::format(
        "time that both logs cover, {:.3f} s of {:.3f} s, is less than the nine tenths that a requirement needs",
        comparison.known_s, comparison.asked_s));
  }
  if (required_angle_rad && comparison.angle.mean_abs > *required_angle_rad) {
    sentences.push_back(too_large("angle", comparison.angle.mean_abs, *required_angle_rad, "deg"));
  }
  if (required_rate_rad_s && comparison.rate.mean_abs > *required_rate_rad_s) {
    sentences.push_back(too_large("rate", comparison.rate.mean_abs, *required_rate_rad_s, "deg/s"));
  }
  return sentences;
}

std::vector<result::Listed> listed_comparison() {
  return {result::listed("", comparison_fields), result::listed("differences.csv", sample_fields)};
}

result::Document comparison(const CompareResults& results, const result::Made& made) {
  result::Document document = document_of(results, made, {});
  document.kind = "comparison of two logs";
  document.title = fmt::format("{} against {}", results.names.a, results.names.b);
  return document;
}

result::Document overlay(const CompareResults& results, const logs::RollLog& a, const logs::RollLog& b,
                         const result::Made& made) {
  std::vector<result::Section> more;
  for (const Quantity& quantity :
       {Quantity{"Roll command", "roll command", "deg", &logs::RollLog::command_rad, degrees(1.0)},
        Quantity{"Canards", "mean of the encoders", "deg", &logs::RollLog::canard_rad, degrees(1.0)},
        Quantity{"Speed, as the avionics estimated it", "speed", "m/s", &logs::RollLog::speed_m_s, 1.0},
        Quantity{"Height", "height", "m", &logs::RollLog::height_m, 1.0}}) {
    if (auto section = section_of(quantity, results, a, b)) {
      more.push_back(std::move(*section));
    }
  }
  result::Document document = document_of(results, made, std::move(more));
  document.kind = "report of two flights";
  document.title = fmt::format("{} and {}", results.names.a, results.names.b);
  return document;
}

}  // namespace fantail::tool
