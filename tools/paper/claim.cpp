// SPDX-License-Identifier: MIT
#include "paper/claim.hpp"

#include <cmath>
#include <utility>

#include "text/number.hpp"

namespace fantail::paper {
namespace {

struct Names {
  std::string_view name;
  std::string_view words;
};

constexpr std::array<Names, kinds.size()> names{{{"computed", "computed"},
                                                 {"simulated", "simulated"},
                                                 {"described", "described"},
                                                 {"fitted", "fitted"},
                                                 {"read_back", "read back"},
                                                 {"definition", "definition"},
                                                 {"outside", "outside the model"},
                                                 {"error_in_print", "error in print"},
                                                 {"not_reproducible", "not reproducible"}}};

std::string with_unit(double value, int decimals, const std::string& unit) {
  return text::fixed(value, decimals) + (unit.empty() ? "" : " " + unit);
}

constexpr const char* no_reason = "The reason is not known.";

}  // namespace

std::string_view name(Kind kind) { return names[place_of(kind)].name; }
std::string_view words(Kind kind) { return names[place_of(kind)].words; }

std::string_view rule_text() {
  return "One rule decides the kind of a row: the source of our value. \u201cComputed\u201d: from other printed "
         "numbers alone. \u201cSimulated\u201d: by a run with the published inputs, none of which was chosen to meet "
         "it. \u201cDescribed\u201d: printed in words, and found in such a run or in other printed numbers. Only these "
         "three count as reproduced. \u201cFitted\u201d: an unpublished input (motor, drag area, reference area, "
         "offset, height count) was "
         "chosen to meet it or a related value. \u201cRead back\u201d: a round trip; "
         "the value was an input, and "
         "our analysis finds it again. \u201cDefinition\u201d: an equation or input, taken as printed.";
}

std::string_view finding(const Claim& claim) {
  if (!claim.agrees) {
    return "differs";
  }
  return counts_as_reproduced(claim.kind) ? "reproduced" : name(claim.kind);
}

std::string_view basis(const Claim& claim) {
  switch (claim.kind) {
    case Kind::computed:
    case Kind::error_in_print: return "derived";
    case Kind::simulated:
    case Kind::described: return "simulated";
    case Kind::fitted: return "fitted";
    case Kind::read_back: return "round_trip";
    case Kind::definition:
    case Kind::outside:
    case Kind::not_reproducible: break;
  }
  return "none";
}

std::string kind_words(const Claim& claim) {
  return std::string{words(claim.kind)} + (claim.agrees ? "" : ", differs");
}

Claim compare(const Numbers& n) {
  const double difference = n.ours - n.theirs;
  // A tolerance of exactly a printed digit must not fail on the last bit of a decimal fraction.
  const bool agrees = std::abs(difference) <= n.tolerance * (1.0 + 1e-9) + 1e-12;
  const bool contradiction = !agrees && n.kind == Kind::computed;
  Claim claim{.place = n.place,
              .what = n.what,
              .theirs = with_unit(n.theirs, n.decimals, n.unit),
              .ours = with_unit(n.ours, n.decimals, n.unit),
              .difference = with_unit(difference, n.decimals, n.unit),
              .kind = contradiction ? Kind::error_in_print : n.kind,
              .agrees = agrees || contradiction,
              .why = agrees ? n.remark : n.why_otherwise};
  if (claim.why.empty() && !agrees) {
    claim.why = no_reason;
  }
  return claim;
}

Claim compare(const InWords& w) {
  return {.place = w.place,
          .what = w.what,
          .theirs = w.theirs,
          .ours = w.ours,
          .difference = {},
          .kind = w.kind,
          .agrees = w.holds,
          .why = w.why.empty() && !w.holds ? no_reason : w.why};
}

Claim unpublished(std::string place, std::string what, std::string theirs, std::string why, std::string ours) {
  return {.place = std::move(place),
          .what = std::move(what),
          .theirs = std::move(theirs),
          .ours = std::move(ours),
          .difference = {},
          .kind = Kind::not_reproducible,
          .agrees = true,
          .why = std::move(why)};
}

Claim slip(std::string place, std::string what, std::string printed, std::string must_be, std::string why) {
  return {.place = std::move(place),
          .what = std::move(what),
          .theirs = std::move(printed),
          .ours = std::move(must_be),
          .difference = {},
          .kind = Kind::error_in_print,
          .agrees = true,
          .why = std::move(why)};
}

}  // namespace fantail::paper
