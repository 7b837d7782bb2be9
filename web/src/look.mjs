// Controls of the whole picture, and of how it is computed.
import { checkbox, color, select, slider } from './controls.mjs';
import { withScene } from './scene.mjs';

function setFog(scene, extinction) {
    if (extinction > 0) scene.fog = { ...scene.fog, extinction };
    else delete scene.fog;
}

// Where there is no fog, nothing can thin out.
function setFogHeight(scene, scale) {
    if (!scene.fog) return;
    if (scale > 0) scene.fog.height = { ...scene.fog.height, scale };
    else delete scene.fog.height;
}

export function lookControls(app) {
    const { history } = app;
    const scene = () => history.current.scene;
    const change = (make, isFinal) => history[isFinal ? 'commit' : 'preview'](withScene(history.current, make));
    const set = (key) => (value, isFinal) => change((changed) => (changed[key] = value), isFinal);
    return [
        select({ id: 'composite', label: 'Composite', options: [['soft', 'soft: never clips'], ['add', 'add'], ['lerp', "lerp: the papers'"]],
            get: () => scene().composite ?? 'lerp', set: set('composite') }),
        slider({ id: 'exposure', label: 'Exposure', unit: '×', min: 0.05, max: 10, log: true, get: () => scene().exposure ?? 1, set: set('exposure') }),
        slider({ id: 'core-pixels', label: 'Least core', unit: 'pixels', min: 0, max: 8, get: () => scene().core_pixels ?? (scene().interval ? 0 : 1.5),
            set: (value, isFinal) => change((changed) => (changed.core_pixels = Math.min(Math.max(value, 0), 64)), isFinal) }),
        slider({ id: 'fog', label: 'Fog', unit: 'per unit', min: 0, max: 1, get: () => scene().fog?.extinction ?? 0,
            set: (value, isFinal) => change((changed) => setFog(changed, Math.min(Math.max(value, 0), 1e12)), isFinal) }),
        slider({ id: 'fog-height', label: 'It thins out over', unit: 'units up, 0: never', min: 0, max: 20, get: () => scene().fog?.height?.scale ?? 0,
            set: (value, isFinal) => change((changed) => setFogHeight(changed, value), isFinal) }),
        color({ id: 'background', label: 'Background', get: () => scene().background ?? [0, 0, 0], set: set('background') }),
        ...(scene().camera.projection === 'orthographic' ? [] : [
            slider({ id: 'fov', label: 'Field of view', unit: 'degrees', min: 5, max: 120, get: () => scene().camera.fov_y_degrees ?? 45,
                set: (value, isFinal) => change((changed) => (changed.camera.fov_y_degrees = Math.min(Math.max(value, 1), 179)), isFinal) })]),
    ];
}

// `how` is what is shown, changed in place: it belongs to the page, not to the document.
export function howControls(how, changed) {
    const set = (key, make = (value) => value) => (value) => {
        how[key] = make(value);
        changed();
    };
    return [
        select({ id: 'integrator', label: 'Integrator', options: [['adaptive', 'adaptive'], ['simpson', "Simpson's rule"]], get: () => how.integrator, set: set('integrator') }),
        select({ id: 'quality', label: 'Quality', options: [[0, 'error 1e-2'], [1, 'error 1e-3'], [2, 'error 1e-4']], get: () => how.quality, set: set('quality', Number) }),
        slider({ id: 'divisions', label: 'Divisions', unit: '', min: 2, max: 1024, log: true, get: () => how.divisions,
            set: set('divisions', (value) => 2 * Math.min(Math.max(Math.round(value / 2), 1), 2048)) }),
        checkbox({ id: 'split', label: 'Split screen', get: () => how.split, set: set('split') }),
        select({ id: 'map', label: 'Show', options: [[0, 'the picture'], [1, 'cost map'], [2, 'error map (slow)']], get: () => how.map, set: set('map', Number) }),
    ];
}
