#!/usr/bin/env bash
# Fuzzes each kind of input for so many seconds, and turns what it finds into minimised cases.
#   tools/fuzz.sh SECONDS [KIND...]      kinds: perimeter stream scan mesh native labels (default: all)
# Inputs, logs and findings go to out/fuzz. Exit 1 when anything was found, then or before, and is there still.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:?usage: tools/fuzz.sh SECONDS [KIND...]}; shift
kinds=("$@"); [ ${#kinds[@]} -gt 0 ] || kinds=(perimeter stream scan mesh native labels)
programs=build/fuzz/tests
declare -A longest=([perimeter]=800 [stream]=2000 [scan]=2000 [mesh]=2000 [native]=12000 [labels]=1000)
export ASAN_OPTIONS=allocator_may_return_null=1:detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1
found=0
for kind in "${kinds[@]}"; do
  out=out/fuzz/$kind
  mkdir -p "$out/inputs" "$out/seeds" "$out/found"
  tests/fuzz/make_seeds.py "$kind" "$out/seeds" build/release/limpet
  case $kind in perimeter|stream) cases=$kind ;; *) cases=file ;; esac
  { grep -l "^limpet case $cases" tests/corpus/*.case 2>/dev/null || true; } | xargs -r cp -t "$out/seeds"
  : >"$out/log"
  # After a finding it goes on, until the time is over.
  end=$((SECONDS + seconds))
  while [ $SECONDS -lt $end ]; do
    "$programs/fuzz/limpet_fuzz_$kind" "$out/inputs" "$out/seeds" -max_total_time=$((end - SECONDS)) \
      -max_len="${longest[$kind]}" -timeout=30 -rss_limit_mb=4000 -artifact_prefix="$out/found/" \
      -print_final_stats=1 >>"$out/log" 2>&1 || sleep 1
  done
  runs=$(grep -o 'stat::number_of_executed_units: *[0-9]*' "$out/log" | awk '{n += $2} END {print n + 0}')
  cover=$(grep -o 'cov: [0-9]*' "$out/log" | tail -1)
  mapfile -t inputs < <(find "$out/found" -type f ! -name '*.case' | sort)
  echo "$kind: $runs inputs, ${cover:-no coverage}, ${#inputs[@]} findings"
  [ "$runs" -gt 0 ] || { echo "$kind: nothing was tried; see $out/log" >&2; found=1; }
  for input in "${inputs[@]}"; do
    found=1
    [ -f "$input.case" ] && continue
    "$programs/cases/limpet_case" show "$kind" "$input" -o "$input.case" >/dev/null 2>&1 || true
    timeout 300 "$programs/cases/limpet_case" minimise "$input.case" -o "$input.case" 30 || true
  done
done
exit $found
