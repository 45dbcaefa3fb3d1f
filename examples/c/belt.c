/* A block on a moving belt: stick-slip with Stribeck's C interface, without any FMU.
 *
 *     cc -Iinclude examples/c/belt.c -Ltarget/release -lstribeck -lm -o belt
 *     LD_LIBRARY_PATH=target/release ./belt
 *     LD_LIBRARY_PATH=target/release ./belt Wojewoda step=1e-5 mu_s=0.14 rig.belt_velocity=0.2
 *
 * The program couples two models: BeltRig, a spring-held block on a belt, and a friction law named on the command line
 * (default: LuGre); laws in the plane and in space slide along x. Variables of the law, and with `rig.` those of the
 * rig, follow as name=value. The program also shows how to list the models, find variables by name, save and restore a
 * state, and handle a rejected value.
 */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stribeck.h"

/* Communication step, unless given on the command line. The coupling is explicit, so the step must resolve the
 * steepest slope of the law. With this one, and default parameters, the period of most laws is correct to within 0.1 %,
 * but FrictionalLag and Wojewoda need 1e-5 s. */
static const double STEP = 1e-4;     /* s */
static const double DURATION = 40.0; /* s */
static const double GRAVITY = 9.81;  /* m/s2 */

/* ---------------------------------------------------------------------- errors */

/* Every function that can fail returns a status; the model keeps the error message. An example may stop at the first
 * error; a library would pass the status on. */
static void check(stribeck_status status, const stribeck_instance *model, const char *what) {
    if (status == STRIBECK_OK) {
        return;
    }
    const char *reason = model != NULL ? stribeck_last_error(model) : stribeck_status_text(status);
    fprintf(stderr, "%s: %s\n", what, reason);
    exit(EXIT_FAILURE);
}

static stribeck_instance *create(const char *name) {
    stribeck_instance *model = NULL;
    check(stribeck_create(name, &model), NULL, name);
    return model;
}

/* ---------------------------------------------------------------------- variables */

/* A variable is addressed by its column. Look the name up once and use the number in the loop: setting a value is then
 * a bound check and a store. */
static uint32_t column(stribeck_instance *model, const char *variable) {
    uint32_t found = 0;
    check(stribeck_find(model, variable, &found), model, variable);
    return found;
}

/* Not every law has every variable. */
static bool has(stribeck_instance *model, const char *variable) {
    uint32_t found = 0;
    return stribeck_find(model, variable, &found) == STRIBECK_OK;
}

/* Laws in the plane and in space have vectors, of which the component along the belt is used. */
static uint32_t column_along(stribeck_instance *model, const char *line, const char *x) {
    return column(model, has(model, line) ? line : x);
}

static double get(stribeck_instance *model, uint32_t at) {
    double value = 0.0;
    check(stribeck_get(model, at, &value), model, "get");
    return value;
}

static void set(stribeck_instance *model, uint32_t at, double value) {
    check(stribeck_set(model, at, value), model, "set");
}

static double get_named(stribeck_instance *model, const char *variable) {
    double value = 0.0;
    check(stribeck_get_by_name(model, variable, &value), model, variable);
    return value;
}

static void set_named(stribeck_instance *model, const char *variable, double value) {
    check(stribeck_set_by_name(model, variable, value), model, variable);
}

/* ---------------------------------------------------------------------- the coupled system */

typedef struct {
    stribeck_instance *rig;
    stribeck_instance *friction;
    double step;
    bool wants_external_force; /* laws with true stiction balance the forces on the block */
    bool wants_acceleration;   /* laws with one curve for speeding up and one for slowing down */

    /* Columns of the friction law, */
    uint32_t velocity, external_force, acceleration, friction_force, dissipated_energy;
    /* and of the rig. */
    uint32_t rig_friction_force, position, block_velocity, rig_velocity, rig_external_force, belt_velocity, mass;
} belt;

static void find_columns(belt *system) {
    system->velocity = column_along(system->friction, "velocity", "velocity_x");
    system->friction_force = column_along(system->friction, "friction_force", "friction_force_x");
    system->dissipated_energy = column(system->friction, "dissipated_energy");
    system->wants_external_force = has(system->friction, "external_force");
    if (system->wants_external_force) {
        system->external_force = column(system->friction, "external_force");
    }
    system->wants_acceleration = has(system->friction, "acceleration");
    if (system->wants_acceleration) {
        system->acceleration = column(system->friction, "acceleration");
    }
    system->rig_friction_force = column(system->rig, "friction_force");
    system->position = column(system->rig, "position");
    system->block_velocity = column(system->rig, "block_velocity");
    system->rig_velocity = column(system->rig, "velocity");
    system->rig_external_force = column(system->rig, "external_force");
    system->belt_velocity = column(system->rig, "belt_velocity");
    system->mass = column(system->rig, "mass");
}

/* Sets the name=value arguments, either of the rig or of the law; the step belongs to neither. */
static void configure(belt *system, bool of_rig, int count, char **settings) {
    for (int i = 0; i < count; i++) {
        char name[64];
        const char *equals = strchr(settings[i], '=');
        char *end = NULL;
        double value = equals != NULL ? strtod(equals + 1, &end) : 0.0;
        if (end == NULL || end == equals + 1 || *end != '\0' || (size_t)(equals - settings[i]) >= sizeof name) {
            fprintf(stderr, "'%s' is not of the form name=value\n", settings[i]);
            exit(EXIT_FAILURE);
        }
        snprintf(name, sizeof name, "%.*s", (int)(equals - settings[i]), settings[i]);
        bool is_of_rig = strncmp(name, "rig.", 4) == 0;
        if (strcmp(name, "step") == 0) {
            system->step = value;
        } else if (is_of_rig == of_rig) {
            set_named(of_rig ? system->rig : system->friction, of_rig ? name + 4 : name, value);
        }
    }
}

static bool is_given(const char *name, int count, char **settings) {
    for (int i = 0; i < count; i++) {
        if (strncmp(settings[i], name, strlen(name)) == 0 && settings[i][strlen(name)] == '=') {
            return true;
        }
    }
    return false;
}

static belt assemble(const char *law, int count, char **settings) {
    belt system = {.rig = create("BeltRig"), .friction = create(law), .step = STEP};
    find_columns(&system);
    configure(&system, true, count, settings);
    /* The block starts at rest on the belt. */
    if (!is_given("rig.block_velocity", count, settings)) {
        set(system.rig, system.block_velocity, get(system.rig, system.belt_velocity));
    }
    if (!(system.step > 0.0 && system.step <= DURATION / 2.0)) {
        fprintf(stderr, "step = %g: must be > 0 and <= %g s\n", system.step, DURATION / 2.0);
        exit(EXIT_FAILURE);
    }
    double mass = get(system.rig, system.mass);
    /* A law that knows the mass can bring the block to rest and hold it; otherwise the block chatters. */
    if (has(system.friction, "mass")) {
        set_named(system.friction, "mass", mass);
    }
    /* The block presses on the belt with its weight. */
    set_named(system.friction, "normal_force", mass * GRAVITY);
    configure(&system, false, count, settings);
    return system;
}

/* Friction first, with the motion at the start of the step; then the rig, with the new force. The laws call this order
 * a sequential exchange. */
static void step(const belt *system) {
    set(system->friction, system->velocity, get(system->rig, system->rig_velocity));
    if (system->wants_external_force) {
        set(system->friction, system->external_force, get(system->rig, system->rig_external_force));
    }
    /* The acceleration depends on the force being computed, so only that of the last force is available. */
    if (system->wants_acceleration) {
        double resultant = get(system->rig, system->rig_external_force) - get(system->rig, system->rig_friction_force);
        set(system->friction, system->acceleration, resultant / get(system->rig, system->mass));
    }
    check(stribeck_step(system->friction, system->step), system->friction, "friction step");
    set(system->rig, system->rig_friction_force, get(system->friction, system->friction_force));
    check(stribeck_step(system->rig, system->step), system->rig, "rig step");
}

static void dismantle(belt *system) {
    stribeck_free(system->friction);
    stribeck_free(system->rig);
}

/* ---------------------------------------------------------------------- the report */

/* Kinetic energy of the block and energy of the spring. */
static double mechanical_energy(const belt *system) {
    double x = get(system->rig, system->position);
    double v = get(system->rig, system->block_velocity);
    return 0.5 * get_named(system->rig, "mass") * v * v + 0.5 * get_named(system->rig, "stiffness") * x * x;
}

/* Runs to `end` and prints each time at which the block reverses. Returns the work of the belt on the block. */
static double run(const belt *system, double end) {
    double work = 0.0;
    long steps = (long)((end - stribeck_time(system->rig)) / system->step + 0.5);
    for (long i = 0; i < steps; i++) {
        double before = get(system->rig, system->block_velocity);
        step(system);
        double after = get(system->rig, system->block_velocity);
        /* The belt feels +friction_force, so it pulls the block with -friction_force. */
        work -= get(system->rig, system->rig_friction_force) * get(system->rig, system->belt_velocity) * system->step;
        if (before > 0.0 && after <= 0.0) {
            /* Between two steps the velocity is practically linear. */
            double t = stribeck_time(system->rig) + system->step * after / (before - after);
            printf("  maximum at t = %8.4f s   position = %.5f m\n", t, get(system->rig, system->position));
        }
    }
    return work;
}

static void list_models(void) {
    printf("Stribeck %s has %zu models:", stribeck_version(), stribeck_model_count());
    for (size_t i = 0; i < stribeck_model_count(); i++) {
        printf(" %s", stribeck_model_name(i));
    }
    printf("\n");
}

/* A value outside its bounds is rejected and nothing changes: the model remains usable. */
static void show_refusal(stribeck_instance *friction) {
    double before = get_named(friction, "mu_k");
    if (stribeck_set_by_name(friction, "mu_k", -0.1) == STRIBECK_OK || get_named(friction, "mu_k") != before) {
        fprintf(stderr, "a negative coefficient was accepted\n");
        exit(EXIT_FAILURE);
    }
    stribeck_set_by_name(friction, "mu_k", -0.1);
    printf("\nrefused, as it should be: %s\n", stribeck_last_error(friction));
}

/* The complete state of a model, as bytes: for a step that is tried and undone, or for a file. */
typedef struct {
    size_t size;
    void *bytes;
} snapshot;

static snapshot save(stribeck_instance *model) {
    snapshot state = {.size = stribeck_state_size(model)};
    state.bytes = malloc(state.size);
    if (state.bytes == NULL) {
        fprintf(stderr, "out of memory\n");
        exit(EXIT_FAILURE);
    }
    check(stribeck_save(model, state.bytes, state.size), model, "save");
    return state;
}

static void restore(stribeck_instance *model, const snapshot *state) {
    check(stribeck_restore(model, state->bytes, state->size), model, "restore");
}

int main(int argc, char **argv) {
    const char *law = argc > 1 ? argv[1] : "LuGre";
    list_models();

    belt system = assemble(law, argc > 2 ? argc - 2 : 0, argv + 2);
    double start = mechanical_energy(&system);
    printf("\n%s on the belt, %g s in steps of %g s:\n", law, DURATION, system.step);
    double work = run(&system, DURATION / 2.0);

    /* Halfway, save both models. */
    snapshot rig = save(system.rig);
    snapshot friction = save(system.friction);

    work += run(&system, DURATION);
    double dissipated = get(system.friction, system.dissipated_energy);
    double end = mechanical_energy(&system);
    printf("\nwork of the belt     %9.6f J\n", work);
    printf("dissipated           %9.6f J\n", dissipated);
    printf("gained by the block  %9.6f J\n", end - start);
    /* The force is held over a step while the rig moves: the balance closes to first order in the step. */
    printf("not accounted for    %9.2g J\n", work - dissipated - (end - start));

    /* Back to half-time, and the same second half again: bit-identical, not just nearly the same. */
    double position = get(system.rig, system.position);
    restore(system.rig, &rig);
    restore(system.friction, &friction);
    printf("\nback at t = %g s, again:\n", stribeck_time(system.rig));
    run(&system, DURATION);
    double again = get(system.rig, system.position);
    bool identical = memcmp(&position, &again, sizeof position) == 0;
    printf("final position %.17g m, %s\n", again, identical ? "identical to the last bit" : "DIFFERENT");

    show_refusal(system.friction);

    free(rig.bytes);
    free(friction.bytes);
    dismantle(&system);
    return identical ? EXIT_SUCCESS : EXIT_FAILURE;
}
