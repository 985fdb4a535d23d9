// To be put behind cloth.wgsl: a sphere of cloth under one directional light, each pixel with its own footprint.

struct View
{
    width: u32,
    height: u32,
    radius: f32,   // of the sphere, millimetres
    distance: f32, // from the eye to its middle, millimetres
}

@group(1) @binding(0) var<uniform> picture: View;
@group(1) @binding(1) var<storage, read_write> pixels: array<vec4<f32>>;

/// The direction of the ray through a point of the picture; the eye looks along −z.
fn ray(pixel: vec2<f32>) -> vec3<f32>
{
    let size = vec2<f32>(f32(picture.width), f32(picture.height));
    let place = (pixel - 0.5 * size) / min(size.x, size.y);
    return normalize(vec3<f32>(place.x, -place.y, -1.6));
}

/// Where a ray meets the sphere: position relative to its middle, and 0 where it misses.
fn hit(direction: vec3<f32>) -> vec4<f32>
{
    let eye = vec3<f32>(0.0, 0.0, picture.distance);
    let along = dot(eye, direction);
    let square = along * along - dot(eye, eye) + picture.radius * picture.radius;
    let root = sqrt(max(square, 0.0));
    return vec4<f32>(eye + (-along - root) * direction, select(0.0, 1.0, square > 0.0));
}

/// Draft coordinates of a point of the sphere: longitude and latitude, in millimetres.
fn draft(position: vec3<f32>) -> vec2<f32>
{
    let normal = position / picture.radius;
    return picture.radius * vec2<f32>(atan2(normal.x, normal.z), asin(clamp(normal.y, -1.0, 1.0)));
}

@compute @workgroup_size(8, 8)
fn draw(@builtin(global_invocation_id) id: vec3<u32>)
{
    if (id.x >= picture.width || id.y >= picture.height) { return; }
    let pixel = vec2<f32>(id.xy) + 0.5;
    let direction = ray(pixel);
    let found = hit(direction);
    var colour = vec3<f32>(0.02);
    if (found.w > 0.0)
    {
        let normal = found.xyz / picture.radius;
        let axis_x = normalize(vec3<f32>(normal.z, 0.0, -normal.x)); // dp/du, along the weft
        let axis_y = cross(normal, axis_x);
        let centre = draft(found.xyz);
        // The steps to the next pixels. Engines have them by derivatives of uv.
        let dx = draft(hit(ray(pixel + vec2<f32>(1.0, 0.0))).xyz) - centre;
        let dy = draft(hit(ray(pixel + vec2<f32>(0.0, 1.0))).xyz) - centre;
        let towards = normalize(vec3<f32>(0.5, 0.6, 0.8));
        let light = vec3<f32>(dot(towards, axis_x), dot(towards, axis_y), dot(towards, normal));
        let view = -vec3<f32>(dot(direction, axis_x), dot(direction, axis_y), dot(direction, normal));
        let value = cloth_value(0u, centre, dx, dy, light, view);
        // The irradiance of the light is π; behind holes lies the background.
        colour = 3.14159265 * value.rgb + value.a * colour;
    }
    pixels[id.y * picture.width + id.x] = vec4<f32>(colour, 1.0);
}
