#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: in_two_halves.sh PROGRAM COMMAND...
# Runs COMMAND PROGRAM twice at the same time, each with one half of the program's tests: they mostly wait, for what has a
# pace of its own. Exit code of the half that failed, or else of the one that was skipped.
set -eu
program=$1
shift
half() {
  "$@" env GTEST_TOTAL_SHARDS=2 "GTEST_SHARD_INDEX=$index" "$program"
}
index=0
half "$@" &
first=$!
index=1
second=0
half "$@" || second=$?
code=0
wait "$first" || code=$?
[ "$second" -eq 0 ] || [ "$second" -eq 77 ] || exit "$second"
[ "$code" -ne 0 ] || code=$second
exit "$code"
