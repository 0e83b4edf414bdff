# gnuplot sweep.gp draws sweep.svg and sweep.png: largest stable steps over Rayleigh's time, from sweep.csv
set encoding utf8
set ylabel 'largest stable step / Rayleigh time [-]'
set logscale y
set ytics (0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 1, 1.5, 2, 3)
set xtics out nomirror
set grid y lc rgb '#dddddd'
set yrange [0.02:3.5]
rows(sweep, law) = sprintf("< awk -F, '$1 == \"%s\" && $3 == \"%s\" && $4 == (\"%s\" == \"rps\" ? 0.01 : 1) {print $2, $9, $10}' sweep.csv", sweep, law, law)
pair(sweep, law, integrator) = sprintf("< awk -F, '$1 == \"%s\" && $3 == \"%s\" && $5 == \"%s\" && $4 == (\"%s\" == \"rps\" ? 0.01 : 1) {print $2, $9, $10}' sweep.csv", sweep, law, integrator, law)
both = "plot rows(sweep, 'none') with yerrorbars pt 7 lc rgb '#000000' title 'original', rows(sweep, 'rps') with yerrorbars pt 5 lc rgb '#0072B2' title 'rps at 0.01', 1 lc rgb '#D55E00' title 'Rayleigh time', 0.15 lc rgb '#009E73' title 'default'"
do for [k=1:2] {
  if (k == 1) { set terminal svg size 1100,1100 dynamic background rgb 'white' font 'sans,12'; set output 'sweep.svg' }
  else { set terminal pngcairo size 1650,1650 font 'sans,16'; set output 'sweep.png' }
  set multiplot layout 3,2
  set key bottom left Left reverse samplen 2
  set xtics auto; unset logscale x; set xrange [-0.5:18.5]; set xtics rotate by -50 font ',8' noenhanced; set xlabel ''
  set title 'elastic flow at 0.1 m/s, Hertz: laws and factors'
  plot "< awk -F, '$1 == \"laws_hertz\" {printf \"%d %s %s %s_%g\\n\", n++, $9, $10, $3, $4}' sweep.csv" using 1:2:3:xtic(4) with yerrorbars pt 7 lc rgb '#000000' notitle, 1 lc rgb '#D55E00' title 'Rayleigh time', 0.15 lc rgb '#009E73' title 'default'
  set xtics norotate font ',12' autofreq; set logscale x; set xrange [0.007:1.5]
  set title 'elastic flow: speed'; set xlabel 'speed at the start, root mean square [m/s]'; sweep = 'speed'; @both
  unset logscale x; set xrange [0:0.6]
  set title 'elastic flow at 0.1 m/s: density'; set xlabel 'volume fraction [-]'; sweep = 'volume_fraction'; @both
  set xrange [0.5:6.5]
  set title 'elastic flow at 0.1 m/s: two sizes'; set xlabel 'radius of the large over that of the small [-]'; sweep = 'size_ratio'; @both
  set logscale x; set xrange [0.01:4]
  do for [sweep in 'collision_hertz collision_jkr'] {
    set title 'one collision of glass, '.(sweep eq 'collision_jkr' ? 'JKR' : 'Hertz').', off by 1 %'; set xlabel 'impact speed [m/s]'
    plot pair(sweep, 'none', 'verlet') with yerrorbars pt 6 lc rgb '#000000' title 'original, verlet', pair(sweep, 'none', 'synchronized') with yerrorbars pt 7 lc rgb '#000000' title 'original, synchronized', pair(sweep, 'rps', 'verlet') with yerrorbars pt 4 lc rgb '#0072B2' title 'rps at 0.01, verlet', pair(sweep, 'rps', 'synchronized') with yerrorbars pt 5 lc rgb '#0072B2' title 'rps at 0.01, synchronized', 1 lc rgb '#D55E00' title 'Rayleigh time', 0.15 lc rgb '#009E73' title 'default'
  }
  unset multiplot
}
