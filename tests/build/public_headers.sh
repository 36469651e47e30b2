#!/usr/bin/env bash
# No public header includes CGAL or OpenMesh; those that may are named *_internal.hpp.
set -euo pipefail
cd "$1"
leaks=$(grep -rlE '#include *[<"](CGAL|OpenMesh)/' --include='*.hpp' \
  audit geometry model io survey kinematics following simulation evaluation drawing app | grep -v '_internal\.hpp$' || true)
[ -z "$leaks" ] || { echo "these public headers include CGAL or OpenMesh:"; echo "$leaks"; exit 1; }
