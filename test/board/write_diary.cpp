// SPDX-License-Identifier: MIT
#include "write_diary.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "board_flight.hpp"

namespace fantail::board {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out{file, std::ios::binary};
  out << text;
  out.close();
  if (!out) {
    throw std::system_error{errno, std::generic_category(), file.string()};
  }
}

std::string pulses_of(const Board& board) {
  std::string text = "canard,begin_s,width_us,whole\n";
  for (const HeardPulse& pulse : board.chip.pulses()) {
    text += fmt::format("{},{:.9f},{:.3f},{}\n", pulse.line + 1, pulse.begin_s, pulse.width_us, pulse.whole ? 1 : 0);
  }
  return text;
}

std::string traffic_of(const Board& board) {
  std::string text;
  for (const auto& [time_s, frame] : board.traffic) {
    text += fmt::format("({:.6f}) board {:03X}#", time_s, frame.id);
    for (std::size_t i = 0; i < frame.length; ++i) {
      text += fmt::format("{:02X}", frame.data[i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

void write_diary(BoardServer& server, const std::filesystem::path& folder) {
  if (const Board* board = server.board()) {
    write(folder / "board_pulses.csv", pulses_of(*board));
    write(folder / "board_can.log", traffic_of(*board));
    write(folder / "board_console.txt", server.said());
    std::vector<Complaint> in_time = board->processor.complaints;
    for (const Board::Restart& each : board->restarts) {
      if (each.kind != ResetKind::power_on) {
        in_time.push_back({each.time_s, fmt::format("a reset: {}", name(each.kind))});
      }
    }
    std::ranges::stable_sort(in_time, {}, &Complaint::time_s);
    std::string complaints;
    for (const Complaint& each : in_time) {
      complaints += fmt::format("{:.6f} s: {}\n", each.time_s, each.what);
    }
    for (const std::string& each : board->violations()) {
      complaints += each + '\n';
    }
    if (!complaints.empty()) {
      write(folder / "board_complaints.txt", complaints);
    }
  }
}

}  // namespace fantail::board
