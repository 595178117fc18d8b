// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <pugixml.hpp>

namespace fantail::airframe::openrocket {

/// One component of a design as its XML has it: numbers in SI, angles in degrees.
class Component {
 public:
  Component(const std::filesystem::path& file, pugi::xml_node node) : file_{&file}, node_{node} {}

  [[nodiscard]] std::string kind() const { return node_.name(); }  ///< "bodytube"
  [[nodiscard]] std::string name() const;                          ///< as a person named it
  [[nodiscard]] pugi::xml_node xml() const { return node_; }

  [[nodiscard]] bool has(const char* key) const { return static_cast<bool>(node_.child(key)); }
  [[nodiscard]] std::string text(const char* key) const { return node_.child(key).text().as_string(); }
  /// Throws text::Error (bad_data) where it is missing, no number, or not in the range.
  [[nodiscard]] double number(const char* key, double least, double most) const;
  /// Empty where it is missing, or "auto" without a number behind it.
  [[nodiscard]] std::optional<double> number_or_auto(const char* key, double least, double most) const;
  [[nodiscard]] double number_or(const char* key, double least, double most, double other) const;
  /// Of the material, kg/m3, kg/m2 or kg/m by its kind; 0 where it has none.
  [[nodiscard]] double density(const char* material = "material") const;
  /// Empty where it is missing. Throws as number() does for another word than true and false.
  [[nodiscard]] std::optional<bool> flag(const char* key) const;

  [[noreturn]] void refuse(const std::string& complaint) const;

 private:
  [[nodiscard]] double checked(const char* key, const std::string& text, double least, double most) const;

  const std::filesystem::path* file_;
  pugi::xml_node node_;
};

}  // namespace fantail::airframe::openrocket
