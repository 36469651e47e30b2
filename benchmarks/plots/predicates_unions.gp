# Copyright the limpet authors. GPL-3.0-or-later.
# The union step beside Boost.Geometry's: time, and what fails.
#   gnuplot -e "folder='out/predicates'" benchmarks/plots/predicates_unions.gp
load 'benchmarks/plots/style.gp'
set datafile columnheaders
file = folder.'/unions.csv'
set terminal pngcairo size 1100,520 font 'sans,10'
set output folder.'/unions.png'
set bmargin 11
set key outside bottom center horizontal maxcols 5 Left reverse
set style fill solid 0.8 noborder
set boxwidth 0.15
names = 'limpet limpet-float-grid limpet-float boost_double boost_long_long'
titles = 'limpet limpet-float-grid limpet-float Boost:double Boost:long-long'
colours = '#7f7f7f #1f77b4 #ff7f0e #2ca02c #98df8a'
bad = 'no_answer exceptions hangs crashes invalid other_law wrong_area'
share(x) = (sum [i = 1:words(bad)] column(word(bad, i))) * 100.0 / column('pairs')
of(name, x) = strcol('contestant') eq name ? x : NaN
set xtics rotate by -30
set xtics ('general, grid' 0, 'general, free' 1, 'general, far' 2, \
           'degenerate, grid' 3, 'degenerate, free' 4, 'degenerate, far' 5)
set xrange [-0.5:5.5]
set multiplot layout 1,2
set title 'Time of a union, µs (median)'
set logscale y
plot for [k = 1:5] file using (int($0 / 5) + 0.16 * (k - 3)):(of(word(names, k), column('us'))) \
  with points pt 7 lc rgb word(colours, k) title word(titles, k)
unset logscale y
set yrange [0:*]
set title 'No answer, invalid or wrong, % of pairs'
plot for [k = 1:5] file using (int($0 / 5) + 0.16 * (k - 3)):(of(word(names, k), share(0))) \
  with boxes lc rgb word(colours, k) title word(titles, k)
unset multiplot
