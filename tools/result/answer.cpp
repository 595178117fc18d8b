// SPDX-License-Identifier: MIT
#include "result/answer.hpp"

#include <algorithm>
#include <cctype>

namespace fantail::result {

std::string_view name(Answer answer) {
  switch (answer) {
    case Answer::yes: return "yes";
    case Answer::no: return "no";
    case Answer::undecided: return "undecided";
    case Answer::none: break;
  }
  return "none";
}

page::Tone tone(Answer answer) {
  switch (answer) {
    case Answer::yes: return page::Tone::good;
    case Answer::no: return page::Tone::bad;
    case Answer::undecided: return page::Tone::unsure;
    case Answer::none: break;
  }
  return page::Tone::plain;
}

std::string behind_heading(const Verdict& verdict) {
  const std::string_view heading = verdict.heading;
  const std::string_view sentence = verdict.sentence;
  const std::size_t colon = std::min(sentence.find(": "), sentence.size());
  const std::size_t blank = std::min(sentence.find(' '), colon);
  const auto is_same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  const std::string_view without_subject = sentence.substr(0, colon).substr(std::min(blank + 1, colon));
  if (sentence.substr(0, colon) == heading || std::ranges::equal(without_subject, heading, is_same)) {
    return std::string{sentence.substr(std::min(colon + 2, sentence.size()))};
  }
  const std::size_t comma = sentence.find(", ");
  const bool is_begin_of_heading =
      comma != std::string_view::npos && heading.starts_with(sentence.substr(0, comma + 1));
  return std::string{is_begin_of_heading ? sentence.substr(comma + 2) : sentence};
}

page::Tone tone(const Verdict& verdict) { return verdict.with_caution ? page::Tone::unsure : tone(verdict.answer); }

void put_answer(json::Value& all, Answer answer, std::string_view sentence, const Made& made) {
  json::Value inputs = json::Value::array();
  for (const Made::Input& one : made.inputs) {
    inputs.push_back({{"file", one.file}, {"sha256", one.sha256}});
  }
  json::Value how{{"command", made.command},
                  {"version", made.version},
                  {"seed", made.seed ? json::Value{*made.seed} : json::Value{}},
                  {"changes", made.changes},
                  {"inputs", inputs}};
  json::keep_exact(how, "seed");
  all["answer"] = name(answer);
  all["sentence"] = sentence;
  all["made"] = how;
}

}  // namespace fantail::result
