// Pre-sliding hysteresis: a contact moved back and forth by 20 micrometres, with Stribeck's C interface from C++17.
//
//     c++ -std=c++17 -Iinclude examples/cpp/hysteresis.cpp -Ltarget/release -lstribeck -o hysteresis
//     LD_LIBRARY_PATH=target/release ./hysteresis loop.csv
//
// Before it slides, a contact yields like a spring that is never quite elastic. Dahl's law describes the loop of force
// over displacement, and for a triangular motion of stroke 2 X the energy of the loop has a closed form:
//
//     E = 4 f_C X - 4 f_C^2 / sigma_0 tanh(sigma_0 X / f_C)
//
// The program writes the loop to a CSV file and prints both energies.

#include <cmath>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "stribeck.h"

// A model that frees itself and throws errors as exceptions. This is the complete wrapper: copy it.
class Model {
  public:
    explicit Model(const std::string &name) {
        stribeck_instance *created = nullptr;
        const stribeck_status status = stribeck_create(name.c_str(), &created);
        if (status != STRIBECK_OK) {
            throw std::invalid_argument(name + ": " + stribeck_status_text(status));
        }
        handle.reset(created);
    }

    // Variables are addressed by their column: look the name up once.
    std::uint32_t column(const std::string &variable) {
        std::uint32_t found = 0;
        check(stribeck_find(handle.get(), variable.c_str(), &found));
        return found;
    }

    double get(std::uint32_t column) {
        double value = 0.0;
        check(stribeck_get(handle.get(), column, &value));
        return value;
    }

    double get(const std::string &variable) {
        return get(column(variable));
    }

    void set(std::uint32_t column, double value) {
        check(stribeck_set(handle.get(), column, value));
    }

    void step(double dt) {
        check(stribeck_step(handle.get(), dt));
    }

  private:
    struct Deleter {
        void operator()(stribeck_instance *model) const noexcept {
            stribeck_free(model);
        }
    };

    void check(stribeck_status status) const {
        if (status != STRIBECK_OK) {
            throw std::runtime_error(stribeck_last_error(handle.get()));
        }
    }

    std::unique_ptr<stribeck_instance, Deleter> handle;
};

// Moves the contact from one end of its stroke to the other at constant speed.
class Bench {
  public:
    static constexpr double amplitude = 20e-6; // m

    explicit Bench(std::ostream &output) : csv(output) {
        csv << "position_m,friction_force_N\n" << std::setprecision(9);
    }

    void move_by(double distance, bool record) {
        constexpr int pieces = 200;
        constexpr double dt = 1e-3; // s
        law.set(velocity, distance / (pieces * dt));
        for (int piece = 0; piece < pieces; ++piece) {
            law.step(dt);
            position += distance / pieces;
            if (record) {
                csv << position << ',' << law.get(friction_force) << '\n';
            }
        }
    }

    // Energy of one closed loop.
    double loop(bool record) {
        const double before = law.get(dissipated_energy);
        move_by(-2.0 * amplitude, record);
        move_by(+2.0 * amplitude, record);
        return law.get(dissipated_energy) - before;
    }

    Model law{"Dahl"};

  private:
    std::ostream &csv;
    const std::uint32_t velocity = law.column("velocity");
    const std::uint32_t friction_force = law.column("friction_force");
    const std::uint32_t dissipated_energy = law.column("dissipated_energy");
    double position = 0.0;
};

static double closed_form(Model &law) {
    const double level = law.get("mu_k") * law.get("normal_force");
    const double stiffness = law.get("sigma_0");
    const double stroke = Bench::amplitude;
    return 4.0 * level * stroke - 4.0 * level * level / stiffness * std::tanh(stiffness * stroke / level);
}

static void run(const char *path) {
    std::ofstream csv(path);
    Bench bench(csv);
    bench.move_by(Bench::amplitude, true);
    // The first loops depend on the initial state; each loop removes most of that dependence.
    for (int loop = 0; loop < 10; ++loop) {
        bench.loop(true);
    }
    const double energy = bench.loop(false);
    const double expected = closed_form(bench.law);
    csv.close();
    if (!csv) {
        throw std::runtime_error(std::string("cannot write ") + path);
    }
    std::cout << std::setprecision(10) << "energy of the closed loop  " << energy << " J\n"
              << "closed form                " << expected << " J\n"
              << "relative difference        " << std::setprecision(2) << energy / expected - 1.0 << '\n'
              << "the loop is in             " << path << '\n';
}

// A rejected value throws an exception that names the variable, its value and the limit.
static void show_refusal() {
    Model law("Dahl");
    try {
        law.set(law.column("sigma_0"), -1.0);
    } catch (const std::runtime_error &refused) {
        std::cout << "refused, as it should be:  " << refused.what() << '\n';
        return;
    }
    throw std::logic_error("a negative stiffness was accepted");
}

int main(int argc, char **argv) {
    if (argc != 2) {
        std::cerr << "usage: " << argv[0] << " loop.csv\n";
        return 2;
    }
    try {
        run(argv[1]);
        show_refusal();
    } catch (const std::exception &error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
