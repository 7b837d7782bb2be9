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

static void write_strings(const char *profile, const char *role, unsigned key, const char *stage, const char *const *strings,
                          int count)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s-%s%05x.%s", folder, profile, role, key, stage);
    FILE *file = fopen(path, "w");
    for (int i = 0; file && i < count; ++i)
        fputs(strings[i], file);
    if (!file || fclose(file) != 0) {
        perror(path);
        exit(EXIT_FAILURE);
    }
}

static void write_permutation(const shader_profile *profile, unsigned key)
{
    ew_shader_text text;
    ew_write_vertex_shader(&text, &profile->dialect, key);
    write_strings(profile->name, "", key, "vert", text.strings, text.count);
    ew_write_fragment_shader(&text, &profile->dialect, key);
    write_strings(profile->name, "", key, "frag", text.strings, text.count);
}

/* What main() does with the integral is the same for all of them: multisampled depth and dither meet only some. */
static bool is_wanted_pass(unsigned flags)
{
    const unsigned dither = EW_PERMUTATION_DITHER | EW_PERMUTATION_DITHER_SRGB;
    const unsigned outputs = EW_PERMUTATION_LUMINANCE | EW_PERMUTATION_EVALUATIONS;
    if ((flags & outputs) == outputs) return false;
    if (flags & EW_PERMUTATION_DEPTH_MULTISAMPLE)
        return flags & EW_PERMUTATION_DEPTH && !(flags & (dither | EW_PERMUTATION_SIMPSON | EW_PERMUTATION_WEIGHTS));
    if (flags & dither) return flags == EW_PERMUTATION_DITHER || flags == dither;
    return true;
}

/* Whether one of the kinds, a set of bits, takes weights. */
static bool takes_weights(unsigned kinds)
{
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (kinds & 1u << kind && ew_kinds[kind]->weights) return true;
    return false;
}

/* Every set of flags that can meet, on every set of kinds, with few sources of each (a literal count) and with many. */
static void write_permutations(const shader_profile *profile)
{
    for (unsigned flags = 0; flags < 1u << EW_PERMUTATION_FLAG_COUNT; ++flags) {
        if (!is_wanted_pass(flags)) continue;
        for (unsigned kinds = 0; kinds < 1u << EW_KIND_COUNT; ++kinds) {
            if (flags & EW_PERMUTATION_WEIGHTS && !takes_weights(kinds)) continue;
            for (unsigned count = 1; count <= EW_ANY_COUNT; count += EW_ANY_COUNT - 1) {
                unsigned key = flags;
                for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
                    if (kinds & 1u << kind) key = ew_permutation_with_count(key, kind, count);
                write_permutation(profile, key);
            }
        }
    }
}

/* The text for hosts' shaders, as the only thing in a shader that uses it. */
static void write_include(const shader_profile *profile, unsigned key)
{
    ew_shader_text text;
    ew_write_include(&text, &profile->dialect, key);
    char *joined = malloc(ew_join_shader_text(&text, NULL) + 1);
    if (!joined) exit(EXIT_FAILURE);
    ew_join_shader_text(&text, joined);
    const char *const strings[] = {profile->include_version, joined, "out vec4 color;\nvoid main()\n{\n",
                                   "color = ew_light(vec3(0.0), vec3(1.0), vec2(0.0, 1.0), 1.0);\n",
                                   "color.a = ew_luminance(vec3(0.0), vec3(1.0), vec2(0.0, 1.0), 1.0);\n}\n"};
    write_strings(profile->name, "include-", key, "frag", strings, 5);
    free(joined);
}

/* Without sources, of the kinds one by one, and of all at once with weights. */
static void write_includes(const shader_profile *profile)
{
    for (unsigned simpson = 0; simpson <= EW_PERMUTATION_SIMPSON; simpson += EW_PERMUTATION_SIMPSON) {
        unsigned all = simpson | EW_PERMUTATION_WEIGHTS;
        write_include(profile, simpson);
        for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
            write_include(profile, ew_permutation_with_count(simpson, kind, (size_t)kind % 4 + 1));
            all = ew_permutation_with_count(all, kind, EW_ANY_COUNT);
        }
        write_include(profile, all);
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
        {"330", {false, false, 0, largest}, "#version 330\n"},
        {"330-software", {false, true, 31, largest}, NULL},
        {"300es-software", {true, true, 16, smallest}, NULL},
        {"300es", {true, false, 16, smallest}, "#version 300 es\n"},
    };
    for (size_t i = 0; i < sizeof profiles / sizeof profiles[0]; ++i) {
        write_permutations(&profiles[i]);
        if (profiles[i].include_version) write_includes(&profiles[i]);
    }
    return EXIT_SUCCESS;
}
