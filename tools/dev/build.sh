# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# Building: one build at a time, with progress. Part of ./dev, which has set $root and runs in that folder.

# Takes the lock of this folder: a node and a bench are often started together. Held until leave_turn, or the end of this script.
take_turn() {
  mkdir -p build 2>/dev/null && (: >>build/lock) 2>/dev/null || cannot_write build
  exec 9>>build/lock
  flock -w 1 9 || { # a shorter wait needs no message
    [ $? -eq 1 ] || refuse "flock does not work here; it keeps two builds apart and is part of the package util-linux"
    echo "dev: waiting for another ./dev in this folder: $(cat build/lock.owner 2>/dev/null || echo "it has just started")" >&2
    flock 9
  }
  (echo "./dev $verb, process $$" >build/lock.owner) 2>/dev/null || cannot_write build
}

leave_turn() {
  rm -f build/lock.owner
  exec 9>&-
}

free_mb() {
  df -Pm . | awk 'NR == 2 { print $4 }'
}

# cannot_write FOLDER: prints why, and exits.
cannot_write() {
  [ "$(free_mb)" -ge 20 ] || out_of_room 900
  echo "dev: this user cannot write into $root/$1 or its contents. If root built it before, run as root:" \
    "chown -R $(id -un) $root/build. Or copy the project into a folder of your own." >&2
  exit 73
}

out_of_room() {
  echo "dev: the disk is full: $(free_mb) MB are free on the disk of build/, and a build takes up to $1 MB." \
    "Free some space and run this command again; what has been built is kept." >&2
  exit 74
}

# build WHAT FOLDER ROOM_MB COMMAND...: runs COMMAND, a build by ninja in FOLDER, and shows the progress of WHAT: on a
# terminal all the time, in a pipe every ten seconds. Silent when there is nothing to build. Errors are printed in full.
build() {
  local what="$1" folder="$2" room_mb="$3" status ticker="" code
  shift 3
  mkdir -p "$folder" 2>/dev/null && (: >"$folder/build.log") 2>/dev/null || cannot_write "$folder"
  status=$folder/progress
  rm -f "$status"
  if [ ! -t 2 ]; then
    # Ends when this script ends, even if it is killed.
    (while sleep 10 && kill -0 "$$" 2>/dev/null; do [ ! -s "$status" ] || cat "$status" >&2; done) 9>&- &
    ticker=$!
  elif [ ! -e "$folder/build.ninja" ]; then
    printf 'building %s: configuring' "$what" >&2
  fi
  [ -e "$folder/build.ninja" ] || echo "building $what: configuring" >"$status"
  # The exit code bypasses the pipe; a missing one is a failure too.
  code=$({ { NINJA_STATUS='[%f %t] ' "$@" 3>&- 9>&- 2>&1 && echo 0 >&3; } | tee "$folder/build.log" 2>/dev/null |
    follow_build "$what" "$status" 9>&-; } 3>&1) || :
  [ -z "$ticker" ] || kill "$ticker" 2>/dev/null
  [ ! -t 2 ] || printf '\r\033[K' >&2
  rm -f "$status"
  [ "$code" != 0 ] || return 0
  # From the first compiler error on; the whole log if no compiler failed.
  sed -n '/^FAILED: /,$p' "$folder/build.log" | grep -v '^\[[0-9]* [0-9]*\] ' >&2 || :
  grep -q '^FAILED: ' "$folder/build.log" || cat "$folder/build.log" >&2
  ! grep -q 'No space left on device' "$folder/build.log" && [ "$(free_mb)" -ge 20 ] || out_of_room "$room_mb"
  # An unreadable source gives "Permission denied" too.
  ! grep -q 'Permission denied' "$folder/build.log" || [ -z "$(find "$folder" ! -writable -print -quit)" ] ||
    cannot_write "$folder"
  echo "dev: building $what failed; see the reasons above, and the whole log in $folder/build.log." \
    "If the sources are not the cause, delete the build and try again: rm -rf $folder" >&2
  exit 70
}

# follow_build WHAT STATUS_FILE: reads the output of ninja and keeps a line with the progress.
follow_build() {
  local begun line count done total spent left text
  begun=$(date +%s)
  while IFS= read -r line; do
    case "$line" in
      "["[0-9]*"] "*)
        count=${line%%]*}
        count=${count#[}
        done=${count% *} total=${count#* }
        # Asking for the time on every line would start a program each time.
        [ "$((done % 4))" -ne 0 ] && [ "$done" -ne "$total" ] && [ -s "$2" ] && continue
        spent=$(($(date +%s) - begun))
        left=""
        # The first few say nothing of the rest: what all others include is compiled before them.
        [ "$spent" -lt 3 ] || [ "$((done * 20))" -lt "$total" ] || left=$((spent * (total - done) / done))
        [ "${left:-0}" -lt 1 ] && left="" || left=", about $left s to go"
        text="building $1: $done of $total ($((100 * done / total)) %)$left"
        (echo "$text" >"$2") 2>/dev/null || : # the build itself reports a full disk
        [ ! -t 2 ] || printf '\r\033[K%s' "$text" >&2
        ;;
    esac
  done
}

# configured FOLDER PRESET [OPTION...]: configures with these options on, if needed. CMake runs again by itself when one of
# its files changes, but not when a preset does.
configured() {
  local build_folder="$1" preset="$2" wanted="" fresh=yes option
  shift 2
  for option in "$@"; do
    wanted="$wanted -D $option=ON"
    grep -q "^$option:BOOL=ON" "$build_folder/CMakeCache.txt" 2>/dev/null || fresh=""
  done
  [ -n "$fresh" ] && was_configured_here "$build_folder" && [ "$build_folder/build.ninja" -nt CMakePresets.json ] && return 0
  # shellcheck disable=SC2086 # a list of words
  configure "$build_folder" "$preset" $wanted
}

# The build folder of a copied or moved project still points to the original, and would build and run that.
was_configured_here() {
  [ -s "$1/build.ninja" ] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt" 2>/dev/null
}

# configure FOLDER PRESET [ARGUMENT...]: discards the cache of another folder, or of a first configuration that failed.
configure() {
  local build_folder="$1" forget="" preset="$2"
  shift 2
  was_configured_here "$build_folder" || forget=--fresh
  # shellcheck disable=SC2086 # one word or nothing
  cmake $forget --preset "$preset" "$@"
}

# host_build WHAT TARGET...: builds programs for this PC, with the options in $host_options.
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

# arm_build WHAT TARGET: builds an image for the board's processor, or all images and the tests that run on it.
arm_build() {
  build "$1" build/arm 200 arm_commands "$2"
}

arm_commands() {
  # Always configured: the tests are left out if the package googletest was missing the last time.
  configure build/arm stm32f405 && cmake --build build/arm --target "$1"
}
