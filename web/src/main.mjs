// Puts the page together: the document, the camera, the engine, and what the user does to them.
import { Camera } from './camera.mjs';
import { button } from './controls.mjs';
import { cCode } from './c_code.mjs';
import { createEngine, whatIsMissing } from './engine.mjs';
import { chooseFile, download, textOfFile } from './files.mjs';
import { History } from './history.mjs';
import { listKeys, shortcuts, watchKeys } from './keys.mjs';
import { additions, isSource, kinds } from './kinds.mjs';
import { linkOf, textOfLink } from './link.mjs';
import { PartList } from './list.mjs';
import { howControls, lookControls } from './look.mjs';
import { Overlay } from './overlay.mjs';
import { Panel } from './panel.mjs';
import { extentOf, pick } from './pick.mjs';
import { HeldKeys, watchPointers } from './pointer.mjs';
import * as scenes from './scene.mjs';
import { sceneOfCourt, starts, startScene } from './starts.mjs';
import { forget, restore, store } from './storage.mjs';
import { View } from './view.mjs';

const at = (id) => document.getElementById(id);
const stage = at('stage');
const how = { integrator: 'adaptive', quality: 1, divisions: 64, split: false, map: 0 };
const courtBegins = 3.4; // seconds: when much is going on

let engine, view, overlay, panel, partList, lookList = [], howList = [];
let seconds = courtBegins, isPlaying = true, isCourt = true, hasOwnCamera = false, lastFrame = 0;

function say(text, isGood = false) {
    at('message-text').textContent = text;
    at('message').classList.toggle('good', isGood);
    at('message').hidden = !text;
}

// ---- The document ---------------------------------------------------------------------------------------------------------

// Whether the engine takes the document; says where it is wrong.
function accepts(changed) {
    try {
        engine.showFile(scenes.shownText(changed, app.camera.place));
        return true;
    } catch (error) {
        say(error.message);
        return false;
    }
}

const app = {
    camera: new Camera({ eye: [4, 3.4, 16], target: [0.9, 2.75, 0] }),
    history: new History({ scene: { camera: { eye: [0, 0, 1], target: [0, 0, 0] } }, hidden: [] }, accepts),
    selection: undefined,
    selectedPoint: undefined,
    axis: 'view',
    pulse: (frame, count) => engine.pulse(frame, count),
    select(key, point) {
        app.selection = key;
        app.selectedPoint = point;
        refresh();
    },
    selectPoint(point) {
        app.selectedPoint = point;
        overlay.draw();
    },
    toggleHidden(key) {
        const { hidden } = app.history.current;
        app.history.commit(scenes.withHidden(app.history.current, hidden.includes(key) ? hidden.filter((other) => other !== key) : [...hidden, key]));
    },
};
app.history.onChange(() => {
    if (!scenes.partOf(app.history.current, app.selection)) app.selection = undefined;
    refresh();
    keep();
});

let keepTimer;
// Stores the document, once it has been still for a moment.
function keep() {
    clearTimeout(keepTimer);
    keepTimer = setTimeout(() => {
        if (!isCourt) store(app.history.current, app.camera.place);
    }, 300);
}
addEventListener('pagehide', () => !isCourt && store(app.history.current, app.camera.place));

// Shows another scene; throws, and changes nothing, where it is wrong. Undo brings the last one back.
function show(scene, hidden = [], camera = undefined) {
    const next = { scene: structuredClone(scene), hidden };
    engine.showFile(scenes.shownText(next, camera));
    app.camera.set({ ...scene.camera, ...camera });
    app.selection = app.selectedPoint = undefined;
    isCourt = false;
    app.history.commit(next);
    buildLook();
    refresh();
    say('');
}

function showText(text, name) {
    try {
        engine.showFile(text); // the parser of ew-render says what is wrong, and where
        show(JSON.parse(text.replace(/^\uFEFF/, '')));
    } catch (error) {
        resend();
        throw new Error(error.message.replace(/^scene: /, `${name}: `));
    }
}

// Tells the engine what is shown, after it may have been shown something else.
function resend() {
    if (isCourt) engine.showCourt(seconds);
    else accepts(app.history.current);
    view?.wake();
}

function editMoment() {
    if (!isCourt) return;
    engine.showCourt(seconds);
    if (hasOwnCamera) engine.setCamera(app.camera);
    show(sceneOfCourt(engine.write()));
    stage.focus({ preventScroll: true });
}

function showCourt() {
    isCourt = true;
    hasOwnCamera = false;
    isPlaying = true;
    app.selection = undefined;
    forget();
    refresh();
}

// ---- Drawing --------------------------------------------------------------------------------------------------------------

let held, hasPicture = false;

// Called before each frame: tells the engine what to draw. Returns whether it moves by itself.
function sync(now) {
    const elapsed = Math.min((now - lastFrame) / 1000, 0.2);
    lastFrame = now;
    const flies = held.move(app.camera, elapsed);
    if (flies) moved();
    if (isCourt) {
        if (isPlaying) seconds += elapsed;
        engine.showCourt(seconds);
        if (hasOwnCamera) engine.setCamera(app.camera);
    } else engine.setCamera(app.camera);
    return flies || (isCourt && isPlaying);
}

const report = {
    progress(share) {
        at('loading').hidden = false;
        at('loading').classList.toggle('again', hasPicture);
        at('loading-text').textContent = 'Compiling shaders';
        at('progress').value = share;
        stage.setAttribute('aria-busy', 'true');
    },
    drawn(rests) {
        hasPicture = true;
        at('loading').hidden = true;
        stage.setAttribute('aria-busy', String(!rests));
        at('map-text').textContent = mapText();
    },
    failed(error) {
        at('loading').hidden = true;
        stage.setAttribute('aria-busy', 'false');
        say(error.message);
    },
};

function mapText() {
    if (how.map === 0) return '';
    const texts = (how.split ? [0, 1] : [0]).map((half) => {
        const [mean, largest, most] = [0, 1, 2].map((which) => engine.statistic(half, which));
        return how.map === 1 ? `${mean.toFixed(1)} evaluations a pixel` : `largest error ${largest.toExponential(1)}, 99 % within ${most.toExponential(1)}`;
    });
    return `${texts.join(' | ')} (black: ${how.map === 1 ? 'none' : '1e-6'}, pale yellow: ${how.map === 1 ? '4096' : '0.1'})`;
}

function sendHow() {
    const left = { integrator: how.split || how.integrator === 'adaptive' ? 0 : 1, quality: how.quality, divisions: how.divisions };
    engine.setIntegrator(false, left);
    engine.setIntegrator(true, { ...left, integrator: 1 });
    engine.setView(how.map, how.split);
    at('split-line').hidden = !how.split;
    for (const control of howList) control.refresh();
    view?.wake();
}

// After the camera moved.
function moved() {
    if (isCourt) hasOwnCamera = true;
    at('hint').hidden = true;
    overlay.draw();
    view.wake();
    keep();
}

// Takes the moving court's camera over, before the user moves it.
function takeCamera() {
    if (!isCourt || hasOwnCamera) return;
    engine.showCourt(seconds);
    app.camera.set(JSON.parse(engine.write()).camera);
}

// ---- The panel ------------------------------------------------------------------------------------------------------------

function buildLook() {
    lookList = isCourt ? [] : lookControls(app);
    at('look').replaceChildren(...lookList.map((control) => control.element));
}

function refresh() {
    const { history, selection } = app, hasPart = Boolean(selection);
    at('court-tools').hidden = !isCourt;
    at('play').textContent = isPlaying ? 'Pause' : 'Play';
    at('play').setAttribute('aria-pressed', String(isPlaying));
    at('look-section').hidden = isCourt;
    at('undo').disabled = isCourt || !history.canUndo;
    at('redo').disabled = isCourt || !history.canRedo;
    at('selected').hidden = !hasPart;
    if (hasPart) at('selected-title').textContent = scenes.nameOf(history.current, selection);
    at('parts').hidden = isCourt;
    at('start').value = isCourt ? 'court' : '';
    if (!isCourt) partList.draw();
    else at('no-parts').hidden = true;
    panel.draw();
    overlay.draw();
    for (const control of lookList) control.refresh();
    view?.wake();
}

// Where a new part goes, the middle of what the camera looks at, and how large it is.
function newPlace() {
    const size = 0.12 * app.camera.distance;
    return { place: app.camera.target.map((x) => Number(x.toPrecision(6))), size: Number(size.toPrecision(2)), right: app.camera.axes.right };
}

function addPart(name) {
    editMoment();
    const { list, create } = additions[name], { place, size, right } = newPlace();
    const [changed, key] = scenes.withAdded(app.history.current, list, create(place, size, right, scenes.partOf(app.history.current, app.selection)));
    if (app.history.commit(changed)) app.select(key);
}

const actions = {
    axis(key) {
        app.axis = key === 'v' ? 'view' : 'xyz'.indexOf(key);
        at('axis').value = app.axis;
    },
    deselect: () => app.select(undefined),
    focus() {
        if (!app.selection) return;
        const { middle, radius } = extentOf(app.history.current, app.selection);
        app.camera.focus(middle, radius);
        moved();
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
        if (!app.selection || isCourt) return;
        const key = app.selection;
        app.selection = undefined;
        app.history.commit(scenes.withoutPart(app.history.current, key));
    },
    undo: () => !isCourt && app.history.undo(),
    redo: () => !isCourt && app.history.redo(),
    open: () => chooseFile('.json,application/json', openFile),
    save() {
        editMoment();
        download(new Blob([scenes.fileText(app.history.current, app.camera.place)], { type: 'application/json' }), 'scene.json');
        const { hidden } = app.history.current;
        say(hidden.length ? `Saved. What is hidden here (${hidden.length}) is in the file, and shows there.` : 'Saved.', true);
    },
    split() {
        how.split = !how.split;
        sendHow();
    },
    map() {
        how.map = (how.map + 1) % 3;
        sendHow();
    },
    play() {
        isPlaying = !isPlaying;
        refresh();
    },
    help: () => at('keys').showModal(),
};

async function openFile(file) {
    try {
        showText(await textOfFile(file), file.name);
    } catch (error) {
        say(error.message);
    }
}

async function startFrom(name) {
    try {
        if (name === 'court') showCourt();
        else {
            engine.showCourt(0);
            const scene = await startScene(name, engine.write());
            show(scene);
        }
    } catch (error) {
        resend();
        say(error.message);
    }
    at('start').value = isCourt ? 'court' : '';
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

async function savePng() {
    try {
        const [width, height] = ['png-width', 'png-height'].map((id) => at(id).valueAsNumber);
        if (![width, height].every((side) => Number.isInteger(side) && side >= 1 && side <= 8192))
            throw new Error('The sides of a PNG are from 1 to 8192 pixels.');
        while (engine.prepare(width, height) > 0) await new Promise((resolve) => setTimeout(resolve));
        sync(lastFrame);
        engine.draw(width, height);
        const canvas = Object.assign(document.createElement('canvas'), { width, height });
        canvas.getContext('2d').putImageData(engine.read(width, height), 0, 0);
        download(await new Promise((resolve) => canvas.toBlob(resolve, 'image/png')), 'energywave.png');
    } catch (error) {
        say(error.message);
    }
    view.wake();
}

function wirePanel() {
    at('start').append(new Option('your own scene', ''), ...starts.map(([value, label]) => new Option(label, value)));
    at('start').options[0].hidden = true;
    at('start').addEventListener('change', () => startFrom(at('start').value));
    at('add').append(...Object.entries(additions).map(([name, { label }]) =>
        button(`+ ${label}`, () => addPart(name), { id: `add-${name}`, 'aria-label': `Add: ${label}` })));
    const clicks = { play: actions.play, 'edit-moment': editMoment, undo: actions.undo, redo: actions.redo, open: actions.open, save: actions.save,
        focus: actions.focus, duplicate: actions.duplicate, solo: actions.solo, delete: actions.remove, help: actions.help, png: savePng,
        'close-message': () => say(''),
        'copy-c': () => { editMoment(); copy(cCode(app.history.current.scene), 'The C code'); },
        'copy-link': async () => {
            editMoment();
            try {
                await copy(await linkOf(scenes.fileText(app.history.current, app.camera.place), location.href), 'The link');
            } catch (error) {
                say(error.message);
            }
        } };
    for (const [id, action] of Object.entries(clicks)) at(id).addEventListener('click', () => action());
    at('axis').addEventListener('change', () => (app.axis = at('axis').value === 'view' ? 'view' : Number(at('axis').value)));
    howList = howControls(how, sendHow);
    at('how').replaceChildren(...howList.map((control) => control.element));
}

function wireStage() {
    const move = (method) => (...amounts) => {
        takeCamera();
        app.camera[method](...amounts);
        moved();
    };
    watchPointers(stage, { orbit: move('orbit'), look: move('look'), pan: move('pan'), zoom: move('zoom'), click(x, y) {
        takeCamera();
        if (isCourt) hasOwnCamera = true;
        editMoment();
        const { clientWidth: width, clientHeight: height } = stage;
        app.select(pick(app.history.current, app.camera.ray(x, y, width, height), app.camera.unitsPerPixel(1, height)));
    } });
    held = new HeldKeys(stage, () => {
        takeCamera();
        moved();
    });
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
    addEventListener('hashchange', openLink);
    new ResizeObserver(() => overlay.draw()).observe(stage);
}

// ---- Beginning ------------------------------------------------------------------------------------------------------------

// Returns whether the address held a scene, right or wrong.
async function openLink() {
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

// The engine, on a canvas of its own. A lost context is replaced, canvas and all.
async function startEngine() {
    const canvas = document.createElement('canvas');
    canvas.setAttribute('aria-hidden', 'true');
    at('canvas').replaceWith(canvas);
    canvas.id = 'canvas';
    engine = await createEngine(canvas);
    at('renderer').textContent = engine.renderer();
    canvas.addEventListener('webglcontextlost', async (event) => {
        event.preventDefault();
        view.stop();
        at('loading').hidden = false;
        at('loading-text').textContent = 'The GPU was reset. Starting again';
        setTimeout(begin, 200);
    });
    view = new View(canvas, stage, engine, sync, report);
}

async function begin() {
    try {
        await startEngine();
        resend();
        sendHow();
    } catch (error) {
        at('progress').hidden = true;
        at('loading-text').textContent = `The picture cannot be drawn: ${error.message}`;
    }
}

// What was stored may be of another version, or broken; then the court is shown.
function restoreLast() {
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

async function main() {
    const missing = whatIsMissing();
    if (missing) {
        at('progress').hidden = true;
        at('loading-text').textContent = missing;
        return;
    }
    overlay = new Overlay(at('overlay'), app);
    panel = new Panel(at('controls'), app);
    partList = new PartList(at('parts'), at('no-parts'), app);
    const rows = shortcuts(actions);
    wirePanel();
    wireStage();
    listKeys(at('keys-table'), rows);
    watchKeys(rows);
    await begin();
    if (!(await openLink())) restoreLast();
    refresh();
}

main();
