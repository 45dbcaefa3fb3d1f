// The ShockAbsorber as an actuator of MuJoCo, through Stribeck's C interface: no FMU, no Python in the loop.
//
//     <extension>
//       <plugin plugin="stribeck.shock_absorber">
//         <instance name="strut"><config key="spring.k" value="60000"/></instance>
//       </plugin>
//     </extension>
//     <actuator>
//       <plugin name="strut" plugin="stribeck.shock_absorber" instance="strut" tendon="strut"/>
//     </actuator>
//
// The tendon runs from eye to eye. Keys are the parameters of the ShockAbsorber; an enumeration takes the number of the
// choice, from 1, a Boolean 0 or 1. Tables and elements, such as damper.tab_v[1] to damper.tab_v[16], are one key
// without the index whose value is a list of numbers, from the first: MuJoCo admits 255 keys. build_plugin.py compiles
// this file, run_plugin.py uses it.
//
// The strut's memory is kept in MuJoCo's plugin state, so that copies of the simulation, mj_setState and repeated calls
// of mj_forward work correctly: `compute` always begins where the last complete step ended.

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "stribeck.h"

namespace {

constexpr const char *plugin_name = "stribeck.shock_absorber";

using Keys = std::map<std::string, std::vector<std::string>>;

// The name of a variable without its index: damper.tab_v for damper.tab_v[1].
std::string without_index(std::string name) {
    const std::size_t from = name.find('['), to = name.find(']');
    return from == std::string::npos ? name : name.erase(from, to + 1 - from);
}

class ShockAbsorber {
  public:
    ShockAbsorber() {
        stribeck_instance *created = nullptr;
        const stribeck_status status = stribeck_create("ShockAbsorber", &created);
        if (status != STRIBECK_OK) {
            throw std::runtime_error(std::string("ShockAbsorber: ") + stribeck_status_text(status));
        }
        handle.reset(created);
        length = column("length");
        velocity = column("velocity");
        force = column("force");
    }

    // Parameters by their key: several for a table.
    Keys parameters() const {
        Keys keys;
        for (std::uint32_t index = 0; index < stribeck_variable_count(handle.get()); ++index) {
            std::uint32_t reference = 0;
            stribeck_variable variable{};
            check(stribeck_reference(handle.get(), index, &reference));
            check(stribeck_describe(handle.get(), reference, &variable));
            if (variable.role == STRIBECK_FIXED || variable.role == STRIBECK_TUNABLE) {
                keys[without_index(variable.name)].emplace_back(variable.name);
            }
        }
        return keys;
    }

    // Sets the parameters of a key: one, or the first ones of a table.
    void set(const std::string &key, const std::vector<std::string> &parameters, const char *text) {
        std::size_t count = 0;
        for (const char *rest = text; *rest != '\0'; ++count) {
            char *end = nullptr;
            const double value = std::strtod(rest, &end);
            if (end == rest || (*end != '\0' && *end != ' ')) {
                throw std::runtime_error(key + " = '" + text + "': must be a number");
            }
            if (count == parameters.size()) {
                throw std::runtime_error(key + ": must have at most " + std::to_string(count) + " numbers");
            }
            check(stribeck_set_by_name(handle.get(), parameters[count].c_str(), value));
            rest = end + std::strspn(end, " ");
        }
    }

    // One step from a saved state; returns the force. Usually the model is still in that state.
    double step(const mjtNum *state, double now_length, double now_velocity, double dt) {
        if (here.empty() || std::memcmp(here.data(), state, state_size()) != 0) {
            check(stribeck_restore(handle.get(), state, state_size()));
        }
        here.clear();
        check(stribeck_set(handle.get(), length, now_length));
        check(stribeck_set(handle.get(), velocity, now_velocity));
        check(stribeck_step(handle.get(), dt));
        double result = 0.0;
        check(stribeck_get(handle.get(), force, &result));
        return result;
    }

    void save(mjtNum *state) {
        check(stribeck_save(handle.get(), state, state_size()));
        here.assign(state, state + numbers());
    }

    // Checks that the parameters are consistent.
    void settle() {
        check(stribeck_output(handle.get()));
    }

    // Size of the state in numbers of MuJoCo.
    int numbers() const {
        return static_cast<int>((state_size() + sizeof(mjtNum) - 1) / sizeof(mjtNum));
    }

    int actuator = -1;

  private:
    struct Deleter {
        void operator()(stribeck_instance *model) const noexcept {
            stribeck_free(model);
        }
    };

    std::size_t state_size() const {
        return stribeck_state_size(handle.get());
    }

    std::uint32_t column(const char *variable) {
        std::uint32_t found = 0;
        check(stribeck_find(handle.get(), variable, &found));
        return found;
    }

    void check(stribeck_status status) const {
        if (status != STRIBECK_OK) {
            throw std::runtime_error(stribeck_last_error(handle.get()));
        }
    }

    std::unique_ptr<stribeck_instance, Deleter> handle;
    std::uint32_t length = 0;
    std::uint32_t velocity = 0;
    std::uint32_t force = 0;
    // The present state of the model, if it is a saved one.
    std::vector<mjtNum> here;
};

// The initial state of a strut, also after mj_resetData; `model` is the one that steps.
struct Instance {
    ShockAbsorber model;
    std::vector<mjtNum> start;
};

const Keys &parameters() {
    static const Keys keys = ShockAbsorber().parameters();
    return keys;
}

Instance &instance_of(const mjData *d, int instance) {
    return *reinterpret_cast<Instance *>(d->plugin_data[instance]);
}

mjtNum *state_of(const mjModel *m, const mjData *d, int instance) {
    return d->plugin_state + m->plugin_stateadr[instance];
}

int actuator_of(const mjModel *m, int instance) {
    for (int at = 0; at < m->nu; ++at) {
        if (m->actuator_plugin[at] == instance) {
            return at;
        }
    }
    throw std::runtime_error("no actuator uses this instance");
}

int nstate(const mjModel *, int) {
    static const int numbers = ShockAbsorber().numbers();
    return numbers;
}

// MuJoCo reports which plugin could not be initialised; the warning says why.
int init(const mjModel *m, mjData *d, int instance) {
    try {
        if (m->opt.integrator == mjINT_RK4) {
            throw std::runtime_error("the integrator RK4 evaluates forces within a step: choose Euler or implicitfast");
        }
        auto created = std::make_unique<Instance>();
        created->model.actuator = actuator_of(m, instance);
        for (const auto &[key, names] : parameters()) {
            const char *text = mj_getPluginConfig(m, instance, key.c_str());
            if (text != nullptr && *text != '\0') {
                created->model.set(key, names, text);
            }
        }
        created->model.settle();
        created->start.resize(static_cast<std::size_t>(created->model.numbers()));
        created->model.save(created->start.data());
        d->plugin_data[instance] = reinterpret_cast<std::uintptr_t>(created.release());
        return 0;
    } catch (const std::exception &refused) {
        mju_warning("%s: %s", plugin_name, refused.what());
        return -1;
    }
}

void destroy(mjData *d, int instance) {
    delete &instance_of(d, instance);
    d->plugin_data[instance] = 0;
}

void reset(const mjModel *, mjtNum *state, void *data, int) {
    const std::vector<mjtNum> &start = static_cast<Instance *>(data)->start;
    mju_copy(state, start.data(), static_cast<int>(start.size()));
}

void step(const mjModel *m, mjData *d, int instance) {
    ShockAbsorber &model = instance_of(d, instance).model;
    const int at = model.actuator;
    d->actuator_force[at] =
        model.step(state_of(m, d, instance), d->actuator_length[at], d->actuator_velocity[at], m->opt.timestep);
}

void compute(const mjModel *m, mjData *d, int instance, int) {
    try {
        step(m, d, instance);
    } catch (const std::exception &refused) {
        mju_error("%s at %g s: %s", plugin_name, d->time, refused.what());
    }
}

// Accepts the step tried by `compute`.
void advance(const mjModel *m, mjData *d, int instance) {
    try {
        instance_of(d, instance).model.save(state_of(m, d, instance));
    } catch (const std::exception &refused) {
        mju_error("%s at %g s: %s", plugin_name, d->time, refused.what());
    }
}

} // namespace

mjPLUGIN_LIB_INIT(stribeck_shock_absorber) {
    static std::vector<const char *> attributes;
    for (const auto &[key, names] : parameters()) {
        attributes.push_back(key.c_str());
    }
    mjpPlugin plugin;
    mjp_defaultPlugin(&plugin);
    plugin.name = plugin_name;
    plugin.capabilityflags = mjPLUGIN_ACTUATOR;
    plugin.nattribute = static_cast<int>(attributes.size());
    plugin.attributes = attributes.data();
    plugin.nstate = nstate;
    plugin.init = init;
    plugin.destroy = destroy;
    plugin.reset = reset;
    plugin.compute = compute;
    plugin.advance = advance;
    mjp_registerPlugin(&plugin);
}
