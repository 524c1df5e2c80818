"use strict";
const at = (id) => document.getElementById(id);
const RATIOS = ["gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia"];
const CURVES = [...RATIOS, "inertia"]; // in the order of the figures
const STEP = 0.002; // s
const KEPT = 1500; // points of a curve
const NEAR = 12; // times the latest error: what was less sure is not what a curve is scaled by
let past = [];
let believed = true; // can any number be shown?
let simulated = null; // time, angle and rate of the leg that the estimates make

function tell(id, text, level) {
  const shown = at(id);
  if (shown.textContent !== text) shown.textContent = text;
  if (level) for (const each of ["none", "good", "care", "bad"]) shown.classList.toggle(each, each === level);
}

function turn(id, angle) {
  if (angle !== null) at(id).style.transform = `rotate(${(-angle * 180) / Math.PI}deg)`;
}

// phi'' = -(m l g / J) cos(phi) - (c / J) phi - (d / J) phi', by the midpoint rule.
function fall(state, [gravity, stiffness, damping], until) {
  const push = (angle, rate) => -gravity * Math.cos(angle) - stiffness * angle - damping * rate;
  for (let left = until - state.time; left > 1e-9; left -= STEP) {
    const step = Math.min(STEP, left);
    const angle = state.angle + (step / 2) * state.rate;
    const rate = state.rate + (step / 2) * push(state.angle, state.rate);
    state = { time: state.time + step, angle: state.angle + step * rate, rate: state.rate + step * push(angle, rate) };
  }
  return state;
}

function follow(moment, swing) {
  const { phase, angle_rad: angle, velocity_rad_s: rate } = moment.state;
  const known = RATIOS.map((name) => moment.ratios[name].value);
  const moves = phase === "moving" && swing !== null && !swing.includes(null);
  const goesOn = simulated && moment.time_s > simulated.time && moment.time_s - simulated.time < 1;
  if (moves && goesOn) simulated = fall(simulated, swing, moment.time_s);
  else simulated = moves && angle !== null && rate !== null ? { time: moment.time_s, angle, rate } : null;
  turn("measured", angle);
  turn("simulated", simulated ? simulated.angle : angle);
  tell("angle", angle === null ? "no angle" : `${((angle * 180) / Math.PI).toFixed(1)}°`);
  const last = past.length ? past[past.length - 1][0] : -1;
  if (known.includes(null) || moment.time_s === last) return;
  if (moment.time_s < last) past = [];
  const told = { ...moment.ratios, ...moment.absolute };
  past.push([moment.time_s, ...CURVES.flatMap((name) => [told[name]?.value ?? null, told[name]?.standard_error ?? null])]);
  if (past.length > KEPT) past = past.filter((_, place) => place % 2);
}

function made(name, attributes) {
  const found = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) found.setAttribute(key, value);
  return found;
}

function draw() {
  if (past.length < 2) return;
  document.querySelectorAll("figure").forEach((figure, place) => {
    const column = 1 + 2 * place;
    const told = past.filter((each) => each[column] !== null);
    figure.hidden = told.length < 2;
    if (!figure.hidden) plot(figure, column, told);
  });
}

function plot(figure, column, told) {
  const [chart, scale, ends] = [".chart", ".scale", ".ends"].map((name) => figure.querySelector(name));
  if (!believed) return [chart, scale, ends].forEach((each) => each.replaceChildren());
  const newest = told[told.length - 1];
  const sure = told.filter((each) => each[column + 1] <= NEAR * newest[column + 1]);
  const least = Math.min(...sure.map((each) => each[column] - each[column + 1]));
  const most = Math.max(...sure.map((each) => each[column] + each[column + 1]));
  const room = (most - least) * 0.08 || 1e-9;
  const [low, high] = [least - room, most + room];
  const x = (time) => (320 * (time - past[0][0])) / (past[past.length - 1][0] - past[0][0] || 1);
  const y = (value) => Math.max(-200, Math.min(330, (130 * (high - value)) / (high - low)));
  const corner = (sign) => (each) => `${x(each[0]).toFixed(1)},${y(each[column] + sign * each[column + 1]).toFixed(1)}`;
  const band = [...told.map(corner(1)), ...told.map(corner(-1)).reverse()].join(" ");
  chart.replaceChildren(
    made("polygon", { class: "band", points: band }),
    made("polyline", { class: "curve", points: told.map(corner(0)).join(" ") }),
  );
  const digits = (size) => Math.max(0, 1 - Math.floor(Math.log10(size || 1)));
  const level = (value) => value.toFixed(digits(high - low));
  const final = (value) => value.toFixed(digits(newest[column + 1]));
  write(scale, [level(high), level((low + high) / 2), level(low)]);
  write(ends, [`${past[0][0].toFixed(0)} s`, `${final(newest[column])} ± ${final(newest[column + 1])}`, `${past[past.length - 1][0].toFixed(0)} s`]);
}

function write(place, texts) {
  place.replaceChildren(...texts.map((text) => Object.assign(document.createElement("span"), { textContent: text })));
}

function cell(content, kind) {
  const found = document.createElement("td");
  if (kind) found.className = kind;
  found.append(content);
  return found;
}

function goal(share, wanted) {
  const found = document.createElement("span");
  if (share === null) return found;
  const bar = Object.assign(document.createElement("progress"), { max: 1, value: share, title: `${Math.round(100 * share)} %` });
  found.append(bar, ` ${wanted}`);
  return found;
}

function list(rows) {
  at("rows").replaceChildren(...rows.map((each) => {
    const found = document.createElement("tr");
    found.append(cell(each.name), cell(each.value, "right"), cell(each.error, "right"), cell(each.unit), cell(goal(each.goal, each.wanted)));
    return found;
  }));
}

function show(board) {
  tell("trust", board.reached ? "enough: the goal is reached" : board.trust, board.reached ? "good" : board.level);
  tell("doing", board.doing || "\u00a0");
  if (board.over) tell("link", board.over, "none");
  tell("drops", board.drops);
  at("loaded").hidden = !board.weight || board.ended;
  tell("weight", board.weight);
  tell("next", board.next || "-");
  tell("fit", board.fit || "-");
  tell("stream", board.stream || "-");
  list(board.rows);
  believed = !board.moment || board.moment.ratios[RATIOS[0]].value !== null;
  if (board.moment) follow(board.moment, board.swing);
  draw();
}

at("turn").onclick = () => fetch(`weight${location.search}`, { method: "POST" });
const source = new EventSource(`events${location.search}`);
source.onopen = () => tell("link", "live", "good");
source.onerror = () => tell("link", "connection lost; trying again", "bad");
source.addEventListener("past", (message) => { past = JSON.parse(message.data); simulated = null; });
source.addEventListener("now", (message) => show(JSON.parse(message.data)));
source.addEventListener("end", () => { source.close(); tell("link", "ended", "none"); });
