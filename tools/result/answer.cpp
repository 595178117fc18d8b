// SPDX-License-Identifier: MIT
#include "result/answer.hpp"

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
