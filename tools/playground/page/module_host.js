// SPDX-License-Identifier: MIT
// Calls the module. A refusal ends an instance of it (module.cpp); the next call gets another, of the same compiled code.
"use strict";

function fantailModule(compiled) {
  const largest = 256 * 1024 * 1024;  // what a long run has left in an instance is given back with the instance
  const imports = {};
  // The C library could write to a console and read a clock. Here it has neither, and is told so: ENOSYS of WASI.
  for (const {module, name} of WebAssembly.Module.imports(compiled)) (imports[module] ??= {})[name] = () => 52;
  let it = null, names = null;

  function instance() {
    if (it === null) {
      it = new WebAssembly.Instance(compiled, imports).exports;
      it._initialize();
    }
    return it;
  }

  const text = (from, at, size) => new TextDecoder().decode(new Uint8Array(from.memory.buffer, at, size));

  // {answer}, or {refusal}; `broken`: nobody has said why, which is an error of the module.
  function call(what, words = "") {
    const now = instance();
    try {
      const bytes = new TextEncoder().encode(words);
      const room = now.room(bytes.length);  // memory may move, so it is looked up afterwards
      new Uint8Array(now.memory.buffer, room, bytes.length).set(bytes);
      now[what]();
      return {answer: text(now, now.answer(), now.answer_size())};
    } catch (error) {
      it = null;
      const size = now.refusal_size();
      return size > 0 ? {refusal: text(now, now.refusal(), size)} : {refusal: `the module stopped: ${error.message}`, broken: true};
    }
  }

  function about() {
    if (names === null) {
      const [scenarios, columns] = call("about").answer.split("\n\n");
      names = {scenarios: scenarios.split("\n"), columns: columns.split(" ")};
    }
    return names;
  }

  // With `columns`, a Float32Array of its own, one column of `rows` behind the other, and how long it took.
  function fly(words) {
    const begun = performance.now();
    const signals = about().columns.length;
    const done = call("fly", words);
    if (done.refusal !== undefined) return done;
    const rows = it.rows();
    const columns = new Float32Array(it.memory.buffer, it.columns(), signals * rows).slice();
    const bytes = it.memory.buffer.byteLength;
    if (bytes > largest) it = null;
    return {summary: done.answer, columns, rows, milliseconds: performance.now() - begun, memory: bytes};
  }

  return {about, fly, controls: (scenario) => call("controls", scenario)};
}
