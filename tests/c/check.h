/* CHECK(condition) counts, and prints where it failed. A test program ends with `return report();`. */
#ifndef STRIBECK_TEST_CHECK_H
#define STRIBECK_TEST_CHECK_H

#include <stdio.h>
#include <stdlib.h>

static int checks_passed;
static int checks_failed;

#define CHECK(condition) check_that((condition) ? 1 : 0, __FILE__, __LINE__, #condition)

/* As CHECK, but ends the program if it fails, because the rest would make no sense. */
#define REQUIRE(condition)                                                                                             \
    do {                                                                                                               \
        if (!CHECK(condition)) {                                                                                       \
            exit(EXIT_FAILURE);                                                                                        \
        }                                                                                                              \
    } while (0)

/* Threads may count at the same time, where the compiler of programs with threads is gcc or clang. */
#if defined __GNUC__
#define COUNT(counter) (void)__atomic_fetch_add(&(counter), 1, __ATOMIC_RELAXED)
#else
#define COUNT(counter) (void)(counter)++
#endif

static int check_that(int holds, const char *file, int line, const char *condition) {
    if (holds) {
        COUNT(checks_passed);
    } else {
        COUNT(checks_failed);
        fprintf(stderr, "%s:%d: failed: %s\n", file, line, condition);
    }
    return holds;
}

static int report(void) {
    printf("%d checks passed, %d failed\n", checks_passed, checks_failed);
    return checks_failed == 0 && checks_passed > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif
