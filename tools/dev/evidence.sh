# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# What carries the safety case: from hazard to evidence, the gates of every change, and their page of figures. Part of ./dev.

# trace: writes docs/trace.md, and measures the complexity of the firmware.
trace() {
  [ $# -eq 0 ] || usage
  take_turn
  python_of test/safety build/safety-venv
  leave_turn
  /usr/bin/python3 tools/dev/trace.py .
  mkdir -p build/figures
  build/safety-venv/bin/python test/safety/complexity.py . --json build/figures/complexity.json
}

# gates: each in a shell of its own, so that one that fails does not keep the others from being measured.
gates() {
  [ $# -eq 0 ] || usage
  local failed="" begun gate
  begun=$(date +%s)
  for gate in repository "package --lint" "board --check" docs trace "prove --resume" coverage "mutate --sample 300"; do
    # shellcheck disable=SC2086 # a list of words
    ./dev $gate || {
      echo "dev: gates: ./dev $gate ended with $?" >&2
      failed=yes
    }
  done
  /usr/bin/python3 tools/dev/figures.py docs/figures/gates.md "Gates of every change" "./dev gates" \
    build/figures/repository.json build/figures/package.json build/figures/board.json build/figures/docs.json build/figures/complexity.json build/figures/proofs.json build/figures/coverage.json build/figures/mutation.json || failed=yes
  echo "gates: $(($(date +%s) - begun)) s, ${failed:+not }passed"
  [ -z "$failed" ]
}

# A gate that is a list of checks, all of which are made, also when one has failed:  begin_checks NAME;  checked WHAT COMMAND...;
# end_checks TITLE VERB, which is false when one has failed. They are noted in build/figures/NAME.json.
begin_checks() {
  checks_of=$1
  checks_begun=$(date +%s)
  checks_failed=""
  mkdir -p build/figures
  rm -f "build/figures/$1.json"
  : >"build/figures/$1.txt"
}

checked() {
  local what="$1" verdict=passed
  shift
  "$@" || {
    verdict="NOT PASSED"
    checks_failed=yes
  }
  echo "$checks_of: $what: $verdict"
  printf '%s\t%s\n' "$what" "$verdict" >>"build/figures/$checks_of.txt"
}

end_checks() {
  /usr/bin/python3 tools/dev/checked.py "$1" "$2" "build/figures/$checks_of.txt" $(($(date +%s) - checks_begun)) "build/figures/$checks_of.json"
  [ -z "$checks_failed" ]
}
