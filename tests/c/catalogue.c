/* Steps every model of the library with moving inputs and prints its results with all their digits, so that runs on
 * different machines can be compared. The inputs are sums and products only, without functions of a C library.
 */
#include <stdio.h>
#include <stdlib.h>

#include "stribeck.h"

static const int STEPS = 500;
static const double STEP = 1e-3;  /* s */
static const int QUARTER = 25;    /* steps from the middle of the wave to its top */
static const double SWING = 0.01; /* top of the wave, relative to the start value if that is larger than 1 */

static void check(stribeck_status status, const stribeck_instance *model, const char *name) {
    if (status != STRIBECK_OK) {
        fprintf(stderr, "%s: %s\n", name, stribeck_last_error(model));
        exit(EXIT_FAILURE);
    }
}

/* Triangles between -1 and 1, later for later columns. */
static double wave(int at, uint32_t column) {
    int phase = (at + (int)column) % (4 * QUARTER);
    int from_top = abs(phase - 2 * QUARTER);
    return (double)(QUARTER - from_top) / QUARTER;
}

static double input(const stribeck_variable *variable, int at, uint32_t column) {
    double size = variable->start > 1.0 ? variable->start : 1.0;
    double value = variable->start + SWING * size * wave(at, column);
    if (value < variable->min) {
        return variable->min;
    }
    return value > variable->max ? variable->max : value;
}

static void move_inputs(stribeck_instance *model, const char *name, int at) {
    for (uint32_t index = 0; index < stribeck_variable_count(model); index++) {
        stribeck_variable variable;
        uint32_t reference = 0;
        check(stribeck_reference(model, index, &reference), model, name);
        check(stribeck_describe(model, reference, &variable), model, name);
        if (variable.role == STRIBECK_INPUT) {
            check(stribeck_set(model, reference, input(&variable, at, index)), model, name);
        }
    }
}

static void print_results(stribeck_instance *model, const char *name) {
    for (uint32_t index = 0; index < stribeck_variable_count(model); index++) {
        stribeck_variable variable;
        uint32_t reference = 0;
        check(stribeck_reference(model, index, &reference), model, name);
        check(stribeck_describe(model, reference, &variable), model, name);
        if (variable.role == STRIBECK_OUTPUT || variable.role == STRIBECK_STATE_OUTPUT) {
            double value = 0.0;
            check(stribeck_get(model, reference, &value), model, name);
            printf("%s %s %.17g\n", name, variable.name, value);
        }
    }
}

int main(void) {
    for (size_t i = 0; i < stribeck_model_count(); i++) {
        const char *name = stribeck_model_name(i);
        stribeck_instance *model = NULL;
        check(stribeck_create(name, &model), model, name);
        for (int at = 0; at < STEPS; at++) {
            move_inputs(model, name, at);
            check(stribeck_step(model, STEP), model, name);
        }
        print_results(model, name);
        stribeck_free(model);
    }
    return EXIT_SUCCESS;
}
