/* Importers load the library of an FMU, run it and unload it, from a new folder each time and from odd ones.
 *
 * Some even unload it while instances live, and load it again: then it may have another address.
 *
 * Usage: loads <shared library> <empty folder> <cycles> <guid of each model>...
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "check.h"
#include "library.h"
#include "reference.h"
#include "stribeck.h"

enum { PATH_SIZE = 4096, WARM_UP = 100 };

/* A loaded library and those of its functions that this program calls. */
typedef struct {
    library loaded;
    fmi2Component (*Instantiate)(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *,
                                 fmi2Boolean, fmi2Boolean);
    void (*FreeInstance)(fmi2Component);
    fmi2Status (*SetupExperiment)(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real);
    fmi2Status (*EnterInitializationMode)(fmi2Component);
    fmi2Status (*ExitInitializationMode)(fmi2Component);
    fmi2Status (*DoStep)(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean);
    fmi2Status (*GetReal)(fmi2Component, const fmi2ValueReference *, size_t, fmi2Real *);
    fmi2Status (*SetReal)(fmi2Component, const fmi2ValueReference *, size_t, const fmi2Real *);
    fmi2Status (*GetFMUstate)(fmi2Component, fmi2FMUstate *);
    fmi2Status (*SetFMUstate)(fmi2Component, fmi2FMUstate);
    fmi2Status (*FreeFMUstate)(fmi2Component, fmi2FMUstate *);
    fmi2Status (*SerializedFMUstateSize)(fmi2Component, fmi2FMUstate, size_t *);
    fmi2Status (*SerializeFMUstate)(fmi2Component, fmi2FMUstate, fmi2Byte *, size_t);
} fmu;

#define RESOLVE(fmu, name)                                                                                             \
    do {                                                                                                               \
        void *address = find((fmu)->loaded, "fmi2" #name);                                                             \
        REQUIRE(address != NULL);                                                                                      \
        memcpy(&(fmu)->name, &address, sizeof address);                                                                \
    } while (0)

/* Loads the library from that path. */
static int load(fmu *made, const char *path) {
    made->loaded = open_library(path);
    if (!CHECK(made->loaded != NULL)) {
        fprintf(stderr, "  %s: %s\n", path, dlerror());
        return 0;
    }
    RESOLVE(made, Instantiate);
    RESOLVE(made, FreeInstance);
    RESOLVE(made, SetupExperiment);
    RESOLVE(made, EnterInitializationMode);
    RESOLVE(made, ExitInitializationMode);
    RESOLVE(made, DoStep);
    RESOLVE(made, GetReal);
    RESOLVE(made, SetReal);
    RESOLVE(made, GetFMUstate);
    RESOLVE(made, SetFMUstate);
    RESOLVE(made, FreeFMUstate);
    RESOLVE(made, SerializedFMUstateSize);
    RESOLVE(made, SerializeFMUstate);
    return 1;
}

/* Makes an instance that is ready to step. */
static fmi2Component start(const fmu *from, const char *guid) {
    fmi2CallbackFunctions callbacks = {NULL, NULL, NULL, NULL, NULL};
    fmi2Component slave = from->Instantiate("slave", fmi2CoSimulation, guid, "", &callbacks, fmi2False, fmi2True);
    REQUIRE(slave != NULL);
    CHECK(from->SetupExperiment(slave, fmi2False, 0.0, 0.0, fmi2False, 0.0) == fmi2OK);
    CHECK(from->EnterInitializationMode(slave) == fmi2OK);
    CHECK(from->ExitInitializationMode(slave) == fmi2OK);
    return slave;
}

/* Steps from one millisecond to another. */
static void steps(const fmu *by, fmi2Component slave, int from, int to) {
    for (int k = from; k < to; k++) {
        CHECK(by->DoStep(slave, k * 1e-3, 1e-3, fmi2True) == fmi2OK);
    }
}

/* Loads the library from that path, makes an instance, steps it and unloads the library. */
static void cycle(const char *path, const char *guid) {
    fmu one;
    if (load(&one, path)) {
        fmi2Component slave = start(&one, guid);
        steps(&one, slave, 0, 10);
        one.FreeInstance(slave);
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
static fmi2Byte *bytes_of(const fmu *from, fmi2Component slave, fmi2FMUstate state, size_t *size) {
    fmi2FMUstate present = NULL;
    if (state == NULL) {
        CHECK(from->GetFMUstate(slave, &present) == fmi2OK);
        state = present;
    }
    REQUIRE(from->SerializedFMUstateSize(slave, state, size) == fmi2OK);
    fmi2Byte *bytes = malloc(*size);
    REQUIRE(bytes != NULL);
    CHECK(from->SerializeFMUstate(slave, state, bytes, *size) == fmi2OK);
    CHECK(from->FreeFMUstate(slave, &present) == fmi2OK);
    return bytes;
}

static void expect_bytes(const fmu *from, fmi2Component slave, fmi2FMUstate state, const fmi2Byte *wanted,
                         size_t wanted_size) {
    size_t size = 0;
    fmi2Byte *bytes = bytes_of(from, slave, state, &size);
    CHECK(size == wanted_size && memcmp(bytes, wanted, wanted_size) == 0);
    free(bytes);
}

enum { INSTANCES = 4 };

/* Continues with instances that have made five steps; each begins with another function. */
static void go_on(const fmu *by, fmi2Component *slaves, fmi2Real *value, fmi2Status *set) {
    const fmi2ValueReference time = reference_of("time"), velocity = reference_of("velocity");
    steps(by, slaves[0], 5, 10);
    CHECK(by->GetReal(slaves[1], &time, 1, value) == fmi2OK);
    /* Not every model has this input. */
    *set = by->SetReal(slaves[2], &velocity, 1, value);
    for (int i = 1; i < INSTANCES; i++) {
        by->FreeInstance(slaves[i]);
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
    fmi2Component slaves[INSTANCES];
    fmi2Component twins[INSTANCES];
    for (int i = 0; i < INSTANCES; i++) {
        slaves[i] = start(&moved, guid);
        twins[i] = start(&other, guid);
        steps(&moved, slaves[i], 0, 5);
        steps(&other, twins[i], 0, 5);
    }
    fmi2Component slave = slaves[0];
    fmi2Component twin = twins[0];
    fmi2FMUstate saved = NULL;
    CHECK(moved.GetFMUstate(slave, &saved) == fmi2OK);
    size_t early_size = 0;
    fmi2Byte *early = bytes_of(&other, twin, NULL, &early_size);

    long page = sysconf(_SC_PAGESIZE);
    char *code = find(moved.loaded, "fmi2DoStep");
    char *taken = code - (size_t)code % (size_t)page;
    close_library(moved.loaded);
    REQUIRE(mappings_of(path) == 0);
    void *block = mmap(taken, (size_t)page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
    REQUIRE(block == taken);
    if (load(&moved, path)) {
        fmi2Real values[2] = {0.0, 1.0};
        fmi2Status set[2];
        go_on(&moved, slaves, &values[0], &set[0]);
        go_on(&other, twins, &values[1], &set[1]);
        CHECK(values[0] == values[1] && set[0] == set[1]);
        size_t late_size = 0;
        fmi2Byte *late = bytes_of(&other, twin, NULL, &late_size);
        expect_bytes(&moved, slave, NULL, late, late_size);
        expect_bytes(&moved, slave, saved, early, early_size);
        CHECK(moved.SetFMUstate(slave, saved) == fmi2OK);
        expect_bytes(&moved, slave, NULL, early, early_size);
        CHECK(moved.FreeFMUstate(slave, &saved) == fmi2OK);
        moved.FreeInstance(slave);
        close_library(moved.loaded);
        free(late);
    }
    free(early);
    other.FreeInstance(twin);
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
    if (argc < 5) {
        fprintf(stderr, "usage: %s <shared library> <empty folder> <cycles> <guid>...\n", argv[0]);
        return 2;
    }
    make_folder(argv[2]);
    from_odd_folders(argv[1], argv[2], argv[4]);
    again_and_again(argv[1], argv[2], atoi(argv[3]), argv[4]);
    unloaded_too_early(argv[1], argv[2], argc - 4, argv + 4);
    return report();
}
