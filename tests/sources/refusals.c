/* What lugre.h promises of refusals: the status, and that nothing changes; a preset. Prints a line if it is kept. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "lugre.h"

static lugre_memory memory;

#define EXPECT(call, status)                                                                                           \
    do {                                                                                                               \
        lugre_status found = call;                                                                                     \
        if (found != status)                                                                                           \
            return printf("%s: %d\n", #call, (int)found), __LINE__;                                                    \
    } while (0)

int main(void) {
    unsigned char before[LUGRE_STATE], after[LUGRE_STATE];
    double force = 0.0, slope = 0.0;
    lugre *law = NULL;
    EXPECT(lugre_create(NULL, &law), LUGRE_NULL);
    EXPECT(lugre_create(&memory, NULL), LUGRE_NULL);
    EXPECT(lugre_create(&memory, &law), LUGRE_OK);
    EXPECT(lugre_set(law, LUGRE_VELOCITY, 0.001), LUGRE_OK);
    EXPECT(lugre_step(law, 1.0e-3), LUGRE_OK);
    EXPECT(lugre_get(law, LUGRE_FRICTION_FORCE, &force), LUGRE_OK);
    /* A bristle that has hardly moved: sigma_0 v dt f_n, and sigma_1 v f_n. */
    if (!(force > 0.0 && force < 1.0e6))
        return __LINE__;
    EXPECT(lugre_derivative(law, LUGRE_FRICTION_FORCE, LUGRE_VELOCITY, &slope), LUGRE_OK);
    if (!(slope > 0.0))
        return __LINE__;
    EXPECT(lugre_save(law, before, sizeof before), LUGRE_OK);
    EXPECT(lugre_set(law, LUGRE_MU_K, -1.0), LUGRE_REFUSED_VALUE);
    EXPECT(lugre_set(law, LUGRE_VELOCITY, (double)NAN), LUGRE_REFUSED_VALUE);
    EXPECT(lugre_set(law, LUGRE_FRICTION_FORCE, 1.0), LUGRE_NOT_SETTABLE);
    EXPECT(lugre_set(law, 7, 1.0), LUGRE_UNKNOWN_VARIABLE);
    EXPECT(lugre_set(NULL, LUGRE_VELOCITY, 1.0), LUGRE_NULL);
    EXPECT(lugre_get(law, LUGRE_FRICTION_FORCE, NULL), LUGRE_NULL);
    EXPECT(lugre_step(law, 0.0), LUGRE_REFUSED_VALUE);
    EXPECT(lugre_step(law, (double)INFINITY), LUGRE_REFUSED_VALUE);
    EXPECT(lugre_apply_preset(law, 99), LUGRE_UNKNOWN_PRESET);
    EXPECT(lugre_derivative(law, LUGRE_VELOCITY, LUGRE_VELOCITY, &slope), LUGRE_UNKNOWN_VARIABLE);
    EXPECT(lugre_save(law, after, 3), LUGRE_BAD_BUFFER);
    EXPECT(lugre_restore(law, before, 3), LUGRE_BAD_BUFFER);
    before[100] ^= 1;
    EXPECT(lugre_restore(law, before, sizeof before), LUGRE_BAD_BUFFER);
    before[100] ^= 1;
    EXPECT(lugre_save(law, after, sizeof after), LUGRE_OK);
    if (memcmp(before, after, sizeof before) != 0)
        return __LINE__;
    /* The second preset has values of its own. */
    EXPECT(lugre_apply_preset(law, 1), LUGRE_OK);
    EXPECT(lugre_get(law, LUGRE_MU_S, &force), LUGRE_OK);
    if (force != 1.5)
        return __LINE__;
    EXPECT(lugre_reset(law), LUGRE_OK);
    EXPECT(lugre_output(law), LUGRE_OK);
    if (lugre_time(law) != 0.0 || !isnan(lugre_time(NULL)))
        return __LINE__;
    printf("all refusals as documented\n");
    return 0;
}
