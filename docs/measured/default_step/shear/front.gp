# gnuplot front.gp draws front.svg and front.png
set datafile separator ','
set encoding utf8
set title 'Deviation from the smallest step over work: dense\_shear'
set xlabel 'evaluations of contact forces [-]'
set ylabel 'largest relative deviation of a measured quantity [-]'
set logscale x
set format x '%h'
set logscale y
set format y '%h'
set xrange [*:*] noextend
set grid lc rgb '#dddddd'
set key outside right top Left reverse
set terminal svg size 900,520 dynamic background rgb 'white' font 'sans,13'
set output 'front.svg'
plot 'tradeoff.csv' using 4:(strcol(1) eq 'verlet' && $7 > 0 ? ($7) : NaN) with points pt 4 ps 1.47 lw 1.6 lc rgb '#0072B2' title 'verlet, deviation', \
     'tradeoff.csv' using 4:(strcol(1) eq 'verlet' && $7 > 0 ? ($8) : NaN) with lines lw 1.8 lc rgb '#0072B2' title 'verlet, standard error of it', \
     'tradeoff.csv' using 4:(strcol(1) eq 'synchronized' && $7 > 0 ? ($7) : NaN) with points pt 6 ps 1.39 lw 1.6 lc rgb '#D55E00' title 'synchronized, deviation', \
     'tradeoff.csv' using 4:(strcol(1) eq 'synchronized' && $7 > 0 ? ($8) : NaN) with lines lw 1.8 lc rgb '#D55E00' title 'synchronized, standard error of it'
set terminal pngcairo size 1350,780 font 'sans,15'
set output 'front.png'
replot
