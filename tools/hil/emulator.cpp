// SPDX-License-Identifier: MIT
#include "hil/emulator.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <system_error>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "text/error.hpp"

namespace fantail::hil {
namespace {

// Where the image looks for its world (hal/emulator/semihosting_channel.cpp).
constexpr int target_reads = 3;
constexpr int target_writes = 4;

// Only the machine with the STM32F405, and nothing else that a person might have configured.
std::vector<std::string> command(const EmulatorOptions& options) {
  if (options.diary) {
    return {options.program, "--serve", options.image.string(), options.diary->string()};
  }
  return {options.program,
          "-nodefaults",
          "-no-user-config",
          "-display",
          "none",
          "-M",
          "netduinoplus2",
          "-icount",
          options.icount,
          "-semihosting-config",
          "enable=on,target=native",
          "-kernel",
          options.image.string()};
}

// After fork(): nothing but system calls.
[[noreturn]] void become(const std::vector<char*>& arguments, pid_t parent, int in, int out, int complaints,
                         int failure) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) {
    ::_exit(1);
  }
  ::setpgid(0, 0);  // the keyboard's interrupt is for this program, which then ends the emulator in order
  // Upwards first, so that none of them is where another is to go.
  const int null = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (null < 0) {
    ::_exit(1);
  }
  for (int* each : {&in, &out, &complaints, &failure}) {
    *each = ::fcntl(*each, F_DUPFD_CLOEXEC, 10);
  }
  for (const int each : {in, out}) {  // the emulator waits in its calls
    ::fcntl(each, F_SETFL, ::fcntl(each, F_GETFL) & ~O_NONBLOCK);
  }
  ::dup2(null, STDIN_FILENO);
  ::dup2(complaints, STDOUT_FILENO);
  ::dup2(complaints, STDERR_FILENO);
  ::dup2(in, target_reads);
  ::dup2(out, target_writes);
  ::execvp(arguments[0], arguments.data());
  const int error = errno;
  (void)!::write(failure, &error, sizeof error);
  ::_exit(1);
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("it was killed by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  }
  return fmt::format("its exit code was {}", WEXITSTATUS(status));
}

}  // namespace

OneProcessor::OneProcessor() : thread_{::gettid()} {
  const int here = ::sched_getcpu();
  if (here < 0 || ::sched_getaffinity(thread_, sizeof before_, &before_) != 0) {
    return;  // it is only about speed
  }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(here), &one);
  bound_ = ::sched_setaffinity(thread_, sizeof one, &one) == 0;
}

OneProcessor::~OneProcessor() {
  if (bound_) {
    (void)::sched_setaffinity(thread_, sizeof before_, &before_);
  }
}

Emulator::Emulator(const EmulatorOptions& options) : options_{options} {
  if (!std::filesystem::is_regular_file(options.image)) {
    throw text::Error{
        text::ErrorKind::no_such_input,
        fmt::format("{}: no such file. In the sources, ./dev fly --on {} builds {}. Another one is given with --image",
                    options.image.string(), options.diary ? "board" : "emulator",
                    options.diary ? "build/arm/fantail-stm32f405.elf" : "build/arm/fantail-emulator.elf")};
  }
  auto [target_in, to_target] = make_pipe();
  auto [from_target, target_out] = make_pipe();
  auto [complaints, complain] = make_pipe();
  auto [failed, fail] = make_pipe();
  std::vector<std::string> words = command(options);
  std::vector<char*> arguments;
  std::ranges::transform(words, std::back_inserter(arguments), [](std::string& word) { return word.data(); });
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) {
    become(arguments, parent, target_in.number(), target_out.number(), complain.number(), fail.number());
  }
  if (process_ < 0) {
    throw std::system_error{errno, std::generic_category(), "fork"};
  }
  fail.close();
  int error = 0;
  const auto told = failed.read(std::as_writable_bytes(std::span{&error, 1}), std::chrono::milliseconds{10'000});
  if (told.value_or(0) == sizeof error) {
    ::waitpid(process_, nullptr, 0);
    process_ = -1;
    throw TargetError{fmt::format("{} could not be started ({}); it {}", options.program, std::strerror(error),
                                  options.diary ? "is built, and never installed, where the Debian package "
                                                  "libunicorn-dev is"
                                                : "comes with the Debian package qemu-system-arm")};
  }
  to_target_ = std::move(to_target);
  from_target_ = std::move(from_target);
  complaints_ = std::move(complaints);
}

Emulator::~Emulator() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
}

void Emulator::end() {
  to_target_.close();
  int status = 0;
  for (int i = 0; i < 1'000; ++i) {
    if (::waitpid(process_, &status, WNOHANG) == process_) {
      process_ = -1;
      if (status != 0) {
        fail(status);
      }
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  throw TargetError{"the virtual board does not end after its flight"};
}

void Emulator::write(std::span<const std::byte> bytes) {
  if (!to_target_.write(bytes)) {
    ended();
  }
}

std::size_t Emulator::read(std::span<std::byte> out, std::chrono::milliseconds at_most) {
  const auto count = from_target_.read(out, at_most);
  if (!count) {
    ended();
  }
  return *count;
}

void Emulator::ended() {
  int status = 0;
  // It has closed its end, so it is about to end.
  for (int i = 0; i < 100 && ::waitpid(process_, &status, WNOHANG) == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  process_ = -1;
  fail(status);
}

void Emulator::fail(int status) const {
  std::array<std::byte, 2048> text{};
  const auto size = complaints_.read(text, std::chrono::milliseconds{100}).value_or(0);
  std::string said{reinterpret_cast<const char*>(text.data()), size};
  while (!said.empty() && said.back() == '\n') {
    said.pop_back();
  }
  if (options_.diary && WIFEXITED(status) && (WEXITSTATUS(status) == 65 || WEXITSTATUS(status) == 66)) {
    throw text::Error{WEXITSTATUS(status) == 65 ? text::ErrorKind::bad_data : text::ErrorKind::no_such_input, said};
  }
  throw TargetError{fmt::format("the emulated flight computer ended before the flight did: {}{}{}",
                                how_it_ended(status), said.empty() ? "" : "; it printed: ", said)};
}

std::filesystem::path built_image(const std::string& name) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path().parent_path() / "arm" / name;  // of build/host/libexec/fantail-fly
}

}  // namespace fantail::hil
