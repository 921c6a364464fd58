# False shadow and false light over glPolygonOffset's slope factor. Blocks of `data`: factor, false shadow %, false light %, sum %.
load here.'/style.gp'
set terminal svg size 1100,420 font 'sans-serif,13' background '#ffffff' dynamic
set multiplot layout 1,3
set logscale y
set format y '%g'
set yrange [0.01:60]
set xlabel 'slope factor (bias 4)'
do for [i=0:methods-1] {
  set title word(system("grep '^\"' ".data." | tr -d '\"'"), i+1).', %'
  plot data index i using 1:2 skip 1 with linespoints lc rgb '#d62728' title 'false shadow', \
       data index i using 1:3 skip 1 with linespoints lc rgb '#1f77b4' title 'false light', \
       data index i using 1:4 skip 1 with lines lc rgb '#000000' dt 2 title 'sum'
}
unset multiplot
