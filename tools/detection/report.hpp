// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "detection/campaign.hpp"
#include "distributions/shares.hpp"
#include "page/chart.hpp"
#include "result/answer.hpp"
#include "result/document.hpp"
#include "text/layout.hpp"

namespace fantail::detection {

using distributions::upper_bound_95;

struct Report {
  Campaign campaign;
  Results results;
  result::Made made{};
  std::optional<double> at_most{};        ///< missed launches of a judged rule, a share: asked of its 95 % bound
  std::optional<double> false_at_most{};  ///< false actuations of a judged rule, likewise; empty: none may be seen
};

/// A rule's counts over some kinds and conditions.
struct Sum {
  std::uint64_t events = 0;
  std::uint64_t detected = 0;
  std::uint64_t controlling = 0;
};

/// Of all events that are no launches, in every condition.
[[nodiscard]] Sum events_of(const Results& results, std::size_t rule);
/// Of these, both accelerometers well, and all others.
[[nodiscard]] Sum well_events_of(const Results& results, std::size_t rule);
[[nodiscard]] Sum bad_events_of(const Results& results, std::size_t rule);
/// Of all launches with both accelerometers well.
[[nodiscard]] Sum launches_of(const Results& results, std::size_t rule);
/// Of one kind, all conditions but `well`.
[[nodiscard]] Sum one_bad_of(const Tally& tally, std::size_t rule);

/// Of the kinds that are no launch, both accelerometers well, the one whose bound is the largest; of equals the one
/// that came nearest to the gate. Empty: fewer than two kinds were played.
[[nodiscard]] std::optional<Kind> worst_kind_of(const Report& report, std::size_t rule);

enum class Verdict : std::uint8_t { met, not_met, not_judged };
[[nodiscard]] const char* name(Verdict verdict);

/// What is asked of a judged rule. Both accelerometers are well in everything that is judged.
struct Requirement {
  Verdict verdict = Verdict::not_judged;
  std::string sentence{};
};
/// Of each judged rule that it moves no canard in an event that is no launch, and, where at_most says so, that it
/// misses no more launches. What was not played is not judged.
[[nodiscard]] std::vector<Requirement> requirements(const Report& report);
/// Not met when one is not; met when any is; else not judged.
[[nodiscard]] Verdict verdict(const std::vector<Requirement>& requirements);
/// Undecided: not judged.
[[nodiscard]] result::Answer answer_of(Verdict verdict);
/// The verdict in words, with the counts behind it.
[[nodiscard]] std::string what_was_judged(const Report& report, Verdict verdict);
/// The sentences of those that are not met.
[[nodiscard]] std::vector<std::string> failures(const Report& report);
/// What a judged rule does with one accelerometer bad, which nobody asks of it: a sentence for each that has moved a
/// canard, with the reason.
[[nodiscard]] std::vector<std::string> known_limits(const Report& report);

/// Is there going to be anything that at_most can be asked of, and false_at_most?
[[nodiscard]] bool judges_launches(const Campaign& campaign);
[[nodiscard]] bool judges_events(const Campaign& campaign);

// What each rule made of it.

/// Of each kind that is no launch, the bad accelerometers together, and each condition by itself.
[[nodiscard]] result::Table events_table(const Report& report, std::size_t rule);
[[nodiscard]] result::Table events_by_condition(const Report& report, std::size_t rule);
/// Of flights that come down: how many were none, and in which part control started.
[[nodiscard]] std::vector<std::string> about_flights(const Report& report, std::size_t rule);
[[nodiscard]] result::Table launches_table(const Report& report, std::size_t rule);
/// With which thrust, or after how long a rest, it misses them or is late.
[[nodiscard]] std::vector<std::string> about_launches(const Report& report, std::size_t rule);
/// All of a rule in one line, for scripts too.
[[nodiscard]] std::vector<std::string> sum_lines(const Report& report);
/// What was drawn.
[[nodiscard]] result::Table models(const Report& report);
/// Of all rules beside each other, the launches of one kind.
[[nodiscard]] std::vector<result::Block> distributions(const Report& report, Kind kind);
/// False actuations with both accelerometers well as an SVG: a row for each kind of event and in it a bar for each
/// rule, up to the 95 % bound of their share, with a dot at what was counted. On a scale of decades, so that none of
/// ten thousand and none of ten million look different. Empty without events. `width` as in page::Chart.
[[nodiscard]] std::string bounds_svg(const Report& report, double width);

/// All of it, for every output. Events that a command can show again are named by it.
[[nodiscard]] result::Document answer(const Report& report);
[[nodiscard]] std::vector<result::Listed> listed_fields();

/// "fantail campaign detection --kind shaking --event 12", with seed and plans where they are not the usual ones.
[[nodiscard]] std::string command_of(const Campaign& campaign, Kind kind, std::uint64_t event);

/// The 95 % bound of the share of `count` among `of`, which are at least one: "at most 0.0031 %".
[[nodiscard]] std::string bound_text(std::uint64_t count, std::uint64_t of);

/// A number of events as "0 (at most 0.0031 %)", with the 95 % bound of their share.
[[nodiscard]] std::string with_bound(std::uint64_t count, std::uint64_t of);

/// Of the rules, in their order, in every figure.
inline constexpr std::array<page::Role, 4> roles{page::Role::measured, page::Role::model, page::Role::second_model,
                                                 page::Role::target};

/// One event of a campaign again, tick by tick.
struct ShownEvent {
  std::string verdict{};  ///< in a sentence: who moves canards, or who detects
  bool is_bad = false;    ///< a judged rule moves a canard without a launch, or misses one with both well
  std::vector<std::string> sentences{};  ///< what happens in it and what each rule makes of it
  std::vector<result::Picture>
      pictures{};  ///< what the accelerometers read, and the speed and distance that each rule estimated
};
[[nodiscard]] ShownEvent show_event(const Campaign& campaign, Kind kind, std::uint64_t event);
[[nodiscard]] result::Document event_answer(const Campaign& campaign, Kind kind, std::uint64_t event,
                                            const result::Made& made);

/// Of the events that are no launch the one that came nearest to moving a canard of the rule; empty: none came near.
[[nodiscard]] std::optional<result::Section> worst_event(const Report& report, std::size_t rule);

}  // namespace fantail::detection
