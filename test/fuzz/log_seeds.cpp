// SPDX-License-Identifier: MIT
#include "fuzz/log_seeds.hpp"

#include <array>
#include <cstddef>
#include <span>

#include "core/flight_plan_fields.hpp"
#include "flight_log/log_maker.hpp"
#include "flight_log/made_flight.hpp"

namespace fantail::test {
namespace {

using core::Microseconds;
using flight_log::LogMaker;
using flight_log::MadeFlight;

std::string seed(std::span<const std::byte> bytes) {
  std::string text{'\x01'};
  text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());  // NOLINT: a fuzzer's input is characters
  return text;
}

std::span<const std::byte> frames(const MadeFlight& made, std::size_t from, std::size_t until) {
  const std::size_t begin = from == 0 ? 0 : made.frame_ends[from - 1];
  return std::span{made.bytes}.subspan(begin, made.frame_ends[until - 1] - begin);
}

std::string joined(std::span<const std::byte> a, std::span<const std::byte> b) {
  std::vector<std::byte> both{a.begin(), a.end()};
  for (const std::byte byte : b) {
    both.push_back(byte);
  }
  return seed(both);
}

// The flight law's state in each phase: a checkpoint every twenty ticks, the header before and a few ticks behind.
void add_phases(std::vector<std::string>& seeds) {
  const MadeFlight made =
      flight_log::make_flight({.checkpoint_every = Microseconds{20'000}, .header_every = Microseconds{10'000'000}});
  const auto header = frames(made, 0, 1);
  for (std::size_t from = 1; from + 30 < made.frame_ends.size(); from += 210) {
    seeds.push_back(joined(header, frames(made, from, from + 30)));
  }
}

std::string notes() {
  LogMaker log;
  log.header(Microseconds{0}, flight_log::some_header(), core::default_plan());
  for (std::uint8_t kind = 0; kind < protocol::log_event_kinds; ++kind) {
    log.event({.time = Microseconds{kind}, .kind = static_cast<protocol::LogEventKind>(kind), .number = 3});
  }
  log.health({.time = Microseconds{1'000}, .longest_tick_us = 200, .longest_queue = 3});
  log.record(static_cast<protocol::LogRecord>(77), Microseconds{2'000}, std::array<std::byte, 5>{});
  return seed(log.bytes());
}

std::string other_version() {
  protocol::LogHeader header = flight_log::some_header();
  header.schema = "tick 8\n0 u8 a\n1 i16 b m\n0 u32:3.7 c\n4 f32 d\n0 f64 e\n";
  LogMaker log;
  log.header(Microseconds{0}, header, core::default_plan());
  log.record(protocol::LogRecord::tick, Microseconds{1'000}, std::array<std::byte, 8>{});
  return seed(log.bytes());
}

std::string many_flights() {
  LogMaker log;
  for (int i = 0; i < 20; ++i) {
    log.skip_to(0);
    log.tick({.time = Microseconds{1'000}});
  }
  return seed(log.bytes());
}

}  // namespace

std::vector<std::string> log_seeds() {
  std::vector<std::string> seeds;
  add_phases(seeds);
  seeds.push_back(notes());
  seeds.push_back(other_version());
  seeds.push_back(many_flights());
  const MadeFlight made = flight_log::make_flight({.length = Microseconds{20'000}});
  seeds.push_back(seed(made.bytes));
  seeds.push_back(joined(made.bytes, made.bytes));
  seeds.push_back(joined(frames(made, 0, 4), frames(made, 9, 12)));
  seeds.emplace_back("\x01time_s,phase\n0,safe\n");
  return seeds;
}

}  // namespace fantail::test
