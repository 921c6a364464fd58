# Wrong pixels where one parameter goes to extremes. Files `data`SWEEP.dat, blocks: value, wrong %, weighted by normal . L, floor.
load here.'/style.gp'
set terminal svg size 1100,640 font 'sans-serif,13' background '#ffffff' dynamic
set multiplot layout 2,2
set logscale y
set format y '%g'
set ylabel 'wrong, %'
set yrange [0.02:20]
set title "the sun's elevation, degrees (solid: weighted by normal . L; dotted: all alike)"
plot for [i=0:methods-1] data.'elevation.dat' index i using 1:3 with linespoints lt i+1 title columnheader(1), \
     for [i=0:methods-1] data.'elevation.dat' index i using 1:2 skip 1 with lines lt i+1 dt 3 notitle, \
     data.'elevation.dat' index 0 using 1:4 skip 1 with lines lc rgb '#000000' dt 2 title 'floor'
set yrange [0.02:2]
set logscale x
set format x '10^{%L}'
set title 'far / near of a spotlight'
plot for [i=0:methods-1] data.'far_near.dat' index i using 1:2 with linespoints lt i+1 title columnheader(1), \
     data.'far_near.dat' index 0 using 1:4 skip 1 with lines lc rgb '#000000' dt 2 title 'floor'
set title 'the scene made larger'
plot for [i=0:methods-1] data.'scale.dat' index i using 1:2 with linespoints lt i+1 title columnheader(1), \
     data.'scale.dat' index 0 using 1:4 skip 1 with lines lc rgb '#000000' dt 2 title 'floor'
set title 'the scene moved from the origin'
plot for [i=0:methods-1] data.'offset.dat' index i using 1:2 with linespoints lt i+1 title columnheader(1), \
     data.'offset.dat' index 0 using 1:4 skip 1 with lines lc rgb '#000000' dt 2 title 'floor'
unset multiplot
