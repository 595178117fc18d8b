// SPDX-License-Identifier: MIT
#include "input/rasp_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "input/messages.hpp"
#include "input/motor_text.hpp"
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
  [[nodiscard]] std::string maker() const { return header.words.size() < header_words ? "" : header.words.back(); }
};

/// "0,5" is 0.5 to those who write a comma, and a word has no other use for one.
std::optional<double> decimal(std::string word) {
  std::ranges::replace(word, ',', '.');
  return text::decimal(word);
}

/// Words of a name that has spaces become one. A header is known by its numbers: size, delays, masses.
void join_name(std::vector<std::string>& words) {
  const auto is_number = [&](std::size_t i) { return decimal(words[i]).has_value(); };
  for (std::size_t i = 1; i + 4 < words.size(); ++i) {
    if (is_number(i) && is_number(i + 1) && is_number(i + 3) && is_number(i + 4)) {
      for (std::size_t word = 1; word < i; ++word) {
        words[0] += "_" + words[word];
      }
      words.erase(words.begin() + 1, words.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
  while (words.size() > header_words) {  // of the maker's
    words[header_words - 1] += " " + words[header_words];
    words.erase(words.begin() + header_words);
  }
}

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
    if (const std::string odd = odd_units(motor); !odd.empty()) {
      motor.warning =
          (motor.warning ? *motor.warning + " " : "") + name_ + ":" + std::to_string(block.header.number) + ": " + odd;
    }
    return motor;
  }

 private:
  // The motors of the file, not yet judged. Names of motors may be numbers, so only the count of words tells the next
  // motor's header from a broken point.
  std::vector<Block> split() {
    std::vector<Block> blocks;
    while (auto words = next_words()) {
      if (blocks.empty() || (words->size() >= header_words && !blocks.back().points.empty())) {
        join_name(*words);
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

  // "K550", or of several of that name "K550:AeroTech" or "K550:2".
  const Block& chosen(const std::vector<Block>& blocks, const std::optional<std::string>& wanted) {
    if (!wanted && blocks.size() == 1) {
      return blocks.front();
    }
    std::vector<std::string> names;
    for (const Block& block : blocks) {
      names.push_back(block.name());
    }
    if (!wanted) {
      line_ = blocks[1].header.number;
      refuse("a second motor begins here; choose one of " + some_of(names) + ", as in file = \"" +
             name_.substr(name_.rfind('/') + 1) + "#" + names.front() + "\"");
    }
    const std::size_t colon = wanted->rfind(':');
    const std::string name = wanted->substr(0, colon);
    const std::string which = colon == std::string::npos ? "" : wanted->substr(colon + 1);
    std::vector<const Block*> same;
    for (const Block& block : blocks) {
      if (block.name() == name || block.name() == *wanted) {
        same.push_back(&block);
      }
    }
    if (same.empty()) {
      line_ = blocks.front().header.number;
      const auto meant = suggestion(name, names);
      refuse("no motor \"" + name + "\" in this file; " + (meant ? "did you mean " + *meant + "? " : "") +
             "allowed: " + some_of(names));
    }
    std::vector<std::string> choices;
    for (std::size_t i = 0; i < same.size(); ++i) {
      const std::string number = std::to_string(i + 1);
      const bool is_only = std::ranges::count(same, same[i]->maker(), &Block::maker) == 1;
      if (same.size() == 1 || which == number || (is_only && which == same[i]->maker())) {
        return *same[i];
      }
      choices.push_back(name + ":" + (is_only && !same[i]->maker().empty() ? same[i]->maker() : number));
    }
    line_ = same[1]->header.number;
    refuse("a second motor called \"" + name + "\"; choose " + some_of(choices));
  }

  // A person reads a dozen; there are files of hundreds.
  static std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
      list += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > most ? list + " and " + std::to_string(names.size() - most) + " more" : list;
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
      std::istringstream rest{text.starts_with('#') ? "" : text.substr(0, text.find(';'))};
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
    const std::optional<double> value = decimal(word);
    if (!value || !std::isfinite(*value)) {
      refuse(what + " \"" + word + "\"; allowed: a finite number with a decimal point");
    }
    return *value;
  }

  // Returns the propellant mass. Size and delays play no part in the flight; they must only be where they belong.
  double read_header(const std::vector<std::string>& words) const {
    if (words.size() < header_words - 1) {  // the maker may be missing
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
    sim::ThrustPoint point{.time_s = number(words[0], "time"), .thrust_n = number(words[1], "thrust")};
    if (!points.empty() && point.time_s == points.back().time_s) {  // a step, or a point that is there twice
      if (point.thrust_n == points.back().thrust_n) {
        return;
      }
      constexpr double as_good_as_upright_s = 1e-4;
      point.time_s += as_good_as_upright_s;
    }
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
  const std::optional<std::string> text = motor_text(file.string());
  if (!text) {
    throw text::Error{text::ErrorKind::no_such_input, file.string() + ": no such motor file"};
  }
  return RaspReader{file.string(), *text}.read(motor);
}

}  // namespace fantail::input
