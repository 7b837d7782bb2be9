/* EW_PRINTF(format, first): the compiler checks the arguments from the one numbered `first` on against that numbered `format`.
 */
#ifndef EW_PRINTF_FORMAT_H
#define EW_PRINTF_FORMAT_H

/* MinGW's `printf` is that of Microsoft's first C library, which does not know %zu; in C11 it calls its own, which does. */
#if defined(__MINGW32__)
#define EW_PRINTF(format_index, first_index) __attribute__((format(gnu_printf, format_index, first_index)))
#elif defined(__GNUC__)
#define EW_PRINTF(format_index, first_index) __attribute__((format(printf, format_index, first_index)))
#else
#define EW_PRINTF(format_index, first_index)
#endif

#endif
