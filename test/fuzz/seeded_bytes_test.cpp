// SPDX-License-Identifier: MIT
// A fuzzer's target without the fuzzer: its seeds, each of their beginnings, and mutations of them.

#include "seed.hpp"
#include "target.hpp"
#include "test.hpp"

namespace fantail::fuzz {
namespace {

void run_target(const std::string& input) {
  (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

TEST(FuzzTarget, HoldsItsPromisesOnItsSeedsAndEachOfTheirBeginnings) {
  const auto inputs = seeds();
  ASSERT_GE(inputs.size(), 3U);
  for (const std::string& input : inputs) {
    const std::size_t step = std::max<std::size_t>(input.size() / 200, 1);
    for (std::size_t size = 0; size < input.size(); size += step) {
      run_target(input.substr(0, size));
    }
    run_target(input);
  }
}

TEST(FuzzTarget, HoldsItsPromisesOnMutationsOfItsSeeds) {
  const auto inputs = seeds();
  std::mt19937 random{test::seed(20'261'125)};  // NOLINT(cert-msc32-c,cert-msc51-cpp): the seed is the point
  const auto below = [&random](std::size_t limit) { return random() % limit; };
  for (int i = 0; i < 2'000; ++i) {
    std::string input = inputs[below(inputs.size())];
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
      const std::size_t at = 1 + below(input.size() - 1);
      switch (below(4)) {
        case 0: input[at] = static_cast<char>(input[at] ^ (1 << below(8))); break;
        case 1: input[at] = static_cast<char>(below(256)); break;
        case 2: input.insert(at, input.substr(at, 1 + below(40))); break;
        default: input.erase(at, std::min(input.size() - at - 1, 1 + below(8)));
      }
    }
    run_target(input);
  }
}

}  // namespace
}  // namespace fantail::fuzz
