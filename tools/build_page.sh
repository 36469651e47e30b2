#!/usr/bin/env bash
# Makes the parts of the page (drawing/page/) that the program holds: page.html, style.css and program.js, which has
# three.js in it.
#   tools/build_page.sh OUT NPM ESBUILD
# Where npm, its registry or esbuild fails they are empty and one line says so: everything but `limpet view` to a page
# works without.
set -uo pipefail
out=$1 npm=$2 esbuild=$3
page=$(cd "$(dirname "$0")/../drawing/page" && pwd)
work=$out/work

without() {
  echo "no page: $1; all else is built. Install npm (Node.js 18 or newer) and esbuild, and build again" >&2
  for part in page.html style.css program.js; do : > "$out/$part"; done
  exit 0
}

mkdir -p "$work"
[ -x "$npm" ] || without "there is no npm"
[ -x "$esbuild" ] || without "there is no esbuild"
cp "$page/package.json" "$page/package-lock.json" "$page/.npmrc" "$work"/
if ! cmp -s "$page/package-lock.json" "$work/installed.json"; then
  (cd "$work" && "$npm" ci --ignore-scripts --no-audit --no-fund --loglevel=error >npm.log 2>&1) ||
    without "npm could not install three.js ($work/npm.log)"
  cp "$page/package-lock.json" "$work/installed.json"
fi
rm -rf "$work/source" && cp -r "$page/source" "$work/source"
"$esbuild" "$work/source/main.js" --bundle --minify --format=iife --target=es2020 --legal-comments=none \
  --log-level=error --outfile="$out/program.js.new" >"$work/esbuild.log" 2>&1 ||
  without "esbuild failed ($work/esbuild.log)"
mv "$out/program.js.new" "$out/program.js"
cp "$page/page.html" "$page/style.css" "$out"/
