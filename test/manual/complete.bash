# SPDX-License-Identifier: MIT
# Prints what bash offers at the end of $COMPLETE_LINE, one word a line, folders without a slash.
source "$COMPLETIONS/fantail.bash"
compopt() { :; } # bash has it only while somebody presses the key

# As bash takes the line apart: at blanks, and at = and : , which are words of their own.
COMP_LINE=$COMPLETE_LINE
COMP_POINT=${#COMP_LINE}
COMP_WORDS=()
spaced=${COMP_LINE//=/ = }
spaced=${spaced//:/ : }
read -ra COMP_WORDS <<<"$spaced"
[[ $COMP_LINE != *[[:space:]] ]] || COMP_WORDS+=("")
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
complete -p fantail >/dev/null
_fantail fantail "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\n' "${COMPREPLY[@]}"
