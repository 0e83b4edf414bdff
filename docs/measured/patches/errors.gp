# scalebreak_patch_errors errors.csv makes the numbers; gnuplot errors.gp draws ../../pictures/patch_errors.png
set datafile separator ','
set encoding utf8
set title 'Rows and random clusters of 3 to 20 spheres, 200 each, beside the exact engine'
set bmargin 8
set xlabel 'largest difference of a velocity, over the speed [-]'
set ylabel 'share of the scenes below [-]'
set logscale x
set format x '%h'
set xrange [1e-6:10] noextend
set yrange [0:1]
set grid lc rgb '#dddddd'
set key outside bottom center Left reverse maxrows 3
set terminal pngcairo size 1200,800 font 'sans,14'
set output '../../pictures/patch_errors.png'
plot 'errors.csv' using 4:(strcol(1) eq 'cluster' ? 1 : 0) smooth cnormal lw 2.5 lc rgb '#0072B2' title 'clusters: hybrid, step 0.15 of Rayleigh''s', \
     'errors.csv' using 5:(strcol(1) eq 'cluster' ? 1 : 0) smooth cnormal lw 2.5 lc rgb '#009E73' title 'clusters: hybrid, step 0.02', \
     'errors.csv' using 6:(strcol(1) eq 'cluster' ? 1 : 0) smooth cnormal lw 2.5 lc rgb '#D55E00' title 'clusters: event-driven, two at a time', \
     'errors.csv' using 4:(strcol(1) eq 'row' ? 1 : 0) smooth cnormal lw 2 dt 2 lc rgb '#0072B2' title 'rows: hybrid, step 0.15', \
     'errors.csv' using 5:(strcol(1) eq 'row' ? 1 : 0) smooth cnormal lw 2 dt 2 lc rgb '#009E73' title 'rows: hybrid, step 0.02', \
     'errors.csv' using 6:(strcol(1) eq 'row' ? 1 : 0) smooth cnormal lw 2 dt 2 lc rgb '#D55E00' title 'rows: event-driven, two at a time'
