// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/terminal.hpp"
#include "json/value.hpp"
#include "link/log_download.hpp"

namespace fantail::tool {

struct BenchLogOptions {
  BenchOptions bench;
  std::string out = "out/bench_log";
  std::optional<int> flight;
  bool list = false;
  bool erase = false;
  bool discard = false;
  bool yes = false;
};

/// At one rocket, for one run of the verb.
struct LogVisit {
  explicit LogVisit(const BenchLogOptions& chosen) : options{chosen}, place{chosen.bench.interface}, link{place.bus()} {
    await_rocket(chosen.bench, place, link);
    info = reader.info();
    json["used_bytes"] = info.used_bytes;
    json["free_bytes"] = info.free_bytes;
  }

  template <typename... Values>
  void tell(fmt::format_string<Values...> text, Values&&... values) const {
    if (!options.bench.json) {
      show(text, std::forward<Values>(values)...);
    }
  }

  const BenchLogOptions& options;
  CanPlace place;
  link::AvionicsLink link;
  link::LogReader reader{place, link};
  link::LogInfo info{};
  json::Value json{};
  std::vector<std::byte> record{};  ///< as it was downloaded, verified and written
  link::LogCheck check{};           ///< of that
};

/// Asks, and erases the record of the rocket if the download is complete, or nothing better can be downloaded.
/// Throws RequirementNotMet when it is kept.
void erase_record(LogVisit& visit);

}  // namespace fantail::tool
