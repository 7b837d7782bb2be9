// A browser that draws by the rasteriser of that name, and what it is given: files by name. What it leaves behind, it leaves in
// `folder`.
import { chromium } from 'playwright-core';
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';

const rasterisers = {
    swiftshader: ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
    llvmpipe: ['--use-gl=angle', '--use-angle=gl', '--ignore-gpu-blocklist'],
};

const types = { html: 'text/html', js: 'text/javascript', mjs: 'text/javascript', wasm: 'application/wasm' };

// Serves the files of a table from names to paths.
async function serve(files) {
    const server = createServer(async (request, response) => {
        const name = request.url.slice(1);
        const text = files[name] && (await readFile(files[name]));
        response.writeHead(text ? 200 : 404, { 'Content-Type': types[name.split('.').pop()] ?? 'application/octet-stream' });
        response.end(text);
    });
    await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
    return server;
}

export async function open(rasteriser, folder, files) {
    const server = await serve(files);
    const context = await chromium.launchPersistentContext(`${folder}/profile-${rasteriser}`, {
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        headless: false,
        args: [...rasterisers[rasteriser], '--no-sandbox', '--disable-gpu-watchdog'],
    });
    const page = await context.newPage();
    page.on('console', (message) => console.log(`${rasteriser}: ${message.text()}`));
    page.on('pageerror', (error) => console.log(`${rasteriser}: ${error}`));
    await page.goto(`http://127.0.0.1:${server.address().port}/page.html`);
    const close = async () => {
        await context.close();
        server.close();
    };
    return { page, context, close };
}
