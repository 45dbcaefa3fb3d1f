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
