# Error against time. Blocks of `data`: milliseconds, wrong %, mean absolute %, size.
load here.'/style.gp'
set terminal svg size 1100,560 font 'sans-serif,13' background '#ffffff' dynamic
set multiplot layout 1,2
set logscale xy
set xrange [low:high]
set xlabel clock.' more than without shadows'
set format y '%g'
set key outside bottom center horizontal maxrows 3
set title 'wrong pixels, %'
set label 1 'no shadow' at graph 0.02, first none offset 0,0.6 textcolor rgb '#555555'
plot none with lines lc rgb '#555555' dt 2 lw 1.5 notitle, \
     for [i=0:methods-1] data index i using 1:2 with linespoints lt i+1 title columnheader(1)
set title 'mean absolute error of the light let through, %'
plot none with lines lc rgb '#555555' dt 2 lw 1.5 notitle, \
     for [i=0:methods-1] data index i using 1:3 with linespoints lt i+1 title columnheader(1)
unset multiplot
