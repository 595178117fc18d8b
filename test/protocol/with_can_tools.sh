#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the Python of the environment that ./dev test makes (cantools, python-can): with_can_tools.sh ARGUMENT...
# Exits 77 (skipped) without one.
set -eu
python="$(dirname -- "$(readlink -f -- "$0")")/../../build/can-venv/bin/python"
[ -x "$python" ] || {
  echo "SKIPPED: no cantools in build/can-venv; run ./dev test with a network once" >&2
  exit 77
}
exec "$python" "$@"
