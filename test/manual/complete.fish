# SPDX-License-Identifier: MIT
# Prints what fish offers at the end of $COMPLETE_LINE, one word a line, folders without a slash.
source $COMPLETIONS/fantail.fish
complete -C "$COMPLETE_LINE" | string replace -r '\t.*' '' | string replace -r '/$' ''
true # string says whether it replaced something
