// SPDX-License-Identifier: MIT
// Loaded into linux.uml with LD_PRELOAD. User-mode Linux before 6.14 holds 2696 bytes of floating-point registers per
// process. On a processor with AMX the host's set is longer, the host takes it back only whole ("ptrace set fp regs
// failed, errno = 14"), and the guest dies in its first process. This fills the set up to the host's length.
//
// Plain system calls and nothing else: the guest's processes start on a stack of one page, on which neither the
// dynamic linker's lazy binding nor a second frame of that size has room.
#include <elf.h>
#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>

static unsigned char whole_set[65536] __attribute__((aligned(64)));

enum { states_at = 512 };               // where the XSAVE header says which states the set holds
static const uint64_t short_states = 0x2FF;  // x87 to PKRU: all that lies in the first 2696 bytes

static long plain_ptrace(long request, long pid, void* address, void* data) {
  long result;
  register void* fourth __asm__("r10") = data;
  __asm__ volatile("syscall"
                   : "=a"(result)
                   : "a"((long)SYS_ptrace), "D"(request), "S"(pid), "d"(address), "r"(fourth)
                   : "rcx", "r11", "memory");
  return result;
}

long ptrace(enum __ptrace_request request, ...) {
  static size_t whole_size;
  va_list rest;
  va_start(rest, request);
  const pid_t pid = va_arg(rest, pid_t);
  void* const address = va_arg(rest, void*);
  void* data = va_arg(rest, void*);
  va_end(rest);

  long peeked = 0;
  struct iovec set = {whole_set, sizeof whole_set};
  if (request == PTRACE_PEEKTEXT || request == PTRACE_PEEKDATA || request == PTRACE_PEEKUSER) {
    data = &peeked;
  } else if (request == PTRACE_SETREGSET && (uintptr_t)address == NT_X86_XSTATE) {
    const struct iovec* const given = data;
    if (whole_size == 0 && plain_ptrace(PTRACE_GETREGSET, pid, address, &set) == 0) {
      whole_size = set.iov_len;
    }
    if (given->iov_len < whole_size) {
      uint64_t states;
      memset(whole_set, 0, whole_size);
      memcpy(whole_set, given->iov_base, given->iov_len);
      memcpy(&states, whole_set + states_at, sizeof states);
      states &= short_states;
      memcpy(whole_set + states_at, &states, sizeof states);
      set.iov_len = whole_size;
      data = &set;
    }
  }
  const long result = plain_ptrace(request, pid, address, data);
  if (result < 0) {
    errno = (int)-result;
    return -1;
  }
  return data == &peeked ? peeked : result;
}
