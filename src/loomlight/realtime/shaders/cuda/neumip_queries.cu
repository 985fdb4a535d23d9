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

struct Neural_0
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
    uint transmits_0;
    uint transmission_0;
    uint has_holes_0;
    uint opacity_0;
};

struct Latent_0
{
    uint is_trained_1;
    uint decoder_1;
    uint hidden_0;
    uint frames_0;
    uint sampler_0;
    uint albedo_0;
    uint texels_1;
    uint texel_elements_1;
    uint levels_3;
    float last_level_2;
    uint face_texels_1;
    uint back_1;
    float repeats_per_x_1;
    float repeats_per_y_1;
    float texels_per_mm_1;
    float width_0;
    float height_0;
    uint is_trilinear_0;
};

struct Clustered_0
{
    uint is_baked_1;
    uint clusters_0;
    uint rank_0;
    uint channels_0;
    uint columns_0;
    uint rows_0;
    float texel_width_0;
    float texel_height_0;
    uint samples_0;
    uint sums_0;
    uint labels_0;
    uint coefficients_0;
    uint basis_0;
    uint moments_1;
    uint light_0;
    uint view_0;
    uint offset_1;
    uint trust_0;
};

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Neural_0 neural_0;
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
    uint has_detail_0;
    float uv_width_0;
    float uv_height_0;
    uint is_open_0;
    uint openness_0;
    uint albedo_map_0;
    uint albedo_map_levels_0;
    uint has_yarns_0;
    float mean_hole_0;
    Latent_0 latent_0;
    Clustered_0 clustered_0;
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
    float has_plies_0;
    float plies_per_mm_0;
    float ply_sine_0;
    float ply_cosine_0;
    float fibre_tilt_0;
    float fibre_tone_0;
    float slub_0;
    float slubs_per_mm_0;
    float per_half_width_0;
    float hairiness_0;
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
    uint width_1;
    uint height_1;
    uint lights_0;
    uint samples_1;
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
    uint columns_1;
    uint rows_1;
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
    uint clusters_1;
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

struct Query_0
{
    uint fabric_1;
    float centre_x_0;
    float centre_y_0;
    float dx_x_0;
    float dx_y_0;
    float dy_x_0;
    float dy_y_0;
    float light_x_0;
    float light_y_0;
    float light_z_0;
    float view_x_0;
    float view_y_0;
    float view_z_0;
    uint seed_1;
};

struct GlobalParams_0
{
    StructuredBuffer<Fabric_0> fabrics_0;
    StructuredBuffer<Family_0> families_0;
    StructuredBuffer<uint> words_0;
    StructuredBuffer<Light_0> lights_1;
    StructuredBuffer<Frame_0> frames_1;
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
    StructuredBuffer<Query_0> queries_0;
    StructuredBuffer<uint> query_count_0;
    RWStructuredBuffer<float4 > answers_0;
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
    float4  sums_1 = make_float4 (0.0f);
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
        *&((&sums_1)->x) = *&((&sums_1)->x) + (dot_0(_S8.low_0, low_1) + dot_0(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 4U + column_0);
        *&((&sums_1)->y) = *&((&sums_1)->y) + (dot_0(_S9.low_0, low_1) + dot_0(_S9.high_0, high_1));
        Eight_0 _S10 = FloatWeights_eight_0(weights_0, row_0 + 8U + column_0);
        *&((&sums_1)->z) = *&((&sums_1)->z) + (dot_0(_S10.low_0, low_1) + dot_0(_S10.high_0, high_1));
        Eight_0 _S11 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        *&((&sums_1)->w) = *&((&sums_1)->w) + (dot_0(_S11.low_0, low_1) + dot_0(_S11.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_1;
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
    float4  sums_2 = make_float4 (0.0f);
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
        *&((&sums_2)->x) = *&((&sums_2)->x) + (dot_0(_S27.low_0, low_2) + dot_0(_S27.high_0, high_2));
        Eight_0 _S28 = FloatWeights_eight_0(weights_2, row_1 + 2U + column_1);
        *&((&sums_2)->y) = *&((&sums_2)->y) + (dot_0(_S28.low_0, low_2) + dot_0(_S28.high_0, high_2));
        Eight_0 _S29 = FloatWeights_eight_0(weights_2, row_1 + 4U + column_1);
        *&((&sums_2)->z) = *&((&sums_2)->z) + (dot_0(_S29.low_0, low_2) + dot_0(_S29.high_0, high_2));
        Eight_0 _S30 = FloatWeights_eight_0(weights_2, row_1 + 6U + column_1);
        *&((&sums_2)->w) = *&((&sums_2)->w) + (dot_0(_S30.low_0, low_2) + dot_0(_S30.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_2;
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

__device__ float4  tile_product_2(FloatWeights_0 * weights_6, uint row_2, FixedArray<float, 16>  * inputs_6)
{
    float4  sums_3 = make_float4 (0.0f);
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
        int _S42 = int(8U * column_2);
        *&((&low_3)->x) = (*inputs_6)[_S42];
        *&((&high_3)->x) = (*inputs_6)[_S42 + int(4)];
        int _S43 = _S42 + int(1);
        *&((&low_3)->y) = (*inputs_6)[_S43];
        *&((&high_3)->y) = (*inputs_6)[_S43 + int(4)];
        int _S44 = _S42 + int(2);
        *&((&low_3)->z) = (*inputs_6)[_S44];
        *&((&high_3)->z) = (*inputs_6)[_S44 + int(4)];
        int _S45 = _S42 + int(3);
        *&((&low_3)->w) = (*inputs_6)[_S45];
        *&((&high_3)->w) = (*inputs_6)[_S45 + int(4)];
        Eight_0 _S46 = FloatWeights_eight_0(weights_6, row_2 + column_2);
        *&((&sums_3)->x) = *&((&sums_3)->x) + (dot_0(_S46.low_0, low_3) + dot_0(_S46.high_0, high_3));
        Eight_0 _S47 = FloatWeights_eight_0(weights_6, row_2 + 2U + column_2);
        *&((&sums_3)->y) = *&((&sums_3)->y) + (dot_0(_S47.low_0, low_3) + dot_0(_S47.high_0, high_3));
        Eight_0 _S48 = FloatWeights_eight_0(weights_6, row_2 + 4U + column_2);
        *&((&sums_3)->z) = *&((&sums_3)->z) + (dot_0(_S48.low_0, low_3) + dot_0(_S48.high_0, high_3));
        Eight_0 _S49 = FloatWeights_eight_0(weights_6, row_2 + 6U + column_2);
        *&((&sums_3)->w) = *&((&sums_3)->w) + (dot_0(_S49.low_0, low_3) + dot_0(_S49.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_3;
}

__device__ void dense_part_2(FloatWeights_0 * weights_7, uint first_5, bool adds_4, FixedArray<float, 16>  * inputs_7, FixedArray<float, 16>  * outputs_4)
{
    uint _S50 = first_5 + uint(whole_parts_0(int(2)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S51 = output_2 < int(16);
        if(_S51)
        {
        }
        else
        {
            break;
        }
        uint _S52 = uint(output_2);
        Eight_0 _S53 = FloatWeights_eight_0(weights_7, first_5 + _S52 / 8U);
        float4  _S54 = tile_product_2(weights_7, _S50 + _S52 * 2U, inputs_7);
        float4  _S55;
        if((output_2 & int(4)) != int(0))
        {
            _S55 = _S53.high_0;
        }
        else
        {
            _S55 = _S53.low_0;
        }
        float4  _S56 = _S54 + _S55;
        float _S57;
        if(_S51)
        {
            if(adds_4)
            {
                _S57 = (*outputs_4)[output_2];
            }
            else
            {
                _S57 = 0.0f;
            }
            (*outputs_4)[output_2] = Relu_apply_0(_S56.x + _S57);
        }
        int _S58 = output_2 + int(1);
        if(_S58 < int(16))
        {
            if(adds_4)
            {
                _S57 = (*outputs_4)[_S58];
            }
            else
            {
                _S57 = 0.0f;
            }
            (*outputs_4)[_S58] = Relu_apply_0(_S56.y + _S57);
        }
        int _S59 = output_2 + int(2);
        if(_S59 < int(16))
        {
            if(adds_4)
            {
                _S57 = (*outputs_4)[_S59];
            }
            else
            {
                _S57 = 0.0f;
            }
            (*outputs_4)[_S59] = Relu_apply_0(_S56.z + _S57);
        }
        int _S60 = output_2 + int(3);
        if(_S60 < int(16))
        {
            if(adds_4)
            {
                _S57 = (*outputs_4)[_S60];
            }
            else
            {
                _S57 = 0.0f;
            }
            (*outputs_4)[_S60] = Relu_apply_0(_S56.w + _S57);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

__device__ void dense_part_3(FloatWeights_0 * weights_8, uint first_6, bool adds_5, FixedArray<float, 16>  * inputs_8, FixedArray<float, 1>  * outputs_5)
{
    uint _S61 = first_6 + uint(whole_parts_0(int(1)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S62 = output_3 < int(1);
        if(_S62)
        {
        }
        else
        {
            break;
        }
        uint _S63 = uint(output_3);
        Eight_0 _S64 = FloatWeights_eight_0(weights_8, first_6 + _S63 / 8U);
        float4  _S65 = tile_product_2(weights_8, _S61 + _S63 * 2U, inputs_8);
        float4  _S66;
        if((output_3 & int(4)) != int(0))
        {
            _S66 = _S64.high_0;
        }
        else
        {
            _S66 = _S64.low_0;
        }
        float4  _S67 = _S65 + _S66;
        float _S68;
        if(_S62)
        {
            if(adds_5)
            {
                _S68 = (*outputs_5)[output_3];
            }
            else
            {
                _S68 = 0.0f;
            }
            (*outputs_5)[output_3] = Identity_apply_0(_S67.x + _S68);
        }
        int _S69 = output_3 + int(1);
        if(_S69 < int(1))
        {
            if(adds_5)
            {
                _S68 = (*outputs_5)[_S69];
            }
            else
            {
                _S68 = 0.0f;
            }
            (*outputs_5)[_S69] = Identity_apply_0(_S67.y + _S68);
        }
        int _S70 = output_3 + int(2);
        if(_S70 < int(1))
        {
            if(adds_5)
            {
                _S68 = (*outputs_5)[_S70];
            }
            else
            {
                _S68 = 0.0f;
            }
            (*outputs_5)[_S70] = Identity_apply_0(_S67.z + _S68);
        }
        int _S71 = output_3 + int(3);
        if(_S71 < int(1))
        {
            if(adds_5)
            {
                _S68 = (*outputs_5)[_S71];
            }
            else
            {
                _S68 = 0.0f;
            }
            (*outputs_5)[_S71] = Identity_apply_0(_S67.w + _S68);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

__device__ float4  tile_product_3(FloatWeights_0 * weights_9, uint row_3, FixedArray<float, 9>  * inputs_9)
{
    float4  sums_4 = make_float4 (0.0f);
    uint column_3 = 0U;
    for(;;)
    {
        if(column_3 < 2U)
        {
        }
        else
        {
            break;
        }
        float4  low_4;
        float4  high_4;
        int _S72 = int(8U * column_3);
        *&((&low_4)->x) = (*inputs_9)[(I32_min((_S72), (int(8))))];
        *&((&high_4)->x) = (*inputs_9)[(I32_min((_S72 + int(4)), (int(8))))];
        int _S73 = _S72 + int(1);
        *&((&low_4)->y) = (*inputs_9)[(I32_min((_S73), (int(8))))];
        *&((&high_4)->y) = (*inputs_9)[(I32_min((_S73 + int(4)), (int(8))))];
        int _S74 = _S72 + int(2);
        *&((&low_4)->z) = (*inputs_9)[(I32_min((_S74), (int(8))))];
        *&((&high_4)->z) = (*inputs_9)[(I32_min((_S74 + int(4)), (int(8))))];
        int _S75 = _S72 + int(3);
        *&((&low_4)->w) = (*inputs_9)[(I32_min((_S75), (int(8))))];
        *&((&high_4)->w) = (*inputs_9)[(I32_min((_S75 + int(4)), (int(8))))];
        Eight_0 _S76 = FloatWeights_eight_0(weights_9, row_3 + column_3);
        *&((&sums_4)->x) = *&((&sums_4)->x) + (dot_0(_S76.low_0, low_4) + dot_0(_S76.high_0, high_4));
        Eight_0 _S77 = FloatWeights_eight_0(weights_9, row_3 + 2U + column_3);
        *&((&sums_4)->y) = *&((&sums_4)->y) + (dot_0(_S77.low_0, low_4) + dot_0(_S77.high_0, high_4));
        Eight_0 _S78 = FloatWeights_eight_0(weights_9, row_3 + 4U + column_3);
        *&((&sums_4)->z) = *&((&sums_4)->z) + (dot_0(_S78.low_0, low_4) + dot_0(_S78.high_0, high_4));
        Eight_0 _S79 = FloatWeights_eight_0(weights_9, row_3 + 6U + column_3);
        *&((&sums_4)->w) = *&((&sums_4)->w) + (dot_0(_S79.low_0, low_4) + dot_0(_S79.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_4;
}

__device__ void dense_part_4(FloatWeights_0 * weights_10, uint first_7, bool adds_6, FixedArray<float, 9>  * inputs_10, FixedArray<float, 16>  * outputs_6)
{
    uint _S80 = first_7 + uint(whole_parts_0(int(2)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S81 = output_4 < int(16);
        if(_S81)
        {
        }
        else
        {
            break;
        }
        uint _S82 = uint(output_4);
        Eight_0 _S83 = FloatWeights_eight_0(weights_10, first_7 + _S82 / 8U);
        float4  _S84 = tile_product_3(weights_10, _S80 + _S82 * 2U, inputs_10);
        float4  _S85;
        if((output_4 & int(4)) != int(0))
        {
            _S85 = _S83.high_0;
        }
        else
        {
            _S85 = _S83.low_0;
        }
        float4  _S86 = _S84 + _S85;
        float _S87;
        if(_S81)
        {
            if(adds_6)
            {
                _S87 = (*outputs_6)[output_4];
            }
            else
            {
                _S87 = 0.0f;
            }
            (*outputs_6)[output_4] = Relu_apply_0(_S86.x + _S87);
        }
        int _S88 = output_4 + int(1);
        if(_S88 < int(16))
        {
            if(adds_6)
            {
                _S87 = (*outputs_6)[_S88];
            }
            else
            {
                _S87 = 0.0f;
            }
            (*outputs_6)[_S88] = Relu_apply_0(_S86.y + _S87);
        }
        int _S89 = output_4 + int(2);
        if(_S89 < int(16))
        {
            if(adds_6)
            {
                _S87 = (*outputs_6)[_S89];
            }
            else
            {
                _S87 = 0.0f;
            }
            (*outputs_6)[_S89] = Relu_apply_0(_S86.z + _S87);
        }
        int _S90 = output_4 + int(3);
        if(_S90 < int(16))
        {
            if(adds_6)
            {
                _S87 = (*outputs_6)[_S90];
            }
            else
            {
                _S87 = 0.0f;
            }
            (*outputs_6)[_S90] = Relu_apply_0(_S86.w + _S87);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

__device__ void dense_2(FloatWeights_0 * weights_11, uint first_8, bool adds_7, FixedArray<float, 16>  * inputs_11, FixedArray<float, 16>  * outputs_7)
{
    dense_part_2(weights_11, first_8, adds_7, inputs_11, outputs_7);
    return;
}

__device__ void dense_3(FloatWeights_0 * weights_12, uint first_9, bool adds_8, FixedArray<float, 16>  * inputs_12, FixedArray<float, 1>  * outputs_8)
{
    dense_part_3(weights_12, first_9, adds_8, inputs_12, outputs_8);
    return;
}

__device__ void dense_4(FloatWeights_0 * weights_13, uint first_10, bool adds_9, FixedArray<float, 9>  * inputs_13, FixedArray<float, 16>  * outputs_9)
{
    dense_part_4(weights_13, first_10, adds_9, inputs_13, outputs_9);
    return;
}

__device__ void dense_part_5(FloatWeights_0 * weights_14, uint first_11, bool adds_10, FixedArray<float, 25>  * inputs_14, FixedArray<float, 25>  * outputs_10)
{
    uint _S91 = first_11 + uint(whole_parts_0(int(4)));
    int output_5 = int(0);
    for(;;)
    {
        bool _S92 = output_5 < int(25);
        if(_S92)
        {
        }
        else
        {
            break;
        }
        uint _S93 = uint(output_5);
        Eight_0 _S94 = FloatWeights_eight_0(weights_14, first_11 + _S93 / 8U);
        float4  _S95 = tile_product_0(weights_14, _S91 + _S93 * 4U, inputs_14);
        float4  _S96;
        if((output_5 & int(4)) != int(0))
        {
            _S96 = _S94.high_0;
        }
        else
        {
            _S96 = _S94.low_0;
        }
        float4  _S97 = _S95 + _S96;
        float _S98;
        if(_S92)
        {
            if(adds_10)
            {
                _S98 = (*outputs_10)[output_5];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_10)[output_5] = Relu_apply_0(_S97.x + _S98);
        }
        int _S99 = output_5 + int(1);
        if(_S99 < int(25))
        {
            if(adds_10)
            {
                _S98 = (*outputs_10)[_S99];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_10)[_S99] = Relu_apply_0(_S97.y + _S98);
        }
        int _S100 = output_5 + int(2);
        if(_S100 < int(25))
        {
            if(adds_10)
            {
                _S98 = (*outputs_10)[_S100];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_10)[_S100] = Relu_apply_0(_S97.z + _S98);
        }
        int _S101 = output_5 + int(3);
        if(_S101 < int(25))
        {
            if(adds_10)
            {
                _S98 = (*outputs_10)[_S101];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_10)[_S101] = Relu_apply_0(_S97.w + _S98);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

__device__ void dense_part_6(FloatWeights_0 * weights_15, uint first_12, bool adds_11, FixedArray<float, 25>  * inputs_15, FixedArray<float, 1>  * outputs_11)
{
    uint _S102 = first_12 + uint(whole_parts_0(int(1)));
    int output_6 = int(0);
    for(;;)
    {
        bool _S103 = output_6 < int(1);
        if(_S103)
        {
        }
        else
        {
            break;
        }
        uint _S104 = uint(output_6);
        Eight_0 _S105 = FloatWeights_eight_0(weights_15, first_12 + _S104 / 8U);
        float4  _S106 = tile_product_0(weights_15, _S102 + _S104 * 4U, inputs_15);
        float4  _S107;
        if((output_6 & int(4)) != int(0))
        {
            _S107 = _S105.high_0;
        }
        else
        {
            _S107 = _S105.low_0;
        }
        float4  _S108 = _S106 + _S107;
        float _S109;
        if(_S103)
        {
            if(adds_11)
            {
                _S109 = (*outputs_11)[output_6];
            }
            else
            {
                _S109 = 0.0f;
            }
            (*outputs_11)[output_6] = Identity_apply_0(_S108.x + _S109);
        }
        int _S110 = output_6 + int(1);
        if(_S110 < int(1))
        {
            if(adds_11)
            {
                _S109 = (*outputs_11)[_S110];
            }
            else
            {
                _S109 = 0.0f;
            }
            (*outputs_11)[_S110] = Identity_apply_0(_S108.y + _S109);
        }
        int _S111 = output_6 + int(2);
        if(_S111 < int(1))
        {
            if(adds_11)
            {
                _S109 = (*outputs_11)[_S111];
            }
            else
            {
                _S109 = 0.0f;
            }
            (*outputs_11)[_S111] = Identity_apply_0(_S108.z + _S109);
        }
        int _S112 = output_6 + int(3);
        if(_S112 < int(1))
        {
            if(adds_11)
            {
                _S109 = (*outputs_11)[_S112];
            }
            else
            {
                _S109 = 0.0f;
            }
            (*outputs_11)[_S112] = Identity_apply_0(_S108.w + _S109);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

__device__ void dense_part_7(FloatWeights_0 * weights_16, uint first_13, bool adds_12, FixedArray<float, 9>  * inputs_16, FixedArray<float, 25>  * outputs_12)
{
    uint _S113 = first_13 + uint(whole_parts_0(int(4)));
    int output_7 = int(0);
    for(;;)
    {
        bool _S114 = output_7 < int(25);
        if(_S114)
        {
        }
        else
        {
            break;
        }
        uint _S115 = uint(output_7);
        Eight_0 _S116 = FloatWeights_eight_0(weights_16, first_13 + _S115 / 8U);
        float4  _S117 = tile_product_3(weights_16, _S113 + _S115 * 2U, inputs_16);
        float4  _S118;
        if((output_7 & int(4)) != int(0))
        {
            _S118 = _S116.high_0;
        }
        else
        {
            _S118 = _S116.low_0;
        }
        float4  _S119 = _S117 + _S118;
        float _S120;
        if(_S114)
        {
            if(adds_12)
            {
                _S120 = (*outputs_12)[output_7];
            }
            else
            {
                _S120 = 0.0f;
            }
            (*outputs_12)[output_7] = Relu_apply_0(_S119.x + _S120);
        }
        int _S121 = output_7 + int(1);
        if(_S121 < int(25))
        {
            if(adds_12)
            {
                _S120 = (*outputs_12)[_S121];
            }
            else
            {
                _S120 = 0.0f;
            }
            (*outputs_12)[_S121] = Relu_apply_0(_S119.y + _S120);
        }
        int _S122 = output_7 + int(2);
        if(_S122 < int(25))
        {
            if(adds_12)
            {
                _S120 = (*outputs_12)[_S122];
            }
            else
            {
                _S120 = 0.0f;
            }
            (*outputs_12)[_S122] = Relu_apply_0(_S119.z + _S120);
        }
        int _S123 = output_7 + int(3);
        if(_S123 < int(25))
        {
            if(adds_12)
            {
                _S120 = (*outputs_12)[_S123];
            }
            else
            {
                _S120 = 0.0f;
            }
            (*outputs_12)[_S123] = Relu_apply_0(_S119.w + _S120);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

__device__ void dense_5(FloatWeights_0 * weights_17, uint first_14, bool adds_13, FixedArray<float, 25>  * inputs_17, FixedArray<float, 25>  * outputs_13)
{
    dense_part_5(weights_17, first_14, adds_13, inputs_17, outputs_13);
    return;
}

__device__ void dense_6(FloatWeights_0 * weights_18, uint first_15, bool adds_14, FixedArray<float, 25>  * inputs_18, FixedArray<float, 1>  * outputs_14)
{
    dense_part_6(weights_18, first_15, adds_14, inputs_18, outputs_14);
    return;
}

__device__ void dense_7(FloatWeights_0 * weights_19, uint first_16, bool adds_15, FixedArray<float, 9>  * inputs_19, FixedArray<float, 25>  * outputs_15)
{
    dense_part_7(weights_19, first_16, adds_15, inputs_19, outputs_15);
    return;
}

__device__ float3  max_1(float3  x_9, float3  y_6)
{
    float3  result_5;
    int i_4 = int(0);
    for(;;)
    {
        if(i_4 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_5, i_4) = (F32_max((_slang_vector_get_element(x_9, i_4)), (_slang_vector_get_element(y_6, i_4))));
        i_4 = i_4 + int(1);
    }
    return result_5;
}

struct MLP_0
{
    FloatWeights_0 weights_20;
};

__device__ int layer_size_0(int inputs_20, int outputs_16)
{
    return whole_parts_0((outputs_16 + int(7)) / int(8)) + whole_parts_0((inputs_20 + int(7)) / int(8) * ((outputs_16 + int(4) - int(1)) / int(4) * int(4)));
}

__device__ void MLP_evaluate_0(MLP_0 * this_1, FixedArray<float, 11>  * inputs_21, FixedArray<float, 3>  * outputs_17)
{
    FixedArray<float, 25>  odd_0;
    FixedArray<float, 25>  even_0;
    dense_1(&this_1->weights_20, 0U, false, inputs_21, &even_0);
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
        int _S124 = layer_size_0(int(25), int(25));
        uint _S125 = uint(layer_size_0(int(11), int(25)) + (layer_0 - int(1)) * _S124);
        dense_5(&this_1->weights_20, _S125, false, &even_0, &odd_0);
        if((layer_0 + int(1)) < int(3))
        {
            dense_5(&this_1->weights_20, _S125 + uint(_S124), false, &odd_0, &even_0);
        }
        layer_0 = layer_0 + int(2);
    }
    uint _S126 = uint(layer_size_0(int(11), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_0(&this_1->weights_20, _S126, false, &even_0, outputs_17);
    return;
}

__device__ float clamp_0(float x_10, float minBound_0, float maxBound_0)
{
    return (F32_min(((F32_max((x_10), (minBound_0)))), (maxBound_0)));
}

__device__ void MLP_evaluate_1(MLP_0 * this_2, FixedArray<float, 9>  * inputs_22, FixedArray<float, 1>  * outputs_18)
{
    FixedArray<float, 16>  odd_1;
    FixedArray<float, 16>  even_1;
    dense_4(&this_2->weights_20, 0U, false, inputs_22, &even_1);
    int layer_1 = int(1);
    for(;;)
    {
        if(layer_1 < int(2))
        {
        }
        else
        {
            break;
        }
        int _S127 = layer_size_0(int(16), int(16));
        uint _S128 = uint(layer_size_0(int(9), int(16)) + (layer_1 - int(1)) * _S127);
        dense_2(&this_2->weights_20, _S128, false, &even_1, &odd_1);
        if((layer_1 + int(1)) < int(2))
        {
            dense_2(&this_2->weights_20, _S128 + uint(_S127), false, &odd_1, &even_1);
        }
        layer_1 = layer_1 + int(2);
    }
    uint _S129 = uint(layer_size_0(int(9), int(16)) + layer_size_0(int(16), int(16)));
    dense_3(&this_2->weights_20, _S129, false, &odd_1, outputs_18);
    return;
}

__device__ float2  clamp_1(float2  x_11, float2  minBound_1, float2  maxBound_1)
{
    return min_0(max_0(x_11, minBound_1), maxBound_1);
}

__device__ float2  frac_0(float2  x_12)
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
        *_slang_vector_get_element_ptr(&result_6, i_5) = (F32_frac((_slang_vector_get_element(x_12, i_5))));
        i_5 = i_5 + int(1);
    }
    return result_6;
}

__device__ void MLP_evaluate_2(MLP_0 * this_3, FixedArray<float, 9>  * inputs_23, FixedArray<float, 1>  * outputs_19)
{
    FixedArray<float, 25>  odd_2;
    FixedArray<float, 25>  even_2;
    dense_7(&this_3->weights_20, 0U, false, inputs_23, &even_2);
    int layer_2 = int(1);
    for(;;)
    {
        if(layer_2 < int(3))
        {
        }
        else
        {
            break;
        }
        int _S130 = layer_size_0(int(25), int(25));
        uint _S131 = uint(layer_size_0(int(9), int(25)) + (layer_2 - int(1)) * _S130);
        dense_5(&this_3->weights_20, _S131, false, &even_2, &odd_2);
        if((layer_2 + int(1)) < int(3))
        {
            dense_5(&this_3->weights_20, _S131 + uint(_S130), false, &odd_2, &even_2);
        }
        layer_2 = layer_2 + int(2);
    }
    uint _S132 = uint(layer_size_0(int(9), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_6(&this_3->weights_20, _S132, false, &even_2, outputs_19);
    return;
}

__device__ float2  f16tof32_0(uint2  value_0)
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
        *_slang_vector_get_element_ptr(&result_7, i_6) = (__half2float(__ushort_as_half((_slang_vector_get_element(value_0, i_6)))));
        i_6 = i_6 + int(1);
    }
    return result_7;
}

__device__ float2  floor_0(float2  x_13)
{
    float2  result_8;
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
        *_slang_vector_get_element_ptr(&result_8, i_7) = (F32_floor((_slang_vector_get_element(x_13, i_7))));
        i_7 = i_7 + int(1);
    }
    return result_8;
}

__device__ Query_0 slang_ldg_0(Query_0 * ptr_0)
{
    uint _S133 = __ldg(&ptr_0->fabric_1);
    float _S134 = __ldg(&ptr_0->centre_x_0);
    float _S135 = __ldg(&ptr_0->centre_y_0);
    float _S136 = __ldg(&ptr_0->dx_x_0);
    float _S137 = __ldg(&ptr_0->dx_y_0);
    float _S138 = __ldg(&ptr_0->dy_x_0);
    float _S139 = __ldg(&ptr_0->dy_y_0);
    float _S140 = __ldg(&ptr_0->light_x_0);
    float _S141 = __ldg(&ptr_0->light_y_0);
    float _S142 = __ldg(&ptr_0->light_z_0);
    float _S143 = __ldg(&ptr_0->view_x_0);
    float _S144 = __ldg(&ptr_0->view_y_0);
    float _S145 = __ldg(&ptr_0->view_z_0);
    uint _S146 = __ldg(&ptr_0->seed_1);
    Query_0 _S147 = { _S133, _S134, _S135, _S136, _S137, _S138, _S139, _S140, _S141, _S142, _S143, _S144, _S145, _S146 };
    return _S147;
}

__device__ Neumip_0 slang_ldg_1(Neumip_0 * ptr_1)
{
    uint _S148 = __ldg(&ptr_1->is_trained_0);
    uint _S149 = __ldg(&ptr_1->decoder_0);
    uint _S150 = __ldg(&ptr_1->has_offset_0);
    uint _S151 = __ldg(&ptr_1->offset_0);
    uint _S152 = __ldg(&ptr_1->offset_texels_0);
    uint _S153 = __ldg(&ptr_1->features_0);
    uint _S154 = __ldg(&ptr_1->texel_elements_0);
    uint _S155 = __ldg(&ptr_1->levels_2);
    float _S156 = __ldg(&ptr_1->last_level_1);
    uint _S157 = __ldg(&ptr_1->face_texels_0);
    uint _S158 = __ldg(&ptr_1->back_0);
    float _S159 = __ldg(&ptr_1->repeats_per_x_0);
    float _S160 = __ldg(&ptr_1->repeats_per_y_0);
    float _S161 = __ldg(&ptr_1->texels_per_mm_0);
    float _S162 = __ldg(&ptr_1->unit_x_0);
    float _S163 = __ldg(&ptr_1->unit_y_0);
    uint _S164 = __ldg(&ptr_1->transmits_0);
    uint _S165 = __ldg(&ptr_1->transmission_0);
    uint _S166 = __ldg(&ptr_1->has_holes_0);
    uint _S167 = __ldg(&ptr_1->opacity_0);
    Neumip_0 _S168 = { _S148, _S149, _S150, _S151, _S152, _S153, _S154, _S155, _S156, _S157, _S158, _S159, _S160, _S161, _S162, _S163, _S164, _S165, _S166, _S167 };
    return _S168;
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S169 = float2 {direction_0.x, direction_0.y};
    float _S170;
    if(back_2)
    {
        _S170 = - direction_0.z;
    }
    else
    {
        _S170 = direction_0.z;
    }
    return make_float3 (_S169.x, _S169.y, _S170);
}

__device__ Eight_0 no_numbers_0()
{
    Eight_0 numbers_1;
    float4  _S171 = make_float4 (0.0f);
    (&numbers_1)->low_0 = _S171;
    (&numbers_1)->high_0 = _S171;
    return numbers_1;
}

__device__ Eight_0 eight_halves_0(uint4  packed_0)
{
    Eight_0 numbers_2;
    uint _S172 = packed_0.x;
    uint _S173 = packed_0.y;
    (&numbers_2)->low_0 = make_float4 (f16tof32_0(make_uint2 (_S172 & 65535U, _S172 >> 16U)).x, f16tof32_0(make_uint2 (_S172 & 65535U, _S172 >> 16U)).y, f16tof32_0(make_uint2 (_S173 & 65535U, _S173 >> 16U)).x, f16tof32_0(make_uint2 (_S173 & 65535U, _S173 >> 16U)).y);
    uint _S174 = packed_0.z;
    uint _S175 = packed_0.w;
    (&numbers_2)->high_0 = make_float4 (f16tof32_0(make_uint2 (_S174 & 65535U, _S174 >> 16U)).x, f16tof32_0(make_uint2 (_S174 & 65535U, _S174 >> 16U)).y, f16tof32_0(make_uint2 (_S175 & 65535U, _S175 >> 16U)).x, f16tof32_0(make_uint2 (_S175 & 65535U, _S175 >> 16U)).y);
    return numbers_2;
}

__device__ Eight_0 texel_numbers_0(uint first_17, uint elements_1, uint texel_0)
{
    uint _S176 = first_17 + texel_0 * elements_1;
    uint4  _S177 = __ldg((&(globalParams_0->packed_numbers_0)[_S176]));
    if(elements_1 == 1U)
    {
        return eight_halves_0(_S177);
    }
    Eight_0 numbers_3;
    (&numbers_3)->low_0 = asfloat_0(_S177);
    uint4  _S178 = __ldg((&(globalParams_0->packed_numbers_0)[_S176 + 1U]));
    (&numbers_3)->high_0 = asfloat_0(_S178);
    return numbers_3;
}

__device__ void add_bilinear_0(uint first_18, uint elements_2, uint start_1, uint columns_2, uint rows_2, float2  uv_0, float weight_0, Eight_0 * sums_5)
{
    float2  _S179 = uv_0 * make_float2 (float(columns_2), float(rows_2)) - make_float2 (0.5f);
    float2  _S180 = floor_0(_S179);
    float2  _S181 = _S179 - _S180;
    int _S182 = int(_S180.x);
    int _S183 = int(_S180.y);
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
        uint _S184 = tap_0 & 1U;
        uint _S185 = tap_0 >> int(1);
        Eight_0 _S186 = texel_numbers_0(first_18, elements_2, start_1 + (uint(_S183 + int(_S185)) & (rows_2 - 1U)) * columns_2 + (uint(_S182 + int(_S184)) & (columns_2 - 1U)));
        float _S187;
        if(_S185 != 0U)
        {
            _S187 = _S181.y;
        }
        else
        {
            _S187 = 1.0f - _S181.y;
        }
        float _S188;
        if(_S184 != 0U)
        {
            _S188 = _S181.x;
        }
        else
        {
            _S188 = 1.0f - _S181.x;
        }
        float _S189 = _S187 * _S188 * weight_0;
        sums_5->low_0 = sums_5->low_0 + make_float4 (_S189) * _S186.low_0;
        sums_5->high_0 = sums_5->high_0 + make_float4 (_S189) * _S186.high_0;
        tap_0 = tap_0 + 1U;
    }
    return;
}

__device__ float channel_0(Eight_0 * numbers_4, int k_0)
{
    float _S190;
    if(k_0 < int(4))
    {
        _S190 = *_slang_vector_get_element_ptr(&numbers_4->low_0, k_0);
    }
    else
    {
        _S190 = *_slang_vector_get_element_ptr(&numbers_4->high_0, k_0 - int(4));
    }
    return _S190;
}

__device__ float neumip_depth_0(Neumip_0 * model_0, float2  uv_1, float2  view_1, uint face_1)
{
    uint _S191 = model_0->levels_2;
    uint _S192 = __ldg((&(globalParams_0->words_0)[model_0->levels_2 + 1U]));
    uint _S193 = __ldg((&(globalParams_0->words_0)[_S191 + 2U]));
    Eight_0 texel_1 = no_numbers_0();
    add_bilinear_0(model_0->offset_texels_0, model_0->texel_elements_0, face_1 * _S192 * _S193, _S192, _S193, frac_0(uv_1), 1.0f, &texel_1);
    FixedArray<float, 9>  inputs_24;
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
        Eight_0 _S194 = texel_1;
        float _S195 = channel_0(&_S194, k_1);
        inputs_24[k_1] = _S195;
        k_1 = k_1 + int(1);
    }
    inputs_24[int(7)] = view_1.x;
    inputs_24[int(8)] = view_1.y;
    MLP_0 network_1;
    (&(&network_1)->weights_20)->first_0 = model_0->offset_0;
    MLP_0 _S196 = network_1;
    FixedArray<float, 1>  depth_0;
    MLP_evaluate_2(&_S196, &inputs_24, &depth_0);
    return depth_0[int(0)];
}

__device__ float natural_logarithm_0(float x_14)
{
    uint _S197 = (F32_asuint((x_14)));
    float exponent_0 = float(int(_S197 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S197 & 8388607U) | 1056964608U)));
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
    float _S198 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S198 - exponent_1 * 0.00021219444170129f - 0.5f * _S198) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_15)
{
    return natural_logarithm_0(x_15) * 1.4426950216293335f;
}

__device__ float2  within_repeat_0(float2  uv_2)
{
    return clamp_1(frac_0(uv_2), make_float2 (0.0f), make_float2 (1.0f));
}

struct TexelPyramid_0
{
    uint first_19;
    uint elements_3;
    uint levels_4;
    float last_level_3;
    uint face_texels_2;
};

__device__ void TexelPyramid_add_level_0(TexelPyramid_0 * this_4, float2  place_0, uint level_1, uint face_2, float weight_1, Eight_0 * sums_6)
{
    uint _S199 = this_4->levels_4 + 3U * level_1;
    uint _S200 = this_4->first_19;
    uint _S201 = this_4->elements_3;
    uint _S202 = face_2 * this_4->face_texels_2;
    uint _S203 = __ldg((&(globalParams_0->words_0)[_S199]));
    uint _S204 = _S202 + _S203;
    uint _S205 = __ldg((&(globalParams_0->words_0)[_S199 + 1U]));
    uint _S206 = __ldg((&(globalParams_0->words_0)[_S199 + 2U]));
    add_bilinear_0(_S200, _S201, _S204, _S205, _S206, place_0, weight_1, sums_6);
    return;
}

__device__ Eight_0 TexelPyramid_between_levels_0(TexelPyramid_0 * this_5, float2  uv_3, float level_2, uint face_3)
{
    float _S207 = clamp_0(level_2, 0.0f, this_5->last_level_3);
    float _S208 = clamp_0((F32_floor((_S207))), 0.0f, (F32_max((this_5->last_level_3 - 1.0f), (0.0f))));
    float _S209 = _S207 - _S208;
    float2  _S210 = within_repeat_0(uv_3);
    Eight_0 texel_2 = no_numbers_0();
    uint offset_2 = 0U;
    for(;;)
    {
        if(offset_2 < 2U)
        {
        }
        else
        {
            break;
        }
        float _S211;
        if(offset_2 == 0U)
        {
            _S211 = 1.0f - _S209;
        }
        else
        {
            _S211 = _S209;
        }
        if(_S211 > 0.0f)
        {
            TexelPyramid_add_level_0(this_5, _S210, uint(_S208) + offset_2, face_3, _S211, &texel_2);
        }
        offset_2 = offset_2 + 1U;
    }
    return texel_2;
}

__device__ float exponential_0(float x_16)
{
    float _S212 = clamp_0(x_16, -87.0f, 88.0f);
    float _S213 = (F32_floor((_S212 * 1.4426950216293335f + 0.5f)));
    float _S214 = _S212 - _S213 * 0.693359375f + _S213 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S214 + 0.00139819993637502f) * _S214 + 0.00833345204591751f) * _S214 + 0.04166579619050026f) * _S214 + 0.1666666567325592f) * _S214 + 0.5f;
    float _S215 = (U32_asfloat((uint(int(_S213) + int(127)) << int(23))));
    float _S216;
    if(x_16 < -87.0f)
    {
        _S216 = 0.0f;
    }
    else
    {
        _S216 = (p_0 * _S214 * _S214 + _S214 + 1.0f) * _S215;
    }
    return _S216;
}

__device__ float neumip_hole_0(Neumip_0 * model_1, Eight_0 * texel_3, float2  view_2)
{
    FixedArray<float, 9>  inputs_25;
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
        float _S217 = channel_0(texel_3, k_2);
        inputs_25[k_2] = _S217;
        k_2 = k_2 + int(1);
    }
    inputs_25[int(7)] = view_2.x;
    inputs_25[int(8)] = view_2.y;
    MLP_0 network_2;
    (&(&network_2)->weights_20)->first_0 = model_1->opacity_0;
    MLP_0 _S218 = network_2;
    FixedArray<float, 1>  opening_0;
    MLP_evaluate_1(&_S218, &inputs_25, &opening_0);
    return 1.0f / (1.0f + exponential_0(- clamp_0(opening_0[int(0)], -30.0f, 30.0f)));
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

struct NeumipView_0
{
    FixedArray<float, 7>  latent_1;
    float2  view_3;
    bool back_3;
    float hole_0;
};

__device__ void neumip_view_0(uint _S219, Footprint_0 * _S220, float3  _S221, NeumipView_0 * _S222)
{
    Neumip_0 _S223 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S219])->neumip_0);
    bool _S224 = (_S221.z) < 0.0f;
    uint _S225;
    if(_S224)
    {
        _S225 = _S223.back_0;
    }
    else
    {
        _S225 = 0U;
    }
    float3  _S226 = to_face_frame_0(_S221, _S224);
    float2  uv_4 = _S220->centre_0 * make_float2 (_S223.repeats_per_x_0, _S223.repeats_per_y_0);
    float2  uv_5;
    if((_S223.has_offset_0) != 0U)
    {
        float2  _S227 = float2 {_S226.x, _S226.y};
        Neumip_0 _S228 = _S223;
        float _S229 = neumip_depth_0(&_S228, uv_4, _S227, _S225);
        uv_5 = uv_4 + make_float2 (_S229 / (F32_max((_S226.z), (0.60000002384185791f)))) * _S227 * make_float2 (_S223.unit_x_0, _S223.unit_y_0);
    }
    else
    {
        uv_5 = uv_4;
    }
    float _S230 = (F32_sqrt(((F32_abs((_S220->dx_0.x * _S220->dy_0.y - _S220->dx_0.y * _S220->dy_0.x)))))) * _S223.texels_per_mm_0;
    TexelPyramid_0 pyramid_0;
    (&pyramid_0)->first_19 = _S223.features_0;
    (&pyramid_0)->elements_3 = _S223.texel_elements_0;
    (&pyramid_0)->levels_4 = _S223.levels_2;
    (&pyramid_0)->last_level_3 = _S223.last_level_1;
    (&pyramid_0)->face_texels_2 = _S223.face_texels_0;
    float _S231 = binary_logarithm_0((F32_max((_S230), (9.99999971718068537e-10f))));
    TexelPyramid_0 _S232 = pyramid_0;
    Eight_0 _S233 = TexelPyramid_between_levels_0(&_S232, uv_5, _S231, _S225);
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
        Eight_0 _S234 = _S233;
        float _S235 = channel_0(&_S234, k_3);
        _S222->latent_1[k_3] = _S235;
        k_3 = k_3 + int(1);
    }
    float2  _S236 = float2 {_S226.x, _S226.y};
    _S222->view_3 = _S236;
    _S222->back_3 = _S224;
    float _S237;
    if((_S223.has_holes_0) != 0U)
    {
        Neumip_0 _S238 = _S223;
        Eight_0 _S239 = _S233;
        float _S240 = neumip_hole_0(&_S238, &_S239, _S236);
        _S237 = _S240;
    }
    else
    {
        _S237 = 0.0f;
    }
    _S222->hole_0 = _S237;
    return;
}

__device__ float3  neumip_value_0(uint _S241, NeumipView_0 * _S242, float3  _S243)
{
    Fabric_0 * _S244 = (&(globalParams_0->fabrics_0)[_S241]);
    float3  _S245 = to_face_frame_0(_S243, _S242->back_3);
    float _S246 = _S245.z;
    bool _S247;
    if(_S246 < 0.0f)
    {
        Neumip_0 _S248 = slang_ldg_1(&_S244->neumip_0);
        _S247 = (_S248.transmits_0) != 0U;
    }
    else
    {
        _S247 = false;
    }
    bool _S249;
    if(_S246 <= 0.0f)
    {
        _S249 = !_S247;
    }
    else
    {
        _S249 = false;
    }
    if(_S249)
    {
        return make_float3 (0.0f);
    }
    FixedArray<float, 11>  inputs_26;
    int k_4 = int(0);
    for(;;)
    {
        if(k_4 < int(7))
        {
        }
        else
        {
            break;
        }
        inputs_26[k_4] = _S242->latent_1[k_4];
        k_4 = k_4 + int(1);
    }
    inputs_26[int(7)] = _S245.x;
    inputs_26[int(8)] = _S245.y;
    inputs_26[int(9)] = _S242->view_3.x;
    inputs_26[int(10)] = _S242->view_3.y;
    FixedArray<float, 3>  outputs_20;
    MLP_0 network_3;
    uint _S250;
    if(_S247)
    {
        Neumip_0 _S251 = slang_ldg_1(&_S244->neumip_0);
        _S250 = _S251.transmission_0;
    }
    else
    {
        Neumip_0 _S252 = slang_ldg_1(&_S244->neumip_0);
        _S250 = _S252.decoder_0;
    }
    (&(&network_3)->weights_20)->first_0 = _S250;
    MLP_0 _S253 = network_3;
    MLP_evaluate_0(&_S253, &inputs_26, &outputs_20);
    return max_1(make_float3 (outputs_20[int(0)], outputs_20[int(1)], outputs_20[int(2)]), make_float3 (0.0f)) * make_float3 (0.31830987334251404f);
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_1, float2  dx_1, float2  dy_1, float3  light_1, float3  view_4)
{
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_1;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    Footprint_0 _S254 = footprint_0;
    NeumipView_0 seen_0;
    neumip_view_0(fabric_2, &_S254, view_4, &seen_0);
    float3  _S255 = neumip_value_0(fabric_2, &seen_0, light_1);
    return make_float4 (_S255.x, _S255.y, _S255.z, (&seen_0)->hole_0);
}

extern "C" __global__ void neumip_queries()
{
    uint _S256 = (blockIdx * blockDim + threadIdx).x;
    uint _S257 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S256 >= _S257)
    {
        return;
    }
    Query_0 _S258 = slang_ldg_0((&(globalParams_0->queries_0)[_S256]));
    *(&(globalParams_0->answers_0)[_S256]) = cloth_value_0(_S258.fabric_1, make_float2 (_S258.centre_x_0, _S258.centre_y_0), make_float2 (_S258.dx_x_0, _S258.dx_y_0), make_float2 (_S258.dy_x_0, _S258.dy_y_0), make_float3 (_S258.light_x_0, _S258.light_y_0, _S258.light_z_0), make_float3 (_S258.view_x_0, _S258.view_y_0, _S258.view_z_0));
    return;
}

