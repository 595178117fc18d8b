// SPDX-License-Identifier: MIT
// Takes the place of the main function of a test program while mutants are on trial (docs/evidence.md):
//   PROGRAM list                 the names of its tests
//   PROGRAM run TESTS            runs the tests in the file TESTS, a line "SECONDS NAME" each, in that order, until one
//   fails PROGRAM trace TESTS HITS     the same; HITS takes what each has reached: "NAME" and the places in the program
// It prints "OUTCOME NAME CPU_SECONDS" of each, then "end". Outcomes: passed; failed; timeout, more than SECONDS of the
// processor, or a minute and thirty times as much by the wall clock; nothing, it did not run or was skipped; broken, it
// could not be started. Each test has a process of its own, so that none sees what another has left.
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern "C" const std::uint8_t __executable_start;
extern "C" const std::uint8_t etext;

namespace {

constexpr int passed = 100;  // no exit code that a test would end with by mistake

std::size_t text_size() { return static_cast<std::size_t>(&etext - &__executable_start); }

// One byte for each byte of the program, also for the processes that a test starts.
std::uint8_t* reached() {
  static std::uint8_t* const map = [] {
    void* memory = mmap(nullptr, text_size(), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
      std::abort();
    }
    return static_cast<std::uint8_t*>(memory);
  }();
  return map;
}

struct Ended {
  const char* outcome;
  double cpu_s;
};

Ended run(const std::string& name, unsigned seconds) {
  const pid_t child = fork();
  if (child < 0) {
    std::perror("fork");
    std::exit(70);
  }
  if (child == 0) {
    const rlimit limit{.rlim_cur = seconds, .rlim_max = seconds + 1};
    const int out = open("test.out", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (setrlimit(RLIMIT_CPU, &limit) != 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0) {
      std::exit(70);
    }
    alarm(60 + 30 * seconds);  // by the wall clock, for what only waits
    testing::GTEST_FLAG(filter) = name;
    const int failed = RUN_ALL_TESTS();
    const auto& all = *testing::UnitTest::GetInstance();
    std::exit(failed != 0 ? 1 : all.successful_test_count() == 1 && all.skipped_test_count() == 0 ? passed : 77);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child) {
    std::perror("wait4");
    std::exit(70);
  }
  const auto of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  const double cpu_s = of(usage.ru_utime) + of(usage.ru_stime);
  if (WIFSIGNALED(status)) {
    const bool late =
        WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGALRM || (WTERMSIG(status) == SIGKILL && cpu_s >= seconds);
    return {late ? "timeout" : "failed", cpu_s};
  }
  const int code = WEXITSTATUS(status);
  return {code == passed ? "passed" : code == 77 ? "nothing" : code == 70 ? "broken" : "failed", cpu_s};
}

int run_all(std::ifstream tests, std::ofstream* hits) {
  const std::vector<std::uint8_t> before(reached(), reached() + (hits ? text_size() : 0));  // by what ran before main
  unsigned seconds = 0;
  std::string name;
  bool all_passed = true;
  while (all_passed && tests >> seconds >> name) {
    std::copy(before.begin(), before.end(), reached());
    const Ended ended = run(name, seconds);
    std::cout << ended.outcome << ' ' << name << ' ' << ended.cpu_s << std::endl;
    all_passed = std::strcmp(ended.outcome, "passed") == 0;
    if (hits) {
      *hits << name;
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (reached()[i] != 0) {
          *hits << ' ' << i;
        }
      }
      *hits << '\n';
    }
  }
  std::cout << "end" << std::endl;
  return all_passed ? 0 : 1;
}

}  // namespace

extern "C" void __sanitizer_cov_trace_pc() {
  const auto* const at = static_cast<const std::uint8_t*>(__builtin_return_address(0));
  reached()[at - &__executable_start] = 1;
}

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  testing::InitGoogleTest(&argc, argv);
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "list") {
    const auto& all = *testing::UnitTest::GetInstance();
    for (int s = 0; s < all.total_test_suite_count(); ++s) {
      const auto& suite = *all.GetTestSuite(s);
      for (int t = 0; t < suite.total_test_count(); ++t) {
        std::cout << suite.name() << '.' << suite.GetTestInfo(t)->name() << '\n';
      }
    }
    return 0;
  }
  if (what == "run" && argc == 3) {
    return run_all(std::ifstream(argv[2]), nullptr);
  }
  if (what == "trace" && argc == 4) {
    std::ofstream hits(argv[3]);
    return run_all(std::ifstream(argv[2]), &hits);
  }
  std::cerr << "usage: list | run TESTS | trace TESTS HITS\n";
  return 64;
}
