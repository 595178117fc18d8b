// SPDX-License-Identifier: MIT
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "log_export/about.hpp"
#include "log_export/formats.hpp"
#include "log_export/json_element.hpp"

namespace fantail::log_export {
namespace {

std::string ticks(const ReplayedFlight& source, const Selection& selection) {
  std::vector<fmt::memory_buffer> lists(selection.size());
  for_each_tick(source, [&](std::size_t, core::Microseconds, std::span<const Value> values) {
    for (std::size_t i = 0; i < selection.size(); ++i) {
      if (lists[i].size() > 0) {
        lists[i].push_back(',');
      }
      std::visit(JsonElement{lists[i]}, values[selection[i]]);
    }
  });
  fmt::memory_buffer out;
  for (std::size_t i = 0; i < selection.size(); ++i) {
    fmt::format_to(std::back_inserter(out), "{}\n    \"{}\": [", i == 0 ? "" : ",", fields()[selection[i]].name);
    out.append(lists[i]);
    out.push_back(']');
  }
  return fmt::to_string(out);
}

}  // namespace

std::string json(const ReplayedFlight& source, const Selection& selection) {
  std::string text = about(source, selection).pretty();
  text.resize(text.size() - 3);  // "\n}\n"
  return text + ",\n  \"ticks\": {" + ticks(source, selection) + "\n  }\n}\n";
}

}  // namespace fantail::log_export
