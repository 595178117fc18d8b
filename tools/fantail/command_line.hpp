// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "manual/command.hpp"
#include "text/error.hpp"

// CLI11 stands behind this file: its headers take five seconds to compile, and every verb would pay them.
namespace CLI {
class App;
class Option;
}  // namespace CLI
namespace fantail::tool {

/// What is wrong with the words of a command line. what() names the option, its value and what is allowed.
class UsageError : public text::Error {
 public:
  explicit UsageError(const std::string& message) : Error{text::ErrorKind::usage, message + " (see --help)"} {}
};

/// What is wrong with the text of a value; empty when nothing is.
using Objection = std::function<std::string(const std::string& text)>;

/// One option, flag or argument of a verb. A handle: copies mean the same option.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_{option} {}

  Option& required(bool is = true);
  Option& check(const Objection& objection);
  Option& range(double low, double high);
  Option& one_of(std::initializer_list<const char*> words);
  Option& one_of(std::vector<std::string> words);
  /// What a shell may offer for the value; the words of one_of() it does without.
  Option& offers(manual::Offering offering);
  /// What stands for the value in the help: KG_M2.
  Option& value_name(const std::string& name);
  /// The help shows the value that the variable has now.
  Option& show_default();
  /// Takes one word each time it is given, and may be given again: for lists.
  Option& one_word_each_time();
  Option& separated_by(char separator);
  /// An older spelling: it is read, and no help, manual or shell tells of it.
  Option& hidden();
  Option& needs(const Option& other);
  Option& excludes(const Option& other);

  /// Another value than the usual one makes another result: it is told by asked().
  Option& changes_result();
  /// It makes no other result, and belongs to the command that makes the same again.
  Option& belongs_to_command();

 private:
  CLI::Option* option_;
};

/// What a command line asks for, but for what makes no other result: where it goes, how it is told, how many processors
/// make it.
struct Asked {
  std::string command{};               ///< that makes it again: "fantail predict tasha3_launch2 --swirl -2"
  std::vector<std::string> changes{};  ///< beside --set and --seed: "swirl=-2"
};

/// A verb of the program, or one of its own verbs. A handle, too.
class Verb {
 public:
  explicit Verb(CLI::App* app) : app_{app} {}

  /// `plan check` is a verb of `plan`.
  [[nodiscard]] Verb verb(const std::string& name, const std::string& meaning) const;
  void needs_verb() const;

  /// Names are "--out" or "-o,--out"; a name without dashes is an argument by its place. An empty word is refused. T:
  /// std::string, double, int, unsigned, std::size_t, optionals of these, and std::vector<std::string>.
  template <typename T>
  Option option(const std::string& names, T& value, const std::string& meaning) const;
  Option flag(const std::string& name, bool& value, const std::string& meaning) const;
  /// The help and the manual show the options that follow below this title.
  void section(const std::string& title) const;

  /// Stands below the options in the help.
  void examples(const std::string& text) const;
  /// What is done when the whole command line has been read, and none of its own verbs was called.
  void action(const std::function<void()>& action) const;
  /// As the variables of the options are now: for an action.
  [[nodiscard]] Asked asked() const;

 private:
  CLI::App* app_;
};

/// What `fill` describes, for the manual and for shells.
[[nodiscard]] manual::Command command_of(const std::string& name, const std::string& meaning,
                                         void (*fill)(const Verb& verb));

/// Reads the words behind a verb's name and does what `fill` has described; for --help, prints it. Throws UsageError,
/// and what the verb's action throws.
void read_command_line(const std::string& name, const std::string& meaning, void (*fill)(const Verb& verb),
                       std::vector<std::string> words);

// What several verbs have.

/// --threads.
void add_threads_option(const Verb& verb, unsigned& threads);
/// --for, and further names.
void add_end_option(const Verb& verb, std::optional<double>& seconds, const std::string& names = "--for");
/// --can.
void add_can_option(const Verb& verb, std::string& interface);

/// Both ends included. The library's own range would take "nan".
[[nodiscard]] Objection within(double low, double high);
[[nodiscard]] std::string objection_to_time(const std::string& text);

}  // namespace fantail::tool
