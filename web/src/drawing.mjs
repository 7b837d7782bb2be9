// The engine at work: what it is told before each frame, how it integrates, and what it reports.
import { app } from './app.mjs';
import { at } from './controls.mjs';
import { court } from './court.mjs';
import { createEngine } from './engine.mjs';
import { howControls } from './look.mjs';
import { say } from './message.mjs';
import { resend } from './opening.mjs';
import { moveByKeys } from './stage.mjs';
import { View } from './view.mjs';

const how = { integrator: 'adaptive', quality: 1, divisions: 64, split: false, map: 0 };
const longestStep = 0.2; // seconds of a frame that count
let controls = [], lastFrame = 0, hasPicture = false;

// Tells the engine what to draw.
export function sendFrame() {
    if (court.isShown) court.send();
    else app.engine.setCamera(app.camera);
}

// Called before each frame. Returns whether the picture moves by itself.
function sync(now) {
    const elapsed = Math.min((now - lastFrame) / 1000, longestStep);
    lastFrame = now;
    const flies = moveByKeys(elapsed), plays = court.isShown && court.isPlaying;
    if (plays) court.seconds += elapsed;
    sendFrame();
    return flies || plays;
}

const report = {
    changes: () => at('stage').setAttribute('aria-busy', 'true'),
    progress(share) {
        at('loading').hidden = false;
        at('loading').classList.toggle('again', hasPicture);
        at('loading-text').textContent = 'Compiling shaders';
        at('progress').value = share;
        at('stage').setAttribute('aria-busy', 'true');
    },
    drawn(rests) {
        hasPicture = true;
        at('loading').hidden = true;
        at('stage').setAttribute('aria-busy', String(!rests));
        at('map-text').textContent = mapText();
    },
    failed(error) {
        at('loading').hidden = true;
        at('stage').setAttribute('aria-busy', 'false');
        say(error.message);
    },
};

function mapText() {
    if (how.map === 0) return '';
    const texts = (how.split ? [0, 1] : [0]).map((half) => {
        const [mean, largest, most] = [0, 1, 2].map((which) => app.engine.statistic(half, which));
        return how.map === 1 ? `${mean.toFixed(1)} evaluations a pixel` : `largest error ${largest.toExponential(1)}, 99 % within ${most.toExponential(1)}`;
    });
    return `${texts.join(' | ')} (black: ${how.map === 1 ? 'none' : '1e-6'}, pale yellow: ${how.map === 1 ? '4096' : '0.1'})`;
}

function sendHow() {
    const { engine } = app;
    const left = { integrator: how.split || how.integrator === 'adaptive' ? 0 : 1, quality: how.quality, divisions: how.divisions };
    engine.setIntegrator(false, left);
    engine.setIntegrator(true, { ...left, integrator: 1 });
    engine.setView(how.map, how.split);
    at('split-line').hidden = !how.split;
    for (const control of controls) control.refresh();
    app.view?.wake();
}

export function toggleSplit() {
    how.split = !how.split;
    sendHow();
}

export function nextMap() {
    how.map = (how.map + 1) % 3;
    sendHow();
}

export function buildHow() {
    controls = howControls(how, sendHow);
    at('how').replaceChildren(...controls.map((control) => control.element));
}

// The engine, on a canvas of its own. A lost context is replaced, canvas and all.
async function startEngine() {
    const canvas = document.createElement('canvas');
    canvas.setAttribute('aria-hidden', 'true');
    at('canvas').replaceWith(canvas);
    canvas.id = 'canvas';
    app.engine = await createEngine(canvas);
    at('renderer').textContent = app.engine.renderer();
    canvas.addEventListener('webglcontextlost', async (event) => {
        event.preventDefault();
        app.view.stop();
        at('loading').hidden = false;
        at('loading-text').textContent = 'The GPU was reset. Starting again';
        setTimeout(beginDrawing, 200);
    });
    app.view = new View(canvas, at('stage'), app.engine, sync, report);
}

export async function beginDrawing() {
    try {
        await startEngine();
        resend();
        sendHow();
    } catch (error) {
        at('progress').hidden = true;
        at('loading-text').textContent = `The picture cannot be drawn: ${error.message}`;
    }
}
