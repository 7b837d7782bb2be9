/* The demo's energy as a function of time: see animation.h. */
#include "animation.h"
#include "path_shapes.h"
#include "vector.h"

/* When the orb fires, in seconds from the beginning of each repetition. */
static const double fire_second = 5;

/* How long the beam and the ring last. */
static const double beam_seconds = 2.6, ring_seconds = 3.4;

/* When the blade slashes and along which arc, and how long a slash takes to fade. */
static const struct {
    double second;
    path_arc arc;
} slashes[] = {{1.4, {{-3.3, 2.3, 4.6}, {0.3, 0.5, 0.8}, {-0.8, 1, 0}, 1.9, -0.85 * M_PI}},
               {2.9, {{-3.3, 2.3, 4.6}, {0.3, 0.5, 0.8}, {0.8, 1, 0}, 1.9, 0.85 * M_PI}},
               {8.2, {{-3.4, 1.9, 4.1}, {0.2, 1, 0.3}, {-1, 0, 0.2}, 2.0, 1.1 * M_PI}}};
enum { SLASH_COUNT = sizeof slashes / sizeof *slashes };
static const double slash_fade = 1.1;

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

/* The seconds since an event of this or the last repetition. */
static double seconds_since(double event, double seconds)
{
    return fmod(seconds - event + ANIMATION_SECONDS, ANIMATION_SECONDS);
}

static double flicker(double seconds, unsigned seed)
{
    return path_noise((path_clock){seconds, ANIMATION_SECONDS}, 12, seed);
}

/* The orb's charge, from 0 to 1. It rises slowly, and is gone within a second of the shot. */
static double charge(double seconds)
{
    double up = ramp(0, fire_second, seconds);
    return up * up * (1 - ramp(fire_second, fire_second + 0.9, seconds));
}

/* How strongly the emitters shine, from 0 to 1. */
static double power(double seconds)
{
    return ramp(0, 1, seconds) * (1 - ramp(fire_second - 0.4, fire_second + 0.3, seconds));
}

static void set_orb(demo_animation *a, double seconds)
{
    double since = seconds - fire_second, flash = exp(-since * since / 0.03), charged = charge(seconds);
    ew_point *orb = &a->points[ANIMATION_ORB];
    orb->core = 0.16 + 0.22 * charged;
    orb->reach = 1.6 + 1.4 * charged + 0.8 * flash;
    orb->brightness = 2 + 1.2 * charged + 1.2 * flash;
}

static void set_lightning(demo_animation *a, double seconds)
{
    const path_clock clock = {seconds, ANIMATION_SECONDS};
    ew_path *bolt = &a->paths[ANIMATION_BOLT], *branch = &a->paths[ANIMATION_BRANCH];
    path_make_bolt(court_emitters[0], court_orb, 0.06, clock, 1, a->path_points[ANIMATION_BOLT], bolt->point_count);
    path_make_bolt(court_emitters[0], court_orb, 0.11, clock, 2, a->path_points[ANIMATION_BRANCH], branch->point_count);
    bolt->brightness = power(seconds) * (2.0 + 0.6 * flicker(seconds, 11));
    branch->brightness = power(seconds) * fmax(0, 0.9 + 0.9 * flicker(seconds, 12));
}

/* A pulse by equation (5.1) of the thesis runs from the emitter to the orb every 2.5 seconds. Between pulses some glow remains.
 */
static void set_stream(demo_animation *a, double seconds)
{
    ew_path *stream = &a->paths[ANIMATION_STREAM];
    double *weights = a->weights[ANIMATION_STREAM];
    double(*points)[3] = a->path_points[ANIMATION_STREAM];
    for (size_t i = 0; i < stream->point_count; i++) {
        double u = (double)i / (double)(stream->point_count - 1), size = 4 * u * (1 - u);
        for (int j = 0; j < 3; j++)
            points[i][j] = court_emitters[1][j] + u * (court_orb[j] - court_emitters[1][j]);
        points[i][1] += size * (0.55 + 0.5 * wave(seconds, 4, -1.1 * u));
        points[i][2] += size * 0.8 * wave(seconds, 3, 0.3 - 0.9 * u);
    }
    stream->brightness = 2.4 * (0.25 + 0.75 * power(seconds));
    ew_fill_pulse_weights(50 * fmod(seconds, 2.5), weights, stream->weight_count);
    for (size_t i = 0; i < stream->weight_count; i++)
        weights[i] = 0.35 + 0.75 * weights[i];
}

/* Pulses climb the pillar while the spiral turns. */
static void set_spiral(demo_animation *a, double seconds)
{
    ew_path *spiral = &a->paths[ANIMATION_SPIRAL];
    path_helix helix = {.height = 5.6, .radii = {1.0, 0.8}, .turns = 3.5, .start_angle = -2 * M_PI * 0.2 * seconds};
    vector_copy(court_spiral_base, helix.base);
    spiral->brightness = 0.7;
    path_make_helix(&helix, a->path_points[ANIMATION_SPIRAL], spiral->point_count);
    for (size_t i = 0; i < spiral->weight_count; i++) {
        double u = (double)i / (double)(spiral->weight_count - 1), pulse = 0.5 + 0.5 * wave(seconds, 5, -1.5 * u);
        a->weights[ANIMATION_SPIRAL][i] = ramp(0, 0.12, u) * (1 - ramp(0.8, 1, u)) * (0.4 + 0.7 * pulse * pulse);
    }
}

/* The blade's edge lights up where it passes, and fades behind it. */
static void set_slash(demo_animation *a, double seconds)
{
    int latest = 0;
    for (int i = 1; i < SLASH_COUNT; i++)
        if (seconds_since(slashes[i].second, seconds) < seconds_since(slashes[latest].second, seconds)) latest = i;
    double since = seconds_since(slashes[latest].second, seconds);
    ew_path *slash = &a->paths[ANIMATION_SLASH];
    path_make_arc(&slashes[latest].arc, a->path_points[ANIMATION_SLASH], slash->point_count);
    double edge = since / 0.3, left = 1 - ramp(0.35, slash_fade, since);
    slash->brightness = 3 * left;
    for (size_t i = 0; i < slash->weight_count; i++) {
        double u = (double)i / (double)(slash->weight_count - 1), behind = edge - 1.1 * u;
        double tips = ramp(0, 0.25, u) * (1 - ramp(0.85, 1, u));
        a->weights[ANIMATION_SLASH][i] = tips * ramp(0, 0.15, behind) * exp(-0.6 * fmax(behind, 0));
    }
}

/* The orb fires at a pillar, which glows where it is hit. */
static void set_beam(demo_animation *a, double seconds)
{
    double since = fmax(seconds - fire_second, 0), u = ramp(0, 0.25, since);
    double left = ramp(0, 0.1, since) * (1 - ramp(beam_seconds - 0.9, beam_seconds, since));
    ew_path *beam = &a->paths[ANIMATION_BEAM];
    ew_point *impact = &a->points[ANIMATION_IMPACT];
    double(*points)[3] = a->path_points[ANIMATION_BEAM], way[3];
    vector_subtract(court_target, court_orb, way);
    vector_copy(court_orb, points[0]);
    vector_add_scaled(court_orb, fmax(u, 0.02), way, points[1]);
    beam->brightness = left * (2.6 + 0.25 * flicker(seconds, 21));
    impact->brightness = ramp(0.2, 0.3, since) * left * (2.4 + 0.5 * flicker(seconds, 22));
}

static void set_ring(demo_animation *a, double seconds)
{
    double since = seconds_since(fire_second, seconds);
    a->ring.radius = 0.3 + 13 * (1 - exp(-0.8 * since));
    a->ring.brightness = 1.8 * ramp(0, 0.3, since) * (1 - ramp(0.6, ring_seconds, since));
}

/* The gas in the globes glows with the emitters' power. */
static void set_globes(demo_animation *a, double seconds)
{
    static const double moonlit[3] = {0.004, 0.006, 0.012};
    static const double colors[ANIMATION_GLOBES][3] = {{0.10, 0.16, 0.45}, {0.03, 0.28, 0.25}};
    for (int i = 0; i < ANIMATION_GLOBES; i++) {
        double light = 0.1 + power(seconds) * (0.5 + 0.08 * flicker(seconds, 31 + (unsigned)i));
        vector_add_scaled(moonlit, light, colors[i], a->media[i].ambient);
    }
}

/* The force field flares up where the beam hits it. */
static void set_shield(demo_animation *a)
{
    static const double at_rest[3] = {0.006, 0.016, 0.020}, color[3] = {0.015, 0.08, 0.095};
    vector_add_scaled(at_rest, a->points[ANIMATION_IMPACT].brightness, color, a->media[ANIMATION_SHIELD].ambient);
}

/* Before the court, to and fro; or from far away into the orb, nearer by the same factor in every second. */
static void set_camera(scene_camera *camera, bool flies, double seconds)
{
    double angle = 0.24 + 0.14 * wave(seconds, 1, 0), distance = 16.4 + 0.8 * wave(seconds, 1, 0.2);
    double height = 3.4 + 0.7 * wave(seconds, 1, 0.35);
    vector_copy((double[3]){distance * sin(angle), height, distance * cos(angle)}, camera->eye);
    vector_copy((double[3]){0.9, 2.75, 0}, camera->target);
    if (!flies) return;
    double nearness = pow(0.001, seconds / ANIMATION_SECONDS);
    vector_copy(court_orb, camera->target);
    vector_add_scaled(court_orb, nearness, (double[3]){24, 12, 96}, camera->eye);
}

static void init_points(demo_animation *a)
{
    a->points[ANIMATION_ORB] = (ew_point){.color = {0.4, 0.8, 2.0}, .sharpness = 2.5};
    a->points[ANIMATION_IMPACT] = (ew_point){.color = {1.6, 0.5, 0.12}, .core = 0.22, .reach = 1.8, .sharpness = 2};
    vector_copy(court_orb, a->points[ANIMATION_ORB].position);
    vector_copy(court_target, a->points[ANIMATION_IMPACT].position);
    a->ring = (ew_torus){.axis = {0.22, 1, 0.16}, .color = {0.15, 0.9, 1.3}, .core = 0.05, .reach = 1.1, .sharpness = 2.5};
    vector_copy(court_orb, a->ring.center);
}

static void init_paths(demo_animation *a)
{
    static const ew_path paths[ANIMATION_PATHS] = {
        [ANIMATION_BOLT] =
            {.kind = EW_PATH_POLYLINE, .point_count = 25, .color = {0.5, 0.75, 2.0}, .core = 0.022, .reach = 0.8},
        [ANIMATION_BRANCH] =
            {.kind = EW_PATH_POLYLINE, .point_count = 25, .color = {0.4, 0.6, 2.0}, .core = 0.012, .reach = 0.5},
        [ANIMATION_STREAM] = {.kind = EW_PATH_CATMULL_ROM,
                              .point_count = 7,
                              .weight_count = 12,
                              .color = {0.1, 0.9, 0.8},
                              .core = 0.06,
                              .reach = 0.9},
        [ANIMATION_SPIRAL] = {.kind = EW_PATH_BSPLINE,
                              .point_count = 29,
                              .weight_count = 40,
                              .color = {0.9, 0.2, 1.8},
                              .core = 0.035,
                              .reach = 0.7},
        [ANIMATION_SLASH] = {.kind = EW_PATH_BSPLINE,
                             .point_count = 11,
                             .weight_count = 32,
                             .color = {2, 0.35, 0.65},
                             .core = 0.06,
                             .reach = 1.1},
        [ANIMATION_BEAM] = {.kind = EW_PATH_POLYLINE, .point_count = 2, .color = {1.8, 0.6, 0.14}, .core = 0.11, .reach = 1.3},
    };
    for (int i = 0; i < ANIMATION_PATHS; i++) {
        ew_path *path = &a->paths[i];
        *path = paths[i];
        path->points = (const double(*)[3])a->path_points[i];
        if (path->weight_count > 0) path->weights = a->weights[i];
        path->sharpness = 2.5;
    }
}

static ew_medium body(const double center[3], double across, double up, double extinction)
{
    ew_medium medium = {.shape = EW_MEDIUM_ELLIPSOID,
                        .half_axes = {{across, 0, 0}, {0, up, 0}, {0, 0, across}},
                        .extinction = extinction,
                        .albedo = 1};
    vector_copy(center, medium.center);
    return medium;
}

static void init_media(demo_animation *a)
{
    for (int i = 0; i < ANIMATION_GLOBES; i++)
        a->media[i] = body(court_emitters[i], 0.6, 0.6, 0.9);
    a->media[ANIMATION_SHIELD] = body(court_shield, 1.7, 3.6, 0.2);
}

void animation_init(demo_animation *a)
{
    *a = (demo_animation){.scene = {.camera = {.up = {0, 1, 0}, .fov_y_degrees = 42, .near_depth = 0.05, .far_depth = 300},
                                    .decay_alpha = 1,
                                    .decay_beta = 1,
                                    .core_pixels = EW_CORE_PIXELS_DEFAULT,
                                    .exposure = 1,
                                    .light_gain = 12,
                                    .light_reach = 6,
                                    .shadow_thickness = 1.2,
                                    .fog = {.extinction = 0.09, .up = {0, 1, 0}, .scale = 1.3},
                                    .background = {0.0018, 0.003, 0.008},
                                    .composite = EW_OUTPUT_SOFT}};
    init_points(a);
    init_paths(a);
    init_media(a);
    ew_sources_desc *sources = &a->scene.sources;
    sources->points = a->points;
    sources->point_count = ANIMATION_POINTS;
    sources->tori = &a->ring;
    sources->torus_count = 1;
    sources->paths = a->paths;
    sources->path_count = ANIMATION_PATHS;
    a->scene.media = a->media;
    a->scene.medium_count = ANIMATION_MEDIA;
    a->scene.opaque = a->shapes;
    a->scene.opaque_count = court_make_shapes(a->shapes);
}

void animation_set_time(demo_animation *a, double seconds)
{
    double in_repetition = fmod(seconds, ANIMATION_SECONDS);
    if (in_repetition < 0) in_repetition += ANIMATION_SECONDS;
    set_orb(a, in_repetition);
    set_ring(a, in_repetition);
    set_globes(a, in_repetition);
    set_lightning(a, in_repetition);
    set_stream(a, in_repetition);
    set_spiral(a, in_repetition);
    set_slash(a, in_repetition);
    set_beam(a, in_repetition);
    set_shield(a);
    set_camera(&a->scene.camera, a->flies, in_repetition);
}
