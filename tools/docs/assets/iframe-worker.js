// SPDX-License-Identifier: MIT
// A browser starts no worker from a file on the disk, and the search of the site is one. Here it is a hidden frame instead, with as
// much of Worker as the search uses.
if (location.protocol === 'file:') {
  window.Worker = class extends EventTarget {
    constructor(url) {
      super();
      const frame = Object.assign(document.createElement('iframe'), {hidden: true, ariaHidden: 'true', title: 'search'});
      document.body.appendChild(frame);
      this.frame = frame;
      const inside = frame.contentDocument;
      inside.open();
      // What the worker sends goes to the page that made it.
      inside.write('<!doctype html><title>search</title><script>window.postMessage = (data) => window.answer(data);</' + 'script>');
      frame.contentWindow.answer = (data) => this.answer(data);
      frame.contentWindow.importScripts = () => undefined; // for other languages than English
      // The search index is a variable of the page.
      frame.contentWindow.__index = window.__index;
      inside.write(`<script src="${url}"></` + 'script>');
      inside.close();
      this.ready = new Promise((done) => frame.addEventListener('load', done, {once: true}));
    }
    answer(data) {
      const event = new MessageEvent('message', {data});
      this.dispatchEvent(event);
      if (this.onmessage) this.onmessage(event);
    }
    postMessage(data) {
      this.ready.then(() => this.frame.contentWindow.dispatchEvent(new MessageEvent('message', {data})));
    }
    terminate() {
      this.frame.remove();
    }
  };
}
