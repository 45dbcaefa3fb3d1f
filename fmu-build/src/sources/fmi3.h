/* Types of FMI 3.0, and what depends on them. */

#if !defined(FMI3_OVERRIDE_FUNCTION_PREFIX) && defined(FMI3_FUNCTION_PREFIX)
#define FUNCTION_PREFIX FMI3_FUNCTION_PREFIX
#elif defined(FMI3_ACTUAL_FUNCTION_PREFIX)
#define FUNCTION_PREFIX FMI3_ACTUAL_FUNCTION_PREFIX
#endif

typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef const char *fmi3String;
typedef uint8_t fmi3Byte;
typedef const fmi3Byte *fmi3Binary;
typedef bool fmi3Clock;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef int fmi3DependencyKind;
typedef int fmi3IntervalQualifier;
typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String, fmi3String);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment, fmi3Float64, fmi3Boolean, fmi3Boolean,
                                               fmi3Boolean, fmi3Boolean, fmi3Boolean *, fmi3Float64 *);
typedef void (*fmi3LockPreemptionCallback)(void);
typedef void (*fmi3UnlockPreemptionCallback)(void);

#define FMI(name) fmi3##name
#define FMI_VERSION 3u
#define FMI_PREFIX "fmi3"
#define FMI_GUID "instantiationToken"
#define FMI_GUID_NAME "instantiationToken"
#define FMI_STATE "FMUState"

/* Nothing is logged without being asked for. */
#define ALWAYS_HEARS {0, 0, 0, 0, 0}

struct importer {
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
};

static int has_logger(const struct importer *importer) {
    return importer->log != NULL;
}

static void send(const struct importer *importer, const char *name, fmi3Status status, const char *category,
                 const char *text) {
    (void)name;
    importer->log(importer->environment, status, category, text);
}
