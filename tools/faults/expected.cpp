// SPDX-License-Identifier: MIT
#include <array>

#include <fmt/core.h>

#include "faults/fault_table.hpp"

namespace fantail::faults {
namespace {

std::string clause(Outcome outcome, const Expected& e) {
  switch (outcome) {
    case Outcome::not_armed: return "not armed";
    case Outcome::no_control: return "no control";
    case Outcome::holds: return fmt::format("held within {:g} deg", e.within_deg);
    case Outcome::recovers:
      return fmt::format("held within {:g} deg from {:g} s after the end of the fault, and within {:g} deg before",
                         e.within_deg, e.settle_s, e.meanwhile_deg);
    case Outcome::goes_on: return fmt::format("held within {:g} deg", e.meanwhile_deg);
    case Outcome::over: return fmt::format("control ended and canards at trim within {:g} s", e.trim_s);
    case Outcome::ended:
      return fmt::format("control ended early, and held within {:g} deg until then", e.meanwhile_deg);
    case Outcome::anything: break;
  }
  return "any roll, within the limits";
}

}  // namespace

std::string sentence(const Expected& expected) {
  std::string text;
  for (unsigned bit = 0; bit < outcomes; ++bit) {
    const auto outcome = static_cast<Outcome>(1U << bit);
    if (expected.allows(outcome)) {
      text += (text.empty() ? "" : ", or ") + clause(outcome, expected);
    }
  }
  return text.empty() ? "not applicable" : text;
}

const char* name(Outcome outcome) {
  switch (outcome) {
    case Outcome::not_armed: return "not_armed";
    case Outcome::no_control: return "no_control";
    case Outcome::holds: return "holds";
    case Outcome::recovers: return "recovers";
    case Outcome::goes_on: return "goes_on";
    case Outcome::over: return "over";
    case Outcome::ended: return "ended";
    case Outcome::anything: break;
  }
  return "anything";
}

}  // namespace fantail::faults
