/*
 * Writes the text of every class of shader permutation to files: shader_text FOLDER. Names are PROFILE-KEY.vert and
 * PROFILE-KEY.frag.
 */
#include "plan/shader_text.h"
#include "model/sources.h"

#include <stdio.h>
#include <stdlib.h>

static const char *folder;

/* A dialect of which all shaders are written. */
typedef struct shader_profile {
    const char *name;
    ew_dialect dialect;
    const char *include_version; /* of the shaders that have the text for hosts; NULL for none of these */
} shader_profile;

static void write_strings(const char *profile, const char *role, ew_key key, const char *stage, const char *const *strings,
                          int count)
{
    char path[4096];
    if (count > EW_SHADER_MAX_STRINGS) {
        fprintf(stderr, "%s%09llx takes %d strings\n", role, (unsigned long long)key, count);
        exit(EXIT_FAILURE);
    }
    snprintf(path, sizeof path, "%s/%s-%s%09llx.%s", folder, profile, role, (unsigned long long)key, stage);
    FILE *file = fopen(path, "w");
    for (int i = 0; file && i < count; ++i)
        fputs(strings[i], file);
    if (!file || fclose(file) != 0) {
        perror(path);
        exit(EXIT_FAILURE);
    }
}

/* ---- What can meet ---- */

/* The fields that an integral can have: the papers' and the world's, with and without what sources may have. */
static const unsigned fields[] = {
    0,
    EW_PERMUTATION_REACH,
    EW_PERMUTATION_REACH | EW_PERMUTATION_SHARPNESS,
    EW_PERMUTATION_REACH | EW_PERMUTATION_WORLD,
    EW_PERMUTATION_REACH | EW_PERMUTATION_WORLD | EW_PERMUTATION_SHARPNESS,
};
enum { FIELD_COUNT = sizeof fields / sizeof fields[0] };

static const unsigned no_kinds = 0, all_kinds = (1u << EW_KIND_COUNT) - 1;

static int kind_count(unsigned kinds)
{
    int count = 0;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        count += kinds >> kind & 1;
    return count;
}

static bool takes_weights(unsigned kinds)
{
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (kinds & 1u << kind && ew_kinds[kind]->weights) return true;
    return false;
}

static bool takes_forms(unsigned kinds)
{
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (kinds & 1u << kind && ew_kinds[kind]->chain) return true;
    return false;
}

/* The key of a set of kinds, a set of bits. Counts are few (a literal) and many in turn, the first of them `first`. */
static ew_key with_kinds(ew_key key, unsigned kinds, size_t first)
{
    size_t count = first;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        if (!(kinds & 1u << kind)) continue;
        key = ew_permutation_with_count(key, kind, count);
        count = EW_ANY_COUNT + 1 - count;
    }
    return key;
}

/* ---- Shaders of the library ---- */

static const char *const pass_names[EW_PASS_COUNT] = {[EW_PASS_WAVE] = "",
                                                      [EW_PASS_SURFACES] = "surfaces-",
                                                      [EW_PASS_MEDIA] = "media-",
                                                      [EW_PASS_NODES] = "nodes-",
                                                      [EW_PASS_FIELD] = "field-",
                                                      [EW_PASS_PEAK] = "peak-",
                                                      [EW_PASS_CLASSES] = "classes-",
                                                      [EW_PASS_CELLS] = "cells-",
                                                      [EW_PASS_INTERPOLATION] = "interpolation-"};

static void write_pass(const shader_profile *profile, ew_pass pass, ew_key key)
{
    ew_shader_text text;
    ew_key pass_key = ew_permutation_of_pass(pass, key);
    ew_write_fragment_shader(&text, &profile->dialect, pass, pass_key);
    write_strings(profile->name, pass_names[pass], pass_key, "frag", text.strings, text.count);
    ew_write_vertex_shader(&text, &profile->dialect, pass, pass_key);
    write_strings(profile->name, pass_names[pass], pass_key, "vert", text.strings, text.count);
}

static void write_fragment_shader(const shader_profile *profile, ew_key key)
{
    ew_shader_text text;
    ew_write_fragment_shader(&text, &profile->dialect, EW_PASS_WAVE, key);
    write_strings(profile->name, "", key, "frag", text.strings, text.count);
}

static void write_permutation(const shader_profile *profile, ew_key key)
{
    ew_shader_text text;
    write_fragment_shader(profile, key);
    ew_write_vertex_shader(&text, &profile->dialect, EW_PASS_WAVE, key);
    write_strings(profile->name, "", key, "vert", text.strings, text.count);
}

/* The parts into which sources are divided, and what becomes of their sum. */
static void write_parts(const shader_profile *profile, ew_key key)
{
    static const ew_pass passes[] = {EW_PASS_NODES, EW_PASS_CELLS, EW_PASS_WAVE};
    const bool has_samples = key & EW_PERMUTATION_DEPTH_MULTISAMPLE;
    const size_t pass_count = has_samples ? 2 : 3;
    if (!ew_permutation_can_be_split(key & ~(ew_key)EW_PERMUTATION_DEPTH_MULTISAMPLE)) return;
    for (int part = 0; part < EW_PART_COUNT; ++part)
        for (size_t i = 0; ew_permutation_has_part(key, (ew_part)part) && i < pass_count; ++i)
            write_pass(profile, passes[i], ew_permutation_of_part(key, (ew_part)part));
    write_pass(profile, EW_PASS_WAVE, ew_permutation_summed(key));
    write_pass(profile, EW_PASS_CELLS, ew_permutation_summed(key));
    write_pass(profile, EW_PASS_SURFACES, ew_permutation_summed(0));
}

/* Whether a set of kinds is written with paths of these forms: alone, with each form and with all; beside other kinds, with
 * beams and with all. */
static bool has_forms(unsigned kinds, ew_key forms)
{
    const bool is_alone = kind_count(kinds) == 1;
    if (!takes_forms(kinds)) return forms == 0;
    if (is_alone && (forms == EW_PERMUTATION_POLYLINES || forms == EW_PERMUTATION_BENDS)) return true;
    return forms == EW_PERMUTATION_BEAMS || forms == EW_PERMUTATION_FORMS;
}

/* Every integral that the kinds can have. */
static void write_integrals(const shader_profile *profile, unsigned kinds, size_t first_count)
{
    const unsigned flags[] = {EW_PERMUTATION_WEIGHTS, EW_PERMUTATION_SIMPSON,   EW_PERMUTATION_CORE_PIXELS,
                              EW_PERMUTATION_BEAMS,   EW_PERMUTATION_POLYLINES, EW_PERMUTATION_BENDS};
    for (unsigned set = 0; set < 64; ++set) {
        ew_key key = 0;
        for (int i = 0; i < 6; ++i)
            if (set & 1u << i) key |= flags[i];
        if (!has_forms(kinds, key & EW_PERMUTATION_FORMS)) continue;
        if (key & EW_PERMUTATION_WEIGHTS && !takes_weights(kinds)) continue;
        for (int field = 0; field < FIELD_COUNT; ++field) {
            ew_key exact = with_kinds(key | fields[field], kinds, first_count);
            bool has_lists = first_count == EW_ANY_COUNT && !(key & EW_PERMUTATION_SIMPSON);
            write_permutation(profile, has_lists ? ew_permutation_with_lists(exact) : exact);
            if (kinds == all_kinds) write_parts(profile, has_lists ? ew_permutation_with_lists(exact) : exact);
        }
    }
}

/* Kinds meet in pairs, and all at once; three and four of them in the default integrals alone. */
static void write_all_integrals(const shader_profile *profile)
{
    for (unsigned kinds = no_kinds; kinds <= all_kinds; ++kinds) {
        int count = kind_count(kinds);
        if (count <= 2 || kinds == all_kinds) write_integrals(profile, kinds, 1);
        if (count == 1 || kinds == all_kinds) write_integrals(profile, kinds, EW_ANY_COUNT);
        if (count <= 2 || kinds == all_kinds) continue;
        const ew_key forms = takes_forms(kinds) ? EW_PERMUTATION_BEAMS : 0;
        write_permutation(profile, with_kinds(forms, kinds, 1));
        write_permutation(profile, with_kinds(forms | fields[3] | EW_PERMUTATION_CORE_PIXELS, kinds, EW_ANY_COUNT));
    }
}

/* The passes of adaptive resolution. */
static void write_grid_passes(const shader_profile *profile, ew_key key)
{
    if (key & EW_PERMUTATION_EVALUATIONS) return;
    for (int pass = 0; pass < EW_PASS_COUNT; ++pass)
        if (ew_pass_is_of_grid((ew_pass)pass)) write_pass(profile, (ew_pass)pass, key);
}

/* What the light on surfaces may know of its sources beside their kinds. */
static const unsigned emitters[] = {
    EW_PERMUTATION_BEAMS,
    EW_PERMUTATION_REACH | EW_PERMUTATION_BEAMS,
    EW_PERMUTATION_REACH | EW_PERMUTATION_BEAMS | EW_PERMUTATION_WEIGHTS,
    EW_PERMUTATION_REACH | EW_PERMUTATION_POLYLINES,
    EW_PERMUTATION_REACH | EW_PERMUTATION_BEAMS | EW_PERMUTATION_POLYLINES | EW_PERMUTATION_BENDS | EW_PERMUTATION_WEIGHTS,
};

/* The light on surfaces: of the kinds one by one, and of all at once. */
static void write_surfaces(const shader_profile *profile)
{
    const unsigned shaded = EW_PERMUTATION_SHADOWS | EW_PERMUTATION_NORMALS;
    for (size_t i = 0; i < sizeof emitters / sizeof emitters[0]; ++i) {
        const ew_key key = emitters[i] | EW_PERMUTATION_IRRADIANCE | EW_PERMUTATION_WORLD | EW_PERMUTATION_DEPTH;
        const ew_key many = with_kinds(ew_permutation_with_lists(key), all_kinds, EW_ANY_COUNT);
        for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
            write_pass(profile, EW_PASS_SURFACES, ew_permutation_with_count(key | (kind % 2 ? shaded : 0), kind, 1));
        write_pass(profile, EW_PASS_SURFACES, many | shaded);
        for (int part = 0; part < EW_PART_COUNT; ++part)
            if (ew_permutation_has_part(many, (ew_part)part))
                write_pass(profile, EW_PASS_SURFACES, ew_permutation_of_part(many | shaded, (ew_part)part));
        write_pass(profile, EW_PASS_SURFACES, many | EW_PERMUTATION_SHADOWS | EW_PERMUTATION_DEPTH_MULTISAMPLE);
        write_pass(profile, EW_PASS_SURFACES, many | EW_PERMUTATION_DEPTH_MULTISAMPLE);
        write_pass(profile, EW_PASS_SURFACES, many | EW_PERMUTATION_SOURCE_TEXTURE);
    }
}

/* All that main() can do, with each field: without sources, and with all kinds. */
static void write_passes(const shader_profile *profile)
{
    static const unsigned depths[] = {0, EW_PERMUTATION_DEPTH, EW_PERMUTATION_DEPTH | EW_PERMUTATION_DEPTH_MULTISAMPLE};
    static const unsigned outputs[] = {0,
                                       EW_PERMUTATION_DITHER,
                                       EW_PERMUTATION_DITHER | EW_PERMUTATION_DITHER_SRGB,
                                       EW_PERMUTATION_SOFT,
                                       EW_PERMUTATION_SOFT | EW_PERMUTATION_DITHER,
                                       EW_PERMUTATION_SOFT | EW_PERMUTATION_DITHER | EW_PERMUTATION_DITHER_SRGB,
                                       EW_PERMUTATION_LUMINANCE,
                                       EW_PERMUTATION_EVALUATIONS};
    for (size_t depth = 0; depth < sizeof depths / sizeof depths[0]; ++depth)
        for (size_t output = 0; output < sizeof outputs / sizeof outputs[0]; ++output)
            for (int field = 0; field < FIELD_COUNT; ++field) {
                ew_key key = depths[depth] | outputs[output] | fields[field];
                write_fragment_shader(profile, key);
                write_grid_passes(profile, key);
                key |= EW_PERMUTATION_WEIGHTS | EW_PERMUTATION_FORMS | EW_PERMUTATION_CORE_PIXELS;
                ew_key general = ew_permutation_with_lists(with_kinds(key, all_kinds, EW_ANY_COUNT));
                write_fragment_shader(profile, general);
                write_grid_passes(profile, general);
                write_parts(profile, general);
                if (outputs[output] == 0) write_parts(profile, general | EW_PERMUTATION_SOURCE_TEXTURE);
                if (outputs[output] == 0) write_grid_passes(profile, general | EW_PERMUTATION_SOURCE_TEXTURE);
                write_fragment_shader(profile, with_kinds(key | EW_PERMUTATION_SIMPSON, all_kinds, 1));
            }
}

/* The kinds one by one and all at once, with and without all that they may have, in both kinds of fog and among media. */
static void write_fogs(const shader_profile *profile)
{
    static const unsigned fogs[] = {EW_PERMUTATION_FOG, EW_PERMUTATION_FOG | EW_PERMUTATION_FOG_HEIGHT,
                                    EW_PERMUTATION_FOG | EW_PERMUTATION_MEDIA,
                                    EW_PERMUTATION_FOG | EW_PERMUTATION_FOG_HEIGHT | EW_PERMUTATION_MEDIA};
    for (int fog = 0; fog < 4; ++fog)
        for (int field = 0; field < FIELD_COUNT; ++field) {
            ew_key plain = fogs[fog] | fields[field];
            const ew_key general = plain | EW_PERMUTATION_WEIGHTS | EW_PERMUTATION_FORMS | EW_PERMUTATION_CORE_PIXELS;
            for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
                write_permutation(profile, with_kinds(plain | EW_PERMUTATION_BEAMS, 1u << kind, 1));
                write_permutation(profile, with_kinds(general & ~(ew_key)EW_PERMUTATION_BENDS, 1u << kind, 1));
            }
            ew_key with_lists = ew_permutation_with_lists(with_kinds(general, all_kinds, EW_ANY_COUNT));
            write_permutation(profile, with_lists);
            write_grid_passes(profile, with_lists);
            write_parts(profile, with_lists);
            write_permutation(profile, with_kinds(general | EW_PERMUTATION_SIMPSON, all_kinds, 1));
        }
}

/* The media themselves, in both kinds of fog. */
static void write_media(const shader_profile *profile)
{
    static const unsigned extras[] = {0, EW_PERMUTATION_DITHER, EW_PERMUTATION_DEPTH,
                                      EW_PERMUTATION_DEPTH | EW_PERMUTATION_DEPTH_MULTISAMPLE | EW_PERMUTATION_DITHER |
                                          EW_PERMUTATION_DITHER_SRGB};
    const unsigned key = EW_PERMUTATION_WORLD | EW_PERMUTATION_FOG | EW_PERMUTATION_MEDIA;
    for (size_t i = 0; i < sizeof extras / sizeof extras[0]; ++i) {
        write_pass(profile, EW_PASS_MEDIA, key | extras[i]);
        write_pass(profile, EW_PASS_MEDIA, key | EW_PERMUTATION_FOG_HEIGHT | extras[i]);
    }
}

/* ---- The text for hosts ---- */

/* As the only thing in a shader that uses it. */
static void write_include(const shader_profile *profile, ew_key key)
{
    const char *interval = key & EW_PERMUTATION_WORLD ? "" : "vec2(0.0, 1.0), ";
    ew_shader_text text;
    ew_write_include(&text, &profile->dialect, key);
    char *joined = malloc(ew_join_shader_text(&text, NULL) + 1);
    if (!joined) exit(EXIT_FAILURE);
    ew_join_shader_text(&text, joined);
    const char *const strings[] = {
        profile->include_version,
        joined,
        "out vec4 color;\nvoid main()\n{\ncolor = ew_light(vec3(0.0), vec3(1.0), ",
        interval,
        "1.0);\ncolor.a = ew_luminance(vec3(0.0), vec3(1.0), ",
        interval,
        "1.0);\n",
        key & EW_PERMUTATION_IRRADIANCE
            ? "color.rgb += ew_irradiance(vec3(0.0), vec3(1.0)) + ew_specular(vec3(0.0), vec3(1.0), vec3(1.0), 0.5);\n"
            : "",
        key & EW_PERMUTATION_MEDIA ? "color += ew_media_light(vec3(0.0), vec3(1.0), 1.0);\n" : "",
        "}\n"};
    write_strings(profile->name, "include-", key, "frag", strings, sizeof strings / sizeof strings[0]);
    free(joined);
}

/* Without sources, of the kinds one by one, and of all at once with all that they may have. */
static void write_includes(const shader_profile *profile)
{
    const ew_key extras = EW_PERMUTATION_WEIGHTS | EW_PERMUTATION_FORMS | EW_PERMUTATION_CORE_PIXELS;
    for (unsigned simpson = 0; simpson <= EW_PERMUTATION_SIMPSON; simpson += EW_PERMUTATION_SIMPSON)
        for (int field = 0; field < FIELD_COUNT; ++field) {
            ew_key flags = simpson | fields[field] | EW_PERMUTATION_BEAMS;
            write_include(profile, flags);
            for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
                write_include(profile, ew_permutation_with_count(flags, kind, (size_t)kind % 2 + 1));
                if (field == 3) write_include(profile, ew_permutation_with_count(flags | EW_PERMUTATION_IRRADIANCE, kind, 1));
                if (!simpson) write_grid_passes(profile, ew_permutation_with_count(flags, kind, (size_t)kind % 2 + 1));
            }
            for (unsigned lit = 0; lit <= EW_PERMUTATION_IRRADIANCE; lit += EW_PERMUTATION_IRRADIANCE)
                write_include(profile, with_kinds(flags | extras | lit, all_kinds, EW_ANY_COUNT));
            const unsigned fog = EW_PERMUTATION_FOG | EW_PERMUTATION_FOG_HEIGHT;
            write_include(profile, with_kinds(flags | extras | fog, all_kinds, EW_ANY_COUNT));
            write_include(profile,
                          with_kinds(flags | extras | EW_PERMUTATION_FOG | EW_PERMUTATION_MEDIA, all_kinds, EW_ANY_COUNT));
            write_include(profile, with_kinds(flags | extras | fog | EW_PERMUTATION_MEDIA, all_kinds, EW_ANY_COUNT));
        }
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: shader_text FOLDER\n");
        return EXIT_FAILURE;
    }
    folder = argv[1];
    /* The capacities of the smallest uniform blocks that GL allows and of the largest in use, likewise the varyings: all few
     * sources fit between the stages, or not even a curve; the profiles' least versions; hardware and software. */
    size_t smallest = ew_sources_capacity(16384), largest = ew_sources_capacity(65536);
    const shader_profile profiles[] = {
        {"330", {false, false, false, 0, largest, 4096}, "#version 330\n"},
        {"330-software", {false, true, true, 31, largest, 4096}, NULL},
        {"300es-software", {true, false, true, 16, smallest, 1024}, NULL},
        {"300es", {true, true, false, 16, smallest, 1024}, "#version 300 es\n"},
    };
    for (size_t i = 0; i < sizeof profiles / sizeof profiles[0]; ++i) {
        write_all_integrals(&profiles[i]);
        write_passes(&profiles[i]);
        write_surfaces(&profiles[i]);
        write_fogs(&profiles[i]);
        write_media(&profiles[i]);
        if (profiles[i].include_version) write_includes(&profiles[i]);
    }
    return EXIT_SUCCESS;
}
