// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "input/plan_file.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

/// A comment ends with its line.
std::string comment(std::string text) {
  constexpr std::size_t width = 110;
  std::ranges::replace_if(text, [](unsigned char c) { return c < 0x20; }, ' ');
  std::string all;
  while (text.size() > width) {
    const std::size_t space = text.rfind(' ', width);
    const std::size_t end = space == std::string::npos || space == 0 ? width : space;
    all += "# " + text.substr(0, end) + "\n";
    text.erase(0, text[end] == ' ' ? end + 1 : end);
  }
  return all + "# " + text + "\n";
}

}  // namespace

std::string plan_text(const Tuning& t) {
  std::string text = comment(fmt::format(
      "Made by {} (Fantail {}) for {}. All fields except those of the law are copied from the plan it was made from.",
      t.request.command, t.request.version, t.vehicle));
  text += comment(fmt::format("Gains of {}, instead of {}.", law_words(t.after->plan), law_words(t.before.plan)));
  for (const std::string& sentence : {model_sentence(t), loop_sentence(t), flights_sentence(t)}) {
    text += sentence.empty() ? "" : comment(sentence);
  }
  for (const std::string& sentence : remarks(t)) {
    text += comment(sentence);
  }
  for (const std::string& sentence : basis(t)) {
    text += comment(sentence);
  }
  return text + "\n" + input::plan_table(t.after->plan);
}

}  // namespace fantail::tune
