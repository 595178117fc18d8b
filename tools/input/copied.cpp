// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <filesystem>

#include "input/file_checks.hpp"
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

std::vector<std::string> shared_sentences(const std::vector<std::string>& ours, const TomlNode& theirs) {
  std::vector<std::string> shared;
  for (const TomlNode& element : theirs.elements().value_or(std::vector<TomlNode>{})) {
    const std::optional<std::string> sentence = element.text();
    if (sentence && std::ranges::find(ours, *sentence) != ours.end()) {
      shared.push_back(*sentence);
    }
  }
  return shared;
}

}  // namespace

std::optional<std::string> question_about_vehicle(const Document& document, const sim::Vehicle& vehicle) {
  if (is_shipped(Shipped::vehicle, document.file())) {
    return std::nullopt;
  }
  std::string question;
  std::string about_model;
  std::size_t most_alike = 0;
  for (const std::string& name : shipped_names(Shipped::vehicle)) {
    const Document shipped = Document::load(find_input(Shipped::vehicle, name).string());
    const TomlNode body = shipped.root()["body"];
    const std::string whose = " of the shipped vehicle " + name + "; ";
    // Sentences are shared by several shipped vehicles; the name says which one was copied, or else how many they are,
    // and the roll model.
    if (body["name"].text() == vehicle.name) {
      return document.file() + ": body.name \"" + vehicle.name + "\" is that" + whose + "is it true of this rocket?";
    }
    const TomlNode roll = shipped.root()["aerodynamics"];
    const bool same_model = roll["damping_m2"].number() == vehicle.roll_plant.damping_m2 &&
                            roll["torque_m"].number() == vehicle.roll_plant.torque_m;
    if (about_model.empty() && same_model) {
      about_model = document.file() + ": aerodynamics.damping_m2 and torque_m are those" + whose +
                    "were they found for this rocket?";
    }
    const std::vector<std::string> shared = shared_sentences(vehicle.assumed, body["assumed"]);
    if (const std::size_t likeness = 2 * shared.size() + (same_model ? 1 : 0);
        !shared.empty() && likeness > most_alike) {
      most_alike = likeness;
      question = document.file() + ": body.assumed \"" + shared.front() + "\" is an assumption" + whose +
                 "is it true of this rocket?";
    }
  }
  question = question.empty() ? about_model : question;
  return question.empty() ? std::nullopt : std::optional{question};
}

std::vector<std::string> questions_about_scenario(const Document& scenario_file, const Document& vehicle_file,
                                                  const sim::Scenario& scenario) {
  std::vector<std::string> questions;
  if (is_shipped(Shipped::scenario, scenario_file.file())) {
    return questions;
  }
  for (const std::string& name : shipped_names(Shipped::scenario)) {
    const Document shipped = Document::load(find_input(Shipped::scenario, name).string());
    if (const auto shared = shared_sentences(scenario.assumed, shipped.root()["assumed"]); !shared.empty()) {
      questions.push_back(scenario_file.file() + ": assumed \"" + shared.front() +
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
