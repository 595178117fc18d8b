// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/time.hpp"

namespace fantail::link {

/// One flight in a downloaded record, as far as its frames tell.
struct RecordedFlight {
  std::size_t begin = 0;  ///< its bytes in the record
  std::size_t end = 0;
  std::string vehicle{};                    ///< of its first intact header
  std::optional<std::uint32_t> power_up{};  ///< of the same
  core::Microseconds first_time{};
  core::Microseconds last_time{};
  std::size_t records = 0;          ///< intact ones
  std::size_t missing_records = 0;  ///< by their numbers, without those that the recorder itself left out
  std::size_t damaged_bytes = 0;    ///< that belong to no intact record and are not erased flash
  std::size_t cut_off_bytes = 0;    ///< of its last record, which a power cut left unfinished; they are no damage

  [[nodiscard]] double duration_s() const { return 1e-6 * static_cast<double>((last_time - first_time).count()); }
  [[nodiscard]] bool intact() const { return missing_records == 0 && damaged_bytes == 0; }
};

/// The flights of a record, one behind the other. Each begins where the numbers of the records begin anew or a header
/// names another flight, and ends with its last byte that is not erased flash.
[[nodiscard]] std::vector<RecordedFlight> split_flights(std::span<const std::byte> record);

}  // namespace fantail::link
