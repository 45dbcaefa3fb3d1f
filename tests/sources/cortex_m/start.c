/* The beginning of a program on a Cortex-M of qemu (machines mps2-an386 and mps2-an500), whose input and output are
 * those of the host by semihosting. */

#include <stdint.h>

extern uint32_t stack_begin[];
void reset(void);

__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    void (*start)(void);
} vectors = {stack_begin, reset};

__attribute__((naked, used)) void reset(void) {
    __asm volatile("ldr r0, =0xe000ed88\n" /* CPACR: the processor's floating-point unit */
                   "ldr r1, [r0]\n"
                   "orr r1, r1, #0xf00000\n"
                   "str r1, [r0]\n"
                   "dsb\n"
                   "isb\n"
                   "ldr r0, =_start\n"
                   "bx r0\n");
}
