// SPDX-License-Identifier: MIT
#include "predict/decision.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "predict/advice.hpp"
#include "predict/criteria.hpp"
#include "stability/canard_sense.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {
namespace {

// Advice aims at it, or at what is asked for where that is more.
using stability::comfortable_phase_margin_rad;

struct TriedGains {
  GainAdvice gains{};
  Trial trial{};
};

/// The first that costs no runs which would hold: for a comfortable margin, or for the one that is asked for; by both
/// gains, or by the derivative gain alone, because a smaller proportional gain settles further from the reference.
TriedGains try_gains(const Prediction& p, const LimitAdvice& limit, double asked_rad, const Look& look) {
  std::vector<double> aims_rad{std::max(comfortable_phase_margin_rad, asked_rad)};
  if (asked_rad < comfortable_phase_margin_rad) {
    aims_rad.push_back(asked_rad);
  }
  std::optional<TriedGains> first;
  for (const auto search : {stability::Search::both_gains, stability::Search::derivative_gain}) {
    for (const double aim_rad : aims_rad) {
      const GainAdvice gains = advice_on_gains(p, aim_rad, search);
      TriedGains tried{.gains = gains, .trial = trial(p, limit, gains, look)};
      if (tried.gains.gains && tried.trial.helps) {
        return tried;
      }
      if (!first) {
        first = std::move(tried);
      }
    }
  }
  return first.value();
}

/// Against what the first advice leaves of it, which is the limit, or the gains, that were tried.
std::vector<std::string> more_on_offset(const Decision& d, const Prediction& p, const LimitAdvice& limit,
                                        const TriedGains& tried, const Look& look) {
  const bool is_enough =
      tried.trial.helps && tried.trial.held.of > 0 && tried.trial.held.value >= d.thresholds.held_share;
  const bool rests_off = std::ranges::count(p.runs, report::Outcome::off_command, &Run::outcome) > 0;
  if (is_enough || (limit.sentence.empty() && !rests_off) || !stability::why_uncontrollable(p.flown).empty()) {
    return {};
  }
  const bool more = tried.trial.helps && (limit.limit_deg || tried.gains.gains);
  return advice_on_offset(p, more ? with_advice(p, limit, tried.gains) : p.flown, more,
                          {.held_share = d.thresholds.held_share, .phase_margin_rad = d.thresholds.phase_margin_rad},
                          look);
}

std::vector<std::string> advice(const Decision& d, const Prediction& p, const Look& look) {
  LimitAdvice limit;
  bool loop_swings = false;
  bool is_held_not_met = false;
  std::string tilt;
  std::string wind;
  for (const Criterion& c : d.criteria) {
    const bool too_few = (c.key == "authority" && too_few_runs(p.authority, d.thresholds.authority_share)) ||
                         (c.key == "held" && too_few_runs(p.held, d.thresholds.held_share));
    if (c.judgement != Judgement::not_met && !too_few) {
      continue;
    }
    if (c.key == "authority" && !too_few) {
      limit = advice_on_canard_limit(p, d.thresholds.authority_share);
    } else if (c.key == "phase_margin" && p.worst_speed) {
      loop_swings = true;
    } else if (c.key == "tilt_limit") {
      tilt = advice_on_tilt(p);
    } else if (c.key == "held") {
      is_held_not_met = true;
      wind = advice_on_wind(p, look);
    }
  }
  const TriedGains tried = loop_swings ? try_gains(p, limit, d.thresholds.phase_margin_rad, look)
                                       : TriedGains{.trial = trial(p, limit, {}, look)};
  std::vector<std::string> all{limit.sentence, tried.gains.sentence, tried.trial.sentence};
  if (is_held_not_met || !limit.sentence.empty()) {
    std::ranges::move(more_on_offset(d, p, limit, tried, look), std::back_inserter(all));
  }
  all.insert(all.end(), {tilt, wind});
  std::erase(all, "");
  return all;
}

/// A launch that is outside the model comes first, then what is not met, then what too few runs leave open.
std::string joined(const std::vector<Criterion>& criteria, bool met) {
  std::vector<std::string> clauses;
  std::vector<std::string> open;
  for (const Criterion& c : criteria) {
    if ((c.judgement == Judgement::met) == met && !c.clause.empty()) {
      (c.judgement == Judgement::not_judged && c.key != "model" ? open : clauses).push_back(c.clause);
    }
  }
  std::ranges::move(open, std::back_inserter(clauses));
  return as_sentences(clauses);
}

}  // namespace

Decision decide(const Prediction& prediction, const Thresholds& thresholds, const Look& look) {
  Decision d{.thresholds = thresholds};
  d.criteria = {authority(prediction, thresholds.authority_share), held(prediction, thresholds.held_share),
                phase_margin(prediction, thresholds.phase_margin_rad)};
  if (const auto opens = gate(prediction, thresholds.held_share)) {
    d.criteria.push_back(*opens);
  }
  if (const auto guide = beyond_guide(prediction)) {
    d.criteria.push_back(*guide);
  }
  if (const auto tilt = tilt_limit(prediction)) {
    d.criteria.push_back(*tilt);
  }
  const auto model = within_model(prediction);
  const bool is_caution = model && d.criteria[1].judgement == Judgement::met && is_outside_by_wind_alone(prediction);
  if (model && !is_caution) {
    d.criteria.insert(d.criteria.begin(), *model);
  }
  d.go = std::ranges::all_of(d.criteria, [](const Criterion& c) { return c.judgement == Judgement::met; });
  if (d.go) {
    d.cautions = {is_caution ? model->clause : "", wind_caution(prediction.flown), tilt_caution(prediction),
                  stability_caution(prediction), resonance_caution(prediction)};
    std::erase(d.cautions, "");
  }
  d.text = fmt::format("{}: {}.", d.heading(), joined(d.criteria, d.go));
  for (const std::string& caution : d.cautions) {
    d.text += fmt::format(" Caution: {}.", caution);
  }
  for (const std::string& missing : {missing_spread(prediction), spread_not_drawn(prediction)}) {
    d.text += missing.empty() ? "" : " " + missing;
  }
  d.advice = advice(d, prediction, look);
  return d;
}

}  // namespace fantail::predict
