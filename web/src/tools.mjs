// The panel beside the picture: its buttons, and what they show.
import { actions, addPart } from './actions.mjs';
import { app } from './app.mjs';
import { at, button } from './controls.mjs';
import { court } from './court.mjs';
import { buildHow } from './drawing.mjs';
import { additions } from './kinds.mjs';
import { PartList } from './list.mjs';
import { lookControls } from './look.mjs';
import { say } from './message.mjs';
import { editMoment, startFrom } from './opening.mjs';
import { Panel } from './panel.mjs';
import * as scenes from './scene.mjs';
import { starts } from './starts.mjs';
import { copyC, copyLink, savePng } from './taking.mjs';

let panel, partList, looks = [];

function buildLook() {
    looks = court.isShown ? [] : lookControls(app);
    at('look').replaceChildren(...looks.map((control) => control.element));
}

function refresh() {
    const { history, selection } = app, hasPart = Boolean(selection), isCourt = court.isShown;
    at('court-tools').hidden = !isCourt;
    at('play').textContent = court.isPlaying ? 'Pause' : 'Play';
    at('play').setAttribute('aria-pressed', String(court.isPlaying));
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
    for (const control of looks) control.refresh();
}

function wireButtons() {
    const clicks = { play: actions.play, 'edit-moment': editMoment, undo: actions.undo, redo: actions.redo, open: actions.open, save: actions.save,
        focus: actions.focus, duplicate: actions.duplicate, solo: actions.solo, delete: actions.remove, help: actions.help, png: savePng,
        'close-message': () => say(''), 'copy-c': copyC, 'copy-link': copyLink };
    for (const [id, action] of Object.entries(clicks)) at(id).addEventListener('click', () => action());
    at('add').append(...Object.entries(additions).map(([name, { label }]) =>
        button(`+ ${label}`, () => addPart(name), { id: `add-${name}`, 'aria-label': `Add: ${label}` })));
}

export function buildTools() {
    panel = new Panel(at('controls'), app);
    partList = new PartList(at('parts'), at('no-parts'), app);
    at('start').append(new Option('your own scene', ''), ...starts.map(([value, label]) => new Option(label, value)));
    at('start').options[0].hidden = true;
    at('start').addEventListener('change', () => startFrom(at('start').value));
    at('axis').addEventListener('change', () => (app.axis = at('axis').value === 'view' ? 'view' : Number(at('axis').value)));
    wireButtons();
    buildHow();
    app.on('scene', buildLook);
    app.on('change', refresh);
}
