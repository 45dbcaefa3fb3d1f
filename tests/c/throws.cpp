// A host in C++ whose logger throws, in both versions of FMI, or whose callback within a step does. The exception
// reaches the host, and leaves the instance in the state implied by the status: a refused value has changed nothing,
// and after an error reset, free and restore are allowed.
#include <cfenv>
#include <cstdarg>
#include <stdexcept>
#include <string>
#include <vector>

#include "check.h"
#include "fmi3Functions.h"
#include "stribeck.h"

namespace {

// The status of both versions has the same numbers.
enum { OK = fmi2OK, DISCARD = fmi2Discard, ERROR = fmi2Error };

// An object to be destroyed during unwinding, as hosts have.
struct Complaint : std::runtime_error {
    Complaint(int given, const std::string &text) : std::runtime_error(text), status(given) {}
    int status;
};

int told = 0;

void throwing_logger_2(fmi2ComponentEnvironment, fmi2String, fmi2Status status, fmi2String, fmi2String format, ...) {
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    told++;
    throw Complaint(status, text);
}

void throwing_logger_3(fmi3InstanceEnvironment, fmi3Status status, fmi3String, fmi3String text) {
    told++;
    throw Complaint(status, text);
}

const fmi2CallbackFunctions CALLBACKS = {throwing_logger_2, nullptr, nullptr, nullptr, nullptr};

const uint32_t VELOCITY = STRIBECK_LUGRE_VELOCITY;
const uint32_t LOAD = STRIBECK_LUGRE_NORMAL_FORCE;
const uint32_t FORCE = STRIBECK_LUGRE_FRICTION_FORCE;

struct Fmi2 {
    using State = fmi2FMUstate;
    // With loggingOn = false: the reason of a failure is logged in any case.
    static void *make(const char *guid, bool is_exchange = false) {
        const fmi2Type type = is_exchange ? fmi2ModelExchange : fmi2CoSimulation;
        return fmi2Instantiate("throws", type, guid, nullptr, &CALLBACKS, fmi2False, fmi2False);
    }
    static constexpr auto free = fmi2FreeInstance;
    static int initialise(void *slave) {
        CHECK(fmi2SetupExperiment(slave, fmi2False, 0.0, 0.0, fmi2False, 0.0) == fmi2OK);
        CHECK(fmi2EnterInitializationMode(slave) == fmi2OK);
        return fmi2ExitInitializationMode(slave);
    }
    static int step(void *slave, double time, double length) {
        return fmi2DoStep(slave, time, length, fmi2True);
    }
    static int set(void *slave, uint32_t reference, double value) {
        return fmi2SetReal(slave, &reference, 1, &value);
    }
    static int get(void *slave, uint32_t reference, double *value) {
        return fmi2GetReal(slave, &reference, 1, value);
    }
    static int get_nothing(void *slave) {
        return fmi2GetReal(slave, nullptr, 1, nullptr);
    }
    static int set_text(void *slave) {
        return fmi2SetString(slave, &LOAD, 1, nullptr);
    }
    static constexpr auto reset = fmi2Reset;
    static constexpr auto terminate = fmi2Terminate;
    static constexpr auto save = fmi2GetFMUstate;
    static constexpr auto restore = fmi2SetFMUstate;
    static constexpr auto free_state = fmi2FreeFMUstate;
    static int silence(void *slave) {
        return fmi2SetDebugLogging(slave, fmi2False, 0, nullptr);
    }
    static constexpr const char *NO_MODEL = "does not belong to a model";
    static constexpr const char *NO_TEXT = "any String variable";
    static constexpr const char *NO_REFERENCES = "vr is NULL";
    static void each_call(void *slave);
};

struct Fmi3 {
    using State = fmi3FMUState;
    static void *make(const char *token, bool is_exchange = false) {
        return is_exchange
                   ? fmi3InstantiateModelExchange("throws", token, nullptr, false, true, nullptr, throwing_logger_3)
                   : fmi3InstantiateCoSimulation("throws", token, nullptr, false, true, false, false, nullptr, 0,
                                                 nullptr, throwing_logger_3, nullptr);
    }
    static constexpr auto free = fmi3FreeInstance;
    static int initialise(void *slave) {
        CHECK(fmi3EnterInitializationMode(slave, false, 0.0, 0.0, false, 0.0) == fmi3OK);
        return fmi3ExitInitializationMode(slave);
    }
    static int step(void *slave, double time, double length) {
        bool event, terminate, early;
        double reached;
        return fmi3DoStep(slave, time, length, true, &event, &terminate, &early, &reached);
    }
    static int set(void *slave, uint32_t reference, double value) {
        return fmi3SetFloat64(slave, &reference, 1, &value, 1);
    }
    static int get(void *slave, uint32_t reference, double *value) {
        return fmi3GetFloat64(slave, &reference, 1, value, 1);
    }
    static int get_nothing(void *slave) {
        return fmi3GetFloat64(slave, nullptr, 1, nullptr, 1);
    }
    static int set_text(void *slave) {
        return fmi3SetString(slave, &LOAD, 1, nullptr, 1);
    }
    static constexpr auto reset = fmi3Reset;
    static constexpr auto terminate = fmi3Terminate;
    static constexpr auto save = fmi3GetFMUState;
    static constexpr auto restore = fmi3SetFMUState;
    static constexpr auto free_state = fmi3FreeFMUState;
    static int silence(void *slave) {
        return fmi3SetDebugLogging(slave, false, 0, nullptr);
    }
    static constexpr const char *NO_MODEL = "does not belong to a model";
    static constexpr const char *NO_TEXT = "not String";
    static constexpr const char *NO_REFERENCES = "valueReferences is NULL";
    static void each_call(void *slave);
};

// The call must throw the logger's exception, with this status and a text that contains `why`.
template <typename Call>
void throws(int status, const char *why, Call call) {
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

// An instance of LuGre after the initialization, which in FMI 3.0 warns if it logs at all.
template <class Fmi>
void *ready() {
    void *slave = Fmi::make(STRIBECK_LUGRE_GUID);
    REQUIRE(slave != nullptr);
    CHECK(Fmi::set(slave, STRIBECK_LUGRE_VISCOUS_COEFFICIENT, 1e4) == OK);
    CHECK(Fmi::initialise(slave) == OK);
    return slave;
}

template <class Fmi>
double get(void *slave, uint32_t reference) {
    double value = -1.0;
    CHECK(Fmi::get(slave, reference, &value) == OK);
    return value;
}

template <class Fmi>
void nothing_is_instantiated() {
    throws(ERROR, Fmi::NO_MODEL, [] { Fmi::make("{no such model}"); });
    const std::string endless(10000, '#');
    throws(ERROR, "##", [&] { Fmi::make(endless.c_str()); });
}

template <class Fmi>
void a_refused_value_changes_nothing() {
    void *slave = ready<Fmi>();
    CHECK(Fmi::set(slave, VELOCITY, 1e-3) == OK);
    CHECK(Fmi::step(slave, 0.0, 1e-3) == OK);
    const double force = get<Fmi>(slave, FORCE), load = get<Fmi>(slave, LOAD);
    throws(DISCARD, "normal_force = -1: must be >= 0", [&] { Fmi::set(slave, LOAD, -1.0); });
    CHECK(get<Fmi>(slave, LOAD) == load && get<Fmi>(slave, FORCE) == force);
    CHECK(Fmi::step(slave, 1e-3, 1e-3) == OK);
    Fmi::free(slave);
}

template <class Fmi>
void an_error_is_left_by_reset_and_by_a_saved_state() {
    void *slave = ready<Fmi>();
    CHECK(Fmi::set(slave, VELOCITY, 1e-3) == OK);
    CHECK(Fmi::step(slave, 0.0, 1e-3) == OK);
    const double force = get<Fmi>(slave, FORCE);
    typename Fmi::State state = nullptr;
    CHECK(int(Fmi::save(slave, &state)) == OK);
    throws(ERROR, "currentCommunicationPoint = 7", [&] { Fmi::step(slave, 7.0, 1e-3); });
    throws(ERROR, "may not be called in state Error", [&] { Fmi::step(slave, 1e-3, 1e-3); });
    CHECK(get<Fmi>(slave, FORCE) == force);
    CHECK(int(Fmi::restore(slave, state)) == OK);
    CHECK(int(Fmi::free_state(slave, &state)) == OK);
    CHECK(Fmi::step(slave, 1e-3, 1e-3) == OK);
    throws(ERROR, Fmi::NO_REFERENCES, [&] { Fmi::get_nothing(slave); });
    CHECK(int(Fmi::reset(slave)) == OK);
    CHECK(Fmi::set(slave, STRIBECK_LUGRE_VISCOUS_COEFFICIENT, 1e4) == OK);
    CHECK(Fmi::initialise(slave) == OK);
    CHECK(Fmi::step(slave, 0.0, 1e-3) == OK);
    throws(ERROR, Fmi::NO_TEXT, [&] { Fmi::set_text(slave); });
    Fmi::free(slave);
}

// One function after the other, in the state before the initialization, in which most may not be called.
template <class Fmi>
void every_kind_of_call_can_throw() {
    void *slave = Fmi::make(STRIBECK_LUGRE_GUID, true);
    REQUIRE(slave != nullptr);
    Fmi::each_call(slave);
    CHECK(int(Fmi::reset(slave)) == OK);
    Fmi::free(slave);
}

void Fmi2::each_call(void *slave) {
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
}

void Fmi3::each_call(void *slave) {
    double value = 0.0;
    size_t size = 0;
    bool a, b, c, d, e;
    fmi3FMUState state = nullptr;
    const fmi3Int32 order = 1;
    const char *category = "logNothing";
    throws(fmi3Error, "state", [&] { fmi3EnterEventMode(slave); });
    throws(fmi3Error, "state", [&] { fmi3UpdateDiscreteStates(slave, &a, &b, &c, &d, &e, &value); });
    throws(fmi3Error, "state", [&] { fmi3CompletedIntegratorStep(slave, true, &a, &b); });
    throws(fmi3Error, "state", [&] { fmi3SetTime(slave, 0.0); });
    throws(fmi3Error, "state", [&] { fmi3SetContinuousStates(slave, &value, 1); });
    throws(fmi3Error, "state", [&] { fmi3Terminate(slave); });
    throws(fmi3Error, "state", [&] { fmi3ExitInitializationMode(slave); });
    throws(fmi3Error, "state", [&] { fmi3ExitConfigurationMode(slave); });
    throws(fmi3Error, "not available", [&] { fmi3EnterStepMode(slave); });
    throws(fmi3Error, "not available", [&] { fmi3DoStep(slave, 0.0, 1e-3, true, &a, &b, &c, &value); });
    throws(fmi3Error, "not available", [&] { fmi3GetOutputDerivatives(slave, &FORCE, 1, &order, &value, 1); });
    throws(fmi3Error, "unknown log category", [&] { fmi3SetDebugLogging(slave, true, 1, &category); });
    throws(fmi3Error, "FMUState is NULL", [&] { fmi3GetFMUState(slave, nullptr); });
    throws(fmi3Error, "FMUState is NULL", [&] { fmi3SerializedFMUStateSize(slave, nullptr, &size); });
    throws(fmi3Error, "fmi3DeserializeFMUState", [&] { fmi3DeserializeFMUState(slave, nullptr, 0, &state); });
    throws(fmi3Error, "dependencies", [&] { fmi3GetNumberOfVariableDependencies(slave, FORCE, &size); });
}

// A disabled logger is not called, and nothing is thrown.
template <class Fmi>
void silence_throws_nothing() {
    void *slave = Fmi::make(STRIBECK_LUGRE_GUID);
    REQUIRE(slave != nullptr);
    const int before = told;
    CHECK(Fmi::silence(slave) == OK);
    CHECK(int(Fmi::terminate(slave)) == ERROR);
    CHECK(told == before);
    Fmi::free(slave);
}

// The mode of the host is restored when its logger is called, and when it has thrown.
template <class Fmi>
void the_mode_of_the_host_comes_back() {
    void *slave = ready<Fmi>();
    REQUIRE(std::fesetround(FE_UPWARD) == 0);
    throws(ERROR, "must be > 0", [&] { Fmi::step(slave, 0.0, -1.0); });
    CHECK(std::fegetround() == FE_UPWARD);
    REQUIRE(std::fesetround(FE_TONEAREST) == 0);
    Fmi::free(slave);
}

template <class Fmi>
void each_test() {
    nothing_is_instantiated<Fmi>();
    a_refused_value_changes_nothing<Fmi>();
    an_error_is_left_by_reset_and_by_a_saved_state<Fmi>();
    every_kind_of_call_can_throw<Fmi>();
    silence_throws_nothing<Fmi>();
    the_mode_of_the_host_comes_back<Fmi>();
}

// At which of its calls the callback within a step throws.
int visits_left = 0;

void throwing_visit(fmi3InstanceEnvironment, double, bool, bool, bool, bool, bool *, double *) {
    if (--visits_left == 0) {
        throw Complaint(OK, "within a step");
    }
}

// The next call is one within the step, an error; after a reset the instance is as good as a new one.
void a_callback_within_a_step_may_throw() {
    for (int visit : {1, 2, 4}) {
        visits_left = visit;
        void *slave = fmi3InstantiateCoSimulation("throws", STRIBECK_LUGRE_GUID, nullptr, false, false, false, false,
                                                  nullptr, 0, nullptr, nullptr, throwing_visit);
        REQUIRE(slave != nullptr);
        CHECK(Fmi3::initialise(slave) == OK);
        throws(OK, "within a step", [&] { Fmi3::step(slave, 0.0, 1e-3); });
        CHECK(Fmi3::step(slave, 0.0, 1e-3) == ERROR);
        CHECK(fmi3Reset(slave) == fmi3OK);
        void *other = ready<Fmi3>();
        CHECK(Fmi3::set(slave, STRIBECK_LUGRE_VISCOUS_COEFFICIENT, 1e4) == OK);
        CHECK(Fmi3::initialise(slave) == OK);
        for (void *one : {slave, other}) {
            CHECK(Fmi3::set(one, VELOCITY, 1e-3) == OK);
            CHECK(Fmi3::step(one, 0.0, 1e-3) == OK);
        }
        const double force = get<Fmi3>(slave, FORCE);
        CHECK(force > 0.0 && force == get<Fmi3>(other, FORCE));
        Fmi3::free(other);
        Fmi3::free(slave);
    }
}

} // namespace

int main() {
    each_test<Fmi2>();
    each_test<Fmi3>();
    a_callback_within_a_step_may_throw();
    return report();
}
