#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: same_bytes.sh SOURCE_FOLDER WORK_FOLDER BUILD_FOLDER [--without-optimisation]
# Compiles what flies and its world once more, optimised by clang and, if asked for, by g++ without optimisation, links it with
# the rest of the normal build's fly_alone (`fantail fly` and nothing else), flies every shipped scenario with each, and
# compares the bytes with what the normal one writes. Exit code 77 (skipped) without clang.
set -eu
source_folder="$1"
work="$2"
normal_build="$3"
normal="$normal_build/test/system/fly_alone"
optimising_clang="${FANTAIL_CLANG:-clang++-19}"
if ! command -v "$optimising_clang" >/dev/null; then
  echo "SKIPPED: $optimising_clang is not installed, so nobody knows whether clang gives the same bytes" >&2
  exit 77
fi

# How the normal build links fly_alone: words, of which some are archives of firmware, hal and sim.
link=$(ninja -C "$normal_build" -t commands fly_alone | tail -n 1)
archives=$(echo "$link" | tr ' ' '\n' | grep -E '^(firmware|hal|sim)/.*\.a$' | sort -u)
[ "$(echo "$archives" | wc -l)" -ge 5 ] || {
  echo "FAILED: no archives of what flies in: $link" >&2
  exit 1
}

build() { # NAME COMPILER FLAGS
  if ! {
    # shellcheck disable=SC2086 # a list of words
    cmake -S "$source_folder" -B "$work/$1" -G Ninja -D CMAKE_CXX_COMPILER="$2" -D CMAKE_CXX_FLAGS="$3" \
      -D CMAKE_BUILD_TYPE= && cmake --build "$work/$1" --target $archives &&
      (cd "$normal_build" && eval "$(echo "$link" | sed -E "s# (firmware|hal|sim)/# $work/$1/\\1/#g; s# -o [^ ]+# -o $work/$1/fly_alone#")")
  } >"$work/$1.log" 2>&1; then
    cat "$work/$1.log" >&2
    exit 1
  fi
}

fly() { # NAME FLY_ALONE
  for scenario in "$source_folder"/sim/scenarios/*.toml; do
    name="$(basename "$scenario" .toml)"
    # A quarter of an hour each, of what tunnel_swirl_with does, too. Without optimisation that one, ten minutes of a rocket
    # that rolls freely, would take a third of the time of this test.
    case "$1,$name" in *,tunnel_flow | *,tunnel_swirl_without | gcc-O0,tunnel_swirl_with) continue ;; esac
    "$2" "$scenario" "$work/flights/$1/$name"
    # Every model that the shipped scenarios leave alone, with one rocket each that flies at once and late, and with a bench.
    case "$name" in tasha3_launch2 | kestrel_euroc | bench_healthy) ;; *) continue ;; esac
    "$2" "$scenario" "$work/flights/$1/$name-isa" environment.density=isa launch_guide.tilt_deg=7 \
      imu.misalignment_deg=1 accelerometer.delay_s=0.004 excitation.form=sweep excitation.amplitude_variation_deg=1
    case "$name" in bench*) continue ;; esac # without an airframe
    "$2" "$scenario" "$work/flights/$1/$name-six_dof" flight.motion=six_dof launch_guide.tilt_deg=4 \
      launch_guide.azimuth_deg=110 wind.speed_m_s=6 wind.exponent=0.14 wind.turbulence=0.15 wind.gust_m_s=3 \
      imu.position_m=0.3 imu.across_m=0.01 vibration.specific_force_m_s2=10 recovery.drag_area_m2=0.5 \
      barometer.fitted=yes environment.air_temperature_c=-5
  done
}

mkdir -p "$work"
rm -rf "$work/flights"
others="clang-O2"
build clang-O2 "$optimising_clang" -O2
[ "${4:-}" != --without-optimisation ] || {
  others="$others gcc-O0"
  build gcc-O0 g++ -O0
}
fly normal "$normal"
for other in $others; do
  fly "$other" "$work/$other/fly_alone"
done

# The C library chooses faster routines on processors with fused multiply-add; the bytes must not follow.
GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA_Usable,-AVX2_Usable
export GLIBC_TUNABLES
fly older-processor "$normal"

compared=0
different=0
for build in $others older-processor; do
  for flight in "$work/flights/$build"/*; do
    for file in "$work/flights/normal/$(basename "$flight")"/*; do
      compared=$((compared + 1))
      cmp "$file" "$flight/$(basename "$file")" || different=$((different + 1))
    done
  done
done
echo "$compared files compared, $different different"
[ "$compared" -gt 0 ] && [ "$different" -eq 0 ]
