// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

#include "text/error.hpp"

namespace fantail::test {

/// Runs something that must be refused, with all the words that a person needs.
template <class Work>
void expect_refused(text::ErrorKind fault, std::initializer_list<const char*> words, const Work& work) {
  try {
    work();
    ADD_FAILURE() << "accepted";
  } catch (const text::Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.kind(), fault) << message;
    for (const char* word : words) {
      EXPECT_NE(message.find(word), std::string::npos) << message << " lacks " << word;
    }
  }
}

}  // namespace fantail::test
