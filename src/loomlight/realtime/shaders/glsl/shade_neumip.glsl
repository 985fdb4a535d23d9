#version 450
layout(row_major) uniform;
layout(row_major) buffer;
struct Frame_0
{
    uint width_0;
    uint height_0;
    uint lights_0;
    uint samples_0;
    uint pass_number_0;
    uint environment_samples_0;
    uint environment_columns_0;
    uint environment_rows_0;
    uint environment_table_0;
    float environment_total_0;
    float environment_sine_0;
    float environment_cosine_0;
    uint shows_environment_0;
    uint casts_shadows_0;
    uint leaves_0;
    uint leaf_faces_0;
    float ray_offset_0;
    float jitter_x_0;
    float jitter_y_0;
    float gain_0;
    float origin_x_0;
    float origin_y_0;
    float origin_z_0;
    float right_x_0;
    float right_y_0;
    float right_z_0;
    float up_x_0;
    float up_y_0;
    float up_z_0;
    float forward_x_0;
    float forward_y_0;
    float forward_z_0;
    float near_0;
    float background_red_0;
    float background_green_0;
    float background_blue_0;
};

layout(std430, binding = 4) readonly buffer StructuredBuffer_Frame_t_0 {
    Frame_0 _data[];
} frames_0;
struct Layer_0
{
    uint face_0;
    float share_0;
};

layout(std430, binding = 12) buffer StructuredBuffer_Layer_t_0 {
    Layer_0 _data[];
} layers_0;
layout(std430, binding = 7) readonly buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} face_fabrics_0;
struct Lobes_0
{
    uint is_baked_0;
    float inverse_base_size_0;
    float last_level_0;
    uint levels_0;
    uint face_nodes_0;
    uint packs_0;
    uint front_warp_packs_0;
    uint back_warp_packs_0;
    uint coverage_0;
    uint coverage_holes_0;
    uint projected_area_0;
    uint light_visibility_0;
    uint irradiance_0;
    uint moments_0;
    float front_hole_weight_0;
    float back_hole_weight_0;
    float threads_per_mm_0;
    float unit_level_0;
};

struct Woven_0
{
    uint is_encoded_0;
    uint network_0;
    uint latents_0;
    uint texels_0;
    uint levels_1;
    uint top_level_0;
    float ends_0;
    float picks_0;
    float ends_per_mm_0;
    float picks_per_mm_0;
    float pitch_0;
    float warp_x_0;
    float warp_y_0;
    float warp_roughness_0;
    float weft_x_0;
    float weft_y_0;
    float weft_roughness_0;
    float warp_lobe_roughness_0;
    float weft_lobe_roughness_0;
    uint bundles_0;
    uint is_corrected_0;
    uint correction_0;
};

struct Neumip_0
{
    uint is_trained_0;
    uint decoder_0;
    uint has_offset_0;
    uint offset_0;
    uint offset_texels_0;
    uint features_0;
    uint texel_elements_0;
    uint levels_2;
    float last_level_1;
    uint face_texels_0;
    uint back_0;
    float repeats_per_x_0;
    float repeats_per_y_0;
    float texels_per_mm_0;
    float unit_x_0;
    float unit_y_0;
};

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Woven_0 woven_0;
    Neumip_0 neumip_0;
    uint run_words_0;
    uint ends_1;
    uint max_heights_0;
    uint max_height_columns_0;
    float height_low_0;
    float height_high_0;
    float lift_0;
    float threads_per_x_0;
    float threads_per_y_0;
    float per_relief_0;
    float diffuse_blend_0;
    float optical_depth_0;
    float sheen_strength_0;
    float sheen_roughness_0;
    float fibre_noise_0;
    float colour_noise_0;
    uint seed_0;
    float layer_bound_0;
    float fibre_size_0;
    float uv_width_0;
    float uv_height_0;
    uint is_open_0;
    uint albedo_map_0;
    uint albedo_map_levels_0;
};

layout(std430, binding = 0) readonly buffer StructuredBuffer_Fabric_t_0 {
    Fabric_0 _data[];
} fabrics_0;
layout(std430, binding = 6) readonly buffer StructuredBuffer_uint_t_1 {
    uint _data[];
} corners_0;
struct Vertex_0
{
    float x_0;
    float y_0;
    float z_0;
    float normal_x_0;
    float normal_y_0;
    float normal_z_0;
    float u_0;
    float v_0;
};

layout(std430, binding = 5) readonly buffer StructuredBuffer_Vertex_t_0 {
    Vertex_0 _data[];
} vertices_0;
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_2 {
    uint _data[];
} words_0;
layout(std430, binding = 10) readonly buffer StructuredBuffer_vectorx3Cuintx2C4x3E_t_0 {
    uvec4 _data[];
} packed_numbers_0;
layout(std430, binding = 13) buffer StructuredBuffer_float_t_0 {
    float _data[];
} visibilities_0;
layout(std430, binding = 11) readonly buffer StructuredBuffer_uint_t_3 {
    uint _data[];
} scene_words_0;
struct Light_0
{
    uint is_point_0;
    float x_1;
    float y_1;
    float z_1;
    float red_0;
    float green_0;
    float blue_0;
};

layout(std430, binding = 3) readonly buffer StructuredBuffer_Light_t_0 {
    Light_0 _data[];
} lights_1;
layout(std430, binding = 8) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} radiance_0;
struct FloatWeights_0
{
    uint first_0;
};

int whole_parts_0(int elements_0)
{
    return (elements_0 + 3) / 4 * 4;
}

struct Eight_0
{
    vec4 low_0;
    vec4 high_0;
};

Eight_0 FloatWeights_eight_0(FloatWeights_0 this_0, uint element_0)
{
    Eight_0 numbers_0;
    uint _S1 = this_0.first_0 + 2U * element_0;
    numbers_0.low_0 = uintBitsToFloat(packed_numbers_0._data[uint(_S1)]);
    numbers_0.high_0 = uintBitsToFloat(packed_numbers_0._data[uint(_S1 + 1U)]);
    return numbers_0;
}

vec4 tile_product_0(FloatWeights_0 weights_0, uint row_0, inout float  inputs_0[25])
{
    vec4 sums_0 = vec4(0.0);
    uint column_0 = 0U;
    for(;;)
    {
        if(column_0 < 4U)
        {
        }
        else
        {
            break;
        }
        vec4 low_1;
        vec4 high_1;
        int _S2 = int(8U * column_0);
        low_1[0] = inputs_0[min(_S2, 24)];
        high_1[0] = inputs_0[min(_S2 + 4, 24)];
        int _S3 = _S2 + 1;
        low_1[1] = inputs_0[min(_S3, 24)];
        high_1[1] = inputs_0[min(_S3 + 4, 24)];
        int _S4 = _S2 + 2;
        low_1[2] = inputs_0[min(_S4, 24)];
        high_1[2] = inputs_0[min(_S4 + 4, 24)];
        int _S5 = _S2 + 3;
        low_1[3] = inputs_0[min(_S5, 24)];
        high_1[3] = inputs_0[min(_S5 + 4, 24)];
        Eight_0 _S6 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        sums_0[0] = sums_0[0] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 4U + column_0);
        sums_0[1] = sums_0[1] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 8U + column_0);
        sums_0[2] = sums_0[2] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        sums_0[3] = sums_0[3] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
}

float Identity_apply_0(float x_2)
{
    return x_2;
}

void dense_part_0(FloatWeights_0 weights_1, uint first_1, bool adds_0, inout float  inputs_1[25], inout float  outputs_0[3])
{
    uint _S10 = first_1 + uint(whole_parts_0(1));
    int output_0 = 0;
    for(;;)
    {
        bool _S11 = output_0 < 3;
        if(_S11)
        {
        }
        else
        {
            break;
        }
        uint _S12 = uint(output_0);
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U);
        vec4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 4U, inputs_1);
        vec4 _S15;
        if((output_0 & 4) != 0)
        {
            _S15 = _S13.high_0;
        }
        else
        {
            _S15 = _S13.low_0;
        }
        vec4 _S16 = _S14 + _S15;
        float _S17;
        if(_S11)
        {
            if(adds_0)
            {
                _S17 = outputs_0[output_0];
            }
            else
            {
                _S17 = 0.0;
            }
            outputs_0[output_0] = Identity_apply_0(_S16[0] + _S17);
        }
        int _S18 = output_0 + 1;
        if(_S18 < 3)
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S18];
            }
            else
            {
                _S17 = 0.0;
            }
            outputs_0[_S18] = Identity_apply_0(_S16[1] + _S17);
        }
        int _S19 = output_0 + 2;
        if(_S19 < 3)
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S19];
            }
            else
            {
                _S17 = 0.0;
            }
            outputs_0[_S19] = Identity_apply_0(_S16[2] + _S17);
        }
        int _S20 = output_0 + 3;
        if(_S20 < 3)
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S20];
            }
            else
            {
                _S17 = 0.0;
            }
            outputs_0[_S20] = Identity_apply_0(_S16[3] + _S17);
        }
        output_0 = output_0 + 4;
    }
    return;
}

vec4 tile_product_1(FloatWeights_0 weights_2, uint row_1, inout float  inputs_2[11])
{
    vec4 sums_1 = vec4(0.0);
    uint column_1 = 0U;
    for(;;)
    {
        if(column_1 < 2U)
        {
        }
        else
        {
            break;
        }
        vec4 low_2;
        vec4 high_2;
        int _S21 = int(8U * column_1);
        low_2[0] = inputs_2[min(_S21, 10)];
        high_2[0] = inputs_2[min(_S21 + 4, 10)];
        int _S22 = _S21 + 1;
        low_2[1] = inputs_2[min(_S22, 10)];
        high_2[1] = inputs_2[min(_S22 + 4, 10)];
        int _S23 = _S21 + 2;
        low_2[2] = inputs_2[min(_S23, 10)];
        high_2[2] = inputs_2[min(_S23 + 4, 10)];
        int _S24 = _S21 + 3;
        low_2[3] = inputs_2[min(_S24, 10)];
        high_2[3] = inputs_2[min(_S24 + 4, 10)];
        Eight_0 _S25 = FloatWeights_eight_0(weights_2, row_1 + column_1);
        sums_1[0] = sums_1[0] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        Eight_0 _S26 = FloatWeights_eight_0(weights_2, row_1 + 2U + column_1);
        sums_1[1] = sums_1[1] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        Eight_0 _S27 = FloatWeights_eight_0(weights_2, row_1 + 4U + column_1);
        sums_1[2] = sums_1[2] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        Eight_0 _S28 = FloatWeights_eight_0(weights_2, row_1 + 6U + column_1);
        sums_1[3] = sums_1[3] + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
}

float Relu_apply_0(float x_3)
{
    return max(x_3, 0.0);
}

void dense_part_1(FloatWeights_0 weights_3, uint first_2, bool adds_1, inout float  inputs_3[11], inout float  outputs_1[25])
{
    uint _S29 = first_2 + uint(whole_parts_0(4));
    int output_1 = 0;
    for(;;)
    {
        bool _S30 = output_1 < 25;
        if(_S30)
        {
        }
        else
        {
            break;
        }
        uint _S31 = uint(output_1);
        Eight_0 _S32 = FloatWeights_eight_0(weights_3, first_2 + _S31 / 8U);
        vec4 _S33 = tile_product_1(weights_3, _S29 + _S31 * 2U, inputs_3);
        vec4 _S34;
        if((output_1 & 4) != 0)
        {
            _S34 = _S32.high_0;
        }
        else
        {
            _S34 = _S32.low_0;
        }
        vec4 _S35 = _S33 + _S34;
        float _S36;
        if(_S30)
        {
            if(adds_1)
            {
                _S36 = outputs_1[output_1];
            }
            else
            {
                _S36 = 0.0;
            }
            outputs_1[output_1] = Relu_apply_0(_S35[0] + _S36);
        }
        int _S37 = output_1 + 1;
        if(_S37 < 25)
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S37];
            }
            else
            {
                _S36 = 0.0;
            }
            outputs_1[_S37] = Relu_apply_0(_S35[1] + _S36);
        }
        int _S38 = output_1 + 2;
        if(_S38 < 25)
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S38];
            }
            else
            {
                _S36 = 0.0;
            }
            outputs_1[_S38] = Relu_apply_0(_S35[2] + _S36);
        }
        int _S39 = output_1 + 3;
        if(_S39 < 25)
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S39];
            }
            else
            {
                _S36 = 0.0;
            }
            outputs_1[_S39] = Relu_apply_0(_S35[3] + _S36);
        }
        output_1 = output_1 + 4;
    }
    return;
}

void dense_0(FloatWeights_0 weights_4, uint first_3, bool adds_2, inout float  inputs_4[25], inout float  outputs_2[3])
{
    dense_part_0(weights_4, first_3, adds_2, inputs_4, outputs_2);
    return;
}

void dense_1(FloatWeights_0 weights_5, uint first_4, bool adds_3, inout float  inputs_5[11], inout float  outputs_3[25])
{
    dense_part_1(weights_5, first_4, adds_3, inputs_5, outputs_3);
    return;
}

void dense_part_2(FloatWeights_0 weights_6, uint first_5, bool adds_4, inout float  inputs_6[25], inout float  outputs_4[25])
{
    uint _S40 = first_5 + uint(whole_parts_0(4));
    int output_2 = 0;
    for(;;)
    {
        bool _S41 = output_2 < 25;
        if(_S41)
        {
        }
        else
        {
            break;
        }
        uint _S42 = uint(output_2);
        Eight_0 _S43 = FloatWeights_eight_0(weights_6, first_5 + _S42 / 8U);
        vec4 _S44 = tile_product_0(weights_6, _S40 + _S42 * 4U, inputs_6);
        vec4 _S45;
        if((output_2 & 4) != 0)
        {
            _S45 = _S43.high_0;
        }
        else
        {
            _S45 = _S43.low_0;
        }
        vec4 _S46 = _S44 + _S45;
        float _S47;
        if(_S41)
        {
            if(adds_4)
            {
                _S47 = outputs_4[output_2];
            }
            else
            {
                _S47 = 0.0;
            }
            outputs_4[output_2] = Relu_apply_0(_S46[0] + _S47);
        }
        int _S48 = output_2 + 1;
        if(_S48 < 25)
        {
            if(adds_4)
            {
                _S47 = outputs_4[_S48];
            }
            else
            {
                _S47 = 0.0;
            }
            outputs_4[_S48] = Relu_apply_0(_S46[1] + _S47);
        }
        int _S49 = output_2 + 2;
        if(_S49 < 25)
        {
            if(adds_4)
            {
                _S47 = outputs_4[_S49];
            }
            else
            {
                _S47 = 0.0;
            }
            outputs_4[_S49] = Relu_apply_0(_S46[2] + _S47);
        }
        int _S50 = output_2 + 3;
        if(_S50 < 25)
        {
            if(adds_4)
            {
                _S47 = outputs_4[_S50];
            }
            else
            {
                _S47 = 0.0;
            }
            outputs_4[_S50] = Relu_apply_0(_S46[3] + _S47);
        }
        output_2 = output_2 + 4;
    }
    return;
}

void dense_part_3(FloatWeights_0 weights_7, uint first_6, bool adds_5, inout float  inputs_7[25], inout float  outputs_5[1])
{
    uint _S51 = first_6 + uint(whole_parts_0(1));
    int output_3 = 0;
    for(;;)
    {
        bool _S52 = output_3 < 1;
        if(_S52)
        {
        }
        else
        {
            break;
        }
        uint _S53 = uint(output_3);
        Eight_0 _S54 = FloatWeights_eight_0(weights_7, first_6 + _S53 / 8U);
        vec4 _S55 = tile_product_0(weights_7, _S51 + _S53 * 4U, inputs_7);
        vec4 _S56;
        if((output_3 & 4) != 0)
        {
            _S56 = _S54.high_0;
        }
        else
        {
            _S56 = _S54.low_0;
        }
        vec4 _S57 = _S55 + _S56;
        float _S58;
        if(_S52)
        {
            if(adds_5)
            {
                _S58 = outputs_5[output_3];
            }
            else
            {
                _S58 = 0.0;
            }
            outputs_5[output_3] = Identity_apply_0(_S57[0] + _S58);
        }
        int _S59 = output_3 + 1;
        if(_S59 < 1)
        {
            if(adds_5)
            {
                _S58 = outputs_5[_S59];
            }
            else
            {
                _S58 = 0.0;
            }
            outputs_5[_S59] = Identity_apply_0(_S57[1] + _S58);
        }
        int _S60 = output_3 + 2;
        if(_S60 < 1)
        {
            if(adds_5)
            {
                _S58 = outputs_5[_S60];
            }
            else
            {
                _S58 = 0.0;
            }
            outputs_5[_S60] = Identity_apply_0(_S57[2] + _S58);
        }
        int _S61 = output_3 + 3;
        if(_S61 < 1)
        {
            if(adds_5)
            {
                _S58 = outputs_5[_S61];
            }
            else
            {
                _S58 = 0.0;
            }
            outputs_5[_S61] = Identity_apply_0(_S57[3] + _S58);
        }
        output_3 = output_3 + 4;
    }
    return;
}

vec4 tile_product_2(FloatWeights_0 weights_8, uint row_2, inout float  inputs_8[9])
{
    vec4 sums_2 = vec4(0.0);
    uint column_2 = 0U;
    for(;;)
    {
        if(column_2 < 2U)
        {
        }
        else
        {
            break;
        }
        vec4 low_3;
        vec4 high_3;
        int _S62 = int(8U * column_2);
        low_3[0] = inputs_8[min(_S62, 8)];
        high_3[0] = inputs_8[min(_S62 + 4, 8)];
        int _S63 = _S62 + 1;
        low_3[1] = inputs_8[min(_S63, 8)];
        high_3[1] = inputs_8[min(_S63 + 4, 8)];
        int _S64 = _S62 + 2;
        low_3[2] = inputs_8[min(_S64, 8)];
        high_3[2] = inputs_8[min(_S64 + 4, 8)];
        int _S65 = _S62 + 3;
        low_3[3] = inputs_8[min(_S65, 8)];
        high_3[3] = inputs_8[min(_S65 + 4, 8)];
        Eight_0 _S66 = FloatWeights_eight_0(weights_8, row_2 + column_2);
        sums_2[0] = sums_2[0] + (dot(_S66.low_0, low_3) + dot(_S66.high_0, high_3));
        Eight_0 _S67 = FloatWeights_eight_0(weights_8, row_2 + 2U + column_2);
        sums_2[1] = sums_2[1] + (dot(_S67.low_0, low_3) + dot(_S67.high_0, high_3));
        Eight_0 _S68 = FloatWeights_eight_0(weights_8, row_2 + 4U + column_2);
        sums_2[2] = sums_2[2] + (dot(_S68.low_0, low_3) + dot(_S68.high_0, high_3));
        Eight_0 _S69 = FloatWeights_eight_0(weights_8, row_2 + 6U + column_2);
        sums_2[3] = sums_2[3] + (dot(_S69.low_0, low_3) + dot(_S69.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
}

void dense_part_4(FloatWeights_0 weights_9, uint first_7, bool adds_6, inout float  inputs_9[9], inout float  outputs_6[25])
{
    uint _S70 = first_7 + uint(whole_parts_0(4));
    int output_4 = 0;
    for(;;)
    {
        bool _S71 = output_4 < 25;
        if(_S71)
        {
        }
        else
        {
            break;
        }
        uint _S72 = uint(output_4);
        Eight_0 _S73 = FloatWeights_eight_0(weights_9, first_7 + _S72 / 8U);
        vec4 _S74 = tile_product_2(weights_9, _S70 + _S72 * 2U, inputs_9);
        vec4 _S75;
        if((output_4 & 4) != 0)
        {
            _S75 = _S73.high_0;
        }
        else
        {
            _S75 = _S73.low_0;
        }
        vec4 _S76 = _S74 + _S75;
        float _S77;
        if(_S71)
        {
            if(adds_6)
            {
                _S77 = outputs_6[output_4];
            }
            else
            {
                _S77 = 0.0;
            }
            outputs_6[output_4] = Relu_apply_0(_S76[0] + _S77);
        }
        int _S78 = output_4 + 1;
        if(_S78 < 25)
        {
            if(adds_6)
            {
                _S77 = outputs_6[_S78];
            }
            else
            {
                _S77 = 0.0;
            }
            outputs_6[_S78] = Relu_apply_0(_S76[1] + _S77);
        }
        int _S79 = output_4 + 2;
        if(_S79 < 25)
        {
            if(adds_6)
            {
                _S77 = outputs_6[_S79];
            }
            else
            {
                _S77 = 0.0;
            }
            outputs_6[_S79] = Relu_apply_0(_S76[2] + _S77);
        }
        int _S80 = output_4 + 3;
        if(_S80 < 25)
        {
            if(adds_6)
            {
                _S77 = outputs_6[_S80];
            }
            else
            {
                _S77 = 0.0;
            }
            outputs_6[_S80] = Relu_apply_0(_S76[3] + _S77);
        }
        output_4 = output_4 + 4;
    }
    return;
}

void dense_2(FloatWeights_0 weights_10, uint first_8, bool adds_7, inout float  inputs_10[25], inout float  outputs_7[25])
{
    dense_part_2(weights_10, first_8, adds_7, inputs_10, outputs_7);
    return;
}

void dense_3(FloatWeights_0 weights_11, uint first_9, bool adds_8, inout float  inputs_11[25], inout float  outputs_8[1])
{
    dense_part_3(weights_11, first_9, adds_8, inputs_11, outputs_8);
    return;
}

void dense_4(FloatWeights_0 weights_12, uint first_10, bool adds_9, inout float  inputs_12[9], inout float  outputs_9[25])
{
    dense_part_4(weights_12, first_10, adds_9, inputs_12, outputs_9);
    return;
}

struct MLP_0
{
    FloatWeights_0 weights_13;
};

int layer_size_0(int inputs_13, int outputs_10)
{
    return whole_parts_0((outputs_10 + 7) / 8) + whole_parts_0((inputs_13 + 7) / 8 * ((outputs_10 + 4 - 1) / 4 * 4));
}

void MLP_evaluate_0(MLP_0 this_1, inout float  inputs_14[11], inout float  outputs_11[3])
{
    float  odd_0[25];
    float  even_0[25];
    dense_1(this_1.weights_13, 0U, false, inputs_14, even_0);
    int layer_0 = 1;
    for(;;)
    {
        if(layer_0 < 3)
        {
        }
        else
        {
            break;
        }
        int _S81 = layer_size_0(25, 25);
        uint _S82 = uint(layer_size_0(11, 25) + (layer_0 - 1) * _S81);
        dense_2(this_1.weights_13, _S82, false, even_0, odd_0);
        if((layer_0 + 1) < 3)
        {
            dense_2(this_1.weights_13, _S82 + uint(_S81), false, odd_0, even_0);
        }
        layer_0 = layer_0 + 2;
    }
    uint _S83 = uint(layer_size_0(11, 25) + 2 * layer_size_0(25, 25));
    dense_0(this_1.weights_13, _S83, false, even_0, outputs_11);
    return;
}

float saturate_0(float x_4)
{
    return clamp(x_4, 0.0, 1.0);
}

void MLP_evaluate_1(MLP_0 this_2, inout float  inputs_15[9], inout float  outputs_12[1])
{
    float  odd_1[25];
    float  even_1[25];
    dense_4(this_2.weights_13, 0U, false, inputs_15, even_1);
    int layer_1 = 1;
    for(;;)
    {
        if(layer_1 < 3)
        {
        }
        else
        {
            break;
        }
        int _S84 = layer_size_0(25, 25);
        uint _S85 = uint(layer_size_0(9, 25) + (layer_1 - 1) * _S84);
        dense_2(this_2.weights_13, _S85, false, even_1, odd_1);
        if((layer_1 + 1) < 3)
        {
            dense_2(this_2.weights_13, _S85 + uint(_S84), false, odd_1, even_1);
        }
        layer_1 = layer_1 + 2;
    }
    uint _S86 = uint(layer_size_0(9, 25) + 2 * layer_size_0(25, 25));
    dense_3(this_2.weights_13, _S86, false, even_1, outputs_12);
    return;
}

vec3 position_of_0(Vertex_0 vertex_0)
{
    return vec3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float square_0(vec3 v_1)
{
    return dot(v_1, v_1);
}

vec3 normal_of_0(Vertex_0 vertex_1)
{
    return vec3(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

struct VisiblePoint_0
{
    vec3 position_0;
    vec3 view_0;
    vec3 axis_x_0;
    vec3 axis_y_0;
    vec3 normal_0;
    vec3 face_normal_0;
    vec2 uv_0;
    vec2 draft_per_uv_0;
    vec2 draft_0;
    vec2 draft_dx_0;
    vec2 draft_dy_0;
};

vec3 to_local_0(VisiblePoint_0 point_0, vec3 direction_0)
{
    return vec3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

vec3 to_face_frame_0(vec3 direction_1, bool back_1)
{
    vec2 _S87 = direction_1.xy;
    float _S88;
    if(back_1)
    {
        _S88 = - direction_1.z;
    }
    else
    {
        _S88 = direction_1.z;
    }
    return vec3(_S87, _S88);
}

Eight_0 no_numbers_0()
{
    Eight_0 numbers_1;
    const vec4 _S89 = vec4(0.0);
    numbers_1.low_0 = _S89;
    numbers_1.high_0 = _S89;
    return numbers_1;
}

Eight_0 eight_halves_0(uvec4 packed_0)
{
    Eight_0 numbers_2;
    numbers_2.low_0 = vec4(unpackHalf2x16(packed_0.x), unpackHalf2x16(packed_0.y));
    numbers_2.high_0 = vec4(unpackHalf2x16(packed_0.z), unpackHalf2x16(packed_0.w));
    return numbers_2;
}

Eight_0 texel_numbers_0(uint first_11, uint elements_1, uint texel_0)
{
    uint _S90 = first_11 + texel_0 * elements_1;
    uvec4 _S91 = packed_numbers_0._data[uint(_S90)];
    if(elements_1 == 1U)
    {
        return eight_halves_0(_S91);
    }
    Eight_0 numbers_3;
    numbers_3.low_0 = uintBitsToFloat(_S91);
    numbers_3.high_0 = uintBitsToFloat(packed_numbers_0._data[uint(_S90 + 1U)]);
    return numbers_3;
}

void add_bilinear_0(uint first_12, uint elements_2, uint start_0, uint columns_0, uint rows_0, vec2 uv_1, float weight_0, inout Eight_0 sums_3)
{
    vec2 _S92 = uv_1 * vec2(float(columns_0), float(rows_0)) - 0.5;
    vec2 _S93 = floor(_S92);
    vec2 _S94 = _S92 - _S93;
    int _S95 = int(_S93.x);
    int _S96 = int(_S93.y);
    uint tap_0 = 0U;
    for(;;)
    {
        if(tap_0 < 4U)
        {
        }
        else
        {
            break;
        }
        uint _S97 = tap_0 & 1U;
        uint _S98 = tap_0 >> 1;
        Eight_0 _S99 = texel_numbers_0(first_12, elements_2, start_0 + (uint(_S96 + int(_S98)) & (rows_0 - 1U)) * columns_0 + (uint(_S95 + int(_S97)) & (columns_0 - 1U)));
        float _S100;
        if(_S98 != 0U)
        {
            _S100 = _S94.y;
        }
        else
        {
            _S100 = 1.0 - _S94.y;
        }
        float _S101;
        if(_S97 != 0U)
        {
            _S101 = _S94.x;
        }
        else
        {
            _S101 = 1.0 - _S94.x;
        }
        float _S102 = _S100 * _S101 * weight_0;
        sums_3.low_0 = sums_3.low_0 + _S102 * _S99.low_0;
        sums_3.high_0 = sums_3.high_0 + _S102 * _S99.high_0;
        tap_0 = tap_0 + 1U;
    }
    return;
}

float channel_0(Eight_0 numbers_4, int k_0)
{
    float _S103;
    if(k_0 < 4)
    {
        _S103 = numbers_4.low_0[k_0];
    }
    else
    {
        _S103 = numbers_4.high_0[k_0 - 4];
    }
    return _S103;
}

float neumip_depth_0(Neumip_0 model_0, vec2 uv_2, vec2 view_1, uint face_1)
{
    uint _S104 = words_0._data[uint(model_0.levels_2 + 1U)];
    uint _S105 = words_0._data[uint(model_0.levels_2 + 2U)];
    Eight_0 texel_1 = no_numbers_0();
    add_bilinear_0(model_0.offset_texels_0, model_0.texel_elements_0, face_1 * _S104 * _S105, _S104, _S105, fract(uv_2), 1.0, texel_1);
    float  inputs_16[9];
    int k_1 = 0;
    for(;;)
    {
        if(k_1 < 7)
        {
        }
        else
        {
            break;
        }
        inputs_16[k_1] = channel_0(texel_1, k_1);
        k_1 = k_1 + 1;
    }
    inputs_16[7] = view_1.x;
    inputs_16[8] = view_1.y;
    MLP_0 network_1;
    network_1.weights_13.first_0 = model_0.offset_0;
    float  depth_0[1];
    MLP_evaluate_1(network_1, inputs_16, depth_0);
    return depth_0[0];
}

float natural_logarithm_0(float x_5)
{
    uint _S106 = floatBitsToUint(x_5);
    float exponent_0 = float(int(_S106 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S106 & 8388607U) | 1056964608U);
    float m_1;
    float exponent_1;
    if(m_0 < 0.70710676908493042)
    {
        float exponent_2 = exponent_0 - 1.0;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    float m_2 = m_1 - 1.0;
    float _S107 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S107 - exponent_1 * 0.00021219444170129 - 0.5 * _S107) + exponent_1 * 0.693359375;
}

float binary_logarithm_0(float x_6)
{
    return natural_logarithm_0(x_6) * 1.4426950216293335;
}

Eight_0 neumip_texel_0(Neumip_0 model_1, vec2 uv_3, float level_0, uint face_2)
{
    float _S108 = clamp(level_0, 0.0, model_1.last_level_1);
    float _S109 = clamp(floor(_S108), 0.0, max(model_1.last_level_1 - 1.0, 0.0));
    float _S110 = _S108 - _S109;
    vec2 _S111 = clamp(fract(uv_3), vec2(0.0), vec2(1.0));
    Eight_0 texel_2 = no_numbers_0();
    uint offset_1 = 0U;
    for(;;)
    {
        if(offset_1 < 2U)
        {
        }
        else
        {
            break;
        }
        float _S112;
        if(offset_1 == 0U)
        {
            _S112 = 1.0 - _S110;
        }
        else
        {
            _S112 = _S110;
        }
        if(_S112 <= 0.0)
        {
            offset_1 = offset_1 + 1U;
            continue;
        }
        uint _S113 = model_1.levels_2 + 3U * (uint(_S109) + offset_1);
        add_bilinear_0(model_1.features_0, model_1.texel_elements_0, face_2 * model_1.face_texels_0 + words_0._data[uint(_S113)], words_0._data[uint(_S113 + 1U)], words_0._data[uint(_S113 + 2U)], _S111, _S112, texel_2);
        offset_1 = offset_1 + 1U;
    }
    return texel_2;
}

uint scramble_0(uint value_0)
{
    uint _S114 = value_0 * 747796405U + 2891336453U;
    uint _S115 = ((_S114 >> ((_S114 >> 28) + 4U)) ^ _S114) * 277803737U;
    return (_S115 >> 22) ^ _S115;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> 9) + 0.5) * 1.1920928955078125e-07;
}

vec2 pixel_sequence_0(uvec2 pixel_0, uint index_0, uint stream_1)
{
    uint _S116 = pixel_0.x;
    uint _S117 = pixel_0.y;
    return fract(vec2(uniform_hash_0(_S116, _S117, stream_1), uniform_hash_0(_S116, _S117, stream_1 + 1U)) + float(index_0 & 65535U) * vec2(0.75487768650054932, 0.56984031200408936));
}

float scene_number_0(uint index_1)
{
    return uintBitsToFloat(scene_words_0._data[uint(index_1)]);
}

struct Choice_0
{
    uint index_2;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_0, float number_0)
{
    uint high_4 = count_0;
    uint low_4 = 0U;
    for(;;)
    {
        if((high_4 - low_4) > 1U)
        {
        }
        else
        {
            break;
        }
        uint _S118 = (low_4 + high_4) / 2U;
        if((scene_number_0(table_0 + _S118)) <= number_0)
        {
            low_4 = _S118;
        }
        else
        {
            high_4 = _S118;
        }
    }
    uint _S119 = table_0 + low_4;
    float _S120 = scene_number_0(_S119);
    float _S121 = scene_number_0(_S119 + 1U);
    Choice_0 choice_0;
    choice_0.index_2 = low_4;
    choice_0.remainder_0 = saturate_0((number_0 - _S120) / max(_S121 - _S120, 9.999999960041972e-13));
    return choice_0;
}

float mean_0(vec3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0;
}

vec2 sine_cosine_0(float x_7)
{
    float _S122 = floor(x_7 * 0.63661974668502808 + 0.5);
    float _S123 = x_7 - _S122 * 1.5703125 - _S122 * 0.00048375129699707 - _S122 * 7.54979012640433211e-08;
    float _S124 = _S123 * _S123;
    float _S125 = ((-0.00019515295571182 * _S124 + 0.00833216123282909) * _S124 - 0.16666655242443085) * _S124 * _S123 + _S123;
    float _S126 = ((0.00002443315679557 * _S124 - 0.00138873164542019) * _S124 + 0.04166664555668831) * _S124 * _S124 - 0.5 * _S124 + 1.0;
    uint _S127 = uint(int(_S122)) & 3U;
    vec2 _S128;
    if((_S127 & 1U) != 0U)
    {
        _S128 = vec2(_S126, _S125);
    }
    else
    {
        _S128 = vec2(_S125, _S126);
    }
    float _S129;
    if((_S127 & 2U) != 0U)
    {
        _S129 = - _S128.x;
    }
    else
    {
        _S129 = _S128.x;
    }
    float _S130;
    if(((_S127 + 1U) & 2U) != 0U)
    {
        _S130 = - _S128.y;
    }
    else
    {
        _S130 = _S128.y;
    }
    return vec2(_S129, _S130);
}

void accumulate_0(uint index_3, vec4 light_0)
{
    float _S131 = layers_0._data[uint(index_3)].share_0;
    radiance_0._data[uint(index_3)] = radiance_0._data[uint(index_3)] + layers_0._data[uint(index_3)].share_0 * light_0;
    layers_0._data[uint(index_3)].share_0 = _S131 * (1.0 - light_0.w);
    return;
}

vec3 camera_right_0(int _S132)
{
    return vec3(frames_0._data[uint(_S132)].right_x_0, frames_0._data[uint(_S132)].right_y_0, frames_0._data[uint(_S132)].right_z_0);
}

vec3 camera_up_0(int _S133)
{
    return vec3(frames_0._data[uint(_S133)].up_x_0, frames_0._data[uint(_S133)].up_y_0, frames_0._data[uint(_S133)].up_z_0);
}

vec3 camera_forward_0(int _S134)
{
    return vec3(frames_0._data[uint(_S134)].forward_x_0, frames_0._data[uint(_S134)].forward_y_0, frames_0._data[uint(_S134)].forward_z_0);
}

vec3 camera_origin_0(int _S135)
{
    return vec3(frames_0._data[uint(_S135)].origin_x_0, frames_0._data[uint(_S135)].origin_y_0, frames_0._data[uint(_S135)].origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S136, uint _S137, float _S138, float _S139)
{
    uint _S140 = 3U * _S137;
    Vertex_0 _S141 = vertices_0._data[uint(corners_0._data[uint(_S140)])];
    Vertex_0 _S142 = vertices_0._data[uint(corners_0._data[uint(_S140 + 1U)])];
    Vertex_0 _S143 = vertices_0._data[uint(corners_0._data[uint(_S140 + 2U)])];
    vec3 _S144 = position_of_0(_S141);
    vec3 _S145 = position_of_0(_S142) - _S144;
    vec3 _S146 = position_of_0(_S143) - _S144;
    float _S147 = _S142.u_0 - _S141.u_0;
    float _S148 = _S142.v_0 - _S141.v_0;
    vec2 _S149 = vec2(_S147, _S148);
    float _S150 = _S143.u_0 - _S141.u_0;
    float _S151 = _S143.v_0 - _S141.v_0;
    vec2 _S152 = vec2(_S150, _S151);
    float _S153;
    if((_S147 * _S151 - _S148 * _S150) < 0.0)
    {
        _S153 = -1.0;
    }
    else
    {
        _S153 = 1.0;
    }
    vec3 _S154 = _S153 * (_S151 * _S145 - _S148 * _S146);
    vec3 _S155 = _S153 * (_S147 * _S146 - _S150 * _S145);
    VisiblePoint_0 point_1;
    vec3 _S156 = normalize((1.0 - _S138 - _S139) * normal_of_0(_S141) + _S138 * normal_of_0(_S142) + _S139 * normal_of_0(_S143));
    point_1.normal_0 = _S156;
    vec3 _S157 = normalize(_S154 - _S156 * dot(_S156, _S154));
    point_1.axis_x_0 = _S157;
    point_1.axis_y_0 = cross(_S156, _S157);
    vec3 _S158 = normalize(cross(_S145, _S146));
    vec3 _S159;
    if((dot(_S158, _S156)) < 0.0)
    {
        _S159 = - _S158;
    }
    else
    {
        _S159 = _S158;
    }
    point_1.face_normal_0 = _S159;
    point_1.position_0 = _S144 + _S138 * _S145 + _S139 * _S146;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_0 = vec2(_S141.u_0, _S141.v_0) + _S138 * _S149 + _S139 * _S152;
    bool _S160 = (dot(cross(_S154, _S155), point_1.normal_0)) < 0.0;
    float _S161 = fabrics_0._data[uint(_S136)].uv_width_0;
    if(_S160)
    {
        _S153 = - fabrics_0._data[uint(_S136)].uv_height_0;
    }
    else
    {
        _S153 = fabrics_0._data[uint(_S136)].uv_height_0;
    }
    vec2 _S162 = vec2(_S161, _S153);
    point_1.draft_per_uv_0 = _S162;
    vec2 _S163 = point_1.uv_0 * _S162;
    if(_S160)
    {
        _S153 = fabrics_0._data[uint(_S136)].uv_height_0;
    }
    else
    {
        _S153 = 0.0;
    }
    point_1.draft_0 = _S163 + vec2(0.0, _S153);
    const vec2 _S164 = vec2(0.0);
    point_1.draft_dx_0 = _S164;
    point_1.draft_dy_0 = _S164;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S165, uint _S166, uint _S167, uvec2 _S168)
{
    uint _S169 = 3U * _S167;
    Vertex_0 _S170 = vertices_0._data[uint(corners_0._data[uint(_S169)])];
    Vertex_0 _S171 = vertices_0._data[uint(corners_0._data[uint(_S169 + 1U)])];
    Vertex_0 _S172 = vertices_0._data[uint(corners_0._data[uint(_S169 + 2U)])];
    vec3 _S173 = position_of_0(_S170);
    vec3 _S174 = position_of_0(_S171) - _S173;
    vec3 _S175 = position_of_0(_S172) - _S173;
    vec3 _S176 = cross(_S174, _S175);
    float _S177 = 1.0 / max(square_0(_S176), 1.00000000317107685e-30);
    float _S178 = float(frames_0._data[uint(_S165)].width_0);
    vec3 _S179 = camera_right_0(_S165) * (2.0 / _S178);
    float _S180 = float(frames_0._data[uint(_S165)].height_0);
    vec3 _S181 = camera_up_0(_S165) * (-2.0 / _S180);
    vec3 _S182 = camera_forward_0(_S165) + (float(_S168.x) + 0.5 - 0.5 * _S178) * _S179 + (float(_S168.y) + 0.5 - 0.5 * _S180) * _S181;
    float _S183 = dot(_S182, _S176);
    float _S184;
    if((abs(_S183)) > 1.00000000317107685e-30)
    {
        _S184 = _S183;
    }
    else
    {
        _S184 = 1.00000000317107685e-30;
    }
    float _S185 = 1.0 / _S184;
    vec3 _S186 = _S173 - camera_origin_0(_S165);
    float _S187 = dot(_S186, _S176) * _S185;
    vec3 _S188 = _S182 * _S187 - _S186;
    vec3 _S189 = _S187 * (_S179 - _S182 * (dot(_S179, _S176) * _S185));
    vec3 _S190 = _S187 * (_S181 - _S182 * (dot(_S181, _S176) * _S185));
    vec3 _S191 = cross(_S175, _S176) * _S177;
    vec3 _S192 = cross(_S176, _S174) * _S177;
    vec2 _S193 = vec2(_S171.u_0 - _S170.u_0, _S171.v_0 - _S170.v_0);
    vec2 _S194 = vec2(_S172.u_0 - _S170.u_0, _S172.v_0 - _S170.v_0);
    VisiblePoint_0 point_2 = face_point_0(_S166, _S167, dot(_S188, _S191), dot(_S188, _S192));
    point_2.position_0 = _S173 + _S188;
    point_2.view_0 = - normalize(_S182);
    point_2.draft_dx_0 = (dot(_S189, _S191) * _S193 + dot(_S189, _S192) * _S194) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (dot(_S190, _S191) * _S193 + dot(_S190, _S192) * _S194) * point_2.draft_per_uv_0;
    return point_2;
}

struct Footprint_0
{
    vec2 centre_0;
    vec2 dx_0;
    vec2 dy_0;
};

struct NeumipView_0
{
    float  latent_0[7];
    vec2 view_2;
    bool back_2;
};

void neumip_view_0(uint _S195, Footprint_0 _S196, vec3 _S197, inout NeumipView_0 _S198)
{
    Neumip_0 _S199 = fabrics_0._data[uint(_S195)].neumip_0;
    bool _S200 = (_S197.z) < 0.0;
    uint _S201;
    if(_S200)
    {
        _S201 = _S199.back_0;
    }
    else
    {
        _S201 = 0U;
    }
    vec3 _S202 = to_face_frame_0(_S197, _S200);
    vec2 uv_4 = _S196.centre_0 * vec2(_S199.repeats_per_x_0, _S199.repeats_per_y_0);
    vec2 uv_5;
    if((_S199.has_offset_0) != 0U)
    {
        vec2 _S203 = _S202.xy;
        uv_5 = uv_4 + neumip_depth_0(_S199, uv_4, _S203, _S201) / max(_S202.z, 0.60000002384185791) * _S203 * vec2(_S199.unit_x_0, _S199.unit_y_0);
    }
    else
    {
        uv_5 = uv_4;
    }
    Eight_0 _S204 = neumip_texel_0(_S199, uv_5, binary_logarithm_0(max(sqrt(abs(_S196.dx_0.x * _S196.dy_0.y - _S196.dx_0.y * _S196.dy_0.x)) * _S199.texels_per_mm_0, 9.99999971718068537e-10)), _S201);
    int k_2 = 0;
    for(;;)
    {
        if(k_2 < 7)
        {
        }
        else
        {
            break;
        }
        _S198.latent_0[k_2] = channel_0(_S204, k_2);
        k_2 = k_2 + 1;
    }
    _S198.view_2 = _S202.xy;
    _S198.back_2 = _S200;
    return;
}

uint light_sample_count_0(int _S205)
{
    return frames_0._data[uint(_S205)].lights_0 + frames_0._data[uint(_S205)].environment_samples_0;
}

float visibility_at_0(int _S206, uint _S207, uvec2 _S208)
{
    if((frames_0._data[uint(_S206)].casts_shadows_0) == 0U)
    {
        return 1.0;
    }
    return visibilities_0._data[uint((_S207 * frames_0._data[uint(_S206)].height_0 + _S208.y) * frames_0._data[uint(_S206)].width_0 + _S208.x)];
}

struct LightSample_0
{
    vec3 towards_0;
    vec3 irradiance_1;
    float distance_0;
};

vec3 environment_texel_0(int _S209, uint _S210, uint _S211)
{
    uint _S212 = frames_0._data[uint(_S209)].environment_table_0 + frames_0._data[uint(_S209)].environment_rows_0 + 1U + frames_0._data[uint(_S209)].environment_rows_0 * (frames_0._data[uint(_S209)].environment_columns_0 + 1U) + 3U * (_S210 * frames_0._data[uint(_S209)].environment_columns_0 + _S211);
    return vec3(scene_number_0(_S212), scene_number_0(_S212 + 1U), scene_number_0(_S212 + 2U));
}

vec3 sample_environment_0(int _S213, vec2 _S214, out vec3 _S215)
{
    uint _S216 = frames_0._data[uint(_S213)].environment_rows_0;
    Choice_0 _S217 = choose_0(frames_0._data[uint(_S213)].environment_table_0, frames_0._data[uint(_S213)].environment_rows_0, _S214.y);
    uint _S218 = frames_0._data[uint(_S213)].environment_columns_0;
    Choice_0 _S219 = choose_0(frames_0._data[uint(_S213)].environment_table_0 + frames_0._data[uint(_S213)].environment_rows_0 + 1U + _S217.index_2 * (frames_0._data[uint(_S213)].environment_columns_0 + 1U), frames_0._data[uint(_S213)].environment_columns_0, _S214.x);
    vec3 _S220 = environment_texel_0(_S213, _S217.index_2, _S219.index_2);
    _S215 = _S220 * (frames_0._data[uint(_S213)].environment_total_0 / max(mean_0(_S220), 9.99999968265522539e-21));
    float _S221 = 3.14159274101257324 / float(_S216);
    float _S222 = mix(sine_cosine_0(float(_S217.index_2) * _S221).y, sine_cosine_0(float(_S217.index_2 + 1U) * _S221).y, _S217.remainder_0);
    float _S223 = sqrt(max(1.0 - _S222 * _S222, 0.0));
    vec2 _S224 = sine_cosine_0((float(_S219.index_2) + _S219.remainder_0) * (6.28318548202514648 / float(_S218)));
    float _S225 = _S223 * _S224.x;
    float _S226 = - _S223 * _S224.y;
    return vec3(frames_0._data[uint(_S213)].environment_cosine_0 * _S225 + frames_0._data[uint(_S213)].environment_sine_0 * _S226, _S222, frames_0._data[uint(_S213)].environment_cosine_0 * _S226 - frames_0._data[uint(_S213)].environment_sine_0 * _S225);
}

LightSample_0 light_sample_0(int _S227, uint _S228, uvec2 _S229, vec3 _S230)
{
    LightSample_0 sample_0;
    sample_0.distance_0 = 1.00000001504746622e+30;
    uint _S231 = frames_0._data[uint(_S227)].lights_0;
    if(_S228 >= (frames_0._data[uint(_S227)].lights_0))
    {
        vec3 weight_1;
        vec3 _S232 = sample_environment_0(_S227, pixel_sequence_0(_S229, frames_0._data[uint(_S227)].pass_number_0 * frames_0._data[uint(_S227)].environment_samples_0 + (_S228 - _S231), 3U), weight_1);
        sample_0.towards_0 = _S232;
        sample_0.irradiance_1 = weight_1 / float(frames_0._data[uint(_S227)].environment_samples_0);
        return sample_0;
    }
    Light_0 _S233 = lights_1._data[uint(_S228)];
    sample_0.irradiance_1 = vec3(_S233.red_0, _S233.green_0, _S233.blue_0);
    sample_0.towards_0 = vec3(_S233.x_1, _S233.y_1, _S233.z_1);
    if((_S233.is_point_0) != 0U)
    {
        vec3 _S234 = sample_0.towards_0 - _S230;
        float _S235 = max(square_0(_S234), 9.999999960041972e-13);
        sample_0.distance_0 = sqrt(_S235);
        sample_0.irradiance_1 = sample_0.irradiance_1 / _S235;
        sample_0.towards_0 = normalize(_S234);
    }
    return sample_0;
}

vec3 neumip_value_0(uint _S236, inout NeumipView_0 _S237, vec3 _S238)
{
    vec3 _S239 = to_face_frame_0(_S238, _S237.back_2);
    if((_S239.z) <= 0.0)
    {
        return vec3(0.0);
    }
    float  inputs_17[11];
    int k_3 = 0;
    for(;;)
    {
        if(k_3 < 7)
        {
        }
        else
        {
            break;
        }
        inputs_17[k_3] = _S237.latent_0[k_3];
        k_3 = k_3 + 1;
    }
    inputs_17[7] = _S239.x;
    inputs_17[8] = _S239.y;
    inputs_17[9] = _S237.view_2.x;
    inputs_17[10] = _S237.view_2.y;
    MLP_0 network_2;
    network_2.weights_13.first_0 = fabrics_0._data[uint(_S236)].neumip_0.decoder_0;
    float  outputs_13[3];
    MLP_evaluate_0(network_2, inputs_17, outputs_13);
    return max(vec3(outputs_13[0], outputs_13[1], outputs_13[2]), vec3(0.0)) * 0.31830987334251404;
}

vec4 light_of_neumip_0(int _S240, uint _S241, VisiblePoint_0 _S242, uvec2 _S243)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = _S242.draft_0;
    footprint_0.dx_0 = _S242.draft_dx_0;
    footprint_0.dy_0 = _S242.draft_dy_0;
    NeumipView_0 seen_0;
    neumip_view_0(_S241, footprint_0, to_local_0(_S242, _S242.view_0), seen_0);
    const vec3 _S244 = vec3(0.0);
    uint number_1 = 0U;
    vec3 radiance_1 = _S244;
    for(;;)
    {
        if(number_1 < (light_sample_count_0(_S240)))
        {
        }
        else
        {
            break;
        }
        float _S245 = visibility_at_0(_S240, number_1, _S243);
        if(_S245 <= 0.0)
        {
            number_1 = number_1 + 1U;
            continue;
        }
        LightSample_0 _S246 = light_sample_0(_S240, number_1, _S243, _S242.position_0);
        vec3 _S247 = _S245 * _S246.irradiance_1;
        vec3 _S248 = neumip_value_0(_S241, seen_0, to_local_0(_S242, _S246.towards_0));
        radiance_1 = radiance_1 + _S247 * _S248;
        number_1 = number_1 + 1U;
    }
    return vec4(radiance_1, 1.0);
}

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
void main()
{
    uint _S249 = frames_0._data[uint(0)].width_0;
    bool _S250;
    if((gl_GlobalInvocationID.x) >= (frames_0._data[uint(0)].width_0))
    {
        _S250 = true;
    }
    else
    {
        _S250 = (gl_GlobalInvocationID.y) >= (frames_0._data[uint(0)].height_0);
    }
    if(_S250)
    {
        return;
    }
    uint _S251 = gl_GlobalInvocationID.y * _S249 + gl_GlobalInvocationID.x;
    uint _S252 = layers_0._data[uint(_S251)].face_0;
    if((layers_0._data[uint(_S251)].face_0) == 0U)
    {
        return;
    }
    uint _S253 = _S252 - 1U;
    uint _S254 = face_fabrics_0._data[uint(_S253)];
    accumulate_0(_S251, light_of_neumip_0(0, _S254, visible_point_0(0, _S254, _S253, gl_GlobalInvocationID.xy), gl_GlobalInvocationID.xy));
    return;
}

