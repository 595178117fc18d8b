// SPDX-License-Identifier: MIT
#include "airframe/openrocket/document.hpp"

#include <array>
#include <memory>
#include <string_view>

#include <fmt/core.h>
#include <zip.h>
#include <zlib.h>

#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::airframe::openrocket {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_data, file.string() + ": " + complaint};
}

[[noreturn]] void refuse_size(const std::filesystem::path& file) {
  refuse(file, fmt::format("its design has more than {} MB unpacked; allowed: at most that", most_bytes >> 20U));
}

/// `read` fills a buffer and returns how much, 0 at the end, below 0 when it failed.
template <typename Read>
std::string all_of(const std::filesystem::path& file, const Read& read) {
  std::string text;
  std::array<char, 65536> buffer{};
  for (;;) {
    const auto count = read(buffer.data(), buffer.size());
    if (count < 0) {
      refuse(file, "cannot be unpacked: it is damaged");
    }
    if (count == 0) {
      return text;
    }
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > most_bytes) {
      refuse_size(file);
    }
  }
}

std::string of_archive(const std::filesystem::path& file) {
  int error = 0;
  const std::unique_ptr<zip_t, decltype(&zip_discard)> archive{zip_open(file.c_str(), ZIP_RDONLY, &error),
                                                               &zip_discard};
  if (!archive) {
    refuse(file, "is a zip archive that cannot be opened: it is damaged");
  }
  const zip_int64_t entries = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < entries; ++i) {
    zip_stat_t entry;
    if (zip_stat_index(archive.get(), static_cast<zip_uint64_t>(i), 0, &entry) != 0 || entry.name == nullptr ||
        !std::string_view{entry.name}.ends_with(".ork")) {
      continue;
    }
    if ((entry.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && entry.encryption_method != ZIP_EM_NONE) {
      refuse(file, fmt::format("its entry {} is encrypted; save it without a password", entry.name));
    }
    if ((entry.valid & ZIP_STAT_SIZE) != 0 && entry.size > most_bytes) {
      refuse_size(file);
    }
    const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> inside{
        zip_fopen_index(archive.get(), static_cast<zip_uint64_t>(i), 0), &zip_fclose};
    if (!inside) {
      refuse(file, fmt::format("its entry {} cannot be unpacked", entry.name));
    }
    return all_of(file, [&](char* buffer, std::size_t size) { return zip_fread(inside.get(), buffer, size); });
  }
  refuse(file, "is a zip archive without a design: none of its entries ends with .ork");
}

/// zlib reads what is not packed as it is.
std::string of_plain_or_gzip(const std::filesystem::path& file) {
  const std::unique_ptr<gzFile_s, decltype(&gzclose)> inside{gzopen(file.c_str(), "rb"), &gzclose};
  if (!inside) {
    throw text::Error{text::ErrorKind::no_such_input, file.string() + ": cannot be opened"};
  }
  std::string text = all_of(
      file, [&](char* buffer, std::size_t size) { return gzread(inside.get(), buffer, static_cast<unsigned>(size)); });
  int state = Z_OK;  // reading alone takes a file that was cut off for one that has ended
  (void)gzerror(inside.get(), &state);
  if (state != Z_OK && state != Z_STREAM_END) {
    refuse(file, "cannot be unpacked: it ends too early");
  }
  return text;
}

}  // namespace

std::string document_text(const std::filesystem::path& file) {
  std::array<char, 2> magic{};
  (void)text::InputFile{file, text::InputKind::document}.read(magic);
  return std::string_view{magic.data(), magic.size()} == "PK" ? of_archive(file) : of_plain_or_gzip(file);
}

}  // namespace fantail::airframe::openrocket
