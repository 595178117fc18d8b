// SPDX-License-Identifier: MIT
#include "tunnel/stability.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::tunnel {
namespace {

using text::fixed;

constexpr double gravity_m_s2 = 9.80665;

std::optional<StiffnessLine> line_through(const std::vector<StabilitySwing>& swings) {
  // Weighted least squares; sums of weight, x, y and their products.
  double w = 0.0;
  double wx = 0.0;
  double wy = 0.0;
  double wxx = 0.0;
  double wxy = 0.0;
  std::size_t count = 0;
  double least = 0.0;
  double most = 0.0;
  for (const StabilitySwing& swing : swings) {
    if (!swing.result.swing || swing.speed_m_s <= 0.0) {
      continue;
    }
    const Estimate& y = swing.result.swing->stiffness_per_s2;
    const double weight = 1.0 / std::max(y.deviation * y.deviation, 1e-12);
    const double x = swing.speed_m_s * swing.speed_m_s;
    least = count == 0 ? x : std::min(least, x);
    most = std::max(most, x);
    w += weight;
    wx += weight * x;
    wy += weight * y.value;
    wxx += weight * x * x;
    wxy += weight * x * y.value;
    ++count;
  }
  // Speeds that differ by less than a tenth are one.
  if (count < 2 || most < 1.21 * least) {
    return std::nullopt;
  }
  const double determinant = w * wxx - wx * wx;
  StiffnessLine line{.slope_per_m2 = {(w * wxy - wx * wy) / determinant, std::sqrt(w / determinant)},
                     .intercept_per_s2 = {(wxx * wy - wx * wxy) / determinant, std::sqrt(wxx / determinant)}};
  if (count > 2) {
    double chi_square = 0.0;
    for (const StabilitySwing& swing : swings) {
      if (const auto& found = swing.result.swing) {
        const Estimate& y = found->stiffness_per_s2;
        const double off =
            y.value - line.intercept_per_s2.value - line.slope_per_m2.value * swing.speed_m_s * swing.speed_m_s;
        chi_square += off * off / std::max(y.deviation * y.deviation, 1e-12);
      }
    }
    line.chi_square = chi_square;
    // Points that scatter more than their deviations say make the line less certain, never more.
    const double widening = std::sqrt(std::max(1.0, chi_square / static_cast<double>(count - 2)));
    line.slope_per_m2.deviation *= widening;
    line.intercept_per_s2.deviation *= widening;
  }
  return line;
}

/// As far as one can see.
double largest(const Unsteadiness& air) { return std::max(air.share, air.rounding_share); }

double largest_angle_rad(const Stability& s) {
  double largest_rad = 0.0;
  for (const StabilitySwing& swing : s.swings) {
    largest_rad = std::max(largest_rad, swing.result.swing ? swing.result.swing->largest_rad : 0.0);
  }
  return largest_rad;
}

/// The body's own lift grows with the square of the angle. Over a swing it acts as a linear one of 8 / (3 pi) times the
/// largest angle would.
double taken_by_body_lift_m(const Stability& s, const PitchAirframe& a) {
  return std::max(0.0, 8.0 / (3.0 * std::numbers::pi) * largest_angle_rad(s) * a.body_lift_area_m2 * a.body_lift_arm_m /
                           (a.cross_section_m2 * a.normal_force_slope_per_rad));
}

/// `more_m`: by which the truth may be larger beside.
std::string interval_mm(const Estimate& e, double more_m = 0.0) {
  return fmt::format("{} mm (95 %: {} to {})", fixed(1e3 * e.value, 0),
                     fixed(1e3 * (e.value - reach_95 * e.deviation), 0),
                     fixed(1e3 * (e.value + reach_95 * e.deviation + more_m), 0));
}

/// What strings and pins do to the margin if it is all the pins': the least that the rocket's own margin can be, and
/// the largest.
struct OwnMargin {
  double least_m = 0.0;
  double most_m = 0.0;
};
OwnMargin own_margin(const Stability& s, const PitchAirframe& airframe) {
  const double weight_n = airframe.mass_kg * gravity_m_s2;
  const Estimate& held = *s.without_wind_n_m_per_rad;
  const double least_offset_m = (held.value - reach_95 * held.deviation) / weight_n;
  const double most_offset_m = (held.value + reach_95 * held.deviation) / weight_n;
  const Estimate& margin = *s.margin_m;
  return {
      .least_m = margin.value - reach_95 * margin.deviation - std::max(0.0, most_offset_m),
      .most_m = margin.value + reach_95 * margin.deviation + s.taken_by_body_lift_m - std::min(0.0, least_offset_m)};
}

void judge(Stability& s, const PitchAirframe& airframe) {
  const auto grown = std::ranges::find_if(s.swings, [](const auto& swing) { return swing.result.grows; });
  if (grown != s.swings.end()) {
    s.verdict = StabilityVerdict::unstable;
    s.sentence = fmt::format("Unstable: at {} m/s, before or from {} s on, {}.", fixed(grown->speed_m_s, 1),
                             fixed(grown->result.stretch.begin_s, 1), grown->result.reason);
    return;
  }
  if (!s.margin_m) {
    const bool any = std::ranges::any_of(s.swings, [](const auto& swing) { return swing.result.swing.has_value(); });
    s.sentence = any ? "Not judged: the swings that can be fitted are at one speed only."
                     : "Not judged: no swing can be fitted.";
    for (const StabilitySwing& swing : s.swings) {
      if (swing.result.is_too_large) {
        s.sentence = fmt::format(
            "Not judged: from {} s on ({} m/s) the rocket swings as far as its tether or the wall. If nobody pushed "
            "it that far, it is unstable.",
            fixed(swing.result.stretch.begin_s, 1), fixed(swing.speed_m_s, 1));
        break;
      }
    }
    return;
  }
  const Estimate& margin = *s.margin_m;
  const std::string calibres = fixed(margin.value / airframe.diameter_m, 1);
  const OwnMargin own = own_margin(s, airframe);
  if (margin.value - reach_95 * margin.deviation > 0.0 && own.least_m <= 0.0) {
    s.sentence = fmt::format(
        "Not judged: it is stable on its pins, {} in front of the centre of pressure. The stiffness without wind may "
        "come from pins in front of its centre of gravity, and then its own margin may be {} mm.",
        interval_mm(margin, s.taken_by_body_lift_m), fixed(1e3 * own.least_m, 0));
  } else if (margin.value - reach_95 * margin.deviation > 0.0) {
    s.verdict = StabilityVerdict::stable;
    s.sentence = fmt::format("Stable: the centre of pressure is {} behind the pins, {} calibres.",
                             interval_mm(margin, s.taken_by_body_lift_m), calibres);
  } else if (own.most_m < 0.0) {
    s.verdict = StabilityVerdict::unstable;
    s.sentence = fmt::format(
        "Unstable: the centre of pressure is in front of the pins by {}. The rocket swings only because strings or "
        "pins hold it without wind.",
        interval_mm({-margin.value, margin.deviation}));
  } else {
    s.sentence = fmt::format("Not judged: the margin is {}, so the rocket may be stable or unstable.",
                             interval_mm(margin, s.taken_by_body_lift_m));
  }
}

/// What nobody can tell from one speed.
std::string remark_on_one_speed(const StabilitySwing& swing, const PitchAirframe& airframe) {
  constexpr double clamp_error_m = 0.005;
  const double stiffness_n_m = airframe.transverse_inertia_kg_m2 * swing.result.swing->stiffness_per_s2.value;
  return fmt::format(
      "One speed is not enough: strings and clamps hold the rocket, too. Pins 5 mm off the centre of gravity alone "
      "make {} % of the stiffness at {} m/s. Swing at three speeds or more.",
      fixed(100.0 * airframe.mass_kg * gravity_m_s2 * clamp_error_m / stiffness_n_m, 0), fixed(swing.speed_m_s, 1));
}

void remark_on_angles(Stability& s) {
  constexpr double least_m = 0.001;
  if (s.taken_by_body_lift_m > least_m) {
    s.remarks.push_back(fmt::format(
        "The lift of the body reduces the margin at large angles. At the largest of these, {} degrees, it takes {} "
        "mm by the vehicle's data. The interval is extended upwards by that much; push less to make it narrow.",
        fixed(text::degrees(largest_angle_rad(s)), 1), fixed(1e3 * s.taken_by_body_lift_m, 0)));
  }
}

/// Up to this turbulence simulated margins of 120 mm were off by 2 mm at most.
constexpr double matters_little = 0.01;

std::string remark_on_turbulence(const std::vector<StabilitySwing>& swings) {
  constexpr const char* simulated =
      "Eight sessions were simulated for each turbulence, with pushes of a degree and a margin of 120 mm. The margin "
      "was off by up to 2 mm with 1 % of turbulence, 8 mm with 2 % and 23 mm with 5 %. In the last case most "
      "intervals missed the true value.";
  std::optional<Unsteadiness> worst;
  for (const StabilitySwing& swing : swings) {
    if (!swing.result.swing) {
      continue;
    }
    if (!swing.air) {
      return fmt::format(
          "Turbulence pushes the rocket, too, and no interval includes it. The turbulence at {} m/s is unknown: a "
          "tunnel.csv with five or more readings of steady wind would show it. {}",
          fixed(swing.speed_m_s, 1), simulated);
    }
    worst = worst && largest(*worst) >= largest(*swing.air) ? worst : swing.air;
  }
  const double share = largest(*worst);
  return fmt::format(
      "{} {} % (standard deviation): {}. {}",
      worst->share >= worst->rounding_share ? "The wind speed varied by up to"
                                            : "The wind speed varied by less than the rounding of its sensor,",
      fixed(100.0 * share, 1),
      share < matters_little ? "too little to matter much, but no interval includes it"
                             : "this turbulence pushes the rocket and is not in the intervals, which are too narrow",
      simulated);
}

void remark(Stability& s, const PitchAirframe& airframe) {
  remark_on_angles(s);
  for (const StabilitySwing& swing : s.swings) {
    if (!swing.result.swing && !swing.result.grows) {
      s.remarks.push_back(fmt::format("The swing from {} s on ({} m/s) is left out: {}.",
                                      fixed(swing.result.stretch.begin_s, 1), fixed(swing.speed_m_s, 1),
                                      swing.result.reason));
    }
  }
  if (!s.line) {
    for (const StabilitySwing& swing : s.swings) {
      if (swing.result.swing) {
        s.remarks.push_back(remark_on_one_speed(swing, airframe));
        break;
      }
    }
    return;
  }
  const Estimate& held = *s.without_wind_n_m_per_rad;
  s.remarks.push_back(
      fmt::format("Without wind, a stiffness of {} ± {} N m/rad (95 %) holds the rocket. It comes from strings, or "
                  "from pins {} mm in front of its centre of gravity. If only the pins cause it, the margin from the "
                  "centre of gravity is smaller by that distance.",
                  fixed(held.value, 3), fixed(reach_95 * held.deviation, 3),
                  fixed(1e3 * held.value / (airframe.mass_kg * gravity_m_s2), 1)));
  s.remarks.emplace_back(
      "The interval includes only the errors of the swings. Each percent that the inertia is too large adds one "
      "percent to the margin; each percent that the normal force slope is too large takes one off.");
  s.remarks.push_back(remark_on_turbulence(s.swings));
  if (s.line->chi_square && *s.line->chi_square > 9.0 * static_cast<double>(s.swings.size() - 2)) {
    s.remarks.push_back(fmt::format(
        "The points lie farther from the line than their errors allow (chi-square {}). Something changed between the "
        "swings, or they are too large for a moment in proportion to the angle. The interval is wider for that reason.",
        fixed(*s.line->chi_square, 1)));
  }
}

}  // namespace

Stability examine_stability(std::vector<StabilitySwing> swings, const PitchAirframe& airframe, double density_kg_m3) {
  Stability s{.swings = std::move(swings)};
  s.line = line_through(s.swings);
  if (s.line) {
    const double per_slope = 2.0 * airframe.transverse_inertia_kg_m2 /
                             (density_kg_m3 * airframe.cross_section_m2 * airframe.normal_force_slope_per_rad);
    s.margin_m = Estimate{per_slope * s.line->slope_per_m2.value, per_slope * s.line->slope_per_m2.deviation};
    s.without_wind_n_m_per_rad = Estimate{airframe.transverse_inertia_kg_m2 * s.line->intercept_per_s2.value,
                                          airframe.transverse_inertia_kg_m2 * s.line->intercept_per_s2.deviation};
  }
  s.taken_by_body_lift_m = taken_by_body_lift_m(s, airframe);
  judge(s, airframe);
  remark(s, airframe);
  return s;
}

}  // namespace fantail::tunnel
