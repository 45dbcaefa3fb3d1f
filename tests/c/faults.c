/* Conditions in hosts that are not mistakes: small stacks, many threads, odd floating-point modes,
 * nonsensical numbers. Every model of the library is tried, in one version of FMI.
 *
 * Usage: faults 2|3 stack|threads|race|short|environment|long|<CPU seconds of the sweep for each model>
 *               <model>={guid} ...
 */
#define _GNU_SOURCE
#include <fenv.h>
#include <float.h>
#include <locale.h>
#include <malloc.h>
#include <math.h>
#include <pthread.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>
#if defined __SSE__
#include <xmmintrin.h>
#endif

#include "check.h"
#include "reference.h"
#include "stribeck.h"
#include "version.h"

/* ---------------------------------------------------------------------- models */

typedef struct {
    char name[64];
    const char *guid;
    stribeck_instance *described; /* owns the texts */
    stribeck_variable *variables;
    size_t columns;
    uint32_t *references;
    uint32_t *reals; /* value references of all Real variables, and number of their values */
    size_t real_count, values;
} model;

static version chosen;
static const version *const fmi = &chosen;

static model *models;
static size_t model_count;

static void *memory(size_t size) {
    void *found = calloc(size, 1);
    REQUIRE(found != NULL);
    return found;
}

/* Whether FMI 3.0 has it as an element of an array. */
static int is_element(const stribeck_variable *variable) {
    return fmi->number == 3 && strchr(variable->name, '[') != NULL;
}

static size_t index_of(const stribeck_variable *variable) {
    return (size_t)atol(strchr(variable->name, '[') + 1);
}

/* The value reference of its array, whose name has no index. */
static uint32_t array_of(const stribeck_variable *variable) {
    char name[128];
    const char *begin = strchr(variable->name, '['), *end = strchr(begin, ']') + 1;
    REQUIRE(snprintf(name, sizeof name, "%.*s%s", (int)(begin - variable->name), variable->name, end) <
            (int)sizeof name);
    return reference_of(name);
}

static void read_model(model *one, const char *argument) {
    const char *equals = strchr(argument, '=');
    REQUIRE(equals != NULL && (size_t)(equals - argument) < sizeof one->name);
    memcpy(one->name, argument, (size_t)(equals - argument));
    one->guid = equals + 1;
    REQUIRE(stribeck_create(one->name, &one->described) == STRIBECK_OK);
    one->columns = stribeck_variable_count(one->described);
    one->variables = memory(one->columns * sizeof *one->variables);
    one->references = memory(one->columns * sizeof *one->references);
    one->reals = memory(one->columns * sizeof *one->reals);
    for (uint32_t i = 0; i < one->columns; i++) {
        REQUIRE(stribeck_reference(one->described, i, &one->references[i]) == STRIBECK_OK);
        REQUIRE(stribeck_describe(one->described, one->references[i], &one->variables[i]) == STRIBECK_OK);
        if (one->variables[i].kind == STRIBECK_REAL) {
            one->values++;
            if (!is_element(&one->variables[i])) {
                one->reals[one->real_count++] = one->references[i];
            } else if (index_of(&one->variables[i]) == 1) {
                one->reals[one->real_count++] = array_of(&one->variables[i]);
            }
        }
    }
}

static void read_models(int count, char **arguments) {
    REQUIRE((size_t)count <= stribeck_model_count());
    models = memory((size_t)count * sizeof *models);
    for (int i = 0; i < count; i++) {
        read_model(&models[model_count++], arguments[i]);
    }
}

static void free_models(void) {
    for (size_t i = 0; i < model_count; i++) {
        stribeck_free(models[i].described);
        free(models[i].variables);
        free(models[i].references);
        free(models[i].reals);
    }
    free(models);
}

static int is_real(const model *of, uint32_t column, stribeck_role role) {
    const stribeck_variable *variable = &of->variables[column];
    return variable->kind == STRIBECK_REAL && variable->role == role && !is_element(variable);
}

/* ---------------------------------------------------------------------- slaves */

static void *make(const model *of, bool hears) {
    void *slave = instantiate(fmi, of->guid, false, hears);
    REQUIRE(slave != NULL);
    return slave;
}

/* An everyday value: it swings a little around the start value, within the bounds. Rounded to nearest in any mode. */
static __attribute__((noinline)) double everyday_value(const stribeck_variable *input, int k) {
    return input->start + 0.002 * (input->min <= -1.0 ? sin(0.01 * k) : 1.0);
}

static __attribute__((noinline)) double everyday_time(int k) {
    return k * 1e-3;
}

static void set_inputs(const model *of, void *slave, int k) {
    for (uint32_t i = 0; i < of->columns; i++) {
        if (is_real(of, i, STRIBECK_INPUT)) {
            int mode = fegetround();
            fesetround(FE_TONEAREST);
            double value = everyday_value(&of->variables[i], k + (int)i);
            fesetround(mode);
            CHECK(set_reals(fmi, slave, &of->references[i], 1, &value, 1) == OK);
        }
    }
}

/* In FMI 3.0 inputs have no derivatives. */
static void set_slopes(const model *of, void *slave, double slope) {
    const int32_t order = 1;
    for (uint32_t i = 0; i < of->columns && fmi->number == 2; i++) {
        if (is_real(of, i, STRIBECK_INPUT)) {
            CHECK(fmi->two.SetRealInputDerivatives(slave, &of->references[i], 1, &order, &slope) != fmi2Fatal);
        }
    }
}

/* Makes everyday steps of 1 ms and returns the sum of the bits of all readable values. */
static uint64_t everyday(const model *of, void *slave, int from, int to, double *values) {
    uint64_t bits = 0;
    for (int k = from; k < to; k++) {
        set_inputs(of, slave, k);
        int mode = fegetround();
        fesetround(FE_TONEAREST);
        double time = everyday_time(k);
        fesetround(mode);
        if (!CHECK(do_step(fmi, slave, time, 1e-3) == OK)) {
            fprintf(stderr, "  %s, step %d\n", of->name, k);
            return 0;
        }
        CHECK(get_reals(fmi, slave, of->reals, of->real_count, values, of->values) == OK);
        for (size_t i = 0; i < of->values; i++) {
            uint64_t word;
            memcpy(&word, &values[i], sizeof word);
            bits = bits * 31 + word;
        }
    }
    return bits;
}

/* ---------------------------------------------------------------------- stack */

/* One choice of an enumeration in an otherwise unchanged model; column 0 and choice 0 for none. */
typedef struct {
    const model *of;
    uint32_t column;
    int32_t choice;
} trial;

static void choose(const trial *one, void *slave) {
    if (one->choice != 0) {
        const uint32_t reference = one->of->references[one->column];
        CHECK(set_whole(fmi, slave, STRIBECK_ENUMERATION, reference, one->choice) == OK);
    }
}

/* The first number that is not computed. */
static uint32_t first_free_number(const model *of) {
    uint32_t column = 0;
    while (of->variables[column].kind != STRIBECK_REAL || of->variables[column].role == STRIBECK_OUTPUT ||
           is_element(&of->variables[column])) {
        column++;
    }
    return column;
}

/* Derivatives of an output: in time, and with respect to a number that may vary. */
static void differentiate_output(const model *of, void *slave) {
    double slope;
    uint32_t output = 0;
    while (!is_real(of, output, STRIBECK_OUTPUT) && !is_real(of, output, STRIBECK_STATE_OUTPUT)) {
        output++;
    }
    const uint32_t known = first_free_number(of);
    CHECK(get_slope(fmi, slave, of->references[output], &slope) == OK);
    CHECK(differentiate(fmi, slave, of->references[output], of->references[known], &slope) == OK);
}

/* The same of the rate of the dissipated energy, a state of all models of friction. */
static void differentiate_rate(const model *of, void *slave) {
    const uint32_t varied = of->references[first_free_number(of)];
    for (uint32_t i = 0; i < of->columns; i++) {
        if (strcmp(of->variables[i].name, "dissipated_energy") == 0) {
            double slope;
            CHECK(differentiate(fmi, slave, reference_of("der(dissipated_energy)"), varied, &slope) == OK);
        }
    }
}

/* What a solver asks for, of a model that can be integrated. */
static void be_integrated(const trial *one) {
    void *slave = instantiate(fmi, one->of->guid, true, false);
    if (slave == NULL) {
        return;
    }
    choose(one, slave);
    double *values = memory(one->of->columns * sizeof *values);
    /* Some choices are for co-simulation only. */
    if (initialise(fmi, slave) == OK && new_discrete_states(fmi, slave) == OK &&
        CHECK(CALL(EnterContinuousTimeMode, slave) == OK)) {
        size_t states = 0;
        while (states < one->of->columns && CALL(GetNominalsOfContinuousStates, slave, values, states) != OK) {
            CHECK(CALL(Reset, slave) == OK);
            choose(one, slave);
            REQUIRE(initialise(fmi, slave) == OK && new_discrete_states(fmi, slave) == OK);
            REQUIRE(CALL(EnterContinuousTimeMode, slave) == OK);
            states++;
        }
        CHECK(CALL(GetContinuousStates, slave, values, states) == OK);
        CHECK(CALL(SetContinuousStates, slave, values, states) == OK);
        CHECK(get_derivatives(fmi, slave, values, states) == OK);
        differentiate_rate(one->of, slave);
        CHECK(completed_step(fmi, slave) == OK);
        CHECK(CALL(EnterEventMode, slave) == OK && new_discrete_states(fmi, slave) == OK);
    }
    free_instance(fmi, slave);
    free(values);
}

/* A life cycle: steps, ramps, derivatives, states, a refusal with its message, and the same through the C interface. */
static void live(const trial *one) {
    const model *of = one->of;
    double *values = memory(of->columns * sizeof *values);
    void *slave = make(of, false);
    choose(one, slave);
    if (initialise(fmi, slave) != OK) {
        /* A choice may require others. */
        CHECK(one->choice != 0);
        free_instance(fmi, slave);
        free(values);
        return;
    }
    /* Before the first step a model may have to find what it starts with. */
    differentiate_output(of, slave);
    everyday(of, slave, 0, 20, values);
    set_slopes(of, slave, 1e-3);
    CHECK(do_step(fmi, slave, 0.02, 1e-3) == OK);
    differentiate_output(of, slave);
    void *state = NULL;
    size_t size = 0;
    CHECK(save(fmi, slave, &state) == OK);
    unsigned char *bytes = bytes_of_state(fmi, slave, state, &size);
    CHECK(read_state(fmi, slave, bytes, size, &state) == OK);
    CHECK(restore(fmi, slave, state) == OK);
    CHECK(free_state(fmi, slave, &state) == OK);
    free(bytes);
    CHECK(do_step(fmi, slave, 0.5, NAN) == ERROR);
    free_instance(fmi, slave);
    free(values);

    stribeck_instance *handle = NULL;
    CHECK(stribeck_create(of->name, &handle) == STRIBECK_OK);
    CHECK(stribeck_step(handle, 1e-3) == STRIBECK_OK);
    CHECK(stribeck_step(handle, NAN) == STRIBECK_REFUSED_VALUE);
    stribeck_free(handle);
}

static void *live_thread(void *one) {
    live(one);
    be_integrated(one);
    return NULL;
}

enum { STACK = 1024 * 1024, LIMIT = 16 * 1000, LIMIT_OF_STRUT = 50 * 1000, UNTOUCHED = 0xA5 };

/* Bytes of the given stack used by a thread with a complete life cycle. */
static size_t stack_use(trial *one, unsigned char *stack, size_t size) {
    memset(stack, UNTOUCHED, size);
    pthread_attr_t attributes;
    pthread_t thread;
    REQUIRE(pthread_attr_init(&attributes) == 0);
    REQUIRE(pthread_attr_setstack(&attributes, stack, size) == 0);
    REQUIRE(pthread_create(&thread, &attributes, live_thread, one) == 0);
    REQUIRE(pthread_join(thread, NULL) == 0);
    REQUIRE(pthread_attr_destroy(&attributes) == 0);
    size_t untouched = 0;
    while (untouched < size && stack[untouched] == UNTOUCHED) {
        untouched++;
    }
    return size - untouched;
}

/* The largest stack of a model, over each choice of each of its enumerations. */
static size_t most_stack_of(const model *of, unsigned char *stack) {
    trial one = {of, 0, 0};
    size_t most = stack_use(&one, stack, STACK);
    for (one.column = 0; one.column < of->columns; one.column++) {
        const stribeck_variable *variable = &of->variables[one.column];
        int is_parameter = variable->role == STRIBECK_FIXED || variable->role == STRIBECK_TUNABLE;
        if (is_parameter && variable->kind == STRIBECK_ENUMERATION) {
            for (one.choice = 1; one.choice <= (int32_t)variable->max; one.choice++) {
                size_t used = stack_use(&one, stack, STACK);
                most = used > most ? used : most;
            }
        }
    }
    return most;
}

/* Stack of a thread that each model needs, including some kilobytes of the thread itself. */
static void small_stack(void) {
    unsigned char *stack = mmap(NULL, STACK, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    REQUIRE(stack != MAP_FAILED);
    size_t most = 0, most_of_strut = 0;
    const char *whose = "";
    for (size_t i = 0; i < model_count; i++) {
        int is_strut = strcmp(models[i].name, "ShockAbsorber") == 0;
        size_t used = most_stack_of(&models[i], stack);
        if (!CHECK(used <= (is_strut ? LIMIT_OF_STRUT : LIMIT))) {
            fprintf(stderr, "  %s uses %zu bytes of stack\n", models[i].name, used);
        }
        if (is_strut) {
            most_of_strut = used;
        } else if (used > most) {
            most = used;
            whose = models[i].name;
        }
    }
    CHECK(munmap(stack, STACK) == 0);
    printf("stack: %zu models, at most %zu bytes (%s), ShockAbsorber %zu\n", model_count, most, whose, most_of_strut);
}

/* ---------------------------------------------------------------------- sweep */

static double since(const struct timespec *start) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)(now.tv_sec - start->tv_sec) + 1e-9 * (double)(now.tv_nsec - start->tv_nsec);
}

static const double NUMBERS[] = {0.0,   -0.0,  1.0,    -1.0,  1e-310, -1e-310, DBL_MIN,  -DBL_MIN, 1e-30,    1e30,
                                 -1e30, 1e150, -1e150, 1e308, -1e308, DBL_MAX, -DBL_MAX, NAN,      INFINITY, -INFINITY};
static const double STEPS[] = {1e-12, 1e-3, 1.0, 1e6};
enum { NUMBER_COUNT = sizeof NUMBERS / sizeof NUMBERS[0], STEP_COUNT = sizeof STEPS / sizeof STEPS[0] };

static long calls_made;
static long calls_refused;
static double slowest;
static char slowest_what[512];

static int all_finite(const double *values, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(values[i])) {
            return 0;
        }
    }
    return 1;
}

/* One step with the present values: it succeeds with finite numbers, or it changes nothing. `what` describes it. */
static void try_step(const model *of, void *slave, double h, double slope, const char *what) {
    double *before = memory(of->columns * sizeof *before);
    double *after = memory(of->columns * sizeof *after);
    struct timespec start;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &start);
    int read = get_reals(fmi, slave, of->reals, of->real_count, before, of->values);
    CHECK(read == OK ? all_finite(before, of->values) : read == ERROR);
    if (read != OK) {
        calls_refused++;
        free(before);
        free(after);
        return;
    }
    if (slope != 0.0) {
        set_slopes(of, slave, slope);
    }
    int status = do_step(fmi, slave, 0.0, h);
    calls_made++;
    int sound = get_reals(fmi, slave, of->reals, of->real_count, after, of->values) == OK;
    sound = sound && all_finite(after, of->values);
    if (status != OK) {
        calls_refused++;
        sound = sound && status == ERROR && memcmp(before, after, of->values * sizeof *after) == 0;
    } else {
        for (uint32_t i = 0; i < of->columns; i++) {
            double value = 0.0;
            if (is_real(of, i, STRIBECK_OUTPUT)) {
                int found = get_slope(fmi, slave, of->references[i], &value);
                sound = sound && (found != OK || isfinite(value));
                break;
            }
        }
    }
    if (!CHECK(sound)) {
        fprintf(stderr, "  %s with %s, step %g s, slope %g: status %d\n", of->name, what, h, slope, status);
    }
    double took = since(&start);
    if (took > slowest) {
        slowest = took;
        snprintf(slowest_what, sizeof slowest_what, "%s with %s, step %g s, slope %g", of->name, what, h, slope);
    }
    free(before);
    free(after);
}

/* Sets a Real or Boolean variable. As one element of an array all others get their start values. */
static int set_with_array(const model *of, void *slave, uint32_t column, double value) {
    const stribeck_variable *variable = &of->variables[column];
    const uint32_t reference = is_element(variable) ? array_of(variable) : of->references[column];
    double *values = memory(of->columns * sizeof *values);
    bool *flags = memory(of->columns * sizeof *flags);
    size_t count = 0;
    for (uint32_t i = 0; i < of->columns; i++) {
        const stribeck_variable *other = &of->variables[i];
        if (i == column || (is_element(variable) && is_element(other) && array_of(other) == reference)) {
            size_t place = is_element(other) ? index_of(other) - 1 : 0;
            values[place] = i == column ? value : other->start;
            flags[place] = values[place] != 0.0;
            count++;
        }
    }
    int status = variable->kind == STRIBECK_REAL ? set_reals(fmi, slave, &reference, 1, values, count)
                                                 : set_booleans(fmi, slave, reference, flags, count);
    free(values);
    free(flags);
    return status;
}

/* Sets a column before the run, or an input during it; true if the value was accepted. */
static int try_set(const model *of, void *slave, uint32_t column, double value) {
    const stribeck_variable *variable = &of->variables[column];
    int status = OK;
    switch (variable->kind) {
    case STRIBECK_REAL:
    case STRIBECK_BOOLEAN:
        status = set_with_array(of, slave, column, value);
        break;
    default: {
        int32_t number = fabs(value) < 1e9 ? (int32_t)value : 0;
        status = set_whole(fmi, slave, variable->kind, of->references[column], number);
    }
    }
    if (variable->kind == STRIBECK_REAL && !isfinite(value)) {
        CHECK(status == DISCARD);
    }
    CHECK(status == OK || status == DISCARD);
    return status == OK;
}

static void try_values(const model *of, const uint32_t *columns, const double *values, size_t count, double h,
                       double slope) {
    char what[160] = "";
    size_t length = 0;
    void *slave = make(of, false);
    for (size_t i = 0; i < count; i++) {
        if (try_set(of, slave, columns[i], values[i]) && length < sizeof what) {
            length += (size_t)snprintf(what + length, sizeof what - length, "%s = %g ", of->variables[columns[i]].name,
                                       values[i]);
        }
    }
    if (initialise(fmi, slave) == OK) {
        try_step(of, slave, h, slope, what);
    } else {
        calls_refused++;
    }
    free_instance(fmi, slave);
}

/* Knuth's generator. Each mixture has its own beginning, so that a failure can be repeated. */
static uint64_t random_state;
static size_t random_below(size_t limit) {
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (size_t)((random_state >> 33) % limit);
}

static double any_number(const stribeck_variable *variable) {
    switch (random_below(5)) {
    case 0:
        return NUMBERS[random_below(NUMBER_COUNT)];
    case 1:
        return variable->min;
    case 2:
        return variable->max;
    default:
        return variable->start * pow(10.0, (double)random_below(13) - 6.0);
    }
}

enum { VALUES = NUMBER_COUNT + 2, MIXTURES = 300, STRIDE = 7919 };

/* Number `which` in the variable `column` alone. */
static void try_single(const model *of, uint32_t column, size_t which) {
    const stribeck_variable *variable = &of->variables[column];
    if (variable->role != STRIBECK_OUTPUT && variable->kind == STRIBECK_REAL) {
        const double ends[] = {variable->min, variable->max};
        double value = which < NUMBER_COUNT ? NUMBERS[which] : ends[which - NUMBER_COUNT];
        try_values(of, &column, &value, 1, STEPS[(which + column) % 3], 0.0);
    }
}

/* Any numbers in a quarter of the variables. */
static void try_mixture(const model *of, int number) {
    random_state = (uint64_t)number;
    uint32_t *columns = memory(of->columns * sizeof *columns);
    double *values = memory(of->columns * sizeof *values);
    size_t count = 0;
    for (uint32_t column = 0; column < of->columns; column++) {
        if (of->variables[column].role != STRIBECK_OUTPUT && random_below(4) == 0) {
            columns[count] = column;
            values[count++] = any_number(&of->variables[column]);
        }
    }
    double slope = number % 3 == 0 ? any_number(of->variables) : 0.0;
    try_values(of, columns, values, count, STEPS[random_below(3)], slope);
    free(columns);
    free(values);
}

/* Every number in every variable alone, then mixtures, with several steps; for each model as far as the time allows,
 * because a host with an impossible task computes for seconds before it gives up. */
static void sweep(double seconds) {
    long skipped = 0;
    for (size_t m = 0; m < model_count; m++) {
        const model *of = &models[m];
        struct timespec start;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &start);
        for (size_t s = 0; s < STEP_COUNT; s++) {
            try_values(of, NULL, NULL, 0, STEPS[s], 0.0);
            try_values(of, NULL, NULL, 0, STEPS[s], 1e-3);
        }
        size_t singles = of->columns * VALUES;
        for (size_t i = 0; i < singles; i++) {
            if (since(&start) < 0.6 * seconds) {
                size_t single = i * STRIDE % singles;
                try_single(of, (uint32_t)(single / VALUES), single % VALUES);
            } else {
                skipped++;
            }
        }
        for (int i = 0; i < MIXTURES; i++) {
            if (since(&start) < seconds) {
                try_mixture(of, i);
            } else {
                skipped++;
            }
        }
    }
    printf("sweep: %ld steps, %ld times they or their parameters were refused, %ld trials left out for time\n",
           calls_made, calls_refused, skipped);
    printf("sweep: the slowest took %.3f s: %s\n", slowest, slowest_what);
}

/* ---------------------------------------------------------------------- threads */

enum { THREADS = 16, INSTANCES = 1000, PHASES = 10, STEPS_A_PHASE = 10 };

static void *crowd[INSTANCES];
static uint64_t crowd_bits[INSTANCES];
static pthread_barrier_t phase_end;

/* In each phase another thread uses the instance. */
static void *step_crowd(void *number) {
    size_t mine = (size_t)(uintptr_t)number;
    double *values = memory(4096 * sizeof *values);
    for (size_t phase = 0; phase < PHASES; phase++) {
        for (size_t i = (mine + phase) % THREADS; i < INSTANCES; i += THREADS) {
            const model *of = &models[i % model_count];
            int from = (int)phase * STEPS_A_PHASE;
            crowd_bits[i] = crowd_bits[i] * 31 + everyday(of, crowd[i], from, from + STEPS_A_PHASE, values);
        }
        pthread_barrier_wait(&phase_end);
    }
    free(values);
    return NULL;
}

static void threads(void) {
    pthread_t thread[THREADS];
    for (size_t i = 0; i < INSTANCES; i++) {
        crowd[i] = make(&models[i % model_count], false);
        REQUIRE(initialise(fmi, crowd[i]) == OK);
    }
    REQUIRE(pthread_barrier_init(&phase_end, NULL, THREADS) == 0);
    for (size_t i = 0; i < THREADS; i++) {
        REQUIRE(pthread_create(&thread[i], NULL, step_crowd, (void *)(uintptr_t)i) == 0);
    }
    for (size_t i = 0; i < THREADS; i++) {
        REQUIRE(pthread_join(thread[i], NULL) == 0);
    }
    REQUIRE(pthread_barrier_destroy(&phase_end) == 0);
    double *values = memory(4096 * sizeof *values);
    int differ = 0;
    for (size_t i = 0; i < INSTANCES; i++) {
        const model *of = &models[i % model_count];
        void *alone = make(of, false);
        REQUIRE(initialise(fmi, alone) == OK);
        uint64_t bits = 0;
        for (int phase = 0; phase < PHASES; phase++) {
            bits = bits * 31 + everyday(of, alone, phase * STEPS_A_PHASE, (phase + 1) * STEPS_A_PHASE, values);
        }
        differ += bits != crowd_bits[i];
        free_instance(fmi, alone);
        free_instance(fmi, crowd[i]);
    }
    CHECK(differ == 0);
    free(values);
    printf("threads: %d instances on %d threads, %d steps each, %d differ from a serial run\n", INSTANCES, THREADS,
           PHASES * STEPS_A_PHASE, differ);
}

/* Wrong on purpose: two threads use one instance. To prove that a thread sanitizer is active in the library. */
static void *use_shared(void *slave) {
    for (int k = 0; k < 1000; k++) {
        CALL(Reset, slave);
    }
    return NULL;
}

static void race(void) {
    pthread_t thread[2];
    void *slave = make(&models[0], false);
    for (size_t i = 0; i < 2; i++) {
        REQUIRE(pthread_create(&thread[i], NULL, use_shared, slave) == 0);
    }
    for (size_t i = 0; i < 2; i++) {
        REQUIRE(pthread_join(thread[i], NULL) == 0);
    }
    free_instance(fmi, slave);
}

/* Wrong on purpose: an array is shorter than stated to the library. To prove that an address sanitizer watches it. */
static void short_array(void) {
    double *value = memory(sizeof *value);
    uint32_t twice[2] = {models[0].reals[0], models[0].reals[0]};
    void *slave = make(&models[0], false);
    CHECK(initialise(fmi, slave) == OK);
    CHECK(get_reals(fmi, slave, twice, 2, value, 2) == OK);
    free_instance(fmi, slave);
    free(value);
}

/* ---------------------------------------------------------------------- floating-point environment, locale */

/* The bits of 200 everyday steps. */
static uint64_t run_alone(const model *of) {
    double *values = memory(of->columns * sizeof *values);
    void *slave = make(of, false);
    CHECK(initialise(fmi, slave) == OK);
    uint64_t bits = everyday(of, slave, 0, 200, values);
    free_instance(fmi, slave);
    free(values);
    return bits;
}

static const int MODES[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
enum { TRAPS = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW, NO_DENORMALS = 0x8040 };

/* A signal would end the program. */
static uint64_t run_with_traps(const model *of) {
    feclearexcept(FE_ALL_EXCEPT);
    REQUIRE(feenableexcept(TRAPS) != -1);
    uint64_t bits = run_alone(of);
    CHECK(fegetexcept() == TRAPS);
    fedisableexcept(FE_ALL_EXCEPT);
    return bits;
}

static uint64_t run_rounding(const model *of, int mode) {
    REQUIRE(fesetround(mode) == 0);
    uint64_t bits = run_alone(of);
    CHECK(fegetround() == mode);
    REQUIRE(fesetround(FE_TONEAREST) == 0);
    return bits;
}

#if defined __SSE__
static uint64_t run_without_denormals(const model *of) {
    unsigned control = _mm_getcsr();
    _mm_setcsr(control | NO_DENORMALS);
    uint64_t bits = run_alone(of);
    CHECK((_mm_getcsr() & NO_DENORMALS) == NO_DENORMALS);
    _mm_setcsr(control);
    return bits;
}
#endif

static uint64_t run_in_germany(const model *of) {
    REQUIRE(setlocale(LC_ALL, "de_DE.UTF-8") != NULL);
    char half[8];
    snprintf(half, sizeof half, "%.1f", 0.5);
    REQUIRE(strcmp(half, "0,5") == 0);
    uint64_t bits = run_alone(of);
    void *slave = make(of, true);
    CHECK(initialise(fmi, slave) == OK);
    CHECK(do_step(fmi, slave, 0.0, -0.5) == ERROR);
    CHECK(strstr(heard, " = -0.5: ") != NULL);
    free_instance(fmi, slave);
    setlocale(LC_ALL, "C");
    return bits;
}

/* The mode of the host is restored, and the results are the same to the last bit. */
static void environment(void) {
    for (size_t m = 0; m < model_count; m++) {
        const model *of = &models[m];
        uint64_t bits = run_alone(of);
        int same = CHECK(run_with_traps(of) == bits);
        for (size_t i = 0; i < sizeof MODES / sizeof MODES[0]; i++) {
            same &= CHECK(run_rounding(of, MODES[i]) == bits);
        }
#if defined __SSE__
        same &= CHECK(run_without_denormals(of) == bits);
#endif
        same &= CHECK(run_in_germany(of) == bits);
        if (!same) {
            fprintf(stderr, "  %s\n", of->name);
        }
    }
    printf("environment: %zu models, the same bits with traps, in %zu rounding modes, without denormals, in Germany\n",
           model_count, sizeof MODES / sizeof MODES[0]);
}

/* ---------------------------------------------------------------------- a long run */

static long resident_pages(void) {
    long total = 0;
    long resident = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    REQUIRE(file != NULL && fscanf(file, "%ld %ld", &total, &resident) == 2);
    fclose(file);
    return resident;
}

static void long_run(const char *name) {
    size_t m = 0;
    while (m < model_count && strcmp(models[m].name, name) != 0) {
        m++;
    }
    REQUIRE(m < model_count);
    const model *of = &models[m];
    double *values = memory(of->columns * sizeof *values);
    void *slave = make(of, false);
    CHECK(initialise(fmi, slave) == OK);
    everyday(of, slave, 0, 1000, values);
    long before = resident_pages();
    size_t allocated = mallinfo2().uordblks;
    everyday(of, slave, 1000, 1000000, values);
    long grown = resident_pages() - before;
    CHECK(mallinfo2().uordblks == allocated);
    /* Pages of the library itself may be touched for the first time. */
    CHECK(grown < 64);
    printf("long: %s, 1000000 steps, not a byte more is allocated, %ld more pages are resident\n", of->name, grown);
    free_instance(fmi, slave);
    free(values);
}

int main(int argc, char **argv) {
    setvbuf(stdout, NULL, _IOLBF, 0);
    REQUIRE(argc > 3);
    const char *what = argv[2];
    chosen = version_of(RTLD_DEFAULT, atoi(argv[1]));
    read_models(argc - 3, argv + 3);
    if (atof(what) > 0.0) {
        sweep(atof(what));
    } else if (strcmp(what, "stack") == 0) {
        small_stack();
    } else if (strcmp(what, "threads") == 0) {
        threads();
    } else if (strcmp(what, "race") == 0) {
        race();
    } else if (strcmp(what, "short") == 0) {
        short_array();
    } else if (strcmp(what, "environment") == 0) {
        environment();
    } else if (strcmp(what, "long") == 0) {
        long_run("LuGre");
        long_run("ShockAbsorber");
    } else {
        CHECK(!"a fault that is known");
    }
    free_models();
    return report();
}
