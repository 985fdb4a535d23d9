#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
struct FloatWeights_0
{
    uint first_0;
};

struct Frame_0
{
    uint width_0;
    uint height_0;
    uint lights_0;
    uint samples_0;
    uint pass_number_0;
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

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Woven_0 woven_0;
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
};

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

struct Family_0
{
    uint is_alike_0;
    float count_0;
    float inverse_count_0;
    float half_inverse_count_0;
    float size_0;
    float inverse_size_0;
    float half_width_0;
    float start_0;
    float period_0;
    float inverse_period_0;
    float bins_0;
    uint first_thread_table_0;
    uint place_table_0;
    uint bend_table_0;
    float height_scale_0;
    float twist_sine_0;
    float twist_cosine_0;
    float level_0;
    float roughness_0;
    uint albedo_table_0;
    uint albedo_stride_0;
    uint before_0;
    float visible_total_0;
    float smallest_box_0;
    uint quantities_0;
    uint colour_mean_0;
    uint colour_axes_0;
    uint colour_threads_0;
    uint colour_areas_0;
    float area_unit_0;
    float crossing_area_0;
};

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

struct KernelContext_0
{
    Frame_0 device* frames_0;
    texture2d<uint, access::sample> visible_faces_0;
    uint device* face_fabrics_0;
    Fabric_0 device* fabrics_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
    packed_uint4 device* packed_numbers_0;
    uint device* words_0;
    Family_0 device* families_0;
    Light_0 device* lights_1;
    packed_float4 device* radiance_0;
};

struct Eight_0
{
    float4 low_0;
    float4 high_0;
};

Eight_0 FloatWeights_eight_0(const FloatWeights_0 thread* this_0, uint element_0, KernelContext_0 thread* kernelContext_0)
{
    thread Eight_0 numbers_0;
    uint _S1 = this_0->first_0 + 2U * element_0;
    (&numbers_0)->low_0 = (as_type<float4>((uint4(*(kernelContext_0->packed_numbers_0+_S1)) )));
    (&numbers_0)->high_0 = (as_type<float4>((uint4(*(kernelContext_0->packed_numbers_0+(_S1 + 1U))) )));
    return numbers_0;
}

float4 tile_product_0(const FloatWeights_0 thread* weights_0, uint row_0, array<float, int(96)> thread* inputs_0, KernelContext_0 thread* kernelContext_1)
{
    thread float4 sums_0 = float4(0.0f) ;
    uint column_0 = 0U;
    for(;;)
    {
        if(column_0 < 12U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_1;
        thread float4 high_1;
        int _S2 = int(8U * column_0);
        low_1.x = (*inputs_0)[_S2];
        high_1.x = (*inputs_0)[_S2 + int(4)];
        int _S3 = _S2 + int(1);
        low_1.y = (*inputs_0)[_S3];
        high_1.y = (*inputs_0)[_S3 + int(4)];
        int _S4 = _S2 + int(2);
        low_1.z = (*inputs_0)[_S4];
        high_1.z = (*inputs_0)[_S4 + int(4)];
        int _S5 = _S2 + int(3);
        low_1.w = (*inputs_0)[_S5];
        high_1.w = (*inputs_0)[_S5 + int(4)];
        Eight_0 _S6 = FloatWeights_eight_0(weights_0, row_0 + column_0, kernelContext_1);
        sums_0.x = sums_0.x + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0, kernelContext_1);
        sums_0.y = sums_0.y + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0, kernelContext_1);
        sums_0.z = sums_0.z + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0, kernelContext_1);
        sums_0.w = sums_0.w + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
}

int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

float Identity_apply_0(float x_2)
{
    return x_2;
}

void dense_part_0(const FloatWeights_0 thread* weights_1, uint first_1, bool adds_0, array<float, int(96)> thread* inputs_1, array<float, int(50)> thread* outputs_0, KernelContext_0 thread* kernelContext_2)
{
    uint _S10 = first_1 + uint(whole_parts_0(int(7)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S11 = output_0 < int(50);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        uint _S12 = uint(output_0);
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U, kernelContext_2);
        float4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 12U, inputs_1, kernelContext_2);
        float4 _S15;
        if((output_0 & int(4)) != int(0))
        {
            _S15 = _S13.high_0;
        }
        else
        {
            _S15 = _S13.low_0;
        }
        float4 _S16 = _S14 + _S15;
        float _S17;
        if(_S11)
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[output_0];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[output_0] = Identity_apply_0(_S16[int(0)] + _S17);
        }
        int _S18 = output_0 + int(1);
        if(_S18 < int(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S18] = Identity_apply_0(_S16[int(1)] + _S17);
        }
        int _S19 = output_0 + int(2);
        if(_S19 < int(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S19] = Identity_apply_0(_S16[int(2)] + _S17);
        }
        int _S20 = output_0 + int(3);
        if(_S20 < int(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S20] = Identity_apply_0(_S16[int(3)] + _S17);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

struct HalfWeights_0
{
    uint first_2;
};

float2 f16tof32_0(uint2 value_0)
{
    thread float2 result_0;
    int i_0 = int(0);
    for(;;)
    {
        if(i_0 < int(2))
        {
        }
        else
        {
            break;
        }
        result_0[i_0] = (as_type<half>((ushort)((value_0[i_0]))));
        i_0 = i_0 + int(1);
    }
    return result_0;
}

Eight_0 eight_halves_0(uint4 packed_0)
{
    thread Eight_0 numbers_1;
    uint _S21 = packed_0.x;
    uint _S22 = packed_0.y;
    (&numbers_1)->low_0 = float4(f16tof32_0(uint2(_S21 & 65535U, _S21 >> 16U)), f16tof32_0(uint2(_S22 & 65535U, _S22 >> 16U)));
    uint _S23 = packed_0.z;
    uint _S24 = packed_0.w;
    (&numbers_1)->high_0 = float4(f16tof32_0(uint2(_S23 & 65535U, _S23 >> 16U)), f16tof32_0(uint2(_S24 & 65535U, _S24 >> 16U)));
    return numbers_1;
}

Eight_0 HalfWeights_eight_0(const HalfWeights_0 thread* this_1, uint element_1, KernelContext_0 thread* kernelContext_3)
{
    return eight_halves_0(uint4(*(kernelContext_3->packed_numbers_0+(this_1->first_2 + element_1))) );
}

float4 tile_product_1(const HalfWeights_0 thread* weights_2, uint row_1, array<float, int(96)> thread* inputs_2, KernelContext_0 thread* kernelContext_4)
{
    thread float4 sums_1 = float4(0.0f) ;
    uint column_1 = 0U;
    for(;;)
    {
        if(column_1 < 12U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_2;
        thread float4 high_2;
        int _S25 = int(8U * column_1);
        low_2.x = (*inputs_2)[_S25];
        high_2.x = (*inputs_2)[_S25 + int(4)];
        int _S26 = _S25 + int(1);
        low_2.y = (*inputs_2)[_S26];
        high_2.y = (*inputs_2)[_S26 + int(4)];
        int _S27 = _S25 + int(2);
        low_2.z = (*inputs_2)[_S27];
        high_2.z = (*inputs_2)[_S27 + int(4)];
        int _S28 = _S25 + int(3);
        low_2.w = (*inputs_2)[_S28];
        high_2.w = (*inputs_2)[_S28 + int(4)];
        Eight_0 _S29 = HalfWeights_eight_0(weights_2, row_1 + column_1, kernelContext_4);
        sums_1.x = sums_1.x + (dot(_S29.low_0, low_2) + dot(_S29.high_0, high_2));
        Eight_0 _S30 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1, kernelContext_4);
        sums_1.y = sums_1.y + (dot(_S30.low_0, low_2) + dot(_S30.high_0, high_2));
        Eight_0 _S31 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1, kernelContext_4);
        sums_1.z = sums_1.z + (dot(_S31.low_0, low_2) + dot(_S31.high_0, high_2));
        Eight_0 _S32 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1, kernelContext_4);
        sums_1.w = sums_1.w + (dot(_S32.low_0, low_2) + dot(_S32.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
}

void dense_part_1(const HalfWeights_0 thread* weights_3, uint first_3, bool adds_1, array<float, int(96)> thread* inputs_3, array<float, int(52)> thread* outputs_1, KernelContext_0 thread* kernelContext_5)
{
    uint _S33 = first_3 + uint(whole_parts_0(int(7)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S34 = output_1 < int(52);
        if(_S34)
        {
        }
        else
        {
            break;
        }
        uint _S35 = uint(output_1);
        Eight_0 _S36 = HalfWeights_eight_0(weights_3, first_3 + _S35 / 8U, kernelContext_5);
        float4 _S37 = tile_product_1(weights_3, _S33 + _S35 * 12U, inputs_3, kernelContext_5);
        float4 _S38;
        if((output_1 & int(4)) != int(0))
        {
            _S38 = _S36.high_0;
        }
        else
        {
            _S38 = _S36.low_0;
        }
        float4 _S39 = _S37 + _S38;
        float _S40;
        if(_S34)
        {
            if(adds_1)
            {
                _S40 = (*outputs_1)[output_1];
            }
            else
            {
                _S40 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S39[int(0)] + _S40);
        }
        int _S41 = output_1 + int(1);
        if(_S41 < int(52))
        {
            if(adds_1)
            {
                _S40 = (*outputs_1)[_S41];
            }
            else
            {
                _S40 = 0.0f;
            }
            (*outputs_1)[_S41] = Identity_apply_0(_S39[int(1)] + _S40);
        }
        int _S42 = output_1 + int(2);
        if(_S42 < int(52))
        {
            if(adds_1)
            {
                _S40 = (*outputs_1)[_S42];
            }
            else
            {
                _S40 = 0.0f;
            }
            (*outputs_1)[_S42] = Identity_apply_0(_S39[int(2)] + _S40);
        }
        int _S43 = output_1 + int(3);
        if(_S43 < int(52))
        {
            if(adds_1)
            {
                _S40 = (*outputs_1)[_S43];
            }
            else
            {
                _S40 = 0.0f;
            }
            (*outputs_1)[_S43] = Identity_apply_0(_S39[int(3)] + _S40);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

float4 tile_product_2(const HalfWeights_0 thread* weights_4, uint row_2, array<float, int(39)> thread* inputs_4, KernelContext_0 thread* kernelContext_6)
{
    thread float4 sums_2 = float4(0.0f) ;
    uint column_2 = 0U;
    for(;;)
    {
        if(column_2 < 5U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_3;
        thread float4 high_3;
        int _S44 = int(8U * column_2);
        low_3.x = (*inputs_4)[min(_S44, int(38))];
        high_3.x = (*inputs_4)[min(_S44 + int(4), int(38))];
        int _S45 = _S44 + int(1);
        low_3.y = (*inputs_4)[min(_S45, int(38))];
        high_3.y = (*inputs_4)[min(_S45 + int(4), int(38))];
        int _S46 = _S44 + int(2);
        low_3.z = (*inputs_4)[min(_S46, int(38))];
        high_3.z = (*inputs_4)[min(_S46 + int(4), int(38))];
        int _S47 = _S44 + int(3);
        low_3.w = (*inputs_4)[min(_S47, int(38))];
        high_3.w = (*inputs_4)[min(_S47 + int(4), int(38))];
        Eight_0 _S48 = HalfWeights_eight_0(weights_4, row_2 + column_2, kernelContext_6);
        sums_2.x = sums_2.x + (dot(_S48.low_0, low_3) + dot(_S48.high_0, high_3));
        Eight_0 _S49 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2, kernelContext_6);
        sums_2.y = sums_2.y + (dot(_S49.low_0, low_3) + dot(_S49.high_0, high_3));
        Eight_0 _S50 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2, kernelContext_6);
        sums_2.z = sums_2.z + (dot(_S50.low_0, low_3) + dot(_S50.high_0, high_3));
        Eight_0 _S51 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2, kernelContext_6);
        sums_2.w = sums_2.w + (dot(_S51.low_0, low_3) + dot(_S51.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
}

void dense_part_2(const HalfWeights_0 thread* weights_5, uint first_4, bool adds_2, array<float, int(39)> thread* inputs_5, array<float, int(96)> thread* outputs_2, KernelContext_0 thread* kernelContext_7)
{
    uint _S52 = first_4 + uint(whole_parts_0(int(12)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S53 = output_2 < int(96);
        if(_S53)
        {
        }
        else
        {
            break;
        }
        uint _S54 = uint(output_2);
        Eight_0 _S55 = HalfWeights_eight_0(weights_5, first_4 + _S54 / 8U, kernelContext_7);
        float4 _S56 = tile_product_2(weights_5, _S52 + _S54 * 5U, inputs_5, kernelContext_7);
        float4 _S57;
        if((output_2 & int(4)) != int(0))
        {
            _S57 = _S55.high_0;
        }
        else
        {
            _S57 = _S55.low_0;
        }
        float4 _S58 = _S56 + _S57;
        float _S59;
        if(_S53)
        {
            if(adds_2)
            {
                _S59 = (*outputs_2)[output_2];
            }
            else
            {
                _S59 = 0.0f;
            }
            (*outputs_2)[output_2] = Identity_apply_0(_S58[int(0)] + _S59);
        }
        int _S60 = output_2 + int(1);
        if(_S60 < int(96))
        {
            if(adds_2)
            {
                _S59 = (*outputs_2)[_S60];
            }
            else
            {
                _S59 = 0.0f;
            }
            (*outputs_2)[_S60] = Identity_apply_0(_S58[int(1)] + _S59);
        }
        int _S61 = output_2 + int(2);
        if(_S61 < int(96))
        {
            if(adds_2)
            {
                _S59 = (*outputs_2)[_S61];
            }
            else
            {
                _S59 = 0.0f;
            }
            (*outputs_2)[_S61] = Identity_apply_0(_S58[int(2)] + _S59);
        }
        int _S62 = output_2 + int(3);
        if(_S62 < int(96))
        {
            if(adds_2)
            {
                _S59 = (*outputs_2)[_S62];
            }
            else
            {
                _S59 = 0.0f;
            }
            (*outputs_2)[_S62] = Identity_apply_0(_S58[int(3)] + _S59);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

float4 tile_product_3(const HalfWeights_0 thread* weights_6, uint row_3, array<float, int(100)> thread* inputs_6, KernelContext_0 thread* kernelContext_8)
{
    thread float4 sums_3 = float4(0.0f) ;
    uint column_3 = 0U;
    for(;;)
    {
        if(column_3 < 13U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_4;
        thread float4 high_4;
        int _S63 = int(8U * column_3);
        low_4.x = (*inputs_6)[min(_S63, int(99))];
        high_4.x = (*inputs_6)[min(_S63 + int(4), int(99))];
        int _S64 = _S63 + int(1);
        low_4.y = (*inputs_6)[min(_S64, int(99))];
        high_4.y = (*inputs_6)[min(_S64 + int(4), int(99))];
        int _S65 = _S63 + int(2);
        low_4.z = (*inputs_6)[min(_S65, int(99))];
        high_4.z = (*inputs_6)[min(_S65 + int(4), int(99))];
        int _S66 = _S63 + int(3);
        low_4.w = (*inputs_6)[min(_S66, int(99))];
        high_4.w = (*inputs_6)[min(_S66 + int(4), int(99))];
        Eight_0 _S67 = HalfWeights_eight_0(weights_6, row_3 + column_3, kernelContext_8);
        sums_3.x = sums_3.x + (dot(_S67.low_0, low_4) + dot(_S67.high_0, high_4));
        Eight_0 _S68 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3, kernelContext_8);
        sums_3.y = sums_3.y + (dot(_S68.low_0, low_4) + dot(_S68.high_0, high_4));
        Eight_0 _S69 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3, kernelContext_8);
        sums_3.z = sums_3.z + (dot(_S69.low_0, low_4) + dot(_S69.high_0, high_4));
        Eight_0 _S70 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3, kernelContext_8);
        sums_3.w = sums_3.w + (dot(_S70.low_0, low_4) + dot(_S70.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_3;
}

void dense_part_3(const HalfWeights_0 thread* weights_7, uint first_5, bool adds_3, array<float, int(100)> thread* inputs_7, array<float, int(96)> thread* outputs_3, KernelContext_0 thread* kernelContext_9)
{
    uint _S71 = first_5 + uint(whole_parts_0(int(12)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S72 = output_3 < int(96);
        if(_S72)
        {
        }
        else
        {
            break;
        }
        uint _S73 = uint(output_3);
        Eight_0 _S74 = HalfWeights_eight_0(weights_7, first_5 + _S73 / 8U, kernelContext_9);
        float4 _S75 = tile_product_3(weights_7, _S71 + _S73 * 13U, inputs_7, kernelContext_9);
        float4 _S76;
        if((output_3 & int(4)) != int(0))
        {
            _S76 = _S74.high_0;
        }
        else
        {
            _S76 = _S74.low_0;
        }
        float4 _S77 = _S75 + _S76;
        float _S78;
        if(_S72)
        {
            if(adds_3)
            {
                _S78 = (*outputs_3)[output_3];
            }
            else
            {
                _S78 = 0.0f;
            }
            (*outputs_3)[output_3] = Identity_apply_0(_S77[int(0)] + _S78);
        }
        int _S79 = output_3 + int(1);
        if(_S79 < int(96))
        {
            if(adds_3)
            {
                _S78 = (*outputs_3)[_S79];
            }
            else
            {
                _S78 = 0.0f;
            }
            (*outputs_3)[_S79] = Identity_apply_0(_S77[int(1)] + _S78);
        }
        int _S80 = output_3 + int(2);
        if(_S80 < int(96))
        {
            if(adds_3)
            {
                _S78 = (*outputs_3)[_S80];
            }
            else
            {
                _S78 = 0.0f;
            }
            (*outputs_3)[_S80] = Identity_apply_0(_S77[int(2)] + _S78);
        }
        int _S81 = output_3 + int(3);
        if(_S81 < int(96))
        {
            if(adds_3)
            {
                _S78 = (*outputs_3)[_S81];
            }
            else
            {
                _S78 = 0.0f;
            }
            (*outputs_3)[_S81] = Identity_apply_0(_S77[int(3)] + _S78);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

float4 tile_product_4(const HalfWeights_0 thread* weights_8, uint row_4, array<float, int(16)> thread* inputs_8, KernelContext_0 thread* kernelContext_10)
{
    thread float4 sums_4 = float4(0.0f) ;
    uint column_4 = 0U;
    for(;;)
    {
        if(column_4 < 2U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_5;
        thread float4 high_5;
        int _S82 = int(8U * column_4);
        low_5.x = (*inputs_8)[_S82];
        high_5.x = (*inputs_8)[_S82 + int(4)];
        int _S83 = _S82 + int(1);
        low_5.y = (*inputs_8)[_S83];
        high_5.y = (*inputs_8)[_S83 + int(4)];
        int _S84 = _S82 + int(2);
        low_5.z = (*inputs_8)[_S84];
        high_5.z = (*inputs_8)[_S84 + int(4)];
        int _S85 = _S82 + int(3);
        low_5.w = (*inputs_8)[_S85];
        high_5.w = (*inputs_8)[_S85 + int(4)];
        Eight_0 _S86 = HalfWeights_eight_0(weights_8, row_4 + column_4, kernelContext_10);
        sums_4.x = sums_4.x + (dot(_S86.low_0, low_5) + dot(_S86.high_0, high_5));
        Eight_0 _S87 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4, kernelContext_10);
        sums_4.y = sums_4.y + (dot(_S87.low_0, low_5) + dot(_S87.high_0, high_5));
        Eight_0 _S88 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4, kernelContext_10);
        sums_4.z = sums_4.z + (dot(_S88.low_0, low_5) + dot(_S88.high_0, high_5));
        Eight_0 _S89 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4, kernelContext_10);
        sums_4.w = sums_4.w + (dot(_S89.low_0, low_5) + dot(_S89.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_4;
}

void dense_part_4(const HalfWeights_0 thread* weights_9, uint first_6, bool adds_4, array<float, int(16)> thread* inputs_9, array<float, int(1)> thread* outputs_4, KernelContext_0 thread* kernelContext_11)
{
    uint _S90 = first_6 + uint(whole_parts_0(int(1)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S91 = output_4 < int(1);
        if(_S91)
        {
        }
        else
        {
            break;
        }
        uint _S92 = uint(output_4);
        Eight_0 _S93 = HalfWeights_eight_0(weights_9, first_6 + _S92 / 8U, kernelContext_11);
        float4 _S94 = tile_product_4(weights_9, _S90 + _S92 * 2U, inputs_9, kernelContext_11);
        float4 _S95;
        if((output_4 & int(4)) != int(0))
        {
            _S95 = _S93.high_0;
        }
        else
        {
            _S95 = _S93.low_0;
        }
        float4 _S96 = _S94 + _S95;
        float _S97;
        if(_S91)
        {
            if(adds_4)
            {
                _S97 = (*outputs_4)[output_4];
            }
            else
            {
                _S97 = 0.0f;
            }
            (*outputs_4)[output_4] = Identity_apply_0(_S96[int(0)] + _S97);
        }
        int _S98 = output_4 + int(1);
        if(_S98 < int(1))
        {
            if(adds_4)
            {
                _S97 = (*outputs_4)[_S98];
            }
            else
            {
                _S97 = 0.0f;
            }
            (*outputs_4)[_S98] = Identity_apply_0(_S96[int(1)] + _S97);
        }
        int _S99 = output_4 + int(2);
        if(_S99 < int(1))
        {
            if(adds_4)
            {
                _S97 = (*outputs_4)[_S99];
            }
            else
            {
                _S97 = 0.0f;
            }
            (*outputs_4)[_S99] = Identity_apply_0(_S96[int(2)] + _S97);
        }
        int _S100 = output_4 + int(3);
        if(_S100 < int(1))
        {
            if(adds_4)
            {
                _S97 = (*outputs_4)[_S100];
            }
            else
            {
                _S97 = 0.0f;
            }
            (*outputs_4)[_S100] = Identity_apply_0(_S96[int(3)] + _S97);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

float LeakyRelu_apply_0(float x_3)
{
    return max(x_3, x_3 * 0.00999999977648258f);
}

void dense_part_5(const HalfWeights_0 thread* weights_10, uint first_7, bool adds_5, array<float, int(96)> thread* inputs_10, array<float, int(96)> thread* outputs_5, KernelContext_0 thread* kernelContext_12)
{
    uint _S101 = first_7 + uint(whole_parts_0(int(12)));
    int output_5 = int(0);
    for(;;)
    {
        bool _S102 = output_5 < int(96);
        if(_S102)
        {
        }
        else
        {
            break;
        }
        uint _S103 = uint(output_5);
        Eight_0 _S104 = HalfWeights_eight_0(weights_10, first_7 + _S103 / 8U, kernelContext_12);
        float4 _S105 = tile_product_1(weights_10, _S101 + _S103 * 12U, inputs_10, kernelContext_12);
        float4 _S106;
        if((output_5 & int(4)) != int(0))
        {
            _S106 = _S104.high_0;
        }
        else
        {
            _S106 = _S104.low_0;
        }
        float4 _S107 = _S105 + _S106;
        float _S108;
        if(_S102)
        {
            if(adds_5)
            {
                _S108 = (*outputs_5)[output_5];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_5)[output_5] = LeakyRelu_apply_0(_S107[int(0)] + _S108);
        }
        int _S109 = output_5 + int(1);
        if(_S109 < int(96))
        {
            if(adds_5)
            {
                _S108 = (*outputs_5)[_S109];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_5)[_S109] = LeakyRelu_apply_0(_S107[int(1)] + _S108);
        }
        int _S110 = output_5 + int(2);
        if(_S110 < int(96))
        {
            if(adds_5)
            {
                _S108 = (*outputs_5)[_S110];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_5)[_S110] = LeakyRelu_apply_0(_S107[int(2)] + _S108);
        }
        int _S111 = output_5 + int(3);
        if(_S111 < int(96))
        {
            if(adds_5)
            {
                _S108 = (*outputs_5)[_S111];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_5)[_S111] = LeakyRelu_apply_0(_S107[int(3)] + _S108);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

void dense_part_6(const HalfWeights_0 thread* weights_11, uint first_8, bool adds_6, array<float, int(100)> thread* inputs_11, array<float, int(16)> thread* outputs_6, KernelContext_0 thread* kernelContext_13)
{
    uint _S112 = first_8 + uint(whole_parts_0(int(2)));
    int output_6 = int(0);
    for(;;)
    {
        bool _S113 = output_6 < int(16);
        if(_S113)
        {
        }
        else
        {
            break;
        }
        uint _S114 = uint(output_6);
        Eight_0 _S115 = HalfWeights_eight_0(weights_11, first_8 + _S114 / 8U, kernelContext_13);
        float4 _S116 = tile_product_3(weights_11, _S112 + _S114 * 13U, inputs_11, kernelContext_13);
        float4 _S117;
        if((output_6 & int(4)) != int(0))
        {
            _S117 = _S115.high_0;
        }
        else
        {
            _S117 = _S115.low_0;
        }
        float4 _S118 = _S116 + _S117;
        float _S119;
        if(_S113)
        {
            if(adds_6)
            {
                _S119 = (*outputs_6)[output_6];
            }
            else
            {
                _S119 = 0.0f;
            }
            (*outputs_6)[output_6] = LeakyRelu_apply_0(_S118[int(0)] + _S119);
        }
        int _S120 = output_6 + int(1);
        if(_S120 < int(16))
        {
            if(adds_6)
            {
                _S119 = (*outputs_6)[_S120];
            }
            else
            {
                _S119 = 0.0f;
            }
            (*outputs_6)[_S120] = LeakyRelu_apply_0(_S118[int(1)] + _S119);
        }
        int _S121 = output_6 + int(2);
        if(_S121 < int(16))
        {
            if(adds_6)
            {
                _S119 = (*outputs_6)[_S121];
            }
            else
            {
                _S119 = 0.0f;
            }
            (*outputs_6)[_S121] = LeakyRelu_apply_0(_S118[int(2)] + _S119);
        }
        int _S122 = output_6 + int(3);
        if(_S122 < int(16))
        {
            if(adds_6)
            {
                _S119 = (*outputs_6)[_S122];
            }
            else
            {
                _S119 = 0.0f;
            }
            (*outputs_6)[_S122] = LeakyRelu_apply_0(_S118[int(3)] + _S119);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

float4 tile_product_5(const HalfWeights_0 thread* weights_12, uint row_5, array<float, int(88)> thread* inputs_12, KernelContext_0 thread* kernelContext_14)
{
    thread float4 sums_5 = float4(0.0f) ;
    uint column_5 = 0U;
    for(;;)
    {
        if(column_5 < 11U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_6;
        thread float4 high_6;
        int _S123 = int(8U * column_5);
        low_6.x = (*inputs_12)[_S123];
        high_6.x = (*inputs_12)[_S123 + int(4)];
        int _S124 = _S123 + int(1);
        low_6.y = (*inputs_12)[_S124];
        high_6.y = (*inputs_12)[_S124 + int(4)];
        int _S125 = _S123 + int(2);
        low_6.z = (*inputs_12)[_S125];
        high_6.z = (*inputs_12)[_S125 + int(4)];
        int _S126 = _S123 + int(3);
        low_6.w = (*inputs_12)[_S126];
        high_6.w = (*inputs_12)[_S126 + int(4)];
        Eight_0 _S127 = HalfWeights_eight_0(weights_12, row_5 + column_5, kernelContext_14);
        sums_5.x = sums_5.x + (dot(_S127.low_0, low_6) + dot(_S127.high_0, high_6));
        Eight_0 _S128 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5, kernelContext_14);
        sums_5.y = sums_5.y + (dot(_S128.low_0, low_6) + dot(_S128.high_0, high_6));
        Eight_0 _S129 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5, kernelContext_14);
        sums_5.z = sums_5.z + (dot(_S129.low_0, low_6) + dot(_S129.high_0, high_6));
        Eight_0 _S130 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5, kernelContext_14);
        sums_5.w = sums_5.w + (dot(_S130.low_0, low_6) + dot(_S130.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_5;
}

void dense_part_7(const HalfWeights_0 thread* weights_13, uint first_9, bool adds_7, array<float, int(88)> thread* inputs_13, array<float, int(96)> thread* outputs_7, KernelContext_0 thread* kernelContext_15)
{
    uint _S131 = first_9 + uint(whole_parts_0(int(12)));
    int output_7 = int(0);
    for(;;)
    {
        bool _S132 = output_7 < int(96);
        if(_S132)
        {
        }
        else
        {
            break;
        }
        uint _S133 = uint(output_7);
        Eight_0 _S134 = HalfWeights_eight_0(weights_13, first_9 + _S133 / 8U, kernelContext_15);
        float4 _S135 = tile_product_5(weights_13, _S131 + _S133 * 11U, inputs_13, kernelContext_15);
        float4 _S136;
        if((output_7 & int(4)) != int(0))
        {
            _S136 = _S134.high_0;
        }
        else
        {
            _S136 = _S134.low_0;
        }
        float4 _S137 = _S135 + _S136;
        float _S138;
        if(_S132)
        {
            if(adds_7)
            {
                _S138 = (*outputs_7)[output_7];
            }
            else
            {
                _S138 = 0.0f;
            }
            (*outputs_7)[output_7] = LeakyRelu_apply_0(_S137[int(0)] + _S138);
        }
        int _S139 = output_7 + int(1);
        if(_S139 < int(96))
        {
            if(adds_7)
            {
                _S138 = (*outputs_7)[_S139];
            }
            else
            {
                _S138 = 0.0f;
            }
            (*outputs_7)[_S139] = LeakyRelu_apply_0(_S137[int(1)] + _S138);
        }
        int _S140 = output_7 + int(2);
        if(_S140 < int(96))
        {
            if(adds_7)
            {
                _S138 = (*outputs_7)[_S140];
            }
            else
            {
                _S138 = 0.0f;
            }
            (*outputs_7)[_S140] = LeakyRelu_apply_0(_S137[int(2)] + _S138);
        }
        int _S141 = output_7 + int(3);
        if(_S141 < int(96))
        {
            if(adds_7)
            {
                _S138 = (*outputs_7)[_S141];
            }
            else
            {
                _S138 = 0.0f;
            }
            (*outputs_7)[_S141] = LeakyRelu_apply_0(_S137[int(3)] + _S138);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

void dense_0(const FloatWeights_0 thread* weights_14, uint first_10, bool adds_8, array<float, int(96)> thread* inputs_14, array<float, int(50)> thread* outputs_8, KernelContext_0 thread* kernelContext_16)
{
    dense_part_0(weights_14, first_10, adds_8, inputs_14, outputs_8, kernelContext_16);
    return;
}

void dense_1(const HalfWeights_0 thread* weights_15, uint first_11, bool adds_9, array<float, int(96)> thread* inputs_15, array<float, int(52)> thread* outputs_9, KernelContext_0 thread* kernelContext_17)
{
    dense_part_1(weights_15, first_11, adds_9, inputs_15, outputs_9, kernelContext_17);
    return;
}

void dense_2(const HalfWeights_0 thread* weights_16, uint first_12, bool adds_10, array<float, int(96)> thread* inputs_16, array<float, int(96)> thread* outputs_10, KernelContext_0 thread* kernelContext_18)
{
    dense_part_5(weights_16, first_12, adds_10, inputs_16, outputs_10, kernelContext_18);
    return;
}

void dense_3(const HalfWeights_0 thread* weights_17, uint first_13, bool adds_11, array<float, int(39)> thread* inputs_17, array<float, int(96)> thread* outputs_11, KernelContext_0 thread* kernelContext_19)
{
    dense_part_2(weights_17, first_13, adds_11, inputs_17, outputs_11, kernelContext_19);
    return;
}

void dense_4(const HalfWeights_0 thread* weights_18, uint first_14, bool adds_12, array<float, int(100)> thread* inputs_18, array<float, int(96)> thread* outputs_12, KernelContext_0 thread* kernelContext_20)
{
    dense_part_3(weights_18, first_14, adds_12, inputs_18, outputs_12, kernelContext_20);
    return;
}

void dense_5(const HalfWeights_0 thread* weights_19, uint first_15, bool adds_13, array<float, int(16)> thread* inputs_19, array<float, int(1)> thread* outputs_13, KernelContext_0 thread* kernelContext_21)
{
    dense_part_4(weights_19, first_15, adds_13, inputs_19, outputs_13, kernelContext_21);
    return;
}

void dense_6(const HalfWeights_0 thread* weights_20, uint first_16, bool adds_14, array<float, int(100)> thread* inputs_20, array<float, int(16)> thread* outputs_14, KernelContext_0 thread* kernelContext_22)
{
    dense_part_6(weights_20, first_16, adds_14, inputs_20, outputs_14, kernelContext_22);
    return;
}

void dense_part_8(const HalfWeights_0 thread* weights_21, uint first_17, bool adds_15, array<float, int(96)> thread* inputs_21, array<float, int(100)> thread* outputs_15, KernelContext_0 thread* kernelContext_23)
{
    uint _S142 = first_17 + uint(whole_parts_0(int(12)));
    int output_8 = int(0);
    for(;;)
    {
        bool _S143 = output_8 < int(96);
        if(_S143)
        {
        }
        else
        {
            break;
        }
        uint _S144 = uint(output_8);
        Eight_0 _S145 = HalfWeights_eight_0(weights_21, first_17 + _S144 / 8U, kernelContext_23);
        float4 _S146 = tile_product_1(weights_21, _S142 + _S144 * 12U, inputs_21, kernelContext_23);
        float4 _S147;
        if((output_8 & int(4)) != int(0))
        {
            _S147 = _S145.high_0;
        }
        else
        {
            _S147 = _S145.low_0;
        }
        float4 _S148 = _S146 + _S147;
        float _S149;
        if(_S143)
        {
            if(adds_15)
            {
                _S149 = (*outputs_15)[output_8];
            }
            else
            {
                _S149 = 0.0f;
            }
            (*outputs_15)[output_8] = LeakyRelu_apply_0(_S148[int(0)] + _S149);
        }
        int _S150 = output_8 + int(1);
        if(_S150 < int(96))
        {
            if(adds_15)
            {
                _S149 = (*outputs_15)[_S150];
            }
            else
            {
                _S149 = 0.0f;
            }
            (*outputs_15)[_S150] = LeakyRelu_apply_0(_S148[int(1)] + _S149);
        }
        int _S151 = output_8 + int(2);
        if(_S151 < int(96))
        {
            if(adds_15)
            {
                _S149 = (*outputs_15)[_S151];
            }
            else
            {
                _S149 = 0.0f;
            }
            (*outputs_15)[_S151] = LeakyRelu_apply_0(_S148[int(2)] + _S149);
        }
        int _S152 = output_8 + int(3);
        if(_S152 < int(96))
        {
            if(adds_15)
            {
                _S149 = (*outputs_15)[_S152];
            }
            else
            {
                _S149 = 0.0f;
            }
            (*outputs_15)[_S152] = LeakyRelu_apply_0(_S148[int(3)] + _S149);
        }
        output_8 = output_8 + int(4);
    }
    return;
}

void dense_7(const HalfWeights_0 thread* weights_22, uint first_18, bool adds_16, array<float, int(88)> thread* inputs_22, array<float, int(96)> thread* outputs_16, KernelContext_0 thread* kernelContext_24)
{
    dense_part_7(weights_22, first_18, adds_16, inputs_22, outputs_16, kernelContext_24);
    return;
}

float3 position_of_0(const Vertex_0 thread* vertex_0)
{
    return float3(vertex_0->x_0, vertex_0->y_0, vertex_0->z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

float3 camera_right_0(const Frame_0 thread* frame_0)
{
    return float3(frame_0->right_x_0, frame_0->right_y_0, frame_0->right_z_0);
}

float3 camera_up_0(const Frame_0 thread* frame_1)
{
    return float3(frame_1->up_x_0, frame_1->up_y_0, frame_1->up_z_0);
}

float3 camera_forward_0(const Frame_0 thread* frame_2)
{
    return float3(frame_2->forward_x_0, frame_2->forward_y_0, frame_2->forward_z_0);
}

float3 camera_origin_0(const Frame_0 thread* frame_3)
{
    return float3(frame_3->origin_x_0, frame_3->origin_y_0, frame_3->origin_z_0);
}

float3 normal_of_0(const Vertex_0 thread* vertex_1)
{
    return float3(vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(const VisiblePoint_0 thread* point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0->axis_x_0), dot(direction_0, point_0->axis_y_0), dot(direction_0, point_0->normal_0));
}

float square_1(float x_4)
{
    return x_4 * x_4;
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float3 row_of_taps_0(const Footprint_0 thread* footprint_0)
{
    float _S153 = footprint_0->dx_0.x;
    float _S154 = footprint_0->dy_0.x;
    float _S155 = _S153 * _S153 + _S154 * _S154;
    float _S156 = footprint_0->dx_0.y;
    float _S157 = footprint_0->dy_0.y;
    float _S158 = _S156 * _S156 + _S157 * _S157;
    float _S159 = _S153 * _S156 + _S154 * _S157;
    float _S160 = 0.5f * (_S155 - _S158);
    float _S161 = 0.5f * (_S155 + _S158);
    float _S162 = sqrt(_S160 * _S160 + _S159 * _S159);
    float _S163 = _S161 + _S162;
    float _S164 = max(_S163 - 1.5f * max(_S161 - _S162, 0.0f), 0.0f);
    float _S165 = square_1(4.0f);
    float _S166 = max(_S161 - 0.5f * _S164, _S163 / _S165);
    float _S167 = sqrt(max(min(_S164, _S163 - _S166), 0.0f) / (_S165 - 1.0f));
    float _S168 = _S160 / max(_S162, 1.00000000317107685e-30f);
    float _S169 = sqrt(max(0.5f * (1.0f - _S168), 0.0f));
    float _S170 = sqrt(_S166);
    float _S171 = _S167 * sqrt(max(0.5f * (1.0f + _S168), 0.0f));
    float _S172;
    if(_S159 < 0.0f)
    {
        _S172 = - _S167 * _S169;
    }
    else
    {
        _S172 = _S167 * _S169;
    }
    return float3(_S170, _S171, _S172);
}

struct AnisotropicTaps_0
{
    float2 centre_1;
    float side_0;
    float2 first_19;
    float2 second_0;
};

float AnisotropicTaps_size_0(const AnisotropicTaps_0 thread* this_2)
{
    float _S173 = this_2->first_19.x;
    float _S174 = this_2->second_0.x;
    float _S175 = this_2->side_0 * this_2->side_0;
    float _S176 = this_2->first_19.y;
    float _S177 = this_2->second_0.y;
    float _S178 = 12.0f * (_S173 * _S176 + _S174 * _S177);
    return sqrt(sqrt(max((12.0f * (_S173 * _S173 + _S174 * _S174) + _S175) * (12.0f * (_S176 * _S176 + _S177 * _S177) + _S175) - _S178 * _S178, square_1(_S175))));
}

float natural_logarithm_0(float x_5)
{
    uint _S179 = (as_type<uint>((x_5)));
    float exponent_0 = float(int(_S179 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S179 & 8388607U) | 1056964608U)));
    float m_1;
    float exponent_1;
    if(m_0 < 0.70710676908493042f)
    {
        float exponent_2 = exponent_0 - 1.0f;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    float m_2 = m_1 - 1.0f;
    float _S180 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S180 - exponent_1 * 0.00021219444170129f - 0.5f * _S180) + exponent_1 * 0.693359375f;
}

float3 footprint_coordinates_0(const AnisotropicTaps_0 thread* taps_0)
{
    float _S181 = AnisotropicTaps_size_0(taps_0);
    return float3(taps_0->centre_1 - floor(taps_0->centre_1), clamp(natural_logarithm_0(max(_S181, 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

float3 to_face_frame_0(float3 direction_1, bool back_0)
{
    float2 _S182 = direction_1.xy;
    float _S183;
    if(back_0)
    {
        _S183 = - direction_1.z;
    }
    else
    {
        _S183 = direction_1.z;
    }
    return float3(_S182, _S183);
}

float table_number_0(uint index_0, KernelContext_0 thread* kernelContext_25)
{
    return (as_type<float>((kernelContext_25->words_0[index_0])));
}

float table_number_1(uint index_1, KernelContext_0 thread* kernelContext_26)
{
    return (as_type<float>((kernelContext_26->words_0[index_1])));
}

float wrapped_0(float index_2, float count_1)
{
    float _S184;
    if(index_2 < 0.0f)
    {
        _S184 = index_2 + count_1;
    }
    else
    {
        if(index_2 >= count_1)
        {
            _S184 = index_2 - count_1;
        }
        else
        {
            _S184 = index_2;
        }
    }
    return _S184;
}

float binary_logarithm_0(float x_6)
{
    return natural_logarithm_0(x_6) * 1.4426950216293335f;
}

bool AnisotropicTaps_has_steps_0(const AnisotropicTaps_0 thread* this_3)
{
    float2 _S185 = float2(0.0f) ;
    bool _S186;
    if(any((this_3->first_19) != _S185))
    {
        _S186 = true;
    }
    else
    {
        _S186 = any((this_3->second_0) != _S185);
    }
    return _S186;
}

float2 AnisotropicTaps_place_0(const AnisotropicTaps_0 thread* this_4, uint number_0)
{
    float _S187;
    if(number_0 >= 2U)
    {
        _S187 = 1.0f;
    }
    else
    {
        _S187 = -1.0f;
    }
    float _S188;
    if((number_0 & 1U) != 0U)
    {
        _S188 = 1.0f;
    }
    else
    {
        _S188 = -1.0f;
    }
    return this_4->centre_1 + float2(_S187)  * this_4->first_19 + float2(_S188)  * this_4->second_0;
}

float bump_0(float distance_0)
{
    float _S189 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S189 * _S189;
}

float correction_weight_of_0(float coded_size_0)
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

float2 turns_and_remainder_0(uint family_0, float index_3, KernelContext_0 thread* kernelContext_27)
{
    float _S190 = floor(fma(index_3, kernelContext_27->families_0[family_0].inverse_count_0, kernelContext_27->families_0[family_0].half_inverse_count_0));
    return float2(_S190, fma(- _S190, kernelContext_27->families_0[family_0].count_0, index_3));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1, KernelContext_0 thread* kernelContext_28)
{
    float _S191 = floor(position_1 * kernelContext_28->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_0;
    float _S192 = fma(- _S191, kernelContext_28->families_0[family_1].size_0, position_1);
    (&cell_0)->below_0 = _S192;
    (&cell_0)->above_0 = kernelContext_28->families_0[family_1].size_0 - _S192;
    (&cell_0)->across_0 = _S192 - 0.5f * kernelContext_28->families_0[family_1].size_0;
    (&cell_0)->half_width_1 = kernelContext_28->families_0[family_1].half_width_0;
    float2 _S193 = turns_and_remainder_0(family_1, _S191, kernelContext_28);
    (&cell_0)->thread_0 = uint(clamp(_S193.y, 0.0f, kernelContext_28->families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_2, KernelContext_0 thread* kernelContext_29)
{
    float turns_0 = (position_2 - kernelContext_29->families_0[family_2].start_0) * kernelContext_29->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S194 = turns_1 * kernelContext_29->families_0[family_2].period_0;
    uint thread_1 = kernelContext_29->words_0[kernelContext_29->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_29->families_0[family_2].bins_0, 0.0f, kernelContext_29->families_0[family_2].bins_0 - 1.0f))];
    float _S195 = table_number_0(kernelContext_29->families_0[family_2].place_table_0 + thread_1 * 4U + 1U, kernelContext_29);
    uint _S196;
    if(_S194 >= _S195)
    {
        _S196 = 1U;
    }
    else
    {
        _S196 = 0U;
    }
    uint _S197 = min(thread_1 + _S196, uint(kernelContext_29->families_0[family_2].count_0) - 1U);
    uint _S198 = kernelContext_29->families_0[family_2].place_table_0 + _S197 * 4U;
    thread Cell_0 cell_1;
    (&cell_1)->thread_0 = _S197;
    float _S199 = table_number_0(_S198, kernelContext_29);
    (&cell_1)->below_0 = _S194 - _S199;
    float _S200 = table_number_0(_S198 + 1U, kernelContext_29);
    (&cell_1)->above_0 = _S200 - _S194;
    float _S201 = table_number_0(_S198 + 2U, kernelContext_29);
    (&cell_1)->across_0 = _S194 - _S201;
    float _S202 = table_number_0(_S198 + 3U, kernelContext_29);
    (&cell_1)->half_width_1 = _S202;
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_3, KernelContext_0 thread* kernelContext_30)
{
    if((kernelContext_30->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S203 = locate_alike_0(family_3, position_3, kernelContext_30);
        return _S203;
    }
    Cell_0 _S204 = locate_varied_0(family_3, position_3, kernelContext_30);
    return _S204;
}

struct Bound_0
{
    uint thread_2;
    float turns_2;
    float cell_2;
    float visible_0;
    float width_1;
    float gap_0;
};

Bound_0 bound_at_0(uint family_4, float position_4, KernelContext_0 thread* kernelContext_31)
{
    Cell_0 _S205 = locate_0(family_4, position_4, kernelContext_31);
    float _S206 = table_number_0(kernelContext_31->families_0[family_4].before_0 + 2U * _S205.thread_0 + 1U, kernelContext_31);
    thread Bound_0 bound_0;
    (&bound_0)->thread_2 = _S205.thread_0;
    (&bound_0)->turns_2 = round((position_4 - kernelContext_31->families_0[family_4].start_0 - _S206 - _S205.below_0) * kernelContext_31->families_0[family_4].inverse_period_0);
    (&bound_0)->cell_2 = _S205.below_0;
    float _S207 = 2.0f * _S205.half_width_1;
    (&bound_0)->width_1 = _S207;
    (&bound_0)->visible_0 = clamp((_S205.across_0 + _S205.half_width_1) / _S207, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S205.below_0, _S205.below_0 - _S205.across_0 - _S205.half_width_1) + max(_S205.across_0 - _S205.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1, KernelContext_0 thread* kernelContext_32)
{
    float _S208 = centre_2 - floor((centre_2 - kernelContext_32->families_0[family_5].start_0) * kernelContext_32->families_0[family_5].inverse_period_0) * kernelContext_32->families_0[family_5].period_0;
    float _S209 = 0.5f * max(size_1, kernelContext_32->families_0[family_5].smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S210 = bound_at_0(family_5, _S208 - _S209, kernelContext_32);
    (&stretch_0)->low_7 = _S210;
    Bound_0 _S211 = bound_at_0(family_5, _S208 + _S209, kernelContext_32);
    (&stretch_0)->high_7 = _S211;
    return stretch_0;
}

float3 table_colour_0(uint index_4, KernelContext_0 thread* kernelContext_33)
{
    float _S212 = table_number_1(index_4, kernelContext_33);
    float _S213 = table_number_1(index_4 + 1U, kernelContext_33);
    float _S214 = table_number_1(index_4 + 2U, kernelContext_33);
    return float3(_S212, _S213, _S214);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_6, KernelContext_0 thread* kernelContext_34)
{
    thread Albedos_0 albedos_0;
    float3 _S215 = table_colour_0(row_6, kernelContext_34);
    (&albedos_0)->diffuse_reflect_0 = _S215;
    float3 _S216 = table_colour_0(row_6 + 3U, kernelContext_34);
    (&albedos_0)->diffuse_transmit_0 = _S216;
    float3 _S217 = table_colour_0(row_6 + 6U, kernelContext_34);
    (&albedos_0)->specular_reflect_0 = _S217;
    float3 _S218 = table_colour_0(row_6 + 9U, kernelContext_34);
    (&albedos_0)->specular_transmit_0 = _S218;
    return albedos_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_5)
{
    return (&this_5->high_7)->turns_2 - (&this_5->low_7)->turns_2;
}

float3 lengths_0(uint family_6, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_35)
{
    float _S219 = Stretch_turns_0(stretch_1);
    uint _S220 = kernelContext_35->families_0[family_6].before_0 + 2U * (&stretch_1->low_7)->thread_2;
    uint _S221 = kernelContext_35->families_0[family_6].before_0 + 2U * (&stretch_1->high_7)->thread_2;
    float _S222 = table_number_0(_S221, kernelContext_35);
    float _S223 = table_number_0(_S220, kernelContext_35);
    float _S224 = _S222 - _S223;
    float _S225 = table_number_0(_S221 + 1U, kernelContext_35);
    float _S226 = table_number_0(_S220 + 1U, kernelContext_35);
    float _S227 = _S225 - _S226;
    return float3(_S224 + (&stretch_1->high_7)->visible_0 * (&stretch_1->high_7)->width_1 - (&stretch_1->low_7)->visible_0 * (&stretch_1->low_7)->width_1 + _S219 * kernelContext_35->families_0[family_6].visible_total_0, _S227 - _S224 + (&stretch_1->high_7)->gap_0 - (&stretch_1->low_7)->gap_0 + _S219 * (kernelContext_35->families_0[family_6].period_0 - kernelContext_35->families_0[family_6].visible_total_0), _S227 + (&stretch_1->high_7)->cell_2 - (&stretch_1->low_7)->cell_2 + _S219 * kernelContext_35->families_0[family_6].period_0);
}

float2 integrals_along_0(uint family_7, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_36)
{
    Family_0 _S228 = kernelContext_36->families_0[family_7];
    uint _S229 = 3U * _S228.quantities_0;
    uint _S230 = kernelContext_36->families_0[family_7].colour_threads_0 + _S229 * (&stretch_2->low_7)->thread_2 + quantity_0;
    uint _S231 = kernelContext_36->families_0[family_7].colour_threads_0 + _S229 * (&stretch_2->high_7)->thread_2 + quantity_0;
    uint _S232 = kernelContext_36->families_0[family_7].colour_threads_0 + _S229 * uint(kernelContext_36->families_0[family_7].count_0) + quantity_0;
    float _S233 = table_number_0(_S230, kernelContext_36);
    float _S234 = table_number_0(_S231, kernelContext_36);
    float _S235 = Stretch_turns_0(stretch_2);
    float _S236 = table_number_0(_S231 + _S228.quantities_0, kernelContext_36);
    float _S237 = table_number_0(_S230 + _S228.quantities_0, kernelContext_36);
    float _S238 = _S236 - _S237 + _S234 * (&stretch_2->high_7)->visible_0 * (&stretch_2->high_7)->width_1 - _S233 * (&stretch_2->low_7)->visible_0 * (&stretch_2->low_7)->width_1;
    float _S239 = table_number_0(_S232 + _S228.quantities_0, kernelContext_36);
    float _S240 = _S238 + _S235 * _S239;
    uint _S241 = 2U * _S228.quantities_0;
    float _S242 = table_number_0(_S231 + _S241, kernelContext_36);
    float _S243 = table_number_0(_S230 + _S241, kernelContext_36);
    float _S244 = _S242 - _S243 + _S234 * (&stretch_2->high_7)->cell_2 - _S233 * (&stretch_2->low_7)->cell_2;
    float _S245 = table_number_0(_S232 + _S241, kernelContext_36);
    return float2(_S240, _S244 + _S235 * _S245);
}

bool Stretch_wraps_0(const Stretch_0 thread* this_6)
{
    return ((&this_6->high_7)->thread_2) < ((&this_6->low_7)->thread_2);
}

bool Stretch_wraps_1(const Stretch_0 thread* this_7)
{
    return ((&this_7->high_7)->thread_2) < ((&this_7->low_7)->thread_2);
}

uint4 Stretch_differences_0(const Stretch_0 thread* this_8, uint4 entries_0, uint whole_0)
{
    uint _S246 = entries_0.z;
    uint _S247 = entries_0.x;
    uint _S248 = _S246 - _S247;
    bool _S249 = Stretch_wraps_1(this_8);
    uint _S250;
    if(_S249)
    {
        _S250 = whole_0;
    }
    else
    {
        _S250 = 0U;
    }
    return uint4(_S248 + _S250, entries_0.w - _S246, entries_0.y - _S247, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_1, uint row_7, uint count_2, uint quantities_1, KernelContext_0 thread* kernelContext_37)
{
    uint _S251 = row_7 + (&across_1->low_7)->thread_2 * quantities_1;
    uint _S252 = row_7 + (&across_1->high_7)->thread_2 * quantities_1;
    uint4 _S253 = Stretch_differences_0(across_1, uint4(kernelContext_37->words_0[_S251], kernelContext_37->words_0[_S251 + quantities_1], kernelContext_37->words_0[_S252], kernelContext_37->words_0[_S252 + quantities_1]), kernelContext_37->words_0[row_7 + count_2 * quantities_1]);
    return _S253;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_9)
{
    float _S254 = (&this_9->high_7)->visible_0;
    float _S255 = - (&this_9->low_7)->visible_0;
    float _S256 = Stretch_turns_0(this_9);
    bool _S257 = Stretch_wraps_0(this_9);
    float _S258;
    if(_S257)
    {
        _S258 = 1.0f;
    }
    else
    {
        _S258 = 0.0f;
    }
    return float4(1.0f, _S254, _S255, _S256 - _S258);
}

float integral_on_top_0(uint family_8, const Stretch_0 thread* across_2, const Stretch_0 thread* along_0, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_38)
{
    uint _S259 = uint(kernelContext_38->families_0[family_8].count_0);
    uint _S260 = (_S259 + 1U) * kernelContext_38->families_0[family_8].quantities_0;
    uint _S261 = kernelContext_38->families_0[family_8].colour_areas_0 + quantity_1;
    uint _S262 = (&along_0->low_7)->thread_2;
    uint4 _S263 = row_differences_0(across_2, _S261 + (&along_0->low_7)->thread_2 * _S260, _S259, kernelContext_38->families_0[family_8].quantities_0, kernelContext_38);
    uint4 _S264 = row_differences_0(across_2, _S261 + (_S262 + 1U) * _S260, _S259, kernelContext_38->families_0[family_8].quantities_0, kernelContext_38);
    uint _S265 = (&along_0->high_7)->thread_2;
    uint4 _S266 = row_differences_0(across_2, _S261 + (&along_0->high_7)->thread_2 * _S260, _S259, kernelContext_38->families_0[family_8].quantities_0, kernelContext_38);
    uint4 _S267 = row_differences_0(across_2, _S261 + (_S265 + 1U) * _S260, _S259, kernelContext_38->families_0[family_8].quantities_0, kernelContext_38);
    uint4 _S268 = row_differences_0(across_2, _S261 + crossing_count_0 * _S260, _S259, kernelContext_38->families_0[family_8].quantities_0, kernelContext_38);
    uint4 _S269 = _S266 - _S263;
    bool _S270 = Stretch_wraps_0(along_0);
    uint4 _S271;
    if(_S270)
    {
        _S271 = _S268;
    }
    else
    {
        _S271 = uint4(int4(int(0)) );
    }
    uint4 _S272 = _S269 + _S271;
    float4 _S273 = Stretch_weights_0(across_2);
    float4 _S274 = Stretch_weights_0(along_0);
    return dot(float4(dot(float4(int4(_S272)), _S273), dot(float4(int4(_S267 - _S266)), _S273), dot(float4(int4(_S264 - _S263)), _S273), dot(float4(int4(_S268)), _S273)), _S274) * kernelContext_38->families_0[family_8].area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_0, uint row_8, KernelContext_0 thread* kernelContext_39)
{
    Albedos_0 _S275 = table_albedos_0(row_8, kernelContext_39);
    thread Albedos_0 sum_0;
    float3 _S276 = float3(weight_0) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S276 * _S275.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S276 * _S275.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S276 * _S275.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S276 * _S275.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, const Stretch_0 thread* own_0, const Stretch_0 thread* other_0, bool back_1, KernelContext_0 thread* kernelContext_40)
{
    Albedos_0 _S277 = table_albedos_0(kernelContext_40->families_0[family_9].colour_mean_0, kernelContext_40);
    thread Albedos_0 albedos_2 = _S277;
    if((kernelContext_40->families_0[family_9].quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S278 = lengths_0(crossing_0, other_0, kernelContext_40);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (kernelContext_40->families_0[family_9].quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S279 = integrals_along_0(family_9, own_0, quantity_2, kernelContext_40);
        float _S280 = integral_on_top_0(family_9, own_0, other_0, uint(kernelContext_40->families_0[crossing_0].count_0), quantity_2, kernelContext_40);
        float _S281 = _S279.x;
        float _S282 = _S281 * _S278.x;
        float _S283;
        if(back_1)
        {
            _S283 = _S282 - _S280;
        }
        else
        {
            _S283 = _S280;
        }
        bool _S284 = quantity_2 == 0U;
        if(_S284)
        {
            is_exposed_0 = _S283 > (16.0f * kernelContext_40->families_0[family_9].area_unit_0 * min(_S282 / kernelContext_40->families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S282);
        }
        float _S285 = _S281 * _S278.y;
        float _S286;
        if(is_exposed_0)
        {
            _S286 = _S283;
        }
        else
        {
            _S286 = 0.0f;
        }
        float _S287 = _S285 + _S286 + 0.000244140625f * _S278.z * _S279.y;
        if(_S284)
        {
            weight_1 = 1.0f / max(_S287, 9.99999968265522539e-21f);
        }
        else
        {
            float _S288 = _S287 * weight_1;
            uint _S289 = kernelContext_40->families_0[family_9].colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S290 = albedos_2;
            Albedos_0 _S291 = with_added_albedos_0(&_S290, _S288, _S289, kernelContext_40);
            albedos_2 = _S291;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

float3 towards_light_0(const Light_0 thread* light_0, float3 position_5, float3 thread* irradiance_1)
{
    *irradiance_1 = float3(light_0->red_0, light_0->green_0, light_0->blue_0);
    float3 _S292 = float3(light_0->x_1, light_0->y_1, light_0->z_1);
    if((light_0->is_point_0) == 0U)
    {
        return _S292;
    }
    float3 _S293 = _S292 - position_5;
    *irradiance_1 = *irradiance_1 / float3(max(square_0(_S293), 9.999999960041972e-13f)) ;
    return normalize(_S293);
}

float exponential_0(float x_7)
{
    float _S294 = clamp(x_7, -87.0f, 88.0f);
    float _S295 = floor(_S294 * 1.4426950216293335f + 0.5f);
    float _S296 = _S294 - _S295 * 0.693359375f + _S295 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S296 + 0.00139819993637502f) * _S296 + 0.00833345204591751f) * _S296 + 0.04166579619050026f) * _S296 + 0.1666666567325592f) * _S296 + 0.5f;
    float _S297 = (as_type<float>((uint(int(_S295) + int(127)) << 23U)));
    float _S298;
    if(x_7 < -87.0f)
    {
        _S298 = 0.0f;
    }
    else
    {
        _S298 = (p_0 * _S296 * _S296 + _S296 + 1.0f) * _S297;
    }
    return _S298;
}

float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

uint mirrored_bundle_0(uint bundle_0)
{
    uint _S299 = bundle_0 / 3U;
    uint _S300 = bundle_0 % 3U;
    uint _S301;
    if(bundle_0 == 24U)
    {
        _S301 = bundle_0;
    }
    else
    {
        _S301 = _S299 * 3U + 3U - 1U - _S300;
    }
    return _S301;
}

float light_visibility_of_0(float diffuse_0, float3 light_1, float3 view_1, float blend_0)
{
    float _S302 = max(abs(light_1.z), 0.00100000004749745f);
    float2 _S303 = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S302, (0.59700000286102295f * _S302 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S303, view_1.xy) * rsqrt(max(dot(_S303, _S303), 9.99999997475242708e-07f))) + 1.0f), blend_0);
}

float sheen_scale_0(float x_8, float y_2)
{
    return (((((0.0f * x_8 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_8 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_8 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_8 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_8 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_8 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_9, float y_3)
{
    return ((((0.0f * x_9 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_9 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_9 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_9 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_9 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_10, float y_4)
{
    return ((((0.0f * x_10 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_10 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_10 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_10 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_10 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S304 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S305 = 2.0f * sqrt(_S304) - 1.0f;
    float _S306 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S305, _S306), 0.00999999977648258f, 1.0f), clamp((1.0f - _S304) * sheen_shear_0(_S305, _S306), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S305, _S306), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_2, float3 view_2, float scale_1, float shear_0)
{
    float _S307 = light_2.z;
    bool _S308;
    if(_S307 <= 0.0f)
    {
        _S308 = true;
    }
    else
    {
        _S308 = (view_2.z) <= 0.0f;
    }
    if(_S308)
    {
        return 0.0f;
    }
    float2 _S309 = view_2.xy;
    float _S310 = dot(_S309, _S309);
    float2 _S311;
    if(_S310 > 9.99999968265522539e-21f)
    {
        _S311 = _S309 * float2(rsqrt(_S310)) ;
    }
    else
    {
        _S311 = float2(1.0f, 0.0f);
    }
    float _S312 = scale_1 * dot(light_2.xy, _S311) + shear_0 * _S307;
    float _S313 = scale_1 * (light_2.y * _S311.x - light_2.x * _S311.y);
    float _S314 = _S312 * _S312 + _S313 * _S313 + _S307 * _S307;
    return 0.31830987334251404f * scale_1 * scale_1 * _S307 / max(_S314 * _S314, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_3, float3 view_3, float strength_0, float roughness_2)
{
    float3 _S315 = sheen_lobe_0(view_3.z, roughness_2);
    float _S316 = strength_0 * _S315.z;
    return float2(_S316 * transformed_cosine_0(light_3, view_3, _S315.x, _S315.y), 1.0f - _S316);
}

void accumulate_0(const Frame_0 thread* frame_4, uint2 pixel_0, float4 light_4, KernelContext_0 thread* kernelContext_41)
{
    uint _S317 = pixel_0.y * frame_4->width_0 + pixel_0.x;
    float _S318 = light_4.w;
    float4 _S319 = float4(light_4.xyz + float3((1.0f - _S318))  * float3(frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0), _S318);
    packed_float4 device* _S320 = kernelContext_41->radiance_0+_S317;
    float4 _S321;
    if((frame_4->pass_number_0) == 0U)
    {
        _S321 = _S319;
    }
    else
    {
        _S321 = float4(*(kernelContext_41->radiance_0+_S317))  + _S319;
    }
    *_S320 = packed_float4(_S321) ;
    return;
}

VisiblePoint_0 visible_point_0(const Frame_0 thread* _S322, uint _S323, uint _S324, uint2 _S325, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S326 = kernelContext_42->fabrics_0+_S323;
    uint _S327 = 3U * _S324;
    Vertex_0 _S328 = kernelContext_42->vertices_0[kernelContext_42->corners_0[_S327]];
    Vertex_0 _S329 = kernelContext_42->vertices_0[kernelContext_42->corners_0[_S327 + 1U]];
    Vertex_0 _S330 = kernelContext_42->vertices_0[kernelContext_42->corners_0[_S327 + 2U]];
    thread Vertex_0 _S331 = _S329;
    float3 _S332 = position_of_0(&_S331);
    thread Vertex_0 _S333 = _S328;
    float3 _S334 = position_of_0(&_S333);
    float3 _S335 = _S332 - _S334;
    thread Vertex_0 _S336 = _S330;
    float3 _S337 = position_of_0(&_S336);
    float3 _S338 = _S337 - _S334;
    float3 _S339 = cross(_S335, _S338);
    float _S340 = 1.0f / max(square_0(_S339), 1.00000000317107685e-30f);
    float3 _S341 = camera_right_0(_S322);
    float _S342 = float(_S322->width_0);
    float3 _S343 = _S341 * float3((2.0f / _S342)) ;
    float3 _S344 = camera_up_0(_S322);
    float _S345 = float(_S322->height_0);
    float3 _S346 = _S344 * float3((-2.0f / _S345)) ;
    float _S347 = float(_S325.x) + 0.5f - 0.5f * _S342;
    float _S348 = float(_S325.y) + 0.5f - 0.5f * _S345;
    float3 _S349 = camera_forward_0(_S322);
    float3 _S350 = _S349 + float3(_S347)  * _S343 + float3(_S348)  * _S346;
    float _S351 = dot(_S350, _S339);
    float _S352;
    if((abs(_S351)) > 1.00000000317107685e-30f)
    {
        _S352 = _S351;
    }
    else
    {
        _S352 = 1.00000000317107685e-30f;
    }
    float _S353 = 1.0f / _S352;
    float3 _S354 = camera_origin_0(_S322);
    float3 _S355 = _S334 - _S354;
    float3 _S356 = float3((dot(_S355, _S339) * _S353)) ;
    float3 _S357 = _S350 * _S356 - _S355;
    float3 _S358 = _S356 * (_S343 - _S350 * float3((dot(_S343, _S339) * _S353)) );
    float3 _S359 = _S356 * (_S346 - _S350 * float3((dot(_S346, _S339) * _S353)) );
    float3 _S360 = float3(_S340) ;
    float3 _S361 = cross(_S338, _S339) * _S360;
    float3 _S362 = cross(_S339, _S335) * _S360;
    float _S363 = dot(_S357, _S361);
    float _S364 = dot(_S357, _S362);
    float _S365 = _S329.u_0 - _S328.u_0;
    float _S366 = _S329.v_0 - _S328.v_0;
    float2 _S367 = float2(_S365, _S366);
    float _S368 = _S330.u_0 - _S328.u_0;
    float _S369 = _S330.v_0 - _S328.v_0;
    float2 _S370 = float2(_S368, _S369);
    float2 _S371 = float2(_S328.u_0, _S328.v_0) + float2(_S363)  * _S367 + float2(_S364)  * _S370;
    float2 _S372 = float2(dot(_S358, _S361))  * _S367 + float2(dot(_S358, _S362))  * _S370;
    float2 _S373 = float2(dot(_S359, _S361))  * _S367 + float2(dot(_S359, _S362))  * _S370;
    if((_S365 * _S369 - _S366 * _S368) < 0.0f)
    {
        _S352 = -1.0f;
    }
    else
    {
        _S352 = 1.0f;
    }
    float3 _S374 = float3(_S352)  * (float3(_S369)  * _S335 - float3(_S366)  * _S338);
    float3 _S375 = float3(_S352)  * (float3(_S365)  * _S338 - float3(_S368)  * _S335);
    thread VisiblePoint_0 point_1;
    float _S376 = 1.0f - _S363 - _S364;
    thread Vertex_0 _S377 = _S328;
    float3 _S378 = normal_of_0(&_S377);
    float3 _S379 = float3(_S376)  * _S378;
    thread Vertex_0 _S380 = _S329;
    float3 _S381 = normal_of_0(&_S380);
    float3 _S382 = _S379 + float3(_S363)  * _S381;
    thread Vertex_0 _S383 = _S330;
    float3 _S384 = normal_of_0(&_S383);
    float3 _S385 = normalize(_S382 + float3(_S364)  * _S384);
    (&point_1)->normal_0 = _S385;
    float3 _S386 = normalize(_S374 - _S385 * float3(dot(_S385, _S374)) );
    (&point_1)->axis_x_0 = _S386;
    (&point_1)->axis_y_0 = cross(_S385, _S386);
    (&point_1)->position_0 = _S334 + _S357;
    (&point_1)->view_0 = - normalize(_S350);
    bool _S387 = (dot(cross(_S374, _S375), _S385)) < 0.0f;
    float _S388 = _S326->uv_width_0;
    if(_S387)
    {
        _S352 = - _S326->uv_height_0;
    }
    else
    {
        _S352 = _S326->uv_height_0;
    }
    float2 _S389 = float2(_S388, _S352);
    float2 _S390 = _S371 * _S389;
    if(_S387)
    {
        _S352 = _S326->uv_height_0;
    }
    else
    {
        _S352 = 0.0f;
    }
    (&point_1)->draft_0 = _S390 + float2(0.0f, _S352);
    (&point_1)->draft_dx_0 = _S372 * _S389;
    (&point_1)->draft_dy_0 = _S373 * _S389;
    return point_1;
}

struct WovenView_0
{
    array<float, int(96)> sums_6;
    float hole_0;
    float correction_weight_0;
    float3 view_4;
    bool back_2;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S391, const Footprint_0 thread* _S392, KernelContext_0 thread* kernelContext_43)
{
    Fabric_0 device* _S393 = kernelContext_43->fabrics_0+_S391;
    float3 _S394 = row_of_taps_0(_S392);
    float2 _S395 = _S392->dx_0;
    float2 _S396 = _S392->dy_0;
    float _S397 = dot(_S392->dx_0, _S392->dx_0) + dot(_S392->dy_0, _S392->dy_0);
    float _S398 = _S392->dx_0.x * _S392->dy_0.y - _S392->dx_0.y * _S392->dy_0.x;
    float _S399 = 0.5f * (_S397 + sqrt(max(_S397 * _S397 - 4.0f * _S398 * _S398, 0.0f)));
    Woven_0 _S400 = _S393->woven_0;
    bool _S401;
    if(_S399 < (5.5f * (_S397 - _S399)))
    {
        _S401 = _S397 > (8.0f * _S400.pitch_0 * _S400.pitch_0);
    }
    else
    {
        _S401 = false;
    }
    float2 _S402 = float2(_S400.ends_per_mm_0, _S400.picks_per_mm_0);
    thread AnisotropicTaps_0 taps_1;
    (&taps_1)->centre_1 = _S392->centre_0 * _S402;
    float _S403;
    if(_S401)
    {
        _S403 = sqrt(0.125f * _S397);
    }
    else
    {
        _S403 = _S394.x;
    }
    (&taps_1)->side_0 = _S403 / _S400.pitch_0;
    float2 _S404;
    if(_S401)
    {
        _S404 = float2(0.25f)  * _S395;
    }
    else
    {
        _S404 = _S394.yz;
    }
    (&taps_1)->first_19 = _S404 * _S402;
    if(_S401)
    {
        _S404 = float2(0.25f)  * _S396;
    }
    else
    {
        _S404 = float2(0.5f)  * _S394.yz;
    }
    (&taps_1)->second_0 = _S404 * _S402;
    return taps_1;
}

void add_texel_0(uint _S405, uint _S406, float _S407, array<float, int(88)> thread* _S408, KernelContext_0 thread* kernelContext_44)
{
    uint _S409 = (kernelContext_44->fabrics_0+_S405)->woven_0.latents_0 + _S406 * 8U;
    uint part_0 = 0U;
    for(;;)
    {
        if(part_0 < 8U)
        {
        }
        else
        {
            break;
        }
        Eight_0 _S410 = eight_halves_0(uint4(*(kernelContext_44->packed_numbers_0+(_S409 + part_0))) );
        int _S411 = int(8U * part_0);
        (*_S408)[_S411] = (*_S408)[_S411] + _S407 * _S410.low_0[int(0)];
        (*_S408)[_S411 + int(4)] = (*_S408)[_S411 + int(4)] + _S407 * _S410.high_0[int(0)];
        int _S412 = _S411 + int(1);
        (*_S408)[_S412] = (*_S408)[_S412] + _S407 * _S410.low_0[int(1)];
        (*_S408)[_S412 + int(4)] = (*_S408)[_S412 + int(4)] + _S407 * _S410.high_0[int(1)];
        int _S413 = _S411 + int(2);
        (*_S408)[_S413] = (*_S408)[_S413] + _S407 * _S410.low_0[int(2)];
        (*_S408)[_S413 + int(4)] = (*_S408)[_S413 + int(4)] + _S407 * _S410.high_0[int(2)];
        int _S414 = _S411 + int(3);
        (*_S408)[_S414] = (*_S408)[_S414] + _S407 * _S410.low_0[int(3)];
        (*_S408)[_S414 + int(4)] = (*_S408)[_S414 + int(4)] + _S407 * _S410.high_0[int(3)];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S415, uint _S416, bool _S417, float2 _S418, float _S419, array<float, int(88)> thread* _S420, KernelContext_0 thread* kernelContext_45)
{
    Woven_0 _S421 = (kernelContext_45->fabrics_0+_S415)->woven_0;
    uint _S422 = (kernelContext_45->fabrics_0+_S415)->woven_0.levels_1 + 4U * _S416;
    float _S423 = table_number_0(_S422, kernelContext_45);
    float _S424 = table_number_0(_S422 + 1U, kernelContext_45);
    float _S425 = table_number_0(_S422 + 2U, kernelContext_45);
    bool _S426;
    if(_S416 > 3U)
    {
        _S426 = _S416 < (_S421.top_level_0);
    }
    else
    {
        _S426 = false;
    }
    float _S427 = table_number_0(_S422 + 3U, kernelContext_45);
    float2 _S428 = _S418 * float2(_S427) ;
    float _S429;
    if(_S426)
    {
        _S429 = 1.0f;
    }
    else
    {
        _S429 = 0.5f;
    }
    float2 _S430 = _S428 - float2(_S429) ;
    float2 _S431 = floor(_S430);
    float2 _S432 = _S430 - _S431;
    uint corner_0 = 0U;
    for(;;)
    {
        if(corner_0 < 4U)
        {
        }
        else
        {
            break;
        }
        float _S433 = float(corner_0 & 1U);
        float _S434 = float(corner_0 >> 1U);
        float2 _S435 = mix(float2(1.0f)  - _S432, _S432, float2(_S433, _S434));
        uint _S436 = uint(_S423 + wrapped_0(_S431.y + _S434, _S425) * _S424 + wrapped_0(_S431.x + _S433, _S424));
        uint _S437;
        if(_S417)
        {
            _S437 = _S421.texels_0;
        }
        else
        {
            _S437 = 0U;
        }
        add_texel_0(_S415, _S436 + _S437, _S419 * _S435.x * _S435.y, _S420, kernelContext_45);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S438, const AnisotropicTaps_0 thread* _S439, float3 _S440, bool _S441, array<float, int(88)> thread* _S442, KernelContext_0 thread* kernelContext_46)
{
    float offset_0;
    Fabric_0 device* _S443 = kernelContext_46->fabrics_0+_S438;
    int k_0 = int(0);
    for(;;)
    {
        if(k_0 < int(64))
        {
        }
        else
        {
            break;
        }
        (*_S442)[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    float2 _S444 = float2(_S443->woven_0.ends_0, _S443->woven_0.picks_0);
    float _S445 = float(_S443->woven_0.top_level_0);
    float _S446 = clamp(binary_logarithm_0(max(_S439->side_0, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S445);
    float _S447 = min(floor(_S446), _S445 - 1.0f);
    bool _S448 = AnisotropicTaps_has_steps_0(_S439);
    uint _S449;
    if(_S448)
    {
        _S449 = 4U;
    }
    else
    {
        _S449 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S449))
        {
        }
        else
        {
            break;
        }
        float2 _S450 = AnisotropicTaps_place_0(_S439, number_1 >> 1U);
        float2 _S451 = clamp(_S450 - _S444 * floor(_S450 / _S444), float2(0.0f) , _S444);
        bool _S452 = (number_1 & 1U) != 0U;
        if(_S452)
        {
            offset_0 = _S446 - _S447;
        }
        else
        {
            offset_0 = 1.0f - (_S446 - _S447);
        }
        float _S453 = offset_0 / float(_S449);
        uint _S454 = uint(_S447);
        uint _S455;
        if(_S452)
        {
            _S455 = 1U;
        }
        else
        {
            _S455 = 0U;
        }
        add_level_0(_S438, _S454 + _S455, _S441, _S451, _S453, _S442, kernelContext_46);
        number_1 = number_1 + 1U;
    }
    int number_2 = int(0);
    for(;;)
    {
        if(number_2 < int(3))
        {
        }
        else
        {
            break;
        }
        int bin_0 = int(0);
        for(;;)
        {
            if(bin_0 < int(8))
            {
            }
            else
            {
                break;
            }
            float offset_1 = _S440[number_2] - (float(bin_0) + 0.5f) / 8.0f;
            if(number_2 < int(2))
            {
                offset_0 = offset_1 - round(offset_1);
            }
            else
            {
                offset_0 = offset_1;
            }
            (*_S442)[int(64) + number_2 * int(8) + bin_0] = bump_0(offset_0 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_2 = number_2 + int(1);
    }
    return;
}

float3 crown_fibres_0(uint _S456, bool _S457, bool _S458, KernelContext_0 thread* kernelContext_47)
{
    Fabric_0 device* _S459 = kernelContext_47->fabrics_0+_S456;
    float _S460;
    if(_S457)
    {
        if(_S458)
        {
            _S460 = - _S459->woven_0.warp_x_0;
        }
        else
        {
            _S460 = _S459->woven_0.warp_x_0;
        }
        return float3(_S460, _S459->woven_0.warp_y_0, _S459->woven_0.warp_roughness_0);
    }
    Woven_0 _S461 = _S459->woven_0;
    if(_S458)
    {
        _S460 = - _S461.weft_y_0;
    }
    else
    {
        _S460 = _S461.weft_y_0;
    }
    return float3(_S461.weft_x_0, _S460, _S461.weft_roughness_0);
}

void woven_view_0(uint _S462, const Footprint_0 thread* _S463, float3 _S464, WovenView_0 thread* _S465, KernelContext_0 thread* kernelContext_48)
{
    Fabric_0 device* _S466 = kernelContext_48->fabrics_0+_S462;
    bool _S467 = (_S464.z) < 0.0f;
    AnisotropicTaps_0 _S468 = anisotropic_taps_0(_S462, _S463, kernelContext_48);
    thread AnisotropicTaps_0 _S469 = _S468;
    float3 _S470 = footprint_coordinates_0(&_S469);
    float3 _S471 = to_face_frame_0(_S464, _S467);
    thread HalfWeights_0 weights_23;
    (&weights_23)->first_2 = _S466->woven_0.network_0;
    thread AnisotropicTaps_0 _S472 = _S468;
    thread array<float, int(88)> inputs_23;
    code_footprint_0(_S462, &_S472, _S470, _S467, &inputs_23, kernelContext_48);
    thread HalfWeights_0 _S473 = weights_23;
    thread array<float, int(96)> hidden_0;
    dense_7(&_S473, 0U, false, &inputs_23, &hidden_0, kernelContext_48);
    thread HalfWeights_0 _S474 = weights_23;
    thread array<float, int(100)> fused_0;
    dense_part_8(&_S474, 1068U, false, &hidden_0, &fused_0, kernelContext_48);
    fused_0[int(96)] = _S471.x;
    fused_0[int(97)] = _S471.y;
    float3 _S475 = crown_fibres_0(_S462, true, _S467, kernelContext_48);
    float2 _S476 = _S471.xy;
    fused_0[int(98)] = dot(_S475.xy, _S476);
    float3 _S477 = crown_fibres_0(_S462, false, _S467, kernelContext_48);
    fused_0[int(99)] = dot(_S477.xy, _S476);
    thread HalfWeights_0 _S478 = weights_23;
    thread array<float, int(16)> of_hole_0;
    dense_6(&_S478, 2232U, false, &fused_0, &of_hole_0, kernelContext_48);
    thread HalfWeights_0 _S479 = weights_23;
    thread array<float, int(1)> hole_1;
    dense_5(&_S479, 2444U, false, &of_hole_0, &hole_1, kernelContext_48);
    thread HalfWeights_0 _S480 = weights_23;
    dense_4(&_S480, 2456U, false, &fused_0, &_S465->sums_6, kernelContext_48);
    _S465->hole_0 = clamp(hole_1[int(0)], 0.0f, 1.0f);
    _S465->correction_weight_0 = correction_weight_of_0(_S470.z);
    _S465->view_4 = _S471;
    _S465->back_2 = _S467;
    return;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_1;
    Albedos_0 weft_1;
};

FamilyAlbedos_0 albedos_over_0(uint _S481, const Footprint_0 thread* _S482, bool _S483, KernelContext_0 thread* kernelContext_49)
{
    Fabric_0 device* _S484 = kernelContext_49->fabrics_0+_S481;
    float2 _S485 = sqrt(_S482->dx_0 * _S482->dx_0 + _S482->dy_0 * _S482->dy_0);
    uint _S486 = _S484->warp_0;
    float2 _S487 = _S482->centre_0;
    Stretch_0 _S488 = stretch_of_0(_S484->warp_0, _S482->centre_0.x, _S485.x, kernelContext_49);
    uint _S489 = _S484->weft_0;
    Stretch_0 _S490 = stretch_of_0(_S484->weft_0, _S487.y, _S485.y, kernelContext_49);
    thread FamilyAlbedos_0 albedos_3;
    thread Stretch_0 _S491 = _S488;
    thread Stretch_0 _S492 = _S490;
    Albedos_0 _S493 = mean_albedos_0(_S486, _S489, &_S491, &_S492, _S483, kernelContext_49);
    (&albedos_3)->warp_1 = _S493;
    thread Stretch_0 _S494 = _S490;
    thread Stretch_0 _S495 = _S488;
    Albedos_0 _S496 = mean_albedos_0(_S489, _S486, &_S494, &_S495, _S483, kernelContext_49);
    (&albedos_3)->weft_1 = _S496;
    return albedos_3;
}

struct Components_0
{
    float diffuse_warp_0;
    float diffuse_weft_0;
    float specular_warp_0;
    float specular_weft_0;
    float light_visibility_1;
    float hole_2;
};

void code_light_0(uint _S497, float3 _S498, float3 _S499, bool _S500, array<float, int(39)> thread* _S501, KernelContext_0 thread* kernelContext_50)
{
    (*_S501)[int(0)] = _S498.x;
    (*_S501)[int(1)] = _S498.y;
    (*_S501)[int(2)] = _S498.z;
    float3 _S502 = _S498 + _S499;
    float _S503 = _S502.z;
    float _S504 = _S503 * _S503 + 0.00009999999747379f;
    float2 _S505 = _S502.xy;
    float _S506 = 1.0f / (dot(_S505, _S505) + _S504);
    int family_10 = int(0);
    for(;;)
    {
        if(family_10 < int(2))
        {
        }
        else
        {
            break;
        }
        float3 _S507 = crown_fibres_0(_S497, family_10 == int(0), _S500, kernelContext_50);
        float2 _S508 = _S507.xy;
        (*_S501)[int(3) + family_10] = dot(_S508, _S498.xy);
        float _S509 = dot(_S508, _S505);
        float _S510 = _S509 * _S509;
        float _S511 = (0.75f * _S509 / (0.5f * sqrt(_S510 + _S504) + abs(_S509)) + 0.5f) * 8.0f;
        int bin_1 = int(0);
        for(;;)
        {
            if(bin_1 < int(16))
            {
            }
            else
            {
                break;
            }
            (*_S501)[int(5) + family_10 * int(16) + bin_1] = bump_0(_S511 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S512 = _S507.z;
        float _S513 = _S512 * _S512;
        float _S514 = _S510 * _S506 * (1.0f - _S513) + _S513;
        (*_S501)[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S513 * _S512 / (_S514 * _S514));
        family_10 = family_10 + int(1);
    }
    return;
}

float mixed_bundles_0(uint _S515, uint _S516, uint _S517, float3 _S518, float3 _S519, bool _S520, array<float, int(52)> thread* _S521, KernelContext_0 thread* kernelContext_51)
{
    Fabric_0 device* _S522 = kernelContext_51->fabrics_0+_S515;
    float3 _S523 = _S518 + _S519;
    float _S524 = 1.0f / (square_0(_S523) + 0.00009999999747379f);
    bool _S525;
    if(_S516 == 0U)
    {
        _S525 = _S520;
    }
    else
    {
        _S525 = false;
    }
    float _S526;
    if(_S525)
    {
        _S526 = - _S523.x;
    }
    else
    {
        _S526 = _S523.x;
    }
    if(_S516 == 1U)
    {
        _S525 = _S520;
    }
    else
    {
        _S525 = false;
    }
    float _S527;
    if(_S525)
    {
        _S527 = - _S523.y;
    }
    else
    {
        _S527 = _S523.y;
    }
    uint bundle_1 = 0U;
    float sum_1 = 0.0f;
    for(;;)
    {
        if(bundle_1 < 25U)
        {
        }
        else
        {
            break;
        }
        uint _S528 = _S516 * 25U;
        uint _S529 = _S522->woven_0.bundles_0 + 4U * (_S528 + bundle_1);
        float _S530 = table_number_0(_S529, kernelContext_51);
        float _S531 = table_number_0(_S529 + 1U, kernelContext_51);
        float _S532 = table_number_0(_S529 + 2U, kernelContext_51);
        float _S533 = dot(float3(_S530, _S531, _S532), float3(_S526, _S527, _S523.z));
        float _S534 = _S533 * _S533 * _S524;
        float _S535 = table_number_0(_S529 + 3U, kernelContext_51);
        float _S536 = _S534 + _S535;
        uint _S537 = _S517 + _S528;
        uint _S538;
        if(_S520)
        {
            _S538 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S538 = bundle_1;
        }
        float sum_2 = sum_1 + max((*_S521)[_S537 + _S538], (*_S521)[_S537 + _S538] * 0.00999999977648258f) / (_S536 * _S536);
        bundle_1 = bundle_1 + 1U;
        sum_1 = sum_2;
    }
    return 0.01999999955296516f * sum_1;
}

Components_0 woven_components_0(uint _S539, WovenView_0 thread* _S540, float3 _S541, KernelContext_0 thread* kernelContext_52)
{
    float _S542;
    Fabric_0 device* _S543 = kernelContext_52->fabrics_0+_S539;
    bool _S544 = _S540->back_2;
    float3 _S545 = to_face_frame_0(_S541, _S540->back_2);
    float3 _S546 = _S540->view_4;
    thread HalfWeights_0 weights_24;
    Woven_0 _S547 = _S543->woven_0;
    (&weights_24)->first_2 = _S543->woven_0.network_0;
    thread array<float, int(39)> directions_0;
    code_light_0(_S539, _S545, _S540->view_4, _S540->back_2, &directions_0, kernelContext_52);
    thread array<float, int(96)> skip_0;
    int k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(96))
        {
        }
        else
        {
            break;
        }
        skip_0[k_1] = _S540->sums_6[k_1];
        k_1 = k_1 + int(1);
    }
    thread HalfWeights_0 _S548 = weights_24;
    dense_3(&_S548, 3716U, true, &directions_0, &skip_0, kernelContext_52);
    thread array<float, int(96)> hidden_1;
    thread array<float, int(96)> next_0;
    k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(96))
        {
        }
        else
        {
            break;
        }
        hidden_1[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
        k_1 = k_1 + int(1);
    }
    uint layer_0 = 0U;
    for(;;)
    {
        if(layer_0 < 3U)
        {
        }
        else
        {
            break;
        }
        k_1 = int(0);
        for(;;)
        {
            if(k_1 < int(96))
            {
            }
            else
            {
                break;
            }
            if(layer_0 == 1U)
            {
                _S542 = skip_0[k_1];
            }
            else
            {
                _S542 = 0.0f;
            }
            next_0[k_1] = _S542;
            k_1 = k_1 + int(1);
        }
        uint _S549 = 4208U + layer_0 * 1164U;
        thread HalfWeights_0 _S550 = weights_24;
        dense_2(&_S550, _S549, true, &hidden_1, &next_0, kernelContext_52);
        int k_2 = int(0);
        for(;;)
        {
            if(k_2 < int(96))
            {
            }
            else
            {
                break;
            }
            hidden_1[k_2] = next_0[k_2];
            k_2 = k_2 + int(1);
        }
        layer_0 = layer_0 + 1U;
    }
    thread HalfWeights_0 _S551 = weights_24;
    thread array<float, int(52)> outputs_17;
    dense_1(&_S551, 7700U, false, &hidden_1, &outputs_17, kernelContext_52);
    bool _S552;
    if((_S547.is_corrected_0) != 0U)
    {
        _S552 = (_S545.z) > 0.0f;
    }
    else
    {
        _S552 = false;
    }
    if(_S552)
    {
        _S552 = (_S540->correction_weight_0) > 0.0f;
    }
    else
    {
        _S552 = false;
    }
    if(_S552)
    {
        thread FloatWeights_0 fitted_0;
        (&fitted_0)->first_0 = _S547.correction_0;
        thread FloatWeights_0 _S553 = fitted_0;
        thread array<float, int(50)> change_0;
        dense_0(&_S553, 0U, false, &hidden_1, &change_0, kernelContext_52);
        k_1 = int(0);
        for(;;)
        {
            if(k_1 < int(50))
            {
            }
            else
            {
                break;
            }
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S540->correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S545.z) > 0.0f)
    {
        _S542 = 0.00999999977648258f;
    }
    else
    {
        _S542 = 0.00100000004749745f;
    }
    thread Components_0 result_1;
    float _S554 = unmapped_0(outputs_17[int(0)], _S542);
    (&result_1)->diffuse_warp_0 = _S554;
    float _S555 = unmapped_0(outputs_17[int(1)], _S542);
    (&result_1)->diffuse_weft_0 = _S555;
    float _S556 = 2979.9580078125f * _S542;
    float _S557 = mixed_bundles_0(_S539, 0U, 2U, _S545, _S546, _S544, &outputs_17, kernelContext_52);
    (&result_1)->specular_warp_0 = clamp(_S557, 0.0f, _S556);
    float _S558 = mixed_bundles_0(_S539, 1U, 2U, _S545, _S546, _S544, &outputs_17, kernelContext_52);
    (&result_1)->specular_weft_0 = clamp(_S558, 0.0f, _S556);
    (&result_1)->hole_2 = _S540->hole_0;
    (&result_1)->light_visibility_1 = min(light_visibility_of_0(_S554 + _S555, _S545, _S546, _S543->diffuse_blend_0), 1.0f - _S540->hole_0);
    return result_1;
}

float3 composed_0(uint _S559, const Components_0 thread* _S560, const FamilyAlbedos_0 thread* _S561, float3 _S562, float3 _S563, KernelContext_0 thread* kernelContext_53)
{
    Fabric_0 device* _S564 = kernelContext_53->fabrics_0+_S559;
    float3 _S565 = float3(_S560->diffuse_warp_0) ;
    float3 _S566 = float3(_S560->diffuse_weft_0) ;
    float3 _S567 = float3(_S560->specular_warp_0) ;
    float3 _S568 = float3(_S560->specular_weft_0) ;
    float3 _S569 = (&_S561->warp_1)->diffuse_reflect_0 * _S565 + (&_S561->weft_1)->diffuse_reflect_0 * _S566 + (&_S561->warp_1)->specular_reflect_0 * _S567 + (&_S561->weft_1)->specular_reflect_0 * _S568;
    float _S570 = _S563.z;
    float3 body_0;
    if((_S562.z * _S570) < 0.0f)
    {
        body_0 = (&_S561->warp_1)->diffuse_transmit_0 * _S565 + (&_S561->weft_1)->diffuse_transmit_0 * _S566 + (&_S561->warp_1)->specular_transmit_0 * _S567 + (&_S561->weft_1)->specular_transmit_0 * _S568;
    }
    else
    {
        body_0 = _S569;
    }
    float _S571 = _S564->sheen_strength_0;
    if((_S564->sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S572 = _S570 < 0.0f;
    float2 _S573 = sheen_with_transmittance_0(to_face_frame_0(_S562, _S572), to_face_frame_0(_S563, _S572), _S571, _S564->sheen_roughness_0);
    return float3(_S573.y)  * body_0 + float3(((_S560->light_visibility_1 + _S560->hole_2) * _S573.x)) ;
}

float4 light_of_woven_0(const Frame_0 thread* _S574, uint _S575, const VisiblePoint_0 thread* _S576, KernelContext_0 thread* kernelContext_54)
{
    Fabric_0 device* _S577 = kernelContext_54->fabrics_0+_S575;
    thread Footprint_0 footprint_1;
    (&footprint_1)->centre_0 = _S576->draft_0;
    (&footprint_1)->dx_0 = _S576->draft_dx_0;
    (&footprint_1)->dy_0 = _S576->draft_dy_0;
    float3 _S578 = to_local_0(_S576, _S576->view_0);
    thread Footprint_0 _S579 = footprint_1;
    thread WovenView_0 activations_0;
    woven_view_0(_S575, &_S579, _S578, &activations_0, kernelContext_54);
    float _S580 = _S578.z;
    bool _S581 = _S580 < 0.0f;
    thread Footprint_0 _S582 = footprint_1;
    FamilyAlbedos_0 _S583 = albedos_over_0(_S575, &_S582, _S581, kernelContext_54);
    float3 _S584 = float3(0.0f) ;
    uint number_3 = 0U;
    float3 radiance_1 = _S584;
    for(;;)
    {
        if(number_3 < (_S574->lights_0))
        {
        }
        else
        {
            break;
        }
        thread Light_0 _S585 = kernelContext_54->lights_1[number_3];
        thread float3 irradiance_2;
        float3 _S586 = towards_light_0(&_S585, _S576->position_0, &irradiance_2);
        float3 _S587 = to_local_0(_S576, _S586);
        Components_0 _S588 = woven_components_0(_S575, &activations_0, _S587, kernelContext_54);
        thread Components_0 _S589 = _S588;
        thread FamilyAlbedos_0 _S590 = _S583;
        float3 _S591 = composed_0(_S575, &_S589, &_S590, _S587, _S578, kernelContext_54);
        float3 radiance_2 = radiance_1 + irradiance_2 * _S591;
        number_3 = number_3 + 1U;
        radiance_1 = radiance_2;
    }
    float hole_3 = (&activations_0)->hole_0;
    float _S592 = _S577->sheen_strength_0;
    float hole_4;
    if((_S577->sheen_strength_0) > 0.0f)
    {
        hole_4 = hole_3 * (1.0f - _S592 * sheen_lobe_0(abs(_S580), _S577->sheen_roughness_0).z);
    }
    else
    {
        hole_4 = hole_3;
    }
    return float4(radiance_1, 1.0f - hole_4);
}

[[kernel]] void shade_woven(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], texture2d<uint, access::sample> visible_faces_1 [[texture(0)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], packed_uint4 device* packed_numbers_1 [[buffer(10)]], uint device* words_1 [[buffer(2)]], Family_0 device* families_1 [[buffer(1)]], Light_0 device* lights_2 [[buffer(3)]], packed_float4 device* radiance_3 [[buffer(8)]])
{
    thread KernelContext_0 kernelContext_55;
    (&kernelContext_55)->frames_0 = frames_1;
    (&kernelContext_55)->visible_faces_0 = visible_faces_1;
    (&kernelContext_55)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_55)->fabrics_0 = fabrics_1;
    (&kernelContext_55)->corners_0 = corners_1;
    (&kernelContext_55)->vertices_0 = vertices_1;
    (&kernelContext_55)->packed_numbers_0 = packed_numbers_1;
    (&kernelContext_55)->words_0 = words_1;
    (&kernelContext_55)->families_0 = families_1;
    (&kernelContext_55)->lights_1 = lights_2;
    (&kernelContext_55)->radiance_0 = radiance_3;
    Frame_0 _S593 = frames_1[int(0)];
    bool _S594;
    if((id_0.x) >= (_S593.width_0))
    {
        _S594 = true;
    }
    else
    {
        _S594 = (id_0.y) >= (_S593.height_0);
    }
    if(_S594)
    {
        return;
    }
    uint2 _S595 = id_0.xy;
    int3 _S596 = int3(int2(_S595), int(0));
    uint _S597 = (((&kernelContext_55)->visible_faces_0).read(vec<uint,2>(((_S596)).xy), uint(((_S596)).z)).x);
    float4 _S598 = float4(0.0f) ;
    float4 sum_3;
    if(_S597 > 0U)
    {
        uint _S599 = _S597 - 1U;
        uint _S600 = (&kernelContext_55)->face_fabrics_0[_S599];
        thread Frame_0 _S601 = _S593;
        VisiblePoint_0 _S602 = visible_point_0(&_S601, _S600, _S599, _S595, &kernelContext_55);
        thread Frame_0 _S603 = _S593;
        thread VisiblePoint_0 _S604 = _S602;
        float4 _S605 = light_of_woven_0(&_S603, _S600, &_S604, &kernelContext_55);
        sum_3 = _S605;
    }
    else
    {
        sum_3 = _S598;
    }
    thread Frame_0 _S606 = _S593;
    accumulate_0(&_S606, _S595, sum_3, &kernelContext_55);
    return;
}

