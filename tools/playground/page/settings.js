// SPDX-License-Identifier: MIT
// What a link carries, and what the module is told: the name of a scenario, and settings as in fantail fly --set. Whether a key
// exists and a value is allowed is for the loaders to say; here is refused only what is no link of this page.
"use strict";

const fantailSettings = (() => {
  const usual = "tasha3_launch2";
  const longest = 4000;

  // "#tasha3_launch2&controller.proportional_gain=0.4" -> {scenario, settings: Map}, or {refusal}.
  function ofLink(hash) {
    if (hash.length > longest) return {refusal: `The link is longer than ${longest} characters, the longest that this page makes.`};
    const [scenario, ...parts] = hash.replace(/^#/, "").split("&");
    const settings = new Map();
    for (const part of parts) {
      let text;
      try {
        text = decodeURIComponent(part);
      } catch {
        return {refusal: `"${part}" in the link is not text: a percent sign must be followed by the code of a character.`};
      }
      const equals = text.indexOf("=");
      const key = text.slice(0, Math.max(equals, 0)).trim();
      if (key === "") return {refusal: `"${text}" in the link is not a setting; allowed: section.key=value, as in controller.canard_limit_deg=6`};
      if (/[\u0000-\u001f\u007f]/.test(text)) return {refusal: `The setting ${key} in the link contains a line break or another control character.`};
      if (settings.has(key)) return {refusal: `The link sets ${key} twice.`};
      settings.set(key, text.slice(equals + 1).trim());
    }
    try {
      const name = decodeURIComponent(scenario);
      if (!/[\u0000-\u001f\u007f]/.test(name)) return {scenario: name || usual, settings};
    } catch {
      // said below
    }
    return {refusal: `"${scenario}" in the link is not the name of a scenario.`};
  }

  // Of what somebody types where one number belongs; "" when nothing speaks against it. To the loaders "0,4" is a list of two.
  const objection = (text) => /^\s*[-+]?\d*,\d+\s*$/.test(text)
    ? `"${text.trim()}" is not a number: write it with a decimal point, as in ${text.trim().replace(",", ".")}.` : "";

  const code = (text) => encodeURIComponent(text).replace(/%5B/g, "[").replace(/%5D/g, "]").replace(/%2C/g, ",");

  function toLink({scenario, settings}) {
    return "#" + [encodeURIComponent(scenario), ...[...settings].map(([key, value]) => `${encodeURIComponent(key)}=${code(value)}`)].join("&");
  }

  // The lines that playground::fly() reads.
  const toWords = ({scenario, settings}) => [scenario, ...[...settings].map(([key, value]) => `${key}=${value}`)].join("\n");

  const word = (text) => /^[A-Za-z0-9_./=:,+-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`;

  // What flies the same on a PC: {command}, and {fault}, the section that its scenario needs, where there is one.
  function native({scenario, settings}) {
    const faults = [...settings].filter(([key]) => key.startsWith("faults."));
    const others = [...settings].filter(([key]) => !key.startsWith("faults."));
    const options = others.map(([key, value]) => key === "seed" ? ` --seed ${word(value)}` : ` --set ${word(`${key}=${value}`)}`);
    return {
      command: `./dev fly ${word(faults.length > 0 ? "my_scenario.toml" : scenario)}${options.join("")}`,
      fault: faults.length === 0 ? null
        : `[[faults]]\n${faults.map(([key, value]) => `${key.slice(7)} = ${value}`).join("\n")}\n`,
    };
  }

  return {ofLink, objection, toLink, toWords, native};
})();
if (typeof module !== "undefined") module.exports = fantailSettings;
