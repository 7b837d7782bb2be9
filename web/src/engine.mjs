// The library, compiled to WebAssembly, on a canvas: page.h as functions of JavaScript.
import createPage from './page.js';

// Returns why this browser cannot draw the page, or ''.
export function whatIsMissing() {
    const gl = document.createElement('canvas').getContext('webgl2');
    if (!gl)
        return 'This browser has no WebGL 2, by which the page draws. Take a current browser, or switch its hardware acceleration on.';
    if (!gl.getExtension('EXT_color_buffer_float'))
        return 'This GPU cannot draw to float textures (EXT_color_buffer_float), which the light needs. Take another browser or device.';
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    return '';
}

export async function createEngine(canvas) {
    const module = await createPage({ canvas, print: () => {}, printErr: (text) => console.warn(text) });
    const check = (pointer) => {
        const message = module.UTF8ToString(pointer);
        if (message) throw new Error(message);
    };
    check(module._page_start());
    return {
        renderer: () => module.UTF8ToString(module._page_renderer()),
        showCourt: (seconds) => module._page_show_court(seconds),
        // Throws, and changes nothing, where the text is no scene file.
        showFile(text) {
            const size = module.lengthBytesUTF8(text) + 1;
            const memory = module._malloc(size);
            if (!memory) throw new Error('scene: does not fit into memory');
            module.stringToUTF8(text, memory, size);
            try {
                check(module._page_show_file(memory, size - 1));
            } finally {
                module._free(memory);
            }
        },
        write: () => module.UTF8ToString(module._page_write()),
        setCamera: ({ eye, target, up, height }) => module._page_set_camera(...eye, ...target, ...up, height),
        // The key of what is seen at a place of what is drawn, or ''. The place is from -1 to 1, to the right and up, and so wide.
        pick: (x, y, aspect, width) => module.UTF8ToString(module._page_pick(x, y, aspect, width)),
        setIntegrator: (isRight, { integrator, quality, divisions }) =>
            module._page_set_integrator(isRight, integrator, quality, divisions),
        setView: (mode, split) => module._page_set_view(mode, split),
        prepare: (width, height) => module._page_prepare(width, height),
        draw: (width, height) => check(module._page_draw(width, height)),
        present: () => module._page_present(),
        // Rows from the top down, as ImageData has them.
        read(width, height) {
            const pointer = module._page_read();
            if (!pointer) throw new Error('The picture does not fit into memory. Ask for a smaller one.');
            const image = new ImageData(width, height);
            for (let row = 0; row < height; row++) {
                const start = pointer + 4 * width * (height - 1 - row);
                image.data.set(module.HEAPU8.subarray(start, start + 4 * width), 4 * width * row);
            }
            return image;
        },
        // The weights of a pulse at a frame.
        pulse(frame, count) {
            const memory = module._malloc(8 * count);
            if (!memory) throw new Error('The weights do not fit into memory.');
            module._page_fill_pulse(frame, memory, count);
            const weights = [...module.HEAPF64.subarray(memory / 8, memory / 8 + count)];
            module._free(memory);
            return weights;
        },
        statistic: (half, which) => module._page_statistic(half, which),
    };
}
