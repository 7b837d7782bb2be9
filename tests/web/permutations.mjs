// Every shader that a frame can ask for is compiled and drawn first in Chromium on SwiftShader in little time and memory: every kind of
// source, alone and together with the others, with what changes its integrator, and a point with what changes the rest of a shader.
// Without EXT_color_buffer_float, frames of adaptive resolution are drawn at full resolution, and no frame in parts.
// Usage: permutations.mjs PERMUTATIONS.JS FOLDER
import { readFileSync, rmSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { hideExtension, open } from './browser.mjs';

const [program, folder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
// Milliseconds of a processor for a shader, from its text to its first draw: half as much again as is asked for, beside other work.
// Other work adds to what is measured, and nothing takes from it. So one of some must be within it; a new context compiles
// all anew.
const most = 1500, mostMegabytes = 1000, measurements = 3;
const mostDifference = 1; // of 255

const files = {
    'page.html': `${here}/page.html`,
    'page.mjs': `${here}/permutations_page.mjs`,
    'permutations.js': program,
    'permutations.wasm': program.replace(/js$/, 'wasm'),
};
rmSync(folder, { recursive: true, force: true }); // with all that Chromium has kept of shaders
const { page, close } = await open('swiftshader', folder, files);
const devtools = await page.context().browser().newBrowserCDPSession();

let failures = 0;
function tell(isGood, text) {
    failures += isGood ? 0 : 1;
    console.log(`${isGood ? 'ok  ' : 'FAIL'} ${text}`);
}

// The process that draws: its id, and the milliseconds of a processor that it has taken. Unlike time by the clock, these grow little
// where a machine has other work, too.
async function drawingProcess() {
    const { processInfo } = await devtools.send('SystemInfo.getProcessInfo');
    const { id, cpuTime } = processInfo.find(({ type }) => type === 'GPU');
    return { id, milliseconds: 1000 * cpuTime };
}

// The same once the process has come to rest: some work on a shader goes on behind a call.
async function settledMilliseconds() {
    let before, { milliseconds } = await drawingProcess();
    do {
        before = milliseconds;
        await new Promise((resolve) => setTimeout(resolve, 50));
        ({ milliseconds } = await drawingProcess());
    } while (milliseconds > before);
    return milliseconds;
}

// Draws a frame, whose shaders are prepared one by one. Returns also the milliseconds of each: a call compiles it, links it, or makes its
// first draw.
async function drawFrame(i, wantsPixels) {
    let last = await settledMilliseconds();
    async function timed(result) {
        const value = await result;
        const now = await settledMilliseconds();
        const milliseconds = now - last;
        last = now;
        return { ...value, milliseconds };
    }
    const steps = [await timed(page.evaluate((frame) => window.beginFrame(frame), i))];
    do steps.push(await timed(page.evaluate((frame) => window.prepareFrame(frame), i)));
    while (!steps.at(-1).fault && steps.at(-1).stepsLeft > 0);
    const drawn = await timed(page.evaluate(([frame, pixels]) => window.drawFrame(frame, pixels), [i, wantsPixels]));
    const shaders = Array.from({ length: (steps.length - 1) / 3 }, (_, k) =>
        steps.slice(3 * k + 1, 3 * k + 4).reduce((sum, step) => sum + step.milliseconds, 0));
    return { ...drawn, longest: Math.max(...shaders), shaders, total: [...steps, drawn].reduce((sum, step) => sum + step.milliseconds, 0) };
}

await page.evaluate(hideExtension, 'KHR_parallel_shader_compile'); // by which a call would take steps of all shaders
const names = await page.evaluate(() => window.begin());
let total = 0;
for (const [i, name] of names.entries()) {
    let drawn = await drawFrame(i);
    for (let k = 1; k < measurements && !drawn.fault && drawn.errors === 0 && drawn.longest > most; ++k) {
        await page.evaluate(() => window.begin());
        drawn = await drawFrame(i);
    }
    const { fault, longest, shaders, milliseconds, total: taken, points, errors } = drawn;
    total += taken;
    tell(!fault && errors === 0 && longest <= most && milliseconds <= most && (points > 0) === /adaptive/.test(name),
        `${name}: ${shaders.length} shaders, ${Math.round(longest)} ms at most, ${Math.round(taken)} ms in all, ${Math.round(milliseconds)} ms for the frame${fault && `, ${fault}`}${errors ? `, ${errors} errors of GL` : ''}`);
}
const { id } = await drawingProcess();
const megabytes = /VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`))[1] / 1024;
tell(megabytes <= mostMegabytes, `${names.length} frames in ${Math.round(total / 1000)} s of a processor, with ${Math.round(megabytes)} MB at most`);

// Without float textures, a frame of adaptive resolution and of all kinds is what it was with them, but at full resolution and by one
// shader.
const adaptive = names.findIndex((name) => /^all.*adaptive/.test(name));
const withGrid = await drawFrame(adaptive, true);
await page.evaluate(hideExtension, 'EXT_color_buffer_float');
await page.evaluate(() => window.begin());
const bare = await drawFrame(adaptive, true);
const difference = bare.pixels.reduce((most, value, k) => Math.max(most, Math.abs(value - withGrid.pixels[k])), 0);
tell(!bare.fault && bare.errors === 0 && withGrid.points > 0 && bare.points === 0 && bare.shaders.length === 1 && difference <= mostDifference,
    `without float textures, at full resolution and by one shader: ${difference}/255 off${bare.fault && `, ${bare.fault}`}`);

await close();
process.exit(failures > 0 ? 1 : 0);
