# SPDX-License-Identifier: MIT
"""The way of a student with a rocket of her own, from a design of OpenRocket to the brief, for five rockets of other sizes than the shipped ones.

Usage: route_test.py FANTAIL [ROCKET...]
"""

import json
import pathlib
import subprocess
import sys
import tempfile

# Body diameter in m, body length, payload in kg, total impulse in N s, burn time in s, propellant in kg, motor in kg.
ROCKETS = {
    "i38": (0.038, 1.0, 1.0, 330, 2.0, 0.17, 0.35),
    "j54": (0.054, 1.3, 2.2, 700, 2.4, 0.36, 0.75),
    "k75": (0.075, 1.6, 4.5, 1400, 3.0, 0.72, 1.5),
    "l98": (0.098, 2.1, 11.0, 3000, 3.4, 1.5, 3.0),
    "n150": (0.150, 3.0, 42.0, 11000, 5.0, 5.5, 10.0),
}


def design(diameter_m, length_m, payload_kg, motor_kg):
    """Round, thin walls, three fins and four canards in proportion."""
    radius_m, nose_m, root_m = diameter_m / 2, 4 * diameter_m, 1.8 * diameter_m
    mount_m = 0.35 * length_m

    def part(kind, name, inside, density=1400.0, children=""):
        return (f"<{kind}><name>{name}</name><material type='bulk' density='{density}'>m</material>{inside}"
                f"<subcomponents>{children}</subcomponents></{kind}>")

    def fins(name, count, offset, method, root, span):
        return part("trapezoidfinset", name, f"<instancecount>{count}</instancecount><axialoffset method='{method}'>{offset}</axialoffset>"
                    f"<thickness>{0.03 * diameter_m}</thickness><crosssection>square</crosssection><cant>0</cant><rootchord>{root}</rootchord>"
                    f"<tipchord>{0.5 * root}</tipchord><sweeplength>{0.5 * root}</sweeplength><height>{span}</height>", 1600.0)

    payload = (f"<masscomponent><name>Payload</name><axialoffset method='top'>{0.1 * length_m}</axialoffset>"
               f"<packedlength>{0.2 * length_m}</packedlength><packedradius>{0.8 * radius_m}</packedradius><mass>{payload_kg}</mass></masscomponent>")
    mount = part("innertube", "Mount", f"<axialoffset method='bottom'>0</axialoffset><length>{mount_m}</length><outerradius>{0.8 * radius_m}"
                 "</outerradius><thickness>0.0015</thickness><motormount><overhang>0</overhang><motor configid='a'><designation>M1</designation>"
                 f"<diameter>{1.5 * radius_m}</diameter><length>{mount_m}</length></motor></motormount>")
    canards = fins("Canards", 4, 0.15 * diameter_m, "top", 0.6 * diameter_m, 0.55 * diameter_m)
    tube = part("bodytube", "Body", f"<length>{length_m}</length><thickness>{0.02 * diameter_m}</thickness><radius>{radius_m}</radius>",
                children=canards + payload + fins("Fins", 3, 0, "bottom", root_m, 1.3 * diameter_m) + mount)
    nose = part("nosecone", "Nose", f"<length>{nose_m}</length><thickness>{0.03 * diameter_m}</thickness><shape>ogive</shape>"
                f"<aftradius>{radius_m}</aftradius>")
    return ("<?xml version='1.0' encoding='utf-8'?><openrocket version='1.9' creator='a test'><rocket><name>Own</name><subcomponents>"
            f"<stage><name>Sustainer</name><subcomponents>{nose}{tube}</subcomponents></stage></subcomponents></rocket></openrocket>")


def motor(diameter_m, length_m, impulse_n_s, burn_s, propellant_kg, motor_kg):
    thrust_n = impulse_n_s / (burn_s - 0.1)
    return (f"M1 {1000 * diameter_m:.0f} {1000 * length_m:.0f} P {propellant_kg} {motor_kg} test\n"
            f"0.1 {thrust_n:.1f}\n{burn_s - 0.1:.2f} {thrust_n:.1f}\n{burn_s} 0\n")


class Route:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, *words, codes=(0,)):
        done = subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True, check=False, timeout=600)
        assert done.returncode in codes, f"fantail {' '.join(words)}: exit code {done.returncode}\n{done.stdout[-1500:]}{done.stderr[-1500:]}"
        return done.stdout

    def json(self, *words, codes=(0,)):
        return json.loads(self.run(*words, "--json", codes=codes))

    def page(self, path):
        text = (self.folder / path).read_text()
        assert "</html>" in text and " nan" not in text.lower(), path


def fly_the_route(program, name, numbers, folder):
    diameter_m, length_m, payload_kg, impulse_n_s, burn_s, propellant_kg, motor_kg = numbers
    (folder / "own.ork").write_text(design(diameter_m, length_m, payload_kg, motor_kg))
    (folder / "own.eng").write_text(motor(0.75 * diameter_m, 0.35 * length_m, impulse_n_s, burn_s, propellant_kg, motor_kg))
    route = Route(program, folder)
    said = route.run("new", name, "--from", "own.ork", "--motor", "own.eng")
    assert "One degree of fin cant takes" in said and "Canards\": used as the canards" in said, said
    assert "Not used" not in said and "Left out" not in said, said
    airframe = route.json("airframe", f"{name}/vehicle.toml", "--out", "airframe")
    assert airframe["stability"] in ("stable", "marginal"), airframe["sentence"]
    scenario = f"{name}/scenario.toml"
    flown = route.json("fly", scenario, "--out", "flown")
    assert flown["outcome"] == "held" and abs(flown["rest_error_deg"]) < 1, flown["sentence"]
    route.page("flown/report.html")
    route.run("plan", "check", f"{name}/plan.toml")
    route.run("tune", scenario, "--flights", "1", "--threads", "2", "--out", "tuned", codes=(0, 1))
    route.json("campaign", scenario, "--runs", "6", "--threads", "2", "--out", "campaign", codes=(0, 1))
    route.page("campaign/campaign.html")
    assumed = route.json("predict", scenario, "--threads", "2", "--out", "assumed", codes=(1,))
    assert assumed["answer"] == "undecided" and not assumed["go"], assumed["sentence"]
    route.page("assumed/predict.html")
    route.run("rules", "irec", scenario, codes=(0, 1))
    route.run("brief", scenario, "--out", "brief")
    return flown["outcome"]


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    wanted = sys.argv[2:] or list(ROCKETS)
    for name in wanted:
        with tempfile.TemporaryDirectory() as folder:
            print(f"{name}: {fly_the_route(program, name, ROCKETS[name], pathlib.Path(folder))}", flush=True)


if __name__ == "__main__":
    main()
