/* The two versions of FMI, with the same functions for both: a fault of the host is tried on each. */
#ifndef STRIBECK_TEST_VERSION_H
#define STRIBECK_TEST_VERSION_H

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <string.h>

#include "check.h"
#include "fmi3FunctionTypes.h"
#include "library.h"
#include "stribeck.h"

/* The status of both versions has the same numbers. */
enum { OK = fmi2OK, DISCARD = fmi2Discard, ERROR = fmi2Error };

#define SAME_IN_BOTH(DO)                                                                                               \
    DO(FreeInstance)                                                                                                   \
    DO(EnterInitializationMode)                                                                                        \
    DO(ExitInitializationMode)                                                                                         \
    DO(Reset)                                                                                                          \
    DO(DoStep)                                                                                                         \
    DO(GetDirectionalDerivative)                                                                                       \
    DO(EnterEventMode)                                                                                                 \
    DO(EnterContinuousTimeMode)                                                                                        \
    DO(CompletedIntegratorStep)                                                                                        \
    DO(SetContinuousStates)                                                                                            \
    DO(GetContinuousStates)                                                                                            \
    DO(GetNominalsOfContinuousStates)
#define ONLY_IN_2(DO)                                                                                                  \
    DO(Instantiate)                                                                                                    \
    DO(SetupExperiment)                                                                                                \
    DO(GetReal)                                                                                                        \
    DO(SetReal)                                                                                                        \
    DO(SetInteger)                                                                                                     \
    DO(SetBoolean)                                                                                                     \
    DO(SetRealInputDerivatives)                                                                                        \
    DO(GetRealOutputDerivatives)                                                                                       \
    DO(NewDiscreteStates)                                                                                              \
    DO(GetDerivatives)                                                                                                 \
    DO(GetFMUstate)                                                                                                    \
    DO(SetFMUstate)                                                                                                    \
    DO(FreeFMUstate)                                                                                                   \
    DO(SerializedFMUstateSize)                                                                                         \
    DO(SerializeFMUstate)                                                                                              \
    DO(DeSerializeFMUstate)
#define ONLY_IN_3(DO)                                                                                                  \
    DO(InstantiateCoSimulation)                                                                                        \
    DO(InstantiateModelExchange)                                                                                       \
    DO(GetFloat64)                                                                                                     \
    DO(SetFloat64)                                                                                                     \
    DO(SetInt32)                                                                                                       \
    DO(SetInt64)                                                                                                       \
    DO(SetBoolean)                                                                                                     \
    DO(GetOutputDerivatives)                                                                                           \
    DO(UpdateDiscreteStates)                                                                                           \
    DO(GetContinuousStateDerivatives)                                                                                  \
    DO(GetFMUState)                                                                                                    \
    DO(SetFMUState)                                                                                                    \
    DO(FreeFMUState)                                                                                                   \
    DO(SerializedFMUStateSize)                                                                                         \
    DO(SerializeFMUState)                                                                                              \
    DO(DeserializeFMUState)

#define MEMBER_2(name) __typeof__(fmi2##name) *name;
#define MEMBER_3(name) fmi3##name##TYPE *name;

/* The functions of one version in one library. */
typedef struct {
    int number;
    struct {
        SAME_IN_BOTH(MEMBER_2)
        ONLY_IN_2(MEMBER_2)
    } two;
    struct {
        SAME_IN_BOTH(MEMBER_3)
        ONLY_IN_3(MEMBER_3)
    } three;
} version;

#define RESOLVE_2(name)                                                                                                \
    address = find(loaded, "fmi2" #name);                                                                              \
    REQUIRE(address != NULL);                                                                                          \
    memcpy(&fmi.two.name, &address, sizeof address);
#define RESOLVE_3(name)                                                                                                \
    address = find(loaded, "fmi3" #name);                                                                              \
    REQUIRE(address != NULL);                                                                                          \
    memcpy(&fmi.three.name, &address, sizeof address);

static inline version version_of(library loaded, int number) {
    version fmi;
    void *address;
    memset(&fmi, 0, sizeof fmi);
    fmi.number = number;
    if (number == 2) {
        SAME_IN_BOTH(RESOLVE_2)
        ONLY_IN_2(RESOLVE_2)
    } else {
        SAME_IN_BOTH(RESOLVE_3)
        ONLY_IN_3(RESOLVE_3)
    }
    return fmi;
}

#define CALL(name, ...) (fmi->number == 2 ? (int)fmi->two.name(__VA_ARGS__) : (int)fmi->three.name(__VA_ARGS__))

/* The last message. */
static char heard[200];

static inline void hear_2(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status,
                          fmi2String category, fmi2String message, ...) {
    (void)environment, (void)instance, (void)status, (void)category;
    va_list arguments;
    va_start(arguments, message);
    vsnprintf(heard, sizeof heard, message, arguments);
    va_end(arguments);
}

static inline void hear_3(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                          fmi3String message) {
    (void)environment, (void)status, (void)category;
    snprintf(heard, sizeof heard, "%s", message);
}

/* An instance, or NULL; with `hears` its messages go to `heard`. */
static inline void *instantiate(const version *fmi, const char *guid, bool is_exchange, bool hears) {
    if (fmi->number == 2) {
        fmi2CallbackFunctions callbacks = {hears ? hear_2 : NULL, NULL, NULL, NULL, NULL};
        fmi2Type type = is_exchange ? fmi2ModelExchange : fmi2CoSimulation;
        return fmi->two.Instantiate("slave", type, guid, "", &callbacks, fmi2False, fmi2True);
    }
    fmi3LogMessageCallback logger = hears ? hear_3 : NULL;
    return is_exchange ? fmi->three.InstantiateModelExchange("slave", guid, "", false, true, NULL, logger)
                       : fmi->three.InstantiateCoSimulation("slave", guid, "", false, true, false, false, NULL, 0, NULL,
                                                            logger, NULL);
}

static inline void free_instance(const version *fmi, void *slave) {
    if (fmi->number == 2) {
        fmi->two.FreeInstance(slave);
    } else {
        fmi->three.FreeInstance(slave);
    }
}

static inline int initialise(const version *fmi, void *slave) {
    if (fmi->number == 2) {
        CHECK(fmi->two.SetupExperiment(slave, fmi2False, 0.0, 0.0, fmi2False, 0.0) == fmi2OK);
        CHECK(fmi->two.EnterInitializationMode(slave) == fmi2OK);
    } else {
        CHECK(fmi->three.EnterInitializationMode(slave, false, 0.0, 0.0, false, 0.0) == fmi3OK);
    }
    return CALL(ExitInitializationMode, slave);
}

static inline int do_step(const version *fmi, void *slave, double time, double length) {
    if (fmi->number == 2) {
        return (int)fmi->two.DoStep(slave, time, length, fmi2True);
    }
    fmi3Boolean event, terminate, early;
    fmi3Float64 reached = NAN;
    int status = (int)fmi->three.DoStep(slave, time, length, true, &event, &terminate, &early, &reached);
    /* The mode of the host may round its sum otherwise. */
    bool is_there = status != OK || fabs(reached - (time + length)) <= 1e-15 * (fabs(time) + length);
    CHECK(is_there && (status != OK || (!event && !terminate && !early)));
    return status;
}

static inline int get_reals(const version *fmi, void *slave, const uint32_t *references, size_t count, double *values,
                            size_t elements) {
    return fmi->number == 2 ? (int)fmi->two.GetReal(slave, references, count, values)
                            : (int)fmi->three.GetFloat64(slave, references, count, values, elements);
}

static inline int set_reals(const version *fmi, void *slave, const uint32_t *references, size_t count,
                            const double *values, size_t elements) {
    return fmi->number == 2 ? (int)fmi->two.SetReal(slave, references, count, values)
                            : (int)fmi->three.SetFloat64(slave, references, count, values, elements);
}

/* Sets a Boolean variable with all its elements, one in FMI 2.0. */
static inline int set_booleans(const version *fmi, void *slave, uint32_t reference, const bool *values,
                               size_t elements) {
    const fmi2Boolean flag = values[0];
    return fmi->number == 2 ? (int)fmi->two.SetBoolean(slave, &reference, 1, &flag)
                            : (int)fmi->three.SetBoolean(slave, &reference, 1, values, elements);
}

/* Sets an integer or a choice. */
static inline int set_whole(const version *fmi, void *slave, stribeck_kind kind, uint32_t reference, int32_t value) {
    const fmi3Int64 choice = value;
    if (fmi->number == 2) {
        return (int)fmi->two.SetInteger(slave, &reference, 1, &value);
    }
    return kind == STRIBECK_ENUMERATION ? (int)fmi->three.SetInt64(slave, &reference, 1, &choice, 1)
                                        : (int)fmi->three.SetInt32(slave, &reference, 1, &value, 1);
}

/* The time derivative of an output. */
static inline int get_slope(const version *fmi, void *slave, uint32_t reference, double *slope) {
    const int32_t order = 1;
    return fmi->number == 2 ? (int)fmi->two.GetRealOutputDerivatives(slave, &reference, 1, &order, slope)
                            : (int)fmi->three.GetOutputDerivatives(slave, &reference, 1, &order, slope, 1);
}

/* A partial derivative. */
static inline int differentiate(const version *fmi, void *slave, uint32_t unknown, uint32_t known, double *slope) {
    const double seed = 1.0;
    return fmi->number == 2
               ? (int)fmi->two.GetDirectionalDerivative(slave, &unknown, 1, &known, 1, &seed, slope)
               : (int)fmi->three.GetDirectionalDerivative(slave, &unknown, 1, &known, 1, &seed, 1, slope, 1);
}

static inline int new_discrete_states(const version *fmi, void *slave) {
    if (fmi->number == 2) {
        fmi2EventInfo info;
        return (int)fmi->two.NewDiscreteStates(slave, &info);
    }
    fmi3Boolean more, terminate, nominals, values, defined;
    fmi3Float64 next;
    return (int)fmi->three.UpdateDiscreteStates(slave, &more, &terminate, &nominals, &values, &defined, &next);
}

static inline int get_derivatives(const version *fmi, void *slave, double *values, size_t count) {
    return fmi->number == 2 ? (int)fmi->two.GetDerivatives(slave, values, count)
                            : (int)fmi->three.GetContinuousStateDerivatives(slave, values, count);
}

static inline int completed_step(const version *fmi, void *slave) {
    fmi2Boolean event, end;
    fmi3Boolean event_3, end_3;
    return fmi->number == 2 ? (int)fmi->two.CompletedIntegratorStep(slave, fmi2True, &event, &end)
                            : (int)fmi->three.CompletedIntegratorStep(slave, true, &event_3, &end_3);
}

static inline int save(const version *fmi, void *slave, void **state) {
    return fmi->number == 2 ? (int)fmi->two.GetFMUstate(slave, state) : (int)fmi->three.GetFMUState(slave, state);
}

static inline int restore(const version *fmi, void *slave, void *state) {
    return fmi->number == 2 ? (int)fmi->two.SetFMUstate(slave, state) : (int)fmi->three.SetFMUState(slave, state);
}

static inline int free_state(const version *fmi, void *slave, void **state) {
    return fmi->number == 2 ? (int)fmi->two.FreeFMUstate(slave, state) : (int)fmi->three.FreeFMUState(slave, state);
}

/* A saved state as bytes, to be freed. */
static inline unsigned char *bytes_of_state(const version *fmi, void *slave, void *state, size_t *size) {
    int measured = fmi->number == 2 ? (int)fmi->two.SerializedFMUstateSize(slave, state, size)
                                    : (int)fmi->three.SerializedFMUStateSize(slave, state, size);
    REQUIRE(measured == OK);
    unsigned char *bytes = malloc(*size);
    REQUIRE(bytes != NULL);
    int status = fmi->number == 2 ? (int)fmi->two.SerializeFMUstate(slave, state, (fmi2Byte *)bytes, *size)
                                  : (int)fmi->three.SerializeFMUState(slave, state, bytes, *size);
    CHECK(status == OK);
    return bytes;
}

static inline int read_state(const version *fmi, void *slave, const unsigned char *bytes, size_t size, void **state) {
    return fmi->number == 2 ? (int)fmi->two.DeSerializeFMUstate(slave, (const fmi2Byte *)bytes, size, state)
                            : (int)fmi->three.DeserializeFMUState(slave, bytes, size, state);
}

#endif
