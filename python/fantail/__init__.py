# SPDX-License-Identifier: MIT
"""Fantail: roll control for sounding rockets.

>>> import fantail
>>> flight = fantail.fly("tasha3_launch2", set={"controller.canard_limit_deg": 9})
>>> flight["roll_angle_deg"]        # numpy, one value a row of flight.csv
>>> flight.events["apogee_s"]       # seconds after lift-off
>>> flight.summary["verdict"]       # as in summary.json

Each verb of the programs that answers with --json is a function whose arguments are its options; help() lists them:

>>> fantail.predict("tasha3_launch1", swirl_deg=-2)["answer"]

Names carry their units. What the programs refuse raises a ValueError with the same message.
"""
import os as _os
import pathlib as _pathlib
import sys as _sys
import typing as _typing

from . import _core

# Files of other programs (fantail.files) are read by this Python.
_os.environ.setdefault("FANTAIL_PYTHON", _sys.executable)
# A wheel carries its data within; in a build tree these are links to the sources. FANTAIL_DATA goes before both.
_core.set_data_folder(str(_pathlib.Path(__file__).parent / "data"))

from ._campaign import Campaign, campaign, merge_campaign  # noqa: E402
from ._core import Inputs, Tick  # noqa: E402
from ._flight import Flight, fly, fly_many  # noqa: E402
from ._law import Autopilot  # noqa: E402
from ._log import Log, LoggedFlight, Replay, read_flight, read_log, replay  # noqa: E402
from ._plan import Plan, PlanField, plan  # noqa: E402
from ._scenario import Scenario, data_folder, shipped_scenarios  # noqa: E402
from ._verbs import functions as _functions  # noqa: E402

# A verb that has an object of its own, as fly and campaign, keeps it.
globals().update({name: function for name, function in _functions.items() if name not in globals()})
if _typing.TYPE_CHECKING:
    def __getattr__(name: str) -> _typing.Callable[..., dict[str, _typing.Any]]: ...  # each of the others

__all__ = ["Autopilot", "Campaign", "Flight", "Inputs", "Log", "LoggedFlight", "Plan", "PlanField", "Replay", "Scenario", "Tick",
           "campaign", "data_folder", "fly", "fly_many", "merge_campaign", "plan", "read_flight", "read_log", "replay", "shipped_scenarios", *sorted(_functions)]
