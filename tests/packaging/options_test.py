#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each option that the programs print with --help is described in the help and in the man pages, and
the help describes no other.

Usage: options_test.py ROOT PALPATE PALPATE-CLI PALPATE-FETCH
"""
import pathlib
import re
import subprocess
import sys

root, window = pathlib.Path(sys.argv[1]), sys.argv[2]


def helped(*command):
    """(names of the options, names of the subcommands)"""
    text = subprocess.run([*command, "--help"], capture_output=True, text=True, check=True).stdout
    options = {name for line in re.findall(r"^  (-\S+)", text, re.M) for name in line.split(",")}
    part = text.partition("Subcommands:\n")[2]
    return options, re.findall(r"^  (\S+)  ", part, re.M)


def described(text):
    """The options that lines of a page name first: "- `-h`, `--help`: …"."""
    found = set()
    for line in re.findall(r"^- (`-.*?`):", text, re.M):
        found |= {name.split()[0] for name in re.findall(r"`(-[^`]*)`", line)}
    return found


def sections(text):
    parts = re.split(r"^## (.*)$", text, flags=re.M)
    return dict(zip(parts[1::2], parts[2::2]))


wrong = []


def compare(what, printed, told):
    wrong.extend(f"{what}: the help does not describe {name}" for name in sorted(printed - told))
    wrong.extend(f"{what}: there is no {name}" for name in sorted(told - printed))


page = (root / "resources/help/palpate.md").read_text()
compare("palpate", helped(window)[0], described(page))

count = 0
for path, shared in ((sys.argv[3], "Choosing a volume"), (sys.argv[4], "Choosing a server")):
    program = pathlib.Path(path).name
    page = sections((root / f"resources/help/{program}.md").read_text())
    common = described(page["Description"])
    takers = set(re.findall(r"`(\w+)`", page[shared].split(" take these")[0]))
    options, commands = helped(path)
    for name in commands:
        if name not in page:
            wrong.append(f"{program} {name}: the help has no section for it")
            continue
        printed, leaves = helped(path, name)
        for leaf in leaves:
            printed |= helped(path, name, leaf)[0]
        told = described(page[name]) | (described(page[shared]) if name in takers else set())
        compare(f"{program} {name}", printed - common, told)
    compare(program, options, common - {"--json"})
    if len(commands) < 3:
        wrong.append(f"{program} has {len(commands)} commands")
    count += len(commands)

for program in ("palpate", "palpate-cli", "palpate-fetch"):
    man = (root / f"packaging/man/{program}.1").read_text().replace("\\-", "-")
    told = described((root / f"resources/help/{program}.md").read_text())
    wrong += [f"{program}.1 lacks {name}" for name in sorted(told) if name not in man]

print(*wrong, f"{count} commands, {len(wrong)} wrong.", sep="\n")
sys.exit(1 if wrong else 0)
