// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign/setup.hpp"
#include "faults/results.hpp"
#include "flight/model_end.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

// What came of it, in words, and the commands that fly it again.
namespace fantail::faults {
namespace {

std::string options_of(const Campaign& campaign) {
  const Campaign usual;
  std::string words;
  for (const input::Override& change : campaign.changes) {
    words += " --set " + text::shell_word(campaign::lines_of({change}));
  }
  words += fmt::format(" --seed {}", campaign.seed);
  const auto add = [&words](const char* option, int value, int usually) {
    words += value == usually ? std::string{} : fmt::format(" {} {}", option, value);
  };
  add("--step-ms", campaign.step_ms, usual.step_ms);
  add("--every", campaign.every, usual.every);
  add("--seeds", static_cast<int>(campaign.seeds), static_cast<int>(usual.seeds));
  return words;
}

/// ", at worst servo/dead/controlling (control went on, 12.3 deg apart)": the flight that is farthest off.
std::string worst_of(const Result& result, Colour colour) {
  const CellResult* worst = nullptr;
  for (const CellResult& cell : result.cells) {
    if (cell.colour == colour && (worst == nullptr || worst->worst->apart_deg < cell.worst->apart_deg)) {
      worst = &cell;
    }
  }
  return worst == nullptr
             ? ""
             : fmt::format(", at worst {} ({})", worst->cell.name(), worst->figure.substr(0, worst->figure.find(';')));
}

/// What the flights of a fault in all its phases came to.
struct FaultsCounted {
  std::size_t not_safe = 0;    ///< in some phase
  std::size_t safe = 0;        ///< in every flight
  std::size_t not_judged = 0;  ///< in some phase, and safe in the others
};

FaultsCounted counted(const Result& result) {
  FaultsCounted all;
  for (auto cell = result.cells.begin(); cell != result.cells.end();) {
    const FaultRow* const fault = cell->cell.row;
    const auto end = std::find_if(cell, result.cells.end(), [&](const auto& other) { return other.cell.row != fault; });
    const auto has = [&](Colour colour) { return std::ranges::count(cell, end, colour, &CellResult::colour) > 0; };
    if (has(Colour::red) || has(Colour::known_limit)) {
      ++all.not_safe;
    } else if (has(Colour::not_judged)) {
      ++all.not_judged;
    } else if (has(Colour::green) || has(Colour::limit_without_need)) {
      ++all.safe;
    }
    cell = end;
  }
  return all;
}

/// "3 of 20 faults are not safe in some phase: servo hardover, ...; 17 are safe in every flight."
std::string faults_sentence(const Result& result) {
  constexpr std::size_t most_names = 4;
  const FaultsCounted of = counted(result);
  const std::size_t bad = of.not_safe;
  const std::size_t flown = bad + of.safe + of.not_judged;
  if (flown == 0) {
    return "No fault was flown";
  }
  std::vector<std::string> names;  // the worst first
  for (const std::size_t i : worst_cells(result)) {
    const CellResult& cell = result.cells[i];
    if ((cell.colour == Colour::red || cell.colour == Colour::known_limit) && names.size() < most_names) {
      names.push_back(fmt::format("{} {}", cell.cell.row->device, cell.cell.row->fault));
    }
  }
  const std::string more = bad > names.size() ? fmt::format(" and {} more", bad - names.size()) : "";
  const auto faults = [](std::size_t count) { return fmt::format("{} fault{}", count, count == 1 ? "" : "s"); };
  if (bad == 0 && of.not_judged == 0) {
    return flown == 1 ? "The fault is safe in every flight"
                      : fmt::format("All {} are safe in every flight", faults(flown));
  }
  const std::string the_safe =
      of.safe == 0 ? "" : fmt::format("{}{} safe in every flight", of.safe, of.safe == 1 ? " is" : " are");
  if (bad == 0) {
    return the_safe.empty() ? "No flight broke the rules for every flight" : "No fault is unsafe; " + the_safe;
  }
  return fmt::format("{} of {} {} not safe in some phase: {}{}{}{}", bad, faults(flown), bad == 1 ? "is" : "are",
                     fmt::join(names, ", "), more, the_safe.empty() ? "" : "; ", the_safe);
}

}  // namespace

std::size_t count(const Result& result, Colour colour) {
  return static_cast<std::size_t>(std::ranges::count(result.cells, colour, &CellResult::colour));
}

const char* word_of(Colour colour) {
  switch (colour) {
    case Colour::red: return "RED";
    case Colour::known_limit: return "a known limit";
    case Colour::limit_without_need: return "safe, though a limit is listed";
    case Colour::not_judged: return "not judged further";
    case Colour::green:
    case Colour::not_applicable: break;
  }
  return "safe";
}

bool has_red(const Result& result) { return count(result, Colour::red) > 0; }

bool has_red_limit(const Result& result) { return count(result, Colour::known_limit) > 0; }

std::string what_to_do(const CellResult& cell) {
  return fmt::format("{}{}{}", cell.limit->what_to_do, cell.of_rocket.empty() ? "" : ". ", cell.of_rocket);
}

std::string headline(const Result& result) {
  const std::size_t flown = result.cells.size() - count(result, Colour::not_applicable);
  const std::size_t red = count(result, Colour::red);
  const std::size_t limits = count(result, Colour::known_limit);
  const std::size_t without_need = count(result, Colour::limit_without_need);
  const std::size_t not_judged = count(result, Colour::not_judged);
  const std::size_t safe = flown - red - limits - without_need - not_judged;
  const auto line = [](std::string_view what, std::size_t number, const std::string& more = {}) {
    return number == 0 ? std::string{} : fmt::format(" {}: {}{}.", what, text::counted(number, "cell"), more);
  };
  const auto never = static_cast<std::size_t>(std::ranges::count(result.cells, false, &CellResult::is_reached));
  return fmt::format("{}{}. {} in {}.{}{}{}{}{}{}{}{}{}", flight::outside_model(result.beyond_model),
                     faults_sentence(result), text::counted(result.flights, "flight"), text::counted(flown, "cell"),
                     red == 0 ? " No cell is RED." : "", line("RED", red, worst_of(result, Colour::red)),
                     line("Not safe because of a known limit", limits, worst_of(result, Colour::known_limit)),
                     line("Checked only against the rules for every flight", not_judged),
                     line("Safe, though a limit is listed", without_need), line("Safe in every flight", safe),
                     line("Never happened, because no flight reaches the phase, and not counted as safe", never),
                     result.never_happened.empty() ? "" : " ", result.never_happened);
}

std::string command_of(const Campaign& campaign) {
  std::string words = "fantail campaign faults " + text::shell_word(campaign.scenario) + options_of(campaign);
  const auto add = [&words](const char* option, const std::string& value) {
    words += value.empty() ? std::string{} : fmt::format(" {} {}", option, value);
  };
  add("--device", campaign.device);
  add("--fault", campaign.fault);
  add("--phase", campaign.phase);
  return words;
}

std::string run_command(const Campaign& campaign, const Cell& cell, std::uint64_t number) {
  return fmt::format("fantail campaign faults {}{} --cell {} --run {}", text::shell_word(campaign.scenario),
                     options_of(campaign), cell.name(), number);
}

result::Answer answer_of(const Result& result) {
  return has_red(result)                                         ? result::Answer::no
         : has_red_limit(result) || !result.beyond_model.empty() ? result::Answer::undecided
                                                                 : result::Answer::yes;
}

result::Answer answer_of(Colour colour) {
  switch (colour) {
    case Colour::green: return result::Answer::yes;
    case Colour::red: return result::Answer::no;
    case Colour::not_applicable: return result::Answer::none;
    default: return result::Answer::undecided;
  }
}

}  // namespace fantail::faults
