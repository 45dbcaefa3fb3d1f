"""Models that are stepped by the caller."""

from __future__ import annotations

from typing import Any

from stribeck import _stribeck
from stribeck._stribeck import Refused
from stribeck.catalogue import Description, model, number
from stribeck.results import Result
from stribeck.series import simulate


class _Missing(Refused, AttributeError):
    """An attribute that does not exist, so that `hasattr` is false."""


class Part:
    """A part of a model: its variables are attributes."""

    _model: Model
    _prefix: str

    def __init__(self, owner: Model, prefix: str) -> None:
        object.__setattr__(self, "_model", owner)
        object.__setattr__(self, "_prefix", prefix)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._model._get(self._prefix + name)
        except Refused as refused:
            raise _Missing(*refused.args) from None

    def __setattr__(self, name: str, value: Any) -> None:
        self._model.set(**{self._prefix + name: value})

    def __repr__(self) -> str:
        names = [name for name in self.__dir__() if self._prefix + name in self._model.description.variables]
        values = ", ".join(f"{name} = {_shown(getattr(self, name))}" for name in names)
        return f"<{self._prefix[:-1]} of {self._model.description.name}: {values}>"

    def __dir__(self) -> list[str]:
        known = self._model.description.variables
        length = len(self._prefix)
        return sorted({name[length:].split(".")[0] for name in known if name.startswith(self._prefix)})


def _shown(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


class Model(Part):
    """A model that is stepped by the caller. Its variables are attributes, in SI units.

    >>> contact = Model("Dahl", mu_k=0.1, sigma_0=1e5, normal_force=10.0)
    >>> contact.velocity = 1e-3
    >>> contact.step(1e-3)
    >>> round(contact.friction_force, 4)  # 1 - exp(-0.1)
    0.0952

    `contact["friction.mu_k"]` is the same as `contact.friction.mu_k`; the second form completes in a shell. Parameters
    marked `Fixed`, and states, can be set until the first step. Raises `stribeck.Refused`, a ValueError, for what is
    refused; nothing has changed then.
    """

    def __init__(self, name: str | Description, *, preset: str | None = None, **values: Any) -> None:
        described = model(name)
        object.__setattr__(self, "description", described)
        object.__setattr__(self, "_instance", _stribeck.Instance(described.name, preset))
        super().__init__(self, "")
        self.set(**values)

    description: Description
    _instance: _stribeck.Instance

    @property
    def time(self) -> float:
        """Time in s."""
        return self._instance.time

    @property
    def warning(self) -> str | None:
        """Warning about present values that make no sense, or with which the model is not passive, if there are any."""
        return self._instance.warning()

    def set(self, **values: Any) -> None:
        """Sets variables: all, or none if one is refused. Names with points as `**{"friction.mu_k": 0.1}`."""
        find = self.description.find
        self._instance.set([(name, find(name).number(value)) for name, value in values.items()])

    def step(self, dt: float, **slopes: float) -> None:
        """Advances by `dt` seconds, with inputs held, or moving with these rates: `step(1e-3, velocity=2.0)`."""
        self._instance.step(number("dt", dt), [(name, number(name, slope)) for name, slope in slopes.items()])

    def reset(self) -> None:
        """Resets all variables to their start values, and the time to 0."""
        self._instance.reset()

    def __reduce__(self) -> tuple[Any, ...]:
        # Copies, and models that are sent to other processes, are steered apart from this one.
        return _restored, (type(self), self.description.name, self._instance.save())

    def __getitem__(self, name: str) -> Any:
        return self._get(name)

    def __setitem__(self, name: str, value: Any) -> None:
        self.set(**{name: value})

    def __repr__(self) -> str:
        inputs = ", ".join(f"{name} = {_shown(self._get(name))}" for name in self.description.inputs)
        return f"<{self.description.name} at {self.time:g} s: {inputs}>"

    def _get(self, name: str) -> Any:
        known = self.description.variables
        if name not in known and any(other.startswith(f"{name}.") for other in known):
            return Part(self, f"{name}.")
        variable = self.description.find(name)
        value = self._instance.get(name)
        if variable.kind == "choice":
            return variable.choices[int(value) - 1][0]
        return bool(value) if variable.kind == "boolean" else value

    def simulate(self, **inputs: Any) -> Result:
        """Results along inputs, from the start, with the present parameters: see `stribeck.simulate`."""
        parameters = {name: self._instance.get(name) for name in self.description.parameters}
        return simulate(self.description, **{**parameters, **inputs})


def _restored(kind: type[Model], name: str, state: bytes) -> Model:
    """A model as it was saved."""
    restored = kind.__new__(kind)
    Model.__init__(restored, name)
    restored._instance.load(state)
    return restored


class ShockAbsorber(Model):
    """The telescopic shock absorber: `ShockAbsorber(**{"friction.mu_k": 0.1})`.

    >>> strut = ShockAbsorber()
    >>> strut.friction.model = "LuGre"
    >>> strut.set(length=0.2, side_force_m=200.0)
    >>> strut.step(1e-3)
    >>> strut.normal_1 > 0.0  # at the rod guide
    True
    """

    def __init__(self, *, preset: str | None = None, **values: Any) -> None:
        super().__init__("ShockAbsorber", preset=preset, **values)
