// SPDX-License-Identifier: MIT
#include "rules/tokens.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "rules/expression.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

constexpr std::array<std::string_view, 5> words{"and", "or", "not", "true", "false"};
constexpr std::array<std::string_view, 12> signs{"==", "!=", "<=", ">=", "<", ">", "+", "-", "*", "/", "(", ")"};

template <typename Belongs>
std::size_t end_of(std::string_view text, std::size_t at, const Belongs& belongs) {
  while (at < text.size() && belongs(at)) {
    ++at;
  }
  return at;
}

std::size_t end_of_number(std::string_view text, std::size_t begin) {
  return end_of(text, begin, [&](std::size_t i) {
    const bool is_sign_of_exponent = (text[i] == '-' || text[i] == '+') && i > begin && text[i - 1] == 'e';
    return is_digit(text[i]) || text[i] == '.' || text[i] == 'e' || is_sign_of_exponent;
  });
}

Token token_at(std::string_view text, std::size_t at, std::size_t& end) {
  const std::size_t position = at + 1;
  if (is_digit(text[at])) {
    end = end_of_number(text, at);
    const std::string written{text.substr(at, end - at)};
    const std::optional<double> number = text::decimal(written);
    if (!number) {
      throw ExpressionError{position, written + " is not a number"};
    }
    return {.kind = Token::Kind::number, .text = written, .number = *number, .position = position};
  }
  if (is_letter(text[at])) {
    end = end_of(text, at, [&](std::size_t i) { return is_letter(text[i]) || is_digit(text[i]) || text[i] == '.'; });
    const std::string word{text.substr(at, end - at)};
    const bool is_sign = std::ranges::find(words, word) != words.end();
    return {.kind = is_sign ? Token::Kind::sign : Token::Kind::name, .text = word, .position = position};
  }
  if (text[at] == '"') {
    const std::size_t close = text.find('"', at + 1);
    if (close == std::string_view::npos) {
      throw ExpressionError{position, "the text that begins here has no closing quote"};
    }
    end = close + 1;
    return {.kind = Token::Kind::text, .text = std::string{text.substr(at + 1, close - at - 1)}, .position = position};
  }
  const auto* sign = std::ranges::find_if(signs, [&](std::string_view s) { return text.substr(at).starts_with(s); });
  if (sign == signs.end()) {
    throw ExpressionError{position, "\"" + std::string{text.substr(at, 1)} +
                                        "\" has no meaning here; allowed: names, numbers, \"texts\", true, false, and, "
                                        "or, not, == != < <= > >= + - * / ( )"};
  }
  end = at + sign->size();
  return {.kind = Token::Kind::sign, .text = std::string{*sign}, .position = position};
}

}  // namespace

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> all;
  std::size_t at = 0;
  while (true) {
    at = end_of(text, at,
                [&](std::size_t i) { return std::string_view{" \t\r\n"}.find(text[i]) != std::string_view::npos; });
    if (at == text.size()) {
      all.push_back({.position = at + 1});
      return all;
    }
    std::size_t end = at;
    all.push_back(token_at(text, at, end));
    at = end;
  }
}

}  // namespace fantail::rules
