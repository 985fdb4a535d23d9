#include <slang-cuda-prelude.h>
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
    float x_0;
    float y_0;
    float z_0;
    float red_0;
    float green_0;
    float blue_0;
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

struct Vertex_0
{
    float x_1;
    float y_1;
    float z_1;
    float normal_x_0;
    float normal_y_0;
    float normal_z_0;
    float u_0;
    float v_0;
};

struct GlobalParams_0
{
    StructuredBuffer<Fabric_0> fabrics_0;
    StructuredBuffer<Family_0> families_0;
    StructuredBuffer<uint> words_0;
    StructuredBuffer<Light_0> lights_1;
    StructuredBuffer<Frame_0> frames_0;
    StructuredBuffer<Vertex_0> vertices_0;
    StructuredBuffer<uint> corners_0;
    StructuredBuffer<uint> face_fabrics_0;
    RWStructuredBuffer<float4 > radiance_0;
    RWStructuredBuffer<uint> pixels_0;
    StructuredBuffer<uint4 > packed_numbers_0;
    CUtexObject visible_faces_0;
};

extern "C" __constant__ GlobalParams_0 SLANG_globalParams;
#define globalParams_0 (&SLANG_globalParams)
struct FloatWeights_0
{
    uint first_0;
};

struct Eight_0
{
    float4  low_0;
    float4  high_0;
};

__device__ float4  asfloat_0(uint4  x_2)
{
    float4  result_0;
    int i_0 = int(0);
    for(;;)
    {
        if(i_0 < int(4))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_0, i_0) = (U32_asfloat((_slang_vector_get_element(x_2, i_0))));
        i_0 = i_0 + int(1);
    }
    return result_0;
}

__device__ Eight_0 FloatWeights_eight_0(FloatWeights_0 * this_0, uint element_0)
{
    Eight_0 numbers_0;
    uint _S1 = this_0->first_0 + 2U * element_0;
    uint4  _S2 = __ldg((&(globalParams_0->packed_numbers_0)[_S1]));
    (&numbers_0)->low_0 = asfloat_0(_S2);
    uint4  _S3 = __ldg((&(globalParams_0->packed_numbers_0)[_S1 + 1U]));
    (&numbers_0)->high_0 = asfloat_0(_S3);
    return numbers_0;
}

__device__ float dot_0(float4  x_3, float4  y_2)
{
    int i_1 = int(0);
    float result_1 = 0.0f;
    for(;;)
    {
        if(i_1 < int(4))
        {
        }
        else
        {
            break;
        }
        float result_2 = result_1 + _slang_vector_get_element(x_3, i_1) * _slang_vector_get_element(y_2, i_1);
        i_1 = i_1 + int(1);
        result_1 = result_2;
    }
    return result_1;
}

__device__ float4  tile_product_0(FloatWeights_0 * weights_0, uint row_0, FixedArray<float, 96>  * inputs_0)
{
    float4  sums_0 = make_float4 (0.0f);
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
        float4  low_1;
        float4  high_1;
        int _S4 = int(8U * column_0);
        *&((&low_1)->x) = (*inputs_0)[_S4];
        *&((&high_1)->x) = (*inputs_0)[_S4 + int(4)];
        int _S5 = _S4 + int(1);
        *&((&low_1)->y) = (*inputs_0)[_S5];
        *&((&high_1)->y) = (*inputs_0)[_S5 + int(4)];
        int _S6 = _S4 + int(2);
        *&((&low_1)->z) = (*inputs_0)[_S6];
        *&((&high_1)->z) = (*inputs_0)[_S6 + int(4)];
        int _S7 = _S4 + int(3);
        *&((&low_1)->w) = (*inputs_0)[_S7];
        *&((&high_1)->w) = (*inputs_0)[_S7 + int(4)];
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        *&((&sums_0)->x) = *&((&sums_0)->x) + (dot_0(_S8.low_0, low_1) + dot_0(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        *&((&sums_0)->y) = *&((&sums_0)->y) + (dot_0(_S9.low_0, low_1) + dot_0(_S9.high_0, high_1));
        Eight_0 _S10 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        *&((&sums_0)->z) = *&((&sums_0)->z) + (dot_0(_S10.low_0, low_1) + dot_0(_S10.high_0, high_1));
        Eight_0 _S11 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0);
        *&((&sums_0)->w) = *&((&sums_0)->w) + (dot_0(_S11.low_0, low_1) + dot_0(_S11.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
}

__device__ int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

__device__ float Identity_apply_0(float x_4)
{
    return x_4;
}

__device__ void dense_part_0(FloatWeights_0 * weights_1, uint first_1, bool adds_0, FixedArray<float, 96>  * inputs_1, FixedArray<float, 50>  * outputs_0)
{
    uint _S12 = first_1 + uint(whole_parts_0(int(7)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S13 = output_0 < int(50);
        if(_S13)
        {
        }
        else
        {
            break;
        }
        uint _S14 = uint(output_0);
        Eight_0 _S15 = FloatWeights_eight_0(weights_1, first_1 + _S14 / 8U);
        float4  _S16 = tile_product_0(weights_1, _S12 + _S14 * 12U, inputs_1);
        float4  _S17;
        if((output_0 & int(4)) != int(0))
        {
            _S17 = _S15.high_0;
        }
        else
        {
            _S17 = _S15.low_0;
        }
        float4  _S18 = _S16 + _S17;
        float _S19;
        if(_S13)
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[output_0];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[output_0] = Identity_apply_0(_S18.x + _S19);
        }
        int _S20 = output_0 + int(1);
        if(_S20 < int(50))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S20];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S20] = Identity_apply_0(_S18.y + _S19);
        }
        int _S21 = output_0 + int(2);
        if(_S21 < int(50))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S21];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S21] = Identity_apply_0(_S18.z + _S19);
        }
        int _S22 = output_0 + int(3);
        if(_S22 < int(50))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S22];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S22] = Identity_apply_0(_S18.w + _S19);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

__device__ float3  min_0(float3  x_5, float3  y_3)
{
    float3  result_3;
    int i_2 = int(0);
    for(;;)
    {
        if(i_2 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_3, i_2) = (F32_min((_slang_vector_get_element(x_5, i_2)), (_slang_vector_get_element(y_3, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_3;
}

__device__ float3  max_0(float3  x_6, float3  y_4)
{
    float3  result_4;
    int i_3 = int(0);
    for(;;)
    {
        if(i_3 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_4, i_3) = (F32_max((_slang_vector_get_element(x_6, i_3)), (_slang_vector_get_element(y_4, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_4;
}

__device__ float3  clamp_0(float3  x_7, float3  minBound_0, float3  maxBound_0)
{
    return min_0(max_0(x_7, minBound_0), maxBound_0);
}

struct HalfWeights_0
{
    uint first_2;
};

__device__ float2  f16tof32_0(uint2  value_0)
{
    float2  result_5;
    int i_4 = int(0);
    for(;;)
    {
        if(i_4 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_5, i_4) = (__half2float(__ushort_as_half((_slang_vector_get_element(value_0, i_4)))));
        i_4 = i_4 + int(1);
    }
    return result_5;
}

__device__ Eight_0 eight_halves_0(uint4  packed_0)
{
    Eight_0 numbers_1;
    uint _S23 = packed_0.x;
    uint _S24 = packed_0.y;
    (&numbers_1)->low_0 = make_float4 (f16tof32_0(make_uint2 (_S23 & 65535U, _S23 >> 16U)).x, f16tof32_0(make_uint2 (_S23 & 65535U, _S23 >> 16U)).y, f16tof32_0(make_uint2 (_S24 & 65535U, _S24 >> 16U)).x, f16tof32_0(make_uint2 (_S24 & 65535U, _S24 >> 16U)).y);
    uint _S25 = packed_0.z;
    uint _S26 = packed_0.w;
    (&numbers_1)->high_0 = make_float4 (f16tof32_0(make_uint2 (_S25 & 65535U, _S25 >> 16U)).x, f16tof32_0(make_uint2 (_S25 & 65535U, _S25 >> 16U)).y, f16tof32_0(make_uint2 (_S26 & 65535U, _S26 >> 16U)).x, f16tof32_0(make_uint2 (_S26 & 65535U, _S26 >> 16U)).y);
    return numbers_1;
}

__device__ Eight_0 HalfWeights_eight_0(HalfWeights_0 * this_1, uint element_1)
{
    uint4  _S27 = __ldg((&(globalParams_0->packed_numbers_0)[this_1->first_2 + element_1]));
    return eight_halves_0(_S27);
}

__device__ float4  tile_product_1(HalfWeights_0 * weights_2, uint row_1, FixedArray<float, 96>  * inputs_2)
{
    float4  sums_1 = make_float4 (0.0f);
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
        float4  low_2;
        float4  high_2;
        int _S28 = int(8U * column_1);
        *&((&low_2)->x) = (*inputs_2)[_S28];
        *&((&high_2)->x) = (*inputs_2)[_S28 + int(4)];
        int _S29 = _S28 + int(1);
        *&((&low_2)->y) = (*inputs_2)[_S29];
        *&((&high_2)->y) = (*inputs_2)[_S29 + int(4)];
        int _S30 = _S28 + int(2);
        *&((&low_2)->z) = (*inputs_2)[_S30];
        *&((&high_2)->z) = (*inputs_2)[_S30 + int(4)];
        int _S31 = _S28 + int(3);
        *&((&low_2)->w) = (*inputs_2)[_S31];
        *&((&high_2)->w) = (*inputs_2)[_S31 + int(4)];
        Eight_0 _S32 = HalfWeights_eight_0(weights_2, row_1 + column_1);
        *&((&sums_1)->x) = *&((&sums_1)->x) + (dot_0(_S32.low_0, low_2) + dot_0(_S32.high_0, high_2));
        Eight_0 _S33 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1);
        *&((&sums_1)->y) = *&((&sums_1)->y) + (dot_0(_S33.low_0, low_2) + dot_0(_S33.high_0, high_2));
        Eight_0 _S34 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1);
        *&((&sums_1)->z) = *&((&sums_1)->z) + (dot_0(_S34.low_0, low_2) + dot_0(_S34.high_0, high_2));
        Eight_0 _S35 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1);
        *&((&sums_1)->w) = *&((&sums_1)->w) + (dot_0(_S35.low_0, low_2) + dot_0(_S35.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
}

__device__ void dense_part_1(HalfWeights_0 * weights_3, uint first_3, bool adds_1, FixedArray<float, 96>  * inputs_3, FixedArray<float, 52>  * outputs_1)
{
    uint _S36 = first_3 + uint(whole_parts_0(int(7)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S37 = output_1 < int(52);
        if(_S37)
        {
        }
        else
        {
            break;
        }
        uint _S38 = uint(output_1);
        Eight_0 _S39 = HalfWeights_eight_0(weights_3, first_3 + _S38 / 8U);
        float4  _S40 = tile_product_1(weights_3, _S36 + _S38 * 12U, inputs_3);
        float4  _S41;
        if((output_1 & int(4)) != int(0))
        {
            _S41 = _S39.high_0;
        }
        else
        {
            _S41 = _S39.low_0;
        }
        float4  _S42 = _S40 + _S41;
        float _S43;
        if(_S37)
        {
            if(adds_1)
            {
                _S43 = (*outputs_1)[output_1];
            }
            else
            {
                _S43 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S42.x + _S43);
        }
        int _S44 = output_1 + int(1);
        if(_S44 < int(52))
        {
            if(adds_1)
            {
                _S43 = (*outputs_1)[_S44];
            }
            else
            {
                _S43 = 0.0f;
            }
            (*outputs_1)[_S44] = Identity_apply_0(_S42.y + _S43);
        }
        int _S45 = output_1 + int(2);
        if(_S45 < int(52))
        {
            if(adds_1)
            {
                _S43 = (*outputs_1)[_S45];
            }
            else
            {
                _S43 = 0.0f;
            }
            (*outputs_1)[_S45] = Identity_apply_0(_S42.z + _S43);
        }
        int _S46 = output_1 + int(3);
        if(_S46 < int(52))
        {
            if(adds_1)
            {
                _S43 = (*outputs_1)[_S46];
            }
            else
            {
                _S43 = 0.0f;
            }
            (*outputs_1)[_S46] = Identity_apply_0(_S42.w + _S43);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

__device__ float4  tile_product_2(HalfWeights_0 * weights_4, uint row_2, FixedArray<float, 39>  * inputs_4)
{
    float4  sums_2 = make_float4 (0.0f);
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
        float4  low_3;
        float4  high_3;
        int _S47 = int(8U * column_2);
        *&((&low_3)->x) = (*inputs_4)[(I32_min((_S47), (int(38))))];
        *&((&high_3)->x) = (*inputs_4)[(I32_min((_S47 + int(4)), (int(38))))];
        int _S48 = _S47 + int(1);
        *&((&low_3)->y) = (*inputs_4)[(I32_min((_S48), (int(38))))];
        *&((&high_3)->y) = (*inputs_4)[(I32_min((_S48 + int(4)), (int(38))))];
        int _S49 = _S47 + int(2);
        *&((&low_3)->z) = (*inputs_4)[(I32_min((_S49), (int(38))))];
        *&((&high_3)->z) = (*inputs_4)[(I32_min((_S49 + int(4)), (int(38))))];
        int _S50 = _S47 + int(3);
        *&((&low_3)->w) = (*inputs_4)[(I32_min((_S50), (int(38))))];
        *&((&high_3)->w) = (*inputs_4)[(I32_min((_S50 + int(4)), (int(38))))];
        Eight_0 _S51 = HalfWeights_eight_0(weights_4, row_2 + column_2);
        *&((&sums_2)->x) = *&((&sums_2)->x) + (dot_0(_S51.low_0, low_3) + dot_0(_S51.high_0, high_3));
        Eight_0 _S52 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2);
        *&((&sums_2)->y) = *&((&sums_2)->y) + (dot_0(_S52.low_0, low_3) + dot_0(_S52.high_0, high_3));
        Eight_0 _S53 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2);
        *&((&sums_2)->z) = *&((&sums_2)->z) + (dot_0(_S53.low_0, low_3) + dot_0(_S53.high_0, high_3));
        Eight_0 _S54 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2);
        *&((&sums_2)->w) = *&((&sums_2)->w) + (dot_0(_S54.low_0, low_3) + dot_0(_S54.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
}

__device__ void dense_part_2(HalfWeights_0 * weights_5, uint first_4, bool adds_2, FixedArray<float, 39>  * inputs_5, FixedArray<float, 96>  * outputs_2)
{
    uint _S55 = first_4 + uint(whole_parts_0(int(12)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S56 = output_2 < int(96);
        if(_S56)
        {
        }
        else
        {
            break;
        }
        uint _S57 = uint(output_2);
        Eight_0 _S58 = HalfWeights_eight_0(weights_5, first_4 + _S57 / 8U);
        float4  _S59 = tile_product_2(weights_5, _S55 + _S57 * 5U, inputs_5);
        float4  _S60;
        if((output_2 & int(4)) != int(0))
        {
            _S60 = _S58.high_0;
        }
        else
        {
            _S60 = _S58.low_0;
        }
        float4  _S61 = _S59 + _S60;
        float _S62;
        if(_S56)
        {
            if(adds_2)
            {
                _S62 = (*outputs_2)[output_2];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_2)[output_2] = Identity_apply_0(_S61.x + _S62);
        }
        int _S63 = output_2 + int(1);
        if(_S63 < int(96))
        {
            if(adds_2)
            {
                _S62 = (*outputs_2)[_S63];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_2)[_S63] = Identity_apply_0(_S61.y + _S62);
        }
        int _S64 = output_2 + int(2);
        if(_S64 < int(96))
        {
            if(adds_2)
            {
                _S62 = (*outputs_2)[_S64];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_2)[_S64] = Identity_apply_0(_S61.z + _S62);
        }
        int _S65 = output_2 + int(3);
        if(_S65 < int(96))
        {
            if(adds_2)
            {
                _S62 = (*outputs_2)[_S65];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_2)[_S65] = Identity_apply_0(_S61.w + _S62);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

__device__ float4  tile_product_3(HalfWeights_0 * weights_6, uint row_3, FixedArray<float, 100>  * inputs_6)
{
    float4  sums_3 = make_float4 (0.0f);
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
        float4  low_4;
        float4  high_4;
        int _S66 = int(8U * column_3);
        *&((&low_4)->x) = (*inputs_6)[(I32_min((_S66), (int(99))))];
        *&((&high_4)->x) = (*inputs_6)[(I32_min((_S66 + int(4)), (int(99))))];
        int _S67 = _S66 + int(1);
        *&((&low_4)->y) = (*inputs_6)[(I32_min((_S67), (int(99))))];
        *&((&high_4)->y) = (*inputs_6)[(I32_min((_S67 + int(4)), (int(99))))];
        int _S68 = _S66 + int(2);
        *&((&low_4)->z) = (*inputs_6)[(I32_min((_S68), (int(99))))];
        *&((&high_4)->z) = (*inputs_6)[(I32_min((_S68 + int(4)), (int(99))))];
        int _S69 = _S66 + int(3);
        *&((&low_4)->w) = (*inputs_6)[(I32_min((_S69), (int(99))))];
        *&((&high_4)->w) = (*inputs_6)[(I32_min((_S69 + int(4)), (int(99))))];
        Eight_0 _S70 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        *&((&sums_3)->x) = *&((&sums_3)->x) + (dot_0(_S70.low_0, low_4) + dot_0(_S70.high_0, high_4));
        Eight_0 _S71 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3);
        *&((&sums_3)->y) = *&((&sums_3)->y) + (dot_0(_S71.low_0, low_4) + dot_0(_S71.high_0, high_4));
        Eight_0 _S72 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3);
        *&((&sums_3)->z) = *&((&sums_3)->z) + (dot_0(_S72.low_0, low_4) + dot_0(_S72.high_0, high_4));
        Eight_0 _S73 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3);
        *&((&sums_3)->w) = *&((&sums_3)->w) + (dot_0(_S73.low_0, low_4) + dot_0(_S73.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_3;
}

__device__ void dense_part_3(HalfWeights_0 * weights_7, uint first_5, bool adds_3, FixedArray<float, 100>  * inputs_7, FixedArray<float, 96>  * outputs_3)
{
    uint _S74 = first_5 + uint(whole_parts_0(int(12)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S75 = output_3 < int(96);
        if(_S75)
        {
        }
        else
        {
            break;
        }
        uint _S76 = uint(output_3);
        Eight_0 _S77 = HalfWeights_eight_0(weights_7, first_5 + _S76 / 8U);
        float4  _S78 = tile_product_3(weights_7, _S74 + _S76 * 13U, inputs_7);
        float4  _S79;
        if((output_3 & int(4)) != int(0))
        {
            _S79 = _S77.high_0;
        }
        else
        {
            _S79 = _S77.low_0;
        }
        float4  _S80 = _S78 + _S79;
        float _S81;
        if(_S75)
        {
            if(adds_3)
            {
                _S81 = (*outputs_3)[output_3];
            }
            else
            {
                _S81 = 0.0f;
            }
            (*outputs_3)[output_3] = Identity_apply_0(_S80.x + _S81);
        }
        int _S82 = output_3 + int(1);
        if(_S82 < int(96))
        {
            if(adds_3)
            {
                _S81 = (*outputs_3)[_S82];
            }
            else
            {
                _S81 = 0.0f;
            }
            (*outputs_3)[_S82] = Identity_apply_0(_S80.y + _S81);
        }
        int _S83 = output_3 + int(2);
        if(_S83 < int(96))
        {
            if(adds_3)
            {
                _S81 = (*outputs_3)[_S83];
            }
            else
            {
                _S81 = 0.0f;
            }
            (*outputs_3)[_S83] = Identity_apply_0(_S80.z + _S81);
        }
        int _S84 = output_3 + int(3);
        if(_S84 < int(96))
        {
            if(adds_3)
            {
                _S81 = (*outputs_3)[_S84];
            }
            else
            {
                _S81 = 0.0f;
            }
            (*outputs_3)[_S84] = Identity_apply_0(_S80.w + _S81);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

__device__ float4  tile_product_4(HalfWeights_0 * weights_8, uint row_4, FixedArray<float, 16>  * inputs_8)
{
    float4  sums_4 = make_float4 (0.0f);
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
        float4  low_5;
        float4  high_5;
        int _S85 = int(8U * column_4);
        *&((&low_5)->x) = (*inputs_8)[_S85];
        *&((&high_5)->x) = (*inputs_8)[_S85 + int(4)];
        int _S86 = _S85 + int(1);
        *&((&low_5)->y) = (*inputs_8)[_S86];
        *&((&high_5)->y) = (*inputs_8)[_S86 + int(4)];
        int _S87 = _S85 + int(2);
        *&((&low_5)->z) = (*inputs_8)[_S87];
        *&((&high_5)->z) = (*inputs_8)[_S87 + int(4)];
        int _S88 = _S85 + int(3);
        *&((&low_5)->w) = (*inputs_8)[_S88];
        *&((&high_5)->w) = (*inputs_8)[_S88 + int(4)];
        Eight_0 _S89 = HalfWeights_eight_0(weights_8, row_4 + column_4);
        *&((&sums_4)->x) = *&((&sums_4)->x) + (dot_0(_S89.low_0, low_5) + dot_0(_S89.high_0, high_5));
        Eight_0 _S90 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4);
        *&((&sums_4)->y) = *&((&sums_4)->y) + (dot_0(_S90.low_0, low_5) + dot_0(_S90.high_0, high_5));
        Eight_0 _S91 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4);
        *&((&sums_4)->z) = *&((&sums_4)->z) + (dot_0(_S91.low_0, low_5) + dot_0(_S91.high_0, high_5));
        Eight_0 _S92 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4);
        *&((&sums_4)->w) = *&((&sums_4)->w) + (dot_0(_S92.low_0, low_5) + dot_0(_S92.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_4;
}

__device__ void dense_part_4(HalfWeights_0 * weights_9, uint first_6, bool adds_4, FixedArray<float, 16>  * inputs_9, FixedArray<float, 1>  * outputs_4)
{
    uint _S93 = first_6 + uint(whole_parts_0(int(1)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S94 = output_4 < int(1);
        if(_S94)
        {
        }
        else
        {
            break;
        }
        uint _S95 = uint(output_4);
        Eight_0 _S96 = HalfWeights_eight_0(weights_9, first_6 + _S95 / 8U);
        float4  _S97 = tile_product_4(weights_9, _S93 + _S95 * 2U, inputs_9);
        float4  _S98;
        if((output_4 & int(4)) != int(0))
        {
            _S98 = _S96.high_0;
        }
        else
        {
            _S98 = _S96.low_0;
        }
        float4  _S99 = _S97 + _S98;
        float _S100;
        if(_S94)
        {
            if(adds_4)
            {
                _S100 = (*outputs_4)[output_4];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_4)[output_4] = Identity_apply_0(_S99.x + _S100);
        }
        int _S101 = output_4 + int(1);
        if(_S101 < int(1))
        {
            if(adds_4)
            {
                _S100 = (*outputs_4)[_S101];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_4)[_S101] = Identity_apply_0(_S99.y + _S100);
        }
        int _S102 = output_4 + int(2);
        if(_S102 < int(1))
        {
            if(adds_4)
            {
                _S100 = (*outputs_4)[_S102];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_4)[_S102] = Identity_apply_0(_S99.z + _S100);
        }
        int _S103 = output_4 + int(3);
        if(_S103 < int(1))
        {
            if(adds_4)
            {
                _S100 = (*outputs_4)[_S103];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_4)[_S103] = Identity_apply_0(_S99.w + _S100);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

__device__ float LeakyRelu_apply_0(float x_8)
{
    return (F32_max((x_8), (x_8 * 0.00999999977648258f)));
}

__device__ void dense_part_5(HalfWeights_0 * weights_10, uint first_7, bool adds_5, FixedArray<float, 96>  * inputs_10, FixedArray<float, 96>  * outputs_5)
{
    uint _S104 = first_7 + uint(whole_parts_0(int(12)));
    int output_5 = int(0);
    for(;;)
    {
        bool _S105 = output_5 < int(96);
        if(_S105)
        {
        }
        else
        {
            break;
        }
        uint _S106 = uint(output_5);
        Eight_0 _S107 = HalfWeights_eight_0(weights_10, first_7 + _S106 / 8U);
        float4  _S108 = tile_product_1(weights_10, _S104 + _S106 * 12U, inputs_10);
        float4  _S109;
        if((output_5 & int(4)) != int(0))
        {
            _S109 = _S107.high_0;
        }
        else
        {
            _S109 = _S107.low_0;
        }
        float4  _S110 = _S108 + _S109;
        float _S111;
        if(_S105)
        {
            if(adds_5)
            {
                _S111 = (*outputs_5)[output_5];
            }
            else
            {
                _S111 = 0.0f;
            }
            (*outputs_5)[output_5] = LeakyRelu_apply_0(_S110.x + _S111);
        }
        int _S112 = output_5 + int(1);
        if(_S112 < int(96))
        {
            if(adds_5)
            {
                _S111 = (*outputs_5)[_S112];
            }
            else
            {
                _S111 = 0.0f;
            }
            (*outputs_5)[_S112] = LeakyRelu_apply_0(_S110.y + _S111);
        }
        int _S113 = output_5 + int(2);
        if(_S113 < int(96))
        {
            if(adds_5)
            {
                _S111 = (*outputs_5)[_S113];
            }
            else
            {
                _S111 = 0.0f;
            }
            (*outputs_5)[_S113] = LeakyRelu_apply_0(_S110.z + _S111);
        }
        int _S114 = output_5 + int(3);
        if(_S114 < int(96))
        {
            if(adds_5)
            {
                _S111 = (*outputs_5)[_S114];
            }
            else
            {
                _S111 = 0.0f;
            }
            (*outputs_5)[_S114] = LeakyRelu_apply_0(_S110.w + _S111);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

__device__ void dense_part_6(HalfWeights_0 * weights_11, uint first_8, bool adds_6, FixedArray<float, 100>  * inputs_11, FixedArray<float, 16>  * outputs_6)
{
    uint _S115 = first_8 + uint(whole_parts_0(int(2)));
    int output_6 = int(0);
    for(;;)
    {
        bool _S116 = output_6 < int(16);
        if(_S116)
        {
        }
        else
        {
            break;
        }
        uint _S117 = uint(output_6);
        Eight_0 _S118 = HalfWeights_eight_0(weights_11, first_8 + _S117 / 8U);
        float4  _S119 = tile_product_3(weights_11, _S115 + _S117 * 13U, inputs_11);
        float4  _S120;
        if((output_6 & int(4)) != int(0))
        {
            _S120 = _S118.high_0;
        }
        else
        {
            _S120 = _S118.low_0;
        }
        float4  _S121 = _S119 + _S120;
        float _S122;
        if(_S116)
        {
            if(adds_6)
            {
                _S122 = (*outputs_6)[output_6];
            }
            else
            {
                _S122 = 0.0f;
            }
            (*outputs_6)[output_6] = LeakyRelu_apply_0(_S121.x + _S122);
        }
        int _S123 = output_6 + int(1);
        if(_S123 < int(16))
        {
            if(adds_6)
            {
                _S122 = (*outputs_6)[_S123];
            }
            else
            {
                _S122 = 0.0f;
            }
            (*outputs_6)[_S123] = LeakyRelu_apply_0(_S121.y + _S122);
        }
        int _S124 = output_6 + int(2);
        if(_S124 < int(16))
        {
            if(adds_6)
            {
                _S122 = (*outputs_6)[_S124];
            }
            else
            {
                _S122 = 0.0f;
            }
            (*outputs_6)[_S124] = LeakyRelu_apply_0(_S121.z + _S122);
        }
        int _S125 = output_6 + int(3);
        if(_S125 < int(16))
        {
            if(adds_6)
            {
                _S122 = (*outputs_6)[_S125];
            }
            else
            {
                _S122 = 0.0f;
            }
            (*outputs_6)[_S125] = LeakyRelu_apply_0(_S121.w + _S122);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

__device__ float4  tile_product_5(HalfWeights_0 * weights_12, uint row_5, FixedArray<float, 88>  * inputs_12)
{
    float4  sums_5 = make_float4 (0.0f);
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
        float4  low_6;
        float4  high_6;
        int _S126 = int(8U * column_5);
        *&((&low_6)->x) = (*inputs_12)[_S126];
        *&((&high_6)->x) = (*inputs_12)[_S126 + int(4)];
        int _S127 = _S126 + int(1);
        *&((&low_6)->y) = (*inputs_12)[_S127];
        *&((&high_6)->y) = (*inputs_12)[_S127 + int(4)];
        int _S128 = _S126 + int(2);
        *&((&low_6)->z) = (*inputs_12)[_S128];
        *&((&high_6)->z) = (*inputs_12)[_S128 + int(4)];
        int _S129 = _S126 + int(3);
        *&((&low_6)->w) = (*inputs_12)[_S129];
        *&((&high_6)->w) = (*inputs_12)[_S129 + int(4)];
        Eight_0 _S130 = HalfWeights_eight_0(weights_12, row_5 + column_5);
        *&((&sums_5)->x) = *&((&sums_5)->x) + (dot_0(_S130.low_0, low_6) + dot_0(_S130.high_0, high_6));
        Eight_0 _S131 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5);
        *&((&sums_5)->y) = *&((&sums_5)->y) + (dot_0(_S131.low_0, low_6) + dot_0(_S131.high_0, high_6));
        Eight_0 _S132 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5);
        *&((&sums_5)->z) = *&((&sums_5)->z) + (dot_0(_S132.low_0, low_6) + dot_0(_S132.high_0, high_6));
        Eight_0 _S133 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5);
        *&((&sums_5)->w) = *&((&sums_5)->w) + (dot_0(_S133.low_0, low_6) + dot_0(_S133.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_5;
}

__device__ void dense_part_7(HalfWeights_0 * weights_13, uint first_9, bool adds_7, FixedArray<float, 88>  * inputs_13, FixedArray<float, 96>  * outputs_7)
{
    uint _S134 = first_9 + uint(whole_parts_0(int(12)));
    int output_7 = int(0);
    for(;;)
    {
        bool _S135 = output_7 < int(96);
        if(_S135)
        {
        }
        else
        {
            break;
        }
        uint _S136 = uint(output_7);
        Eight_0 _S137 = HalfWeights_eight_0(weights_13, first_9 + _S136 / 8U);
        float4  _S138 = tile_product_5(weights_13, _S134 + _S136 * 11U, inputs_13);
        float4  _S139;
        if((output_7 & int(4)) != int(0))
        {
            _S139 = _S137.high_0;
        }
        else
        {
            _S139 = _S137.low_0;
        }
        float4  _S140 = _S138 + _S139;
        float _S141;
        if(_S135)
        {
            if(adds_7)
            {
                _S141 = (*outputs_7)[output_7];
            }
            else
            {
                _S141 = 0.0f;
            }
            (*outputs_7)[output_7] = LeakyRelu_apply_0(_S140.x + _S141);
        }
        int _S142 = output_7 + int(1);
        if(_S142 < int(96))
        {
            if(adds_7)
            {
                _S141 = (*outputs_7)[_S142];
            }
            else
            {
                _S141 = 0.0f;
            }
            (*outputs_7)[_S142] = LeakyRelu_apply_0(_S140.y + _S141);
        }
        int _S143 = output_7 + int(2);
        if(_S143 < int(96))
        {
            if(adds_7)
            {
                _S141 = (*outputs_7)[_S143];
            }
            else
            {
                _S141 = 0.0f;
            }
            (*outputs_7)[_S143] = LeakyRelu_apply_0(_S140.z + _S141);
        }
        int _S144 = output_7 + int(3);
        if(_S144 < int(96))
        {
            if(adds_7)
            {
                _S141 = (*outputs_7)[_S144];
            }
            else
            {
                _S141 = 0.0f;
            }
            (*outputs_7)[_S144] = LeakyRelu_apply_0(_S140.w + _S141);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

__device__ float2  min_1(float2  x_9, float2  y_5)
{
    float2  result_6;
    int i_5 = int(0);
    for(;;)
    {
        if(i_5 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_6, i_5) = (F32_min((_slang_vector_get_element(x_9, i_5)), (_slang_vector_get_element(y_5, i_5))));
        i_5 = i_5 + int(1);
    }
    return result_6;
}

__device__ float2  max_1(float2  x_10, float2  y_6)
{
    float2  result_7;
    int i_6 = int(0);
    for(;;)
    {
        if(i_6 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_7, i_6) = (F32_max((_slang_vector_get_element(x_10, i_6)), (_slang_vector_get_element(y_6, i_6))));
        i_6 = i_6 + int(1);
    }
    return result_7;
}

__device__ float dot_1(float3  x_11, float3  y_7)
{
    int i_7 = int(0);
    float result_8 = 0.0f;
    for(;;)
    {
        if(i_7 < int(3))
        {
        }
        else
        {
            break;
        }
        float result_9 = result_8 + _slang_vector_get_element(x_11, i_7) * _slang_vector_get_element(y_7, i_7);
        i_7 = i_7 + int(1);
        result_8 = result_9;
    }
    return result_8;
}

__device__ float length_0(float3  x_12)
{
    return (F32_sqrt((dot_1(x_12, x_12))));
}

__device__ float dot_2(float2  x_13, float2  y_8)
{
    int i_8 = int(0);
    float result_10 = 0.0f;
    for(;;)
    {
        if(i_8 < int(2))
        {
        }
        else
        {
            break;
        }
        float result_11 = result_10 + _slang_vector_get_element(x_13, i_8) * _slang_vector_get_element(y_8, i_8);
        i_8 = i_8 + int(1);
        result_10 = result_11;
    }
    return result_10;
}

__device__ float clamp_1(float x_14, float minBound_1, float maxBound_1)
{
    return (F32_min(((F32_max((x_14), (minBound_1)))), (maxBound_1)));
}

__device__ float lerp_0(float x_15, float y_9, float s_0)
{
    return x_15 + (y_9 - x_15) * s_0;
}

__device__ void dense_0(FloatWeights_0 * weights_14, uint first_10, bool adds_8, FixedArray<float, 96>  * inputs_14, FixedArray<float, 50>  * outputs_8)
{
    dense_part_0(weights_14, first_10, adds_8, inputs_14, outputs_8);
    return;
}

__device__ void dense_1(HalfWeights_0 * weights_15, uint first_11, bool adds_9, FixedArray<float, 96>  * inputs_15, FixedArray<float, 52>  * outputs_9)
{
    dense_part_1(weights_15, first_11, adds_9, inputs_15, outputs_9);
    return;
}

__device__ void dense_2(HalfWeights_0 * weights_16, uint first_12, bool adds_10, FixedArray<float, 96>  * inputs_16, FixedArray<float, 96>  * outputs_10)
{
    dense_part_5(weights_16, first_12, adds_10, inputs_16, outputs_10);
    return;
}

__device__ void dense_3(HalfWeights_0 * weights_17, uint first_13, bool adds_11, FixedArray<float, 39>  * inputs_17, FixedArray<float, 96>  * outputs_11)
{
    dense_part_2(weights_17, first_13, adds_11, inputs_17, outputs_11);
    return;
}

__device__ float3  normalize_0(float3  x_16)
{
    return x_16 / make_float3 (length_0(x_16));
}

__device__ float3  saturate_0(float3  x_17)
{
    return clamp_0(x_17, make_float3 (0.0f), make_float3 (1.0f));
}

__device__ float2  sqrt_0(float2  x_18)
{
    float2  result_12;
    int i_9 = int(0);
    for(;;)
    {
        if(i_9 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_12, i_9) = (F32_sqrt((_slang_vector_get_element(x_18, i_9))));
        i_9 = i_9 + int(1);
    }
    return result_12;
}

__device__ void dense_4(HalfWeights_0 * weights_18, uint first_14, bool adds_12, FixedArray<float, 100>  * inputs_18, FixedArray<float, 96>  * outputs_12)
{
    dense_part_3(weights_18, first_14, adds_12, inputs_18, outputs_12);
    return;
}

__device__ void dense_5(HalfWeights_0 * weights_19, uint first_15, bool adds_13, FixedArray<float, 16>  * inputs_19, FixedArray<float, 1>  * outputs_13)
{
    dense_part_4(weights_19, first_15, adds_13, inputs_19, outputs_13);
    return;
}

__device__ void dense_6(HalfWeights_0 * weights_20, uint first_16, bool adds_14, FixedArray<float, 100>  * inputs_20, FixedArray<float, 16>  * outputs_14)
{
    dense_part_6(weights_20, first_16, adds_14, inputs_20, outputs_14);
    return;
}

__device__ void dense_part_8(HalfWeights_0 * weights_21, uint first_17, bool adds_15, FixedArray<float, 96>  * inputs_21, FixedArray<float, 100>  * outputs_15)
{
    uint _S145 = first_17 + uint(whole_parts_0(int(12)));
    int output_8 = int(0);
    for(;;)
    {
        bool _S146 = output_8 < int(96);
        if(_S146)
        {
        }
        else
        {
            break;
        }
        uint _S147 = uint(output_8);
        Eight_0 _S148 = HalfWeights_eight_0(weights_21, first_17 + _S147 / 8U);
        float4  _S149 = tile_product_1(weights_21, _S145 + _S147 * 12U, inputs_21);
        float4  _S150;
        if((output_8 & int(4)) != int(0))
        {
            _S150 = _S148.high_0;
        }
        else
        {
            _S150 = _S148.low_0;
        }
        float4  _S151 = _S149 + _S150;
        float _S152;
        if(_S146)
        {
            if(adds_15)
            {
                _S152 = (*outputs_15)[output_8];
            }
            else
            {
                _S152 = 0.0f;
            }
            (*outputs_15)[output_8] = LeakyRelu_apply_0(_S151.x + _S152);
        }
        int _S153 = output_8 + int(1);
        if(_S153 < int(96))
        {
            if(adds_15)
            {
                _S152 = (*outputs_15)[_S153];
            }
            else
            {
                _S152 = 0.0f;
            }
            (*outputs_15)[_S153] = LeakyRelu_apply_0(_S151.y + _S152);
        }
        int _S154 = output_8 + int(2);
        if(_S154 < int(96))
        {
            if(adds_15)
            {
                _S152 = (*outputs_15)[_S154];
            }
            else
            {
                _S152 = 0.0f;
            }
            (*outputs_15)[_S154] = LeakyRelu_apply_0(_S151.z + _S152);
        }
        int _S155 = output_8 + int(3);
        if(_S155 < int(96))
        {
            if(adds_15)
            {
                _S152 = (*outputs_15)[_S155];
            }
            else
            {
                _S152 = 0.0f;
            }
            (*outputs_15)[_S155] = LeakyRelu_apply_0(_S151.w + _S152);
        }
        output_8 = output_8 + int(4);
    }
    return;
}

__device__ void dense_7(HalfWeights_0 * weights_22, uint first_18, bool adds_16, FixedArray<float, 88>  * inputs_22, FixedArray<float, 96>  * outputs_16)
{
    dense_part_7(weights_22, first_18, adds_16, inputs_22, outputs_16);
    return;
}

__device__ float2  clamp_2(float2  x_19, float2  minBound_2, float2  maxBound_2)
{
    return min_1(max_1(x_19, minBound_2), maxBound_2);
}

__device__ bool any_0(bool2  x_20)
{
    bool result_13 = false;
    int i_10 = int(0);
    for(;;)
    {
        if(i_10 < int(2))
        {
        }
        else
        {
            break;
        }
        if(result_13)
        {
            result_13 = true;
        }
        else
        {
            result_13 = (bool((_slang_vector_get_element(x_20, i_10))));
        }
        i_10 = i_10 + int(1);
    }
    return result_13;
}

__device__ float2  lerp_1(float2  x_21, float2  y_10, float2  s_1)
{
    return x_21 + (y_10 - x_21) * s_1;
}

__device__ float2  floor_0(float2  x_22)
{
    float2  result_14;
    int i_11 = int(0);
    for(;;)
    {
        if(i_11 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_14, i_11) = (F32_floor((_slang_vector_get_element(x_22, i_11))));
        i_11 = i_11 + int(1);
    }
    return result_14;
}

__device__ float3  cross_0(float3  left_0, float3  right_0)
{
    float _S156 = left_0.y;
    float _S157 = right_0.z;
    float _S158 = left_0.z;
    float _S159 = right_0.y;
    float _S160 = right_0.x;
    float _S161 = left_0.x;
    return make_float3 (_S156 * _S157 - _S158 * _S159, _S158 * _S160 - _S161 * _S157, _S161 * _S159 - _S156 * _S160);
}

__device__ Frame_0 slang_ldg_0(Frame_0 * ptr_0)
{
    uint _S162 = __ldg(&ptr_0->width_0);
    uint _S163 = __ldg(&ptr_0->height_0);
    uint _S164 = __ldg(&ptr_0->lights_0);
    uint _S165 = __ldg(&ptr_0->samples_0);
    uint _S166 = __ldg(&ptr_0->pass_number_0);
    float _S167 = __ldg(&ptr_0->jitter_x_0);
    float _S168 = __ldg(&ptr_0->jitter_y_0);
    float _S169 = __ldg(&ptr_0->gain_0);
    float _S170 = __ldg(&ptr_0->origin_x_0);
    float _S171 = __ldg(&ptr_0->origin_y_0);
    float _S172 = __ldg(&ptr_0->origin_z_0);
    float _S173 = __ldg(&ptr_0->right_x_0);
    float _S174 = __ldg(&ptr_0->right_y_0);
    float _S175 = __ldg(&ptr_0->right_z_0);
    float _S176 = __ldg(&ptr_0->up_x_0);
    float _S177 = __ldg(&ptr_0->up_y_0);
    float _S178 = __ldg(&ptr_0->up_z_0);
    float _S179 = __ldg(&ptr_0->forward_x_0);
    float _S180 = __ldg(&ptr_0->forward_y_0);
    float _S181 = __ldg(&ptr_0->forward_z_0);
    float _S182 = __ldg(&ptr_0->near_0);
    float _S183 = __ldg(&ptr_0->background_red_0);
    float _S184 = __ldg(&ptr_0->background_green_0);
    float _S185 = __ldg(&ptr_0->background_blue_0);
    Frame_0 _S186 = { _S162, _S163, _S164, _S165, _S166, _S167, _S168, _S169, _S170, _S171, _S172, _S173, _S174, _S175, _S176, _S177, _S178, _S179, _S180, _S181, _S182, _S183, _S184, _S185 };
    return _S186;
}

__device__ Woven_0 slang_ldg_1(Woven_0 * ptr_1)
{
    uint _S187 = __ldg(&ptr_1->is_encoded_0);
    uint _S188 = __ldg(&ptr_1->network_0);
    uint _S189 = __ldg(&ptr_1->latents_0);
    uint _S190 = __ldg(&ptr_1->texels_0);
    uint _S191 = __ldg(&ptr_1->levels_1);
    uint _S192 = __ldg(&ptr_1->top_level_0);
    float _S193 = __ldg(&ptr_1->ends_0);
    float _S194 = __ldg(&ptr_1->picks_0);
    float _S195 = __ldg(&ptr_1->ends_per_mm_0);
    float _S196 = __ldg(&ptr_1->picks_per_mm_0);
    float _S197 = __ldg(&ptr_1->pitch_0);
    float _S198 = __ldg(&ptr_1->warp_x_0);
    float _S199 = __ldg(&ptr_1->warp_y_0);
    float _S200 = __ldg(&ptr_1->warp_roughness_0);
    float _S201 = __ldg(&ptr_1->weft_x_0);
    float _S202 = __ldg(&ptr_1->weft_y_0);
    float _S203 = __ldg(&ptr_1->weft_roughness_0);
    float _S204 = __ldg(&ptr_1->warp_lobe_roughness_0);
    float _S205 = __ldg(&ptr_1->weft_lobe_roughness_0);
    uint _S206 = __ldg(&ptr_1->bundles_0);
    uint _S207 = __ldg(&ptr_1->is_corrected_0);
    uint _S208 = __ldg(&ptr_1->correction_0);
    Woven_0 _S209 = { _S187, _S188, _S189, _S190, _S191, _S192, _S193, _S194, _S195, _S196, _S197, _S198, _S199, _S200, _S201, _S202, _S203, _S204, _S205, _S206, _S207, _S208 };
    return _S209;
}

__device__ Vertex_0 slang_ldg_2(Vertex_0 * ptr_2)
{
    float _S210 = __ldg(&ptr_2->x_1);
    float _S211 = __ldg(&ptr_2->y_1);
    float _S212 = __ldg(&ptr_2->z_1);
    float _S213 = __ldg(&ptr_2->normal_x_0);
    float _S214 = __ldg(&ptr_2->normal_y_0);
    float _S215 = __ldg(&ptr_2->normal_z_0);
    float _S216 = __ldg(&ptr_2->u_0);
    float _S217 = __ldg(&ptr_2->v_0);
    Vertex_0 _S218 = { _S210, _S211, _S212, _S213, _S214, _S215, _S216, _S217 };
    return _S218;
}

__device__ float3  position_of_0(Vertex_0 * vertex_0)
{
    return make_float3 (vertex_0->x_1, vertex_0->y_1, vertex_0->z_1);
}

__device__ float square_0(float3  v_1)
{
    return dot_1(v_1, v_1);
}

__device__ float3  camera_right_0(Frame_0 * frame_0)
{
    return make_float3 (frame_0->right_x_0, frame_0->right_y_0, frame_0->right_z_0);
}

__device__ float3  camera_up_0(Frame_0 * frame_1)
{
    return make_float3 (frame_1->up_x_0, frame_1->up_y_0, frame_1->up_z_0);
}

__device__ float3  camera_forward_0(Frame_0 * frame_2)
{
    return make_float3 (frame_2->forward_x_0, frame_2->forward_y_0, frame_2->forward_z_0);
}

__device__ float3  camera_origin_0(Frame_0 * frame_3)
{
    return make_float3 (frame_3->origin_x_0, frame_3->origin_y_0, frame_3->origin_z_0);
}

__device__ float3  normal_of_0(Vertex_0 * vertex_1)
{
    return make_float3 (vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

struct VisiblePoint_0
{
    float3  position_0;
    float3  view_0;
    float3  axis_x_0;
    float3  axis_y_0;
    float3  normal_0;
    float2  draft_0;
    float2  draft_dx_0;
    float2  draft_dy_0;
};

__device__ float3  to_local_0(VisiblePoint_0 * point_0, float3  direction_0)
{
    return make_float3 (dot_1(direction_0, point_0->axis_x_0), dot_1(direction_0, point_0->axis_y_0), dot_1(direction_0, point_0->normal_0));
}

__device__ float square_1(float x_23)
{
    return x_23 * x_23;
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

__device__ float3  row_of_taps_0(Footprint_0 * footprint_0)
{
    float _S219 = footprint_0->dx_0.x;
    float _S220 = footprint_0->dy_0.x;
    float _S221 = _S219 * _S219 + _S220 * _S220;
    float _S222 = footprint_0->dx_0.y;
    float _S223 = footprint_0->dy_0.y;
    float _S224 = _S222 * _S222 + _S223 * _S223;
    float _S225 = _S219 * _S222 + _S220 * _S223;
    float _S226 = 0.5f * (_S221 - _S224);
    float _S227 = 0.5f * (_S221 + _S224);
    float _S228 = (F32_sqrt((_S226 * _S226 + _S225 * _S225)));
    float _S229 = _S227 + _S228;
    float _S230 = (F32_max((_S229 - 1.5f * (F32_max((_S227 - _S228), (0.0f)))), (0.0f)));
    float _S231 = square_1(4.0f);
    float _S232 = (F32_max((_S227 - 0.5f * _S230), (_S229 / _S231)));
    float _S233 = (F32_sqrt(((F32_max(((F32_min((_S230), (_S229 - _S232)))), (0.0f))) / (_S231 - 1.0f))));
    float _S234 = _S226 / (F32_max((_S228), (1.00000000317107685e-30f)));
    float _S235 = (F32_sqrt(((F32_max((0.5f * (1.0f - _S234)), (0.0f))))));
    float _S236 = (F32_sqrt((_S232)));
    float _S237 = _S233 * (F32_sqrt(((F32_max((0.5f * (1.0f + _S234)), (0.0f))))));
    float _S238;
    if(_S225 < 0.0f)
    {
        _S238 = - _S233 * _S235;
    }
    else
    {
        _S238 = _S233 * _S235;
    }
    return make_float3 (_S236, _S237, _S238);
}

struct AnisotropicTaps_0
{
    float2  centre_1;
    float side_0;
    float2  first_19;
    float2  second_0;
};

__device__ float AnisotropicTaps_size_0(AnisotropicTaps_0 * this_2)
{
    float _S239 = this_2->first_19.x;
    float _S240 = this_2->second_0.x;
    float _S241 = this_2->side_0 * this_2->side_0;
    float _S242 = this_2->first_19.y;
    float _S243 = this_2->second_0.y;
    float _S244 = 12.0f * (_S239 * _S242 + _S240 * _S243);
    return (F32_sqrt(((F32_sqrt(((F32_max(((12.0f * (_S239 * _S239 + _S240 * _S240) + _S241) * (12.0f * (_S242 * _S242 + _S243 * _S243) + _S241) - _S244 * _S244), (square_1(_S241))))))))));
}

__device__ float natural_logarithm_0(float x_24)
{
    uint _S245 = (F32_asuint((x_24)));
    float exponent_0 = float(int(_S245 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S245 & 8388607U) | 1056964608U)));
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
    float _S246 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S246 - exponent_1 * 0.00021219444170129f - 0.5f * _S246) + exponent_1 * 0.693359375f;
}

__device__ float3  footprint_coordinates_0(AnisotropicTaps_0 * taps_0)
{
    float _S247 = AnisotropicTaps_size_0(taps_0);
    return make_float3 ((taps_0->centre_1 - floor_0(taps_0->centre_1)).x, (taps_0->centre_1 - floor_0(taps_0->centre_1)).y, clamp_1(natural_logarithm_0((F32_max((_S247), (9.99999997475242708e-07f))) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

__device__ float3  to_face_frame_0(float3  direction_1, bool back_0)
{
    float2  _S248 = float2 {direction_1.x, direction_1.y};
    float _S249;
    if(back_0)
    {
        _S249 = - direction_1.z;
    }
    else
    {
        _S249 = direction_1.z;
    }
    return make_float3 (_S248.x, _S248.y, _S249);
}

__device__ float table_number_0(uint index_0)
{
    uint _S250 = __ldg((&(globalParams_0->words_0)[index_0]));
    return (U32_asfloat((_S250)));
}

__device__ float wrapped_0(float index_1, float count_1)
{
    float _S251;
    if(index_1 < 0.0f)
    {
        _S251 = index_1 + count_1;
    }
    else
    {
        if(index_1 >= count_1)
        {
            _S251 = index_1 - count_1;
        }
        else
        {
            _S251 = index_1;
        }
    }
    return _S251;
}

__device__ float binary_logarithm_0(float x_25)
{
    return natural_logarithm_0(x_25) * 1.4426950216293335f;
}

__device__ bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 * this_3)
{
    float2  _S252 = make_float2 (0.0f);
    bool _S253;
    if(any_0((this_3->first_19) != _S252))
    {
        _S253 = true;
    }
    else
    {
        _S253 = any_0((this_3->second_0) != _S252);
    }
    return _S253;
}

__device__ float2  AnisotropicTaps_place_0(AnisotropicTaps_0 * this_4, uint number_0)
{
    float _S254;
    if(number_0 >= 2U)
    {
        _S254 = 1.0f;
    }
    else
    {
        _S254 = -1.0f;
    }
    float _S255;
    if((number_0 & 1U) != 0U)
    {
        _S255 = 1.0f;
    }
    else
    {
        _S255 = -1.0f;
    }
    return this_4->centre_1 + make_float2 (_S254) * this_4->first_19 + make_float2 (_S255) * this_4->second_0;
}

__device__ float bump_0(float distance_0)
{
    float _S256 = (F32_max((1.0f - distance_0 * distance_0), (0.0f)));
    return _S256 * _S256;
}

__device__ float correction_weight_of_0(float coded_size_0)
{
    return clamp_1((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

__device__ Family_0 slang_ldg_3(Family_0 * ptr_3)
{
    uint _S257 = __ldg(&ptr_3->is_alike_0);
    float _S258 = __ldg(&ptr_3->count_0);
    float _S259 = __ldg(&ptr_3->inverse_count_0);
    float _S260 = __ldg(&ptr_3->half_inverse_count_0);
    float _S261 = __ldg(&ptr_3->size_0);
    float _S262 = __ldg(&ptr_3->inverse_size_0);
    float _S263 = __ldg(&ptr_3->half_width_0);
    float _S264 = __ldg(&ptr_3->start_0);
    float _S265 = __ldg(&ptr_3->period_0);
    float _S266 = __ldg(&ptr_3->inverse_period_0);
    float _S267 = __ldg(&ptr_3->bins_0);
    uint _S268 = __ldg(&ptr_3->first_thread_table_0);
    uint _S269 = __ldg(&ptr_3->place_table_0);
    uint _S270 = __ldg(&ptr_3->bend_table_0);
    float _S271 = __ldg(&ptr_3->height_scale_0);
    float _S272 = __ldg(&ptr_3->twist_sine_0);
    float _S273 = __ldg(&ptr_3->twist_cosine_0);
    float _S274 = __ldg(&ptr_3->level_0);
    float _S275 = __ldg(&ptr_3->roughness_0);
    uint _S276 = __ldg(&ptr_3->albedo_table_0);
    uint _S277 = __ldg(&ptr_3->albedo_stride_0);
    uint _S278 = __ldg(&ptr_3->before_0);
    float _S279 = __ldg(&ptr_3->visible_total_0);
    float _S280 = __ldg(&ptr_3->smallest_box_0);
    uint _S281 = __ldg(&ptr_3->quantities_0);
    uint _S282 = __ldg(&ptr_3->colour_mean_0);
    uint _S283 = __ldg(&ptr_3->colour_axes_0);
    uint _S284 = __ldg(&ptr_3->colour_threads_0);
    uint _S285 = __ldg(&ptr_3->colour_areas_0);
    float _S286 = __ldg(&ptr_3->area_unit_0);
    float _S287 = __ldg(&ptr_3->crossing_area_0);
    Family_0 _S288 = { _S257, _S258, _S259, _S260, _S261, _S262, _S263, _S264, _S265, _S266, _S267, _S268, _S269, _S270, _S271, _S272, _S273, _S274, _S275, _S276, _S277, _S278, _S279, _S280, _S281, _S282, _S283, _S284, _S285, _S286, _S287 };
    return _S288;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_2)
{
    Family_0 _S289 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    Family_0 _S290 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    float _S291 = (F32_floor(((F32_fma((index_2), (_S289.inverse_count_0), (_S290.half_inverse_count_0))))));
    float _S292 = - _S291;
    Family_0 _S293 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S291, (F32_fma((_S292), (_S293.count_0), (index_2))));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_1)
{
    Family_0 _S294 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    float _S295 = (F32_floor((position_1 * _S294.inverse_size_0)));
    Cell_0 cell_0;
    float _S296 = - _S295;
    Family_0 _S297 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    float _S298 = (F32_fma((_S296), (_S297.size_0), (position_1)));
    (&cell_0)->below_0 = _S298;
    Family_0 _S299 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->above_0 = _S299.size_0 - _S298;
    Family_0 _S300 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->across_0 = _S298 - 0.5f * _S300.size_0;
    Family_0 _S301 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->half_width_1 = _S301.half_width_0;
    float _S302 = turns_and_remainder_0(family_1, _S295).y;
    Family_0 _S303 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->thread_0 = uint(clamp_1(_S302, 0.0f, _S303.count_0 - 1.0f));
    return cell_0;
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_2)
{
    Family_0 _S304 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S305 = position_2 - _S304.start_0;
    Family_0 _S306 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S305 * _S306.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S307 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S308 = turns_1 * _S307.period_0;
    Family_0 _S309 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S310 = turns_1 * _S309.bins_0;
    Family_0 _S311 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S312 = uint(clamp_1(_S310, 0.0f, _S311.bins_0 - 1.0f));
    Family_0 _S313 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S314 = __ldg((&(globalParams_0->words_0)[_S313.first_thread_table_0 + _S312]));
    Family_0 _S315 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S316;
    if(_S308 >= (table_number_0(_S315.place_table_0 + _S314 * 4U + 1U)))
    {
        _S316 = 1U;
    }
    else
    {
        _S316 = 0U;
    }
    uint _S317 = _S314 + _S316;
    Family_0 _S318 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S319 = (U32_min((_S317), (uint(_S318.count_0) - 1U)));
    Family_0 _S320 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S321 = _S320.place_table_0 + _S319 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S319;
    (&cell_1)->below_0 = _S308 - table_number_0(_S321);
    (&cell_1)->above_0 = table_number_0(_S321 + 1U) - _S308;
    (&cell_1)->across_0 = _S308 - table_number_0(_S321 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S321 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_3)
{
    Family_0 _S322 = slang_ldg_3((&(globalParams_0->families_0)[family_3]));
    if((_S322.is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct Bound_0
{
    uint thread_1;
    float turns_2;
    float cell_2;
    float visible_0;
    float width_1;
    float gap_0;
};

__device__ Bound_0 bound_at_0(uint family_4, float position_4)
{
    Cell_0 _S323 = locate_0(family_4, position_4);
    Family_0 _S324 = slang_ldg_3((&(globalParams_0->families_0)[family_4]));
    float _S325 = table_number_0(_S324.before_0 + 2U * _S323.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_1 = _S323.thread_0;
    Family_0 _S326 = slang_ldg_3((&(globalParams_0->families_0)[family_4]));
    float _S327 = position_4 - _S326.start_0 - _S325 - _S323.below_0;
    Family_0 _S328 = slang_ldg_3((&(globalParams_0->families_0)[family_4]));
    (&bound_0)->turns_2 = (F32_round((_S327 * _S328.inverse_period_0)));
    (&bound_0)->cell_2 = _S323.below_0;
    float _S329 = 2.0f * _S323.half_width_1;
    (&bound_0)->width_1 = _S329;
    (&bound_0)->visible_0 = clamp_1((_S323.across_0 + _S323.half_width_1) / _S329, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S323.below_0), (_S323.below_0 - _S323.across_0 - _S323.half_width_1))) + (F32_max((_S323.across_0 - _S323.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

__device__ Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    Family_0 _S330 = slang_ldg_3((&(globalParams_0->families_0)[family_5]));
    float _S331 = centre_2 - _S330.start_0;
    Family_0 _S332 = slang_ldg_3((&(globalParams_0->families_0)[family_5]));
    float _S333 = (F32_floor((_S331 * _S332.inverse_period_0)));
    Family_0 _S334 = slang_ldg_3((&(globalParams_0->families_0)[family_5]));
    float _S335 = centre_2 - _S333 * _S334.period_0;
    Family_0 _S336 = slang_ldg_3((&(globalParams_0->families_0)[family_5]));
    float _S337 = 0.5f * (F32_max((size_1), (_S336.smallest_box_0)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_7 = bound_at_0(family_5, _S335 - _S337);
    (&stretch_0)->high_7 = bound_at_0(family_5, _S335 + _S337);
    return stretch_0;
}

__device__ float3  table_colour_0(uint index_3)
{
    return make_float3 (table_number_0(index_3), table_number_0(index_3 + 1U), table_number_0(index_3 + 2U));
}

struct Albedos_0
{
    float3  diffuse_reflect_0;
    float3  diffuse_transmit_0;
    float3  specular_reflect_0;
    float3  specular_transmit_0;
};

__device__ Albedos_0 table_albedos_0(uint row_6)
{
    Albedos_0 albedos_0;
    (&albedos_0)->diffuse_reflect_0 = table_colour_0(row_6);
    (&albedos_0)->diffuse_transmit_0 = table_colour_0(row_6 + 3U);
    (&albedos_0)->specular_reflect_0 = table_colour_0(row_6 + 6U);
    (&albedos_0)->specular_transmit_0 = table_colour_0(row_6 + 9U);
    return albedos_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_5)
{
    return (&this_5->high_7)->turns_2 - (&this_5->low_7)->turns_2;
}

__device__ float3  lengths_0(uint family_6, Stretch_0 * stretch_1)
{
    float _S338 = Stretch_turns_0(stretch_1);
    Family_0 _S339 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    uint _S340 = _S339.before_0 + 2U * (&stretch_1->low_7)->thread_1;
    Family_0 _S341 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    uint _S342 = _S341.before_0 + 2U * (&stretch_1->high_7)->thread_1;
    float _S343 = table_number_0(_S342) - table_number_0(_S340);
    float _S344 = table_number_0(_S342 + 1U) - table_number_0(_S340 + 1U);
    float _S345 = _S343 + (&stretch_1->high_7)->visible_0 * (&stretch_1->high_7)->width_1 - (&stretch_1->low_7)->visible_0 * (&stretch_1->low_7)->width_1;
    Family_0 _S346 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    float _S347 = _S345 + _S338 * _S346.visible_total_0;
    float _S348 = _S344 - _S343 + (&stretch_1->high_7)->gap_0 - (&stretch_1->low_7)->gap_0;
    Family_0 _S349 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    Family_0 _S350 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    float _S351 = _S348 + _S338 * (_S349.period_0 - _S350.visible_total_0);
    float _S352 = _S344 + (&stretch_1->high_7)->cell_2 - (&stretch_1->low_7)->cell_2;
    Family_0 _S353 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    return make_float3 (_S347, _S351, _S352 + _S338 * _S353.period_0);
}

__device__ float2  integrals_along_0(uint family_7, Stretch_0 * stretch_2, uint quantity_0)
{
    Family_0 _S354 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    Family_0 _S355 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    uint _S356 = 3U * _S354.quantities_0;
    uint _S357 = _S355.colour_threads_0 + _S356 * (&stretch_2->low_7)->thread_1 + quantity_0;
    Family_0 _S358 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    uint _S359 = _S358.colour_threads_0 + _S356 * (&stretch_2->high_7)->thread_1 + quantity_0;
    Family_0 _S360 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    Family_0 _S361 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    uint _S362 = _S360.colour_threads_0 + _S356 * uint(_S361.count_0) + quantity_0;
    float _S363 = table_number_0(_S357);
    float _S364 = table_number_0(_S359);
    float _S365 = Stretch_turns_0(stretch_2);
    uint _S366 = 2U * _S354.quantities_0;
    return make_float2 (table_number_0(_S359 + _S354.quantities_0) - table_number_0(_S357 + _S354.quantities_0) + _S364 * (&stretch_2->high_7)->visible_0 * (&stretch_2->high_7)->width_1 - _S363 * (&stretch_2->low_7)->visible_0 * (&stretch_2->low_7)->width_1 + _S365 * table_number_0(_S362 + _S354.quantities_0), table_number_0(_S359 + _S366) - table_number_0(_S357 + _S366) + _S364 * (&stretch_2->high_7)->cell_2 - _S363 * (&stretch_2->low_7)->cell_2 + _S365 * table_number_0(_S362 + _S366));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_6)
{
    return ((&this_6->high_7)->thread_1) < ((&this_6->low_7)->thread_1);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_7, uint4  entries_0, uint whole_0)
{
    uint _S367 = entries_0.z;
    uint _S368 = entries_0.x;
    uint _S369 = _S367 - _S368;
    bool _S370 = Stretch_wraps_0(this_7);
    uint _S371;
    if(_S370)
    {
        _S371 = whole_0;
    }
    else
    {
        _S371 = 0U;
    }
    return make_uint4 (_S369 + _S371, entries_0.w - _S367, entries_0.y - _S368, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S372 = row_7 + (&across_1->low_7)->thread_1 * quantities_1;
    uint _S373 = row_7 + (&across_1->high_7)->thread_1 * quantities_1;
    uint _S374 = __ldg((&(globalParams_0->words_0)[_S372]));
    uint _S375 = __ldg((&(globalParams_0->words_0)[_S372 + quantities_1]));
    uint _S376 = __ldg((&(globalParams_0->words_0)[_S373]));
    uint _S377 = __ldg((&(globalParams_0->words_0)[_S373 + quantities_1]));
    uint4  _S378 = make_uint4 (_S374, _S375, _S376, _S377);
    uint _S379 = __ldg((&(globalParams_0->words_0)[row_7 + count_2 * quantities_1]));
    uint4  _S380 = Stretch_differences_0(across_1, _S378, _S379);
    return _S380;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_8)
{
    float _S381 = (&this_8->high_7)->visible_0;
    float _S382 = - (&this_8->low_7)->visible_0;
    float _S383 = Stretch_turns_0(this_8);
    bool _S384 = Stretch_wraps_0(this_8);
    float _S385;
    if(_S384)
    {
        _S385 = 1.0f;
    }
    else
    {
        _S385 = 0.0f;
    }
    return make_float4 (1.0f, _S381, _S382, _S383 - _S385);
}

__device__ float integral_on_top_0(uint family_8, Stretch_0 * across_2, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    Family_0 _S386 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    uint _S387 = uint(_S386.count_0);
    uint _S388 = _S387 + 1U;
    Family_0 _S389 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    uint _S390 = _S388 * _S389.quantities_0;
    Family_0 _S391 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    uint _S392 = _S391.colour_areas_0 + quantity_1;
    uint _S393 = (&along_0->low_7)->thread_1;
    uint _S394 = _S392 + (&along_0->low_7)->thread_1 * _S390;
    Family_0 _S395 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    uint4  _S396 = row_differences_0(across_2, _S394, _S387, _S395.quantities_0);
    uint _S397 = _S392 + (_S393 + 1U) * _S390;
    Family_0 _S398 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    uint4  _S399 = row_differences_0(across_2, _S397, _S387, _S398.quantities_0);
    uint _S400 = (&along_0->high_7)->thread_1;
    uint _S401 = _S392 + (&along_0->high_7)->thread_1 * _S390;
    Family_0 _S402 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    uint4  _S403 = row_differences_0(across_2, _S401, _S387, _S402.quantities_0);
    uint _S404 = _S392 + (_S400 + 1U) * _S390;
    Family_0 _S405 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    uint4  _S406 = row_differences_0(across_2, _S404, _S387, _S405.quantities_0);
    uint _S407 = _S392 + crossing_count_0 * _S390;
    Family_0 _S408 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    uint4  _S409 = row_differences_0(across_2, _S407, _S387, _S408.quantities_0);
    uint4  _S410 = _S403 - _S396;
    bool _S411 = Stretch_wraps_0(along_0);
    uint4  _S412;
    if(_S411)
    {
        _S412 = _S409;
    }
    else
    {
        int4  _S413 = make_int4 (int(0));
        uint4  _S414 = make_uint4 ((uint)_S413.x, (uint)_S413.y, (uint)_S413.z, (uint)_S413.w);
        _S412 = _S414;
    }
    uint4  _S415 = _S410 + _S412;
    float4  _S416 = Stretch_weights_0(across_2);
    float4  _S417 = Stretch_weights_0(along_0);
    int4  _S418 = make_int4 ((int)_S415.x, (int)_S415.y, (int)_S415.z, (int)_S415.w);
    float4  _S419 = make_float4 ((float)_S418.x, (float)_S418.y, (float)_S418.z, (float)_S418.w);
    uint4  _S420 = _S406 - _S403;
    int4  _S421 = make_int4 ((int)_S420.x, (int)_S420.y, (int)_S420.z, (int)_S420.w);
    float4  _S422 = make_float4 ((float)_S421.x, (float)_S421.y, (float)_S421.z, (float)_S421.w);
    uint4  _S423 = _S399 - _S396;
    int4  _S424 = make_int4 ((int)_S423.x, (int)_S423.y, (int)_S423.z, (int)_S423.w);
    float4  _S425 = make_float4 ((float)_S424.x, (float)_S424.y, (float)_S424.z, (float)_S424.w);
    int4  _S426 = make_int4 ((int)_S409.x, (int)_S409.y, (int)_S409.z, (int)_S409.w);
    float4  _S427 = make_float4 ((float)_S426.x, (float)_S426.y, (float)_S426.z, (float)_S426.w);
    float _S428 = dot_0(make_float4 (dot_0(_S419, _S416), dot_0(_S422, _S416), dot_0(_S425, _S416), dot_0(_S427, _S416)), _S417);
    Family_0 _S429 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    return _S428 * _S429.area_unit_0;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S430 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_0) * _S430.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_0) * _S430.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_0) * _S430.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_0) * _S430.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 * own_0, Stretch_0 * other_0, bool back_1)
{
    Family_0 _S431 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
    Albedos_0 albedos_2 = table_albedos_0(_S431.colour_mean_0);
    Family_0 _S432 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
    if((_S432.quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3  _S433 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        Family_0 _S434 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
        if(quantity_2 < (_S434.quantities_0))
        {
        }
        else
        {
            break;
        }
        float2  _S435 = integrals_along_0(family_9, own_0, quantity_2);
        Family_0 _S436 = slang_ldg_3((&(globalParams_0->families_0)[crossing_0]));
        float _S437 = integral_on_top_0(family_9, own_0, other_0, uint(_S436.count_0), quantity_2);
        float _S438 = _S435.x;
        float _S439 = _S438 * _S433.x;
        float _S440;
        if(back_1)
        {
            _S440 = _S439 - _S437;
        }
        else
        {
            _S440 = _S437;
        }
        bool _S441 = quantity_2 == 0U;
        if(_S441)
        {
            Family_0 _S442 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
            float _S443 = 16.0f * _S442.area_unit_0;
            Family_0 _S444 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
            is_exposed_0 = _S440 > (_S443 * (F32_min((_S439 / _S444.crossing_area_0), (1.0f))) + 0.00000999999974738f * _S439);
        }
        float _S445 = _S438 * _S433.y;
        float _S446;
        if(is_exposed_0)
        {
            _S446 = _S440;
        }
        else
        {
            _S446 = 0.0f;
        }
        float _S447 = _S445 + _S446 + 0.000244140625f * _S433.z * _S435.y;
        if(_S441)
        {
            weight_1 = 1.0f / (F32_max((_S447), (9.99999968265522539e-21f)));
        }
        else
        {
            float _S448 = _S447 * weight_1;
            Family_0 _S449 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
            uint _S450 = _S449.colour_axes_0 + 12U * (quantity_2 - 1U);
            Albedos_0 _S451 = albedos_2;
            Albedos_0 _S452 = with_added_albedos_0(&_S451, _S448, _S450);
            albedos_2 = _S452;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate_0((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate_0((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate_0((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate_0((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

__device__ Light_0 slang_ldg_4(Light_0 * ptr_4)
{
    uint _S453 = __ldg(&ptr_4->is_point_0);
    float _S454 = __ldg(&ptr_4->x_0);
    float _S455 = __ldg(&ptr_4->y_0);
    float _S456 = __ldg(&ptr_4->z_0);
    float _S457 = __ldg(&ptr_4->red_0);
    float _S458 = __ldg(&ptr_4->green_0);
    float _S459 = __ldg(&ptr_4->blue_0);
    Light_0 _S460 = { _S453, _S454, _S455, _S456, _S457, _S458, _S459 };
    return _S460;
}

__device__ float3  towards_light_0(Light_0 * light_0, float3  position_5, float3  * irradiance_1)
{
    *irradiance_1 = make_float3 (light_0->red_0, light_0->green_0, light_0->blue_0);
    float3  _S461 = make_float3 (light_0->x_0, light_0->y_0, light_0->z_0);
    if((light_0->is_point_0) == 0U)
    {
        return _S461;
    }
    float3  _S462 = _S461 - position_5;
    *irradiance_1 = *irradiance_1 / make_float3 ((F32_max((square_0(_S462)), (9.999999960041972e-13f))));
    return normalize_0(_S462);
}

__device__ float exponential_0(float x_26)
{
    float _S463 = clamp_1(x_26, -87.0f, 88.0f);
    float _S464 = (F32_floor((_S463 * 1.4426950216293335f + 0.5f)));
    float _S465 = _S463 - _S464 * 0.693359375f + _S464 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S465 + 0.00139819993637502f) * _S465 + 0.00833345204591751f) * _S465 + 0.04166579619050026f) * _S465 + 0.1666666567325592f) * _S465 + 0.5f;
    float _S466 = (U32_asfloat((uint(int(_S464) + int(127)) << int(23))));
    float _S467;
    if(x_26 < -87.0f)
    {
        _S467 = 0.0f;
    }
    else
    {
        _S467 = (p_0 * _S465 * _S465 + _S465 + 1.0f) * _S466;
    }
    return _S467;
}

__device__ float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp_1(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

__device__ uint mirrored_bundle_0(uint bundle_0)
{
    uint _S468 = bundle_0 / 3U;
    uint _S469 = bundle_0 % 3U;
    uint _S470;
    if(bundle_0 == 24U)
    {
        _S470 = bundle_0;
    }
    else
    {
        _S470 = _S468 * 3U + 3U - 1U - _S469;
    }
    return _S470;
}

__device__ float light_visibility_of_0(float diffuse_0, float3  light_1, float3  view_1, float blend_0)
{
    float _S471 = (F32_max(((F32_abs((light_1.z)))), (0.00100000004749745f)));
    float2  _S472 = float2 {light_1.x, light_1.y};
    return 3.14159274101257324f * (F32_max((diffuse_0), (0.0f))) / lerp_0(_S471, (0.59700000286102295f * _S471 + 0.16599999368190765f) * (0.21600000560283661f * (dot_2(_S472, float2 {view_1.x, view_1.y}) * (F32_rsqrt(((F32_max((dot_2(_S472, _S472)), (9.99999997475242708e-07f))))))) + 1.0f), blend_0);
}

__device__ float sheen_scale_0(float x_27, float y_11)
{
    return (((((0.0f * x_27 + (((((-1.1402510404586792f * y_11 + 0.40672621130943298f) * y_11 + 1.65398800373077393f) * y_11 + -1.29730904102325439f) * y_11 + 0.30570998787879944f) * y_11 + -0.0220868494361639f)) * x_27 + (((((-0.21142719686031342f * y_11 + 1.05947399139404297f) * y_11 + -0.41116121411323547f) * y_11 + -0.93859231472015381f) * y_11 + 0.51606941223144531f) * y_11 + 0.05409301072359085f)) * x_27 + (((((1.22944498062133789f * y_11 + -0.45962560176849365f) * y_11 + -1.63861405849456787f) * y_11 + 1.33565104007720947f) * y_11 + -0.45725581049919128f) * y_11 + 0.08243165910243988f)) * x_27 + (((((0.39779931306838989f * y_11 + -1.18879103660583496f) * y_11 + 0.28251591324806213f) * y_11 + 1.168984055519104f) * y_11 + -0.76864629983901978f) * y_11 + 0.0091691892594099f)) * x_27 + (((((-0.26563560962677002f * y_11 + -0.19379159808158875f) * y_11 + 0.2677634060382843f) * y_11 + 0.00270519289188087f) * y_11 + 0.14349560439586639f) * y_11 + 0.10290180146694183f)) * x_27 + (((((-0.20701569318771362f * y_11 + 0.24526430666446686f) * y_11 + 0.19551840424537659f) * y_11 + 0.07586126774549484f) * y_11 + 0.38894739747047424f) * y_11 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_28, float y_12)
{
    return ((((0.0f * x_28 + (((((-0.10608240216970444f * y_12 + 1.99214303493499756f) * y_12 + -1.42255294322967529f) * y_12 + -1.09495604038238525f) * y_12 + 0.59180057048797607f) * y_12 + 0.06902855634689331f)) * x_28 + (((((-0.46220690011978149f * y_12 + -0.29113379120826721f) * y_12 + 1.39025199413299561f) * y_12 + 0.35589990019798279f) * y_12 + -1.17120099067687988f) * y_12 + 0.15940259397029877f)) * x_28 + (((((2.26068711280822754f * y_12 + -3.64728999137878418f) * y_12 + -0.72173482179641724f) * y_12 + 3.07659196853637695f) * y_12 + -0.6827620267868042f) * y_12 + -0.3039557933807373f)) * x_28 + (((((0.81201767921447754f * y_12 + 0.36014080047607422f) * y_12 + -1.72646903991699219f) * y_12 + -0.22630110383033752f) * y_12 + 0.89514690637588501f) * y_12 + -0.10397960245609283f)) * x_28 + (((((-0.37648698687553406f * y_12 + 1.10974001884460449f) * y_12 + 0.17824520170688629f) * y_12 + -1.04968702793121338f) * y_12 + 0.1461234986782074f) * y_12 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_29, float y_13)
{
    return ((((0.0f * x_29 + (((((12.95646953582763672f * y_13 + -21.38032913208007812f) * y_13 + -7.37853097915649414f) * y_13 + 34.55607986450195312f) * y_13 + -23.61347007751464844f) * y_13 + 5.00126314163208008f)) * x_29 + (((((10.91487026214599609f * y_13 + -6.08202791213989258f) * y_13 + -38.2036285400390625f) * y_13 + 53.3440399169921875f) * y_13 + -21.91996002197265625f) * y_13 + 2.01606011390686035f)) * x_29 + (((((-14.52206039428710938f * y_13 + 36.803619384765625f) * y_13 + -22.94047927856445312f) * y_13 + -10.07973003387451172f) * y_13 + 15.77003955841064453f) * y_13 + -4.92722177505493164f)) * x_29 + (((((-7.62505722045898438f * y_13 + 1.27310299873352051f) * y_13 + 31.19523048400878906f) * y_13 + -44.39989852905273438f) * y_13 + 26.44947052001953125f) * y_13 + -8.73507976531982422f)) * x_29 + (((((5.65633487701416016f * y_13 + -17.66820907592773438f) * y_13 + 24.65356063842773438f) * y_13 + -19.38941001892089844f) * y_13 + 11.06159019470214844f) * y_13 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S473 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S474 = 2.0f * (F32_sqrt((_S473))) - 1.0f;
    float _S475 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_1, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S474, _S475), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S473) * sheen_shear_0(_S474, _S475), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S474, _S475), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_2, float3  view_2, float scale_1, float shear_0)
{
    float _S476 = light_2.z;
    bool _S477;
    if(_S476 <= 0.0f)
    {
        _S477 = true;
    }
    else
    {
        _S477 = (view_2.z) <= 0.0f;
    }
    if(_S477)
    {
        return 0.0f;
    }
    float2  _S478 = float2 {view_2.x, view_2.y};
    float _S479 = dot_2(_S478, _S478);
    float2  _S480;
    if(_S479 > 9.99999968265522539e-21f)
    {
        _S480 = _S478 * make_float2 ((F32_rsqrt((_S479))));
    }
    else
    {
        _S480 = make_float2 (1.0f, 0.0f);
    }
    float _S481 = scale_1 * dot_2(float2 {light_2.x, light_2.y}, _S480) + shear_0 * _S476;
    float _S482 = scale_1 * (light_2.y * _S480.x - light_2.x * _S480.y);
    float _S483 = _S481 * _S481 + _S482 * _S482 + _S476 * _S476;
    return 0.31830987334251404f * scale_1 * scale_1 * _S476 / (F32_max((_S483 * _S483), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_3, float3  view_3, float strength_0, float roughness_2)
{
    float3  _S484 = sheen_lobe_0(view_3.z, roughness_2);
    float _S485 = strength_0 * _S484.z;
    return make_float2 (_S485 * transformed_cosine_0(light_3, view_3, _S484.x, _S484.y), 1.0f - _S485);
}

__device__ void accumulate_0(Frame_0 * frame_4, uint2  pixel_0, float4  light_4)
{
    uint _S486 = pixel_0.y * frame_4->width_0 + pixel_0.x;
    float _S487 = light_4.w;
    float4  _S488 = make_float4 ((float3 {light_4.x, light_4.y, light_4.z} + make_float3 (1.0f - _S487) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).x, (float3 {light_4.x, light_4.y, light_4.z} + make_float3 (1.0f - _S487) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).y, (float3 {light_4.x, light_4.y, light_4.z} + make_float3 (1.0f - _S487) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).z, _S487);
    float4  * _S489 = (&(globalParams_0->radiance_0)[_S486]);
    float4  _S490;
    if((frame_4->pass_number_0) == 0U)
    {
        _S490 = _S488;
    }
    else
    {
        _S490 = *(&(globalParams_0->radiance_0)[_S486]) + _S488;
    }
    *_S489 = _S490;
    return;
}

__device__ VisiblePoint_0 visible_point_0(Frame_0 * _S491, uint _S492, uint _S493, uint2  _S494)
{
    Fabric_0 * _S495 = (&(globalParams_0->fabrics_0)[_S492]);
    uint _S496 = 3U * _S493;
    uint _S497 = __ldg((&(globalParams_0->corners_0)[_S496]));
    Vertex_0 _S498 = slang_ldg_2((&(globalParams_0->vertices_0)[_S497]));
    uint _S499 = __ldg((&(globalParams_0->corners_0)[_S496 + 1U]));
    Vertex_0 _S500 = slang_ldg_2((&(globalParams_0->vertices_0)[_S499]));
    uint _S501 = __ldg((&(globalParams_0->corners_0)[_S496 + 2U]));
    Vertex_0 _S502 = slang_ldg_2((&(globalParams_0->vertices_0)[_S501]));
    Vertex_0 _S503 = _S500;
    float3  _S504 = position_of_0(&_S503);
    Vertex_0 _S505 = _S498;
    float3  _S506 = position_of_0(&_S505);
    float3  _S507 = _S504 - _S506;
    Vertex_0 _S508 = _S502;
    float3  _S509 = position_of_0(&_S508);
    float3  _S510 = _S509 - _S506;
    float3  _S511 = cross_0(_S507, _S510);
    float _S512 = 1.0f / (F32_max((square_0(_S511)), (1.00000000317107685e-30f)));
    float3  _S513 = camera_right_0(_S491);
    float _S514 = float(_S491->width_0);
    float3  _S515 = _S513 * make_float3 (2.0f / _S514);
    float3  _S516 = camera_up_0(_S491);
    float _S517 = float(_S491->height_0);
    float3  _S518 = _S516 * make_float3 (-2.0f / _S517);
    float _S519 = float(_S494.x) + 0.5f - 0.5f * _S514;
    float _S520 = float(_S494.y) + 0.5f - 0.5f * _S517;
    float3  _S521 = camera_forward_0(_S491);
    float3  _S522 = _S521 + make_float3 (_S519) * _S515 + make_float3 (_S520) * _S518;
    float _S523 = dot_1(_S522, _S511);
    float _S524;
    if((F32_abs((_S523))) > 1.00000000317107685e-30f)
    {
        _S524 = _S523;
    }
    else
    {
        _S524 = 1.00000000317107685e-30f;
    }
    float _S525 = 1.0f / _S524;
    float3  _S526 = camera_origin_0(_S491);
    float3  _S527 = _S506 - _S526;
    float _S528 = dot_1(_S527, _S511) * _S525;
    float3  _S529 = _S522 * make_float3 (_S528) - _S527;
    float3  _S530 = make_float3 (_S528) * (_S515 - _S522 * make_float3 (dot_1(_S515, _S511) * _S525));
    float3  _S531 = make_float3 (_S528) * (_S518 - _S522 * make_float3 (dot_1(_S518, _S511) * _S525));
    float3  _S532 = cross_0(_S510, _S511) * make_float3 (_S512);
    float3  _S533 = cross_0(_S511, _S507) * make_float3 (_S512);
    float _S534 = dot_1(_S529, _S532);
    float _S535 = dot_1(_S529, _S533);
    float _S536 = _S500.u_0 - _S498.u_0;
    float _S537 = _S500.v_0 - _S498.v_0;
    float2  _S538 = make_float2 (_S536, _S537);
    float _S539 = _S502.u_0 - _S498.u_0;
    float _S540 = _S502.v_0 - _S498.v_0;
    float2  _S541 = make_float2 (_S539, _S540);
    float2  _S542 = make_float2 (_S498.u_0, _S498.v_0) + make_float2 (_S534) * _S538 + make_float2 (_S535) * _S541;
    float2  _S543 = make_float2 (dot_1(_S530, _S532)) * _S538 + make_float2 (dot_1(_S530, _S533)) * _S541;
    float2  _S544 = make_float2 (dot_1(_S531, _S532)) * _S538 + make_float2 (dot_1(_S531, _S533)) * _S541;
    if((_S536 * _S540 - _S537 * _S539) < 0.0f)
    {
        _S524 = -1.0f;
    }
    else
    {
        _S524 = 1.0f;
    }
    float3  _S545 = make_float3 (_S524) * (make_float3 (_S540) * _S507 - make_float3 (_S537) * _S510);
    float3  _S546 = make_float3 (_S524) * (make_float3 (_S536) * _S510 - make_float3 (_S539) * _S507);
    VisiblePoint_0 point_1;
    float _S547 = 1.0f - _S534 - _S535;
    Vertex_0 _S548 = _S498;
    float3  _S549 = normal_of_0(&_S548);
    float3  _S550 = make_float3 (_S547) * _S549;
    Vertex_0 _S551 = _S500;
    float3  _S552 = normal_of_0(&_S551);
    float3  _S553 = _S550 + make_float3 (_S534) * _S552;
    Vertex_0 _S554 = _S502;
    float3  _S555 = normal_of_0(&_S554);
    float3  _S556 = normalize_0(_S553 + make_float3 (_S535) * _S555);
    (&point_1)->normal_0 = _S556;
    float3  _S557 = normalize_0(_S545 - _S556 * make_float3 (dot_1(_S556, _S545)));
    (&point_1)->axis_x_0 = _S557;
    (&point_1)->axis_y_0 = cross_0(_S556, _S557);
    (&point_1)->position_0 = _S506 + _S529;
    (&point_1)->view_0 = - normalize_0(_S522);
    bool _S558 = (dot_1(cross_0(_S545, _S546), _S556)) < 0.0f;
    float _S559 = __ldg(&_S495->uv_width_0);
    if(_S558)
    {
        float _S560 = __ldg(&_S495->uv_height_0);
        _S524 = - _S560;
    }
    else
    {
        float _S561 = __ldg(&_S495->uv_height_0);
        _S524 = _S561;
    }
    float2  _S562 = make_float2 (_S559, _S524);
    float2  _S563 = _S542 * _S562;
    if(_S558)
    {
        float _S564 = __ldg(&_S495->uv_height_0);
        _S524 = _S564;
    }
    else
    {
        _S524 = 0.0f;
    }
    (&point_1)->draft_0 = _S563 + make_float2 (0.0f, _S524);
    (&point_1)->draft_dx_0 = _S543 * _S562;
    (&point_1)->draft_dy_0 = _S544 * _S562;
    return point_1;
}

struct WovenView_0
{
    FixedArray<float, 96>  sums_6;
    float hole_0;
    float correction_weight_0;
    float3  view_4;
    bool back_2;
};

__device__ AnisotropicTaps_0 anisotropic_taps_0(uint _S565, Footprint_0 * _S566)
{
    Fabric_0 * _S567 = (&(globalParams_0->fabrics_0)[_S565]);
    float3  _S568 = row_of_taps_0(_S566);
    float2  _S569 = _S566->dx_0;
    float2  _S570 = _S566->dy_0;
    float _S571 = dot_2(_S566->dx_0, _S566->dx_0) + dot_2(_S566->dy_0, _S566->dy_0);
    float _S572 = _S566->dx_0.x * _S566->dy_0.y - _S566->dx_0.y * _S566->dy_0.x;
    float _S573 = 0.5f * (_S571 + (F32_sqrt(((F32_max((_S571 * _S571 - 4.0f * _S572 * _S572), (0.0f)))))));
    Woven_0 _S574 = slang_ldg_1(&_S567->woven_0);
    bool _S575;
    if(_S573 < (5.5f * (_S571 - _S573)))
    {
        _S575 = _S571 > (8.0f * _S574.pitch_0 * _S574.pitch_0);
    }
    else
    {
        _S575 = false;
    }
    float2  _S576 = make_float2 (_S574.ends_per_mm_0, _S574.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    (&taps_1)->centre_1 = _S566->centre_0 * _S576;
    float _S577;
    if(_S575)
    {
        _S577 = (F32_sqrt((0.125f * _S571)));
    }
    else
    {
        _S577 = _S568.x;
    }
    (&taps_1)->side_0 = _S577 / _S574.pitch_0;
    float2  _S578;
    if(_S575)
    {
        _S578 = make_float2 (0.25f) * _S569;
    }
    else
    {
        _S578 = float2 {_S568.y, _S568.z};
    }
    (&taps_1)->first_19 = _S578 * _S576;
    if(_S575)
    {
        _S578 = make_float2 (0.25f) * _S570;
    }
    else
    {
        _S578 = make_float2 (0.5f) * float2 {_S568.y, _S568.z};
    }
    (&taps_1)->second_0 = _S578 * _S576;
    return taps_1;
}

__device__ void add_texel_0(uint _S579, uint _S580, float _S581, FixedArray<float, 88>  * _S582)
{
    Woven_0 _S583 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S579])->woven_0);
    uint _S584 = _S583.latents_0 + _S580 * 8U;
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
        uint4  _S585 = __ldg((&(globalParams_0->packed_numbers_0)[_S584 + part_0]));
        Eight_0 _S586 = eight_halves_0(_S585);
        int _S587 = int(8U * part_0);
        (*_S582)[_S587] = (*_S582)[_S587] + _S581 * _S586.low_0.x;
        (*_S582)[_S587 + int(4)] = (*_S582)[_S587 + int(4)] + _S581 * _S586.high_0.x;
        int _S588 = _S587 + int(1);
        (*_S582)[_S588] = (*_S582)[_S588] + _S581 * _S586.low_0.y;
        (*_S582)[_S588 + int(4)] = (*_S582)[_S588 + int(4)] + _S581 * _S586.high_0.y;
        int _S589 = _S587 + int(2);
        (*_S582)[_S589] = (*_S582)[_S589] + _S581 * _S586.low_0.z;
        (*_S582)[_S589 + int(4)] = (*_S582)[_S589 + int(4)] + _S581 * _S586.high_0.z;
        int _S590 = _S587 + int(3);
        (*_S582)[_S590] = (*_S582)[_S590] + _S581 * _S586.low_0.w;
        (*_S582)[_S590 + int(4)] = (*_S582)[_S590 + int(4)] + _S581 * _S586.high_0.w;
        part_0 = part_0 + 1U;
    }
    return;
}

__device__ void add_level_0(uint _S591, uint _S592, bool _S593, float2  _S594, float _S595, FixedArray<float, 88>  * _S596)
{
    Woven_0 _S597 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S591])->woven_0);
    uint _S598 = _S597.levels_1 + 4U * _S592;
    float _S599 = table_number_0(_S598);
    float _S600 = table_number_0(_S598 + 1U);
    float _S601 = table_number_0(_S598 + 2U);
    bool _S602;
    if(_S592 > 3U)
    {
        _S602 = _S592 < (_S597.top_level_0);
    }
    else
    {
        _S602 = false;
    }
    float2  _S603 = _S594 * make_float2 (table_number_0(_S598 + 3U));
    float _S604;
    if(_S602)
    {
        _S604 = 1.0f;
    }
    else
    {
        _S604 = 0.5f;
    }
    float2  _S605 = _S603 - make_float2 (_S604);
    float2  _S606 = floor_0(_S605);
    float2  _S607 = _S605 - _S606;
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
        float _S608 = float(corner_0 & 1U);
        float _S609 = float(corner_0 >> int(1));
        float2  _S610 = lerp_1(make_float2 (1.0f) - _S607, _S607, make_float2 (_S608, _S609));
        uint _S611 = uint(_S599 + wrapped_0(_S606.y + _S609, _S601) * _S600 + wrapped_0(_S606.x + _S608, _S600));
        uint _S612;
        if(_S593)
        {
            _S612 = _S597.texels_0;
        }
        else
        {
            _S612 = 0U;
        }
        add_texel_0(_S591, _S611 + _S612, _S595 * _S610.x * _S610.y, _S596);
        corner_0 = corner_0 + 1U;
    }
    return;
}

__device__ void code_footprint_0(uint _S613, AnisotropicTaps_0 * _S614, float3  _S615, bool _S616, FixedArray<float, 88>  * _S617)
{
    float offset_0;
    Fabric_0 * _S618 = (&(globalParams_0->fabrics_0)[_S613]);
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
        (*_S617)[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    Woven_0 _S619 = slang_ldg_1(&_S618->woven_0);
    float2  _S620 = make_float2 (_S619.ends_0, _S619.picks_0);
    float _S621 = float(_S619.top_level_0);
    float _S622 = clamp_1(binary_logarithm_0((F32_max((_S614->side_0), (9.99999997475242708e-07f)))) + 3.0f, 0.0f, _S621);
    float _S623 = (F32_min(((F32_floor((_S622)))), (_S621 - 1.0f)));
    bool _S624 = AnisotropicTaps_has_steps_0(_S614);
    uint _S625;
    if(_S624)
    {
        _S625 = 4U;
    }
    else
    {
        _S625 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S625))
        {
        }
        else
        {
            break;
        }
        float2  _S626 = AnisotropicTaps_place_0(_S614, number_1 >> int(1));
        float2  _S627 = clamp_2(_S626 - _S620 * floor_0(_S626 / _S620), make_float2 (0.0f), _S620);
        bool _S628 = (number_1 & 1U) != 0U;
        if(_S628)
        {
            offset_0 = _S622 - _S623;
        }
        else
        {
            offset_0 = 1.0f - (_S622 - _S623);
        }
        float _S629 = offset_0 / float(_S625);
        uint _S630 = uint(_S623);
        uint _S631;
        if(_S628)
        {
            _S631 = 1U;
        }
        else
        {
            _S631 = 0U;
        }
        add_level_0(_S613, _S630 + _S631, _S616, _S627, _S629, _S617);
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
            float offset_1 = _slang_vector_get_element(_S615, number_2) - (float(bin_0) + 0.5f) / 8.0f;
            if(number_2 < int(2))
            {
                offset_0 = offset_1 - (F32_round((offset_1)));
            }
            else
            {
                offset_0 = offset_1;
            }
            (*_S617)[int(64) + number_2 * int(8) + bin_0] = bump_0(offset_0 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_2 = number_2 + int(1);
    }
    return;
}

__device__ float3  crown_fibres_0(uint _S632, bool _S633, bool _S634)
{
    Fabric_0 * _S635 = (&(globalParams_0->fabrics_0)[_S632]);
    float _S636;
    if(_S633)
    {
        if(_S634)
        {
            Woven_0 _S637 = slang_ldg_1(&_S635->woven_0);
            _S636 = - _S637.warp_x_0;
        }
        else
        {
            Woven_0 _S638 = slang_ldg_1(&_S635->woven_0);
            _S636 = _S638.warp_x_0;
        }
        Woven_0 _S639 = slang_ldg_1(&_S635->woven_0);
        return make_float3 (_S636, _S639.warp_y_0, _S639.warp_roughness_0);
    }
    Woven_0 _S640 = slang_ldg_1(&_S635->woven_0);
    if(_S634)
    {
        _S636 = - _S640.weft_y_0;
    }
    else
    {
        _S636 = _S640.weft_y_0;
    }
    return make_float3 (_S640.weft_x_0, _S636, _S640.weft_roughness_0);
}

__device__ void woven_view_0(uint _S641, Footprint_0 * _S642, float3  _S643, WovenView_0 * _S644)
{
    Fabric_0 * _S645 = (&(globalParams_0->fabrics_0)[_S641]);
    bool _S646 = (_S643.z) < 0.0f;
    AnisotropicTaps_0 _S647 = anisotropic_taps_0(_S641, _S642);
    AnisotropicTaps_0 _S648 = _S647;
    float3  _S649 = footprint_coordinates_0(&_S648);
    float3  _S650 = to_face_frame_0(_S643, _S646);
    HalfWeights_0 weights_23;
    Woven_0 _S651 = slang_ldg_1(&_S645->woven_0);
    (&weights_23)->first_2 = _S651.network_0;
    AnisotropicTaps_0 _S652 = _S647;
    FixedArray<float, 88>  inputs_23;
    code_footprint_0(_S641, &_S652, _S649, _S646, &inputs_23);
    HalfWeights_0 _S653 = weights_23;
    FixedArray<float, 96>  hidden_0;
    dense_7(&_S653, 0U, false, &inputs_23, &hidden_0);
    HalfWeights_0 _S654 = weights_23;
    FixedArray<float, 100>  fused_0;
    dense_part_8(&_S654, 1068U, false, &hidden_0, &fused_0);
    fused_0[int(96)] = _S650.x;
    fused_0[int(97)] = _S650.y;
    float3  _S655 = crown_fibres_0(_S641, true, _S646);
    float2  _S656 = float2 {_S650.x, _S650.y};
    fused_0[int(98)] = dot_2(float2 {_S655.x, _S655.y}, _S656);
    float3  _S657 = crown_fibres_0(_S641, false, _S646);
    fused_0[int(99)] = dot_2(float2 {_S657.x, _S657.y}, _S656);
    HalfWeights_0 _S658 = weights_23;
    FixedArray<float, 16>  of_hole_0;
    dense_6(&_S658, 2232U, false, &fused_0, &of_hole_0);
    HalfWeights_0 _S659 = weights_23;
    FixedArray<float, 1>  hole_1;
    dense_5(&_S659, 2444U, false, &of_hole_0, &hole_1);
    HalfWeights_0 _S660 = weights_23;
    dense_4(&_S660, 2456U, false, &fused_0, &_S644->sums_6);
    _S644->hole_0 = clamp_1(hole_1[int(0)], 0.0f, 1.0f);
    _S644->correction_weight_0 = correction_weight_of_0(_S649.z);
    _S644->view_4 = _S650;
    _S644->back_2 = _S646;
    return;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_1;
    Albedos_0 weft_1;
};

__device__ FamilyAlbedos_0 albedos_over_0(uint _S661, Footprint_0 * _S662, bool _S663)
{
    Fabric_0 * _S664 = (&(globalParams_0->fabrics_0)[_S661]);
    float2  _S665 = sqrt_0(_S662->dx_0 * _S662->dx_0 + _S662->dy_0 * _S662->dy_0);
    uint _S666 = __ldg(&_S664->warp_0);
    float2  _S667 = _S662->centre_0;
    Stretch_0 _S668 = stretch_of_0(_S666, _S662->centre_0.x, _S665.x);
    uint _S669 = __ldg(&_S664->weft_0);
    Stretch_0 _S670 = stretch_of_0(_S669, _S667.y, _S665.y);
    FamilyAlbedos_0 albedos_3;
    Stretch_0 _S671 = _S668;
    Stretch_0 _S672 = _S670;
    Albedos_0 _S673 = mean_albedos_0(_S666, _S669, &_S671, &_S672, _S663);
    (&albedos_3)->warp_1 = _S673;
    Stretch_0 _S674 = _S670;
    Stretch_0 _S675 = _S668;
    Albedos_0 _S676 = mean_albedos_0(_S669, _S666, &_S674, &_S675, _S663);
    (&albedos_3)->weft_1 = _S676;
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

__device__ void code_light_0(uint _S677, float3  _S678, float3  _S679, bool _S680, FixedArray<float, 39>  * _S681)
{
    (*_S681)[int(0)] = _S678.x;
    (*_S681)[int(1)] = _S678.y;
    (*_S681)[int(2)] = _S678.z;
    float3  _S682 = _S678 + _S679;
    float _S683 = _S682.z;
    float _S684 = _S683 * _S683 + 0.00009999999747379f;
    float2  _S685 = float2 {_S682.x, _S682.y};
    float _S686 = 1.0f / (dot_2(_S685, _S685) + _S684);
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
        float3  _S687 = crown_fibres_0(_S677, family_10 == int(0), _S680);
        float2  _S688 = float2 {_S687.x, _S687.y};
        (*_S681)[int(3) + family_10] = dot_2(_S688, float2 {_S678.x, _S678.y});
        float _S689 = dot_2(_S688, _S685);
        float _S690 = _S689 * _S689;
        float _S691 = (0.75f * _S689 / (0.5f * (F32_sqrt((_S690 + _S684))) + (F32_abs((_S689)))) + 0.5f) * 8.0f;
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
            (*_S681)[int(5) + family_10 * int(16) + bin_1] = bump_0(_S691 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S692 = _S687.z;
        float _S693 = _S692 * _S692;
        float _S694 = _S690 * _S686 * (1.0f - _S693) + _S693;
        (*_S681)[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S693 * _S692 / (_S694 * _S694));
        family_10 = family_10 + int(1);
    }
    return;
}

__device__ float mixed_bundles_0(uint _S695, uint _S696, uint _S697, float3  _S698, float3  _S699, bool _S700, FixedArray<float, 52>  * _S701)
{
    Fabric_0 * _S702 = (&(globalParams_0->fabrics_0)[_S695]);
    float3  _S703 = _S698 + _S699;
    float _S704 = 1.0f / (square_0(_S703) + 0.00009999999747379f);
    bool _S705;
    if(_S696 == 0U)
    {
        _S705 = _S700;
    }
    else
    {
        _S705 = false;
    }
    float _S706;
    if(_S705)
    {
        _S706 = - _S703.x;
    }
    else
    {
        _S706 = _S703.x;
    }
    if(_S696 == 1U)
    {
        _S705 = _S700;
    }
    else
    {
        _S705 = false;
    }
    float _S707;
    if(_S705)
    {
        _S707 = - _S703.y;
    }
    else
    {
        _S707 = _S703.y;
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
        Woven_0 _S708 = slang_ldg_1(&_S702->woven_0);
        uint _S709 = _S696 * 25U;
        uint _S710 = _S708.bundles_0 + 4U * (_S709 + bundle_1);
        float _S711 = dot_1(make_float3 (table_number_0(_S710), table_number_0(_S710 + 1U), table_number_0(_S710 + 2U)), make_float3 (_S706, _S707, _S703.z));
        float _S712 = _S711 * _S711 * _S704 + table_number_0(_S710 + 3U);
        uint _S713 = _S697 + _S709;
        uint _S714;
        if(_S700)
        {
            _S714 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S714 = bundle_1;
        }
        float sum_2 = sum_1 + (F32_max(((*_S701)[_S713 + _S714]), ((*_S701)[_S713 + _S714] * 0.00999999977648258f))) / (_S712 * _S712);
        bundle_1 = bundle_1 + 1U;
        sum_1 = sum_2;
    }
    return 0.01999999955296516f * sum_1;
}

__device__ Components_0 woven_components_0(uint _S715, WovenView_0 * _S716, float3  _S717)
{
    float _S718;
    Fabric_0 * _S719 = (&(globalParams_0->fabrics_0)[_S715]);
    bool _S720 = _S716->back_2;
    float3  _S721 = to_face_frame_0(_S717, _S716->back_2);
    float3  _S722 = _S716->view_4;
    HalfWeights_0 weights_24;
    Woven_0 _S723 = slang_ldg_1(&_S719->woven_0);
    (&weights_24)->first_2 = _S723.network_0;
    FixedArray<float, 39>  directions_0;
    code_light_0(_S715, _S721, _S722, _S720, &directions_0);
    FixedArray<float, 96>  skip_0;
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
        skip_0[k_1] = _S716->sums_6[k_1];
        k_1 = k_1 + int(1);
    }
    HalfWeights_0 _S724 = weights_24;
    dense_3(&_S724, 3716U, true, &directions_0, &skip_0);
    FixedArray<float, 96>  hidden_1;
    FixedArray<float, 96>  next_0;
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
                _S718 = skip_0[k_1];
            }
            else
            {
                _S718 = 0.0f;
            }
            next_0[k_1] = _S718;
            k_1 = k_1 + int(1);
        }
        uint _S725 = 4208U + layer_0 * 1164U;
        HalfWeights_0 _S726 = weights_24;
        dense_2(&_S726, _S725, true, &hidden_1, &next_0);
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
    HalfWeights_0 _S727 = weights_24;
    FixedArray<float, 52>  outputs_17;
    dense_1(&_S727, 7700U, false, &hidden_1, &outputs_17);
    bool _S728;
    if((_S723.is_corrected_0) != 0U)
    {
        _S728 = (_S721.z) > 0.0f;
    }
    else
    {
        _S728 = false;
    }
    if(_S728)
    {
        _S728 = (_S716->correction_weight_0) > 0.0f;
    }
    else
    {
        _S728 = false;
    }
    if(_S728)
    {
        FloatWeights_0 fitted_0;
        (&fitted_0)->first_0 = _S723.correction_0;
        FloatWeights_0 _S729 = fitted_0;
        FixedArray<float, 50>  change_0;
        dense_0(&_S729, 0U, false, &hidden_1, &change_0);
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
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S716->correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S721.z) > 0.0f)
    {
        _S718 = 0.00999999977648258f;
    }
    else
    {
        _S718 = 0.00100000004749745f;
    }
    Components_0 result_15;
    float _S730 = unmapped_0(outputs_17[int(0)], _S718);
    (&result_15)->diffuse_warp_0 = _S730;
    float _S731 = unmapped_0(outputs_17[int(1)], _S718);
    (&result_15)->diffuse_weft_0 = _S731;
    float _S732 = 2979.9580078125f * _S718;
    float _S733 = mixed_bundles_0(_S715, 0U, 2U, _S721, _S722, _S720, &outputs_17);
    (&result_15)->specular_warp_0 = clamp_1(_S733, 0.0f, _S732);
    float _S734 = mixed_bundles_0(_S715, 1U, 2U, _S721, _S722, _S720, &outputs_17);
    (&result_15)->specular_weft_0 = clamp_1(_S734, 0.0f, _S732);
    float _S735 = _S716->hole_0;
    (&result_15)->hole_2 = _S716->hole_0;
    float _S736 = _S730 + _S731;
    float _S737 = __ldg(&_S719->diffuse_blend_0);
    (&result_15)->light_visibility_1 = (F32_min((light_visibility_of_0(_S736, _S721, _S722, _S737)), (1.0f - _S735)));
    return result_15;
}

__device__ float3  composed_0(uint _S738, Components_0 * _S739, FamilyAlbedos_0 * _S740, float3  _S741, float3  _S742)
{
    Fabric_0 * _S743 = (&(globalParams_0->fabrics_0)[_S738]);
    float _S744 = _S739->diffuse_warp_0;
    float _S745 = _S739->diffuse_weft_0;
    float _S746 = _S739->specular_warp_0;
    float _S747 = _S739->specular_weft_0;
    float3  _S748 = (&_S740->warp_1)->diffuse_reflect_0 * make_float3 (_S739->diffuse_warp_0) + (&_S740->weft_1)->diffuse_reflect_0 * make_float3 (_S739->diffuse_weft_0) + (&_S740->warp_1)->specular_reflect_0 * make_float3 (_S739->specular_warp_0) + (&_S740->weft_1)->specular_reflect_0 * make_float3 (_S739->specular_weft_0);
    float _S749 = _S742.z;
    float3  body_0;
    if((_S741.z * _S749) < 0.0f)
    {
        body_0 = (&_S740->warp_1)->diffuse_transmit_0 * make_float3 (_S744) + (&_S740->weft_1)->diffuse_transmit_0 * make_float3 (_S745) + (&_S740->warp_1)->specular_transmit_0 * make_float3 (_S746) + (&_S740->weft_1)->specular_transmit_0 * make_float3 (_S747);
    }
    else
    {
        body_0 = _S748;
    }
    float _S750 = __ldg(&_S743->sheen_strength_0);
    if(_S750 <= 0.0f)
    {
        return body_0;
    }
    bool _S751 = _S749 < 0.0f;
    float3  _S752 = to_face_frame_0(_S741, _S751);
    float3  _S753 = to_face_frame_0(_S742, _S751);
    float _S754 = __ldg(&_S743->sheen_roughness_0);
    float2  _S755 = sheen_with_transmittance_0(_S752, _S753, _S750, _S754);
    return make_float3 (_S755.y) * body_0 + make_float3 ((_S739->light_visibility_1 + _S739->hole_2) * _S755.x);
}

__device__ float4  light_of_woven_0(Frame_0 * _S756, uint _S757, VisiblePoint_0 * _S758)
{
    Fabric_0 * _S759 = (&(globalParams_0->fabrics_0)[_S757]);
    Footprint_0 footprint_1;
    (&footprint_1)->centre_0 = _S758->draft_0;
    (&footprint_1)->dx_0 = _S758->draft_dx_0;
    (&footprint_1)->dy_0 = _S758->draft_dy_0;
    float3  _S760 = to_local_0(_S758, _S758->view_0);
    Footprint_0 _S761 = footprint_1;
    WovenView_0 activations_0;
    woven_view_0(_S757, &_S761, _S760, &activations_0);
    float _S762 = _S760.z;
    bool _S763 = _S762 < 0.0f;
    Footprint_0 _S764 = footprint_1;
    FamilyAlbedos_0 _S765 = albedos_over_0(_S757, &_S764, _S763);
    float3  _S766 = make_float3 (0.0f);
    uint number_3 = 0U;
    float3  radiance_1 = _S766;
    for(;;)
    {
        if(number_3 < (_S756->lights_0))
        {
        }
        else
        {
            break;
        }
        Light_0 _S767 = slang_ldg_4((&(globalParams_0->lights_1)[number_3]));
        Light_0 _S768 = _S767;
        float3  irradiance_2;
        float3  _S769 = towards_light_0(&_S768, _S758->position_0, &irradiance_2);
        float3  _S770 = to_local_0(_S758, _S769);
        Components_0 _S771 = woven_components_0(_S757, &activations_0, _S770);
        Components_0 _S772 = _S771;
        FamilyAlbedos_0 _S773 = _S765;
        float3  _S774 = composed_0(_S757, &_S772, &_S773, _S770, _S760);
        float3  radiance_2 = radiance_1 + irradiance_2 * _S774;
        number_3 = number_3 + 1U;
        radiance_1 = radiance_2;
    }
    float hole_3 = (&activations_0)->hole_0;
    float _S775 = __ldg(&_S759->sheen_strength_0);
    float hole_4;
    if(_S775 > 0.0f)
    {
        float _S776 = (F32_abs((_S762)));
        float _S777 = __ldg(&_S759->sheen_roughness_0);
        hole_4 = hole_3 * (1.0f - _S775 * sheen_lobe_0(_S776, _S777).z);
    }
    else
    {
        hole_4 = hole_3;
    }
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f - hole_4);
}

extern "C" __global__ void shade_woven()
{
    uint3  _S778 = blockIdx * blockDim + threadIdx;
    Frame_0 _S779 = slang_ldg_0((&(globalParams_0->frames_0)[int(0)]));
    bool _S780;
    if((_S778.x) >= (_S779.width_0))
    {
        _S780 = true;
    }
    else
    {
        _S780 = (_S778.y) >= (_S779.height_0);
    }
    if(_S780)
    {
        return;
    }
    uint2  _S781 = uint2 {_S778.x, _S778.y};
    int2  _S782 = make_int2 ((int)_S781.x, (int)_S781.y);
    int3  _S783 = make_int3 (_S782.x, _S782.y, int(0));
    uint _S784 = (tex2Dfetch_int<uint>((globalParams_0->visible_faces_0), ((_S783)).x, ((_S783)).y, ((_S783)).z));
    float4  _S785 = make_float4 (0.0f);
    float4  sum_3;
    if(_S784 > 0U)
    {
        uint _S786 = _S784 - 1U;
        uint _S787 = __ldg((&(globalParams_0->face_fabrics_0)[_S786]));
        Frame_0 _S788 = _S779;
        VisiblePoint_0 _S789 = visible_point_0(&_S788, _S787, _S786, _S781);
        Frame_0 _S790 = _S779;
        VisiblePoint_0 _S791 = _S789;
        float4  _S792 = light_of_woven_0(&_S790, _S787, &_S791);
        sum_3 = _S792;
    }
    else
    {
        sum_3 = _S785;
    }
    Frame_0 _S793 = _S779;
    accumulate_0(&_S793, _S781, sum_3);
    return;
}

