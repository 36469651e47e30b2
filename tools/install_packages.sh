#!/usr/bin/env bash
# Installs the Debian 12 packages that building, testing and the demo need; does nothing, fast, when they are there.
#   tools/install_packages.sh [lint] [sanitize] [bench] [fuzz]      adds what `make lint`, `make sanitize` and so on need
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache mold clang-format
  libcgal-dev libgmp-dev libmpfr-dev libeigen3-dev libboost-dev libopenmesh-dev libpng-dev
  libcli11-dev nlohmann-json3-dev libtomlplusplus-dev
  libgtest-dev librapidcheck-dev python3 locales
  libcgal-demo)
for group in "$@"; do
  case $group in
    lint) packages+=(clang-tidy-22 libglpk-dev) ;;  # the first that does not look at what others wrote
    bench) packages+=(gnuplot-nox libglpk-dev valgrind) ;;
    sanitize) packages+=(clang libclang-rt-14-dev) ;;
    fuzz) packages+=(clang libclang-rt-14-dev llvm) ;;
    *) echo "usage: $0 [lint] [sanitize] [bench] [fuzz]" >&2; exit 2 ;;
  esac
done

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "not root and no sudo; as root: apt-get install ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
