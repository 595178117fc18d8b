// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fantail::files {

/// What other programs are to take a column for.
enum class Kind : std::uint8_t { number, integer, flag, word };

/// One column of a table. All columns of one are equally long.
struct Column {
  std::string name;
  Kind kind = Kind::number;
  /// Not a number: unknown. Of a flag 0 or 1; of a word its place in `words`, counted from 0.
  std::vector<double> values{};
  std::vector<std::string> words{};  ///< those that occur

  friend bool operator==(const Column&, const Column&) = default;
};
using Columns = std::vector<Column>;

/// Files of other programs, by the Python packages that are made for them: python/fantail/files, which runs as a
/// process of its own. It is given a file's bytes and the end of its name, gives back bytes, opens nothing and gets no
/// shell. It stops at 4 GB of memory and at 512 MiB of result. The Python is the one that FANTAIL_PYTHON names, else
/// that of the environment which install() makes, else python3.

/// No Python, or none with a package that is needed; what() says which command installs it.
class NotInstalled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is read and written, by the ends of names. CSV can also be converted from.
inline constexpr std::array<std::string_view, 14> read_endings{".mat",  ".parquet", ".feather", ".xlsx", ".h5",
                                                               ".hdf5", ".gz",      ".mcap",    ".ulg",  ".bin",
                                                               ".bbl",  ".bfl",     ".eeprom",  ".telem"};
inline constexpr std::array<std::string_view, 7> written_endings{".csv",  ".parquet", ".feather", ".mat",
                                                                 ".xlsx", ".mcap",    ".json"};
/// ".mat, .parquet, ...", for messages.
[[nodiscard]] std::string listed(std::span<const std::string_view> endings);

/// Is it one of read_endings, in capitals or not?
[[nodiscard]] bool is_read(const std::filesystem::path& file);

/// The table in a file, as CSV that flight::Table reads.
struct Read {
  using Pairs = std::vector<std::pair<std::string, std::string>>;

  std::string csv;
  Pairs units{};                     ///< what the file says, by the names of columns
  Pairs not_columns{};               ///< a name, and what stands under it instead of a column: "complex numbers"
  std::vector<std::string> notes{};  ///< a sentence each: damage that was read around
};

// These throw NotInstalled; text::Error (bad_data) for a file that is not what its name says, is damaged, or holds no
// table, naming it; text::Error (interrupted) when a signal comes meanwhile; and what text::read_input() does.

[[nodiscard]] Read read(const std::filesystem::path& file);

struct Converted {
  std::string bytes;
  std::vector<std::string> notes{};  ///< as in Read
};
/// A file of one of read_endings as one with one of written_endings.
[[nodiscard]] Converted converted(const std::filesystem::path& file, std::string_view ending);
/// The same of the text of a table as files::load() makes it; messages call it `name`.
[[nodiscard]] Converted converted_text(const std::string& csv, const std::string& name, std::string_view ending);

/// A flight (log_export/handed_over.cpp) as "json", "parquet" or "mcap".
[[nodiscard]] std::string exported(std::string_view flight, std::string_view format);

/// Makes the environment, or makes it anew: $XDG_DATA_HOME/fantail/python, else ~/.local/share/fantail/python. Returns
/// it.
std::filesystem::path install();

}  // namespace fantail::files
