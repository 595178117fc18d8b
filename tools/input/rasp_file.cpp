// SPDX-License-Identifier: MIT
#include "input/rasp_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "input/file_text.hpp"
#include "input/messages.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::input {
namespace {

constexpr std::size_t header_words = 7;

struct Line {
  std::size_t number;
  std::vector<std::string> words;
};

struct Block {
  Line header;
  std::vector<Line> points;

  [[nodiscard]] const std::string& name() const { return header.words.front(); }
};

class RaspReader {
 public:
  RaspReader(std::string file, const std::string& text) : name_{std::move(file)}, stream_{text} {}

  RaspMotor read(const std::optional<std::string>& wanted) {
    const std::vector<Block> blocks = split();
    const Block& block = chosen(blocks, wanted);
    line_ = block.header.number;
    const double propellant_kg = read_header(block.header.words);
    if (block.points.empty()) {
      refuse("no thrust points after this header");
    }
    std::vector<sim::ThrustPoint> points;
    for (const Line& line : block.points) {
      line_ = line.number;
      add_point(line.words, points);
    }
    RaspMotor motor;
    motor.warning = end_at_zero(points);
    motor.name = block.name();
    motor.total_kg = number(block.header.words[5], "total mass");
    motor.diameter_m = 0.001 * number(block.header.words[1], "diameter");
    motor.length_m = 0.001 * number(block.header.words[2], "length");
    motor.curve = checked_curve(std::move(points), propellant_kg, block.header.number);
    return motor;
  }

 private:
  // The motors of the file, not yet judged. Names of motors may be numbers, so only the count of words tells the next
  // motor's header from a broken point.
  std::vector<Block> split() {
    std::vector<Block> blocks;
    while (auto words = next_words()) {
      if (blocks.empty() || (words->size() >= header_words && !blocks.back().points.empty())) {
        blocks.push_back({.header = {line_, std::move(*words)}, .points = {}});
      } else {
        blocks.back().points.push_back({line_, std::move(*words)});
      }
    }
    if (blocks.empty()) {
      refuse("no motor in this file; allowed: a header line and thrust points");
    }
    return blocks;
  }

  const Block& chosen(const std::vector<Block>& blocks, const std::optional<std::string>& wanted) {
    if (!wanted && blocks.size() == 1) {
      return blocks.front();
    }
    std::vector<std::string> names;
    std::string list;
    for (const Block& block : blocks) {
      names.push_back(block.name());
      list += (list.empty() ? "" : ", ") + block.name();
    }
    if (!wanted) {
      line_ = blocks[1].header.number;
      refuse("a second motor begins here; choose one of " + list + ", as in file = \"" +
             name_.substr(name_.rfind('/') + 1) + "#" + names.front() + "\"");
    }
    const auto found = std::ranges::find(blocks, *wanted, &Block::name);
    if (found == blocks.end()) {
      line_ = blocks.front().header.number;
      const auto meant = suggestion(*wanted, names);
      refuse("no motor \"" + *wanted + "\" in this file; " + (meant ? "did you mean " + *meant + "? " : "") +
             "allowed: " + list);
    }
    if (const auto second = std::ranges::find(std::next(found), blocks.end(), *wanted, &Block::name);
        second != blocks.end()) {
      line_ = second->header.number;
      refuse("a second motor called \"" + *wanted + "\"; allowed: one of each name to choose from");
    }
    return *found;
  }

  // Most published files end with the last measured thrust. Ends the curve and says so.
  std::optional<std::string> end_at_zero(std::vector<sim::ThrustPoint>& points) const {
    const sim::ThrustPoint last = points.back();
    if (last.thrust_n == 0.0) {
      return std::nullopt;
    }
    constexpr double fall_s = 0.001;
    const sim::ThrustPoint end{.time_s = last.time_s + fall_s, .thrust_n = 0.0};
    if (sim::ThrustCurve::fault(&last, end)) {
      refuse("the last thrust is " + plain_number(last.thrust_n) + " N; allowed: zero, which ends the motor");
    }
    points.push_back(end);
    return name_ + ":" + std::to_string(line_) + ": the last thrust is " + plain_number(last.thrust_n) + " N at " +
           plain_number(last.time_s) + " s, not zero; assumed: the motor is out one millisecond later.";
  }

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
    const std::optional<double> value = text::decimal(word);
    if (!value || !std::isfinite(*value)) {
      refuse(what + " \"" + word + "\"; allowed: a finite number with a decimal point");
    }
    return *value;
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
           " s; allowed: increasing times");
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
  std::istringstream stream_;
  std::size_t line_ = 0;
};

}  // namespace

RaspMotor load_rasp(const std::filesystem::path& file, const std::optional<std::string>& motor) {
  const std::optional<std::string> text = file_text(file.string());
  if (!text) {
    throw text::Error{text::ErrorKind::no_such_input, file.string() + ": no such motor file"};
  }
  return RaspReader{file.string(), *text}.read(motor);
}

}  // namespace fantail::input
