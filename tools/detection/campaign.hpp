// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "detection/kind.hpp"
#include "detection/rule.hpp"
#include "detection/tally.hpp"

namespace fantail::detection {

struct Campaign {
  std::vector<Rule> rules;
  std::vector<Kind> kinds;  ///< each once
  std::uint64_t seed = 1;
  std::uint64_t events = 10'000;     ///< of each kind that is no launch
  std::uint64_t launches = 1'000;    ///< of each kind that is one
  bool both_well = false;            ///< only events in which both accelerometers are: those with an even number
  std::vector<std::string> plans{};  ///< by name or file, that made the rules; empty: the usual ones

  [[nodiscard]] std::uint64_t number_of(Kind kind) const { return is_launch(kind) ? launches : events; }
  [[nodiscard]] std::uint64_t event(Kind kind, std::uint64_t turn) const {
    return both_well && !is_launch(kind) ? 2 * turn : turn;
  }
  [[nodiscard]] std::uint64_t total() const;

  /// Leaves out the kinds of which there is to be none.
  void drop_empty_kinds();
};

/// Events that are played and stored together; which are in which depends on nothing but their turn.
[[nodiscard]] constexpr std::uint64_t events_of_a_chunk(Kind kind) {
  return is_launch(kind) ? 512 : is_flight(kind) ? 256 : 4'096;
}

/// A tally for each kind that was asked for, in the order of the enumeration; empty for the others.
struct Results {
  std::array<std::optional<Tally>, kinds> of_kind{};
  std::uint64_t played = 0;   ///< in this call; the others were stored
  std::uint64_t damaged = 0;  ///< damaged stored parts, which were played again
  double processor_s = 0.0;   ///< what the played ones took, on all threads together
};

/// Plays all events on several threads (0: as many as the machine has). The counts do not depend on the threads, nor on
/// how often it was interrupted: `folder` keeps finished chunks, and the same campaign goes on from there; so does one
/// with more events or other kinds. Without a folder nothing is kept.
///
/// `look` is called with how many events are done, those of unfinished chunks too, on the caller's thread; what it
/// throws ends all after the present event and comes out of here, and finished chunks stay. Throws text::Error
/// (bad_configuration) for a folder with a campaign of another seed, other rules, other models or another program, or
/// of another kind; text::OutputError.
[[nodiscard]] Results play(const Campaign& campaign, const std::optional<std::filesystem::path>& folder,
                           const std::string& program, unsigned threads,
                           const std::function<void(std::uint64_t done)>& look);

/// Of the models and of what these rules make of them: a digest of a few events of every kind. Another one when a model
/// draws something else, or when the flight law decides otherwise in one of these events.
[[nodiscard]] std::string fingerprint(std::span<const Rule> rules);

}  // namespace fantail::detection
