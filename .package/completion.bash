# SPDX-License-Identifier: GPL-3.0-or-later
# Completes options from --help and, after --set, the keys of the case on the command line from --tables.
_tiprub() {
  local word=$2 before=$3 case
  if [[ $before == --set ]]; then
    case=$(printf '%s\n' "${COMP_WORDS[@]}" | grep -m 1 '\.toml$')
    compopt -o nospace
    COMPREPLY=($(compgen -S = -W "$("$1" "$case" --tables 2>/dev/null |
      sed -n -e 's/^\[\(.*\)\]$/\1./; t table; s/^\([a-z_]*\) = .*/\1/; T; G; s/\(.*\)\n\(.*\)/\2\1/p; d; :table; h')" -- "$word"))
  elif [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$("$1" --help | sed -n '/^Options:/,$p' | grep -oE '^  (-[a-z],)?--?[a-z-]+' | tr ',' ' ')" -- "$word"))
  fi
}
complete -o default -F _tiprub tiprub-mesh tiprub-reduce tiprub-simulate tiprub-postprocess
