// SPDX-License-Identifier: MIT
#include "fantail/flight_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

std::string text_of(std::span<const std::byte> bytes) {
  std::string text(bytes.size(), '\0');
  std::ranges::transform(bytes, text.begin(), [](std::byte byte) { return static_cast<char>(byte); });
  return text;
}

bool holds(const std::filesystem::path& path, const std::string& content) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) != content.size() || error) {
    return false;
  }
  std::ifstream file{path, std::ios::binary};
  return std::string{std::istreambuf_iterator<char>{file}, {}} == content;
}

}  // namespace

std::vector<FlightFile> write_flights(const std::filesystem::path& folder, std::span<const std::byte> record,
                                      std::size_t first) {
  std::vector<FlightFile> files;
  std::vector<text::NamedFile> contents;
  std::set<std::string> taken;
  // Either the name is free, or the file of that name is this one.
  const auto usable = [&](const std::string& name, const std::string& content) {
    return !taken.contains(name) && (!std::filesystem::exists(folder / name) || holds(folder / name, content));
  };
  const auto add = [&](const link::RecordedFlight& flight, std::size_t number, const char* pattern) {
    std::string content = text_of(record.subspan(flight.begin, flight.end - flight.begin));
    std::string name;
    do {
      name = fmt::format(fmt::runtime(pattern), number);
      number += 1;
    } while (!usable(name, content));
    taken.insert(name);
    files.push_back({name, flight});
    contents.push_back({name, std::move(content)});
  };
  const std::vector<link::RecordedFlight> flights = link::split_flights(record);
  for (std::size_t i = 0; i < flights.size(); ++i) {
    add(flights[i], first + i, "flight_{:03}.ftl");
  }
  if (flights.empty()) {
    add({.begin = 0, .end = record.size(), .damaged_bytes = record.size()}, first, "unreadable_{:03}.bin");
  }
  text::OutputFolder{folder}.write(contents);
  for (const text::NamedFile& file : contents) {
    if (!holds(folder / file.name, file.content)) {
      throw text::OutputError{(folder / file.name).string() + ": does not hold what was written to it"};
    }
  }
  return files;
}

}  // namespace fantail::tool
