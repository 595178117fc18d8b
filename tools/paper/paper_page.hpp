// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "paper/claim.hpp"
#include "paper/print.hpp"
#include "paper/runs.hpp"
#include "result/answer.hpp"

namespace fantail::paper {

/// How many claims came to what. Each stands in one place, so that they add up to all.
struct Tally {
  std::array<std::size_t, kinds.size()> agreeing{};  ///< by place_of(kind)
  std::size_t differs = 0;

  [[nodiscard]] std::size_t of(Kind kind) const { return agreeing[place_of(kind)]; }
  [[nodiscard]] std::size_t reproduced() const;  ///< of the kinds that count as it
};
[[nodiscard]] Tally tally(std::span<const Chapter> chapters);

/// How it came out, in three sentences.
[[nodiscard]] std::string summary(const Tally& tally);

/// Of rows that are folded away: "Rows: 8 read back, 2 definition".
[[nodiscard]] std::string folded_words(std::span<const Claim> claims);

/// The whole reproduction as one page that loads nothing.
[[nodiscard]] std::string paper_html(std::span<const Chapter> chapters, const std::string& version);

/// An object: tally, and "claims" with place, what, theirs, ours, difference, finding, basis, kind, why. Ends with a
/// newline.
[[nodiscard]] std::string paper_json(std::span<const Chapter> chapters, const std::string& version,
                                     const result::Made& made = {});

// Each flies what it needs, works out the numbers that were printed, and draws the figures that were printed.

[[nodiscard]] Chapter air_chapter(const Tell& tell);            ///< Section 4.1.1
[[nodiscard]] Chapter swirl_chapter(const Tell& tell);          ///< Section 4.1.2
[[nodiscard]] Chapter first_launch_chapter(const Tell& tell);   ///< Section 4.2
[[nodiscard]] Chapter steps_chapter(const Tell& tell);          ///< Section 4.3.1, Table 2
[[nodiscard]] Chapter second_launch_chapter(const Tell& tell);  ///< Section 4.3.2
[[nodiscard]] Chapter print_chapter(const Print& print);
[[nodiscard]] Chapter inputs_chapter();  ///< what was taken as printed, and what no model here contains

}  // namespace fantail::paper
