#!/usr/bin/env bash
# Public headers need Eigen and nothing else: each that `make install` leaves behind compiles on its own, and opens no
# file but our own headers, Eigen's and the standard library's. Headers that need more are named *_internal.hpp, and
# are not installed. No other header of the source tree includes CGAL, OpenMesh, Boost or urdfdom.
#
#   public_headers.sh SOURCE BUILD COMPILER EIGEN WORK
set -euo pipefail
source=$1 build=$2 compiler=$3 eigen=$4 work=$5

leaks=$(cd "$source" && grep -rlE '#include *[<"](CGAL|OpenMesh|boost|urdf_[a-z]+|console_bridge)/' --include='*.hpp' \
  audit geometry model io survey kinematics following simulation evaluation drawing app | grep -v '_internal\.hpp$' || true)
[ -z "$leaks" ] || { echo "these headers include CGAL, OpenMesh, Boost or urdfdom:"; echo "$leaks"; exit 1; }

rm -rf "$work" && mkdir -p "$work"
cmake --install "$build" --prefix "$work/installed" > "$work/install.log"
installed=$(cd "$work/installed/include" && pwd)

# Eigen's modules, each compiled beforehand with those before it: of a header nearly all time would go to them.
modules=(Core Geometry Dense)
for module in "${modules[@]}"; do
  before="${before:-}#include <Eigen/$module>"$'\n'
  printf '%s' "$before" > "$work/$module.hpp"
  "$compiler" -std=c++20 -x c++-header "$work/$module.hpp" -o "$work/$module.hpp.gch" -isystem "$eigen"
done

# opened FILE HEADER...: lists in FILE what the headers open.
opened() {
  printf '#include <%s>\n' "${@:2}" > "$1.cpp"
  "$compiler" -std=c++20 -M "$1.cpp" -I"$installed" -isystem "$eigen" > "$1.d" || return 1
  sed -e 's/^[^:]*://' -e 's/\\$//' "$1.d" | tr ' ' '\n' | sed -e '/^$/d' -e '/\.cpp$/d' | xargs realpath | sort -u > "$1"
}
# compiles FILE: with no more of Eigen known than it includes.
compiles() {
  local known=() module
  for module in Core Geometry Dense; do
    ! grep -qx "$(realpath "$eigen/Eigen/$module")" "$1" || known=(-include "$work/$module.hpp")
  done
  "$compiler" -std=c++20 -Winvalid-pch -Werror -fsyntax-only "${known[@]}" -I"$installed" -isystem "$eigen" "$1.cpp"
}
check() {
  local found=$work/$(tr / _ <<< "$1")
  opened "$found" "$1" && compiles "$found" || { echo "does not compile on its own: $1"; return 1; }
  local more
  more=$(comm -23 "$found" "$work/standard" | grep -vF -e "$installed/" -e "$(realpath "$eigen")/" || true)
  [ -z "$more" ] || { echo "$1 needs more than Eigen:"; head -3 <<< "$more"; return 1; }
}
export -f opened compiles check
export compiler eigen work installed

# The standard library, and what Eigen takes of the compiler's own headers.
opened "$work/standard" Eigen/Dense bits/stdc++.h
headers=$(cd "$installed" && find limpet -name '*.hpp' | sort)
[ -n "$headers" ] || { echo "no headers are installed"; exit 1; }
xargs -P "$(nproc)" -I{} bash -c 'check {}' <<< "$headers"
