// SPDX-License-Identifier: MIT
#include "identify/page_words.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "identify/words.hpp"
#include "report/numbers.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using report::degrees;

// A sentence a node would bury the rest.
std::string all_nodes(const Identification& result) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (std::size_t k = 2; k < result.uncertainty->interval.size(); ++k) {
    const Interval& interval = result.uncertainty->interval[k];
    const double half = 0.5 * degrees(*interval.high - *interval.low);
    least = std::min(least, half);
    most = std::max(most, half);
  }
  return fmt::format("The disturbance at its {} nodes is known to {} to {} deg either way.",
                     result.model.node_rad.size(), text::brief(least, 3), text::brief(most, 3));
}

}  // namespace

const Identification& main_result(const WindowFindings& window) {
  const auto continuous = std::ranges::find(window.results, Method::continuous, &Identification::method);
  return continuous == window.results.end() ? window.results.front() : *continuous;
}

bool tells(const WindowFindings& window) {
  const auto& u = main_result(window).uncertainty;
  return u && u->alpha_identifiable && u->beta_identifiable;
}

std::vector<std::string> how_well_sentences(const Identification& result) {
  const std::size_t nodes = result.model.node_rad.size();
  constexpr std::size_t few = 2;
  const std::size_t told = 2 + (nodes <= few ? nodes : 0);
  std::vector<std::string> all;
  all.reserve(told + 1);
  for (std::size_t k = 0; k < told; ++k) {
    all.push_back(printable(how_well(result, k)));
  }
  if (nodes > few) {
    all.push_back(all_nodes(result));
  }
  const Uncertainty& u = *result.uncertainty;
  constexpr double tied = 0.9;
  if (std::abs(u.correlation(0, 1)) > tied) {
    all.push_back(
        fmt::format("Alpha and beta go together (correlation {}): a larger alpha with a larger beta explains "
                    "the log nearly as well, so their ratio is known better than either.",
                    text::fixed(u.correlation(0, 1), 2)));
  }
  const std::string strength = text::brief(degrees(u.residual_rms_rad), 3);
  const std::string worth = text::fixed(u.effective_samples, 0);
  if (u.effective_samples > 0.5 * static_cast<double>(result.samples)) {
    all.push_back(fmt::format("The residual, {} deg, is new in every sample: each of the {} samples counts.", strength,
                              result.samples));
  } else {
    all.push_back(
        fmt::format("The residual, {} deg, remembers itself for {} s: all {} samples together are worth about {} "
                    "independent {}. Faster sampling would not help; more time or more motion would.",
                    strength, text::fixed(u.residual_correlation_s, 2), result.samples, worth == "1" ? "one" : worth,
                    worth == "1" ? "reading" : "readings"));
  }
  return all;
}

std::string printable(std::string text) {
  for (const auto& [plain, printed] :
       {std::pair{"+-", "\u00b1"}, std::pair{" m2", " m\u00b2"}, std::pair{"kg/m3", "kg/m\u00b3"}}) {
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain)) {
      text.replace(at, std::string_view{plain}.size(), printed);
    }
  }
  return text;
}

std::string sentence(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

}  // namespace fantail::identify
