# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# Building, flashing and debugging the image for the board, and the virtual board that runs it. Part of ./dev.

firmware() {
  [ $# -eq 0 ] || usage
  take_turn
  # shellcheck disable=SC2086
  need $firmware_packages
  arm_build "the flight image" fantail-stm32f405
  python3 firmware/boards/image_report.py build/arm/fantail-stm32f405.elf
  printf '\n  image   %s\n  map     %s\n' "build/arm/fantail-stm32f405.elf, .hex, .bin" "build/arm/fantail-stm32f405.map"
}

# The tests hold the virtual board: it is made of their devices.
board_build() {
  # shellcheck disable=SC2086
  need $board_packages
  arm_build "the image for the virtual board" fantail-stm32f405
  host_options=FANTAIL_TESTS
  # A build that was configured without Unicorn knows nothing of it.
  grep -qs libexec/fantail-board build/host/build.ninja || rm -f build/host/build.ninja
  host_build "the virtual board" fantail-board "$@"
}

# board_check: what a change of the firmware may break and only the flashed image shows.
board_check() {
  local image=build/arm/fantail-stm32f405.elf
  take_turn
  board_build board_sweep board_flips
  leave_turn
  begin_checks board
  checked "the flashed image through every kind of reset, at 16 instants each" build/host/test/board/board_sweep "$image" 16
  checked "the flashed image with 500 bits flipped" build/host/test/board/board_flips "$image" 500
  end_checks "Virtual board" "./dev board --check"
}

flash() {
  take_turn
  # shellcheck disable=SC2086
  need $firmware_packages $flash_packages
  arm_build "the flight image" fantail-stm32f405
  leave_turn
  exec tools/flash_board build/arm/fantail-stm32f405 "$@"
}

debug() {
  [ $# -eq 0 ] || usage
  take_turn
  # shellcheck disable=SC2086
  need $firmware_packages $flash_packages gdb-multiarch
  arm_build "the flight image" fantail-stm32f405
  leave_turn
  st-info --probe 2>/dev/null | grep -qE '^Found [1-9]' || {
    echo "dev: no ST-LINK found: plug it in, and see docs/flashing.md" >&2
    exit 74
  }
  exec gdb-multiarch build/arm/fantail-stm32f405.elf \
    -ex "target extended-remote | openocd -f interface/stlink.cfg -f target/stm32f4x.cfg -c 'gdb_port pipe; log_output build/arm/openocd.log'" \
    -ex "monitor reset halt"
}
