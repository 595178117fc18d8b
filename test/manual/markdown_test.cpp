// SPDX-License-Identifier: MIT
#include <stdexcept>

#include <gtest/gtest.h>

#include "manual/roff.hpp"

namespace fantail::manual {
namespace {

TEST(Markdown, TakesThePassagesThatAreMarked) {
  EXPECT_EQ(passages_for_manual("a\n<!-- manual -->\nb\n<!-- end of manual -->\nc\n<!-- manual -->\nd\n"
                                "<!-- end of manual -->\n"),
            "b\n\nd\n\n");
  EXPECT_THROW((void)passages_for_manual("nothing"), std::runtime_error);
}

TEST(Markdown, KeepsTheWordsOfALinkAndDropsStars) {
  EXPECT_EQ(roff_of_markdown("See **[the `law`](control.md)** [0, 1]\nand `a*b[1](2)`.\n"),
            ".PP\nSee the \\fBlaw\\fR [0, 1] and \\fBa*b[1](2)\\fR.\n");
}

TEST(Markdown, LeavesOutALinkThatStandsAloneInBrackets) {
  EXPECT_EQ(roff_of_markdown("As they are ([an example](a.md)) (so [it](b.md) is).\n"),
            ".PP\nAs they are (so it is).\n");
}

TEST(Markdown, MakesAnItemOfEachRowOfATable) {
  EXPECT_EQ(roff_of_markdown("| key | unit | default | meaning |\n|---|---|---|---|\n"
                             "| `tilt` | deg | 0 | Against the vertical. |\n| `roll` |  | must be there | Free. |\n"),
            ".TP\n\\fBtilt\\fR  (deg; default 0)\nAgainst the vertical.\n"
            ".TP\n\\fBroll\\fR  (must be there)\nFree.\n");
}

TEST(Markdown, PutsWhatIsTooLongForATagBehindTheText) {
  const std::string many(70, 'x');
  EXPECT_EQ(roff_of_markdown("| key | range | meaning |\n|---|---|---|\n| `kind` | " + many + " | Which. |\n"),
            ".TP\n\\fBkind\\fR\nWhich. (" + many + ")\n");
}

TEST(Markdown, KeepsCodeAsItIs) {
  EXPECT_EQ(roff_of_markdown("```toml\n[body]  # *x*\n```\nEnd.\n"),
            ".PP\n.RS 4\n.nf\n[body]  # *x*\n.fi\n.RE\n.PP\nEnd.\n");
}

TEST(Markdown, PutsAWideCommentBeforeItsLine) {
  const std::string word(31, 'x');
  EXPECT_EQ(
      roff_of_markdown("```\nkey = 1        # " + word + " " + word + "\n               # and more\nlast = 2\n```\n"),
      ".PP\n.RS 4\n.nf\n# " + word + " " + word + "\n# and more\nkey = 1\nlast = 2\n.fi\n.RE\n");
}

TEST(Markdown, KnowsHeadingsAndLists) {
  EXPECT_EQ(roff_of_markdown("## The format: `x`\n\n- one\n  and more\n  - within\n- two\n"),
            ".SH THE FORMAT: x\n.IP \\(bu 2\none and more\n.RS 4\n.IP \\(bu 2\nwithin\n.RE\n.IP \\(bu 2\ntwo\n");
  EXPECT_EQ(roff_of_markdown("`[wind]`\n\nText.\n"), ".SS [wind]\n.PP\nText.\n");
}

}  // namespace
}  // namespace fantail::manual
