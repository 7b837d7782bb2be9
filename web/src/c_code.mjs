// A scene as C, which compiles against energywave.h as it is.
import { polynomialOf } from './kinds.mjs';
import { sourceColor } from './scene.mjs';

const pathKinds = { polyline: 'EW_PATH_POLYLINE', bspline: 'EW_PATH_BSPLINE', bezier: 'EW_PATH_BEZIER', catmull_rom: 'EW_PATH_CATMULL_ROM' };
const outputs = { lerp: 'EW_OUTPUT_LERP', add: 'EW_OUTPUT_ADD', soft: 'EW_OUTPUT_SOFT' };

// All digits, and never an integer, which might be too large for C.
const number = (x) => (/[.e]/.test(String(x)) ? String(x) : `${x}.0`);
const list = (xs) => `{${xs.map(number).join(', ')}}`;
const vectors = (xs) => `{${xs.map(list).join(', ')}}`;

// A name of the user's, in a comment: nothing that could end the comment, or begin something else.
const comment = (name) => (name ? ` /* ${String(name).replace(/[^\w .,+-]/g, '?')} */` : '');

function light(source, scene) {
    const members = [];
    if (source.brightness === undefined) members.push(`.coefficient = ${number(source.coefficient ?? 1)}`);
    else members.push(`.brightness = ${number(source.brightness)}`);
    members.push(`.color = ${list(sourceColor(scene, source))}`);
    for (const key of ['core', 'reach', 'sharpness']) if (source[key] !== undefined) members.push(`.${key} = ${number(source[key])}`);
    return members;
}

// A medium as ew_medium has it: half axes around a center.
function medium(m) {
    const { extinction, albedo = 0, ambient = [1, 1, 1] } = m;
    const center = m.shape === 'box' ? m.min.map((least, i) => 0.5 * (least + m.max[i])) : m.center;
    const radii = m.shape === 'box' ? m.min.map((least, i) => 0.5 * (m.max[i] - least)) : m.radii ?? [m.radius, m.radius, m.radius];
    const axes = (m.axes ?? [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).map((axis, i) => axis.map((x) => radii[i] * x / Math.hypot(...axis)));
    return [`.shape = ${m.shape === 'box' ? 'EW_MEDIUM_BOX' : 'EW_MEDIUM_ELLIPSOID'}`, `.center = ${list(center)}`, `.half_axes = ${vectors(axes)}`,
        `.extinction = ${number(extinction)}`, `.albedo = ${number(albedo)}`, `.ambient = ${list(ambient)}`];
}

const kinds = {
    points: { type: 'ew_point', count: 'point_count', shape: (s) => [`.position = ${list(s.position)}`] },
    lines: { type: 'ew_line', count: 'line_count', shape: (s) => [`.position = ${list(s.position)}`, `.direction = ${list(s.direction)}`] },
    tori: { type: 'ew_torus', count: 'torus_count', shape: (s) => [`.center = ${list(s.center)}`, `.axis = ${list(s.axis)}`, `.radius = ${number(s.radius)}`] },
    curves: { type: 'ew_curve', count: 'curve_count', shape: (s) => [
        `.polynomial = ${vectors(s.control_points ? polynomialOf(s.control_points) : s.polynomial)}`, `.domain = ${list(s.domain ?? [0, 1])}`] },
    paths: { type: 'ew_path', count: 'path_count', shape: (s, i) => [
        `.kind = ${pathKinds[s.kind ?? 'polyline']}`, `.points = path_points_${i}`, `.point_count = ${s.points.length}`, ...(s.closed ? ['.is_closed = 1'] : [])] },
};

// Arrays that the structures of a list point to.
function arraysOf(key, sources) {
    const lines = [];
    sources.forEach((source, i) => {
        if (key === 'paths') lines.push(`static const double path_points_${i}[][3] = ${vectors(source.points)};`);
        if (source.weights) lines.push(`static const double ${key}_weights_${i}[] = ${list(source.weights)};`);
    });
    return lines;
}

export function cCode(scene) {
    const text = ['/* A scene of EnergyWave. Lengths are in the unit of your world, colours are linear RGB.',
        ' *', ' *     ew_set_sources(effect, &scene_sources, &error);',
        ' *     scene_set_frame(&frame);    after EW_FRAME_DEFAULTS, your camera and your target', ' */', '#include <energywave.h>', ''];
    const used = Object.entries(kinds).filter(([key]) => scene[key]?.length);
    for (const [key, { type, shape }] of used) {
        text.push(...arraysOf(key, scene[key]), `static const ${type} scene_${key}[] = {`);
        scene[key].forEach((source, i) => {
            const weights = source.weights ? [`.weights = ${key}_weights_${i}`, `.weight_count = ${source.weights.length}`] : [];
            text.push(`    {${[...shape(source, i), ...weights, ...light(source, scene)].join(',\n     ')}},${comment(source.name)}`);
        });
        text.push('};', '');
    }
    if (scene.media?.length)
        text.push('static const ew_medium scene_media[] = {',
            ...scene.media.map((m) => `    {${medium(m).join(',\n     ')}},${comment(m.name)}`), '};', '');
    text.push('static const ew_sources_desc scene_sources = {',
        ...used.map(([key, { count }]) => `    .${key} = scene_${key},\n    .${count} = sizeof scene_${key} / sizeof *scene_${key},`),
        `    .epsilon = ${number(scene.epsilon ?? 1e-3)},`, '};', '',
        'static inline void scene_set_frame(ew_frame_desc *frame)', '{',
        `    frame->output = ${outputs[scene.composite ?? 'lerp']};`, `    frame->exposure = ${number(scene.exposure ?? 1)};`);
    if (scene.core_pixels !== undefined) text.push(`    frame->core_pixels = ${number(scene.core_pixels)};`);
    if (scene.light)
        text.push(`    frame->light_gain = ${number(scene.light.gain ?? 1)};`, `    frame->light_reach = ${number(scene.light.reach)};`,
            `    frame->shadow_thickness = ${number(scene.light.shadow_thickness ?? 0)};`);
    if (scene.fog) {
        const { base = 0, scale = 0, up = [0, 1, 0] } = scene.fog.height ?? {};
        text.push(`    frame->fog = (ew_fog){.extinction = ${number(scene.fog.extinction)}, .up = ${list(up)}, ` +
            `.base = ${number(base)}, .scale = ${number(scale)}};`);
    }
    if (scene.media?.length)
        text.push('    frame->media = scene_media;', '    frame->medium_count = sizeof scene_media / sizeof *scene_media;');
    if (scene.interval) {
        const near = scene.camera.near ?? 0.1, far = scene.camera.far ?? 100;
        text.push(`    frame->interval_start = ${number(scene.interval.start ?? near)};`, `    frame->interval_end = ${number(scene.interval.end ?? far)};`,
            `    frame->decay_alpha = ${number(scene.decay?.alpha ?? 1)};`, `    frame->decay_beta = ${number(scene.decay?.beta ?? 1)};`);
    }
    return `${text.join('\n')}\n}\n`;
}
