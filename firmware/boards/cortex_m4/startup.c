// SPDX-License-Identifier: MIT
// From the reset to main(). In C, because C++ allows no gaps in a table that is filled by index.
#include <stdint.h>

extern uint32_t stack_top[];
extern uint32_t data_begin[], data_end[], data_in_flash[];
extern uint32_t bss_begin[], bss_end[];
typedef void (*handler)(void);
extern const handler constructors_begin[], constructors_end[];
int main(void);

void reset_handler(void);

// Whatever nobody handles is a crash, and crash_handler says what is done then: centre the canards, leave a record.
void crash_handler(void);

#define MAY_BE_HANDLED(name) \
  __attribute__((weak, naked)) void name(void) { __asm("b crash_handler"); }
MAY_BE_HANDLED(systick_handler)
MAY_BE_HANDLED(can1_tx_handler)
MAY_BE_HANDLED(can1_rx0_handler)
MAY_BE_HANDLED(can1_sce_handler)
MAY_BE_HANDLED(usart1_handler)

// RM0090 table 62: sixteen of the processor's own, then 82 interrupts.
__attribute__((section(".vectors"), used)) static const handler vectors[16 + 82] = {
    [0] = (handler)stack_top,
    [1] = reset_handler,
    [2 ... 14] = crash_handler,
    [15] = systick_handler,
    [16 ... 16 + 18] = crash_handler,
    [16 + 19] = can1_tx_handler,
    [16 + 20] = can1_rx0_handler,
    [16 + 21] = crash_handler,
    [16 + 22] = can1_sce_handler,
    [16 + 23 ... 16 + 36] = crash_handler,
    [16 + 37] = usart1_handler,
    [16 + 38 ... 16 + 81] = crash_handler,
};

void reset_handler(void) {
  // The FPU is off after a reset, and the compiler may use it anywhere: coprocessors 10 and 11, full access.
  *(volatile uint32_t *)0xE000ED88 |= 0xFU << 20;
  __asm volatile("dsb\n isb" ::: "memory");

  const uint32_t *from = data_in_flash;
  for (uint32_t *to = data_begin; to != data_end; ++to) {
    *to = *from++;
  }
  // Eight words a round: word by word this was a third of a start, and canards wait for it. The linker script sees to it
  // that the rounds come out even.
  for (uint64_t *to = (uint64_t *)bss_begin; to != (uint64_t *)bss_end; to += 4) {
    to[0] = 0;
    to[1] = 0;
    to[2] = 0;
    to[3] = 0;
  }
  for (const handler *construct = constructors_begin; construct != constructors_end; ++construct) {
    (*construct)();
  }
  main();
  crash_handler();  // main() never returns
}
