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

// Begins with the i-th frame, and takes a step towards its shaders. These return what is wrong, and the second how many steps are left.
window.beginFrame = (i) => {
    points = errors = 0;
    return { fault: module.UTF8ToString(module._begin_frame(i)) };
};
window.prepareFrame = (i) => ({ fault: module.UTF8ToString(module._prepare_frame(i)), stepsLeft: module._count_steps_left() });

// Draws it. Returns what is wrong with it, and its pixels, if these are wanted.
window.drawFrame = (i, wantsPixels) => {
    const fault = module.UTF8ToString(module._draw_frame(i));
    const first = module._last_pixels();
    return { fault, points, errors, pixels: wantsPixels ? Array.from(module.HEAPU8.subarray(first, first + module._last_pixels_size())) : [] };
};
