// Files to and from the user's disk.
const mostBytes = 4 << 20;

export async function textOfFile(file) {
    if (file.size > mostBytes) throw new Error(`${file.name}: is larger than ${mostBytes >> 20} MiB, which no scene needs.`);
    try {
        return new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
    } catch {
        throw new Error(`${file.name}: is no text in UTF-8, as scene files are.`);
    }
}

// Lets the user choose a file, if they do.
export function chooseFile(accept, take) {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = accept;
    input.addEventListener('change', () => input.files[0] && take(input.files[0]));
    input.click();
}

export function download(blob, name) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
