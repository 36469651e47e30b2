#!/bin/sh
# Truth and model side by side, from simulated scans of 100,000 points:
#     tools/draw_objects.sh PROGRAM FOLDER OBJECT...
# An object is a shape or a mesh file. λ and noise are chosen by the program.
set -eu
program=$1 folder=$2
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$folder"
for object in "$@"; do
  name=$(basename "$object" | sed 's/\.[^.]*$//')
  "$program" scan "$object" --points 100000 --order sampled -o "$scratch/scan.ply" -q
  "$program" model "$scratch/scan.ply" -o "$scratch/model.limpet" -q
  "$program" draw "$object" "$scratch/model.limpet" -o "$folder/$name.png" --view 1,-0.8,0.6 --width 640 -q
  echo "$folder/$name.png"
done
