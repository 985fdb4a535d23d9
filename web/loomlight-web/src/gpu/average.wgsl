// Pictures that are made of areas are means over their passes, in place of sums: so areas of which one has a pass more
// than the other can be shown beside each other.

struct Blend {
    // Of the area in the picture, pixels.
    x: u32,
    y: u32,
    width: u32,
    height: u32,
    // Pixels of the picture in a row.
    stride: u32,
    // Passes before this one.
    passes: u32,
};

@group(0) @binding(0) var<uniform> area: Blend;
@group(0) @binding(1) var<storage, read_write> of_pass: array<vec4f>;
@group(0) @binding(2) var<storage, read_write> means: array<vec4f>;

// A pass over an area becomes the mean over all passes, there and in the picture.
@compute @workgroup_size(8, 8)
fn blend(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= area.width || id.y >= area.height {
        return;
    }
    let source = id.y * area.width + id.x;
    let place = (area.y + id.y) * area.stride + area.x + id.x;
    // Before the first pass there is what a coarser picture showed.
    let mean = select(mix(means[place], of_pass[source], 1.0 / f32(area.passes + 1u)), of_pass[source], area.passes == 0u);
    means[place] = mean;
    of_pass[source] = mean;
}

struct Enlarge {
    from_width: u32,
    from_height: u32,
    // That the sums are of.
    passes: f32,
    to_width: u32,
    to_height: u32,
};

@group(0) @binding(0) var<uniform> sizes: Enlarge;
@group(0) @binding(1) var<storage, read> from_pixels: array<u32>;
@group(0) @binding(2) var<storage, read> from_sums: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> to_pixels: array<u32>;
@group(0) @binding(4) var<storage, read_write> to_means: array<vec4f>;

// Means of a picture of sums, of its own size or another; colours between pixels are interpolated.
@compute @workgroup_size(8, 8)
fn enlarge(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= sizes.to_width || id.y >= sizes.to_height {
        return;
    }
    let from_size = vec2f(f32(sizes.from_width), f32(sizes.from_height));
    let place = (vec2f(id.xy) + 0.5) * from_size / vec2f(f32(sizes.to_width), f32(sizes.to_height)) - 0.5;
    let low = floor(place);
    let share = place - low;
    var colour = vec4f(0.0);
    var mean = vec4f(0.0);
    for (var corner = 0u; corner < 4u; corner++) {
        let step = vec2f(f32(corner & 1u), f32(corner >> 1u));
        let weights = mix(1.0 - share, share, step);
        let pixel = vec2u(clamp(low + step, vec2f(0.0), from_size - 1.0));
        let at = pixel.y * sizes.from_width + pixel.x;
        colour += weights.x * weights.y * unpack4x8unorm(from_pixels[at]);
        mean += weights.x * weights.y * from_sums[at] / sizes.passes;
    }
    let to = id.y * sizes.to_width + id.x;
    to_pixels[to] = pack4x8unorm(colour);
    to_means[to] = mean;
}
