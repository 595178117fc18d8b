// SPDX-License-Identifier: MIT
#include "link/log_download.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_header.hpp"
#include "text/output_folder.hpp"

namespace fantail::link {
namespace {

bool same_record(LogReader& reader, const LogStretch& stretch, const LogPart& part) {
  return part.size() <= stretch.size && still_there(reader, stretch.offset, part.read(0, part.size()));
}

// Of the smallest sector that there is in NOR flash; larger ones are multiples of it.
constexpr std::uint32_t sector = 4096;

std::optional<ListedFlight> flight_at(LogReader& reader, std::uint32_t offset, std::uint32_t room) {
  const std::vector<std::byte> head = read_all(reader, offset, protocol::log_head_size);
  const auto length = static_cast<std::uint32_t>(protocol::get<2>(head, 2));
  const bool first_header = head[0] == protocol::log_sync &&
                            head[1] == static_cast<std::byte>(protocol::LogRecord::header) &&
                            protocol::get<4>(head, 4) == 0;
  const std::uint32_t size = static_cast<std::uint32_t>(protocol::log_frame_overhead) + length;
  if (!first_header || length > protocol::largest_log_payload || size > room) {
    return std::nullopt;
  }
  const std::vector<std::byte> bytes = read_all(reader, offset, size);
  const auto frame = protocol::LogFrameReader{bytes}.next();
  const auto header = frame && frame->position == 0 ? protocol::decode_log_header(frame->payload) : std::nullopt;
  if (!header) {
    return std::nullopt;
  }
  return ListedFlight{
      .stretch = {.offset = offset}, .vehicle = std::string{header->vehicle}, .power_up = header->power_up};
}

}  // namespace

std::vector<std::byte> read_all(LogReader& reader, std::uint32_t offset, std::uint32_t size) {
  std::vector<std::byte> bytes;
  while (bytes.size() < size) {
    const auto done = static_cast<std::uint32_t>(bytes.size());
    const std::vector<std::byte> more = reader.read(offset + done, size - done);
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  return bytes;
}

bool still_there(LogReader& reader, std::uint32_t offset, std::span<const std::byte> bytes) {
  const std::size_t compared = std::min<std::size_t>(bytes.size(), protocol::largest_log_chunk);
  const auto same = [&](std::size_t at) {
    return std::ranges::equal(bytes.subspan(at, compared), read_all(reader, offset + static_cast<std::uint32_t>(at),
                                                                    static_cast<std::uint32_t>(compared)));
  };
  return same(0) && same(bytes.size() - compared);
}

LogPart::LogPart(std::filesystem::path path) : path_{std::move(path)} {
  std::error_code error;
  if (path_.has_parent_path()) {
    std::filesystem::create_directories(path_.parent_path(), error);
  }
  if (error) {
    throw text::OutputError{path_.parent_path().string() + ": " + error.message()};
  }
  open(std::ios::app);
  const std::streamoff end = file_.seekp(0, std::ios::end).tellp();
  if (end < 0) {
    fail();
  }
  size_ = static_cast<std::uint32_t>(end);
}

void LogPart::fail() const { throw text::OutputError{path_.string() + ": " + std::strerror(errno)}; }

void LogPart::open(std::ios::openmode mode) {
  file_.close();
  file_.clear();
  errno = 0;
  file_.open(path_, std::ios::binary | mode);
  if (!file_) {
    fail();
  }
}

std::vector<std::byte> LogPart::read(std::uint32_t offset, std::uint32_t size) const {
  std::vector<std::byte> bytes(size);
  std::ifstream file{path_, std::ios::binary};
  file.seekg(offset);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {  // NOLINT
    throw text::OutputError{path_.string() + ": the downloaded part cannot be read back"};
  }
  return bytes;
}

void LogPart::append(std::span<const std::byte> bytes) {
  errno = 0;
  const auto* const text = reinterpret_cast<const char*>(bytes.data());  // NOLINT
  if (!file_.write(text, static_cast<std::streamsize>(bytes.size())).flush()) {
    fail();
  }
  size_ += static_cast<std::uint32_t>(bytes.size());
}

void LogPart::overwrite(std::uint32_t offset, std::span<const std::byte> bytes) {
  errno = 0;
  std::fstream file{path_, std::ios::binary | std::ios::in | std::ios::out};
  file.seekp(offset);
  const auto* const text = reinterpret_cast<const char*>(bytes.data());  // NOLINT
  if (!file.write(text, static_cast<std::streamsize>(bytes.size())).flush()) {
    fail();
  }
}

void LogPart::start_anew() {
  open(std::ios::trunc);
  size_ = 0;
}

void LogPart::remove() {
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

std::uint32_t download(LogReader& reader, const LogStretch& stretch, LogPart& part,
                       const std::function<void(std::uint32_t)>& progress) {
  if (part.size() > 0 && !same_record(reader, stretch, part)) {
    part.start_anew();
  }
  const std::uint32_t before = part.size();
  while (part.size() < stretch.size) {
    part.append(reader.read(stretch.offset + part.size(), stretch.size - part.size()));
    progress(part.size());
  }
  return before;
}

std::vector<ListedFlight> list_flights(LogReader& reader, std::uint32_t used_bytes,
                                       const std::function<void(std::uint32_t)>& progress) {
  std::vector<ListedFlight> flights;
  for (std::uint32_t offset = 0; offset + sector <= used_bytes; offset += sector) {
    if (auto flight = flight_at(reader, offset, used_bytes - offset)) {
      flights.push_back(std::move(*flight));
    }
    if (!flights.empty()) {
      flights.back().stretch.size = offset + sector - flights.back().stretch.offset;
    }
    progress(offset + sector);
  }
  return flights;
}

}  // namespace fantail::link
