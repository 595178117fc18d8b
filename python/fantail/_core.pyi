# SPDX-License-Identifier: MIT
"""The libraries of Fantail; use the package fantail instead."""

from collections.abc import Sequence
from typing import Annotated

import numpy
from numpy.typing import NDArray


class Plan:
    @staticmethod
    def load(name_or_path: str, changes: Sequence[str]) -> Plan: ...

    @staticmethod
    def default() -> Plan: ...

    def changed(self, changes: Sequence[str]) -> Plan: ...

    @property
    def values_json(self) -> str: ...

    @property
    def table(self) -> str: ...

    @property
    def block(self) -> bytes: ...

    def __reduce_ex__(self, arg: int, /) -> object: ...

def plan_fields_json() -> str: ...

class Scenario:
    @staticmethod
    def load(source: str, changes: Sequence[str], seed: str) -> Scenario: ...

    @property
    def source(self) -> str: ...

    @property
    def changes(self) -> list[str]: ...

    @property
    def seed_text(self) -> str: ...

    @property
    def name(self) -> str: ...

    @property
    def vehicle(self) -> str: ...

    @property
    def plan_name(self) -> str: ...

    @property
    def seed(self) -> int: ...

    @property
    def plan(self) -> Plan: ...

    @property
    def warnings(self) -> list[str]: ...

    def __reduce_ex__(self, arg: int, /) -> object: ...

def set_data_folder(folder: str) -> None: ...

def data_folder() -> str: ...

def shipped_scenarios() -> list[str]: ...

class Flight:
    @property
    def column_names(self) -> list[str]: ...

    def column(self, name: str) -> object: ...

    @property
    def events(self) -> dict: ...

    @property
    def summary_json(self) -> str: ...

    @property
    def verdict(self) -> str: ...

    @property
    def scenario(self) -> str: ...

    @property
    def vehicle(self) -> str: ...

    @property
    def seed(self) -> int | None: ...

    @property
    def plan(self) -> Plan: ...

    @property
    def knows_plan(self) -> bool: ...

    @property
    def notes(self) -> list[str]: ...

    @property
    def log(self) -> bytes: ...

    def write(self, folder: str) -> None: ...

    def __reduce_ex__(self, arg: int, /) -> object: ...

def phase_names() -> list[str]: ...

def fly(scenario: Scenario) -> Flight: ...

def fly_many(scenarios: list, columns: Sequence[str] | None, threads: int) -> list: ...

class Log:
    @staticmethod
    def read(path: str) -> Log: ...

    @property
    def name(self) -> str: ...

    @property
    def bytes(self) -> int: ...

    @property
    def foreign_bytes(self) -> int: ...

    @property
    def intact(self) -> bool: ...

    def __len__(self) -> int: ...

    def flight(self, index: int) -> LoggedFlight: ...

    def __reduce_ex__(self, arg: int, /) -> object: ...

class LoggedFlight:
    @property
    def number(self) -> int: ...

    @property
    def vehicle(self) -> str: ...

    @property
    def sensors(self) -> str: ...

    @property
    def firmware_version(self) -> str: ...

    @property
    def git_hash(self) -> str: ...

    @property
    def plan(self) -> Plan | None: ...

    @property
    def ticks(self) -> int: ...

    @property
    def from_s(self) -> float: ...

    @property
    def to_s(self) -> float: ...

    @property
    def intact(self) -> bool: ...

    @property
    def integrity(self) -> str: ...

    @property
    def events(self) -> list: ...

    def inputs(self) -> list[Inputs]: ...

    def commands_rad(self) -> Annotated[NDArray[numpy.float32], dict(shape=(None,), writable=False)]: ...

    def autopilot(self, log: str) -> tuple[Autopilot, int]: ...

    def replay(self, log: str, changes: Sequence[str]) -> tuple[str, Flight]: ...

    def __reduce_ex__(self, arg: int, /) -> object: ...

def read_flight(path: str) -> Flight: ...

class Inputs:
    """
    Inputs of one step of the control law.

    time_us: time of this step, on any clock that starts before the flight; a step is due every 1000 us.
    rate_rad_s: angular rate (x, y, z) in the body frame, x to the nose; None: no reading.
    specific_force_m_s2: (x, y, z) likewise; x reads +9.80665 on the pad.
    encoders_rad: angle of each canard about its shaft; None: unknown.
    arm_switch_closed, arm_command: together they arm; the command lasts one step.
    start_command: starts control with run.start = "tunnel", one step long.
    abort: the abort input asks to end control, by the plan's run.abort_input.
    second_...: of a second gyro or accelerometer, if the plan requires one.
    sample_time_us: time of the measurement, if it is not time_us; a repeated sample keeps its time.
    ..._saturated: the reading is at the end of its range.
    """

    def __init__(self, time_us: int, rate_rad_s: Sequence[float] | None = None, specific_force_m_s2: Sequence[float] | None = None, encoders_rad: Sequence[float | None] = [None, None, None, None], *, arm_switch_closed: bool = False, arm_command: bool = False, start_command: bool = False, second_rate_rad_s: Sequence[float] | None = None, second_specific_force_m_s2: Sequence[float] | None = None, sample_time_us: int | None = None, rate_saturated: bool = False, specific_force_saturated: bool = False, abort: bool = False) -> None: ...

    @property
    def time_us(self) -> int: ...

class Tick:
    """Result of one step of the control law."""

    @property
    def time_us(self) -> int: ...

    @property
    def phase(self) -> str:
        """safe, armed, launched, dormant, controlling or finished"""

    @property
    def reason(self) -> str:
        """Reason for the phase"""

    @property
    def command_rad(self) -> float:
        """Roll command as a canard angle, within the plan's limit"""

    @property
    def saturated(self) -> bool:
        """The command was cut to its limit"""

    @property
    def canards_rad(self) -> tuple:
        """Shaft angle commanded to each canard, positive as its encoder counts"""

    @property
    def pulses_us(self) -> tuple:
        """Pulse for each servo"""

    @property
    def driven(self) -> tuple:
        """False: this servo's output stays off"""

    @property
    def roll_angle_rad(self) -> float:
        """
        Roll angle since launch detection, in the tunnel since control start; not wrapped
        """

    @property
    def roll_rate_rad_s(self) -> float: ...

    @property
    def reference_rad(self) -> float: ...

    @property
    def height_m(self) -> float:
        """Height above the place of lift-off"""

    @property
    def speed_m_s(self) -> float:
        """Speed along the guide"""

    @property
    def signals(self) -> dict:
        """Every signal by its name with its unit; an enumeration as a word"""

class Autopilot:
    """
    The control law that flies in the rocket, for your own simulator.

    Call step() every millisecond from the pad on (3 s at rest give the gyro's bias), arm it, and move the canards to canards_rad of the result.
    """

    def __init__(self, plan: Plan) -> None: ...

    def step(self, inputs: Inputs) -> Tick:
        """One step, nominally every millisecond."""

    @property
    def phase(self) -> str:
        """safe, armed, launched, dormant, controlling or finished"""

    def __reduce_ex__(self, arg: int, /) -> object: ...

def verbs() -> list: ...

def run_verb(name: str, words: Sequence[str]) -> tuple[str, list[str]]: ...

def merge_shards(shards: Sequence[str], out: str) -> int: ...
