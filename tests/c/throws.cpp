// A host in C++ whose logger throws. The exception reaches the host, and leaves the instance in the state implied by
// the status: a refused value has changed nothing, and after an error reset, free and restore are allowed.
#include <cfenv>
#include <cstdarg>
#include <stdexcept>
#include <string>
#include <vector>

#include "check.h"
#include "stribeck.h"

namespace {

// An object to be destroyed during unwinding, as hosts have.
struct Complaint : std::runtime_error {
    Complaint(fmi2Status given, const std::string &text) : std::runtime_error(text), status(given) {}
    fmi2Status status;
};

int told = 0;

void throwing_logger(fmi2ComponentEnvironment, fmi2String, fmi2Status status, fmi2String, fmi2String format, ...) {
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    told++;
    throw Complaint(status, text);
}

const fmi2CallbackFunctions CALLBACKS = {throwing_logger, nullptr, nullptr, nullptr, nullptr};

fmi2Component make(fmi2Type type, const char *guid) {
    // With loggingOn = false: the reason of a failure is logged in any case.
    return fmi2Instantiate("throws", type, guid, nullptr, &CALLBACKS, fmi2False, fmi2False);
}

void initialise(fmi2Component slave) {
    CHECK(fmi2SetupExperiment(slave, fmi2False, 0.0, 0.0, fmi2False, 0.0) == fmi2OK);
    CHECK(fmi2EnterInitializationMode(slave) == fmi2OK);
    CHECK(fmi2ExitInitializationMode(slave) == fmi2OK);
}

// The call must throw the logger's exception, with this status and a text that contains `why`.
template <typename Call>
void throws(fmi2Status status, const char *why, Call call) {
    try {
        call();
        CHECK(!"an exception");
    } catch (const Complaint &complaint) {
        CHECK(complaint.status == status);
        if (!CHECK(std::string(complaint.what()).find(why) != std::string::npos)) {
            fprintf(stderr, "  %s\n", complaint.what());
        }
    }
}

const fmi2ValueReference VELOCITY = STRIBECK_LUGRE_VELOCITY;
const fmi2ValueReference LOAD = STRIBECK_LUGRE_NORMAL_FORCE;
const fmi2ValueReference FORCE = STRIBECK_LUGRE_FRICTION_FORCE;

void set(fmi2Component slave, fmi2ValueReference reference, double value) {
    CHECK(fmi2SetReal(slave, &reference, 1, &value) == fmi2OK);
}

double get(fmi2Component slave, fmi2ValueReference reference) {
    double value = -1.0;
    CHECK(fmi2GetReal(slave, &reference, 1, &value) == fmi2OK);
    return value;
}

void nothing_is_instantiated() {
    throws(fmi2Error, "does not belong to a model", [] { make(fmi2CoSimulation, "{no such model}"); });
    const std::string endless(10000, '#');
    throws(fmi2Error, "##", [&] { make(fmi2CoSimulation, endless.c_str()); });
}

void a_refused_value_changes_nothing() {
    fmi2Component slave = make(fmi2CoSimulation, STRIBECK_LUGRE_GUID);
    REQUIRE(slave != nullptr);
    initialise(slave);
    set(slave, VELOCITY, 1e-3);
    CHECK(fmi2DoStep(slave, 0.0, 1e-3, fmi2True) == fmi2OK);
    const double force = get(slave, FORCE), load = get(slave, LOAD), wrong = -1.0;
    throws(fmi2Discard, "normal_force = -1: must be >= 0", [&] { fmi2SetReal(slave, &LOAD, 1, &wrong); });
    CHECK(get(slave, LOAD) == load && get(slave, FORCE) == force);
    CHECK(fmi2DoStep(slave, 1e-3, 1e-3, fmi2True) == fmi2OK);
    fmi2FreeInstance(slave);
}

void an_error_is_left_by_reset_and_by_a_saved_state() {
    fmi2Component slave = make(fmi2CoSimulation, STRIBECK_LUGRE_GUID);
    REQUIRE(slave != nullptr);
    initialise(slave);
    set(slave, VELOCITY, 1e-3);
    CHECK(fmi2DoStep(slave, 0.0, 1e-3, fmi2True) == fmi2OK);
    const double force = get(slave, FORCE);
    fmi2FMUstate state = nullptr;
    CHECK(fmi2GetFMUstate(slave, &state) == fmi2OK);
    throws(fmi2Error, "currentCommunicationPoint = 7", [&] { fmi2DoStep(slave, 7.0, 1e-3, fmi2True); });
    throws(fmi2Error, "may not be called in state Error", [&] { fmi2DoStep(slave, 1e-3, 1e-3, fmi2True); });
    CHECK(get(slave, FORCE) == force);
    CHECK(fmi2SetFMUstate(slave, state) == fmi2OK);
    CHECK(fmi2FreeFMUstate(slave, &state) == fmi2OK);
    CHECK(fmi2DoStep(slave, 1e-3, 1e-3, fmi2True) == fmi2OK);
    throws(fmi2Error, "vr is NULL", [&] { fmi2GetReal(slave, nullptr, 1, nullptr); });
    CHECK(fmi2Reset(slave) == fmi2OK);
    initialise(slave);
    CHECK(fmi2DoStep(slave, 0.0, 1e-3, fmi2True) == fmi2OK);
    throws(fmi2Error, "any String variable", [&] { fmi2SetString(slave, &LOAD, 1, nullptr); });
    fmi2FreeInstance(slave);
}

// One function after the other, in the state before the initialization, in which most may not be called.
void every_kind_of_call_can_throw() {
    fmi2Component slave = make(fmi2ModelExchange, STRIBECK_LUGRE_GUID);
    REQUIRE(slave != nullptr);
    double value = 0.0;
    size_t size = 0;
    fmi2Boolean flag = fmi2False;
    fmi2FMUstate state = nullptr;
    fmi2EventInfo info = {};
    const fmi2Integer order = 1;
    const char *category = "logNothing";
    throws(fmi2Error, "state", [&] { fmi2EnterEventMode(slave); });
    throws(fmi2Error, "state", [&] { fmi2NewDiscreteStates(slave, &info); });
    throws(fmi2Error, "state", [&] { fmi2CompletedIntegratorStep(slave, fmi2True, &flag, &flag); });
    throws(fmi2Error, "state", [&] { fmi2SetTime(slave, 0.0); });
    throws(fmi2Error, "99 derivatives: must be 2", [&] { fmi2GetDerivatives(slave, &value, 99); });
    throws(fmi2Error, "99 event indicators: must be 1", [&] { fmi2GetEventIndicators(slave, &value, 99); });
    throws(fmi2Error, "state", [&] { fmi2SetContinuousStates(slave, &value, 1); });
    throws(fmi2Error, "state", [&] { fmi2Terminate(slave); });
    throws(fmi2Error, "state", [&] { fmi2ExitInitializationMode(slave); });
    throws(fmi2Error, "is NULL", [&] { fmi2GetDirectionalDerivative(slave, nullptr, 1, nullptr, 1, &value, &value); });
    throws(fmi2Error, "not available", [&] { fmi2DoStep(slave, 0.0, 1e-3, fmi2True); });
    throws(fmi2Error, "not available", [&] { fmi2SetRealInputDerivatives(slave, &VELOCITY, 1, &order, &value); });
    throws(fmi2Error, "not available", [&] { fmi2GetRealStatus(slave, fmi2LastSuccessfulTime, &value); });
    throws(fmi2Error, "unknown log category", [&] { fmi2SetDebugLogging(slave, fmi2True, 1, &category); });
    throws(fmi2Error, "FMUstate is NULL", [&] { fmi2GetFMUstate(slave, nullptr); });
    throws(fmi2Error, "FMUstate is NULL", [&] { fmi2SerializedFMUstateSize(slave, nullptr, &size); });
    throws(fmi2Error, "fmi2DeSerializeFMUstate", [&] { fmi2DeSerializeFMUstate(slave, nullptr, 0, &state); });
    CHECK(fmi2Reset(slave) == fmi2OK);
    fmi2FreeInstance(slave);
}

// A disabled logger is not called, and nothing is thrown.
void silence_throws_nothing() {
    fmi2Component slave = make(fmi2CoSimulation, STRIBECK_LUGRE_GUID);
    REQUIRE(slave != nullptr);
    const int before = told;
    CHECK(fmi2SetDebugLogging(slave, fmi2False, 0, nullptr) == fmi2OK);
    CHECK(fmi2Terminate(slave) == fmi2Error);
    CHECK(told == before);
    fmi2FreeInstance(slave);
}

// The mode of the host is restored when its logger is called, and when it has thrown.
void the_mode_of_the_host_comes_back() {
    fmi2Component slave = make(fmi2CoSimulation, STRIBECK_LUGRE_GUID);
    REQUIRE(slave != nullptr);
    initialise(slave);
    REQUIRE(std::fesetround(FE_UPWARD) == 0);
    throws(fmi2Error, "must be > 0", [&] { fmi2DoStep(slave, 0.0, -1.0, fmi2True); });
    CHECK(std::fegetround() == FE_UPWARD);
    REQUIRE(std::fesetround(FE_TONEAREST) == 0);
    fmi2FreeInstance(slave);
}

} // namespace

int main() {
    nothing_is_instantiated();
    a_refused_value_changes_nothing();
    an_error_is_left_by_reset_and_by_a_saved_state();
    every_kind_of_call_can_throw();
    silence_throws_nothing();
    the_mode_of_the_host_comes_back();
    return report();
}
