// Everything that one takes along: a scene file, a link, C, and a picture.
import { app } from './app.mjs';
import { cCode } from './c_code.mjs';
import { at } from './controls.mjs';
import { sendFrame } from './drawing.mjs';
import { download } from './files.mjs';
import { linkOf } from './link.mjs';
import { say } from './message.mjs';
import { editMoment } from './opening.mjs';
import * as scenes from './scene.mjs';

const largestSide = 8192; // of a picture, in pixels

const sceneText = () => scenes.fileText(app.history.current, app.camera.place);

export function save() {
    editMoment();
    download(new Blob([sceneText()], { type: 'application/json' }), 'scene.json');
    const { hidden } = app.history.current;
    say(hidden.length ? `Saved. What is hidden here (${hidden.length}) is in the file, and shows there.` : 'Saved.', true);
}

async function copy(text, what) {
    try {
        await navigator.clipboard.writeText(text);
        say(`${what} is on the clipboard.`, true);
    } catch {
        download(new Blob([text], { type: 'text/plain' }), what === 'The C code' ? 'scene.h' : 'link.txt');
        say(`${what} could not go to the clipboard, and was saved as a file instead.`, true);
    }
}

export function copyC() {
    editMoment();
    copy(cCode(app.history.current.scene), 'The C code');
}

export async function copyLink() {
    editMoment();
    try {
        await copy(await linkOf(sceneText(), location.href), 'The link');
    } catch (error) {
        say(error.message);
    }
}

export async function savePng() {
    const { engine } = app;
    try {
        const [width, height] = ['png-width', 'png-height'].map((id) => at(id).valueAsNumber);
        if (![width, height].every((side) => Number.isInteger(side) && side >= 1 && side <= largestSide))
            throw new Error(`The sides of a PNG are from 1 to ${largestSide} pixels.`);
        while (engine.prepare(width, height) > 0) await new Promise((resolve) => setTimeout(resolve));
        sendFrame();
        engine.draw(width, height);
        const canvas = Object.assign(document.createElement('canvas'), { width, height });
        canvas.getContext('2d').putImageData(engine.read(width, height), 0, 0);
        download(await new Promise((resolve) => canvas.toBlob(resolve, 'image/png')), 'energywave.png');
    } catch (error) {
        say(error.message);
    }
    app.view.wake();
}
