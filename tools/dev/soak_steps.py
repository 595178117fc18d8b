# SPDX-License-Identifier: MIT
# The long tests that ./dev soak runs.
#
# name, title, what is counted, how many (a run of --short: a thousandth), command, environment, what to read from its output.
# {n} is how many, {seed} the seed, {host} and {fuzz} the builds, and of the campaigns and proofs {every}, {false},
# {missed} and {proofs}: with --short fewer flights, the bounds that so few events can show, and the quick proofs.
DETECTION = ("{host}/fantail campaign detection --plan tasha3_launch2 --both-well --seed {seed} --threads 1 --out build/soak/out_")
DETECTION_READS = [("events", r": (\d+) events, false"), ("false actuations", r"false actuations (\d+)"),
                   ("launches", r"; (\d+) launches"), ("missed", r"launches, missed (\d+)")]
STEPS = [
    ("frames", "Random and mutated frames to the avionics", "frames", 100_000_000,
     "{host}/test/avionics/test_avionics --gtest_brief=1 --gtest_filter=BusFrames.*", {"FANTAIL_FRAMES": "{n}"}, []),
    ("flips", "Bits of flight law, plan and watch flipped in flight", "flips", 100_000,
     "{host}/test/avionics/test_memory_campaign --gtest_brief=1", {"FANTAIL_FLIPS": "{n}"}, []),
    ("cuts", "Power cut at every byte of a flight, each of its bits flipped", "flights of 11 s", 1,
     "{host}/test/avionics/test_avionics --gtest_brief=1 --gtest_filter=PowerCut.*:BitFlip.*", {"FANTAIL_ALL_CUTS": "1"}, []),
    ("verdicts", "Random flights whose verdict is held against the truth", "flights", 50_000,
     "{host}/test/sil/test_sil --gtest_brief=1 --gtest_filter=VerdictOracle.*", {"FANTAIL_FLIGHTS": "{n}"}, []),
    ("goes", "Predictions that said go, flown", "goes", 500,
     "{host}/test/sil/test_sil --gtest_brief=1 --gtest_filter=GoOracle.*", {"FANTAIL_GOES": "{n}"}, []),
    ("captures", "Captures that closed forms promised, flown", "captures", 100_000,
     "{host}/test/dormancy/test_dormancy --gtest_brief=1 --gtest_filter=CaptureOracle.*", {"FANTAIL_CAPTURES": "{n}"}, []),
    ("law", "Flight law with random plans and samples: flights of 12 000 ticks", "flights", 83_334,
     "{host}/test/core/test_core --gtest_brief=1 --gtest_filter=Autopilot.WhateverComesInTheCommandsKeepTheirLimits",
     {"RC_PARAMS": "seed={seed} max_success={n}"}, []),
    *[(name, title, "launches", 1_000_000, f"{{host}}/test/dormancy/test_gates --gtest_brief=1 --gtest_filter=DormancyLaunches.{test}",
       {"FANTAIL_LAUNCHES": "{n}"}, [("ticks off trim before the gate", r"before the gate (\d+)"), *more])
      for name, title, test, more in [
          ("gates", "Launches of drawn rockets, each gate held against the truth", "OfASoundMotorNoGateOpensBeforeItsTime",
           [("of sound motors", r"sound motors: (.*)")]),
          ("gates_faulted", "The same, one device faulted in each", "WhateverFailsTheCanardsStandAtTrimBeforeTheGate", [])]],
    ("events", "Events that are not launches: 11 kinds, both accelerometers well", "events of each kind", 909_091,
     DETECTION + "events --kind handling --kind drop --kind transport --kind shaking --kind chuff --kind misfire --kind neighbour "
     "--kind gust --kind vibration --kind bias --kind tilt --events {n} --launches 0 --false-at-most {false}", {}, DETECTION_READS[:2]),
    ("launches", "Launches, half of them with vibration of 2 g rms", "launches of each kind", 500_000,
     DETECTION + "launches --kind launch --kind launch_at_2_g --events 0 --launches {n} --at-most {missed}", {}, DETECTION_READS[2:]),
    ("faults", "Every device broken in every phase of a launch", "campaign", 1,
     "{host}/fantail campaign faults tasha3_launch2 --every {every} --threads 1 --out build/soak/out_faults", {},
     [("flights", r"(\d+) flights in \d+ cells\."), ("cells red for a known limit", r"because of a known limit: (\d+) cells?")]),
    ("routes", "From a design to the brief, for five rockets of other sizes", "way of each", 1,
     "/usr/bin/python3 -B test/system/route_test.py {host}/fantail", {}, []),
    *[(name, title, unit, n, "{host}/test/board/" + command, {}, reads) for name, title, unit, n, command, reads in [
        ("board_flips", "Bits flipped in memory and registers under the flashed image", "flips", 10_000,
         "board_flips build/arm/fantail-stm32f405.elf {n} {seed}",
         [("pulses beyond the plan", r"(\d+) whole pulses beyond the plan"), ("without a name", r"(\d+) flips changed pulses and named nothing")]),
        ("board_resets", "Every kind of reset of the flashed image, over a servo frame", "instants of each kind", 64,
         "board_sweep build/arm/fantail-stm32f405.elf {n}", []),
        ("board_devices", "Each device of the flashed image's board broken, at boot and under control", "campaign", 1,
         "board_faults build/arm/fantail-stm32f405.elf test/board/device_faults.txt", []),
        ("board_timing", "Ticks of the flashed image, and its answers to a motion", "flight of each pace", 1,
         "board_timing build/arm/fantail-stm32f405.elf", [])]],
    ("bench_zero", "The real bench finds a horn that is off, and its plan corrects it", "rocket", 1,
     "tools/with_vcan --timeout 800 {host}/test/can/test_can --gtest_filter=CanSystem.ZeroFinds*", {}, []),
    ("board_bench", "The real bench and the flashed image on a bus", "sheet", 1,
     "tools/with_vcan --timeout 800 {host}/test/board/test_board_can --gtest_filter=VirtualBoard.PassesTheSheetOfTheBench", {}, []),
    ("proofs", "Every proof, with its seeded bugs", "run", 1,
     "build/prove-venv/bin/python -B test/proof/prove.py build/prove-venv/esbmc build/soak/proofs {proofs}", {},
     [("properties", r"(\d+ of \d+) properties"), ("seeded bugs refuted", r"(\d+ of \d+) seeded bugs")]),
    *[(f"fuzz_{target}", f"Fuzzing: {about}", "inputs", 1_000_000,
       f"{{fuzz}}/test/fuzz/{target}_fuzz -runs={{n}} -max_len={most} -print_final_stats=1 -artifact_prefix=build/soak/{target}_ "
       f"build/soak/found_{target} build/soak/seeds_{target}", {},
       [("edges covered", r"\bcov: (\d+)"), ("inputs a second", r"average_exec_per_sec: +(\d+)")])
      for target, most, about in [
          ("bus", 4096, "any frames on a bus, to the gateway and the bench"), ("csv", 4096, "any bytes as a CSV log"),
          ("json", 4096, "any bytes as JSON: a flight's summary, a roll model, a campaign"), ("log", 8192, "any bytes as a flight log"),
          ("document", 4096, "any bytes as plan, vehicle, scenario, thrust curve or OpenRocket design"),
          ("frame", 2048, "any bytes as a frame, a plan block or a record"), ("listen", 4096, "any bytes as somebody's log, and as the words that map its columns"),
          ("network", 4096, "any bytes as LCM packets or log, address, or question of a browser"), ("state", 4096, "the flight law from any state, with any samples"),
          ("table", 4096, "any bytes as an exported trajectory")]],
]
