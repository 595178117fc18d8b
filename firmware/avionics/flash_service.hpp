// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "avionics/boot_counter.hpp"
#include "avionics/flash_access.hpp"
#include "avionics/flash_facts.hpp"
#include "avionics/flight_region.hpp"
#include "avionics/log_transfer.hpp"
#include "avionics/plan_store.hpp"
#include "avionics/plan_transfer.hpp"
#include "avionics/recorder.hpp"
#include "core/time.hpp"
#include "hal/flash.hpp"

namespace fantail::avionics {

/// Everything that the avionics keeps in flash. One of its users has the flash at a time: the boot counter until it has
/// finished, then a flight that is recorded, then a plan that is written, and in the ticks that are left the flights
/// are read for the bench, or their region is looked through or erased.
class FlashService {
 public:
  /// The flash outlives this object.
  [[gnu::cold]] explicit FlashService(hal::Flash& flash) : access_{flash} {}
  FlashService(const FlashService&) = delete;  // its users refer to its access
  FlashService& operator=(const FlashService&) = delete;

  /// At power-up: PlanStore::load().
  std::optional<StoredPlan> load_plan(core::Microseconds now) {
    const std::optional<StoredPlan> stored = store_.load(now);
    if (stored) {
      plan_source_ = source_of(*stored);
    }
    return stored;
  }

  /// Once a tick, after the frames of the bus have been given to transfer(): at most one call to the flash, which is
  /// one erase or one program begun, or 256 bytes read.
  void update(core::Microseconds now, bool safe, LogTransfer::Right right = {}) {
    transfer_.update(now, safe);
    log_.update(now, known(right));
    if (!boots_.finished()) {
      boots_.update(now);
    } else if (recorder_.busy()) {
      recorder_.update(now);
    } else if (store_.write() == PlanWrite::under_way) {
      store_.update(now);
    } else if (!log_.read(now)) {
      flights_.update(now);
    }
  }

  /// A flight goes on after a reset: what is left of it gets a record of its own. `used_sectors`: of the flights'
  /// region, as it was known before.
  void resume_flight(std::optional<std::uint32_t> used_sectors, const Recorder::Resume& resume) {
    if (used_sectors) {
      flights_.look_from(*used_sectors);
    }
    recorder_.resume_flight(resume);
  }

  /// As the frames of the bus come in.
  void receive(const protocol::LogRequest& request, LogTransfer::Right right) { log_.receive(request, known(right)); }
  /// Once a tick, behind the reports of the others.
  void send_log(core::Microseconds now, LogTransfer::Right right, hal::CanBus& bus) {
    log_.send(now, known(right), bus);
  }

  [[nodiscard]] PlanTransfer& transfer() { return transfer_; }
  [[nodiscard]] const BootCounter& boots() const { return boots_; }
  [[nodiscard]] const FlightRegion& flights() const { return flights_; }
  [[nodiscard]] Recorder& recorder() { return recorder_; }
  [[nodiscard]] const Recorder& recorder() const { return recorder_; }

  /// PlanTransfer::take_plan(); it also takes the place of one that could not be read.
  std::optional<core::FlightPlan> take_plan() {
    const std::optional<core::FlightPlan> plan = transfer_.take_plan();
    if (plan) {
      plan_source_ = protocol::PlanSource::stored;
    }
    return plan;
  }

  [[nodiscard]] FlashFacts facts() const {
    const bool plan_failed = plan_source_ == protocol::PlanSource::flash_unreadable;
    return {.has_bad_pages = flights_.bad_pages() > 0,
            .failed = plan_failed || boots_.failed() || flights_.failed(),
            .plan = plan_source_,
            .free_bytes = flights_.free_bytes(),
            .region_bytes = access_.map().flight_end - access_.map().flight_begin};
  }

 private:
  [[nodiscard]] LogTransfer::Right known(LogTransfer::Right right) const {
    right.flash_in_use = !boots_.finished() || recorder_.busy() || store_.write() == PlanWrite::under_way;
    return right;
  }

  FlashAccess access_;
  BootCounter boots_{access_};
  PlanStore store_{access_};
  FlightRegion flights_{access_};
  Recorder recorder_{flights_};
  LogTransfer log_{flights_, recorder_.plan_block()};
  PlanTransfer transfer_{store_};
  std::optional<protocol::PlanSource> plan_source_{};  ///< empty until the flash has been asked
};

}  // namespace fantail::avionics
