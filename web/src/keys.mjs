// Keyboard shortcuts, and the page that lists them.
import { element } from './controls.mjs';

// Each row: how it is written, what it does, and, if it is not handled elsewhere, which event is meant and the action.
export function shortcuts(actions) {
    const key = (name) => (event) => !event.ctrlKey && !event.metaKey && !event.altKey && event.key.toLowerCase() === name;
    const control = (name, shift = false) => (event) =>
        (event.ctrlKey || event.metaKey) && event.shiftKey === shift && event.key.toLowerCase() === name;
    return [
        ['Drag', 'look around the middle; with Shift move, with the right button turn the head'],
        ['Wheel, two fingers', 'come closer, go away'],
        ['W A S D, Q E', 'fly; arrow keys turn. The picture must have the focus'],
        ['Click', 'choose what is there'],
        ['Tab, arrow keys', 'on a handle: move it; with Shift finely'],
        ['X Y Z V', 'drag along x, y, z, or in the view plane', (event) => 'xyzv'.includes(event.key.toLowerCase()) && key(event.key.toLowerCase())(event), (event) => actions.axis(event.key.toLowerCase())],
        ['Esc', 'choose nothing', key('escape'), actions.deselect],
        ['F', 'look at what is chosen', key('f'), actions.focus],
        ['N', 'add a point to the chosen path', key('n'), actions.addPoint],
        ['H', 'hide what is chosen, or show it', key('h'), actions.hide],
        ['O', 'solo: hide all other lights', key('o'), actions.solo],
        ['Ctrl+D', 'duplicate', control('d'), actions.duplicate],
        ['Delete', 'delete', (event) => key('delete')(event) || key('backspace')(event), actions.remove],
        ['Ctrl+Z', 'undo', control('z'), actions.undo],
        ['Ctrl+Shift+Z, Ctrl+Y', 'redo', (event) => control('z', true)(event) || control('y')(event), actions.redo],
        ['Ctrl+O', 'open a scene file', control('o'), actions.open],
        ['Ctrl+S', 'save a scene file', control('s'), actions.save],
        ['P', 'split the screen with Simpson', key('p'), actions.split],
        ['M', 'cost map, error map, picture', key('m'), actions.map],
        ['Space', 'pause the court, or go on', key(' '), actions.play],
        ['?', 'this page', key('?'), actions.help],
    ];
}

// Keys belong to a field of text while one writes in it, and some to the control that has the focus.
function isForField(event) {
    const { target } = event;
    if (event.ctrlKey || event.metaKey) return target.matches('input[type=text], input[type=number]') && /^[zy]$/i.test(event.key);
    if (target.matches('input[type=text], input[type=number], select')) return true;
    return event.key === ' ' && target.matches('button, summary, input');
}

export function watchKeys(rows) {
    document.addEventListener('keydown', (event) => {
        if (document.querySelector('dialog[open]') || event.defaultPrevented || isForField(event)) return;
        const row = rows.find(([, , matches]) => matches?.(event));
        if (!row) return;
        event.preventDefault();
        row[3](event);
    });
}

export function listKeys(table, rows) {
    table.replaceChildren(...rows.map(([keys, meaning]) => element('tr', {}, element('td', {}, element('kbd', {}, keys)), element('td', {}, meaning))));
}
