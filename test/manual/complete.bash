# SPDX-License-Identifier: MIT
# Prints what bash offers at the end of $COMPLETE_LINE, one word a line, folders as the completion has them, a line break in it as ?.
# A set $COMPLETE_BREAKS stands for what bash takes words apart at.
set -u # as somebody may have it
COMP_WORDBREAKS=${COMPLETE_BREAKS-$COMP_WORDBREAKS}
source "$COMPLETIONS/fantail.bash"
compopt() { :; } # bash has it only while somebody presses the key

# As bash takes the line apart: at blanks, and at = and : , which are words of their own where they are breaks.
COMP_LINE=$COMPLETE_LINE
COMP_POINT=${#COMP_LINE}
COMP_WORDS=()
spaced=$COMP_LINE
for break in = :; do
  [[ $COMP_WORDBREAKS != *$break* ]] || spaced=${spaced//$break/ $break }
done
read -ra COMP_WORDS <<<"$spaced"
[[ $COMP_LINE != *[[:space:]] ]] || COMP_WORDS+=("")
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
complete -p fantail >/dev/null
_fantail "${COMP_WORDS[0]}" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\n' "${COMPREPLY[@]//$'\n'/?}"
