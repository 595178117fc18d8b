// SPDX-License-Identifier: MIT
#include <fstream>
#include <iomanip>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "core/tick_record.hpp"
#include "hal/board.hpp"
#include "protocol/log_notes.hpp"
#include "replies/sentence.hpp"

namespace fantail::bench {
namespace {

// docs/messages.md tells what each word and each refusal of the avionics means: does it know all of them?

std::string page() {
  std::ifstream file{FANTAIL_TEST_SOURCE "/docs/messages.md"};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// Every value of an enumeration that has a name.
template <typename Value>
void expect_names(const std::string& page) {
  int known = 0;
  for (int i = 0; i < 256; ++i) {
    const std::string_view called = name(static_cast<Value>(i));
    if (called != "unknown") {
      ++known;
      EXPECT_NE(page.find('`' + std::string{called} + '`'), std::string::npos) << called;
    }
  }
  EXPECT_GT(known, 1);
}

TEST(MessagesPage, HasEveryWordOfTheRecord) {
  const std::string text = page();
  expect_names<core::PhaseReason>(text);
  expect_names<core::CanardVerdict>(text);
  expect_names<core::SensorState>(text);
  expect_names<core::GyroVote>(text);
  expect_names<core::CommandStatus>(text);
  expect_names<core::DetectionState>(text);
  expect_names<protocol::LogEventKind>(text);
  expect_names<protocol::LogBegin>(text);
  expect_names<protocol::LogEnd>(text);
  expect_names<protocol::ResumedAfter>(text);
  for (std::size_t i = 0; i < hal::board_faults; ++i) {
    const std::string_view called = name(static_cast<hal::BoardFault>(i));
    EXPECT_NE(text.find('`' + std::string{called} + '`'), std::string::npos) << called;
  }
}

/// Up to where it says more: a second half, an example, the key of a plan.
std::string_view begin_of(std::string_view sentence) { return sentence.substr(0, sentence.find_first_of(";:,(")); }

template <typename Sentence>
void expect_sentences(const std::string& page, const Sentence& sentence) {
  int known = 0;
  for (int i = 0; i < 256; ++i) {
    std::string said = sentence(i);
    if (said == "unknown reason" || said == "no reason given") {
      continue;
    }
    ++known;
    if (const auto canard = said.find("canard 1"); canard != std::string::npos) {
      said.replace(canard, 8, "canard N");
    }
    EXPECT_NE(page.find(begin_of(said)), std::string::npos) << said;
  }
  EXPECT_GT(known, 1);
}

// Whoever decodes the bus without this program has these words alone.
TEST(MessagesPage, HasEveryWordThatTheBusGivesAsACause) {
  const std::string text = page();
  std::ifstream file{FANTAIL_TEST_SOURCE "/firmware/protocol/canard_bus.dbc"};
  const std::set<std::string> causes{"reason",         "failure",       "refusal",   "fault",     "block_fault",
                                     "command_status", "gyro",          "verdict_1", "verdict_2", "verdict_3",
                                     "verdict_4",      "accelerometer", "plan",      "quality"};
  std::set<std::string> seen;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words{line};
    std::string mark;
    std::string identifier;
    std::string signal;
    if (!(words >> mark >> identifier >> signal) || mark != "VAL_" || !causes.contains(signal)) {
      continue;
    }
    seen.insert(signal);
    std::string number;
    for (std::string word; words >> number >> std::quoted(word);) {
      EXPECT_TRUE(word == "none" || text.find('`' + word + '`') != std::string::npos) << signal << " " << word;
    }
  }
  EXPECT_EQ(seen, causes);
}

TEST(MessagesPage, HasEveryRefusal) {
  const std::string text = page();
  using namespace protocol;
  expect_sentences(text, [](int i) { return replies::sentence(static_cast<SessionReason>(i)); });
  expect_sentences(text, [](int i) { return replies::sentence(static_cast<SelfTestFailure>(i), 0); });
  expect_sentences(text, [](int i) { return replies::sentence(static_cast<ArmRefusal>(i)); });
  expect_sentences(text, [](int i) { return replies::sentence(static_cast<LogFault>(i)); });
  expect_sentences(text, [](int i) { return replies::sentence(PlanReply{.fault = static_cast<TransferFault>(i)}); });
  expect_sentences(text, [](int i) {
    return replies::sentence(
        PlanReply{.fault = TransferFault::bad_block, .block_fault = static_cast<PlanBlockFault>(i)});
  });
}

}  // namespace
}  // namespace fantail::bench
