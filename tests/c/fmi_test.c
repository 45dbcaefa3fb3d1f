/* The FMI 2.0 functions as an importer uses them: in a library that is loaded while the program runs.
 *
 * Usage: fmi_test <path of the shared library>
 */
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "check.h"
#include "library.h"
#include "stribeck.h"

/* Every function that FMI 2.0 requires of a co-simulation slave; importers refuse a library that lacks one. */
static const char *const FUNCTIONS[] = {
    "fmi2GetTypesPlatform",
    "fmi2GetVersion",
    "fmi2SetDebugLogging",
    "fmi2Instantiate",
    "fmi2FreeInstance",
    "fmi2SetupExperiment",
    "fmi2EnterInitializationMode",
    "fmi2ExitInitializationMode",
    "fmi2Terminate",
    "fmi2Reset",
    "fmi2GetReal",
    "fmi2GetInteger",
    "fmi2GetBoolean",
    "fmi2GetString",
    "fmi2SetReal",
    "fmi2SetInteger",
    "fmi2SetBoolean",
    "fmi2SetString",
    "fmi2GetFMUstate",
    "fmi2SetFMUstate",
    "fmi2FreeFMUstate",
    "fmi2SerializedFMUstateSize",
    "fmi2SerializeFMUstate",
    "fmi2DeSerializeFMUstate",
    "fmi2GetDirectionalDerivative",
    "fmi2SetRealInputDerivatives",
    "fmi2GetRealOutputDerivatives",
    "fmi2DoStep",
    "fmi2CancelStep",
    "fmi2GetStatus",
    "fmi2GetRealStatus",
    "fmi2GetIntegerStatus",
    "fmi2GetBooleanStatus",
    "fmi2GetStringStatus",
    "fmi2EnterEventMode",
    "fmi2NewDiscreteStates",
    "fmi2EnterContinuousTimeMode",
    "fmi2CompletedIntegratorStep",
    "fmi2SetTime",
    "fmi2SetContinuousStates",
    "fmi2GetDerivatives",
    "fmi2GetEventIndicators",
    "fmi2GetContinuousStates",
    "fmi2GetNominalsOfContinuousStates",
};

/* The functions that this program calls. */
typedef struct {
    const char *(*GetTypesPlatform)(void);
    const char *(*GetVersion)(void);
    fmi2Status (*SetDebugLogging)(fmi2Component, fmi2Boolean, size_t, const fmi2String[]);
    fmi2Component (*Instantiate)(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *,
                                 fmi2Boolean, fmi2Boolean);
    void (*FreeInstance)(fmi2Component);
    fmi2Status (*SetupExperiment)(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real);
    fmi2Status (*EnterInitializationMode)(fmi2Component);
    fmi2Status (*ExitInitializationMode)(fmi2Component);
    fmi2Status (*Terminate)(fmi2Component);
    fmi2Status (*Reset)(fmi2Component);
    fmi2Status (*SetReal)(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Real[]);
    fmi2Status (*GetReal)(fmi2Component, const fmi2ValueReference[], size_t, fmi2Real[]);
    fmi2Status (*GetBoolean)(fmi2Component, const fmi2ValueReference[], size_t, fmi2Boolean[]);
    fmi2Status (*DoStep)(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean);
    fmi2Status (*EnterEventMode)(fmi2Component);
    fmi2Status (*NewDiscreteStates)(fmi2Component, fmi2EventInfo *);
    fmi2Status (*EnterContinuousTimeMode)(fmi2Component);
    fmi2Status (*SetTime)(fmi2Component, fmi2Real);
    fmi2Status (*SetContinuousStates)(fmi2Component, const fmi2Real[], size_t);
    fmi2Status (*GetContinuousStates)(fmi2Component, fmi2Real[], size_t);
    fmi2Status (*GetDerivatives)(fmi2Component, fmi2Real[], size_t);
    fmi2Status (*CompletedIntegratorStep)(fmi2Component, fmi2Boolean, fmi2Boolean *, fmi2Boolean *);
    fmi2Status (*GetFMUstate)(fmi2Component, fmi2FMUstate *);
    fmi2Status (*SetFMUstate)(fmi2Component, fmi2FMUstate);
    fmi2Status (*FreeFMUstate)(fmi2Component, fmi2FMUstate *);
    fmi2Status (*SerializedFMUstateSize)(fmi2Component, fmi2FMUstate, size_t *);
    fmi2Status (*SerializeFMUstate)(fmi2Component, fmi2FMUstate, fmi2Byte[], size_t);
    fmi2Status (*DeSerializeFMUstate)(fmi2Component, const fmi2Byte[], size_t, fmi2FMUstate *);
} functions;

/* ISO C has no cast from void * to a function pointer; POSIX and Windows promise that a copy of the bytes works. */
#define RESOLVE(loaded, table, name)                                                                                   \
    do {                                                                                                               \
        void *address = find(loaded, "fmi2" #name);                                                                    \
        memcpy(&(table)->name, &address, sizeof address);                                                              \
    } while (0)

static functions resolve(library loaded) {
    functions fmi;
    RESOLVE(loaded, &fmi, GetTypesPlatform);
    RESOLVE(loaded, &fmi, GetVersion);
    RESOLVE(loaded, &fmi, SetDebugLogging);
    RESOLVE(loaded, &fmi, Instantiate);
    RESOLVE(loaded, &fmi, FreeInstance);
    RESOLVE(loaded, &fmi, SetupExperiment);
    RESOLVE(loaded, &fmi, EnterInitializationMode);
    RESOLVE(loaded, &fmi, ExitInitializationMode);
    RESOLVE(loaded, &fmi, Terminate);
    RESOLVE(loaded, &fmi, Reset);
    RESOLVE(loaded, &fmi, SetReal);
    RESOLVE(loaded, &fmi, GetReal);
    RESOLVE(loaded, &fmi, GetBoolean);
    RESOLVE(loaded, &fmi, DoStep);
    RESOLVE(loaded, &fmi, EnterEventMode);
    RESOLVE(loaded, &fmi, NewDiscreteStates);
    RESOLVE(loaded, &fmi, EnterContinuousTimeMode);
    RESOLVE(loaded, &fmi, SetTime);
    RESOLVE(loaded, &fmi, SetContinuousStates);
    RESOLVE(loaded, &fmi, GetContinuousStates);
    RESOLVE(loaded, &fmi, GetDerivatives);
    RESOLVE(loaded, &fmi, CompletedIntegratorStep);
    RESOLVE(loaded, &fmi, GetFMUstate);
    RESOLVE(loaded, &fmi, SetFMUstate);
    RESOLVE(loaded, &fmi, FreeFMUstate);
    RESOLVE(loaded, &fmi, SerializedFMUstateSize);
    RESOLVE(loaded, &fmi, SerializeFMUstate);
    RESOLVE(loaded, &fmi, DeSerializeFMUstate);
    return fmi;
}

/* ---------------------------------------------------------------------- log */

typedef struct {
    int count;
    fmi2Status status;
    char instance[64];
    char category[64];
    char text[512];
} message_log;

static void logger(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                   fmi2String message, ...) {
    message_log *log = environment;
    log->count++;
    log->status = status;
    snprintf(log->instance, sizeof log->instance, "%s", instance);
    snprintf(log->category, sizeof log->category, "%s", category);
    va_list arguments;
    va_start(arguments, message);
    vsnprintf(log->text, sizeof log->text, message, arguments);
    va_end(arguments);
}

static fmi2Component make_for(const functions *fmi, fmi2Type purpose, fmi2String guid, message_log *log) {
    fmi2CallbackFunctions callbacks = {logger, NULL, NULL, NULL, log};
    fmi2Component made = fmi->Instantiate("contact", purpose, guid, NULL, &callbacks, fmi2False, fmi2True);
    /* The structure belongs to the caller again: it must not be read any more. */
    memset(&callbacks, 0xFF, sizeof callbacks);
    return made;
}

static fmi2Component make(const functions *fmi, fmi2String guid, message_log *log) {
    return make_for(fmi, fmi2CoSimulation, guid, log);
}

static void initialise(const functions *fmi, fmi2Component slave) {
    CHECK(fmi->SetupExperiment(slave, fmi2True, 1e-6, 0.0, fmi2False, 0.0) == fmi2OK);
    CHECK(fmi->EnterInitializationMode(slave) == fmi2OK);
    CHECK(fmi->ExitInitializationMode(slave) == fmi2OK);
}

static double get(const functions *fmi, fmi2Component slave, fmi2ValueReference reference) {
    fmi2Real value = NAN;
    CHECK(fmi->GetReal(slave, &reference, 1, &value) == fmi2OK);
    return value;
}

static void set(const functions *fmi, fmi2Component slave, fmi2ValueReference reference, fmi2Real value) {
    CHECK(fmi->SetReal(slave, &reference, 1, &value) == fmi2OK);
}

/* ---------------------------------------------------------------------- tests */

static void every_function_of_the_standard_is_there(library loaded) {
    for (size_t i = 0; i < sizeof FUNCTIONS / sizeof FUNCTIONS[0]; i++) {
        if (!CHECK(find(loaded, FUNCTIONS[i]) != NULL)) {
            fprintf(stderr, "  missing: %s\n", FUNCTIONS[i]);
        }
    }
    /* A library that resolved any name would prove nothing. */
    CHECK(find(loaded, "fmi2NoSuchFunction") == NULL);
}

static void platform_and_version(const functions *fmi) {
    CHECK(strcmp(fmi->GetTypesPlatform(), "default") == 0);
    CHECK(strcmp(fmi->GetVersion(), "2.0") == 0);
}

/* A contact that slides steadily carries the level of the Stribeck curve. */
static void plain_run_reaches_steady_sliding(const functions *fmi) {
    message_log log = {0};
    fmi2Component slave = make(fmi, STRIBECK_LUGRE_GUID, &log);
    REQUIRE(slave != NULL);
    const double v = 0.002;
    set(fmi, slave, STRIBECK_LUGRE_VELOCITY, v);
    initialise(fmi, slave);
    for (int i = 0; i < 1000; i++) {
        CHECK(fmi->DoStep(slave, i * 1e-3, 1e-3, fmi2True) == fmi2OK);
    }
    double level = 0.981 + 0.4905 * exp(-4.0) + 0.1 * v;
    CHECK(fabs(get(fmi, slave, STRIBECK_LUGRE_FRICTION_FORCE) - level) < 1e-12);
    const fmi2ValueReference sticking = STRIBECK_LUGRE_STICKING;
    fmi2Boolean value = fmi2True;
    CHECK(fmi->GetBoolean(slave, &sticking, 1, &value) == fmi2OK);
    CHECK(value == fmi2False);
    CHECK(fmi->Terminate(slave) == fmi2OK);
    /* Reset returns to the start. */
    CHECK(fmi->Reset(slave) == fmi2OK);
    initialise(fmi, slave);
    CHECK(get(fmi, slave, STRIBECK_LUGRE_FRICTION_FORCE) == 0.0);
    CHECK(get(fmi, slave, STRIBECK_LUGRE_VELOCITY) == 0.0);
    fmi->FreeInstance(slave);
    /* Both runs say that the parameters are not passive. */
    CHECK(log.count == 2 && strstr(log.text, "below 158.114 the damping of the bristles") != NULL);
}

/* The free block is an oscillator: after a period it is where it was, whatever the size of the steps. */
static void rig_swings_with_its_period(const functions *fmi) {
    message_log log = {0};
    fmi2Component rig = make(fmi, STRIBECK_BELT_RIG_GUID, &log);
    REQUIRE(rig != NULL);
    set(fmi, rig, STRIBECK_BELT_RIG_POSITION, 0.3);
    set(fmi, rig, STRIBECK_BELT_RIG_BLOCK_VELOCITY, 0.0);
    initialise(fmi, rig);
    double period = 2.0 * acos(-1.0) / sqrt(2.0);
    double t = 0.0;
    for (int i = 0; i < 7; i++) {
        CHECK(fmi->DoStep(rig, t, period / 7.0, fmi2True) == fmi2OK);
        t += period / 7.0;
    }
    CHECK(fabs(get(fmi, rig, STRIBECK_BELT_RIG_POSITION) - 0.3) < 1e-14);
    CHECK(fabs(get(fmi, rig, STRIBECK_BELT_RIG_BLOCK_VELOCITY)) < 1e-14);
    fmi->FreeInstance(rig);
    CHECK(log.count == 0);
}

/* Position and velocity of the block. */
#define STATES 2

static void slopes_at(const functions *fmi, fmi2Component rig, double t, const double x[STATES],
                      double slopes[STATES]) {
    CHECK(fmi->SetTime(rig, t) == fmi2OK);
    CHECK(fmi->SetContinuousStates(rig, x, STATES) == fmi2OK);
    CHECK(fmi->GetDerivatives(rig, slopes, STATES) == fmi2OK);
}

/* One step of the midpoint rule, as a master with a solver of its own makes it. */
static void integrate(const functions *fmi, fmi2Component rig, double t, double h) {
    double x[STATES], middle[STATES], slopes[STATES];
    CHECK(fmi->GetContinuousStates(rig, x, STATES) == fmi2OK);
    slopes_at(fmi, rig, t, x, slopes);
    for (int i = 0; i < STATES; i++) {
        middle[i] = x[i] + 0.5 * h * slopes[i];
    }
    slopes_at(fmi, rig, t + 0.5 * h, middle, slopes);
    for (int i = 0; i < STATES; i++) {
        x[i] += h * slopes[i];
    }
    CHECK(fmi->SetTime(rig, t + h) == fmi2OK);
    CHECK(fmi->SetContinuousStates(rig, x, STATES) == fmi2OK);
    fmi2Boolean event = fmi2True, end = fmi2True;
    CHECK(fmi->CompletedIntegratorStep(rig, fmi2True, &event, &end) == fmi2OK);
    CHECK(event == fmi2False && end == fmi2False);
}

/* The block swings with its period in Model Exchange as well; the midpoint rule is off by less than (omega h)^2. */
static void rig_swings_in_a_solver(const functions *fmi) {
    message_log log = {0};
    fmi2Component rig = make_for(fmi, fmi2ModelExchange, STRIBECK_BELT_RIG_GUID, &log);
    REQUIRE(rig != NULL);
    set(fmi, rig, STRIBECK_BELT_RIG_POSITION, 0.3);
    set(fmi, rig, STRIBECK_BELT_RIG_BLOCK_VELOCITY, 0.0);
    initialise(fmi, rig);
    fmi2EventInfo info;
    CHECK(fmi->NewDiscreteStates(rig, &info) == fmi2OK);
    CHECK(info.newDiscreteStatesNeeded == fmi2False && info.nextEventTimeDefined == fmi2False);
    CHECK(fmi->EnterContinuousTimeMode(rig) == fmi2OK);
    const int steps = 2000;
    const double omega = sqrt(2.0), h = 2.0 * acos(-1.0) / omega / steps;
    for (int i = 0; i < steps; i++) {
        integrate(fmi, rig, i * h, h);
    }
    double off = omega * h * omega * h;
    CHECK(fabs(get(fmi, rig, STRIBECK_BELT_RIG_POSITION) - 0.3) < 0.3 * off);
    CHECK(fabs(get(fmi, rig, STRIBECK_BELT_RIG_BLOCK_VELOCITY)) < 2.0 * 0.3 * omega * off);
    CHECK(fmi->EnterEventMode(rig) == fmi2OK);
    CHECK(fmi->Terminate(rig) == fmi2OK);
    fmi->FreeInstance(rig);
    CHECK(log.count == 0);
    /* A law with random bonds has no derivative, and reports that. */
    CHECK(make_for(fmi, fmi2ModelExchange, STRIBECK_BRISTLE_GUID, &log) == NULL);
    CHECK(log.count == 1);
}

/* Refused calls say why, through a logger that expands its format. */
static void refusals_are_logged(const functions *fmi) {
    message_log log = {0};
    CHECK(make(fmi, "{00000000-0000-0000-0000-000000000000}", &log) == NULL);
    CHECK(log.count == 1);
    CHECK(log.status == fmi2Error);
    CHECK(strcmp(log.instance, "contact") == 0);
    CHECK(make(fmi, NULL, &log) == NULL);
    CHECK(log.count == 2);

    fmi2Component slave = make(fmi, STRIBECK_LUGRE_GUID, &log);
    REQUIRE(slave != NULL);
    initialise(fmi, slave);
    log.count = 0;
    CHECK(fmi->DoStep(slave, 0.0, -1e-3, fmi2True) == fmi2Error);
    CHECK(log.count == 1);
    CHECK(log.status == fmi2Error);
    CHECK(strcmp(log.category, "logStatusError") == 0);
    CHECK(strstr(log.text, "-0.001") != NULL);
    /* No more steps after an error, but reset recovers. */
    CHECK(fmi->DoStep(slave, 0.0, 1e-3, fmi2True) == fmi2Error);
    CHECK(fmi->Reset(slave) == fmi2OK);
    initialise(fmi, slave);
    CHECK(fmi->DoStep(slave, 0.0, 1e-3, fmi2True) == fmi2OK);
    /* A disabled category is not logged. */
    log.count = 0;
    CHECK(fmi->SetDebugLogging(slave, fmi2False, 0, NULL) == fmi2OK);
    CHECK(fmi->DoStep(slave, 0.001, NAN, fmi2True) == fmi2Error);
    CHECK(log.count == 0);
    fmi->FreeInstance(slave);

    CHECK(fmi->DoStep(NULL, 0.0, 1e-3, fmi2True) == fmi2Error);
    fmi->FreeInstance(NULL);
}

/* A state travels as bytes from one instance to another, and the futures are identical. */
static void state_travels_between_instances(const functions *fmi) {
    message_log log = {0};
    fmi2Component one = make(fmi, STRIBECK_LUGRE_GUID, &log);
    fmi2Component other = make(fmi, STRIBECK_LUGRE_GUID, &log);
    REQUIRE(one != NULL && other != NULL);
    set(fmi, one, STRIBECK_LUGRE_VELOCITY, 3e-4);
    initialise(fmi, one);
    initialise(fmi, other);
    CHECK(fmi->DoStep(one, 0.0, 0.01, fmi2False) == fmi2OK);

    fmi2FMUstate state = NULL;
    size_t size = 0;
    CHECK(fmi->GetFMUstate(one, &state) == fmi2OK);
    CHECK(fmi->SerializedFMUstateSize(one, state, &size) == fmi2OK);
    REQUIRE(size > 0);
    fmi2Byte *bytes = malloc(size);
    REQUIRE(bytes != NULL);
    CHECK(fmi->SerializeFMUstate(one, state, bytes, size) == fmi2OK);
    CHECK(fmi->FreeFMUstate(one, &state) == fmi2OK);
    CHECK(state == NULL);

    CHECK(fmi->DeSerializeFMUstate(other, bytes, size, &state) == fmi2OK);
    CHECK(fmi->SetFMUstate(other, state) == fmi2OK);
    CHECK(fmi->FreeFMUstate(other, &state) == fmi2OK);
    free(bytes);

    CHECK(fmi->DoStep(one, 0.01, 0.02, fmi2False) == fmi2OK);
    CHECK(fmi->DoStep(other, 0.01, 0.02, fmi2False) == fmi2OK);
    double force = get(fmi, one, STRIBECK_LUGRE_FRICTION_FORCE);
    CHECK(force != 0.0);
    CHECK(get(fmi, other, STRIBECK_LUGRE_FRICTION_FORCE) == force);
    fmi->FreeInstance(one);
    fmi->FreeInstance(other);
    /* Each says that its parameters are not passive. */
    CHECK(log.count == 2);
}

/* Importers unload the library after every run, and load it again for the next one. */
static void library_can_be_loaded_again_and_again(const char *path) {
    for (int i = 0; i < 100; i++) {
        library loaded = open_library(path);
        REQUIRE(loaded != NULL);
        functions fmi = resolve(loaded);
        message_log log = {0};
        fmi2Component slave = make(&fmi, STRIBECK_LUGRE_GUID, &log);
        REQUIRE(slave != NULL);
        initialise(&fmi, slave);
        CHECK(fmi.DoStep(slave, 0.0, 1e-3, fmi2True) == fmi2OK);
        fmi.FreeInstance(slave);
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
    every_function_of_the_standard_is_there(loaded);
    REQUIRE(checks_failed == 0);
    functions fmi = resolve(loaded);
    platform_and_version(&fmi);
    plain_run_reaches_steady_sliding(&fmi);
    rig_swings_with_its_period(&fmi);
    rig_swings_in_a_solver(&fmi);
    refusals_are_logged(&fmi);
    state_travels_between_instances(&fmi);
    close_library(loaded);
    library_can_be_loaded_again_and_again(argv[1]);
    return report();
}
