#!/usr/bin/env bash
# Builds the program with other compilers, optimisations and sanitizers, and runs each on the same scans, simulated
# ones and, where they are, real ones of LIMPET_DATA: all must give the same bytes. A scan that none can model (in a quarter of an hour) counts for nothing.
#   tools/same_bytes.sh [BUILD...]       builds: gcc-O0 gcc-O2 clang-O0 clang-O2 sanitize (default: all)
set -euo pipefail
cd "$(dirname "$0")/.."
builds=("$@"); [ ${#builds[@]} -gt 0 ] || builds=(gcc-O0 gcc-O2 clang-O0 clang-O2 sanitize)
data=${LIMPET_DATA:-../shared/data}
out=out/same_bytes
mkdir -p "$out"

for build in "${builds[@]}"; do
  case $build in
    sanitize) flags=(-DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS_RELEASE="-O1 -g1" -DLIMPET_SANITIZE=ON) ;;
    gcc-*) flags=(-DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS_RELEASE="-${build#*-} -DNDEBUG") ;;
    clang-*) flags=(-DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE="-${build#*-} -DNDEBUG") ;;
    *) echo "there is no build '$build'" >&2; exit 2 ;;
  esac
  cmake -S . -B "build/same_bytes/$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DLIMPET_TESTS=OFF "${flags[@]}" >"$out/$build.log"
  cmake --build "build/same_bytes/$build" -j "${JOBS:-$(nproc)}" --target limpet >>"$out/$build.log"
done

scans=()
for line in "cube --points 50000 --noise 0.002" "step_hole --points 50000 --order shuffled" \
  "room --points 100000 --order sampled --noise 0.005" "city:25 --points 100000 --order sampled --seed 3" \
  "pyramid --points 30000 --order sampled --outliers 0.02"; do
  read -ra arguments <<<"$line"
  scan=$out/${arguments[0]//:/_}.ply
  "build/same_bytes/${builds[0]}/limpet" scan "${arguments[@]}" -o "$scan" -q
  scans+=("$scan")
done
# Real scans of up to 20 MB.
while IFS= read -r scan; do scans+=("$scan"); done < <(
  find "$data" -size -20M \( -name '*.pcd' -o -name '*.xyz' -o -name '*.pwn' -o -path '*points*.ply' \) 2>/dev/null | sort)

for scan in "${scans[@]}"; do
  declare -A digest=()
  for build in "${builds[@]}"; do
    model=$out/$build.limpet
    rm -f "$model"
    timeout -s KILL 900 "build/same_bytes/$build/limpet" model "$scan" -o "$model" -q 2>/dev/null || true
    digest[$build]=$([ -f "$model" ] && sha256sum <"$model" | cut -c1-16 || echo "no model")
  done
  distinct=$(printf '%s\n' "${digest[@]}" | sort -u | wc -l)
  [ "$distinct" -eq 1 ] && verdict=same || verdict=DIFFERENT
  [ "${digest[*]}" != "${digest[*]//no model/}" ] && [ $verdict = same ] && verdict="no model:"
  echo "$verdict $(basename "$scan"):$(for build in "${builds[@]}"; do printf ' %s %s' "$build" "${digest[$build]}"; done)"
done | tee "$out/report.txt"
grep -q DIFFERENT "$out/report.txt" && { echo "builds differ"; exit 1; }
echo "$(grep -c '^same' "$out/report.txt") scans, the same bytes from ${#builds[@]} builds"
