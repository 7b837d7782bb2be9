/* The demo's energy as a function of time: see animation.h. */
#include "animation.h"
#include "vector.h"

static const double blue[3] = {0.08, 0.36, 1.0};
static const double teal[3] = {0.10, 0.75, 1.0};
static const double amber[3] = {1.0, 0.30, 0.03};
static const double rose[3] = {1.0, 0.08, 0.24};

/* When the orb fires, in seconds from the beginning of each repetition. */
static const double fire_second = 5;

/* How long the bolt and the ring last. */
static const double bolt_seconds = 3, ring_seconds = 3.4;

/* 0 up to `from`, 1 from `to` on, and smooth in between. */
static double ramp(double from, double to, double x)
{
    double t = fmin(fmax((x - from) / (to - from), 0), 1);
    return t * t * (3 - 2 * t);
}

/* A sine with `turns` whole periods in a repetition. */
static double wave(double seconds, int turns, double phase)
{
    return sin(2 * M_PI * (turns * seconds / ANIMATION_SECONDS + phase));
}

static void set_bezier(ew_curve *curve, const double start[3], const double middle[3], const double end[3])
{
    double points[3][3];
    vector_copy(start, points[0]);
    vector_copy(middle, points[1]);
    vector_copy(end, points[2]);
    ew_bezier_polynomial(points, curve->polynomial);
}

/* The orb's charge, from 0 to 1. It rises slowly, and is gone within a second of the shot. */
static double charge(double seconds)
{
    double up = ramp(0, fire_second, seconds);
    return up * up * (1 - ramp(fire_second, fire_second + 0.9, seconds));
}

static void set_orb(demo_animation *a, double seconds)
{
    double since = seconds - fire_second, flash = exp(-since * since / 0.03);
    a->orb.coefficient = 2.2 + 4.2 * charge(seconds) + 2.5 * flash;
}

/* A pulse by equation (5.1) of the thesis runs from the emitter to the orb every 2.5 seconds. Between pulses some glow remains.
 */
static void set_beam(demo_animation *a, int beam, double seconds)
{
    const double *from = court_emitters[beam];
    double side = beam ? 1 : -1, phase = beam * 0.37;
    double power = 0.35 + 0.65 * ramp(0, 1, seconds) * (1 - ramp(fire_second - 0.4, fire_second + 0.6, seconds));
    double middle[3] = {0.55 * from[0] + side * 0.8 * wave(seconds, 1, phase), 3.9 + 1.7 * wave(seconds, 2, phase),
                        0.5 * from[2] + 2.4 * wave(seconds, 3, phase + 0.2)};
    ew_curve *curve = &a->curves[beam];
    set_bezier(curve, from, middle, court_orb);
    curve->coefficient = 2.9 * power;
    double *weights = a->weights[beam], period = 2.5;
    double pulse_seconds = fmod(seconds + beam * period / 2, period);
    ew_fill_pulse_weights(60 * pulse_seconds, weights, ANIMATION_WEIGHTS);
    for (int i = 0; i < ANIMATION_WEIGHTS; i++)
        weights[i] = 0.3 + 0.9 * weights[i];
}

/* Where the bolt's end is when it reaches `reach` far. It sweeps along as it is shot. */
static void aim(double seconds, double reach, double result[3])
{
    double angle = M_PI * (-0.22 + 0.52 * ramp(0, 2.6, seconds));
    double target[3] = {-reach * cos(angle), 1.3 + 1.2 * sin(2.2 * seconds), -reach * sin(angle)};
    vector_copy(target, result);
}

static void set_bolt(demo_animation *a, double seconds)
{
    double since = seconds - fire_second;
    if (since < 0) since = 0;
    double reach = 0.3 + 13.5 * ramp(-0.2, 0.35, since);
    double middle[3], end[3];
    aim(since, reach, end);
    /* The middle lags behind the end, which bends the bolt. */
    aim(since - 0.45, 0.5 * reach, middle);
    middle[1] += 3.0;
    ew_curve *curve = &a->curves[ANIMATION_BOLT];
    set_bezier(curve, court_orb, middle, end);
    curve->coefficient = 5.2 * ramp(0, 0.25, since) * (1 - ramp(bolt_seconds - 1.1, bolt_seconds, since));
    double *weights = a->weights[ANIMATION_BOLT];
    /* The next pulse starts before the last one arrives, so two overlap. */
    double pulse[ANIMATION_WEIGHTS], period = 0.75;
    ew_fill_pulse_weights(110 * fmod(since, period), pulse, ANIMATION_WEIGHTS);
    ew_fill_pulse_weights(110 * (fmod(since, period) + period), weights, ANIMATION_WEIGHTS);
    for (int i = 0; i < ANIMATION_WEIGHTS; i++)
        weights[i] = 0.55 + 0.6 * (weights[i] + pulse[i]);
}

static void set_ring(demo_animation *a, double seconds)
{
    double since = fmod(seconds - fire_second + ANIMATION_SECONDS, ANIMATION_SECONDS);
    double left = 1 - ramp(0, ring_seconds, since);
    a->ring.radius = 0.4 + 15 * (1 - exp(-0.75 * since));
    a->ring.coefficient = 1.6 * ramp(0, 0.5, since) * left;
}

/* The blade was thrown: it spins about its middle while it flies around the steps. */
static void set_blade(demo_animation *a, double seconds)
{
    double round = 2 * M_PI * (seconds / ANIMATION_SECONDS + 0.08), turn = 2 * M_PI * 5 * seconds / ANIMATION_SECONDS;
    double middle[3] = {4.6 * sin(round), 1.75 + 0.35 * wave(seconds, 2, 0), 4.6 * cos(round)};
    double tangent[3] = {cos(round), 0, -sin(round)}, direction[3] = {0, 0.94 * sin(turn), 0.34 * sin(turn)};
    double hilt[3], tip[3];
    vector_add_scaled(direction, cos(turn), tangent, direction);
    vector_add_scaled(middle, -1.25, direction, hilt);
    vector_add_scaled(middle, 1.25, direction, tip);
    set_bezier(&a->curves[ANIMATION_BLADE], hilt, middle, tip);
}

static void set_camera(scene_camera *camera, double seconds)
{
    double angle = 0.24 + 0.17 * wave(seconds, 1, 0), distance = 16.4 + 0.8 * wave(seconds, 1, 0.2);
    vector_copy((double[3]){distance * sin(angle), 3.4 + 0.7 * wave(seconds, 1, 0.35), distance * cos(angle)}, camera->eye);
    vector_copy((double[3]){0.2, 2.75, 0}, camera->target);
}

void animation_init(demo_animation *a)
{
    *a = (demo_animation){.scene = {.camera = {.up = {0, 1, 0}, .fov_y_degrees = 40, .near_depth = 0.1, .far_depth = 90},
                                    .interval_start = 0.1,
                                    .interval_end = 45,
                                    .decay_alpha = 1,
                                    .decay_beta = 1,
                                    .exposure = 1,
                                    .background = {0.0018, 0.003, 0.008},
                                    .composite = EW_OUTPUT_LERP,
                                    .sources = {.epsilon = 0.012}}};
    vector_copy(court_orb, a->orb.position);
    vector_copy(blue, a->orb.color);
    vector_copy(court_orb, a->ring.center);
    vector_copy((double[3]){0.22, 1, 0.16}, a->ring.axis);
    vector_copy(teal, a->ring.color);
    for (int i = 0; i < ANIMATION_CURVES; i++) {
        ew_curve *curve = &a->curves[i];
        curve->domain[1] = 1;
        curve->weights = a->weights[i];
        curve->weight_count = ANIMATION_WEIGHTS;
        vector_copy(i == ANIMATION_BOLT ? amber : i == ANIMATION_BLADE ? rose : blue, curve->color);
    }
    ew_curve *blade = &a->curves[ANIMATION_BLADE];
    static const double blade_weights[] = {0.5, 1, 1, 0.6};
    for (int i = 0; i < 4; i++)
        a->weights[ANIMATION_BLADE][i] = blade_weights[i];
    blade->weight_count = 4;
    blade->coefficient = 3.8;

    ew_sources_desc *sources = &a->scene.sources;
    sources->points = &a->orb;
    sources->point_count = 1;
    sources->tori = &a->ring;
    sources->torus_count = 1;
    sources->curves = a->curves;
    sources->curve_count = ANIMATION_CURVES;
    a->scene.opaque = a->shapes;
    a->scene.opaque_count = court_make_shapes(a->shapes);
}

void animation_set_time(demo_animation *a, double seconds)
{
    double in_repetition = fmod(seconds, ANIMATION_SECONDS);
    if (in_repetition < 0) in_repetition += ANIMATION_SECONDS;
    set_orb(a, in_repetition);
    set_ring(a, in_repetition);
    for (int beam = 0; beam < ANIMATION_BEAMS; beam++)
        set_beam(a, beam, in_repetition);
    set_bolt(a, in_repetition);
    set_blade(a, in_repetition);
    set_camera(&a->scene.camera, in_repetition);
}
