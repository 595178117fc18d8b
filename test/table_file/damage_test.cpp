// SPDX-License-Identifier: MIT
// What a log must never do is to be read as another one.
#include <cstddef>
#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "random/seed.hpp"
#include "table_file/parquet_writer.hpp"
#include "table_file/read.hpp"
#include "table_file/tables.hpp"
#include "text/error.hpp"

namespace fantail::table_file {
namespace {

struct Format {
  const char* name;
  std::string whole;
  std::function<Columns(std::string_view, const std::string&)> read;
};

const Format formats[] = {{"log.mat", mat_file(small_table()),
                           [](std::string_view file, const std::string& name) { return read_mat(file, name, known); }},
                          {"log.parquet", parquet::file(small_table(), "{}"), read_parquet}};

// Whether it was refused, with the name of the file; anything else must be the table as it was.
bool is_refused(const Format& format, const std::string& bytes, const std::string& damage) {
  try {
    EXPECT_TRUE(same(format.read(bytes, format.name), format.read(format.whole, format.name)))
        << format.name << ", " << damage << ": read as another table";
    return false;
  } catch (const text::Error& error) {
    EXPECT_TRUE(std::string_view{error.what()}.starts_with(format.name)) << error.what();
    return true;
  }
}

TEST(DamagedTableFile, IsRefusedWhereverItIsCutOff) {
  for (const Format& format : formats) {
    for (std::size_t size = 0; size < format.whole.size(); ++size) {
      // A MAT-file has no end of its own: one that is cut off between two variables is a whole one with fewer of them.
      const bool ends_with_a_variable =
          format.name == formats[0].name && size >= 128 && format.whole.substr(size, 4) == std::string("\x0F\0\0\0", 4);
      if (!ends_with_a_variable) {
        EXPECT_TRUE(is_refused(format, format.whole.substr(0, size), std::to_string(size))) << format.name << size;
      }
    }
  }
}

TEST(DamagedTableFile, IsNeverReadAsAnotherTableWhateverBitFlips) {
  for (const Format& format : formats) {
    std::size_t refused = 0;
    for (std::size_t bit = 0; bit < 8 * format.whole.size(); ++bit) {
      std::string damaged = format.whole;
      damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
      refused += is_refused(format, damaged, "bit " + std::to_string(bit)) ? 1 : 0;
    }
    EXPECT_GT(refused, 4 * format.whole.size()) << format.name << ": some bits mean nothing, but not half of them";
  }
}

// Nothing but a refusal may come of bytes that are none: no crash, no endless loop. What comes out is not looked at.
TEST(DamagedTableFile, OfAnyBytesEndsInATableOrARefusal) {
  std::mt19937 random{test::seed()};
  const auto drawn = [&](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>{0, below - 1}(random);
  };
  std::size_t refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const Format& format = formats[i % 2];
    std::string bytes = format.whole;
    for (std::size_t changes = 1 + drawn(8); changes > 0; --changes) {
      const std::size_t at = drawn(bytes.size());
      switch (drawn(3)) {
        case 0: bytes[at] = static_cast<char>(drawn(256)); break;
        case 1: bytes.erase(at, 1 + drawn(16)); break;
        default: bytes.insert(at, bytes.substr(drawn(bytes.size()), 1 + drawn(16)));
      }
    }
    try {
      (void)format.read(bytes, format.name);
    } catch (const text::Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000U);
}

}  // namespace
}  // namespace fantail::table_file
