// Puts the page together, and begins.
import { actions } from './actions.mjs';
import { app } from './app.mjs';
import { at } from './controls.mjs';
import { beginDrawing } from './drawing.mjs';
import { whatIsMissing } from './engine.mjs';
import './keeping.mjs';
import { listKeys, shortcuts, watchKeys } from './keys.mjs';
import { openLink, restoreLast } from './opening.mjs';
import { buildStage } from './stage.mjs';
import { buildTools } from './tools.mjs';

async function main() {
    const missing = whatIsMissing();
    if (missing) {
        at('progress').hidden = true;
        at('loading-text').textContent = missing;
        return;
    }
    const rows = shortcuts(actions);
    buildStage();
    buildTools();
    listKeys(at('keys-table'), rows);
    watchKeys(rows);
    await beginDrawing();
    if (!(await openLink())) restoreLast();
    app.tell('change');
}

main();
