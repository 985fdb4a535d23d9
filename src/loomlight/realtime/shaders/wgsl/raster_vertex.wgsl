struct Frame_std430_0
{
    @align(4) width_0 : u32,
    @align(4) height_0 : u32,
    @align(4) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(4) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(4) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(4) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(4) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(4) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(4) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(4) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(4) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(4) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(4) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(4) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(4) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(4) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(4) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(4) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(4) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
};

@binding(4) @group(0) var<storage, read> frames_0 : array<Frame_std430_0>;

@binding(6) @group(0) var<storage, read> corners_0 : array<u32>;

struct Vertex_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) z_0 : f32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) u_0 : f32,
    @align(4) v_0 : f32,
};

@binding(5) @group(0) var<storage, read> vertices_0 : array<Vertex_std430_0>;

fn position_of_0( vertex_0 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_0).x_0, (*vertex_0).y_0, (*vertex_0).z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

struct RasterOutput_0
{
    @builtin(position) position_0 : vec4<f32>,
    @interpolate(flat) @location(0) face_0 : u32,
};

fn camera_origin_0( _S1 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S1].origin_x_0, frames_0[_S1].origin_y_0, frames_0[_S1].origin_z_0);
}

fn camera_right_0( _S2 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S2].right_x_0, frames_0[_S2].right_y_0, frames_0[_S2].right_z_0);
}

fn camera_up_0( _S3 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S3].up_x_0, frames_0[_S3].up_y_0, frames_0[_S3].up_z_0);
}

fn camera_forward_0( _S4 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S4].forward_x_0, frames_0[_S4].forward_y_0, frames_0[_S4].forward_z_0);
}

fn to_clip_0( _S5 : i32,  _S6 : vec3<f32>) -> vec4<f32>
{
    var _S7 : vec3<f32> = _S6 - camera_origin_0(_S5);
    var _S8 : vec3<f32> = camera_right_0(_S5);
    var _S9 : vec3<f32> = camera_up_0(_S5);
    var _S10 : f32 = dot(_S7, camera_forward_0(_S5));
    return vec4<f32>(dot(_S7, _S8) / square_0(_S8) - 2.0f * frames_0[_S5].jitter_x_0 / f32(frames_0[_S5].width_0) * _S10, dot(_S7, _S9) / square_0(_S9) + 2.0f * frames_0[_S5].jitter_y_0 / f32(frames_0[_S5].height_0) * _S10, frames_0[_S5].near_0, _S10);
}

@vertex
fn raster_vertex(@builtin(vertex_index) index_0 : u32) -> RasterOutput_0
{
    var output_0 : RasterOutput_0;
    var _S11 : Vertex_std430_0 = vertices_0[corners_0[index_0]];
    var _S12 : vec3<f32> = position_of_0(&(_S11));
    output_0.position_0 = to_clip_0(i32(0), _S12);
    output_0.face_0 = index_0 / u32(3);
    return output_0;
}

