// Draws what is shown onto the canvas, when it has changed. While something moves, the picture has as many pixels as the machine draws
// smoothly; when it rests, all of them.
const smoothMilliseconds = 40, restMilliseconds = 250, leastScale = 0.15;

export class View {
    #scale = 0.3;
    #isDirty = true;
    #lastChange = 0;
    #stepsAtFirst = 0;
    #wasFull = false;
    #fence; // behind the last picture, until the GPU has drawn it
    #drawnAt = 0;
    #lastSize;

    // `sync(now)` tells the engine what to draw; returns whether it moves by itself. `report` gets progress, errors and pictures.
    constructor(canvas, stage, engine, sync, report) {
        Object.assign(this, { canvas, stage, engine, sync, report, isStopped: false });
        this.gl = canvas.getContext('webgl2'); // the engine's
        requestAnimationFrame((now) => this.#frame(now));
    }

    stop() {
        this.isStopped = true;
    }

    wake() {
        this.#isDirty = true;
        this.#lastChange = performance.now();
        this.report.changes();
    }

    // In pixels of the screen. They change with the zoom, and when the window goes to another screen, and no event says so.
    get size() {
        const { width, height } = this.stage.getBoundingClientRect();
        return [width, height].map((side) => Math.max(1, Math.round(side * devicePixelRatio)));
    }

    #frame(now) {
        if (this.isStopped) return;
        requestAnimationFrame((next) => this.#frame(next));
        if (!this.#isDone()) return;
        const moves = this.sync(now) && !document.hidden, size = this.size.join();
        if (moves || size !== this.#lastSize) this.wake();
        this.#lastSize = size;
        const rests = performance.now() - this.#lastChange > restMilliseconds;
        if (this.#isDirty || (rests && !this.#wasFull)) this.#draw(rests ? 1 : this.#scale, rests);
    }

    // Whether the GPU has drawn the last picture. Pictures that queue up would make the page slow to answer.
    #isDone() {
        const { gl } = this;
        if (!this.#fence) return true;
        if (gl.clientWaitSync(this.#fence.sync, 0, 0) === gl.TIMEOUT_EXPIRED) return false;
        gl.deleteSync(this.#fence.sync);
        if (!this.#fence.rests) this.#adapt(performance.now() - this.#drawnAt);
        this.report.drawn(this.#fence.rests && !this.#isDirty);
        this.#fence = undefined;
        return true;
    }

    #draw(scale, rests) {
        const [width, height] = this.size.map((side) => Math.max(1, Math.round(side * scale)));
        try {
            const steps = this.engine.prepare(width, height);
            if (steps > 0) {
                this.#stepsAtFirst = Math.max(this.#stepsAtFirst, steps);
                this.report.progress(1 - steps / (this.#stepsAtFirst + 1));
                return;
            }
            this.#stepsAtFirst = 0;
            this.#drawnAt = performance.now();
            this.engine.draw(width, height);
            if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
            this.engine.present();
            this.#fence = { sync: this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0), rests };
            this.gl.flush();
            this.#isDirty = false;
            this.#wasFull = rests || scale === 1;
        } catch (error) {
            this.#isDirty = false;
            this.#wasFull = true;
            this.report.failed(error);
        }
    }

    #adapt(milliseconds) {
        const wanted = this.#scale * Math.sqrt(smoothMilliseconds / Math.max(milliseconds, 1));
        this.#scale = Math.min(1, Math.max(leastScale, 0.5 * (this.#scale + wanted)));
    }
}
