// SPDX-License-Identifier: MIT
#include "input/motor_text.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "input/file_text.hpp"
#include "text/encoding.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::input {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {}", file, complaint)};
}

/// A word of a header: without spaces, and never empty.
std::string word(std::string text) {
  std::ranges::replace_if(text, [](unsigned char c) { return c <= ' ' || c == ';'; }, '-');
  return text.empty() ? "unknown" : text;
}

/// In kilograms, of an attribute in grams.
std::string kilograms(const std::string& file, pugi::xml_node engine, const char* key) {
  const std::string given = engine.attribute(key).as_string();
  const auto grams = text::number(given);
  if (!grams) {
    refuse(file, fmt::format("engine \"{}\": {} = \"{}\"; allowed: a number of grams",
                             engine.attribute("code").as_string(), key, given));
  }
  return fmt::format("{:.9g}", 1e-3 * *grams);
}

std::string of_engine(const std::string& file, pugi::xml_node engine) {
  const auto attribute = [&](const char* key) { return word(engine.attribute(key).as_string()); };
  std::string out =
      fmt::format("{} {} {} {} {} {} {}\n", attribute("code"), attribute("dia"), attribute("len"), attribute("delays"),
                  kilograms(file, engine, "propWt"), kilograms(file, engine, "initWt"), attribute("mfg"));
  for (const pugi::xml_node point : engine.child("data").children("eng-data")) {
    out += fmt::format("{} {}\n", word(point.attribute("t").as_string()), word(point.attribute("f").as_string()));
  }
  return out;
}

std::string of_rocksim(const std::string& file, const std::string& xml) {
  pugi::xml_document document;
  if (const pugi::xml_parse_result result = document.load_buffer(xml.data(), xml.size()); !result) {
    refuse(file, fmt::format("is not XML: {} at byte {}", result.description(), result.offset));
  }
  std::string out;
  for (const pugi::xpath_node& engine : document.select_nodes("/engine-database/engine-list/engine")) {
    out += of_engine(file, engine.node());
  }
  if (out.empty()) {
    refuse(file, "is XML without an engine (<engine-database><engine-list><engine>), so no motor file of RockSim");
  }
  return out;
}

}  // namespace

std::optional<std::string> motor_text(const std::string& file) {
  std::optional<std::string> bytes = file_text(file);
  if (!bytes) {
    return std::nullopt;
  }
  std::string text = text::plain_text(std::move(*bytes));
  const bool is_xml = text::trimmed(text).starts_with('<');
  return is_xml ? of_rocksim(file, text) : text;
}

}  // namespace fantail::input
