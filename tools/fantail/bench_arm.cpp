// SPDX-License-Identifier: MIT
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include <fmt/core.h>
#include <unistd.h>

#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/deliver.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "json/value.hpp"
#include "link/arm_steps.hpp"
#include "link/session.hpp"
#include "replies/sentence.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

struct ArmOptions {
  BenchOptions bench;
  bool yes = false;
  bool start = false;
};

constexpr hal::Microseconds glance{50'000};
constexpr hal::Microseconds switch_patience{60'000'000};

void tell(const ArmOptions& options, const std::string& text) {
  if (!options.bench.json) {
    show("{}\n", text);
    std::fflush(stdout);
  }
}

protocol::StatusReport status(const link::AvionicsLink& link) { return link.reported<protocol::StatusReport>("state"); }

std::string refusal(const link::AvionicsLink& link) {
  return replies::sentence(link.reported<protocol::ArmReply>("answer to arming").refusal);
}

void look(link::Place& place, link::AvionicsLink& link) {
  place.wait(glance);
  link.listen(place.now());
  link.expect_one_rocket();
  if (link.has_fallen_silent()) {
    throw link::LinkError{"the avionics has stopped answering"};
  }
}

double gyro_zero_deg_s(const link::AvionicsLink& link) {
  return text::degrees(static_cast<double>(status(link).gyro_bias_rad_s));
}

void test(const ArmOptions& options, const link::AvionicsLink& link, link::ArmSteps& steps) {
  link::CanardUnderTest moving;
  tell(options, "Self-test: keep the rocket still for three seconds; then each canard moves. Keep hands off.");
  const auto show = [&](const protocol::ArmReply& now) {
    if (const auto canard = moving.news(now)) {
      tell(options, fmt::format("  canard {}", *canard + 1));
    }
  };
  protocol::ArmReply reply;
  try {
    reply = steps.run_self_test(show);
  } catch (const link::SelfTestRefused& refusal) {
    throw RequirementNotMet{std::string{"the avionics refuses the self-test: "} + refusal.what()};
  }
  if (reply.self_test != protocol::SelfTestState::passed) {
    throw RequirementNotMet{"the self-test failed: " + replies::sentence(reply.failure, reply.canard)};
  }
  tell(options, fmt::format("  passed; at rest the gyro reads {} deg/s about the long axis, which is subtracted",
                            text::fixed(gyro_zero_deg_s(link), 2)));
  tell(options, fmt::format("  abort input: {}", replies::sentence(reply.abort_input)));
}

// The first action belongs to the hand at the rocket; this program can only wait for it.
void await_switch(const ArmOptions& options, link::Place& place, link::AvionicsLink& link) {
  if (status(link).arm_switch_closed) {
    return;
  }
  tell(options, "Close the arm switch at the rocket.");
  for (const hal::Microseconds end = place.now() + switch_patience; !status(link).arm_switch_closed;) {
    if (place.now() >= end) {
      throw RequirementNotMet{
          "the arm switch stayed open for a minute, and the self-test has expired; the rocket is safe"};
    }
    look(place, link);
  }
  tell(options, "  closed");
}

void await_consent(const ArmOptions& options, link::Place& place, link::AvionicsLink& link) {
  if (options.yes) {
    return;
  }
  say("Type ARM to arm, anything else to leave the rocket safe: ");  // standard output may be one JSON object
  LineInput input;
  std::optional<std::string> line;
  while (!(line = input.next())) {
    if (input.ended()) {
      throw RequirementNotMet{"ARM was not typed; the rocket is safe"};
    }
    look(place, link);
  }
  if (*line != "ARM") {
    throw RequirementNotMet{"not confirmed; the rocket is safe"};
  }
}

void arm(const ArmOptions& options) {
  CanPlace place{options.bench.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options.bench, place, link);
  link::ArmSteps steps{place, link};
  test(options, link, steps);
  await_switch(options, place, link);
  await_consent(options, place, link);
  const protocol::ArmReply answer = steps.ask_for_nonce();
  if (!answer.nonce) {
    throw RequirementNotMet{"the avionics refuses to be armed: " + replies::sentence(answer.refusal)};
  }
  if (!steps.confirm(*answer.nonce)) {
    throw RequirementNotMet{"the avionics refuses to be armed: " + refusal(link)};
  }
  tell(options, "ARMED. Opening the arm switch makes the rocket safe again.");
  if (options.start) {
    if (!steps.start_control(*answer.nonce)) {
      throw RequirementNotMet{"control does not start: " + refusal(link)};
    }
    tell(options, "Control has started.");
  }
  if (options.bench.json) {
    json::Value all{{"armed", true},
                    {"control_started", options.start},
                    {"abort_input", replies::name(link.reported<protocol::ArmReply>("answer to arming").abort_input)},
                    {"gyro_bias_deg_s", json::rounded(gyro_zero_deg_s(link))}};
    result::put_answer(all, result::Answer::yes, options.start ? "Armed, and control has started." : "Armed.",
                       made_with({}));
    fmt::print("{}\n", all.dump());
  }
}

}  // namespace

void add_bench_arm(const Verb& bench) {
  auto verb = bench.verb("arm", "Arm the rocket: self-test, arm switch, command");
  auto options = std::make_shared<ArmOptions>();
  add_bench_options(verb, options->bench, "Print one JSON object; the question goes to standard error");
  verb.flag("--yes", options->yes, "Do not ask on the terminal; for rehearsals and scripts");
  verb.flag("--start", options->start, "In the wind tunnel: also start control");
  verb.examples(
      "Examples:\n"
      "  fantail bench arm --can can0                 self-test, switch, question, command\n"
      "  fantail bench arm --can vcan0 --yes          a rehearsal without the question\n"
      "  fantail bench arm --can can0 --yes --start   in the wind tunnel: armed, and control on");
  verb.action([options] { arm(*options); });
}

}  // namespace fantail::tool
