// Vectors of three numbers.
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const addScaled = (a, s, b) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const mix = (a, b, t) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];

export function normalize(a) {
    const l = length(a);
    return l > 0 ? scale(a, 1 / l) : [0, 0, 0];
}

// Two unit vectors across `axis` and across each other.
export function across(axis) {
    const n = normalize(axis);
    const helper = Math.abs(n[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
    const first = normalize(cross(n, helper));
    return [first, cross(n, first)];
}

// Turns `a` about the unit vector `axis` by `angle`, in radians: Rodrigues' formula.
export function turn(a, axis, angle) {
    const c = Math.cos(angle), s = Math.sin(angle);
    return addScaled(addScaled(scale(a, c), s, cross(axis, a)), (1 - c) * dot(axis, a), axis);
}
