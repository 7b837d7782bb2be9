// The picture as one takes hold of it: pointers, flying keys, dropped files, and the handles over it.
import { app } from './app.mjs';
import { at } from './controls.mjs';
import { court } from './court.mjs';
import { editMoment, openFile, openLink } from './opening.mjs';
import { Overlay } from './overlay.mjs';
import { pick } from './pick.mjs';
import { HeldKeys, watchPointers } from './pointer.mjs';

let held;

// Flies or turns for as long as `seconds` by the keys that are held; returns whether the camera moved.
export function moveByKeys(seconds) {
    const moves = held.move(app.camera, seconds);
    if (moves) app.tell('move');
    return moves;
}

function click(x, y) {
    const stage = at('stage'), { clientWidth: width, clientHeight: height } = stage;
    court.takeCamera();
    if (court.isShown) court.hasOwnCamera = true;
    editMoment();
    app.engine.setCamera(app.camera);
    app.select(pick(app.history.current, app.engine, x, y, width, height));
}

function watchDrops() {
    addEventListener('dragover', (event) => {
        event.preventDefault();
        document.body.classList.add('drop');
    });
    addEventListener('dragleave', (event) => event.relatedTarget ?? document.body.classList.remove('drop'));
    addEventListener('drop', (event) => {
        event.preventDefault();
        document.body.classList.remove('drop');
        if (event.dataTransfer.files[0]) openFile(event.dataTransfer.files[0]);
    });
}

export function buildStage() {
    const stage = at('stage');
    const move = (method) => (...amounts) => {
        court.takeCamera();
        app.camera[method](...amounts);
        app.tell('move');
    };
    app.overlay = new Overlay(at('overlay'), app);
    watchPointers(stage, { orbit: move('orbit'), look: move('look'), pan: move('pan'), zoom: move('zoom'), click });
    held = new HeldKeys(stage, () => {
        court.takeCamera();
        app.tell('move');
    });
    watchDrops();
    addEventListener('hashchange', openLink);
    new ResizeObserver(() => app.overlay.draw()).observe(stage);
    const draw = () => {
        app.overlay.draw();
        app.view?.wake();
    };
    app.on('change', draw);
    app.on('move', draw);
    app.on('move', () => (at('hint').hidden = true));
}
