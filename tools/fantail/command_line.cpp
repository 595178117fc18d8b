// SPDX-License-Identifier: MIT
#include "fantail/command_line.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "fantail/declared.hpp"
#include "fantail/offers.hpp"
#include "input/messages.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

using Texts = std::vector<std::string>;

std::map<const CLI::Option*, Declared>& all_declared() {
  static std::map<const CLI::Option*, Declared> all;
  return all;
}

template <typename T>
Texts texts_of(const T& value) {
  return {fmt::format("{}", value)};
}
template <typename T>
Texts texts_of(const std::optional<T>& value) {
  return value ? texts_of(*value) : Texts{};
}
Texts texts_of(const Texts& values) { return values; }
Texts texts_of(bool is_given) { return is_given ? Texts{""} : Texts{}; }

template <typename T>
void remember(const CLI::Option* option, T& value) {
  declared(option).values = [&value] { return texts_of(value); };
  declared(option).usual = texts_of(value);
}

}  // namespace

Declared& declared(const CLI::Option* option) { return all_declared()[option]; }

void forget_declared() { all_declared().clear(); }

Option& Option::required(bool is) {
  option_->required(is);
  return *this;
}

Option& Option::check(const Objection& objection) {
  option_->check(CLI::Validator{objection, ""});
  return *this;
}

// CLI11's own Range lets NaN through.
Option& Option::range(double low, double high) {
  std::string& allowed = declared(option_).allowed;
  allowed = fmt::format("from {} to {}", input::plain_number(low), input::plain_number(high));
  option_->check(CLI::Validator{within(low, high), allowed});
  return *this;
}

Option& Option::one_of(std::initializer_list<const char*> words) {
  return one_of(std::vector<std::string>{words.begin(), words.end()});
}

Option& Option::one_of(std::vector<std::string> words) {
  Declared& more = declared(option_);
  more.words = std::move(words);
  more.allowed = CLI::detail::generate_set(more.words);
  option_->check(CLI::IsMember(more.words));
  return *this;
}

Option& Option::offers(manual::Offering offering) {
  declared(option_).offering = std::move(offering);
  return *this;
}

Option& Option::value_name(const std::string& name) {
  option_->type_name(name);
  return *this;
}

Option& Option::show_default() {
  option_->capture_default_str();
  return *this;
}

Option& Option::one_word_each_time() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::separated_by(char separator) {
  option_->delimiter(separator);
  return *this;
}

Option& Option::hidden() {
  declared(option_).hidden = true;
  return *this;
}

Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option& Option::changes_result() {
  declared(option_).changes_result = true;
  return belongs_to_command();
}

Option& Option::belongs_to_command() {
  declared(option_).belongs_to_command = true;
  return *this;
}

Verb Verb::verb(const std::string& name, const std::string& meaning) const {
  const Verb inner{app_->add_subcommand(name, meaning)};
  inner.section("Options");  // or it begins with that of this verb
  return inner;
}

void Verb::section(const std::string& title) const { app_->option_defaults()->group(title); }

void Verb::needs_verb() const { app_->require_subcommand(1); }

// Whoever leaves a word out asks for what is usual; whoever gives an empty one has made a mistake.
template <typename T>
Option Verb::option(const std::string& names, T& value, const std::string& meaning) const {
  CLI::Option* const option = app_->add_option(names, value, meaning);
  remember(option, value);
  return Option{option}.check([](const std::string& text) { return std::string{text.empty() ? "it is empty" : ""}; });
}

template Option Verb::option(const std::string&, std::string&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::string>&, const std::string&) const;
template Option Verb::option(const std::string&, double&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<double>&, const std::string&) const;
template Option Verb::option(const std::string&, int&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<int>&, const std::string&) const;
template Option Verb::option(const std::string&, unsigned&, const std::string&) const;
template Option Verb::option(const std::string&, std::size_t&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::size_t>&, const std::string&) const;
template Option Verb::option(const std::string&, std::vector<std::string>&, const std::string&) const;

Option Verb::flag(const std::string& name, bool& value, const std::string& meaning) const {
  CLI::Option* const option = app_->add_flag(name, value, meaning);
  remember(option, value);
  return Option{option};
}

void Verb::examples(const std::string& text) const { app_->footer(text); }

void Verb::action(const std::function<void()>& action) const {
  app_->callback([app = app_, action] {
    if (app->get_subcommands().empty()) {
      action();
    }
  });
}

Asked Verb::asked() const {
  Asked asked{.command = app_->get_name()};
  for (const CLI::App* app = app_->get_parent(); app != nullptr; app = app->get_parent()) {
    asked.command.insert(0, app->get_name() + " ");
  }
  for (const CLI::Option* option : app_->get_options()) {
    const Declared& more = declared(option);
    const bool is_argument = option->get_positional();
    const Texts values = more.belongs_to_command ? more.values() : Texts{};
    if (values == more.usual && !is_argument) {
      continue;
    }
    for (const std::string& value : values) {
      asked.command += is_argument ? "" : " " + option->get_name();
      asked.command += value.empty() ? "" : " " + text::shell_word(value);
      if (more.changes_result) {
        asked.changes.push_back(option->get_lnames().front() + (value.empty() ? "" : "=" + value));
      }
    }
  }
  return asked;
}

Objection within(double low, double high) {
  return [low, high](const std::string& text) {
    const auto value = text::number(text);
    return value && *value >= low && *value <= high
               ? std::string{}
               : fmt::format("\"{}\": allowed: {} to {}", text, input::plain_number(low), input::plain_number(high));
  };
}

void add_threads_option(const Verb& verb, unsigned& threads) {
  verb.option("--threads", threads, "Number of parallel threads [all of the machine's]").range(1, 1024);
}

void add_end_option(const Verb& verb, std::optional<double>& seconds, const std::string& names) {
  verb.option(names, seconds, "End after this many seconds [until Ctrl-C]").range(0.0, 1e9).value_name("SECONDS");
}

void add_can_option(const Verb& verb, std::string& interface) {
  verb.option("--can", interface, "CAN interface, for example vcan0 or can0")
      .offers(can_interfaces)
      .required()
      .value_name("IF");
}

std::string objection_to_time(const std::string& text) {
  return text::number(text) ? "" : '"' + text + "\" is not a number of seconds";
}

}  // namespace fantail::tool
