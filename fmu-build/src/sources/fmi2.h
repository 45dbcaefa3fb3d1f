/* Types of FMI 2.0, and what depends on them. */

#ifdef FMI2_FUNCTION_PREFIX
#define FUNCTION_PREFIX FMI2_FUNCTION_PREFIX
#endif

typedef void *fmi2Component;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef int fmi2Type;
typedef int fmi2StatusKind;

typedef struct {
    void (*logger)(void *, fmi2String, fmi2Status, fmi2String, fmi2String, ...);
    void *(*allocateMemory)(size_t, size_t);
    void (*freeMemory)(void *);
    void (*stepFinished)(void *, fmi2Status);
    void *componentEnvironment;
} fmi2CallbackFunctions;

enum { MODEL_EXCHANGE, CO_SIMULATION };
enum { LAST_SUCCESSFUL_TIME = 2, IS_TERMINATED = 3 };

#define FMI(name) fmi2##name
#define FMI_VERSION 2u
#define FMI_PREFIX "fmi2"
#define FMI_GUID "fmuGUID"
#define FMI_GUID_NAME "guid"
#define FMI_STATE "FMUstate"

/* What is logged without being asked for. */
#define ALWAYS_HEARS {1, 0, 1, 0, 1}

struct importer {
    fmi2CallbackFunctions callbacks;
};

static int has_logger(const struct importer *importer) {
    return importer->callbacks.logger != NULL;
}

static void send(const struct importer *importer, const char *name, fmi2Status status, const char *category,
                 const char *text) {
    importer->callbacks.logger(importer->callbacks.componentEnvironment, name, status, category, "%s", text);
}
