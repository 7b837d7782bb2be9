// The moving court, which the page shows until there is a document.
import { app } from './app.mjs';

const begins = 3.4; // seconds: when much is going on

export const court = {
    isShown: true,
    isPlaying: true,
    hasOwnCamera: false, // the user's, not the court's
    seconds: begins,

    begin() {
        Object.assign(court, { isShown: true, isPlaying: true, hasOwnCamera: false });
        app.selection = undefined;
        app.tell('change');
    },
    // Has the engine draw this moment.
    send() {
        app.engine.showCourt(court.seconds);
        if (court.hasOwnCamera) app.engine.setCamera(app.camera);
    },
    // Takes the court's camera over, before the user moves it.
    takeCamera() {
        if (!court.isShown || court.hasOwnCamera) return;
        app.engine.showCourt(court.seconds);
        app.camera.set(JSON.parse(app.engine.write()).camera);
    },
};

app.on('move', () => {
    if (court.isShown) court.hasOwnCamera = true;
});
