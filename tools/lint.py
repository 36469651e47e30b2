#!/usr/bin/env python3
"""clang-tidy over the whole tree, many files at a time.

Most of clang-tidy's time goes to the headers that a file includes. Files of one target that have no names in common
are therefore looked at together, as one file that includes them; where they do not compile together after all, half
of them at a time. What is found is said with the file's own name and line.

    tools/lint.py BUILD [--jobs N] [FILE...]     BUILD: a configured folder, with compile_commands.json
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
LARGEST_BATCH = 24

# What a file keeps to itself begins at the first column of an unnamed namespace.
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace\n", re.S | re.M)
TYPE = re.compile(r"^(?:template <[^\n]*>\n)?(?:struct|class|enum class|enum|using) (\w+)", re.M)
VALUE = re.compile(r"^(?!struct|class|enum|using|template|namespace|//|/\*)(?=\w)[\w:<>,&*\[\] ]*?[ &*](\w+)(?:\[\w*\])?(?:\(| =|\{|;)",
                   re.M)
TEST = re.compile(r"^(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP)\((\w+, \w+)", re.M)


def own_names(path):
    text = path.read_text()
    names = set(re.findall(r"^#define (\w+)", text, re.M)) | set(re.findall(r"^int (main)\(", text, re.M))
    space = re.search(r"^namespace ([\w:]+) \{", text, re.M)
    for part in [text] if not space else UNNAMED.findall(text):
        names |= {(space and space[1], name) for name in TEST.findall(part) + TYPE.findall(part) + VALUE.findall(part)}
    return names


def flags_of(entry):
    """The command without the file, its output, and the compiler."""
    words = shlex.split(entry["command"])  # no path here has blanks in it
    words = words[2:] if words[0].endswith("ccache") else words[1:]
    flags, skip = [], False
    for word in words:
        if skip:
            skip = False
        elif word in ("-o", "-MF", "-MT", "-c"):
            skip = True
        elif word != "-MD":
            flags.append(word)
    return " ".join(flags).replace("-isystem ", "-isystem").split(" ")


def defines(flags):
    return {flag.split("=")[0]: flag for flag in flags if flag.startswith("-D")}


def fits(batch, names, flags):
    mine, theirs = defines(batch["flags"]), defines(flags)
    return (len(batch["paths"]) < LARGEST_BATCH and not batch["names"] & names
            and all(theirs.get(name, flag) == flag for name, flag in mine.items()))


def batches_of(database, wanted):
    """Files such that no two in a batch have a name of their own in common, or are compiled with other definitions."""
    flags_by_path = {}
    for entry in database:
        path = pathlib.Path(entry["file"]).resolve()
        if path in wanted:
            flags_by_path.setdefault(path, flags_of(entry))
    for missing in sorted(wanted - set(flags_by_path)):
        print(f"not compiled in this build, so not looked at: {missing.relative_to(SOURCE)}", file=sys.stderr)
    batches = []
    for path, flags in sorted(flags_by_path.items()):
        names = own_names(path)
        batch = next((b for b in batches if fits(b, names, flags)), None)
        if batch is None:
            batch = {"paths": [], "names": set(), "flags": []}
            batches.append(batch)
        batch["paths"].append(path)
        batch["names"] |= names
        batch["flags"] += [flag for flag in flags if flag not in batch["flags"]]
    return sorted(batches, key=lambda batch: -len(batch["paths"]))


def look_at(batch, folder, number):
    """What clang-tidy says of the files; a batch that does not compile is looked at by halves."""
    paths = batch["paths"]
    together = folder / f"batch_{number}.cpp"
    together.write_text("".join(f'#include "{path}"\n' for path in paths))
    command = ["clang-tidy", "--quiet", "--header-filter=" + rf"(/limpet/[a-z]+/[a-z0-9_]+\.hpp|^{SOURCE}/.*\.[ch]pp)$",
               str(together), "--", *batch["flags"], "-Wno-everything"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    said = done.stdout + done.stderr
    if "clang-diagnostic-error" in said and len(paths) > 1:
        middle = len(paths) // 2
        halves = [dict(batch, paths=paths[:middle]), dict(batch, paths=paths[middle:])]
        return "".join(look_at(half, folder, f"{number}_{i}") for i, half in enumerate(halves))
    return done.stdout if done.returncode else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    args = parser.parse_args()
    listed = args.files or subprocess.run(["git", "ls-files", "*.cpp"], cwd=SOURCE, capture_output=True, text=True,
                                          check=True).stdout.split()
    wanted = {(SOURCE / path).resolve() for path in listed}
    database = json.loads((args.build / "compile_commands.json").read_text())
    batches = batches_of(database, wanted)
    folder = args.build.resolve() / "lint"
    folder.mkdir(exist_ok=True)
    print(f"{sum(len(batch['paths']) for batch in batches)} files in {len(batches)} batches", flush=True)
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        said = list(pool.map(lambda numbered: look_at(numbered[1], folder, numbered[0]), enumerate(batches)))
    text = "".join(said)
    print(text, end="")
    return 1 if text else 0


if __name__ == "__main__":
    sys.exit(main())
