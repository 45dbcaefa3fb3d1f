/* Strokes to and fro, whose speed rises and falls along straight lines. */
#include <stdio.h>
#include <stdlib.h>
#include "stribeck.h"

#define SAMPLES @samples@

static void check(stribeck_status status, const stribeck_instance *law) {
    if (status != STRIBECK_OK) {
        fprintf(stderr, "%s\n", stribeck_last_error(law));
        exit(1);
    }
}

int main(void) {
    static double velocity[SAMPLES], acceleration[SAMPLES], force[SAMPLES];
    const double speed = @speed@, dt = @every@; /* m/s, s */
    stribeck_instance *law = NULL;
    uint32_t in[2], out;
    const double *given[2] = {velocity, acceleration};
    double *results[1] = {force};
    check(stribeck_create("@model@", &law), law);
@values@    for (int i = 0; i < SAMPLES; i++) {
        double u = (i % @period@) / @quarter@.0;
        velocity[i] = speed * (u <= 1 ? u : u <= 3 ? 2 - u : u - 4);
        acceleration[i] = i % @period@ / @quarter@ % 3 == 0 ? speed / (@quarter@ * dt) : -speed / (@quarter@ * dt);
    }
@places@    stribeck_samples inputs = {in, given, @inputs@};
    stribeck_results forces = {&out, results, 1};
    check(stribeck_run(law, dt, SAMPLES, 0, &inputs, &forces), law);
    for (int i = 0; i < SAMPLES; i++) printf("%.17g,%.17g,%.17g\n", i * dt, velocity[i], force[i]);
    stribeck_free(law);
    return 0;
}
