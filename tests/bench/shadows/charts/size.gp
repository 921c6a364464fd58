# Error against the map's size. Blocks of `data`: size, wrong %; the floor's last.
load here.'/style.gp'
set logscale xy 2
set logscale y 10
set key left bottom
set xlabel "texels along the map's side"
set ylabel 'wrong pixels, %'
set format y '%g'
set xrange [110:9500]
set xtics (128,256,512,1024,2048,4096,8192)
plot for [i=0:methods-1] data index i using 1:2 with linespoints lt i+1 title columnheader(1), \
     data index methods using 1:2 with lines lc rgb '#000000' dt 2 lw 2 title columnheader(1)
