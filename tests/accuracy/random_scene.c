/* Scenes made up at random: see random_scene.h. */
#include "random_scene.h"
#include "random_numbers.h"
#include "vector.h"

#include <stdlib.h>
#include <string.h>

/* ---- Kinds of scenes ---------------------------------------------------------------------------------------------------- */

/* Scenes of more than a single source without weights. */
typedef struct combination {
    const char *name;
    double share;
    int count_of_each;             /* how many sources there are of each kind, */
    int counts[SOURCE_KIND_COUNT]; /* and how many more of some */
} combination;

/* Those of the papers' integral have no paths, so that they stay the scenes they were before there were paths. */
static const combination papers_combinations[RANDOM_SCENE_COMBINATION_COUNT] = {
    {.name = "weighted curve", .share = 0.25, .counts = {[KIND_CURVE] = 1}},
    {.name = "two curves", .share = 0.08, .counts = {[KIND_CURVE] = 2}},
    {.name = "mix", .share = 0.12, .counts = {[KIND_POINT] = 1, [KIND_LINE] = 1, [KIND_TORUS] = 1, [KIND_CURVE] = 1}},
    {.name = "many", .share = 0.05, .counts = {[KIND_POINT] = 5, [KIND_LINE] = 5, [KIND_TORUS] = 5, [KIND_CURVE] = 5}},
};

static const combination world_combinations[RANDOM_SCENE_COMBINATION_COUNT] = {
    {.name = "world weighted curve", .share = 0.08, .counts = {[KIND_CURVE] = 1}},
    {.name = "world weighted path", .share = 0.12, .counts = {[KIND_PATH] = 1}},
    {.name = "world mix", .share = 0.1, .count_of_each = 1},
    {.name = "world many", .share = 0.02, .count_of_each = 3},
};

static bool is_world_kind(int scene_kind)
{
    return scene_kind >= RANDOM_PAPERS_KIND_COUNT;
}

/* NULL if it is a single source. */
static const combination *combination_of(int scene_kind)
{
    int number = scene_kind % RANDOM_PAPERS_KIND_COUNT - SOURCE_KIND_COUNT;
    return number < 0 ? NULL : is_world_kind(scene_kind) ? &world_combinations[number] : &papers_combinations[number];
}

const char *random_scene_kind_name(int scene_kind)
{
    const combination *several = combination_of(scene_kind);
    if (several) return several->name;
    const source_kind *kind = source_kinds[scene_kind % RANDOM_PAPERS_KIND_COUNT];
    return is_world_kind(scene_kind) ? kind->world_scene_name : kind->name;
}

int random_scene_kind_find(const char *name)
{
    for (int kind = 0; kind < RANDOM_SCENE_KIND_COUNT; kind++)
        if (strcmp(random_scene_kind_name(kind), name) == 0) return kind;
    return -1;
}

static double share_of(int scene_kind)
{
    const combination *several = combination_of(scene_kind);
    if (several) return several->share;
    const source_kind *kind = source_kinds[scene_kind % RANDOM_PAPERS_KIND_COUNT];
    return is_world_kind(scene_kind) ? kind->world_scene_share : kind->scene_share;
}

static int count_of(int scene_kind, int kind)
{
    const combination *several = combination_of(scene_kind);
    return several ? several->count_of_each + several->counts[kind] : scene_kind % RANDOM_PAPERS_KIND_COUNT == kind;
}

/* The first numbers of a seed's sequence choose the kind. */
static int choose_kind(scene_maker *m)
{
    int first = m->is_world ? RANDOM_PAPERS_KIND_COUNT : 0, last = first + RANDOM_PAPERS_KIND_COUNT - 1, kind = first;
    double sum = 0;
    for (int i = first; i <= last; i++)
        sum += share_of(i);
    double left = sum * random_unit(&m->random);
    while (kind < last && left >= share_of(kind))
        left -= share_of(kind++);
    return kind;
}

static bool is_world_seed(uint64_t seed)
{
    return seed / RANDOM_WORLD_SEED % 2 == 1;
}

static bool is_fog_seed(uint64_t seed)
{
    return seed >= 2 * RANDOM_WORLD_SEED && seed < 4 * RANDOM_WORLD_SEED;
}

static bool is_media_seed(uint64_t seed)
{
    return seed >= 4 * RANDOM_WORLD_SEED;
}

int random_scene_kind_of(uint64_t seed)
{
    scene_maker m = {.random = seed, .is_world = is_world_seed(seed)};
    return choose_kind(&m);
}

/* ---- The parts of a scene ----------------------------------------------------------------------------------------------- */

/* How bright a source is, in the papers' integral. */
static void write_coefficient(scene_maker *m)
{
    fprintf(m->file, "\"coefficient\": %.3g", m->distance * maker_between(m, 0.1, 1));
}

/* In the world integral. */
static void write_light(scene_maker *m)
{
    double core = m->epsilon;
    if (maker_chance(m, 0.7) || core < m->least_core) {
        core = fmax(m->least_core, m->distance * maker_magnitude(m, 1e-6, 1e-1));
        fprintf(m->file, "\"core\": %.17g, ", core);
    }
    double narrowest = fmax(2 * core, 1e-2 * m->distance), widest = fmax(narrowest, 10 * m->distance);
    double reach = maker_chance(m, 0.1) ? core * maker_between(m, 1.01, 2) : maker_magnitude(m, narrowest, widest);
    fprintf(m->file, "\"reach\": %.17g, ", reach);
    if (maker_chance(m, 0.3)) fprintf(m->file, "\"sharpness\": %.3g, ", maker_between(m, 1, 4));
    fprintf(m->file, "\"%s\": %.3g", maker_chance(m, 0.7) ? "brightness" : "coefficient", maker_between(m, 0.1, 1));
}

static void write_sources(scene_maker *m, int scene_kind)
{
    bool first = true;
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        int count = count_of(scene_kind, k);
        for (int i = 0; i < count; i++) {
            fprintf(m->file, i == 0 ? ",\n  \"%s\": [\n    { " : ",\n    { ", source_kinds[k]->list_name);
            /* Of two curves, the first has weights. */
            m->least_core = 0;
            source_kinds[k]->write(m, first, combination_of(scene_kind) && i == 0);
            if (m->is_world)
                write_light(m);
            else
                write_coefficient(m);
            fputs(i + 1 == count ? " }\n  ]" : " }", m->file);
            first = false;
        }
    }
}

/* Leaves the camera open for its near and far planes. */
static void write_camera(scene_maker *m)
{
    double target[3], up[3], offset[3];
    bool orthographic = maker_chance(m, 0.15), in_core = maker_chance(m, 0.05);
    double least = fmax(1e-4, 20 * m->epsilon / m->distance);
    double height = m->distance * (maker_chance(m, 0.6) ? maker_magnitude(m, 0.1, 3) : maker_magnitude(m, fmin(least, 1), 1));
    maker_direction(m, up);
    maker_offset(m, 0.4 * height, offset);
    vector_add_scaled(m->place, 1, offset, target);
    if (in_core) {
        maker_offset(m, m->epsilon, offset);
        vector_add_scaled(m->place, 1, offset, m->eye);
        vector_add_scaled(m->eye, m->distance, m->forward, target);
    }
    fputs("  \"camera\": { ", m->file);
    maker_write_vector(m, "eye", m->eye);
    maker_write_vector(m, "target", target);
    maker_write_vector(m, "up", up);
    if (orthographic)
        fprintf(m->file, "\"projection\": \"orthographic\", \"height\": %.17g, ", height);
    else
        fprintf(m->file, "\"fov_y_degrees\": %.17g, ", 360 / M_PI * atan(0.5 * height / m->distance));
}

/* Closes the camera. */
static void write_depths(scene_maker *m)
{
    double ratio = maker_magnitude(m, 1.2, 1e4),
           share = maker_chance(m, 0.85) ? maker_between(m, 0.02, 0.98) : maker_between(m, -0.2, 1.2);
    double start = m->distance * pow(ratio, -share), end = start * ratio;
    double near_depth = fmax(start, 1e-3 * m->distance) * maker_magnitude(m, 0.1, 0.9), far_depth = fmax(end, m->distance) * 2;
    fprintf(m->file, "\"near\": %.17g, \"far\": %.17g },\n", near_depth, far_depth);
    fprintf(m->file, "  \"interval\": { \"start\": %.17g, \"end\": %.17g },\n", start, end);
    fprintf(m->file, "  \"decay\": { \"alpha\": 1, \"beta\": %.17g },\n", maker_magnitude(m, 0.05, 4));
    fprintf(m->file, "  \"epsilon\": %.17g", m->epsilon);
}

/* Closes the camera of the world integral. */
static void write_world_depths(scene_maker *m)
{
    double near_depth = m->distance * maker_magnitude(m, 1e-3, 0.9), far_depth = m->distance * maker_magnitude(m, 1, 1e3);
    fprintf(m->file, "\"near\": %.17g, \"far\": %.17g },\n", near_depth, far_depth);
    if (maker_chance(m, 0.3)) fprintf(m->file, "  \"core_pixels\": %.3g,\n", maker_chance(m, 0.4) ? 0 : maker_between(m, 0, 4));
    fprintf(m->file, "  \"epsilon\": %.17g", m->epsilon);
}

/* Before, in or behind the core. */
static void random_opaque_place(scene_maker *m, double place[3])
{
    double along, which = maker_between(m, 0, 1);
    if (which < 0.3)
        along = -maker_magnitude(m, m->epsilon, 0.5 * m->distance);
    else if (which < 0.6)
        along = maker_between(m, -1, 1) * m->epsilon;
    else
        along = maker_magnitude(m, m->epsilon, 0.5 * m->distance);
    vector_add_scaled(m->place, along, m->forward, place);
}

static void write_opaque(scene_maker *m)
{
    double place[3], across[3], normal[3];
    random_opaque_place(m, place);
    maker_direction(m, across);
    if (maker_chance(m, 0.7)) {
        vector_add_scaled(m->forward, 0.8, across, normal);
        fputs(",\n  \"opaque\": [ { \"shape\": \"plane\", ", m->file);
        maker_write_vector(m, "point", place);
        fprintf(m->file, "\"normal\": [%.17g, %.17g, %.17g] } ]", -normal[0], -normal[1], -normal[2]);
        return;
    }
    double size = m->distance * maker_magnitude(m, 1e-3, 1), min[3], max[3];
    vector_add_scaled(place, size, m->forward, place);
    for (int i = 0; i < 3; i++) {
        min[i] = place[i] - size;
        max[i] = place[i] + size;
    }
    fputs(",\n  \"opaque\": [ { \"shape\": \"box\", ", m->file);
    maker_write_vector(m, "min", min);
    fprintf(m->file, "\"max\": [%.17g, %.17g, %.17g] } ]", max[0], max[1], max[2]);
}

static void write_fog(scene_maker *m)
{
    double depth = maker_chance(m, 0.8) ? maker_magnitude(m, 1e-2, 10) : maker_magnitude(m, 1e-6, 1e3);
    fprintf(m->file, ",\n  \"fog\": { \"extinction\": %.17g", depth / m->distance);
    if (maker_chance(m, 0.5)) {
        double up[3], scale = m->distance * maker_magnitude(m, 1e-2, 10);
        maker_direction(m, up);
        double base = vector_dot(up, m->place) + scale * maker_between(m, -1, 1);
        fputs(", \"height\": { ", m->file);
        maker_write_vector(m, "up", up);
        fprintf(m->file, "\"scale\": %.17g, \"base\": %.17g }", scale, base);
    }
    fputs(" }", m->file);
}

/* A body about as far around the place as it is large, or around the eye. */
static void write_medium(scene_maker *m, bool is_first)
{
    static const char *const shapes[] = {"box", "sphere", "ellipsoid"};
    int shape = (int)maker_between(m, 0, 3);
    double size = m->distance * maker_magnitude(m, 1e-2, 3), center[3], radii[3];
    double depth = maker_chance(m, 0.8) ? maker_magnitude(m, 1e-2, 10) : maker_magnitude(m, 1e-6, 1e3);
    maker_offset(m, size * maker_between(m, 0, 1.5), center);
    vector_add_scaled(center, 1, maker_chance(m, 0.2) ? m->eye : m->place, center);
    fprintf(m->file, "%s { \"shape\": \"%s\", \"extinction\": %.17g, ", is_first ? "" : ",", shapes[shape], depth / size);
    for (int i = 0; i < 3; i++)
        radii[i] = size * maker_magnitude(m, 0.1, 1);
    if (shape == 0) {
        double min[3], max[3];
        vector_subtract(center, radii, min);
        vector_add_scaled(center, 1, radii, max);
        maker_write_vector(m, "min", min);
        fprintf(m->file, "\"max\": [%.17g, %.17g, %.17g] }", max[0], max[1], max[2]);
        return;
    }
    maker_write_vector(m, "center", center);
    if (shape == 1) {
        fprintf(m->file, "\"radius\": %.17g }", radii[0]);
        return;
    }
    double first[3], second[3], third[3];
    maker_direction(m, first);
    maker_direction(m, second);
    vector_cross(first, second, third);
    vector_cross(third, first, second);
    maker_write_vector(m, "radii", radii);
    fprintf(m->file, "\"axes\": [[%.17g, %.17g, %.17g], [%.17g, %.17g, %.17g], [%.17g, %.17g, %.17g]] }", first[0], first[1],
            first[2], second[0], second[1], second[2], third[0], third[1], third[2]);
}

static void write_media(scene_maker *m)
{
    int count = 1 + (int)maker_between(m, 0, 6);
    if (maker_chance(m, 0.4)) write_fog(m);
    fputs(",\n  \"media\": [", m->file);
    for (int i = 0; i < count; i++)
        write_medium(m, i == 0);
    fputs(" ]", m->file);
}

char *random_scene_text(uint64_t seed)
{
    char *text = NULL;
    size_t size;
    scene_maker m = {.random = seed, .is_world = is_world_seed(seed), .file = open_memstream(&text, &size)};
    if (!m.file) return NULL;
    int kind = choose_kind(&m);
    m.distance = maker_magnitude(&m, 1e-3, 1e5);
    m.epsilon = m.distance * maker_magnitude(&m, 1e-6, 1e-1);
    maker_direction(&m, m.forward);
    maker_offset(&m, maker_chance(&m, 0.5) ? 0 : m.distance * maker_magnitude(&m, 1, 1e5), m.eye);
    vector_add_scaled(m.eye, m.distance, m.forward, m.place);

    fprintf(m.file, "{\n  \"comment\": \"Random scene %llu.\",\n", (unsigned long long)seed);
    write_camera(&m);
    if (m.is_world)
        write_world_depths(&m);
    else
        write_depths(&m);
    if (is_fog_seed(seed)) write_fog(&m);
    if (is_media_seed(seed)) write_media(&m);
    write_sources(&m, kind);
    if (maker_chance(&m, 0.5)) write_opaque(&m);
    fputs("\n}\n", m.file);
    bool ok = !ferror(m.file);
    if (fclose(m.file) == 0 && ok) return text;
    free(text);
    return NULL;
}
