# Draws the integrand of one ray that passes a point source closely: as the papers integrate it, with the samples of Simpson's
# rule, and after the change of variable v = 1 / (s + beta). Run by make_figures.sh.
beta = 1.
epsilon = 0.001
b2 = 0.0025 ** 2
k = 1.2
s0 = 0.4166

max(a, b) = a > b ? a : b
field(s) = 1 / max(epsilon, sqrt(b2 + k * (s - s0) ** 2))

# Simpson's rule integrates a parabola through every three samples.
step = 1. / 200
sample(i) = field(i * step) / (i * step + beta) ** 2
parabola(i, x) = sample(i) * (x - 1) * (x - 2) / 2 - sample(i + 1) * x * (x - 2) + sample(i + 2) * x * (x - 1) / 2
seen(s) = (i = 2 * int(s / step / 2), parabola(i, s / step - i))
array samples[200]
do for [i = 1 : 200] { samples[i] = sample(i) }

set terminal svg size 900, 360 font "sans-serif,12" background rgb "white"
set output "substitution.svg"
set multiplot layout 1, 2
set samples 800
set grid linecolor rgb "#dddddd"
set key below samplen 2
set lmargin 7

set title "near the source: a parabola through every three samples"
set xlabel "s"
set xrange [s0 - 0.027 : s0 + 0.027]
set xtics 0.01
set yrange [0 : 210]
plot field(x) / (x + beta) ** 2 title "integrand" linewidth 2 linecolor rgb "#2060c0", \
    seen(x) title "what Simpson-200 integrates" linewidth 2 linecolor rgb "#c03020" dashtype 2, \
    samples using ($1 * step):2 title "samples" with points pointtype 7 pointsize 0.5 linecolor rgb "#c03020"

set title "the whole ray"
set xlabel "fraction of the ray from S to E, in s or in v"
set xrange [0 : 1]
set xtics 0.2
set logscale y
set yrange [0.3 : 500]
v(x) = 1 / beta + x * (1 / (1 + beta) - 1 / beta)
plot field(x) / (x + beta) ** 2 title "over s: the peak times the decay" linecolor rgb "#c03020", \
    field(1 / v(x) - beta) title "over v = 1 / (s + beta): the peak alone" linewidth 2 linecolor rgb "#2060c0"
unset multiplot
