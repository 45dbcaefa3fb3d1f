/* law.h: TITLE, as C for controllers. ORIGIN; do not edit.
 *
 * Memory: An instance lives in LAW_MEMORY bytes that the caller provides, static or not, as a `law_memory`. It is one
 * until the memory is used for something else; nothing has to be freed. It must not be moved or copied: law_save and
 * law_restore copy a state. An instance uses no other memory, so different ones may be used at the same time, each by
 * one thread, task or interrupt at a time.
 *
 * Errors: Any status other than LAW_OK is a refusal, which changes nothing. No result is infinite or NaN. After
 * LAW_INTERNAL, which is an error in these sources, the instance must be created again.
 *
ONLY
 * Sign: As in the documentation of the model. SI units throughout; Booleans are 0 or 1, choices numbers from 1.
 *
 * Compiler: C99, and its library: memcpy, memmove, memset, and sqrt, floor and the like. double is computed as IEC
 * 60559 says, and a * b + c is rounded twice: -ffp-contract=off for gcc and clang, never -ffast-math. law_create finds
 * out. Then every result has the bits of the library of stribeck.
 *
 * Example, without status checks:
 *
 *     static law_memory memory;
 *     law *instance;
 *     double value;
 *     law_create(&memory, &instance);
 *     law_set(instance, FIRST_INPUT, 0.001);
 *     law_step(instance, 1.0e-3);
 *     law_get(instance, FIRST_OUTPUT, &value);
 */

#ifndef LAW_H
#define LAW_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Version of the library that these sources come from. */
#define LAW_VERSION "VERSION_TEXT"

/** Bytes of an instance. */
#define LAW_MEMORY MEMORY_BYTESu

STACK
/** Bytes of a state, as law_save writes them. */
#define LAW_STATE STATE_BYTESu

/** Result of a call. */
typedef enum law_status {
    /** Success. */
    LAW_OK = 0,
    /** A required pointer is NULL. */
    LAW_NULL = 1,
    /** The preset does not exist. */
    LAW_UNKNOWN_PRESET = 2,
    /** The variable does not exist, or the requested derivative is not that of a result with respect to something that
     * can be set. */
    LAW_UNKNOWN_VARIABLE = 3,
    /** The value is outside the bounds of its variable, or the parameters do not fit together. */
    LAW_REFUSED_VALUE = 4,
    /** The variable is computed and cannot be set. */
    LAW_NOT_SETTABLE = 5,
    /** The result would not be finite. */
    LAW_NOT_FINITE = 6,
    /** The buffer is too small, or does not contain a state of this model. */
    LAW_BAD_BUFFER = 7,
    /** Internal error; please report it. */
    LAW_INTERNAL = 8,
    /** This target does not compute as these sources need it: see Compiler above. */
    LAW_OTHER_ARITHMETIC = 10
} law_status;

/** An instance. */
typedef struct law law;

/** Memory of an instance, aligned. */
typedef union law_memory {
    /** Aligns the bytes. */
    double real;
    /** Aligns the bytes. */
    void *pointer;
    /** The bytes. */
    unsigned char bytes[LAW_MEMORY];
} law_memory;

/** Makes an instance at its start values and at time 0, in this memory, and writes its handle to `*instance`. */
law_status law_create(law_memory *memory, law **instance);

/** Resets an instance to its start values and to time 0. */
law_status law_reset(law *instance);

/** Sets a variable. Everything except computed results can be set at any time; outputs follow at once. */
law_status law_set(law *instance, uint32_t variable, double value);

/** Reads a variable; results are computed first if anything has been set since. */
law_status law_get(law *instance, uint32_t variable, double *value);

/** Advances the instance by `dt` > 0 seconds with held inputs and computes the results. */
law_status law_step(law *instance, double dt);

/** Computes the results now, and checks that the parameters fit together. */
law_status law_output(law *instance);

/** Time since creation or reset, in seconds; NaN for NULL. */
double law_time(law *instance);

/** Applies the preset with this number, from 0, in the order of the documentation of the model. */
law_status law_apply_preset(law *instance, uint32_t preset);

/** Partial derivative of a result with respect to an input, parameter or state, at the present values. */
law_status law_derivative(law *instance, uint32_t output, uint32_t input, double *value);

/** Writes the complete state as LAW_STATE bytes, the same as those of stribeck_save on every platform. */
law_status law_save(law *instance, void *buffer, size_t size);

/** Restores a state of this model. Foreign or damaged bytes are refused. */
law_status law_restore(law *instance, const void *buffer, size_t size);

VARIABLES
#ifdef __cplusplus
}
#endif

#endif /* LAW_H */
