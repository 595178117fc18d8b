// SPDX-License-Identifier: MIT

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

struct Clock {
  double begin_s = 0.0;
  double end_s = 10.0;
  double interval_s = 0.01;
};

std::string log_of(const Clock& clock, const std::function<double(double)>& angle_deg,
                   const std::function<double(double)>& rate_deg_s, const std::string& angle_name = "roll_angle_deg") {
  std::string text = "time_s," + angle_name + ",roll_rate_deg_s\n";
  const auto count = static_cast<int>(std::lround((clock.end_s - clock.begin_s) / clock.interval_s));
  for (int i = 0; i <= count; ++i) {
    const double t = clock.begin_s + i * clock.interval_s;
    text += std::to_string(t) + "," + std::to_string(angle_deg(t)) + "," + std::to_string(rate_deg_s(t)) + "\n";
  }
  return text;
}

constexpr double w = 2.0 * std::numbers::pi * 0.23;

// 100 sin(w (t - ahead)) degrees.
std::string swing(const Clock& clock, double ahead_s = 0.0, double offset_deg = 0.0) {
  return log_of(
      clock, [=](double t) { return offset_deg + 100.0 * std::sin(w * (t - ahead_s)); },
      [=](double t) { return 100.0 * w * std::cos(w * (t - ahead_s)); });
}

// angle + rate t, degrees.
std::string line(const Clock& clock, double angle, double rate, const std::string& angle_name = "roll_angle_deg") {
  return log_of(clock, [=](double t) { return angle + rate * t; }, [=](double) { return rate; }, angle_name);
}

TEST(Compare, PrintsMeanAndLargestDifferenceAndWritesAPageAndTheData) {
  const Folder folder;
  folder.write("a.csv", line({}, 1.0, 20.0));
  folder.write("b.csv", line({.begin_s = -1.0, .end_s = 11.0, .interval_s = 0.013}, 0.0, 19.0));
  const Outcome outcome =
      fantail({"compare", "a.csv", "b.csv", "--from", "2", "--to", "4", "--json"}, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = json::parse(outcome.out);
  // A - B = 1 + t over 2..4 s: mean 4, largest 5 at 4 s; the rates are 1 deg/s apart.
  EXPECT_NEAR(json["mean_abs_angle_difference_deg"].number(), 4.0, 1e-5);
  EXPECT_NEAR(json["max_abs_angle_difference_deg"].number(), 5.0, 1e-5);
  EXPECT_NEAR(json["max_angle_difference_at_s"].number(), 4.0, 1e-9);
  EXPECT_NEAR(json["mean_abs_rate_difference_deg_s"].number(), 1.0, 1e-5);
  EXPECT_NEAR(json["max_abs_rate_difference_deg_s"].number(), 1.0, 1e-5);
  EXPECT_EQ(json["samples"], 201);
  EXPECT_NEAR(json["seconds"].number(), 2.0, 1e-9);
  EXPECT_EQ(json["shift_s"], 0.0);
  EXPECT_TRUE(json["requirement_met"].is_null());
  EXPECT_EQ(folder.listing(), (Words{"a.csv", "b.csv", "out", "out/compare", "out/compare/compare.html",
                                     "out/compare/compare.json", "out/compare/differences.csv"}));
  EXPECT_EQ(content(folder / "out/compare/compare.json"), outcome.out);
  const std::string data = content(folder / "out/compare/differences.csv");
  EXPECT_EQ(std::ranges::count(data, '\n'), 202);
  EXPECT_NE(data.find("\n3.000000,61.000000,57.000000,4.000000,20.000000,19.000000,1.000000\n"), std::string::npos);
  EXPECT_NE(content(folder / "out/compare/compare.html").find("</html>"), std::string::npos);
}

TEST(Compare, RemarksThatALaunchAndATunnelRunBeginTheirClocksElsewhere) {
  const Folder folder;
  for (const auto& [scenario, out] : {std::pair{"tasha3_launch2", "launch"}, std::pair{"tunnel_steps", "steps"}}) {
    ASSERT_EQ(fantail({"fly", scenario, "--out", out}, {.working_folder = folder.path()}).exit_code, 0);
  }
  const std::string both = fantail({"compare", "launch", "steps"}, {.working_folder = folder.path()}).out;
  EXPECT_NE(both.find("steps is a tunnel run and launch is a launch"), std::string::npos) << both;
  const std::string same =
      fantail({"compare", "launch", "launch", "--b", "true"}, {.working_folder = folder.path()}).out;
  EXPECT_EQ(same.find("tunnel run"), std::string::npos) << same;
}

TEST(Compare, FindsHowFarTwoClocksAreApart) {
  const Folder folder;
  folder.write("a.csv", swing({}));
  folder.write("b.csv", swing({.begin_s = -3.0, .end_s = 13.0}, 0.037, 30.0));
  const Words words{"compare", "a.csv", "b.csv", "--align", "angle", "--remove-offset", "--json"};
  const Outcome outcome = fantail(words, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = json::parse(outcome.out);
  EXPECT_NEAR(json["shift_s"].number(), 0.037, 1e-3);
  EXPECT_NEAR(json["offset_deg"].number(), -30.0, 0.15);  // a millisecond of at most 145 deg/s
  EXPECT_LT(json["max_abs_angle_difference_deg"].number(), 0.3);
  const Outcome stated =
      fantail({"compare", "a.csv", "b.csv", "--shift", "0.037", "--json"}, {.working_folder = folder.path()});
  EXPECT_NEAR(json::parse(stated.out)["mean_abs_angle_difference_deg"].number(), 30.0, 0.01);
}

TEST(Compare, ASimulatedFlightHasItsTruthBesideIt) {
  const Folder folder;
  ASSERT_EQ(fantail({"fly", "--out", folder / "flight"}).exit_code, 0);
  const Words words{"compare", "flight", "flight", "--b", "true", "--window", "control", "--require-angle", "1"};
  const Outcome outcome = fantail(words, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("  second   flight (true)\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("  window   control\n"), std::string::npos) << outcome.out;
  EXPECT_NE(content(folder / "out/compare/compare.html").find("Close enough"), std::string::npos);
}

// Whoever reads a page does not know which was A.
TEST(Compare, CallsEachLogByTheShortestNameThatTellsItFromTheOther) {
  const Folder folder;
  for (const char* name : {"flown.csv", "monday/flight.csv", "tuesday/flight.csv"}) {
    folder.write(name, line({.end_s = 1.0}, 0.0, 20.0));
  }
  ASSERT_EQ(fantail({"fly", "--out", folder / "sim"}).exit_code, 0);
  struct Case {
    Words words;
    std::string title;
  };
  for (const Case& one :
       {Case{{"compare", "flown.csv", "monday/flight.csv"}, "flown.csv against flight.csv"},
        {{"compare", "monday/flight.csv", "tuesday/flight.csv"}, "monday/flight.csv against tuesday/flight.csv"},
        {{"compare", "monday/../flown.csv", "flown.csv"}, "flown.csv (first) against flown.csv (second)"},
        {{"compare", "sim/", "sim", "--b", "true"}, "sim (measured) against sim (true)"},
        {{"report", "sim", "tuesday/flight.csv"}, "sim and flight.csv"}}) {
    Words words = one.words;
    words.insert(words.end(), {"--out", "o"});
    const Outcome outcome = fantail(words, {.working_folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with(one.title)) << outcome.out;
    const std::string page = content(folder / (words[0] == "report" ? "o/report.html" : "o/compare.html"));
    EXPECT_NE(page.find("<h1>" + one.title), std::string::npos) << one.title;
    for (const std::string& text : {outcome.out, page.substr(page.find("<h1>"))}) {
      for (const char* letter : {">A<", ">B<", "  A ", "  B ", "A's", "B's", " of A", " of B", "A minus B"}) {
        EXPECT_EQ(text.find(letter), std::string::npos) << one.title << ": " << letter;
      }
    }
  }
}

TEST(Compare, ADifferenceAboveTheRequiredOneIsExitCodeOneAndStillWritten) {
  const Folder folder;
  folder.write("a.csv", line({}, 3.0, 20.0));
  folder.write("b.csv", line({}, 0.0, 20.0));
  const auto required = [&](const char* angle, const char* rate) {
    return fantail({"compare", "a.csv", "b.csv", "--require-angle", angle, "--require-rate", rate, "--out", "o"},
                   {.working_folder = folder.path()});
  };
  EXPECT_EQ(required("3.001", "0").exit_code, 0);
  const Outcome outcome = required("2.999", "0");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("mean angle difference 3 deg"), std::string::npos) << outcome.err;
  EXPECT_NE(content(folder / "o/compare.html").find("Too far apart"), std::string::npos);
}

TEST(Compare, WhatHardlyOverlapsMeetsNoRequirement) {
  const Folder folder;
  folder.write("a.csv", line({}, 0.0, 20.0));
  folder.write("enough.csv", line({.end_s = 9.0}, 0.0, 20.0));
  folder.write("little.csv", line({.end_s = 8.99}, 0.0, 20.0));
  const auto compared = [&](const char* b, const Words& rest) {
    Words words{"compare", "a.csv", b, "--out", "o"};
    words.insert(words.end(), rest.begin(), rest.end());
    return fantail(words, {.working_folder = folder.path()});
  };
  EXPECT_EQ(compared("enough.csv", {"--require-angle", "1", "--from", "0"}).exit_code, 0);
  EXPECT_EQ(compared("little.csv", {"--require-angle", "1"}).exit_code, 0);  // all that both have
  EXPECT_EQ(compared("little.csv", {"--from", "0"}).exit_code, 0);
  const Outcome outcome = compared("little.csv", {"--require-angle", "1", "--from", "0"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("8.990 s of 10.000 s, is less than the nine tenths"), std::string::npos) << outcome.err;
  EXPECT_NE(content(folder / "o/compare.html").find("Too little to compare"), std::string::npos);

  // A hole in A, and a window from one edge of it to the other.
  std::string holed = line({.end_s = 4.0}, 0.0, 20.0);
  const std::string rest = line({.begin_s = 8.0, .end_s = 20.0}, 0.0, 20.0);
  holed += rest.substr(rest.find('\n') + 1);
  folder.write("holed.csv", holed);
  folder.write("whole.csv", line({.end_s = 20.0}, 0.0, 20.0));
  for (const char* window : {"4:8", "3.9:8.1"}) {
    const Outcome edges = fantail({"compare", "holed.csv", "whole.csv", "--window", window, "--require-angle", "1"},
                                  {.working_folder = folder.path()});
    EXPECT_EQ(edges.exit_code, 1) << window << edges.out;
  }
}

TEST(Compare, ReadsLoggersThatNameAndMeasureOtherwise) {
  const Folder folder;
  folder.write("a.csv", line({}, 0.0, 90.0));
  folder.write("b.csv", line({}, 0.0, std::numbers::pi / 2.0, "phi"));
  const Words words{"compare", "a.csv", "b.csv", "--b-column", "roll_angle_deg=phi", "--b-units", "rad", "--json"};
  const Outcome outcome = fantail(words, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_LT(json::parse(outcome.out)["max_abs_angle_difference_deg"].number(), 1e-3);
}

TEST(Compare, RefusesWhatCannotBeCompared) {
  const std::string early = line({}, 0, 1);
  const std::string late = line({.begin_s = 50, .end_s = 60}, 0, 1);
  Refusal({{"a.csv", early}, {"b.csv", late}}, {"compare", "a.csv", "b.csv"}, 65,
          {"a.csv and b.csv", "no overlap", "0 s to 10 s", "50 s to 60 s"});
  Refusal({{"a.csv", early}}, {"compare", "a.csv", "a.csv", "--align", "angle"}, 65, {"rates do not change"});
  Refusal({{"a.csv", early}}, {"compare", "a.csv", "a.csv", "--from", "20"}, 65, {"a.csv", "20 s", "10 s"});
  Refusal({{"a.csv", early}}, {"compare", "a.csv", "a.csv", "--from", "5", "--to", "3"}, 78, {"5 s", "3 s"});
  Refusal({{"a.csv", early}}, {"compare", "a.csv", "a.csv", "--b", "true"}, 65, {"true_roll_angle_deg"});
  Refusal({{"a.csv", early}}, {"compare", "a.csv", "none.csv"}, 66, {"none.csv"});
}

TEST(Compare, RefusesCommandLinesThatContradictThemselves) {
  const std::string log = line({}, 0, 1);
  const Words files{"compare", "a.csv", "a.csv"};
  for (const Words& rest : {Words{"--shift", "1", "--align", "angle"}, Words{"--window", "control", "--from", "1"},
                            Words{"--from", "nan"}, Words{"--require-angle", "-1"}, Words{"--require-rate", "nan"},
                            Words{"--a", "both"}, Words{"--a-column", "phi"}, Words{"--out", ""}}) {
    Words words = files;
    words.insert(words.end(), rest.begin(), rest.end());
    Refusal({{"a.csv", log}}, words, 64, {rest[0]});
  }
  Refusal({{"a.csv", log}}, {"compare", "a.csv"}, 64, {"B is required"});
}

}  // namespace
}  // namespace fantail::test
