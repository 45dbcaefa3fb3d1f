/* Drives the C sources of a law as its input says, and prints bits: a line for each step.
 *
 * Compiled with -DLAW=lugre and -DHEADER="lugre.h" in quotes. Reads the numbers of inputs, outputs and steps, the
 * references of the inputs and outputs, then for each step the bits of its length and of its inputs, in hexadecimal.
 * The line of a step that is refused is the status.
 */

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include HEADER

#define PASTE(a, b) a##b
#define JOIN(a, b) PASTE(a, b)
#define CALL(name) JOIN(LAW, name)

enum { MOST = 256 };

static CALL(_memory) memory, other;

static double number(void) {
    uint32_t high, low;
    uint64_t bits;
    double value;
    /* In halves, for libraries that read no longer numbers. */
    if (scanf("%8" SCNx32 "%8" SCNx32, &high, &low) != 2)
        exit(3);
    bits = (uint64_t)high << 32 | low;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void references(uint32_t *list, unsigned count) {
    unsigned at;
    for (at = 0; at < count; at++)
        if (scanf("%" SCNu32, &list[at]) != 1)
            exit(3);
}

/* Moves the state into another instance, as bytes. */
static LAW *moved(LAW *law, int from_other) {
    static unsigned char *bytes;
    LAW *to;
    size_t size = JOIN(STATE_OF_, LAW);
    if (!bytes)
        bytes = malloc(size);
    if (!bytes || CALL(_save)(law, bytes, size) || CALL(_create)(from_other ? &memory : &other, &to))
        exit(4);
    return CALL(_restore)(to, bytes, size) ? NULL : to;
}

int main(void) {
    static uint32_t inputs[MOST], outputs[MOST];
    unsigned n_inputs, n_outputs, steps, step, at;
    LAW *law;
    if (scanf("%u %u %u", &n_inputs, &n_outputs, &steps) != 3 || n_inputs > MOST || n_outputs > MOST)
        return 3;
    references(inputs, n_inputs);
    references(outputs, n_outputs);
    if (CALL(_create)(&memory, &law))
        return 5;
    for (step = 0; step < steps; step++) {
        double dt = number(), value;
        uint64_t bits;
        int status = 0, refused;
        for (at = 0; at < n_inputs; at++)
            if ((refused = (int)CALL(_set)(law, inputs[at], number())) != 0)
                status = refused;
        if (!status)
            status = (int)CALL(_step)(law, dt);
        if (status)
            printf("%d", status);
        for (at = 0; at < n_outputs && !status; at++) {
            if (CALL(_get)(law, outputs[at], &value))
                return 8;
            memcpy(&bits, &value, sizeof bits);
            printf("%08" PRIx32 "%08" PRIx32 " ", (uint32_t)(bits >> 32), (uint32_t)bits);
        }
        printf("\n");
        if (step % 16 == 15 && !(law = moved(law, step / 16 % 2)))
            return 9;
    }
    return 0;
}
