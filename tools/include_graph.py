#!/usr/bin/env python3
# Copyright the limpet authors. GPL-3.0-or-later.
"""Shows how the folders of the house hang together, and how long files and functions are.

    tools/include_graph.py [ROOT]        ROOT: the sources, by default the folder above this one

For each folder, from the ground up: which folders its files include from, and in how many #include lines. For
model/, the same by file: how many headers of model/ a file includes, and how many files include it. Then the
lengths of files (lines) and of functions (lines from the first of the signature to the closing brace) as median,
90 % quantile and largest. Functions are found by universal-ctags and left out where it is not installed.
"""
import collections
import json
import pathlib
import re
import shutil
import subprocess
import sys

FOLDERS = ["audit", "geometry", "model", "io", "survey", "kinematics", "following", "simulation", "evaluation",
           "drawing", "app"]
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]', re.MULTILINE)


def sources(root, folder):
    return sorted(path for path in (root / folder).rglob("*") if path.suffix in (".cpp", ".hpp"))


def included(path, folder):
    """The (folder, header) pairs of the house that a file includes."""
    for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
        parts = name.split("/")
        if parts[0] == "limpet" and len(parts) == 3:
            yield parts[1], parts[2]
        elif len(parts) == 1 and (path.parent / name).exists():
            yield folder, name


def folder_graph(root, folders):
    print("folder -> folders it includes from (lines)")
    for folder in folders:
        lines = collections.Counter(target for path in sources(root, folder)
                                    for target, _ in included(path, folder) if target != folder)
        targets = sorted(lines, key=lambda name: FOLDERS.index(name) if name in FOLDERS else -1)
        upward = [name for name in targets if FOLDERS.index(name) > FOLDERS.index(folder)]
        print(f"  {folder:12}" + (", ".join(f"{name} {lines[name]}" for name in targets) or "-")
              + (f"    UPWARD: {', '.join(upward)}" if upward else ""))


def file_graph(root, folder):
    out, into = {}, collections.Counter()
    for path in sources(root, folder):
        headers = {name for target, name in included(path, folder) if target == folder}
        out[path.name] = len(headers)
        into.update(headers)
    print(f"{folder}/ by file: headers of {folder}/ that it includes, files of {folder}/ that include it")
    for name in sorted(out, key=lambda name: (-into[name], name)):
        print(f"  {name:32}{out[name]:4}{into[name]:4}")


def functions(path):
    """The lengths of a file's functions, by universal-ctags."""
    tags = subprocess.run(["ctags", "--output-format=json", "--fields=+ne", "--languages=C++", "--map-C++=+.hpp",
                           "--kinds-C++=f", "-f", "-", path], check=True, capture_output=True, text=True).stdout
    for line in tags.splitlines():
        tag = json.loads(line)
        if "end" in tag:
            yield tag["end"] - tag["line"] + 1, f"{path.name}:{tag['line']} {tag['name']}"


def print_lengths(what, lengths):
    lengths = sorted(lengths)
    if lengths:
        sizes = [size for size, _ in lengths]
        print(f"  {what:12}{len(sizes):5}   median {sizes[len(sizes) // 2]:4}   90 % {sizes[len(sizes) * 9 // 10]:4}"
              f"   largest {sizes[-1]:4}  {lengths[-1][1]}")


def print_all_lengths(root, folders, title, lengths_of):
    print(title)
    everything = []
    for folder in folders:
        lengths = [length for path in sources(root, folder) for length in lengths_of(path)]
        print_lengths(folder, lengths)
        everything += lengths
    print_lengths("all", everything)


def main():
    if len(sys.argv) > 2 or (len(sys.argv) == 2 and not pathlib.Path(sys.argv[1]).is_dir()):
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1] if len(sys.argv) == 2 else pathlib.Path(__file__).resolve().parent.parent)
    folders = [folder for folder in FOLDERS if (root / folder).is_dir()]
    folder_graph(root, folders)
    file_graph(root, "model")
    print_all_lengths(root, folders, "files (lines)",
                      lambda path: [(len(path.read_text(encoding="utf-8").splitlines()), path.name)])
    if shutil.which("ctags"):
        print_all_lengths(root, folders, "functions (lines)", functions)


if __name__ == "__main__":
    main()
