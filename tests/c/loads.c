/* Importers load the library of an FMU, run it and unload it, from a new folder each time and from odd ones.
 *
 * Usage: loads <shared library> <empty folder> <cycles> <guid of a model>
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <sys/stat.h>
#include <unistd.h>

#include "check.h"
#include "library.h"
#include "stribeck.h"

enum { PATH_SIZE = 4096, WARM_UP = 100 };

static const char *guid;

#define RESOLVE(loaded, name)                                                                                          \
    void *name##_address = find(loaded, "fmi2" #name);                                                                 \
    REQUIRE(name##_address != NULL);                                                                                   \
    memcpy(&name, &name##_address, sizeof name##_address)

/* Loads the library from that path, makes an instance, steps it and unloads the library. */
static void cycle(const char *path) {
    library loaded = open_library(path);
    if (!CHECK(loaded != NULL)) {
        fprintf(stderr, "  %s: %s\n", path, dlerror());
        return;
    }
    fmi2Component (*Instantiate)(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *,
                                 fmi2Boolean, fmi2Boolean);
    void (*FreeInstance)(fmi2Component);
    fmi2Status (*SetupExperiment)(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real);
    fmi2Status (*EnterInitializationMode)(fmi2Component);
    fmi2Status (*ExitInitializationMode)(fmi2Component);
    fmi2Status (*DoStep)(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean);
    RESOLVE(loaded, Instantiate);
    RESOLVE(loaded, FreeInstance);
    RESOLVE(loaded, SetupExperiment);
    RESOLVE(loaded, EnterInitializationMode);
    RESOLVE(loaded, ExitInitializationMode);
    RESOLVE(loaded, DoStep);
    fmi2CallbackFunctions callbacks = {NULL, NULL, NULL, NULL, NULL};
    fmi2Component slave = Instantiate("slave", fmi2CoSimulation, guid, path, &callbacks, fmi2False, fmi2True);
    REQUIRE(slave != NULL);
    CHECK(SetupExperiment(slave, fmi2False, 0.0, 0.0, fmi2False, 0.0) == fmi2OK);
    CHECK(EnterInitializationMode(slave) == fmi2OK);
    CHECK(ExitInitializationMode(slave) == fmi2OK);
    for (int k = 0; k < 10; k++) {
        CHECK(DoStep(slave, k * 1e-3, 1e-3, fmi2True) == fmi2OK);
    }
    FreeInstance(slave);
    close_library(loaded);
}

static void make_folder(const char *path) {
    REQUIRE(mkdir(path, 0700) == 0 || errno == EEXIST);
}

/* A second name for the library, so that each load is one of a path that was never loaded. */
static void give_name(const char *library_path, const char *path) {
    if (link(library_path, path) != 0) {
        REQUIRE(symlink(library_path, path) == 0);
    }
}

static int entries(const char *folder) {
    DIR *opened = opendir(folder);
    REQUIRE(opened != NULL);
    int count = 0;
    while (readdir(opened) != NULL) {
        count++;
    }
    closedir(opened);
    return count;
}

static int mappings_of(const char *text) {
    char line[PATH_SIZE];
    int count = 0;
    FILE *maps = fopen("/proc/self/maps", "r");
    REQUIRE(maps != NULL);
    while (fgets(line, sizeof line, maps) != NULL) {
        count += strstr(line, text) != NULL;
    }
    fclose(maps);
    return count;
}

static long resident_kilobytes(void) {
    long total = 0;
    long resident = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    REQUIRE(file != NULL && fscanf(file, "%ld %ld", &total, &resident) == 2);
    fclose(file);
    return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

static void again_and_again(const char *library_path, const char *folder, int cycles) {
    char path[PATH_SIZE];
    long before = 0;
    int files = 0;
    int threads = 0;
    for (int i = 0; i < WARM_UP + cycles; i++) {
        if (i == WARM_UP) {
            before = resident_kilobytes();
            files = entries("/proc/self/fd");
            threads = entries("/proc/self/task");
        }
        REQUIRE(snprintf(path, sizeof path, "%s/unique-%d.so", folder, i) < (int)sizeof path);
        give_name(library_path, path);
        cycle(path);
        REQUIRE(unlink(path) == 0);
    }
    long grown = resident_kilobytes() - before;
    CHECK(grown < 2048);
    CHECK(mappings_of("/unique-") == 0);
    CHECK(entries("/proc/self/fd") == files);
    CHECK(entries("/proc/self/task") == threads);
    printf("loads: %d cycles, memory grew by %ld kB, no mapping, file or thread is left\n", cycles, grown);
}

/* 200 letters: with the folder above it, near to what a file system takes as one name. */
#define FIFTY "abcdefghijabcdefghijabcdefghijabcdefghijabcdefghij"

static const char *const ODD[] = {
    "with space",     "um\xc3\xa4ut \xc3\x9f", "\xe6\x97\xa5\xe6\x9c\xac",
    "{braces}",       "100%25 %s%n",           "a#b?c",
    "quote'\"",       "semi;colon&and",        "-dash",
    "\xff not UTF-8", "back\\slash",           FIFTY FIFTY FIFTY FIFTY,
};

static void from_odd_folders(const char *library_path, const char *folder) {
    size_t count = sizeof ODD / sizeof ODD[0];
    for (size_t i = 0; i < count; i++) {
        char odd[PATH_SIZE];
        char path[2 * PATH_SIZE];
        REQUIRE(snprintf(odd, sizeof odd, "%s/%s", folder, ODD[i]) < (int)sizeof odd);
        make_folder(odd);
        REQUIRE(snprintf(path, sizeof path, "%s/lib.so", odd) < (int)sizeof path);
        give_name(library_path, path);
        cycle(path);
        REQUIRE(unlink(path) == 0 && rmdir(odd) == 0);
    }
    printf("loads: from %zu odd folders\n", count);
}

int main(int argc, char **argv) {
    if (argc != 5) {
        fprintf(stderr, "usage: %s <shared library> <empty folder> <cycles> <guid>\n", argv[0]);
        return 2;
    }
    guid = argv[4];
    make_folder(argv[2]);
    from_odd_folders(argv[1], argv[2]);
    again_and_again(argv[1], argv[2], atoi(argv[3]));
    return report();
}
