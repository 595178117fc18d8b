// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "can/program.hpp"
#include "hal/linux/can_bus.hpp"
#include "hal/linux/clock.hpp"
#include "link/avionics_link.hpp"
#include "linux/shell.hpp"
#include "test.hpp"

namespace fantail::test {

/// Every test begins with both buses up, whatever the one before it did to them.
class CanSystem : public ::testing::Test {
 protected:
  void SetUp() override { restore_virtual_buses(); }
};

[[nodiscard]] bool have_cantools();

/// For tests that need cantools, which comes with a network; where a skipped test counts as a failure, so does this.
class WithCantools : public CanSystem {
 protected:
  void SetUp() override {
    if (!have_cantools()) {
      GTEST_SKIP() << "no cantools in build/test-venv; run ./dev test with a network once";
    }
    CanSystem::SetUp();
  }
};

/// Hears the avionics as a bench does.
class Ear {
 public:
  explicit Ear(const std::string& interface) : bus_{interface} {}

  /// Listens until the answer is yes; false when it stays no.
  [[nodiscard]] bool until(const std::function<bool()>& question,
                           std::chrono::milliseconds longest = std::chrono::minutes{1});

  template <typename Message>
  [[nodiscard]] Message newest() const {
    const auto& heard = link_.newest<Message>();
    return heard ? heard->message : Message{};
  }
  [[nodiscard]] link::AvionicsLink& link() { return link_; }
  [[nodiscard]] bool at_rest() {
    return until([this] { return newest<protocol::StatusReport>().at_rest; });
  }
  [[nodiscard]] bool reaches(core::Phase phase) {
    return until([this, phase] {
      const auto& status = link_.newest<protocol::StatusReport>();
      return status && status->message.phase == phase;
    });
  }

 private:
  hal::on_linux::CanBus bus_;
  hal::on_linux::Clock clock_;
  link::AvionicsLink link_{bus_};
};

/// fantail node.
class Node {
 public:
  /// `flash` is a file; empty: a new one that goes with the object. `settings`: of --set.
  explicit Node(const std::string& interface, const std::string& scenario = "bench_healthy",
                const std::string& flash = "", const std::vector<std::string>& settings = {});

  /// Waits until the rocket has stood still for long enough.
  void await_rest();

  std::string interface;
  Folder folder;
  Program program;
};

/// Tests that share one rocket on vcan0, at rest.
class AtARocket : public CanSystem {
 protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite() { node.reset(); }
  static inline std::unique_ptr<Node> node;
};

/// Runs fantail bench, and again when its session was lost because the guest gave it no processor time for 0.1 s: that
/// is the interlock at work, and a busy machine must not decide a test. Says so when it happens; eleven times at most.
[[nodiscard]] Outcome fantail_bench(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
[[nodiscard]] bool starved(const Outcome& outcome);
/// The same for a bench that goes on: it runs, and the answer has been yes. Prints why it is begun again.
[[nodiscard]] std::unique_ptr<Program> bench_until(const std::vector<std::string>& arguments,
                                                   const std::function<bool(const Program&)>& question);

/// candump on an interface, from when the object has been made.
class Dump {
 public:
  explicit Dump(const std::string& interface);
  /// Everything until now, in the words of candump -L; then it ends.
  [[nodiscard]] std::string log();

 private:
  std::string interface_;
  Program program_;
};

struct LoggedFrame {
  double time_s = 0.0;
  hal::CanFrame frame;
};
/// What candump -L wrote; without the frames of CAN FD.
[[nodiscard]] std::vector<LoggedFrame> frames(const std::string& log);

/// One message in the words of cantools.
struct Spoken {
  std::string name;
  std::map<std::string, std::string> signals;  ///< without units
};
/// A candump log, read by cantools with the database. Frames that it does not know are left out.
[[nodiscard]] std::vector<Spoken> decoded_by_cantools(const std::string& log);

/// Lines "TIME_S MESSAGE [wrong_crc] SIGNAL=VALUE ...", made by cantools into a candump log.
[[nodiscard]] std::string encoded_by_cantools(const std::string& lines, const std::string& interface);

/// The message of a frame; empty when it is none of the avionics.
template <typename Message>
[[nodiscard]] std::optional<Message> report(const hal::CanFrame& frame) {
  if (frame.extended || frame.remote) {
    return std::nullopt;
  }
  const auto decoded = protocol::decode_from_avionics(
      {.id = static_cast<std::uint16_t>(frame.id), .length = frame.length, .data = frame.data});
  const Message* const message = decoded.message ? std::get_if<Message>(&*decoded.message) : nullptr;
  return message != nullptr ? std::optional{*message} : std::nullopt;
}

/// All reports of one kind in a log, in order.
template <typename Message>
[[nodiscard]] std::vector<Message> reports(const std::string& log) {
  std::vector<Message> all;
  for (const LoggedFrame& each : frames(log)) {
    if (const auto message = report<Message>(each.frame)) {
      all.push_back(*message);
    }
  }
  return all;
}

/// Largest distance of a canard from zero; of those that are known.
[[nodiscard]] float farthest_deg(const protocol::PerCanard& angles);

/// For EXPECT_PRED2.
[[nodiscard]] inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace fantail::test
