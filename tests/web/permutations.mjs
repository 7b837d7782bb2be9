// Every shader that a frame can ask for is compiled and drawn first in Chromium on SwiftShader in little time and memory: every kind of
// source, alone and together with the others, with what changes its integrator, and a point with what changes the rest of a shader.
// Without EXT_color_buffer_float, frames of adaptive resolution are drawn at full resolution.
// Usage: permutations.mjs PERMUTATIONS.JS FOLDER
import { readFileSync, rmSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { hideExtension, open } from './browser.mjs';

const [program, folder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
// Milliseconds of a processor for one kind of source, and for all at once: half as much again as was measured beside other work. Adaptive
// resolution compiles two integrals.
const most = { one: 3000, all: 5500 }, mostMegabytes = 1000;
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

const names = await page.evaluate(() => window.begin());
let total = 0;
for (const [i, name] of names.entries()) {
    const before = await drawingProcess();
    const { fault, milliseconds, points, errors } = await page.evaluate((frame) => window.drawFrame(frame), i);
    const taken = (await drawingProcess()).milliseconds - before.milliseconds;
    const limit = (/^all/.test(name) ? most.all : most.one) * (/adaptive/.test(name) ? 2 : 1);
    total += taken;
    tell(!fault && errors === 0 && taken <= limit && (points > 0) === /adaptive/.test(name),
        `${name}: ${Math.round(taken)} ms, ${Math.round(milliseconds)} by the clock${fault && `, ${fault}`}${errors ? `, ${errors} errors of GL` : ''}`);
}
const { id } = await drawingProcess();
const megabytes = /VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`))[1] / 1024;
tell(megabytes <= mostMegabytes, `${names.length} frames in ${Math.round(total / 1000)} s of a processor, with ${Math.round(megabytes)} MB at most`);

// Without float textures, a frame of adaptive resolution is what it was with them, but at full resolution.
const adaptive = names.findIndex((name) => /adaptive/.test(name));
const withGrid = await page.evaluate((frame) => window.drawFrame(frame, true), adaptive);
await page.evaluate(hideExtension, 'EXT_color_buffer_float');
await page.evaluate(() => window.begin());
const bare = await page.evaluate((frame) => window.drawFrame(frame, true), adaptive);
const difference = bare.pixels.reduce((most, value, k) => Math.max(most, Math.abs(value - withGrid.pixels[k])), 0);
tell(!bare.fault && bare.errors === 0 && withGrid.points > 0 && bare.points === 0 && difference <= mostDifference,
    `without float textures, at full resolution: ${difference}/255 off${bare.fault && `, ${bare.fault}`}`);

await close();
process.exit(failures > 0 ? 1 : 0);
