struct Frame_std140_0
{
    @align(16) width_0 : u32,
    @align(4) height_0 : u32,
    @align(8) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(16) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(8) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(16) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(8) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(16) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(8) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(16) corners_0 : u32,
    @align(4) face_fabrics_0 : u32,
    @align(8) vertices_0 : u32,
    @align(4) light_records_0 : u32,
    @align(16) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(8) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(16) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(8) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(16) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(8) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(16) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(8) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(16) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(8) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
};

@binding(10) @group(0) var<uniform> frame_record_0 : Frame_std140_0;
struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(5) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(4) @group(0) var<storage, read> scene_words_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn arc_tangent_quotient_0( x_0 : f32,  y_0 : f32) -> f32
{
    return ((((((0.0f * x_0 + 0.00809729471802711f) * x_0 + -0.0377517081797123f) * x_0 + 0.08475969731807709f) * x_0 + -0.13537675142288208f) * x_0 + 0.19895026087760925f) * x_0 + -0.33327975869178772f) * x_0 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_1 : f32,  x_1 : f32) -> f32
{
    var _S1 : f32 = abs(x_1);
    var _S2 : f32 = abs(y_1);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S1, _S2) / max(max(_S1, _S2), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S2 > _S1);
    var angle_2 : f32 = select(angle_1, 3.14159274101257324f - angle_1, x_1 < 0.0f);
    return select(angle_2, - angle_2, y_1 < 0.0f);
}

fn arc_sine_0( x_2 : f32) -> f32
{
    var _S3 : f32 = abs(x_2);
    var _S4 : bool = _S3 > 0.5f;
    var _S5 : f32 = select(_S3 * _S3, 0.5f * (1.0f - _S3), _S4);
    var _S6 : f32 = select(_S3, sqrt(max(_S5, 0.0f)), _S4);
    var _S7 : f32 = ((((0.04216320067644119f * _S5 + 0.02418131195008755f) * _S5 + 0.04547002539038658f) * _S5 + 0.07495300471782684f) * _S5 + 0.16666752099990845f) * _S5 * _S6 + _S6;
    var _S8 : f32 = select(_S7, 1.57079637050628662f - 2.0f * _S7, _S4);
    return select(_S8, - _S8, x_2 < 0.0f);
}

fn scene_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_0])));
}

fn camera_forward_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.forward_x_0, frame_record_0.forward_y_0, frame_record_0.forward_z_0);
}

fn camera_right_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.right_x_0, frame_record_0.right_y_0, frame_record_0.right_z_0);
}

fn camera_up_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.up_x_0, frame_record_0.up_y_0, frame_record_0.up_z_0);
}

fn pixel_direction_0( _S9 : vec2<u32>,  _S10 : vec2<f32>) -> vec3<f32>
{
    return camera_forward_0() + vec3<f32>(((f32(_S9.x) + 0.5f + _S10.x) * 2.0f / f32(frame_record_0.width_0) - 1.0f)) * camera_right_0() + vec3<f32>((1.0f - (f32(_S9.y) + 0.5f + _S10.y) * 2.0f / f32(frame_record_0.height_0))) * camera_up_0();
}

fn environment_texel_0( _S11 : u32,  _S12 : u32) -> vec3<f32>
{
    var _S13 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S11 * frame_record_0.environment_columns_0 + _S12);
    return vec3<f32>(scene_number_0(_S13), scene_number_0(_S13 + u32(1)), scene_number_0(_S13 + u32(2)));
}

fn environment_radiance_0( _S14 : vec3<f32>) -> vec3<f32>
{
    var _S15 : f32 = _S14.x;
    var _S16 : f32 = _S14.z;
    var _S17 : f32 = arc_tangent_0(frame_record_0.environment_cosine_0 * _S15 - frame_record_0.environment_sine_0 * _S16, - (frame_record_0.environment_sine_0 * _S15 + frame_record_0.environment_cosine_0 * _S16)) / 6.28318548202514648f;
    var _S18 : u32 = frame_record_0.environment_columns_0;
    var _S19 : f32 = (_S17 - floor(_S17)) * f32(frame_record_0.environment_columns_0) - 0.5f;
    var _S20 : u32 = frame_record_0.environment_rows_0 - u32(1);
    var _S21 : f32 = clamp((0.5f - arc_sine_0(clamp(_S14.y, -1.0f, 1.0f)) / 3.14159274101257324f) * f32(frame_record_0.environment_rows_0) - 0.5f, 0.0f, f32(_S20));
    var _S22 : f32 = floor(_S19);
    var _S23 : u32 = u32(i32(_S22) + i32(frame_record_0.environment_columns_0)) % frame_record_0.environment_columns_0;
    var _S24 : u32 = (_S23 + u32(1)) % _S18;
    var _S25 : u32 = u32(_S21);
    var _S26 : u32 = min(_S25 + u32(1), _S20);
    var _S27 : vec3<f32> = vec3<f32>((_S19 - _S22));
    return mix(mix(environment_texel_0(_S25, _S23), environment_texel_0(_S25, _S24), _S27), mix(environment_texel_0(_S26, _S23), environment_texel_0(_S26, _S24), _S27), vec3<f32>((_S21 - f32(_S25))));
}

@compute
@workgroup_size(8, 8, 1)
fn add_background(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S28 : u32 = id_0.x;
    var _S29 : bool;
    if(_S28 >= (frame_record_0.width_0))
    {
        _S29 = true;
    }
    else
    {
        _S29 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S29)
    {
        return;
    }
    var _S30 : u32 = id_0.y * frame_record_0.width_0 + _S28;
    var _S31 : f32 = layers_0[_S30].share_0;
    if((layers_0[_S30].share_0) <= 0.0f)
    {
        return;
    }
    var _S32 : vec3<f32> = vec3<f32>(frame_record_0.background_red_0, frame_record_0.background_green_0, frame_record_0.background_blue_0);
    var background_0 : vec3<f32>;
    if((frame_record_0.shows_environment_0) != u32(0))
    {
        var _S33 : vec3<f32> = environment_radiance_0(normalize(pixel_direction_0(id_0.xy, vec2<f32>(frame_record_0.jitter_x_0, frame_record_0.jitter_y_0))));
        background_0 = _S33;
    }
    else
    {
        background_0 = _S32;
    }
    radiance_0[_S30] = radiance_0[_S30] + vec4<f32>(vec3<f32>(_S31) * background_0, 0.0f);
    return;
}

