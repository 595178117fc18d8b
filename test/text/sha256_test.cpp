// SPDX-License-Identifier: MIT
#include "text/sha256.hpp"

#include <string>

#include <gtest/gtest.h>

namespace fantail::text {
namespace {

// FIPS 180-4, examples of NIST.
TEST(Sha256, IsThatOfTheStandard) {
  const std::string message = "abc";
  EXPECT_EQ(sha256(std::as_bytes(std::span{message})),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace fantail::text
