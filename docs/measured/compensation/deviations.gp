# gnuplot deviations.gp draws deviations.svg and deviations.png
set datafile separator ','
set encoding utf8
array labels[6] = ['temperature', 'rotational energy', 'collision rate', 'pressure', 'shear stress', 'coordination']
set xrange [0.5:6.5]
set ylabel 'off the original [%]'
set grid y lc rgb '#dddddd'
set arrow from 0.5, 0 to 6.5, 0 nohead lc rgb '#000000'
set xtics out nomirror rotate by -20
do for [i=1:6] { set xtics add (labels[i] i) }
set key outside right top Left reverse
draw = "plot for [v=1:5] for [i=1:6] 'deviations.csv' using (strcol(1) eq word(names, v) && $2 == phi && $3 == factor && $4 == 0 ? i + 0.12*(v - 3) : NaN):(column(3 + 2*i)):(column(4 + 2*i)) with yerrorbars pt 2*v + 3 ps 1 lw 1.5 lc rgb word(colours, v) title i == 1 ? word(titles, v) : ''"
names = 'rps diameter restitution diameter+restitution fitted'
colours = '#000000 #0072B2 #D55E00 #CC79A7 #009E73'
titles = '"RPS" "(a) diameter" "(b) restitution" "(c) both" "(d) fitted"'
do for [k=1:2] {
  if (k == 1) { set terminal svg size 900,900 dynamic background rgb 'white' font 'sans,13'; set output 'deviations.svg' }
  else { set terminal pngcairo size 1350,1350 font 'sans,15'; set output 'deviations.png' }
  factor = 1e-4
  set multiplot layout 3,1
  phi = 0.4; set yrange [-40:40]; set title 'volume fraction 0.4, factor 1e-4'; @draw
  phi = 0.5; set title 'volume fraction 0.5, factor 1e-4 (where (d) is fitted)'; @draw
  phi = 0.55; set yrange [-100:80]; set title 'volume fraction 0.55, factor 1e-4'; @draw
  unset multiplot
}
