'use strict';
// Draws the report from the JSON in #report-data; html.cpp writes that JSON, document.h says what each part means.
(() => {
const data = JSON.parse(document.getElementById('report-data').textContent);
const SVG = 'http://www.w3.org/2000/svg';

// --- Elements -------------------------------------------------------------------------------------------------------

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children.flat().filter(child => child !== null));
  return node;
}
const html = (tag, attributes = {}, ...children) => fill(document.createElement(tag), attributes, children);
const svg = (tag, attributes = {}, ...children) => fill(document.createElementNS(SVG, tag), attributes, children);
const section = (title, lead, ...children) =>
    html('section', {}, html('h2', {}, title), lead ? html('p', {class: 'quiet lead'}, lead) : null, ...children);
const round = value => Math.round(value * 100) / 100;
const polyline = points => points.map(([x, y]) => `${round(x)},${round(y)}`).join(' ');

// --- Frames: whatever shows the current frame adds a function here ----------------------------------------------------

const watchers = [];
let current = 0;
function show(frame) {
  current = Math.max(0, Math.min(data.frames.length - 1, frame));
  for (const watch of watchers) watch(data.frames[current], current);
}

// --- Head -----------------------------------------------------------------------------------------------------------

function head() {
  const missed = data.figures.filter(figure => figure.verdict === 'short').length;
  const verdict = data.figures.length === 0 ? null :
      missed === 0 ? html('span', {class: 'verdict ok'}, `✓ all ${data.figures.length} bounds kept`) :
                     html('span', {class: 'verdict short'}, `${missed} of ${data.figures.length} bounds missed`);
  const tiles = data.headline.map(figure => html('div', {class: `tile ${figure.verdict}`},
      html('div', {class: 'label'}, figure.label),
      html('div', {class: 'value'}, figure.value),
      html('div', {class: 'bound'}, figure.verdict === 'ok' ? `bound ${figure.bound}` : `short of ${figure.bound}`)));
  return html('header', {},
      html('div', {class: 'headline'}, html('h1', {}, data.title), verdict),
      html('div', {class: 'quiet'}, data.subtitle),
      html('div', {class: 'tiles'}, ...tiles));
}

const wide = data.width / data.height > 2;  // Image above the map instead of beside it.

// --- Camera image with contact points -------------------------------------------------------------------------------

function cameraView() {
  const image = html('img', {alt: 'camera image'});
  const size = data.width / 640;  // Marks keep their size on the page whatever the image's width.
  const walk = data.lines.map(([u0, v0, u1, v1]) => svg('line', {x1: u0, y1: v0, x2: u1, y2: v1, class: 'walk', 'stroke-width': size}));
  const marks = svg('g');
  const overlay = svg('svg', {viewBox: `-0.5 -0.5 ${data.width} ${data.height}`}, ...walk, marks);
  const caption = html('div', {class: 'caption'});
  watchers.push(frame => {
    image.src = frame.camera;
    marks.replaceChildren(
        ...frame.kernelContacts.map(([u, v, clipped]) =>
            svg('circle', {cx: u, cy: v, r: 3.6 * size, class: 'kernel-mark', 'stroke-width': size, 'fill-opacity': clipped ? 0.35 : 1})),
        ...frame.goldenContacts.map(([u, v]) => svg('circle', {cx: u, cy: v, r: 6 * size, class: 'golden-mark', 'stroke-width': 1.3 * size})));
    caption.replaceChildren(html('span', {}, html('b', {}, `Frame ${frame.index}`), ` at ${frame.timestamp.toFixed(2)} s`),
        html('span', {}, `${frame.kernelContacts.length} contact points`));
  });
  return html('div', {class: 'card'}, html('div', {class: 'picture'}, image, overlay), caption);
}

// --- Floor map ------------------------------------------------------------------------------------------------------
// World coordinates in metres, turned so that the robot's first heading points up, or to the right for a long straight way.

const first = data.path.length ? data.path[0] : [0, 0, 0];
/** World coordinates as metres ahead of and to the left of the robot's first place. */
function aheadAndLeft([x, y]) {
  const dx = x - first[0], dy = y - first[1], c = Math.cos(first[2]), s = Math.sin(first[2]);
  return [c * dx + s * dy, -s * dx + c * dy];
}
function toWorld([px, py, yaw], [x, y]) {
  return [px + Math.cos(yaw) * x - Math.sin(yaw) * y, py + Math.sin(yaw) * x + Math.cos(yaw) * y];
}
const sideways = (() => {
  const way = data.path.map(aheadAndLeft);
  const length = Math.max(...way.map(point => Math.abs(point[0])), 0), breadth = Math.max(...way.map(point => Math.abs(point[1])), 0);
  return length > 20 && length > 2 * breadth;
})();
function toMap(point) {
  const [ahead, left] = aheadAndLeft(point);
  return sideways ? [ahead, -left] : [-left, -ahead];
}
const onMap = (pose, points) => points.map(point => toMap(toWorld(pose, point)));

function mapExtent() {
  const points = data.path.map(toMap);
  for (const frame of data.frames) {
    points.push(...onMap(frame.pose, data.fieldOfView), ...onMap(frame.pose, frame.obstacles));
  }
  if (points.length === 0) points.push([-1, -1], [1, 1]);
  const xs = points.map(point => point[0]), ys = points.map(point => point[1]);
  const margin = 0.3;
  return {left: Math.min(...xs) - margin, right: Math.max(...xs) + margin, top: Math.min(...ys) - margin, bottom: Math.max(...ys) + margin};
}

function niceStep(length) {
  return [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50].find(step => length / step <= 9) || 100;
}

/** An empty map with metre axes; `layers` are drawn inside its frame, in pixels scaled by `scale` from metres. */
function mapFrame(extent, width, build) {
  const gutter = 34, scale = (width - gutter - 8) / (extent.right - extent.left);
  const height = (extent.bottom - extent.top) * scale;
  const px = ([x, y]) => [gutter + (x - extent.left) * scale, 8 + (y - extent.top) * scale];
  const across = extent.right - extent.left, along = extent.bottom - extent.top;
  const step = Math.min(niceStep(Math.max(across, along)), niceStep(1.5 * Math.min(across, along)));
  const axes = [];
  for (let x = Math.ceil(extent.left / step); x * step <= extent.right; ++x) {
    const [at] = px([x * step, 0]);
    axes.push(svg('line', {x1: at, x2: at, y1: 8, y2: 8 + height, class: 'axis'}),
        svg('text', {x: at, y: height + 23, 'text-anchor': 'middle'}, String(round((sideways ? x : -x) * step))));
  }
  for (let y = Math.ceil(extent.top / step); y * step <= extent.bottom; ++y) {
    const [, at] = px([0, y * step]);
    axes.push(svg('line', {x1: gutter, x2: width - 8, y1: at, y2: at, class: 'axis'}),
        svg('text', {x: gutter - 6, y: at + 4, 'text-anchor': 'end'}, String(round(-y * step))));
  }
  const clip = `map-${Math.random().toString(36).slice(2)}`;
  const inside = svg('g', {'clip-path': `url(#${clip})`}, ...build(px, scale));
  return svg('svg', {viewBox: `0 0 ${width} ${height + 42}`},
      svg('clipPath', {id: clip}, svg('rect', {x: gutter, y: 8, width: width - gutter - 8, height})), ...axes, inside,
      svg('text', {x: width - 8, y: height + 38, 'text-anchor': 'end'}, sideways ? 'metres ahead →, to the left ↑' : 'metres to the left ←, ahead ↑'));
}

const pathLine = px => svg('polyline', {points: polyline(data.path.map(toMap).map(px)), class: 'path'});

function robotMark(px, [x, y, yaw]) {
  const [u, v] = px(toMap([x, y]));
  const [tipU, tipV] = px(toMap([x + Math.cos(yaw), y + Math.sin(yaw)]));
  const angle = Math.atan2(tipV - v, tipU - u) * 180 / Math.PI;
  return svg('path', {d: 'M11,0 L-7,7 L-3,0 L-7,-7 Z', class: 'robot', transform: `translate(${round(u)},${round(v)}) rotate(${round(angle)})`});
}

function floorMap() {
  const dynamic = svg('g');
  let px;
  const picture = mapFrame(mapExtent(), wide ? 1300 : 560, project => {
    px = project;
    return [pathLine(px), dynamic];
  });
  const place = (pose, points) => onMap(pose, points).map(px);
  const dots = (pose, points, radius, style) =>
      place(pose, points).map(([x, y]) => svg('circle', {cx: round(x), cy: round(y), r: radius, class: style}));
  watchers.push((frame, number) => {
    const earlier = data.frames.slice(0, number).flatMap(past => dots(past.pose, past.obstacles, 3, 'earlier'));
    dynamic.replaceChildren(
        svg('polygon', {points: polyline(place(frame.pose, data.fieldOfView)), class: 'field'}),
        ...frame.markings.map(marking => svg('polygon', {points: polyline(place(frame.pose, marking)), class: 'marking'})),
        ...frame.truth.map(foot => svg('polyline', {points: polyline(place(frame.pose, foot.contact)), class: 'foot'},
            svg('title', {}, foot.kind))),
        ...earlier, ...dots(frame.pose, frame.points, 2.2, 'point'), ...dots(frame.pose, frame.obstacles, 4.6, 'obstacle'),
        robotMark(px, frame.pose));
  });
  return html('div', {class: 'card map'}, picture);
}

function legend() {
  const key = (shape, text) => html('span', {}, svg('svg', {viewBox: '0 0 16 16'}, shape), text);
  const has = field => data.frames.some(frame => frame[field].length > 0);
  return html('div', {class: 'legend'},
      key(svg('circle', {cx: 8, cy: 8, r: 4, class: 'kernel-mark'}), 'contact point, fixed-point kernels'),
      has('goldenContacts') ? key(svg('circle', {cx: 8, cy: 8, r: 6, class: 'golden-mark', 'stroke-width': 1.4}), 'contact point, golden model') : null,
      key(svg('circle', {cx: 8, cy: 8, r: 4.6, class: 'obstacle'}), 'obstacle reported on the floor (faint: earlier frames)'),
      has('truth') ? key(svg('path', {d: 'M2,11 L8,4 L14,11', class: 'foot'}), 'true foot of an obstacle or wall') : null,
      has('markings') ? key(svg('rect', {x: 2, y: 3, width: 12, height: 10, class: 'marking'}), 'painted marking, no obstacle') : null,
      key(svg('path', {d: 'M14,8 L3,13 L6,8 L3,3 Z', class: 'robot'}), 'robot, its path and field of view'));
}

function viewSection() {
  const readings = html('div', {class: 'readings'});
  watchers.push(frame => readings.replaceChildren(...frame.readings.map(([name, value]) => html('span', {}, name, html('b', {}, value)))));
  return section('What the system sees', null,
      html('div', {class: wide ? 'view wide' : 'view'}, html('div', {}, cameraView(), readings), floorMap()), legend());
}

// --- Stages ---------------------------------------------------------------------------------------------------------

function picture(title, note) {
  const image = html('img', {alt: title});
  const remark = html('span', {}, note);
  return {image, remark, card: html('div', {class: 'card'}, html('div', {class: 'picture'}, image),
      html('div', {class: 'caption'}, html('b', {}, title), remark))};
}

function stageRow(stage, index) {
  const kernel = picture('kernel', 'fixed point');
  const golden = picture('golden', 'floating point');
  const difference = picture('difference', '');
  watchers.push(frame => {
    const pictures = frame.stages[index];
    if (!pictures) return;
    kernel.image.src = pictures.kernel;
    golden.image.src = pictures.golden;
    difference.image.src = pictures.difference;
    difference.remark.textContent = `× ${stage.amplification} · ${pictures.caption}`;
  });
  return html('div', {},
      html('div', {class: 'stage-head'}, html('h3', {}, stage.name), html('span', {class: 'quiet'}, stage.description),
          ...stage.figures.map(figure => html('span', {class: `figure ${figure.verdict}`},
              `${figure.verdict === 'ok' ? '✓' : '✗'} ${figure.label}: ${figure.value} (${figure.bound})`))),
      html('div', {class: 'stage'}, kernel.card, golden.card, difference.card));
}

function stagesSection() {
  if (data.stages.length === 0) return null;
  return section('Stage by stage',
      'Each kernel in C simulation beside its floating-point twin on the same input; the third picture is their difference, amplified: black where both agree.',
      ...data.stages.map(stageRow));
}

// --- Tables, histograms, grid, hardware, parameters -------------------------------------------------------------------

const isNumber = text => /^[≤≥]? ?[-+]?[\d.,]+(e[-+]?\d+)?( ?[%\w/²×]{1,9})?$/.test(text);

function table(columns, rows) {
  const numeric = columns.map((_, i) => rows.length > 0 && rows.every(row => isNumber(String(row[i])) || row[i] === 'none'));
  const cell = (text, i) => {
    const style = text === 'ok' || text === 'short' ? text : numeric[i] ? 'number' : '';
    return html('td', {class: style}, String(text));
  };
  return html('table', {}, html('thead', {}, html('tr', {}, ...columns.map((name, i) => html('th', {class: numeric[i] ? 'number' : ''}, name)))),
      html('tbody', {}, ...rows.map(row => html('tr', {}, ...row.map(cell)))));
}

function figuresSection() {
  const bounds = data.figures.map(figure => [figure.label, figure.value, figure.bound, figure.verdict]);
  const blocks = data.tables.map(entry => html('div', {}, html('h3', {}, entry.title),
      entry.note ? html('p', {class: 'quiet'}, entry.note) : null, table(entry.columns, entry.rows)));
  if (bounds.length) blocks.unshift(html('div', {}, html('h3', {}, 'Measured against bounds'), table(['figure', 'value', 'bound', 'verdict'], bounds)));
  return blocks.length ? section('Figures', null, ...blocks) : null;
}

function histogramChart({title, unit, low, high, counts, note}) {
  const width = 400, height = 150, base = 126, most = Math.max(1, ...counts), step = width / counts.length;
  const bars = counts.map((count, i) => svg('rect', {x: round(i * step + 0.5), width: round(step - 1), class: 'bar',
      y: round(base - count / most * (base - 12)), height: round(count / most * (base - 12))},
      svg('title', {}, `${count} from ${round(low + (high - low) * i / counts.length)} ${unit}`)));
  const label = (share, anchor) => svg('text', {x: width * share, y: base + 16, 'text-anchor': anchor}, `${round(low + (high - low) * share)}${share === 1 ? ` ${unit} and more` : ''}`);
  return html('div', {class: 'card'}, html('b', {}, title), html('div', {class: 'quiet'}, note),
      svg('svg', {viewBox: `0 0 ${width} ${height}`}, ...bars, svg('line', {x1: 0, x2: width, y1: base, y2: base, class: 'axis'}),
          label(0, 'start'), label(0.5, 'middle'), label(1, 'end')));
}

function histogramsSection() {
  return data.histograms.length ? section('Errors', null, html('div', {class: 'charts'}, ...data.histograms.map(histogramChart))) : null;
}

function gridSection() {
  if (data.grids.length === 0) return null;
  const grid = data.grids[0], [x, y] = grid.origin;
  const corners = [[x, y], [x + grid.width, y], [x, y + grid.height], [x + grid.width, y + grid.height]].map(toMap);
  const extent = {left: Math.min(...corners.map(c => c[0])), right: Math.max(...corners.map(c => c[0])),
      top: Math.min(...corners.map(c => c[1])), bottom: Math.max(...corners.map(c => c[1]))};
  const turn = first[2] * 180 / Math.PI - (sideways ? 0 : 90);
  const map = mapFrame(extent, wide ? 1300 : 760, (px, scale) => {
    // The picture's row 0 lies at the greatest Y: its upper left corner is (x, y + height) in the world.
    const [u, v] = px(toMap([x, y + grid.height]));
    const image = svg('image', {href: grid.picture, width: grid.width * scale, height: grid.height * scale, 'image-rendering': 'pixelated',
        preserveAspectRatio: 'none', transform: `translate(${u},${v}) rotate(${turn})`});
    return [image, pathLine(px)];
  });
  return section('Occupancy grid', 'After the last frame: dark is occupied, light is proved free by the lines, grey is unknown.',
      html('div', {class: 'card map', style: `max-width: ${wide ? 1304 : 760}px`}, map));
}

function hardwareSection() {
  if (data.hardware.length === 0) return null;
  return section('Hardware', null, ...data.hardware.map(entry => html('div', {}, html('h3', {}, entry.title),
      entry.note ? html('p', {class: 'quiet lead'}, entry.note) : null,
      entry.rows && entry.rows.length ? table(entry.columns, entry.rows) : null,
      entry.picture ? html('img', {src: entry.picture, class: 'hardware-picture', alt: entry.title}) : null)));
}

function parametersSection() {
  return data.parameters.length ? section('Parameters used', null, table(['parameter', 'value', 'meaning'], data.parameters)) : null;
}

// --- Player ---------------------------------------------------------------------------------------------------------

function player() {
  if (data.frames.length < 2) return null;
  const slider = html('input', {type: 'range', min: 0, max: data.frames.length - 1, value: 0, 'aria-label': 'frame'});
  const button = html('button', {title: 'play or pause (space)'}, '▶');
  const place = html('output');
  let timer = null;
  const toggle = () => {
    if (timer) { clearInterval(timer); timer = null; }
    else timer = setInterval(() => show((current + 1) % data.frames.length), 180);
    button.textContent = timer ? '❚❚' : '▶';
  };
  slider.addEventListener('input', () => show(Number(slider.value)));
  button.addEventListener('click', toggle);
  document.addEventListener('keydown', event => {
    if (event.target === slider && event.key.startsWith('Arrow')) return;
    if (event.key === 'ArrowRight') show(current + 1);
    else if (event.key === 'ArrowLeft') show(current - 1);
    else if (event.key === ' ' && event.target !== button) { event.preventDefault(); toggle(); }
  });
  watchers.push((frame, number) => {
    slider.value = number;
    place.textContent = `frame ${frame.index}  (${number + 1} of ${data.frames.length})`;
  });
  return html('div', {class: 'player'}, html('div', {}, button, slider, place, html('kbd', {}, '← → step, space plays')));
}

// --- Page -----------------------------------------------------------------------------------------------------------

const parts = [data.frames.length ? viewSection() : null, stagesSection(), figuresSection(), histogramsSection(), gridSection(),
  hardwareSection(), parametersSection()];
document.body.append(head(), html('main', {}, ...parts.filter(part => part !== null)));
const bar = player();
if (bar) document.body.append(bar);
if (data.frames.length) show(Math.floor(data.frames.length / 2));
})();
