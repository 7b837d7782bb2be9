/* Pictures that gnuplot draws: see gnuplot.h. */
#include "gnuplot.h"
#include "message.h"
#include "output_file.h"

#include <sys/wait.h>
#include <unistd.h>

/* Runs gnuplot on a script in `folder`; returns whether that succeeded. */
static bool run_gnuplot(const char *folder, const char *script)
{
    int status = -1;
    pid_t child = fork();
    if (child == 0) {
        if (chdir(folder) == 0) execlp("gnuplot", "gnuplot", script, (char *)NULL);
        _exit(127);
    }
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool gnuplot_draw(const char *folder, const char *name, void (*write)(FILE *script, const void *user), const void *user,
                  char *message, size_t size)
{
    char script[80], path[4096];
    snprintf(script, sizeof script, "%s.gnuplot", name);
    snprintf(path, sizeof path, "%s/%s", folder, script);
    FILE *file = fopen(path, "w");
    if (file) write(file, user);
    if (!output_file_close(file, path, message, size)) return false;
    if (run_gnuplot(folder, script)) {
        remove(path);
        return true;
    }
    message_write(message, size, "%s: gnuplot could not draw it; run it there where there is gnuplot", path);
    return false;
}

void gnuplot_begin(FILE *script, const char *name, const char *title)
{
    fputs("set terminal svg size 760,520 dynamic background 'white' font 'sans-serif,14'\n", script);
    fprintf(script, "set output '%s.svg'\nset title '%s' noenhanced\n", name, title);
    fputs("set logscale xy\nset format x '%g'\nset grid lt 1 lw 0.5 lc rgb '#dddddd'\nset key outside top center horizontal "
          "samplen 2\n",
          script);
}
