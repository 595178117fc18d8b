# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# How much of the code that moves canards the tests reach, and whether they notice when it is changed. Part of ./dev.

# coverage [--json]: builds the tests of core, protocol and avionics with counters, runs them, judges (test/coverage).
coverage() {
  local begun folder=build/coverage failed="" ticker test
  case "$*" in
    "" | --json) ;;
    *) usage ;;
  esac
  begun=$(date +%s)
  take_turn
  # shellcheck disable=SC2086
  need $coverage_packages
  build "the tests with counters" $folder 900 coverage_commands
  mkdir -p build/figures
  rm -f $folder/*.profraw $folder/export.json
  # Ends when this script ends, even if it is killed.
  (while sleep 10 && kill -0 "$$" 2>/dev/null; do
    echo "coverage: the tests have been running for $(($(date +%s) - begun)) s" >&2
  done) 9>&- &
  ticker=$!
  running=""
  for test in core protocol avionics; do
    LLVM_PROFILE_FILE="$root/$folder/$test.profraw" FANTAIL_FRAMES=20000 \
      "$folder/test/$test/test_$test" "--gtest_filter=$(coverage_tests $test)" >"$folder/$test.log" 2>&1 &
    running="$running $test:$!"
  done
  for test in $running; do
    wait "${test#*:}" || {
      failed=yes
      echo "dev: coverage: test_${test%:*} failed; the end of $folder/${test%:*}.log:" >&2
      tail -n 30 "$folder/${test%:*}.log" >&2
    }
  done
  kill "$ticker" 2>/dev/null || :
  [ -z "$failed" ] || exit 1
  coverage_export $folder || {
    echo "dev: coverage: LLVM could not read the counters; see its message above" >&2
    exit 70
  }
  /usr/bin/python3 test/coverage/coverage.py "$root" $folder/export.json --figures build/figures/coverage.json \
    --command "./dev coverage" --seconds $(($(date +%s) - begun)) "$@"
}

coverage_commands() {
  configured build/coverage coverage && cmake --build --preset coverage
}

# Power cuts and flipped bits are about the flash, take most of the time, and reach nothing that the other tests do not.
coverage_tests() {
  if [ "$1" = avionics ]; then echo '-PowerCut.*:BitFlip.*'; else echo '*'; fi
}

coverage_export() {
  llvm-profdata-19 merge -sparse "$1/core.profraw" "$1/protocol.profraw" "$1/avionics.profraw" -o "$1/tests.profdata" &&
    llvm-cov-19 export "$1/test/core/test_core" -object "$1/test/protocol/test_protocol" \
      -object "$1/test/avionics/test_avionics" -instr-profile "$1/tests.profdata" \
      --ignore-filename-regex '^/usr/|/test/' >"$1/export.json"
}

# mutate [OPTION...]: changes that code in one place at a time and asks whether a test notices (test/mutation).
mutate() {
  # What is wrong with the options is said before anything is installed or built.
  ! command -v /usr/bin/python3 >/dev/null || /usr/bin/python3 test/mutation/mutate.py --check-options "$@" || exit $?
  take_turn # until the end: what is built in between would be judged
  # shellcheck disable=SC2086
  need $mutation_packages
  host_options=FANTAIL_TESTS
  host_build "the tests that judge mutants" test_core test_protocol test_avionics
  exec /usr/bin/python3 test/mutation/mutate.py "$@"
}
