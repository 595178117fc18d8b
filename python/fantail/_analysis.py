# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
import numbers
from collections.abc import Sequence
from typing import Any, Optional, Union

from . import _arguments, _changes, _core
from ._flight import Flight
from ._log import Path
from ._scenario import Name, Scenario, asked_for

Window = Union[str, tuple[float, float]]


def _filled(asked: Any, values: dict[str, Any]) -> Any:
    for name, value in values.items():
        setattr(asked, name, _arguments.utf8(name, value) if isinstance(value, str) else value)
    return asked


def _window_words(windows: Any) -> list[str]:
    words = []
    for window in windows if isinstance(windows, Sequence) else [None]:
        if isinstance(window, str):
            words.append(window)
        elif isinstance(window, Sequence) and len(window) == 2 and all(isinstance(end, numbers.Real) for end in window):
            words.append(":".join(repr(float(end)).removesuffix(".0") for end in window))
        else:
            raise ValueError(f"windows = {windows!r}; allowed: a list of (begin_s, end_s) or of texts as --window has them")
    return words


def identify(data: Union[Flight, Path], *, windows: Union[str, Sequence[Window]] = (), nodes: str = "even:1",
             method: str = "continuous", vehicle: Optional[str] = None, inertia_kg_m2: Optional[float] = None,
             reference_area_m2: Optional[float] = None, density: Optional[str] = None,
             elevation_m: Optional[float] = None, speed_m_s: Optional[float] = None, lag_s: float = 0.0,
             fit_lag: bool = False, fit_initial: bool = False, truth: bool = False) -> dict[str, Any]:
    """The roll model in a flight or a log: damping, torque constant and disturbance, each with its uncertainty.

    What identification.json of `fantail identify` says, in the open loop; the arguments are those of its options. A
    window is "control", "thrust", "coast", "step:N", or "A:B" or (A, B) in seconds on the log's clock. Raises
    ValueError.
    """
    asked = _filled(_core.Question(), {
        "windows": [windows] if isinstance(windows, str) else _window_words(windows), "nodes": nodes, "method": method,
        "vehicle": vehicle, "inertia_kg_m2": inertia_kg_m2, "reference_area_m2": reference_area_m2, "density": density,
        "elevation_m": elevation_m, "speed_m_s": speed_m_s, "lag_s": lag_s, "fit_lag": fit_lag,
        "fit_initial": fit_initial, "truth": truth})
    if isinstance(data, Flight):
        return json.loads(_core.identify_flight(data._core, asked))
    return json.loads(_core.identify_file(_arguments.path("data", data), asked))


def predict(scenario: Union[Scenario, Name], set: Optional[_changes.Changes] = None,  # noqa: A002
            seed: Optional[int] = None, *, tunnel: Optional[Path] = None, swirl_deg: Optional[float] = None,
            damping_factor: tuple[float, float] = (1.0, 1.0), runs: int = 200, threads: int = 0,
            servo_lag_s: Optional[float] = None, servo_delay_s: Optional[float] = None, other_vehicle: bool = False,
            authority_percent: float = 95.0, held_percent: float = 90.0,
            phase_margin_deg: float = 30.0) -> dict[str, Any]:
    """Flies a launch over the spread of a tunnel result, and says go or no go, with the reasons.

    What predict.json of `fantail predict` says; the arguments are those of its options. `tunnel`: a steps.csv or a
    shipped name, instead of the scenario's own. Raises ValueError.
    """
    low, high = damping_factor
    for name, value, least, most in (("swirl_deg", swirl_deg, -45.0, 45.0), ("damping_factor", low, 0.1, high),
                                     ("damping_factor", high, low, 10.0), ("runs", runs, 1, 100_000),
                                     ("threads", threads, 0, 1024), ("servo_lag_s", servo_lag_s, 0.0005, 1.0),
                                     ("servo_delay_s", servo_delay_s, 0.0, 0.05),
                                     ("authority_percent", authority_percent, 0.0, 99.9),
                                     ("held_percent", held_percent, 0.0, 99.9),
                                     ("phase_margin_deg", phase_margin_deg, 0.0, 90.0)):
        _arguments.in_range(name, value, least, most)
    scenario = asked_for(scenario, set, seed)
    spread = _filled(_core.Spread(), {
        "tunnel": None if tunnel is None else _arguments.path("tunnel", tunnel), "swirl_deg": swirl_deg,
        "damping_factor": damping_factor, "runs": runs, "threads": threads, "servo_lag_s": servo_lag_s,
        "servo_delay_s": servo_delay_s, "other_vehicle": other_vehicle})
    return json.loads(_core.predict(scenario._core, spread, authority_percent, held_percent, phase_margin_deg))
