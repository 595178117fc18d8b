# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# Running the tests, and timing them. Part of ./dev.

# The Python packages that some tests compare Fantail's files and frames with. Without them those tests are skipped, which
# --all does not allow.
python_tools() {
  # Only the pinned versions: others may read or generate different text.
  cat test/protocol/requirements.txt python/fantail/files/requirements.txt test/log_export/requirements.txt test/python/requirements.txt test/safety/requirements.txt >build/test-requirements.txt
  cmp -s build/test-requirements.txt build/test-venv/requirements.txt && return 0
  rm -rf build/test-venv
  # Debian's Python, not the first in PATH: the package list provides its modules.
  if /usr/bin/python3 -m venv build/test-venv &&
    build/test-venv/bin/pip -q --disable-pip-version-check install --no-compile --no-deps -r build/test-requirements.txt; then
    cp build/test-requirements.txt build/test-venv/requirements.txt
    rm -f build/host/build.ninja # what was configured without nanobind looks for it again
  else
    rm -rf build/test-venv
    echo "dev: pip could not install cantools, pyarrow, SciPy, pyulog, lcm, nanobind, pytest and Dask (no network?): the tests that need them are SKIPPED" >&2
  fi
}

# Files of other programs are read by the Python that has the packages for it.
use_test_python() {
  [ ! -x build/test-venv/bin/python ] || export FANTAIL_PYTHON="$root/build/test-venv/bin/python"
}

# What judges the pages in test/browser. It is fetched anew when the script that names it has changed.
axe_core() {
  cmp -s test/browser/fetch_axe.py build/axe/fetch_axe.py && return 0
  rm -rf build/axe
  /usr/bin/python3 test/browser/fetch_axe.py build/axe && cp test/browser/fetch_axe.py build/axe/ || {
    rm -rf build/axe
    echo "dev: axe-core could not be fetched (no network?): the test of the pages in a browser is SKIPPED" >&2
  }
}

# stage NAME COMMAND...: runs a command; --times prints one line for it.
stage() {
  local name="$1" begun code=0
  begun=$(date +%s)
  shift
  "$@" || code=$?
  echo "$name $(($(date +%s) - begun))" >>build/times.txt
  return "$code"
}

fetch_tools() {
  stage python python_tools
  stage axe axe_core
  stage prover prover_of_proofs ||
    echo "dev: pip could not install the model checker (no network?): the proofs are SKIPPED" >&2
}

run_tests() {
  all="" times=""
  if [ "${1:-}" = --only ] && [ $# -eq 2 ]; then
    one_test "$2"
    return
  fi
  for word in "$@"; do
    case "$word" in
      --all) all=yes ;;
      --times) times=yes ;;
      *) usage ;;
    esac
  done
  take_turn
  : >build/times.txt
  # shellcheck disable=SC2086
  if [ -n "$all" ]; then stage packages need $all_packages; else stage packages need $test_packages; fi
  if [ -z "$all" ]; then
    stage python python_tools
  else
    # pip waits for the network, or has work for one core; meanwhile what needs nothing of it is built.
    fetch_tools 9>&- &
    fetching=$!
    # Without --all the tests on the emulated processor are skipped.
    stage build_arm arm_build "the images for the emulated processor" all
    stage build_playground build "the module of the page" build/playground 100 playground_commands
    wait "$fetching"
  fi
  host_options=FANTAIL_TESTS
  stage build_host host_build "the tests" all
  leave_turn
  failed=""
  stage tests host_tests || failed=yes
  # A skipped test proves nothing; if everything is installed it is a failure.
  if ! grep -q 'skipped="0"' build/host/test-results.xml; then
    if [ -n "$all" ]; then
      echo "dev: tests were skipped, which --all does not allow" >&2
      failed=yes
    else
      echo "dev: the skipped tests need packages that are not installed; ./dev test --all installs them and skips none" >&2
    fi
  fi
  [ -z "$times" ] || /usr/bin/python3 tools/dev/times.py build
  [ -z "$failed" ]
}

# test/build/declared_packages.py checks which files of which packages the tests read.
host_tests() {
  : >build/host/read_log.txt
  rm -rf build/host/test-times
  # Memory of a flight that is given back to the kernel is cleared for the next one: up to a third of the time of a test.
  export MALLOC_MMAP_THRESHOLD_=33554432 MALLOC_TRIM_THRESHOLD_=1073741824
  use_test_python
  LD_PRELOAD="$root/build/host/test/build/read_log.so" FANTAIL_READ_LOG="$root/build/host/read_log.txt" \
    GTEST_OUTPUT="json:$root/build/host/test-times/" GTEST_BRIEF=1 ctest --preset host --output-junit test-results.xml
}

# one_test SUITE.NAME: that test, or with * several, wherever a test program has it; also as the safety case writes it, with the
# name of what its parameters are before it. A name that no test has is wrong usage: googletest would call nothing a success.
one_test() {
  local name="${1##*/}" folders folder program filter found="" failed=""
  local suite="${name%%.*}"
  case "$name" in *[!A-Za-z0-9_.*?]* | *.*.*) usage ;; [A-Za-z]*.?*) ;; *) usage ;; esac
  # shellcheck disable=SC2046 # names of folders
  folders=$(dirname $(grep -rlE "\\b(TYPED_)?(TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\\( *$(echo "$suite" | sed 's/[*?]/\\w*/g')," test --include='*.cpp' ||
    echo none/x) | sort -u)
  filter="$name:*/$name:$name/*:*/$name/*:$suite/*.${name#*.}"
  [ "$folders" = none ] || {
    take_turn
    # shellcheck disable=SC2086
    need $test_packages
    python_tools
    host_options=FANTAIL_TESTS
    # shellcheck disable=SC2046
    host_build "the test" $(printf '%s/all ' $folders)
    leave_turn
  }
  for folder in $folders; do
    for program in build/host/"$folder"/test_*; do
      [ -f "$program" ] && [ -x "$program" ] && "$program" --gtest_list_tests --gtest_filter="$filter" 2>/dev/null | grep -q '^  ' || continue
      found=yes
      echo "$program:"
      "$program" --gtest_brief=1 --gtest_filter="$filter" || failed=yes
    done
  done
  [ -n "$found" ] || {
    echo "dev: test: no test is called $1; example: ./dev test --only 'FlightPhase.*'" >&2
    exit 64
  }
  [ -z "$failed" ]
}
