// SPDX-License-Identifier: MIT
#include "rules/expression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "input/messages.hpp"
#include "rules/tokens.hpp"

namespace fantail::rules {

namespace {

std::string_view name(Type type) {
  switch (type) {
    case Type::flag: return "true or false";
    case Type::number: return "a number";
    case Type::text: break;
  }
  return "a text";
}

bool is_comparison(std::string_view sign) {
  return sign == "==" || sign == "!=" || sign == "<" || sign == "<=" || sign == ">" || sign == ">=";
}

}  // namespace

class Parser {
 public:
  Parser(std::string_view text, const Vocabulary& vocabulary) : tokens_{tokens_of(text)}, vocabulary_{vocabulary} {}

  Expression parse() {
    if (now().kind == Token::Kind::end) {
      throw ExpressionError{1, "the expression is empty"};
    }
    if (tokens_.size() > most_parts) {
      throw ExpressionError{1, "the expression has more than 1000 parts"};
    }
    alternative();
    if (now().kind != Token::Kind::end) {
      throw ExpressionError{now().position, "\"" + now().text + "\" cannot follow here"};
    }
    return std::move(made_);
  }

 private:
  using Node = Expression::Node;

  [[nodiscard]] const Token& now() const { return tokens_[at_]; }
  [[nodiscard]] bool is(std::string_view sign) const { return now().kind == Token::Kind::sign && now().text == sign; }

  std::size_t add(Node node) {
    made_.nodes_.push_back(std::move(node));
    return made_.nodes_.size() - 1;
  }
  void expect(std::size_t node, Type type, const Token& of) const {
    const Node& found = made_.nodes_[node];
    if (found.type != type) {
      throw ExpressionError{found.position, "\"" + of.text + "\" needs " + std::string{name(type)} +
                                                " here, and this is " + std::string{name(found.type)}};
    }
  }

  /// `part` for both sides, which have that type, as what is made of them has.
  template <typename Part>
  std::size_t chain(std::initializer_list<std::string_view> signs, Type type, const Part& part) {
    std::size_t left = part();
    while (std::ranges::any_of(signs, [this](std::string_view sign) { return is(sign); })) {
      const Token sign = tokens_[at_++];
      expect(left, type, sign);
      const std::size_t right = part();
      expect(right, type, sign);
      left = add({.operation = sign.text,
                  .type = type,
                  .left = left,
                  .right = right,
                  .position = made_.nodes_[left].position});
    }
    return left;
  }

  std::size_t alternative() {
    return chain({"or"}, Type::flag, [this] { return chain({"and"}, Type::flag, [this] { return negation(); }); });
  }

  std::size_t negation() {
    if (!is("not")) {
      return comparison();
    }
    const Deeper deeper{*this};
    const Token sign = tokens_[at_++];
    const std::size_t part = negation();
    expect(part, Type::flag, sign);
    return add({.operation = "not", .type = Type::flag, .left = part, .position = sign.position});
  }

  std::size_t comparison() {
    const std::size_t left = sum();
    if (now().kind != Token::Kind::sign || !is_comparison(now().text)) {
      return left;
    }
    const Token sign = tokens_[at_++];
    const std::size_t right = sum();
    check(left, right, sign);
    if (now().kind == Token::Kind::sign && is_comparison(now().text)) {
      throw ExpressionError{now().position, "a comparison cannot be compared; write two with \"and\" between them"};
    }
    return add({.operation = sign.text,
                .type = Type::flag,
                .left = left,
                .right = right,
                .position = made_.nodes_[left].position});
  }

  void check(std::size_t left, std::size_t right, const Token& sign) const {
    if (sign.text != "==" && sign.text != "!=") {
      expect(left, Type::number, sign);
      expect(right, Type::number, sign);
      return;
    }
    const Node& one = made_.nodes_[left];
    const Node& other = made_.nodes_[right];
    if (one.type != other.type) {
      throw ExpressionError{other.position, "this is " + std::string{name(other.type)} +
                                                ", and what it is compared with is " + std::string{name(one.type)}};
    }
    check_word(one, other);
    check_word(other, one);
  }

  /// A word that a field can never have would make a rule that never, or always, holds.
  static void check_word(const Node& named, const Node& literal) {
    const auto* word = std::get_if<std::string>(&literal.literal);
    if (named.words.empty() || word == nullptr || !literal.name.empty() ||
        std::ranges::find(named.words, *word) != named.words.end()) {
      return;
    }
    std::string allowed;
    for (const std::string& one : named.words) {
      allowed += (allowed.empty() ? "\"" : ", \"") + one + "\"";
    }
    throw ExpressionError{literal.position,
                          "\"" + *word + "\" is not a value of " + named.name + "; allowed: " + allowed};
  }

  std::size_t sum() {
    return chain({"+", "-"}, Type::number,
                 [this] { return chain({"*", "/"}, Type::number, [this] { return signed_part(); }); });
  }

  std::size_t signed_part() {
    if (!is("-")) {
      return value();
    }
    const Deeper deeper{*this};
    const Token sign = tokens_[at_++];
    const std::size_t part = signed_part();
    expect(part, Type::number, sign);
    return add({.operation = "negative", .type = Type::number, .left = part, .position = sign.position});
  }

  std::size_t value() {
    const Token token = now();
    if (is("(")) {
      const Deeper deeper{*this};
      ++at_;
      const std::size_t inside = alternative();
      if (!is(")")) {
        throw ExpressionError{now().position, "\")\" is missing"};
      }
      ++at_;
      return inside;
    }
    ++at_;
    if (token.kind == Token::Kind::number) {
      return add({.operation = {},
                  .type = Type::number,
                  .literal = Number{token.number, token.number},
                  .position = token.position});
    }
    if (token.kind == Token::Kind::text) {
      return add({.operation = {}, .type = Type::text, .literal = token.text, .position = token.position});
    }
    if (token.text == "true" || token.text == "false") {
      return add({.operation = {}, .type = Type::flag, .literal = token.text == "true", .position = token.position});
    }
    if (token.kind == Token::Kind::name) {
      return named(token);
    }
    throw ExpressionError{token.position, token.kind == Token::Kind::end
                                              ? "a value is missing at the end"
                                              : "a value is missing in front of \"" + token.text + "\""};
  }

  std::size_t named(const Token& token) {
    std::optional<Meaning> meaning = vocabulary_.meaning_of(token.text);
    if (!meaning) {
      const auto meant = input::suggestion(token.text, vocabulary_.names());
      throw ExpressionError{token.position, "\"" + token.text + "\" names no figure and no field of a plan" +
                                                (meant ? "; did you mean " + *meant + "?" : "")};
    }
    if (std::ranges::find(made_.names_, token.text) == made_.names_.end()) {
      made_.names_.push_back(token.text);
    }
    return add({.operation = {},
                .type = meaning->type,
                .name = token.text,
                .position = token.position,
                .words = std::move(meaning->words)});
  }

  // A file must not be able to use up the stack.
  static constexpr std::size_t most_parts = 1000;
  struct Deeper {
    explicit Deeper(Parser& its_parser) : parser{its_parser} {
      if (++parser.depth_ > 100) {
        throw ExpressionError{parser.now().position, "nested more than 100 deep"};
      }
    }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    ~Deeper() { --parser.depth_; }
    Parser& parser;
  };

  std::vector<Token> tokens_;
  const Vocabulary& vocabulary_;
  std::size_t at_ = 0;
  int depth_ = 0;
  Expression made_;
};

Expression Expression::parse(std::string_view text, const Vocabulary& vocabulary) {
  return Parser{text, vocabulary}.parse();
}

}  // namespace fantail::rules
