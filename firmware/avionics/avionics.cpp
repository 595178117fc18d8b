// SPDX-License-Identifier: MIT
#include "avionics/avionics.hpp"

#include "avionics/abort_input.hpp"
#include "avionics/sensor_scaling.hpp"
#include "core/flight_plan_members.hpp"
#include "core/per_canard.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::avionics {
namespace {

constexpr std::array<std::optional<hal::Pulse>, hal::canards> no_pulses{};

}  // namespace

Avionics::Avionics(Devices devices, const core::FlightPlan& built_in, const Identity& identity)
    : devices_{devices},
      flash_{devices.flash},
      flight_memory_{devices.backup_memory, devices.clock, devices.board.status().reset_cause},
      plan_{built_in},
      self_test_{plan_} {
  flash_.recorder().introduce(identity);
  adopt(built_in);
  look_for_new_plan();
}

const core::TickRecord& Avionics::tick() {
  look_for_new_plan();
  const core::Microseconds now = devices_.clock.now();
  listen(now);
  const core::Inputs inputs = read_devices(now);
  resume_flight(inputs);
  if (!memory_watch_.intact(*autopilot_)) {
    mend_memory(inputs);
  }
  const core::TickRecord& record = autopilot_->step(inputs);
  devices_.servo.write(plan_is_lost() ? no_pulses : pulses(record.canards));

  const FlashFacts flash = flash_.facts();
  tell_person(record);
  follow(record, inputs, flash);
  flash_.recorder().note({.raw = raw_,
                          .scales = scales_,
                          .inputs = inputs,
                          .record = record,
                          .duration_before = tick_duration_,
                          .bus = devices_.can_bus,
                          .power_up = flash_.boots().count(),
                          .board = &devices_.board,
                          .faults = board_watch_.faults()},
                         *autopilot_);
  flight_memory_.keep(record, plan_crc_, flash_.flights().used_sectors(), *autopilot_);
  const LogTransfer::Right right = right_to_log();
  flash_.update(now, plan_may_change(), right);
  report(record, inputs);
  flash_.send_log(now, right, devices_.can_bus);
  tick_duration_ = devices_.clock.now() - now;
  memory_watch_.look(plan_, *autopilot_);
  // Meets TIM-2.
  // Last: only a tick that came this far proves that the loop is alive.
  devices_.watchdog.feed();
  return record;
}

// What arming and the self-test look at, and both.
void Avionics::follow(const core::TickRecord& record, const core::Inputs& inputs, const FlashFacts& flash) {
  situation_ = {.time = inputs.time,
                .phase = record.phase,
                .reason = record.reason,
                .at_rest = record.motion.at_rest_for >= plan_.motion.rest_time,
                .moves = record.motion.at_rest_for == core::Microseconds{0},
                .arm_switch_closed = inputs.arm_switch_closed,
                .arm_switch_open = devices_.arm_switch.open(),
                .abort = abort_state(plan_.run.abort_input, devices_.abort_contact)};
  watch_board(record, flash);
  arming_.update(situation_);
  self_test_.update(inputs, record, flash, situation_.board_faulty);
}

void Avionics::look_for_new_plan() {
  // A flash that was busy at power-up, with what a reset left behind, is asked until it answers.
  if (!flash_was_read_ && situation_.phase == core::Phase::safe) {
    if (const auto stored = flash_.load_plan(devices_.clock.now())) {
      flash_was_read_ = true;
      if (stored->plan) {
        adopt(*stored->plan);
      }
    }
  }
  if (const auto plan = flash_.take_plan()) {
    adopt(*plan);
    devices_.console.write("plan: a new one is in force\n");
  }
}

// Not before the flash has said which plan is in force.
void Avionics::resume_flight(const core::Inputs& first) {
  if (!flash_was_read_ || !flight_memory_.waits()) {
    return;
  }
  if (const auto resumed = flight_memory_.resume(first, plan_crc_, *autopilot_)) {
    flash_.resume_flight(resumed->used_sectors, {resumed->after, flight_memory_.resumes()});
    devices_.console.write("flight: resumed after a reset\n");
  } else {
    autopilot_.emplace(plan_);  // half a state is none
    devices_.console.write("flight: not resumed\n");
  }
}

// The packed plan, which has a CRC of its own, is the copy that counts. In flight the law goes on from its last state
// that was sealed for a reset, 10 ms old at most, but no further than to trim: what has damaged it may do so again.
void Avionics::mend_memory(const core::Inputs& next) {
  const std::span<const std::byte> block = flash_.recorder().plan_block();
  const auto copy = protocol::read_plan_block(block);
  lost_plan_ = copy.plan ? lost_plan_ : plan_lost;
  plan_ = copy.plan.value_or(core::default_plan());
  plan_crc_ = protocol::plan_block_checksum(block);
  memory_watch_.begin(plan_);
  memory_was_damaged_ = true;
  autopilot_.emplace(plan_);
  if (!flight_memory_.resume(next, plan_crc_, *autopilot_)) {
    autopilot_.emplace(plan_);
  }
  autopilot_->give_up(next.time);
  flash_.recorder().restate();
  self_test_ = SelfTest{plan_};
}

// In Safe only. The new autopilot begins as after power-up: it moves the canards slowly from where they stand, and has
// yet to see the rocket at rest, so nobody who was allowed to move them by the old plan still is.
void Avionics::adopt(const core::FlightPlan& plan) {
  plan_ = plan;
  autopilot_.emplace(plan);
  memory_watch_.begin(plan_);
  flash_.recorder().take_plan(plan);
  plan_crc_ = protocol::plan_block_checksum(flash_.recorder().plan_block());
  self_test_ = SelfTest{plan_};
}

void Avionics::listen(core::Microseconds now) {
  situation_.time = now;
  receiver_.begin_tick();
  while (const auto message = receiver_.next(now, devices_.can_bus, bench_mode_.session())) {
    if (const auto* session = std::get_if<protocol::BenchSession>(&*message)) {
      obey(*session);
    } else if (const auto* request = std::get_if<protocol::BenchRequest>(&*message)) {
      obey(*request);
    } else if (const auto* arm = std::get_if<protocol::ArmRequest>(&*message)) {
      obey(*arm);
    } else if (const auto* begin = std::get_if<protocol::PlanBegin>(&*message)) {
      flash_.transfer().receive(now, *begin, plan_may_change());
    } else if (const auto* data = std::get_if<protocol::PlanData>(&*message)) {
      flash_.transfer().receive(now, *data, plan_may_change());
    } else if (const auto* log = std::get_if<protocol::LogRequest>(&*message)) {
      flash_.receive(*log, right_to_log());
    }
  }
  bench_mode_.update(situation_);
}

void Avionics::obey(const protocol::BenchSession& message) {
  if (!bench_mode_.receive(situation_, self_test_.running(), message)) {
    receiver_.count(protocol::Rejection::stale);
  }
}

void Avionics::obey(const protocol::BenchRequest& message) {
  if (!bench_mode_.receive(message)) {
    receiver_.count(protocol::Rejection::stale);
  }
}

void Avionics::obey(const protocol::ArmRequest& message) {
  if (message.action == protocol::ArmAction::self_test) {
    arming_.answer(self_test_.start(situation_, bench_mode_.open()));
  } else {
    // Meets REC-1.
    // A plan that is being written will want a self-test of its own, and a flight wants its room in the flash.
    const bool flash_is_ready = !flash_.transfer().writing() && !flash_.flights().erasing();
    arming_.receive(situation_,
                    {.self_test_passed = self_test_.passed(situation_.time) && flash_is_ready,
                     .session_open = bench_mode_.open(),
                     .tunnel_plan = plan_.run.start == core::Start::tunnel,
                     .power_up = flash_.boots().count(),
                     .random = devices_.entropy.draw()},
                    message);
  }
}

// Meets PLN-1.
bool Avionics::plan_may_change() const {
  return situation_.phase == core::Phase::safe && situation_.at_rest && !bench_mode_.open() && !self_test_.running() &&
         !arming_.nonce() && !flash_.recorder().busy();
}

LogTransfer::Right Avionics::right_to_log() const {
  return {.safe = situation_.phase == core::Phase::safe, .session = bench_mode_.session()};
}

void Avionics::watch_board(const core::TickRecord& record, const FlashFacts& flash) {
  hal::BoardStatus status = devices_.board.status();
  if (memory_was_damaged_) {
    status.faults.add(hal::BoardFault::memory_damaged);
  }
  if (flash.has_bad_pages) {
    status.faults.add(hal::BoardFault::flash_page_bad);
  }
  board_watch_.look(status, record.overruns, plan_.run.overrun_limit);
  situation_.board_faulty = board_watch_.faulty();
  board_is_news_ = board_watch_.tell(record.time, record.phase, flash, devices_.console);
  devices_.board.show(
      signal_of(record.phase, record.reason, self_test_.running(), !board_watch_.faulty() && flash.fit()));
}

void Avionics::report(const core::TickRecord& record, const core::Inputs& inputs) {
  Report report{.situation = situation_,
                .self_test_running = self_test_.running(),
                .session_open = bench_mode_.open(),
                .session = bench_mode_.reply(),
                .session_is_news = bench_mode_.take_news(),
                .session_refusal = bench_mode_.take_refusal(),
                .arming = {.self_test = self_test_.state(),
                           .failure = self_test_.failure(),
                           .canard = self_test_.canard(),
                           .refusal = arming_.refusal(),
                           .nonce = arming_.nonce(),
                           .abort_input = situation_.abort},
                .plan = flash_.transfer().reply(),
                .plan_crc = plan_crc_,
                .tick_duration = tick_duration_};
  if (board_is_news_ || telemetry_.slow_report_is_due()) {
    report.slow = {.rejections = receiver_.rejections(),
                   .limits = {.limit = core::per_canard([&](std::size_t i) { return autopilot_->canard_limit(i); })},
                   .board = board_watch_.report(flash_.facts()),
                   .board_is_news = board_is_news_};
  }
  telemetry_.send(record, inputs, report, devices_.can_bus);
}

void Avionics::tell_person(const core::TickRecord& record) {
  if (record.phase == situation_.phase && record.reason == situation_.reason) {
    return;
  }
  devices_.console.write("phase: ");
  devices_.console.write(name(record.phase));
  devices_.console.write(", ");
  devices_.console.write(name(record.reason));
  devices_.console.write("\n");
}

std::array<std::optional<hal::Pulse>, hal::canards> Avionics::pulses_at_trim() const {
  if (plan_is_lost()) {
    return no_pulses;
  }
  core::CanardCommands commands;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const core::CanardPlan& canard = plan_.canards.each[i];
    commands[i] = {.angle = canard.trim,
                   .pulse_us = canard.pulse_centre_us + canard.pulse_per_radian_us * canard.trim.radians(),
                   .driven = true};
  }
  return pulses(commands);
}

}  // namespace fantail::avionics
