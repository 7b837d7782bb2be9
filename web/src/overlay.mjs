// The outline and the handles of the selected part, over the picture: SVG, whose handles can be dragged, or moved by the arrow keys.
import { kinds } from './kinds.mjs';
import { partOf, withPart, listOf } from './scene.mjs';
import { addScaled } from './vector.mjs';

const xmlns = 'http://www.w3.org/2000/svg';
const step = 8; // pixels that an arrow key moves a handle

export class Overlay {
    #handles = [];

    // `app` has `history`, `camera`, `selection`, `selectedPoint` and `axis`: 'view', or 0, 1, 2 for x, y, z.
    constructor(svg, app) {
        this.svg = svg;
        this.app = app;
        this.outline = svg.appendChild(document.createElementNS(xmlns, 'path'));
        this.outline.setAttribute('class', 'outline');
    }

    get #size() {
        return [this.svg.clientWidth || 1, this.svg.clientHeight || 1];
    }

    draw() {
        const { history, camera, selection } = this.app;
        const part = partOf(history.current, selection);
        this.#drawOutline(part ? kinds[listOf(selection)].lines(part) : [], camera);
        this.#drawHandles(part ? kinds[listOf(selection)].handles(part) : [], camera);
    }

    #drawOutline(lines, camera) {
        const [width, height] = this.#size;
        let text = '';
        for (const line of lines) {
            let isDown = false;
            for (const place of line) {
                const { x, y, depth } = camera.project(place, width, height);
                const isSeen = depth > camera.near && Math.abs(x) < 1e5 && Math.abs(y) < 1e5;
                if (isSeen) text += `${isDown ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`;
                isDown = isSeen;
            }
        }
        this.outline.setAttribute('d', text);
    }

    #drawHandles(handles, camera) {
        const [width, height] = this.#size;
        while (this.#handles.length > handles.length) this.#handles.pop().remove();
        while (this.#handles.length < handles.length) this.#handles.push(this.#makeHandle(this.#handles.length));
        handles.forEach((handle, i) => {
            const { x, y, depth } = camera.project(handle.position, width, height);
            const element = this.#handles[i];
            element.setAttribute('display', depth > camera.near ? 'inline' : 'none');
            element.setAttribute('cx', x.toFixed(1));
            element.setAttribute('cy', y.toFixed(1));
            element.setAttribute('aria-label', `Handle: ${handle.label}`);
            element.classList.toggle('chosen', handle.point !== undefined && handle.point === this.app.selectedPoint);
        });
    }

    #makeHandle(index) {
        const element = this.svg.appendChild(document.createElementNS(xmlns, 'circle'));
        element.setAttribute('r', 8);
        element.setAttribute('class', 'handle');
        element.setAttribute('tabindex', 0);
        element.setAttribute('role', 'button');
        element.addEventListener('pointerdown', (event) => this.#beginDrag(event, index));
        element.addEventListener('keydown', (event) => this.#nudge(event, index));
        element.addEventListener('focus', () => this.app.selectPoint(this.#handleOf(index)?.point));
        return element;
    }

    #handleOf(index) {
        const part = partOf(this.app.history.current, this.app.selection);
        return part && kinds[listOf(this.app.selection)].handles(part)[index];
    }

    // The document with the handle where a pixel is, from the document and the place that it had before.
    #moved(before, index, place, x, y) {
        const { camera, axis, selection } = this.app;
        const to = axis === 'view' ? camera.onViewPlane(place, x, y, ...this.#size)
            : camera.onAxis(place, [0, 1, 2].map((i) => (i === axis ? 1 : 0)), x, y, ...this.#size);
        return withPart(before, selection, (part) => kinds[listOf(selection)].handles(part)[index].move(part, to));
    }

    #beginDrag(event, index) {
        const { history, camera } = this.app;
        const element = this.#handles[index], before = history.current, place = this.#handleOf(index).position;
        const seen = camera.project(place, ...this.#size);
        const box = this.svg.getBoundingClientRect();
        const offset = [seen.x - event.clientX + box.left, seen.y - event.clientY + box.top];
        event.preventDefault();
        event.stopPropagation();
        element.focus();
        element.setPointerCapture(event.pointerId);
        const drag = (moved) => history.preview(
            this.#moved(before, index, place, moved.clientX - box.left + offset[0], moved.clientY - box.top + offset[1]));
        const end = (ended) => {
            element.removeEventListener('pointermove', drag);
            element.removeEventListener('pointerup', end);
            element.removeEventListener('pointercancel', end);
            if (ended.type === 'pointercancel') history.revert();
            else history.commit();
        };
        element.addEventListener('pointermove', drag);
        element.addEventListener('pointerup', end);
        element.addEventListener('pointercancel', end);
    }

    #nudge(event, index) {
        const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
        const way = ways[event.key];
        if (!way || event.ctrlKey || event.metaKey) return;
        event.preventDefault();
        event.stopPropagation();
        const { history, camera, axis, selection } = this.app;
        const place = this.#handleOf(index).position, seen = camera.project(place, ...this.#size);
        const pixels = event.shiftKey ? 1 : step;
        if (axis === 'view') {
            history.commit(this.#moved(history.current, index, place, seen.x + pixels * way[0], seen.y + pixels * way[1]));
            return;
        }
        const along = [0, 1, 2].map((i) => (i === axis ? 1 : 0));
        const distance = (way[0] - way[1]) * pixels * camera.unitsPerPixel(seen.depth, this.#size[1]);
        history.commit(withPart(history.current, selection, (part) =>
            kinds[listOf(selection)].handles(part)[index].move(part, addScaled(place, distance, along))));
    }
}
