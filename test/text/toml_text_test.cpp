// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "text/error.hpp"
#include "text/quoting.hpp"

namespace fantail::text {
namespace {

TEST(TomlText, QuotesWhatTomlReadsBack) {
  EXPECT_EQ(toml_text("a \"b\" c\\d \n\x7F \u00FC\U0001F680"),
            "\"a \\\"b\\\" c\\\\d \\u000a\\u007f \u00FC\U0001F680\"");
  EXPECT_EQ(toml_text(""), "\"\"");
}

TEST(TomlText, OfBytesThatAreNoUtf8IsRefused) {
  try {
    (void)toml_text("fl\xFCg");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_configuration);
    EXPECT_STREQ(error.what(), "\"fl?g\" is not text in UTF-8, which a TOML file must be; rename what is called so");
  }
}

}  // namespace
}  // namespace fantail::text
