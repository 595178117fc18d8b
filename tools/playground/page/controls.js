// SPDX-License-Identifier: MIT
// The left column. It shows what the settings are, and tells of each change, or of what is wrong with it; what it does not know
// stays in the link.
"use strict";

const fantailControls = (changed, refused) => {
  const $ = (id) => document.getElementById(id);
  const usualFault = {canard: "1", from_s: "2", until_s: "4", offset_deg_s: "100"};
  const offset = "disturbance.angles_deg";
  let rows = [], faults = [], settings = new Map();

  const element = (kind, properties, ...children) => {
    const made = Object.assign(document.createElement(kind), properties);
    made.append(...children);
    return made;
  };
  // What is refused stays in its field, to be mended.
  function onChange(field, take) {
    field.addEventListener("change", () => {
      const objection = fantailSettings.objection(field.value);
      if (objection) refused(objection); else take(field.value.trim());
    });
  }
  const bare = (value) => value.replace(/^\[(.*)\]$/, "$1");

  // A fin offset of a scenario may change in flight; one that is set here does not.
  function set(key, value) {
    const list = key === offset;
    if (value === null) {
      settings.delete(key);
      if (list) settings.delete("disturbance.times_s");
    } else {
      if (list) settings.set("disturbance.times_s", "[0]");
      settings.set(key, list ? `[${value}]` : value);
    }
  }

  function addRow(control) {
    const id = control.key.replace(".", "-");
    const unit = control.unit ? ` ${control.unit}` : "";
    const label = element("label", {className: "row", htmlFor: id, title: control.meaning}, control.label, element("small", {textContent: unit}));
    const slider = element("input", {type: "range", min: control.low, max: control.high, step: control.step, ariaLabel: control.label});
    const field = element("input", {type: "text", id, inputMode: "decimal", autocomplete: "off"});
    const box = element("div", {title: control.meaning}, label, element("div", {className: "pair"}, slider, field));
    const usual = control.value === null ? "" : String(control.value);
    const turned = (value) => {
      const text = value.trim().replace("\u2212", "-");
      set(control.key, text === "" || text === usual ? null : text);
      changed();
    };
    slider.addEventListener("input", () => { field.value = slider.value; turned(slider.value); });
    onChange(field, (value) => { turned(value); show(); });
    const show = () => {
      const own = settings.get(control.key);
      field.value = own === undefined ? usual : bare(own);
      field.placeholder = usual === "" ? "as in the scenario" : usual;
      slider.value = field.value === "" || !Number.isFinite(Number(field.value)) ? 0 : field.value;
      mark();
    };
    const mark = () => box.classList.toggle("changed", settings.has(control.key));
    rows.push({key: control.key, show, mark});
    return box;
  }

  // {controls, faults, seed} of a scenario, as playground::controls() writes them.
  function build(of) {
    rows = [];
    faults = of.faults;
    $("controls").replaceChildren(...of.controls.map(addRow));
    $("fault").replaceChildren(element("option", {value: "", textContent: "none added"}),
      ...faults.map(({kind, meaning}) => element("option", {value: kind, textContent: kind.replaceAll("_", " "), title: meaning})));
    $("seed").placeholder = String(of.seed);
  }

  const faultKind = () => (settings.get("faults.kind") ?? "").replace(/^"(.*)"$/, "$1");

  function showFault() {
    const fault = faults.find(({kind}) => kind === faultKind());
    $("fault").value = fault ? fault.kind : "";
    $("fault-fields").replaceChildren(...(fault?.fields ?? []).flatMap(({key, unit}) => {
      const field = element("input", {type: "text", id: `fault-${key}`, value: settings.get(`faults.${key}`) ?? "", autocomplete: "off"});
      onChange(field, (value) => { settings.set(`faults.${key}`, value); changed(); });
      return [element("label", {htmlFor: field.id, textContent: key.replace(/_(s|deg|deg_s)$/, "").replaceAll("_", " ") + (unit ? `, ${unit}` : "")}), field];
    }));
    $("fault-fields").title = fault?.meaning ?? "";
  }

  $("fault").addEventListener("change", () => {
    for (const key of [...settings.keys()]) if (key.startsWith("faults.")) settings.delete(key);
    const fault = faults.find(({kind}) => kind === $("fault").value);
    if (fault) settings.set("faults.kind", `"${fault.kind}"`);
    for (const {key} of fault?.fields ?? []) settings.set(`faults.${key}`, usualFault[key] ?? "1");
    showFault();
    changed();
  });
  onChange($("seed"), (value) => {
    if (value === "") settings.delete("seed"); else settings.set("seed", value);
    changed();
  });

  function show(now) {
    settings = now;
    for (const row of rows) row.show();
    showFault();
    $("seed").value = settings.get("seed") ?? "";
    showOthers();
  }

  // What only the link says.
  function showOthers() {
    const known = (key) => key === "seed" || key === "disturbance.times_s" || key.startsWith("faults.") || rows.some((row) => row.key === key);
    const others = [...settings].filter(([key]) => !known(key)).map(([key, value]) => `${key}=${value}`);
    $("others").hidden = others.length === 0;
    $("others").textContent = `Also set by the link: ${others.join(", ")}.`;
    for (const row of rows) row.mark();
  }

  return {build, show, showOthers};
};
