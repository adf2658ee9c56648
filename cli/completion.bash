# Completion of tedit and tedit-qt for bash: commands, options, operations with their parameters, choices, files. All is
# read from the programs' own help, so that it is never out of date.

# Option names in a help text on stdin.
_tedit_options() {
  sed -nE 's/^ +((-[[:alnum:]], ?)?--[a-z-]+).*/\1/p' | tr -d ' ' | tr ',' '\n'
}

_tedit() {
  local program=$1 current=$2 previous=$3 word command="" group="" operation="" i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    [[ $word == --op ]] && operation=${COMP_WORDS[i + 1]}
    [[ $word == -* || -n $group ]] && continue
    if [[ -z $command ]]; then
      command=$word
    elif [[ $command == plugin || $command == doc || $command == certs || $command == users || $command == config ]]; then
      group=$word
    fi
  done

  # A word that an option wants.
  case $previous in
    --op) mapfile -t COMPREPLY < <(compgen -W "$("$program" ops 2>/dev/null | sed -nE 's/^([a-z]\w*) .*/\1/p')" -- "$current"); return ;;
    --device) mapfile -t COMPREPLY < <(compgen -W "auto cpu lavapipe" -- "$current"); return ;;
    --param)
      word=$("$program" ops "$operation" 2>/dev/null |
        sed -nE 's/^ +(\w+) \((real, m; or (\w+_mm))?.*/\1 \3/p' | tr ' ' '\n' | sed -nE '/^(select)?$/!s/$/=/p')
      mapfile -t COMPREPLY < <(compgen -W "$word" -- "$current")
      compopt -o nospace
      return
      ;;
  esac
  local help choices
  help=$("$program" ${command:+"$command"} ${group:+"$group"} --help 2>/dev/null)
  if [[ $previous == -* ]]; then
    choices=$(grep -oE -- "^ +(-[[:alnum:]],)?$previous [A-Z]+:\{[^}]*\}" <<<"$help" | sed -E 's/.*\{(.*)\}/\1/' | tr ',' ' ')
    if [[ -n $choices ]]; then
      mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$current")
      return
    fi
  fi

  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_tedit_options <<<"$help")" -- "$current")
  elif grep -q '^Subcommands:' <<<"$help"; then
    mapfile -t COMPREPLY < <(compgen -W "$(sed -nE '/^Subcommands:/,/^$/s/^  ([a-z-]+) .*/\1/p' <<<"$help")" -- "$current")
  else
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}

complete -F _tedit tedit
complete -F _tedit tedit-qt
