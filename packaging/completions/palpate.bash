# SPDX-License-Identifier: BSD-3-Clause
# Made by generate.py from --help; not to be changed by hand.
_palpate() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
  local command= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
      *) ;;
    esac
  done
  case "$command $before" in
    " --phantom") mapfile -t COMPREPLY < <(compgen -W "demo mastoid sphere halfspace torus gyroid wedge hole slot cylinder marker" -- "$word"); return ;;
    " --isovalue") compopt -o default; return ;;
    " --tool") mapfile -t COMPREPLY < <(compgen -W "burr-1 burr-2 burr-3 burr-4 burr-6 drill probe curved-probe hook elevator needle sphere cane wrench peg" -- "$word"); compopt -o default; return ;;
    " --tool-unit") mapfile -t COMPREPLY < <(compgen -W "m mm cm in" -- "$word"); return ;;
    " --hand") mapfile -t COMPREPLY < <(compgen -W "mouse tap slide wedge pry hook jerk twist" -- "$word"); compopt -o default; return ;;
    " --surface") mapfile -t COMPREPLY < <(compgen -W "raycast mesh" -- "$word"); return ;;
    " --series") compopt -o default; return ;;
    " --labels") compopt -o default; return ;;
    " --screenshot") compopt -o default; return ;;
    " --after") compopt -o default; return ;;
    " --log-level") mapfile -t COMPREPLY < <(compgen -W "error warning info debug off" -- "$word"); return ;;
    *) ;;
  esac
  case "$command" in
    "") mapfile -t COMPREPLY < <(compgen -W "-h --help --version --phantom --isovalue --tool --tool-unit --hand --surface --series --labels --correct --screenshot --after --no-notice --log-level" -- "$word") ;;
    *) ;;
  esac
  [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default
}
complete -F _palpate palpate
