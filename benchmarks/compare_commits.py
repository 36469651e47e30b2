#!/usr/bin/env python3
# Copyright the limpet authors. GPL-3.0-or-later.
"""Compares the speed of two commits, and says whether their models are the same bytes.

    benchmarks/compare_commits.py BASE [HEAD] [--rounds 5] [--cases cube,city] [--jobs N]

Both are built from git worktrees of their own below build/compare. The same simulated scans, made by HEAD's
program, are modelled by both programs in turn (ABBAAB…), so that what else the machine does falls on both alike.
A case's figure is the ratio HEAD/BASE of the seconds that `limpet model` tells (reading the scan included): of
the fastest runs, and the median and range over the rounds. Below 1 HEAD is faster. On a busy machine look at
the ratio of processor time, too; it is that of the whole program, with writing and judging the model.
"""
import argparse
import filecmp
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build" / "compare"

# Name: shape, points, order, outliers, resolution, noise; resolution and noise by the rules of scan_case.hpp.
CASES = {
    "cube": ("cube", 1_000_000, "shuffled", 0, 0.05, 0.002),
    "cube_raster": ("cube", 1_000_000, "raster", 0, 0.05, 0.002),
    "step_hole": ("step_hole", 300_000, "shuffled", 0, 0.0125, 0.001),
    "city": ("city:100", 300_000, "shuffled", 0, 0.12, 0.002),
    "city_raster": ("city:100", 300_000, "raster", 0, 0.12, 0.002),
    "room": ("room", 300_000, "raster", 0, 0.085, 0.0005),
    "outliers": ("L", 500_000, "sampled", 0.01, 0.025, 0.001),
}


def run(*command, **options):
    return subprocess.run([str(c) for c in command], check=True, **options)


def commit_of(name):
    found = subprocess.run(["git", "-C", ROOT, "rev-parse", "--verify", "--quiet", name + "^{commit}"],
                           capture_output=True, text=True)
    if found.returncode != 0:
        sys.exit(f"compare_commits: no such commit: {name}")
    return found.stdout.strip()


def build(commit, side, jobs):
    """The program of a commit; worktrees are kept, so that the next build is a small one."""
    tree = FOLDER / side
    if tree.exists():
        run("git", "-C", tree, "checkout", "--quiet", "--detach", "--force", commit)
    else:
        run("git", "-C", ROOT, "worktree", "prune")
        run("git", "-C", ROOT, "worktree", "add", "--quiet", "--detach", tree, commit)
    environment = dict(os.environ, CCACHE_BASEDIR=str(tree))
    options = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG",
               "-DLIMPET_TESTS=OFF"]
    run("cmake", "-S", tree, "-B", tree / "build", *options, env=environment, stdout=subprocess.DEVNULL)
    run("cmake", "--build", tree / "build", "-j", jobs, "--target", "limpet", env=environment,
        stdout=subprocess.DEVNULL)
    return next(p for p in (tree / "build").rglob("limpet") if p.is_file() and os.access(p, os.X_OK))


def make_scan(program, name):
    shape, points, order, outliers, _, noise = CASES[name]
    scan = FOLDER / f"{name}.ply"
    run(program, "scan", shape, "-o", scan, "--points", points, "--order", order, "--outliers", outliers,
        "--noise", noise, "--seed", 1, "--quiet")
    return scan


def model(program, scan, name, output):
    """The program's summary of one run, and the processor time of all of it."""
    *_, resolution, noise = CASES[name]
    summary = output.with_suffix(".json")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(program, "model", scan, "-o", output, "--resolution", resolution, "--noise", noise, "--json", summary,
        "--quiet", stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = json.loads(summary.read_text())
    result["cpu"] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return result


def compare(programs, name, rounds):
    scan = make_scan(programs["head"], name)
    models = {side: FOLDER / f"{side}_{name}.limpet" for side in programs}
    runs = {side: [] for side in programs}
    for k in range(rounds):
        for side in ("base", "head") if k % 2 == 0 else ("head", "base"):
            runs[side].append(model(programs[side], scan, name, models[side]))
    scan.unlink()
    ratios = [h["seconds"] / b["seconds"] for b, h in zip(runs["base"], runs["head"])]
    cpu_ratio = min(r["cpu"] for r in runs["head"]) / min(r["cpu"] for r in runs["base"])
    points = runs["base"][0]["points"]
    nanoseconds = {side: 1e9 * min(r["seconds"] for r in rs) / points for side, rs in runs.items()}
    memory = {side: rs[-1]["peak_memory_bytes"] / 1e6 for side, rs in runs.items()}
    same = filecmp.cmp(models["base"], models["head"], shallow=False)
    return (f"| {name:<12} | {points:>9,} | {nanoseconds['base']:>13,.0f} | {nanoseconds['head']:>13,.0f} "
            f"| {nanoseconds['head'] / nanoseconds['base']:>5.3f} | {statistics.median(ratios):>6.3f} "
            f"| {min(ratios):.3f} to {max(ratios):.3f} | {cpu_ratio:>5.3f} "
            f"| {memory['base']:>7.1f} | {memory['head']:>7.1f} "
            f"| {'same' if same else 'differ':<6} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("base")
    parser.add_argument("head", nargs="?", default="HEAD")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--cases", default=",".join(CASES), help="some of " + ",".join(CASES))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    args = parser.parse_args()
    names = args.cases.split(",")
    if unknown := [n for n in names if n not in CASES]:
        sys.exit(f"compare_commits: no such case: {unknown[0]}")
    FOLDER.mkdir(parents=True, exist_ok=True)
    commits = {"base": commit_of(args.base), "head": commit_of(args.head)}
    programs = {side: build(commit, side, args.jobs) for side, commit in commits.items()}

    print(f"HEAD {commits['head'][:10]} against BASE {commits['base'][:10]}, {args.rounds} rounds; "
          "ratios are HEAD/BASE, memory is the peak in MB")
    print("| case         |    points | BASE ns/point | HEAD ns/point | ratio | median | range          "
          "|   cpu | BASE MB | HEAD MB | models |")
    print("|--------------|----------:|--------------:|--------------:|------:|-------:|----------------"
          "|------:|--------:|--------:|--------|")
    for name in names:
        print(compare(programs, name, args.rounds), flush=True)


if __name__ == "__main__":
    main()
