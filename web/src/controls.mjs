// Controls of the panel. Each is an element with a `refresh` that shows the document's value anew. `set` gets a value and whether it is
// final, as after a drag.
export function element(tag, attributes = {}, ...children) {
    const result = document.createElement(tag);
    for (const [key, value] of Object.entries(attributes)) {
        if (key.startsWith('on')) result.addEventListener(key.slice(2), value);
        else if (value === true) result.setAttribute(key, '');
        else if (value !== false && value !== undefined) result.setAttribute(key, value);
    }
    result.append(...children);
    return result;
}

export const at = (id) => document.getElementById(id);

export const button = (label, onclick, attributes = {}) => element('button', { type: 'button', onclick, ...attributes }, label);

const row = (id, label, ...children) => element('div', { class: 'row' }, element('label', { for: id }, label), ...children);

// A slider on a logarithmic scale, if `min` is more than 0 and `log` is set, and the number with its unit. The number may be beyond the
// slider's ends.
export function slider({ id, label, unit = '', min, max, log = false, get, set }) {
    const steps = 1000;
    const at = (value) => Math.round(steps * (log ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min)));
    const value = (place) => Number((log ? min * (max / min) ** (place / steps) : min + ((max - min) * place) / steps).toPrecision(3));
    const range = element('input', { type: 'range', id, min: 0, max: steps, step: 1 });
    const number = element('input', { type: 'number', id: `${id}-number`, step: 'any', 'aria-label': `${label}, a number`, class: 'number' });
    const refresh = () => {
        const now = get();
        if (document.activeElement !== number) number.value = Number(now.toPrecision(4));
        range.value = Math.min(Math.max(at(Math.max(now, log ? min : -Infinity)), 0), steps);
        range.setAttribute('aria-valuetext', `${Number(now.toPrecision(3))} ${unit}`);
    };
    range.addEventListener('input', () => set(value(range.valueAsNumber), false));
    range.addEventListener('change', () => set(value(range.valueAsNumber), true));
    number.addEventListener('change', () => {
        if (Number.isFinite(number.valueAsNumber)) set(number.valueAsNumber, true);
        number.value = Number(get().toPrecision(4));
    });
    return { element: row(id, label, range, number, element('span', { class: 'unit' }, unit)), refresh };
}

export function select({ id, label, options, get, set }) {
    const input = element('select', { id }, ...options.map(([value, text]) => element('option', { value }, text)));
    input.addEventListener('change', () => set(input.value, true));
    return { element: row(id, label, input), refresh: () => (input.value = get()) };
}

export function checkbox({ id, label, get, set }) {
    const input = element('input', { type: 'checkbox', id });
    input.addEventListener('change', () => set(input.checked, true));
    return { element: row(id, label, input), refresh: () => (input.checked = get()) };
}

export function text({ id, label, placeholder, get, set }) {
    const input = element('input', { type: 'text', id, placeholder, maxlength: 80, spellcheck: 'false' });
    input.addEventListener('change', () => set(input.value, true));
    return { element: row(id, label, input), refresh: () => document.activeElement === input || (input.value = get()) };
}

export function vector({ id, label, get, set }) {
    const inputs = ['x', 'y', 'z'].map((axis, i) => {
        const input = element('input', { type: 'number', step: 'any', id: i === 0 ? id : `${id}-${axis}`, 'aria-label': `${label} ${axis}` });
        input.addEventListener('change', () => {
            if (!Number.isFinite(input.valueAsNumber)) return;
            set(get().map((x, j) => (j === i ? input.valueAsNumber : x)), true);
        });
        return input;
    });
    const refresh = () => inputs.forEach((input, i) => {
        input.placeholder = 'xyz'[i];
        if (document.activeElement !== input) input.value = Number(get()[i].toPrecision(5));
    });
    return { element: row(id, label, element('div', { class: 'vector' }, ...inputs)), refresh };
}

const encode = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
const decode = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

// A linear colour as browsers write it, in sRGB; what is brighter than white is cut.
export const hexOf = (color) => `#${color.map((x) => Math.round(255 * encode(Math.min(x, 1))).toString(16).padStart(2, '0')).join('')}`;

// A colour as browsers choose it, in sRGB up to white. What is brighter, in linear RGB, keeps its largest component.
export function color({ id, label, get, set }) {
    const input = element('input', { type: 'color', id });
    const scaleOf = () => Math.max(1, ...get());
    const chosen = () => [1, 3, 5].map((i) => Number((scaleOf() * decode(parseInt(input.value.slice(i, i + 2), 16) / 255)).toPrecision(4)));
    input.addEventListener('input', () => set(chosen(), false));
    input.addEventListener('change', () => set(chosen(), true));
    const refresh = () => {
        if (document.activeElement !== input) input.value = hexOf(get().map((x) => x / scaleOf()));
    };
    return { element: row(id, label, input), refresh };
}
