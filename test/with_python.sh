#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the Python of the environment that ./dev test makes (cantools, python-can, lcm, those of fantail convert, pandas, pytest, Dask): with_python.sh ARGUMENT...
# Exits 77 (skipped) without one.
set -eu
python="$(dirname -- "$(readlink -f -- "$0")")/../build/test-venv/bin/python"
[ -x "$python" ] || {
  echo "SKIPPED: no Python packages in build/test-venv; run ./dev test with a network once" >&2
  exit 77
}
exec "$python" "$@"
