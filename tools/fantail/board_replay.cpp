// SPDX-License-Identifier: MIT
#include "fantail/board_replay.hpp"

#include <fmt/format.h>

#include "flight_log/flight_log.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/regenerate.hpp"

namespace fantail::tool {

BoardReplay board_replay(std::span<const std::byte> log) {
  if (log.empty()) {
    return {.note = "Nothing was recorded, so nothing of the flight could be repeated on this computer."};
  }
  BoardReplay all{.note = "The flash of the board, repeated on this computer:"};
  for (const flight_log::Flight& recorded : flight_log::parse_log(log, "flight.ftl").flights) {
    const flight_log::Regeneration replayed =
        flight_log::replay(recorded, "flight.ftl", flight_log::plan_for_replay(recorded, "flight.ftl", {}));
    all.note += fmt::format("{} {}", all.note.ends_with(':') ? "" : ";", flight_log::replay_text(recorded, replayed));
    all.differs = all.differs || replayed.differing > 0;
  }
  all.note += '.';
  return all;
}

}  // namespace fantail::tool
