#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: install_test.sh SOURCE BUILD
# Installs into an empty prefix, flies from there, and builds somebody else's project against it.
set -eu
source=$1 build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix="$work/a prefix"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

cmake --install "$build" --prefix "$prefix" >"$work/install.log" || { cat "$work/install.log" && exit 1; }
cd "$work"
"$prefix/bin/fantail" fly --json >summary.json
[ -s out/tasha3_launch2/report.html ] || fail "the installed program made no report"
# Its data is what was installed, not what lies in the sources.
"$prefix/bin/fantail" plan check tasha3_launch2 | grep -qF "$prefix/share/fantail/firmware/plans/" ||
  fail "the installed program reads other data than what was installed"
for verb in $("$build/fantail" --help | sed -n 's/^  \([a-z]*\)  *  [A-Z].*/\1/p'); do
  "$prefix/bin/fantail" "$verb" --help >help.txt || fail "fantail $verb is not installed"
  grep -q "^Usage: fantail $verb" help.txt || fail "fantail $verb --help speaks of something else"
  cat help.txt >>helps.txt
  [ -s "$prefix/share/man/man1/fantail-$verb.1" ] || fail "there is no man page of $verb"
done
for page in man1/fantail.1 man5/fantail.toml.5 man5/flight.ftl.5; do
  [ -s "$prefix/share/man/$page" ] || fail "there is no man page $page"
done
# What lies in the sources alone is not named as if it were here.
"$prefix/bin/fantail" new made --from tasha3_launch2 >made.txt
"$prefix/bin/fantail" fly --on emulator 2>>made.txt || true
! grep -rE '\./dev |docs/' helps.txt made.txt made "$prefix/share/fantail" | grep -v 'the sources' >said ||
  fail "somebody without the sources is sent there: $(cat said)"
# A shell that completes is told the names that are installed.
mv "$prefix/share/fantail/sim/scenarios/tunnel_steps.toml" "$prefix/share/fantail/sim/scenarios/tunnel_mine.toml"
"$prefix/bin/fantail" --complete fly tunnel_ >words.txt
grep -qx tunnel_mine words.txt && ! grep -qx tunnel_steps words.txt || fail "completed are other names than the installed: $(cat words.txt)"
for file in bash-completion/completions/fantail zsh/site-functions/_fantail fish/vendor_completions.d/fantail.fish; do
  grep -q -e --complete "$prefix/share/$file" || fail "$file is not installed"
done
rm "$prefix/libexec/fantail/fantail-paper"
code=0
"$prefix/bin/fantail" paper >said 2>&1 || code=$?
[ "$code" = 69 ] && grep -q 'fantail-paper' said || fail "a verb that is not installed: exit code $code, $(cat said)"
chmod a-x "$prefix/libexec/fantail/fantail-plan"
code=0
"$prefix/bin/fantail" plan >said 2>&1 || code=$?
[ "$code" = 69 ] && grep -q 'fantail-plan cannot be started: Permission denied' said || fail "no program: $code, $(cat said)"
chmod a+x "$prefix/libexec/fantail/fantail-plan"
[ -s "$prefix/share/fantail/canard_bus.dbc" ] || fail "no CAN database"
[ -s "$prefix/share/fantail/plan_block.csv" ] || fail "no fields of the plan block"
# What the verbs on a bus name where there is none.
code=0
"$prefix/libexec/fantail/with_vcan" --timeout 60 sh -c 'exit 3' 2>said || code=$?
[ "$code" = 3 ] || [ "$code" = 77 ] || fail "the installed with_vcan: exit code $code, $(cat said)"
[ -s "$prefix/share/fantail/lcm/state_t.lcm" ] || fail "no LCM types"

version=$("$prefix/bin/fantail" --version | sed 's/.* //')
cmake -S "$source/test/build/consumer" -B consumer -G Ninja -D CMAKE_PREFIX_PATH="$prefix" -D WANTED="$version" -D CMAKE_CXX_COMPILER="${CXX:-c++}" >configure.log ||
  { cat configure.log && exit 1; }
cmake --build consumer >build.log || { cat build.log && exit 1; }
./consumer/consumer | grep -q 'plan schema [0-9a-f]\{8\}$' || fail "the consumer says: $(./consumer/consumer)"
# What it links was compiled like the programs: the installed plan packs to the same schema.
schema=$(./consumer/consumer | sed 's/.* //')
"$prefix/bin/fantail" plan compile tasha3_launch2 --out p.ftpl | grep -q "schema $schema" || fail "another plan schema than $schema"
