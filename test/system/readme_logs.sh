#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: readme_logs.sh SOURCE PROGRAM
# The lines of the README's sections on logs and on the flight record, one by one, as a reader copies them; PROGRAM stands in for ./dev, which would
# build one of its own. A line that promises exit code 1 must keep that, too.
set -u
source=$1 program=$2
work=$(mktemp -d /tmp/readme_logs.XXXXXX)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

for section in "From logs" "The flight record"; do
  sed -n "/^## $section/,/^## /p" "$source/README.md" | sed -n '/^```/,/^```/p' | sed '/^```/d' >section_lines
  [ "$(wc -l <section_lines)" -ge 6 ] || { echo "FAILED: \"$section\" has only $(wc -l <section_lines) lines" && exit 1; }
  cat section_lines >>lines
done

failures=0
while read -r line; do
  verb=$(echo "$line" | sed -n 's/^\.\/dev \([a-z]*\) .*/\1/p; s/^\.\/dev \([a-z]*\)$/\1/p')
  "$source/dev" help | grep -q "^./dev $verb " || { echo "FAILED: ./dev knows no $verb" && failures=$((failures + 1)); }
  expected=0
  case "$line" in *"exit code 1"*) expected=1 ;; esac
  command=$(echo "$line" | sed 's/ *#.*//; s/^\.\/dev //')
  # shellcheck disable=SC2086 # a list of words
  "$program" $command >out.txt 2>&1 </dev/null
  code=$?
  if [ "$code" -ne "$expected" ]; then
    echo "FAILED: exit code $code instead of $expected: $line" && cat out.txt && failures=$((failures + 1))
  fi
  # Every page that is named must be there.
  for page in $(sed -n 's/^  \(report\|page\) *//p' out.txt); do
    [ -s "$page" ] || { echo "FAILED: no $page after: $line" && failures=$((failures + 1)); }
  done
done <lines
[ "$failures" -eq 0 ]
