// SPDX-License-Identifier: MIT
#include <cstdio>

#include "core/autopilot.hpp"
#include "protocol/plan_block.hpp"

int main() {
  const fantail::core::Autopilot autopilot{fantail::core::default_plan()};
  std::printf("%zu bytes of autopilot, plan schema %08x\n", sizeof autopilot, fantail::protocol::plan_schema_hash());
}
