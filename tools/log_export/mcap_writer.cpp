// SPDX-License-Identifier: MIT
#include "log_export/mcap_writer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>

#include "table_file/little_endian.hpp"
#include "text/deflate.hpp"

namespace fantail::log_export {
namespace {

using table_file::put;

constexpr std::string_view magic = "\x89MCAP0\r\n";
enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

void put_text(std::string& out, std::string_view text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  out += text;
}

std::string record(Opcode opcode, std::string_view content) {
  std::string out;
  put(out, static_cast<std::uint8_t>(opcode));
  put(out, std::uint64_t{content.size()});
  return out += content;
}

std::uint64_t nanoseconds(core::Microseconds time) { return static_cast<std::uint64_t>(time.count()) * 1000; }

}  // namespace

McapWriter::McapWriter() : out_{magic} {
  std::string header;
  put_text(header, "");  // no profile
  put_text(header, "Fantail");
  out_ += record(Opcode::header, header);
}

std::uint16_t McapWriter::topic(std::string_view name, std::string_view schema_name, std::string_view schema) {
  topics_.emplace_back();
  const auto id = static_cast<std::uint16_t>(topics_.size());  // of a schema 0 means none
  std::string content;
  put(content, id);
  put_text(content, schema_name);
  put_text(content, "jsonschema");
  put_text(content, schema);
  schemas_ += record(Opcode::schema, content);
  out_ += record(Opcode::schema, content);
  content.clear();
  put(content, id);
  put(content, id);
  put_text(content, name);
  put_text(content, "json");
  put_text(content, "");  // no metadata
  channels_ += record(Opcode::channel, content);
  out_ += record(Opcode::channel, content);
  return id;
}

void McapWriter::message(std::uint16_t topic, core::Microseconds time, std::string_view json) {
  const std::uint64_t time_ns = nanoseconds(time);
  if (chunk_.empty()) {
    chunk_begin_ns_ = time_ns;
    first_ns_ = chunk_indices_.empty() ? time_ns : first_ns_;
  }
  last_ns_ = time_ns;
  Topic& of = topics_[topic - 1U];
  of.in_chunk.push_back({time_ns, chunk_.size()});
  std::string content;
  put(content, topic);
  put(content, of.messages++);
  put(content, time_ns);
  put(content, time_ns);
  content += json;
  chunk_ += record(Opcode::message, content);
  constexpr std::size_t enough = std::size_t{1} << 20U;
  if (chunk_.size() >= enough) {
    end_chunk();
  }
}

void McapWriter::end_chunk() {
  if (chunk_.empty()) {
    return;
  }
  const std::uint64_t begin = out_.size();
  std::string content;
  put(content, chunk_begin_ns_);
  put(content, last_ns_);
  put(content, std::uint64_t{chunk_.size()});
  put(content, text::crc32(chunk_));
  put_text(content, "");  // not packed
  put(content, std::uint64_t{chunk_.size()});
  content += chunk_;
  out_ += record(Opcode::chunk, content);
  const std::uint64_t end = out_.size();

  std::string offsets;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    if (topics_[i].in_chunk.empty()) {
      continue;
    }
    const auto id = static_cast<std::uint16_t>(i + 1);
    put(offsets, id);
    put(offsets, std::uint64_t{out_.size()});
    std::string places;
    for (const Place& place : topics_[i].in_chunk) {
      put(places, place.time_ns);
      put(places, place.offset);
    }
    topics_[i].in_chunk.clear();
    content.clear();
    put(content, id);
    put_text(content, places);
    out_ += record(Opcode::message_index, content);
  }

  content.clear();
  put(content, chunk_begin_ns_);
  put(content, last_ns_);
  put(content, begin);
  put(content, end - begin);
  put_text(content, offsets);
  put(content, std::uint64_t{out_.size()} - end);
  put_text(content, "");
  put(content, std::uint64_t{chunk_.size()});
  put(content, std::uint64_t{chunk_.size()});
  chunk_indices_.push_back(record(Opcode::chunk_index, content));
  chunk_.clear();
}

void McapWriter::metadata(const std::string& name, const std::map<std::string, std::string>& texts) {
  std::string pairs;
  for (const auto& [key, text] : texts) {
    put_text(pairs, key);
    put_text(pairs, text);
  }
  std::string content;
  put_text(content, name);
  put_text(content, pairs);
  const std::string whole = record(Opcode::metadata, content);
  content.clear();
  put(content, std::uint64_t{out_.size()});
  put(content, std::uint64_t{whole.size()});
  put_text(content, name);
  metadata_indices_.push_back(record(Opcode::metadata_index, content));
  out_ += whole;
}

std::string McapWriter::take() {
  end_chunk();
  std::string content;
  put(content, text::crc32(out_));
  out_ += record(Opcode::data_end, content);

  const std::uint64_t summary = out_.size();
  std::string counts;
  std::uint64_t messages = 0;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    put(counts, static_cast<std::uint16_t>(i + 1));
    put(counts, std::uint64_t{topics_[i].messages});
    messages += topics_[i].messages;
  }
  content.clear();
  put(content, messages);
  put(content, static_cast<std::uint16_t>(topics_.size()));
  put(content, static_cast<std::uint32_t>(topics_.size()));
  put(content, std::uint32_t{0});  // attachments
  put(content, static_cast<std::uint32_t>(metadata_indices_.size()));
  put(content, static_cast<std::uint32_t>(chunk_indices_.size()));
  put(content, first_ns_);
  put(content, last_ns_);
  put_text(content, counts);
  const auto joined = [](const std::vector<std::string>& list) {
    return std::accumulate(list.begin(), list.end(), std::string{});
  };
  const std::array groups{std::pair{Opcode::schema, schemas_}, std::pair{Opcode::channel, channels_},
                          std::pair{Opcode::statistics, record(Opcode::statistics, content)},
                          std::pair{Opcode::chunk_index, joined(chunk_indices_)},
                          std::pair{Opcode::metadata_index, joined(metadata_indices_)}};
  std::string offsets;
  for (const auto& [opcode, records] : groups) {
    if (!records.empty()) {
      content.clear();
      put(content, static_cast<std::uint8_t>(opcode));
      put(content, std::uint64_t{out_.size()});
      put(content, std::uint64_t{records.size()});
      offsets += record(Opcode::summary_offset, content);
      out_ += records;
    }
  }
  const std::uint64_t offsets_at = out_.size();
  out_ += offsets;

  // The checksum of the summary goes as far as the footer's own fields before it.
  content.clear();
  put(content, summary);
  put(content, offsets_at);
  put(content, std::uint32_t{0});
  std::string footer = record(Opcode::footer, content);
  footer.resize(footer.size() - sizeof(std::uint32_t));
  out_ += footer;
  put(out_, text::crc32(std::string_view{out_}.substr(summary)));
  out_ += magic;
  return std::move(out_);
}

}  // namespace fantail::log_export
