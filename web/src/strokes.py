import numpy
import stribeck

given = {
@given@}
@curve@
# Strokes to and fro, whose speed rises and falls along straight lines.
speed, dt = @speed@, @every@  # m/s, s
k = numpy.arange(@samples@) % @period@
u = k / @quarter@
velocity = speed * numpy.where(u <= 1, u, numpy.where(u <= 3, 2 - u, u - 4))
@acceleration@loop = stribeck.simulate("@model@", @velocity@=velocity@lead@, dt=dt, **given)
way = numpy.concatenate([[0.0], numpy.cumsum(0.5 * (velocity[:-1] + velocity[1:]) * dt)])  # m
print(loop["@force@"])
