// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>

#include <unistd.h>

#include "test.hpp"

// As every verb does, it lives on when a reader of what it writes is gone, and the call says so. A program with a
// skipped test must not look like one that has passed.
int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  // The environment that ./dev test makes; a person's own goes before it.
  if (::access(FANTAIL_TEST_PYTHON, X_OK) == 0) {
    ::setenv("FANTAIL_PYTHON", FANTAIL_TEST_PYTHON, 0);
  }
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  return failed == 0 && testing::UnitTest::GetInstance()->skipped_test_count() > 0 ? 77 : failed;
}
