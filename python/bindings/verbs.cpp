// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "campaign/campaign.hpp"
#include "fantail/command_line.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/verb_table.hpp"
#include "manual/command.hpp"
#include "python/bindings/bind.hpp"
#include "text/error.hpp"

namespace nb = nanobind;

namespace fantail::python {
namespace {

using Texts = std::vector<std::string>;

/// Standard output and what the options of a verb are kept in belong to the whole program.
std::mutex one_verb_at_a_time;

/// The lines that the verb has said, of any of its threads.
struct Said {
  std::mutex mutex;
  Texts lines;
} said;

void hear(std::string_view line) {
  const std::lock_guard lock{said.mutex};
  said.lines.emplace_back(line);
}

/// What is printed while this is there.
class CapturedOutput {
 public:
  CapturedOutput() : stream_{open_memstream(&text_, &size_)} {
    if (stream_ == nullptr) {
      throw std::bad_alloc{};
    }
    std::swap(stdout, stream_);
  }
  ~CapturedOutput() {
    std::swap(stdout, stream_);
    std::fclose(stream_);
    std::free(text_);
  }
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  [[nodiscard]] std::string text() const {
    std::fflush(stdout);
    return {text_, size_};
  }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* stream_;  ///< while this is there, the one that was standard output
};

const tool::VerbEntry& entry_of(const tool::VerbCode& verb) {
  return *std::ranges::find(tool::verb_table, verb.name, &tool::VerbEntry::name);
}

/// "campaign" of "campaign faults".
const tool::VerbCode& verb_of(std::string_view name) {
  const tool::VerbCode* verb = tool::VerbCode::first;
  while (verb->name != name.substr(0, name.find(' '))) {
    verb = verb->next;
  }
  return *verb;
}

/// What it has printed, and the lines that it has said on the way. `words`: as they are typed behind the verb's name.
/// That the answer is no is no error.
std::pair<std::string, Texts> run_verb(const std::string& name, const Texts& words) {
  const nb::gil_scoped_release others_may_work;
  const std::lock_guard alone{one_verb_at_a_time};
  said.lines.clear();
  const CapturedOutput output;
  try {
    const tool::VerbCode& verb = verb_of(name);
    tool::read_command_line(verb.name, std::string{entry_of(verb).meaning}, verb.fill, words);
  } catch (const text::Error& error) {
    if (error.kind() != text::ErrorKind::requirement_not_met || output.text().empty()) {
      throw;
    }
  }
  return {output.text(), said.lines};
}

nb::dict described(const manual::Option& option) {
  nb::dict row;
  row["name"] = option.names.back();
  row["value"] = option.value;
  row["allowed"] = option.allowed;
  row["usual"] = option.usual;
  row["meaning"] = option.meaning;
  row["required"] = option.required;
  row["repeated"] = option.repeated;
  row["is_folder"] = option.offering && option.offering("").paths == manual::Paths::folders;
  return row;
}

/// It and its own verbs, as far as they print JSON.
void add(nb::list& verbs, const manual::Command& command) {
  const auto is_json = [](const manual::Option& option) { return option.names.back() == "--json"; };
  if (std::ranges::any_of(command.options, is_json)) {
    nb::list rows;
    for (const auto* options : {&command.arguments, &command.options}) {
      for (const manual::Option& option : *options) {
        rows.append(described(option));
      }
    }
    verbs.append(nb::make_tuple(command.name.substr(command.name.find(' ') + 1), command.meaning, rows));
  }
  for (const manual::Command& inner : command.commands) {
    add(verbs, inner);
  }
}

nb::list verbs() {
  const std::lock_guard alone{one_verb_at_a_time};
  nb::list all;
  for (const tool::VerbCode* verb = tool::VerbCode::first; verb != nullptr; verb = verb->next) {
    add(all, tool::command_of(verb->name, std::string{entry_of(*verb).meaning}, verb->fill));
  }
  return all;
}

std::uint64_t merge_shards(const Texts& shards, const std::string& out) {
  const std::vector<std::filesystem::path> folders{shards.begin(), shards.end()};
  return campaign::merge(folders, out);
}

}  // namespace

void bind_verbs(nb::module_& m) {
  tool::ask_for_interrupts(give_up_if_interrupted);
  tool::hear_instead(hear);
  m.def("verbs", &verbs);
  m.def("run_verb", &run_verb, nb::arg("name"), nb::arg("words"));
  m.def("merge_shards", &merge_shards, nb::arg("shards"), nb::arg("out"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace fantail::python
