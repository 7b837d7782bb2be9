# Draws which point of an arc is nearest, in the plane of its parabola C(tau) = (tau, tau^2). Run by make_figures.sh.
first = -1.
last = 0.7
y(tau) = tau * tau

# The point on the normal at tau that is equally far from C(tau) and from `end`.
normal_x(tau) = -2 * tau / sqrt(1 + 4 * tau * tau)
normal_y(tau) = 1 / sqrt(1 + 4 * tau * tau)
along(tau, end) = ((tau - end) ** 2 + (y(tau) - y(end)) ** 2) \
    / (2 * ((end - tau) * normal_x(tau) + (y(end) - y(tau)) * normal_y(tau)))
equal_x(tau, end) = tau + along(tau, end) * normal_x(tau)
equal_y(tau, end) = y(tau) + along(tau, end) * normal_y(tau)

# The cell of the last end is bounded by its normal, by the points that are as near to the other arm, and by the ends' bisector.
set print $last_cell
print last - 4 * normal_x(last), y(last) - 4 * normal_y(last)
do for [i = 0 : 40] {
    tau = -last + i / 40. * (first + last)
    print equal_x(tau, last), equal_y(tau, last)
}
bisector_x = last - first
bisector_y = y(last) - y(first)
print equal_x(first, last) - 4 * bisector_y, equal_y(first, last) + 4 * bisector_x
print 9, 9
set print $first_cell
print first - 4 * normal_x(first), y(first) - 4 * normal_y(first)
print equal_x(first, last), equal_y(first, last)
print equal_x(first, last) - 4 * bisector_y, equal_y(first, last) + 4 * bisector_x
print -9, 9
set print

set terminal svg size 620, 470 font "sans-serif,12" background rgb "white"
set output "nearest.svg"
set parametric
set trange [0 : 1]
set samples 100
set size ratio -1
set xrange [-2 : 2.2]
set yrange [-0.5 : 2.5]
unset xtics
unset ytics
unset border
set key bottom center outside horizontal samplen 2

set label "the first end is nearest" at -1.9, 2.1 front
set label "the last end is nearest" at 0.66, 1.9 front
set label "the left arm" at -1.15, -0.2 front
set label "the right arm" at 0.3, -0.2 front
set label "jump" at 0.04, 0.72 font ",10" front
plot $first_cell with filledcurves closed linecolor rgb "#e8f0d8" notitle, \
    $last_cell with filledcurves closed linecolor rgb "#f6e6d0" notitle, \
    first + t * (last - first), y(first + t * (last - first)) title "arc" linewidth 4 linecolor rgb "#2060c0", \
    0, 0.5 + t * (equal_y(-last, last) - 0.5) title "the arms are equally near" linewidth 2 linecolor rgb "#c03020", \
    -4 * (t - 0.5) ** 3 * 8, 3 * (2 * t - 1) ** 2 + 0.5 title "centres of curvature" linecolor rgb "#808080" dashtype 3, \
    -2 + 4.2 * t, 0.95 + 0.55 * t title "a ray: one interval for each end" linecolor rgb "black"
