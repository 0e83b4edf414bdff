# gnuplot patch_fraction.gp draws ../../pictures/patch_fraction.png from the studies of data/reference that the hybrid ran, and prints the fit
set datafile separator ','
set encoding utf8
reference = '../../../data/reference/'
studies = 'contact_time size cohesion engines engines_adhesive'
colours = "#0072B2 #D55E00 #009E73 #CC79A7 #E69F00"
titles = '"no cohesion, 400/s and 1500/s" "enlarged, 400/s and 1500/s" "cohesive, 200/s" "40/s" "40/s, JKR and adhesive rolling"'
files = ''
do for [study in studies] { files = files.' '.reference.study.'/study.csv' }
# One row a cell; fitted is where few contacts are in patches.
most = 0.03
stats '< cat'.files using (strcol(7) eq 'collision_rate' && strlen(strcol(24)) && $9*$22 < most ? log($24/($9*$22)) : NaN) name 'fit' nooutput
constant = exp(fit_mean)
scatter = exp(fit_stddev)
print sprintf('%.3g times the product, within a factor of %.2f, %d cells below %g', constant, scatter, fit_records, most)
set title 'Contacts of the hybrid that are in patches or in soft spheres'
set xlabel 'contact time of the fastest meeting × collision rate [-]'
set ylabel 'of all contacts [-]'
set logscale xy
set format xy '%h'
set yrange [0.005:1.3]
set samples 500
set grid lc rgb '#dddddd'
set key bottom right Left reverse
set terminal pngcairo size 1100,720 font 'sans,14'
set output '../../pictures/patch_fraction.png'
plot [0.0005:1] for [k=1:words(studies)] reference.word(studies, k).'/study.csv' \
       using (strcol(7) eq 'collision_rate' && strlen(strcol(24)) ? $9*$22 : NaN):24 \
       with points pt 4 + 2*k ps 1.6 - 0.12*k lw 1.6 lc rgb word(colours, k) title word(titles, k), \
     x*constant < 1 ? x*constant : 1 with lines lw 2.5 lc rgb '#000000' title sprintf('%.3g times the product, up to 1', constant), \
     x*constant*scatter < 1 ? x*constant*scatter : 1 with lines dt 2 lc rgb '#7F7F7F' title sprintf('a factor of %.2f more or less', scatter), \
     x*constant/scatter < 1 ? x*constant/scatter : 1 with lines dt 2 lc rgb '#7F7F7F' notitle
