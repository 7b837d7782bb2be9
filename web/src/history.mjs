// What can be undone: snapshots of the document, which nobody changes once they are made. A drag previews many, and commits one.
// A document that `accepts` refuses changes nothing.
export class History {
    #past = [];
    #future = [];
    #committed;
    #listeners = [];

    #accepts;

    constructor(document, accepts) {
        this.#accepts = accepts;
        this.#committed = document;
        this.current = document;
    }

    onChange(listener) {
        this.#listeners.push(listener);
    }

    #show(document) {
        this.current = document;
        for (const listener of this.#listeners) listener(document);
    }

    preview(document) {
        if (!this.#accepts(document)) return false;
        this.#show(document);
        return true;
    }

    commit(document = this.current) {
        if (document === this.#committed) return true;
        if (!this.#accepts(document)) {
            this.revert();
            return false;
        }
        this.take(document);
        return true;
    }

    // Commits a document that was accepted elsewhere.
    take(document) {
        this.#past.push(this.#committed);
        this.#future = [];
        this.#committed = document;
        this.#show(document);
    }

    // Shows what was committed last again.
    revert() {
        this.#accepts(this.#committed);
        this.#show(this.#committed);
    }

    #step(from, to) {
        if (from.length === 0) return false;
        to.push(this.#committed);
        this.#committed = from.pop();
        this.#accepts(this.#committed);
        this.#show(this.#committed);
        return true;
    }

    undo() {
        return this.#step(this.#past, this.#future);
    }

    redo() {
        return this.#step(this.#future, this.#past);
    }

    get canUndo() {
        return this.#past.length > 0;
    }

    get canRedo() {
        return this.#future.length > 0;
    }
}
