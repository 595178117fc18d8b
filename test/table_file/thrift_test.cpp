// SPDX-License-Identifier: MIT
#include "table_file/thrift.hpp"

#include <string>

#include <gtest/gtest.h>

namespace fantail::table_file::thrift {
namespace {

using namespace std::string_literals;

// By hand from Thrift's thrift-compact-protocol.md: the head of a field is its step and type, a number zigzag and
// varint.
TEST(Thrift, WritesTheBytesOfItsSpecification) {
  Writer inner;
  inner.int32(1, -1);
  Writer writer;
  writer.int32(1, 150);
  writer.binary(3, "ab");
  writer.structure(4, inner);
  writer.int32s(6, {1, -2});
  EXPECT_EQ(writer.bytes(), "\x15\xAC\x02\x28\x02"s + "ab" + "\x1C\x15\x01\x00\x29\x25\x02\x03\x00"s);
}

TEST(Thrift, ReadsWhatItHasWritten) {
  Writer element;
  element.binary(4, "roll");
  Writer writer;
  writer.int64(2, -5'000'000'000);
  writer.structures(5, std::vector<Writer>(20, element));
  writer.binaries(6, {"x", ""});
  const std::string bytes = writer.bytes() + "rest";
  std::string_view rest = bytes;
  const auto value = read(rest);
  ASSERT_TRUE(value);
  EXPECT_EQ(rest, "rest");
  EXPECT_EQ(value->integer(2), -5'000'000'000);
  EXPECT_EQ(value->integer(3), std::nullopt);
  ASSERT_NE(value->find(5, Type::list), nullptr);
  ASSERT_EQ(value->find(5, Type::list)->elements.size(), 20U);
  EXPECT_EQ(value->find(5, Type::list)->elements[19].find(4, Type::binary)->bytes, "roll");
  EXPECT_EQ(value->find(6, Type::list)->elements[0].bytes, "x");
}

TEST(Thrift, HasNoValueForWhatIsCutOffOrTooDeep) {
  Writer writer;
  writer.binaries(1, {"x", "yz"});
  const std::string bytes = writer.bytes();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::string_view rest = std::string_view{bytes}.substr(0, size);
    EXPECT_FALSE(read(rest)) << size;
  }
  const std::string deep(100'000, '\x1C');
  std::string_view rest = deep;
  EXPECT_FALSE(read(rest));
}

}  // namespace
}  // namespace fantail::table_file::thrift
