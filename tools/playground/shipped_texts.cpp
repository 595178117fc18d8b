// SPDX-License-Identifier: MIT
// Where there are no files: what input/shipped.cpp, file_text.cpp and copied.cpp are on a PC, over the embedded texts.
// libc++ for WASI has std::filesystem::path as a class and none of its functions, so a path here is the text it holds.
#include "playground/shipped_texts.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "input/file_checks.hpp"
#include "input/file_text.hpp"
#include "input/messages.hpp"
#include "input/motor_text.hpp"
#include "input/shipped.hpp"
#include "text/error.hpp"

namespace fantail::playground {
namespace {

std::string& behind_scenarios() {
  static std::string text;
  return text;
}

}  // namespace

void append_to_scenarios(std::string text) { behind_scenarios() = std::move(text); }

}  // namespace fantail::playground

namespace fantail::input {
namespace {

/// "sim/scenarios/"
std::string folder_of(Shipped kind) { return std::string{place_of(kind).folder} + '/'; }

std::filesystem::path find(Shipped kind, const std::string& name, const std::string& where) {
  const ShippedPlace place = place_of(kind);
  const std::vector<std::string> names = shipped_names(kind);
  if (std::ranges::find(names, name) != names.end()) {
    return folder_of(kind) + name + std::string{place.extension};
  }
  const auto meant = suggestion(name, names);
  std::string message = where + "unknown " + std::string{place.noun} + " \"" + name + '"' +
                        (meant ? "; did you mean " + *meant + "?" : ";") + " shipped:";
  for (const std::string& one : names) {
    message += " " + one;
  }
  throw text::Error{text::ErrorKind::no_such_input, message};
}

}  // namespace

std::optional<std::string> file_text(const std::string& file) {
  const auto texts = playground::shipped_texts();
  const auto found = std::ranges::find(texts, file, &playground::ShippedText::file);
  if (found == texts.end()) {
    return std::nullopt;
  }
  const bool is_scenario = file.starts_with(folder_of(Shipped::scenario));
  return std::string{found->text} + (is_scenario ? playground::behind_scenarios() : std::string{});
}

std::optional<std::string> motor_text(const std::string& file) { return file_text(file); }

std::vector<std::string> shipped_names(Shipped kind) {
  const std::string folder = folder_of(kind);
  std::vector<std::string> names;
  for (const playground::ShippedText& one : playground::shipped_texts()) {
    if (one.file.starts_with(folder)) {
      const std::string_view name = one.file.substr(folder.size());
      names.emplace_back(name.substr(0, name.size() - place_of(kind).extension.size()));
    }
  }
  return names;
}

std::filesystem::path find_input(Shipped kind, const std::string& name_or_path) { return find(kind, name_or_path, ""); }

std::filesystem::path find_named_input(Shipped kind, const Document& document, Section& section, std::string_view key) {
  return find_named_input(kind, document, section, key, section.text(key));
}

std::filesystem::path find_named_input(Shipped kind, const Document& /*document*/, const Section& section,
                                       std::string_view key, const std::string& name) {
  return find(kind, name, section.where(key) + ": ");
}

std::string name_of_file(const std::filesystem::path& file) {
  const std::string name = file.string().substr(file.string().rfind('/') + 1);
  return name.substr(0, name.rfind('.'));
}

// Every file here is a shipped one, whatever a setting has changed in it.
std::optional<std::string> question_about_vehicle(const Document& /*document*/, const sim::Vehicle& /*vehicle*/) {
  return std::nullopt;
}

std::vector<std::string> questions_about_scenario(const Document& /*scenario_file*/, const Document& /*vehicle_file*/,
                                                  const sim::Scenario& /*scenario*/) {
  return {};
}

}  // namespace fantail::input
