// SPDX-License-Identifier: MIT
#include "protocol/little_endian.hpp"

#include "test.hpp"

namespace fantail::protocol {
namespace {

constexpr std::uint64_t whole_word = 0x0102030405060708;

template <std::size_t bytes>
constexpr std::array<std::byte, 10> put_at_one() {
  std::array<std::byte, 10> out{};
  out.fill(std::byte{0x5A});
  put<bytes>(out, 1, whole_word);
  return out;
}

constexpr std::array<std::byte, 10> as_documented(std::size_t bytes) {
  std::array<std::byte, 10> out{};
  out.fill(std::byte{0x5A});
  for (std::size_t i = 0; i < bytes; ++i) {
    out.at(1 + i) = static_cast<std::byte>(8 - i);  // the lowest byte of the number is 8
  }
  return out;
}

template <std::size_t bytes>
void expect_the_lowest_byte_first() {
  constexpr auto by_the_compiler = put_at_one<bytes>();
  EXPECT_EQ(by_the_compiler, as_documented(bytes)) << bytes;
  EXPECT_EQ(put_at_one<bytes>(), as_documented(bytes)) << bytes;
  constexpr std::uint64_t part = bytes == 8 ? whole_word : whole_word % (std::uint64_t{1} << (8 * bytes % 64));
  constexpr std::uint64_t read_by_the_compiler = get<bytes>(by_the_compiler, 1);
  EXPECT_EQ(read_by_the_compiler, part) << bytes;
  EXPECT_EQ(get<bytes>(as_documented(bytes), 1), part) << bytes;
}

// In a program it is one store; to the compiler, and on a processor of the other byte order, it is one byte after the
// other, and must be the same.
TEST(LittleEndian, TheLowestByteComesFirstForTheProgramAndForTheCompiler) {
  expect_the_lowest_byte_first<1>();
  expect_the_lowest_byte_first<2>();
  expect_the_lowest_byte_first<4>();
  expect_the_lowest_byte_first<6>();
  expect_the_lowest_byte_first<8>();
}

}  // namespace
}  // namespace fantail::protocol
