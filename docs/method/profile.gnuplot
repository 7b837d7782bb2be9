# Draws the world integral across an orb or a long beam, over its brightness, for some ratios of reach to core and some sharpnesses.
# Run by make_figures.sh.

# The integral of max(0, 1 / max(r, d) - 1 / R) along a ray that passes at distance x, over its value at x = 0; R = 1.
# With y the way from the closest approach: 2 asinh(y / x) beyond the core, y / r within it.
max(a, b) = a > b ? a : b
chord(x, radius) = sqrt(max(radius * radius - x * x, 0))
beyond(x, r) = log((1 + chord(x, 1)) / max(x, 1e-9)) - (x < r ? log((r + chord(x, r)) / max(x, 1e-9)) : 0)
light(x, r) = x >= 1 ? 0 : 2 * (beyond(x, r) + chord(x, r) / r - chord(x, 1))
profile(x, r) = light(abs(x), r) / (2 * log(1 / r))
sharpened(x, r, sharpness) = profile(x, r) ** sharpness

set terminal svg size 900, 360 font "sans-serif,12" background rgb "white"
set output "profile.svg"
set multiplot layout 1, 2
set samples 661
set grid linecolor rgb "#dddddd"
set key top right samplen 1.5
set lmargin 7
set xlabel "distance from the source / reach"
set xrange [-1.1 : 1.1]
set yrange [0 : 1.05]
set title "luminance / brightness, sharpness 1"
plot profile(x, 1 / 3.) title "reach / core 3" linewidth 2 linecolor rgb "#c03020", \
    profile(x, 1 / 10.) title "10" linewidth 2 linecolor rgb "#e09020", \
    profile(x, 1 / 30.) title "30" linewidth 2 linecolor rgb "#20a060", \
    profile(x, 1 / 100.) title "100" linewidth 2 linecolor rgb "#2060c0"
set title "luminance / brightness, reach / core = 20"
plot sharpened(x, 1 / 20., 1) title "sharpness 1" linewidth 2 linecolor rgb "#c03020", \
    sharpened(x, 1 / 20., 1.5) title "1.5" linewidth 2 linecolor rgb "#e09020", \
    sharpened(x, 1 / 20., 2) title "2" linewidth 2 linecolor rgb "#20a060", \
    sharpened(x, 1 / 20., 4) title "4" linewidth 2 linecolor rgb "#2060c0"
unset multiplot
