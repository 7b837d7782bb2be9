// The camera of the page: what a scene file's camera says, moved by hand. It orbits its target, or flies.
import { add, addScaled, cross, dot, length, normalize, scale, subtract, turn } from './vector.mjs';

const closest = 1e-3; // to the target, of the distance from which it was first seen

export class Camera {
    constructor(camera) {
        this.set(camera);
    }

    set({ eye, target, up = [0, 1, 0], projection = 'perspective', fov_y_degrees = 45, height = 2, near = 0.1, far = 100 }) {
        Object.assign(this, { eye, target, up, isOrthographic: projection === 'orthographic', fovY: fov_y_degrees, height, near, far });
        this.firstDistance = this.distance;
    }

    // The members that moving changes, as a scene file has them.
    get place() {
        const { eye, target, up, height } = this;
        return this.isOrthographic ? { eye, target, up, height } : { eye, target, up };
    }

    get distance() {
        return length(subtract(this.target, this.eye));
    }

    get axes() {
        const forward = normalize(subtract(this.target, this.eye));
        const right = normalize(cross(forward, this.up));
        return { forward, right, up: cross(right, forward) };
    }

    // Turns about the target, or about the eye, by radians to the right and up; never over the poles.
    #turned(way, yaw, pitch) {
        const up = normalize(this.up);
        const turned = turn(way, up, yaw);
        const right = normalize(cross(turned, up));
        const pitched = turn(turned, right, pitch);
        return length(cross(normalize(pitched), up)) > 0.02 ? pitched : turned;
    }

    orbit(yaw, pitch) {
        this.eye = subtract(this.target, this.#turned(subtract(this.target, this.eye), yaw, pitch));
    }

    look(yaw, pitch) {
        this.target = add(this.eye, this.#turned(subtract(this.target, this.eye), yaw, pitch));
    }

    // Moves eye and target, in distances to the target.
    pan(rightwards, upwards, forwards = 0) {
        const { right, up, forward } = this.axes;
        const way = scale(addScaled(addScaled(scale(right, rightwards), upwards, up), forwards, forward), this.distance);
        this.eye = add(this.eye, way);
        this.target = add(this.target, way);
    }

    zoom(factor) {
        if (this.isOrthographic) {
            this.height *= factor;
            return;
        }
        const distance = Math.min(Math.max(this.distance * factor, closest * this.firstDistance), 0.9 * this.far);
        this.eye = addScaled(this.target, -distance, this.axes.forward);
    }

    // Looks at a place from the same side, from far enough for a ball of `radius`.
    focus(place, radius) {
        const distance = Math.max(radius / Math.tan((this.fovY * Math.PI) / 360), 4 * this.near);
        this.eye = addScaled(place, -distance, this.axes.forward);
        this.target = place;
    }

    // World units that a picture `rows` high shows in one row, at a view depth.
    unitsPerPixel(depth, rows) {
        return (this.isOrthographic ? this.height : 2 * depth * Math.tan((this.fovY * Math.PI) / 360)) / rows;
    }

    // Where a place is seen in a picture, from its top left corner, and its view depth.
    project(place, width, height) {
        const { right, up, forward } = this.axes;
        const way = subtract(place, this.eye);
        const depth = dot(way, forward);
        const unit = this.unitsPerPixel(depth, height);
        return { x: width / 2 + dot(way, right) / unit, y: height / 2 - dot(way, up) / unit, depth };
    }

    // The ray through a pixel; its direction has unit view depth.
    ray(x, y, width, height) {
        const { right, up, forward } = this.axes;
        const unit = this.unitsPerPixel(1, height);
        const offset = addScaled(scale(right, (x - width / 2) * unit), (height / 2 - y) * unit, up);
        return this.isOrthographic ? { origin: add(this.eye, offset), direction: forward }
            : { origin: this.eye, direction: add(forward, offset) };
    }

    // The place on the plane through `place` across the view that is seen at a pixel.
    onViewPlane(place, x, y, width, height) {
        const { origin, direction } = this.ray(x, y, width, height);
        return addScaled(origin, dot(subtract(place, this.eye), this.axes.forward), direction);
    }

    // The place on the line through `place` along `axis` that is nearest to the ray through a pixel.
    onAxis(place, axis, x, y, width, height) {
        const { origin, direction } = this.ray(x, y, width, height);
        const ray = normalize(direction), way = subtract(place, origin);
        const b = dot(axis, ray), denominator = 1 - b * b;
        // Seen along itself, the axis has no nearest place.
        if (denominator < 1e-4) return place;
        return addScaled(place, (b * dot(ray, way) - dot(axis, way)) / denominator, axis);
    }
}
