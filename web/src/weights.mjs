// Weights as a curve that one drags: control values along the path, from its start on the left to its end on the right.
import { button, element, slider } from './controls.mjs';

const xmlns = 'http://www.w3.org/2000/svg';
const width = 260, height = 90, margin = 8;
const most = 2; // the weight at the top

const xAt = (i, count) => margin + ((width - 2 * margin) * (count > 1 ? i / (count - 1) : 0.5));
const yAt = (weight) => height - margin - (height - 2 * margin) * Math.min(weight / most, 1);

// `pulse(frame, count)` returns the weights of a pulse.
export function weightsEditor({ get, set, pulse }) {
    const svg = document.createElementNS(xmlns, 'svg');
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    svg.setAttribute('class', 'weights');
    const line = svg.appendChild(document.createElementNS(xmlns, 'polyline'));
    let frame = 0;
    const put = (i, weight, isFinal) =>
        set(get().map((old, j) => (j === i ? Number(Math.min(Math.max(weight, 0), most).toFixed(3)) : old)), isFinal);
    const knobs = get().map((_, i) => {
        const knob = svg.appendChild(document.createElementNS(xmlns, 'circle'));
        knob.setAttribute('r', 5);
        knob.setAttribute('tabindex', 0);
        knob.setAttribute('role', 'slider');
        knob.setAttribute('aria-label', `weight ${i + 1} of ${get().length}`);
        knob.setAttribute('aria-valuemin', 0);
        knob.setAttribute('aria-valuemax', most);
        const toWeight = (event) => {
            const box = svg.getBoundingClientRect();
            return (most * (height - margin - ((event.clientY - box.top) * height) / box.height)) / (height - 2 * margin);
        };
        knob.addEventListener('pointerdown', (event) => {
            event.preventDefault();
            knob.focus();
            knob.setPointerCapture(event.pointerId);
            knob.onpointermove = (moved) => put(i, toWeight(moved), false);
            knob.onpointerup = (ended) => {
                knob.onpointermove = knob.onpointerup = null;
                put(i, toWeight(ended), true);
            };
        });
        knob.addEventListener('keydown', (event) => {
            const change = { ArrowUp: 0.05, ArrowRight: 0.05, ArrowDown: -0.05, ArrowLeft: -0.05 }[event.key];
            if (!change) return;
            event.preventDefault();
            event.stopPropagation();
            put(i, get()[i] + change, true);
        });
        return knob;
    });
    const pulseSlider = slider({
        id: 'pulse', label: 'Pulse at frame', min: 0, max: 50 + 7 * Math.max(get().length - 1, 1), get: () => frame,
        set(value, isFinal) {
            frame = value;
            set(pulse(value, Math.max(get().length, 3)).map((weight) => Number(weight.toPrecision(6))), isFinal);
        } });
    const refresh = () => {
        const weights = get();
        line.setAttribute('points', weights.map((weight, i) => `${xAt(i, weights.length)},${yAt(weight)}`).join(' '));
        knobs.forEach((knob, i) => {
            knob.setAttribute('cx', xAt(i, weights.length));
            knob.setAttribute('cy', yAt(weights[i]));
            knob.setAttribute('aria-valuenow', weights[i]);
        });
        pulseSlider.refresh();
    };
    const resampled = (count) => Array.from({ length: count }, (_, i) => {
        const at = (i / Math.max(count - 1, 1)) * (get().length - 1), low = Math.floor(at), high = Math.min(low + 1, get().length - 1);
        return Number((get()[low] + (at - low) * (get()[high] - get()[low])).toFixed(3));
    });
    const tools = element('div', { class: 'buttons' },
        button('Fewer', () => get().length > 2 && set(resampled(get().length - 1), true), { title: 'One weight fewer' }),
        button('More', () => get().length < 64 && set(resampled(get().length + 1), true), { title: 'One weight more' }),
        button('Fade', () => set(get().map((_, i) => Number((1 - i / Math.max(get().length - 1, 1)).toFixed(3))), true), { title: 'From 1 to 0' }),
        button('Swell', () => set(get().map((_, i) => Number(Math.sin((Math.PI * i) / Math.max(get().length - 1, 1)).toFixed(3))), true), { title: 'Bright in the middle' }),
        button('Even', () => set(undefined, true), { title: 'Without weights' }));
    return { element: element('div', { class: 'weights-editor' }, svg, tools, pulseSlider.element), refresh };
}
