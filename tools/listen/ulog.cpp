// SPDX-License-Identifier: MIT
#include "listen/ulog.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "flight/table.hpp"
#include "listen/ulog_fields.hpp"
#include "text/error.hpp"

namespace fantail::listen {
namespace {

constexpr std::string_view magic{"ULog\x01\x12\x35", 7};
constexpr std::string_view sync{"\x2F\x73\x13\x20\x25\x0C\xBB\x12", 8};
constexpr std::string_view known_types{"BFIMPQADLCSORT"};
constexpr std::size_t header_size = 16;
constexpr std::size_t message_head = 3;
constexpr std::array<std::string_view, 2> wanted{"sensor_combined", "vehicle_air_data"};
// Before the time in the header, which is when the logger began, and after it: what says otherwise is damaged.
constexpr std::uint64_t most_before_us = 60'000'000;
constexpr std::uint64_t most_after_us = 6ULL * 3600 * 1'000'000;

class Reader {
 public:
  Reader(std::string_view file, const std::string& name) : file_{file}, name_{name} {}

  UlogColumns read() {
    if (!file_.starts_with(magic) || file_.size() < header_size) {
      refuse(fmt::format("is no ULog; it begins with {}", flight::in_quotes(file_.substr(0, 7))));
    }
    std::memcpy(&start_us_, file_.data() + magic.size() + 1, sizeof start_us_);
    for (std::size_t at = header_size; at < file_.size();) {
      at = message(at);
    }
    return columns();
  }

 private:
  struct Row {
    std::uint64_t time_us;
    std::size_t topic;  ///< of `wanted`
    std::string_view content;
  };
  struct Subscription {
    std::string_view topic;
    std::optional<std::size_t> wanted;  ///< its place in `wanted`, where its rows are
  };

  [[noreturn]] void refuse(const std::string& complaint) const {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {}", name_, complaint)};
  }

  // The message at a byte; returns where the next one is.
  std::size_t message(std::size_t at) {
    if (at + message_head > file_.size()) {
      cut_off(at);
      return file_.size();
    }
    std::uint16_t size = 0;
    std::memcpy(&size, file_.data() + at, sizeof size);
    const char type = file_[at + 2];
    const std::size_t end = at + message_head + size;
    if (known_types.find(type) == std::string_view::npos) {
      return resynchronize(at);
    }
    if (end > file_.size()) {
      const std::size_t next = file_.find(sync, at);
      if (next == std::string_view::npos) {
        cut_off(at);
        return file_.size();
      }
      return resynchronize(at);
    }
    return take(type, file_.substr(at + message_head, size)) ? end : resynchronize(at);
  }

  void cut_off(std::size_t at) { notes_.push_back(fmt::format("The ULog is cut off in a message at byte {}.", at)); }

  std::size_t resynchronize(std::size_t at) {
    const std::size_t next = file_.find(sync, at);
    const std::size_t end = next == std::string_view::npos ? file_.size() : next + sync.size();
    ++damages_;
    damaged_bytes_ += end - at;
    first_damage_ = damages_ == 1 ? at : first_damage_;
    return end;
  }

  // False: no logger writes such a message, so its size is not to be trusted either.
  bool take(char type, std::string_view content) {
    std::uint16_t id = 0;
    if (type == 'F') {
      const std::size_t colon = content.find(':');
      if (colon != std::string_view::npos) {
        formats_.emplace(content.substr(0, colon), ulog_format(content.substr(colon + 1)));
      }
    } else if (type == 'A' && content.size() > 3) {
      std::memcpy(&id, content.data() + 1, sizeof id);
      subscribe(id, content[0], content.substr(3));
    } else if (type == 'D') {
      return content.size() > sizeof id && add_row(content);
    } else if (type == 'O' && content.size() == sizeof id) {
      std::memcpy(&id, content.data(), sizeof id);
      dropped_ms_ += id;
    }
    return true;
  }

  void subscribe(std::uint16_t id, char instance, std::string_view topic) {
    const auto found = std::ranges::find(wanted, topic);
    const bool is_wanted = found != wanted.end() && instance == 0;
    subscribed_.emplace(
        id, Subscription{
                .topic = topic,
                .wanted = is_wanted ? std::optional{static_cast<std::size_t>(found - wanted.begin())} : std::nullopt});
  }

  bool add_row(std::string_view content) {
    std::uint16_t id = 0;
    std::memcpy(&id, content.data(), sizeof id);
    content.remove_prefix(sizeof id);
    const auto subscription = subscribed_.find(id);
    if (subscription == subscribed_.end()) {
      return false;
    }
    const auto format = formats_.find(subscription->second.topic);
    if (content.size() < sizeof(std::uint64_t) || (format != formats_.end() && !format->second.fits(content.size()))) {
      return false;
    }
    if (!subscription->second.wanted) {
      return true;
    }
    Row row{.time_us = 0, .topic = *subscription->second.wanted, .content = content};
    std::memcpy(&row.time_us, content.data(), sizeof row.time_us);  // every topic begins with its time
    const bool believable =
        row.time_us + most_before_us >= start_us_ && row.time_us <= start_us_ + most_before_us + most_after_us;
    if (believable) {
      rows_.push_back(row);
    } else {
      ++unbelievable_;
    }
    return true;
  }

  // A topic's messages come in the order of their times. One that stands alone with its time is damaged and left out;
  // where the others go back too, nobody knows what was when.
  void put_in_order() {
    std::vector<Row> kept;
    for (std::size_t topic = 0; topic < wanted.size(); ++topic) {
      std::vector<Row> rows;
      std::ranges::copy_if(rows_, std::back_inserter(rows), [topic](const Row& row) { return row.topic == topic; });
      const std::size_t begin = kept.size();
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool after_last = kept.size() == begin || kept.back().time_us <= rows[i].time_us;
        const bool before_next = i + 1 == rows.size() || rows[i].time_us <= rows[i + 1].time_us;
        const bool next_fits =
            i + 1 < rows.size() && (kept.size() == begin || kept.back().time_us <= rows[i + 1].time_us);
        if (after_last && (before_next || !next_fits)) {
          kept.push_back(rows[i]);
        } else if (next_fits || i + 1 == rows.size()) {
          ++alone_;
        } else {
          refuse(fmt::format("time goes back in the topic {}: from {:.6f} s to {:.6f} s", wanted[topic],
                             static_cast<double>(kept.back().time_us) * 1e-6,
                             static_cast<double>(rows[i].time_us) * 1e-6));
        }
      }
    }
    if (100 * alone_ > rows_.size()) {
      refuse(fmt::format("time goes back again and again: {} of {} messages", alone_, rows_.size()));
    }
    rows_ = std::move(kept);
    std::ranges::stable_sort(rows_, {}, &Row::time_us);
  }

  [[nodiscard]] UlogColumns columns() {
    if (std::ranges::none_of(rows_, [](const Row& row) { return row.topic == 0; })) {
      std::set<std::string_view> names;
      for (const auto& [id, subscription] : subscribed_) {
        names.insert(subscription.topic);
      }
      const std::string topics = fmt::format("{}", fmt::join(names, ", "));
      refuse(fmt::format("has no message of the topic {}; its topics are: {}", wanted[0],
                         topics.empty() ? "none" : topics.substr(0, 400)));
    }
    put_in_order();
    UlogColumns result{.columns = {{.name = "timestamp"}}, .notes = std::move(notes_)};
    for (const Row& row : rows_) {
      result.columns[0].values.push_back(static_cast<double>(row.time_us));
    }
    for (std::size_t topic = 0; topic < wanted.size(); ++topic) {
      const auto format = formats_.find(wanted[topic]);
      for (const UlogField& field : format == formats_.end() ? std::vector<UlogField>{} : format->second.fields) {
        add_column(result.columns, topic, field);
      }
    }
    if (damages_ > 0) {
      result.notes.push_back(fmt::format("The ULog is damaged in {}: {} bytes are left out, the first at byte {}.",
                                         damages_ == 1 ? "one place" : fmt::format("{} places", damages_),
                                         damaged_bytes_, first_damage_));
    }
    if (unbelievable_ > 0) {
      result.notes.push_back(
          fmt::format("{} messages with a time that is not near the start of the ULog are left out.", unbelievable_));
    }
    if (alone_ > 0) {
      result.notes.push_back(fmt::format("{} left out.", alone_ == 1
                                                             ? "One message that stands alone with its time is"
                                                             : fmt::format("{} messages that stand alone with their "
                                                                           "time are",
                                                                           alone_)));
    }
    if (dropped_ms_ > 0) {
      result.notes.push_back(fmt::format("The logger says that it dropped {} ms.", dropped_ms_));
    }
    return result;
  }

  // A name that an earlier topic has, too, is the earlier topic's: the time, first of all.
  void add_column(table_file::Columns& columns, std::size_t topic, const UlogField& field) const {
    if (std::ranges::find(columns, field.name, &table_file::Column::name) != columns.end()) {
      return;
    }
    table_file::Column column{.name = field.name};
    for (const Row& row : rows_) {
      const bool has = row.topic == topic && field.offset + field.size <= row.content.size();
      column.values.push_back(has ? field.read(row.content.data() + field.offset)
                                  : std::numeric_limits<double>::quiet_NaN());
    }
    columns.push_back(std::move(column));
  }

  std::string_view file_;
  const std::string& name_;
  std::map<std::string, UlogFormat, std::less<>> formats_;
  std::map<std::uint16_t, Subscription> subscribed_;
  std::vector<Row> rows_;
  std::vector<std::string> notes_;
  std::uint64_t start_us_ = 0;
  std::size_t unbelievable_ = 0;
  std::size_t alone_ = 0;
  std::size_t damages_ = 0;
  std::size_t damaged_bytes_ = 0;
  std::size_t first_damage_ = 0;
  std::uint64_t dropped_ms_ = 0;
};

}  // namespace

UlogColumns read_ulog(std::string_view file, const std::string& name) { return Reader{file, name}.read(); }

}  // namespace fantail::listen
