// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/document.hpp"
#include "rules/expression.hpp"
#include "rules/figures.hpp"

namespace fantail::rules {

/// How a clause is judged.
enum class Kind : std::uint8_t {
  computed,  ///< from the scenario and its flight
  plan,      ///< from fields of the plan alone
  log,       ///< from what was commanded and measured in a flight
  blank,     ///< by nobody here: the team must show it
};
[[nodiscard]] std::string_view name(Kind kind);

/// One demand of a document, in our words.
struct Clause {
  std::string id{};  ///< unique in its pack
  std::string title{};
  std::string words{};
  std::string source{};
  std::string date{};  ///< of the source, as far as it is known
  Kind kind = Kind::blank;
  std::optional<Expression> applies_if{};  ///< empty: always
  std::optional<Expression> passes_if{};   ///< empty for a blank one
  std::optional<Expression> fails_if{};    ///< of a blank one: there is nothing that the team could show; empty: never
  std::string team_shows{};                ///< of a blank one
  std::vector<std::string> evidence{};     ///< names to show beside those of the expressions
};

struct Pack {
  std::string name{};  ///< that of its file
  std::string file{};
  std::string title{};
  std::string date{};             ///< of these words
  std::string document{};         ///< the one that counts
  std::string document_sha256{};  ///< of its PDF that somebody compared the pack with; empty: nobody has
  std::vector<std::string> notes{};
  Findings team{};  ///< team.KEY: what the pack states about the team or its rocket
  std::vector<Clause> clauses{};
};

/// Throws text::Error (bad_configuration) that names file, line and clause, and the position in an expression.
[[nodiscard]] Pack read_pack(const input::Document& document);
/// A shipped name or a path. Throws text::Error.
[[nodiscard]] Pack load_pack(const std::string& name_or_path);

}  // namespace fantail::rules
