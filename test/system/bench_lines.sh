#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: bench_lines.sh SOURCE PROGRAM [OPTION OF WITH_VCAN...]
# The lines of docs/bench.md for a bench without hardware, one by one, as a reader copies them. Only ./dev is another one, because the
# real one would build a program of its own: it hands its verbs to PROGRAM, and knows none that the real one does not.
set -u
source=$1 program=$2
shift 2
with_vcan="$source/tools/with_vcan --timeout 240 $*"
work=$(mktemp -d /tmp/bench_lines.XXXXXX)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}

cat >dev <<DEV
#!/bin/sh
verb=\$1
"$source/dev" help | grep -q "^./dev \$verb " || { echo "./dev knows no \$verb" >&2 && exit 64; }
case "\$verb" in
  with-vcan) shift && exec $with_vcan "\$@" ;;
  node | bench) exec "$program" "\$@" ;;
  *) echo "this test does not know ./dev \$verb" >&2 && exit 70 ;;
esac
DEV
chmod +x dev

# shellcheck disable=SC2086 # a list of words
$with_vcan true >skipped 2>&1
[ $? -ne 77 ] || { cat skipped && exit 77; }

# The first block of code below the heading.
sed -n '/^### Without hardware/,/^## /p' "$source/docs/bench.md" | awk '/^```/ { block++; next } block == 1' >lines
[ "$(wc -l <lines)" -ge 4 ] || fail "docs/bench.md has only $(wc -l <lines) lines"

number=0
while IFS= read -r line; do
  number=$((number + 1))
  wanted=$(echo "$line" | sed -n 's/.*# .*exit code \([0-9]*\).*/\1/p')
  # On a PC with much else to do the guest stands still for longer than the avionics waits for a heartbeat. That, and
  # nothing else, is tried again, and said.
  for try in 1 2 3 4 5; do
    sh -c "$line" >"said_$number" 2>&1 </dev/null
    code=$?
    grep -q -e 'no heartbeat from the bench arrived' -e 'the canards are not judged' -e 'no verdict: ' "said_$number" || break
    echo "try $try: this PC is too busy: $line"
  done
  [ "$code" = "${wanted:-0}" ] || {
    fail "exit code $code instead of ${wanted:-0}: $line"
    tail -n 15 "said_$number"
  }
done <lines

# What the text around the lines promises.
grep -q 'safe (power_on); canard 1' said_* || fail "nothing was watched"
grep -q PASS out/healthy/sheet.html || fail "the healthy rocket has not passed"
grep -q '"passed": true' out/healthy/sheet.json || fail "nor does its JSON say so"
grep -q 'Canard 3 is reversed' out/reversed/sheet.html || fail "the reversed canard was not named"
grep -q 'ARMED' said_* || fail "nothing was armed"
exit "$((failures > 0))"
