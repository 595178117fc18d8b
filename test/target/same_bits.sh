#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: same_bits.sh HOST_PROGRAM PROGRAM.elf
# What the flight law computes on this PC and on an emulated Cortex-M4, to the last bit. 77: not possible here.
set -eu
on_target=$("$(dirname "$0")/run_on_target.sh" "$2") || { code=$?; echo "$on_target"; exit "$code"; }
on_host=$("$1")
echo "here:      $on_host"
echo "Cortex-M4: $on_target"
[ -n "$on_host" ] && [ "$on_host" = "$on_target" ]
