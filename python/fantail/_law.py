# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Union

from . import _core
from ._plan import Plan
from ._scenario import Name


class Autopilot(_core.Autopilot):
    __doc__ = _core.Autopilot.__doc__

    def __init__(self, plan: Union[Plan, Name]) -> None:
        super().__init__((plan if isinstance(plan, Plan) else Plan.load(plan))._core)
