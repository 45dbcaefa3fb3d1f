/* stribeck.h: friction force models, the interface for C and C++.  Written by fmu-build; do not edit.
 *
 * Two interfaces, one library. The functions stribeck_... are for programs that use the models directly; the functions
 * fmi2... are those of FMI 2.0 for co-simulation and Model Exchange, with the names and types of the standard's
 * headers, for programs that treat the library as an FMU. Use one of the two for an instance, and do not include the
 * standard's headers together with this one. The modelDescription.xml of a model shows whether it supports Model
 * Exchange; fmi2Instantiate refuses it for the others.
 *
 * Sign        velocity is that of body 1 relative to body 2. friction_force is the resistance: it has the sign of
 *             velocity when sliding, body 1 feels -friction_force and body 2 feels +friction_force. The power
 *             friction_force * velocity is taken out of the motion. external_force is the resultant of all other
 *             tangential forces on body 1 or, if body 2 accelerates too, the effective mass times the relative
 *             acceleration that they cause. A contact that sticks carries friction_force = external_force. SI units
 *             throughout.
 * Columns     A model is a row of numbers. Every variable has a column, which is also its FMI value reference; the
 *             enums at the end of this file name the columns of each model, with role, unit, meaning, bound and
 *             default: in = set by the caller before each step or evaluation; fixed = parameter that stays constant
 *             during a run; tunable = parameter that may change between steps or at events; state = advanced by steps
 *             or, in Model Exchange, by the caller's solver and by events; out = result. Booleans are 0 or 1,
 *             enumerations are numbers from 1.
 * Ownership   An instance made by stribeck_create or fmi2Instantiate is freed exactly once, with stribeck_free or
 *             fmi2FreeInstance. Texts that the library returns belong to the library. Every pointer you pass stays
 *             yours and is not kept after the call, except the logger of fmi2Instantiate and its environment. A program
 *             that unloads the library must first free the instances made by stribeck_create.
 * Threads     Different instances may be used from different threads at the same time, one instance from one thread at
 *             a time. The library does not start threads.
 * Errors      A call that is refused changes nothing; no call aborts the program. stribeck_...: any status other than
 *             STRIBECK_OK is a refusal, and stribeck_last_error says why. fmi2...: with fmi2Discard a value was refused
 *             and the run can continue, in Model Exchange with a shorter step of the solver; after fmi2Error the
 *             instance must be reset, freed or given a saved state. The reason is passed to the logger. A result is
 *             never infinite or NaN.
 * NULL        A NULL instance or array is refused, never dereferenced; an array of length 0 may be NULL. Freeing NULL
 *             does nothing.
 * Safety      A pointer that is not NULL must be valid for its purpose, and a text must end with a zero byte.
 *
 * Example, without status checks:
 *
 *     stribeck_model *law = NULL;
 *     double force = 0.0;
 *     stribeck_create("LuGre", &law);
 *     stribeck_set(law, STRIBECK_LUGRE_VELOCITY, 0.001);
 *     stribeck_step(law, 1.0e-3);
 *     stribeck_get(law, STRIBECK_LUGRE_FRICTION_FORCE, &force);
 *     stribeck_free(law);
 */

#ifndef STRIBECK_H
#define STRIBECK_H

#include <stddef.h>
#include <stdint.h>

/** Version of the library that this header belongs to. */
#define STRIBECK_VERSION "0.1.0"

/** Result of a call. */
typedef enum {
  /** Success. */
  STRIBECK_OK = 0,
  /** A required pointer is NULL. */
  STRIBECK_NULL = 1,
  /** The model or preset does not exist. */
  STRIBECK_UNKNOWN_MODEL = 2,
  /**
   * The variable or column does not exist in this model, or the requested derivative is not that of a result with
   * respect to something that can be set.
   */
  STRIBECK_UNKNOWN_VARIABLE = 3,
  /** The value is outside the bounds of its variable, or the parameters do not fit together. */
  STRIBECK_REFUSED_VALUE = 4,
  /** The variable is computed and cannot be set. */
  STRIBECK_NOT_SETTABLE = 5,
  /** The result would not be finite. */
  STRIBECK_NOT_FINITE = 6,
  /** The buffer is too small, or does not contain a state of this model. */
  STRIBECK_BAD_BUFFER = 7,
  /** Internal error; please report it. */
  STRIBECK_INTERNAL = 8,
  /** Memory has run out. */
  STRIBECK_OUT_OF_MEMORY = 9,
} stribeck_status;

/** Who writes a variable. */
typedef enum {
  /** Set by the caller before each step. */
  STRIBECK_INPUT = 0,
  /** Parameter that stays constant during a run. */
  STRIBECK_FIXED = 1,
  /** Parameter that may change between steps. */
  STRIBECK_TUNABLE = 2,
  /** State, advanced by steps. */
  STRIBECK_STATE = 3,
  /** State that is also a result. */
  STRIBECK_STATE_OUTPUT = 4,
  /** Result, computed from the other variables. */
  STRIBECK_OUTPUT = 5,
} stribeck_role;

/** Meaning of the number in a variable. */
typedef enum {
  /** A physical quantity. */
  STRIBECK_REAL = 0,
  /** A whole number. */
  STRIBECK_INTEGER = 1,
  /** 0 or 1. */
  STRIBECK_BOOLEAN = 2,
  /** The number of a choice, from 1. */
  STRIBECK_ENUMERATION = 3,
} stribeck_kind;

/** Result of a call. */
typedef enum {
  /** Success. */
  fmi2OK,
  /** Success, with a warning in the log. */
  fmi2Warning,
  /** Refused; nothing was changed and the simulation can continue. */
  fmi2Discard,
  /** Refused; the instance must be reset, freed or given a saved state. */
  fmi2Error,
  /** The instance cannot be used any more. */
  fmi2Fatal,
  /** Still running (never returned: all calls are synchronous). */
  fmi2Pending,
} fmi2Status;

/** An instance of a model. Made by stribeck_create, freed by stribeck_free. */
typedef struct stribeck_model stribeck_model;

/** Description of a variable, as given by stribeck_describe. The texts belong to the handle and are freed with it. */
typedef struct {
  /** Name, such as `velocity` or `element[3].stiffness`. */
  const char *name;
  /** Unit, `1` for a pure number; empty if the kind is not STRIBECK_REAL. */
  const char *unit;
  /** One-line description. */
  const char *help;
  /** Who writes it. */
  stribeck_role role;
  /** Meaning of the number. */
  stribeck_kind kind;
  /** Start value. */
  double start;
  /** Smallest admitted value, `-DBL_MAX` if unbounded; 1e-300 if the value must be > 0 (stiffness). */
  double min;
  /** Largest admitted value, `DBL_MAX` if unbounded. */
  double max;
} stribeck_variable;

/** An instance of a model. */
typedef void *fmi2Component;

/** `fmi2False` or `fmi2True`. */
typedef int fmi2Boolean;

/** Floating-point number. */
typedef double fmi2Real;

/** Changes and requests of an event. */
typedef struct {
  /** Whether fmi2NewDiscreteStates must be called again. */
  fmi2Boolean newDiscreteStatesNeeded;
  /** Whether the simulation must end. */
  fmi2Boolean terminateSimulation;
  /** Whether the states have new nominal values. */
  fmi2Boolean nominalsOfContinuousStatesChanged;
  /** Whether the states have jumped. */
  fmi2Boolean valuesOfContinuousStatesChanged;
  /** Whether the time of the next event is known. */
  fmi2Boolean nextEventTimeDefined;
  /** Time of the next event. */
  fmi2Real nextEventTime;
} fmi2EventInfo;

/** Character. */
typedef char fmi2Char;

/** Zero-terminated text. */
typedef const fmi2Char *fmi2String;

/** Interface type of an FMU, an argument of fmi2Instantiate: `fmi2ModelExchange` or `fmi2CoSimulation`. */
typedef int fmi2Type;

/** Pointer that the importer gets back in its logger. */
typedef void *fmi2ComponentEnvironment;

/** Receives a message. `message` is a printf format; this library passes "%s" and the text. */
typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment componentEnvironment,
                                   fmi2String instanceName,
                                   fmi2Status status,
                                   fmi2String category,
                                   fmi2String message,
                                   ...);

/** Allocates zeroed memory. Not used by this library; may be NULL. */
typedef void *(*fmi2CallbackAllocateMemory)(size_t nobj, size_t size);

/** Frees memory. Not used by this library; may be NULL. */
typedef void (*fmi2CallbackFreeMemory)(void *obj);

/** Signals the end of an asynchronous step. Not used by this library; may be NULL. */
typedef void (*fmi2StepFinished)(fmi2ComponentEnvironment componentEnvironment, fmi2Status status);

/** Functions of the importer. The struct is copied by fmi2Instantiate and need not outlive that call. */
typedef struct {
  /** Receives messages; NULL for none. */
  fmi2CallbackLogger logger;
  /** Not used; may be NULL. */
  fmi2CallbackAllocateMemory allocateMemory;
  /** Not used; may be NULL. */
  fmi2CallbackFreeMemory freeMemory;
  /** Not used; may be NULL. */
  fmi2StepFinished stepFinished;
  /** Passed back to the logger. */
  fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

/** A saved state of an instance. */
typedef void *fmi2FMUstate;

/** Byte of a serialised state. */
typedef char fmi2Byte;

/** Kinds of status for fmi2GetXXXStatus. */
typedef int fmi2StatusKind;

/** Integer, also used for enumerations. */
typedef int fmi2Integer;

/** Handle of a variable: its column in the table of the model. */
typedef unsigned int fmi2ValueReference;

/** True. */
#define fmi2True 1

/** False. */
#define fmi2False 0

/** Model exchange. */
#define fmi2ModelExchange 0

/** Co-simulation. */
#define fmi2CoSimulation 1

/** Result of an asynchronous step. */
#define fmi2DoStepStatus 0

/** Text about an asynchronous step. */
#define fmi2PendingStatus 1

/** End of the last completed step. */
#define fmi2LastSuccessfulTime 2

/** Whether the instance wants to end the simulation. */
#define fmi2Terminated 3

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/** Version of the library, such as "0.1.0". */
const char *stribeck_version(void);

/** Number of models of the library. */
size_t stribeck_model_count(void);

/** Name of the model with this index, from 0; NULL beyond the last. The text lives as long as the library. */
const char *stribeck_model_name(size_t index);

/**
 * Meaning of a status, in a few words. The text lives as long as the library.
 *
 * Takes an `int`, because a number outside the enum must be harmless.
 */
const char *stribeck_status_text(int status);

/**
 * Makes a model at its start values and writes its handle to `*model`, or NULL on failure. The handle must be freed
 * once with stribeck_free.
 */
stribeck_status stribeck_create(const char *name, stribeck_model **model);

/** Frees a model. NULL is ignored. */
void stribeck_free(stribeck_model *model);

/**
 * Reason why the last refused call on this handle was refused. The text lives until the next call on the handle. For
 * NULL it says that the handle is NULL; the only reason given by a failed stribeck_create is its status.
 */
const char *stribeck_last_error(const stribeck_model *model);

/** Resets the model to its start values and to time 0. */
stribeck_status stribeck_reset(stribeck_model *model);

/** Number of columns, that is, of variables; 0 for NULL. */
uint32_t stribeck_column_count(const stribeck_model *model);

/** Column of the variable with this name. The enums of this header hold the same numbers. */
stribeck_status stribeck_find(stribeck_model *model, const char *variable, uint32_t *column);

/** Describes a column: name, unit, help text, role, kind, start value and bounds. */
stribeck_status stribeck_describe(stribeck_model *model, uint32_t column, stribeck_variable *variable);

/** Number of presets, that is, named parameter sets, of the model; 0 for NULL. */
size_t stribeck_preset_count(const stribeck_model *model);

/** Name of the preset with this index, from 0; NULL beyond the last. The text belongs to the handle. */
const char *stribeck_preset_name(const stribeck_model *model, size_t index);

/** Source of the values of the preset with this index; NULL beyond the last. The text belongs to the handle. */
const char *stribeck_preset_source(const stribeck_model *model, size_t index);

/**
 * Sets all parameters: those in the named preset to its values, the others to their start values. Inputs in the preset
 * are set as well.
 */
stribeck_status stribeck_apply_preset(stribeck_model *model, const char *preset);

/** Sets a variable. Everything except computed results can be set at any time; outputs follow at once. */
stribeck_status stribeck_set(stribeck_model *model, uint32_t column, double value);

/** Reads a variable; results are computed first if anything has been set since. */
stribeck_status stribeck_get(stribeck_model *model, uint32_t column, double *value);

/** As stribeck_set, by name. Slower: look the column up once with stribeck_find if it is set often. */
stribeck_status stribeck_set_by_name(stribeck_model *model, const char *variable, double value);

/** As stribeck_get, by name. */
stribeck_status stribeck_get_by_name(stribeck_model *model, const char *variable, double *value);

/** Advances the model by `dt` > 0 seconds with held inputs and computes the results. */
stribeck_status stribeck_step(stribeck_model *model, double dt);

/** Computes the results now, and checks that the parameters fit together and the results are finite. */
stribeck_status stribeck_output(stribeck_model *model);

/** Time since creation or reset, in seconds; NaN for NULL. */
double stribeck_time(const stribeck_model *model);

/**
 * Partial derivative of a result with respect to an input, parameter or state, at the present values: exact, except
 * for the friction of ShockAbsorber before its first step, which is differentiated numerically.
 */
stribeck_status stribeck_derivative(stribeck_model *model, uint32_t output, uint32_t input, double *value);

/** Number of bytes that stribeck_save writes; 0 for NULL. */
size_t stribeck_state_size(const stribeck_model *model);

/** Writes the complete state of the model, including parameters and time, as bytes that any process can read. */
stribeck_status stribeck_save(stribeck_model *model, void *buffer, size_t size);

/**
 * Restores a saved state of this or of another instance of the same model. Foreign or damaged bytes are refused, and
 * so is a state that only events of Model Exchange can produce (`phase`).
 */
stribeck_status stribeck_restore(stribeck_model *model, const void *buffer, size_t size);

/**
 * Warning about the present values, if some were accepted although they make no sense, such as an unconnected input at
 * 0; otherwise an empty text. Best called after the first step; the library does not report warnings by itself. The
 * text lives until the next call of this function on the handle. For NULL it says that the handle is NULL.
 */
const char *stribeck_warning(stribeck_model *model);

/** Enters event mode, in which inputs may jump. */
fmi2Status fmi2EnterEventMode(fmi2Component c);

/**
 * Applies the changes of an event: one call is enough. No model knows the time of its next event or ends the
 * simulation.
 */
fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *eventInfo);

/** Enters continuous-time mode, in which time and states move. */
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c);

/** Completes a step of the importer's solver. Requests an event if a result that jumps has a new value. */
fmi2Status fmi2CompletedIntegratorStep(fmi2Component c,
                                       fmi2Boolean noSetFMUStatePriorToCurrentPoint,
                                       fmi2Boolean *enterEventMode,
                                       fmi2Boolean *terminateSimulation);

/** Sets the present time. */
fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time);

/** Sets the states: all, or none with fmi2Discard if one is not finite. */
fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real *x, size_t nx);

/**
 * Time derivatives of the states. If one is not finite: fmi2Discard at and between events, where the solver may try a
 * smaller step, otherwise fmi2Error.
 */
fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real *derivatives, size_t nx);

/**
 * Functions that change sign where derivatives or outputs jump. If one is not finite: fmi2Discard at and between
 * events, otherwise fmi2Error.
 */
fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real *eventIndicators, size_t ni);

/** The states. */
fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real *x, size_t nx);

/** The nominal values of the states. */
fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real *x_nominal, size_t nx);

/** The platform of the types: "default". */
fmi2String fmi2GetTypesPlatform(void);

/** The version of the interface: "2.0". */
fmi2String fmi2GetVersion(void);

/**
 * Makes an instance of the model whose guid is `fmuGUID`, to be freed once with fmi2FreeInstance.
 *
 * `fmuType` must be `fmi2CoSimulation` or, for models that support it, `fmi2ModelExchange`. `callbacks` is copied; its
 * function pointers may all be NULL. `fmuResourceLocation` and `visible` are not used. Returns NULL, and logs the
 * reason, if the guid does not belong to a model of this library, if the model does not support that type, if the name
 * is blank, or if memory runs out; silently if `callbacks` is NULL, as there is no logger.
 */
fmi2Component fmi2Instantiate(fmi2String instanceName,
                              fmi2Type fmuType,
                              fmi2String fmuGUID,
                              fmi2String fmuResourceLocation,
                              const fmi2CallbackFunctions *callbacks,
                              fmi2Boolean visible,
                              fmi2Boolean loggingOn);

/** Frees an instance. NULL is ignored. */
void fmi2FreeInstance(fmi2Component c);

/**
 * Switches log categories (`logStatusWarning`, `logStatusDiscard`, `logStatusError`, `logAll`); all of them if
 * `nCategories` is 0. Before this call, errors, refused values and warnings are logged even if `loggingOn` of
 * fmi2Instantiate was false; values refused in a solver's trials only if it was true.
 */
fmi2Status fmi2SetDebugLogging(fmi2Component c,
                               fmi2Boolean loggingOn,
                               size_t nCategories,
                               const fmi2String *categories);

/**
 * Declares start time and, if defined, stop time, which no step may exceed. The tolerance is only checked: the steps
 * are exact or keep a tighter tolerance of their own.
 */
fmi2Status fmi2SetupExperiment(fmi2Component c,
                               fmi2Boolean toleranceDefined,
                               fmi2Real tolerance,
                               fmi2Real startTime,
                               fmi2Boolean stopTimeDefined,
                               fmi2Real stopTime);

/** Enters initialization mode, in which inputs are set and outputs read at the start time. */
fmi2Status fmi2EnterInitializationMode(fmi2Component c);

/**
 * Ends the initialization: parameters must now fit together, outputs must be finite. Model Exchange continues in event
 * mode; the states left undetermined by the start values are set, and the first fmi2NewDiscreteStates reports whether
 * states jumped.
 */
fmi2Status fmi2ExitInitializationMode(fmi2Component c);

/** Ends the simulation run. Results can still be read. */
fmi2Status fmi2Terminate(fmi2Component c);

/** Resets to the state after fmi2Instantiate: start values, no experiment, time 0. Log settings are kept. */
fmi2Status fmi2Reset(fmi2Component c);

/**
 * Saves the state. `*FMUstate` must be NULL, to make a new one, or an earlier state, to overwrite it. The state must
 * be freed once with fmi2FreeFMUstate.
 */
fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *FMUstate);

/**
 * Restores a saved state of this or of another instance of the same model. The state can be used again. Co-simulation
 * refuses a state that only events can produce (`phase`).
 */
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate FMUstate);

/** Frees a saved state and sets the pointer to NULL. A pointer to NULL is ignored, as is NULL. */
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *FMUstate);

/** Number of bytes that fmi2SerializeFMUstate writes. */
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate FMUstate, size_t *size);

/**
 * Writes a saved state as bytes that another process, even on another platform, can read. Equal states give equal
 * bytes.
 */
fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate FMUstate, fmi2Byte *serializedState, size_t size);

/** Makes a saved state from bytes. Foreign, truncated and damaged bytes are refused. */
fmi2Status fmi2DeSerializeFMUstate(fmi2Component c,
                                   const fmi2Byte *serializedState,
                                   size_t size,
                                   fmi2FMUstate *FMUstate);

/**
 * Advances the instance by `communicationStepSize` > 0. Inputs are held, or move with the slopes of
 * fmi2SetRealInputDerivatives. On an error nothing has changed.
 */
fmi2Status fmi2DoStep(fmi2Component c,
                      fmi2Real currentCommunicationPoint,
                      fmi2Real communicationStepSize,
                      fmi2Boolean noSetFMUStatePriorToCurrentPoint);

/** Always an error: steps are never pending. */
fmi2Status fmi2CancelStep(fmi2Component c);

/** Always fmi2Discard: there are no asynchronous steps. */
fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind s, fmi2Status *value);

/** `fmi2LastSuccessfulTime`: the end of the last completed step. fmi2Discard for other kinds. */
fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind s, fmi2Real *value);

/** Always fmi2Discard: there is no integer status. */
fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind s, fmi2Integer *value);

/** `fmi2Terminated`: no model ends the simulation, so fmi2False. fmi2Discard for other kinds. */
fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind s, fmi2Boolean *value);

/** Always fmi2Discard: there is no asynchronous step to ask about. */
fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind s, fmi2String *value);

/** Reads Real variables. */
fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, fmi2Real *value);

/** Reads Integer and Enumeration variables. */
fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, fmi2Integer *value);

/** Reads Boolean variables. */
fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, fmi2Boolean *value);

/** Reads String variables; no model has any, so only `nvr` = 0 succeeds. */
fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, fmi2String *value);

/** Sets Real variables: all, or none if one is refused. fmi2Discard if a value is outside its bound. */
fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, const fmi2Real *value);

/** Sets Integer and Enumeration variables, as fmi2SetReal does. */
fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, const fmi2Integer *value);

/** Sets Boolean variables, as fmi2SetReal does; only `fmi2False` and `fmi2True` are accepted. */
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, const fmi2Boolean *value);

/** Sets String variables; no model has any, so only `nvr` = 0 succeeds. */
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, const fmi2String *value);

/** Gives inputs a slope over the next step (order 1 only). It is used for that step, and then forgotten. */
fmi2Status fmi2SetRealInputDerivatives(fmi2Component c,
                                       const fmi2ValueReference *vr,
                                       size_t nvr,
                                       const fmi2Integer *order,
                                       const fmi2Real *value);

/** Time derivatives of outputs at the present time: order 1 exact, higher orders 0 as the standard requires. */
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c,
                                        const fmi2ValueReference *vr,
                                        size_t nvr,
                                        const fmi2Integer *order,
                                        fmi2Real *value);

/**
 * Derivative of outputs, and of the time derivatives of the states, in a direction of inputs, parameters and states:
 * exact, by automatic differentiation, except for the friction of ShockAbsorber before the run, which is
 * differentiated numerically.
 */
fmi2Status fmi2GetDirectionalDerivative(fmi2Component c,
                                        const fmi2ValueReference *vUnknown_ref,
                                        size_t nUnknown,
                                        const fmi2ValueReference *vKnown_ref,
                                        size_t nKnown,
                                        const fmi2Real *dvKnown,
                                        fmi2Real *dvUnknown);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

/** Choices of a variable of the type BengisuAkayVariant. */
typedef enum stribeck_bengisu_akay_variant {
  /** Product of two exponentials, as printed in the thesis. */
  STRIBECK_BENGISU_AKAY_VARIANT_THESIS = 1,
  /** Parabola up to the peak, exponential beyond it, as in Marques et al. (2016). */
  STRIBECK_BENGISU_AKAY_VARIANT_MARQUES = 2,
} stribeck_bengisu_akay_variant;

/** Choices of a variable of the type BlimanSorineOrder. */
typedef enum stribeck_bliman_sorine_order {
  /** One relaxation: Coulomb friction with pre-sliding displacement. */
  STRIBECK_BLIMAN_SORINE_ORDER_FIRST = 1,
  /** Two relaxations: a peak of the force before steady sliding. */
  STRIBECK_BLIMAN_SORINE_ORDER_SECOND = 2,
} stribeck_bliman_sorine_order;

/** Choices of a variable of the type BumpMode. */
typedef enum stribeck_bump_mode {
  /** Proportional to its compression. */
  STRIBECK_BUMP_MODE_LINEAR = 1,
  /** A power of its compression. */
  STRIBECK_BUMP_MODE_POWER = 2,
  /** A cubic polynomial of its compression. */
  STRIBECK_BUMP_MODE_CUBIC = 3,
} stribeck_bump_mode;

/** Choices of a variable of the type CoulombViscousVariant. */
typedef enum stribeck_coulomb_viscous_variant {
  /** The viscous part is proportional to velocity. */
  STRIBECK_COULOMB_VISCOUS_VARIANT_LINEAR = 1,
  /** The viscous part is a power of speed. */
  STRIBECK_COULOMB_VISCOUS_VARIANT_POWER = 2,
} stribeck_coulomb_viscous_variant;

/** Choices of a variable of the type DamperMode. */
typedef enum stribeck_damper_mode {
  /** Proportional to the velocity, with two coefficients. */
  STRIBECK_DAMPER_MODE_LINEAR = 1,
  /** A table over the velocity. */
  STRIBECK_DAMPER_MODE_TABLE = 2,
  /** Falling slope: c v / (1 + d |v|). */
  STRIBECK_DAMPER_MODE_DEGRESSIVE = 3,
} stribeck_damper_mode;

/** Choices of a variable of the type ElementDistribution. */
typedef enum stribeck_element_distribution {
  /** The shares of each element are given. */
  STRIBECK_ELEMENT_DISTRIBUTION_EXPLICIT = 1,
  /** Equal stiffness and evenly spaced slip displacements: the virgin curve is nearly a parabola. */
  STRIBECK_ELEMENT_DISTRIBUTION_UNIFORM = 2,
} stribeck_element_distribution;

/** Choices of a variable of the type Exchange. */
typedef enum stribeck_exchange {
  /** The friction model steps first, and the host uses the force of that step (Gauss-Seidel). */
  STRIBECK_EXCHANGE_SEQUENTIAL = 1,
  /** All models step at once and exchange values afterwards, so the force acts one step later (Jacobi). */
  STRIBECK_EXCHANGE_PARALLEL = 2,
} stribeck_exchange;

/** Choices of a variable of the type FrictionModel. */
typedef enum stribeck_friction_model {
  /** No friction. */
  STRIBECK_FRICTION_MODEL_NONE = 1,
  /** Coulomb friction */
  STRIBECK_FRICTION_MODEL_COULOMB = 2,
  /** Coulomb friction with stiction */
  STRIBECK_FRICTION_MODEL_COULOMB_STICTION = 3,
  /** Coulomb friction with a viscous part */
  STRIBECK_FRICTION_MODEL_COULOMB_VISCOUS = 4,
  /** Friction that falls with speed from the static to the kinetic level (Stribeck) */
  STRIBECK_FRICTION_MODEL_STRIBECK = 5,
  /** Coulomb friction with a linear transition, by its slope (Bernard) */
  STRIBECK_FRICTION_MODEL_BERNARD = 6,
  /** Coulomb friction with an exponential transition (Threlfall) */
  STRIBECK_FRICTION_MODEL_THRELFALL = 7,
  /** Coulomb friction with an exponential transition up to the Coulomb level (modified Threlfall) */
  STRIBECK_FRICTION_MODEL_THRELFALL_MODIFIED = 8,
  /** Coulomb friction with a transition band (Rooney and Deravi) */
  STRIBECK_FRICTION_MODEL_ROONEY_DERAVI = 9,
  /** Coulomb friction that is ramped up with speed (Ambrosio) */
  STRIBECK_FRICTION_MODEL_AMBROSIO = 10,
  /** Coulomb friction with a band of stiction (Karnopp) */
  STRIBECK_FRICTION_MODEL_KARNOPP = 11,
  /** Continuous friction law with a stiction peak (Bengisu and Akay) */
  STRIBECK_FRICTION_MODEL_BENGISU_AKAY = 12,
  /** Continuous friction law with a stiction peak, without exponentials (Hollars) */
  STRIBECK_FRICTION_MODEL_HOLLARS = 13,
  /** Smooth friction law with the Stribeck curve (Andersson) */
  STRIBECK_FRICTION_MODEL_ANDERSSON = 14,
  /** Continuous friction law that holds a load at rest (Awrejcewicz, Grzelczyk and Pyryev) */
  STRIBECK_FRICTION_MODEL_AWREJCEWICZ = 15,
  /** Smooth friction law that passes through the static level (Specker) */
  STRIBECK_FRICTION_MODEL_SPECKER = 16,
  /** Friction law with stiction made of three straight lines */
  STRIBECK_FRICTION_MODEL_LINEAR_STICTION = 17,
  /** Smooth friction law with a stiction peak (Brown and McPhee) */
  STRIBECK_FRICTION_MODEL_BROWN_MC_PHEE = 18,
  /** Pre-sliding displacement with hysteresis (Dahl) */
  STRIBECK_FRICTION_MODEL_DAHL = 19,
  /** Bristle friction with Stribeck effect (LuGre) */
  STRIBECK_FRICTION_MODEL_LU_GRE = 20,
  /** Stribeck friction that lags behind the velocity (Hess and Soom) */
  STRIBECK_FRICTION_MODEL_FRICTIONAL_LAG = 21,
  /** Stick, slip, lag and rising static friction with seven parameters (Armstrong-Helouvry) */
  STRIBECK_FRICTION_MODEL_ARMSTRONG = 22,
  /** Different friction while speeding up and slowing down (reconstructed) */
  STRIBECK_FRICTION_MODEL_NON_REVERSIBLE = 23,
  /** Hysteretic friction: stuck spring, two branches of sliding (reconstructed after Wojewoda) */
  STRIBECK_FRICTION_MODEL_WOJEWODA = 24,
  /** Pre-sliding displacement and breakaway peak in the sliding distance (Bliman-Sorine) */
  STRIBECK_FRICTION_MODEL_BLIMAN_SORINE = 25,
  /** Bond that breaks at the static level (reset integrator) */
  STRIBECK_FRICTION_MODEL_RESET_INTEGRATOR = 26,
  /** Pre-sliding displacement of sheared asperities (Dankowicz, reconstructed) */
  STRIBECK_FRICTION_MODEL_DANKOWICZ = 27,
  /** Bristle friction without drift below breakaway (elasto-plastic) */
  STRIBECK_FRICTION_MODEL_ELASTO_PLASTIC = 28,
  /** Bonds that snap and form again at random (bristle model) */
  STRIBECK_FRICTION_MODEL_BRISTLE = 29,
  /** Smooth friction law with a velocity-dependent lag (Specker, reconstructed) */
  STRIBECK_FRICTION_MODEL_SPECKER_DYNAMIC = 30,
  /** Elements that stick or slip, with hysteresis of pre-sliding (generalised Maxwell-slip, GMS) */
  STRIBECK_FRICTION_MODEL_MAXWELL_SLIP = 31,
  /** Bristle friction with hysteresis of pre-sliding (Leuven, in the form of Lampaert) */
  STRIBECK_FRICTION_MODEL_LEUVEN = 32,
  /** Bristle friction with dwell time (Gonthier) */
  STRIBECK_FRICTION_MODEL_GONTHIER = 33,
} stribeck_friction_model;

/** Choices of a variable of the type FrictionStart. */
typedef enum stribeck_friction_start {
  /** State after one second at the initial velocity: steady sliding, or rest. */
  STRIBECK_FRICTION_START_STEADY = 1,
  /** Contacts at rest, without load. */
  STRIBECK_FRICTION_START_ZERO = 2,
  /** Start values of memory_1 and memory_2. */
  STRIBECK_FRICTION_START_VALUE = 3,
} stribeck_friction_start;

/** Choices of a variable of the type FrictionSwitch. */
typedef enum stribeck_friction_switch {
  /** The complete law. */
  STRIBECK_FRICTION_SWITCH_ON = 1,
  /** Static level equal to the kinetic one, as if mu_s were mu_k and preload_s were preload_k. */
  STRIBECK_FRICTION_SWITCH_NO_STICTION = 2,
  /** Only the viscous part, as if coefficients and preloads were 0. */
  STRIBECK_FRICTION_SWITCH_VISCOUS_ONLY = 3,
  /** No friction, as if the model were None. */
  STRIBECK_FRICTION_SWITCH_OFF = 4,
} stribeck_friction_switch;

/** Choices of a variable of the type FrictionalLagVariant. */
typedef enum stribeck_frictional_lag_variant {
  /** The force follows the velocity one time lag earlier. */
  STRIBECK_FRICTIONAL_LAG_VARIANT_DELAY = 1,
  /** The force follows the velocity through a first-order filter. */
  STRIBECK_FRICTIONAL_LAG_VARIANT_FIRST_ORDER = 2,
} stribeck_frictional_lag_variant;

/** Choices of a variable of the type InitialBonds. */
typedef enum stribeck_initial_bonds {
  /** All are bonded in place, so they snap together at the first breakaway. */
  STRIBECK_INITIAL_BONDS_BONDED = 1,
  /** As after a long slide in the direction of the first motion. */
  STRIBECK_INITIAL_BONDS_STATIONARY = 2,
} stribeck_initial_bonds;

/** Choices of a variable of the type InputMode. */
typedef enum stribeck_input_mode {
  /** They are held. */
  STRIBECK_INPUT_MODE_HOLD = 1,
  /** The length moves with the velocity, the velocity with the acceleration. */
  STRIBECK_INPUT_MODE_LINEAR = 2,
} stribeck_input_mode;

/** Choices of a variable of the type Interpolation. */
typedef enum stribeck_interpolation {
  /** Straight lines. */
  STRIBECK_INTERPOLATION_LINEAR = 1,
  /** Monotone cubic: smooth, without overshoot. */
  STRIBECK_INTERPOLATION_CUBIC = 2,
} stribeck_interpolation;

/** Choices of a variable of the type LiangVariant. */
typedef enum stribeck_liang_variant {
  /** The deflection keeps its direction and is shortened: the force is continuous. */
  STRIBECK_LIANG_VARIANT_RADIAL_RETURN = 1,
  /** The deflection takes the direction of the velocity, as printed: the force can jump. */
  STRIBECK_LIANG_VARIANT_PRINTED = 2,
} stribeck_liang_variant;

/** Choices of a variable of the type NormalSum. */
typedef enum stribeck_normal_sum {
  /** Each contact has its own load, found as a vector. */
  STRIBECK_NORMAL_SUM_TWO_POINT = 1,
  /** Magnitudes of force and bending moment over overlap are added and shared equally, as Adams does. */
  STRIBECK_NORMAL_SUM_ADAMS = 2,
} stribeck_normal_sum;

/** Choices of a variable of the type Phase. */
typedef enum stribeck_phase {
  /** Determined by the velocity: no event has set it, as in co-simulation. */
  STRIBECK_PHASE_FREE = 1,
  /** Held, or within the band around rest. */
  STRIBECK_PHASE_HELD = 2,
  /** Slides with positive velocity. */
  STRIBECK_PHASE_FORWARD = 3,
  /** Slides with negative velocity. */
  STRIBECK_PHASE_BACKWARD = 4,
} stribeck_phase;

/** Choices of a variable of the type RooneyDeraviVariant. */
typedef enum stribeck_rooney_deravi_variant {
  /** Hyperbolic tangent inside the band, as printed in the thesis; jumps at the end of the band. */
  STRIBECK_ROONEY_DERAVI_VARIANT_PRINTED = 1,
  /** Straight line inside the band. */
  STRIBECK_ROONEY_DERAVI_VARIANT_LINEAR = 2,
  /** Hyperbolic tangent for all velocities. */
  STRIBECK_ROONEY_DERAVI_VARIANT_TANH = 3,
} stribeck_rooney_deravi_variant;

/** Choices of a variable of the type Side. */
typedef enum stribeck_side {
  /** The set describes a left tyre; right tyres are its mirror image. */
  STRIBECK_SIDE_LEFT = 1,
  /** The set describes a right tyre; left tyres are its mirror image. */
  STRIBECK_SIDE_RIGHT = 2,
} stribeck_side;

/** Choices of a variable of the type SideConvention. */
typedef enum stribeck_side_convention {
  /** Transverse force and moment of the tube on the rod, reduced to the eye of the tube. */
  STRIBECK_SIDE_CONVENTION_WRENCH_ON_ROD = 1,
  /** Lagrange multipliers of the joint, of the rows m.d, n.d, m.a and n.a. */
  STRIBECK_SIDE_CONVENTION_LAMBDA = 2,
} stribeck_side_convention;

/** Choices of a variable of the type SideMode. */
typedef enum stribeck_side_mode {
  /** The four inputs. */
  STRIBECK_SIDE_MODE_INPUTS = 1,
  /** Loads from the spring: offset of its line of action and side force. */
  STRIBECK_SIDE_MODE_INTERNAL = 2,
  /** Both. */
  STRIBECK_SIDE_MODE_SUM = 3,
} stribeck_side_mode;

/** Choices of a variable of the type SpringMode. */
typedef enum stribeck_spring_mode {
  /** Proportional to the compression. */
  STRIBECK_SPRING_MODE_LINEAR = 1,
  /** Straight lines between the points of a table. */
  STRIBECK_SPRING_MODE_TABLE = 2,
} stribeck_spring_mode;

/** Choices of a variable of the type StribeckCurve. */
typedef enum stribeck_stribeck_curve {
  /** Exponential of speed. */
  STRIBECK_STRIBECK_CURVE_TUSTIN = 1,
  /** Exponential of a power of speed, with stribeck_exponent. */
  STRIBECK_STRIBECK_CURVE_BO_PAVELESCU = 2,
  /** Lorentzian; half of the excess is left at stribeck_velocity. */
  STRIBECK_STRIBECK_CURVE_HESS_SOOM = 3,
  /** Hyperbola; half of the excess is left at stribeck_velocity. A quadratic part may be added. */
  STRIBECK_STRIBECK_CURVE_POPP_STELTER = 4,
  /** Exponential of the square of speed. */
  STRIBECK_STRIBECK_CURVE_GAUSSIAN = 5,
} stribeck_stribeck_curve;

/** Choices of a variable of the type ThrelfallVariant. */
typedef enum stribeck_threlfall_variant {
  /** The exponential for all velocities, as printed in the thesis. */
  STRIBECK_THRELFALL_VARIANT_PRINTED = 1,
  /** The original, which stops at 95 % of the Coulomb level. */
  STRIBECK_THRELFALL_VARIANT_CAPPED = 2,
} stribeck_threlfall_variant;

/** Guid of Coulomb for fmi2Instantiate. */
#define STRIBECK_COULOMB_GUID "{bbeced28-4358-a1f2-3f23-1a453d227502}"

/** Coulomb: Coulomb friction. Columns of "Coulomb". */
typedef enum stribeck_coulomb_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_COULOMB_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_COULOMB_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_COULOMB_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_COULOMB_MU_K = 3,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_COULOMB_MASS = 4,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_COULOMB_EXCHANGE = 5,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_COULOMB_STEP_SIZE = 6,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_COULOMB_PLANNING_STEP = 7,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_COULOMB_PLANNED_FORCE = 8,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_COULOMB_END_VELOCITY = 9,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_COULOMB_END_EXTERNAL_FORCE = 10,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_COULOMB_END_NORMAL_FORCE = 11,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_VELOCITY_CHANGE = 12,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_EXTERNAL_FORCE_CHANGE = 13,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_NORMAL_FORCE_CHANGE = 14,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_COULOMB_PHASE = 15,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_COULOMB_DISSIPATED_ENERGY = 16,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_COULOMB_FRICTION_FORCE = 17,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_COULOMB_DISSIPATED_POWER = 18,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_COULOMB_STICKING = 19,
} stribeck_coulomb_variable;

/** Guid of CoulombStiction for fmi2Instantiate. */
#define STRIBECK_COULOMB_STICTION_GUID "{ad4b3d5c-d393-488b-8284-a119076e3e83}"

/** CoulombStiction: Coulomb friction with stiction. Columns of "CoulombStiction". */
typedef enum stribeck_coulomb_stiction_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_COULOMB_STICTION_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_COULOMB_STICTION_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_COULOMB_STICTION_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_COULOMB_STICTION_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_COULOMB_STICTION_MU_S = 4,
  /** state [Boolean]: Is the contact stuck since the last step? Only with mass > 0; in Model Exchange see phase.
   *  (default false) */
  STRIBECK_COULOMB_STICTION_STUCK = 5,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_MASS = 6,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_COULOMB_STICTION_EXCHANGE = 7,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_STEP_SIZE = 8,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_PLANNING_STEP = 9,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_COULOMB_STICTION_PLANNED_FORCE = 10,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_COULOMB_STICTION_END_VELOCITY = 11,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_COULOMB_STICTION_END_EXTERNAL_FORCE = 12,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_END_NORMAL_FORCE = 13,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_STICTION_VELOCITY_CHANGE = 14,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_STICTION_EXTERNAL_FORCE_CHANGE = 15,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_STICTION_NORMAL_FORCE_CHANGE = 16,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_COULOMB_STICTION_PHASE = 17,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_COULOMB_STICTION_DISSIPATED_ENERGY = 18,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_COULOMB_STICTION_FRICTION_FORCE = 19,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_COULOMB_STICTION_DISSIPATED_POWER = 20,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_COULOMB_STICTION_STICKING = 21,
} stribeck_coulomb_stiction_variable;

/** Guid of CoulombViscous for fmi2Instantiate. */
#define STRIBECK_COULOMB_VISCOUS_GUID "{61230f08-6eaa-471e-9f27-4eb4bf62e45f}"

/** CoulombViscous: Coulomb friction with a viscous part. Columns of "CoulombViscous". */
typedef enum stribeck_coulomb_viscous_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_COULOMB_VISCOUS_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_COULOMB_VISCOUS_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_COULOMB_VISCOUS_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_COULOMB_VISCOUS_MU_K = 3,
  /** fixed [stribeck_coulomb_viscous_variant]: Variant of the law. (default Linear) */
  STRIBECK_COULOMB_VISCOUS_VARIANT = 4,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_COULOMB_VISCOUS_VISCOUS_COEFFICIENT = 5,
  /** tunable [1]: Exponent of the viscous part. (> 0, default 1) */
  STRIBECK_COULOMB_VISCOUS_VISCOUS_EXPONENT = 6,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_COULOMB_VISCOUS_MASS = 7,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_COULOMB_VISCOUS_EXCHANGE = 8,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_COULOMB_VISCOUS_STEP_SIZE = 9,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_COULOMB_VISCOUS_PLANNING_STEP = 10,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_COULOMB_VISCOUS_PLANNED_FORCE = 11,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_COULOMB_VISCOUS_END_VELOCITY = 12,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_COULOMB_VISCOUS_END_EXTERNAL_FORCE = 13,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_COULOMB_VISCOUS_END_NORMAL_FORCE = 14,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_VISCOUS_VELOCITY_CHANGE = 15,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_VISCOUS_EXTERNAL_FORCE_CHANGE = 16,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_VISCOUS_NORMAL_FORCE_CHANGE = 17,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_COULOMB_VISCOUS_PHASE = 18,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_COULOMB_VISCOUS_DISSIPATED_ENERGY = 19,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_COULOMB_VISCOUS_FRICTION_FORCE = 20,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_COULOMB_VISCOUS_DISSIPATED_POWER = 21,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_COULOMB_VISCOUS_STICKING = 22,
} stribeck_coulomb_viscous_variable;

/** Guid of Stribeck for fmi2Instantiate. */
#define STRIBECK_STRIBECK_GUID "{1338417f-b372-978d-fe96-9f97c79779d9}"

/** Stribeck: Friction that falls with speed from the static to the kinetic level (Stribeck). Columns of "Stribeck". */
typedef enum stribeck_stribeck_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_STRIBECK_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_STRIBECK_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_STRIBECK_EXTERNAL_FORCE = 2,
  /** fixed [stribeck_stribeck_curve]: How the level falls with speed. (default Gaussian) */
  STRIBECK_STRIBECK_CURVE = 3,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_STRIBECK_MU_K = 4,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_STRIBECK_MU_S = 5,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_STRIBECK_STRIBECK_VELOCITY = 6,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_STRIBECK_STRIBECK_EXPONENT = 7,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_STRIBECK_VISCOUS_COEFFICIENT = 8,
  /** tunable [N.s2/m2]: Quadratic friction coefficient; used by PoppStelter. (>= 0, default 0) */
  STRIBECK_STRIBECK_QUADRATIC_COEFFICIENT = 9,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_STRIBECK_MASS = 10,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_STRIBECK_EXCHANGE = 11,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_STRIBECK_STEP_SIZE = 12,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_STRIBECK_PLANNING_STEP = 13,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_STRIBECK_PLANNED_FORCE = 14,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_STRIBECK_END_VELOCITY = 15,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_STRIBECK_END_EXTERNAL_FORCE = 16,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_STRIBECK_END_NORMAL_FORCE = 17,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_STRIBECK_VELOCITY_CHANGE = 18,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_STRIBECK_EXTERNAL_FORCE_CHANGE = 19,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_STRIBECK_NORMAL_FORCE_CHANGE = 20,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_STRIBECK_PHASE = 21,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_STRIBECK_DISSIPATED_ENERGY = 22,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_STRIBECK_FRICTION_FORCE = 23,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_STRIBECK_DISSIPATED_POWER = 24,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_STRIBECK_STICKING = 25,
} stribeck_stribeck_variable;

/** Guid of Bernard for fmi2Instantiate. */
#define STRIBECK_BERNARD_GUID "{6c351125-3a0f-4eff-7385-830ef8bb9be8}"

/** Bernard: Coulomb friction with a linear transition, by its slope (Bernard). Columns of "Bernard". */
typedef enum stribeck_bernard_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BERNARD_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BERNARD_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_BERNARD_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BERNARD_MU_K = 3,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 2000) */
  STRIBECK_BERNARD_TRANSITION_SLOPE = 4,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_BERNARD_MASS = 5,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_BERNARD_EXCHANGE = 6,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_BERNARD_STEP_SIZE = 7,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_BERNARD_PLANNING_STEP = 8,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_BERNARD_PLANNED_FORCE = 9,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_BERNARD_END_VELOCITY = 10,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_BERNARD_END_EXTERNAL_FORCE = 11,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_BERNARD_END_NORMAL_FORCE = 12,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BERNARD_VELOCITY_CHANGE = 13,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BERNARD_EXTERNAL_FORCE_CHANGE = 14,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BERNARD_NORMAL_FORCE_CHANGE = 15,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_BERNARD_PHASE = 16,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BERNARD_DISSIPATED_ENERGY = 17,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BERNARD_FRICTION_FORCE = 18,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BERNARD_DISSIPATED_POWER = 19,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BERNARD_STICKING = 20,
} stribeck_bernard_variable;

/** Guid of Threlfall for fmi2Instantiate. */
#define STRIBECK_THRELFALL_GUID "{3e1459a0-12dc-ed88-4efa-d8479f088699}"

/** Threlfall: Coulomb friction with an exponential transition (Threlfall). Columns of "Threlfall". */
typedef enum stribeck_threlfall_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_THRELFALL_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_THRELFALL_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_THRELFALL_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_THRELFALL_MU_K = 3,
  /** fixed [stribeck_threlfall_variant]: Variant of the law. (default Printed) */
  STRIBECK_THRELFALL_VARIANT = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_THRELFALL_TRANSITION_VELOCITY = 5,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_THRELFALL_MASS = 6,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_THRELFALL_EXCHANGE = 7,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_THRELFALL_STEP_SIZE = 8,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_THRELFALL_PLANNING_STEP = 9,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_THRELFALL_PLANNED_FORCE = 10,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_THRELFALL_END_VELOCITY = 11,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_THRELFALL_END_EXTERNAL_FORCE = 12,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_THRELFALL_END_NORMAL_FORCE = 13,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_VELOCITY_CHANGE = 14,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_EXTERNAL_FORCE_CHANGE = 15,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_NORMAL_FORCE_CHANGE = 16,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_THRELFALL_PHASE = 17,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_THRELFALL_DISSIPATED_ENERGY = 18,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_THRELFALL_FRICTION_FORCE = 19,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_THRELFALL_DISSIPATED_POWER = 20,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_THRELFALL_STICKING = 21,
} stribeck_threlfall_variable;

/** Guid of ThrelfallModified for fmi2Instantiate. */
#define STRIBECK_THRELFALL_MODIFIED_GUID "{51d4042e-608e-5600-eead-99a5a0eae44a}"

/** ThrelfallModified: Coulomb friction with an exponential transition up to the Coulomb level (modified Threlfall). Columns of "ThrelfallModified". */
typedef enum stribeck_threlfall_modified_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_THRELFALL_MODIFIED_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_THRELFALL_MODIFIED_MU_K = 3,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_THRELFALL_MODIFIED_TRANSITION_VELOCITY = 4,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_THRELFALL_MODIFIED_MASS = 5,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_THRELFALL_MODIFIED_EXCHANGE = 6,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_THRELFALL_MODIFIED_STEP_SIZE = 7,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_THRELFALL_MODIFIED_PLANNING_STEP = 8,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_PLANNED_FORCE = 9,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_END_VELOCITY = 10,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_END_EXTERNAL_FORCE = 11,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_THRELFALL_MODIFIED_END_NORMAL_FORCE = 12,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_VELOCITY_CHANGE = 13,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_EXTERNAL_FORCE_CHANGE = 14,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_NORMAL_FORCE_CHANGE = 15,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_THRELFALL_MODIFIED_PHASE = 16,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_DISSIPATED_ENERGY = 17,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_THRELFALL_MODIFIED_FRICTION_FORCE = 18,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_THRELFALL_MODIFIED_DISSIPATED_POWER = 19,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_THRELFALL_MODIFIED_STICKING = 20,
} stribeck_threlfall_modified_variable;

/** Guid of RooneyDeravi for fmi2Instantiate. */
#define STRIBECK_ROONEY_DERAVI_GUID "{b4dda239-e67f-2c81-3c15-83dea4130273}"

/** RooneyDeravi: Coulomb friction with a transition band (Rooney and Deravi). Columns of "RooneyDeravi". */
typedef enum stribeck_rooney_deravi_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ROONEY_DERAVI_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ROONEY_DERAVI_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_ROONEY_DERAVI_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ROONEY_DERAVI_MU_K = 3,
  /** fixed [stribeck_rooney_deravi_variant]: Variant of the law. (default Linear) */
  STRIBECK_ROONEY_DERAVI_VARIANT = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_ROONEY_DERAVI_TRANSITION_VELOCITY = 5,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_ROONEY_DERAVI_MASS = 6,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_ROONEY_DERAVI_EXCHANGE = 7,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_ROONEY_DERAVI_STEP_SIZE = 8,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_ROONEY_DERAVI_PLANNING_STEP = 9,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_ROONEY_DERAVI_PLANNED_FORCE = 10,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_ROONEY_DERAVI_END_VELOCITY = 11,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_ROONEY_DERAVI_END_EXTERNAL_FORCE = 12,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_ROONEY_DERAVI_END_NORMAL_FORCE = 13,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROONEY_DERAVI_VELOCITY_CHANGE = 14,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROONEY_DERAVI_EXTERNAL_FORCE_CHANGE = 15,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROONEY_DERAVI_NORMAL_FORCE_CHANGE = 16,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_ROONEY_DERAVI_PHASE = 17,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ROONEY_DERAVI_DISSIPATED_ENERGY = 18,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ROONEY_DERAVI_FRICTION_FORCE = 19,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ROONEY_DERAVI_DISSIPATED_POWER = 20,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ROONEY_DERAVI_STICKING = 21,
} stribeck_rooney_deravi_variable;

/** Guid of Ambrosio for fmi2Instantiate. */
#define STRIBECK_AMBROSIO_GUID "{4ed7c963-b21e-ea39-2768-a00ac6df0ac9}"

/** Ambrosio: Coulomb friction that is ramped up with speed (Ambrosio). Columns of "Ambrosio". */
typedef enum stribeck_ambrosio_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_AMBROSIO_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_AMBROSIO_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_AMBROSIO_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_AMBROSIO_MU_K = 3,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (>= 0, default 0.0001) */
  STRIBECK_AMBROSIO_TRANSITION_VELOCITY = 4,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.001) */
  STRIBECK_AMBROSIO_SLIDING_VELOCITY = 5,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_AMBROSIO_MASS = 6,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_AMBROSIO_EXCHANGE = 7,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_AMBROSIO_STEP_SIZE = 8,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_AMBROSIO_PLANNING_STEP = 9,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_AMBROSIO_PLANNED_FORCE = 10,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_AMBROSIO_END_VELOCITY = 11,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_AMBROSIO_END_EXTERNAL_FORCE = 12,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_AMBROSIO_END_NORMAL_FORCE = 13,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AMBROSIO_VELOCITY_CHANGE = 14,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AMBROSIO_EXTERNAL_FORCE_CHANGE = 15,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AMBROSIO_NORMAL_FORCE_CHANGE = 16,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_AMBROSIO_PHASE = 17,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_AMBROSIO_DISSIPATED_ENERGY = 18,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_AMBROSIO_FRICTION_FORCE = 19,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_AMBROSIO_DISSIPATED_POWER = 20,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_AMBROSIO_STICKING = 21,
} stribeck_ambrosio_variable;

/** Guid of Karnopp for fmi2Instantiate. */
#define STRIBECK_KARNOPP_GUID "{11c8c491-0b58-eb8e-8204-f008d65d00cc}"

/** Karnopp: Coulomb friction with a band of stiction (Karnopp). Columns of "Karnopp". */
typedef enum stribeck_karnopp_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_KARNOPP_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_KARNOPP_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_KARNOPP_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_KARNOPP_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_KARNOPP_MU_S = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_KARNOPP_TRANSITION_VELOCITY = 5,
  /** state [Boolean]: Is the contact stuck since the last step? Only with mass > 0; in Model Exchange see phase.
   *  (default false) */
  STRIBECK_KARNOPP_STUCK = 6,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_KARNOPP_MASS = 7,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_KARNOPP_EXCHANGE = 8,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_KARNOPP_STEP_SIZE = 9,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_KARNOPP_PLANNING_STEP = 10,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_KARNOPP_PLANNED_FORCE = 11,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_KARNOPP_END_VELOCITY = 12,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_KARNOPP_END_EXTERNAL_FORCE = 13,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_KARNOPP_END_NORMAL_FORCE = 14,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_KARNOPP_VELOCITY_CHANGE = 15,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_KARNOPP_EXTERNAL_FORCE_CHANGE = 16,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_KARNOPP_NORMAL_FORCE_CHANGE = 17,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_KARNOPP_PHASE = 18,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_KARNOPP_DISSIPATED_ENERGY = 19,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_KARNOPP_FRICTION_FORCE = 20,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_KARNOPP_DISSIPATED_POWER = 21,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_KARNOPP_STICKING = 22,
} stribeck_karnopp_variable;

/** Guid of BengisuAkay for fmi2Instantiate. */
#define STRIBECK_BENGISU_AKAY_GUID "{b8b3d50e-4a59-d749-82cc-1a3ad906e311}"

/** BengisuAkay: Continuous friction law with a stiction peak (Bengisu and Akay). Columns of "BengisuAkay". */
typedef enum stribeck_bengisu_akay_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BENGISU_AKAY_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BENGISU_AKAY_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_BENGISU_AKAY_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BENGISU_AKAY_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_BENGISU_AKAY_MU_S = 4,
  /** fixed [stribeck_bengisu_akay_variant]: Variant of the law. (default Thesis) */
  STRIBECK_BENGISU_AKAY_VARIANT = 5,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 5000) */
  STRIBECK_BENGISU_AKAY_TRANSITION_SLOPE = 6,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 500) */
  STRIBECK_BENGISU_AKAY_STICTION_DECAY = 7,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_BENGISU_AKAY_TRANSITION_VELOCITY = 8,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_BENGISU_AKAY_MASS = 9,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_BENGISU_AKAY_EXCHANGE = 10,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_BENGISU_AKAY_STEP_SIZE = 11,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_BENGISU_AKAY_PLANNING_STEP = 12,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_BENGISU_AKAY_PLANNED_FORCE = 13,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_BENGISU_AKAY_END_VELOCITY = 14,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_BENGISU_AKAY_END_EXTERNAL_FORCE = 15,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_BENGISU_AKAY_END_NORMAL_FORCE = 16,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BENGISU_AKAY_VELOCITY_CHANGE = 17,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BENGISU_AKAY_EXTERNAL_FORCE_CHANGE = 18,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BENGISU_AKAY_NORMAL_FORCE_CHANGE = 19,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_BENGISU_AKAY_PHASE = 20,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BENGISU_AKAY_DISSIPATED_ENERGY = 21,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BENGISU_AKAY_FRICTION_FORCE = 22,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BENGISU_AKAY_DISSIPATED_POWER = 23,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BENGISU_AKAY_STICKING = 24,
} stribeck_bengisu_akay_variable;

/** Guid of Hollars for fmi2Instantiate. */
#define STRIBECK_HOLLARS_GUID "{897d132a-40f5-2444-8136-bac64cc732a1}"

/** Hollars: Continuous friction law with a stiction peak, without exponentials (Hollars). Columns of "Hollars". */
typedef enum stribeck_hollars_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_HOLLARS_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_HOLLARS_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_HOLLARS_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_HOLLARS_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_HOLLARS_MU_S = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_HOLLARS_TRANSITION_VELOCITY = 5,
  /** tunable [s/m]: Viscous coefficient of friction, per normal force. (>= 0, default 0) */
  STRIBECK_HOLLARS_MU_V = 6,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_HOLLARS_MASS = 7,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_HOLLARS_EXCHANGE = 8,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_HOLLARS_STEP_SIZE = 9,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_HOLLARS_PLANNING_STEP = 10,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_HOLLARS_PLANNED_FORCE = 11,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_HOLLARS_END_VELOCITY = 12,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_HOLLARS_END_EXTERNAL_FORCE = 13,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_HOLLARS_END_NORMAL_FORCE = 14,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_HOLLARS_VELOCITY_CHANGE = 15,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_HOLLARS_EXTERNAL_FORCE_CHANGE = 16,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_HOLLARS_NORMAL_FORCE_CHANGE = 17,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_HOLLARS_PHASE = 18,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_HOLLARS_DISSIPATED_ENERGY = 19,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_HOLLARS_FRICTION_FORCE = 20,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_HOLLARS_DISSIPATED_POWER = 21,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_HOLLARS_STICKING = 22,
} stribeck_hollars_variable;

/** Guid of Andersson for fmi2Instantiate. */
#define STRIBECK_ANDERSSON_GUID "{13e325ea-4f80-0388-d174-e5dcb57a7e33}"

/** Andersson: Smooth friction law with the Stribeck curve (Andersson). Columns of "Andersson". */
typedef enum stribeck_andersson_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ANDERSSON_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ANDERSSON_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_ANDERSSON_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ANDERSSON_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_ANDERSSON_MU_S = 4,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_ANDERSSON_STRIBECK_VELOCITY = 5,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_ANDERSSON_STRIBECK_EXPONENT = 6,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 10000) */
  STRIBECK_ANDERSSON_TRANSITION_SLOPE = 7,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_ANDERSSON_VISCOUS_COEFFICIENT = 8,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_ANDERSSON_MASS = 9,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_ANDERSSON_EXCHANGE = 10,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_ANDERSSON_STEP_SIZE = 11,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_ANDERSSON_PLANNING_STEP = 12,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_ANDERSSON_PLANNED_FORCE = 13,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_ANDERSSON_END_VELOCITY = 14,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_ANDERSSON_END_EXTERNAL_FORCE = 15,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_ANDERSSON_END_NORMAL_FORCE = 16,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ANDERSSON_VELOCITY_CHANGE = 17,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ANDERSSON_EXTERNAL_FORCE_CHANGE = 18,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ANDERSSON_NORMAL_FORCE_CHANGE = 19,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_ANDERSSON_PHASE = 20,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ANDERSSON_DISSIPATED_ENERGY = 21,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ANDERSSON_FRICTION_FORCE = 22,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ANDERSSON_DISSIPATED_POWER = 23,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ANDERSSON_STICKING = 24,
} stribeck_andersson_variable;

/** Guid of Awrejcewicz for fmi2Instantiate. */
#define STRIBECK_AWREJCEWICZ_GUID "{bfc4c633-ab3b-e0ee-d984-fba310e0f3cd}"

/** Awrejcewicz: Continuous friction law that holds a load at rest (Awrejcewicz, Grzelczyk and Pyryev). Columns of "Awrejcewicz". */
typedef enum stribeck_awrejcewicz_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_AWREJCEWICZ_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_AWREJCEWICZ_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_AWREJCEWICZ_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_AWREJCEWICZ_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_AWREJCEWICZ_MU_S = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_AWREJCEWICZ_TRANSITION_VELOCITY = 5,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_AWREJCEWICZ_STICTION_DECAY = 6,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_AWREJCEWICZ_MASS = 7,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_AWREJCEWICZ_EXCHANGE = 8,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_AWREJCEWICZ_STEP_SIZE = 9,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_AWREJCEWICZ_PLANNING_STEP = 10,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_AWREJCEWICZ_PLANNED_FORCE = 11,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_AWREJCEWICZ_END_VELOCITY = 12,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_AWREJCEWICZ_END_EXTERNAL_FORCE = 13,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_AWREJCEWICZ_END_NORMAL_FORCE = 14,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AWREJCEWICZ_VELOCITY_CHANGE = 15,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AWREJCEWICZ_EXTERNAL_FORCE_CHANGE = 16,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AWREJCEWICZ_NORMAL_FORCE_CHANGE = 17,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_AWREJCEWICZ_PHASE = 18,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_AWREJCEWICZ_DISSIPATED_ENERGY = 19,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_AWREJCEWICZ_FRICTION_FORCE = 20,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_AWREJCEWICZ_DISSIPATED_POWER = 21,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_AWREJCEWICZ_STICKING = 22,
} stribeck_awrejcewicz_variable;

/** Guid of Specker for fmi2Instantiate. */
#define STRIBECK_SPECKER_GUID "{a3c0daa8-503e-4b13-b11b-c16e4b8b6f14}"

/** Specker: Smooth friction law that passes through the static level (Specker). Columns of "Specker". */
typedef enum stribeck_specker_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_SPECKER_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_SPECKER_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_SPECKER_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_SPECKER_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_SPECKER_MU_S = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_SPECKER_TRANSITION_VELOCITY = 5,
  /** tunable [m/s]: Velocity at which the static level is reached (default chosen). (> 0, default 0.0005) */
  STRIBECK_SPECKER_PEAK_VELOCITY = 6,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SPECKER_VISCOUS_COEFFICIENT = 7,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_SPECKER_MASS = 8,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_SPECKER_EXCHANGE = 9,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_SPECKER_STEP_SIZE = 10,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_SPECKER_PLANNING_STEP = 11,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_SPECKER_PLANNED_FORCE = 12,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_SPECKER_END_VELOCITY = 13,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_SPECKER_END_EXTERNAL_FORCE = 14,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_SPECKER_END_NORMAL_FORCE = 15,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SPECKER_VELOCITY_CHANGE = 16,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SPECKER_EXTERNAL_FORCE_CHANGE = 17,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SPECKER_NORMAL_FORCE_CHANGE = 18,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_SPECKER_PHASE = 19,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_SPECKER_DISSIPATED_ENERGY = 20,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_SPECKER_FRICTION_FORCE = 21,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_SPECKER_DISSIPATED_POWER = 22,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_SPECKER_STICKING = 23,
} stribeck_specker_variable;

/** Guid of LinearStiction for fmi2Instantiate. */
#define STRIBECK_LINEAR_STICTION_GUID "{0ed89408-c6a5-10ba-55ad-87be8bebf93e}"

/** LinearStiction: Friction law with stiction made of three straight lines. Columns of "LinearStiction". */
typedef enum stribeck_linear_stiction_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_LINEAR_STICTION_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LINEAR_STICTION_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_LINEAR_STICTION_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LINEAR_STICTION_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LINEAR_STICTION_MU_S = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_LINEAR_STICTION_TRANSITION_VELOCITY = 5,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.0015) */
  STRIBECK_LINEAR_STICTION_SLIDING_VELOCITY = 6,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_LINEAR_STICTION_MASS = 7,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_LINEAR_STICTION_EXCHANGE = 8,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_LINEAR_STICTION_STEP_SIZE = 9,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_LINEAR_STICTION_PLANNING_STEP = 10,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_LINEAR_STICTION_PLANNED_FORCE = 11,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_LINEAR_STICTION_END_VELOCITY = 12,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_LINEAR_STICTION_END_EXTERNAL_FORCE = 13,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_LINEAR_STICTION_END_NORMAL_FORCE = 14,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_LINEAR_STICTION_VELOCITY_CHANGE = 15,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_LINEAR_STICTION_EXTERNAL_FORCE_CHANGE = 16,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_LINEAR_STICTION_NORMAL_FORCE_CHANGE = 17,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_LINEAR_STICTION_PHASE = 18,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LINEAR_STICTION_DISSIPATED_ENERGY = 19,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LINEAR_STICTION_FRICTION_FORCE = 20,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LINEAR_STICTION_DISSIPATED_POWER = 21,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LINEAR_STICTION_STICKING = 22,
} stribeck_linear_stiction_variable;

/** Guid of BrownMcPhee for fmi2Instantiate. */
#define STRIBECK_BROWN_MCPHEE_GUID "{e4242594-9d91-a529-753f-7d144a9382d9}"

/** BrownMcPhee: Smooth friction law with a stiction peak (Brown and McPhee). Columns of "BrownMcPhee". */
typedef enum stribeck_brown_mcphee_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BROWN_MCPHEE_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BROWN_MCPHEE_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_BROWN_MCPHEE_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BROWN_MCPHEE_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_BROWN_MCPHEE_MU_S = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_BROWN_MCPHEE_TRANSITION_VELOCITY = 5,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_VISCOUS_COEFFICIENT = 6,
  /** tunable [N]: Normal force at which the viscous part is fully active (default chosen). (> 0, default 1) */
  STRIBECK_BROWN_MCPHEE_TRANSITION_NORMAL_FORCE = 7,
  /** tunable [kg]: Effective mass of the body, to hold it at rest in co-simulation; too small is safer than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_MASS = 8,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_BROWN_MCPHEE_EXCHANGE = 9,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_STEP_SIZE = 10,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_PLANNING_STEP = 11,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_BROWN_MCPHEE_PLANNED_FORCE = 12,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_BROWN_MCPHEE_END_VELOCITY = 13,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_BROWN_MCPHEE_END_EXTERNAL_FORCE = 14,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_END_NORMAL_FORCE = 15,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BROWN_MCPHEE_VELOCITY_CHANGE = 16,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BROWN_MCPHEE_EXTERNAL_FORCE_CHANGE = 17,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BROWN_MCPHEE_NORMAL_FORCE_CHANGE = 18,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_BROWN_MCPHEE_PHASE = 19,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BROWN_MCPHEE_DISSIPATED_ENERGY = 20,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BROWN_MCPHEE_FRICTION_FORCE = 21,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BROWN_MCPHEE_DISSIPATED_POWER = 22,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BROWN_MCPHEE_STICKING = 23,
} stribeck_brown_mcphee_variable;

/** Guid of Dahl for fmi2Instantiate. */
#define STRIBECK_DAHL_GUID "{81261687-8d7f-44de-0214-fbf63612f2b5}"

/** Dahl: Pre-sliding displacement with hysteresis (Dahl). Columns of "Dahl". */
typedef enum stribeck_dahl_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_DAHL_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_DAHL_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_DAHL_MU_K = 2,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_DAHL_SIGMA_0 = 3,
  /** tunable [1]: Exponent of the transition to sliding; below 1 brittle, from 1 on ductile. (>= 0, default 1) */
  STRIBECK_DAHL_ALPHA = 4,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_DAHL_BRISTLE_DEFLECTION = 5,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_DAHL_DISSIPATED_ENERGY = 6,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_DAHL_FRICTION_FORCE = 7,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_DAHL_DISSIPATED_POWER = 8,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_DAHL_STICKING = 9,
} stribeck_dahl_variable;

/** Guid of LuGre for fmi2Instantiate. */
#define STRIBECK_LUGRE_GUID "{bdfcf639-f9dc-473e-ecbe-a3a094ef8c0d}"

/** LuGre: Bristle friction with Stribeck effect (LuGre). Columns of "LuGre". */
typedef enum stribeck_lugre_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_LUGRE_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LUGRE_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (> 0, default 0.1) */
  STRIBECK_LUGRE_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LUGRE_MU_S = 3,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_LUGRE_STRIBECK_VELOCITY = 4,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_LUGRE_STRIBECK_EXPONENT = 5,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_LUGRE_SIGMA_0 = 6,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_LUGRE_SIGMA_1 = 7,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_LUGRE_VISCOUS_COEFFICIENT = 8,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_LUGRE_DAMPING_VELOCITY = 9,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_LUGRE_BRISTLE_DEFLECTION = 10,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LUGRE_DISSIPATED_ENERGY = 11,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LUGRE_FRICTION_FORCE = 12,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LUGRE_DISSIPATED_POWER = 13,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LUGRE_STICKING = 14,
} stribeck_lugre_variable;

/** Guid of FrictionalLag for fmi2Instantiate. */
#define STRIBECK_FRICTIONAL_LAG_GUID "{ebbe0a4c-aecb-84a6-d133-567793ad148d}"

/** FrictionalLag: Stribeck friction that lags behind the velocity (Hess and Soom). Columns of "FrictionalLag". */
typedef enum stribeck_frictional_lag_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_FRICTIONAL_LAG_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_FRICTIONAL_LAG_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_FRICTIONAL_LAG_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_FRICTIONAL_LAG_MU_S = 3,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_FRICTIONAL_LAG_STRIBECK_VELOCITY = 4,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_FRICTIONAL_LAG_STRIBECK_EXPONENT = 5,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_VISCOUS_COEFFICIENT = 6,
  /** fixed [s]: Time by which the level of friction lags behind the velocity (default chosen). (>= 0, default 0.005) */
  STRIBECK_FRICTIONAL_LAG_TIME_LAG = 7,
  /** fixed [stribeck_frictional_lag_variant]: Variant of the law. (default Delay) */
  STRIBECK_FRICTIONAL_LAG_VARIANT = 8,
  /** state [Boolean]: Does the contact have a past? Without one the level follows the present velocity.
   *  (default false) */
  STRIBECK_FRICTIONAL_LAG_HAS_PAST = 9,
  /** state [m/s]: Velocity that determines the friction level: delayed by the time lag, or filtered. (default 0) */
  STRIBECK_FRICTIONAL_LAG_LAGGED_VELOCITY = 10,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_1_DURATION = 11,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_1_BEGIN = 12,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_1_END = 13,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_2_DURATION = 14,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_2_BEGIN = 15,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_2_END = 16,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_3_DURATION = 17,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_3_BEGIN = 18,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_3_END = 19,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_4_DURATION = 20,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_4_BEGIN = 21,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_4_END = 22,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_5_DURATION = 23,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_5_BEGIN = 24,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_5_END = 25,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_6_DURATION = 26,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_6_BEGIN = 27,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_6_END = 28,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_7_DURATION = 29,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_7_BEGIN = 30,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_7_END = 31,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_8_DURATION = 32,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_8_BEGIN = 33,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_8_END = 34,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_9_DURATION = 35,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_9_BEGIN = 36,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_9_END = 37,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_10_DURATION = 38,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_10_BEGIN = 39,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_10_END = 40,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_11_DURATION = 41,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_11_BEGIN = 42,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_11_END = 43,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_12_DURATION = 44,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_12_BEGIN = 45,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_12_END = 46,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_13_DURATION = 47,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_13_BEGIN = 48,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_13_END = 49,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_14_DURATION = 50,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_14_BEGIN = 51,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_14_END = 52,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_15_DURATION = 53,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_15_BEGIN = 54,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_15_END = 55,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_16_DURATION = 56,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_16_BEGIN = 57,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_16_END = 58,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_17_DURATION = 59,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_17_BEGIN = 60,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_17_END = 61,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_18_DURATION = 62,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_18_BEGIN = 63,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_18_END = 64,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_19_DURATION = 65,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_19_BEGIN = 66,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_19_END = 67,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_20_DURATION = 68,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_20_BEGIN = 69,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_20_END = 70,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_21_DURATION = 71,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_21_BEGIN = 72,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_21_END = 73,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_22_DURATION = 74,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_22_BEGIN = 75,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_22_END = 76,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_23_DURATION = 77,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_23_BEGIN = 78,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_23_END = 79,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_24_DURATION = 80,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_24_BEGIN = 81,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_24_END = 82,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_25_DURATION = 83,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_25_BEGIN = 84,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_25_END = 85,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_26_DURATION = 86,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_26_BEGIN = 87,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_26_END = 88,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_27_DURATION = 89,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_27_BEGIN = 90,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_27_END = 91,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_28_DURATION = 92,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_28_BEGIN = 93,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_28_END = 94,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_29_DURATION = 95,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_29_BEGIN = 96,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_29_END = 97,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_30_DURATION = 98,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_30_BEGIN = 99,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_30_END = 100,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_31_DURATION = 101,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_31_BEGIN = 102,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_31_END = 103,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_32_DURATION = 104,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_32_BEGIN = 105,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_32_END = 106,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_33_DURATION = 107,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_33_BEGIN = 108,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_33_END = 109,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_34_DURATION = 110,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_34_BEGIN = 111,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_34_END = 112,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_35_DURATION = 113,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_35_BEGIN = 114,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_35_END = 115,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_36_DURATION = 116,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_36_BEGIN = 117,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_36_END = 118,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_37_DURATION = 119,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_37_BEGIN = 120,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_37_END = 121,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_38_DURATION = 122,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_38_BEGIN = 123,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_38_END = 124,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_39_DURATION = 125,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_39_BEGIN = 126,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_39_END = 127,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_40_DURATION = 128,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_40_BEGIN = 129,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_40_END = 130,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_41_DURATION = 131,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_41_BEGIN = 132,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_41_END = 133,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_42_DURATION = 134,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_42_BEGIN = 135,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_42_END = 136,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_43_DURATION = 137,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_43_BEGIN = 138,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_43_END = 139,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_44_DURATION = 140,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_44_BEGIN = 141,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_44_END = 142,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_45_DURATION = 143,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_45_BEGIN = 144,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_45_END = 145,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_46_DURATION = 146,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_46_BEGIN = 147,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_46_END = 148,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_47_DURATION = 149,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_47_BEGIN = 150,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_47_END = 151,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_48_DURATION = 152,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_48_BEGIN = 153,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_48_END = 154,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_49_DURATION = 155,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_49_BEGIN = 156,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_49_END = 157,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_50_DURATION = 158,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_50_BEGIN = 159,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_50_END = 160,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_51_DURATION = 161,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_51_BEGIN = 162,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_51_END = 163,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_52_DURATION = 164,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_52_BEGIN = 165,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_52_END = 166,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_53_DURATION = 167,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_53_BEGIN = 168,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_53_END = 169,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_54_DURATION = 170,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_54_BEGIN = 171,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_54_END = 172,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_55_DURATION = 173,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_55_BEGIN = 174,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_55_END = 175,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_56_DURATION = 176,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_56_BEGIN = 177,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_56_END = 178,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_57_DURATION = 179,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_57_BEGIN = 180,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_57_END = 181,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_58_DURATION = 182,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_58_BEGIN = 183,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_58_END = 184,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_59_DURATION = 185,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_59_BEGIN = 186,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_59_END = 187,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_60_DURATION = 188,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_60_BEGIN = 189,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_60_END = 190,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_61_DURATION = 191,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_61_BEGIN = 192,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_61_END = 193,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_62_DURATION = 194,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_62_BEGIN = 195,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_62_END = 196,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_63_DURATION = 197,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_63_BEGIN = 198,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_63_END = 199,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_64_DURATION = 200,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_64_BEGIN = 201,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_64_END = 202,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_FRICTIONAL_LAG_DISSIPATED_ENERGY = 203,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_FRICTIONAL_LAG_FRICTION_FORCE = 204,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_FRICTIONAL_LAG_DISSIPATED_POWER = 205,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_FRICTIONAL_LAG_STICKING = 206,
} stribeck_frictional_lag_variable;

/** Guid of Armstrong for fmi2Instantiate. */
#define STRIBECK_ARMSTRONG_GUID "{ea672f5d-c0f7-68db-9ad2-d2faba962336}"

/** Armstrong: Stick, slip, lag and rising static friction with seven parameters (Armstrong-Helouvry). Columns of "Armstrong". */
typedef enum stribeck_armstrong_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ARMSTRONG_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ARMSTRONG_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ARMSTRONG_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_ARMSTRONG_MU_S = 3,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_ARMSTRONG_SIGMA_0 = 4,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_ARMSTRONG_STRIBECK_VELOCITY = 5,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_VISCOUS_COEFFICIENT = 6,
  /** fixed [s]: Time by which the level of friction lags behind the velocity (default chosen). (>= 0, default 0.005) */
  STRIBECK_ARMSTRONG_TIME_LAG = 7,
  /** tunable [s]: Dwell time after which half of the rise of the static friction has occurred (default chosen).
   *  (>= 0, default 2) */
  STRIBECK_ARMSTRONG_GAMMA = 8,
  /** state [Boolean]: Has the contact broken away? (default false) */
  STRIBECK_ARMSTRONG_SLIPPING = 9,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_ARMSTRONG_BRISTLE_DEFLECTION = 10,
  /** state [s]: Time since the contact got stuck; 0 while it slips. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_DWELL_TIME = 11,
  /** state [1]: Stribeck magnitude per normal force: that at the end of the last slip while stuck, that of the breakaway while slipping.
   *  (>= 0, default 0) */
  STRIBECK_ARMSTRONG_STRIBECK_COEFFICIENT = 12,
  /** state [m/s]: Velocity that determines the friction level: delayed by the time lag, or filtered. (default 0) */
  STRIBECK_ARMSTRONG_LAGGED_VELOCITY = 13,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_1_DURATION = 14,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_1_BEGIN = 15,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_1_END = 16,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_2_DURATION = 17,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_2_BEGIN = 18,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_2_END = 19,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_3_DURATION = 20,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_3_BEGIN = 21,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_3_END = 22,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_4_DURATION = 23,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_4_BEGIN = 24,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_4_END = 25,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_5_DURATION = 26,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_5_BEGIN = 27,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_5_END = 28,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_6_DURATION = 29,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_6_BEGIN = 30,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_6_END = 31,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_7_DURATION = 32,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_7_BEGIN = 33,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_7_END = 34,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_8_DURATION = 35,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_8_BEGIN = 36,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_8_END = 37,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_9_DURATION = 38,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_9_BEGIN = 39,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_9_END = 40,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_10_DURATION = 41,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_10_BEGIN = 42,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_10_END = 43,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_11_DURATION = 44,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_11_BEGIN = 45,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_11_END = 46,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_12_DURATION = 47,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_12_BEGIN = 48,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_12_END = 49,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_13_DURATION = 50,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_13_BEGIN = 51,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_13_END = 52,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_14_DURATION = 53,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_14_BEGIN = 54,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_14_END = 55,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_15_DURATION = 56,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_15_BEGIN = 57,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_15_END = 58,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_16_DURATION = 59,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_16_BEGIN = 60,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_16_END = 61,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_17_DURATION = 62,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_17_BEGIN = 63,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_17_END = 64,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_18_DURATION = 65,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_18_BEGIN = 66,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_18_END = 67,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_19_DURATION = 68,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_19_BEGIN = 69,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_19_END = 70,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_20_DURATION = 71,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_20_BEGIN = 72,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_20_END = 73,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_21_DURATION = 74,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_21_BEGIN = 75,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_21_END = 76,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_22_DURATION = 77,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_22_BEGIN = 78,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_22_END = 79,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_23_DURATION = 80,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_23_BEGIN = 81,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_23_END = 82,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_24_DURATION = 83,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_24_BEGIN = 84,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_24_END = 85,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_25_DURATION = 86,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_25_BEGIN = 87,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_25_END = 88,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_26_DURATION = 89,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_26_BEGIN = 90,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_26_END = 91,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_27_DURATION = 92,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_27_BEGIN = 93,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_27_END = 94,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_28_DURATION = 95,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_28_BEGIN = 96,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_28_END = 97,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_29_DURATION = 98,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_29_BEGIN = 99,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_29_END = 100,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_30_DURATION = 101,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_30_BEGIN = 102,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_30_END = 103,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_31_DURATION = 104,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_31_BEGIN = 105,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_31_END = 106,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_32_DURATION = 107,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_32_BEGIN = 108,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_32_END = 109,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_33_DURATION = 110,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_33_BEGIN = 111,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_33_END = 112,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_34_DURATION = 113,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_34_BEGIN = 114,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_34_END = 115,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_35_DURATION = 116,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_35_BEGIN = 117,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_35_END = 118,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_36_DURATION = 119,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_36_BEGIN = 120,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_36_END = 121,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_37_DURATION = 122,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_37_BEGIN = 123,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_37_END = 124,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_38_DURATION = 125,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_38_BEGIN = 126,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_38_END = 127,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_39_DURATION = 128,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_39_BEGIN = 129,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_39_END = 130,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_40_DURATION = 131,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_40_BEGIN = 132,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_40_END = 133,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_41_DURATION = 134,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_41_BEGIN = 135,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_41_END = 136,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_42_DURATION = 137,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_42_BEGIN = 138,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_42_END = 139,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_43_DURATION = 140,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_43_BEGIN = 141,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_43_END = 142,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_44_DURATION = 143,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_44_BEGIN = 144,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_44_END = 145,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_45_DURATION = 146,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_45_BEGIN = 147,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_45_END = 148,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_46_DURATION = 149,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_46_BEGIN = 150,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_46_END = 151,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_47_DURATION = 152,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_47_BEGIN = 153,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_47_END = 154,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_48_DURATION = 155,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_48_BEGIN = 156,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_48_END = 157,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_49_DURATION = 158,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_49_BEGIN = 159,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_49_END = 160,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_50_DURATION = 161,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_50_BEGIN = 162,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_50_END = 163,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_51_DURATION = 164,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_51_BEGIN = 165,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_51_END = 166,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_52_DURATION = 167,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_52_BEGIN = 168,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_52_END = 169,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_53_DURATION = 170,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_53_BEGIN = 171,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_53_END = 172,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_54_DURATION = 173,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_54_BEGIN = 174,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_54_END = 175,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_55_DURATION = 176,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_55_BEGIN = 177,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_55_END = 178,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_56_DURATION = 179,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_56_BEGIN = 180,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_56_END = 181,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_57_DURATION = 182,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_57_BEGIN = 183,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_57_END = 184,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_58_DURATION = 185,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_58_BEGIN = 186,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_58_END = 187,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_59_DURATION = 188,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_59_BEGIN = 189,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_59_END = 190,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_60_DURATION = 191,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_60_BEGIN = 192,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_60_END = 193,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_61_DURATION = 194,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_61_BEGIN = 195,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_61_END = 196,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_62_DURATION = 197,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_62_BEGIN = 198,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_62_END = 199,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_63_DURATION = 200,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_63_BEGIN = 201,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_63_END = 202,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_64_DURATION = 203,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_64_BEGIN = 204,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_64_END = 205,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ARMSTRONG_DISSIPATED_ENERGY = 206,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ARMSTRONG_FRICTION_FORCE = 207,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ARMSTRONG_DISSIPATED_POWER = 208,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ARMSTRONG_STICKING = 209,
} stribeck_armstrong_variable;

/** Guid of NonReversible for fmi2Instantiate. */
#define STRIBECK_NON_REVERSIBLE_GUID "{b79145f5-aaf6-b9d9-9423-2c0345808397}"

/** NonReversible: Different friction while speeding up and slowing down (reconstructed). Columns of "NonReversible". */
typedef enum stribeck_non_reversible_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_NON_REVERSIBLE_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_NON_REVERSIBLE_NORMAL_FORCE = 1,
  /** in [m/s2]: Acceleration of body 1 relative to body 2; used if the velocity has no slope. (default 0) */
  STRIBECK_NON_REVERSIBLE_ACCELERATION = 2,
  /** state [m/s2]: Slope of the velocity over the last step; 0 if it was held. (default 0) */
  STRIBECK_NON_REVERSIBLE_VELOCITY_SLOPE = 3,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_NON_REVERSIBLE_MU_K = 4,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_NON_REVERSIBLE_MU_S = 5,
  /** tunable [1]: Coefficient of friction that a contact reaches when it comes to rest; not more than mu_s (default chosen).
   *  (>= 0, default 0) */
  STRIBECK_NON_REVERSIBLE_MU_STOP = 6,
  /** tunable [s/m]: Steepness of the curve while speeding up (default chosen). (> 0, default 500) */
  STRIBECK_NON_REVERSIBLE_ACCELERATION_DECAY = 7,
  /** tunable [s/m]: Steepness of the curve while slowing down (default chosen). (> 0, default 500) */
  STRIBECK_NON_REVERSIBLE_DECELERATION_DECAY = 8,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_NON_REVERSIBLE_DISSIPATED_ENERGY = 9,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_NON_REVERSIBLE_FRICTION_FORCE = 10,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_NON_REVERSIBLE_DISSIPATED_POWER = 11,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_NON_REVERSIBLE_STICKING = 12,
} stribeck_non_reversible_variable;

/** Guid of Wojewoda for fmi2Instantiate. */
#define STRIBECK_WOJEWODA_GUID "{1d2ec7b4-a425-5b16-68c9-aeb950488dd2}"

/** Wojewoda: Hysteretic friction: stuck spring, two branches of sliding (reconstructed after Wojewoda). Columns of "Wojewoda". */
typedef enum stribeck_wojewoda_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_WOJEWODA_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_WOJEWODA_NORMAL_FORCE = 1,
  /** in [m/s2]: Acceleration of body 1 relative to body 2; used if the velocity has no slope. (default 0) */
  STRIBECK_WOJEWODA_ACCELERATION = 2,
  /** state [m/s2]: Slope of the velocity over the last step; 0 if it was held. (default 0) */
  STRIBECK_WOJEWODA_VELOCITY_SLOPE = 3,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_WOJEWODA_MU_K = 4,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_WOJEWODA_MU_S = 5,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_WOJEWODA_SIGMA_0 = 6,
  /** tunable [s/m]: Steepness of the curves for speeding up and slowing down (default chosen). (> 0, default 500) */
  STRIBECK_WOJEWODA_BRANCH_DECAY = 7,
  /** state [Boolean]: Has the contact broken away? (default false) */
  STRIBECK_WOJEWODA_SLIPPING = 8,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_WOJEWODA_BRISTLE_DEFLECTION = 9,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_WOJEWODA_DISSIPATED_ENERGY = 10,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_WOJEWODA_FRICTION_FORCE = 11,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_WOJEWODA_DISSIPATED_POWER = 12,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_WOJEWODA_STICKING = 13,
} stribeck_wojewoda_variable;

/** Guid of BlimanSorine for fmi2Instantiate. */
#define STRIBECK_BLIMAN_SORINE_GUID "{a4b1ca64-2232-a844-5ba0-2d47690d27a9}"

/** BlimanSorine: Pre-sliding displacement and breakaway peak in the sliding distance (Bliman-Sorine). Columns of "BlimanSorine". */
typedef enum stribeck_bliman_sorine_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BLIMAN_SORINE_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BLIMAN_SORINE_NORMAL_FORCE = 1,
  /** fixed [stribeck_bliman_sorine_order]: Variant of the law. (default Second) */
  STRIBECK_BLIMAN_SORINE_VARIANT = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BLIMAN_SORINE_MU_K = 3,
  /** tunable [1]: Level of the slow relaxation, as a coefficient of friction; second order (default calibrated).
   *  (>= 0, default 0.2732050807568877) */
  STRIBECK_BLIMAN_SORINE_MU_2 = 4,
  /** tunable [1]: Length of the fast relaxation as a part of that of the slow one; second order (default chosen).
   *  (> 0, <= 1, default 0.5) */
  STRIBECK_BLIMAN_SORINE_ETA = 5,
  /** tunable [m]: Sliding distance in which the slow relaxation settles to 1/e (default calibrated).
   *  (> 0, default 4.642141842225068e-5) */
  STRIBECK_BLIMAN_SORINE_EPS_F = 6,
  /** state [1]: Fast relaxation, in units of its level. (default 0) */
  STRIBECK_BLIMAN_SORINE_Y_1 = 7,
  /** state [1]: Slow relaxation, in units of its level; second order. (default 0) */
  STRIBECK_BLIMAN_SORINE_Y_2 = 8,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BLIMAN_SORINE_DISSIPATED_ENERGY = 9,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BLIMAN_SORINE_FRICTION_FORCE = 10,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BLIMAN_SORINE_DISSIPATED_POWER = 11,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BLIMAN_SORINE_STICKING = 12,
} stribeck_bliman_sorine_variable;

/** Guid of ResetIntegrator for fmi2Instantiate. */
#define STRIBECK_RESET_INTEGRATOR_GUID "{53556615-5df0-cdd0-3b63-a07e8c5e5848}"

/** ResetIntegrator: Bond that breaks at the static level (reset integrator). Columns of "ResetIntegrator". */
typedef enum stribeck_reset_integrator_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_RESET_INTEGRATOR_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_RESET_INTEGRATOR_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_RESET_INTEGRATOR_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_RESET_INTEGRATOR_MU_S = 3,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_RESET_INTEGRATOR_SIGMA_0 = 4,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_RESET_INTEGRATOR_SIGMA_1 = 5,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_RESET_INTEGRATOR_BRISTLE_DEFLECTION = 6,
  /** state [1]: Direction in which the contact has broken away; 0 = bonded. (>= -1, <= 1, default 0) */
  STRIBECK_RESET_INTEGRATOR_SLIP_DIRECTION = 7,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_RESET_INTEGRATOR_DISSIPATED_ENERGY = 8,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_RESET_INTEGRATOR_FRICTION_FORCE = 9,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_RESET_INTEGRATOR_DISSIPATED_POWER = 10,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_RESET_INTEGRATOR_STICKING = 11,
} stribeck_reset_integrator_variable;

/** Guid of Dankowicz for fmi2Instantiate. */
#define STRIBECK_DANKOWICZ_GUID "{28f989d4-5f89-d379-8a3d-488097594365}"

/** Dankowicz: Pre-sliding displacement of sheared asperities (Dankowicz, reconstructed). Columns of "Dankowicz". */
typedef enum stribeck_dankowicz_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_DANKOWICZ_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_DANKOWICZ_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_DANKOWICZ_MU_K = 2,
  /** tunable [m]: Shear deflection of the asperities in steady sliding (default f_C / sigma_0 of the thesis).
   *  (> 0, default 9.81e-6) */
  STRIBECK_DANKOWICZ_DELTA_T = 3,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_DANKOWICZ_BRISTLE_DEFLECTION = 4,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_DANKOWICZ_DISSIPATED_ENERGY = 5,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_DANKOWICZ_FRICTION_FORCE = 6,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_DANKOWICZ_DISSIPATED_POWER = 7,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_DANKOWICZ_STICKING = 8,
} stribeck_dankowicz_variable;

/** Guid of ElastoPlastic for fmi2Instantiate. */
#define STRIBECK_ELASTO_PLASTIC_GUID "{333ed675-96b8-6542-43ed-0bb0a226d423}"

/** ElastoPlastic: Bristle friction without drift below breakaway (elasto-plastic). Columns of "ElastoPlastic". */
typedef enum stribeck_elasto_plastic_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ELASTO_PLASTIC_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ELASTO_PLASTIC_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ELASTO_PLASTIC_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_ELASTO_PLASTIC_MU_S = 3,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_ELASTO_PLASTIC_STRIBECK_VELOCITY = 4,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_ELASTO_PLASTIC_STRIBECK_EXPONENT = 5,
  /** tunable [1]: Part of the deflection of steady sliding up to which the contact is purely elastic.
   *  (> 0, <= 1, default 0.7) */
  STRIBECK_ELASTO_PLASTIC_BREAKAWAY_RATIO = 6,
  /** tunable [Integer]: Exponent of the transition from elastic deflection to sliding; odd. (>= 1, <= 9, default 1) */
  STRIBECK_ELASTO_PLASTIC_PLASTIC_EXPONENT = 7,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_ELASTO_PLASTIC_SIGMA_0 = 8,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_ELASTO_PLASTIC_SIGMA_1 = 9,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_ELASTO_PLASTIC_VISCOUS_COEFFICIENT = 10,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_ELASTO_PLASTIC_DAMPING_VELOCITY = 11,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_ELASTO_PLASTIC_BRISTLE_DEFLECTION = 12,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ELASTO_PLASTIC_DISSIPATED_ENERGY = 13,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ELASTO_PLASTIC_FRICTION_FORCE = 14,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ELASTO_PLASTIC_DISSIPATED_POWER = 15,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ELASTO_PLASTIC_STICKING = 16,
} stribeck_elasto_plastic_variable;

/** Guid of Bristle for fmi2Instantiate. */
#define STRIBECK_BRISTLE_GUID "{aca1929e-345e-f19d-f265-d4d06626ce0b}"

/** Bristle: Bonds that snap and form again at random (bristle model). Columns of "Bristle". */
typedef enum stribeck_bristle_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BRISTLE_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BRISTLE_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BRISTLE_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_BRISTLE_MU_S = 3,
  /** tunable [m]: Strain at which a bristle snaps (default f_s / sigma_0 of the thesis). (> 0, default 1.4715e-5) */
  STRIBECK_BRISTLE_DELTA = 4,
  /** fixed [Integer]: Number of bristles (default chosen). (>= 1, <= 64, default 25) */
  STRIBECK_BRISTLE_BRISTLE_COUNT = 5,
  /** fixed [Integer]: Seed of the random numbers. (>= 0, default 0) */
  STRIBECK_BRISTLE_SEED = 6,
  /** fixed [stribeck_initial_bonds]: State of the bristles when the motion starts. (default Bonded) */
  STRIBECK_BRISTLE_INITIAL_BONDS = 7,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_1_STRAIN = 8,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_1_DRAWS = 9,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_2_STRAIN = 10,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_2_DRAWS = 11,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_3_STRAIN = 12,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_3_DRAWS = 13,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_4_STRAIN = 14,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_4_DRAWS = 15,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_5_STRAIN = 16,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_5_DRAWS = 17,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_6_STRAIN = 18,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_6_DRAWS = 19,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_7_STRAIN = 20,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_7_DRAWS = 21,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_8_STRAIN = 22,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_8_DRAWS = 23,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_9_STRAIN = 24,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_9_DRAWS = 25,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_10_STRAIN = 26,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_10_DRAWS = 27,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_11_STRAIN = 28,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_11_DRAWS = 29,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_12_STRAIN = 30,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_12_DRAWS = 31,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_13_STRAIN = 32,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_13_DRAWS = 33,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_14_STRAIN = 34,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_14_DRAWS = 35,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_15_STRAIN = 36,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_15_DRAWS = 37,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_16_STRAIN = 38,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_16_DRAWS = 39,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_17_STRAIN = 40,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_17_DRAWS = 41,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_18_STRAIN = 42,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_18_DRAWS = 43,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_19_STRAIN = 44,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_19_DRAWS = 45,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_20_STRAIN = 46,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_20_DRAWS = 47,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_21_STRAIN = 48,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_21_DRAWS = 49,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_22_STRAIN = 50,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_22_DRAWS = 51,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_23_STRAIN = 52,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_23_DRAWS = 53,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_24_STRAIN = 54,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_24_DRAWS = 55,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_25_STRAIN = 56,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_25_DRAWS = 57,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_26_STRAIN = 58,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_26_DRAWS = 59,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_27_STRAIN = 60,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_27_DRAWS = 61,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_28_STRAIN = 62,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_28_DRAWS = 63,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_29_STRAIN = 64,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_29_DRAWS = 65,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_30_STRAIN = 66,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_30_DRAWS = 67,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_31_STRAIN = 68,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_31_DRAWS = 69,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_32_STRAIN = 70,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_32_DRAWS = 71,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_33_STRAIN = 72,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_33_DRAWS = 73,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_34_STRAIN = 74,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_34_DRAWS = 75,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_35_STRAIN = 76,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_35_DRAWS = 77,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_36_STRAIN = 78,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_36_DRAWS = 79,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_37_STRAIN = 80,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_37_DRAWS = 81,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_38_STRAIN = 82,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_38_DRAWS = 83,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_39_STRAIN = 84,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_39_DRAWS = 85,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_40_STRAIN = 86,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_40_DRAWS = 87,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_41_STRAIN = 88,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_41_DRAWS = 89,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_42_STRAIN = 90,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_42_DRAWS = 91,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_43_STRAIN = 92,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_43_DRAWS = 93,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_44_STRAIN = 94,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_44_DRAWS = 95,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_45_STRAIN = 96,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_45_DRAWS = 97,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_46_STRAIN = 98,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_46_DRAWS = 99,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_47_STRAIN = 100,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_47_DRAWS = 101,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_48_STRAIN = 102,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_48_DRAWS = 103,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_49_STRAIN = 104,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_49_DRAWS = 105,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_50_STRAIN = 106,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_50_DRAWS = 107,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_51_STRAIN = 108,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_51_DRAWS = 109,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_52_STRAIN = 110,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_52_DRAWS = 111,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_53_STRAIN = 112,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_53_DRAWS = 113,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_54_STRAIN = 114,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_54_DRAWS = 115,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_55_STRAIN = 116,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_55_DRAWS = 117,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_56_STRAIN = 118,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_56_DRAWS = 119,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_57_STRAIN = 120,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_57_DRAWS = 121,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_58_STRAIN = 122,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_58_DRAWS = 123,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_59_STRAIN = 124,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_59_DRAWS = 125,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_60_STRAIN = 126,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_60_DRAWS = 127,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_61_STRAIN = 128,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_61_DRAWS = 129,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_62_STRAIN = 130,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_62_DRAWS = 131,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_63_STRAIN = 132,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_63_DRAWS = 133,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_64_STRAIN = 134,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_64_DRAWS = 135,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BRISTLE_DISSIPATED_ENERGY = 136,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BRISTLE_FRICTION_FORCE = 137,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BRISTLE_DISSIPATED_POWER = 138,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BRISTLE_STICKING = 139,
} stribeck_bristle_variable;

/** Guid of SpeckerDynamic for fmi2Instantiate. */
#define STRIBECK_SPECKER_DYNAMIC_GUID "{86b330c2-8260-a4e9-0f47-98493ba7f49a}"

/** SpeckerDynamic: Smooth friction law with a velocity-dependent lag (Specker, reconstructed). Columns of "SpeckerDynamic". */
typedef enum stribeck_specker_dynamic_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_SPECKER_DYNAMIC_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_SPECKER_DYNAMIC_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_SPECKER_DYNAMIC_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_SPECKER_DYNAMIC_MU_S = 3,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_SPECKER_DYNAMIC_TRANSITION_VELOCITY = 4,
  /** tunable [m/s]: Velocity at which the static level is reached (default chosen). (> 0, default 0.0005) */
  STRIBECK_SPECKER_DYNAMIC_PEAK_VELOCITY = 5,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SPECKER_DYNAMIC_VISCOUS_COEFFICIENT = 6,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_SPECKER_DYNAMIC_SIGMA_0 = 7,
  /** tunable [s]: Time constant of the force while sliding (default chosen). (> 0, default 0.001) */
  STRIBECK_SPECKER_DYNAMIC_SLIP_TIME = 8,
  /** state [N]: Friction force behind the low-pass. (default 0) */
  STRIBECK_SPECKER_DYNAMIC_LAGGING_FORCE = 9,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_SPECKER_DYNAMIC_DISSIPATED_ENERGY = 10,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_SPECKER_DYNAMIC_FRICTION_FORCE = 11,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_SPECKER_DYNAMIC_DISSIPATED_POWER = 12,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_SPECKER_DYNAMIC_STICKING = 13,
} stribeck_specker_dynamic_variable;

/** Guid of MaxwellSlip for fmi2Instantiate. */
#define STRIBECK_MAXWELL_SLIP_GUID "{148e43d1-2241-4114-8fef-1877e0c68caa}"

/** MaxwellSlip: Elements that stick or slip, with hysteresis of pre-sliding (generalised Maxwell-slip, GMS). Columns of "MaxwellSlip". */
typedef enum stribeck_maxwell_slip_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_MAXWELL_SLIP_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_MAXWELL_SLIP_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_MAXWELL_SLIP_MU_S = 3,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_MAXWELL_SLIP_STRIBECK_VELOCITY = 4,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_MAXWELL_SLIP_STRIBECK_EXPONENT = 5,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_MAXWELL_SLIP_SIGMA_0 = 6,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 0) */
  STRIBECK_MAXWELL_SLIP_SIGMA_1 = 7,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_MAXWELL_SLIP_VISCOUS_COEFFICIENT = 8,
  /** tunable [N/s]: Rate at which the slipping elements together approach their level (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_MAXWELL_SLIP_ATTRACTION = 9,
  /** fixed [stribeck_element_distribution]: Where the shares of the elements come from. (default Explicit) */
  STRIBECK_MAXWELL_SLIP_DISTRIBUTION = 10,
  /** fixed [Integer]: Number of elements in use (default chosen). (>= 1, <= 1000, default 4) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_COUNT = 11,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.5) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_1_STIFFNESS_SHARE = 12,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_1_STRENGTH_SHARE = 13,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_1_FORCE = 14,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_1_SLIPPING = 15,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.25) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_2_STIFFNESS_SHARE = 16,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.2) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_2_STRENGTH_SHARE = 17,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_2_FORCE = 18,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_2_SLIPPING = 19,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.15) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_3_STIFFNESS_SHARE = 20,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.3) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_3_STRENGTH_SHARE = 21,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_3_FORCE = 22,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_3_SLIPPING = 23,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_4_STIFFNESS_SHARE = 24,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.4) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_4_STRENGTH_SHARE = 25,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_4_FORCE = 26,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_4_SLIPPING = 27,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_5_STIFFNESS_SHARE = 28,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_5_STRENGTH_SHARE = 29,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_5_FORCE = 30,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_5_SLIPPING = 31,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_6_STIFFNESS_SHARE = 32,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_6_STRENGTH_SHARE = 33,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_6_FORCE = 34,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_6_SLIPPING = 35,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_7_STIFFNESS_SHARE = 36,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_7_STRENGTH_SHARE = 37,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_7_FORCE = 38,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_7_SLIPPING = 39,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_8_STIFFNESS_SHARE = 40,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_8_STRENGTH_SHARE = 41,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_8_FORCE = 42,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_8_SLIPPING = 43,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_9_STIFFNESS_SHARE = 44,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_9_STRENGTH_SHARE = 45,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_9_FORCE = 46,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_9_SLIPPING = 47,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_10_STIFFNESS_SHARE = 48,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_10_STRENGTH_SHARE = 49,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_10_FORCE = 50,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_10_SLIPPING = 51,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_11_STIFFNESS_SHARE = 52,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_11_STRENGTH_SHARE = 53,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_11_FORCE = 54,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_11_SLIPPING = 55,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_12_STIFFNESS_SHARE = 56,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_12_STRENGTH_SHARE = 57,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_12_FORCE = 58,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_12_SLIPPING = 59,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_13_STIFFNESS_SHARE = 60,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_13_STRENGTH_SHARE = 61,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_13_FORCE = 62,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_13_SLIPPING = 63,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_14_STIFFNESS_SHARE = 64,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_14_STRENGTH_SHARE = 65,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_14_FORCE = 66,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_14_SLIPPING = 67,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_15_STIFFNESS_SHARE = 68,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_15_STRENGTH_SHARE = 69,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_15_FORCE = 70,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_15_SLIPPING = 71,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_16_STIFFNESS_SHARE = 72,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_16_STRENGTH_SHARE = 73,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_16_FORCE = 74,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_16_SLIPPING = 75,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_17_STIFFNESS_SHARE = 76,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_17_STRENGTH_SHARE = 77,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_17_FORCE = 78,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_17_SLIPPING = 79,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_18_STIFFNESS_SHARE = 80,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_18_STRENGTH_SHARE = 81,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_18_FORCE = 82,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_18_SLIPPING = 83,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_19_STIFFNESS_SHARE = 84,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_19_STRENGTH_SHARE = 85,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_19_FORCE = 86,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_19_SLIPPING = 87,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_20_STIFFNESS_SHARE = 88,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_20_STRENGTH_SHARE = 89,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_20_FORCE = 90,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_20_SLIPPING = 91,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_21_STIFFNESS_SHARE = 92,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_21_STRENGTH_SHARE = 93,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_21_FORCE = 94,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_21_SLIPPING = 95,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_22_STIFFNESS_SHARE = 96,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_22_STRENGTH_SHARE = 97,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_22_FORCE = 98,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_22_SLIPPING = 99,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_23_STIFFNESS_SHARE = 100,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_23_STRENGTH_SHARE = 101,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_23_FORCE = 102,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_23_SLIPPING = 103,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_24_STIFFNESS_SHARE = 104,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_24_STRENGTH_SHARE = 105,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_24_FORCE = 106,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_24_SLIPPING = 107,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_25_STIFFNESS_SHARE = 108,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_25_STRENGTH_SHARE = 109,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_25_FORCE = 110,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_25_SLIPPING = 111,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_26_STIFFNESS_SHARE = 112,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_26_STRENGTH_SHARE = 113,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_26_FORCE = 114,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_26_SLIPPING = 115,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_27_STIFFNESS_SHARE = 116,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_27_STRENGTH_SHARE = 117,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_27_FORCE = 118,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_27_SLIPPING = 119,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_28_STIFFNESS_SHARE = 120,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_28_STRENGTH_SHARE = 121,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_28_FORCE = 122,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_28_SLIPPING = 123,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_29_STIFFNESS_SHARE = 124,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_29_STRENGTH_SHARE = 125,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_29_FORCE = 126,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_29_SLIPPING = 127,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_30_STIFFNESS_SHARE = 128,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_30_STRENGTH_SHARE = 129,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_30_FORCE = 130,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_30_SLIPPING = 131,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_31_STIFFNESS_SHARE = 132,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_31_STRENGTH_SHARE = 133,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_31_FORCE = 134,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_31_SLIPPING = 135,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_32_STIFFNESS_SHARE = 136,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_32_STRENGTH_SHARE = 137,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_32_FORCE = 138,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_32_SLIPPING = 139,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_33_STIFFNESS_SHARE = 140,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_33_STRENGTH_SHARE = 141,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_33_FORCE = 142,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_33_SLIPPING = 143,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_34_STIFFNESS_SHARE = 144,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_34_STRENGTH_SHARE = 145,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_34_FORCE = 146,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_34_SLIPPING = 147,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_35_STIFFNESS_SHARE = 148,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_35_STRENGTH_SHARE = 149,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_35_FORCE = 150,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_35_SLIPPING = 151,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_36_STIFFNESS_SHARE = 152,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_36_STRENGTH_SHARE = 153,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_36_FORCE = 154,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_36_SLIPPING = 155,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_37_STIFFNESS_SHARE = 156,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_37_STRENGTH_SHARE = 157,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_37_FORCE = 158,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_37_SLIPPING = 159,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_38_STIFFNESS_SHARE = 160,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_38_STRENGTH_SHARE = 161,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_38_FORCE = 162,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_38_SLIPPING = 163,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_39_STIFFNESS_SHARE = 164,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_39_STRENGTH_SHARE = 165,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_39_FORCE = 166,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_39_SLIPPING = 167,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_40_STIFFNESS_SHARE = 168,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_40_STRENGTH_SHARE = 169,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_40_FORCE = 170,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_40_SLIPPING = 171,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_41_STIFFNESS_SHARE = 172,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_41_STRENGTH_SHARE = 173,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_41_FORCE = 174,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_41_SLIPPING = 175,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_42_STIFFNESS_SHARE = 176,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_42_STRENGTH_SHARE = 177,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_42_FORCE = 178,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_42_SLIPPING = 179,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_43_STIFFNESS_SHARE = 180,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_43_STRENGTH_SHARE = 181,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_43_FORCE = 182,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_43_SLIPPING = 183,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_44_STIFFNESS_SHARE = 184,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_44_STRENGTH_SHARE = 185,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_44_FORCE = 186,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_44_SLIPPING = 187,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_45_STIFFNESS_SHARE = 188,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_45_STRENGTH_SHARE = 189,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_45_FORCE = 190,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_45_SLIPPING = 191,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_46_STIFFNESS_SHARE = 192,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_46_STRENGTH_SHARE = 193,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_46_FORCE = 194,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_46_SLIPPING = 195,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_47_STIFFNESS_SHARE = 196,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_47_STRENGTH_SHARE = 197,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_47_FORCE = 198,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_47_SLIPPING = 199,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_48_STIFFNESS_SHARE = 200,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_48_STRENGTH_SHARE = 201,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_48_FORCE = 202,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_48_SLIPPING = 203,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_49_STIFFNESS_SHARE = 204,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_49_STRENGTH_SHARE = 205,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_49_FORCE = 206,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_49_SLIPPING = 207,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_50_STIFFNESS_SHARE = 208,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_50_STRENGTH_SHARE = 209,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_50_FORCE = 210,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_50_SLIPPING = 211,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_51_STIFFNESS_SHARE = 212,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_51_STRENGTH_SHARE = 213,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_51_FORCE = 214,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_51_SLIPPING = 215,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_52_STIFFNESS_SHARE = 216,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_52_STRENGTH_SHARE = 217,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_52_FORCE = 218,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_52_SLIPPING = 219,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_53_STIFFNESS_SHARE = 220,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_53_STRENGTH_SHARE = 221,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_53_FORCE = 222,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_53_SLIPPING = 223,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_54_STIFFNESS_SHARE = 224,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_54_STRENGTH_SHARE = 225,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_54_FORCE = 226,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_54_SLIPPING = 227,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_55_STIFFNESS_SHARE = 228,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_55_STRENGTH_SHARE = 229,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_55_FORCE = 230,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_55_SLIPPING = 231,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_56_STIFFNESS_SHARE = 232,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_56_STRENGTH_SHARE = 233,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_56_FORCE = 234,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_56_SLIPPING = 235,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_57_STIFFNESS_SHARE = 236,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_57_STRENGTH_SHARE = 237,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_57_FORCE = 238,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_57_SLIPPING = 239,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_58_STIFFNESS_SHARE = 240,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_58_STRENGTH_SHARE = 241,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_58_FORCE = 242,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_58_SLIPPING = 243,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_59_STIFFNESS_SHARE = 244,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_59_STRENGTH_SHARE = 245,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_59_FORCE = 246,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_59_SLIPPING = 247,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_60_STIFFNESS_SHARE = 248,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_60_STRENGTH_SHARE = 249,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_60_FORCE = 250,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_60_SLIPPING = 251,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_61_STIFFNESS_SHARE = 252,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_61_STRENGTH_SHARE = 253,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_61_FORCE = 254,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_61_SLIPPING = 255,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_62_STIFFNESS_SHARE = 256,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_62_STRENGTH_SHARE = 257,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_62_FORCE = 258,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_62_SLIPPING = 259,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_63_STIFFNESS_SHARE = 260,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_63_STRENGTH_SHARE = 261,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_63_FORCE = 262,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_63_SLIPPING = 263,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_64_STIFFNESS_SHARE = 264,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_64_STRENGTH_SHARE = 265,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_64_FORCE = 266,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_64_SLIPPING = 267,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_MAXWELL_SLIP_DISSIPATED_ENERGY = 268,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_MAXWELL_SLIP_FRICTION_FORCE = 269,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_MAXWELL_SLIP_DISSIPATED_POWER = 270,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_MAXWELL_SLIP_STICKING = 271,
} stribeck_maxwell_slip_variable;

/** Guid of Leuven for fmi2Instantiate. */
#define STRIBECK_LEUVEN_GUID "{5eb02a12-d916-797f-9640-ff7071270152}"

/** Leuven: Bristle friction with hysteresis of pre-sliding (Leuven, in the form of Lampaert). Columns of "Leuven". */
typedef enum stribeck_leuven_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_LEUVEN_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LEUVEN_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LEUVEN_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LEUVEN_MU_S = 3,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_LEUVEN_STRIBECK_VELOCITY = 4,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_LEUVEN_STRIBECK_EXPONENT = 5,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_LEUVEN_SIGMA_0 = 6,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_LEUVEN_SIGMA_1 = 7,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_LEUVEN_VISCOUS_COEFFICIENT = 8,
  /** tunable [1]: Exponent of the approach to the steady level (default chosen). (>= 0.1, default 1) */
  STRIBECK_LEUVEN_APPROACH_EXPONENT = 9,
  /** tunable [1]: Strength of all elements together, as a multiple of the static level; not less than 1 (default chosen).
   *  (> 0, default 1.2) */
  STRIBECK_LEUVEN_HYSTERESIS_STRENGTH = 10,
  /** fixed [stribeck_element_distribution]: Where the shares of the elements come from. (default Explicit) */
  STRIBECK_LEUVEN_DISTRIBUTION = 11,
  /** fixed [Integer]: Number of elements in use (default chosen). (>= 1, <= 64, default 4) */
  STRIBECK_LEUVEN_ELEMENT_COUNT = 12,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.5) */
  STRIBECK_LEUVEN_ELEMENT_1_STIFFNESS_SHARE = 13,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_1_STRENGTH_SHARE = 14,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_1_FORCE = 15,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.25) */
  STRIBECK_LEUVEN_ELEMENT_2_STIFFNESS_SHARE = 16,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.2) */
  STRIBECK_LEUVEN_ELEMENT_2_STRENGTH_SHARE = 17,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_2_FORCE = 18,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.15) */
  STRIBECK_LEUVEN_ELEMENT_3_STIFFNESS_SHARE = 19,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.3) */
  STRIBECK_LEUVEN_ELEMENT_3_STRENGTH_SHARE = 20,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_3_FORCE = 21,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_4_STIFFNESS_SHARE = 22,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.4) */
  STRIBECK_LEUVEN_ELEMENT_4_STRENGTH_SHARE = 23,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_4_FORCE = 24,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_5_STIFFNESS_SHARE = 25,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_5_STRENGTH_SHARE = 26,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_5_FORCE = 27,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_6_STIFFNESS_SHARE = 28,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_6_STRENGTH_SHARE = 29,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_6_FORCE = 30,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_7_STIFFNESS_SHARE = 31,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_7_STRENGTH_SHARE = 32,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_7_FORCE = 33,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_8_STIFFNESS_SHARE = 34,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_8_STRENGTH_SHARE = 35,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_8_FORCE = 36,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_9_STIFFNESS_SHARE = 37,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_9_STRENGTH_SHARE = 38,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_9_FORCE = 39,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_10_STIFFNESS_SHARE = 40,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_10_STRENGTH_SHARE = 41,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_10_FORCE = 42,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_11_STIFFNESS_SHARE = 43,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_11_STRENGTH_SHARE = 44,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_11_FORCE = 45,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_12_STIFFNESS_SHARE = 46,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_12_STRENGTH_SHARE = 47,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_12_FORCE = 48,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_13_STIFFNESS_SHARE = 49,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_13_STRENGTH_SHARE = 50,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_13_FORCE = 51,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_14_STIFFNESS_SHARE = 52,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_14_STRENGTH_SHARE = 53,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_14_FORCE = 54,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_15_STIFFNESS_SHARE = 55,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_15_STRENGTH_SHARE = 56,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_15_FORCE = 57,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_16_STIFFNESS_SHARE = 58,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_16_STRENGTH_SHARE = 59,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_16_FORCE = 60,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_17_STIFFNESS_SHARE = 61,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_17_STRENGTH_SHARE = 62,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_17_FORCE = 63,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_18_STIFFNESS_SHARE = 64,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_18_STRENGTH_SHARE = 65,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_18_FORCE = 66,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_19_STIFFNESS_SHARE = 67,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_19_STRENGTH_SHARE = 68,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_19_FORCE = 69,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_20_STIFFNESS_SHARE = 70,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_20_STRENGTH_SHARE = 71,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_20_FORCE = 72,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_21_STIFFNESS_SHARE = 73,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_21_STRENGTH_SHARE = 74,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_21_FORCE = 75,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_22_STIFFNESS_SHARE = 76,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_22_STRENGTH_SHARE = 77,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_22_FORCE = 78,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_23_STIFFNESS_SHARE = 79,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_23_STRENGTH_SHARE = 80,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_23_FORCE = 81,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_24_STIFFNESS_SHARE = 82,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_24_STRENGTH_SHARE = 83,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_24_FORCE = 84,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_25_STIFFNESS_SHARE = 85,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_25_STRENGTH_SHARE = 86,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_25_FORCE = 87,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_26_STIFFNESS_SHARE = 88,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_26_STRENGTH_SHARE = 89,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_26_FORCE = 90,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_27_STIFFNESS_SHARE = 91,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_27_STRENGTH_SHARE = 92,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_27_FORCE = 93,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_28_STIFFNESS_SHARE = 94,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_28_STRENGTH_SHARE = 95,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_28_FORCE = 96,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_29_STIFFNESS_SHARE = 97,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_29_STRENGTH_SHARE = 98,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_29_FORCE = 99,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_30_STIFFNESS_SHARE = 100,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_30_STRENGTH_SHARE = 101,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_30_FORCE = 102,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_31_STIFFNESS_SHARE = 103,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_31_STRENGTH_SHARE = 104,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_31_FORCE = 105,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_32_STIFFNESS_SHARE = 106,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_32_STRENGTH_SHARE = 107,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_32_FORCE = 108,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_33_STIFFNESS_SHARE = 109,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_33_STRENGTH_SHARE = 110,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_33_FORCE = 111,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_34_STIFFNESS_SHARE = 112,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_34_STRENGTH_SHARE = 113,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_34_FORCE = 114,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_35_STIFFNESS_SHARE = 115,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_35_STRENGTH_SHARE = 116,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_35_FORCE = 117,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_36_STIFFNESS_SHARE = 118,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_36_STRENGTH_SHARE = 119,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_36_FORCE = 120,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_37_STIFFNESS_SHARE = 121,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_37_STRENGTH_SHARE = 122,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_37_FORCE = 123,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_38_STIFFNESS_SHARE = 124,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_38_STRENGTH_SHARE = 125,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_38_FORCE = 126,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_39_STIFFNESS_SHARE = 127,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_39_STRENGTH_SHARE = 128,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_39_FORCE = 129,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_40_STIFFNESS_SHARE = 130,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_40_STRENGTH_SHARE = 131,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_40_FORCE = 132,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_41_STIFFNESS_SHARE = 133,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_41_STRENGTH_SHARE = 134,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_41_FORCE = 135,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_42_STIFFNESS_SHARE = 136,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_42_STRENGTH_SHARE = 137,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_42_FORCE = 138,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_43_STIFFNESS_SHARE = 139,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_43_STRENGTH_SHARE = 140,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_43_FORCE = 141,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_44_STIFFNESS_SHARE = 142,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_44_STRENGTH_SHARE = 143,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_44_FORCE = 144,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_45_STIFFNESS_SHARE = 145,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_45_STRENGTH_SHARE = 146,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_45_FORCE = 147,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_46_STIFFNESS_SHARE = 148,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_46_STRENGTH_SHARE = 149,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_46_FORCE = 150,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_47_STIFFNESS_SHARE = 151,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_47_STRENGTH_SHARE = 152,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_47_FORCE = 153,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_48_STIFFNESS_SHARE = 154,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_48_STRENGTH_SHARE = 155,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_48_FORCE = 156,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_49_STIFFNESS_SHARE = 157,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_49_STRENGTH_SHARE = 158,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_49_FORCE = 159,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_50_STIFFNESS_SHARE = 160,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_50_STRENGTH_SHARE = 161,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_50_FORCE = 162,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_51_STIFFNESS_SHARE = 163,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_51_STRENGTH_SHARE = 164,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_51_FORCE = 165,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_52_STIFFNESS_SHARE = 166,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_52_STRENGTH_SHARE = 167,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_52_FORCE = 168,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_53_STIFFNESS_SHARE = 169,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_53_STRENGTH_SHARE = 170,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_53_FORCE = 171,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_54_STIFFNESS_SHARE = 172,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_54_STRENGTH_SHARE = 173,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_54_FORCE = 174,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_55_STIFFNESS_SHARE = 175,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_55_STRENGTH_SHARE = 176,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_55_FORCE = 177,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_56_STIFFNESS_SHARE = 178,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_56_STRENGTH_SHARE = 179,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_56_FORCE = 180,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_57_STIFFNESS_SHARE = 181,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_57_STRENGTH_SHARE = 182,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_57_FORCE = 183,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_58_STIFFNESS_SHARE = 184,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_58_STRENGTH_SHARE = 185,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_58_FORCE = 186,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_59_STIFFNESS_SHARE = 187,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_59_STRENGTH_SHARE = 188,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_59_FORCE = 189,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_60_STIFFNESS_SHARE = 190,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_60_STRENGTH_SHARE = 191,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_60_FORCE = 192,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_61_STIFFNESS_SHARE = 193,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_61_STRENGTH_SHARE = 194,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_61_FORCE = 195,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_62_STIFFNESS_SHARE = 196,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_62_STRENGTH_SHARE = 197,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_62_FORCE = 198,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_63_STIFFNESS_SHARE = 199,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_63_STRENGTH_SHARE = 200,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_63_FORCE = 201,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_64_STIFFNESS_SHARE = 202,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_64_STRENGTH_SHARE = 203,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_64_FORCE = 204,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_LEUVEN_BRISTLE_DEFLECTION = 205,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LEUVEN_DISSIPATED_ENERGY = 206,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LEUVEN_FRICTION_FORCE = 207,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LEUVEN_DISSIPATED_POWER = 208,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LEUVEN_STICKING = 209,
} stribeck_leuven_variable;

/** Guid of Gonthier for fmi2Instantiate. */
#define STRIBECK_GONTHIER_GUID "{42fa2fc2-775c-cded-96c6-6470d75d4139}"

/** Gonthier: Bristle friction with dwell time (Gonthier). Columns of "Gonthier". */
typedef enum stribeck_gonthier_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_GONTHIER_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_GONTHIER_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_GONTHIER_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_GONTHIER_MU_S = 3,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_GONTHIER_STRIBECK_VELOCITY = 4,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 1e-5) */
  STRIBECK_GONTHIER_TRANSITION_VELOCITY = 5,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_GONTHIER_SIGMA_0 = 6,
  /** tunable [N.s/m]: Damping of the bristles. (> 0, default 316.22776601683796) */
  STRIBECK_GONTHIER_SIGMA_1 = 7,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_GONTHIER_VISCOUS_COEFFICIENT = 8,
  /** tunable [s]: Time constant with which the static level rises at rest. (> 0, default 2) */
  STRIBECK_GONTHIER_DWELL_TIME_CONSTANT = 9,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_GONTHIER_BRISTLE_DEFLECTION = 10,
  /** state [1]: Memory of the time at rest: 0 after sliding, 1 after a long rest. (>= 0, <= 1, default 0) */
  STRIBECK_GONTHIER_DWELL = 11,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_GONTHIER_DISSIPATED_ENERGY = 12,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_GONTHIER_FRICTION_FORCE = 13,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_GONTHIER_DISSIPATED_POWER = 14,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_GONTHIER_STICKING = 15,
} stribeck_gonthier_variable;

/** Guid of Liang for fmi2Instantiate. */
#define STRIBECK_LIANG_GUID "{a8a88c6c-69e0-5d83-f43c-264b3bc7ce95}"

/** Liang: Bristle friction in space (Liang). Columns of "Liang". */
typedef enum stribeck_liang_variable {
  /** in [m/s]: Velocity of body 1 relative to body 2, component x. (default 0) */
  STRIBECK_LIANG_VELOCITY_X = 0,
  /** in [m/s]: Velocity of body 1 relative to body 2, component y. (default 0) */
  STRIBECK_LIANG_VELOCITY_Y = 1,
  /** in [m/s]: Velocity of body 1 relative to body 2, component z. (default 0) */
  STRIBECK_LIANG_VELOCITY_Z = 2,
  /** in [1]: Normal of the contact, component x; the length does not matter. (default 0) */
  STRIBECK_LIANG_NORMAL_X = 3,
  /** in [1]: Normal of the contact, component y; the length does not matter. (default 0) */
  STRIBECK_LIANG_NORMAL_Y = 4,
  /** in [1]: Normal of the contact, component z; the length does not matter. (default 1) */
  STRIBECK_LIANG_NORMAL_Z = 5,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LIANG_NORMAL_FORCE = 6,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LIANG_MU_K = 7,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LIANG_MU_S = 8,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_LIANG_TRANSITION_VELOCITY = 9,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_LIANG_SIGMA_0 = 10,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_LIANG_SIGMA_1 = 11,
  /** fixed [stribeck_liang_variant]: Variant of the law. (default RadialReturn) */
  STRIBECK_LIANG_VARIANT = 12,
  /** state [m]: Elastic deflection of the bristles, component x. (default 0) */
  STRIBECK_LIANG_BRISTLE_DEFLECTION_X = 13,
  /** state [m]: Elastic deflection of the bristles, component y. (default 0) */
  STRIBECK_LIANG_BRISTLE_DEFLECTION_Y = 14,
  /** state [m]: Elastic deflection of the bristles, component z. (default 0) */
  STRIBECK_LIANG_BRISTLE_DEFLECTION_Z = 15,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LIANG_DISSIPATED_ENERGY = 16,
  /** out [N]: Friction force, component x; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LIANG_FRICTION_FORCE_X = 17,
  /** out [N]: Friction force, component y; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LIANG_FRICTION_FORCE_Y = 18,
  /** out [N]: Friction force, component z; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LIANG_FRICTION_FORCE_Z = 19,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LIANG_DISSIPATED_POWER = 20,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LIANG_STICKING = 21,
} stribeck_liang_variable;

/** Guid of LuGrePlanar for fmi2Instantiate. */
#define STRIBECK_LUGRE_PLANAR_GUID "{665ef91d-b628-8f64-4c98-d8d6b5ac8ad4}"

/** LuGrePlanar: Bristle friction with Stribeck effect in a plane (LuGre). Columns of "LuGrePlanar". */
typedef enum stribeck_lugre_planar_variable {
  /** in [m/s]: Velocity of body 1 relative to body 2, component x. (default 0) */
  STRIBECK_LUGRE_PLANAR_VELOCITY_X = 0,
  /** in [m/s]: Velocity of body 1 relative to body 2, component y. (default 0) */
  STRIBECK_LUGRE_PLANAR_VELOCITY_Y = 1,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LUGRE_PLANAR_NORMAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LUGRE_PLANAR_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LUGRE_PLANAR_MU_S = 4,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_LUGRE_PLANAR_STRIBECK_VELOCITY = 5,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_LUGRE_PLANAR_STRIBECK_EXPONENT = 6,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_LUGRE_PLANAR_SIGMA_0 = 7,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_LUGRE_PLANAR_SIGMA_1 = 8,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_LUGRE_PLANAR_VISCOUS_COEFFICIENT = 9,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_LUGRE_PLANAR_DAMPING_VELOCITY = 10,
  /** state [m]: Elastic deflection of the bristles, component x. (default 0) */
  STRIBECK_LUGRE_PLANAR_BRISTLE_DEFLECTION_X = 11,
  /** state [m]: Elastic deflection of the bristles, component y. (default 0) */
  STRIBECK_LUGRE_PLANAR_BRISTLE_DEFLECTION_Y = 12,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LUGRE_PLANAR_DISSIPATED_ENERGY = 13,
  /** out [N]: Friction force, component x; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LUGRE_PLANAR_FRICTION_FORCE_X = 14,
  /** out [N]: Friction force, component y; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LUGRE_PLANAR_FRICTION_FORCE_Y = 15,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LUGRE_PLANAR_DISSIPATED_POWER = 16,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LUGRE_PLANAR_STICKING = 17,
} stribeck_lugre_planar_variable;

/** Guid of ElastoPlasticPlanar for fmi2Instantiate. */
#define STRIBECK_ELASTO_PLASTIC_PLANAR_GUID "{e9f5ed33-430e-0fb4-5efd-07a8506903de}"

/** ElastoPlasticPlanar: Bristle friction without drift below breakaway, in a plane (elasto-plastic). Columns of "ElastoPlasticPlanar". */
typedef enum stribeck_elasto_plastic_planar_variable {
  /** in [m/s]: Velocity of body 1 relative to body 2, component x. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_VELOCITY_X = 0,
  /** in [m/s]: Velocity of body 1 relative to body 2, component y. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_VELOCITY_Y = 1,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_NORMAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_MU_S = 4,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_STRIBECK_VELOCITY = 5,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_STRIBECK_EXPONENT = 6,
  /** tunable [1]: Part of the deflection of steady sliding up to which the contact is purely elastic.
   *  (> 0, <= 0.99, default 0.7) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_BREAKAWAY_RATIO = 7,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_SIGMA_0 = 8,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_SIGMA_1 = 9,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_VISCOUS_COEFFICIENT = 10,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_DAMPING_VELOCITY = 11,
  /** state [m]: Elastic deflection of the bristles, component x. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_BRISTLE_DEFLECTION_X = 12,
  /** state [m]: Elastic deflection of the bristles, component y. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_BRISTLE_DEFLECTION_Y = 13,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_DISSIPATED_ENERGY = 14,
  /** out [N]: Friction force, component x; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ELASTO_PLASTIC_PLANAR_FRICTION_FORCE_X = 15,
  /** out [N]: Friction force, component y; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ELASTO_PLASTIC_PLANAR_FRICTION_FORCE_Y = 16,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ELASTO_PLASTIC_PLANAR_DISSIPATED_POWER = 17,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ELASTO_PLASTIC_PLANAR_STICKING = 18,
} stribeck_elasto_plastic_planar_variable;

/** Guid of ShockAbsorber for fmi2Instantiate. */
#define STRIBECK_SHOCK_ABSORBER_GUID "{b8b67bdc-0cb7-0992-180b-49e1f88da5c0}"

/** ShockAbsorber: Telescopic shock absorber with friction from its side load. Columns of "ShockAbsorber". */
typedef enum stribeck_shock_absorber_variable {
  /** in [m]: Distance of the eyes, or travel of the host: see adapter. (default 0.1775) */
  STRIBECK_SHOCK_ABSORBER_LENGTH = 0,
  /** in [m/s]: Time derivative of the length; positive in extension. (default 0) */
  STRIBECK_SHOCK_ABSORBER_VELOCITY = 1,
  /** in [N]: Transverse force of the tube on the rod along m, at the eye of the tube; or lambda_1. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_FORCE_M = 2,
  /** in [N]: Transverse force of the tube on the rod along n, at the eye of the tube; or lambda_2. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_FORCE_N = 3,
  /** in [N.m]: Moment of the tube on the rod about m, at the eye of the tube; or lambda_3. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_MOMENT_M = 4,
  /** in [N.m]: Moment of the tube on the rod about n, at the eye of the tube; or lambda_4. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_MOMENT_N = 5,
  /** in [rad/s]: Spin of the rod relative to the tube, about the axis from tube to rod. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPIN_RATE = 6,
  /** in [N]: All other forces along the strut, positive in extension; only for laws that hold a load at rest.
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_EXTERNAL_FORCE = 7,
  /** in [m/s2]: Time derivative of the velocity; for num.input_mode = Linear and for laws that use it. (default 0) */
  STRIBECK_SHOCK_ABSORBER_ACCELERATION = 8,
  /** in [K]: Ambient temperature; used if thermal.enabled is true. (>= 0, default 293.15) */
  STRIBECK_SHOCK_ABSORBER_TEMPERATURE_AMBIENT = 9,
  /** fixed [m]: Distance of the eyes at full extension (default chosen). (> 0, default 0.2) */
  STRIBECK_SHOCK_ABSORBER_GEOM_LENGTH_EXTENDED = 10,
  /** fixed [m]: Stroke from full extension to full compression. (> 0, default 0.055) */
  STRIBECK_SHOCK_ABSORBER_GEOM_STROKE = 11,
  /** fixed [Boolean]: Are d_i and d_j derived from length_extended and stroke? (default false) */
  STRIBECK_SHOCK_ABSORBER_GEOM_GUIDANCE_DERIVED = 12,
  /** fixed [m]: Distance from the eye of the tube to the rod guide (default chosen). (> 0, default 0.125) */
  STRIBECK_SHOCK_ABSORBER_GEOM_D_I = 13,
  /** fixed [m]: Distance from the eye of the rod to the piston (default chosen). (> 0, default 0.105) */
  STRIBECK_SHOCK_ABSORBER_GEOM_D_J = 14,
  /** fixed [m]: Overlap below which the contact forces are kept finite (default chosen). (>= 0, default 0.002) */
  STRIBECK_SHOCK_ABSORBER_GEOM_H_REG = 15,
  /** fixed [m]: Radius of the rod, at the rod guide (default chosen). (>= 0, default 0.007) */
  STRIBECK_SHOCK_ABSORBER_GEOM_R_1 = 16,
  /** fixed [m]: Radius of the piston (default chosen). (>= 0, default 0.0125) */
  STRIBECK_SHOCK_ABSORBER_GEOM_R_2 = 17,
  /** fixed [Boolean]: Is there a spring? (default true) */
  STRIBECK_SHOCK_ABSORBER_SPRING_ENABLED = 18,
  /** fixed [stribeck_spring_mode]: Form of the spring's characteristic. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_SPRING_MODE = 19,
  /** tunable [N/m]: Stiffness. (>= 0, default 45000) */
  STRIBECK_SHOCK_ABSORBER_SPRING_K = 20,
  /** tunable [N]: Force at full extension (default chosen). (default 150) */
  STRIBECK_SHOCK_ABSORBER_SPRING_PRELOAD = 21,
  /** fixed [Integer]: Number of points of the table in use (default chosen). (>= 2, <= 16, default 3) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_N = 22,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_1 = 23,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0.03) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_2 = 24,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0.055) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_3 = 25,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_4 = 26,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_5 = 27,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_6 = 28,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_7 = 29,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_8 = 30,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_9 = 31,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_10 = 32,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_11 = 33,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_12 = 34,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_13 = 35,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_14 = 36,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_15 = 37,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_16 = 38,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_1 = 39,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 1350) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_2 = 40,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 2850) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_3 = 41,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_4 = 42,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_5 = 43,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_6 = 44,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_7 = 45,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_8 = 46,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_9 = 47,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_10 = 48,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_11 = 49,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_12 = 50,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_13 = 51,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_14 = 52,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_15 = 53,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_16 = 54,
  /** fixed [Boolean]: Is there a gas force? (default true) */
  STRIBECK_SHOCK_ABSORBER_GAS_ENABLED = 55,
  /** tunable [Pa]: Absolute gas pressure at full extension (default chosen). (>= 0, default 1000000) */
  STRIBECK_SHOCK_ABSORBER_GAS_P0 = 56,
  /** fixed [m3]: Gas volume at full extension (default chosen). (> 0, default 3e-5) */
  STRIBECK_SHOCK_ABSORBER_GAS_V0 = 57,
  /** fixed [1]: Polytropic exponent (default chosen). (>= 0, default 1.2) */
  STRIBECK_SHOCK_ABSORBER_GAS_N = 58,
  /** fixed [m]: Diameter of the rod (default chosen). (>= 0, default 0.014) */
  STRIBECK_SHOCK_ABSORBER_GAS_ROD_DIAMETER = 59,
  /** tunable [Pa]: Ambient pressure. (>= 0, default 101325) */
  STRIBECK_SHOCK_ABSORBER_GAS_P_AMBIENT = 60,
  /** fixed [Boolean]: Is there a bump stop? (default true) */
  STRIBECK_SHOCK_ABSORBER_BUMP_ENABLED = 61,
  /** fixed [m]: Compression from full extension at which the bump stop is touched (default chosen). (default 0.04) */
  STRIBECK_SHOCK_ABSORBER_BUMP_GAP = 62,
  /** fixed [stribeck_bump_mode]: Form of the bump stop's characteristic. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_BUMP_MODE = 63,
  /** tunable [N/m]: Stiffness: of the linear form, and first coefficient of the cubic one (default chosen).
   *  (>= 0, default 150000) */
  STRIBECK_SHOCK_ABSORBER_BUMP_K = 64,
  /** tunable [1]: Exponent of the power form (default chosen). (>= 1, default 2.2) */
  STRIBECK_SHOCK_ABSORBER_BUMP_N = 65,
  /** tunable [m]: Compression at which the power form has the force F_ref (default chosen). (> 0, default 0.01) */
  STRIBECK_SHOCK_ABSORBER_BUMP_X_REF = 66,
  /** tunable [N]: Force of the power form at x_ref (default chosen). (>= 0, default 1500) */
  STRIBECK_SHOCK_ABSORBER_BUMP_F_REF = 67,
  /** tunable [N/m2]: Second coefficient of the cubic form. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_BUMP_K2 = 68,
  /** tunable [N/m3]: Third coefficient of the cubic form. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_BUMP_K3 = 69,
  /** tunable [N.s/m]: Damping while the stop is touched. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_BUMP_C = 70,
  /** fixed [Boolean]: Is there a rebound stop? (default true) */
  STRIBECK_SHOCK_ABSORBER_REBOUND_ENABLED = 71,
  /** fixed [m]: Compression from full extension at which the rebound stop is touched. (default 0) */
  STRIBECK_SHOCK_ABSORBER_REBOUND_GAP = 72,
  /** tunable [N/m]: Stiffness (default chosen). (>= 0, default 1000000) */
  STRIBECK_SHOCK_ABSORBER_REBOUND_K = 73,
  /** tunable [N.s/m]: Damping while the stop is touched. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_REBOUND_C = 74,
  /** fixed [Boolean]: Is there a damper? (default true) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_ENABLED = 75,
  /** fixed [stribeck_damper_mode]: Form of the damper's characteristic. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MODE = 76,
  /** tunable [N.s/m]: Damping coefficient in compression (default chosen). (>= 0, default 1500) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_C_COMP = 77,
  /** tunable [N.s/m]: Damping coefficient in extension, the rebound (default chosen). (>= 0, default 2300) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_C_REB = 78,
  /** tunable [s/m]: Degression in compression. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_DEGR_COMP = 79,
  /** tunable [s/m]: Degression in extension. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_DEGR_REB = 80,
  /** fixed [Integer]: Number of points of the table in use (default chosen). (>= 2, <= 16, default 11) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_N = 81,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_1 = 82,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.5) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_2 = 83,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.25) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_3 = 84,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_4 = 85,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.05) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_5 = 86,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_6 = 87,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.05) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_7 = 88,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_8 = 89,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.25) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_9 = 90,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.5) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_10 = 91,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_11 = 92,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_12 = 93,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_13 = 94,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_14 = 95,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_15 = 96,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_16 = 97,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -1150) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_1 = 98,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -700) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_2 = 99,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -430) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_3 = 100,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -210) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_4 = 101,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -110) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_5 = 102,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_6 = 103,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 180) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_7 = 104,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 340) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_8 = 105,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 640) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_9 = 106,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 950) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_10 = 107,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 1500) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_11 = 108,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_12 = 109,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_13 = 110,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_14 = 111,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_15 = 112,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_16 = 113,
  /** fixed [stribeck_interpolation]: Curve through the points of the table. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_INTERPOLATION = 114,
  /** tunable [1]: Factor on the damper force. (>= 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_SCALE = 115,
  /** fixed [N/m]: Stiffness in series with the damper, of oil and top mount; 0 = rigid. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_K_SERIES = 116,
  /** fixed [stribeck_friction_model]: Friction law; parameters of other laws are ignored. (default LuGre) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MODEL = 117,
  /** tunable [stribeck_friction_switch]: Active parts of the friction. (default On) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SWITCH = 118,
  /** tunable [1]: Friction in compression over friction in extension: (1 + asymmetry) / (1 - asymmetry).
   *  (>= -0.99, <= 0.99, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ASYMMETRY = 119,
  /** tunable [1]: Factor on all friction levels. (>= 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SCALE = 120,
  /** tunable [kg]: Effective mass of the body, for laws that use it; 0 = law as printed. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MASS = 121,
  /** fixed [stribeck_exchange]: Order in which the master exchanges force and motion; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_EXCHANGE = 122,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_STRIBECK_VELOCITY = 123,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_STRIBECK_EXPONENT = 124,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SIGMA_0 = 125,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SIGMA_1 = 126,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_VISCOUS_COEFFICIENT = 127,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DAMPING_VELOCITY = 128,
  /** fixed [stribeck_coulomb_viscous_variant]: Variant of the law. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_COULOMBVISCOUS_VARIANT = 129,
  /** tunable [1]: Exponent of the viscous part. (> 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_VISCOUS_EXPONENT = 130,
  /** fixed [stribeck_stribeck_curve]: How the level falls with speed. (default Gaussian) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_CURVE = 131,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_STRIBECK_VISCOUS_COEFFICIENT = 132,
  /** tunable [N.s2/m2]: Quadratic friction coefficient; used by PoppStelter. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_QUADRATIC_COEFFICIENT = 133,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 2000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TRANSITION_SLOPE = 134,
  /** fixed [stribeck_threlfall_variant]: Variant of the law. (default Printed) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_THRELFALL_VARIANT = 135,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TRANSITION_VELOCITY = 136,
  /** fixed [stribeck_rooney_deravi_variant]: Variant of the law. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ROONEYDERAVI_VARIANT = 137,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (>= 0, default 0.0001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_AMBROSIO_TRANSITION_VELOCITY = 138,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SLIDING_VELOCITY = 139,
  /** fixed [stribeck_bengisu_akay_variant]: Variant of the law. (default Thesis) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BENGISUAKAY_VARIANT = 140,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 5000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BENGISUAKAY_TRANSITION_SLOPE = 141,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 500) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_STICTION_DECAY = 142,
  /** tunable [s/m]: Viscous coefficient of friction, per normal force. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MU_V = 143,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 10000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ANDERSSON_TRANSITION_SLOPE = 144,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ANDERSSON_VISCOUS_COEFFICIENT = 145,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_AWREJCEWICZ_STICTION_DECAY = 146,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SPECKER_TRANSITION_VELOCITY = 147,
  /** tunable [m/s]: Velocity at which the static level is reached (default chosen). (> 0, default 0.0005) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_PEAK_VELOCITY = 148,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SPECKER_VISCOUS_COEFFICIENT = 149,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.0015) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_LINEARSTICTION_SLIDING_VELOCITY = 150,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BROWNMCPHEE_VISCOUS_COEFFICIENT = 151,
  /** tunable [N]: Normal force at which the viscous part is fully active (default chosen). (> 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TRANSITION_NORMAL_FORCE = 152,
  /** tunable [1]: Exponent of the transition to sliding; below 1 brittle, from 1 on ductile. (>= 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ALPHA = 153,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_FRICTIONALLAG_VISCOUS_COEFFICIENT = 154,
  /** fixed [s]: Time by which the level of friction lags behind the velocity (default chosen). (>= 0, default 0.005) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TIME_LAG = 155,
  /** fixed [stribeck_frictional_lag_variant]: Variant of the law. (default Delay) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_FRICTIONALLAG_VARIANT = 156,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ARMSTRONG_VISCOUS_COEFFICIENT = 157,
  /** tunable [s]: Dwell time after which half of the rise of the static friction has occurred (default chosen).
   *  (>= 0, default 2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_GAMMA = 158,
  /** tunable [1]: Coefficient of friction that a contact reaches when it comes to rest; not more than mu_s (default chosen).
   *  (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MU_STOP = 159,
  /** tunable [s/m]: Steepness of the curve while speeding up (default chosen). (> 0, default 500) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ACCELERATION_DECAY = 160,
  /** tunable [s/m]: Steepness of the curve while slowing down (default chosen). (> 0, default 500) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DECELERATION_DECAY = 161,
  /** tunable [s/m]: Steepness of the curves for speeding up and slowing down (default chosen). (> 0, default 500) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BRANCH_DECAY = 162,
  /** fixed [stribeck_bliman_sorine_order]: Variant of the law. (default Second) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BLIMANSORINE_VARIANT = 163,
  /** tunable [1]: Level of the slow relaxation, as a coefficient of friction; second order (default calibrated).
   *  (>= 0, default 0.2732050807568877) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MU_2 = 164,
  /** tunable [1]: Length of the fast relaxation as a part of that of the slow one; second order (default chosen).
   *  (> 0, <= 1, default 0.5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ETA = 165,
  /** tunable [m]: Sliding distance in which the slow relaxation settles to 1/e (default calibrated).
   *  (> 0, default 4.642141842225068e-5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_EPS_F = 166,
  /** tunable [m]: Shear deflection of the asperities in steady sliding (default f_C / sigma_0 of the thesis).
   *  (> 0, default 9.81e-6) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DELTA_T = 167,
  /** tunable [1]: Part of the deflection of steady sliding up to which the contact is purely elastic.
   *  (> 0, <= 1, default 0.7) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BREAKAWAY_RATIO = 168,
  /** tunable [Integer]: Exponent of the transition from elastic deflection to sliding; odd. (>= 1, <= 9, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_PLASTIC_EXPONENT = 169,
  /** tunable [m]: Strain at which a bristle snaps (default f_s / sigma_0 of the thesis). (> 0, default 1.4715e-5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DELTA = 170,
  /** fixed [Integer]: Number of bristles (default chosen). (>= 1, <= 64, default 25) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BRISTLE_COUNT = 171,
  /** fixed [Integer]: Seed of the random numbers. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SEED = 172,
  /** fixed [stribeck_initial_bonds]: State of the bristles when the motion starts. (default Bonded) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_INITIAL_BONDS = 173,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SPECKERDYNAMIC_TRANSITION_VELOCITY = 174,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SPECKERDYNAMIC_VISCOUS_COEFFICIENT = 175,
  /** tunable [s]: Time constant of the force while sliding (default chosen). (> 0, default 0.001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SLIP_TIME = 176,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MAXWELLSLIP_SIGMA_1 = 177,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MAXWELLSLIP_VISCOUS_COEFFICIENT = 178,
  /** tunable [N/s]: Rate at which the slipping elements together approach their level (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ATTRACTION = 179,
  /** fixed [stribeck_element_distribution]: Where the shares of the elements come from. (default Explicit) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DISTRIBUTION = 180,
  /** fixed [Integer]: Number of elements in use (default chosen). (>= 1, <= 16, default 4) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_COUNT = 181,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_1_STIFFNESS_SHARE = 182,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_1_STRENGTH_SHARE = 183,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.25) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_2_STIFFNESS_SHARE = 184,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_2_STRENGTH_SHARE = 185,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.15) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_3_STIFFNESS_SHARE = 186,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.3) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_3_STRENGTH_SHARE = 187,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_4_STIFFNESS_SHARE = 188,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.4) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_4_STRENGTH_SHARE = 189,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_5_STIFFNESS_SHARE = 190,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_5_STRENGTH_SHARE = 191,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_6_STIFFNESS_SHARE = 192,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_6_STRENGTH_SHARE = 193,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_7_STIFFNESS_SHARE = 194,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_7_STRENGTH_SHARE = 195,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_8_STIFFNESS_SHARE = 196,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_8_STRENGTH_SHARE = 197,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_9_STIFFNESS_SHARE = 198,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_9_STRENGTH_SHARE = 199,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_10_STIFFNESS_SHARE = 200,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_10_STRENGTH_SHARE = 201,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_11_STIFFNESS_SHARE = 202,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_11_STRENGTH_SHARE = 203,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_12_STIFFNESS_SHARE = 204,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_12_STRENGTH_SHARE = 205,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_13_STIFFNESS_SHARE = 206,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_13_STRENGTH_SHARE = 207,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_14_STIFFNESS_SHARE = 208,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_14_STRENGTH_SHARE = 209,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_15_STIFFNESS_SHARE = 210,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_15_STRENGTH_SHARE = 211,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_16_STIFFNESS_SHARE = 212,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_16_STRENGTH_SHARE = 213,
  /** tunable [1]: Exponent of the approach to the steady level (default chosen). (>= 0.1, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_APPROACH_EXPONENT = 214,
  /** tunable [1]: Strength of all elements together, as a multiple of the static level; not less than 1 (default chosen).
   *  (> 0, default 1.2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_HYSTERESIS_STRENGTH = 215,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 1e-5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_GONTHIER_TRANSITION_VELOCITY = 216,
  /** tunable [s]: Time constant with which the static level rises at rest. (> 0, default 2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DWELL_TIME_CONSTANT = 217,
  /** tunable [1]: Static coefficient of friction; not less than mu_k (default chosen). (>= 0, default 0.15) */
  STRIBECK_SHOCK_ABSORBER_C1_MU_S = 218,
  /** tunable [1]: Kinetic coefficient of friction (default chosen). (>= 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_C1_MU_K = 219,
  /** tunable [N]: Breakaway force without normal force, e.g. of a seal; not less than preload_k (default chosen).
   *  (>= 0, default 10) */
  STRIBECK_SHOCK_ABSORBER_C1_PRELOAD_S = 220,
  /** tunable [N]: Sliding friction force without normal force, e.g. of a seal (default chosen). (>= 0, default 8) */
  STRIBECK_SHOCK_ABSORBER_C1_PRELOAD_K = 221,
  /** tunable [1]: Static coefficient of friction; not less than mu_k (default chosen). (>= 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_C2_MU_S = 222,
  /** tunable [1]: Kinetic coefficient of friction (default chosen). (>= 0, default 0.08) */
  STRIBECK_SHOCK_ABSORBER_C2_MU_K = 223,
  /** tunable [N]: Breakaway force without normal force, e.g. of a seal; not less than preload_k (default chosen).
   *  (>= 0, default 8) */
  STRIBECK_SHOCK_ABSORBER_C2_PRELOAD_S = 224,
  /** tunable [N]: Sliding friction force without normal force, e.g. of a seal (default chosen). (>= 0, default 6) */
  STRIBECK_SHOCK_ABSORBER_C2_PRELOAD_K = 225,
  /** fixed [stribeck_side_mode]: Side loads that act on the joint. (default Sum) */
  STRIBECK_SHOCK_ABSORBER_SIDE_MODE = 226,
  /** fixed [stribeck_side_convention]: Meaning of the four side-load inputs. (default WrenchOnRod) */
  STRIBECK_SHOCK_ABSORBER_SIDE_CONVENTION = 227,
  /** tunable [m]: Offset of the spring's line of action along m (default chosen). (default 0.003) */
  STRIBECK_SHOCK_ABSORBER_SIDE_OFFSET_M = 228,
  /** tunable [m]: Offset of the spring's line of action along n. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_OFFSET_N = 229,
  /** tunable [1]: Side force of the spring along m, relative to its axial force; it acts at the eye of the tube.
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_FORCE_RATIO = 230,
  /** fixed [stribeck_normal_sum]: Rule for the loads of the contacts from the load of the joint. (default TwoPoint) */
  STRIBECK_SHOCK_ABSORBER_SIDE_NORMAL_SUM = 231,
  /** tunable [1]: Factor on the contact forces for the distribution of pressure; 4 / pi for a cosine over half the rim.
   *  (>= 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_SIDE_C_GEO = 232,
  /** fixed [Boolean]: Does the temperature change and affect the damper force? (default false) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_ENABLED = 233,
  /** tunable [1/K]: Relative loss of damper force per kelvin (default chosen). (>= 0, default 0.003) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_BETA = 234,
  /** fixed [K]: Temperature at which the damper's characteristic was measured (default chosen).
   *  (> 0, default 293.15) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_TEMPERATURE_REF = 235,
  /** fixed [J/K]: Heat capacity of the damper (default chosen: 0.6 kg of aluminium and oil). (> 0, default 600) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_CAPACITY = 236,
  /** tunable [W/K]: Heat flow to the surroundings per kelvin (default chosen). (>= 0, default 1.5) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_CONDUCTANCE = 237,
  /** fixed [m]: Length of the strut when the input length is 0. (default 0) */
  STRIBECK_SHOCK_ABSORBER_ADAPTER_LENGTH_OFFSET = 238,
  /** fixed [1]: Length of the strut per input length; -MR for wheel travel, -0.001 for millimetres of compression.
   *  (default 1) */
  STRIBECK_SHOCK_ABSORBER_ADAPTER_LENGTH_GAIN = 239,
  /** fixed [1]: Factor on force_travel, for the host's unit of force. (default 1) */
  STRIBECK_SHOCK_ABSORBER_ADAPTER_FORCE_GAIN = 240,
  /** fixed [s]: Largest internal step (default chosen). (> 0, default 0.0001) */
  STRIBECK_SHOCK_ABSORBER_NUM_H_MAX = 241,
  /** fixed [stribeck_input_mode]: Motion of the inputs within a step. (default Hold) */
  STRIBECK_SHOCK_ABSORBER_NUM_INPUT_MODE = 242,
  /** tunable [kg]: Mass that the strut carries or moves, whichever is smaller; for the advice step_limit only.
   *  (> 0, default 16.4) */
  STRIBECK_SHOCK_ABSORBER_NUM_MASS_REF = 243,
  /** fixed [stribeck_friction_start]: Initial state of the friction law. (default Steady) */
  STRIBECK_SHOCK_ABSORBER_INIT_FRICTION_STATE = 244,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_1 = 245,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_2 = 246,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_3 = 247,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_4 = 248,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_5 = 249,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_6 = 250,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_7 = 251,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_8 = 252,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_9 = 253,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_10 = 254,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_11 = 255,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_12 = 256,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_13 = 257,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_14 = 258,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_15 = 259,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_16 = 260,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_17 = 261,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_18 = 262,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_19 = 263,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_20 = 264,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_21 = 265,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_22 = 266,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_23 = 267,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_24 = 268,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_25 = 269,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_26 = 270,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_27 = 271,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_28 = 272,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_29 = 273,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_30 = 274,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_31 = 275,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_32 = 276,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_33 = 277,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_34 = 278,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_35 = 279,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_36 = 280,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_37 = 281,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_38 = 282,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_39 = 283,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_40 = 284,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_41 = 285,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_42 = 286,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_43 = 287,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_44 = 288,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_45 = 289,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_46 = 290,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_47 = 291,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_48 = 292,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_49 = 293,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_50 = 294,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_51 = 295,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_52 = 296,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_53 = 297,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_54 = 298,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_55 = 299,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_56 = 300,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_57 = 301,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_58 = 302,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_59 = 303,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_60 = 304,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_61 = 305,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_62 = 306,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_63 = 307,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_64 = 308,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_65 = 309,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_66 = 310,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_67 = 311,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_68 = 312,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_69 = 313,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_70 = 314,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_71 = 315,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_72 = 316,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_73 = 317,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_74 = 318,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_75 = 319,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_76 = 320,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_77 = 321,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_78 = 322,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_79 = 323,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_80 = 324,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_81 = 325,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_82 = 326,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_83 = 327,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_84 = 328,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_85 = 329,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_86 = 330,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_87 = 331,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_88 = 332,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_89 = 333,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_90 = 334,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_91 = 335,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_92 = 336,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_93 = 337,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_94 = 338,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_95 = 339,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_96 = 340,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_97 = 341,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_98 = 342,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_99 = 343,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_100 = 344,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_101 = 345,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_102 = 346,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_103 = 347,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_104 = 348,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_105 = 349,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_106 = 350,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_107 = 351,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_108 = 352,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_109 = 353,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_110 = 354,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_111 = 355,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_112 = 356,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_113 = 357,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_114 = 358,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_115 = 359,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_116 = 360,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_117 = 361,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_118 = 362,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_119 = 363,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_120 = 364,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_121 = 365,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_122 = 366,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_123 = 367,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_124 = 368,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_125 = 369,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_126 = 370,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_127 = 371,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_128 = 372,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_129 = 373,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_130 = 374,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_131 = 375,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_132 = 376,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_133 = 377,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_134 = 378,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_135 = 379,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_136 = 380,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_137 = 381,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_138 = 382,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_139 = 383,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_140 = 384,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_141 = 385,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_142 = 386,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_143 = 387,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_144 = 388,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_145 = 389,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_146 = 390,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_147 = 391,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_148 = 392,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_149 = 393,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_150 = 394,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_151 = 395,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_152 = 396,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_153 = 397,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_154 = 398,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_155 = 399,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_156 = 400,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_157 = 401,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_158 = 402,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_159 = 403,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_160 = 404,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_161 = 405,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_162 = 406,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_163 = 407,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_164 = 408,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_165 = 409,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_166 = 410,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_167 = 411,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_168 = 412,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_169 = 413,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_170 = 414,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_171 = 415,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_172 = 416,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_173 = 417,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_174 = 418,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_175 = 419,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_176 = 420,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_177 = 421,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_178 = 422,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_179 = 423,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_180 = 424,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_181 = 425,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_182 = 426,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_183 = 427,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_184 = 428,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_185 = 429,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_186 = 430,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_187 = 431,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_188 = 432,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_189 = 433,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_190 = 434,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_191 = 435,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_192 = 436,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_193 = 437,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_194 = 438,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_195 = 439,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_196 = 440,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_197 = 441,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_1 = 442,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_2 = 443,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_3 = 444,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_4 = 445,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_5 = 446,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_6 = 447,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_7 = 448,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_8 = 449,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_9 = 450,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_10 = 451,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_11 = 452,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_12 = 453,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_13 = 454,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_14 = 455,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_15 = 456,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_16 = 457,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_17 = 458,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_18 = 459,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_19 = 460,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_20 = 461,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_21 = 462,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_22 = 463,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_23 = 464,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_24 = 465,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_25 = 466,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_26 = 467,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_27 = 468,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_28 = 469,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_29 = 470,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_30 = 471,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_31 = 472,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_32 = 473,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_33 = 474,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_34 = 475,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_35 = 476,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_36 = 477,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_37 = 478,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_38 = 479,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_39 = 480,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_40 = 481,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_41 = 482,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_42 = 483,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_43 = 484,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_44 = 485,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_45 = 486,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_46 = 487,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_47 = 488,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_48 = 489,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_49 = 490,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_50 = 491,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_51 = 492,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_52 = 493,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_53 = 494,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_54 = 495,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_55 = 496,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_56 = 497,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_57 = 498,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_58 = 499,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_59 = 500,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_60 = 501,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_61 = 502,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_62 = 503,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_63 = 504,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_64 = 505,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_65 = 506,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_66 = 507,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_67 = 508,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_68 = 509,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_69 = 510,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_70 = 511,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_71 = 512,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_72 = 513,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_73 = 514,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_74 = 515,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_75 = 516,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_76 = 517,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_77 = 518,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_78 = 519,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_79 = 520,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_80 = 521,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_81 = 522,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_82 = 523,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_83 = 524,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_84 = 525,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_85 = 526,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_86 = 527,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_87 = 528,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_88 = 529,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_89 = 530,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_90 = 531,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_91 = 532,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_92 = 533,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_93 = 534,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_94 = 535,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_95 = 536,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_96 = 537,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_97 = 538,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_98 = 539,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_99 = 540,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_100 = 541,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_101 = 542,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_102 = 543,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_103 = 544,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_104 = 545,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_105 = 546,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_106 = 547,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_107 = 548,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_108 = 549,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_109 = 550,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_110 = 551,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_111 = 552,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_112 = 553,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_113 = 554,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_114 = 555,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_115 = 556,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_116 = 557,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_117 = 558,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_118 = 559,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_119 = 560,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_120 = 561,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_121 = 562,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_122 = 563,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_123 = 564,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_124 = 565,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_125 = 566,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_126 = 567,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_127 = 568,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_128 = 569,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_129 = 570,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_130 = 571,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_131 = 572,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_132 = 573,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_133 = 574,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_134 = 575,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_135 = 576,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_136 = 577,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_137 = 578,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_138 = 579,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_139 = 580,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_140 = 581,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_141 = 582,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_142 = 583,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_143 = 584,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_144 = 585,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_145 = 586,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_146 = 587,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_147 = 588,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_148 = 589,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_149 = 590,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_150 = 591,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_151 = 592,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_152 = 593,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_153 = 594,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_154 = 595,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_155 = 596,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_156 = 597,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_157 = 598,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_158 = 599,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_159 = 600,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_160 = 601,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_161 = 602,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_162 = 603,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_163 = 604,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_164 = 605,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_165 = 606,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_166 = 607,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_167 = 608,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_168 = 609,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_169 = 610,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_170 = 611,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_171 = 612,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_172 = 613,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_173 = 614,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_174 = 615,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_175 = 616,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_176 = 617,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_177 = 618,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_178 = 619,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_179 = 620,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_180 = 621,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_181 = 622,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_182 = 623,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_183 = 624,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_184 = 625,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_185 = 626,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_186 = 627,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_187 = 628,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_188 = 629,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_189 = 630,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_190 = 631,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_191 = 632,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_192 = 633,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_193 = 634,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_194 = 635,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_195 = 636,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_196 = 637,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_197 = 638,
  /** state [m/s]: Velocity of the damper's piston behind its series stiffness; that of the strut without a series stiffness.
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_PISTON_VELOCITY = 639,
  /** state [Boolean]: Has the run begun? (default false) */
  STRIBECK_SHOCK_ABSORBER_STARTED = 640,
  /** state [s]: Last communication step; 0 before the first. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_STEP_SIZE = 641,
  /** state, out [K]: Temperature of the damper. (> 0, default 293.15) */
  STRIBECK_SHOCK_ABSORBER_TEMPERATURE = 642,
  /** state, out [J]: Energy taken out of the motion by friction and damper since the start. (default 0) */
  STRIBECK_SHOCK_ABSORBER_DISSIPATED_ENERGY = 643,
  /** out [N]: Force of the strut; positive pushes the eyes apart. */
  STRIBECK_SHOCK_ABSORBER_FORCE = 644,
  /** out [N]: The same with the opposite sign: positive pulls the eyes together. */
  STRIBECK_SHOCK_ABSORBER_FORCE_TENSION = 645,
  /** out [N]: Part of the spring. */
  STRIBECK_SHOCK_ABSORBER_FORCE_SPRING = 646,
  /** out [N]: Part of the gas. */
  STRIBECK_SHOCK_ABSORBER_FORCE_GAS = 647,
  /** out [N]: Part of the bump stop. */
  STRIBECK_SHOCK_ABSORBER_FORCE_BUMP = 648,
  /** out [N]: Part of the rebound stop. */
  STRIBECK_SHOCK_ABSORBER_FORCE_REBOUND = 649,
  /** out [N]: Part of the damper. */
  STRIBECK_SHOCK_ABSORBER_FORCE_DAMPER = 650,
  /** out [N]: Part of the friction. */
  STRIBECK_SHOCK_ABSORBER_FORCE_FRICTION = 651,
  /** out [N]: Force on the travel of the host, by virtual work: see adapter. */
  STRIBECK_SHOCK_ABSORBER_FORCE_TRAVEL = 652,
  /** out [N]: Axial friction at the rod guide; has the sign of the velocity when sliding. */
  STRIBECK_SHOCK_ABSORBER_FRICTION_1 = 653,
  /** out [N]: Axial friction at the piston; has the sign of the velocity when sliding. */
  STRIBECK_SHOCK_ABSORBER_FRICTION_2 = 654,
  /** out [N]: Normal force at the rod guide. */
  STRIBECK_SHOCK_ABSORBER_NORMAL_1 = 655,
  /** out [N]: Normal force at the piston. */
  STRIBECK_SHOCK_ABSORBER_NORMAL_2 = 656,
  /** out [N.m]: Friction torque about the axis, on the tube; has the sign of the spin rate when sliding. */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TORQUE = 657,
  /** out [m]: Compression from full extension. */
  STRIBECK_SHOCK_ABSORBER_COMPRESSION = 658,
  /** out [m]: Distance from piston to rod guide. */
  STRIBECK_SHOCK_ABSORBER_OVERLAP = 659,
  /** out [N/m]: Derivative of the force with respect to the length of the strut. */
  STRIBECK_SHOCK_ABSORBER_DFORCE_DLENGTH = 660,
  /** out [N.s/m]: Derivative of the force after a step with respect to the velocity of the strut. */
  STRIBECK_SHOCK_ABSORBER_DFORCE_DVELOCITY = 661,
  /** out [s]: Largest communication step that is stable for num.mass_ref; advice to the master. */
  STRIBECK_SHOCK_ABSORBER_STEP_LIMIT = 662,
  /** out [W]: Power taken out of the motion by friction and damper. */
  STRIBECK_SHOCK_ABSORBER_DISSIPATED_POWER = 663,
  /** out [Boolean]: Do the contacts stick? */
  STRIBECK_SHOCK_ABSORBER_STICKING = 664,
  /** out [Boolean]: Is the bump stop touched? */
  STRIBECK_SHOCK_ABSORBER_BUMP_ACTIVE = 665,
  /** out [Boolean]: Is the overlap so short that the contact forces are regularised? */
  STRIBECK_SHOCK_ABSORBER_OVERLAP_LOW = 666,
} stribeck_shock_absorber_variable;

/** Guid of TelescopicJoint for fmi2Instantiate. */
#define STRIBECK_TELESCOPIC_JOINT_GUID "{2f8d9de5-6e9b-7810-ca8e-d72e365f8a12}"

/** TelescopicJoint: Contact forces of a telescopic joint, from its side load. Columns of "TelescopicJoint". */
typedef enum stribeck_telescopic_joint_variable {
  /** in [m]: Distance of the eyes. (default 0.1775) */
  STRIBECK_TELESCOPIC_JOINT_LENGTH = 0,
  /** in [N]: Transverse force of the tube on the rod along m, at the eye of the tube; or lambda_1. (default 0) */
  STRIBECK_TELESCOPIC_JOINT_SIDE_FORCE_M = 1,
  /** in [N]: Transverse force of the tube on the rod along n, at the eye of the tube; or lambda_2. (default 0) */
  STRIBECK_TELESCOPIC_JOINT_SIDE_FORCE_N = 2,
  /** in [N.m]: Moment of the tube on the rod about m, at the eye of the tube; or lambda_3. (default 0) */
  STRIBECK_TELESCOPIC_JOINT_SIDE_MOMENT_M = 3,
  /** in [N.m]: Moment of the tube on the rod about n, at the eye of the tube; or lambda_4. (default 0) */
  STRIBECK_TELESCOPIC_JOINT_SIDE_MOMENT_N = 4,
  /** fixed [stribeck_side_convention]: Meaning of the four side loads. (default WrenchOnRod) */
  STRIBECK_TELESCOPIC_JOINT_CONVENTION = 5,
  /** fixed [stribeck_normal_sum]: Rule for summing the contact forces. (default TwoPoint) */
  STRIBECK_TELESCOPIC_JOINT_NORMAL_SUM = 6,
  /** fixed [m]: Distance from the eye of the tube to the rod guide (default chosen). (> 0, default 0.125) */
  STRIBECK_TELESCOPIC_JOINT_GEOM_D_I = 7,
  /** fixed [m]: Distance from the eye of the rod to the piston (default chosen). (> 0, default 0.105) */
  STRIBECK_TELESCOPIC_JOINT_GEOM_D_J = 8,
  /** fixed [m]: Overlap below which the contact forces are kept finite (default chosen). (>= 0, default 0.002) */
  STRIBECK_TELESCOPIC_JOINT_GEOM_H_REG = 9,
  /** out [N]: Normal force at the rod guide. */
  STRIBECK_TELESCOPIC_JOINT_NORMAL_1 = 10,
  /** out [N]: Normal force at the piston. */
  STRIBECK_TELESCOPIC_JOINT_NORMAL_2 = 11,
  /** out [N]: Force on the rod at the rod guide along m. */
  STRIBECK_TELESCOPIC_JOINT_FORCE_1_M = 12,
  /** out [N]: Force on the rod at the rod guide along n. */
  STRIBECK_TELESCOPIC_JOINT_FORCE_1_N = 13,
  /** out [N]: Force on the rod at the piston along m. */
  STRIBECK_TELESCOPIC_JOINT_FORCE_2_M = 14,
  /** out [N]: Force on the rod at the piston along n. */
  STRIBECK_TELESCOPIC_JOINT_FORCE_2_N = 15,
  /** out [m]: Distance from piston to rod guide. */
  STRIBECK_TELESCOPIC_JOINT_OVERLAP = 16,
  /** out [Boolean]: Is the overlap so short that the contact forces are regularised? */
  STRIBECK_TELESCOPIC_JOINT_OVERLAP_LOW = 17,
} stribeck_telescopic_joint_variable;

/** Guid of GuideContact for fmi2Instantiate. */
#define STRIBECK_GUIDE_CONTACT_GUID "{db48fccd-436f-c2ea-f8c2-6da3aa63e4a3}"

/** GuideContact: Friction of a rod in its guide, by any law of the catalogue. Columns of "GuideContact". */
typedef enum stribeck_guide_contact_variable {
  /** in [m/s]: Axial velocity of the rod relative to the guide. (default 0) */
  STRIBECK_GUIDE_CONTACT_VELOCITY = 0,
  /** in [rad/s]: Spin of the rod relative to the guide. (default 0) */
  STRIBECK_GUIDE_CONTACT_SPIN_RATE = 1,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_NORMAL_FORCE = 2,
  /** in [N]: All other axial forces on the rod; only for laws that hold a load at rest. (default 0) */
  STRIBECK_GUIDE_CONTACT_EXTERNAL_FORCE = 3,
  /** in [m/s2]: Time derivative of the velocity; only for laws that use it. (default 0) */
  STRIBECK_GUIDE_CONTACT_ACCELERATION = 4,
  /** tunable [m]: Radius of the contact. (>= 0, default 0.007) */
  STRIBECK_GUIDE_CONTACT_RADIUS = 5,
  /** tunable [1]: Static coefficient of friction; not less than mu_k (default chosen). (>= 0, default 0.15) */
  STRIBECK_GUIDE_CONTACT_LEVELS_MU_S = 6,
  /** tunable [1]: Kinetic coefficient of friction (default chosen). (>= 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_LEVELS_MU_K = 7,
  /** tunable [N]: Breakaway force without normal force, e.g. of a seal; not less than preload_k (default chosen).
   *  (>= 0, default 10) */
  STRIBECK_GUIDE_CONTACT_LEVELS_PRELOAD_S = 8,
  /** tunable [N]: Sliding friction force without normal force, e.g. of a seal (default chosen). (>= 0, default 8) */
  STRIBECK_GUIDE_CONTACT_LEVELS_PRELOAD_K = 9,
  /** fixed [stribeck_friction_model]: Friction law; parameters of other laws are ignored. (default LuGre) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MODEL = 10,
  /** tunable [stribeck_friction_switch]: Active parts of the friction. (default On) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SWITCH = 11,
  /** tunable [1]: Friction in compression over friction in extension: (1 + asymmetry) / (1 - asymmetry).
   *  (>= -0.99, <= 0.99, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ASYMMETRY = 12,
  /** tunable [1]: Factor on all friction levels. (>= 0, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SCALE = 13,
  /** tunable [kg]: Effective mass of the body, for laws that use it; 0 = law as printed. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MASS = 14,
  /** fixed [stribeck_exchange]: Order in which the master exchanges force and motion; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_GUIDE_CONTACT_FRICTION_EXCHANGE = 15,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_STRIBECK_VELOCITY = 16,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_STRIBECK_EXPONENT = 17,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SIGMA_0 = 18,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SIGMA_1 = 19,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_VISCOUS_COEFFICIENT = 20,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DAMPING_VELOCITY = 21,
  /** fixed [stribeck_coulomb_viscous_variant]: Variant of the law. (default Linear) */
  STRIBECK_GUIDE_CONTACT_FRICTION_COULOMBVISCOUS_VARIANT = 22,
  /** tunable [1]: Exponent of the viscous part. (> 0, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_VISCOUS_EXPONENT = 23,
  /** fixed [stribeck_stribeck_curve]: How the level falls with speed. (default Gaussian) */
  STRIBECK_GUIDE_CONTACT_FRICTION_CURVE = 24,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_STRIBECK_VISCOUS_COEFFICIENT = 25,
  /** tunable [N.s2/m2]: Quadratic friction coefficient; used by PoppStelter. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_QUADRATIC_COEFFICIENT = 26,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 2000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_TRANSITION_SLOPE = 27,
  /** fixed [stribeck_threlfall_variant]: Variant of the law. (default Printed) */
  STRIBECK_GUIDE_CONTACT_FRICTION_THRELFALL_VARIANT = 28,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_TRANSITION_VELOCITY = 29,
  /** fixed [stribeck_rooney_deravi_variant]: Variant of the law. (default Linear) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ROONEYDERAVI_VARIANT = 30,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (>= 0, default 0.0001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_AMBROSIO_TRANSITION_VELOCITY = 31,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SLIDING_VELOCITY = 32,
  /** fixed [stribeck_bengisu_akay_variant]: Variant of the law. (default Thesis) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BENGISUAKAY_VARIANT = 33,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 5000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BENGISUAKAY_TRANSITION_SLOPE = 34,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 500) */
  STRIBECK_GUIDE_CONTACT_FRICTION_STICTION_DECAY = 35,
  /** tunable [s/m]: Viscous coefficient of friction, per normal force. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MU_V = 36,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 10000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ANDERSSON_TRANSITION_SLOPE = 37,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ANDERSSON_VISCOUS_COEFFICIENT = 38,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_AWREJCEWICZ_STICTION_DECAY = 39,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SPECKER_TRANSITION_VELOCITY = 40,
  /** tunable [m/s]: Velocity at which the static level is reached (default chosen). (> 0, default 0.0005) */
  STRIBECK_GUIDE_CONTACT_FRICTION_PEAK_VELOCITY = 41,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SPECKER_VISCOUS_COEFFICIENT = 42,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.0015) */
  STRIBECK_GUIDE_CONTACT_FRICTION_LINEARSTICTION_SLIDING_VELOCITY = 43,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BROWNMCPHEE_VISCOUS_COEFFICIENT = 44,
  /** tunable [N]: Normal force at which the viscous part is fully active (default chosen). (> 0, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_TRANSITION_NORMAL_FORCE = 45,
  /** tunable [1]: Exponent of the transition to sliding; below 1 brittle, from 1 on ductile. (>= 0, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ALPHA = 46,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_FRICTIONALLAG_VISCOUS_COEFFICIENT = 47,
  /** fixed [s]: Time by which the level of friction lags behind the velocity (default chosen). (>= 0, default 0.005) */
  STRIBECK_GUIDE_CONTACT_FRICTION_TIME_LAG = 48,
  /** fixed [stribeck_frictional_lag_variant]: Variant of the law. (default Delay) */
  STRIBECK_GUIDE_CONTACT_FRICTION_FRICTIONALLAG_VARIANT = 49,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ARMSTRONG_VISCOUS_COEFFICIENT = 50,
  /** tunable [s]: Dwell time after which half of the rise of the static friction has occurred (default chosen).
   *  (>= 0, default 2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_GAMMA = 51,
  /** tunable [1]: Coefficient of friction that a contact reaches when it comes to rest; not more than mu_s (default chosen).
   *  (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MU_STOP = 52,
  /** tunable [s/m]: Steepness of the curve while speeding up (default chosen). (> 0, default 500) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ACCELERATION_DECAY = 53,
  /** tunable [s/m]: Steepness of the curve while slowing down (default chosen). (> 0, default 500) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DECELERATION_DECAY = 54,
  /** tunable [s/m]: Steepness of the curves for speeding up and slowing down (default chosen). (> 0, default 500) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BRANCH_DECAY = 55,
  /** fixed [stribeck_bliman_sorine_order]: Variant of the law. (default Second) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BLIMANSORINE_VARIANT = 56,
  /** tunable [1]: Level of the slow relaxation, as a coefficient of friction; second order (default calibrated).
   *  (>= 0, default 0.2732050807568877) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MU_2 = 57,
  /** tunable [1]: Length of the fast relaxation as a part of that of the slow one; second order (default chosen).
   *  (> 0, <= 1, default 0.5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ETA = 58,
  /** tunable [m]: Sliding distance in which the slow relaxation settles to 1/e (default calibrated).
   *  (> 0, default 4.642141842225068e-5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_EPS_F = 59,
  /** tunable [m]: Shear deflection of the asperities in steady sliding (default f_C / sigma_0 of the thesis).
   *  (> 0, default 9.81e-6) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DELTA_T = 60,
  /** tunable [1]: Part of the deflection of steady sliding up to which the contact is purely elastic.
   *  (> 0, <= 1, default 0.7) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BREAKAWAY_RATIO = 61,
  /** tunable [Integer]: Exponent of the transition from elastic deflection to sliding; odd. (>= 1, <= 9, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_PLASTIC_EXPONENT = 62,
  /** tunable [m]: Strain at which a bristle snaps (default f_s / sigma_0 of the thesis). (> 0, default 1.4715e-5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DELTA = 63,
  /** fixed [Integer]: Number of bristles (default chosen). (>= 1, <= 64, default 25) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BRISTLE_COUNT = 64,
  /** fixed [Integer]: Seed of the random numbers. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SEED = 65,
  /** fixed [stribeck_initial_bonds]: State of the bristles when the motion starts. (default Bonded) */
  STRIBECK_GUIDE_CONTACT_FRICTION_INITIAL_BONDS = 66,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SPECKERDYNAMIC_TRANSITION_VELOCITY = 67,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SPECKERDYNAMIC_VISCOUS_COEFFICIENT = 68,
  /** tunable [s]: Time constant of the force while sliding (default chosen). (> 0, default 0.001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SLIP_TIME = 69,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MAXWELLSLIP_SIGMA_1 = 70,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MAXWELLSLIP_VISCOUS_COEFFICIENT = 71,
  /** tunable [N/s]: Rate at which the slipping elements together approach their level (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ATTRACTION = 72,
  /** fixed [stribeck_element_distribution]: Where the shares of the elements come from. (default Explicit) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DISTRIBUTION = 73,
  /** fixed [Integer]: Number of elements in use (default chosen). (>= 1, <= 16, default 4) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_COUNT = 74,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_1_STIFFNESS_SHARE = 75,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_1_STRENGTH_SHARE = 76,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.25) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_2_STIFFNESS_SHARE = 77,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_2_STRENGTH_SHARE = 78,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.15) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_3_STIFFNESS_SHARE = 79,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.3) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_3_STRENGTH_SHARE = 80,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_4_STIFFNESS_SHARE = 81,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.4) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_4_STRENGTH_SHARE = 82,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_5_STIFFNESS_SHARE = 83,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_5_STRENGTH_SHARE = 84,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_6_STIFFNESS_SHARE = 85,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_6_STRENGTH_SHARE = 86,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_7_STIFFNESS_SHARE = 87,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_7_STRENGTH_SHARE = 88,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_8_STIFFNESS_SHARE = 89,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_8_STRENGTH_SHARE = 90,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_9_STIFFNESS_SHARE = 91,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_9_STRENGTH_SHARE = 92,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_10_STIFFNESS_SHARE = 93,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_10_STRENGTH_SHARE = 94,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_11_STIFFNESS_SHARE = 95,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_11_STRENGTH_SHARE = 96,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_12_STIFFNESS_SHARE = 97,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_12_STRENGTH_SHARE = 98,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_13_STIFFNESS_SHARE = 99,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_13_STRENGTH_SHARE = 100,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_14_STIFFNESS_SHARE = 101,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_14_STRENGTH_SHARE = 102,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_15_STIFFNESS_SHARE = 103,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_15_STRENGTH_SHARE = 104,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_16_STIFFNESS_SHARE = 105,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_16_STRENGTH_SHARE = 106,
  /** tunable [1]: Exponent of the approach to the steady level (default chosen). (>= 0.1, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_APPROACH_EXPONENT = 107,
  /** tunable [1]: Strength of all elements together, as a multiple of the static level; not less than 1 (default chosen).
   *  (> 0, default 1.2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_HYSTERESIS_STRENGTH = 108,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 1e-5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_GONTHIER_TRANSITION_VELOCITY = 109,
  /** tunable [s]: Time constant with which the static level rises at rest. (> 0, default 2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DWELL_TIME_CONSTANT = 110,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_1 = 111,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_2 = 112,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_3 = 113,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_4 = 114,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_5 = 115,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_6 = 116,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_7 = 117,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_8 = 118,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_9 = 119,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_10 = 120,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_11 = 121,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_12 = 122,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_13 = 123,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_14 = 124,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_15 = 125,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_16 = 126,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_17 = 127,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_18 = 128,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_19 = 129,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_20 = 130,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_21 = 131,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_22 = 132,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_23 = 133,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_24 = 134,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_25 = 135,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_26 = 136,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_27 = 137,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_28 = 138,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_29 = 139,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_30 = 140,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_31 = 141,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_32 = 142,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_33 = 143,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_34 = 144,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_35 = 145,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_36 = 146,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_37 = 147,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_38 = 148,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_39 = 149,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_40 = 150,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_41 = 151,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_42 = 152,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_43 = 153,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_44 = 154,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_45 = 155,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_46 = 156,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_47 = 157,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_48 = 158,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_49 = 159,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_50 = 160,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_51 = 161,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_52 = 162,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_53 = 163,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_54 = 164,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_55 = 165,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_56 = 166,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_57 = 167,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_58 = 168,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_59 = 169,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_60 = 170,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_61 = 171,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_62 = 172,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_63 = 173,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_64 = 174,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_65 = 175,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_66 = 176,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_67 = 177,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_68 = 178,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_69 = 179,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_70 = 180,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_71 = 181,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_72 = 182,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_73 = 183,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_74 = 184,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_75 = 185,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_76 = 186,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_77 = 187,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_78 = 188,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_79 = 189,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_80 = 190,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_81 = 191,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_82 = 192,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_83 = 193,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_84 = 194,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_85 = 195,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_86 = 196,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_87 = 197,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_88 = 198,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_89 = 199,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_90 = 200,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_91 = 201,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_92 = 202,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_93 = 203,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_94 = 204,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_95 = 205,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_96 = 206,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_97 = 207,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_98 = 208,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_99 = 209,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_100 = 210,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_101 = 211,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_102 = 212,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_103 = 213,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_104 = 214,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_105 = 215,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_106 = 216,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_107 = 217,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_108 = 218,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_109 = 219,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_110 = 220,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_111 = 221,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_112 = 222,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_113 = 223,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_114 = 224,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_115 = 225,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_116 = 226,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_117 = 227,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_118 = 228,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_119 = 229,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_120 = 230,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_121 = 231,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_122 = 232,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_123 = 233,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_124 = 234,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_125 = 235,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_126 = 236,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_127 = 237,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_128 = 238,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_129 = 239,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_130 = 240,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_131 = 241,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_132 = 242,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_133 = 243,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_134 = 244,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_135 = 245,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_136 = 246,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_137 = 247,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_138 = 248,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_139 = 249,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_140 = 250,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_141 = 251,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_142 = 252,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_143 = 253,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_144 = 254,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_145 = 255,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_146 = 256,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_147 = 257,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_148 = 258,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_149 = 259,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_150 = 260,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_151 = 261,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_152 = 262,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_153 = 263,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_154 = 264,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_155 = 265,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_156 = 266,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_157 = 267,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_158 = 268,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_159 = 269,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_160 = 270,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_161 = 271,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_162 = 272,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_163 = 273,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_164 = 274,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_165 = 275,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_166 = 276,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_167 = 277,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_168 = 278,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_169 = 279,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_170 = 280,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_171 = 281,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_172 = 282,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_173 = 283,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_174 = 284,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_175 = 285,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_176 = 286,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_177 = 287,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_178 = 288,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_179 = 289,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_180 = 290,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_181 = 291,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_182 = 292,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_183 = 293,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_184 = 294,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_185 = 295,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_186 = 296,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_187 = 297,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_188 = 298,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_189 = 299,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_190 = 300,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_191 = 301,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_192 = 302,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_193 = 303,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_194 = 304,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_195 = 305,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_196 = 306,
  /** state [1]: States of the friction law, in SI units and in the order of the law, discrete ones last. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_197 = 307,
  /** state [Boolean]: Has the run begun? (default false) */
  STRIBECK_GUIDE_CONTACT_STARTED = 308,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_GUIDE_CONTACT_DISSIPATED_ENERGY = 309,
  /** out [N]: Axial friction force; has the sign of the velocity when sliding. */
  STRIBECK_GUIDE_CONTACT_FRICTION_FORCE = 310,
  /** out [N.m]: Friction torque about the axis; has the sign of the spin rate when sliding. */
  STRIBECK_GUIDE_CONTACT_FRICTION_TORQUE = 311,
  /** out [W]: Power taken out of the motion. */
  STRIBECK_GUIDE_CONTACT_DISSIPATED_POWER = 312,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_GUIDE_CONTACT_STICKING = 313,
} stribeck_guide_contact_variable;

/** Guid of CoilSpring for fmi2Instantiate. */
#define STRIBECK_COIL_SPRING_GUID "{1940e84a-ac92-39f7-c0de-a671c35f8e0b}"

/** CoilSpring: Coil spring with preload, linear or from a table. Columns of "CoilSpring". */
typedef enum stribeck_coil_spring_variable {
  /** in [m]: Compression from full extension. (default 0) */
  STRIBECK_COIL_SPRING_COMPRESSION = 0,
  /** fixed [Boolean]: Is there a spring? (default true) */
  STRIBECK_COIL_SPRING_SPRING_ENABLED = 1,
  /** fixed [stribeck_spring_mode]: Form of the spring's characteristic. (default Linear) */
  STRIBECK_COIL_SPRING_SPRING_MODE = 2,
  /** tunable [N/m]: Stiffness. (>= 0, default 45000) */
  STRIBECK_COIL_SPRING_SPRING_K = 3,
  /** tunable [N]: Force at full extension (default chosen). (default 150) */
  STRIBECK_COIL_SPRING_SPRING_PRELOAD = 4,
  /** fixed [Integer]: Number of points of the table in use (default chosen). (>= 2, <= 16, default 3) */
  STRIBECK_COIL_SPRING_SPRING_TAB_N = 5,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_1 = 6,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0.03) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_2 = 7,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0.055) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_3 = 8,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_4 = 9,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_5 = 10,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_6 = 11,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_7 = 12,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_8 = 13,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_9 = 14,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_10 = 15,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_11 = 16,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_12 = 17,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_13 = 18,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_14 = 19,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_15 = 20,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_16 = 21,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_1 = 22,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 1350) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_2 = 23,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 2850) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_3 = 24,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_4 = 25,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_5 = 26,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_6 = 27,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_7 = 28,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_8 = 29,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_9 = 30,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_10 = 31,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_11 = 32,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_12 = 33,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_13 = 34,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_14 = 35,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_15 = 36,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_16 = 37,
  /** out [N]: Force of the spring; positive pushes its ends apart. */
  STRIBECK_COIL_SPRING_FORCE = 38,
} stribeck_coil_spring_variable;

/** Guid of GasSpring for fmi2Instantiate. */
#define STRIBECK_GAS_SPRING_GUID "{600bb709-07c3-9d50-5c31-a25dd319a7a2}"

/** GasSpring: Gas force on the rod of a shock absorber. Columns of "GasSpring". */
typedef enum stribeck_gas_spring_variable {
  /** in [m]: Compression from full extension. (default 0) */
  STRIBECK_GAS_SPRING_COMPRESSION = 0,
  /** fixed [Boolean]: Is there a gas force? (default true) */
  STRIBECK_GAS_SPRING_GAS_ENABLED = 1,
  /** tunable [Pa]: Absolute gas pressure at full extension (default chosen). (>= 0, default 1000000) */
  STRIBECK_GAS_SPRING_GAS_P0 = 2,
  /** fixed [m3]: Gas volume at full extension (default chosen). (> 0, default 3e-5) */
  STRIBECK_GAS_SPRING_GAS_V0 = 3,
  /** fixed [1]: Polytropic exponent (default chosen). (>= 0, default 1.2) */
  STRIBECK_GAS_SPRING_GAS_N = 4,
  /** fixed [m]: Diameter of the rod (default chosen). (>= 0, default 0.014) */
  STRIBECK_GAS_SPRING_GAS_ROD_DIAMETER = 5,
  /** tunable [Pa]: Ambient pressure. (>= 0, default 101325) */
  STRIBECK_GAS_SPRING_GAS_P_AMBIENT = 6,
  /** out [N]: Gas force on the rod; positive pushes it out. */
  STRIBECK_GAS_SPRING_FORCE = 7,
} stribeck_gas_spring_variable;

/** Guid of EndStops for fmi2Instantiate. */
#define STRIBECK_END_STOPS_GUID "{6107fa94-fb45-4292-a2f5-7dd0553054a9}"

/** EndStops: Bump stop and rebound stop of a shock absorber. Columns of "EndStops". */
typedef enum stribeck_end_stops_variable {
  /** in [m]: Compression from full extension. (default 0) */
  STRIBECK_END_STOPS_COMPRESSION = 0,
  /** in [m/s]: Velocity of extension. (default 0) */
  STRIBECK_END_STOPS_VELOCITY = 1,
  /** fixed [Boolean]: Is there a bump stop? (default true) */
  STRIBECK_END_STOPS_BUMP_ENABLED = 2,
  /** fixed [m]: Compression from full extension at which the bump stop is touched (default chosen). (default 0.04) */
  STRIBECK_END_STOPS_BUMP_GAP = 3,
  /** fixed [stribeck_bump_mode]: Form of the bump stop's characteristic. (default Linear) */
  STRIBECK_END_STOPS_BUMP_MODE = 4,
  /** tunable [N/m]: Stiffness: of the linear form, and first coefficient of the cubic one (default chosen).
   *  (>= 0, default 150000) */
  STRIBECK_END_STOPS_BUMP_K = 5,
  /** tunable [1]: Exponent of the power form (default chosen). (>= 1, default 2.2) */
  STRIBECK_END_STOPS_BUMP_N = 6,
  /** tunable [m]: Compression at which the power form has the force F_ref (default chosen). (> 0, default 0.01) */
  STRIBECK_END_STOPS_BUMP_X_REF = 7,
  /** tunable [N]: Force of the power form at x_ref (default chosen). (>= 0, default 1500) */
  STRIBECK_END_STOPS_BUMP_F_REF = 8,
  /** tunable [N/m2]: Second coefficient of the cubic form. (>= 0, default 0) */
  STRIBECK_END_STOPS_BUMP_K2 = 9,
  /** tunable [N/m3]: Third coefficient of the cubic form. (>= 0, default 0) */
  STRIBECK_END_STOPS_BUMP_K3 = 10,
  /** tunable [N.s/m]: Damping while the stop is touched. (>= 0, default 0) */
  STRIBECK_END_STOPS_BUMP_C = 11,
  /** fixed [Boolean]: Is there a rebound stop? (default true) */
  STRIBECK_END_STOPS_REBOUND_ENABLED = 12,
  /** fixed [m]: Compression from full extension at which the rebound stop is touched. (default 0) */
  STRIBECK_END_STOPS_REBOUND_GAP = 13,
  /** tunable [N/m]: Stiffness (default chosen). (>= 0, default 1000000) */
  STRIBECK_END_STOPS_REBOUND_K = 14,
  /** tunable [N.s/m]: Damping while the stop is touched. (>= 0, default 0) */
  STRIBECK_END_STOPS_REBOUND_C = 15,
  /** out [N]: Force of the bump stop; positive pushes the eyes apart. */
  STRIBECK_END_STOPS_FORCE_BUMP = 16,
  /** out [N]: Force of the rebound stop; negative pulls the eyes together. */
  STRIBECK_END_STOPS_FORCE_REBOUND = 17,
  /** out [Boolean]: Is the bump stop touched? */
  STRIBECK_END_STOPS_BUMP_ACTIVE = 18,
} stribeck_end_stops_variable;

/** Guid of HydraulicDamper for fmi2Instantiate. */
#define STRIBECK_HYDRAULIC_DAMPER_GUID "{6567281f-8e7a-ef7a-1a5f-070b449a16c4}"

/** HydraulicDamper: Hydraulic damper, linear, degressive or from a table. Columns of "HydraulicDamper". */
typedef enum stribeck_hydraulic_damper_variable {
  /** in [m/s]: Velocity of extension. (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_VELOCITY = 0,
  /** fixed [Boolean]: Is there a damper? (default true) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_ENABLED = 1,
  /** fixed [stribeck_damper_mode]: Form of the damper's characteristic. (default Linear) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MODE = 2,
  /** tunable [N.s/m]: Damping coefficient in compression (default chosen). (>= 0, default 1500) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_C_COMP = 3,
  /** tunable [N.s/m]: Damping coefficient in extension, the rebound (default chosen). (>= 0, default 2300) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_C_REB = 4,
  /** tunable [s/m]: Degression in compression. (>= 0, default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_DEGR_COMP = 5,
  /** tunable [s/m]: Degression in extension. (>= 0, default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_DEGR_REB = 6,
  /** fixed [Integer]: Number of points of the table in use (default chosen). (>= 2, <= 16, default 11) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_N = 7,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_1 = 8,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.5) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_2 = 9,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.25) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_3 = 10,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_4 = 11,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.05) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_5 = 12,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_6 = 13,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.05) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_7 = 14,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_8 = 15,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.25) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_9 = 16,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.5) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_10 = 17,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_11 = 18,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_12 = 19,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_13 = 20,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_14 = 21,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_15 = 22,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_16 = 23,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -1150) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_1 = 24,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -700) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_2 = 25,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -430) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_3 = 26,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -210) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_4 = 27,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -110) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_5 = 28,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_6 = 29,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 180) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_7 = 30,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 340) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_8 = 31,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 640) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_9 = 32,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 950) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_10 = 33,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 1500) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_11 = 34,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_12 = 35,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_13 = 36,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_14 = 37,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_15 = 38,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_16 = 39,
  /** fixed [stribeck_interpolation]: Curve through the points of the table. (default Linear) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_INTERPOLATION = 40,
  /** tunable [1]: Factor on the damper force. (>= 0, default 1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_SCALE = 41,
  /** fixed [N/m]: Stiffness in series with the damper, of oil and top mount; 0 = rigid. (>= 0, default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_K_SERIES = 42,
  /** fixed [s]: Largest internal step (default chosen). (> 0, default 0.0001) */
  STRIBECK_HYDRAULIC_DAMPER_STEP_SIZE = 43,
  /** state [m/s]: Velocity of the piston behind the series stiffness; the velocity itself if there is none.
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_PISTON_VELOCITY = 44,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DISSIPATED_ENERGY = 45,
  /** out [N]: Force of the damper; positive pushes its ends apart. */
  STRIBECK_HYDRAULIC_DAMPER_FORCE = 46,
  /** out [W]: Power taken out of the motion. */
  STRIBECK_HYDRAULIC_DAMPER_DISSIPATED_POWER = 47,
} stribeck_hydraulic_damper_variable;

/** Guid of DamperTemperature for fmi2Instantiate. */
#define STRIBECK_DAMPER_TEMPERATURE_GUID "{0f9cde77-96a0-c294-c83c-91ac86f9f893}"

/** DamperTemperature: Temperature of a damper and its effect on the force. Columns of "DamperTemperature". */
typedef enum stribeck_damper_temperature_variable {
  /** in [W]: Power dissipated in the damper. (default 0) */
  STRIBECK_DAMPER_TEMPERATURE_POWER = 0,
  /** in [K]: Ambient temperature. (>= 0, default 293.15) */
  STRIBECK_DAMPER_TEMPERATURE_TEMPERATURE_AMBIENT = 1,
  /** fixed [Boolean]: Does the temperature change and affect the damper force? (default false) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_ENABLED = 2,
  /** tunable [1/K]: Relative loss of damper force per kelvin (default chosen). (>= 0, default 0.003) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_BETA = 3,
  /** fixed [K]: Temperature at which the damper's characteristic was measured (default chosen).
   *  (> 0, default 293.15) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_TEMPERATURE_REF = 4,
  /** fixed [J/K]: Heat capacity of the damper (default chosen: 0.6 kg of aluminium and oil). (> 0, default 600) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_CAPACITY = 5,
  /** tunable [W/K]: Heat flow to the surroundings per kelvin (default chosen). (>= 0, default 1.5) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_CONDUCTANCE = 6,
  /** state, out [K]: Temperature of the damper. (> 0, default 293.15) */
  STRIBECK_DAMPER_TEMPERATURE_TEMPERATURE = 7,
  /** out [1]: Factor on the damper force. */
  STRIBECK_DAMPER_TEMPERATURE_FORCE_FACTOR = 8,
} stribeck_damper_temperature_variable;

/** Guid of BeltRig for fmi2Instantiate. */
#define STRIBECK_BELT_RIG_GUID "{8afd28c8-91fa-cade-2d68-b28fdb2690f2}"

/** BeltRig: Block on a moving belt, held by a spring. Columns of "BeltRig". */
typedef enum stribeck_belt_rig_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_BELT_RIG_FRICTION_FORCE = 0,
  /** fixed [kg]: Mass of the block. (> 0, default 1) */
  STRIBECK_BELT_RIG_MASS = 1,
  /** fixed [N/m]: Stiffness of the spring. (>= 0, default 2) */
  STRIBECK_BELT_RIG_STIFFNESS = 2,
  /** tunable [m/s]: Velocity of the belt. (default 0.1) */
  STRIBECK_BELT_RIG_BELT_VELOCITY = 3,
  /** state, out [m]: Position of the block; the spring is relaxed at 0. (default 0) */
  STRIBECK_BELT_RIG_POSITION = 4,
  /** state, out [m/s]: Velocity of the block. (default 0.1) */
  STRIBECK_BELT_RIG_BLOCK_VELOCITY = 5,
  /** out [m/s]: Velocity of the block relative to the belt. */
  STRIBECK_BELT_RIG_VELOCITY = 6,
  /** out [N]: Spring force on the block. */
  STRIBECK_BELT_RIG_EXTERNAL_FORCE = 7,
} stribeck_belt_rig_variable;

/** Guid of QuarterCar for fmi2Instantiate. */
#define STRIBECK_QUARTER_CAR_GUID "{23e3aa46-e0a4-32f5-d7aa-582b2d5849d3}"

/** QuarterCar: Quarter car: body, wheel and tyre, driven by the force of a strut. Columns of "QuarterCar". */
typedef enum stribeck_quarter_car_variable {
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_QUARTER_CAR_ROAD_HEIGHT = 0,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_QUARTER_CAR_ROAD_VELOCITY = 1,
  /** fixed [kg]: Mass of the body, without the wheels. (> 0, default 52.91) */
  STRIBECK_QUARTER_CAR_BODY_MASS = 2,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.011) */
  STRIBECK_QUARTER_CAR_MOTION_RATIO = 3,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_QUARTER_CAR_STATIC_LENGTH = 4,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1325.2555) */
  STRIBECK_QUARTER_CAR_STATIC_FORCE = 5,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_QUARTER_CAR_WHEEL_MASS = 6,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_QUARTER_CAR_TYRE_STIFFNESS = 7,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_QUARTER_CAR_TYRE_DAMPING = 8,
  /** state, out [m]: Height of the body above its height at rest. (default 0) */
  STRIBECK_QUARTER_CAR_BODY_HEIGHT = 9,
  /** state, out [m/s]: Vertical velocity of the body. (default 0) */
  STRIBECK_QUARTER_CAR_BODY_VELOCITY = 10,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_QUARTER_CAR_STRUT_FORCE = 11,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_QUARTER_CAR_WHEEL_HEIGHT = 12,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_QUARTER_CAR_WHEEL_VELOCITY = 13,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_QUARTER_CAR_LENGTH = 14,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_QUARTER_CAR_VELOCITY = 15,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_QUARTER_CAR_TYRE_LOAD = 16,
} stribeck_quarter_car_variable;

/** Guid of FourPostCar for fmi2Instantiate. */
#define STRIBECK_FOUR_POST_CAR_GUID "{abce49bb-587d-13bb-7750-5282709d5eef}"

/** FourPostCar: Car on four posts, driven by the forces of four struts. Columns of "FourPostCar". */
typedef enum stribeck_four_post_car_variable {
  /** fixed [kg]: Mass of the body, without the wheels. (> 0, default 223.2) */
  STRIBECK_FOUR_POST_CAR_BODY_MASS = 0,
  /** fixed [kg.m2]: Moment of inertia of the body about its lateral axis. (> 0, default 126.29) */
  STRIBECK_FOUR_POST_CAR_PITCH_INERTIA = 1,
  /** fixed [kg.m2]: Moment of inertia of the body about its longitudinal axis. (> 0, default 26.46) */
  STRIBECK_FOUR_POST_CAR_ROLL_INERTIA = 2,
  /** fixed [m]: Distance between the axles. (> 0, default 1.528) */
  STRIBECK_FOUR_POST_CAR_WHEELBASE = 3,
  /** fixed [m]: Distance of the front axle ahead of the body's centre of gravity. (>= 0, default 0.8035) */
  STRIBECK_FOUR_POST_CAR_CG_TO_FRONT = 4,
  /** state, out [m]: Height of the centre of gravity above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_HEAVE = 5,
  /** state, out [m/s]: Vertical velocity of the centre of gravity. (default 0) */
  STRIBECK_FOUR_POST_CAR_HEAVE_RATE = 6,
  /** state, out [rad]: Pitch angle; positive nose down. (default 0) */
  STRIBECK_FOUR_POST_CAR_PITCH = 7,
  /** state, out [rad/s]: Rate of the pitch angle. (default 0) */
  STRIBECK_FOUR_POST_CAR_PITCH_RATE = 8,
  /** state, out [rad]: Roll angle; positive lowers the right side. (default 0) */
  STRIBECK_FOUR_POST_CAR_ROLL = 9,
  /** state, out [rad/s]: Rate of the roll angle. (default 0) */
  STRIBECK_FOUR_POST_CAR_ROLL_RATE = 10,
  /** fixed [m]: Distance between the wheels of the axle. (> 0, default 1.22) */
  STRIBECK_FOUR_POST_CAR_FRONT_TRACK = 11,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.011) */
  STRIBECK_FOUR_POST_CAR_FRONT_MOTION_RATIO = 12,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_FOUR_POST_CAR_FRONT_STATIC_LENGTH = 13,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1325.2555) */
  STRIBECK_FOUR_POST_CAR_FRONT_STATIC_FORCE = 14,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_FOUR_POST_CAR_FRONT_WHEEL_MASS = 15,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_FOUR_POST_CAR_FRONT_TYRE_STIFFNESS = 16,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_FOUR_POST_CAR_FRONT_TYRE_DAMPING = 17,
  /** fixed [m]: Distance between the wheels of the axle. (> 0, default 1.2) */
  STRIBECK_FOUR_POST_CAR_REAR_TRACK = 18,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.004) */
  STRIBECK_FOUR_POST_CAR_REAR_MOTION_RATIO = 19,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_FOUR_POST_CAR_REAR_STATIC_LENGTH = 20,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1100.2555) */
  STRIBECK_FOUR_POST_CAR_REAR_STATIC_FORCE = 21,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_FOUR_POST_CAR_REAR_WHEEL_MASS = 22,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_FOUR_POST_CAR_REAR_TYRE_STIFFNESS = 23,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_FOUR_POST_CAR_REAR_TYRE_DAMPING = 24,
  /** in [m]: Height of the post under the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_FL_POST_HEIGHT = 25,
  /** in [m/s]: Rate of the post's height. (default 0) */
  STRIBECK_FOUR_POST_CAR_FL_POST_VELOCITY = 26,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_FOUR_POST_CAR_FL_STRUT_FORCE = 27,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_FL_WHEEL_HEIGHT = 28,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_FL_WHEEL_VELOCITY = 29,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_FOUR_POST_CAR_FL_LENGTH = 30,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_FOUR_POST_CAR_FL_VELOCITY = 31,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_FOUR_POST_CAR_FL_TYRE_LOAD = 32,
  /** in [m]: Height of the post under the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_FR_POST_HEIGHT = 33,
  /** in [m/s]: Rate of the post's height. (default 0) */
  STRIBECK_FOUR_POST_CAR_FR_POST_VELOCITY = 34,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_FOUR_POST_CAR_FR_STRUT_FORCE = 35,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_FR_WHEEL_HEIGHT = 36,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_FR_WHEEL_VELOCITY = 37,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_FOUR_POST_CAR_FR_LENGTH = 38,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_FOUR_POST_CAR_FR_VELOCITY = 39,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_FOUR_POST_CAR_FR_TYRE_LOAD = 40,
  /** in [m]: Height of the post under the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_RL_POST_HEIGHT = 41,
  /** in [m/s]: Rate of the post's height. (default 0) */
  STRIBECK_FOUR_POST_CAR_RL_POST_VELOCITY = 42,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1100.2555) */
  STRIBECK_FOUR_POST_CAR_RL_STRUT_FORCE = 43,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_RL_WHEEL_HEIGHT = 44,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_RL_WHEEL_VELOCITY = 45,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_FOUR_POST_CAR_RL_LENGTH = 46,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_FOUR_POST_CAR_RL_VELOCITY = 47,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_FOUR_POST_CAR_RL_TYRE_LOAD = 48,
  /** in [m]: Height of the post under the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_RR_POST_HEIGHT = 49,
  /** in [m/s]: Rate of the post's height. (default 0) */
  STRIBECK_FOUR_POST_CAR_RR_POST_VELOCITY = 50,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1100.2555) */
  STRIBECK_FOUR_POST_CAR_RR_STRUT_FORCE = 51,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_RR_WHEEL_HEIGHT = 52,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_RR_WHEEL_VELOCITY = 53,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_FOUR_POST_CAR_RR_LENGTH = 54,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_FOUR_POST_CAR_RR_VELOCITY = 55,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_FOUR_POST_CAR_RR_TYRE_LOAD = 56,
} stribeck_four_post_car_variable;

/** Guid of DoubleTrackCar for fmi2Instantiate. */
#define STRIBECK_DOUBLE_TRACK_CAR_GUID "{f2f80c84-2a09-d80f-5af4-53182eb5c19a}"

/** DoubleTrackCar: Double-track car steered at constant speed, with Magic Formula tyres. Columns of "DoubleTrackCar". */
typedef enum stribeck_double_track_car_variable {
  /** in [rad]: Steering angle of the front wheels; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_STEERING_ANGLE = 0,
  /** fixed [kg]: Mass of the body, without the wheels. (> 0, default 223.2) */
  STRIBECK_DOUBLE_TRACK_CAR_BODY_MASS = 1,
  /** fixed [kg.m2]: Moment of inertia of the body about its lateral axis. (> 0, default 126.29) */
  STRIBECK_DOUBLE_TRACK_CAR_PITCH_INERTIA = 2,
  /** fixed [kg.m2]: Moment of inertia of the body about its longitudinal axis. (> 0, default 26.46) */
  STRIBECK_DOUBLE_TRACK_CAR_ROLL_INERTIA = 3,
  /** fixed [m]: Distance between the axles. (> 0, default 1.528) */
  STRIBECK_DOUBLE_TRACK_CAR_WHEELBASE = 4,
  /** fixed [m]: Distance of the front axle ahead of the body's centre of gravity. (>= 0, default 0.8035) */
  STRIBECK_DOUBLE_TRACK_CAR_CG_TO_FRONT = 5,
  /** state, out [m]: Height of the centre of gravity above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_HEAVE = 6,
  /** state, out [m/s]: Vertical velocity of the centre of gravity. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_HEAVE_RATE = 7,
  /** state, out [rad]: Pitch angle; positive nose down. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_PITCH = 8,
  /** state, out [rad/s]: Rate of the pitch angle. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_PITCH_RATE = 9,
  /** state, out [rad]: Roll angle; positive lowers the right side. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_ROLL = 10,
  /** state, out [rad/s]: Rate of the roll angle. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_ROLL_RATE = 11,
  /** fixed [m/s]: Forward speed. (> 0, default 20) */
  STRIBECK_DOUBLE_TRACK_CAR_SPEED = 12,
  /** fixed [kg.m2]: Moment of inertia of the car about its vertical axis. (> 0, default 142.92) */
  STRIBECK_DOUBLE_TRACK_CAR_YAW_INERTIA = 13,
  /** fixed [m]: Height of the body's centre of gravity above the ground. (>= 0, default 0.3203) */
  STRIBECK_DOUBLE_TRACK_CAR_CG_HEIGHT = 14,
  /** fixed [m]: Height of the wheels' centres of gravity above the ground (default chosen). (>= 0, default 0.2) */
  STRIBECK_DOUBLE_TRACK_CAR_WHEEL_CENTRE_HEIGHT = 15,
  /** fixed [m]: Relaxation length: rolling distance after which the side slip has reached 63 % (default chosen).
   *  (> 0, default 0.2) */
  STRIBECK_DOUBLE_TRACK_CAR_RELAXATION_LENGTH = 16,
  /** fixed [N]: Nominal load F_z0 of the set. (> 0, default 3000) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_FNOMIN = 17,
  /** fixed [m]: Unloaded radius R_0 of the tyre (default chosen). (> 0, default 0.2) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_UNLOADED_RADIUS = 18,
  /** fixed [m/s]: Reference speed V_0 of the rolling resistance (default chosen). (> 0, default 16.7) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LONGVL = 19,
  /** fixed [1]: Scale factor of the nominal load; 700 N here, for Formula Student.
   *  (> 0, default 0.23333333333333334) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LFZO = 20,
  /** fixed [1]: Scale factor of the shape of F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LCX = 21,
  /** fixed [1]: Scale factor of the longitudinal friction; 0.97 in the source. (> 0, default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMUX = 22,
  /** fixed [1]: Scale factor of the curvature of F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LEX = 23,
  /** fixed [1]: Scale factor of the slip stiffness. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LKX = 24,
  /** fixed [1]: Scale factor of the horizontal shift of F_x; 1 in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LHX = 25,
  /** fixed [1]: Scale factor of the vertical shift of F_x; 1 in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LVX = 26,
  /** fixed [1]: Scale factor of the camber in F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LGAX = 27,
  /** fixed [1]: Scale factor of the shape of F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LCY = 28,
  /** fixed [1]: Scale factor of the lateral friction; 0.97 in the source. (> 0, default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMUY = 29,
  /** fixed [1]: Scale factor of the curvature of F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LEY = 30,
  /** fixed [1]: Scale factor of the cornering stiffness. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LKY = 31,
  /** fixed [1]: Scale factor of the horizontal shift of F_y; 1 in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LHY = 32,
  /** fixed [1]: Scale factor of the vertical shift of F_y; 1 in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LVY = 33,
  /** fixed [1]: Scale factor of the camber in F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LGAY = 34,
  /** fixed [1]: Scale factor of the pneumatic trail. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LTR = 35,
  /** fixed [1]: Scale factor of the residual torque. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LRES = 36,
  /** fixed [1]: Scale factor of the camber in M_z. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LGAZ = 37,
  /** fixed [1]: Scale factor of the influence of the side slip on F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LXAL = 38,
  /** fixed [1]: Scale factor of the influence of the longitudinal slip on F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LYKA = 39,
  /** fixed [1]: Scale factor of the side force that longitudinal slip induces. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LVYKA = 40,
  /** fixed [1]: Scale factor of the moment arm of F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LS = 41,
  /** fixed [1]: Scale factor of the overturning couple. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMX = 42,
  /** fixed [1]: Scale factor of the vertical shift of the overturning couple. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LVMX = 43,
  /** fixed [1]: Scale factor of the rolling resistance. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMY = 44,
  /** fixed [1]: Shape factor of F_x. (default 1.6) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PCX1 = 45,
  /** fixed [1]: Longitudinal friction at the nominal load. (default 1.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDX1 = 46,
  /** fixed [1]: Change of the longitudinal friction with load. (default -0.04) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDX2 = 47,
  /** fixed [1]: Change of the longitudinal friction with the square of camber. (default 0.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDX3 = 48,
  /** fixed [1]: Curvature of F_x at the nominal load. (default 0.7) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEX1 = 49,
  /** fixed [1]: Change of the curvature of F_x with load. (default -0.17) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEX2 = 50,
  /** fixed [1]: Change of the curvature of F_x with the square of load. (default 0.023) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEX3 = 51,
  /** fixed [1]: Change of the curvature of F_x with the sign of slip. (default -0.14) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEX4 = 52,
  /** fixed [1]: Slip stiffness per load at the nominal load. (default 30.7) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKX1 = 53,
  /** fixed [1]: Change of the slip stiffness with load. (default 0.27) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKX2 = 54,
  /** fixed [1]: Exponent of the slip stiffness with load. (default 0.13) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKX3 = 55,
  /** fixed [1]: Horizontal shift of F_x at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHX1 = 56,
  /** fixed [1]: Change of the horizontal shift of F_x with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHX2 = 57,
  /** fixed [1]: Vertical shift of F_x per load at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVX1 = 58,
  /** fixed [1]: Change of the vertical shift of F_x with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVX2 = 59,
  /** fixed [1]: Stiffness of the reduction of F_x by side slip. (default 17.4) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBX1 = 60,
  /** fixed [1]: Change of the stiffness of the reduction of F_x with longitudinal slip. (default 12.9) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBX2 = 61,
  /** fixed [1]: Shape factor of the reduction of F_x. (default 1.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RCX1 = 62,
  /** fixed [1]: Curvature of the reduction of F_x. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_REX1 = 63,
  /** fixed [1]: Change of the curvature of the reduction of F_x with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_REX2 = 64,
  /** fixed [1]: Shift of the reduction of F_x. (default 0.001) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RHX1 = 65,
  /** fixed [1]: Shape factor of F_y. (default 1.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PCY1 = 66,
  /** fixed [1]: Lateral friction at the nominal load. (default 1.2) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDY1 = 67,
  /** fixed [1]: Change of the lateral friction with load. (default -0.09) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDY2 = 68,
  /** fixed [1]: Change of the lateral friction with the square of camber. (default 0.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDY3 = 69,
  /** fixed [1]: Curvature of F_y at the nominal load. (default 0.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY1 = 70,
  /** fixed [1]: Change of the curvature of F_y with load. (default -1.2) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY2 = 71,
  /** fixed [1]: Change of the curvature of F_y with the sign of side slip. (default 0.05) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY3 = 72,
  /** fixed [1]: Change of the curvature of F_y with camber and the sign of side slip. (default -8.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY4 = 73,
  /** fixed [1]: Largest cornering stiffness per nominal load; negative for these axes. (default -75.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY1 = 74,
  /** fixed [1]: Load of the largest cornering stiffness per nominal load; not 0. (default 4.65) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY2 = 75,
  /** fixed [1]: Change of the cornering stiffness with camber. (default -0.6) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY3 = 76,
  /** fixed [1]: Horizontal shift of F_y at the nominal load. (default 0.003) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHY1 = 77,
  /** fixed [1]: Change of the horizontal shift of F_y with load. (default -0.0006) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHY2 = 78,
  /** fixed [1]: Change of the horizontal shift of F_y with camber. (default 0.004) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHY3 = 79,
  /** fixed [1]: Vertical shift of F_y per load at the nominal load. (default 0.04) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVY1 = 80,
  /** fixed [1]: Change of the vertical shift of F_y with load. (default -0.02) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVY2 = 81,
  /** fixed [1]: Change of the vertical shift of F_y with camber. (default -0.97) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVY3 = 82,
  /** fixed [1]: Change of the vertical shift of F_y with camber and load. (default -0.41) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVY4 = 83,
  /** fixed [1]: Stiffness of the reduction of F_y by longitudinal slip. (default 20.6) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBY1 = 84,
  /** fixed [1]: Change of the stiffness of the reduction of F_y with side slip. (default -23.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBY2 = 85,
  /** fixed [1]: Side slip at which that stiffness is largest. (default 0.001) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBY3 = 86,
  /** fixed [1]: Shape factor of the reduction of F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RCY1 = 87,
  /** fixed [1]: Curvature of the reduction of F_y. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_REY1 = 88,
  /** fixed [1]: Change of the curvature of the reduction of F_y with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_REY2 = 89,
  /** fixed [1]: Shift of the reduction of F_y. (default -0.02) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RHY1 = 90,
  /** fixed [1]: Change of the shift of the reduction of F_y with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RHY2 = 91,
  /** fixed [1]: Side force induced by longitudinal slip, at the nominal load. (default 0.16) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY1 = 92,
  /** fixed [1]: Change of the induced side force with load. (default 0.03) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY2 = 93,
  /** fixed [1]: Change of the induced side force with camber. (default 27.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY3 = 94,
  /** fixed [1]: Change of the induced side force with side slip. (default -29.7) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY4 = 95,
  /** fixed [1]: Shape factor of the induced side force. (default 0.03) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY5 = 96,
  /** fixed [1]: Stiffness of the induced side force. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY6 = 97,
  /** fixed [1]: Stiffness of the trail at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ1 = 98,
  /** fixed [1]: Change of the stiffness of the trail with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ2 = 99,
  /** fixed [1]: Change of the stiffness of the trail with the square of load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ3 = 100,
  /** fixed [1]: Change of the stiffness of the trail with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ4 = 101,
  /** fixed [1]: Change of the stiffness of the trail with the size of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ5 = 102,
  /** fixed [1]: Stiffness of the residual torque. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ9 = 103,
  /** fixed [1]: Stiffness of the residual torque per that of F_y. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ10 = 104,
  /** fixed [1]: Shape factor of the trail. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QCZ1 = 105,
  /** fixed [1]: Largest trail per radius at the nominal load; 0: no trail in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ1 = 106,
  /** fixed [1]: Change of the largest trail with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ2 = 107,
  /** fixed [1]: Change of the largest trail with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ3 = 108,
  /** fixed [1]: Change of the largest trail with the square of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ4 = 109,
  /** fixed [1]: Largest residual torque per radius and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ6 = 110,
  /** fixed [1]: Change of the residual torque with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ7 = 111,
  /** fixed [1]: Change of the residual torque with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ8 = 112,
  /** fixed [1]: Change of the residual torque with camber and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ9 = 113,
  /** fixed [1]: Curvature of the trail at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ1 = 114,
  /** fixed [1]: Change of the curvature of the trail with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ2 = 115,
  /** fixed [1]: Change of the curvature of the trail with the square of load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ3 = 116,
  /** fixed [1]: Change of the curvature of the trail with side slip. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ4 = 117,
  /** fixed [1]: Change of the curvature of the trail with side slip and camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ5 = 118,
  /** fixed [1]: Horizontal shift of the trail at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QHZ1 = 119,
  /** fixed [1]: Change of the horizontal shift of the trail with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QHZ2 = 120,
  /** fixed [1]: Change of the horizontal shift of the trail with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QHZ3 = 121,
  /** fixed [1]: Change of the horizontal shift of the trail with camber and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QHZ4 = 122,
  /** fixed [1]: Moment arm of F_x per radius. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SSZ1 = 123,
  /** fixed [1]: Change of the moment arm with F_y. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SSZ2 = 124,
  /** fixed [1]: Change of the moment arm with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SSZ3 = 125,
  /** fixed [1]: Change of the moment arm with camber and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SSZ4 = 126,
  /** fixed [1]: Overturning couple per radius and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX1 = 127,
  /** fixed [1]: Change of the overturning couple with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX2 = 128,
  /** fixed [1]: Change of the overturning couple with F_y. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX3 = 129,
  /** fixed [1]: Rolling resistance per radius and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY1 = 130,
  /** fixed [1]: Change of the rolling resistance with F_x. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY2 = 131,
  /** fixed [1]: Change of the rolling resistance with speed. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY3 = 132,
  /** fixed [1]: Change of the rolling resistance with the fourth power of speed. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY4 = 133,
  /** fixed [stribeck_side]: Side that the set was measured for; tyres on the other side are mirrored. (default Left) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SIDE = 134,
  /** state, out [m]: Position of the car's centre of gravity along the road. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_POSITION_X = 135,
  /** state, out [m]: Lateral position of the car's centre of gravity; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_POSITION_Y = 136,
  /** state, out [rad]: Yaw angle; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_YAW_ANGLE = 137,
  /** state, out [m/s]: Lateral velocity of the car's centre of gravity; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_LATERAL_VELOCITY = 138,
  /** state, out [rad/s]: Yaw rate; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_YAW_RATE = 139,
  /** out [m/s2]: Lateral acceleration of the car's centre of gravity; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_LATERAL_ACCELERATION = 140,
  /** fixed [m]: Height of the roll centre above the ground. (default 0.035) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_ROLL_CENTRE_HEIGHT = 141,
  /** fixed [m]: Distance between the wheels of the axle. (> 0, default 1.22) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_TRACK = 142,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.011) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_MOTION_RATIO = 143,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_STATIC_LENGTH = 144,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1325.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_STATIC_FORCE = 145,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_WHEEL_MASS = 146,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_TYRE_STIFFNESS = 147,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_TYRE_DAMPING = 148,
  /** fixed [m]: Height of the roll centre above the ground. (default 0.05) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_ROLL_CENTRE_HEIGHT = 149,
  /** fixed [m]: Distance between the wheels of the axle. (> 0, default 1.2) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_TRACK = 150,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.004) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_MOTION_RATIO = 151,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_STATIC_LENGTH = 152,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1100.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_STATIC_FORCE = 153,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_WHEEL_MASS = 154,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_TYRE_STIFFNESS = 155,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_TYRE_DAMPING = 156,
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_ROAD_HEIGHT = 157,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_ROAD_VELOCITY = 158,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_STRUT_FORCE = 159,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_WHEEL_HEIGHT = 160,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_WHEEL_VELOCITY = 161,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_LENGTH = 162,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_VELOCITY = 163,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_TYRE_LOAD = 164,
  /** state, out [rad]: Side slip of the tyre; positive when the wheel slips to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_SIDE_SLIP = 165,
  /** out [N]: Lateral force of the road on the tyre; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_LATERAL_FORCE = 166,
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_ROAD_HEIGHT = 167,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_ROAD_VELOCITY = 168,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_STRUT_FORCE = 169,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_WHEEL_HEIGHT = 170,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_WHEEL_VELOCITY = 171,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_LENGTH = 172,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_VELOCITY = 173,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_TYRE_LOAD = 174,
  /** state, out [rad]: Side slip of the tyre; positive when the wheel slips to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_SIDE_SLIP = 175,
  /** out [N]: Lateral force of the road on the tyre; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_LATERAL_FORCE = 176,
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_ROAD_HEIGHT = 177,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_ROAD_VELOCITY = 178,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1100.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_STRUT_FORCE = 179,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_WHEEL_HEIGHT = 180,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_WHEEL_VELOCITY = 181,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_LENGTH = 182,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_VELOCITY = 183,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_TYRE_LOAD = 184,
  /** state, out [rad]: Side slip of the tyre; positive when the wheel slips to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_SIDE_SLIP = 185,
  /** out [N]: Lateral force of the road on the tyre; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_LATERAL_FORCE = 186,
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_ROAD_HEIGHT = 187,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_ROAD_VELOCITY = 188,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1100.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_STRUT_FORCE = 189,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_WHEEL_HEIGHT = 190,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_WHEEL_VELOCITY = 191,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_LENGTH = 192,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_VELOCITY = 193,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_TYRE_LOAD = 194,
  /** state, out [rad]: Side slip of the tyre; positive when the wheel slips to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_SIDE_SLIP = 195,
  /** out [N]: Lateral force of the road on the tyre; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_LATERAL_FORCE = 196,
} stribeck_double_track_car_variable;

/** Guid of Posts for fmi2Instantiate. */
#define STRIBECK_POSTS_GUID "{9cf74dd5-8d05-60ef-a610-a20f57e55eed}"

/** Posts: Four-post rig. Columns of "Posts". */
typedef enum stribeck_posts_variable {
  /** out [m]: Height of the post under the wheel. */
  STRIBECK_POSTS_FL_POST_HEIGHT = 0,
  /** out [m/s]: Rate of the post's height. */
  STRIBECK_POSTS_FL_POST_VELOCITY = 1,
  /** fixed [m]: Travel of the post, lowest to highest. (>= 0, default 0.04) */
  STRIBECK_POSTS_FL_TRAVEL = 2,
  /** fixed [rad]: Phase lag of the post; it rests until then. (>= 0, default 0) */
  STRIBECK_POSTS_FL_PHASE = 3,
  /** out [m]: Height of the post under the wheel. */
  STRIBECK_POSTS_FR_POST_HEIGHT = 4,
  /** out [m/s]: Rate of the post's height. */
  STRIBECK_POSTS_FR_POST_VELOCITY = 5,
  /** fixed [m]: Travel of the post, lowest to highest. (>= 0, default 0.04) */
  STRIBECK_POSTS_FR_TRAVEL = 6,
  /** fixed [rad]: Phase lag of the post; it rests until then. (>= 0, default 0) */
  STRIBECK_POSTS_FR_PHASE = 7,
  /** out [m]: Height of the post under the wheel. */
  STRIBECK_POSTS_RL_POST_HEIGHT = 8,
  /** out [m/s]: Rate of the post's height. */
  STRIBECK_POSTS_RL_POST_VELOCITY = 9,
  /** fixed [m]: Travel of the post, lowest to highest. (>= 0, default 0.04) */
  STRIBECK_POSTS_RL_TRAVEL = 10,
  /** fixed [rad]: Phase lag of the post; it rests until then. (>= 0, default 1.5707963267948966) */
  STRIBECK_POSTS_RL_PHASE = 11,
  /** out [m]: Height of the post under the wheel. */
  STRIBECK_POSTS_RR_POST_HEIGHT = 12,
  /** out [m/s]: Rate of the post's height. */
  STRIBECK_POSTS_RR_POST_VELOCITY = 13,
  /** fixed [m]: Travel of the post, lowest to highest. (>= 0, default 0.04) */
  STRIBECK_POSTS_RR_TRAVEL = 14,
  /** fixed [rad]: Phase lag of the post; it rests until then. (>= 0, default 1.5707963267948966) */
  STRIBECK_POSTS_RR_PHASE = 15,
  /** tunable [Hz]: Frequency of the strokes. (>= 0, default 2) */
  STRIBECK_POSTS_FREQUENCY = 16,
  /** state [rad]: Angle of the drive. (default 0) */
  STRIBECK_POSTS_ANGLE = 17,
} stribeck_posts_variable;

#endif /* STRIBECK_H */
