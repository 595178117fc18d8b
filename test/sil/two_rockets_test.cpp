// SPDX-License-Identifier: MIT
// A second rocket, or a device that imitates one, on the bus of a bench: no report says which one it is about.

#include "avionics/can_frame.hpp"
#include "bench/axes.hpp"
#include "figures.hpp"
#include "link/arm_steps.hpp"
#include "link/log_reader.hpp"
#include "link/plan_transfer.hpp"
#include "protocol/plan_block.hpp"
#include "sil/bench_at_world.hpp"
#include "sil/second_rocket.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

std::string complaint(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no complaint";
}

/// The first has been on for 4 s and the bench has heard it alone; the second comes when the test says so.
class TwoRockets : public testing::Test {
 protected:
  TwoRockets() {
    link::await_avionics(place, link);
    place.wait(3 * second);
    while (link.listen(place.now())) {
    }
  }

  void join(int on_for_ms) {
    other.emplace(place.wire);
    other->live(on_for_ms);
    place.pc_bus.pass_over();  // it came to this bus only now
    place.board_bus.pass_over();
    place.after_tick = [this] { other->live(); };
  }
  void join_after(int milliseconds, int on_for_ms) {
    place.after_tick = [this, milliseconds, on_for_ms, ticks = 0]() mutable {
      if (++ticks == milliseconds) {
        join(on_for_ms);
      }
    };
  }
  void expect_told(const std::function<void()>& work) { EXPECT_THROW(work(), link::TwoRockets); }

  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  std::optional<SecondRocket> other;
};

// 0: one switch for both; 4000 and a little: the same uptime as the first.
TEST_F(TwoRockets, ABenchThatComesToBothIsToldBeforeItAsksAnything) {
  for (const int on_for_ms : {1, 50, 130, 1'000, 3'990, 4'100, 20'000}) {
    other.reset();
    join(on_for_ms);
    link::AvionicsLink new_link{place.bus()};
    hal::sim::CanBus ear{place.wire};
    expect_told([&] { link::await_avionics(place, new_link); });
    while (const auto frame = ear.receive()) {
      EXPECT_GE(frame->id, 0x100U) << "something was asked";
    }
    place.after_tick = nullptr;
  }
}

TEST_F(TwoRockets, OneThatComesWhileCanardsMoveEndsTheExerciseAndBlamesNoPc) {
  for (const int on_for_ms : {1, 500, 20'000}) {
    BenchAtWorld here{"bench_healthy"};
    link::AvionicsLink ear{here.bus()};
    link::Session session = here.open_session(ear);
    const bench::Exercise exercise =
        bench::Exercise::limits(bench::bounds(ear.reported<protocol::LimitReport>("canard limits"), session.trims()));
    std::optional<SecondRocket> late;
    int ticks = 0;
    here.after_tick = [&] {
      if (++ticks == 3'000) {
        late.emplace(here.wire);
        late->live(on_for_ms);
        here.board_bus.pass_over();
        here.pc_bus.pass_over();
      } else if (late) {
        late->live();
      }
    };
    expect_told([&] { (void)bench::perform(exercise, session, ear, [](double) {}); });
    EXPECT_LT(ticks, 4'000) << "within a second";
    (void)session.close();
    here.wait(300 * millisecond);
    for (const auto& canard : here.record.canards) {
      EXPECT_NEAR(canard.angle.degrees(), 0.0F, 0.01F) << "centred";
    }
  }
}

/// A busy PC: when the bench has asked for its first session, nobody runs for 0.3 s.
class StallingPlace final : public link::Place {
 public:
  explicit StallingPlace(BenchAtWorld& inner) : inner_{inner}, ear_{inner.wire} {}
  [[nodiscard]] hal::CanBus& bus() override { return inner_.bus(); }
  [[nodiscard]] hal::Microseconds now() const override { return inner_.now(); }
  void wait(hal::Microseconds at_most) override {
    inner_.wait(at_most);
    while (const auto frame = ear_.receive()) {
      if (frame->id < 0x100U && !asked_) {
        asked_ = true;
        inner_.wait(300 * millisecond);
        return;
      }
    }
  }

 private:
  BenchAtWorld& inner_;
  hal::sim::CanBus ear_;
  bool asked_ = false;
};

TEST_F(TwoRockets, ASessionThatEndsAsSoonAsItHasOpenedIsNotCalledRefused) {
  StallingPlace stalling{place};
  const std::string said = complaint([&] { link::Session session(stalling, link, 5); });
  EXPECT_TRUE(says(said, "heartbeat") && figures(said) == (std::vector<std::string>{"0.1", "0.3"})) << said;
}

TEST_F(TwoRockets, OneThatComesWhileThePcStandsStillIsNamedBeforeThePc) {
  StallingPlace stalling{place};
  join_after(150, 1);
  expect_told([&] { link::Session session(stalling, link, 5); });
}

TEST_F(TwoRockets, OneThatComesDuringTheSelfTestEndsArming) {
  link::ArmSteps steps{place, link};
  join_after(4'000, 10'000);
  expect_told([&] { (void)steps.run_self_test([](const auto&) {}); });
}

TEST_F(TwoRockets, OneThatComesBeforeTheConfirmationLeavesBothUnarmed) {
  link::ArmSteps steps{place, link};
  ASSERT_EQ(steps.run_self_test([](const auto&) {}).self_test, protocol::SelfTestState::passed);
  place.world->set_arm_switch(true);
  place.wait(10 * millisecond);
  join(10'000);
  expect_told([&] {
    for (int i = 0; i < 100; ++i) {
      (void)steps.ask_for_nonce();
    }
  });
  EXPECT_EQ(place.record.phase, core::Phase::safe);
  EXPECT_EQ(other->record.phase, core::Phase::safe);
}

TEST_F(TwoRockets, NoPlanIsCalledInForceOfOneOfThem) {
  std::array<std::byte, protocol::largest_plan_block> block{};
  const std::size_t size = protocol::write_plan_block(place.scenario.plan, block);
  join(10'000);
  expect_told([&] { (void)link::send_plan(place, link, std::span{block}.first(size), [](std::size_t) {}); });
  expect_told([&] { (void)link::read_plan_in_force(place, link); });
}

TEST_F(TwoRockets, NeitherRecordIsReadOrErased) {
  link::LogReader reader{place, link};
  join(10'000);
  expect_told([&] {
    for (int i = 0; i < 100; ++i) {
      (void)reader.info();
      place.wait(10 * millisecond);
    }
  });
}

TEST_F(TwoRockets, NoTurnIsTakenForThatOfOneOfThem) {
  join(10'000);
  expect_told([&] { (void)bench::watch_turns(place, link, [](const auto&) {}); });
}

// It sends nothing but heartbeats, of a plan of its own.
TEST_F(TwoRockets, ADeviceThatSendsHeartbeatsIsTold) {
  hal::sim::CanBus stranger{place.wire};
  place.after_tick = [&, ticks = 0]() mutable {
    if (++ticks % 250 == 0) {
      (void)stranger.send(avionics::can_frame(encode(protocol::HeartbeatReport{.uptime_ms = 7, .plan_crc = 1})));
    }
  };
  link::AvionicsLink new_link{place.bus()};
  expect_told([&] {
    link::await_avionics(place, new_link);
    link::Session session{place, new_link, 5};
    session.wait(second);
  });
}

TEST_F(TwoRockets, ARocketThatIsSwitchedOffAndOnIsOne) {
  place.power_cycle();
  for (int i = 0; i < 500; ++i) {
    place.wait(10 * millisecond);
    link.listen(place.now());
  }
  EXPECT_FALSE(link.two_rockets()) << *link.two_rockets();
}

}  // namespace
}  // namespace fantail::sil
