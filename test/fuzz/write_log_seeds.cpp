// SPDX-License-Identifier: MIT
// Writes what the fuzzing of the log reader begins with: write_log_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "fuzz/log_seeds.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    return 64;
  }
  const std::filesystem::path folder{argv[1]};
  std::filesystem::create_directories(folder);
  std::size_t number = 0;
  for (const std::string& seed : fantail::test::log_seeds()) {
    std::ofstream stream{folder / ("seed_" + std::to_string(number)), std::ios::binary};
    stream << seed;
    if (!stream.flush()) {
      std::perror(folder.c_str());
      return 74;
    }
    number += 1;
  }
}
