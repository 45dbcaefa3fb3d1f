/* The functions of FMI 2.0 for co-simulation. */

EXPORTED fmi2String NAMED(fmi2GetTypesPlatform)(void) {
    return "default";
}

EXPORTED fmi2String NAMED(fmi2GetVersion)(void) {
    return "2.0";
}

EXPORTED fmi2Component NAMED(fmi2Instantiate)(fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID,
                                              fmi2String fmuResourceLocation, const fmi2CallbackFunctions *functions,
                                              fmi2Boolean visible, fmi2Boolean loggingOn) {
    struct importer importer;
    const char *text;
    (void)fmuResourceLocation, (void)visible;
    if (!functions)
        return NULL;
    importer.callbacks = *functions;
    text = no_instance(instanceName, fmuGUID);
    if (!text && fmuType == MODEL_EXCHANGE)
        text = "these sources are for co-simulation only";
    if (!text && fmuType != CO_SIMULATION)
        text = "fmuType must be 1 (co-simulation)";
    return make(instanceName, "", importer, text, 1, loggingOn);
}

EXPORTED void NAMED(fmi2FreeInstance)(fmi2Component component) {
    end(component);
}

EXPORTED fmi2Status NAMED(fmi2SetDebugLogging)(fmi2Component component, fmi2Boolean loggingOn, size_t nCategories,
                                               const fmi2String categories[]) {
    return switch_log(component, loggingOn, nCategories, categories);
}

EXPORTED fmi2Status NAMED(fmi2SetupExperiment)(fmi2Component component, fmi2Boolean toleranceDefined,
                                               fmi2Real tolerance, fmi2Real startTime, fmi2Boolean stopTimeDefined,
                                               fmi2Real stopTime) {
    ENTER(component, SetupExperiment);
    return set_up(c, SetupExperiment, toleranceDefined ? &tolerance : NULL, startTime,
                  stopTimeDefined ? &stopTime : NULL);
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
    return begin(c, ExitInitializationMode, StepComplete);
}

EXPORTED fmi2Status NAMED(fmi2Terminate)(fmi2Component component) {
    return go(component, Terminate, Terminated);
}

EXPORTED fmi2Status NAMED(fmi2Reset)(fmi2Component component) {
    return reset(component);
}

/* Reads variables of one type into one of the arrays. */
static fmi2Status get(struct component *c, enum call call, u32 kind, const fmi2ValueReference vr[], size_t n,
                      fmi2Real reals[], int others[]) {
    size_t at;
    u32 status;
    for (at = 0; at < n; at++) {
        status = result(c, model_check_readable(&c->m, vr[at], kind));
        if (status != OK)
            return refused(c, call, status);
    }
    for (at = 0; at < n; at++) {
        double value;
        if (result(c, model_get(&c->m, vr[at], kind, c->state == Error)) != OK)
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
        if (result(c, model_get(&c->m, vr[at], REAL, 0)) != OK)
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
        status = result(c, model_check_readable(&c->m, vr[at], kind));
        if (status != OK)
            return refused(c, call, status);
    }
    for (at = 0; at < n; at++) {
        double value = kind == REAL ? reals[at] : (double)others[at];
        status = result(c, model_check(&c->m, vr[at], kind, value, is_running));
        if (status != OK)
            return refused(c, call, status);
    }
    for (at = 0; at < n; at++)
        model_set(&c->m, vr[at], kind == REAL ? reals[at] : (double)others[at]);
    return finish(c, call, OK);
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
            status = result(c, model_slope(&c->m, vr[at], (u32)order[at], value[at], is_final));
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
        status = result(c, model_time_derivative(&c->m, vr[at], (u32)order[at]));
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
    return finish(c, GetDirectionalDerivative, status);
}

EXPORTED fmi2Status NAMED(fmi2DoStep)(fmi2Component component, fmi2Real currentCommunicationPoint,
                                      fmi2Real communicationStepSize, fmi2Boolean noSetFMUStatePriorToCurrentPoint) {
    fmi2Status status;
    ENTER(component, DoStep);
    (void)noSetFMUStatePriorToCurrentPoint;
    status = check_step(c, currentCommunicationPoint, communicationStepSize);
    return status == fmi2OK ? step(c, currentCommunicationPoint, communicationStepSize) : status;
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

STATE_FUNCTIONS(GetFMUstate, SetFMUstate, FreeFMUstate, SerializedFMUstateSize, SerializeFMUstate, DeSerializeFMUstate)
