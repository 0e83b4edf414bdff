# gnuplot front_time.gp draws front_time.svg and front_time.png
set datafile separator ','
set encoding utf8
set title 'Error over processor time: methods\_bed'
set xlabel 'processor time of one core, for the same statistics [s]'
set ylabel 'largest relative error of a measured quantity [-]'
set logscale x
set format x '%h'
set logscale y
set format y '%h'
set xrange [*:*] noextend
set grid lc rgb '#dddddd'
set key outside right top Left reverse
set terminal svg size 900,520 dynamic background rgb 'white' font 'sans,13'
set output 'front_time.svg'
plot 'front_time.csv' using 1:2 with lines lw 2.5 lc rgb '#000000' title 'front', \
     'tradeoff.csv' using 19:(strcol(1) eq 'dem over step' && $10 > 0 ? ($10) : NaN):12:13 with yerrorbars pt 4 ps 1.47 lw 1.6 lc rgb '#0072B2' title 'dem over step', \
     'tradeoff.csv' using 19:(strcol(1) eq 'rps (dem)' && $10 > 0 ? ($10) : NaN):12:13 with yerrorbars pt 6 ps 1.39 lw 1.6 lc rgb '#D55E00' title 'rps (dem)', \
     'tradeoff.csv' using 19:(strcol(1) eq 'sup keeping cell (dem)' && $10 > 0 ? ($10) : NaN):12:13 with yerrorbars pt 8 ps 1.31 lw 1.6 lc rgb '#009E73' title 'sup keeping cell (dem)', \
     'tradeoff.csv' using 19:(strcol(1) eq 'hybrid' && $10 > 0 ? ($10) : NaN):12:13 with yerrorbars pt 10 ps 1.23 lw 1.6 lc rgb '#CC79A7' title 'hybrid', \
     'tradeoff.csv' using ($19/1.4):(0.0215265) with lines lw 1.8 lc rgb '#7F7F7F' title 'not told apart below 2.2 %'
set terminal pngcairo size 1350,780 font 'sans,15'
set output 'front_time.png'
replot
