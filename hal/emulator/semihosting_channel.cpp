// SPDX-License-Identifier: MIT
#include "hal/emulator/semihosting_channel.hpp"

#include <string_view>

#include "hal/emulator/semihosting.hpp"

namespace fantail::hal::emulator {
namespace {

int open(std::string_view path, semihosting::Mode mode) {
  const int handle = semihosting::open(path.data(), path.size(), mode);
  if (handle < 0) {
    semihosting::say("no world at descriptors 3 and 4: this image is started by `fantail fly --on emulator`\n");
    semihosting::exit(false);
  }
  return handle;
}

}  // namespace

SemihostingChannel::SemihostingChannel()
    : in_{open("/dev/fd/3", semihosting::Mode::read)}, out_{open("/dev/fd/4", semihosting::Mode::write)} {}

std::size_t SemihostingChannel::read(std::span<std::byte> out) {
  const std::size_t count = semihosting::read(in_, out);
  if (count == 0) {
    semihosting::exit(true);
  }
  return count;
}

void SemihostingChannel::write(std::span<const std::byte> bytes) {
  if (!semihosting::write(out_, bytes)) {
    semihosting::exit(false);
  }
}

}  // namespace fantail::hal::emulator
