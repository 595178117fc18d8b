// SPDX-License-Identifier: MIT
#include "rules/expression.hpp"

#include <limits>
#include <map>

#include "test.hpp"

namespace fantail::rules {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::map<std::string, Known> values{{"height_m", exactly(1500.0)},
                                          {"late_s", Number{3.1, infinity}},
                                          {"about", Number{2.0, 4.0}},
                                          {"beyond", exactly(infinity)},
                                          {"open", true},
                                          {"until", std::string{"guide"}}};
const std::map<std::string, Meaning> meanings{{"height_m", {}},
                                              {"late_s", {}},
                                              {"about", {}},
                                              {"beyond", {}},
                                              {"hidden", {.type = Type::flag}},
                                              {"hidden_m", {}},
                                              {"open", {.type = Type::flag}},
                                              {"until", {.type = Type::text, .words = {"guide", "burn_out"}}}};

const Vocabulary vocabulary{.meaning_of =
                                [](const std::string& name) {
                                  const auto found = meanings.find(name);
                                  return found == meanings.end() ? std::nullopt : std::optional{found->second};
                                },
                            .names =
                                [] {
                                  std::vector<std::string> names;
                                  for (const auto& [name, meaning] : meanings) {
                                    names.push_back(name);
                                  }
                                  return names;
                                }};

std::optional<Known> value_of(const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? std::nullopt : std::optional{found->second};
}
std::optional<Known> value(const std::string& text) { return Expression::parse(text, vocabulary).value(value_of); }

std::string truth(const std::string& text) {
  const auto known = value(text);
  return !known ? "unknown" : std::get<bool>(*known) ? "true" : "false";
}

struct Complaint {
  std::size_t position = 0;
  std::string said;
};
Complaint complaint(const std::string& text) {
  try {
    (void)Expression::parse(text, vocabulary);
  } catch (const ExpressionError& error) {
    return {error.position(), error.what()};
  }
  return {};
}

void expect_refused(const std::string& text, std::size_t position, const std::string& said) {
  const Complaint found = complaint(text);
  EXPECT_EQ(found.position, position) << text;
  EXPECT_NE(found.said.find(said), std::string::npos) << text << ": " << found.said;
}

TEST(Expression, BindsAsArithmeticAndLogicDo) {
  EXPECT_EQ(truth("1 + 2 * 3 == 7"), "true");
  EXPECT_EQ(truth("(1 + 2) * 3 == 9"), "true");
  EXPECT_EQ(truth("8 / 4 / 2 == 1 and 8 - 4 - 2 == 2"), "true");
  EXPECT_EQ(truth("-2 * -3 == 6"), "true");
  EXPECT_EQ(truth("true or false and false"), "true");
  EXPECT_EQ(truth("(true or false) and false"), "false");
  EXPECT_EQ(truth("not 1 > 2 and 1.5e2 >= 150"), "true");
  EXPECT_EQ(truth("until == \"guide\" and until != \"burn_out\""), "true");
  EXPECT_EQ(truth("open == true\n and height_m >= 1500"), "true");
}

TEST(Expression, OfAnUnknownValueIsDecidedOnlyWhereTheOthersDecideIt) {
  EXPECT_EQ(truth("hidden or true"), "true");
  EXPECT_EQ(truth("hidden or false"), "unknown");
  EXPECT_EQ(truth("hidden and false"), "false");
  EXPECT_EQ(truth("hidden and true"), "unknown");
  EXPECT_EQ(truth("not hidden"), "unknown");
  EXPECT_EQ(truth("hidden_m >= 0"), "unknown");
  EXPECT_EQ(truth("hidden == hidden"), "unknown");
  EXPECT_EQ(truth("hidden_m * 0 == 0"), "unknown");
}

TEST(Expression, OfANumberWhoseEndsAreKnownIsDecidedWhereEveryNumberBetweenThemDecidesItAlike) {
  EXPECT_EQ(truth("3.0 >= late_s"), "false");
  EXPECT_EQ(truth("3.2 >= late_s"), "unknown");
  EXPECT_EQ(truth("late_s > 3"), "true");
  EXPECT_EQ(truth("about >= 2"), "true");
  EXPECT_EQ(truth("about > 2"), "unknown");
  EXPECT_EQ(truth("about < 5 and about <= 4"), "true");
  EXPECT_EQ(truth("about == 5"), "false");
  EXPECT_EQ(truth("about == 3"), "unknown");
  EXPECT_EQ(truth("-about <= -2"), "true");
  EXPECT_EQ(truth("10 / about <= 5"), "true");
  EXPECT_EQ(truth("about - about <= 2"), "true");
  EXPECT_EQ(truth("1 / (about - 3) > 0"), "unknown");  // a division by zero is among them
  EXPECT_EQ(truth("1 / 0 > 0"), "unknown");
  EXPECT_EQ(truth("late_s * 0 == 0"), "unknown");
}

TEST(Expression, OfAValueBeyondEveryNumberIsUnknown) {
  EXPECT_EQ(truth("1e308 * 10 > 0"), "unknown");
  EXPECT_EQ(truth("-1e308 * 10 < 0"), "unknown");
  EXPECT_EQ(truth("1e308 + 1e308 >= 1"), "unknown");
  EXPECT_EQ(truth("1 / 1e-320 > 1"), "unknown");
  EXPECT_EQ(truth("1e308 * 10 == 1e308 * 10"), "unknown");
  EXPECT_EQ(truth("1e308 * 10 > 0 or true"), "true");
  EXPECT_EQ(truth("beyond > 1"), "unknown");
  EXPECT_EQ(truth("late_s + 1 > 4"), "true");  // it reaches to infinity, and begins at a number
}

TEST(Expression, TellsTheNamesThatItNeedsEachOnce) {
  EXPECT_EQ(Expression::parse("height_m > 1 and open and height_m < 9", vocabulary).names(),
            (std::vector<std::string>{"height_m", "open"}));
}

// Values as for the truth above: what one side decides needs no other.
TEST(Expression, TellsTheNamesThatDecideIt) {
  const auto deciding = [](const std::string& text) {
    return Expression::parse(text, vocabulary).deciding_names(value_of);
  };
  const std::string is_true = "height_m < 1e9";
  const std::string is_false = "height_m > 1e9";
  const std::string open = "hidden_m > 1";
  EXPECT_EQ(deciding(is_true + " or " + open), (std::vector<std::string>{"height_m"}));
  EXPECT_EQ(deciding(open + " or " + is_true), (std::vector<std::string>{"height_m"}));
  EXPECT_EQ(deciding(open + " and " + is_false), (std::vector<std::string>{"height_m"}));
  EXPECT_EQ(deciding("not (" + is_false + " and " + open + ")"), (std::vector<std::string>{"height_m"}));
  EXPECT_EQ(deciding(is_true + " and " + open), (std::vector<std::string>{"height_m", "hidden_m"}));
  EXPECT_EQ(deciding(is_false + " or " + open), (std::vector<std::string>{"height_m", "hidden_m"}));
}

TEST(Expression, IsRefusedWithItsPositionAndWhy) {
  expect_refused("", 1, "empty");
  expect_refused("   ", 1, "empty");
  expect_refused("heigth_m > 3", 1, "names no figure and no field of a plan; did you mean height_m?");
  expect_refused("1 < 2 and xyzzy", 11, "names no figure");
  expect_refused("height_m > ", 12, "a value is missing at the end");
  expect_refused("height_m > )", 12, "a value is missing in front of \")\"");
  expect_refused("(height_m > 3", 14, "\")\" is missing");
  expect_refused("height_m > 3)", 13, "cannot follow here");
  expect_refused("height_m > 3 4", 14, "cannot follow here");
  expect_refused("until == \"guide", 10, "no closing quote");
  expect_refused("height_m & 3", 10, "has no meaning here");
  expect_refused("height_m = 3", 10, "has no meaning here");
  expect_refused("height_m > 1.2.3", 12, "is not a number");
  expect_refused("1 < 2 < 3", 7, "cannot be compared");
}

TEST(Expression, IsRefusedForATypeThatDoesNotFit) {
  expect_refused("height_m and open", 1, "\"and\" needs true or false here, and this is a number");
  expect_refused("open or 3", 9, "\"or\" needs true or false");
  expect_refused("not height_m", 5, "\"not\" needs true or false");
  expect_refused("open + 1 > 0", 1, "\"+\" needs a number here, and this is true or false");
  expect_refused("-until > 0", 2, "\"-\" needs a number here, and this is a text");
  expect_refused("until > 3", 1, "\">\" needs a number");
  expect_refused("until == 3", 10, "this is a number, and what it is compared with is a text");
  expect_refused("open == height_m", 9, "this is a number");
}

// It would always be false, and with != a clause would always pass.
TEST(Expression, IsRefusedForAWordThatAFieldCannotHave) {
  expect_refused("until == \"burnout\"", 10, "\"burnout\" is not a value of until; allowed: \"guide\", \"burn_out\"");
  expect_refused("\"burnout\" != until", 1, "is not a value of until");
}

TEST(Expression, OfAFileCannotUseUpTheStack) {
  expect_refused(std::string(400, '(') + "1 < 2" + std::string(400, ')'), 101, "nested more than 100 deep");
  std::string long_one = "open";
  for (int i = 0; i < 100'000; ++i) {
    long_one += " or open";
  }
  expect_refused(long_one, 1, "more than 1000 parts");
}

}  // namespace
}  // namespace fantail::rules
