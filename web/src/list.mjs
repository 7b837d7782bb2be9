// The list of lights, shapes and media.
import { element, hexOf } from './controls.mjs';
import { isSource } from './kinds.mjs';
import { colorOf, keysOf, listOf, nameOf } from './scene.mjs';

export class PartList {
    #shown = '';

    // `app` has `history`, `selection`, `select` and `toggleHidden`.
    constructor(container, empty, app) {
        Object.assign(this, { container, empty, app });
    }

    draw() {
        const { history, selection } = this.app, document = history.current;
        const rows = keysOf(document).map((key) => ({ key, name: nameOf(document, key), isHidden: document.hidden.includes(key),
            color: colorOf(document, key) }));
        const shown = JSON.stringify([rows, selection]);
        if (shown === this.#shown) return;
        this.#shown = shown;
        const focused = globalThis.document.activeElement?.dataset?.focus;
        this.container.replaceChildren(...rows.map((row) => this.#row(row)));
        if (focused) [...this.container.querySelectorAll('[data-focus]')].find((one) => one.dataset.focus === focused)?.focus();
        this.empty.hidden = rows.length > 0;
        this.container.querySelector('[aria-pressed=true]')?.scrollIntoView({ block: 'nearest' });
    }

    #row({ key, name, isHidden, color }) {
        const swatch = element('i', { class: isSource(listOf(key)) ? 'swatch' : 'swatch solid', 'aria-hidden': 'true' });
        const most = isSource(listOf(key)) ? Math.max(...color, 1e-9) : 1; // of a light, only the hue
        swatch.style.background = hexOf(color.map((x) => x / most));
        const choose = element('button', { type: 'button', class: isHidden ? 'part hidden' : 'part', 'data-focus': `part ${key}`,
            'aria-pressed': String(key === this.app.selection), onclick: () => this.app.select(key) }, swatch, element('span', {}, name));
        const eye = element('button', { type: 'button', class: 'eye', 'data-focus': `eye ${key}`, 'aria-pressed': String(isHidden),
            'aria-label': `Hide ${name}`, title: 'Hide, or show again (H)', onclick: () => this.app.toggleHidden(key) }, isHidden ? 'show' : 'hide');
        return element('li', {}, choose, eye);
    }
}
