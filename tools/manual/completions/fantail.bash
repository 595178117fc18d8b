# SPDX-License-Identifier: MIT
# Completion of fantail for bash: `source` this file, or have it where bash-completion looks for it. What may stand where the
# cursor is, the program itself says; files are for bash to list.

_fantail() {
  # bash takes words apart at = and :, where the program does not.
  local words=() rest=${COMP_LINE:0:COMP_POINT} piece space i
  for ((i = 0; i <= COMP_CWORD; i++)); do
    space=${rest%%[![:space:]]*}
    rest=${rest#"$space"}
    piece=${COMP_WORDS[i]}
    [[ $rest == "$piece"* ]] || piece=$rest # the cursor is within the word
    rest=${rest#"$piece"}
    if [[ $i -gt 0 && -z $space ]]; then
      words[${#words[@]} - 1]+=$piece
    else
      words+=("$piece")
    fi
  done

  local begun=${words[${#words[@]} - 1]}
  local kept=${begun%"${begun##*[=:]}"} # the part that bash leaves where it is
  local answer word
  mapfile -t answer < <("${words[0]/#\~/$HOME}" --complete "${words[@]:1}" 2>/dev/null)
  COMPREPLY=()
  for word in "${answer[@]:1}"; do
    word=${word%%$'\t'*}
    COMPREPLY+=("${word#"$kept"}")
    [[ $word != *[=:] ]] || compopt -o nospace
  done
  case ${answer[0]} in
    # What bash does itself where it found nothing: a name in quotes.
    files)
      compopt -o filenames -o default
      mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "${begun#"$kept"}")
      ;;
    folders)
      compopt -o filenames -o dirnames
      mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "${begun#"$kept"}")
      ;;
  esac
}

complete -F _fantail fantail
