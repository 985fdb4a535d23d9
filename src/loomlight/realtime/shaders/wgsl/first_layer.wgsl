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

struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(12) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(14) @group(0) var visible_faces_0 : texture_2d<u32>;

@binding(8) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

@compute
@workgroup_size(8, 8, 1)
fn first_layer(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1 : u32 = id_0.x;
    var _S2 : u32 = frames_0[i32(0)].width_0;
    var _S3 : bool;
    if(_S1 >= (frames_0[i32(0)].width_0))
    {
        _S3 = true;
    }
    else
    {
        _S3 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S3)
    {
        return;
    }
    var _S4 : u32 = id_0.y * _S2 + _S1;
    var _S5 : vec3<i32> = vec3<i32>(vec2<i32>(id_0.xy), i32(0));
    layers_0[_S4].face_0 = (textureLoad((visible_faces_0), ((_S5)).xy, ((_S5)).z).x);
    layers_0[_S4].share_0 = 1.0f;
    if((frames_0[i32(0)].pass_number_0) == u32(0))
    {
        radiance_0[_S4] = vec4<f32>(0.0f);
    }
    return;
}

