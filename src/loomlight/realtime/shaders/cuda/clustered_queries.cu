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
__device__ float dot_0(float3  x_3, float3  y_3)
{
    int i_0 = int(0);
    float result_0 = 0.0f;
    for(;;)
    {
        if(i_0 < int(3))
        {
        }
        else
        {
            break;
        }
        float result_1 = result_0 + _slang_vector_get_element(x_3, i_0) * _slang_vector_get_element(y_3, i_0);
        i_0 = i_0 + int(1);
        result_0 = result_1;
    }
    return result_0;
}

__device__ float length_0(float3  x_4)
{
    return (F32_sqrt((dot_0(x_4, x_4))));
}

__device__ float3  max_0(float3  x_5, float3  y_4)
{
    float3  result_2;
    int i_1 = int(0);
    for(;;)
    {
        if(i_1 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_2, i_1) = (F32_max((_slang_vector_get_element(x_5, i_1)), (_slang_vector_get_element(y_4, i_1))));
        i_1 = i_1 + int(1);
    }
    return result_2;
}

__device__ float3  min_0(float3  x_6, float3  y_5)
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
        *_slang_vector_get_element_ptr(&result_3, i_2) = (F32_min((_slang_vector_get_element(x_6, i_2)), (_slang_vector_get_element(y_5, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_3;
}

__device__ float3  clamp_0(float3  x_7, float3  minBound_0, float3  maxBound_0)
{
    return min_0(max_0(x_7, minBound_0), maxBound_0);
}

__device__ float2  min_1(float2  x_8, float2  y_6)
{
    float2  result_4;
    int i_3 = int(0);
    for(;;)
    {
        if(i_3 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_4, i_3) = (F32_min((_slang_vector_get_element(x_8, i_3)), (_slang_vector_get_element(y_6, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_4;
}

__device__ float lerp_0(float x_9, float y_7, float s_0)
{
    return x_9 + (y_7 - x_9) * s_0;
}

__device__ float3  normalize_0(float3  x_10)
{
    return x_10 / make_float3 (length_0(x_10));
}

__device__ float3  lerp_1(float3  x_11, float3  y_8, float3  s_1)
{
    return x_11 + (y_8 - x_11) * s_1;
}

__device__ float3  cross_0(float3  left_0, float3  right_0)
{
    float _S1 = left_0.y;
    float _S2 = right_0.z;
    float _S3 = left_0.z;
    float _S4 = right_0.y;
    float _S5 = right_0.x;
    float _S6 = left_0.x;
    return make_float3 (_S1 * _S2 - _S3 * _S4, _S3 * _S5 - _S6 * _S2, _S6 * _S4 - _S1 * _S5);
}

__device__ float2  lerp_2(float2  x_12, float2  y_9, float2  s_2)
{
    return x_12 + (y_9 - x_12) * s_2;
}

__device__ float2  floor_0(float2  x_13)
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
        *_slang_vector_get_element_ptr(&result_5, i_4) = (F32_floor((_slang_vector_get_element(x_13, i_4))));
        i_4 = i_4 + int(1);
    }
    return result_5;
}

__device__ float clamp_1(float x_14, float minBound_1, float maxBound_1)
{
    return (F32_min(((F32_max((x_14), (minBound_1)))), (maxBound_1)));
}

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ float dot_1(float2  x_15, float2  y_10)
{
    int i_5 = int(0);
    float result_6 = 0.0f;
    for(;;)
    {
        if(i_5 < int(2))
        {
        }
        else
        {
            break;
        }
        float result_7 = result_6 + _slang_vector_get_element(x_15, i_5) * _slang_vector_get_element(y_10, i_5);
        i_5 = i_5 + int(1);
        result_6 = result_7;
    }
    return result_6;
}

__device__ float saturate_0(float x_16)
{
    return clamp_1(x_16, 0.0f, 1.0f);
}

__device__ float3  saturate_1(float3  x_17)
{
    return clamp_0(x_17, make_float3 (0.0f), make_float3 (1.0f));
}

__device__ float dot_2(float4  x_18, float4  y_11)
{
    int i_6 = int(0);
    float result_8 = 0.0f;
    for(;;)
    {
        if(i_6 < int(4))
        {
        }
        else
        {
            break;
        }
        float result_9 = result_8 + _slang_vector_get_element(x_18, i_6) * _slang_vector_get_element(y_11, i_6);
        i_6 = i_6 + int(1);
        result_8 = result_9;
    }
    return result_8;
}

__device__ float2  sqrt_0(float2  x_19)
{
    float2  result_10;
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
        *_slang_vector_get_element_ptr(&result_10, i_7) = (F32_sqrt((_slang_vector_get_element(x_19, i_7))));
        i_7 = i_7 + int(1);
    }
    return result_10;
}

__device__ float2  max_1(float2  x_20, float2  y_12)
{
    float2  result_11;
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
        *_slang_vector_get_element_ptr(&result_11, i_8) = (F32_max((_slang_vector_get_element(x_20, i_8)), (_slang_vector_get_element(y_12, i_8))));
        i_8 = i_8 + int(1);
    }
    return result_11;
}

__device__ float2  round_0(float2  x_21)
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
        *_slang_vector_get_element_ptr(&result_12, i_9) = (F32_round((_slang_vector_get_element(x_21, i_9))));
        i_9 = i_9 + int(1);
    }
    return result_12;
}

__device__ float2  clamp_2(float2  x_22, float2  minBound_2, float2  maxBound_2)
{
    return min_1(max_1(x_22, minBound_2), maxBound_2);
}

__device__ Query_0 slang_ldg_0(Query_0 * ptr_0)
{
    uint _S7 = __ldg(&ptr_0->fabric_1);
    float _S8 = __ldg(&ptr_0->centre_x_0);
    float _S9 = __ldg(&ptr_0->centre_y_0);
    float _S10 = __ldg(&ptr_0->dx_x_0);
    float _S11 = __ldg(&ptr_0->dx_y_0);
    float _S12 = __ldg(&ptr_0->dy_x_0);
    float _S13 = __ldg(&ptr_0->dy_y_0);
    float _S14 = __ldg(&ptr_0->light_x_0);
    float _S15 = __ldg(&ptr_0->light_y_0);
    float _S16 = __ldg(&ptr_0->light_z_0);
    float _S17 = __ldg(&ptr_0->view_x_0);
    float _S18 = __ldg(&ptr_0->view_y_0);
    float _S19 = __ldg(&ptr_0->view_z_0);
    uint _S20 = __ldg(&ptr_0->seed_1);
    Query_0 _S21 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19, _S20 };
    return _S21;
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

__device__ Footprint_0 footprint_of_0(float2  centre_1, float2  dx_1, float2  dy_1)
{
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_1;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    return footprint_0;
}

__device__ Clustered_0 slang_ldg_1(Clustered_0 * ptr_1)
{
    uint _S22 = __ldg(&ptr_1->is_baked_1);
    uint _S23 = __ldg(&ptr_1->clusters_0);
    uint _S24 = __ldg(&ptr_1->rank_0);
    uint _S25 = __ldg(&ptr_1->channels_0);
    uint _S26 = __ldg(&ptr_1->columns_0);
    uint _S27 = __ldg(&ptr_1->rows_0);
    float _S28 = __ldg(&ptr_1->texel_width_0);
    float _S29 = __ldg(&ptr_1->texel_height_0);
    uint _S30 = __ldg(&ptr_1->samples_0);
    uint _S31 = __ldg(&ptr_1->sums_0);
    uint _S32 = __ldg(&ptr_1->labels_0);
    uint _S33 = __ldg(&ptr_1->coefficients_0);
    uint _S34 = __ldg(&ptr_1->basis_0);
    uint _S35 = __ldg(&ptr_1->moments_1);
    uint _S36 = __ldg(&ptr_1->light_0);
    uint _S37 = __ldg(&ptr_1->view_0);
    uint _S38 = __ldg(&ptr_1->offset_1);
    uint _S39 = __ldg(&ptr_1->trust_0);
    Clustered_0 _S40 = { _S22, _S23, _S24, _S25, _S26, _S27, _S28, _S29, _S30, _S31, _S32, _S33, _S34, _S35, _S36, _S37, _S38, _S39 };
    return _S40;
}

__device__ uint mixed_0(uint number_0)
{
    uint bits_0 = (number_0 ^ (number_0 >> int(16))) * 2246822507U;
    uint bits_1 = (bits_0 ^ (bits_0 >> int(13))) * 3266489909U;
    return bits_1 ^ (bits_1 >> int(16));
}

__device__ uint with_number_0(uint hash_0, float number_1)
{
    uint _S41;
    if(number_1 == 0.0f)
    {
        _S41 = 0U;
    }
    else
    {
        _S41 = (F32_asuint((number_1)));
    }
    return mixed_0(hash_0 ^ _S41);
}

__device__ uint hashed_0(Footprint_0 * footprint_1, float3  view_1, float2  size_1)
{
    uint hash_1 = 2654435769U;
    uint axis_0 = 0U;
    for(;;)
    {
        if(axis_0 < 2U)
        {
        }
        else
        {
            break;
        }
        float _S42 = *_slang_vector_get_element_ptr(&footprint_1->centre_0, axis_0) / _slang_vector_get_element(size_1, axis_0);
        uint _S43 = mixed_0(hash_1 ^ uint((_S42 - (F32_floor((_S42)))) * 4096.0f));
        uint _S44 = axis_0 + 1U;
        hash_1 = _S43;
        axis_0 = _S44;
    }
    axis_0 = 0U;
    for(;;)
    {
        if(axis_0 < 3U)
        {
        }
        else
        {
            break;
        }
        uint _S45 = with_number_0(hash_1, _slang_vector_get_element(view_1, axis_0));
        uint _S46 = axis_0 + 1U;
        hash_1 = _S45;
        axis_0 = _S46;
    }
    return with_number_0(with_number_0(with_number_0(with_number_0(hash_1, footprint_1->dx_0.x), footprint_1->dx_0.y), footprint_1->dy_0.x), footprint_1->dy_0.y);
}

__device__ float uniform_of_0(uint seed_2, uint dimension_0)
{
    return float((mixed_0(seed_2 + (dimension_0 + 1U) * 2654435769U)) >> int(8)) * 5.9604644775390625e-08f;
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S47 = float2 {direction_0.x, direction_0.y};
    float _S48;
    if(back_2)
    {
        _S48 = - direction_0.z;
    }
    else
    {
        _S48 = direction_0.z;
    }
    return make_float3 (_S47.x, _S47.y, _S48);
}

__device__ float arc_tangent_quotient_0(float x_23, float y_13)
{
    return ((((((0.0f * x_23 + 0.00809729471802711f) * x_23 + -0.0377517081797123f) * x_23 + 0.08475969731807709f) * x_23 + -0.13537675142288208f) * x_23 + 0.19895026087760925f) * x_23 + -0.33327975869178772f) * x_23 + 0.99999970197677612f;
}

__device__ float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

struct BinTaps_0
{
    uint corner_0;
    uint bins_1;
    float4  weights_0;
};

__device__ BinTaps_0 bin_taps_0(float3  direction_1, uint bins_2)
{
    float _S49 = (F32_sqrt(((F32_max((1.0f - direction_1.z), (0.0f))))));
    float _S50 = direction_1.x;
    float _S51 = (F32_abs((_S50)));
    float _S52 = direction_1.y;
    float _S53 = (F32_abs((_S52)));
    float _S54 = arc_tangent_of_ratio_0((F32_min((_S51), (_S53))) / (F32_max(((F32_max((_S51), (_S53)))), (9.999999960041972e-13f)))) * 1.27323949337005615f;
    bool _S55 = _S51 >= _S53;
    float _S56;
    if(_S50 < 0.0f)
    {
        _S56 = -1.0f;
    }
    else
    {
        _S56 = 1.0f;
    }
    float _S57;
    if(_S55)
    {
        _S57 = _S49;
    }
    else
    {
        _S57 = _S49 * _S54;
    }
    float _S58 = _S56 * _S57;
    if(_S52 < 0.0f)
    {
        _S56 = -1.0f;
    }
    else
    {
        _S56 = 1.0f;
    }
    if(_S55)
    {
        _S57 = _S49 * _S54;
    }
    else
    {
        _S57 = _S49;
    }
    float _S59 = float(bins_2);
    float2  _S60 = clamp_2((make_float2 (_S58, _S56 * _S57) + make_float2 (1.0f)) * make_float2 (0.5f * _S59) - make_float2 (0.5f), make_float2 (0.0f), make_float2 (_S59 - 1.0f));
    float _S61 = _S60.x;
    uint _S62 = bins_2 - 2U;
    uint _S63 = (U32_min((uint(_S61)), (_S62)));
    float _S64 = _S60.y;
    uint _S65 = (U32_min((uint(_S64)), (_S62)));
    float _S66 = _S61 - float(_S63);
    float _S67 = _S64 - float(_S65);
    BinTaps_0 taps_0;
    (&taps_0)->corner_0 = _S65 * bins_2 + _S63;
    (&taps_0)->bins_1 = bins_2;
    float _S68 = 1.0f - _S66;
    float _S69 = 1.0f - _S67;
    (&taps_0)->weights_0 = make_float4 (_S68 * _S69, _S66 * _S69, _S68 * _S67, _S66 * _S67);
    return taps_0;
}

__device__ float table_number_0(uint index_0)
{
    uint _S70 = __ldg((&(globalParams_0->words_0)[index_0]));
    return (U32_asfloat((_S70)));
}

__device__ float BinTaps_read_0(BinTaps_0 * this_0, uint table_0, uint first_0, uint stride_0, uint offset_2)
{
    uint _S71 = table_0 + (first_0 + this_0->corner_0) * stride_0 + offset_2;
    return table_number_0(_S71) * this_0->weights_0.x + table_number_0(_S71 + stride_0) * this_0->weights_0.y + table_number_0(_S71 + this_0->bins_1 * stride_0) * this_0->weights_0.z + table_number_0(_S71 + (this_0->bins_1 + 1U) * stride_0) * this_0->weights_0.w;
}

struct TexelBox_0
{
    float2  corner_1;
    float2  size_2;
    uint2  first_1;
    float2  extent_0;
    uint2  last_0;
    float2  turns_0;
};

__device__ TexelBox_0 texel_box_0(Clustered_0 * tables_1, Footprint_0 * footprint_2, float2  offset_3, float place_0)
{
    float _S72 = footprint_2->dx_0.x;
    float _S73 = footprint_2->dy_0.x;
    float _S74 = (F32_sqrt((_S72 * _S72 + _S73 * _S73)));
    float _S75 = footprint_2->dx_0.y;
    float _S76 = footprint_2->dy_0.y;
    float _S77 = (F32_sqrt((_S75 * _S75 + _S76 * _S76)));
    float2  _S78 = make_float2 (_S74, _S77);
    float _S79 = (_S72 * _S75 + _S73 * _S76) / (F32_max((_S74 * _S77), (1.00000000317107685e-30f)));
    float _S80 = (F32_abs((_S79)));
    float _S81 = place_0 * (F32_sqrt(((F32_min((_S80), (1.0f))))));
    float _S82;
    if(_S79 < 0.0f)
    {
        _S82 = - _S81;
    }
    else
    {
        _S82 = _S81;
    }
    float2  _S83 = _S78 * make_float2 (_S81, _S82);
    float2  _S84 = make_float2 (tables_1->texel_width_0, tables_1->texel_height_0);
    uint _S85 = tables_1->columns_0;
    uint _S86 = tables_1->rows_0;
    float2  _S87 = make_float2 (float(tables_1->columns_0), float(tables_1->rows_0));
    TexelBox_0 box_0;
    float2  _S88 = _S78 * make_float2 ((F32_sqrt(((F32_max((1.0f - _S80), (0.0f)))))));
    (&box_0)->size_2 = _S88;
    float2  _S89 = make_float2 (0.5f) * _S88;
    float2  _S90 = footprint_2->centre_0 + _S83 - _S89;
    (&box_0)->corner_1 = _S90;
    float2  _S91 = max_1(round_0(_S88 / _S84), make_float2 (1.0f));
    (&box_0)->extent_0 = _S91;
    float2  _S92 = round_0((_S90 + _S89 + offset_3) / _S84 - make_float2 (0.5f) * _S91);
    float2  _S93 = make_float2 (0.0f);
    float2  _S94 = max_1(_S92 - floor_0(_S92 / _S87) * _S87, _S93);
    uint2  _S95 = make_uint2 ((U32_min((uint(_S94.x)), (tables_1->columns_0 - 1U))), (U32_min((uint(_S94.y)), (tables_1->rows_0 - 1U))));
    (&box_0)->first_1 = _S95;
    float2  _S96 = floor_0(_S91 / _S87);
    (&box_0)->turns_0 = _S96;
    float2  _S97 = max_1(_S91 - _S96 * _S87, _S93);
    uint2  _S98 = _S95 + make_uint2 (uint(_S97.x), uint(_S97.y));
    (&box_0)->last_0 = _S98;
    if((_S98.x) >= (tables_1->columns_0))
    {
        *&((&(&box_0)->last_0)->x) = *&((&(&box_0)->last_0)->x) - _S85;
        *&((&(&box_0)->turns_0)->x) = *&((&(&box_0)->turns_0)->x) + 1.0f;
    }
    if(((&box_0)->last_0.y) >= _S86)
    {
        *&((&(&box_0)->last_0)->y) = *&((&(&box_0)->last_0)->y) - _S86;
        *&((&(&box_0)->turns_0)->y) = *&((&(&box_0)->turns_0)->y) + 1.0f;
    }
    return box_0;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_1)
{
    float _S99 = __ldg(&(&(globalParams_0->families_0)[family_0])->inverse_count_0);
    float _S100 = __ldg(&(&(globalParams_0->families_0)[family_0])->half_inverse_count_0);
    float _S101 = (F32_floor(((F32_fma((index_1), (_S99), (_S100))))));
    float _S102 = - _S101;
    float _S103 = __ldg(&(&(globalParams_0->families_0)[family_0])->count_0);
    return make_float2 (_S101, (F32_fma((_S102), (_S103), (index_1))));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_0)
{
    float _S104 = __ldg(&(&(globalParams_0->families_0)[family_1])->inverse_size_0);
    float _S105 = (F32_floor((position_0 * _S104)));
    Cell_0 cell_0;
    float _S106 = - _S105;
    float _S107 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    float _S108 = (F32_fma((_S106), (_S107), (position_0)));
    (&cell_0)->below_0 = _S108;
    float _S109 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->above_0 = _S109 - _S108;
    float _S110 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->across_0 = _S108 - 0.5f * _S110;
    float _S111 = __ldg(&(&(globalParams_0->families_0)[family_1])->half_width_0);
    (&cell_0)->half_width_1 = _S111;
    float _S112 = turns_and_remainder_0(family_1, _S105).y;
    float _S113 = __ldg(&(&(globalParams_0->families_0)[family_1])->count_0);
    (&cell_0)->thread_0 = uint(clamp_1(_S112, 0.0f, _S113 - 1.0f));
    return cell_0;
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float _S114 = __ldg(&(&(globalParams_0->families_0)[family_2])->start_0);
    float _S115 = position_1 - _S114;
    float _S116 = __ldg(&(&(globalParams_0->families_0)[family_2])->inverse_period_0);
    float turns_1 = _S115 * _S116;
    float turns_2 = turns_1 - (F32_floor((turns_1)));
    float _S117 = __ldg(&(&(globalParams_0->families_0)[family_2])->period_0);
    float _S118 = turns_2 * _S117;
    float _S119 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    float _S120 = turns_2 * _S119;
    float _S121 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    uint _S122 = uint(clamp_1(_S120, 0.0f, _S121 - 1.0f));
    uint _S123 = __ldg(&(&(globalParams_0->families_0)[family_2])->first_thread_table_0);
    uint _S124 = __ldg((&(globalParams_0->words_0)[_S123 + _S122]));
    uint _S125 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S126;
    if(_S118 >= (table_number_0(_S125 + _S124 * 4U + 1U)))
    {
        _S126 = 1U;
    }
    else
    {
        _S126 = 0U;
    }
    uint _S127 = _S124 + _S126;
    float _S128 = __ldg(&(&(globalParams_0->families_0)[family_2])->count_0);
    uint _S129 = (U32_min((_S127), (uint(_S128) - 1U)));
    uint _S130 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S131 = _S130 + _S129 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S129;
    (&cell_1)->below_0 = _S118 - table_number_0(_S131);
    (&cell_1)->above_0 = table_number_0(_S131 + 1U) - _S118;
    (&cell_1)->across_0 = _S118 - table_number_0(_S131 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S131 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    uint _S132 = __ldg(&(&(globalParams_0->families_0)[family_3])->is_alike_0);
    if(_S132 != 0U)
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Bound_0
{
    uint thread_1;
    float turns_3;
    float cell_2;
    float visible_0;
    float width_2;
    float gap_0;
};

__device__ Bound_0 bound_at_0(uint family_4, float position_3)
{
    Cell_0 _S133 = locate_0(family_4, position_3);
    uint _S134 = __ldg(&(&(globalParams_0->families_0)[family_4])->before_0);
    float _S135 = table_number_0(_S134 + 2U * _S133.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_1 = _S133.thread_0;
    float _S136 = __ldg(&(&(globalParams_0->families_0)[family_4])->start_0);
    float _S137 = position_3 - _S136 - _S135 - _S133.below_0;
    float _S138 = __ldg(&(&(globalParams_0->families_0)[family_4])->inverse_period_0);
    (&bound_0)->turns_3 = (F32_round((_S137 * _S138)));
    (&bound_0)->cell_2 = _S133.below_0;
    float _S139 = 2.0f * _S133.half_width_1;
    (&bound_0)->width_2 = _S139;
    (&bound_0)->visible_0 = clamp_1((_S133.across_0 + _S133.half_width_1) / _S139, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S133.below_0), (_S133.below_0 - _S133.across_0 - _S133.half_width_1))) + (F32_max((_S133.across_0 - _S133.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

__device__ Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_3)
{
    float _S140 = __ldg(&(&(globalParams_0->families_0)[family_5])->start_0);
    float _S141 = centre_2 - _S140;
    float _S142 = __ldg(&(&(globalParams_0->families_0)[family_5])->inverse_period_0);
    float _S143 = (F32_floor((_S141 * _S142)));
    float _S144 = __ldg(&(&(globalParams_0->families_0)[family_5])->period_0);
    float _S145 = centre_2 - _S143 * _S144;
    float _S146 = __ldg(&(&(globalParams_0->families_0)[family_5])->smallest_box_0);
    float _S147 = 0.5f * (F32_max((size_3), (_S146)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_0 = bound_at_0(family_5, _S145 - _S147);
    (&stretch_0)->high_0 = bound_at_0(family_5, _S145 + _S147);
    return stretch_0;
}

__device__ float3  table_colour_0(uint index_2)
{
    return make_float3 (table_number_0(index_2), table_number_0(index_2 + 1U), table_number_0(index_2 + 2U));
}

struct Albedos_0
{
    float3  diffuse_reflect_0;
    float3  diffuse_transmit_0;
    float3  specular_reflect_0;
    float3  specular_transmit_0;
};

__device__ Albedos_0 table_albedos_0(uint row_0)
{
    Albedos_0 albedos_0;
    (&albedos_0)->diffuse_reflect_0 = table_colour_0(row_0);
    (&albedos_0)->diffuse_transmit_0 = table_colour_0(row_0 + 3U);
    (&albedos_0)->specular_reflect_0 = table_colour_0(row_0 + 6U);
    (&albedos_0)->specular_transmit_0 = table_colour_0(row_0 + 9U);
    return albedos_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_1)
{
    return (&this_1->high_0)->turns_3 - (&this_1->low_0)->turns_3;
}

__device__ float3  lengths_0(uint family_6, Stretch_0 * stretch_1)
{
    float _S148 = Stretch_turns_0(stretch_1);
    uint _S149 = __ldg(&(&(globalParams_0->families_0)[family_6])->before_0);
    uint _S150 = _S149 + 2U * (&stretch_1->low_0)->thread_1;
    uint _S151 = __ldg(&(&(globalParams_0->families_0)[family_6])->before_0);
    uint _S152 = _S151 + 2U * (&stretch_1->high_0)->thread_1;
    float _S153 = table_number_0(_S152) - table_number_0(_S150);
    float _S154 = table_number_0(_S152 + 1U) - table_number_0(_S150 + 1U);
    float _S155 = _S153 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_2 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_2;
    float _S156 = __ldg(&(&(globalParams_0->families_0)[family_6])->visible_total_0);
    float _S157 = _S155 + _S148 * _S156;
    float _S158 = _S154 - _S153 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0;
    float _S159 = __ldg(&(&(globalParams_0->families_0)[family_6])->period_0);
    float _S160 = __ldg(&(&(globalParams_0->families_0)[family_6])->visible_total_0);
    float _S161 = _S158 + _S148 * (_S159 - _S160);
    float _S162 = _S154 + (&stretch_1->high_0)->cell_2 - (&stretch_1->low_0)->cell_2;
    float _S163 = __ldg(&(&(globalParams_0->families_0)[family_6])->period_0);
    return make_float3 (_S157, _S161, _S162 + _S148 * _S163);
}

__device__ float2  integrals_along_0(uint family_7, Stretch_0 * stretch_2, uint quantity_0)
{
    uint _S164 = __ldg(&(&(globalParams_0->families_0)[family_7])->quantities_0);
    uint _S165 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    uint _S166 = 3U * _S164;
    uint _S167 = _S165 + _S166 * (&stretch_2->low_0)->thread_1 + quantity_0;
    uint _S168 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    uint _S169 = _S168 + _S166 * (&stretch_2->high_0)->thread_1 + quantity_0;
    uint _S170 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    float _S171 = __ldg(&(&(globalParams_0->families_0)[family_7])->count_0);
    uint _S172 = _S170 + _S166 * uint(_S171) + quantity_0;
    float _S173 = table_number_0(_S167);
    float _S174 = table_number_0(_S169);
    float _S175 = Stretch_turns_0(stretch_2);
    uint _S176 = 2U * _S164;
    return make_float2 (table_number_0(_S169 + _S164) - table_number_0(_S167 + _S164) + _S174 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_2 - _S173 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_2 + _S175 * table_number_0(_S172 + _S164), table_number_0(_S169 + _S176) - table_number_0(_S167 + _S176) + _S174 * (&stretch_2->high_0)->cell_2 - _S173 * (&stretch_2->low_0)->cell_2 + _S175 * table_number_0(_S172 + _S176));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_2)
{
    return ((&this_2->high_0)->thread_1) < ((&this_2->low_0)->thread_1);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_3, uint4  entries_0, uint whole_0)
{
    uint _S177 = entries_0.z;
    uint _S178 = entries_0.x;
    uint _S179 = _S177 - _S178;
    bool _S180 = Stretch_wraps_0(this_3);
    uint _S181;
    if(_S180)
    {
        _S181 = whole_0;
    }
    else
    {
        _S181 = 0U;
    }
    return make_uint4 (_S179 + _S181, entries_0.w - _S177, entries_0.y - _S178, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_1, uint row_1, uint count_1, uint quantities_1)
{
    uint _S182 = row_1 + (&across_1->low_0)->thread_1 * quantities_1;
    uint _S183 = row_1 + (&across_1->high_0)->thread_1 * quantities_1;
    uint _S184 = __ldg((&(globalParams_0->words_0)[_S182]));
    uint _S185 = __ldg((&(globalParams_0->words_0)[_S182 + quantities_1]));
    uint _S186 = __ldg((&(globalParams_0->words_0)[_S183]));
    uint _S187 = __ldg((&(globalParams_0->words_0)[_S183 + quantities_1]));
    uint4  _S188 = make_uint4 (_S184, _S185, _S186, _S187);
    uint _S189 = __ldg((&(globalParams_0->words_0)[row_1 + count_1 * quantities_1]));
    uint4  _S190 = Stretch_differences_0(across_1, _S188, _S189);
    return _S190;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_4)
{
    float _S191 = (&this_4->high_0)->visible_0;
    float _S192 = - (&this_4->low_0)->visible_0;
    float _S193 = Stretch_turns_0(this_4);
    bool _S194 = Stretch_wraps_0(this_4);
    float _S195;
    if(_S194)
    {
        _S195 = 1.0f;
    }
    else
    {
        _S195 = 0.0f;
    }
    return make_float4 (1.0f, _S191, _S192, _S193 - _S195);
}

__device__ float integral_on_top_0(uint family_8, Stretch_0 * across_2, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    float _S196 = __ldg(&(&(globalParams_0->families_0)[family_8])->count_0);
    uint _S197 = uint(_S196);
    uint _S198 = _S197 + 1U;
    uint _S199 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint _S200 = _S198 * _S199;
    uint _S201 = __ldg(&(&(globalParams_0->families_0)[family_8])->colour_areas_0);
    uint _S202 = _S201 + quantity_1;
    uint _S203 = (&along_0->low_0)->thread_1;
    uint _S204 = _S202 + (&along_0->low_0)->thread_1 * _S200;
    uint _S205 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S206 = row_differences_0(across_2, _S204, _S197, _S205);
    uint _S207 = _S202 + (_S203 + 1U) * _S200;
    uint _S208 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S209 = row_differences_0(across_2, _S207, _S197, _S208);
    uint _S210 = (&along_0->high_0)->thread_1;
    uint _S211 = _S202 + (&along_0->high_0)->thread_1 * _S200;
    uint _S212 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S213 = row_differences_0(across_2, _S211, _S197, _S212);
    uint _S214 = _S202 + (_S210 + 1U) * _S200;
    uint _S215 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S216 = row_differences_0(across_2, _S214, _S197, _S215);
    uint _S217 = _S202 + crossing_count_0 * _S200;
    uint _S218 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S219 = row_differences_0(across_2, _S217, _S197, _S218);
    uint4  _S220 = _S213 - _S206;
    bool _S221 = Stretch_wraps_0(along_0);
    uint4  _S222;
    if(_S221)
    {
        _S222 = _S219;
    }
    else
    {
        int4  _S223 = make_int4 (int(0));
        uint4  _S224 = make_uint4 ((uint)_S223.x, (uint)_S223.y, (uint)_S223.z, (uint)_S223.w);
        _S222 = _S224;
    }
    uint4  _S225 = _S220 + _S222;
    float4  _S226 = Stretch_weights_0(across_2);
    float4  _S227 = Stretch_weights_0(along_0);
    int4  _S228 = make_int4 ((int)_S225.x, (int)_S225.y, (int)_S225.z, (int)_S225.w);
    float4  _S229 = make_float4 ((float)_S228.x, (float)_S228.y, (float)_S228.z, (float)_S228.w);
    uint4  _S230 = _S216 - _S213;
    int4  _S231 = make_int4 ((int)_S230.x, (int)_S230.y, (int)_S230.z, (int)_S230.w);
    float4  _S232 = make_float4 ((float)_S231.x, (float)_S231.y, (float)_S231.z, (float)_S231.w);
    uint4  _S233 = _S209 - _S206;
    int4  _S234 = make_int4 ((int)_S233.x, (int)_S233.y, (int)_S233.z, (int)_S233.w);
    float4  _S235 = make_float4 ((float)_S234.x, (float)_S234.y, (float)_S234.z, (float)_S234.w);
    int4  _S236 = make_int4 ((int)_S219.x, (int)_S219.y, (int)_S219.z, (int)_S219.w);
    float4  _S237 = make_float4 ((float)_S236.x, (float)_S236.y, (float)_S236.z, (float)_S236.w);
    float _S238 = dot_2(make_float4 (dot_2(_S229, _S226), dot_2(_S232, _S226), dot_2(_S235, _S226), dot_2(_S237, _S226)), _S227);
    float _S239 = __ldg(&(&(globalParams_0->families_0)[family_8])->area_unit_0);
    return _S238 * _S239;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_0, uint row_2)
{
    Albedos_0 _S240 = table_albedos_0(row_2);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_0) * _S240.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_0) * _S240.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_0) * _S240.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_0) * _S240.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 * own_0, Stretch_0 * other_0, bool back_3)
{
    uint _S241 = __ldg(&(&(globalParams_0->families_0)[family_9])->colour_mean_0);
    Albedos_0 albedos_2 = table_albedos_0(_S241);
    uint _S242 = __ldg(&(&(globalParams_0->families_0)[family_9])->quantities_0);
    if(_S242 == 1U)
    {
        return albedos_2;
    }
    float3  _S243 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        uint _S244 = __ldg(&(&(globalParams_0->families_0)[family_9])->quantities_0);
        if(quantity_2 < _S244)
        {
        }
        else
        {
            break;
        }
        float2  _S245 = integrals_along_0(family_9, own_0, quantity_2);
        float _S246 = __ldg(&(&(globalParams_0->families_0)[crossing_0])->count_0);
        float _S247 = integral_on_top_0(family_9, own_0, other_0, uint(_S246), quantity_2);
        float _S248 = _S245.x;
        float _S249 = _S248 * _S243.x;
        float _S250;
        if(back_3)
        {
            _S250 = _S249 - _S247;
        }
        else
        {
            _S250 = _S247;
        }
        bool _S251 = quantity_2 == 0U;
        if(_S251)
        {
            float _S252 = __ldg(&(&(globalParams_0->families_0)[family_9])->area_unit_0);
            float _S253 = 16.0f * _S252;
            float _S254 = __ldg(&(&(globalParams_0->families_0)[family_9])->crossing_area_0);
            is_exposed_0 = _S250 > (_S253 * (F32_min((_S249 / _S254), (1.0f))) + 0.00000999999974738f * _S249);
        }
        float _S255 = _S248 * _S243.y;
        float _S256;
        if(is_exposed_0)
        {
            _S256 = _S250;
        }
        else
        {
            _S256 = 0.0f;
        }
        float _S257 = _S255 + _S256 + 0.000244140625f * _S243.z * _S245.y;
        if(_S251)
        {
            weight_1 = 1.0f / (F32_max((_S257), (9.99999968265522539e-21f)));
        }
        else
        {
            Albedos_0 _S258 = albedos_2;
            float _S259 = _S257 * weight_1;
            uint _S260 = __ldg(&(&(globalParams_0->families_0)[family_9])->colour_axes_0);
            uint _S261 = _S260 + 12U * (quantity_2 - 1U);
            Albedos_0 _S262 = _S258;
            Albedos_0 _S263 = with_added_albedos_0(&_S262, _S259, _S261);
            albedos_2 = _S263;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate_1((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate_1((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate_1((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate_1((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

__device__ Albedos_0 tinted_0(Albedos_0 * albedos_3, float3  tint_0)
{
    Albedos_0 result_13 = *albedos_3;
    (&result_13)->diffuse_reflect_0 = (&result_13)->diffuse_reflect_0 * tint_0;
    (&result_13)->diffuse_transmit_0 = (&result_13)->diffuse_transmit_0 * tint_0;
    return result_13;
}

struct FaceRadiance_0
{
    float3  warp_1;
    float3  weft_1;
    float3  mean_0;
    float3  leaked_0;
};

struct FaceSends_0
{
    float3  sky_warp_0;
    float3  sky_weft_0;
    float3  crossing_warp_0;
    float3  crossing_weft_0;
    float open_0;
    float blocks_warp_0;
    float blocks_weft_0;
};

__device__ FaceRadiance_0 face_radiance_0(FaceSends_0 * sends_0, float open_of_other_0, float3  passed_0, float3  from_other_0)
{
    float3  _S264 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S265 = sends_0->sky_warp_0 + _S264 * sends_0->crossing_warp_0;
    (&found_0)->warp_1 = _S265;
    float3  _S266 = sends_0->sky_weft_0 + _S264 * sends_0->crossing_weft_0;
    (&found_0)->weft_1 = _S266;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S265 + make_float3 (sends_0->blocks_weft_0) * _S266;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

__device__ void view_terms_0(float3  view_2, FixedArray<float, 6>  * terms_0)
{
    float _S267 = 1.0f - view_2.z;
    float _S268 = _S267 * _S267;
    (*terms_0)[int(0)] = 1.0f;
    float _S269 = view_2.x;
    float _S270 = _S269 * _S269;
    float _S271 = view_2.y;
    float _S272 = _S271 * _S271;
    (*terms_0)[int(1)] = (F32_sqrt(((F32_max((_S270 + _S272), (9.999999960041972e-13f))))));
    (*terms_0)[int(2)] = _S268;
    (*terms_0)[int(3)] = _S268 * _S268;
    (*terms_0)[int(4)] = _S270 - _S272;
    (*terms_0)[int(5)] = 0.0f;
    return;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

__device__ Blocked_0 scaled_0(Blocked_0 * blocked_0, float share_1)
{
    Blocked_0 result_14;
    (&result_14)->by_warp_0 = share_1 * blocked_0->by_warp_0;
    (&result_14)->by_weft_0 = share_1 * blocked_0->by_weft_0;
    (&result_14)->far_0 = share_1 * blocked_0->far_0;
    return result_14;
}

struct Bounced_0
{
    float3  reflected_0;
    float3  transmitted_0;
};

struct Scattered_0
{
    float3  back_4;
    float3  through_0;
};

struct Interior_0
{
    float3  warp_2;
    float3  weft_2;
    float3  leaked_1;
    float3  far_1;
    float3  far_leaked_0;
};

__device__ Bounced_0 bounced_by_0(Blocked_0 * blocked_1, Scattered_0 * yarn_0, Interior_0 * interior_0)
{
    float3  _S273 = make_float3 (blocked_1->by_warp_0 + blocked_1->by_weft_0) * interior_0->leaked_1;
    float3  _S274 = make_float3 (blocked_1->far_0) * yarn_0->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_0->back_4 * (make_float3 (blocked_1->by_warp_0) * interior_0->warp_2 + make_float3 (blocked_1->by_weft_0) * interior_0->weft_2) + _S274 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S274 * interior_0->far_1 + yarn_0->back_4 * _S273;
    return bounced_0;
}

__device__ Bounced_0 sum_of_0(Bounced_0 * first_2, Bounced_0 * second_0)
{
    Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_2->reflected_0 + second_0->reflected_0;
    (&sum_1)->transmitted_0 = first_2->transmitted_0 + second_0->transmitted_0;
    return sum_1;
}

__device__ int summed_0(Clustered_0 * tables_2, uint first_3, uint column_0, uint row_3)
{
    uint _S275 = __ldg((&(globalParams_0->words_0)[first_3 + (row_3 * (tables_2->columns_0 + 1U) + column_0) * tables_2->channels_0]));
    return int(_S275);
}

__device__ float box_mean_0(Clustered_0 * tables_3, TexelBox_0 * box_1, uint face_1, uint channel_0)
{
    uint _S276 = tables_3->columns_0;
    uint _S277 = tables_3->rows_0;
    uint _S278 = tables_3->sums_0 + face_1 * (tables_3->columns_0 + 1U) * (tables_3->rows_0 + 1U) * tables_3->channels_0 + channel_0;
    uint2  _S279 = box_1->last_0;
    uint _S280 = box_1->last_0.x;
    uint2  _S281 = box_1->first_1;
    uint _S282 = box_1->first_1.y;
    int _S283 = summed_0(tables_3, _S278, _S280, _S282);
    uint _S284 = _S281.x;
    int _S285 = summed_0(tables_3, _S278, _S284, _S282);
    int _S286 = _S283 - _S285;
    uint _S287 = _S279.y;
    int _S288 = summed_0(tables_3, _S278, _S280, _S287);
    int _S289 = summed_0(tables_3, _S278, _S284, _S287);
    float total_0 = float(_S288 - _S289 - _S286);
    float2  _S290 = box_1->turns_0;
    float _S291 = box_1->turns_0.x;
    bool _S292 = _S291 > 0.0f;
    float total_1;
    if(_S292)
    {
        int _S293 = summed_0(tables_3, _S278, _S276, _S287);
        int _S294 = summed_0(tables_3, _S278, _S276, _S282);
        total_1 = total_0 + _S291 * float(_S293 - _S294);
    }
    else
    {
        total_1 = total_0;
    }
    float _S295 = _S290.y;
    bool _S296 = _S295 > 0.0f;
    if(_S296)
    {
        int _S297 = summed_0(tables_3, _S278, _S280, _S277);
        int _S298 = summed_0(tables_3, _S278, _S284, _S277);
        total_1 = total_1 + _S295 * float(_S297 - _S298);
    }
    bool _S299;
    if(_S292)
    {
        _S299 = _S296;
    }
    else
    {
        _S299 = false;
    }
    if(_S299)
    {
        float _S300 = _S291 * _S295;
        int _S301 = summed_0(tables_3, _S278, _S276, _S277);
        total_1 = total_1 + _S300 * float(_S301);
    }
    return total_1 / (box_1->extent_0.x * box_1->extent_0.y);
}

__device__ float square_0(float3  v_1)
{
    return dot_0(v_1, v_1);
}

struct BaseTaps_0
{
    float3  facing_0;
    bool transmits_1;
    BinTaps_0 around_0;
    uint first_4;
    BinTaps_0 half_vector_0;
};

struct ViewedBase_0
{
    float3  view_3;
    bool back_5;
    uint face_2;
    BinTaps_0 around_1;
    TexelBox_0 box_2;
    float2  trust_1;
};

__device__ BaseTaps_0 base_taps_0(ViewedBase_0 * seen_0, float3  light_1)
{
    BaseTaps_0 taps_1;
    float3  _S302 = to_face_frame_0(light_1, seen_0->back_5);
    (&taps_1)->facing_0 = _S302;
    float _S303 = _S302.z;
    bool _S304 = _S303 < 0.0f;
    (&taps_1)->transmits_1 = _S304;
    (&taps_1)->around_0 = bin_taps_0(make_float3 (float2 {_S302.x, _S302.y}.x, float2 {_S302.x, _S302.y}.y, (F32_abs((_S303)))), 32U);
    uint _S305 = seen_0->face_2 * 2U;
    uint _S306;
    if(_S304)
    {
        _S306 = 1U;
    }
    else
    {
        _S306 = 0U;
    }
    (&taps_1)->first_4 = (_S305 + _S306) * 1024U;
    float3  _S307 = (&taps_1)->facing_0 + seen_0->view_3;
    float3  half_vector_1 = _S307 * make_float3 (1.0f / (F32_sqrt(((F32_max((square_0(_S307)), (9.999999960041972e-13f)))))));
    float3  half_vector_2;
    if((half_vector_1.z) < 0.0f)
    {
        half_vector_2 = - half_vector_1;
    }
    else
    {
        half_vector_2 = half_vector_1;
    }
    (&taps_1)->half_vector_0 = bin_taps_0(half_vector_2, 32U);
    return taps_1;
}

struct Components_0
{
    float diffuse_warp_0;
    float diffuse_weft_0;
    float specular_warp_0;
    float specular_weft_0;
    float light_visibility_1;
    float hole_0;
};

__device__ Components_0 no_components_0()
{
    Components_0 nothing_0;
    (&nothing_0)->diffuse_warp_0 = 0.0f;
    (&nothing_0)->diffuse_weft_0 = 0.0f;
    (&nothing_0)->specular_warp_0 = 0.0f;
    (&nothing_0)->specular_weft_0 = 0.0f;
    (&nothing_0)->light_visibility_1 = 0.0f;
    (&nothing_0)->hole_0 = 0.0f;
    return nothing_0;
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_0, float roughness_1)
{
    float _S308 = dot_0(direction_2, tangent_0);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S308 * _S308 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_24)
{
    float _S309 = clamp_1(x_24, -87.0f, 88.0f);
    float _S310 = (F32_floor((_S309 * 1.4426950216293335f + 0.5f)));
    float _S311 = _S309 - _S310 * 0.693359375f + _S310 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S311 + 0.00139819993637502f) * _S311 + 0.00833345204591751f) * _S311 + 0.04166579619050026f) * _S311 + 0.1666666567325592f) * _S311 + 0.5f;
    float _S312 = (U32_asfloat((uint(int(_S310) + int(127)) << int(23))));
    float _S313;
    if(x_24 < -87.0f)
    {
        _S313 = 0.0f;
    }
    else
    {
        _S313 = (p_0 * _S311 * _S311 + _S311 + 1.0f) * _S312;
    }
    return _S313;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_3;
    Albedos_0 weft_3;
};

__device__ float3  shaded_0(Components_0 * components_0, FamilyAlbedos_0 * albedos_4, bool transmits_2)
{
    if(transmits_2)
    {
        return (&albedos_4->warp_3)->diffuse_transmit_0 * make_float3 (components_0->diffuse_warp_0) + (&albedos_4->weft_3)->diffuse_transmit_0 * make_float3 (components_0->diffuse_weft_0) + (&albedos_4->warp_3)->specular_transmit_0 * make_float3 (components_0->specular_warp_0) + (&albedos_4->weft_3)->specular_transmit_0 * make_float3 (components_0->specular_weft_0);
    }
    return (&albedos_4->warp_3)->diffuse_reflect_0 * make_float3 (components_0->diffuse_warp_0) + (&albedos_4->weft_3)->diffuse_reflect_0 * make_float3 (components_0->diffuse_weft_0) + (&albedos_4->warp_3)->specular_reflect_0 * make_float3 (components_0->specular_warp_0) + (&albedos_4->weft_3)->specular_reflect_0 * make_float3 (components_0->specular_weft_0);
}

__device__ float3  bounced_value_0(Bounced_0 * bounced_1, float3  light_2, float3  view_4)
{
    float _S314 = light_2.z;
    float3  _S315;
    if((_S314 * view_4.z) < 0.0f)
    {
        _S315 = bounced_1->transmitted_0;
    }
    else
    {
        _S315 = bounced_1->reflected_0;
    }
    return _S315 * make_float3 ((F32_abs((_S314))) * 0.31830987334251404f);
}

__device__ float sheen_scale_0(float x_25, float y_14)
{
    return (((((0.0f * x_25 + (((((-1.1402510404586792f * y_14 + 0.40672621130943298f) * y_14 + 1.65398800373077393f) * y_14 + -1.29730904102325439f) * y_14 + 0.30570998787879944f) * y_14 + -0.0220868494361639f)) * x_25 + (((((-0.21142719686031342f * y_14 + 1.05947399139404297f) * y_14 + -0.41116121411323547f) * y_14 + -0.93859231472015381f) * y_14 + 0.51606941223144531f) * y_14 + 0.05409301072359085f)) * x_25 + (((((1.22944498062133789f * y_14 + -0.45962560176849365f) * y_14 + -1.63861405849456787f) * y_14 + 1.33565104007720947f) * y_14 + -0.45725581049919128f) * y_14 + 0.08243165910243988f)) * x_25 + (((((0.39779931306838989f * y_14 + -1.18879103660583496f) * y_14 + 0.28251591324806213f) * y_14 + 1.168984055519104f) * y_14 + -0.76864629983901978f) * y_14 + 0.0091691892594099f)) * x_25 + (((((-0.26563560962677002f * y_14 + -0.19379159808158875f) * y_14 + 0.2677634060382843f) * y_14 + 0.00270519289188087f) * y_14 + 0.14349560439586639f) * y_14 + 0.10290180146694183f)) * x_25 + (((((-0.20701569318771362f * y_14 + 0.24526430666446686f) * y_14 + 0.19551840424537659f) * y_14 + 0.07586126774549484f) * y_14 + 0.38894739747047424f) * y_14 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_26, float y_15)
{
    return ((((0.0f * x_26 + (((((-0.10608240216970444f * y_15 + 1.99214303493499756f) * y_15 + -1.42255294322967529f) * y_15 + -1.09495604038238525f) * y_15 + 0.59180057048797607f) * y_15 + 0.06902855634689331f)) * x_26 + (((((-0.46220690011978149f * y_15 + -0.29113379120826721f) * y_15 + 1.39025199413299561f) * y_15 + 0.35589990019798279f) * y_15 + -1.17120099067687988f) * y_15 + 0.15940259397029877f)) * x_26 + (((((2.26068711280822754f * y_15 + -3.64728999137878418f) * y_15 + -0.72173482179641724f) * y_15 + 3.07659196853637695f) * y_15 + -0.6827620267868042f) * y_15 + -0.3039557933807373f)) * x_26 + (((((0.81201767921447754f * y_15 + 0.36014080047607422f) * y_15 + -1.72646903991699219f) * y_15 + -0.22630110383033752f) * y_15 + 0.89514690637588501f) * y_15 + -0.10397960245609283f)) * x_26 + (((((-0.37648698687553406f * y_15 + 1.10974001884460449f) * y_15 + 0.17824520170688629f) * y_15 + -1.04968702793121338f) * y_15 + 0.1461234986782074f) * y_15 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_27, float y_16)
{
    return ((((0.0f * x_27 + (((((12.95646953582763672f * y_16 + -21.38032913208007812f) * y_16 + -7.37853097915649414f) * y_16 + 34.55607986450195312f) * y_16 + -23.61347007751464844f) * y_16 + 5.00126314163208008f)) * x_27 + (((((10.91487026214599609f * y_16 + -6.08202791213989258f) * y_16 + -38.2036285400390625f) * y_16 + 53.3440399169921875f) * y_16 + -21.91996002197265625f) * y_16 + 2.01606011390686035f)) * x_27 + (((((-14.52206039428710938f * y_16 + 36.803619384765625f) * y_16 + -22.94047927856445312f) * y_16 + -10.07973003387451172f) * y_16 + 15.77003955841064453f) * y_16 + -4.92722177505493164f)) * x_27 + (((((-7.62505722045898438f * y_16 + 1.27310299873352051f) * y_16 + 31.19523048400878906f) * y_16 + -44.39989852905273438f) * y_16 + 26.44947052001953125f) * y_16 + -8.73507976531982422f)) * x_27 + (((((5.65633487701416016f * y_16 + -17.66820907592773438f) * y_16 + 24.65356063842773438f) * y_16 + -19.38941001892089844f) * y_16 + 11.06159019470214844f) * y_16 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_2)
{
    float _S316 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S317 = 2.0f * (F32_sqrt((_S316))) - 1.0f;
    float _S318 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_2, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S317, _S318), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S316) * sheen_shear_0(_S317, _S318), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S317, _S318), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_3, float3  view_5, float scale_0, float shear_0)
{
    float _S319 = light_3.z;
    bool _S320;
    if(_S319 <= 0.0f)
    {
        _S320 = true;
    }
    else
    {
        _S320 = (view_5.z) <= 0.0f;
    }
    if(_S320)
    {
        return 0.0f;
    }
    float2  _S321 = float2 {view_5.x, view_5.y};
    float _S322 = dot_1(_S321, _S321);
    float2  _S323;
    if(_S322 > 9.99999968265522539e-21f)
    {
        _S323 = _S321 * make_float2 ((F32_rsqrt((_S322))));
    }
    else
    {
        _S323 = make_float2 (1.0f, 0.0f);
    }
    float _S324 = scale_0 * dot_1(float2 {light_3.x, light_3.y}, _S323) + shear_0 * _S319;
    float _S325 = scale_0 * (light_3.y * _S323.x - light_3.x * _S323.y);
    float _S326 = _S324 * _S324 + _S325 * _S325 + _S319 * _S319;
    return 0.31830987334251404f * scale_0 * scale_0 * _S319 / (F32_max((_S326 * _S326), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_4, float3  view_6, float strength_0, float roughness_3)
{
    float3  _S327 = sheen_lobe_0(view_6.z, roughness_3);
    float _S328 = strength_0 * _S327.z;
    return make_float2 (_S328 * transformed_cosine_0(light_4, view_6, _S327.x, _S327.y), 1.0f - _S328);
}

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

__device__ SearchQuality_0 default_quality_0()
{
    SearchQuality_0 quality_0;
    (&quality_0)->steps_per_thread_0 = 5.0f;
    (&quality_0)->steps_per_relief_0 = 8.0f;
    (&quality_0)->shadow_share_0 = 1.0f;
    (&quality_0)->refinements_0 = 2U;
    return quality_0;
}

struct Shown_0
{
    bool is_warp_0;
    bool hole_1;
    bool on_top_0;
    uint word_0;
};

struct Crossing_0
{
    Cell_0 warp_4;
    Cell_0 weft_4;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_1, bool back_6)
{
    bool _S329 = (F32_abs(((&crossing_1->warp_4)->across_0))) < ((&crossing_1->warp_4)->half_width_1);
    bool _S330 = (F32_abs(((&crossing_1->weft_4)->across_0))) < ((&crossing_1->weft_4)->half_width_1);
    Shown_0 shown_0;
    bool _S331;
    if(_S329)
    {
        if(!_S330)
        {
            _S331 = true;
        }
        else
        {
            _S331 = crossing_1->warp_above_0;
        }
    }
    else
    {
        _S331 = false;
    }
    (&shown_0)->is_warp_0 = _S331;
    if(!_S329)
    {
        _S331 = !_S330;
    }
    else
    {
        _S331 = false;
    }
    (&shown_0)->hole_1 = _S331;
    uint _S332;
    if((&shown_0)->is_warp_0)
    {
        _S332 = crossing_1->warp_word_0;
    }
    else
    {
        _S332 = crossing_1->weft_word_0;
    }
    (&shown_0)->word_0 = _S332;
    (&shown_0)->on_top_0 = ((_S332 & 1U) == 1U) != back_6;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_5, Cell_0 * second_1)
{
    Cell_0 cell_3;
    uint _S333;
    if(is_first_0)
    {
        _S333 = first_5->thread_0;
    }
    else
    {
        _S333 = second_1->thread_0;
    }
    (&cell_3)->thread_0 = _S333;
    float _S334;
    if(is_first_0)
    {
        _S334 = first_5->across_0;
    }
    else
    {
        _S334 = second_1->across_0;
    }
    (&cell_3)->across_0 = _S334;
    if(is_first_0)
    {
        _S334 = first_5->half_width_1;
    }
    else
    {
        _S334 = second_1->half_width_1;
    }
    (&cell_3)->half_width_1 = _S334;
    if(is_first_0)
    {
        _S334 = first_5->below_0;
    }
    else
    {
        _S334 = second_1->below_0;
    }
    (&cell_3)->below_0 = _S334;
    if(is_first_0)
    {
        _S334 = first_5->above_0;
    }
    else
    {
        _S334 = second_1->above_0;
    }
    (&cell_3)->above_0 = _S334;
    return cell_3;
}

__device__ float boundary_0(uint family_10, uint thread_2, int step_0)
{
    float2  _S335 = turns_and_remainder_0(family_10, float(int(thread_2) + step_0));
    float _S336 = _S335.x;
    float _S337 = __ldg(&(&(globalParams_0->families_0)[family_10])->period_0);
    uint _S338 = __ldg(&(&(globalParams_0->families_0)[family_10])->place_table_0);
    return (F32_fma((_S336), (_S337), (table_number_0(_S338 + uint(_S335.y) * 4U))));
}

__device__ float span_0(uint family_11, uint thread_3, int first_6, int last_1)
{
    uint _S339 = __ldg(&(&(globalParams_0->families_0)[family_11])->is_alike_0);
    if(_S339 != 0U)
    {
        float _S340 = float(last_1 - first_6);
        float _S341 = __ldg(&(&(globalParams_0->families_0)[family_11])->size_0);
        return _S340 * _S341;
    }
    return boundary_0(family_11, thread_3, last_1) - boundary_0(family_11, thread_3, first_6);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

__device__ Bend_0 bend_of_0(uint family_12, uint thread_4)
{
    uint _S342 = __ldg(&(&(globalParams_0->families_0)[family_12])->bend_table_0);
    uint _S343 = __ldg(&(&(globalParams_0->families_0)[family_12])->is_alike_0);
    uint _S344;
    if(_S343 != 0U)
    {
        _S344 = 0U;
    }
    else
    {
        _S344 = thread_4 * 4U;
    }
    uint _S345 = _S342 + _S344;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S345);
    (&bend_0)->half_tangent_0 = table_number_0(_S345 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S345 + 2U);
    return bend_0;
}

struct Run_0
{
    float distance_0;
    bool near_start_0;
    float from_start_0;
    float to_end_0;
    float reach_0;
    float other_reach_0;
    Bend_0 bend_1;
    bool straight_0;
    bool first_crossing_0;
    bool last_crossing_0;
};

__device__ Run_0 unpack_0(uint own_1, uint other_1, uint thread_5, Cell_0 * crossed_0, uint word_1)
{
    int _S346 = int((word_1 >> int(1)) & 127U);
    int _S347 = int((word_1 >> int(8)) & 127U);
    int _S348 = int((word_1 >> int(15)) & 63U);
    int _S349 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S350 = crossed_0->thread_0;
    int _S351 = - _S346;
    float _S352 = crossed_0->below_0 + span_0(other_1, crossed_0->thread_0, _S351, int(0));
    (&run_0)->from_start_0 = _S352;
    int _S353 = _S347 + int(1);
    float _S354 = crossed_0->above_0 + span_0(other_1, crossed_0->thread_0, int(1), _S353);
    (&run_0)->to_end_0 = _S354;
    bool _S355 = _S352 < _S354;
    (&run_0)->near_start_0 = _S355;
    int _S356;
    if(_S355)
    {
        _S356 = _S351 - _S348;
    }
    else
    {
        _S356 = _S353;
    }
    int _S357;
    if((&run_0)->near_start_0)
    {
        _S357 = _S351;
    }
    else
    {
        _S357 = _S353 + _S349;
    }
    (&run_0)->bend_1 = bend_of_0(own_1, thread_5);
    float _S358;
    if((&run_0)->straight_0)
    {
        _S358 = 1.0e+06f;
    }
    else
    {
        _S358 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S358;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_1, _S350, _S356, _S357)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S346 == int(0);
    (&run_0)->last_crossing_0 = _S347 == int(0);
    return run_0;
}

__device__ float square_1(float x_28)
{
    return x_28 * x_28;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_4)
{
    float _S359 = cell_4->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S360 = clamp_1(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_3 = _S360;
    float _S361 = _S359 * _S359 - square_1(_S360);
    float _S362 = (F32_rsqrt((_S361)));
    (&section_0)->drop_0 = _S359 - _S361 * _S362;
    (&section_0)->slope_0 = - _S360 * _S362;
    return section_0;
}

__device__ float edge_drop_0(uint family_13, uint thread_6, int step_1)
{
    uint _S363 = __ldg(&(&(globalParams_0->families_0)[family_13])->is_alike_0);
    if(_S363 != 0U)
    {
        uint _S364 = __ldg(&(&(globalParams_0->families_0)[family_13])->bend_table_0);
        return table_number_0(_S364 + 3U);
    }
    uint _S365 = __ldg(&(&(globalParams_0->families_0)[family_13])->bend_table_0);
    return table_number_0(_S365 + uint(turns_and_remainder_0(family_13, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_2, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S366 = crossed_1->below_0;
    float _S367 = crossed_1->above_0;
    bool _S368 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S369 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S370;
    if(_S368)
    {
        _S370 = _S366 - crossed_1->across_0;
    }
    else
    {
        _S370 = _S367 + crossed_1->across_0;
    }
    float _S371 = _S370 - crossed_1->half_width_1;
    bool _S372;
    if(_S368)
    {
        _S372 = run_1->first_crossing_0;
    }
    else
    {
        _S372 = run_1->last_crossing_0;
    }
    bool _S373 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S370 = 0.0f;
    }
    else
    {
        float _S374 = __ldg(&(&(globalParams_0->families_0)[other_2])->height_scale_0);
        _S370 = _S374 * edge_drop_0(other_2, crossed_1->thread_0, int(0));
    }
    float _S375;
    if(_S373 != _S372)
    {
        _S375 = 0.0f;
    }
    else
    {
        float _S376 = __ldg(&(&(globalParams_0->families_0)[other_2])->height_scale_0);
        uint _S377 = crossed_1->thread_0;
        int _S378;
        if(_S368)
        {
            _S378 = int(-1);
        }
        else
        {
            _S378 = int(1);
        }
        _S375 = _S376 * edge_drop_0(other_2, _S377, _S378);
    }
    float _S379 = 1.0f / (F32_max((2.0f * _S371), (9.999999960041972e-13f)));
    float _S380 = clamp_1((_S371 - _S369) * _S379, 0.0f, 1.0f);
    float _S381 = _S370 + (_S375 - _S370) * (_S380 * _S380 * (3.0f - 2.0f * _S380));
    float _S382 = (_S370 - _S375) * (6.0f * _S380 * (1.0f - _S380) * _S379);
    if(_S368)
    {
        _S370 = 1.0f;
    }
    else
    {
        _S370 = -1.0f;
    }
    return make_float2 (_S381, _S382 * _S370);
}

struct StepControl_0
{
    float step_2;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_1;
    bool up_0;
};

__device__ StepControl_0 step_control_0(float2  direction_3, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S383 = direction_3.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S383)))), (9.99999971718068537e-10f)));
    float _S384 = direction_3.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S384)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S383 > 0.0f;
    (&control_0)->up_0 = _S384 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
    float clearance_0;
    float rate_0;
    uint yarn_1;
    bool known_0;
};

__device__ PreviousSample_0 no_previous_sample_0()
{
    PreviousSample_0 previous_0;
    (&previous_0)->clearance_0 = 0.0f;
    (&previous_0)->rate_0 = 0.0f;
    (&previous_0)->yarn_1 = 0U;
    (&previous_0)->known_0 = false;
    return previous_0;
}

__device__ float outline_distance_0(Cell_0 * cell_5, Shown_0 * shown_2, Run_0 * run_2, bool lengthwise_0, bool forwards_0)
{
    float _S385;
    if(forwards_0)
    {
        _S385 = cell_5->across_0;
    }
    else
    {
        _S385 = - cell_5->across_0;
    }
    float _S386;
    if(forwards_0)
    {
        _S386 = cell_5->above_0;
    }
    else
    {
        _S386 = cell_5->below_0;
    }
    bool _S387;
    if(forwards_0)
    {
        _S387 = run_2->last_crossing_0;
    }
    else
    {
        _S387 = run_2->first_crossing_0;
    }
    bool _S388;
    if(forwards_0)
    {
        _S388 = run_2->first_crossing_0;
    }
    else
    {
        _S388 = run_2->last_crossing_0;
    }
    float _S389 = cell_5->half_width_1;
    float _S390 = - cell_5->half_width_1;
    bool _S391 = _S385 < _S390;
    bool _S392 = _S385 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S387 = !_S387;
    }
    else
    {
        _S387 = false;
    }
    if(_S387)
    {
        _S387 = !shown_2->hole_1;
    }
    else
    {
        _S387 = false;
    }
    bool _S393;
    if(_S387)
    {
        _S393 = shown_2->on_top_0;
    }
    else
    {
        _S393 = false;
    }
    if(_S393)
    {
        if(_S388)
        {
            _S388 = _S391;
        }
        else
        {
            _S388 = false;
        }
        _S388 = !_S388;
    }
    else
    {
        _S388 = false;
    }
    if(shown_2->hole_1)
    {
        _S387 = true;
    }
    else
    {
        if(_S387)
        {
            _S387 = !shown_2->on_top_0;
        }
        else
        {
            _S387 = false;
        }
    }
    float _S394;
    if(_S391)
    {
        _S394 = _S390;
    }
    else
    {
        _S394 = _S389;
    }
    float _S395 = _S394 - _S385;
    if(_S387)
    {
        _S385 = 2.0f * _S386 + _S385 - _S389;
    }
    else
    {
        _S385 = _S386;
    }
    if(_S388)
    {
        if(forwards_0)
        {
            _S385 = run_2->to_end_0;
        }
        else
        {
            _S385 = run_2->from_start_0;
        }
        return _S385;
    }
    if(_S392)
    {
    }
    else
    {
        _S385 = _S395;
    }
    return _S385;
}

struct Probe_0
{
    float height_2;
    bool hole_2;
    float slope_x_0;
    float slope_y_0;
    uint yarn_2;
    float cell_max_0;
    float side_x_0;
    float side_y_0;
    float edge_x_0;
    float edge_y_0;
};

__device__ float way_back_to_dip_0(PreviousSample_0 * previous_1, float clearance_1, float rate_1, float step_4, Probe_0 * here_0)
{
    float _S396 = previous_1->rate_0;
    float _S397 = previous_1->rate_0 * step_4;
    float _S398 = rate_1 * step_4;
    bool _S399;
    if(!previous_1->known_0)
    {
        _S399 = true;
    }
    else
    {
        _S399 = here_0->hole_2;
    }
    if(_S399)
    {
        _S399 = true;
    }
    else
    {
        _S399 = (previous_1->yarn_1) != (here_0->yarn_2);
    }
    if(_S399)
    {
        _S399 = true;
    }
    else
    {
        _S399 = _S396 >= 0.0f;
    }
    if(_S399)
    {
        _S399 = true;
    }
    else
    {
        _S399 = rate_1 <= 0.0f;
    }
    if(_S399)
    {
        return -1.0f;
    }
    float _S400 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S397) >= 0.0f)
    {
        _S399 = (3.0f * clearance_1 - _S398) >= 0.0f;
    }
    else
    {
        _S399 = false;
    }
    if(_S399)
    {
        return -1.0f;
    }
    float _S401 = clearance_1 - _S400;
    float _S402 = 6.0f * _S401 - 4.0f * _S397 - 2.0f * _S398;
    float _S403 = -2.0f * _S397 / (F32_max((_S402 + (F32_sqrt(((F32_max((_S402 * _S402 - 4.0f * (3.0f * (_S397 + _S398 - 2.0f * _S401)) * _S397), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S404 = 1.0f - _S403;
    float _S405 = (_S400 * (2.0f * _S403 + 1.0f) + _S397 * _S403) * _S404 * _S404;
    float _S406 = (clearance_1 * (2.0f * _S404 + 1.0f) - _S398 * _S404) * _S403 * _S403;
    if(_S403 > 0.01999999955296516f)
    {
        _S399 = _S404 > 0.01999999955296516f;
    }
    else
    {
        _S399 = false;
    }
    if(_S399)
    {
        _S399 = (_S405 + _S406) < 0.0f;
    }
    else
    {
        _S399 = false;
    }
    float _S407;
    if(_S399)
    {
        _S407 = _S404 * step_4;
    }
    else
    {
        _S407 = -1.0f;
    }
    return _S407;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S408 = here_1->hole_2;
    float _S409;
    if(here_1->hole_2)
    {
        _S409 = 1.0e+09f;
    }
    else
    {
        _S409 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S409;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_1 = here_1->yarn_2;
    bool _S410;
    if(!_S408)
    {
        _S410 = !is_cell_exit_0;
    }
    else
    {
        _S410 = false;
    }
    (&previous_2)->known_0 = _S410;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_5, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_5->per_x_0), (side_y_1 * this_5->per_y_0)))), (0.0f))) + this_5->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_6, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S411 = (F32_min((here_2->edge_x_0 * this_6->per_x_0), (here_2->edge_y_0 * this_6->per_y_0)));
    bool _S412;
    if(!here_2->hole_2)
    {
        _S412 = (rate_3 * _S411 + clearance_3) < 0.0f;
    }
    else
    {
        _S412 = false;
    }
    if(_S412)
    {
        _S412 = _S411 > (2.0f * this_6->epsilon_0);
    }
    else
    {
        _S412 = false;
    }
    float _S413 = this_6->step_2;
    float _S414;
    if(_S412)
    {
        _S414 = _S411 - this_6->epsilon_0;
    }
    else
    {
        _S414 = (F32_max((_S411), (0.0f))) + this_6->epsilon_0;
    }
    return (F32_min((_S413), (_S414)));
}

struct ViewRay_0
{
    float2  origin_0;
    float2  slope_1;
};

__device__ float2  ViewRay_at_0(ViewRay_0 * this_7, float height_3)
{
    return this_7->origin_0 + this_7->slope_1 * make_float2 (height_3);
}

__device__ float ViewRay_rate_0(ViewRay_0 * this_8, Probe_0 * here_3)
{
    return here_3->slope_x_0 * this_8->slope_1.x + here_3->slope_y_0 * this_8->slope_1.y - 1.0f;
}

__device__ float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S415 = end_0 - start_1;
    float _S416 = start_rate_0 + end_rate_0 - 2.0f * _S415;
    float _S417 = 3.0f * _S415 - 2.0f * start_rate_0 - end_rate_0;
    float share_2 = start_1 / (F32_max((- _S415), (9.99999968265522539e-21f)));
    int i_10 = int(0);
    for(;;)
    {
        if(uint(i_10) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S418 = clamp_1(share_2 - (((_S416 * share_2 + _S417) * share_2 + start_rate_0) * share_2 + start_1) / (F32_min(((3.0f * _S416 * share_2 + 2.0f * _S417) * share_2 + start_rate_0), (0.10000000149011612f * _S415 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S419 = i_10 + int(1);
        share_2 = _S418;
        i_10 = _S419;
    }
    return share_2;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_1(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S420 = along_slope_0 * along_slope_0 + 1.0f;
    float _S421 = (F32_rsqrt((_S420)));
    float _S422 = sine_1 * _S421 * (F32_rsqrt((_S420 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S422 * _S420, _S422 * across_slope_0 * along_slope_0 + cosine_0 * _S421);
}

__device__ float arc_sine_0(float x_29)
{
    float _S423 = (F32_abs((x_29)));
    bool _S424 = _S423 > 0.5f;
    float _S425;
    if(_S424)
    {
        _S425 = 0.5f * (1.0f - _S423);
    }
    else
    {
        _S425 = _S423 * _S423;
    }
    float _S426;
    if(_S424)
    {
        _S426 = (F32_sqrt(((F32_max((_S425), (0.0f))))));
    }
    else
    {
        _S426 = _S423;
    }
    float _S427 = ((((0.04216320067644119f * _S425 + 0.02418131195008755f) * _S425 + 0.04547002539038658f) * _S425 + 0.07495300471782684f) * _S425 + 0.16666752099990845f) * _S425 * _S426 + _S426;
    if(_S424)
    {
        _S425 = 1.57079637050628662f - 2.0f * _S427;
    }
    else
    {
        _S425 = _S427;
    }
    if(x_29 < 0.0f)
    {
        _S425 = - _S425;
    }
    return _S425;
}

struct Hair_0
{
    float cover_0;
    float3  normal_0;
    float3  tangent_1;
};

__device__ Hair_0 Hair_x24init_0(float cover_1, float3  normal_1, float3  tangent_2)
{
    Hair_0 _S428;
    (&_S428)->cover_0 = cover_1;
    (&_S428)->normal_0 = normal_1;
    (&_S428)->tangent_1 = tangent_2;
    return _S428;
}

__device__ float fade_0(float size_4, float period_1)
{
    return clamp_1((1.0f - size_4 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S429 = value_0 * 747796405U + 2891336453U;
    uint _S430 = ((_S429 >> ((_S429 >> int(28)) + 4U)) ^ _S429) * 277803737U;
    return (_S430 >> int(22)) ^ _S430;
}

__device__ uint hash_key_0(uint thread_7, uint stream_0)
{
    return scramble_0(thread_7 + scramble_0(stream_0));
}

__device__ uint hash_bits_0(uint key_0, uint cell_6)
{
    return scramble_0(cell_6 + key_0);
}

__device__ float share_of_0(uint bits_2)
{
    return (float(bits_2 & 1023U) + 0.5f) * 0.0009765625f;
}

__device__ float2  sine_cosine_0(float x_30)
{
    float _S431 = (F32_floor((x_30 * 0.63661974668502808f + 0.5f)));
    float _S432 = x_30 - _S431 * 1.5703125f - _S431 * 0.00048375129699707f - _S431 * 7.54979012640433211e-08f;
    float _S433 = _S432 * _S432;
    float _S434 = ((-0.00019515295571182f * _S433 + 0.00833216123282909f) * _S433 - 0.16666655242443085f) * _S433 * _S432 + _S432;
    float _S435 = ((0.00002443315679557f * _S433 - 0.00138873164542019f) * _S433 + 0.04166664555668831f) * _S433 * _S433 - 0.5f * _S433 + 1.0f;
    uint _S436 = uint(int(_S431)) & 3U;
    float2  _S437;
    if((_S436 & 1U) != 0U)
    {
        _S437 = make_float2 (_S435, _S434);
    }
    else
    {
        _S437 = make_float2 (_S434, _S435);
    }
    float _S438;
    if((_S436 & 2U) != 0U)
    {
        _S438 = - _S437.x;
    }
    else
    {
        _S438 = _S437.x;
    }
    float _S439;
    if(((_S436 + 1U) & 2U) != 0U)
    {
        _S439 = - _S437.y;
    }
    else
    {
        _S439 = _S437.y;
    }
    return make_float2 (_S438, _S439);
}

__device__ Albedos_0 albedos_of_0(uint family_14, uint thread_8)
{
    uint _S440 = __ldg(&(&(globalParams_0->families_0)[family_14])->albedo_table_0);
    uint _S441 = __ldg(&(&(globalParams_0->families_0)[family_14])->albedo_stride_0);
    return table_albedos_0(_S440 + _S441 * thread_8);
}

__device__ float3  fibre_cell_0(float across_4, float along_1, float width_3)
{
    float _S442 = (F32_floor((across_4 / width_3)));
    return make_float3 (_S442, along_1 / (width_3 * 40.0f) + 0.61799997091293335f * _S442, 2.0f * (across_4 / width_3 - _S442) - 1.0f);
}

struct SurfacePoint_0
{
    bool hole_3;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_4;
    float3  normal_2;
    float3  tangent_3;
    float across_5;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ float ply_offset_0(uint family_15, SurfacePoint_0 * point_0, bool back_7)
{
    float _S443;
    if(back_7)
    {
        float _S444 = __ldg(&(&(globalParams_0->families_0)[family_15])->ply_sine_0);
        _S443 = - _S444;
    }
    else
    {
        float _S445 = __ldg(&(&(globalParams_0->families_0)[family_15])->ply_sine_0);
        _S443 = _S445;
    }
    float _S446 = point_0->fibre_across_0;
    float _S447 = __ldg(&(&(globalParams_0->families_0)[family_15])->ply_cosine_0);
    float _S448 = _S446 * _S447 + point_0->fibre_along_0 * _S443;
    float _S449 = __ldg(&(&(globalParams_0->families_0)[family_15])->plies_per_mm_0);
    float _S450 = _S448 * _S449;
    return 2.0f * (_S450 - (F32_floor((_S450)))) - 1.0f;
}

__device__ float signed_noise_0(uint bits_3)
{
    return (float(bits_3 & 65535U) + 0.5f) * 0.000030517578125f - 1.0f;
}

__device__ float smooth_share_0(float share_3)
{
    return share_3 * share_3 * (3.0f - 2.0f * share_3);
}

__device__ float2  wave_noise_0(uint key_1, float position_4)
{
    float _S451 = (F32_floor((position_4)));
    float _S452 = position_4 - _S451;
    uint _S453 = uint(int(_S451));
    float _S454 = signed_noise_0(hash_bits_0(key_1, _S453));
    float _S455 = signed_noise_0(hash_bits_0(key_1, _S453 + 1U));
    return make_float2 (lerp_0(_S454, _S455, smooth_share_0(_S452)), 6.0f * _S452 * (1.0f - _S452) * (_S455 - _S454));
}

__device__ float2  cell_noise_0(uint key_2, float3  cell_7)
{
    float _S456 = cell_7.y;
    float _S457 = (F32_floor((_S456)));
    uint _S458 = uint(int(cell_7.x)) * 65536U + uint(int(_S457));
    uint _S459 = hash_bits_0(key_2, _S458);
    uint _S460 = hash_bits_0(key_2, _S458 + 1U);
    return lerp_2(make_float2 (signed_noise_0(_S459), signed_noise_0(_S459 >> int(16))), make_float2 (signed_noise_0(_S460), signed_noise_0(_S460 >> int(16))), make_float2 (smooth_share_0(_S456 - _S457)));
}

__device__ float uniform_hash_0(uint thread_9, uint cell_8, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_9, stream_1), cell_8)) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float thread_gain_0(uint thread_10, float amount_0, uint seed_3)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, 0U, seed_3 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_1, float3  room_0)
{
    float3  _S461 = room_0 / max_0(albedo_1, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S461.x), (_S461.y)))), (_S461.z)))), (0.0f))))));
}

__device__ float flattened_0(float largest_0, float3  albedo_2, float3  room_1)
{
    float3  _S462 = room_1 / max_0(albedo_2, make_float3 (9.99999997475242708e-07f)) - make_float3 (1.0f);
    return (F32_min(((F32_max(((F32_min(((F32_min((_S462.x), (_S462.y)))), (_S462.z)))), (0.0f))) / (F32_max((largest_0), (9.99999997475242708e-07f)))), (1.0f)));
}

__device__ float natural_logarithm_0(float x_31)
{
    uint _S463 = (F32_asuint((x_31)));
    float exponent_0 = float(int(_S463 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S463 & 8388607U) | 1056964608U)));
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
    float _S464 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S464 - exponent_1 * 0.00021219444170129f - 0.5f * _S464) + exponent_1 * 0.693359375f;
}

__device__ float fibre_gain_0(uint thread_11, uint cell_9, float amount_1, uint seed_4)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_11, cell_9, seed_4 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
    float3  normal_3;
    float3  tangent_4;
    float loss_0;
};

__device__ YarnFrame_0 under_hair_0(YarnFrame_0 * frame_0, Hair_0 * hair_0)
{
    float3  _S465 = frame_0->tangent_4;
    float3  _S466 = hair_0->tangent_1;
    float3  _S467;
    if((dot_0(frame_0->tangent_4, hair_0->tangent_1)) < 0.0f)
    {
        _S467 = - _S466;
    }
    else
    {
        _S467 = _S466;
    }
    YarnFrame_0 blended_0;
    float3  _S468 = make_float3 (hair_0->cover_0);
    float3  _S469 = normalize_0(lerp_1(frame_0->normal_3, hair_0->normal_0, _S468));
    (&blended_0)->normal_3 = _S469;
    float3  _S470 = lerp_1(_S465, _S467, _S468);
    float3  _S471 = _S470 - make_float3 (dot_0(_S470, _S469)) * _S469;
    (&blended_0)->tangent_4 = _S471 * make_float3 ((F32_rsqrt(((F32_max((dot_0(_S471, _S471)), (9.999999960041972e-13f)))))));
    (&blended_0)->loss_0 = frame_0->loss_0 * (1.0f - hair_0->cover_0);
    return blended_0;
}

__device__ float diffuse_gain_0(YarnFrame_0 * frame_1, float blend_0)
{
    return (F32_min((0.85000002384185791f * blend_0 * frame_1->loss_0 + 1.0f), (1.0f / (0.5f * blend_0 * (frame_1->normal_3.z - 1.0f) + 1.0f))));
}

__device__ uint texel_along_0(float share_4, uint first_7, float extent_1, uint count_2)
{
    float _S472 = (F32_min(((F32_floor((share_4 * extent_1)))), (extent_1 - 1.0f)));
    float _S473 = float(count_2);
    uint _S474 = first_7 + (U32_min((uint((F32_max((_S472 - (F32_floor((_S472 / _S473))) * _S473), (0.0f))))), (count_2 - 1U)));
    uint _S475;
    if(_S474 >= count_2)
    {
        _S475 = _S474 - count_2;
    }
    else
    {
        _S475 = _S474;
    }
    return _S475;
}

__device__ uint texel_of_0(Clustered_0 * tables_4, TexelBox_0 * box_3, float2  share_5)
{
    return texel_along_0(share_5.y, box_3->first_1.y, box_3->extent_0.y, tables_4->rows_0) * tables_4->columns_0 + texel_along_0(share_5.x, box_3->first_1.x, box_3->extent_0.x, tables_4->columns_0);
}

__device__ uint table_byte_0(uint table_1, uint index_3)
{
    uint _S476 = __ldg((&(globalParams_0->words_0)[table_1 + index_3 / 4U]));
    return (_S476 >> (8U * (index_3 & 3U))) & 255U;
}

__device__ float diffuse_reflection_0(float3  light_5, float3  normal_4, float blend_1)
{
    float _S477 = light_5.z;
    if(_S477 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S477), (0.0f))), (F32_max((dot_0(light_5, normal_4)), (0.0f))), blend_1);
}

__device__ float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

__device__ float flake_density_0(float squared_along_0, float roughness_4)
{
    float _S478 = roughness_4 * roughness_4;
    float _S479 = squared_along_0 * (1.0f - _S478) + _S478;
    return 0.31830987334251404f * _S478 * roughness_4 / (_S479 * _S479);
}

__device__ float density_between_0(float3  light_6, float3  view_7, float3  tangent_5, float roughness_5)
{
    float3  _S480 = light_6 + view_7;
    float _S481 = dot_0(_S480, tangent_5);
    return flake_density_0((F32_min((_S481 * _S481 / (F32_max((square_0(_S480)), (9.999999960041972e-13f)))), (1.0f))), roughness_5);
}

__device__ float transmission_1(float3  light_7, float3  view_8, float3  normal_5, float3  tangent_6, float roughness_6, float optical_depth_1)
{
    float _S482 = - dot_0(light_7, normal_5);
    float _S483 = dot_0(view_8, normal_5);
    bool _S484;
    if(_S482 <= 0.0f)
    {
        _S484 = true;
    }
    else
    {
        _S484 = _S483 <= 0.0f;
    }
    if(_S484)
    {
        return 0.0f;
    }
    float _S485 = 1.0f / (F32_max((_S483), (9.99999997475242708e-07f)));
    float _S486 = projected_area_1(light_7, tangent_6, roughness_6) / (F32_max((_S482), (9.99999997475242708e-07f)));
    float _S487 = projected_area_1(view_8, tangent_6, roughness_6) * _S485;
    return density_between_0(light_7, view_8, tangent_6, roughness_6) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * (F32_min((_S486), (_S487)))) * mean_attenuation_0(optical_depth_1 * (F32_abs((_S486 - _S487)))) * _S485;
}

__device__ float reflection_0(float3  light_8, float3  view_9, float3  normal_6, float3  tangent_7, float roughness_7, float optical_depth_2)
{
    float _S488 = dot_0(light_8, normal_6);
    bool _S489;
    if(_S488 <= 0.0f)
    {
        _S489 = true;
    }
    else
    {
        _S489 = (dot_0(view_9, normal_6)) <= 0.0f;
    }
    if(_S489)
    {
        return 0.0f;
    }
    float _S490 = (F32_max((_S488), (9.99999997475242708e-07f)));
    float _S491 = (F32_max((dot_0(view_9, normal_6)), (9.99999997475242708e-07f)));
    float _S492 = projected_area_1(light_8, tangent_7, roughness_7) * _S491 + projected_area_1(view_9, tangent_7, roughness_7) * _S490;
    float _S493 = optical_depth_2 * _S492 / (_S490 * _S491);
    return 0.25f * density_between_0(light_8, view_9, tangent_7, roughness_7) * (_S493 * mean_attenuation_0(_S493)) * _S490 / _S492;
}

struct ClusteredView_0
{
    ViewedBase_0 base_0;
    FamilyAlbedos_0 albedos_5;
    Bounced_0 bounced_2;
    float3  view_10;
    bool is_alone_0;
};

__device__ ViewedBase_0 viewed_base_0(uint _S494, Footprint_0 * _S495, float3  _S496, float _S497, bool _S498)
{
    Fabric_0 * _S499 = (&(globalParams_0->fabrics_0)[_S494]);
    ViewedBase_0 seen_1;
    bool _S500 = (_S496.z) < 0.0f;
    (&seen_1)->back_5 = _S500;
    (&seen_1)->view_3 = to_face_frame_0(_S496, _S500);
    uint _S501;
    if(_S500)
    {
        _S501 = 1U;
    }
    else
    {
        _S501 = 0U;
    }
    (&seen_1)->face_2 = _S501;
    BinTaps_0 _S502 = bin_taps_0((&seen_1)->view_3, 16U);
    (&seen_1)->around_1 = _S502;
    uint _S503 = _S501 * 256U;
    Clustered_0 _S504 = slang_ldg_1(&_S499->clustered_0);
    BinTaps_0 _S505 = _S502;
    float _S506 = BinTaps_read_0(&_S505, _S504.offset_1, _S503, 2U, 0U);
    BinTaps_0 _S507 = _S502;
    float _S508 = BinTaps_read_0(&_S507, _S504.offset_1, _S503, 2U, 1U);
    float2  _S509 = make_float2 (_S506, _S508);
    float _S510 = _S497 - 0.5f;
    Clustered_0 _S511 = _S504;
    TexelBox_0 _S512 = texel_box_0(&_S511, _S495, _S509, _S510);
    (&seen_1)->box_2 = _S512;
    (&seen_1)->trust_1 = make_float2 (1.0f);
    if(!_S498)
    {
        BinTaps_0 _S513 = (&seen_1)->around_1;
        float _S514 = BinTaps_read_0(&_S513, _S504.trust_0, _S503, 2U, 0U);
        BinTaps_0 _S515 = (&seen_1)->around_1;
        float _S516 = BinTaps_read_0(&_S515, _S504.trust_0, _S503, 2U, 1U);
        (&seen_1)->trust_1 = make_float2 (_S514, _S516);
    }
    return seen_1;
}

__device__ FamilyAlbedos_0 albedos_over_0(uint _S517, Footprint_0 * _S518, bool _S519)
{
    Fabric_0 * _S520 = (&(globalParams_0->fabrics_0)[_S517]);
    float2  _S521 = sqrt_0(_S518->dx_0 * _S518->dx_0 + _S518->dy_0 * _S518->dy_0);
    uint _S522 = __ldg(&_S520->warp_0);
    float2  _S523 = _S518->centre_0;
    Stretch_0 _S524 = stretch_of_0(_S522, _S518->centre_0.x, _S521.x);
    uint _S525 = __ldg(&_S520->weft_0);
    Stretch_0 _S526 = stretch_of_0(_S525, _S523.y, _S521.y);
    FamilyAlbedos_0 albedos_6;
    Stretch_0 _S527 = _S524;
    Stretch_0 _S528 = _S526;
    Albedos_0 _S529 = mean_albedos_0(_S522, _S525, &_S527, &_S528, _S519);
    (&albedos_6)->warp_3 = _S529;
    Stretch_0 _S530 = _S526;
    Stretch_0 _S531 = _S524;
    Albedos_0 _S532 = mean_albedos_0(_S525, _S522, &_S530, &_S531, _S519);
    (&albedos_6)->weft_3 = _S532;
    return albedos_6;
}

__device__ float openness_number_0(uint _S533, uint _S534)
{
    uint _S535 = __ldg(&(&(globalParams_0->fabrics_0)[_S533])->openness_0);
    return table_number_0(_S535 + _S534);
}

__device__ Scattered_0 scattered_by_0(uint _S536, Albedos_0 * _S537, uint _S538, float3  _S539)
{
    uint _S540 = 159U + 2U * _S538;
    Scattered_0 yarn_3;
    float3  _S541 = _S539 * _S537->diffuse_reflect_0;
    float _S542 = openness_number_0(_S536, _S540);
    (&yarn_3)->back_4 = _S541 + make_float3 (_S542) * _S537->specular_reflect_0;
    float3  _S543 = _S539 * _S537->diffuse_transmit_0;
    float _S544 = openness_number_0(_S536, _S540 + 1U);
    (&yarn_3)->through_0 = _S543 + make_float3 (_S544) * _S537->specular_transmit_0;
    return yarn_3;
}

__device__ void sent_0(uint _S545, uint _S546, float3  _S547, float3  _S548, float3  _S549, float3  _S550, float3  * _S551, float3  * _S552)
{
    uint _S553 = 146U + 4U * _S546;
    float _S554 = openness_number_0(_S545, _S553);
    float _S555 = openness_number_0(_S545, _S553 + 1U);
    float _S556 = openness_number_0(_S545, _S553 + 2U);
    float _S557 = openness_number_0(_S545, _S553 + 3U);
    float3  _S558 = make_float3 (1.0f) - _S549 * make_float3 (_S554);
    float3  _S559 = make_float3 (1.0f) - _S550 * make_float3 (_S557);
    float3  _S560 = make_float3 (1.0f) / (_S558 * _S559 - _S549 * _S550 * make_float3 (_S555 * _S556));
    *_S551 = (_S547 * _S559 + _S549 * make_float3 (_S555) * _S548) * _S560;
    *_S552 = (_S548 * _S558 + _S550 * make_float3 (_S556) * _S547) * _S560;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S561, uint _S562, Scattered_0 * _S563, Scattered_0 * _S564)
{
    uint _S565 = 2U * _S562;
    uint _S566 = 142U + _S565;
    float _S567 = openness_number_0(_S561, _S566);
    float _S568 = openness_number_0(_S561, _S566 + 1U);
    float3  _S569 = make_float3 (1.0f - _S567) * _S563->back_4;
    float3  _S570 = make_float3 (1.0f - _S568) * _S564->back_4;
    FaceSends_0 sends_1;
    uint _S571 = 154U + _S565;
    float _S572 = openness_number_0(_S561, _S571);
    (&sends_1)->blocks_warp_0 = _S572;
    float _S573 = openness_number_0(_S561, _S571 + 1U);
    (&sends_1)->blocks_weft_0 = _S573;
    (&sends_1)->open_0 = _S572 * _S567 + _S573 * _S568;
    sent_0(_S561, _S562, make_float3 (_S567) * _S563->back_4, make_float3 (_S568) * _S564->back_4, _S569, _S570, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S561, _S562, _S563->through_0, _S564->through_0, _S569, _S570, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S574, float3  _S575, bool _S576)
{
    Fabric_0 * _S577 = (&(globalParams_0->fabrics_0)[_S574]);
    uint _S578 = __ldg(&_S577->warp_0);
    uint _S579 = __ldg(&(&(globalParams_0->families_0)[_S578])->colour_mean_0);
    Albedos_0 _S580 = table_albedos_0(_S579);
    Scattered_0 _S581 = scattered_by_0(_S574, &_S580, 0U, _S575);
    uint _S582 = __ldg(&_S577->weft_0);
    uint _S583 = __ldg(&(&(globalParams_0->families_0)[_S582])->colour_mean_0);
    Albedos_0 _S584 = table_albedos_0(_S583);
    Scattered_0 _S585 = scattered_by_0(_S574, &_S584, 1U, _S575);
    uint _S586;
    if(_S576)
    {
        _S586 = 1U;
    }
    else
    {
        _S586 = 0U;
    }
    Scattered_0 _S587 = _S581;
    Scattered_0 _S588 = _S585;
    FaceSends_0 _S589 = face_sends_0(_S574, _S586, &_S587, &_S588);
    if(_S576)
    {
        _S586 = 0U;
    }
    else
    {
        _S586 = 1U;
    }
    Scattered_0 _S590 = _S581;
    Scattered_0 _S591 = _S585;
    FaceSends_0 _S592 = face_sends_0(_S574, _S586, &_S590, &_S591);
    float3  _S593 = make_float3 (_S589.blocks_warp_0) * _S589.crossing_warp_0 + make_float3 (_S589.blocks_weft_0) * _S589.crossing_weft_0;
    float3  _S594 = make_float3 (_S592.blocks_warp_0) * _S592.crossing_warp_0 + make_float3 (_S592.blocks_weft_0) * _S592.crossing_weft_0;
    float _S595 = 1.0f - _S589.open_0;
    float _S596 = 1.0f - _S592.open_0;
    float3  _S597 = make_float3 (1.0f) / (make_float3 (1.0f) - _S593 * _S594 * make_float3 (_S595 * _S596));
    float3  _S598 = _S594 * (make_float3 (_S589.open_0) + make_float3 (_S595) * (make_float3 (_S589.blocks_warp_0) * _S589.sky_warp_0 + make_float3 (_S589.blocks_weft_0) * _S589.sky_weft_0)) * _S597;
    float3  _S599 = _S593 * (make_float3 (_S592.open_0) + make_float3 (_S596) * (make_float3 (_S592.blocks_warp_0) * _S592.sky_warp_0 + make_float3 (_S592.blocks_weft_0) * _S592.sky_weft_0)) * _S597;
    FaceSends_0 _S600 = _S589;
    FaceRadiance_0 _S601 = face_radiance_0(&_S600, _S592.open_0, _S598, _S599);
    FaceSends_0 _S602 = _S592;
    FaceRadiance_0 _S603 = face_radiance_0(&_S602, _S589.open_0, _S599, _S598);
    Interior_0 interior_1;
    (&interior_1)->warp_2 = _S601.warp_1;
    (&interior_1)->weft_2 = _S601.weft_1;
    (&interior_1)->leaked_1 = _S601.leaked_0;
    (&interior_1)->far_1 = _S603.mean_0;
    (&interior_1)->far_leaked_0 = _S603.leaked_0;
    return interior_1;
}

__device__ Blocked_0 blocked_of_terms_0(uint _S604, uint _S605, FixedArray<float, 6>  * _S606, uint _S607)
{
    FixedArray<float, 3>  shares_0;
    uint share_6 = 0U;
    for(;;)
    {
        if(share_6 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_6] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S607)
            {
            }
            else
            {
                break;
            }
            float _S608 = openness_number_0(_S604, _S605 + share_6 * _S607 + term_0);
            shares_0[share_6] = shares_0[share_6] + _S608 * (*_S606)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_6] = saturate_0(shares_0[share_6]);
        share_6 = share_6 + 1U;
    }
    Blocked_0 blocked_2;
    (&blocked_2)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_2)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_2)->far_0 = shares_0[int(1)];
    return blocked_2;
}

__device__ Blocked_0 blocked_from_0(uint _S609, float3  _S610, bool _S611, bool _S612)
{
    FixedArray<float, 6>  terms_1;
    view_terms_0(_S610, &terms_1);
    uint _S613;
    if(_S612)
    {
        _S613 = 2U;
    }
    else
    {
        _S613 = 0U;
    }
    uint _S614;
    if(_S611)
    {
        _S614 = 0U;
    }
    else
    {
        _S614 = 1U;
    }
    uint _S615 = (_S613 + _S614) * 15U;
    FixedArray<float, 6>  _S616 = terms_1;
    Blocked_0 _S617 = blocked_of_terms_0(_S609, _S615, &_S616, 5U);
    return _S617;
}

__device__ float warp_seen_from_0(uint _S618, float3  _S619, bool _S620)
{
    FixedArray<float, 6>  terms_2;
    view_terms_0(_S619, &terms_2);
    uint term_1 = 0U;
    float share_7 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S621;
        if(_S620)
        {
            _S621 = 5U;
        }
        else
        {
            _S621 = 0U;
        }
        float _S622 = openness_number_0(_S618, 132U + _S621 + term_1);
        float share_8 = share_7 + _S622 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_7 = share_8;
    }
    return saturate_0(share_7);
}

__device__ Bounced_0 bounced_of_families_0(uint _S623, FamilyAlbedos_0 * _S624, float3  _S625, Interior_0 * _S626, Blocked_0 * _S627, Blocked_0 * _S628)
{
    Scattered_0 _S629 = scattered_by_0(_S623, &_S624->warp_3, 0U, _S625);
    Scattered_0 _S630 = _S629;
    Bounced_0 _S631 = bounced_by_0(_S627, &_S630, _S626);
    Scattered_0 _S632 = scattered_by_0(_S623, &_S624->weft_3, 1U, _S625);
    Scattered_0 _S633 = _S632;
    Bounced_0 _S634 = bounced_by_0(_S628, &_S633, _S626);
    Bounced_0 _S635 = _S631;
    Bounced_0 _S636 = _S634;
    Bounced_0 _S637 = sum_of_0(&_S635, &_S636);
    return _S637;
}

__device__ Bounced_0 bounced_far_0(uint _S638, FamilyAlbedos_0 * _S639, float3  _S640, Interior_0 * _S641, float3  _S642, bool _S643, float _S644, float _S645, float _S646)
{
    Blocked_0 _S647 = blocked_from_0(_S638, _S642, true, _S643);
    Blocked_0 _S648 = blocked_from_0(_S638, _S642, false, _S643);
    float _S649 = _S644 / (F32_max((1.0f - _S647.by_warp_0 - _S647.by_weft_0), (0.10000000149011612f)));
    float _S650 = _S645 / (F32_max((1.0f - _S648.by_warp_0 - _S648.by_weft_0), (0.10000000149011612f)));
    float _S651 = warp_seen_from_0(_S638, _S642, _S643);
    float _S652 = (0.0020000000949949f * _S651 + _S649) / (_S649 + _S650 + 0.0020000000949949f);
    float _S653 = 1.0f - _S646;
    float _S654 = _S652 * _S653;
    Blocked_0 _S655 = _S647;
    Blocked_0 _S656 = scaled_0(&_S655, _S654);
    float _S657 = (1.0f - _S652) * _S653;
    Blocked_0 _S658 = _S648;
    Blocked_0 _S659 = scaled_0(&_S658, _S657);
    Blocked_0 _S660 = _S656;
    Blocked_0 _S661 = _S659;
    Bounced_0 _S662 = bounced_of_families_0(_S638, _S639, _S640, _S641, &_S660, &_S661);
    return _S662;
}

__device__ ClusteredView_0 clustered_view_0(uint _S663, Footprint_0 * _S664, float3  _S665, float3  _S666, uint _S667, bool _S668)
{
    Fabric_0 * _S669 = (&(globalParams_0->fabrics_0)[_S663]);
    ClusteredView_0 seen_2;
    ViewedBase_0 _S670 = viewed_base_0(_S663, _S664, _S665, uniform_of_0(_S667, 0U), _S668);
    (&seen_2)->base_0 = _S670;
    (&seen_2)->view_10 = _S665;
    (&seen_2)->is_alone_0 = _S668;
    FamilyAlbedos_0 _S671 = albedos_over_0(_S663, _S664, (&(&seen_2)->base_0)->back_5);
    Albedos_0 _S672 = _S671.warp_3;
    Albedos_0 _S673 = tinted_0(&_S672, _S666);
    (&(&seen_2)->albedos_5)->warp_3 = _S673;
    Albedos_0 _S674 = _S671.weft_3;
    Albedos_0 _S675 = tinted_0(&_S674, _S666);
    (&(&seen_2)->albedos_5)->weft_3 = _S675;
    float3  _S676 = make_float3 (0.0f);
    (&(&seen_2)->bounced_2)->reflected_0 = _S676;
    (&(&seen_2)->bounced_2)->transmitted_0 = _S676;
    uint _S677 = __ldg(&_S669->openness_0);
    if(_S677 != 4294967295U)
    {
        Interior_0 _S678 = interior_of_0(_S663, _S666, (&(&seen_2)->base_0)->back_5);
        FamilyAlbedos_0 _S679 = _S671;
        Interior_0 _S680 = _S678;
        Bounced_0 _S681 = bounced_far_0(_S663, &_S679, _S666, &_S680, (&(&seen_2)->base_0)->view_3, (&(&seen_2)->base_0)->back_5, 0.0f, 0.0f, 0.0f);
        (&seen_2)->bounced_2 = _S681;
    }
    return seen_2;
}

__device__ float clustered_hole_0(uint _S682, ViewedBase_0 * _S683)
{
    Fabric_0 * _S684 = (&(globalParams_0->fabrics_0)[_S682]);
    uint cluster_0 = 0U;
    float covered_0 = 0.0f;
    for(;;)
    {
        Clustered_0 _S685 = slang_ldg_1(&_S684->clustered_0);
        if(cluster_0 < (_S685.clusters_0))
        {
        }
        else
        {
            break;
        }
        Clustered_0 _S686 = _S685;
        float _S687 = box_mean_0(&_S686, &_S683->box_2, _S683->face_2, cluster_0);
        float covered_1 = covered_0 + _S687;
        cluster_0 = cluster_0 + 1U;
        covered_0 = covered_1;
    }
    return clamp_1(1.0f - covered_0, 0.0f, 1.0f);
}

__device__ float cluster_density_0(uint _S688, ViewedBase_0 * _S689, BaseTaps_0 * _S690, uint _S691, uint _S692)
{
    Clustered_0 _S693 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S688])->clustered_0);
    float _S694 = BinTaps_read_0(&_S690->half_vector_0, _S693.basis_0, _S689->face_2 * 1024U, _S693.clusters_0 * (1U + _S693.rank_0), _S692 * _S693.clusters_0 + _S691);
    return _S694;
}

struct ClusterTerms_0
{
    float diffuse_0;
    float specular_0;
    float lit_1;
};

__device__ float cluster_attenuation_0(uint _S695, ViewedBase_0 * _S696, BaseTaps_0 * _S697, uint _S698)
{
    Fabric_0 * _S699 = (&(globalParams_0->fabrics_0)[_S695]);
    Clustered_0 _S700 = slang_ldg_1(&_S699->clustered_0);
    uint _S701 = _S700.moments_1 + (_S696->face_2 * _S700.clusters_0 + _S698) * 8U;
    float3  _S702 = make_float3 (table_number_0(_S701), table_number_0(_S701 + 1U), table_number_0(_S701 + 2U));
    float3  _S703 = make_float3 (table_number_0(_S701 + 3U), table_number_0(_S701 + 4U), table_number_0(_S701 + 5U));
    float _S704 = table_number_0(_S701 + 7U);
    float _S705 = __ldg(&_S699->optical_depth_0);
    float3  _S706 = _S697->facing_0;
    float _S707 = dot_0(_S697->facing_0, _S702);
    bool _S708 = _S697->transmits_1;
    float _S709;
    if(_S697->transmits_1)
    {
        _S709 = - _S707;
    }
    else
    {
        _S709 = _S707;
    }
    float _S710 = (F32_max((dot_0(_S696->view_3, _S702)), (0.10000000149011612f)));
    float _S711 = projected_area_1(_S706, _S703, _S704) / (F32_max((_S709), (0.10000000149011612f)));
    float _S712 = projected_area_1(_S696->view_3, _S703, _S704) / _S710;
    if(!_S708)
    {
        float _S713 = _S711 + _S712;
        return 0.25f * (1.0f - exponential_0(- _S705 * _S713)) / (_S713 * _S710);
    }
    float _S714 = (F32_max((_S705 * (F32_abs((_S711 - _S712)))), (0.00100000004749745f)));
    return 0.25f * _S705 * exponential_0(- _S705 * (F32_min((_S711), (_S712)))) * (1.0f - exponential_0(- _S714)) / (_S714 * _S710);
}

__device__ ClusterTerms_0 cluster_terms_0(uint _S715, ViewedBase_0 * _S716, BaseTaps_0 * _S717, uint _S718)
{
    Fabric_0 * _S719 = (&(globalParams_0->fabrics_0)[_S715]);
    Clustered_0 _S720 = slang_ldg_1(&_S719->clustered_0);
    uint _S721 = 2U * _S720.clusters_0;
    float _S722 = BinTaps_read_0(&_S717->around_0, _S720.light_0, _S717->first_4, _S721, _S718);
    float _S723 = BinTaps_read_0(&_S717->around_0, _S720.light_0, _S717->first_4, _S721, _S720.clusters_0 + _S718);
    float _S724 = BinTaps_read_0(&_S716->around_1, _S720.view_0, _S716->face_2 * 256U, _S720.clusters_0, _S718);
    float _S725 = __ldg(&_S719->diffuse_blend_0);
    ClusterTerms_0 terms_3;
    float _S726 = _S716->trust_1.x * _S724;
    (&terms_3)->diffuse_0 = _S726 * 0.31830987334251404f * ((1.0f - _S725) * (F32_abs((_S717->facing_0.z))) * _S722 + _S725 * _S723);
    float _S727 = _S716->trust_1.y * _S724 * _S722;
    float _S728 = cluster_attenuation_0(_S715, _S716, _S717, _S718);
    (&terms_3)->specular_0 = _S727 * _S728;
    (&terms_3)->lit_1 = _S726 * _S722;
    return terms_3;
}

__device__ Components_0 with_cluster_0(uint _S729, Components_0 * _S730, ClusterTerms_0 * _S731, uint _S732, float _S733, float _S734)
{
    Clustered_0 _S735 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S729])->clustered_0);
    bool _S736 = _S732 < (_S735.clusters_0 / 2U);
    Components_0 result_15 = *_S730;
    float _S737;
    if(_S736)
    {
        _S737 = _S733 * _S731->diffuse_0;
    }
    else
    {
        _S737 = 0.0f;
    }
    (&result_15)->diffuse_warp_0 = (&result_15)->diffuse_warp_0 + _S737;
    if(_S736)
    {
        _S737 = 0.0f;
    }
    else
    {
        _S737 = _S733 * _S731->diffuse_0;
    }
    (&result_15)->diffuse_weft_0 = (&result_15)->diffuse_weft_0 + _S737;
    if(_S736)
    {
        _S737 = _S731->specular_0 * _S734;
    }
    else
    {
        _S737 = 0.0f;
    }
    (&result_15)->specular_warp_0 = (&result_15)->specular_warp_0 + _S737;
    if(_S736)
    {
        _S737 = 0.0f;
    }
    else
    {
        _S737 = _S731->specular_0 * _S734;
    }
    (&result_15)->specular_weft_0 = (&result_15)->specular_weft_0 + _S737;
    (&result_15)->light_visibility_1 = (&result_15)->light_visibility_1 + _S733 * _S731->lit_1;
    return result_15;
}

__device__ Components_0 clustered_base_0(uint _S738, ViewedBase_0 * _S739, BaseTaps_0 * _S740)
{
    Clustered_0 _S741 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S738])->clustered_0);
    Components_0 base_1 = no_components_0();
    uint cluster_1 = 0U;
    for(;;)
    {
        if(cluster_1 < (_S741.clusters_0))
        {
        }
        else
        {
            break;
        }
        uint _S742 = _S739->face_2;
        Clustered_0 _S743 = _S741;
        float _S744 = box_mean_0(&_S743, &_S739->box_2, _S739->face_2, cluster_1);
        if(_S744 <= 0.0f)
        {
            cluster_1 = cluster_1 + 1U;
            continue;
        }
        float _S745 = cluster_density_0(_S738, _S739, _S740, cluster_1, 0U);
        float _S746 = _S744 * _S745;
        uint number_2 = 1U;
        float density_0 = _S746;
        for(;;)
        {
            if(number_2 <= (_S741.rank_0))
            {
            }
            else
            {
                break;
            }
            uint _S747 = number_2 * _S741.clusters_0 + cluster_1;
            Clustered_0 _S748 = _S741;
            float _S749 = box_mean_0(&_S748, &_S739->box_2, _S742, _S747);
            float _S750 = cluster_density_0(_S738, _S739, _S740, cluster_1, number_2);
            float density_1 = density_0 + _S749 * _S750;
            number_2 = number_2 + 1U;
            density_0 = density_1;
        }
        ClusterTerms_0 _S751 = cluster_terms_0(_S738, _S739, _S740, cluster_1);
        Components_0 _S752 = base_1;
        ClusterTerms_0 _S753 = _S751;
        Components_0 _S754 = with_cluster_0(_S738, &_S752, &_S753, cluster_1, _S744, density_0);
        base_1 = _S754;
        cluster_1 = cluster_1 + 1U;
    }
    return base_1;
}

__device__ float3  under_sheen_0(uint _S755, ClusteredView_0 * _S756, float3  _S757, float _S758, float3  _S759)
{
    Fabric_0 * _S760 = (&(globalParams_0->fabrics_0)[_S755]);
    float _S761 = __ldg(&_S760->sheen_strength_0);
    if(_S761 <= 0.0f)
    {
        return _S757;
    }
    float3  _S762 = to_face_frame_0(_S759, (&_S756->base_0)->back_5);
    float3  _S763 = (&_S756->base_0)->view_3;
    float _S764 = __ldg(&_S760->sheen_roughness_0);
    float2  _S765 = sheen_with_transmittance_0(_S762, _S763, _S761, _S764);
    return make_float3 (_S765.y) * _S757 + make_float3 (_S758 * _S765.x);
}

__device__ float3  clustered_base_value_0(uint _S766, ClusteredView_0 * _S767, float _S768, float3  _S769)
{
    BaseTaps_0 _S770 = base_taps_0(&_S767->base_0, _S769);
    BaseTaps_0 _S771 = _S770;
    Components_0 _S772 = clustered_base_0(_S766, &_S767->base_0, &_S771);
    Components_0 _S773 = _S772;
    float3  _S774 = shaded_0(&_S773, &_S767->albedos_5, _S770.transmits_1);
    float _S775 = 1.0f - _S768;
    float3  _S776 = bounced_value_0(&_S767->bounced_2, _S769, _S767->view_10);
    float3  _S777 = under_sheen_0(_S766, _S767, _S774 + make_float3 (_S775) * _S776, _S772.light_visibility_1 + _S768, _S769);
    return _S777;
}

struct YarnPoint_0
{
    bool back_8;
    bool hole_4;
    bool is_warp_2;
    float x_32;
    float y_17;
    float height_5;
    float3  normal_7;
    float3  tangent_8;
    float3  surface_normal_0;
    float diffuse_gain_1;
    float roughness_8;
    Albedos_0 albedos_7;
};

struct ResidualPoint_0
{
    YarnPoint_0 point_1;
    uint texel_0;
};

struct Hit_0
{
    float x_33;
    float y_18;
    bool hole_5;
    float height_6;
};

struct Sample_0
{
    Crossing_0 crossing_2;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_7;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

__device__ Crossing_0 crossing_at_0(uint _S778, float _S779, float _S780, bool _S781)
{
    Fabric_0 * _S782 = (&(globalParams_0->fabrics_0)[_S778]);
    Crossing_0 crossing_3;
    uint _S783 = __ldg(&_S782->warp_0);
    (&crossing_3)->warp_4 = locate_0(_S783, _S779);
    uint _S784 = __ldg(&_S782->weft_0);
    (&crossing_3)->weft_4 = locate_0(_S784, _S780);
    uint _S785 = __ldg(&_S782->run_words_0);
    uint _S786 = (&(&crossing_3)->weft_4)->thread_0;
    uint _S787 = __ldg(&_S782->ends_1);
    uint _S788 = _S785 + 2U * (_S786 * _S787 + (&(&crossing_3)->warp_4)->thread_0);
    uint _S789 = __ldg((&(globalParams_0->words_0)[_S788]));
    (&crossing_3)->warp_word_0 = _S789;
    uint _S790 = __ldg((&(globalParams_0->words_0)[_S788 + 1U]));
    (&crossing_3)->weft_word_0 = _S790;
    (&crossing_3)->warp_above_0 = ((_S789 & 1U) == 1U) != _S781;
    return crossing_3;
}

__device__ Sample_0 sample_at_0(uint _S791, float _S792, float _S793, bool _S794)
{
    Fabric_0 * _S795 = (&(globalParams_0->fabrics_0)[_S791]);
    Sample_0 sample_0;
    Crossing_0 _S796 = crossing_at_0(_S791, _S792, _S793, _S794);
    (&sample_0)->crossing_2 = _S796;
    Crossing_0 _S797 = _S796;
    Shown_0 _S798 = shown_at_0(&_S797, _S794);
    (&sample_0)->shown_3 = _S798;
    uint _S799;
    if(_S798.is_warp_0)
    {
        uint _S800 = __ldg(&_S795->warp_0);
        _S799 = _S800;
    }
    else
    {
        uint _S801 = __ldg(&_S795->weft_0);
        _S799 = _S801;
    }
    uint _S802;
    if(_S798.is_warp_0)
    {
        uint _S803 = __ldg(&_S795->weft_0);
        _S802 = _S803;
    }
    else
    {
        uint _S804 = __ldg(&_S795->warp_0);
        _S802 = _S804;
    }
    Cell_0 _S805 = (&(&sample_0)->crossing_2)->warp_4;
    Cell_0 _S806 = (&(&sample_0)->crossing_2)->weft_4;
    Cell_0 _S807 = select_cell_0(_S798.is_warp_0, &_S805, &_S806);
    Cell_0 _S808 = (&(&sample_0)->crossing_2)->weft_4;
    Cell_0 _S809 = (&(&sample_0)->crossing_2)->warp_4;
    Cell_0 _S810 = select_cell_0(_S798.is_warp_0, &_S808, &_S809);
    Cell_0 _S811 = _S810;
    Run_0 _S812 = unpack_0(_S799, _S802, _S807.thread_0, &_S811, _S798.word_0);
    Cell_0 _S813 = _S807;
    Section_0 _S814 = section_at_0(&_S813);
    bool _S815;
    if(_S798.on_top_0)
    {
        _S815 = (_S812.distance_0) < (_S814.drop_0 * _S812.bend_1.sine_0);
    }
    else
    {
        _S815 = false;
    }
    bool _S816;
    if(_S798.on_top_0)
    {
        _S816 = !_S815;
    }
    else
    {
        _S816 = false;
    }
    float _S817;
    if(_S816)
    {
        _S817 = 1.0f;
    }
    else
    {
        _S817 = -1.0f;
    }
    float _S818;
    if(_S815)
    {
        _S818 = _S812.other_reach_0;
    }
    else
    {
        _S818 = _S812.reach_0;
    }
    float _S819;
    if(_S815)
    {
        _S819 = _S818 + _S812.distance_0;
    }
    else
    {
        _S819 = (F32_max((_S818 - _S812.distance_0), (0.0f)));
    }
    float _S820 = _S818 / _S812.bend_1.sine_0 - _S817 * _S814.drop_0;
    float _S821 = _S819 * _S819;
    float _S822 = (F32_max((_S820 * _S820 - _S821), (9.99999968265522539e-21f)));
    float _S823 = (F32_rsqrt((_S822)));
    float _S824 = _S821 / (_S822 * _S823 + _S820);
    bool _S825 = _S819 > 0.0f;
    float _S826;
    if(_S798.on_top_0)
    {
        _S826 = 1.0f;
    }
    else
    {
        _S826 = -1.0f;
    }
    float _S827;
    if(_S812.near_start_0)
    {
        _S827 = 1.0f;
    }
    else
    {
        _S827 = -1.0f;
    }
    float _S828 = _S826 * _S827;
    if(_S825)
    {
        _S826 = _S820 * _S823;
    }
    else
    {
        _S826 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S814.slope_0 * _S826;
    if(_S825)
    {
        _S819 = _S828 * _S819 * _S823;
    }
    else
    {
        _S819 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S819;
    float _S829 = __ldg(&(&(globalParams_0->families_0)[_S799])->height_scale_0);
    Shown_0 _S830 = _S798;
    Run_0 _S831 = _S812;
    Cell_0 _S832 = _S810;
    float2  _S833 = dive_0(_S802, &_S830, &_S831, &_S832);
    if(_S812.straight_0)
    {
        _S817 = 0.0f;
    }
    else
    {
        _S817 = _S829 * _S817;
    }
    (&sample_0)->height_7 = _S817 * (_S818 * _S812.bend_1.half_tangent_0 - _S824) - _S829 * _S814.drop_0 - _S833.x;
    float _S834 = _S829 * (&sample_0)->slope_across_0;
    float _S835 = _S829 * (&sample_0)->slope_along_0 - _S833.y;
    if(_S798.is_warp_0)
    {
        _S817 = _S834;
    }
    else
    {
        _S817 = _S835;
    }
    (&sample_0)->slope_x_1 = _S817;
    if(_S798.is_warp_0)
    {
        _S817 = _S835;
    }
    else
    {
        _S817 = _S834;
    }
    (&sample_0)->slope_y_1 = _S817;
    (&sample_0)->run_3 = _S812;
    (&sample_0)->section_1 = _S814;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S836, SearchQuality_0 * _S837, float3  _S838)
{
    Fabric_0 * _S839 = (&(globalParams_0->fabrics_0)[_S836]);
    float _S840 = (F32_abs((_S838.x)));
    float _S841 = __ldg(&_S839->threads_per_x_0);
    float _S842 = _S840 * _S841;
    float _S843 = (F32_abs((_S838.y)));
    float _S844 = __ldg(&_S839->threads_per_y_0);
    float _S845 = (F32_max((_S842), (_S843 * _S844))) * _S837->steps_per_thread_0;
    float _S846 = (F32_abs((_S838.z)));
    float _S847 = __ldg(&_S839->per_relief_0);
    return (F32_max((_S845), (_S846 * _S847 * _S837->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S848, Crossing_0 * _S849)
{
    Fabric_0 * _S850 = (&(globalParams_0->fabrics_0)[_S848]);
    bool _S851 = _S849->warp_above_0;
    uint _S852;
    if(_S849->warp_above_0)
    {
        uint _S853 = __ldg(&_S850->warp_0);
        _S852 = _S853;
    }
    else
    {
        uint _S854 = __ldg(&_S850->weft_0);
        _S852 = _S854;
    }
    uint _S855;
    if(_S851)
    {
        _S855 = _S849->warp_word_0;
    }
    else
    {
        _S855 = _S849->weft_word_0;
    }
    float _S856 = float(_S855 >> int(28));
    float _S857 = __ldg(&(&(globalParams_0->families_0)[_S852])->height_scale_0);
    float _S858 = _S856 * _S857;
    float _S859 = __ldg(&(&(globalParams_0->families_0)[_S852])->level_0);
    return _S858 * _S859;
}

__device__ Probe_0 probe_0(uint _S860, float _S861, float _S862, bool _S863, bool _S864, bool _S865)
{
    Sample_0 _S866 = sample_at_0(_S860, _S861, _S862, _S863);
    Probe_0 probe_1;
    (&probe_1)->height_2 = _S866.height_7;
    (&probe_1)->hole_2 = _S866.shown_3.hole_1;
    (&probe_1)->slope_x_0 = _S866.slope_x_1;
    (&probe_1)->slope_y_0 = _S866.slope_y_1;
    uint _S867;
    if(_S866.shown_3.is_warp_0)
    {
        _S867 = _S866.crossing_2.warp_4.thread_0 * 2U + 1U;
    }
    else
    {
        _S867 = _S866.crossing_2.weft_4.thread_0 * 2U;
    }
    (&probe_1)->yarn_2 = _S867;
    Crossing_0 _S868 = _S866.crossing_2;
    float _S869 = cell_maximum_0(_S860, &_S868);
    (&probe_1)->cell_max_0 = _S869;
    float _S870;
    if(_S864)
    {
        _S870 = _S866.crossing_2.warp_4.above_0;
    }
    else
    {
        _S870 = _S866.crossing_2.warp_4.below_0;
    }
    (&probe_1)->side_x_0 = _S870;
    if(_S865)
    {
        _S870 = _S866.crossing_2.weft_4.above_0;
    }
    else
    {
        _S870 = _S866.crossing_2.weft_4.below_0;
    }
    (&probe_1)->side_y_0 = _S870;
    bool _S871 = !_S866.shown_3.is_warp_0;
    Cell_0 _S872 = _S866.crossing_2.warp_4;
    Shown_0 _S873 = _S866.shown_3;
    Run_0 _S874 = _S866.run_3;
    float _S875 = outline_distance_0(&_S872, &_S873, &_S874, _S871, _S864);
    (&probe_1)->edge_x_0 = _S875;
    Cell_0 _S876 = _S866.crossing_2.weft_4;
    Shown_0 _S877 = _S866.shown_3;
    Run_0 _S878 = _S866.run_3;
    float _S879 = outline_distance_0(&_S876, &_S877, &_S878, _S866.shown_3.is_warp_0, _S865);
    (&probe_1)->edge_y_0 = _S879;
    return probe_1;
}

__device__ bool is_free_0(uint _S880, SearchQuality_0 * _S881, float3  _S882, float3  _S883, bool _S884, float _S885)
{
    float _S886 = _S883.z;
    if(_S886 <= 0.0f)
    {
        return false;
    }
    float _S887 = _S881->shadow_share_0;
    float _S888 = steps_per_length_0(_S880, _S881, _S883);
    float _S889 = 1.0f / (F32_max((_S887 * _S888), (9.99999971718068537e-10f)));
    StepControl_0 _S890 = step_control_0(float2 {_S883.x, _S883.y}, _S889);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S891;
        if(count_3 < 1024U)
        {
            _S891 = (_S882.z + _S886 * distance_1) < _S885;
        }
        else
        {
            _S891 = false;
        }
        if(_S891)
        {
        }
        else
        {
            break;
        }
        float3  _S892 = _S882 + _S883 * make_float3 (distance_1);
        Probe_0 _S893 = probe_0(_S880, _S892.x, _S892.y, _S884, _S890.right_1, _S890.up_0);
        float _S894 = _S892.z;
        float _S895 = _S894 - _S893.height_2;
        float _S896 = _S886 - _S893.slope_x_0 * _S883.x - _S893.slope_y_0 * _S883.y;
        bool _S897;
        if(!_S893.hole_2)
        {
            _S897 = _S895 < 0.0f;
        }
        else
        {
            _S897 = false;
        }
        if(_S897)
        {
            return false;
        }
        PreviousSample_0 _S898 = previous_3;
        Probe_0 _S899 = _S893;
        float _S900 = way_back_to_dip_0(&_S898, _S895, _S896, last_step_0, &_S899);
        if(_S900 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S900;
            distance_1 = distance_1 - _S900;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S901 = _S894 > (_S893.cell_max_0);
        Probe_0 _S902 = _S893;
        PreviousSample_0 _S903 = after_sample_0(_S895, _S896, &_S902, _S901);
        float last_step_2;
        if(_S901)
        {
            StepControl_0 _S904 = _S890;
            float _S905 = StepControl_to_cell_exit_0(&_S904, _S893.side_x_0, _S893.side_y_0);
            last_step_2 = (F32_max((_S905), (_S889)));
        }
        else
        {
            StepControl_0 _S906 = _S890;
            Probe_0 _S907 = _S893;
            float _S908 = StepControl_to_next_sample_0(&_S906, &_S907, _S895, _S896);
            last_step_2 = _S908;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S903;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S909, SearchQuality_0 * _S910, float _S911, float _S912, float3  _S913, bool _S914)
{
    Fabric_0 * _S915 = (&(globalParams_0->fabrics_0)[_S909]);
    Sample_0 _S916 = sample_at_0(_S909, _S911, _S912, _S914);
    if(!_S916.shown_3.hole_1)
    {
        return false;
    }
    float3  _S917 = make_float3 (_S911, _S912, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S918;
        if(side_0 < 2U)
        {
            _S918 = passes_0;
        }
        else
        {
            _S918 = false;
        }
        if(_S918)
        {
        }
        else
        {
            break;
        }
        float3  _S919;
        if(side_0 == 0U)
        {
            _S919 = _S913;
        }
        else
        {
            _S919 = make_float3 (- _S913.x, - _S913.y, _S913.z);
        }
        bool _S920 = _S914 != (side_0 == 1U);
        float _S921 = __ldg(&_S915->height_high_0);
        bool _S922 = is_free_0(_S909, _S910, _S917, _S919, _S920, _S921);
        uint _S923 = side_0 + 1U;
        passes_0 = _S922;
        side_0 = _S923;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_8;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

__device__ float max_height_along_0(uint _S924, float _S925, float _S926, float _S927, float3  _S928, bool _S929)
{
    Fabric_0 * _S930 = (&(globalParams_0->fabrics_0)[_S924]);
    uint _S931 = __ldg(&_S930->warp_0);
    uint _S932 = locate_0(_S931, _S925).thread_0 / 2U;
    uint _S933 = __ldg(&_S930->weft_0);
    uint _S934 = locate_0(_S933, _S926).thread_0 / 2U;
    float _S935 = _S928.x;
    uint _S936;
    if(_S935 > 0.0f)
    {
        _S936 = 1U;
    }
    else
    {
        _S936 = 0U;
    }
    float _S937 = _S928.y;
    uint _S938;
    if(_S937 > 0.0f)
    {
        _S938 = 2U;
    }
    else
    {
        _S938 = 0U;
    }
    uint _S939 = _S936 + _S938;
    uint _S940 = __ldg(&_S930->max_heights_0);
    uint _S941 = __ldg(&_S930->max_height_columns_0);
    uint _S942 = __ldg((&(globalParams_0->words_0)[_S940 + 4U * (_S934 * _S941 + _S932) + _S939]));
    int number_3;
    if(_S929)
    {
        number_3 = int(4);
    }
    else
    {
        number_3 = int(0);
    }
    uint _S943 = _S942 >> number_3;
    float _S944 = (F32_abs((_S935)));
    float _S945 = __ldg(&_S930->threads_per_x_0);
    float _S946 = _S944 * _S945;
    float _S947 = (F32_abs((_S937)));
    float _S948 = __ldg(&_S930->threads_per_y_0);
    float _S949 = (F32_max((_S946), (_S947 * _S948))) / _S928.z;
    float _S950 = __ldg(&_S930->height_high_0);
    float max_height_0 = _S950;
    number_3 = int(3);
    for(;;)
    {
        if(number_3 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S927) * _S949) <= (PYRAMID_RADII_0[number_3]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S943 >> uint(int(8) * number_3)) & 15U) * 0.06666667014360428f * _S950)));
        }
        number_3 = number_3 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S951, float _S952, float _S953, bool _S954, bool _S955, bool _S956)
{
    Crossing_0 _S957 = crossing_at_0(_S951, _S952, _S953, _S954);
    Crossing_0 _S958 = _S957;
    float _S959 = cell_maximum_0(_S951, &_S958);
    float _S960;
    if(_S955)
    {
        _S960 = _S957.warp_4.above_0;
    }
    else
    {
        _S960 = _S957.warp_4.below_0;
    }
    float _S961;
    if(_S956)
    {
        _S961 = _S957.weft_4.above_0;
    }
    else
    {
        _S961 = _S957.weft_4.below_0;
    }
    return make_float3 (_S959, _S960, _S961);
}

__device__ float first_sample_height_0(uint _S962, ViewRay_0 * _S963, StepControl_0 * _S964, bool _S965)
{
    float _S966 = max_height_along_0(_S962, _S963->origin_0.x, _S963->origin_0.y, 0.0f, make_float3 (_S963->slope_1.x, _S963->slope_1.y, 1.0f), _S965);
    uint count_4 = 0U;
    float height_9 = _S966;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S967 = ViewRay_at_0(_S963, height_9);
        float3  _S968 = cell_bounds_0(_S962, _S967.x, _S967.y, _S965, _S964->right_1, _S964->up_0);
        float _S969 = height_9 - _S968.x;
        float _S970 = StepControl_to_cell_exit_0(_S964, _S968.y, _S968.z);
        float height_10 = height_9 - clamp_1(_S969, 0.0f, _S970);
        if(_S969 <= _S970)
        {
            height_9 = height_10;
            break;
        }
        count_4 = count_4 + 1U;
        height_9 = height_10;
    }
    return height_9;
}

__device__ ViewRayEnd_0 search_down_0(uint _S971, ViewRay_0 * _S972, StepControl_0 * _S973, bool _S974)
{
    Fabric_0 * _S975 = (&(globalParams_0->fabrics_0)[_S971]);
    float _S976 = __ldg(&_S975->height_low_0);
    float _S977 = __ldg(&_S975->height_high_0);
    float _S978 = _S976 - (_S977 - _S976);
    ViewRayEnd_0 end_1;
    float _S979 = first_sample_height_0(_S971, _S972, _S973, _S974);
    (&end_1)->height_8 = _S979;
    (&end_1)->last_step_3 = _S973->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
    uint count_5 = 0U;
    for(;;)
    {
        if(count_5 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S980 = ViewRay_at_0(_S972, (&end_1)->height_8);
        Probe_0 _S981 = probe_0(_S971, _S980.x, _S980.y, _S974, _S973->right_1, _S973->up_0);
        float _S982 = (&end_1)->height_8 - _S981.height_2;
        Probe_0 _S983 = _S981;
        float _S984 = ViewRay_rate_0(_S972, &_S983);
        (&end_1)->depth_1 = - _S982;
        (&end_1)->rate_4 = _S984;
        bool _S985;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S985 = !_S981.hole_2;
        }
        else
        {
            _S985 = false;
        }
        bool _S986;
        if(_S985)
        {
            _S986 = ((&(&end_1)->previous_4)->yarn_1) == (_S981.yarn_2);
        }
        else
        {
            _S986 = false;
        }
        (&end_1)->smooth_0 = _S986;
        bool _S987;
        if(!_S981.hole_2)
        {
            _S987 = _S982 <= 0.0f;
        }
        else
        {
            _S987 = false;
        }
        bool _S988;
        if(_S987)
        {
            _S988 = true;
        }
        else
        {
            _S988 = ((&end_1)->height_8) <= _S978;
        }
        if(_S988)
        {
            break;
        }
        PreviousSample_0 _S989 = (&end_1)->previous_4;
        Probe_0 _S990 = _S981;
        float _S991 = way_back_to_dip_0(&_S989, _S982, _S984, (&end_1)->last_step_3, &_S990);
        if(_S991 >= 0.0f)
        {
            (&end_1)->height_8 = (&end_1)->height_8 + _S991;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S991;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S992 = StepControl_to_cell_exit_0(_S973, _S981.side_x_0, _S981.side_y_0);
        float _S993 = (F32_min((_S992), ((&end_1)->height_8 - _S981.cell_max_0)));
        Probe_0 _S994 = _S981;
        float _S995 = StepControl_to_next_sample_0(_S973, &_S994, _S982, _S984);
        bool _S996 = _S993 > _S995;
        Probe_0 _S997 = _S981;
        PreviousSample_0 _S998 = after_sample_0(_S982, _S984, &_S997, _S996);
        (&end_1)->previous_4 = _S998;
        float _S999 = (F32_max((_S993), (_S995)));
        (&end_1)->last_step_3 = _S999;
        (&end_1)->height_8 = (&end_1)->height_8 - _S999;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S1000, ViewRay_0 * _S1001, StepControl_0 * _S1002, bool _S1003, ViewRayEnd_0 * _S1004, uint _S1005)
{
    Fabric_0 * _S1006 = (&(globalParams_0->fabrics_0)[_S1000]);
    float _S1007 = __ldg(&_S1006->height_high_0);
    float _S1008 = __ldg(&_S1006->height_low_0);
    float _S1009 = _S1007 - _S1008;
    float _S1010 = _S1004->height_8;
    float _S1011 = _S1004->last_step_3;
    float above_2 = _S1004->height_8 + _S1004->last_step_3;
    float above_gap_1 = clamp_1((&_S1004->previous_4)->clearance_0, 0.0f, _S1009);
    float under_gap_1 = clamp_1(_S1004->depth_1, 0.0f, _S1009);
    float _S1012 = cubic_root_0(above_gap_1, - under_gap_1, (&_S1004->previous_4)->rate_0 * _S1004->last_step_3, _S1004->rate_4 * _S1004->last_step_3);
    bool _S1013 = _S1004->smooth_0;
    float middle_0;
    if(_S1004->smooth_0)
    {
        middle_0 = above_2 - _S1012 * _S1011;
    }
    else
    {
        middle_0 = between_0(above_2, _S1010, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S1010;
    float above_3 = above_2;
    uint i_11 = 0U;
    for(;;)
    {
        if(i_11 < _S1005)
        {
        }
        else
        {
            break;
        }
        float2  _S1014 = ViewRay_at_0(_S1001, middle_0);
        Probe_0 _S1015 = probe_0(_S1000, _S1014.x, _S1014.y, _S1003, _S1002->right_1, _S1002->up_0);
        float _S1016;
        if(_S1015.hole_2)
        {
            _S1016 = -1.0e+09f;
        }
        else
        {
            _S1016 = _S1015.height_2;
        }
        float _S1017 = clamp_1(middle_0 - _S1016, - _S1009, _S1009);
        float _S1018;
        if(_S1017 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S1018 = 0.5f * above_gap_2;
            }
            else
            {
                _S1018 = above_gap_2;
            }
            float _S1019 = - _S1017;
            under_1 = middle_0;
            above_gap_2 = _S1018;
            under_gap_2 = _S1019;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S1018 = 0.5f * under_gap_2;
            }
            else
            {
                _S1018 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S1017;
            under_gap_2 = _S1018;
            side_1 = -1.0f;
        }
        if(_S1013)
        {
            Probe_0 _S1020 = _S1015;
            float _S1021 = ViewRay_rate_0(_S1001, &_S1020);
            middle_0 = clamp_1(middle_0 + _S1017 / (F32_min((_S1021), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_11 = i_11 + 1U;
    }
    if(_S1013)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S1022, SearchQuality_0 * _S1023, float _S1024, float _S1025, float3  _S1026, bool _S1027)
{
    float _S1028 = (F32_max((_S1026.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S1024, _S1025);
    float2  _S1029 = float2 {_S1026.x, _S1026.y} / make_float2 (_S1028);
    (&ray_0)->slope_1 = _S1029;
    float2  _S1030 = - _S1029;
    float _S1031 = steps_per_length_0(_S1022, _S1023, _S1026);
    StepControl_0 _S1032 = step_control_0(_S1030, 1.0f / (F32_max((_S1031 / _S1028), (9.99999971718068537e-10f))));
    ViewRay_0 _S1033 = ray_0;
    StepControl_0 _S1034 = _S1032;
    ViewRayEnd_0 _S1035 = search_down_0(_S1022, &_S1033, &_S1034, _S1027);
    Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    ViewRay_0 _S1036 = ray_0;
    StepControl_0 _S1037 = _S1032;
    ViewRayEnd_0 _S1038 = _S1035;
    float _S1039 = refined_height_0(_S1022, &_S1036, &_S1037, _S1027, &_S1038, _S1023->refinements_0);
    (&hit_0)->height_6 = _S1039;
    ViewRay_0 _S1040 = ray_0;
    float2  _S1041 = ViewRay_at_0(&_S1040, _S1039);
    (&hit_0)->x_33 = _S1041.x;
    (&hit_0)->y_18 = _S1041.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S1042, SearchQuality_0 * _S1043, float _S1044, float _S1045, float3  _S1046, bool _S1047)
{
    bool _S1048 = passes_through_0(_S1042, _S1043, _S1044, _S1045, _S1046, _S1047);
    if(!_S1048)
    {
        Hit_0 _S1049 = first_hit_of_yarn_0(_S1042, _S1043, _S1044, _S1045, _S1046, _S1047);
        return _S1049;
    }
    Hit_0 hit_1;
    (&hit_1)->x_33 = _S1044;
    (&hit_1)->y_18 = _S1045;
    (&hit_1)->height_6 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S1050, float _S1051, float _S1052, bool _S1053)
{
    Fabric_0 * _S1054 = (&(globalParams_0->fabrics_0)[_S1050]);
    Sample_0 _S1055 = sample_at_0(_S1050, _S1051, _S1052, _S1053);
    float _S1056;
    if(_S1055.shown_3.is_warp_0)
    {
        _S1056 = _S1055.crossing_2.warp_4.half_width_1;
    }
    else
    {
        _S1056 = _S1055.crossing_2.weft_4.half_width_1;
    }
    uint _S1057;
    if(_S1055.shown_3.is_warp_0)
    {
        uint _S1058 = __ldg(&_S1054->warp_0);
        _S1057 = _S1058;
    }
    else
    {
        uint _S1059 = __ldg(&_S1054->weft_0);
        _S1057 = _S1059;
    }
    float _S1060 = __ldg(&(&(globalParams_0->families_0)[_S1057])->twist_sine_0);
    float _S1061;
    if(_S1053)
    {
        _S1061 = -1.0f;
    }
    else
    {
        _S1061 = 1.0f;
    }
    float _S1062 = _S1060 * _S1061;
    float _S1063 = __ldg(&(&(globalParams_0->families_0)[_S1057])->twist_cosine_0);
    if(_S1055.shown_3.is_warp_0)
    {
        _S1061 = 1.0f;
    }
    else
    {
        _S1061 = -1.0f;
    }
    float2  _S1064 = fibre_direction_0(_S1055.slope_across_0, _S1061 * _S1055.slope_along_0, _S1062, _S1063);
    float _S1065;
    if(_S1055.shown_3.is_warp_0)
    {
        _S1065 = _S1055.slope_x_1;
    }
    else
    {
        _S1065 = _S1055.slope_y_1;
    }
    float _S1066;
    if(_S1055.shown_3.is_warp_0)
    {
        _S1066 = _S1055.slope_y_1;
    }
    else
    {
        _S1066 = _S1055.slope_x_1;
    }
    float _S1067 = _S1064.x;
    float _S1068 = _S1064.y;
    float _S1069 = _S1065 * _S1067 + _S1061 * _S1066 * _S1068;
    float _S1070 = _S1056 * 1.0154266357421875f;
    float _S1071 = _S1070 * arc_sine_0(clamp_1(_S1055.section_1.across_3 / _S1070, -1.0f, 1.0f));
    if(_S1055.shown_3.is_warp_0)
    {
        _S1056 = _S1052;
    }
    else
    {
        _S1056 = - _S1051;
    }
    SurfacePoint_0 point_2;
    (&point_2)->hole_3 = _S1055.shown_3.hole_1;
    (&point_2)->is_warp_1 = _S1055.shown_3.is_warp_0;
    (&point_2)->warp_thread_0 = _S1055.crossing_2.warp_4.thread_0;
    (&point_2)->weft_thread_0 = _S1055.crossing_2.weft_4.thread_0;
    (&point_2)->height_4 = _S1055.height_7;
    (&point_2)->normal_2 = normalize_0(make_float3 (- _S1055.slope_x_1, - _S1055.slope_y_1, 1.0f));
    float3  _S1072;
    if(_S1055.shown_3.is_warp_0)
    {
        _S1072 = make_float3 (_S1067, _S1068, _S1069);
    }
    else
    {
        _S1072 = make_float3 (- _S1068, _S1067, _S1069);
    }
    (&point_2)->tangent_3 = normalize_0(_S1072);
    (&point_2)->across_5 = _S1055.section_1.across_3;
    (&point_2)->fibre_across_0 = _S1071 * _S1063 + _S1056 * _S1062;
    (&point_2)->fibre_along_0 = _S1056 * _S1063 - _S1071 * _S1062;
    return point_2;
}

__device__ bool has_hairs_0(uint _S1073)
{
    Fabric_0 * _S1074 = (&(globalParams_0->fabrics_0)[_S1073]);
    uint _S1075 = __ldg(&_S1074->warp_0);
    float _S1076 = __ldg(&(&(globalParams_0->families_0)[_S1075])->hairiness_0);
    bool _S1077;
    if(_S1076 > 0.0f)
    {
        _S1077 = true;
    }
    else
    {
        uint _S1078 = __ldg(&_S1074->weft_0);
        float _S1079 = __ldg(&(&(globalParams_0->families_0)[_S1078])->hairiness_0);
        _S1077 = _S1079 > 0.0f;
    }
    return _S1077;
}

__device__ Hair_0 hair_at_0(uint _S1080, float2  _S1081, bool _S1082, float _S1083)
{
    Fabric_0 * _S1084 = (&(globalParams_0->fabrics_0)[_S1080]);
    float _S1085 = __ldg(&_S1084->fibre_size_0);
    float _S1086 = 17.0f * _S1085;
    float _S1087 = fade_0(_S1083, _S1086);
    float2  _S1088 = _S1081 / make_float2 (_S1086);
    uint number_4;
    if(_S1082)
    {
        number_4 = 1U;
    }
    else
    {
        number_4 = 0U;
    }
    uint _S1089 = __ldg(&_S1084->seed_0);
    uint _S1090 = hash_key_0(number_4, _S1089 ^ 1013904242U);
    float _S1091 = 1.0f / (F32_max((_S1083), (0.07999999821186066f * _S1085)));
    float _S1092 = (F32_min((0.63999998569488525f * _S1085 * _S1091), (1.0f)));
    float2  _S1093 = make_float2 (0.0f, 1.0f);
    float cover_2 = 0.0f;
    float hair_away_0 = 0.0f;
    float2  hair_across_0 = _S1093;
    number_4 = 0U;
    for(;;)
    {
        bool _S1094;
        if(_S1087 > 0.0f)
        {
            _S1094 = number_4 < 18U;
        }
        else
        {
            _S1094 = false;
        }
        if(_S1094)
        {
        }
        else
        {
            break;
        }
        uint _S1095 = number_4 / 9U;
        uint _S1096 = number_4 / 3U - 3U * _S1095;
        float2  _S1097 = floor_0(_S1088) + make_float2 (float(number_4 - 3U * _S1096 - 9U * _S1095), float(_S1096)) - make_float2 (1.0f);
        uint _S1098 = hash_bits_0(_S1090 + _S1095, uint(int(_S1097.x)) * 65536U + uint(int(_S1097.y)));
        uint _S1099 = hash_bits_0(_S1090, _S1098);
        float2  _S1100 = _S1088 - _S1097 - make_float2 (share_of_0(_S1098), share_of_0(_S1098 >> int(10)));
        float2  _S1101 = sine_cosine_0(3.14159274101257324f * share_of_0(_S1098 >> int(20)));
        float _S1102 = lerp_0(5.0f, 16.0f, share_of_0(_S1099 >> int(10))) / 17.0f;
        float _S1103 = _S1100.x;
        float _S1104 = _S1101.y;
        float _S1105 = _S1100.y;
        float _S1106 = _S1101.x;
        float _S1107 = (_S1103 * _S1104 + _S1105 * _S1106) / _S1102;
        float _S1108 = 0.69999998807907104f * (2.0f * share_of_0(_S1099 >> int(20)) - 1.0f);
        float _S1109 = 2.0f * _S1108 * _S1107;
        float _S1110 = (F32_rsqrt((_S1109 * _S1109 + 1.0f)));
        float _S1111 = (_S1105 * _S1104 - _S1103 * _S1106 - _S1108 * _S1102 * _S1107 * _S1107) * _S1110 * 17.0f;
        float _S1112 = clamp_1((0.31999999284744263f - (F32_abs((_S1111)))) * _S1085 * _S1091 + 0.5f, 0.0f, _S1092);
        uint _S1113;
        if(((_S1099 >> int(30)) & 1U) == 1U)
        {
            uint _S1114 = __ldg(&_S1084->warp_0);
            _S1113 = _S1114;
        }
        else
        {
            uint _S1115 = __ldg(&_S1084->weft_0);
            _S1113 = _S1115;
        }
        float _S1116 = share_of_0(_S1099);
        float _S1117 = __ldg(&(&(globalParams_0->families_0)[_S1113])->hairiness_0);
        bool _S1118;
        if(_S1116 < _S1117)
        {
            _S1118 = (F32_abs((_S1107))) < 1.0f;
        }
        else
        {
            _S1118 = false;
        }
        bool _S1119;
        if(_S1118)
        {
            _S1119 = _S1112 > cover_2;
        }
        else
        {
            _S1119 = false;
        }
        if(_S1119)
        {
            float2  _S1120 = make_float2 (- _S1106 - _S1109 * _S1104, _S1104 - _S1109 * _S1106) * make_float2 (_S1110);
            cover_2 = _S1112;
            hair_away_0 = _S1111;
            hair_across_0 = _S1120;
        }
        number_4 = number_4 + 1U;
    }
    float _S1121 = clamp_1(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    Hair_0 hair_1;
    (&hair_1)->cover_0 = _S1087 * cover_2;
    (&hair_1)->normal_0 = make_float3 ((make_float2 (_S1121) * hair_across_0).x, (make_float2 (_S1121) * hair_across_0).y, (F32_sqrt((1.0f - _S1121 * _S1121))));
    (&hair_1)->tangent_1 = make_float3 (hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

__device__ bool varies_at_0(uint _S1122, float _S1123)
{
    Fabric_0 * _S1124 = (&(globalParams_0->fabrics_0)[_S1122]);
    float _S1125 = __ldg(&_S1124->fibre_noise_0);
    bool _S1126;
    if(_S1125 > 0.0f)
    {
        _S1126 = true;
    }
    else
    {
        float _S1127 = __ldg(&_S1124->colour_noise_0);
        _S1126 = _S1127 > 0.0f;
    }
    if(_S1126)
    {
        _S1126 = true;
    }
    else
    {
        uint _S1128 = __ldg(&_S1124->has_detail_0);
        if(_S1128 != 0U)
        {
            _S1126 = _S1123 >= 0.0f;
        }
        else
        {
            _S1126 = false;
        }
    }
    return _S1126;
}

__device__ uint thread_number_0(uint _S1129, SurfacePoint_0 * _S1130, float _S1131, float _S1132)
{
    Fabric_0 * _S1133 = (&(globalParams_0->fabrics_0)[_S1129]);
    bool _S1134 = _S1130->is_warp_1;
    float _S1135;
    if(_S1130->is_warp_1)
    {
        _S1135 = _S1131;
    }
    else
    {
        _S1135 = _S1132;
    }
    float _S1136 = _S1135 - _S1130->across_5;
    uint _S1137;
    if(_S1134)
    {
        uint _S1138 = __ldg(&_S1133->warp_0);
        _S1137 = _S1138;
    }
    else
    {
        uint _S1139 = __ldg(&_S1133->weft_0);
        _S1137 = _S1139;
    }
    float _S1140 = __ldg(&(&(globalParams_0->families_0)[_S1137])->period_0);
    float _S1141 = __ldg(&(&(globalParams_0->families_0)[_S1137])->count_0);
    int _S1142 = int(_S1141);
    if(_S1134)
    {
        _S1137 = _S1130->warp_thread_0;
    }
    else
    {
        _S1137 = _S1130->weft_thread_0;
    }
    uint _S1143 = uint(int((F32_floor((_S1136 / _S1140)))) * _S1142 + int(_S1137)) * 2U;
    if(_S1134)
    {
        _S1137 = 1U;
    }
    else
    {
        _S1137 = 0U;
    }
    return _S1143 + _S1137;
}

struct FibreNoise_0
{
    float2  bundle_0;
    float bundle_weight_0;
    float2  fibre_0;
    float fibre_weight_0;
    float offset_4;
    float slope_2;
};

__device__ FibreNoise_0 fibre_noise_at_0(uint _S1144, uint _S1145, SurfacePoint_0 * _S1146, uint _S1147, float _S1148)
{
    Fabric_0 * _S1149 = (&(globalParams_0->fabrics_0)[_S1144]);
    float _S1150 = __ldg(&_S1149->fibre_size_0);
    float _S1151 = 5.0f * _S1150;
    uint _S1152 = __ldg(&_S1149->seed_0);
    float _S1153 = _S1146->fibre_along_0;
    float2  _S1154 = wave_noise_0(hash_key_0(_S1147, _S1152 ^ 458671337U), _S1146->fibre_along_0 / (25.0f * _S1150));
    float _S1155 = _S1146->fibre_across_0;
    float _S1156 = __ldg(&(&(globalParams_0->families_0)[_S1145])->fibre_tilt_0);
    float _S1157 = _S1155 + _S1156 * 0.5f * 25.0f * _S1150 * _S1154.x;
    float3  _S1158 = fibre_cell_0(_S1157, _S1153, _S1150);
    FibreNoise_0 noise_0;
    (&noise_0)->bundle_0 = cell_noise_0(hash_key_0(_S1147, _S1152 ^ 1757159915U), fibre_cell_0(_S1157, _S1153, _S1151));
    (&noise_0)->bundle_weight_0 = fade_0(_S1148, _S1151);
    (&noise_0)->fibre_0 = cell_noise_0(hash_key_0(_S1147, _S1152 ^ 48610963U), _S1158);
    (&noise_0)->fibre_weight_0 = fade_0(_S1148, _S1150);
    (&noise_0)->offset_4 = _S1158.z;
    (&noise_0)->slope_2 = 0.5f * _S1154.y;
    return noise_0;
}

__device__ float2  detail_gain_0(uint _S1159, uint _S1160, SurfacePoint_0 * _S1161, float2  _S1162, bool _S1163, uint _S1164, float _S1165)
{
    Fabric_0 * _S1166 = (&(globalParams_0->fabrics_0)[_S1159]);
    float2  _S1167 = make_float2 (0.0f);
    float _S1168 = __ldg(&(&(globalParams_0->families_0)[_S1160])->has_plies_0);
    float2  gain_2;
    if(_S1168 > 0.0f)
    {
        float _S1169 = __ldg(&(&(globalParams_0->families_0)[_S1160])->plies_per_mm_0);
        float _S1170 = 0.60000002384185791f * fade_0(_S1165, 1.0f / _S1169);
        float _S1171 = ply_offset_0(_S1160, _S1161, _S1163);
        gain_2 = make_float2 (_S1170) * make_float2 (0.20000000298023224f - square_1(square_1(_S1171)), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S1167;
    }
    float _S1172 = __ldg(&(&(globalParams_0->families_0)[_S1160])->fibre_tone_0);
    if(_S1172 > 0.0f)
    {
        FibreNoise_0 _S1173 = fibre_noise_at_0(_S1159, _S1160, _S1161, _S1164, _S1165);
        float _S1174 = __ldg(&(&(globalParams_0->families_0)[_S1160])->fibre_tone_0);
        gain_2 = gain_2 + make_float2 (_S1174) * make_float2 (_S1173.bundle_weight_0 * _S1173.bundle_0.y + _S1173.fibre_weight_0 * _S1173.fibre_0.y, _S1173.bundle_weight_0 + _S1173.fibre_weight_0);
    }
    float _S1175 = __ldg(&(&(globalParams_0->families_0)[_S1160])->slub_0);
    if(_S1175 > 0.0f)
    {
        float _S1176 = __ldg(&(&(globalParams_0->families_0)[_S1160])->slub_0);
        float _S1177 = 0.25f * _S1176;
        float _S1178 = __ldg(&(&(globalParams_0->families_0)[_S1160])->slubs_per_mm_0);
        float _S1179 = _S1177 * fade_0(_S1165, 1.0f / _S1178);
        float _S1180;
        if(_S1161->is_warp_1)
        {
            _S1180 = _S1162.y;
        }
        else
        {
            _S1180 = - _S1162.x;
        }
        uint _S1181 = __ldg(&_S1166->seed_0);
        uint _S1182 = hash_key_0(_S1164, _S1181 ^ 1373058189U);
        float _S1183 = __ldg(&(&(globalParams_0->families_0)[_S1160])->slubs_per_mm_0);
        float2  _S1184 = wave_noise_0(_S1182, _S1180 * _S1183);
        float _S1185 = _S1161->across_5;
        float _S1186 = __ldg(&(&(globalParams_0->families_0)[_S1160])->per_half_width_0);
        gain_2 = gain_2 + make_float2 (_S1179) * make_float2 (_S1184.x * lerp_0(0.40000000596046448f, 1.0f, (F32_min((square_1(_S1185 * _S1186)), (1.0f)))), 1.0f);
    }
    return gain_2;
}

__device__ Albedos_0 vary_albedos_0(uint _S1187, Albedos_0 * _S1188, uint _S1189, uint _S1190, float2  _S1191)
{
    Fabric_0 * _S1192 = (&(globalParams_0->fabrics_0)[_S1187]);
    float3  _S1193 = _S1188->specular_reflect_0;
    float3  _S1194 = _S1188->specular_transmit_0;
    float3  _S1195 = max_0(_S1188->specular_reflect_0, _S1188->specular_transmit_0);
    float3  _S1196 = _S1188->diffuse_reflect_0;
    float3  _S1197 = _S1188->diffuse_transmit_0;
    float3  _S1198 = _S1188->diffuse_reflect_0 + _S1188->diffuse_transmit_0;
    float _S1199 = __ldg(&_S1192->layer_bound_0);
    float3  _S1200 = make_float3 (1.0f) - make_float3 (_S1199) * _S1195;
    float _S1201 = __ldg(&_S1192->colour_noise_0);
    uint _S1202 = __ldg(&_S1192->seed_0);
    float colour_0 = bounded_gain_0(thread_gain_0(_S1189, _S1201, _S1202), _S1198, _S1200);
    float colour_1 = colour_0 * (1.0f + flattened_0(_S1191.y, make_float3 (colour_0) * _S1198, _S1200) * _S1191.x);
    float3  _S1203 = min_0((make_float3 (1.0f) - make_float3 (colour_1) * _S1198) / make_float3 (_S1199), make_float3 (1.0f));
    float _S1204 = __ldg(&_S1192->fibre_noise_0);
    float _S1205 = bounded_gain_0(fibre_gain_0(_S1189, _S1190, _S1204, _S1202), _S1195, _S1203);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (colour_1) * _S1196;
    (&varied_0)->diffuse_transmit_0 = make_float3 (colour_1) * _S1197;
    (&varied_0)->specular_reflect_0 = make_float3 (_S1205) * _S1193;
    (&varied_0)->specular_transmit_0 = make_float3 (_S1205) * _S1194;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S1206, SurfacePoint_0 * _S1207, Albedos_0 * _S1208, float _S1209, float _S1210, bool _S1211, float _S1212, float _S1213)
{
    Fabric_0 * _S1214 = (&(globalParams_0->fabrics_0)[_S1206]);
    uint _S1215 = thread_number_0(_S1206, _S1207, _S1209, _S1210);
    float _S1216 = _S1207->fibre_across_0;
    float _S1217 = _S1207->fibre_along_0;
    float _S1218 = __ldg(&_S1214->fibre_size_0);
    float3  _S1219 = fibre_cell_0(_S1216, _S1217, _S1218);
    float2  _S1220 = make_float2 (0.0f);
    uint _S1221 = __ldg(&_S1214->has_detail_0);
    bool _S1222;
    if(_S1221 != 0U)
    {
        _S1222 = _S1212 >= 0.0f;
    }
    else
    {
        _S1222 = false;
    }
    float2  gain_3;
    if(_S1222)
    {
        uint _S1223;
        if(_S1207->is_warp_1)
        {
            uint _S1224 = __ldg(&_S1214->warp_0);
            _S1223 = _S1224;
        }
        else
        {
            uint _S1225 = __ldg(&_S1214->weft_0);
            _S1223 = _S1225;
        }
        float2  _S1226 = detail_gain_0(_S1206, _S1223, _S1207, make_float2 (_S1209, _S1210), _S1211, _S1215, _S1212);
        gain_3 = _S1226 * make_float2 (1.0f - _S1213, 1.0f);
    }
    else
    {
        gain_3 = _S1220;
    }
    Albedos_0 _S1227 = vary_albedos_0(_S1206, _S1208, _S1215, uint(int(_S1219.x)) * 65536U + uint(int((F32_floor((_S1219.y))))), gain_3);
    return _S1227;
}

__device__ YarnFrame_0 turned_frame_0(uint _S1228, uint _S1229, SurfacePoint_0 * _S1230, bool _S1231, uint _S1232, float _S1233)
{
    YarnFrame_0 frame_2;
    (&frame_2)->normal_3 = _S1230->normal_2;
    (&frame_2)->tangent_4 = _S1230->tangent_3;
    (&frame_2)->loss_0 = 0.0f;
    float _S1234 = __ldg(&(&(globalParams_0->families_0)[_S1229])->has_plies_0);
    if(_S1234 > 0.0f)
    {
        float _S1235 = __ldg(&(&(globalParams_0->families_0)[_S1229])->plies_per_mm_0);
        float _S1236 = fade_0(_S1233, 1.0f / _S1235);
        float _S1237 = _S1236 * 0.41999998688697815f;
        float _S1238 = ply_offset_0(_S1229, _S1230, _S1231);
        float _S1239 = _S1237 * _S1238;
        float _S1240 = (F32_sqrt((1.0f - _S1239 * _S1239)));
        float _S1241;
        if(_S1231)
        {
            float _S1242 = __ldg(&(&(globalParams_0->families_0)[_S1229])->ply_sine_0);
            _S1241 = - _S1242;
        }
        else
        {
            float _S1243 = __ldg(&(&(globalParams_0->families_0)[_S1229])->ply_sine_0);
            _S1241 = _S1243;
        }
        float _S1244 = __ldg(&(&(globalParams_0->families_0)[_S1229])->ply_cosine_0);
        float3  _S1245 = cross_0((&frame_2)->tangent_4, (&frame_2)->normal_3);
        float3  _S1246 = make_float3 (_S1244) * _S1245 + make_float3 (_S1241) * (&frame_2)->tangent_4;
        (&frame_2)->tangent_4 = make_float3 (_S1244) * (make_float3 (_S1244) * (&frame_2)->tangent_4 - make_float3 (_S1241) * _S1245) + make_float3 (_S1241) * (make_float3 (_S1240) * _S1246 - make_float3 (_S1239) * (&frame_2)->normal_3);
        (&frame_2)->normal_3 = make_float3 (_S1240) * (&frame_2)->normal_3 + make_float3 (_S1239) * _S1246;
        (&frame_2)->loss_0 = _S1236 * _S1236 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    float _S1247 = __ldg(&(&(globalParams_0->families_0)[_S1229])->fibre_tilt_0);
    if(_S1247 > 0.0f)
    {
        FibreNoise_0 _S1248 = fibre_noise_at_0(_S1228, _S1229, _S1230, _S1232, _S1233);
        float _S1249 = 1.09858846664428711f * _S1247 * (_S1248.bundle_weight_0 * _S1248.bundle_0.x + _S1248.fibre_weight_0 * (_S1248.fibre_0.x + _S1248.offset_4));
        float _S1250 = _S1247 * (1.42099642753601074f * (_S1248.bundle_weight_0 * _S1248.bundle_0.y + _S1248.fibre_weight_0 * _S1248.fibre_0.y) - _S1248.bundle_weight_0 * _S1248.slope_2);
        float _S1251 = square_1(_S1248.fibre_weight_0);
        (&frame_2)->loss_0 = (&frame_2)->loss_0 + 0.5f * _S1247 * _S1247 * ((0.24761904776096344f * (square_1(_S1248.bundle_weight_0) + _S1251) + _S1251 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        float3  _S1252 = cross_0((&frame_2)->tangent_4, (&frame_2)->normal_3);
        float2  _S1253 = sine_cosine_0(_S1249);
        float2  _S1254 = sine_cosine_0(_S1250);
        float _S1255 = _S1253.y;
        float _S1256 = _S1253.x;
        float3  _S1257 = make_float3 (_S1255) * _S1252 - make_float3 (_S1256) * (&frame_2)->normal_3;
        (&frame_2)->normal_3 = make_float3 (_S1255) * (&frame_2)->normal_3 + make_float3 (_S1256) * _S1252;
        (&frame_2)->tangent_4 = make_float3 (_S1254.y) * (&frame_2)->tangent_4 + make_float3 (_S1254.x) * _S1257;
    }
    return frame_2;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S1258, SurfacePoint_0 * _S1259, float _S1260, float _S1261, bool _S1262, bool _S1263, float _S1264)
{
    Fabric_0 * _S1265 = (&(globalParams_0->fabrics_0)[_S1258]);
    bool _S1266 = _S1259->is_warp_1;
    uint _S1267;
    if(_S1259->is_warp_1)
    {
        uint _S1268 = __ldg(&_S1265->warp_0);
        _S1267 = _S1268;
    }
    else
    {
        uint _S1269 = __ldg(&_S1265->weft_0);
        _S1267 = _S1269;
    }
    uint _S1270 = __ldg(&_S1265->has_detail_0);
    bool _S1271;
    if(_S1270 != 0U)
    {
        _S1271 = _S1264 >= 0.0f;
    }
    else
    {
        _S1271 = false;
    }
    float3  _S1272 = make_float3 (0.0f);
    Hair_0 _S1273 = Hair_x24init_0(0.0f, _S1272, _S1272);
    bool _S1274;
    if(_S1271)
    {
        bool _S1275 = has_hairs_0(_S1258);
        _S1274 = _S1275;
    }
    else
    {
        _S1274 = false;
    }
    Hair_0 hair_2;
    if(_S1274)
    {
        Hair_0 _S1276 = hair_at_0(_S1258, make_float2 (_S1260, _S1261), _S1262, _S1264);
        hair_2 = _S1276;
    }
    else
    {
        hair_2 = _S1273;
    }
    uint _S1277;
    if(_S1266)
    {
        _S1277 = _S1259->warp_thread_0;
    }
    else
    {
        _S1277 = _S1259->weft_thread_0;
    }
    Albedos_0 albedos_8 = albedos_of_0(_S1267, _S1277);
    bool _S1278 = varies_at_0(_S1258, _S1264);
    Albedos_0 albedos_9;
    if(_S1278)
    {
        Albedos_0 _S1279 = albedos_8;
        Albedos_0 _S1280 = varied_at_0(_S1258, _S1259, &_S1279, _S1260, _S1261, _S1262, _S1264, hair_2.cover_0);
        albedos_9 = _S1280;
    }
    else
    {
        albedos_9 = albedos_8;
    }
    YarnPoint_0 point_3;
    (&point_3)->back_8 = _S1262;
    (&point_3)->hole_4 = _S1263;
    (&point_3)->is_warp_2 = _S1266;
    (&point_3)->x_32 = _S1260;
    (&point_3)->y_17 = _S1261;
    (&point_3)->height_5 = _S1259->height_4;
    (&point_3)->normal_7 = _S1259->normal_2;
    (&point_3)->tangent_8 = _S1259->tangent_3;
    (&point_3)->surface_normal_0 = _S1259->normal_2;
    (&point_3)->diffuse_gain_1 = 1.0f;
    if(_S1271)
    {
        uint _S1281 = thread_number_0(_S1258, _S1259, _S1260, _S1261);
        YarnFrame_0 _S1282 = turned_frame_0(_S1258, _S1267, _S1259, _S1262, _S1281, _S1264);
        bool _S1283 = has_hairs_0(_S1258);
        YarnFrame_0 frame_3;
        if(_S1283)
        {
            YarnFrame_0 _S1284 = _S1282;
            Hair_0 _S1285 = hair_2;
            YarnFrame_0 _S1286 = under_hair_0(&_S1284, &_S1285);
            frame_3 = _S1286;
        }
        else
        {
            frame_3 = _S1282;
        }
        (&point_3)->normal_7 = frame_3.normal_3;
        (&point_3)->tangent_8 = frame_3.tangent_4;
        float _S1287 = __ldg(&_S1265->diffuse_blend_0);
        YarnFrame_0 _S1288 = frame_3;
        float _S1289 = diffuse_gain_0(&_S1288, _S1287);
        (&point_3)->diffuse_gain_1 = _S1289;
    }
    float _S1290 = __ldg(&(&(globalParams_0->families_0)[_S1267])->roughness_0);
    (&point_3)->roughness_8 = _S1290;
    (&point_3)->albedos_7 = albedos_9;
    return point_3;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S1291, SearchQuality_0 * _S1292, float _S1293, float _S1294, float3  _S1295, float _S1296)
{
    bool _S1297 = (_S1295.z) < 0.0f;
    Hit_0 _S1298 = first_hit_0(_S1291, _S1292, _S1293, _S1294, to_face_frame_0(_S1295, _S1297), _S1297);
    SurfacePoint_0 _S1299 = surface_at_0(_S1291, _S1298.x_33, _S1298.y_18, _S1297);
    SurfacePoint_0 _S1300 = _S1299;
    YarnPoint_0 _S1301 = yarn_point_of_0(_S1291, &_S1300, _S1298.x_33, _S1298.y_18, _S1297, _S1298.hole_5, _S1296);
    return _S1301;
}

__device__ YarnPoint_0 locate_yarn_1(uint _S1302, SearchQuality_0 * _S1303, float _S1304, float _S1305, float3  _S1306)
{
    YarnPoint_0 _S1307 = locate_yarn_0(_S1302, _S1303, _S1304, _S1305, _S1306, -1.0f);
    return _S1307;
}

__device__ ResidualPoint_0 residual_point_0(uint _S1308, ViewedBase_0 * _S1309, float3  _S1310, uint _S1311, uint _S1312)
{
    Fabric_0 * _S1313 = (&(globalParams_0->fabrics_0)[_S1308]);
    uint _S1314 = _S1311 + _S1312 * 1663821227U;
    float2  _S1315 = make_float2 (uniform_of_0(_S1314, 1U), uniform_of_0(_S1314, 2U));
    float2  _S1316 = (&_S1309->box_2)->corner_1 + _S1315 * (&_S1309->box_2)->size_2;
    ResidualPoint_0 result_16;
    float _S1317 = _S1316.x;
    float _S1318 = _S1316.y;
    SearchQuality_0 _S1319 = default_quality_0();
    YarnPoint_0 _S1320 = locate_yarn_1(_S1308, &_S1319, _S1317, _S1318, _S1310);
    (&result_16)->point_1 = _S1320;
    Clustered_0 _S1321 = slang_ldg_1(&_S1313->clustered_0);
    Clustered_0 _S1322 = _S1321;
    uint _S1323 = texel_of_0(&_S1322, &_S1309->box_2, _S1315);
    (&result_16)->texel_0 = _S1323;
    return result_16;
}

__device__ Components_0 clustered_at_texel_0(uint _S1324, ViewedBase_0 * _S1325, uint _S1326, BaseTaps_0 * _S1327)
{
    uint _S1328 = _S1325->face_2;
    Clustered_0 _S1329 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S1324])->clustered_0);
    uint _S1330 = _S1328 * _S1329.columns_0 * _S1329.rows_0 + _S1326;
    uint _S1331 = table_byte_0(_S1329.labels_0, _S1330);
    Components_0 base_2 = no_components_0();
    if(_S1331 >= (_S1329.clusters_0))
    {
        return base_2;
    }
    float _S1332 = cluster_density_0(_S1324, _S1325, _S1327, _S1331, 0U);
    uint number_5 = 1U;
    float density_2 = _S1332;
    for(;;)
    {
        if(number_5 <= (_S1329.rank_0))
        {
        }
        else
        {
            break;
        }
        int _S1333 = int(table_byte_0(_S1329.coefficients_0, _S1330 * _S1329.rank_0 + number_5 - 1U));
        int _S1334;
        if(_S1333 > int(127))
        {
            _S1334 = _S1333 - int(256);
        }
        else
        {
            _S1334 = _S1333;
        }
        float _S1335 = float(_S1334);
        float _S1336 = cluster_density_0(_S1324, _S1325, _S1327, _S1331, number_5);
        float density_3 = density_2 + _S1335 * _S1336;
        number_5 = number_5 + 1U;
        density_2 = density_3;
    }
    ClusterTerms_0 _S1337 = cluster_terms_0(_S1324, _S1325, _S1327, _S1331);
    Components_0 _S1338 = base_2;
    ClusterTerms_0 _S1339 = _S1337;
    Components_0 _S1340 = with_cluster_0(_S1324, &_S1338, &_S1339, _S1331, 1.0f, density_2);
    return _S1340;
}

__device__ bool unoccluded_0(uint _S1341, SearchQuality_0 * _S1342, float _S1343, float _S1344, float _S1345, float3  _S1346, bool _S1347)
{
    Fabric_0 * _S1348 = (&(globalParams_0->fabrics_0)[_S1341]);
    if((_S1346.z) <= 0.0f)
    {
        return false;
    }
    float _S1349 = max_height_along_0(_S1341, _S1343, _S1344, _S1345, _S1346, _S1347);
    float _S1350 = __ldg(&_S1348->lift_0);
    bool _S1351 = is_free_0(_S1341, _S1342, make_float3 (_S1343, _S1344, _S1345 + _S1350), _S1346, _S1347, _S1349);
    return _S1351;
}

__device__ bool is_lit_0(uint _S1352, SearchQuality_0 * _S1353, YarnPoint_0 * _S1354, float3  _S1355)
{
    if(_S1354->hole_4)
    {
        return true;
    }
    bool _S1356 = _S1354->back_8;
    float3  _S1357 = to_face_frame_0(_S1355, _S1354->back_8);
    float _S1358 = _S1357.z;
    bool _S1359 = _S1358 < 0.0f;
    float3  _S1360 = _S1354->surface_normal_0;
    float _S1361 = _S1354->height_5;
    float3  normal_8;
    float height_11;
    if(_S1359)
    {
        SurfacePoint_0 _S1362 = surface_at_0(_S1352, _S1354->x_32, _S1354->y_17, !_S1356);
        normal_8 = _S1362.normal_2;
        height_11 = _S1362.height_4;
    }
    else
    {
        normal_8 = _S1360;
        height_11 = _S1361;
    }
    float3  _S1363 = make_float3 (float2 {_S1357.x, _S1357.y}.x, float2 {_S1357.x, _S1357.y}.y, (F32_abs((_S1358))));
    if((dot_0(normal_8, _S1363)) <= 0.0f)
    {
        return false;
    }
    bool _S1364 = unoccluded_0(_S1352, _S1353, _S1354->x_32, _S1354->y_17, height_11, _S1363, _S1356 != _S1359);
    return _S1364;
}

__device__ Components_0 components_of_point_0(uint _S1365, SearchQuality_0 * _S1366, YarnPoint_0 * _S1367, float3  _S1368, float3  _S1369)
{
    Fabric_0 * _S1370 = (&(globalParams_0->fabrics_0)[_S1365]);
    Components_0 result_17 = no_components_0();
    bool _S1371 = _S1367->hole_4;
    float _S1372;
    if(_S1367->hole_4)
    {
        _S1372 = 1.0f;
    }
    else
    {
        _S1372 = 0.0f;
    }
    (&result_17)->hole_0 = _S1372;
    bool _S1373;
    if(_S1371)
    {
        _S1373 = true;
    }
    else
    {
        bool _S1374 = is_lit_0(_S1365, _S1366, _S1367, _S1368);
        _S1373 = !_S1374;
    }
    if(_S1373)
    {
        return result_17;
    }
    float3  _S1375 = to_face_frame_0(_S1368, _S1367->back_8);
    float3  _S1376 = to_face_frame_0(_S1369, _S1367->back_8);
    float _S1377 = _S1367->diffuse_gain_1;
    bool _S1378 = (_S1375.z) < 0.0f;
    float3  _S1379;
    if(_S1378)
    {
        _S1379 = - _S1375;
    }
    else
    {
        _S1379 = _S1375;
    }
    float3  _S1380 = _S1367->normal_7;
    float _S1381 = __ldg(&_S1370->diffuse_blend_0);
    float _S1382 = _S1377 * diffuse_reflection_0(_S1379, _S1380, _S1381);
    if(_S1378)
    {
        float3  _S1383 = _S1367->tangent_8;
        float _S1384 = _S1367->roughness_8;
        float _S1385 = __ldg(&_S1370->optical_depth_0);
        _S1372 = transmission_1(_S1375, _S1376, _S1380, _S1383, _S1384, _S1385);
    }
    else
    {
        float3  _S1386 = _S1367->tangent_8;
        float _S1387 = _S1367->roughness_8;
        float _S1388 = __ldg(&_S1370->optical_depth_0);
        _S1372 = reflection_0(_S1375, _S1376, _S1380, _S1386, _S1387, _S1388);
    }
    bool _S1389 = _S1367->is_warp_2;
    float _S1390;
    if(_S1367->is_warp_2)
    {
        _S1390 = _S1382;
    }
    else
    {
        _S1390 = 0.0f;
    }
    (&result_17)->diffuse_warp_0 = _S1390;
    if(_S1389)
    {
        _S1390 = 0.0f;
    }
    else
    {
        _S1390 = _S1382;
    }
    (&result_17)->diffuse_weft_0 = _S1390;
    if(_S1389)
    {
        _S1390 = _S1372;
    }
    else
    {
        _S1390 = 0.0f;
    }
    (&result_17)->specular_warp_0 = _S1390;
    if(_S1389)
    {
        _S1372 = 0.0f;
    }
    (&result_17)->specular_weft_0 = _S1372;
    (&result_17)->light_visibility_1 = 1.0f;
    return result_17;
}

__device__ float3  clustered_residual_0(uint _S1391, ClusteredView_0 * _S1392, ResidualPoint_0 * _S1393, float3  _S1394, float3  _S1395)
{
    BaseTaps_0 _S1396 = base_taps_0(&_S1392->base_0, _S1395);
    BaseTaps_0 _S1397 = _S1396;
    Components_0 _S1398 = clustered_at_texel_0(_S1391, &_S1392->base_0, _S1393->texel_0, &_S1397);
    float3  _S1399 = _S1392->view_10;
    SearchQuality_0 _S1400 = default_quality_0();
    Components_0 _S1401 = components_of_point_0(_S1391, &_S1400, &_S1393->point_1, _S1395, _S1392->view_10);
    FamilyAlbedos_0 own_2;
    Albedos_0 _S1402 = tinted_0(&(&_S1393->point_1)->albedos_7, _S1394);
    (&own_2)->warp_3 = _S1402;
    (&own_2)->weft_3 = _S1402;
    Components_0 _S1403 = _S1401;
    FamilyAlbedos_0 _S1404 = own_2;
    float3  _S1405 = shaded_0(&_S1403, &_S1404, _S1396.transmits_1);
    Components_0 _S1406 = _S1398;
    float3  _S1407 = shaded_0(&_S1406, &_S1392->albedos_5, _S1396.transmits_1);
    float3  _S1408 = _S1405 - _S1407;
    float3  _S1409 = bounced_value_0(&_S1392->bounced_2, _S1395, _S1399);
    float3  _S1410 = under_sheen_0(_S1391, _S1392, _S1408 - make_float3 (_S1401.hole_0) * _S1409, _S1401.light_visibility_1 + _S1401.hole_0 - _S1398.light_visibility_1, _S1395);
    return _S1410;
}

__device__ float passed_by_sheen_0(uint _S1411, float _S1412, float3  _S1413)
{
    Fabric_0 * _S1414 = (&(globalParams_0->fabrics_0)[_S1411]);
    float _S1415 = __ldg(&_S1414->sheen_strength_0);
    if(_S1415 <= 0.0f)
    {
        return _S1412;
    }
    float _S1416 = (F32_abs((_S1413.z)));
    float _S1417 = __ldg(&_S1414->sheen_roughness_0);
    return _S1412 * (1.0f - _S1415 * sheen_lobe_0(_S1416, _S1417).z);
}

__device__ float4  clustered_value_0(uint _S1418, Footprint_0 * _S1419, float3  _S1420, float3  _S1421, uint _S1422, uint _S1423)
{
    float3  _S1424 = make_float3 (1.0f);
    bool _S1425 = _S1423 == 0U;
    ClusteredView_0 _S1426 = clustered_view_0(_S1418, _S1419, _S1421, _S1424, _S1422, _S1425);
    float hole_6;
    if(_S1425)
    {
        ViewedBase_0 _S1427 = _S1426.base_0;
        float _S1428 = clustered_hole_0(_S1418, &_S1427);
        hole_6 = _S1428;
    }
    else
    {
        hole_6 = 0.0f;
    }
    ClusteredView_0 _S1429 = _S1426;
    float3  _S1430 = clustered_base_value_0(_S1418, &_S1429, hole_6, _S1420);
    uint number_6 = 0U;
    float3  value_1 = _S1430;
    for(;;)
    {
        if(number_6 < _S1423)
        {
        }
        else
        {
            break;
        }
        ViewedBase_0 _S1431 = _S1426.base_0;
        ResidualPoint_0 _S1432 = residual_point_0(_S1418, &_S1431, _S1421, _S1422, number_6);
        ClusteredView_0 _S1433 = _S1426;
        ResidualPoint_0 _S1434 = _S1432;
        float3  _S1435 = clustered_residual_0(_S1418, &_S1433, &_S1434, _S1424, _S1420);
        float _S1436 = float(_S1423);
        float3  value_2 = value_1 + _S1435 / make_float3 (_S1436);
        float _S1437;
        if(_S1432.point_1.hole_4)
        {
            _S1437 = 1.0f;
        }
        else
        {
            _S1437 = 0.0f;
        }
        float hole_7 = hole_6 + _S1437 / _S1436;
        number_6 = number_6 + 1U;
        value_1 = value_2;
        hole_6 = hole_7;
    }
    float _S1438 = passed_by_sheen_0(_S1418, hole_6, _S1421);
    return make_float4 (value_1.x, value_1.y, value_1.z, _S1438);
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_3, float2  dx_2, float2  dy_2, float3  light_9, float3  view_11)
{
    Footprint_0 _S1439 = footprint_of_0(centre_3, dx_2, dy_2);
    Clustered_0 _S1440 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[fabric_2])->clustered_0);
    Clustered_0 _S1441 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[fabric_2])->clustered_0);
    float _S1442 = _S1440.texel_width_0 * float(_S1441.columns_0);
    Clustered_0 _S1443 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[fabric_2])->clustered_0);
    Clustered_0 _S1444 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[fabric_2])->clustered_0);
    float2  _S1445 = make_float2 (_S1442, _S1443.texel_height_0 * float(_S1444.rows_0));
    Footprint_0 _S1446 = _S1439;
    uint _S1447 = hashed_0(&_S1446, view_11, _S1445);
    Footprint_0 _S1448 = _S1439;
    float4  _S1449 = clustered_value_0(fabric_2, &_S1448, light_9, view_11, _S1447, 0U);
    return _S1449;
}

__device__ float4  cloth_estimate_0(uint fabric_3, float2  centre_4, float2  dx_3, float2  dy_3, float3  light_10, float3  view_12, uint seed_5)
{
    Clustered_0 _S1450 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[fabric_3])->clustered_0);
    uint _S1451 = (U32_max((_S1450.samples_0), (1U)));
    uint _S1452 = mixed_0(seed_5);
    Footprint_0 _S1453 = footprint_of_0(centre_4, dx_3, dy_3);
    float4  _S1454 = clustered_value_0(fabric_3, &_S1453, light_10, view_12, _S1452, _S1451);
    return _S1454;
}

extern "C" __global__ void clustered_queries()
{
    uint _S1455 = (blockIdx * blockDim + threadIdx).x;
    uint _S1456 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S1455 >= _S1456)
    {
        return;
    }
    Query_0 _S1457 = slang_ldg_0((&(globalParams_0->queries_0)[_S1455]));
    float2  _S1458 = make_float2 (_S1457.centre_x_0, _S1457.centre_y_0);
    float2  _S1459 = make_float2 (_S1457.dx_x_0, _S1457.dx_y_0);
    float2  _S1460 = make_float2 (_S1457.dy_x_0, _S1457.dy_y_0);
    float3  _S1461 = make_float3 (_S1457.light_x_0, _S1457.light_y_0, _S1457.light_z_0);
    float3  _S1462 = make_float3 (_S1457.view_x_0, _S1457.view_y_0, _S1457.view_z_0);
    if((_S1457.seed_1) == 0U)
    {
        *(&(globalParams_0->answers_0)[_S1455]) = cloth_value_0(_S1457.fabric_1, _S1458, _S1459, _S1460, _S1461, _S1462);
    }
    else
    {
        *(&(globalParams_0->answers_0)[_S1455]) = cloth_estimate_0(_S1457.fabric_1, _S1458, _S1459, _S1460, _S1461, _S1462, _S1457.seed_1);
    }
    return;
}

