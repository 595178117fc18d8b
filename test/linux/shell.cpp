// SPDX-License-Identifier: MIT
#include "linux/shell.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "hal/linux/can_interface.hpp"

namespace fantail::test {
bool is_heard(const std::string& interface) {
  // The kernel's list of those who listen to everything on an interface; a CanBus has filters and is in another list.
  std::ifstream list{"/proc/net/can/rcvlist_all"};
  const std::string text{std::istreambuf_iterator<char>{list}, {}};
  return text.find("  " + interface) != std::string::npos;
}

void must(const std::string& command) {
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error{"failed: " + command};
  }
}

Background::Background(const std::string& command) : pipe_{popen(("timeout 10 " + command).c_str(), "r")} {}

Background::~Background() {
  if (pipe_ != nullptr) {
    pclose(pipe_);
  }
}

std::string Background::output() {
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe_)) {
    text.append(part.data(), count);
  }
  pclose(pipe_);
  pipe_ = nullptr;
  return text;
}

Background::Background(const std::string& command, const std::string& interface) : Background{command} {
  if (!eventually([&] { return is_heard(interface); })) {
    throw std::runtime_error{"does not listen to " + interface + ": " + command};
  }
}

Background candump(const std::string& interface, int frames) {
  return Background{"sh -c \"candump -L -n " + std::to_string(frames) + " " + interface + " | sed 's/^([^)]*) //'\"",
                    interface};
}

bool eventually(const std::function<bool()>& question, std::chrono::milliseconds longest) {
  const auto end = std::chrono::steady_clock::now() + longest;
  while (!question()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
  return true;
}

std::optional<hal::CanFrame> next_frame(hal::on_linux::CanBus& bus) {
  std::optional<hal::CanFrame> frame;
  (void)eventually([&] {
    bus.wait(std::chrono::milliseconds{100});
    frame = bus.receive();
    return frame.has_value();
  });
  return frame;
}

void restore_virtual_buses() {
  for (const std::string name : {"vcan0", "vcan1"}) {
    // Asked first: in the guest a program takes its time to start.
    const auto found = hal::on_linux::find_interface(name);
    if (!found) {
      must("ip link add " + name + " mtu 72 type vcan");
    }
    if (!found || !found->up) {
      must("ip link set " + name + " up");
    }
  }
}

}  // namespace fantail::test
