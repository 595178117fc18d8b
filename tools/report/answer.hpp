// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "flight/flight.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "result/document.hpp"

namespace fantail::report {

/// What a flight came to, without pictures: the terminal and summary.json. Every key of it is always there; what does
/// not exist is null.
[[nodiscard]] result::Document summary(const flight::Flight& flight, const Figures& figures, const Verdict& verdict,
                                       const result::Made& made = {});
/// The same for report.html, with its charts, path and rockets.
[[nodiscard]] result::Document answer(const flight::Flight& flight, const Figures& figures, const Verdict& verdict,
                                      const result::Made& made = {});

/// The figures of summary.json, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();

}  // namespace fantail::report
