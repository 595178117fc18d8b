#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: verbs.sh PROJECT quick|thorough
# Every verb of ./dev that needs no hardware and no hours, called once as a person calls it. `thorough` are those that
# need clang or the ARM compiler; it ends with 77 (skipped) where these are not installed. ./dev test is what calls this.
set -eu
project=$1
dev=$project/dev
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
called="test"

# call CODE VERB ARGUMENT...
call() {
  wanted=$1
  shift
  called="$called $1"
  code=0
  "$dev" "$@" >said 2>&1 </dev/null || code=$?
  [ "$code" = "$wanted" ] || {
    echo "FAILED: ./dev $*: exit code $code instead of $wanted:"
    tail -n 30 said
    exit 1
  }
}

quick() {
  call 0 help
  call 64 bogus
  grep -q 'no verb "bogus"' said || { echo "FAILED: a verb that is none was not named: $(cat said)" && exit 1; }
  call 64 packages nonsense
  call 0 packages fly
  grep -qx ninja-build said || { echo "FAILED: no ninja-build in the packages for flying" && exit 1; }
  call 0 fly
  call 0 identify out/tasha3_launch2 --vehicle tasha3_launch2 --window 0.9:8
  call 0 compare out/tasha3_launch2 out/tasha3_launch2 --b true
  call 0 listen out/tasha3_launch2/flight.csv
  call 0 log info out/tasha3_launch2
  python=$project/build/test-venv/bin/python # has the packages; without it convert names the command that installs them
  if [ -e "$python" ]; then
    FANTAIL_PYTHON=$python call 0 convert out/tasha3_launch2/flight.csv --to parquet
  else
    call 69 convert out/tasha3_launch2/flight.csv --to parquet
  fi
  call 0 replay out/tasha3_launch2
  call 0 report out/tasha3_launch2
  call 0 plan check tasha3_launch2
  call 0 tune tasha3_launch2 --flights 4
  call 0 fly tunnel_steps
  call 0 tunnel steps out/tunnel_steps
  call 1 predict tasha3_launch1 --runs 8
  call 0 campaign tasha3_launch2 --runs 8
  call 0 campaign detection --plan tasha3_launch2 --kind drop --events 64
  call 64 campaign detection --events 0 --launches 0
  call 64 campaign detection --kind launch_one_bad --launches 4 --at-most 10
  call 1 campaign detection --plan tasha3_launch2 --kind launch --launches 5 --at-most 0.1
  call 0 campaign faults tasha3_launch2 --device bus --phase launched
  call 0 campaign faults tasha3_launch2 --cell imu/offset_100/controlling
  call 64 campaign faults tasha3_launch2 --cell imu/dead/armed --device imu
  call 0 rules irec tasha3_launch2_irec
  call 0 brief tasha3_launch2_irec --step 2
  call 0 paper
  call 0 airframe tasha3_launch2
  call 0 new my_rocket --from tasha3_launch2
  call 0 fly my_rocket/scenario.toml
  # No bus and no messages here: what they say of that is the test.
  call 74 node bench_healthy --can no_such_bus
  call 74 bench watch --can no_such_bus
  call 74 gateway --can no_such_bus --lcm "file:///$work/x.lcmlog"
  call 74 watch --lcm file:///nowhere/x.lcmlog
  call 3 with-vcan sh -c 'exit 3'
  call 0 flash --help # says how, and installs nothing for it
  grep -q 'write the image into the board' said || { echo "FAILED: what is flash? $(cat said)" && exit 1; }
  call 64 test --foo
  grep -q 'test does not take "--foo"' said || { echo "FAILED: the wrong word was not named: $(cat said)" && exit 1; }
  call 64 test --only NoSuchSuite.NoSuchTest
  grep -q 'no test is called NoSuchSuite.NoSuchTest' said || { echo "FAILED: a name that no test has: $(cat said)" && exit 1; }
  call 64 test --only 'Two words.x'
  call 64 playground here
  call 64 format ''
  call 64 lint .
  call 64 sanitize .
  call 64 gates firmware/core
  call 64 repository docs
  call 64 package here
  call 64 package --lint --container
  call 0 package --help # what the words do takes minutes and root
  grep -qe '--check' said && grep -qe '--container' said || { echo "FAILED: what does package take? $(cat said)" && exit 1; }
  call 64 release
  call 64 docs here
  call 64 prove no_such_proof
  grep -q 'no proof no_such_proof' said || { echo "FAILED: the proof that is none was not named: $(cat said)" && exit 1; }
  call 0 prove --list
  call 64 coverage --jason
  call 64 mutate --sample 0
  call 64 install --prefix --help
  call 64 install '--prefix=~/nowhere'
  export DESTDIR="$work/stage"
  call 0 install --prefix /prefix
  unset DESTDIR
  grep -qF "$work/stage/prefix/bin/fantail" said && [ -x "$work/stage/prefix/bin/fantail" ] ||
    { echo "FAILED: it is not where it was said to be: $(cat said)" && exit 1; }
  call 0 install --prefix "$work/prefix"
  "$work/prefix/bin/fantail" --version
}

thorough() {
  for tool in clang-tidy-19 arm-none-eabi-gcc; do
    command -v "$tool" >/dev/null || { echo "SKIPPED: $tool is not installed" && exit 77; }
  done
  call 0 firmware
  # A stale page would be mended by the next line, and the sources would change while other tests compile them.
  python3 "$project/tools/dev/trace.py" "$project" --check >said 2>&1 || { echo "FAILED: $(cat said)" && exit 1; }
  call 0 trace
  call 0 sanitize tools/json # the folder that is built the fastest
  call 0 lint tools/replies
  [ -e /usr/include/unicorn/unicorn.h ] || { echo "SKIPPED: libunicorn-dev is not installed" && exit 77; }
  call 74 board --can no_such_bus
}

"$2"
# None is forgotten: the two parts together are what the help lists.
all="$(sed -n 's/^ *call [0-9]* \([a-z-]*\).*/\1/p' "$0") test"
for verb in $("$dev" help | sed -n 's/^\.\/dev \([a-z-]*\).*/\1/p'); do
  case " $(echo "$all" | tr '\n' ' ') flash debug soak bench-speed validate wheel examples " in
    *" $verb "*) ;;
    *) echo "FAILED: no test calls ./dev $verb" && exit 1 ;;
  esac
done
