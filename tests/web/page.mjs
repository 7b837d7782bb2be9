// What runs in the page: ew-render, compiled to WebAssembly, watched call by call.
import createEwRender from './ew-render.js';

const messages = [];
let points = 0; // how often points were drawn, which only the grids of adaptive resolution are

// Asks for GL's error after each call. The program gets the error that it asks for all the same.
function watch(prototype) {
    const getError = prototype.getError;
    let pending = 0;
    for (const name of Object.getOwnPropertyNames(prototype)) {
        const method = Object.getOwnPropertyDescriptor(prototype, name).value;
        if (typeof method !== 'function' || name === 'constructor' || name === 'getError') continue;
        prototype[name] = function (...parameters) {
            const value = method.apply(this, parameters);
            if (name === 'drawArrays' && parameters[0] === this.POINTS) points++;
            const error = getError.call(this);
            if (error) messages.push(`${name} makes GL error 0x${error.toString(16)}`);
            pending ||= error;
            return value;
        };
    }
    prototype.getError = () => {
        const error = pending;
        pending = 0;
        return error;
    };
}
watch(WebGL2RenderingContext.prototype);

async function pixelsOf(png) {
    const bitmap = await createImageBitmap(new Blob([png], { type: 'image/png' }), { colorSpaceConversion: 'none' });
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
}

// Draws the scene `NAME.json` with the options. Each picture has a module and a context of its own, so that shaders are compiled anew.
// Returns its pixels, or nothing, and how long drawing took.
async function draw(name, options) {
    const canvas = document.createElement('canvas');
    document.getElementById('canvas').replaceWith(canvas);
    canvas.id = 'canvas';
    const module = await createEwRender({ canvas, print: () => {}, printErr: (text) => messages.push(text) });
    module.FS.writeFile('/scene.json', await (await fetch(`${name}.json`)).text());
    const start = performance.now();
    const status = module.callMain(['/scene.json', '-o', '/drawn.png', ...options]);
    const milliseconds = performance.now() - start;
    return { pixels: status === 0 ? await pixelsOf(module.FS.readFile('/drawn.png')) : [], milliseconds };
}

// The differences between the picture of a scene and the native one, `NAME.png`, in 255ths: one a pixel.
function differences(drawn, native) {
    const most = new Uint8Array(native.length / 4).fill(drawn.length === native.length ? 0 : 255);
    for (let i = 0; i < native.length; i++) most[i >> 2] = Math.max(most[i >> 2], Math.abs((drawn[i] ?? 0) - native[i]));
    return most;
}

async function differencesOf(name, options) {
    const { pixels, milliseconds } = await draw(name, options);
    const native = await pixelsOf(new Uint8Array(await (await fetch(`${name}.png`)).arrayBuffer()));
    return { most: differences(pixels, native), milliseconds };
}

// Compares a scene's picture with the native one. At the silhouettes of opaque shapes rasterisers may choose another surface: pixels in
// which `NAME-dark`, the scene without its light and recoloured, differs by more than `allowed` do not count, but how many they are is told.
window.compare = async (name, options, allowed) => {
    messages.length = 0;
    const dark = await differencesOf(`${name}-dark`, options);
    points = 0;
    const { most, milliseconds } = await differencesOf(name, options);
    const counted = most.filter((_, i) => dark.most[i] <= allowed);
    const left = most.length - counted.length;
    return { difference: Math.max(...counted), left, pixels: most.length, hasGrid: points > 0, milliseconds, messages };
};
