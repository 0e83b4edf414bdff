# gnuplot front.gp draws front.svg and front.png
set datafile separator ','
set encoding utf8
set title 'Error of a collision over its work: oblique\_glass'
set xlabel 'evaluations of the contact force [-]'
set ylabel 'root mean square error over the impact speed [-]'
set logscale x
set format x '%h'
set logscale y
set format y '%h'
set xrange [*:*] noextend
set grid lc rgb '#dddddd'
set key outside right top Left reverse
set terminal svg size 900,520 dynamic background rgb 'white' font 'sans,13'
set output 'front.svg'
plot 'tradeoff.csv' using 11:(strcol(1) eq 'verlet' ? ($6) : NaN) with points pt 4 ps 1.47 lw 1.6 lc rgb '#0072B2' title 'verlet', \
     'tradeoff.csv' using 11:(strcol(1) eq 'synchronized' ? ($6) : NaN) with points pt 6 ps 1.39 lw 1.6 lc rgb '#D55E00' title 'synchronized', \
     'tradeoff.csv' using 11:(strcol(1) eq 'exact' ? ($6) : NaN) with points pt 8 ps 1.31 lw 1.6 lc rgb '#009E73' title 'exact', \
     'tradeoff.csv' using 11:(strcol(1) eq 'cash_karp54' ? ($6) : NaN) with points pt 10 ps 1.23 lw 1.6 lc rgb '#CC79A7' title 'cash\_karp54', \
     'tradeoff.csv' using 11:(strcol(1) eq 'dopri5' ? ($6) : NaN) with points pt 12 ps 1.15 lw 1.6 lc rgb '#E69F00' title 'dopri5', \
     'tradeoff.csv' using 11:(strcol(1) eq 'dopri5_dense' ? ($6) : NaN) with points pt 14 ps 1.07 lw 1.6 lc rgb '#56B4E9' title 'dopri5\_dense', \
     'tradeoff.csv' using 11:(strcol(1) eq 'bulirsch_stoer' ? ($6) : NaN) with points pt 1 ps 0.99 lw 1.6 lc rgb '#8B4513' title 'bulirsch\_stoer', \
     'tradeoff.csv' using 11:(strcol(1) eq 'table' ? ($6) : NaN) with points pt 2 ps 0.91 lw 1.6 lc rgb '#7F7F7F' title 'table', \
     'front.csv' using 11:6 with lines lw 2.5 lc rgb '#000000' title 'front'
set terminal pngcairo size 1350,780 font 'sans,15'
set output 'front.png'
replot
