// What is under the pointer: the source whose light there is largest, or else the nearest opaque shape.
import { kinds, isSource } from './kinds.mjs';
import { keyOf, lists, sourceColor } from './scene.mjs';
import { add, addScaled, dot, length, normalize, subtract } from './vector.mjs';

// Less light than this, relative to what is shown as white, is not what somebody clicks on.
const leastLight = 0.02;

// The least distance between the ray and a segment from a to b, and how far along the unit ray that is.
function distanceToSegment(origin, ray, a, b) {
    const way = subtract(b, a), from = subtract(a, origin);
    const along = dot(way, ray), squared = dot(way, way) - along * along;
    const t = squared > 1e-12 * dot(way, way) ? Math.min(Math.max((along * dot(from, ray) - dot(from, way)) / squared, 0), 1) : 0;
    const place = addScaled(a, t, way), depth = Math.max(dot(subtract(place, origin), ray), 0);
    return { distance: length(subtract(place, addScaled(origin, depth, ray))), depth };
}

// The luminance of a long straight beam at that distance from the ray, with its sharpness; the papers' has no end.
function lightAt(source, scene, distance) {
    const core = source.core ?? scene.epsilon ?? 1e-3;
    const reach = source.reach ?? 1e3 * core;
    const spread = Math.log(reach / core);
    const brightness = source.brightness ?? 2 * (source.coefficient ?? 1) * spread;
    const share = Math.log(reach / Math.min(Math.max(distance, core), reach)) / spread;
    return brightness * Math.max(...sourceColor(scene, source)) * share ** (source.sharpness ?? 1);
}

// The distance along the unit ray at which it meets a shape; infinite where it does not.
const meets = {
    sphere(origin, ray, { center, radius }) {
        const way = subtract(center, origin), along = dot(way, ray);
        const half = radius * radius - dot(way, way) + along * along;
        return half > 0 && along - Math.sqrt(half) > 0 ? along - Math.sqrt(half) : Infinity;
    },
    plane(origin, ray, { point, normal }) {
        const distance = dot(subtract(point, origin), normal) / dot(ray, normal);
        return distance > 0 ? distance : Infinity;
    },
    box(origin, ray, { min, max }) {
        let near = 0, far = Infinity;
        for (let i = 0; i < 3; i++) {
            const ends = [(min[i] - origin[i]) / ray[i], (max[i] - origin[i]) / ray[i]];
            near = Math.max(near, Math.min(...ends));
            far = Math.min(far, Math.max(...ends));
        }
        return near > 0 && near < far ? near : Infinity;
    },
};

// Returns the key of what a pixel's ray meets, or undefined. `unitsPerPixel` at unit depth widens thin cores, so that one need not
// hit them exactly.
export function pick(document, { origin, direction }, unitsPerPixel) {
    const { scene } = document;
    const ray = normalize(direction), hidden = new Set(document.hidden);
    let shape, wall = Infinity;
    (scene.opaque ?? []).forEach((part, index) => {
        const distance = hidden.has(keyOf('opaque', index)) ? Infinity : meets[part.shape](origin, ray, part);
        if (distance < wall) [wall, shape] = [distance, keyOf('opaque', index)];
    });
    let source, most = leastLight;
    for (const list of lists.filter(isSource))
        (scene[list] ?? []).forEach((part, index) => {
            if (hidden.has(keyOf(list, index))) return;
            for (const line of kinds[list].lines(part))
                for (let i = 0; i + 1 < line.length; i++) {
                    const { distance, depth } = distanceToSegment(origin, ray, line[i], line[i + 1]);
                    if (depth <= 0 || depth > wall + (part.core ?? 0)) continue;
                    const light = lightAt(part, scene, Math.max(distance - 4 * unitsPerPixel * depth, 0));
                    if (light > most) [most, source] = [light, keyOf(list, index)];
                }
        });
    return source ?? shape;
}

// The middle of a part, and how far it extends from there.
export function extentOf(document, key) {
    const [list, index] = key.split('/');
    const part = document.scene[list][index];
    const places = list === 'lines' ? [part.position] : kinds[list].lines(part).flat();
    const middle = places.reduce((sum, place) => add(sum, place), [0, 0, 0]).map((x) => x / places.length);
    return { middle, radius: Math.max(...places.map((place) => length(subtract(place, middle)))) + (part.reach ?? 0) };
}
