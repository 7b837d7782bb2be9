// Scenes in a browser are what they are natively, at most 2/255 apart, without a GL error after any call.
// Usage: scenes.mjs SCENES EW_RENDER WEB_BUILD FOLDER; the scenes are those of demo/scenes, ew-render is the native one
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { open } from './browser.mjs';
import { darkScene } from './dark.mjs';

const [scenes, nativeRender, webBuild, folder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const most = 2; // of 255
const mostLeft = 0.001; // of the pixels: silhouettes

// All kinds of sources, alone and together, with and without weights, sharpness, joints, bends, opaque shapes and an interval.
const names = ['showpiece', 'torus-0.9-oblique', 'weights-seven', 'beziers-5.0-side', 'artists/beam-struggle', 'artists/bolt',
    'artists/slash', 'artists/aura', 'artists/portal'];
// Enough pixels for adaptive resolution, and no face of a pillar seen along itself: rasterisers place vertices to a 16th or a 256th of a
// pixel, by which the depth of such a face changes.
const size = ['--size', '368x207'];

const files = {
    'page.html': `${here}/page.html`,
    'page.mjs': `${here}/page.mjs`,
    'ew-render.js': `${webBuild}/demo/ew-render.js`,
    'ew-render.wasm': `${webBuild}/demo/ew-render.wasm`,
};
mkdirSync(folder, { recursive: true });
function addScene(name, path) {
    files[`${name}.json`] = path;
    files[`${name}.png`] = `${folder}/${name}.png`;
    execFileSync(nativeRender, [path, '-o', files[`${name}.png`], '--resolution', 'full', ...size]);
}
for (const name of names) {
    const darkPath = `${folder}/${basename(name)}-dark.json`;
    writeFileSync(darkPath, JSON.stringify(darkScene(JSON.parse(readFileSync(`${scenes}/${name}.json`)))));
    addScene(`${basename(name)}-dark`, darkPath);
    addScene(basename(name), `${scenes}/${name}.json`);
}

let failures = 0;
for (const rasteriser of ['swiftshader', 'llvmpipe']) {
    const { page, close } = await open(rasteriser, folder, files);
    for (const name of names)
        for (const resolution of ['full', 'adaptive']) {
            const options = ['--resolution', resolution, ...size];
            const { difference, left, pixels, hasGrid, milliseconds, messages } = await page.evaluate(
                ([scene, how, allowed]) => window.compare(scene, how, allowed), [basename(name), options, most]);
            const isGood = difference <= most && left <= mostLeft * pixels && messages.length === 0 &&
                hasGrid === (resolution === 'adaptive');
            failures += isGood ? 0 : 1;
            console.log(`${isGood ? 'ok  ' : 'FAIL'} ${rasteriser} ${name} ${resolution}: ${difference}/255 off, ${left} silhouettes, ` +
                `${Math.round(milliseconds)} ms${messages.map((message) => `\n         ${message}`).join('')}`);
        }
    await close();
}
process.exit(failures > 0 ? 1 : 0);
