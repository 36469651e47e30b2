#!/usr/bin/env bash
# Lines of geometry/ and model/ that the tests run, and that the fuzzers' inputs of out/fuzz and tests/corpus run.
#   tools/coverage.sh       leaves out/coverage/{tests,fuzzing}.txt, a line a file
set -euo pipefail
cd "$(dirname "$0")/.."
build=build/coverage out=out/coverage
mkdir -p $out && rm -f $out/*.profraw
cmake -S . -B $build -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release -DLIMPET_FUZZ=ON -DLIMPET_COVERAGE=ON \
  -DCMAKE_CXX_FLAGS_RELEASE=-O1 >$out/build.log
suites=(geometry/limpet_geometry_tests model/limpet_model_tests cases/limpet_cases_tests)
kinds=(perimeter stream scan mesh native labels)
cmake --build $build -j "${JOBS:-$(nproc)}" --target limpet_geometry_tests limpet_model_tests limpet_cases_tests limpet_fuzzers >>$out/build.log || { tail -20 $out/build.log >&2; exit 1; }

# report NAME PROGRAM...: of what these programs left in NAME-*.profraw
report() {
  local name=$1; shift
  llvm-profdata merge -sparse $out/"$name"-*.profraw -o $out/"$name".profdata
  local objects=(); for program in "${@:2}"; do objects+=(-object "$program"); done
  llvm-cov report "$1" "${objects[@]}" -instr-profile=$out/"$name".profdata geometry model -use-color=false |
    awk '/\.(cpp|hpp) / || /^TOTAL/ {print $1, $8, $9, $10}' >$out/"$name".txt
  echo "$name: lines of geometry/ and model/: $(awk '/^TOTAL/ {print $4}' $out/"$name".txt)"
}

programs=()
for suite in "${suites[@]}"; do
  LLVM_PROFILE_FILE=$out/tests-${suite##*/}.profraw $build/tests/"$suite" --gtest_brief=1 >/dev/null || echo "$suite failed" >&2
  programs+=($build/tests/"$suite")
done
report tests "${programs[@]}"
programs=()
for kind in "${kinds[@]}"; do
  [ -d out/fuzz/"$kind" ] || continue
  LLVM_PROFILE_FILE=$out/fuzzing-$kind.profraw $build/tests/fuzz/limpet_fuzz_"$kind" -runs=0 out/fuzz/"$kind"/{inputs,seeds} tests/corpus >/dev/null 2>&1 || true
  programs+=($build/tests/fuzz/limpet_fuzz_"$kind")
done
[ ${#programs[@]} -eq 0 ] || report fuzzing "${programs[@]}"
