// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "fake_spi.hpp"

namespace fantail::devices {

/// What may happen to the answers of a device on an SPI bus, whatever it is.
enum class Answers : std::uint8_t {
  right,
  none,      ///< nobody drives the line, which is pulled down
  high,      ///< the same with a line that is pulled up
  late,      ///< each byte comes one byte late
  repeated,  ///< what it answered the last time to the same first byte
  flipped,   ///< one bit in a thousand is turned over
  garbage,   ///< any bytes
};

/// A device behind a wire that may fail.
class WireFault final : public hal::stm32f4::test::SpiSlave {
 public:
  WireFault(SpiSlave& device, std::uint32_t seed) : device_{device}, random_{seed} {}
  Answers answers = Answers::right;

  [[nodiscard]] Needs needs() const override { return device_.needs(); }
  void selected() override {
    device_.selected();
    first_ = true;
    place_ = 0;
    late_ = 0;
  }
  std::uint8_t exchange(std::uint8_t out) override {
    const std::uint8_t right = device_.exchange(out);
    if (first_) {
      first_ = false;
      known_ = &known_answers_[out];
    }
    if (known_->size() <= place_) {
      known_->resize(place_ + 1);
    }
    std::uint8_t& known = (*known_)[place_++];
    if (answers != Answers::repeated) {
      known = right;
    }
    const std::uint8_t before = late_;
    late_ = right;
    switch (answers) {
      case Answers::right: break;
      case Answers::none: return 0;
      case Answers::high: return 0xFF;
      case Answers::late: return before;
      case Answers::repeated: return known;
      case Answers::flipped: return static_cast<std::uint8_t>(right ^ noise());
      case Answers::garbage: return static_cast<std::uint8_t>(random_());
    }
    return right;
  }
  void deselected() override { device_.deselected(); }

 private:
  std::uint8_t noise() {
    unsigned bits = 0;
    for (int i = 0; i < 8; ++i) {
      bits = bits << 1U | (one_in_a_thousand_(random_) ? 1U : 0U);
    }
    return static_cast<std::uint8_t>(bits);
  }

  SpiSlave& device_;
  std::mt19937 random_;
  std::bernoulli_distribution one_in_a_thousand_{0.001};
  std::map<std::uint8_t, std::vector<std::uint8_t>> known_answers_;
  std::vector<std::uint8_t>* known_ = nullptr;
  std::size_t place_ = 0;
  bool first_ = true;
  std::uint8_t late_ = 0;
};

}  // namespace fantail::devices
