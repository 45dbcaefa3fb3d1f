/* The functions of FMI 3.0 for co-simulation, without events and intermediate updates. */

/* Types of variables: those of the model, in its order, and others, which none has. */
enum type {
    NONE,
    FLOAT64,
    INT32,
    INT64,
    TRUTH,
    DERIVATIVE,
    TIME,
    UINT64,
    FLOAT32,
    INT8,
    UINT8,
    INT16,
    UINT16,
    UINT32,
    STRING,
    BINARY,
    CLOCK
};

static const char *const type_names[] = {"",        "Float64", "Int32",   "Int64",  "Boolean", "Float64",
                                         "Float64", "UInt64",  "Float32", "Int8",   "UInt8",   "Int16",
                                         "UInt16",  "UInt32",  "String",  "Binary", "Clock"};

/* A variable: the references of its elements, or a size. */
struct variable {
    enum type type;
    const u32 *elements;
    size_t count;
    int size;
};

/* Whether a reference belongs to an element of an array, which has none in FMI 3.0. */
static int is_element(u32 reference) {
    int at;
    for (at = 0; at < ELEMENTS; at++)
        if (elements[at] == reference)
            return 1;
    return 0;
}

/* The variable with a reference; its type is NONE if there is none. */
static struct variable find(struct component *c, const u32 *reference) {
    struct variable found = {NONE, reference, 1, -1};
    int at;
    for (at = 0; at < SIZES; at++)
        if (sizes[at].reference == *reference) {
            found.type = UINT64;
            found.size = at;
            return found;
        }
    for (at = 0; at < ARRAYS; at++)
        if (arrays[at].reference == *reference) {
            found.elements = elements + arrays[at].first;
            found.count = arrays[at].size < 0 ? arrays[at].most : (size_t)c->sizes[arrays[at].size];
            found.type = (enum type)model_type(&c->m, found.elements[0]);
            return found;
        }
    if (!is_element(*reference))
        found.type = (enum type)model_type(&c->m, *reference);
    return found;
}

static const char *name_of(struct component *c, const struct variable *variable) {
    if (variable->size >= 0)
        return sizes[variable->size].name;
    model_name(&c->m, variable->elements[0]);
    return why(c);
}

static int is_real(enum type type) {
    return type == FLOAT64 || type == DERIVATIVE || type == TIME;
}

/* Refuses variables that do not exist or are of another type, and counts the elements of the others. */
static fmi3Status count(struct component *c, enum call call, enum type wanted, const u32 references[], size_t n,
                        size_t *elements) {
    char text[TEXT];
    size_t at;
    *elements = 0;
    for (at = 0; at < n; at++) {
        struct variable found = find(c, &references[at]);
        if (found.type == NONE) {
            snprintf(text, TEXT, "value reference %lu does not belong to any variable", (unsigned long)references[at]);
            return refuse(c, call, text);
        }
        if (found.type != wanted && !(wanted == FLOAT64 && is_real(found.type))) {
            snprintf(text, TEXT, "%s (value reference %lu) is of type %s, not %s", name_of(c, &found),
                     (unsigned long)references[at], type_names[found.type], type_names[wanted]);
            return refuse(c, call, text);
        }
        *elements += found.count;
    }
    return fmi3OK;
}

/* Refuses a number of values that is not that of the elements. */
static fmi3Status check_count(struct component *c, enum call call, size_t given, size_t wanted, const char *what) {
    char text[64];
    if (given == wanted)
        return fmi3OK;
    snprintf(text, sizeof text, "%lu %s: must be %lu", (unsigned long)given, what, (unsigned long)wanted);
    return refuse(c, call, text);
}

static fmi3Status check_values(struct component *c, enum call call, enum type wanted, const u32 references[], size_t n,
                               size_t values) {
    size_t elements;
    fmi3Status status = count(c, call, wanted, references, n, &elements);
    return status == fmi3OK ? check_count(c, call, values, elements, "values") : status;
}

static void put(void *values, size_t at, enum type type, double value) {
    switch (type) {
    case INT32:
        ((fmi3Int32 *)values)[at] = (fmi3Int32)value;
        break;
    case INT64:
        ((fmi3Int64 *)values)[at] = (fmi3Int64)value;
        break;
    case UINT64:
        ((fmi3UInt64 *)values)[at] = (fmi3UInt64)value;
        break;
    case TRUTH:
        ((fmi3Boolean *)values)[at] = value != 0.0;
        break;
    default:
        ((fmi3Float64 *)values)[at] = value;
    }
}

static double take(const void *values, size_t at, enum type type) {
    switch (type) {
    case INT32:
        return ((const fmi3Int32 *)values)[at];
    case INT64:
        return (double)((const fmi3Int64 *)values)[at];
    case UINT64:
        return (double)((const fmi3UInt64 *)values)[at];
    case TRUTH:
        return ((const fmi3Boolean *)values)[at] ? 1.0 : 0.0;
    default:
        return ((const fmi3Float64 *)values)[at];
    }
}

/* The type of the model by which a variable is read. */
static u32 kind_of(enum type type) {
    return type == TRUTH ? BOOLEAN : type == INT32 || type == INT64 ? INTEGER : REAL;
}

/* Reads variables that are neither arrays nor have to be computed first. Returns 0 if one of them is not such a
 * variable. */
static int get_at_once(struct component *c, const u32 references[], size_t n, double values[]) {
    size_t at;
    if (c->state != StepMode)
        return 0;
    for (at = 0; at < n; at++) {
        if (is_element(references[at]) || result(c, model_get(&c->m, references[at], REAL, 0)) != OK)
            return 0;
        values[at] = model_value(&c->m);
    }
    return 1;
}

static fmi3Status get(void *instance, enum call call, enum type type, const u32 references[], size_t n, void *values,
                      size_t n_values) {
    size_t at, element, to = 0;
    fmi3Status status;
    ENTER(instance, call);
    NOT_NULL(references, n, "valueReferences", call);
    NOT_NULL(values, n_values, "values", call);
    if (type == FLOAT64 && n == n_values && get_at_once(c, references, n, (double *)values))
        return fmi3OK;
    status = check_values(c, call, type, references, n, n_values);
    for (at = 0; at < n && status == fmi3OK; at++) {
        struct variable found = find(c, &references[at]);
        if (found.size >= 0)
            put(values, to++, type, c->sizes[found.size]);
        for (element = 0; found.size < 0 && element < found.count; element++) {
            if (result(c, model_get(&c->m, found.elements[element], kind_of(type), 0)) != OK)
                return refuse(c, call, why(c));
            put(values, to++, type, model_value(&c->m));
        }
    }
    return status;
}

/* Refuses a variable that is never set here. */
static fmi3Status check_settable(struct component *c, enum call call, const u32 *reference) {
    char text[TEXT];
    struct variable found = find(c, reference);
    const char *why_not = NULL;
    if (c->state == ConfigurationMode)
        why_not = found.size < 0 ? "only sizes of arrays are set here" : NULL;
    else if (found.size >= 0)
        why_not = " can be set in state ConfigurationMode only";
    else if (found.type == DERIVATIVE || found.type == TIME)
        why_not = " is computed and cannot be set";
    if (!why_not)
        return fmi3OK;
    snprintf(text, TEXT, "%s%s", c->state == ConfigurationMode ? "" : name_of(c, &found), why_not);
    return refuse(c, call, text);
}

/* Checks a size and then, in a second round, sets it. */
static fmi3Status resize(struct component *c, enum call call, int size, double value, int is_final) {
    char text[TEXT], shown[32], most[32];
    if (!(value >= 1.0 && value <= sizes[size].most)) {
        snprintf(text, TEXT, "%s = %s: must be from 1 to %s", sizes[size].name, digits(value, shown),
                 digits(sizes[size].most, most));
        return discard(c, call, DISCARDED, text);
    }
    if (is_final)
        c->sizes[size] = value;
    return fmi3OK;
}

/* Checks all values and then, in a second round, sets them. */
static fmi3Status set_all(struct component *c, enum call call, enum type type, const u32 references[], size_t n,
                          const void *values, int is_final) {
    u32 is_running = c->state == StepMode, status = OK;
    size_t at, element, from = 0;
    for (at = 0; at < n; at++) {
        struct variable found = find(c, &references[at]);
        if (found.size >= 0) {
            fmi3Status resized = resize(c, call, found.size, take(values, from++, type), is_final);
            if (resized != fmi3OK)
                return resized;
            continue;
        }
        for (element = 0; element < found.count; element++) {
            double value = take(values, from++, type);
            u32 reference = found.elements[element];
            status =
                is_final ? model_set(&c->m, reference, value) : model_check(&c->m, reference, ANY, value, is_running);
            if (result(c, status) != OK)
                return finish(c, call, status);
        }
    }
    return fmi3OK;
}

static fmi3Status set(void *instance, enum call call, enum type type, const u32 references[], size_t n,
                      const void *values, size_t n_values) {
    size_t at;
    fmi3Status status;
    ENTER(instance, call);
    NOT_NULL(references, n, "valueReferences", call);
    NOT_NULL(values, n_values, "values", call);
    if (type == FLOAT64 && n == 1 && n_values == 1 && c->state == StepMode && !is_element(references[0]) &&
        model_set_input(&c->m, references[0], take(values, 0, type)))
        return fmi3OK;
    status = check_values(c, call, type, references, n, n_values);
    for (at = 0; at < n && status == fmi3OK; at++)
        status = check_settable(c, call, &references[at]);
    if (status == fmi3OK)
        status = set_all(c, call, type, references, n, values, 0);
    return status == fmi3OK ? set_all(c, call, type, references, n, values, 1) : status;
}

#define VALUES(Name, TYPE)                                                                                             \
    EXPORTED fmi3Status NAMED(fmi3Get##Name)(fmi3Instance instance, const fmi3ValueReference valueReferences[],        \
                                             size_t nValueReferences, fmi3##Name values[], size_t nValues) {           \
        return get(instance, Get##Name, TYPE, valueReferences, nValueReferences, values, nValues);                     \
    }                                                                                                                  \
    EXPORTED fmi3Status NAMED(fmi3Set##Name)(fmi3Instance instance, const fmi3ValueReference valueReferences[],        \
                                             size_t nValueReferences, const fmi3##Name values[], size_t nValues) {     \
        return set(instance, Set##Name, TYPE, valueReferences, nValueReferences, values, nValues);                     \
    }

VALUES(Float32, FLOAT32)
VALUES(Float64, FLOAT64)
VALUES(Int8, INT8)
VALUES(UInt8, UINT8)
VALUES(Int16, INT16)
VALUES(UInt16, UINT16)
VALUES(Int32, INT32)
VALUES(UInt32, UINT32)
VALUES(Int64, INT64)
VALUES(UInt64, UINT64)
VALUES(Boolean, TRUTH)
VALUES(String, STRING)

EXPORTED fmi3Status NAMED(fmi3GetBinary)(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                         size_t nValueReferences, size_t valueSizes[], fmi3Binary values[],
                                         size_t nValues) {
    (void)valueSizes;
    return get(instance, GetBinary, BINARY, valueReferences, nValueReferences, values, nValues);
}

EXPORTED fmi3Status NAMED(fmi3SetBinary)(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                         size_t nValueReferences, const size_t valueSizes[], const fmi3Binary values[],
                                         size_t nValues) {
    (void)valueSizes;
    return set(instance, SetBinary, BINARY, valueReferences, nValueReferences, values, nValues);
}

/* A call about clocks, of which no model has any. */
static fmi3Status without_clocks(void *instance, enum call call, const u32 references[], size_t n) {
    size_t elements;
    ENTER(instance, call);
    NOT_NULL(references, n, "valueReferences", call);
    return count(c, call, CLOCK, references, n, &elements);
}

#define ONE_OF_CLOCKS(Name, Type)                                                                                      \
    EXPORTED fmi3Status NAMED(fmi3##Name)(fmi3Instance instance, const fmi3ValueReference valueReferences[],           \
                                          size_t nValueReferences, Type values[]) {                                    \
        (void)values;                                                                                                  \
        return without_clocks(instance, Name, valueReferences, nValueReferences);                                      \
    }

#define TWO_OF_CLOCKS(Name, Type, Other)                                                                               \
    EXPORTED fmi3Status NAMED(fmi3##Name)(fmi3Instance instance, const fmi3ValueReference valueReferences[],           \
                                          size_t nValueReferences, Type values[], Other others[]) {                    \
        (void)values, (void)others;                                                                                    \
        return without_clocks(instance, Name, valueReferences, nValueReferences);                                      \
    }

ONE_OF_CLOCKS(GetClock, fmi3Clock)
ONE_OF_CLOCKS(SetClock, const fmi3Clock)
ONE_OF_CLOCKS(GetShiftDecimal, fmi3Float64)
ONE_OF_CLOCKS(SetShiftDecimal, const fmi3Float64)
ONE_OF_CLOCKS(SetIntervalDecimal, const fmi3Float64)
TWO_OF_CLOCKS(GetIntervalDecimal, fmi3Float64, fmi3IntervalQualifier)
TWO_OF_CLOCKS(GetShiftFraction, fmi3UInt64, fmi3UInt64)
TWO_OF_CLOCKS(SetShiftFraction, const fmi3UInt64, const fmi3UInt64)
TWO_OF_CLOCKS(SetIntervalFraction, const fmi3UInt64, const fmi3UInt64)

EXPORTED fmi3Status NAMED(fmi3GetIntervalFraction)(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                                   size_t nValueReferences, fmi3UInt64 counters[],
                                                   fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[]) {
    (void)counters, (void)resolutions, (void)qualifiers;
    return without_clocks(instance, GetIntervalFraction, valueReferences, nValueReferences);
}

EXPORTED fmi3String NAMED(fmi3GetVersion)(void) {
    return "3.0";
}

/* An instance that is not available. */
static fmi3Instance no_kind(const char *kind, bool loggingOn, fmi3InstanceEnvironment environment,
                            fmi3LogMessageCallback log) {
    struct importer importer;
    importer.environment = environment;
    importer.log = log;
    return make("", kind, importer, "these sources are for co-simulation only", loggingOn, 0);
}

EXPORTED fmi3Instance NAMED(fmi3InstantiateModelExchange)(fmi3String instanceName, fmi3String instantiationToken,
                                                          fmi3String resourcePath, fmi3Boolean visible,
                                                          fmi3Boolean loggingOn,
                                                          fmi3InstanceEnvironment instanceEnvironment,
                                                          fmi3LogMessageCallback logMessage) {
    (void)instanceName, (void)instantiationToken, (void)resourcePath, (void)visible;
    return no_kind("ModelExchange", loggingOn, instanceEnvironment, logMessage);
}

EXPORTED fmi3Instance NAMED(fmi3InstantiateScheduledExecution)(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible,
    fmi3Boolean loggingOn, fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage,
    fmi3ClockUpdateCallback clockUpdate, fmi3LockPreemptionCallback lockPreemption,
    fmi3UnlockPreemptionCallback unlockPreemption) {
    (void)instanceName, (void)instantiationToken, (void)resourcePath, (void)visible;
    (void)clockUpdate, (void)lockPreemption, (void)unlockPreemption;
    return no_kind("ScheduledExecution", loggingOn, instanceEnvironment, logMessage);
}

EXPORTED fmi3Instance NAMED(fmi3InstantiateCoSimulation)(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible,
    fmi3Boolean loggingOn, fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed,
    const fmi3ValueReference requiredIntermediateVariables[], size_t nRequiredIntermediateVariables,
    fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage,
    fmi3IntermediateUpdateCallback intermediateUpdate) {
    const char *text = no_instance(instanceName, instantiationToken);
    struct importer importer;
    (void)resourcePath, (void)visible, (void)earlyReturnAllowed;
    (void)requiredIntermediateVariables, (void)intermediateUpdate;
    importer.environment = instanceEnvironment;
    importer.log = logMessage;
    if (!text && eventModeUsed)
        text = "eventModeUsed must be false: these sources have no Event Mode";
    if (!text && nRequiredIntermediateVariables != 0)
        text = "nRequiredIntermediateVariables must be 0: these sources have no intermediate updates";
    return make(instanceName, "CoSimulation", importer, text, loggingOn, loggingOn);
}

EXPORTED void NAMED(fmi3FreeInstance)(fmi3Instance instance) {
    end(instance);
}

EXPORTED fmi3Status NAMED(fmi3SetDebugLogging)(fmi3Instance instance, fmi3Boolean loggingOn, size_t nCategories,
                                               const fmi3String categories[]) {
    return switch_log(instance, loggingOn, nCategories, categories);
}

EXPORTED fmi3Status NAMED(fmi3EnterConfigurationMode)(fmi3Instance instance) {
    ENTER(instance, EnterConfigurationMode);
    if (SIZES == 0)
        return refuse(c, EnterConfigurationMode, MODEL_NAME " has no structural parameters");
    c->state = ConfigurationMode;
    return fmi3OK;
}

EXPORTED fmi3Status NAMED(fmi3ExitConfigurationMode)(fmi3Instance instance) {
    return go(instance, ExitConfigurationMode, Instantiated);
}

EXPORTED fmi3Status NAMED(fmi3EnterInitializationMode)(fmi3Instance instance, fmi3Boolean toleranceDefined,
                                                       fmi3Float64 tolerance, fmi3Float64 startTime,
                                                       fmi3Boolean stopTimeDefined, fmi3Float64 stopTime) {
    fmi3Status status;
    ENTER(instance, EnterInitializationMode);
    status = set_up(c, EnterInitializationMode, toleranceDefined ? &tolerance : NULL, startTime,
                    stopTimeDefined ? &stopTime : NULL);
    if (status == fmi3OK)
        c->state = InitializationMode;
    return status;
}

/* Refuses numbers of elements beyond the sizes of their arrays. */
static fmi3Status check_sizes(struct component *c, enum call call) {
    char text[TEXT], shown[32], most[32];
    int at;
    for (at = 0; at < SIZES; at++) {
        double value;
        if (result(c, model_get(&c->m, sizes[at].in_use, ANY, 0)) != OK)
            return refuse(c, call, why(c));
        value = model_value(&c->m);
        if (value > c->sizes[at]) {
            snprintf(text, TEXT, "%s = %s: must be at most %s = %s", sizes[at].name_in_use, digits(value, shown),
                     sizes[at].name, digits(c->sizes[at], most));
            return refuse(c, call, text);
        }
    }
    return fmi3OK;
}

EXPORTED fmi3Status NAMED(fmi3ExitInitializationMode)(fmi3Instance instance) {
    fmi3Status status;
    ENTER(instance, ExitInitializationMode);
    status = check_sizes(c, ExitInitializationMode);
    return status == fmi3OK ? begin(c, ExitInitializationMode, StepMode) : status;
}

EXPORTED fmi3Status NAMED(fmi3Terminate)(fmi3Instance instance) {
    return go(instance, Terminate, Terminated);
}

EXPORTED fmi3Status NAMED(fmi3Reset)(fmi3Instance instance) {
    return reset(instance);
}

EXPORTED fmi3Status NAMED(fmi3DoStep)(fmi3Instance instance, fmi3Float64 currentCommunicationPoint,
                                      fmi3Float64 communicationStepSize, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                      fmi3Boolean *eventHandlingNeeded, fmi3Boolean *terminateSimulation,
                                      fmi3Boolean *earlyReturn, fmi3Float64 *lastSuccessfulTime) {
    fmi3Status status;
    ENTER(instance, DoStep);
    (void)noSetFMUStatePriorToCurrentPoint;
    NOT_NULL(eventHandlingNeeded, 1, "eventHandlingNeeded", DoStep);
    NOT_NULL(terminateSimulation, 1, "terminateSimulation", DoStep);
    NOT_NULL(earlyReturn, 1, "earlyReturn", DoStep);
    NOT_NULL(lastSuccessfulTime, 1, "lastSuccessfulTime", DoStep);
    status = check_step(c, currentCommunicationPoint, communicationStepSize);
    if (status == fmi3OK)
        status = check_sizes(c, DoStep);
    if (status == fmi3OK)
        status = step(c, currentCommunicationPoint, communicationStepSize);
    if (status != fmi3OK)
        return status;
    *eventHandlingNeeded = *terminateSimulation = *earlyReturn = false;
    *lastSuccessfulTime = model_time(&c->m);
    return fmi3OK;
}

EXPORTED fmi3Status NAMED(fmi3GetOutputDerivatives)(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                                    size_t nValueReferences, const fmi3Int32 orders[],
                                                    fmi3Float64 values[], size_t nValues) {
    size_t at, element, to = 0;
    fmi3Status status;
    ENTER(instance, GetOutputDerivatives);
    NOT_NULL(valueReferences, nValueReferences, "valueReferences", GetOutputDerivatives);
    NOT_NULL(orders, nValueReferences, "orders", GetOutputDerivatives);
    NOT_NULL(values, nValues, "values", GetOutputDerivatives);
    status = check_values(c, GetOutputDerivatives, FLOAT64, valueReferences, nValueReferences, nValues);
    for (at = 0; at < nValueReferences && status == fmi3OK; at++) {
        struct variable found = find(c, &valueReferences[at]);
        for (element = 0; element < found.count && status == fmi3OK; element++) {
            u32 answer = model_time_derivative(&c->m, found.elements[element], (u32)orders[at]);
            status = finish(c, GetOutputDerivatives, answer);
            if (status == fmi3OK)
                values[to++] = model_value(&c->m);
        }
    }
    return status;
}

/* A list of variables, with all their elements one after the other. */
struct list {
    const u32 *references;
    size_t n, count;
};

/* The reference of an element of a list. */
static u32 at(struct component *c, const struct list *list, size_t index) {
    size_t place;
    for (place = 0; place < list->n; place++) {
        struct variable found = find(c, &list->references[place]);
        if (index < found.count)
            return found.elements[index];
        index -= found.count;
    }
    return 0;
}

/* Computes the derivatives of unknowns in the direction of the seed or, without one, of a single known. */
static u32 differentiate(struct component *c, const struct list *unknowns, const struct list *knowns,
                         const double *seed, size_t only) {
    u32 status = result(c, model_direct(&c->m)), has_rates = 0;
    size_t index;
    for (index = 0; index < knowns->count && status == OK; index++)
        if (seed || index == only)
            status = result(c, model_direct_to(&c->m, at(c, knowns, index), seed ? seed[index] : 1.0));
    for (index = 0; index < unknowns->n; index++)
        has_rates |= find(c, &unknowns->references[index]).type == DERIVATIVE;
    return status == OK ? result(c, model_differentiate(&c->m, has_rates)) : status;
}

static u32 find_directional(struct component *c, const struct list *unknowns, const struct list *knowns,
                            const double seed[], double sensitivity[]) {
    u32 status = differentiate(c, unknowns, knowns, seed, 0);
    size_t index;
    for (index = 0; index < unknowns->count && status == OK; index++) {
        status = result(c, model_derivative(&c->m, at(c, unknowns, index)));
        if (status == OK)
            sensitivity[index] = model_value(&c->m);
    }
    return status;
}

static u32 find_adjoint(struct component *c, const struct list *unknowns, const struct list *knowns,
                        const double seed[], double sensitivity[]) {
    u32 status = OK;
    size_t known, index;
    for (known = 0; known < knowns->count && status == OK; known++) {
        /* As a sum begins in the library, for the sign of zero. */
        double sum = -0.0;
        status = differentiate(c, unknowns, knowns, NULL, known);
        for (index = 0; index < unknowns->count && status == OK; index++) {
            status = result(c, model_derivative(&c->m, at(c, unknowns, index)));
            if (status == OK)
                sum += seed[index] * model_value(&c->m);
        }
        if (status == OK)
            sensitivity[known] = sum;
    }
    return status;
}

/* Refuses unknowns that have no derivatives, and counts their elements. */
static fmi3Status count_unknowns(struct component *c, enum call call, struct list *list) {
    size_t index;
    fmi3Status status = count(c, call, FLOAT64, list->references, list->n, &list->count);
    for (index = 0; index < list->count && status == fmi3OK; index++)
        status = finish(c, call, model_check_unknown(&c->m, at(c, list, index)));
    return status;
}

static fmi3Status derivative(void *instance, enum call call, struct list unknowns, struct list knowns,
                             const double seed[], size_t n_seed, double sensitivity[], size_t n_sensitivity) {
    int is_adjoint = call == GetAdjointDerivative;
    fmi3Status status;
    size_t index;
    ENTER(instance, call);
    NOT_NULL(unknowns.references, unknowns.n, "unknowns", call);
    NOT_NULL(knowns.references, knowns.n, "knowns", call);
    NOT_NULL(seed, n_seed, "seed", call);
    NOT_NULL(sensitivity, n_sensitivity, "sensitivity", call);
    status = count_unknowns(c, call, &unknowns);
    if (status == fmi3OK)
        status = count(c, call, FLOAT64, knowns.references, knowns.n, &knowns.count);
    if (status == fmi3OK)
        status = check_count(c, call, n_seed, is_adjoint ? unknowns.count : knowns.count, "seeds");
    if (status == fmi3OK)
        status = check_count(c, call, n_sensitivity, is_adjoint ? knowns.count : unknowns.count, "sensitivities");
    if (status != fmi3OK)
        return status;
    if (!is_adjoint)
        return finish(c, call, find_directional(c, &unknowns, &knowns, seed, sensitivity));
    status = finish(c, call, find_adjoint(c, &unknowns, &knowns, seed, sensitivity));
    for (index = 0; index < n_sensitivity && status == fmi3OK; index++)
        if (!is_finite(sensitivity[index]))
            status = refuse(c, call, "a derivative is not finite");
    return status;
}

EXPORTED fmi3Status NAMED(fmi3GetDirectionalDerivative)(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                                        size_t nUnknowns, const fmi3ValueReference knowns[],
                                                        size_t nKnowns, const fmi3Float64 seed[], size_t nSeed,
                                                        fmi3Float64 sensitivity[], size_t nSensitivity) {
    struct list of_unknowns = {unknowns, nUnknowns, 0}, of_knowns = {knowns, nKnowns, 0};
    return derivative(instance, GetDirectionalDerivative, of_unknowns, of_knowns, seed, nSeed, sensitivity,
                      nSensitivity);
}

EXPORTED fmi3Status NAMED(fmi3GetAdjointDerivative)(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                                    size_t nUnknowns, const fmi3ValueReference knowns[], size_t nKnowns,
                                                    const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[],
                                                    size_t nSensitivity) {
    struct list of_unknowns = {unknowns, nUnknowns, 0}, of_knowns = {knowns, nKnowns, 0};
    return derivative(instance, GetAdjointDerivative, of_unknowns, of_knowns, seed, nSeed, sensitivity, nSensitivity);
}

STATE_FUNCTIONS(GetFMUState, SetFMUState, FreeFMUState, SerializedFMUStateSize, SerializeFMUState, DeserializeFMUState)

static fmi3Status no_dependencies(void *instance, enum call call) {
    ENTER(instance, call);
    return refuse(c, call, "dependencies of single elements are not provided: those of modelDescription.xml hold");
}

EXPORTED fmi3Status NAMED(fmi3GetNumberOfVariableDependencies)(fmi3Instance instance, fmi3ValueReference valueReference,
                                                               size_t *nDependencies) {
    (void)valueReference, (void)nDependencies;
    return no_dependencies(instance, GetNumberOfVariableDependencies);
}

EXPORTED fmi3Status NAMED(fmi3GetVariableDependencies)(fmi3Instance instance, fmi3ValueReference dependent,
                                                       size_t elementIndicesOfDependent[],
                                                       fmi3ValueReference independents[],
                                                       size_t elementIndicesOfIndependents[],
                                                       fmi3DependencyKind dependencyKinds[], size_t nDependencies) {
    (void)dependent, (void)elementIndicesOfDependent, (void)independents, (void)elementIndicesOfIndependents;
    (void)dependencyKinds, (void)nDependencies;
    return no_dependencies(instance, GetVariableDependencies);
}

/* A call that is allowed in none of the states that an instance reaches. */
static fmi3Status never(void *instance, enum call call) {
    ENTER(instance, call);
    return fmi3OK;
}

EXPORTED fmi3Status NAMED(fmi3EnterEventMode)(fmi3Instance instance) {
    ENTER(instance, EnterEventMode);
    return refuse(c, EnterEventMode, "eventModeUsed was fmi3False");
}

EXPORTED fmi3Status NAMED(fmi3EvaluateDiscreteStates)(fmi3Instance instance) {
    return never(instance, EvaluateDiscreteStates);
}

EXPORTED fmi3Status NAMED(fmi3UpdateDiscreteStates)(fmi3Instance instance, fmi3Boolean *discreteStatesNeedUpdate,
                                                    fmi3Boolean *terminateSimulation,
                                                    fmi3Boolean *nominalsOfContinuousStatesChanged,
                                                    fmi3Boolean *valuesOfContinuousStatesChanged,
                                                    fmi3Boolean *nextEventTimeDefined, fmi3Float64 *nextEventTime) {
    (void)discreteStatesNeedUpdate, (void)terminateSimulation, (void)nominalsOfContinuousStatesChanged;
    (void)valuesOfContinuousStatesChanged, (void)nextEventTimeDefined, (void)nextEventTime;
    return never(instance, UpdateDiscreteStates);
}

EXPORTED fmi3Status NAMED(fmi3EnterStepMode)(fmi3Instance instance) {
    return never(instance, EnterStepMode);
}

EXPORTED fmi3Status NAMED(fmi3EnterContinuousTimeMode)(fmi3Instance instance) {
    return never(instance, EnterContinuousTimeMode);
}

EXPORTED fmi3Status NAMED(fmi3CompletedIntegratorStep)(fmi3Instance instance,
                                                       fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                                       fmi3Boolean *enterEventMode, fmi3Boolean *terminateSimulation) {
    (void)noSetFMUStatePriorToCurrentPoint, (void)enterEventMode, (void)terminateSimulation;
    return never(instance, CompletedIntegratorStep);
}

EXPORTED fmi3Status NAMED(fmi3SetTime)(fmi3Instance instance, fmi3Float64 time) {
    (void)time;
    return never(instance, SetTime);
}

#define OF_SOLVERS(Name, Type)                                                                                         \
    EXPORTED fmi3Status NAMED(fmi3##Name)(fmi3Instance instance, Type values[], size_t nValues) {                      \
        (void)values, (void)nValues;                                                                                   \
        return never(instance, Name);                                                                                  \
    }

OF_SOLVERS(SetContinuousStates, const fmi3Float64)
OF_SOLVERS(GetContinuousStateDerivatives, fmi3Float64)
OF_SOLVERS(GetEventIndicators, fmi3Float64)
OF_SOLVERS(GetContinuousStates, fmi3Float64)
OF_SOLVERS(GetNominalsOfContinuousStates, fmi3Float64)

#define NUMBER_FOR_SOLVERS(Name)                                                                                       \
    EXPORTED fmi3Status NAMED(fmi3##Name)(fmi3Instance instance, size_t *number) {                                     \
        (void)number;                                                                                                  \
        return never(instance, Name);                                                                                  \
    }

NUMBER_FOR_SOLVERS(GetNumberOfEventIndicators)
NUMBER_FOR_SOLVERS(GetNumberOfContinuousStates)

EXPORTED fmi3Status NAMED(fmi3ActivateModelPartition)(fmi3Instance instance, fmi3ValueReference clockReference,
                                                      fmi3Float64 activationTime) {
    (void)clockReference, (void)activationTime;
    return never(instance, ActivateModelPartition);
}
