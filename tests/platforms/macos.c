/* Functions that the library for macOS calls and Linux lacks, so that its code runs on Linux, in one thread. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void macos_memset_pattern16(void *to, const void *pattern, size_t size);
void macos_at_exit_of_thread(void (*destructor)(void *), void *object);
int macos_number_of_thread(void *thread, uint64_t *number);
void macos_absent(void);

void macos_memset_pattern16(void *to, const void *pattern, size_t size) {
    for (size_t at = 0; at < size; at += 16) {
        memcpy((char *)to + at, pattern, size - at < 16 ? size - at : 16);
    }
}

/* The one thread ends with the process. */
void macos_at_exit_of_thread(void (*destructor)(void *), void *object) {
    (void)destructor, (void)object;
}

int macos_number_of_thread(void *thread, uint64_t *number) {
    (void)thread;
    *number = 1;
    return 0;
}

void macos_absent(void) {
    fputs("a function of macOS was called that Linux lacks\n", stderr);
    abort();
}

/* A variable of each thread is found by calling the first word of its descriptor, whose third word is the place behind
 * the template. The one thread uses the template itself. No register but that of the result may change. */
#if defined __x86_64__
__asm__(".globl macos_variable_of_thread\n"
        "macos_variable_of_thread:\n"
        "    pushq %rdi\n"
        "    movq 16(%rdi), %rdi\n"
        "    leaq macos_thread_template(%rip), %rax\n"
        "    addq %rdi, %rax\n"
        "    popq %rdi\n"
        "    ret\n");
#else
__asm__(".globl macos_variable_of_thread\n"
        "macos_variable_of_thread:\n"
        "    stp x1, x2, [sp, #-16]!\n"
        "    ldr x1, [x0, #16]\n"
        "    adrp x2, macos_thread_template\n"
        "    add x2, x2, :lo12:macos_thread_template\n"
        "    add x0, x1, x2\n"
        "    ldp x1, x2, [sp], #16\n"
        "    ret\n");
#endif
