#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: run_on_target.sh PROGRAM.elf [--gtest_filter=...]
# Runs a test program on an emulated Cortex-M4; its exit code is the program's. 77: not possible here.
set -eu
command -v qemu-system-arm >/dev/null || { echo "qemu-system-arm is not installed"; exit 77; }
[ -e "$1" ] || { echo "$1 has not been built: cmake --preset emulator && cmake --build --preset emulator"; exit 77; }
exec timeout 100 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none \
  -semihosting-config "enable=on,target=native,arg=program${2:+,arg=$2}" -kernel "$1" </dev/null
