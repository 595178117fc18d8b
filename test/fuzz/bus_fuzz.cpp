// SPDX-License-Identifier: MIT
// Any frames on a CAN bus, as the programs on a PC take them: the gateway, a bench that reads plan and record back, and
// what splits a record into flights. Figures keep their promises, or somebody is told why not. Nothing else may happen.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "avionics/can_frame.hpp"
#include "chosen_input.hpp"
#include "gateway/gateway.hpp"
#include "link/log_download.hpp"
#include "link/log_reader.hpp"
#include "link/plan_transfer.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::fuzz {
namespace {

constexpr std::size_t frame_size = 12;  // milliseconds before it, identifier, length, data

/// Frames that come by their own clock; what is sent is lost. Who waits here takes no time.
class FuzzedBus final : public hal::CanBus, public link::Place {
 public:
  explicit FuzzedBus(std::string_view bytes) : bytes_{bytes} {}

  bool send(const hal::CanFrame&) override { return true; }
  std::optional<hal::CanFrame> receive() override {
    if (bytes_.size() < frame_size || now_ < due()) {
      return std::nullopt;
    }
    hal::CanFrame frame{.id = byte(1) * 256U + byte(2), .length = std::min<std::uint8_t>(byte(3), 8)};
    for (std::size_t i = 0; i < frame.data.size(); ++i) {
      frame.data[i] = byte(4 + i);
    }
    came_ = due();
    bytes_.remove_prefix(frame_size);
    return frame;
  }
  [[nodiscard]] hal::CanState state() const override { return hal::CanState::error_active; }
  [[nodiscard]] hal::CanCounters counters() const override { return {}; }

  [[nodiscard]] hal::CanBus& bus() override { return *this; }
  [[nodiscard]] hal::Microseconds now() const override { return now_; }
  void wait(hal::Microseconds at_most) override { now_ += std::max(at_most, hal::Microseconds{1'000}); }
  [[nodiscard]] bool has_more() const { return bytes_.size() >= frame_size; }

 private:
  [[nodiscard]] std::uint8_t byte(std::size_t i) const { return static_cast<std::uint8_t>(bytes_[i]); }
  [[nodiscard]] hal::Microseconds due() const { return came_ + hal::Microseconds{1'000 * byte(0)}; }

  std::string_view bytes_;
  hal::Microseconds now_{};
  hal::Microseconds came_{};
};

struct Counted final : telemetry::Sink {
  void send(const telemetry::Packet& packet) override { require(decode(packet.channel, packet.content()).has_value()); }
};

void gateway(std::string_view bytes) {
  FuzzedBus bus{bytes};
  Counted sink;
  gateway::Gateway passed{bus, sink};
  while (bus.has_more()) {
    bus.wait(hal::Microseconds{1'000});
    passed.listen(bus.now());
  }
  const link::LinkFigures& heard = passed.heard();
  require(heard.frames + heard.foreign + heard.damaged <= bytes.size() / frame_size);
}

template <typename Read>
void bench(std::string_view bytes, const Read& read) {
  FuzzedBus bus{bytes};
  link::AvionicsLink link{bus};
  try {
    read(bus, link);
  } catch (const std::runtime_error& error) {
    require_sentence(error.what());
  }
}

// The first byte chooses what the rest is.
void read(std::uint8_t choice, const std::string& bytes) {
  switch (choice % 4) {
    case 0: gateway(bytes); return;
    case 1:
      bench(bytes, [](FuzzedBus& bus, link::AvionicsLink& link) {
        link::LogReader reader{bus, link};
        const link::LogInfo info = reader.info();
        require(reader.read(0, std::max(info.used_bytes, 1U)).size() <= std::max(info.used_bytes, 1U));
      });
      return;
    case 2:
      bench(bytes, [](FuzzedBus& bus, link::AvionicsLink& link) {
        require(!core::validate(link::read_plan_in_force(bus, link).plan));
      });
      return;
    default: {
      std::size_t end = 0;
      for (const link::RecordedFlight& flight : link::split_flights(std::as_bytes(std::span{bytes}))) {
        require(flight.begin >= end && flight.end >= flight.begin && flight.end <= bytes.size());
        end = flight.end;
      }
    }
  }
}

std::string in_time(char milliseconds, const protocol::BusFrame& frame) {
  const hal::CanFrame whole = avionics::can_frame(frame);
  std::string text{milliseconds, static_cast<char>(whole.id >> 8U), static_cast<char>(whole.id),
                   static_cast<char>(whole.length)};
  std::ranges::transform(whole.data, std::back_inserter(text),
                         [](std::uint8_t byte) { return static_cast<char>(byte); });
  return text;
}

}  // namespace

std::vector<std::string> seeds() {
  std::string reports;
  for (std::uint8_t i = 0; i < 4; ++i) {
    reports += in_time(1, encode(protocol::StatusReport{})) + in_time(0, encode(protocol::CommandReport{}, i)) +
               in_time(0, encode(protocol::EncoderReport{}, i)) + in_time(1, encode(protocol::HeartbeatReport{}));
  }
  const std::string replies =
      in_time(1, encode(protocol::LogReply{})) + in_time(1, encode(protocol::LogData{})) + reports;
  return {std::string(1, '\0') + reports, std::string{"\1"} + replies, std::string{"\2"} + replies,
          std::string{"\3\xA5\x01"} + std::string(60, '\xFF')};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fantail::fuzz::read_chosen(data, size, fantail::fuzz::read);
}
