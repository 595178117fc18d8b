// SPDX-License-Identifier: MIT
#include "report/verdict.hpp"

namespace fantail::report {

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::held: return "held";
    case Outcome::off_command: return "off_command";
    case Outcome::outside_model: return "outside_model";
    case Outcome::not_held: return "not_held";
    case Outcome::oscillates: return "oscillates";
    case Outcome::cut_short: return "cut_short";
    case Outcome::not_judged: return "not_judged";
    case Outcome::no_control: return "no_control";
    case Outcome::ascent_failed: return "ascent_failed";
  }
  return "unknown";
}

std::string_view display_name(Outcome outcome) {
  switch (outcome) {
    case Outcome::held: return "Held";
    case Outcome::off_command: return "Steady, off the command";
    case Outcome::outside_model: return "Outside the model";
    case Outcome::not_held: return "Not held";
    case Outcome::oscillates: return "Oscillates";
    case Outcome::cut_short: return "Cut short";
    case Outcome::not_judged: return "Not judged";
    case Outcome::no_control: return "No control";
    case Outcome::ascent_failed: return "Ascent failed";
  }
  return "Unknown";
}

result::Answer answer(const Verdict& verdict) {
  switch (verdict.outcome) {
    case Outcome::held: return result::Answer::yes;
    case Outcome::outside_model:
    case Outcome::not_judged: return result::Answer::undecided;
    case Outcome::no_control: return verdict.as_planned ? result::Answer::undecided : result::Answer::no;
    case Outcome::cut_short: return verdict.ended_early ? result::Answer::no : result::Answer::undecided;
    default: return result::Answer::no;
  }
}

}  // namespace fantail::report
