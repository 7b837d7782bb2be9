/* Offscreen with OSMesa, on machines without a display or a GPU: writes a beam and an orb to the PPM file that is named. */
#include <energywave.h>
#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 640, HEIGHT = 360 };

static void check(int ok, const char *what)
{
    if (ok) return;
    fprintf(stderr, "osmesa: %s\n", what);
    exit(1);
}

static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    return OSMesaGetProcAddress(name);
}

static void write_picture(const char *path, unsigned char (*pixels)[WIDTH][4])
{
    FILE *file = fopen(path, "wb");
    check(file != NULL, "the picture cannot be written");
    fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
    for (int y = HEIGHT - 1; y >= 0; y--) /* PPM counts from the top */
        for (int x = 0; x < WIDTH; x++)
            fwrite(pixels[y][x], 1, 3, file);
    check(fclose(file) == 0, "the picture cannot be written");
}

int main(int argc, char **argv)
{
    static unsigned char pixels[HEIGHT][WIDTH][4]; /* framebuffer 0 */
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    check(argc == 2, "name the picture, as in picture.ppm");
    OSMesaContext context = OSMesaCreateContextAttribs(attributes, NULL);
    check(context != NULL, "no OpenGL 3.3");
    check(OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, WIDTH, HEIGHT), "the context cannot be made current");

    ew_effect *effect;
    ew_error error;
    ew_point orb = {.position = {-2, 0, 0}, .core = 0.3, .reach = 2, .brightness = 2, .sharpness = 2, .color = {0.1, 0.4, 1}};
    const double ends[2][3] = {{-2, 0, 0}, {4, 1, -1}};
    ew_path beam = {.points = ends, .point_count = 2, .core = 0.05, .reach = 1, .brightness = 2, .sharpness = 2};
    beam.color[0] = 0.1, beam.color[1] = 0.4, beam.color[2] = 1;
    ew_sources_desc sources = {.points = &orb, .point_count = 1, .paths = &beam, .path_count = 1};
    check(ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address}, &effect, &error) == EW_OK, error.text);
    check(ew_set_sources(effect, &sources, &error) == EW_OK, error.text);

    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.view[14] = -4;
    frame.projection[0] = (double)HEIGHT / WIDTH;
    frame.viewport_width = WIDTH;
    frame.viewport_height = HEIGHT;
    frame.output = EW_OUTPUT_SOFT;
    frame.dither = 1;
    glClear(GL_COLOR_BUFFER_BIT);
    check(ew_draw(effect, &frame, &error) == EW_OK, error.text);
    glFinish();
    write_picture(argv[1], pixels);
    ew_destroy_effect(effect);
    OSMesaDestroyContext(context);
}
