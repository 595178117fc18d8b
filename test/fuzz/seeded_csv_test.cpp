// SPDX-License-Identifier: MIT
// The fuzzer's target without the fuzzer: its corpus, and mutations of it from a seed.
#include <filesystem>
#include <fstream>

#include "seed.hpp"
#include "system/folder.hpp"
#include "test.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fantail::test {
namespace {

void run_target(const std::string& input) {
  (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::vector<std::string> corpus() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator{FANTAIL_CSV_CORPUS}) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);  // the same mutations on every machine
  std::vector<std::string> inputs;
  std::ranges::for_each(files, [&](const auto& file) { inputs.push_back(content(file)); });
  return inputs;
}

// The words between the quotes of a dictionary, escapes left as they are: they are odd text, too.
std::vector<std::string> words() {
  std::ifstream stream{FANTAIL_CSV_WORDS};
  std::vector<std::string> list{"\n", std::string{'\0'}};
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('"')) {
      list.push_back(line.substr(1, line.size() - 2));
    }
  }
  return list;
}

class Mutation {
 public:
  explicit Mutation(std::uint32_t seed) : random_{seed} {}

  std::string of(const std::vector<std::string>& inputs, const std::vector<std::string>& words) {
    std::string text = inputs[below(inputs.size())];
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
      const std::size_t at = below(text.size() + 1);
      const std::size_t length = below(std::min<std::size_t>(text.size() - at, 40) + 1);
      const std::string& other = inputs[below(inputs.size())];
      switch (below(6)) {
        case 0: text.insert(at, words[below(words.size())]); break;
        case 1: text.erase(at, length); break;
        case 2: text.insert(below(text.size() + 1), text.substr(at, length)); break;
        case 3: text.replace(at, length, other.substr(below(other.size() + 1), 40)); break;
        case 4: text.insert(at, 1, static_cast<char>(below(256))); break;
        default:
          if (at < text.size()) {
            text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
          }
      }
    }
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }
  std::mt19937 random_;  // NOLINT(cert-msc32-c,cert-msc51-cpp): the seed is the point
};

TEST(CsvReader, HoldsItsPromisesOnTheCorpus) {
  const auto inputs = corpus();
  ASSERT_GE(inputs.size(), 10U);
  std::ranges::for_each(inputs, run_target);
}

TEST(CsvReader, HoldsItsPromisesOnMutationsOfTheCorpus) {
  const auto inputs = corpus();
  const auto dictionary = words();
  Mutation mutation{seed(20'261'121)};
  for (int i = 0; i < 20'000; ++i) {
    run_target(mutation.of(inputs, dictionary));
  }
}

}  // namespace
}  // namespace fantail::test
