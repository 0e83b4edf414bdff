# gnuplot convergence.gp draws convergence.svg and convergence.png
set datafile separator ','
set encoding utf8
set title 'Error of a collision over the step: elastic\_sliding'
set xlabel 'step over the Rayleigh time [-]'
set ylabel 'relative error [-]'
set logscale x
set format x '%h'
set logscale y
set format y '%h'
set xrange [*:*] noextend
set grid lc rgb '#dddddd'
set key outside right top Left reverse
set terminal svg size 900,520 dynamic background rgb 'white' font 'sans,13'
set output 'convergence.svg'
plot 'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'verlet' ? ($6) : NaN) with points pt 4 ps 1.47 lw 1.6 lc rgb '#0072B2' title 'verlet: root mean square', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'verlet' ? ($6) : NaN) with lines lw 1.8 lc rgb '#0072B2' title '', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'verlet' ? ($7) : NaN) with lines lw 1.8 lc rgb '#0072B2' title 'verlet: largest', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'verlet' ? ((abs($8))) : NaN) with points pt 6 ps 1.39 lw 1.6 lc rgb '#D55E00' title 'verlet: mean energy change', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'verlet' ? ($9) : NaN) with points pt 8 ps 1.31 lw 1.6 lc rgb '#009E73' title 'verlet: contact time', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'synchronized' ? ($6) : NaN) with points pt 10 ps 1.23 lw 1.6 lc rgb '#CC79A7' title 'synchronized: root mean square', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'synchronized' ? ($6) : NaN) with lines lw 1.8 lc rgb '#CC79A7' title '', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'synchronized' ? ($7) : NaN) with lines lw 1.8 lc rgb '#CC79A7' title 'synchronized: largest', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'synchronized' ? ((abs($8))) : NaN) with points pt 12 ps 1.15 lw 1.6 lc rgb '#E69F00' title 'synchronized: mean energy change', \
     'tradeoff.csv' using ($3 > 0 ? $2 : NaN):(strcol(1) eq 'synchronized' ? ($9) : NaN) with points pt 14 ps 1.07 lw 1.6 lc rgb '#56B4E9' title 'synchronized: contact time'
set terminal pngcairo size 1350,780 font 'sans,15'
set output 'convergence.png'
replot
