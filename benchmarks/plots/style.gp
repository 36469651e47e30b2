# Copyright the limpet authors. GPL-3.0-or-later.
# What a report's pictures have in common: CSV files in, PNG files out, in `folder`.
set datafile separator ','
set datafile missing NaN
set grid xtics ytics mytics lt 1 lw 0.7 lc rgb "#cccccc", lt 1 lw 0.4 lc rgb "#e8e8e8"
set border 3
set tics nomirror
set bmargin 8
set style data linespoints
set pointsize 0.9
blue = '#1f77b4'; orange = '#ff7f0e'; grey = '#7f7f7f'
set title font ',12'
