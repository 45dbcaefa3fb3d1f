/* The minimal FMI 2.0 co-simulation slave: a row of numbers, copied in and out, and one function that advances it. No
 * checks of any kind. The benchmarks compare Stribeck's functions with it.
 *
 * A law includes this file after it has defined COLUMNS and START (the start values), and then defines advance().
 */
#ifndef FLOOR_FMU_H
#define FLOOR_FMU_H

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

typedef void *fmi2Component;
typedef const char *fmi2String;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Boolean;
typedef enum { fmi2OK } fmi2Status;

#if defined _WIN32
#define FMI2_EXPORT __declspec(dllexport)
#else
#define FMI2_EXPORT
#endif

static void advance(double *row, double dt);

FMI2_EXPORT fmi2Component fmi2Instantiate(fmi2String name, int type, fmi2String guid, fmi2String resources,
                                          const void *functions, fmi2Boolean visible, fmi2Boolean logging_on) {
    (void)name, (void)type, (void)guid, (void)resources, (void)functions, (void)visible, (void)logging_on;
    double *row = malloc(sizeof START);
    if (row != NULL) {
        memcpy(row, START, sizeof START);
    }
    return row;
}

FMI2_EXPORT void fmi2FreeInstance(fmi2Component c) {
    free(c);
}

FMI2_EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                           fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
    (void)c, (void)tolerance_defined, (void)tolerance, (void)start, (void)stop_defined, (void)stop;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real value[]) {
    double *row = c;
    for (size_t i = 0; i < n; i++) {
        row[vr[i]] = value[i];
    }
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
    const double *row = c;
    for (size_t i = 0; i < n; i++) {
        value[i] = row[vr[i]];
    }
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real t, fmi2Real h, fmi2Boolean no_set_state_before) {
    (void)t, (void)no_set_state_before;
    advance(c, h);
    return fmi2OK;
}

#endif
