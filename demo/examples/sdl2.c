/* SDL 2: an orb that rises and falls in a window. Escape ends it. */
#include <energywave.h>
#include <GL/gl.h>
#include <math.h>
#include <SDL.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int ok, const char *what)
{
    if (ok) return;
    fprintf(stderr, "sdl2: %s\n", what);
    exit(1);
}

static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    /* C converts a pointer to an object into one to a function only by way of an integer. */
    return (ew_gl_function)(uintptr_t)SDL_GL_GetProcAddress(name);
}

static int wants_to_end(void)
{
    SDL_Event event;
    while (SDL_PollEvent(&event))
        if (event.type == SDL_QUIT || (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE)) return 1;
    return 0;
}

static SDL_Window *open_window(void)
{
    check(SDL_Init(SDL_INIT_VIDEO) == 0, SDL_GetError());
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_Window *window = SDL_CreateWindow("EnergyWave", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, 960, 540,
                                          SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
    check(window != NULL, SDL_GetError());
    return window;
}

int main(int argc, char **argv)
{
    (void)argc, (void)argv; /* SDL's own main passes them */
    SDL_Window *window = open_window();
    SDL_GLContext context = SDL_GL_CreateContext(window);
    check(context != NULL, SDL_GetError());

    ew_effect *effect;
    ew_error error;
    ew_point orb = {.core = 0.3, .reach = 3, .brightness = 2, .sharpness = 2, .color = {0.1, 0.4, 1}};
    ew_sources_desc sources = {.points = &orb, .point_count = 1};
    check(ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address}, &effect, &error) == EW_OK, error.text);
    while (!wants_to_end()) {
        ew_frame_desc frame = EW_FRAME_DEFAULTS;
        SDL_GL_GetDrawableSize(window, &frame.viewport_width, &frame.viewport_height);
        frame.view[14] = -4; /* the eye is 4 units in front of the orb, and sees 90 degrees */
        frame.projection[0] = (double)frame.viewport_height / frame.viewport_width;
        frame.output = EW_OUTPUT_SOFT;
        frame.dither = 1;
        orb.position[1] = sin(SDL_GetTicks() * 1e-3);
        glClear(GL_COLOR_BUFFER_BIT);
        check(ew_set_sources(effect, &sources, &error) == EW_OK, error.text);
        check(ew_draw(effect, &frame, &error) == EW_OK, error.text);
        SDL_GL_SwapWindow(window);
    }
    ew_destroy_effect(effect);
    SDL_GL_DeleteContext(context);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return 0;
}
