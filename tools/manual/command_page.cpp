// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "manual/command.hpp"
#include "manual/roff.hpp"

namespace fantail::manual {
namespace {

/// "--color auto|always|never"; of a choice its words, whatever the help calls the value.
std::string value_text(const Option& option) {
  const std::string words = fmt::format("{}", fmt::join(option.words, "|"));
  return italic(words.empty() ? option.value : words) + (option.repeated ? " ..." : "");
}

std::string facts(const Option& option) {
  std::string text;
  const auto add = [&](const std::string& fact) { text += (text.empty() ? "" : "; ") + fact; };
  if (option.required) {
    add("required");
  }
  if (!option.allowed.empty() && option.words.empty()) {
    add(roff(option.allowed));
  }
  if (!option.usual.empty()) {
    add("default " + bold(option.usual));
  }
  const auto list = [&](const char* word, const std::vector<std::string>& names) {
    if (!names.empty()) {
      std::string all;
      for (const std::string& name : names) {
        all += (all.empty() ? "" : ", ") + bold(name);
      }
      add(word + all);
    }
  };
  list("needs ", option.needs);
  list("not with ", option.excludes);
  return text;
}

std::string option_item(const Option& option) {
  std::string tag;
  for (const std::string& name : option.names) {
    tag += (tag.empty() ? "" : ", ") + bold(name);
  }
  if (!option.value.empty() && option.names.front().starts_with('-')) {
    tag += " " + value_text(option);
  } else if (option.repeated) {
    tag += " ...";
  }
  std::string text = sentence(option.meaning);
  if (const std::string more = facts(option); !more.empty()) {
    text += (text.empty() ? "" : " ") + ("(" + more + ")");
  }
  return item(tag, text);
}

std::string synopsis(const Command& command) {
  std::string line = bold(command.name);
  for (const Option& option : command.options) {
    if (option.required) {
      line.append(" ").append(bold(option.names.back())).append(" ").append(value_text(option));
    }
  }
  line += " [" + italic("options") + "]";
  for (const Option& argument : command.arguments) {
    const std::string name = italic(argument.names.front()) + (argument.repeated ? " ..." : "");
    line += argument.required ? " " + name : " [" + name + "]";
  }
  return line;
}

/// Of a program that only finds the programs of its verbs, their options are not known.
bool has_page_here(const Command& inner) { return !inner.options.empty(); }

std::string synopses(const Command& command) {
  std::string lines = command.needs_command ? "" : synopsis(command);
  for (const Command& inner : command.commands) {
    if (!has_page_here(inner)) {
      return paragraph(bold(command.name) + " " + italic("verb") + " [" + italic("options") + "]");
    }
    lines += (lines.empty() ? "" : "\n.br\n") + synopsis(inner);
  }
  return paragraph(lines);
}

std::string verbs(const Command& command) {
  std::string text;
  for (const Command& inner : command.commands) {
    text += item(bold(inner.name.substr(command.name.size() + 1)), sentence(inner.meaning));
  }
  return text;
}

bool has(const Command& command, const Option& wanted) {
  return std::ranges::any_of(command.options, [&](const Option& option) {
    return option.names == wanted.names && option.meaning == wanted.meaning;
  });
}

/// Which a command has in common with all of its own.
bool is_common(const Command& command, const Option& option) {
  return !command.commands.empty() && has(command, option) &&
         std::ranges::all_of(command.commands, [&](const Command& inner) { return has(inner, option); });
}

std::string common_options(const Command& command) {
  std::string text;
  for (const Option& option : command.options) {
    text += is_common(command, option) ? option_item(option) : "";
  }
  return text;
}

/// Arguments and options of `command`, but those that all of `whole` have in common.
std::string options(const Command& command, const Command& whole) {
  std::string text;
  std::string section;
  for (const auto* list : {&command.arguments, &command.options}) {
    for (const Option& option : *list) {
      if (is_common(whole, option)) {
        continue;
      }
      text += option.section == section || list == &command.arguments ? "" : subheading(option.section);
      section = list == &command.arguments ? "" : option.section;
      text += option_item(option);
    }
  }
  return text;
}

std::string examples(const Notes& notes) {
  std::string text;
  for (const Example& example : notes.examples) {
    // A line as it is, so that it can be copied: a page of 80 columns has 70 of them left.
    text += ".PP\n.nf\n";
    for (std::string rest = command_lines(example.command, "", 70); !rest.empty(); rest.erase(0, rest.find('\n') + 1)) {
      text += bold(rest.substr(0, rest.find('\n'))) + "\n";
    }
    text += ".fi\n";
    if (!example.meaning.empty()) {
      text += ".RS 4\n" + sentence(example.meaning) + "\n.RE\n";
    }
  }
  return text;
}

std::string section(const char* title, const std::string& text) { return text.empty() ? "" : heading(title) + text; }

std::string paragraphs(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) {
    result += paragraph(sentence(text));
  }
  return result;
}

std::string as_sentence(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

/// As whatis(1) has it: the first letter small, but for an abbreviation.
std::string as_name_line(std::string text) {
  if (text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) == 0) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

}  // namespace

std::string command_page(const Command& command, const Title& title, std::span<const ExitCode> codes) {
  const Notes notes = notes_of(command.notes);
  std::string page = beginning(title, as_name_line(command.meaning)) + section("SYNOPSIS", synopses(command));
  page += heading("DESCRIPTION") + paragraph(sentence(as_sentence(command.meaning))) + paragraphs(notes.sentences);
  page += section("VERBS", verbs(command)) + section("OPTIONS OF EVERY VERB", common_options(command));
  page += section("OPTIONS", options(command, command));
  for (const Command& inner : command.commands) {
    if (!has_page_here(inner)) {
      continue;
    }
    const Notes own = notes_of(inner.notes);
    page += heading(inner.name.substr(inner.name.find(' ') + 1));
    page += paragraph(sentence(as_sentence(inner.meaning))) + paragraphs(own.sentences) + paragraphs(own.exits);
    page += options(inner, command);
    if (!own.examples.empty()) {
      page += subheading("Examples") + examples(own);
    }
  }
  page += heading("EXIT STATUS") + paragraphs(notes.exits);
  for (const ExitCode& code : codes) {
    page += item(bold(std::to_string(code.code)), roff(code.meaning));
  }
  return page + section("EXAMPLES", examples(notes));
}

std::string see_also(std::initializer_list<const char*> pages) {
  std::string names;
  for (const std::string_view page : pages) {
    const std::size_t bracket = page.find('(');
    names += (names.empty() ? "" : ", ") + bold(page.substr(0, bracket)) + roff(page.substr(bracket));
  }
  return section("SEE ALSO", paragraph(names));
}

}  // namespace fantail::manual
