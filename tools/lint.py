#!/usr/bin/env python3
"""clang-tidy over the whole tree: each folder as one file (preset `lint`), because most of its time goes to what files
include; and again only over what has changed since it passed.

    tools/lint.py BUILD [--jobs N] [--minutes M]     BUILD: configured with the preset `lint`

What is not begun after M minutes is counted, and is first at the next run. What has passed is remembered in
$XDG_CACHE_HOME/limpet-lint (~/.cache).
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parent.parent
CACHE = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "limpet-lint"
OURS = rf"(/limpet/[a-z]+/[a-z0-9_]+\.hpp|^{SOURCE}/(?!build/).*\.[ch]pp)$"
# The same sources with other definitions, and files that are not to compile.
TWICE = ("float", "counted", "tests/build/")


def said_by(command, folder):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace")


def flags_of(entry):
    """What the compiler is told, without the file, its output, and what only GCC knows."""
    words = shlex.split(entry["command"])
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


class Unit:
    def __init__(self, entry):
        self.file, self.folder, self.flags = entry["file"], entry["directory"], flags_of(entry)
        self.name = str(pathlib.Path(self.file).resolve().relative_to(SOURCE))

    def stamp(self, setting):
        """A file that is there when exactly this has passed: the text with all it includes, comments too."""
        text = said_by(["c++", *self.flags, "-E", "-P", "-C", self.file], self.folder)
        if text.returncode:
            return None
        return CACHE / hashlib.sha256((setting + text.stdout).encode()).hexdigest()

    def look(self, setting, end):
        """What is wrong with it; nothing where all is well; None where there was no time to look."""
        stamp = self.stamp(setting)
        if stamp and stamp.exists():
            return ""
        if time.monotonic() > end:
            return None
        # Units that CMake has put together include .cpp files; nothing of ours may.
        checks = ["--checks=-bugprone-suspicious-include"] if "/Unity/" in self.file else []
        done = said_by(["clang-tidy", "--quiet", *checks, f"--header-filter={OURS}", self.file, "--", *self.flags,
                        "-Wno-everything"], self.folder)
        if done.returncode == 0 and stamp:
            CACHE.mkdir(parents=True, exist_ok=True)
            stamp.touch()
        return "" if done.returncode == 0 else done.stdout or done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=float("inf"))
    args = parser.parse_args()
    end = time.monotonic() + 60 * args.minutes
    setting = (SOURCE / ".clang-tidy").read_text() + said_by(["clang-tidy", "--version"], SOURCE).stdout
    database = json.loads((args.build / "compile_commands.json").read_text())
    units = {entry["file"]: Unit(entry) for entry in database if not any(part in entry["file"] for part in TWICE)}
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        found = dict(zip(units, pool.map(lambda unit: unit.look(setting, end), units.values())))
    print("".join(text for text in found.values() if text), end="")
    left = [units[file].name for file, text in found.items() if text is None]
    print(f"clang-tidy: {len(found) - len(left)} of {len(found)} units looked at", flush=True)
    if left:
        print("for want of time not: " + " ".join(left))
    return 1 if any(found.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
