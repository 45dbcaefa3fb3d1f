/* Wrong on purpose: each argument names a mistake that a sanitizer must catch. run.py uses it to prove that the
 * sanitizers are active in the other programs. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Volatile, so that no compiler recognises the mistake and removes it. */
static volatile size_t past_the_end = 8;
static volatile int large = INT_MAX;
static char *volatile forgotten;

int main(int argc, char **argv) {
    const char *mistake = argc > 1 ? argv[1] : "";
    if (strcmp(mistake, "address") == 0) {
        char *buffer = calloc(past_the_end, 1);
        int read = buffer[past_the_end];
        free(buffer);
        printf("read %d\n", read);
    } else if (strcmp(mistake, "overflow") == 0) {
        printf("%d\n", large + 1);
    } else if (strcmp(mistake, "leak") == 0) {
        forgotten = malloc(past_the_end);
        forgotten = NULL;
        printf("forgotten %p\n", (void *)forgotten);
    } else {
        fprintf(stderr, "unknown mistake: %s\n", mistake);
        return 2;
    }
    return EXIT_SUCCESS;
}
