/* Importers load the library of an FMU, run it and unload it, from a new folder each time and from odd ones.
 *
 * Some even unload it while instances live, and load it again: then it may have another address.
 *
 * Usage: loads 2|3 <shared library> <empty folder> <cycles> <guid of each model>...
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "check.h"
#include "reference.h"
#include "version.h"

enum { PATH_SIZE = 4096, WARM_UP = 100 };

/* A loaded library, and its functions in one version of FMI. */
typedef struct {
    library loaded;
    version fmi;
} fmu;

/* The version of FMI that is tried. */
static int number;

/* Loads the library from that path. */
static int load(fmu *made, const char *path) {
    made->loaded = open_library(path);
    if (!CHECK(made->loaded != NULL)) {
        fprintf(stderr, "  %s: %s\n", path, dlerror());
        return 0;
    }
    made->fmi = version_of(made->loaded, number);
    return 1;
}

/* Makes an instance that is ready to step. */
static void *start(const fmu *from, const char *guid) {
    void *slave = instantiate(&from->fmi, guid, false, false);
    REQUIRE(slave != NULL);
    CHECK(initialise(&from->fmi, slave) == OK);
    return slave;
}

/* Steps from one millisecond to another. */
static void steps(const fmu *by, void *slave, int from, int to) {
    for (int k = from; k < to; k++) {
        CHECK(do_step(&by->fmi, slave, k * 1e-3, 1e-3) == OK);
    }
}

/* Loads the library from that path, makes an instance, steps it and unloads the library. */
static void cycle(const char *path, const char *guid) {
    fmu one;
    if (load(&one, path)) {
        void *slave = start(&one, guid);
        steps(&one, slave, 0, 10);
        free_instance(&one.fmi, slave);
        close_library(one.loaded);
    }
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

/* A file of its own: a second name would be the same library to the loader. */
static void copy_file(const char *from, const char *to) {
    static char buffer[1 << 16];
    FILE *in = fopen(from, "rb");
    FILE *out = fopen(to, "wb");
    REQUIRE(in != NULL && out != NULL);
    for (size_t n = fread(buffer, 1, sizeof buffer, in); n > 0; n = fread(buffer, 1, sizeof buffer, in)) {
        REQUIRE(fwrite(buffer, 1, n, out) == n);
    }
    REQUIRE(!ferror(in) && fclose(in) == 0 && fclose(out) == 0);
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

static void again_and_again(const char *library_path, const char *folder, int cycles, const char *guid) {
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
        cycle(path, guid);
        REQUIRE(unlink(path) == 0);
    }
    long grown = resident_kilobytes() - before;
    CHECK(grown < 2048);
    CHECK(mappings_of("/unique-") == 0);
    CHECK(entries("/proc/self/fd") == files);
    CHECK(entries("/proc/self/task") == threads);
    printf("loads: %d cycles, memory grew by %ld kB, no mapping, file or thread is left\n", cycles, grown);
}

/* 200 letters: with the folder above it, close to the limit of a file system for one name. */
#define FIFTY "abcdefghijabcdefghijabcdefghijabcdefghijabcdefghij"

static const char *const ODD[] = {
    "with space",     "um\xc3\xa4ut \xc3\x9f", "\xe6\x97\xa5\xe6\x9c\xac",
    "{braces}",       "100%25 %s%n",           "a#b?c",
    "quote'\"",       "semi;colon&and",        "-dash",
    "\xff not UTF-8", "back\\slash",           FIFTY FIFTY FIFTY FIFTY,
};

static void from_odd_folders(const char *library_path, const char *folder, const char *guid) {
    size_t count = sizeof ODD / sizeof ODD[0];
    for (size_t i = 0; i < count; i++) {
        char odd[PATH_SIZE];
        char path[2 * PATH_SIZE];
        REQUIRE(snprintf(odd, sizeof odd, "%s/%s", folder, ODD[i]) < (int)sizeof odd);
        make_folder(odd);
        REQUIRE(snprintf(path, sizeof path, "%s/lib.so", odd) < (int)sizeof path);
        give_name(library_path, path);
        cycle(path, guid);
        REQUIRE(unlink(path) == 0 && rmdir(odd) == 0);
    }
    printf("loads: from %zu odd folders\n", count);
}

/* The whole state of an instance as bytes, to be freed; `state` may be NULL, which stands for the present one. */
static unsigned char *bytes_of(const fmu *from, void *slave, void *state, size_t *size) {
    void *present = NULL;
    if (state == NULL) {
        CHECK(save(&from->fmi, slave, &present) == OK);
        state = present;
    }
    unsigned char *bytes = bytes_of_state(&from->fmi, slave, state, size);
    CHECK(free_state(&from->fmi, slave, &present) == OK);
    return bytes;
}

static void expect_bytes(const fmu *from, void *slave, void *state, const unsigned char *wanted, size_t wanted_size) {
    size_t size = 0;
    unsigned char *bytes = bytes_of(from, slave, state, &size);
    CHECK(size == wanted_size && memcmp(bytes, wanted, wanted_size) == 0);
    free(bytes);
}

enum { INSTANCES = 4 };

/* Continues with instances that have made five steps; each begins with another function. */
static void go_on(const fmu *by, void **slaves, double *value, int *set) {
    const uint32_t time = reference_of("time"), velocity = reference_of("velocity");
    steps(by, slaves[0], 5, 10);
    CHECK(get_reals(&by->fmi, slaves[1], &time, 1, value, 1) == OK);
    /* Not every model has this input. */
    *set = set_reals(&by->fmi, slaves[2], &velocity, 1, value, 1);
    for (int i = 1; i < INSTANCES; i++) {
        free_instance(&by->fmi, slaves[i]);
    }
}

/* Unloads the library and loads it again while instances live. Its address range is occupied in between, so that it
 * must move. Other instances, in a library that stays, give the expected results. */
static void while_instances_live(const char *path, const char *other_path, const char *guid) {
    fmu moved;
    fmu other;
    if (!load(&moved, path) || !load(&other, other_path)) {
        return;
    }
    void *slaves[INSTANCES];
    void *twins[INSTANCES];
    for (int i = 0; i < INSTANCES; i++) {
        slaves[i] = start(&moved, guid);
        twins[i] = start(&other, guid);
        steps(&moved, slaves[i], 0, 5);
        steps(&other, twins[i], 0, 5);
    }
    void *slave = slaves[0];
    void *twin = twins[0];
    void *saved = NULL;
    CHECK(save(&moved.fmi, slave, &saved) == OK);
    size_t early_size = 0;
    unsigned char *early = bytes_of(&other, twin, NULL, &early_size);

    long page = sysconf(_SC_PAGESIZE);
    char *code = find(moved.loaded, number == 2 ? "fmi2DoStep" : "fmi3DoStep");
    char *taken = code - (size_t)code % (size_t)page;
    close_library(moved.loaded);
    REQUIRE(mappings_of(path) == 0);
    void *block = mmap(taken, (size_t)page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
    REQUIRE(block == taken);
    if (load(&moved, path)) {
        double values[2] = {0.0, 1.0};
        int set[2];
        go_on(&moved, slaves, &values[0], &set[0]);
        go_on(&other, twins, &values[1], &set[1]);
        CHECK(values[0] == values[1] && set[0] == set[1]);
        size_t late_size = 0;
        unsigned char *late = bytes_of(&other, twin, NULL, &late_size);
        expect_bytes(&moved, slave, NULL, late, late_size);
        expect_bytes(&moved, slave, saved, early, early_size);
        CHECK(restore(&moved.fmi, slave, saved) == OK);
        expect_bytes(&moved, slave, NULL, early, early_size);
        CHECK(free_state(&moved.fmi, slave, &saved) == OK);
        free_instance(&moved.fmi, slave);
        close_library(moved.loaded);
        free(late);
    }
    free(early);
    free_instance(&other.fmi, twin);
    close_library(other.loaded);
    REQUIRE(munmap(block, (size_t)page) == 0);
}

static void unloaded_too_early(const char *library_path, const char *folder, int count, char **guids) {
    char path[PATH_SIZE];
    char other_path[PATH_SIZE];
    REQUIRE(snprintf(path, sizeof path, "%s/moves.so", folder) < (int)sizeof path);
    REQUIRE(snprintf(other_path, sizeof other_path, "%s/stays.so", folder) < (int)sizeof other_path);
    copy_file(library_path, path);
    copy_file(library_path, other_path);
    for (int i = 0; i < count; i++) {
        while_instances_live(path, other_path, guids[i]);
    }
    REQUIRE(unlink(path) == 0 && unlink(other_path) == 0);
    printf("loads: %d models live on when the library is unloaded and comes back elsewhere\n", count);
}

int main(int argc, char **argv) {
    if (argc < 6) {
        fprintf(stderr, "usage: %s 2|3 <shared library> <empty folder> <cycles> <guid>...\n", argv[0]);
        return 2;
    }
    number = atoi(argv[1]);
    make_folder(argv[3]);
    from_odd_folders(argv[2], argv[3], argv[5]);
    again_and_again(argv[2], argv[3], atoi(argv[4]), argv[5]);
    unloaded_too_early(argv[2], argv[3], argc - 5, argv + 5);
    return report();
}
