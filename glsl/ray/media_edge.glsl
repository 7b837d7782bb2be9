// Where the light changes suddenly from ray to ray, because a body begins or ends, or has an edge there: for the grid of adaptive
// resolution.

// By how much places of the body's own space change, at the ray's s, from a node to all rays within a cell of it.
vec3 ew_cell_in_body(const ew_medium_block body, const float s)
{
    vec2 right = float(EW_CELL_SIZE) * (ew_frame.ray_right.xy + s * ew_frame.ray_right.zw);
    vec2 up = float(EW_CELL_SIZE) * (ew_frame.ray_up.xy + s * ew_frame.ray_up.zw);
    vec3 along_right = vec3(dot(body.row_x.xy, right), dot(body.row_y.xy, right), dot(body.row_z.xy, right));
    vec3 along_up = vec3(dot(body.row_x.xy, up), dot(body.row_y.xy, up), dot(body.row_z.xy, up));
    return abs(along_right) + abs(along_up);
}

// How many of the four may be the largest, each of them off by as much as `error` says.
int ew_count_largest(const vec4 values, const vec4 error)
{
    vec4 least = values - error;
    float most = max(max(least.x, least.y), max(least.z, least.w));
    return int(dot(vec4(greaterThanEqual(values + error, vec4(most))), vec4(1.0)));
}

// Whether some ray within a cell of this one may meet another face of a box, or pass it by, where this one does not, or the reverse.
// `begin`: where the fog does.
bool ew_is_near_edge_of_box(const ew_medium_block body, const ew_body_ray ray, const float begin, const float end)
{
    ew_slabs slabs = ew_meet_slabs(ray);
    vec3 near = clamp(slabs.near, -1e15, 1e15);
    vec3 far = clamp(slabs.far, -1e15, 1e15);
    vec3 near_error, far_error;
    for (int face = 0; face < 3; ++face) {
        near_error[face] = ew_cell_in_body(body, clamp(near[face], begin, end))[face] / slabs.speed[face];
        far_error[face] = ew_cell_in_body(body, clamp(far[face], begin, end))[face] / slabs.speed[face];
    }
    vec3 first_near = near - near_error;
    vec3 last_far = far + far_error;
    float enters = max(max(max(first_near.x, first_near.y), first_near.z), begin);
    float leaves = min(min(min(last_far.x, last_far.y), last_far.z), end);
    vec3 last_near = near + near_error;
    vec3 first_far = far - far_error;
    bool is_met = max(max(max(last_near.x, last_near.y), last_near.z), begin) < min(min(min(first_far.x, first_far.y), first_far.z), end);
    bool has_one_face = ew_count_largest(vec4(near, begin), vec4(near_error, 0.0)) == 1 &&
                        ew_count_largest(vec4(-far, -end), vec4(far_error, 0.0)) == 1;
    return enters < leaves && !(is_met && has_one_face);
}

// The same of an ellipsoid's silhouette.
bool ew_is_near_edge_of_ball(const ew_medium_block body, const ew_body_ray ray, const float begin, const float end)
{
    float k = max(ew_length_squared(ray.step), 1e-30);
    float middle = -dot(ray.place, ray.step) / k;
    float error = length(ew_cell_in_body(body, clamp(middle, begin, end)));
    float way = 1.0 / sqrt(k);
    bool is_on_ray = middle + way > begin && middle - way < end;
    return is_on_ray && abs(length(ray.place + middle * ray.step) - 1.0) < error;
}

bool ew_is_near_edge(const ew_segment segment)
{
    bool is_near = false;
    for (int i = 0; i < EW_MEDIUM_ROOM && i < ew_fog.bodies.x; ++i) {
        ew_medium_block body = ew_media[i];
        ew_body_ray ray = ew_bring_to_body(segment, body);
        if (i < ew_fog.bodies.y) is_near = is_near || ew_is_near_edge_of_box(body, ray, ew_fog_begin, segment.end);
        else is_near = is_near || ew_is_near_edge_of_ball(body, ray, ew_fog_begin, segment.end);
    }
    return is_near;
}
