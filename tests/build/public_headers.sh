#!/usr/bin/env bash
# Public headers need Eigen and nothing else: each that `make install` leaves behind compiles on its own, and opens no
# file but our own headers, Eigen's and the standard library's. Headers that need more are named *_internal.hpp, and
# are not installed. No other header of the source tree includes CGAL, OpenMesh or Boost.
#
#   public_headers.sh SOURCE BUILD COMPILER EIGEN WORK
set -euo pipefail
source=$1 build=$2 compiler=$3 eigen=$4 work=$5

leaks=$(cd "$source" && grep -rlE '#include *[<"](CGAL|OpenMesh|boost)/' --include='*.hpp' \
  audit geometry model io survey kinematics following simulation evaluation drawing app | grep -v '_internal\.hpp$' || true)
[ -z "$leaks" ] || { echo "these headers include CGAL, OpenMesh or Boost:"; echo "$leaks"; exit 1; }

rm -rf "$work" && mkdir -p "$work"
cmake --install "$build" --prefix "$work/installed" > "$work/install.log"
installed=$(cd "$work/installed/include" && pwd)

# opened HEADER FILE: compiles the header and lists in FILE what it opens. A hundred headers are three minutes' work,
# unless the compiler's cache knows them.
cache=$(command -v ccache || true)
opened() {
  printf '#include <%s>\n' "${@:3}" "$1" > "$2.cpp"
  ${cache:+"$cache"} "$compiler" -std=c++20 -c "$2.cpp" -o "$2.o" -I"$installed" -isystem "$eigen" -MD -MF "$2.d" || return 1
  sed -e 's/^[^:]*://' -e 's/\\$//' "$2.d" | tr ' ' '\n' | sed -e '/^$/d' -e '/\.cpp$/d' | xargs realpath | sort -u > "$2"
}
check() {
  local found=$work/$(tr / _ <<< "$1")
  opened "$1" "$found" || { echo "does not compile on its own: $1"; return 1; }
  local more
  more=$(comm -23 "$found" "$work/standard" | grep -vF -e "$installed/" -e "$(realpath "$eigen")/" || true)
  [ -z "$more" ] || { echo "$1 needs more than Eigen:"; head -3 <<< "$more"; return 1; }
}
export -f opened check
export cache compiler eigen work installed

# The standard library, and what Eigen takes of the compiler's own headers.
opened Eigen/Dense "$work/standard" bits/stdc++.h
headers=$(cd "$installed" && find limpet -name '*.hpp' | sort)
[ -n "$headers" ] || { echo "no headers are installed"; exit 1; }
xargs -P "$(nproc)" -I{} bash -c 'check {}' <<< "$headers"
