// SPDX-License-Identifier: MIT
// Flies beside the page, so that the page never waits. The first message is the compiled module, each further one a wish.
"use strict";

let host = null;
onmessage = ({data}) => {
  if (data.compiled) {
    host = fantailModule(data.compiled);
    postMessage({about: host.about()});
    return;
  }
  if (data.controls !== undefined) {
    postMessage({of: data.controls, controls: host.controls(data.controls)});
    return;
  }
  const flown = host.fly(data.words);
  postMessage({id: data.id, flown}, flown.columns ? [flown.columns.buffer] : []);
};
