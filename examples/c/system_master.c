/* A master in plain C for any system of FMI 2.0 slaves: the libraries of the FMUs are loaded while it runs.
 *
 *     cc -Iinclude examples/c/system_master.c -ldl -o system_master
 *     ./system_master system.txt
 *
 * The text file describes the system, one fact per line; components count from 0, variables are value references:
 *
 *     step 0.001                        communication step in s
 *     steps 1000                        how many
 *     fmu {guid} /path/LuGre.so         a component: guid of its description, its unpacked binary
 *     start 1 4 0.2                     variable 4 of component 1 starts at 0.2
 *     link 0 5 1 2                      output 5 of component 0 leads to input 2 of component 1
 *     signal 1 3 0.1 0.2 ...            values of input 3 of component 1, one per step
 *     watch 1 7                         print variable 7 of component 1 after each step
 *
 * All components step with the values of the last communication point; then outputs become inputs (Jacobi). Every step
 * prints one line. The first failing call ends the run.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stribeck.h"

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

enum { MOST = 64, LONGEST = 4096 };

/* A component: the functions of its library that a master needs, and the instance. */
typedef struct {
    fmi2Component slave;
    fmi2Component (*instantiate)(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *,
                                 fmi2Boolean, fmi2Boolean);
    void (*free_instance)(fmi2Component);
    fmi2Status (*setup)(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real);
    fmi2Status (*enter)(fmi2Component);
    fmi2Status (*leave)(fmi2Component);
    fmi2Status (*terminate)(fmi2Component);
    fmi2Status (*get)(fmi2Component, const fmi2ValueReference *, size_t, fmi2Real *);
    fmi2Status (*set)(fmi2Component, const fmi2ValueReference *, size_t, const fmi2Real *);
    fmi2Status (*step)(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean);
} component;

typedef struct {
    size_t component;
    fmi2ValueReference variable;
} port;

typedef struct {
    port from, to;
} connection;

typedef struct {
    port to;
    double *values;
} input;

typedef struct {
    double step;
    size_t steps, components, links, signals, watches;
    component component[MOST];
    connection link[MOST];
    input signal[MOST];
    port watch[MOST];
} plan;

static void fail(const char *what, const char *which) {
    fprintf(stderr, "%s: %s\n", what, which);
    exit(EXIT_FAILURE);
}

static void check(fmi2Status status, const char *call) {
    if (status > fmi2Warning) {
        fprintf(stderr, "%s returned status %d\n", call, (int)status);
        exit(EXIT_FAILURE);
    }
}

/* The slaves report through this function. The message is a format, as in printf. */
static void logger(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                   fmi2String message, ...) {
    (void)environment;
    fprintf(stderr, "%s: status %d, %s: ", instance, (int)status, category);
    va_list arguments;
    va_start(arguments, message);
    vfprintf(stderr, message, arguments);
    va_end(arguments);
    fprintf(stderr, "\n");
}

/* ---------------------------------------------------------------------- components */

static void *load(const char *path) {
#ifdef _WIN32
    void *library = (void *)LoadLibraryA(path);
#else
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
#endif
    if (library == NULL) {
        fail("cannot load", path);
    }
    return library;
}

/* Stores the address of a function in a function pointer. */
static void find(void *library, const char *name, void *target) {
#ifdef _WIN32
    FARPROC found = GetProcAddress((HMODULE)library, name);
#else
    void *found = dlsym(library, name);
#endif
    if (found == NULL) {
        fail("no function", name);
    }
    memcpy(target, &found, sizeof found);
}

static component instantiate(const char *guid, const char *path) {
    void *library = load(path);
    component made;
    find(library, "fmi2Instantiate", &made.instantiate);
    find(library, "fmi2FreeInstance", &made.free_instance);
    find(library, "fmi2SetupExperiment", &made.setup);
    find(library, "fmi2EnterInitializationMode", &made.enter);
    find(library, "fmi2ExitInitializationMode", &made.leave);
    find(library, "fmi2Terminate", &made.terminate);
    find(library, "fmi2GetReal", &made.get);
    find(library, "fmi2SetReal", &made.set);
    find(library, "fmi2DoStep", &made.step);
    fmi2CallbackFunctions callbacks = {.logger = logger};
    made.slave = made.instantiate(path, fmi2CoSimulation, guid, NULL, &callbacks, fmi2False, fmi2True);
    if (made.slave == NULL) {
        fail("fmi2Instantiate failed", path);
    }
    return made;
}

static void initialise(const component *made) {
    check(made->setup(made->slave, fmi2False, 0.0, 0.0, fmi2False, 0.0), "fmi2SetupExperiment");
    check(made->enter(made->slave), "fmi2EnterInitializationMode");
    check(made->leave(made->slave), "fmi2ExitInitializationMode");
}

/* ---------------------------------------------------------------------- the plan */

static void expect(int found, int wanted, const char *keyword) {
    if (found != wanted) {
        fail("the file has an invalid line", keyword);
    }
}

static size_t next(size_t *count, const char *keyword) {
    if (*count == MOST) {
        fail("too many", keyword);
    }
    return (*count)++;
}

static port read_port(FILE *file, const plan *system, const char *keyword) {
    port read;
    expect(fscanf(file, "%zu %u", &read.component, &read.variable), 2, keyword);
    if (read.component >= system->components) {
        fail("names a component that does not exist", keyword);
    }
    return read;
}

static double *read_values(FILE *file, size_t count) {
    double *values = malloc((count + 1) * sizeof *values);
    if (values == NULL) {
        fail("out of memory", "signal");
    }
    for (size_t i = 0; i < count; i++) {
        expect(fscanf(file, "%lf", &values[i]), 1, "signal");
    }
    return values;
}

static double get(const plan *system, port at) {
    const component *slave = &system->component[at.component];
    double value = 0.0;
    check(slave->get(slave->slave, &at.variable, 1, &value), "fmi2GetReal");
    return value;
}

static void set(const plan *system, port at, double value) {
    const component *slave = &system->component[at.component];
    check(slave->set(slave->slave, &at.variable, 1, &value), "fmi2SetReal");
}

static void read_plan(FILE *file, plan *system) {
    char keyword[16], guid[64], path[LONGEST];
    while (fscanf(file, "%15s", keyword) == 1) {
        if (strcmp(keyword, "step") == 0) {
            expect(fscanf(file, "%lf", &system->step), 1, keyword);
        } else if (strcmp(keyword, "steps") == 0) {
            expect(fscanf(file, "%zu", &system->steps), 1, keyword);
        } else if (strcmp(keyword, "fmu") == 0) {
            expect(fscanf(file, "%63s %4095[^\n]", guid, path), 2, keyword);
            system->component[next(&system->components, keyword)] = instantiate(guid, path);
        } else if (strcmp(keyword, "start") == 0) {
            port at = read_port(file, system, keyword);
            double value = 0.0;
            expect(fscanf(file, "%lf", &value), 1, keyword);
            set(system, at, value);
        } else if (strcmp(keyword, "link") == 0) {
            connection *link = &system->link[next(&system->links, keyword)];
            link->from = read_port(file, system, keyword);
            link->to = read_port(file, system, keyword);
        } else if (strcmp(keyword, "signal") == 0) {
            input *signal = &system->signal[next(&system->signals, keyword)];
            signal->to = read_port(file, system, keyword);
            signal->values = read_values(file, system->steps);
        } else if (strcmp(keyword, "watch") == 0) {
            system->watch[next(&system->watches, keyword)] = read_port(file, system, keyword);
        } else {
            fail("unknown keyword", keyword);
        }
    }
}

/* ---------------------------------------------------------------------- the run */

/* All outputs are read before the first input is set: the order of the connections must not matter. */
static void exchange(const plan *system) {
    double values[MOST];
    for (size_t i = 0; i < system->links; i++) {
        values[i] = get(system, system->link[i].from);
    }
    for (size_t i = 0; i < system->links; i++) {
        set(system, system->link[i].to, values[i]);
    }
}

static void advance(const plan *system, size_t number) {
    for (size_t i = 0; i < system->signals; i++) {
        set(system, system->signal[i].to, system->signal[i].values[number]);
    }
    for (size_t i = 0; i < system->components; i++) {
        const component *slave = &system->component[i];
        check(slave->step(slave->slave, (double)number * system->step, system->step, fmi2True), "fmi2DoStep");
    }
    for (size_t i = 0; i < system->watches; i++) {
        printf("%.17g%c", get(system, system->watch[i]), i + 1 < system->watches ? ' ' : '\n');
    }
    exchange(system);
}

int main(int argc, char **argv) {
    static plan system;
    FILE *file = argc == 2 ? fopen(argv[1], "r") : NULL;
    if (file == NULL) {
        fail("usage", "system_master FILE");
    }
    read_plan(file, &system);
    fclose(file);
    for (size_t i = 0; i < system.components; i++) {
        initialise(&system.component[i]);
    }
    /* At the start, values propagate through all components. */
    for (size_t i = 0; i < system.components; i++) {
        exchange(&system);
    }
    for (size_t number = 0; number < system.steps; number++) {
        advance(&system, number);
    }
    for (size_t i = 0; i < system.components; i++) {
        check(system.component[i].terminate(system.component[i].slave), "fmi2Terminate");
        system.component[i].free_instance(system.component[i].slave);
    }
    for (size_t i = 0; i < system.signals; i++) {
        free(system.signal[i].values);
    }
    return EXIT_SUCCESS;
}
