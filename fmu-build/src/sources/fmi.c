/* What FMI 2.0 and 3.0 have in common, over the functions above: FMI(name) is the name with the prefix of the version.
 * Types, names and states are those of the standard; a call that is refused leaves the model as it was, and the logger
 * hears why. Memory is allocated for an instance and for a saved state. */

#if defined _WIN32 || defined __CYGWIN__
#define EXPORTED __declspec(dllexport)
#elif defined __GNUC__
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif

#ifdef FUNCTION_PREFIX
#define JOINED(prefix, name) prefix##name
#define JOIN(prefix, name) JOINED(prefix, name)
#define NAMED(name) JOIN(FUNCTION_PREFIX, name)
#else
#define NAMED(name) name
#endif

typedef FMI(Status) outcome;

/* Results of the functions of the model. */
enum { OK, REFUSED_VALUE = 4, INTERNAL = 8 };

/* Types of variables of the model. */
enum { REAL, INTEGER, BOOLEAN, ANY };

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
    struct importer importer;
    unsigned char hears[REASONS];
    int is_waiting;
    enum reason reason;
    u32 told_count;
    u64 told[TOLD];
    char text[TEXT], *name;
    /* Of arrays, as the importer has chosen them. */
    double sizes[SIZES + 1];
};

struct saved {
    u32 magic;
    size_t size;
    u8 bytes[1];
};

/* Marks of both, different ones for each version. */
#define COMPONENT (0x53545200u + FMI_VERSION)
#define SAVED (0x53415600u + FMI_VERSION)

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
    if (!c->hears[reason] || !has_logger(&c->importer))
        return;
    if (call)
        at = (size_t)snprintf(c->text, TEXT, FMI_PREFIX "%s: ", call);
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
    static const outcome statuses[REASONS] = {FMI(Warning), FMI(Warning), FMI(Discard), FMI(Discard), FMI(Error)};
    static const char *const names[REASONS] = {CATEGORY_WARNING, CATEGORY_WARNING, CATEGORY_DISCARD, CATEGORY_DISCARD,
                                               CATEGORY_ERROR};
    if (!c->is_waiting)
        return;
    c->is_waiting = 0;
    send(&c->importer, c->name, statuses[c->reason], names[c->reason], c->text);
}

/* A call that is refused. Whatever it was, an instance that is broken stays so. */
static outcome refuse(struct component *c, enum call call, const char *why) {
    c->state = Error;
    keep(c, FAILED, calls[call].name, c->m.is_broken ? "internal error, please report it" : why);
    tell(c);
    return c->m.is_broken ? FMI(Fatal) : FMI(Error);
}

static outcome discard(struct component *c, enum call call, enum reason reason, const char *why) {
    keep(c, reason, calls[call].name, why);
    tell(c);
    return FMI(Discard);
}

/* The last text of the model: why it refused a call, or a warning. */
static const char *why(struct component *c) {
    return (const char *)BYTE(&c->m, model_text(&c->m), 0);
}

/* The result of a function of the model, unless it broke down. */
static u32 result(const struct component *c, u32 status) {
    return c->m.is_broken ? INTERNAL : status;
}

/* A call that the model has refused. */
static outcome refused(struct component *c, enum call call, u32 status) {
    if (status == REFUSED_VALUE)
        return discard(c, call, DISCARDED, why(c));
    return refuse(c, call, why(c));
}

/* The end of a call that had this result. */
static outcome finish(struct component *c, enum call call, u32 status) {
    return result(c, status) == OK ? FMI(OK) : refused(c, call, result(c, status));
}

/* Whether a call may be made now. */
static outcome admit(struct component *c, enum call call) {
    char text[64];
    if (!c || c->magic != COMPONENT)
        return FMI(Error);
    if (c->m.is_broken)
        return FMI(Fatal);
    if (calls[call].is_allowed[c->state])
        return FMI(OK);
    snprintf(text, sizeof text, "may not be called in state %s", states[c->state]);
    return refuse(c, call, text);
}

/* What every call begins with. */
#define ENTER(instance, call)                                                                                          \
    struct component *c = (struct component *)instance;                                                                \
    outcome admitted = admit(c, call);                                                                                 \
    if (admitted != FMI(OK))                                                                                           \
    return admitted

#define NOT_NULL(pointer, count, name, call)                                                                           \
    if ((count) && !(pointer))                                                                                         \
    return refuse(c, call, name " is NULL")

static int is_blank(const char *text) {
    for (; text && *text; text++)
        if (*text != ' ' && (*text < '\t' || *text > '\r'))
            return 0;
    return 1;
}

/* Why no instance can be made; NULL if one can. */
static const char *no_instance(const char *name, const char *guid) {
    if (is_blank(name))
        return "instanceName is NULL or blank";
    if (!guid)
        return FMI_GUID " is NULL";
    if (strcmp(guid, MODEL_GUID) != 0)
        return "the " FMI_GUID_NAME " is not that of these sources: they differ from modelDescription.xml in version";
    if (!computes_alike())
        return "this target does not round as IEC 60559 says: compile with -ffp-contract=off, keep subnormal numbers";
    return NULL;
}

/* Gives arrays their largest sizes. */
static void enlarge(struct component *c) {
    int at;
    for (at = 0; at < SIZES; at++)
        c->sizes[at] = sizes[at].most;
}

/* An instance at its start values. */
static struct component *made(const char *name, struct importer importer, int is_debugged) {
    static const unsigned char always[REASONS] = ALWAYS_HEARS;
    struct component *c = (struct component *)calloc(1, sizeof *c + strlen(name) + 1);
    int reason;
    if (!c)
        return NULL;
    create_module(&c->m);
    c->magic = COMPONENT;
    c->importer = importer;
    c->stop = HUGE_VAL;
    c->name = (char *)(c + 1);
    memcpy(c->name, name, strlen(name) + 1);
    for (reason = 0; reason < REASONS; reason++)
        c->hears[reason] = always[reason] || is_debugged;
    enlarge(c);
    if (result(c, model_create(&c->m)) == OK)
        return c;
    free(c);
    return NULL;
}

/* An instance, unless there is a reason why not, which is logged. */
static void *make(const char *name, const char *kind, struct importer importer, const char *why_not, int is_logged,
                  int is_debugged) {
    char text[TEXT];
    struct component *c = why_not ? NULL : made(name, importer, is_debugged);
    if (!c && is_logged && has_logger(&importer)) {
        snprintf(text, TEXT, FMI_PREFIX "Instantiate%s: %s", kind, why_not ? why_not : "out of memory");
        send(&importer, name ? name : "", FMI(Error), CATEGORY_ERROR, text);
    }
    return c;
}

static void end(void *instance) {
    struct component *c = (struct component *)instance;
    if (!c || c->magic != COMPONENT)
        return;
    c->magic = 0;
    free(c);
}

static int hear(struct component *c, const char *category, int is_on) {
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

static outcome switch_log(void *instance, int is_on, size_t count, const FMI(String) categories[]) {
    size_t at;
    ENTER(instance, SetDebugLogging);
    NOT_NULL(categories, count, "categories", SetDebugLogging);
    if (count == 0)
        hear(c, CATEGORY_ALL, is_on);
    for (at = 0; at < count; at++) {
        if (!categories[at])
            return refuse(c, SetDebugLogging, "a category is NULL");
        if (!hear(c, categories[at], is_on))
            return refuse(c, SetDebugLogging, "unknown log category");
    }
    return FMI(OK);
}

static int is_finite(double value) {
    return value - value == 0.0;
}

/* Refuses a number, with its name, its value and the limit. */
static outcome refuse_number(struct component *c, enum call call, const char *name, double value, const char *rule) {
    char text[128], shown[32];
    snprintf(text, sizeof text, "%s = %s: %s", name, digits(value, shown), rule);
    return refuse(c, call, text);
}

/* Sets an experiment up; the tolerance is only checked. */
static outcome set_up(struct component *c, enum call call, const double *tolerance, double start, const double *stop) {
    if (tolerance && !(*tolerance > 0.0 && is_finite(*tolerance)))
        return refuse_number(c, call, "tolerance", *tolerance, "must be > 0 and finite");
    if (!is_finite(start))
        return refuse_number(c, call, "startTime", start, "must be finite");
    if (stop && !(is_finite(*stop) && *stop >= start))
        return refuse_number(c, call, "stopTime", *stop, "must be finite and >= startTime");
    c->is_set_up = 1;
    c->start = start;
    c->stop = stop ? *stop : HUGE_VAL;
    return finish(c, call, model_set_time(&c->m, start));
}

/* Ends the initialization: parameters must now fit together, and outputs be finite. */
static outcome begin(struct component *c, enum call call, enum state state) {
    if (result(c, model_output(&c->m)) != OK)
        return refuse(c, call, why(c));
    c->steps = 0;
    if (model_warning(&c->m, 1))
        keep(c, NOTED, NULL, why(c));
    if (c->m.is_broken)
        return refuse(c, call, "");
    c->state = state;
    tell(c);
    return FMI(OK);
}

static outcome go(void *instance, enum call call, enum state state) {
    ENTER(instance, call);
    c->state = state;
    return FMI(OK);
}

static outcome reset(void *instance) {
    ENTER(instance, Reset);
    c->is_set_up = 0;
    c->start = 0.0;
    c->stop = HUGE_VAL;
    c->state = Instantiated;
    enlarge(c);
    return finish(c, Reset, model_reset(&c->m));
}

/* A step that begins, or ends, a rounding error away from where it should; otherwise a wrong one. */
static outcome check_unusual_step(struct component *c, double t, double h) {
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
    return FMI(OK);
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

static outcome check_step(struct component *c, double t, double h) {
    if (t == model_time(&c->m) && h > 0.0 && t + h <= c->stop && t + h < HUGE_VAL)
        return FMI(OK);
    return check_unusual_step(c, t, h);
}

/* Makes a step, after which the clock of the importer is the reference. */
static outcome step(struct component *c, double t, double h) {
    if (result(c, model_step(&c->m, h)) != OK)
        return refuse(c, DoStep, why(c));
    model_set_time(&c->m, t + h);
    c->steps++;
    if ((c->steps & (c->steps - 1)) == 0 && model_warning(&c->m, 0))
        warn(c);
    if (c->m.is_broken)
        return refuse(c, DoStep, "");
    tell(c);
    return FMI(OK);
}

/* The saved state behind a pointer; NULL, with the reason logged, if there is none. */
static struct saved *saved(struct component *c, enum call call, void *state) {
    struct saved *s = (struct saved *)state;
    if (s && s->magic == SAVED)
        return s;
    refuse(c, call, s ? FMI_STATE " is not a state of these sources" : FMI_STATE " is NULL");
    return NULL;
}

/* A place for a state: that of the caller, or a new one. */
static struct saved *room(struct component *c, enum call call, void *const *place) {
    size_t size = STATE_SIZE;
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

static outcome save(void *instance, enum call call, void **state) {
    struct saved *s;
    double number;
    int at;
    ENTER(instance, call);
    NOT_NULL(state, 1, FMI_STATE, call);
    s = room(c, call, state);
    if (!s)
        return FMI(Error);
    *state = s;
    number = FIRST_STATE + (double)c->state;
    for (at = 0; at < SIZES; at++)
        model_resize(&c->m, (u32)at, c->sizes[at]);
    if (result(c, model_save(&c->m, number, c->is_set_up ? 1.0 : 0.0, c->start, c->stop, SIZES)) != OK)
        return refuse(c, call, why(c));
    memcpy(s->bytes, BYTE(&c->m, model_state(&c->m), 0), s->size);
    return FMI(OK);
}

/* Reads bytes of a state, and continues with them if this is final. */
static u32 read(struct component *c, const void *bytes, size_t size, u32 is_final) {
    memcpy(BYTE(&c->m, model_state(&c->m), 0), bytes, size < STATE_SIZE ? size : STATE_SIZE);
    return result(c, model_read(&c->m, size < 0xffffffffu ? (u32)size : 0xffffffffu, SIZES, is_final));
}

/* The state in what was read; STATES if it is none. */
static enum state state_read(struct component *c) {
    double number = model_owner(&c->m, 0) - FIRST_STATE;
    int at;
    for (at = 0; at < STATES; at++)
        if (number == at && is_reached[at])
            return (enum state)at;
    return STATES;
}

/* Whether the numbers of this layer in a state make sense. */
static int is_sound(struct component *c) {
    double is_set_up = model_owner(&c->m, 1), stop = model_owner(&c->m, 3), size;
    int at;
    for (at = 0; at < SIZES; at++) {
        size = model_size(&c->m, (u32)at);
        if (!(size >= 1.0 && size <= sizes[at].most && size == floor(size)))
            return 0;
    }
    return state_read(c) != STATES && (is_set_up == 0.0 || is_set_up == 1.0) && is_finite(model_owner(&c->m, 2)) &&
           stop == stop;
}

static outcome restore(void *instance, enum call call, void *state) {
    struct saved *s;
    int at;
    ENTER(instance, call);
    s = saved(c, call, state);
    if (!s)
        return FMI(Error);
    if (read(c, s->bytes, s->size, 1) != OK)
        return refuse(c, call, why(c));
    c->state = state_read(c);
    c->is_set_up = model_owner(&c->m, 1) != 0.0;
    c->start = model_owner(&c->m, 2);
    c->stop = model_owner(&c->m, 3);
    for (at = 0; at < SIZES; at++)
        c->sizes[at] = model_size(&c->m, (u32)at);
    return FMI(OK);
}

static outcome forget(void *instance, enum call call, void **state) {
    struct saved *s;
    ENTER(instance, call);
    if (!state || !*state)
        return FMI(OK);
    s = saved(c, call, *state);
    if (!s)
        return FMI(Error);
    s->magic = 0;
    free(s);
    *state = NULL;
    return FMI(OK);
}

static outcome size_of(void *instance, enum call call, void *state, size_t *size) {
    struct saved *s;
    ENTER(instance, call);
    NOT_NULL(size, 1, "size", call);
    s = saved(c, call, state);
    if (!s)
        return FMI(Error);
    *size = s->size;
    return FMI(OK);
}

static outcome write(void *instance, enum call call, void *state, void *bytes, size_t size) {
    struct saved *s;
    ENTER(instance, call);
    NOT_NULL(bytes, size, "serializedState", call);
    s = saved(c, call, state);
    if (!s)
        return FMI(Error);
    if (size < s->size)
        return refuse(c, call, "serializedState is smaller than the state");
    memcpy(bytes, s->bytes, s->size);
    return FMI(OK);
}

static outcome deserialize(void *instance, enum call call, const void *bytes, size_t size, void **state) {
    struct saved *s;
    ENTER(instance, call);
    NOT_NULL(bytes, size, "serializedState", call);
    NOT_NULL(state, 1, FMI_STATE, call);
    if (read(c, bytes, size, 0) != OK)
        return refuse(c, call, why(c));
    if (!is_sound(c))
        return refuse(c, call, "the state of the experiment makes no sense");
    s = room(c, call, state);
    if (!s)
        return FMI(Error);
    memcpy(s->bytes, bytes, s->size);
    *state = s;
    return FMI(OK);
}

/* The functions of states, whose names differ between the versions in more than their prefix. */
#define STATE_FUNCTIONS(Get, Set, Free, Size, Serialize, Deserialize)                                                  \
    EXPORTED outcome NAMED(FMI(Get))(void *instance, void **state) {                                                   \
        return save(instance, Get, state);                                                                             \
    }                                                                                                                  \
    EXPORTED outcome NAMED(FMI(Set))(void *instance, void *state) {                                                    \
        return restore(instance, Set, state);                                                                          \
    }                                                                                                                  \
    EXPORTED outcome NAMED(FMI(Free))(void *instance, void **state) {                                                  \
        return forget(instance, Free, state);                                                                          \
    }                                                                                                                  \
    EXPORTED outcome NAMED(FMI(Size))(void *instance, void *state, size_t *size) {                                     \
        return size_of(instance, Size, state, size);                                                                   \
    }                                                                                                                  \
    EXPORTED outcome NAMED(FMI(Serialize))(void *instance, void *state, FMI(Byte) bytes[], size_t size) {              \
        return write(instance, Serialize, state, bytes, size);                                                         \
    }                                                                                                                  \
    EXPORTED outcome NAMED(FMI(Deserialize))(void *instance, const FMI(Byte) bytes[], size_t size, void **state) {     \
        return deserialize(instance, Deserialize, bytes, size, state);                                                 \
    }
