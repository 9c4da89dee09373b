# SPDX-License-Identifier: BSD-3-Clause
# Made by generate.py from --help; not to be changed by hand.
_palpate_cli() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
  local command= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
      " info") command="info" ;;
      " convert") command="convert" ;;
      " cohort") command="cohort" ;;
      "cohort merge") command="cohort merge" ;;
      " devices") command="devices" ;;
      " tool") command="tool" ;;
      " run") command="run" ;;
      " replay") command="replay" ;;
      " recover") command="recover" ;;
      " surface") command="surface" ;;
      " export") command="export" ;;
      " study") command="study" ;;
      "study accuracy") command="study accuracy" ;;
      "study stability") command="study stability" ;;
      "study plan") command="study plan" ;;
      "study merge") command="study merge" ;;
      *) ;;
    esac
  done
  case "$command $before" in
    "info --series") compopt -o default; return ;;
    "info --every") compopt -o default; return ;;
    "info --box") compopt -o default; return ;;
    "info --labels") compopt -o default; return ;;
    "convert --phantom") compopt -o default; return ;;
    "convert --series") compopt -o default; return ;;
    "convert --every") compopt -o default; return ;;
    "convert --box") compopt -o default; return ;;
    "cohort --isovalue") mapfile -t COMPREPLY < <(compgen -W "bone skin" -- "$word"); return ;;
    "cohort --tool") compopt -o default; return ;;
    "cohort --hand") compopt -o default; return ;;
    "cohort --repetitions") compopt -o default; return ;;
    "cohort --seconds") compopt -o default; return ;;
    "cohort --stiffness") compopt -o default; return ;;
    "cohort --angular-stiffness") compopt -o default; return ;;
    "cohort --friction") compopt -o default; return ;;
    "cohort --field") mapfile -t COMPREPLY < <(compgen -W "trilinear spline" -- "$word"); return ;;
    "cohort --normals") mapfile -t COMPREPLY < <(compgen -W "central cell spline" -- "$word"); return ;;
    "cohort --epsilon") compopt -o default; return ;;
    "cohort --sub-steps") compopt -o default; return ;;
    "cohort --budget") compopt -o default; return ;;
    "cohort --rate") mapfile -t COMPREPLY < <(compgen -W "1000 2000 4000" -- "$word"); return ;;
    "cohort --seed") compopt -o default; return ;;
    "cohort --tool-mesh") compopt -o default; return ;;
    "cohort --tool-unit") mapfile -t COMPREPLY < <(compgen -W "m mm cm in" -- "$word"); return ;;
    "cohort --shard") compopt -o default; return ;;
    "cohort --jobs") compopt -o default; return ;;
    "cohort merge --out") compopt -o default; return ;;
    "cohort merge --before") compopt -o default; return ;;
    "cohort merge --isovalue") mapfile -t COMPREPLY < <(compgen -W "bone skin" -- "$word"); return ;;
    "cohort merge --tool") compopt -o default; return ;;
    "cohort merge --hand") compopt -o default; return ;;
    "cohort merge --repetitions") compopt -o default; return ;;
    "cohort merge --seconds") compopt -o default; return ;;
    "cohort merge --stiffness") compopt -o default; return ;;
    "cohort merge --angular-stiffness") compopt -o default; return ;;
    "cohort merge --friction") compopt -o default; return ;;
    "cohort merge --field") mapfile -t COMPREPLY < <(compgen -W "trilinear spline" -- "$word"); return ;;
    "cohort merge --normals") mapfile -t COMPREPLY < <(compgen -W "central cell spline" -- "$word"); return ;;
    "cohort merge --epsilon") compopt -o default; return ;;
    "cohort merge --sub-steps") compopt -o default; return ;;
    "cohort merge --budget") compopt -o default; return ;;
    "cohort merge --rate") mapfile -t COMPREPLY < <(compgen -W "1000 2000 4000" -- "$word"); return ;;
    "cohort merge --seed") compopt -o default; return ;;
    "cohort merge --tool-mesh") compopt -o default; return ;;
    "cohort merge --tool-unit") mapfile -t COMPREPLY < <(compgen -W "m mm cm in" -- "$word"); return ;;
    "tool --points") compopt -o default; return ;;
    "tool --tool-unit") mapfile -t COMPREPLY < <(compgen -W "m mm cm in" -- "$word"); return ;;
    "tool --out") compopt -o default; return ;;
    "run --volume") compopt -o default; return ;;
    "run --phantom") compopt -o default; return ;;
    "run --series") compopt -o default; return ;;
    "run --every") compopt -o default; return ;;
    "run --box") compopt -o default; return ;;
    "run --isovalue") compopt -o default; return ;;
    "run --tool") mapfile -t COMPREPLY < <(compgen -W "burr-2 burr-4 burr-6 drill probe curved-probe hook elevator needle sphere cane wrench peg" -- "$word"); compopt -o default; return ;;
    "run --points") compopt -o default; return ;;
    "run --tool-unit") mapfile -t COMPREPLY < <(compgen -W "m mm cm in" -- "$word"); return ;;
    "run --hand") mapfile -t COMPREPLY < <(compgen -W "tap slide wedge pry hook jerk twist" -- "$word"); compopt -o default; return ;;
    "run --seconds") compopt -o default; return ;;
    "run --stiffness") compopt -o default; return ;;
    "run --angular-stiffness") compopt -o default; return ;;
    "run --friction") compopt -o default; return ;;
    "run --epsilon") compopt -o default; return ;;
    "run --sub-steps") compopt -o default; return ;;
    "run --budget") compopt -o default; return ;;
    "run --field") mapfile -t COMPREPLY < <(compgen -W "spline trilinear" -- "$word"); return ;;
    "run --normal") mapfile -t COMPREPLY < <(compgen -W "cell central spline" -- "$word"); return ;;
    "run --normals") mapfile -t COMPREPLY < <(compgen -W "cell central spline" -- "$word"); return ;;
    "run --device") compopt -o default; return ;;
    "run --rate") mapfile -t COMPREPLY < <(compgen -W "1000 2000 4000" -- "$word"); return ;;
    "run --trace") compopt -o default; return ;;
    "run --record") compopt -o default; return ;;
    "run --seed") compopt -o default; return ;;
    "replay --volume") compopt -o default; return ;;
    "replay --phantom") compopt -o default; return ;;
    "replay --series") compopt -o default; return ;;
    "replay --every") compopt -o default; return ;;
    "replay --box") compopt -o default; return ;;
    "surface --phantom") compopt -o default; return ;;
    "surface --series") compopt -o default; return ;;
    "surface --every") compopt -o default; return ;;
    "surface --box") compopt -o default; return ;;
    "surface --isovalue") compopt -o default; return ;;
    "surface --out") compopt -o default; return ;;
    "surface --frame") mapfile -t COMPREPLY < <(compgen -W "lps ras" -- "$word"); return ;;
    "surface --view") compopt -o default; return ;;
    "export --format") mapfile -t COMPREPLY < <(compgen -W "csv motion-bids hdf5 mcap video" -- "$word"); return ;;
    "export --out") compopt -o default; return ;;
    "export --from") compopt -o default; return ;;
    "export --to") compopt -o default; return ;;
    "export --rate") compopt -o default; return ;;
    "export --volume") compopt -o default; return ;;
    "export --phantom") compopt -o default; return ;;
    "export --series") compopt -o default; return ;;
    "export --every") compopt -o default; return ;;
    "export --box") compopt -o default; return ;;
    "export --size") compopt -o default; return ;;
    "export --fps") compopt -o default; return ;;
    "export --speed") compopt -o default; return ;;
    "export --camera") mapfile -t COMPREPLY < <(compgen -W "recorded fixed" -- "$word"); return ;;
    "export --surface") mapfile -t COMPREPLY < <(compgen -W "raycast mesh" -- "$word"); return ;;
    "export --view") compopt -o default; return ;;
    "study accuracy --seed") compopt -o default; return ;;
    "study accuracy --shard") compopt -o default; return ;;
    "study accuracy --out") compopt -o default; return ;;
    "study stability --seed") compopt -o default; return ;;
    "study stability --shard") compopt -o default; return ;;
    "study stability --out") compopt -o default; return ;;
    "study plan --seed") compopt -o default; return ;;
    "study plan --shard") compopt -o default; return ;;
    "study plan --out") compopt -o default; return ;;
    "study merge --out") compopt -o default; return ;;
    *) ;;
  esac
  case "$command" in
    "") mapfile -t COMPREPLY < <(compgen -W "info convert cohort devices tool run replay recover surface export study -h --help --version" -- "$word") ;;
    "info") mapfile -t COMPREPLY < <(compgen -W "-h --help --series --correct --largest-part --every --box --labels --names --json" -- "$word") ;;
    "convert") mapfile -t COMPREPLY < <(compgen -W "-h --help --phantom --series --correct --largest-part --every --box --json" -- "$word") ;;
    "cohort") mapfile -t COMPREPLY < <(compgen -W "merge -h --help --isovalue --tool --hand --repetitions --seconds --stiffness --angular-stiffness --friction --field --normals --epsilon --sub-steps --budget --rate --seed --tool-mesh --tool-unit --shard --jobs --plan --json" -- "$word") ;;
    "cohort merge") mapfile -t COMPREPLY < <(compgen -W "-h --help --out --before --isovalue --tool --hand --repetitions --seconds --stiffness --angular-stiffness --friction --field --normals --epsilon --sub-steps --budget --rate --seed --tool-mesh --tool-unit --json" -- "$word") ;;
    "devices") mapfile -t COMPREPLY < <(compgen -W "-h --help --json" -- "$word") ;;
    "tool") mapfile -t COMPREPLY < <(compgen -W "-h --help --points --tool-unit --out --json" -- "$word") ;;
    "run") mapfile -t COMPREPLY < <(compgen -W "-h --help --volume --phantom --series --correct --largest-part --every --box --isovalue --tool --points --tool-unit --hand --seconds --stiffness --angular-stiffness --friction --epsilon --sub-steps --budget --field --normal --normals --device --rate --trace --record --epoch --open-hash --seed --json" -- "$word") ;;
    "replay") mapfile -t COMPREPLY < <(compgen -W "-h --help --volume --phantom --series --correct --largest-part --every --box --json" -- "$word") ;;
    "recover") mapfile -t COMPREPLY < <(compgen -W "-h --help --json" -- "$word") ;;
    "surface") mapfile -t COMPREPLY < <(compgen -W "-h --help --phantom --series --correct --largest-part --every --box --isovalue --out --frame --largest --view --json" -- "$word") ;;
    "export") mapfile -t COMPREPLY < <(compgen -W "-h --help --format --out --from --to --rate --no-contacts --volume --phantom --series --correct --largest-part --every --box --size --fps --speed --burn-in --camera --surface --slices --view --json" -- "$word") ;;
    "study") mapfile -t COMPREPLY < <(compgen -W "accuracy stability plan merge -h --help" -- "$word") ;;
    "study accuracy") mapfile -t COMPREPLY < <(compgen -W "-h --help --quick --seed --shard --out --json" -- "$word") ;;
    "study stability") mapfile -t COMPREPLY < <(compgen -W "-h --help --quick --seed --shard --out --json" -- "$word") ;;
    "study plan") mapfile -t COMPREPLY < <(compgen -W "-h --help --quick --seed --shard --out --json" -- "$word") ;;
    "study merge") mapfile -t COMPREPLY < <(compgen -W "-h --help --out --json" -- "$word") ;;
    *) ;;
  esac
  [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default
}
complete -F _palpate_cli palpate-cli
