// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "airframe/summary.hpp"
#include "brief/brief.hpp"
#include "campaign/results.hpp"
#include "detection/report.hpp"
#include "fantail/compare_results.hpp"
#include "faults/results.hpp"
#include "hardover/study.hpp"
#include "identify/result/answer.hpp"
#include "listen/answer.hpp"
#include "predict/answer.hpp"
#include "rare/study.hpp"
#include "report/answer.hpp"
#include "rules/judge.hpp"
#include "tune/results.hpp"
#include "tunnel/flow.hpp"
#include "tunnel/stability.hpp"
#include "tunnel/steps.hpp"
#include "tunnel/swirl.hpp"

namespace fantail::result {
namespace {

/// With the unit behind it that it does not name.
std::string key_of(const Column& column) {
  const bool names_unit = !column.unit.suffix.empty() || column.unit.symbol.empty();
  return fmt::format("`{}{}`{}", column.key, column.unit.suffix,
                     names_unit ? "" : fmt::format(" ({})", column.unit.symbol));
}

/// The label goes before the meaning if it has a word, longer than "that", which neither key nor meaning has.
std::string meaning_of(const Column& column) {
  std::istringstream words{std::string{column.label}};
  bool says_more = false;
  for (std::string word; words >> word;) {
    std::erase_if(word, [](char c) { return c == ',' || c == ':'; });
    says_more = says_more || (word.size() > 4 && column.key.find(word) == std::string_view::npos &&
                              column.meaning.find(word) == std::string_view::npos);
  }
  return fmt::format("{}{}{}", says_more ? column.label : "", says_more ? ": " : "", column.meaning);
}

/// A table for each place: key and meaning of its fields. What an earlier table of the verb has alike is named only.
std::string tables(const std::vector<Listed>& all) {
  std::string text;
  std::set<std::string> earlier;
  for (const Listed& one : all) {
    std::string rows;
    std::string as_above;
    for (const Column& column : one.columns) {
      const std::string row = fmt::format("| {} | {} |\n", key_of(column), meaning_of(column));
      if (earlier.insert(row).second) {
        rows += row;
      } else {
        as_above += fmt::format("{}{}", as_above.empty() ? "As above: " : ", ", key_of(column));
      }
    }
    const std::string place = one.place.empty() ? "key" : fmt::format("`{}`", one.place);
    text += rows.empty() ? place + ":\n\n" : fmt::format("| {} | meaning |\n|---|---|\n{}\n", place, rows);
    text += as_above.empty() ? "" : as_above + ".\n\n";
  }
  return text;
}

constexpr const char* page_file = FANTAIL_TEST_SOURCE "/docs/results.md";
constexpr std::string_view begin_mark =
    "<!-- fields: written by FANTAIL_WRITE_MANUAL=1 build/host/test/result/test_result -->\n";

TEST(ResultsPage, HasEveryFieldOfTheVerbsWhoseResultsAreTables) {
  std::ifstream file{page_file};
  std::string page{std::istreambuf_iterator<char>{file}, {}};
  const std::size_t begin = page.find(begin_mark);
  ASSERT_NE(begin, std::string::npos) << page_file;
  const std::vector<std::pair<std::string_view, std::vector<Listed>>> verbs{
      {"airframe", airframe::listed_fields()},
      {"brief", brief::listed_fields()},
      {"campaign", campaign::listed_fields()},
      {"campaign detection", detection::listed_fields()},
      {"campaign faults", faults::listed_fields()},
      {"campaign hardover", hardover::listed_fields()},
      {"campaign rare", rare::listed_fields()},
      {"compare, report of two flights", tool::listed_comparison()},
      {"fly, report", report::listed_fields()},
      {"identify", identify::result::listed_fields()},
      {"listen", listen::listed_fields()},
      {"predict", predict::listed_fields()},
      {"rules", rules::listed_fields()},
      {"tune", tune::listed_fields()},
      {"tunnel flow", tunnel::listed_flow_fields()},
      {"tunnel stability", tunnel::listed_stability_fields()},
      {"tunnel steps", tunnel::listed_step_fields()},
      {"tunnel swirl", tunnel::listed_swirl_fields()}};
  std::string fields;
  for (const auto& [verb, listed] : verbs) {
    fields += fmt::format("\n## {}\n\n{}", verb, tables(listed));
    fields.pop_back();
  }
  const std::string written = page.substr(0, begin) + std::string{begin_mark} + fields;
  if (std::getenv("FANTAIL_WRITE_MANUAL") != nullptr) {  // NOLINT(concurrency-mt-unsafe): there is one thread
    std::ofstream{page_file} << written;
    page = written;
  }
  EXPECT_EQ(page, written) << "FANTAIL_WRITE_MANUAL=1 build/host/test/result/test_result writes it";
}

}  // namespace
}  // namespace fantail::result
