// SPDX-License-Identifier: MIT
#include "fantail/pad_script.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "avionics/can_frame.hpp"
#include "fantail/standard_streams.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::tool {
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

PadScript::PadScript(const PadEar& ear, std::vector<PadCommand> commands) : commands_{std::move(commands)} {
  const std::initializer_list<PadCommand> own{{"wait session", "read on when a bench session is open",
                                               [this, &ear] { awaited_ = [&ear] { return ear.session_open(); }; }},
                                              {"wait self-test", "read on when the self-test has passed",
                                               [this, &ear] { awaited_ = [&ear] { return ear.self_test_passed(); }; }},
                                              {"help", "list these commands", [this] { say(help()); }},
                                              {"quit", "end the program", [this] { is_over_ = true; }}};
  commands_.insert(commands_.end(), own);
}

std::string PadScript::help() const {
  std::string text;
  for (const PadCommand& command : commands_) {
    text += fmt::format("  {:<16}{}\n", command.text, command.meaning);
  }
  return text;
}

bool PadScript::obey() {
  // Who types without end does not keep the rocket from its time.
  constexpr int most_lines = 8;
  for (int line_number = 0; line_number < most_lines && !is_over_ && (!awaited_ || awaited_()); ++line_number) {
    awaited_ = nullptr;
    const auto line = input_.next();
    if (!line) {
      break;
    }
    const auto command = std::ranges::find(commands_, *line, &PadCommand::text);
    if (command != commands_.end()) {
      command->act();
    } else if (!line->empty()) {
      say(fmt::format("\"{}\" is not a command; there are:\n{}", *line, help()));
    }
  }
  return !is_over_;
}

}  // namespace fantail::tool
