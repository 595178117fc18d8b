// SPDX-License-Identifier: MIT
#include "json/value.hpp"

#include <cstdio>

#include "seed.hpp"
#include "test.hpp"

namespace fantail::json {
namespace {

std::string message_of(const auto& action) {
  try {
    (void)action();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was wrong";
}

TEST(Value, ANumberShowsWhetherItIsWhole) {
  EXPECT_EQ(Value(1).dump(), "1");
  EXPECT_EQ(Value(1.0).dump(), "1.0");
  EXPECT_EQ(Value(-7).dump(), "-7");
  EXPECT_EQ(Value(-0.0).dump(), "-0.0");
  EXPECT_EQ(Value(std::uint8_t{200}).dump(), "200");
}

TEST(Value, ADoubleHasAsManyDigitsAsItNeeds) {
  EXPECT_EQ(Value(0.1).dump(), "0.1");
  EXPECT_EQ(Value(1.0 / 3.0).dump(), "0.3333333333333333");
  EXPECT_EQ(Value(1e14).dump(), "100000000000000.0");
  EXPECT_EQ(Value(1e15).dump(), "1e+15");
  EXPECT_EQ(Value(1e-5).dump(), "1e-05");
  EXPECT_EQ(Value(5e-324).dump(), "5e-324");
}

TEST(Value, AFloatShowsTheDoubleThatItIs) {
  EXPECT_EQ(Value(0.5F).dump(), "0.5");
  EXPECT_EQ(Value(0.1F).dump(), "0.10000000149011612");
}

TEST(Value, TheLargestIntegersKeepEveryDigit) {
  EXPECT_EQ(Value(std::numeric_limits<std::uint64_t>::max()).dump(), "18446744073709551615");
  EXPECT_EQ(Value(std::numeric_limits<std::int64_t>::min()).dump(), "-9223372036854775808");
  EXPECT_EQ(parse("18446744073709551615").count(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(parse("-9223372036854775808").dump(), "-9223372036854775808");
}

TEST(Value, WhatIsNoNumberIsNull) {
  EXPECT_EQ(Value(std::nan("")).dump(), "null");
  EXPECT_EQ(Value(-std::numeric_limits<double>::infinity()).dump(), "null");
}

TEST(Value, AnObjectKeepsTheOrderInWhichItWasMade) {
  Value value{{"z", 1}, {"a", {{"y", true}, {"b", nullptr}}}};
  value["m"] = "text";
  value["z"] = 2;  // where it was
  EXPECT_EQ(value.dump(), R"({"z":2,"a":{"y":true,"b":null},"m":"text"})");
}

TEST(Value, OfTwoMembersWithOneNameTheFirstIsWritten) { EXPECT_EQ((Value{{"a", 1}, {"a", 2}}.dump()), R"({"a":1})"); }

TEST(Value, PrettyIsAFileIndentedByTwo) {
  const Value value{{"list", Value::array({1, "two", Value::array()})}, {"object", {{"a", 0.5}}}};
  EXPECT_EQ(value.pretty(),
            "{\n  \"list\": [\n    1,\n    \"two\",\n    []\n  ],\n  \"object\": {\n    \"a\": 0.5\n  }\n}\n");
}

TEST(Value, NullBecomesWhatIsBuiltOfIt) {
  Value value;
  EXPECT_TRUE(value.is_null());
  value["a"]["b"].push_back(1);
  EXPECT_EQ(value.dump(), R"({"a":{"b":[1]}})");
  value["a"]["b"][0] = false;
  EXPECT_EQ(value.dump(), R"({"a":{"b":[false]}})");
  EXPECT_EQ(message_of([&] { return value["a"]["b"]["c"]; }), "not an object: [false]");
  EXPECT_EQ(message_of([&] { return value.push_back(1), 0; }), R"(not an array: {"a":{"b":[false]}})");
}

TEST(Value, BracesAroundAValueAreNoArray) {
  const Value text{"a"};
  const Value same{text};  // NOLINT(performance-unnecessary-copy-initialization): the copy is what is tested
  EXPECT_EQ(same.dump(), R"("a")");
}

TEST(Value, AnEmptyOptionalIsNullAndAVectorAnArray) {
  EXPECT_EQ(Value(std::optional<double>{}).dump(), "null");
  EXPECT_EQ(Value(std::optional{7U}).dump(), "7");
  EXPECT_EQ(Value(std::vector<std::string>{"a", "b"}).dump(), R"(["a","b"])");
  EXPECT_EQ(Value(std::vector<double>{}).dump(), "[]");
}

TEST(Value, TextIsEscapedWhereItMustBe) {
  EXPECT_EQ(Value("\"\\/\b\f\n\r\t\x01\x7f\u00e4\u2028").dump(), "\"\\\"\\\\/\\b\\f\\n\\r\\t\\u0001\x7f\u00e4\u2028\"");
}

TEST(Value, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_EQ(Value("a\xff\xfe"
                  "b")
                .dump(),
            "\"a\ufffd\ufffdb\"");
  EXPECT_EQ(Value("\xe2\x82").dump(), "\"\ufffd\"");
  EXPECT_EQ((Value{{"\xff", 1}}.pretty()), "{\n  \"\ufffd\": 1\n}\n");
}

TEST(Value, ReadsBackWhatItWrote) {
  const Value value{{"null", nullptr},
                    {"numbers", Value::array({-1, 0, 0.1, 1e300, std::numeric_limits<std::uint64_t>::max()})},
                    {"text", "\"\n\u00e4"},
                    {"empty", Value::array()}};
  EXPECT_EQ(parse(value.dump()), value);
  EXPECT_EQ(parse(value.pretty()), value);
}

TEST(Value, NumbersAreEqualWhateverTheirForm) {
  EXPECT_EQ(Value(1), Value(1U));
  EXPECT_EQ(Value(1), Value(1.0));
  EXPECT_EQ(Value(-2.0), Value(-2));
  EXPECT_NE(Value(1), Value(1.5));
  EXPECT_NE(Value(1), Value(true));
  EXPECT_NE(Value(1), Value("1"));
  EXPECT_NE(Value(std::nan("")), Value(std::nan("")));
}

TEST(Value, ObjectsAreEqualWithOneOrder) {
  EXPECT_EQ((Value{{"a", 1}, {"b", 2}}), (Value{{"a", 1.0}, {"b", 2}}));
  EXPECT_NE((Value{{"a", 1}, {"b", 2}}), (Value{{"b", 2}, {"a", 1}}));
}

TEST(Value, AReaderFindsWhatThereIs) {
  const Value value = parse(R"( {"a": [1, -2.5, "x", true, null], "b": {}} )");
  EXPECT_EQ(value["a"][0].count(), 1U);
  EXPECT_EQ(value["a"][1].number(), -2.5);
  EXPECT_EQ(value["a"][2].text(), "x");
  EXPECT_EQ(value["a"][3].boolean(), true);
  EXPECT_TRUE(value["a"][4].is_null());
  EXPECT_EQ(value["a"].size(), 5U);
  EXPECT_TRUE(value["b"].is_object() && value["b"].empty());
  EXPECT_TRUE(value.contains("b"));
  EXPECT_EQ(value.find("c"), nullptr);
  EXPECT_EQ(value["a"].find("c"), nullptr) << "an array";
  std::string kinds;
  for (const Value& element : value["a"]) {
    kinds += element.is_count() ? 'c' : element.is_number() ? 'n' : element.is_text() ? 't' : '.';
  }
  EXPECT_EQ(kinds, "cnt..");
}

TEST(Value, WhatHasNoElementsIsEmptyToALoop) {
  for (const Value& value : {Value{}, Value("text"), Value{{"a", 1}}}) {
    EXPECT_EQ(value.begin(), value.end()) << value;
  }
}

TEST(Value, AReaderIsToldWhatItDidNotFind) {
  const Value value = parse(R"({"a":[1],"b":-1})");
  EXPECT_EQ(message_of([&] { return value["c"]; }), R"(not an object with "c": {"a":[1],"b":-1})");
  EXPECT_EQ(message_of([&] { return value["a"][1]; }), "not an array with an element 1: [1]");
  EXPECT_EQ(message_of([&] { return value["b"].count(); }), "not a whole number from 0 on: -1");
  EXPECT_EQ(message_of([&] { return value["b"].text(); }), "not text: -1");
  EXPECT_EQ(message_of([&] { return value["a"].number(); }), "not a number: [1]");
  EXPECT_EQ(message_of([&] { return value["a"].boolean(); }), "not true or false: [1]");
  EXPECT_EQ(message_of([] { return parse("{}")["a"]; }), R"(not an object with "a": {})") << "no member is made here";
}

TEST(Value, IsPrintedAsInOneLine) {
  std::ostringstream stream;
  stream << Value{{"a", 1}};
  EXPECT_EQ(stream.str(), R"({"a":1})");
}

TEST(Parse, SaysWhereTextIsNoJson) {
  for (const char* text : {"", "{", "[1,]", "nul", "{\"a\":1} x", "'a'", "01", "1e999", "\"\xff\""}) {
    EXPECT_THROW((void)parse(text), Error) << text;
  }
  EXPECT_NE(message_of([] { return parse("[1,\n 2 3]"); }).find("line 2, column 4"), std::string::npos);
}

TEST(Parse, RepeatsLittleOfWhatIsNoJson) {
  for (const std::string& text : {'"' + std::string(100'000, 'a'), std::string(100'000, '9')}) {
    EXPECT_LE(message_of([&] { return parse(text); }).size(), 300U);
  }
}

TEST(Parse, OfTwoMembersWithOneNameTheLastCounts) { EXPECT_EQ(parse(R"({"a":1,"a":2})").dump(), R"({"a":2})"); }

TEST(Parse, RefusesANestWithoutEnd) {
  EXPECT_NO_THROW((void)parse(std::string(100, '[') + std::string(100, ']')));
  const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  EXPECT_EQ(message_of([&] { return parse(deep); }), "nested deeper than 200 levels");
}

TEST(Rounded, HasSixDecimalsAndNoMinusBeforeZero) {
  EXPECT_EQ(Value(rounded(1.23456789)).dump(), "1.234568");
  EXPECT_EQ(Value(rounded(2.0)).dump(), "2.0");
  EXPECT_EQ(Value(rounded(-1e-9)).dump(), "0.0");
  EXPECT_EQ(Value(rounded(0.123456785, 8)).dump(), "0.12345679");
  EXPECT_EQ(Value(rounded(std::nan(""))).dump(), "null");
  EXPECT_EQ(Value(rounded(std::optional<double>{})).dump(), "null");
  EXPECT_EQ(Value(rounded(std::optional{1e-7})).dump(), "0.0");
}

TEST(Printed, HasTheDecimalsOfPrintf) {
  EXPECT_EQ(printed(7.914, 2).dump(), "7.91");
  EXPECT_EQ(printed(12.0, 4).dump(), "12.0");
  EXPECT_EQ(printed(-0.00001, 4).dump(), "-0.0");
  EXPECT_EQ(printed(1e20, 2).dump(), "1e+20");
  EXPECT_TRUE(printed({}, 2).is_null());
  EXPECT_TRUE(printed(std::nan(""), 2).is_null());
  std::mt19937_64 random{test::seed()};
  std::uniform_real_distribution<double> any{-1000.0, 1000.0};
  for (int i = 0; i < 20'000; ++i) {
    const double value = i % 2 == 0 ? any(random) : std::round(any(random) * 32768.0) / 32768.0;  // ties
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4f", value);
    ASSERT_EQ(printed(value, 4).number(), std::strtod(text.data(), nullptr)) << text.data();
  }
}

TEST(TextOrNull, OfNothingIsNull) {
  EXPECT_TRUE(text_or_null("").is_null());
  EXPECT_EQ(text_or_null("a"), "a");
}

TEST(JsonValue, KeepsACountThatADoubleCannotHoldAsTextToo) {
  Value small{{"seed", std::uint64_t{9007199254740991U}}};
  keep_exact(small, "seed");
  EXPECT_FALSE(small.contains("seed_text"));
  Value large{{"seed", std::uint64_t{9007199254740993U}}};
  keep_exact(large, "seed");
  EXPECT_EQ(large.dump(), "{\"seed\":9007199254740993,\"seed_text\":\"9007199254740993\"}");
  Value none{{"seed", nullptr}};
  keep_exact(none, "seed");
  EXPECT_EQ(none.size(), 1U);
}

}  // namespace
}  // namespace fantail::json
