// SPDX-License-Identifier: MIT
// What the page reads from a link and writes into one.
"use strict";
const assert = require("node:assert");
const test = require("node:test");
const {objection, ofLink, toLink, toWords, native} = require("../../tools/playground/page/settings.js");

const wish = (scenario, ...pairs) => ({scenario, settings: new Map(pairs)});

test("a link comes back as it was written", () => {
  for (const settings of [wish("tasha3_launch2"), wish("tunnel_steps", ["tunnel.fan_rpm", "1400"]),
                          wish("tasha3_launch2", ["disturbance.angles_deg", "[-4.9]"], ["faults.kind", '"canard_stuck"'], ["body.name", "a&b=c #%"])]) {
    assert.deepStrictEqual(ofLink(toLink(settings)), settings);
  }
});

test("without a link the second launch is flown", () => {
  assert.deepStrictEqual(ofLink(""), wish("tasha3_launch2"));
  assert.deepStrictEqual(ofLink("#"), wish("tasha3_launch2"));
});

test("what is no link of this page is refused by what is wrong with it", () => {
  for (const [hash, sentence] of [["#x&%E0%A4%A", /is not text/], ["#%E0%A4%A", /not the name of a scenario/], ["#x&a", /is not a setting/],
                                  ["#x&=1", /is not a setting/], ["#x&a.b=1&a.b=2", /sets a\.b twice/], ["#x&a.b=1%0Ac.d=2", /control character/],
                                  ["#x%0Aseed=1", /not the name of a scenario/], [`#${"x".repeat(5000)}`, /longer than 4000/]]) {
    assert.match(ofLink(hash).refusal ?? "taken", sentence, hash);
  }
});

test("a decimal comma is refused in words, and a number is not", () => {
  assert.match(objection(" 0,4"), /"0,4" is not a number: write it with a decimal point, as in 0\.4\./);
  assert.match(objection("-,5"), /as in -\.5/);
  for (const text of ["", "0.4", "-5", "1e-3", "[1, 2]", "a"]) assert.strictEqual(objection(text), "", text);
});

test("the words of a setting end at its line", () => {
  assert.strictEqual(toWords(wish("a", ["b.c", "1"], ["seed", "2"])), "a\nb.c=1\nseed=2");
});

test("the native command says the same, in words that a shell leaves alone", () => {
  assert.strictEqual(native(wish("tasha3_launch2", ["controller.proportional_gain", "0.4"], ["seed", "7"])).command,
                     "./dev fly tasha3_launch2 --set controller.proportional_gain=0.4 --seed 7");
  assert.strictEqual(native(wish("tasha3_launch2", ["disturbance.angles_deg", "[1]"])).command,
                     "./dev fly tasha3_launch2 --set 'disturbance.angles_deg=[1]'");
  assert.strictEqual(native(wish("tasha3_launch2", ["body.name", "it's $HOME"])).command,
                     "./dev fly tasha3_launch2 --set 'body.name=it'\\''s $HOME'");
});

test("a fault is told as the section that a scenario needs", () => {
  const {command, fault} = native(wish("tasha3_launch2", ["faults.kind", '"canard_dead"'], ["faults.canard", "1"]));
  assert.strictEqual(command, "./dev fly my_scenario.toml");
  assert.strictEqual(fault, '[[faults]]\nkind = "canard_dead"\ncanard = 1\n');
});
