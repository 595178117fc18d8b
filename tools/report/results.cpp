// SPDX-License-Identifier: MIT
#include "report/results.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "flight/write_csv.hpp"
#include "text/output_folder.hpp"

namespace fantail::report {
namespace {

std::string text(std::span<const std::byte> bytes) {
  std::string out(bytes.size(), '\0');
  std::ranges::transform(bytes, out.begin(), [](std::byte byte) { return static_cast<char>(byte); });
  return out;
}

constexpr const char* own_log = "flight.ftl";
constexpr const char* own_readings = "tunnel.csv";
constexpr const char* own_path = "trajectory.csv";
constexpr const char* own_turning = "turning.csv";
constexpr const char* own_free_roll = "without_control.csv";

std::vector<text::NamedFile> result_files(const flight::Flight& flight, const Results& results) {
  std::vector<text::NamedFile> files(3);
  // First, because its charts have as many numbers as the rows, and are gone when the largest file is made.
  files[2] = {"report.html", result::html(answer(flight, results.figures, results.verdict, results.document.made))};
  files[1] = {"summary.json", result::json(results.document)};
  files[0] = {"flight.csv", csv(flight)};
  return files;
}

}  // namespace

Results results(const flight::Flight& flight, const result::Made& made) {
  const Figures figures = report::figures(flight);
  const Verdict verdict = report::verdict(flight, figures);
  return {figures, verdict, summary(flight, figures, verdict, made)};
}

std::vector<std::string> write_results(const flight::Flight& flight, const Results& results,
                                       const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& made_from) {
  std::vector<text::NamedFile> files = result_files(flight, results);
  std::vector<std::string> of_others{"card.png"};  // which earlier versions drew
  const auto add = [&](const char* name, bool there, const auto& content) {
    if (there) {
      files.push_back({name, content()});
    } else {
      of_others.emplace_back(name);
    }
  };
  add(own_log, !flight.log.empty(), [&] { return text(flight.log); });
  add(own_readings, !flight.tunnel_readings.empty(), [&] { return flight::tunnel_csv(flight); });
  add(own_path, !flight.path.empty(), [&] { return flight::trajectory_csv(flight.path, flight.path_frame); });
  add(own_turning, !flight.turning.empty(), [&] { return flight::turning_csv(flight.turning); });
  add(own_free_roll, !flight.without_control.empty(), [&] { return flight::free_roll_csv(flight.without_control); });
  text::OutputFolder{folder, made_from}.write(files, of_others);
  std::vector<std::string> names;
  std::ranges::transform(files, std::back_inserter(names), &text::NamedFile::name);
  return names;
}

void write_report(const flight::Flight& flight, const Results& results, const std::filesystem::path& folder,
                  const std::filesystem::path& input) {
  for (const char* name : {own_log, own_readings, own_path, own_turning, own_free_roll}) {
    std::error_code not_there;
    if (std::filesystem::exists(folder / name, not_there)) {
      throw text::OutputError{(folder / name).string() +
                              ": this folder has the files of a flight, and a report does not mix its own with them; "
                              "choose another folder"};
    }
  }
  text::OutputFolder{folder, {input}}.write(result_files(flight, results));
}

}  // namespace fantail::report
