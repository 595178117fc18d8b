// SPDX-License-Identifier: MIT
#include "input/document.hpp"

#include "input/messages.hpp"
#include "input/section.hpp"
#include "scratch_file.hpp"
#include "test.hpp"

namespace fantail::input {
namespace {

Complaint refusal_of_file(std::string_view content) {
  const ScratchFile file{content};
  return complaint([&] { (void)Document::load(file.path()); });
}

TEST(Document, AFileThatIsNotThereIsNoSuchInput) {
  const Complaint missing = complaint([] { (void)Document::load("/nowhere/plan.toml"); });
  EXPECT_EQ(missing.fault, text::ErrorKind::no_such_input);
  EXPECT_EQ(missing.message, "plan.toml: no such file");
  EXPECT_EQ(complaint([] { (void)Document::load("/"); }).fault, text::ErrorKind::no_such_input);
}

TEST(Document, BrokenTomlSaysFileLineAndColumn) {
  const Complaint broken = refusal_of_file("[controller]\ncanard_limit_deg = = 9\n");
  EXPECT_EQ(broken.fault, text::ErrorKind::bad_data);
  EXPECT_TRUE(broken.message.starts_with("plan.toml:2:20: not valid TOML: ")) << broken.message;
}

TEST(Document, EveryKindOfBrokenTomlIsBadDataWithAPlace) {
  for (const std::string_view content :
       {std::string_view{"[controller"}, std::string_view{"a = \"open\nb = 1"}, std::string_view{"a = 1 b = 2"},
        std::string_view{"a = [1, 2"}, std::string_view{"a = 99999999999999999999"}, std::string_view{"a\0b = 1", 7},
        std::string_view{"a = \"\xff\xfe\""}, std::string_view{"= 1"},
        std::string_view{"\x7f"
                         "ELF"}}) {
    const Complaint broken = refusal_of_file(content);
    EXPECT_EQ(broken.fault, text::ErrorKind::bad_data);
    EXPECT_TRUE(broken.message.starts_with("plan.toml:1:") || broken.message.starts_with("plan.toml:2:"))
        << broken.message;
  }
}

TEST(Document, ADuplicateKeyAndADuplicateSectionAreRefusedWhereTheyStand) {
  EXPECT_TRUE(refusal_of_file("[a]\nx = 1\nx = 2\n").message.starts_with("plan.toml:3:"));
  EXPECT_TRUE(refusal_of_file("[a]\nx = 1\n[a]\ny = 2\n").message.starts_with("plan.toml:3:"));
}

TEST(Document, DeepNestingIsRefusedInsteadOfExhaustingTheStack) {
  EXPECT_EQ(refusal_of_file("a = " + std::string(100'000, '[')).fault, text::ErrorKind::bad_data);
}

TEST(Document, WindowsLineEndsAndAByteOrderMarkAreRead) {
  const ScratchFile file{"\xEF\xBB\xBF[a]\r\nx = 1\r\ny = 2\r\n"};
  const Document document = Document::load(file.path());
  EXPECT_EQ(document.root()["a"]["y"].integer(), 2);
  EXPECT_EQ(document.where("a", "y", document.root()["a"]["y"]), file.path().string() + ":3");
}

TEST(Document, AnEmptyFileIsAnEmptyDocument) {
  const ScratchFile file{""};
  EXPECT_TRUE(Document::load(file.path()).root().keys().empty());
}

TEST(Document, AHugeFileIsReadToItsEnd) {
  std::string content = "[a]\n";
  for (int i = 0; i < 200'000; ++i) {
    content += "# a comment line that says nothing at all\n";
  }
  const ScratchFile file{content + "x = 1\n"};
  const Document document = Document::load(file.path());
  EXPECT_EQ(document.where("a", "x", document.root()["a"]["x"]), file.path().string() + ":200002");
}

TEST(Override, ReadsSectionKeyAndValue) {
  const Override change = parse_override("controller.canard_limit_deg=6");
  EXPECT_EQ(change.section, "controller");
  EXPECT_EQ(change.key, "canard_limit_deg");
  EXPECT_EQ(change.value, "6");
  EXPECT_EQ(change.text(), "--set controller.canard_limit_deg=6");
}

TEST(Override, TheValueMayHoldDotsAndEqualsSigns) {
  EXPECT_EQ(parse_override("a.b=1.5").value, "1.5");
  EXPECT_EQ(parse_override("a.b=x=y.z").value, "x=y.z");
}

TEST(Override, SpacesAroundTheEqualsSignDoNotMatter) {
  const Override change = parse_override("a.b = 6");
  EXPECT_EQ(change.key, "b");
  EXPECT_EQ(change.value, "6");
}

TEST(Override, WhatIsNotSectionKeyValueIsRefusedAndShown) {
  for (const std::string text : {"", "=", "a", "a.b", "a=1", ".b=1", "a.=1", "a.b=", "a.b= ", "a=b.c", " .b=1"}) {
    const Complaint refused = complaint([&] { (void)parse_override(text); });
    EXPECT_EQ(refused.fault, text::ErrorKind::bad_configuration);
    EXPECT_TRUE(refused.message.starts_with("--set " + text + ": expected section.key=value")) << refused.message;
  }
}

TEST(Override, ReplacesAddsAndIsRememberedAsThePlaceOfTheValue) {
  const ScratchFile file{"[a]\nx = 1\n"};
  Document document = Document::load(file.path());
  document.apply(parse_override("a.x=2.5"));
  document.apply(parse_override("a.word=product"));
  document.apply(parse_override("a.list=[1, 2]"));
  document.apply(parse_override("new.flag=true"));
  EXPECT_EQ(document.root()["a"]["x"].number(), 2.5);
  EXPECT_EQ(document.root()["a"]["word"].text(), "product");
  EXPECT_EQ(document.root()["a"]["list"].elements()->size(), 2U);
  EXPECT_EQ(document.root()["new"]["flag"].flag(), true);
  EXPECT_EQ(document.where("a", "x", {}), "--set a.x=2.5");
}

TEST(Override, TheLastOfTwoWins) {
  const ScratchFile file{""};
  Document document = Document::load(file.path());
  document.apply(parse_override("a.x=1"));
  document.apply(parse_override("a.x=2"));
  EXPECT_EQ(document.root()["a"]["x"].integer(), 2);
  EXPECT_EQ(document.where("a", "x", {}), "--set a.x=2");
}

TEST(Override, WhatIsNotOneTomlValueIsAWord) {
  const ScratchFile file{""};
  Document document = Document::load(file.path());
  for (const std::string value : {"6\nb = 7", "[1, 2", "{", "1.2.3"}) {
    document.apply({"a", "x", value});
    EXPECT_EQ(document.root()["a"]["x"].text(), value);
  }
}

TEST(Override, CannotGoInsideWhatIsNotASection) {
  const ScratchFile file{"seed = 7\n"};
  Document document = Document::load(file.path());
  const Complaint refused = complaint([&] { document.apply(parse_override("seed.x=1")); });
  EXPECT_EQ(refused.fault, text::ErrorKind::bad_configuration);
  EXPECT_EQ(refused.message, "--set seed.x=1: seed is not a section");
}

TEST(Override, AnUnknownSectionIsRefusedByItsOwnName) {
  const ScratchFile file{""};
  Document document = Document::load(file.path());
  document.apply(parse_override("contoller.kp=1"));
  const std::vector<std::string> known{"controller", "guide"};
  EXPECT_EQ(complaint([&] { refuse_unknown_sections(document, known); }).message,
            "--set contoller.kp=1: unknown section [contoller]; did you mean controller?");
}

TEST(Suggestion, FindsTheWordThatWasMeantAndIsSilentWhenNoneIsNear) {
  const std::vector<std::string> known{"canard_limit_deg", "proportional_gain", "kind"};
  EXPECT_EQ(suggestion("canard_limit", known), "canard_limit_deg");
  EXPECT_EQ(suggestion("proportinal_gain", known), "proportional_gain");
  EXPECT_EQ(suggestion("kin", known), "kind");
  EXPECT_EQ(suggestion("zebra_crossing", known), std::nullopt);
  EXPECT_EQ(suggestion("x", {}), std::nullopt);
}

}  // namespace
}  // namespace fantail::input
