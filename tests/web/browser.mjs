// Chromium with a page, served from this machine.
import { chromium } from 'playwright-core';
import { serve } from './serve.mjs';

const rasterisers = {
    swiftshader: ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
    llvmpipe: ['--use-gl=angle', '--use-angle=gl', '--ignore-gpu-blocklist'],
};

// What the page is to be drawn by, as the browser calls it.
const renderers = { swiftshader: /SwiftShader/, llvmpipe: /llvmpipe/ };

function renderer() {
    const gl = document.createElement('canvas').getContext('webgl2');
    const info = gl?.getExtension('WEBGL_debug_renderer_info');
    return info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : 'nothing';
}

// To be run in a page: takes an extension of WebGL 2 away from contexts that are made from then on.
export function hideExtension(extension) {
    const { getExtension, getSupportedExtensions } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getExtension = function (name) {
        return name === extension ? null : getExtension.call(this, name);
    };
    WebGL2RenderingContext.prototype.getSupportedExtensions = function () {
        return getSupportedExtensions.call(this).filter((name) => name !== extension);
    };
}

// Opens a page in a browser that draws by `rasteriser`, with a profile of its own in `folder`. Needs a display, since Chromium draws
// by llvmpipe only to a window. `options` are Playwright's.
export async function launch(rasteriser, folder, address, options = {}) {
    const browser = await chromium.launchPersistentContext(`${folder}/profile-${rasteriser}`, {
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        headless: false,
        // Chromium refuses to run as root with a sandbox.
        args: [...rasterisers[rasteriser], ...(process.getuid() === 0 ? ['--no-sandbox'] : [])],
        ...options,
    });
    const page = browser.pages()[0];
    page.on('console', (message) => console.log(`${rasteriser}: ${message.text()}`));
    page.on('pageerror', (error) => console.log(`${rasteriser}: ${error}`));
    await page.goto(address);
    const found = await page.evaluate(renderer);
    if (renderers[rasteriser].test(found)) return { page, browser };
    await browser.close();
    throw new Error(`Chromium draws by ${found} rather than by ${rasteriser}`);
}

// Opens page.html. `files` maps names to paths.
export async function open(rasteriser, folder, files) {
    const server = await serve((path) => files[path.slice(1)], 0);
    const { page, browser } = await launch(rasteriser, folder, `http://127.0.0.1:${server.address().port}/page.html`);
    const close = async () => {
        await browser.close();
        server.close();
    };
    return { page, close };
}
