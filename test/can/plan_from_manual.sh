#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: plan_from_manual.sh FANTAIL
# A plan block that is made from the manual alone is, byte for byte, the one that the program makes.
set -eu
fantail=$1
project=$(cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
: >"$scratch/defaults.toml"
for plan in "$project/test/can/every_field.toml" "$scratch/defaults.toml"; do
  "$project/test/with_python.sh" "$project/test/can/plan_client.py" "$project/docs" \
    "$project/firmware/protocol/canard_bus.dbc" "$plan" --write "$scratch/manual.ftpl"
  "$fantail" plan compile "$plan" --out "$scratch/program.ftpl"
  cmp "$scratch/manual.ftpl" "$scratch/program.ftpl"
done
