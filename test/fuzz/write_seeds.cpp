// SPDX-License-Identifier: MIT
// write_seeds FOLDER: what a target begins from, as files for libFuzzer.
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "target.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    return 64;
  }
  const std::filesystem::path folder{argv[1]};
  std::filesystem::create_directories(folder);
  const auto list = fantail::fuzz::seeds();
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::ofstream file{folder / std::to_string(i), std::ios::binary};
    file.write(list[i].data(), static_cast<std::streamsize>(list[i].size()));
    if (!file.flush()) {
      return 74;
    }
  }
}
