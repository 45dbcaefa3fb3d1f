/* Value references, computed by the rule that src/reference.rs states, apart from its code. */

#ifndef REFERENCE_H
#define REFERENCE_H

#include <stdint.h>

/* The value reference of the variable of that name: its fingerprint, FNV-1a of 32 bits without the highest. */
static inline uint32_t reference_of(const char *name) {
    uint32_t hash = 0x811c9dc5;
    for (; *name != 0; name++) {
        hash = (hash ^ (unsigned char)*name) * 0x01000193;
    }
    return hash & 0x7fffffff;
}

#endif
