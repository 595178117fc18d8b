// SPDX-License-Identifier: MIT
#include "input/toml_tree.hpp"

#include "test.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

TomlTree tree_of(const std::string& content) { return TomlTree::parse(content, "a.toml"); }

using Keys = std::vector<std::string>;

TEST(TomlTree, GivesAValueOnlyAsTheKindThatItIs) {
  const TomlTree tree = tree_of("flag = true\ninteger = 3\nnumber = 1.5\ntext = \"six\"\nlist = [1, \"two\"]\n");
  const TomlNode root = tree.root();
  EXPECT_EQ(root["flag"].flag(), true);
  EXPECT_EQ(root["integer"].integer(), 3);
  EXPECT_EQ(root["integer"].number(), 3.0);
  EXPECT_EQ(root["number"].number(), 1.5);
  EXPECT_EQ(root["text"].text(), "six");
  ASSERT_EQ(root["list"].elements().value().size(), 2U);
  EXPECT_EQ(root["list"].elements()->back().text(), "two");

  EXPECT_EQ(root["integer"].flag(), std::nullopt);
  EXPECT_EQ(root["flag"].integer(), std::nullopt);
  EXPECT_EQ(root["number"].integer(), std::nullopt);
  EXPECT_EQ(root["text"].number(), std::nullopt);
  EXPECT_EQ(root["number"].text(), std::nullopt);
  EXPECT_FALSE(root["text"].elements());
  EXPECT_FALSE(root["list"].is_table());
}

// toml++ asks whether such a character is white space, and answers by undefined behaviour.
TEST(TomlTree, RefusesWhatIsNotAsciiOutsideOfQuotesAndCommentsByItsPlace) {
  for (const char* content : {"a = 1\nb = [3.\u031a-5, 7]\n", "a = 1\nb = \u00e9\n", "a = 1\n\u00e9 = 2\n",
                              "a = 1\nb = \"x\\\u00e9\"\n", "a = 1\nb = 0.B'B\u00fd'\n", "a = 1\nb = 0.'\u00e9'\n",
                              "a = 1\nb = 'x' '\u00e9'\n", "a = 1\nb = -\"\u00e9\"\n"}) {
    try {
      (void)tree_of(content);
      FAIL() << content;
    } catch (const text::Error& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(":2:"), std::string::npos) << said;
      EXPECT_NE(said.find("not ASCII, outside of quotes and comments"), std::string::npos) << said;
    }
  }
}

TEST(TomlTree, TakesEveryLetterInQuotesAndComments) {
  const TomlTree tree = tree_of(
      "\xEF\xBB\xBF# \u00e9\n"
      "a = \"Fl\u00fcgel \\\" \u706b\"\n"
      "b = '\u00e9\\'\n"
      "c = \"\"\"\n\u00e9 \"\" x\"\"\"\"\n"
      "d = '''\u00e9'''\n"
      "\"\u00e9\" = 5 # \u00e9\n"
      "e = [ # \u00e9\n  \"\u00e9\", '\u00fc' ]\n"
      "t . \"\u00e9\" = { '\u00fc' = 1 }\n");
  const TomlNode root = tree.root();
  EXPECT_EQ(root["a"].text(), "Fl\u00fcgel \" \u706b");
  EXPECT_EQ(root["b"].text(), "\u00e9\\");
  EXPECT_EQ(root["c"].text(), "\u00e9 \"\" x\"");
  EXPECT_EQ(root["d"].text(), "\u00e9");
  EXPECT_EQ(root["\u00e9"].integer(), 5);
  EXPECT_EQ(root["e"].elements()->size(), 2U);
  EXPECT_EQ(root["t"]["\u00e9"]["\u00fc"].integer(), 1);
}

TEST(TomlTree, HasDatesAndTimesButAsNoKindThatAnybodyAsksFor) {
  const TomlTree tree = tree_of("a = 2015-12-04\nb = 07:32:00\nc = 2015-12-04T07:32:00Z\n");
  for (const char* key : {"a", "b", "c"}) {
    const TomlNode date = tree.root()[key];
    EXPECT_TRUE(date);
    EXPECT_FALSE(date.flag() || date.integer() || date.number() || date.text() || date.elements() || date.is_table());
  }
  EXPECT_EQ(tree.root()["c"].as_text(), "2015-12-04T07:32:00Z");
}

TEST(TomlTree, HasNothingInsideWhatIsNoTableOrIsNotThere) {
  const TomlTree tree = tree_of("a = 1\n");
  for (const TomlNode none : {tree.root()["b"], tree.root()["a"]["x"], tree.root()["b"]["x"], TomlNode{}}) {
    EXPECT_FALSE(none);
    EXPECT_FALSE(none.flag() || none.integer() || none.number() || none.text() || none.elements() || none.is_table());
    EXPECT_TRUE(none.keys().empty());
    EXPECT_EQ(none.line(), 0U);
  }
}

TEST(TomlTree, GivesTheKeysOfATableSortedWhereverTheyStand) {
  const TomlTree tree = tree_of("[zebra]\n[b]\ny = 1\n\"ä b\" = 2\nX = 3\n[a]\n");
  EXPECT_EQ(tree.root().keys(), (Keys{"a", "b", "zebra"}));
  EXPECT_EQ(tree.root()["b"].keys(), (Keys{"X", "y", "ä b"}));
}

TEST(TomlTree, KnowsTheLineOfEveryValueInItsFile) {
  const TomlTree tree = tree_of("\n[a]\nx = [\n  1,\n  2]\n[[b]]\n[[b]]\ny = 1\n");
  EXPECT_EQ(tree.root().line(), 1U);
  EXPECT_EQ(tree.root()["a"].line(), 2U);
  EXPECT_EQ(tree.root()["a"]["x"].line(), 3U);
  EXPECT_EQ(tree.root()["a"]["x"].elements()->back().line(), 5U);
  EXPECT_EQ(tree.root()["b"].elements()->back()["y"].line(), 8U);
  EXPECT_EQ(TomlTree{}.root().line(), 0U);
}

TEST(TomlTree, ShowsEveryValueOnOneLineAndALongOneCutOff) {
  const TomlTree tree = tree_of(
      "[a]\ninteger = 1_000\nhex = 0xFF\nnumber = 3.0\ninf = -inf\ntext = \"it's\"\n"
      "lines = \"\"\"two\nlines\"\"\"\nlist = [1, [2, 3], {x = 1}]\nempty = []\ntable = {y = 1, x.z = 'w'}\n"
      "long = [100000000, 200000000, 300000000, 400000000, 500000000, 600000000]\n[a.inside]\nx = 1\n[a.inside.it]\n");
  const TomlNode a = tree.root()["a"];
  EXPECT_EQ(a["integer"].as_text(), "1000");
  EXPECT_EQ(a["hex"].as_text(), "0xFF");
  EXPECT_EQ(a["number"].as_text(), "3.0");
  EXPECT_EQ(a["inf"].as_text(), "-inf");
  EXPECT_EQ(a["text"].as_text(), "\"it's\"");
  EXPECT_EQ(a["lines"].as_text(), "'''two lines'''");
  EXPECT_EQ(a["list"].as_text(), "[ 1, [ 2, 3 ], { x = 1 } ]");
  EXPECT_EQ(a["empty"].as_text(), "[]");
  EXPECT_EQ(a["table"].as_text(), "{ x = { z = 'w' }, y = 1 }");
  EXPECT_EQ(a["long"].as_text(), "[ 100000000, 200000000, 300000000, 400000000, 500000000, 600...");
  EXPECT_EQ(a["inside"].as_text(), "x = 1 [it]");
}

TEST(TomlTree, TakesAValueAsTomlElseAsAWordIntoATableThatMayBeNew) {
  TomlTree tree = tree_of("[a]\nx = 1\n");
  tree.put("a", "x", "2.5");
  tree.put("a", "y", "[1, 2]");
  tree.put("b", "x", "product");
  EXPECT_EQ(tree.root()["a"]["x"].number(), 2.5);
  EXPECT_EQ(tree.root()["a"]["y"].as_text(), "[ 1, 2 ]");
  EXPECT_EQ(tree.root()["a"]["y"].line(), 0U);
  EXPECT_EQ(tree.root()["b"]["x"].text(), "product");
}

TEST(TomlTree, KeepsWhatElseIsInATableOfWhichAValueIsReplaced) {
  TomlTree tree = tree_of("[a]\nx = 1\ny = 2\n");
  const TomlNode other = tree.root()["a"]["y"];
  tree.put("a", "x", "3");
  EXPECT_EQ(other.integer(), 2);
  EXPECT_EQ(other.line(), 3U);
}

}  // namespace
}  // namespace fantail::input
