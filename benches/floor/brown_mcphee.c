/* Brown-McPhee, as written by a C programmer who trusts every caller; no viscous part.
 *
 *   f = f_C tanh(4 v / v_0) + (f_s - f_C) (v / v_0) / ((v / v_0)^2 / 4 + 3 / 4)^2
 */
enum {
    VELOCITY,
    NORMAL_FORCE,
    FRICTION_FORCE,
    DISSIPATED_POWER,
    STICKING,
    DISSIPATED_ENERGY,
    MU_K,
    MU_S,
    TRANSITION_VELOCITY,
    COLUMNS
};

static const double START[COLUMNS] = {0.0, 9.81, 0.0, 0.0, 0.0, 0.0, 0.1, 0.15, 1e-3};

#include "fmu.h"

static void advance(double *row, double dt) {
    double v = row[VELOCITY];
    double u = v / row[TRANSITION_VELOCITY];
    double coulomb = row[MU_K] * row[NORMAL_FORCE];
    double base = 0.25 * u * u + 0.75;
    double force = coulomb * tanh(4.0 * u) + (row[MU_S] * row[NORMAL_FORCE] - coulomb) * u / (base * base);
    row[FRICTION_FORCE] = force;
    row[DISSIPATED_POWER] = force * v;
    row[DISSIPATED_ENERGY] += force * v * dt;
    row[STICKING] = fabs(v) < row[TRANSITION_VELOCITY];
}
