// What the page's modules share: the document and what is chosen in it, the camera, the engine that draws, and what happens to them.
import { Camera } from './camera.mjs';
import { History } from './history.mjs';
import { say } from './message.mjs';
import * as scenes from './scene.mjs';

// Whether the engine takes the document; says where it is wrong.
function accepts(changed) {
    try {
        app.engine.showFile(scenes.shownText(changed, app.camera.place));
        return true;
    } catch (error) {
        say(error.message);
        return false;
    }
}

const listeners = { change: [], scene: [], move: [] };

export const app = {
    engine: undefined, // of engine.mjs, once it has started
    view: undefined, // of view.mjs, likewise
    overlay: undefined,
    camera: new Camera({ eye: [4, 3.4, 16], target: [0.9, 2.75, 0] }),
    history: new History({ scene: { camera: { eye: [0, 0, 1], target: [0, 0, 0] } }, hidden: [] }, accepts),
    selection: undefined,
    selectedPoint: undefined,
    axis: 'view',
    pulse: (frame, count) => app.engine.pulse(frame, count),

    // `change`: something that the page shows is another; `scene`: so is all of it; `move`: the camera is elsewhere.
    on: (event, listener) => listeners[event].push(listener),
    tell: (event) => listeners[event].forEach((listener) => listener()),

    select(key, point) {
        app.selection = key;
        app.selectedPoint = point;
        app.tell('change');
    },
    selectPoint(point) {
        app.selectedPoint = point;
        app.overlay.draw();
    },
    toggleHidden(key) {
        const { hidden } = app.history.current;
        app.history.commit(scenes.withHidden(app.history.current, hidden.includes(key) ? hidden.filter((other) => other !== key) : [...hidden, key]));
    },
    // Has the engine draw the document, after it may have been shown something else.
    sendDocument: () => accepts(app.history.current),
};

app.history.onChange(() => {
    if (!scenes.partOf(app.history.current, app.selection)) app.selection = undefined;
    app.tell('change');
});
