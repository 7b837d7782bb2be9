// The document: a scene as its file has it, and which parts of it the page hides. Every function returns a new one.
// A part is a source, an opaque shape or a medium; its key is its list and its index, such as "paths/2".
import { isSource, kinds } from './kinds.mjs';

export const lists = Object.keys(kinds);

export const keyOf = (list, index) => `${list}/${index}`;

export function partOf(document, key) {
    if (!key) return undefined;
    const [list, index] = key.split('/');
    return document.scene[list]?.[Number(index)];
}

export const listOf = (key) => key.split('/')[0];

export const keysOf = (document) =>
    lists.flatMap((list) => (document.scene[list] ?? []).map((_, index) => keyOf(list, index)));

export const nameOf = (document, key) => {
    const [list, index] = key.split('/');
    return partOf(document, key)?.name || `${kinds[list].label} ${Number(index) + 1}`;
};

// The colour of a source, which may be the scene's, and the one of a part; a medium's is the light that comes to it.
export const sourceColor = (scene, source) => source.color ?? scene.color ?? [0.2, 0.5, 1];
export function colorOf(document, key) {
    const part = partOf(document, key);
    if (listOf(key) === 'media') return part.ambient ?? [1, 1, 1];
    return isSource(listOf(key)) ? sourceColor(document.scene, part) : part.color ?? [0.8, 0.8, 0.8];
}

// With `change` made to a copy of the scene.
export function withScene(document, change) {
    const scene = structuredClone(document.scene);
    change(scene);
    return { ...document, scene };
}

export function withPart(document, key, change) {
    const [list, index] = key.split('/');
    return withScene(document, (scene) => change(scene[list][Number(index)]));
}

// Returns the document and the key of what was added.
export function withAdded(document, list, part) {
    const added = withScene(document, (scene) => (scene[list] ??= []).push(part));
    return [added, keyOf(list, added.scene[list].length - 1)];
}

export function withoutPart(document, key) {
    const [list, text] = key.split('/');
    const removed = Number(text);
    const without = withScene(document, (scene) => {
        scene[list].splice(removed, 1);
        if (scene[list].length === 0) delete scene[list];
    });
    const hidden = document.hidden.filter((other) => other !== key).map((other) => {
        const [otherList, index] = other.split('/');
        return otherList === list && Number(index) > removed ? keyOf(list, Number(index) - 1) : other;
    });
    return { ...without, hidden };
}

export const withHidden = (document, hidden) => ({ ...document, hidden });

// The text of the file, with the camera as seen.
export function fileText(document, camera) {
    return `${JSON.stringify({ ...document.scene, camera: { ...document.scene.camera, ...camera } }, null, 1)}\n`;
}

// The text of what the page shows: without what is hidden.
export function shownText(document, camera) {
    const hidden = new Set(document.hidden);
    const scene = { ...document.scene, camera: { ...document.scene.camera, ...camera } };
    if (hidden.size > 0)
        for (const list of lists)
            if (scene[list]) scene[list] = scene[list].filter((_, index) => !hidden.has(keyOf(list, index)));
    return JSON.stringify(scene);
}
