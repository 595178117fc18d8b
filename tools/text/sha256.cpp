// SPDX-License-Identifier: MIT
#include "text/sha256.hpp"

#include <array>
#include <cstdint>

#include <sha256.h>

namespace fantail::text {

std::string sha256(std::span<const std::byte> bytes) {
  SHA2_CTX context;
  SHA256Init(&context);
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());  // NOLINT: bytes as bytes
  std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
  return SHA256End(&context, text.data());
}

}  // namespace fantail::text
