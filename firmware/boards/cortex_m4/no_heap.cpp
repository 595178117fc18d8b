// SPDX-License-Identifier: MIT
// A class with a virtual destructor carries a way to delete it, which nothing here ever takes. The library's own would
// bring the heap into the image.
#include <cstddef>

extern "C" void crash_handler();

void operator delete(void* /*place*/) noexcept { crash_handler(); }
void operator delete(void* /*place*/, std::size_t /*size*/) noexcept { crash_handler(); }

/// A virtual function that nobody has implemented was called.
extern "C" void __cxa_pure_virtual() { crash_handler(); }

/// What the standard library calls where it would throw. Its own would bring signals and an exit.
extern "C" void abort() {
  crash_handler();
  for (;;) {
  }
}
