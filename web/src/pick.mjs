// What is under the pointer, and where a part is.
import { kinds } from './kinds.mjs';
import { keyOf, listOf } from './scene.mjs';
import { add, length, subtract } from './vector.mjs';

const clickWidth = 4; // pixels around the pointer, so that one need not hit thin cores exactly

// Returns the key of what is seen at a pixel, or undefined. The engine numbers the parts without those that are hidden.
export function pick(document, engine, x, y, width, height) {
    const key = engine.pick((2 * x) / width - 1, 1 - (2 * y) / height, width / height, (2 * clickWidth) / height);
    if (!key) return undefined;
    const list = listOf(key), hidden = new Set(document.hidden);
    const shown = document.scene[list].map((_, index) => keyOf(list, index)).filter((other) => !hidden.has(other));
    return shown[Number(key.split('/')[1])];
}

// The middle of a part, and how far it extends from there.
export function extentOf(document, key) {
    const [list, index] = key.split('/');
    const part = document.scene[list][index];
    const places = list === 'lines' ? [part.position] : kinds[list].lines(part).flat();
    const middle = places.reduce((sum, place) => add(sum, place), [0, 0, 0]).map((x) => x / places.length);
    return { middle, radius: Math.max(...places.map((place) => length(subtract(place, middle)))) + (part.reach ?? 0) };
}
