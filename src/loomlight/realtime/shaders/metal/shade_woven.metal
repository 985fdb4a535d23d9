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

struct Layer_0
{
    uint face_0;
    float share_0;
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
    Layer_0 device* layers_0;
    uint device* face_fabrics_0;
    Fabric_0 device* fabrics_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
    uint device* scene_words_0;
    packed_uint4 device* packed_numbers_0;
    uint device* words_0;
    Family_0 device* families_0;
    float device* visibilities_0;
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

float3 normal_of_0(const Vertex_0 thread* vertex_1)
{
    return float3(vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

float square_1(float x_4)
{
    return x_4 * x_4;
}

float natural_logarithm_0(float x_5)
{
    uint _S153 = (as_type<uint>((x_5)));
    float exponent_0 = float(int(_S153 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S153 & 8388607U) | 1056964608U)));
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
    float _S154 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S154 - exponent_1 * 0.00021219444170129f - 0.5f * _S154) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_6)
{
    return natural_logarithm_0(x_6) * 1.4426950216293335f;
}

float exponential_0(float x_7)
{
    float _S155 = clamp(x_7, -87.0f, 88.0f);
    float _S156 = floor(_S155 * 1.4426950216293335f + 0.5f);
    float _S157 = _S155 - _S156 * 0.693359375f + _S156 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S157 + 0.00139819993637502f) * _S157 + 0.00833345204591751f) * _S157 + 0.04166579619050026f) * _S157 + 0.1666666567325592f) * _S157 + 0.5f;
    float _S158 = (as_type<float>((uint(int(_S156) + int(127)) << 23U)));
    float _S159;
    if(x_7 < -87.0f)
    {
        _S159 = 0.0f;
    }
    else
    {
        _S159 = (p_0 * _S157 * _S157 + _S157 + 1.0f) * _S158;
    }
    return _S159;
}

float3 map_texel_0(uint index_0, KernelContext_0 thread* kernelContext_25)
{
    uint _S160 = kernelContext_25->scene_words_0[index_0];
    float3 _S161 = float3(float(_S160 & 1023U), float((_S160 >> 10U) & 1023U), float(_S160 >> 20U)) / float3(1023.0f) ;
    return _S161 * _S161;
}

float3 map_level_0(uint first_19, uint side_0, float2 uv_0, KernelContext_0 thread* kernelContext_26)
{
    float _S162 = uv_0.x;
    float _S163 = float(side_0);
    float _S164 = (_S162 - floor(_S162)) * _S163 - 0.5f;
    float _S165 = uv_0.y;
    float _S166 = (_S165 - floor(_S165)) * _S163 - 0.5f;
    float _S167 = floor(_S164);
    int _S168 = int(side_0);
    uint _S169 = side_0 - 1U;
    uint _S170 = uint(int(_S167) + _S168) & _S169;
    float _S171 = floor(_S166);
    uint _S172 = uint(int(_S171) + _S168) & _S169;
    uint _S173 = (_S170 + 1U) & _S169;
    uint _S174 = (_S172 + 1U) & _S169;
    float _S175 = _S164 - _S167;
    uint _S176 = first_19 + _S172 * side_0;
    float3 _S177 = map_texel_0(_S176 + _S170, kernelContext_26);
    float3 _S178 = map_texel_0(_S176 + _S173, kernelContext_26);
    float3 _S179 = float3(_S175) ;
    float3 _S180 = mix(_S177, _S178, _S179);
    uint _S181 = first_19 + _S174 * side_0;
    float3 _S182 = map_texel_0(_S181 + _S170, kernelContext_26);
    float3 _S183 = map_texel_0(_S181 + _S173, kernelContext_26);
    return mix(_S180, mix(_S182, _S183, _S179), float3((_S166 - _S171)) );
}

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float3 face_normal_0;
    float2 uv_1;
    float2 draft_per_uv_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(const VisiblePoint_0 thread* point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0->axis_x_0), dot(direction_0, point_0->axis_y_0), dot(direction_0, point_0->normal_0));
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float3 row_of_taps_0(const Footprint_0 thread* footprint_0)
{
    float _S184 = footprint_0->dx_0.x;
    float _S185 = footprint_0->dy_0.x;
    float _S186 = _S184 * _S184 + _S185 * _S185;
    float _S187 = footprint_0->dx_0.y;
    float _S188 = footprint_0->dy_0.y;
    float _S189 = _S187 * _S187 + _S188 * _S188;
    float _S190 = _S184 * _S187 + _S185 * _S188;
    float _S191 = 0.5f * (_S186 - _S189);
    float _S192 = 0.5f * (_S186 + _S189);
    float _S193 = sqrt(_S191 * _S191 + _S190 * _S190);
    float _S194 = _S192 + _S193;
    float _S195 = max(_S194 - 1.5f * max(_S192 - _S193, 0.0f), 0.0f);
    float _S196 = square_1(4.0f);
    float _S197 = max(_S192 - 0.5f * _S195, _S194 / _S196);
    float _S198 = sqrt(max(min(_S195, _S194 - _S197), 0.0f) / (_S196 - 1.0f));
    float _S199 = _S191 / max(_S193, 1.00000000317107685e-30f);
    float _S200 = sqrt(max(0.5f * (1.0f - _S199), 0.0f));
    float _S201 = sqrt(_S197);
    float _S202 = _S198 * sqrt(max(0.5f * (1.0f + _S199), 0.0f));
    float _S203;
    if(_S190 < 0.0f)
    {
        _S203 = - _S198 * _S200;
    }
    else
    {
        _S203 = _S198 * _S200;
    }
    return float3(_S201, _S202, _S203);
}

struct AnisotropicTaps_0
{
    float2 centre_1;
    float side_1;
    float2 first_20;
    float2 second_0;
};

float AnisotropicTaps_size_0(const AnisotropicTaps_0 thread* this_2)
{
    float _S204 = this_2->first_20.x;
    float _S205 = this_2->second_0.x;
    float _S206 = this_2->side_1 * this_2->side_1;
    float _S207 = this_2->first_20.y;
    float _S208 = this_2->second_0.y;
    float _S209 = 12.0f * (_S204 * _S207 + _S205 * _S208);
    return sqrt(sqrt(max((12.0f * (_S204 * _S204 + _S205 * _S205) + _S206) * (12.0f * (_S207 * _S207 + _S208 * _S208) + _S206) - _S209 * _S209, square_1(_S206))));
}

float3 footprint_coordinates_0(const AnisotropicTaps_0 thread* taps_0)
{
    float _S210 = AnisotropicTaps_size_0(taps_0);
    return float3(taps_0->centre_1 - floor(taps_0->centre_1), clamp(natural_logarithm_0(max(_S210, 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

float3 to_face_frame_0(float3 direction_1, bool back_1)
{
    float2 _S211 = direction_1.xy;
    float _S212;
    if(back_1)
    {
        _S212 = - direction_1.z;
    }
    else
    {
        _S212 = direction_1.z;
    }
    return float3(_S211, _S212);
}

float table_number_0(uint index_1, KernelContext_0 thread* kernelContext_27)
{
    return (as_type<float>((kernelContext_27->words_0[index_1])));
}

float table_number_1(uint index_2, KernelContext_0 thread* kernelContext_28)
{
    return (as_type<float>((kernelContext_28->words_0[index_2])));
}

float wrapped_0(float index_3, float count_1)
{
    float _S213;
    if(index_3 < 0.0f)
    {
        _S213 = index_3 + count_1;
    }
    else
    {
        if(index_3 >= count_1)
        {
            _S213 = index_3 - count_1;
        }
        else
        {
            _S213 = index_3;
        }
    }
    return _S213;
}

bool AnisotropicTaps_has_steps_0(const AnisotropicTaps_0 thread* this_3)
{
    float2 _S214 = float2(0.0f) ;
    bool _S215;
    if(any((this_3->first_20) != _S214))
    {
        _S215 = true;
    }
    else
    {
        _S215 = any((this_3->second_0) != _S214);
    }
    return _S215;
}

float2 AnisotropicTaps_place_0(const AnisotropicTaps_0 thread* this_4, uint number_0)
{
    float _S216;
    if(number_0 >= 2U)
    {
        _S216 = 1.0f;
    }
    else
    {
        _S216 = -1.0f;
    }
    float _S217;
    if((number_0 & 1U) != 0U)
    {
        _S217 = 1.0f;
    }
    else
    {
        _S217 = -1.0f;
    }
    return this_4->centre_1 + float2(_S216)  * this_4->first_20 + float2(_S217)  * this_4->second_0;
}

float bump_0(float distance_0)
{
    float _S218 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S218 * _S218;
}

float correction_weight_of_0(float coded_size_0)
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

float2 turns_and_remainder_0(uint family_0, float index_4, KernelContext_0 thread* kernelContext_29)
{
    float _S219 = floor(fma(index_4, kernelContext_29->families_0[family_0].inverse_count_0, kernelContext_29->families_0[family_0].half_inverse_count_0));
    return float2(_S219, fma(- _S219, kernelContext_29->families_0[family_0].count_0, index_4));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1, KernelContext_0 thread* kernelContext_30)
{
    float _S220 = floor(position_1 * kernelContext_30->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_0;
    float _S221 = fma(- _S220, kernelContext_30->families_0[family_1].size_0, position_1);
    (&cell_0)->below_0 = _S221;
    (&cell_0)->above_0 = kernelContext_30->families_0[family_1].size_0 - _S221;
    (&cell_0)->across_0 = _S221 - 0.5f * kernelContext_30->families_0[family_1].size_0;
    (&cell_0)->half_width_1 = kernelContext_30->families_0[family_1].half_width_0;
    float2 _S222 = turns_and_remainder_0(family_1, _S220, kernelContext_30);
    (&cell_0)->thread_0 = uint(clamp(_S222.y, 0.0f, kernelContext_30->families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_2, KernelContext_0 thread* kernelContext_31)
{
    float turns_0 = (position_2 - kernelContext_31->families_0[family_2].start_0) * kernelContext_31->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S223 = turns_1 * kernelContext_31->families_0[family_2].period_0;
    uint thread_1 = kernelContext_31->words_0[kernelContext_31->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_31->families_0[family_2].bins_0, 0.0f, kernelContext_31->families_0[family_2].bins_0 - 1.0f))];
    float _S224 = table_number_0(kernelContext_31->families_0[family_2].place_table_0 + thread_1 * 4U + 1U, kernelContext_31);
    uint _S225;
    if(_S223 >= _S224)
    {
        _S225 = 1U;
    }
    else
    {
        _S225 = 0U;
    }
    uint _S226 = min(thread_1 + _S225, uint(kernelContext_31->families_0[family_2].count_0) - 1U);
    uint _S227 = kernelContext_31->families_0[family_2].place_table_0 + _S226 * 4U;
    thread Cell_0 cell_1;
    (&cell_1)->thread_0 = _S226;
    float _S228 = table_number_0(_S227, kernelContext_31);
    (&cell_1)->below_0 = _S223 - _S228;
    float _S229 = table_number_0(_S227 + 1U, kernelContext_31);
    (&cell_1)->above_0 = _S229 - _S223;
    float _S230 = table_number_0(_S227 + 2U, kernelContext_31);
    (&cell_1)->across_0 = _S223 - _S230;
    float _S231 = table_number_0(_S227 + 3U, kernelContext_31);
    (&cell_1)->half_width_1 = _S231;
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_3, KernelContext_0 thread* kernelContext_32)
{
    if((kernelContext_32->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S232 = locate_alike_0(family_3, position_3, kernelContext_32);
        return _S232;
    }
    Cell_0 _S233 = locate_varied_0(family_3, position_3, kernelContext_32);
    return _S233;
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

Bound_0 bound_at_0(uint family_4, float position_4, KernelContext_0 thread* kernelContext_33)
{
    Cell_0 _S234 = locate_0(family_4, position_4, kernelContext_33);
    float _S235 = table_number_0(kernelContext_33->families_0[family_4].before_0 + 2U * _S234.thread_0 + 1U, kernelContext_33);
    thread Bound_0 bound_0;
    (&bound_0)->thread_2 = _S234.thread_0;
    (&bound_0)->turns_2 = round((position_4 - kernelContext_33->families_0[family_4].start_0 - _S235 - _S234.below_0) * kernelContext_33->families_0[family_4].inverse_period_0);
    (&bound_0)->cell_2 = _S234.below_0;
    float _S236 = 2.0f * _S234.half_width_1;
    (&bound_0)->width_1 = _S236;
    (&bound_0)->visible_0 = clamp((_S234.across_0 + _S234.half_width_1) / _S236, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S234.below_0, _S234.below_0 - _S234.across_0 - _S234.half_width_1) + max(_S234.across_0 - _S234.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1, KernelContext_0 thread* kernelContext_34)
{
    float _S237 = centre_2 - floor((centre_2 - kernelContext_34->families_0[family_5].start_0) * kernelContext_34->families_0[family_5].inverse_period_0) * kernelContext_34->families_0[family_5].period_0;
    float _S238 = 0.5f * max(size_1, kernelContext_34->families_0[family_5].smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S239 = bound_at_0(family_5, _S237 - _S238, kernelContext_34);
    (&stretch_0)->low_7 = _S239;
    Bound_0 _S240 = bound_at_0(family_5, _S237 + _S238, kernelContext_34);
    (&stretch_0)->high_7 = _S240;
    return stretch_0;
}

float3 table_colour_0(uint index_5, KernelContext_0 thread* kernelContext_35)
{
    float _S241 = table_number_1(index_5, kernelContext_35);
    float _S242 = table_number_1(index_5 + 1U, kernelContext_35);
    float _S243 = table_number_1(index_5 + 2U, kernelContext_35);
    return float3(_S241, _S242, _S243);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_6, KernelContext_0 thread* kernelContext_36)
{
    thread Albedos_0 albedos_0;
    float3 _S244 = table_colour_0(row_6, kernelContext_36);
    (&albedos_0)->diffuse_reflect_0 = _S244;
    float3 _S245 = table_colour_0(row_6 + 3U, kernelContext_36);
    (&albedos_0)->diffuse_transmit_0 = _S245;
    float3 _S246 = table_colour_0(row_6 + 6U, kernelContext_36);
    (&albedos_0)->specular_reflect_0 = _S246;
    float3 _S247 = table_colour_0(row_6 + 9U, kernelContext_36);
    (&albedos_0)->specular_transmit_0 = _S247;
    return albedos_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_5)
{
    return (&this_5->high_7)->turns_2 - (&this_5->low_7)->turns_2;
}

float3 lengths_0(uint family_6, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_37)
{
    float _S248 = Stretch_turns_0(stretch_1);
    uint _S249 = kernelContext_37->families_0[family_6].before_0 + 2U * (&stretch_1->low_7)->thread_2;
    uint _S250 = kernelContext_37->families_0[family_6].before_0 + 2U * (&stretch_1->high_7)->thread_2;
    float _S251 = table_number_0(_S250, kernelContext_37);
    float _S252 = table_number_0(_S249, kernelContext_37);
    float _S253 = _S251 - _S252;
    float _S254 = table_number_0(_S250 + 1U, kernelContext_37);
    float _S255 = table_number_0(_S249 + 1U, kernelContext_37);
    float _S256 = _S254 - _S255;
    return float3(_S253 + (&stretch_1->high_7)->visible_0 * (&stretch_1->high_7)->width_1 - (&stretch_1->low_7)->visible_0 * (&stretch_1->low_7)->width_1 + _S248 * kernelContext_37->families_0[family_6].visible_total_0, _S256 - _S253 + (&stretch_1->high_7)->gap_0 - (&stretch_1->low_7)->gap_0 + _S248 * (kernelContext_37->families_0[family_6].period_0 - kernelContext_37->families_0[family_6].visible_total_0), _S256 + (&stretch_1->high_7)->cell_2 - (&stretch_1->low_7)->cell_2 + _S248 * kernelContext_37->families_0[family_6].period_0);
}

float2 integrals_along_0(uint family_7, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_38)
{
    Family_0 _S257 = kernelContext_38->families_0[family_7];
    uint _S258 = 3U * _S257.quantities_0;
    uint _S259 = kernelContext_38->families_0[family_7].colour_threads_0 + _S258 * (&stretch_2->low_7)->thread_2 + quantity_0;
    uint _S260 = kernelContext_38->families_0[family_7].colour_threads_0 + _S258 * (&stretch_2->high_7)->thread_2 + quantity_0;
    uint _S261 = kernelContext_38->families_0[family_7].colour_threads_0 + _S258 * uint(kernelContext_38->families_0[family_7].count_0) + quantity_0;
    float _S262 = table_number_0(_S259, kernelContext_38);
    float _S263 = table_number_0(_S260, kernelContext_38);
    float _S264 = Stretch_turns_0(stretch_2);
    float _S265 = table_number_0(_S260 + _S257.quantities_0, kernelContext_38);
    float _S266 = table_number_0(_S259 + _S257.quantities_0, kernelContext_38);
    float _S267 = _S265 - _S266 + _S263 * (&stretch_2->high_7)->visible_0 * (&stretch_2->high_7)->width_1 - _S262 * (&stretch_2->low_7)->visible_0 * (&stretch_2->low_7)->width_1;
    float _S268 = table_number_0(_S261 + _S257.quantities_0, kernelContext_38);
    float _S269 = _S267 + _S264 * _S268;
    uint _S270 = 2U * _S257.quantities_0;
    float _S271 = table_number_0(_S260 + _S270, kernelContext_38);
    float _S272 = table_number_0(_S259 + _S270, kernelContext_38);
    float _S273 = _S271 - _S272 + _S263 * (&stretch_2->high_7)->cell_2 - _S262 * (&stretch_2->low_7)->cell_2;
    float _S274 = table_number_0(_S261 + _S270, kernelContext_38);
    return float2(_S269, _S273 + _S264 * _S274);
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
    uint _S275 = entries_0.z;
    uint _S276 = entries_0.x;
    uint _S277 = _S275 - _S276;
    bool _S278 = Stretch_wraps_1(this_8);
    uint _S279;
    if(_S278)
    {
        _S279 = whole_0;
    }
    else
    {
        _S279 = 0U;
    }
    return uint4(_S277 + _S279, entries_0.w - _S275, entries_0.y - _S276, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_1, uint row_7, uint count_2, uint quantities_1, KernelContext_0 thread* kernelContext_39)
{
    uint _S280 = row_7 + (&across_1->low_7)->thread_2 * quantities_1;
    uint _S281 = row_7 + (&across_1->high_7)->thread_2 * quantities_1;
    uint4 _S282 = Stretch_differences_0(across_1, uint4(kernelContext_39->words_0[_S280], kernelContext_39->words_0[_S280 + quantities_1], kernelContext_39->words_0[_S281], kernelContext_39->words_0[_S281 + quantities_1]), kernelContext_39->words_0[row_7 + count_2 * quantities_1]);
    return _S282;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_9)
{
    float _S283 = (&this_9->high_7)->visible_0;
    float _S284 = - (&this_9->low_7)->visible_0;
    float _S285 = Stretch_turns_0(this_9);
    bool _S286 = Stretch_wraps_0(this_9);
    float _S287;
    if(_S286)
    {
        _S287 = 1.0f;
    }
    else
    {
        _S287 = 0.0f;
    }
    return float4(1.0f, _S283, _S284, _S285 - _S287);
}

float integral_on_top_0(uint family_8, const Stretch_0 thread* across_2, const Stretch_0 thread* along_0, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_40)
{
    uint _S288 = uint(kernelContext_40->families_0[family_8].count_0);
    uint _S289 = (_S288 + 1U) * kernelContext_40->families_0[family_8].quantities_0;
    uint _S290 = kernelContext_40->families_0[family_8].colour_areas_0 + quantity_1;
    uint _S291 = (&along_0->low_7)->thread_2;
    uint4 _S292 = row_differences_0(across_2, _S290 + (&along_0->low_7)->thread_2 * _S289, _S288, kernelContext_40->families_0[family_8].quantities_0, kernelContext_40);
    uint4 _S293 = row_differences_0(across_2, _S290 + (_S291 + 1U) * _S289, _S288, kernelContext_40->families_0[family_8].quantities_0, kernelContext_40);
    uint _S294 = (&along_0->high_7)->thread_2;
    uint4 _S295 = row_differences_0(across_2, _S290 + (&along_0->high_7)->thread_2 * _S289, _S288, kernelContext_40->families_0[family_8].quantities_0, kernelContext_40);
    uint4 _S296 = row_differences_0(across_2, _S290 + (_S294 + 1U) * _S289, _S288, kernelContext_40->families_0[family_8].quantities_0, kernelContext_40);
    uint4 _S297 = row_differences_0(across_2, _S290 + crossing_count_0 * _S289, _S288, kernelContext_40->families_0[family_8].quantities_0, kernelContext_40);
    uint4 _S298 = _S295 - _S292;
    bool _S299 = Stretch_wraps_0(along_0);
    uint4 _S300;
    if(_S299)
    {
        _S300 = _S297;
    }
    else
    {
        _S300 = uint4(int4(int(0)) );
    }
    uint4 _S301 = _S298 + _S300;
    float4 _S302 = Stretch_weights_0(across_2);
    float4 _S303 = Stretch_weights_0(along_0);
    return dot(float4(dot(float4(int4(_S301)), _S302), dot(float4(int4(_S296 - _S295)), _S302), dot(float4(int4(_S293 - _S292)), _S302), dot(float4(int4(_S297)), _S302)), _S303) * kernelContext_40->families_0[family_8].area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_0, uint row_8, KernelContext_0 thread* kernelContext_41)
{
    Albedos_0 _S304 = table_albedos_0(row_8, kernelContext_41);
    thread Albedos_0 sum_0;
    float3 _S305 = float3(weight_0) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S305 * _S304.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S305 * _S304.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S305 * _S304.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S305 * _S304.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, const Stretch_0 thread* own_0, const Stretch_0 thread* other_0, bool back_2, KernelContext_0 thread* kernelContext_42)
{
    Albedos_0 _S306 = table_albedos_0(kernelContext_42->families_0[family_9].colour_mean_0, kernelContext_42);
    thread Albedos_0 albedos_2 = _S306;
    if((kernelContext_42->families_0[family_9].quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S307 = lengths_0(crossing_0, other_0, kernelContext_42);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (kernelContext_42->families_0[family_9].quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S308 = integrals_along_0(family_9, own_0, quantity_2, kernelContext_42);
        float _S309 = integral_on_top_0(family_9, own_0, other_0, uint(kernelContext_42->families_0[crossing_0].count_0), quantity_2, kernelContext_42);
        float _S310 = _S308.x;
        float _S311 = _S310 * _S307.x;
        float _S312;
        if(back_2)
        {
            _S312 = _S311 - _S309;
        }
        else
        {
            _S312 = _S309;
        }
        bool _S313 = quantity_2 == 0U;
        if(_S313)
        {
            is_exposed_0 = _S312 > (16.0f * kernelContext_42->families_0[family_9].area_unit_0 * min(_S311 / kernelContext_42->families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S311);
        }
        float _S314 = _S310 * _S307.y;
        float _S315;
        if(is_exposed_0)
        {
            _S315 = _S312;
        }
        else
        {
            _S315 = 0.0f;
        }
        float _S316 = _S314 + _S315 + 0.000244140625f * _S307.z * _S308.y;
        if(_S313)
        {
            weight_1 = 1.0f / max(_S316, 9.99999968265522539e-21f);
        }
        else
        {
            float _S317 = _S316 * weight_1;
            uint _S318 = kernelContext_42->families_0[family_9].colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S319 = albedos_2;
            Albedos_0 _S320 = with_added_albedos_0(&_S319, _S317, _S318, kernelContext_42);
            albedos_2 = _S320;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

Albedos_0 tinted_0(const Albedos_0 thread* albedos_3, float3 tint_0)
{
    thread Albedos_0 result_1 = *albedos_3;
    (&result_1)->diffuse_reflect_0 = (&result_1)->diffuse_reflect_0 * tint_0;
    (&result_1)->diffuse_transmit_0 = (&result_1)->diffuse_transmit_0 * tint_0;
    return result_1;
}

uint scramble_0(uint value_1)
{
    uint _S321 = value_1 * 747796405U + 2891336453U;
    uint _S322 = ((_S321 >> ((_S321 >> 28U) + 4U)) ^ _S321) * 277803737U;
    return (_S322 >> 22U) ^ _S322;
}

float uniform_hash_0(uint thread_3, uint cell_3, uint stream_0)
{
    return (float((scramble_0(cell_3 + scramble_0(thread_3 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_6, uint stream_1)
{
    uint _S323 = pixel_0.x;
    uint _S324 = pixel_0.y;
    return fract(float2(uniform_hash_0(_S323, _S324, stream_1), uniform_hash_0(_S323, _S324, stream_1 + 1U)) + float2(float(index_6 & 65535U))  * float2(0.75487768650054932f, 0.56984031200408936f));
}

float scene_number_0(uint index_7, KernelContext_0 thread* kernelContext_43)
{
    return (as_type<float>((kernelContext_43->scene_words_0[index_7])));
}

struct Choice_0
{
    uint index_8;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_3, float number_1, KernelContext_0 thread* kernelContext_44)
{
    uint high_8 = count_3;
    uint low_8 = 0U;
    for(;;)
    {
        if((high_8 - low_8) > 1U)
        {
        }
        else
        {
            break;
        }
        uint _S325 = (low_8 + high_8) / 2U;
        float _S326 = scene_number_0(table_0 + _S325, kernelContext_44);
        if(_S326 <= number_1)
        {
            low_8 = _S325;
        }
        else
        {
            high_8 = _S325;
        }
    }
    uint _S327 = table_0 + low_8;
    float _S328 = scene_number_0(_S327, kernelContext_44);
    float _S329 = scene_number_0(_S327 + 1U, kernelContext_44);
    thread Choice_0 choice_0;
    (&choice_0)->index_8 = low_8;
    (&choice_0)->remainder_0 = saturate((number_1 - _S328) / max(_S329 - _S328, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_8)
{
    float _S330 = floor(x_8 * 0.63661974668502808f + 0.5f);
    float _S331 = x_8 - _S330 * 1.5703125f - _S330 * 0.00048375129699707f - _S330 * 7.54979012640433211e-08f;
    float _S332 = _S331 * _S331;
    float _S333 = ((-0.00019515295571182f * _S332 + 0.00833216123282909f) * _S332 - 0.16666655242443085f) * _S332 * _S331 + _S331;
    float _S334 = ((0.00002443315679557f * _S332 - 0.00138873164542019f) * _S332 + 0.04166664555668831f) * _S332 * _S332 - 0.5f * _S332 + 1.0f;
    uint _S335 = uint(int(_S330)) & 3U;
    float2 _S336;
    if((_S335 & 1U) != 0U)
    {
        _S336 = float2(_S334, _S333);
    }
    else
    {
        _S336 = float2(_S333, _S334);
    }
    float _S337;
    if((_S335 & 2U) != 0U)
    {
        _S337 = - _S336.x;
    }
    else
    {
        _S337 = _S336.x;
    }
    float _S338;
    if(((_S335 + 1U) & 2U) != 0U)
    {
        _S338 = - _S336.y;
    }
    else
    {
        _S338 = _S336.y;
    }
    return float2(_S337, _S338);
}

float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

uint mirrored_bundle_0(uint bundle_0)
{
    uint _S339 = bundle_0 / 3U;
    uint _S340 = bundle_0 % 3U;
    uint _S341;
    if(bundle_0 == 24U)
    {
        _S341 = bundle_0;
    }
    else
    {
        _S341 = _S339 * 3U + 3U - 1U - _S340;
    }
    return _S341;
}

float light_visibility_of_0(float diffuse_0, float3 light_0, float3 view_1, float blend_0)
{
    float _S342 = max(abs(light_0.z), 0.00100000004749745f);
    float2 _S343 = light_0.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S342, (0.59700000286102295f * _S342 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S343, view_1.xy) * rsqrt(max(dot(_S343, _S343), 9.99999997475242708e-07f))) + 1.0f), blend_0);
}

float sheen_scale_0(float x_9, float y_2)
{
    return (((((0.0f * x_9 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_9 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_9 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_9 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_9 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_9 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_10, float y_3)
{
    return ((((0.0f * x_10 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_10 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_10 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_10 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_10 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_11, float y_4)
{
    return ((((0.0f * x_11 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_11 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_11 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_11 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_11 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S344 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S345 = 2.0f * sqrt(_S344) - 1.0f;
    float _S346 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S345, _S346), 0.00999999977648258f, 1.0f), clamp((1.0f - _S344) * sheen_shear_0(_S345, _S346), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S345, _S346), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_1, float3 view_2, float scale_1, float shear_0)
{
    float _S347 = light_1.z;
    bool _S348;
    if(_S347 <= 0.0f)
    {
        _S348 = true;
    }
    else
    {
        _S348 = (view_2.z) <= 0.0f;
    }
    if(_S348)
    {
        return 0.0f;
    }
    float2 _S349 = view_2.xy;
    float _S350 = dot(_S349, _S349);
    float2 _S351;
    if(_S350 > 9.99999968265522539e-21f)
    {
        _S351 = _S349 * float2(rsqrt(_S350)) ;
    }
    else
    {
        _S351 = float2(1.0f, 0.0f);
    }
    float _S352 = scale_1 * dot(light_1.xy, _S351) + shear_0 * _S347;
    float _S353 = scale_1 * (light_1.y * _S351.x - light_1.x * _S351.y);
    float _S354 = _S352 * _S352 + _S353 * _S353 + _S347 * _S347;
    return 0.31830987334251404f * scale_1 * scale_1 * _S347 / max(_S354 * _S354, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_2, float3 view_3, float strength_0, float roughness_2)
{
    float3 _S355 = sheen_lobe_0(view_3.z, roughness_2);
    float _S356 = strength_0 * _S355.z;
    return float2(_S356 * transformed_cosine_0(light_2, view_3, _S355.x, _S355.y), 1.0f - _S356);
}

void accumulate_0(uint index_9, float4 light_3, KernelContext_0 thread* kernelContext_45)
{
    float _S357 = (kernelContext_45->layers_0+index_9)->share_0;
    packed_float4 device* _S358 = kernelContext_45->radiance_0+index_9;
    *_S358 = packed_float4((float4(*_S358)  + float4((kernelContext_45->layers_0+index_9)->share_0)  * light_3)) ;
    (kernelContext_45->layers_0+index_9)->share_0 = _S357 * (1.0f - light_3.w);
    return;
}

float3 camera_right_0(int _S359, KernelContext_0 thread* kernelContext_46)
{
    Frame_0 device* _S360 = kernelContext_46->frames_0+_S359;
    return float3(_S360->right_x_0, _S360->right_y_0, _S360->right_z_0);
}

float3 camera_up_0(int _S361, KernelContext_0 thread* kernelContext_47)
{
    Frame_0 device* _S362 = kernelContext_47->frames_0+_S361;
    return float3(_S362->up_x_0, _S362->up_y_0, _S362->up_z_0);
}

float3 camera_forward_0(int _S363, KernelContext_0 thread* kernelContext_48)
{
    Frame_0 device* _S364 = kernelContext_48->frames_0+_S363;
    return float3(_S364->forward_x_0, _S364->forward_y_0, _S364->forward_z_0);
}

float3 camera_origin_0(int _S365, KernelContext_0 thread* kernelContext_49)
{
    Frame_0 device* _S366 = kernelContext_49->frames_0+_S365;
    return float3(_S366->origin_x_0, _S366->origin_y_0, _S366->origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S367, uint _S368, float _S369, float _S370, KernelContext_0 thread* kernelContext_50)
{
    Fabric_0 device* _S371 = kernelContext_50->fabrics_0+_S367;
    uint _S372 = 3U * _S368;
    Vertex_0 _S373 = kernelContext_50->vertices_0[kernelContext_50->corners_0[_S372]];
    Vertex_0 _S374 = kernelContext_50->vertices_0[kernelContext_50->corners_0[_S372 + 1U]];
    Vertex_0 _S375 = kernelContext_50->vertices_0[kernelContext_50->corners_0[_S372 + 2U]];
    thread Vertex_0 _S376 = _S374;
    float3 _S377 = position_of_0(&_S376);
    thread Vertex_0 _S378 = _S373;
    float3 _S379 = position_of_0(&_S378);
    float3 _S380 = _S377 - _S379;
    thread Vertex_0 _S381 = _S375;
    float3 _S382 = position_of_0(&_S381);
    float3 _S383 = _S382 - _S379;
    float _S384 = _S374.u_0 - _S373.u_0;
    float _S385 = _S374.v_0 - _S373.v_0;
    float2 _S386 = float2(_S384, _S385);
    float _S387 = _S375.u_0 - _S373.u_0;
    float _S388 = _S375.v_0 - _S373.v_0;
    float2 _S389 = float2(_S387, _S388);
    float _S390;
    if((_S384 * _S388 - _S385 * _S387) < 0.0f)
    {
        _S390 = -1.0f;
    }
    else
    {
        _S390 = 1.0f;
    }
    float3 _S391 = float3(_S390)  * (float3(_S388)  * _S380 - float3(_S385)  * _S383);
    float3 _S392 = float3(_S390)  * (float3(_S384)  * _S383 - float3(_S387)  * _S380);
    thread VisiblePoint_0 point_1;
    float _S393 = 1.0f - _S369 - _S370;
    thread Vertex_0 _S394 = _S373;
    float3 _S395 = normal_of_0(&_S394);
    float3 _S396 = float3(_S393)  * _S395;
    thread Vertex_0 _S397 = _S374;
    float3 _S398 = normal_of_0(&_S397);
    float3 _S399 = float3(_S369) ;
    float3 _S400 = _S396 + _S399 * _S398;
    thread Vertex_0 _S401 = _S375;
    float3 _S402 = normal_of_0(&_S401);
    float3 _S403 = float3(_S370) ;
    float3 _S404 = normalize(_S400 + _S403 * _S402);
    (&point_1)->normal_0 = _S404;
    float3 _S405 = normalize(_S391 - _S404 * float3(dot(_S404, _S391)) );
    (&point_1)->axis_x_0 = _S405;
    (&point_1)->axis_y_0 = cross(_S404, _S405);
    float3 _S406 = normalize(cross(_S380, _S383));
    float3 _S407;
    if((dot(_S406, _S404)) < 0.0f)
    {
        _S407 = - _S406;
    }
    else
    {
        _S407 = _S406;
    }
    (&point_1)->face_normal_0 = _S407;
    (&point_1)->position_0 = _S379 + _S399 * _S380 + _S403 * _S383;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_1 = float2(_S373.u_0, _S373.v_0) + float2(_S369)  * _S386 + float2(_S370)  * _S389;
    bool _S408 = (dot(cross(_S391, _S392), (&point_1)->normal_0)) < 0.0f;
    float _S409 = _S371->uv_width_0;
    if(_S408)
    {
        _S390 = - _S371->uv_height_0;
    }
    else
    {
        _S390 = _S371->uv_height_0;
    }
    float2 _S410 = float2(_S409, _S390);
    (&point_1)->draft_per_uv_0 = _S410;
    float2 _S411 = (&point_1)->uv_1 * _S410;
    if(_S408)
    {
        _S390 = _S371->uv_height_0;
    }
    else
    {
        _S390 = 0.0f;
    }
    (&point_1)->draft_0 = _S411 + float2(0.0f, _S390);
    float2 _S412 = float2(0.0f) ;
    (&point_1)->draft_dx_0 = _S412;
    (&point_1)->draft_dy_0 = _S412;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S413, uint _S414, uint _S415, uint2 _S416, KernelContext_0 thread* kernelContext_51)
{
    Frame_0 device* _S417 = kernelContext_51->frames_0+_S413;
    uint _S418 = 3U * _S415;
    Vertex_0 _S419 = kernelContext_51->vertices_0[kernelContext_51->corners_0[_S418]];
    Vertex_0 _S420 = kernelContext_51->vertices_0[kernelContext_51->corners_0[_S418 + 1U]];
    Vertex_0 _S421 = kernelContext_51->vertices_0[kernelContext_51->corners_0[_S418 + 2U]];
    thread Vertex_0 _S422 = _S420;
    float3 _S423 = position_of_0(&_S422);
    thread Vertex_0 _S424 = _S419;
    float3 _S425 = position_of_0(&_S424);
    float3 _S426 = _S423 - _S425;
    thread Vertex_0 _S427 = _S421;
    float3 _S428 = position_of_0(&_S427);
    float3 _S429 = _S428 - _S425;
    float3 _S430 = cross(_S426, _S429);
    float _S431 = 1.0f / max(square_0(_S430), 1.00000000317107685e-30f);
    float3 _S432 = camera_right_0(_S413, kernelContext_51);
    float _S433 = float(_S417->width_0);
    float3 _S434 = _S432 * float3((2.0f / _S433)) ;
    float3 _S435 = camera_up_0(_S413, kernelContext_51);
    float _S436 = float(_S417->height_0);
    float3 _S437 = _S435 * float3((-2.0f / _S436)) ;
    float _S438 = float(_S416.x) + 0.5f - 0.5f * _S433;
    float _S439 = float(_S416.y) + 0.5f - 0.5f * _S436;
    float3 _S440 = camera_forward_0(_S413, kernelContext_51);
    float3 _S441 = _S440 + float3(_S438)  * _S434 + float3(_S439)  * _S437;
    float _S442 = dot(_S441, _S430);
    float _S443;
    if((abs(_S442)) > 1.00000000317107685e-30f)
    {
        _S443 = _S442;
    }
    else
    {
        _S443 = 1.00000000317107685e-30f;
    }
    float _S444 = 1.0f / _S443;
    float3 _S445 = camera_origin_0(_S413, kernelContext_51);
    float3 _S446 = _S425 - _S445;
    float3 _S447 = float3((dot(_S446, _S430) * _S444)) ;
    float3 _S448 = _S441 * _S447 - _S446;
    float3 _S449 = _S447 * (_S434 - _S441 * float3((dot(_S434, _S430) * _S444)) );
    float3 _S450 = _S447 * (_S437 - _S441 * float3((dot(_S437, _S430) * _S444)) );
    float3 _S451 = float3(_S431) ;
    float3 _S452 = cross(_S429, _S430) * _S451;
    float3 _S453 = cross(_S430, _S426) * _S451;
    float2 _S454 = float2(_S420.u_0 - _S419.u_0, _S420.v_0 - _S419.v_0);
    float2 _S455 = float2(_S421.u_0 - _S419.u_0, _S421.v_0 - _S419.v_0);
    VisiblePoint_0 _S456 = face_point_0(_S414, _S415, dot(_S448, _S452), dot(_S448, _S453), kernelContext_51);
    thread VisiblePoint_0 point_2 = _S456;
    (&point_2)->position_0 = _S425 + _S448;
    (&point_2)->view_0 = - normalize(_S441);
    (&point_2)->draft_dx_0 = (float2(dot(_S449, _S452))  * _S454 + float2(dot(_S449, _S453))  * _S455) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (float2(dot(_S450, _S452))  * _S454 + float2(dot(_S450, _S453))  * _S455) * (&point_2)->draft_per_uv_0;
    return point_2;
}

float3 filtered_albedo_0(uint _S457, const VisiblePoint_0 thread* _S458, KernelContext_0 thread* kernelContext_52)
{
    Fabric_0 device* _S459 = kernelContext_52->fabrics_0+_S457;
    uint _S460 = _S459->albedo_map_levels_0;
    if((_S459->albedo_map_levels_0) == 0U)
    {
        return float3(1.0f) ;
    }
    float2 _S461 = float2(_S459->uv_width_0, _S459->uv_height_0);
    float2 _S462 = _S458->draft_dx_0 / _S461;
    float2 _S463 = _S458->draft_dy_0 / _S461;
    uint _S464 = _S460 - 1U;
    uint _S465 = 1U << _S464;
    float _S466 = clamp(0.5f * binary_logarithm_0(max(abs(_S462.x * _S463.y - _S462.y * _S463.x), 9.99999968265522539e-21f) * (square_1(float(_S465)) / 3.0f)), 0.0f, float(_S460) - 1.0f);
    uint _S467 = min(uint(_S466), max(_S460, 2U) - 2U);
    uint _S468 = min(_S467 + 1U, _S464);
    uint _S469 = 1U << (2U * _S460);
    uint _S470 = _S459->albedo_map_0 + (_S469 - (_S469 >> (2U * _S468))) / 3U;
    float _S471 = (exponential_0(1.38629436492919922f * (_S466 - float(_S467))) - 1.0f) / 3.0f;
    float2 _S472 = _S458->uv_1;
    float3 _S473 = map_level_0(_S459->albedo_map_0 + (_S469 - (_S469 >> (2U * _S467))) / 3U, _S465 >> _S467, _S458->uv_1, kernelContext_52);
    float3 _S474 = map_level_0(_S470, _S465 >> _S468, _S472, kernelContext_52);
    return mix(_S473, _S474, float3(_S471) );
}

struct WovenView_0
{
    array<float, int(96)> sums_6;
    float hole_0;
    float correction_weight_0;
    float3 view_4;
    bool back_3;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S475, const Footprint_0 thread* _S476, KernelContext_0 thread* kernelContext_53)
{
    Fabric_0 device* _S477 = kernelContext_53->fabrics_0+_S475;
    float3 _S478 = row_of_taps_0(_S476);
    float2 _S479 = _S476->dx_0;
    float2 _S480 = _S476->dy_0;
    float _S481 = dot(_S476->dx_0, _S476->dx_0) + dot(_S476->dy_0, _S476->dy_0);
    float _S482 = _S476->dx_0.x * _S476->dy_0.y - _S476->dx_0.y * _S476->dy_0.x;
    float _S483 = 0.5f * (_S481 + sqrt(max(_S481 * _S481 - 4.0f * _S482 * _S482, 0.0f)));
    Woven_0 _S484 = _S477->woven_0;
    bool _S485;
    if(_S483 < (5.5f * (_S481 - _S483)))
    {
        _S485 = _S481 > (8.0f * _S484.pitch_0 * _S484.pitch_0);
    }
    else
    {
        _S485 = false;
    }
    float2 _S486 = float2(_S484.ends_per_mm_0, _S484.picks_per_mm_0);
    thread AnisotropicTaps_0 taps_1;
    (&taps_1)->centre_1 = _S476->centre_0 * _S486;
    float _S487;
    if(_S485)
    {
        _S487 = sqrt(0.125f * _S481);
    }
    else
    {
        _S487 = _S478.x;
    }
    (&taps_1)->side_1 = _S487 / _S484.pitch_0;
    float2 _S488;
    if(_S485)
    {
        _S488 = float2(0.25f)  * _S479;
    }
    else
    {
        _S488 = _S478.yz;
    }
    (&taps_1)->first_20 = _S488 * _S486;
    if(_S485)
    {
        _S488 = float2(0.25f)  * _S480;
    }
    else
    {
        _S488 = float2(0.5f)  * _S478.yz;
    }
    (&taps_1)->second_0 = _S488 * _S486;
    return taps_1;
}

void add_texel_0(uint _S489, uint _S490, float _S491, array<float, int(88)> thread* _S492, KernelContext_0 thread* kernelContext_54)
{
    uint _S493 = (kernelContext_54->fabrics_0+_S489)->woven_0.latents_0 + _S490 * 8U;
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
        Eight_0 _S494 = eight_halves_0(uint4(*(kernelContext_54->packed_numbers_0+(_S493 + part_0))) );
        int _S495 = int(8U * part_0);
        (*_S492)[_S495] = (*_S492)[_S495] + _S491 * _S494.low_0[int(0)];
        (*_S492)[_S495 + int(4)] = (*_S492)[_S495 + int(4)] + _S491 * _S494.high_0[int(0)];
        int _S496 = _S495 + int(1);
        (*_S492)[_S496] = (*_S492)[_S496] + _S491 * _S494.low_0[int(1)];
        (*_S492)[_S496 + int(4)] = (*_S492)[_S496 + int(4)] + _S491 * _S494.high_0[int(1)];
        int _S497 = _S495 + int(2);
        (*_S492)[_S497] = (*_S492)[_S497] + _S491 * _S494.low_0[int(2)];
        (*_S492)[_S497 + int(4)] = (*_S492)[_S497 + int(4)] + _S491 * _S494.high_0[int(2)];
        int _S498 = _S495 + int(3);
        (*_S492)[_S498] = (*_S492)[_S498] + _S491 * _S494.low_0[int(3)];
        (*_S492)[_S498 + int(4)] = (*_S492)[_S498 + int(4)] + _S491 * _S494.high_0[int(3)];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S499, uint _S500, bool _S501, float2 _S502, float _S503, array<float, int(88)> thread* _S504, KernelContext_0 thread* kernelContext_55)
{
    Woven_0 _S505 = (kernelContext_55->fabrics_0+_S499)->woven_0;
    uint _S506 = (kernelContext_55->fabrics_0+_S499)->woven_0.levels_1 + 4U * _S500;
    float _S507 = table_number_0(_S506, kernelContext_55);
    float _S508 = table_number_0(_S506 + 1U, kernelContext_55);
    float _S509 = table_number_0(_S506 + 2U, kernelContext_55);
    bool _S510;
    if(_S500 > 3U)
    {
        _S510 = _S500 < (_S505.top_level_0);
    }
    else
    {
        _S510 = false;
    }
    float _S511 = table_number_0(_S506 + 3U, kernelContext_55);
    float2 _S512 = _S502 * float2(_S511) ;
    float _S513;
    if(_S510)
    {
        _S513 = 1.0f;
    }
    else
    {
        _S513 = 0.5f;
    }
    float2 _S514 = _S512 - float2(_S513) ;
    float2 _S515 = floor(_S514);
    float2 _S516 = _S514 - _S515;
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
        float _S517 = float(corner_0 & 1U);
        float _S518 = float(corner_0 >> 1U);
        float2 _S519 = mix(float2(1.0f)  - _S516, _S516, float2(_S517, _S518));
        uint _S520 = uint(_S507 + wrapped_0(_S515.y + _S518, _S509) * _S508 + wrapped_0(_S515.x + _S517, _S508));
        uint _S521;
        if(_S501)
        {
            _S521 = _S505.texels_0;
        }
        else
        {
            _S521 = 0U;
        }
        add_texel_0(_S499, _S520 + _S521, _S503 * _S519.x * _S519.y, _S504, kernelContext_55);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S522, const AnisotropicTaps_0 thread* _S523, float3 _S524, bool _S525, array<float, int(88)> thread* _S526, KernelContext_0 thread* kernelContext_56)
{
    float offset_1;
    Fabric_0 device* _S527 = kernelContext_56->fabrics_0+_S522;
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
        (*_S526)[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    float2 _S528 = float2(_S527->woven_0.ends_0, _S527->woven_0.picks_0);
    float _S529 = float(_S527->woven_0.top_level_0);
    float _S530 = clamp(binary_logarithm_0(max(_S523->side_1, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S529);
    float _S531 = min(floor(_S530), _S529 - 1.0f);
    bool _S532 = AnisotropicTaps_has_steps_0(_S523);
    uint _S533;
    if(_S532)
    {
        _S533 = 4U;
    }
    else
    {
        _S533 = 1U;
    }
    uint number_2 = 0U;
    for(;;)
    {
        if(number_2 < (2U * _S533))
        {
        }
        else
        {
            break;
        }
        float2 _S534 = AnisotropicTaps_place_0(_S523, number_2 >> 1U);
        float2 _S535 = clamp(_S534 - _S528 * floor(_S534 / _S528), float2(0.0f) , _S528);
        bool _S536 = (number_2 & 1U) != 0U;
        if(_S536)
        {
            offset_1 = _S530 - _S531;
        }
        else
        {
            offset_1 = 1.0f - (_S530 - _S531);
        }
        float _S537 = offset_1 / float(_S533);
        uint _S538 = uint(_S531);
        uint _S539;
        if(_S536)
        {
            _S539 = 1U;
        }
        else
        {
            _S539 = 0U;
        }
        add_level_0(_S522, _S538 + _S539, _S525, _S535, _S537, _S526, kernelContext_56);
        number_2 = number_2 + 1U;
    }
    int number_3 = int(0);
    for(;;)
    {
        if(number_3 < int(3))
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
            float offset_2 = _S524[number_3] - (float(bin_0) + 0.5f) / 8.0f;
            if(number_3 < int(2))
            {
                offset_1 = offset_2 - round(offset_2);
            }
            else
            {
                offset_1 = offset_2;
            }
            (*_S526)[int(64) + number_3 * int(8) + bin_0] = bump_0(offset_1 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_3 = number_3 + int(1);
    }
    return;
}

float3 crown_fibres_0(uint _S540, bool _S541, bool _S542, KernelContext_0 thread* kernelContext_57)
{
    Fabric_0 device* _S543 = kernelContext_57->fabrics_0+_S540;
    float _S544;
    if(_S541)
    {
        if(_S542)
        {
            _S544 = - _S543->woven_0.warp_x_0;
        }
        else
        {
            _S544 = _S543->woven_0.warp_x_0;
        }
        return float3(_S544, _S543->woven_0.warp_y_0, _S543->woven_0.warp_roughness_0);
    }
    Woven_0 _S545 = _S543->woven_0;
    if(_S542)
    {
        _S544 = - _S545.weft_y_0;
    }
    else
    {
        _S544 = _S545.weft_y_0;
    }
    return float3(_S545.weft_x_0, _S544, _S545.weft_roughness_0);
}

void woven_view_0(uint _S546, const Footprint_0 thread* _S547, float3 _S548, WovenView_0 thread* _S549, KernelContext_0 thread* kernelContext_58)
{
    Fabric_0 device* _S550 = kernelContext_58->fabrics_0+_S546;
    bool _S551 = (_S548.z) < 0.0f;
    AnisotropicTaps_0 _S552 = anisotropic_taps_0(_S546, _S547, kernelContext_58);
    thread AnisotropicTaps_0 _S553 = _S552;
    float3 _S554 = footprint_coordinates_0(&_S553);
    float3 _S555 = to_face_frame_0(_S548, _S551);
    thread HalfWeights_0 weights_23;
    (&weights_23)->first_2 = _S550->woven_0.network_0;
    thread AnisotropicTaps_0 _S556 = _S552;
    thread array<float, int(88)> inputs_23;
    code_footprint_0(_S546, &_S556, _S554, _S551, &inputs_23, kernelContext_58);
    thread HalfWeights_0 _S557 = weights_23;
    thread array<float, int(96)> hidden_0;
    dense_7(&_S557, 0U, false, &inputs_23, &hidden_0, kernelContext_58);
    thread HalfWeights_0 _S558 = weights_23;
    thread array<float, int(100)> fused_0;
    dense_part_8(&_S558, 1068U, false, &hidden_0, &fused_0, kernelContext_58);
    fused_0[int(96)] = _S555.x;
    fused_0[int(97)] = _S555.y;
    float3 _S559 = crown_fibres_0(_S546, true, _S551, kernelContext_58);
    float2 _S560 = _S555.xy;
    fused_0[int(98)] = dot(_S559.xy, _S560);
    float3 _S561 = crown_fibres_0(_S546, false, _S551, kernelContext_58);
    fused_0[int(99)] = dot(_S561.xy, _S560);
    thread HalfWeights_0 _S562 = weights_23;
    thread array<float, int(16)> of_hole_0;
    dense_6(&_S562, 2232U, false, &fused_0, &of_hole_0, kernelContext_58);
    thread HalfWeights_0 _S563 = weights_23;
    thread array<float, int(1)> hole_1;
    dense_5(&_S563, 2444U, false, &of_hole_0, &hole_1, kernelContext_58);
    thread HalfWeights_0 _S564 = weights_23;
    dense_4(&_S564, 2456U, false, &fused_0, &_S549->sums_6, kernelContext_58);
    _S549->hole_0 = clamp(hole_1[int(0)], 0.0f, 1.0f);
    _S549->correction_weight_0 = correction_weight_of_0(_S554.z);
    _S549->view_4 = _S555;
    _S549->back_3 = _S551;
    return;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_1;
    Albedos_0 weft_1;
};

FamilyAlbedos_0 albedos_over_0(uint _S565, const Footprint_0 thread* _S566, bool _S567, KernelContext_0 thread* kernelContext_59)
{
    Fabric_0 device* _S568 = kernelContext_59->fabrics_0+_S565;
    float2 _S569 = sqrt(_S566->dx_0 * _S566->dx_0 + _S566->dy_0 * _S566->dy_0);
    uint _S570 = _S568->warp_0;
    float2 _S571 = _S566->centre_0;
    Stretch_0 _S572 = stretch_of_0(_S568->warp_0, _S566->centre_0.x, _S569.x, kernelContext_59);
    uint _S573 = _S568->weft_0;
    Stretch_0 _S574 = stretch_of_0(_S568->weft_0, _S571.y, _S569.y, kernelContext_59);
    thread FamilyAlbedos_0 albedos_4;
    thread Stretch_0 _S575 = _S572;
    thread Stretch_0 _S576 = _S574;
    Albedos_0 _S577 = mean_albedos_0(_S570, _S573, &_S575, &_S576, _S567, kernelContext_59);
    (&albedos_4)->warp_1 = _S577;
    thread Stretch_0 _S578 = _S574;
    thread Stretch_0 _S579 = _S572;
    Albedos_0 _S580 = mean_albedos_0(_S573, _S570, &_S578, &_S579, _S567, kernelContext_59);
    (&albedos_4)->weft_1 = _S580;
    return albedos_4;
}

uint light_sample_count_0(int _S581, KernelContext_0 thread* kernelContext_60)
{
    Frame_0 device* _S582 = kernelContext_60->frames_0+_S581;
    return _S582->lights_0 + _S582->environment_samples_0;
}

float visibility_at_0(int _S583, uint _S584, uint2 _S585, KernelContext_0 thread* kernelContext_61)
{
    Frame_0 device* _S586 = kernelContext_61->frames_0+_S583;
    if((_S586->casts_shadows_0) == 0U)
    {
        return 1.0f;
    }
    return *(kernelContext_61->visibilities_0+((_S584 * _S586->height_0 + _S585.y) * _S586->width_0 + _S585.x));
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_1;
};

float3 environment_texel_0(int _S587, uint _S588, uint _S589, KernelContext_0 thread* kernelContext_62)
{
    Frame_0 device* _S590 = kernelContext_62->frames_0+_S587;
    uint _S591 = _S590->environment_table_0 + _S590->environment_rows_0 + 1U + _S590->environment_rows_0 * (_S590->environment_columns_0 + 1U) + 3U * (_S588 * _S590->environment_columns_0 + _S589);
    float _S592 = scene_number_0(_S591, kernelContext_62);
    float _S593 = scene_number_0(_S591 + 1U, kernelContext_62);
    float _S594 = scene_number_0(_S591 + 2U, kernelContext_62);
    return float3(_S592, _S593, _S594);
}

float3 sample_environment_0(int _S595, float2 _S596, float3 thread* _S597, KernelContext_0 thread* kernelContext_63)
{
    Frame_0 device* _S598 = kernelContext_63->frames_0+_S595;
    uint _S599 = _S598->environment_table_0;
    uint _S600 = _S598->environment_rows_0;
    Choice_0 _S601 = choose_0(_S598->environment_table_0, _S598->environment_rows_0, _S596.y, kernelContext_63);
    uint _S602 = _S598->environment_columns_0;
    Choice_0 _S603 = choose_0(_S599 + _S600 + 1U + _S601.index_8 * (_S598->environment_columns_0 + 1U), _S598->environment_columns_0, _S596.x, kernelContext_63);
    float3 _S604 = environment_texel_0(_S595, _S601.index_8, _S603.index_8, kernelContext_63);
    *_S597 = _S604 * float3((_S598->environment_total_0 / max(mean_0(_S604), 9.99999968265522539e-21f))) ;
    float _S605 = 3.14159274101257324f / float(_S600);
    float _S606 = mix(sine_cosine_0(float(_S601.index_8) * _S605).y, sine_cosine_0(float(_S601.index_8 + 1U) * _S605).y, _S601.remainder_0);
    float _S607 = sqrt(max(1.0f - _S606 * _S606, 0.0f));
    float2 _S608 = sine_cosine_0((float(_S603.index_8) + _S603.remainder_0) * (6.28318548202514648f / float(_S602)));
    float _S609 = _S607 * _S608.x;
    float _S610 = - _S607 * _S608.y;
    return float3(_S598->environment_cosine_0 * _S609 + _S598->environment_sine_0 * _S610, _S606, _S598->environment_cosine_0 * _S610 - _S598->environment_sine_0 * _S609);
}

LightSample_0 light_sample_0(int _S611, uint _S612, uint2 _S613, float3 _S614, KernelContext_0 thread* kernelContext_64)
{
    Frame_0 device* _S615 = kernelContext_64->frames_0+_S611;
    thread LightSample_0 sample_0;
    (&sample_0)->distance_1 = 1.00000001504746622e+30f;
    uint _S616 = _S615->lights_0;
    if(_S612 >= (_S615->lights_0))
    {
        uint _S617 = _S615->environment_samples_0;
        thread float3 weight_2;
        float3 _S618 = sample_environment_0(_S611, pixel_sequence_0(_S613, _S615->pass_number_0 * _S615->environment_samples_0 + (_S612 - _S616), 3U), &weight_2, kernelContext_64);
        (&sample_0)->towards_0 = _S618;
        (&sample_0)->irradiance_1 = weight_2 / float3(float(_S617)) ;
        return sample_0;
    }
    Light_0 _S619 = kernelContext_64->lights_1[_S612];
    (&sample_0)->irradiance_1 = float3(_S619.red_0, _S619.green_0, _S619.blue_0);
    (&sample_0)->towards_0 = float3(_S619.x_1, _S619.y_1, _S619.z_1);
    if((_S619.is_point_0) != 0U)
    {
        float3 _S620 = (&sample_0)->towards_0 - _S614;
        float _S621 = max(square_0(_S620), 9.999999960041972e-13f);
        (&sample_0)->distance_1 = sqrt(_S621);
        (&sample_0)->irradiance_1 = (&sample_0)->irradiance_1 / float3(_S621) ;
        (&sample_0)->towards_0 = normalize(_S620);
    }
    return sample_0;
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

void code_light_0(uint _S622, float3 _S623, float3 _S624, bool _S625, array<float, int(39)> thread* _S626, KernelContext_0 thread* kernelContext_65)
{
    (*_S626)[int(0)] = _S623.x;
    (*_S626)[int(1)] = _S623.y;
    (*_S626)[int(2)] = _S623.z;
    float3 _S627 = _S623 + _S624;
    float _S628 = _S627.z;
    float _S629 = _S628 * _S628 + 0.00009999999747379f;
    float2 _S630 = _S627.xy;
    float _S631 = 1.0f / (dot(_S630, _S630) + _S629);
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
        float3 _S632 = crown_fibres_0(_S622, family_10 == int(0), _S625, kernelContext_65);
        float2 _S633 = _S632.xy;
        (*_S626)[int(3) + family_10] = dot(_S633, _S623.xy);
        float _S634 = dot(_S633, _S630);
        float _S635 = _S634 * _S634;
        float _S636 = (0.75f * _S634 / (0.5f * sqrt(_S635 + _S629) + abs(_S634)) + 0.5f) * 8.0f;
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
            (*_S626)[int(5) + family_10 * int(16) + bin_1] = bump_0(_S636 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S637 = _S632.z;
        float _S638 = _S637 * _S637;
        float _S639 = _S635 * _S631 * (1.0f - _S638) + _S638;
        (*_S626)[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S638 * _S637 / (_S639 * _S639));
        family_10 = family_10 + int(1);
    }
    return;
}

float mixed_bundles_0(uint _S640, uint _S641, uint _S642, float3 _S643, float3 _S644, bool _S645, array<float, int(52)> thread* _S646, KernelContext_0 thread* kernelContext_66)
{
    Fabric_0 device* _S647 = kernelContext_66->fabrics_0+_S640;
    float3 _S648 = _S643 + _S644;
    float _S649 = 1.0f / (square_0(_S648) + 0.00009999999747379f);
    bool _S650;
    if(_S641 == 0U)
    {
        _S650 = _S645;
    }
    else
    {
        _S650 = false;
    }
    float _S651;
    if(_S650)
    {
        _S651 = - _S648.x;
    }
    else
    {
        _S651 = _S648.x;
    }
    if(_S641 == 1U)
    {
        _S650 = _S645;
    }
    else
    {
        _S650 = false;
    }
    float _S652;
    if(_S650)
    {
        _S652 = - _S648.y;
    }
    else
    {
        _S652 = _S648.y;
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
        uint _S653 = _S641 * 25U;
        uint _S654 = _S647->woven_0.bundles_0 + 4U * (_S653 + bundle_1);
        float _S655 = table_number_0(_S654, kernelContext_66);
        float _S656 = table_number_0(_S654 + 1U, kernelContext_66);
        float _S657 = table_number_0(_S654 + 2U, kernelContext_66);
        float _S658 = dot(float3(_S655, _S656, _S657), float3(_S651, _S652, _S648.z));
        float _S659 = _S658 * _S658 * _S649;
        float _S660 = table_number_0(_S654 + 3U, kernelContext_66);
        float _S661 = _S659 + _S660;
        uint _S662 = _S642 + _S653;
        uint _S663;
        if(_S645)
        {
            _S663 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S663 = bundle_1;
        }
        float sum_2 = sum_1 + max((*_S646)[_S662 + _S663], (*_S646)[_S662 + _S663] * 0.00999999977648258f) / (_S661 * _S661);
        bundle_1 = bundle_1 + 1U;
        sum_1 = sum_2;
    }
    return 0.01999999955296516f * sum_1;
}

Components_0 woven_components_0(uint _S664, WovenView_0 thread* _S665, float3 _S666, KernelContext_0 thread* kernelContext_67)
{
    float _S667;
    Fabric_0 device* _S668 = kernelContext_67->fabrics_0+_S664;
    bool _S669 = _S665->back_3;
    float3 _S670 = to_face_frame_0(_S666, _S665->back_3);
    float3 _S671 = _S665->view_4;
    thread HalfWeights_0 weights_24;
    Woven_0 _S672 = _S668->woven_0;
    (&weights_24)->first_2 = _S668->woven_0.network_0;
    thread array<float, int(39)> directions_0;
    code_light_0(_S664, _S670, _S665->view_4, _S665->back_3, &directions_0, kernelContext_67);
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
        skip_0[k_1] = _S665->sums_6[k_1];
        k_1 = k_1 + int(1);
    }
    thread HalfWeights_0 _S673 = weights_24;
    dense_3(&_S673, 3716U, true, &directions_0, &skip_0, kernelContext_67);
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
                _S667 = skip_0[k_1];
            }
            else
            {
                _S667 = 0.0f;
            }
            next_0[k_1] = _S667;
            k_1 = k_1 + int(1);
        }
        uint _S674 = 4208U + layer_0 * 1164U;
        thread HalfWeights_0 _S675 = weights_24;
        dense_2(&_S675, _S674, true, &hidden_1, &next_0, kernelContext_67);
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
    thread HalfWeights_0 _S676 = weights_24;
    thread array<float, int(52)> outputs_17;
    dense_1(&_S676, 7700U, false, &hidden_1, &outputs_17, kernelContext_67);
    bool _S677;
    if((_S672.is_corrected_0) != 0U)
    {
        _S677 = (_S670.z) > 0.0f;
    }
    else
    {
        _S677 = false;
    }
    if(_S677)
    {
        _S677 = (_S665->correction_weight_0) > 0.0f;
    }
    else
    {
        _S677 = false;
    }
    if(_S677)
    {
        thread FloatWeights_0 fitted_0;
        (&fitted_0)->first_0 = _S672.correction_0;
        thread FloatWeights_0 _S678 = fitted_0;
        thread array<float, int(50)> change_0;
        dense_0(&_S678, 0U, false, &hidden_1, &change_0, kernelContext_67);
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
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S665->correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S670.z) > 0.0f)
    {
        _S667 = 0.00999999977648258f;
    }
    else
    {
        _S667 = 0.00100000004749745f;
    }
    thread Components_0 result_2;
    float _S679 = unmapped_0(outputs_17[int(0)], _S667);
    (&result_2)->diffuse_warp_0 = _S679;
    float _S680 = unmapped_0(outputs_17[int(1)], _S667);
    (&result_2)->diffuse_weft_0 = _S680;
    float _S681 = 2979.9580078125f * _S667;
    float _S682 = mixed_bundles_0(_S664, 0U, 2U, _S670, _S671, _S669, &outputs_17, kernelContext_67);
    (&result_2)->specular_warp_0 = clamp(_S682, 0.0f, _S681);
    float _S683 = mixed_bundles_0(_S664, 1U, 2U, _S670, _S671, _S669, &outputs_17, kernelContext_67);
    (&result_2)->specular_weft_0 = clamp(_S683, 0.0f, _S681);
    (&result_2)->hole_2 = _S665->hole_0;
    (&result_2)->light_visibility_1 = min(light_visibility_of_0(_S679 + _S680, _S670, _S671, _S668->diffuse_blend_0), 1.0f - _S665->hole_0);
    return result_2;
}

float3 composed_0(uint _S684, const Components_0 thread* _S685, const FamilyAlbedos_0 thread* _S686, float3 _S687, float3 _S688, KernelContext_0 thread* kernelContext_68)
{
    Fabric_0 device* _S689 = kernelContext_68->fabrics_0+_S684;
    float3 _S690 = float3(_S685->diffuse_warp_0) ;
    float3 _S691 = float3(_S685->diffuse_weft_0) ;
    float3 _S692 = float3(_S685->specular_warp_0) ;
    float3 _S693 = float3(_S685->specular_weft_0) ;
    float3 _S694 = (&_S686->warp_1)->diffuse_reflect_0 * _S690 + (&_S686->weft_1)->diffuse_reflect_0 * _S691 + (&_S686->warp_1)->specular_reflect_0 * _S692 + (&_S686->weft_1)->specular_reflect_0 * _S693;
    float _S695 = _S688.z;
    float3 body_0;
    if((_S687.z * _S695) < 0.0f)
    {
        body_0 = (&_S686->warp_1)->diffuse_transmit_0 * _S690 + (&_S686->weft_1)->diffuse_transmit_0 * _S691 + (&_S686->warp_1)->specular_transmit_0 * _S692 + (&_S686->weft_1)->specular_transmit_0 * _S693;
    }
    else
    {
        body_0 = _S694;
    }
    float _S696 = _S689->sheen_strength_0;
    if((_S689->sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S697 = _S695 < 0.0f;
    float2 _S698 = sheen_with_transmittance_0(to_face_frame_0(_S687, _S697), to_face_frame_0(_S688, _S697), _S696, _S689->sheen_roughness_0);
    return float3(_S698.y)  * body_0 + float3(((_S685->light_visibility_1 + _S685->hole_2) * _S698.x)) ;
}

float4 light_of_woven_0(int _S699, uint _S700, const VisiblePoint_0 thread* _S701, uint2 _S702, float3 _S703, KernelContext_0 thread* kernelContext_69)
{
    Fabric_0 device* _S704 = kernelContext_69->fabrics_0+_S700;
    thread Footprint_0 footprint_1;
    (&footprint_1)->centre_0 = _S701->draft_0;
    (&footprint_1)->dx_0 = _S701->draft_dx_0;
    (&footprint_1)->dy_0 = _S701->draft_dy_0;
    float3 _S705 = to_local_0(_S701, _S701->view_0);
    thread Footprint_0 _S706 = footprint_1;
    thread WovenView_0 activations_0;
    woven_view_0(_S700, &_S706, _S705, &activations_0, kernelContext_69);
    float _S707 = _S705.z;
    bool _S708 = _S707 < 0.0f;
    thread Footprint_0 _S709 = footprint_1;
    FamilyAlbedos_0 _S710 = albedos_over_0(_S700, &_S709, _S708, kernelContext_69);
    thread FamilyAlbedos_0 albedos_5;
    thread Albedos_0 _S711 = _S710.warp_1;
    Albedos_0 _S712 = tinted_0(&_S711, _S703);
    (&albedos_5)->warp_1 = _S712;
    thread Albedos_0 _S713 = _S710.weft_1;
    Albedos_0 _S714 = tinted_0(&_S713, _S703);
    (&albedos_5)->weft_1 = _S714;
    float3 _S715 = float3(0.0f) ;
    uint number_4 = 0U;
    float3 radiance_1 = _S715;
    for(;;)
    {
        uint _S716 = light_sample_count_0(_S699, kernelContext_69);
        if(number_4 < _S716)
        {
        }
        else
        {
            break;
        }
        float _S717 = visibility_at_0(_S699, number_4, _S702, kernelContext_69);
        if(_S717 <= 0.0f)
        {
            number_4 = number_4 + 1U;
            continue;
        }
        LightSample_0 _S718 = light_sample_0(_S699, number_4, _S702, _S701->position_0, kernelContext_69);
        float3 _S719 = to_local_0(_S701, _S718.towards_0);
        Components_0 _S720 = woven_components_0(_S700, &activations_0, _S719, kernelContext_69);
        float3 _S721 = float3(_S717)  * _S718.irradiance_1;
        thread Components_0 _S722 = _S720;
        thread FamilyAlbedos_0 _S723 = albedos_5;
        float3 _S724 = composed_0(_S700, &_S722, &_S723, _S719, _S705, kernelContext_69);
        radiance_1 = radiance_1 + _S721 * _S724;
        number_4 = number_4 + 1U;
    }
    float hole_3 = (&activations_0)->hole_0;
    float _S725 = _S704->sheen_strength_0;
    float hole_4;
    if((_S704->sheen_strength_0) > 0.0f)
    {
        hole_4 = hole_3 * (1.0f - _S725 * sheen_lobe_0(abs(_S707), _S704->sheen_roughness_0).z);
    }
    else
    {
        hole_4 = hole_3;
    }
    return float4(radiance_1, 1.0f - hole_4);
}

[[kernel]] void shade_woven(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], Layer_0 device* layers_1 [[buffer(12)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], uint device* scene_words_1 [[buffer(11)]], packed_uint4 device* packed_numbers_1 [[buffer(10)]], uint device* words_1 [[buffer(2)]], Family_0 device* families_1 [[buffer(1)]], float device* visibilities_1 [[buffer(13)]], Light_0 device* lights_2 [[buffer(3)]], packed_float4 device* radiance_2 [[buffer(8)]])
{
    thread KernelContext_0 kernelContext_70;
    (&kernelContext_70)->frames_0 = frames_1;
    (&kernelContext_70)->layers_0 = layers_1;
    (&kernelContext_70)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_70)->fabrics_0 = fabrics_1;
    (&kernelContext_70)->corners_0 = corners_1;
    (&kernelContext_70)->vertices_0 = vertices_1;
    (&kernelContext_70)->scene_words_0 = scene_words_1;
    (&kernelContext_70)->packed_numbers_0 = packed_numbers_1;
    (&kernelContext_70)->words_0 = words_1;
    (&kernelContext_70)->families_0 = families_1;
    (&kernelContext_70)->visibilities_0 = visibilities_1;
    (&kernelContext_70)->lights_1 = lights_2;
    (&kernelContext_70)->radiance_0 = radiance_2;
    Frame_0 device* _S726 = frames_1+int(0);
    uint _S727 = id_0.x;
    uint _S728 = _S726->width_0;
    bool _S729;
    if(_S727 >= (_S726->width_0))
    {
        _S729 = true;
    }
    else
    {
        _S729 = (id_0.y) >= (_S726->height_0);
    }
    if(_S729)
    {
        return;
    }
    uint _S730 = id_0.y * _S728 + _S727;
    uint _S731 = ((&kernelContext_70)->layers_0+_S730)->face_0;
    if((((&kernelContext_70)->layers_0+_S730)->face_0) == 0U)
    {
        return;
    }
    uint _S732 = _S731 - 1U;
    uint _S733 = (&kernelContext_70)->face_fabrics_0[_S732];
    uint2 _S734 = id_0.xy;
    VisiblePoint_0 _S735 = visible_point_0(int(0), _S733, _S732, _S734, &kernelContext_70);
    thread VisiblePoint_0 _S736 = _S735;
    float3 _S737 = filtered_albedo_0(_S733, &_S736, &kernelContext_70);
    thread VisiblePoint_0 _S738 = _S735;
    float4 _S739 = light_of_woven_0(int(0), _S733, &_S738, _S734, _S737, &kernelContext_70);
    accumulate_0(_S730, _S739, &kernelContext_70);
    return;
}

