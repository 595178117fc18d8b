// SPDX-License-Identifier: MIT
// From the reset to the C library's own start, which gets its memory and its output from the emulator.
#include <stdint.h>
#include <sys/stat.h>

extern uint32_t __stack[];
void _start(void);

static void reset_handler(void) {
  *(volatile uint32_t *)0xE000ED88 |= 0xFU << 20;  // the FPU
  __asm volatile("dsb\n isb" ::: "memory");
  _start();
}

// An exit through the emulator, with an error: a fault must not look like a test that takes long.
static void fault_handler(void) {
  static const uint32_t reason[2] = {0x20026, 70};  // ADP_Stopped_ApplicationExit
  register uint32_t operation __asm("r0") = 0x20;   // SYS_EXIT_EXTENDED
  register const uint32_t *block __asm("r1") = reason;
  __asm volatile("bkpt 0xab" : : "r"(operation), "r"(block) : "memory");
  for (;;) {
  }
}

__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {
    [0] = (void (*)(void))__stack, [1] = reset_handler, [2 ... 15] = fault_handler};

// googletest would make folders for its reports.
int mkdir(const char *path, mode_t mode) {
  (void)path;
  (void)mode;
  return -1;
}
