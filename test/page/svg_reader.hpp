// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <cstdlib>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace fantail::page {

struct Place {
  double x;
  double y;
};

/// Just enough of a reader of SVG for the questions of these tests.
class SvgReader {
 public:
  explicit SvgReader(std::string svg) : svg_{std::move(svg)} {}

  /// The opening tags of this element whose class begins so, in order.
  [[nodiscard]] std::vector<std::string> tags(const std::string& element, const std::string& kind) const {
    std::vector<std::string> found;
    const std::string opening = "<" + element + " ";
    for (std::size_t at = svg_.find(opening); at != std::string::npos; at = svg_.find(opening, at + 1)) {
      const std::string tag = svg_.substr(at, svg_.find('>', at) + 1 - at);
      if (tag.find("class=\"" + kind) != std::string::npos) {
        found.push_back(tag);
      }
    }
    return found;
  }
  [[nodiscard]] static std::string text(const std::string& tag, const std::string& attribute) {
    const std::string key = " " + attribute + "=\"";
    const std::size_t at = tag.find(key);
    return at == std::string::npos ? "" : tag.substr(at + key.size(), tag.find('"', at + key.size()) - at - key.size());
  }
  [[nodiscard]] static double number(const std::string& tag, const std::string& attribute) {
    return std::strtod(text(tag, attribute).c_str(), nullptr);
  }

  [[nodiscard]] std::string frame() const { return tags("rect", "frame").at(0); }
  /// Where a value at these parts of the axes (0..1 from left to right, from below upwards) belongs.
  [[nodiscard]] Place at(double x_part, double y_part) const {
    const std::string f = frame();
    return {number(f, "x") + x_part * number(f, "width"), number(f, "y") + (1.0 - y_part) * number(f, "height")};
  }

  /// The corners of a path of M, L, H, V and h0, one list for each M.
  [[nodiscard]] static std::vector<std::vector<Place>> strokes(const std::string& tag) {
    std::vector<std::vector<Place>> result;
    const std::string d = text(tag, "d");
    Place pen{};
    const char* at = d.c_str();
    while (*at != '\0') {
      const char command = *at++;
      char* next = nullptr;
      const double first = std::strtod(at, &next);
      at = next;
      switch (command) {
        case 'M':
        case 'L':
          pen = {first, std::strtod(at, &next)};
          at = next;
          break;
        case 'H': pen.x = first; break;
        case 'V': pen.y = first; break;
        default: continue;  // h0, Z
      }
      if (command == 'M') {
        result.emplace_back();
      }
      result.back().push_back(pen);
    }
    return result;
  }
  /// All texts, with markup inside as it stands.
  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> found;
    const std::regex pattern{"<text[^>]*>([^<]*)</text>"};
    for (std::sregex_iterator it{svg_.begin(), svg_.end(), pattern}; it != std::sregex_iterator{}; ++it) {
      found.push_back((*it)[1].str());
    }
    return found;
  }
  [[nodiscard]] bool has_text(const std::string& wanted) const {
    for (const std::string& text : texts()) {
      if (text == wanted) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool holds(const std::string& part) const { return svg_.find(part) != std::string::npos; }
  /// No coordinate came out as nan or inf.
  [[nodiscard]] bool finite() const {
    return !std::regex_search(svg_, std::regex{R"([ "MLHV](nan|-nan|inf|-inf)[ "MLHVZ])"});
  }

 private:
  std::string svg_;
};

}  // namespace fantail::page
