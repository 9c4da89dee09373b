#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the completions of bash, zsh and fish from what the programs print with --help.

Usage: generate.py PALPATE PALPATE-CLI PALPATE-FETCH          fails where the files here are not current
       generate.py PALPATE PALPATE-CLI PALPATE-FETCH --write  writes them
"""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
HEAD = "SPDX-License-Identifier: BSD-3-Clause\n# Made by generate.py from --help; not to be changed by hand.\n"


def helped(program, *words):
    return subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True).stdout


def options(text):
    """{"--name": (short name or "", choices, takes a value, description)} and the subcommands."""
    found, commands, part, last = {}, {}, "", None
    for line in text.splitlines():
        if re.match(r"^\S.*:$", line):
            part = line[:-1]
            continue
        option = re.match(r"^  (-\S+)(?: (\S.*?))?(?:  +(\S.*))?$", line)
        if part == "Options" and option:
            names, kind, words = option.groups()
            if kind and not words and not re.match(r"^[A-Z]+(:|$| )", kind):
                kind, words = None, kind
            kind = kind or ""
            short = [name for name in names.split(",") if not name.startswith("--")]
            choices = re.search(r"\{([^}]*)\}", kind)
            last = [short[0] if short else "", choices.group(1).split(",") if choices else [],
                    bool(re.match(r"(TEXT|INT|UINT|FLOAT|HOST:PORT|ADDRESS:PORT)", kind)), words or ""]
            found |= {name: last for name in names.split(",") if name.startswith("--")}
        elif part == "Options" and last and re.match(r"^ {20,}\S", line):
            last[3] = (last[3] + " " + line.strip()).strip()
        elif part == "Subcommands" and (command := re.match(r"^  (\S+)  +(.*)$", line)):
            commands[command.group(1)] = command.group(2)
    for option in found.values():  # names that only the description lists
        listed = re.match(r"^((?:[a-z0-9-]+, )+[a-z0-9-]+)(?:,|$)", option[3])
        if not option[1] and option[2] and listed:
            option[1] = listed.group(1).split(", ")
    return found, commands


def tree(program):
    """{"": …, "run": …, "study accuracy": …}: options and subcommands of each command."""
    whole = {"": options(helped(program))}
    for command in whole[""][1]:
        whole[command] = options(helped(program, command))
        for leaf in whole[command][1]:
            whole[f"{command} {leaf}"] = options(helped(program, command, leaf))
    return whole


def names(found):
    return [name for option, (short, *_) in found.items() for name in (short, option) if name]


def bash(program, commands):
    function = "_" + program.replace("-", "_")
    lines = [f"# {HEAD}{function}() {{", "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}",
             "  local command= i", "  for ((i = 1; i < COMP_CWORD; ++i)); do", '    case "$command ${COMP_WORDS[i]}" in']
    for name in commands:
        if name:
            first, _, second = name.rpartition(" ")
            lines.append(f'      "{first} {second}") command="{name}" ;;')
    lines += ["      *) ;;", "    esac", "  done", '  case "$command $before" in']
    for name, (found, _) in commands.items():
        for option, (short, choices, value, _) in found.items():
            keys = " | ".join(f'"{name} {key}"' for key in (short, option) if key)
            if choices:
                lines.append(f'    {keys}) mapfile -t COMPREPLY < <(compgen -W "{" ".join(choices)}" -- "$word")'
                             + ("; return ;;" if option not in ("--tool", "--hand") else
                                '; compopt -o default; return ;;'))
            elif value:
                lines.append(f"    {keys}) compopt -o default; return ;;")
    lines += ["    *) ;;", "  esac", '  case "$command" in']
    for name, (found, leaves) in commands.items():
        words = " ".join([*leaves, *names(found)])
        lines.append(f'    "{name}") mapfile -t COMPREPLY < <(compgen -W "{words}" -- "$word") ;;')
    lines += ["    *) ;;", "  esac", "  [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default", "}",
              f"complete -F {function} {program}", ""]
    return "\n".join(lines)


def quoted(text):
    return text.replace("'", "'\\''").replace("[", "(").replace("]", ")").replace(":", " -")


def zsh(program, commands):
    def specs(found):
        for option, (short, choices, value, words) in found.items():
            kind = (":value:(" + " ".join(choices) + ")" if choices else ":value:_files") if value else ""
            for key in (short, option):
                if key:
                    yield f"    '{key}[{quoted(words)}]{kind}' \\"

    function = "_" + program
    lines = [f"#compdef {program}", f"# {HEAD}", f"{function}() {{"]
    if len(commands) == 1:
        lines += ["  _arguments \\", *specs(commands[""][0]), "    '*:file:_files'"]
    else:
        lines += ["  local command=", "  local word", "  for word in ${words[2,CURRENT-1]}; do",
                  '    case "$command $word" in']
        for name in commands:
            if name:
                first, _, second = name.rpartition(" ")
                lines.append(f'      "{first} {second}") command="{name}" ;;')
        lines += ["    esac", "  done", '  case "$command" in']
        for name, (found, leaves) in commands.items():
            lines.append(f'    "{name}")')
            if leaves:
                listed = " ".join(f"'{leaf}:{quoted(words)}'" for leaf, words in leaves.items())
                lines += [f"    local -a known=({listed})", "    _describe command known"]
            lines += ["    _arguments \\", *specs(found), "    '*:file:_files' ;;"]
        lines += ["  esac"]
    lines += ["}", "", f'{function} "$@"', ""]
    return "\n".join(lines)


def fish(program, commands):
    lines = [f"# {HEAD}".rstrip()]
    for name, (found, leaves) in commands.items():
        words = name.split()
        if words:
            condition = "; and ".join(f"__fish_seen_subcommand_from {word}" for word in words)
        else:
            condition = "__fish_use_subcommand" if leaves else ""
        given = f" -n '{condition}'" if condition else ""
        for leaf, text in leaves.items():
            known = "; and not __fish_seen_subcommand_from " + " ".join(leaves) if words else ""
            only = f" -n '{condition}{known}'" if condition else ""
            lines.append(f"complete -c {program}{only} -f -a {leaf} -d '{quoted(text)}'")
        for option, (short, choices, value, text) in found.items():
            parts = f"complete -c {program}{given} -l {option[2:]}" + (f" -s {short[1:]}" if short else "")
            if choices:
                parts += f" -x -a '{' '.join(choices)}'"
            elif value:
                parts += " -r -F"
            lines.append(f"{parts} -d '{quoted(text)}'")
    return "\n".join(lines) + "\n"


def main():
    wrong = 0
    for path in sys.argv[1:4]:
        program = pathlib.Path(path).name
        commands = tree(path)
        for name, text in ((f"{program}.bash", bash(program, commands)), (f"_{program}", zsh(program, commands)),
                           (f"{program}.fish", fish(program, commands))):
            if "--write" in sys.argv:
                (HERE / name).write_text(text)
            elif not (HERE / name).exists() or (HERE / name).read_text() != text:
                print(f"{name} is not what --help says; run packaging/completions/generate.py with --write.")
                wrong += 1
    print(f"{wrong} wrong.")
    return 1 if wrong else 0


sys.exit(main())
