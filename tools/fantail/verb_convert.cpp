// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/core.h>

#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "files/convert.hpp"
#include "files/load.hpp"
#include "flight/table.hpp"
#include "text/input_file.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct ConvertOptions {
  std::string file;
  std::string format;
  std::string out;
  bool install = false;
};

bool is_written(const std::string& ending) {
  return std::ranges::find(files::written_endings, ending) != files::written_endings.end();
}

/// With its point: what --to says, else how the name of --out ends, else CSV.
std::string ending_of(const ConvertOptions& o) {
  if (!o.format.empty()) {
    return "." + o.format;
  }
  if (o.out.empty() || o.out == "-") {
    return ".csv";
  }
  std::string ending = std::filesystem::path{o.out}.extension().string();
  if (!is_written(ending)) {
    throw UsageError{fmt::format("--out {}: its ending is not an output format; allowed: {}, or give --to", o.out,
                                 files::listed(files::written_endings))};
  }
  return ending;
}

std::filesystem::path target_of(const ConvertOptions& o, const std::string& ending) {
  if (!o.out.empty()) {
    return o.out;
  }
  std::filesystem::path name = std::filesystem::path{o.file}.stem();
  if (name.extension() == ".csv") {  // of .csv.gz
    name = name.stem();
  }
  return std::filesystem::path{"out"} / "convert" / (name.string() + ending);
}

files::Converted converted(const std::filesystem::path& file, const std::string& ending) {
  if (files::is_read(file)) {
    return files::converted(file, ending);
  }
  if (file.extension() == ".ftl") {
    (void)text::InputFile{file};  // one that is missing is that first
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: is a flight log; fantail log export writes it as a table", file.string())};
  }
  const files::Loaded loaded = files::load(file, files::Beside::nothing);
  if (loaded.table.rows() == 0) {
    throw text::Error{text::ErrorKind::bad_data, file.string() + ": no row of a table is in it"};
  }
  files::Converted result = files::converted_text(flight::csv_text(loaded.table), file.string(), ending);
  result.notes.insert(result.notes.begin(), loaded.notes.begin(), loaded.notes.end());
  return result;
}

/// No slip of the pen may lose a scenario or a log.
void refuse_to_replace(const std::filesystem::path& target, const std::string& ending) {
  if (target.extension() != ending && std::filesystem::exists(target)) {
    throw text::OutputError{fmt::format("--out {}: this file exists, and its name does not end in {}; choose another",
                                        target.string(), ending)};
  }
}

void convert(const ConvertOptions& o) {
  if (o.install) {
    if (!o.file.empty()) {
      throw UsageError{"--install takes no file"};
    }
    show("{}\n", files::install().string());
    return;
  }
  if (o.file.empty()) {
    throw UsageError{"FILE is missing"};
  }
  const std::string ending = ending_of(o);
  const std::filesystem::path target = target_of(o, ending);
  if (o.out != "-") {
    refuse_to_replace(target, ending);
  }
  const files::Converted converted = tool::converted(o.file, ending);
  give_up_if_interrupted();
  for (const std::string& note : converted.notes) {
    say("fantail: note: " + note + "\n");
  }
  if (o.out == "-") {
    fmt::print("{}", converted.bytes);
    return;
  }
  text::OutputFolder{target.parent_path(), {o.file}}.write(
      std::array{text::NamedFile{target.filename().string(), converted.bytes}});
  fmt::print("{}\n", target.string());
}

std::string objection_to_file(const std::string& text) {
  return text.back() == '/' ? '"' + text + "\" is not the name of a file" : "";
}

void fill(const Verb& verb) {
  auto options = std::make_shared<ConvertOptions>();
  verb.option("FILE", options->file,
              fmt::format("The table to read; by its extension: {} (.gz: CSV packed with gzip), else text",
                          files::listed(files::read_endings)))
      .offers(files);
  verb.option("--to", options->format, "The format to write [extension of --out, else csv]")
      .one_of({"csv", "parquet", "feather", "mat", "xlsx", "mcap", "json"})
      .value_name("csv|parquet|feather|mat|xlsx|mcap|json");
  verb.option("--out", options->out, "The file; - is standard output [out/convert/NAME.ENDING]")
      .offers(files)
      .check(objection_to_file);
  verb.flag("--install", options->install,
            "Install the Python packages that read and write these files, into ~/.local/share/fantail/python");
  verb.examples(
      "Examples:\n"
      "  fantail convert --install                       the packages, once (needs the Debian package python3-venv)\n"
      "  fantail convert session.xlsx                    the first sheet as CSV: out/convert/session.csv\n"
      "  fantail convert flown.mat --out flown.parquet   a file saved by MATLAB, for pandas and DuckDB");
  verb.action([options] { convert(*options); });
}

const VerbCode code{"convert", fill};

}  // namespace
}  // namespace fantail::tool
