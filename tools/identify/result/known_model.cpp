// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "identify/result/agreement.hpp"
#include "json/value.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::identify::result {
namespace {

using text::Error;
using text::ErrorKind;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw Error{ErrorKind::bad_data, file.string() + ": " + why};
}

json::Value read(const std::filesystem::path& file) {
  const std::optional<std::string> content = text::read_if_there(file);
  if (!content) {
    throw Error{ErrorKind::no_such_input,
                fmt::format("{}: no such file; allowed: an identification.json, or the folder that `fantail identify` "
                            "wrote it into",
                            file.string())};
  }
  try {
    return json::parse(*content);
  } catch (const json::Error& error) {
    refuse(file, fmt::format("not JSON: {}", error.what()));
  }
}

double above_zero(const std::filesystem::path& file, const json::Value& model, const char* key) {
  const json::Value* value = model.find(key);
  if (value == nullptr || !value->is_number() || !(value->number() > 0.0) || !std::isfinite(value->number())) {
    refuse(file, fmt::format("{} is {}; allowed: a number above 0, as `fantail identify` writes it", key,
                             value == nullptr ? "missing" : value->dump()));
  }
  return value->number();
}

/// Of alpha and beta, if the file has it: a common one, or the first of a matrix.
std::optional<double> correlation(const json::Value& model) {
  if (const json::Value* common = model.find("alpha_beta_correlation"); common != nullptr && common->is_number()) {
    return common->number();
  }
  const json::Value* matrix = model.find("correlation");
  const bool has_it = matrix != nullptr && matrix->is_array() && matrix->size() > 1 && (*matrix)[0].is_array() &&
                      (*matrix)[0].size() > 1 && (*matrix)[0][1].is_number();
  return has_it ? std::optional{(*matrix)[0][1].number()} : std::nullopt;
}

/// An identification of several windows lists them, and is open and continuous.
std::string how_identified(const json::Value& model) {
  const auto text = [](const json::Value& of, const char* key) {
    const json::Value* value = of.find(key);
    return value != nullptr && value->is_text() ? value->text() : std::string{};
  };
  const auto window = [&](const json::Value& of) {
    return fmt::format("window {} of {}", text(of, "window"), text(of, "data"));
  };
  if (const json::Value* windows = model.find("windows"); windows != nullptr && windows->is_array()) {
    std::string all = "open loop, continuous";
    for (const json::Value& one : *windows) {
      all += ", " + window(one);
    }
    return all;
  }
  return text(model, "loop").empty()
             ? ""
             : fmt::format("{} loop, {}, {}", text(model, "loop"), text(model, "method"), window(model));
}

}  // namespace

KnownModel read_model(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::is_directory(path, ignored) ? path / "identification.json" : path;
  const json::Value model = read(file);
  if (!model.is_object()) {
    refuse(file, "not an identification: it is not a JSON object");
  }
  if (model.contains("results")) {
    refuse(file,
           "it has several results, and one is needed; identify one window with one method, or windows together with "
           "--shared alpha,beta");
  }
  KnownModel known{.source = path.string(), .how = how_identified(model)};
  known.constants.value = {above_zero(file, model, "alpha_m2"), above_zero(file, model, "beta_m")};
  known.reference_area_m2 = above_zero(file, model, "reference_area_m2");
  known.constants.degrees_of_freedom = std::numeric_limits<double>::infinity();
  if (const auto together = correlation(model); together && model.contains("alpha_sd_m2")) {
    const Eigen::Vector2d deviation{above_zero(file, model, "alpha_sd_m2"), above_zero(file, model, "beta_sd_m")};
    // Rounded to eight digits, a correlation of nearly one may read one.
    constexpr double closest = 1.0 - 1e-9;
    const double share = std::clamp(*together, -closest, closest);
    known.constants.covariance << deviation(0) * deviation(0), share * deviation(0) * deviation(1),
        share * deviation(0) * deviation(1), deviation(1) * deviation(1);
    known.constants.degrees_of_freedom = above_zero(file, model, "degrees_of_freedom");
    known.covariance_is_known = true;
  }
  return known;
}

}  // namespace fantail::identify::result
