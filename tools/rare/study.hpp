// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/question.hpp"
#include "campaign/setup.hpp"
#include "rare/subset_simulation.hpp"
#include "result/document.hpp"
#include "runs/folder.hpp"

namespace fantail::rare {

/// What is asked: how probable is it that a flight of a scenario fails a question, over all that its tables [[spread]]
/// say is not known?
struct Options {
  campaign::Campaign campaign{};  ///< scenario, changes and seed; the rest is of no matter
  campaign::Question question{};
  std::size_t flights_a_level = 3'000;
  std::optional<double> at_most{};     ///< a probability that is required
  unsigned threads = 0;                ///< 0: as many as the machine has
  const runs::Folder* kept = nullptr;  ///< of finished flights; null: none are kept
};

/// A flight that failed, or came nearest to it.
struct Found {
  Point point{};
  std::vector<std::string> changes{};  ///< "body.mass_kg=4.1": with the seed they are the flight again
  double margin = 0.0;
  std::string outcome{};
  std::string folder{};  ///< of its flight report; empty: none was written
};

/// One quantity over flights that failed. In two places at once (a bias of either sign) its mean says how many flights
/// are in which, by chance of the search: how far it moved is what counts then.
struct Quantity {
  std::string name{};             ///< as runs.csv has it
  double mean_sigmas = 0.0;       ///< 0 in all flights, failed or not
  double deviation_sigmas = 0.0;  ///< 1 in all

  /// Of both: how far it is from its mean, in whatever direction; 1 in all flights.
  [[nodiscard]] double far_sigmas() const { return std::hypot(mean_sigmas, deviation_sigmas); }
  [[nodiscard]] bool is_one_way() const { return std::abs(mean_sigmas) > 0.7 * far_sigmas(); }
  /// More than the samples of a search are off by chance.
  [[nodiscard]] bool has_moved() const { return is_one_way() ? std::abs(mean_sigmas) >= 0.5 : far_sigmas() >= 1.5; }
};

/// Of the failed flights those that fail by one thing.
struct Mode {
  std::string criterion{};             ///< as failed_by in runs.csv has it, the first of a flight; or the question
  double share = 0.0;                  ///< of the failed flights
  std::vector<Quantity> quantities{};  ///< those that moved most first
};

struct Study {
  std::string scenario{};
  std::string vehicle{};
  std::string plan{};
  Options options{};
  Estimate estimate{};
  std::vector<Mode> modes{};            ///< the most frequent first; of two hundred failed flights, flown again
  std::optional<Found> likeliest{};     ///< of the failed flights the one nearest to the middle of all laws
  std::vector<Found> worst{};           ///< the most negative margins
  std::vector<std::string> discrete{};  ///< fields that are drawn from rows of a table
  std::optional<std::string> led_to{};  ///< of `followed`: to what the search came nearest; of outcome=held
  std::uint64_t events = 0;             ///< plain flights that failed by something that no figure measures
  /// What the probability would be if each normal law had the tails of Student's t distribution with five degrees of
  /// freedom and the same standard deviation: of the half space of this probability where the failures are.
  std::optional<double> with_heavier_tails{};
  result::Made made{};  ///< the caller's
};

/// Flies until the levels have come to the failures. `look`: how many flights were flown
/// now; those that were kept are not flown again. Throws text::Error for a
/// scenario without spread, a question that cannot be searched, a draw that a field refuses.
[[nodiscard]] Study search(const Options& options, const std::function<void(std::uint64_t done)>& look);

/// Flies the likeliest and the worst again, each alone, and writes their flight reports into folders of `folder`.
void fly_again(Study& study, const std::filesystem::path& folder, const std::function<void()>& look);

[[nodiscard]] result::Document answer(const Study& study);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();

}  // namespace fantail::rare
