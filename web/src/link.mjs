// A link that holds a scene: its text, deflated, behind the #, which browsers do not send to servers.
const mark = '#scene=';
const mostCharacters = 1 << 16; // of the link: more than chats and browsers pass on
const mostBytes = 1 << 22; // of the scene; a small link could hold gigabytes otherwise

async function throughStream(bytes, stream) {
    const writer = stream.writable.getWriter();
    // What fails here fails below, too.
    writer.write(bytes).catch(() => {});
    writer.close().catch(() => {});
    const parts = [];
    let size = 0;
    for (const reader = stream.readable.getReader(); ;) {
        const { value, done } = await reader.read();
        if (done) break;
        size += value.length;
        if (size > mostBytes) {
            await reader.cancel();
            throw new Error(`The link holds more than ${mostBytes >> 20} MiB, which no scene needs.`);
        }
        parts.push(value);
    }
    return new Uint8Array(await new Blob(parts).arrayBuffer());
}

export async function linkOf(text, page) {
    const bytes = await throughStream(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
    let binary = '';
    for (const byte of bytes) binary += String.fromCharCode(byte);
    const code = btoa(binary).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
    if (code.length > mostCharacters) throw new Error('The scene is too large for a link. Save it as a file instead.');
    return `${page.split('#')[0]}${mark}${code}`;
}

// Returns the text that a link holds, or undefined if it holds none.
export async function textOfLink(hash) {
    if (!hash.startsWith(mark)) return undefined;
    const code = hash.slice(mark.length);
    if (code.length > mostCharacters) throw new Error('The link is too long to hold a scene.');
    let binary;
    try {
        binary = atob(code.replace(/-/g, '+').replace(/_/g, '/'));
    } catch {
        throw new Error('The link holds no scene: it has characters that none has. Copy it once more, in full.');
    }
    try {
        const bytes = await throughStream(Uint8Array.from(binary, (c) => c.charCodeAt(0)), new DecompressionStream('deflate-raw'));
        return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    } catch (error) {
        if (/MiB/.test(error.message)) throw error;
        throw new Error('The link holds no scene: a part of it is missing or changed. Copy it once more, in full.');
    }
}
