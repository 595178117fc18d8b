// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "random_stream.hpp"
#include "transfer_rig.hpp"

namespace fantail::avionics {
namespace {

using protocol::TransferState;

// A bench that waits for the reply to each frame and says it again after 20 ms, on a bus that loses, doubles and
// delays.
bool bench_gets_through(TransferRig& rig, const Bytes& block, core::RandomStream& random) {
  constexpr int begin_frame = -1;
  std::vector<int> late;  // frames that will come once more, later
  const auto deliver = [&](int frame) {
    if (frame == begin_frame) {
      rig.begin(block);
    } else {
      rig.data(block, static_cast<std::size_t>(frame));
    }
  };
  int next = begin_frame;
  int waited = 0;
  for (int ticks = 0; ticks < 20'000; ++ticks) {
    if (waited % 20 == 0) {
      if (!random.chance(0.2)) {
        deliver(next);
      }
      if (random.chance(0.1)) {
        deliver(next);
      }
      if (next != begin_frame && random.chance(0.1)) {  // a beginning that came late would rightly begin again
        late.push_back(next);
      }
    }
    if (!late.empty() && random.chance(0.05)) {
      deliver(late.back());
      late.pop_back();
    }
    waited += 1;
    const auto reply = rig.step();
    if (!reply || random.chance(0.2)) {
      continue;
    }
    if (reply->state == TransferState::stored || reply->state == TransferState::refused) {
      return reply->state == TransferState::stored;
    }
    if (reply->state == TransferState::receiving && (next == begin_frame || reply->next_index > next)) {
      next = reply->next_index;
      waited = 0;
    }
  }
  return false;
}

RC_GTEST_PROP(PlanTransfer, ABenchThatRepeatsItselfGetsThroughABusThatLosesDoublesAndDelays, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  TransferRig rig;
  const int number = random.whole(1, 100);
  RC_ASSERT(bench_gets_through(rig, block_of(numbered_plan(number)), random));
  RC_ASSERT(rig.taken && number_of(*rig.taken) == number);
  RC_ASSERT(rig.stored_number() == number);
}

// Random messages, mixed with pieces of a real transfer, through every state, with phases and power that come and go.
RC_GTEST_PROP(PlanTransfer, WhateverArrivesThePlanInFlashIsOneThatWasSentAsAWhole, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  Bytes cells = flash_holding(7);
  int in_force = 7;
  for (int life = 0; life < 3; ++life) {
    TransferRig rig{cells};
    RC_ASSERT(rig.found.plan && number_of(*rig.found.plan) == in_force);
    const int number = random.whole(1, 100);
    const Bytes block = block_of(numbered_plan(number));
    std::size_t next = 0;
    for (int message = 0; message < 1500; ++message) {
      if (random.chance(0.002)) {
        rig.begin(static_cast<std::uint16_t>(random.whole(0, 0xFFFF)), static_cast<std::uint32_t>(random.whole(0, 9)));
      } else if (random.chance(0.005)) {
        rig.begin(block);
        next = 0;
      } else if (random.chance(0.002)) {
        const protocol::PlanData noise{.index = static_cast<std::uint8_t>(random.whole(0, 255)),
                                       .bytes = {static_cast<std::byte>(random.whole(0, 255))}};
        rig.service.transfer().receive(rig.world.time, noise, rig.safe);
      } else {
        rig.data(block, next);
        next += next < 200 ? 1 : 0;
      }
      rig.safe = rig.safe ? !random.chance(0.003) : random.chance(0.3);
      rig.taken.reset();
      rig.step();
      if (rig.taken) {
        RC_ASSERT(number_of(*rig.taken) == number);
        in_force = number;
      }
    }
    rig.flash.cut_power(seed);
    cells = rig.cells();
    const int after = rig.stored_number();
    RC_ASSERT(after == in_force || after == number);
    in_force = after;
  }
}

}  // namespace
}  // namespace fantail::avionics
