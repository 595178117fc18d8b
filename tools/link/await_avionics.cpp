// SPDX-License-Identifier: MIT
// Who is on the bus, before anything is asked of it.
#include "link/session.hpp"

namespace fantail::link {
namespace {

using hal::Microseconds;

constexpr Microseconds glance{2'000};
// While one rocket sends so many, a second one has sent enough to be told from it.
constexpr std::uint64_t heartbeats_of_one = 5;
constexpr Microseconds time_to_tell{2'000'000};
// Of a node on a busy PC the reports that come once a second may come late.
constexpr Microseconds slow_reports{3'000'000};

void require_our_version(const AvionicsLink& link) {
  const auto& heartbeat = link.newest<protocol::HeartbeatReport>();
  if (heartbeat && heartbeat->message.version != protocol::bus_protocol_version) {
    throw LinkError{"the avionics uses version " + std::to_string(heartbeat->message.version) +
                    " of the bus protocol; this program uses version " +
                    std::to_string(int{protocol::bus_protocol_version})};
  }
}

}  // namespace

void await_avionics(Place& place, AvionicsLink& link, Microseconds longest) {
  Timeout timeout{longest, place.now()};
  Timeout for_all_reports{longest + slow_reports, place.now()};
  // One heartbeat of another version may be anybody's frame with this identifier: it has no CRC. Of the avionics' own,
  // the next follows within 100 ms.
  const auto speaks_our_version = [&] {
    const auto& heartbeat = link.newest<protocol::HeartbeatReport>();
    return heartbeat && heartbeat->message.version == protocol::bus_protocol_version;
  };
  const auto complete = [&] {
    return speaks_our_version() && link.count<protocol::HeartbeatReport>() >= heartbeats_of_one &&
           link.count<protocol::StatusReport>() > 0 && link.count<protocol::LimitReport>() > 0 &&
           link.count<protocol::BoardReport>() > 0;
  };
  for (link.listen(place.now()); !complete(); link.listen(place.now())) {
    link.expect_one_rocket();
    const bool no_answer = timeout.expired(place.now()) && (link.figures().frames == 0 || !speaks_our_version());
    if (for_all_reports.expired(place.now()) || no_answer) {
      require_our_version(link);
      throw LinkError{link.figures().frames == 0
                          ? "the avionics is silent: is it powered (its node running), is the bus terminated at both "
                            "ends, and does it run at 1 Mbit/s?"
                          : "the avionics sends frames, but its heartbeat, state, canard limits or board report is "
                            "missing: is the bus overloaded?"};
    }
    place.wait(glance);
  }
  link.expect_one_rocket();
}

void look_for_second_rocket(Place& place, AvionicsLink& link, const std::function<void()>& meanwhile) {
  const std::uint64_t enough = link.count<protocol::HeartbeatReport>() + 2 * heartbeats_of_one;
  for (Timeout timeout{time_to_tell, place.now()};
       link.count<protocol::HeartbeatReport>() < enough && !timeout.expired(place.now());) {
    meanwhile();
    place.wait(glance);
    link.listen(place.now());
    link.expect_one_rocket();
  }
}

}  // namespace fantail::link
