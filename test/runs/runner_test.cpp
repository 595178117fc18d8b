// SPDX-License-Identifier: MIT
#include "runs/runner.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include "test.hpp"

namespace fantail::runs {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

struct Flight {
  std::uint64_t number = 0;
  double value = 0.0;

  friend bool operator==(const Flight&, const Flight&) = default;
};
void fields(RowText& text, Flight& row) { text(row.number, row.value); }

Flight flown(std::uint64_t number) { return {.number = number, .value = 1.0 / (3.0 + static_cast<double>(number))}; }

std::vector<Flight> expected(std::size_t count) {
  std::vector<Flight> rows;
  for (std::uint64_t number = 0; number < count; ++number) {
    rows.push_back(flown(number));
  }
  return rows;
}

const auto unseen = [](std::uint64_t) {};
struct Stop {};

class ManyFlights : public testing::Test {
 protected:
  ManyFlights() { fs::remove_all(place_.folder); }
  ~ManyFlights() override { fs::remove_all(place_.folder); }

  Summary fly(const Folder* folder, unsigned threads, const std::function<void(std::uint64_t)>& look = unseen) {
    return run(rows_into<Flight>(rows_, 8, "row",
                                 [this](std::uint64_t number) {
                                   ++begun_;
                                   std::this_thread::sleep_for(pause_);
                                   return flown(number);
                                 }),
               folder, threads, look);
  }

  Place place_{.folder = fs::temp_directory_path() / ("fantail_many_flights_" + std::to_string(getpid())),
               .identity = {{"seed", "1"}}};
  std::vector<Flight> rows_ = std::vector<Flight>(100);
  std::atomic<int> begun_{0};
  std::chrono::microseconds pause_{0};
};

TEST_F(ManyFlights, AreTheSameWithEveryNumberOfThreadsAndWithAFolderOrNone) {
  for (const unsigned threads : {1U, 3U}) {
    const Summary summary = fly(nullptr, threads);
    EXPECT_EQ(rows_, expected(100));
    EXPECT_EQ(summary.parts, 13U);
    EXPECT_EQ(summary.flights, 100U);
    EXPECT_EQ(summary.flown, 100U);
    rows_ = std::vector<Flight>(100);
  }
  const Folder folder{place_};
  fly(&folder, 2);
  EXPECT_EQ(rows_, expected(100));
}

TEST_F(ManyFlights, ThatAreStoredAreNotFlownAgainAlsoWhenThereAreToBeMore) {
  const Folder folder{place_};
  fly(&folder, 2);
  rows_ = std::vector<Flight>(100);
  EXPECT_EQ(fly(&folder, 2).flown, 0U);
  EXPECT_EQ(rows_, expected(100));
  rows_ = std::vector<Flight>(120);
  EXPECT_EQ(fly(&folder, 2).flown, 24U) << "the part that was not full, and those behind it";
  EXPECT_EQ(rows_, expected(120));
  EXPECT_EQ(folder.damaged(), 0U);
}

TEST_F(ManyFlights, OfADamagedPartAreFlownAgainAndNoOthers) {
  const Folder folder{place_};
  fly(&folder, 2);
  const fs::path part = place_.folder / "parts/row00000008.part";
  fs::resize_file(part, fs::file_size(part) - 3);
  const Summary summary = fly(&folder, 2);
  EXPECT_EQ(summary.damaged, 1U);
  EXPECT_EQ(summary.flown, 8U);
  EXPECT_EQ(rows_, expected(100));
}

TEST_F(ManyFlights, WhoInterruptsThemDoesNotWaitForAPartAndKeepsThoseThatAreFinished) {
  pause_ = 1ms;
  rows_ = std::vector<Flight>(1'000);
  {
    const Folder folder{place_};
    EXPECT_THROW(fly(&folder, 2,
                     [](std::uint64_t done) {
                       if (done > 20) {
                         throw Stop{};
                       }
                     }),
                 Stop);
    EXPECT_LT(begun_, 1'000);
  }
  EXPECT_TRUE(has_parts(place_));
  pause_ = 0ms;
  begun_ = 0;
  const Folder folder{place_};
  const Summary summary = fly(&folder, 2);
  EXPECT_EQ(summary.flown, static_cast<std::uint64_t>(begun_));
  EXPECT_LT(summary.flown, 1'000U);
  EXPECT_EQ(summary.flights, 1'000U);
  EXPECT_EQ(rows_, expected(1'000));
}

TEST_F(ManyFlights, WhoseProgramIsKilledAtAnyMomentComeToTheSameInTheEnd) {
  pause_ = 50us;
  int killed = 0;
  bool is_done = false;
  for (int kill_after_ms = 1; !is_done; ++kill_after_ms) {
    const pid_t child = fork();
    if (child == 0) {
      const Folder folder{place_};
      fly(&folder, 1);
      _exit(0);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{kill_after_ms});
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    is_done = WIFEXITED(status);
    killed += is_done ? 0 : 1;
  }
  EXPECT_GT(killed, 0);
  const Folder folder{place_};
  EXPECT_EQ(fly(&folder, 1).flown, 0U);
  EXPECT_EQ(folder.damaged(), 0U) << "a part is there whole or not at all";
  EXPECT_EQ(rows_, expected(100));
}

TEST_F(ManyFlights, ThatAreEnoughAreTheSameWithEveryNumberOfThreads) {
  pause_ = 200us;
  for (const unsigned threads : {1U, 4U}) {
    Flights flights = rows_into<Flight>(rows_, 8, "", [this](std::uint64_t number) {
      ++begun_;
      std::this_thread::sleep_for(pause_);
      return flown(number);
    });
    std::vector<std::size_t> asked;
    flights.is_enough = [&](std::size_t part) {
      asked.push_back(part);
      EXPECT_EQ(rows_[8 * part], flown(8 * part)) << "taken before";
      return part == 4;
    };
    const Summary summary = run(flights, nullptr, threads, unseen);
    EXPECT_EQ(summary.parts, 5U) << threads;
    EXPECT_EQ(asked, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  }
}

TEST_F(ManyFlights, TroubleInOneComesOutAndThePartsBeforeStay) {
  const Folder folder{place_};
  Flights flights = rows_into<Flight>(rows_, 8, "row", [](std::uint64_t number) {
    if (number == 50) {
      throw std::runtime_error{"a wing fell off"};
    }
    return flown(number);
  });
  EXPECT_THROW((void)run(flights, &folder, 1, unseen), std::runtime_error);
  EXPECT_EQ(fly(&folder, 1).flown, 100U - 48U);
}

TEST(Shards, AreAllFlightsOnceAndInOrderInWholeParts) {
  for (const std::uint64_t flights : {1U, 64U, 65U, 1000U, 10'000'000U}) {
    for (const std::uint64_t of : {1U, 2U, 7U, 1000U}) {
      std::uint64_t next = 0;
      for (std::uint64_t number = 1; number <= of; ++number) {
        const Stretch share = share_of({.number = number, .of = of}, flights, 64);
        EXPECT_TRUE(share.count == 0 || share.first == next) << number << " of " << of;
        EXPECT_EQ(share.first % 64 == 0 || share.count == 0, true);
        next += share.count;
      }
      EXPECT_EQ(next, flights);
    }
  }
}

TEST(Parts, AreNamedByTheirFirstFlight) {
  const auto parts = parts_of({.first = 128, .count = 70}, 64, "x");
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "x00000128");
  EXPECT_EQ(parts[1].name, "x00000192");
  EXPECT_EQ(parts[1].flights.count, 6U);
  EXPECT_TRUE(parts_of({}, 64).empty());
}

}  // namespace
}  // namespace fantail::runs
