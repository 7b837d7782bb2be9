// Everything by which the page comes to show another scene: files, links, scenes to start from, what was stored, and the court's moment.
import { app } from './app.mjs';
import { at } from './controls.mjs';
import { court } from './court.mjs';
import { textOfFile } from './files.mjs';
import { textOfLink } from './link.mjs';
import { say } from './message.mjs';
import * as scenes from './scene.mjs';
import { sceneOfCourt, startScene } from './starts.mjs';
import { forget, restore } from './storage.mjs';

// Takes over a document that the engine already draws. Undo brings the last one back.
function adopt(document, camera) {
    app.camera.set({ ...document.scene.camera, ...camera });
    app.selection = app.selectedPoint = undefined;
    court.isShown = false;
    app.history.take(document);
    app.tell('scene');
    app.tell('change');
    say('');
}

// Shows another scene; throws, and changes nothing, where it is wrong.
function show(scene, hidden = [], camera = undefined) {
    const next = { scene: structuredClone(scene), hidden };
    app.engine.showFile(scenes.shownText(next, camera));
    adopt(next, camera);
}

// The parser of ew-render says what is wrong, and where.
function showText(text, name) {
    try {
        app.engine.showFile(text);
        adopt({ scene: JSON.parse(text.replace(/^\uFEFF/, '')), hidden: [] });
    } catch (error) {
        resend();
        throw new Error(error.message.replace(/^scene: /, `${name}: `));
    }
}

// Tells the engine what is shown, after it may have been shown something else.
export function resend() {
    if (court.isShown) app.engine.showCourt(court.seconds);
    else app.sendDocument();
    app.view?.wake();
}

// Makes the court's moment the document, if the court is shown.
export function editMoment() {
    if (!court.isShown) return;
    court.send();
    show(sceneOfCourt(app.engine.write()));
    at('stage').focus({ preventScroll: true });
}

export async function openFile(file) {
    try {
        showText(await textOfFile(file), file.name);
    } catch (error) {
        say(error.message);
    }
}

export async function startFrom(name) {
    try {
        if (name === 'court') {
            forget();
            court.begin();
        } else {
            app.engine.showCourt(0);
            show(await startScene(name, app.engine.write()));
        }
    } catch (error) {
        resend();
        say(error.message);
    }
    at('start').value = court.isShown ? 'court' : '';
}

// Returns whether the address held a scene that is now shown.
export async function openLink() {
    try {
        const text = await textOfLink(location.hash);
        if (text === undefined) return false;
        showText(text, 'link');
    } catch (error) {
        say(error.message);
        return false;
    }
    return true;
}

// What was stored may be of another version, or broken; then the court is shown.
export function restoreLast() {
    const last = restore();
    if (!last) return;
    try {
        const hidden = Array.isArray(last.document.hidden) ? last.document.hidden.filter((key) => typeof key === 'string') : [];
        show(last.document.scene, hidden, last.camera);
    } catch (error) {
        resend();
        say(`What was stored here last could not be shown: ${error.message}`);
    }
}
