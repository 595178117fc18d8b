// SPDX-License-Identifier: MIT
#include <fstream>

#include "bench/perform.hpp"
#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "sil/bench_at_world.hpp"
#include "sil/bus_filter.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

// The rocket's clock against what its reports show and what this PC did: no sentence may say more than is known.

/// The sheet of canard 1 alone, or why there is none.
struct Result {
  std::optional<bench::Sheet> sheet;
  std::string complaint;
  bool too_slow = false;
};

Result limits_of_canard_1(BenchAtWorld& rocket, link::Place& place) {
  link::AvionicsLink link{place.bus()};
  try {
    link::await_avionics(place, link);
    for (int i = 0; i < 300; ++i) {
      place.wait(10 * millisecond);
      link.listen(place.now());
    }
    link::Session session{place, link, 5};
    const bench::Exercise exercise = bench::Exercise::limits_of(
        bench::bounds(link.reported<protocol::LimitReport>("canard limits"), session.trims()), 0);
    const link::Recording recording = bench::perform(exercise, session, link, [](double) {});
    EXPECT_TRUE(session.close());
    return {.sheet = bench::examine(recording, exercise, rocket.scenario.vehicle.canard_tolerances, {}),
            .complaint = {}};
  } catch (const bench::TooSlow& error) {
    return {.sheet = {}, .complaint = error.what(), .too_slow = true};
  } catch (const std::runtime_error& error) {
    return {.sheet = {}, .complaint = error.what()};
  }
}

// HeartbeatReport has 24 bits for the milliseconds since power-up, from bit 8 on.
void turn_on_earlier(hal::CanFrame& frame, std::uint32_t by_ms) {
  if (frame.id != 0x140) {
    return;
  }
  const std::uint32_t uptime_ms = (frame.data[1] | frame.data[2] << 8U | frame.data[3] << 16U) + by_ms;
  for (unsigned byte = 0; byte < 3; ++byte) {
    frame.data[1 + byte] = static_cast<std::uint8_t>(uptime_ms >> (8U * byte));
  }
}

// 2^24 ms are 4 h 39 min 37.216 s, and the exercise lasts from some 5 to 10 s after this rocket's power-up.
TEST(RocketTime, AnExerciseInWhichTheUptimeBeginsAgainAtZeroIsJudgedAsAnyOther) {
  for (const std::uint32_t wrap_at_ms : {1'000U, 3'000U, 6'000U, 7'044U, 8'500U}) {
    BenchAtWorld rocket{"bench_healthy"};
    BusFilter place{rocket, [&](hal::CanFrame& frame) {
                      turn_on_earlier(frame, (1U << 24U) - wrap_at_ms);
                      return true;
                    }};
    const Result result = limits_of_canard_1(rocket, place);
    ASSERT_TRUE(result.sheet) << "it wraps after " << wrap_at_ms << " ms: " << result.complaint;
    EXPECT_TRUE(result.sheet->passed());
  }
}

TEST(RocketTime, ANodeThatIsStoppedForAWhileDoesNotMakeThePcSlow) {
  for (const int stop_ms : {30, 70, 300, 1'500}) {
    BenchAtWorld rocket{"bench_healthy"};
    rocket.after_tick = [&, ticks = 0]() mutable {
      ticks += 1;
      rocket.stopped = ticks % 7'000 >= 7'000 - stop_ms;
    };
    const Result result = limits_of_canard_1(rocket, rocket);
    EXPECT_FALSE(result.too_slow) << stop_ms << " ms: " << result.complaint;
    EXPECT_FALSE(says(result.complaint, "too slow")) << result.complaint;
    if (result.sheet) {
      EXPECT_TRUE(result.sheet->passed());
    }
  }
}

TEST(RocketTime, ANodeThatStaysStoppedIsSaidToHaveStoppedReporting) {
  BenchAtWorld rocket{"bench_healthy"};
  rocket.after_tick = [&, ticks = 0]() mutable { rocket.stopped = ++ticks > 7'000; };
  const Result result = limits_of_canard_1(rocket, rocket);
  EXPECT_TRUE(says(result.complaint, "stopped") && !result.too_slow) << result.complaint;
}

// The rocket lives on and nothing of it arrives: its clock goes on by what no report shows.
TEST(RocketTime, ReportsThatDoNotArriveAreNotBlamedOnAPcThatListened) {
  for (const int missing_ms : {48, 160}) {
    BenchAtWorld rocket{"bench_healthy"};
    BusFilter place{rocket, [&](hal::CanFrame&) {
                      const auto now_ms = rocket.now().count() / 1'000;
                      return now_ms < 7'000 || now_ms >= 7'000 + missing_ms;
                    }};
    const Result result = limits_of_canard_1(rocket, place);
    EXPECT_FALSE(result.too_slow);
    EXPECT_TRUE(says(result.complaint, "canards")) << result.complaint;
    EXPECT_FALSE(says(result.complaint, "too slow")) << result.complaint;
    // Only the longer one is long enough to be a silence, which is told first.
    const std::string told_ms = figures(result.complaint).at(0);
    EXPECT_EQ(told_ms.size() == 3 && told_ms.starts_with("16"), missing_ms == 160) << result.complaint;
  }
}

TEST(RocketTime, APcThatPausedIsCalledTooSlowAndItsPauseIsNamed) {
  BenchAtWorld rocket{"bench_healthy"};
  BusFilter place{rocket, [&](hal::CanFrame&) { return true; }};
  rocket.after_tick = [&, ticks = 0]() mutable {
    if (++ticks == 7'000) {
      rocket.after_tick = nullptr;
      rocket.wait(75 * millisecond);  // of 225 and more frames the PC's queue keeps 64
    }
  };
  const Result result = limits_of_canard_1(rocket, place);
  EXPECT_TRUE(result.too_slow) << result.complaint;
  EXPECT_TRUE(figures(result.complaint).back().starts_with("7")) << result.complaint;
}

// Flights that RocketPy computed (test/validation), flown here with the same rocket.

std::ifstream file(const std::string& name) {
  return std::ifstream{std::string{FANTAIL_TEST_SOURCE} + "/test/validation/" + name};
}

std::vector<input::Override> rocket() {
  std::vector<input::Override> all;
  std::ifstream in = file("peer_rocket.txt");
  for (std::string line; std::getline(in, line);) {
    all.push_back(input::parse_override(line));
  }
  return all;
}

using Figures = std::map<std::string, double>;

std::vector<Figures> peer_flights() {
  std::ifstream in = file("peer_flights.csv");
  std::string line;
  std::getline(in, line);
  std::vector<std::string> names;
  std::istringstream header{line};
  for (std::string name; std::getline(header, name, ',');) {
    names.push_back(name);
  }
  std::vector<Figures> flights;
  while (std::getline(in, line)) {
    std::istringstream row{line};
    Figures& flight = flights.emplace_back();
    for (const std::string& name : names) {
      std::string cell;
      std::getline(row, cell, ',');
      flight[name] = std::stod(cell);
    }
  }
  return flights;
}

TEST(PeerFlight, MovesAsRocketPysRocketDoes) {
  const std::vector<Figures> flights = peer_flights();
  ASSERT_GE(flights.size(), 8U);
  for (const Figures& peer : flights) {
    std::vector<input::Override> changes = rocket();
    ASSERT_GE(changes.size(), 10U);
    for (const auto& [key, name] : {std::pair{"launch_guide.tilt_deg", "guide_tilt_deg"},
                                    {"launch_guide.azimuth_deg", "guide_azimuth_deg"},
                                    {"wind.speed_m_s", "wind_m_s"},
                                    {"wind.from_deg", "wind_from_deg"}}) {
      changes.push_back(input::parse_override(std::string{key} + "=" + std::to_string(peer.at(name))));
    }
    const flight::Flight flight = fly::fly_scenario(input::load_scenario("tasha3_launch2", changes));
    const flight::PathPoint* top = flight::point_at(flight.path, flight.events.apogee_s.value());
    ASSERT_NE(top, nullptr);
    double top_speed_m_s = 0.0;
    for (const flight::PathPoint& point : flight.path) {
      top_speed_m_s = std::max(top_speed_m_s, std::hypot(point.north_m_s, point.east_m_s, point.up_m_s));
    }
    // What is left in wind: RocketPy's lift goes with the angle of attack, ours with its sine.
    const bool calm = peer.at("wind_m_s") == 0.0;
    const std::string flown = "tilt " + std::to_string(peer.at("guide_tilt_deg")) + " deg, wind " +
                              std::to_string(peer.at("wind_m_s")) + " m/s";
    EXPECT_NEAR(top->height_m, peer.at("apogee_m"), (calm ? 0.0005 : 0.002) * peer.at("apogee_m")) << flown;
    EXPECT_NEAR(top_speed_m_s, peer.at("top_speed_m_s"), 0.0005 * peer.at("top_speed_m_s")) << flown;
    EXPECT_NEAR(top->north_m, peer.at("north_m"), calm ? 0.3 : 1.0) << flown;
    EXPECT_NEAR(top->east_m, peer.at("east_m"), calm ? 0.3 : 1.0) << flown;
    EXPECT_NEAR(text::degrees(top->tilt_rad), peer.at("tilt_at_apogee_deg"), calm ? 0.2 : 0.6) << flown;
  }
}

}  // namespace

}  // namespace fantail::sil
