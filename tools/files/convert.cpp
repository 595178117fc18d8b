// SPDX-License-Identifier: MIT
#include "files/convert.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "input/shipped.hpp"
#include "json/value.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/quoting.hpp"

namespace fantail::files {
namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error{errno, std::generic_category(), what}; }

/// A file that is nowhere but in memory.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view content = {}) : number_{::memfd_create("fantail", MFD_CLOEXEC)} {
    if (number_ < 0) {
      fail("memory for a file");
    }
    while (!content.empty()) {
      const ssize_t written = ::write(number_, content.data(), content.size());
      if (written <= 0) {
        ::close(number_);
        fail("memory for a file");
      }
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    ::lseek(number_, 0, SEEK_SET);
  }
  ~MemoryFile() { ::close(number_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] int number() const { return number_; }

  [[nodiscard]] std::string content() const {
    std::string all(static_cast<std::size_t>(::lseek(number_, 0, SEEK_END)), '\0');
    std::size_t at = 0;
    while (at < all.size()) {
      const ssize_t read = ::pread(number_, all.data() + at, all.size() - at, static_cast<off_t>(at));
      if (read <= 0) {
        fail("memory for a file");
      }
      at += static_cast<std::size_t>(read);
    }
    return all;
  }

 private:
  int number_;
};

/// A program that runs, and ends with this object at the latest.
class Child {
 public:
  Child(std::vector<std::string> words, const MemoryFile& in, const MemoryFile& out, const MemoryFile* errors) {
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, in.number(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, out.number(), STDOUT_FILENO);
    if (errors != nullptr) {
      ::posix_spawn_file_actions_adddup2(&files, errors->number(), STDERR_FILENO);
    }
    std::vector<char*> arguments;
    std::ranges::transform(words, std::back_inserter(arguments), [](std::string& word) { return word.data(); });
    arguments.push_back(nullptr);
    start_error_ = ::posix_spawnp(&process_, arguments[0], &files, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
  }
  ~Child() {
    if (start_error_ == 0 && !ended_) {
      ::kill(process_, SIGKILL);
      (void)status();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  [[nodiscard]] int start_error() const { return start_error_; }

  /// Waits for its end, or throws when a signal comes: poll() is never continued behind one.
  void wait() const {
    const auto end = static_cast<int>(::syscall(SYS_pidfd_open, process_, 0));
    if (end < 0) {
      return;
    }
    pollfd look{.fd = end, .events = POLLIN, .revents = 0};
    const bool interrupted = ::poll(&look, 1, -1) < 0 && errno == EINTR;
    ::close(end);
    if (interrupted) {
      throw text::Error{text::ErrorKind::interrupted, "interrupted; nothing was written"};
    }
  }

  /// Of its end, as a shell has it: more than 128 for a signal.
  int status() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  pid_t process_ = 0;
  int start_error_ = 0;
  bool ended_ = false;
};

// NOLINTNEXTLINE(concurrency-mt-unsafe): nobody changes the environment
std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return value == nullptr ? std::string_view{} : value;
}

/// Empty where there is no home.
std::filesystem::path own_environment() {
  const std::filesystem::path data{environment("XDG_DATA_HOME")};
  const std::filesystem::path home{environment("HOME")};
  if (data.is_absolute()) {
    return data / "fantail/python";
  }
  return home.is_absolute() ? home / ".local/share/fantail/python" : "";
}

std::string python() {
  if (const std::string_view named = environment("FANTAIL_PYTHON"); !named.empty()) {
    return std::string{named};
  }
  const std::filesystem::path own = own_environment() / "bin/python";
  return ::access(own.c_str(), X_OK) == 0 ? own.string() : "python3";
}

std::filesystem::path module_folder() {
  const std::filesystem::path folder = input::program_folder();
  const std::filesystem::path with_data = folder / "python/fantail/files";
  std::error_code ignored;
  return std::filesystem::exists(with_data, ignored) ? with_data : folder.parent_path() / "files";  // of a wheel
}

std::string install_command() {
  const std::string_view named = environment("FANTAIL_PYTHON");
  return named.empty() ? "fantail convert --install"
                       : fmt::format("{} -m pip install -r {}", text::shell_word(std::string{named}),
                                     text::shell_word((module_folder() / "requirements.txt").string()));
}

constexpr int bad_data = 65;
constexpr int not_installed = 69;

[[noreturn]] void refuse(const std::string& what, int status, const std::string& said) {
  if (status == not_installed) {
    throw NotInstalled{fmt::format("{}: Python lacks {}, which this kind of file needs; this command installs it: {}",
                                   what, said, install_command())};
  }
  if (status > 128 && said.empty()) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: its reader ended with signal {}; the file may be damaged", what, status - 128)};
  }
  const std::string last = said.substr(said.rfind('\n') + 1);
  throw text::Error{text::ErrorKind::bad_data,
                    status == bad_data ? fmt::format("{}: {}", what, last)
                                       : fmt::format("{}: Python could not read or write it: {}", what, last)};
}

// `what` is the file or the option that messages begin with.
std::string run(const std::string& what, const std::vector<std::string>& request, std::string_view input,
                std::string* notes = nullptr) {
  std::vector<std::string> words{python(), "-B", (module_folder() / "__main__.py").string()};
  words.insert(words.end(), request.begin(), request.end());
  const MemoryFile in{input};
  const MemoryFile out;
  const MemoryFile errors;
  Child child{words, in, out, &errors};
  if (child.start_error() != 0) {
    throw NotInstalled{fmt::format("{}: this kind of file needs Python, and {} cannot be started ({}); {}", what,
                                   words[0], std::strerror(child.start_error()),
                                   environment("FANTAIL_PYTHON").empty()
                                       ? "install the Debian package python3-venv, then: fantail convert --install"
                                       : "FANTAIL_PYTHON names it")};
  }
  child.wait();
  const int status = child.status();
  std::string said = errors.content();
  said.erase(said.find_last_not_of("\n ") + 1);
  if (status != 0) {
    refuse(what, status, said);
  }
  if (notes != nullptr) {
    *notes = std::move(said);
  }
  return out.content();
}

Read::Pairs pairs(const json::Value& object) {
  Read::Pairs all;
  for (const json::Member& member : object.members()) {
    all.emplace_back(member.key, member.value.text());
  }
  return all;
}

}  // namespace

std::string listed(std::span<const std::string_view> endings) { return fmt::format("{}", fmt::join(endings, ", ")); }

bool is_read(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::find(read_endings, ending) != read_endings.end();
}

Read read(const std::filesystem::path& file) {
  std::string answer = run(file.string(), {"read", file.extension().string()}, text::read_input(file));
  const std::size_t end = std::min(answer.find('\n'), answer.size());
  const json::Value head = json::parse(answer.substr(0, end));
  answer.erase(0, end + 1);
  Read result{.csv = std::move(answer), .units = pairs(head["units"]), .not_columns = pairs(head["not_columns"])};
  for (const json::Value& note : head["notes"]) {
    result.notes.push_back(note.text());
  }
  return result;
}

namespace {

Converted run_converted(const std::string& name, const std::string& from, std::string_view to, std::string_view bytes) {
  Converted result;
  std::string said;
  result.bytes = run(name, {"convert", from, std::string{to}}, bytes, &said);
  while (!said.empty()) {
    const std::size_t end = std::min(said.find('\n'), said.size());
    result.notes.push_back(said.substr(0, end));
    said.erase(0, end + 1);
  }
  return result;
}

}  // namespace

Converted converted(const std::filesystem::path& file, std::string_view ending) {
  return run_converted(file.string(), file.extension().string(), ending, text::read_input(file));
}

Converted converted_text(const std::string& csv, const std::string& name, std::string_view ending) {
  return ending == ".csv" ? Converted{.bytes = csv} : run_converted(name, ".csv", ending, csv);
}

std::string exported(std::string_view flight, std::string_view format) {
  return run(fmt::format("--to {}", format), {"export", std::string{format}}, flight);
}

std::filesystem::path install() {
  const std::filesystem::path folder = own_environment();
  if (folder.empty()) {
    throw text::Error{text::ErrorKind::usage, "--install: HOME is not set, so there is no folder for the packages"};
  }
  if (!environment("FANTAIL_PYTHON").empty()) {
    throw text::Error{
        text::ErrorKind::usage,
        fmt::format("--install: FANTAIL_PYTHON names another Python; this command installs the packages there: {}",
                    install_command())};
  }
  const MemoryFile none;
  Child child{
      {"python3", "-B", (module_folder() / "__main__.py").string(), "install", folder.string()}, none, none, nullptr};
  if (child.start_error() != 0) {
    throw NotInstalled{"--install: python3 cannot be started; install the Debian package python3-venv, then try again"};
  }
  child.wait();
  if (const int status = child.status(); status != 0) {
    throw NotInstalled{fmt::format(
        "--install: {} could not be created; see the message above. python3-venv may be missing", folder.string())};
  }
  return folder;
}

}  // namespace fantail::files
