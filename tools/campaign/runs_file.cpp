// SPDX-License-Identifier: MIT
#include "campaign/runs_file.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

#include <fmt/core.h>

#include "campaign/setup.hpp"
#include "text/deflate.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

namespace fs = std::filesystem;

/// The runs of these rows, when they are all of this stretch, each with its seed.
std::optional<std::vector<FlownRun>> whole(const std::string& rows, const std::vector<Spread>& spreads,
                                           const Stretch& stretch, std::uint64_t master_seed, bool may_be_fewer) {
  constexpr std::size_t piece = 1U << 26U;  // of rows that are read at once
  try {
    std::vector<FlownRun> runs;
    for (std::size_t begin = 0; begin < rows.size();) {
      const std::size_t end = rows.size() - begin <= piece ? rows.size() : rows.rfind('\n', begin + piece) + 1;
      if (end <= begin) {
        return std::nullopt;  // no row is so long
      }
      std::ranges::move(read_rows(rows.substr(begin, end - begin), spreads, runs_name), std::back_inserter(runs));
      begin = end;
    }
    bool is_whole = runs.size() == stretch.count ||
                    (may_be_fewer && !runs.empty() && runs.size() < stretch.count && runs.size() % runs_of_a_part == 0);
    for (std::uint64_t i = 0; is_whole && i < runs.size(); ++i) {
      const std::uint64_t run = stretch.first + i;
      is_whole = runs[i].run == run && runs[i].seed == runs::seed_of_run(master_seed, run);
    }
    return is_whole ? std::optional{std::move(runs)} : std::nullopt;
  } catch (const text::Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::size_t most_bytes(const Stretch& runs) {
  constexpr std::size_t of_header = std::size_t{1} << 20U;
  constexpr std::size_t of_a_run = 4096;  // ten times what one has
  return of_header + of_a_run * static_cast<std::size_t>(runs.count);
}

std::string packed_rows(std::span<const FlownRun> runs) {
  std::string rows;
  for (const FlownRun& run : runs) {
    rows += csv_row(run);
  }
  return text::gzip(rows);
}

std::optional<std::vector<FlownRun>> unpacked_rows(const std::string& packed, const Stretch& stretch,
                                                   std::uint64_t master_seed, const std::vector<Spread>& spreads) {
  const auto rows = text::gunzip(packed, most_bytes(stretch));
  return rows ? whole(*rows, spreads, stretch, master_seed, false) : std::nullopt;
}

Finished finished_runs(const fs::path& folder, const Stretch& stretch, std::uint64_t master_seed,
                       const std::vector<Spread>& spreads, bool may_be_fewer) {
  const fs::path file = folder / runs_name;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    return {};
  }
  Finished found{.remark = file.string() + ": was damaged"};
  const std::size_t most = most_bytes(stretch);
  const auto text = text::gunzip(file_content(file, most), most);
  const std::string header = header_row(spreads);
  if (text && text->starts_with(header)) {
    const std::string rows = text->substr(header.size());
    if (const auto place = edited_row(rows)) {
      found.remark =
          fmt::format("{}: the row of run {} is not as it was written", file.string(), stretch.first + *place);
    } else {
      found.runs = whole(rows, spreads, stretch, master_seed, may_be_fewer);
      if (found.runs) {
        found.remark.clear();
      }
    }
  } else if (text && !text->substr(0, text->find('\n')).ends_with(",row_check")) {
    found.remark = file.string() + ": was written by an earlier version, whose rows carry no check";
  }
  return found;
}

}  // namespace fantail::campaign
