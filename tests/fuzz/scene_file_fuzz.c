/*
 * The scene parser under any bytes: it takes them and the scene has finite triangles, or it refuses them with one line that
 * names the file. libFuzzer's entry point; replay.c is its main program where there is no libFuzzer.
 */
#include "opaque.h"
#include "scene_file.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define require(condition)                                                                                                     \
    do {                                                                                                                       \
        if (!(condition)) {                                                                                                    \
            fprintf(stderr, "%s:%d: broken promise: %s\n", __FILE__, __LINE__, #condition);                                    \
            abort();                                                                                                           \
        }                                                                                                                      \
    } while (0)

static void check_mesh(const demo_scene *scene)
{
    opaque_mesh mesh;
    require(opaque_make_mesh(scene, &mesh));
    for (size_t i = 0; i < mesh.triangle_count; i++)
        for (int corner = 0; corner < 3; corner++)
            require(mesh.triangles[i][corner] < mesh.vertex_count);
    for (size_t i = 0; i < mesh.vertex_count; i++)
        for (int axis = 0; axis < 3; axis++)
            require(isfinite(mesh.vertices[i].position[axis]) && isfinite(mesh.vertices[i].normal[axis]));
    opaque_free_mesh(&mesh);
}

/* A path has its points, and in the world integral light has its reach. */
static void check_sources(const demo_scene *scene)
{
    const ew_sources_desc *sources = &scene->sources;
    require(sources->epsilon > 0);
    for (size_t i = 0; i < sources->path_count; i++) {
        const ew_path *path = &sources->paths[i];
        double core = path->core > 0 ? path->core : sources->epsilon;
        require(path->points && path->point_count >= 2);
        require(path->reach > core || (path->reach == 0 && !scene_is_world(scene)));
        require(path->coefficient == 0 || path->brightness == 0);
    }
}

static void check_refusal(const char *message, size_t size)
{
    static const char start[] = "name: ";
    require(memchr(message, '\0', size));
    require(strncmp(message, start, strlen(start)) == 0 && message[strlen(start)] != '\0');
    require(!strchr(message, '\n'));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    enum { FEW_SHAPES = 16 }; /* spheres have so many triangles that more would slow the fuzzer down and show nothing new */
    demo_scene scene;
    char message[256];
    memset(message, 'x', sizeof message);
    if (!scene_parse((const char *)data, size, "name", &scene, message, sizeof message)) {
        check_refusal(message, sizeof message);
        return 0;
    }
    require(scene_is_world(&scene) || scene.interval_start < scene.interval_end);
    check_sources(&scene);
    if (scene.opaque_count <= FEW_SHAPES) check_mesh(&scene);
    scene_free(&scene);
    return 0;
}
