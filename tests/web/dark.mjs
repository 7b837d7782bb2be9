// A scene without its light, for finding silhouettes: its opaque shapes are recoloured in colours far apart, so that no two surfaces look
// alike.
export function darkScene({ points, lines, tori, curves, paths, ...dark }) {
    const opaque = dark.opaque?.map((shape, i) => ({ ...shape, color: [0.618, 0.414, 0.236].map((step) => (i * step) % 1) }));
    return opaque ? { ...dark, opaque } : dark;
}
