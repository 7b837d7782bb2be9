// docs/scene.schema.json and ew-render agree on every file: what one takes, the other takes. A schema cannot hold two numbers against
// each other, nor count an effect's memory; for these faults, which are listed here, ew-render is the judge.
// Usage: schema.mjs SCHEMA EW_RENDER FOLDER SCENES...; the last are folders of scene files, good and bad
import Ajv from 'ajv';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';

const [schemaPath, ewRender, folder, ...sceneFolders] = process.argv.slice(2);
const validate = new Ajv({ strictTypes: false, strictRequired: false }).compile(JSON.parse(readFileSync(schemaPath)));

const notOfSchemas = [
    /must not be where the camera's eye is/, /must not point along the view/, /must be more than (near|start|the radius of the core)/,
    /must not be beyond the camera's far plane/, /must be larger than min/, /must grow from its first number/, /must be 3 n \+ 1 points/,
    /must have \d+ elements at most/, /must not lie in a plane/, /reach: must be more/, /line \d+, column \d+/, /is UTF-16/, /^(?!.*(is not a key|is missing)).*: (sources|points|lines|tori|curves|paths|frame|view|projection|interval|decay)\b/,
];

// Good scenes with one thing wrong, at every place of each: no such key, nothing, a wrong type.
function* mutations(value, path = []) {
    if (value === null || typeof value !== 'object') return;
    if (!Array.isArray(value)) yield [[...path, 'nokey'], 1];
    for (const key of Object.keys(value)) {
        for (const wrong of [undefined, 'text', -1]) yield [[...path, key], wrong];
        yield* mutations(value[key], [...path, key]);
    }
}

function mutated(scene, [path, wrong]) {
    const copy = structuredClone(scene);
    const parent = path.slice(0, -1).reduce((object, key) => object[key], copy);
    if (wrong === undefined && Array.isArray(parent)) parent.splice(path.at(-1), 1);
    else if (wrong === undefined) delete parent[path.at(-1)];
    else parent[path.at(-1)] = wrong;
    return copy;
}

// A scene with every kind of source and shape, in which each mutation is tried.
const everything = {
    version: 1, comment: 'all there is', camera: { eye: [0, 1, 8], target: [0, 0, 0], up: [0, 1, 0], projection: 'perspective', fov_y_degrees: 45, near: 0.1, far: 50 },
    epsilon: 0.001, core_pixels: 1, exposure: 1, light: { gain: 2, reach: 3, shadow_thickness: 0.5 }, fog: { extinction: 0.1, height: { base: 1, scale: 2, up: [0, 1, 0] } }, background: [0, 0, 0], color: [1, 1, 1], composite: 'soft',
    media: [{ shape: 'box', name: 'smoke', min: [0, 0, 0], max: [1, 1, 1], extinction: 1, albedo: 0.5, ambient: [1, 1, 1] }, { shape: 'sphere', center: [0, 0, 0], radius: 1, extinction: 1 },
        { shape: 'ellipsoid', center: [0, 0, 0], radii: [1, 2, 3], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], extinction: 1 }],
    points: [{ name: 'orb', position: [0, 0, 0], brightness: 1, core: 0.1, reach: 1, sharpness: 2, color: [1, 0, 0] }],
    lines: [{ position: [0, 0, 0], direction: [1, 0, 0], coefficient: 1, reach: 1 }], tori: [{ center: [0, 0, 0], axis: [0, 1, 0], radius: 1, reach: 1 }],
    curves: [{ control_points: [[0, 0, 0], [1, 1, 0], [2, 0, 0]], domain: [0, 1], weights: [1, 0.5], reach: 1 }, { polynomial: [[0, 0, 0], [1, 1, 0], [2, 0, 0]], reach: 1 }],
    paths: [{ kind: 'bezier', points: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], closed: false, weights: [1], reach: 1 }],
    opaque: [{ shape: 'box', name: 'b', min: [0, 0, 0], max: [1, 1, 1], color: [1, 1, 1] }, { shape: 'plane', point: [0, 0, 0], normal: [0, 1, 0] }, { shape: 'sphere', center: [0, 0, 0], radius: 1 }],
};
const papers = { camera: { eye: [0, 1, 8], target: [0, 0, 0], projection: 'orthographic', height: 3, near: 0.1, far: 20 }, interval: { start: 1, end: 15 }, decay: { alpha: 1, beta: 1 }, points: [{ position: [0, 0, 0] }] };

function* files(path) {
    if (statSync(path).isDirectory()) for (const name of readdirSync(path)) yield* files(`${path}/${name}`);
    else yield path;
}

mkdirSync(folder, { recursive: true });
const counts = { taken: 0, refused: 0, 'refused by ew-render alone': 0 };
let failures = 0;

function verdictOfSchema(bytes) {
    try {
        return validate(JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes)));
    } catch {
        return false;
    }
}

function check(path, name) {
    const { status, stderr } = spawnSync(ewRender, [path, '-o', `${folder}/drawn.png`, '--size', '1x1'], { encoding: 'utf8' });
    const takes = status === 0, schemaTakes = verdictOfSchema(readFileSync(path));
    const isRelation = !takes && schemaTakes && notOfSchemas.some((fault) => fault.test(stderr));
    counts[takes ? 'taken' : isRelation ? 'refused by ew-render alone' : 'refused']++;
    if (takes === schemaTakes || isRelation) return;
    failures++;
    console.log(`FAIL ${name}: ${takes ? `the schema refuses it: ${JSON.stringify(validate.errors?.slice(-2).map(({ instancePath, message }) => [instancePath, message]))}` : `the schema takes it, but ${stderr.trim()}`}`);
}

for (const sceneFolder of sceneFolders) for (const path of files(sceneFolder)) check(path, path);
for (const scene of [everything, papers])
    for (const mutation of mutations(scene)) {
        writeFileSync(`${folder}/mutated.json`, JSON.stringify(mutated(scene, mutation)));
        check(`${folder}/mutated.json`, `${mutation[0].join('.')} = ${JSON.stringify(mutation[1])}`);
    }
console.log(`${failures ? 'FAIL' : 'ok  '} schema: ${Object.entries(counts).map(([what, count]) => `${count} ${what}`).join(', ')}`);
process.exit(failures > 0 || counts.taken < 50 || counts.refused < 50 ? 1 : 0);
