# SPDX-License-Identifier: MIT
# Completion of fantail for fish. What may stand where the cursor is, the program itself says; files are for fish to list.

function __fantail_complete
    set -l words (commandline -opc)
    set -l begun (commandline -ct)
    set -l program (string replace -r '^~' $HOME -- $words[1])
    set -e words[1]
    type -q "$program"; or return
    set -l answer ($program --complete $words "$begun" 2>/dev/null)
    printf '%s\n' $answer[2..-1]
    # Names as fish finds them for a command that it does not know: it reads quotes and ~.
    set -l option (string match -r -- '^--[^=]*=' "$begun")
    set -l path (string replace -r -- '^--[^=]*=' '' "$begun")
    switch "$answer[1]"
        case files
            complete -C "'' -- $path" | string replace -r -- '^' "$option"
        case folders
            __fish_complete_directories "$path" | string replace -r -- '^' "$option"
    end
end

complete -c fantail -f -a '(__fantail_complete)'
