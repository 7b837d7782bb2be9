// Scenes to start from.
export const starts = [['court', 'The court, moving'], ['hall', 'The court, without light'], ['empty', 'An empty floor'], ['bolt', 'Bolt'], ['slash', 'Slash'],
    ['shield', 'Shield'], ['portal', 'Portal'], ['aura', 'Aura'], ['beam-struggle', 'Beam struggle'], ['orb-and-beam', 'Orb and beam']];

const emptyScene = {
    version: 1,
    camera: { eye: [0, 2.2, 7], target: [0, 1.2, 0], up: [0, 1, 0], fov_y_degrees: 40, near: 0.05, far: 120 },
    background: [0.004, 0.006, 0.012],
    composite: 'soft',
    opaque: [{ shape: 'plane', name: 'Floor', point: [0, 0, 0], normal: [0, 1, 0], color: [0.08, 0.085, 0.1] },
        { shape: 'box', name: 'Pillar', min: [-0.35, 0, -2.35], max: [0.35, 3, -1.65], color: [0.2, 0.2, 0.22] }],
};

const courtNames = { points: ['Orb', 'Impact'], tori: ['Shock ring'], paths: ['Bolt', 'Branch', 'Stream', 'Spiral', 'Slash', 'Beam'] };

const courtMedia = ['Globe', 'Globe', 'Force field'];

// The court at one moment as a scene: without sources that do not shine then.
export function sceneOfCourt(text) {
    const scene = JSON.parse(text);
    for (const [list, names] of Object.entries(courtNames)) {
        scene[list]?.forEach((source, i) => (source.name = names[i]));
        scene[list] = scene[list]?.filter((source) => source.brightness > 0.01 && !(source.weights && Math.max(...source.weights) < 0.01));
        if (!scene[list]?.length) delete scene[list];
    }
    scene.media?.forEach((medium, i) => (medium.name = courtMedia[i]));
    return scene;
}

// Returns the scene of that name; the court's at the moment when `text` was written.
export async function startScene(name, text) {
    if (name === 'empty') return structuredClone(emptyScene);
    if (name === 'hall') {
        const { points, lines, tori, curves, paths, media, fog, ...hall } = sceneOfCourt(text);
        return hall;
    }
    const response = await fetch(`scenes/${name}.json`);
    if (!response.ok) throw new Error(`scenes/${name}.json is missing beside this page.`);
    return response.json();
}
