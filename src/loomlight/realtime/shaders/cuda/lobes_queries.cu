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
__device__ float3  max_0(float3  x_3, float3  y_3)
{
    float3  result_0;
    int i_0 = int(0);
    for(;;)
    {
        if(i_0 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_0, i_0) = (F32_max((_slang_vector_get_element(x_3, i_0)), (_slang_vector_get_element(y_3, i_0))));
        i_0 = i_0 + int(1);
    }
    return result_0;
}

__device__ float3  min_0(float3  x_4, float3  y_4)
{
    float3  result_1;
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
        *_slang_vector_get_element_ptr(&result_1, i_1) = (F32_min((_slang_vector_get_element(x_4, i_1)), (_slang_vector_get_element(y_4, i_1))));
        i_1 = i_1 + int(1);
    }
    return result_1;
}

__device__ float3  clamp_0(float3  x_5, float3  minBound_0, float3  maxBound_0)
{
    return min_0(max_0(x_5, minBound_0), maxBound_0);
}

__device__ float dot_0(float3  x_6, float3  y_5)
{
    int i_2 = int(0);
    float result_2 = 0.0f;
    for(;;)
    {
        if(i_2 < int(3))
        {
        }
        else
        {
            break;
        }
        float result_3 = result_2 + _slang_vector_get_element(x_6, i_2) * _slang_vector_get_element(y_5, i_2);
        i_2 = i_2 + int(1);
        result_2 = result_3;
    }
    return result_2;
}

__device__ float length_0(float3  x_7)
{
    return (F32_sqrt((dot_0(x_7, x_7))));
}

__device__ float dot_1(float2  x_8, float2  y_6)
{
    int i_3 = int(0);
    float result_4 = 0.0f;
    for(;;)
    {
        if(i_3 < int(2))
        {
        }
        else
        {
            break;
        }
        float result_5 = result_4 + _slang_vector_get_element(x_8, i_3) * _slang_vector_get_element(y_6, i_3);
        i_3 = i_3 + int(1);
        result_4 = result_5;
    }
    return result_4;
}

__device__ float clamp_1(float x_9, float minBound_1, float maxBound_1)
{
    return (F32_min(((F32_max((x_9), (minBound_1)))), (maxBound_1)));
}

__device__ float3  lerp_0(float3  x_10, float3  y_7, float3  s_0)
{
    return x_10 + (y_7 - x_10) * s_0;
}

__device__ float3  saturate_0(float3  x_11)
{
    return clamp_0(x_11, make_float3 (0.0f), make_float3 (1.0f));
}

__device__ float dot_2(float4  x_12, float4  y_8)
{
    int i_4 = int(0);
    float result_6 = 0.0f;
    for(;;)
    {
        if(i_4 < int(4))
        {
        }
        else
        {
            break;
        }
        float result_7 = result_6 + _slang_vector_get_element(x_12, i_4) * _slang_vector_get_element(y_8, i_4);
        i_4 = i_4 + int(1);
        result_6 = result_7;
    }
    return result_6;
}

__device__ float2  sqrt_0(float2  x_13)
{
    float2  result_8;
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
        *_slang_vector_get_element_ptr(&result_8, i_5) = (F32_sqrt((_slang_vector_get_element(x_13, i_5))));
        i_5 = i_5 + int(1);
    }
    return result_8;
}

__device__ float2  max_1(float2  x_14, float2  y_9)
{
    float2  result_9;
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
        *_slang_vector_get_element_ptr(&result_9, i_6) = (F32_max((_slang_vector_get_element(x_14, i_6)), (_slang_vector_get_element(y_9, i_6))));
        i_6 = i_6 + int(1);
    }
    return result_9;
}

__device__ static const FixedArray<float2 , 9>  TAP_OFFSETS_0 = {
    float2 {
        -0.3333333432674408f, -0.3333333432674408f
    }, float2 {
        -0.3333333432674408f, 0.0f
    }, float2 {
        -0.3333333432674408f, 0.3333333432674408f
    }, float2 {
        0.0f, -0.3333333432674408f
    }, float2 {
        0.0f, 0.0f
    }, float2 {
        0.0f, 0.3333333432674408f
    }, float2 {
        0.3333333432674408f, -0.3333333432674408f
    }, float2 {
        0.3333333432674408f, 0.0f
    }, float2 {
        0.3333333432674408f, 0.3333333432674408f
    }
};
__device__ float saturate_1(float x_15)
{
    return clamp_1(x_15, 0.0f, 1.0f);
}

__device__ float lerp_1(float x_16, float y_10, float s_1)
{
    return x_16 + (y_10 - x_16) * s_1;
}

__device__ float3  normalize_0(float3  x_17)
{
    return x_17 / make_float3 (length_0(x_17));
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

__device__ float2  lerp_2(float2  x_18, float2  y_11, float2  s_2)
{
    return x_18 + (y_11 - x_18) * s_2;
}

__device__ float2  floor_0(float2  x_19)
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
        *_slang_vector_get_element_ptr(&result_10, i_7) = (F32_floor((_slang_vector_get_element(x_19, i_7))));
        i_7 = i_7 + int(1);
    }
    return result_10;
}

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ float2  round_0(float2  x_20)
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
        *_slang_vector_get_element_ptr(&result_11, i_8) = (F32_round((_slang_vector_get_element(x_20, i_8))));
        i_8 = i_8 + int(1);
    }
    return result_11;
}

__device__ static const FixedArray<float2 , 8>  POINT_OFFSETS_0 = {
    float2 {
        0.0f, 0.0f
    }, float2 {
        -0.23010000586509705f, 0.35670000314712524f
    }, float2 {
        0.36809998750686646f, -0.22939999401569366f
    }, float2 {
        -0.28040000796318054f, -0.34400001168251038f
    }, float2 {
        0.3465999960899353f, 0.28859999775886536f
    }, float2 {
        -0.36349999904632568f, 0.0511000007390976f
    }, float2 {
        0.09929999709129333f, -0.35699999332427979f
    }, float2 {
        0.10710000246763229f, 0.32879999279975891f
    }
};
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

__device__ Lobes_0 slang_ldg_1(Lobes_0 * ptr_1)
{
    uint _S22 = __ldg(&ptr_1->is_baked_0);
    float _S23 = __ldg(&ptr_1->inverse_base_size_0);
    float _S24 = __ldg(&ptr_1->last_level_0);
    uint _S25 = __ldg(&ptr_1->levels_0);
    uint _S26 = __ldg(&ptr_1->face_nodes_0);
    uint _S27 = __ldg(&ptr_1->packs_0);
    uint _S28 = __ldg(&ptr_1->front_warp_packs_0);
    uint _S29 = __ldg(&ptr_1->back_warp_packs_0);
    uint _S30 = __ldg(&ptr_1->coverage_0);
    uint _S31 = __ldg(&ptr_1->coverage_holes_0);
    uint _S32 = __ldg(&ptr_1->projected_area_0);
    uint _S33 = __ldg(&ptr_1->light_visibility_0);
    uint _S34 = __ldg(&ptr_1->irradiance_0);
    uint _S35 = __ldg(&ptr_1->moments_0);
    float _S36 = __ldg(&ptr_1->front_hole_weight_0);
    float _S37 = __ldg(&ptr_1->back_hole_weight_0);
    float _S38 = __ldg(&ptr_1->threads_per_mm_0);
    float _S39 = __ldg(&ptr_1->unit_level_0);
    Lobes_0 _S40 = { _S22, _S23, _S24, _S25, _S26, _S27, _S28, _S29, _S30, _S31, _S32, _S33, _S34, _S35, _S36, _S37, _S38, _S39 };
    return _S40;
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

__device__ float Footprint_spread_side_0(Footprint_0 * this_0)
{
    return (F32_sqrt((0.5f * (dot_1(this_0->dx_0, this_0->dx_0) + dot_1(this_0->dy_0, this_0->dy_0)))));
}

__device__ float natural_logarithm_0(float x_21)
{
    uint _S41 = (F32_asuint((x_21)));
    float exponent_0 = float(int(_S41 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S41 & 8388607U) | 1056964608U)));
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
    float _S42 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S42 - exponent_1 * 0.00021219444170129f - 0.5f * _S42) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_22)
{
    return natural_logarithm_0(x_22) * 1.4426950216293335f;
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S43 = float2 {direction_0.x, direction_0.y};
    float _S44;
    if(back_2)
    {
        _S44 = - direction_0.z;
    }
    else
    {
        _S44 = direction_0.z;
    }
    return make_float3 (_S43.x, _S43.y, _S44);
}

struct SurfacePoint_0
{
    bool hole_0;
    bool is_warp_0;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_2;
    float3  normal_0;
    float3  tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_3, float3  normal_1, float3  tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    SurfacePoint_0 _S45;
    (&_S45)->hole_0 = hole_1;
    (&_S45)->is_warp_0 = is_warp_1;
    (&_S45)->warp_thread_0 = warp_thread_1;
    (&_S45)->weft_thread_0 = weft_thread_1;
    (&_S45)->height_2 = height_3;
    (&_S45)->normal_0 = normal_1;
    (&_S45)->tangent_0 = tangent_1;
    (&_S45)->across_0 = across_1;
    (&_S45)->fibre_across_0 = fibre_across_1;
    (&_S45)->fibre_along_0 = fibre_along_1;
    return _S45;
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

__device__ Components_0 no_components_0()
{
    Components_0 nothing_0;
    (&nothing_0)->diffuse_warp_0 = 0.0f;
    (&nothing_0)->diffuse_weft_0 = 0.0f;
    (&nothing_0)->specular_warp_0 = 0.0f;
    (&nothing_0)->specular_weft_0 = 0.0f;
    (&nothing_0)->light_visibility_1 = 0.0f;
    (&nothing_0)->hole_2 = 0.0f;
    return nothing_0;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

__device__ Blocked_0 no_blocked_0()
{
    Blocked_0 nothing_1;
    (&nothing_1)->by_warp_0 = 0.0f;
    (&nothing_1)->by_weft_0 = 0.0f;
    (&nothing_1)->far_0 = 0.0f;
    return nothing_1;
}

struct CloseUp_0
{
    float weight_0;
    Blocked_0 warp_1;
    Blocked_0 weft_1;
};

__device__ CloseUp_0 no_close_up_0()
{
    CloseUp_0 nothing_2;
    (&nothing_2)->weight_0 = 0.0f;
    Blocked_0 _S46 = no_blocked_0();
    (&nothing_2)->warp_1 = _S46;
    (&nothing_2)->weft_1 = _S46;
    return nothing_2;
}

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

__device__ SearchQuality_0 quality_of_0(float threads_0)
{
    float _S47 = clamp_1((-3.0f - binary_logarithm_0((F32_max((threads_0), (9.99999971718068537e-10f))))) / 2.0f, 0.0f, 1.0f);
    SearchQuality_0 quality_0;
    float _S48 = lerp_1(2.5f, 5.0f, _S47);
    (&quality_0)->steps_per_thread_0 = _S48;
    (&quality_0)->steps_per_relief_0 = _S48;
    (&quality_0)->shadow_share_0 = lerp_1(1.60000002384185791f, 1.0f, _S47);
    (&quality_0)->refinements_0 = uint(lerp_1(1.0f, 2.0f, _S47) + 0.5f);
    return quality_0;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_0)
{
    float _S49 = __ldg(&(&(globalParams_0->families_0)[family_0])->inverse_count_0);
    float _S50 = __ldg(&(&(globalParams_0->families_0)[family_0])->half_inverse_count_0);
    float _S51 = (F32_floor(((F32_fma((index_0), (_S49), (_S50))))));
    float _S52 = - _S51;
    float _S53 = __ldg(&(&(globalParams_0->families_0)[family_0])->count_0);
    return make_float2 (_S51, (F32_fma((_S52), (_S53), (index_0))));
}

struct Cell_0
{
    uint thread_0;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_0)
{
    float _S54 = __ldg(&(&(globalParams_0->families_0)[family_1])->inverse_size_0);
    float _S55 = (F32_floor((position_0 * _S54)));
    Cell_0 cell_0;
    float _S56 = - _S55;
    float _S57 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    float _S58 = (F32_fma((_S56), (_S57), (position_0)));
    (&cell_0)->below_0 = _S58;
    float _S59 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->above_0 = _S59 - _S58;
    float _S60 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->across_2 = _S58 - 0.5f * _S60;
    float _S61 = __ldg(&(&(globalParams_0->families_0)[family_1])->half_width_0);
    (&cell_0)->half_width_1 = _S61;
    float _S62 = turns_and_remainder_0(family_1, _S55).y;
    float _S63 = __ldg(&(&(globalParams_0->families_0)[family_1])->count_0);
    (&cell_0)->thread_0 = uint(clamp_1(_S62, 0.0f, _S63 - 1.0f));
    return cell_0;
}

__device__ float table_number_0(uint index_1)
{
    uint _S64 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S64)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float _S65 = __ldg(&(&(globalParams_0->families_0)[family_2])->start_0);
    float _S66 = position_1 - _S65;
    float _S67 = __ldg(&(&(globalParams_0->families_0)[family_2])->inverse_period_0);
    float turns_0 = _S66 * _S67;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    float _S68 = __ldg(&(&(globalParams_0->families_0)[family_2])->period_0);
    float _S69 = turns_1 * _S68;
    float _S70 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    float _S71 = turns_1 * _S70;
    float _S72 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    uint _S73 = uint(clamp_1(_S71, 0.0f, _S72 - 1.0f));
    uint _S74 = __ldg(&(&(globalParams_0->families_0)[family_2])->first_thread_table_0);
    uint _S75 = __ldg((&(globalParams_0->words_0)[_S74 + _S73]));
    uint _S76 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S77;
    if(_S69 >= (table_number_0(_S76 + _S75 * 4U + 1U)))
    {
        _S77 = 1U;
    }
    else
    {
        _S77 = 0U;
    }
    uint _S78 = _S75 + _S77;
    float _S79 = __ldg(&(&(globalParams_0->families_0)[family_2])->count_0);
    uint _S80 = (U32_min((_S78), (uint(_S79) - 1U)));
    uint _S81 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S82 = _S81 + _S80 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S80;
    (&cell_1)->below_0 = _S69 - table_number_0(_S82);
    (&cell_1)->above_0 = table_number_0(_S82 + 1U) - _S69;
    (&cell_1)->across_2 = _S69 - table_number_0(_S82 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S82 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    uint _S83 = __ldg(&(&(globalParams_0->families_0)[family_3])->is_alike_0);
    if(_S83 != 0U)
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Shown_0
{
    bool is_warp_2;
    bool hole_3;
    bool on_top_0;
    uint word_0;
};

struct Crossing_0
{
    Cell_0 warp_2;
    Cell_0 weft_2;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_3)
{
    bool _S84 = (F32_abs(((&crossing_0->warp_2)->across_2))) < ((&crossing_0->warp_2)->half_width_1);
    bool _S85 = (F32_abs(((&crossing_0->weft_2)->across_2))) < ((&crossing_0->weft_2)->half_width_1);
    Shown_0 shown_0;
    bool _S86;
    if(_S84)
    {
        if(!_S85)
        {
            _S86 = true;
        }
        else
        {
            _S86 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S86 = false;
    }
    (&shown_0)->is_warp_2 = _S86;
    if(!_S84)
    {
        _S86 = !_S85;
    }
    else
    {
        _S86 = false;
    }
    (&shown_0)->hole_3 = _S86;
    uint _S87;
    if((&shown_0)->is_warp_2)
    {
        _S87 = crossing_0->warp_word_0;
    }
    else
    {
        _S87 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S87;
    (&shown_0)->on_top_0 = ((_S87 & 1U) == 1U) != back_3;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_2;
    uint _S88;
    if(is_first_0)
    {
        _S88 = first_0->thread_0;
    }
    else
    {
        _S88 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S88;
    float _S89;
    if(is_first_0)
    {
        _S89 = first_0->across_2;
    }
    else
    {
        _S89 = second_0->across_2;
    }
    (&cell_2)->across_2 = _S89;
    if(is_first_0)
    {
        _S89 = first_0->half_width_1;
    }
    else
    {
        _S89 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S89;
    if(is_first_0)
    {
        _S89 = first_0->below_0;
    }
    else
    {
        _S89 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S89;
    if(is_first_0)
    {
        _S89 = first_0->above_0;
    }
    else
    {
        _S89 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S89;
    return cell_2;
}

__device__ float boundary_0(uint family_4, uint thread_1, int step_0)
{
    float2  _S90 = turns_and_remainder_0(family_4, float(int(thread_1) + step_0));
    float _S91 = _S90.x;
    float _S92 = __ldg(&(&(globalParams_0->families_0)[family_4])->period_0);
    uint _S93 = __ldg(&(&(globalParams_0->families_0)[family_4])->place_table_0);
    return (F32_fma((_S91), (_S92), (table_number_0(_S93 + uint(_S90.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_2, int first_1, int last_0)
{
    uint _S94 = __ldg(&(&(globalParams_0->families_0)[family_5])->is_alike_0);
    if(_S94 != 0U)
    {
        float _S95 = float(last_0 - first_1);
        float _S96 = __ldg(&(&(globalParams_0->families_0)[family_5])->size_0);
        return _S95 * _S96;
    }
    return boundary_0(family_5, thread_2, last_0) - boundary_0(family_5, thread_2, first_1);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

__device__ Bend_0 bend_of_0(uint family_6, uint thread_3)
{
    uint _S97 = __ldg(&(&(globalParams_0->families_0)[family_6])->bend_table_0);
    uint _S98 = __ldg(&(&(globalParams_0->families_0)[family_6])->is_alike_0);
    uint _S99;
    if(_S98 != 0U)
    {
        _S99 = 0U;
    }
    else
    {
        _S99 = thread_3 * 4U;
    }
    uint _S100 = _S97 + _S99;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S100);
    (&bend_0)->half_tangent_0 = table_number_0(_S100 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S100 + 2U);
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

__device__ Run_0 unpack_0(uint own_0, uint other_0, uint thread_4, Cell_0 * crossed_0, uint word_1)
{
    int _S101 = int((word_1 >> int(1)) & 127U);
    int _S102 = int((word_1 >> int(8)) & 127U);
    int _S103 = int((word_1 >> int(15)) & 63U);
    int _S104 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S105 = crossed_0->thread_0;
    int _S106 = - _S101;
    float _S107 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_0, _S106, int(0));
    (&run_0)->from_start_0 = _S107;
    int _S108 = _S102 + int(1);
    float _S109 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_0, int(1), _S108);
    (&run_0)->to_end_0 = _S109;
    bool _S110 = _S107 < _S109;
    (&run_0)->near_start_0 = _S110;
    int _S111;
    if(_S110)
    {
        _S111 = _S106 - _S103;
    }
    else
    {
        _S111 = _S108;
    }
    int _S112;
    if((&run_0)->near_start_0)
    {
        _S112 = _S106;
    }
    else
    {
        _S112 = _S108 + _S104;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_4);
    float _S113;
    if((&run_0)->straight_0)
    {
        _S113 = 1.0e+06f;
    }
    else
    {
        _S113 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S113;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S105, _S111, _S112)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S101 == int(0);
    (&run_0)->last_crossing_0 = _S102 == int(0);
    return run_0;
}

__device__ float square_0(float x_23)
{
    return x_23 * x_23;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_3)
{
    float _S114 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S115 = clamp_1(cell_3->across_2, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_3 = _S115;
    float _S116 = _S114 * _S114 - square_0(_S115);
    float _S117 = (F32_rsqrt((_S116)));
    (&section_0)->drop_0 = _S114 - _S116 * _S117;
    (&section_0)->slope_0 = - _S115 * _S117;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_5, int step_1)
{
    uint _S118 = __ldg(&(&(globalParams_0->families_0)[family_7])->is_alike_0);
    if(_S118 != 0U)
    {
        uint _S119 = __ldg(&(&(globalParams_0->families_0)[family_7])->bend_table_0);
        return table_number_0(_S119 + 3U);
    }
    uint _S120 = __ldg(&(&(globalParams_0->families_0)[family_7])->bend_table_0);
    return table_number_0(_S120 + uint(turns_and_remainder_0(family_7, float(int(thread_5) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S121 = crossed_1->below_0;
    float _S122 = crossed_1->above_0;
    bool _S123 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S124 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S125;
    if(_S123)
    {
        _S125 = _S121 - crossed_1->across_2;
    }
    else
    {
        _S125 = _S122 + crossed_1->across_2;
    }
    float _S126 = _S125 - crossed_1->half_width_1;
    bool _S127;
    if(_S123)
    {
        _S127 = run_1->first_crossing_0;
    }
    else
    {
        _S127 = run_1->last_crossing_0;
    }
    bool _S128 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S125 = 0.0f;
    }
    else
    {
        float _S129 = __ldg(&(&(globalParams_0->families_0)[other_1])->height_scale_0);
        _S125 = _S129 * edge_drop_0(other_1, crossed_1->thread_0, int(0));
    }
    float _S130;
    if(_S128 != _S127)
    {
        _S130 = 0.0f;
    }
    else
    {
        float _S131 = __ldg(&(&(globalParams_0->families_0)[other_1])->height_scale_0);
        uint _S132 = crossed_1->thread_0;
        int _S133;
        if(_S123)
        {
            _S133 = int(-1);
        }
        else
        {
            _S133 = int(1);
        }
        _S130 = _S131 * edge_drop_0(other_1, _S132, _S133);
    }
    float _S134 = 1.0f / (F32_max((2.0f * _S126), (9.999999960041972e-13f)));
    float _S135 = clamp_1((_S126 - _S124) * _S134, 0.0f, 1.0f);
    float _S136 = _S125 + (_S130 - _S125) * (_S135 * _S135 * (3.0f - 2.0f * _S135));
    float _S137 = (_S125 - _S130) * (6.0f * _S135 * (1.0f - _S135) * _S134);
    if(_S123)
    {
        _S125 = 1.0f;
    }
    else
    {
        _S125 = -1.0f;
    }
    return make_float2 (_S136, _S137 * _S125);
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

__device__ StepControl_0 step_control_0(float2  direction_1, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S138 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S138)))), (9.99999971718068537e-10f)));
    float _S139 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S139)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S138 > 0.0f;
    (&control_0)->up_0 = _S139 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
    float clearance_0;
    float rate_0;
    uint yarn_0;
    bool known_0;
};

__device__ PreviousSample_0 no_previous_sample_0()
{
    PreviousSample_0 previous_0;
    (&previous_0)->clearance_0 = 0.0f;
    (&previous_0)->rate_0 = 0.0f;
    (&previous_0)->yarn_0 = 0U;
    (&previous_0)->known_0 = false;
    return previous_0;
}

__device__ float outline_distance_0(Cell_0 * cell_4, Shown_0 * shown_2, Run_0 * run_2, bool lengthwise_0, bool forwards_0)
{
    float _S140;
    if(forwards_0)
    {
        _S140 = cell_4->across_2;
    }
    else
    {
        _S140 = - cell_4->across_2;
    }
    float _S141;
    if(forwards_0)
    {
        _S141 = cell_4->above_0;
    }
    else
    {
        _S141 = cell_4->below_0;
    }
    bool _S142;
    if(forwards_0)
    {
        _S142 = run_2->last_crossing_0;
    }
    else
    {
        _S142 = run_2->first_crossing_0;
    }
    bool _S143;
    if(forwards_0)
    {
        _S143 = run_2->first_crossing_0;
    }
    else
    {
        _S143 = run_2->last_crossing_0;
    }
    float _S144 = cell_4->half_width_1;
    float _S145 = - cell_4->half_width_1;
    bool _S146 = _S140 < _S145;
    bool _S147 = _S140 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S142 = !_S142;
    }
    else
    {
        _S142 = false;
    }
    if(_S142)
    {
        _S142 = !shown_2->hole_3;
    }
    else
    {
        _S142 = false;
    }
    bool _S148;
    if(_S142)
    {
        _S148 = shown_2->on_top_0;
    }
    else
    {
        _S148 = false;
    }
    if(_S148)
    {
        if(_S143)
        {
            _S143 = _S146;
        }
        else
        {
            _S143 = false;
        }
        _S143 = !_S143;
    }
    else
    {
        _S143 = false;
    }
    if(shown_2->hole_3)
    {
        _S142 = true;
    }
    else
    {
        if(_S142)
        {
            _S142 = !shown_2->on_top_0;
        }
        else
        {
            _S142 = false;
        }
    }
    float _S149;
    if(_S146)
    {
        _S149 = _S145;
    }
    else
    {
        _S149 = _S144;
    }
    float _S150 = _S149 - _S140;
    if(_S142)
    {
        _S140 = 2.0f * _S141 + _S140 - _S144;
    }
    else
    {
        _S140 = _S141;
    }
    if(_S143)
    {
        if(forwards_0)
        {
            _S140 = run_2->to_end_0;
        }
        else
        {
            _S140 = run_2->from_start_0;
        }
        return _S140;
    }
    if(_S147)
    {
    }
    else
    {
        _S140 = _S150;
    }
    return _S140;
}

struct Probe_0
{
    float height_4;
    bool hole_4;
    float slope_x_0;
    float slope_y_0;
    uint yarn_1;
    float cell_max_0;
    float side_x_0;
    float side_y_0;
    float edge_x_0;
    float edge_y_0;
};

__device__ float way_back_to_dip_0(PreviousSample_0 * previous_1, float clearance_1, float rate_1, float step_4, Probe_0 * here_0)
{
    float _S151 = previous_1->rate_0;
    float _S152 = previous_1->rate_0 * step_4;
    float _S153 = rate_1 * step_4;
    bool _S154;
    if(!previous_1->known_0)
    {
        _S154 = true;
    }
    else
    {
        _S154 = here_0->hole_4;
    }
    if(_S154)
    {
        _S154 = true;
    }
    else
    {
        _S154 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S154)
    {
        _S154 = true;
    }
    else
    {
        _S154 = _S151 >= 0.0f;
    }
    if(_S154)
    {
        _S154 = true;
    }
    else
    {
        _S154 = rate_1 <= 0.0f;
    }
    if(_S154)
    {
        return -1.0f;
    }
    float _S155 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S152) >= 0.0f)
    {
        _S154 = (3.0f * clearance_1 - _S153) >= 0.0f;
    }
    else
    {
        _S154 = false;
    }
    if(_S154)
    {
        return -1.0f;
    }
    float _S156 = clearance_1 - _S155;
    float _S157 = 6.0f * _S156 - 4.0f * _S152 - 2.0f * _S153;
    float _S158 = -2.0f * _S152 / (F32_max((_S157 + (F32_sqrt(((F32_max((_S157 * _S157 - 4.0f * (3.0f * (_S152 + _S153 - 2.0f * _S156)) * _S152), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S159 = 1.0f - _S158;
    float _S160 = (_S155 * (2.0f * _S158 + 1.0f) + _S152 * _S158) * _S159 * _S159;
    float _S161 = (clearance_1 * (2.0f * _S159 + 1.0f) - _S153 * _S159) * _S158 * _S158;
    if(_S158 > 0.01999999955296516f)
    {
        _S154 = _S159 > 0.01999999955296516f;
    }
    else
    {
        _S154 = false;
    }
    if(_S154)
    {
        _S154 = (_S160 + _S161) < 0.0f;
    }
    else
    {
        _S154 = false;
    }
    float _S162;
    if(_S154)
    {
        _S162 = _S159 * step_4;
    }
    else
    {
        _S162 = -1.0f;
    }
    return _S162;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S163 = here_1->hole_4;
    float _S164;
    if(here_1->hole_4)
    {
        _S164 = 1.0e+09f;
    }
    else
    {
        _S164 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S164;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S165;
    if(!_S163)
    {
        _S165 = !is_cell_exit_0;
    }
    else
    {
        _S165 = false;
    }
    (&previous_2)->known_0 = _S165;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S166 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S167;
    if(!here_2->hole_4)
    {
        _S167 = (rate_3 * _S166 + clearance_3) < 0.0f;
    }
    else
    {
        _S167 = false;
    }
    if(_S167)
    {
        _S167 = _S166 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S167 = false;
    }
    float _S168 = this_2->step_2;
    float _S169;
    if(_S167)
    {
        _S169 = _S166 - this_2->epsilon_0;
    }
    else
    {
        _S169 = (F32_max((_S166), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S168), (_S169)));
}

struct ViewRay_0
{
    float2  origin_0;
    float2  slope_1;
};

__device__ float2  ViewRay_at_0(ViewRay_0 * this_3, float height_5)
{
    return this_3->origin_0 + this_3->slope_1 * make_float2 (height_5);
}

__device__ float ViewRay_rate_0(ViewRay_0 * this_4, Probe_0 * here_3)
{
    return here_3->slope_x_0 * this_4->slope_1.x + here_3->slope_y_0 * this_4->slope_1.y - 1.0f;
}

__device__ float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S170 = end_0 - start_1;
    float _S171 = start_rate_0 + end_rate_0 - 2.0f * _S170;
    float _S172 = 3.0f * _S170 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S170), (9.99999968265522539e-21f)));
    int i_9 = int(0);
    for(;;)
    {
        if(uint(i_9) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S173 = clamp_1(share_1 - (((_S171 * share_1 + _S172) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S171 * share_1 + 2.0f * _S172) * share_1 + start_rate_0), (0.10000000149011612f * _S170 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S174 = i_9 + int(1);
        share_1 = _S173;
        i_9 = _S174;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_1(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S175 = along_slope_0 * along_slope_0 + 1.0f;
    float _S176 = (F32_rsqrt((_S175)));
    float _S177 = sine_1 * _S176 * (F32_rsqrt((_S175 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S177 * _S175, _S177 * across_slope_0 * along_slope_0 + cosine_0 * _S176);
}

__device__ float arc_sine_0(float x_24)
{
    float _S178 = (F32_abs((x_24)));
    bool _S179 = _S178 > 0.5f;
    float _S180;
    if(_S179)
    {
        _S180 = 0.5f * (1.0f - _S178);
    }
    else
    {
        _S180 = _S178 * _S178;
    }
    float _S181;
    if(_S179)
    {
        _S181 = (F32_sqrt(((F32_max((_S180), (0.0f))))));
    }
    else
    {
        _S181 = _S178;
    }
    float _S182 = ((((0.04216320067644119f * _S180 + 0.02418131195008755f) * _S180 + 0.04547002539038658f) * _S180 + 0.07495300471782684f) * _S180 + 0.16666752099990845f) * _S180 * _S181 + _S181;
    if(_S179)
    {
        _S180 = 1.57079637050628662f - 2.0f * _S182;
    }
    else
    {
        _S180 = _S182;
    }
    if(x_24 < 0.0f)
    {
        _S180 = - _S180;
    }
    return _S180;
}

struct Hair_0
{
    float cover_0;
    float3  normal_2;
    float3  tangent_2;
};

__device__ Hair_0 Hair_x24init_0(float cover_1, float3  normal_3, float3  tangent_3)
{
    Hair_0 _S183;
    (&_S183)->cover_0 = cover_1;
    (&_S183)->normal_2 = normal_3;
    (&_S183)->tangent_2 = tangent_3;
    return _S183;
}

__device__ float fade_0(float size_1, float period_1)
{
    return clamp_1((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S184 = value_0 * 747796405U + 2891336453U;
    uint _S185 = ((_S184 >> ((_S184 >> int(28)) + 4U)) ^ _S184) * 277803737U;
    return (_S185 >> int(22)) ^ _S185;
}

__device__ uint hash_key_0(uint thread_6, uint stream_0)
{
    return scramble_0(thread_6 + scramble_0(stream_0));
}

__device__ uint hash_bits_0(uint key_0, uint cell_5)
{
    return scramble_0(cell_5 + key_0);
}

__device__ float share_of_0(uint bits_0)
{
    return (float(bits_0 & 1023U) + 0.5f) * 0.0009765625f;
}

__device__ float2  sine_cosine_0(float x_25)
{
    float _S186 = (F32_floor((x_25 * 0.63661974668502808f + 0.5f)));
    float _S187 = x_25 - _S186 * 1.5703125f - _S186 * 0.00048375129699707f - _S186 * 7.54979012640433211e-08f;
    float _S188 = _S187 * _S187;
    float _S189 = ((-0.00019515295571182f * _S188 + 0.00833216123282909f) * _S188 - 0.16666655242443085f) * _S188 * _S187 + _S187;
    float _S190 = ((0.00002443315679557f * _S188 - 0.00138873164542019f) * _S188 + 0.04166664555668831f) * _S188 * _S188 - 0.5f * _S188 + 1.0f;
    uint _S191 = uint(int(_S186)) & 3U;
    float2  _S192;
    if((_S191 & 1U) != 0U)
    {
        _S192 = make_float2 (_S190, _S189);
    }
    else
    {
        _S192 = make_float2 (_S189, _S190);
    }
    float _S193;
    if((_S191 & 2U) != 0U)
    {
        _S193 = - _S192.x;
    }
    else
    {
        _S193 = _S192.x;
    }
    float _S194;
    if(((_S191 + 1U) & 2U) != 0U)
    {
        _S194 = - _S192.y;
    }
    else
    {
        _S194 = _S192.y;
    }
    return make_float2 (_S193, _S194);
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

__device__ Albedos_0 albedos_of_0(uint family_8, uint thread_7)
{
    uint _S195 = __ldg(&(&(globalParams_0->families_0)[family_8])->albedo_table_0);
    uint _S196 = __ldg(&(&(globalParams_0->families_0)[family_8])->albedo_stride_0);
    return table_albedos_0(_S195 + _S196 * thread_7);
}

__device__ float3  fibre_cell_0(float across_4, float along_0, float width_2)
{
    float _S197 = (F32_floor((across_4 / width_2)));
    return make_float3 (_S197, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S197, 2.0f * (across_4 / width_2 - _S197) - 1.0f);
}

__device__ float ply_offset_0(uint family_9, SurfacePoint_0 * point_0, bool back_4)
{
    float _S198;
    if(back_4)
    {
        float _S199 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_sine_0);
        _S198 = - _S199;
    }
    else
    {
        float _S200 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_sine_0);
        _S198 = _S200;
    }
    float _S201 = point_0->fibre_across_0;
    float _S202 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_cosine_0);
    float _S203 = _S201 * _S202 + point_0->fibre_along_0 * _S198;
    float _S204 = __ldg(&(&(globalParams_0->families_0)[family_9])->plies_per_mm_0);
    float _S205 = _S203 * _S204;
    return 2.0f * (_S205 - (F32_floor((_S205)))) - 1.0f;
}

__device__ float signed_noise_0(uint bits_1)
{
    return (float(bits_1 & 65535U) + 0.5f) * 0.000030517578125f - 1.0f;
}

__device__ float smooth_share_0(float share_2)
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

__device__ float2  wave_noise_0(uint key_1, float position_3)
{
    float _S206 = (F32_floor((position_3)));
    float _S207 = position_3 - _S206;
    uint _S208 = uint(int(_S206));
    float _S209 = signed_noise_0(hash_bits_0(key_1, _S208));
    float _S210 = signed_noise_0(hash_bits_0(key_1, _S208 + 1U));
    return make_float2 (lerp_1(_S209, _S210, smooth_share_0(_S207)), 6.0f * _S207 * (1.0f - _S207) * (_S210 - _S209));
}

__device__ float2  cell_noise_0(uint key_2, float3  cell_6)
{
    float _S211 = cell_6.y;
    float _S212 = (F32_floor((_S211)));
    uint _S213 = uint(int(cell_6.x)) * 65536U + uint(int(_S212));
    uint _S214 = hash_bits_0(key_2, _S213);
    uint _S215 = hash_bits_0(key_2, _S213 + 1U);
    return lerp_2(make_float2 (signed_noise_0(_S214), signed_noise_0(_S214 >> int(16))), make_float2 (signed_noise_0(_S215), signed_noise_0(_S215 >> int(16))), make_float2 (smooth_share_0(_S211 - _S212)));
}

__device__ float uniform_hash_0(uint thread_8, uint cell_7, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_8, stream_1), cell_7)) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float thread_gain_0(uint thread_9, float amount_0, uint seed_2)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_2 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_1, float3  room_0)
{
    float3  _S216 = room_0 / max_0(albedo_1, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S216.x), (_S216.y)))), (_S216.z)))), (0.0f))))));
}

__device__ float flattened_0(float largest_0, float3  albedo_2, float3  room_1)
{
    float3  _S217 = room_1 / max_0(albedo_2, make_float3 (9.99999997475242708e-07f)) - make_float3 (1.0f);
    return (F32_min(((F32_max(((F32_min(((F32_min((_S217.x), (_S217.y)))), (_S217.z)))), (0.0f))) / (F32_max((largest_0), (9.99999997475242708e-07f)))), (1.0f)));
}

__device__ float fibre_gain_0(uint thread_10, uint cell_8, float amount_1, uint seed_3)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_10, cell_8, seed_3 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
    float3  normal_4;
    float3  tangent_4;
    float loss_0;
};

__device__ YarnFrame_0 under_hair_0(YarnFrame_0 * frame_0, Hair_0 * hair_0)
{
    float3  _S218 = frame_0->tangent_4;
    float3  _S219 = hair_0->tangent_2;
    float3  _S220;
    if((dot_0(frame_0->tangent_4, hair_0->tangent_2)) < 0.0f)
    {
        _S220 = - _S219;
    }
    else
    {
        _S220 = _S219;
    }
    YarnFrame_0 blended_0;
    float3  _S221 = make_float3 (hair_0->cover_0);
    float3  _S222 = normalize_0(lerp_0(frame_0->normal_4, hair_0->normal_2, _S221));
    (&blended_0)->normal_4 = _S222;
    float3  _S223 = lerp_0(_S218, _S220, _S221);
    float3  _S224 = _S223 - make_float3 (dot_0(_S223, _S222)) * _S222;
    (&blended_0)->tangent_4 = _S224 * make_float3 ((F32_rsqrt(((F32_max((dot_0(_S224, _S224)), (9.999999960041972e-13f)))))));
    (&blended_0)->loss_0 = frame_0->loss_0 * (1.0f - hair_0->cover_0);
    return blended_0;
}

__device__ float diffuse_gain_0(YarnFrame_0 * frame_1, float blend_0)
{
    return (F32_min((0.85000002384185791f * blend_0 * frame_1->loss_0 + 1.0f), (1.0f / (0.5f * blend_0 * (frame_1->normal_4.z - 1.0f) + 1.0f))));
}

__device__ float diffuse_reflection_0(float3  light_1, float3  normal_5, float blend_1)
{
    float _S225 = light_1.z;
    if(_S225 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_1((F32_max((_S225), (0.0f))), (F32_max((dot_0(light_1, normal_5)), (0.0f))), blend_1);
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_5, float roughness_1)
{
    float _S226 = dot_0(direction_2, tangent_5);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S226 * _S226 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_26)
{
    float _S227 = clamp_1(x_26, -87.0f, 88.0f);
    float _S228 = (F32_floor((_S227 * 1.4426950216293335f + 0.5f)));
    float _S229 = _S227 - _S228 * 0.693359375f + _S228 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S229 + 0.00139819993637502f) * _S229 + 0.00833345204591751f) * _S229 + 0.04166579619050026f) * _S229 + 0.1666666567325592f) * _S229 + 0.5f;
    float _S230 = (U32_asfloat((uint(int(_S228) + int(127)) << int(23))));
    float _S231;
    if(x_26 < -87.0f)
    {
        _S231 = 0.0f;
    }
    else
    {
        _S231 = (p_0 * _S229 * _S229 + _S229 + 1.0f) * _S230;
    }
    return _S231;
}

__device__ float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

__device__ float square_1(float3  v_1)
{
    return dot_0(v_1, v_1);
}

__device__ float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S232 = roughness_2 * roughness_2;
    float _S233 = squared_along_0 * (1.0f - _S232) + _S232;
    return 0.31830987334251404f * _S232 * roughness_2 / (_S233 * _S233);
}

__device__ float density_between_0(float3  light_2, float3  view_1, float3  tangent_6, float roughness_3)
{
    float3  _S234 = light_2 + view_1;
    float _S235 = dot_0(_S234, tangent_6);
    return flake_density_0((F32_min((_S235 * _S235 / (F32_max((square_1(_S234)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float transmission_1(float3  light_3, float3  view_2, float3  normal_6, float3  tangent_7, float roughness_4, float optical_depth_1)
{
    float _S236 = - dot_0(light_3, normal_6);
    float _S237 = dot_0(view_2, normal_6);
    bool _S238;
    if(_S236 <= 0.0f)
    {
        _S238 = true;
    }
    else
    {
        _S238 = _S237 <= 0.0f;
    }
    if(_S238)
    {
        return 0.0f;
    }
    float _S239 = 1.0f / (F32_max((_S237), (9.99999997475242708e-07f)));
    float _S240 = projected_area_1(light_3, tangent_7, roughness_4) / (F32_max((_S236), (9.99999997475242708e-07f)));
    float _S241 = projected_area_1(view_2, tangent_7, roughness_4) * _S239;
    return density_between_0(light_3, view_2, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * (F32_min((_S240), (_S241)))) * mean_attenuation_0(optical_depth_1 * (F32_abs((_S240 - _S241)))) * _S239;
}

__device__ float reflection_0(float3  light_4, float3  view_3, float3  normal_7, float3  tangent_8, float roughness_5, float optical_depth_2)
{
    float _S242 = dot_0(light_4, normal_7);
    bool _S243;
    if(_S242 <= 0.0f)
    {
        _S243 = true;
    }
    else
    {
        _S243 = (dot_0(view_3, normal_7)) <= 0.0f;
    }
    if(_S243)
    {
        return 0.0f;
    }
    float _S244 = (F32_max((_S242), (9.99999997475242708e-07f)));
    float _S245 = (F32_max((dot_0(view_3, normal_7)), (9.99999997475242708e-07f)));
    float _S246 = projected_area_1(light_4, tangent_8, roughness_5) * _S245 + projected_area_1(view_3, tangent_8, roughness_5) * _S244;
    float _S247 = optical_depth_2 * _S246 / (_S244 * _S245);
    return 0.25f * density_between_0(light_4, view_3, tangent_8, roughness_5) * (_S247 * mean_attenuation_0(_S247)) * _S244 / _S246;
}

__device__ Components_0 with_added_0(Components_0 * sums_1, Components_0 * more_0, float weight_1)
{
    Components_0 result_12;
    (&result_12)->diffuse_warp_0 = sums_1->diffuse_warp_0 + weight_1 * more_0->diffuse_warp_0;
    (&result_12)->diffuse_weft_0 = sums_1->diffuse_weft_0 + weight_1 * more_0->diffuse_weft_0;
    (&result_12)->specular_warp_0 = sums_1->specular_warp_0 + weight_1 * more_0->specular_warp_0;
    (&result_12)->specular_weft_0 = sums_1->specular_weft_0 + weight_1 * more_0->specular_weft_0;
    (&result_12)->light_visibility_1 = sums_1->light_visibility_1 + weight_1 * more_0->light_visibility_1;
    (&result_12)->hole_2 = sums_1->hole_2 + weight_1 * more_0->hole_2;
    return result_12;
}

__device__ Blocked_0 scaled_0(Blocked_0 * blocked_0, float share_3)
{
    Blocked_0 result_13;
    (&result_13)->by_warp_0 = share_3 * blocked_0->by_warp_0;
    (&result_13)->by_weft_0 = share_3 * blocked_0->by_weft_0;
    (&result_13)->far_0 = share_3 * blocked_0->far_0;
    return result_13;
}

__device__ float wrapped_cell_0(float position_4, float count_1)
{
    return (F32_min(((F32_floor(((position_4 - (F32_floor((position_4)))) * count_1)))), (count_1 - 1.0f)));
}

__device__ float arc_tangent_quotient_0(float x_27, float y_12)
{
    return ((((((0.0f * x_27 + 0.00809729471802711f) * x_27 + -0.0377517081797123f) * x_27 + 0.08475969731807709f) * x_27 + -0.13537675142288208f) * x_27 + 0.19895026087760925f) * x_27 + -0.33327975869178772f) * x_27 + 0.99999970197677612f;
}

__device__ float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

__device__ float arc_tangent_0(float y_13, float x_28)
{
    float _S248 = (F32_abs((x_28)));
    float _S249 = (F32_abs((y_13)));
    float angle_0 = arc_tangent_of_ratio_0((F32_min((_S248), (_S249))) / (F32_max(((F32_max((_S248), (_S249)))), (1.00000000317107685e-30f))));
    float angle_1;
    if(_S249 > _S248)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_28 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_13 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
    uint4  nodes_0;
    uint4  weights_0;
    float inverse_sum_0;
};

__device__ NodeTaps_0 node_taps_0(float3  direction_3)
{
    float _S250 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    float _S251 = (F32_floor((_S250)));
    float _S252 = _S250 - _S251;
    float _S253 = (F32_sqrt((clamp_1((1.0f - (F32_abs((direction_3.z)))) / 0.97000002861022949f, 0.0f, 1.0f))));
    float _S254 = 7.0f * _S253 * (F32_sqrt((_S253)));
    float _S255 = (F32_min(((F32_floor((_S254)))), (6.0f)));
    float _S256 = _S254 - _S255;
    uint _S257 = uint(int(_S251) + int(32)) % 32U;
    uint _S258 = uint(_S255);
    uint _S259 = _S257 * 8U + _S258;
    uint _S260 = (_S257 + 1U) % 32U * 8U + _S258;
    NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = make_uint4 (_S259, _S259 + 1U, _S260, _S260 + 1U);
    float _S261 = 1.0f - _S252;
    float _S262 = 1.0f - _S256;
    float4  _S263 = make_float4 (_S261 * _S262, _S261 * _S256, _S252 * _S262, _S252 * _S256) * make_float4 (252.0f) + make_float4 (0.5f);
    uint4  _S264 = make_uint4 ((uint)_S263.x, (uint)_S263.y, (uint)_S263.z, (uint)_S263.w);
    (&taps_0)->weights_0 = _S264;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S264.x + _S264.y + _S264.z + _S264.w);
    return taps_0;
}

__device__ float3  half_vector_0(float3  light_5, float3  view_4)
{
    float3  _S265 = light_5 + view_4;
    return _S265 * make_float3 ((F32_rsqrt(((F32_max((square_1(_S265)), (9.999999960041972e-13f)))))));
}

__device__ float3  shadow_correlation_0(float3  light_6, float3  view_5)
{
    float2  _S266 = float2 {light_6.x, light_6.y};
    float2  _S267 = float2 {view_5.x, view_5.y};
    float _S268 = dot_1(_S266, _S267) / (F32_max(((F32_sqrt((dot_1(_S266, _S266) * dot_1(_S267, _S267))))), (9.99999997475242708e-07f)));
    if((light_6.z) < 0.0f)
    {
        return make_float3 (make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S268).x, make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S268).y, 0.0f);
    }
    return make_float3 ((F32_min((0.62000000476837158f + 0.62999999523162842f * _S268), (1.20000004768371582f))), 0.62000000476837158f, 0.37000000476837158f);
}

__device__ float4  bytes_of_sums_0(uint even_0, uint odd_0)
{
    return make_float4 (float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

__device__ float4  interpolate_0(NodeTaps_0 * taps_1, uint4  packs_2)
{
    uint4  _S269 = (packs_2 & make_uint4 (16711935U)) * taps_1->weights_0;
    uint4  _S270 = ((packs_2 >> make_uint4 (int(8))) & make_uint4 (16711935U)) * taps_1->weights_0;
    return bytes_of_sums_0(_S269.x + _S269.y + _S269.z + _S269.w, _S270.x + _S270.y + _S270.z + _S270.w) * make_float4 (taps_1->inverse_sum_0);
}

__device__ float4  interpolate_table_0(NodeTaps_0 * taps_2, uint table_0, uint stride_0)
{
    uint4  _S271 = make_uint4 (table_0) + taps_2->nodes_0 * make_uint4 (stride_0);
    uint _S272 = __ldg((&(globalParams_0->words_0)[_S271.x]));
    uint _S273 = __ldg((&(globalParams_0->words_0)[_S271.y]));
    uint _S274 = __ldg((&(globalParams_0->words_0)[_S271.z]));
    uint _S275 = __ldg((&(globalParams_0->words_0)[_S271.w]));
    float4  _S276 = interpolate_0(taps_2, make_uint4 (_S272, _S273, _S274, _S275));
    return _S276;
}

struct Group_0
{
    float3  normal_8;
    float weight_2;
    float3  tangent_9;
    float3  variance_0;
    float3  covariance_0;
    float roughness_6;
};

__device__ Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    (&group_0)->normal_8 = make_float3 (table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    (&group_0)->weight_2 = table_number_0(row_1 + 3U);
    float3  _S277 = make_float3 (table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    (&group_0)->tangent_9 = _S277;
    float _S278 = table_number_0(row_1 + 7U);
    float _S279 = table_number_0(row_1 + 8U);
    (&group_0)->variance_0 = make_float3 (_S278, _S279, 1.0f - square_1(_S277) - _S278 - _S279);
    (&group_0)->covariance_0 = make_float3 (table_number_0(row_1 + 9U), table_number_0(row_1 + 10U), table_number_0(row_1 + 11U));
    (&group_0)->roughness_6 = roughness_7;
    return group_0;
}

__device__ float2  visibility_gain_0(float3  correlations_0, float from_light_0, float from_view_0)
{
    return max_1(float2 {correlations_0.x, correlations_0.y} * make_float2 (1.0f / (F32_max(((F32_max((from_light_0), (from_view_0)))), (0.00392156885936856f))) - 1.0f) + make_float2 (1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), make_float2 (0.0f));
}

__device__ float Group_variance_along_0(Group_0 * this_5, float3  direction_4)
{
    float _S280 = direction_4.x;
    float _S281 = direction_4.y;
    float _S282 = direction_4.z;
    return (F32_max((dot_0(this_5->variance_0, direction_4 * direction_4) + 2.0f * dot_0(this_5->covariance_0, make_float3 (_S280 * _S281, _S280 * _S282, _S281 * _S282))), (0.0f)));
}

__device__ float mean_area_0(Group_0 * group_1, float3  direction_5)
{
    float _S283 = dot_0(direction_5, group_1->tangent_9);
    float _S284 = _S283 * _S283;
    float _S285 = Group_variance_along_0(group_1, direction_5);
    float _S286 = group_1->roughness_6 * group_1->roughness_6;
    return (F32_sqrt(((F32_max(((_S286 - 1.0f) * (_S284 + _S285) + 1.0f), (_S286))))));
}

__device__ float mean_density_0(Group_0 * group_2, float3  half_0)
{
    float _S287 = group_2->roughness_6;
    float _S288 = (F32_max(((F32_sqrt(((F32_max((1.0f - group_2->roughness_6 * group_2->roughness_6), (0.0f)))))) / group_2->roughness_6), (0.00100000004749745f)));
    float _S289 = Group_variance_along_0(group_2, half_0);
    float _S290 = (F32_max(((F32_sqrt((3.0f * _S289)))), (_S287 * 0.01999999955296516f + 0.00009999999747379f)));
    float _S291 = dot_0(half_0, group_2->tangent_9);
    float _S292 = _S288 * (_S291 - _S290);
    float _S293 = _S288 * (_S291 + _S290);
    float _S294 = _S292 * _S293;
    float _S295 = 2.0f * _S290 * _S288;
    return 0.15915493667125702f / _S287 * ((1.0f - _S294) / ((_S292 * _S292 + 1.0f) * (_S293 * _S293 + 1.0f)) + arc_tangent_0(_S295, 1.0f + _S294) / _S295);
}

__device__ float layer_value_0(Group_0 * group_3, float3  half_1, float3  light_7, float3  view_6, float optical_depth_3)
{
    bool _S296 = (light_7.z) < 0.0f;
    float3  _S297 = group_3->normal_8;
    float _S298 = dot_0(light_7, group_3->normal_8);
    float _S299;
    if(_S296)
    {
        _S299 = - _S298;
    }
    else
    {
        _S299 = _S298;
    }
    float _S300 = (F32_max((_S299), (0.01999999955296516f)));
    float _S301 = (F32_max((dot_0(view_6, _S297)), (0.01999999955296516f)));
    float _S302 = mean_area_0(group_3, light_7);
    float _S303 = _S302 / _S300;
    float _S304 = mean_area_0(group_3, view_6);
    float _S305 = _S304 / _S301;
    if(_S296)
    {
        _S299 = (F32_abs((_S303 - _S305)));
    }
    else
    {
        _S299 = _S303 + _S305;
    }
    float _S306 = optical_depth_3 * (F32_max((_S299), (0.00100000004749745f)));
    if(_S296)
    {
        _S299 = exponential_0(- optical_depth_3 * (F32_min((_S303), (_S305))));
    }
    else
    {
        _S299 = 1.0f;
    }
    float _S307 = optical_depth_3 * _S299 * (1.0f - exponential_0(- _S306)) / _S306 / _S301;
    if(_S296)
    {
        _S299 = 1.0f;
    }
    else
    {
        _S299 = 1.0f - 0.34999999403953552f * (1.0f - square_1(_S297));
    }
    float _S308 = mean_density_0(group_3, half_1);
    return 0.25f * _S308 * _S299 * _S307;
}

struct Bound_0
{
    uint thread_11;
    float turns_2;
    float cell_9;
    float visible_0;
    float width_3;
    float gap_0;
};

__device__ Bound_0 bound_at_0(uint family_10, float position_5)
{
    Cell_0 _S309 = locate_0(family_10, position_5);
    uint _S310 = __ldg(&(&(globalParams_0->families_0)[family_10])->before_0);
    float _S311 = table_number_0(_S310 + 2U * _S309.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_11 = _S309.thread_0;
    float _S312 = __ldg(&(&(globalParams_0->families_0)[family_10])->start_0);
    float _S313 = position_5 - _S312 - _S311 - _S309.below_0;
    float _S314 = __ldg(&(&(globalParams_0->families_0)[family_10])->inverse_period_0);
    (&bound_0)->turns_2 = (F32_round((_S313 * _S314)));
    (&bound_0)->cell_9 = _S309.below_0;
    float _S315 = 2.0f * _S309.half_width_1;
    (&bound_0)->width_3 = _S315;
    (&bound_0)->visible_0 = clamp_1((_S309.across_2 + _S309.half_width_1) / _S315, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S309.below_0), (_S309.below_0 - _S309.across_2 - _S309.half_width_1))) + (F32_max((_S309.across_2 - _S309.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

__device__ Stretch_0 stretch_of_0(uint family_11, float centre_1, float size_2)
{
    float _S316 = __ldg(&(&(globalParams_0->families_0)[family_11])->start_0);
    float _S317 = centre_1 - _S316;
    float _S318 = __ldg(&(&(globalParams_0->families_0)[family_11])->inverse_period_0);
    float _S319 = (F32_floor((_S317 * _S318)));
    float _S320 = __ldg(&(&(globalParams_0->families_0)[family_11])->period_0);
    float _S321 = centre_1 - _S319 * _S320;
    float _S322 = __ldg(&(&(globalParams_0->families_0)[family_11])->smallest_box_0);
    float _S323 = 0.5f * (F32_max((size_2), (_S322)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_0 = bound_at_0(family_11, _S321 - _S323);
    (&stretch_0)->high_0 = bound_at_0(family_11, _S321 + _S323);
    return stretch_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

__device__ float3  lengths_0(uint family_12, Stretch_0 * stretch_1)
{
    float _S324 = Stretch_turns_0(stretch_1);
    uint _S325 = __ldg(&(&(globalParams_0->families_0)[family_12])->before_0);
    uint _S326 = _S325 + 2U * (&stretch_1->low_0)->thread_11;
    uint _S327 = __ldg(&(&(globalParams_0->families_0)[family_12])->before_0);
    uint _S328 = _S327 + 2U * (&stretch_1->high_0)->thread_11;
    float _S329 = table_number_0(_S328) - table_number_0(_S326);
    float _S330 = table_number_0(_S328 + 1U) - table_number_0(_S326 + 1U);
    float _S331 = _S329 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_3 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_3;
    float _S332 = __ldg(&(&(globalParams_0->families_0)[family_12])->visible_total_0);
    float _S333 = _S331 + _S324 * _S332;
    float _S334 = _S330 - _S329 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0;
    float _S335 = __ldg(&(&(globalParams_0->families_0)[family_12])->period_0);
    float _S336 = __ldg(&(&(globalParams_0->families_0)[family_12])->visible_total_0);
    float _S337 = _S334 + _S324 * (_S335 - _S336);
    float _S338 = _S330 + (&stretch_1->high_0)->cell_9 - (&stretch_1->low_0)->cell_9;
    float _S339 = __ldg(&(&(globalParams_0->families_0)[family_12])->period_0);
    return make_float3 (_S333, _S337, _S338 + _S324 * _S339);
}

__device__ float2  integrals_along_0(uint family_13, Stretch_0 * stretch_2, uint quantity_0)
{
    uint _S340 = __ldg(&(&(globalParams_0->families_0)[family_13])->quantities_0);
    uint _S341 = __ldg(&(&(globalParams_0->families_0)[family_13])->colour_threads_0);
    uint _S342 = 3U * _S340;
    uint _S343 = _S341 + _S342 * (&stretch_2->low_0)->thread_11 + quantity_0;
    uint _S344 = __ldg(&(&(globalParams_0->families_0)[family_13])->colour_threads_0);
    uint _S345 = _S344 + _S342 * (&stretch_2->high_0)->thread_11 + quantity_0;
    uint _S346 = __ldg(&(&(globalParams_0->families_0)[family_13])->colour_threads_0);
    float _S347 = __ldg(&(&(globalParams_0->families_0)[family_13])->count_0);
    uint _S348 = _S346 + _S342 * uint(_S347) + quantity_0;
    float _S349 = table_number_0(_S343);
    float _S350 = table_number_0(_S345);
    float _S351 = Stretch_turns_0(stretch_2);
    uint _S352 = 2U * _S340;
    return make_float2 (table_number_0(_S345 + _S340) - table_number_0(_S343 + _S340) + _S350 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_3 - _S349 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_3 + _S351 * table_number_0(_S348 + _S340), table_number_0(_S345 + _S352) - table_number_0(_S343 + _S352) + _S350 * (&stretch_2->high_0)->cell_9 - _S349 * (&stretch_2->low_0)->cell_9 + _S351 * table_number_0(_S348 + _S352));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_7)
{
    return ((&this_7->high_0)->thread_11) < ((&this_7->low_0)->thread_11);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_8, uint4  entries_0, uint whole_0)
{
    uint _S353 = entries_0.z;
    uint _S354 = entries_0.x;
    uint _S355 = _S353 - _S354;
    bool _S356 = Stretch_wraps_0(this_8);
    uint _S357;
    if(_S356)
    {
        _S357 = whole_0;
    }
    else
    {
        _S357 = 0U;
    }
    return make_uint4 (_S355 + _S357, entries_0.w - _S353, entries_0.y - _S354, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_5, uint row_2, uint count_2, uint quantities_1)
{
    uint _S358 = row_2 + (&across_5->low_0)->thread_11 * quantities_1;
    uint _S359 = row_2 + (&across_5->high_0)->thread_11 * quantities_1;
    uint _S360 = __ldg((&(globalParams_0->words_0)[_S358]));
    uint _S361 = __ldg((&(globalParams_0->words_0)[_S358 + quantities_1]));
    uint _S362 = __ldg((&(globalParams_0->words_0)[_S359]));
    uint _S363 = __ldg((&(globalParams_0->words_0)[_S359 + quantities_1]));
    uint4  _S364 = make_uint4 (_S360, _S361, _S362, _S363);
    uint _S365 = __ldg((&(globalParams_0->words_0)[row_2 + count_2 * quantities_1]));
    uint4  _S366 = Stretch_differences_0(across_5, _S364, _S365);
    return _S366;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_9)
{
    float _S367 = (&this_9->high_0)->visible_0;
    float _S368 = - (&this_9->low_0)->visible_0;
    float _S369 = Stretch_turns_0(this_9);
    bool _S370 = Stretch_wraps_0(this_9);
    float _S371;
    if(_S370)
    {
        _S371 = 1.0f;
    }
    else
    {
        _S371 = 0.0f;
    }
    return make_float4 (1.0f, _S367, _S368, _S369 - _S371);
}

__device__ float integral_on_top_0(uint family_14, Stretch_0 * across_6, Stretch_0 * along_1, uint crossing_count_0, uint quantity_1)
{
    float _S372 = __ldg(&(&(globalParams_0->families_0)[family_14])->count_0);
    uint _S373 = uint(_S372);
    uint _S374 = _S373 + 1U;
    uint _S375 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint _S376 = _S374 * _S375;
    uint _S377 = __ldg(&(&(globalParams_0->families_0)[family_14])->colour_areas_0);
    uint _S378 = _S377 + quantity_1;
    uint _S379 = (&along_1->low_0)->thread_11;
    uint _S380 = _S378 + (&along_1->low_0)->thread_11 * _S376;
    uint _S381 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S382 = row_differences_0(across_6, _S380, _S373, _S381);
    uint _S383 = _S378 + (_S379 + 1U) * _S376;
    uint _S384 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S385 = row_differences_0(across_6, _S383, _S373, _S384);
    uint _S386 = (&along_1->high_0)->thread_11;
    uint _S387 = _S378 + (&along_1->high_0)->thread_11 * _S376;
    uint _S388 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S389 = row_differences_0(across_6, _S387, _S373, _S388);
    uint _S390 = _S378 + (_S386 + 1U) * _S376;
    uint _S391 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S392 = row_differences_0(across_6, _S390, _S373, _S391);
    uint _S393 = _S378 + crossing_count_0 * _S376;
    uint _S394 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S395 = row_differences_0(across_6, _S393, _S373, _S394);
    uint4  _S396 = _S389 - _S382;
    bool _S397 = Stretch_wraps_0(along_1);
    uint4  _S398;
    if(_S397)
    {
        _S398 = _S395;
    }
    else
    {
        int4  _S399 = make_int4 (int(0));
        uint4  _S400 = make_uint4 ((uint)_S399.x, (uint)_S399.y, (uint)_S399.z, (uint)_S399.w);
        _S398 = _S400;
    }
    uint4  _S401 = _S396 + _S398;
    float4  _S402 = Stretch_weights_0(across_6);
    float4  _S403 = Stretch_weights_0(along_1);
    int4  _S404 = make_int4 ((int)_S401.x, (int)_S401.y, (int)_S401.z, (int)_S401.w);
    float4  _S405 = make_float4 ((float)_S404.x, (float)_S404.y, (float)_S404.z, (float)_S404.w);
    uint4  _S406 = _S392 - _S389;
    int4  _S407 = make_int4 ((int)_S406.x, (int)_S406.y, (int)_S406.z, (int)_S406.w);
    float4  _S408 = make_float4 ((float)_S407.x, (float)_S407.y, (float)_S407.z, (float)_S407.w);
    uint4  _S409 = _S385 - _S382;
    int4  _S410 = make_int4 ((int)_S409.x, (int)_S409.y, (int)_S409.z, (int)_S409.w);
    float4  _S411 = make_float4 ((float)_S410.x, (float)_S410.y, (float)_S410.z, (float)_S410.w);
    int4  _S412 = make_int4 ((int)_S395.x, (int)_S395.y, (int)_S395.z, (int)_S395.w);
    float4  _S413 = make_float4 ((float)_S412.x, (float)_S412.y, (float)_S412.z, (float)_S412.w);
    float _S414 = dot_2(make_float4 (dot_2(_S405, _S402), dot_2(_S408, _S402), dot_2(_S411, _S402), dot_2(_S413, _S402)), _S403);
    float _S415 = __ldg(&(&(globalParams_0->families_0)[family_14])->area_unit_0);
    return _S414 * _S415;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_3, uint row_3)
{
    Albedos_0 _S416 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_3) * _S416.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_3) * _S416.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_3) * _S416.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_3) * _S416.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_15, uint crossing_1, Stretch_0 * own_1, Stretch_0 * other_2, bool back_5)
{
    uint _S417 = __ldg(&(&(globalParams_0->families_0)[family_15])->colour_mean_0);
    Albedos_0 albedos_2 = table_albedos_0(_S417);
    uint _S418 = __ldg(&(&(globalParams_0->families_0)[family_15])->quantities_0);
    if(_S418 == 1U)
    {
        return albedos_2;
    }
    float3  _S419 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_4 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        uint _S420 = __ldg(&(&(globalParams_0->families_0)[family_15])->quantities_0);
        if(quantity_2 < _S420)
        {
        }
        else
        {
            break;
        }
        float2  _S421 = integrals_along_0(family_15, own_1, quantity_2);
        float _S422 = __ldg(&(&(globalParams_0->families_0)[crossing_1])->count_0);
        float _S423 = integral_on_top_0(family_15, own_1, other_2, uint(_S422), quantity_2);
        float _S424 = _S421.x;
        float _S425 = _S424 * _S419.x;
        float _S426;
        if(back_5)
        {
            _S426 = _S425 - _S423;
        }
        else
        {
            _S426 = _S423;
        }
        bool _S427 = quantity_2 == 0U;
        if(_S427)
        {
            float _S428 = __ldg(&(&(globalParams_0->families_0)[family_15])->area_unit_0);
            float _S429 = 16.0f * _S428;
            float _S430 = __ldg(&(&(globalParams_0->families_0)[family_15])->crossing_area_0);
            is_exposed_0 = _S426 > (_S429 * (F32_min((_S425 / _S430), (1.0f))) + 0.00000999999974738f * _S425);
        }
        float _S431 = _S424 * _S419.y;
        float _S432;
        if(is_exposed_0)
        {
            _S432 = _S426;
        }
        else
        {
            _S432 = 0.0f;
        }
        float _S433 = _S431 + _S432 + 0.000244140625f * _S419.z * _S421.y;
        if(_S427)
        {
            weight_4 = 1.0f / (F32_max((_S433), (9.99999968265522539e-21f)));
        }
        else
        {
            Albedos_0 _S434 = albedos_2;
            float _S435 = _S433 * weight_4;
            uint _S436 = __ldg(&(&(globalParams_0->families_0)[family_15])->colour_axes_0);
            uint _S437 = _S436 + 12U * (quantity_2 - 1U);
            Albedos_0 _S438 = _S434;
            Albedos_0 _S439 = with_added_albedos_0(&_S438, _S435, _S437);
            albedos_2 = _S439;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate_0((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate_0((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate_0((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate_0((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

__device__ Albedos_0 lerp_albedos_0(Albedos_0 * first_2, Albedos_0 * second_1, float weight_5)
{
    Albedos_0 albedos_3;
    float3  _S440 = make_float3 (weight_5);
    (&albedos_3)->diffuse_reflect_0 = lerp_0(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S440);
    (&albedos_3)->diffuse_transmit_0 = lerp_0(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S440);
    (&albedos_3)->specular_reflect_0 = lerp_0(first_2->specular_reflect_0, second_1->specular_reflect_0, _S440);
    (&albedos_3)->specular_transmit_0 = lerp_0(first_2->specular_transmit_0, second_1->specular_transmit_0, _S440);
    return albedos_3;
}

__device__ Albedos_0 tinted_0(Albedos_0 * albedos_4, float3  tint_0)
{
    Albedos_0 result_14 = *albedos_4;
    (&result_14)->diffuse_reflect_0 = (&result_14)->diffuse_reflect_0 * tint_0;
    (&result_14)->diffuse_transmit_0 = (&result_14)->diffuse_transmit_0 * tint_0;
    return result_14;
}

struct FaceRadiance_0
{
    float3  warp_3;
    float3  weft_3;
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
    float3  _S441 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S442 = sends_0->sky_warp_0 + _S441 * sends_0->crossing_warp_0;
    (&found_0)->warp_3 = _S442;
    float3  _S443 = sends_0->sky_weft_0 + _S441 * sends_0->crossing_weft_0;
    (&found_0)->weft_3 = _S443;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S442 + make_float3 (sends_0->blocks_weft_0) * _S443;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

__device__ void view_terms_0(float3  view_7, FixedArray<float, 6>  * terms_0)
{
    float _S444 = 1.0f - view_7.z;
    float _S445 = _S444 * _S444;
    (*terms_0)[int(0)] = 1.0f;
    float _S446 = view_7.x;
    float _S447 = _S446 * _S446;
    float _S448 = view_7.y;
    float _S449 = _S448 * _S448;
    (*terms_0)[int(1)] = (F32_sqrt(((F32_max((_S447 + _S449), (9.999999960041972e-13f))))));
    (*terms_0)[int(2)] = _S445;
    (*terms_0)[int(3)] = _S445 * _S445;
    (*terms_0)[int(4)] = _S447 - _S449;
    (*terms_0)[int(5)] = 0.0f;
    return;
}

struct Bounced_0
{
    float3  reflected_0;
    float3  transmitted_0;
};

struct Scattered_0
{
    float3  back_6;
    float3  through_0;
};

struct Interior_0
{
    float3  warp_4;
    float3  weft_4;
    float3  leaked_1;
    float3  far_1;
    float3  far_leaked_0;
};

__device__ Bounced_0 bounced_by_0(Blocked_0 * blocked_1, Scattered_0 * yarn_2, Interior_0 * interior_0)
{
    float3  _S450 = make_float3 (blocked_1->by_warp_0 + blocked_1->by_weft_0) * interior_0->leaked_1;
    float3  _S451 = make_float3 (blocked_1->far_0) * yarn_2->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_6 * (make_float3 (blocked_1->by_warp_0) * interior_0->warp_4 + make_float3 (blocked_1->by_weft_0) * interior_0->weft_4) + _S451 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S451 * interior_0->far_1 + yarn_2->back_6 * _S450;
    return bounced_0;
}

__device__ Bounced_0 sum_of_0(Bounced_0 * first_3, Bounced_0 * second_2)
{
    Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_3->reflected_0 + second_2->reflected_0;
    (&sum_1)->transmitted_0 = first_3->transmitted_0 + second_2->transmitted_0;
    return sum_1;
}

__device__ float3  bounced_value_0(Bounced_0 * bounced_1, float3  light_8, float3  view_8)
{
    float _S452 = light_8.z;
    float3  _S453;
    if((_S452 * view_8.z) < 0.0f)
    {
        _S453 = bounced_1->transmitted_0;
    }
    else
    {
        _S453 = bounced_1->reflected_0;
    }
    return _S453 * make_float3 ((F32_abs((_S452))) * 0.31830987334251404f);
}

__device__ float sheen_scale_0(float x_29, float y_14)
{
    return (((((0.0f * x_29 + (((((-1.1402510404586792f * y_14 + 0.40672621130943298f) * y_14 + 1.65398800373077393f) * y_14 + -1.29730904102325439f) * y_14 + 0.30570998787879944f) * y_14 + -0.0220868494361639f)) * x_29 + (((((-0.21142719686031342f * y_14 + 1.05947399139404297f) * y_14 + -0.41116121411323547f) * y_14 + -0.93859231472015381f) * y_14 + 0.51606941223144531f) * y_14 + 0.05409301072359085f)) * x_29 + (((((1.22944498062133789f * y_14 + -0.45962560176849365f) * y_14 + -1.63861405849456787f) * y_14 + 1.33565104007720947f) * y_14 + -0.45725581049919128f) * y_14 + 0.08243165910243988f)) * x_29 + (((((0.39779931306838989f * y_14 + -1.18879103660583496f) * y_14 + 0.28251591324806213f) * y_14 + 1.168984055519104f) * y_14 + -0.76864629983901978f) * y_14 + 0.0091691892594099f)) * x_29 + (((((-0.26563560962677002f * y_14 + -0.19379159808158875f) * y_14 + 0.2677634060382843f) * y_14 + 0.00270519289188087f) * y_14 + 0.14349560439586639f) * y_14 + 0.10290180146694183f)) * x_29 + (((((-0.20701569318771362f * y_14 + 0.24526430666446686f) * y_14 + 0.19551840424537659f) * y_14 + 0.07586126774549484f) * y_14 + 0.38894739747047424f) * y_14 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_30, float y_15)
{
    return ((((0.0f * x_30 + (((((-0.10608240216970444f * y_15 + 1.99214303493499756f) * y_15 + -1.42255294322967529f) * y_15 + -1.09495604038238525f) * y_15 + 0.59180057048797607f) * y_15 + 0.06902855634689331f)) * x_30 + (((((-0.46220690011978149f * y_15 + -0.29113379120826721f) * y_15 + 1.39025199413299561f) * y_15 + 0.35589990019798279f) * y_15 + -1.17120099067687988f) * y_15 + 0.15940259397029877f)) * x_30 + (((((2.26068711280822754f * y_15 + -3.64728999137878418f) * y_15 + -0.72173482179641724f) * y_15 + 3.07659196853637695f) * y_15 + -0.6827620267868042f) * y_15 + -0.3039557933807373f)) * x_30 + (((((0.81201767921447754f * y_15 + 0.36014080047607422f) * y_15 + -1.72646903991699219f) * y_15 + -0.22630110383033752f) * y_15 + 0.89514690637588501f) * y_15 + -0.10397960245609283f)) * x_30 + (((((-0.37648698687553406f * y_15 + 1.10974001884460449f) * y_15 + 0.17824520170688629f) * y_15 + -1.04968702793121338f) * y_15 + 0.1461234986782074f) * y_15 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_31, float y_16)
{
    return ((((0.0f * x_31 + (((((12.95646953582763672f * y_16 + -21.38032913208007812f) * y_16 + -7.37853097915649414f) * y_16 + 34.55607986450195312f) * y_16 + -23.61347007751464844f) * y_16 + 5.00126314163208008f)) * x_31 + (((((10.91487026214599609f * y_16 + -6.08202791213989258f) * y_16 + -38.2036285400390625f) * y_16 + 53.3440399169921875f) * y_16 + -21.91996002197265625f) * y_16 + 2.01606011390686035f)) * x_31 + (((((-14.52206039428710938f * y_16 + 36.803619384765625f) * y_16 + -22.94047927856445312f) * y_16 + -10.07973003387451172f) * y_16 + 15.77003955841064453f) * y_16 + -4.92722177505493164f)) * x_31 + (((((-7.62505722045898438f * y_16 + 1.27310299873352051f) * y_16 + 31.19523048400878906f) * y_16 + -44.39989852905273438f) * y_16 + 26.44947052001953125f) * y_16 + -8.73507976531982422f)) * x_31 + (((((5.65633487701416016f * y_16 + -17.66820907592773438f) * y_16 + 24.65356063842773438f) * y_16 + -19.38941001892089844f) * y_16 + 11.06159019470214844f) * y_16 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S454 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S455 = 2.0f * (F32_sqrt((_S454))) - 1.0f;
    float _S456 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_8, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S455, _S456), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S454) * sheen_shear_0(_S455, _S456), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S455, _S456), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_9, float3  view_9, float scale_0, float shear_0)
{
    float _S457 = light_9.z;
    bool _S458;
    if(_S457 <= 0.0f)
    {
        _S458 = true;
    }
    else
    {
        _S458 = (view_9.z) <= 0.0f;
    }
    if(_S458)
    {
        return 0.0f;
    }
    float2  _S459 = float2 {view_9.x, view_9.y};
    float _S460 = dot_1(_S459, _S459);
    float2  _S461;
    if(_S460 > 9.99999968265522539e-21f)
    {
        _S461 = _S459 * make_float2 ((F32_rsqrt((_S460))));
    }
    else
    {
        _S461 = make_float2 (1.0f, 0.0f);
    }
    float _S462 = scale_0 * dot_1(float2 {light_9.x, light_9.y}, _S461) + shear_0 * _S457;
    float _S463 = scale_0 * (light_9.y * _S461.x - light_9.x * _S461.y);
    float _S464 = _S462 * _S462 + _S463 * _S463 + _S457 * _S457;
    return 0.31830987334251404f * scale_0 * scale_0 * _S457 / (F32_max((_S464 * _S464), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_10, float3  view_10, float strength_0, float roughness_9)
{
    float3  _S465 = sheen_lobe_0(view_10.z, roughness_9);
    float _S466 = strength_0 * _S465.z;
    return make_float2 (_S466 * transformed_cosine_0(light_10, view_10, _S465.x, _S465.y), 1.0f - _S466);
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_5;
    Albedos_0 weft_5;
};

struct Estimate_0
{
    Components_0 components_0;
    CloseUp_0 close_0;
    FamilyAlbedos_0 albedos_5;
};

struct Regime_0
{
    float prefiltered_0;
    float threads_1;
    float points_1;
};

__device__ Regime_0 regime_of_0(uint _S467, Footprint_0 * _S468, float _S469)
{
    Fabric_0 * _S470 = (&(globalParams_0->fabrics_0)[_S467]);
    float _S471 = Footprint_spread_side_0(_S468);
    float _S472 = binary_logarithm_0((F32_max((_S471), (9.99999971718068537e-10f))));
    Lobes_0 _S473 = slang_ldg_1(&_S470->lobes_0);
    float _S474 = clamp_1((_S472 - _S473.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S475 = _S474 * _S474 * (3.0f - 2.0f * _S474);
    (&regime_0)->prefiltered_0 = _S475;
    (&regime_0)->threads_1 = _S471 * _S473.threads_per_mm_0;
    float _S476 = lerp_1((F32_max((8.0f / _S469), (1.0f))), 1.0f, _S475);
    float _S477;
    if(_S475 < 1.0f)
    {
        _S477 = clamp_1((&regime_0)->threads_1 * 12.0f, 1.0f, _S476);
    }
    else
    {
        _S477 = 0.0f;
    }
    (&regime_0)->points_1 = _S477;
    return regime_0;
}

__device__ bool varies_at_0(uint _S478, float _S479)
{
    Fabric_0 * _S480 = (&(globalParams_0->fabrics_0)[_S478]);
    float _S481 = __ldg(&_S480->fibre_noise_0);
    bool _S482;
    if(_S481 > 0.0f)
    {
        _S482 = true;
    }
    else
    {
        float _S483 = __ldg(&_S480->colour_noise_0);
        _S482 = _S483 > 0.0f;
    }
    if(_S482)
    {
        _S482 = true;
    }
    else
    {
        uint _S484 = __ldg(&_S480->has_detail_0);
        if(_S484 != 0U)
        {
            _S482 = _S479 >= 0.0f;
        }
        else
        {
            _S482 = false;
        }
    }
    return _S482;
}

struct Hit_0
{
    float x_32;
    float y_17;
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

__device__ Crossing_0 crossing_at_0(uint _S485, float _S486, float _S487, bool _S488)
{
    Fabric_0 * _S489 = (&(globalParams_0->fabrics_0)[_S485]);
    Crossing_0 crossing_3;
    uint _S490 = __ldg(&_S489->warp_0);
    (&crossing_3)->warp_2 = locate_0(_S490, _S486);
    uint _S491 = __ldg(&_S489->weft_0);
    (&crossing_3)->weft_2 = locate_0(_S491, _S487);
    uint _S492 = __ldg(&_S489->run_words_0);
    uint _S493 = (&(&crossing_3)->weft_2)->thread_0;
    uint _S494 = __ldg(&_S489->ends_1);
    uint _S495 = _S492 + 2U * (_S493 * _S494 + (&(&crossing_3)->warp_2)->thread_0);
    uint _S496 = __ldg((&(globalParams_0->words_0)[_S495]));
    (&crossing_3)->warp_word_0 = _S496;
    uint _S497 = __ldg((&(globalParams_0->words_0)[_S495 + 1U]));
    (&crossing_3)->weft_word_0 = _S497;
    (&crossing_3)->warp_above_0 = ((_S496 & 1U) == 1U) != _S488;
    return crossing_3;
}

__device__ Sample_0 sample_at_0(uint _S498, float _S499, float _S500, bool _S501)
{
    Fabric_0 * _S502 = (&(globalParams_0->fabrics_0)[_S498]);
    Sample_0 sample_0;
    Crossing_0 _S503 = crossing_at_0(_S498, _S499, _S500, _S501);
    (&sample_0)->crossing_2 = _S503;
    Crossing_0 _S504 = _S503;
    Shown_0 _S505 = shown_at_0(&_S504, _S501);
    (&sample_0)->shown_3 = _S505;
    uint _S506;
    if(_S505.is_warp_2)
    {
        uint _S507 = __ldg(&_S502->warp_0);
        _S506 = _S507;
    }
    else
    {
        uint _S508 = __ldg(&_S502->weft_0);
        _S506 = _S508;
    }
    uint _S509;
    if(_S505.is_warp_2)
    {
        uint _S510 = __ldg(&_S502->weft_0);
        _S509 = _S510;
    }
    else
    {
        uint _S511 = __ldg(&_S502->warp_0);
        _S509 = _S511;
    }
    Cell_0 _S512 = (&(&sample_0)->crossing_2)->warp_2;
    Cell_0 _S513 = (&(&sample_0)->crossing_2)->weft_2;
    Cell_0 _S514 = select_cell_0(_S505.is_warp_2, &_S512, &_S513);
    Cell_0 _S515 = (&(&sample_0)->crossing_2)->weft_2;
    Cell_0 _S516 = (&(&sample_0)->crossing_2)->warp_2;
    Cell_0 _S517 = select_cell_0(_S505.is_warp_2, &_S515, &_S516);
    Cell_0 _S518 = _S517;
    Run_0 _S519 = unpack_0(_S506, _S509, _S514.thread_0, &_S518, _S505.word_0);
    Cell_0 _S520 = _S514;
    Section_0 _S521 = section_at_0(&_S520);
    bool _S522;
    if(_S505.on_top_0)
    {
        _S522 = (_S519.distance_0) < (_S521.drop_0 * _S519.bend_1.sine_0);
    }
    else
    {
        _S522 = false;
    }
    bool _S523;
    if(_S505.on_top_0)
    {
        _S523 = !_S522;
    }
    else
    {
        _S523 = false;
    }
    float _S524;
    if(_S523)
    {
        _S524 = 1.0f;
    }
    else
    {
        _S524 = -1.0f;
    }
    float _S525;
    if(_S522)
    {
        _S525 = _S519.other_reach_0;
    }
    else
    {
        _S525 = _S519.reach_0;
    }
    float _S526;
    if(_S522)
    {
        _S526 = _S525 + _S519.distance_0;
    }
    else
    {
        _S526 = (F32_max((_S525 - _S519.distance_0), (0.0f)));
    }
    float _S527 = _S525 / _S519.bend_1.sine_0 - _S524 * _S521.drop_0;
    float _S528 = _S526 * _S526;
    float _S529 = (F32_max((_S527 * _S527 - _S528), (9.99999968265522539e-21f)));
    float _S530 = (F32_rsqrt((_S529)));
    float _S531 = _S528 / (_S529 * _S530 + _S527);
    bool _S532 = _S526 > 0.0f;
    float _S533;
    if(_S505.on_top_0)
    {
        _S533 = 1.0f;
    }
    else
    {
        _S533 = -1.0f;
    }
    float _S534;
    if(_S519.near_start_0)
    {
        _S534 = 1.0f;
    }
    else
    {
        _S534 = -1.0f;
    }
    float _S535 = _S533 * _S534;
    if(_S532)
    {
        _S533 = _S527 * _S530;
    }
    else
    {
        _S533 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S521.slope_0 * _S533;
    if(_S532)
    {
        _S526 = _S535 * _S526 * _S530;
    }
    else
    {
        _S526 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S526;
    float _S536 = __ldg(&(&(globalParams_0->families_0)[_S506])->height_scale_0);
    Shown_0 _S537 = _S505;
    Run_0 _S538 = _S519;
    Cell_0 _S539 = _S517;
    float2  _S540 = dive_0(_S509, &_S537, &_S538, &_S539);
    if(_S519.straight_0)
    {
        _S524 = 0.0f;
    }
    else
    {
        _S524 = _S536 * _S524;
    }
    (&sample_0)->height_7 = _S524 * (_S525 * _S519.bend_1.half_tangent_0 - _S531) - _S536 * _S521.drop_0 - _S540.x;
    float _S541 = _S536 * (&sample_0)->slope_across_0;
    float _S542 = _S536 * (&sample_0)->slope_along_0 - _S540.y;
    if(_S505.is_warp_2)
    {
        _S524 = _S541;
    }
    else
    {
        _S524 = _S542;
    }
    (&sample_0)->slope_x_1 = _S524;
    if(_S505.is_warp_2)
    {
        _S524 = _S542;
    }
    else
    {
        _S524 = _S541;
    }
    (&sample_0)->slope_y_1 = _S524;
    (&sample_0)->run_3 = _S519;
    (&sample_0)->section_1 = _S521;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S543, SearchQuality_0 * _S544, float3  _S545)
{
    Fabric_0 * _S546 = (&(globalParams_0->fabrics_0)[_S543]);
    float _S547 = (F32_abs((_S545.x)));
    float _S548 = __ldg(&_S546->threads_per_x_0);
    float _S549 = _S547 * _S548;
    float _S550 = (F32_abs((_S545.y)));
    float _S551 = __ldg(&_S546->threads_per_y_0);
    float _S552 = (F32_max((_S549), (_S550 * _S551))) * _S544->steps_per_thread_0;
    float _S553 = (F32_abs((_S545.z)));
    float _S554 = __ldg(&_S546->per_relief_0);
    return (F32_max((_S552), (_S553 * _S554 * _S544->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S555, Crossing_0 * _S556)
{
    Fabric_0 * _S557 = (&(globalParams_0->fabrics_0)[_S555]);
    bool _S558 = _S556->warp_above_0;
    uint _S559;
    if(_S556->warp_above_0)
    {
        uint _S560 = __ldg(&_S557->warp_0);
        _S559 = _S560;
    }
    else
    {
        uint _S561 = __ldg(&_S557->weft_0);
        _S559 = _S561;
    }
    uint _S562;
    if(_S558)
    {
        _S562 = _S556->warp_word_0;
    }
    else
    {
        _S562 = _S556->weft_word_0;
    }
    float _S563 = float(_S562 >> int(28));
    float _S564 = __ldg(&(&(globalParams_0->families_0)[_S559])->height_scale_0);
    float _S565 = _S563 * _S564;
    float _S566 = __ldg(&(&(globalParams_0->families_0)[_S559])->level_0);
    return _S565 * _S566;
}

__device__ Probe_0 probe_0(uint _S567, float _S568, float _S569, bool _S570, bool _S571, bool _S572)
{
    Sample_0 _S573 = sample_at_0(_S567, _S568, _S569, _S570);
    Probe_0 probe_1;
    (&probe_1)->height_4 = _S573.height_7;
    (&probe_1)->hole_4 = _S573.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S573.slope_x_1;
    (&probe_1)->slope_y_0 = _S573.slope_y_1;
    uint _S574;
    if(_S573.shown_3.is_warp_2)
    {
        _S574 = _S573.crossing_2.warp_2.thread_0 * 2U + 1U;
    }
    else
    {
        _S574 = _S573.crossing_2.weft_2.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S574;
    Crossing_0 _S575 = _S573.crossing_2;
    float _S576 = cell_maximum_0(_S567, &_S575);
    (&probe_1)->cell_max_0 = _S576;
    float _S577;
    if(_S571)
    {
        _S577 = _S573.crossing_2.warp_2.above_0;
    }
    else
    {
        _S577 = _S573.crossing_2.warp_2.below_0;
    }
    (&probe_1)->side_x_0 = _S577;
    if(_S572)
    {
        _S577 = _S573.crossing_2.weft_2.above_0;
    }
    else
    {
        _S577 = _S573.crossing_2.weft_2.below_0;
    }
    (&probe_1)->side_y_0 = _S577;
    bool _S578 = !_S573.shown_3.is_warp_2;
    Cell_0 _S579 = _S573.crossing_2.warp_2;
    Shown_0 _S580 = _S573.shown_3;
    Run_0 _S581 = _S573.run_3;
    float _S582 = outline_distance_0(&_S579, &_S580, &_S581, _S578, _S571);
    (&probe_1)->edge_x_0 = _S582;
    Cell_0 _S583 = _S573.crossing_2.weft_2;
    Shown_0 _S584 = _S573.shown_3;
    Run_0 _S585 = _S573.run_3;
    float _S586 = outline_distance_0(&_S583, &_S584, &_S585, _S573.shown_3.is_warp_2, _S572);
    (&probe_1)->edge_y_0 = _S586;
    return probe_1;
}

__device__ bool is_free_0(uint _S587, SearchQuality_0 * _S588, float3  _S589, float3  _S590, bool _S591, float _S592)
{
    float _S593 = _S590.z;
    if(_S593 <= 0.0f)
    {
        return false;
    }
    float _S594 = _S588->shadow_share_0;
    float _S595 = steps_per_length_0(_S587, _S588, _S590);
    float _S596 = 1.0f / (F32_max((_S594 * _S595), (9.99999971718068537e-10f)));
    StepControl_0 _S597 = step_control_0(float2 {_S590.x, _S590.y}, _S596);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S598;
        if(count_3 < 1024U)
        {
            _S598 = (_S589.z + _S593 * distance_1) < _S592;
        }
        else
        {
            _S598 = false;
        }
        if(_S598)
        {
        }
        else
        {
            break;
        }
        float3  _S599 = _S589 + _S590 * make_float3 (distance_1);
        Probe_0 _S600 = probe_0(_S587, _S599.x, _S599.y, _S591, _S597.right_1, _S597.up_0);
        float _S601 = _S599.z;
        float _S602 = _S601 - _S600.height_4;
        float _S603 = _S593 - _S600.slope_x_0 * _S590.x - _S600.slope_y_0 * _S590.y;
        bool _S604;
        if(!_S600.hole_4)
        {
            _S604 = _S602 < 0.0f;
        }
        else
        {
            _S604 = false;
        }
        if(_S604)
        {
            return false;
        }
        PreviousSample_0 _S605 = previous_3;
        Probe_0 _S606 = _S600;
        float _S607 = way_back_to_dip_0(&_S605, _S602, _S603, last_step_0, &_S606);
        if(_S607 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S607;
            distance_1 = distance_1 - _S607;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S608 = _S601 > (_S600.cell_max_0);
        Probe_0 _S609 = _S600;
        PreviousSample_0 _S610 = after_sample_0(_S602, _S603, &_S609, _S608);
        float last_step_2;
        if(_S608)
        {
            StepControl_0 _S611 = _S597;
            float _S612 = StepControl_to_cell_exit_0(&_S611, _S600.side_x_0, _S600.side_y_0);
            last_step_2 = (F32_max((_S612), (_S596)));
        }
        else
        {
            StepControl_0 _S613 = _S597;
            Probe_0 _S614 = _S600;
            float _S615 = StepControl_to_next_sample_0(&_S613, &_S614, _S602, _S603);
            last_step_2 = _S615;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S610;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S616, SearchQuality_0 * _S617, float _S618, float _S619, float3  _S620, bool _S621)
{
    Fabric_0 * _S622 = (&(globalParams_0->fabrics_0)[_S616]);
    Sample_0 _S623 = sample_at_0(_S616, _S618, _S619, _S621);
    if(!_S623.shown_3.hole_3)
    {
        return false;
    }
    float3  _S624 = make_float3 (_S618, _S619, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S625;
        if(side_0 < 2U)
        {
            _S625 = passes_0;
        }
        else
        {
            _S625 = false;
        }
        if(_S625)
        {
        }
        else
        {
            break;
        }
        float3  _S626;
        if(side_0 == 0U)
        {
            _S626 = _S620;
        }
        else
        {
            _S626 = make_float3 (- _S620.x, - _S620.y, _S620.z);
        }
        bool _S627 = _S621 != (side_0 == 1U);
        float _S628 = __ldg(&_S622->height_high_0);
        bool _S629 = is_free_0(_S616, _S617, _S624, _S626, _S627, _S628);
        uint _S630 = side_0 + 1U;
        passes_0 = _S629;
        side_0 = _S630;
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

__device__ float max_height_along_0(uint _S631, float _S632, float _S633, float _S634, float3  _S635, bool _S636)
{
    Fabric_0 * _S637 = (&(globalParams_0->fabrics_0)[_S631]);
    uint _S638 = __ldg(&_S637->warp_0);
    uint _S639 = locate_0(_S638, _S632).thread_0 / 2U;
    uint _S640 = __ldg(&_S637->weft_0);
    uint _S641 = locate_0(_S640, _S633).thread_0 / 2U;
    float _S642 = _S635.x;
    uint _S643;
    if(_S642 > 0.0f)
    {
        _S643 = 1U;
    }
    else
    {
        _S643 = 0U;
    }
    float _S644 = _S635.y;
    uint _S645;
    if(_S644 > 0.0f)
    {
        _S645 = 2U;
    }
    else
    {
        _S645 = 0U;
    }
    uint _S646 = _S643 + _S645;
    uint _S647 = __ldg(&_S637->max_heights_0);
    uint _S648 = __ldg(&_S637->max_height_columns_0);
    uint _S649 = __ldg((&(globalParams_0->words_0)[_S647 + 4U * (_S641 * _S648 + _S639) + _S646]));
    int number_0;
    if(_S636)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S650 = _S649 >> number_0;
    float _S651 = (F32_abs((_S642)));
    float _S652 = __ldg(&_S637->threads_per_x_0);
    float _S653 = _S651 * _S652;
    float _S654 = (F32_abs((_S644)));
    float _S655 = __ldg(&_S637->threads_per_y_0);
    float _S656 = (F32_max((_S653), (_S654 * _S655))) / _S635.z;
    float _S657 = __ldg(&_S637->height_high_0);
    float max_height_0 = _S657;
    number_0 = int(3);
    for(;;)
    {
        if(number_0 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S634) * _S656) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S650 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S657)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S658, float _S659, float _S660, bool _S661, bool _S662, bool _S663)
{
    Crossing_0 _S664 = crossing_at_0(_S658, _S659, _S660, _S661);
    Crossing_0 _S665 = _S664;
    float _S666 = cell_maximum_0(_S658, &_S665);
    float _S667;
    if(_S662)
    {
        _S667 = _S664.warp_2.above_0;
    }
    else
    {
        _S667 = _S664.warp_2.below_0;
    }
    float _S668;
    if(_S663)
    {
        _S668 = _S664.weft_2.above_0;
    }
    else
    {
        _S668 = _S664.weft_2.below_0;
    }
    return make_float3 (_S666, _S667, _S668);
}

__device__ float first_sample_height_0(uint _S669, ViewRay_0 * _S670, StepControl_0 * _S671, bool _S672)
{
    float _S673 = max_height_along_0(_S669, _S670->origin_0.x, _S670->origin_0.y, 0.0f, make_float3 (_S670->slope_1.x, _S670->slope_1.y, 1.0f), _S672);
    uint count_4 = 0U;
    float height_9 = _S673;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S674 = ViewRay_at_0(_S670, height_9);
        float3  _S675 = cell_bounds_0(_S669, _S674.x, _S674.y, _S672, _S671->right_1, _S671->up_0);
        float _S676 = height_9 - _S675.x;
        float _S677 = StepControl_to_cell_exit_0(_S671, _S675.y, _S675.z);
        float height_10 = height_9 - clamp_1(_S676, 0.0f, _S677);
        if(_S676 <= _S677)
        {
            height_9 = height_10;
            break;
        }
        count_4 = count_4 + 1U;
        height_9 = height_10;
    }
    return height_9;
}

__device__ ViewRayEnd_0 search_down_0(uint _S678, ViewRay_0 * _S679, StepControl_0 * _S680, bool _S681)
{
    Fabric_0 * _S682 = (&(globalParams_0->fabrics_0)[_S678]);
    float _S683 = __ldg(&_S682->height_low_0);
    float _S684 = __ldg(&_S682->height_high_0);
    float _S685 = _S683 - (_S684 - _S683);
    ViewRayEnd_0 end_1;
    float _S686 = first_sample_height_0(_S678, _S679, _S680, _S681);
    (&end_1)->height_8 = _S686;
    (&end_1)->last_step_3 = _S680->epsilon_0;
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
        float2  _S687 = ViewRay_at_0(_S679, (&end_1)->height_8);
        Probe_0 _S688 = probe_0(_S678, _S687.x, _S687.y, _S681, _S680->right_1, _S680->up_0);
        float _S689 = (&end_1)->height_8 - _S688.height_4;
        Probe_0 _S690 = _S688;
        float _S691 = ViewRay_rate_0(_S679, &_S690);
        (&end_1)->depth_1 = - _S689;
        (&end_1)->rate_4 = _S691;
        bool _S692;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S692 = !_S688.hole_4;
        }
        else
        {
            _S692 = false;
        }
        bool _S693;
        if(_S692)
        {
            _S693 = ((&(&end_1)->previous_4)->yarn_0) == (_S688.yarn_1);
        }
        else
        {
            _S693 = false;
        }
        (&end_1)->smooth_0 = _S693;
        bool _S694;
        if(!_S688.hole_4)
        {
            _S694 = _S689 <= 0.0f;
        }
        else
        {
            _S694 = false;
        }
        bool _S695;
        if(_S694)
        {
            _S695 = true;
        }
        else
        {
            _S695 = ((&end_1)->height_8) <= _S685;
        }
        if(_S695)
        {
            break;
        }
        PreviousSample_0 _S696 = (&end_1)->previous_4;
        Probe_0 _S697 = _S688;
        float _S698 = way_back_to_dip_0(&_S696, _S689, _S691, (&end_1)->last_step_3, &_S697);
        if(_S698 >= 0.0f)
        {
            (&end_1)->height_8 = (&end_1)->height_8 + _S698;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S698;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S699 = StepControl_to_cell_exit_0(_S680, _S688.side_x_0, _S688.side_y_0);
        float _S700 = (F32_min((_S699), ((&end_1)->height_8 - _S688.cell_max_0)));
        Probe_0 _S701 = _S688;
        float _S702 = StepControl_to_next_sample_0(_S680, &_S701, _S689, _S691);
        bool _S703 = _S700 > _S702;
        Probe_0 _S704 = _S688;
        PreviousSample_0 _S705 = after_sample_0(_S689, _S691, &_S704, _S703);
        (&end_1)->previous_4 = _S705;
        float _S706 = (F32_max((_S700), (_S702)));
        (&end_1)->last_step_3 = _S706;
        (&end_1)->height_8 = (&end_1)->height_8 - _S706;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S707, ViewRay_0 * _S708, StepControl_0 * _S709, bool _S710, ViewRayEnd_0 * _S711, uint _S712)
{
    Fabric_0 * _S713 = (&(globalParams_0->fabrics_0)[_S707]);
    float _S714 = __ldg(&_S713->height_high_0);
    float _S715 = __ldg(&_S713->height_low_0);
    float _S716 = _S714 - _S715;
    float _S717 = _S711->height_8;
    float _S718 = _S711->last_step_3;
    float above_2 = _S711->height_8 + _S711->last_step_3;
    float above_gap_1 = clamp_1((&_S711->previous_4)->clearance_0, 0.0f, _S716);
    float under_gap_1 = clamp_1(_S711->depth_1, 0.0f, _S716);
    float _S719 = cubic_root_0(above_gap_1, - under_gap_1, (&_S711->previous_4)->rate_0 * _S711->last_step_3, _S711->rate_4 * _S711->last_step_3);
    bool _S720 = _S711->smooth_0;
    float middle_0;
    if(_S711->smooth_0)
    {
        middle_0 = above_2 - _S719 * _S718;
    }
    else
    {
        middle_0 = between_0(above_2, _S717, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S717;
    float above_3 = above_2;
    uint i_10 = 0U;
    for(;;)
    {
        if(i_10 < _S712)
        {
        }
        else
        {
            break;
        }
        float2  _S721 = ViewRay_at_0(_S708, middle_0);
        Probe_0 _S722 = probe_0(_S707, _S721.x, _S721.y, _S710, _S709->right_1, _S709->up_0);
        float _S723;
        if(_S722.hole_4)
        {
            _S723 = -1.0e+09f;
        }
        else
        {
            _S723 = _S722.height_4;
        }
        float _S724 = clamp_1(middle_0 - _S723, - _S716, _S716);
        float _S725;
        if(_S724 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S725 = 0.5f * above_gap_2;
            }
            else
            {
                _S725 = above_gap_2;
            }
            float _S726 = - _S724;
            under_1 = middle_0;
            above_gap_2 = _S725;
            under_gap_2 = _S726;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S725 = 0.5f * under_gap_2;
            }
            else
            {
                _S725 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S724;
            under_gap_2 = _S725;
            side_1 = -1.0f;
        }
        if(_S720)
        {
            Probe_0 _S727 = _S722;
            float _S728 = ViewRay_rate_0(_S708, &_S727);
            middle_0 = clamp_1(middle_0 + _S724 / (F32_min((_S728), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_10 = i_10 + 1U;
    }
    if(_S720)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S729, SearchQuality_0 * _S730, float _S731, float _S732, float3  _S733, bool _S734)
{
    float _S735 = (F32_max((_S733.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S731, _S732);
    float2  _S736 = float2 {_S733.x, _S733.y} / make_float2 (_S735);
    (&ray_0)->slope_1 = _S736;
    float2  _S737 = - _S736;
    float _S738 = steps_per_length_0(_S729, _S730, _S733);
    StepControl_0 _S739 = step_control_0(_S737, 1.0f / (F32_max((_S738 / _S735), (9.99999971718068537e-10f))));
    ViewRay_0 _S740 = ray_0;
    StepControl_0 _S741 = _S739;
    ViewRayEnd_0 _S742 = search_down_0(_S729, &_S740, &_S741, _S734);
    Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    ViewRay_0 _S743 = ray_0;
    StepControl_0 _S744 = _S739;
    ViewRayEnd_0 _S745 = _S742;
    float _S746 = refined_height_0(_S729, &_S743, &_S744, _S734, &_S745, _S730->refinements_0);
    (&hit_0)->height_6 = _S746;
    ViewRay_0 _S747 = ray_0;
    float2  _S748 = ViewRay_at_0(&_S747, _S746);
    (&hit_0)->x_32 = _S748.x;
    (&hit_0)->y_17 = _S748.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S749, SearchQuality_0 * _S750, float _S751, float _S752, float3  _S753, bool _S754)
{
    bool _S755 = passes_through_0(_S749, _S750, _S751, _S752, _S753, _S754);
    if(!_S755)
    {
        Hit_0 _S756 = first_hit_of_yarn_0(_S749, _S750, _S751, _S752, _S753, _S754);
        return _S756;
    }
    Hit_0 hit_1;
    (&hit_1)->x_32 = _S751;
    (&hit_1)->y_17 = _S752;
    (&hit_1)->height_6 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S757, float _S758, float _S759, bool _S760)
{
    Fabric_0 * _S761 = (&(globalParams_0->fabrics_0)[_S757]);
    Sample_0 _S762 = sample_at_0(_S757, _S758, _S759, _S760);
    float _S763;
    if(_S762.shown_3.is_warp_2)
    {
        _S763 = _S762.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S763 = _S762.crossing_2.weft_2.half_width_1;
    }
    uint _S764;
    if(_S762.shown_3.is_warp_2)
    {
        uint _S765 = __ldg(&_S761->warp_0);
        _S764 = _S765;
    }
    else
    {
        uint _S766 = __ldg(&_S761->weft_0);
        _S764 = _S766;
    }
    float _S767 = __ldg(&(&(globalParams_0->families_0)[_S764])->twist_sine_0);
    float _S768;
    if(_S760)
    {
        _S768 = -1.0f;
    }
    else
    {
        _S768 = 1.0f;
    }
    float _S769 = _S767 * _S768;
    float _S770 = __ldg(&(&(globalParams_0->families_0)[_S764])->twist_cosine_0);
    if(_S762.shown_3.is_warp_2)
    {
        _S768 = 1.0f;
    }
    else
    {
        _S768 = -1.0f;
    }
    float2  _S771 = fibre_direction_0(_S762.slope_across_0, _S768 * _S762.slope_along_0, _S769, _S770);
    float _S772;
    if(_S762.shown_3.is_warp_2)
    {
        _S772 = _S762.slope_x_1;
    }
    else
    {
        _S772 = _S762.slope_y_1;
    }
    float _S773;
    if(_S762.shown_3.is_warp_2)
    {
        _S773 = _S762.slope_y_1;
    }
    else
    {
        _S773 = _S762.slope_x_1;
    }
    float _S774 = _S771.x;
    float _S775 = _S771.y;
    float _S776 = _S772 * _S774 + _S768 * _S773 * _S775;
    float _S777 = _S763 * 1.0154266357421875f;
    float _S778 = _S777 * arc_sine_0(clamp_1(_S762.section_1.across_3 / _S777, -1.0f, 1.0f));
    if(_S762.shown_3.is_warp_2)
    {
        _S763 = _S759;
    }
    else
    {
        _S763 = - _S758;
    }
    SurfacePoint_0 point_1;
    (&point_1)->hole_0 = _S762.shown_3.hole_3;
    (&point_1)->is_warp_0 = _S762.shown_3.is_warp_2;
    (&point_1)->warp_thread_0 = _S762.crossing_2.warp_2.thread_0;
    (&point_1)->weft_thread_0 = _S762.crossing_2.weft_2.thread_0;
    (&point_1)->height_2 = _S762.height_7;
    (&point_1)->normal_0 = normalize_0(make_float3 (- _S762.slope_x_1, - _S762.slope_y_1, 1.0f));
    float3  _S779;
    if(_S762.shown_3.is_warp_2)
    {
        _S779 = make_float3 (_S774, _S775, _S776);
    }
    else
    {
        _S779 = make_float3 (- _S775, _S774, _S776);
    }
    (&point_1)->tangent_0 = normalize_0(_S779);
    (&point_1)->across_0 = _S762.section_1.across_3;
    (&point_1)->fibre_across_0 = _S778 * _S770 + _S763 * _S769;
    (&point_1)->fibre_along_0 = _S763 * _S770 - _S778 * _S769;
    return point_1;
}

struct YarnPoint_0
{
    bool back_7;
    bool hole_6;
    bool is_warp_3;
    float x_33;
    float y_18;
    float height_11;
    float3  normal_9;
    float3  tangent_10;
    float3  surface_normal_0;
    float diffuse_gain_1;
    float roughness_10;
    Albedos_0 albedos_6;
};

__device__ bool has_hairs_0(uint _S780)
{
    Fabric_0 * _S781 = (&(globalParams_0->fabrics_0)[_S780]);
    uint _S782 = __ldg(&_S781->warp_0);
    float _S783 = __ldg(&(&(globalParams_0->families_0)[_S782])->hairiness_0);
    bool _S784;
    if(_S783 > 0.0f)
    {
        _S784 = true;
    }
    else
    {
        uint _S785 = __ldg(&_S781->weft_0);
        float _S786 = __ldg(&(&(globalParams_0->families_0)[_S785])->hairiness_0);
        _S784 = _S786 > 0.0f;
    }
    return _S784;
}

__device__ Hair_0 hair_at_0(uint _S787, float2  _S788, bool _S789, float _S790)
{
    Fabric_0 * _S791 = (&(globalParams_0->fabrics_0)[_S787]);
    float _S792 = __ldg(&_S791->fibre_size_0);
    float _S793 = 17.0f * _S792;
    float _S794 = fade_0(_S790, _S793);
    float2  _S795 = _S788 / make_float2 (_S793);
    uint number_1;
    if(_S789)
    {
        number_1 = 1U;
    }
    else
    {
        number_1 = 0U;
    }
    uint _S796 = __ldg(&_S791->seed_0);
    uint _S797 = hash_key_0(number_1, _S796 ^ 1013904242U);
    float _S798 = 1.0f / (F32_max((_S790), (0.07999999821186066f * _S792)));
    float _S799 = (F32_min((0.63999998569488525f * _S792 * _S798), (1.0f)));
    float2  _S800 = make_float2 (0.0f, 1.0f);
    float cover_2 = 0.0f;
    float hair_away_0 = 0.0f;
    float2  hair_across_0 = _S800;
    number_1 = 0U;
    for(;;)
    {
        bool _S801;
        if(_S794 > 0.0f)
        {
            _S801 = number_1 < 18U;
        }
        else
        {
            _S801 = false;
        }
        if(_S801)
        {
        }
        else
        {
            break;
        }
        uint _S802 = number_1 / 9U;
        uint _S803 = number_1 / 3U - 3U * _S802;
        float2  _S804 = floor_0(_S795) + make_float2 (float(number_1 - 3U * _S803 - 9U * _S802), float(_S803)) - make_float2 (1.0f);
        uint _S805 = hash_bits_0(_S797 + _S802, uint(int(_S804.x)) * 65536U + uint(int(_S804.y)));
        uint _S806 = hash_bits_0(_S797, _S805);
        float2  _S807 = _S795 - _S804 - make_float2 (share_of_0(_S805), share_of_0(_S805 >> int(10)));
        float2  _S808 = sine_cosine_0(3.14159274101257324f * share_of_0(_S805 >> int(20)));
        float _S809 = lerp_1(5.0f, 16.0f, share_of_0(_S806 >> int(10))) / 17.0f;
        float _S810 = _S807.x;
        float _S811 = _S808.y;
        float _S812 = _S807.y;
        float _S813 = _S808.x;
        float _S814 = (_S810 * _S811 + _S812 * _S813) / _S809;
        float _S815 = 0.69999998807907104f * (2.0f * share_of_0(_S806 >> int(20)) - 1.0f);
        float _S816 = 2.0f * _S815 * _S814;
        float _S817 = (F32_rsqrt((_S816 * _S816 + 1.0f)));
        float _S818 = (_S812 * _S811 - _S810 * _S813 - _S815 * _S809 * _S814 * _S814) * _S817 * 17.0f;
        float _S819 = clamp_1((0.31999999284744263f - (F32_abs((_S818)))) * _S792 * _S798 + 0.5f, 0.0f, _S799);
        uint _S820;
        if(((_S806 >> int(30)) & 1U) == 1U)
        {
            uint _S821 = __ldg(&_S791->warp_0);
            _S820 = _S821;
        }
        else
        {
            uint _S822 = __ldg(&_S791->weft_0);
            _S820 = _S822;
        }
        float _S823 = share_of_0(_S806);
        float _S824 = __ldg(&(&(globalParams_0->families_0)[_S820])->hairiness_0);
        bool _S825;
        if(_S823 < _S824)
        {
            _S825 = (F32_abs((_S814))) < 1.0f;
        }
        else
        {
            _S825 = false;
        }
        bool _S826;
        if(_S825)
        {
            _S826 = _S819 > cover_2;
        }
        else
        {
            _S826 = false;
        }
        if(_S826)
        {
            float2  _S827 = make_float2 (- _S813 - _S816 * _S811, _S811 - _S816 * _S813) * make_float2 (_S817);
            cover_2 = _S819;
            hair_away_0 = _S818;
            hair_across_0 = _S827;
        }
        number_1 = number_1 + 1U;
    }
    float _S828 = clamp_1(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    Hair_0 hair_1;
    (&hair_1)->cover_0 = _S794 * cover_2;
    (&hair_1)->normal_2 = make_float3 ((make_float2 (_S828) * hair_across_0).x, (make_float2 (_S828) * hair_across_0).y, (F32_sqrt((1.0f - _S828 * _S828))));
    (&hair_1)->tangent_2 = make_float3 (hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

__device__ uint thread_number_0(uint _S829, SurfacePoint_0 * _S830, float _S831, float _S832)
{
    Fabric_0 * _S833 = (&(globalParams_0->fabrics_0)[_S829]);
    bool _S834 = _S830->is_warp_0;
    float _S835;
    if(_S830->is_warp_0)
    {
        _S835 = _S831;
    }
    else
    {
        _S835 = _S832;
    }
    float _S836 = _S835 - _S830->across_0;
    uint _S837;
    if(_S834)
    {
        uint _S838 = __ldg(&_S833->warp_0);
        _S837 = _S838;
    }
    else
    {
        uint _S839 = __ldg(&_S833->weft_0);
        _S837 = _S839;
    }
    float _S840 = __ldg(&(&(globalParams_0->families_0)[_S837])->period_0);
    float _S841 = __ldg(&(&(globalParams_0->families_0)[_S837])->count_0);
    int _S842 = int(_S841);
    if(_S834)
    {
        _S837 = _S830->warp_thread_0;
    }
    else
    {
        _S837 = _S830->weft_thread_0;
    }
    uint _S843 = uint(int((F32_floor((_S836 / _S840)))) * _S842 + int(_S837)) * 2U;
    if(_S834)
    {
        _S837 = 1U;
    }
    else
    {
        _S837 = 0U;
    }
    return _S843 + _S837;
}

struct FibreNoise_0
{
    float2  bundle_0;
    float bundle_weight_0;
    float2  fibre_0;
    float fibre_weight_0;
    float offset_2;
    float slope_2;
};

__device__ FibreNoise_0 fibre_noise_at_0(uint _S844, uint _S845, SurfacePoint_0 * _S846, uint _S847, float _S848)
{
    Fabric_0 * _S849 = (&(globalParams_0->fabrics_0)[_S844]);
    float _S850 = __ldg(&_S849->fibre_size_0);
    float _S851 = 5.0f * _S850;
    uint _S852 = __ldg(&_S849->seed_0);
    float _S853 = _S846->fibre_along_0;
    float2  _S854 = wave_noise_0(hash_key_0(_S847, _S852 ^ 458671337U), _S846->fibre_along_0 / (25.0f * _S850));
    float _S855 = _S846->fibre_across_0;
    float _S856 = __ldg(&(&(globalParams_0->families_0)[_S845])->fibre_tilt_0);
    float _S857 = _S855 + _S856 * 0.5f * 25.0f * _S850 * _S854.x;
    float3  _S858 = fibre_cell_0(_S857, _S853, _S850);
    FibreNoise_0 noise_0;
    (&noise_0)->bundle_0 = cell_noise_0(hash_key_0(_S847, _S852 ^ 1757159915U), fibre_cell_0(_S857, _S853, _S851));
    (&noise_0)->bundle_weight_0 = fade_0(_S848, _S851);
    (&noise_0)->fibre_0 = cell_noise_0(hash_key_0(_S847, _S852 ^ 48610963U), _S858);
    (&noise_0)->fibre_weight_0 = fade_0(_S848, _S850);
    (&noise_0)->offset_2 = _S858.z;
    (&noise_0)->slope_2 = 0.5f * _S854.y;
    return noise_0;
}

__device__ float2  detail_gain_0(uint _S859, uint _S860, SurfacePoint_0 * _S861, float2  _S862, bool _S863, uint _S864, float _S865)
{
    Fabric_0 * _S866 = (&(globalParams_0->fabrics_0)[_S859]);
    float2  _S867 = make_float2 (0.0f);
    float _S868 = __ldg(&(&(globalParams_0->families_0)[_S860])->has_plies_0);
    float2  gain_2;
    if(_S868 > 0.0f)
    {
        float _S869 = __ldg(&(&(globalParams_0->families_0)[_S860])->plies_per_mm_0);
        float _S870 = 0.60000002384185791f * fade_0(_S865, 1.0f / _S869);
        float _S871 = ply_offset_0(_S860, _S861, _S863);
        gain_2 = make_float2 (_S870) * make_float2 (0.20000000298023224f - square_0(square_0(_S871)), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S867;
    }
    float _S872 = __ldg(&(&(globalParams_0->families_0)[_S860])->fibre_tone_0);
    if(_S872 > 0.0f)
    {
        FibreNoise_0 _S873 = fibre_noise_at_0(_S859, _S860, _S861, _S864, _S865);
        float _S874 = __ldg(&(&(globalParams_0->families_0)[_S860])->fibre_tone_0);
        gain_2 = gain_2 + make_float2 (_S874) * make_float2 (_S873.bundle_weight_0 * _S873.bundle_0.y + _S873.fibre_weight_0 * _S873.fibre_0.y, _S873.bundle_weight_0 + _S873.fibre_weight_0);
    }
    float _S875 = __ldg(&(&(globalParams_0->families_0)[_S860])->slub_0);
    if(_S875 > 0.0f)
    {
        float _S876 = __ldg(&(&(globalParams_0->families_0)[_S860])->slub_0);
        float _S877 = 0.25f * _S876;
        float _S878 = __ldg(&(&(globalParams_0->families_0)[_S860])->slubs_per_mm_0);
        float _S879 = _S877 * fade_0(_S865, 1.0f / _S878);
        float _S880;
        if(_S861->is_warp_0)
        {
            _S880 = _S862.y;
        }
        else
        {
            _S880 = - _S862.x;
        }
        uint _S881 = __ldg(&_S866->seed_0);
        uint _S882 = hash_key_0(_S864, _S881 ^ 1373058189U);
        float _S883 = __ldg(&(&(globalParams_0->families_0)[_S860])->slubs_per_mm_0);
        float2  _S884 = wave_noise_0(_S882, _S880 * _S883);
        float _S885 = _S861->across_0;
        float _S886 = __ldg(&(&(globalParams_0->families_0)[_S860])->per_half_width_0);
        gain_2 = gain_2 + make_float2 (_S879) * make_float2 (_S884.x * lerp_1(0.40000000596046448f, 1.0f, (F32_min((square_0(_S885 * _S886)), (1.0f)))), 1.0f);
    }
    return gain_2;
}

__device__ Albedos_0 vary_albedos_0(uint _S887, Albedos_0 * _S888, uint _S889, uint _S890, float2  _S891)
{
    Fabric_0 * _S892 = (&(globalParams_0->fabrics_0)[_S887]);
    float3  _S893 = _S888->specular_reflect_0;
    float3  _S894 = _S888->specular_transmit_0;
    float3  _S895 = max_0(_S888->specular_reflect_0, _S888->specular_transmit_0);
    float3  _S896 = _S888->diffuse_reflect_0;
    float3  _S897 = _S888->diffuse_transmit_0;
    float3  _S898 = _S888->diffuse_reflect_0 + _S888->diffuse_transmit_0;
    float _S899 = __ldg(&_S892->layer_bound_0);
    float3  _S900 = make_float3 (1.0f) - make_float3 (_S899) * _S895;
    float _S901 = __ldg(&_S892->colour_noise_0);
    uint _S902 = __ldg(&_S892->seed_0);
    float colour_0 = bounded_gain_0(thread_gain_0(_S889, _S901, _S902), _S898, _S900);
    float colour_1 = colour_0 * (1.0f + flattened_0(_S891.y, make_float3 (colour_0) * _S898, _S900) * _S891.x);
    float3  _S903 = min_0((make_float3 (1.0f) - make_float3 (colour_1) * _S898) / make_float3 (_S899), make_float3 (1.0f));
    float _S904 = __ldg(&_S892->fibre_noise_0);
    float _S905 = bounded_gain_0(fibre_gain_0(_S889, _S890, _S904, _S902), _S895, _S903);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (colour_1) * _S896;
    (&varied_0)->diffuse_transmit_0 = make_float3 (colour_1) * _S897;
    (&varied_0)->specular_reflect_0 = make_float3 (_S905) * _S893;
    (&varied_0)->specular_transmit_0 = make_float3 (_S905) * _S894;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S906, SurfacePoint_0 * _S907, Albedos_0 * _S908, float _S909, float _S910, bool _S911, float _S912, float _S913)
{
    Fabric_0 * _S914 = (&(globalParams_0->fabrics_0)[_S906]);
    uint _S915 = thread_number_0(_S906, _S907, _S909, _S910);
    float _S916 = _S907->fibre_across_0;
    float _S917 = _S907->fibre_along_0;
    float _S918 = __ldg(&_S914->fibre_size_0);
    float3  _S919 = fibre_cell_0(_S916, _S917, _S918);
    float2  _S920 = make_float2 (0.0f);
    uint _S921 = __ldg(&_S914->has_detail_0);
    bool _S922;
    if(_S921 != 0U)
    {
        _S922 = _S912 >= 0.0f;
    }
    else
    {
        _S922 = false;
    }
    float2  gain_3;
    if(_S922)
    {
        uint _S923;
        if(_S907->is_warp_0)
        {
            uint _S924 = __ldg(&_S914->warp_0);
            _S923 = _S924;
        }
        else
        {
            uint _S925 = __ldg(&_S914->weft_0);
            _S923 = _S925;
        }
        float2  _S926 = detail_gain_0(_S906, _S923, _S907, make_float2 (_S909, _S910), _S911, _S915, _S912);
        gain_3 = _S926 * make_float2 (1.0f - _S913, 1.0f);
    }
    else
    {
        gain_3 = _S920;
    }
    Albedos_0 _S927 = vary_albedos_0(_S906, _S908, _S915, uint(int(_S919.x)) * 65536U + uint(int((F32_floor((_S919.y))))), gain_3);
    return _S927;
}

__device__ YarnFrame_0 turned_frame_0(uint _S928, uint _S929, SurfacePoint_0 * _S930, bool _S931, uint _S932, float _S933)
{
    YarnFrame_0 frame_2;
    (&frame_2)->normal_4 = _S930->normal_0;
    (&frame_2)->tangent_4 = _S930->tangent_0;
    (&frame_2)->loss_0 = 0.0f;
    float _S934 = __ldg(&(&(globalParams_0->families_0)[_S929])->has_plies_0);
    if(_S934 > 0.0f)
    {
        float _S935 = __ldg(&(&(globalParams_0->families_0)[_S929])->plies_per_mm_0);
        float _S936 = fade_0(_S933, 1.0f / _S935);
        float _S937 = _S936 * 0.41999998688697815f;
        float _S938 = ply_offset_0(_S929, _S930, _S931);
        float _S939 = _S937 * _S938;
        float _S940 = (F32_sqrt((1.0f - _S939 * _S939)));
        float _S941;
        if(_S931)
        {
            float _S942 = __ldg(&(&(globalParams_0->families_0)[_S929])->ply_sine_0);
            _S941 = - _S942;
        }
        else
        {
            float _S943 = __ldg(&(&(globalParams_0->families_0)[_S929])->ply_sine_0);
            _S941 = _S943;
        }
        float _S944 = __ldg(&(&(globalParams_0->families_0)[_S929])->ply_cosine_0);
        float3  _S945 = cross_0((&frame_2)->tangent_4, (&frame_2)->normal_4);
        float3  _S946 = make_float3 (_S944) * _S945 + make_float3 (_S941) * (&frame_2)->tangent_4;
        (&frame_2)->tangent_4 = make_float3 (_S944) * (make_float3 (_S944) * (&frame_2)->tangent_4 - make_float3 (_S941) * _S945) + make_float3 (_S941) * (make_float3 (_S940) * _S946 - make_float3 (_S939) * (&frame_2)->normal_4);
        (&frame_2)->normal_4 = make_float3 (_S940) * (&frame_2)->normal_4 + make_float3 (_S939) * _S946;
        (&frame_2)->loss_0 = _S936 * _S936 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    float _S947 = __ldg(&(&(globalParams_0->families_0)[_S929])->fibre_tilt_0);
    if(_S947 > 0.0f)
    {
        FibreNoise_0 _S948 = fibre_noise_at_0(_S928, _S929, _S930, _S932, _S933);
        float _S949 = 1.09858846664428711f * _S947 * (_S948.bundle_weight_0 * _S948.bundle_0.x + _S948.fibre_weight_0 * (_S948.fibre_0.x + _S948.offset_2));
        float _S950 = _S947 * (1.42099642753601074f * (_S948.bundle_weight_0 * _S948.bundle_0.y + _S948.fibre_weight_0 * _S948.fibre_0.y) - _S948.bundle_weight_0 * _S948.slope_2);
        float _S951 = square_0(_S948.fibre_weight_0);
        (&frame_2)->loss_0 = (&frame_2)->loss_0 + 0.5f * _S947 * _S947 * ((0.24761904776096344f * (square_0(_S948.bundle_weight_0) + _S951) + _S951 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        float3  _S952 = cross_0((&frame_2)->tangent_4, (&frame_2)->normal_4);
        float2  _S953 = sine_cosine_0(_S949);
        float2  _S954 = sine_cosine_0(_S950);
        float _S955 = _S953.y;
        float _S956 = _S953.x;
        float3  _S957 = make_float3 (_S955) * _S952 - make_float3 (_S956) * (&frame_2)->normal_4;
        (&frame_2)->normal_4 = make_float3 (_S955) * (&frame_2)->normal_4 + make_float3 (_S956) * _S952;
        (&frame_2)->tangent_4 = make_float3 (_S954.y) * (&frame_2)->tangent_4 + make_float3 (_S954.x) * _S957;
    }
    return frame_2;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S958, SurfacePoint_0 * _S959, float _S960, float _S961, bool _S962, bool _S963, float _S964)
{
    Fabric_0 * _S965 = (&(globalParams_0->fabrics_0)[_S958]);
    bool _S966 = _S959->is_warp_0;
    uint _S967;
    if(_S959->is_warp_0)
    {
        uint _S968 = __ldg(&_S965->warp_0);
        _S967 = _S968;
    }
    else
    {
        uint _S969 = __ldg(&_S965->weft_0);
        _S967 = _S969;
    }
    uint _S970 = __ldg(&_S965->has_detail_0);
    bool _S971;
    if(_S970 != 0U)
    {
        _S971 = _S964 >= 0.0f;
    }
    else
    {
        _S971 = false;
    }
    float3  _S972 = make_float3 (0.0f);
    Hair_0 _S973 = Hair_x24init_0(0.0f, _S972, _S972);
    bool _S974;
    if(_S971)
    {
        bool _S975 = has_hairs_0(_S958);
        _S974 = _S975;
    }
    else
    {
        _S974 = false;
    }
    Hair_0 hair_2;
    if(_S974)
    {
        Hair_0 _S976 = hair_at_0(_S958, make_float2 (_S960, _S961), _S962, _S964);
        hair_2 = _S976;
    }
    else
    {
        hair_2 = _S973;
    }
    uint _S977;
    if(_S966)
    {
        _S977 = _S959->warp_thread_0;
    }
    else
    {
        _S977 = _S959->weft_thread_0;
    }
    Albedos_0 albedos_7 = albedos_of_0(_S967, _S977);
    bool _S978 = varies_at_0(_S958, _S964);
    Albedos_0 albedos_8;
    if(_S978)
    {
        Albedos_0 _S979 = albedos_7;
        Albedos_0 _S980 = varied_at_0(_S958, _S959, &_S979, _S960, _S961, _S962, _S964, hair_2.cover_0);
        albedos_8 = _S980;
    }
    else
    {
        albedos_8 = albedos_7;
    }
    YarnPoint_0 point_2;
    (&point_2)->back_7 = _S962;
    (&point_2)->hole_6 = _S963;
    (&point_2)->is_warp_3 = _S966;
    (&point_2)->x_33 = _S960;
    (&point_2)->y_18 = _S961;
    (&point_2)->height_11 = _S959->height_2;
    (&point_2)->normal_9 = _S959->normal_0;
    (&point_2)->tangent_10 = _S959->tangent_0;
    (&point_2)->surface_normal_0 = _S959->normal_0;
    (&point_2)->diffuse_gain_1 = 1.0f;
    if(_S971)
    {
        uint _S981 = thread_number_0(_S958, _S959, _S960, _S961);
        YarnFrame_0 _S982 = turned_frame_0(_S958, _S967, _S959, _S962, _S981, _S964);
        bool _S983 = has_hairs_0(_S958);
        YarnFrame_0 frame_3;
        if(_S983)
        {
            YarnFrame_0 _S984 = _S982;
            Hair_0 _S985 = hair_2;
            YarnFrame_0 _S986 = under_hair_0(&_S984, &_S985);
            frame_3 = _S986;
        }
        else
        {
            frame_3 = _S982;
        }
        (&point_2)->normal_9 = frame_3.normal_4;
        (&point_2)->tangent_10 = frame_3.tangent_4;
        float _S987 = __ldg(&_S965->diffuse_blend_0);
        YarnFrame_0 _S988 = frame_3;
        float _S989 = diffuse_gain_0(&_S988, _S987);
        (&point_2)->diffuse_gain_1 = _S989;
    }
    float _S990 = __ldg(&(&(globalParams_0->families_0)[_S967])->roughness_0);
    (&point_2)->roughness_10 = _S990;
    (&point_2)->albedos_6 = albedos_8;
    return point_2;
}

__device__ bool unoccluded_0(uint _S991, SearchQuality_0 * _S992, float _S993, float _S994, float _S995, float3  _S996, bool _S997)
{
    Fabric_0 * _S998 = (&(globalParams_0->fabrics_0)[_S991]);
    if((_S996.z) <= 0.0f)
    {
        return false;
    }
    float _S999 = max_height_along_0(_S991, _S993, _S994, _S995, _S996, _S997);
    float _S1000 = __ldg(&_S998->lift_0);
    bool _S1001 = is_free_0(_S991, _S992, make_float3 (_S993, _S994, _S995 + _S1000), _S996, _S997, _S999);
    return _S1001;
}

__device__ bool is_lit_0(uint _S1002, SearchQuality_0 * _S1003, YarnPoint_0 * _S1004, float3  _S1005)
{
    if(_S1004->hole_6)
    {
        return true;
    }
    bool _S1006 = _S1004->back_7;
    float3  _S1007 = to_face_frame_0(_S1005, _S1004->back_7);
    float _S1008 = _S1007.z;
    bool _S1009 = _S1008 < 0.0f;
    float3  _S1010 = _S1004->surface_normal_0;
    float _S1011 = _S1004->height_11;
    float3  normal_10;
    float height_12;
    if(_S1009)
    {
        SurfacePoint_0 _S1012 = surface_at_0(_S1002, _S1004->x_33, _S1004->y_18, !_S1006);
        normal_10 = _S1012.normal_0;
        height_12 = _S1012.height_2;
    }
    else
    {
        normal_10 = _S1010;
        height_12 = _S1011;
    }
    float3  _S1013 = make_float3 (float2 {_S1007.x, _S1007.y}.x, float2 {_S1007.x, _S1007.y}.y, (F32_abs((_S1008))));
    if((dot_0(normal_10, _S1013)) <= 0.0f)
    {
        return false;
    }
    bool _S1014 = unoccluded_0(_S1002, _S1003, _S1004->x_33, _S1004->y_18, height_12, _S1013, _S1006 != _S1009);
    return _S1014;
}

__device__ Components_0 components_of_point_0(uint _S1015, SearchQuality_0 * _S1016, YarnPoint_0 * _S1017, float3  _S1018, float3  _S1019)
{
    Fabric_0 * _S1020 = (&(globalParams_0->fabrics_0)[_S1015]);
    Components_0 result_15 = no_components_0();
    bool _S1021 = _S1017->hole_6;
    float _S1022;
    if(_S1017->hole_6)
    {
        _S1022 = 1.0f;
    }
    else
    {
        _S1022 = 0.0f;
    }
    (&result_15)->hole_2 = _S1022;
    bool _S1023;
    if(_S1021)
    {
        _S1023 = true;
    }
    else
    {
        bool _S1024 = is_lit_0(_S1015, _S1016, _S1017, _S1018);
        _S1023 = !_S1024;
    }
    if(_S1023)
    {
        return result_15;
    }
    float3  _S1025 = to_face_frame_0(_S1018, _S1017->back_7);
    float3  _S1026 = to_face_frame_0(_S1019, _S1017->back_7);
    float _S1027 = _S1017->diffuse_gain_1;
    bool _S1028 = (_S1025.z) < 0.0f;
    float3  _S1029;
    if(_S1028)
    {
        _S1029 = - _S1025;
    }
    else
    {
        _S1029 = _S1025;
    }
    float3  _S1030 = _S1017->normal_9;
    float _S1031 = __ldg(&_S1020->diffuse_blend_0);
    float _S1032 = _S1027 * diffuse_reflection_0(_S1029, _S1030, _S1031);
    if(_S1028)
    {
        float3  _S1033 = _S1017->tangent_10;
        float _S1034 = _S1017->roughness_10;
        float _S1035 = __ldg(&_S1020->optical_depth_0);
        _S1022 = transmission_1(_S1025, _S1026, _S1030, _S1033, _S1034, _S1035);
    }
    else
    {
        float3  _S1036 = _S1017->tangent_10;
        float _S1037 = _S1017->roughness_10;
        float _S1038 = __ldg(&_S1020->optical_depth_0);
        _S1022 = reflection_0(_S1025, _S1026, _S1030, _S1036, _S1037, _S1038);
    }
    bool _S1039 = _S1017->is_warp_3;
    float _S1040;
    if(_S1017->is_warp_3)
    {
        _S1040 = _S1032;
    }
    else
    {
        _S1040 = 0.0f;
    }
    (&result_15)->diffuse_warp_0 = _S1040;
    if(_S1039)
    {
        _S1040 = 0.0f;
    }
    else
    {
        _S1040 = _S1032;
    }
    (&result_15)->diffuse_weft_0 = _S1040;
    if(_S1039)
    {
        _S1040 = _S1022;
    }
    else
    {
        _S1040 = 0.0f;
    }
    (&result_15)->specular_warp_0 = _S1040;
    if(_S1039)
    {
        _S1022 = 0.0f;
    }
    (&result_15)->specular_weft_0 = _S1022;
    (&result_15)->light_visibility_1 = 1.0f;
    return result_15;
}

__device__ float openness_number_0(uint _S1041, uint _S1042)
{
    uint _S1043 = __ldg(&(&(globalParams_0->fabrics_0)[_S1041])->openness_0);
    return table_number_0(_S1043 + _S1042);
}

__device__ Blocked_0 blocked_of_terms_0(uint _S1044, uint _S1045, FixedArray<float, 6>  * _S1046, uint _S1047)
{
    FixedArray<float, 3>  shares_0;
    uint share_4 = 0U;
    for(;;)
    {
        if(share_4 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_4] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S1047)
            {
            }
            else
            {
                break;
            }
            float _S1048 = openness_number_0(_S1044, _S1045 + share_4 * _S1047 + term_0);
            shares_0[share_4] = shares_0[share_4] + _S1048 * (*_S1046)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_4] = saturate_1(shares_0[share_4]);
        share_4 = share_4 + 1U;
    }
    Blocked_0 blocked_2;
    (&blocked_2)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_2)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_2)->far_0 = shares_0[int(1)];
    return blocked_2;
}

__device__ Blocked_0 blocked_at_0(uint _S1049, bool _S1050, bool _S1051, float _S1052, float _S1053)
{
    float _S1054 = openness_number_0(_S1049, 158U);
    float _S1055 = _S1053 * _S1054;
    float _S1056 = _S1052 * _S1052;
    float _S1057 = _S1052 * _S1055;
    float _S1058 = _S1055 * _S1055;
    uint _S1059;
    if(_S1051)
    {
        _S1059 = 2U;
    }
    else
    {
        _S1059 = 0U;
    }
    uint _S1060;
    if(_S1050)
    {
        _S1060 = 0U;
    }
    else
    {
        _S1060 = 1U;
    }
    uint _S1061 = 60U + (_S1059 + _S1060) * 18U;
    FixedArray<float, 6>  _S1062;
    _S1062[int(0)] = 1.0f;
    _S1062[int(1)] = _S1052;
    _S1062[int(2)] = _S1055;
    _S1062[int(3)] = _S1056;
    _S1062[int(4)] = _S1057;
    _S1062[int(5)] = _S1058;
    Blocked_0 _S1063 = blocked_of_terms_0(_S1049, _S1061, &_S1062, 6U);
    return _S1063;
}

__device__ Blocked_0 with_blocked_0(uint _S1064, Blocked_0 * _S1065, YarnPoint_0 * _S1066, bool _S1067, float _S1068)
{
    bool _S1069;
    if(_S1066->hole_6)
    {
        _S1069 = true;
    }
    else
    {
        _S1069 = (_S1066->is_warp_3) != _S1067;
    }
    if(_S1069)
    {
        return *_S1065;
    }
    Blocked_0 _S1070 = blocked_at_0(_S1064, _S1067, _S1066->back_7, _S1066->normal_9.z, _S1066->height_11);
    Blocked_0 result_16;
    (&result_16)->by_warp_0 = _S1065->by_warp_0 + _S1068 * _S1070.by_warp_0;
    (&result_16)->by_weft_0 = _S1065->by_weft_0 + _S1068 * _S1070.by_weft_0;
    (&result_16)->far_0 = _S1065->far_0 + _S1068 * _S1070.far_0;
    return result_16;
}

struct CoverageTaps_0
{
    FixedArray<uint, 9>  nodes_1;
};

__device__ float3  pyramid_level_0(uint _S1071, float _S1072)
{
    Lobes_0 _S1073 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S1071])->lobes_0);
    uint _S1074 = _S1073.levels_0 + 4U * uint((F32_min((_S1072), (_S1073.last_level_0))));
    return make_float3 (table_number_0(_S1074), table_number_0(_S1074 + 1U), table_number_0(_S1074 + 2U));
}

__device__ CoverageTaps_0 coverage_taps_0(uint _S1075, Footprint_0 * _S1076, bool _S1077)
{
    Fabric_0 * _S1078 = (&(globalParams_0->fabrics_0)[_S1075]);
    float _S1079 = Footprint_spread_side_0(_S1076);
    Lobes_0 _S1080 = slang_ldg_1(&_S1078->lobes_0);
    float _S1081 = _S1079 * _S1080.inverse_base_size_0;
    float3  _S1082 = pyramid_level_0(_S1075, (F32_floor((binary_logarithm_0((F32_max((0.68000000715255737f * _S1081), (1.0f))))))));
    float _S1083 = 1.0f / (F32_max((_S1081), (9.99999997475242708e-07f)));
    float _S1084 = (F32_min(((F32_max(((F32_sqrt((clamp_1(1.29999995231628418f * (1.0f - _S1083 * _S1083), 0.0f, 1.0f))))), (0.3333333432674408f * _S1083)))), (1.0f)));
    uint _S1085 = __ldg(&_S1078->warp_0);
    float _S1086 = __ldg(&(&(globalParams_0->families_0)[_S1085])->inverse_period_0);
    uint _S1087 = __ldg(&_S1078->weft_0);
    float _S1088 = __ldg(&(&(globalParams_0->families_0)[_S1087])->inverse_period_0);
    float2  _S1089 = make_float2 (_S1086, _S1088);
    float2  _S1090 = _S1076->centre_0 * _S1089;
    float2  _S1091 = _S1076->dx_0 * _S1089 * make_float2 (_S1084);
    float2  _S1092 = _S1076->dy_0 * _S1089 * make_float2 (_S1084);
    CoverageTaps_0 taps_3;
    uint number_2 = 0U;
    for(;;)
    {
        if(number_2 < 9U)
        {
        }
        else
        {
            break;
        }
        float2  _S1093 = _S1090 + make_float2 (TAP_OFFSETS_0[number_2].x) * _S1091 + make_float2 (TAP_OFFSETS_0[number_2].y) * _S1092;
        float _S1094 = _S1082.y;
        float _S1095 = wrapped_cell_0(_S1093.x, _S1094);
        float _S1096 = wrapped_cell_0(_S1093.y, _S1082.z);
        uint _S1097;
        if(_S1077)
        {
            _S1097 = _S1080.face_nodes_0;
        }
        else
        {
            _S1097 = 0U;
        }
        (&taps_3)->nodes_1[number_2] = _S1097 + uint(_S1096 * _S1094 + _S1095 + _S1082.x);
        number_2 = number_2 + 1U;
    }
    return taps_3;
}

__device__ float4  coverage_of_pack_0(uint _S1098, CoverageTaps_0 * _S1099, uint _S1100)
{
    Fabric_0 * _S1101 = (&(globalParams_0->fabrics_0)[_S1098]);
    uint number_3 = 0U;
    uint even_1 = 0U;
    uint odd_1 = 0U;
    for(;;)
    {
        if(number_3 < 9U)
        {
        }
        else
        {
            break;
        }
        Lobes_0 _S1102 = slang_ldg_1(&_S1101->lobes_0);
        uint _S1103 = __ldg((&(globalParams_0->words_0)[_S1102.coverage_0 + _S1099->nodes_1[number_3] * _S1102.packs_0 + _S1100]));
        uint even_2 = even_1 + (_S1103 & 16711935U);
        uint odd_2 = odd_1 + ((_S1103 >> int(8)) & 16711935U);
        number_3 = number_3 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / make_float4 (9.0f);
}

__device__ float coverage_of_holes_0(uint _S1104, CoverageTaps_0 * _S1105)
{
    Fabric_0 * _S1106 = (&(globalParams_0->fabrics_0)[_S1104]);
    uint number_4 = 0U;
    uint total_0 = 0U;
    for(;;)
    {
        if(number_4 < 9U)
        {
        }
        else
        {
            break;
        }
        uint _S1107 = _S1105->nodes_1[number_4];
        Lobes_0 _S1108 = slang_ldg_1(&_S1106->lobes_0);
        uint _S1109 = __ldg((&(globalParams_0->words_0)[_S1108.coverage_holes_0 + _S1107 / 4U]));
        uint total_1 = total_0 + ((_S1109 >> (8U * (_S1107 % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

__device__ float prefiltered_hole_0(uint _S1110, CoverageTaps_0 * _S1111, NodeTaps_0 * _S1112, bool _S1113)
{
    Lobes_0 _S1114 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S1110])->lobes_0);
    float4  _S1115 = interpolate_table_0(_S1112, _S1114.projected_area_0 + _S1114.packs_0, _S1114.packs_0 + 1U);
    float _S1116 = _S1115.x;
    float _S1117;
    if(_S1113)
    {
        _S1117 = _S1114.back_hole_weight_0;
    }
    else
    {
        _S1117 = _S1114.front_hole_weight_0;
    }
    float _S1118 = coverage_of_holes_0(_S1110, _S1111);
    return (F32_min((_S1118 * _S1116 * _S1116 * _S1117), (1.0f)));
}

__device__ Components_0 prefiltered_components_0(uint _S1119, Footprint_0 * _S1120, float3  _S1121, float3  _S1122, bool _S1123)
{
    Fabric_0 * _S1124 = (&(globalParams_0->fabrics_0)[_S1119]);
    CoverageTaps_0 _S1125 = coverage_taps_0(_S1119, _S1120, _S1123);
    NodeTaps_0 _S1126 = node_taps_0(_S1122);
    NodeTaps_0 view_nodes_0 = _S1126;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S1121);
    NodeTaps_0 seen_nodes_0 = _S1126;
    uint _S1127;
    if(_S1123)
    {
        _S1127 = 1U;
    }
    else
    {
        _S1127 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + make_uint4 (_S1127 * 256U);
    uint _S1128 = 2U * _S1127;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + make_uint4 (_S1128 * 256U);
    uint _S1129;
    if((_S1121.z) < 0.0f)
    {
        _S1129 = 1U;
    }
    else
    {
        _S1129 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + make_uint4 ((_S1128 + _S1129) * 256U);
    float3  _S1130 = half_vector_0(_S1121, _S1122);
    float3  _S1131 = shadow_correlation_0(_S1121, _S1122);
    if(_S1123)
    {
        Lobes_0 _S1132 = slang_ldg_1(&_S1124->lobes_0);
        _S1129 = _S1132.back_warp_packs_0;
    }
    else
    {
        Lobes_0 _S1133 = slang_ldg_1(&_S1124->lobes_0);
        _S1129 = _S1133.front_warp_packs_0;
    }
    Components_0 sums_2;
    (&sums_2)->diffuse_warp_0 = 0.0f;
    (&sums_2)->diffuse_weft_0 = 0.0f;
    (&sums_2)->specular_warp_0 = 0.0f;
    (&sums_2)->specular_weft_0 = 0.0f;
    (&sums_2)->light_visibility_1 = 0.0f;
    uint pack_0 = 0U;
    float total_2 = 0.0f;
    for(;;)
    {
        Lobes_0 _S1134 = slang_ldg_1(&_S1124->lobes_0);
        if(pack_0 < (_S1134.packs_0))
        {
        }
        else
        {
            break;
        }
        CoverageTaps_0 _S1135 = _S1125;
        float4  _S1136 = coverage_of_pack_0(_S1119, &_S1135, pack_0);
        uint _S1137 = _S1134.projected_area_0 + pack_0;
        uint _S1138 = _S1134.packs_0 + 1U;
        NodeTaps_0 _S1139 = view_nodes_0;
        float4  _S1140 = interpolate_table_0(&_S1139, _S1137, _S1138);
        uint _S1141 = _S1134.light_visibility_0 + pack_0;
        NodeTaps_0 _S1142 = seen_nodes_0;
        float4  _S1143 = interpolate_table_0(&_S1142, _S1141, _S1134.packs_0);
        float4  _S1144 = _S1143 / make_float4 (255.0f);
        NodeTaps_0 _S1145 = light_nodes_0;
        float4  _S1146 = interpolate_table_0(&_S1145, _S1141, _S1134.packs_0);
        float4  _S1147 = _S1146 / make_float4 (255.0f);
        uint _S1148 = _S1134.irradiance_0 + pack_0;
        NodeTaps_0 _S1149 = light_nodes_0;
        float4  _S1150 = interpolate_table_0(&_S1149, _S1148, _S1134.packs_0);
        float4  _S1151 = _S1150 * make_float4 (0.00124827399849892f);
        bool _S1152 = pack_0 < _S1129;
        uint _S1153;
        if(_S1152)
        {
            uint _S1154 = __ldg(&_S1124->warp_0);
            _S1153 = _S1154;
        }
        else
        {
            uint _S1155 = __ldg(&_S1124->weft_0);
            _S1153 = _S1155;
        }
        float _S1156 = __ldg(&(&(globalParams_0->families_0)[_S1153])->roughness_0);
        uint number_5 = 0U;
        float diffuse_0 = 0.0f;
        float specular_0 = 0.0f;
        for(;;)
        {
            if(number_5 < 4U)
            {
            }
            else
            {
                break;
            }
            Group_0 _S1157 = group_at_0(_S1134.moments_0 + 12U * (4U * (_S1127 * _S1134.packs_0 + pack_0) + number_5), _S1156);
            float _S1158 = _slang_vector_get_element(_S1136, number_5) * _slang_vector_get_element(_S1140, number_5) * _slang_vector_get_element(_S1140, number_5) * _S1157.weight_2;
            uint _S1159 = number_5;
            float2  _S1160 = visibility_gain_0(_S1131, _slang_vector_get_element(_S1147, number_5), _slang_vector_get_element(_S1144, number_5));
            float _S1161 = __ldg(&_S1124->optical_depth_0);
            Group_0 _S1162 = _S1157;
            float _S1163 = layer_value_0(&_S1162, _S1130, _S1121, _S1122, _S1161);
            float _S1164 = _S1160.x;
            float diffuse_1 = diffuse_0 + _S1158 * _slang_vector_get_element(_S1151, number_5) * _S1164;
            float specular_1 = specular_0 + _S1158 * _S1163 * _slang_vector_get_element(_S1147, _S1159) * _S1160.y;
            (&sums_2)->light_visibility_1 = (&sums_2)->light_visibility_1 + _S1158 * _slang_vector_get_element(_S1147, _S1159) * _S1164;
            float total_3 = total_2 + _S1158;
            number_5 = number_5 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S1165;
        if(_S1152)
        {
            _S1165 = diffuse_0;
        }
        else
        {
            _S1165 = 0.0f;
        }
        (&sums_2)->diffuse_warp_0 = (&sums_2)->diffuse_warp_0 + _S1165;
        float _S1166;
        if(_S1152)
        {
            _S1166 = 0.0f;
        }
        else
        {
            _S1166 = diffuse_0;
        }
        (&sums_2)->diffuse_weft_0 = (&sums_2)->diffuse_weft_0 + _S1166;
        float _S1167;
        if(_S1152)
        {
            _S1167 = specular_0;
        }
        else
        {
            _S1167 = 0.0f;
        }
        (&sums_2)->specular_warp_0 = (&sums_2)->specular_warp_0 + _S1167;
        float _S1168;
        if(_S1152)
        {
            _S1168 = 0.0f;
        }
        else
        {
            _S1168 = specular_0;
        }
        (&sums_2)->specular_weft_0 = (&sums_2)->specular_weft_0 + _S1168;
        pack_0 = pack_0 + 1U;
    }
    CoverageTaps_0 _S1169 = _S1125;
    NodeTaps_0 _S1170 = view_nodes_0;
    float _S1171 = prefiltered_hole_0(_S1119, &_S1169, &_S1170, _S1123);
    (&sums_2)->hole_2 = _S1171;
    float _S1172 = (1.0f - _S1171) / (F32_max((total_2), (9.999999960041972e-13f)));
    (&sums_2)->diffuse_warp_0 = (&sums_2)->diffuse_warp_0 * _S1172;
    (&sums_2)->diffuse_weft_0 = (&sums_2)->diffuse_weft_0 * _S1172;
    (&sums_2)->specular_warp_0 = (&sums_2)->specular_warp_0 * _S1172;
    (&sums_2)->specular_weft_0 = (&sums_2)->specular_weft_0 * _S1172;
    (&sums_2)->light_visibility_1 = (&sums_2)->light_visibility_1 * _S1172;
    return sums_2;
}

__device__ FamilyAlbedos_0 albedos_over_0(uint _S1173, Footprint_0 * _S1174, bool _S1175)
{
    Fabric_0 * _S1176 = (&(globalParams_0->fabrics_0)[_S1173]);
    float2  _S1177 = sqrt_0(_S1174->dx_0 * _S1174->dx_0 + _S1174->dy_0 * _S1174->dy_0);
    uint _S1178 = __ldg(&_S1176->warp_0);
    float2  _S1179 = _S1174->centre_0;
    Stretch_0 _S1180 = stretch_of_0(_S1178, _S1174->centre_0.x, _S1177.x);
    uint _S1181 = __ldg(&_S1176->weft_0);
    Stretch_0 _S1182 = stretch_of_0(_S1181, _S1179.y, _S1177.y);
    FamilyAlbedos_0 albedos_9;
    Stretch_0 _S1183 = _S1180;
    Stretch_0 _S1184 = _S1182;
    Albedos_0 _S1185 = mean_albedos_0(_S1178, _S1181, &_S1183, &_S1184, _S1175);
    (&albedos_9)->warp_5 = _S1185;
    Stretch_0 _S1186 = _S1182;
    Stretch_0 _S1187 = _S1180;
    Albedos_0 _S1188 = mean_albedos_0(_S1181, _S1178, &_S1186, &_S1187, _S1175);
    (&albedos_9)->weft_5 = _S1188;
    return albedos_9;
}

__device__ Estimate_0 lobes_estimate_of_pass_0(uint _S1189, Footprint_0 * _S1190, float _S1191, float2  _S1192, float3  _S1193, float3  _S1194)
{
    float _S1195;
    float _S1196;
    Fabric_0 * _S1197 = (&(globalParams_0->fabrics_0)[_S1189]);
    Regime_0 _S1198 = regime_of_0(_S1189, _S1190, _S1191);
    bool _S1199 = (_S1194.z) < 0.0f;
    float3  _S1200 = to_face_frame_0(_S1194, _S1199);
    float _S1201 = Footprint_spread_side_0(_S1190);
    bool _S1202 = varies_at_0(_S1189, _S1201);
    uint _S1203 = __ldg(&_S1197->warp_0);
    uint _S1204 = __ldg(&(&(globalParams_0->families_0)[_S1203])->quantities_0);
    bool _S1205;
    if(_S1204 > 1U)
    {
        _S1205 = true;
    }
    else
    {
        uint _S1206 = __ldg(&_S1197->weft_0);
        uint _S1207 = __ldg(&(&(globalParams_0->families_0)[_S1206])->quantities_0);
        _S1205 = _S1207 > 1U;
    }
    float _S1208 = 1.0f - _S1198.prefiltered_0;
    if(_S1208 > 0.0f)
    {
        if(_S1202)
        {
            _S1205 = true;
        }
    }
    else
    {
        _S1205 = false;
    }
    Footprint_0 box_0 = *_S1190;
    float3  _S1209 = make_float3 (0.0f);
    SurfacePoint_0 _S1210 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S1209, _S1209, 0.0f, 0.0f, 0.0f);
    float2  _S1211 = _S1190->centre_0;
    Components_0 _S1212 = no_components_0();
    CloseUp_0 close_1 = no_close_up_0();
    int _S1213;
    if(_S1205)
    {
        _S1213 = int(0);
    }
    else
    {
        _S1213 = int(1);
    }
    uint _S1214 = uint(_S1213);
    Components_0 points_2 = _S1212;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S1210;
    float2  central_place_0 = _S1211;
    uint number_6 = _S1214;
    for(;;)
    {
        float _S1215 = float(number_6);
        _S1195 = _S1198.points_1;
        if(_S1215 < (_S1198.points_1 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S1216 = number_6 == 0U;
        uint _S1217;
        if(_S1216)
        {
            _S1217 = 0U;
        }
        else
        {
            _S1217 = number_6 - 1U;
        }
        float2  _S1218 = POINT_OFFSETS_0[_S1217] + _S1192;
        float2  _S1219;
        if(_S1216)
        {
            _S1219 = make_float2 (0.0f);
        }
        else
        {
            _S1219 = _S1218 - round_0(_S1218);
        }
        float2  _S1220 = _S1211 + make_float2 (_S1219.x) * _S1190->dx_0 + make_float2 (_S1219.y) * _S1190->dy_0;
        if(_S1216)
        {
            _S1196 = 0.0f;
        }
        else
        {
            _S1196 = _S1198.threads_1;
        }
        SearchQuality_0 _S1221 = quality_of_0(_S1196);
        float _S1222 = _S1220.x;
        float _S1223 = _S1220.y;
        SearchQuality_0 _S1224 = _S1221;
        Hit_0 _S1225 = first_hit_0(_S1189, &_S1224, _S1222, _S1223, _S1200, _S1199);
        SurfacePoint_0 _S1226 = surface_at_0(_S1189, _S1225.x_32, _S1225.y_17, _S1199);
        if(_S1216)
        {
            float central_weight_1;
            if(_S1225.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S1208;
            }
            float2  central_place_1 = make_float2 (_S1225.x_32, _S1225.y_17);
            (&box_0)->centre_0 = lerp_2(_S1211, central_place_1, make_float2 (central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S1226;
            central_place_0 = central_place_1;
            number_6 = number_6 + 1U;
            continue;
        }
        SurfacePoint_0 _S1227 = _S1226;
        YarnPoint_0 _S1228 = yarn_point_of_0(_S1189, &_S1227, _S1225.x_32, _S1225.y_17, _S1199, _S1225.hole_5, _S1201);
        SearchQuality_0 _S1229 = _S1221;
        YarnPoint_0 _S1230 = _S1228;
        Components_0 _S1231 = components_of_point_0(_S1189, &_S1229, &_S1230, _S1193, _S1194);
        float _S1232 = (F32_min((_S1198.points_1 - float(number_6 - 1U)), (1.0f)));
        Components_0 _S1233 = points_2;
        Components_0 _S1234 = _S1231;
        Components_0 _S1235 = with_added_0(&_S1233, &_S1234, _S1232);
        uint _S1236 = __ldg(&_S1197->openness_0);
        if(_S1236 != 4294967295U)
        {
            Blocked_0 _S1237 = (&close_1)->warp_1;
            YarnPoint_0 _S1238 = _S1228;
            Blocked_0 _S1239 = with_blocked_0(_S1189, &_S1237, &_S1238, true, _S1232);
            (&close_1)->warp_1 = _S1239;
            Blocked_0 _S1240 = (&close_1)->weft_1;
            YarnPoint_0 _S1241 = _S1228;
            Blocked_0 _S1242 = with_blocked_0(_S1189, &_S1240, &_S1241, false, _S1232);
            (&close_1)->weft_1 = _S1242;
        }
        points_2 = _S1235;
        number_6 = number_6 + 1U;
    }
    (&close_1)->weight_0 = _S1208;
    float _S1243 = (F32_max((_S1195), (1.0f)));
    float _S1244 = 1.0f / _S1243;
    Blocked_0 _S1245 = (&close_1)->warp_1;
    Blocked_0 _S1246 = scaled_0(&_S1245, _S1244);
    (&close_1)->warp_1 = _S1246;
    float _S1247 = 1.0f / _S1243;
    Blocked_0 _S1248 = (&close_1)->weft_1;
    Blocked_0 _S1249 = scaled_0(&_S1248, _S1247);
    (&close_1)->weft_1 = _S1249;
    Estimate_0 estimate_0;
    (&estimate_0)->close_0 = close_1;
    float _S1250 = _S1208 / _S1243;
    Components_0 _S1251 = _S1212;
    Components_0 _S1252 = points_2;
    Components_0 _S1253 = with_added_0(&_S1251, &_S1252, _S1250);
    (&estimate_0)->components_0 = _S1253;
    if((_S1198.prefiltered_0) > 0.0f)
    {
        Components_0 _S1254 = prefiltered_components_0(_S1189, _S1190, to_face_frame_0(_S1193, _S1199), _S1200, _S1199);
        Components_0 _S1255 = (&estimate_0)->components_0;
        Components_0 _S1256 = _S1254;
        Components_0 _S1257 = with_added_0(&_S1255, &_S1256, _S1198.prefiltered_0);
        (&estimate_0)->components_0 = _S1257;
    }
    Footprint_0 _S1258 = box_0;
    FamilyAlbedos_0 _S1259 = albedos_over_0(_S1189, &_S1258, _S1199);
    (&estimate_0)->albedos_5 = _S1259;
    if(_S1202)
    {
        _S1205 = central_weight_0 > 0.0f;
    }
    else
    {
        _S1205 = false;
    }
    if(_S1205)
    {
        SurfacePoint_0 _S1260 = central_0;
        Albedos_0 _S1261;
        if(central_0.is_warp_0)
        {
            _S1261 = (&(&estimate_0)->albedos_5)->warp_5;
        }
        else
        {
            _S1261 = (&(&estimate_0)->albedos_5)->weft_5;
        }
        uint _S1262 = __ldg(&_S1197->has_detail_0);
        if(_S1262 != 0U)
        {
            bool _S1263 = has_hairs_0(_S1189);
            _S1205 = _S1263;
        }
        else
        {
            _S1205 = false;
        }
        if(_S1205)
        {
            Hair_0 _S1264 = hair_at_0(_S1189, central_place_0, _S1199, _S1201);
            _S1196 = _S1264.cover_0;
        }
        else
        {
            _S1196 = 0.0f;
        }
        float _S1265 = central_place_0.x;
        float _S1266 = central_place_0.y;
        SurfacePoint_0 _S1267 = central_0;
        Albedos_0 _S1268 = _S1261;
        Albedos_0 _S1269 = varied_at_0(_S1189, &_S1267, &_S1268, _S1265, _S1266, _S1199, _S1201, _S1196);
        Albedos_0 _S1270 = _S1261;
        Albedos_0 _S1271 = _S1269;
        Albedos_0 _S1272 = lerp_albedos_0(&_S1270, &_S1271, central_weight_0);
        if(_S1260.is_warp_0)
        {
            (&(&estimate_0)->albedos_5)->warp_5 = _S1272;
        }
        else
        {
            (&(&estimate_0)->albedos_5)->weft_5 = _S1272;
        }
    }
    return estimate_0;
}

__device__ Estimate_0 lobes_estimate_0(uint _S1273, Footprint_0 * _S1274, float _S1275, float3  _S1276, float3  _S1277)
{
    Estimate_0 _S1278 = lobes_estimate_of_pass_0(_S1273, _S1274, _S1275, make_float2 (0.0f), _S1276, _S1277);
    return _S1278;
}

__device__ Scattered_0 scattered_by_0(uint _S1279, Albedos_0 * _S1280, uint _S1281, float3  _S1282)
{
    uint _S1283 = 159U + 2U * _S1281;
    Scattered_0 yarn_3;
    float3  _S1284 = _S1282 * _S1280->diffuse_reflect_0;
    float _S1285 = openness_number_0(_S1279, _S1283);
    (&yarn_3)->back_6 = _S1284 + make_float3 (_S1285) * _S1280->specular_reflect_0;
    float3  _S1286 = _S1282 * _S1280->diffuse_transmit_0;
    float _S1287 = openness_number_0(_S1279, _S1283 + 1U);
    (&yarn_3)->through_0 = _S1286 + make_float3 (_S1287) * _S1280->specular_transmit_0;
    return yarn_3;
}

__device__ void sent_0(uint _S1288, uint _S1289, float3  _S1290, float3  _S1291, float3  _S1292, float3  _S1293, float3  * _S1294, float3  * _S1295)
{
    uint _S1296 = 146U + 4U * _S1289;
    float _S1297 = openness_number_0(_S1288, _S1296);
    float _S1298 = openness_number_0(_S1288, _S1296 + 1U);
    float _S1299 = openness_number_0(_S1288, _S1296 + 2U);
    float _S1300 = openness_number_0(_S1288, _S1296 + 3U);
    float3  _S1301 = make_float3 (1.0f) - _S1292 * make_float3 (_S1297);
    float3  _S1302 = make_float3 (1.0f) - _S1293 * make_float3 (_S1300);
    float3  _S1303 = make_float3 (1.0f) / (_S1301 * _S1302 - _S1292 * _S1293 * make_float3 (_S1298 * _S1299));
    *_S1294 = (_S1290 * _S1302 + _S1292 * make_float3 (_S1298) * _S1291) * _S1303;
    *_S1295 = (_S1291 * _S1301 + _S1293 * make_float3 (_S1299) * _S1290) * _S1303;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S1304, uint _S1305, Scattered_0 * _S1306, Scattered_0 * _S1307)
{
    uint _S1308 = 2U * _S1305;
    uint _S1309 = 142U + _S1308;
    float _S1310 = openness_number_0(_S1304, _S1309);
    float _S1311 = openness_number_0(_S1304, _S1309 + 1U);
    float3  _S1312 = make_float3 (1.0f - _S1310) * _S1306->back_6;
    float3  _S1313 = make_float3 (1.0f - _S1311) * _S1307->back_6;
    FaceSends_0 sends_1;
    uint _S1314 = 154U + _S1308;
    float _S1315 = openness_number_0(_S1304, _S1314);
    (&sends_1)->blocks_warp_0 = _S1315;
    float _S1316 = openness_number_0(_S1304, _S1314 + 1U);
    (&sends_1)->blocks_weft_0 = _S1316;
    (&sends_1)->open_0 = _S1315 * _S1310 + _S1316 * _S1311;
    sent_0(_S1304, _S1305, make_float3 (_S1310) * _S1306->back_6, make_float3 (_S1311) * _S1307->back_6, _S1312, _S1313, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S1304, _S1305, _S1306->through_0, _S1307->through_0, _S1312, _S1313, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S1317, float3  _S1318, bool _S1319)
{
    Fabric_0 * _S1320 = (&(globalParams_0->fabrics_0)[_S1317]);
    uint _S1321 = __ldg(&_S1320->warp_0);
    uint _S1322 = __ldg(&(&(globalParams_0->families_0)[_S1321])->colour_mean_0);
    Albedos_0 _S1323 = table_albedos_0(_S1322);
    Scattered_0 _S1324 = scattered_by_0(_S1317, &_S1323, 0U, _S1318);
    uint _S1325 = __ldg(&_S1320->weft_0);
    uint _S1326 = __ldg(&(&(globalParams_0->families_0)[_S1325])->colour_mean_0);
    Albedos_0 _S1327 = table_albedos_0(_S1326);
    Scattered_0 _S1328 = scattered_by_0(_S1317, &_S1327, 1U, _S1318);
    uint _S1329;
    if(_S1319)
    {
        _S1329 = 1U;
    }
    else
    {
        _S1329 = 0U;
    }
    Scattered_0 _S1330 = _S1324;
    Scattered_0 _S1331 = _S1328;
    FaceSends_0 _S1332 = face_sends_0(_S1317, _S1329, &_S1330, &_S1331);
    if(_S1319)
    {
        _S1329 = 0U;
    }
    else
    {
        _S1329 = 1U;
    }
    Scattered_0 _S1333 = _S1324;
    Scattered_0 _S1334 = _S1328;
    FaceSends_0 _S1335 = face_sends_0(_S1317, _S1329, &_S1333, &_S1334);
    float3  _S1336 = make_float3 (_S1332.blocks_warp_0) * _S1332.crossing_warp_0 + make_float3 (_S1332.blocks_weft_0) * _S1332.crossing_weft_0;
    float3  _S1337 = make_float3 (_S1335.blocks_warp_0) * _S1335.crossing_warp_0 + make_float3 (_S1335.blocks_weft_0) * _S1335.crossing_weft_0;
    float _S1338 = 1.0f - _S1332.open_0;
    float _S1339 = 1.0f - _S1335.open_0;
    float3  _S1340 = make_float3 (1.0f) / (make_float3 (1.0f) - _S1336 * _S1337 * make_float3 (_S1338 * _S1339));
    float3  _S1341 = _S1337 * (make_float3 (_S1332.open_0) + make_float3 (_S1338) * (make_float3 (_S1332.blocks_warp_0) * _S1332.sky_warp_0 + make_float3 (_S1332.blocks_weft_0) * _S1332.sky_weft_0)) * _S1340;
    float3  _S1342 = _S1336 * (make_float3 (_S1335.open_0) + make_float3 (_S1339) * (make_float3 (_S1335.blocks_warp_0) * _S1335.sky_warp_0 + make_float3 (_S1335.blocks_weft_0) * _S1335.sky_weft_0)) * _S1340;
    FaceSends_0 _S1343 = _S1332;
    FaceRadiance_0 _S1344 = face_radiance_0(&_S1343, _S1335.open_0, _S1341, _S1342);
    FaceSends_0 _S1345 = _S1335;
    FaceRadiance_0 _S1346 = face_radiance_0(&_S1345, _S1332.open_0, _S1342, _S1341);
    Interior_0 interior_1;
    (&interior_1)->warp_4 = _S1344.warp_3;
    (&interior_1)->weft_4 = _S1344.weft_3;
    (&interior_1)->leaked_1 = _S1344.leaked_0;
    (&interior_1)->far_1 = _S1346.mean_0;
    (&interior_1)->far_leaked_0 = _S1346.leaked_0;
    return interior_1;
}

__device__ Blocked_0 blocked_from_0(uint _S1347, float3  _S1348, bool _S1349, bool _S1350)
{
    FixedArray<float, 6>  terms_1;
    view_terms_0(_S1348, &terms_1);
    uint _S1351;
    if(_S1350)
    {
        _S1351 = 2U;
    }
    else
    {
        _S1351 = 0U;
    }
    uint _S1352;
    if(_S1349)
    {
        _S1352 = 0U;
    }
    else
    {
        _S1352 = 1U;
    }
    uint _S1353 = (_S1351 + _S1352) * 15U;
    FixedArray<float, 6>  _S1354 = terms_1;
    Blocked_0 _S1355 = blocked_of_terms_0(_S1347, _S1353, &_S1354, 5U);
    return _S1355;
}

__device__ float warp_seen_from_0(uint _S1356, float3  _S1357, bool _S1358)
{
    FixedArray<float, 6>  terms_2;
    view_terms_0(_S1357, &terms_2);
    uint term_1 = 0U;
    float share_5 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S1359;
        if(_S1358)
        {
            _S1359 = 5U;
        }
        else
        {
            _S1359 = 0U;
        }
        float _S1360 = openness_number_0(_S1356, 132U + _S1359 + term_1);
        float share_6 = share_5 + _S1360 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_5 = share_6;
    }
    return saturate_1(share_5);
}

__device__ Bounced_0 bounced_of_families_0(uint _S1361, FamilyAlbedos_0 * _S1362, float3  _S1363, Interior_0 * _S1364, Blocked_0 * _S1365, Blocked_0 * _S1366)
{
    Scattered_0 _S1367 = scattered_by_0(_S1361, &_S1362->warp_5, 0U, _S1363);
    Scattered_0 _S1368 = _S1367;
    Bounced_0 _S1369 = bounced_by_0(_S1365, &_S1368, _S1364);
    Scattered_0 _S1370 = scattered_by_0(_S1361, &_S1362->weft_5, 1U, _S1363);
    Scattered_0 _S1371 = _S1370;
    Bounced_0 _S1372 = bounced_by_0(_S1366, &_S1371, _S1364);
    Bounced_0 _S1373 = _S1369;
    Bounced_0 _S1374 = _S1372;
    Bounced_0 _S1375 = sum_of_0(&_S1373, &_S1374);
    return _S1375;
}

__device__ Bounced_0 bounced_far_0(uint _S1376, FamilyAlbedos_0 * _S1377, float3  _S1378, Interior_0 * _S1379, float3  _S1380, bool _S1381, float _S1382, float _S1383, float _S1384)
{
    Blocked_0 _S1385 = blocked_from_0(_S1376, _S1380, true, _S1381);
    Blocked_0 _S1386 = blocked_from_0(_S1376, _S1380, false, _S1381);
    float _S1387 = _S1382 / (F32_max((1.0f - _S1385.by_warp_0 - _S1385.by_weft_0), (0.10000000149011612f)));
    float _S1388 = _S1383 / (F32_max((1.0f - _S1386.by_warp_0 - _S1386.by_weft_0), (0.10000000149011612f)));
    float _S1389 = warp_seen_from_0(_S1376, _S1380, _S1381);
    float _S1390 = (0.0020000000949949f * _S1389 + _S1387) / (_S1387 + _S1388 + 0.0020000000949949f);
    float _S1391 = 1.0f - _S1384;
    float _S1392 = _S1390 * _S1391;
    Blocked_0 _S1393 = _S1385;
    Blocked_0 _S1394 = scaled_0(&_S1393, _S1392);
    float _S1395 = (1.0f - _S1390) * _S1391;
    Blocked_0 _S1396 = _S1386;
    Blocked_0 _S1397 = scaled_0(&_S1396, _S1395);
    Blocked_0 _S1398 = _S1394;
    Blocked_0 _S1399 = _S1397;
    Bounced_0 _S1400 = bounced_of_families_0(_S1376, _S1377, _S1378, _S1379, &_S1398, &_S1399);
    return _S1400;
}

__device__ Bounced_0 bounced_over_0(uint _S1401, Components_0 * _S1402, CloseUp_0 * _S1403, FamilyAlbedos_0 * _S1404, float3  _S1405, float3  _S1406)
{
    bool _S1407 = (_S1406.z) < 0.0f;
    Interior_0 _S1408 = interior_of_0(_S1401, _S1405, _S1407);
    float3  _S1409 = to_face_frame_0(_S1406, _S1407);
    Interior_0 _S1410 = _S1408;
    Bounced_0 _S1411 = bounced_far_0(_S1401, _S1404, _S1405, &_S1410, _S1409, _S1407, _S1402->diffuse_warp_0, _S1402->diffuse_weft_0, _S1402->hole_2);
    Bounced_0 bounced_2 = _S1411;
    float _S1412 = _S1403->weight_0;
    if((_S1403->weight_0) > 0.0f)
    {
        Interior_0 _S1413 = _S1408;
        Bounced_0 _S1414 = bounced_of_families_0(_S1401, _S1404, _S1405, &_S1413, &_S1403->warp_1, &_S1403->weft_1);
        float3  _S1415 = make_float3 (_S1412);
        (&bounced_2)->reflected_0 = lerp_0((&bounced_2)->reflected_0, _S1414.reflected_0, _S1415);
        (&bounced_2)->transmitted_0 = lerp_0((&bounced_2)->transmitted_0, _S1414.transmitted_0, _S1415);
    }
    return bounced_2;
}

__device__ float3  composed_0(uint _S1416, Components_0 * _S1417, CloseUp_0 * _S1418, FamilyAlbedos_0 * _S1419, float3  _S1420, float3  _S1421, float3  _S1422)
{
    Fabric_0 * _S1423 = (&(globalParams_0->fabrics_0)[_S1416]);
    Albedos_0 _S1424 = tinted_0(&_S1419->warp_5, _S1420);
    Albedos_0 _S1425 = tinted_0(&_S1419->weft_5, _S1420);
    float _S1426 = _S1417->diffuse_warp_0;
    float _S1427 = _S1417->diffuse_weft_0;
    float _S1428 = _S1417->specular_warp_0;
    float _S1429 = _S1417->specular_weft_0;
    float3  _S1430 = _S1424.diffuse_reflect_0 * make_float3 (_S1417->diffuse_warp_0) + _S1425.diffuse_reflect_0 * make_float3 (_S1417->diffuse_weft_0) + _S1424.specular_reflect_0 * make_float3 (_S1417->specular_warp_0) + _S1425.specular_reflect_0 * make_float3 (_S1417->specular_weft_0);
    float _S1431 = _S1422.z;
    float3  body_0;
    if((_S1421.z * _S1431) < 0.0f)
    {
        body_0 = _S1424.diffuse_transmit_0 * make_float3 (_S1426) + _S1425.diffuse_transmit_0 * make_float3 (_S1427) + _S1424.specular_transmit_0 * make_float3 (_S1428) + _S1425.specular_transmit_0 * make_float3 (_S1429);
    }
    else
    {
        body_0 = _S1430;
    }
    uint _S1432 = __ldg(&_S1423->openness_0);
    if(_S1432 != 4294967295U)
    {
        Bounced_0 _S1433 = bounced_over_0(_S1416, _S1417, _S1418, _S1419, _S1420, _S1422);
        Bounced_0 _S1434 = _S1433;
        float3  _S1435 = bounced_value_0(&_S1434, _S1421, _S1422);
        body_0 = body_0 + _S1435;
    }
    float _S1436 = __ldg(&_S1423->sheen_strength_0);
    if(_S1436 <= 0.0f)
    {
        return body_0;
    }
    bool _S1437 = _S1431 < 0.0f;
    float3  _S1438 = to_face_frame_0(_S1421, _S1437);
    float3  _S1439 = to_face_frame_0(_S1422, _S1437);
    float _S1440 = __ldg(&_S1423->sheen_roughness_0);
    float2  _S1441 = sheen_with_transmittance_0(_S1438, _S1439, _S1436, _S1440);
    return make_float3 (_S1441.y) * body_0 + make_float3 ((_S1417->light_visibility_1 + _S1417->hole_2) * _S1441.x);
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_2, float2  dx_1, float2  dy_1, float3  light_11, float3  view_11)
{
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_2;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    Footprint_0 _S1442 = footprint_0;
    Estimate_0 _S1443 = lobes_estimate_0(fabric_2, &_S1442, 1.0f, light_11, view_11);
    float3  _S1444 = make_float3 (1.0f);
    Components_0 _S1445 = _S1443.components_0;
    CloseUp_0 _S1446 = _S1443.close_0;
    FamilyAlbedos_0 _S1447 = _S1443.albedos_5;
    float3  _S1448 = composed_0(fabric_2, &_S1445, &_S1446, &_S1447, _S1444, light_11, view_11);
    float _S1449 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
    float through_1;
    if(_S1449 > 0.0f)
    {
        float _S1450 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
        float _S1451 = (F32_abs((view_11.z)));
        float _S1452 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_roughness_0);
        through_1 = _S1443.components_0.hole_2 * (1.0f - _S1450 * sheen_lobe_0(_S1451, _S1452).z);
    }
    else
    {
        through_1 = _S1443.components_0.hole_2;
    }
    return make_float4 (_S1448.x, _S1448.y, _S1448.z, through_1);
}

extern "C" __global__ void lobes_queries()
{
    uint _S1453 = (blockIdx * blockDim + threadIdx).x;
    uint _S1454 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S1453 >= _S1454)
    {
        return;
    }
    Query_0 _S1455 = slang_ldg_0((&(globalParams_0->queries_0)[_S1453]));
    *(&(globalParams_0->answers_0)[_S1453]) = cloth_value_0(_S1455.fabric_1, make_float2 (_S1455.centre_x_0, _S1455.centre_y_0), make_float2 (_S1455.dx_x_0, _S1455.dx_y_0), make_float2 (_S1455.dy_x_0, _S1455.dy_y_0), make_float3 (_S1455.light_x_0, _S1455.light_y_0, _S1455.light_z_0), make_float3 (_S1455.view_x_0, _S1455.view_y_0, _S1455.view_z_0));
    return;
}

