# A ray past a torus: 1 / distance, its closed form, and the rest with the quadrature's nodes, found as glsl/rest.glsl finds them.
# Run by make_figures.sh.
beta = 1.
epsilon = 0.003
tolerance = 1e-3 # of the quality "1e-3"
first_panel = 10.
growth = 3.

# The ray is sqrt(from_axis2 + across2 x^2) from the torus's axis and height + climb x above its plane, x = s - s_axis.
radius = 0.3
s_axis = 0.5
from_axis2 = 0.05 ** 2
across2 = 0.6
height = -0.1
climb = -0.3

max(a, b) = a > b ? a : b
min(a, b) = a < b ? a : b
distance2(x) = (sqrt(from_axis2 + across2 * x * x) - radius) ** 2 + (height + climb * x) ** 2
field(s) = 1 / sqrt(max(distance2(s - s_axis), epsilon ** 2))

# The closest approach before the axis (side -1) or behind it (1), and the curvature of the squared distance there.
k = across2 + climb * climb
slope(x) = k * x + height * climb - radius * across2 * x / sqrt(from_axis2 + across2 * x * x)
curvature(x) = k - radius * across2 * from_axis2 / (from_axis2 + across2 * x * x) ** 1.5
newton(x, n) = n == 0 ? x : newton(x - slope(x) / curvature(x), n - 1)
approach(side) = newton(-height * climb / k + side * radius * sqrt(across2) / k, 6)
near = approach(-1)
far = approach(1)
model(s) = (x = s < s_axis ? near : far, 1 / sqrt(max(distance2(x) + curvature(x) * (s - s_axis - x) ** 2, epsilon ** 2)))
rest(v) = field(1 / v - beta) - model(1 / v - beta)

jacobi_nodes = "0.13975986 0.41640957 0.72315699 0.94289580"
jacobi_differences = "-1.7249797 1.6796979 -1.0989184 0.3567003"
legendre_nodes = "0.06943184 0.33000948 0.66999052 0.93056816"
legendre_differences = "-0.2318919 0.5873578 -0.5873578 0.2318919"
node(is_first, i) = real(word(is_first ? jacobi_nodes : legendre_nodes, i))
difference(is_first, i) = real(word(is_first ? jacobi_differences : legendre_differences, i))

set print $nodes
set print $panels append
reciprocal = 0
array stops[3] = [0., s_axis, 1.]
array passings[2] = [s_axis + near, s_axis + far]
count = 0
do for [half = 1 : 2] {
    v_center = 1 / (passings[half] + beta)
    s_passing = passings[half] - s_axis
    peak = first_panel * sqrt(max(distance2(s_passing), epsilon ** 2) / curvature(s_passing)) * v_center ** 2
    # In place of the closed form, for the allowance.
    length = 1 / (stops[half] + beta) - 1 / (stops[half + 1] + beta)
    reciprocal = reciprocal + sum [i = 0 : 499] field(1 / (1 / (stops[half + 1] + beta) + (i + 0.5) / 500 * length) - beta) * length / 500
    do for [side = 0 : 1] {
        v = v_center
        remaining = 1 / (stops[half + side] + beta) - v
        is_first = 1
        width = max(-peak, min(peak, remaining))
        while (abs(remaining) > 1e-9) {
            roughness = abs(sum [i = 1 : 4] difference(is_first, i) * rest(v + width * node(is_first, i))) \
                + 0.06 * abs(rest(v + width * node(is_first, 1)) - rest(v + width * node(is_first, 2)) \
                - rest(v + width * node(is_first, 3)) + rest(v + width * node(is_first, 4)))
            count = count + 4
            if (roughness * abs(width) <= tolerance * reciprocal) {
                set print $nodes append
                do for [i = 1 : 4] { print v + width * node(is_first, i) }
                set print $panels append
                print v + width
                v = v + width
                remaining = remaining - width
                is_first = 0
                width = abs(remaining) < 1.5 * growth * abs(width) ? remaining : growth * width
            } else {
                width = 0.4 * width
            }
        }
    }
}
set print

set terminal svg size 900, 360 font "sans-serif,12" background rgb "white"
set output "rest.svg"
set multiplot layout 1, 2
set samples 600
set grid linecolor rgb "#dddddd"
set xlabel "v = 1 / (s + beta)"
set xrange [0.5 : 1]
set title "1 / distance to a torus, and what has a closed form"
set key below samplen 2
set lmargin 7
plot field(1 / x - beta) title "1 / distance" linewidth 3 linecolor rgb "#80b0ff", \
    model(1 / x - beta) title "closed form, one a half" linecolor rgb "#c03020"
set title "the rest: ".count." evaluations"
plot rest(x) title "1 / distance - closed form" linewidth 2 linecolor rgb "#2060c0", \
    $nodes using 1:(rest($1)) title "nodes" with points pointtype 7 pointsize 0.5 linecolor rgb "#c03020", \
    $panels using 1:(0) title "ends of panels" with points pointtype 2 pointsize 0.7 linecolor rgb "black"
unset multiplot
