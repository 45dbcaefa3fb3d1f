/* CHECK(condition) counts, and prints where it failed. A test program ends with `return report();`. */
#ifndef STRIBECK_TEST_CHECK_H
#define STRIBECK_TEST_CHECK_H

#include <stdio.h>
#include <stdlib.h>

static int checks_passed;
static int checks_failed;

#define CHECK(condition) check_that((condition) ? 1 : 0, __FILE__, __LINE__, #condition)

/* As CHECK, and gives up if it fails: what follows would make no sense. */
#define REQUIRE(condition)                                                                                             \
    do {                                                                                                               \
        if (!CHECK(condition)) {                                                                                       \
            exit(EXIT_FAILURE);                                                                                        \
        }                                                                                                              \
    } while (0)

static int check_that(int holds, const char *file, int line, const char *condition) {
    if (holds) {
        checks_passed++;
    } else {
        checks_failed++;
        fprintf(stderr, "%s:%d: failed: %s\n", file, line, condition);
    }
    return holds;
}

static int report(void) {
    printf("%d checks passed, %d failed\n", checks_passed, checks_failed);
    return checks_failed == 0 && checks_passed > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif
