#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: octave_test.sh SOURCE PROGRAM
# A simulated flight as a MAT-file: docs/octave/roll_model.m finds in it what `fantail identify` finds, and identify finds in the
# file, also as Octave saves it again, what it finds in the flight log.
set -eu
source=$1 program=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$program" fly tasha3_launch2 --out flight >/dev/null
"$program" log export flight --to mat --out flight.mat >/dev/null
cat >fit.m <<'SCRIPT'
addpath(fullfile(getenv('SOURCE'), 'docs', 'octave'));
m = roll_model('flight.mat', [0.9 8], 0.00393, 5.0265e-5);
file = fopen('octave.txt', 'w');
fprintf(file, '%.6f\n', m.alpha_m2, m.beta_m, m.disturbance_deg, m.rate_error_deg_s);
fclose(file);
flight = load('flight.mat').flight;
words = load('flight.mat').words;
save('-v7', 'again_v7.mat', 'flight', 'words');
save('-v6', 'again_v6.mat', 'flight', 'words');
SCRIPT
# The packages of the tests declare no Octave: what it reads is not to be counted.
LD_PRELOAD='' SOURCE=$source octave-cli --no-init-file fit.m

for log in flight/flight.ftl flight.mat again_v7.mat again_v6.mat; do
  "$program" identify "$log" --window 0.9:8 --vehicle tasha3_launch2 --json --out "identified/$(basename "$log")" \
    >"$(basename "$log").json"
done
/usr/bin/python3 - <<'SCRIPT'
import json

names = ["flight.ftl", "flight.mat", "again_v7.mat", "again_v6.mat"]
log, *tables = [json.load(open(name + ".json")) for name in names]
for table in tables:
    assert table["samples"] == log["samples"], (table["data"], table["samples"], log["samples"])
    for key in ("alpha_m2", "beta_m"):
        assert abs(table[key] / log[key] - 1.0) < 1e-6, (key, table["data"], table[key], log[key])
alpha, beta, first, last, _ = [float(line) for line in open("octave.txt")]
# The scenario's own truth, and identify's answer: the rate and the angle of one flight tell the same within a percent.
for found, wanted, reach in ((alpha, 23.0, 0.23), (alpha, log["alpha_m2"], 0.23), (beta, 9.0, 0.09),
                             (beta, log["beta_m"], 0.09), (first, log["disturbance_deg"][0], 0.02),
                             (last, log["disturbance_deg"][1], 0.02)):
    assert abs(found - wanted) < reach, (found, wanted, reach)
SCRIPT
