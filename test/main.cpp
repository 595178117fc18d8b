// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

// A program with a skipped test must not look like one that has passed.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  return failed == 0 && testing::UnitTest::GetInstance()->skipped_test_count() > 0 ? 77 : failed;
}
