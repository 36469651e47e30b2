# Copyright the limpet authors. GPL-3.0-or-later.
# What a report's pictures have in common: CSV files in, PNG files out, in `folder`.
set datafile separator ','
set datafile missing NaN
set grid lw 0.5 lc rgb '#dddddd'
set border 3
set tics nomirror
set style data linespoints
set pointsize 0.9
blue = '#1f77b4'; orange = '#ff7f0e'; grey = '#7f7f7f'
set title font ',12'
