// SPDX-License-Identifier: MIT
#include "can/program.hpp"

#include <csignal>
#include <stdexcept>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "linux/shell.hpp"

namespace fantail::test {

Program::Program(const std::string& program, const std::vector<std::string>& arguments) {
  const std::string input = folder_ / "in";
  if (mkfifo(input.c_str(), 0600) != 0) {
    throw std::runtime_error{"no pipe: " + input};
  }
  keyboard_ = open(input.c_str(), O_RDWR | O_CLOEXEC);  // for writing alone it would wait for the reader
  const auto prepare = [input, show = redirect(STDOUT_FILENO, out_)] {
    const int reading = open(input.c_str(), O_RDONLY);
    dup2(reading, STDIN_FILENO);
    close(reading);
    show();
    std::signal(SIGINT, SIG_DFL);
  };
  runner_ = std::thread{[this, program, arguments, prepare] {
    Outcome outcome =
        run(program, arguments, {.prepare = prepare, .meanwhile = [this](int process) { await_its_end(process); }});
    outcome.out = said();
    outcome_ = std::move(outcome);
  }};
  std::unique_lock lock{mutex_};
  begun_.wait(lock, [this] { return started_; });
}

Program::~Program() {
  signal(SIGKILL);
  if (runner_.joinable()) {
    runner_.join();
  }
  close_input();
}

// It is not reaped here, so until the mutex is taken its number belongs to nobody else.
void Program::await_its_end(int process) {
  {
    const std::lock_guard lock{mutex_};
    process_ = process;
    started_ = true;
  }
  begun_.notify_all();
  siginfo_t ignored{};
  while (waitid(P_PID, static_cast<id_t>(process), &ignored, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
  const std::lock_guard lock{mutex_};
  process_ = 0;
}

void Program::type(const std::string& line) const {
  const std::string text = line + "\n";
  if (write(keyboard_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    throw std::runtime_error{"nobody takes what is typed"};
  }
}

void Program::close_input() {
  if (keyboard_ >= 0) {
    close(keyboard_);
    keyboard_ = -1;
  }
}

void Program::signal(int number) {
  const std::lock_guard lock{mutex_};
  if (process_ != 0) {
    kill(process_, number);
  }
}

bool Program::ended() {
  const std::lock_guard lock{mutex_};
  return process_ == 0;
}

bool Program::says(const std::string& text, std::chrono::milliseconds longest) const {
  return eventually([&] { return said().find(text) != std::string::npos; }, longest);
}

const Outcome& Program::outcome() {
  if (runner_.joinable()) {
    runner_.join();
  }
  return outcome_;
}

}  // namespace fantail::test
