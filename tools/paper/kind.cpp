// SPDX-License-Identifier: MIT
#include "paper/kind.hpp"

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

}  // namespace

std::string_view name(Kind kind) { return names[place_of(kind)].name; }
std::string_view words(Kind kind) { return names[place_of(kind)].words; }

std::string_view rule_text() {
  return "One rule decides the kind of a row: what our value was made from. \u201cComputed\u201d: from other printed "
         "numbers alone. \u201cSimulated\u201d: by a run with the published inputs, none of which was chosen to meet "
         "it. \u201cDescribed\u201d: printed in words, and seen in such a run or in other printed numbers. Only these "
         "three count as reproduced. \u201cFitted\u201d: an unpublished input was chosen to meet it: motor, drag area, "
         "reference area, or the way to count height. \u201cRead back\u201d: a round trip; the value was an input, and "
         "our analysis finds it again. \u201cDefinition\u201d: an equation or input, taken as printed.";
}

}  // namespace fantail::paper
