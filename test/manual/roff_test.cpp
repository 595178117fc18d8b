// SPDX-License-Identifier: MIT
#include "manual/roff.hpp"

#include <gtest/gtest.h>

namespace fantail::manual {
namespace {

TEST(Roff, TakesNoTextForAnInstruction) {
  EXPECT_EQ(roff("a\\b --set"), "a\\eb \\-\\-set");
  EXPECT_EQ(paragraph(".SH no heading"), ".PP\n\\&.SH no heading\n");
  EXPECT_EQ(paragraph("'tis none"), ".PP\n\\&'tis none\n");
  EXPECT_EQ(verbatim(".x\ny"), ".PP\n.RS 4\n.nf\n\\&.x\ny\n.fi\n.RE\n");
}

TEST(Roff, NamesCharactersThatAreNotAscii) { EXPECT_EQ(roff("−5 °, 𝄞"), "\\[u2212]5 \\[u00B0], \\[u1D11E]"); }

TEST(Roff, MakesBackticksBold) { EXPECT_EQ(sentence("of `--plan`, too"), "of \\fB\\-\\-plan\\fR, too"); }

TEST(Roff, LeavesOutABreakThatFollowsAHeading) {
  EXPECT_EQ(tidied(heading("NAME") + paragraph("a") + paragraph("b")), ".SH NAME\na\n.PP\nb\n");
}

}  // namespace
}  // namespace fantail::manual
