// SPDX-License-Identifier: MIT
// For dbc_test.py. `bus_lines catalogue` prints every frame of the bus with its worst latency. Without arguments each
// line of standard input is a frame (010#0011223344556677); the answer is the message in the words of the database with
// the frame that it encodes to, or why it was refused. `bus_lines session` prints the number of the session that is
// open.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "bus_rig.hpp"
#include "protocol/bus_catalogue.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/bus_load.hpp"

namespace {

using namespace fantail;
using namespace fantail::protocol;

void print(const char* name, double value) { std::printf(" %s=%.12g", name, value); }
void print(const std::string& name, double value) { print(name.c_str(), value); }

template <typename Enum>
  requires std::is_enum_v<Enum>
void print(const std::string& name, Enum value) {
  print(name, static_cast<double>(value));
}

void print_degrees(const std::string& name, core::Angle angle) { print(name, static_cast<double>(angle.degrees())); }

std::string numbered(const char* name, std::size_t i) { return std::string{name} + "_" + std::to_string(i + 1); }

void print_angles(const PerCanard& angles, const char* given) {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    print_degrees(numbered("canard", i), angles[i].value_or(core::Angle{}));
    print(numbered(given, i), angles[i].has_value());
  }
}

void print_signals(const BenchRequest& m) { print_angles(m.angle, "asked"); }
void print_signals(const CommandReport& m) { print_angles(m.angle, "driven"); }
void print_signals(const EncoderReport& m) { print_angles(m.angle, "valid"); }
void print_signals(const BenchSession& m) {
  print("action", m.action);
  print("session", m.session);
}
void print_signals(const ArmRequest& m) {
  print("action", m.action);
  print("nonce", m.nonce);
}
void print_signals(const PlanBegin& m) {
  print("size", m.size);
  print("block_crc", m.block_crc);
}
void print_data(const auto& m) {
  print("index", m.index);
  for (std::size_t i = 0; i < m.bytes.size(); ++i) {
    print("byte_" + std::to_string(i), std::to_integer<int>(m.bytes[i]));
  }
}
void print_signals(const LogRequest& m) {
  print("action", m.action);
  print("tag", m.tag);
  print("offset", m.offset);
  print("size", m.size);
}
void print_signals(const PlanData& m) { print_data(m); }
void print_signals(const LogData& m) { print_data(m); }
void print_signals(const StatusReport& m) {
  print("phase", m.phase);
  print("reason", m.reason);
  print("command_status", m.command_status);
  print_degrees("roll_command", m.roll_command);
  for (std::size_t i = 0; i < m.limited.size(); ++i) {
    print(numbered("limited", i), m.limited[i]);
  }
  print("saturated", m.saturated);
  print("arm_switch_closed", m.arm_switch_closed);
  print("at_rest", m.at_rest);
  print("session_open", m.session_open);
  print("self_test_running", m.self_test_running);
  print("timing_fault", m.timing_fault);
  print("every_tick", m.every_tick);
  print("abort", m.abort);
  print_degrees("gyro_bias", core::Angle::from_radians(m.gyro_bias_rad_s));
}
void print_signals(const MotionReport& m) {
  print_degrees("roll_angle", m.roll_angle);
  print_degrees("roll_rate", core::Angle::from_radians(m.roll_rate_rad_s));
  print("height", static_cast<double>(m.height_m));
  print("speed", static_cast<double>(m.speed_m_s));
}
void print_signals(const SessionReply& m) {
  print("state", m.state);
  print("reason", m.reason);
  print("session", m.session);
}
void print_signals(const ArmReply& m) {
  print("self_test", m.self_test);
  print("failure", m.failure);
  print("canard", m.canard ? static_cast<double>(*m.canard) + 1 : 0);
  print("refusal", m.refusal);
  print("nonce_given", m.nonce.has_value());
  print("nonce", m.nonce.value_or(0));
  print("abort_input", m.abort_input);
}
void print_signals(const PlanReply& m) {
  print("state", m.state);
  print("fault", m.fault);
  print("next_index", m.next_index);
  print("block_fault", m.block_fault ? static_cast<double>(*m.block_fault) + 1 : 0);
  print("field_given", m.field.has_value());
  print("field", m.field.value_or(0));
}
void print_signals(const LogReply& m) {
  print("state", m.state);
  print("fault", m.fault);
  print("tag", m.tag);
  print("number", m.number);
  print("extra", m.extra);
}
void print_signals(const HealthReport& m) {
  for (std::size_t i = 0; i < m.verdicts.size(); ++i) {
    print(numbered("verdict", i), m.verdicts[i]);
  }
  print("gyro", m.gyro);
  print("accelerometer", m.accelerometer);
  print("bus_state", m.bus_state);
  print("unsent", m.unsent);
  print("overrun", m.overrun);
  print("bus_errors", m.bus_errors);
  print("longest_tick", m.longest_tick_us);
}
void print_signals(const RejectionReport& m) {
  const auto count = [&](Rejection cause) { return m.count[static_cast<std::size_t>(cause)]; };
  print("unknown_id", count(Rejection::unknown_id));
  print("wrong_length", count(Rejection::wrong_length));
  print("wrong_crc", count(Rejection::wrong_crc));
  print("wrong_counter", count(Rejection::wrong_counter));
  print("out_of_range", count(Rejection::out_of_range));
  print("stale", count(Rejection::stale));
}
void print_signals(const LimitReport& m) {
  for (std::size_t i = 0; i < m.limit.size(); ++i) {
    print_degrees(numbered("canard", i), m.limit[i]);
  }
}
void print_signals(const BoardReport& m) {
  print("faults", m.faults);
  print("battery", m.battery_mv.value_or(0));
  print("overruns", m.overruns);
  print("reset_cause", m.reset_cause);
  print("plan", m.plan);
  print("battery_given", m.battery_mv.has_value());
  print("flash_failed", m.flash_failed);
}
void print_signals(const GyroReport& m) {
  print_degrees("x", core::Angle::from_radians(m.rate_rad_s.x));
  print_degrees("y", core::Angle::from_radians(m.rate_rad_s.y));
  print_degrees("z", core::Angle::from_radians(m.rate_rad_s.z));
  print("time", m.time_ms);
  print("quality", m.quality);
}
void print_signals(const AccelerometerReport& m) {
  print("x", static_cast<double>(m.specific_force_m_s2.x));
  print("y", static_cast<double>(m.specific_force_m_s2.y));
  print("z", static_cast<double>(m.specific_force_m_s2.z));
  print("sensor", m.sensor);
  print("quality", m.quality);
}
void print_signals(const HeartbeatReport& m) {
  print("version", m.version);
  print("uptime", m.uptime_ms);
  print("plan_crc", m.plan_crc);
}

void answer(const auto& decoded) {
  if (!decoded.message) {
    std::printf("refused %d\n", static_cast<int>(decoded.rejection));
    return;
  }
  std::visit(
      [&](const auto& message) {
        const BusFrame again = encode_any(message, decoded.counter.value_or(0));
        std::printf("%03X#", static_cast<unsigned>(again.id));
        for (std::size_t i = 0; i < again.length; ++i) {
          std::printf("%02X", static_cast<unsigned>(again.data[i]));
        }
        print_signals(message);
      },
      *decoded.message);
  if (decoded.counter) {
    print("counter", *decoded.counter);
  }
  std::puts("");
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 1 && std::string_view{arguments[1]} == "session") {
    std::printf("%u\n", unsigned{open_session});
    return 0;
  }
  if (count > 1) {
    std::vector<PeriodicFrame> fastest;
    for (const BusFrameKind& kind : bus_catalogue()) {
      fastest.push_back({.id = kind.id, .bits = worst_bits_on_wire(kind.length), .period = kind.fastest_period});
    }
    for (const BusFrameKind& kind : bus_catalogue()) {
      const int period_ms = kind.fastest_period ? static_cast<int>(kind.fastest_period->count()) : 0;
      const auto latency = worst_latency(fastest, kind.id);
      std::printf("%u %s %s %u %d %d %d %s\n", static_cast<unsigned>(kind.id), std::string{kind.name}.c_str(),
                  kind.sender == BusNode::bench ? "BENCH" : "AVIONICS", static_cast<unsigned>(kind.length), period_ms,
                  kind.has_counter, kind.can_move, latency ? std::to_string(latency->count()).c_str() : "none");
    }
    return 0;
  }
  for (std::string line; std::getline(std::cin, line);) {
    BusFrame frame{.id = static_cast<std::uint16_t>(std::stoul(line.substr(0, 3), nullptr, 16)),
                   .length = static_cast<std::uint8_t>((line.size() - 4) / 2)};
    for (std::size_t i = 0; i < frame.length && i < frame.data.size(); ++i) {
      frame.data[i] = static_cast<std::uint8_t>(std::stoul(line.substr(4 + 2 * i, 2), nullptr, 16));
    }
    frame.id < 0x100 ? answer(decode_from_bench(frame, open_session)) : answer(decode_from_avionics(frame));
  }
}
