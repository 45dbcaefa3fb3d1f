/* FMI 2.0 for co-simulation over the functions above. Types, names and states are those of the standard; a call that is
 * refused changes nothing, and the logger hears why. Memory is allocated for an instance and for a saved state. */

#if defined _WIN32 || defined __CYGWIN__
#define EXPORTED __declspec(dllexport)
#elif defined __GNUC__
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif

#ifdef FMI2_FUNCTION_PREFIX
#define JOINED(prefix, name) prefix##name
#define JOIN(prefix, name) JOINED(prefix, name)
#define NAMED(name) JOIN(FMI2_FUNCTION_PREFIX, name)
#else
#define NAMED(name) name
#endif

typedef void *fmi2Component;
typedef void *fmi2FMUstate;
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

/* Results of the functions of the model. */
enum { OK, REFUSED_VALUE = 4 };

/* Types of variables. */
enum { REAL, INTEGER, BOOLEAN };

/* Why a call is logged: done, but it makes no sense; done, with parameters of which there is something to say; a value
 * was refused; a query has no answer; a call was refused. */
enum reason { WARNED, NOTED, DISCARDED, TRIED, FAILED, REASONS };

/* Slack for communication points and the stop time, as in the library. */
#define TIME_SLACK 1e-9
#define RELATIVE_SLACK 0x1p-23
#define STEP_SLACK 0.4

enum { TEXT = 512, TOLD = 16 };

struct component {
    struct module m;
    u32 magic;
    enum state state;
    int is_set_up;
    double start, stop;
    u64 steps;
    fmi2CallbackFunctions callbacks;
    unsigned char hears[REASONS];
    int is_waiting;
    enum reason reason;
    u32 told_count;
    u64 told[TOLD];
    char text[TEXT], *name;
};

struct saved {
    u32 magic;
    size_t size;
    u8 bytes[1];
};

#define COMPONENT 0x53545249u
#define SAVED 0x53415645u

/* A number with as few digits as it takes to read it back. */
static const char *digits(double value, char text[32]) {
    int digits;
    for (digits = 15; digits <= 17; digits++) {
        snprintf(text, 32, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    return text;
}

/* Keeps a message, in which each # is doubled: a single one introduces a variable. */
static void keep(struct component *c, enum reason reason, const char *call, const char *why) {
    size_t at = 0;
    if (!c->hears[reason] || !c->callbacks.logger)
        return;
    if (call)
        at = (size_t)snprintf(c->text, TEXT, "fmi2%s: ", call);
    for (; *why && at < TEXT - 2; why++) {
        if (*why == '#')
            c->text[at++] = '#';
        c->text[at++] = *why;
    }
    c->text[at] = 0;
    c->reason = reason;
    c->is_waiting = 1;
}

/* Passes the message to the logger: after everything else, because it may not return. */
static void tell(struct component *c) {
    static const fmi2Status statuses[REASONS] = {fmi2Warning, fmi2Warning, fmi2Discard, fmi2Discard, fmi2Error};
    static const char *const names[REASONS] = {CATEGORY_WARNING, CATEGORY_WARNING, CATEGORY_DISCARD, CATEGORY_DISCARD,
                                               CATEGORY_ERROR};
    if (!c->is_waiting)
        return;
    c->is_waiting = 0;
    c->callbacks.logger(c->callbacks.componentEnvironment, c->name, statuses[c->reason], names[c->reason], "%s",
                        c->text);
}

static fmi2Status refuse(struct component *c, enum call call, const char *why) {
    c->state = Error;
    keep(c, FAILED, calls[call].name, why);
    tell(c);
    return fmi2Error;
}

static fmi2Status discard(struct component *c, enum call call, enum reason reason, const char *why) {
    keep(c, reason, calls[call].name, why);
    tell(c);
    return fmi2Discard;
}

/* Why the model refused the last call. */
static const char *why(struct component *c) {
    return (const char *)c->m.memory + model_text(&c->m);
}

/* A call of the model that was refused. */
static fmi2Status refused(struct component *c, enum call call, u32 status) {
    if (status == REFUSED_VALUE)
        return discard(c, call, DISCARDED, why(c));
    return refuse(c, call, why(c));
}

static fmi2Status broken(struct component *c, enum call call) {
    c->state = Error;
    keep(c, FAILED, calls[call].name, "internal error, please report it");
    tell(c);
    return fmi2Fatal;
}

/* Whether a call may be made now. */
static fmi2Status admit(struct component *c, enum call call) {
    char text[64];
    if (!c || c->magic != COMPONENT)
        return fmi2Error;
    if (c->m.is_broken)
        return fmi2Fatal;
    if (calls[call].is_allowed[c->state])
        return fmi2OK;
    snprintf(text, sizeof text, "may not be called in state %s", states[c->state]);
    return refuse(c, call, text);
}

/* What every call begins with. */
#define ENTER(component, call)                                                                                         \
    struct component *c = (struct component *)component;                                                               \
    fmi2Status admitted = admit(c, call);                                                                              \
    if (admitted != fmi2OK)                                                                                            \
        return admitted;                                                                                               \
    if (setjmp(c->m.way_out))                                                                                          \
    return broken((struct component *)component, call)

#define NOT_NULL(pointer, count, name, call)                                                                           \
    if ((count) && !(pointer))                                                                                         \
    return refuse(c, call, name " is NULL")

EXPORTED fmi2String NAMED(fmi2GetTypesPlatform)(void) {
    return "default";
}

EXPORTED fmi2String NAMED(fmi2GetVersion)(void) {
    return "2.0";
}

static int is_blank(const char *text) {
    for (; text && *text; text++)
        if (*text != ' ' && (*text < '\t' || *text > '\r'))
            return 0;
    return 1;
}

/* Why no instance can be made; NULL if one can. */
static const char *no_instance(fmi2String name, fmi2Type type, fmi2String guid) {
    if (is_blank(name))
        return "fmi2Instantiate: instanceName is NULL or blank";
    if (!guid)
        return "fmi2Instantiate: fmuGUID is NULL";
    if (strcmp(guid, MODEL_GUID) != 0)
        return "fmi2Instantiate: the guid is not that of these sources: they differ from modelDescription.xml in "
               "version";
    if (type == MODEL_EXCHANGE)
        return "fmi2Instantiate: these sources are for co-simulation only";
    if (type != CO_SIMULATION)
        return "fmi2Instantiate: fmuType must be 1 (co-simulation)";
    if (!computes_alike())
        return "fmi2Instantiate: this target does not round as IEC 60559 says: compile with -ffp-contract=off, keep "
               "subnormal numbers";
    return NULL;
}

/* Makes the model of an instance, whose memory is all zero. */
static int make(struct component *c) {
    if (setjmp(c->m.way_out))
        return 0;
    return model_create(&c->m) == OK;
}

static struct component *allocated(fmi2String name, const fmi2CallbackFunctions *callbacks, fmi2Boolean is_debugged) {
    static const unsigned char always[REASONS] = {1, 0, 1, 0, 1};
    struct component *c = (struct component *)calloc(1, sizeof *c + strlen(name) + 1);
    int reason;
    if (!c)
        return NULL;
    create_module(&c->m);
    c->magic = COMPONENT;
    c->callbacks = *callbacks;
    c->stop = HUGE_VAL;
    c->name = (char *)(c + 1);
    memcpy(c->name, name, strlen(name) + 1);
    for (reason = 0; reason < REASONS; reason++)
        c->hears[reason] = always[reason] || is_debugged;
    return c;
}

EXPORTED fmi2Component NAMED(fmi2Instantiate)(fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID,
                                              fmi2String fmuResourceLocation, const fmi2CallbackFunctions *functions,
                                              fmi2Boolean visible, fmi2Boolean loggingOn) {
    const char *text;
    struct component *c = NULL;
    (void)fmuResourceLocation, (void)visible;
    if (!functions)
        return NULL;
    text = no_instance(instanceName, fmuType, fmuGUID);
    if (!text) {
        c = allocated(instanceName, functions, loggingOn);
        if (c && make(c))
            return c;
        text = "fmi2Instantiate: out of memory";
    }
    free(c);
    if (functions->logger)
        functions->logger(functions->componentEnvironment, instanceName ? instanceName : "", fmi2Error, CATEGORY_ERROR,
                          "%s", text);
    return NULL;
}

EXPORTED void NAMED(fmi2FreeInstance)(fmi2Component component) {
    struct component *c = (struct component *)component;
    if (!c || c->magic != COMPONENT)
        return;
    c->magic = 0;
    free(c);
}

static int hear(struct component *c, fmi2String category, fmi2Boolean is_on) {
    int all = strcmp(category, CATEGORY_ALL) == 0, known = all;
    unsigned char on = is_on != 0;
    if (all || strcmp(category, CATEGORY_WARNING) == 0)
        c->hears[WARNED] = c->hears[NOTED] = on, known = 1;
    if (all || strcmp(category, CATEGORY_DISCARD) == 0)
        c->hears[DISCARDED] = c->hears[TRIED] = on, known = 1;
    if (all || strcmp(category, CATEGORY_ERROR) == 0)
        c->hears[FAILED] = on, known = 1;
    return known;
}

EXPORTED fmi2Status NAMED(fmi2SetDebugLogging)(fmi2Component component, fmi2Boolean loggingOn, size_t nCategories,
                                               const fmi2String categories[]) {
    size_t at;
    ENTER(component, SetDebugLogging);
    NOT_NULL(categories, nCategories, "categories", SetDebugLogging);
    if (nCategories == 0)
        hear(c, CATEGORY_ALL, loggingOn);
    for (at = 0; at < nCategories; at++) {
        if (!categories[at])
            return refuse(c, SetDebugLogging, "a category is NULL");
        if (!hear(c, categories[at], loggingOn))
            return refuse(c, SetDebugLogging, "unknown log category");
    }
    return fmi2OK;
}

static int is_finite(double value) {
    return value - value == 0.0;
}

/* Refuses a number, with its name, its value and the limit. */
static fmi2Status refuse_number(struct component *c, enum call call, const char *name, double value, const char *rule) {
    char text[128], shown[32];
    snprintf(text, sizeof text, "%s = %s: %s", name, digits(value, shown), rule);
    return refuse(c, call, text);
}

EXPORTED fmi2Status NAMED(fmi2SetupExperiment)(fmi2Component component, fmi2Boolean toleranceDefined,
                                               fmi2Real tolerance, fmi2Real startTime, fmi2Boolean stopTimeDefined,
                                               fmi2Real stopTime) {
    ENTER(component, SetupExperiment);
    if (toleranceDefined && !(tolerance > 0.0 && is_finite(tolerance)))
        return refuse_number(c, SetupExperiment, "tolerance", tolerance, "must be > 0 and finite");
    if (!is_finite(startTime))
        return refuse_number(c, SetupExperiment, "startTime", startTime, "must be finite");
    if (stopTimeDefined && !(is_finite(stopTime) && stopTime >= startTime))
        return refuse_number(c, SetupExperiment, "stopTime", stopTime, "must be finite and >= startTime");
    c->is_set_up = 1;
    c->start = startTime;
    c->stop = stopTimeDefined ? stopTime : HUGE_VAL;
    model_set_time(&c->m, startTime);
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2EnterInitializationMode)(fmi2Component component) {
    ENTER(component, EnterInitializationMode);
    if (!c->is_set_up)
        return refuse(c, EnterInitializationMode, "fmi2SetupExperiment must be called first");
    c->state = Initialization;
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2ExitInitializationMode)(fmi2Component component) {
    ENTER(component, ExitInitializationMode);
    if (model_output(&c->m) != OK)
        return refuse(c, ExitInitializationMode, why(c));
    c->steps = 0;
    if (model_warning(&c->m, 1))
        keep(c, NOTED, NULL, why(c));
    c->state = StepComplete;
    tell(c);
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2Terminate)(fmi2Component component) {
    ENTER(component, Terminate);
    c->state = Terminated;
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2Reset)(fmi2Component component) {
    ENTER(component, Reset);
    model_reset(&c->m);
    c->is_set_up = 0;
    c->start = 0.0;
    c->stop = HUGE_VAL;
    c->state = Instantiated;
    return fmi2OK;
}

/* Reads variables of one type into one of the arrays. */
static fmi2Status get(struct component *c, enum call call, u32 kind, const fmi2ValueReference vr[], size_t n,
                      fmi2Real reals[], int others[]) {
    size_t at;
    u32 status;
    for (at = 0; at < n; at++) {
        status = model_check_readable(&c->m, vr[at], kind);
        if (status != OK)
            return refused(c, call, status);
    }
    for (at = 0; at < n; at++) {
        double value;
        if (model_get(&c->m, vr[at], kind, c->state == Error) != OK)
            return refuse(c, call, why(c));
        value = model_value(&c->m);
        if (kind == REAL)
            reals[at] = value;
        else
            others[at] = kind == BOOLEAN ? value != 0.0 : (int)value;
    }
    return fmi2OK;
}

/* Whether this many variables were read that need no computing. */
static int get_at_once(struct component *c, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
    size_t at;
    if (c->state != StepComplete)
        return 0;
    for (at = 0; at < n; at++) {
        if (model_get(&c->m, vr[at], REAL, 0) != OK)
            return 0;
        value[at] = model_value(&c->m);
    }
    return 1;
}

EXPORTED fmi2Status NAMED(fmi2GetReal)(fmi2Component component, const fmi2ValueReference vr[], size_t nvr,
                                       fmi2Real value[]) {
    ENTER(component, GetReal);
    NOT_NULL(vr, nvr, "vr", GetReal);
    NOT_NULL(value, nvr, "value", GetReal);
    return get_at_once(c, vr, nvr, value) ? fmi2OK : get(c, GetReal, REAL, vr, nvr, value, NULL);
}

EXPORTED fmi2Status NAMED(fmi2GetInteger)(fmi2Component component, const fmi2ValueReference vr[], size_t nvr,
                                          fmi2Integer value[]) {
    ENTER(component, GetInteger);
    NOT_NULL(vr, nvr, "vr", GetInteger);
    NOT_NULL(value, nvr, "value", GetInteger);
    return get(c, GetInteger, INTEGER, vr, nvr, NULL, value);
}

EXPORTED fmi2Status NAMED(fmi2GetBoolean)(fmi2Component component, const fmi2ValueReference vr[], size_t nvr,
                                          fmi2Boolean value[]) {
    ENTER(component, GetBoolean);
    NOT_NULL(vr, nvr, "vr", GetBoolean);
    NOT_NULL(value, nvr, "value", GetBoolean);
    return get(c, GetBoolean, BOOLEAN, vr, nvr, NULL, value);
}

static fmi2Status no_strings(struct component *c, enum call call, size_t n) {
    return n == 0 ? fmi2OK : refuse(c, call, "the value reference does not belong to any String variable");
}

EXPORTED fmi2Status NAMED(fmi2GetString)(fmi2Component component, const fmi2ValueReference vr[], size_t nvr,
                                         fmi2String value[]) {
    ENTER(component, GetString);
    (void)vr, (void)value;
    return no_strings(c, GetString, nvr);
}

/* Sets variables of one type: all, or none. */
static fmi2Status set(struct component *c, enum call call, u32 kind, const fmi2ValueReference vr[], size_t n,
                      const fmi2Real reals[], const int others[]) {
    u32 is_running = c->state == StepComplete, status;
    size_t at;
    if (kind == REAL && n == 1 && is_running && model_set_input(&c->m, vr[0], reals[0]))
        return fmi2OK;
    for (at = 0; at < n; at++) {
        status = model_check_readable(&c->m, vr[at], kind);
        if (status != OK)
            return refused(c, call, status);
    }
    for (at = 0; at < n; at++) {
        status = model_check(&c->m, vr[at], kind, kind == REAL ? reals[at] : (double)others[at], is_running);
        if (status != OK)
            return refused(c, call, status);
    }
    for (at = 0; at < n; at++)
        model_set(&c->m, vr[at], kind == REAL ? reals[at] : (double)others[at]);
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2SetReal)(fmi2Component component, const fmi2ValueReference vr[], size_t nvr,
                                       const fmi2Real value[]) {
    ENTER(component, SetReal);
    NOT_NULL(vr, nvr, "vr", SetReal);
    NOT_NULL(value, nvr, "value", SetReal);
    return set(c, SetReal, REAL, vr, nvr, value, NULL);
}

EXPORTED fmi2Status NAMED(fmi2SetInteger)(fmi2Component component, const fmi2ValueReference vr[], size_t nvr,
                                          const fmi2Integer value[]) {
    ENTER(component, SetInteger);
    NOT_NULL(vr, nvr, "vr", SetInteger);
    NOT_NULL(value, nvr, "value", SetInteger);
    return set(c, SetInteger, INTEGER, vr, nvr, NULL, value);
}

EXPORTED fmi2Status NAMED(fmi2SetBoolean)(fmi2Component component, const fmi2ValueReference vr[], size_t nvr,
                                          const fmi2Boolean value[]) {
    ENTER(component, SetBoolean);
    NOT_NULL(vr, nvr, "vr", SetBoolean);
    NOT_NULL(value, nvr, "value", SetBoolean);
    return set(c, SetBoolean, BOOLEAN, vr, nvr, NULL, value);
}

EXPORTED fmi2Status NAMED(fmi2SetString)(fmi2Component component, const fmi2ValueReference vr[], size_t nvr,
                                         const fmi2String value[]) {
    ENTER(component, SetString);
    (void)vr, (void)value;
    return no_strings(c, SetString, nvr);
}

EXPORTED fmi2Status NAMED(fmi2SetRealInputDerivatives)(fmi2Component component, const fmi2ValueReference vr[],
                                                       size_t nvr, const fmi2Integer order[], const fmi2Real value[]) {
    u32 is_final, status;
    size_t at;
    ENTER(component, SetRealInputDerivatives);
    NOT_NULL(vr, nvr, "vr", SetRealInputDerivatives);
    NOT_NULL(order, nvr, "order", SetRealInputDerivatives);
    NOT_NULL(value, nvr, "value", SetRealInputDerivatives);
    for (is_final = 0; is_final < 2; is_final++)
        for (at = 0; at < nvr; at++) {
            status = model_slope(&c->m, vr[at], (u32)order[at], value[at], is_final);
            if (status != OK)
                return refused(c, SetRealInputDerivatives, status);
        }
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2GetRealOutputDerivatives)(fmi2Component component, const fmi2ValueReference vr[],
                                                        size_t nvr, const fmi2Integer order[], fmi2Real value[]) {
    u32 status;
    size_t at;
    ENTER(component, GetRealOutputDerivatives);
    NOT_NULL(vr, nvr, "vr", GetRealOutputDerivatives);
    NOT_NULL(order, nvr, "order", GetRealOutputDerivatives);
    NOT_NULL(value, nvr, "value", GetRealOutputDerivatives);
    for (at = 0; at < nvr; at++) {
        status = model_time_derivative(&c->m, vr[at], (u32)order[at]);
        if (status != OK)
            return refused(c, GetRealOutputDerivatives, status);
        value[at] = model_value(&c->m);
    }
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2GetDirectionalDerivative)(fmi2Component component,
                                                        const fmi2ValueReference vUnknown_ref[], size_t nUnknown,
                                                        const fmi2ValueReference vKnown_ref[], size_t nKnown,
                                                        const fmi2Real dvKnown[], fmi2Real dvUnknown[]) {
    size_t at;
    u32 status = OK;
    ENTER(component, GetDirectionalDerivative);
    NOT_NULL(vUnknown_ref, nUnknown, "vUnknown_ref", GetDirectionalDerivative);
    NOT_NULL(vKnown_ref, nKnown, "vKnown_ref", GetDirectionalDerivative);
    NOT_NULL(dvKnown, nKnown, "dvKnown", GetDirectionalDerivative);
    NOT_NULL(dvUnknown, nUnknown, "dvUnknown", GetDirectionalDerivative);
    for (at = 0; at < nUnknown && status == OK; at++)
        status = model_check_unknown(&c->m, vUnknown_ref[at]);
    if (status == OK)
        status = model_direct(&c->m);
    for (at = 0; at < nKnown && status == OK; at++)
        status = model_direct_to(&c->m, vKnown_ref[at], dvKnown[at]);
    if (status == OK)
        status = model_differentiate(&c->m, HAS_RATES);
    for (at = 0; at < nUnknown && status == OK; at++) {
        status = model_derivative(&c->m, vUnknown_ref[at]);
        if (status == OK)
            dvUnknown[at] = model_value(&c->m);
    }
    return status == OK ? fmi2OK : refused(c, GetDirectionalDerivative, status);
}

/* A step that begins, or ends, a rounding error away from where it should; otherwise a wrong one. */
static fmi2Status check_unusual_step(struct component *c, double t, double h) {
    double time = model_time(&c->m), largest = fabs(t) > fabs(time) ? fabs(t) : fabs(time);
    double slack = TIME_SLACK + RELATIVE_SLACK * largest;
    if (!(h > 0.0 && is_finite(h)))
        return refuse_number(c, DoStep, "communicationStepSize", h, "must be > 0 and finite");
    if (slack > STEP_SLACK * h)
        slack = STEP_SLACK * h;
    slack += 4.0 * DBL_EPSILON * largest;
    if (!(is_finite(t) && fabs(t - time) <= slack))
        return refuse_number(c, DoStep, "currentCommunicationPoint", t, "must be where the last step ended");
    if (t + h > c->stop + slack || !is_finite(t + h))
        return refuse_number(c, DoStep, "end of the step", t + h, "must not pass the stop time");
    return fmi2OK;
}

/* Logs a warning, once. */
static void warn(struct component *c) {
    u64 mark = UINT64_C(0xcbf29ce484222325);
    const char *text = why(c);
    u32 at;
    if (!c->hears[WARNED])
        return;
    for (; *text; text++)
        mark = (mark ^ (unsigned char)*text) * UINT64_C(0x100000001b3);
    for (at = 0; at < c->told_count; at++)
        if (c->told[at] == mark)
            return;
    if (at == TOLD)
        return;
    c->told[c->told_count++] = mark;
    keep(c, WARNED, NULL, why(c));
}

EXPORTED fmi2Status NAMED(fmi2DoStep)(fmi2Component component, fmi2Real currentCommunicationPoint,
                                      fmi2Real communicationStepSize, fmi2Boolean noSetFMUStatePriorToCurrentPoint) {
    double t = currentCommunicationPoint, h = communicationStepSize;
    ENTER(component, DoStep);
    (void)noSetFMUStatePriorToCurrentPoint;
    if (!(t == model_time(&c->m) && h > 0.0 && t + h <= c->stop && t + h < HUGE_VAL)) {
        fmi2Status status = check_unusual_step(c, t, h);
        if (status != fmi2OK)
            return status;
    }
    if (model_step(&c->m, h) != OK)
        return refuse(c, DoStep, why(c));
    model_set_time(&c->m, t + h);
    c->steps++;
    if ((c->steps & (c->steps - 1)) == 0 && model_warning(&c->m, 0))
        warn(c);
    tell(c);
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2CancelStep)(fmi2Component component) {
    ENTER(component, CancelStep);
    return fmi2OK;
}

static fmi2Status no_status(struct component *c, enum call call) {
    return discard(c, call, TRIED, "this kind of status is not available: steps are synchronous");
}

EXPORTED fmi2Status NAMED(fmi2GetStatus)(fmi2Component component, fmi2StatusKind s, fmi2Status *value) {
    ENTER(component, GetStatus);
    NOT_NULL(value, 1, "value", GetStatus);
    (void)s;
    return no_status(c, GetStatus);
}

EXPORTED fmi2Status NAMED(fmi2GetRealStatus)(fmi2Component component, fmi2StatusKind s, fmi2Real *value) {
    ENTER(component, GetRealStatus);
    NOT_NULL(value, 1, "value", GetRealStatus);
    if (s != LAST_SUCCESSFUL_TIME)
        return no_status(c, GetRealStatus);
    *value = model_time(&c->m);
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2GetIntegerStatus)(fmi2Component component, fmi2StatusKind s, fmi2Integer *value) {
    ENTER(component, GetIntegerStatus);
    NOT_NULL(value, 1, "value", GetIntegerStatus);
    (void)s;
    return no_status(c, GetIntegerStatus);
}

EXPORTED fmi2Status NAMED(fmi2GetBooleanStatus)(fmi2Component component, fmi2StatusKind s, fmi2Boolean *value) {
    ENTER(component, GetBooleanStatus);
    NOT_NULL(value, 1, "value", GetBooleanStatus);
    if (s != IS_TERMINATED)
        return no_status(c, GetBooleanStatus);
    *value = 0;
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2GetStringStatus)(fmi2Component component, fmi2StatusKind s, fmi2String *value) {
    ENTER(component, GetStringStatus);
    NOT_NULL(value, 1, "value", GetStringStatus);
    (void)s;
    return no_status(c, GetStringStatus);
}

/* The saved state behind a pointer; NULL, with the reason logged, if there is none. */
static struct saved *saved(struct component *c, enum call call, fmi2FMUstate state) {
    struct saved *s = (struct saved *)state;
    if (s && s->magic == SAVED)
        return s;
    refuse(c, call, s ? "FMUstate is not a state of these sources" : "FMUstate is NULL");
    return NULL;
}

/* A place for a state: that of the caller, or a new one. */
static struct saved *room(struct component *c, enum call call, fmi2FMUstate *place) {
    size_t size = model_state_size(&c->m);
    struct saved *s = (struct saved *)*place;
    if (s)
        return saved(c, call, s);
    s = (struct saved *)calloc(1, sizeof *s + size);
    if (!s) {
        refuse(c, call, "out of memory");
        return NULL;
    }
    s->magic = SAVED;
    s->size = size;
    return s;
}

EXPORTED fmi2Status NAMED(fmi2GetFMUstate)(fmi2Component component, fmi2FMUstate *FMUstate) {
    struct saved *s;
    ENTER(component, GetFMUstate);
    NOT_NULL(FMUstate, 1, "FMUstate", GetFMUstate);
    s = room(c, GetFMUstate, FMUstate);
    if (!s)
        return fmi2Error;
    *FMUstate = s;
    if (model_save(&c->m, (double)c->state, c->is_set_up ? 1.0 : 0.0, c->start, c->stop) != OK)
        return refuse(c, GetFMUstate, why(c));
    memcpy(s->bytes, c->m.memory + model_state(&c->m), s->size);
    return fmi2OK;
}

/* Reads bytes of a state, and continues with them. */
static u32 read(struct component *c, const void *bytes, size_t size, u32 is_final) {
    size_t known = model_state_size(&c->m);
    memcpy(c->m.memory + model_state(&c->m), bytes, size < known ? size : known);
    return model_read(&c->m, size < 0xffffffffu ? (u32)size : 0xffffffffu, is_final);
}

/* Whether the numbers of this layer in a state make sense. */
static int is_sound(struct component *c) {
    double state = model_owner(&c->m, 0), is_set_up = model_owner(&c->m, 1), stop = model_owner(&c->m, 3);
    int is_state = state == Instantiated || state == Initialization || state == StepComplete || state == Terminated ||
                   state == Error;
    return is_state && (is_set_up == 0.0 || is_set_up == 1.0) && is_finite(model_owner(&c->m, 2)) && stop == stop;
}

EXPORTED fmi2Status NAMED(fmi2SetFMUstate)(fmi2Component component, fmi2FMUstate FMUstate) {
    struct saved *s;
    ENTER(component, SetFMUstate);
    s = saved(c, SetFMUstate, FMUstate);
    if (!s)
        return fmi2Error;
    if (read(c, s->bytes, s->size, 1) != OK)
        return refuse(c, SetFMUstate, why(c));
    c->state = (enum state)(int)model_owner(&c->m, 0);
    c->is_set_up = model_owner(&c->m, 1) != 0.0;
    c->start = model_owner(&c->m, 2);
    c->stop = model_owner(&c->m, 3);
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2FreeFMUstate)(fmi2Component component, fmi2FMUstate *FMUstate) {
    struct saved *s;
    ENTER(component, FreeFMUstate);
    if (!FMUstate || !*FMUstate)
        return fmi2OK;
    s = saved(c, FreeFMUstate, *FMUstate);
    if (!s)
        return fmi2Error;
    s->magic = 0;
    free(s);
    *FMUstate = NULL;
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2SerializedFMUstateSize)(fmi2Component component, fmi2FMUstate FMUstate, size_t *size) {
    struct saved *s;
    ENTER(component, SerializedFMUstateSize);
    NOT_NULL(size, 1, "size", SerializedFMUstateSize);
    s = saved(c, SerializedFMUstateSize, FMUstate);
    if (!s)
        return fmi2Error;
    *size = s->size;
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2SerializeFMUstate)(fmi2Component component, fmi2FMUstate FMUstate,
                                                 fmi2Byte serializedState[], size_t size) {
    struct saved *s;
    ENTER(component, SerializeFMUstate);
    NOT_NULL(serializedState, size, "serializedState", SerializeFMUstate);
    s = saved(c, SerializeFMUstate, FMUstate);
    if (!s)
        return fmi2Error;
    if (size < s->size)
        return refuse(c, SerializeFMUstate, "serializedState is smaller than the state");
    memcpy(serializedState, s->bytes, s->size);
    return fmi2OK;
}

EXPORTED fmi2Status NAMED(fmi2DeSerializeFMUstate)(fmi2Component component, const fmi2Byte serializedState[],
                                                   size_t size, fmi2FMUstate *FMUstate) {
    struct saved *s;
    ENTER(component, DeSerializeFMUstate);
    NOT_NULL(serializedState, size, "serializedState", DeSerializeFMUstate);
    NOT_NULL(FMUstate, 1, "FMUstate", DeSerializeFMUstate);
    if (read(c, serializedState, size, 0) != OK)
        return refuse(c, DeSerializeFMUstate, why(c));
    if (!is_sound(c))
        return refuse(c, DeSerializeFMUstate, "the state of the experiment makes no sense");
    s = room(c, DeSerializeFMUstate, FMUstate);
    if (!s)
        return fmi2Error;
    memcpy(s->bytes, serializedState, s->size);
    *FMUstate = s;
    return fmi2OK;
}
