// Serves static files to this machine.
// Usage: serve.mjs FOLDER
import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

const types = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.json': 'application/json' };
const firstPort = 8017, lastPort = 8099;

// The file of a folder that a path means.
export const inFolder = (folder) => (path) => join(folder, normalize(path.endsWith('/') ? `${path}index.html` : path));

// `fileOf` finds the file of a path that is asked for.
export function serve(fileOf, port) {
    const server = createServer(async (request, response) => {
        try {
            const file = fileOf(decodeURIComponent(new URL(request.url, 'http://127.0.0.1').pathname));
            if (!(await stat(file)).isFile()) throw new Error('no file');
            response.writeHead(200, { 'Content-Type': types[extname(file)] ?? 'application/octet-stream', 'Cache-Control': 'no-cache' });
            createReadStream(file).pipe(response);
        } catch {
            response.writeHead(404).end();
        }
    });
    return new Promise((resolve, reject) => server.once('error', reject).listen(port, '127.0.0.1', () => resolve(server)));
}

async function serveAnywhere(folder) {
    for (let port = firstPort; port <= lastPort; port++) {
        try {
            return await serve(inFolder(folder), port);
        } catch (error) {
            if (error.code !== 'EADDRINUSE') throw error;
        }
    }
    throw new Error(`The ports ${firstPort} to ${lastPort} are all taken.`);
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
    const server = await serveAnywhere(process.argv[2]);
    console.log(`The page is at http://127.0.0.1:${server.address().port}/ until Ctrl+C.`);
}
