# SPDX-License-Identifier: MIT
import json

import pytest

import fantail


def test_every_value_is_that_of_the_program(program):
    for name in ("tasha3_launch1", "tasha3_launch2", "tunnel_steps"):
        plan = fantail.plan(name)
        shown = json.loads(program.run("plan", "show", name, "--json").stdout)
        flat = {f"{section}.{key}": tuple(value) if isinstance(value, list) else value
                for section, values in shown.items() if section not in ("answer", "sentence", "made")
                for key, value in values.items()}
        assert list(plan) == list(flat)
        for field in plan.fields.values():
            if field.kind == "number":
                assert plan[field.name] == pytest.approx(flat[field.name], rel=1e-6)
            else:
                assert plan[field.name] == flat[field.name]
        assert str(plan) == program.run("plan", "show", name).stdout


def test_without_a_name_it_has_every_default():
    plan = fantail.plan()
    for field in plan.fields.values():
        value = plan[field.name]
        for each in value if isinstance(value, tuple) else (value,):
            assert each == (pytest.approx(field.default, rel=1e-6) if field.kind == "number" else field.default), field.name


def test_a_value_is_what_a_person_wrote_and_not_what_single_precision_makes_of_it():
    assert fantail.plan("tasha3_launch2")["run.tilt_limit_deg"] == 60.0
    assert fantail.plan(set={"controller.proportional_gain": 0.1})["controller.proportional_gain"] == 0.1


def test_a_value_is_found_by_section_and_key_too():
    plan = fantail.plan("tasha3_launch2", set={"controller.canard_limit_deg": 7.5})
    assert plan.controller.canard_limit_deg == plan["controller.canard_limit_deg"] == 7.5
    with pytest.raises(AttributeError, match="no section controler"):
        plan.controler
    assert plan == fantail.plan("tasha3_launch2").changed({"controller.canard_limit_deg": 7.5})
    assert plan != fantail.plan("tasha3_launch2")


def test_it_cannot_be_assigned_to_and_still_keeps_what_it_found():
    plan = fantail.plan("tasha3_launch2")
    for change in (lambda: setattr(plan, "x", 3), lambda: setattr(plan, "controller", None), lambda: delattr(plan, "_core"),
                   lambda: setattr(plan.controller, "canard_limit_deg", 9)):
        with pytest.raises(AttributeError):
            change()
    assert plan.fields is plan.fields and plan._values is plan._values
    assert not hasattr(plan, "x") and plan == fantail.plan("tasha3_launch2")


def test_a_field_says_kind_unit_range_and_meaning():
    limit = fantail.plan().fields["controller.canard_limit_deg"]
    assert (limit.kind, limit.unit) == ("number", "deg") and 0 <= limit.minimum < 6 < limit.maximum <= 20
    kind = fantail.plan().fields["reference.kind"]
    assert kind.choices == ("hold", "steps", "square_wave") and kind.minimum is None
    assert all(field.meaning for field in fantail.plan().fields.values())


def test_every_number_may_be_its_least_and_its_most_and_no_more():
    for field in fantail.plan().fields.values():
        if field.kind == "number" and field.slots == 1:
            beyond = field.maximum + max(1.0, abs(field.maximum)) * 0.01
            with pytest.raises(ValueError, match=field.key):
                fantail.plan(set={field.name: beyond})


def test_what_the_program_refuses_is_refused_in_its_words(program, tmp_path):
    bad = tmp_path / "bad.toml"
    bad.write_text("[controller]\ncanard_limit_deg = 60\n")
    with pytest.raises(ValueError) as refused:
        fantail.plan(bad)
    assert str(refused.value) == program.refusal("plan", "check", bad)
    with pytest.raises(ValueError) as refused:
        fantail.plan("tasha3_launch9")
    assert str(refused.value) == program.refusal("plan", "show", "tasha3_launch9")


def test_its_block_is_what_a_board_is_loaded_with(program, tmp_path):
    program.run("plan", "compile", "tasha3_launch2", "--out", tmp_path / "p.ftpl")
    assert fantail.plan("tasha3_launch2").block == (tmp_path / "p.ftpl").read_bytes()
