// The page, as one uses it: each test is a promise of it. Pictures of the page itself are left in FOLDER, to be looked at.
// Usage: site.mjs SITE NATIVE_BUILD FOLDER; run where the repository is
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { hideExtension, launch } from './browser.mjs';
import { darkScene } from './dark.mjs';
import { inFolder, serve } from './serve.mjs';

const [site, native, folder] = process.argv.slice(2);
const pngSize = [368, 207];
const viewport = { width: 900, height: 520 }, pillar = [290, 250]; // where the pillar of the empty floor is seen
const mostBytes = 1e6, most = 2; // of 255
const mostLeft = 0.001; // of the pixels: silhouettes
const patience = 60000; // milliseconds, for shaders and pictures by software

rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const server = await serve(inFolder(site), 0);
const address = `http://127.0.0.1:${server.address().port}/`;
const requests = [], faults = [];

// Opens the page in a browser of its own, and takes note of what it asks for and complains of. `profile` is the browser's folder.
async function open(profile, options) {
    const opened = await launch('swiftshader', profile, `${address}?any`, options); // so that going to `address` loads the page anew
    opened.page.setDefaultTimeout(patience);
    opened.browser.on('request', (request) => requests.push(request.url()));
    opened.page.on('pageerror', (error) => faults.push(String(error)));
    opened.page.on('console', (message) => ['error', 'warning'].includes(message.type()) && faults.push(message.text()));
    await opened.page.reload(); // so that what loading asks for is among them
    return opened;
}

const { page: firstPage, browser } = await open(folder, { viewport, permissions: ['clipboard-read', 'clipboard-write'] });
let page = firstPage; // that the functions below use

const rests = () => page.waitForFunction(() => document.getElementById('stage').getAttribute('aria-busy') === 'false' && document.getElementById('loading').hidden);
const look = (name) => page.screenshot({ path: `${folder}/${name}.png` });
const message = () => page.evaluate(() => (document.getElementById('message').hidden ? '' : document.getElementById('message-text').textContent));
const parts = () => page.locator('#parts .part').allTextContents();

async function startFrom(name) {
    await page.selectOption('#start', name);
    await page.waitForFunction(() => document.getElementById('start').value === '');
    await rests();
}

async function saved(button = '#save') {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
    return readFileSync(await download.path());
}

const savedScene = async () => JSON.parse(await saved());

async function openFile(file) {
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.click('#open')]);
    await chooser.setFiles(file);
}

const asFile = (name, text) => ({ name, mimeType: 'application/json', buffer: Buffer.from(text) });

// The differences between two PNGs of one size, in 255ths: one a pixel.
function differences(a, b) {
    return page.evaluate(async (pngs) => {
        const [first, second] = await Promise.all(pngs.map(async (png) => {
            const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (c) => c.charCodeAt(0))], { type: 'image/png' }), { colorSpaceConversion: 'none' });
            const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
            context.drawImage(bitmap, 0, 0);
            return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
        }));
        const most = new Array(first.length / 4).fill(first.length === second.length ? 0 : 255);
        for (let i = 0; i < first.length; i++) most[i >> 2] = Math.max(most[i >> 2], Math.abs(first[i] - second[i]));
        return most;
    }, [a, b].map((png) => png.toString('base64')));
}

function renderNatively(path) {
    const picture = `${folder}/native.png`;
    execFileSync(`${native}/demo/ew-render`, [path, '-o', picture, '--size', pngSize.join('x'), '--resolution', 'full'], { stdio: ['ignore', 'ignore', 'inherit'] });
    return readFileSync(picture);
}

async function pagePng() {
    await page.fill('#png-width', String(pngSize[0]));
    await page.fill('#png-height', String(pngSize[1]));
    return saved('#png');
}

function expect(condition, what) {
    if (!condition) throw new Error(what);
}

// Opens a scene, and returns the page's picture of it and the native one of the file that the page saves.
async function bothPictures(name, scene) {
    await openFile(asFile(name, JSON.stringify(scene)));
    const count = Object.values(scene).flatMap((list) => (typeof list?.[0] === 'object' ? list : [])).length;
    await page.waitForFunction((wanted) => document.querySelectorAll('#parts .part').length === wanted, count);
    const png = await pagePng();
    writeFileSync(`${folder}/saved.json`, await saved());
    return [png, renderNatively(`${folder}/saved.json`)];
}

// Waits until the canvas has the pixels of a screen with `density` of them in one of the page's, each way, and rests with them.
async function isSharp(density, what) {
    const { width, height } = await page.locator('#canvas').boundingBox(), wanted = [width, height].map((side) => Math.round(side * density));
    const isWanted = ([x, y]) => document.getElementById('canvas').width === x && document.getElementById('canvas').height === y;
    await page.waitForFunction(isWanted, wanted).catch(() => {});
    await rests();
    const found = await page.evaluate(() => [document.getElementById('canvas').width, document.getElementById('canvas').height]);
    expect(found.join() === wanted.join(), `${what}, the canvas has ${found} pixels, where the screen has ${wanted}`);
}

// Where the picture, of the screen's pixels, is brightest: the middle of all pixels that are nearly as bright as one can be.
async function brightestPlace() {
    const png = (await page.locator('#stage').screenshot({ path: `${folder}/sharp.png` })).toString('base64');
    return page.evaluate(async (text) => {
        const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], { type: 'image/png' }));
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        context.drawImage(bitmap, 0, 0);
        const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
        const sum = [0, 0, 0];
        for (let i = 0; i < data.length; i += 4)
            if (data[i + 1] > 190 && data[i + 2] > 190) [1, (i / 4) % bitmap.width + 0.5, Math.floor(i / 4 / bitmap.width) + 0.5].forEach((x, k) => (sum[k] += x));
        return [sum[1] / sum[0], sum[2] / sum[0]];
    }, png);
}

// The empty floor's camera looks from 7 units away at its middle, in front of a pillar 0.7 units wide, whose front is 8.65 units away.
async function choosesAndMoves() {
    const { width, height } = await page.locator('#stage').boundingBox(), middle = [width / 2, height / 2];
    const rowsPerUnit = height / 2 / Math.tan((20 * Math.PI) / 180); // at a view depth of 1
    for (const [offset, name] of [[0.3, 'Pillar'], [-0.3, 'Pillar'], [0.4, 'Floor']]) {
        await page.mouse.click(middle[0] + (offset / 8.7) * rowsPerUnit, middle[1] + 10);
        const chosen = await page.textContent('#selected-title');
        expect(chosen === name, `a click ${offset} units beside the pillar's middle chooses ${chosen}`);
    }
    await page.click('#add-orb');
    await page.mouse.move(...middle);
    await page.mouse.down();
    await page.mouse.move(middle[0] - 90, middle[1] - 40, { steps: 4 });
    await page.mouse.up();
    const scene = await savedScene(), distance = Math.hypot(7, 1);
    const moved = (-scene.points[0].position[0] * rowsPerUnit) / distance;
    expect(Math.abs(moved - 90) < 0.01, `dragged by 90 pixels, the orb moves by ${moved}`);
    await page.keyboard.press('Escape');
    await page.evaluate(() => (document.getElementById('hint').hidden = true));
    await isSharp(2, 'at last');
    const seen = (await brightestPlace()).map((x) => x / 2);
    expect(Math.abs(seen[0] - middle[0] + 90) < 1 && Math.abs(seen[1] - middle[1] + 40) < 1, `the orb is seen at ${seen}, not where it was dragged to from ${middle}`);
    const png = await pagePng();
    expect(png.readUInt32BE(16) === pngSize[0] && png.readUInt32BE(20) === pngSize[1], `the PNG is ${png.readUInt32BE(16)} pixels wide`);
    writeFileSync(`${folder}/saved.json`, JSON.stringify(scene));
    const counted = (await differences(png, renderNatively(`${folder}/saved.json`))).filter((difference) => difference > most).length;
    expect(counted <= mostLeft * pngSize[0] * pngSize[1], `${counted} pixels of the PNG are another picture`);
    await isSharp(2, 'after a PNG');
}

const tests = {
    'draws the court, and is smaller than a megabyte': async () => {
        await page.waitForFunction(() => document.getElementById('loading').hidden);
        await look('court');
        const sizes = readdirSync(site, { recursive: true }).map((name) => statSync(`${site}/${name}`)).filter((file) => file.isFile()).map((file) => file.size);
        const sum = sizes.reduce((a, b) => a + b, 0);
        expect(sum < mostBytes, `the site has ${sum} bytes`);
    },
    'a click on a light takes this moment and chooses the light': async () => {
        // At a moment at which the beam is not before the orb.
        for (let wait = 500; ; wait += 500) {
            await page.click('#play');
            await page.click('#edit-moment');
            await rests();
            const list = await parts();
            if (list.includes('Orb') && !list.includes('Beam')) break;
            expect(wait < 10000, `the list has ${list}`);
            await page.selectOption('#start', 'court');
            await page.waitForSelector('#play', { state: 'visible' });
            if ((await page.textContent('#play')) === 'Play') await page.click('#play');
            await page.waitForTimeout(wait);
        }
        await page.locator('#parts .part', { hasText: /^Orb$/ }).click();
        const handle = await page.locator('circle.handle').first().boundingBox();
        await page.keyboard.press('Escape');
        expect(await page.isHidden('#selected'), 'Escape left something chosen');
        await page.mouse.click(handle.x + handle.width / 2 + 3, handle.y + handle.height / 2 + 3);
        expect((await page.textContent('#selected-title')) === 'Orb', `${await page.textContent('#selected-title')} was chosen`);
    },
    'a dragged point and a new reach are undone, redone, saved, kept over a reload, and opened': async () => {
        await startFrom('empty');
        await page.click('#add-path');
        await rests();
        const before = await savedScene();
        const box = await page.locator('circle.handle').nth(1).boundingBox();
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
        await page.mouse.down();
        await page.mouse.move(box.x + 30, box.y - 60, { steps: 4 });
        await page.mouse.up();
        await page.fill('#reach-number', '0.75');
        await page.keyboard.press('Tab');
        await rests();
        await look('path');
        const changed = await savedScene();
        expect(changed.paths[0].reach === 0.75, `the reach is ${changed.paths[0].reach}`);
        expect(changed.paths[0].points[1][1] > before.paths[0].points[1][1] + 0.1, 'the point was not dragged up');
        await page.click('#undo');
        await page.click('#undo');
        expect(JSON.stringify((await savedScene()).paths) === JSON.stringify(before.paths), 'undo did not bring back what was there');
        await page.click('#redo');
        await page.click('#redo');
        const redone = await saved();
        expect(JSON.stringify(JSON.parse(redone).paths) === JSON.stringify(changed.paths), 'redo did not bring back the changes');
        await page.reload();
        await rests();
        expect(JSON.stringify(await savedScene()) === JSON.stringify(changed), 'the reload lost something');
        await startFrom('empty');
        await openFile(asFile('mine.json', redone.toString()));
        await page.waitForFunction(() => document.querySelectorAll('#parts .part').length === 3);
        expect(JSON.stringify(await savedScene()) === JSON.stringify(changed), 'the file opened as something else');
    },
    'the keyboard alone is enough': async () => {
        await startFrom('empty');
        await page.focus('#add-orb');
        await page.keyboard.press('Enter');
        const before = (await savedScene()).points[0].position;
        await page.locator('circle.handle').first().focus();
        await page.keyboard.press('x');
        await page.keyboard.press('ArrowRight');
        const after = (await savedScene()).points[0].position;
        expect(after[0] > before[0] && after[1] === before[1] && after[2] === before[2], `the arrow moved it from ${before} to ${after}`);
        await page.keyboard.press('v');
        await page.keyboard.press('Control+d');
        expect((await savedScene()).points.length === 2, 'Ctrl+D did not duplicate');
        await page.keyboard.press('Control+z');
        await page.keyboard.press('Control+z');
        expect((await savedScene()).points[0].position.join() === before.join(), 'Ctrl+Z did not undo');
        await page.keyboard.press('?');
        expect(await page.isVisible('#keys'), '? shows no keys');
        await look('keys');
        await page.keyboard.press('Escape');
        await page.locator('#parts .part').first().focus();
        await page.keyboard.press('Enter');
        await page.keyboard.press('Delete');
        expect(!(await savedScene()).points, 'Delete did not delete');
    },
    'every kind can be added, and hidden, and every control leaves a scene that ew-render takes': async () => {
        await startFrom('empty');
        for (const name of ['orb', 'beam', 'path', 'spiral', 'ring', 'line', 'curve', 'shape', 'medium']) await page.click(`#add-${name}`);
        for (const part of await page.locator('#parts .part').all()) {
            await part.click();
            for (const range of await page.locator('#controls input[type=range]').all()) {
                await range.press('Home');
            }
            for (const kind of ['polyline', 'bspline', 'bezier', 'catmull_rom'])
                if (await page.locator('#kind').count()) await page.selectOption('#kind', kind);
            if (await page.locator('#add-weights').count()) await page.click('#add-weights');
            for (const shape of await page.locator('#shape option').allTextContents()) await page.selectOption('#shape', shape);
        }
        await page.keyboard.press('Escape');
        writeFileSync(`${folder}/everything.json`, await saved());
        renderNatively(`${folder}/everything.json`);
        expect((await message()) === 'Saved.', await message());
    },
    'what the page shows is what ew-render draws': async () => {
        for (const name of ['showpiece', 'weights-seven', 'artists/aura', 'artists/beam-struggle']) {
            const scene = JSON.parse(readFileSync(`demo/scenes/${name}.json`));
            // At the silhouettes of opaque shapes rasterisers may choose another surface.
            const dark = await differences(...(await bothPictures('dark.json', darkScene(scene))));
            const lit = await differences(...(await bothPictures('lit.json', scene)));
            const counted = lit.filter((_, i) => dark[i] <= most), left = lit.length - counted.length;
            expect(Math.max(...counted) <= most && left <= mostLeft * lit.length, `${name}: ${Math.max(...counted)}/255 off, ${left} silhouettes`);
        }
    },
    'fog is made, thins out with height, and is cleared': async () => {
        await startFrom('empty');
        await page.click('#add-orb');
        await page.keyboard.press('Escape');
        await page.click('#look-section summary');
        const enter = async (id, value) => {
            await page.fill(`#${id}-number`, value);
            await page.keyboard.press('Tab');
        };
        const picture = async () => {
            await rests();
            return pagePng();
        };
        const changed = async (before, after) => (await differences(before, after)).filter((difference) => difference > 10).length;
        const clear = await picture();
        await enter('fog-height', '3');
        expect(!(await savedScene()).fog, 'no fog thins out');
        await enter('fog', '0.2');
        expect((await savedScene()).fog.extinction === 0.2, `the fog is ${JSON.stringify((await savedScene()).fog)}`);
        const even = await picture();
        expect((await changed(clear, even)) > 100, 'fog leaves the picture as it is');
        await enter('fog-height', '1.5');
        const fog = (await savedScene()).fog;
        expect(fog.extinction === 0.2 && fog.height.scale === 1.5, `the fog is ${JSON.stringify(fog)}`);
        const thinner = await picture();
        expect((await changed(even, thinner)) > 100, 'it does not thin out');
        writeFileSync(`${folder}/fog.json`, await saved());
        const counted = (await differences(thinner, renderNatively(`${folder}/fog.json`))).filter((difference) => difference > most).length;
        expect(counted <= mostLeft * pngSize[0] * pngSize[1], `${counted} pixels of the PNG are another picture`);
        await look('fog');
        await enter('fog', '0');
        expect(!(await savedScene()).fog, 'the fog was not cleared');
        expect((await changed(clear, await picture())) === 0, 'without fog the picture is not as before');
    },
    'a medium is added, dragged, made denser and another shape, clicked on, removed and brought back': async () => {
        await startFrom('empty');
        await page.click('#add-medium');
        const drag = async (index, x, y) => {
            const box = await page.locator('circle.handle').nth(index).boundingBox();
            await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
            await page.mouse.down();
            await page.mouse.move(box.x + box.width / 2 + x, box.y + box.height / 2 + y, { steps: 4 });
            await page.mouse.up();
        };
        const medium = async () => (await savedScene()).media[0], first = await medium();
        await drag(0, 0, -60);
        await drag(1, 40, 0);
        const dragged = await medium();
        expect(dragged.center[1] > first.center[1] + 0.3 && Math.abs(dragged.center[0] - first.center[0]) < 1e-3, `dragged up, it is at ${dragged.center}`);
        expect(dragged.radius > first.radius + 0.2, `drawn to the right, its radius is ${dragged.radius}`);
        await page.fill('#extinction-number', '2.5');
        await page.fill('#albedo-number', '7'); // more than all
        await page.keyboard.press('Tab');
        await page.fill('#color', '#ff0000');
        await page.selectOption('#shape', 'ellipsoid');
        await drag(2, 0, -50);
        const shaped = await medium();
        expect(shaped.extinction === 2.5 && shaped.albedo === 1 && shaped.ambient.join() === '1,0,0', `it is ${JSON.stringify(shaped)}`);
        expect(shaped.shape === 'ellipsoid' && shaped.radius === undefined && shaped.radii[1] > 0.6 && shaped.radii[0] === 0.8, `it is ${JSON.stringify(shaped)}`);
        await look('medium');
        const middle = await page.locator('circle.handle').first().boundingBox();
        await page.keyboard.press('Escape');
        await page.mouse.click(middle.x + middle.width / 2, middle.y + middle.height / 2);
        expect((await page.textContent('#selected-title')) === 'Medium 1', `${await page.textContent('#selected-title')} was chosen`);
        await page.keyboard.press('Delete');
        expect(!(await savedScene()).media, 'Delete did not delete');
        await page.keyboard.press('Control+z');
        await rests();
        const png = await pagePng();
        writeFileSync(`${folder}/saved.json`, await saved());
        expect(JSON.stringify(await medium()) === JSON.stringify(shaped), 'undo did not bring it back');
        const counted = (await differences(png, renderNatively(`${folder}/saved.json`))).filter((difference) => difference > most).length;
        expect(counted <= mostLeft * pngSize[0] * pngSize[1], `${counted} pixels of the PNG are another picture`);
    },
    'one finger looks around, two come closer, and a tap chooses': async () => {
        await startFrom('empty');
        const devtools = await browser.newCDPSession(page);
        const touch = (type, ...fingers) => devtools.send('Input.dispatchTouchEvent', { type, touchPoints: fingers.map(([x, y], id) => ({ x, y, id })) });
        const distance = ({ eye, target }) => Math.hypot(...eye.map((x, i) => x - target[i]));
        await touch('touchStart', pillar);
        await touch('touchEnd');
        expect((await page.textContent('#selected-title')) === 'Pillar', 'a tap on the pillar does not choose it');
        const before = (await savedScene()).camera;
        await touch('touchStart', [100, 450]);
        for (let i = 1; i <= 5; i++) await touch('touchMove', [100 + 20 * i, 450]);
        await touch('touchEnd');
        const turned = (await savedScene()).camera;
        expect(Math.abs(turned.eye[0] - before.eye[0]) > 1 && Math.abs(distance(turned) / distance(before) - 1) < 1e-6, 'a finger does not look around');
        await touch('touchStart', [200, 450], [300, 450]);
        for (let i = 1; i <= 5; i++) await touch('touchMove', [200 - 20 * i, 450], [300 + 20 * i, 450]);
        await touch('touchEnd');
        const near = distance((await savedScene()).camera) / distance(turned);
        expect(Math.abs(near * 3 - 1) < 0.01, `fingers that are three times as far apart come ${1 / near} times as close`);
        await page.keyboard.press('Escape');
    },
    'a click goes through what is hidden': async () => {
        await startFrom('empty');
        const chosen = async () => {
            await page.keyboard.press('Escape');
            await page.mouse.click(...pillar);
            return (await page.isVisible('#selected')) ? page.textContent('#selected-title') : 'nothing';
        };
        await page.click('[aria-label="Hide Floor"]');
        expect((await chosen()) === 'Pillar', `without the floor, a click on the pillar chooses ${await chosen()}`);
        await page.click('[aria-label="Hide Pillar"]');
        expect((await chosen()) === 'nothing', `without both, a click on the pillar chooses ${await chosen()}`);
        await page.click('[aria-label="Hide Floor"]');
        expect((await chosen()) === 'Floor', `without the pillar, a click on it chooses ${await chosen()}`);
    },
    'a file that is dropped is opened, and a wrong one is not': async () => {
        const drop = (name, text) => page.evaluate(([fileName, content]) => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([content], fileName));
            const event = (type) => new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true });
            const stage = document.getElementById('stage');
            stage.dispatchEvent(event('dragover'));
            return stage.dispatchEvent(event('drop')); // false, so that the browser does not go to the file
        }, [name, text]);
        await startFrom('empty');
        const isLeft = await drop('dropped.json', '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0] }, "points": [{ "position": [0, 0, 0], "reach": 1 }] }');
        await page.waitForFunction(() => document.querySelectorAll('#parts .part').length === 1);
        expect(!isLeft, 'the browser goes to the file');
        await drop('wrong.json', '{ "camera": 3 }');
        await page.waitForFunction(() => /^wrong.json: camera: must be/.test(document.getElementById('message-text').textContent));
        expect((await parts()).join() === 'Orb 1', `the list has ${await parts()}`);
    },
    'an orthographic camera comes closer, in the picture and in the file': async () => {
        const scene = { camera: { eye: [0, 0, 8], target: [0, 0, 0], projection: 'orthographic', height: 4 }, points: [{ position: [0, 0, 0], core: 0.2, reach: 1, color: [1, 1, 1] }] };
        await openFile(asFile('flat.json', JSON.stringify(scene)));
        await page.waitForFunction(() => document.querySelectorAll('#parts .part').length === 1);
        await rests();
        const far = await pagePng();
        await page.mouse.move(200, 200);
        await page.mouse.wheel(0, -400);
        await rests();
        const near = await pagePng();
        writeFileSync(`${folder}/saved.json`, await saved());
        expect(JSON.parse(readFileSync(`${folder}/saved.json`)).camera.height < 3, 'the file has the old height');
        expect(Math.max(...(await differences(far, near))) > 20, 'the picture has the old height');
        expect(Math.max(...(await differences(near, renderNatively(`${folder}/saved.json`)))) <= most, 'the file is another picture');
    },
    'the copied C compiles, and draws the same': async () => {
        await startFrom('portal');
        await page.click('#add-curve');
        await page.click('#add-line');
        await page.click('#add-medium');
        await page.click('#copy-c');
        await page.waitForFunction(() => /C code/.test(document.getElementById('message-text').textContent));
        writeFileSync(`${folder}/copied.h`, await page.evaluate(() => navigator.clipboard.readText()));
        const scene = await savedScene(), { points, lines, tori, curves, paths, media, ...rest } = scene;
        writeFileSync(`${folder}/saved.json`, JSON.stringify(scene));
        writeFileSync(`${folder}/rest.json`, JSON.stringify(rest));
        const libraries = execFileSync('sh', ['-c', 'pkg-config --libs jansson egl; pkg-config --libs osmesa || true'], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).split(/\s+/).filter(Boolean);
        execFileSync('cc', ['-std=c11', '-Wall', '-Wextra', '-Wpedantic', '-Werror', '-DEW_STATIC', '-Isrc', '-Idemo/support', `-I${folder}`, 'tests/web/copied_c.c', '-o', `${folder}/copied_c`,
            `${native}/demo/support/libew_demo_support.a`, `${native}/demo/support/libew_contexts.a`, `${native}/src/libenergywave.a`, ...libraries, '-lm'], { stdio: 'inherit' });
        execFileSync(`${folder}/copied_c`, [`${folder}/rest.json`, `${folder}/copied.png`, ...pngSize].map(String));
        const largest = Math.max(...(await differences(readFileSync(`${folder}/copied.png`), renderNatively(`${folder}/saved.json`))));
        expect(largest === 0, `the copied C is ${largest}/255 off`);
    },
    'a link holds the scene': async () => {
        await startFrom('bolt');
        await page.click('#copy-link');
        await page.waitForFunction(() => /link/.test(document.getElementById('message-text').textContent));
        const link = await page.evaluate(() => navigator.clipboard.readText()), scene = await savedScene();
        await startFrom('empty');
        await page.goto(link);
        await page.waitForFunction(() => document.querySelectorAll('#parts .part').length > 2);
        expect(JSON.stringify(await savedScene()) === JSON.stringify(scene), 'the link holds another scene');
        await page.goto(address);
        await rests();
    },
    'broken, foreign, huge and hostile files and links change nothing and say where they are wrong': async () => {
        await startFrom('empty');
        const before = JSON.stringify(await savedScene());
        const camera = '"camera": { "eye": [0, 0, 8], "target": [0, 0, 0] }';
        const bad = {
            'empty.json': ['', /line 1/], 'broken.json': ['{ "camera": ', /line 1/], 'picture.png': ['\x89PNG\r\n\x1a\n\0\0', /./], 'list.json': ['[1, 2]', /object/],
            'deep.json': [`${'['.repeat(1e5)}`, /line 1/], 'huge.json': [' '.repeat(5 << 20), /larger/],
            'prototype.json': [`{ ${camera}, "__proto__": { "polluted": 1 } }`, /__proto__/],
            'html.json': [`{ ${camera}, "points": [{ "name": "<img src=x onerror=alert(1)>", "position": [0, 0] }] }`, /points\[0\]\.position/],
            'reach.json': [`{ ${camera}, "paths": [{ "points": [[0, 0, 0], [1, 0, 0]], "core": 0.5, "reach": 0.1 }] }`, /paths\[0\]\.reach/],
            'many.json': [`{ ${camera}, "points": [${Array(32700).fill('{"position":[0,0,0],"reach":1}').join()}] }`, /./],
        };
        for (const [name, [text, where]] of Object.entries(bad)) {
            await page.evaluate(() => document.getElementById('close-message').click());
            await openFile({ name, mimeType: 'application/json', buffer: Buffer.from(text, 'latin1') });
            await page.waitForFunction(() => !document.getElementById('message').hidden);
            expect(where.test(await message()), `${name} is called ${(await message()).slice(0, 200)}`);
            expect(JSON.stringify(await savedScene()) === before, `${name} changed the scene`);
        }
        for (const code of ['!!', 'AAAA', 'A'.repeat(1e5), '']) {
            await page.evaluate(() => document.getElementById('close-message').click());
            await page.evaluate((hash) => (location.hash = hash), `#scene=${code}`);
            await page.waitForFunction(() => !document.getElementById('message').hidden);
            expect(JSON.stringify(await savedScene()) === before, `the link ${code.slice(0, 10)} changed the scene`);
        }
        await page.goto(address);
        await rests();
    },
    'names from files are text, in the list and in C': async () => {
        const name = '<img src=x onerror=alert(1)> */ int x; //';
        await openFile(asFile('named.json', JSON.stringify({ camera: { eye: [0, 0, 8], target: [0, 0, 0] }, points: [{ name, position: [0, 0, 0], reach: 1 }] })));
        await page.waitForFunction((wanted) => [...document.querySelectorAll('#parts .part')].some((part) => part.textContent === wanted), name);
        expect((await page.locator('#parts img').count()) === 0, 'a name became HTML');
        await page.click('#copy-c');
        await page.waitForFunction(() => /C code/.test(document.getElementById('message-text').textContent));
        const code = await page.evaluate(() => navigator.clipboard.readText());
        expect(!code.includes('int x;'), 'a name became C');
    },
    'a lost context comes back': async () => {
        await startFrom('empty');
        const before = faults.length;
        await page.evaluate(() => document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext());
        await page.waitForFunction(() => !document.getElementById('loading').hidden);
        await rests();
        expect((await savedScene()).opaque.length === 2, 'the scene is gone');
        faults.length = before; // without the browser's own warning of the loss
    },
    'where there are no float textures it says so': async () => {
        const bare = await browser.newPage();
        await bare.addInitScript(hideExtension, 'EXT_color_buffer_float');
        await bare.goto(address);
        await bare.waitForFunction(() => /^This GPU cannot draw to float textures/.test(document.getElementById('loading-text').textContent));
        expect(await bare.isVisible('#loading-text'), 'the sentence is not to be seen');
        await bare.close();
    },
    'split screen and maps': async () => {
        await startFrom('beam-struggle');
        await page.evaluate(() => (document.getElementById('how-section').open = true));
        await page.check('#split');
        await rests();
        expect(await page.isVisible('#split-line'), 'nothing is split');
        await look('split');
        await page.uncheck('#split');
        await page.selectOption('#map', '1');
        await rests();
        await page.waitForFunction(() => /evaluations a pixel/.test(document.getElementById('map-text').textContent));
        await look('cost');
        await page.selectOption('#map', '0');
        await page.setViewportSize({ width: 560, height: 300 }); // the map of errors is slow
        await startFrom('empty');
        await page.click('#add-orb');
        await page.selectOption('#map', '2');
        await page.waitForFunction(() => /largest error/.test(document.getElementById('map-text').textContent));
        await rests();
        await look('error');
        const [largest, most] = (await page.textContent('#map-text')).match(/[\d.]+e[-+]\d+/g).map(Number);
        expect(largest > 0 && largest < 1e-2 && most <= 1e-3, `the errors are ${largest} and ${most}`);
        await page.selectOption('#map', '0');
        await page.setViewportSize(viewport);
        await rests();
    },
    'text has the contrast of WCAG AA': async () => {
        await page.locator('#parts .part').first().click();
        await page.evaluate(() => document.querySelectorAll('details').forEach((details) => (details.open = true)));
        const poor = await page.evaluate(() => {
            const channels = (color) => color.match(/[\d.]+/g).map(Number);
            const linear = (x) => (x / 255 <= 0.04045 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4);
            const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
            const ground = (element) => {
                for (let one = element; one; one = one.parentElement) {
                    const color = channels(getComputedStyle(one).backgroundColor);
                    if (color.length === 3 || color[3] > 0.99) return color;
                }
                return [0, 0, 0];
            };
            return [...document.querySelectorAll('#panel *')].filter((element) => !element.disabled && element.checkVisibility() && [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim())).map((element) => {
                const [a, b] = [luminance(channels(getComputedStyle(element).color)), luminance(ground(element))].sort((x, y) => y - x);
                return [element.textContent.trim().slice(0, 30), (a + 0.05) / (b + 0.05)];
            }).filter(([, ratio]) => ratio < 4.5);
        });
        expect(poor.length === 0, `too little contrast: ${JSON.stringify(poor)}`);
    },
    'a fine screen gets all its pixels, after any change of size, and what is under the pointer is chosen and moved': async () => {
        const fine = await open(`${folder}/fine`, { viewport: { width: 720, height: 400 }, deviceScaleFactor: 2 });
        try {
            page = fine.page;
            await page.waitForFunction(() => document.getElementById('loading').hidden);
            await startFrom('empty');
            await isSharp(2, 'at first');
            await page.setViewportSize({ width: 700, height: 401 }); // where it is no whole number of pixels high
            await isSharp(2, 'resized');
            const devtools = await fine.browser.newCDPSession(page);
            await devtools.send('Emulation.setDeviceMetricsOverride', { width: 700, height: 401, deviceScaleFactor: 1.25, mobile: false });
            await isSharp(1.25, 'on another screen');
            await page.setViewportSize({ width: 800, height: 440 });
            await devtools.send('Emulation.setDeviceMetricsOverride', { width: 800, height: 440, deviceScaleFactor: 2, mobile: false });
            await isSharp(2, 'back');
            await choosesAndMoves();
        } finally {
            await fine.browser.close();
            page = firstPage;
        }
    },
    'nothing comes from elsewhere, and nothing complains': async () => {
        const foreign = requests.filter((url) => !url.startsWith(address) && !/^(data|blob):/.test(url));
        expect(foreign.length === 0, `asked for ${foreign}`);
        expect(faults.length === 0, faults.join('\n'));
    },
};

let failures = 0;
for (const [name, test] of Object.entries(tests)) {
    const start = performance.now();
    try {
        await test();
        console.log(`ok   ${name} (${Math.round(performance.now() - start)} ms)`);
    } catch (error) {
        failures++;
        await look('failed').catch(() => {});
        console.log(`FAIL ${name}: ${error.message}`);
    }
}
await browser.close();
server.close();
process.exit(failures > 0 ? 1 : 0);
