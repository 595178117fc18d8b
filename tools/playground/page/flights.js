// SPDX-License-Identifier: MIT
// The worker, seen from the page: of many wishes only the newest is flown, one at a time. One that takes long is given up for a
// newer one, with its worker; the compiled module is handed to the next.
"use strict";

const fantailFlights = (take) => {
  const patience = 400;  // milliseconds that a newer wish waits for an older flight
  const source = new Blob([document.getElementById("worker-source").textContent], {type: "text/javascript"});
  let compiled = null, worker = null, busySince = null, waiting = null, asked = null, running = 0, timer = null;

  const bytes = () => Uint8Array.from(atob(document.getElementById("module-base64").textContent.trim()), (char) => char.charCodeAt(0));

  function start() {
    const url = URL.createObjectURL(source);
    worker = new Worker(url);
    URL.revokeObjectURL(url);
    worker.onmessage = ({data}) => {
      if (data.flown === undefined) return take(data);
      if (data.id !== running) return undefined;  // of a wish that is no longer one
      busySince = null;
      clearTimeout(timer);
      take({flown: data.flown, asked});
      return next();
    };
    worker.onerror = (event) => take({trouble: event.message || "the worker of this page did not start"});
    worker.postMessage({compiled});
  }

  function next() {
    if (waiting === null) return;
    asked = waiting;
    waiting = null;
    busySince = performance.now();
    running += 1;
    worker.postMessage({id: running, words: fantailSettings.toWords(asked)});
  }

  function giveUp() {
    if (busySince === null || waiting === null) return;
    worker.terminate();
    busySince = null;
    start();
    next();
  }

  // {scenario, settings}, which whoever asks may change afterwards.
  function wish({scenario, settings}) {
    waiting = {scenario, settings: new Map(settings)};
    if (busySince === null) return next();
    clearTimeout(timer);
    timer = setTimeout(giveUp, Math.max(0, patience - (performance.now() - busySince)));
    return undefined;
  }

  return {
    start: async () => {
      compiled = await WebAssembly.compile(bytes());
      start();
    },
    wish,
    controls: (scenario) => worker.postMessage({controls: scenario}),
    isBusy: () => busySince !== null,
  };
};
