/* LuGre with the exact step, as written by a C programmer who trusts every caller: delta = 2, constant damping, always
   loaded. *
 *   dz/dt = v - sigma_0 |v| z / g(v),   g(v) = f_C + (f_s - f_C) exp(-(v / v_S)^2)
 *   f     = sigma_0 z + sigma_1 dz/dt + sigma_2 v
 */
enum {
    VELOCITY,
    NORMAL_FORCE,
    FRICTION_FORCE,
    DISSIPATED_POWER,
    STICKING,
    DISSIPATED_ENERGY,
    BRISTLE_DEFLECTION,
    MU_K,
    MU_S,
    STRIBECK_VELOCITY,
    SIGMA_0,
    SIGMA_1,
    SIGMA_2,
    COLUMNS
};

static const double START[COLUMNS] = {
    0.0, 9.81, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.15, 1e-3, 1e5, 316.22776601683794, 0.1,
};

#include "fmu.h"

static void advance(double *row, double dt) {
    double v = row[VELOCITY];
    double u = v / row[STRIBECK_VELOCITY];
    double coulomb = row[MU_K] * row[NORMAL_FORCE];
    double level = coulomb + (row[MU_S] * row[NORMAL_FORCE] - coulomb) * exp(-u * u);
    double direction = v > 0.0 ? 1.0 : -1.0;
    double distance = v * dt;

    double steady = direction * level / row[SIGMA_0];
    double change = (row[BRISTLE_DEFLECTION] - steady) * expm1(-row[SIGMA_0] * fabs(distance) / level);
    row[BRISTLE_DEFLECTION] += change;
    row[DISSIPATED_ENERGY] +=
        direction * level * (distance - change) + row[SIGMA_1] * v * change + row[SIGMA_2] * v * distance;

    double rate = v - row[SIGMA_0] * fabs(v) * row[BRISTLE_DEFLECTION] / level;
    row[FRICTION_FORCE] = row[SIGMA_0] * row[BRISTLE_DEFLECTION] + row[SIGMA_1] * rate + row[SIGMA_2] * v;
    row[DISSIPATED_POWER] = row[FRICTION_FORCE] * v;
    row[STICKING] = direction * rate > 0.01 * fabs(v);
}
