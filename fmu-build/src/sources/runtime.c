/* What the functions below need, and C does not have under these names. */

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0 || FLT_RADIX != 2 || DBL_MANT_DIG != 53
#error "double must be computed in double, as IEC 60559 says: no -ffast-math, and on x86 -msse2 -mfpmath=sse"
#endif

/* a * b + c must be rounded twice: create finds out whether it is. */
#if defined(__clang__) || !defined(__GNUC__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__OPTIMIZE__)
#pragma GCC optimize("fp-contract=off")
#endif

#if defined(__GNUC__)
#define SELDOM __attribute__((cold, noinline))
#define HELPER __attribute__((unused)) static inline
#else
#define SELDOM
#define HELPER static inline
#endif

typedef uint8_t u8;
typedef uint16_t u16;
typedef uint32_t u32;
typedef uint64_t u64;
typedef int8_t s8;
typedef int16_t s16;
typedef int32_t s32;
typedef int64_t s64;

/* Marks the instance as broken: every function returns then, and the call has the result of an internal error. */
SELDOM static void trap(struct module *m) {
    m->is_broken = 1;
}

/* Whether this can be a new end of the stack, which is at the beginning of the memory: a stack that is too small
 * becomes huge. */
HELPER int is_within_stack(struct module *m, u32 end) {
    if (end <= STACK_END)
        return 1;
    trap(m);
    return 0;
}

/* Numbers in the memory are little-endian, wherever it is. */
#if defined(_MSC_VER) || (defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
#define IS_LITTLE_ENDIAN 1
#else
#define IS_LITTLE_ENDIAN 0
#endif

/* The byte at an address of the module, which is within the memory: the module was safe Rust. */
#define BYTE(m, at, offset) ((m)->memory + ((size_t)(at) + (size_t)(offset) - MEMORY_BEGIN))

HELPER u16 read16(const u8 *p) {
    return (u16)(p[0] | p[1] << 8);
}

HELPER u32 read32(const u8 *p) {
#if IS_LITTLE_ENDIAN
    u32 value;
    memcpy(&value, p, 4);
    return value;
#else
    return (u32)p[0] | (u32)p[1] << 8 | (u32)p[2] << 16 | (u32)p[3] << 24;
#endif
}

HELPER u64 read64(const u8 *p) {
#if IS_LITTLE_ENDIAN
    u64 value;
    memcpy(&value, p, 8);
    return value;
#else
    return (u64)read32(p) | (u64)read32(p + 4) << 32;
#endif
}

HELPER double from_bits(u64 bits) {
    double value;
    memcpy(&value, &bits, 8);
    return value;
}

HELPER u64 to_bits(double value) {
    u64 bits;
    memcpy(&bits, &value, 8);
    return bits;
}

HELPER float float_from_bits(u32 bits) {
    float value;
    memcpy(&value, &bits, 4);
    return value;
}

HELPER u32 float_to_bits(float value) {
    u32 bits;
    memcpy(&bits, &value, 4);
    return bits;
}

HELPER void write16(u8 *p, u64 value) {
    p[0] = (u8)value;
    p[1] = (u8)(value >> 8);
}

HELPER void write32(u8 *p, u64 value) {
#if IS_LITTLE_ENDIAN
    u32 part = (u32)value;
    memcpy(p, &part, 4);
#else
    write16(p, value);
    write16(p + 2, value >> 16);
#endif
}

HELPER void write64(u8 *p, u64 value) {
#if IS_LITTLE_ENDIAN
    memcpy(p, &value, 8);
#else
    write32(p, value);
    write32(p + 4, value >> 32);
#endif
}

#define load8(m, at, offset) (*BYTE(m, at, offset))
#define load16(m, at, offset) read16(BYTE(m, at, offset))
#define load32(m, at, offset) read32(BYTE(m, at, offset))
#define load64(m, at, offset) read64(BYTE(m, at, offset))
#define load_double(m, at, offset) from_bits(load64(m, at, offset))
#define load_float(m, at, offset) float_from_bits(load32(m, at, offset))
#define store8(m, at, offset, value) (*BYTE(m, at, offset) = (u8)(value))
#define store16(m, at, offset, value) write16(BYTE(m, at, offset), value)
#define store32(m, at, offset, value) write32(BYTE(m, at, offset), value)
#define store64(m, at, offset, value) write64(BYTE(m, at, offset), value)
#define store_double(m, at, offset, value) store64(m, at, offset, to_bits(value))
#define store_float(m, at, offset, value) store32(m, at, offset, float_to_bits(value))

/* The address of nothing may be anywhere. */
HELPER void copy(struct module *m, u32 to, u32 from, u32 n) {
    if (n != 0)
        memmove(BYTE(m, to, 0), BYTE(m, from, 0), n);
}

HELPER void fill(struct module *m, u32 to, u32 value, u32 n) {
    if (n != 0)
        memset(BYTE(m, to, 0), (int)(value & 255), n);
}

HELPER u32 rotate32(u32 a, u32 n) {
    return a << (n & 31) | a >> ((32 - (n & 31)) & 31);
}

HELPER u64 rotate64(u64 a, u64 n) {
    return a << (n & 63) | a >> ((64 - (n & 63)) & 63);
}

HELPER u32 ones32(u32 a) {
    a -= a >> 1 & 0x55555555u;
    a = (a & 0x33333333u) + (a >> 2 & 0x33333333u);
    a = (a + (a >> 4)) & 0x0f0f0f0fu;
    return a * 0x01010101u >> 24;
}

HELPER u32 leading32(u32 a) {
    a |= a >> 1;
    a |= a >> 2;
    a |= a >> 4;
    a |= a >> 8;
    a |= a >> 16;
    return 32 - ones32(a);
}

HELPER u32 trailing32(u32 a) {
    return ones32(~a & (a - 1));
}

HELPER u32 leading64(u64 a) {
    return a >> 32 ? leading32((u32)(a >> 32)) : 32 + leading32((u32)a);
}

HELPER u32 trailing64(u64 a) {
    return (u32)a ? trailing32((u32)a) : 32 + trailing32((u32)(a >> 32));
}

HELPER u32 divisor32(struct module *m, u32 b) {
    if (b != 0)
        return b;
    trap(m);
    return 1;
}

HELPER u64 divisor64(struct module *m, u64 b) {
    if (b != 0)
        return b;
    trap(m);
    return 1;
}

HELPER u32 divide32(struct module *m, u32 a, u32 b) {
    if (b == 0 || (a == 0x80000000u && b == 0xffffffffu)) {
        trap(m);
        return 0;
    }
    return (u32)((s32)a / (s32)b);
}

HELPER u32 remain32(struct module *m, u32 a, u32 b) {
    b = (u32)divisor32(m, b);
    return b == 0xffffffffu ? 0 : (u32)((s32)a % (s32)b);
}

HELPER u64 divide64(struct module *m, u64 a, u64 b) {
    if (b == 0 || (a == UINT64_C(1) << 63 && b == UINT64_MAX)) {
        trap(m);
        return 0;
    }
    return (u64)((s64)a / (s64)b);
}

HELPER u64 remain64(struct module *m, u64 a, u64 b) {
    b = (u64)divisor64(m, b);
    return b == UINT64_MAX ? 0 : (u64)((s64)a % (s64)b);
}

/* To whole numbers: the nearest one if there is none, 0 for NaN. */
HELPER s32 to_s32(double a) {
    if (!(a > -2147483649.0))
        return a != a ? 0 : INT32_MIN;
    return a < 2147483648.0 ? (s32)a : INT32_MAX;
}

HELPER u32 to_u32(double a) {
    if (!(a > -1.0))
        return 0;
    return a < 4294967296.0 ? (u32)a : UINT32_MAX;
}

HELPER s64 to_s64(double a) {
    if (!(a >= -9223372036854775808.0))
        return a != a ? 0 : INT64_MIN;
    return a < 9223372036854775808.0 ? (s64)a : INT64_MAX;
}

HELPER u64 to_u64(double a) {
    if (!(a > -1.0))
        return 0;
    return a < 18446744073709551616.0 ? (u64)a : UINT64_MAX;
}

HELPER double least(double a, double b) {
    if (a != a || b != b)
        return a + b;
    return a == b ? from_bits(to_bits(a) | to_bits(b)) : a < b ? a : b;
}

HELPER double most(double a, double b) {
    if (a != a || b != b)
        return a + b;
    return a == b ? from_bits(to_bits(a) & to_bits(b)) : a > b ? a : b;
}

#if defined(__arm__) && !(defined(__ARM_FP) && (__ARM_FP & 8))
/* The exponent of a number, and its digits before they are multiplied by a power of two. */
static u32 exponent_of(u64 bits) {
    u32 exponent = (u32)(bits >> 52) & 0x7ff;
    return exponent ? exponent : 1;
}

static u64 digits_of(u64 bits) {
    u64 fraction = (UINT64_C(1) << 52) - 1;
    return (bits & fraction) | (bits >> 52 & 0x7ff ? fraction + 1 : 0);
}

/* The sum of finite numbers of opposite signs, of which the large one has an exponent that is greater by 33. */
static double distant_sum(u64 large, u64 small) {
    u64 exponent = exponent_of(large) - 1, part = digits_of(small), result;
    /* Eleven digits more than the result has; the last one stands for all behind it. */
    u64 digits = (digits_of(large) << 11) - (part >> 22);
    if (part << 42)
        digits = (digits - 1) | 1;
    if (!(digits >> 63)) {
        digits <<= 1;
        exponent -= 1;
    }
    result = (exponent << 52) + (digits >> 11);
    if ((digits & 0x7ff) > 0x400 || ((digits & 0x7ff) == 0x400 && (result & 1)))
        result += 1;
    return from_bits((large >> 63 << 63) | result);
}

/* Where the processor has no double, a library computes it. GCC's for ARM rounds a difference wrongly if the digits of
 * one number are shifted by 33, and those of the result by one. */
static double sum(double a, double b) {
    u64 x = to_bits(a), y = to_bits(b);
    u32 i = exponent_of(x), j = exponent_of(y);
    if ((x ^ y) >> 63 && i == j + 33 && i != 0x7ff)
        return distant_sum(x, y);
    if ((x ^ y) >> 63 && j == i + 33 && j != 0x7ff)
        return distant_sum(y, x);
    return a + b;
}

#define difference(a, b) sum(a, -(b))
#else
#define sum(a, b) ((a) + (b))
#define difference(a, b) ((a) - (b))
#endif

/* Whether this target computes as the library does: rounding twice in a * b + c, to nearest, with small numbers. */
SELDOM static int computes_alike(void) {
    volatile double a = 1.0 + 0x1p-27, c = 1.0 + 0x1p-26, least_normal = DBL_MIN, one = 1.0, half_digit = 0x1p-53;
    double product = a * a - c, small = least_normal * 0.5;
    return product == 0.0 && small > 0.0 && one + half_digit == 1.0 && one + 3.0 * half_digit == 1.0 + 0x1p-51 &&
           to_bits(one) == UINT64_C(0x3ff0000000000000);
}
