// SPDX-License-Identifier: MIT
// The fuzzer's target without the fuzzer: its seeds, and mutations of them.

#include "fuzz/log_seeds.hpp"
#include "seed.hpp"
#include "test.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fantail::test {
namespace {

void run_target(const std::string& input) {
  (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

// At the ends of what a state of the flight law may hold, and beyond.
constexpr std::array<std::uint64_t, 8> odd_times{0x3FFF'FFFF'FFFF'FFFF, 0xC000'0000'0000'0001, 0x7FFF'FFFF'FFFF'FFFF,
                                                 0x8000'0000'0000'0000, 0x0003'FFFF'FFFF'FFFF, 0xFFFC'0000'0000'0001,
                                                 0x4E6E'6B28'CE6E'6B28, 0x7F80'0000'7FC0'0000};

void put(std::string& bytes, std::size_t at, std::uint64_t value) {
  for (std::size_t i = 0; i < 8 && at + i < bytes.size(); ++i) {
    bytes[at + i] = static_cast<char>(value >> (8 * i));
  }
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
      switch (below(9)) {
        case 0: bytes.erase(at, length); break;
        case 1: bytes.insert(below(bytes.size() + 1), bytes.substr(at, length)); break;
        case 2: bytes.replace(at, length, other.substr(below(other.size() + 1), 90)); break;
        case 3: bytes.resize(at); break;
        case 4: bytes.insert(at, length, static_cast<char>(below(2) == 0 ? 0xFF : 0)); break;
        case 5: put(bytes, at, odd_times[below(odd_times.size())]); break;
        case 6: std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), length, odd_byte()); break;
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

TEST(LogReader, HoldsItsPromisesWithAnOddNumberAnywhereInWhatTheFlightLawRemembered) {
  const auto inputs = log_seeds();
  for (std::size_t phase = 0; phase < 15; phase += 3) {
    // A header, then a checkpoint.
    const std::string& seed = inputs[phase];
    const std::size_t checkpoint = seed.find("\xA5\x02");
    ASSERT_NE(checkpoint, std::string::npos);
    for (std::size_t at = checkpoint + 14; at < checkpoint + 1700; ++at) {
      std::string changed = seed;
      put(changed, at, odd_times[(at + phase) % odd_times.size()]);
      run_target(changed);
    }
  }
}

TEST(LogReader, HoldsItsPromisesOnMutationsOfTheSeeds) {
  const auto inputs = log_seeds();
  Mutation mutation{seed(20'261'121)};
  for (int i = 0; i < 20'000; ++i) {
    run_target(mutation.of(inputs));
  }
}

}  // namespace
}  // namespace fantail::test
