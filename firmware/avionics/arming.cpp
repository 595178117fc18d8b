// SPDX-License-Identifier: MIT
#include "avionics/arming.hpp"

#include <utility>

namespace fantail::avionics {

using protocol::AbortState;
using protocol::ArmAction;
using protocol::ArmRefusal;

namespace {

constexpr std::uint32_t most_requests = 0xFFFF;  // of one power-up

// The finishing steps of MurmurHash3. They can be undone, so no two values share a result; and near values have results
// that nobody mistakes for each other.
std::uint32_t mixed(std::uint32_t value) {
  value ^= value >> 16U;
  value *= 0x85EBCA6BU;
  value ^= value >> 13U;
  value *= 0xC2B2AE35U;
  value ^= value >> 16U;
  return value;
}

}  // namespace

void Arming::receive(const Situation& now, const Permission& permission, const protocol::ArmRequest& request) {
  expire(now.time);
  switch (request.action) {
    case ArmAction::self_test: return;
    case ArmAction::begin:
      refusal_ = objection(now, permission);
      if (refusal_ == ArmRefusal::none) {
        if (const auto nonce = fresh_nonce(permission)) {
          issued_ = Issued{.nonce = *nonce, .time = now.time};
        } else {
          refusal_ = ArmRefusal::no_nonce;
        }
      }
      return;
    // Meets ARM-7.
    case ArmAction::confirm:
      refusal_ = objection(now, permission);
      if (refusal_ == ArmRefusal::none) {
        refusal_ = objection_to_nonce(request.nonce);
      }
      issued_.reset();  // one attempt, or all of them could be tried
      expired_ = false;
      if (refusal_ == ArmRefusal::none) {
        armed_with_ = request.nonce;
        arm_command_ = true;
      }
      return;
    case ArmAction::start:
      refusal_ = objection_to_start(now, permission, request.nonce);
      start_command_ = start_command_ || refusal_ == ArmRefusal::none;
      return;
  }
}

void Arming::update(const Situation& now) {
  switch_was_open_ = switch_was_open_ || now.arm_switch_open;
  expire(now.time);
}

// Meets ARM-7.
void Arming::expire(core::Microseconds now) {
  if (issued_ && now - issued_->time > nonce_lifetime) {
    issued_.reset();
    expired_ = true;
    refusal_ = ArmRefusal::nonce_expired;
  }
}

bool Arming::take_arm_command() { return std::exchange(arm_command_, false); }

bool Arming::take_start_command() { return std::exchange(start_command_, false); }

std::optional<std::uint32_t> Arming::nonce() const { return issued_ ? std::optional{issued_->nonce} : std::nullopt; }

// Meets ARM-3, ARM-4, BUS-1.
ArmRefusal Arming::objection(const Situation& now, const Permission& permission) const {
  if (now.phase != core::Phase::safe) {
    return ArmRefusal::not_safe;
  }
  if (permission.session_open) {
    return ArmRefusal::session_open;
  }
  if (now.board_faulty) {
    return ArmRefusal::board_fault;
  }
  if (!permission.self_test_passed) {
    return ArmRefusal::self_test_not_passed;
  }
  if (!now.at_rest) {
    return ArmRefusal::not_at_rest;
  }
  if (!now.arm_switch_closed) {
    return ArmRefusal::switch_open;
  }
  // Meets ABT-1.
  if (now.abort == AbortState::asks_to_abort || now.abort == AbortState::unsettled) {
    return ArmRefusal::abort_not_ready;
  }
  // Meets ARM-6.
  // A switch that was closed before power-up is nobody's decision: this may be a reset on the pad.
  return switch_was_open_ ? ArmRefusal::none : ArmRefusal::switch_not_cycled;
}

ArmRefusal Arming::objection_to_nonce(std::uint32_t nonce) const {
  if (!issued_) {
    return expired_ ? ArmRefusal::nonce_expired : ArmRefusal::no_nonce;
  }
  return nonce == issued_->nonce ? ArmRefusal::none : ArmRefusal::wrong_nonce;
}

// Meets PHS-3.
ArmRefusal Arming::objection_to_start(const Situation& now, const Permission& permission, std::uint32_t nonce) const {
  if (!permission.tunnel_plan) {
    return ArmRefusal::not_a_tunnel_plan;
  }
  if (now.phase != core::Phase::armed || !armed_with_) {
    return ArmRefusal::not_armed;
  }
  if (nonce != *armed_with_) {
    return ArmRefusal::wrong_nonce;
  }
  return now.at_rest ? ArmRefusal::none : ArmRefusal::not_at_rest;
}

// Meets ARM-8.
std::optional<std::uint32_t> Arming::fresh_nonce(const Permission& permission) {
  if (!permission.power_up || requests_ == most_requests) {
    return std::nullopt;
  }
  requests_ += 1;
  // Whatever the generator does: one that has failed and repeats itself leaves the nonces different.
  return mixed((*permission.power_up << 16U) | requests_) ^ permission.random;
}

}  // namespace fantail::avionics
