#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: flash_board.sh PROJECT
# tools/flash_board with programs in the place of the real ones, which nobody could test without a probe. Those for USB
# and for the ST-LINK have a board behind them, with a flash and option bytes in files, and misbehave as told.
set -eu
tool=$1/tools/flash_board
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
for ending in elf bin hex; do echo "an image as $ending" >"$work/image.$ending"; done

# program NAME TEXT CODE: prints TEXT, notes its arguments, ends with CODE.
program() {
  printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\necho "%s"\nexit %s\n' "$1" "$work" "$2" "$3" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

# expect CODE WORDS ARGUMENT...: exit code, and words in what it says or calls; $answers is typed.
answers=
expect() {
  code=$1 words=$2
  shift 2
  : >"$work/calls"
  actual=0
  printf '%s' "$answers" | PATH="$work/bin:$PATH" "$tool" "$@" >"$work/said" 2>&1 || actual=$?
  cat "$work/calls" >>"$work/said"
  if [ "$actual" -ne "$code" ] || ! grep -qF -- "$words" "$work/said"; then
    echo "flash_board $*: exit code $actual, expected $code and '$words' in:" >&2
    cat "$work/said" >&2
    exit 1
  fi
}
refuse_words() {
  ! grep -qF -- "$1" "$work/said" || {
    echo "flash_board said '$1':" >&2
    cat "$work/said" >&2
    exit 1
  }
}

# ---- nothing there, and what it calls ----

program st-info "Found 0 stlink programmers" 0
program dfu-util "nothing" 0
program openocd "" 0
program st-flash "" 0
program stm32flash "" 0
expect 74 "no ST-LINK found" "$work/image"
expect 74 "nothing was written" "$work/image"
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
expect 0 "the option bytes could not be read" "$work/image"
expect 0 "st-flash --reset write $work/image.bin 0x08000000" "$work/image" --probe st-flash
expect 0 "stm32flash -w $work/image.hex -v -g 0x08000000 /dev/null" "$work/image" --probe serial --port /dev/null

program openocd "" 1
expect 74 "may be incomplete" "$work/image"
refuse_words "nothing was written"
program openocd "" 0
program stm32flash "" 1
expect 74 "boot loader did not answer" "$work/image" --probe serial --port /dev/null

# ---- USB ----

cat >"$work/bin/dfu-util" <<'END'
#!/bin/sh
board=$(dirname "$0")/../board
echo "dfu-util $*" >>"$board/../calls"
is() { [ -e "$board/$1" ]; }
alternate=0 address='' upload='' download=''
while [ $# -gt 0 ]; do
  case "$1" in
    -l) is gone || echo 'Found DFU: [0483:df11] ver=2200, alt=0, name="@Internal Flash  /0x08000000/04*016Kg"'; exit 0 ;;
    -a) alternate=$2 && shift ;;
    -s) address=$2 && shift ;;
    -U) upload=$2 && shift ;;
    -D) download=$2 && shift ;;
    -d) shift ;;
  esac
  shift
done
is gone && exit 74
memory=$board/flash
[ "$alternate" = 0 ] || memory=$board/options
if [ -n "$upload" ]; then
  [ ! -e "$upload" ] || exit 73 # it does not write over a file
  size=${address#*:} && size=${size%%:*}
  is "unreadable_$alternate" && exit 74
  is "short_$alternate" && size=$((size - 1))
  head -c "$size" "$memory" >"$upload"
else
  is "unwritable_$alternate" && exit 74
  if is "wrong_$alternate"; then
    { printf 'X' && tail -c +2 "$download"; } >"$memory"
  else
    cp "$download" "$memory"
  fi
  # To load them it resets itself; without BOOT0 the firmware runs then.
  [ "$alternate" = 0 ] || ! is leaves_when_written || : >"$board/gone"
  [ "$alternate" = 0 ] || ! is ends_in_an_error || exit 74
fi
exit 0
END
chmod +x "$work/bin/dfu-util"

# board LEVEL FAULT...: as it comes from the factory but for the first byte, in octal, and its complement.
board() {
  rm -rf "$work/board" && mkdir "$work/board"
  : >"$work/board/flash"
  printf "\\$1\\252\\$2\\125" >"$work/board/options"
  printf '\377\377\377\377\377\177\000\200\377\377\377\377' >>"$work/board/options"
  shift 2
  for fault in "$@"; do : >"$work/board/$fault"; done
}
options() { od -An -v -tx1 "$work/board/options" | tr -d ' \n'; }
unset_level="357 020" # ef, ~ef
set_level="343 034"   # e3, ~e3
usb() { expect "$1" "$2" "$work/image" --probe dfu; }

# shellcheck disable=SC2086
{
  board $set_level
  usb 0 "written, read back and compared"
  refuse_words "Set level 3"
  cmp "$work/image.bin" "$work/board/flash"

  board $set_level unwritable_0
  usb 74 "may be incomplete"
  board $set_level unreadable_0
  usb 74 "could not be read back"
  board $set_level short_0
  usb 74 "could not be read back"
  board $set_level wrong_0
  usb 65 "the board does not hold what was written"
  refuse_words "read back and compared"

  # The level is not set. Nobody is there, somebody says no, somebody says something else.
  for answers in '' 'n
' 'Yes, but
'; do
    board $unset_level
    before=$(options)
    usb 0 "be armed"
    [ "$(options)" = "$before" ] || { echo "option bytes were written without a yes" >&2 && exit 1; }
  done

  answers='yes
'
  board $unset_level
  before=$(options)
  usb 0 "brown-out level 3 is set, read back and compared"
  # Nothing but the two bits, and their complements.
  [ "$(options)" = "e3aa1c55${before#efaa1055}" ] || { echo "option bytes: $(options)" >&2 && exit 1; }
  board $unset_level ends_in_an_error
  usb 0 "brown-out level 3 is set, read back and compared"
  board $unset_level wrong_1
  usb 65 "instead of e3 aa 1c 55"
  board $unset_level short_1
  usb 0 "could not be read"
  board $unset_level unreadable_1
  usb 0 "could not be read"
  board $unset_level unwritable_1
  usb 65 "instead of e3 aa 1c 55"
  board $unset_level leaves_when_written
  usb 74 "written and not read back"
  answers='yes
yes
'
  board $unset_level leaves_when_written
  usb 74 "could not be read back" # it is said to be back, and is not

  # Read-protected, and what is no option byte at all: left alone, whatever is answered.
  board $unset_level && printf '\357\125' >"$work/two" && tail -c +3 "$work/board/options" >>"$work/two"
  mv "$work/two" "$work/board/options"
  before=$(options)
  usb 0 "left alone"
  [ "$(options)" = "$before" ]
  head -c 16 /dev/zero | tr '\000' '\377' >"$work/board/options"
  usb 0 "left alone"
}

# ---- ST-LINK ----

cat >"$work/bin/st-flash" <<'END'
#!/bin/sh
board=$(dirname "$0")/../board
echo "st-flash $*" >>"$board/../calls"
case "$*" in
  "--area=option read")
    [ ! -e "$board/unreadable" ] || exit 1
    echo "st-flash 1.7.0"
    cat "$board/optcr"
    [ ! -e "$board/unreadable_later" ] || : >"$board/unreadable"
    ;;
  "--area=option write "*)
    [ ! -e "$board/unwritable" ] || exit 1
    [ -e "$board/forgets" ] || printf '%08x\n' $(($3 | 1)) >"$board/optcr" # locked again
    ;;
esac
exit 0
END
linked() {
  rm -rf "$work/board" && mkdir "$work/board"
  echo "$1" >"$work/board/optcr"
  shift
  for fault in "$@"; do : >"$work/board/$fault"; done
}
for probe in stlink st-flash; do
  stlink() { expect "$1" "$2" "$work/image" --probe "$probe"; }
  answers='yes
'
  linked 0fffaae1
  stlink 0 "verified and started"
  refuse_words "--area=option write"
  linked 0fffaaed # as it comes from the factory
  stlink 0 "st-flash --area=option write 0x0fffaae0"
  stlink 0 "verified and started"
  [ "$(cat "$work/board/optcr")" = 0fffaae1 ]
  linked 0fffaaed forgets
  stlink 65 "0fffaaec instead of 0fffaae0"
  linked 0fffaaed unwritable
  stlink 74 "could not write the option bytes"
  linked 0fffaaed unreadable
  stlink 0 "could not be read"
  linked 0fffaaed unreadable_later
  stlink 74 "could not be read back"
  linked 0fff55ed # read-protected
  stlink 0 "left alone"
  linked nonsense
  stlink 0 "could not be read"
  for answers in '' 'no
'; do
    linked 0fffaaed
    stlink 0 "be armed"
    refuse_words "--area=option write"
  done
done
