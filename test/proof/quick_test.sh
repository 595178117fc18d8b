#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: quick_test.sh PROVER BUILD_FOLDER; exit code 77 where the prover is not installed
[ -x "$1" ] || {
  echo "SKIPPED: $1 is not there; ./dev test --all installs it"
  exit 77
}
exec /usr/bin/python3 -B "$(dirname "$0")/prove.py" "$1" "$2" --quick
