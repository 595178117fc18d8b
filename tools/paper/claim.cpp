// SPDX-License-Identifier: MIT
#include "paper/claim.hpp"

#include <cmath>
#include <utility>

#include "text/number.hpp"

namespace fantail::paper {
namespace {

std::string with_unit(double value, int decimals, const std::string& unit) {
  return text::fixed(value, decimals) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

std::string_view name(Finding finding) {
  switch (finding) {
    case Finding::reproduced: return "reproduced";
    case Finding::differs: return "differs";
    case Finding::not_reproducible: return "not_reproducible";
    case Finding::error_in_print: break;
  }
  return "error_in_print";
}

std::string_view words(Finding finding) {
  switch (finding) {
    case Finding::reproduced: return "reproduced";
    case Finding::differs: return "differs";
    case Finding::not_reproducible: return "not reproducible without the data";
    case Finding::error_in_print: break;
  }
  return "error in print";
}

std::string_view name(Basis basis) {
  switch (basis) {
    case Basis::derived: return "derived";
    case Basis::fitted: return "fitted";
    case Basis::round_trip: return "round_trip";
    case Basis::none: break;
  }
  return "none";
}

std::string_view words(Basis basis) {
  switch (basis) {
    case Basis::derived: return "derived from the print";
    case Basis::fitted: return "fitted to the print";
    case Basis::round_trip: return "round trip";
    case Basis::none: break;
  }
  return "not computed";
}

Claim compare(const Numbers& n) {
  const double difference = n.ours - n.theirs;
  // A tolerance of exactly a printed digit must not fail on the last bit of a decimal fraction.
  const bool agrees = std::abs(difference) <= n.tolerance * (1.0 + 1e-9) + 1e-12;
  Claim claim{.place = n.place,
              .what = n.what,
              .theirs = with_unit(n.theirs, n.decimals, n.unit),
              .ours = with_unit(n.ours, n.decimals, n.unit),
              .difference = with_unit(difference, n.decimals, n.unit),
              .finding = agrees ? Finding::reproduced : n.otherwise,
              .basis = n.basis,
              .why = agrees ? n.remark : n.why_otherwise};
  if (claim.why.empty() && !agrees) {
    claim.why = "The reason is not known.";
  }
  return claim;
}

Claim unpublished(std::string place, std::string what, std::string theirs, std::string why, std::string ours) {
  const Basis basis = ours.empty() ? Basis::none : Basis::round_trip;
  return {.place = std::move(place),
          .what = std::move(what),
          .theirs = std::move(theirs),
          .ours = std::move(ours),
          .difference = {},
          .finding = Finding::not_reproducible,
          .basis = basis,
          .why = std::move(why)};
}

Claim slip(std::string place, std::string what, std::string printed, std::string must_be, std::string why) {
  return {.place = std::move(place),
          .what = std::move(what),
          .theirs = std::move(printed),
          .ours = std::move(must_be),
          .difference = {},
          .finding = Finding::error_in_print,
          .basis = Basis::derived,
          .why = std::move(why)};
}

}  // namespace fantail::paper
