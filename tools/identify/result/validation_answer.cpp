// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "identify/result/answer.hpp"
#include "identify/result/parts.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using text::brief;
using text::fixed;
using V = Validation;

double rms(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// A model held against a window.
struct Held {
  const model::Record& record;
  const Identification& result;
  output::Uncertain alpha_m2;
  output::Uncertain beta_m;
};
using H = Held;

std::string share_words(double percent) { return fixed(std::floor(100.0 * percent) / 100.0, 2); }  // 99.999 is not all

constexpr auto held_fields = output::fields<H>({
    {"alpha", "damping alpha", u::m2, 4, [](const H& h) { return Cell{h.alpha_m2}; }, "damping"},
    {"beta", "torque constant beta", u::m, 4, [](const H& h) { return Cell{h.beta_m}; }, "canard torque"},
    {"rms_angle_error", "angle error, rms", u::deg, 3,
     [](const H& h) { return Cell{rms(h.record.roll_angle_rad, h.result.simulation.roll_angle_rad)}; },
     "root mean square difference of modelled and measured roll angle"},
    {"rms_rate_error", "rate error, rms", u::deg_s, 2,
     [](const H& h) { return Cell{rms(h.record.roll_rate_rad_s, h.result.simulation.roll_rate_rad_s)}; },
     "the same of the roll rate"},
    {"explained", "variance of the rate explained", u::share, 2,
     [](const H& h) { return Cell{explained_share(h.record, h.result.simulation)}; },
     "share of the variance of the measured roll rate that the model explains", output::Worse::neither, share_words},
});

struct Window {
  const V& of;
  const ValidatedWindow& window;
};
using W = Window;
constexpr auto window_fields = output::fields<W>({
    {"window", "window", u::none, 0, [](const W& w) { return Cell{w.window.window.record.window}; },
     "the window as requested"},
    {"samples", "samples", u::none, 0, [](const W& w) { return Cell{std::uint64_t{w.window.window.record.size()}}; },
     "samples in the window"},
    {"own_alpha_interval", "95 % of its own alpha", u::m2, 4,
     [](const W& w) { return Cell{interval_of(w.window.own, 0)}; }, "95 % interval from a fit to this window alone"},
    {"own_beta_interval", "95 % of its own beta", u::m, 4,
     [](const W& w) { return Cell{interval_of(w.window.own, 1)}; }, "likewise"},
    {"chi_square", "chi-square", u::none, 1, [](const W& w) { return Cell{w.window.agreement.chi_square}; },
     "distance of the model from a fit to this window alone"},
    {"chi_square_limit", "95 % below", u::none, 1, [](const W& w) { return Cell{w.window.agreement.limit}; },
     "correct models are below it in 95 of 100 cases"},
    {"can_tell", "the window can tell", u::none, 0, [](const W& w) { return Cell{w.window.can_tell()}; },
     "whether the window determines alpha and beta"},
    {"holds", "the model holds", u::none, 0,
     [](const W& w) { return w.window.can_tell() ? Cell{w.window.holds()} : Cell{}; },
     "whether the model holds in it; null: the window cannot tell"},
    {"verdict", "verdict", u::none, 0, [](const W& w) { return Cell{verdict(w.of, w.window)}; }, "the same in words"},
});

template <Eigen::Index which>
output::Uncertain known(const V& v) {
  const Constants& c = v.model.constants;
  return {c.value(which), v.model.covariance_is_known ? std::sqrt(c.covariance(which, which)) : 0.0};
}
constexpr auto model_fields = output::fields<V>({
    {"alpha", "damping alpha", u::m2, 4, [](const V& v) { return Cell{known<0>(v)}; }, "damping of the model"},
    {"beta", "torque constant beta", u::m, 4, [](const V& v) { return Cell{known<1>(v)}; },
     "canard torque of the model"},
    {"model_uncertainty_known", "its uncertainty is known", u::none, 0,
     [](const V& v) { return Cell{v.model.covariance_is_known}; },
     "whether its file states its uncertainty; else it is assumed to be exact"},
    {"reference_area", "reference area", u::m2, 7, [](const V& v) { return Cell{v.airframe.reference_area_m2}; },
     "reference area of the log's rocket, which the model is converted to"},
    {"inertia", "roll inertia", kg_m2, 5, [](const V& v) { return Cell{v.airframe.inertia_kg_m2}; }, "roll inertia"},
});

std::string heading(const ValidatedWindow& window) {
  return !window.can_tell() ? "This window cannot decide"
         : window.holds()   ? "The model holds"
                            : "The model does not hold";
}

output::Verdict verdict_of(const V& v) {
  using enum output::Answer;
  const auto all = [&](auto is_so) { return std::ranges::all_of(v.windows, is_so); };
  const bool told = all([](const ValidatedWindow& w) { return w.can_tell(); });
  const bool good = told && all([](const ValidatedWindow& w) { return w.holds(); });
  output::Verdict said{.answer = good   ? yes
                                 : told ? no
                                        : undecided,
                       .heading = good ? "The model holds in all windows" : "The model is not confirmed in all windows",
                       .sentence = ""};
  if (v.windows.size() == 1) {
    said.heading = heading(v.windows.front());
    said.sentence = verdict(v, v.windows.front());
    return said;
  }
  for (const ValidatedWindow& window : v.windows) {
    said.sentence +=
        fmt::format("{}{}: {}.", said.sentence.empty() ? "" : " ", window.window.record.window, heading(window));
  }
  return said;
}

void add_window(output::Document& document, const V& v, const ValidatedWindow& window, std::size_t index) {
  using enum output::Readers;
  const WindowFindings& found = window.window;
  const Identification& known_model = found.results.front();
  const std::string place = fmt::format("windows.{}", index);
  const output::Figures held =
      output::figures(place + ".model", H{found.record, known_model, known<0>(v), known<1>(v)}, held_fields);
  const output::Figures own = output::figures(
      place + ".own", H{found.record, window.own, uncertain(window.own, 0), uncertain(window.own, 1)}, held_fields);
  Blocks blocks{extent(found.record) + "."};
  if (v.windows.size() > 1) {
    blocks.emplace_back(verdict(v, window));
  }
  blocks.emplace_back(output::beside({{"the model", held}, {"by itself", own}}));
  blocks.emplace_back("\u00b1: standard deviation. By itself: alpha and beta are fitted to this window, too.");
  add_motion(blocks, found);
  add_residuals(blocks, found);
  blocks.emplace_back(output::Sentences{place + ".remarks", remarks(found, window.own)});
  document.sections.push_back({"Window " + found.record.window, std::move(blocks)});
  document.sections.push_back(
      {"For programs",
       {output::figures(place, W{v, window}, window_fields), held,
        output::Data{place + ".model.disturbance_deg", list(known_model.model.node_rad, u::deg)}, own,
        output::Data{place + ".own.disturbance_deg", list(window.own.model.node_rad, u::deg)}},
       programs});
  document.spreadsheets.push_back(
      model_table(index == 0 ? "model" : fmt::format("model_{}", index + 1), found.record, known_model));
}

}  // namespace

double explained_share(const model::Record& record, const model::Simulation& simulation) {
  const std::vector<double>& measured = record.roll_rate_rad_s;
  const double mean = std::accumulate(measured.begin(), measured.end(), 0.0) / static_cast<double>(measured.size());
  const double left = rms(measured, simulation.roll_rate_rad_s);
  const double all = rms(measured, std::vector<double>(measured.size(), mean));
  return 1.0 - left * left / (all * all);
}

std::string verdict(const Validation& v, const ValidatedWindow& window) {
  const std::string difference = fmt::format("its alpha and beta differ by up to {} % from a fit to this window alone",
                                             brief(100.0 * window.largest_difference(), 2));
  const std::string figures = fmt::format("chi-square {}; 95 in 100 correct models stay below {}",
                                          fixed(window.agreement.chi_square, 1), fixed(window.agreement.limit, 1));
  if (!window.can_tell()) {
    return fmt::format("This window cannot decide whether the model holds: {}.", window.own.uncertainty->verdict);
  }
  const std::string doubt = v.model.covariance_is_known
                                ? ""
                                : " The file does not state the uncertainty of its model, which was assumed "
                                  "to be exact.";
  if (window.agreement.agree()) {
    return fmt::format("The model holds: {}, no more than noise explains ({}).{}", difference, figures, doubt);
  }
  return fmt::format("The model {}: {}, more than noise explains ({}){}.{}", window.holds() ? "holds" : "does not hold",
                     difference, figures, window.holds() ? ", but too little to matter" : "", doubt);
}

std::vector<output::Listed> listed_validation() {
  return {output::listed("with --validate", model_fields), output::listed("windows[] with --validate", window_fields),
          output::listed("windows[].model, windows[].own", held_fields)};
}

output::Document answer(const V& v, const output::Made& made) {
  output::Document document{.kind = "validation report",
                            .title = v.data,
                            .subtitle = fmt::format("validation of the model of {}{}; {}", v.model.source,
                                                    v.model.how.empty() ? "" : " (" + v.model.how + ")", v.vehicle),
                            .verdict = verdict_of(v),
                            .facts = {{"data", "", v.data},
                                      {"model", "", v.model.source},
                                      {"density", "density", v.density},
                                      {"speed", "speed", v.speed}},
                            .made = made,
                            .json_decimals = json_digits};
  for (std::size_t i = 0; i < v.windows.size(); ++i) {
    add_window(document, v, v.windows[i], i);
  }
  document.sections.push_back({"Remarks", {output::Sentences{"remarks", v.warnings}}});
  document.sections.push_back({"For programs", {output::figures("", v, model_fields)}, output::Readers::programs});
  return document;
}

}  // namespace fantail::identify::result
