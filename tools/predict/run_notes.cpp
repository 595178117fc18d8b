// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

#include <fmt/core.h>

#include "predict/run.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

struct Note {
  std::string without_figures;
  std::string sentence;  ///< of the first run that has it
  std::size_t first_run = 0;
  std::size_t count = 0;
  bool figures_differ = false;
};

/// Whether an angle of attack is largest at the end of the guide makes no other note.
std::string without_figures(std::string sentence) {
  constexpr std::string_view begin = ", and up to ";
  constexpr std::string_view end = " s";
  const std::size_t from = sentence.find(begin);
  if (const std::size_t to = sentence.find(end, from); from != std::string::npos && to != std::string::npos) {
    sentence.erase(from, to + end.size() - from);
  }
  std::erase_if(sentence,
                [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-'; });
  return sentence;
}

std::string told(const Note& note, std::size_t runs) {
  if (note.count == runs && !note.figures_differ) {
    return note.sentence;
  }
  return fmt::format("In {} of {}{}: {}", note.count == runs ? "all" : fmt::format("{}", note.count),
                     text::counted(runs, "run"),
                     note.figures_differ ? fmt::format(" (figures of run {})", note.first_run) : "", note.sentence);
}

}  // namespace

bool is_figure_alone(std::string_view note) {
  return note.find("Static margin: ") != std::string_view::npos ||
         (note.find("The angle of attack is ") != std::string_view::npos &&
          note.find(" the canards leave the linear range") == std::string_view::npos);
}

std::vector<std::string> notes_of(const std::vector<Run>& runs) {
  std::vector<Note> notes;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<std::string> keys;  // of this run: two sentences that differ in figures only are two notes
    for (const std::string& sentence : runs[i].notes) {
      keys.push_back(without_figures(sentence));
      const std::string key = fmt::format("{}{}", keys.back(), std::ranges::count(keys, keys.back()));
      auto note = std::ranges::find(notes, key, &Note::without_figures);
      if (note == notes.end()) {
        note = notes.insert(note, {.without_figures = key, .sentence = sentence, .first_run = i});
      }
      ++note->count;
      note->figures_differ = note->figures_differ || sentence != note->sentence;
    }
  }
  std::vector<std::string> all;
  all.reserve(notes.size());
  for (const Note& note : notes) {
    all.push_back(told(note, runs.size()));
  }
  return all;
}

}  // namespace fantail::predict
