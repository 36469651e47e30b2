#!/usr/bin/env bash
# Runs the tests of a build, and says at the end how many were skipped.
#   tools/test.sh BUILD [options of ctest]
set -uo pipefail
build=$1
shift
log=$build/tests.log
ctest --test-dir "$build" -j2 --output-on-failure "$@" | tee "$log"
code=${PIPESTATUS[0]}
skipped=$(grep -c '\*\*\*Skipped' "$log")
total=$(sed -n 's/.*tests failed out of \([0-9]*\).*/\1/p' "$log")
if [ "$skipped" -gt 0 ]; then
  echo "SKIPPED: $skipped of $total tests judged nothing, nearly all for want of real scans: set LIMPET_DATA to a folder"
  echo "that has them (tests/data_folder.hpp). $build/tests.log has their names."
fi
command -v "${CHROMIUM:-chromium}" >/dev/null ||
  echo "SKIPPED: the page was not tried in a browser: tools/install_packages.sh browser installs Chromium."
exit "$code"
