/*
 * Runs a fuzzer's entry point on every file of a folder, or on single files: what libFuzzer's own main program does with
 * files, for compilers without libFuzzer.
 */
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static int fail(const char *path)
{
    perror(path);
    return EXIT_FAILURE;
}

static int replay_file(const char *path)
{
    enum { MAX_BYTES = 1 << 20 };
    static uint8_t bytes[MAX_BYTES];
    FILE *file = fopen(path, "rb");
    if (!file) return fail(path);
    size_t size = fread(bytes, 1, sizeof bytes, file);
    int failed = ferror(file) || size == sizeof bytes;
    fclose(file);
    uint8_t *exact = failed ? NULL : malloc(size); /* so that a sanitizer sees a read beyond the end */
    if (failed || (!exact && size > 0)) return fail(path);
    for (size_t i = 0; i < size; i++)
        exact[i] = bytes[i];
    printf("%s\n", path);
    fflush(stdout); /* the last one printed is the one that crashed */
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
    return EXIT_SUCCESS;
}

static int replay_folder(const char *path)
{
    DIR *folder = opendir(path);
    if (!folder) return replay_file(path);
    int result = EXIT_SUCCESS, count = 0;
    for (struct dirent *entry; result == EXIT_SUCCESS && (entry = readdir(folder));) {
        char file[4096];
        if (entry->d_name[0] == '.') continue;
        snprintf(file, sizeof file, "%s/%s", path, entry->d_name);
        result = replay_file(file);
        count++;
    }
    closedir(folder);
    if (count > 0) return result;
    fprintf(stderr, "%s: holds no file\n", path);
    return EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        fprintf(stderr, "Usage: %s FILE_OR_FOLDER...\n", argv[0]);
        return EXIT_FAILURE;
    }
    for (int i = 1; i < argc; i++)
        if (replay_folder(argv[i]) != EXIT_SUCCESS) return EXIT_FAILURE;
    return EXIT_SUCCESS;
}
