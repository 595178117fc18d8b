// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "link/avionics_link.hpp"
#include "link/place.hpp"

namespace fantail::link {

/// Waits until the avionics has reported, and half a second, long enough for a second one to report too. Throws
/// LinkError with advice if it stays silent for that long or uses another version of the protocol; TwoRockets if it is
/// not alone.
void await_avionics(Place& place, AvionicsLink& link, hal::Microseconds longest = hal::Microseconds{2'000'000});

/// Receives for ten heartbeats, a second of a rocket's time: by then a second rocket is detected. Throws TwoRockets. To
/// be called before another cause is given for reports that do not fit. `meanwhile` is called at every look.
void look_for_second_rocket(Place& place, AvionicsLink& link, const std::function<void()>& meanwhile = [] {});

/// The right to move the canards. It opens with the object and lives on heartbeats, which are sent while the bench
/// waits; however the object ends, by the end of its work or by an exception, the canards are centred.
class Session {
 public:
  /// Asks for nothing while another bench has a session. Throws LinkError then, and with the reason when the avionics
  /// refuses. `number`: drawn at random, because it distinguishes the frames of this bench from those of another.
  Session(Place& place, AvionicsLink& link, std::uint16_t number);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Requests these angles from now on.
  void request(const protocol::PerCanard& angles) { wanted_ = angles; }

  /// Lets time pass, with heartbeats and requests as they fall due. Throws LinkError when the session has ended.
  void wait(hal::Microseconds duration);
  /// A few frames long, and no longer than 2 ms.
  void wait();

  /// As the function of this name, with the session's heartbeats and requests; whether or not it goes on.
  void look_for_second_rocket();

  /// Ends the session and waits until the avionics confirms it. True when all canards that are driven then stand at
  /// their trims by command.
  bool close();

  [[nodiscard]] std::uint16_t number() const { return number_; }
  /// By the clock of this PC.
  [[nodiscard]] hal::Microseconds now() const { return place_.now(); }

  /// Where the canards stand without a request.
  [[nodiscard]] const Each<core::Angle>& trims() const { return trims_; }

 private:
  void look_for_another_bench();
  void open();
  [[nodiscard]] protocol::SessionReply ask_to_open();
  void learn_trims();
  void speak();
  void note_look(hal::Microseconds now);
  void say(protocol::SessionAction action);
  [[nodiscard]] std::optional<protocol::SessionReply> answer_since(std::uint64_t count) const;
  void check_still_open() const;
  [[noreturn]] void tell_end(protocol::SessionReason reason) const;

  Place& place_;
  AvionicsLink& link_;
  std::uint16_t number_;
  bool open_ = false;
  std::optional<protocol::PerCanard> wanted_;
  std::optional<std::uint64_t> unsure_since_;  ///< answers heard before this process last stood still
  Each<core::Angle> trims_{};
  hal::Microseconds next_heartbeat_{};
  hal::Microseconds last_look_{};
  hal::Microseconds longest_gap_{};  ///< between two looks, in which no heartbeat could be sent
  hal::Microseconds next_request_{};
  protocol::FrameCounter heartbeat_counter_;
  protocol::FrameCounter request_counter_;
};

}  // namespace fantail::link
