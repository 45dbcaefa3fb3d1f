/* @title@: steps of @step@ s. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "stribeck.h"

/* Results are passed on from one part to an input of another one. */
typedef struct {
    int from;
    uint32_t out;
    int to;
    uint32_t in;
} wire;

#define PARTS @parts@
#define WIRES @wires@
#define RESULTS @results@

static stribeck_instance *part[PARTS];
static const int is_host[PARTS] = {@hosts@}, order[PARTS] = {@order@};
static wire wires[WIRES];

static void check(stribeck_status status, const stribeck_instance *model) {
    if (status != STRIBECK_OK) {
        fprintf(stderr, "%s\n", stribeck_last_error(model));
        exit(1);
    }
}

@course@static uint32_t find(int at, const char *name) {
    uint32_t found = 0;
    check(stribeck_find(part[at], name, &found), part[at]);
    return found;
}

static double get(int at, uint32_t variable) {
    double value = 0.0;
    check(stribeck_get(part[at], variable, &value), part[at]);
    return value;
}

/* At the start values go round until nothing changes. */
static void settle(void) {
    drive(0);
    for (int round = 0, changed = 1; round <= WIRES && changed; round++) {
        changed = 0;
        for (int i = 0; i < WIRES; i++) {
            double value = get(wires[i].from, wires[i].out), now = get(wires[i].to, wires[i].in);
            if (memcmp(&value, &now, sizeof value) != 0) {
                check(stribeck_set(part[wires[i].to], wires[i].in, value), part[wires[i].to]);
                changed = 1;
            }
        }
    }
}

/* Passes values on to hosts, or to what acts on them: all are read before any is set. */
static void pass(int to_host) {
    double values[WIRES];
    for (int i = 0; i < WIRES; i++)
        if (is_host[wires[i].to] == to_host) values[i] = get(wires[i].from, wires[i].out);
    for (int i = 0; i < WIRES; i++)
        if (is_host[wires[i].to] == to_host) check(stribeck_set(part[wires[i].to], wires[i].in, values[i]), part[wires[i].to]);
}

static void advance(int hosts, double h) {
    for (int i = 0; i < PARTS; i++)
        if (is_host[order[i]] == hosts) check(stribeck_step(part[order[i]], h), part[order[i]]);
}

int main(void) {
    const double step = @step@, end = @end@; /* s */
    const int intervals = @intervals@;
    const int from[RESULTS] = {@from@};
    uint32_t result[RESULTS];
@set_up@    puts("time [s],@names@");
    settle();
    /* Times are summed up with what the last digit loses (Kahan). */
    double time = 0.0, lost = 0.0;
    for (int number = 0, made = 0;; made++) {
        double reached = time + 1e-9 * step + 4.0 * 2.220446049250313e-16 * time;
        double due = number == intervals ? end : end * ((double)number / intervals);
        if (due <= reached) {
            printf("%.17g", time);
            for (int i = 0; i < RESULTS; i++) printf(",%.17g", get(from[i], result[i]));
            puts("");
            do {
                number++;
                due = number == intervals ? end : end * ((double)number / intervals);
            } while (number <= intervals && due <= reached);
        }
        if (number > intervals) break;
        double rest = end - time, h = step >= rest * (1.0 - 1e-9) ? rest : step, length = h - lost, next = time + length;
        drive(made);
        pass(0);
        advance(0, h);
        pass(1);
        advance(1, h);
        lost = (next - time) - length;
        time = next;
    }
    for (int i = 0; i < PARTS; i++) stribeck_free(part[i]);
    return 0;
}
