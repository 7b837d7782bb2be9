/*
 * PRINTF_FORMAT(format, first): the compiler checks the arguments from the one numbered `first` on against that numbered
 * `format`.
 */
#ifndef PRINTF_FORMAT_H
#define PRINTF_FORMAT_H

/* MinGW's `printf` is that of Microsoft's first C library, which does not know %zu; in C11 it calls its own, which does. */
#if defined(__MINGW32__)
#define PRINTF_FORMAT(format_index, first_index) __attribute__((format(gnu_printf, format_index, first_index)))
#elif defined(__GNUC__)
#define PRINTF_FORMAT(format_index, first_index) __attribute__((format(printf, format_index, first_index)))
#else
#define PRINTF_FORMAT(format_index, first_index)
#endif

#endif
