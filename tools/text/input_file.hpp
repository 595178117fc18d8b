// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace fantail::text {

// The one way to the content of a file that somebody names: no more of it is read than stands here, a device and a
// folder are refused, and whoever waits for a pipe can be interrupted.

/// What is to be read, and so how much of it at most.
enum class InputKind : std::uint8_t {
  data,      ///< a log, a table, results: 512 MiB, from a pipe too
  document,  ///< what a person writes, and may be read twice: 16 MiB, and no pipe
};
[[nodiscard]] constexpr std::size_t most_bytes(InputKind kind) {
  return std::size_t{kind == InputKind::data ? 512U : 16U} << 20U;
}

/// `check` is called before each portion of a pipe, and ten times a second while that gives nothing; it may throw.
/// `tell` is given a sentence, once, about a pipe out of which nothing has come for five seconds.
void check_while_reading(void (*check)(), void (*tell)(const std::string& sentence) = nullptr);

/// A file or a pipe that is read from its beginning to its end.
class InputFile {
 public:
  /// Throws Error (no_such_input) for one that is missing, a folder, a device, or a pipe where none is allowed;
  /// std::system_error for one that cannot be opened.
  explicit InputFile(const std::filesystem::path& path, InputKind kind = InputKind::data);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// How many bytes have come; 0 at the end only. Throws std::system_error, and what the check throws.
  [[nodiscard]] std::size_t read(std::span<char> to);
  /// Of a file, at this moment; 0 of a pipe.
  [[nodiscard]] std::size_t size() const;

 private:
  [[nodiscard]] bool has_come();

  std::filesystem::path path_;
  int file_;
  bool is_pipe_ = false;
  int silent_looks_ = 0;  ///< before the first byte
};

/// All that stands in a file. Throws as InputFile does, and Error (bad_data) for one with more than so many bytes and
/// for one that grows or shrinks meanwhile.
[[nodiscard]] std::string read_input(const std::filesystem::path& path, InputKind kind, std::size_t most);
[[nodiscard]] inline std::string read_input(const std::filesystem::path& path, InputKind kind = InputKind::data) {
  return read_input(path, kind, most_bytes(kind));
}

/// The same, empty where there is no such file.
[[nodiscard]] std::optional<std::string> read_if_there(const std::filesystem::path& path, InputKind kind,
                                                       std::size_t most);
[[nodiscard]] inline std::optional<std::string> read_if_there(const std::filesystem::path& path,
                                                              InputKind kind = InputKind::data) {
  return read_if_there(path, kind, most_bytes(kind));
}

/// The same in memory that was not filled with zeros first, which takes a third of the time of a large log.
struct InputBytes {
  std::unique_ptr<std::byte[]> bytes;  // NOLINT(modernize-avoid-c-arrays)
  std::size_t size = 0;
};
[[nodiscard]] InputBytes read_input_bytes(const std::filesystem::path& path);

}  // namespace fantail::text
