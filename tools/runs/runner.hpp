// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "runs/folder.hpp"
#include "runs/row_text.hpp"

namespace fantail::runs {

/// Calls `work` once for each index below `count`, on several threads at once (0: as many as the machine has, and never
/// more than four times that). `look` is called on the caller's thread, a few times a second and at the end, with how
/// many are done. What either throws ends the others after their present piece of work and comes out of here.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t index)>& work,
                  const std::function<void(std::size_t done)>& look);

/// What belongs to a flight alone, of all 64 bits: another for every one, the same for the same number however many
/// there are. Nobody reads it.
[[nodiscard]] std::uint64_t key_of_run(std::uint64_t master_seed, std::uint64_t run);
/// The seed of a flight, which is printed and typed again: the upper 53 bits of its key. A double holds all of them,
/// and programs that read JSON often have no other numbers.
[[nodiscard]] std::uint64_t seed_of_run(std::uint64_t master_seed, std::uint64_t run);

/// Flights that follow each other.
struct Stretch {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// One of several shares of many flights, each for a machine of its own.
struct Shard {
  std::uint64_t number = 1;  ///< from 1 on
  std::uint64_t of = 1;      ///< as many as there are
};

/// Of `flights` that are flown by `of_a_part` together those of a shard: whole parts, as equal in number as they can
/// be.
[[nodiscard]] Stretch share_of(const Shard& shard, std::uint64_t flights, std::uint64_t of_a_part);

/// Flights that are flown and stored together.
struct Part {
  std::string name{};
  Stretch flights{};
};

/// "NAME00000128" of the flights from number 128 on, and so on. Which flight is in which part depends on its number
/// alone when `flights` begins with a part.
[[nodiscard]] std::vector<Part> parts_of(const Stretch& flights, std::uint64_t of_a_part, const std::string& name = {});

/// What is to be flown. Each part is a pure function of its number: no flight waits for another, in whatever order, on
/// whatever thread and on whatever day it is flown.
struct Flights {
  std::vector<Part> parts{};
  /// Flies the flights of a part, calling `flown` after each, and returns them as text.
  std::function<std::string(std::size_t part, const std::function<void()>& flown)> fly{};
  /// Takes that text, from any thread, whether it was flown now or stored before; false when it is not that of this
  /// part.
  std::function<bool(std::size_t part, const std::string& text)> take{};
  /// Called for each part in order when those before it are taken, too; true: the others need not be flown. Empty: all.
  std::function<bool(std::size_t part)> is_enough{};
};

/// Rows that are each a pure function of a flight's number; `take` is given those of a part, from any thread.
template <typename Row>
[[nodiscard]] Flights rows_of(const std::vector<Part>& parts,
                              std::function<Row(std::size_t part, std::uint64_t flight)> fly,
                              std::function<void(std::size_t part, std::vector<Row>& rows)> take) {
  Flights all{.parts = parts};
  all.fly = [parts, fly = std::move(fly)](std::size_t part, const std::function<void()>& flown) {
    RowText text;
    const Stretch& flights = parts[part].flights;
    for (std::uint64_t flight = flights.first; flight < flights.first + flights.count; ++flight) {
      Row row = fly(part, flight);
      text(row);
      flown();
    }
    return text.text();
  };
  all.take = [parts, take = std::move(take)](std::size_t part, const std::string& text) {
    std::vector<Row> rows(parts[part].flights.count);
    const bool are_these = read_rows(text, rows);
    if (are_these) {
      take(part, rows);
    }
    return are_these;
  };
  return all;
}

/// The same into `all`, which has as many rows as are to be flown.
template <typename Row>
[[nodiscard]] Flights rows_into(std::vector<Row>& all, std::uint64_t of_a_part, const std::string& name,
                                std::function<Row(std::uint64_t flight)> fly) {
  return rows_of<Row>(
      parts_of({.first = 0, .count = all.size()}, of_a_part, name),
      [fly = std::move(fly)](std::size_t /*part*/, std::uint64_t flight) { return fly(flight); },
      [&all, of_a_part](std::size_t part, std::vector<Row>& rows) {
        std::ranges::move(rows, all.begin() + static_cast<std::ptrdiff_t>(part * of_a_part));
      });
}

/// What came of it.
struct Summary {
  std::size_t parts = 0;      ///< from the first on that were wanted
  std::uint64_t flights = 0;  ///< of them
  std::uint64_t flown = 0;    ///< in this call; the others were stored
  std::uint64_t damaged = 0;  ///< damaged stored parts, which were flown again
};

/// Flies every part that `folder` does not hold yet, on several threads, and stores it there; null: nothing is kept.
/// What comes of it does not depend on the threads, nor on how often it was interrupted: a row is read back from its
/// text even when it is flown now. `look` is called with the flights done, a few times a second, on the caller's
/// thread; what it throws ends all after the present flight, and the parts that are finished stay. Throws what flying
/// throws, and text::OutputError.
Summary run(const Flights& flights, const Folder* folder, unsigned threads,
            const std::function<void(std::uint64_t done)>& look);

}  // namespace fantail::runs
