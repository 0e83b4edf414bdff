# gnuplot exactness.gp draws exactness.svg and exactness.png
set datafile separator ','
set encoding utf8
set title 'Error of an exact collision against its tolerance (e = 0.81, v = 3 reduced units)'
set xlabel 'tolerance asked for [-]'
set ylabel 'larger error of restitution and relative contact time [-]'
set logscale x
set format x '%h'
set logscale y
set format y '%h'
set xrange [*:*] noextend
set grid lc rgb '#dddddd'
set key outside right top Left reverse
set terminal svg size 900,520 dynamic background rgb 'white' font 'sans,13'
set output 'exactness.svg'
plot 'exactness.csv' using 2:(strcol(1) eq 'linear_touch_overlap' ? (($3 > $4 ? $3 : $4)) : NaN) with points pt 4 ps 1.47 lw 1.6 lc rgb '#0072B2' title 'linear, touch, overlap', \
     'exactness.csv' using 2:(strcol(1) eq 'hertz_touch_overlap' ? (($3 > $4 ? $3 : $4)) : NaN) with points pt 6 ps 1.39 lw 1.6 lc rgb '#D55E00' title 'hertz, touch, overlap', \
     'exactness.csv' using 2:(strcol(1) eq 'jkr_full_overlap' ? (($3 > $4 ? $3 : $4)) : NaN) with points pt 8 ps 1.31 lw 1.6 lc rgb '#009E73' title 'jkr, full, overlap', \
     'exactness.csv' using 2:(strcol(1) eq 'jkr_full_contact_radius' ? (($3 > $4 ? $3 : $4)) : NaN) with points pt 10 ps 1.23 lw 1.6 lc rgb '#CC79A7' title 'jkr, full, contact\_radius', \
     'exactness.csv' using 2:(strcol(1) eq 'jkr_pull_off_overlap' ? (($3 > $4 ? $3 : $4)) : NaN) with points pt 12 ps 1.15 lw 1.6 lc rgb '#E69F00' title 'jkr, pull\_off, overlap', \
     'exactness.csv' using 2:(strcol(1) eq 'jkr_pull_off_contact_radius' ? (($3 > $4 ? $3 : $4)) : NaN) with points pt 14 ps 1.07 lw 1.6 lc rgb '#56B4E9' title 'jkr, pull\_off, contact\_radius', \
     'exactness.csv' using 2:(strcol(1) eq 'jkr_touch_overlap' ? (($3 > $4 ? $3 : $4)) : NaN) with points pt 1 ps 0.99 lw 1.6 lc rgb '#8B4513' title 'jkr, touch, overlap', \
     'exactness.csv' using 2:(strcol(1) eq 'jkr_touch_contact_radius' ? (($3 > $4 ? $3 : $4)) : NaN) with points pt 2 ps 0.91 lw 1.6 lc rgb '#7F7F7F' title 'jkr, touch, contact\_radius', \
     'exactness.csv' using 2:2 with lines lw 2.5 lc rgb '#000000' title 'error = tolerance'
set terminal pngcairo size 1350,780 font 'sans,15'
set output 'exactness.png'
replot
