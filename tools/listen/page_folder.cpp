// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "json/value.hpp"
#include "listen/answer.hpp"
#include "text/input_file.hpp"

namespace fantail::listen {
namespace {

namespace fs = std::filesystem;

// The log that the page in a folder is of, by its own words; empty: it does not say.
std::string whose(const fs::path& folder) {
  const std::string text = text::read_if_there(folder / "listen.json").value_or(std::string{});
  try {
    return json::parse(text)["log"].text();
  } catch (const json::Error&) {
    return {};
  }
}

// A file that is gone, or whose name is no UTF-8, is known by its words.
bool is_same_file(const std::string& by_page, const fs::path& log) {
  std::error_code not_there;
  return fs::equivalent(by_page, log, not_there) || by_page == json::parse(json::Value{log.string()}.dump()).text() ||
         fs::absolute(by_page).lexically_normal() == fs::absolute(log).lexically_normal();
}

}  // namespace

PageFolder page_folder(const fs::path& under, const fs::path& log) {
  const std::string name = log.stem().string();
  PageFolder place{.folder = under / name};
  for (int number = 2;; ++number) {
    std::error_code ignored;
    if (!fs::exists(place.folder / "listen.json", ignored) && !fs::exists(place.folder / "listen.html", ignored)) {
      return place;
    }
    const std::string other = whose(place.folder);
    if (!other.empty() && is_same_file(other, log)) {
      return place;
    }
    if (place.remark.empty()) {
      place.remark = fmt::format("{} has the page of {}, which is not overwritten.", place.folder.string(),
                                 other.empty() ? "an unnamed file" : "another file, " + other);
    }
    place.folder = under / fmt::format("{}_{}", name, number);
  }
}

}  // namespace fantail::listen
