// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "bench/verdict.hpp"

namespace fantail::bench {
namespace {

// In the order of Cause.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> causes{
    {{"healthy", "is healthy"},
     {"stuck", "is stuck"},
     {"dead", "does not move"},
     {"reversed", "is reversed"},
     {"slipping", "slips"},
     {"slow", "is slow"},
     {"encoder_unplugged", "has no usable encoder reading"},
     {"encoder_noisy", "has a noisy encoder"},
     {"wrong_trim", "has a wrong trim"},
     {"wrong_canard_moves", "moves another canard"},
     {"out_of_tolerance", "is out of tolerance"},
     {"limit_not_kept", "was commanded beyond its limit"},
     {"not_measured", "could not be measured"}}};
static_assert(static_cast<std::size_t>(Cause::not_measured) + 1 == causes.size());

}  // namespace

std::string_view name(Cause cause) { return causes[static_cast<std::size_t>(cause)].first; }

std::string_view cause_text(Cause cause) { return causes[static_cast<std::size_t>(cause)].second; }

}  // namespace fantail::bench
