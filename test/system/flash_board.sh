#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: flash_board.sh PROJECT
# tools/flash_board with programs in the place of the real ones, which nobody could test without a probe.
set -eu
tool=$1/tools/flash_board
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
for ending in elf bin hex; do echo "$ending" >"$work/image.$ending"; done

# program NAME TEXT CODE: prints TEXT, notes its arguments, ends with CODE.
program() {
  printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\necho "%s"\nexit %s\n' "$1" "$work" "$2" "$3" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

# expect CODE WORDS ARGUMENT...: exit code, and words in what it says or calls.
expect() {
  code=$1 words=$2
  shift 2
  : >"$work/calls"
  actual=0
  PATH="$work/bin:$PATH" "$tool" "$@" >"$work/said" 2>&1 || actual=$?
  cat "$work/calls" >>"$work/said"
  if [ "$actual" -ne "$code" ] || ! grep -qF -- "$words" "$work/said"; then
    echo "flash_board $*: exit code $actual, expected $code and '$words' in:" >&2
    cat "$work/said" >&2
    exit 1
  fi
}

program st-info "Found 0 stlink programmers" 0
program dfu-util "nothing" 0
program openocd "" 0
program st-flash "" 0
program stm32flash "" 0
expect 74 "no ST-LINK found" "$work/image"
expect 74 "no ST-LINK found" "$work/image" --probe st-flash
expect 74 "no board in DFU mode" "$work/image" --probe dfu
expect 74 "no serial port $work/none" "$work/image" --probe serial --port "$work/none"
# What is not a device is no serial port either.
expect 74 "no serial port $work/image.elf" "$work/image" --probe serial --port "$work/image.elf"
expect 66 "$work/missing.elf: no such file" "$work/missing"
expect 64 "Usage" "$work/image" --probe telepathy
expect 64 "Usage" "$work/image" --probe

program st-info "Found 1 stlink programmers" 0
expect 0 "openocd -f interface/stlink.cfg -f target/stm32f4x.cfg -c program {$work/image.elf} verify reset exit" "$work/image"
expect 0 "st-flash --reset write $work/image.bin 0x08000000" "$work/image" --probe st-flash
program dfu-util "Found DFU: [0483:df11] ver=2200" 0
expect 0 "dfu-util -a 0 -d 0483:df11 -s 0x08000000:leave -D $work/image.bin" "$work/image" --probe dfu
expect 0 "stm32flash -w $work/image.hex -v -g 0x08000000 /dev/null" "$work/image" --probe serial --port /dev/null

program openocd "" 1
expect 74 "nothing was written" "$work/image"
program stm32flash "" 1
expect 74 "boot loader did not answer" "$work/image" --probe serial --port /dev/null
