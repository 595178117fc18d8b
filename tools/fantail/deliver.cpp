// SPDX-License-Identifier: MIT
#include "fantail/deliver.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "page/page.hpp"
#include "text/input_file.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"
#include "text/sha256.hpp"

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;

std::string paint(page::Tone tone, std::string_view words) {
  switch (tone) {
    case page::Tone::good: return painted(Color::green, words);
    case page::Tone::bad: return painted(Color::red, words);
    case page::Tone::unsure: return painted(Color::yellow, words);
    case page::Tone::plain: break;
  }
  return std::string{words};
}

void add_input(result::Made& made, const fs::path& file, const fs::path& name) {
  if (std::error_code unknown; !fs::is_regular_file(file, unknown)) {
    return;
  }
  try {
    const std::string bytes = text::read_input(file);
    const result::Made::Input one{name.string(), text::sha256(std::as_bytes(std::span{bytes}))};
    const auto is_same = [&](const auto& other) { return other.file == one.file && other.sha256 == one.sha256; };
    if (std::ranges::none_of(made.inputs, is_same)) {  // a flight may be held against itself
      made.inputs.push_back(one);
    }
  } catch (const std::runtime_error&) {
    return;  // a result without a hash is worth more than none
  }
}

}  // namespace

result::Made made_with(const std::vector<fs::path>& inputs, std::optional<std::uint64_t> seed,
                       std::vector<std::string> changes) {
  result::Made made{
      .command = page::made_by_command(), .version = FANTAIL_VERSION, .seed = seed, .changes = std::move(changes)};
  for (const fs::path& input : inputs) {
    std::error_code unknown;
    if (!fs::is_directory(input, unknown)) {
      const auto is_called_so = [&](const fs::path& other) {
        return other.filename() == input.filename() && other != input;
      };
      const fs::path folder = fs::absolute(input, unknown).parent_path().filename();
      add_input(made, input, std::ranges::any_of(inputs, is_called_so) ? folder / input.filename() : input.filename());
      continue;
    }
    const fs::path folder = fs::weakly_canonical(input).filename();  // of "." and "out/x/", too
    for (const char* const name : {"flight.csv", "flight.ftl", "summary.json"}) {
      add_input(made, input / name, folder / name);
    }
  }
  return made;
}

void deliver(const result::Document& document, const Delivery& delivery) {
  const bool is_written = !delivery.name.empty();
  if (is_written) {
    text::OutputFolder{delivery.folder, delivery.inputs}.write(result::files(document, delivery.name, delivery.page),
                                                               delivery.removed);
  }
  if (delivery.when_written) {
    delivery.when_written();
  }
  if (delivery.json) {
    fmt::print("{}", result::json(document));
  } else {
    std::string text = result::text(document, paint, output_columns());
    for (const std::string& file : is_written ? delivery.shown_files : std::vector<std::string>{}) {
      const std::string& page = delivery.page.empty() ? delivery.name : delivery.page;
      text +=
          fmt::format("  {:<8} {}\n", file,
                      text::printable((delivery.folder / (file == "page" ? page + ".html" : file + ".csv")).string()));
    }
    show_text(text + delivery.last_line + (delivery.last_line.empty() ? "" : "\n"));
  }
  if (delivery.yes_is_required && document.verdict.answer != result::Answer::yes) {
    throw RequirementNotMet{""};
  }
}

}  // namespace fantail::tool
