// SPDX-License-Identifier: MIT
#include "input/rasp_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "input/messages.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

constexpr std::size_t header_words = 7;

class RaspReader {
 public:
  explicit RaspReader(const std::filesystem::path& file) : name_{file.string()}, stream_{file, std::ios::binary} {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored) || !stream_) {
      throw text::Error{text::ErrorKind::no_such_input, name_ + ": no such motor file"};
    }
  }

  sim::ThrustCurve read() {
    std::optional<std::vector<std::string>> words = next_words();
    if (!words) {
      refuse("no motor in this file; allowed: a header line and thrust points");
    }
    const double propellant_kg = read_header(*words);
    const std::size_t header_line = line_;

    std::vector<sim::ThrustPoint> points;
    std::size_t last_line = line_;
    while ((words = next_words())) {
      // Names of motors may be numbers, so only the count of words tells the next motor's header from a broken point.
      if (words->size() >= header_words && !points.empty()) {
        break;
      }
      add_point(*words, points);
      last_line = line_;
    }
    line_ = last_line;
    if (stream_.bad()) {
      refuse("cannot be read any further");
    }
    if (points.empty()) {
      refuse("no thrust points after this header");
    }
    if (points.back().thrust_n != 0.0) {
      refuse("the last thrust is " + plain_number(points.back().thrust_n) + " N; allowed: zero, which ends the motor");
    }
    return checked_curve(std::move(points), propellant_kg, header_line);
  }

 private:
  [[noreturn]] void refuse(const std::string& complaint) const {
    throw text::Error{text::ErrorKind::bad_data,
                      name_ + ":" + std::to_string(std::max<std::size_t>(line_, 1)) + ": " + complaint};
  }

  // The words of the next line that has any, comments left out; empty at the end of the file.
  std::optional<std::vector<std::string>> next_words() {
    std::string text;
    while (std::getline(stream_, text)) {
      ++line_;
      if (line_ == 1 && text.starts_with("\xEF\xBB\xBF")) {
        text.erase(0, 3);  // editors on Windows mark UTF-8 with these bytes
      }
      std::istringstream rest{text.substr(0, text.find(';'))};
      std::vector<std::string> words;
      for (std::string word; rest >> word;) {
        words.push_back(word);
      }
      if (!words.empty()) {
        return words;
      }
    }
    return std::nullopt;
  }

  // Not std::stod, which reads a decimal comma in some locales and stops silently at garbage.
  double number(const std::string& word, const std::string& what) const {
    double value = 0.0;
    const char* end = word.data() + word.size();
    const auto [stopped, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc{} || stopped != end || !std::isfinite(value)) {
      refuse(what + " \"" + word + "\"; allowed: a finite number with a decimal point");
    }
    return value;
  }

  // Returns the propellant mass. Size and delays play no part in the flight; they must only be where they belong.
  double read_header(const std::vector<std::string>& words) const {
    if (words.size() < header_words) {
      refuse("header with " + std::to_string(words.size()) +
             " words; allowed: name diameter_mm length_mm delays propellant_kg total_kg maker");
    }
    for (const auto& [index, what] : {std::pair{1U, "diameter"}, std::pair{2U, "length"}}) {
      if (number(words[index], what) < 0.0) {
        refuse(std::string{what} + " " + words[index] + " mm; allowed: not negative");
      }
    }
    const double propellant_kg = number(words[4], "propellant mass");
    const double total_kg = number(words[5], "total mass");
    if (propellant_kg <= 0.0) {
      refuse("propellant mass " + words[4] + " kg; allowed: above zero");
    }
    if (propellant_kg > total_kg) {
      refuse("propellant mass " + words[4] + " kg; allowed: at most the total mass, " + words[5] + " kg");
    }
    return propellant_kg;
  }

  [[noreturn]] void refuse_point(sim::PointFault fault, const std::vector<sim::ThrustPoint>& points,
                                 const sim::ThrustPoint& next) const {
    switch (fault) {
      case sim::PointFault::time:
        refuse("time " + plain_number(next.time_s) + " s; allowed: a finite number, not before ignition");
      case sim::PointFault::thrust:
        refuse("thrust " + plain_number(next.thrust_n) + " N; allowed: a finite number, not negative");
      case sim::PointFault::order: break;
    }
    refuse("time " + plain_number(next.time_s) + " s comes after " + plain_number(points.back().time_s) +
           " s; allowed: only forwards");
  }

  void add_point(const std::vector<std::string>& words, std::vector<sim::ThrustPoint>& points) const {
    if (words.size() != 2) {
      refuse("thrust point with " + std::to_string(words.size()) + " words, first \"" + words.front() +
             "\"; allowed: seconds newtons");
    }
    const sim::ThrustPoint point{.time_s = number(words[0], "time"), .thrust_n = number(words[1], "thrust")};
    if (const auto fault = sim::ThrustCurve::fault(points.empty() ? nullptr : &points.back(), point)) {
      refuse_point(*fault, points, point);
    }
    if (points.empty() && point.time_s > 0.0) {
      points.push_back({.time_s = 0.0, .thrust_n = 0.0});
    }
    points.push_back(point);
  }

  // Each point is in order by now; what is left to object to is the curve as a whole.
  sim::ThrustCurve checked_curve(std::vector<sim::ThrustPoint> points, double propellant_kg, std::size_t header_line) {
    try {
      return sim::ThrustCurve{std::move(points), propellant_kg};
    } catch (const std::invalid_argument& error) {
      line_ = header_line;
      refuse(error.what());
    }
  }

  std::string name_;
  std::ifstream stream_;
  std::size_t line_ = 0;
};

}  // namespace

sim::ThrustCurve load_rasp(const std::filesystem::path& file) { return RaspReader{file}.read(); }

}  // namespace fantail::input
