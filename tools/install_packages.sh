#!/usr/bin/env bash
# Installs the Debian 12 packages that building, testing and the demo need; does nothing, fast, when they are there.
#   tools/install_packages.sh [lint] [sanitize] [bench] [fuzz] [browser]      adds what `make lint`, `make sanitize` and so on need
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache mold clang-format
  libcgal-dev libgmp-dev libmpfr-dev libeigen3-dev libboost-dev libopenmesh-dev libpng-dev
  libcli11-dev nlohmann-json3-dev libtomlplusplus-dev liburdfdom-dev
  libgtest-dev librapidcheck-dev liborocos-kdl-dev python3 locales
  zlib1g-dev libcgal-demo)
for group in "$@"; do
  case $group in
    lint) packages+=(clang-tidy-22 libglpk-dev) ;;  # the first that does not look at what others wrote
    bench) packages+=(gnuplot-nox libglpk-dev valgrind) ;;
    sanitize) packages+=(clang libclang-rt-14-dev) ;;
    browser) packages+=(chromium) ;;
    fuzz) packages+=(clang libclang-rt-14-dev llvm) ;;
    *) echo "usage: $0 [lint] [sanitize] [bench] [fuzz] [browser]" >&2; exit 2 ;;
  esac
done

is_there() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]; }
missing=()
for package in "${packages[@]}"; do is_there "$package" || missing+=("$package"); done
# The page of `limpet view` is made with npm and esbuild; all else is built without them. Debian's npm does not go with
# another Node.js, which brings an npm of its own.
wanted=()
command -v npm >/dev/null || wanted+=(npm)
command -v esbuild >/dev/null || wanted+=(esbuild)
[ ${#missing[@]} -eq 0 ] && [ ${#wanted[@]} -eq 0 ] && exit 0

echo "installing: ${missing[*]} ${wanted[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "not root and no sudo; as root: apt-get install ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
install() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@"; }
if [ ${#missing[@]} -gt 0 ]; then
  "${as_root[@]}" apt-get update -qq
  install "${missing[@]}"
fi
for package in "${wanted[@]}"; do
  install "$package" || { "${as_root[@]}" apt-get update -qq && install "$package"; } ||
    echo "$package cannot be installed: limpet view will not write pages; all else works" >&2
done
