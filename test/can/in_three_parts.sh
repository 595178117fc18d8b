#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: in_three_parts.sh PROGRAM FILTER COMMAND...
# Runs COMMAND PROGRAM three times at once, each with a third of the program's tests that FILTER names: they mostly wait,
# for what has a pace of its own. Exit code of a part that failed, or else of one that was skipped.
set -eu
program=$1
filter=$2
shift 2
part() {
  "$@" env GTEST_TOTAL_SHARDS=3 "GTEST_SHARD_INDEX=$index" "$program" "--gtest_filter=$filter"
}
parts=
for index in 0 1 2; do
  part "$@" &
  parts="$parts $!"
done
code=0
for part in $parts; do
  result=0
  wait "$part" || result=$?
  case $result in
    0) ;;
    77) [ "$code" -ne 0 ] || code=77 ;;
    *) code=$result ;;
  esac
done
exit "$code"
