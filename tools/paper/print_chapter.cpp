// SPDX-License-Identifier: MIT
// What can be checked with the printed page and a pencil.
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/core.h>

#include "paper/paper_page.hpp"
#include "paper/print.hpp"
#include "paper/recomputed.hpp"
#include "text/number.hpp"

namespace fantail::paper {
namespace {

void add_words(std::vector<Claim>& claims, const Print& print) {
  const auto grows = [](const PublishedStep& step) {
    return std::abs(step.disturbance_begin_deg) < std::abs(step.disturbance_end_deg);
  };
  const auto growing = static_cast<std::size_t>(std::ranges::count_if(print.steps, grows));
  claims.push_back(compare(InWords{.place = "Section 4.3.1, table 2",
                                   .what = "The offset is lower at the begin of a step",
                                   .theirs = "a trend",
                                   .ours = fmt::format("in {} of {} steps", growing, print.steps.size()),
                                   .holds = 2 * growing > print.steps.size(),
                                   .why = "From the eight rows of the table."}));
  const auto [weakest, strongest] = std::ranges::minmax(print.steps, {}, &PublishedStep::disturbance_end_deg);
  const auto [first_weak, first_strong] = std::ranges::minmax(print.steps, {}, &PublishedStep::disturbance_begin_deg);
  const double swirl = print[Number::swirl_deg];
  const double low = std::min(weakest.disturbance_end_deg, first_weak.disturbance_begin_deg) + swirl;
  const double high = std::max(strongest.disturbance_end_deg, first_strong.disturbance_begin_deg) + swirl;
  const double mean = -print[Number::launch_offset_deg];
  claims.push_back(compare(
      InWords{.place = "Section 4.3.2, figure 29",
              .what = "The offsets of launch 2 lie within the range of the tunnel tests",
              .theirs = "all of them",
              .ours = text::with_minus(fmt::format("their mean, {:.1f}, within {:.2f} to {:.2f} deg", mean, low, high)),
              .holds = low < mean && mean < high,
              .why = "From table 2 and 2 degrees of swirl. The single offsets are not printed as numbers."}));
}

}  // namespace

Chapter print_chapter(const Print& print) {
  Chapter chapter{.title = "The publication, checked against itself",
                  .introduction = "Sums, percentages and repeated numbers that need nothing but the publication."};
  for (const Computed& row : computed()) {
    chapter.claims.push_back(worked_out(row, print));
  }
  add_words(chapter.claims, print);
  std::ranges::move(print_slips(), std::back_inserter(chapter.claims));
  return chapter;
}

}  // namespace fantail::paper
