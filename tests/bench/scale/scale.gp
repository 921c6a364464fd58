# What a scene costs by its number of shapes. Blocks of `data`, one a number of combinations: shapes, seconds and MB of the build,
# seconds of a frame and MB of drawing.
load style
set terminal svg size 860,720 font 'sans-serif,13' background '#ffffff' dynamic
array titles[4] = ['building: processor seconds', 'building: MB', 'a frame: processor seconds', 'drawing: MB']
set logscale xy
set xlabel 'shapes'
set xrange [700:140000]
set xtics (1000,10000,100000)
set format y '%g'
set key below maxrows 1 samplen 1 width -2
set multiplot layout 2,2
do for [panel=1:4] {
  set title titles[panel]
  plot for [i=0:lines-1] data index i using 1:(column(panel+1)) with linespoints lt i+1 title columnheader(1)
}
unset multiplot
