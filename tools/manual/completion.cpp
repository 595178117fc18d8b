// SPDX-License-Identifier: MIT
#include "manual/completion.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace fantail::manual {
namespace {

const Option* find_option(const Command& command, std::string_view name) {
  const auto found = std::ranges::find_if(command.options, [&](const Option& option) {
    return std::ranges::find(option.names, name) != option.names.end();
  });
  return found == command.options.end() ? nullptr : &*found;
}

/// The last word of its name.
std::string_view own_name(const Command& command) {
  return std::string_view{command.name}.substr(command.name.rfind(' ') + 1);
}

const Command* find_command(const Command& command, std::string_view name) {
  const auto found = std::ranges::find(command.commands, name, own_name);
  return found == command.commands.end() ? nullptr : &*found;
}

/// Where the last word stands.
struct Place {
  const Command* command;
  const Option* option = nullptr;  ///< the word is its value
  std::size_t arguments = 0;       ///< that stand before it
  bool behind_dashes = false;      ///< of a bare --: neither option nor verb
};

Place place_of_last(const Command& command, std::span<const std::string> words) {
  Place place{.command = &command};
  for (const std::string& word : words.first(words.size() - 1)) {
    if (place.option != nullptr) {
      place.option = nullptr;
    } else if (!place.behind_dashes && word == "--") {
      place.behind_dashes = true;
    } else if (!place.behind_dashes && word.starts_with('-')) {
      const Option* option = find_option(*place.command, word);  // none for --name=value
      place.option = option != nullptr && !option->value.empty() ? option : nullptr;
    } else if (const Command* inner =
                   !place.behind_dashes && place.arguments == 0 ? find_command(*place.command, word) : nullptr) {
      place.command = inner;
    } else {
      place.arguments += 1;
    }
  }
  return place;
}

class Answer {
 public:
  explicit Answer(std::string_view begun) : begun_{begun} {}

  void add(std::string_view word, std::string_view meaning = {}) {
    if (word.starts_with(begun_)) {
      lines_.append(word).append(meaning.empty() ? "" : "\t").append(meaning) += '\n';
    }
  }

  /// `before` stands ahead of the value in the same word: "--out=".
  void add_values(const Option& option, std::string_view before = {}) {
    Offer offer{.words = option.words};
    if (option.offering) {
      offer = option.offering(begun_.substr(before.size()));
    }
    for (const std::string& word : offer.words) {
      add(std::string{before} + word);
    }
    paths_ = offer.paths;
  }

  [[nodiscard]] std::string text() const {
    const char* first = paths_ == Paths::none ? "words\n" : (paths_ == Paths::files ? "files\n" : "folders\n");
    return first + lines_;
  }

 private:
  std::string_view begun_;
  std::string lines_;
  Paths paths_ = Paths::none;
};

}  // namespace

std::string completion(const Command& command, std::span<const std::string> words) {
  const std::string_view begun = words.back();
  const Place place = place_of_last(command, words);
  const bool is_option = begun.starts_with('-') && !place.behind_dashes;
  Answer answer{begun};
  if (place.option != nullptr) {
    answer.add_values(*place.option);
  } else if (const std::size_t equals = begun.find('='); is_option && equals != std::string_view::npos) {
    if (const Option* option = find_option(*place.command, begun.substr(0, equals))) {
      answer.add_values(*option, begun.substr(0, equals + 1));
    }
  } else if (is_option) {
    for (const Option& option : place.command->options) {
      for (const std::string& name : option.names) {
        answer.add(name, option.meaning);
      }
    }
  } else {
    for (const Command& inner : place.command->commands) {
      if (place.arguments == 0 && !place.behind_dashes) {
        answer.add(own_name(inner), inner.meaning);
      }
    }
    const std::vector<Option>& arguments = place.command->arguments;
    if (place.arguments < arguments.size()) {
      answer.add_values(arguments[place.arguments]);
    } else if (!arguments.empty() && arguments.back().repeated) {
      answer.add_values(arguments.back());
    }
  }
  return answer.text();
}

}  // namespace fantail::manual
