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

struct Layer_0
{
    uint face_0;
    float share_0;
};

struct Bake_0
{
    uint fabric_0;
    uint per_family_0;
    uint packs_1;
    uint max_clusters_0;
    uint rays_0;
    float ends_2;
    float picks_1;
    float spacing_x_0;
    float spacing_y_0;
    uint columns_0;
    uint rows_0;
    uint face_nodes_1;
    uint texels_across_0;
    uint texels_along_0;
    float texel_x_0;
    float texel_y_0;
    float far_weight_0;
    uint moments_table_0;
    uint record_warp_packs_0;
    uint record_hole_weights_0;
    uint facts_0;
    uint gaps_0;
    uint gap_nulls_0;
    uint lit_0;
    uint lists_0;
    uint points_0;
    uint clusters_0;
    uint cluster_means_0;
    uint cluster_errors_0;
    uint centroids_0;
    uint view_sums_0;
    uint light_sums_0;
    uint group_moments_0;
    uint areas_0;
    uint area_scales_0;
    uint row_totals_0;
    uint row_largest_0;
    uint coverage_means_0;
    uint coverage_scales_0;
    uint hole_bytes_0;
};

struct SurfaceHit_0
{
    float x_2;
    float y_2;
    uint flags_0;
    float normal_x_1;
    float normal_y_1;
    float normal_z_1;
    float tangent_x_0;
    float tangent_y_0;
    float tangent_z_0;
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
    StructuredBuffer<uint> scene_words_0;
    RWStructuredBuffer<Layer_0> layers_0;
    RWStructuredBuffer<float> visibilities_0;
    StructuredBuffer<Bake_0> bakes_0;
    StructuredBuffer<uint> steps_0;
    RWStructuredBuffer<SurfaceHit_0> hits_0;
    RWStructuredBuffer<uint> scratch_0;
    RWStructuredBuffer<uint> texel_counters_0;
    StructuredBuffer<uint> texel_counts_0;
    RWStructuredBuffer<float4 > coverage_pyramid_0;
    RWStructuredBuffer<uint> tables_0;
    RWStructuredBuffer<uint> record_words_0;
    CUtexObject visible_faces_0;
};

extern "C" __constant__ GlobalParams_0 SLANG_globalParams;
#define globalParams_0 (&SLANG_globalParams)
__device__ float2  min_0(float2  x_3, float2  y_3)
{
    float2  result_0;
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
        *_slang_vector_get_element_ptr(&result_0, i_0) = (F32_min((_slang_vector_get_element(x_3, i_0)), (_slang_vector_get_element(y_3, i_0))));
        i_0 = i_0 + int(1);
    }
    return result_0;
}

__device__ float2  max_0(float2  x_4, float2  y_4)
{
    float2  result_1;
    int i_1 = int(0);
    for(;;)
    {
        if(i_1 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_1, i_1) = (F32_max((_slang_vector_get_element(x_4, i_1)), (_slang_vector_get_element(y_4, i_1))));
        i_1 = i_1 + int(1);
    }
    return result_1;
}

struct FloatWeights_0
{
    uint first_0;
};

__device__ int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

struct Eight_0
{
    float4  low_0;
    float4  high_0;
};

__device__ float4  asfloat_0(uint4  x_5)
{
    float4  result_2;
    int i_2 = int(0);
    for(;;)
    {
        if(i_2 < int(4))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_2, i_2) = (U32_asfloat((_slang_vector_get_element(x_5, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_2;
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

__device__ float dot_0(float4  x_6, float4  y_5)
{
    int i_3 = int(0);
    float result_3 = 0.0f;
    for(;;)
    {
        if(i_3 < int(4))
        {
        }
        else
        {
            break;
        }
        float result_4 = result_3 + _slang_vector_get_element(x_6, i_3) * _slang_vector_get_element(y_5, i_3);
        i_3 = i_3 + int(1);
        result_3 = result_4;
    }
    return result_3;
}

__device__ float4  tile_product_0(FloatWeights_0 * weights_0, uint row_0, FixedArray<float, 25>  * inputs_0)
{
    float4  sums_0 = make_float4 (0.0f);
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
        float4  low_1;
        float4  high_1;
        int _S4 = int(8U * column_0);
        *&((&low_1)->x) = (*inputs_0)[(I32_min((_S4), (int(24))))];
        *&((&high_1)->x) = (*inputs_0)[(I32_min((_S4 + int(4)), (int(24))))];
        int _S5 = _S4 + int(1);
        *&((&low_1)->y) = (*inputs_0)[(I32_min((_S5), (int(24))))];
        *&((&high_1)->y) = (*inputs_0)[(I32_min((_S5 + int(4)), (int(24))))];
        int _S6 = _S4 + int(2);
        *&((&low_1)->z) = (*inputs_0)[(I32_min((_S6), (int(24))))];
        *&((&high_1)->z) = (*inputs_0)[(I32_min((_S6 + int(4)), (int(24))))];
        int _S7 = _S4 + int(3);
        *&((&low_1)->w) = (*inputs_0)[(I32_min((_S7), (int(24))))];
        *&((&high_1)->w) = (*inputs_0)[(I32_min((_S7 + int(4)), (int(24))))];
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        *&((&sums_0)->x) = *&((&sums_0)->x) + (dot_0(_S8.low_0, low_1) + dot_0(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 4U + column_0);
        *&((&sums_0)->y) = *&((&sums_0)->y) + (dot_0(_S9.low_0, low_1) + dot_0(_S9.high_0, high_1));
        Eight_0 _S10 = FloatWeights_eight_0(weights_0, row_0 + 8U + column_0);
        *&((&sums_0)->z) = *&((&sums_0)->z) + (dot_0(_S10.low_0, low_1) + dot_0(_S10.high_0, high_1));
        Eight_0 _S11 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        *&((&sums_0)->w) = *&((&sums_0)->w) + (dot_0(_S11.low_0, low_1) + dot_0(_S11.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
}

__device__ float Identity_apply_0(float x_7)
{
    return x_7;
}

__device__ void dense_part_0(FloatWeights_0 * weights_1, uint first_1, bool adds_0, FixedArray<float, 25>  * inputs_1, FixedArray<float, 3>  * outputs_0)
{
    uint _S12 = first_1 + uint(whole_parts_0(int(1)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S13 = output_0 < int(3);
        if(_S13)
        {
        }
        else
        {
            break;
        }
        uint _S14 = uint(output_0);
        Eight_0 _S15 = FloatWeights_eight_0(weights_1, first_1 + _S14 / 8U);
        float4  _S16 = tile_product_0(weights_1, _S12 + _S14 * 4U, inputs_1);
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
        if(_S20 < int(3))
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
        if(_S21 < int(3))
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
        if(_S22 < int(3))
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

__device__ float4  tile_product_1(FloatWeights_0 * weights_2, uint row_1, FixedArray<float, 11>  * inputs_2)
{
    float4  sums_1 = make_float4 (0.0f);
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
        float4  low_2;
        float4  high_2;
        int _S23 = int(8U * column_1);
        *&((&low_2)->x) = (*inputs_2)[(I32_min((_S23), (int(10))))];
        *&((&high_2)->x) = (*inputs_2)[(I32_min((_S23 + int(4)), (int(10))))];
        int _S24 = _S23 + int(1);
        *&((&low_2)->y) = (*inputs_2)[(I32_min((_S24), (int(10))))];
        *&((&high_2)->y) = (*inputs_2)[(I32_min((_S24 + int(4)), (int(10))))];
        int _S25 = _S23 + int(2);
        *&((&low_2)->z) = (*inputs_2)[(I32_min((_S25), (int(10))))];
        *&((&high_2)->z) = (*inputs_2)[(I32_min((_S25 + int(4)), (int(10))))];
        int _S26 = _S23 + int(3);
        *&((&low_2)->w) = (*inputs_2)[(I32_min((_S26), (int(10))))];
        *&((&high_2)->w) = (*inputs_2)[(I32_min((_S26 + int(4)), (int(10))))];
        Eight_0 _S27 = FloatWeights_eight_0(weights_2, row_1 + column_1);
        *&((&sums_1)->x) = *&((&sums_1)->x) + (dot_0(_S27.low_0, low_2) + dot_0(_S27.high_0, high_2));
        Eight_0 _S28 = FloatWeights_eight_0(weights_2, row_1 + 2U + column_1);
        *&((&sums_1)->y) = *&((&sums_1)->y) + (dot_0(_S28.low_0, low_2) + dot_0(_S28.high_0, high_2));
        Eight_0 _S29 = FloatWeights_eight_0(weights_2, row_1 + 4U + column_1);
        *&((&sums_1)->z) = *&((&sums_1)->z) + (dot_0(_S29.low_0, low_2) + dot_0(_S29.high_0, high_2));
        Eight_0 _S30 = FloatWeights_eight_0(weights_2, row_1 + 6U + column_1);
        *&((&sums_1)->w) = *&((&sums_1)->w) + (dot_0(_S30.low_0, low_2) + dot_0(_S30.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
}

__device__ float Relu_apply_0(float x_8)
{
    return (F32_max((x_8), (0.0f)));
}

__device__ void dense_part_1(FloatWeights_0 * weights_3, uint first_2, bool adds_1, FixedArray<float, 11>  * inputs_3, FixedArray<float, 25>  * outputs_1)
{
    uint _S31 = first_2 + uint(whole_parts_0(int(4)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S32 = output_1 < int(25);
        if(_S32)
        {
        }
        else
        {
            break;
        }
        uint _S33 = uint(output_1);
        Eight_0 _S34 = FloatWeights_eight_0(weights_3, first_2 + _S33 / 8U);
        float4  _S35 = tile_product_1(weights_3, _S31 + _S33 * 2U, inputs_3);
        float4  _S36;
        if((output_1 & int(4)) != int(0))
        {
            _S36 = _S34.high_0;
        }
        else
        {
            _S36 = _S34.low_0;
        }
        float4  _S37 = _S35 + _S36;
        float _S38;
        if(_S32)
        {
            if(adds_1)
            {
                _S38 = (*outputs_1)[output_1];
            }
            else
            {
                _S38 = 0.0f;
            }
            (*outputs_1)[output_1] = Relu_apply_0(_S37.x + _S38);
        }
        int _S39 = output_1 + int(1);
        if(_S39 < int(25))
        {
            if(adds_1)
            {
                _S38 = (*outputs_1)[_S39];
            }
            else
            {
                _S38 = 0.0f;
            }
            (*outputs_1)[_S39] = Relu_apply_0(_S37.y + _S38);
        }
        int _S40 = output_1 + int(2);
        if(_S40 < int(25))
        {
            if(adds_1)
            {
                _S38 = (*outputs_1)[_S40];
            }
            else
            {
                _S38 = 0.0f;
            }
            (*outputs_1)[_S40] = Relu_apply_0(_S37.z + _S38);
        }
        int _S41 = output_1 + int(3);
        if(_S41 < int(25))
        {
            if(adds_1)
            {
                _S38 = (*outputs_1)[_S41];
            }
            else
            {
                _S38 = 0.0f;
            }
            (*outputs_1)[_S41] = Relu_apply_0(_S37.w + _S38);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

__device__ void dense_0(FloatWeights_0 * weights_4, uint first_3, bool adds_2, FixedArray<float, 25>  * inputs_4, FixedArray<float, 3>  * outputs_2)
{
    dense_part_0(weights_4, first_3, adds_2, inputs_4, outputs_2);
    return;
}

__device__ void dense_1(FloatWeights_0 * weights_5, uint first_4, bool adds_3, FixedArray<float, 11>  * inputs_5, FixedArray<float, 25>  * outputs_3)
{
    dense_part_1(weights_5, first_4, adds_3, inputs_5, outputs_3);
    return;
}

__device__ void dense_part_2(FloatWeights_0 * weights_6, uint first_5, bool adds_4, FixedArray<float, 25>  * inputs_6, FixedArray<float, 25>  * outputs_4)
{
    uint _S42 = first_5 + uint(whole_parts_0(int(4)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S43 = output_2 < int(25);
        if(_S43)
        {
        }
        else
        {
            break;
        }
        uint _S44 = uint(output_2);
        Eight_0 _S45 = FloatWeights_eight_0(weights_6, first_5 + _S44 / 8U);
        float4  _S46 = tile_product_0(weights_6, _S42 + _S44 * 4U, inputs_6);
        float4  _S47;
        if((output_2 & int(4)) != int(0))
        {
            _S47 = _S45.high_0;
        }
        else
        {
            _S47 = _S45.low_0;
        }
        float4  _S48 = _S46 + _S47;
        float _S49;
        if(_S43)
        {
            if(adds_4)
            {
                _S49 = (*outputs_4)[output_2];
            }
            else
            {
                _S49 = 0.0f;
            }
            (*outputs_4)[output_2] = Relu_apply_0(_S48.x + _S49);
        }
        int _S50 = output_2 + int(1);
        if(_S50 < int(25))
        {
            if(adds_4)
            {
                _S49 = (*outputs_4)[_S50];
            }
            else
            {
                _S49 = 0.0f;
            }
            (*outputs_4)[_S50] = Relu_apply_0(_S48.y + _S49);
        }
        int _S51 = output_2 + int(2);
        if(_S51 < int(25))
        {
            if(adds_4)
            {
                _S49 = (*outputs_4)[_S51];
            }
            else
            {
                _S49 = 0.0f;
            }
            (*outputs_4)[_S51] = Relu_apply_0(_S48.z + _S49);
        }
        int _S52 = output_2 + int(3);
        if(_S52 < int(25))
        {
            if(adds_4)
            {
                _S49 = (*outputs_4)[_S52];
            }
            else
            {
                _S49 = 0.0f;
            }
            (*outputs_4)[_S52] = Relu_apply_0(_S48.w + _S49);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

__device__ void dense_part_3(FloatWeights_0 * weights_7, uint first_6, bool adds_5, FixedArray<float, 25>  * inputs_7, FixedArray<float, 1>  * outputs_5)
{
    uint _S53 = first_6 + uint(whole_parts_0(int(1)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S54 = output_3 < int(1);
        if(_S54)
        {
        }
        else
        {
            break;
        }
        uint _S55 = uint(output_3);
        Eight_0 _S56 = FloatWeights_eight_0(weights_7, first_6 + _S55 / 8U);
        float4  _S57 = tile_product_0(weights_7, _S53 + _S55 * 4U, inputs_7);
        float4  _S58;
        if((output_3 & int(4)) != int(0))
        {
            _S58 = _S56.high_0;
        }
        else
        {
            _S58 = _S56.low_0;
        }
        float4  _S59 = _S57 + _S58;
        float _S60;
        if(_S54)
        {
            if(adds_5)
            {
                _S60 = (*outputs_5)[output_3];
            }
            else
            {
                _S60 = 0.0f;
            }
            (*outputs_5)[output_3] = Identity_apply_0(_S59.x + _S60);
        }
        int _S61 = output_3 + int(1);
        if(_S61 < int(1))
        {
            if(adds_5)
            {
                _S60 = (*outputs_5)[_S61];
            }
            else
            {
                _S60 = 0.0f;
            }
            (*outputs_5)[_S61] = Identity_apply_0(_S59.y + _S60);
        }
        int _S62 = output_3 + int(2);
        if(_S62 < int(1))
        {
            if(adds_5)
            {
                _S60 = (*outputs_5)[_S62];
            }
            else
            {
                _S60 = 0.0f;
            }
            (*outputs_5)[_S62] = Identity_apply_0(_S59.z + _S60);
        }
        int _S63 = output_3 + int(3);
        if(_S63 < int(1))
        {
            if(adds_5)
            {
                _S60 = (*outputs_5)[_S63];
            }
            else
            {
                _S60 = 0.0f;
            }
            (*outputs_5)[_S63] = Identity_apply_0(_S59.w + _S60);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

__device__ float4  tile_product_2(FloatWeights_0 * weights_8, uint row_2, FixedArray<float, 9>  * inputs_8)
{
    float4  sums_2 = make_float4 (0.0f);
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
        float4  low_3;
        float4  high_3;
        int _S64 = int(8U * column_2);
        *&((&low_3)->x) = (*inputs_8)[(I32_min((_S64), (int(8))))];
        *&((&high_3)->x) = (*inputs_8)[(I32_min((_S64 + int(4)), (int(8))))];
        int _S65 = _S64 + int(1);
        *&((&low_3)->y) = (*inputs_8)[(I32_min((_S65), (int(8))))];
        *&((&high_3)->y) = (*inputs_8)[(I32_min((_S65 + int(4)), (int(8))))];
        int _S66 = _S64 + int(2);
        *&((&low_3)->z) = (*inputs_8)[(I32_min((_S66), (int(8))))];
        *&((&high_3)->z) = (*inputs_8)[(I32_min((_S66 + int(4)), (int(8))))];
        int _S67 = _S64 + int(3);
        *&((&low_3)->w) = (*inputs_8)[(I32_min((_S67), (int(8))))];
        *&((&high_3)->w) = (*inputs_8)[(I32_min((_S67 + int(4)), (int(8))))];
        Eight_0 _S68 = FloatWeights_eight_0(weights_8, row_2 + column_2);
        *&((&sums_2)->x) = *&((&sums_2)->x) + (dot_0(_S68.low_0, low_3) + dot_0(_S68.high_0, high_3));
        Eight_0 _S69 = FloatWeights_eight_0(weights_8, row_2 + 2U + column_2);
        *&((&sums_2)->y) = *&((&sums_2)->y) + (dot_0(_S69.low_0, low_3) + dot_0(_S69.high_0, high_3));
        Eight_0 _S70 = FloatWeights_eight_0(weights_8, row_2 + 4U + column_2);
        *&((&sums_2)->z) = *&((&sums_2)->z) + (dot_0(_S70.low_0, low_3) + dot_0(_S70.high_0, high_3));
        Eight_0 _S71 = FloatWeights_eight_0(weights_8, row_2 + 6U + column_2);
        *&((&sums_2)->w) = *&((&sums_2)->w) + (dot_0(_S71.low_0, low_3) + dot_0(_S71.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
}

__device__ void dense_part_4(FloatWeights_0 * weights_9, uint first_7, bool adds_6, FixedArray<float, 9>  * inputs_9, FixedArray<float, 25>  * outputs_6)
{
    uint _S72 = first_7 + uint(whole_parts_0(int(4)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S73 = output_4 < int(25);
        if(_S73)
        {
        }
        else
        {
            break;
        }
        uint _S74 = uint(output_4);
        Eight_0 _S75 = FloatWeights_eight_0(weights_9, first_7 + _S74 / 8U);
        float4  _S76 = tile_product_2(weights_9, _S72 + _S74 * 2U, inputs_9);
        float4  _S77;
        if((output_4 & int(4)) != int(0))
        {
            _S77 = _S75.high_0;
        }
        else
        {
            _S77 = _S75.low_0;
        }
        float4  _S78 = _S76 + _S77;
        float _S79;
        if(_S73)
        {
            if(adds_6)
            {
                _S79 = (*outputs_6)[output_4];
            }
            else
            {
                _S79 = 0.0f;
            }
            (*outputs_6)[output_4] = Relu_apply_0(_S78.x + _S79);
        }
        int _S80 = output_4 + int(1);
        if(_S80 < int(25))
        {
            if(adds_6)
            {
                _S79 = (*outputs_6)[_S80];
            }
            else
            {
                _S79 = 0.0f;
            }
            (*outputs_6)[_S80] = Relu_apply_0(_S78.y + _S79);
        }
        int _S81 = output_4 + int(2);
        if(_S81 < int(25))
        {
            if(adds_6)
            {
                _S79 = (*outputs_6)[_S81];
            }
            else
            {
                _S79 = 0.0f;
            }
            (*outputs_6)[_S81] = Relu_apply_0(_S78.z + _S79);
        }
        int _S82 = output_4 + int(3);
        if(_S82 < int(25))
        {
            if(adds_6)
            {
                _S79 = (*outputs_6)[_S82];
            }
            else
            {
                _S79 = 0.0f;
            }
            (*outputs_6)[_S82] = Relu_apply_0(_S78.w + _S79);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

__device__ void dense_2(FloatWeights_0 * weights_10, uint first_8, bool adds_7, FixedArray<float, 25>  * inputs_10, FixedArray<float, 25>  * outputs_7)
{
    dense_part_2(weights_10, first_8, adds_7, inputs_10, outputs_7);
    return;
}

__device__ void dense_3(FloatWeights_0 * weights_11, uint first_9, bool adds_8, FixedArray<float, 25>  * inputs_11, FixedArray<float, 1>  * outputs_8)
{
    dense_part_3(weights_11, first_9, adds_8, inputs_11, outputs_8);
    return;
}

__device__ void dense_4(FloatWeights_0 * weights_12, uint first_10, bool adds_9, FixedArray<float, 9>  * inputs_12, FixedArray<float, 25>  * outputs_9)
{
    dense_part_4(weights_12, first_10, adds_9, inputs_12, outputs_9);
    return;
}

__device__ float dot_1(float3  x_9, float3  y_6)
{
    int i_4 = int(0);
    float result_5 = 0.0f;
    for(;;)
    {
        if(i_4 < int(3))
        {
        }
        else
        {
            break;
        }
        float result_6 = result_5 + _slang_vector_get_element(x_9, i_4) * _slang_vector_get_element(y_6, i_4);
        i_4 = i_4 + int(1);
        result_5 = result_6;
    }
    return result_5;
}

__device__ float length_0(float3  x_10)
{
    return (F32_sqrt((dot_1(x_10, x_10))));
}

__device__ float3  max_1(float3  x_11, float3  y_7)
{
    float3  result_7;
    int i_5 = int(0);
    for(;;)
    {
        if(i_5 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_7, i_5) = (F32_max((_slang_vector_get_element(x_11, i_5)), (_slang_vector_get_element(y_7, i_5))));
        i_5 = i_5 + int(1);
    }
    return result_7;
}

struct MLP_0
{
    FloatWeights_0 weights_13;
};

__device__ int layer_size_0(int inputs_13, int outputs_10)
{
    return whole_parts_0((outputs_10 + int(7)) / int(8)) + whole_parts_0((inputs_13 + int(7)) / int(8) * ((outputs_10 + int(4) - int(1)) / int(4) * int(4)));
}

__device__ void MLP_evaluate_0(MLP_0 * this_1, FixedArray<float, 11>  * inputs_14, FixedArray<float, 3>  * outputs_11)
{
    FixedArray<float, 25>  odd_0;
    FixedArray<float, 25>  even_0;
    dense_1(&this_1->weights_13, 0U, false, inputs_14, &even_0);
    int layer_0 = int(1);
    for(;;)
    {
        if(layer_0 < int(3))
        {
        }
        else
        {
            break;
        }
        int _S83 = layer_size_0(int(25), int(25));
        uint _S84 = uint(layer_size_0(int(11), int(25)) + (layer_0 - int(1)) * _S83);
        dense_2(&this_1->weights_13, _S84, false, &even_0, &odd_0);
        if((layer_0 + int(1)) < int(3))
        {
            dense_2(&this_1->weights_13, _S84 + uint(_S83), false, &odd_0, &even_0);
        }
        layer_0 = layer_0 + int(2);
    }
    uint _S85 = uint(layer_size_0(int(11), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_0(&this_1->weights_13, _S85, false, &even_0, outputs_11);
    return;
}

__device__ float3  normalize_0(float3  x_12)
{
    return x_12 / make_float3 (length_0(x_12));
}

__device__ float lerp_0(float x_13, float y_8, float s_0)
{
    return x_13 + (y_8 - x_13) * s_0;
}

__device__ float clamp_0(float x_14, float minBound_0, float maxBound_0)
{
    return (F32_min(((F32_max((x_14), (minBound_0)))), (maxBound_0)));
}

__device__ float saturate_0(float x_15)
{
    return clamp_0(x_15, 0.0f, 1.0f);
}

__device__ float2  frac_0(float2  x_16)
{
    float2  result_8;
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
        *_slang_vector_get_element_ptr(&result_8, i_6) = (F32_frac((_slang_vector_get_element(x_16, i_6))));
        i_6 = i_6 + int(1);
    }
    return result_8;
}

__device__ float2  clamp_1(float2  x_17, float2  minBound_1, float2  maxBound_1)
{
    return min_0(max_0(x_17, minBound_1), maxBound_1);
}

__device__ void MLP_evaluate_1(MLP_0 * this_2, FixedArray<float, 9>  * inputs_15, FixedArray<float, 1>  * outputs_12)
{
    FixedArray<float, 25>  odd_1;
    FixedArray<float, 25>  even_1;
    dense_4(&this_2->weights_13, 0U, false, inputs_15, &even_1);
    int layer_1 = int(1);
    for(;;)
    {
        if(layer_1 < int(3))
        {
        }
        else
        {
            break;
        }
        int _S86 = layer_size_0(int(25), int(25));
        uint _S87 = uint(layer_size_0(int(9), int(25)) + (layer_1 - int(1)) * _S86);
        dense_2(&this_2->weights_13, _S87, false, &even_1, &odd_1);
        if((layer_1 + int(1)) < int(3))
        {
            dense_2(&this_2->weights_13, _S87 + uint(_S86), false, &odd_1, &even_1);
        }
        layer_1 = layer_1 + int(2);
    }
    uint _S88 = uint(layer_size_0(int(9), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_3(&this_2->weights_13, _S88, false, &even_1, outputs_12);
    return;
}

__device__ float2  f16tof32_0(uint2  value_0)
{
    float2  result_9;
    int i_7 = int(0);
    for(;;)
    {
        if(i_7 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_9, i_7) = (__half2float(__ushort_as_half((_slang_vector_get_element(value_0, i_7)))));
        i_7 = i_7 + int(1);
    }
    return result_9;
}

__device__ float2  floor_0(float2  x_18)
{
    float2  result_10;
    int i_8 = int(0);
    for(;;)
    {
        if(i_8 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_10, i_8) = (F32_floor((_slang_vector_get_element(x_18, i_8))));
        i_8 = i_8 + int(1);
    }
    return result_10;
}

__device__ float3  cross_0(float3  left_0, float3  right_0)
{
    float _S89 = left_0.y;
    float _S90 = right_0.z;
    float _S91 = left_0.z;
    float _S92 = right_0.y;
    float _S93 = right_0.x;
    float _S94 = left_0.x;
    return make_float3 (_S89 * _S90 - _S91 * _S92, _S91 * _S93 - _S94 * _S90, _S94 * _S92 - _S89 * _S93);
}

__device__ Neumip_0 slang_ldg_0(Neumip_0 * ptr_0)
{
    uint _S95 = __ldg(&ptr_0->is_trained_0);
    uint _S96 = __ldg(&ptr_0->decoder_0);
    uint _S97 = __ldg(&ptr_0->has_offset_0);
    uint _S98 = __ldg(&ptr_0->offset_0);
    uint _S99 = __ldg(&ptr_0->offset_texels_0);
    uint _S100 = __ldg(&ptr_0->features_0);
    uint _S101 = __ldg(&ptr_0->texel_elements_0);
    uint _S102 = __ldg(&ptr_0->levels_2);
    float _S103 = __ldg(&ptr_0->last_level_1);
    uint _S104 = __ldg(&ptr_0->face_texels_0);
    uint _S105 = __ldg(&ptr_0->back_0);
    float _S106 = __ldg(&ptr_0->repeats_per_x_0);
    float _S107 = __ldg(&ptr_0->repeats_per_y_0);
    float _S108 = __ldg(&ptr_0->texels_per_mm_0);
    float _S109 = __ldg(&ptr_0->unit_x_0);
    float _S110 = __ldg(&ptr_0->unit_y_0);
    Neumip_0 _S111 = { _S95, _S96, _S97, _S98, _S99, _S100, _S101, _S102, _S103, _S104, _S105, _S106, _S107, _S108, _S109, _S110 };
    return _S111;
}

__device__ Vertex_0 slang_ldg_1(Vertex_0 * ptr_1)
{
    float _S112 = __ldg(&ptr_1->x_1);
    float _S113 = __ldg(&ptr_1->y_1);
    float _S114 = __ldg(&ptr_1->z_1);
    float _S115 = __ldg(&ptr_1->normal_x_0);
    float _S116 = __ldg(&ptr_1->normal_y_0);
    float _S117 = __ldg(&ptr_1->normal_z_0);
    float _S118 = __ldg(&ptr_1->u_0);
    float _S119 = __ldg(&ptr_1->v_0);
    Vertex_0 _S120 = { _S112, _S113, _S114, _S115, _S116, _S117, _S118, _S119 };
    return _S120;
}

__device__ float3  position_of_0(Vertex_0 * vertex_0)
{
    return make_float3 (vertex_0->x_1, vertex_0->y_1, vertex_0->z_1);
}

__device__ float square_0(float3  v_1)
{
    return dot_1(v_1, v_1);
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
    float3  face_normal_0;
    float2  uv_0;
    float2  draft_per_uv_0;
    float2  draft_0;
    float2  draft_dx_0;
    float2  draft_dy_0;
};

__device__ float3  to_local_0(VisiblePoint_0 * point_0, float3  direction_0)
{
    return make_float3 (dot_1(direction_0, point_0->axis_x_0), dot_1(direction_0, point_0->axis_y_0), dot_1(direction_0, point_0->normal_0));
}

__device__ float3  to_face_frame_0(float3  direction_1, bool back_1)
{
    float2  _S121 = float2 {direction_1.x, direction_1.y};
    float _S122;
    if(back_1)
    {
        _S122 = - direction_1.z;
    }
    else
    {
        _S122 = direction_1.z;
    }
    return make_float3 (_S121.x, _S121.y, _S122);
}

__device__ Eight_0 no_numbers_0()
{
    Eight_0 numbers_1;
    float4  _S123 = make_float4 (0.0f);
    (&numbers_1)->low_0 = _S123;
    (&numbers_1)->high_0 = _S123;
    return numbers_1;
}

__device__ Eight_0 eight_halves_0(uint4  packed_0)
{
    Eight_0 numbers_2;
    uint _S124 = packed_0.x;
    uint _S125 = packed_0.y;
    (&numbers_2)->low_0 = make_float4 (f16tof32_0(make_uint2 (_S124 & 65535U, _S124 >> 16U)).x, f16tof32_0(make_uint2 (_S124 & 65535U, _S124 >> 16U)).y, f16tof32_0(make_uint2 (_S125 & 65535U, _S125 >> 16U)).x, f16tof32_0(make_uint2 (_S125 & 65535U, _S125 >> 16U)).y);
    uint _S126 = packed_0.z;
    uint _S127 = packed_0.w;
    (&numbers_2)->high_0 = make_float4 (f16tof32_0(make_uint2 (_S126 & 65535U, _S126 >> 16U)).x, f16tof32_0(make_uint2 (_S126 & 65535U, _S126 >> 16U)).y, f16tof32_0(make_uint2 (_S127 & 65535U, _S127 >> 16U)).x, f16tof32_0(make_uint2 (_S127 & 65535U, _S127 >> 16U)).y);
    return numbers_2;
}

__device__ Eight_0 texel_numbers_0(uint first_11, uint elements_1, uint texel_0)
{
    uint _S128 = first_11 + texel_0 * elements_1;
    uint4  _S129 = __ldg((&(globalParams_0->packed_numbers_0)[_S128]));
    if(elements_1 == 1U)
    {
        return eight_halves_0(_S129);
    }
    Eight_0 numbers_3;
    (&numbers_3)->low_0 = asfloat_0(_S129);
    uint4  _S130 = __ldg((&(globalParams_0->packed_numbers_0)[_S128 + 1U]));
    (&numbers_3)->high_0 = asfloat_0(_S130);
    return numbers_3;
}

__device__ void add_bilinear_0(uint first_12, uint elements_2, uint start_1, uint columns_1, uint rows_1, float2  uv_1, float weight_0, Eight_0 * sums_3)
{
    float2  _S131 = uv_1 * make_float2 (float(columns_1), float(rows_1)) - make_float2 (0.5f);
    float2  _S132 = floor_0(_S131);
    float2  _S133 = _S131 - _S132;
    int _S134 = int(_S132.x);
    int _S135 = int(_S132.y);
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
        uint _S136 = tap_0 & 1U;
        uint _S137 = tap_0 >> int(1);
        Eight_0 _S138 = texel_numbers_0(first_12, elements_2, start_1 + (uint(_S135 + int(_S137)) & (rows_1 - 1U)) * columns_1 + (uint(_S134 + int(_S136)) & (columns_1 - 1U)));
        float _S139;
        if(_S137 != 0U)
        {
            _S139 = _S133.y;
        }
        else
        {
            _S139 = 1.0f - _S133.y;
        }
        float _S140;
        if(_S136 != 0U)
        {
            _S140 = _S133.x;
        }
        else
        {
            _S140 = 1.0f - _S133.x;
        }
        float _S141 = _S139 * _S140 * weight_0;
        sums_3->low_0 = sums_3->low_0 + make_float4 (_S141) * _S138.low_0;
        sums_3->high_0 = sums_3->high_0 + make_float4 (_S141) * _S138.high_0;
        tap_0 = tap_0 + 1U;
    }
    return;
}

__device__ float channel_0(Eight_0 * numbers_4, int k_0)
{
    float _S142;
    if(k_0 < int(4))
    {
        _S142 = *_slang_vector_get_element_ptr(&numbers_4->low_0, k_0);
    }
    else
    {
        _S142 = *_slang_vector_get_element_ptr(&numbers_4->high_0, k_0 - int(4));
    }
    return _S142;
}

__device__ float neumip_depth_0(Neumip_0 * model_0, float2  uv_2, float2  view_1, uint face_1)
{
    uint _S143 = model_0->levels_2;
    uint _S144 = __ldg((&(globalParams_0->words_0)[model_0->levels_2 + 1U]));
    uint _S145 = __ldg((&(globalParams_0->words_0)[_S143 + 2U]));
    Eight_0 texel_1 = no_numbers_0();
    add_bilinear_0(model_0->offset_texels_0, model_0->texel_elements_0, face_1 * _S144 * _S145, _S144, _S145, frac_0(uv_2), 1.0f, &texel_1);
    FixedArray<float, 9>  inputs_16;
    int k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(7))
        {
        }
        else
        {
            break;
        }
        Eight_0 _S146 = texel_1;
        float _S147 = channel_0(&_S146, k_1);
        inputs_16[k_1] = _S147;
        k_1 = k_1 + int(1);
    }
    inputs_16[int(7)] = view_1.x;
    inputs_16[int(8)] = view_1.y;
    MLP_0 network_1;
    (&(&network_1)->weights_13)->first_0 = model_0->offset_0;
    MLP_0 _S148 = network_1;
    FixedArray<float, 1>  depth_0;
    MLP_evaluate_1(&_S148, &inputs_16, &depth_0);
    return depth_0[int(0)];
}

__device__ float natural_logarithm_0(float x_19)
{
    uint _S149 = (F32_asuint((x_19)));
    float exponent_0 = float(int(_S149 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S149 & 8388607U) | 1056964608U)));
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
    float _S150 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S150 - exponent_1 * 0.00021219444170129f - 0.5f * _S150) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_20)
{
    return natural_logarithm_0(x_20) * 1.4426950216293335f;
}

__device__ Eight_0 neumip_texel_0(Neumip_0 * model_1, float2  uv_3, float level_1, uint face_2)
{
    float _S151 = clamp_0(level_1, 0.0f, model_1->last_level_1);
    float _S152 = clamp_0((F32_floor((_S151))), 0.0f, (F32_max((model_1->last_level_1 - 1.0f), (0.0f))));
    float _S153 = _S151 - _S152;
    float2  _S154 = clamp_1(frac_0(uv_3), make_float2 (0.0f), make_float2 (1.0f));
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
        float _S155;
        if(offset_1 == 0U)
        {
            _S155 = 1.0f - _S153;
        }
        else
        {
            _S155 = _S153;
        }
        if(_S155 <= 0.0f)
        {
            offset_1 = offset_1 + 1U;
            continue;
        }
        uint _S156 = model_1->levels_2 + 3U * (uint(_S152) + offset_1);
        uint _S157 = face_2 * model_1->face_texels_0;
        uint _S158 = __ldg((&(globalParams_0->words_0)[_S156]));
        uint _S159 = _S157 + _S158;
        uint _S160 = model_1->features_0;
        uint _S161 = model_1->texel_elements_0;
        uint _S162 = __ldg((&(globalParams_0->words_0)[_S156 + 1U]));
        uint _S163 = __ldg((&(globalParams_0->words_0)[_S156 + 2U]));
        add_bilinear_0(_S160, _S161, _S159, _S162, _S163, _S154, _S155, &texel_2);
        offset_1 = offset_1 + 1U;
    }
    return texel_2;
}

__device__ uint scramble_0(uint value_1)
{
    uint _S164 = value_1 * 747796405U + 2891336453U;
    uint _S165 = ((_S164 >> ((_S164 >> int(28)) + 4U)) ^ _S164) * 277803737U;
    return (_S165 >> int(22)) ^ _S165;
}

__device__ float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float2  pixel_sequence_0(uint2  pixel_0, uint index_0, uint stream_1)
{
    uint _S166 = pixel_0.x;
    uint _S167 = pixel_0.y;
    return frac_0(make_float2 (uniform_hash_0(_S166, _S167, stream_1), uniform_hash_0(_S166, _S167, stream_1 + 1U)) + make_float2 (float(index_0 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f));
}

__device__ float scene_number_0(uint index_1)
{
    uint _S168 = __ldg((&(globalParams_0->scene_words_0)[index_1]));
    return (U32_asfloat((_S168)));
}

struct Choice_0
{
    uint index_2;
    float remainder_0;
};

__device__ Choice_0 choose_0(uint table_0, uint count_1, float number_0)
{
    uint high_4 = count_1;
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
        uint _S169 = (low_4 + high_4) / 2U;
        if((scene_number_0(table_0 + _S169)) <= number_0)
        {
            low_4 = _S169;
        }
        else
        {
            high_4 = _S169;
        }
    }
    uint _S170 = table_0 + low_4;
    float _S171 = scene_number_0(_S170);
    float _S172 = scene_number_0(_S170 + 1U);
    Choice_0 choice_0;
    (&choice_0)->index_2 = low_4;
    (&choice_0)->remainder_0 = saturate_0((number_0 - _S171) / (F32_max((_S172 - _S171), (9.999999960041972e-13f))));
    return choice_0;
}

__device__ float mean_0(float3  colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

__device__ float2  sine_cosine_0(float x_21)
{
    float _S173 = (F32_floor((x_21 * 0.63661974668502808f + 0.5f)));
    float _S174 = x_21 - _S173 * 1.5703125f - _S173 * 0.00048375129699707f - _S173 * 7.54979012640433211e-08f;
    float _S175 = _S174 * _S174;
    float _S176 = ((-0.00019515295571182f * _S175 + 0.00833216123282909f) * _S175 - 0.16666655242443085f) * _S175 * _S174 + _S174;
    float _S177 = ((0.00002443315679557f * _S175 - 0.00138873164542019f) * _S175 + 0.04166664555668831f) * _S175 * _S175 - 0.5f * _S175 + 1.0f;
    uint _S178 = uint(int(_S173)) & 3U;
    float2  _S179;
    if((_S178 & 1U) != 0U)
    {
        _S179 = make_float2 (_S177, _S176);
    }
    else
    {
        _S179 = make_float2 (_S176, _S177);
    }
    float _S180;
    if((_S178 & 2U) != 0U)
    {
        _S180 = - _S179.x;
    }
    else
    {
        _S180 = _S179.x;
    }
    float _S181;
    if(((_S178 + 1U) & 2U) != 0U)
    {
        _S181 = - _S179.y;
    }
    else
    {
        _S181 = _S179.y;
    }
    return make_float2 (_S180, _S181);
}

__device__ Light_0 slang_ldg_2(Light_0 * ptr_2)
{
    uint _S182 = __ldg(&ptr_2->is_point_0);
    float _S183 = __ldg(&ptr_2->x_0);
    float _S184 = __ldg(&ptr_2->y_0);
    float _S185 = __ldg(&ptr_2->z_0);
    float _S186 = __ldg(&ptr_2->red_0);
    float _S187 = __ldg(&ptr_2->green_0);
    float _S188 = __ldg(&ptr_2->blue_0);
    Light_0 _S189 = { _S182, _S183, _S184, _S185, _S186, _S187, _S188 };
    return _S189;
}

__device__ void accumulate_0(uint index_3, float4  light_0)
{
    float4  * _S190 = (&(globalParams_0->radiance_0)[index_3]);
    *_S190 = *_S190 + make_float4 ((&(globalParams_0->layers_0)[index_3])->share_0) * light_0;
    (&(globalParams_0->layers_0)[index_3])->share_0 = (&(globalParams_0->layers_0)[index_3])->share_0 * (1.0f - light_0.w);
    return;
}

__device__ float3  camera_right_0(int _S191)
{
    Frame_0 * _S192 = (&(globalParams_0->frames_0)[_S191]);
    float _S193 = __ldg(&_S192->right_x_0);
    float _S194 = __ldg(&_S192->right_y_0);
    float _S195 = __ldg(&_S192->right_z_0);
    return make_float3 (_S193, _S194, _S195);
}

__device__ float3  camera_up_0(int _S196)
{
    Frame_0 * _S197 = (&(globalParams_0->frames_0)[_S196]);
    float _S198 = __ldg(&_S197->up_x_0);
    float _S199 = __ldg(&_S197->up_y_0);
    float _S200 = __ldg(&_S197->up_z_0);
    return make_float3 (_S198, _S199, _S200);
}

__device__ float3  camera_forward_0(int _S201)
{
    Frame_0 * _S202 = (&(globalParams_0->frames_0)[_S201]);
    float _S203 = __ldg(&_S202->forward_x_0);
    float _S204 = __ldg(&_S202->forward_y_0);
    float _S205 = __ldg(&_S202->forward_z_0);
    return make_float3 (_S203, _S204, _S205);
}

__device__ float3  camera_origin_0(int _S206)
{
    Frame_0 * _S207 = (&(globalParams_0->frames_0)[_S206]);
    float _S208 = __ldg(&_S207->origin_x_0);
    float _S209 = __ldg(&_S207->origin_y_0);
    float _S210 = __ldg(&_S207->origin_z_0);
    return make_float3 (_S208, _S209, _S210);
}

__device__ VisiblePoint_0 face_point_0(uint _S211, uint _S212, float _S213, float _S214)
{
    Fabric_0 * _S215 = (&(globalParams_0->fabrics_0)[_S211]);
    uint _S216 = 3U * _S212;
    uint _S217 = __ldg((&(globalParams_0->corners_0)[_S216]));
    Vertex_0 _S218 = slang_ldg_1((&(globalParams_0->vertices_0)[_S217]));
    uint _S219 = __ldg((&(globalParams_0->corners_0)[_S216 + 1U]));
    Vertex_0 _S220 = slang_ldg_1((&(globalParams_0->vertices_0)[_S219]));
    uint _S221 = __ldg((&(globalParams_0->corners_0)[_S216 + 2U]));
    Vertex_0 _S222 = slang_ldg_1((&(globalParams_0->vertices_0)[_S221]));
    Vertex_0 _S223 = _S220;
    float3  _S224 = position_of_0(&_S223);
    Vertex_0 _S225 = _S218;
    float3  _S226 = position_of_0(&_S225);
    float3  _S227 = _S224 - _S226;
    Vertex_0 _S228 = _S222;
    float3  _S229 = position_of_0(&_S228);
    float3  _S230 = _S229 - _S226;
    float _S231 = _S220.u_0 - _S218.u_0;
    float _S232 = _S220.v_0 - _S218.v_0;
    float2  _S233 = make_float2 (_S231, _S232);
    float _S234 = _S222.u_0 - _S218.u_0;
    float _S235 = _S222.v_0 - _S218.v_0;
    float2  _S236 = make_float2 (_S234, _S235);
    float _S237;
    if((_S231 * _S235 - _S232 * _S234) < 0.0f)
    {
        _S237 = -1.0f;
    }
    else
    {
        _S237 = 1.0f;
    }
    float3  _S238 = make_float3 (_S237) * (make_float3 (_S235) * _S227 - make_float3 (_S232) * _S230);
    float3  _S239 = make_float3 (_S237) * (make_float3 (_S231) * _S230 - make_float3 (_S234) * _S227);
    VisiblePoint_0 point_1;
    float _S240 = 1.0f - _S213 - _S214;
    Vertex_0 _S241 = _S218;
    float3  _S242 = normal_of_0(&_S241);
    float3  _S243 = make_float3 (_S240) * _S242;
    Vertex_0 _S244 = _S220;
    float3  _S245 = normal_of_0(&_S244);
    float3  _S246 = _S243 + make_float3 (_S213) * _S245;
    Vertex_0 _S247 = _S222;
    float3  _S248 = normal_of_0(&_S247);
    float3  _S249 = normalize_0(_S246 + make_float3 (_S214) * _S248);
    (&point_1)->normal_0 = _S249;
    float3  _S250 = normalize_0(_S238 - _S249 * make_float3 (dot_1(_S249, _S238)));
    (&point_1)->axis_x_0 = _S250;
    (&point_1)->axis_y_0 = cross_0(_S249, _S250);
    float3  _S251 = normalize_0(cross_0(_S227, _S230));
    float3  _S252;
    if((dot_1(_S251, _S249)) < 0.0f)
    {
        _S252 = - _S251;
    }
    else
    {
        _S252 = _S251;
    }
    (&point_1)->face_normal_0 = _S252;
    (&point_1)->position_0 = _S226 + make_float3 (_S213) * _S227 + make_float3 (_S214) * _S230;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_0 = make_float2 (_S218.u_0, _S218.v_0) + make_float2 (_S213) * _S233 + make_float2 (_S214) * _S236;
    bool _S253 = (dot_1(cross_0(_S238, _S239), (&point_1)->normal_0)) < 0.0f;
    float _S254 = __ldg(&_S215->uv_width_0);
    if(_S253)
    {
        float _S255 = __ldg(&_S215->uv_height_0);
        _S237 = - _S255;
    }
    else
    {
        float _S256 = __ldg(&_S215->uv_height_0);
        _S237 = _S256;
    }
    float2  _S257 = make_float2 (_S254, _S237);
    (&point_1)->draft_per_uv_0 = _S257;
    float2  _S258 = (&point_1)->uv_0 * _S257;
    if(_S253)
    {
        float _S259 = __ldg(&_S215->uv_height_0);
        _S237 = _S259;
    }
    else
    {
        _S237 = 0.0f;
    }
    (&point_1)->draft_0 = _S258 + make_float2 (0.0f, _S237);
    float2  _S260 = make_float2 (0.0f);
    (&point_1)->draft_dx_0 = _S260;
    (&point_1)->draft_dy_0 = _S260;
    return point_1;
}

__device__ VisiblePoint_0 visible_point_0(int _S261, uint _S262, uint _S263, uint2  _S264)
{
    Frame_0 * _S265 = (&(globalParams_0->frames_0)[_S261]);
    uint _S266 = 3U * _S263;
    uint _S267 = __ldg((&(globalParams_0->corners_0)[_S266]));
    Vertex_0 _S268 = slang_ldg_1((&(globalParams_0->vertices_0)[_S267]));
    uint _S269 = __ldg((&(globalParams_0->corners_0)[_S266 + 1U]));
    Vertex_0 _S270 = slang_ldg_1((&(globalParams_0->vertices_0)[_S269]));
    uint _S271 = __ldg((&(globalParams_0->corners_0)[_S266 + 2U]));
    Vertex_0 _S272 = slang_ldg_1((&(globalParams_0->vertices_0)[_S271]));
    Vertex_0 _S273 = _S270;
    float3  _S274 = position_of_0(&_S273);
    Vertex_0 _S275 = _S268;
    float3  _S276 = position_of_0(&_S275);
    float3  _S277 = _S274 - _S276;
    Vertex_0 _S278 = _S272;
    float3  _S279 = position_of_0(&_S278);
    float3  _S280 = _S279 - _S276;
    float3  _S281 = cross_0(_S277, _S280);
    float _S282 = 1.0f / (F32_max((square_0(_S281)), (1.00000000317107685e-30f)));
    float3  _S283 = camera_right_0(_S261);
    uint _S284 = __ldg(&_S265->width_0);
    float _S285 = float(_S284);
    float3  _S286 = _S283 * make_float3 (2.0f / _S285);
    float3  _S287 = camera_up_0(_S261);
    uint _S288 = __ldg(&_S265->height_0);
    float _S289 = float(_S288);
    float3  _S290 = _S287 * make_float3 (-2.0f / _S289);
    float _S291 = float(_S264.x) + 0.5f - 0.5f * _S285;
    float _S292 = float(_S264.y) + 0.5f - 0.5f * _S289;
    float3  _S293 = camera_forward_0(_S261);
    float3  _S294 = _S293 + make_float3 (_S291) * _S286 + make_float3 (_S292) * _S290;
    float _S295 = dot_1(_S294, _S281);
    float _S296;
    if((F32_abs((_S295))) > 1.00000000317107685e-30f)
    {
        _S296 = _S295;
    }
    else
    {
        _S296 = 1.00000000317107685e-30f;
    }
    float _S297 = 1.0f / _S296;
    float3  _S298 = camera_origin_0(_S261);
    float3  _S299 = _S276 - _S298;
    float _S300 = dot_1(_S299, _S281) * _S297;
    float3  _S301 = _S294 * make_float3 (_S300) - _S299;
    float3  _S302 = make_float3 (_S300) * (_S286 - _S294 * make_float3 (dot_1(_S286, _S281) * _S297));
    float3  _S303 = make_float3 (_S300) * (_S290 - _S294 * make_float3 (dot_1(_S290, _S281) * _S297));
    float3  _S304 = cross_0(_S280, _S281) * make_float3 (_S282);
    float3  _S305 = cross_0(_S281, _S277) * make_float3 (_S282);
    float2  _S306 = make_float2 (_S270.u_0 - _S268.u_0, _S270.v_0 - _S268.v_0);
    float2  _S307 = make_float2 (_S272.u_0 - _S268.u_0, _S272.v_0 - _S268.v_0);
    VisiblePoint_0 _S308 = face_point_0(_S262, _S263, dot_1(_S301, _S304), dot_1(_S301, _S305));
    VisiblePoint_0 point_2 = _S308;
    (&point_2)->position_0 = _S276 + _S301;
    (&point_2)->view_0 = - normalize_0(_S294);
    (&point_2)->draft_dx_0 = (make_float2 (dot_1(_S302, _S304)) * _S306 + make_float2 (dot_1(_S302, _S305)) * _S307) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (make_float2 (dot_1(_S303, _S304)) * _S306 + make_float2 (dot_1(_S303, _S305)) * _S307) * (&point_2)->draft_per_uv_0;
    return point_2;
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

struct NeumipView_0
{
    FixedArray<float, 7>  latent_0;
    float2  view_2;
    bool back_2;
};

__device__ void neumip_view_0(uint _S309, Footprint_0 * _S310, float3  _S311, NeumipView_0 * _S312)
{
    Neumip_0 _S313 = slang_ldg_0(&(&(globalParams_0->fabrics_0)[_S309])->neumip_0);
    bool _S314 = (_S311.z) < 0.0f;
    uint _S315;
    if(_S314)
    {
        _S315 = _S313.back_0;
    }
    else
    {
        _S315 = 0U;
    }
    float3  _S316 = to_face_frame_0(_S311, _S314);
    float2  uv_4 = _S310->centre_0 * make_float2 (_S313.repeats_per_x_0, _S313.repeats_per_y_0);
    float2  uv_5;
    if((_S313.has_offset_0) != 0U)
    {
        float2  _S317 = float2 {_S316.x, _S316.y};
        Neumip_0 _S318 = _S313;
        float _S319 = neumip_depth_0(&_S318, uv_4, _S317, _S315);
        uv_5 = uv_4 + make_float2 (_S319 / (F32_max((_S316.z), (0.60000002384185791f)))) * _S317 * make_float2 (_S313.unit_x_0, _S313.unit_y_0);
    }
    else
    {
        uv_5 = uv_4;
    }
    float _S320 = binary_logarithm_0((F32_max(((F32_sqrt(((F32_abs((_S310->dx_0.x * _S310->dy_0.y - _S310->dx_0.y * _S310->dy_0.x)))))) * _S313.texels_per_mm_0), (9.99999971718068537e-10f))));
    Neumip_0 _S321 = _S313;
    Eight_0 _S322 = neumip_texel_0(&_S321, uv_5, _S320, _S315);
    int k_2 = int(0);
    for(;;)
    {
        if(k_2 < int(7))
        {
        }
        else
        {
            break;
        }
        Eight_0 _S323 = _S322;
        float _S324 = channel_0(&_S323, k_2);
        _S312->latent_0[k_2] = _S324;
        k_2 = k_2 + int(1);
    }
    _S312->view_2 = float2 {_S316.x, _S316.y};
    _S312->back_2 = _S314;
    return;
}

__device__ uint light_sample_count_0(int _S325)
{
    Frame_0 * _S326 = (&(globalParams_0->frames_0)[_S325]);
    uint _S327 = __ldg(&_S326->lights_0);
    uint _S328 = __ldg(&_S326->environment_samples_0);
    return _S327 + _S328;
}

__device__ float visibility_at_0(int _S329, uint _S330, uint2  _S331)
{
    Frame_0 * _S332 = (&(globalParams_0->frames_0)[_S329]);
    uint _S333 = __ldg(&_S332->casts_shadows_0);
    if(_S333 == 0U)
    {
        return 1.0f;
    }
    uint _S334 = __ldg(&_S332->height_0);
    uint _S335 = _S330 * _S334 + _S331.y;
    uint _S336 = __ldg(&_S332->width_0);
    return *(&(globalParams_0->visibilities_0)[_S335 * _S336 + _S331.x]);
}

struct LightSample_0
{
    float3  towards_0;
    float3  irradiance_1;
    float distance_0;
};

__device__ float3  environment_texel_0(int _S337, uint _S338, uint _S339)
{
    Frame_0 * _S340 = (&(globalParams_0->frames_0)[_S337]);
    uint _S341 = __ldg(&_S340->environment_table_0);
    uint _S342 = __ldg(&_S340->environment_rows_0);
    uint _S343 = _S341 + _S342 + 1U;
    uint _S344 = __ldg(&_S340->environment_columns_0);
    uint _S345 = _S343 + _S342 * (_S344 + 1U) + 3U * (_S338 * _S344 + _S339);
    return make_float3 (scene_number_0(_S345), scene_number_0(_S345 + 1U), scene_number_0(_S345 + 2U));
}

__device__ float3  sample_environment_0(int _S346, float2  _S347, float3  * _S348)
{
    Frame_0 * _S349 = (&(globalParams_0->frames_0)[_S346]);
    uint _S350 = __ldg(&_S349->environment_table_0);
    uint _S351 = __ldg(&_S349->environment_rows_0);
    Choice_0 _S352 = choose_0(_S350, _S351, _S347.y);
    uint _S353 = _S350 + _S351 + 1U;
    uint _S354 = __ldg(&_S349->environment_columns_0);
    Choice_0 _S355 = choose_0(_S353 + _S352.index_2 * (_S354 + 1U), _S354, _S347.x);
    float3  _S356 = environment_texel_0(_S346, _S352.index_2, _S355.index_2);
    float _S357 = __ldg(&_S349->environment_total_0);
    *_S348 = _S356 * make_float3 (_S357 / (F32_max((mean_0(_S356)), (9.99999968265522539e-21f))));
    float _S358 = 3.14159274101257324f / float(_S351);
    float _S359 = lerp_0(sine_cosine_0(float(_S352.index_2) * _S358).y, sine_cosine_0(float(_S352.index_2 + 1U) * _S358).y, _S352.remainder_0);
    float _S360 = (F32_sqrt(((F32_max((1.0f - _S359 * _S359), (0.0f))))));
    float2  _S361 = sine_cosine_0((float(_S355.index_2) + _S355.remainder_0) * (6.28318548202514648f / float(_S354)));
    float _S362 = _S360 * _S361.x;
    float _S363 = - _S360 * _S361.y;
    float _S364 = __ldg(&_S349->environment_cosine_0);
    float _S365 = _S364 * _S362;
    float _S366 = __ldg(&_S349->environment_sine_0);
    return make_float3 (_S365 + _S366 * _S363, _S359, _S364 * _S363 - _S366 * _S362);
}

__device__ LightSample_0 light_sample_0(int _S367, uint _S368, uint2  _S369, float3  _S370)
{
    Frame_0 * _S371 = (&(globalParams_0->frames_0)[_S367]);
    LightSample_0 sample_0;
    (&sample_0)->distance_0 = 1.00000001504746622e+30f;
    uint _S372 = __ldg(&_S371->lights_0);
    if(_S368 >= _S372)
    {
        uint _S373 = __ldg(&_S371->pass_number_0);
        uint _S374 = __ldg(&_S371->environment_samples_0);
        float3  weight_1;
        float3  _S375 = sample_environment_0(_S367, pixel_sequence_0(_S369, _S373 * _S374 + (_S368 - _S372), 3U), &weight_1);
        (&sample_0)->towards_0 = _S375;
        (&sample_0)->irradiance_1 = weight_1 / make_float3 (float(_S374));
        return sample_0;
    }
    Light_0 _S376 = slang_ldg_2((&(globalParams_0->lights_1)[_S368]));
    (&sample_0)->irradiance_1 = make_float3 (_S376.red_0, _S376.green_0, _S376.blue_0);
    (&sample_0)->towards_0 = make_float3 (_S376.x_0, _S376.y_0, _S376.z_0);
    if((_S376.is_point_0) != 0U)
    {
        float3  _S377 = (&sample_0)->towards_0 - _S370;
        float _S378 = (F32_max((square_0(_S377)), (9.999999960041972e-13f)));
        (&sample_0)->distance_0 = (F32_sqrt((_S378)));
        (&sample_0)->irradiance_1 = (&sample_0)->irradiance_1 / make_float3 (_S378);
        (&sample_0)->towards_0 = normalize_0(_S377);
    }
    return sample_0;
}

__device__ float3  neumip_value_0(uint _S379, NeumipView_0 * _S380, float3  _S381)
{
    Fabric_0 * _S382 = (&(globalParams_0->fabrics_0)[_S379]);
    float3  _S383 = to_face_frame_0(_S381, _S380->back_2);
    if((_S383.z) <= 0.0f)
    {
        return make_float3 (0.0f);
    }
    FixedArray<float, 11>  inputs_17;
    int k_3 = int(0);
    for(;;)
    {
        if(k_3 < int(7))
        {
        }
        else
        {
            break;
        }
        inputs_17[k_3] = _S380->latent_0[k_3];
        k_3 = k_3 + int(1);
    }
    inputs_17[int(7)] = _S383.x;
    inputs_17[int(8)] = _S383.y;
    inputs_17[int(9)] = _S380->view_2.x;
    inputs_17[int(10)] = _S380->view_2.y;
    MLP_0 network_2;
    Neumip_0 _S384 = slang_ldg_0(&_S382->neumip_0);
    (&(&network_2)->weights_13)->first_0 = _S384.decoder_0;
    MLP_0 _S385 = network_2;
    FixedArray<float, 3>  outputs_13;
    MLP_evaluate_0(&_S385, &inputs_17, &outputs_13);
    return max_1(make_float3 (outputs_13[int(0)], outputs_13[int(1)], outputs_13[int(2)]), make_float3 (0.0f)) * make_float3 (0.31830987334251404f);
}

__device__ float4  light_of_neumip_0(int _S386, uint _S387, VisiblePoint_0 * _S388, uint2  _S389)
{
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = _S388->draft_0;
    (&footprint_0)->dx_0 = _S388->draft_dx_0;
    (&footprint_0)->dy_0 = _S388->draft_dy_0;
    float3  _S390 = to_local_0(_S388, _S388->view_0);
    Footprint_0 _S391 = footprint_0;
    NeumipView_0 seen_0;
    neumip_view_0(_S387, &_S391, _S390, &seen_0);
    float3  _S392 = make_float3 (0.0f);
    uint number_1 = 0U;
    float3  radiance_1 = _S392;
    for(;;)
    {
        uint _S393 = light_sample_count_0(_S386);
        if(number_1 < _S393)
        {
        }
        else
        {
            break;
        }
        float _S394 = visibility_at_0(_S386, number_1, _S389);
        if(_S394 <= 0.0f)
        {
            number_1 = number_1 + 1U;
            continue;
        }
        LightSample_0 _S395 = light_sample_0(_S386, number_1, _S389, _S388->position_0);
        float3  _S396 = make_float3 (_S394) * _S395.irradiance_1;
        float3  _S397 = to_local_0(_S388, _S395.towards_0);
        float3  _S398 = neumip_value_0(_S387, &seen_0, _S397);
        radiance_1 = radiance_1 + _S396 * _S398;
        number_1 = number_1 + 1U;
    }
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f);
}

extern "C" __global__ void shade_neumip()
{
    uint3  _S399 = blockIdx * blockDim + threadIdx;
    Frame_0 * _S400 = (&(globalParams_0->frames_0)[int(0)]);
    uint _S401 = _S399.x;
    uint _S402 = __ldg(&_S400->width_0);
    bool _S403;
    if(_S401 >= _S402)
    {
        _S403 = true;
    }
    else
    {
        uint _S404 = _S399.y;
        uint _S405 = __ldg(&_S400->height_0);
        _S403 = _S404 >= _S405;
    }
    if(_S403)
    {
        return;
    }
    uint _S406 = _S399.y * _S402 + _S401;
    uint _S407 = (&(globalParams_0->layers_0)[_S406])->face_0;
    if(((&(globalParams_0->layers_0)[_S406])->face_0) == 0U)
    {
        return;
    }
    uint _S408 = _S407 - 1U;
    uint _S409 = __ldg((&(globalParams_0->face_fabrics_0)[_S408]));
    uint2  _S410 = uint2 {_S399.x, _S399.y};
    VisiblePoint_0 _S411 = visible_point_0(int(0), _S409, _S408, _S410);
    VisiblePoint_0 _S412 = _S411;
    float4  _S413 = light_of_neumip_0(int(0), _S409, &_S412, _S410);
    accumulate_0(_S406, _S413);
    return;
}

