// SPDX-License-Identifier: MIT
#include <csignal>

#include <gtest/gtest.h>

// As every verb does, it lives on when a reader of what it writes is gone, and the call says so. A program with a
// skipped test must not look like one that has passed.
int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  return failed == 0 && testing::UnitTest::GetInstance()->skipped_test_count() > 0 ? 77 : failed;
}
