"""Events of FMI 3.0 whose times have a closed form, within communication steps of 50 ms."""

H = 0.05

PULLED = {"velocity": 0.006, "external_force": 0.4, "mass": 1.0, "normal_force": 9.81, "mu_k": 0.1}
# Model, start values, time of the first event in s, whether it sticks from there on: a body that friction stops against
# a pull, at m v / (f_C - f_e); a bond bent at constant velocity, which breaks at f_C / (sigma_0 v).
CASES = {
    "stick": ("Coulomb", PULLED, 0.006 / (0.981 - 0.4), True),
    "slip": ("ResetIntegrator", {"velocity": 3e-5, "normal_force": 9.81, "mu_k": 0.1}, 0.981 / (1e5 * 3e-5), False),
}
