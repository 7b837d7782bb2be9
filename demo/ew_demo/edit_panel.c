/* The sliders of the selected part: see edit_panel.h. */
#include "edit_panel.h"
#include "scene_edit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sizes at a scale of 1. Each row has a line of text, and a bar below it. */
enum { PANEL_WIDTH = 180, MARGIN = 8, ROW = 2 * OVERLAY_LINE + 4, BAR = 9 };

static const unsigned char white[4] = {235, 240, 250, 255}, pale[4] = {160, 180, 210, 255}, shade[4] = {4, 6, 14, 200},
                           trough[4] = {60, 72, 96, 255}, filled[4] = {110, 160, 240, 255};

static void add_sliders_of_medium(edit_panel *panel, const ew_medium *medium)
{
    panel->sliders[0] = (edit_slider){.key = "extinction",
                                      .value = medium->extinction,
                                      .least = 1e-2,
                                      .most = 100,
                                      .is_logarithmic = true,
                                      .upper = HUGE_VAL};
    panel->sliders[1] = (edit_slider){.key = "albedo", .value = medium->albedo, .least = 0, .most = 1, .upper = 1};
    panel->slider_count = 2;
}

static void add_sliders(edit_panel *panel, const demo_scene *scene, const char *text, scene_part part)
{
    source_light light = scene_part_light(scene, part);
    double core = light.core > 0 ? light.core : scene->sources.epsilon;
    const edit_slider sliders[EDIT_MOST_SLIDERS] = {
        {.key = "core", .value = core, .least = 1e-3, .most = 10, .is_logarithmic = true, .upper = HUGE_VAL},
        {.key = "reach", .value = light.reach, .least = 1e-2, .most = 100, .is_logarithmic = true, .upper = HUGE_VAL},
        {.key = "brightness", .value = light.brightness, .least = 0, .most = 8, .upper = HUGE_VAL}};
    memcpy(panel->sliders, sliders, sizeof sliders);
    panel->slider_count = EDIT_MOST_SLIDERS;
    if (light.reach > 0) panel->sliders[0].upper = 0.95 * light.reach;
    panel->sliders[1].lower = 1.05 * core;
    if (!scene_edit_has(text, part, "brightness"))
        panel->sliders[2] = (edit_slider){.key = "coefficient",
                                          .value = light.coefficient,
                                          .least = 1e-2,
                                          .most = 100,
                                          .is_logarithmic = true,
                                          .upper = HUGE_VAL};
}

edit_panel edit_panel_of(const demo_scene *scene, const char *text, scene_part part)
{
    edit_panel panel = {.slider_count = 0};
    if (part_is_source(part.kind)) add_sliders(&panel, scene, text, part);
    if (part.kind == PART_MEDIUM) add_sliders_of_medium(&panel, &scene->media[part.index]);
    scene_edit_title(text, part, panel.title, sizeof panel.title);
    return panel;
}

/* ---- Where everything is ------------------------------------------------------------------------------------------------- */

typedef struct rectangle {
    double x, y, width, height;
} rectangle;

static rectangle panel_rectangle(const edit_panel *panel, edit_place place)
{
    double s = place.scale, height = 2 * MARGIN + OVERLAY_LINE + 4 + panel->slider_count * ROW + OVERLAY_LINE;
    return (rectangle){place.width - (PANEL_WIDTH + 8) * s, 8 * s, PANEL_WIDTH * s, height * s};
}

static rectangle row_rectangle(const edit_panel *panel, edit_place place, int slider)
{
    rectangle all = panel_rectangle(panel, place);
    double s = place.scale;
    return (rectangle){all.x + MARGIN * s, all.y + (MARGIN + OVERLAY_LINE + 4 + slider * ROW) * s, all.width - 2 * MARGIN * s,
                       ROW * s};
}

static bool is_within(rectangle r, double x, double y)
{
    return x >= r.x && x < r.x + r.width && y >= r.y && y < r.y + r.height;
}

bool edit_panel_has(const edit_panel *panel, edit_place place, double x, double y)
{
    return is_within(panel_rectangle(panel, place), x, y);
}

int edit_panel_slider_at(const edit_panel *panel, edit_place place, double x, double y)
{
    for (int i = 0; i < panel->slider_count; i++)
        if (is_within(row_rectangle(panel, place, i), x, y)) return i;
    return EDIT_NO_SLIDER;
}

/* ---- Values -------------------------------------------------------------------------------------------------------------- */

/* How far along its bar a value is, from 0 to 1. */
static double share_of(const edit_slider *slider)
{
    if (!(slider->value > slider->least)) return 0;
    double share = slider->is_logarithmic ? log(slider->value / slider->least) / log(slider->most / slider->least)
                                          : (slider->value - slider->least) / (slider->most - slider->least);
    return fmin(share, 1);
}

static double value_of(const edit_slider *slider, double share)
{
    double within = fmin(fmax(share, 0), 1);
    double value = slider->is_logarithmic ? slider->least * pow(slider->most / slider->least, within)
                                          : slider->least + within * (slider->most - slider->least);
    char digits[32];
    snprintf(digits, sizeof digits, "%.3g", fmin(fmax(value, slider->lower), slider->upper));
    return strtod(digits, NULL);
}

double edit_panel_value_at(const edit_panel *panel, int slider, edit_place place, double x)
{
    rectangle row = row_rectangle(panel, place, slider);
    return value_of(&panel->sliders[slider], (x - row.x) / row.width);
}

double edit_panel_value_beside(const edit_panel *panel, int slider, double way)
{
    const edit_slider *moved = &panel->sliders[slider];
    double value = value_of(moved, share_of(moved) + way);
    /* What is beyond the bar, or beyond its limits, already is not brought back by going further. */
    return (value - moved->value) * way > 0 ? value : moved->value;
}

/* ---- Drawing ------------------------------------------------------------------------------------------------------------- */

static void draw_slider(demo_overlay *overlay, const edit_slider *slider, bool is_chosen, rectangle row, double scale)
{
    char value[32] = "none";
    if (slider->value > 0 || slider->least == 0) snprintf(value, sizeof value, "%.4g", slider->value);
    double bar = row.y + OVERLAY_LINE * scale;
    if (is_chosen) overlay_box(overlay, row.x - MARGIN * scale, row.y, 3 * scale, (ROW - 4) * scale, white);
    overlay_text(overlay, row.x, row.y, scale, slider->key, is_chosen ? white : pale);
    overlay_text(overlay, row.x + row.width - overlay_text_width(value, scale), row.y, scale, value, white);
    overlay_box(overlay, row.x, bar, row.width, BAR * scale, trough);
    overlay_box(overlay, row.x, bar, row.width * share_of(slider), BAR * scale, filled);
    overlay_box(overlay, row.x + row.width * share_of(slider) - scale, bar - scale, 2 * scale, (BAR + 2) * scale, white);
}

void edit_panel_draw(demo_overlay *overlay, const edit_panel *panel, edit_place place)
{
    rectangle all = panel_rectangle(panel, place);
    double s = place.scale, x = all.x + MARGIN * s;
    char title[sizeof panel->title];
    snprintf(title, sizeof title, "%s", panel->title);
    for (size_t end = strlen(title); end > 0 && overlay_text_width(title, s) > all.width - 2 * MARGIN * s; end--)
        title[end - 1] = '\0';
    overlay_box(overlay, all.x, all.y, all.width, all.height, shade);
    overlay_text(overlay, x, all.y + MARGIN * s, s, title, white);
    for (int i = 0; i < panel->slider_count; i++)
        draw_slider(overlay, &panel->sliders[i], i == panel->chosen, row_rectangle(panel, place, i), s);
    overlay_text(overlay, x, all.y + all.height - (MARGIN + OVERLAY_LINE - 2) * s, s,
                 panel->is_saved ? "saved" : "not saved: Ctrl+S", pale);
}
