/* The FMI 3.0 functions as an importer uses them: declared by the headers of the standard, in a library that is loaded
 * while the program runs. Every function is called, and each of its arguments changes what it answers.
 *
 * Usage: fmi3_test <path of the shared library>
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "fmi3FunctionTypes.h"
#include "library.h"
#include "reference.h"
#include "stribeck.h"

/* Every function of fmi3Functions.h: run.py compares this list with the header. */
#define SETUP(DO)                                                                                                      \
    DO(GetVersion)                                                                                                     \
    DO(InstantiateModelExchange)                                                                                       \
    DO(InstantiateCoSimulation)                                                                                        \
    DO(InstantiateScheduledExecution)                                                                                  \
    DO(FreeInstance)                                                                                                   \
    DO(SetDebugLogging)                                                                                                \
    DO(EnterInitializationMode)                                                                                        \
    DO(ExitInitializationMode)                                                                                         \
    DO(EnterConfigurationMode)                                                                                         \
    DO(ExitConfigurationMode)                                                                                          \
    DO(EnterEventMode)                                                                                                 \
    DO(EvaluateDiscreteStates)                                                                                         \
    DO(UpdateDiscreteStates)                                                                                           \
    DO(Terminate)                                                                                                      \
    DO(Reset)
#define VALUES(DO)                                                                                                     \
    DO(GetFloat32)                                                                                                     \
    DO(GetFloat64)                                                                                                     \
    DO(GetInt8)                                                                                                        \
    DO(GetUInt8)                                                                                                       \
    DO(GetInt16)                                                                                                       \
    DO(GetUInt16)                                                                                                      \
    DO(GetInt32)                                                                                                       \
    DO(GetUInt32)                                                                                                      \
    DO(GetInt64)                                                                                                       \
    DO(GetUInt64)                                                                                                      \
    DO(GetBoolean)                                                                                                     \
    DO(GetString)                                                                                                      \
    DO(GetBinary)                                                                                                      \
    DO(SetFloat32)                                                                                                     \
    DO(SetFloat64)                                                                                                     \
    DO(SetInt8)                                                                                                        \
    DO(SetUInt8)                                                                                                       \
    DO(SetInt16)                                                                                                       \
    DO(SetUInt16)                                                                                                      \
    DO(SetInt32)                                                                                                       \
    DO(SetUInt32)                                                                                                      \
    DO(SetInt64)                                                                                                       \
    DO(SetUInt64)                                                                                                      \
    DO(SetBoolean)                                                                                                     \
    DO(SetString)                                                                                                      \
    DO(SetBinary)
#define CLOCKS(DO)                                                                                                     \
    DO(GetClock)                                                                                                       \
    DO(SetClock)                                                                                                       \
    DO(GetIntervalDecimal)                                                                                             \
    DO(GetIntervalFraction)                                                                                            \
    DO(GetShiftDecimal)                                                                                                \
    DO(GetShiftFraction)                                                                                               \
    DO(SetIntervalDecimal)                                                                                             \
    DO(SetIntervalFraction)                                                                                            \
    DO(SetShiftDecimal)                                                                                                \
    DO(SetShiftFraction)                                                                                               \
    DO(ActivateModelPartition)
#define STATES_AND_DERIVATIVES(DO)                                                                                     \
    DO(GetNumberOfVariableDependencies)                                                                                \
    DO(GetVariableDependencies)                                                                                        \
    DO(GetFMUState)                                                                                                    \
    DO(SetFMUState)                                                                                                    \
    DO(FreeFMUState)                                                                                                   \
    DO(SerializedFMUStateSize)                                                                                         \
    DO(SerializeFMUState)                                                                                              \
    DO(DeserializeFMUState)                                                                                            \
    DO(GetDirectionalDerivative)                                                                                       \
    DO(GetAdjointDerivative)                                                                                           \
    DO(GetOutputDerivatives)
#define RUN(DO)                                                                                                        \
    DO(EnterContinuousTimeMode)                                                                                        \
    DO(CompletedIntegratorStep)                                                                                        \
    DO(SetTime)                                                                                                        \
    DO(SetContinuousStates)                                                                                            \
    DO(GetContinuousStateDerivatives)                                                                                  \
    DO(GetEventIndicators)                                                                                             \
    DO(GetContinuousStates)                                                                                            \
    DO(GetNominalsOfContinuousStates)                                                                                  \
    DO(GetNumberOfEventIndicators)                                                                                     \
    DO(GetNumberOfContinuousStates)                                                                                    \
    DO(EnterStepMode)                                                                                                  \
    DO(DoStep)
#define EACH(DO) SETUP(DO) VALUES(DO) CLOCKS(DO) STATES_AND_DERIVATIVES(DO) RUN(DO)

#define MEMBER(name) fmi3##name##TYPE *name;
typedef struct {
    EACH(MEMBER)
} functions;

/* ISO C has no cast from void * to a function pointer; POSIX and Windows promise that a copy of the bytes works. */
#define RESOLVE(name)                                                                                                  \
    address = find(loaded, "fmi3" #name);                                                                              \
    if (!CHECK(address != NULL)) {                                                                                     \
        fprintf(stderr, "  missing: fmi3%s\n", #name);                                                                 \
    }                                                                                                                  \
    memcpy(&fmi.name, &address, sizeof address);

static functions resolve(library loaded) {
    functions fmi;
    void *address;
    EACH(RESOLVE)
    return fmi;
}

/* ---------------------------------------------------------------------- instances */

typedef struct {
    const functions *fmi;
    fmi3Instance instance;
    int count;
    fmi3Status status;
    char category[64];
    char text[512];
    /* What the callback within a step has seen, and when it ends a step. */
    fmi3Float64 seen[8], times[8];
    size_t visits;
    fmi3Float64 end;
} host;

static void logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message) {
    host *owner = environment;
    owner->count++;
    owner->status = status;
    snprintf(owner->category, sizeof owner->category, "%s", category);
    snprintf(owner->text, sizeof owner->text, "%s", message);
}

/* The call must be refused with this status and a message that contains `why`. */
#define REFUSED(owner, wanted, why, call)                                                                              \
    do {                                                                                                               \
        (owner)->text[0] = 0;                                                                                          \
        CHECK((call) == (wanted));                                                                                     \
        if (!CHECK(strstr((owner)->text, why) != NULL)) {                                                              \
            fprintf(stderr, "  %s\n", (owner)->text);                                                                  \
        }                                                                                                              \
    } while (0)

static fmi3Instance make(const functions *fmi, host *owner, const char *token) {
    memset(owner, 0, sizeof *owner);
    owner->fmi = fmi;
    owner->instance =
        fmi->InstantiateCoSimulation("contact", token, NULL, false, true, false, false, NULL, 0, owner, logger, NULL);
    return owner->instance;
}

static fmi3Instance make_for_solver(const functions *fmi, host *owner, const char *token) {
    memset(owner, 0, sizeof *owner);
    owner->fmi = fmi;
    owner->instance = fmi->InstantiateModelExchange("contact", token, NULL, false, true, owner, logger);
    return owner->instance;
}

static void initialise(const functions *fmi, fmi3Instance instance) {
    CHECK(fmi->EnterInitializationMode(instance, true, 1e-6, 0.0, false, 0.0) == fmi3OK);
    CHECK(fmi->ExitInitializationMode(instance) == fmi3OK);
}

static double get(const functions *fmi, fmi3Instance instance, fmi3ValueReference reference) {
    double value = NAN;
    CHECK(fmi->GetFloat64(instance, &reference, 1, &value, 1) == fmi3OK);
    return value;
}

static void set(const functions *fmi, fmi3Instance instance, fmi3ValueReference reference, double value) {
    CHECK(fmi->SetFloat64(instance, &reference, 1, &value, 1) == fmi3OK);
}

static int is_set(const functions *fmi, fmi3Instance instance, fmi3ValueReference reference) {
    fmi3Boolean value = false;
    CHECK(fmi->GetBoolean(instance, &reference, 1, &value, 1) == fmi3OK);
    return value;
}

typedef struct {
    fmi3Boolean event, terminate, early;
    fmi3Float64 time;
} outcome;

static outcome step(const functions *fmi, fmi3Instance instance, double time, double length) {
    outcome made = {true, true, true, NAN};
    CHECK(fmi->DoStep(instance, time, length, true, &made.event, &made.terminate, &made.early, &made.time) == fmi3OK);
    CHECK(!made.terminate);
    return made;
}

/* Whether its discrete states have jumped. */
static int update(const functions *fmi, fmi3Instance instance) {
    fmi3Boolean more = true, terminate = true, nominals = true, values = true, defined = true;
    fmi3Float64 next = NAN;
    CHECK(fmi->UpdateDiscreteStates(instance, &more, &terminate, &nominals, &values, &defined, &next) == fmi3OK);
    CHECK(!more && !terminate && !nominals && !defined);
    return values;
}

/* ---------------------------------------------------------------------- runs */

/* A contact that slides steadily carries the level of the Stribeck curve. */
static void plain_run_reaches_steady_sliding(const functions *fmi) {
    host owner;
    fmi3Instance law = make(fmi, &owner, STRIBECK_LUGRE_GUID);
    REQUIRE(law != NULL);
    const double v = 0.002;
    set(fmi, law, STRIBECK_LUGRE_VELOCITY, v);
    initialise(fmi, law);
    for (int i = 0; i < 1000; i++) {
        outcome made = step(fmi, law, i * 1e-3, 1e-3);
        CHECK(!made.event && !made.early && fabs(made.time - (i + 1) * 1e-3) < 1e-12);
    }
    double level = 0.981 + 0.4905 * exp(-4.0) + 0.1 * v;
    CHECK(fabs(get(fmi, law, STRIBECK_LUGRE_FRICTION_FORCE) - level) < 1e-12);
    CHECK(!is_set(fmi, law, STRIBECK_LUGRE_STICKING));
    const fmi3ValueReference both[] = {STRIBECK_LUGRE_FRICTION_FORCE, STRIBECK_LUGRE_VELOCITY};
    fmi3Float64 values[] = {NAN, NAN};
    CHECK(fmi->GetFloat64(law, both, 2, values, 2) == fmi3OK);
    CHECK(fabs(values[0] - level) < 1e-12 && values[1] == v);
    CHECK(fmi->Terminate(law) == fmi3OK);
    CHECK(fmi->Reset(law) == fmi3OK);
    initialise(fmi, law);
    CHECK(get(fmi, law, STRIBECK_LUGRE_FRICTION_FORCE) == 0.0);
    CHECK(get(fmi, law, STRIBECK_LUGRE_VELOCITY) == 0.0);
    fmi->FreeInstance(law);
    /* Both runs say that the parameters are not passive. */
    CHECK(owner.count == 2 && owner.status == fmi3Warning && strcmp(owner.category, "logStatusWarning") == 0);
    CHECK(strstr(owner.text, "below 158.114 the damping of the bristles") != NULL);
}

/* The free block is an oscillator: after a period it is where it was, whatever the size of the steps. */
static void rig_swings_with_its_period(const functions *fmi) {
    host owner;
    fmi3Instance rig = make(fmi, &owner, STRIBECK_BELT_RIG_GUID);
    REQUIRE(rig != NULL);
    set(fmi, rig, STRIBECK_BELT_RIG_POSITION, 0.3);
    set(fmi, rig, STRIBECK_BELT_RIG_BLOCK_VELOCITY, 0.0);
    initialise(fmi, rig);
    double period = 2.0 * acos(-1.0) / sqrt(2.0);
    double t = 0.0;
    for (int i = 0; i < 7; i++) {
        t = step(fmi, rig, t, period / 7.0).time;
    }
    CHECK(fabs(get(fmi, rig, STRIBECK_BELT_RIG_POSITION) - 0.3) < 1e-14);
    CHECK(fabs(get(fmi, rig, STRIBECK_BELT_RIG_BLOCK_VELOCITY)) < 1e-14);
    /* The spring of 2 N/m pulls the block of 1 kg back. */
    const fmi3ValueReference velocity = STRIBECK_BELT_RIG_VELOCITY;
    const fmi3Int32 first = 1, none = 0;
    fmi3Float64 slope = NAN;
    CHECK(fmi->GetOutputDerivatives(rig, &velocity, 1, &first, &slope, 1) == fmi3OK);
    CHECK(fabs(slope + 2.0 * 0.3) < 1e-13);
    REFUSED(&owner, fmi3Error, "order 0 of velocity", fmi->GetOutputDerivatives(rig, &velocity, 1, &none, &slope, 1));
    fmi->FreeInstance(rig);
    CHECK(owner.count == 1);
}

/* Position and velocity of the block. */
#define STATES 2

static void slopes_at(const functions *fmi, fmi3Instance rig, double t, const double x[STATES], double slopes[STATES]) {
    CHECK(fmi->SetTime(rig, t) == fmi3OK);
    CHECK(fmi->SetContinuousStates(rig, x, STATES) == fmi3OK);
    CHECK(fmi->GetContinuousStateDerivatives(rig, slopes, STATES) == fmi3OK);
}

/* One step of the midpoint rule, as a master with a solver of its own makes it. */
static void integrate(const functions *fmi, fmi3Instance rig, double t, double h) {
    double x[STATES], middle[STATES], slopes[STATES];
    CHECK(fmi->GetContinuousStates(rig, x, STATES) == fmi3OK);
    slopes_at(fmi, rig, t, x, slopes);
    for (int i = 0; i < STATES; i++) {
        middle[i] = x[i] + 0.5 * h * slopes[i];
    }
    slopes_at(fmi, rig, t + 0.5 * h, middle, slopes);
    for (int i = 0; i < STATES; i++) {
        x[i] += h * slopes[i];
    }
    CHECK(fmi->SetTime(rig, t + h) == fmi3OK);
    CHECK(fmi->SetContinuousStates(rig, x, STATES) == fmi3OK);
    fmi3Boolean event = true, end = true;
    CHECK(fmi->CompletedIntegratorStep(rig, true, &event, &end) == fmi3OK);
    CHECK(!event && !end);
}

/* The block swings with its period in Model Exchange as well; the midpoint rule is off by less than (omega h)^2. */
static void rig_swings_in_a_solver(const functions *fmi) {
    host owner;
    fmi3Instance rig = make_for_solver(fmi, &owner, STRIBECK_BELT_RIG_GUID);
    REQUIRE(rig != NULL);
    set(fmi, rig, STRIBECK_BELT_RIG_POSITION, 0.3);
    set(fmi, rig, STRIBECK_BELT_RIG_BLOCK_VELOCITY, 0.0);
    size_t states = 9, indicators = 9;
    CHECK(fmi->GetNumberOfContinuousStates(rig, &states) == fmi3OK && states == STATES);
    CHECK(fmi->GetNumberOfEventIndicators(rig, &indicators) == fmi3OK && indicators == 0);
    initialise(fmi, rig);
    CHECK(fmi->EvaluateDiscreteStates(rig) == fmi3OK);
    CHECK(!update(fmi, rig));
    double nominals[STATES] = {NAN, NAN};
    CHECK(fmi->GetNominalsOfContinuousStates(rig, nominals, STATES) == fmi3OK);
    CHECK(nominals[0] > 0.0 && nominals[1] > 0.0);
    CHECK(fmi->EnterContinuousTimeMode(rig) == fmi3OK);
    const int steps = 2000;
    const double omega = sqrt(2.0), h = 2.0 * acos(-1.0) / omega / steps;
    for (int i = 0; i < steps; i++) {
        integrate(fmi, rig, i * h, h);
    }
    double off = omega * h * omega * h;
    CHECK(fabs(get(fmi, rig, STRIBECK_BELT_RIG_POSITION) - 0.3) < 0.3 * off);
    CHECK(fabs(get(fmi, rig, STRIBECK_BELT_RIG_BLOCK_VELOCITY)) < 2.0 * 0.3 * omega * off);
    CHECK(get(fmi, rig, reference_of("time")) == (steps - 1) * h + h);
    CHECK(fmi->EnterEventMode(rig) == fmi3OK);
    CHECK(fmi->Terminate(rig) == fmi3OK);
    fmi->FreeInstance(rig);
    CHECK(owner.count == 0);
    /* A law with random bonds has no derivative, and reports that. */
    CHECK(make_for_solver(fmi, &owner, STRIBECK_BRISTLE_GUID) == NULL);
    CHECK(owner.count == 1 && strstr(owner.text, "co-simulation") != NULL);
}

/* Some indicator of a contact has another sign if the load is taken away. */
static void indicators_change_sign(const functions *fmi) {
    host owner;
    fmi3Instance law = make_for_solver(fmi, &owner, STRIBECK_RESET_INTEGRATOR_GUID);
    REQUIRE(law != NULL);
    size_t count = 0;
    CHECK(fmi->GetNumberOfEventIndicators(law, &count) == fmi3OK);
    REQUIRE(count > 0 && count < 8);
    initialise(fmi, law);
    fmi3Float64 before[8], after[8];
    CHECK(fmi->GetEventIndicators(law, before, count) == fmi3OK);
    REFUSED(&owner, fmi3Error, "event indicators", fmi->GetEventIndicators(law, before, count + 1));
    CHECK(fmi->Reset(law) == fmi3OK);
    set(fmi, law, STRIBECK_RESET_INTEGRATOR_NORMAL_FORCE, 0.0);
    initialise(fmi, law);
    CHECK(fmi->GetEventIndicators(law, after, count) == fmi3OK);
    int changed = 0;
    for (size_t i = 0; i < count; i++) {
        changed += (before[i] > 0.0) != (after[i] > 0.0);
    }
    CHECK(changed > 0);
    fmi->FreeInstance(law);
}

/* A bond that is bent at constant velocity breaks at z_m / v, within a step of 50 ms, which ends there. */
static void a_step_ends_at_an_event(const functions *fmi) {
    host owner = {0};
    fmi3Instance law = fmi->InstantiateCoSimulation("bond", STRIBECK_RESET_INTEGRATOR_GUID, NULL, false, true, true,
                                                    true, NULL, 0, &owner, logger, NULL);
    REQUIRE(law != NULL);
    const double v = 3e-5, h = 0.05;
    set(fmi, law, STRIBECK_RESET_INTEGRATOR_VELOCITY, v);
    initialise(fmi, law);
    update(fmi, law);
    CHECK(fmi->EnterStepMode(law) == fmi3OK);
    const double broken = get(fmi, law, STRIBECK_RESET_INTEGRATOR_MU_K) *
                          get(fmi, law, STRIBECK_RESET_INTEGRATOR_NORMAL_FORCE) /
                          get(fmi, law, STRIBECK_RESET_INTEGRATOR_SIGMA_0) / v;
    double t = 0.0;
    outcome made = {false, false, false, 0.0};
    while (!made.early && t < 10.0) {
        CHECK(is_set(fmi, law, STRIBECK_RESET_INTEGRATOR_STICKING));
        made = step(fmi, law, t, h);
        t = made.time;
    }
    CHECK(made.event && fabs(t - broken) < 1e-9);
    CHECK(!is_set(fmi, law, STRIBECK_RESET_INTEGRATOR_STICKING));
    CHECK(fmi->EnterEventMode(law) == fmi3OK);
    update(fmi, law);
    CHECK(fmi->EnterStepMode(law) == fmi3OK);
    made = step(fmi, law, t, h);
    CHECK(!made.event && !made.early);
    fmi->FreeInstance(law);
}

static void within_a_step(fmi3InstanceEnvironment environment, fmi3Float64 time, fmi3Boolean set_requested,
                          fmi3Boolean get_allowed, fmi3Boolean finished, fmi3Boolean can_return,
                          fmi3Boolean *return_requested, fmi3Float64 *return_time) {
    host *owner = environment;
    CHECK(!set_requested && get_allowed && finished);
    REQUIRE(owner->visits < 8);
    owner->times[owner->visits] = time;
    owner->seen[owner->visits++] = get(owner->fmi, owner->instance, STRIBECK_LUGRE_FRICTION_FORCE);
    if (can_return && owner->end > 0.0) {
        *return_requested = true;
        *return_time = owner->end;
    }
}

/* The callback reads forces within a step, the last one that of its end, and may end the step. */
static void forces_are_read_within_a_step(const functions *fmi) {
    const fmi3ValueReference required = STRIBECK_LUGRE_FRICTION_FORCE;
    for (int ends = 0; ends < 2; ends++) {
        host owner = {0};
        owner.fmi = fmi;
        owner.end = ends ? 3e-3 : 0.0;
        owner.instance = fmi->InstantiateCoSimulation("within", STRIBECK_LUGRE_GUID, NULL, false, true, false, true,
                                                      &required, 1, &owner, logger, within_a_step);
        REQUIRE(owner.instance != NULL);
        set(fmi, owner.instance, STRIBECK_LUGRE_VELOCITY, 1e-3);
        initialise(fmi, owner.instance);
        outcome made = step(fmi, owner.instance, 0.0, 8e-3);
        CHECK(made.early == (ends == 1) && made.time == (ends ? 3e-3 : 8e-3));
        REQUIRE(owner.visits > 1);
        CHECK(owner.times[owner.visits - 1] == made.time);
        CHECK(owner.seen[owner.visits - 1] == get(fmi, owner.instance, STRIBECK_LUGRE_FRICTION_FORCE));
        CHECK(owner.times[0] < made.time && owner.seen[0] > 0.0 && owner.seen[0] < owner.seen[owner.visits - 1]);
        fmi->FreeInstance(owner.instance);
    }
    host owner = {0};
    const fmi3ValueReference parameter = STRIBECK_LUGRE_MU_K;
    CHECK(fmi->InstantiateCoSimulation("within", STRIBECK_LUGRE_GUID, NULL, false, true, false, true, &parameter, 1,
                                       &owner, logger, within_a_step) == NULL);
    CHECK(strstr(owner.text, "required intermediate variable") != NULL);
}

/* ---------------------------------------------------------------------- values */

/* Start and stop time, and tolerance, are those that the importer passes. */
static void an_experiment_is_kept(const functions *fmi) {
    host owner;
    fmi3Instance rig = make(fmi, &owner, STRIBECK_BELT_RIG_GUID);
    REQUIRE(rig != NULL);
    CHECK(fmi->EnterInitializationMode(rig, false, NAN, 3.0, true, 4.0) == fmi3OK);
    CHECK(get(fmi, rig, reference_of("time")) == 3.0);
    CHECK(fmi->ExitInitializationMode(rig) == fmi3OK);
    CHECK(step(fmi, rig, 3.0, 0.5).time == 3.5);
    outcome made;
    REFUSED(&owner, fmi3Error, "4",
            fmi->DoStep(rig, 3.5, 1.0, true, &made.event, &made.terminate, &made.early, &made.time));
    CHECK(fmi->Reset(rig) == fmi3OK);
    REFUSED(&owner, fmi3Error, "tolerance", fmi->EnterInitializationMode(rig, true, -1.0, 3.0, true, 4.0));
    CHECK(fmi->Reset(rig) == fmi3OK);
    CHECK(fmi->EnterInitializationMode(rig, false, NAN, 3.0, false, 1.0) == fmi3OK);
    fmi->FreeInstance(rig);
}

/* An array counts by its elements; its size is set in Configuration Mode. */
static void arrays_have_sizes(const functions *fmi) {
    host owner;
    fmi3Instance strut = make(fmi, &owner, STRIBECK_SHOCK_ABSORBER_GUID);
    REQUIRE(strut != NULL);
    const fmi3ValueReference size = reference_of("damper.tab_size"), table = reference_of("damper.tab_v");
    fmi3UInt64 most = 0;
    CHECK(fmi->GetUInt64(strut, &size, 1, &most, 1) == fmi3OK);
    CHECK(most == 16);
    fmi3Float64 values[16], again[16];
    CHECK(fmi->GetFloat64(strut, &table, 1, values, 16) == fmi3OK);
    REFUSED(&owner, fmi3Error, "3 values: must be 16", fmi->GetFloat64(strut, &table, 1, values, 3));
    CHECK(fmi->Reset(strut) == fmi3OK);
    CHECK(fmi->EnterConfigurationMode(strut) == fmi3OK);
    const fmi3UInt64 three = 3, seventeen = 17;
    REFUSED(&owner, fmi3Discard, "17: must be from 1 to 16", fmi->SetUInt64(strut, &size, 1, &seventeen, 1));
    CHECK(fmi->SetUInt64(strut, &size, 1, &three, 1) == fmi3OK);
    CHECK(fmi->ExitConfigurationMode(strut) == fmi3OK);
    for (int i = 0; i < 3; i++) {
        values[i] = i - 1.25;
    }
    CHECK(fmi->SetFloat64(strut, &table, 1, values, 3) == fmi3OK);
    CHECK(fmi->GetFloat64(strut, &table, 1, again, 3) == fmi3OK);
    CHECK(memcmp(values, again, 3 * sizeof *values) == 0);
    fmi->FreeInstance(strut);
    fmi3Instance law = make(fmi, &owner, STRIBECK_LUGRE_GUID);
    REQUIRE(law != NULL);
    REFUSED(&owner, fmi3Error, "LuGre has no structural parameters", fmi->EnterConfigurationMode(law));
    fmi->FreeInstance(law);
}

/* Integers, choices and truth values. */
static void every_type_has_its_functions(const functions *fmi) {
    host owner;
    fmi3Instance strut = make(fmi, &owner, STRIBECK_SHOCK_ABSORBER_GUID);
    REQUIRE(strut != NULL);
    const fmi3ValueReference law = reference_of("friction.model"), count = reference_of("damper.tab_n"),
                             on = reference_of("gas.enabled");
    fmi3Int64 choice = 2, read_choice = 0;
    CHECK(fmi->SetInt64(strut, &law, 1, &choice, 1) == fmi3OK);
    CHECK(fmi->GetInt64(strut, &law, 1, &read_choice, 1) == fmi3OK && read_choice == 2);
    fmi3Int32 number = 5, read_number = 0;
    CHECK(fmi->SetInt32(strut, &count, 1, &number, 1) == fmi3OK);
    CHECK(fmi->GetInt32(strut, &count, 1, &read_number, 1) == fmi3OK && read_number == 5);
    const fmi3Boolean before = (fmi3Boolean)is_set(fmi, strut, on), opposite = !before;
    CHECK(fmi->SetBoolean(strut, &on, 1, &opposite, 1) == fmi3OK);
    CHECK(is_set(fmi, strut, on) == opposite);
    choice = 1000;
    REFUSED(&owner, fmi3Discard, "friction.model = 1000", fmi->SetInt64(strut, &law, 1, &choice, 1));
    fmi->FreeInstance(strut);
}

/* No model has variables of other types: that of another type is named, and so is a number of values. */
#define HAS_NO(type, value)                                                                                            \
    do {                                                                                                               \
        fmi3##type one = value;                                                                                        \
        REFUSED(&owner, fmi3Error, "velocity (value reference 846470194) is of type Float64, not " #type,              \
                fmi->Get##type(law, &velocity, 1, &one, 1));                                                           \
        CHECK(fmi->Reset(law) == fmi3OK);                                                                              \
        REFUSED(&owner, fmi3Error, "is of type Float64, not " #type, fmi->Set##type(law, &velocity, 1, &one, 1));      \
        CHECK(fmi->Reset(law) == fmi3OK);                                                                              \
        REFUSED(&owner, fmi3Error, "7 values: must be 0", fmi->Get##type(law, NULL, 0, &one, 7));                      \
        CHECK(fmi->Reset(law) == fmi3OK);                                                                              \
        REFUSED(&owner, fmi3Error, "7 values: must be 0", fmi->Set##type(law, NULL, 0, &one, 7));                      \
        CHECK(fmi->Reset(law) == fmi3OK);                                                                              \
        CHECK(fmi->Get##type(law, NULL, 0, NULL, 0) == fmi3OK && fmi->Set##type(law, NULL, 0, NULL, 0) == fmi3OK);     \
    } while (0)

static void other_types_are_refused(const functions *fmi) {
    host owner;
    fmi3Instance law = make(fmi, &owner, STRIBECK_LUGRE_GUID);
    REQUIRE(law != NULL);
    const fmi3ValueReference velocity = STRIBECK_LUGRE_VELOCITY;
    HAS_NO(Float32, 1.0f);
    HAS_NO(Int8, 1);
    HAS_NO(UInt8, 1);
    HAS_NO(Int16, 1);
    HAS_NO(UInt16, 1);
    HAS_NO(UInt32, 1);
    HAS_NO(String, "1");
    const fmi3Byte byte = 1;
    fmi3Binary bytes = &byte;
    size_t size = 1;
    REFUSED(&owner, fmi3Error, "not Binary", fmi->GetBinary(law, &velocity, 1, &size, &bytes, 1));
    CHECK(fmi->Reset(law) == fmi3OK);
    REFUSED(&owner, fmi3Error, "not Binary", fmi->SetBinary(law, &velocity, 1, &size, &bytes, 1));
    CHECK(fmi->Reset(law) == fmi3OK);
    REFUSED(&owner, fmi3Error, "7 values: must be 0", fmi->GetBinary(law, NULL, 0, &size, &bytes, 7));
    CHECK(fmi->Reset(law) == fmi3OK);
    REFUSED(&owner, fmi3Error, "7 values: must be 0", fmi->SetBinary(law, NULL, 0, &size, &bytes, 7));
    CHECK(fmi->Reset(law) == fmi3OK);
    fmi3Int64 whole = 1;
    REFUSED(&owner, fmi3Error, "is of type Float64, not Int64", fmi->GetInt64(law, &velocity, 1, &whole, 1));
    CHECK(fmi->Reset(law) == fmi3OK);
    const fmi3Float64 nothing = NAN;
    REFUSED(&owner, fmi3Discard, "velocity = NaN: must be a finite number",
            fmi->SetFloat64(law, &velocity, 1, &nothing, 1));
    CHECK(get(fmi, law, velocity) == 0.0);
    fmi->FreeInstance(law);
}

/* No model has clocks either. */
#define HAS_NO_CLOCK(call)                                                                                             \
    do {                                                                                                               \
        REFUSED(&owner, fmi3Error, "is of type Float64, not Clock", call);                                             \
        CHECK(fmi->Reset(rig) == fmi3OK);                                                                              \
        CHECK(fmi->EnterInitializationMode(rig, false, 0.0, 0.0, false, 0.0) == fmi3OK);                               \
    } while (0)

static void clocks_are_refused(const functions *fmi) {
    host owner;
    fmi3Instance rig = make(fmi, &owner, STRIBECK_BELT_RIG_GUID);
    REQUIRE(rig != NULL);
    const fmi3ValueReference mass = STRIBECK_BELT_RIG_MASS;
    fmi3Float64 interval = 1.0;
    fmi3UInt64 counter = 1, resolution = 2;
    fmi3IntervalQualifier qualifier = fmi3IntervalUnchanged;
    CHECK(fmi->EnterInitializationMode(rig, false, 0.0, 0.0, false, 0.0) == fmi3OK);
    HAS_NO_CLOCK(fmi->GetIntervalDecimal(rig, &mass, 1, &interval, &qualifier));
    HAS_NO_CLOCK(fmi->GetIntervalFraction(rig, &mass, 1, &counter, &resolution, &qualifier));
    HAS_NO_CLOCK(fmi->GetShiftDecimal(rig, &mass, 1, &interval));
    HAS_NO_CLOCK(fmi->GetShiftFraction(rig, &mass, 1, &counter, &resolution));
    HAS_NO_CLOCK(fmi->SetIntervalDecimal(rig, &mass, 1, &interval));
    HAS_NO_CLOCK(fmi->SetIntervalFraction(rig, &mass, 1, &counter, &resolution));
    HAS_NO_CLOCK(fmi->SetShiftDecimal(rig, &mass, 1, &interval));
    HAS_NO_CLOCK(fmi->SetShiftFraction(rig, &mass, 1, &counter, &resolution));
    REFUSED(&owner, fmi3Error, "state", fmi->ActivateModelPartition(rig, mass, 0.0));
    fmi->FreeInstance(rig);
    rig = make_for_solver(fmi, &owner, STRIBECK_BELT_RIG_GUID);
    REQUIRE(rig != NULL);
    fmi3Clock tick = true;
    initialise(fmi, rig);
    CHECK(fmi->GetClock(rig, NULL, 0, &tick) == fmi3OK && fmi->SetClock(rig, NULL, 0, &tick) == fmi3OK);
    REFUSED(&owner, fmi3Error, "not Clock", fmi->GetClock(rig, &mass, 1, &tick));
    CHECK(fmi->Reset(rig) == fmi3OK);
    initialise(fmi, rig);
    REFUSED(&owner, fmi3Error, "not Clock", fmi->SetClock(rig, &mass, 1, &tick));
    fmi->FreeInstance(rig);
    memset(&owner, 0, sizeof owner);
    CHECK(fmi->InstantiateScheduledExecution("clocked", STRIBECK_BELT_RIG_GUID, NULL, false, true, &owner, logger, NULL,
                                             NULL, NULL) == NULL);
    CHECK(owner.count == 1 && strstr(owner.text, "no model has partitions") != NULL);
}

/* The rates of the rig are linear: x' = v, v' = (F - k x) / m. */
static void derivatives_in_both_directions(const functions *fmi) {
    host owner;
    fmi3Instance rig = make_for_solver(fmi, &owner, STRIBECK_BELT_RIG_GUID);
    REQUIRE(rig != NULL);
    initialise(fmi, rig);
    const fmi3ValueReference rates[] = {reference_of("der(position)"), reference_of("der(block_velocity)")};
    const fmi3ValueReference knowns[] = {STRIBECK_BELT_RIG_POSITION, STRIBECK_BELT_RIG_BLOCK_VELOCITY};
    const fmi3Float64 seed[] = {3.0, 5.0};
    fmi3Float64 found[] = {NAN, NAN};
    CHECK(fmi->GetDirectionalDerivative(rig, rates, 2, knowns, 2, seed, 2, found, 2) == fmi3OK);
    CHECK(found[0] == 5.0 && fabs(found[1] + 2.0 * 3.0) < 1e-14);
    CHECK(fmi->GetAdjointDerivative(rig, rates, 2, knowns, 2, seed, 2, found, 2) == fmi3OK);
    CHECK(fabs(found[0] + 2.0 * 5.0) < 1e-14 && found[1] == 3.0);
    CHECK(fmi->GetDirectionalDerivative(rig, rates, 1, knowns + 1, 1, seed, 1, found, 1) == fmi3OK);
    CHECK(found[0] == 3.0);
    REFUSED(&owner, fmi3Error, "must be 1", fmi->GetDirectionalDerivative(rig, rates, 1, knowns, 2, seed, 2, found, 2));
    fmi->FreeInstance(rig);
}

/* ---------------------------------------------------------------------- misuse */

/* Refused calls say why. */
static void refusals_are_logged(const functions *fmi) {
    host owner;
    CHECK(make(fmi, &owner, "{00000000-0000-0000-0000-000000000000}") == NULL);
    CHECK(owner.count == 1 && owner.status == fmi3Error);
    CHECK(strstr(owner.text, "instantiationToken") != NULL);
    CHECK(make(fmi, &owner, NULL) == NULL);
    CHECK(fmi->InstantiateCoSimulation(NULL, STRIBECK_LUGRE_GUID, NULL, false, true, false, false, NULL, 0, &owner,
                                       logger, NULL) == NULL);
    CHECK(owner.count == 2);
    CHECK(fmi->InstantiateModelExchange("", STRIBECK_LUGRE_GUID, NULL, false, false, &owner, logger) == NULL);
    CHECK(owner.count == 2);

    fmi3Instance law = make(fmi, &owner, STRIBECK_LUGRE_GUID);
    REQUIRE(law != NULL);
    initialise(fmi, law);
    outcome made = {false, false, false, 0.0};
    owner.count = 0;
    REFUSED(&owner, fmi3Error, "-0.001",
            fmi->DoStep(law, 0.0, -1e-3, true, &made.event, &made.terminate, &made.early, &made.time));
    CHECK(owner.count == 1 && owner.status == fmi3Error && strcmp(owner.category, "logStatusError") == 0);
    /* No more steps after an error, but reset recovers. */
    REFUSED(&owner, fmi3Error, "state Error",
            fmi->DoStep(law, 0.0, 1e-3, true, &made.event, &made.terminate, &made.early, &made.time));
    CHECK(fmi->Reset(law) == fmi3OK);
    initialise(fmi, law);
    REFUSED(&owner, fmi3Error, "lastSuccessfulTime is NULL",
            fmi->DoStep(law, 0.0, 1e-3, true, &made.event, &made.terminate, &made.early, NULL));
    CHECK(fmi->Reset(law) == fmi3OK);
    initialise(fmi, law);
    step(fmi, law, 0.0, 1e-3);
    /* Dependencies of elements are not offered. */
    size_t number = 1;
    REFUSED(&owner, fmi3Error, "dependencies",
            fmi->GetNumberOfVariableDependencies(law, STRIBECK_LUGRE_FRICTION_FORCE, &number));
    CHECK(fmi->Reset(law) == fmi3OK);
    fmi3ValueReference reference = 0;
    fmi3DependencyKind kind = fmi3Dependent;
    REFUSED(&owner, fmi3Error, "dependencies",
            fmi->GetVariableDependencies(law, STRIBECK_LUGRE_FRICTION_FORCE, &number, &reference, &number, &kind, 1));
    CHECK(fmi->Reset(law) == fmi3OK);
    /* A disabled category is not logged. */
    const char *categories[] = {"logStatusError", "logNothing"};
    REFUSED(&owner, fmi3Error, "logNothing", fmi->SetDebugLogging(law, true, 2, categories));
    CHECK(fmi->Reset(law) == fmi3OK);
    CHECK(fmi->SetDebugLogging(law, false, 1, categories) == fmi3OK);
    owner.count = 0;
    CHECK(fmi->Terminate(law) == fmi3Error);
    CHECK(owner.count == 0);
    fmi->FreeInstance(law);
    CHECK(fmi->Terminate(NULL) == fmi3Error);
    fmi->FreeInstance(NULL);
}

/* A state travels as bytes from one instance to another, and the futures are identical. */
static void state_travels_between_instances(const functions *fmi) {
    host owner, owner_of_other;
    fmi3Instance one = make(fmi, &owner, STRIBECK_LUGRE_GUID);
    fmi3Instance other = make(fmi, &owner_of_other, STRIBECK_LUGRE_GUID);
    REQUIRE(one != NULL && other != NULL);
    set(fmi, one, STRIBECK_LUGRE_VELOCITY, 3e-4);
    initialise(fmi, one);
    initialise(fmi, other);
    step(fmi, one, 0.0, 0.01);

    fmi3FMUState state = NULL;
    size_t size = 0;
    CHECK(fmi->GetFMUState(one, &state) == fmi3OK);
    CHECK(fmi->SerializedFMUStateSize(one, state, &size) == fmi3OK);
    REQUIRE(size > 0);
    fmi3Byte *bytes = malloc(size);
    REQUIRE(bytes != NULL);
    CHECK(fmi->SerializeFMUState(one, state, bytes, size) == fmi3OK);
    CHECK(fmi->FreeFMUState(one, &state) == fmi3OK);
    CHECK(state == NULL);

    CHECK(fmi->DeserializeFMUState(other, bytes, size, &state) == fmi3OK);
    CHECK(fmi->SetFMUState(other, state) == fmi3OK);
    CHECK(fmi->FreeFMUState(other, &state) == fmi3OK);

    step(fmi, one, 0.01, 0.02);
    step(fmi, other, 0.01, 0.02);
    double force = get(fmi, one, STRIBECK_LUGRE_FRICTION_FORCE);
    CHECK(force != 0.0);
    CHECK(get(fmi, other, STRIBECK_LUGRE_FRICTION_FORCE) == force);
    REFUSED(&owner_of_other, fmi3Error, "bytes", fmi->DeserializeFMUState(other, bytes, size - 1, &state));
    free(bytes);
    fmi->FreeInstance(one);
    fmi->FreeInstance(other);
}

/* Importers unload the library after every run, and load it again for the next one. */
static void library_can_be_loaded_again_and_again(const char *path) {
    for (int i = 0; i < 100; i++) {
        library loaded = open_library(path);
        REQUIRE(loaded != NULL);
        functions fmi = resolve(loaded);
        host owner;
        fmi3Instance law = make(&fmi, &owner, STRIBECK_LUGRE_GUID);
        REQUIRE(law != NULL);
        initialise(&fmi, law);
        step(&fmi, law, 0.0, 1e-3);
        fmi.FreeInstance(law);
        close_library(loaded);
    }
}

int main(int argc, char **argv) {
    if (argc != 2) {
        fprintf(stderr, "usage: %s <shared library>\n", argv[0]);
        return 2;
    }
    library loaded = open_library(argv[1]);
    REQUIRE(loaded != NULL);
    functions fmi = resolve(loaded);
    REQUIRE(checks_failed == 0);
    CHECK(strcmp(fmi.GetVersion(), "3.0") == 0);
    plain_run_reaches_steady_sliding(&fmi);
    rig_swings_with_its_period(&fmi);
    rig_swings_in_a_solver(&fmi);
    indicators_change_sign(&fmi);
    a_step_ends_at_an_event(&fmi);
    forces_are_read_within_a_step(&fmi);
    an_experiment_is_kept(&fmi);
    arrays_have_sizes(&fmi);
    every_type_has_its_functions(&fmi);
    other_types_are_refused(&fmi);
    clocks_are_refused(&fmi);
    derivatives_in_both_directions(&fmi);
    refusals_are_logged(&fmi);
    state_travels_between_instances(&fmi);
    close_library(loaded);
    library_can_be_loaded_again_and_again(argv[1]);
    return report();
}
