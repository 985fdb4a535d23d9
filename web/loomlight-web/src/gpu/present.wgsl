// Shows one picture, or two on either side of an upright line, on a canvas of another size.

struct Source {
    width: u32,
    height: u32,
    // Passes that the sums of the alpha are divided by.
    passes: f32,
    // 1 where something is seen beside the cloth and behind its holes.
    has_background: u32,
};

struct Show {
    left: Source,
    right: Source,
    canvas_width: f32,
    canvas_height: f32,
    // Where the second picture begins, from 0 at the left to 1; the first fills all of 1.
    split: f32,
    // 1 where the canvas lets through what lies behind it.
    is_transparent: u32,
};

@group(0) @binding(0) var<uniform> show: Show;
@group(0) @binding(1) var<storage, read> left_pixels: array<u32>;
@group(0) @binding(2) var<storage, read> left_sums: array<vec4f>;
@group(0) @binding(3) var<storage, read> right_pixels: array<u32>;
@group(0) @binding(4) var<storage, read> right_sums: array<vec4f>;

@vertex
fn cover(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

fn texel(is_right: bool, source: Source, x: i32, y: i32) -> vec4f {
    let column = u32(clamp(x, 0, i32(source.width) - 1));
    let row = u32(clamp(y, 0, i32(source.height) - 1));
    let at = row * source.width + column;
    if is_right {
        return vec4f(unpack4x8unorm(right_pixels[at]).rgb, right_sums[at].a / source.passes);
    }
    return vec4f(unpack4x8unorm(left_pixels[at]).rgb, left_sums[at].a / source.passes);
}

@fragment
fn present(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let place = position.xy / vec2f(show.canvas_width, show.canvas_height);
    let is_right = place.x >= show.split;
    var source = show.left;
    if is_right {
        source = show.right;
    }
    let size = vec2f(f32(source.width), f32(source.height));
    let at = place * size - 0.5;
    let low = floor(at);
    let share = at - low;
    let x = i32(low.x);
    let y = i32(low.y);
    var colour = vec4f(0.0);
    if size.x == show.canvas_width && size.y == show.canvas_height {
        // Pixel by pixel: software adapters take long for the rest.
        colour = texel(is_right, source, i32(position.x), i32(position.y));
    } else {
        let above = mix(texel(is_right, source, x, y), texel(is_right, source, x + 1, y), share.x);
        let below = mix(texel(is_right, source, x, y + 1), texel(is_right, source, x + 1, y + 1), share.x);
        colour = mix(above, below, share.y);
    }
    let line = 1.0 / show.canvas_width;
    if show.split > 0.0 && show.split < 1.0 && abs(place.x - show.split) < line {
        return vec4f(1.0);
    }
    // Canvases add what lies behind them by 1 - alpha to colours as they are: with a background that is nothing.
    let lets_through = show.is_transparent == 1u && source.has_background == 0u;
    return vec4f(colour.rgb, select(1.0, clamp(colour.a, 0.0, 1.0), lets_through));
}
