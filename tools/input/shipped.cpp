// SPDX-License-Identifier: MIT
#include "input/shipped.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "input/messages.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::input {
namespace {

bool looks_like_path(const std::string& text) {
  return text.find('/') != std::string::npos || std::filesystem::path{text}.has_extension();
}

// The names of the files in a folder that end as this kind of file does.
std::vector<std::string> files_in(const std::filesystem::path& folder, std::string_view extension) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator{folder, ignored}) {
    if (entry.path().extension() == extension) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

std::optional<std::string> near_file(const std::filesystem::path& missing, std::string_view extension) {
  const std::filesystem::path folder = missing.has_parent_path() ? missing.parent_path() : ".";
  const auto name = suggestion(missing.filename().string(), files_in(folder, extension));
  return name ? std::optional{(missing.parent_path() / *name).string()} : std::nullopt;
}

[[noreturn]] void refuse_folder(Shipped kind, const std::filesystem::path& folder) {
  const ShippedPlace place = place_of(kind);
  std::string message =
      folder.string() + ": a folder; allowed: a " + std::string{place.noun} + " file or a shipped name";
  if (const std::vector<std::string> names = files_in(folder, place.extension); !names.empty()) {
    message += "; files in it: " + names.front();
    for (std::size_t i = 1; i < names.size(); ++i) {
      message += ", " + names[i];
    }
  }
  // The results of a shipped scenario are in a folder of its name.
  const std::filesystem::path named = folder.has_filename() ? folder : folder.parent_path();
  const std::vector<std::string> shipped = shipped_names(kind);
  if (const auto meant = suggestion(named.filename().string(), shipped)) {
    message += "; did you mean " + *meant + "?";
  }
  throw text::Error{text::ErrorKind::no_such_input, message};
}

// Of a library that was installed without the programs.
std::filesystem::path& folder_of_library() {
  static std::filesystem::path folder;
  return folder;
}

}  // namespace

void set_data_folder(std::filesystem::path folder) { folder_of_library() = std::move(folder); }

std::filesystem::path data_folder() {
  const char* chosen = std::getenv("FANTAIL_DATA");  // NOLINT(concurrency-mt-unsafe): read before any thread exists
  return chosen != nullptr ? std::filesystem::path{chosen} : program_folder();
}

std::filesystem::path program_folder() {
  if (!folder_of_library().empty()) {
    return folder_of_library();
  }
  // Under any prefix, and in a build folder, which has links to the sources there: no program has a path in it.
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  for (auto folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    const auto part = std::filesystem::canonical(folder / "share/fantail/sim", ignored);
    if (!ignored) {
      return part.parent_path();
    }
  }
  return "share/fantail";  // there is nothing; whoever looks for a file there says so
}

std::vector<std::string> shipped_names(Shipped kind) {
  const ShippedPlace place = place_of(kind);
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator{data_folder() / place.folder, ignored}) {
    if (entry.path().extension() == place.extension) {
      names.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

std::string name_of_file(const std::filesystem::path& file) {
  const std::string name = file.stem().string();
  const std::string folder = std::filesystem::absolute(file).parent_path().filename().string();
  return (name == "scenario" || name == "vehicle") && !folder.empty() ? folder : name;
}

std::filesystem::path find_input(Shipped kind, const std::string& name_or_path) {
  const ShippedPlace place = place_of(kind);
  std::filesystem::path shipped = data_folder() / place.folder / (name_or_path + std::string{place.extension});
  std::error_code ignored;
  if (!looks_like_path(name_or_path) && std::filesystem::is_regular_file(shipped, ignored)) {
    return shipped;
  }
  if (std::filesystem::is_regular_file(name_or_path, ignored)) {
    return name_or_path;
  }
  if (std::filesystem::is_directory(name_or_path, ignored)) {
    refuse_folder(kind, name_or_path);
  }
  if (std::filesystem::is_regular_file(name_or_path + std::string{place.extension}, ignored)) {
    return name_or_path + std::string{place.extension};
  }
  if (std::filesystem::exists(name_or_path, ignored)) {
    (void)text::InputFile{name_or_path, text::InputKind::document};  // says what it is
  }
  const std::vector<std::string> names = shipped_names(kind);
  if (looks_like_path(name_or_path)) {
    const auto near = near_file(name_or_path, place.extension);
    throw text::Error{text::ErrorKind::no_such_input,
                      name_or_path + ": no such file" + (near ? "; did you mean " + *near + "?" : "")};
  }
  std::string message = "unknown " + std::string{place.noun} + " \"" + name_or_path + "\"";
  if (const auto meant = suggestion(name_or_path, names)) {
    message += "; did you mean " + *meant + "?";
  }
  message += std::string{message.ends_with('?') ? "" : ";"} + " shipped:";
  for (const std::string& name : names) {
    message += " " + name;
  }
  throw text::Error{text::ErrorKind::no_such_input, message};
}

std::filesystem::path find_named_input(Shipped kind, const Document& document, Section& section, std::string_view key) {
  return find_named_input(kind, document, section, key, section.text(key));
}

std::filesystem::path find_named_input(Shipped kind, const Document& document, const Section& section,
                                       std::string_view key, const std::string& name) {
  std::filesystem::path beside = std::filesystem::path{document.file()}.parent_path() / name;
  std::error_code ignored;
  if (!section.is_replaced(key) && looks_like_path(name) && std::filesystem::is_regular_file(beside, ignored)) {
    return beside;
  }
  try {
    return find_input(kind, name);
  } catch (const text::Error& error) {
    throw text::Error{error.kind(), section.where(key) + ": " + error.what()};
  }
}

}  // namespace fantail::input
