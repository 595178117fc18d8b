// SPDX-License-Identifier: MIT
#include "input/section.hpp"

#include "scratch_file.hpp"
#include "test.hpp"

namespace fantail::input {
namespace {

class ASection : public testing::Test {
 protected:
  static Document load(std::string_view content) {
    const ScratchFile file{content};
    return Document::load(file.path());
  }
  // What reading `a` of the content is refused with.
  template <typename Read>
  static std::string refusal(std::string_view content, Read read) {
    const Document document = load(content);
    return complaint([&] {
             Section section{document, "s"};
             read(section);
           })
        .message;
  }
  static constexpr Limits limits{0.1, 20.0};
  static constexpr std::array<std::string_view, 2> words{"none", "product"};
};

TEST_F(ASection, GivesNumbersWordsAndFlagsAsTheyStand) {
  const Document document = load("[s]\na = 1.5\nb = 3\nc = true\nd = \"product\"\ne = [0.1, 20]\n");
  Section section{document, "s"};
  EXPECT_EQ(section.number("a", limits), 1.5);
  EXPECT_EQ(section.number("b", limits), 3.0);
  EXPECT_EQ(section.integer("b", limits), 3);
  EXPECT_TRUE(section.flag("c"));
  EXPECT_EQ(section.choice("d", words), 1U);
  EXPECT_EQ(section.text("d"), "product");
  EXPECT_EQ(section.numbers("e", limits, 2), (std::vector<double>{0.1, 20.0}));
  section.finish();
}

TEST_F(ASection, ThatIsAbsentHasNothing) {
  const Document document = load("");
  Section section{document, "s"};
  EXPECT_FALSE(section.is_there());
  EXPECT_FALSE(section.has("a"));
  EXPECT_TRUE(section.numbers("a", limits, 2).empty());
  section.finish();
}

TEST_F(ASection, RefusesANumberOutOfRangeWithPlaceNameValueAndRange) {
  const auto read = [](Section& s) { (void)s.number("a", limits); };
  EXPECT_EQ(refusal("[s]\n\na = 21", read), "plan.toml:3: s.a = 21 is out of range; allowed: 0.1 to 20");
  EXPECT_EQ(refusal("[s]\na = 20.0000001", read), "plan.toml:2: s.a = 20.0000001 is out of range; allowed: 0.1 to 20");
  EXPECT_EQ(refusal("[s]\na = nan", read), "plan.toml:2: s.a = nan is out of range; allowed: 0.1 to 20");
  EXPECT_EQ(refusal("[s]\na = -inf", read), "plan.toml:2: s.a = -inf is out of range; allowed: 0.1 to 20");
}

TEST_F(ASection, RefusesTheWrongTypeOnOneLine) {
  const auto number = [](Section& s) { (void)s.number("a", limits); };
  EXPECT_EQ(refusal("[s]\na = \"six\"", number), "plan.toml:2: s.a = 'six' is not a number; allowed: 0.1 to 20");
  EXPECT_EQ(refusal("[s]\na = true", number), "plan.toml:2: s.a = true is not a number; allowed: 0.1 to 20");
  for (const std::string_view content :
       {"[s]\na = [6]", "[s]\na = {x = 1, y = 2}", "[s.a]\nx = 1\ny = 2", "[[s.a]]\nx = 1\n[[s.a]]\nx = 2",
        "[s]\na = \"\"\"two\nlines\"\"\"", "[s]\na = [1, [2, 3], {x = 1}, 'a long word', 'another long word', 'third']",
        "[s]\na = 2015-12-04"}) {
    EXPECT_TRUE(refusal(content, number).starts_with("plan.toml:")) << content;
    EXPECT_TRUE(refusal(content, number).ends_with(" is not a number; allowed: 0.1 to 20")) << refusal(content, number);
  }
  EXPECT_EQ(refusal("[s]\na = 3.0", [](Section& s) { (void)s.integer("a", limits); }),
            "plan.toml:2: s.a = 3.0 is not a whole number");
  EXPECT_EQ(refusal("[s]\na = 1", [](Section& s) { (void)s.flag("a"); }),
            "plan.toml:2: s.a = 1; allowed: true or false");
  EXPECT_EQ(refusal("[s]\na = 1", [](Section& s) { (void)s.text("a"); }), "plan.toml:2: s.a = 1 is not a text");
  EXPECT_EQ(refusal("[s]\na = 1", [](Section& s) { (void)s.numbers("a", limits, 2); }),
            "plan.toml:2: s.a must be a list, as in [1, 2]");
  EXPECT_EQ(refusal("[s]\na = 'chirp'", [](Section& s) { (void)s.choice("a", words); }),
            "plan.toml:2: s.a = 'chirp'; allowed: none, product");
}

TEST_F(ASection, RefusesListsTooLongAndTheirBadElements) {
  const auto read = [](Section& s) { (void)s.numbers("a", limits, 2); };
  EXPECT_EQ(refusal("[s]\na = [1, 2, 3]", read), "plan.toml:2: s.a has 3 values; allowed: at most 2");
  EXPECT_EQ(refusal("[s]\na = [1, 21]", read), "plan.toml:2: s.a = 21 is out of range; allowed: 0.1 to 20");
  EXPECT_EQ(refusal("[s]\na = [1, 'x']", read), "plan.toml:2: s.a = 'x' is not a number; allowed: 0.1 to 20");
}

TEST_F(ASection, GivesAListOfTextsAndRefusesWhatIsNone) {
  const Document document = load("[s]\na = [\"one\", \"two\"]\n");
  Section section{document, "s"};
  EXPECT_EQ(section.texts("a", 2), (std::vector<std::string>{"one", "two"}));
  EXPECT_TRUE(section.texts("b", 2).empty());
  EXPECT_NE(
      refusal("[s]\na = [\"one\", 2]\n", [](Section& s) { (void)s.texts("a", 2); }).find(":2: s.a = 2 is not a text"),
      std::string::npos);
}

TEST_F(ASection, RefusesWhatIsMissing) {
  EXPECT_EQ(refusal("\n[s]\n", [](Section& s) { (void)s.number("a", limits); }),
            "plan.toml:2: s.a is missing; allowed: 0.1 to 20");
  EXPECT_EQ(refusal("", [](Section& s) { (void)s.text("a"); }), "plan.toml: s.a is missing");
}

TEST_F(ASection, RefusesAKeyNobodyAskedForAndSuggestsOne) {
  const auto read = [](Section& s) {
    (void)s.has("canard_limit_deg");
    s.finish();
  };
  EXPECT_EQ(refusal("[s]\ncanard_limit = 6", read),
            "plan.toml:2: unknown key s.canard_limit; did you mean s.canard_limit_deg?");
  EXPECT_EQ(refusal("[s]\nzebra = 6", read), "plan.toml:2: unknown key s.zebra; allowed: canard_limit_deg");
}

TEST_F(ASection, MustBeATable) {
  EXPECT_EQ(refusal("s = 3", [](Section&) {}), "plan.toml:1: [s] must be a section");
  EXPECT_EQ(refusal("[[s]]\na = 1", [](Section&) {}), "plan.toml:1: [s] must be a section");
}

TEST_F(ASection, NamesTheOverrideInsteadOfTheFile) {
  Document document = load("[s]\na = 1\n");
  document.apply(parse_override("s.a=99"));
  EXPECT_EQ(complaint([&] { (void)Section{document, "s"}.number("a", limits); }).message,
            "--set s.a=99: s.a = 99 is out of range; allowed: 0.1 to 20");
  document.apply(parse_override("s.zebra=1"));
  EXPECT_EQ(complaint([&] {
              Section section{document, "s"};
              (void)section.has("a");
              section.finish();
            }).message,
            "--set s.zebra=1: unknown key s.zebra; allowed: a");
}

}  // namespace
}  // namespace fantail::input
