// One row for each kind of part: how a new one looks, its handles, and its shape as polylines, for the overlay and for picking.
import { across, add, addScaled, dot, length, mix, normalize, scale, subtract } from './vector.mjs';

const glow = (size) => ({ brightness: 3, core: 0.03 * size, reach: 0.6 * size, sharpness: 2, color: [0.1, 0.4, 1] });

// A handle that is one of the part's positions.
const positionHandle = (part, member, label) => ({
    label, position: part[member], move: (changed, position) => (changed[member] = position) });

const pointHandles = (part, member) => part[member].map((position, i) => ({
    label: `point ${i + 1}`, position, point: i, move: (changed, moved) => (changed[member][i] = moved) }));

// A handle at the end of a vector of the part, `reach` long, or as long as the vector.
const vectorHandle = (part, from, member, label, reach) => ({
    label,
    position: addScaled(part[from], reach, normalize(part[member])),
    move(changed, moved) {
        const vector = subtract(moved, changed[from]);
        if (length(vector) > 0) changed[member] = normalize(vector);
    },
});

const worldAxes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

export function circle(center, axis, radius, count = 64) {
    const [u, v] = across(axis);
    return Array.from({ length: count + 1 }, (_, i) => {
        const angle = (2 * Math.PI * i) / count;
        return addScaled(addScaled(center, radius * Math.cos(angle), u), radius * Math.sin(angle), v);
    });
}

const quadratic = (a, b, c, count = 16) => Array.from({ length: count + 1 }, (_, i) => mix(mix(a, b, i / count), mix(b, c, i / count), i / count));

const cubic = (a, b, c, d, count = 16) => Array.from({ length: count + 1 }, (_, i) => {
    const t = i / count, ab = mix(a, b, t), bc = mix(b, c, t), cd = mix(c, d, t);
    return mix(mix(ab, bc, t), mix(bc, cd, t), t);
});

const bezierOf = (polynomial, [start, end]) => Array.from({ length: 33 }, (_, i) => {
    const t = start + ((end - start) * i) / 32;
    return addScaled(addScaled(polynomial[0], t, polynomial[1]), t * t, polynomial[2]);
});

function bspline(points, closed) {
    const n = points.length;
    const line = [];
    for (let i = closed ? 0 : 1; i < (closed ? n : n - 1); i++) {
        const before = points[(i + n - 1) % n], here = points[i], after = points[(i + 1) % n];
        const start = !closed && i === 1 ? before : mix(before, here, 0.5);
        const end = !closed && i === n - 2 ? after : mix(here, after, 0.5);
        line.push(...quadratic(start, here, end));
    }
    return line;
}

function catmullRom(points, closed) {
    const n = points.length;
    const at = (i) => closed ? points[(i + n) % n]
        : i < 0 ? addScaled(scale(points[0], 2), -1, points[1])
        : i >= n ? addScaled(scale(points[n - 1], 2), -1, points[n - 2]) : points[i];
    const line = [];
    for (let i = 0; i < (closed ? n : n - 1); i++) {
        const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
        line.push(...cubic(b, addScaled(b, 1 / 6, subtract(c, a)), addScaled(c, -1 / 6, subtract(d, b)), c));
    }
    return line;
}

function pathLine({ kind = 'polyline', points, closed = false }) {
    if (kind === 'bspline' && points.length > 2) return bspline(points, closed);
    if (kind === 'catmull_rom' && points.length > 1) return catmullRom(points, closed);
    if (kind === 'bezier') {
        const line = [];
        for (let i = 0; i + 3 < points.length; i += 3) line.push(...cubic(...points.slice(i, i + 4)));
        return line;
    }
    return closed ? [...points, points[0]] : points;
}

const boxCorners = ({ min, max }) => Array.from({ length: 8 }, (_, i) => [0, 1, 2].map((axis) => ((i >> axis) & 1 ? max : min)[axis]));

function boxLines(box) {
    const corners = boxCorners(box);
    const lines = [];
    for (let i = 0; i < 8; i++) for (let axis = 0; axis < 3; axis++) if (!((i >> axis) & 1)) lines.push([corners[i], corners[i | (1 << axis)]]);
    return lines;
}

// The least thickness of a box that is dragged.
const thinnest = 1e-3;

const boxHandles = (box) => [
    { label: 'middle', position: mix(box.min, box.max, 0.5), move(changed, moved) {
        const way = subtract(moved, mix(changed.min, changed.max, 0.5));
        changed.min = add(changed.min, way);
        changed.max = add(changed.max, way);
    } },
    { label: 'least corner', position: box.min, move: (changed, moved) => (changed.min = moved.map((x, i) => Math.min(x, changed.max[i] - thinnest))) },
    { label: 'largest corner', position: box.max, move: (changed, moved) => (changed.max = moved.map((x, i) => Math.max(x, changed.min[i] + thinnest))) },
];

// One for the end of each radius, along its axis.
const radiiHandles = ({ center, radii, axes = worldAxes }) => radii.map((radius, i) => ({
    label: `radius ${i + 1}`, position: addScaled(center, radius, normalize(axes[i])),
    move: (changed, moved) => (changed.radii[i] = Math.max(thinnest, Math.abs(dot(subtract(moved, changed.center), normalize(axes[i]))))) }));

// An ellipse with the conjugate half axes u and v.
const ellipse = (center, u, v, count = 64) => Array.from({ length: count + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return addScaled(addScaled(center, Math.cos(angle), u), Math.sin(angle), v);
});

// Of opaque shapes and of media, which may be ellipsoids but no planes.
const shapes = {
    ellipsoid: {
        handles: (ellipsoid) => [positionHandle(ellipsoid, 'center', 'centre'), ...radiiHandles(ellipsoid)],
        lines({ center, radii, axes = worldAxes }) {
            const halves = radii.map((radius, i) => scale(normalize(axes[i]), radius));
            return halves.map((half, i) => ellipse(center, half, halves[(i + 1) % 3]));
        },
    },
    box: { handles: boxHandles, lines: boxLines },
    plane: {
        handles: (plane) => [positionHandle(plane, 'point', 'point'), vectorHandle(plane, 'point', 'normal', 'normal', 1)],
        lines: ({ point, normal }) => [circle(point, normal, 1, 4), [point, add(point, normalize(normal))]],
    },
    sphere: {
        handles: (sphere) => [positionHandle(sphere, 'center', 'centre'), {
            label: 'radius', position: add(sphere.center, [sphere.radius, 0, 0]),
            move: (changed, moved) => (changed.radius = Math.max(thinnest, length(subtract(moved, changed.center)))) }],
        lines: ({ center, radius }) => worldAxes.map((axis) => circle(center, axis, radius)),
    },
};

// `create` makes one at a place, `size` world units large; `right` is the viewer's right.
export const kinds = {
    points: {
        label: 'Orb',
        create: (at, size) => ({ position: at, ...glow(size), core: 0.1 * size, reach: 0.8 * size }),
        handles: (part) => [positionHandle(part, 'position', 'position')],
        lines: (part) => [[part.position, part.position]],
    },
    paths: {
        label: 'Path',
        create: (at, size, right) => ({
            kind: 'catmull_rom',
            points: [-1, -0.33, 0.33, 1].map((x, i) => addScaled(addScaled(at, x * size, right), [0, 0.35, -0.35, 0][i] * size, [0, 1, 0])),
            ...glow(size) }),
        handles: (part) => pointHandles(part, 'points'),
        lines: (part) => [pathLine(part)],
    },
    lines: {
        label: 'Line',
        create: (at, size, right) => ({ position: at, direction: right, ...glow(size) }),
        handles: (part) => [positionHandle(part, 'position', 'position'), vectorHandle(part, 'position', 'direction', 'direction', 1)],
        lines: ({ position, direction }) => {
            const unit = normalize(direction);
            return [Array.from({ length: 81 }, (_, i) => addScaled(position, Math.sign(i - 40) * 1.17 ** Math.abs(i - 40) - Math.sign(i - 40), unit))];
        },
    },
    tori: {
        label: 'Ring',
        create: (at, size) => ({ center: at, axis: [0, 1, 0], radius: 0.7 * size, ...glow(size) }),
        handles: (part) => [positionHandle(part, 'center', 'centre'),
            vectorHandle(part, 'center', 'axis', 'axis', Math.max(part.radius, thinnest)), {
                label: 'radius', position: addScaled(part.center, part.radius, across(part.axis)[0]),
                move: (changed, moved) => (changed.radius = length(subtract(moved, changed.center))) }],
        lines: (part) => [circle(part.center, part.axis, part.radius)],
    },
    curves: {
        label: 'Curve',
        create: (at, size, right) => ({
            control_points: [addScaled(at, -size, right), addScaled(at, size, [0, 1, 0]), addScaled(at, size, right)], ...glow(size) }),
        handles: (part) => (part.control_points ? pointHandles(part, 'control_points') : polynomialHandles(part)),
        lines: (part) => [part.control_points ? bezierOf(polynomialOf(part.control_points), part.domain ?? [0, 1]) : bezierOf(part.polynomial, part.domain ?? [0, 1])],
    },
    opaque: {
        label: 'Solid',
        create: (at, size) => ({ shape: 'box', min: addScaled(at, -0.4 * size, [1, 1, 1]), max: addScaled(at, 0.4 * size, [1, 1, 1]), color: [0.3, 0.3, 0.32] }),
        handles: (part) => shapes[part.shape].handles(part),
        lines: (part) => shapes[part.shape].lines(part),
    },
    media: {
        label: 'Medium',
        create: (at, size) => ({ shape: 'sphere', center: at, radius: 0.6 * size, extinction: Number((1 / size).toPrecision(2)), albedo: 0.8, ambient: [0.1, 0.16, 0.24] }),
        handles: (part) => shapes[part.shape].handles(part),
        lines: (part) => shapes[part.shape].lines(part),
    },
};

export function polynomialOf([a, b, c]) {
    return [a, scale(subtract(b, a), 2), add(subtract(a, scale(b, 2)), c)];
}

// A curve that is given by its polynomial has one handle, which moves all of it.
function polynomialHandles(part) {
    return [{ label: 'position', position: part.polynomial[0], move: (changed, moved) => (changed.polynomial[0] = moved) }];
}

export const isSource = (list) => list !== 'opaque' && list !== 'media';
export const hasWeights = (list) => list === 'paths' || list === 'curves';

// A B-spline that winds round an axis that goes up through `at`, `height` high and as wide as `radius`.
function spiral(at, size, radius, height) {
    const turns = 3, perTurn = 8, count = turns * perTurn;
    const points = Array.from({ length: count + 1 }, (_, i) => {
        const angle = (2 * Math.PI * i) / perTurn;
        return add(at, [radius * Math.cos(angle), height * (i / count), radius * Math.sin(angle)].map((x) => Number(x.toPrecision(5))));
    });
    return { kind: 'bspline', points, ...glow(size) };
}

// What can be added: its list, and a function that makes one. A spiral winds round the opaque shape `around`, if there is one.
export const additions = {
    orb: { label: 'Orb', list: 'points', create: kinds.points.create },
    beam: { label: 'Beam', list: 'paths', create: (at, size, right) => ({ points: [addScaled(at, -size, right), addScaled(at, size, right)], ...glow(size) }) },
    path: { label: 'Path', list: 'paths', create: kinds.paths.create },
    spiral: { label: 'Spiral', list: 'paths', create(at, size, right, around) {
        if (around?.shape === 'box') {
            const [x, , z] = mix(around.min, around.max, 0.5), height = around.max[1] - around.min[1];
            return spiral([x, around.min[1] + 0.05 * height, z], size, 0.85 * Math.max(around.max[0] - around.min[0], around.max[2] - around.min[2]), 0.9 * height);
        }
        if (around?.shape === 'sphere') return spiral(addScaled(around.center, -around.radius, [0, 1, 0]), size, 1.2 * around.radius, 2 * around.radius);
        return spiral(addScaled(at, -size, [0, 1, 0]), size, 0.6 * size, 2 * size);
    } },
    ring: { label: 'Ring', list: 'tori', create: kinds.tori.create },
    line: { label: 'Endless line', list: 'lines', create: kinds.lines.create },
    curve: { label: 'Curve', list: 'curves', create: kinds.curves.create },
    shape: { label: 'Solid', list: 'opaque', create: kinds.opaque.create },
    medium: { label: 'Medium', list: 'media', create: kinds.media.create },
};
