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
 * Variables   A model is a row of numbers. Every variable has a number, its reference, which is also its FMI value
 *             reference. It follows from the name of the variable and never changes; the enums at the end of this file
 *             list the references of each model, with role, unit, meaning, bound and default: in = set by the caller
 *             before each step or evaluation; fixed = parameter that stays constant during a run; tunable = parameter
 *             that may change between steps or at events; state = advanced by steps or, in Model Exchange, by the
 *             caller's solver and by events; out = result. Booleans are 0 or 1, enumerations are numbers from 1.
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
 *     stribeck_instance *law = NULL;
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
   * The variable does not exist in this model, or the requested derivative is not that of a result with respect to
   * something that can be set.
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
typedef struct stribeck_instance stribeck_instance;

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

/** Variables with arrays of values, which stribeck_run reads. The arrays belong to the caller. */
typedef struct {
  /** References of the variables. */
  const uint32_t *references;
  /** An array for each of them. */
  const double *const *values;
  /** Number of variables. */
  size_t count;
} stribeck_samples;

/**
 * Variables with arrays for their values, which stribeck_run writes. The arrays belong to the caller and do not overlap.
 */
typedef struct {
  /** References of the variables. */
  const uint32_t *references;
  /** An array for each of them. */
  double *const *values;
  /** Number of variables. */
  size_t count;
} stribeck_results;

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

/** Kinds of status for fmi2GetStatus, fmi2GetRealStatus and the functions of the other types. */
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
 * Makes an instance at its start values and writes its handle to `*instance`, or NULL on failure. The handle must be freed
 * once with stribeck_free.
 */
stribeck_status stribeck_create(const char *name,
                                stribeck_instance **instance);

/** Frees an instance. NULL is ignored. */
void stribeck_free(stribeck_instance *instance);

/**
 * Reason why the last refused call on this handle was refused. The text lives until the next call on the handle. For
 * NULL it says that the handle is NULL; the only reason given by a failed stribeck_create is its status.
 */
const char *stribeck_last_error(const stribeck_instance *instance);

/** Resets the instance to its start values and to time 0. */
stribeck_status stribeck_reset(stribeck_instance *instance);

/** Number of variables; 0 for NULL. */
uint32_t stribeck_variable_count(const stribeck_instance *instance);

/** Reference of the variable with that index, from 0, in the order of the enums of this header. */
stribeck_status stribeck_reference(stribeck_instance *instance, uint32_t index, uint32_t *reference);

/** Reference of the variable with this name. The enums of this header hold the same numbers. */
stribeck_status stribeck_find(stribeck_instance *instance, const char *variable, uint32_t *reference);

/** Describes a variable: name, unit, help text, role, kind, start value and bounds. */
stribeck_status stribeck_describe(stribeck_instance *instance, uint32_t reference, stribeck_variable *variable);

/** Number of presets, that is, named parameter sets, of the model; 0 for NULL. */
size_t stribeck_preset_count(const stribeck_instance *instance);

/** Name of the preset with this index, from 0; NULL beyond the last. The text belongs to the handle. */
const char *stribeck_preset_name(const stribeck_instance *instance, size_t index);

/** Source of the values of the preset with this index; NULL beyond the last. The text belongs to the handle. */
const char *stribeck_preset_source(const stribeck_instance *instance, size_t index);

/**
 * Sets all parameters: those in the named preset to its values, the others to their start values. Inputs in the preset
 * are set as well.
 */
stribeck_status stribeck_apply_preset(stribeck_instance *instance, const char *preset);

/** Sets a variable. Everything except computed results can be set at any time; outputs follow at once. */
stribeck_status stribeck_set(stribeck_instance *instance, uint32_t reference, double value);

/** Reads a variable; results are computed first if anything has been set since. */
stribeck_status stribeck_get(stribeck_instance *instance, uint32_t reference, double *value);

/** As stribeck_set, by name. Slower: look the reference up once with stribeck_find if it is set often. */
stribeck_status stribeck_set_by_name(stribeck_instance *instance, const char *variable, double value);

/** As stribeck_get, by name. */
stribeck_status stribeck_get_by_name(stribeck_instance *instance, const char *variable, double *value);

/** Advances the instance by `dt` > 0 seconds with held inputs and computes the results. */
stribeck_status stribeck_step(stribeck_instance *instance, double dt);

/**
 * Computes the results now, and checks that the parameters fit together and the results are finite. Advice, such as a
 * `step_limit`, is computed when it is read.
 */
stribeck_status stribeck_output(stribeck_instance *instance);

/** Time since creation or reset, in seconds; NaN for NULL. */
double stribeck_time(const stribeck_instance *instance);

/**
 * Partial derivative of a result with respect to an input, parameter or state, at the present values: exact, except
 * for the friction of ShockAbsorber before its first step, which is differentiated numerically.
 */
stribeck_status stribeck_derivative(stribeck_instance *instance, uint32_t output, uint32_t input, double *value);

/**
 * Leads the instance along samples of its inputs, `dt` seconds apart: at each of the `samples` it sets the inputs, reads the
 * results and, except at the last one, makes a step. Each array has a value per sample. With `held` = 0 the inputs move
 * along straight lines between the samples; otherwise they keep the earlier value, as with stribeck_step. The results are
 * the same, to the last bit, as those of single calls.
 *
 * A refused call leaves the instance as it was, and stribeck_last_error names the sample; the arrays of `results` may have
 * been written to. Nothing is allocated between the samples. `inputs` and `results` may be NULL if there are none.
 */
stribeck_status stribeck_run(stribeck_instance *instance,
                             double dt,
                             size_t samples,
                             int held,
                             const stribeck_samples *inputs,
                             const stribeck_results *results);

/**
 * As stribeck_run, for several runs that all begin with the present state of the instance, to which it returns at the end.
 * Each array of `parameters`, which may be any variables that can be set, has a value per run; each array of `inputs` and
 * `results` has `samples` values per run, run after run. Runs of laws without modes, over held inputs, are made side by
 * side in the registers of the processor, with the bits of each by itself.
 */
stribeck_status stribeck_run_many(stribeck_instance *instance,
                                  double dt,
                                  size_t samples,
                                  size_t runs,
                                  int held,
                                  const stribeck_samples *parameters,
                                  const stribeck_samples *inputs,
                                  const stribeck_results *results);

/** Number of bytes that stribeck_save writes; 0 for NULL. */
size_t stribeck_state_size(const stribeck_instance *instance);

/** Writes the complete state of the instance, including parameters and time, as bytes that any process can read. */
stribeck_status stribeck_save(stribeck_instance *instance, void *buffer, size_t size);

/**
 * Restores a saved state of this or of another instance of the same model. Foreign or damaged bytes are refused, and
 * so is a state that only events of Model Exchange can produce (`phase`).
 */
stribeck_status stribeck_restore(stribeck_instance *instance, const void *buffer, size_t size);

/**
 * Warning about the present values, if some were accepted although they make no sense, such as an unconnected input at
 * 0, or if the model can give back more energy than it took with these parameters; otherwise an empty text. Best
 * called after the first step; the library does not report warnings by itself. The text lives until the next call of
 * this function on the handle. For NULL it says that the handle is NULL.
 */
const char *stribeck_warning(stribeck_instance *instance);

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
 * is blank, or if memory runs out. If `callbacks` is NULL it returns NULL without a message.
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

/** Returns fmi2Discard: steps are never asynchronous. */
fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind s, fmi2Status *value);

/** `fmi2LastSuccessfulTime`: the end of the last completed step. fmi2Discard for other kinds. */
fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind s, fmi2Real *value);

/** Returns fmi2Discard: FMI 2.0 defines no integer status. */
fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind s, fmi2Integer *value);

/** `fmi2Terminated`: no model ends the simulation, so fmi2False. fmi2Discard for other kinds. */
fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind s, fmi2Boolean *value);

/** Returns fmi2Discard: steps are never asynchronous. */
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

/** Choices of a variable of the type AccelerationSource. */
typedef enum stribeck_acceleration_source {
  /** From the slope of the velocity or, without one, from the input acceleration. */
  STRIBECK_ACCELERATION_SOURCE_INPUT = 1,
  /** From the balance of the external force and friction. */
  STRIBECK_ACCELERATION_SOURCE_BALANCE = 2,
} stribeck_acceleration_source;

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

/** Choices of a variable of the type Compensation. */
typedef enum stribeck_compensation {
  /** The controller knows nothing of friction. */
  STRIBECK_COMPENSATION_OFF = 1,
  /** Coulomb and viscous friction at the velocity of the target. */
  STRIBECK_COMPENSATION_FEED_FORWARD = 2,
  /** The force of LuGre's law, whose deflection an observer estimates from the velocity and the position error. */
  STRIBECK_COMPENSATION_OBSERVER = 3,
} stribeck_compensation;

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
  /** Hysteresis that follows a voltage: see MagnetorheologicalDamper. */
  STRIBECK_DAMPER_MODE_MAGNETORHEOLOGICAL_DAMPER = 4,
} stribeck_damper_mode;

/** Choices of a variable of the type ElementDistribution. */
typedef enum stribeck_element_distribution {
  /** The shares of each element are given. */
  STRIBECK_ELEMENT_DISTRIBUTION_EXPLICIT = 1,
  /** Equal stiffness and evenly spaced slip displacements: the virgin curve is nearly a parabola. */
  STRIBECK_ELEMENT_DISTRIBUTION_UNIFORM = 2,
} stribeck_element_distribution;

/** Choices of a variable of the type ExchangeOrder. */
typedef enum stribeck_exchange_order {
  /** The friction model steps first, and the host uses the force of that step (Gauss-Seidel). */
  STRIBECK_EXCHANGE_ORDER_SEQUENTIAL = 1,
  /** All models step at once and exchange values afterwards, so the force acts one step later (Jacobi). */
  STRIBECK_EXCHANGE_ORDER_PARALLEL = 2,
} stribeck_exchange_order;

/** Choices of a variable of the type FormulaVersion. */
typedef enum stribeck_formula_version {
  /** Version 5.2, as PAC2002. */
  STRIBECK_FORMULA_VERSION_FIVE = 1,
  /** Versions 6.1 and 6.2, whose forces and moments are the same. */
  STRIBECK_FORMULA_VERSION_SIX = 2,
} stribeck_formula_version;

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
  /** Friction of a cylinder with a lubricant film that needs time (Tran and Yanada) */
  STRIBECK_FRICTION_MODEL_CYLINDER_FRICTION = 34,
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

/** Choices of a variable of the type LiangMotion. */
typedef enum stribeck_liang_motion {
  /** Determined by deflection and velocity: no event has set it, as in co-simulation. */
  STRIBECK_LIANG_MOTION_FREE = 1,
  /** Moves with the surface, within the static limit. */
  STRIBECK_LIANG_MOTION_BONDED = 2,
  /** Slides at the static limit. */
  STRIBECK_LIANG_MOTION_SLIDING = 3,
  /** Moves with the surface, within the kinetic limit. */
  STRIBECK_LIANG_MOTION_BONDED_FAST = 4,
  /** Slides at the kinetic limit. */
  STRIBECK_LIANG_MOTION_SLIDING_FAST = 5,
} stribeck_liang_motion;

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

/** Choices of a variable of the type RateAndStateVariant. */
typedef enum stribeck_rate_and_state_variant {
  /** Contacts age with time, also at rest (Dieterich). */
  STRIBECK_RATE_AND_STATE_VARIANT_AGEING = 1,
  /** Contacts change only by sliding (Ruina). */
  STRIBECK_RATE_AND_STATE_VARIANT_SLIP = 2,
} stribeck_rate_and_state_variant;

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
#define STRIBECK_COULOMB_GUID "{fb9a3d77-1dd8-e510-3e61-4e4926818cd2}"

/** Coulomb: Coulomb friction. Variables of "Coulomb". */
typedef enum stribeck_coulomb_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_COULOMB_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_COULOMB_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_COULOMB_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_COULOMB_MU_K = 1281456745,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_COULOMB_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_COULOMB_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_COULOMB_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_COULOMB_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_COULOMB_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_COULOMB_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_COULOMB_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_COULOMB_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_COULOMB_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_COULOMB_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_COULOMB_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_COULOMB_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_COULOMB_STICKING = 553311409,
} stribeck_coulomb_variable;

/** Guid of CoulombStiction for fmi2Instantiate. */
#define STRIBECK_COULOMB_STICTION_GUID "{61dc50b8-b11f-b3f7-ef1b-dd846f296a13}"

/** CoulombStiction: Coulomb friction with stiction. Variables of "CoulombStiction". */
typedef enum stribeck_coulomb_stiction_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_COULOMB_STICTION_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_COULOMB_STICTION_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_COULOMB_STICTION_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_COULOMB_STICTION_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_COULOMB_STICTION_MU_S = 1147235793,
  /** state [Boolean]: Is the contact stuck since the last step? Only with mass > 0; in Model Exchange see phase.
   *  (default false) */
  STRIBECK_COULOMB_STICTION_STUCK = 1549186443,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_COULOMB_STICTION_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_COULOMB_STICTION_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_COULOMB_STICTION_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_COULOMB_STICTION_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_STICTION_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_STICTION_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_STICTION_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_COULOMB_STICTION_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_COULOMB_STICTION_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_COULOMB_STICTION_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_COULOMB_STICTION_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_COULOMB_STICTION_STICKING = 553311409,
} stribeck_coulomb_stiction_variable;

/** Guid of CoulombViscous for fmi2Instantiate. */
#define STRIBECK_COULOMB_VISCOUS_GUID "{588184f2-7da0-6b2c-e0a2-abf758f07895}"

/** CoulombViscous: Coulomb friction with a viscous part. Variables of "CoulombViscous". */
typedef enum stribeck_coulomb_viscous_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_COULOMB_VISCOUS_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_COULOMB_VISCOUS_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_COULOMB_VISCOUS_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_COULOMB_VISCOUS_MU_K = 1281456745,
  /** fixed [stribeck_coulomb_viscous_variant]: Variant of the law. (default Linear) */
  STRIBECK_COULOMB_VISCOUS_VARIANT = 1125473670,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_COULOMB_VISCOUS_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [1]: Exponent of the viscous part. (> 0, default 1) */
  STRIBECK_COULOMB_VISCOUS_VISCOUS_EXPONENT = 884504011,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_COULOMB_VISCOUS_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_COULOMB_VISCOUS_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_COULOMB_VISCOUS_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_COULOMB_VISCOUS_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_COULOMB_VISCOUS_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_COULOMB_VISCOUS_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_COULOMB_VISCOUS_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_COULOMB_VISCOUS_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_VISCOUS_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_VISCOUS_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_COULOMB_VISCOUS_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_COULOMB_VISCOUS_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_COULOMB_VISCOUS_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_COULOMB_VISCOUS_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_COULOMB_VISCOUS_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_COULOMB_VISCOUS_STICKING = 553311409,
} stribeck_coulomb_viscous_variable;

/** Guid of Stribeck for fmi2Instantiate. */
#define STRIBECK_STRIBECK_GUID "{380a7ede-8754-8e45-72dd-110b503a7aaf}"

/** Stribeck: Friction that falls with speed from the static to the kinetic level (Stribeck). Variables of "Stribeck". */
typedef enum stribeck_stribeck_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_STRIBECK_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_STRIBECK_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_STRIBECK_EXTERNAL_FORCE = 1336490458,
  /** fixed [stribeck_stribeck_curve]: How the level falls with speed. (default Gaussian) */
  STRIBECK_STRIBECK_CURVE = 423101972,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_STRIBECK_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_STRIBECK_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which 1/e of the excess is left; one half with HessSoom and PoppStelter.
   *  (> 0, default 0.001) */
  STRIBECK_STRIBECK_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_STRIBECK_STRIBECK_EXPONENT = 509292062,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_STRIBECK_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [N.s2/m2]: Quadratic friction coefficient; used by PoppStelter. (>= 0, default 0) */
  STRIBECK_STRIBECK_QUADRATIC_COEFFICIENT = 1815977239,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_STRIBECK_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_STRIBECK_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_STRIBECK_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_STRIBECK_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_STRIBECK_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_STRIBECK_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_STRIBECK_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_STRIBECK_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_STRIBECK_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_STRIBECK_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_STRIBECK_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_STRIBECK_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_STRIBECK_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_STRIBECK_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_STRIBECK_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_STRIBECK_STICKING = 553311409,
} stribeck_stribeck_variable;

/** Guid of Bernard for fmi2Instantiate. */
#define STRIBECK_BERNARD_GUID "{66b45405-95ae-cdd3-fcb2-50ec04f626e8}"

/** Preset of Bernard: Novais (2024), Tables 6.1 and 6.2 (the start values). */
#define STRIBECK_BERNARD_PRESET_THESIS "thesis"

/** Bernard: Coulomb friction with a linear transition, by its slope (Bernard). Variables of "Bernard". */
typedef enum stribeck_bernard_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BERNARD_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BERNARD_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_BERNARD_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BERNARD_MU_K = 1281456745,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 2000) */
  STRIBECK_BERNARD_TRANSITION_SLOPE = 573976870,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_BERNARD_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_BERNARD_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_BERNARD_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_BERNARD_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_BERNARD_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_BERNARD_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_BERNARD_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_BERNARD_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BERNARD_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BERNARD_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BERNARD_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_BERNARD_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BERNARD_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BERNARD_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BERNARD_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BERNARD_STICKING = 553311409,
} stribeck_bernard_variable;

/** Guid of Threlfall for fmi2Instantiate. */
#define STRIBECK_THRELFALL_GUID "{8c86de35-30c5-83fe-0e6e-abd3c9c7946f}"

/** Preset of Threlfall: Novais (2024), Tables 6.1 and 6.2 (the start values). */
#define STRIBECK_THRELFALL_PRESET_THESIS "thesis"

/** Threlfall: Coulomb friction with an exponential transition (Threlfall). Variables of "Threlfall". */
typedef enum stribeck_threlfall_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_THRELFALL_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_THRELFALL_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_THRELFALL_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_THRELFALL_MU_K = 1281456745,
  /** fixed [stribeck_threlfall_variant]: Variant of the law. (default Printed) */
  STRIBECK_THRELFALL_VARIANT = 1125473670,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_THRELFALL_TRANSITION_VELOCITY = 1009615136,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_THRELFALL_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_THRELFALL_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_THRELFALL_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_THRELFALL_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_THRELFALL_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_THRELFALL_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_THRELFALL_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_THRELFALL_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_THRELFALL_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_THRELFALL_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_THRELFALL_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_THRELFALL_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_THRELFALL_STICKING = 553311409,
} stribeck_threlfall_variable;

/** Guid of ThrelfallModified for fmi2Instantiate. */
#define STRIBECK_THRELFALL_MODIFIED_GUID "{6845c27a-07a8-2915-c313-9649aa118b9a}"

/** Preset of ThrelfallModified: Novais (2024), Tables 6.1 and 6.2 (the start values). */
#define STRIBECK_THRELFALL_MODIFIED_PRESET_THESIS "thesis"

/** ThrelfallModified: Coulomb friction with an exponential transition up to the Coulomb level (modified Threlfall). Variables of "ThrelfallModified". */
typedef enum stribeck_threlfall_modified_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_THRELFALL_MODIFIED_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_THRELFALL_MODIFIED_MU_K = 1281456745,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_THRELFALL_MODIFIED_TRANSITION_VELOCITY = 1009615136,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_THRELFALL_MODIFIED_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_THRELFALL_MODIFIED_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_THRELFALL_MODIFIED_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_THRELFALL_MODIFIED_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_THRELFALL_MODIFIED_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_THRELFALL_MODIFIED_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_THRELFALL_MODIFIED_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_THRELFALL_MODIFIED_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_THRELFALL_MODIFIED_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_THRELFALL_MODIFIED_STICKING = 553311409,
} stribeck_threlfall_modified_variable;

/** Guid of RooneyDeravi for fmi2Instantiate. */
#define STRIBECK_ROONEY_DERAVI_GUID "{0f480c2e-e0ef-6e75-f0fa-27bf9c4880a9}"

/** Preset of RooneyDeravi: Novais (2024), Tables 6.1 and 6.2 (the start values), in the form of (6.5). */
#define STRIBECK_ROONEY_DERAVI_PRESET_THESIS "thesis"

/** RooneyDeravi: Coulomb friction with a transition band (Rooney and Deravi). Variables of "RooneyDeravi". */
typedef enum stribeck_rooney_deravi_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ROONEY_DERAVI_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ROONEY_DERAVI_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_ROONEY_DERAVI_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ROONEY_DERAVI_MU_K = 1281456745,
  /** fixed [stribeck_rooney_deravi_variant]: Variant of the law. (default Linear) */
  STRIBECK_ROONEY_DERAVI_VARIANT = 1125473670,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_ROONEY_DERAVI_TRANSITION_VELOCITY = 1009615136,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_ROONEY_DERAVI_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_ROONEY_DERAVI_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_ROONEY_DERAVI_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_ROONEY_DERAVI_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_ROONEY_DERAVI_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_ROONEY_DERAVI_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_ROONEY_DERAVI_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_ROONEY_DERAVI_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROONEY_DERAVI_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROONEY_DERAVI_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROONEY_DERAVI_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_ROONEY_DERAVI_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ROONEY_DERAVI_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ROONEY_DERAVI_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ROONEY_DERAVI_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ROONEY_DERAVI_STICKING = 553311409,
} stribeck_rooney_deravi_variable;

/** Guid of Ambrosio for fmi2Instantiate. */
#define STRIBECK_AMBROSIO_GUID "{f3bf559a-0312-68ef-9c89-426bb4f1643f}"

/** Preset of Ambrosio: Novais (2024), Tables 6.1 and 6.2 (the start values). */
#define STRIBECK_AMBROSIO_PRESET_THESIS "thesis"

/** Ambrosio: Coulomb friction that is ramped up with speed (Ambrosio). Variables of "Ambrosio". */
typedef enum stribeck_ambrosio_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_AMBROSIO_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_AMBROSIO_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_AMBROSIO_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_AMBROSIO_MU_K = 1281456745,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (>= 0, default 0.0001) */
  STRIBECK_AMBROSIO_TRANSITION_VELOCITY = 1009615136,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.001) */
  STRIBECK_AMBROSIO_SLIDING_VELOCITY = 868290001,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_AMBROSIO_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_AMBROSIO_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_AMBROSIO_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_AMBROSIO_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_AMBROSIO_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_AMBROSIO_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_AMBROSIO_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_AMBROSIO_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AMBROSIO_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AMBROSIO_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AMBROSIO_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_AMBROSIO_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_AMBROSIO_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_AMBROSIO_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_AMBROSIO_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_AMBROSIO_STICKING = 553311409,
} stribeck_ambrosio_variable;

/** Guid of Karnopp for fmi2Instantiate. */
#define STRIBECK_KARNOPP_GUID "{d3159ed2-f53f-c2dd-5023-bfcfc382f1f6}"

/** Karnopp: Coulomb friction with a band of stiction (Karnopp). Variables of "Karnopp". */
typedef enum stribeck_karnopp_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_KARNOPP_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_KARNOPP_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_KARNOPP_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_KARNOPP_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_KARNOPP_MU_S = 1147235793,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_KARNOPP_TRANSITION_VELOCITY = 1009615136,
  /** state [Boolean]: Is the contact stuck since the last step? Only with mass > 0; in Model Exchange see phase.
   *  (default false) */
  STRIBECK_KARNOPP_STUCK = 1549186443,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_KARNOPP_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_KARNOPP_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_KARNOPP_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_KARNOPP_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_KARNOPP_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_KARNOPP_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_KARNOPP_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_KARNOPP_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_KARNOPP_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_KARNOPP_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_KARNOPP_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_KARNOPP_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_KARNOPP_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_KARNOPP_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_KARNOPP_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_KARNOPP_STICKING = 553311409,
} stribeck_karnopp_variable;

/** Guid of BengisuAkay for fmi2Instantiate. */
#define STRIBECK_BENGISU_AKAY_GUID "{4d98475b-6060-ae8d-af46-9b437f359427}"

/** Preset of BengisuAkay: Form of Marques et al. (2016), with a chosen decay: 1/e in 1 mm/s. */
#define STRIBECK_BENGISU_AKAY_PRESET_MARQUES_2016 "marques_2016"

/** BengisuAkay: Continuous friction law with a stiction peak (Bengisu and Akay). Variables of "BengisuAkay". */
typedef enum stribeck_bengisu_akay_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BENGISU_AKAY_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BENGISU_AKAY_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_BENGISU_AKAY_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BENGISU_AKAY_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_BENGISU_AKAY_MU_S = 1147235793,
  /** fixed [stribeck_bengisu_akay_variant]: Variant of the law. (default Thesis) */
  STRIBECK_BENGISU_AKAY_VARIANT = 1125473670,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 5000) */
  STRIBECK_BENGISU_AKAY_TRANSITION_SLOPE = 573976870,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 500) */
  STRIBECK_BENGISU_AKAY_STICTION_DECAY = 1861695917,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_BENGISU_AKAY_TRANSITION_VELOCITY = 1009615136,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_BENGISU_AKAY_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_BENGISU_AKAY_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_BENGISU_AKAY_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_BENGISU_AKAY_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_BENGISU_AKAY_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_BENGISU_AKAY_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_BENGISU_AKAY_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_BENGISU_AKAY_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BENGISU_AKAY_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BENGISU_AKAY_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BENGISU_AKAY_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_BENGISU_AKAY_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BENGISU_AKAY_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BENGISU_AKAY_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BENGISU_AKAY_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BENGISU_AKAY_STICKING = 553311409,
} stribeck_bengisu_akay_variable;

/** Guid of Hollars for fmi2Instantiate. */
#define STRIBECK_HOLLARS_GUID "{750f8ef7-ef41-2355-b37a-689070069bd7}"

/** Preset of Hollars: Default transition velocity of Simbody. */
#define STRIBECK_HOLLARS_PRESET_SIMBODY "simbody"

/** Hollars: Continuous friction law with a stiction peak, without exponentials (Hollars). Variables of "Hollars". */
typedef enum stribeck_hollars_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_HOLLARS_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_HOLLARS_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_HOLLARS_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_HOLLARS_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_HOLLARS_MU_S = 1147235793,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_HOLLARS_TRANSITION_VELOCITY = 1009615136,
  /** tunable [s/m]: Viscous coefficient of friction, per normal force. (>= 0, default 0) */
  STRIBECK_HOLLARS_MU_V = 1197568650,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_HOLLARS_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_HOLLARS_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_HOLLARS_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_HOLLARS_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_HOLLARS_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_HOLLARS_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_HOLLARS_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_HOLLARS_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_HOLLARS_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_HOLLARS_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_HOLLARS_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_HOLLARS_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_HOLLARS_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_HOLLARS_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_HOLLARS_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_HOLLARS_STICKING = 553311409,
} stribeck_hollars_variable;

/** Guid of Andersson for fmi2Instantiate. */
#define STRIBECK_ANDERSSON_GUID "{5559a5ef-e443-c8b7-3b54-512d213d7669}"

/** Preset of Andersson: Conveyor-belt example of Nikravesh, Planar Multibody Dynamics. */
#define STRIBECK_ANDERSSON_PRESET_CONVEYOR_BELT "conveyor_belt"

/** Andersson: Smooth friction law with the Stribeck curve (Andersson). Variables of "Andersson". */
typedef enum stribeck_andersson_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ANDERSSON_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ANDERSSON_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_ANDERSSON_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ANDERSSON_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_ANDERSSON_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_ANDERSSON_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_ANDERSSON_STRIBECK_EXPONENT = 509292062,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 10000) */
  STRIBECK_ANDERSSON_TRANSITION_SLOPE = 573976870,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_ANDERSSON_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_ANDERSSON_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_ANDERSSON_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_ANDERSSON_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_ANDERSSON_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_ANDERSSON_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_ANDERSSON_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_ANDERSSON_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_ANDERSSON_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ANDERSSON_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ANDERSSON_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ANDERSSON_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_ANDERSSON_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ANDERSSON_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ANDERSSON_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ANDERSSON_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ANDERSSON_STICKING = 553311409,
} stribeck_andersson_variable;

/** Guid of Awrejcewicz for fmi2Instantiate. */
#define STRIBECK_AWREJCEWICZ_GUID "{71ce3492-82a5-ed49-4da8-e07d6e390c23}"

/** Awrejcewicz: Continuous friction law that holds a load at rest (Awrejcewicz, Grzelczyk and Pyryev). Variables of "Awrejcewicz". */
typedef enum stribeck_awrejcewicz_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_AWREJCEWICZ_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_AWREJCEWICZ_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_AWREJCEWICZ_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_AWREJCEWICZ_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_AWREJCEWICZ_MU_S = 1147235793,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_AWREJCEWICZ_TRANSITION_VELOCITY = 1009615136,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_AWREJCEWICZ_STICTION_DECAY = 1861695917,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_AWREJCEWICZ_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_AWREJCEWICZ_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_AWREJCEWICZ_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_AWREJCEWICZ_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_AWREJCEWICZ_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_AWREJCEWICZ_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_AWREJCEWICZ_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_AWREJCEWICZ_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AWREJCEWICZ_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AWREJCEWICZ_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_AWREJCEWICZ_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_AWREJCEWICZ_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_AWREJCEWICZ_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_AWREJCEWICZ_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_AWREJCEWICZ_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_AWREJCEWICZ_STICKING = 553311409,
} stribeck_awrejcewicz_variable;

/** Guid of Specker for fmi2Instantiate. */
#define STRIBECK_SPECKER_GUID "{f11f0235-b458-842c-ff2e-d36f90dc8934}"

/** Preset of Specker: Ratio of the two velocities in Translational Friction of Simscape, v_0 = v_p / 10, at v_p = 0.5 mm/s. */
#define STRIBECK_SPECKER_PRESET_SIMSCAPE "simscape"

/** Specker: Smooth friction law that passes through the static level (Specker). Variables of "Specker". */
typedef enum stribeck_specker_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_SPECKER_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_SPECKER_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_SPECKER_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_SPECKER_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_SPECKER_MU_S = 1147235793,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_SPECKER_TRANSITION_VELOCITY = 1009615136,
  /** tunable [m/s]: Velocity at which the static level is reached (default chosen). (> 0, default 0.0005) */
  STRIBECK_SPECKER_PEAK_VELOCITY = 593654064,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SPECKER_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_SPECKER_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_SPECKER_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_SPECKER_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_SPECKER_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_SPECKER_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_SPECKER_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_SPECKER_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_SPECKER_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SPECKER_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SPECKER_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SPECKER_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_SPECKER_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_SPECKER_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_SPECKER_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_SPECKER_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_SPECKER_STICKING = 553311409,
} stribeck_specker_variable;

/** Guid of LinearStiction for fmi2Instantiate. */
#define STRIBECK_LINEAR_STICTION_GUID "{e43f8d13-c915-67c4-2579-aab87a25b98e}"

/** LinearStiction: Friction law with stiction made of three straight lines. Variables of "LinearStiction". */
typedef enum stribeck_linear_stiction_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_LINEAR_STICTION_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LINEAR_STICTION_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_LINEAR_STICTION_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LINEAR_STICTION_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LINEAR_STICTION_MU_S = 1147235793,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_LINEAR_STICTION_TRANSITION_VELOCITY = 1009615136,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.0015) */
  STRIBECK_LINEAR_STICTION_SLIDING_VELOCITY = 868290001,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_LINEAR_STICTION_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_LINEAR_STICTION_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_LINEAR_STICTION_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_LINEAR_STICTION_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_LINEAR_STICTION_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_LINEAR_STICTION_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_LINEAR_STICTION_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_LINEAR_STICTION_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_LINEAR_STICTION_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_LINEAR_STICTION_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_LINEAR_STICTION_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_LINEAR_STICTION_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LINEAR_STICTION_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LINEAR_STICTION_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LINEAR_STICTION_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LINEAR_STICTION_STICKING = 553311409,
} stribeck_linear_stiction_variable;

/** Guid of BrownMcPhee for fmi2Instantiate. */
#define STRIBECK_BROWN_MCPHEE_GUID "{807a5181-8e45-b143-2042-6ea3ffd4ddaf}"

/** BrownMcPhee: Smooth friction law with a stiction peak (Brown and McPhee). Variables of "BrownMcPhee". */
typedef enum stribeck_brown_mcphee_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BROWN_MCPHEE_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BROWN_MCPHEE_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_BROWN_MCPHEE_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BROWN_MCPHEE_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_BROWN_MCPHEE_MU_S = 1147235793,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_BROWN_MCPHEE_TRANSITION_VELOCITY = 1009615136,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [N]: Normal force at which the viscous part is fully active (default chosen). (> 0, default 1) */
  STRIBECK_BROWN_MCPHEE_TRANSITION_NORMAL_FORCE = 341816060,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_BROWN_MCPHEE_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_BROWN_MCPHEE_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_BROWN_MCPHEE_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_BROWN_MCPHEE_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BROWN_MCPHEE_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BROWN_MCPHEE_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_BROWN_MCPHEE_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_BROWN_MCPHEE_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BROWN_MCPHEE_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BROWN_MCPHEE_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BROWN_MCPHEE_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BROWN_MCPHEE_STICKING = 553311409,
} stribeck_brown_mcphee_variable;

/** Guid of Dahl for fmi2Instantiate. */
#define STRIBECK_DAHL_GUID "{81261687-8d7f-44de-0214-fbf63612f2b5}"

/** Preset of Dahl: Novais (2024), Tables 6.1 and 7.1, in the form (7.5), alpha = 1 (the start values). */
#define STRIBECK_DAHL_PRESET_THESIS "thesis"

/** Preset of Dahl: Example of a suspension bushing: 60 N of hysteresis, reached over some 0.2 mm. */
#define STRIBECK_DAHL_PRESET_BUSHING "bushing"

/** Dahl: Pre-sliding displacement with hysteresis (Dahl). Variables of "Dahl". */
typedef enum stribeck_dahl_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_DAHL_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_DAHL_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_DAHL_MU_K = 1281456745,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_DAHL_SIGMA_0 = 206242323,
  /** tunable [1]: Exponent of the transition to sliding; below 1 brittle, from 1 on ductile. (>= 0, default 1) */
  STRIBECK_DAHL_ALPHA = 1569418667,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_DAHL_BRISTLE_DEFLECTION = 767148150,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_DAHL_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_DAHL_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_DAHL_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_DAHL_STICKING = 553311409,
} stribeck_dahl_variable;

/** Guid of LuGre for fmi2Instantiate. */
#define STRIBECK_LUGRE_GUID "{bdfcf639-f9dc-473e-ecbe-a3a094ef8c0d}"

/** Preset of LuGre: Novais (2024), Tables 6.1 and 7.1 (the start values). */
#define STRIBECK_LUGRE_PRESET_THESIS "thesis"

/** Preset of LuGre: Canudas de Wit et al. (1995), Table I: F_C = 1 N, F_S = 1.5 N, here at a normal force of 1 N. */
#define STRIBECK_LUGRE_PRESET_CANUDAS_1995 "canudas_1995"

/** Preset of LuGre: Example of the rod seal of a damper: 30 N sliding, 45 N at breakaway, at a contact force of 300 N. */
#define STRIBECK_LUGRE_PRESET_ROD_SEAL "rod_seal"

/** LuGre: Bristle friction with Stribeck effect (LuGre). Variables of "LuGre". */
typedef enum stribeck_lugre_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_LUGRE_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LUGRE_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (> 0, default 0.1) */
  STRIBECK_LUGRE_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LUGRE_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_LUGRE_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_LUGRE_STRIBECK_EXPONENT = 509292062,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_LUGRE_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_LUGRE_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_LUGRE_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_LUGRE_DAMPING_VELOCITY = 626846797,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_LUGRE_BRISTLE_DEFLECTION = 767148150,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LUGRE_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LUGRE_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LUGRE_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LUGRE_STICKING = 553311409,
} stribeck_lugre_variable;

/** Guid of FrictionalLag for fmi2Instantiate. */
#define STRIBECK_FRICTIONAL_LAG_GUID "{920d25db-c641-75de-0fcb-c6fbf188de4f}"

/** Preset of FrictionalLag: Example of a lubricated guide: lag and Stribeck velocity in the middle of the reported ranges. */
#define STRIBECK_FRICTIONAL_LAG_PRESET_LUBRICATED_GUIDE "lubricated_guide"

/** Preset of FrictionalLag: Example for a visible loop: drive it with (2 + 1.5 sin(2 pi t)) mm/s. */
#define STRIBECK_FRICTIONAL_LAG_PRESET_SLOW_OSCILLATION "slow_oscillation"

/** FrictionalLag: Stribeck friction that lags behind the velocity (Hess and Soom). Variables of "FrictionalLag". */
typedef enum stribeck_frictional_lag_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_FRICTIONAL_LAG_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_FRICTIONAL_LAG_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_FRICTIONAL_LAG_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_FRICTIONAL_LAG_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_FRICTIONAL_LAG_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_FRICTIONAL_LAG_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_FRICTIONAL_LAG_STRIBECK_EXPONENT = 509292062,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_VISCOUS_COEFFICIENT = 97539077,
  /** fixed [s]: Time by which the level of friction lags behind the velocity (default chosen). (>= 0, default 0.005) */
  STRIBECK_FRICTIONAL_LAG_TIME_LAG = 1742363935,
  /** fixed [stribeck_frictional_lag_variant]: Variant of the law. (default Delay) */
  STRIBECK_FRICTIONAL_LAG_VARIANT = 1125473670,
  /** state [Boolean]: Does the contact have a past? Without one the level follows the present velocity.
   *  (default false) */
  STRIBECK_FRICTIONAL_LAG_HAS_PAST = 700495112,
  /** state [m/s]: Velocity that determines the friction level: delayed by the time lag, or filtered. (default 0) */
  STRIBECK_FRICTIONAL_LAG_LAGGED_VELOCITY = 1776968477,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_1_DURATION = 1903629728,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_1_BEGIN = 1546713253,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_1_END = 2140881061,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_2_DURATION = 469569313,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_2_BEGIN = 55254778,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_2_END = 428510326,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_3_DURATION = 1134056486,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_3_BEGIN = 1221082799,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_3_END = 668947559,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_4_DURATION = 1361660871,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_4_BEGIN = 88281716,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_4_END = 1963875104,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_5_DURATION = 250257788,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_5_BEGIN = 334762345,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_5_END = 1588008969,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_6_DURATION = 305655373,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_6_BEGIN = 1718004158,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_6_END = 1774551274,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_7_DURATION = 124128482,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_7_BEGIN = 1805583187,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_7_END = 33966187,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_8_DURATION = 751072787,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_8_BEGIN = 158135512,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_8_END = 2099449428,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_9_DURATION = 84691256,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_9_BEGIN = 234988605,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_9_END = 486379341,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_10_DURATION = 1813815230,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_10_BEGIN = 2081838791,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_10_END = 292375727,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_11_DURATION = 1108312441,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_11_BEGIN = 1911951762,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_11_END = 1891739326,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_12_DURATION = 1074895288,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_12_BEGIN = 1162790333,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_12_END = 890139853,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_13_DURATION = 1741276819,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_13_BEGIN = 1085937240,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_13_END = 355726292,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_14_DURATION = 1405428570,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_14_BEGIN = 1464577739,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_14_END = 598958995,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_15_DURATION = 226786053,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_15_BEGIN = 773380822,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_15_END = 1326718514,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_16_DURATION = 984266900,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_16_BEGIN = 1705384449,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_16_END = 908977201,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_17_DURATION = 2129698463,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_17_BEGIN = 1587347564,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_17_END = 1421014696,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_18_DURATION = 2124260518,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_18_BEGIN = 1400879,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_18_END = 1072708071,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_19_DURATION = 1459773345,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_19_BEGIN = 983056506,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_19_END = 832270838,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_20_DURATION = 485450269,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_20_BEGIN = 2131686798,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_20_END = 318005242,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_21_DURATION = 1881138418,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_21_BEGIN = 1440930659,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_21_END = 708651899,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_22_DURATION = 1204369495,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_22_BEGIN = 433510148,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_22_END = 1942478960,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_23_DURATION = 45819404,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_23_BEGIN = 290722745,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_23_END = 30095513,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_24_DURATION = 1556167921,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_24_BEGIN = 1918121418,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_24_END = 257593990,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_25_DURATION = 2139922806,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_25_BEGIN = 2119194815,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_25_END = 1768753463,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_26_DURATION = 2004116523,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_26_BEGIN = 1797614256,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_26_END = 1318965244,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_27_DURATION = 473168816,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_27_BEGIN = 246156021,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_27_END = 1374480373,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_28_DURATION = 665857621,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_28_BEGIN = 1399561318,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_28_END = 1787999106,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_29_DURATION = 1476266794,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_29_BEGIN = 1803462107,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_29_END = 2080922915,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_30_DURATION = 1057682560,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_30_BEGIN = 1667240197,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_30_END = 103748869,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_31_DURATION = 258686459,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_31_BEGIN = 1191843840,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_31_END = 144957516,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_32_DURATION = 708622086,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_32_BEGIN = 1461423887,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_32_END = 88459719,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_33_DURATION = 497211009,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_33_BEGIN = 238634970,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_33_END = 167696470,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_34_DURATION = 1416708188,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_34_BEGIN = 1658678473,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_34_END = 541383785,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_35_DURATION = 1789469735,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_35_BEGIN = 1708897620,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_35_END = 1288415232,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_36_DURATION = 1029393218,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_36_BEGIN = 229439283,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_36_END = 888655435,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_37_DURATION = 435289645,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_37_BEGIN = 1963527198,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_37_END = 161979722,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_38_DURATION = 813115800,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_38_BEGIN = 1911813661,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_38_END = 1723949357,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_39_DURATION = 476287347,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_39_BEGIN = 341515704,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_39_END = 1797162036,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_40_DURATION = 591842087,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_40_BEGIN = 1338329684,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_40_END = 1277424896,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_41_DURATION = 219080540,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_41_BEGIN = 1288110537,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_41_END = 530393449,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_42_DURATION = 1385145645,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_42_BEGIN = 1592959262,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_42_END = 150989386,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_43_DURATION = 1979249218,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_43_BEGIN = 2006354995,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_43_END = 877665099,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_44_DURATION = 1208542459,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_44_BEGIN = 821275904,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_44_END = 133967180,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_45_DURATION = 2007538560,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_45_BEGIN = 1296672261,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_45_END = 92758533,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_46_DURATION = 1447067009,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_46_BEGIN = 2015550682,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_46_END = 156706134,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_47_DURATION = 1658478086,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_47_BEGIN = 1090855951,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_47_END = 77469383,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_48_DURATION = 1836103935,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_48_BEGIN = 534397772,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_48_END = 1541175944,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_49_DURATION = 46201844,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_49_BEGIN = 564142817,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_49_END = 1636764689,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_50_DURATION = 1242637906,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_50_BEGIN = 1041916483,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_50_END = 1436336219,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_51_DURATION = 1881792381,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_51_BEGIN = 1737751406,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_51_END = 13709018,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_52_DURATION = 2059599212,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_52_BEGIN = 2002797465,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_52_END = 1831706233,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_53_DURATION = 1919553079,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_53_BEGIN = 811965540,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_53_END = 617814480,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_54_DURATION = 1371112022,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_54_BEGIN = 308693023,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_54_END = 485665687,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_55_DURATION = 139387217,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_55_BEGIN = 469934250,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_55_END = 284790374,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_56_DURATION = 836311056,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_56_BEGIN = 1999807445,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_56_END = 1028607445,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_57_DURATION = 1991513355,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_57_BEGIN = 682624784,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_57_END = 643503708,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_58_DURATION = 1478903306,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_58_BEGIN = 688472635,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_58_END = 1363884675,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_59_DURATION = 653151285,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_59_BEGIN = 284571846,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_59_END = 1112537570,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_60_DURATION = 1103609825,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_60_BEGIN = 400702650,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_60_END = 223203638,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_61_DURATION = 643151590,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_61_BEGIN = 1842827119,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_61_END = 505217575,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_62_DURATION = 234852315,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_62_BEGIN = 872493152,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_62_END = 561818540,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_63_DURATION = 830788960,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_63_BEGIN = 2085141349,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_63_END = 1511116901,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_64_DURATION = 783637773,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_64_BEGIN = 206940798,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_FRICTIONAL_LAG_HISTORY_64_END = 910333354,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_FRICTIONAL_LAG_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_FRICTIONAL_LAG_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_FRICTIONAL_LAG_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_FRICTIONAL_LAG_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_FRICTIONAL_LAG_STICKING = 553311409,
} stribeck_frictional_lag_variable;

/** Guid of Armstrong for fmi2Instantiate. */
#define STRIBECK_ARMSTRONG_GUID "{a29e2957-ad40-4d5f-46a2-c9bcfb8fd23c}"

/** Preset of Armstrong: Example of a contact that has rested so long that its static friction has fully risen. */
#define STRIBECK_ARMSTRONG_PRESET_LONG_REST "long_rest"

/** Preset of Armstrong: Example of a lubricated servo axis, within the ranges of Armstrong-Helouvry et al. (1994). */
#define STRIBECK_ARMSTRONG_PRESET_LUBRICATED_SERVO "lubricated_servo"

/** Armstrong: Stick, slip, lag and rising static friction with seven parameters (Armstrong-Helouvry). Variables of "Armstrong". */
typedef enum stribeck_armstrong_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ARMSTRONG_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ARMSTRONG_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ARMSTRONG_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_ARMSTRONG_MU_S = 1147235793,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_ARMSTRONG_SIGMA_0 = 206242323,
  /** tunable [m/s]: Speed at which half of the excess of static over kinetic friction is left. (> 0, default 0.001) */
  STRIBECK_ARMSTRONG_STRIBECK_VELOCITY = 2117263402,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_VISCOUS_COEFFICIENT = 97539077,
  /** fixed [s]: Time by which the level of friction lags behind the velocity (default chosen). (>= 0, default 0.005) */
  STRIBECK_ARMSTRONG_TIME_LAG = 1742363935,
  /** tunable [s]: Dwell time after which half of the rise of the static friction has occurred (default chosen).
   *  (>= 0, default 2) */
  STRIBECK_ARMSTRONG_GAMMA = 1344869386,
  /** state [Boolean]: Has the contact broken away? (default false) */
  STRIBECK_ARMSTRONG_SLIPPING = 1815582239,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_ARMSTRONG_BRISTLE_DEFLECTION = 767148150,
  /** state [s]: Time since the contact got stuck; 0 while it slips. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_DWELL_TIME = 640253981,
  /** state [1]: Stribeck magnitude per normal force: that at the end of the last slip while stuck, that of the breakaway while slipping.
   *  (>= 0, default 0) */
  STRIBECK_ARMSTRONG_STRIBECK_COEFFICIENT = 958423482,
  /** state [m/s]: Velocity that determines the friction level: delayed by the time lag, or filtered. (default 0) */
  STRIBECK_ARMSTRONG_LAGGED_VELOCITY = 1776968477,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_1_DURATION = 1903629728,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_1_BEGIN = 1546713253,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_1_END = 2140881061,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_2_DURATION = 469569313,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_2_BEGIN = 55254778,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_2_END = 428510326,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_3_DURATION = 1134056486,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_3_BEGIN = 1221082799,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_3_END = 668947559,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_4_DURATION = 1361660871,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_4_BEGIN = 88281716,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_4_END = 1963875104,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_5_DURATION = 250257788,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_5_BEGIN = 334762345,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_5_END = 1588008969,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_6_DURATION = 305655373,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_6_BEGIN = 1718004158,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_6_END = 1774551274,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_7_DURATION = 124128482,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_7_BEGIN = 1805583187,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_7_END = 33966187,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_8_DURATION = 751072787,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_8_BEGIN = 158135512,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_8_END = 2099449428,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_9_DURATION = 84691256,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_9_BEGIN = 234988605,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_9_END = 486379341,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_10_DURATION = 1813815230,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_10_BEGIN = 2081838791,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_10_END = 292375727,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_11_DURATION = 1108312441,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_11_BEGIN = 1911951762,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_11_END = 1891739326,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_12_DURATION = 1074895288,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_12_BEGIN = 1162790333,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_12_END = 890139853,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_13_DURATION = 1741276819,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_13_BEGIN = 1085937240,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_13_END = 355726292,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_14_DURATION = 1405428570,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_14_BEGIN = 1464577739,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_14_END = 598958995,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_15_DURATION = 226786053,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_15_BEGIN = 773380822,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_15_END = 1326718514,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_16_DURATION = 984266900,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_16_BEGIN = 1705384449,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_16_END = 908977201,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_17_DURATION = 2129698463,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_17_BEGIN = 1587347564,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_17_END = 1421014696,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_18_DURATION = 2124260518,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_18_BEGIN = 1400879,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_18_END = 1072708071,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_19_DURATION = 1459773345,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_19_BEGIN = 983056506,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_19_END = 832270838,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_20_DURATION = 485450269,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_20_BEGIN = 2131686798,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_20_END = 318005242,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_21_DURATION = 1881138418,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_21_BEGIN = 1440930659,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_21_END = 708651899,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_22_DURATION = 1204369495,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_22_BEGIN = 433510148,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_22_END = 1942478960,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_23_DURATION = 45819404,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_23_BEGIN = 290722745,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_23_END = 30095513,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_24_DURATION = 1556167921,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_24_BEGIN = 1918121418,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_24_END = 257593990,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_25_DURATION = 2139922806,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_25_BEGIN = 2119194815,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_25_END = 1768753463,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_26_DURATION = 2004116523,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_26_BEGIN = 1797614256,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_26_END = 1318965244,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_27_DURATION = 473168816,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_27_BEGIN = 246156021,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_27_END = 1374480373,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_28_DURATION = 665857621,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_28_BEGIN = 1399561318,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_28_END = 1787999106,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_29_DURATION = 1476266794,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_29_BEGIN = 1803462107,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_29_END = 2080922915,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_30_DURATION = 1057682560,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_30_BEGIN = 1667240197,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_30_END = 103748869,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_31_DURATION = 258686459,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_31_BEGIN = 1191843840,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_31_END = 144957516,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_32_DURATION = 708622086,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_32_BEGIN = 1461423887,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_32_END = 88459719,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_33_DURATION = 497211009,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_33_BEGIN = 238634970,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_33_END = 167696470,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_34_DURATION = 1416708188,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_34_BEGIN = 1658678473,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_34_END = 541383785,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_35_DURATION = 1789469735,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_35_BEGIN = 1708897620,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_35_END = 1288415232,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_36_DURATION = 1029393218,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_36_BEGIN = 229439283,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_36_END = 888655435,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_37_DURATION = 435289645,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_37_BEGIN = 1963527198,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_37_END = 161979722,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_38_DURATION = 813115800,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_38_BEGIN = 1911813661,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_38_END = 1723949357,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_39_DURATION = 476287347,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_39_BEGIN = 341515704,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_39_END = 1797162036,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_40_DURATION = 591842087,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_40_BEGIN = 1338329684,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_40_END = 1277424896,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_41_DURATION = 219080540,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_41_BEGIN = 1288110537,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_41_END = 530393449,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_42_DURATION = 1385145645,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_42_BEGIN = 1592959262,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_42_END = 150989386,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_43_DURATION = 1979249218,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_43_BEGIN = 2006354995,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_43_END = 877665099,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_44_DURATION = 1208542459,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_44_BEGIN = 821275904,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_44_END = 133967180,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_45_DURATION = 2007538560,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_45_BEGIN = 1296672261,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_45_END = 92758533,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_46_DURATION = 1447067009,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_46_BEGIN = 2015550682,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_46_END = 156706134,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_47_DURATION = 1658478086,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_47_BEGIN = 1090855951,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_47_END = 77469383,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_48_DURATION = 1836103935,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_48_BEGIN = 534397772,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_48_END = 1541175944,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_49_DURATION = 46201844,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_49_BEGIN = 564142817,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_49_END = 1636764689,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_50_DURATION = 1242637906,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_50_BEGIN = 1041916483,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_50_END = 1436336219,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_51_DURATION = 1881792381,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_51_BEGIN = 1737751406,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_51_END = 13709018,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_52_DURATION = 2059599212,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_52_BEGIN = 2002797465,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_52_END = 1831706233,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_53_DURATION = 1919553079,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_53_BEGIN = 811965540,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_53_END = 617814480,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_54_DURATION = 1371112022,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_54_BEGIN = 308693023,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_54_END = 485665687,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_55_DURATION = 139387217,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_55_BEGIN = 469934250,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_55_END = 284790374,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_56_DURATION = 836311056,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_56_BEGIN = 1999807445,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_56_END = 1028607445,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_57_DURATION = 1991513355,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_57_BEGIN = 682624784,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_57_END = 643503708,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_58_DURATION = 1478903306,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_58_BEGIN = 688472635,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_58_END = 1363884675,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_59_DURATION = 653151285,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_59_BEGIN = 284571846,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_59_END = 1112537570,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_60_DURATION = 1103609825,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_60_BEGIN = 400702650,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_60_END = 223203638,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_61_DURATION = 643151590,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_61_BEGIN = 1842827119,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_61_END = 505217575,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_62_DURATION = 234852315,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_62_BEGIN = 872493152,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_62_END = 561818540,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_63_DURATION = 830788960,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_63_BEGIN = 2085141349,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_63_END = 1511116901,
  /** state [s]: Duration of this piece of the past; 0 = not used. (>= 0, default 0) */
  STRIBECK_ARMSTRONG_HISTORY_64_DURATION = 783637773,
  /** state [m/s]: Velocity at the beginning of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_64_BEGIN = 206940798,
  /** state [m/s]: Velocity at the end of this piece of the past. (default 0) */
  STRIBECK_ARMSTRONG_HISTORY_64_END = 910333354,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_ARMSTRONG_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ARMSTRONG_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ARMSTRONG_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ARMSTRONG_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ARMSTRONG_STICKING = 553311409,
} stribeck_armstrong_variable;

/** Guid of NonReversible for fmi2Instantiate. */
#define STRIBECK_NON_REVERSIBLE_GUID "{5df8191d-b30c-9205-12e9-bdb0632eee7a}"

/** Preset of NonReversible: Example: the variant in the literature whose lower curve is the mirror image, f_l0 = 2 f_C - f_s. */
#define STRIBECK_NON_REVERSIBLE_PRESET_MIRRORED "mirrored"

/** Preset of NonReversible: Example: both curves equal, that is, the curve of Tustin with a Stribeck velocity of 2 mm/s. */
#define STRIBECK_NON_REVERSIBLE_PRESET_REVERSIBLE "reversible"

/** NonReversible: Different friction while speeding up and slowing down (reconstructed). Variables of "NonReversible". */
typedef enum stribeck_non_reversible_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_NON_REVERSIBLE_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_NON_REVERSIBLE_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_NON_REVERSIBLE_EXTERNAL_FORCE = 1336490458,
  /** in [m/s2]: Acceleration of body 1 relative to body 2; used if the velocity has no slope. (default 0) */
  STRIBECK_NON_REVERSIBLE_ACCELERATION = 799062685,
  /** state [m/s2]: Slope of the velocity over the last step; 0 if it was held. (default 0) */
  STRIBECK_NON_REVERSIBLE_VELOCITY_SLOPE = 90397206,
  /** fixed [stribeck_acceleration_source]: How the law knows whether the contact speeds up or slows down.
   *  (default Input) */
  STRIBECK_NON_REVERSIBLE_ACCELERATION_SOURCE = 2091868843,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_NON_REVERSIBLE_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_NON_REVERSIBLE_MU_S = 1147235793,
  /** tunable [1]: Coefficient of friction that a contact reaches when it comes to rest; not more than mu_s (default chosen).
   *  (>= 0, default 0) */
  STRIBECK_NON_REVERSIBLE_MU_STOP = 916254464,
  /** tunable [s/m]: Steepness of the curve while speeding up (default chosen). (> 0, default 500) */
  STRIBECK_NON_REVERSIBLE_ACCELERATION_DECAY = 840199020,
  /** tunable [s/m]: Steepness of the curve while slowing down (default chosen). (> 0, default 500) */
  STRIBECK_NON_REVERSIBLE_DECELERATION_DECAY = 1686569403,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_NON_REVERSIBLE_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_NON_REVERSIBLE_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_NON_REVERSIBLE_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_NON_REVERSIBLE_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_NON_REVERSIBLE_STICKING = 553311409,
} stribeck_non_reversible_variable;

/** Guid of Wojewoda for fmi2Instantiate. */
#define STRIBECK_WOJEWODA_GUID "{1d385c77-68e3-75f4-c15b-446876e516e9}"

/** Preset of Wojewoda: Example of a soft pad with a wide hysteresis. */
#define STRIBECK_WOJEWODA_PRESET_RUBBER_PAD "rubber_pad"

/** Wojewoda: Hysteretic friction: stuck spring, two branches of sliding (reconstructed after Wojewoda). Variables of "Wojewoda". */
typedef enum stribeck_wojewoda_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_WOJEWODA_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_WOJEWODA_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_WOJEWODA_EXTERNAL_FORCE = 1336490458,
  /** in [m/s2]: Acceleration of body 1 relative to body 2; used if the velocity has no slope. (default 0) */
  STRIBECK_WOJEWODA_ACCELERATION = 799062685,
  /** state [m/s2]: Slope of the velocity over the last step; 0 if it was held. (default 0) */
  STRIBECK_WOJEWODA_VELOCITY_SLOPE = 90397206,
  /** fixed [stribeck_acceleration_source]: How the law knows whether the contact speeds up or slows down.
   *  (default Input) */
  STRIBECK_WOJEWODA_ACCELERATION_SOURCE = 2091868843,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_WOJEWODA_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_WOJEWODA_MU_S = 1147235793,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_WOJEWODA_SIGMA_0 = 206242323,
  /** tunable [s/m]: Steepness of the curves for speeding up and slowing down (default chosen). (> 0, default 500) */
  STRIBECK_WOJEWODA_BRANCH_DECAY = 183287636,
  /** state [Boolean]: Has the contact broken away? (default false) */
  STRIBECK_WOJEWODA_SLIPPING = 1815582239,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_WOJEWODA_BRISTLE_DEFLECTION = 767148150,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_WOJEWODA_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_WOJEWODA_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_WOJEWODA_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_WOJEWODA_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_WOJEWODA_STICKING = 553311409,
} stribeck_wojewoda_variable;

/** Guid of BlimanSorine for fmi2Instantiate. */
#define STRIBECK_BLIMAN_SORINE_GUID "{a4b1ca64-2232-a844-5ba0-2d47690d27a9}"

/** Preset of BlimanSorine: Novais (2024), (7.14), Tables 6.1 and 7.1: first order; eps_f = f_C / sigma_0 is derived. */
#define STRIBECK_BLIMAN_SORINE_PRESET_THESIS "thesis"

/** Preset of BlimanSorine: Example: second order with eta = 0.1, the same peak of 1.4715 N and stiffness of 1e5 N/m. */
#define STRIBECK_BLIMAN_SORINE_PRESET_SHARP_PEAK "sharp_peak"

/** BlimanSorine: Pre-sliding displacement and breakaway peak in the sliding distance (Bliman-Sorine). Variables of "BlimanSorine". */
typedef enum stribeck_bliman_sorine_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BLIMAN_SORINE_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BLIMAN_SORINE_NORMAL_FORCE = 5891938,
  /** fixed [stribeck_bliman_sorine_order]: Variant of the law. (default Second) */
  STRIBECK_BLIMAN_SORINE_VARIANT = 1125473670,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BLIMAN_SORINE_MU_K = 1281456745,
  /** tunable [1]: Level of the slow relaxation, as a coefficient of friction; second order (default calibrated).
   *  (>= 0, default 0.2732050807568877) */
  STRIBECK_BLIMAN_SORINE_MU_2 = 56742142,
  /** tunable [1]: Length of the fast relaxation as a part of that of the slow one; second order (default chosen).
   *  (> 0, <= 1, default 0.5) */
  STRIBECK_BLIMAN_SORINE_ETA = 194781479,
  /** tunable [m]: Sliding distance in which the slow relaxation settles to 1/e (default calibrated).
   *  (> 0, default 4.642141842225068e-5) */
  STRIBECK_BLIMAN_SORINE_EPS_F = 140585692,
  /** state [1]: Fast relaxation, in units of its level. (default 0) */
  STRIBECK_BLIMAN_SORINE_Y_1 = 215971072,
  /** state [1]: Slow relaxation, in units of its level; second order. (default 0) */
  STRIBECK_BLIMAN_SORINE_Y_2 = 266303929,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BLIMAN_SORINE_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BLIMAN_SORINE_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BLIMAN_SORINE_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BLIMAN_SORINE_STICKING = 553311409,
} stribeck_bliman_sorine_variable;

/** Guid of ResetIntegrator for fmi2Instantiate. */
#define STRIBECK_RESET_INTEGRATOR_GUID "{09a8195a-7b0a-6310-88bf-e980c6d7000b}"

/** Preset of ResetIntegrator: Novais (2024), Tables 6.1 and 7.1 with a = f_s / f_C - 1 = 0.5: the start values. */
#define STRIBECK_RESET_INTEGRATOR_PRESET_THESIS "thesis"

/** Preset of ResetIntegrator: Novais (2024), Table 7.1 as printed: a = 0.52, so that breakaway is at 1.49112 N. */
#define STRIBECK_RESET_INTEGRATOR_PRESET_THESIS_PRINTED "thesis_printed"

/** Preset of ResetIntegrator: Example: sigma_1 = 1.414 sqrt((1 + a) sigma_0 m) damps a stuck mass of 1 kg by 0.707. */
#define STRIBECK_RESET_INTEGRATOR_PRESET_DAMPED_BOND "damped_bond"

/** ResetIntegrator: Bond that breaks at the static level (reset integrator). Variables of "ResetIntegrator". */
typedef enum stribeck_reset_integrator_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_RESET_INTEGRATOR_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_RESET_INTEGRATOR_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_RESET_INTEGRATOR_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_RESET_INTEGRATOR_MU_S = 1147235793,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_RESET_INTEGRATOR_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_RESET_INTEGRATOR_SIGMA_1 = 189464704,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_RESET_INTEGRATOR_BRISTLE_DEFLECTION = 767148150,
  /** state [1]: Direction in which the contact has broken away; 0 = bonded. (>= -1, <= 1, default 0) */
  STRIBECK_RESET_INTEGRATOR_SLIP_DIRECTION = 1771013485,
  /** state [stribeck_phase]: Bond as found by the last event of Model Exchange: held, or broken in a direction.
   *  (default Free) */
  STRIBECK_RESET_INTEGRATOR_BOND = 1519443964,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_RESET_INTEGRATOR_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_RESET_INTEGRATOR_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_RESET_INTEGRATOR_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_RESET_INTEGRATOR_STICKING = 553311409,
} stribeck_reset_integrator_variable;

/** Guid of Dankowicz for fmi2Instantiate. */
#define STRIBECK_DANKOWICZ_GUID "{28f989d4-5f89-d379-8a3d-488097594365}"

/** Preset of Dankowicz: Novais (2024), Tables 6.1 and 7.1; delta_t = f_C / sigma_0 is derived (the start values). */
#define STRIBECK_DANKOWICZ_PRESET_THESIS "thesis"

/** Dankowicz: Pre-sliding displacement of sheared asperities (Dankowicz, reconstructed). Variables of "Dankowicz". */
typedef enum stribeck_dankowicz_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_DANKOWICZ_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_DANKOWICZ_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_DANKOWICZ_MU_K = 1281456745,
  /** tunable [m]: Shear deflection of the asperities in steady sliding (default f_C / sigma_0 of the thesis).
   *  (> 0, default 9.81e-6) */
  STRIBECK_DANKOWICZ_DELTA_T = 434886250,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_DANKOWICZ_BRISTLE_DEFLECTION = 767148150,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_DANKOWICZ_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_DANKOWICZ_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_DANKOWICZ_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_DANKOWICZ_STICKING = 553311409,
} stribeck_dankowicz_variable;

/** Guid of ElastoPlastic for fmi2Instantiate. */
#define STRIBECK_ELASTO_PLASTIC_GUID "{333ed675-96b8-6542-43ed-0bb0a226d423}"

/** Preset of ElastoPlastic: Novais (2024), Tables 6.1 and 7.1, and kappa = 0.7 from its text (the start values). */
#define STRIBECK_ELASTO_PLASTIC_PRESET_THESIS "thesis"

/** Preset of ElastoPlastic: Example: the thesis's values with a bristle damping that fades at 1 mm/s, for sampled velocities. */
#define STRIBECK_ELASTO_PLASTIC_PRESET_SAMPLED "sampled"

/** ElastoPlastic: Bristle friction without drift below breakaway (elasto-plastic). Variables of "ElastoPlastic". */
typedef enum stribeck_elasto_plastic_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ELASTO_PLASTIC_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ELASTO_PLASTIC_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ELASTO_PLASTIC_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_ELASTO_PLASTIC_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_ELASTO_PLASTIC_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_ELASTO_PLASTIC_STRIBECK_EXPONENT = 509292062,
  /** tunable [1]: Part of the deflection of steady sliding up to which the contact is purely elastic.
   *  (> 0, <= 1, default 0.7) */
  STRIBECK_ELASTO_PLASTIC_BREAKAWAY_RATIO = 1487030850,
  /** tunable [Integer]: Exponent of the transition from elastic deflection to sliding; odd. (>= 1, <= 9, default 1) */
  STRIBECK_ELASTO_PLASTIC_PLASTIC_EXPONENT = 447717963,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_ELASTO_PLASTIC_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_ELASTO_PLASTIC_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_ELASTO_PLASTIC_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_ELASTO_PLASTIC_DAMPING_VELOCITY = 626846797,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_ELASTO_PLASTIC_BRISTLE_DEFLECTION = 767148150,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ELASTO_PLASTIC_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ELASTO_PLASTIC_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ELASTO_PLASTIC_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ELASTO_PLASTIC_STICKING = 553311409,
} stribeck_elasto_plastic_variable;

/** Guid of Bristle for fmi2Instantiate. */
#define STRIBECK_BRISTLE_GUID "{aca1929e-345e-f19d-f265-d4d06626ce0b}"

/** Preset of Bristle: Novais (2024), Tables 6.1 and 7.1 for levels and stiffness; 25 bristles chosen (the start values). */
#define STRIBECK_BRISTLE_PRESET_THESIS "thesis"

/** Preset of Bristle: Example: the start values without the first peak, in which all bristles snap together. */
#define STRIBECK_BRISTLE_PRESET_HAESSIG_FRIEDLAND_STATIONARY "haessig_friedland_stationary"

/** Bristle: Bonds that snap and form again at random (bristle model). Variables of "Bristle". */
typedef enum stribeck_bristle_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BRISTLE_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BRISTLE_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BRISTLE_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_BRISTLE_MU_S = 1147235793,
  /** tunable [m]: Strain at which a bristle snaps (default f_s / sigma_0 of the thesis). (> 0, default 1.4715e-5) */
  STRIBECK_BRISTLE_DELTA = 1795259425,
  /** fixed [Integer]: Number of bristles (default chosen). (>= 1, <= 64, default 25) */
  STRIBECK_BRISTLE_BRISTLE_COUNT = 2048496580,
  /** fixed [Integer]: Seed of the random numbers. (>= 0, default 0) */
  STRIBECK_BRISTLE_SEED = 1346747564,
  /** fixed [stribeck_initial_bonds]: State of the bristles when the motion starts. (default Bonded) */
  STRIBECK_BRISTLE_INITIAL_BONDS = 550744762,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_1_STRAIN = 622566322,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_1_DRAWS = 1926637046,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_2_STRAIN = 802444927,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_2_DRAWS = 814704753,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_3_STRAIN = 1307367312,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_3_DRAWS = 1114305728,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_4_STRAIN = 1060117685,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_4_DRAWS = 675813507,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_5_STRAIN = 1379308734,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_5_DRAWS = 770910154,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_6_STRAIN = 1896585051,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_6_DRAWS = 1413752181,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_7_STRAIN = 394681180,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_7_DRAWS = 444147268,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_8_STRAIN = 1426978929,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_8_DRAWS = 289098103,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_9_STRAIN = 1938705818,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_9_DRAWS = 564797742,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_10_STRAIN = 824176402,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_10_DRAWS = 660947670,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_11_STRAIN = 1015062569,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_11_DRAWS = 945990367,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_12_STRAIN = 650588528,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_12_DRAWS = 71759904,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_13_STRAIN = 1750090463,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_13_DRAWS = 954168401,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_14_STRAIN = 1554666654,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_14_DRAWS = 1907930666,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_15_STRAIN = 355513749,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_15_DRAWS = 1107001315,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_16_STRAIN = 1069748156,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_16_DRAWS = 1679808548,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_17_STRAIN = 2071942971,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_17_DRAWS = 444865749,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_18_STRAIN = 1514206330,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_18_DRAWS = 1738316174,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_19_STRAIN = 1602233681,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_19_DRAWS = 1149822167,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_20_STRAIN = 763127057,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_20_DRAWS = 1073161623,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_21_STRAIN = 1053299258,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_21_DRAWS = 2002693710,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_22_STRAIN = 1552356487,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_22_DRAWS = 434357929,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_23_STRAIN = 619956024,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_23_DRAWS = 1154008568,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_24_STRAIN = 538687965,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_24_DRAWS = 820908059,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_25_STRAIN = 746808614,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_25_DRAWS = 1899972482,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_26_STRAIN = 1896280931,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_26_DRAWS = 2113895437,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_27_STRAIN = 1935089380,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_27_DRAWS = 1314575772,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_28_STRAIN = 1576590569,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_28_DRAWS = 786013599,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_29_STRAIN = 1348542930,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_29_DRAWS = 625863830,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_30_STRAIN = 1510145948,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_30_DRAWS = 193056388,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_31_STRAIN = 1778844827,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_31_DRAWS = 347838901,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_32_STRAIN = 1406723582,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_32_DRAWS = 1879484426,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_33_STRAIN = 111415029,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_33_DRAWS = 424619459,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_34_STRAIN = 167354832,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_34_DRAWS = 472849920,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_35_STRAIN = 595199679,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_35_DRAWS = 1646982577,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_36_STRAIN = 463753458,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_36_DRAWS = 1410074166,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_37_STRAIN = 680387721,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_37_DRAWS = 1591397311,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_38_STRAIN = 1855698692,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_38_DRAWS = 2093707324,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_39_STRAIN = 328317827,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_39_DRAWS = 745543341,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_40_STRAIN = 1636591683,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_40_DRAWS = 2115612525,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_41_STRAIN = 311319748,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_41_DRAWS = 1975204092,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_42_STRAIN = 561248957,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_42_DRAWS = 786127227,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_43_STRAIN = 1887960326,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_43_DRAWS = 413220322,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_44_STRAIN = 561349095,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_44_DRAWS = 793974409,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_45_STRAIN = 953431320,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_45_DRAWS = 1104492120,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_46_STRAIN = 998064753,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_46_DRAWS = 1044715383,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_47_STRAIN = 1509791642,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_47_DRAWS = 1320415022,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_48_STRAIN = 1467670875,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_48_DRAWS = 21885813,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_49_STRAIN = 2113250652,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_49_DRAWS = 1199764548,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_50_STRAIN = 1834249526,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_50_DRAWS = 1620245874,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_51_STRAIN = 1681381933,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_51_DRAWS = 1052071947,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_52_STRAIN = 1657414772,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_52_DRAWS = 107447052,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_53_STRAIN = 1642128499,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_53_DRAWS = 384283325,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_54_STRAIN = 1504882698,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_54_DRAWS = 430710974,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_55_STRAIN = 1840767201,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_55_DRAWS = 1834618439,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_56_STRAIN = 1763294984,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_56_DRAWS = 164137192,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_57_STRAIN = 1702798103,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_57_DRAWS = 1185568985,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_58_STRAIN = 1102019694,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_58_DRAWS = 1879836442,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_59_STRAIN = 244052965,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_59_DRAWS = 462181139,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_60_STRAIN = 1518020245,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_60_DRAWS = 1477569251,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_61_STRAIN = 569689502,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_61_DRAWS = 131014954,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_62_STRAIN = 1086965819,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_62_DRAWS = 815433685,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_63_STRAIN = 84771004,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_63_DRAWS = 2050376484,
  /** state [m]: Strain of the bristle, x - b_i. (default 0) */
  STRIBECK_BRISTLE_BRISTLE_64_STRAIN = 30085417,
  /** state [1]: Random numbers that the bristle has used. (>= 0, default 0) */
  STRIBECK_BRISTLE_BRISTLE_64_DRAWS = 1316558303,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BRISTLE_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BRISTLE_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BRISTLE_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BRISTLE_STICKING = 553311409,
} stribeck_bristle_variable;

/** Guid of SpeckerDynamic for fmi2Instantiate. */
#define STRIBECK_SPECKER_DYNAMIC_GUID "{86b330c2-8260-a4e9-0f47-98493ba7f49a}"

/** Preset of SpeckerDynamic: Guidance (6.28) of Novais (2024) for v_S = 1 mm/s, which is chosen, as is T_slip (the start values). */
#define STRIBECK_SPECKER_DYNAMIC_PRESET_GUIDANCE "guidance"

/** SpeckerDynamic: Smooth friction law with a velocity-dependent lag (Specker, reconstructed). Variables of "SpeckerDynamic". */
typedef enum stribeck_specker_dynamic_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_SPECKER_DYNAMIC_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_SPECKER_DYNAMIC_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_SPECKER_DYNAMIC_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_SPECKER_DYNAMIC_MU_S = 1147235793,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_SPECKER_DYNAMIC_TRANSITION_VELOCITY = 1009615136,
  /** tunable [m/s]: Velocity at which the static level is reached (default chosen). (> 0, default 0.0005) */
  STRIBECK_SPECKER_DYNAMIC_PEAK_VELOCITY = 593654064,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SPECKER_DYNAMIC_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_SPECKER_DYNAMIC_SIGMA_0 = 206242323,
  /** tunable [s]: Time constant of the force while sliding (default chosen). (> 0, default 0.001) */
  STRIBECK_SPECKER_DYNAMIC_SLIP_TIME = 282526557,
  /** state [N]: Friction force behind the low-pass. (default 0) */
  STRIBECK_SPECKER_DYNAMIC_LAGGING_FORCE = 786728864,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_SPECKER_DYNAMIC_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_SPECKER_DYNAMIC_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_SPECKER_DYNAMIC_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_SPECKER_DYNAMIC_STICKING = 553311409,
} stribeck_specker_dynamic_variable;

/** Guid of MaxwellSlip for fmi2Instantiate. */
#define STRIBECK_MAXWELL_SLIP_GUID "{ade1de7a-7166-6110-e95c-16326bcd8c46}"

/** Preset of MaxwellSlip: Example: levels and stiffness of Novais (2024), Tables 6.1, 7.1; rest chosen (the start values). */
#define STRIBECK_MAXWELL_SLIP_PRESET_FOUR_ELEMENTS "four_elements"

/** Preset of MaxwellSlip: Example: damping and viscous coefficient of other bristle models in Novais (2024), Table 7.1. */
#define STRIBECK_MAXWELL_SLIP_PRESET_DAMPED "damped"

/** Preset of MaxwellSlip: Example of a smooth virgin curve: 1000 elements with evenly spaced slip displacements. */
#define STRIBECK_MAXWELL_SLIP_PRESET_SMOOTH "smooth"

/** MaxwellSlip: Elements that stick or slip, with hysteresis of pre-sliding (generalised Maxwell-slip, GMS). Variables of "MaxwellSlip". */
typedef enum stribeck_maxwell_slip_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_MAXWELL_SLIP_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_MAXWELL_SLIP_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_MAXWELL_SLIP_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_MAXWELL_SLIP_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_MAXWELL_SLIP_STRIBECK_EXPONENT = 509292062,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_MAXWELL_SLIP_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 0) */
  STRIBECK_MAXWELL_SLIP_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_MAXWELL_SLIP_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [N/s]: Rate at which the slipping elements together approach their level (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_MAXWELL_SLIP_ATTRACTION = 262854784,
  /** fixed [stribeck_element_distribution]: Where the shares of the elements come from. (default Explicit) */
  STRIBECK_MAXWELL_SLIP_DISTRIBUTION = 882397483,
  /** fixed [Integer]: Number of elements in use (default chosen). (>= 1, <= 1000, default 4) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_COUNT = 1814028119,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.5) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_1_STIFFNESS_SHARE = 1984559525,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_1_STRENGTH_SHARE = 1653101785,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_1_FORCE = 417008123,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_1_SLIPPING = 61645750,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.25) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_2_STIFFNESS_SHARE = 635638510,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.2) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_2_STRENGTH_SHARE = 1020390876,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_2_FORCE = 956601336,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_2_SLIPPING = 916397611,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.15) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_3_STIFFNESS_SHARE = 236442871,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.3) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_3_STRENGTH_SHARE = 1826059887,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_3_FORCE = 810068841,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_3_SLIPPING = 1045816540,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_4_STIFFNESS_SHARE = 507261856,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.4) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_4_STRENGTH_SHARE = 466493098,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_4_FORCE = 1956354086,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_4_SLIPPING = 567684305,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_5_STIFFNESS_SHARE = 978834793,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_5_STRENGTH_SHARE = 968197717,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_5_FORCE = 1495200879,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_5_SLIPPING = 1747360226,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_6_STIFFNESS_SHARE = 2004137970,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_6_STRENGTH_SHARE = 1481769336,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_6_FORCE = 1688949644,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_6_SLIPPING = 780131655,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_7_STIFFNESS_SHARE = 423657291,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_7_STRENGTH_SHARE = 363891723,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_7_FORCE = 1643862173,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_7_SLIPPING = 2136700712,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_8_STIFFNESS_SHARE = 1337862804,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_8_STRENGTH_SHARE = 866511878,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_8_FORCE = 475811146,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_8_SLIPPING = 1088859837,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_9_STIFFNESS_SHARE = 1333387469,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_9_STRENGTH_SHARE = 1790412305,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_9_FORCE = 427133779,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_9_SLIPPING = 790213006,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_10_STIFFNESS_SHARE = 930777631,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_10_STRENGTH_SHARE = 1307487559,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_10_FORCE = 309754689,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_10_SLIPPING = 1971059860,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_11_STIFFNESS_SHARE = 1582832214,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_11_STRENGTH_SHARE = 1197920180,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_11_FORCE = 1627200688,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_11_SLIPPING = 1236750147,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_12_STIFFNESS_SHARE = 242124973,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_12_STRENGTH_SHARE = 318599793,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_12_FORCE = 1622967027,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_12_SLIPPING = 423589806,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_13_STIFFNESS_SHARE = 488236916,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_13_STRENGTH_SHARE = 569303654,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_13_FORCE = 934999786,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_13_SLIPPING = 592280285,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_14_STIFFNESS_SHARE = 867993811,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_14_STRENGTH_SHARE = 464171203,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_14_FORCE = 1304020821,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_14_SLIPPING = 51371456,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_15_STIFFNESS_SHARE = 1030058266,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_15_STRENGTH_SHARE = 1045466960,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_15_FORCE = 2058652516,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_15_SLIPPING = 277263231,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_16_STIFFNESS_SHARE = 1516159377,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_16_STRENGTH_SHARE = 236029453,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_16_FORCE = 1408145063,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_16_SLIPPING = 1467883514,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_17_STIFFNESS_SHARE = 1526225256,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_17_STRENGTH_SHARE = 1201028194,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_17_FORCE = 303569406,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_17_SLIPPING = 1335271913,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_18_STIFFNESS_SHARE = 209375959,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_18_STRENGTH_SHARE = 596598607,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_18_FORCE = 2027178633,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_18_SLIPPING = 800456828,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_19_STIFFNESS_SHARE = 1120869198,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_19_STRENGTH_SHARE = 207821116,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_19_FORCE = 1048396568,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_19_SLIPPING = 722875339,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_20_STIFFNESS_SHARE = 946953330,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_20_STRENGTH_SHARE = 184261368,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_20_FORCE = 1384494092,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_20_SLIPPING = 1106485959,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_21_STIFFNESS_SHARE = 1513956299,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_21_STRENGTH_SHARE = 1213867403,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_21_FORCE = 1339406621,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_21_SLIPPING = 315571368,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_22_STIFFNESS_SHARE = 1597560864,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_22_STRENGTH_SHARE = 1316468778,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_22_FORCE = 1651898534,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_22_SLIPPING = 894038609,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_23_STIFFNESS_SHARE = 2069133801,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_23_STRENGTH_SHARE = 1818173397,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_23_FORCE = 1190745327,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_23_SLIPPING = 2073714530,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_24_STIFFNESS_SHARE = 1725937518,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_24_STRENGTH_SHARE = 1870366556,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_24_FORCE = 652145784,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_24_SLIPPING = 1242751915,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_25_STIFFNESS_SHARE = 1326741879,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_25_STRENGTH_SHARE = 528551919,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_25_FORCE = 505613289,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_25_SLIPPING = 1372170844,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_26_STIFFNESS_SHARE = 2058379500,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_26_STRENGTH_SHARE = 1023527406,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_26_FORCE = 904932594,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_26_SLIPPING = 1220548901,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_27_STIFFNESS_SHARE = 927374885,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_27_STRENGTH_SHARE = 355593817,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_27_FORCE = 112552571,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_27_SLIPPING = 388000054,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_28_STIFFNESS_SHARE = 1832821434,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_28_STRENGTH_SHARE = 798860656,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_28_FORCE = 1990520644,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_28_SLIPPING = 1763494623,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_29_STIFFNESS_SHARE = 1725129971,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_29_STRENGTH_SHARE = 13610851,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_29_FORCE = 1966599861,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_29_SLIPPING = 291006880,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_30_STIFFNESS_SHARE = 1598222037,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_30_STRENGTH_SHARE = 432647785,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_30_FORCE = 1876414123,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_30_SLIPPING = 458579142,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_31_STIFFNESS_SHARE = 1134555100,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_31_STRENGTH_SHARE = 245259646,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_31_FORCE = 673411298,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_31_SLIPPING = 695477365,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_32_STIFFNESS_SHARE = 772041447,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_32_STRENGTH_SHARE = 1257553087,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_32_FORCE = 585098457,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_32_SLIPPING = 1547016876,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_33_STIFFNESS_SHARE = 872053022,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_33_STRENGTH_SHARE = 992579756,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_33_FORCE = 1202670568,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_33_SLIPPING = 1215492283,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_34_STIFFNESS_SHARE = 665747033,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_34_STRENGTH_SHARE = 964650981,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_34_FORCE = 1613712607,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_34_SLIPPING = 1256503346,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_35_STIFFNESS_SHARE = 1703752592,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_35_STRENGTH_SHARE = 1012019194,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_35_FORCE = 114543126,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_35_SLIPPING = 691903969,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_36_STIFFNESS_SHARE = 1398614523,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_36_STRENGTH_SHARE = 1685909851,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_36_FORCE = 1016182349,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_36_SLIPPING = 694061816,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_37_STIFFNESS_SHARE = 903984738,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_37_STRENGTH_SHARE = 1625210248,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_37_FORCE = 18164220,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_37_SLIPPING = 102603351,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_38_STIFFNESS_SHARE = 1356982141,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_38_STRENGTH_SHARE = 849034273,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_38_FORCE = 1336195843,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_38_SLIPPING = 737377246,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_39_STIFFNESS_SHARE = 1715598724,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_39_STRENGTH_SHARE = 1964832726,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_39_FORCE = 1304001018,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_39_SLIPPING = 993257933,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_40_STIFFNESS_SHARE = 52686992,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_40_STRENGTH_SHARE = 1556782842,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_40_FORCE = 1891458838,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_40_SLIPPING = 1641759969,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_41_STIFFNESS_SHARE = 1162165081,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_41_STRENGTH_SHARE = 1509414629,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_41_FORCE = 1243144671,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_41_SLIPPING = 58875698,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_42_STIFFNESS_SHARE = 1400402786,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_42_STRENGTH_SHARE = 22490248,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_42_FORCE = 1795079932,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_42_SLIPPING = 1052459351,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_43_STIFFNESS_SHARE = 1895032571,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_43_STRENGTH_SHARE = 83189851,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_43_FORCE = 645614413,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_43_SLIPPING = 1643917816,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_44_STIFFNESS_SHARE = 1630973148,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_44_STRENGTH_SHARE = 790023294,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_44_FORCE = 302843362,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_44_SLIPPING = 1645333365,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_45_STIFFNESS_SHARE = 2094640085,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_45_STRENGTH_SHARE = 977411433,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_45_FORCE = 1505846187,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_45_SLIPPING = 1408435142,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_46_STIFFNESS_SHARE = 1368471070,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_46_STRENGTH_SHARE = 1537343404,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_46_FORCE = 832102632,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_46_SLIPPING = 17864635,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_47_STIFFNESS_SHARE = 1268459495,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_47_STRENGTH_SHARE = 1802316735,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_47_FORCE = 214530521,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_47_SLIPPING = 349389228,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_48_STIFFNESS_SHARE = 962357688,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_48_STRENGTH_SHARE = 551198226,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_48_FORCE = 1487246542,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_48_SLIPPING = 63228505,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_49_STIFFNESS_SHARE = 1693810849,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_49_STRENGTH_SHARE = 1863738557,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_49_FORCE = 1661841975,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_49_SLIPPING = 1268102634,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_50_STIFFNESS_SHARE = 858733547,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_50_STRENGTH_SHARE = 1454051371,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_50_FORCE = 203243773,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_50_SLIPPING = 913270536,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_51_STIFFNESS_SHARE = 729255570,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_51_STRENGTH_SHARE = 1369670296,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_51_FORCE = 1665163628,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_51_SLIPPING = 429935015,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_52_STIFFNESS_SHARE = 478314121,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_52_STRENGTH_SHARE = 1175523701,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_52_FORCE = 750257615,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_52_SLIPPING = 1135649474,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_53_STIFFNESS_SHARE = 249802176,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_53_STRENGTH_SHARE = 1412119242,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_53_FORCE = 599051910,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_53_SLIPPING = 558867377,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_54_STIFFNESS_SHARE = 80424343,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_54_STRENGTH_SHARE = 1301221135,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_54_FORCE = 837516361,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_54_SLIPPING = 196555580,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_55_STIFFNESS_SHARE = 782214158,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_55_STRENGTH_SHARE = 2098940,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_55_FORCE = 1684639960,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_55_SLIPPING = 1945475467,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_56_STIFFNESS_SHARE = 1642684485,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_56_STRENGTH_SHARE = 1564337017,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_56_FORCE = 873888731,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_56_SLIPPING = 1061606934,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_57_STIFFNESS_SHARE = 1394649868,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_57_STRENGTH_SHARE = 143624462,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_57_FORCE = 172823890,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_57_SLIPPING = 507858693,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_58_STIFFNESS_SHARE = 101493395,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_58_STRENGTH_SHARE = 1962539907,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_58_FORCE = 114358549,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_58_SLIPPING = 1197397120,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_59_STIFFNESS_SHARE = 234895322,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_59_STRENGTH_SHARE = 1234062608,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_59_FORCE = 1362131492,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_59_SLIPPING = 1894357567,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_60_STIFFNESS_SHARE = 1306091582,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_60_STRENGTH_SHARE = 1993267020,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_60_FORCE = 2000504648,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_60_SLIPPING = 1409802907,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_61_STIFFNESS_SHARE = 1830921223,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_61_STRENGTH_SHARE = 949193311,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_61_FORCE = 1622568249,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_61_SLIPPING = 1513784204,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_62_STIFFNESS_SHARE = 544926460,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_62_STRENGTH_SHARE = 1321062046,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_62_FORCE = 954080834,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_62_SLIPPING = 1026729045,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_63_STIFFNESS_SHARE = 1751068149,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_63_STRENGTH_SHARE = 1706177161,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_63_FORCE = 1435926411,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_63_SLIPPING = 884594470,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_64_STIFFNESS_SHARE = 887313282,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_64_STRENGTH_SHARE = 655092008,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_64_FORCE = 266751068,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_MAXWELL_SLIP_ELEMENT_64_SLIPPING = 1934953527,
  /** state [stribeck_phase]: Direction of slip as found by the last event of Model Exchange: none (Held), Forward or Backward.
   *  (default Free) */
  STRIBECK_MAXWELL_SLIP_SLIP = 1754213035,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_MAXWELL_SLIP_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_MAXWELL_SLIP_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_MAXWELL_SLIP_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_MAXWELL_SLIP_STICKING = 553311409,
} stribeck_maxwell_slip_variable;

/** Guid of Leuven for fmi2Instantiate. */
#define STRIBECK_LEUVEN_GUID "{bf498e23-439b-fdd9-9dc3-e020f60abfc2}"

/** Preset of Leuven: Example: levels and stiffness of Novais (2024), Tables 6.1, 7.1; rest chosen (the start values). */
#define STRIBECK_LEUVEN_PRESET_FOUR_ELEMENTS "four_elements"

/** Preset of Leuven: Example of a smooth virgin curve: 64 elements with evenly spaced slip displacements. */
#define STRIBECK_LEUVEN_PRESET_SMOOTH "smooth"

/** Leuven: Bristle friction with hysteresis of pre-sliding (Leuven, in the form of Lampaert). Variables of "Leuven". */
typedef enum stribeck_leuven_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_LEUVEN_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LEUVEN_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LEUVEN_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LEUVEN_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_LEUVEN_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_LEUVEN_STRIBECK_EXPONENT = 509292062,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_LEUVEN_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_LEUVEN_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_LEUVEN_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [1]: Exponent of the approach to the steady level (default chosen). (>= 0.1, default 1) */
  STRIBECK_LEUVEN_APPROACH_EXPONENT = 1565510341,
  /** tunable [1]: Strength of all elements together, as a multiple of the static level; not less than 1 (default chosen).
   *  (> 0, default 1.2) */
  STRIBECK_LEUVEN_HYSTERESIS_STRENGTH = 1853440090,
  /** fixed [stribeck_element_distribution]: Where the shares of the elements come from. (default Explicit) */
  STRIBECK_LEUVEN_DISTRIBUTION = 882397483,
  /** fixed [Integer]: Number of elements in use (default chosen). (>= 1, <= 64, default 4) */
  STRIBECK_LEUVEN_ELEMENT_COUNT = 1814028119,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.5) */
  STRIBECK_LEUVEN_ELEMENT_1_STIFFNESS_SHARE = 1984559525,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_1_STRENGTH_SHARE = 1653101785,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_1_FORCE = 417008123,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_1_SLIPPING = 61645750,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.25) */
  STRIBECK_LEUVEN_ELEMENT_2_STIFFNESS_SHARE = 635638510,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.2) */
  STRIBECK_LEUVEN_ELEMENT_2_STRENGTH_SHARE = 1020390876,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_2_FORCE = 956601336,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_2_SLIPPING = 916397611,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.15) */
  STRIBECK_LEUVEN_ELEMENT_3_STIFFNESS_SHARE = 236442871,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.3) */
  STRIBECK_LEUVEN_ELEMENT_3_STRENGTH_SHARE = 1826059887,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_3_FORCE = 810068841,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_3_SLIPPING = 1045816540,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_4_STIFFNESS_SHARE = 507261856,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.4) */
  STRIBECK_LEUVEN_ELEMENT_4_STRENGTH_SHARE = 466493098,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_4_FORCE = 1956354086,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_4_SLIPPING = 567684305,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_5_STIFFNESS_SHARE = 978834793,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_5_STRENGTH_SHARE = 968197717,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_5_FORCE = 1495200879,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_5_SLIPPING = 1747360226,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_6_STIFFNESS_SHARE = 2004137970,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_6_STRENGTH_SHARE = 1481769336,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_6_FORCE = 1688949644,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_6_SLIPPING = 780131655,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_7_STIFFNESS_SHARE = 423657291,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_7_STRENGTH_SHARE = 363891723,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_7_FORCE = 1643862173,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_7_SLIPPING = 2136700712,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_8_STIFFNESS_SHARE = 1337862804,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_8_STRENGTH_SHARE = 866511878,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_8_FORCE = 475811146,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_8_SLIPPING = 1088859837,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_9_STIFFNESS_SHARE = 1333387469,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_9_STRENGTH_SHARE = 1790412305,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_9_FORCE = 427133779,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_9_SLIPPING = 790213006,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_10_STIFFNESS_SHARE = 930777631,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_10_STRENGTH_SHARE = 1307487559,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_10_FORCE = 309754689,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_10_SLIPPING = 1971059860,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_11_STIFFNESS_SHARE = 1582832214,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_11_STRENGTH_SHARE = 1197920180,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_11_FORCE = 1627200688,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_11_SLIPPING = 1236750147,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_12_STIFFNESS_SHARE = 242124973,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_12_STRENGTH_SHARE = 318599793,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_12_FORCE = 1622967027,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_12_SLIPPING = 423589806,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_13_STIFFNESS_SHARE = 488236916,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_13_STRENGTH_SHARE = 569303654,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_13_FORCE = 934999786,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_13_SLIPPING = 592280285,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_14_STIFFNESS_SHARE = 867993811,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_14_STRENGTH_SHARE = 464171203,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_14_FORCE = 1304020821,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_14_SLIPPING = 51371456,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_15_STIFFNESS_SHARE = 1030058266,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_15_STRENGTH_SHARE = 1045466960,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_15_FORCE = 2058652516,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_15_SLIPPING = 277263231,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_16_STIFFNESS_SHARE = 1516159377,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_16_STRENGTH_SHARE = 236029453,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_16_FORCE = 1408145063,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_16_SLIPPING = 1467883514,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_17_STIFFNESS_SHARE = 1526225256,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_17_STRENGTH_SHARE = 1201028194,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_17_FORCE = 303569406,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_17_SLIPPING = 1335271913,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_18_STIFFNESS_SHARE = 209375959,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_18_STRENGTH_SHARE = 596598607,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_18_FORCE = 2027178633,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_18_SLIPPING = 800456828,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_19_STIFFNESS_SHARE = 1120869198,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_19_STRENGTH_SHARE = 207821116,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_19_FORCE = 1048396568,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_19_SLIPPING = 722875339,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_20_STIFFNESS_SHARE = 946953330,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_20_STRENGTH_SHARE = 184261368,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_20_FORCE = 1384494092,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_20_SLIPPING = 1106485959,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_21_STIFFNESS_SHARE = 1513956299,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_21_STRENGTH_SHARE = 1213867403,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_21_FORCE = 1339406621,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_21_SLIPPING = 315571368,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_22_STIFFNESS_SHARE = 1597560864,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_22_STRENGTH_SHARE = 1316468778,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_22_FORCE = 1651898534,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_22_SLIPPING = 894038609,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_23_STIFFNESS_SHARE = 2069133801,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_23_STRENGTH_SHARE = 1818173397,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_23_FORCE = 1190745327,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_23_SLIPPING = 2073714530,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_24_STIFFNESS_SHARE = 1725937518,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_24_STRENGTH_SHARE = 1870366556,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_24_FORCE = 652145784,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_24_SLIPPING = 1242751915,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_25_STIFFNESS_SHARE = 1326741879,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_25_STRENGTH_SHARE = 528551919,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_25_FORCE = 505613289,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_25_SLIPPING = 1372170844,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_26_STIFFNESS_SHARE = 2058379500,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_26_STRENGTH_SHARE = 1023527406,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_26_FORCE = 904932594,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_26_SLIPPING = 1220548901,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_27_STIFFNESS_SHARE = 927374885,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_27_STRENGTH_SHARE = 355593817,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_27_FORCE = 112552571,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_27_SLIPPING = 388000054,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_28_STIFFNESS_SHARE = 1832821434,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_28_STRENGTH_SHARE = 798860656,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_28_FORCE = 1990520644,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_28_SLIPPING = 1763494623,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_29_STIFFNESS_SHARE = 1725129971,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_29_STRENGTH_SHARE = 13610851,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_29_FORCE = 1966599861,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_29_SLIPPING = 291006880,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_30_STIFFNESS_SHARE = 1598222037,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_30_STRENGTH_SHARE = 432647785,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_30_FORCE = 1876414123,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_30_SLIPPING = 458579142,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_31_STIFFNESS_SHARE = 1134555100,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_31_STRENGTH_SHARE = 245259646,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_31_FORCE = 673411298,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_31_SLIPPING = 695477365,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_32_STIFFNESS_SHARE = 772041447,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_32_STRENGTH_SHARE = 1257553087,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_32_FORCE = 585098457,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_32_SLIPPING = 1547016876,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_33_STIFFNESS_SHARE = 872053022,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_33_STRENGTH_SHARE = 992579756,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_33_FORCE = 1202670568,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_33_SLIPPING = 1215492283,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_34_STIFFNESS_SHARE = 665747033,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_34_STRENGTH_SHARE = 964650981,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_34_FORCE = 1613712607,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_34_SLIPPING = 1256503346,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_35_STIFFNESS_SHARE = 1703752592,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_35_STRENGTH_SHARE = 1012019194,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_35_FORCE = 114543126,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_35_SLIPPING = 691903969,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_36_STIFFNESS_SHARE = 1398614523,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_36_STRENGTH_SHARE = 1685909851,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_36_FORCE = 1016182349,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_36_SLIPPING = 694061816,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_37_STIFFNESS_SHARE = 903984738,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_37_STRENGTH_SHARE = 1625210248,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_37_FORCE = 18164220,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_37_SLIPPING = 102603351,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_38_STIFFNESS_SHARE = 1356982141,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_38_STRENGTH_SHARE = 849034273,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_38_FORCE = 1336195843,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_38_SLIPPING = 737377246,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_39_STIFFNESS_SHARE = 1715598724,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_39_STRENGTH_SHARE = 1964832726,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_39_FORCE = 1304001018,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_39_SLIPPING = 993257933,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_40_STIFFNESS_SHARE = 52686992,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_40_STRENGTH_SHARE = 1556782842,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_40_FORCE = 1891458838,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_40_SLIPPING = 1641759969,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_41_STIFFNESS_SHARE = 1162165081,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_41_STRENGTH_SHARE = 1509414629,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_41_FORCE = 1243144671,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_41_SLIPPING = 58875698,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_42_STIFFNESS_SHARE = 1400402786,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_42_STRENGTH_SHARE = 22490248,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_42_FORCE = 1795079932,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_42_SLIPPING = 1052459351,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_43_STIFFNESS_SHARE = 1895032571,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_43_STRENGTH_SHARE = 83189851,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_43_FORCE = 645614413,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_43_SLIPPING = 1643917816,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_44_STIFFNESS_SHARE = 1630973148,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_44_STRENGTH_SHARE = 790023294,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_44_FORCE = 302843362,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_44_SLIPPING = 1645333365,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_45_STIFFNESS_SHARE = 2094640085,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_45_STRENGTH_SHARE = 977411433,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_45_FORCE = 1505846187,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_45_SLIPPING = 1408435142,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_46_STIFFNESS_SHARE = 1368471070,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_46_STRENGTH_SHARE = 1537343404,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_46_FORCE = 832102632,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_46_SLIPPING = 17864635,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_47_STIFFNESS_SHARE = 1268459495,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_47_STRENGTH_SHARE = 1802316735,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_47_FORCE = 214530521,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_47_SLIPPING = 349389228,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_48_STIFFNESS_SHARE = 962357688,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_48_STRENGTH_SHARE = 551198226,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_48_FORCE = 1487246542,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_48_SLIPPING = 63228505,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_49_STIFFNESS_SHARE = 1693810849,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_49_STRENGTH_SHARE = 1863738557,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_49_FORCE = 1661841975,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_49_SLIPPING = 1268102634,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_50_STIFFNESS_SHARE = 858733547,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_50_STRENGTH_SHARE = 1454051371,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_50_FORCE = 203243773,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_50_SLIPPING = 913270536,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_51_STIFFNESS_SHARE = 729255570,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_51_STRENGTH_SHARE = 1369670296,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_51_FORCE = 1665163628,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_51_SLIPPING = 429935015,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_52_STIFFNESS_SHARE = 478314121,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_52_STRENGTH_SHARE = 1175523701,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_52_FORCE = 750257615,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_52_SLIPPING = 1135649474,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_53_STIFFNESS_SHARE = 249802176,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_53_STRENGTH_SHARE = 1412119242,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_53_FORCE = 599051910,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_53_SLIPPING = 558867377,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_54_STIFFNESS_SHARE = 80424343,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_54_STRENGTH_SHARE = 1301221135,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_54_FORCE = 837516361,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_54_SLIPPING = 196555580,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_55_STIFFNESS_SHARE = 782214158,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_55_STRENGTH_SHARE = 2098940,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_55_FORCE = 1684639960,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_55_SLIPPING = 1945475467,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_56_STIFFNESS_SHARE = 1642684485,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_56_STRENGTH_SHARE = 1564337017,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_56_FORCE = 873888731,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_56_SLIPPING = 1061606934,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_57_STIFFNESS_SHARE = 1394649868,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_57_STRENGTH_SHARE = 143624462,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_57_FORCE = 172823890,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_57_SLIPPING = 507858693,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_58_STIFFNESS_SHARE = 101493395,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_58_STRENGTH_SHARE = 1962539907,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_58_FORCE = 114358549,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_58_SLIPPING = 1197397120,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_59_STIFFNESS_SHARE = 234895322,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_59_STRENGTH_SHARE = 1234062608,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_59_FORCE = 1362131492,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_59_SLIPPING = 1894357567,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_60_STIFFNESS_SHARE = 1306091582,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_60_STRENGTH_SHARE = 1993267020,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_60_FORCE = 2000504648,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_60_SLIPPING = 1409802907,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_61_STIFFNESS_SHARE = 1830921223,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_61_STRENGTH_SHARE = 949193311,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_61_FORCE = 1622568249,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_61_SLIPPING = 1513784204,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_62_STIFFNESS_SHARE = 544926460,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_62_STRENGTH_SHARE = 1321062046,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_62_FORCE = 954080834,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_62_SLIPPING = 1026729045,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_63_STIFFNESS_SHARE = 1751068149,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_63_STRENGTH_SHARE = 1706177161,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_63_FORCE = 1435926411,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_63_SLIPPING = 884594470,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_64_STIFFNESS_SHARE = 887313282,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_LEUVEN_ELEMENT_64_STRENGTH_SHARE = 655092008,
  /** state [N]: Force of the element. (default 0) */
  STRIBECK_LEUVEN_ELEMENT_64_FORCE = 266751068,
  /** state [Boolean]: Is the element slipping? (default false) */
  STRIBECK_LEUVEN_ELEMENT_64_SLIPPING = 1934953527,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_LEUVEN_BRISTLE_DEFLECTION = 767148150,
  /** state [stribeck_phase]: Direction of slip as found by the last event of Model Exchange: none (Held), Forward or Backward.
   *  (default Free) */
  STRIBECK_LEUVEN_SLIP = 1754213035,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LEUVEN_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LEUVEN_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LEUVEN_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LEUVEN_STICKING = 553311409,
} stribeck_leuven_variable;

/** Guid of Gonthier for fmi2Instantiate. */
#define STRIBECK_GONTHIER_GUID "{42fa2fc2-775c-cded-96c6-6470d75d4139}"

/** Preset of Gonthier: Novais (2024), Tables 6.1 and 7.1, v_0 = v_S / 100 of its text (the start values). */
#define STRIBECK_GONTHIER_PRESET_THESIS "thesis"

/** Gonthier: Bristle friction with dwell time (Gonthier). Variables of "Gonthier". */
typedef enum stribeck_gonthier_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_GONTHIER_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_GONTHIER_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_GONTHIER_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_GONTHIER_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_GONTHIER_STRIBECK_VELOCITY = 2117263402,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 1e-5) */
  STRIBECK_GONTHIER_TRANSITION_VELOCITY = 1009615136,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_GONTHIER_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (> 0, default 316.22776601683796) */
  STRIBECK_GONTHIER_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_GONTHIER_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [s]: Time constant with which the static level rises at rest. (> 0, default 2) */
  STRIBECK_GONTHIER_DWELL_TIME_CONSTANT = 88383486,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_GONTHIER_BRISTLE_DEFLECTION = 767148150,
  /** state [1]: Memory of the time at rest: 0 after sliding, 1 after a long rest. (>= 0, <= 1, default 0) */
  STRIBECK_GONTHIER_DWELL = 313856875,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_GONTHIER_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_GONTHIER_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_GONTHIER_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_GONTHIER_STICKING = 553311409,
} stribeck_gonthier_variable;

/** Guid of Liang for fmi2Instantiate. */
#define STRIBECK_LIANG_GUID "{6ab2b2a7-a367-5938-0fcc-889a566fb5b6}"

/** Preset of Liang: Novais (2024), Tables 6.1 and 7.1 (the start values). */
#define STRIBECK_LIANG_PRESET_THESIS "thesis"

/** Preset of Liang: Novais (2024), Tables 6.1 and 7.1, with the limit rule of (7.49) as printed. */
#define STRIBECK_LIANG_PRESET_PRINTED "printed"

/** Liang: Bristle friction in space (Liang). Variables of "Liang". */
typedef enum stribeck_liang_variable {
  /** in [m/s]: Velocity of body 1 relative to body 2, component x. (default 0) */
  STRIBECK_LIANG_VELOCITY_X = 1174807869,
  /** in [m/s]: Velocity of body 1 relative to body 2, component y. (default 0) */
  STRIBECK_LIANG_VELOCITY_Y = 1158030250,
  /** in [m/s]: Velocity of body 1 relative to body 2, component z. (default 0) */
  STRIBECK_LIANG_VELOCITY_Z = 1141252631,
  /** in [1]: Normal of the contact, component x; the length does not matter. (default 0) */
  STRIBECK_LIANG_NORMAL_X = 1438289821,
  /** in [1]: Normal of the contact, component y; the length does not matter. (default 0) */
  STRIBECK_LIANG_NORMAL_Y = 1421512202,
  /** in [1]: Normal of the contact, component z; the length does not matter. (default 1) */
  STRIBECK_LIANG_NORMAL_Z = 1404734583,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LIANG_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LIANG_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LIANG_MU_S = 1147235793,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_LIANG_TRANSITION_VELOCITY = 1009615136,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_LIANG_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_LIANG_SIGMA_1 = 189464704,
  /** fixed [stribeck_liang_variant]: Variant of the law. (default RadialReturn) */
  STRIBECK_LIANG_VARIANT = 1125473670,
  /** state [m]: Elastic deflection of the bristles, component x. (default 0) */
  STRIBECK_LIANG_BRISTLE_DEFLECTION_X = 1159069321,
  /** state [m]: Elastic deflection of the bristles, component y. (default 0) */
  STRIBECK_LIANG_BRISTLE_DEFLECTION_Y = 1142291702,
  /** state [m]: Elastic deflection of the bristles, component z. (default 0) */
  STRIBECK_LIANG_BRISTLE_DEFLECTION_Z = 1125514083,
  /** state [stribeck_liang_motion]: Motion of the bristle as found by the last event of Model Exchange.
   *  (default Free) */
  STRIBECK_LIANG_MOTION = 1030989351,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LIANG_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force, component x; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LIANG_FRICTION_FORCE_X = 1757412168,
  /** out [N]: Friction force, component y; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LIANG_FRICTION_FORCE_Y = 1774189787,
  /** out [N]: Friction force, component z; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LIANG_FRICTION_FORCE_Z = 1790967406,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LIANG_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LIANG_STICKING = 553311409,
} stribeck_liang_variable;

/** Guid of LuGrePlanar for fmi2Instantiate. */
#define STRIBECK_LUGRE_PLANAR_GUID "{665ef91d-b628-8f64-4c98-d8d6b5ac8ad4}"

/** Preset of LuGrePlanar: The law along a line in Novais (2024), Tables 6.1 and 7.1 (the start values). */
#define STRIBECK_LUGRE_PLANAR_PRESET_THESIS "thesis"

/** LuGrePlanar: Bristle friction with Stribeck effect in a plane (LuGre). Variables of "LuGrePlanar". */
typedef enum stribeck_lugre_planar_variable {
  /** in [m/s]: Velocity of body 1 relative to body 2, component x. (default 0) */
  STRIBECK_LUGRE_PLANAR_VELOCITY_X = 1174807869,
  /** in [m/s]: Velocity of body 1 relative to body 2, component y. (default 0) */
  STRIBECK_LUGRE_PLANAR_VELOCITY_Y = 1158030250,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LUGRE_PLANAR_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LUGRE_PLANAR_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LUGRE_PLANAR_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_LUGRE_PLANAR_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_LUGRE_PLANAR_STRIBECK_EXPONENT = 509292062,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_LUGRE_PLANAR_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_LUGRE_PLANAR_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_LUGRE_PLANAR_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_LUGRE_PLANAR_DAMPING_VELOCITY = 626846797,
  /** state [m]: Elastic deflection of the bristles, component x. (default 0) */
  STRIBECK_LUGRE_PLANAR_BRISTLE_DEFLECTION_X = 1159069321,
  /** state [m]: Elastic deflection of the bristles, component y. (default 0) */
  STRIBECK_LUGRE_PLANAR_BRISTLE_DEFLECTION_Y = 1142291702,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_LUGRE_PLANAR_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force, component x; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LUGRE_PLANAR_FRICTION_FORCE_X = 1757412168,
  /** out [N]: Friction force, component y; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_LUGRE_PLANAR_FRICTION_FORCE_Y = 1774189787,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_LUGRE_PLANAR_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_LUGRE_PLANAR_STICKING = 553311409,
} stribeck_lugre_planar_variable;

/** Guid of ElastoPlasticPlanar for fmi2Instantiate. */
#define STRIBECK_ELASTO_PLASTIC_PLANAR_GUID "{e9f5ed33-430e-0fb4-5efd-07a8506903de}"

/** Preset of ElastoPlasticPlanar: The law along a line in Novais (2024), Tables 6.1 and 7.1, and kappa = 0.7 (the start values). */
#define STRIBECK_ELASTO_PLASTIC_PLANAR_PRESET_THESIS "thesis"

/** ElastoPlasticPlanar: Bristle friction without drift below breakaway, in a plane (elasto-plastic). Variables of "ElastoPlasticPlanar". */
typedef enum stribeck_elasto_plastic_planar_variable {
  /** in [m/s]: Velocity of body 1 relative to body 2, component x. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_VELOCITY_X = 1174807869,
  /** in [m/s]: Velocity of body 1 relative to body 2, component y. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_VELOCITY_Y = 1158030250,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_STRIBECK_EXPONENT = 509292062,
  /** tunable [1]: Part of the deflection of steady sliding up to which the contact is purely elastic.
   *  (> 0, <= 0.99, default 0.7) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_BREAKAWAY_RATIO = 1487030850,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_DAMPING_VELOCITY = 626846797,
  /** state [m]: Elastic deflection of the bristles, component x. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_BRISTLE_DEFLECTION_X = 1159069321,
  /** state [m]: Elastic deflection of the bristles, component y. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_BRISTLE_DEFLECTION_Y = 1142291702,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ELASTO_PLASTIC_PLANAR_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force, component x; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ELASTO_PLASTIC_PLANAR_FRICTION_FORCE_X = 1757412168,
  /** out [N]: Friction force, component y; has the direction of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ELASTO_PLASTIC_PLANAR_FRICTION_FORCE_Y = 1774189787,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ELASTO_PLASTIC_PLANAR_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ELASTO_PLASTIC_PLANAR_STICKING = 553311409,
} stribeck_elasto_plastic_planar_variable;

/** Guid of RollingResistance for fmi2Instantiate. */
#define STRIBECK_ROLLING_RESISTANCE_GUID "{c4503833-cda1-d975-533c-453021f5bf8b}"

/** RollingResistance: Rolling resistance of a wheel, by its lever arm. Variables of "RollingResistance". */
typedef enum stribeck_rolling_resistance_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_ROLLING_RESISTANCE_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_EXTERNAL_FORCE = 1336490458,
  /** tunable [m]: Distance of the normal force ahead of the wheel's centre (default chosen). (>= 0, default 0.003) */
  STRIBECK_ROLLING_RESISTANCE_LEVER_ARM = 1681494142,
  /** tunable [m]: Radius of the wheel (default chosen). (> 0, default 0.3) */
  STRIBECK_ROLLING_RESISTANCE_WHEEL_RADIUS = 279851015,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_ROLLING_RESISTANCE_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_ROLLING_RESISTANCE_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_ROLLING_RESISTANCE_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_ROLLING_RESISTANCE_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_ROLLING_RESISTANCE_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_ROLLING_RESISTANCE_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_ROLLING_RESISTANCE_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_ROLLING_RESISTANCE_FRICTION_FORCE = 1713976319,
  /** out [N.m]: Moment that opposes rolling. */
  STRIBECK_ROLLING_RESISTANCE_RESISTING_MOMENT = 1689387822,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_ROLLING_RESISTANCE_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_ROLLING_RESISTANCE_STICKING = 553311409,
} stribeck_rolling_resistance_variable;

/** Guid of DirectionalStribeck for fmi2Instantiate. */
#define STRIBECK_DIRECTIONAL_STRIBECK_GUID "{02c94eb3-bd10-3967-4d8e-a13dc2802579}"

/** Preset of DirectionalStribeck: enactic/openarm, issue 103 (2025), axis 1: N.m and N.m.s/rad, here at a normal force of 1; no static level known. */
#define STRIBECK_DIRECTIONAL_STRIBECK_PRESET_OPENARM_JOINT_1 "openarm_joint_1"

/** Preset of DirectionalStribeck: Robotics Toolbox of P. Corke, model of the Puma 560: N.m and N.m.s/rad of the motor, here at a normal force of 1; no static level known. */
#define STRIBECK_DIRECTIONAL_STRIBECK_PRESET_PUMA_560_JOINT_1 "puma_560_joint_1"

/** DirectionalStribeck: Stribeck friction that differs by direction. Variables of "DirectionalStribeck". */
typedef enum stribeck_directional_stribeck_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_DIRECTIONAL_STRIBECK_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction at positive velocity. (>= 0, default 0.1) */
  STRIBECK_DIRECTIONAL_STRIBECK_MU_K_FORWARD = 2009355551,
  /** tunable [1]: Kinetic coefficient of friction at negative velocity. (>= 0, default 0.1) */
  STRIBECK_DIRECTIONAL_STRIBECK_MU_K_BACKWARD = 1409630639,
  /** tunable [1]: Static coefficient of friction towards positive velocity; not less than mu_k_forward.
   *  (>= 0, default 0.15) */
  STRIBECK_DIRECTIONAL_STRIBECK_MU_S_FORWARD = 172349863,
  /** tunable [1]: Static coefficient of friction towards negative velocity; not less than mu_k_backward.
   *  (>= 0, default 0.15) */
  STRIBECK_DIRECTIONAL_STRIBECK_MU_S_BACKWARD = 846245543,
  /** tunable [m/s]: Positive velocity at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_DIRECTIONAL_STRIBECK_STRIBECK_VELOCITY_FORWARD = 770119452,
  /** tunable [m/s]: Magnitude of the negative velocity at which the excess of static friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_DIRECTIONAL_STRIBECK_STRIBECK_VELOCITY_BACKWARD = 188310802,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_DIRECTIONAL_STRIBECK_STRIBECK_EXPONENT = 509292062,
  /** tunable [N.s/m]: Viscous friction coefficient at positive velocity. (>= 0, default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_VISCOUS_COEFFICIENT_FORWARD = 1462510995,
  /** tunable [N.s/m]: Viscous friction coefficient at negative velocity. (>= 0, default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_VISCOUS_COEFFICIENT_BACKWARD = 1367278395,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_DIRECTIONAL_STRIBECK_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_DIRECTIONAL_STRIBECK_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_DIRECTIONAL_STRIBECK_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_DIRECTIONAL_STRIBECK_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_DIRECTIONAL_STRIBECK_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_DIRECTIONAL_STRIBECK_STICKING = 553311409,
} stribeck_directional_stribeck_variable;

/** Guid of JointFriction for fmi2Instantiate. */
#define STRIBECK_JOINT_FRICTION_GUID "{58d15beb-6971-91c2-2861-fdcfa4bef305}"

/** Preset of JointFriction: Example of a joint with a gear, in N.m and rad/s at the arm; exponent of Bittencourt and Gunnarsson (2012). */
#define STRIBECK_JOINT_FRICTION_PRESET_WARM_GEAR "warm_gear"

/** JointFriction: Friction of a joint by load and temperature (Bittencourt and Gunnarsson). Variables of "JointFriction". */
typedef enum stribeck_joint_friction_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_JOINT_FRICTION_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_JOINT_FRICTION_NORMAL_FORCE = 5891938,
  /** in [N]: Resultant of all other tangential forces on body 1; see Coupling if body 2 accelerates. (default 0) */
  STRIBECK_JOINT_FRICTION_EXTERNAL_FORCE = 1336490458,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_JOINT_FRICTION_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_JOINT_FRICTION_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_JOINT_FRICTION_STRIBECK_VELOCITY = 2117263402,
  /** tunable [N]: Kinetic level of friction without load. (>= 0, default 0) */
  STRIBECK_JOINT_FRICTION_KINETIC_FORCE = 12436976,
  /** tunable [N]: Excess of the static over the kinetic level without load, at 20 degC. (>= 0, default 0) */
  STRIBECK_JOINT_FRICTION_EXCESS_FORCE = 1955954170,
  /** tunable [1/K]: Relative change of excess_force with temperature. (default 0) */
  STRIBECK_JOINT_FRICTION_EXCESS_BY_TEMPERATURE = 1529109515,
  /** tunable [m/s]: Speed at which the excess without load has fallen to 1/e, at 20 degC. (> 0, default 0.001) */
  STRIBECK_JOINT_FRICTION_STRIBECK_VELOCITY_UNLOADED = 878093101,
  /** tunable [1/K]: Relative change of stribeck_velocity_unloaded with temperature. (default 0) */
  STRIBECK_JOINT_FRICTION_VELOCITY_BY_TEMPERATURE = 542047299,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_JOINT_FRICTION_STRIBECK_EXPONENT = 509292062,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_JOINT_FRICTION_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [N.s/m]: Viscous coefficient that is added at 20 degC, less in a warmer joint. (>= 0, default 0) */
  STRIBECK_JOINT_FRICTION_VISCOUS_COEFFICIENT_COLD = 1841780376,
  /** tunable [K]: Rise of temperature after which 1/e of viscous_coefficient_cold is left (start value chosen).
   *  (> 0, default 20) */
  STRIBECK_JOINT_FRICTION_VISCOUS_TEMPERATURE = 1390637406,
  /** tunable [K]: Temperature of the lubricant. (>= 0, default 293.15) */
  STRIBECK_JOINT_FRICTION_TEMPERATURE = 1777510709,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_JOINT_FRICTION_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_JOINT_FRICTION_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_JOINT_FRICTION_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_JOINT_FRICTION_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_JOINT_FRICTION_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_JOINT_FRICTION_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_JOINT_FRICTION_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_JOINT_FRICTION_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_JOINT_FRICTION_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_JOINT_FRICTION_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_JOINT_FRICTION_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_JOINT_FRICTION_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_JOINT_FRICTION_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_JOINT_FRICTION_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_JOINT_FRICTION_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_JOINT_FRICTION_STICKING = 553311409,
} stribeck_joint_friction_variable;

/** Guid of RateAndState for fmi2Instantiate. */
#define STRIBECK_RATE_AND_STATE_GUID "{d6cab9cd-d5b2-3f86-1c7e-9b5bc92df04c}"

/** Preset of RateAndState: SEAS benchmark BP1, where friction weakens: Erickson et al. (2020), doi:10.1785/0220190248. */
#define STRIBECK_RATE_AND_STATE_PRESET_SEAS_BP1 "seas_bp1"

/** Preset of RateAndState: Example of a contact that creeps steadily: a = 0.015 above b = 0.010. */
#define STRIBECK_RATE_AND_STATE_PRESET_STRENGTHENING "strengthening"

/** RateAndState: Friction of rock, by the speed and the age of its contacts (Dieterich, Ruina). Variables of "RateAndState". */
typedef enum stribeck_rate_and_state_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_RATE_AND_STATE_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_RATE_AND_STATE_NORMAL_FORCE = 5891938,
  /** tunable [1]: Coefficient of friction in steady sliding at the reference velocity. (>= 0, default 0.6) */
  STRIBECK_RATE_AND_STATE_MU_0 = 23186904,
  /** tunable [1]: Direct effect: change of the coefficient of friction with the logarithm of the speed, at once.
   *  (> 0, default 0.01) */
  STRIBECK_RATE_AND_STATE_DIRECT_EFFECT = 1669853328,
  /** tunable [1]: Evolution effect: change of the coefficient of friction with the logarithm of the age of the contacts.
   *  (>= 0, default 0.015) */
  STRIBECK_RATE_AND_STATE_EVOLUTION_EFFECT = 365637878,
  /** tunable [m]: Characteristic slip distance, on which sliding renews the contacts (default chosen).
   *  (> 0, default 1e-5) */
  STRIBECK_RATE_AND_STATE_SLIP_DISTANCE = 1501476103,
  /** tunable [m/s]: Speed of steady sliding at which the coefficient of friction is mu_0. (> 0, default 1e-6) */
  STRIBECK_RATE_AND_STATE_REFERENCE_VELOCITY = 1862806520,
  /** fixed [stribeck_rate_and_state_variant]: Variant of the law. (default Ageing) */
  STRIBECK_RATE_AND_STATE_VARIANT = 1125473670,
  /** state [1]: Logarithm of the age of the contacts, relative to that of steady sliding at the reference velocity.
   *  (default 0) */
  STRIBECK_RATE_AND_STATE_LOG_AGE = 2101967429,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_RATE_AND_STATE_DISSIPATED_ENERGY = 758404530,
  /** out [s]: Age of the contacts. */
  STRIBECK_RATE_AND_STATE_AGE = 742476188,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_RATE_AND_STATE_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_RATE_AND_STATE_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_RATE_AND_STATE_STICKING = 553311409,
} stribeck_rate_and_state_variable;

/** Guid of CylinderFriction for fmi2Instantiate. */
#define STRIBECK_CYLINDER_FRICTION_GUID "{b840a972-f6c9-c86c-e2d2-c9972a65cb8a}"

/** Preset of CylinderFriction: Example of a hydraulic cylinder: 60 N at breakaway, 30 N of seals sliding, at a contact force of 300 N. */
#define STRIBECK_CYLINDER_FRICTION_PRESET_HYDRAULIC_CYLINDER "hydraulic_cylinder"

/** CylinderFriction: Friction of a cylinder with a lubricant film that needs time (Tran and Yanada). Variables of "CylinderFriction". */
typedef enum stribeck_cylinder_friction_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_CYLINDER_FRICTION_VELOCITY = 846470194,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_CYLINDER_FRICTION_NORMAL_FORCE = 5891938,
  /** tunable [1]: Kinetic coefficient of friction. (> 0, default 0.1) */
  STRIBECK_CYLINDER_FRICTION_MU_K = 1281456745,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_CYLINDER_FRICTION_MU_S = 1147235793,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_CYLINDER_FRICTION_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_CYLINDER_FRICTION_STRIBECK_EXPONENT = 509292062,
  /** tunable [m/s]: Speed from which on the film grows no further (default chosen). (> 0, default 0.002) */
  STRIBECK_CYLINDER_FRICTION_FILM_VELOCITY = 356690951,
  /** tunable [s]: Time constant of a film that grows (default chosen). (> 0, default 0.05) */
  STRIBECK_CYLINDER_FRICTION_FILM_GROWTH_TIME_CONSTANT = 1440804158,
  /** tunable [s]: Time constant of a film that thins in motion (default chosen). (> 0, default 0.2) */
  STRIBECK_CYLINDER_FRICTION_FILM_DECAY_TIME_CONSTANT = 430338583,
  /** tunable [s]: Time constant of a film that is squeezed out at rest (default chosen). (> 0, default 20) */
  STRIBECK_CYLINDER_FRICTION_FILM_REST_TIME_CONSTANT = 1484153399,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_CYLINDER_FRICTION_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_CYLINDER_FRICTION_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_CYLINDER_FRICTION_VISCOUS_COEFFICIENT = 97539077,
  /** state [m]: Mean elastic deflection of the bristles. (default 0) */
  STRIBECK_CYLINDER_FRICTION_BRISTLE_DEFLECTION = 767148150,
  /** state [1]: Thickness of the lubricant film: 0 = dry, 1 = carries all the load. (>= 0, <= 1, default 0) */
  STRIBECK_CYLINDER_FRICTION_FILM_THICKNESS = 849709678,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_CYLINDER_FRICTION_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_CYLINDER_FRICTION_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_CYLINDER_FRICTION_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_CYLINDER_FRICTION_STICKING = 553311409,
} stribeck_cylinder_friction_variable;

/** Guid of ShockAbsorber for fmi2Instantiate. */
#define STRIBECK_SHOCK_ABSORBER_GUID "{b4a4eb55-e653-e908-50ab-989526284e55}"

/** Preset of ShockAbsorber: Formula Student, front axle: the start values. */
#define STRIBECK_SHOCK_ABSORBER_PRESET_FRONT "front"

/** Preset of ShockAbsorber: Formula Student, rear axle: spring of Zips Racing ZR26 (MIT licence), otherwise as front. */
#define STRIBECK_SHOCK_ABSORBER_PRESET_REAR "rear"

/** Preset of ShockAbsorber: Example of a digressive damper: the table of the start values. */
#define STRIBECK_SHOCK_ABSORBER_PRESET_DAMPER_TABLE "damper_table"

/** Preset of ShockAbsorber: Spencer, Dyke, Sain, Carlson (1997): their damper, whose accumulator the spring replaces; otherwise as front. */
#define STRIBECK_SHOCK_ABSORBER_PRESET_MAGNETORHEOLOGICAL "magnetorheological"

/** Preset of ShockAbsorber: Example without friction: the start values otherwise. */
#define STRIBECK_SHOCK_ABSORBER_PRESET_FRICTIONLESS "frictionless"

/** Preset of ShockAbsorber: Example for a host with its own spring and stops; the guidance is derived from length and stroke. */
#define STRIBECK_SHOCK_ABSORBER_PRESET_DAMPER_AND_FRICTION "damper_and_friction"

/** Preset of ShockAbsorber: Koelsch 1994: 25 N (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_KOELSCH_1994 "koelsch_1994"

/** Preset of ShockAbsorber: Manger 1995: lower end of 30 N to 45 N (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_MANGER_1995_LOW "manger_1995_low"

/** Preset of ShockAbsorber: Manger 1995: upper end of 30 N to 45 N (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_MANGER_1995_HIGH "manger_1995_high"

/** Preset of ShockAbsorber: Lizarraga 2008, measured: 22 N in compression, 15 N in extension (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_LIZARRAGA_2008_MEASURED "lizarraga_2008_measured"

/** Preset of ShockAbsorber: Lizarraga 2008, simulated: 32 N in compression, 23 N in extension (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_LIZARRAGA_2008_SIMULATED "lizarraga_2008_simulated"

/** Preset of ShockAbsorber: Fujimoto 2018: lower end of 20 N to 150 N (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_FUJIMOTO_2018_LOW "fujimoto_2018_low"

/** Preset of ShockAbsorber: Fujimoto 2018: upper end of 20 N to 150 N (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_FUJIMOTO_2018_HIGH "fujimoto_2018_high"

/** Preset of ShockAbsorber: Wegener 2020: half of the lower end of 75 N to 350 N per axle (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_WEGENER_2020_LOW "wegener_2020_low"

/** Preset of ShockAbsorber: Wegener 2020: half of the upper end of 75 N to 350 N per axle (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_WEGENER_2020_HIGH "wegener_2020_high"

/** Preset of ShockAbsorber: Koerner and Mayer 2020: lower end of 20 N to 70 N in compression and 10 N to 40 N in extension (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_KOERNER_MAYER_2020_LOW "koerner_mayer_2020_low"

/** Preset of ShockAbsorber: Koerner and Mayer 2020: upper end of 20 N to 70 N in compression and 10 N to 40 N in extension (Novais 2024, Table 2.1). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_KOERNER_MAYER_2020_HIGH "koerner_mayer_2020_high"

/** Preset of ShockAbsorber: Herzog and Augsburg 2021: 35 N in compression, 30 N in extension (Novais 2024, Table 2.1; doi:10.3390/vehicles3020014). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_HERZOG_AUGSBURG_2021 "herzog_augsburg_2021"

/** Preset of ShockAbsorber: Deubel and Prokop 2024, with side load: lower end of 62 N to 134 N (Novais 2024, Table 2.1; doi:10.1177/09544070231201688). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_DEUBEL_PROKOP_2024_LOW "deubel_prokop_2024_low"

/** Preset of ShockAbsorber: Deubel and Prokop 2024, with side load: upper end of 62 N to 134 N (Novais 2024, Table 2.1; doi:10.1177/09544070231201688). */
#define STRIBECK_SHOCK_ABSORBER_PRESET_DEUBEL_PROKOP_2024_HIGH "deubel_prokop_2024_high"

/** ShockAbsorber: Telescopic shock absorber with friction from its side load. Variables of "ShockAbsorber". */
typedef enum stribeck_shock_absorber_variable {
  /** in [m]: Distance of the eyes, or travel of the host: see adapter. (default 0.1775) */
  STRIBECK_SHOCK_ABSORBER_LENGTH = 63976981,
  /** in [m/s]: Time derivative of the length; positive in extension. (default 0) */
  STRIBECK_SHOCK_ABSORBER_VELOCITY = 846470194,
  /** in [N]: Transverse force of the tube on the rod along m, at the eye of the tube; or lambda_1. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_FORCE_M = 1541469338,
  /** in [N]: Transverse force of the tube on the rod along n, at the eye of the tube; or lambda_2. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_FORCE_N = 1524691719,
  /** in [N.m]: Moment of the tube on the rod about m, at the eye of the tube; or lambda_3. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_MOMENT_M = 1100257835,
  /** in [N.m]: Moment of the tube on the rod about n, at the eye of the tube; or lambda_4. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_MOMENT_N = 1117035454,
  /** in [rad/s]: Spin of the rod relative to the tube, about the axis from tube to rod. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPIN_RATE = 49729312,
  /** in [N]: All other forces along the strut, positive in extension; only for laws that hold a load at rest.
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_EXTERNAL_FORCE = 1336490458,
  /** in [m/s2]: Time derivative of the velocity; for num.input_mode = Linear and for laws that use it. (default 0) */
  STRIBECK_SHOCK_ABSORBER_ACCELERATION = 799062685,
  /** in [K]: Ambient temperature; used if thermal.enabled is true. (>= 0, default 293.15) */
  STRIBECK_SHOCK_ABSORBER_TEMPERATURE_AMBIENT = 1378166418,
  /** in [V]: Voltage at the current driver of the damper's coil; used by damper.mode = MagnetorheologicalDamper.
   *  (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_VOLTAGE = 1637048165,
  /** fixed [m]: Distance of the eyes at full extension (default chosen). (> 0, default 0.2) */
  STRIBECK_SHOCK_ABSORBER_GEOM_LENGTH_EXTENDED = 1634510775,
  /** fixed [m]: Stroke from full extension to full compression. (> 0, default 0.055) */
  STRIBECK_SHOCK_ABSORBER_GEOM_STROKE = 693420161,
  /** fixed [Boolean]: Are d_i and d_j derived from length_extended and stroke? (default false) */
  STRIBECK_SHOCK_ABSORBER_GEOM_GUIDANCE_DERIVED = 846575701,
  /** fixed [m]: Distance from the eye of the tube to the rod guide (default chosen). (> 0, default 0.125) */
  STRIBECK_SHOCK_ABSORBER_GEOM_D_I = 203271619,
  /** fixed [m]: Distance from the eye of the rod to the piston (default chosen). (> 0, default 0.105) */
  STRIBECK_SHOCK_ABSORBER_GEOM_D_J = 220049238,
  /** fixed [m]: Overlap below which the contact forces are kept finite (default chosen). (>= 0, default 0.002) */
  STRIBECK_SHOCK_ABSORBER_GEOM_H_REG = 606834118,
  /** fixed [m]: Radius of the rod, at the rod guide (default chosen). (>= 0, default 0.007) */
  STRIBECK_SHOCK_ABSORBER_GEOM_R_1 = 1046876817,
  /** fixed [m]: Radius of the piston (default chosen). (>= 0, default 0.0125) */
  STRIBECK_SHOCK_ABSORBER_GEOM_R_2 = 996543960,
  /** fixed [Boolean]: Is there a spring? (default true) */
  STRIBECK_SHOCK_ABSORBER_SPRING_ENABLED = 602440755,
  /** fixed [stribeck_spring_mode]: Form of the spring's characteristic. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_SPRING_MODE = 354240045,
  /** tunable [N/m]: Stiffness. (>= 0, default 45000) */
  STRIBECK_SHOCK_ABSORBER_SPRING_K = 1239346679,
  /** tunable [N]: Force at full extension (default chosen). (default 150) */
  STRIBECK_SHOCK_ABSORBER_SPRING_PRELOAD = 693664647,
  /** fixed [Integer]: Number of points of the table in use (default chosen). (>= 2, <= 16, default 3) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_N = 173096048,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_1 = 1626994985,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0.03) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_2 = 553028690,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0.055) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_3 = 485771119,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_4 = 486903952,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_5 = 1627583365,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_6 = 1627436270,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_7 = 486462667,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_8 = 1558751676,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_9 = 551895857,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_10 = 1632597957,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_11 = 491918544,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_12 = 491374091,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_13 = 1632450862,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_14 = 1631906409,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_15 = 491226996,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_X_16 = 490785711,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_1 = 1971131151,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 1350) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_2 = 1971675604,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 2850) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_3 = 964819785,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_4 = 965364238,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_5 = 1971822699,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_6 = 1972263984,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_7 = 965511333,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_8 = 2037108794,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_9 = 896135191,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_10 = 47843055,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_11 = 115100626,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_12 = 1189066921,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_13 = 48387508,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_14 = 48534603,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_15 = 1189508206,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_SPRING_TAB_F_16 = 1189655301,
  /** fixed [Boolean]: Is there a gas force? (default true) */
  STRIBECK_SHOCK_ABSORBER_GAS_ENABLED = 729824997,
  /** tunable [Pa]: Absolute gas pressure at full extension (default chosen). (>= 0, default 1000000) */
  STRIBECK_SHOCK_ABSORBER_GAS_P0 = 640951140,
  /** fixed [m3]: Gas volume at full extension (default chosen). (> 0, default 3e-5) */
  STRIBECK_SHOCK_ABSORBER_GAS_V0 = 444496818,
  /** fixed [1]: Polytropic exponent (default chosen). (>= 0, default 1.2) */
  STRIBECK_SHOCK_ABSORBER_GAS_N = 904392190,
  /** fixed [m]: Diameter of the rod (default chosen). (>= 0, default 0.014) */
  STRIBECK_SHOCK_ABSORBER_GAS_ROD_DIAMETER = 1130974353,
  /** tunable [Pa]: Ambient pressure. (>= 0, default 101325) */
  STRIBECK_SHOCK_ABSORBER_GAS_P_AMBIENT = 1322016071,
  /** fixed [Boolean]: Is there a bump stop? (default true) */
  STRIBECK_SHOCK_ABSORBER_BUMP_ENABLED = 528272746,
  /** fixed [m]: Compression from full extension at which the bump stop is touched (default chosen). (default 0.04) */
  STRIBECK_SHOCK_ABSORBER_BUMP_GAP = 342752507,
  /** fixed [stribeck_bump_mode]: Form of the bump stop's characteristic. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_BUMP_MODE = 262009054,
  /** tunable [N/m]: Stiffness: of the linear form, and first coefficient of the cubic one (default chosen).
   *  (>= 0, default 150000) */
  STRIBECK_SHOCK_ABSORBER_BUMP_K = 1950935518,
  /** tunable [1]: Exponent of the power form (default chosen). (>= 1, default 2.2) */
  STRIBECK_SHOCK_ABSORBER_BUMP_N = 2034823613,
  /** tunable [m]: Compression at which the power form has the force F_ref (default chosen). (> 0, default 0.01) */
  STRIBECK_SHOCK_ABSORBER_BUMP_X_REF = 1165900593,
  /** tunable [N]: Force of the power form at x_ref (default chosen). (>= 0, default 1500) */
  STRIBECK_SHOCK_ABSORBER_BUMP_F_REF = 1732261983,
  /** tunable [N/m2]: Second coefficient of the cubic form. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_BUMP_K2 = 2059943556,
  /** tunable [N/m3]: Third coefficient of the cubic form. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_BUMP_K3 = 2076721175,
  /** tunable [N.s/m]: Damping while the stop is touched. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_BUMP_C = 1816714566,
  /** fixed [Boolean]: Is there a rebound stop? (default true) */
  STRIBECK_SHOCK_ABSORBER_REBOUND_ENABLED = 670112079,
  /** fixed [m]: Compression from full extension at which the rebound stop is touched. (default 0) */
  STRIBECK_SHOCK_ABSORBER_REBOUND_GAP = 931930910,
  /** tunable [N/m]: Stiffness (default chosen). (>= 0, default 1000000) */
  STRIBECK_SHOCK_ABSORBER_REBOUND_K = 1217846635,
  /** tunable [N.s/m]: Damping while the stop is touched. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_REBOUND_C = 1083625683,
  /** fixed [Boolean]: Is there a damper? (default true) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_ENABLED = 653710919,
  /** fixed [stribeck_damper_mode]: Form of the damper's characteristic. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MODE = 1000786193,
  /** tunable [N.s/m]: Damping coefficient in compression (default chosen). (>= 0, default 1500) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_C_COMP = 1218223315,
  /** tunable [N.s/m]: Damping coefficient in extension, the rebound (default chosen). (>= 0, default 2300) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_C_REB = 1051140173,
  /** tunable [s/m]: Degression in compression. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_DEGR_COMP = 191387222,
  /** tunable [s/m]: Degression in extension. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_DEGR_REB = 563928450,
  /** fixed [Integer]: Number of points of the table in use (default chosen). (>= 2, <= 16, default 11) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_N = 1952893940,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_1 = 948357411,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.5) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_2 = 948901864,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.25) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_3 = 2089581277,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_4 = 1015026602,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.05) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_5 = 947769031,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_6 = 2021926348,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.05) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_7 = 2088889729,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_8 = 2090714110,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.25) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_9 = 2023456539,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.5) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_10 = 915979179,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_11 = 2057004366,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_12 = 2057151461,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_13 = 916523632,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_14 = 915390799,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_15 = 982648370,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_V_16 = 2056563081,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -1150) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_1 = 191481363,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -700) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_2 = 192025816,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -430) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_3 = 258989197,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -210) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_4 = 1331918170,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -110) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_5 = 190892983,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_6 = 191334268,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 180) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_7 = 1332065265,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 340) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_8 = 260122030,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 640) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_9 = 1266528907,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 950) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_10 = 1116503963,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 1500) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_11 = 1183761534,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_12 = 110192597,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_13 = 43229216,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_14 = 42096383,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_15 = 1183069986,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_TAB_F_16 = 1183217081,
  /** fixed [stribeck_interpolation]: Curve through the points of the table. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_INTERPOLATION = 1084982648,
  /** tunable [1]: Factor on the damper force. (>= 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_SCALE = 1838924032,
  /** fixed [N/m]: Stiffness in series with the damper, of oil and top mount; 0 = rigid. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_K_SERIES = 1401687841,
  /** tunable [N.s/m]: Damping at high speeds without voltage. (>= 0, default 2100) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_C_0A = 19433904,
  /** tunable [N.s/(m.V)]: Increase of the damping at high speeds with the voltage. (>= 0, default 350) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_C_0B = 69766761,
  /** tunable [N/m]: Stiffness at high speeds. (>= 0, default 4690) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_K_0 = 639419545,
  /** tunable [N.s/m]: Coefficient of the dashpot in series without voltage. (> 0, default 28300) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_C_1A = 489060141,
  /** tunable [N.s/(m.V)]: Increase of the coefficient of the dashpot in series with the voltage. (>= 0, default 295) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_C_1B = 438727284,
  /** tunable [N/m]: Stiffness of the hysteresis without voltage. (>= 0, default 14000) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_ALPHA_A = 1352302827,
  /** tunable [N/(m.V)]: Increase of the stiffness of the hysteresis with the voltage. (>= 0, default 69500) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_ALPHA_B = 1369080446,
  /** tunable [1/m2]: Form of the hysteresis: its part that acts in both directions of motion, in m^-n.
   *  (>= 0, default 3630000) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_HYSTERESIS_GAMMA = 1000379448,
  /** tunable [1/m2]: Form of the hysteresis: its part that changes sign with the motion, in m^-n; above -hysteresis_gamma.
   *  (default 3630000) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_HYSTERESIS_BETA = 490073321,
  /** tunable [1]: Slope of the evolutionary variable over the displacement where it is 0. (> 0, default 301) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_A = 181946176,
  /** tunable [1]: Exponent of the hysteresis: its transition to the saturated level is sharper if larger.
   *  (>= 1, default 2) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_N = 970494269,
  /** tunable [1/s]: Rate at which the voltage on the fluid follows that at the driver. (> 0, default 190) */
  STRIBECK_SHOCK_ABSORBER_DAMPER_MR_VOLTAGE_RATE = 2066688272,
  /** fixed [stribeck_friction_model]: Friction law; parameters of other laws are ignored. (default LuGre) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MODEL = 718325868,
  /** tunable [stribeck_friction_switch]: Active parts of the friction. (default On) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SWITCH = 1316691407,
  /** tunable [1]: Friction in compression over friction in extension: (1 + asymmetry) / (1 - asymmetry).
   *  (>= -0.99, <= 0.99, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ASYMMETRY = 2029946676,
  /** tunable [1]: Factor on all friction levels. (>= 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SCALE = 956758479,
  /** tunable [kg]: Effective mass of the body, for laws that use it; 0 = law as printed. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MASS = 1642932867,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges force and motion; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_EXCHANGE = 913732870,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_STRIBECK_VELOCITY = 1519261972,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_STRIBECK_EXPONENT = 1211129088,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SIGMA_0 = 1309247285,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SIGMA_1 = 1292469666,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_VISCOUS_COEFFICIENT = 157080163,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DAMPING_VELOCITY = 610883159,
  /** fixed [stribeck_coulomb_viscous_variant]: Variant of the law. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_COULOMBVISCOUS_VARIANT = 2048999885,
  /** tunable [1]: Exponent of the viscous part. (> 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_VISCOUS_EXPONENT = 1053197097,
  /** fixed [stribeck_stribeck_curve]: How the level falls with speed. (default Gaussian) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_CURVE = 365515582,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_STRIBECK_VISCOUS_COEFFICIENT = 1198184670,
  /** tunable [N.s2/m2]: Quadratic friction coefficient; used by PoppStelter. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_QUADRATIC_COEFFICIENT = 1058495321,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 2000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TRANSITION_SLOPE = 1048698240,
  /** fixed [stribeck_threlfall_variant]: Variant of the law. (default Printed) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_THRELFALL_VARIANT = 202163868,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TRANSITION_VELOCITY = 163906394,
  /** fixed [stribeck_rooney_deravi_variant]: Variant of the law. (default Linear) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ROONEYDERAVI_VARIANT = 1956286015,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (>= 0, default 0.0001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_AMBROSIO_TRANSITION_VELOCITY = 32779198,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SLIDING_VELOCITY = 2091256599,
  /** fixed [stribeck_bengisu_akay_variant]: Variant of the law. (default Thesis) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BENGISUAKAY_VARIANT = 780083729,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 5000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BENGISUAKAY_TRANSITION_SLOPE = 1008920195,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 500) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_STICTION_DECAY = 197701967,
  /** tunable [s/m]: Viscous coefficient of friction, per normal force. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MU_V = 195132,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 10000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ANDERSSON_TRANSITION_SLOPE = 175687589,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ANDERSSON_VISCOUS_COEFFICIENT = 451477724,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_AWREJCEWICZ_STICTION_DECAY = 1199436897,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SPECKER_TRANSITION_VELOCITY = 816843187,
  /** tunable [m/s]: Velocity at which the static level is reached (default chosen). (> 0, default 0.0005) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_PEAK_VELOCITY = 494732202,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SPECKER_VISCOUS_COEFFICIENT = 484229442,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.0015) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_LINEARSTICTION_SLIDING_VELOCITY = 1146592147,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BROWNMCPHEE_VISCOUS_COEFFICIENT = 237120135,
  /** tunable [N]: Normal force at which the viscous part is fully active (default chosen). (> 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TRANSITION_NORMAL_FORCE = 804491626,
  /** tunable [1]: Exponent of the transition to sliding; below 1 brittle, from 1 on ductile. (>= 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ALPHA = 582116977,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_FRICTIONALLAG_VISCOUS_COEFFICIENT = 1079872672,
  /** fixed [s]: Time by which the level of friction lags behind the velocity (default chosen). (>= 0, default 0.005) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TIME_LAG = 1346657113,
  /** fixed [stribeck_frictional_lag_variant]: Variant of the law. (default Delay) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_FRICTIONALLAG_VARIANT = 1166768751,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ARMSTRONG_VISCOUS_COEFFICIENT = 104992308,
  /** tunable [s]: Dwell time after which half of the rise of the static friction has occurred (default chosen).
   *  (>= 0, default 2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_GAMMA = 1977894676,
  /** fixed [stribeck_acceleration_source]: How the law knows whether the contact speeds up or slows down.
   *  (default Input) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ACCELERATION_SOURCE = 823206969,
  /** tunable [1]: Coefficient of friction that a contact reaches when it comes to rest; not more than mu_s (default chosen).
   *  (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MU_STOP = 1837154842,
  /** tunable [s/m]: Steepness of the curve while speeding up (default chosen). (> 0, default 500) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ACCELERATION_DECAY = 1879733450,
  /** tunable [s/m]: Steepness of the curve while slowing down (default chosen). (> 0, default 500) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DECELERATION_DECAY = 1768807973,
  /** tunable [s/m]: Steepness of the curves for speeding up and slowing down (default chosen). (> 0, default 500) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BRANCH_DECAY = 2073065670,
  /** fixed [stribeck_bliman_sorine_order]: Variant of the law. (default Second) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BLIMANSORINE_VARIANT = 583382101,
  /** tunable [1]: Level of the slow relaxation, as a coefficient of friction; second order (default calibrated).
   *  (>= 0, default 0.2732050807568877) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MU_2 = 1006800688,
  /** tunable [1]: Length of the fast relaxation as a part of that of the slow one; second order (default chosen).
   *  (> 0, <= 1, default 0.5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ETA = 1505373677,
  /** tunable [m]: Sliding distance in which the slow relaxation settles to 1/e (default calibrated).
   *  (> 0, default 4.642141842225068e-5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_EPS_F = 143280926,
  /** tunable [m]: Shear deflection of the asperities in steady sliding (default f_C / sigma_0 of the thesis).
   *  (> 0, default 9.81e-6) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DELTA_T = 626693188,
  /** tunable [1]: Part of the deflection of steady sliding up to which the contact is purely elastic.
   *  (> 0, <= 1, default 0.7) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BREAKAWAY_RATIO = 1652803556,
  /** tunable [Integer]: Exponent of the transition from elastic deflection to sliding; odd. (>= 1, <= 9, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_PLASTIC_EXPONENT = 580682845,
  /** tunable [m]: Strain at which a bristle snaps (default f_s / sigma_0 of the thesis). (> 0, default 1.4715e-5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DELTA = 2065665047,
  /** fixed [Integer]: Number of bristles (default chosen). (>= 1, <= 64, default 25) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_BRISTLE_COUNT = 1010238726,
  /** fixed [Integer]: Seed of the random numbers. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SEED = 1731659842,
  /** fixed [stribeck_initial_bonds]: State of the bristles when the motion starts. (default Bonded) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_INITIAL_BONDS = 254102368,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SPECKERDYNAMIC_TRANSITION_VELOCITY = 695032766,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SPECKERDYNAMIC_VISCOUS_COEFFICIENT = 165096311,
  /** tunable [s]: Time constant of the force while sliding (default chosen). (> 0, default 0.001) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_SLIP_TIME = 788380435,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MAXWELLSLIP_SIGMA_1 = 1478808016,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_MAXWELLSLIP_VISCOUS_COEFFICIENT = 396050933,
  /** tunable [N/s]: Rate at which the slipping elements together approach their level (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ATTRACTION = 1435098162,
  /** fixed [stribeck_element_distribution]: Where the shares of the elements come from. (default Explicit) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DISTRIBUTION = 21287993,
  /** fixed [Integer]: Number of elements in use (default chosen). (>= 1, <= 16, default 4) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_COUNT = 1149577601,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_1_STIFFNESS_SHARE = 1847706511,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_1_STRENGTH_SHARE = 683083159,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.25) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_2_STIFFNESS_SHARE = 1300159780,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_2_STRENGTH_SHARE = 1889862646,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.15) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_3_STIFFNESS_SHARE = 1127554717,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.3) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_3_STRENGTH_SHARE = 248847553,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_4_STIFFNESS_SHARE = 1010711754,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.4) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_4_STRENGTH_SHARE = 956173024,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_5_STIFFNESS_SHARE = 2008968323,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_5_STRENGTH_SHARE = 717020499,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_6_STIFFNESS_SHARE = 13936472,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_6_STRENGTH_SHARE = 2108675762,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_7_STIFFNESS_SHARE = 1560638401,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_7_STRENGTH_SHARE = 581810013,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_8_STIFFNESS_SHARE = 1234943678,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_8_STRENGTH_SHARE = 479727308,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_9_STIFFNESS_SHARE = 1759773319,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_9_STRENGTH_SHARE = 1583137247,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_10_STIFFNESS_SHARE = 1230619133,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_10_STRENGTH_SHARE = 523667361,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_11_STIFFNESS_SHARE = 1589235716,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_11_STRENGTH_SHARE = 1639465814,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_12_STIFFNESS_SHARE = 471692527,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_12_STRENGTH_SHARE = 398607607,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_13_STIFFNESS_SHARE = 1603765734,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_13_STRENGTH_SHARE = 2038715940,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_14_STIFFNESS_SHARE = 1071029793,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_14_STRENGTH_SHARE = 993607997,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_15_STIFFNESS_SHARE = 339576632,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_15_STRENGTH_SHARE = 1828551314,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_16_STIFFNESS_SHARE = 1364232803,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_ELEMENT_16_STRENGTH_SHARE = 1567232691,
  /** tunable [1]: Exponent of the approach to the steady level (default chosen). (>= 0.1, default 1) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_APPROACH_EXPONENT = 772972039,
  /** tunable [1]: Strength of all elements together, as a multiple of the static level; not less than 1 (default chosen).
   *  (> 0, default 1.2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_HYSTERESIS_STRENGTH = 235565580,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 1e-5) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_GONTHIER_TRANSITION_VELOCITY = 2083171682,
  /** tunable [s]: Time constant with which the static level rises at rest. (> 0, default 2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_DWELL_TIME_CONSTANT = 1275370588,
  /** tunable [m/s]: Speed from which on the film grows no further (default chosen). (> 0, default 0.002) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_FILM_VELOCITY = 66355881,
  /** tunable [s]: Time constant of a film that grows (default chosen). (> 0, default 0.05) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_FILM_GROWTH_TIME_CONSTANT = 2084465472,
  /** tunable [s]: Time constant of a film that thins in motion (default chosen). (> 0, default 0.2) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_FILM_DECAY_TIME_CONSTANT = 1424495313,
  /** tunable [s]: Time constant of a film that is squeezed out at rest (default chosen). (> 0, default 20) */
  STRIBECK_SHOCK_ABSORBER_FRICTION_FILM_REST_TIME_CONSTANT = 942996753,
  /** tunable [1]: Static coefficient of friction; not less than mu_k (default chosen). (>= 0, default 0.15) */
  STRIBECK_SHOCK_ABSORBER_C1_MU_S = 577759937,
  /** tunable [1]: Kinetic coefficient of friction (default chosen). (>= 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_C1_MU_K = 175097081,
  /** tunable [N]: Breakaway force without normal force, e.g. of a seal; not less than preload_k (default chosen).
   *  (>= 0, default 10) */
  STRIBECK_SHOCK_ABSORBER_C1_PRELOAD_S = 552210280,
  /** tunable [N]: Sliding friction force without normal force, e.g. of a seal (default chosen). (>= 0, default 8) */
  STRIBECK_SHOCK_ABSORBER_C1_PRELOAD_K = 149547424,
  /** tunable [1]: Static coefficient of friction; not less than mu_k (default chosen). (>= 0, default 0.1) */
  STRIBECK_SHOCK_ABSORBER_C2_MU_S = 1609957642,
  /** tunable [1]: Kinetic coefficient of friction (default chosen). (>= 0, default 0.08) */
  STRIBECK_SHOCK_ABSORBER_C2_MU_K = 1744178594,
  /** tunable [N]: Breakaway force without normal force, e.g. of a seal; not less than preload_k (default chosen).
   *  (>= 0, default 8) */
  STRIBECK_SHOCK_ABSORBER_C2_PRELOAD_S = 1474317509,
  /** tunable [N]: Sliding friction force without normal force, e.g. of a seal (default chosen). (>= 0, default 6) */
  STRIBECK_SHOCK_ABSORBER_C2_PRELOAD_K = 1876980365,
  /** fixed [stribeck_side_mode]: Side loads that act on the joint. (default Sum) */
  STRIBECK_SHOCK_ABSORBER_SIDE_MODE = 363937827,
  /** fixed [stribeck_side_convention]: Meaning of the four side-load inputs. (default WrenchOnRod) */
  STRIBECK_SHOCK_ABSORBER_SIDE_CONVENTION = 327089831,
  /** tunable [m]: Offset of the spring's line of action along m (default chosen). (default 0.003) */
  STRIBECK_SHOCK_ABSORBER_SIDE_OFFSET_M = 1605389515,
  /** tunable [m]: Offset of the spring's line of action along n. (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_OFFSET_N = 1622167134,
  /** tunable [1]: Side force of the spring along m, relative to its axial force; it acts at the eye of the tube.
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_SIDE_FORCE_RATIO = 302325823,
  /** fixed [stribeck_normal_sum]: Rule for the loads of the contacts from the load of the joint. (default TwoPoint) */
  STRIBECK_SHOCK_ABSORBER_SIDE_NORMAL_SUM = 1495483511,
  /** tunable [1]: Factor on the contact forces for the distribution of pressure; 4 / pi for a cosine over half the rim.
   *  (>= 0, default 1) */
  STRIBECK_SHOCK_ABSORBER_SIDE_C_GEO = 1983693491,
  /** fixed [Boolean]: Does the temperature change and affect the damper force? (default false) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_ENABLED = 1143096615,
  /** tunable [1/K]: Relative loss of damper force per kelvin (default chosen). (>= 0, default 0.003) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_BETA = 896115256,
  /** fixed [K]: Temperature at which the damper's characteristic was measured (default chosen).
   *  (> 0, default 293.15) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_TEMPERATURE_REF = 1979371978,
  /** fixed [J/K]: Heat capacity of the damper (default chosen: 0.6 kg of aluminium and oil). (> 0, default 600) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_CAPACITY = 1977759622,
  /** tunable [W/K]: Heat flow to the surroundings per kelvin (default chosen). (>= 0, default 1.5) */
  STRIBECK_SHOCK_ABSORBER_THERMAL_CONDUCTANCE = 1418428113,
  /** fixed [Boolean]: Is there a rubber mount between the rod and its eye? (default false) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_ENABLED = 1931473901,
  /** fixed [kg]: Mass of the rod with the inner part of the mount (default chosen). (> 0, default 0.3) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_MASS = 352722004,
  /** tunable [N]: Force that the mount carries where it is not displaced. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_PRELOAD = 1872310633,
  /** tunable [N/m]: Elastic stiffness (default chosen). (>= 0, default 500000) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_K_E = 765846497,
  /** fixed [N/m]: Stiffness in series with the damper; 0 = no damper (default chosen). (>= 0, default 100000) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_K_V = 447071736,
  /** tunable [N.s/m]: Coefficient of the damper (default chosen). (> 0, default 2000) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_C = 1948494925,
  /** tunable [N]: Largest friction (default chosen). (>= 0, default 100) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_F_MAX = 407014795,
  /** tunable [m]: Displacement from rest at which the friction is half of the largest (default chosen).
   *  (> 0, default 0.0002) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_X_2 = 1115036993,
  /** fixed [m]: Length of the strut when the input length is 0. (default 0) */
  STRIBECK_SHOCK_ABSORBER_ADAPTER_LENGTH_OFFSET = 469657428,
  /** fixed [1]: Length of the strut per input length; -MR for wheel travel, -0.001 for millimetres of compression.
   *  (default 1) */
  STRIBECK_SHOCK_ABSORBER_ADAPTER_LENGTH_GAIN = 1285630152,
  /** fixed [1]: Factor on force_travel, for the host's unit of force. (default 1) */
  STRIBECK_SHOCK_ABSORBER_ADAPTER_FORCE_GAIN = 1616342737,
  /** fixed [s]: Largest internal step (default chosen). (> 0, default 0.0001) */
  STRIBECK_SHOCK_ABSORBER_NUM_H_MAX = 459041784,
  /** fixed [stribeck_input_mode]: Motion of the inputs within a step. (default Hold) */
  STRIBECK_SHOCK_ABSORBER_NUM_INPUT_MODE = 446727669,
  /** tunable [kg]: Mass that the strut carries or moves, whichever is smaller; for the advice step_limit only.
   *  (> 0, default 16.4) */
  STRIBECK_SHOCK_ABSORBER_NUM_MASS_REF = 1199349185,
  /** fixed [stribeck_friction_start]: Initial state of the friction law. (default Steady) */
  STRIBECK_SHOCK_ABSORBER_INIT_FRICTION_STATE = 1669186807,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_1 = 27959037,
  /** state [1]: States of the friction law at the rod guide, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_1_2 = 1101527974,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_1 = 192605202,
  /** state [1]: States of the friction law at the piston, in SI units: see GuideContact. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MEMORY_2_2 = 1266468329,
  /** state [m/s]: Velocity of the damper's piston behind its series stiffness; that of the strut without a series stiffness.
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_PISTON_VELOCITY = 1881215274,
  /** state, out [K]: Temperature of the damper. (> 0, default 293.15) */
  STRIBECK_SHOCK_ABSORBER_TEMPERATURE = 1777510709,
  /** state, out [J]: Energy taken out of the motion by friction and damper since the start. (default 0) */
  STRIBECK_SHOCK_ABSORBER_DISSIPATED_ENERGY = 758404530,
  /** state [m]: Displacement of the damper less that of its dashpot in series. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MR_SLIP = 1434598982,
  /** state [m]: Evolutionary variable of the hysteresis. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MR_Z = 1962930174,
  /** state [V]: Voltage that acts on the fluid. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MR_FILTERED_VOLTAGE = 1562798738,
  /** state [m]: Displacement of the rod towards its eye, by which the strut is longer than the distance of the eyes.
   *  (default 0) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_DISPLACEMENT = 2059601815,
  /** state [m/s]: Velocity of the rod towards its eye. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_VELOCITY = 1599028631,
  /** state [1]: Friction as a part of the largest. (>= -1, <= 1, default 0) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_FRICTION_SHARE = 512981850,
  /** state [1]: Friction at the last turning point as a part of the largest. (>= -1, <= 1, default 0) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_TURNING_SHARE = 1380903077,
  /** state [Boolean]: Was the last motion towards positive displacements? (default true) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_RISING = 225892338,
  /** state [N]: Force of the damper and its spring. (default 0) */
  STRIBECK_SHOCK_ABSORBER_MOUNT_DAMPER_FORCE = 216505585,
  /** out [N]: Force of the strut; positive pushes the eyes apart. */
  STRIBECK_SHOCK_ABSORBER_FORCE = 2041153668,
  /** out [N]: The same with the opposite sign: positive pulls the eyes together. */
  STRIBECK_SHOCK_ABSORBER_FORCE_TENSION = 1267795993,
  /** out [N]: Part of the spring. */
  STRIBECK_SHOCK_ABSORBER_FORCE_SPRING = 1981388104,
  /** out [N]: Part of the gas. */
  STRIBECK_SHOCK_ABSORBER_FORCE_GAS = 1995581518,
  /** out [N]: Part of the bump stop. */
  STRIBECK_SHOCK_ABSORBER_FORCE_BUMP = 1217129313,
  /** out [N]: Part of the rebound stop. */
  STRIBECK_SHOCK_ABSORBER_FORCE_REBOUND = 1853814980,
  /** out [N]: Part of the damper. */
  STRIBECK_SHOCK_ABSORBER_FORCE_DAMPER = 1982494132,
  /** out [N]: Part of the friction. */
  STRIBECK_SHOCK_ABSORBER_FORCE_FRICTION = 2078264455,
  /** out [N]: Axial force without friction. At rest the friction carries it, less the force with which the host holds the length. */
  STRIBECK_SHOCK_ABSORBER_FORCE_WITHOUT_FRICTION = 1698389154,
  /** out [N]: Force of the mount, on the eye of the rod; force if there is no mount. */
  STRIBECK_SHOCK_ABSORBER_FORCE_MOUNT = 697412790,
  /** out [N]: Part of the force that moves the rod and not its eye: force less force_mount. */
  STRIBECK_SHOCK_ABSORBER_ROD_FORCE = 1433420958,
  /** out [N]: Force on the travel of the host, by virtual work: see adapter. */
  STRIBECK_SHOCK_ABSORBER_FORCE_TRAVEL = 2046608485,
  /** out [N]: Axial friction at the rod guide; has the sign of the velocity when sliding. */
  STRIBECK_SHOCK_ABSORBER_FRICTION_1 = 291020775,
  /** out [N]: Axial friction at the piston; has the sign of the velocity when sliding. */
  STRIBECK_SHOCK_ABSORBER_FRICTION_2 = 307798394,
  /** out [N]: Normal force at the rod guide. */
  STRIBECK_SHOCK_ABSORBER_NORMAL_1 = 213575218,
  /** out [N]: Normal force at the piston. */
  STRIBECK_SHOCK_ABSORBER_NORMAL_2 = 196797599,
  /** out [N.m]: Friction torque about the axis, on the tube; has the sign of the spin rate when sliding. */
  STRIBECK_SHOCK_ABSORBER_FRICTION_TORQUE = 971415098,
  /** out [m]: Compression from full extension. */
  STRIBECK_SHOCK_ABSORBER_COMPRESSION = 987494389,
  /** out [m]: Distance from piston to rod guide. */
  STRIBECK_SHOCK_ABSORBER_OVERLAP = 660987912,
  /** out [N/m]: Derivative of the force with respect to the length of the strut. */
  STRIBECK_SHOCK_ABSORBER_DFORCE_DLENGTH = 120123813,
  /** out [N.s/m]: Derivative of the force after a step with respect to the velocity of the strut. */
  STRIBECK_SHOCK_ABSORBER_DFORCE_DVELOCITY = 1696124290,
  /** out [s]: Largest communication step that is stable for num.mass_ref; advice to the master. */
  STRIBECK_SHOCK_ABSORBER_STEP_LIMIT = 422381299,
  /** out [W]: Power taken out of the motion by friction and damper. */
  STRIBECK_SHOCK_ABSORBER_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Do the contacts stick? */
  STRIBECK_SHOCK_ABSORBER_STICKING = 553311409,
  /** out [Boolean]: Is the bump stop touched? */
  STRIBECK_SHOCK_ABSORBER_BUMP_ACTIVE = 12196120,
  /** out [Boolean]: Is the overlap so short that the contact forces are regularised? */
  STRIBECK_SHOCK_ABSORBER_OVERLAP_LOW = 1487137969,
} stribeck_shock_absorber_variable;

/** Guid of TelescopicJoint for fmi2Instantiate. */
#define STRIBECK_TELESCOPIC_JOINT_GUID "{2f8d9de5-6e9b-7810-ca8e-d72e365f8a12}"

/** Preset of TelescopicJoint: Example of a side load of 100 N at the eye of the tube. */
#define STRIBECK_TELESCOPIC_JOINT_PRESET_SIDE_FORCE "side_force"

/** TelescopicJoint: Contact forces of a telescopic joint, from its side load. Variables of "TelescopicJoint". */
typedef enum stribeck_telescopic_joint_variable {
  /** in [m]: Distance of the eyes. (default 0.1775) */
  STRIBECK_TELESCOPIC_JOINT_LENGTH = 63976981,
  /** in [N]: Transverse force of the tube on the rod along m, at the eye of the tube; or lambda_1. (default 0) */
  STRIBECK_TELESCOPIC_JOINT_SIDE_FORCE_M = 1541469338,
  /** in [N]: Transverse force of the tube on the rod along n, at the eye of the tube; or lambda_2. (default 0) */
  STRIBECK_TELESCOPIC_JOINT_SIDE_FORCE_N = 1524691719,
  /** in [N.m]: Moment of the tube on the rod about m, at the eye of the tube; or lambda_3. (default 0) */
  STRIBECK_TELESCOPIC_JOINT_SIDE_MOMENT_M = 1100257835,
  /** in [N.m]: Moment of the tube on the rod about n, at the eye of the tube; or lambda_4. (default 0) */
  STRIBECK_TELESCOPIC_JOINT_SIDE_MOMENT_N = 1117035454,
  /** fixed [stribeck_side_convention]: Meaning of the four side loads. (default WrenchOnRod) */
  STRIBECK_TELESCOPIC_JOINT_CONVENTION = 712418130,
  /** fixed [stribeck_normal_sum]: Rule for summing the contact forces. (default TwoPoint) */
  STRIBECK_TELESCOPIC_JOINT_NORMAL_SUM = 337058274,
  /** fixed [m]: Distance from the eye of the tube to the rod guide (default chosen). (> 0, default 0.125) */
  STRIBECK_TELESCOPIC_JOINT_GEOM_D_I = 203271619,
  /** fixed [m]: Distance from the eye of the rod to the piston (default chosen). (> 0, default 0.105) */
  STRIBECK_TELESCOPIC_JOINT_GEOM_D_J = 220049238,
  /** fixed [m]: Overlap below which the contact forces are kept finite (default chosen). (>= 0, default 0.002) */
  STRIBECK_TELESCOPIC_JOINT_GEOM_H_REG = 606834118,
  /** out [N]: Normal force at the rod guide. */
  STRIBECK_TELESCOPIC_JOINT_NORMAL_1 = 213575218,
  /** out [N]: Normal force at the piston. */
  STRIBECK_TELESCOPIC_JOINT_NORMAL_2 = 196797599,
  /** out [N]: Force on the rod at the rod guide along m. */
  STRIBECK_TELESCOPIC_JOINT_FORCE_1_M = 2068730960,
  /** out [N]: Force on the rod at the rod guide along n. */
  STRIBECK_TELESCOPIC_JOINT_FORCE_1_N = 2119063817,
  /** out [N]: Force on the rod at the piston along m. */
  STRIBECK_TELESCOPIC_JOINT_FORCE_2_M = 660688669,
  /** out [N]: Force on the rod at the piston along n. */
  STRIBECK_TELESCOPIC_JOINT_FORCE_2_N = 610355812,
  /** out [m]: Distance from piston to rod guide. */
  STRIBECK_TELESCOPIC_JOINT_OVERLAP = 660987912,
  /** out [Boolean]: Is the overlap so short that the contact forces are regularised? */
  STRIBECK_TELESCOPIC_JOINT_OVERLAP_LOW = 1487137969,
} stribeck_telescopic_joint_variable;

/** Guid of GuideContact for fmi2Instantiate. */
#define STRIBECK_GUIDE_CONTACT_GUID "{9a847f7a-68eb-c8d0-f395-df182d4117e2}"

/** GuideContact: Friction of a rod in its guide, by any law of the catalogue. Variables of "GuideContact". */
typedef enum stribeck_guide_contact_variable {
  /** in [m/s]: Axial velocity of the rod relative to the guide. (default 0) */
  STRIBECK_GUIDE_CONTACT_VELOCITY = 846470194,
  /** in [rad/s]: Spin of the rod relative to the guide. (default 0) */
  STRIBECK_GUIDE_CONTACT_SPIN_RATE = 49729312,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_NORMAL_FORCE = 5891938,
  /** in [N]: All other axial forces on the rod; only for laws that hold a load at rest. (default 0) */
  STRIBECK_GUIDE_CONTACT_EXTERNAL_FORCE = 1336490458,
  /** in [m/s2]: Time derivative of the velocity; only for laws that use it. (default 0) */
  STRIBECK_GUIDE_CONTACT_ACCELERATION = 799062685,
  /** tunable [m]: Radius of the contact. (>= 0, default 0.007) */
  STRIBECK_GUIDE_CONTACT_RADIUS = 230313139,
  /** tunable [1]: Static coefficient of friction; not less than mu_k (default chosen). (>= 0, default 0.15) */
  STRIBECK_GUIDE_CONTACT_LEVELS_MU_S = 1754235372,
  /** tunable [1]: Kinetic coefficient of friction (default chosen). (>= 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_LEVELS_MU_K = 9414580,
  /** tunable [N]: Breakaway force without normal force, e.g. of a seal; not less than preload_k (default chosen).
   *  (>= 0, default 10) */
  STRIBECK_GUIDE_CONTACT_LEVELS_PRELOAD_S = 717434771,
  /** tunable [N]: Sliding friction force without normal force, e.g. of a seal (default chosen). (>= 0, default 8) */
  STRIBECK_GUIDE_CONTACT_LEVELS_PRELOAD_K = 1120097627,
  /** fixed [stribeck_friction_model]: Friction law; parameters of other laws are ignored. (default LuGre) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MODEL = 718325868,
  /** tunable [stribeck_friction_switch]: Active parts of the friction. (default On) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SWITCH = 1316691407,
  /** tunable [1]: Friction in compression over friction in extension: (1 + asymmetry) / (1 - asymmetry).
   *  (>= -0.99, <= 0.99, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ASYMMETRY = 2029946676,
  /** tunable [1]: Factor on all friction levels. (>= 0, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SCALE = 956758479,
  /** tunable [kg]: Effective mass of the body, for laws that use it; 0 = law as printed. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MASS = 1642932867,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges force and motion; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_GUIDE_CONTACT_FRICTION_EXCHANGE = 913732870,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e, or to 1/2 where the curve is a fraction (Armstrong, HessSoom, PoppStelter).
   *  (> 0, default 0.001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_STRIBECK_VELOCITY = 1519261972,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_STRIBECK_EXPONENT = 1211129088,
  /** tunable [N/m]: Stiffness of the bristles. (> 0, default 100000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SIGMA_0 = 1309247285,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 316.22776601683796) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SIGMA_1 = 1292469666,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_VISCOUS_COEFFICIENT = 157080163,
  /** tunable [m/s]: Speed at which the damping of the bristles fades; 0 = constant damping. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DAMPING_VELOCITY = 610883159,
  /** fixed [stribeck_coulomb_viscous_variant]: Variant of the law. (default Linear) */
  STRIBECK_GUIDE_CONTACT_FRICTION_COULOMBVISCOUS_VARIANT = 2048999885,
  /** tunable [1]: Exponent of the viscous part. (> 0, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_VISCOUS_EXPONENT = 1053197097,
  /** fixed [stribeck_stribeck_curve]: How the level falls with speed. (default Gaussian) */
  STRIBECK_GUIDE_CONTACT_FRICTION_CURVE = 365515582,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_STRIBECK_VISCOUS_COEFFICIENT = 1198184670,
  /** tunable [N.s2/m2]: Quadratic friction coefficient; used by PoppStelter. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_QUADRATIC_COEFFICIENT = 1058495321,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 2000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_TRANSITION_SLOPE = 1048698240,
  /** fixed [stribeck_threlfall_variant]: Variant of the law. (default Printed) */
  STRIBECK_GUIDE_CONTACT_FRICTION_THRELFALL_VARIANT = 202163868,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_TRANSITION_VELOCITY = 163906394,
  /** fixed [stribeck_rooney_deravi_variant]: Variant of the law. (default Linear) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ROONEYDERAVI_VARIANT = 1956286015,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (>= 0, default 0.0001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_AMBROSIO_TRANSITION_VELOCITY = 32779198,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SLIDING_VELOCITY = 2091256599,
  /** fixed [stribeck_bengisu_akay_variant]: Variant of the law. (default Thesis) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BENGISUAKAY_VARIANT = 780083729,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 5000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BENGISUAKAY_TRANSITION_SLOPE = 1008920195,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 500) */
  STRIBECK_GUIDE_CONTACT_FRICTION_STICTION_DECAY = 197701967,
  /** tunable [s/m]: Viscous coefficient of friction, per normal force. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MU_V = 195132,
  /** tunable [s/m]: Slope of the force at rest, relative to the level there. (> 0, default 10000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ANDERSSON_TRANSITION_SLOPE = 175687589,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ANDERSSON_VISCOUS_COEFFICIENT = 451477724,
  /** tunable [s/m]: Rate at which the excess of static over kinetic friction decays with speed (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_AWREJCEWICZ_STICTION_DECAY = 1199436897,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SPECKER_TRANSITION_VELOCITY = 816843187,
  /** tunable [m/s]: Velocity at which the static level is reached (default chosen). (> 0, default 0.0005) */
  STRIBECK_GUIDE_CONTACT_FRICTION_PEAK_VELOCITY = 494732202,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SPECKER_VISCOUS_COEFFICIENT = 484229442,
  /** tunable [m/s]: Velocity at which the kinetic level is reached. (> 0, default 0.0015) */
  STRIBECK_GUIDE_CONTACT_FRICTION_LINEARSTICTION_SLIDING_VELOCITY = 1146592147,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BROWNMCPHEE_VISCOUS_COEFFICIENT = 237120135,
  /** tunable [N]: Normal force at which the viscous part is fully active (default chosen). (> 0, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_TRANSITION_NORMAL_FORCE = 804491626,
  /** tunable [1]: Exponent of the transition to sliding; below 1 brittle, from 1 on ductile. (>= 0, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ALPHA = 582116977,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_FRICTIONALLAG_VISCOUS_COEFFICIENT = 1079872672,
  /** fixed [s]: Time by which the level of friction lags behind the velocity (default chosen). (>= 0, default 0.005) */
  STRIBECK_GUIDE_CONTACT_FRICTION_TIME_LAG = 1346657113,
  /** fixed [stribeck_frictional_lag_variant]: Variant of the law. (default Delay) */
  STRIBECK_GUIDE_CONTACT_FRICTION_FRICTIONALLAG_VARIANT = 1166768751,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ARMSTRONG_VISCOUS_COEFFICIENT = 104992308,
  /** tunable [s]: Dwell time after which half of the rise of the static friction has occurred (default chosen).
   *  (>= 0, default 2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_GAMMA = 1977894676,
  /** fixed [stribeck_acceleration_source]: How the law knows whether the contact speeds up or slows down.
   *  (default Input) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ACCELERATION_SOURCE = 823206969,
  /** tunable [1]: Coefficient of friction that a contact reaches when it comes to rest; not more than mu_s (default chosen).
   *  (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MU_STOP = 1837154842,
  /** tunable [s/m]: Steepness of the curve while speeding up (default chosen). (> 0, default 500) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ACCELERATION_DECAY = 1879733450,
  /** tunable [s/m]: Steepness of the curve while slowing down (default chosen). (> 0, default 500) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DECELERATION_DECAY = 1768807973,
  /** tunable [s/m]: Steepness of the curves for speeding up and slowing down (default chosen). (> 0, default 500) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BRANCH_DECAY = 2073065670,
  /** fixed [stribeck_bliman_sorine_order]: Variant of the law. (default Second) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BLIMANSORINE_VARIANT = 583382101,
  /** tunable [1]: Level of the slow relaxation, as a coefficient of friction; second order (default calibrated).
   *  (>= 0, default 0.2732050807568877) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MU_2 = 1006800688,
  /** tunable [1]: Length of the fast relaxation as a part of that of the slow one; second order (default chosen).
   *  (> 0, <= 1, default 0.5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ETA = 1505373677,
  /** tunable [m]: Sliding distance in which the slow relaxation settles to 1/e (default calibrated).
   *  (> 0, default 4.642141842225068e-5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_EPS_F = 143280926,
  /** tunable [m]: Shear deflection of the asperities in steady sliding (default f_C / sigma_0 of the thesis).
   *  (> 0, default 9.81e-6) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DELTA_T = 626693188,
  /** tunable [1]: Part of the deflection of steady sliding up to which the contact is purely elastic.
   *  (> 0, <= 1, default 0.7) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BREAKAWAY_RATIO = 1652803556,
  /** tunable [Integer]: Exponent of the transition from elastic deflection to sliding; odd. (>= 1, <= 9, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_PLASTIC_EXPONENT = 580682845,
  /** tunable [m]: Strain at which a bristle snaps (default f_s / sigma_0 of the thesis). (> 0, default 1.4715e-5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DELTA = 2065665047,
  /** fixed [Integer]: Number of bristles (default chosen). (>= 1, <= 64, default 25) */
  STRIBECK_GUIDE_CONTACT_FRICTION_BRISTLE_COUNT = 1010238726,
  /** fixed [Integer]: Seed of the random numbers. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SEED = 1731659842,
  /** fixed [stribeck_initial_bonds]: State of the bristles when the motion starts. (default Bonded) */
  STRIBECK_GUIDE_CONTACT_FRICTION_INITIAL_BONDS = 254102368,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 0.00025) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SPECKERDYNAMIC_TRANSITION_VELOCITY = 695032766,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SPECKERDYNAMIC_VISCOUS_COEFFICIENT = 165096311,
  /** tunable [s]: Time constant of the force while sliding (default chosen). (> 0, default 0.001) */
  STRIBECK_GUIDE_CONTACT_FRICTION_SLIP_TIME = 788380435,
  /** tunable [N.s/m]: Damping of the bristles. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MAXWELLSLIP_SIGMA_1 = 1478808016,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_GUIDE_CONTACT_FRICTION_MAXWELLSLIP_VISCOUS_COEFFICIENT = 396050933,
  /** tunable [N/s]: Rate at which the slipping elements together approach their level (default chosen).
   *  (> 0, default 1000) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ATTRACTION = 1435098162,
  /** fixed [stribeck_element_distribution]: Where the shares of the elements come from. (default Explicit) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DISTRIBUTION = 21287993,
  /** fixed [Integer]: Number of elements in use (default chosen). (>= 1, <= 16, default 4) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_COUNT = 1149577601,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_1_STIFFNESS_SHARE = 1847706511,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_1_STRENGTH_SHARE = 683083159,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.25) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_2_STIFFNESS_SHARE = 1300159780,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_2_STRENGTH_SHARE = 1889862646,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.15) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_3_STIFFNESS_SHARE = 1127554717,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.3) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_3_STRENGTH_SHARE = 248847553,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_4_STIFFNESS_SHARE = 1010711754,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.4) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_4_STRENGTH_SHARE = 956173024,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_5_STIFFNESS_SHARE = 2008968323,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_5_STRENGTH_SHARE = 717020499,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_6_STIFFNESS_SHARE = 13936472,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_6_STRENGTH_SHARE = 2108675762,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_7_STIFFNESS_SHARE = 1560638401,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_7_STRENGTH_SHARE = 581810013,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_8_STIFFNESS_SHARE = 1234943678,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_8_STRENGTH_SHARE = 479727308,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_9_STIFFNESS_SHARE = 1759773319,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_9_STRENGTH_SHARE = 1583137247,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_10_STIFFNESS_SHARE = 1230619133,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_10_STRENGTH_SHARE = 523667361,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_11_STIFFNESS_SHARE = 1589235716,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_11_STRENGTH_SHARE = 1639465814,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_12_STIFFNESS_SHARE = 471692527,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_12_STRENGTH_SHARE = 398607607,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_13_STIFFNESS_SHARE = 1603765734,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_13_STRENGTH_SHARE = 2038715940,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_14_STIFFNESS_SHARE = 1071029793,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_14_STRENGTH_SHARE = 993607997,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_15_STIFFNESS_SHARE = 339576632,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_15_STRENGTH_SHARE = 1828551314,
  /** tunable [1]: Stiffness of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_16_STIFFNESS_SHARE = 1364232803,
  /** tunable [1]: Strength of the element, relative to the sum over all elements in use. (> 0, default 0.1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_ELEMENT_16_STRENGTH_SHARE = 1567232691,
  /** tunable [1]: Exponent of the approach to the steady level (default chosen). (>= 0.1, default 1) */
  STRIBECK_GUIDE_CONTACT_FRICTION_APPROACH_EXPONENT = 772972039,
  /** tunable [1]: Strength of all elements together, as a multiple of the static level; not less than 1 (default chosen).
   *  (> 0, default 1.2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_HYSTERESIS_STRENGTH = 235565580,
  /** tunable [m/s]: Velocity that sets the width of the regularised band around rest. (> 0, default 1e-5) */
  STRIBECK_GUIDE_CONTACT_FRICTION_GONTHIER_TRANSITION_VELOCITY = 2083171682,
  /** tunable [s]: Time constant with which the static level rises at rest. (> 0, default 2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_DWELL_TIME_CONSTANT = 1275370588,
  /** tunable [m/s]: Speed from which on the film grows no further (default chosen). (> 0, default 0.002) */
  STRIBECK_GUIDE_CONTACT_FRICTION_FILM_VELOCITY = 66355881,
  /** tunable [s]: Time constant of a film that grows (default chosen). (> 0, default 0.05) */
  STRIBECK_GUIDE_CONTACT_FRICTION_FILM_GROWTH_TIME_CONSTANT = 2084465472,
  /** tunable [s]: Time constant of a film that thins in motion (default chosen). (> 0, default 0.2) */
  STRIBECK_GUIDE_CONTACT_FRICTION_FILM_DECAY_TIME_CONSTANT = 1424495313,
  /** tunable [s]: Time constant of a film that is squeezed out at rest (default chosen). (> 0, default 20) */
  STRIBECK_GUIDE_CONTACT_FRICTION_FILM_REST_TIME_CONSTANT = 942996753,
  /** state [1]: States of the friction law, in SI units: its continuous states in their order. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_1 = 1672239013,
  /** state [1]: States of the friction law, in SI units: its continuous states in their order. (default 0) */
  STRIBECK_GUIDE_CONTACT_MEMORY_2 = 1672091918,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_GUIDE_CONTACT_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Axial friction force; has the sign of the velocity when sliding. */
  STRIBECK_GUIDE_CONTACT_FRICTION_FORCE = 1713976319,
  /** out [N.m]: Friction torque about the axis; has the sign of the spin rate when sliding. */
  STRIBECK_GUIDE_CONTACT_FRICTION_TORQUE = 971415098,
  /** out [W]: Power taken out of the motion. */
  STRIBECK_GUIDE_CONTACT_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_GUIDE_CONTACT_STICKING = 553311409,
} stribeck_guide_contact_variable;

/** Guid of CoilSpring for fmi2Instantiate. */
#define STRIBECK_COIL_SPRING_GUID "{1940e84a-ac92-39f7-c0de-a671c35f8e0b}"

/** CoilSpring: Coil spring with preload, linear or from a table. Variables of "CoilSpring". */
typedef enum stribeck_coil_spring_variable {
  /** in [m]: Compression from full extension. (default 0) */
  STRIBECK_COIL_SPRING_COMPRESSION = 987494389,
  /** fixed [Boolean]: Is there a spring? (default true) */
  STRIBECK_COIL_SPRING_SPRING_ENABLED = 602440755,
  /** fixed [stribeck_spring_mode]: Form of the spring's characteristic. (default Linear) */
  STRIBECK_COIL_SPRING_SPRING_MODE = 354240045,
  /** tunable [N/m]: Stiffness. (>= 0, default 45000) */
  STRIBECK_COIL_SPRING_SPRING_K = 1239346679,
  /** tunable [N]: Force at full extension (default chosen). (default 150) */
  STRIBECK_COIL_SPRING_SPRING_PRELOAD = 693664647,
  /** fixed [Integer]: Number of points of the table in use (default chosen). (>= 2, <= 16, default 3) */
  STRIBECK_COIL_SPRING_SPRING_TAB_N = 173096048,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_1 = 1626994985,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0.03) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_2 = 553028690,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0.055) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_3 = 485771119,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_4 = 486903952,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_5 = 1627583365,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_6 = 1627436270,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_7 = 486462667,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_8 = 1558751676,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_9 = 551895857,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_10 = 1632597957,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_11 = 491918544,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_12 = 491374091,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_13 = 1632450862,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_14 = 1631906409,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_15 = 491226996,
  /** tunable [m]: Compressions of the table, ascending (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_X_16 = 490785711,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_1 = 1971131151,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 1350) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_2 = 1971675604,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 2850) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_3 = 964819785,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_4 = 965364238,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_5 = 1971822699,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_6 = 1972263984,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_7 = 965511333,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_8 = 2037108794,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_9 = 896135191,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_10 = 47843055,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_11 = 115100626,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_12 = 1189066921,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_13 = 48387508,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_14 = 48534603,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_15 = 1189508206,
  /** tunable [N]: Forces of the table, without preload (default chosen). (default 0) */
  STRIBECK_COIL_SPRING_SPRING_TAB_F_16 = 1189655301,
  /** out [N]: Force of the spring; positive pushes its ends apart. */
  STRIBECK_COIL_SPRING_FORCE = 2041153668,
} stribeck_coil_spring_variable;

/** Guid of GasSpring for fmi2Instantiate. */
#define STRIBECK_GAS_SPRING_GUID "{600bb709-07c3-9d50-5c31-a25dd319a7a2}"

/** GasSpring: Gas force on the rod of a shock absorber. Variables of "GasSpring". */
typedef enum stribeck_gas_spring_variable {
  /** in [m]: Compression from full extension. (default 0) */
  STRIBECK_GAS_SPRING_COMPRESSION = 987494389,
  /** fixed [Boolean]: Is there a gas force? (default true) */
  STRIBECK_GAS_SPRING_GAS_ENABLED = 729824997,
  /** tunable [Pa]: Absolute gas pressure at full extension (default chosen). (>= 0, default 1000000) */
  STRIBECK_GAS_SPRING_GAS_P0 = 640951140,
  /** fixed [m3]: Gas volume at full extension (default chosen). (> 0, default 3e-5) */
  STRIBECK_GAS_SPRING_GAS_V0 = 444496818,
  /** fixed [1]: Polytropic exponent (default chosen). (>= 0, default 1.2) */
  STRIBECK_GAS_SPRING_GAS_N = 904392190,
  /** fixed [m]: Diameter of the rod (default chosen). (>= 0, default 0.014) */
  STRIBECK_GAS_SPRING_GAS_ROD_DIAMETER = 1130974353,
  /** tunable [Pa]: Ambient pressure. (>= 0, default 101325) */
  STRIBECK_GAS_SPRING_GAS_P_AMBIENT = 1322016071,
  /** out [N]: Gas force on the rod; positive pushes it out. */
  STRIBECK_GAS_SPRING_FORCE = 2041153668,
} stribeck_gas_spring_variable;

/** Guid of EndStops for fmi2Instantiate. */
#define STRIBECK_END_STOPS_GUID "{6107fa94-fb45-4292-a2f5-7dd0553054a9}"

/** EndStops: Bump stop and rebound stop of a shock absorber. Variables of "EndStops". */
typedef enum stribeck_end_stops_variable {
  /** in [m]: Compression from full extension. (default 0) */
  STRIBECK_END_STOPS_COMPRESSION = 987494389,
  /** in [m/s]: Velocity of extension. (default 0) */
  STRIBECK_END_STOPS_VELOCITY = 846470194,
  /** fixed [Boolean]: Is there a bump stop? (default true) */
  STRIBECK_END_STOPS_BUMP_ENABLED = 528272746,
  /** fixed [m]: Compression from full extension at which the bump stop is touched (default chosen). (default 0.04) */
  STRIBECK_END_STOPS_BUMP_GAP = 342752507,
  /** fixed [stribeck_bump_mode]: Form of the bump stop's characteristic. (default Linear) */
  STRIBECK_END_STOPS_BUMP_MODE = 262009054,
  /** tunable [N/m]: Stiffness: of the linear form, and first coefficient of the cubic one (default chosen).
   *  (>= 0, default 150000) */
  STRIBECK_END_STOPS_BUMP_K = 1950935518,
  /** tunable [1]: Exponent of the power form (default chosen). (>= 1, default 2.2) */
  STRIBECK_END_STOPS_BUMP_N = 2034823613,
  /** tunable [m]: Compression at which the power form has the force F_ref (default chosen). (> 0, default 0.01) */
  STRIBECK_END_STOPS_BUMP_X_REF = 1165900593,
  /** tunable [N]: Force of the power form at x_ref (default chosen). (>= 0, default 1500) */
  STRIBECK_END_STOPS_BUMP_F_REF = 1732261983,
  /** tunable [N/m2]: Second coefficient of the cubic form. (>= 0, default 0) */
  STRIBECK_END_STOPS_BUMP_K2 = 2059943556,
  /** tunable [N/m3]: Third coefficient of the cubic form. (>= 0, default 0) */
  STRIBECK_END_STOPS_BUMP_K3 = 2076721175,
  /** tunable [N.s/m]: Damping while the stop is touched. (>= 0, default 0) */
  STRIBECK_END_STOPS_BUMP_C = 1816714566,
  /** fixed [Boolean]: Is there a rebound stop? (default true) */
  STRIBECK_END_STOPS_REBOUND_ENABLED = 670112079,
  /** fixed [m]: Compression from full extension at which the rebound stop is touched. (default 0) */
  STRIBECK_END_STOPS_REBOUND_GAP = 931930910,
  /** tunable [N/m]: Stiffness (default chosen). (>= 0, default 1000000) */
  STRIBECK_END_STOPS_REBOUND_K = 1217846635,
  /** tunable [N.s/m]: Damping while the stop is touched. (>= 0, default 0) */
  STRIBECK_END_STOPS_REBOUND_C = 1083625683,
  /** out [N]: Force of the bump stop; positive pushes the eyes apart. */
  STRIBECK_END_STOPS_FORCE_BUMP = 1217129313,
  /** out [N]: Force of the rebound stop; negative pulls the eyes together. */
  STRIBECK_END_STOPS_FORCE_REBOUND = 1853814980,
  /** out [Boolean]: Is the bump stop touched? */
  STRIBECK_END_STOPS_BUMP_ACTIVE = 12196120,
} stribeck_end_stops_variable;

/** Guid of HydraulicDamper for fmi2Instantiate. */
#define STRIBECK_HYDRAULIC_DAMPER_GUID "{c547ac03-c0fa-01ce-4aba-b6ce12da4429}"

/** HydraulicDamper: Hydraulic damper, linear, degressive, from a table or magnetorheological. Variables of "HydraulicDamper". */
typedef enum stribeck_hydraulic_damper_variable {
  /** in [m/s]: Velocity of extension. (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_VELOCITY = 846470194,
  /** in [V]: Voltage at the current driver of the coil; used by damper.mode = MagnetorheologicalDamper.
   *  (>= 0, default 0) */
  STRIBECK_HYDRAULIC_DAMPER_VOLTAGE = 1637048165,
  /** fixed [Boolean]: Is there a damper? (default true) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_ENABLED = 653710919,
  /** fixed [stribeck_damper_mode]: Form of the damper's characteristic. (default Linear) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MODE = 1000786193,
  /** tunable [N.s/m]: Damping coefficient in compression (default chosen). (>= 0, default 1500) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_C_COMP = 1218223315,
  /** tunable [N.s/m]: Damping coefficient in extension, the rebound (default chosen). (>= 0, default 2300) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_C_REB = 1051140173,
  /** tunable [s/m]: Degression in compression. (>= 0, default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_DEGR_COMP = 191387222,
  /** tunable [s/m]: Degression in extension. (>= 0, default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_DEGR_REB = 563928450,
  /** fixed [Integer]: Number of points of the table in use (default chosen). (>= 2, <= 16, default 11) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_N = 1952893940,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_1 = 948357411,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.5) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_2 = 948901864,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.25) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_3 = 2089581277,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_4 = 1015026602,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default -0.05) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_5 = 947769031,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_6 = 2021926348,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.05) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_7 = 2088889729,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_8 = 2090714110,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.25) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_9 = 2023456539,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0.5) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_10 = 915979179,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_11 = 2057004366,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_12 = 2057151461,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_13 = 916523632,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_14 = 915390799,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_15 = 982648370,
  /** tunable [m/s]: Velocities of the table, ascending; positive in extension (default chosen). (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_V_16 = 2056563081,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -1150) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_1 = 191481363,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -700) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_2 = 192025816,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -430) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_3 = 258989197,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -210) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_4 = 1331918170,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default -110) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_5 = 190892983,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_6 = 191334268,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 180) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_7 = 1332065265,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 340) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_8 = 260122030,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 640) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_9 = 1266528907,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 950) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_10 = 1116503963,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 1500) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_11 = 1183761534,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_12 = 110192597,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_13 = 43229216,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_14 = 42096383,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_15 = 1183069986,
  /** tunable [N]: Resistances of the table, with the sign of the velocity and not decreasing (default chosen).
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_TAB_F_16 = 1183217081,
  /** fixed [stribeck_interpolation]: Curve through the points of the table. (default Linear) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_INTERPOLATION = 1084982648,
  /** tunable [1]: Factor on the damper force. (>= 0, default 1) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_SCALE = 1838924032,
  /** fixed [N/m]: Stiffness in series with the damper, of oil and top mount; 0 = rigid. (>= 0, default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_K_SERIES = 1401687841,
  /** tunable [N.s/m]: Damping at high speeds without voltage. (>= 0, default 2100) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_C_0A = 19433904,
  /** tunable [N.s/(m.V)]: Increase of the damping at high speeds with the voltage. (>= 0, default 350) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_C_0B = 69766761,
  /** tunable [N/m]: Stiffness at high speeds. (>= 0, default 4690) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_K_0 = 639419545,
  /** tunable [N.s/m]: Coefficient of the dashpot in series without voltage. (> 0, default 28300) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_C_1A = 489060141,
  /** tunable [N.s/(m.V)]: Increase of the coefficient of the dashpot in series with the voltage. (>= 0, default 295) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_C_1B = 438727284,
  /** tunable [N/m]: Stiffness of the hysteresis without voltage. (>= 0, default 14000) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_ALPHA_A = 1352302827,
  /** tunable [N/(m.V)]: Increase of the stiffness of the hysteresis with the voltage. (>= 0, default 69500) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_ALPHA_B = 1369080446,
  /** tunable [1/m2]: Form of the hysteresis: its part that acts in both directions of motion, in m^-n.
   *  (>= 0, default 3630000) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_HYSTERESIS_GAMMA = 1000379448,
  /** tunable [1/m2]: Form of the hysteresis: its part that changes sign with the motion, in m^-n; above -hysteresis_gamma.
   *  (default 3630000) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_HYSTERESIS_BETA = 490073321,
  /** tunable [1]: Slope of the evolutionary variable over the displacement where it is 0. (> 0, default 301) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_A = 181946176,
  /** tunable [1]: Exponent of the hysteresis: its transition to the saturated level is sharper if larger.
   *  (>= 1, default 2) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_N = 970494269,
  /** tunable [1/s]: Rate at which the voltage on the fluid follows that at the driver. (> 0, default 190) */
  STRIBECK_HYDRAULIC_DAMPER_DAMPER_MR_VOLTAGE_RATE = 2066688272,
  /** fixed [s]: Largest internal step (default chosen). (> 0, default 0.0001) */
  STRIBECK_HYDRAULIC_DAMPER_STEP_SIZE = 843244609,
  /** state [m/s]: Velocity of the piston behind the series stiffness; the velocity itself if there is none.
   *  (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_PISTON_VELOCITY = 1881215274,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_DISSIPATED_ENERGY = 758404530,
  /** state [m]: Displacement of the damper less that of its dashpot in series. (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_MR_SLIP = 1434598982,
  /** state [m]: Evolutionary variable of the hysteresis. (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_MR_Z = 1962930174,
  /** state [V]: Voltage that acts on the fluid. (default 0) */
  STRIBECK_HYDRAULIC_DAMPER_MR_FILTERED_VOLTAGE = 1562798738,
  /** out [N]: Force of the damper; positive pushes its ends apart. */
  STRIBECK_HYDRAULIC_DAMPER_FORCE = 2041153668,
  /** out [W]: Power taken out of the motion. */
  STRIBECK_HYDRAULIC_DAMPER_DISSIPATED_POWER = 236926875,
} stribeck_hydraulic_damper_variable;

/** Guid of DamperTemperature for fmi2Instantiate. */
#define STRIBECK_DAMPER_TEMPERATURE_GUID "{0f9cde77-96a0-c294-c83c-91ac86f9f893}"

/** Preset of DamperTemperature: Example with 50 W, heating switched on. */
#define STRIBECK_DAMPER_TEMPERATURE_PRESET_HEATING "heating"

/** DamperTemperature: Temperature of a damper and its effect on the force. Variables of "DamperTemperature". */
typedef enum stribeck_damper_temperature_variable {
  /** in [W]: Power dissipated in the damper. (default 0) */
  STRIBECK_DAMPER_TEMPERATURE_POWER = 1968120646,
  /** in [K]: Ambient temperature. (>= 0, default 293.15) */
  STRIBECK_DAMPER_TEMPERATURE_TEMPERATURE_AMBIENT = 1378166418,
  /** fixed [Boolean]: Does the temperature change and affect the damper force? (default false) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_ENABLED = 1143096615,
  /** tunable [1/K]: Relative loss of damper force per kelvin (default chosen). (>= 0, default 0.003) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_BETA = 896115256,
  /** fixed [K]: Temperature at which the damper's characteristic was measured (default chosen).
   *  (> 0, default 293.15) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_TEMPERATURE_REF = 1979371978,
  /** fixed [J/K]: Heat capacity of the damper (default chosen: 0.6 kg of aluminium and oil). (> 0, default 600) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_CAPACITY = 1977759622,
  /** tunable [W/K]: Heat flow to the surroundings per kelvin (default chosen). (>= 0, default 1.5) */
  STRIBECK_DAMPER_TEMPERATURE_THERMAL_CONDUCTANCE = 1418428113,
  /** state, out [K]: Temperature of the damper. (> 0, default 293.15) */
  STRIBECK_DAMPER_TEMPERATURE_TEMPERATURE = 1777510709,
  /** out [1]: Factor on the damper force. */
  STRIBECK_DAMPER_TEMPERATURE_FORCE_FACTOR = 1337182042,
} stribeck_damper_temperature_variable;

/** Guid of BeltRig for fmi2Instantiate. */
#define STRIBECK_BELT_RIG_GUID "{4dbd381e-7de3-7af7-278f-fee18eaadf1c}"

/** BeltRig: Block on a moving belt, held by a spring. Variables of "BeltRig". */
typedef enum stribeck_belt_rig_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_BELT_RIG_FRICTION_FORCE = 1713976319,
  /** fixed [kg]: Mass of the block. (> 0, default 1) */
  STRIBECK_BELT_RIG_MASS = 1601648849,
  /** fixed [N/m]: Stiffness of the spring. (>= 0, default 2) */
  STRIBECK_BELT_RIG_STIFFNESS = 1230999982,
  /** tunable [m/s]: Velocity of the belt. (default 0.1) */
  STRIBECK_BELT_RIG_BELT_VELOCITY = 805761162,
  /** state, out [m]: Position of the block; the spring is relaxed at 0. (default 0) */
  STRIBECK_BELT_RIG_POSITION = 323964426,
  /** state, out [m/s]: Velocity of the block. (default 0.1) */
  STRIBECK_BELT_RIG_BLOCK_VELOCITY = 27527328,
  /** out [m/s]: Velocity of the block relative to the belt. */
  STRIBECK_BELT_RIG_VELOCITY = 846470194,
  /** out [N]: Spring force on the block. */
  STRIBECK_BELT_RIG_EXTERNAL_FORCE = 1336490458,
  /** tunable [m/s2]: Acceleration of gravity. (>= 0, default 9.81) */
  STRIBECK_BELT_RIG_GRAVITY = 1376386885,
  /** out [N]: Weight of the block on the belt. */
  STRIBECK_BELT_RIG_NORMAL_FORCE = 5891938,
} stribeck_belt_rig_variable;

/** Guid of QuarterCar for fmi2Instantiate. */
#define STRIBECK_QUARTER_CAR_GUID "{515c58d7-c52d-dc00-250b-5c51cbda67fc}"

/** QuarterCar: Quarter car: body, wheel and tyre, driven by the force of a strut. Variables of "QuarterCar". */
typedef enum stribeck_quarter_car_variable {
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_QUARTER_CAR_ROAD_HEIGHT = 464235471,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_QUARTER_CAR_ROAD_VELOCITY = 716199623,
  /** in [N]: Force of the strut without its friction; only the external force depends on it. (default 1325.2555) */
  STRIBECK_QUARTER_CAR_FORCE_WITHOUT_FRICTION = 1698389154,
  /** in [N]: Part of the strut force that moves the rod and not the body; 0 if they move together. (default 0) */
  STRIBECK_QUARTER_CAR_ROD_FORCE = 1433420958,
  /** fixed [kg]: Mass of the body, without the wheels. (> 0, default 52.91) */
  STRIBECK_QUARTER_CAR_BODY_MASS = 978845638,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.011) */
  STRIBECK_QUARTER_CAR_MOTION_RATIO = 1923590475,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_QUARTER_CAR_STATIC_LENGTH = 271843360,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1325.2555) */
  STRIBECK_QUARTER_CAR_STATIC_FORCE = 368777087,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_QUARTER_CAR_WHEEL_MASS = 1406898941,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_QUARTER_CAR_TYRE_STIFFNESS = 659520257,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_QUARTER_CAR_TYRE_DAMPING = 1956649378,
  /** state, out [m]: Height of the body above its height at rest. (default 0) */
  STRIBECK_QUARTER_CAR_BODY_HEIGHT = 2147148885,
  /** state, out [m/s]: Vertical velocity of the body. (default 0) */
  STRIBECK_QUARTER_CAR_BODY_VELOCITY = 821608557,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_QUARTER_CAR_STRUT_FORCE = 1883817233,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_QUARTER_CAR_WHEEL_HEIGHT = 1220580878,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_QUARTER_CAR_WHEEL_VELOCITY = 1595595438,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_QUARTER_CAR_LENGTH = 63976981,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_QUARTER_CAR_VELOCITY = 846470194,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_QUARTER_CAR_TYRE_LOAD = 1258449592,
  /** out [N]: Force that the strut's friction must carry so that its length keeps its velocity; positive in extension. */
  STRIBECK_QUARTER_CAR_EXTERNAL_FORCE = 1336490458,
} stribeck_quarter_car_variable;

/** Guid of FourPostCar for fmi2Instantiate. */
#define STRIBECK_FOUR_POST_CAR_GUID "{abce49bb-587d-13bb-7750-5282709d5eef}"

/** FourPostCar: Car on four posts, driven by the forces of four struts. Variables of "FourPostCar". */
typedef enum stribeck_four_post_car_variable {
  /** fixed [kg]: Mass of the body, without the wheels. (> 0, default 223.2) */
  STRIBECK_FOUR_POST_CAR_BODY_MASS = 978845638,
  /** fixed [kg.m2]: Moment of inertia of the body about its lateral axis. (> 0, default 126.29) */
  STRIBECK_FOUR_POST_CAR_PITCH_INERTIA = 1899038564,
  /** fixed [kg.m2]: Moment of inertia of the body about its longitudinal axis. (> 0, default 26.46) */
  STRIBECK_FOUR_POST_CAR_ROLL_INERTIA = 1281002275,
  /** fixed [m]: Distance between the axles. (> 0, default 1.528) */
  STRIBECK_FOUR_POST_CAR_WHEELBASE = 1240602281,
  /** fixed [m]: Distance of the front axle ahead of the body's centre of gravity. (>= 0, default 0.8035) */
  STRIBECK_FOUR_POST_CAR_CG_TO_FRONT = 1103134773,
  /** state, out [m]: Height of the centre of gravity above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_HEAVE = 765446484,
  /** state, out [m/s]: Vertical velocity of the centre of gravity. (default 0) */
  STRIBECK_FOUR_POST_CAR_HEAVE_RATE = 1033019235,
  /** state, out [rad]: Pitch angle; positive nose down. (default 0) */
  STRIBECK_FOUR_POST_CAR_PITCH = 1026706097,
  /** state, out [rad/s]: Rate of the pitch angle. (default 0) */
  STRIBECK_FOUR_POST_CAR_PITCH_RATE = 362334040,
  /** state, out [rad]: Roll angle; positive lowers the right side. (default 0) */
  STRIBECK_FOUR_POST_CAR_ROLL = 385826078,
  /** state, out [rad/s]: Rate of the roll angle. (default 0) */
  STRIBECK_FOUR_POST_CAR_ROLL_RATE = 809575385,
  /** fixed [m]: Distance between the wheels of the axle. (> 0, default 1.22) */
  STRIBECK_FOUR_POST_CAR_FRONT_TRACK = 1374883633,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.011) */
  STRIBECK_FOUR_POST_CAR_FRONT_MOTION_RATIO = 136683956,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_FOUR_POST_CAR_FRONT_STATIC_LENGTH = 521595661,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1325.2555) */
  STRIBECK_FOUR_POST_CAR_FRONT_STATIC_FORCE = 1579506636,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_FOUR_POST_CAR_FRONT_WHEEL_MASS = 2014428290,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_FOUR_POST_CAR_FRONT_TYRE_STIFFNESS = 1243508938,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_FOUR_POST_CAR_FRONT_TYRE_DAMPING = 1057394425,
  /** fixed [m]: Distance between the wheels of the axle. (> 0, default 1.2) */
  STRIBECK_FOUR_POST_CAR_REAR_TRACK = 109134438,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.004) */
  STRIBECK_FOUR_POST_CAR_REAR_MOTION_RATIO = 1310894605,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_FOUR_POST_CAR_REAR_STATIC_LENGTH = 274478290,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1100.2555) */
  STRIBECK_FOUR_POST_CAR_REAR_STATIC_FORCE = 2035376845,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_FOUR_POST_CAR_REAR_WHEEL_MASS = 453317695,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_FOUR_POST_CAR_REAR_TYRE_STIFFNESS = 1566799339,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_FOUR_POST_CAR_REAR_TYRE_DAMPING = 2124865380,
  /** in [m]: Height of the post under the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_FL_POST_HEIGHT = 274384917,
  /** in [m/s]: Rate of the post's height. (default 0) */
  STRIBECK_FOUR_POST_CAR_FL_POST_VELOCITY = 1961452845,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_FOUR_POST_CAR_FL_STRUT_FORCE = 1950174495,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_FL_WHEEL_HEIGHT = 284839816,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_FL_WHEEL_VELOCITY = 748140304,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_FOUR_POST_CAR_FL_LENGTH = 425976571,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_FOUR_POST_CAR_FL_VELOCITY = 2042775332,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_FOUR_POST_CAR_FL_TYRE_LOAD = 609020926,
  /** in [m]: Height of the post under the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_FR_POST_HEIGHT = 661303035,
  /** in [m/s]: Rate of the post's height. (default 0) */
  STRIBECK_FOUR_POST_CAR_FR_POST_VELOCITY = 1779794707,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_FOUR_POST_CAR_FR_STRUT_FORCE = 1145036745,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_FR_WHEEL_HEIGHT = 1227595862,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_FR_WHEEL_VELOCITY = 4000102,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_FOUR_POST_CAR_FR_LENGTH = 1768599053,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_FOUR_POST_CAR_FR_VELOCITY = 1784115738,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_FOUR_POST_CAR_FR_TYRE_LOAD = 986607920,
  /** in [m]: Height of the post under the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_RL_POST_HEIGHT = 1381987769,
  /** in [m/s]: Rate of the post's height. (default 0) */
  STRIBECK_FOUR_POST_CAR_RL_POST_VELOCITY = 1752006529,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1100.2555) */
  STRIBECK_FOUR_POST_CAR_RL_STRUT_FORCE = 1332492523,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_RL_WHEEL_HEIGHT = 1012696308,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_RL_WHEEL_VELOCITY = 657365324,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_FOUR_POST_CAR_RL_LENGTH = 945561919,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_FOUR_POST_CAR_RL_VELOCITY = 281724872,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_FOUR_POST_CAR_RL_TYRE_LOAD = 455694498,
  /** in [m]: Height of the post under the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_RR_POST_HEIGHT = 148837671,
  /** in [m/s]: Rate of the post's height. (default 0) */
  STRIBECK_FOUR_POST_CAR_RR_POST_VELOCITY = 1657025935,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1100.2555) */
  STRIBECK_FOUR_POST_CAR_RR_STRUT_FORCE = 1214313901,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_FOUR_POST_CAR_RR_WHEEL_HEIGHT = 293458890,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_FOUR_POST_CAR_RR_WHEEL_VELOCITY = 887969770,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_FOUR_POST_CAR_RR_LENGTH = 1385823017,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_FOUR_POST_CAR_RR_VELOCITY = 1387345990,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_FOUR_POST_CAR_RR_TYRE_LOAD = 1131435484,
} stribeck_four_post_car_variable;

/** Guid of DoubleTrackCar for fmi2Instantiate. */
#define STRIBECK_DOUBLE_TRACK_CAR_GUID "{ba602b63-aeaa-fc1c-0ee5-f227b330db86}"

/** DoubleTrackCar: Double-track car steered at constant speed, with Magic Formula tyres. Variables of "DoubleTrackCar". */
typedef enum stribeck_double_track_car_variable {
  /** in [rad]: Steering angle of the front wheels; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_STEERING_ANGLE = 1595403926,
  /** fixed [kg]: Mass of the body, without the wheels. (> 0, default 223.2) */
  STRIBECK_DOUBLE_TRACK_CAR_BODY_MASS = 978845638,
  /** fixed [kg.m2]: Moment of inertia of the body about its lateral axis. (> 0, default 126.29) */
  STRIBECK_DOUBLE_TRACK_CAR_PITCH_INERTIA = 1899038564,
  /** fixed [kg.m2]: Moment of inertia of the body about its longitudinal axis. (> 0, default 26.46) */
  STRIBECK_DOUBLE_TRACK_CAR_ROLL_INERTIA = 1281002275,
  /** fixed [m]: Distance between the axles. (> 0, default 1.528) */
  STRIBECK_DOUBLE_TRACK_CAR_WHEELBASE = 1240602281,
  /** fixed [m]: Distance of the front axle ahead of the body's centre of gravity. (>= 0, default 0.8035) */
  STRIBECK_DOUBLE_TRACK_CAR_CG_TO_FRONT = 1103134773,
  /** state, out [m]: Height of the centre of gravity above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_HEAVE = 765446484,
  /** state, out [m/s]: Vertical velocity of the centre of gravity. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_HEAVE_RATE = 1033019235,
  /** state, out [rad]: Pitch angle; positive nose down. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_PITCH = 1026706097,
  /** state, out [rad/s]: Rate of the pitch angle. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_PITCH_RATE = 362334040,
  /** state, out [rad]: Roll angle; positive lowers the right side. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_ROLL = 385826078,
  /** state, out [rad/s]: Rate of the roll angle. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_ROLL_RATE = 809575385,
  /** fixed [m/s]: Forward speed. (> 0, default 20) */
  STRIBECK_DOUBLE_TRACK_CAR_SPEED = 2072037248,
  /** fixed [kg.m2]: Moment of inertia of the car about its vertical axis. (> 0, default 142.92) */
  STRIBECK_DOUBLE_TRACK_CAR_YAW_INERTIA = 33944097,
  /** fixed [m]: Height of the body's centre of gravity above the ground. (>= 0, default 0.3203) */
  STRIBECK_DOUBLE_TRACK_CAR_CG_HEIGHT = 651276491,
  /** fixed [m]: Height of the wheels' centres of gravity above the ground (default chosen). (>= 0, default 0.2) */
  STRIBECK_DOUBLE_TRACK_CAR_WHEEL_CENTRE_HEIGHT = 620499472,
  /** fixed [m]: Relaxation length: rolling distance after which the side slip has reached 63 % (default chosen).
   *  (> 0, default 0.2) */
  STRIBECK_DOUBLE_TRACK_CAR_RELAXATION_LENGTH = 1815633595,
  /** fixed [N]: Nominal load F_z0 of the set. (> 0, default 3000) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_FNOMIN = 2111094212,
  /** fixed [m]: Unloaded radius R_0 of the tyre (default chosen). (> 0, default 0.2) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_UNLOADED_RADIUS = 1815672700,
  /** fixed [m/s]: Reference speed V_0 of the rolling resistance (default chosen). (> 0, default 16.7) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LONGVL = 1681973579,
  /** fixed [1]: Scale factor of the nominal load; 700 N here, for Formula Student.
   *  (> 0, default 0.23333333333333334) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LFZO = 1173129670,
  /** fixed [1]: Scale factor of the shape of F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LCX = 493565594,
  /** fixed [1]: Scale factor of the longitudinal friction; 0.97 in the source. (> 0, default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMUX = 1978365441,
  /** fixed [1]: Scale factor of the curvature of F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LEX = 426749308,
  /** fixed [1]: Scale factor of the slip stiffness. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LKX = 494845522,
  /** fixed [1]: Scale factor of the horizontal shift of F_x; 1 in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LHX = 394032713,
  /** fixed [1]: Scale factor of the vertical shift of F_x; 1 in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LVX = 463408855,
  /** fixed [1]: Scale factor of the camber in F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LGAX = 1684445795,
  /** fixed [1]: Scale factor of the shape of F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LCY = 510343213,
  /** fixed [1]: Scale factor of the lateral friction; 0.97 in the source. (> 0, default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMUY = 1961587822,
  /** fixed [1]: Scale factor of the curvature of F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LEY = 443526927,
  /** fixed [1]: Scale factor of the cornering stiffness. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LKY = 511623141,
  /** fixed [1]: Scale factor of the horizontal shift of F_y; 1 in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LHY = 377255094,
  /** fixed [1]: Scale factor of the vertical shift of F_y; 1 in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LVY = 446631236,
  /** fixed [1]: Scale factor of the camber in F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LGAY = 1667668176,
  /** fixed [1]: Scale factor of the pneumatic trail. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LTR = 630890855,
  /** fixed [1]: Scale factor of the residual torque. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LRES = 1830992725,
  /** fixed [1]: Scale factor of the camber in M_z. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LGAZ = 1718001033,
  /** fixed [1]: Scale factor of the influence of the side slip on F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LXAL = 1839454118,
  /** fixed [1]: Scale factor of the influence of the longitudinal slip on F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LYKA = 565450120,
  /** fixed [1]: Scale factor of the side force that longitudinal slip induces. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LVYKA = 1793209748,
  /** fixed [1]: Scale factor of the moment arm of F_x. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LS = 37949558,
  /** fixed [1]: Scale factor of the overturning couple. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMX = 428132404,
  /** fixed [1]: Scale factor of the vertical shift of the overturning couple. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LVMX = 478141936,
  /** fixed [1]: Scale factor of the rolling resistance. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMY = 444910023,
  /** fixed [1]: Shape factor of F_x. (default 1.6) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PCX1 = 2017462589,
  /** fixed [1]: Longitudinal friction at the nominal load. (default 1.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDX1 = 991947616,
  /** fixed [1]: Change of the longitudinal friction with load. (default -0.04) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDX2 = 1042280473,
  /** fixed [1]: Change of the longitudinal friction with the square of camber. (default 0.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDX3 = 1025502854,
  /** fixed [1]: Curvature of F_x at the nominal load. (default 0.7) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEX1 = 1586019003,
  /** fixed [1]: Change of the curvature of F_x with load. (default -0.17) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEX2 = 1602796622,
  /** fixed [1]: Change of the curvature of F_x with the square of load. (default 0.023) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEX3 = 1619574241,
  /** fixed [1]: Change of the curvature of F_x with the sign of slip. (default -0.14) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEX4 = 1636351860,
  /** fixed [1]: Slip stiffness per load at the nominal load. (default 30.7) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKX1 = 1325314021,
  /** fixed [1]: Change of the slip stiffness with load. (default 0.27) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKX2 = 1274981164,
  /** fixed [1]: Exponent of the slip stiffness with load. (default 0.13) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKX3 = 1291758783,
  /** fixed [1]: Horizontal shift of F_x at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHX1 = 1854834788,
  /** fixed [1]: Change of the horizontal shift of F_x with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHX2 = 1905167645,
  /** fixed [1]: Vertical shift of F_x per load at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVX1 = 1746834710,
  /** fixed [1]: Change of the vertical shift of F_x with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVX2 = 1730057091,
  /** fixed [1]: Stiffness of the reduction of F_x by side slip. (default 17.4) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBX1 = 1177084756,
  /** fixed [1]: Change of the stiffness of the reduction of F_x with longitudinal slip. (default 12.9) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBX2 = 1227417613,
  /** fixed [1]: Shape factor of the reduction of F_x. (default 1.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RCX1 = 1192695631,
  /** fixed [1]: Curvature of the reduction of F_x. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_REX1 = 1779455561,
  /** fixed [1]: Change of the curvature of the reduction of F_x with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_REX2 = 1729122704,
  /** fixed [1]: Shift of the reduction of F_x. (default 0.001) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RHX1 = 745641170,
  /** fixed [1]: Shape factor of F_y. (default 1.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PCY1 = 1547836352,
  /** fixed [1]: Lateral friction at the nominal load. (default 1.2) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDY1 = 1461522269,
  /** fixed [1]: Change of the lateral friction with load. (default -0.09) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDY2 = 1411189412,
  /** fixed [1]: Change of the lateral friction with the square of camber. (default 0.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PDY3 = 1427967031,
  /** fixed [1]: Curvature of F_y at the nominal load. (default 0.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY1 = 1653276574,
  /** fixed [1]: Change of the curvature of F_y with load. (default -1.2) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY2 = 1636498955,
  /** fixed [1]: Change of the curvature of F_y with the sign of side slip. (default 0.05) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY3 = 1619721336,
  /** fixed [1]: Change of the curvature of F_y with camber and the sign of side slip. (default -8.1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY4 = 1737164669,
  /** fixed [1]: Largest cornering stiffness per nominal load; negative for these axes. (default -75.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY1 = 1392571592,
  /** fixed [1]: Load of the largest cornering stiffness per nominal load; not 0. (default 4.65) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY2 = 1442904449,
  /** fixed [1]: Change of the cornering stiffness with camber. (default -0.6) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY3 = 1426126830,
  /** fixed [1]: Horizontal shift of F_y at the nominal load. (default 0.003) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHY1 = 1787577217,
  /** fixed [1]: Change of the horizontal shift of F_y with load. (default -0.0006) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHY2 = 1737244360,
  /** fixed [1]: Change of the horizontal shift of F_y with camber. (default 0.004) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PHY3 = 1754021979,
  /** fixed [1]: Vertical shift of F_y per load at the nominal load. (default 0.04) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVY1 = 1679577139,
  /** fixed [1]: Change of the vertical shift of F_y with load. (default -0.02) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVY2 = 1696354758,
  /** fixed [1]: Change of the vertical shift of F_y with camber. (default -0.97) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVY3 = 1713132377,
  /** fixed [1]: Change of the vertical shift of F_y with camber and load. (default -0.41) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PVY4 = 1729909996,
  /** fixed [1]: Stiffness of the reduction of F_y by longitudinal slip. (default 20.6) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBY1 = 1109827185,
  /** fixed [1]: Change of the stiffness of the reduction of F_y with side slip. (default -23.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBY2 = 1059494328,
  /** fixed [1]: Side slip at which that stiffness is largest. (default 0.001) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBY3 = 1076271947,
  /** fixed [1]: Shape factor of the reduction of F_y. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RCY1 = 1259953202,
  /** fixed [1]: Curvature of the reduction of F_y. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_REY1 = 1846713132,
  /** fixed [1]: Change of the curvature of the reduction of F_y with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_REY2 = 1897045989,
  /** fixed [1]: Shift of the reduction of F_y. (default -0.02) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RHY1 = 678383599,
  /** fixed [1]: Change of the shift of the reduction of F_y with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RHY2 = 695161218,
  /** fixed [1]: Side force induced by longitudinal slip, at the nominal load. (default 0.16) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY1 = 939036997,
  /** fixed [1]: Change of the induced side force with load. (default 0.03) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY2 = 888704140,
  /** fixed [1]: Change of the induced side force with camber. (default 27.5) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY3 = 905481759,
  /** fixed [1]: Change of the induced side force with side slip. (default -29.7) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY4 = 855148902,
  /** fixed [1]: Shape factor of the induced side force. (default 0.03) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY5 = 871926521,
  /** fixed [1]: Stiffness of the induced side force. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RVY6 = 821593664,
  /** fixed [1]: Stiffness of the trail at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ1 = 1237265885,
  /** fixed [1]: Change of the stiffness of the trail with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ2 = 1186933028,
  /** fixed [1]: Change of the stiffness of the trail with the square of load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ3 = 1203710647,
  /** fixed [1]: Change of the stiffness of the trail with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ4 = 1153377790,
  /** fixed [1]: Change of the stiffness of the trail with the size of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ5 = 1170155409,
  /** fixed [1]: Stiffness of the residual torque. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ9 = 1103044933,
  /** fixed [1]: Stiffness of the residual torque per that of F_y. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QBZ10 = 83184663,
  /** fixed [1]: Shape factor of the trail. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QCZ1 = 776775486,
  /** fixed [1]: Largest trail per radius at the nominal load; 0: no trail in the source. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ1 = 1265458235,
  /** fixed [1]: Change of the largest trail with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ2 = 1282235854,
  /** fixed [1]: Change of the largest trail with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ3 = 1299013473,
  /** fixed [1]: Change of the largest trail with the square of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ4 = 1315791092,
  /** fixed [1]: Largest residual torque per radius and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ6 = 1349346330,
  /** fixed [1]: Change of the residual torque with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ7 = 1366123949,
  /** fixed [1]: Change of the residual torque with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ8 = 1114459664,
  /** fixed [1]: Change of the residual torque with camber and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ9 = 1131237283,
  /** fixed [1]: Curvature of the trail at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ1 = 1074689668,
  /** fixed [1]: Change of the curvature of the trail with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ2 = 1125022525,
  /** fixed [1]: Change of the curvature of the trail with the square of load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ3 = 1108244906,
  /** fixed [1]: Change of the curvature of the trail with side slip. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ4 = 1024356811,
  /** fixed [1]: Change of the curvature of the trail with side slip and camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QEZ5 = 1007579192,
  /** fixed [1]: Horizontal shift of the trail at the nominal load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QHZ1 = 94549815,
  /** fixed [1]: Change of the horizontal shift of the trail with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QHZ2 = 111327434,
  /** fixed [1]: Change of the horizontal shift of the trail with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QHZ3 = 128105053,
  /** fixed [1]: Change of the horizontal shift of the trail with camber and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QHZ4 = 10661720,
  /** fixed [1]: Moment arm of F_x per radius. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SSZ1 = 1780996876,
  /** fixed [1]: Change of the moment arm with F_y. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SSZ2 = 1831329733,
  /** fixed [1]: Change of the moment arm with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SSZ3 = 1814552114,
  /** fixed [1]: Change of the moment arm with camber and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SSZ4 = 1730664019,
  /** fixed [1]: Overturning couple per radius and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX1 = 1288982208,
  /** fixed [1]: Change of the overturning couple with camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX2 = 1339315065,
  /** fixed [1]: Change of the overturning couple with F_y. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX3 = 1322537446,
  /** fixed [1]: Rolling resistance per radius and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY1 = 1758608445,
  /** fixed [1]: Change of the rolling resistance with F_x. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY2 = 1708275588,
  /** fixed [1]: Change of the rolling resistance with speed. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY3 = 1725053207,
  /** fixed [1]: Change of the rolling resistance with the fourth power of speed. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY4 = 1674720350,
  /** fixed [stribeck_side]: Side that the set was measured for; tyres on the other side are mirrored. (default Left) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_SIDE = 110564140,
  /** fixed [stribeck_formula_version]: Version of the formula. (default Five) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_VERSION = 989224761,
  /** fixed [Pa]: Inflation pressure (default chosen); from version 6 on. (> 0, default 100000) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_INFLPRES = 391165364,
  /** fixed [Pa]: Nominal inflation pressure of the set (default chosen); from version 6 on. (> 0, default 100000) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_NOMPRES = 1877248653,
  /** fixed [1]: Decrease of friction with the speed of slip; from version 6 on, as all that follow.
   *  (>= 0, default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LMUV = 1877699727,
  /** fixed [1]: Scale factor of the stiffness of F_y against camber. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LKYC = 126320626,
  /** fixed [1]: Scale factor of the stiffness of M_z against camber. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_LKZC = 394321245,
  /** fixed [1]: Change of the slip stiffness with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPX1 = 1162686220,
  /** fixed [1]: Change of the slip stiffness with the square of pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPX2 = 1213019077,
  /** fixed [1]: Change of the longitudinal friction with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPX3 = 1196241458,
  /** fixed [1]: Change of the longitudinal friction with the square of pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPX4 = 1112353363,
  /** fixed [1]: Change of the stiffness of the reduction of F_x with the square of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBX3 = 1210639994,
  /** fixed [1]: Change of the curvature of F_y with the square of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PEY5 = 1720387050,
  /** fixed [1]: Shape of the cornering stiffness over load; 2 in version 5.2. (default 2) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY4 = 1476459687,
  /** fixed [1]: Change of the load of the largest cornering stiffness with the square of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY5 = 1459682068,
  /** fixed [1]: Stiffness of F_y against camber per load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY6 = 1510014925,
  /** fixed [1]: Change of the stiffness against camber with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PKY7 = 1493237306,
  /** fixed [1]: Change of the cornering stiffness with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPY1 = 1095428649,
  /** fixed [1]: Change of the load of the largest cornering stiffness with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPY2 = 1045095792,
  /** fixed [1]: Change of the lateral friction with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPY3 = 1061873411,
  /** fixed [1]: Change of the lateral friction with the square of pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPY4 = 1145761506,
  /** fixed [1]: Change of the stiffness against camber with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPY5 = 1162539125,
  /** fixed [1]: Change of the stiffness of the reduction of F_y with the square of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RBY4 = 1160160042,
  /** fixed [1]: Change of the trail with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPZ1 = 1497944410,
  /** fixed [1]: Change of the residual torque by camber with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPZ2 = 1481166791,
  /** fixed [1]: Change of the residual torque with camber times its size. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ10 = 1210574161,
  /** fixed [1]: Change of the residual torque with camber times its size, and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QDZ11 = 1193796542,
  /** fixed [1]: Change of the overturning couple by camber with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PPMX1 = 1650135377,
  /** fixed [1]: Overturning couple of load, lateral force and camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX4 = 1372870303,
  /** fixed [1]: Change of that couple with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX5 = 1356092684,
  /** fixed [1]: Load in that change. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX6 = 1406425541,
  /** fixed [1]: Camber in that couple. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX7 = 1389647922,
  /** fixed [1]: Lateral force in that couple. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX8 = 1439980779,
  /** fixed [1]: Stiffness of the lateral force in that couple. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX9 = 1423203160,
  /** fixed [1]: Overturning couple of load and camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX10 = 1647854544,
  /** fixed [1]: Load in that couple. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX11 = 1664632163,
  /** fixed [1]: Overturning couple of camber times its size. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX12 = 1681409782,
  /** fixed [1]: Overturning couple per radius and lateral force. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX13 = 1698187401,
  /** fixed [1]: Change of that couple with the size of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSX14 = 1714965020,
  /** fixed [1]: Change of the rolling resistance with the square of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY5 = 1691497969,
  /** fixed [1]: Change of the rolling resistance with the square of camber and load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY6 = 1641165112,
  /** fixed [1]: Exponent of the load in the rolling resistance; 1 in version 5.2. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY7 = 1657942731,
  /** fixed [1]: Exponent of the pressure in the rolling resistance. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_QSY8 = 1607609874,
  /** fixed [1]: Free radius at rest per unloaded radius. (default 1) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_RE0 = 1244817082,
  /** fixed [1]: Growth of the free radius with the square of speed. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_V1 = 119224678,
  /** fixed [1]: Growth of the vertical stiffness with speed. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_V2 = 102447059,
  /** fixed [1]: Growth of the vertical stiffness with deflection. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_FZ2 = 1564862091,
  /** fixed [1]: Decrease of the vertical stiffness with the longitudinal force. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_FCX = 285724584,
  /** fixed [1]: Decrease of the vertical stiffness with the lateral force. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_FCY = 302502203,
  /** fixed [1]: Exponent of the deflection in that decrease; from version 6.2 on. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_FCY2 = 1800278315,
  /** fixed [1]: Change of the vertical stiffness with the square of camber; in version 6.1. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_CAM = 1344790878,
  /** fixed [1]: Deflection by camber with the loaded radius; from version 6.2 on, as those that follow. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_CAM1 = 499638717,
  /** fixed [1/m]: Deflection by camber with the square of the loaded radius. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_CAM2 = 449305860,
  /** fixed [1]: Decrease of the deflection with the size of camber. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_CAM3 = 466083479,
  /** fixed [N]: Lateral force by camber that does not soften the tyre. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_FYS1 = 1950502114,
  /** fixed [N]: Its change with the loaded radius. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_FYS2 = 1933724495,
  /** fixed [N]: Its change with the square of the loaded radius. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_Q_FYS3 = 1916946876,
  /** fixed [1]: Change of the vertical stiffness with pressure. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_PFZ1 = 606864888,
  /** fixed [1]: Stiffness of the effective radius at small loads. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_BREFF = 1061372850,
  /** fixed [1]: Level of the decrease of the effective radius at small loads. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_DREFF = 1177791368,
  /** fixed [1]: Decrease of the effective radius with load. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_FREFF = 1725838766,
  /** fixed [m]: Distance from the rim at which the tyre bottoms. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_BOTTOM_OFFST = 865986957,
  /** fixed [N/m]: Stiffness of the bottomed tyre; 0 without bottoming. (>= 0, default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_BOTTOM_STIFF = 1499032857,
  /** fixed [m]: Radius of the rim. (>= 0, default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_RIM_RADIUS = 374156132,
  /** fixed [m]: Width of the tyre's section. (>= 0, default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_WIDTH = 1959451769,
  /** fixed [1]: Height of the tyre's section per width. (>= 0, default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_TYRE_ASPECT_RATIO = 444224415,
  /** state, out [m]: Position of the car's centre of gravity along the road. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_POSITION_X = 1501920533,
  /** state, out [m]: Lateral position of the car's centre of gravity; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_POSITION_Y = 1485142914,
  /** state, out [rad]: Yaw angle; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_YAW_ANGLE = 427621832,
  /** state, out [m/s]: Lateral velocity of the car's centre of gravity; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_LATERAL_VELOCITY = 1614058446,
  /** state, out [rad/s]: Yaw rate; positive to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_YAW_RATE = 1529646967,
  /** out [m/s2]: Lateral acceleration of the car's centre of gravity; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_LATERAL_ACCELERATION = 810413313,
  /** fixed [m]: Height of the roll centre above the ground. (default 0.035) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_ROLL_CENTRE_HEIGHT = 75337661,
  /** fixed [m]: Distance between the wheels of the axle. (> 0, default 1.22) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_TRACK = 1374883633,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.011) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_MOTION_RATIO = 136683956,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_STATIC_LENGTH = 521595661,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1325.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_STATIC_FORCE = 1579506636,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_WHEEL_MASS = 2014428290,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_TYRE_STIFFNESS = 1243508938,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_DOUBLE_TRACK_CAR_FRONT_TYRE_DAMPING = 1057394425,
  /** fixed [m]: Height of the roll centre above the ground. (default 0.05) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_ROLL_CENTRE_HEIGHT = 1384047556,
  /** fixed [m]: Distance between the wheels of the axle. (> 0, default 1.2) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_TRACK = 109134438,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.004) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_MOTION_RATIO = 1310894605,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_STATIC_LENGTH = 274478290,
  /** fixed [N]: Force of the strut at rest; its spring seat is assumed to be set so that this force balances the weight.
   *  (default 1100.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_STATIC_FORCE = 2035376845,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_WHEEL_MASS = 453317695,
  /** fixed [N/m]: Stiffness of the tyre. (>= 0, default 87563.5) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_TYRE_STIFFNESS = 1566799339,
  /** fixed [N.s/m]: Damping of the tyre. (>= 0, default 95.8) */
  STRIBECK_DOUBLE_TRACK_CAR_REAR_TYRE_DAMPING = 2124865380,
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_ROAD_HEIGHT = 230411849,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_ROAD_VELOCITY = 1537419281,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_STRUT_FORCE = 1950174495,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_WHEEL_HEIGHT = 284839816,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_WHEEL_VELOCITY = 748140304,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_LENGTH = 425976571,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_VELOCITY = 2042775332,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_TYRE_LOAD = 609020926,
  /** state, out [rad]: Side slip of the tyre; positive when the wheel slips to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FL_SIDE_SLIP = 722613819,
  /** out [N]: Lateral force of the road on the tyre; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_LATERAL_FORCE = 988510250,
  /** out [m]: Vertical deflection of the tyre. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_TYRE_DEFLECTION = 1644518725,
  /** out [m]: Radius of the tyre under its load; 0 if the formula carries no such load. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_LOADED_RADIUS = 1579033125,
  /** out [m]: Effective rolling radius of the tyre; 0 if the formula carries no such load. */
  STRIBECK_DOUBLE_TRACK_CAR_FL_EFFECTIVE_RADIUS = 1901862391,
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_ROAD_HEIGHT = 1016625143,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_ROAD_VELOCITY = 250906847,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1325.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_STRUT_FORCE = 1145036745,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_WHEEL_HEIGHT = 1227595862,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_WHEEL_VELOCITY = 4000102,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_LENGTH = 1768599053,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_VELOCITY = 1784115738,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_TYRE_LOAD = 986607920,
  /** state, out [rad]: Side slip of the tyre; positive when the wheel slips to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_FR_SIDE_SLIP = 39731741,
  /** out [N]: Lateral force of the road on the tyre; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_LATERAL_FORCE = 683113520,
  /** out [m]: Vertical deflection of the tyre. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_TYRE_DEFLECTION = 1192316363,
  /** out [m]: Radius of the tyre under its load; 0 if the formula carries no such load. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_LOADED_RADIUS = 2041634659,
  /** out [m]: Effective rolling radius of the tyre; 0 if the formula carries no such load. */
  STRIBECK_DOUBLE_TRACK_CAR_FR_EFFECTIVE_RADIUS = 1726338141,
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_ROAD_HEIGHT = 531434269,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_ROAD_VELOCITY = 480403749,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1100.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_STRUT_FORCE = 1332492523,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_WHEEL_HEIGHT = 1012696308,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_WHEEL_VELOCITY = 657365324,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_LENGTH = 945561919,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_VELOCITY = 281724872,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_TYRE_LOAD = 455694498,
  /** state, out [rad]: Side slip of the tyre; positive when the wheel slips to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RL_SIDE_SLIP = 1421136959,
  /** out [N]: Lateral force of the road on the tyre; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_LATERAL_FORCE = 1844363550,
  /** out [m]: Vertical deflection of the tyre. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_TYRE_DEFLECTION = 970568609,
  /** out [m]: Radius of the tyre under its load; 0 if the formula carries no such load. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_LOADED_RADIUS = 1565353081,
  /** out [m]: Effective rolling radius of the tyre; 0 if the formula carries no such load. */
  STRIBECK_DOUBLE_TRACK_CAR_RL_EFFECTIVE_RADIUS = 610979139,
  /** in [m]: Height of the road under the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_ROAD_HEIGHT = 529359059,
  /** in [m/s]: Rate of the road's height. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_ROAD_VELOCITY = 1818239387,
  /** in [N]: Force of the strut; positive pushes its eyes apart. (default 1100.2555) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_STRUT_FORCE = 1214313901,
  /** state, out [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_WHEEL_HEIGHT = 293458890,
  /** state, out [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_WHEEL_VELOCITY = 887969770,
  /** out [m]: Length of the strut, eye to eye. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_LENGTH = 1385823017,
  /** out [m/s]: Rate of the strut's length; positive as it extends. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_VELOCITY = 1387345990,
  /** out [N]: Vertical force of the tyre on the ground; 0 while the wheel is off the ground. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_TYRE_LOAD = 1131435484,
  /** state, out [rad]: Side slip of the tyre; positive when the wheel slips to the left. (default 0) */
  STRIBECK_DOUBLE_TRACK_CAR_RR_SIDE_SLIP = 201694665,
  /** out [N]: Lateral force of the road on the tyre; positive to the left. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_LATERAL_FORCE = 1961338476,
  /** out [m]: Vertical deflection of the tyre. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_TYRE_DEFLECTION = 659494175,
  /** out [m]: Radius of the tyre under its load; 0 if the formula carries no such load. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_LOADED_RADIUS = 1662254959,
  /** out [m]: Effective rolling radius of the tyre; 0 if the formula carries no such load. */
  STRIBECK_DOUBLE_TRACK_CAR_RR_EFFECTIVE_RADIUS = 698408881,
} stribeck_double_track_car_variable;

/** Guid of Posts for fmi2Instantiate. */
#define STRIBECK_POSTS_GUID "{9cf74dd5-8d05-60ef-a610-a20f57e55eed}"

/** Posts: Four-post rig. Variables of "Posts". */
typedef enum stribeck_posts_variable {
  /** out [m]: Height of the post under the wheel. */
  STRIBECK_POSTS_FL_POST_HEIGHT = 274384917,
  /** out [m/s]: Rate of the post's height. */
  STRIBECK_POSTS_FL_POST_VELOCITY = 1961452845,
  /** fixed [m]: Travel of the post, lowest to highest. (>= 0, default 0.04) */
  STRIBECK_POSTS_FL_TRAVEL = 1955381207,
  /** fixed [rad]: Phase lag of the post; it rests until then. (>= 0, default 0) */
  STRIBECK_POSTS_FL_PHASE = 733071070,
  /** out [m]: Height of the post under the wheel. */
  STRIBECK_POSTS_FR_POST_HEIGHT = 661303035,
  /** out [m/s]: Rate of the post's height. */
  STRIBECK_POSTS_FR_POST_VELOCITY = 1779794707,
  /** fixed [m]: Travel of the post, lowest to highest. (>= 0, default 0.04) */
  STRIBECK_POSTS_FR_TRAVEL = 808556209,
  /** fixed [rad]: Phase lag of the post; it rests until then. (>= 0, default 0) */
  STRIBECK_POSTS_FR_PHASE = 934055616,
  /** out [m]: Height of the post under the wheel. */
  STRIBECK_POSTS_RL_POST_HEIGHT = 1381987769,
  /** out [m/s]: Rate of the post's height. */
  STRIBECK_POSTS_RL_POST_VELOCITY = 1752006529,
  /** fixed [m]: Travel of the post, lowest to highest. (>= 0, default 0.04) */
  STRIBECK_POSTS_RL_TRAVEL = 28366115,
  /** fixed [rad]: Phase lag of the post; it rests until then. (>= 0, default 1.5707963267948966) */
  STRIBECK_POSTS_RL_PHASE = 184083626,
  /** out [m]: Height of the post under the wheel. */
  STRIBECK_POSTS_RR_POST_HEIGHT = 148837671,
  /** out [m/s]: Rate of the post's height. */
  STRIBECK_POSTS_RR_POST_VELOCITY = 1657025935,
  /** fixed [m]: Travel of the post, lowest to highest. (>= 0, default 0.04) */
  STRIBECK_POSTS_RR_TRAVEL = 1105902741,
  /** fixed [rad]: Phase lag of the post; it rests until then. (>= 0, default 1.5707963267948966) */
  STRIBECK_POSTS_RR_PHASE = 1639110436,
  /** tunable [Hz]: Frequency of the strokes. (>= 0, default 2) */
  STRIBECK_POSTS_FREQUENCY = 800267265,
  /** state [rad]: Angle of the drive. (default 0) */
  STRIBECK_POSTS_ANGLE = 760497176,
} stribeck_posts_variable;

/** Guid of BeltDrive for fmi2Instantiate. */
#define STRIBECK_BELT_DRIVE_GUID "{411c432b-48f1-ae7c-1ad7-7fe582974656}"

/** BeltDrive: Block on a belt of prescribed motion, held by a spring. Variables of "BeltDrive". */
typedef enum stribeck_belt_drive_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_BELT_DRIVE_FRICTION_FORCE = 1713976319,
  /** in [m/s]: Velocity of the belt. (default 0.1) */
  STRIBECK_BELT_DRIVE_BELT_VELOCITY = 805761162,
  /** in [m/s2]: Acceleration of the belt. (default 0) */
  STRIBECK_BELT_DRIVE_BELT_ACCELERATION = 898572181,
  /** fixed [kg]: Mass of the block. (> 0, default 1) */
  STRIBECK_BELT_DRIVE_MASS = 1601648849,
  /** fixed [N/m]: Stiffness of the spring. (>= 0, default 2) */
  STRIBECK_BELT_DRIVE_STIFFNESS = 1230999982,
  /** tunable [m/s2]: Acceleration of gravity. (>= 0, default 9.81) */
  STRIBECK_BELT_DRIVE_GRAVITY = 1376386885,
  /** state, out [m]: Position of the block; the spring is relaxed at 0. (default 0) */
  STRIBECK_BELT_DRIVE_POSITION = 323964426,
  /** state, out [m/s]: Velocity of the block. (default 0.1) */
  STRIBECK_BELT_DRIVE_BLOCK_VELOCITY = 27527328,
  /** out [m/s]: Velocity of the block relative to the belt. */
  STRIBECK_BELT_DRIVE_VELOCITY = 846470194,
  /** out [N]: Spring force and force of inertia on the block, in the frame of the belt. */
  STRIBECK_BELT_DRIVE_EXTERNAL_FORCE = 1336490458,
  /** out [N]: Weight of the block on the belt. */
  STRIBECK_BELT_DRIVE_NORMAL_FORCE = 5891938,
} stribeck_belt_drive_variable;

/** Guid of TwoBlocks for fmi2Instantiate. */
#define STRIBECK_TWO_BLOCKS_GUID "{30f132e3-07c3-dd14-7057-d55cfd26e56e}"

/** TwoBlocks: Two blocks, one on the other, under forces and on springs. Variables of "TwoBlocks". */
typedef enum stribeck_two_blocks_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_TWO_BLOCKS_FRICTION_FORCE = 1713976319,
  /** in [N]: Force on block 1. (default 0) */
  STRIBECK_TWO_BLOCKS_FORCE_1 = 1954007504,
  /** in [N]: Force on block 2. (default 0) */
  STRIBECK_TWO_BLOCKS_FORCE_2 = 2004340361,
  /** fixed [kg]: Mass of block 1, which lies on block 2. (> 0, default 1) */
  STRIBECK_TWO_BLOCKS_MASS_1 = 787884897,
  /** fixed [kg]: Mass of block 2 (default chosen). (> 0, default 2) */
  STRIBECK_TWO_BLOCKS_MASS_2 = 737552040,
  /** fixed [N/m]: Stiffness of the spring from block 1 to the ground; 0 = none. (>= 0, default 0) */
  STRIBECK_TWO_BLOCKS_STIFFNESS_1 = 2090965782,
  /** fixed [N/m]: Stiffness of the spring from block 2 to the ground; 0 = none. (>= 0, default 0) */
  STRIBECK_TWO_BLOCKS_STIFFNESS_2 = 2074188163,
  /** tunable [m/s2]: Acceleration of gravity. (>= 0, default 9.81) */
  STRIBECK_TWO_BLOCKS_GRAVITY = 1376386885,
  /** state, out [m]: Position of block 1; its spring is relaxed at 0. (default 0) */
  STRIBECK_TWO_BLOCKS_POSITION_1 = 545647834,
  /** state, out [m/s]: Velocity of block 1. (default 0) */
  STRIBECK_TWO_BLOCKS_VELOCITY_1 = 2097525330,
  /** state, out [m]: Position of block 2; its spring is relaxed at 0. (default 0) */
  STRIBECK_TWO_BLOCKS_POSITION_2 = 528870215,
  /** state, out [m/s]: Velocity of block 2. (default 0) */
  STRIBECK_TWO_BLOCKS_VELOCITY_2 = 2080747711,
  /** out [m/s]: Velocity of block 1 relative to block 2. */
  STRIBECK_TWO_BLOCKS_VELOCITY = 846470194,
  /** out [N]: Force that the contact must carry so that both blocks move together. */
  STRIBECK_TWO_BLOCKS_EXTERNAL_FORCE = 1336490458,
  /** out [N]: Weight of block 1 on block 2. */
  STRIBECK_TWO_BLOCKS_NORMAL_FORCE = 5891938,
  /** out [kg]: Effective mass of the relative motion. */
  STRIBECK_TWO_BLOCKS_EFFECTIVE_MASS = 633907963,
} stribeck_two_blocks_variable;

/** Guid of Incline for fmi2Instantiate. */
#define STRIBECK_INCLINE_GUID "{becf5482-a421-f9f9-1c1c-6b9a9a05ff81}"

/** Incline: Block on an inclined plane. Variables of "Incline". */
typedef enum stribeck_incline_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_INCLINE_FRICTION_FORCE = 1713976319,
  /** in [rad]: Angle of the plane above the horizontal. (>= -1.5707963267948966, <= 1.5707963267948966, default 0) */
  STRIBECK_INCLINE_ANGLE = 760497176,
  /** fixed [kg]: Mass of the block. (> 0, default 1) */
  STRIBECK_INCLINE_MASS = 1601648849,
  /** tunable [m/s2]: Acceleration of gravity. (>= 0, default 9.81) */
  STRIBECK_INCLINE_GRAVITY = 1376386885,
  /** state, out [m]: Position of the block, positive down the slope. (default 0) */
  STRIBECK_INCLINE_POSITION = 323964426,
  /** state, out [m/s]: Velocity of the block, positive down the slope. (default 0) */
  STRIBECK_INCLINE_VELOCITY = 846470194,
  /** out [N]: Weight of the block along the plane. */
  STRIBECK_INCLINE_EXTERNAL_FORCE = 1336490458,
  /** out [N]: Weight of the block across the plane. */
  STRIBECK_INCLINE_NORMAL_FORCE = 5891938,
} stribeck_incline_variable;

/** Guid of PulledMass for fmi2Instantiate. */
#define STRIBECK_PULLED_MASS_GUID "{86ce4f8e-f547-17b9-743b-030eb3eeea48}"

/** PulledMass: Mass pulled by a spring. Variables of "PulledMass". */
typedef enum stribeck_pulled_mass_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_PULLED_MASS_FRICTION_FORCE = 1713976319,
  /** in [m/s]: Velocity of the end of the spring (default chosen). (default 0.1) */
  STRIBECK_PULLED_MASS_PULL_VELOCITY = 1105717764,
  /** fixed [kg]: Mass. (> 0, default 1) */
  STRIBECK_PULLED_MASS_MASS = 1601648849,
  /** fixed [N/m]: Stiffness of the spring (default chosen). (>= 0, default 2) */
  STRIBECK_PULLED_MASS_STIFFNESS = 1230999982,
  /** fixed [N.s/m]: Damping beside the spring. (>= 0, default 0) */
  STRIBECK_PULLED_MASS_DAMPING = 996259989,
  /** fixed [N]: Force of the spring where its elongation is 0. (default 0) */
  STRIBECK_PULLED_MASS_PRELOAD = 1930668294,
  /** tunable [m/s2]: Acceleration of gravity. (>= 0, default 9.81) */
  STRIBECK_PULLED_MASS_GRAVITY = 1376386885,
  /** state, out [m]: Position of the mass. (default 0) */
  STRIBECK_PULLED_MASS_POSITION = 323964426,
  /** state, out [m/s]: Velocity of the mass. (default 0) */
  STRIBECK_PULLED_MASS_VELOCITY = 846470194,
  /** state, out [m]: Elongation of the spring. (default 0) */
  STRIBECK_PULLED_MASS_ELONGATION = 1909885199,
  /** out [N]: Force of spring and damper on the mass. */
  STRIBECK_PULLED_MASS_EXTERNAL_FORCE = 1336490458,
  /** out [N]: Weight of the mass. */
  STRIBECK_PULLED_MASS_NORMAL_FORCE = 5891938,
} stribeck_pulled_mass_variable;

/** Guid of Axis for fmi2Instantiate. */
#define STRIBECK_AXIS_GUID "{373cf8b6-a02e-a57e-2bf2-71a6009ad998}"

/** Axis: Axis of a machine, moved by the force of its drive. Variables of "Axis". */
typedef enum stribeck_axis_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_AXIS_FRICTION_FORCE = 1713976319,
  /** in [N]: Force of the drive, as it is measured. (default 0) */
  STRIBECK_AXIS_DRIVE_FORCE = 2046763563,
  /** fixed [kg]: Mass that moves. (> 0, default 95.1089) */
  STRIBECK_AXIS_MASS = 1601648849,
  /** tunable [N]: Part of the measured force that moves nothing. (default 0) */
  STRIBECK_AXIS_OFFSET = 348705738,
  /** tunable [N]: Sum of the normal forces of the guides (default chosen: a coefficient of friction is then a force in N).
   *  (>= 0, default 1) */
  STRIBECK_AXIS_GUIDE_FORCE = 2018901519,
  /** state, out [m]: Position of the slide. (default 0) */
  STRIBECK_AXIS_POSITION = 323964426,
  /** state, out [m/s]: Velocity of the slide. (default 0) */
  STRIBECK_AXIS_VELOCITY = 846470194,
  /** out [N]: Force that moves the slide. */
  STRIBECK_AXIS_EXTERNAL_FORCE = 1336490458,
  /** out [N]: Sum of the normal forces of the guides. */
  STRIBECK_AXIS_NORMAL_FORCE = 5891938,
} stribeck_axis_variable;

/** Guid of ServoArm for fmi2Instantiate. */
#define STRIBECK_SERVO_ARM_GUID "{81ee24ad-33f5-7916-c33f-aa356135d5ad}"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-106, model M1. */
#define STRIBECK_SERVO_ARM_PRESET_MX106_M1 "mx106_m1"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-106, model M2. */
#define STRIBECK_SERVO_ARM_PRESET_MX106_M2 "mx106_m2"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-106, model M3. */
#define STRIBECK_SERVO_ARM_PRESET_MX106_M3 "mx106_m3"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-106, model M4. */
#define STRIBECK_SERVO_ARM_PRESET_MX106_M4 "mx106_m4"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-106, model M5. */
#define STRIBECK_SERVO_ARM_PRESET_MX106_M5 "mx106_m5"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-106, model M6. */
#define STRIBECK_SERVO_ARM_PRESET_MX106_M6 "mx106_m6"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-64, model M1. */
#define STRIBECK_SERVO_ARM_PRESET_MX64_M1 "mx64_m1"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-64, model M2. */
#define STRIBECK_SERVO_ARM_PRESET_MX64_M2 "mx64_m2"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-64, model M3. */
#define STRIBECK_SERVO_ARM_PRESET_MX64_M3 "mx64_m3"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-64, model M4. */
#define STRIBECK_SERVO_ARM_PRESET_MX64_M4 "mx64_m4"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-64, model M5. */
#define STRIBECK_SERVO_ARM_PRESET_MX64_M5 "mx64_m5"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel MX-64, model M6. */
#define STRIBECK_SERVO_ARM_PRESET_MX64_M6 "mx64_m6"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-320, model M1. */
#define STRIBECK_SERVO_ARM_PRESET_XL320_M1 "xl320_m1"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-320, model M2. */
#define STRIBECK_SERVO_ARM_PRESET_XL320_M2 "xl320_m2"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-320, model M3. */
#define STRIBECK_SERVO_ARM_PRESET_XL320_M3 "xl320_m3"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-320, model M4. */
#define STRIBECK_SERVO_ARM_PRESET_XL320_M4 "xl320_m4"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-320, model M5. */
#define STRIBECK_SERVO_ARM_PRESET_XL320_M5 "xl320_m5"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-320, model M6. */
#define STRIBECK_SERVO_ARM_PRESET_XL320_M6 "xl320_m6"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-330, model M1. */
#define STRIBECK_SERVO_ARM_PRESET_XL330_M1 "xl330_m1"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-330, model M2. */
#define STRIBECK_SERVO_ARM_PRESET_XL330_M2 "xl330_m2"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-330, model M3. */
#define STRIBECK_SERVO_ARM_PRESET_XL330_M3 "xl330_m3"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-330, model M4. */
#define STRIBECK_SERVO_ARM_PRESET_XL330_M4 "xl330_m4"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-330, model M5. */
#define STRIBECK_SERVO_ARM_PRESET_XL330_M5 "xl330_m5"

/** Preset of ServoArm: Rhoban/bam (2026), see Duclusaud et al. (2025), motor of Dynamixel XL-330, model M6. */
#define STRIBECK_SERVO_ARM_PRESET_XL330_M6 "xl330_m6"

/** ServoArm: Arm with a load, held by a servo. Variables of "ServoArm". */
typedef enum stribeck_servo_arm_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_SERVO_ARM_FRICTION_FORCE = 1713976319,
  /** in [rad]: Angle that the arm should have. (default 0) */
  STRIBECK_SERVO_ARM_TARGET_ANGLE = 655805416,
  /** tunable [V/rad]: Gain of the controller: voltage by the error of the angle. (>= 0, default 75.84) */
  STRIBECK_SERVO_ARM_GAIN = 458499838,
  /** tunable [V]: Largest voltage of the motor, in both directions. (>= 0, default 14.44) */
  STRIBECK_SERVO_ARM_VOLTAGE_LIMIT = 556240253,
  /** fixed [N.m/A]: Torque of the gear by the current of the motor, and voltage of the motor by the angular velocity of the gear.
   *  (>= 0, default 2.231) */
  STRIBECK_SERVO_ARM_MOTOR_CONSTANT = 2042307859,
  /** fixed [Ohm]: Resistance of the motor. (> 0, default 2.372) */
  STRIBECK_SERVO_ARM_RESISTANCE = 364324608,
  /** fixed [kg.m2]: Moment of inertia of rotor and gear at the output. (> 0, default 0.02457) */
  STRIBECK_SERVO_ARM_ARMATURE = 601504686,
  /** fixed [kg]: Mass at the end of the arm (default chosen). (>= 0, default 0.5) */
  STRIBECK_SERVO_ARM_LOAD_MASS = 1317756706,
  /** fixed [m]: Length of the arm (default chosen). (>= 0, default 0.2) */
  STRIBECK_SERVO_ARM_ARM_LENGTH = 786609978,
  /** fixed [m]: Radius at which forces and velocity are counted. (> 0, default 1) */
  STRIBECK_SERVO_ARM_RADIUS = 230313139,
  /** tunable [m/s2]: Acceleration of gravity. (>= 0, default 9.81) */
  STRIBECK_SERVO_ARM_GRAVITY = 1376386885,
  /** state, out [rad]: Angle of the arm; 0 if it hangs down. (default 0) */
  STRIBECK_SERVO_ARM_ANGLE = 760497176,
  /** state, out [m/s]: Velocity at the radius. (default 0) */
  STRIBECK_SERVO_ARM_VELOCITY = 846470194,
  /** out [N]: Force of the motor at the radius. */
  STRIBECK_SERVO_ARM_MOTOR_FORCE = 1103735874,
  /** out [N]: Weight of the load, at the radius. */
  STRIBECK_SERVO_ARM_LOAD_FORCE = 1613682665,
  /** out [N]: Sum of the forces of motor and load. */
  STRIBECK_SERVO_ARM_EXTERNAL_FORCE = 1336490458,
  /** out [kg]: Moment of inertia of drive and load, as a mass at the radius. */
  STRIBECK_SERVO_ARM_EFFECTIVE_MASS = 633907963,
} stribeck_servo_arm_variable;

/** Guid of TopMount for fmi2Instantiate. */
#define STRIBECK_TOP_MOUNT_GUID "{59d80aa7-dbae-e951-51f9-fadc96a3f0a4}"

/** TopMount: Inner part of a top mount, between a strut and the rubber to the body. Variables of "TopMount". */
typedef enum stribeck_top_mount_variable {
  /** in [N]: Force of the strut. (default 1325.2555) */
  STRIBECK_TOP_MOUNT_STRUT_FORCE = 1883817233,
  /** in [N]: Force of the strut without its friction; only the external force depends on it. (default 1325.2555) */
  STRIBECK_TOP_MOUNT_FORCE_WITHOUT_FRICTION = 1698389154,
  /** in [N]: Force of the rubber, 0 at rest; pushes the inner part back where it is displaced. (default 0) */
  STRIBECK_TOP_MOUNT_MOUNT_FORCE = 1043420746,
  /** in [m]: Height of the body above its height at rest. (default 0) */
  STRIBECK_TOP_MOUNT_BODY_HEIGHT = 2147148885,
  /** in [m/s]: Vertical velocity of the body. (default 0) */
  STRIBECK_TOP_MOUNT_BODY_VELOCITY = 821608557,
  /** in [m]: Height of the wheel above its height at rest. (default 0) */
  STRIBECK_TOP_MOUNT_WHEEL_HEIGHT = 1220580878,
  /** in [m/s]: Vertical velocity of the wheel. (default 0) */
  STRIBECK_TOP_MOUNT_WHEEL_VELOCITY = 1595595438,
  /** in [N]: Vertical force of the tyre on the ground; only the external force depends on it.
   *  (>= 0, default 679.5387) */
  STRIBECK_TOP_MOUNT_TYRE_LOAD = 1258449592,
  /** fixed [kg]: Mass of the inner part, with the rod of the strut (default chosen). (> 0, default 0.3) */
  STRIBECK_TOP_MOUNT_MASS = 1601648849,
  /** fixed [kg]: Mass of the body, without the wheels. (> 0, default 52.91) */
  STRIBECK_TOP_MOUNT_BODY_MASS = 978845638,
  /** fixed [kg]: Unsprung mass of the corner. (> 0, default 16.36) */
  STRIBECK_TOP_MOUNT_WHEEL_MASS = 1406898941,
  /** fixed [1]: Damper travel per wheel travel. (> 0, default 1.011) */
  STRIBECK_TOP_MOUNT_MOTION_RATIO = 1923590475,
  /** fixed [m]: Length of the strut at rest, eye to eye. (> 0, default 0.1775) */
  STRIBECK_TOP_MOUNT_STATIC_LENGTH = 271843360,
  /** fixed [N]: Force of the strut at rest. (default 1325.2555) */
  STRIBECK_TOP_MOUNT_STATIC_FORCE = 368777087,
  /** state, out [m]: Position of the rod along the strut; 0 at rest. (default 0) */
  STRIBECK_TOP_MOUNT_ROD_POSITION = 1899310784,
  /** state, out [m/s]: Velocity of the rod along the strut. (default 0) */
  STRIBECK_TOP_MOUNT_ROD_VELOCITY = 825275428,
  /** out [m]: Displacement of the inner part relative to the body. */
  STRIBECK_TOP_MOUNT_DISPLACEMENT = 81840086,
  /** out [m/s]: Velocity of the inner part relative to the body. */
  STRIBECK_TOP_MOUNT_INNER_VELOCITY = 1054248123,
  /** out [m]: Length of the strut. */
  STRIBECK_TOP_MOUNT_LENGTH = 63976981,
  /** out [m/s]: Rate of the strut's length, positive in extension. */
  STRIBECK_TOP_MOUNT_VELOCITY = 846470194,
  /** out [N]: Part of the strut force that moves the rod and not the body. */
  STRIBECK_TOP_MOUNT_ROD_FORCE = 1433420958,
  /** out [N]: Force that the friction of a stuck strut carries. */
  STRIBECK_TOP_MOUNT_EXTERNAL_FORCE = 1336490458,
} stribeck_top_mount_variable;

/** Guid of PositionControl for fmi2Instantiate. */
#define STRIBECK_POSITION_CONTROL_GUID "{ed112b12-65bc-78aa-3a40-657716af27af}"

/** PositionControl: Mass whose position a PID controller holds or moves. Variables of "PositionControl". */
typedef enum stribeck_position_control_variable {
  /** in [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. (default 0) */
  STRIBECK_POSITION_CONTROL_FRICTION_FORCE = 1713976319,
  /** in [m]: Position that the controller aims at. (default 0) */
  STRIBECK_POSITION_CONTROL_TARGET_POSITION = 1404363290,
  /** in [m/s]: Velocity that the controller aims at. (default 0) */
  STRIBECK_POSITION_CONTROL_TARGET_VELOCITY = 647080962,
  /** in [m/s2]: Acceleration that the controller aims at. (default 0) */
  STRIBECK_POSITION_CONTROL_TARGET_ACCELERATION = 2065821261,
  /** fixed [kg]: Mass that moves. (> 0, default 1) */
  STRIBECK_POSITION_CONTROL_MASS = 1601648849,
  /** tunable [N/m]: Force by position error. (>= 0, default 3) */
  STRIBECK_POSITION_CONTROL_PROPORTIONAL_GAIN = 609643112,
  /** tunable [N/(m.s)]: Force by the integral of the position error. (>= 0, default 4) */
  STRIBECK_POSITION_CONTROL_INTEGRAL_GAIN = 1232300617,
  /** tunable [N.s/m]: Force by velocity error. (>= 0, default 6) */
  STRIBECK_POSITION_CONTROL_VELOCITY_GAIN = 423694768,
  /** tunable [N]: Sum of the normal forces of the guides (default chosen: a coefficient of friction is then a force in N).
   *  (>= 0, default 1) */
  STRIBECK_POSITION_CONTROL_GUIDE_FORCE = 2018901519,
  /** fixed [stribeck_compensation]: How the controller compensates for friction. (default Off) */
  STRIBECK_POSITION_CONTROL_COMPENSATION = 583013215,
  /** tunable [N]: Kinetic level that the controller assumes. (>= 0, default 1) */
  STRIBECK_POSITION_CONTROL_KINETIC_FORCE = 12436976,
  /** tunable [N]: Static level that the observer assumes. (>= 0, default 1.5) */
  STRIBECK_POSITION_CONTROL_BREAKAWAY_FORCE = 546321410,
  /** tunable [m/s]: Stribeck velocity of the observer. (> 0, default 0.001) */
  STRIBECK_POSITION_CONTROL_STRIBECK_VELOCITY = 2117263402,
  /** tunable [N/m]: Stiffness of the bristles of the observer. (> 0, default 100000) */
  STRIBECK_POSITION_CONTROL_SIGMA_0 = 206242323,
  /** tunable [N.s/m]: Damping of the bristles of the observer. (>= 0, default 316.22776601683796) */
  STRIBECK_POSITION_CONTROL_SIGMA_1 = 189464704,
  /** tunable [N.s/m]: Viscous coefficient that the controller assumes. (>= 0, default 0.4) */
  STRIBECK_POSITION_CONTROL_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [1/s]: Deflection per second that a position error of 1 m adds to the estimate of the observer (default chosen).
   *  (>= 0, default 0.0001) */
  STRIBECK_POSITION_CONTROL_OBSERVER_GAIN = 671887067,
  /** fixed [s]: Time between two samples of the controller; 0 = a continuous one. (>= 0, default 0) */
  STRIBECK_POSITION_CONTROL_SAMPLE_TIME = 1453133857,
  /** fixed [m]: Increment of the encoder that measures the position of a sampled controller; 0 = an exact one.
   *  (>= 0, default 0) */
  STRIBECK_POSITION_CONTROL_ENCODER_RESOLUTION = 627808530,
  /** state, out [m]: Position of the mass. (default 0) */
  STRIBECK_POSITION_CONTROL_POSITION = 323964426,
  /** state, out [m/s]: Velocity of the mass. (default 0) */
  STRIBECK_POSITION_CONTROL_VELOCITY = 846470194,
  /** state [m.s]: Integral of the position error. (default 0) */
  STRIBECK_POSITION_CONTROL_ERROR_INTEGRAL = 2127744426,
  /** state [m]: Deflection of the bristles as the observer estimates it. (default 0) */
  STRIBECK_POSITION_CONTROL_DEFLECTION_ESTIMATE = 2130110521,
  /** out [N]: Force of the controller. */
  STRIBECK_POSITION_CONTROL_EXTERNAL_FORCE = 1336490458,
  /** out [N]: Sum of the normal forces of the guides. */
  STRIBECK_POSITION_CONTROL_NORMAL_FORCE = 5891938,
} stribeck_position_control_variable;

/** Guid of MagnetorheologicalDamper for fmi2Instantiate. */
#define STRIBECK_MAGNETORHEOLOGICAL_DAMPER_GUID "{3f12a36f-5995-4647-10ed-f4792238d2c0}"

/** Preset of MagnetorheologicalDamper: Spencer, Dyke, Sain, Carlson (1997), the printed parameters: N/cm as 100 N/m, cm^-2 as 10,000 m^-2. */
#define STRIBECK_MAGNETORHEOLOGICAL_DAMPER_PRESET_SPENCER_1997 "spencer_1997"

/** MagnetorheologicalDamper: Magnetorheological damper with hysteresis (Spencer). Variables of "MagnetorheologicalDamper". */
typedef enum stribeck_magnetorheological_damper_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_VELOCITY = 846470194,
  /** in [V]: Voltage at the current driver of the coil. (>= 0, default 0) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_VOLTAGE = 1637048165,
  /** tunable [N.s/m]: Damping at high speeds without voltage. (>= 0, default 2100) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_C_0A = 1620367148,
  /** tunable [N.s/(m.V)]: Increase of the damping at high speeds with the voltage. (>= 0, default 350) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_C_0B = 1670700005,
  /** tunable [N/m]: Stiffness at high speeds. (>= 0, default 4690) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_K_0 = 896756493,
  /** tunable [N.s/m]: Coefficient of the dashpot in series without voltage. (> 0, default 28300) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_C_1A = 2089993385,
  /** tunable [N.s/(m.V)]: Increase of the coefficient of the dashpot in series with the voltage. (>= 0, default 295) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_C_1B = 2039660528,
  /** tunable [N/m]: Stiffness of the hysteresis without voltage. (>= 0, default 14000) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_ALPHA_A = 1165949383,
  /** tunable [N/(m.V)]: Increase of the stiffness of the hysteresis with the voltage. (>= 0, default 69500) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_ALPHA_B = 1182727002,
  /** tunable [1/m2]: Form of the hysteresis: its part that acts in both directions of motion, in m^-n.
   *  (>= 0, default 3630000) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_HYSTERESIS_GAMMA = 1416361652,
  /** tunable [1/m2]: Form of the hysteresis: its part that changes sign with the motion, in m^-n; above -hysteresis_gamma.
   *  (default 3630000) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_HYSTERESIS_BETA = 808569061,
  /** tunable [1]: Slope of the evolutionary variable over the displacement where it is 0. (> 0, default 301) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_A = 1141634764,
  /** tunable [1]: Exponent of the hysteresis: its transition to the saturated level is sharper if larger.
   *  (>= 1, default 2) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_N = 1795961905,
  /** tunable [1/s]: Rate at which the voltage on the fluid follows that at the driver. (> 0, default 190) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_VOLTAGE_RATE = 1590919820,
  /** tunable [N/m]: Stiffness of the accumulator. (>= 0, default 500) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_K_1 = 879978874,
  /** tunable [m]: Displacement at which the accumulator carries nothing. (default 0.143) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_X_0 = 172254248,
  /** state, out [m]: Displacement of body 1 relative to body 2. (default 0) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_DISPLACEMENT = 81840086,
  /** state [m]: Displacement of the dashpot in series. (default 0) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_Y = 2081181428,
  /** state [m]: Evolutionary variable of the hysteresis. (default 0) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_Z = 2131514285,
  /** state [V]: Voltage that acts on the fluid. (default 0) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_FILTERED_VOLTAGE = 573531939,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Force of the damper; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_MAGNETORHEOLOGICAL_DAMPER_DISSIPATED_POWER = 236926875,
} stribeck_magnetorheological_damper_variable;

/** Guid of RubberMount for fmi2Instantiate. */
#define STRIBECK_RUBBER_MOUNT_GUID "{f2722950-45e3-66c7-c9ef-49a84181c558}"

/** RubberMount: Rubber mount with friction that remembers the last turning point (Berg). Variables of "RubberMount". */
typedef enum stribeck_rubber_mount_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_RUBBER_MOUNT_VELOCITY = 846470194,
  /** tunable [N/m]: Elastic stiffness (default chosen). (>= 0, default 500000) */
  STRIBECK_RUBBER_MOUNT_K_E = 1618142526,
  /** fixed [N/m]: Stiffness in series with the damper; 0 = no damper (default chosen). (>= 0, default 100000) */
  STRIBECK_RUBBER_MOUNT_K_V = 1869806811,
  /** tunable [N.s/m]: Coefficient of the damper (default chosen). (> 0, default 2000) */
  STRIBECK_RUBBER_MOUNT_C = 1712073810,
  /** tunable [N]: Largest friction (default chosen). (>= 0, default 100) */
  STRIBECK_RUBBER_MOUNT_F_MAX = 201386388,
  /** tunable [m]: Displacement from rest at which the friction is half of the largest (default chosen).
   *  (> 0, default 0.0002) */
  STRIBECK_RUBBER_MOUNT_X_2 = 205809486,
  /** state, out [m]: Displacement of body 1 relative to body 2. (default 0) */
  STRIBECK_RUBBER_MOUNT_DISPLACEMENT = 81840086,
  /** state [1]: Friction as a part of the largest. (>= -1, <= 1, default 0) */
  STRIBECK_RUBBER_MOUNT_FRICTION_SHARE = 341380551,
  /** state [1]: Friction at the last turning point as a part of the largest. (>= -1, <= 1, default 0) */
  STRIBECK_RUBBER_MOUNT_TURNING_SHARE = 671000178,
  /** state [Boolean]: Was the last motion towards positive displacements? (default true) */
  STRIBECK_RUBBER_MOUNT_RISING = 1838359547,
  /** state [N]: Force of the damper and its spring. (default 0) */
  STRIBECK_RUBBER_MOUNT_DAMPER_FORCE = 1578574060,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_RUBBER_MOUNT_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Force of the mount, elastic part included; resists a displacement. Body 1 feels its negative. */
  STRIBECK_RUBBER_MOUNT_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_RUBBER_MOUNT_DISSIPATED_POWER = 236926875,
} stribeck_rubber_mount_variable;

/** Guid of GearEfficiency for fmi2Instantiate. */
#define STRIBECK_GEAR_EFFICIENCY_GUID "{cab5fe18-9e7a-dbf2-80e6-0688cf66e8cd}"

/** Preset of GearEfficiency: Example of a worm gear, in N.m and rad/s, which the load cannot drive back. */
#define STRIBECK_GEAR_EFFICIENCY_PRESET_SELF_LOCKING "self_locking"

/** GearEfficiency: Gear with an efficiency of driving and one of driving back. Variables of "GearEfficiency". */
typedef enum stribeck_gear_efficiency_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_GEAR_EFFICIENCY_VELOCITY = 846470194,
  /** in [N]: Force of the motor at the output, positive in the direction of the velocity (default chosen).
   *  (default 10) */
  STRIBECK_GEAR_EFFICIENCY_TRANSMITTED_FORCE = 678577350,
  /** tunable [1]: Part of the force that is lost when driving (default chosen). (>= 0, default 0.2) */
  STRIBECK_GEAR_EFFICIENCY_MU_DRIVING = 151834187,
  /** tunable [1]: Part of the force that resists when the load drives back (default chosen). (>= 0, default 0.3) */
  STRIBECK_GEAR_EFFICIENCY_MU_BACKDRIVING = 591977642,
  /** tunable [m]: Distance after which 1/e of a change of the direction is left (default chosen).
   *  (> 0, default 0.001) */
  STRIBECK_GEAR_EFFICIENCY_RELAXATION_DISTANCE = 1884902156,
  /** state [1]: Direction of the motion. (>= -1, <= 1, default 0) */
  STRIBECK_GEAR_EFFICIENCY_DIRECTION = 1601029994,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_GEAR_EFFICIENCY_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_GEAR_EFFICIENCY_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_GEAR_EFFICIENCY_DISSIPATED_POWER = 236926875,
} stribeck_gear_efficiency_variable;

/** Guid of ServoFriction for fmi2Instantiate. */
#define STRIBECK_SERVO_FRICTION_GUID "{4f773f77-aafa-2304-f705-46b88939b5c6}"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-106, model M1; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX106_M1 "mx106_m1"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-106, model M2; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX106_M2 "mx106_m2"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-106, model M3; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX106_M3 "mx106_m3"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-106, model M4; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX106_M4 "mx106_m4"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-106, model M5; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX106_M5 "mx106_m5"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-106, model M6; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX106_M6 "mx106_m6"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-64, model M1; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX64_M1 "mx64_m1"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-64, model M2; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX64_M2 "mx64_m2"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-64, model M3; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX64_M3 "mx64_m3"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-64, model M4; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX64_M4 "mx64_m4"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-64, model M5; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX64_M5 "mx64_m5"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel MX-64, model M6; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_MX64_M6 "mx64_m6"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-320, model M1; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL320_M1 "xl320_m1"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-320, model M2; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL320_M2 "xl320_m2"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-320, model M3; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL320_M3 "xl320_m3"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-320, model M4; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL320_M4 "xl320_m4"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-320, model M5; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL320_M5 "xl320_m5"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-320, model M6; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL320_M6 "xl320_m6"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-330, model M1; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL330_M1 "xl330_m1"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-330, model M2; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL330_M2 "xl330_m2"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-330, model M3; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL330_M3 "xl330_m3"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-330, model M4; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL330_M4 "xl330_m4"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-330, model M5; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL330_M5 "xl330_m5"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Dynamixel XL-330, model M6; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_XL330_M6 "xl330_m6"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:50, model M1; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_50_M1 "erob80_50_m1"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:50, model M2; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_50_M2 "erob80_50_m2"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:50, model M3; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_50_M3 "erob80_50_m3"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:50, model M4; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_50_M4 "erob80_50_m4"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:50, model M5; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_50_M5 "erob80_50_m5"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:50, model M6; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_50_M6 "erob80_50_m6"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:100, model M1; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_100_M1 "erob80_100_m1"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:100, model M2; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_100_M2 "erob80_100_m2"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:100, model M3; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_100_M3 "erob80_100_m3"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:100, model M4; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_100_M4 "erob80_100_m4"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:100, model M5; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_100_M5 "erob80_100_m5"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), eRob80:100, model M6; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_EROB80_100_M6 "erob80_100_m6"

/** Preset of ServoFriction: Rhoban/bam (2026), see Duclusaud et al. (2025), Feetech STS3215, 7.4 V, model M1; N.m and rad/s. */
#define STRIBECK_SERVO_FRICTION_PRESET_STS3215_M1 "sts3215_m1"

/** ServoFriction: Friction of a servo drive that depends on the torques of motor and load (Duclusaud and others). Variables of "ServoFriction". */
typedef enum stribeck_servo_friction_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_SERVO_FRICTION_VELOCITY = 846470194,
  /** in [N]: Force of the motor at the output, positive in the direction of the velocity. (default 0) */
  STRIBECK_SERVO_FRICTION_MOTOR_FORCE = 1103735874,
  /** in [N]: Force of the load on the output, positive in the direction of the velocity. (default 0) */
  STRIBECK_SERVO_FRICTION_LOAD_FORCE = 1613682665,
  /** tunable [N]: Kinetic level of friction without load. (>= 0, default 0) */
  STRIBECK_SERVO_FRICTION_KINETIC_FORCE = 12436976,
  /** tunable [N]: Excess of the static over the kinetic level without load. (>= 0, default 0.1049) */
  STRIBECK_SERVO_FRICTION_EXCESS_FORCE = 1955954170,
  /** tunable [1]: Kinetic level of friction by the force of the motor. (>= 0, default 0.00915) */
  STRIBECK_SERVO_FRICTION_MOTOR_COEFFICIENT = 389200416,
  /** tunable [1]: Kinetic level of friction by the force of the load. (>= 0, default 0.00915) */
  STRIBECK_SERVO_FRICTION_LOAD_COEFFICIENT = 419002735,
  /** tunable [1]: Excess of the static over the kinetic level by the force of the motor. (>= 0, default 0.2224) */
  STRIBECK_SERVO_FRICTION_MOTOR_EXCESS = 1551683256,
  /** tunable [1]: Excess of the static over the kinetic level by the force of the load. (>= 0, default 0.2224) */
  STRIBECK_SERVO_FRICTION_LOAD_EXCESS = 952738817,
  /** tunable [1/N]: Excess by the square of the force of the motor, where a larger load opposes it.
   *  (>= 0, default 0) */
  STRIBECK_SERVO_FRICTION_MOTOR_QUADRATIC_EXCESS = 591972707,
  /** tunable [1/N]: Excess by the square of the force of the load, where a larger force of the motor opposes it.
   *  (>= 0, default 0) */
  STRIBECK_SERVO_FRICTION_LOAD_QUADRATIC_EXCESS = 1977134430,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 1.623) */
  STRIBECK_SERVO_FRICTION_STRIBECK_VELOCITY = 2117263402,
  /** tunable [1]: Exponent of the Stribeck curve. (> 0, default 1.323) */
  STRIBECK_SERVO_FRICTION_STRIBECK_EXPONENT = 509292062,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0.05096) */
  STRIBECK_SERVO_FRICTION_VISCOUS_COEFFICIENT = 97539077,
  /** tunable [kg]: Effective mass of the body to be held at rest, better too small than too large; 0 = law as printed.
   *  (>= 0, default 0) */
  STRIBECK_SERVO_FRICTION_MASS = 1601648849,
  /** fixed [stribeck_exchange_order]: Order in which the master exchanges values; used with mass > 0.
   *  (default Sequential) */
  STRIBECK_SERVO_FRICTION_EXCHANGE = 1692658528,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_SERVO_FRICTION_STEP_SIZE = 843244609,
  /** state [s]: Step for which a parallel exchange plans: the longest recent one. (>= 0, default 0) */
  STRIBECK_SERVO_FRICTION_PLANNING_STEP = 1287183179,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_SERVO_FRICTION_PLANNED_FORCE = 30514517,
  /** state [m/s]: Velocity at the end of the last step. (default 0) */
  STRIBECK_SERVO_FRICTION_END_VELOCITY = 1478402472,
  /** state [N]: External force at the end of the last step. (default 0) */
  STRIBECK_SERVO_FRICTION_END_EXTERNAL_FORCE = 1757063408,
  /** state [N]: Normal force at the end of the last step. (>= 0, default 0) */
  STRIBECK_SERVO_FRICTION_END_NORMAL_FORCE = 962162212,
  /** state [m/s]: Change of the velocity over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SERVO_FRICTION_VELOCITY_CHANGE = 10986035,
  /** state [N]: Change of the external force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SERVO_FRICTION_EXTERNAL_FORCE_CHANGE = 1328420411,
  /** state [N]: Change of the normal force over the last step if the master gave its slope, else 0. (default 0) */
  STRIBECK_SERVO_FRICTION_NORMAL_FORCE_CHANGE = 2025029027,
  /** state [stribeck_phase]: Motion of the contact as found by the last event of Model Exchange. (default Free) */
  STRIBECK_SERVO_FRICTION_PHASE = 1501573624,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_SERVO_FRICTION_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_SERVO_FRICTION_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_SERVO_FRICTION_DISSIPATED_POWER = 236926875,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_SERVO_FRICTION_STICKING = 553311409,
} stribeck_servo_friction_variable;

/** Guid of Capstan for fmi2Instantiate. */
#define STRIBECK_CAPSTAN_GUID "{389727b8-4ff7-3541-baa5-cf9247e61df7}"

/** Preset of Capstan: Example of a rope with three turns around a winch, with a preload of 100 N. */
#define STRIBECK_CAPSTAN_PRESET_WINCH "winch"

/** Preset of Capstan: Example of a derailleur cable of a bicycle with 180 degrees of bends; mu_k = 0.06 was measured with 180 to 540 degrees (killasgarage.bike, "Cable Routing - Experimental Results", 2016). */
#define STRIBECK_CAPSTAN_PRESET_BOWDEN_CABLE "bowden_cable"

/** Capstan: Rope or Bowden cable over bends, with pre-sliding displacement (Euler and Eytelwein). Variables of "Capstan". */
typedef enum stribeck_capstan_variable {
  /** in [m/s]: Velocity of the rope relative to the drum, from side 1 to side 2. (default 0) */
  STRIBECK_CAPSTAN_VELOCITY = 846470194,
  /** in [N]: Tension on side 1 beside the preload (default chosen). (>= 0, default 10) */
  STRIBECK_CAPSTAN_TENSION_1 = 1649628229,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_CAPSTAN_MU_K = 1281456745,
  /** tunable [rad]: Angle of wrap, all bends and turns together (default chosen: half a turn).
   *  (>= 0, default 3.141592653589793) */
  STRIBECK_CAPSTAN_WRAP_ANGLE = 1384030741,
  /** tunable [N]: Tension on side 1 without load. (>= 0, default 0) */
  STRIBECK_CAPSTAN_PRELOAD = 1930668294,
  /** tunable [m]: Distance after which 1/e of a change of the friction share is left (default chosen).
   *  (> 0, default 0.001) */
  STRIBECK_CAPSTAN_RELAXATION_DISTANCE = 1884902156,
  /** state [1]: Part of the angle whose friction acts, with the sign of the direction. (>= -1, <= 1, default 0) */
  STRIBECK_CAPSTAN_FRICTION_SHARE = 341380551,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_CAPSTAN_DISSIPATED_ENERGY = 758404530,
  /** out [N]: Tension on side 2 less that on side 1; has the sign of the velocity when sliding. The rope feels its negative. */
  STRIBECK_CAPSTAN_FRICTION_FORCE = 1713976319,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_CAPSTAN_DISSIPATED_POWER = 236926875,
  /** out [N]: Tension on side 2. */
  STRIBECK_CAPSTAN_TENSION_2 = 1599295372,
} stribeck_capstan_variable;

#endif /* STRIBECK_H */
