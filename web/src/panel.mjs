// What the panel shows of the selected part: its name, its light, its shape.
import { button, checkbox, color, element, select, slider, text, vector } from './controls.mjs';
import { hasWeights, isSource } from './kinds.mjs';
import { addScaled, mix, subtract } from './vector.mjs';
import { colorOf, listOf, nameOf, partOf, withPart } from './scene.mjs';
import { weightsEditor } from './weights.mjs';

// Controls that a change of this would make others. Rebuilding on each change would take the focus from what is dragged.
const structureOf = (part) => JSON.stringify([Object.keys(part), part.weights?.length, part.points?.length, part.kind, part.closed]);

// Changes that would make the scene wrong take what they depend on along.
function setLight(part, key, value) {
    if (key === 'brightness') delete part.coefficient;
    if (key === 'core' || key === 'reach') value = Math.max(value, 1e-6);
    if (key === 'sharpness') value = Math.max(value, 1);
    part[key] = Math.max(value, 0);
    if (part.reach !== undefined && !(part.reach > (part.core ?? 0))) {
        if (key === 'core') part.reach = Number((1.5 * part.core).toPrecision(4));
        else part.core = Number((part.reach / 1.5).toPrecision(4));
    }
}

function lightControls(app, part, get, change) {
    const number = (key, label, unit, min, max, log, fallback) => slider({
        id: key, label, unit, min, max, log, get: () => get()[key] ?? fallback,
        set: (value, isFinal) => change((changed) => setLight(changed, key, value), isFinal) });
    const { scene } = app.history.current;
    const controls = [
        part.coefficient === undefined && part.reach !== undefined
            ? number('brightness', 'Brightness', '×', 0, 8, false, 1) : number('coefficient', 'Coefficient', '', 0.01, 100, true, 1),
        number('core', 'Core', 'units', 0.001, 10, true, scene.epsilon ?? 1e-3)];
    if (part.reach !== undefined)
        controls.push(number('reach', 'Reach', 'units', 0.01, 100, true, 1), number('sharpness', 'Sharpness', '', 1, 8, false, 1));
    return controls;
}

// The new point goes on from the last two, or half way to the next one.
function addPoint(points, after) {
    const last = points.length - 1;
    const at = after === undefined || after >= last ? last : after;
    const place = at === last ? addScaled(points[last], 0.5, subtract(points[last], points[Math.max(last - 1, 0)])) : mix(points[at], points[at + 1], 0.5);
    points.splice(at + 1, 0, place);
    return at + 1;
}

function addBezier(points) {
    const [, , c, d] = points.slice(-4), way = subtract(d, c);
    points.push(addScaled(d, 1, way), addScaled(d, 2, way), addScaled(d, 3, way));
}

const fewestPoints = ({ kind = 'polyline', closed }) => (kind === 'bezier' ? 4 : closed || kind === 'bspline' ? 3 : 2);

function setKind(path, kind) {
    path.kind = kind;
    if (kind === 'bezier') {
        delete path.closed;
        while (path.points.length < 4 || path.points.length % 3 !== 1) addPoint(path.points);
    }
    while (path.points.length < fewestPoints(path)) addPoint(path.points, 0);
}

function setClosed(path, isClosed) {
    if (isClosed) path.closed = true;
    else delete path.closed;
    while (path.points.length < fewestPoints(path)) addPoint(path.points);
}

function pathControls(app, get, change) {
    const kinds = [['polyline', 'straight pieces'], ['bspline', 'B-spline'], ['bezier', 'cubic Bezier'], ['catmull_rom', 'through all points']];
    const count = element('span', { class: 'unit' });
    const remove = () => change((path) => {
        const isBezier = path.kind === 'bezier', few = fewestPoints(path);
        if (isBezier ? path.points.length > 4 : path.points.length > few)
            path.points.splice(isBezier ? -3 : app.selectedPoint ?? path.points.length - 1, isBezier ? 3 : 1);
    }, true);
    const add = () => {
        let chosen;
        change((path) => (path.kind === 'bezier' ? addBezier(path.points) : (chosen = addPoint(path.points, app.selectedPoint))), true);
        app.selectPoint(chosen);
    };
    return [
        select({ id: 'kind', label: 'Drawn', options: kinds, get: () => get().kind ?? 'polyline', set: (kind) => change((path) => setKind(path, kind), true) }),
        ...(get().kind === 'bezier' ? [] : [checkbox({ id: 'closed', label: 'Closed', get: () => get().closed ?? false, set: (isClosed) => change((path) => setClosed(path, isClosed), true) })]),
        { element: element('div', { class: 'row' }, element('span', {}, 'Points'), count,
            button('Add point', add, { title: 'Behind the chosen point (N)', id: 'add-point' }), button('Remove', remove, { title: 'The chosen point' })),
        refresh: () => (count.textContent = get().points.length) }];
}

function mediumControls(get, change) {
    const number = (key, label, unit, min, max, log, most, fallback) => slider({ id: key, label, unit, min, max, log, get: () => get()[key] ?? fallback,
        set: (value, isFinal) => change((changed) => (changed[key] = Math.min(Math.max(value, 0), most)), isFinal) });
    return [number('extinction', 'Extinction', 'a unit', 0.01, 100, true, 1e12, 0), number('albedo', 'Albedo', '', 0, 1, false, 1, 0)];
}

function shapeControls(app, part, list, get, change) {
    const member = (key, label) => vector({ id: key, label, get: () => get()[key], set: (value, isFinal) => change((changed) => (changed[key] = value), isFinal) });
    const length = (key, label, max) => slider({ id: key, label, unit: 'units', min: 0.01, max, log: true, get: () => get()[key],
        set: (value, isFinal) => change((changed) => (changed[key] = Math.max(value, 1e-6)), isFinal) });
    const radii = () => vector({ id: 'radii', label: 'Radii', get: () => get().radii,
        set: (value, isFinal) => change((changed) => (changed.radii = value.map((radius) => Math.max(radius, 1e-6))), isFinal) });
    const shapes = { box: () => [member('min', 'Corner'), member('max', 'Corner')], plane: () => [member('point', 'Point'), member('normal', 'Normal')],
        sphere: () => [member('center', 'Centre'), length('radius', 'Radius', 100)], ellipsoid: () => [member('center', 'Centre'), radii()] };
    const shapeOf = (...names) => select({ id: 'shape', label: 'Shape', options: names.map((name) => [name, name]), get: () => get().shape,
        set: (shape) => change((changed) => setShape(changed, shape), true) });
    const kinds = {
        points: () => [member('position', 'Position')],
        lines: () => [member('position', 'Position'), member('direction', 'Direction')],
        tori: () => [member('center', 'Centre'), member('axis', 'Axis'), length('radius', 'Radius', 100)],
        curves: () => [], paths: () => pathControls(app, get, change),
        opaque: () => [shapeOf('box', 'sphere', 'plane'), ...shapes[part.shape]()],
        media: () => [...mediumControls(get, change), shapeOf('box', 'sphere', 'ellipsoid'), ...shapes[part.shape]()],
    };
    return kinds[list]();
}

// The other shape takes the old one's place and colour.
function setShape(part, shape) {
    const middle = part.shape === 'box' ? mix(part.min, part.max, 0.5) : part.center ?? part.point;
    for (const key of ['min', 'max', 'center', 'radius', 'radii', 'axes', 'point', 'normal']) delete part[key];
    part.shape = shape;
    if (shape === 'box') Object.assign(part, { min: addScaled(middle, -0.5, [1, 1, 1]), max: addScaled(middle, 0.5, [1, 1, 1]) });
    if (shape === 'sphere') Object.assign(part, { center: middle, radius: 0.5 });
    if (shape === 'ellipsoid') Object.assign(part, { center: middle, radii: [0.8, 0.4, 0.4] });
    if (shape === 'plane') Object.assign(part, { point: middle, normal: [0, 1, 0] });
}

function controlsOf(app, key) {
    const list = listOf(key), get = () => partOf(app.history.current, key), part = get();
    const change = (make, isFinal) => app.history[isFinal ? 'commit' : 'preview'](withPart(app.history.current, key, make));
    const controls = [
        text({ id: 'name', label: 'Name', placeholder: nameOf(app.history.current, key), get: () => get().name ?? '', set: (name) => change((changed) => {
            if (name) changed.name = name;
            else delete changed.name;
        }, true) }),
        color({ id: 'color', label: list === 'media' ? 'Ambient light' : 'Colour', get: () => colorOf(app.history.current, key),
            set: (value, isFinal) => change((changed) => (changed[list === 'media' ? 'ambient' : 'color'] = value), isFinal) })];
    if (isSource(list)) controls.push(...lightControls(app, part, get, change));
    controls.push(...shapeControls(app, part, list, get, change));
    if (hasWeights(list) && part.weights)
        controls.push(weightsEditor({ pulse: app.pulse, get: () => get().weights, set: (weights, isFinal) => change((changed) => {
            if (weights) changed.weights = weights;
            else delete changed.weights;
        }, isFinal) }));
    else if (hasWeights(list))
        controls.push({ element: element('div', { class: 'row' }, element('span', {}, 'Weights'), button('Vary along the path', () =>
            change((changed) => (changed.weights = [1, 1, 1, 1, 1]), true), { id: 'add-weights' })), refresh() {} });
    return controls;
}

export class Panel {
    #shown;
    #controls = [];

    constructor(container, app) {
        this.container = container;
        this.app = app;
    }

    draw() {
        const { app } = this;
        const part = partOf(app.history.current, app.selection);
        const shown = part && `${app.selection} ${structureOf(part)}`;
        if (shown !== this.#shown) {
            const focused = document.activeElement?.id;
            this.#shown = shown;
            this.#controls = part ? controlsOf(app, app.selection) : [];
            this.container.replaceChildren(...this.#controls.map((control) => control.element));
            if (focused && this.container.querySelector(`#${CSS.escape(focused)}`)) document.getElementById(focused).focus();
        }
        for (const control of this.#controls) control.refresh();
    }
}
