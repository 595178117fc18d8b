// SPDX-License-Identifier: MIT
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "table_file/mat_writer.hpp"
#include "table_file/read.hpp"
#include "table_file/tables.hpp"

namespace fantail::table_file {
namespace {

using test::expect_refused;
using text::ErrorKind;

Columns read(const std::vector<std::string>& variables) { return read_mat(mat::file(variables), "log.mat", known); }

// A MAT-file has numbers only: flags and whole numbers come back as such.
TEST(MatFile, GivesItsNumbersAndWordsBack) {
  Columns wanted = small_table();
  wanted[2].kind = Kind::number;
  wanted[3].kind = Kind::number;
  EXPECT_TRUE(same(read_mat(mat_file(small_table()), "log.mat", known), wanted));
}

TEST(MatFile, TakesTheVariablesOrTheOnlyStructWithColumns) {
  const std::string time = mat::column(std::vector{0.0, 0.1}, "time_s");
  const std::string mass = mat::column(std::vector{12.5}, "mass_kg");
  const Columns variables = read({time, mass, mat::text("a note", "note")});
  ASSERT_EQ(variables.size(), 1U) << "single values are no columns";
  EXPECT_EQ(variables[0].name, "time_s");
  const std::vector<mat::Member> members{{"time_s", {mat::column(std::vector{0.0, 0.1})}},
                                         {"name", {mat::text("dart")}}};
  EXPECT_EQ(read({mass, mat::structs(1, members, "data")}).at(0).values, (std::vector{0.0, 0.1}));
  EXPECT_EQ(read({time, mat::structs(1, members, "flight")}).size(), 1U) << "what is called flight comes first";
  expect_refused(ErrorKind::bad_data, {"log.mat", "more than one place", "variables", "the struct data"},
                 [&] { (void)read({time, mat::structs(1, members, "data")}); });
}

TEST(MatFile, TakesACellOfTextsForWords) {
  const std::string phases = mat::cell(std::vector{mat::text("armed"), mat::text(""), mat::text("armed")}, "phase");
  const Columns columns = read({mat::column(std::vector{0.0, 0.1, 0.2}, "time_s"), phases});
  EXPECT_EQ(columns.at(1).words, (std::vector<std::string>{"armed", ""}));
  EXPECT_EQ(columns.at(1).values, (std::vector{0.0, 1.0, 0.0}));
}

TEST(MatFile, RefusesColumnsThatMakeNoTable) {
  const std::string time = mat::column(std::vector{0.0, 0.1}, "time_s");
  expect_refused(ErrorKind::bad_data, {"gains has 3 values and time_s has 2"},
                 [&] { (void)read({mat::column(std::vector{1.0, 2.0, 3.0}, "gains"), time}); });
  expect_refused(ErrorKind::bad_data, {"has no columns"}, [] { (void)read({mat::text("a note", "note")}); });
  const auto with_words = [&](const std::vector<double>& phase, const std::string& words) {
    const std::vector<mat::Member> list{{"phase", {words}}};
    (void)read({time, mat::column(phase, "phase"), mat::structs(1, list, "words")});
  };
  const std::string two = mat::cell(std::vector{mat::text("armed"), mat::text("launched")});
  EXPECT_NO_THROW(with_words({1, 2}, two));
  expect_refused(ErrorKind::bad_data, {"phase has the value 3, and words.phase has 2 texts"},
                 [&] { with_words({1, 3}, two); });
  expect_refused(ErrorKind::bad_data, {"the value 1.5"}, [&] { with_words({1, 1.5}, two); });
  expect_refused(ErrorKind::bad_data, {"words.phase is no list"}, [&] { with_words({1, 2}, mat::text("armed")); });
}

// The same bytes as another class, or as complex numbers.
std::string with_flags(std::string matrix, std::uint32_t flags) {
  constexpr std::size_t at_flags = 16;
  matrix.replace(at_flags, sizeof flags, reinterpret_cast<const char*>(&flags), sizeof flags);
  return matrix;
}

TEST(MatFile, RefusesAWantedNameThatIsNoColumnAndSaysWhatItIs) {
  const std::string time = mat::column(std::vector{0.0, 0.1}, "time_s");
  const std::string angle = mat::column(std::vector{1.0, 2.0}, "roll_angle_deg");
  const std::string other = mat::column(std::vector{1.0, 2.0}, "gains");
  ASSERT_EQ(read({time, angle}).size(), 2U);
  constexpr std::uint32_t complex = 6U | 0x0800U;
  constexpr std::uint32_t sparse = 5U;
  EXPECT_EQ(read({time, with_flags(other, complex)}).size(), 1U) << "nobody asks for it";
  const auto refused = [&](const std::string& variable, const char* words) {
    expect_refused(ErrorKind::bad_data, {"log.mat: roll_angle_deg is ", words}, [&] { (void)read({time, variable}); });
  };
  refused(with_flags(angle, complex), "complex numbers");
  refused(with_flags(angle, sparse), "a sparse matrix");
  refused(mat::column(std::vector{1.0}, "roll_angle_deg"), "a single value");
  refused(mat::cell(std::vector{mat::column(std::vector{1.0}), mat::column(std::vector{2.0})}, "roll_angle_deg"),
          "a cell with something else than texts");
  std::string wide = mat::column(std::vector{1.0, 2.0, 3.0, 4.0}, "roll_angle_deg");
  constexpr std::size_t at_size = 32;
  wide[at_size] = 2;
  wide[at_size + 4] = 2;
  refused(wide, "a matrix of 2 x 2");
  EXPECT_EQ(read({time, mat::column({}, "roll_angle_deg")}).size(), 1U) << "nothing is in it";
}

TEST(MatFile, RefusesAWantedNameThatIsNoColumnInTheStructFlightToo) {
  const std::string values = mat::column(std::vector{0.0, 0.1});
  const auto flight = [&](const std::string& member) {
    const std::vector<mat::Member> members{{"time_s", {values}}, {"roll_angle_deg", {member}}};
    return read({mat::structs(1, members, "flight")});
  };
  EXPECT_EQ(flight(values).size(), 2U);
  expect_refused(ErrorKind::bad_data, {"roll_angle_deg is a cell"},
                 [&] { (void)flight(mat::cell(std::vector{values, values})); });
}

TEST(MatFile, WithTwoVariablesOfOneNameIsRefused) {
  const std::vector<mat::Member> members{{"time_s", {mat::column(std::vector{0.0, 0.1})}}};
  const std::string flight = mat::structs(1, members, "flight");
  expect_refused(ErrorKind::bad_data, {"log.mat: has two variables with the name flight"},
                 [&] { (void)read({flight, flight}); });
}

TEST(MatFile, OfOneRowHasColumns) {
  const std::vector<mat::Member> members{{"time_s", {mat::column(std::vector{1.0})}},
                                         {"roll_angle_deg", {mat::column(std::vector{30.0})}}};
  const Columns columns = read({mat::structs(1, members, "flight")});
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[1].values, std::vector{30.0});
}

TEST(MatFile, OfAnotherKindIsRefusedWithWhatToDo) {
  const auto refused = [](const std::string& text, std::initializer_list<const char*> words) {
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read_mat(text, "log.mat", known); });
  };
  refused("", {"log.mat", "empty"});
  refused("time_s,roll_angle_deg\n0,1\n", {"no MAT-file of version 5"});
  refused("MATLAB 7.3 MAT-file, Platform: GLNXA64", {"HDF5", "-v7"});
  refused("# Created by Octave 7.3.0\n# name: x\n", {"text", "-v7"});
  std::string big_endian = mat_file(small_table());
  std::swap(big_endian[126], big_endian[127]);
  refused(big_endian, {"other order of bytes"});
}

// Written by GNU Octave 7.3 from the same columns in several classes, packed and not (test/table_file/octave_files.m).
TEST(MatFile, OfOctaveIsReadPackedAndNot) {
  for (const char* name : {"octave_v6.mat", "octave_v7.mat"}) {
    std::ostringstream bytes;
    bytes << std::ifstream{FANTAIL_TABLES "/" + std::string{name}, std::ios::binary}.rdbuf();
    const Columns columns = read_mat(bytes.str(), name, known);
    ASSERT_EQ(columns.size(), 7U) << name;
    EXPECT_EQ(columns[0].name, "time_s");
    EXPECT_EQ(columns[0].values, (std::vector{0.0, 0.25, 0.5})) << "a range";
    EXPECT_EQ(columns[1].values, (std::vector{1.5, -2.5, 1e-300})) << "a row";
    EXPECT_EQ(columns[2].values, (std::vector{1.0, 0.0, 1.0})) << "logical";
    EXPECT_EQ(columns[3].values, (std::vector{-7.0, 0.0, 127.0})) << "int8";
    EXPECT_EQ(columns[4].values, (std::vector{0.5, 1.5, 2.5})) << "single";
    EXPECT_EQ(columns[5].words, (std::vector<std::string>{"armed", "launched"})) << "a cell of texts";
    EXPECT_EQ(columns[6].words, (std::vector<std::string>{"ok", "error"})) << "a matrix of characters";
    EXPECT_EQ(columns[6].values, (std::vector{0.0, 1.0, 0.0}));
  }
}

}  // namespace
}  // namespace fantail::table_file
