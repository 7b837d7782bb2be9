// The document survives a reload, in the browser's local storage.
const key = 'energywave.document.1';

export function store(document, camera) {
    try {
        localStorage.setItem(key, JSON.stringify({ document, camera }));
        return true;
    } catch {
        return false; // full, or switched off
    }
}

// Returns what was stored last, or undefined.
export function restore() {
    try {
        return JSON.parse(localStorage.getItem(key)) ?? undefined;
    } catch {
        return undefined;
    }
}

export function forget() {
    try {
        localStorage.removeItem(key);
    } catch {
        // Then there is nothing to forget.
    }
}
