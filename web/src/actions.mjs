// What buttons and keys do to the document, by name.
import { app } from './app.mjs';
import { at } from './controls.mjs';
import { court } from './court.mjs';
import { nextMap, toggleSplit } from './drawing.mjs';
import { chooseFile } from './files.mjs';
import { additions, isSource, kinds } from './kinds.mjs';
import { editMoment, openFile } from './opening.mjs';
import { extentOf } from './pick.mjs';
import * as scenes from './scene.mjs';
import { save } from './taking.mjs';

// Where a new part goes, the middle of what the camera looks at, and how large it is.
function newPlace() {
    const size = 0.12 * app.camera.distance;
    return { place: app.camera.target.map((x) => Number(x.toPrecision(6))), size: Number(size.toPrecision(2)), right: app.camera.axes.right };
}

export function addPart(name) {
    editMoment();
    const { list, create } = additions[name], { place, size, right } = newPlace();
    const [changed, key] = scenes.withAdded(app.history.current, list, create(place, size, right, scenes.partOf(app.history.current, app.selection)));
    if (app.history.commit(changed)) app.select(key);
}

export const actions = {
    axis(key) {
        app.axis = key === 'v' ? 'view' : 'xyz'.indexOf(key);
        at('axis').value = app.axis;
    },
    deselect: () => app.select(undefined),
    focus() {
        if (!app.selection) return;
        const { middle, radius } = extentOf(app.history.current, app.selection);
        app.camera.focus(middle, radius);
        app.tell('move');
    },
    addPoint: () => at('add-point')?.click(),
    hide: () => app.selection && app.toggleHidden(app.selection),
    solo() {
        if (!app.selection) return;
        const others = scenes.keysOf(app.history.current).filter((key) => isSource(scenes.listOf(key)) && key !== app.selection);
        const isSolo = others.length > 0 && others.every((key) => app.history.current.hidden.includes(key));
        app.history.commit(scenes.withHidden(app.history.current, isSolo ? [] : others));
    },
    duplicate() {
        if (!app.selection) return;
        const part = structuredClone(scenes.partOf(app.history.current, app.selection)), list = scenes.listOf(app.selection);
        const way = app.camera.axes.right.map((x) => x * 0.05 * app.camera.distance);
        const handles = kinds[list].handles(part);
        const moving = list === 'paths' || list === 'curves' ? handles : handles.slice(0, 1);
        for (const handle of moving) handle.move(part, handle.position.map((x, i) => x + way[i]));
        if (part.name) part.name += ' copy';
        const [changed, key] = scenes.withAdded(app.history.current, list, part);
        if (app.history.commit(changed)) app.select(key);
    },
    remove() {
        if (!app.selection || court.isShown) return;
        const key = app.selection;
        app.selection = undefined;
        app.history.commit(scenes.withoutPart(app.history.current, key));
    },
    undo: () => !court.isShown && app.history.undo(),
    redo: () => !court.isShown && app.history.redo(),
    open: () => chooseFile('.json,application/json', openFile),
    save,
    split: toggleSplit,
    map: nextMap,
    play() {
        court.isPlaying = !court.isPlaying;
        app.tell('change');
    },
    help: () => at('keys').showModal(),
};
