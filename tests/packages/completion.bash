#!/usr/bin/env bash
# Bash completes verbs, flags and choices as the program has them. Argument: the program.
set -euo pipefail

source /dev/stdin <<< "$("$1" --bash-completion)"

# expect WANTED WORD...: completing the last word offers WANTED among others, or exactly nothing for "".
expect() {
    local wanted=$1
    shift
    COMP_WORDS=(reflectance "$@")
    COMP_CWORD=$#
    _reflectance || true # compgen answers 1 where it finds nothing
    if [[ -z $wanted ]]; then
        ((${#COMPREPLY[@]} == 0)) || { echo "'$*' offers ${COMPREPLY[*]}" >&2; exit 1; }
    elif [[ " ${COMPREPLY[*]} " != *" $wanted "* ]]; then
        echo "'$*' does not offer $wanted but ${COMPREPLY[*]}" >&2
        exit 1
    fi
}

expect render ren
expect --backend render --back
expect gl render --backend g
expect oren_nayar_full render --model oren
expect info table in
expect --json table info --js
expect double eval --precision d
expect "" render --out nosuch
expect "" render no_such_mesh
