/* stribeck.h: friction force models, the interface for C and C++.  Written by fmu-build; do not edit.
 *
 * Two interfaces, one library. The functions stribeck_... are for programs that use the models directly; the functions
 * fmi2... are those of FMI 2.0 for co-simulation, with the names and types of the standard's headers, for programs that
 * treat the library as an FMU. Use one of them for an instance, and do not include the standard's headers together with
 * this one.
 *
 * Sign        velocity is that of body 1 relative to body 2. friction_force is the resistance: it has the sign of
 *             velocity when sliding, body 1 feels -friction_force and body 2 feels +friction_force. The power
 *             friction_force * velocity leaves the motion. external_force is the resultant of all other tangential
 *             forces on body 1; a contact that sticks carries friction_force = external_force. SI units throughout.
 * Columns     A model is a row of numbers. Every variable has a column, which is also its FMI value reference; the
 *             enums at the end of this file name the columns of each model, with role, unit, meaning, bound and default:
 *             in = set by the caller before each step; fixed = parameter that stays constant during a run; tunable =
 *             parameter that may change between steps; state = advanced by steps; out = result. Booleans are 0 or 1,
 *             enumerations are numbers from 1.
 * Ownership   What stribeck_create or fmi2Instantiate makes is freed exactly once, with stribeck_free or
 *             fmi2FreeInstance. Texts that the library returns belong to the library. Every pointer you pass stays
 *             yours and is not kept after the call, except the logger of fmi2Instantiate and its environment.
 * Threads     Different instances may be used from different threads at the same time, one instance from one thread at
 *             a time. The library starts no thread.
 * Errors      A call that is refused changes nothing; no call aborts the program. stribeck_...: any status but
 *             STRIBECK_OK is a refusal, and stribeck_last_error says why. fmi2...: with fmi2Discard a value was refused
 *             and the run can go on; after fmi2Error the instance must be reset, freed or given a saved state. The
 *             reason goes to the logger. A result is never infinite or NaN.
 * NULL        A NULL instance or array is refused, never dereferenced; an array of length 0 may be NULL. Freeing NULL
 *             does nothing.
 * Safety      A pointer that is not NULL must be valid for its purpose, and a text must end with a zero byte.
 *
 * Example, without the checks of the status:
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
  /** All well. */
  STRIBECK_OK = 0,
  /** A pointer that must not be NULL is NULL. */
  STRIBECK_NULL = 1,
  /** There is no model, or no preset, of that name. */
  STRIBECK_UNKNOWN_MODEL = 2,
  /** The model has no variable of that name, or no column of that number. */
  STRIBECK_UNKNOWN_VARIABLE = 3,
  /** The value is outside the bound of its variable, or the parameters do not fit together. */
  STRIBECK_REFUSED_VALUE = 4,
  /** The variable is computed and cannot be set. */
  STRIBECK_NOT_SETTABLE = 5,
  /** The result would not be finite. */
  STRIBECK_NOT_FINITE = 6,
  /** The buffer is too small, or holds no state of this model. */
  STRIBECK_BAD_BUFFER = 7,
  /** A fault of the library; please report it. */
  STRIBECK_INTERNAL = 8,
} stribeck_status;

/** Who writes a variable. */
typedef enum {
  /** Set by the caller before each step. */
  STRIBECK_INPUT = 0,
  /** Parameter that is meant to stay constant during a run. */
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

/** What the number in a variable stands for. */
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
  /** All well. */
  fmi2OK,
  /** Done, but with a remark in the log. */
  fmi2Warning,
  /** Refused; nothing was changed and the simulation can go on. */
  fmi2Discard,
  /** Refused; the instance must be reset, freed or given a saved state. */
  fmi2Error,
  /** The instance is lost. */
  fmi2Fatal,
  /** Still working (never returned: all calls are synchronous). */
  fmi2Pending,
} fmi2Status;

/** A live model. Made by stribeck_create, freed by stribeck_free. */
typedef struct stribeck_model stribeck_model;

/** Description of a variable, as stribeck_describe gives it. The texts belong to the handle and live as long as it. */
typedef struct {
  /** Name, such as `velocity` or `element[3].stiffness`. */
  const char *name;
  /** Unit, `1` for a pure number; empty if the kind is not STRIBECK_REAL. */
  const char *unit;
  /** One line that says what it is. */
  const char *help;
  /** Who writes it. */
  stribeck_role role;
  /** What the number stands for. */
  stribeck_kind kind;
  /** Start value. */
  double start;
  /** Smallest value admitted, `-DBL_MAX` if there is none; a smallest value of 0 may itself be refused (stiffness). */
  double min;
  /** Largest value admitted, `DBL_MAX` if there is none. */
  double max;
} stribeck_variable;

/** Character. */
typedef char fmi2Char;

/** Zero-terminated text. */
typedef const fmi2Char *fmi2String;

/** An instance of a model. */
typedef void *fmi2Component;

/** Kind of an FMU, an argument of fmi2Instantiate: `fmi2ModelExchange` or `fmi2CoSimulation`. */
typedef int fmi2Type;

/** What the importer gets back in its logger. */
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

/** What the importer offers. It is copied by fmi2Instantiate and need not outlive that call. */
typedef struct {
  /** Receives messages; NULL for none. */
  fmi2CallbackLogger logger;
  /** Not used; may be NULL. */
  fmi2CallbackAllocateMemory allocateMemory;
  /** Not used; may be NULL. */
  fmi2CallbackFreeMemory freeMemory;
  /** Not used; may be NULL. */
  fmi2StepFinished stepFinished;
  /** Given back to the logger. */
  fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

/** `fmi2False` or `fmi2True`. */
typedef int fmi2Boolean;

/** Floating-point number. */
typedef double fmi2Real;

/** A saved state of an instance. */
typedef void *fmi2FMUstate;

/** Byte of a serialised state. */
typedef char fmi2Byte;

/** What fmi2GetXXXStatus asks for. */
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

/** Does the instance want to end the simulation? */
#define fmi2Terminated 3

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/** Version of the library, such as "0.1.0". */
const char *stribeck_version(void);

/** Number of models of the library. */
size_t stribeck_model_count(void);

/** Name of the model of that index, from 0; NULL past the last. The text lives as long as the library. */
const char *stribeck_model_name(size_t index);

/**
 * What a status means, in a few words. The text lives as long as the library.
 *
 * Takes an `int`, because a number that is none of the enum's must not be harmful.
 */
const char *stribeck_status_text(int status);

/**
 * Makes a model at its start values and writes its handle to `*model`; NULL there on failure. To be freed once with
 * stribeck_free.
 */
stribeck_status stribeck_create(const char *name, stribeck_model **model);

/** Frees a model. NULL is ignored. */
void stribeck_free(stribeck_model *model);

/**
 * Why the last refused call on this handle was refused. The text lives until the next call on the handle; for NULL a
 * fixed text is returned.
 */
const char *stribeck_last_error(const stribeck_model *model);

/** Back to the start values and to time 0. */
stribeck_status stribeck_reset(stribeck_model *model);

/** Number of columns, that is, of variables; 0 for NULL. */
uint32_t stribeck_column_count(const stribeck_model *model);

/** Column of the variable of that name. The enums of this header hold the same numbers. */
stribeck_status stribeck_find(stribeck_model *model, const char *variable, uint32_t *column);

/** Describes a column: name, unit, help text, role, kind, start value and bounds. */
stribeck_status stribeck_describe(stribeck_model *model, uint32_t column, stribeck_variable *variable);

/** Number of presets, that is, of named parameter sets of the model; 0 for NULL. */
size_t stribeck_preset_count(const stribeck_model *model);

/** Name of the preset of that index, from 0; NULL past the last. The text belongs to the handle. */
const char *stribeck_preset_name(const stribeck_model *model, size_t index);

/** Where the values of the preset of that index come from; NULL past the last. The text belongs to the handle. */
const char *stribeck_preset_source(const stribeck_model *model, size_t index);

/** Sets the parameters of the named preset; the other variables stay as they are. */
stribeck_status stribeck_apply_preset(stribeck_model *model, const char *preset);

/** Sets a variable. Everything but computed results can be set at any time; outputs follow at once. */
stribeck_status stribeck_set(stribeck_model *model, uint32_t column, double value);

/** Reads a variable; results are computed first if anything was set since. */
stribeck_status stribeck_get(stribeck_model *model, uint32_t column, double *value);

/** As stribeck_set, by name. Slower: look the column up once with stribeck_find if it is set often. */
stribeck_status stribeck_set_by_name(stribeck_model *model, const char *variable, double value);

/** As stribeck_get, by name. */
stribeck_status stribeck_get_by_name(stribeck_model *model, const char *variable, double *value);

/** Advances the model by `dt` > 0 seconds with held inputs and computes the results. */
stribeck_status stribeck_step(stribeck_model *model, double dt);

/** Computes the results now, and says whether the parameters fit together and the results are finite. */
stribeck_status stribeck_output(stribeck_model *model);

/** Time since creation or reset, in seconds; NaN for NULL. */
double stribeck_time(const stribeck_model *model);

/** Exact partial derivative of a result with respect to an input, parameter or state, at the present values. */
stribeck_status stribeck_derivative(stribeck_model *model, uint32_t output, uint32_t input, double *value);

/** Number of bytes that stribeck_save writes; 0 for NULL. */
size_t stribeck_state_size(const stribeck_model *model);

/** Writes the complete state of the model, parameters and time included, as bytes that any process can read. */
stribeck_status stribeck_save(stribeck_model *model, void *buffer, size_t size);

/** Goes back to a saved state of this or of another model of the same kind. Foreign or damaged bytes are refused. */
stribeck_status stribeck_restore(stribeck_model *model, const void *buffer, size_t size);

/** The platform of the types: "default". */
fmi2String fmi2GetTypesPlatform(void);

/** The version of the interface: "2.0". */
fmi2String fmi2GetVersion(void);

/**
 * Makes an instance of the model whose guid is `fmuGUID`, to be freed once with fmi2FreeInstance.
 *
 * `fmuType` must be `fmi2CoSimulation`. `callbacks` is copied; its function pointers may all be NULL.
 * `fmuResourceLocation` and `visible` are not used. Returns NULL, and says why to the logger, if the guid is that of no
 * model of this library, or if the name is blank.
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

/** Switches log categories (`logStatusDiscard`, `logStatusError`, `logAll`); all of them if `nCategories` is 0. */
fmi2Status fmi2SetDebugLogging(fmi2Component c,
                               fmi2Boolean loggingOn,
                               size_t nCategories,
                               const fmi2String *categories);

/**
 * Declares start time and, if defined, stop time, beyond which no step may reach. The tolerance is only checked: the
 * steps are exact or hold a tighter tolerance of their own.
 */
fmi2Status fmi2SetupExperiment(fmi2Component c,
                               fmi2Boolean toleranceDefined,
                               fmi2Real tolerance,
                               fmi2Real startTime,
                               fmi2Boolean stopTimeDefined,
                               fmi2Real stopTime);

/** Enters the initialization mode, in which inputs are set and outputs read at the start time. */
fmi2Status fmi2EnterInitializationMode(fmi2Component c);

/** Ends the initialization: parameters must now fit together, outputs must be finite. */
fmi2Status fmi2ExitInitializationMode(fmi2Component c);

/** Ends the simulation run. Results can still be read. */
fmi2Status fmi2Terminate(fmi2Component c);

/** Back to the state after fmi2Instantiate: start values, no experiment, time 0. Log settings stay. */
fmi2Status fmi2Reset(fmi2Component c);

/**
 * Saves the state. `*FMUstate` must be NULL, to make a new one, or an earlier state, to overwrite it. To be freed once
 * with fmi2FreeFMUstate.
 */
fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *FMUstate);

/** Goes back to a saved state, of this or of another instance of the same model. The state can be used again. */
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate FMUstate);

/** Frees a saved state and sets the pointer to NULL. A pointer to NULL is ignored, as is NULL. */
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *FMUstate);

/** Number of bytes that fmi2SerializeFMUstate writes. */
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate FMUstate, size_t *size);

/**
 * Writes a saved state as bytes that another process, on another platform too, can read. Equal states give equal bytes.
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

/** Always an error: no step is ever pending. */
fmi2Status fmi2CancelStep(fmi2Component c);

/** Always fmi2Discard: there is no asynchronous step to ask about. */
fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind s, fmi2Status *value);

/** `fmi2LastSuccessfulTime`: the end of the last completed step. fmi2Discard for other kinds. */
fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind s, fmi2Real *value);

/** Always fmi2Discard: no status is an integer. */
fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind s, fmi2Integer *value);

/** `fmi2Terminated`: no model ends the simulation by itself, so fmi2False. fmi2Discard for other kinds. */
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

/** Sets Boolean variables, as fmi2SetReal does; only `fmi2False` and `fmi2True` are taken. */
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, const fmi2Boolean *value);

/** Sets String variables; no model has any, so only `nvr` = 0 succeeds. */
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference *vr, size_t nvr, const fmi2String *value);

/** Gives inputs a slope over the next step (order 1 only). It is used for that step, and then forgotten. */
fmi2Status fmi2SetRealInputDerivatives(fmi2Component c,
                                       const fmi2ValueReference *vr,
                                       size_t nvr,
                                       const fmi2Integer *order,
                                       const fmi2Real *value);

/** Time derivatives of outputs at the present time: order 1 exact, higher orders 0 as the standard asks. */
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c,
                                        const fmi2ValueReference *vr,
                                        size_t nvr,
                                        const fmi2Integer *order,
                                        fmi2Real *value);

/** Derivative of outputs in a direction of inputs, parameters and states: exact, by automatic differentiation. */
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

/** Choices of a variable of the type Exchange. */
typedef enum stribeck_exchange {
  /** The host uses the force of the step just computed, or the force read after setting the inputs (Gauss-Seidel). */
  STRIBECK_EXCHANGE_SEQUENTIAL = 1,
  /** All models step at once and exchange values afterwards, so the force acts one step later (Jacobi). */
  STRIBECK_EXCHANGE_PARALLEL = 2,
} stribeck_exchange;

/** Guid of CoulombStiction for fmi2Instantiate. */
#define STRIBECK_COULOMB_STICTION_GUID "{a894c3d1-c9a2-7d3a-aaed-376a92f524ff}"

/** CoulombStiction: Coulomb friction with stiction. Columns of "CoulombStiction". */
typedef enum stribeck_coulomb_stiction_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_COULOMB_STICTION_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_COULOMB_STICTION_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1. (default 0) */
  STRIBECK_COULOMB_STICTION_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_COULOMB_STICTION_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_COULOMB_STICTION_MU_S = 4,
  /** tunable [kg]: Effective mass of the host, to hold it in co-simulation; 0 = the printed law. (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_MASS = 5,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_COULOMB_STICTION_EXCHANGE = 6,
  /** state [Boolean]: Is the contact stuck since the last step? Used with mass > 0. (default false) */
  STRIBECK_COULOMB_STICTION_STUCK = 7,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_COULOMB_STICTION_STEP_SIZE = 8,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_COULOMB_STICTION_PLANNED_FORCE = 9,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_COULOMB_STICTION_DISSIPATED_ENERGY = 10,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_COULOMB_STICTION_FRICTION_FORCE = 11,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_COULOMB_STICTION_DISSIPATED_POWER = 12,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_COULOMB_STICTION_STICKING = 13,
} stribeck_coulomb_stiction_variable;

/** Guid of Karnopp for fmi2Instantiate. */
#define STRIBECK_KARNOPP_GUID "{6886e774-1727-1fc5-3fe0-11e98ba632ce}"

/** Karnopp: Coulomb friction with a band of stiction (Karnopp). Columns of "Karnopp". */
typedef enum stribeck_karnopp_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_KARNOPP_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_KARNOPP_NORMAL_FORCE = 1,
  /** in [N]: Resultant of all other tangential forces on body 1. (default 0) */
  STRIBECK_KARNOPP_EXTERNAL_FORCE = 2,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_KARNOPP_MU_K = 3,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_KARNOPP_MU_S = 4,
  /** tunable [m/s]: Velocity at which the regularised band around rest ends (default chosen). (> 0, default 0.001) */
  STRIBECK_KARNOPP_TRANSITION_VELOCITY = 5,
  /** tunable [kg]: Effective mass of the host, to hold it in co-simulation; 0 = the printed law. (>= 0, default 0) */
  STRIBECK_KARNOPP_MASS = 6,
  /** fixed [stribeck_exchange]: Order in which the master exchanges values; used with mass > 0. (default Sequential) */
  STRIBECK_KARNOPP_EXCHANGE = 7,
  /** state [Boolean]: Is the contact stuck since the last step? Used with mass > 0. (default false) */
  STRIBECK_KARNOPP_STUCK = 8,
  /** state [s]: Length of the last step; 0 before the first one. (>= 0, default 0) */
  STRIBECK_KARNOPP_STEP_SIZE = 9,
  /** state [N]: Force planned for the coming step of a parallel exchange. (default 0) */
  STRIBECK_KARNOPP_PLANNED_FORCE = 10,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_KARNOPP_DISSIPATED_ENERGY = 11,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_KARNOPP_FRICTION_FORCE = 12,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_KARNOPP_DISSIPATED_POWER = 13,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_KARNOPP_STICKING = 14,
} stribeck_karnopp_variable;

/** Guid of BrownMcPhee for fmi2Instantiate. */
#define STRIBECK_BROWN_MCPHEE_GUID "{131b5338-0d04-2af5-b0d2-5cda54db0a05}"

/** BrownMcPhee: Smooth friction law with a stiction peak (Brown and McPhee). Columns of "BrownMcPhee". */
typedef enum stribeck_brown_mcphee_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_BROWN_MCPHEE_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_BROWN_MCPHEE_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_BROWN_MCPHEE_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_BROWN_MCPHEE_MU_S = 3,
  /** tunable [m/s]: Velocity at which the regularised band around rest ends (default chosen). (> 0, default 0.001) */
  STRIBECK_BROWN_MCPHEE_TRANSITION_VELOCITY = 4,
  /** tunable [N.s/m]: Viscous friction coefficient. (>= 0, default 0) */
  STRIBECK_BROWN_MCPHEE_VISCOUS_COEFFICIENT = 5,
  /** tunable [N]: Normal force at which the viscous part is fully active (default chosen). (> 0, default 1) */
  STRIBECK_BROWN_MCPHEE_TRANSITION_NORMAL_FORCE = 6,
  /** state, out [J]: Energy taken out of the motion since the start. (default 0) */
  STRIBECK_BROWN_MCPHEE_DISSIPATED_ENERGY = 7,
  /** out [N]: Friction force; has the sign of the velocity when sliding. Body 1 feels its negative. */
  STRIBECK_BROWN_MCPHEE_FRICTION_FORCE = 8,
  /** out [W]: Power taken out of the motion: friction force times velocity. */
  STRIBECK_BROWN_MCPHEE_DISSIPATED_POWER = 9,
  /** out [Boolean]: Is the contact sticking? */
  STRIBECK_BROWN_MCPHEE_STICKING = 10,
} stribeck_brown_mcphee_variable;

/** Guid of Dahl for fmi2Instantiate. */
#define STRIBECK_DAHL_GUID "{726647ac-36e8-da69-ca74-7db2edc41a45}"

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
#define STRIBECK_LUGRE_GUID "{2d67c578-f05b-b8b2-b3d5-920434cde30c}"

/** LuGre: Bristle friction with Stribeck effect (LuGre). Columns of "LuGre". */
typedef enum stribeck_lugre_variable {
  /** in [m/s]: Sliding velocity of body 1 relative to body 2. (default 0) */
  STRIBECK_LUGRE_VELOCITY = 0,
  /** in [N]: Normal force that presses the surfaces together. (>= 0, default 9.81) */
  STRIBECK_LUGRE_NORMAL_FORCE = 1,
  /** tunable [1]: Kinetic coefficient of friction. (>= 0, default 0.1) */
  STRIBECK_LUGRE_MU_K = 2,
  /** tunable [1]: Static coefficient of friction; not less than mu_k. (>= 0, default 0.15) */
  STRIBECK_LUGRE_MU_S = 3,
  /** tunable [m/s]: Speed at which the excess of static over kinetic friction has fallen to 1/e.
   *  (> 0, default 0.001) */
  STRIBECK_LUGRE_STRIBECK_VELOCITY = 4,
  /** tunable [1]: Exponent of the falling level. (> 0, default 2) */
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

/** Guid of BeltRig for fmi2Instantiate. */
#define STRIBECK_BELT_RIG_GUID "{3fdb7835-ec55-d861-bfa1-1465b7cdf0a3}"

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

#endif /* STRIBECK_H */
