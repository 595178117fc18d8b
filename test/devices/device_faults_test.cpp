// SPDX-License-Identifier: MIT
#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

#include "faults.hpp"
#include "test.hpp"
#include "whole_board.hpp"

namespace fantail::devices {
namespace {

// The table of device_faults.txt, run: each row is a device and its faults, each column a phase. Every case begins in a
// copy of a healthy rocket. The file says once that the canards stay at trim after control ended.

using core::Phase;

struct Row {
  std::string device;
  std::string fault;
  std::array<std::string, core::phases> outcomes;
};

const std::string never = ", and that must never be: ";
constexpr double held_deg = 10.0;  // of the reference: what a flight report calls held

/// The fault for so long, as far as it lasts.
void run_with(
    WholeBoard& board, const Device& device, Fault fault, int milliseconds,
    const std::function<bool()>& enough = [] { return false; }) {
  board.forget_faults();
  board.forget_pulses();
  device.set(board, fault, true);
  for (int i = 0; i < milliseconds && !enough(); ++i) {
    if (i == duration_ms(fault)) {
      device.set(board, fault, false);
    }
    board.tick();
  }
}

std::string with(const std::string& what, const std::string& why) { return why.empty() ? what : what + ": " + why; }

std::string in_safe(WholeBoard& board, const Device& device, Fault fault) {
  run_with(board, device, fault, 4'000);
  board.forget_faults();
  board.try_to_arm();
  if (board.record().phase == Phase::armed) {
    return with("armed", board.faults());
  }
  return with("not armed", board.faults().empty() ? board.refusal() : board.faults());
}

std::string in_armed(WholeBoard& board, const Device& device, Fault fault) {
  run_with(board, device, fault, 3'000);
  const core::TickRecord& record = board.record();
  return record.phase == Phase::armed ? with("stays armed", board.faults())
                                      : "safe: " + std::string{name(record.reason)};
}

std::string in_launched(WholeBoard& board, const Device& device, Fault fault) {
  run_with(board, device, fault, 1'500, [&] { return board.record().phase != Phase::launched; });
  const core::TickRecord& record = board.record();
  return record.phase == Phase::controlling ? with("control begins", board.faults())
                                            : "no control: " + std::string{name(record.reason)};
}

std::string in_controlling(WholeBoard& board, const Device& device, Fault fault) {
  run_with(board, device, fault, 2'700);
  const core::TickRecord& record = board.record();
  if (record.phase == Phase::finished) {
    return (board.last_deflection_deg() < 0.01 ? "trim: " : "not at trim: ") + std::string{name(record.reason)};
  }
  const double off_deg = board.roll_deg() - static_cast<double>(record.reference.degrees());
  const bool holds = std::abs(off_deg) <= held_deg && board.roll_error_deg() <= held_deg;
  return with(holds ? "holds" : "controls, does not hold", board.faults());
}

std::string in_finished(WholeBoard& board, const Device& device, Fault fault) {
  run_with(board, device, fault, 300);
  return board.record().phase == Phase::finished && board.last_deflection_deg() < 0.01 ? "trim" : "not at trim";
}

/// What `outcome` says in a copy of this process, which is forgotten.
std::string in_a_copy(const std::function<std::string()>& outcome) {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  const pid_t copy = fork();
  if (copy == 0) {
    const std::string text = outcome();
    const auto written = write(ends[1], text.data(), text.size());
    _exit(written == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 256> part{};
  for (ssize_t size = 0; (size = read(ends[0], part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(size));
  }
  close(ends[0]);
  int status = 0;
  waitpid(copy, &status, 0);
  return status == 0 ? text : "the copy died";
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

// The board's plan waits for no gate: its flight is never Dormant.
constexpr std::size_t phases_told = core::phases - 1;

std::vector<Row> table() {
  std::ifstream page{FANTAIL_DEVICE_FAULTS};
  std::vector<Row> rows;
  for (std::string line; std::getline(page, line);) {
    std::vector<std::string> cells;
    std::istringstream stream{line};
    for (std::string cell; std::getline(stream, cell, '|');) {
      cells.push_back(trimmed(cell));
    }
    if (cells.size() == 2 + phases_told && devices.contains(cells[1])) {
      Row row{.device = cells[1], .fault = {}, .outcomes = {}};
      std::copy(cells.begin() + 3, cells.end(), row.outcomes.begin());
      row.outcomes[static_cast<std::size_t>(Phase::finished)] = "trim";
      std::istringstream named{cells[2]};
      for (std::string fault; std::getline(named, fault, ',');) {
        row.fault = trimmed(fault);
        rows.push_back(row);
      }
    }
  }
  return rows;
}

/// A star at the end stands for whatever comes, but not for what must never be.
bool is_as_told(const std::string& found, const std::string& told) {
  const bool open = told.ends_with("*");
  const std::string begin = told.substr(0, told.size() - (open ? 1 : 0));
  return open ? found.starts_with(begin) && found.find(never) == std::string::npos : found == told;
}

class DeviceFaults : public testing::Test {
 protected:
  using Outcome = std::string (*)(WholeBoard&, const Device&, Fault);

  void expect_column(Phase phase, Outcome outcome) {
    const auto column = static_cast<std::size_t>(phase);
    std::string all_rows;
    for (const Row& row : table()) {
      const Device& device = devices.at(row.device);
      ASSERT_TRUE(faults.contains(row.fault)) << row.fault;
      const std::string found = in_a_copy([&] {
        std::string text = outcome(board, device, faults.at(row.fault));
        text += board.largest_deflection_deg() > limit_deg + 0.05 ? never + "a command beyond the limit" : "";
        return text + (board.every_tick_was_completed() ? "" : never + "a tick that did not end");
      });
      EXPECT_TRUE(is_as_told(found, row.outcomes[column]))
          << "it is: " << found << "; told: " << row.outcomes[column] << "; of " << row.device << ", " << row.fault
          << ", " << name(phase);
      if (std::getenv("FANTAIL_DEVICE_TABLE") != nullptr) {
        std::printf("CELL|%s|%s|%zu|%s\n", row.device.c_str(), row.fault.c_str(), column, found.c_str());
      }
    }
  }
  void arm() {
    board.run(4'000);
    board.try_to_arm();
    ASSERT_EQ(board.record().phase, Phase::armed) << board.refusal() << " " << board.faults();
  }
  void fly_to(Phase phase) {
    arm();
    board.run(3'000);
    board.ignite();
    for (int i = 0; i < 60'000 && board.record().phase != phase; ++i) {
      board.tick();
    }
    ASSERT_EQ(board.record().phase, phase);
  }

  const double limit_deg = static_cast<double>(core::default_plan().controller.canard_limit.degrees());
  WholeBoard board;
};

TEST_F(DeviceFaults, TheTableHasEachFaultOfEachDevice) {
  std::map<std::string, std::vector<std::string>> found;
  for (const Row& row : table()) {
    found[row.device].push_back(row.fault);
  }
  for (const auto& [name, device] : devices) {
    ASSERT_TRUE(found.contains(name)) << name;
    EXPECT_EQ(found[name].size(), device.faults.size()) << name;
    for (const std::string& fault : found[name]) {
      EXPECT_NE(std::ranges::find(device.faults, faults.at(fault)), device.faults.end()) << name << ", " << fault;
    }
  }
}

TEST_F(DeviceFaults, FromPowerUp) { expect_column(Phase::safe, in_safe); }

TEST_F(DeviceFaults, WhileArmed) {
  arm();
  expect_column(Phase::armed, in_armed);
}

TEST_F(DeviceFaults, AfterTheLaunchWasDetected) {
  fly_to(Phase::launched);
  expect_column(Phase::launched, in_launched);
}

TEST_F(DeviceFaults, UnderControl) {
  fly_to(Phase::controlling);
  board.run(300);
  expect_column(Phase::controlling, in_controlling);
}

TEST_F(DeviceFaults, WhenControlIsOver) {
  fly_to(Phase::finished);
  board.run(2'000);
  expect_column(Phase::finished, in_finished);
}

// The driver of the switch needs 50 ms to know it, and what it says meanwhile is not "open".
TEST(PowerUp, WithTheSwitchClosedDoesNotArmBeforeItWasOpened) {
  WholeBoard board;
  board.set_switch(true);
  board.run(4'000);
  board.try_to_arm();
  EXPECT_EQ(board.record().phase, core::Phase::safe);
  EXPECT_EQ(board.refusal(), "switch_not_cycled");
  board.set_switch(false);
  board.run(100);
  board.try_to_arm();
  EXPECT_EQ(board.record().phase, core::Phase::armed) << board.refusal();
}

}  // namespace

}  // namespace fantail::devices
