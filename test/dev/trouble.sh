#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: trouble.sh PROJECT
# What ./dev says when the machine does not do what it should: a copy of ./dev with stand-ins for the package tools and for
# CMake, and no others in its PATH.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/project/tools" "$work/bin"
cp "$1/dev" "$1/CMakePresets.json" "$work/project/"
cp -r "$1/tools/dev" "$work/project/tools/"
cd "$work/project"
for tool in sh cat grep sed awk mkdir rm date flock tee sleep df dirname readlink env tail sort cmp; do
  ln -s "$(command -v "$tool")" "$work/bin/$tool"
done
failures=0

# stand_in NAME SCRIPT: a program of that name.
stand_in() {
  rm -f "$work/bin/$1" # a link: the file behind it is this machine's own
  printf '#!/bin/sh\n%s\n' "$2" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

# expect CODE TEXT ARGUMENT...: the exit code of ./dev, and what it must say on standard error.
expect() {
  wanted=$1 text=$2
  shift 2
  code=0
  PATH="$work/bin" ./dev "$@" >"$work/out" 2>"$work/err" </dev/null || code=$?
  if [ "$code" != "$wanted" ] || ! grep -qF -- "$text" "$work/err"; then
    echo "FAILED: ./dev $*: exit code $code instead of $wanted, or nothing of \"$text\" in:"
    cat "$work/out" "$work/err"
    failures=$((failures + 1))
  fi
}

expect 69 "has no dpkg" fly

# One package is missing from here on, and who asks is no administrator.
stand_in dpkg-query 'for last; do :; done; [ "$last" = ninja-build ] || echo "install ok installed"'
stand_in dpkg 'cat "$0.audit" 2>/dev/null; exit 0'
stand_in id 'echo 1000'
stand_in apt-cache 'echo "  Candidate: 1.0"'
stand_in apt-get 'echo "apt-get $*" >>"$0.log"; exit 0'
expect 69 "apt-get update && apt-get install --no-install-recommends ninja-build" fly
stand_in sudo 'exit 1'
expect 69 "sudo did not let this user" fly
stand_in true 'exit 0'
stand_in sudo 'exec "$@"'

echo "The following packages are only half configured" >"$work/bin/dpkg.audit"
expect 69 "dpkg --configure -a && apt-get --fix-broken install" fly
rm "$work/bin/dpkg.audit"

stand_in apt-get 'case "$*" in *update*) echo "Temporary failure resolving deb.debian.org"; exit 100 ;; *install*) exit 100 ;; esac'
expect 69 "the package servers could not be reached" fly
stand_in apt-cache 'echo "  Candidate: (none)"'
expect 69 "without them these are unknown: ninja-build" fly
stand_in apt-get 'exit 0'
expect 69 "has no package ninja-build; Fantail is built and tested on Debian 12" fly
stand_in apt-cache 'echo "  Candidate: 1.0"'
stand_in apt-get 'case "$*" in *install*) exit 100 ;; esac'
stand_in df 'echo "Filesystem 1048576-blocks Used Available Capacity Mounted"; echo "/dev/sda 10 9 3 99% /"'
expect 69 "only 3 MB are free" fly
ln -sf "$(command -v df)" "$work/bin/df"
expect 69 "see its message above" fly

# All packages are there.
stand_in dpkg-query 'echo "install ok installed"'
stand_in cmake 'echo "[1 9] Building"; echo "FAILED: a.o"; echo "a.cpp: No space left on device"; exit 1'
expect 74 "the disk is full" fly
stand_in cmake 'echo "[1 9] Building"; echo "FAILED: a.o"; echo "a.cpp:1: error: such a thing"; exit 1'
expect 70 "a.cpp:1: error: such a thing" fly
stand_in cmake 'echo "CMake Error: no such preset"; exit 1'
expect 70 "CMake Error: no such preset" fly
expect 70 "try again: rm -rf build/host" fly
# A first configuration that failed is not to spoil the second.
stand_in cmake 'case "$*" in --fresh*) echo "forgotten" ;; esac; exit 1'
expect 70 "forgotten" fly
# Nor is the build of another place, which the project was copied from.
mkdir -p build/host
echo "rule" >build/host/build.ninja
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$work/other" >build/host/CMakeCache.txt
expect 70 "forgotten" fly
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$work/project" >build/host/CMakeCache.txt
stand_in cmake 'echo "$*"; exit 1'
expect 70 "--build --preset host" fly
rm -r build/host
stand_in flock 'exit 127'
expect 69 "flock does not work here" fly
ln -sf "$(command -v flock)" "$work/bin/flock"

# Where nothing can be written.
rm -rf build
: >build
expect 73 "this user cannot write into $work/project/build" fly
stand_in df 'echo "Filesystem 1048576-blocks Used Available Capacity Mounted"; echo "/dev/sda 10 9 3 99% /"'
expect 74 "the disk is full" fly
ln -sf "$(command -v df)" "$work/bin/df"
rm build

# A model checker that cannot be fetched; what needs none works without.
mkdir test
cp -r "$1/test/proof" test/
PIP_INDEX_URL=http://127.0.0.1:9/ PIP_RETRIES=0 PIP_DEFAULT_TIMEOUT=1
export PIP_INDEX_URL PIP_RETRIES PIP_DEFAULT_TIMEOUT
expect 69 "the model checker could not be installed" prove
[ ! -e build/prove-venv ] || { echo "FAILED: a half environment was left behind" && failures=$((failures + 1)); }
expect 64 "there is no proof such" prove such

# A folder that git does not know, and a tool that Go cannot fetch.
stand_in git 'exit 128'
expect 69 "git does not know this folder as a repository" repository
stand_in git 'exit 0'
stand_in go 'exit 1'
mkdir -p test/repository build/repository-venv
: >test/repository/requirements.txt
: >build/repository-venv/requirements.txt
expect 69 "actionlint could not be installed" repository
[ ! -e build/actionlint ] || { echo "FAILED: half of actionlint was left behind" && failures=$((failures + 1)); }
unset PIP_INDEX_URL PIP_RETRIES PIP_DEFAULT_TIMEOUT

# Slow: in a pipe it says how far it is, and a second one waits for its turn and says so.
mkdir -p build/host
stand_in cmake 'case "$*" in --build*) echo "[40 90] Building"; sleep 12 ;; esac'
printf '#!/bin/sh\necho flown\n' >build/host/fantail
chmod +x build/host/fantail
PATH="$work/bin" ./dev fly >"$work/first" 2>&1 </dev/null &
first=$!
sleep 3
expect 0 "waiting for another ./dev in this folder: ./dev fly" identify
wait "$first"
grep -q "building the flight simulator: 40 of 90 (44 %)" "$work/first" || {
  echo "FAILED: in ten seconds nothing was said of a build: $(cat "$work/first")"
  failures=$((failures + 1))
}
[ "$(tail -n 1 "$work/first")" = flown ] || { echo "FAILED: not flown" && failures=$((failures + 1)); }

# Killed outright, it leaves nobody behind who writes.
mkfifo "$work/pipe"
PATH="$work/bin" ./dev fly >"$work/pipe" 2>&1 </dev/null &
killed=$!
(sleep 1 && kill -KILL "$killed") &
timeout 60 cat "$work/pipe" >"$work/said" || {
  echo "FAILED: a minute after ./dev was killed somebody still wrote: $(tail -n 2 "$work/said")"
  failures=$((failures + 1))
}
[ "$failures" -eq 0 ]
