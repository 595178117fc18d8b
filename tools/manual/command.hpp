// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::manual {

// A command line as it is declared, for whoever describes it: a manual page, and a shell that completes it.

/// What of the file system a value may name.
enum class Paths : std::uint8_t { none, files, folders };

/// What a shell may put where a value stands.
struct Offer {
  std::vector<std::string> words{};
  Paths paths = Paths::none;
};

/// Called when somebody asks, with what has been typed of the word.
using Offering = std::function<Offer(std::string_view begun)>;

/// An option or flag; or an argument, which is known by its place.
struct Option {
  std::vector<std::string> names{};  ///< "--out"; of an argument one, without dashes
  std::string value{};               ///< what the help has for the value; empty: a flag
  std::string allowed{};             ///< "from 1 to 4"; empty: the meaning says it
  std::string usual{};               ///< the value when it is left out; empty: the meaning says it
  std::string meaning{};
  std::string section{};                ///< the title that it stands below; empty: none
  std::vector<std::string> words{};     ///< of a choice
  std::vector<std::string> needs{};     ///< other options, by their names
  std::vector<std::string> excludes{};  ///< likewise
  bool required = false;
  bool repeated = false;
  Offering offering{};
};

struct ExitCode {
  int code;
  std::string_view meaning;
};

struct Command {
  std::string name{};  ///< with those before it: "fantail bench limits"
  std::string meaning{};
  std::vector<Option> arguments{};
  std::vector<Option> options{};
  std::vector<Command> commands{};
  bool needs_command = false;
  std::string notes{};  ///< what the help has below the options: sentences and examples
};

/// A command as lines that a shell takes as one: broken before options, or where that is not enough between words; each
/// but the last ends with a backslash, and each but the first is four columns further in. What is quoted stays
/// together, however long it is.
[[nodiscard]] std::string command_lines(std::string_view command, std::string_view indent, std::size_t columns);

}  // namespace fantail::manual
