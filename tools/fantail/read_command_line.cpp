// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "fantail/command_line.hpp"
#include "fantail/declared.hpp"
#include "fantail/help.hpp"
#include "fantail/terminal.hpp"
#include "fantail/verb_table.hpp"
#include "input/messages.hpp"
#include "page/page.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

const CLI::App& innermost(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : innermost(*parsed.front());
}

std::string meant_or_allowed(const std::string& word, const std::vector<std::string>& names) {
  const auto meant = input::suggestion(word, names);
  return meant ? "did you mean " + *meant + "?" : fmt::format("allowed: {}", fmt::join(names, ", "));
}

std::string complaint_about_surplus(const CLI::App& verb, const std::vector<std::string>& surplus) {
  // No word behind a bare -- is an option.
  const auto dashes = std::ranges::find(surplus, "--");
  const auto option = std::ranges::find(surplus.begin(), dashes, '-', [](const auto& word) { return word[0]; });
  if (option == dashes) {
    return '"' + surplus[dashes == surplus.begin() ? 1 : 0] + "\" is one word too many for " + verb.get_name();
  }
  const std::string word = option->substr(0, option->find('='));
  const auto removed = std::ranges::find(removed_options, verb.get_name() + " " + word, &RemovedOption::option);
  if (removed != removed_options.end()) {
    return fmt::format("{} {}", word, removed->said);
  }
  std::vector<std::string> names;
  for (const CLI::Option* known : verb.get_options([](const auto* o) { return !declared(o).hidden; })) {
    for (const std::string& name : known->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return fmt::format("unknown option {}; {}", word, meant_or_allowed(word, names));
}

// One line on what is wrong with the words, naming the one that is.
std::string complaint(const CLI::App& program, const CLI::ParseError& error) {
  std::vector<std::string> verbs;
  std::ranges::transform(innermost(program).get_subcommands(nullptr), std::back_inserter(verbs), &CLI::App::get_name);
  const std::vector<std::string> surplus = program.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !surplus.empty()) {
    return complaint_about_surplus(innermost(program), surplus);
  }
  // CLI11 says only that something is required, whatever stands in its place.
  if (verbs.empty() || dynamic_cast<const CLI::RequiredError*>(&error) == nullptr) {
    return error.what();
  }
  if (surplus.empty()) {
    return fmt::format("a verb is missing; allowed: {}", fmt::join(verbs, ", "));
  }
  const std::string& word = surplus.front();
  if (std::ranges::find(verbs, word) != verbs.end()) {
    return '"' + word + "\" is not a verb after a bare --";
  }
  if (word.starts_with('-')) {
    return fmt::format("unknown option {}; a verb comes first: {}", word, fmt::join(verbs, ", "));
  }
  return fmt::format("unknown verb \"{}\"; {}", word, meant_or_allowed(word, verbs));
}

// What every verb has.
void add_color(CLI::App& app) {
  for (CLI::App* verb : app.get_subcommands(nullptr)) {
    Option{verb->add_option_function<std::string>("--color", set_color,
                                                  "Colours, or none; auto: on a terminal, without NO_COLOR")}
        .value_name("auto|always|never")
        .one_of({"auto", "always", "never"});
    add_color(*verb);
  }
}

// For the help alone: CLI11 does not name a hidden option in its complaints about a value either, and repeats the words
// that a value is named after.
void tidy(CLI::App& app) {
  for (CLI::Option* option : app.get_options(nullptr)) {
    const Declared& more = declared(option);
    if (more.hidden) {
      option->group("");
    }
    if (!more.words.empty() && option->get_type_name().starts_with(fmt::format("{}:", fmt::join(more.words, "|")))) {
      option->get_validator(0)->description("");
    }
  }
  for (CLI::App* verb : app.get_subcommands(nullptr)) {
    tidy(*verb);
  }
}

std::unique_ptr<CLI::App> program_with(const std::string& name, const std::string& meaning,
                                       void (*fill)(const Verb& verb)) {
  forget_declared();
  auto program = std::make_unique<CLI::App>("", "fantail");
  program->require_subcommand(1);
  fill(Verb{program->add_subcommand(name, meaning)});
  add_color(*program);
  return program;
}

manual::Option described(const CLI::Option& option) {
  const Declared& more = declared(&option);
  manual::Option result{.allowed = more.allowed,
                        .usual = option.get_default_str(),
                        .meaning = option.get_description(),
                        .section = option.get_group() == "Options" ? "" : option.get_group(),
                        .words = more.words,
                        .required = option.get_required(),
                        .repeated = option.get_expected_max() == CLI::detail::expected_max_vector_size,
                        .offering = more.offering};
  for (const std::string& name : option.get_snames()) {
    result.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    result.names.push_back("--" + name);
  }
  if (option.get_positional()) {
    result.names = {option.get_name(true)};
  }
  if (option.get_type_size() != 0) {
    result.value = option.get_type_name();
    if (!more.allowed.empty()) {  // CLI11 has put it there
      result.value.resize(result.value.size() - more.allowed.size() - 1);
    }
  }
  for (const CLI::Option* other : option.get_needs()) {
    result.needs.push_back(other->get_name());
  }
  for (const CLI::Option* other : option.get_excludes()) {
    result.excludes.push_back(other->get_name());
  }
  std::ranges::sort(result.excludes);  // CLI11 has them in the order of their addresses
  return result;
}

manual::Command described(const CLI::App& verb, const std::string& before) {
  manual::Command command{.name = before + " " + verb.get_name(),
                          .meaning = verb.get_description(),
                          .needs_command = verb.get_require_subcommand_min() > 0,
                          .notes = verb.get_footer()};
  for (const CLI::Option* option : verb.get_options([](const auto* o) { return !declared(o).hidden; })) {
    (option->get_positional() ? command.arguments : command.options).push_back(described(*option));
  }
  for (const CLI::App* inner : verb.get_subcommands(nullptr)) {
    command.commands.push_back(described(*inner, command.name));
  }
  return command;
}
/// What was typed, without what changes nothing in a result: where results and telemetry go, how they are told, how
/// many processors make them.
std::string typed_command(std::string_view name, const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 4> with_value{"--out", "--color", "--threads", "--lcm"};
  std::string command = fmt::format("fantail {}", name);
  for (auto word = words.begin(); word != words.end(); ++word) {
    const std::string option = word->substr(0, word->find('='));
    if (std::ranges::find(with_value, option) != with_value.end()) {
      word += option == *word && word + 1 != words.end() ? 1 : 0;
    } else if (*word != "--json" && *word != "--realtime") {
      command.append(1, ' ').append(text::shell_word(*word));
    }
  }
  return command;
}

}  // namespace

manual::Command command_of(const std::string& name, const std::string& meaning, void (*fill)(const Verb& verb)) {
  const std::unique_ptr<CLI::App> program = program_with(name, meaning, fill);
  return described(*program->get_subcommand(name), program->get_name());
}

void read_command_line(const std::string& name, const std::string& meaning, void (*fill)(const Verb& verb),
                       std::vector<std::string> words) {
  page::set_made_by(typed_command(name, words), FANTAIL_VERSION);
  const std::unique_ptr<CLI::App> program = program_with(name, meaning, fill);
  std::ranges::reverse(words);  // CLI11 takes them from behind
  words.push_back(name);
  try {
    program->parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      throw UsageError{complaint(*program, error)};
    }
    // Asked for. CLI11 puts the examples at its end.
    tidy(*program);
    std::string help = program->help();
    for (auto at = help.find("\n\n\n"); at != std::string::npos; at = help.find("\n\n\n", at)) {
      help.erase(at, 1);  // CLI11 puts two lines between sections
    }
    const std::string examples = innermost(*program).get_footer();
    const std::size_t end = examples.empty() ? help.size() : std::min(help.rfind(examples), help.size());
    show_text(help.substr(0, end));
    fmt::print("{}", end == help.size() ? "" : examples_text(examples, output_columns()));
  }
}

}  // namespace fantail::tool
