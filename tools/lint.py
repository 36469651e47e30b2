#!/usr/bin/env python3
"""clang-tidy over the whole tree in a few minutes: nearly all of its time goes to what sources include, so that all
sources of the program are looked at as one, all tests as another, and each benchmark's.

    tools/lint.py BUILD [--jobs N]     BUILD: configured with the preset `lint`

Names that sources of one folder have for themselves are therefore different ones.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import shlex
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
OURS = rf"(/limpet/[a-z]+/|^{SOURCE}/[a-z]+/)[a-z0-9_/]+\.[ch]pp$"
# The same sources with other definitions, and files that are not to compile.
TWICE = ("float", "counted", "tests/build/")
# Units include sources, which nothing of ours may.
CHECKS = "--checks=-bugprone-suspicious-include"
# What clang 22 does not take of Boost 1.74 and CGAL 5.5.
READING = [f"--extra-arg-before={flag}" for flag in (
    "-fdelayed-template-parsing", "-include", f"{SOURCE}/tools/lint_prelude.hpp")]


def flags_of(command):
    """What the compiler is told, without the file, its output, and what only GCC knows."""
    words = shlex.split(command)
    words = words[2:] if words[0].endswith("ccache") else words[1:]
    flags, skip = [], False
    for word in words:
        if skip:
            skip = False
        elif word in ("-o", "-MF", "-MT", "-c", "--param"):
            skip = True
        elif word != "-MD" and not word.startswith("-W"):
            flags.append(word)
    return flags


def unit_of(entry):
    folder = pathlib.Path(entry["file"]).relative_to(SOURCE).parts[0]
    if folder == "benchmarks":  # each program has its own main
        return re.search(r"(\w+)\.dir/", entry["command"]).group(1)
    return folder if folder == "tests" else "limpet"


class Unit:
    """Sources that are looked at as one, with the flags of all."""

    def __init__(self, name):
        self.name, self.files, self.flags = name, set(), {}

    def add(self, entry):
        self.files.add(entry["file"])
        for flag in flags_of(entry["command"]):
            name, _, value = flag.partition("=")
            if name.startswith("-D") and self.flags.setdefault(name, value) != value:
                sys.exit(f"lint: {self.name}: {name[2:]} has two values")
            if not name.startswith("-D"):
                self.flags[flag] = ""

    def look(self, build):
        """What is wrong with it; nothing where all is well."""
        file = build / "units" / f"{self.name}.cpp"
        file.parent.mkdir(exist_ok=True)
        file.write_text("".join(f'#include "{source}"\n' for source in sorted(self.files)))
        flags = [f"{name}={value}" if value else name for name, value in self.flags.items()]
        done = subprocess.run(["clang-tidy-22", "--quiet", CHECKS, *READING, f"--header-filter={OURS}", str(file), "--", *flags,
                               "-Wno-everything"], cwd=SOURCE, capture_output=True, text=True, errors="replace")
        return "" if done.returncode == 0 else done.stdout or done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    units = {}
    for entry in json.loads((args.build / "compile_commands.json").read_text()):
        if entry["file"].endswith(".cpp") and not any(part in entry["file"] + entry["command"] for part in TWICE):
            units.setdefault(unit_of(entry), Unit(unit_of(entry))).add(entry)
    longest_first = sorted(units.values(), key=lambda unit: -len(unit.files))
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        found = list(pool.map(lambda unit: unit.look(args.build), longest_first))
    print("".join(found), end="")
    print(f"clang-tidy: {sum(len(unit.files) for unit in longest_first)} sources looked at")
    return 1 if any(found) else 0


if __name__ == "__main__":
    sys.exit(main())
