// SPDX-License-Identifier: MIT
// The fuzzer's target without the fuzzer: its seeds, and mutations of them.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fuzz/log_seeds.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fantail::test {
namespace {

void run_target(const std::string& input) {
  (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

class Mutation {
 public:
  explicit Mutation(std::uint32_t seed) : random_{seed} {}

  std::string of(const std::vector<std::string>& inputs) {
    std::string bytes = inputs[below(inputs.size())];
    for (std::size_t changes = 1 + below(6); changes > 0; --changes) {
      const std::size_t at = below(bytes.size() + 1);
      const std::size_t length = below(std::min<std::size_t>(bytes.size() - at, 90) + 1);
      const std::string& other = inputs[below(inputs.size())];
      switch (below(8)) {
        case 0: bytes.erase(at, length); break;
        case 1: bytes.insert(below(bytes.size() + 1), bytes.substr(at, length)); break;
        case 2: bytes.replace(at, length, other.substr(below(other.size() + 1), 90)); break;
        case 3: bytes.resize(at); break;
        case 4: bytes.insert(at, length, static_cast<char>(below(2) == 0 ? 0xFF : 0)); break;
        case 5: std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), length, odd_byte()); break;
        default:
          if (at < bytes.size()) {
            bytes[at] = below(2) == 0 ? odd_byte() : static_cast<char>(bytes[at] ^ (1 << below(8)));
          }
      }
    }
    return bytes;
  }

 private:
  char odd_byte() {
    constexpr unsigned char odd[]{0x00, 0x01, 0x7F, 0x80, 0xFE, 0xFF, 0xA5, 0x3F};
    return static_cast<char>(odd[below(8)]);
  }
  std::size_t below(std::size_t limit) { return random_() % limit; }
  std::mt19937 random_;  // NOLINT(cert-msc32-c,cert-msc51-cpp): the seed is the point
};

TEST(LogReader, HoldsItsPromisesOnTheSeeds) { std::ranges::for_each(log_seeds(), run_target); }

TEST(LogReader, HoldsItsPromisesOnMutationsOfTheSeeds) {
  const char* asked = std::getenv("FANTAIL_SEED");
  const auto seed = asked != nullptr ? static_cast<std::uint32_t>(std::stoul(asked)) : 20'261'121U;
  std::printf("seed %u\n", seed);  // a broken promise ends the program
  std::fflush(stdout);
  const auto inputs = log_seeds();
  Mutation mutation{seed};
  for (int i = 0; i < 20'000; ++i) {
    run_target(mutation.of(inputs));
  }
}

}  // namespace
}  // namespace fantail::test
