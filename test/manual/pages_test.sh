#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: pages_test.sh BUILD
# Each page of the manual is accepted by mandoc, and has every option that the help has.
set -eu
build=$1
command -v mandoc >/dev/null || { echo "mandoc is not installed" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# section TITLE PAGE
section() {
  awk -v title="$1" '/^[^ ]/ { inside = $0 == title } inside' "$2"
}

# has_options PAGE WORD...: every option in the help of these words stands in the page.
has_options() {
  said=$1
  shift
  "$build/fantail" "$@" --help | sed -n 's/^  \(-[^ ]*\).*/\1/p' | tr ',' '\n' >"$work/options"
  grep -qx -e --help "$work/options" || fail "fantail $*: the help has no --help"
  while read -r option; do
    grep -qF -e "$option" "$said" || fail "fantail $*: $option is in the help and not in the manual"
  done <"$work/options"
}

for page in "$build"/manual/man1/*.1 "$build"/manual/man5/*.5; do
  mandoc -T lint -W warning "$page" || fail "$page is not sound"
done

verbs=$("$build/fantail" --help | sed -n 's/^  \([a-z]*\)  *  [A-Z].*/\1/p')
[ -n "$verbs" ] || fail "the help lists no verbs"
for verb in $verbs; do
  page=$work/$verb.txt
  [ -s "$build/manual/man1/fantail-$verb.1" ] || fail "there is no page of fantail $verb"
  mandoc -T ascii -O width=500 "$build/manual/man1/fantail-$verb.1" | sed 's/.\x08//g' >"$page"
  has_options "$page" "$verb"
  for inner in $("$build/fantail" "$verb" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
    {
      section "$verb $inner" "$page"
      section "OPTIONS OF EVERY VERB" "$page"
    } >"$work/inner.txt"
    has_options "$work/inner.txt" "$verb" "$inner"
  done
done

mandoc -T ascii -O width=500 "$build/manual/man1/fantail.1" | sed 's/.\x08//g' >"$work/fantail.txt"
for verb in $verbs; do
  grep -q "^ *$verb  *[A-Z]\|^ *$verb\$" "$work/fantail.txt" || fail "fantail(1) does not list $verb"
done
mandoc -T ascii -O width=500 "$build/manual/man5/fantail.toml.5" | sed 's/.\x08//g' >"$work/toml.txt"
"$build/fantail" --complete fly --set '' | sed -n 's/^[a-z_]*\.\(.*\)=$/\1/p' >"$work/keys"
[ "$(wc -l <"$work/keys")" -gt 200 ] || fail "there are hardly any keys: $(wc -l <"$work/keys")"
while read -r key; do
  grep -q "^ *$key\( \|\$\)" "$work/toml.txt" || fail "fantail.toml(5) does not have the key $key"
done <"$work/keys"
# What is drawn at random has no keys of its own after --set.
for word in '[[spread]]' next_row standard_deviation; do
  grep -qF "$word" "$work/toml.txt" || fail "fantail.toml(5) does not have $word"
done
