#!/usr/bin/env bash
# Models real scans and a simulated one with the built program, and feels two objects with a simulated robot; leaves
# models, meshes and pictures in out/demo.
#   tools/demo.sh path/to/limpet
set -euo pipefail
cd "$(dirname "$0")/.."
limpet=$1
out=out/demo
mkdir -p "$out" build/demo

# Debian's libcgal-demo carries scans. Where documentation is left out on installation, they are taken from the package.
archive=/usr/share/doc/libcgal-dev/data.tar.gz
if [ ! -f build/demo/data/points_3/building.ply ]; then
  if [ ! -f "$archive" ]; then
    (cd build/demo && apt-get download -qq libcgal-demo && dpkg-deb -x libcgal-demo_*.deb package)
    archive=build/demo/package$archive
  fi
  tar -xzf "$archive" -C build/demo data/points_3/cube.pwn data/points_3/building.ply
fi

# show NAME SCAN [options]: one model of a scan, in every form worth having, and its picture.
show() {
  local name=$1 scan=$2
  shift 2
  echo "--- $name: $scan"
  "$limpet" model "$scan" -o "$out/$name.limpet" -o "$out/$name.off" -o "$out/$name.ply" "$@"
  "$limpet" check "$out/$name.limpet"
  "$limpet" draw "$out/$name.limpet" -o "$out/$name.png"
}

show cube build/demo/data/points_3/cube.pwn
show building build/demo/data/points_3/building.ply
kinect=${LIMPET_DATA:-../shared/data}/pcl_mOSD/learn20.pcd
if [ -f "$kinect" ]; then show kinect "$kinect"; fi

echo "--- step_hole: simulated"
"$limpet" scan step_hole -o build/demo/step_hole.ply --points 100000 --noise 0.002 --seed 7
show step_hole build/demo/step_hole.ply --stages 4
"$limpet" compare "$out/step_hole.limpet" step_hole
"$limpet" draw "$out"/step_hole.stage?.limpet -o "$out/step_hole_growth.png"

# feel SHAPE: a simulated robot goes over it until it is modelled; stages of the model with the path, and the end alone.
feel() {
  local shape=$1
  echo "--- $shape: felt by a simulated robot"
  "$limpet" follow "$shape" -o "$out/felt_$shape.limpet" -o "$out/felt_$shape.off" --record "$out/felt_$shape.run"
  "$limpet" check "$out/felt_$shape.limpet"
  "$limpet" draw "$out/felt_$shape.run" -o "$out/felt_$shape.png"
  "$limpet" draw "$out/felt_$shape.run" --stages 1 -o "$out/felt_${shape}_path.png"
  "$limpet" view "$out/felt_$shape.run" -o "$out/felt_$shape.html" --truth "$shape" || echo "the demo goes on without its page"
}

feel cube
feel L

echo
echo "pictures, pages (.html), models (.limpet) and meshes (.off, .ply) are in $out:"
ls "$out"/*.png "$out"/*.html 2>/dev/null || true
