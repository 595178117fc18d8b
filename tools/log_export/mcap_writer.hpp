// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/time.hpp"

namespace fantail::log_export {

/// An MCAP file (mcap.dev/spec, version 0) of JSON messages: chunks that are not packed, each with an index, a summary,
/// and every checksum that the format has. Messages come in order of time.
class McapWriter {
 public:
  McapWriter();

  /// A topic with the JSON schema of its messages; returns what message() wants.
  [[nodiscard]] std::uint16_t topic(std::string_view name, std::string_view schema_name, std::string_view schema);
  void message(std::uint16_t topic, core::Microseconds time, std::string_view json);
  /// Names and texts about the whole file, once.
  void metadata(const std::string& name, const std::map<std::string, std::string>& texts);

  [[nodiscard]] std::string take();

 private:
  struct Place {
    std::uint64_t time_ns;
    std::uint64_t offset;
  };
  struct Topic {
    std::uint32_t messages = 0;
    std::vector<Place> in_chunk{};
  };

  void end_chunk();

  std::string out_;
  std::string schemas_;   ///< as they stand in the file; the summary repeats them
  std::string channels_;  ///< likewise
  std::vector<Topic> topics_;
  std::string chunk_;
  std::uint64_t chunk_begin_ns_ = 0;
  std::uint64_t last_ns_ = 0;
  std::uint64_t first_ns_ = 0;
  std::vector<std::string> chunk_indices_;
  std::vector<std::string> metadata_indices_;
};

}  // namespace fantail::log_export
