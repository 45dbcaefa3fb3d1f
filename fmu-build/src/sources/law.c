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
        return LAW_INTERNAL;                                                                                           \
    if (setjmp((instance)->m.way_out))                                                                                 \
    return LAW_INTERNAL

law_status law_create(law_memory *memory, law **instance) {
    struct law *made = (struct law *)memory;
    if (!memory || !instance)
        return LAW_NULL;
    *instance = NULL;
    if (!computes_alike())
        return LAW_OTHER_ARITHMETIC;
    create_module(&made->m);
    if (setjmp(made->m.way_out) || model_create(&made->m))
        return LAW_INTERNAL;
    *instance = made;
    return LAW_OK;
}

law_status law_reset(law *instance) {
    ENTER(instance);
    return (law_status)model_reset(&instance->m);
}

law_status law_set(law *instance, uint32_t variable, double value) {
    ENTER(instance);
    return (law_status)model_set(&instance->m, variable, value);
}

law_status law_get(law *instance, uint32_t variable, double *value) {
    law_status status;
    ENTER(instance);
    if (!value)
        return LAW_NULL;
    status = (law_status)model_get(&instance->m, variable, 3, 0);
    if (status == LAW_OK)
        *value = model_value(&instance->m);
    return status;
}

law_status law_step(law *instance, double dt) {
    ENTER(instance);
    return (law_status)model_step(&instance->m, dt);
}

law_status law_output(law *instance) {
    ENTER(instance);
    return (law_status)model_output(&instance->m);
}

double law_time(law *instance) {
    if (!instance || setjmp(instance->m.way_out))
        return (double)NAN;
    return model_time(&instance->m);
}

law_status law_apply_preset(law *instance, uint32_t preset) {
    ENTER(instance);
    return (law_status)model_apply(&instance->m, preset);
}

law_status law_derivative(law *instance, uint32_t output, uint32_t input, double *value) {
    law_status status;
    ENTER(instance);
    if (!value)
        return LAW_NULL;
    status = (law_status)model_check_unknown(&instance->m, output);
    if (status == LAW_REFUSED_VALUE)
        status = LAW_UNKNOWN_VARIABLE;
    if (status == LAW_OK)
        status = (law_status)model_direct(&instance->m);
    if (status == LAW_OK)
        status = (law_status)model_direct_to(&instance->m, input, 1.0);
    if (status == LAW_OK)
        status = (law_status)model_differentiate(&instance->m, 0);
    if (status == LAW_OK)
        status = (law_status)model_derivative(&instance->m, output);
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
    status = (law_status)model_save(&instance->m, 0.0, 0.0, 0.0, 0.0);
    if (status == LAW_OK)
        memcpy(buffer, instance->m.memory + model_state(&instance->m), LAW_STATE);
    return status;
}

law_status law_restore(law *instance, const void *buffer, size_t size) {
    ENTER(instance);
    if (!buffer)
        return LAW_NULL;
    if (size != LAW_STATE)
        return LAW_BAD_BUFFER;
    memcpy(instance->m.memory + model_state(&instance->m), buffer, LAW_STATE);
    return (law_status)model_read(&instance->m, LAW_STATE, 1);
}
