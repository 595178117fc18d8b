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
  local breaks=${COMP_WORDBREAKS//[^=:]/} kept='' # the part that bash leaves where it is
  [[ -z $breaks ]] || kept=${begun%"${begun##*[$breaks]}"}
  # Behind a quote that is not closed bash replaces what is within.
  local quote='' bare='' ahead=''
  for ((i = 0; i < ${#begun}; i++)); do
    piece=${begun:i:1}
    case $quote,$piece in
      ,\" | ,\') quote=$piece ahead=$bare ;;
      "$quote,$quote") quote='' ;;
      ,\\ | \",\\) bare+=${begun:++i:1} ;;
      *) bare+=$piece ;;
    esac
  done
  [[ -z $quote ]] || begun=$bare kept=$ahead words[${#words[@]} - 1]=$bare
  local answer word
  mapfile -t answer < <("${words[0]/#\~/$HOME}" --complete "${words[@]:1}" 2>/dev/null)
  COMPREPLY=()
  for word in "${answer[@]:1}"; do
    word=${word%%$'\t'*}
    COMPREPLY+=("${word#"$kept"}")
    [[ $word != *[=:] ]] || compopt -o nospace
  done
  # What bash does itself where it found nothing: a name in quotes.
  local kind usual
  case ${answer[0]-} in
    files) kind=-f usual=default ;;
    folders) kind=-d usual=dirnames ;;
    *) return ;;
  esac
  compopt -o filenames -o "$usual"
  local option='' names
  [[ $begun != --*=* ]] || option=${begun%%=*}=
  # A mark ahead of each name, because there may be a line break in it.
  mapfile -t -d $'\1' names < <(compgen -P $'\1' "$kind" -- "${begun#"$option"}")
  for word in "${names[@]:1}"; do
    word=${word%$'\n'}
    piece=$option$word
    piece=${piece#"$kept"}
    # Where the option is a part of the word, bash does not see that it is a folder.
    if [[ $piece != "$word"* && -d ${word/#\~/$HOME} ]]; then
      piece+=/
      compopt -o nospace
    fi
    COMPREPLY+=("$piece")
  done
}

complete -F _fantail fantail
