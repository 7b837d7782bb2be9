# Draws 1 / distance to an arc along a ray, the closed form, and the rest with the nodes of the quadrature. The nodes are found
# as in glsl/source/rest_panels.glsl. Run by make_figures.sh.
beta = 1.
epsilon = 0.003
tolerance = 1e-3 # of the quality "1e-3"
first_panel = 10.
growth_of_panels = 3.

# The ray L(s) = start + s direction, and the arc C(tau) = (slope tau, bend tau^2, 0). The arc's ends are never nearest.
array start[3] = [-0.35, -0.12, -0.42]
array direction[3] = [0.6, 0.12, 0.9]
slope = 0.6
bend = 0.5

max(a, b) = a > b ? a : b
min(a, b) = a < b ? a : b
place(s, i) = start[i] + s * direction[i]
# The nearest point, equation (12), by Newton's method.
left(s, tau) = 2 * bend ** 2 * tau ** 3 + (slope ** 2 - 2 * bend * place(s, 2)) * tau - slope * place(s, 1)
growth(s, tau) = 6 * bend ** 2 * tau ** 2 + slope ** 2 - 2 * bend * place(s, 2)
newton(s, tau, n) = n == 0 ? tau : newton(s, tau - left(s, tau) / growth(s, tau), n - 1)
nearest(s) = newton(s, 0., 12)
distance2_to(s, tau) = (place(s, 1) - slope * tau) ** 2 + (place(s, 2) - bend * tau ** 2) ** 2 + place(s, 3) ** 2
distance2(s) = (tau = nearest(s), distance2_to(s, tau))
field(s) = 1 / sqrt(max(distance2(s), epsilon ** 2))

# The closest approach, and half the second derivative of the squared distance there.
step = 1e-4
first_derivative(s) = (distance2(s + step) - distance2(s - step)) / (2 * step)
second_derivative(s) = (distance2(s + step) - 2 * distance2(s) + distance2(s - step)) / step ** 2
approach(s, n) = n == 0 ? s : approach(s - first_derivative(s) / second_derivative(s), n - 1)
s0 = approach(0.45, 8)
b2 = distance2(s0)
k = second_derivative(s0) / 2
model(s) = 1 / sqrt(max(b2 + k * (s - s0) ** 2, epsilon ** 2))
rest(v) = field(1 / v - beta) - model(1 / v - beta)

jacobi_nodes = "0.13975986 0.41640957 0.72315699 0.94289580"
jacobi_differences = "-1.7249797 1.6796979 -1.0989184 0.3567003"
legendre_nodes = "0.06943184 0.33000948 0.66999052 0.93056816"
legendre_differences = "-0.2318919 0.5873578 -0.5873578 0.2318919"
node(is_first, i) = real(word(is_first ? jacobi_nodes : legendre_nodes, i))
difference(is_first, i) = real(word(is_first ? jacobi_differences : legendre_differences, i))

set print $nodes
set print $panels append
array stops[2] = [0., 1.]
count = 0
v_center = 1 / (s0 + beta)
peak = first_panel * sqrt(max(b2, epsilon ** 2) / k) * v_center ** 2
# A sum replaces the closed form; only the tolerance depends on it.
length = 1 / beta - 1 / (1 + beta)
reciprocal = sum [i = 0 : 499] field(1 / (1 / (1 + beta) + (i + 0.5) / 500 * length) - beta) * length / 500
do for [side = 1 : 2] {
    v = v_center
    remaining = 1 / (stops[side] + beta) - v
    is_first = 1
    width = max(-peak, min(peak, remaining))
    while (abs(remaining) > 1e-9) {
        roughness = abs(sum [i = 1 : 4] difference(is_first, i) * rest(v + width * node(is_first, i))) \
            + (is_first ? 0.3 : 0.16) * abs(rest(v + width * node(is_first, 1)) - rest(v + width * node(is_first, 2)) \
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
            width = abs(remaining) < 1.5 * growth_of_panels * abs(width) ? remaining : growth_of_panels * width
        } else {
            width = 0.4 * width
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
set title "1 / distance to an arc, and the closed form"
set key below samplen 2
set lmargin 7
plot field(1 / x - beta) title "1 / distance" linewidth 3 linecolor rgb "#80b0ff", \
    model(1 / x - beta) title "closed form" linecolor rgb "#c03020"
set title "the rest: ".count." evaluations"
plot rest(x) title "1 / distance - closed form" linewidth 2 linecolor rgb "#2060c0", \
    $nodes using 1:(rest($1)) title "nodes" with points pointtype 7 pointsize 0.5 linecolor rgb "#c03020", \
    $panels using 1:(0) title "panel ends" with points pointtype 2 pointsize 0.7 linecolor rgb "black"
unset multiplot
