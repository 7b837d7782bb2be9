/* The panel over the picture: see panel.h. */
#include "panel.h"
#include "false_color.h"
#include "integrator_name.h"
#include "printf_format.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/* Columns, because the font is proportional. */
static const char *const key_columns[] = {
    "Space\n. ,\n[ ]\nR\nWASD\nQ E\nMouse\nWheel\nC\nH\nClick\nN\nCtrl+Z Y S",
    ("pause\nnext, previous frame\nslower, faster\nrestart\nfly (Shift: faster)\ndown, up\n"
     "left: orbit, right: look\ncloser, farther\nthe scene's own camera\nthis list\n"
     "change what is there (scene files)\nchange the next part (Shift: the one before)\nundo, redo, save"),
    "1 2 3\n4 5 6\nShift+1-6\nTab\nM\nP\nV\nF11\nF12\nEsc\nUp Down\nLeft Right",
    ("adaptive, error 1e-2, 1e-3, 1e-4\nSimpson's rule, 64, 128, 256 divisions\nthe same for the right half\n"
     "split the picture\nmap of evaluations, of errors, none\nthis panel\nvsync\nfull screen\nscreenshot\nquit\n"
     "another bar of what is changed\nmove that bar (Shift: finely)"),
};
enum { KEY_COLUMNS = sizeof key_columns / sizeof *key_columns };

static const unsigned char white[4] = {235, 240, 250, 255}, pale[4] = {160, 180, 210, 255}, red[4] = {255, 120, 100, 255},
                           shade[4] = {4, 6, 14, 170};

/* Text that grows line by line. */
typedef struct text_lines {
    char text[2000];
    size_t length;
} text_lines;

PRINTF_FORMAT(2, 3) static void add(text_lines *lines, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(lines->text + lines->length, sizeof lines->text - lines->length, format, arguments);
    va_end(arguments);
    if (length > 0) lines->length += (size_t)length;
    if (lines->length >= sizeof lines->text) lines->length = sizeof lines->text - 1;
}

static int line_count(const char *text)
{
    int count = *text != '\0';
    for (; *text; text++)
        count += *text == '\n' && text[1];
    return count;
}

/* Text on a dark box, whose upper left corner is at (x, y). */
static void draw_box(demo_overlay *overlay, double x, double y, double scale, const char *text, const unsigned char color[4])
{
    double margin = 6 * scale;
    overlay_box(overlay, x, y, overlay_text_width(text, scale) + 2 * margin,
                line_count(text) * OVERLAY_LINE * scale + 2 * margin, shade);
    overlay_text(overlay, x + margin, y + margin, scale, text, color);
}

static void draw_keys(demo_overlay *overlay, double y, double scale)
{
    double margin = 6 * scale, x = 8 * scale + margin, width = margin;
    for (int i = 0; i < KEY_COLUMNS; i++)
        width += overlay_text_width(key_columns[i], scale) + 2 * margin;
    overlay_box(overlay, 8 * scale, y, width - margin, line_count(key_columns[0]) * OVERLAY_LINE * scale + 2 * margin, shade);
    for (int i = 0; i < KEY_COLUMNS; i++) {
        overlay_text(overlay, x, y + margin, scale, key_columns[i], i % 2 ? pale : white);
        x += overlay_text_width(key_columns[i], scale) + 2 * margin;
    }
}

static void describe_half(text_lines *lines, const panel_view *view, int half)
{
    const display_statistics *statistics = &view->statistics[half];
    char name[INTEGRATOR_NAME_SIZE];
    integrator_write_name(&view->integrators[half], name);
    add(lines, "%s%s", view->split ? half ? "right: " : "left: " : "", name);
    if (statistics->map.mean_evaluations >= 0) add(lines, ", %.1f evaluations per pixel", statistics->map.mean_evaluations);
    if (view->mode == DISPLAY_PICTURE && statistics->gpu_milliseconds >= 0)
        add(lines, ", GPU %.2f ms", statistics->gpu_milliseconds);
    if (view->mode == DISPLAY_ERROR)
        add(lines, "\n    error at most %.1e, 99 %% below %.1e", statistics->map.largest_error,
            statistics->map.error_of_99_percent);
    add(lines, "\n");
}

static void describe(text_lines *lines, const panel_view *view)
{
    add(lines, "%s", view->scene_name);
    if (view->is_animated)
        add(lines, "   %.2f s, frame %.0f, speed x%g%s", view->seconds, floor(view->seconds * view->frames_per_second + 1e-6),
            view->time_scale, view->is_paused ? ", paused" : "");
    add(lines, "\n");
    if (view->frame_milliseconds > 0)
        add(lines, "%.1f ms per frame, %.0f fps\n", view->frame_milliseconds, 1000 / view->frame_milliseconds);
    for (int half = 0; half < (view->split ? 2 : 1); half++)
        describe_half(lines, view, half);
    add(lines, "%s\nH: keys%s", view->gl_name, view->is_animated ? "" : "; click on what you want to change");
}

/* The colours of a map, with the numbers at both ends. */
static void draw_scale(demo_overlay *overlay, const panel_view *view, int width, int height, double scale)
{
    enum { STEPS = 64 };
    bool is_error = view->mode == DISPLAY_ERROR;
    double bar = fmin(300 * scale, 0.6 * width), x = (width - bar) / 2, y = height - 2.5 * OVERLAY_LINE * scale;
    char text[200];
    if (is_error)
        snprintf(text, sizeof text, "relative error, %g to %g, against Simpson's rule with %d divisions",
                 FALSE_COLOR_LEAST_ERROR, FALSE_COLOR_LARGEST_ERROR, MAP_REFERENCE_DIVISIONS);
    else
        snprintf(text, sizeof text, "evaluations per pixel, %d to %d", 0, FALSE_COLOR_MOST_EVALUATIONS);
    double text_width = overlay_text_width(text, scale);
    draw_box(overlay, (width - text_width) / 2 - 6 * scale, y - OVERLAY_LINE * scale - 10 * scale, scale, text, white);
    for (int i = 0; i < STEPS; i++) {
        unsigned char color[4] = {0, 0, 0, 255};
        false_color_at((i + 0.5) / STEPS, color);
        overlay_box(overlay, x + bar * i / STEPS, y + 6 * scale, bar / STEPS + 0.5, OVERLAY_LINE * scale, color);
    }
}

/* Breaks a line at its spaces, or within a word that is too wide by itself, so that it is no wider than `width`. */
static void wrap(text_lines *lines, const char *text, double width, double scale)
{
    size_t start = 0, space = 0;
    for (; *text; text++) {
        add(lines, "%c", *text);
        if (overlay_text_width(lines->text + start, scale) <= width) {
            if (*text == ' ') space = lines->length - 1;
            continue;
        }
        if (space > start) {
            lines->text[space] = '\n';
            start = space + 1;
        } else {
            lines->text[lines->length - 1] = '\n';
            start = lines->length;
            add(lines, "%c", *text);
        }
    }
}

static void draw_lower_left(demo_overlay *overlay, int width, int height, double scale, const char *text,
                            const unsigned char color[4])
{
    text_lines lines = {.length = 0};
    wrap(&lines, text, width - 28 * scale, scale);
    draw_box(overlay, 8 * scale, height - (line_count(lines.text) * OVERLAY_LINE + 20) * scale, scale, lines.text, color);
}

void panel_draw(demo_overlay *overlay, const panel_view *view, int width, int height, double scale)
{
    text_lines lines = {.length = 0};
    describe(&lines, view);
    if (view->split) overlay_box(overlay, width / 2 - 0.5, 0, 1, height, pale);
    if (view->shows_panel) draw_box(overlay, 8 * scale, 8 * scale, scale, lines.text, white);
    if (view->shows_panel && view->mode != DISPLAY_PICTURE) draw_scale(overlay, view, width, height, scale);
    if (view->shows_keys) draw_keys(overlay, (line_count(lines.text) * OVERLAY_LINE + 28) * scale, scale);
    if (view->error[0])
        draw_lower_left(overlay, width, height, scale, view->error, red);
    else if (view->notice[0])
        draw_lower_left(overlay, width, height, scale, view->notice, white);
}
