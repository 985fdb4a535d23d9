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
    @align(16) ground_x_0 : f32,
    @align(4) ground_y_0 : f32,
    @align(8) ground_z_0 : f32,
    @align(4) ground_offset_0 : f32,
    @align(16) ground_lamp_0 : f32,
};

@binding(10) @group(0) var<uniform> frame_record_0 : Frame_std140_0;
@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

@binding(8) @group(0) var<storage, read_write> pixels_0 : array<u32>;

fn natural_logarithm_0( x_0 : f32) -> f32
{
    var _S1 : u32 = (bitcast<u32>((x_0)));
    var m_0 : f32 = (bitcast<f32>(((((_S1 & (u32(8388607)))) | (u32(1056964608))))));
    var _S2 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S1 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S2);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S2) - 1.0f;
    var _S3 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S3 - exponent_0 * 0.00021219444170129f - 0.5f * _S3) + exponent_0 * 0.693359375f;
}

fn exponential_0( x_1 : f32) -> f32
{
    var _S4 : f32 = clamp(x_1, -87.0f, 88.0f);
    var _S5 : f32 = floor(_S4 * 1.4426950216293335f + 0.5f);
    var _S6 : f32 = _S4 - _S5 * 0.693359375f + _S5 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S6 + 0.00139819993637502f) * _S6 + 0.00833345204591751f) * _S6 + 0.04166579619050026f) * _S6 + 0.1666666567325592f) * _S6 + 0.5f) * _S6 * _S6 + _S6 + 1.0f) * (bitcast<f32>(((u32(i32(_S5) + i32(127)) << (u32(23)))))), 0.0f, x_1 < -87.0f);
}

fn power_0( x_2 : f32,  exponent_1 : f32) -> f32
{
    return exponential_0(exponent_1 * natural_logarithm_0(max(x_2, 1.00000000317107685e-30f)));
}

fn encoded_0( linear_0 : f32) -> u32
{
    var _S7 : f32 = clamp(linear_0, 0.0f, 1.0f);
    return u32(select(1.0549999475479126f * power_0(_S7, 0.4166666567325592f) - 0.05499999970197678f, 12.92000007629394531f * _S7, _S7 <= 0.00313080009073019f) * 255.0f + 0.5f);
}

@compute
@workgroup_size(64, 1, 1)
fn tone_map(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S8 : u32 = id_0.x;
    if(_S8 >= (frame_record_0.width_0 * frame_record_0.height_0))
    {
        return;
    }
    var _S9 : vec3<f32> = radiance_0[_S8].xyz * vec3<f32>(frame_record_0.gain_0);
    pixels_0[_S8] = ((((((encoded_0(_S9.x)) | ((((encoded_0(_S9.y)) << (u32(8))))))) | ((((encoded_0(_S9.z)) << (u32(16))))))) | (u32(4278190080)));
    return;
}

