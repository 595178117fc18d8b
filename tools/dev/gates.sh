# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# What takes too long for every build: sanitizers on everything, the linter, soak tests, benchmarks. Part of ./dev.

# source_folders VERB FOLDER...: refuses what is no folder of the project.
source_folders() {
  local called="$1"
  shift
  for folder in "$@"; do
    case "$folder" in [a-z]*) ;; *) false ;; esac && [ -d "$folder" ] || {
      echo "dev: $called: there is no source folder $folder; example: firmware/core" >&2
      exit 64
    }
  done
}

# sanitize [FOLDER...]: all tests, or those of the folders named, under the sanitizers.
sanitize() {
  source_folders sanitize "$@"
  take_turn
  # shellcheck disable=SC2086
  need $gate_packages
  host_options=FANTAIL_TESTS
  if [ $# -eq 0 ]; then
    build "everything under the sanitizers" build/host-asan 3000 sanitized_commands all
    LD_PRELOAD="" ctest --preset host-asan # the sanitizer must be loaded first
    return
  fi
  for folder in "$@"; do
    tests="test_$(basename "$folder")"
    [ -d "test/$(basename "$folder")" ] || { echo "dev: $folder has no test program" >&2 && continue; }
    build "$tests under the sanitizers" build/host-asan 3000 sanitized_commands "$tests"
    LD_PRELOAD="" "build/host-asan/test/$(basename "$folder")/$tests" --gtest_brief=1
  done
}

# lint [FOLDER...]: clang-tidy.
lint() {
  source_folders lint "$@"
  take_turn
  # shellcheck disable=SC2086
  need $gate_packages
  host_options=FANTAIL_TESTS
  if [ $# -eq 0 ]; then
    host_build "what the linter reads" all
    set -- firmware hal python sim tools test
  else
    host_build "what the linter reads" check_includes
  fi
  # Only what is compiled for this PC: the board's own files are compiled by the ARM compiler. One file a process, to show the
  # progress. The options after --quiet: GCC's own options in the commands, and its stable_sort.
  mkdir -p build/lint
  /usr/bin/python3 tools/dev/compile_commands.py build/host >build/lint/compile_commands.json
  tidy="clang-tidy-19 -p build/lint --quiet --extra-arg=-Wno-ignored-gch --extra-arg=-Wno-unknown-warning-option"
  tidy="$tidy --extra-arg=-Wno-unused-command-line-argument --extra-arg=-Wno-deprecated-declarations"
  files=$(sources "*.cpp" "$@" | sort -u | while read -r file; do
    ! grep -qF "/$file\"" build/lint/compile_commands.json || echo "$file"
  done)
  export tidy total="$(echo "$files" | wc -l)"
  # shellcheck disable=SC2016 # the inner shell puts them in
  echo "$files" | nl -w 1 | xargs -r -n 2 -P "$(nproc)" sh -c 'echo "lint: $1 of $total: $2" && exec $tidy "$2"' lint
}

sanitized_commands() {
  configured build/host-asan host-asan && cmake --build --preset host-asan --target "$@"
}

# soak [--short] [--resume | --failed] [--seed S]: --short is a thousandth of the runs, to check that it works.
soak() {
  local page="" word before="" code=0
  for word in "$@"; do
    case "$before$word" in
      --short) page=build/figures/soak_short.md ;;
      --resume | --failed | --seed) ;;
      --seed[1-9]*) ;;
      *) usage ;;
    esac
    before=""
    [ "$word" != --seed ] || before=--seed
  done
  [ -z "$before" ] || usage
  take_turn
  # shellcheck disable=SC2086
  need $soak_packages $prove_packages $board_packages
  prover_of_proofs || refuse "the model checker could not be installed (see above), and the soak has every proof in it"
  host_options=FANTAIL_TESTS
  arm_build "the image for the virtual board" fantail-stm32f405
  host_build "the soak tests" test_avionics test_memory_campaign test_sil test_core test_dormancy test_gates verbs \
    board_flips board_sweep board_faults board_timing
  build "the fuzzers" build/fuzz 600 fuzz_commands
  leave_turn
  /usr/bin/python3 -B tools/dev/soak.py . "$@" || code=$?
  [ "$code" -le 1 ] || exit "$code"
  /usr/bin/python3 tools/dev/figures.py "${page:-docs/figures/soak.md}" "Soak before a release" "./dev soak" build/figures/soak.json
}

fuzz_commands() {
  configured build/fuzz fuzz && cmake --build --preset fuzz
}

bench_speed() {
  take_turn
  # shellcheck disable=SC2086
  need $bench_packages
  # In its own folder: ./dev test does not need these packages.
  build "the benchmarks" build/bench 300 bench_commands
  python_of test/benchmark build/bench-venv
  leave_turn
  exec build/bench-venv/bin/python test/benchmark/bench_speed.py build/bench/test/benchmark "$@"
}

# python_of FOLDER VENV: the packages that its requirements.txt pins, in an environment of their own.
python_of() {
  if ! cmp -s "$1/requirements.txt" "$2/requirements.txt"; then
    rm -rf "$2"
    /usr/bin/python3 -m venv "$2"
    "$2/bin/pip" -q --disable-pip-version-check install -r "$1/requirements.txt"
    cp "$1/requirements.txt" "$2/"
  fi
}

wheel() {
  [ $# -eq 0 ] || usage
  take_turn
  # shellcheck disable=SC2086
  need $fly_packages python3-venv python3-dev
  rm -rf build/wheels build/wheel-venv
  /usr/bin/python3 -m venv build/wheel-venv
  build/wheel-venv/bin/pip -q --disable-pip-version-check wheel --no-deps --wheel-dir build/wheels .
  build/wheel-venv/bin/pip -q --disable-pip-version-check install build/wheels/fantail-*.whl
  leave_turn
  cd / # it must not need this folder
  "$root/build/wheel-venv/bin/python" -c \
    'import fantail; print(*fantail.__path__); print(fantail.fly("tasha3_launch2").summary["verdict"])'
  ls -l "$root"/build/wheels/fantail-*.whl
}

# The notebooks, and the examples that need more than ./dev test has. The package lies in their environment with its data
# within, as pip installs it, but is the one that the tests have built.
examples() {
  [ $# -eq 0 ] || usage
  take_turn
  # shellcheck disable=SC2086
  need $test_packages
  python_tools
  host_options=FANTAIL_TESTS
  host_build "the Python package" fantail_python
  python_of test/examples build/examples-venv
  site=$(build/examples-venv/bin/python -c 'import sysconfig; print(sysconfig.get_path("platlib"))')
  cmake --install build/host --component python --prefix "$site" >build/host/install.log
  cp python/fantail/*.py "$site/fantail/"
  leave_turn
  PYTHONDONTWRITEBYTECODE=1 exec build/examples-venv/bin/python -m pytest -q -p no:cacheprovider \
    --durations=0 --durations-min=0.1 test/examples
}

validate() {
  take_turn
  # shellcheck disable=SC2086
  need $fly_packages python3-venv
  host_build "fantail fly" fantail fantail-fly
  python_of test/validation build/validation-venv
  leave_turn
  exec build/validation-venv/bin/python test/validation/validate.py build/host/fantail "$@"
}

bench_commands() {
  configured build/bench benchmarks && cmake --build --preset benchmarks
}

format() {
  local how
  case "$#,$*" in
    0,) how=-i ;;
    1,--check) how="--dry-run --Werror" ;;
    *) usage ;;
  esac
  # shellcheck disable=SC2086
  need $format_packages
  # shellcheck disable=SC2086 # a list of words
  sources "*.[ch]pp" firmware hal python sim tools test | xargs -n 100 -P "$(nproc)" clang-format-19 $how
}

# sources PATTERN FOLDER...: the files whose names match. Not git's list: that is empty, without an error, if git does not
# trust the owner of the folder.
sources() {
  local pattern="$1"
  shift
  find "$@" -name "$pattern" -type f
}
