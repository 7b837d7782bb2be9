// Keeps the document over a reload.
import { app } from './app.mjs';
import { court } from './court.mjs';
import { store } from './storage.mjs';

const stillMilliseconds = 300;
let timer;

function keepNow() {
    if (!court.isShown) store(app.history.current, app.camera.place);
}

// Stores the document, once it has been still for a moment.
function keep() {
    clearTimeout(timer);
    timer = setTimeout(keepNow, stillMilliseconds);
}

app.history.onChange(keep);
app.on('move', keep);
addEventListener('pagehide', keepNow);
