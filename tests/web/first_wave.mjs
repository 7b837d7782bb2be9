// Writes docs/first-wave.md: does each of its steps on the page as the text says, checks what comes of it, and takes its picture.
// Usage: first_wave.mjs SITE DOCS SCRATCH
import { mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { launch } from './browser.mjs';
import { inFolder, serve } from './serve.mjs';

const [site, docs, scratch] = process.argv.slice(2);
const name = 'first-wave', mostBytes = 150e3;
const markMargin = 5; // pixels around what a picture marks

rmSync(scratch, { recursive: true, force: true });
mkdirSync(scratch, { recursive: true });
mkdirSync(`${docs}/${name}`, { recursive: true });
const server = await serve(inFolder(site), 0);
const { page, browser } = await launch('swiftshader', scratch, `http://127.0.0.1:${server.address().port}/`, { viewport: { width: 960, height: 600 } });
page.setDefaultTimeout(60000);

function expect(condition, what) {
    if (!condition) throw new Error(what);
}

const rests = () => page.waitForFunction(() => document.getElementById('stage').getAttribute('aria-busy') === 'false' && document.getElementById('loading').hidden);

async function savedScene() {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save')]);
    return JSON.parse(readFileSync(await download.path()));
}

// Drags what is at a place of the window by so many pixels.
async function drag({ x, y }, right, down) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + right, y + down, { steps: 5 });
    await page.mouse.up();
}

// The middle of an element, once the panel has brought it into view.
async function middleOf(locator) {
    await locator.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await locator.boundingBox();
    return { x: x + width / 2, y: y + height / 2 };
}

async function setNumber(id, value) {
    await page.fill(`#${id}-number`, value);
    await page.keyboard.press('Tab');
    expect((await page.inputValue(`#${id}-number`)) === value, `${id} did not take ${value}`);
}

// The box of an element, as a mark in a picture.
const around = (selector) => async () => {
    const locator = page.locator(selector).first();
    await locator.scrollIntoViewIfNeeded();
    return locator.boundingBox();
};

const pillar = { x: 318, y: 320 };
let endOfSpiral; // where its last handle is seen

const steps = [
    { title: 'Begin with an empty floor', text: 'Run `./run web`, and open the address that it prints. In **Start from**, choose *An empty floor*. There are a floor and a pillar, and no light. From now on, this is your own scene.',
        async act() {
            await page.selectOption('#start', 'empty');
            await page.waitForFunction(() => document.querySelectorAll('#parts .part').length === 2);
        }, mark: around('#start') },
    { title: 'Choose the pillar', text: 'Click on the pillar. The panel now says *Pillar*.',
        async act() {
            await page.mouse.click(pillar.x, pillar.y);
            expect((await page.textContent('#selected-title')) === 'Pillar', 'a click on the pillar does not choose it');
        }, mark: async () => ({ x: pillar.x - 8, y: pillar.y - 8, width: 16, height: 16 }) },
    { title: 'Add a spiral', text: 'Press **+ Spiral**. It winds round what is chosen, and is then chosen itself: white rings are its points.',
        async act() {
            await page.click('#add-spiral');
            expect((await page.textContent('#selected-title')) === 'Path 1', 'the spiral is not chosen');
        }, mark: around('#add-spiral') },
    { title: 'Name and colour it', text: 'In **Name**, write `Coil`. Click on **Colour** and choose an orange, such as `#ff8a3c`.',
        async act() {
            await page.fill('#name', 'Coil');
            await page.keyboard.press('Tab');
            await page.fill('#color', '#ff8a3c');
            expect((await page.textContent('#selected-title')) === 'Coil', 'the name is not taken');
        }, mark: around('#color') },
    { title: 'Make it thin', text: 'Set **Core** to 0.012, by its slider or as a number. This is the radius of the bright middle, in units of the scene: the pillar is 3 units high.',
        act: () => setNumber('core', '0.012'), mark: around('#core-number') },
    { title: 'Keep it close', text: 'Set **Reach** to 0.3, the distance at which the light ends. Now the turns are apart from each other.',
        act: () => setNumber('reach', '0.3'), mark: around('#reach-number') },
    { title: 'Let it fly off', text: 'Drag the highest ring, the last point of the spiral, to the upper right. It moves in the plane of the picture, and the end of the beam follows. (**Drag along** would keep it on an axis.)',
        async act() {
            endOfSpiral = await middleOf(page.locator('circle.handle').last());
            await drag(endOfSpiral, 190, -60);
            endOfSpiral.x += 190;
            endOfSpiral.y -= 60;
        }, mark: async () => ({ x: endOfSpiral.x - 8, y: endOfSpiral.y - 8, width: 16, height: 16 }) },
    { title: 'Let it grow', text: 'Press **Vary along the path**. The curve that appears is the brightness along the beam, from its beginning on the left to its end. Drag the left dot to the bottom, and the right dot to the top: the light grows from nothing, and is twice as bright where it ends.',
        async act() {
            await page.click('#add-weights');
            const knobs = page.locator('svg.weights circle');
            await drag(await middleOf(knobs.first()), 0, 80);
            await drag(await middleOf(knobs.last()), 0, -80);
        }, mark: around('svg.weights') },
    { title: 'Look at it from elsewhere', text: 'Press **Look at**, which brings all of the beam into the middle. Drag the dark beside it to the left and a little down, to see it from the right and from above. Then press Escape, which hides the rings. Light looks right from every side, and the pillar hides what is behind it.',
        async act() {
            await page.click('#focus');
            await drag({ x: 100, y: 480 }, -60, 20);
            await page.keyboard.press('Escape');
            expect(await page.isHidden('#selected'), 'Escape leaves something chosen');
        } },
    { title: 'Take it along', text: 'Press **Save**. The file is a [scene](scene-format.md): `build/demo/ew-demo scene.json` shows it in a window, where it can be changed further, and `build/demo/ew-render scene.json -o wave.png` draws it. **Copy as C** copies the same for your own game.',
        async act() {
            const { paths: [coil], camera } = await savedScene();
            writeFileSync(`${scratch}/scene.json`, JSON.stringify({ coil, camera }));
            expect(coil.name === 'Coil' && coil.core === 0.012 && coil.reach === 0.3, 'the file has another core or reach');
            expect(coil.color[0] > 3 * coil.color[2], 'the file has another colour');
            expect(coil.points.at(-1)[0] > 1.5 && coil.points.at(-1)[1] > 3, 'the end of the spiral was not moved');
            expect(coil.weights[0] === 0 && coil.weights.at(-1) === 2, `the weights are ${coil.weights}`);
            expect(camera.eye[0] > 0.3, 'the camera did not turn');
        }, mark: around('#save') },
];

// A ring around what the step uses.
async function showMark(box) {
    await page.evaluate(([box, margin]) => {
        const mark = document.body.appendChild(document.createElement('div'));
        mark.id = 'mark';
        Object.assign(mark.style, { position: 'fixed', zIndex: 10, pointerEvents: 'none', border: '3px solid #ffd24a', borderRadius: '10px', boxSizing: 'border-box',
            left: `${box.x - margin}px`, top: `${box.y - margin}px`, width: `${box.width + 2 * margin}px`, height: `${box.height + 2 * margin}px` });
    }, [box, markMargin]);
}

async function takePicture(path, mark) {
    const box = await mark?.();
    await page.mouse.move(2, 2); // away from what it would light up
    await rests(); // until the picture is drawn with all its pixels
    if (box) await showMark(box);
    await page.screenshot({ path, type: 'jpeg', quality: 84 });
    await page.evaluate(() => document.getElementById('mark')?.remove());
    expect(statSync(path).size < mostBytes, `${path} has ${statSync(path).size} bytes`);
}

// Breaks a line at its spaces, so that it is no wider than the pages.
const wrapped = (text) => text.replace(/(.{1,128})(?: |$)/g, '$1\n');

let text = `# Your first wave

Ten steps from a scene without light to a beam that spirals round a pillar, on the page for browsers. \`./run first-wave\` does every
step as it is written here, checks what comes of it, and takes the pictures anew.
`;
try {
    await page.waitForFunction(() => document.getElementById('loading').hidden); // the court moves, and never rests
    for (const [index, { title, text: what, act, mark }] of steps.entries()) {
        await act();
        await takePicture(`${docs}/${name}/${index + 1}.jpg`, mark);
        text += `\n## ${index + 1}. ${title}\n\n${wrapped(what)}\n![${title}](${name}/${index + 1}.jpg)\n`;
        console.log(`${index + 1}. ${title}`);
    }
    text += `
Undo takes back any step, also after all of them. [The page for artists](artists.md) shows what each parameter does, and **?** lists
the keys.
`;
    writeFileSync(`${docs}/${name}.md`, text);
} finally {
    await browser.close();
    server.close();
}
