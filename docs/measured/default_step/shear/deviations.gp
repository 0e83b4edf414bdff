# gnuplot deviations.gp draws deviations.svg and deviations.png
set datafile separator ','
set encoding utf8
set title 'Deviation from the smallest step: dense\_shear'
set xlabel 'step over the Rayleigh time [-]'
set ylabel 'deviation with its standard error [%]'
set logscale x
set format x '%h'
set xrange [*:*] noextend
set grid lc rgb '#dddddd'
set key outside right top Left reverse
set terminal svg size 900,520 dynamic background rgb 'white' font 'sans,13'
set output 'deviations.svg'
plot 'tradeoff.csv' using 2:(strcol(1) eq 'synchronized' ? ((100*$10)) : NaN):(100*$11) with yerrorbars pt 4 ps 1.47 lw 1.6 lc rgb '#0072B2' title 'temperature, synchronized', \
     'tradeoff.csv' using 2:(strcol(1) eq 'synchronized' ? ((100*$12)) : NaN):(100*$13) with yerrorbars pt 6 ps 1.39 lw 1.6 lc rgb '#D55E00' title 'collision\_rate, synchronized', \
     'tradeoff.csv' using 2:(strcol(1) eq 'synchronized' ? ((100*$14)) : NaN):(100*$15) with yerrorbars pt 8 ps 1.31 lw 1.6 lc rgb '#009E73' title 'coordination, synchronized', \
     'tradeoff.csv' using 2:(strcol(1) eq 'synchronized' ? ((100*$16)) : NaN):(100*$17) with yerrorbars pt 10 ps 1.23 lw 1.6 lc rgb '#CC79A7' title 'dissipation, synchronized', \
     'tradeoff.csv' using 2:(strcol(1) eq 'synchronized' ? ((100*$18)) : NaN):(100*$19) with yerrorbars pt 12 ps 1.15 lw 1.6 lc rgb '#E69F00' title 'pressure, synchronized', \
     'tradeoff.csv' using 2:(strcol(1) eq 'synchronized' ? ((100*$20)) : NaN):(100*$21) with yerrorbars pt 14 ps 1.07 lw 1.6 lc rgb '#56B4E9' title 'stress\_xz, synchronized'
set terminal pngcairo size 1350,780 font 'sans,15'
set output 'deviations.png'
replot
