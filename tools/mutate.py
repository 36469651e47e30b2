#!/usr/bin/env python3
"""Breaks conditions in geometry/ and model/, one at a time, and asks the tests which of it they notice.

  tools/mutate.py [--build FOLDER] [--only NUMBER...] [--report FILE]

A copy of the working tree is built and tested once for each mutant, in FOLDER (default out/mutants). A mutant that
no test notices says which condition nobody guards; one whose text is no longer found, or does not build, ends the run.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
# In the order of their cost; the first that fails ends a mutant's run.
SUITES = ["tests/cases/limpet_cases_tests", "tests/geometry/limpet_geometry_tests", "tests/model/limpet_model_tests",
          "tests/io/limpet_io_tests", "tests/app/limpet_app_tests"]
SECONDS = 900

# file, what stands there, what shall stand there, what that breaks
MUTANTS = [
    ("geometry/predicates.cpp", "return in_box(c, a, b) || in_box(d, a, b) || in_box(a, c, d);", "return in_box(c, a, b);",
     "collinear segments meet in their ends"),
    ("geometry/predicates.cpp", "if (cda * cdb > 0) return false;", "if (cda * cdb >= 0) return false;",
     "a segment that ends on another one meets it"),
    ("geometry/edge_index.cpp", "grid_.row(", "1 + grid_.row(", "the rows of the edge index"),
    ("geometry/judge_edit.cpp", "return swept ? Verdict::swept_vertex : Verdict::valid;", "return Verdict::valid;",
     "no vertex that stays is swept over"),
    ("geometry/judge_edit.cpp", "if (sign > 0)\n      for", "if (sign < 0)\n      for", "the box of a new outer cycle"),
    ("geometry/judge_edit.cpp", ">= -kRounding * rounded ?", ">= -1e9 * kRounding * rounded ?", "what may only grow does not shrink"),
    ("geometry/extend.cpp", "if (polygon_.node(edge).shared) break;", "", "a section holds no shared edge"),
    ("geometry/extend.cpp", "if (visible(at, outer, kNoSlot))", "if (true)", "the ends of a section sight the point"),
    ("geometry/fissure.cpp", "if (orientation(a, b, c) >= 0) return std::nullopt;", "if (orientation(a, b, c) > 0) return std::nullopt;",
     "a notch turns right"),
    ("geometry/fissure.cpp", "if (!cycle.hole || any_shared(cycle)) return false;", "if (!cycle.hole) return false;",
     "a hole with a shared edge stays"),
    ("geometry/merge.cpp", "any_vertex_inside(b, a) || any_vertex_inside(a, b)", "any_vertex_inside(b, a)",
     "one polygon inside the other"),
    ("geometry/mend.cpp", "if (area < 0) return false;", "", "mending changes little"),
    ("model/moments.cpp", "- c[j] * sum_[i]", "+ c[j] * sum_[i]", "central moments"),
    ("model/standing.cpp", "result.near = result.distance2 < setting.lambda2;", "result.near = true;", "a point nearer than λ to the polygon"),
    ("model/standing.cpp", "axis.dot(s.fit.normal) > 0", "axis.dot(s.fit.normal) > 2", "a thin plate has a back"),
    ("model/standing.cpp", "if (!faces_outside(initial.fit.normal, axis)) return false;", "", "an initial segment is confirmed from outside"),
    ("model/insertion.cpp", "if (initial) keep_nearer_crossing(*initial, p, candidates_);", "", "no polygon grows over an initial segment"),
    ("model/merge_polygons.cpp", "if (a.fit.normal.dot(b.fit.normal) <= cos_limit) return false;", "",
     "polygons that merge face the same way"),
    ("model/promotion.cpp", "if (m < 5 || fit.u3 > 4 * v * (m - 3) / m", "if (m < 5", "a polygon's points lie in a plane"),
    ("model/promotion.cpp", "if (-fit.normal.dot(sums.axis) < cos_80", "if (-fit.normal.dot(sums.axis) < -cos_80",
     "readings that graze a plane make none"),
    ("model/dissolve.cpp", "return kFittingShare * fitting >= all.size();", "return fitting > all.size();", "young slivers are dissolved"),
    ("model/publish.cpp", "return merged.squared_residual(part.published.plane(part.chart), setting.step) < 0.999 * setting.lambda2;", "return true;",
     "variance about the published plane stays below λ²"),
    ("model/complex_commit.cpp", "if (edges_.shared(edge)) unshare(edge);\n  for", ";\n  for", "edges that go are unshared"),
    ("model/ordering.cpp", "if (rises > 1) return place.first;", "if (rises > 2) return place.first;", "the local ordering"),
    ("model/reposition.cpp", "if (perimeter.judge(edit) != geometry::Verdict::valid) return offender_on(segment, places);", "",
     "a repositioned perimeter is judged"),
    ("model/voids.cpp", "return !empty_by_chance(", "return empty_by_chance(", "which holes chance explains"),
    ("model/update.cpp", "e.counts.expired += s->count();", "", "points given up are counted"),
    ("model/corner_rings.cpp", "if (!reached) return Refusal::corner_far;", "", "a corner lies near its edges"),
]


def run(command, folder, limit):
    try:
        return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return None


def first_failure(build):
    """The first test that fails, or None."""
    for suite in SUITES:
        done = run([build / suite, "--gtest_fail_fast", "--gtest_brief=1"], build, SECONDS)
        if done is None:
            return f"{pathlib.Path(suite).name}: hangs"
        if done.returncode != 0:
            failed = [line for line in done.stdout.splitlines() if line.startswith("[  FAILED  ]")]
            return failed[0].split("]")[1].split(",")[0].split("(")[0].strip() if failed else f"{pathlib.Path(suite).name}: crashes"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default="out/mutants", type=pathlib.Path)
    parser.add_argument("--only", nargs="*", type=int)
    parser.add_argument("--report", default="out/mutants.md", type=pathlib.Path)
    parser.add_argument("--jobs", default=str(os.cpu_count()))
    args = parser.parse_args()
    tree, build = args.build.resolve() / "tree", args.build.resolve() / "build"
    shutil.rmtree(tree, ignore_errors=True)
    tree.mkdir(parents=True)
    names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
    for name in filter(None, names):
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tree / name)  # newer than what an earlier run built, whatever it left there
    for number, (name, old, _, _) in enumerate(MUTANTS, 1):
        if old not in (tree / name).read_text():
            sys.exit(f"mutant {number}: '{old}' is not in {name} any more")
    subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG", "-DLIMPET_WERROR=OFF"], check=True, capture_output=True)
    targets = [pathlib.Path(s).name for s in SUITES]
    make = ["cmake", "--build", build, "-j", args.jobs, "--target", *targets]
    subprocess.run(make, check=True, capture_output=True)
    if (failure := first_failure(build)) is not None:
        sys.exit(f"without any mutant {failure} fails")
    rows, caught = [], 0
    for number, (name, old, new, what) in enumerate(MUTANTS, 1):
        if args.only and number not in args.only:
            continue
        file = tree / name
        text = file.read_text()
        file.write_text(text.replace(old, new, 1))
        start = time.time()
        built = run(make, build, SECONDS)
        failure = first_failure(build) if built is not None and built.returncode == 0 else None
        file.write_text(text)
        if built is None or built.returncode != 0:
            sys.exit(f"mutant {number} does not build")
        caught += failure is not None
        rows.append(f"| {number} | {name} | {what} | {failure or '**nobody**'} |")
        print(rows[-1], f"{time.time() - start:.0f} s", flush=True)
        report = ["| | file | what the condition is for | noticed first by |", "| --- | --- | --- | --- |", *rows, "",
                  f"{caught} of {len(rows)} noticed."]
        args.report.parent.mkdir(parents=True, exist_ok=True)
        args.report.write_text("\n".join(report) + "\n")
    print(f"{caught} of {len(rows)} noticed.")


if __name__ == "__main__":
    main()
