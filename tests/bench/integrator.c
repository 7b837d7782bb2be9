/* The names of what is compared: see integrator.h. */
#include "integrator.h"
#include "message.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

const char *const integrator_family_names[FAMILY_COUNT] = {"adaptive",      "full",       "simpson", "marching", "equiangular",
                                                           "half-marching", "billboards", "ribbon",  "bare"};

const char integrator_default_list[] = "bare,adaptive:1e-2,adaptive:1e-3,adaptive:1e-4,full:1e-2,full:1e-3,full:1e-4,"
                                       "simpson:16,simpson:64,simpson:200,marching:16,marching:64,marching:256,"
                                       "equiangular:16,equiangular:64";

const char integrator_frame_list[] = "bare,adaptive:1e-3,full:1e-3,simpson:200,marching:64,half-marching:16,half-marching:64,"
                                     "billboards:64,ribbon:64";

static bool read_quality(const char *text, ew_quality *quality)
{
    static const struct {
        const char *text;
        ew_quality quality;
    } qualities[] = {{"1e-2", EW_QUALITY_ERROR_1E_2}, {"1e-3", EW_QUALITY_ERROR_1E_3}, {"1e-4", EW_QUALITY_ERROR_1E_4}};
    for (size_t i = 0; i < sizeof qualities / sizeof *qualities; i++)
        if (strcmp(text, qualities[i].text) == 0) {
            *quality = qualities[i].quality;
            return true;
        }
    return false;
}

static bool read_samples(const char *text, int most, int *samples)
{
    char *end;
    if (!isdigit((unsigned char)text[0])) return false;
    unsigned long value = strtoul(text, &end, 10);
    if (*end != '\0' || value < 1 || value > (unsigned long)most) return false;
    *samples = (int)value;
    return true;
}

static bool read_parameter(bench_integrator *made, const char *parameter)
{
    switch (made->family) {
    case FAMILY_ADAPTIVE:
    case FAMILY_FULL:
        return read_quality(parameter, &made->quality);
    case FAMILY_SIMPSON:
        return read_samples(parameter, EW_MAX_SIMPSON_DIVISIONS, &made->samples) && made->samples % 2 == 0;
    case FAMILY_MARCHING:
    case FAMILY_EQUIANGULAR:
    case FAMILY_HALF_MARCHING:
        return read_samples(parameter, INTEGRATOR_MAX_SAMPLES, &made->samples);
    case FAMILY_BILLBOARDS:
    case FAMILY_RIBBON:
        return read_samples(parameter, INTEGRATOR_MAX_SECTIONS, &made->samples);
    case FAMILY_BARE:
    case FAMILY_COUNT:
        break;
    }
    return false;
}

static bool parse(const char *name, size_t length, bench_integrator *made)
{
    *made = (bench_integrator){.quality = EW_QUALITY_ERROR_1E_3};
    if (length >= sizeof made->name) return false;
    memcpy(made->name, name, length);
    if (strcmp(made->name, "bare") == 0) {
        made->family = FAMILY_BARE;
        return true;
    }
    const char *colon = strchr(made->name, ':');
    if (!colon) return false;
    size_t family_length = (size_t)(colon - made->name);
    for (int family = 0; family < FAMILY_COUNT; family++)
        if (strlen(integrator_family_names[family]) == family_length &&
            strncmp(made->name, integrator_family_names[family], family_length) == 0) {
            made->family = (integrator_family)family;
            return read_parameter(made, colon + 1);
        }
    return false;
}

bench_integrator *integrator_parse_list(const char *text, size_t *count, char *message, size_t size)
{
    size_t capacity = 1;
    for (const char *c = text; *c; c++)
        capacity += *c == ',';
    bench_integrator *list = malloc(capacity * sizeof *list);
    *count = 0;
    if (!list) message_write(message, size, "--integrators: do not fit into memory; name fewer");
    while (list && *count < capacity) {
        size_t length = strcspn(text, ",");
        bench_integrator *made = &list[*count];
        const char *remedy = NULL;
        if (!parse(text, length, made))
            remedy = "is none; use bare, adaptive:1e-2, adaptive:1e-3, adaptive:1e-4, full:1e-2, full:1e-3, full:1e-4, "
                     "simpson:N (N even), marching:N, equiangular:N, half-marching:N, billboards:N or ribbon:N";
        for (size_t i = 0; !remedy && i < *count; i++)
            if (strcmp(list[i].name, made->name) == 0) remedy = "is there twice; name it once";
        if (remedy) {
            message_write(message, size, "--integrators: \"%.*s\" %s", (int)length, text, remedy);
            free(list);
            return NULL;
        }
        ++*count;
        text += length + 1;
    }
    return list;
}
