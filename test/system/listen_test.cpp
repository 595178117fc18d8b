// SPDX-License-Identifier: MIT
#include <filesystem>

#include <fmt/core.h>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

constexpr double g = 9.80665;

// 5 s on the pad, 5 g for 2 s, free fall; 100 samples a second.
std::string made_log(const std::string& header, const std::function<std::string(double t, double axial)>& row) {
  std::string text = header + "\n";
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.01 * i;
    text += row(t, i < 500 ? g : i < 700 ? 5.0 * g : 0.0) + "\n";
  }
  return text;
}

const std::string made =
    made_log("ms,Ay,alt", [](double t, double axial) { return fmt::format("{},{},0", 1e3 * t, -axial / g); });
const Words of_made{"listen", "log.csv", "--columns", "time=ms:ms,axial=-Ay:g,height=alt:ft"};

double phase_s(const Json& json, const std::string& phase) {
  for (const Json& event : json["phases"]) {
    if (event["phase"].text() == phase) {
      return event["time_s"].number();
    }
  }
  return std::nan("");
}

// The flight's own file: the law that made its phases hears them again, from nothing but axial force and roll rate.
TEST(Listen, HearsTheSimulatedFlightAsItFlew) {
  const Folder folder;
  ASSERT_EQ(fantail({"fly", "tasha3_launch2"}, {.working_folder = folder.path()}).exit_code, 0);
  const Outcome outcome =
      fantail({"listen", "out/tasha3_launch2/flight.csv", "--json"}, {.working_folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = json::parse(outcome.out);
  EXPECT_EQ(json["finding"].text(), "heard");
  EXPECT_NEAR(json["interval_s"].number(), 0.001, 1e-9);
  std::map<std::string, double> flown;
  std::istringstream rows{content(folder / "out/tasha3_launch2/flight.csv")};
  std::string line;
  std::getline(rows, line);
  while (std::getline(rows, line)) {
    const std::size_t comma = line.find(',');
    const std::string phase = line.substr(comma + 1, line.find(',', comma + 1) - comma - 1);
    flown.emplace(phase, std::stod(line.substr(0, comma)));
  }
  for (const char* const phase : {"launched", "controlling", "finished"}) {
    EXPECT_NEAR(phase_s(json, phase), flown.at(phase), 0.0015) << phase;
  }
  EXPECT_EQ(json["false_detections_s"].size(), 0U);
  EXPECT_NEAR(json["law"]["apogee_m"].number(), json["log_itself"]["apogee_m"].number(), 3.0);
}

TEST(Listen, WritesAPageAndPrintsTheClosedForm) {
  const Folder folder;
  folder.write("log.csv", made);
  const Outcome outcome = fantail(of_made, {.working_folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Launch detected 0.1"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("100 samples a second"), std::string::npos);
  EXPECT_EQ(folder.listing(), (Words{"log.csv", "out", "out/listen", "out/listen/log", "out/listen/log/listen.html",
                                     "out/listen/log/listen.json"}));
  EXPECT_NE(content(folder / "out/listen/log/listen.html").find("</html>"), std::string::npos);
  const Json json = json::parse(content(folder / "out/listen/log/listen.json"));
  EXPECT_NEAR(json["law"]["top_speed_m_s"].number(), 8.0 * g, 0.5);
  EXPECT_NEAR(json["law"]["apogee_m"].number(), 40.0 * g, 2.0);
  EXPECT_NEAR(json["law"]["apogee_s"].number(), 15.0, 0.06);
}

TEST(Listen, OverwritesThePageOfTheSameFileAndNoOthers) {
  const Folder folder;
  folder.write("a/log.csv", made);
  folder.write("b/log.csv", made);
  const auto listen_to = [&](const std::string& log) {
    Words words = of_made;
    words[1] = log;
    return fantail(words, {.working_folder = folder.path()});
  };
  const auto whose = [&](const std::string& name) {
    return json::parse(content(folder / ("out/listen/" + name + "/listen.json")))["log"].text();
  };
  EXPECT_EQ(listen_to("a/log.csv").err, "");
  const Outcome other = listen_to("b/log.csv");
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_NE(
      other.err.find("out/listen/log has the page of another file, a/log.csv, which is not overwritten. This page is "
                     "in out/listen/log_2"),
      std::string::npos)
      << other.err;
  EXPECT_NE(other.out.find("page     out/listen/log_2/listen.html"), std::string::npos) << other.out;
  EXPECT_EQ(whose("log"), "a/log.csv");
  EXPECT_EQ(whose("log_2"), "b/log.csv");

  EXPECT_EQ(listen_to("./b/../a/log.csv").err, "") << "the same file by another path";
  EXPECT_EQ(whose("log"), "./b/../a/log.csv");
  EXPECT_EQ(listen_to("b/log.csv").exit_code, 0);
  EXPECT_EQ(whose("log_2"), "b/log.csv");
  EXPECT_FALSE(std::filesystem::exists(folder / "out/listen/log_3"));

  Words there = of_made;
  there[1] = "b/log.csv";
  there.insert(there.end(), {"--out", "out/listen/log"});
  EXPECT_EQ(fantail(there, {.working_folder = folder.path()}).err, "");
  EXPECT_EQ(whose("log"), "b/log.csv") << "asked for by name";
}

// A hand in the guide, 3 g above the pad's for a quarter of a second; the launch comes two seconds later.
TEST(Listen, TellsABumpFromTheLaunchAfterIt) {
  const Folder folder;
  std::string log = "s,a\n";
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.01 * i;
    const double axial = t > 8.0 && t < 8.25 ? 4.0 : t < 10.0 ? 1.0 : t < 11.5 ? 6.0 : -0.5;
    log += fmt::format("{:.2f},{}\n", t, axial);
  }
  folder.write("log.csv", log);
  const Outcome outcome =
      fantail({"listen", "log.csv", "--columns", "time=s:s,axial=a:g", "--json"}, {.working_folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = json::parse(outcome.out);
  EXPECT_EQ(json["finding"].text(), "imagined_and_missed");
  EXPECT_NEAR(json["lift_off_s"].number(), 10.0, 0.011);
  EXPECT_NEAR(json["false_detections_s"][0].number(), 8.1, 0.02);
  EXPECT_EQ(json["doubts"].size(), 0U);
}

TEST(Listen, ReadsAnExportOfAltosUi) {
  const Folder folder;
  const std::string log = made_log(
      "#version,serial,flight,call,time,state,acceleration,altitude,height,altitude", [](double t, double axial) {
        return fmt::format("6, 1, 2,CALL, {:.2f}, 3, {:.2f}, 300.0, 1.0, 301.0", t, axial - g);
      });
  folder.write("log.csv", log);
  const Outcome outcome = fantail({"listen", "log.csv", "--json"}, {.working_folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NEAR(json::parse(outcome.out)["law"]["top_speed_m_s"].number(), 8.0 * g, 0.5);
}

TEST(Listen, SaysOfWhichColumnsAMapIs) {
  const Folder folder;
  folder.write("log.csv", made);
  folder.write("cats.csv", made_log("ts,Ax,Ay,Az,Gx,Gy,Gz,b", [](double t, double axial) {
                 return fmt::format("{},0,{},0,0,0,0,{}", t, -axial, axial);
               }));
  const auto said = [&](const Words& words) {
    const std::string out = fantail(words, {.working_folder = folder.path()}).out;
    return out.substr(0, out.find('\n'));
  };
  Words words = of_made;
  words.insert(words.end(), {"--map", "cats"});
  EXPECT_EQ(said(words).find("cats"), std::string::npos) << "its columns are none of that file's\n" << said(words);
  EXPECT_TRUE(said({"listen", "cats.csv"}).ends_with(", columns of the map cats, which fits them"))
      << said({"listen", "cats.csv"});
  const Words mixed{"listen", "cats.csv", "--columns", "axial=b:m/s2"};
  EXPECT_TRUE(said(mixed).ends_with(", columns as typed, the rest from columns of the map cats, which fits them"))
      << said(mixed);
}

TEST(Listen, FollowsAnotherPlan) {
  const Folder folder;
  folder.write("log.csv", made);
  Words words = of_made;
  words.insert(words.end(), {"--plan", "tasha3_launch1", "--json"});
  const Outcome outcome = fantail(words, {.working_folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["plan"].text(), "tasha3_launch1");
}

TEST(Listen, RefusesWhatItCannotHear) {
  const auto with = [](const std::string& columns) { return Words{"listen", "log.csv", "--columns", columns}; };
  Refusal({}, of_made, 66, {"log.csv", "no such file"});
  Refusal({{"log.csv", ""}}, of_made, 65, {"log.csv", "is empty"});
  Refusal({{"log.csv", made}}, {"listen", "log.csv"}, 65, {"no known logger", "--columns time=", "ms, Ay, alt"});
  Refusal({{"log.csv", made}}, with("time=ms:ms,axial=ay:g"), 65, {"no column ay (did you mean Ay?)", "ms, Ay, alt"});
  Refusal({{"log.csv", made}}, with("time=ms:ms,axial=Ay:m/s"), 78, {"\"m/s\" is not a unit of axial", "m/s2, g"});
  Refusal({{"log.csv", made}}, with("time=ms:ms,axal=Ay:g"), 78, {"did you mean axial?"});
  Refusal({{"log.csv", made + "20000,1,0\n19000,1,0\n"}}, of_made, 65,
          {"log.csv:2004", "ms is 19000 after", "in line 2003: time must increase"});
  Refusal({{"log.csv", made}}, with("time=alt:s,axial=Ay:g"), 65, {"1 sample of the axial"});
  Refusal({{"log.csv", made}}, with("time=ms:us,axial=-Ay:g"), 65,
          {"it is 20 ms, shorter than 1 s", "check that the time ms is in us"});
  Refusal({{"log.csv", made}}, {"listen", "log.csv", "--map", "altus"}, 64, {"altus", "altos", "px4"});
  Refusal({{"log.csv", made}}, {"listen", "log.csv", "--map", "altos"}, 65, {"no column time", "--columns time="});
  Refusal({{"log.csv", made}}, {"listen", "log.csv", "--barometer", "log.csv"}, 64, {"--barometer-columns"});
  Refusal({{"log.csv", made}},
          {"listen", "log.csv", "--columns", "time=ms:ms,axial=-Ay:g", "--barometer", "log.csv", "--barometer-columns",
           "time=ms:ms,speed=alt:m/s"},
          64, {"the height is missing"});
  Refusal({{"log.ftl", "x"}}, {"listen", "log.ftl", "--map", "px4"}, 65,
          {"log.ftl", "files that end in .ftl are not read as tables"});
}

TEST(Listen, RefusesAnEmptyWordForColumnsOrBarometer) {
  for (const char* option : {"--columns", "--barometer", "--barometer-columns"}) {
    Refusal({{"log.csv", made}}, {"listen", "log.csv", option, ""}, 64, {option, "is empty"});
  }
}

}  // namespace
}  // namespace fantail::test
