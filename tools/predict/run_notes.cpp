// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cstddef>

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

std::string without_figures(std::string sentence) {
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
