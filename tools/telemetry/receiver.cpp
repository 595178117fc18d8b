// SPDX-License-Identifier: MIT
#include "telemetry/receiver.hpp"

#include <algorithm>
#include <utility>

namespace fantail::telemetry {
namespace {

// Enough for a week of restarts; a stranger who invents one with every packet must not fill the memory.
constexpr std::size_t most_earlier_runs = 10'000;
// Who looks once a second does not do so to the microsecond.
constexpr hal::Microseconds jitter{200'000};
constexpr std::size_t most_events = 1'000;

}  // namespace

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

void Receiver::take(std::string_view channel, std::span<const std::byte> bytes, hal::Microseconds now) {
  const auto ours = channel_named(channel);
  if (!ours) {
    return;
  }
  if (const auto message = decode(*ours, bytes)) {
    take(*ours, *message, now);
  } else {
    totals_[index(*ours)].unreadable += 1;
  }
}

void Receiver::take(Channel channel, const Decoded& message, hal::Microseconds now) {
  const Stamp& stamp = message.stamp;
  if (!run_ || (stamp.run != *run_ && !earlier_runs_.contains(stamp.run))) {
    begin_anew(stamp.run);
  }
  ChannelFigures& figures = totals_[index(channel)];
  const auto arrive = [&] { return sequences_[index(channel)].take(stamp.sequence, figures); };
  Arrival arrival = stamp.run == *run_ ? arrive() : Arrival::far_off;
  if (arrival == Arrival::newest) {
    last_news_ = now;
    suspects_ = {};
  } else if (arrival == Arrival::far_off || now - last_news_ > stale_after) {
    if (is_another_start(channel, stamp)) {
      begin_anew(stamp.run);
      arrival = arrive();
      last_news_ = now;
    } else {
      figures.ignored += arrival == Arrival::far_off ? 1 : 0;
    }
  }
  keep(message, arrival, now);
}

// A log that is played again has the same run and the same numbers. Packets that were only held up on their way do not
// come in such a long row.
bool Receiver::is_another_start(Channel channel, const Stamp& stamp) {
  Suspect& suspect = suspects_[index(channel)];
  const bool goes_on = suspect.rising > 0 && suspect.run == stamp.run && stamp.sequence > suspect.sequence &&
                       stamp.sequence - suspect.sequence <= SequenceWatch::longest_gap;
  suspect = {.run = stamp.run, .sequence = stamp.sequence, .rising = goes_on ? suspect.rising + 1 : 1};
  return suspect.rising >= restart_after;
}

void Receiver::begin_anew(std::int64_t run) {
  if (run_) {
    restarts_ += 1;
    if (earlier_runs_.size() >= most_earlier_runs) {
      earlier_runs_.clear();
    }
    earlier_runs_.insert(*run_);
  }
  run_ = run;
  for (SequenceWatch& sequence : sequences_) {
    sequence.begin_anew();
  }
  suspects_ = {};
  heard_ = {};
}

void Receiver::keep(const Decoded& message, Arrival arrival, hal::Microseconds now) {
  if (const auto* event = std::get_if<Event>(&message.content)) {
    if ((arrival == Arrival::newest || arrival == Arrival::late) && events_.size() < most_events) {
      events_.push_back({.content = *event, .stamp = message.stamp, .came = now});
    }
  }
  if (arrival != Arrival::newest) {
    return;
  }
  std::visit(
      [&]<typename Content>(const Content& content) {
        std::get<std::optional<Heard<Content>>>(heard_) = {.content = content, .stamp = message.stamp, .came = now};
      },
      message.content);
}

std::vector<Heard<Event>> Receiver::take_events() {
  std::vector<Heard<Event>> events = std::exchange(events_, {});
  std::ranges::stable_sort(events, {}, [](const Heard<Event>& event) { return event.stamp.sequence; });
  return events;
}

void Receiver::look(hal::Microseconds now) {
  marks_.push_back({.time = now, .totals = totals_});
  while (marks_.size() > 2 && now - marks_[1].time > recent_time - jitter) {
    marks_.pop_front();
  }
}

ChannelFigures Receiver::recent(Channel channel) const {
  return difference(marks_.back().totals[index(channel)], marks_.front().totals[index(channel)]);
}

hal::Microseconds Receiver::recent_span() const { return marks_.back().time - marks_.front().time; }

}  // namespace fantail::telemetry
