// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fantail::board {

/// Which block of registers lies at which address of the bus, and what lives behind each: the world of registers of the
/// drivers' own tests, reached by address instead of by name.
class AddressSpace {
 public:
  /// The block outlives this object. Of two that overlap the one that was added first answers.
  template <typename Block>
  void add(std::uint32_t address, Block& block) {
    add(address, sizeof(Block), &block);
  }
  void add(std::uint32_t address, std::uint32_t size, void* block);

  /// Called before each access and after each write, with its address.
  std::function<void(std::uint32_t address)> before{};
  std::function<void(std::uint32_t address)> after_write{};

  /// Is there anything at this address?
  [[nodiscard]] bool has(std::uint32_t address) const { return find(address) != nullptr; }
  /// As the processor does; `address` is one of a whole register that is there.
  [[nodiscard]] std::uint32_t load(std::uint32_t address) const;
  void store(std::uint32_t address, std::uint32_t value) const;

 private:
  struct Range {
    std::uint32_t address;
    std::uint32_t size;
    volatile std::uint32_t* block;
  };
  [[nodiscard]] volatile std::uint32_t* find(std::uint32_t address) const;

  std::vector<Range> ranges_;
};

}  // namespace fantail::board
