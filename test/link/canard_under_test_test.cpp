// SPDX-License-Identifier: MIT
#include <vector>

#include <gtest/gtest.h>

#include "link/arm_steps.hpp"

namespace fantail::link {
namespace {

using protocol::ArmReply;
using protocol::SelfTestState;

constexpr ArmReply running(std::optional<std::size_t> canard) {
  return {.self_test = SelfTestState::running, .canard = canard};
}

std::vector<std::size_t> said(const std::vector<ArmReply>& replies) {
  CanardUnderTest canard;
  std::vector<std::size_t> all;
  for (const ArmReply& reply : replies) {
    if (const auto news = canard.news(reply)) {
      all.push_back(*news);
    }
  }
  return all;
}

TEST(CanardUnderTest, EachIsSaidOnce) {
  EXPECT_EQ(said({running({}), running(0), running(0), running(1), running(1), running(2), running(3), running(3)}),
            (std::vector<std::size_t>{0, 1, 2, 3}));
}

// A second rocket rests for its self-test, or a stranger's frame comes, while a canard of the first one moves.
TEST(CanardUnderTest, AReplyThatNamesNoneIsOfNone) {
  const ArmReply passed{.self_test = SelfTestState::passed, .canard = 2};
  EXPECT_EQ(said({running(1), running({}), running(1), passed, running({}), running(2)}),
            (std::vector<std::size_t>{1, 2}));
}

}  // namespace
}  // namespace fantail::link
