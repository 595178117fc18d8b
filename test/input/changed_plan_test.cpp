// SPDX-License-Identifier: MIT
#include <array>

#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "protocol/plan_block.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

core::FlightPlan shipped(const std::string& name) { return read_plan(Document::load(find_input(Shipped::plan, name))); }

core::FlightPlan changed(const core::FlightPlan& plan, const std::string& text) {
  return changed_plan(plan, std::array{parse_override(text)});
}

TEST(ChangedPlan, EveryOtherValueKeepsItsBits) {
  for (const std::string& name : shipped_names(Shipped::plan)) {
    const core::FlightPlan plan = shipped(name);
    core::FlightPlan expected = plan;
    expected.controller.canard_limit = core::Angle::from_degrees(3.5F);
    EXPECT_EQ(protocol::plan_crc(changed(plan, "controller.canard_limit_deg=3.5")), protocol::plan_crc(expected))
        << name;
    EXPECT_EQ(protocol::plan_crc(changed_plan(plan, {})), protocol::plan_crc(plan)) << name;
  }
}

TEST(ChangedPlan, RulesThatSpanSeveralValuesSeeThoseOfThePlan) {
  const core::FlightPlan plan = shipped("tunnel_steps");
  // Steps are allowed because the plan has some; the default plan has none.
  EXPECT_NO_THROW((void)changed(plan, "controller.canard_limit_deg=4"));
}

TEST(ChangedPlan, WhatAFileMayNotSayIsRefused) {
  const core::FlightPlan plan = core::default_plan();
  for (const char* text : {"controller.canard_limit_deg=90", "controller.no_such_key=1", "nowhere.key=1",
                           "controller.canard_limit_deg=wide"}) {
    EXPECT_THROW((void)changed(plan, text), text::Error) << text;
  }
}

}  // namespace
}  // namespace fantail::input
