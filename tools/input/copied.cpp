// SPDX-License-Identifier: MIT
#include "input/copied.hpp"

#include <algorithm>
#include <filesystem>

#include "input/shipped.hpp"

namespace fantail::input {
namespace {

bool is_shipped(Shipped kind, const std::filesystem::path& file) {
  const std::vector<std::string> names = shipped_names(kind);
  const std::string name = file.stem().string();
  std::error_code ignored;
  return std::ranges::find(names, name) != names.end() &&
         std::filesystem::equivalent(file, find_input(kind, name), ignored);
}

// The first sentence that both have.
std::optional<std::string> shared_sentence(const std::vector<std::string>& ours, const TomlNode& theirs) {
  for (const TomlNode& element : theirs.elements().value_or(std::vector<TomlNode>{})) {
    const std::optional<std::string> sentence = element.text();
    if (sentence && std::ranges::find(ours, *sentence) != ours.end()) {
      return sentence;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> question_about_vehicle(const Document& document, const sim::Vehicle& vehicle) {
  if (is_shipped(Shipped::vehicle, document.file())) {
    return std::nullopt;
  }
  std::optional<std::string> about_assumption;
  for (const std::string& name : shipped_names(Shipped::vehicle)) {
    const Document shipped = Document::load(find_input(Shipped::vehicle, name).string());
    const TomlNode body = shipped.root()["body"];
    const std::string whose = " of the shipped vehicle " + name + "; is it true of this rocket?";
    // Sentences are shared by several shipped vehicles; the name says which one was copied.
    if (body["name"].text() == vehicle.name) {
      return document.file() + ": body.name \"" + vehicle.name + "\" is that" + whose;
    }
    if (const auto sentence = shared_sentence(vehicle.assumed, body["assumed"]); sentence && !about_assumption) {
      about_assumption = document.file() + ": body.assumed \"" + *sentence + "\" is an assumption" + whose;
    }
  }
  return about_assumption;
}

std::vector<std::string> questions_about_scenario(const Document& scenario_file, const Document& vehicle_file,
                                                  const sim::Scenario& scenario) {
  std::vector<std::string> questions;
  if (is_shipped(Shipped::scenario, scenario_file.file())) {
    return questions;
  }
  for (const std::string& name : shipped_names(Shipped::scenario)) {
    const Document shipped = Document::load(find_input(Shipped::scenario, name).string());
    if (const auto sentence = shared_sentence(scenario.assumed, shipped.root()["assumed"])) {
      questions.push_back(scenario_file.file() + ": assumed \"" + *sentence +
                          "\" is an assumption of the shipped scenario " + name + "; is it true of this run?");
      break;
    }
  }
  if (scenario.tunnel_result && is_shipped(Shipped::tunnel_result, *scenario.tunnel_result) &&
      !is_shipped(Shipped::vehicle, vehicle_file.file())) {
    questions.push_back(scenario_file.file() + ": tunnel_result \"" +
                        std::filesystem::path{*scenario.tunnel_result}.stem().string() +
                        "\" is shipped and the vehicle is not; was this vehicle measured there?");
  }
  return questions;
}

}  // namespace fantail::input
