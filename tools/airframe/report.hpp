// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "airframe/summary.hpp"
#include "result/answer.hpp"
#include "text/layout.hpp"

namespace fantail::airframe {

[[nodiscard]] std::string text(const sim::Vehicle& vehicle, const Summary& summary,
                               std::size_t columns = ::fantail::text::any_width);
/// Is it stable? Undecided where it is marginal, doubtful or not compared with the design that it was read from.
[[nodiscard]] result::Answer answer(const Summary& summary);
[[nodiscard]] std::string json(const sim::Vehicle& vehicle, const Summary& summary, const result::Made& made = {});
[[nodiscard]] std::string html(const sim::Vehicle& vehicle, const Summary& summary);

/// The rocket from the side, nose to the left, to scale, with its centres of gravity and pressure: an SVG that takes
/// its colours from the page.
[[nodiscard]] std::string side_view(const sim::Geometry& shape, const Summary& summary, double width);

}  // namespace fantail::airframe
