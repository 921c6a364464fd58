# What all charts share: one colour and mark a method, in the order of run's METHODS.
set terminal svg size 860,560 font 'sans-serif,13' background '#ffffff' dynamic
set border 3 lc rgb '#888888'
set tics nomirror textcolor rgb '#444444'
set grid lc rgb '#e4e4e4' lt 1 lw 1
set key textcolor rgb '#333333' samplen 2 spacing 1.1
set linetype 1 lc rgb '#1f77b4' lw 2 pt 7 ps 0.6
set linetype 2 lc rgb '#d62728' lw 2 pt 7 ps 0.6
set linetype 3 lc rgb '#2ca02c' lw 2 pt 7 ps 0.6
set linetype 4 lc rgb '#ff7f0e' lw 2 pt 7 ps 0.6
set linetype 5 lc rgb '#9467bd' lw 2 pt 7 ps 0.6
set linetype 6 lc rgb '#17becf' lw 2 pt 5 ps 0.6
set linetype 7 lc rgb '#8c564b' lw 2 pt 5 ps 0.6
set linetype 8 lc rgb '#e377c2' lw 2 pt 9 ps 0.7
set linetype 9 lc rgb '#7f7f7f' lw 2 pt 9 ps 0.7
set linetype 10 lc rgb '#bcbd22' lw 2 pt 9 ps 0.7
set linetype 11 lc rgb '#000000' lw 2 pt 13 ps 1.2
set linetype cycle 11
