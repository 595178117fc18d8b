// SPDX-License-Identifier: MIT
#include "fantail/log_names.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

/// The name of a path behind so many folders, without the sign of a folder at its end.
std::string end_of(const std::filesystem::path& path, std::ptrdiff_t folders) {
  const std::filesystem::path whole = (std::filesystem::absolute(path) / "").lexically_normal().parent_path();
  std::filesystem::path end;
  const std::ptrdiff_t parts = std::min(folders + 1, std::distance(whole.begin(), whole.end()));
  for (auto part = std::prev(whole.end(), parts); part != whole.end(); ++part) {
    end /= *part;
  }
  return end.string();
}

}  // namespace

LogNames distinct_names(const NamedMotion& a, const NamedMotion& b) {
  constexpr std::ptrdiff_t all = 1000;
  const bool is_same = end_of(a.path, all) == end_of(b.path, all);
  std::ptrdiff_t folders = 0;
  while (!is_same && end_of(a.path, folders) == end_of(b.path, folders)) {
    ++folders;
  }
  const auto name = [&](const NamedMotion& log, const char* place) {
    const std::string more = a.motion != b.motion ? " (" + log.motion + ")" : is_same ? place : "";
    return text::printable(end_of(log.path, folders)) + more;
  };
  return {name(a, " (first)"), name(b, " (second)")};
}

}  // namespace fantail::tool
