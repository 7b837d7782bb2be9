// The mouse, touch and keys that move the camera.
const clickDistance = 5; // pixels that a click may wander

// `act` has orbit, look, pan, zoom and click; the last with a pixel of the stage.
export function watchPointers(stage, act) {
    const pointers = new Map();
    let isClick = false;
    const spread = () => {
        const [a, b] = [...pointers.values()];
        return { distance: Math.hypot(a.x - b.x, a.y - b.y) || 1, x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    };
    stage.addEventListener('pointerdown', (event) => {
        stage.focus({ preventScroll: true });
        stage.setPointerCapture(event.pointerId);
        isClick = pointers.size === 0 && event.button === 0;
        pointers.set(event.pointerId, { x: event.clientX, y: event.clientY, firstX: event.clientX, firstY: event.clientY });
    });
    stage.addEventListener('pointermove', (event) => {
        const pointer = pointers.get(event.pointerId);
        if (!pointer) return;
        const before = pointers.size === 2 ? spread() : undefined;
        const dx = (event.clientX - pointer.x) / stage.clientHeight, dy = (event.clientY - pointer.y) / stage.clientHeight;
        Object.assign(pointer, { x: event.clientX, y: event.clientY });
        if (Math.hypot(pointer.x - pointer.firstX, pointer.y - pointer.firstY) > clickDistance) isClick = false;
        if (isClick) return;
        if (before) {
            const after = spread();
            act.zoom(before.distance / after.distance);
            act.pan((before.x - after.x) / stage.clientHeight, (after.y - before.y) / stage.clientHeight);
        } else if (event.buttons & 2 || event.ctrlKey) act.look(-3 * dx, -3 * dy);
        else if (event.buttons & 4 || event.shiftKey) act.pan(-dx, dy);
        else act.orbit(-5 * dx, -5 * dy);
    });
    const end = (event) => {
        if (!pointers.delete(event.pointerId) || !isClick || event.type !== 'pointerup') return;
        const box = stage.getBoundingClientRect();
        act.click(event.clientX - box.left, event.clientY - box.top);
    };
    stage.addEventListener('pointerup', end);
    stage.addEventListener('pointercancel', end);
    stage.addEventListener('contextmenu', (event) => event.preventDefault());
    stage.addEventListener('wheel', (event) => {
        event.preventDefault();
        act.zoom(Math.exp(Math.max(-1, Math.min(1, event.deltaY / 500))));
    }, { passive: false });
}

const flights = { KeyW: [0, 0, 1], KeyS: [0, 0, -1], KeyA: [-1, 0, 0], KeyD: [1, 0, 0], KeyE: [0, 1, 0], KeyQ: [0, -1, 0] };
const turns = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

// Keys that are held while one flies or turns.
export class HeldKeys {
    #held = new Set();

    constructor(stage, wake) {
        stage.addEventListener('keydown', (event) => {
            if (event.ctrlKey || event.metaKey || event.altKey || !(event.code in flights || event.code in turns) || event.target !== stage) return;
            event.preventDefault();
            this.#held.add(event.code);
            wake();
        });
        stage.addEventListener('keyup', (event) => this.#held.delete(event.code));
        stage.addEventListener('blur', () => this.#held.clear());
    }

    // Moves the camera for as long as `seconds`; returns whether it moved.
    move(camera, seconds) {
        for (const code of this.#held) {
            if (code in flights) camera.pan(...flights[code].map((x) => x * Math.min(seconds, 0.2) * 0.7));
            if (code in turns) camera.look(...turns[code].map((x) => x * Math.min(seconds, 0.2)));
        }
        return this.#held.size > 0;
    }
}
