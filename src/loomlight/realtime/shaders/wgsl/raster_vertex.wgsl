struct Frame_std430_0
{
    @align(4) width_0 : u32,
    @align(4) height_0 : u32,
    @align(4) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(4) pass_number_0 : u32,
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

fn camera_origin_0( frame_0 : ptr<function, Frame_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*frame_0).origin_x_0, (*frame_0).origin_y_0, (*frame_0).origin_z_0);
}

fn camera_right_0( frame_1 : ptr<function, Frame_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*frame_1).right_x_0, (*frame_1).right_y_0, (*frame_1).right_z_0);
}

fn camera_up_0( frame_2 : ptr<function, Frame_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*frame_2).up_x_0, (*frame_2).up_y_0, (*frame_2).up_z_0);
}

fn camera_forward_0( frame_3 : ptr<function, Frame_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*frame_3).forward_x_0, (*frame_3).forward_y_0, (*frame_3).forward_z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn to_clip_0( frame_4 : ptr<function, Frame_std430_0>,  position_0 : vec3<f32>) -> vec4<f32>
{
    var _S1 : vec3<f32> = camera_origin_0(&((*frame_4)));
    var _S2 : vec3<f32> = position_0 - _S1;
    var _S3 : vec3<f32> = camera_right_0(&((*frame_4)));
    var _S4 : vec3<f32> = camera_up_0(&((*frame_4)));
    var _S5 : vec3<f32> = camera_forward_0(&((*frame_4)));
    var _S6 : f32 = dot(_S2, _S5);
    return vec4<f32>(dot(_S2, _S3) / square_0(_S3) - 2.0f * (*frame_4).jitter_x_0 / f32((*frame_4).width_0) * _S6, dot(_S2, _S4) / square_0(_S4) + 2.0f * (*frame_4).jitter_y_0 / f32((*frame_4).height_0) * _S6, (*frame_4).near_0, _S6);
}

struct RasterOutput_0
{
    @builtin(position) position_1 : vec4<f32>,
    @interpolate(flat) @location(0) face_0 : u32,
};

@vertex
fn raster_vertex(@builtin(vertex_index) index_0 : u32) -> RasterOutput_0
{
    var output_0 : RasterOutput_0;
    var _S7 : Frame_std430_0 = frames_0[i32(0)];
    var _S8 : Vertex_std430_0 = vertices_0[corners_0[index_0]];
    var _S9 : vec3<f32> = position_of_0(&(_S8));
    var _S10 : vec4<f32> = to_clip_0(&(_S7), _S9);
    output_0.position_1 = _S10;
    output_0.face_0 = index_0 / u32(3);
    return output_0;
}

