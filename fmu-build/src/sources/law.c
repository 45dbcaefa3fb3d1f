/* The functions of law.h over those above. */

struct law {
    struct module m;
};

/* An instance fits into its memory: the size of this array would be negative otherwise. */
typedef char law_fits_into_its_memory[sizeof(struct law) <= LAW_MEMORY ? 1 : -1];

#define ENTER(instance)                                                                                                \
    if (!(instance))                                                                                                   \
        return LAW_NULL;                                                                                               \
    if ((instance)->m.is_broken)                                                                                       \
    return LAW_INTERNAL

/* The result of a call of the model, unless it broke down. */
static law_status result(const law *instance, u32 status) {
    return instance->m.is_broken ? LAW_INTERNAL : (law_status)status;
}

law_status law_create(law_memory *memory, law **instance) {
    struct law *made = (struct law *)memory;
    if (!memory || !instance)
        return LAW_NULL;
    *instance = NULL;
    if (!computes_alike())
        return LAW_OTHER_ARITHMETIC;
    create_module(&made->m);
    if (result(made, model_create(&made->m)) != LAW_OK)
        return LAW_INTERNAL;
    *instance = made;
    return LAW_OK;
}

law_status law_reset(law *instance) {
    ENTER(instance);
    return result(instance, model_reset(&instance->m));
}

law_status law_set(law *instance, uint32_t variable, double value) {
    ENTER(instance);
    return result(instance, model_set(&instance->m, variable, value));
}

law_status law_get(law *instance, uint32_t variable, double *value) {
    law_status status;
    ENTER(instance);
    if (!value)
        return LAW_NULL;
    status = result(instance, model_get(&instance->m, variable, 3, 0));
    if (status == LAW_OK)
        *value = model_value(&instance->m);
    return status;
}

law_status law_step(law *instance, double dt) {
    ENTER(instance);
    return result(instance, model_step(&instance->m, dt));
}

law_status law_output(law *instance) {
    ENTER(instance);
    return result(instance, model_output(&instance->m));
}

double law_time(law *instance) {
    return instance && !instance->m.is_broken ? model_time(&instance->m) : (double)NAN;
}

law_status law_apply_preset(law *instance, uint32_t preset) {
    ENTER(instance);
    return result(instance, model_apply(&instance->m, preset));
}

law_status law_derivative(law *instance, uint32_t output, uint32_t input, double *value) {
    law_status status;
    ENTER(instance);
    if (!value)
        return LAW_NULL;
    status = result(instance, model_check_unknown(&instance->m, output));
    if (status == LAW_REFUSED_VALUE)
        status = LAW_UNKNOWN_VARIABLE;
    if (status == LAW_OK)
        status = result(instance, model_direct(&instance->m));
    if (status == LAW_OK)
        status = result(instance, model_direct_to(&instance->m, input, 1.0));
    if (status == LAW_OK)
        status = result(instance, model_differentiate(&instance->m, 0));
    if (status == LAW_OK)
        status = result(instance, model_derivative(&instance->m, output));
    if (status == LAW_OK)
        *value = model_value(&instance->m);
    return status;
}

law_status law_save(law *instance, void *buffer, size_t size) {
    law_status status;
    ENTER(instance);
    if (!buffer)
        return LAW_NULL;
    if (size < LAW_STATE)
        return LAW_BAD_BUFFER;
    status = result(instance, model_save(&instance->m, 0.0, 0.0, 0.0, 0.0, 0));
    if (status == LAW_OK)
        memcpy(buffer, BYTE(&instance->m, model_state(&instance->m), 0), LAW_STATE);
    return status;
}

law_status law_restore(law *instance, const void *buffer, size_t size) {
    ENTER(instance);
    if (!buffer)
        return LAW_NULL;
    if (size != LAW_STATE)
        return LAW_BAD_BUFFER;
    memcpy(BYTE(&instance->m, model_state(&instance->m), 0), buffer, LAW_STATE);
    return result(instance, model_read(&instance->m, LAW_STATE, 0, 1));
}
