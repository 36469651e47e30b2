#!/usr/bin/env bash
# Runs the tests of the page (tests/page/), those of them that are named, in headless Chromium where they need it. They
# run on copies in WORK, beside what they need from npm.
#   tools/test_page.sh WORK LIMPET FILE...
# Exit code 77: they could not run, and one line says what is missing.
set -uo pipefail
work=$1 limpet=$2
shift 2
root=$(cd "$(dirname "$0")/.." && pwd)

skip() { echo "skipped: $1"; exit 77; }

command -v node >/dev/null || skip "there is no node (tools/install_packages.sh installs npm, which brings it)"
command -v npm >/dev/null || skip "there is no npm (tools/install_packages.sh installs it)"
command -v esbuild >/dev/null || skip "there is no esbuild (tools/install_packages.sh installs it)"
CHROMIUM=${CHROMIUM:-$(command -v chromium || true)}
[ -n "$CHROMIUM" ] || skip "there is no Chromium: tools/install_packages.sh browser installs it"

mkdir -p "$work"
exec 9>"$work/lock" && flock 9  # tests run side by side
install() {  # FOLDER: what its lock file names
  local folder=$1
  mkdir -p "$work/$folder"
  cp "$root/$folder"/package.json "$root/$folder"/package-lock.json "$root/$folder"/.npmrc "$work/$folder"/
  cmp -s "$root/$folder/package-lock.json" "$work/$folder/installed.json" && return
  (cd "$work/$folder" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error >npm.log 2>&1) ||
    skip "npm could not install what $folder/package-lock.json names ($work/$folder/npm.log)"
  cp "$root/$folder/package-lock.json" "$work/$folder/installed.json"
}
install drawing/page
install tests/page
(cd "$root" && tar -cf - --exclude=node_modules drawing/page tests/page docs/native_format.md) | tar -xf - -C "$work"
exec 9>&-

export CHROMIUM LIMPET=$limpet
cd "$work/tests/page" && exec node --test --test-reporter=spec "$@"
