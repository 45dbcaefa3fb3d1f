/* The whole C interface: its promises and its refusals. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "check.h"
#include "stribeck.h"

static stribeck_instance *create(const char *name) {
    stribeck_instance *model = NULL;
    REQUIRE(stribeck_create(name, &model) == STRIBECK_OK);
    REQUIRE(model != NULL);
    return model;
}

static uint32_t reference(stribeck_instance *model, const char *variable) {
    uint32_t found = UINT32_MAX;
    CHECK(stribeck_find(model, variable, &found) == STRIBECK_OK);
    return found;
}

static double get(stribeck_instance *model, const char *variable) {
    double value = NAN;
    CHECK(stribeck_get_by_name(model, variable, &value) == STRIBECK_OK);
    return value;
}

static void set(stribeck_instance *model, const char *variable, double value) {
    CHECK(stribeck_set_by_name(model, variable, value) == STRIBECK_OK);
}

/* The complete state of a model, to compare. */
typedef struct {
    size_t size;
    unsigned char *bytes;
} state;

static state save(stribeck_instance *model) {
    state saved = {stribeck_state_size(model), NULL};
    REQUIRE(saved.size > 0);
    saved.bytes = malloc(saved.size);
    REQUIRE(saved.bytes != NULL);
    memset(saved.bytes, 0xA5, saved.size);
    CHECK(stribeck_save(model, saved.bytes, saved.size) == STRIBECK_OK);
    return saved;
}

static int is_unchanged(stribeck_instance *model, const state *before) {
    state now = save(model);
    int same = now.size == before->size && memcmp(now.bytes, before->bytes, now.size) == 0;
    free(now.bytes);
    return same;
}

/* The last error contains all of these words. */
static int says(const stribeck_instance *model, const char *one, const char *other) {
    const char *text = stribeck_last_error(model);
    return text != NULL && strstr(text, one) != NULL && strstr(text, other) != NULL;
}

/* ---------------------------------------------------------------------- library */

static void library_names_itself_and_its_models(void) {
    CHECK(stribeck_version() != NULL && strlen(stribeck_version()) >= strlen("0.0.0"));
    size_t count = stribeck_model_count();
    CHECK(count > 0);
    CHECK(stribeck_model_name(count) == NULL);
    CHECK(stribeck_model_name(SIZE_MAX) == NULL);
    for (size_t i = 0; i < count; i++) {
        REQUIRE(stribeck_model_name(i) != NULL);
        CHECK(strlen(stribeck_model_name(i)) > 0);
        for (size_t j = 0; j < i; j++) {
            CHECK(strcmp(stribeck_model_name(i), stribeck_model_name(j)) != 0);
        }
    }
}

static void every_status_has_its_own_text(void) {
    for (int status = STRIBECK_OK; status <= STRIBECK_OUT_OF_MEMORY; status++) {
        REQUIRE(stribeck_status_text(status) != NULL);
        CHECK(strlen(stribeck_status_text(status)) > 0);
        for (int other = STRIBECK_OK; other < status; other++) {
            CHECK(strcmp(stribeck_status_text(status), stribeck_status_text(other)) != 0);
        }
    }
    /* A number that is not a status gets a text as well. */
    const char *unknown = stribeck_status_text(STRIBECK_OUT_OF_MEMORY + 1);
    REQUIRE(unknown != NULL);
    CHECK(strcmp(unknown, stribeck_status_text(STRIBECK_OUT_OF_MEMORY)) != 0);
    CHECK(strcmp(unknown, stribeck_status_text(-1)) == 0);
    CHECK(strcmp(unknown, stribeck_status_text(INT32_MAX)) == 0);
    CHECK(strcmp(unknown, stribeck_status_text(INT32_MIN)) == 0);
}

static void unknown_models_are_refused(void) {
    stribeck_instance *model = create("LuGre");
    stribeck_instance *const live = model;
    CHECK(stribeck_create("NoSuchLaw", &model) == STRIBECK_UNKNOWN_MODEL);
    CHECK(model == NULL);
    model = live;
    CHECK(stribeck_create("", &model) == STRIBECK_UNKNOWN_MODEL);
    CHECK(model == NULL);
    /* Names are exact. */
    CHECK(stribeck_create("lugre", &model) == STRIBECK_UNKNOWN_MODEL);
    CHECK(stribeck_create("LuGre ", &model) == STRIBECK_UNKNOWN_MODEL);
    /* Not UTF-8. */
    CHECK(stribeck_create("\xFF\xFE", &model) == STRIBECK_UNKNOWN_MODEL);
    model = live;
    CHECK(stribeck_create(NULL, &model) == STRIBECK_NULL);
    CHECK(model == NULL);
    CHECK(stribeck_create("LuGre", NULL) == STRIBECK_NULL);
    CHECK(stribeck_create(NULL, NULL) == STRIBECK_NULL);
    stribeck_free(live);
}

/* ---------------------------------------------------------------------- NULL */

static void null_handles_are_answered(void) {
    uint32_t found = 7;
    double value = 7.0;
    unsigned char buffer[8] = {7};
    stribeck_variable described = {0};
    CHECK(stribeck_reset(NULL) == STRIBECK_NULL);
    CHECK(stribeck_variable_count(NULL) == 0);
    CHECK(stribeck_reference(NULL, 0, &found) == STRIBECK_NULL);
    CHECK(stribeck_find(NULL, "velocity", &found) == STRIBECK_NULL);
    CHECK(stribeck_describe(NULL, 0, &described) == STRIBECK_NULL);
    CHECK(stribeck_set(NULL, 0, 0.0) == STRIBECK_NULL);
    CHECK(stribeck_get(NULL, 0, &value) == STRIBECK_NULL);
    CHECK(stribeck_set_by_name(NULL, "velocity", 0.0) == STRIBECK_NULL);
    CHECK(stribeck_get_by_name(NULL, "velocity", &value) == STRIBECK_NULL);
    CHECK(stribeck_step(NULL, 1e-3) == STRIBECK_NULL);
    CHECK(stribeck_output(NULL) == STRIBECK_NULL);
    CHECK(isnan(stribeck_time(NULL)));
    CHECK(stribeck_derivative(NULL, 0, 0, &value) == STRIBECK_NULL);
    CHECK(stribeck_state_size(NULL) == 0);
    CHECK(stribeck_save(NULL, buffer, sizeof buffer) == STRIBECK_NULL);
    CHECK(stribeck_restore(NULL, buffer, sizeof buffer) == STRIBECK_NULL);
    CHECK(stribeck_last_error(NULL) != NULL);
    stribeck_free(NULL);
    /* Results are written on success only. */
    CHECK(found == 7 && value == 7.0 && buffer[0] == 7 && described.name == NULL);
}

static void null_pointers_are_answered(void) {
    stribeck_instance *model = create("LuGre");
    state before = save(model);
    uint32_t found = 7;
    double value = 7.0;
    CHECK(stribeck_find(model, NULL, &found) == STRIBECK_NULL);
    CHECK(says(model, "variable", "NULL"));
    CHECK(stribeck_find(model, "velocity", NULL) == STRIBECK_NULL);
    CHECK(says(model, "reference", "NULL"));
    CHECK(stribeck_reference(model, 0, NULL) == STRIBECK_NULL);
    CHECK(stribeck_find(model, NULL, NULL) == STRIBECK_NULL);
    CHECK(stribeck_describe(model, reference(model, "velocity"), NULL) == STRIBECK_NULL);
    CHECK(stribeck_get(model, reference(model, "velocity"), NULL) == STRIBECK_NULL);
    CHECK(says(model, "value", "NULL"));
    CHECK(stribeck_set_by_name(model, NULL, 0.0) == STRIBECK_NULL);
    CHECK(stribeck_get_by_name(model, NULL, &value) == STRIBECK_NULL);
    CHECK(stribeck_get_by_name(model, "velocity", NULL) == STRIBECK_NULL);
    CHECK(stribeck_derivative(model, reference(model, "friction_force"), reference(model, "velocity"), NULL) ==
          STRIBECK_NULL);
    CHECK(stribeck_save(model, NULL, before.size) == STRIBECK_NULL);
    CHECK(stribeck_restore(model, NULL, before.size) == STRIBECK_NULL);
    CHECK(says(model, "buffer", "NULL"));
    CHECK(found == 7 && value == 7.0);
    CHECK(is_unchanged(model, &before));
    free(before.bytes);
    stribeck_free(model);
}

/* ---------------------------------------------------------------------- tables */

static void describes_itself(stribeck_instance *model, uint32_t at) {
    stribeck_variable variable;
    memset(&variable, 0, sizeof variable);
    REQUIRE(stribeck_describe(model, at, &variable) == STRIBECK_OK);
    REQUIRE(variable.name != NULL && variable.unit != NULL && variable.help != NULL);
    CHECK(strlen(variable.name) > 0);
    CHECK(strlen(variable.help) > 0);
    CHECK((strlen(variable.unit) > 0) == (variable.kind == STRIBECK_REAL));
    CHECK(variable.role >= STRIBECK_INPUT && variable.role <= STRIBECK_OUTPUT);
    CHECK(variable.kind >= STRIBECK_REAL && variable.kind <= STRIBECK_ENUMERATION);
    CHECK(variable.min <= variable.start && variable.start <= variable.max);
    CHECK(reference(model, variable.name) == at);
    double by_reference = NAN;
    CHECK(stribeck_get(model, at, &by_reference) == STRIBECK_OK);
    CHECK(by_reference == get(model, variable.name));
    CHECK(variable.role == STRIBECK_OUTPUT || by_reference == variable.start);
}

/* A variable admits what its description says; a refused value leaves everything as it was. */
static void keeps_its_bounds(stribeck_instance *model, uint32_t at) {
    stribeck_variable variable;
    memset(&variable, 0, sizeof variable);
    REQUIRE(stribeck_describe(model, at, &variable) == STRIBECK_OK);
    state before = save(model);
    if (variable.role == STRIBECK_OUTPUT) {
        CHECK(stribeck_set(model, at, variable.start) == STRIBECK_NOT_SETTABLE);
        CHECK(says(model, variable.name, "cannot be set"));
    } else {
        CHECK(stribeck_set(model, at, NAN) == STRIBECK_REFUSED_VALUE);
        CHECK(says(model, variable.name, "NaN"));
        CHECK(stribeck_set(model, at, INFINITY) == STRIBECK_REFUSED_VALUE);
        CHECK(stribeck_set(model, at, -INFINITY) == STRIBECK_REFUSED_VALUE);
        CHECK(stribeck_set_by_name(model, variable.name, NAN) == STRIBECK_REFUSED_VALUE);
        if (variable.min > -DBL_MAX) {
            CHECK(stribeck_set(model, at, variable.min - 1.0) == STRIBECK_REFUSED_VALUE);
            CHECK(says(model, variable.name, "must be"));
        }
        if (variable.max < DBL_MAX) {
            CHECK(stribeck_set(model, at, variable.max + 1.0) == STRIBECK_REFUSED_VALUE);
        }
        if (variable.kind != STRIBECK_REAL) {
            CHECK(stribeck_set(model, at, variable.start + 0.5) == STRIBECK_REFUSED_VALUE);
        }
    }
    CHECK(is_unchanged(model, &before));
    if (variable.role != STRIBECK_OUTPUT) {
        CHECK(stribeck_set(model, at, variable.max) == STRIBECK_OK);
        double value = NAN;
        state after = save(model);
        CHECK(!(variable.max != variable.start) || memcmp(after.bytes, before.bytes, after.size) != 0);
        free(after.bytes);
        CHECK(stribeck_set(model, at, variable.start) == STRIBECK_OK);
        CHECK(stribeck_get(model, at, &value) == STRIBECK_OK);
        CHECK(value == variable.start);
    }
    free(before.bytes);
}

static void unknown_variables_are_refused(stribeck_instance *model) {
    uint32_t count = stribeck_variable_count(model);
    uint32_t last = 0, past = 7;
    CHECK(stribeck_reference(model, count - 1, &last) == STRIBECK_OK);
    CHECK(stribeck_reference(model, count, &past) == STRIBECK_UNKNOWN_VARIABLE && past == 7);
    state before = save(model);
    const uint32_t outside[] = {0, count, UINT32_MAX};
    for (size_t i = 0; i < sizeof outside / sizeof outside[0]; i++) {
        stribeck_variable described = {0};
        double value = 7.0;
        CHECK(stribeck_set(model, outside[i], 0.0) == STRIBECK_UNKNOWN_VARIABLE);
        CHECK(stribeck_get(model, outside[i], &value) == STRIBECK_UNKNOWN_VARIABLE);
        CHECK(stribeck_describe(model, outside[i], &described) == STRIBECK_UNKNOWN_VARIABLE);
        CHECK(stribeck_derivative(model, outside[i], last, &value) == STRIBECK_UNKNOWN_VARIABLE);
        CHECK(stribeck_derivative(model, last, outside[i], &value) == STRIBECK_UNKNOWN_VARIABLE);
        CHECK(value == 7.0 && described.name == NULL);
    }
    uint32_t found = 7;
    double value = 7.0;
    CHECK(stribeck_find(model, "no_such_variable", &found) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(says(model, "no_such_variable", "no variable"));
    CHECK(stribeck_find(model, "", &found) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(stribeck_find(model, "\xFF", &found) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(stribeck_get_by_name(model, "no_such_variable", &value) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(stribeck_set_by_name(model, "no_such_variable", 0.0) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(found == 7 && value == 7.0);
    CHECK(is_unchanged(model, &before));
    free(before.bytes);
}

static void every_model_keeps_its_table(void) {
    for (size_t i = 0; i < stribeck_model_count(); i++) {
        stribeck_instance *model = create(stribeck_model_name(i));
        REQUIRE(stribeck_variable_count(model) > 0);
        for (uint32_t index = 0; index < stribeck_variable_count(model); index++) {
            uint32_t at = 0;
            REQUIRE(stribeck_reference(model, index, &at) == STRIBECK_OK);
            describes_itself(model, at);
            keeps_its_bounds(model, at);
        }
        unknown_variables_are_refused(model);
        stribeck_free(model);
    }
}

/* The enums of the header and the library agree. */
static void constants_of_the_header_are_the_references_of_the_library(void) {
    stribeck_instance *lugre = create("LuGre");
    CHECK(reference(lugre, "velocity") == STRIBECK_LUGRE_VELOCITY);
    CHECK(reference(lugre, "sigma_0") == STRIBECK_LUGRE_SIGMA_0);
    CHECK(reference(lugre, "friction_force") == STRIBECK_LUGRE_FRICTION_FORCE);
    CHECK(reference(lugre, "sticking") == STRIBECK_LUGRE_STICKING);
    stribeck_free(lugre);
    stribeck_instance *rig = create("BeltRig");
    CHECK(reference(rig, "friction_force") == STRIBECK_BELT_RIG_FRICTION_FORCE);
    CHECK(reference(rig, "external_force") == STRIBECK_BELT_RIG_EXTERNAL_FORCE);
    stribeck_free(rig);
}

/* ---------------------------------------------------------------------- steps */

static void bad_steps_are_refused(stribeck_instance *model) {
    state before = save(model);
    const double bad[] = {0.0, -0.0, -1e-3, NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        CHECK(stribeck_step(model, bad[i]) == STRIBECK_REFUSED_VALUE);
        CHECK(says(model, "dt", "must be"));
    }
    CHECK(is_unchanged(model, &before));
    free(before.bytes);
}

static void every_model_steps_and_resets(void) {
    for (size_t i = 0; i < stribeck_model_count(); i++) {
        stribeck_instance *model = create(stribeck_model_name(i));
        state fresh = save(model);
        CHECK(stribeck_time(model) == 0.0);
        bad_steps_are_refused(model);
        CHECK(stribeck_step(model, 0.25) == STRIBECK_OK);
        CHECK(stribeck_step(model, 0.5) == STRIBECK_OK);
        CHECK(stribeck_time(model) == 0.75);
        CHECK(!is_unchanged(model, &fresh));
        bad_steps_are_refused(model);
        CHECK(stribeck_reset(model) == STRIBECK_OK);
        CHECK(stribeck_time(model) == 0.0);
        CHECK(is_unchanged(model, &fresh));
        free(fresh.bytes);
        stribeck_free(model);
    }
}

/* Parameters that do not fit together are refused by the step, one by one they may pass through such a state. */
static void parameters_must_fit_together(void) {
    stribeck_instance *model = create("LuGre");
    set(model, "velocity", 0.01);
    set(model, "mu_k", 0.5);
    state before = save(model);
    CHECK(stribeck_step(model, 1e-3) == STRIBECK_REFUSED_VALUE);
    CHECK(says(model, "mu_s = 0.15", "mu_k = 0.5"));
    CHECK(stribeck_output(model) == STRIBECK_REFUSED_VALUE);
    CHECK(is_unchanged(model, &before));
    set(model, "mu_s", 0.6);
    CHECK(stribeck_output(model) == STRIBECK_OK);
    CHECK(stribeck_step(model, 1e-3) == STRIBECK_OK);
    free(before.bytes);
    stribeck_free(model);
}

/* A result that no double can hold is refused, and the model continues afterwards. */
static void overflow_is_refused(void) {
    stribeck_instance *model = create("LuGre");
    set(model, "viscous_coefficient", 1e300);
    set(model, "velocity", 1e300);
    double value = 7.0;
    CHECK(stribeck_output(model) == STRIBECK_NOT_FINITE);
    CHECK(stribeck_get_by_name(model, "friction_force", &value) == STRIBECK_NOT_FINITE);
    CHECK(stribeck_step(model, 1e-3) == STRIBECK_NOT_FINITE);
    CHECK(value == 7.0);
    CHECK(stribeck_time(model) == 0.0);
    set(model, "velocity", 0.0);
    CHECK(stribeck_step(model, 1e-3) == STRIBECK_OK);
    CHECK(get(model, "friction_force") == 0.0);
    stribeck_free(model);
}

/* Steady sliding at the Stribeck velocity: f_C + (f_s - f_C) / e + sigma_2 v. */
static void steady_sliding_is_the_stribeck_curve(void) {
    stribeck_instance *model = create("LuGre");
    set(model, "velocity", -0.001);
    CHECK(stribeck_step(model, 1.0) == STRIBECK_OK);
    CHECK(fabs(get(model, "friction_force") + 0.981 + 0.4905 * exp(-1.0) + 0.1 * 0.001) < 1e-12);
    CHECK(get(model, "sticking") == 0.0);
    stribeck_free(model);
}

/* Results follow a set at once, without a step. */
static void outputs_follow_inputs(void) {
    stribeck_instance *model = create("CoulombStiction");
    set(model, "external_force", -1.2);
    CHECK(get(model, "friction_force") == -1.2);
    CHECK(get(model, "sticking") == 1.0);
    set(model, "external_force", 9.0);
    CHECK(fabs(get(model, "friction_force") - 1.4715) < 1e-12);
    set(model, "velocity", 1e-6);
    CHECK(stribeck_output(model) == STRIBECK_OK);
    CHECK(fabs(get(model, "friction_force") - 0.981) < 1e-12);
    CHECK(stribeck_time(model) == 0.0);
    stribeck_free(model);
}

/* Against a central difference, at points left and right of the peak. */
static void derivative_is_that_of_the_force(void) {
    stribeck_instance *model = create("BrownMcPhee");
    uint32_t force = reference(model, "friction_force");
    uint32_t velocity = reference(model, "velocity");
    const double at[] = {-3e-3, -1e-3, 0.0, 2e-4, 0.5};
    for (size_t i = 0; i < sizeof at / sizeof at[0]; i++) {
        const double d = 1e-8;
        set(model, "velocity", at[i] + d);
        double above = get(model, "friction_force");
        set(model, "velocity", at[i] - d);
        double below = get(model, "friction_force");
        set(model, "velocity", at[i]);
        double exact = NAN;
        CHECK(stribeck_derivative(model, force, velocity, &exact) == STRIBECK_OK);
        double difference = (above - below) / (2.0 * d);
        CHECK(fabs(exact - difference) <= 1e-6 * fabs(exact) + 1e-7);
    }
    /* At rest: (4 f_C + 16/9 (f_s - f_C)) / v_0. */
    double slope = NAN;
    set(model, "velocity", 0.0);
    CHECK(stribeck_derivative(model, force, velocity, &slope) == STRIBECK_OK);
    CHECK(fabs(slope - (4.0 * 0.981 + 16.0 / 9.0 * 0.4905) / 0.001) < 1e-9);
    /* Only results can be differentiated, and only with respect to variables that can be set. */
    slope = 7.0;
    CHECK(stribeck_derivative(model, velocity, force, &slope) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(stribeck_derivative(model, velocity, velocity, &slope) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(stribeck_derivative(model, force, force, &slope) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(slope == 7.0);
    stribeck_free(model);
}

/* ---------------------------------------------------------------------- saved states */

/* Moves the first input of a model, if it has one, back and forth about its start value. */
static void excite(stribeck_instance *model, int i) {
    stribeck_variable variable;
    memset(&variable, 0, sizeof variable);
    variable.role = STRIBECK_OUTPUT;
    uint32_t at = 0;
    for (uint32_t index = 0; variable.role != STRIBECK_INPUT && index < stribeck_variable_count(model); index++) {
        REQUIRE(stribeck_reference(model, index, &at) == STRIBECK_OK);
        REQUIRE(stribeck_describe(model, at, &variable) == STRIBECK_OK);
    }
    if (variable.role == STRIBECK_INPUT) {
        CHECK(stribeck_set(model, at, variable.start + 2e-3 * sin(0.1 * i)) == STRIBECK_OK);
    }
    CHECK(stribeck_step(model, 1e-3) == STRIBECK_OK);
}

static void every_model_goes_back_to_the_same_bits(void) {
    for (size_t i = 0; i < stribeck_model_count(); i++) {
        stribeck_instance *model = create(stribeck_model_name(i));
        stribeck_instance *twin = create(stribeck_model_name(i));
        for (int step = 0; step < 100; step++) {
            excite(model, step);
        }
        state middle = save(model);
        for (int step = 100; step < 200; step++) {
            excite(model, step);
        }
        state end = save(model);
        CHECK(memcmp(middle.bytes, end.bytes, end.size) != 0);
        /* The same model, and a fresh one. */
        stribeck_instance *const both[] = {model, twin};
        for (size_t k = 0; k < 2; k++) {
            CHECK(stribeck_restore(both[k], middle.bytes, middle.size) == STRIBECK_OK);
            CHECK(is_unchanged(both[k], &middle));
            for (int step = 100; step < 200; step++) {
                excite(both[k], step);
            }
            CHECK(is_unchanged(both[k], &end));
        }
        free(middle.bytes);
        free(end.bytes);
        stribeck_free(model);
        stribeck_free(twin);
    }
}

static void damaged_states_are_refused(void) {
    stribeck_instance *model = create("LuGre");
    excite(model, 3);
    state good = save(model);
    excite(model, 4);
    state before = save(model);
    unsigned char *bytes = malloc(good.size + 1);
    REQUIRE(bytes != NULL);

    /* Every byte counts. */
    for (size_t i = 0; i < good.size; i++) {
        memcpy(bytes, good.bytes, good.size);
        bytes[i] = (unsigned char)(bytes[i] ^ 0x10);
        CHECK(stribeck_restore(model, bytes, good.size) == STRIBECK_BAD_BUFFER);
    }
    /* So does every length but the right one. */
    for (size_t size = 0; size < good.size; size++) {
        CHECK(stribeck_restore(model, good.bytes, size) == STRIBECK_BAD_BUFFER);
    }
    memcpy(bytes, good.bytes, good.size);
    bytes[good.size] = 0;
    CHECK(stribeck_restore(model, bytes, good.size + 1) == STRIBECK_BAD_BUFFER);
    /* Garbage of the right size. */
    const unsigned char fillings[] = {0x00, 0x5A, 0xFF};
    for (size_t i = 0; i < sizeof fillings; i++) {
        memset(bytes, fillings[i], good.size);
        CHECK(stribeck_restore(model, bytes, good.size) == STRIBECK_BAD_BUFFER);
        CHECK(strlen(stribeck_last_error(model)) > 0);
    }
    CHECK(is_unchanged(model, &before));
    CHECK(stribeck_restore(model, good.bytes, good.size) == STRIBECK_OK);
    CHECK(is_unchanged(model, &good));
    free(bytes);
    free(before.bytes);
    free(good.bytes);
    stribeck_free(model);
}

/* The bytes of one model are refused by every other. */
static void states_of_other_models_are_refused(void) {
    for (size_t i = 0; i < stribeck_model_count(); i++) {
        stribeck_instance *one = create(stribeck_model_name(i));
        state foreign = save(one);
        for (size_t j = 0; j < stribeck_model_count(); j++) {
            stribeck_instance *other = create(stribeck_model_name(j));
            stribeck_status status = stribeck_restore(other, foreign.bytes, foreign.size);
            CHECK(status == (i == j ? STRIBECK_OK : STRIBECK_BAD_BUFFER));
            stribeck_free(other);
        }
        free(foreign.bytes);
        stribeck_free(one);
    }
}

static void small_buffers_are_refused(void) {
    stribeck_instance *model = create("Dahl");
    size_t size = stribeck_state_size(model);
    unsigned char *bytes = malloc(size + 16);
    REQUIRE(bytes != NULL);
    memset(bytes, 0xA5, size + 16);
    CHECK(stribeck_save(model, bytes, size - 1) == STRIBECK_BAD_BUFFER);
    CHECK(stribeck_save(model, bytes, 0) == STRIBECK_BAD_BUFFER);
    for (size_t i = 0; i < size + 16; i++) {
        CHECK(bytes[i] == 0xA5);
    }
    /* A larger one is used as far as needed. */
    CHECK(stribeck_save(model, bytes, size + 16) == STRIBECK_OK);
    for (size_t i = size; i < size + 16; i++) {
        CHECK(bytes[i] == 0xA5);
    }
    CHECK(stribeck_restore(model, bytes, size) == STRIBECK_OK);
    free(bytes);
    stribeck_free(model);
}

/* ---------------------------------------------------------------------- two at once */

/* Two models that take turns behave as each does alone, including their error texts. */
static void models_do_not_disturb_each_other(void) {
    stribeck_instance *alone = create("LuGre");
    for (int step = 0; step < 50; step++) {
        excite(alone, step);
    }
    state expected = save(alone);

    stribeck_instance *one = create("LuGre");
    stribeck_instance *other = create("LuGre");
    set(other, "mu_s", 0.3);
    for (int step = 0; step < 50; step++) {
        excite(one, step);
        excite(other, 7 * step);
    }
    CHECK(is_unchanged(one, &expected));
    CHECK(!is_unchanged(other, &expected));

    CHECK(stribeck_set_by_name(one, "mu_k", -1.0) == STRIBECK_REFUSED_VALUE);
    CHECK(stribeck_set_by_name(other, "sigma_0", -2.0) == STRIBECK_REFUSED_VALUE);
    CHECK(says(one, "mu_k", "-1"));
    CHECK(says(other, "sigma_0", "-2"));

    /* One is freed, the other stays. */
    stribeck_free(one);
    CHECK(stribeck_step(other, 1e-3) == STRIBECK_OK);
    stribeck_free(other);
    stribeck_free(alone);
    free(expected.bytes);
}

/* A preset sets its own values and gives all other parameters their start values. An unknown name changes nothing. */
static void presets_set_the_parameters(void) {
    stribeck_instance *model = create("DamperTemperature");
    set(model, "thermal.enabled", 0.0);
    set(model, "temperature_ambient", 300.0);
    state before = save(model);
    CHECK(stribeck_apply_preset(model, "cooling") == STRIBECK_UNKNOWN_MODEL);
    CHECK(says(model, "DamperTemperature", "'cooling'"));
    CHECK(stribeck_apply_preset(model, NULL) == STRIBECK_NULL);
    CHECK(stribeck_apply_preset(NULL, "heating") == STRIBECK_NULL);
    CHECK(is_unchanged(model, &before));
    CHECK(stribeck_preset_count(model) == 1 && strcmp(stribeck_preset_name(model, 0), "heating") == 0);
    CHECK(stribeck_apply_preset(model, "heating") == STRIBECK_OK);
    CHECK(get(model, "power") == 50.0 && get(model, "thermal.enabled") == 1.0);
    CHECK(get(model, "temperature_ambient") == 300.0);
    free(before.bytes);
    stribeck_free(model);
}

/* ---------------------------------------------------------------- many samples */

enum { SAMPLES = 50, RUNS = 3 };
#define DT 1e-3

/* A velocity that reverses, under a load that changes. */
static void motion(double *velocity, double *load, double size) {
    for (int i = 0; i < SAMPLES; i++) {
        velocity[i] = size * sin(0.3 * i);
        load[i] = 10.0 + 0.1 * i;
    }
}

/* The forces of LuGre along a motion, call by call with held inputs. */
static void by_single_calls(double sigma_0, const double *velocity, const double *load, double *force) {
    stribeck_instance *model = create("LuGre");
    set(model, "sigma_0", sigma_0);
    for (int i = 0; i < SAMPLES; i++) {
        set(model, "velocity", velocity[i]);
        set(model, "normal_force", load[i]);
        force[i] = get(model, "friction_force");
        if (i + 1 < SAMPLES) {
            CHECK(stribeck_step(model, DT) == STRIBECK_OK);
        }
    }
    stribeck_free(model);
}

static void a_run_has_the_bits_of_single_calls(void) {
    double velocity[SAMPLES], load[SAMPLES], expected[SAMPLES], force[SAMPLES];
    motion(velocity, load, 0.01);
    by_single_calls(1e5, velocity, load, expected);
    stribeck_instance *model = create("LuGre");
    const uint32_t given[] = {STRIBECK_LUGRE_VELOCITY, STRIBECK_LUGRE_NORMAL_FORCE};
    const uint32_t wanted[] = {STRIBECK_LUGRE_FRICTION_FORCE};
    const double *values[] = {velocity, load};
    double *found[] = {force};
    const stribeck_samples inputs = {given, values, 2};
    const stribeck_results results = {wanted, found, 1};
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &inputs, &results) == STRIBECK_OK);
    CHECK(memcmp(force, expected, sizeof force) == 0);
    CHECK(fabs(stribeck_time(model) - (SAMPLES - 1) * DT) < 1e-12);
    stribeck_free(model);
}

/* A law whose force does not depend on the steps before: time and energy do. */
static void a_run_leads_its_instance(void) {
    double velocity[SAMPLES], load[SAMPLES], force[SAMPLES];
    motion(velocity, load, 0.01);
    stribeck_instance *led = create("CoulombViscous"), *stepped = create("CoulombViscous");
    const uint32_t given[] = {STRIBECK_COULOMB_VISCOUS_VELOCITY, STRIBECK_COULOMB_VISCOUS_NORMAL_FORCE};
    const uint32_t wanted[] = {STRIBECK_COULOMB_VISCOUS_FRICTION_FORCE};
    const double *values[] = {velocity, load};
    double *found[] = {force};
    const stribeck_samples inputs = {given, values, 2};
    const stribeck_results results = {wanted, found, 1};
    CHECK(stribeck_run(led, DT, SAMPLES, 1, &inputs, &results) == STRIBECK_OK);
    for (int i = 0; i < SAMPLES; i++) {
        set(stepped, "velocity", velocity[i]);
        set(stepped, "normal_force", load[i]);
        CHECK(force[i] == get(stepped, "friction_force"));
        CHECK(i + 1 == SAMPLES || stribeck_step(stepped, DT) == STRIBECK_OK);
    }
    CHECK(stribeck_time(led) == stribeck_time(stepped));
    CHECK(get(led, "dissipated_energy") == get(stepped, "dissipated_energy"));
    CHECK(get(led, "dissipated_energy") > 0.0);
    stribeck_free(led);
    stribeck_free(stepped);
}

/* Dahl's law along a velocity that grows linearly: f_C (1 - exp(-sigma_0 x / f_C)), x = a t^2 / 2. With held inputs the
 * force would be off by some percent. */
static void inputs_may_move_along_lines(void) {
    stribeck_instance *model = create("Dahl");
    set(model, "normal_force", 10.0);
    const double level = 10.0 * get(model, "mu_k"), stiffness = get(model, "sigma_0");
    const double slope = 2.0 * level / stiffness / (DT * DT * SAMPLES * SAMPLES);
    double velocity[SAMPLES], force[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        velocity[i] = slope * DT * i;
    }
    const uint32_t given[] = {STRIBECK_DAHL_VELOCITY}, wanted[] = {STRIBECK_DAHL_FRICTION_FORCE};
    const double *values[] = {velocity};
    double *found[] = {force};
    const stribeck_samples inputs = {given, values, 1};
    const stribeck_results results = {wanted, found, 1};
    CHECK(stribeck_run(model, DT, SAMPLES, 0, &inputs, &results) == STRIBECK_OK);
    for (int i = 0; i < SAMPLES; i++) {
        const double displacement = 0.5 * slope * DT * DT * i * i;
        CHECK(fabs(force[i] - level * (1.0 - exp(-stiffness * displacement / level))) < 1e-8 * level);
    }
    stribeck_free(model);
}

static void many_runs_are_single_runs(void) {
    double velocity[RUNS * SAMPLES], load[RUNS * SAMPLES], force[RUNS * SAMPLES], expected[SAMPLES];
    const double stiffness[RUNS] = {1e4, 1e5, 3e5};
    stribeck_instance *model = create("LuGre");
    set(model, "mu_s", 0.15);
    state before = save(model);
    const uint32_t chosen[] = {STRIBECK_LUGRE_SIGMA_0};
    const uint32_t given[] = {STRIBECK_LUGRE_VELOCITY, STRIBECK_LUGRE_NORMAL_FORCE};
    const uint32_t wanted[] = {STRIBECK_LUGRE_FRICTION_FORCE};
    const double *choices[] = {stiffness}, *values[] = {velocity, load};
    double *found[] = {force};
    const stribeck_samples parameters = {chosen, choices, 1}, inputs = {given, values, 2};
    const stribeck_results results = {wanted, found, 1};
    for (int run = 0; run < RUNS; run++) {
        motion(velocity + run * SAMPLES, load + run * SAMPLES, 0.01 * (run + 1));
    }
    CHECK(stribeck_run_many(model, DT, SAMPLES, RUNS, 1, &parameters, &inputs, &results) == STRIBECK_OK);
    CHECK(is_unchanged(model, &before));
    for (int run = 0; run < RUNS; run++) {
        by_single_calls(stiffness[run], velocity + run * SAMPLES, load + run * SAMPLES, expected);
        CHECK(memcmp(force + run * SAMPLES, expected, sizeof expected) == 0);
    }
    CHECK(stribeck_run_many(model, DT, SAMPLES, 0, 1, NULL, NULL, NULL) == STRIBECK_OK);
    CHECK(is_unchanged(model, &before));
    free(before.bytes);
    stribeck_free(model);
}

static void bad_runs_change_nothing(void) {
    double velocity[SAMPLES], load[SAMPLES], force[SAMPLES];
    motion(velocity, load, 0.01);
    stribeck_instance *model = create("LuGre");
    const uint32_t given[] = {STRIBECK_LUGRE_VELOCITY, STRIBECK_LUGRE_NORMAL_FORCE}, wrong[] = {7};
    const uint32_t wanted[] = {STRIBECK_LUGRE_FRICTION_FORCE};
    const double *values[] = {velocity, load}, *none[] = {NULL, NULL};
    double *found[] = {force}, *nowhere[] = {NULL};
    const stribeck_samples inputs = {given, values, 2}, without = {given, none, 2}, unknown = {wrong, values, 1};
    const stribeck_samples null = {NULL, NULL, 2}, output = {wanted, values, 1};
    const stribeck_results results = {wanted, found, 1}, lost = {wanted, nowhere, 1}, strange = {wrong, found, 1};
    state before = save(model);
    CHECK(stribeck_run(NULL, DT, SAMPLES, 1, &inputs, &results) == STRIBECK_NULL);
    CHECK(stribeck_run(model, 0.0, SAMPLES, 1, &inputs, &results) == STRIBECK_REFUSED_VALUE);
    CHECK(stribeck_run(model, NAN, SAMPLES, 1, &inputs, &results) == STRIBECK_REFUSED_VALUE);
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &without, &results) == STRIBECK_NULL);
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &null, &results) == STRIBECK_NULL);
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &inputs, &lost) == STRIBECK_NULL);
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &unknown, &results) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &inputs, &strange) == STRIBECK_UNKNOWN_VARIABLE);
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &output, &results) == STRIBECK_NOT_SETTABLE);
    CHECK(stribeck_run_many(model, DT, SIZE_MAX / 8, 9, 1, NULL, &inputs, &results) == STRIBECK_REFUSED_VALUE);
    load[40] = -1.0;
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &inputs, &results) == STRIBECK_REFUSED_VALUE);
    CHECK(says(model, "sample 40", "normal_force = -1"));
    load[40] = NAN;
    CHECK(stribeck_run_many(model, DT, SAMPLES, 1, 0, NULL, &inputs, &results) == STRIBECK_REFUSED_VALUE);
    load[40] = 1.0;
    set(model, "viscous_coefficient", 1e300);
    free(before.bytes);
    before = save(model);
    velocity[30] = 1e300;
    CHECK(stribeck_run(model, DT, SAMPLES, 1, &inputs, &results) == STRIBECK_NOT_FINITE);
    CHECK(says(model, "sample 30", "finite"));
    CHECK(is_unchanged(model, &before));
    CHECK(stribeck_run(model, DT, 0, 1, &without, &lost) == STRIBECK_OK);
    CHECK(is_unchanged(model, &before));
    free(before.bytes);
    stribeck_free(model);
}

int main(void) {
    library_names_itself_and_its_models();
    every_status_has_its_own_text();
    unknown_models_are_refused();
    null_handles_are_answered();
    null_pointers_are_answered();
    every_model_keeps_its_table();
    constants_of_the_header_are_the_references_of_the_library();
    every_model_steps_and_resets();
    parameters_must_fit_together();
    overflow_is_refused();
    steady_sliding_is_the_stribeck_curve();
    outputs_follow_inputs();
    derivative_is_that_of_the_force();
    every_model_goes_back_to_the_same_bits();
    damaged_states_are_refused();
    states_of_other_models_are_refused();
    small_buffers_are_refused();
    models_do_not_disturb_each_other();
    presets_set_the_parameters();
    a_run_has_the_bits_of_single_calls();
    a_run_leads_its_instance();
    inputs_may_move_along_lines();
    many_runs_are_single_runs();
    bad_runs_change_nothing();
    return report();
}
