#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: with_vcan_test.sh WITH_VCAN
# with_vcan from outside: what goes in, what comes out, and that nothing stays behind.
set -u
with_vcan=$1
work=$(mktemp -d /tmp/with_vcan_test.XXXXXX)
trap 'rm -rf "$work"' EXIT
export TMPDIR="$work/tmp"
mkdir "$TMPDIR"
failures=0

# expect NAME WANTED GOT
expect() {
  [ "$2" = "$3" ] && return
  failures=$((failures + 1))
  printf 'FAILED: %s\n--- wanted\n%s\n--- got\n%s\n' "$1" "$2" "$3"
}

"$with_vcan" --timeout 60 true 2>"$work/error"
code=$?
[ "$code" -ne 77 ] || { cat "$work/error" && exit 77; }
expect "a command that succeeds" 0 "$code"

"$with_vcan" --help | grep -q '^with_vcan candump'
expect "--help has examples" 0 $?
"$with_vcan" 2>/dev/null
expect "no command is a usage error" 64 $?
"$with_vcan" --timeout soon true 2>/dev/null
expect "a time that is none is a usage error" 64 $?

# Everything that one run can show, in one run: words, folder, environment, streams, buses, files, exit code.
mkdir "$work/a folder"
cat >"$work/a folder/look around" <<'LOOK'
#!/bin/sh
printf '<%s>' "$@"
echo
pwd
echo "$CARGO"
umask
cat | wc -c
echo "to the other stream" >&2
ip -br link show vcan0 | grep -c UP
ip -br link show vcan1 | grep -c UP
candump -L -n 1 vcan0 | sed 's/.* //' &
sleep 0.3
cansend vcan0 123#11
wait
echo "from inside" >made
seq 1 20000 | md5sum
exit 23
LOOK
chmod +x "$work/a folder/look around"
cd "$work/a folder" || exit 1
got=$(umask 027 && CARGO="two  words, it's
two lines" "$with_vcan" --timeout 60 "./look around" "a b" "" "it's" '$HOME "*"' </dev/null 2>"$work/error")
expect "the exit code" 23 $?
expect "what a command sees and says" "<a b><><it's><\$HOME \"*\">
$work/a folder
two  words, it's
two lines
0027
0
to be compared below
1
1
123#11
$(seq 1 20000 | md5sum)" "$(echo "$got" | sed 's/^0$/&\
to be compared below/')"
expect "the other stream" "to the other stream" "$(tail -n 1 "$work/error")"
expect "a file made inside" "from inside" "$(cat made)"
cd /

# What a person sees comes at once, and what a command leaves running ends with it.
begin=$(date +%s)
"$with_vcan" --timeout 60 sh -c 'echo first; sleep 300 & sleep 2; echo second' 2>/dev/null | while read -r _; do
  date +%s
done >"$work/times"
{ read -r first && read -r second; } <"$work/times"
expect "the first line comes before the second is written" yes "$([ $((second - first)) -ge 1 ] && echo yes)"
expect "background jobs do not hold it up" yes "$([ $(($(date +%s) - begin)) -lt 60 ] && echo yes)"

"$with_vcan" --timeout 60 sh -c 'kill -KILL $$' 2>/dev/null
expect "a command that a signal ended" 137 $?
"$with_vcan" no_such_command_anywhere 2>/dev/null
expect "a command that does not exist" 127 $?
"$with_vcan" --timeout 1 sleep 300 2>/dev/null
expect "a command beyond its time" 124 $?
expect "output that nobody reads any more" y "$("$with_vcan" --timeout 60 yes 2>/dev/null | head -n 1)"

# signalled SIGNAL [COMMAND]: the exit code after the signal, sent when the command has said that it is ready. Without
# env the shell would start it deaf to Ctrl-C.
signalled() {
  : >"$work/said"
  env --default-signal=INT "$with_vcan" --timeout 60 sh -c "$2" >"$work/said" 2>/dev/null &
  process=$!
  tries=0
  until grep -q ready "$work/said" || [ $((tries += 1)) -gt 300 ]; do sleep 0.1; done
  # Ctrl-C is for everybody in the foreground; here it reaches with_vcan alone, as from another program.
  kill -s "$1" "$process"
  wait "$process"
  signalled_code=$?
}
loop='echo ready; while :; do sleep 0.1; done'
for signal in INT TERM HUP; do
  signalled $signal "trap 'echo centred; exit 9' $signal; $loop"
  expect "$signal reaches the command, which ends as it likes" 9 $signalled_code
  expect "and can still say something" centred "$(tail -n 1 "$work/said")"
done
signalled TERM "$loop"
expect "a command that does not mind signals" 143 $signalled_code

"$with_vcan" --timeout 60 sleep 300 2>/dev/null &
process=$!
sleep 0.3
kill -s TERM "$process"
wait "$process"
expect "a signal before there is a command" 143 $?

# A terminal stays a terminal, and a pipe beside it a pipe.
if command -v script >/dev/null; then
  export with_vcan
  got=$(timeout 60 script -qec 'stty rows 33 cols 99
    "$with_vcan" sh -c "test -t 1 && stty size <&1; test -t 2 || echo piped" 2>/dev/null' /dev/null | tr -d '\r')
  expect "a terminal and its size" "33 99
piped" "$got"
fi

# Nothing stays: neither files nor processes that name their folder.
expect "temporary files" "" "$(ls -A "$TMPDIR")"
expect "processes" "" "$(ps axo stat,args | grep -v '^Z' | grep -F "$TMPDIR" | grep -v grep)"

# Killed outright, too.
"$with_vcan" --timeout 60 sleep 300 2>/dev/null &
process=$!
sleep 2
kill -s KILL "$process"
sleep 1
expect "temporary files after a kill" "" "$(ls -A "$TMPDIR")"
expect "processes after a kill" "" "$(ps axo stat,args | grep -v '^Z' | grep -F "$TMPDIR" | grep -v grep)"

[ "$failures" -eq 0 ]
