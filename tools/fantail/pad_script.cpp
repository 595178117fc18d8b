// SPDX-License-Identifier: MIT
#include "fantail/pad_script.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/core.h>

#include "avionics/can_frame.hpp"
#include "fantail/standard_streams.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::tool {
namespace {

struct PadCommandEntry {
  std::string_view text;
  PadCommand command;
  std::string_view meaning;
};
constexpr std::array<PadCommandEntry, 9> pad_commands{{
    {"switch close", PadCommand::close_switch, "close the arm switch"},
    {"switch open", PadCommand::open_switch, "open the arm switch"},
    {"abort press", PadCommand::press_abort, "ask to abort at the abort input, if the plan has one"},
    {"abort release", PadCommand::release_abort, "no longer ask to abort"},
    {"ignite", PadCommand::ignite, "ignite the motor"},
    {"wait session", PadCommand::await_session, "read on when a bench session is open"},
    {"wait self-test", PadCommand::await_self_test, "read on when the self-test has passed"},
    {"help", PadCommand::help, "list these commands"},
    {"quit", PadCommand::quit, "end the program"},
}};

}  // namespace

bool PadEar::send(const hal::CanFrame& frame) {
  if (const auto decoded = protocol::decode_from_avionics(avionics::bus_frame(frame)); decoded.message) {
    if (const auto* status = std::get_if<protocol::StatusReport>(&*decoded.message)) {
      session_open_ = status->session_open;
    } else if (const auto* reply = std::get_if<protocol::ArmReply>(&*decoded.message)) {
      self_test_passed_ = reply->self_test == protocol::SelfTestState::passed;
    }
  }
  return bus_.send(frame);
}

std::string pad_commands_help() {
  std::string text;
  for (const PadCommandEntry& entry : pad_commands) {
    text += fmt::format("  {:<16}{}\n", entry.text, entry.meaning);
  }
  return text;
}

bool PadScript::waits() {
  if (awaited_ && (*awaited_ == PadCommand::await_session ? ear_.session_open() : ear_.self_test_passed())) {
    awaited_.reset();
  }
  return awaited_.has_value();
}

std::optional<PadCommand> PadScript::next() {
  while (!waits()) {
    const auto line = input_.next();
    if (!line) {
      return std::nullopt;
    }
    const auto* const entry = std::ranges::find(pad_commands, *line, &PadCommandEntry::text);
    if (entry == pad_commands.end()) {
      if (!line->empty()) {
        say(fmt::format("\"{}\" is not a command; there are:\n{}", *line, pad_commands_help()));
      }
    } else if (entry->command == PadCommand::await_session || entry->command == PadCommand::await_self_test) {
      awaited_ = entry->command;
    } else {
      return entry->command;
    }
  }
  return std::nullopt;
}

}  // namespace fantail::tool
