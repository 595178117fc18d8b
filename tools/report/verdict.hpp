// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "flight/flight.hpp"
#include "report/figures.hpp"

namespace fantail::report {

enum class Outcome : std::uint8_t {
  held,        ///< the largest hold error is at most 10 deg
  not_held,    ///< it is more, or the canards ended at a limit smaller than the fin offset
  not_judged,  ///< under control, but never settled, or without a known disturbance
  no_control,  ///< Controlling was never reached
};

struct Verdict {
  Outcome outcome = Outcome::no_control;
  std::string text;  ///< one to four plain sentences
};

[[nodiscard]] Verdict verdict(const flight::Flight& flight, const Figures& figures);

[[nodiscard]] std::string_view name(Outcome outcome);          ///< for files: "held"
[[nodiscard]] std::string_view display_name(Outcome outcome);  ///< for readers: "Held"

}  // namespace fantail::report
