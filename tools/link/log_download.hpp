// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "link/log_reader.hpp"

namespace fantail::link {

/// What has been downloaded so far, in a file that outlives this program. Verified bytes only are written to it, in
/// order; a program that is killed can leave it shorter. A power cut, a disk or a person can damage it, so data
/// read back must be verified again. Every call throws text::OutputError with the path and the system's reason.
class LogPart {
 public:
  /// Continues an existing file; makes its folder.
  explicit LogPart(std::filesystem::path path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] std::vector<std::byte> read(std::uint32_t offset, std::uint32_t size) const;
  void append(std::span<const std::byte> bytes);
  /// Puts other bytes in the place of some that are there.
  void overwrite(std::uint32_t offset, std::span<const std::byte> bytes);
  void start_anew();
  /// When it is no longer needed.
  void remove();

 private:
  void open(std::ios::openmode mode);
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::ofstream file_;
  std::uint32_t size_ = 0;
};

/// A stretch of the record, from `offset` on.
struct LogStretch {
  std::uint32_t offset = 0;
  std::uint32_t size = 0;
};

/// As many bytes as asked for, in as many requests as it takes.
[[nodiscard]] std::vector<std::byte> read_all(LogReader& reader, std::uint32_t offset, std::uint32_t size);

/// Whether the avionics still has these bytes from `offset` on, by the first and the last 1792 of them.
[[nodiscard]] bool still_there(LogReader& reader, std::uint32_t offset, std::span<const std::byte> bytes);

/// Fills the part until it holds the stretch, and returns the bytes that were there already. It goes on with those when
/// their first and last 1792 bytes are still what the avionics has; otherwise they are of another record, and it starts
/// anew. `progress` is called with the bytes done; it may throw to give up, and so may the place where the bench waits:
/// then the part stays.
std::uint32_t download(LogReader& reader, const LogStretch& stretch, LogPart& part,
                       const std::function<void(std::uint32_t)>& progress);

/// A flight in the avionics' record, of which only the beginning has been read.
struct ListedFlight {
  LogStretch stretch{};  ///< up to the next one, or to the end of the record
  std::string vehicle{};
  std::uint32_t power_up = 0;
};

/// Looks where flights begin. Each begins on a fresh sector with its header, so the first bytes of every sector are
/// asked for: 3 MB take some 20 s. A flight whose first header is damaged is taken for a part of the one before it.
/// `progress` is called with the bytes searched.
[[nodiscard]] std::vector<ListedFlight> list_flights(LogReader& reader, std::uint32_t used_bytes,
                                                     const std::function<void(std::uint32_t)>& progress);

/// The result of verifying a downloaded stretch.
struct LogCheck {
  std::uint32_t mended_bytes = 0;    ///< differed from the avionics' and were corrected
  std::uint32_t unsteady_bytes = 0;  ///< in chunks that were read differently each time
  bool intact = false;               ///< every record is there, by its CRC-32C and its number, up to a last cut-off one
  /// All that is on this PC is what the avionics has: each byte stands under the CRC-32C of its record, or two fetches
  /// of it agree. What is not intact then is damaged in the flash.
  [[nodiscard]] bool agrees() const { return unsteady_bytes == 0; }
};

/// Verifies a part that holds the whole stretch, and fetches again what fails. Of the first `resumed_bytes`, which this
/// run did not fetch, everything that no intact record covers is fetched again. If a flight is not whole then, so is
/// the whole stretch: only two fetches that agree make it damage in the flash, or a record that was cut off there.
/// `progress` is called with the bytes fetched again; it may throw to give up, and the part stays.
[[nodiscard]] LogCheck verify(LogReader& reader, const LogStretch& stretch, LogPart& part, std::uint32_t resumed_bytes,
                              const std::function<void(std::uint32_t)>& progress);

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
