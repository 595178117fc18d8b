# SPDX-License-Identifier: MIT
# Prints what zsh offers at the end of $COMPLETE_LINE, one word a line, folders without a slash. A second zsh, in a terminal
# of its own, is sent the line and the key.
zmodload zsh/zpty
zpty shell zsh -f -i
# Without what other packages have for zsh; zsh's own is listed once, in a file.
zpty -w shell "PS1='' fpath=(\$COMPLETIONS \${fpath:#*vendor*})"
zpty -w shell 'stty -echo; autoload -Uz compinit; compinit -C -d $HOME/listed'
# Instead of a menu: each match between two marks.
zpty -w shell 'show() { compadd() { local -a hits; builtin compadd -O hits "$@"; print -rl -- "offered "$^hits; builtin compadd "$@" }; _main_complete; unfunction compadd; print -r END }'
zpty -w shell 'zle -C show complete-word show; bindkey "^I" show; print -r RE""ADY'
local text
zpty -r shell text '*READY*' # not what is typed, which has quotes in it
zpty -w -n shell "$COMPLETE_LINE"$'\t'
zpty -r shell text '*END*'
print -r -- "$text" | tr -d '\r' | sed -n 's/^.*offered //p' | sed 's|/$||'
zpty -d shell
