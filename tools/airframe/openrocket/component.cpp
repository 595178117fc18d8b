// SPDX-License-Identifier: MIT
#include "airframe/openrocket/component.hpp"

#include <string_view>

#include <fmt/core.h>

#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::airframe::openrocket {

std::string Component::name() const {
  const std::string given = text("name");
  return given.empty() ? kind() : given;
}

double Component::checked(const char* key, const std::string& text, double least, double most) const {
  const auto value = ::fantail::text::number(text);
  if (!value || *value < least || *value > most) {
    refuse(fmt::format("{} = \"{}\"; allowed: {} to {}", key, text, least, most));
  }
  return *value;
}

double Component::number(const char* key, double least, double most) const {
  if (!has(key)) {
    refuse(fmt::format("{} is missing", key));
  }
  return checked(key, text(key), least, most);
}

std::optional<double> Component::number_or_auto(const char* key, double least, double most) const {
  std::string given = text(key);
  if (given.starts_with("auto")) {
    given = given.size() > 5 ? given.substr(5) : "";
  }
  return given.empty() ? std::nullopt : std::optional{checked(key, given, least, most)};
}

double Component::number_or(const char* key, double least, double most, double other) const {
  return has(key) ? number(key, least, most) : other;
}

std::optional<bool> Component::flag(const char* key) const {
  if (!has(key)) {
    return std::nullopt;
  }
  const std::string given = text(key);
  const std::string_view word = ::fantail::text::trimmed(given);
  if (word != "true" && word != "false") {
    refuse(fmt::format("{} = \"{}\"; allowed: true or false", key, given));
  }
  return word == "true";
}

double Component::density(const char* material) const {
  const pugi::xml_attribute density = node_.child(material).attribute("density");
  return density ? checked("material density", density.value(), 0.0, 1e5) : 0.0;
}

void Component::refuse(const std::string& complaint) const {
  throw ::fantail::text::Error{::fantail::text::ErrorKind::bad_data,
                               fmt::format("{}: {} \"{}\": {}", file_->string(), kind(), name(), complaint)};
}

}  // namespace fantail::airframe::openrocket
