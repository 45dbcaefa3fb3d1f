"""Friction force models and a telescopic shock absorber.

>>> import numpy, stribeck
>>> velocity = numpy.array([-0.1, 0.001, 0.1])  # m/s
>>> stribeck.force("CoulombViscous", velocity, 10.0, mu_k=0.2, viscous_coefficient=1.0)
array([-2.1  ,  2.001,  2.1  ])

`laws` and `models` list what there is, `law` and `model` describe one. `force` gives the force in steady sliding,
`simulate` the force along measured or computed motions, `solve` and `compare` the motion of whole systems, `study`
many of them, `identify` the parameters of a law from measured friction, `fmu` the path of an FMU. `Model`,
`ShockAbsorber` and a `batch` of many are stepped by the caller, a `Tyre` is asked for its forces.

Units are SI. `velocity` is that of body 1 relative to body 2; `friction_force` has its sign when sliding, and body 1
feels the negative.
"""

from stribeck._stribeck import Refused, __version__
from stribeck.batches import Batch, batch
from stribeck.catalogue import Description, Preset, Variable, law, laws, model, models
from stribeck.fmus import fmu
from stribeck.identification import Estimate, Fit, Identification, Judgement, identify
from stribeck.instances import Model, ShockAbsorber
from stribeck.results import Result
from stribeck.series import force, simulate
from stribeck.studies import Table, study
from stribeck.systems import (
    Check,
    Comparison,
    Deviation,
    Difference,
    FoundStep,
    NotConverged,
    Solution,
    compare,
    find_step,
    solve,
    solvers,
    systems,
)
from stribeck.tyres import Tyre, TyreRadii, TyreWrench

__all__ = [
    "Batch",
    "Check",
    "Comparison",
    "Description",
    "Deviation",
    "Difference",
    "Estimate",
    "Fit",
    "FoundStep",
    "Identification",
    "Judgement",
    "Model",
    "NotConverged",
    "Preset",
    "Refused",
    "Result",
    "ShockAbsorber",
    "Solution",
    "Table",
    "Tyre",
    "TyreRadii",
    "TyreWrench",
    "Variable",
    "__version__",
    "batch",
    "compare",
    "find_step",
    "fmu",
    "force",
    "identify",
    "law",
    "laws",
    "model",
    "models",
    "simulate",
    "solve",
    "solvers",
    "study",
    "systems",
]
