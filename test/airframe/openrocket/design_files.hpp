// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>
#include <zip.h>
#include <zlib.h>

#include "airframe/openrocket/read.hpp"
#include "text/error.hpp"

namespace fantail::airframe::openrocket {

/// Design files in a folder that goes with them.
class DesignFiles : public testing::Test {
 protected:
  DesignFiles() : folder_{std::filesystem::temp_directory_path() / ("fantail_ork_" + std::to_string(::getpid()))} {
    std::filesystem::create_directories(folder_);
  }
  ~DesignFiles() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path plain(const std::string& xml) const {
    std::ofstream{path("plain.ork"), std::ios::binary} << xml;
    return path("plain.ork");
  }

  std::filesystem::path gzipped(const std::string& xml) const {
    gzFile file = gzopen(path("packed.ork").c_str(), "wb");
    gzwrite(file, xml.data(), static_cast<unsigned>(xml.size()));
    gzclose(file);
    return path("packed.ork");
  }

  std::filesystem::path zipped(const std::string& xml, const char* entry = "rocket.ork",
                               const char* password = nullptr) const {
    std::filesystem::remove(path("archive.ork"));
    zip_t* archive = zip_open(path("archive.ork").c_str(), ZIP_CREATE, nullptr);
    const zip_int64_t at =
        zip_file_add(archive, entry, zip_source_buffer(archive, xml.data(), xml.size(), 0), ZIP_FL_ENC_UTF_8);
    if (password != nullptr) {
      zip_file_set_encryption(archive, static_cast<zip_uint64_t>(at), ZIP_EM_AES_256, password);
    }
    if (zip_close(archive) != 0) {
      throw std::runtime_error{"no archive"};
    }
    return path("archive.ork");
  }

  /// What is said of a file that is refused, its folder left out.
  std::string refusal(const std::filesystem::path& file) const {
    try {
      (void)read_design(file);
    } catch (const text::Error& error) {
      std::string said = error.what();
      const std::string folder = folder_.string() + "/";
      for (std::size_t at = said.find(folder); at != std::string::npos; at = said.find(folder)) {
        said.erase(at, folder.size());
      }
      return said;
    }
    return "not refused";
  }

 private:
  std::filesystem::path folder_;
};

/// A design around these components of its only stage.
inline std::string design(const std::string& components, const std::string& version = "1.10") {
  return "<?xml version='1.0' encoding='utf-8'?>\n<openrocket version=\"" + version +
         "\" creator=\"a test\"><rocket><name>Test &amp; Co</name><subcomponents><stage><name>Sustainer</name>"
         "<subcomponents>" +
         components + "</subcomponents></stage></subcomponents></rocket></openrocket>";
}

}  // namespace fantail::airframe::openrocket
