// SPDX-License-Identifier: MIT
// Usage: node module_test.js MODULE FANTAIL WORK
// The module of the page against the native program: the same record and the same summary.json, of every shipped scenario and
// of changed ones; what it refuses, and how it goes on afterwards; how much memory many flights take.
"use strict";
const assert = require("node:assert");
const {execFileSync} = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");

const [wasm, fantail, work] = process.argv.slice(2);
const project = path.join(__dirname, "../..");
const page = path.join(project, "tools/playground/page");
const fantailModule = new Function(fs.readFileSync(path.join(page, "module_host.js"), "utf8") + "; return fantailModule;")();
const settings = require(path.join(page, "settings.js"));
const compiled = new WebAssembly.Module(fs.readFileSync(wasm));
const host = fantailModule(compiled);
const {scenarios, columns} = host.about();

function test(name, what) {
  what();
  console.log(`ok: ${name}`);
}

let folders = 0;
function native(words, scenarioFile) {
  const [scenario, ...changes] = words;
  const options = changes.flatMap((text) => text.startsWith("seed=") ? ["--seed", text.slice(5)] : ["--set", text]);
  const text = execFileSync(fantail, ["fly", scenarioFile ?? scenario, ...options, "--json", "--out", path.join(work, String(folders++))],
                            {encoding: "utf8", stdio: ["ignore", "pipe", "pipe"], maxBuffer: 1 << 26});
  fs.rmSync(path.join(work, String(folders - 1)), {recursive: true});
  return text;
}

function flown(words) {
  const result = host.fly(words.join("\n"));
  assert.strictEqual(result.refusal, undefined, words.join(" "));
  return result;
}

// No command line made the page's: "made" is the last member, and apart from it both are the same bytes.
function unmade(summary) {
  return summary.slice(0, summary.indexOf('\n  "made": {'));
}

// Everything that the flight came to, and with log_sha256 every byte of its record.
function assertSame(words) {
  const result = flown(words);
  assert.strictEqual(unmade(result.summary), unmade(native(words)), words.join(" "));
  assert.match(JSON.parse(result.summary).log_sha256 ?? "none", /^([0-9a-f]{64}|none)$/);
  return result;
}

test("every shipped scenario gives the native program's summary and digest", () => {
  const shipped = fs.readdirSync(path.join(project, "sim/scenarios")).map((file) => path.parse(file).name).sort();
  assert.deepStrictEqual(scenarios, shipped);
  let recorded = 0;
  for (const scenario of scenarios) {
    const {summary, milliseconds, rows, memory} = assertSame([scenario]);
    recorded += JSON.parse(summary).log_sha256 === null ? 0 : 1;
    console.log(`    ${scenario}: ${milliseconds.toFixed(0)} ms, ${rows} points, ${memory >> 20} MB`);
  }
  assert.ok(recorded > 0);
});

test("so do changed settings of plan, vehicle, world and seed", () => {
  for (const changes of [["controller.proportional_gain=0.3", "controller.derivative_gain_s=0.02"], ["controller.canard_limit_deg=4"],
                         ["disturbance.times_s=[0]", "disturbance.angles_deg=[7.5]"], ["motor.thrust_factor=0.8", "servo.lag_s=0.03"],
                         ["excitation.amplitude_deg=0"], ["reference.kind=hold"], ["launch_guide.tilt_deg=5"], ["seed=12345"],
                         ["flight.motion=six_dof", "wind.speed_m_s=6", "wind.from_deg=250", "wind.turbulence=0.15"]]) {
    assertSame(["tasha3_launch2", ...changes]);
  }
});

test("a fault of the page is the same as in a scenario's file", () => {
  const fault = ['kind = "canard_stuck"', "canard = 2", "from_s = 1.5"];
  const file = path.join(work, "tasha3_launch2.toml");
  fs.writeFileSync(file, fs.readFileSync(path.join(project, "sim/scenarios/tasha3_launch2.toml"), "utf8") + `\n[[faults]]\n${fault.join("\n")}\n`);
  const result = flown(["tasha3_launch2", ...fault.map((line) => `faults.${line.replace(" = ", "=")}`)]);
  const ofFile = JSON.parse(native(["tasha3_launch2"], file));
  ofFile.notes.shift();  // asks whether what was copied is true of this run
  assert.deepStrictEqual({...JSON.parse(result.summary), made: null}, {...ofFile, made: null});
  assert.notStrictEqual(JSON.parse(result.summary).log_sha256, JSON.parse(flown(["tasha3_launch2"]).summary).log_sha256);
});

test("columns are those that are named, and end where the flight ends", () => {
  const {columns: values, rows, summary} = flown(["tasha3_launch2"]);
  assert.strictEqual(values.length, columns.length * rows);
  const column = (name) => values.subarray(columns.indexOf(name) * rows, (columns.indexOf(name) + 1) * rows);
  const time = column("time_s");
  assert.ok(time.every((value, i) => i === 0 || value > time[i - 1]));
  const {events, apogee_m: apogee} = JSON.parse(summary);
  assert.ok(time[rows - 1] > events.apogee_s);
  assert.ok(Math.abs(Math.max(...column("height_m")) - apogee) < 0.5);
});

test("a scenario offers what can be turned in it", () => {
  const of = (scenario) => JSON.parse(host.controls(scenario).answer);
  const launch = of("tasha3_launch2");
  assert.strictEqual(launch.surroundings, "flight");
  const gain = launch.controls.find(({key}) => key === "controller.proportional_gain");
  assert.strictEqual(gain.value, 0.5);
  assert.ok(gain.meaning.length > 0);
  assert.strictEqual(launch.controls.find(({key}) => key === "disturbance.angles_deg").value, -4.9);
  assert.strictEqual(of("tasha3_launch1").controls.find(({key}) => key === "disturbance.angles_deg").value, null); // it changes in flight
  assert.ok(of("tunnel_steps").controls.some(({key}) => key === "tunnel.fan_rpm"));
  assert.ok(!of("tunnel_steps").controls.some(({key}) => key === "motor.thrust_factor"));
  for (const {kind, fields} of launch.faults) { // each can be flown as the page would ask for it
    const usual = {canard: "1", from_s: "2", until_s: "4", offset_deg_s: "100"};
    flown(["tasha3_launch2", `faults.kind="${kind}"`, ...fields.map(({key}) => `faults.${key}=${usual[key]}`)]);
  }
  for (const scenario of scenarios) {
    for (const {key, value, low, high} of of(scenario).controls) {
      assert.ok(value === null || (value >= low && value <= high), `${scenario}: the slider ${key} does not reach ${value}`);
    }
  }
});

const refusals = [
  [["tasha3_launch2", "controller.proportional_gain=nan"], /proportional_gain = nan is out of range; allowed: /],
  [["tasha3_launch2", "controller.proportional_gain=-1"], /proportional_gain = -1 is out of range; allowed: 0 to /],
  [["tasha3_launch2", "controller.canard_limit_deg=1e400"], /canard_limit_deg/],
  [["tasha3_launch2", "controller.canard_limit_deg=six"], /is not a number; allowed: /],
  [["tasha3_launch2", "controller.canard_limit_deg="], /expected section\.key=value/],
  [["tasha3_launch2", "controller.propotional_gain=1"], /unknown key controller\.propotional_gain; did you mean controller\.proportional_gain\?/],
  [["tasha3_launch2", "controler.proportional_gain=1"], /unknown section controler; did you mean controller\?/],
  [["tasha3_launch2", "nonsense"], /expected section\.key=value/],
  [["tasha3_launch2", "seed=-1"], /not a seed; allowed: a whole number/],
  [["tasha3_launch3"], /unknown scenario "tasha3_launch3"; did you mean tasha3_launch1\?.* shipped: /],
  [[""], /unknown scenario ""/],
  [["../../etc/passwd"], /unknown scenario/],
  [["tasha3_launch2", "motor.file=/etc/passwd"], /motor\.file=\/etc\/passwd: unknown motor "\/etc\/passwd"/],
  [["tasha3_launch2", "disturbance.angles_deg=[1,2]"], /has 1 values and angles_deg has 2/],
  [["tasha3_launch2", 'faults.kind="canard_stuck"'], /from_s is missing/],
  [["tasha3_launch2", "faults.kind=canard_stuck", "faults.from_s=1", "faults.canard=1"], /not valid TOML/],
  [["tasha3_launch2", 'faults.kind="canard_stuck"', "faults.from_s=1", "faults.canard=7"], /canard = 7 is out of range; allowed: 1 to 4/],
  [["tasha3_launch2", "timing.time_after_end_s=3600"], /a page can fly this scenario for at most 300 s/],
  [["tasha3_launch2", "timing.log_period_s=0.0015"], /not a whole number of milliseconds/],
  [["tasha3_launch2", `motor.file=${"x".repeat(5000)}`], /longer than 4000 characters/],
];

test("what cannot be flown is refused in words, and the next flight is as before", () => {
  const before = flown(["tasha3_launch2"]).summary;
  for (const [words, sentence] of refusals) {
    const {refusal, broken} = host.fly(words.join("\n"));
    assert.match(refusal ?? "flown", sentence, words.join(" ").slice(0, 200));
    assert.strictEqual(broken, undefined);
  }
  assert.strictEqual(flown(["tasha3_launch2"]).summary, before);
});

test("links of any kind are refused in words, or flown", () => {
  const link = (hash) => {
    const read = settings.ofLink(hash);
    return read.refusal ? read : host.fly(settings.toWords(read));
  };
  for (const hash of ["#tasha3_launch2&controller.proportional_gain=NaN", "#tasha3_launch2&%FF=1", "#<img src=x onerror=alert(1)>",
                      "#tasha3_launch2&constructor.prototype=1", "#tasha3_launch2&__proto__.x=1", "#&&&", "#tasha3_launch2&a.b=1%0Aseed=2"]) {
    const {refusal, broken} = link(hash);
    assert.ok(refusal?.length > 10 && broken === undefined, hash);
  }
  assert.ok(link("#").summary);
  assert.ok(link("#tasha3_launch1&seed=7").summary);
});

test("the memory of the module does not grow from flight to flight", () => {
  let memory = 0;
  for (let i = 0; i < 40; i++) {
    const result = flown(["tasha3_launch2", `controller.proportional_gain=${0.2 + 0.001 * i}`]);
    if (i < 10) memory = Math.max(memory, result.memory);
    assert.ok(result.memory <= memory, `${result.memory} after ${i + 1} flights, ${memory} after ten`);
  }
  console.log(`    ${memory >> 20} MB after 10 flights and after 40`);
});

test("a flight takes", () => {
  const times = Array.from({length: 21}, () => flown(["tasha3_launch2"]).milliseconds).sort((a, b) => a - b);
  console.log(`    tasha3_launch2: ${times[10].toFixed(0)} ms, the middle of 21; ${times[20].toFixed(0)} ms the longest`);
});
