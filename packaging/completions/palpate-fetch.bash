# SPDX-License-Identifier: BSD-3-Clause
# Made by generate.py from --help; not to be changed by hand.
_palpate_fetch() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
  local command= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
      " echo") command="echo" ;;
      " find") command="find" ;;
      " get") command="get" ;;
      " remember") command="remember" ;;
      " forget") command="forget" ;;
      *) ;;
    esac
  done
  case "$command $before" in
    "echo --dicomweb") compopt -o default; return ;;
    "echo --dimse") compopt -o default; return ;;
    "echo --called") compopt -o default; return ;;
    "echo --calling") compopt -o default; return ;;
    "echo --authority") compopt -o default; return ;;
    "echo --certificate") compopt -o default; return ;;
    "echo --key") compopt -o default; return ;;
    "echo --login") mapfile -t COMPREPLY < <(compgen -W "none basic bearer keyring" -- "$word"); return ;;
    "echo --user") compopt -o default; return ;;
    "echo --patience") compopt -o default; return ;;
    "find --dicomweb") compopt -o default; return ;;
    "find --dimse") compopt -o default; return ;;
    "find --called") compopt -o default; return ;;
    "find --calling") compopt -o default; return ;;
    "find --authority") compopt -o default; return ;;
    "find --certificate") compopt -o default; return ;;
    "find --key") compopt -o default; return ;;
    "find --login") mapfile -t COMPREPLY < <(compgen -W "none basic bearer keyring" -- "$word"); return ;;
    "find --user") compopt -o default; return ;;
    "find --patience") compopt -o default; return ;;
    "get --dicomweb") compopt -o default; return ;;
    "get --dimse") compopt -o default; return ;;
    "get --called") compopt -o default; return ;;
    "get --calling") compopt -o default; return ;;
    "get --authority") compopt -o default; return ;;
    "get --certificate") compopt -o default; return ;;
    "get --key") compopt -o default; return ;;
    "get --login") mapfile -t COMPREPLY < <(compgen -W "none basic bearer keyring" -- "$word"); return ;;
    "get --user") compopt -o default; return ;;
    "get --patience") compopt -o default; return ;;
    "get --out") compopt -o default; return ;;
    "get --move") compopt -o default; return ;;
    "remember --dicomweb") compopt -o default; return ;;
    "remember --dimse") compopt -o default; return ;;
    "remember --called") compopt -o default; return ;;
    "remember --calling") compopt -o default; return ;;
    "remember --authority") compopt -o default; return ;;
    "remember --certificate") compopt -o default; return ;;
    "remember --key") compopt -o default; return ;;
    "remember --login") mapfile -t COMPREPLY < <(compgen -W "none basic bearer keyring" -- "$word"); return ;;
    "remember --user") compopt -o default; return ;;
    "remember --patience") compopt -o default; return ;;
    "forget --dicomweb") compopt -o default; return ;;
    "forget --dimse") compopt -o default; return ;;
    "forget --called") compopt -o default; return ;;
    "forget --calling") compopt -o default; return ;;
    "forget --authority") compopt -o default; return ;;
    "forget --certificate") compopt -o default; return ;;
    "forget --key") compopt -o default; return ;;
    "forget --login") mapfile -t COMPREPLY < <(compgen -W "none basic bearer keyring" -- "$word"); return ;;
    "forget --user") compopt -o default; return ;;
    "forget --patience") compopt -o default; return ;;
    *) ;;
  esac
  case "$command" in
    "") mapfile -t COMPREPLY < <(compgen -W "echo find get remember forget -h --help --version" -- "$word") ;;
    "echo") mapfile -t COMPREPLY < <(compgen -W "-h --help --dicomweb --dimse --called --calling --tls --authority --certificate --key --login --user --patience --attached --json" -- "$word") ;;
    "find") mapfile -t COMPREPLY < <(compgen -W "-h --help --dicomweb --dimse --called --calling --tls --authority --certificate --key --login --user --patience --attached --json --names" -- "$word") ;;
    "get") mapfile -t COMPREPLY < <(compgen -W "-h --help --dicomweb --dimse --called --calling --tls --authority --certificate --key --login --user --patience --attached --json --out --move" -- "$word") ;;
    "remember") mapfile -t COMPREPLY < <(compgen -W "-h --help --dicomweb --dimse --called --calling --tls --authority --certificate --key --login --user --patience --attached --json" -- "$word") ;;
    "forget") mapfile -t COMPREPLY < <(compgen -W "-h --help --dicomweb --dimse --called --calling --tls --authority --certificate --key --login --user --patience --attached --json" -- "$word") ;;
    *) ;;
  esac
  [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default
}
complete -F _palpate_fetch palpate-fetch
