// SPDX-License-Identifier: MIT
#include <functional>

#include <fmt/core.h>

#include "identify/result/formatting.hpp"
#include "identify/result/frequency_page.hpp"
#include "identify/result/outputs.hpp"
#include "text/degrees.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

class Text {
 public:
  Text(const Study& study, std::size_t columns) : study_{study}, columns_{columns} {}

  std::string write() {
    heading();
    for (const WindowFindings& window : study_.windows) {
      table(window);
      conclusions(window);
    }
    return out_;
  }

 private:
  using Cell = std::function<std::string(const Identification&)>;

  template <typename... T>
  void line(fmt::format_string<T...> format, T&&... values) {
    std::string text = fmt::format(format, std::forward<T>(values)...);
    text.erase(text.find_last_not_of(' ') + 1);
    out_ += text + "\n";
  }

  void row(const WindowFindings& window, const std::string& label, const Cell& cell) {
    std::vector<std::string> cells{fmt::format("  {:<26}", label)};
    for (const Identification& result : window.results) {
      cells.push_back(fmt::format("{:<28}", cell(result)));
    }
    table_.row_to_its_last_word(cells);
  }

  void heading() {
    line("{}: the roll model", study_.data);
    line("  vehicle    {}", study_.vehicle);
    line("  density    {}", study_.density);
    line("  speed      {}", study_.speed);
    for (const std::string& warning : study_.warnings) {
      line("  Note: {}", warning);
    }
  }

  void table(const WindowFindings& window) {
    line("");
    line("window {}: {}", window.record.window, extent(window.record));
    if (window.lag_is_fitted || window.lag_s != 0.0) {
      line("  canard angles used {} ms {}{}", text::brief(1000.0 * std::abs(window.lag_s), 1),
           window.lag_s < 0.0 ? "earlier" : "later", fitted_lag(window));
    }
    table_ = text::Table{std::vector<text::Table::Column>(1 + window.results.size())};
    const bool any_known = std::ranges::any_of(window.results, [](const auto& r) { return r.uncertainty.has_value(); });
    row(window, any_known ? "+-: standard deviation" : "",
        [](const Identification& r) { return fmt::format("{}, {} loop", name(r.method), name(r.loop)); });
    number(window, "damping alpha / m2", 0);
    number(window, "torque constant beta / m", 1);
    table_.row({"  disturbance / deg"});
    // Methods may choose different numbers of nodes.
    std::size_t nodes = 0;
    for (const Identification& result : window.results) {
      nodes = std::max(nodes, result.model.node_rad.size());
    }
    for (std::size_t k = 0; k < nodes; ++k) {
      row(window, "  " + node_label(window, k), [&](const Identification& r) { return node_value(window, r, k); });
    }
    if (std::ranges::any_of(window.results, [](const Identification& r) { return r.servo.has_value(); })) {
      row(window, "servo lag / ms, fitted", servo_lag_text);
      row(window, "servo play / deg, fitted", servo_play_text);
    }
    row(window, "mean angle error / deg",
        [](const Identification& r) { return text::fixed(text::degrees(r.simulation.mean_abs_angle_error_rad), 3); });
    row(window, "mean rate error / deg/s",
        [](const Identification& r) { return text::fixed(text::degrees(r.simulation.mean_abs_rate_error_rad_s), 2); });
    table_.row({"  residual of the rate: its correlation with"});
    row(window, "  itself, within 0.2 s",
        [](const Identification& r) { return residual_text(r, &ResidualTests::own_correlation); });
    row(window, "  the canards",
        [](const Identification& r) { return residual_text(r, &ResidualTests::canard_correlation); });
    row(window, "effective samples", effective_text);
    out_ += table_.text(columns_);
    for (const Identification& result : window.results) {
      node_curve(result);
    }
  }

  void number(const WindowFindings& window, const std::string& label, std::size_t which) {
    row(window, label, [&](const Identification& r) { return with_deviation(r, which); });
    row(window, "  95 %",
        [&](const Identification& r) { return r.uncertainty ? interval_text(interval_of(r, which)) : std::string{}; });
  }

  void node_curve(const Identification& result) {
    if (result.node_trials.empty()) {
      return;
    }
    line("  intervals of the disturbance, and the mean angle error ({}):", name(result.method));
    for (const NodeTrial& trial : result.node_trials) {
      line("    {}  {} deg{}", trial.intervals, text::fixed(text::degrees(trial.mean_abs_angle_error_rad), 3),
           trial.intervals + 1 == result.model.node_rad.size() ? "  chosen" : "");
    }
  }

  void conclusions(const WindowFindings& window) {
    for (const Identification& result : window.results) {
      const std::string who = window.results.size() > 1 ? fmt::format("{}: ", name(result.method)) : "";
      if (result.uncertainty) {
        line("  {}{}.", who, result.uncertainty->verdict);
      }
      for (const std::string& remark : result.remarks) {
        line("  {}{}", who, remark);
      }
    }
    for (const std::string& remark : window.remarks) {
      line("  {}", remark);
    }
    if (const auto& response = main_result(window).frequency_response) {
      line("  {}", frequency_sentence(*response));
    }
  }

  const Study& study_;
  std::size_t columns_;
  text::Table table_{std::vector<text::Table::Column>{}};
  std::string out_;
};

}  // namespace

std::string as_text(const Study& study, std::size_t columns) { return Text{study, columns}.write(); }

}  // namespace fantail::identify::result
