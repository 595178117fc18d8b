# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# Building, one at a time and not in silence. Part of ./dev, which has set $root and stands in it.

# One build a folder: a node and a bench are often started together. Held until leave_turn, or the end of this script.
take_turn() {
  mkdir -p build || exit 73
  exec 9>>build/lock
  flock -w 1 9 || { # a person who waits for less need not know
    echo "dev: waiting for another ./dev in this folder: $(cat build/lock.owner 2>/dev/null || echo "it has just begun")" >&2
    flock 9
  }
  echo "./dev $verb, process $$" >build/lock.owner || out_of_room
}

leave_turn() {
  rm -f build/lock.owner
  exec 9>&-
}

out_of_room() {
  echo "dev: the disk is full: $(df -Pm build | awk 'NR == 2 { print $4 }') MB are free where build/ is, and a build takes up to $1 MB." \
    "Make room, then this command again; what has been built stays." >&2
  exit 74
}

# build WHAT FOLDER ROOM_MB COMMAND...: runs COMMAND, a build by ninja in FOLDER, and says how far WHAT is: on a terminal
# all the time, in a pipe every ten seconds. Silent when there is nothing to build. What failed is printed whole.
build() {
  local what="$1" folder="$2" room_mb="$3" status ticker begun count done total spent left text
  shift 3
  mkdir -p "$folder" || out_of_room "$room_mb"
  status=$folder/progress
  rm -f "$status" "$folder/failed"
  ticker=""
  if [ ! -t 2 ]; then
    (while sleep 10 >/dev/null 2>&1; do [ ! -s "$status" ] || cat "$status" >&2; done) 9>&- &
    ticker=$!
  elif [ ! -e "$folder/build.ninja" ]; then
    printf 'building %s: looking at this machine' "$what" >&2
  fi
  begun=$(date +%s)
  { NINJA_STATUS='[%f %t] ' "$@" 9>&- 2>&1 || : >"$folder/failed"; } | tee "$folder/build.log" | while IFS= read -r line; do
    case "$line" in
      "["[0-9]*"] "*)
        count=${line%%]*}
        count=${count#[}
        done=${count% *} total=${count#* }
        # Asking for the clock in every line of ninja's would start a program each.
        [ "$((done % 4))" -ne 0 ] && [ "$done" -ne "$total" ] && [ -s "$status" ] && continue
        spent=$(($(date +%s) - begun))
        left=""
        [ "$spent" -lt 3 ] || [ "$done" -eq 0 ] || left=$((spent * (total - done) / done))
        [ "${left:-0}" -lt 1 ] && left="" || left=", about $left s to go"
        text="building $what: $done of $total ($((100 * done / total)) %)$left"
        echo "$text" >"$status"
        [ ! -t 2 ] || printf '\r\033[K%s' "$text" >&2
        ;;
    esac
  done
  [ -z "$ticker" ] || kill "$ticker" 2>/dev/null
  [ ! -t 2 ] || printf '\r\033[K' >&2
  rm -f "$status"
  [ -e "$folder/failed" ] || return 0
  # From the first failure on; all of it when it is not the compiler that failed.
  sed -n '/^FAILED: /,$p' "$folder/build.log" | grep -v '^\[[0-9]* [0-9]*\] ' >&2 || :
  grep -q '^FAILED: ' "$folder/build.log" || cat "$folder/build.log" >&2
  ! grep -q 'No space left on device' "$folder/build.log" || out_of_room "$room_mb"
  echo "dev: $what could not be built; the reasons stand above, all of the build in $folder/build.log" >&2
  exit 70
}

# configured FOLDER PRESET [OPTION...]: with these options on. CMake runs again by itself when one of its files changes,
# but not when a preset does.
configured() {
  local build_folder="$1" preset="$2" wanted="" fresh=yes option
  shift 2
  for option in "$@"; do
    wanted="$wanted -D $option=ON"
    grep -q "^$option:BOOL=ON" "$build_folder/CMakeCache.txt" 2>/dev/null || fresh=""
  done
  [ -n "$fresh" ] && [ "$build_folder/build.ninja" -nt CMakePresets.json ] && return 0
  # shellcheck disable=SC2086 # a list of words
  cmake --preset "$preset" $wanted
}

# host_build WHAT TARGET...: of the programs for this PC, with the options that $host_options names.
host_options=""
host_build() {
  local what="$1"
  shift
  # shellcheck disable=SC2086
  build "$what" build/host 900 host_commands "$@"
}

host_commands() {
  # shellcheck disable=SC2086 # a list of words
  configured build/host host $host_options && cmake --build --preset host --target "$@"
}

# arm_build WHAT TARGET: an image for the processor, or all of them with the tests that run there.
arm_build() {
  build "$1" build/arm 200 arm_commands "$2"
}

arm_commands() {
  # Always, because the tests are left out where the package googletest was missing the last time.
  cmake --preset stm32f405 && cmake --build build/arm --target "$1"
}
