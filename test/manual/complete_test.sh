#!/bin/sh
# SPDX-License-Identifier: MIT
# Usage: complete_test.sh bash|zsh|fish SOURCE BUILD
# The shell itself completes the beginnings of some commands; what it offers is compared with what it should.
set -eu
shell=$1 source=$2 build=$3
tests=$source/test/manual
alone=""
[ "$shell" != fish ] || alone=--no-config # without what other packages have for fish
command -v "$shell" >/dev/null || { echo "$shell is not installed" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME="$work/home" PATH="$build:$PATH" FANTAIL_DATA="$source"
export COMPLETIONS="$source/tools/manual/completions" COMPLETE_LINE
mkdir -p "$HOME" "$work/here/flights" "$work/here/my flights"
cd "$work/here"
touch -- flown.ftl "my flights/first.ftl" "$HOME/at_home.ftl" --odd.ftl 'two
lines.ftl'

# offers LINE WORD...: these words, or only others with a ! ahead of them, are among what the shell offers at the end of LINE.
offers() {
  COMPLETE_LINE=$1
  shift
  # shellcheck disable=SC2086 # one word or nothing
  "$shell" $alone "$tests/complete.$shell" >"$work/offered" 2>&1
  for word in "$@"; do
    case $word in
      !*) ! grep -qxF -e "${word#!}" "$work/offered" ;;
      *) grep -qxF -e "$word" "$work/offered" ;;
    esac || {
      echo "FAILED: $shell, \"$COMPLETE_LINE\": $word; offered were:" && cat "$work/offered"
      exit 1
    }
  done
}

offers 'fantail ' fly bench '!limits'
offers 'fantail bench ' limits watch '!fly'
offers 'fantail bench limits --c' --can --canard --color '!--out'
offers 'fantail fly ' tasha3_launch1 tasha3_launch2 tunnel_steps flown.ftl
offers 'fantail fly --json tasha3_l' tasha3_launch2 '!tunnel_steps'
offers 'fantail plan check tunnel_f' tunnel_free '!tunnel_flow' # plans, not scenarios
offers 'fantail airframe tasha3_b' tasha3_bench
offers 'fantail fly --set controller.' controller.canard_limit_deg= '!body.mass_kg='
offers 'fantail fly --set ' controller.canard_limit_deg= body.mass_kg= wind.speed_m_s=
offers 'fantail replay --set ' controller.canard_limit_deg= '!body.mass_kg='
offers 'fantail identify --method ' grid continuous both '!grid|continuous|both'
offers 'fantail replay f' flown.ftl flights
offers 'fantail fly --out f' flights '!flown.ftl'
# What bash calls a word begins behind the =.
case $shell in bash) before='' ;; *) before=reference.kind= ;; esac
offers 'fantail fly --set reference.kind=' "${before}hold" "${before}steps" "${before}square_wave"
case $shell in bash) before='' ;; *) before=--color= ;; esac
offers 'fantail fly --color=a' "${before}auto" "${before}always" "!${before}never"
# Behind a -- stand arguments alone.
offers 'fantail replay -- --o' !--out
# A program that is not there answers nothing, and nobody complains.
COMPLETE_LINE='no_such_folder/fantail repl'
"$shell" $alone "$tests/complete.$shell" >"$work/offered" 2>&1 || true
[ -z "$(tr -d '[:space:]' <"$work/offered")" ] || { echo "FAILED: $shell without the program:" && cat "$work/offered" && exit 1; }
case $shell in
  bash)
    offers 'fantail replay t' 'two?lines.ftl' !lines.ftl
    # Behind a quote that is open bash replaces what is within.
    offers 'fantail fly --set "controller.canard_l' controller.canard_limit_deg=
    offers "fantail fly --set 'controller.canard_l" controller.canard_limit_deg=
    offers 'fantail fly --set="controller.canard_l' controller.canard_limit_deg=
    offers 'fantail fly --out="f' flights '!flown.ftl'
    # With = taken out of what bash takes words apart at, it replaces the whole word.
    export COMPLETE_BREAKS=': '
    offers 'fantail fly --color=a' --color=auto --color=always
    offers 'fantail fly --set reference.kind=h' reference.kind=hold
    offers 'fantail fly --set=controller.canard_l' --set=controller.canard_limit_deg=
    offers 'fantail fly --out=f' --out=flights/ # bash would not see that it is one
    offers 'fantail fly --out="f' flights
    offers 'fantail fly --set "reference.kind=h' reference.kind=hold
    ;;
  fish)
    offers 'fantail replay my\ flights/' 'my flights/first.ftl'
    offers 'fantail replay "my f' 'my flights'
    offers 'fantail fly --out "my f' 'my flights'
    offers 'fantail replay ~/at' '~/at_home.ftl'
    offers 'fantail replay -- --o' --odd.ftl
    ;;
esac
