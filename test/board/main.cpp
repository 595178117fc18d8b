// SPDX-License-Identifier: MIT
// fantail-board, the program of the verb `board`. And `fantail fly --on board` starts it: a virtual board at the end of
// two pipes.
//
//   fantail-board --serve IMAGE FOLDER    IMAGE: fantail-stm32f405.elf; FOLDER: for what was measured at its pins
//
// The world's questions come on descriptor 3 and the answers go to 4, as for an image in QEMU. It ends when nobody asks
// any more.
#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>

#include <unistd.h>

#include "board_server.hpp"
#include "fantail/run.hpp"
#include "text/error.hpp"
#include "write_diary.hpp"

namespace {

using namespace fantail;

struct NobodyAsks {};

class Pipes final : public hal::emulator::Channel {
 public:
  [[nodiscard]] std::size_t read(std::span<std::byte> out) override {
    for (;;) {
      const ssize_t count = ::read(3, out.data(), out.size());
      if (count > 0) {
        return static_cast<std::size_t>(count);
      }
      if (count == 0) {
        throw NobodyAsks{};
      }
      if (errno != EINTR) {
        throw std::system_error{errno, std::generic_category(), "reading the world's question"};
      }
    }
  }
  void write(std::span<const std::byte> bytes) override {
    while (!bytes.empty()) {
      const ssize_t count = ::write(4, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) {
        throw std::system_error{errno, std::generic_category(), "answering the world"};
      }
      bytes = bytes.subspan(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
  }
};

int serve(const std::string& file, const std::string& folder) {
  const board::Image image{file};
  Pipes pipes;
  board::BoardServer server{image, {}, pipes};
  try {
    for (;;) {
      server.serve();
    }
  } catch (const NobodyAsks&) {
  }
  board::write_diary(server, folder);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 || std::string{argv[1]} != "--serve") {
    return fantail::tool::run(*fantail::tool::VerbCode::first, argc, argv);
  }
  try {
    return serve(argv[2], argv[3]);
  } catch (const text::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.kind() == text::ErrorKind::no_such_input ? 66 : 65;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fantail-board: %s\n", error.what());
    return 70;
  }
}
