/* A master in plain C: a block on a moving belt, held by a spring, with the friction of an FMI 2.0 slave.
 *
 *     cc -Iinclude examples/c/fmu_master.c -Ltarget/release -lstribeck -lm -o fmu_master
 *     LD_LIBRARY_PATH=target/release ./fmu_master
 *
 * The FMI functions are linked directly, so there is no archive to unpack and no XML to read: the header has the value
 * references and the GUID. With an .fmu file the calls are the same, on functions found with dlsym or GetProcAddress.
 *
 * Coulomb friction jumps at rest. A master that only reads the force gets one that alternates between two levels while
 * the block should stick. The model CoulombStiction does better if it knows the mass that it has to hold. The program
 * runs both ways and counts.
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "stribeck.h"

static const double MASS = 1.0;          /* kg */
static const double STIFFNESS = 2.0;     /* N/m */
static const double BELT_VELOCITY = 0.1; /* m/s */
static const double NORMAL_FORCE = 9.81; /* N */
static const double MU_S = 0.15;         /* static coefficient of friction */
static const double STEP = 1e-3;         /* s */
static const double DURATION = 40.0;     /* s */

/* The slave reports through this function. The message is a format, as in printf. */
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

static void check(fmi2Status status, const char *call) {
    if (status != fmi2OK) {
        fprintf(stderr, "%s returned status %d\n", call, (int)status);
        exit(EXIT_FAILURE);
    }
}

/* A slave, initialised and ready to step. `mass` is the mass that it has to hold; 0 if it does not know it. */
static fmi2Component start_slave(double mass) {
    /* The slave copies the structure; it may go away when fmi2Instantiate returns. Memory functions are not needed. */
    fmi2CallbackFunctions callbacks = {.logger = logger};
    fmi2Component slave = fmi2Instantiate("friction", fmi2CoSimulation, STRIBECK_COULOMB_STICTION_GUID, NULL,
                                          &callbacks, fmi2False, fmi2True);
    if (slave == NULL) {
        fprintf(stderr, "fmi2Instantiate failed: header and library do not match\n");
        exit(EXIT_FAILURE);
    }
    const fmi2ValueReference start[] = {STRIBECK_COULOMB_STICTION_NORMAL_FORCE, STRIBECK_COULOMB_STICTION_MU_S,
                                        STRIBECK_COULOMB_STICTION_MASS};
    const fmi2Real values[] = {NORMAL_FORCE, MU_S, mass};
    check(fmi2SetReal(slave, start, 3, values), "fmi2SetReal");
    check(fmi2SetupExperiment(slave, fmi2False, 0.0, 0.0, fmi2True, DURATION), "fmi2SetupExperiment");
    check(fmi2EnterInitializationMode(slave), "fmi2EnterInitializationMode");
    check(fmi2ExitInitializationMode(slave), "fmi2ExitInitializationMode");
    return slave;
}

/* Results of a run. */
typedef struct {
    double first_slip;    /* time at which the block first leaves the belt */
    double furthest;      /* largest position */
    int slips;            /* how often it leaves the belt */
    int chatter;          /* how often the friction force changes its sign */
    double fastest_stuck; /* largest relative speed of a block that the slave calls stuck */
} result;

static result run(double mass) {
    const fmi2ValueReference inputs[] = {STRIBECK_COULOMB_STICTION_VELOCITY, STRIBECK_COULOMB_STICTION_EXTERNAL_FORCE};
    const fmi2ValueReference force_reference[] = {STRIBECK_COULOMB_STICTION_FRICTION_FORCE};
    const fmi2ValueReference sticking_reference[] = {STRIBECK_COULOMB_STICTION_STICKING};

    fmi2Component slave = start_slave(mass);
    result seen = {.first_slip = NAN};
    double x = 0.0;
    double v = BELT_VELOCITY;
    double last_force = 0.0;
    fmi2Boolean stuck_before = fmi2False;

    long steps = (long)(DURATION / STEP + 0.5);
    for (long i = 0; i < steps; i++) {
        double t = (double)i * STEP;
        double spring = -STIFFNESS * x;

        /* Sequential exchange: inputs, step of the slave, outputs, and then our own step with the new force. */
        const fmi2Real values[] = {v - BELT_VELOCITY, spring};
        fmi2Real force[1];
        fmi2Boolean sticking[1];
        check(fmi2SetReal(slave, inputs, 2, values), "fmi2SetReal");
        check(fmi2DoStep(slave, t, STEP, fmi2True), "fmi2DoStep");
        check(fmi2GetReal(slave, force_reference, 1, force), "fmi2GetReal");
        check(fmi2GetBoolean(slave, sticking_reference, 1, sticking), "fmi2GetBoolean");

        /* The master's side: the block, one step of the semi-implicit Euler method. */
        v += STEP * (spring - force[0]) / MASS;
        x += STEP * v;

        if (stuck_before && !sticking[0]) {
            seen.first_slip = seen.slips == 0 ? t : seen.first_slip;
            seen.slips++;
        }
        seen.chatter += force[0] * last_force < 0.0;
        seen.furthest = fmax(seen.furthest, x);
        if (sticking[0]) {
            seen.fastest_stuck = fmax(seen.fastest_stuck, fabs(v - BELT_VELOCITY));
        }
        stuck_before = sticking[0];
        last_force = force[0];
    }
    check(fmi2Terminate(slave), "fmi2Terminate");
    fmi2FreeInstance(slave);
    return seen;
}

int main(void) {
    result told = run(MASS);
    result untold = run(0.0);

    /* The belt carries the block until the spring pulls as hard as static friction can: k v_b t = mu_s f_n. */
    double first_slip = MU_S * NORMAL_FORCE / (STIFFNESS * BELT_VELOCITY);

    printf("Coulomb friction with stiction, %g s in steps of %g s\n\n", DURATION, STEP);
    printf("the slave knows the mass\n");
    printf("  slips %d times, first at %.4f s (theory: %.4f s)\n", told.slips, told.first_slip, first_slip);
    printf("  largest position %.5f m\n", told.furthest);
    printf("  largest relative speed while stuck %.1e m/s\n", told.fastest_stuck);
    printf("  changes of sign of the friction force: %d\n\n", told.chatter);
    printf("the slave does not know the mass\n");
    printf("  changes of sign of the friction force: %d\n", untold.chatter);
    return EXIT_SUCCESS;
}
