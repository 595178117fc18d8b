// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "text/error.hpp"

namespace fantail::listen {

/// That `action` is refused, with a message that has all of these parts.
template <typename Action>
void expect_refusal(text::ErrorKind kind, const std::vector<std::string>& parts, Action action) {
  try {
    action();
    FAIL() << "not refused";
  } catch (const text::Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    for (const std::string& part : parts) {
      EXPECT_NE(std::string{error.what()}.find(part), std::string::npos) << "not said: " << part << "\n"
                                                                         << error.what();
    }
  }
}

}  // namespace fantail::listen
