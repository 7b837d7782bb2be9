// What runs in the page of permutations.mjs: permutations.c, compiled to WebAssembly.
import createPermutations from './permutations.js';

let module, points, errors;

// Counts the draws of points, which only the grids of adaptive resolution are, and GL's errors.
function watch(gl) {
    const { drawArrays } = gl;
    gl.drawArrays = (mode, ...rest) => {
        points += mode === gl.POINTS ? 1 : 0;
        drawArrays.call(gl, mode, ...rest);
        errors += gl.getError() === gl.NO_ERROR ? 0 : 1;
    };
}

// Makes a context, and says what frames there are.
window.begin = async () => {
    const canvas = document.createElement('canvas');
    document.getElementById('canvas').replaceWith(canvas);
    canvas.id = 'canvas';
    module = await createPermutations({ canvas });
    if (!module._start()) throw new Error('there is no WebGL 2');
    watch(canvas.getContext('webgl2'));
    return Array.from({ length: module._count_frames() }, (_, i) => module.UTF8ToString(module._name_frame(i)));
};

// Draws the i-th frame. Returns what is wrong with it, how long it took, and its pixels, if these are wanted.
window.drawFrame = (i, wantsPixels) => {
    points = errors = 0;
    const begin = performance.now();
    const fault = module.UTF8ToString(module._draw_frame(i));
    const milliseconds = performance.now() - begin;
    const first = module._last_pixels();
    return { fault, milliseconds, points, errors, pixels: wantsPixels ? Array.from(module.HEAPU8.subarray(first, first + module._last_pixels_size())) : [] };
};
