// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "json/value.hpp"
#include "page/page.hpp"

namespace fantail::result {

/// The answer of a verb to the question that it was asked; none: it measures, and nothing was asked.
enum class Answer : std::uint8_t { none, yes, no, undecided };
[[nodiscard]] std::string_view name(Answer answer);
/// The colour of a page and a terminal for it.
[[nodiscard]] page::Tone tone(Answer answer);

/// In JSON "answer" and "sentence".
struct Verdict {
  Answer answer;                         ///< has no default: a verdict without an answer does not compile
  std::string heading;                   ///< "Go"
  std::string sentence;                  ///< may begin with the heading and a colon
  std::vector<std::string> beside{};     ///< what a reader should know beside it, a sentence each
  std::vector<std::string> not_in_it{};  ///< what the answer does not count, a sentence or two each
  bool with_caution = false;             ///< a yes that the sentence limits: not in the colour of a yes
  std::string not_in_it_heading = "Not in the verdict:";
};
[[nodiscard]] page::Tone tone(const Verdict& verdict);

/// The sentence without what its heading says already. "Go: every ..." below "Go" is "every ...", "Roll not held: up to
/// ..." below "Not held" is "up to ...", and "Steady, 20 deg ..." below "Steady, off the command" is "20 deg ...".
[[nodiscard]] std::string behind_heading(const Verdict& verdict);

/// How somebody gets the same again; in JSON "made".
struct Made {
  struct Input {
    std::string file{};  ///< without its folder; of a flight, which is a folder, with it
    std::string sha256{};
  };
  std::string command{};  ///< empty: no command line made it
  std::string version{};
  std::optional<std::uint64_t> seed{};  ///< empty: nothing was drawn
  std::vector<std::string> changes{};   ///< "run.canard_fault=end_control"
  std::vector<Input> inputs{};
};

/// The three members that the JSON of every verb has.
void put_answer(json::Value& all, Answer answer, std::string_view sentence, const Made& made);

}  // namespace fantail::result
