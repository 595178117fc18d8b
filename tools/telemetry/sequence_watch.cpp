// SPDX-License-Identifier: MIT
#include "telemetry/sequence_watch.hpp"

namespace fantail::telemetry {

ChannelFigures difference(const ChannelFigures& now, const ChannelFigures& before) {
  return {.received = now.received - before.received,
          .lost = now.lost - before.lost,
          .late = now.late - before.late,
          .duplicate = now.duplicate - before.duplicate,
          .ignored = now.ignored - before.ignored,
          .unreadable = now.unreadable - before.unreadable};
}

Arrival SequenceWatch::take(std::int64_t sequence, ChannelFigures& figures) {
  if (!first_) {
    first_ = highest_ = sequence;
    seen_.set(0);
    figures.received += 1;
    return Arrival::newest;
  }
  // Numbers are not negative, so their difference has a number too.
  const std::int64_t ahead = sequence - highest_;
  if (ahead > longest_gap || ahead <= -window) {
    return Arrival::far_off;
  }
  if (ahead > 0) {
    seen_ = ahead < window ? seen_ << static_cast<std::size_t>(ahead) : std::bitset<window>{};
    seen_.set(0);
    highest_ = sequence;
    figures.received += 1;
    figures.lost += ahead - 1;
    return Arrival::newest;
  }
  const auto place = static_cast<std::size_t>(-ahead);
  if (seen_.test(place)) {
    figures.duplicate += 1;
    return Arrival::duplicate;
  }
  seen_.set(place);
  figures.late += 1;
  if (sequence > *first_) {  // from before we listened, it was never counted as lost
    figures.received += 1;
    figures.lost -= 1;
  }
  return Arrival::late;
}

}  // namespace fantail::telemetry
