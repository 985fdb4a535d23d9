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
    Query_0 _S20 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19 };
    return _S20;
}

__device__ Lobes_0 slang_ldg_1(Lobes_0 * ptr_1)
{
    uint _S21 = __ldg(&ptr_1->is_baked_0);
    float _S22 = __ldg(&ptr_1->inverse_base_size_0);
    float _S23 = __ldg(&ptr_1->last_level_0);
    uint _S24 = __ldg(&ptr_1->levels_0);
    uint _S25 = __ldg(&ptr_1->face_nodes_0);
    uint _S26 = __ldg(&ptr_1->packs_0);
    uint _S27 = __ldg(&ptr_1->front_warp_packs_0);
    uint _S28 = __ldg(&ptr_1->back_warp_packs_0);
    uint _S29 = __ldg(&ptr_1->coverage_0);
    uint _S30 = __ldg(&ptr_1->coverage_holes_0);
    uint _S31 = __ldg(&ptr_1->projected_area_0);
    uint _S32 = __ldg(&ptr_1->light_visibility_0);
    uint _S33 = __ldg(&ptr_1->irradiance_0);
    uint _S34 = __ldg(&ptr_1->moments_0);
    float _S35 = __ldg(&ptr_1->front_hole_weight_0);
    float _S36 = __ldg(&ptr_1->back_hole_weight_0);
    float _S37 = __ldg(&ptr_1->threads_per_mm_0);
    float _S38 = __ldg(&ptr_1->unit_level_0);
    Lobes_0 _S39 = { _S21, _S22, _S23, _S24, _S25, _S26, _S27, _S28, _S29, _S30, _S31, _S32, _S33, _S34, _S35, _S36, _S37, _S38 };
    return _S39;
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
    uint _S40 = (F32_asuint((x_21)));
    float exponent_0 = float(int(_S40 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S40 & 8388607U) | 1056964608U)));
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
    float _S41 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S41 - exponent_1 * 0.00021219444170129f - 0.5f * _S41) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_22)
{
    return natural_logarithm_0(x_22) * 1.4426950216293335f;
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S42 = float2 {direction_0.x, direction_0.y};
    float _S43;
    if(back_2)
    {
        _S43 = - direction_0.z;
    }
    else
    {
        _S43 = direction_0.z;
    }
    return make_float3 (_S42.x, _S42.y, _S43);
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
    SurfacePoint_0 _S44;
    (&_S44)->hole_0 = hole_1;
    (&_S44)->is_warp_0 = is_warp_1;
    (&_S44)->warp_thread_0 = warp_thread_1;
    (&_S44)->weft_thread_0 = weft_thread_1;
    (&_S44)->height_2 = height_3;
    (&_S44)->normal_0 = normal_1;
    (&_S44)->tangent_0 = tangent_1;
    (&_S44)->across_0 = across_1;
    (&_S44)->fibre_across_0 = fibre_across_1;
    (&_S44)->fibre_along_0 = fibre_along_1;
    return _S44;
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
    Blocked_0 _S45 = no_blocked_0();
    (&nothing_2)->warp_1 = _S45;
    (&nothing_2)->weft_1 = _S45;
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
    float _S46 = clamp_1((-3.0f - binary_logarithm_0((F32_max((threads_0), (9.99999971718068537e-10f))))) / 2.0f, 0.0f, 1.0f);
    SearchQuality_0 quality_0;
    float _S47 = lerp_1(2.5f, 5.0f, _S46);
    (&quality_0)->steps_per_thread_0 = _S47;
    (&quality_0)->steps_per_relief_0 = _S47;
    (&quality_0)->shadow_share_0 = lerp_1(1.60000002384185791f, 1.0f, _S46);
    (&quality_0)->refinements_0 = uint(lerp_1(1.0f, 2.0f, _S46) + 0.5f);
    return quality_0;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_0)
{
    float _S48 = __ldg(&(&(globalParams_0->families_0)[family_0])->inverse_count_0);
    float _S49 = __ldg(&(&(globalParams_0->families_0)[family_0])->half_inverse_count_0);
    float _S50 = (F32_floor(((F32_fma((index_0), (_S48), (_S49))))));
    float _S51 = - _S50;
    float _S52 = __ldg(&(&(globalParams_0->families_0)[family_0])->count_0);
    return make_float2 (_S50, (F32_fma((_S51), (_S52), (index_0))));
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
    float _S53 = __ldg(&(&(globalParams_0->families_0)[family_1])->inverse_size_0);
    float _S54 = (F32_floor((position_0 * _S53)));
    Cell_0 cell_0;
    float _S55 = - _S54;
    float _S56 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    float _S57 = (F32_fma((_S55), (_S56), (position_0)));
    (&cell_0)->below_0 = _S57;
    float _S58 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->above_0 = _S58 - _S57;
    float _S59 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->across_2 = _S57 - 0.5f * _S59;
    float _S60 = __ldg(&(&(globalParams_0->families_0)[family_1])->half_width_0);
    (&cell_0)->half_width_1 = _S60;
    float _S61 = turns_and_remainder_0(family_1, _S54).y;
    float _S62 = __ldg(&(&(globalParams_0->families_0)[family_1])->count_0);
    (&cell_0)->thread_0 = uint(clamp_1(_S61, 0.0f, _S62 - 1.0f));
    return cell_0;
}

__device__ float table_number_0(uint index_1)
{
    uint _S63 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S63)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float _S64 = __ldg(&(&(globalParams_0->families_0)[family_2])->start_0);
    float _S65 = position_1 - _S64;
    float _S66 = __ldg(&(&(globalParams_0->families_0)[family_2])->inverse_period_0);
    float turns_0 = _S65 * _S66;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    float _S67 = __ldg(&(&(globalParams_0->families_0)[family_2])->period_0);
    float _S68 = turns_1 * _S67;
    float _S69 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    float _S70 = turns_1 * _S69;
    float _S71 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    uint _S72 = uint(clamp_1(_S70, 0.0f, _S71 - 1.0f));
    uint _S73 = __ldg(&(&(globalParams_0->families_0)[family_2])->first_thread_table_0);
    uint _S74 = __ldg((&(globalParams_0->words_0)[_S73 + _S72]));
    uint _S75 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S76;
    if(_S68 >= (table_number_0(_S75 + _S74 * 4U + 1U)))
    {
        _S76 = 1U;
    }
    else
    {
        _S76 = 0U;
    }
    uint _S77 = _S74 + _S76;
    float _S78 = __ldg(&(&(globalParams_0->families_0)[family_2])->count_0);
    uint _S79 = (U32_min((_S77), (uint(_S78) - 1U)));
    uint _S80 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S81 = _S80 + _S79 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S79;
    (&cell_1)->below_0 = _S68 - table_number_0(_S81);
    (&cell_1)->above_0 = table_number_0(_S81 + 1U) - _S68;
    (&cell_1)->across_2 = _S68 - table_number_0(_S81 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S81 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    uint _S82 = __ldg(&(&(globalParams_0->families_0)[family_3])->is_alike_0);
    if(_S82 != 0U)
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
    bool _S83 = (F32_abs(((&crossing_0->warp_2)->across_2))) < ((&crossing_0->warp_2)->half_width_1);
    bool _S84 = (F32_abs(((&crossing_0->weft_2)->across_2))) < ((&crossing_0->weft_2)->half_width_1);
    Shown_0 shown_0;
    bool _S85;
    if(_S83)
    {
        if(!_S84)
        {
            _S85 = true;
        }
        else
        {
            _S85 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S85 = false;
    }
    (&shown_0)->is_warp_2 = _S85;
    if(!_S83)
    {
        _S85 = !_S84;
    }
    else
    {
        _S85 = false;
    }
    (&shown_0)->hole_3 = _S85;
    uint _S86;
    if((&shown_0)->is_warp_2)
    {
        _S86 = crossing_0->warp_word_0;
    }
    else
    {
        _S86 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S86;
    (&shown_0)->on_top_0 = ((_S86 & 1U) == 1U) != back_3;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_2;
    uint _S87;
    if(is_first_0)
    {
        _S87 = first_0->thread_0;
    }
    else
    {
        _S87 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S87;
    float _S88;
    if(is_first_0)
    {
        _S88 = first_0->across_2;
    }
    else
    {
        _S88 = second_0->across_2;
    }
    (&cell_2)->across_2 = _S88;
    if(is_first_0)
    {
        _S88 = first_0->half_width_1;
    }
    else
    {
        _S88 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S88;
    if(is_first_0)
    {
        _S88 = first_0->below_0;
    }
    else
    {
        _S88 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S88;
    if(is_first_0)
    {
        _S88 = first_0->above_0;
    }
    else
    {
        _S88 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S88;
    return cell_2;
}

__device__ float boundary_0(uint family_4, uint thread_1, int step_0)
{
    float2  _S89 = turns_and_remainder_0(family_4, float(int(thread_1) + step_0));
    float _S90 = _S89.x;
    float _S91 = __ldg(&(&(globalParams_0->families_0)[family_4])->period_0);
    uint _S92 = __ldg(&(&(globalParams_0->families_0)[family_4])->place_table_0);
    return (F32_fma((_S90), (_S91), (table_number_0(_S92 + uint(_S89.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_2, int first_1, int last_0)
{
    uint _S93 = __ldg(&(&(globalParams_0->families_0)[family_5])->is_alike_0);
    if(_S93 != 0U)
    {
        float _S94 = float(last_0 - first_1);
        float _S95 = __ldg(&(&(globalParams_0->families_0)[family_5])->size_0);
        return _S94 * _S95;
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
    uint _S96 = __ldg(&(&(globalParams_0->families_0)[family_6])->bend_table_0);
    uint _S97 = __ldg(&(&(globalParams_0->families_0)[family_6])->is_alike_0);
    uint _S98;
    if(_S97 != 0U)
    {
        _S98 = 0U;
    }
    else
    {
        _S98 = thread_3 * 4U;
    }
    uint _S99 = _S96 + _S98;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S99);
    (&bend_0)->half_tangent_0 = table_number_0(_S99 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S99 + 2U);
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
    int _S100 = int((word_1 >> int(1)) & 127U);
    int _S101 = int((word_1 >> int(8)) & 127U);
    int _S102 = int((word_1 >> int(15)) & 63U);
    int _S103 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S104 = crossed_0->thread_0;
    int _S105 = - _S100;
    float _S106 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_0, _S105, int(0));
    (&run_0)->from_start_0 = _S106;
    int _S107 = _S101 + int(1);
    float _S108 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_0, int(1), _S107);
    (&run_0)->to_end_0 = _S108;
    bool _S109 = _S106 < _S108;
    (&run_0)->near_start_0 = _S109;
    int _S110;
    if(_S109)
    {
        _S110 = _S105 - _S102;
    }
    else
    {
        _S110 = _S107;
    }
    int _S111;
    if((&run_0)->near_start_0)
    {
        _S111 = _S105;
    }
    else
    {
        _S111 = _S107 + _S103;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_4);
    float _S112;
    if((&run_0)->straight_0)
    {
        _S112 = 1.0e+06f;
    }
    else
    {
        _S112 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S112;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S104, _S110, _S111)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S100 == int(0);
    (&run_0)->last_crossing_0 = _S101 == int(0);
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
    float _S113 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S114 = clamp_1(cell_3->across_2, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_3 = _S114;
    float _S115 = _S113 * _S113 - square_0(_S114);
    float _S116 = (F32_rsqrt((_S115)));
    (&section_0)->drop_0 = _S113 - _S115 * _S116;
    (&section_0)->slope_0 = - _S114 * _S116;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_5, int step_1)
{
    uint _S117 = __ldg(&(&(globalParams_0->families_0)[family_7])->is_alike_0);
    if(_S117 != 0U)
    {
        uint _S118 = __ldg(&(&(globalParams_0->families_0)[family_7])->bend_table_0);
        return table_number_0(_S118 + 3U);
    }
    uint _S119 = __ldg(&(&(globalParams_0->families_0)[family_7])->bend_table_0);
    return table_number_0(_S119 + uint(turns_and_remainder_0(family_7, float(int(thread_5) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S120 = crossed_1->below_0;
    float _S121 = crossed_1->above_0;
    bool _S122 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S123 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S124;
    if(_S122)
    {
        _S124 = _S120 - crossed_1->across_2;
    }
    else
    {
        _S124 = _S121 + crossed_1->across_2;
    }
    float _S125 = _S124 - crossed_1->half_width_1;
    bool _S126;
    if(_S122)
    {
        _S126 = run_1->first_crossing_0;
    }
    else
    {
        _S126 = run_1->last_crossing_0;
    }
    bool _S127 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S124 = 0.0f;
    }
    else
    {
        float _S128 = __ldg(&(&(globalParams_0->families_0)[other_1])->height_scale_0);
        _S124 = _S128 * edge_drop_0(other_1, crossed_1->thread_0, int(0));
    }
    float _S129;
    if(_S127 != _S126)
    {
        _S129 = 0.0f;
    }
    else
    {
        float _S130 = __ldg(&(&(globalParams_0->families_0)[other_1])->height_scale_0);
        uint _S131 = crossed_1->thread_0;
        int _S132;
        if(_S122)
        {
            _S132 = int(-1);
        }
        else
        {
            _S132 = int(1);
        }
        _S129 = _S130 * edge_drop_0(other_1, _S131, _S132);
    }
    float _S133 = 1.0f / (F32_max((2.0f * _S125), (9.999999960041972e-13f)));
    float _S134 = clamp_1((_S125 - _S123) * _S133, 0.0f, 1.0f);
    float _S135 = _S124 + (_S129 - _S124) * (_S134 * _S134 * (3.0f - 2.0f * _S134));
    float _S136 = (_S124 - _S129) * (6.0f * _S134 * (1.0f - _S134) * _S133);
    if(_S122)
    {
        _S124 = 1.0f;
    }
    else
    {
        _S124 = -1.0f;
    }
    return make_float2 (_S135, _S136 * _S124);
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
    float _S137 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S137)))), (9.99999971718068537e-10f)));
    float _S138 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S138)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S137 > 0.0f;
    (&control_0)->up_0 = _S138 > 0.0f;
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
    float _S139;
    if(forwards_0)
    {
        _S139 = cell_4->across_2;
    }
    else
    {
        _S139 = - cell_4->across_2;
    }
    float _S140;
    if(forwards_0)
    {
        _S140 = cell_4->above_0;
    }
    else
    {
        _S140 = cell_4->below_0;
    }
    bool _S141;
    if(forwards_0)
    {
        _S141 = run_2->last_crossing_0;
    }
    else
    {
        _S141 = run_2->first_crossing_0;
    }
    bool _S142;
    if(forwards_0)
    {
        _S142 = run_2->first_crossing_0;
    }
    else
    {
        _S142 = run_2->last_crossing_0;
    }
    float _S143 = cell_4->half_width_1;
    float _S144 = - cell_4->half_width_1;
    bool _S145 = _S139 < _S144;
    bool _S146 = _S139 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S141 = !_S141;
    }
    else
    {
        _S141 = false;
    }
    if(_S141)
    {
        _S141 = !shown_2->hole_3;
    }
    else
    {
        _S141 = false;
    }
    bool _S147;
    if(_S141)
    {
        _S147 = shown_2->on_top_0;
    }
    else
    {
        _S147 = false;
    }
    if(_S147)
    {
        if(_S142)
        {
            _S142 = _S145;
        }
        else
        {
            _S142 = false;
        }
        _S142 = !_S142;
    }
    else
    {
        _S142 = false;
    }
    if(shown_2->hole_3)
    {
        _S141 = true;
    }
    else
    {
        if(_S141)
        {
            _S141 = !shown_2->on_top_0;
        }
        else
        {
            _S141 = false;
        }
    }
    float _S148;
    if(_S145)
    {
        _S148 = _S144;
    }
    else
    {
        _S148 = _S143;
    }
    float _S149 = _S148 - _S139;
    if(_S141)
    {
        _S139 = 2.0f * _S140 + _S139 - _S143;
    }
    else
    {
        _S139 = _S140;
    }
    if(_S142)
    {
        if(forwards_0)
        {
            _S139 = run_2->to_end_0;
        }
        else
        {
            _S139 = run_2->from_start_0;
        }
        return _S139;
    }
    if(_S146)
    {
    }
    else
    {
        _S139 = _S149;
    }
    return _S139;
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
    float _S150 = previous_1->rate_0;
    float _S151 = previous_1->rate_0 * step_4;
    float _S152 = rate_1 * step_4;
    bool _S153;
    if(!previous_1->known_0)
    {
        _S153 = true;
    }
    else
    {
        _S153 = here_0->hole_4;
    }
    if(_S153)
    {
        _S153 = true;
    }
    else
    {
        _S153 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S153)
    {
        _S153 = true;
    }
    else
    {
        _S153 = _S150 >= 0.0f;
    }
    if(_S153)
    {
        _S153 = true;
    }
    else
    {
        _S153 = rate_1 <= 0.0f;
    }
    if(_S153)
    {
        return -1.0f;
    }
    float _S154 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S151) >= 0.0f)
    {
        _S153 = (3.0f * clearance_1 - _S152) >= 0.0f;
    }
    else
    {
        _S153 = false;
    }
    if(_S153)
    {
        return -1.0f;
    }
    float _S155 = clearance_1 - _S154;
    float _S156 = 6.0f * _S155 - 4.0f * _S151 - 2.0f * _S152;
    float _S157 = -2.0f * _S151 / (F32_max((_S156 + (F32_sqrt(((F32_max((_S156 * _S156 - 4.0f * (3.0f * (_S151 + _S152 - 2.0f * _S155)) * _S151), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S158 = 1.0f - _S157;
    float _S159 = (_S154 * (2.0f * _S157 + 1.0f) + _S151 * _S157) * _S158 * _S158;
    float _S160 = (clearance_1 * (2.0f * _S158 + 1.0f) - _S152 * _S158) * _S157 * _S157;
    if(_S157 > 0.01999999955296516f)
    {
        _S153 = _S158 > 0.01999999955296516f;
    }
    else
    {
        _S153 = false;
    }
    if(_S153)
    {
        _S153 = (_S159 + _S160) < 0.0f;
    }
    else
    {
        _S153 = false;
    }
    float _S161;
    if(_S153)
    {
        _S161 = _S158 * step_4;
    }
    else
    {
        _S161 = -1.0f;
    }
    return _S161;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S162 = here_1->hole_4;
    float _S163;
    if(here_1->hole_4)
    {
        _S163 = 1.0e+09f;
    }
    else
    {
        _S163 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S163;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S164;
    if(!_S162)
    {
        _S164 = !is_cell_exit_0;
    }
    else
    {
        _S164 = false;
    }
    (&previous_2)->known_0 = _S164;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S165 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S166;
    if(!here_2->hole_4)
    {
        _S166 = (rate_3 * _S165 + clearance_3) < 0.0f;
    }
    else
    {
        _S166 = false;
    }
    if(_S166)
    {
        _S166 = _S165 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S166 = false;
    }
    float _S167 = this_2->step_2;
    float _S168;
    if(_S166)
    {
        _S168 = _S165 - this_2->epsilon_0;
    }
    else
    {
        _S168 = (F32_max((_S165), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S167), (_S168)));
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
    float _S169 = end_0 - start_1;
    float _S170 = start_rate_0 + end_rate_0 - 2.0f * _S169;
    float _S171 = 3.0f * _S169 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S169), (9.99999968265522539e-21f)));
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
        float _S172 = clamp_1(share_1 - (((_S170 * share_1 + _S171) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S170 * share_1 + 2.0f * _S171) * share_1 + start_rate_0), (0.10000000149011612f * _S169 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S173 = i_9 + int(1);
        share_1 = _S172;
        i_9 = _S173;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_1(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S174 = along_slope_0 * along_slope_0 + 1.0f;
    float _S175 = (F32_rsqrt((_S174)));
    float _S176 = sine_1 * _S175 * (F32_rsqrt((_S174 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S176 * _S174, _S176 * across_slope_0 * along_slope_0 + cosine_0 * _S175);
}

__device__ float arc_sine_0(float x_24)
{
    float _S177 = (F32_abs((x_24)));
    bool _S178 = _S177 > 0.5f;
    float _S179;
    if(_S178)
    {
        _S179 = 0.5f * (1.0f - _S177);
    }
    else
    {
        _S179 = _S177 * _S177;
    }
    float _S180;
    if(_S178)
    {
        _S180 = (F32_sqrt(((F32_max((_S179), (0.0f))))));
    }
    else
    {
        _S180 = _S177;
    }
    float _S181 = ((((0.04216320067644119f * _S179 + 0.02418131195008755f) * _S179 + 0.04547002539038658f) * _S179 + 0.07495300471782684f) * _S179 + 0.16666752099990845f) * _S179 * _S180 + _S180;
    if(_S178)
    {
        _S179 = 1.57079637050628662f - 2.0f * _S181;
    }
    else
    {
        _S179 = _S181;
    }
    if(x_24 < 0.0f)
    {
        _S179 = - _S179;
    }
    return _S179;
}

struct Hair_0
{
    float cover_0;
    float3  normal_2;
    float3  tangent_2;
};

__device__ Hair_0 Hair_x24init_0(float cover_1, float3  normal_3, float3  tangent_3)
{
    Hair_0 _S182;
    (&_S182)->cover_0 = cover_1;
    (&_S182)->normal_2 = normal_3;
    (&_S182)->tangent_2 = tangent_3;
    return _S182;
}

__device__ float fade_0(float size_1, float period_1)
{
    return clamp_1((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S183 = value_0 * 747796405U + 2891336453U;
    uint _S184 = ((_S183 >> ((_S183 >> int(28)) + 4U)) ^ _S183) * 277803737U;
    return (_S184 >> int(22)) ^ _S184;
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
    float _S185 = (F32_floor((x_25 * 0.63661974668502808f + 0.5f)));
    float _S186 = x_25 - _S185 * 1.5703125f - _S185 * 0.00048375129699707f - _S185 * 7.54979012640433211e-08f;
    float _S187 = _S186 * _S186;
    float _S188 = ((-0.00019515295571182f * _S187 + 0.00833216123282909f) * _S187 - 0.16666655242443085f) * _S187 * _S186 + _S186;
    float _S189 = ((0.00002443315679557f * _S187 - 0.00138873164542019f) * _S187 + 0.04166664555668831f) * _S187 * _S187 - 0.5f * _S187 + 1.0f;
    uint _S190 = uint(int(_S185)) & 3U;
    float2  _S191;
    if((_S190 & 1U) != 0U)
    {
        _S191 = make_float2 (_S189, _S188);
    }
    else
    {
        _S191 = make_float2 (_S188, _S189);
    }
    float _S192;
    if((_S190 & 2U) != 0U)
    {
        _S192 = - _S191.x;
    }
    else
    {
        _S192 = _S191.x;
    }
    float _S193;
    if(((_S190 + 1U) & 2U) != 0U)
    {
        _S193 = - _S191.y;
    }
    else
    {
        _S193 = _S191.y;
    }
    return make_float2 (_S192, _S193);
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
    uint _S194 = __ldg(&(&(globalParams_0->families_0)[family_8])->albedo_table_0);
    uint _S195 = __ldg(&(&(globalParams_0->families_0)[family_8])->albedo_stride_0);
    return table_albedos_0(_S194 + _S195 * thread_7);
}

__device__ float3  fibre_cell_0(float across_4, float along_0, float width_2)
{
    float _S196 = (F32_floor((across_4 / width_2)));
    return make_float3 (_S196, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S196, 2.0f * (across_4 / width_2 - _S196) - 1.0f);
}

__device__ float ply_offset_0(uint family_9, SurfacePoint_0 * point_0, bool back_4)
{
    float _S197;
    if(back_4)
    {
        float _S198 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_sine_0);
        _S197 = - _S198;
    }
    else
    {
        float _S199 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_sine_0);
        _S197 = _S199;
    }
    float _S200 = point_0->fibre_across_0;
    float _S201 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_cosine_0);
    float _S202 = _S200 * _S201 + point_0->fibre_along_0 * _S197;
    float _S203 = __ldg(&(&(globalParams_0->families_0)[family_9])->plies_per_mm_0);
    float _S204 = _S202 * _S203;
    return 2.0f * (_S204 - (F32_floor((_S204)))) - 1.0f;
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
    float _S205 = (F32_floor((position_3)));
    float _S206 = position_3 - _S205;
    uint _S207 = uint(int(_S205));
    float _S208 = signed_noise_0(hash_bits_0(key_1, _S207));
    float _S209 = signed_noise_0(hash_bits_0(key_1, _S207 + 1U));
    return make_float2 (lerp_1(_S208, _S209, smooth_share_0(_S206)), 6.0f * _S206 * (1.0f - _S206) * (_S209 - _S208));
}

__device__ float2  cell_noise_0(uint key_2, float3  cell_6)
{
    float _S210 = cell_6.y;
    float _S211 = (F32_floor((_S210)));
    uint _S212 = uint(int(cell_6.x)) * 65536U + uint(int(_S211));
    uint _S213 = hash_bits_0(key_2, _S212);
    uint _S214 = hash_bits_0(key_2, _S212 + 1U);
    return lerp_2(make_float2 (signed_noise_0(_S213), signed_noise_0(_S213 >> int(16))), make_float2 (signed_noise_0(_S214), signed_noise_0(_S214 >> int(16))), make_float2 (smooth_share_0(_S210 - _S211)));
}

__device__ float uniform_hash_0(uint thread_8, uint cell_7, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_8, stream_1), cell_7)) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_1, float3  room_0)
{
    float3  _S215 = room_0 / max_0(albedo_1, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S215.x), (_S215.y)))), (_S215.z)))), (0.0f))))));
}

__device__ float flattened_0(float largest_0, float3  albedo_2, float3  room_1)
{
    float3  _S216 = room_1 / max_0(albedo_2, make_float3 (9.99999997475242708e-07f)) - make_float3 (1.0f);
    return (F32_min(((F32_max(((F32_min(((F32_min((_S216.x), (_S216.y)))), (_S216.z)))), (0.0f))) / (F32_max((largest_0), (9.99999997475242708e-07f)))), (1.0f)));
}

__device__ float fibre_gain_0(uint thread_10, uint cell_8, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_10, cell_8, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
    float3  normal_4;
    float3  tangent_4;
    float loss_0;
};

__device__ YarnFrame_0 under_hair_0(YarnFrame_0 * frame_0, Hair_0 * hair_0)
{
    float3  _S217 = frame_0->tangent_4;
    float3  _S218 = hair_0->tangent_2;
    float3  _S219;
    if((dot_0(frame_0->tangent_4, hair_0->tangent_2)) < 0.0f)
    {
        _S219 = - _S218;
    }
    else
    {
        _S219 = _S218;
    }
    YarnFrame_0 blended_0;
    float3  _S220 = make_float3 (hair_0->cover_0);
    float3  _S221 = normalize_0(lerp_0(frame_0->normal_4, hair_0->normal_2, _S220));
    (&blended_0)->normal_4 = _S221;
    float3  _S222 = lerp_0(_S217, _S219, _S220);
    float3  _S223 = _S222 - make_float3 (dot_0(_S222, _S221)) * _S221;
    (&blended_0)->tangent_4 = _S223 * make_float3 ((F32_rsqrt(((F32_max((dot_0(_S223, _S223)), (9.999999960041972e-13f)))))));
    (&blended_0)->loss_0 = frame_0->loss_0 * (1.0f - hair_0->cover_0);
    return blended_0;
}

__device__ float diffuse_gain_0(YarnFrame_0 * frame_1, float blend_0)
{
    return (F32_min((0.85000002384185791f * blend_0 * frame_1->loss_0 + 1.0f), (1.0f / (0.5f * blend_0 * (frame_1->normal_4.z - 1.0f) + 1.0f))));
}

__device__ float diffuse_reflection_0(float3  light_0, float3  normal_5, float blend_1)
{
    float _S224 = light_0.z;
    if(_S224 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_1((F32_max((_S224), (0.0f))), (F32_max((dot_0(light_0, normal_5)), (0.0f))), blend_1);
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_5, float roughness_1)
{
    float _S225 = dot_0(direction_2, tangent_5);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S225 * _S225 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_26)
{
    float _S226 = clamp_1(x_26, -87.0f, 88.0f);
    float _S227 = (F32_floor((_S226 * 1.4426950216293335f + 0.5f)));
    float _S228 = _S226 - _S227 * 0.693359375f + _S227 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S228 + 0.00139819993637502f) * _S228 + 0.00833345204591751f) * _S228 + 0.04166579619050026f) * _S228 + 0.1666666567325592f) * _S228 + 0.5f;
    float _S229 = (U32_asfloat((uint(int(_S227) + int(127)) << int(23))));
    float _S230;
    if(x_26 < -87.0f)
    {
        _S230 = 0.0f;
    }
    else
    {
        _S230 = (p_0 * _S228 * _S228 + _S228 + 1.0f) * _S229;
    }
    return _S230;
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
    float _S231 = roughness_2 * roughness_2;
    float _S232 = squared_along_0 * (1.0f - _S231) + _S231;
    return 0.31830987334251404f * _S231 * roughness_2 / (_S232 * _S232);
}

__device__ float density_between_0(float3  light_1, float3  view_0, float3  tangent_6, float roughness_3)
{
    float3  _S233 = light_1 + view_0;
    float _S234 = dot_0(_S233, tangent_6);
    return flake_density_0((F32_min((_S234 * _S234 / (F32_max((square_1(_S233)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float transmission_1(float3  light_2, float3  view_1, float3  normal_6, float3  tangent_7, float roughness_4, float optical_depth_1)
{
    float _S235 = - dot_0(light_2, normal_6);
    float _S236 = dot_0(view_1, normal_6);
    bool _S237;
    if(_S235 <= 0.0f)
    {
        _S237 = true;
    }
    else
    {
        _S237 = _S236 <= 0.0f;
    }
    if(_S237)
    {
        return 0.0f;
    }
    float _S238 = 1.0f / (F32_max((_S236), (9.99999997475242708e-07f)));
    float _S239 = projected_area_1(light_2, tangent_7, roughness_4) / (F32_max((_S235), (9.99999997475242708e-07f)));
    float _S240 = projected_area_1(view_1, tangent_7, roughness_4) * _S238;
    return density_between_0(light_2, view_1, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * (F32_min((_S239), (_S240)))) * mean_attenuation_0(optical_depth_1 * (F32_abs((_S239 - _S240)))) * _S238;
}

__device__ float reflection_0(float3  light_3, float3  view_2, float3  normal_7, float3  tangent_8, float roughness_5, float optical_depth_2)
{
    float _S241 = dot_0(light_3, normal_7);
    bool _S242;
    if(_S241 <= 0.0f)
    {
        _S242 = true;
    }
    else
    {
        _S242 = (dot_0(view_2, normal_7)) <= 0.0f;
    }
    if(_S242)
    {
        return 0.0f;
    }
    float _S243 = (F32_max((_S241), (9.99999997475242708e-07f)));
    float _S244 = (F32_max((dot_0(view_2, normal_7)), (9.99999997475242708e-07f)));
    float _S245 = projected_area_1(light_3, tangent_8, roughness_5) * _S244 + projected_area_1(view_2, tangent_8, roughness_5) * _S243;
    float _S246 = optical_depth_2 * _S245 / (_S243 * _S244);
    return 0.25f * density_between_0(light_3, view_2, tangent_8, roughness_5) * (_S246 * mean_attenuation_0(_S246)) * _S243 / _S245;
}

__device__ Components_0 with_added_0(Components_0 * sums_0, Components_0 * more_0, float weight_1)
{
    Components_0 result_12;
    (&result_12)->diffuse_warp_0 = sums_0->diffuse_warp_0 + weight_1 * more_0->diffuse_warp_0;
    (&result_12)->diffuse_weft_0 = sums_0->diffuse_weft_0 + weight_1 * more_0->diffuse_weft_0;
    (&result_12)->specular_warp_0 = sums_0->specular_warp_0 + weight_1 * more_0->specular_warp_0;
    (&result_12)->specular_weft_0 = sums_0->specular_weft_0 + weight_1 * more_0->specular_weft_0;
    (&result_12)->light_visibility_1 = sums_0->light_visibility_1 + weight_1 * more_0->light_visibility_1;
    (&result_12)->hole_2 = sums_0->hole_2 + weight_1 * more_0->hole_2;
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
    float _S247 = (F32_abs((x_28)));
    float _S248 = (F32_abs((y_13)));
    float angle_0 = arc_tangent_of_ratio_0((F32_min((_S247), (_S248))) / (F32_max(((F32_max((_S247), (_S248)))), (1.00000000317107685e-30f))));
    float angle_1;
    if(_S248 > _S247)
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
    float _S249 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    float _S250 = (F32_floor((_S249)));
    float _S251 = _S249 - _S250;
    float _S252 = (F32_sqrt((clamp_1((1.0f - (F32_abs((direction_3.z)))) / 0.97000002861022949f, 0.0f, 1.0f))));
    float _S253 = 7.0f * _S252 * (F32_sqrt((_S252)));
    float _S254 = (F32_min(((F32_floor((_S253)))), (6.0f)));
    float _S255 = _S253 - _S254;
    uint _S256 = uint(int(_S250) + int(32)) % 32U;
    uint _S257 = uint(_S254);
    uint _S258 = _S256 * 8U + _S257;
    uint _S259 = (_S256 + 1U) % 32U * 8U + _S257;
    NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = make_uint4 (_S258, _S258 + 1U, _S259, _S259 + 1U);
    float _S260 = 1.0f - _S251;
    float _S261 = 1.0f - _S255;
    float4  _S262 = make_float4 (_S260 * _S261, _S260 * _S255, _S251 * _S261, _S251 * _S255) * make_float4 (252.0f) + make_float4 (0.5f);
    uint4  _S263 = make_uint4 ((uint)_S262.x, (uint)_S262.y, (uint)_S262.z, (uint)_S262.w);
    (&taps_0)->weights_0 = _S263;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S263.x + _S263.y + _S263.z + _S263.w);
    return taps_0;
}

__device__ float3  half_vector_0(float3  light_4, float3  view_3)
{
    float3  _S264 = light_4 + view_3;
    return _S264 * make_float3 ((F32_rsqrt(((F32_max((square_1(_S264)), (9.999999960041972e-13f)))))));
}

__device__ float3  shadow_correlation_0(float3  light_5, float3  view_4)
{
    float2  _S265 = float2 {light_5.x, light_5.y};
    float2  _S266 = float2 {view_4.x, view_4.y};
    float _S267 = dot_1(_S265, _S266) / (F32_max(((F32_sqrt((dot_1(_S265, _S265) * dot_1(_S266, _S266))))), (9.99999997475242708e-07f)));
    if((light_5.z) < 0.0f)
    {
        return make_float3 (make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S267).x, make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S267).y, 0.0f);
    }
    return make_float3 ((F32_min((0.62000000476837158f + 0.62999999523162842f * _S267), (1.20000004768371582f))), 0.62000000476837158f, 0.37000000476837158f);
}

__device__ float4  bytes_of_sums_0(uint even_0, uint odd_0)
{
    return make_float4 (float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

__device__ float4  interpolate_0(NodeTaps_0 * taps_1, uint4  packs_2)
{
    uint4  _S268 = (packs_2 & make_uint4 (16711935U)) * taps_1->weights_0;
    uint4  _S269 = ((packs_2 >> make_uint4 (int(8))) & make_uint4 (16711935U)) * taps_1->weights_0;
    return bytes_of_sums_0(_S268.x + _S268.y + _S268.z + _S268.w, _S269.x + _S269.y + _S269.z + _S269.w) * make_float4 (taps_1->inverse_sum_0);
}

__device__ float4  interpolate_table_0(NodeTaps_0 * taps_2, uint table_0, uint stride_0)
{
    uint4  _S270 = make_uint4 (table_0) + taps_2->nodes_0 * make_uint4 (stride_0);
    uint _S271 = __ldg((&(globalParams_0->words_0)[_S270.x]));
    uint _S272 = __ldg((&(globalParams_0->words_0)[_S270.y]));
    uint _S273 = __ldg((&(globalParams_0->words_0)[_S270.z]));
    uint _S274 = __ldg((&(globalParams_0->words_0)[_S270.w]));
    float4  _S275 = interpolate_0(taps_2, make_uint4 (_S271, _S272, _S273, _S274));
    return _S275;
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
    float3  _S276 = make_float3 (table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    (&group_0)->tangent_9 = _S276;
    float _S277 = table_number_0(row_1 + 7U);
    float _S278 = table_number_0(row_1 + 8U);
    (&group_0)->variance_0 = make_float3 (_S277, _S278, 1.0f - square_1(_S276) - _S277 - _S278);
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
    float _S279 = direction_4.x;
    float _S280 = direction_4.y;
    float _S281 = direction_4.z;
    return (F32_max((dot_0(this_5->variance_0, direction_4 * direction_4) + 2.0f * dot_0(this_5->covariance_0, make_float3 (_S279 * _S280, _S279 * _S281, _S280 * _S281))), (0.0f)));
}

__device__ float mean_area_0(Group_0 * group_1, float3  direction_5)
{
    float _S282 = dot_0(direction_5, group_1->tangent_9);
    float _S283 = _S282 * _S282;
    float _S284 = Group_variance_along_0(group_1, direction_5);
    float _S285 = group_1->roughness_6 * group_1->roughness_6;
    return (F32_sqrt(((F32_max(((_S285 - 1.0f) * (_S283 + _S284) + 1.0f), (_S285))))));
}

__device__ float mean_density_0(Group_0 * group_2, float3  half_0)
{
    float _S286 = group_2->roughness_6;
    float _S287 = (F32_max(((F32_sqrt(((F32_max((1.0f - group_2->roughness_6 * group_2->roughness_6), (0.0f)))))) / group_2->roughness_6), (0.00100000004749745f)));
    float _S288 = Group_variance_along_0(group_2, half_0);
    float _S289 = (F32_max(((F32_sqrt((3.0f * _S288)))), (_S286 * 0.01999999955296516f + 0.00009999999747379f)));
    float _S290 = dot_0(half_0, group_2->tangent_9);
    float _S291 = _S287 * (_S290 - _S289);
    float _S292 = _S287 * (_S290 + _S289);
    float _S293 = _S291 * _S292;
    float _S294 = 2.0f * _S289 * _S287;
    return 0.15915493667125702f / _S286 * ((1.0f - _S293) / ((_S291 * _S291 + 1.0f) * (_S292 * _S292 + 1.0f)) + arc_tangent_0(_S294, 1.0f + _S293) / _S294);
}

__device__ float layer_value_0(Group_0 * group_3, float3  half_1, float3  light_6, float3  view_5, float optical_depth_3)
{
    bool _S295 = (light_6.z) < 0.0f;
    float3  _S296 = group_3->normal_8;
    float _S297 = dot_0(light_6, group_3->normal_8);
    float _S298;
    if(_S295)
    {
        _S298 = - _S297;
    }
    else
    {
        _S298 = _S297;
    }
    float _S299 = (F32_max((_S298), (0.01999999955296516f)));
    float _S300 = (F32_max((dot_0(view_5, _S296)), (0.01999999955296516f)));
    float _S301 = mean_area_0(group_3, light_6);
    float _S302 = _S301 / _S299;
    float _S303 = mean_area_0(group_3, view_5);
    float _S304 = _S303 / _S300;
    if(_S295)
    {
        _S298 = (F32_abs((_S302 - _S304)));
    }
    else
    {
        _S298 = _S302 + _S304;
    }
    float _S305 = optical_depth_3 * (F32_max((_S298), (0.00100000004749745f)));
    if(_S295)
    {
        _S298 = exponential_0(- optical_depth_3 * (F32_min((_S302), (_S304))));
    }
    else
    {
        _S298 = 1.0f;
    }
    float _S306 = optical_depth_3 * _S298 * (1.0f - exponential_0(- _S305)) / _S305 / _S300;
    if(_S295)
    {
        _S298 = 1.0f;
    }
    else
    {
        _S298 = 1.0f - 0.34999999403953552f * (1.0f - square_1(_S296));
    }
    float _S307 = mean_density_0(group_3, half_1);
    return 0.25f * _S307 * _S298 * _S306;
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
    Cell_0 _S308 = locate_0(family_10, position_5);
    uint _S309 = __ldg(&(&(globalParams_0->families_0)[family_10])->before_0);
    float _S310 = table_number_0(_S309 + 2U * _S308.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_11 = _S308.thread_0;
    float _S311 = __ldg(&(&(globalParams_0->families_0)[family_10])->start_0);
    float _S312 = position_5 - _S311 - _S310 - _S308.below_0;
    float _S313 = __ldg(&(&(globalParams_0->families_0)[family_10])->inverse_period_0);
    (&bound_0)->turns_2 = (F32_round((_S312 * _S313)));
    (&bound_0)->cell_9 = _S308.below_0;
    float _S314 = 2.0f * _S308.half_width_1;
    (&bound_0)->width_3 = _S314;
    (&bound_0)->visible_0 = clamp_1((_S308.across_2 + _S308.half_width_1) / _S314, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S308.below_0), (_S308.below_0 - _S308.across_2 - _S308.half_width_1))) + (F32_max((_S308.across_2 - _S308.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

__device__ Stretch_0 stretch_of_0(uint family_11, float centre_1, float size_2)
{
    float _S315 = __ldg(&(&(globalParams_0->families_0)[family_11])->start_0);
    float _S316 = centre_1 - _S315;
    float _S317 = __ldg(&(&(globalParams_0->families_0)[family_11])->inverse_period_0);
    float _S318 = (F32_floor((_S316 * _S317)));
    float _S319 = __ldg(&(&(globalParams_0->families_0)[family_11])->period_0);
    float _S320 = centre_1 - _S318 * _S319;
    float _S321 = __ldg(&(&(globalParams_0->families_0)[family_11])->smallest_box_0);
    float _S322 = 0.5f * (F32_max((size_2), (_S321)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_0 = bound_at_0(family_11, _S320 - _S322);
    (&stretch_0)->high_0 = bound_at_0(family_11, _S320 + _S322);
    return stretch_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

__device__ float3  lengths_0(uint family_12, Stretch_0 * stretch_1)
{
    float _S323 = Stretch_turns_0(stretch_1);
    uint _S324 = __ldg(&(&(globalParams_0->families_0)[family_12])->before_0);
    uint _S325 = _S324 + 2U * (&stretch_1->low_0)->thread_11;
    uint _S326 = __ldg(&(&(globalParams_0->families_0)[family_12])->before_0);
    uint _S327 = _S326 + 2U * (&stretch_1->high_0)->thread_11;
    float _S328 = table_number_0(_S327) - table_number_0(_S325);
    float _S329 = table_number_0(_S327 + 1U) - table_number_0(_S325 + 1U);
    float _S330 = _S328 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_3 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_3;
    float _S331 = __ldg(&(&(globalParams_0->families_0)[family_12])->visible_total_0);
    float _S332 = _S330 + _S323 * _S331;
    float _S333 = _S329 - _S328 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0;
    float _S334 = __ldg(&(&(globalParams_0->families_0)[family_12])->period_0);
    float _S335 = __ldg(&(&(globalParams_0->families_0)[family_12])->visible_total_0);
    float _S336 = _S333 + _S323 * (_S334 - _S335);
    float _S337 = _S329 + (&stretch_1->high_0)->cell_9 - (&stretch_1->low_0)->cell_9;
    float _S338 = __ldg(&(&(globalParams_0->families_0)[family_12])->period_0);
    return make_float3 (_S332, _S336, _S337 + _S323 * _S338);
}

__device__ float2  integrals_along_0(uint family_13, Stretch_0 * stretch_2, uint quantity_0)
{
    uint _S339 = __ldg(&(&(globalParams_0->families_0)[family_13])->quantities_0);
    uint _S340 = __ldg(&(&(globalParams_0->families_0)[family_13])->colour_threads_0);
    uint _S341 = 3U * _S339;
    uint _S342 = _S340 + _S341 * (&stretch_2->low_0)->thread_11 + quantity_0;
    uint _S343 = __ldg(&(&(globalParams_0->families_0)[family_13])->colour_threads_0);
    uint _S344 = _S343 + _S341 * (&stretch_2->high_0)->thread_11 + quantity_0;
    uint _S345 = __ldg(&(&(globalParams_0->families_0)[family_13])->colour_threads_0);
    float _S346 = __ldg(&(&(globalParams_0->families_0)[family_13])->count_0);
    uint _S347 = _S345 + _S341 * uint(_S346) + quantity_0;
    float _S348 = table_number_0(_S342);
    float _S349 = table_number_0(_S344);
    float _S350 = Stretch_turns_0(stretch_2);
    uint _S351 = 2U * _S339;
    return make_float2 (table_number_0(_S344 + _S339) - table_number_0(_S342 + _S339) + _S349 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_3 - _S348 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_3 + _S350 * table_number_0(_S347 + _S339), table_number_0(_S344 + _S351) - table_number_0(_S342 + _S351) + _S349 * (&stretch_2->high_0)->cell_9 - _S348 * (&stretch_2->low_0)->cell_9 + _S350 * table_number_0(_S347 + _S351));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_7)
{
    return ((&this_7->high_0)->thread_11) < ((&this_7->low_0)->thread_11);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_8, uint4  entries_0, uint whole_0)
{
    uint _S352 = entries_0.z;
    uint _S353 = entries_0.x;
    uint _S354 = _S352 - _S353;
    bool _S355 = Stretch_wraps_0(this_8);
    uint _S356;
    if(_S355)
    {
        _S356 = whole_0;
    }
    else
    {
        _S356 = 0U;
    }
    return make_uint4 (_S354 + _S356, entries_0.w - _S352, entries_0.y - _S353, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_5, uint row_2, uint count_2, uint quantities_1)
{
    uint _S357 = row_2 + (&across_5->low_0)->thread_11 * quantities_1;
    uint _S358 = row_2 + (&across_5->high_0)->thread_11 * quantities_1;
    uint _S359 = __ldg((&(globalParams_0->words_0)[_S357]));
    uint _S360 = __ldg((&(globalParams_0->words_0)[_S357 + quantities_1]));
    uint _S361 = __ldg((&(globalParams_0->words_0)[_S358]));
    uint _S362 = __ldg((&(globalParams_0->words_0)[_S358 + quantities_1]));
    uint4  _S363 = make_uint4 (_S359, _S360, _S361, _S362);
    uint _S364 = __ldg((&(globalParams_0->words_0)[row_2 + count_2 * quantities_1]));
    uint4  _S365 = Stretch_differences_0(across_5, _S363, _S364);
    return _S365;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_9)
{
    float _S366 = (&this_9->high_0)->visible_0;
    float _S367 = - (&this_9->low_0)->visible_0;
    float _S368 = Stretch_turns_0(this_9);
    bool _S369 = Stretch_wraps_0(this_9);
    float _S370;
    if(_S369)
    {
        _S370 = 1.0f;
    }
    else
    {
        _S370 = 0.0f;
    }
    return make_float4 (1.0f, _S366, _S367, _S368 - _S370);
}

__device__ float integral_on_top_0(uint family_14, Stretch_0 * across_6, Stretch_0 * along_1, uint crossing_count_0, uint quantity_1)
{
    float _S371 = __ldg(&(&(globalParams_0->families_0)[family_14])->count_0);
    uint _S372 = uint(_S371);
    uint _S373 = _S372 + 1U;
    uint _S374 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint _S375 = _S373 * _S374;
    uint _S376 = __ldg(&(&(globalParams_0->families_0)[family_14])->colour_areas_0);
    uint _S377 = _S376 + quantity_1;
    uint _S378 = (&along_1->low_0)->thread_11;
    uint _S379 = _S377 + (&along_1->low_0)->thread_11 * _S375;
    uint _S380 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S381 = row_differences_0(across_6, _S379, _S372, _S380);
    uint _S382 = _S377 + (_S378 + 1U) * _S375;
    uint _S383 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S384 = row_differences_0(across_6, _S382, _S372, _S383);
    uint _S385 = (&along_1->high_0)->thread_11;
    uint _S386 = _S377 + (&along_1->high_0)->thread_11 * _S375;
    uint _S387 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S388 = row_differences_0(across_6, _S386, _S372, _S387);
    uint _S389 = _S377 + (_S385 + 1U) * _S375;
    uint _S390 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S391 = row_differences_0(across_6, _S389, _S372, _S390);
    uint _S392 = _S377 + crossing_count_0 * _S375;
    uint _S393 = __ldg(&(&(globalParams_0->families_0)[family_14])->quantities_0);
    uint4  _S394 = row_differences_0(across_6, _S392, _S372, _S393);
    uint4  _S395 = _S388 - _S381;
    bool _S396 = Stretch_wraps_0(along_1);
    uint4  _S397;
    if(_S396)
    {
        _S397 = _S394;
    }
    else
    {
        int4  _S398 = make_int4 (int(0));
        uint4  _S399 = make_uint4 ((uint)_S398.x, (uint)_S398.y, (uint)_S398.z, (uint)_S398.w);
        _S397 = _S399;
    }
    uint4  _S400 = _S395 + _S397;
    float4  _S401 = Stretch_weights_0(across_6);
    float4  _S402 = Stretch_weights_0(along_1);
    int4  _S403 = make_int4 ((int)_S400.x, (int)_S400.y, (int)_S400.z, (int)_S400.w);
    float4  _S404 = make_float4 ((float)_S403.x, (float)_S403.y, (float)_S403.z, (float)_S403.w);
    uint4  _S405 = _S391 - _S388;
    int4  _S406 = make_int4 ((int)_S405.x, (int)_S405.y, (int)_S405.z, (int)_S405.w);
    float4  _S407 = make_float4 ((float)_S406.x, (float)_S406.y, (float)_S406.z, (float)_S406.w);
    uint4  _S408 = _S384 - _S381;
    int4  _S409 = make_int4 ((int)_S408.x, (int)_S408.y, (int)_S408.z, (int)_S408.w);
    float4  _S410 = make_float4 ((float)_S409.x, (float)_S409.y, (float)_S409.z, (float)_S409.w);
    int4  _S411 = make_int4 ((int)_S394.x, (int)_S394.y, (int)_S394.z, (int)_S394.w);
    float4  _S412 = make_float4 ((float)_S411.x, (float)_S411.y, (float)_S411.z, (float)_S411.w);
    float _S413 = dot_2(make_float4 (dot_2(_S404, _S401), dot_2(_S407, _S401), dot_2(_S410, _S401), dot_2(_S412, _S401)), _S402);
    float _S414 = __ldg(&(&(globalParams_0->families_0)[family_14])->area_unit_0);
    return _S413 * _S414;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_3, uint row_3)
{
    Albedos_0 _S415 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_3) * _S415.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_3) * _S415.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_3) * _S415.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_3) * _S415.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_15, uint crossing_1, Stretch_0 * own_1, Stretch_0 * other_2, bool back_5)
{
    uint _S416 = __ldg(&(&(globalParams_0->families_0)[family_15])->colour_mean_0);
    Albedos_0 albedos_2 = table_albedos_0(_S416);
    uint _S417 = __ldg(&(&(globalParams_0->families_0)[family_15])->quantities_0);
    if(_S417 == 1U)
    {
        return albedos_2;
    }
    float3  _S418 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_4 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        uint _S419 = __ldg(&(&(globalParams_0->families_0)[family_15])->quantities_0);
        if(quantity_2 < _S419)
        {
        }
        else
        {
            break;
        }
        float2  _S420 = integrals_along_0(family_15, own_1, quantity_2);
        float _S421 = __ldg(&(&(globalParams_0->families_0)[crossing_1])->count_0);
        float _S422 = integral_on_top_0(family_15, own_1, other_2, uint(_S421), quantity_2);
        float _S423 = _S420.x;
        float _S424 = _S423 * _S418.x;
        float _S425;
        if(back_5)
        {
            _S425 = _S424 - _S422;
        }
        else
        {
            _S425 = _S422;
        }
        bool _S426 = quantity_2 == 0U;
        if(_S426)
        {
            float _S427 = __ldg(&(&(globalParams_0->families_0)[family_15])->area_unit_0);
            float _S428 = 16.0f * _S427;
            float _S429 = __ldg(&(&(globalParams_0->families_0)[family_15])->crossing_area_0);
            is_exposed_0 = _S425 > (_S428 * (F32_min((_S424 / _S429), (1.0f))) + 0.00000999999974738f * _S424);
        }
        float _S430 = _S423 * _S418.y;
        float _S431;
        if(is_exposed_0)
        {
            _S431 = _S425;
        }
        else
        {
            _S431 = 0.0f;
        }
        float _S432 = _S430 + _S431 + 0.000244140625f * _S418.z * _S420.y;
        if(_S426)
        {
            weight_4 = 1.0f / (F32_max((_S432), (9.99999968265522539e-21f)));
        }
        else
        {
            Albedos_0 _S433 = albedos_2;
            float _S434 = _S432 * weight_4;
            uint _S435 = __ldg(&(&(globalParams_0->families_0)[family_15])->colour_axes_0);
            uint _S436 = _S435 + 12U * (quantity_2 - 1U);
            Albedos_0 _S437 = _S433;
            Albedos_0 _S438 = with_added_albedos_0(&_S437, _S434, _S436);
            albedos_2 = _S438;
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
    float3  _S439 = make_float3 (weight_5);
    (&albedos_3)->diffuse_reflect_0 = lerp_0(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S439);
    (&albedos_3)->diffuse_transmit_0 = lerp_0(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S439);
    (&albedos_3)->specular_reflect_0 = lerp_0(first_2->specular_reflect_0, second_1->specular_reflect_0, _S439);
    (&albedos_3)->specular_transmit_0 = lerp_0(first_2->specular_transmit_0, second_1->specular_transmit_0, _S439);
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
    float3  _S440 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S441 = sends_0->sky_warp_0 + _S440 * sends_0->crossing_warp_0;
    (&found_0)->warp_3 = _S441;
    float3  _S442 = sends_0->sky_weft_0 + _S440 * sends_0->crossing_weft_0;
    (&found_0)->weft_3 = _S442;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S441 + make_float3 (sends_0->blocks_weft_0) * _S442;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

__device__ void view_terms_0(float3  view_6, FixedArray<float, 6>  * terms_0)
{
    float _S443 = 1.0f - view_6.z;
    float _S444 = _S443 * _S443;
    (*terms_0)[int(0)] = 1.0f;
    float _S445 = view_6.x;
    float _S446 = _S445 * _S445;
    float _S447 = view_6.y;
    float _S448 = _S447 * _S447;
    (*terms_0)[int(1)] = (F32_sqrt(((F32_max((_S446 + _S448), (9.999999960041972e-13f))))));
    (*terms_0)[int(2)] = _S444;
    (*terms_0)[int(3)] = _S444 * _S444;
    (*terms_0)[int(4)] = _S446 - _S448;
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
    float3  _S449 = make_float3 (blocked_1->by_warp_0 + blocked_1->by_weft_0) * interior_0->leaked_1;
    float3  _S450 = make_float3 (blocked_1->far_0) * yarn_2->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_6 * (make_float3 (blocked_1->by_warp_0) * interior_0->warp_4 + make_float3 (blocked_1->by_weft_0) * interior_0->weft_4) + _S450 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S450 * interior_0->far_1 + yarn_2->back_6 * _S449;
    return bounced_0;
}

__device__ Bounced_0 sum_of_0(Bounced_0 * first_3, Bounced_0 * second_2)
{
    Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_3->reflected_0 + second_2->reflected_0;
    (&sum_1)->transmitted_0 = first_3->transmitted_0 + second_2->transmitted_0;
    return sum_1;
}

__device__ float3  bounced_value_0(Bounced_0 * bounced_1, float3  light_7, float3  view_7)
{
    float _S451 = light_7.z;
    float3  _S452;
    if((_S451 * view_7.z) < 0.0f)
    {
        _S452 = bounced_1->transmitted_0;
    }
    else
    {
        _S452 = bounced_1->reflected_0;
    }
    return _S452 * make_float3 ((F32_abs((_S451))) * 0.31830987334251404f);
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
    float _S453 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S454 = 2.0f * (F32_sqrt((_S453))) - 1.0f;
    float _S455 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_8, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S454, _S455), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S453) * sheen_shear_0(_S454, _S455), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S454, _S455), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_8, float3  view_8, float scale_0, float shear_0)
{
    float _S456 = light_8.z;
    bool _S457;
    if(_S456 <= 0.0f)
    {
        _S457 = true;
    }
    else
    {
        _S457 = (view_8.z) <= 0.0f;
    }
    if(_S457)
    {
        return 0.0f;
    }
    float2  _S458 = float2 {view_8.x, view_8.y};
    float _S459 = dot_1(_S458, _S458);
    float2  _S460;
    if(_S459 > 9.99999968265522539e-21f)
    {
        _S460 = _S458 * make_float2 ((F32_rsqrt((_S459))));
    }
    else
    {
        _S460 = make_float2 (1.0f, 0.0f);
    }
    float _S461 = scale_0 * dot_1(float2 {light_8.x, light_8.y}, _S460) + shear_0 * _S456;
    float _S462 = scale_0 * (light_8.y * _S460.x - light_8.x * _S460.y);
    float _S463 = _S461 * _S461 + _S462 * _S462 + _S456 * _S456;
    return 0.31830987334251404f * scale_0 * scale_0 * _S456 / (F32_max((_S463 * _S463), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_9, float3  view_9, float strength_0, float roughness_9)
{
    float3  _S464 = sheen_lobe_0(view_9.z, roughness_9);
    float _S465 = strength_0 * _S464.z;
    return make_float2 (_S465 * transformed_cosine_0(light_9, view_9, _S464.x, _S464.y), 1.0f - _S465);
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

__device__ Regime_0 regime_of_0(uint _S466, Footprint_0 * _S467, float _S468)
{
    Fabric_0 * _S469 = (&(globalParams_0->fabrics_0)[_S466]);
    float _S470 = Footprint_spread_side_0(_S467);
    float _S471 = binary_logarithm_0((F32_max((_S470), (9.99999971718068537e-10f))));
    Lobes_0 _S472 = slang_ldg_1(&_S469->lobes_0);
    float _S473 = clamp_1((_S471 - _S472.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S474 = _S473 * _S473 * (3.0f - 2.0f * _S473);
    (&regime_0)->prefiltered_0 = _S474;
    (&regime_0)->threads_1 = _S470 * _S472.threads_per_mm_0;
    float _S475 = lerp_1((F32_max((8.0f / _S468), (1.0f))), 1.0f, _S474);
    float _S476;
    if(_S474 < 1.0f)
    {
        _S476 = clamp_1((&regime_0)->threads_1 * 12.0f, 1.0f, _S475);
    }
    else
    {
        _S476 = 0.0f;
    }
    (&regime_0)->points_1 = _S476;
    return regime_0;
}

__device__ bool varies_at_0(uint _S477, float _S478)
{
    Fabric_0 * _S479 = (&(globalParams_0->fabrics_0)[_S477]);
    float _S480 = __ldg(&_S479->fibre_noise_0);
    bool _S481;
    if(_S480 > 0.0f)
    {
        _S481 = true;
    }
    else
    {
        float _S482 = __ldg(&_S479->colour_noise_0);
        _S481 = _S482 > 0.0f;
    }
    if(_S481)
    {
        _S481 = true;
    }
    else
    {
        uint _S483 = __ldg(&_S479->has_detail_0);
        if(_S483 != 0U)
        {
            _S481 = _S478 >= 0.0f;
        }
        else
        {
            _S481 = false;
        }
    }
    return _S481;
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

__device__ Crossing_0 crossing_at_0(uint _S484, float _S485, float _S486, bool _S487)
{
    Fabric_0 * _S488 = (&(globalParams_0->fabrics_0)[_S484]);
    Crossing_0 crossing_3;
    uint _S489 = __ldg(&_S488->warp_0);
    (&crossing_3)->warp_2 = locate_0(_S489, _S485);
    uint _S490 = __ldg(&_S488->weft_0);
    (&crossing_3)->weft_2 = locate_0(_S490, _S486);
    uint _S491 = __ldg(&_S488->run_words_0);
    uint _S492 = (&(&crossing_3)->weft_2)->thread_0;
    uint _S493 = __ldg(&_S488->ends_1);
    uint _S494 = _S491 + 2U * (_S492 * _S493 + (&(&crossing_3)->warp_2)->thread_0);
    uint _S495 = __ldg((&(globalParams_0->words_0)[_S494]));
    (&crossing_3)->warp_word_0 = _S495;
    uint _S496 = __ldg((&(globalParams_0->words_0)[_S494 + 1U]));
    (&crossing_3)->weft_word_0 = _S496;
    (&crossing_3)->warp_above_0 = ((_S495 & 1U) == 1U) != _S487;
    return crossing_3;
}

__device__ Sample_0 sample_at_0(uint _S497, float _S498, float _S499, bool _S500)
{
    Fabric_0 * _S501 = (&(globalParams_0->fabrics_0)[_S497]);
    Sample_0 sample_0;
    Crossing_0 _S502 = crossing_at_0(_S497, _S498, _S499, _S500);
    (&sample_0)->crossing_2 = _S502;
    Crossing_0 _S503 = _S502;
    Shown_0 _S504 = shown_at_0(&_S503, _S500);
    (&sample_0)->shown_3 = _S504;
    uint _S505;
    if(_S504.is_warp_2)
    {
        uint _S506 = __ldg(&_S501->warp_0);
        _S505 = _S506;
    }
    else
    {
        uint _S507 = __ldg(&_S501->weft_0);
        _S505 = _S507;
    }
    uint _S508;
    if(_S504.is_warp_2)
    {
        uint _S509 = __ldg(&_S501->weft_0);
        _S508 = _S509;
    }
    else
    {
        uint _S510 = __ldg(&_S501->warp_0);
        _S508 = _S510;
    }
    Cell_0 _S511 = (&(&sample_0)->crossing_2)->warp_2;
    Cell_0 _S512 = (&(&sample_0)->crossing_2)->weft_2;
    Cell_0 _S513 = select_cell_0(_S504.is_warp_2, &_S511, &_S512);
    Cell_0 _S514 = (&(&sample_0)->crossing_2)->weft_2;
    Cell_0 _S515 = (&(&sample_0)->crossing_2)->warp_2;
    Cell_0 _S516 = select_cell_0(_S504.is_warp_2, &_S514, &_S515);
    Cell_0 _S517 = _S516;
    Run_0 _S518 = unpack_0(_S505, _S508, _S513.thread_0, &_S517, _S504.word_0);
    Cell_0 _S519 = _S513;
    Section_0 _S520 = section_at_0(&_S519);
    bool _S521;
    if(_S504.on_top_0)
    {
        _S521 = (_S518.distance_0) < (_S520.drop_0 * _S518.bend_1.sine_0);
    }
    else
    {
        _S521 = false;
    }
    bool _S522;
    if(_S504.on_top_0)
    {
        _S522 = !_S521;
    }
    else
    {
        _S522 = false;
    }
    float _S523;
    if(_S522)
    {
        _S523 = 1.0f;
    }
    else
    {
        _S523 = -1.0f;
    }
    float _S524;
    if(_S521)
    {
        _S524 = _S518.other_reach_0;
    }
    else
    {
        _S524 = _S518.reach_0;
    }
    float _S525;
    if(_S521)
    {
        _S525 = _S524 + _S518.distance_0;
    }
    else
    {
        _S525 = (F32_max((_S524 - _S518.distance_0), (0.0f)));
    }
    float _S526 = _S524 / _S518.bend_1.sine_0 - _S523 * _S520.drop_0;
    float _S527 = _S525 * _S525;
    float _S528 = (F32_max((_S526 * _S526 - _S527), (9.99999968265522539e-21f)));
    float _S529 = (F32_rsqrt((_S528)));
    float _S530 = _S527 / (_S528 * _S529 + _S526);
    bool _S531 = _S525 > 0.0f;
    float _S532;
    if(_S504.on_top_0)
    {
        _S532 = 1.0f;
    }
    else
    {
        _S532 = -1.0f;
    }
    float _S533;
    if(_S518.near_start_0)
    {
        _S533 = 1.0f;
    }
    else
    {
        _S533 = -1.0f;
    }
    float _S534 = _S532 * _S533;
    if(_S531)
    {
        _S532 = _S526 * _S529;
    }
    else
    {
        _S532 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S520.slope_0 * _S532;
    if(_S531)
    {
        _S525 = _S534 * _S525 * _S529;
    }
    else
    {
        _S525 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S525;
    float _S535 = __ldg(&(&(globalParams_0->families_0)[_S505])->height_scale_0);
    Shown_0 _S536 = _S504;
    Run_0 _S537 = _S518;
    Cell_0 _S538 = _S516;
    float2  _S539 = dive_0(_S508, &_S536, &_S537, &_S538);
    if(_S518.straight_0)
    {
        _S523 = 0.0f;
    }
    else
    {
        _S523 = _S535 * _S523;
    }
    (&sample_0)->height_7 = _S523 * (_S524 * _S518.bend_1.half_tangent_0 - _S530) - _S535 * _S520.drop_0 - _S539.x;
    float _S540 = _S535 * (&sample_0)->slope_across_0;
    float _S541 = _S535 * (&sample_0)->slope_along_0 - _S539.y;
    if(_S504.is_warp_2)
    {
        _S523 = _S540;
    }
    else
    {
        _S523 = _S541;
    }
    (&sample_0)->slope_x_1 = _S523;
    if(_S504.is_warp_2)
    {
        _S523 = _S541;
    }
    else
    {
        _S523 = _S540;
    }
    (&sample_0)->slope_y_1 = _S523;
    (&sample_0)->run_3 = _S518;
    (&sample_0)->section_1 = _S520;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S542, SearchQuality_0 * _S543, float3  _S544)
{
    Fabric_0 * _S545 = (&(globalParams_0->fabrics_0)[_S542]);
    float _S546 = (F32_abs((_S544.x)));
    float _S547 = __ldg(&_S545->threads_per_x_0);
    float _S548 = _S546 * _S547;
    float _S549 = (F32_abs((_S544.y)));
    float _S550 = __ldg(&_S545->threads_per_y_0);
    float _S551 = (F32_max((_S548), (_S549 * _S550))) * _S543->steps_per_thread_0;
    float _S552 = (F32_abs((_S544.z)));
    float _S553 = __ldg(&_S545->per_relief_0);
    return (F32_max((_S551), (_S552 * _S553 * _S543->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S554, Crossing_0 * _S555)
{
    Fabric_0 * _S556 = (&(globalParams_0->fabrics_0)[_S554]);
    bool _S557 = _S555->warp_above_0;
    uint _S558;
    if(_S555->warp_above_0)
    {
        uint _S559 = __ldg(&_S556->warp_0);
        _S558 = _S559;
    }
    else
    {
        uint _S560 = __ldg(&_S556->weft_0);
        _S558 = _S560;
    }
    uint _S561;
    if(_S557)
    {
        _S561 = _S555->warp_word_0;
    }
    else
    {
        _S561 = _S555->weft_word_0;
    }
    float _S562 = float(_S561 >> int(28));
    float _S563 = __ldg(&(&(globalParams_0->families_0)[_S558])->height_scale_0);
    float _S564 = _S562 * _S563;
    float _S565 = __ldg(&(&(globalParams_0->families_0)[_S558])->level_0);
    return _S564 * _S565;
}

__device__ Probe_0 probe_0(uint _S566, float _S567, float _S568, bool _S569, bool _S570, bool _S571)
{
    Sample_0 _S572 = sample_at_0(_S566, _S567, _S568, _S569);
    Probe_0 probe_1;
    (&probe_1)->height_4 = _S572.height_7;
    (&probe_1)->hole_4 = _S572.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S572.slope_x_1;
    (&probe_1)->slope_y_0 = _S572.slope_y_1;
    uint _S573;
    if(_S572.shown_3.is_warp_2)
    {
        _S573 = _S572.crossing_2.warp_2.thread_0 * 2U + 1U;
    }
    else
    {
        _S573 = _S572.crossing_2.weft_2.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S573;
    Crossing_0 _S574 = _S572.crossing_2;
    float _S575 = cell_maximum_0(_S566, &_S574);
    (&probe_1)->cell_max_0 = _S575;
    float _S576;
    if(_S570)
    {
        _S576 = _S572.crossing_2.warp_2.above_0;
    }
    else
    {
        _S576 = _S572.crossing_2.warp_2.below_0;
    }
    (&probe_1)->side_x_0 = _S576;
    if(_S571)
    {
        _S576 = _S572.crossing_2.weft_2.above_0;
    }
    else
    {
        _S576 = _S572.crossing_2.weft_2.below_0;
    }
    (&probe_1)->side_y_0 = _S576;
    bool _S577 = !_S572.shown_3.is_warp_2;
    Cell_0 _S578 = _S572.crossing_2.warp_2;
    Shown_0 _S579 = _S572.shown_3;
    Run_0 _S580 = _S572.run_3;
    float _S581 = outline_distance_0(&_S578, &_S579, &_S580, _S577, _S570);
    (&probe_1)->edge_x_0 = _S581;
    Cell_0 _S582 = _S572.crossing_2.weft_2;
    Shown_0 _S583 = _S572.shown_3;
    Run_0 _S584 = _S572.run_3;
    float _S585 = outline_distance_0(&_S582, &_S583, &_S584, _S572.shown_3.is_warp_2, _S571);
    (&probe_1)->edge_y_0 = _S585;
    return probe_1;
}

__device__ bool is_free_0(uint _S586, SearchQuality_0 * _S587, float3  _S588, float3  _S589, bool _S590, float _S591)
{
    float _S592 = _S589.z;
    if(_S592 <= 0.0f)
    {
        return false;
    }
    float _S593 = _S587->shadow_share_0;
    float _S594 = steps_per_length_0(_S586, _S587, _S589);
    float _S595 = 1.0f / (F32_max((_S593 * _S594), (9.99999971718068537e-10f)));
    StepControl_0 _S596 = step_control_0(float2 {_S589.x, _S589.y}, _S595);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S597;
        if(count_3 < 1024U)
        {
            _S597 = (_S588.z + _S592 * distance_1) < _S591;
        }
        else
        {
            _S597 = false;
        }
        if(_S597)
        {
        }
        else
        {
            break;
        }
        float3  _S598 = _S588 + _S589 * make_float3 (distance_1);
        Probe_0 _S599 = probe_0(_S586, _S598.x, _S598.y, _S590, _S596.right_1, _S596.up_0);
        float _S600 = _S598.z;
        float _S601 = _S600 - _S599.height_4;
        float _S602 = _S592 - _S599.slope_x_0 * _S589.x - _S599.slope_y_0 * _S589.y;
        bool _S603;
        if(!_S599.hole_4)
        {
            _S603 = _S601 < 0.0f;
        }
        else
        {
            _S603 = false;
        }
        if(_S603)
        {
            return false;
        }
        PreviousSample_0 _S604 = previous_3;
        Probe_0 _S605 = _S599;
        float _S606 = way_back_to_dip_0(&_S604, _S601, _S602, last_step_0, &_S605);
        if(_S606 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S606;
            distance_1 = distance_1 - _S606;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S607 = _S600 > (_S599.cell_max_0);
        Probe_0 _S608 = _S599;
        PreviousSample_0 _S609 = after_sample_0(_S601, _S602, &_S608, _S607);
        float last_step_2;
        if(_S607)
        {
            StepControl_0 _S610 = _S596;
            float _S611 = StepControl_to_cell_exit_0(&_S610, _S599.side_x_0, _S599.side_y_0);
            last_step_2 = (F32_max((_S611), (_S595)));
        }
        else
        {
            StepControl_0 _S612 = _S596;
            Probe_0 _S613 = _S599;
            float _S614 = StepControl_to_next_sample_0(&_S612, &_S613, _S601, _S602);
            last_step_2 = _S614;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S609;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S615, SearchQuality_0 * _S616, float _S617, float _S618, float3  _S619, bool _S620)
{
    Fabric_0 * _S621 = (&(globalParams_0->fabrics_0)[_S615]);
    Sample_0 _S622 = sample_at_0(_S615, _S617, _S618, _S620);
    if(!_S622.shown_3.hole_3)
    {
        return false;
    }
    float3  _S623 = make_float3 (_S617, _S618, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S624;
        if(side_0 < 2U)
        {
            _S624 = passes_0;
        }
        else
        {
            _S624 = false;
        }
        if(_S624)
        {
        }
        else
        {
            break;
        }
        float3  _S625;
        if(side_0 == 0U)
        {
            _S625 = _S619;
        }
        else
        {
            _S625 = make_float3 (- _S619.x, - _S619.y, _S619.z);
        }
        bool _S626 = _S620 != (side_0 == 1U);
        float _S627 = __ldg(&_S621->height_high_0);
        bool _S628 = is_free_0(_S615, _S616, _S623, _S625, _S626, _S627);
        uint _S629 = side_0 + 1U;
        passes_0 = _S628;
        side_0 = _S629;
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

__device__ float max_height_along_0(uint _S630, float _S631, float _S632, float _S633, float3  _S634, bool _S635)
{
    Fabric_0 * _S636 = (&(globalParams_0->fabrics_0)[_S630]);
    uint _S637 = __ldg(&_S636->warp_0);
    uint _S638 = locate_0(_S637, _S631).thread_0 / 2U;
    uint _S639 = __ldg(&_S636->weft_0);
    uint _S640 = locate_0(_S639, _S632).thread_0 / 2U;
    float _S641 = _S634.x;
    uint _S642;
    if(_S641 > 0.0f)
    {
        _S642 = 1U;
    }
    else
    {
        _S642 = 0U;
    }
    float _S643 = _S634.y;
    uint _S644;
    if(_S643 > 0.0f)
    {
        _S644 = 2U;
    }
    else
    {
        _S644 = 0U;
    }
    uint _S645 = _S642 + _S644;
    uint _S646 = __ldg(&_S636->max_heights_0);
    uint _S647 = __ldg(&_S636->max_height_columns_0);
    uint _S648 = __ldg((&(globalParams_0->words_0)[_S646 + 4U * (_S640 * _S647 + _S638) + _S645]));
    int number_0;
    if(_S635)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S649 = _S648 >> number_0;
    float _S650 = (F32_abs((_S641)));
    float _S651 = __ldg(&_S636->threads_per_x_0);
    float _S652 = _S650 * _S651;
    float _S653 = (F32_abs((_S643)));
    float _S654 = __ldg(&_S636->threads_per_y_0);
    float _S655 = (F32_max((_S652), (_S653 * _S654))) / _S634.z;
    float _S656 = __ldg(&_S636->height_high_0);
    float max_height_0 = _S656;
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
        if(((max_height_0 - _S633) * _S655) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S649 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S656)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S657, float _S658, float _S659, bool _S660, bool _S661, bool _S662)
{
    Crossing_0 _S663 = crossing_at_0(_S657, _S658, _S659, _S660);
    Crossing_0 _S664 = _S663;
    float _S665 = cell_maximum_0(_S657, &_S664);
    float _S666;
    if(_S661)
    {
        _S666 = _S663.warp_2.above_0;
    }
    else
    {
        _S666 = _S663.warp_2.below_0;
    }
    float _S667;
    if(_S662)
    {
        _S667 = _S663.weft_2.above_0;
    }
    else
    {
        _S667 = _S663.weft_2.below_0;
    }
    return make_float3 (_S665, _S666, _S667);
}

__device__ float first_sample_height_0(uint _S668, ViewRay_0 * _S669, StepControl_0 * _S670, bool _S671)
{
    float _S672 = max_height_along_0(_S668, _S669->origin_0.x, _S669->origin_0.y, 0.0f, make_float3 (_S669->slope_1.x, _S669->slope_1.y, 1.0f), _S671);
    uint count_4 = 0U;
    float height_9 = _S672;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S673 = ViewRay_at_0(_S669, height_9);
        float3  _S674 = cell_bounds_0(_S668, _S673.x, _S673.y, _S671, _S670->right_1, _S670->up_0);
        float _S675 = height_9 - _S674.x;
        float _S676 = StepControl_to_cell_exit_0(_S670, _S674.y, _S674.z);
        float height_10 = height_9 - clamp_1(_S675, 0.0f, _S676);
        if(_S675 <= _S676)
        {
            height_9 = height_10;
            break;
        }
        count_4 = count_4 + 1U;
        height_9 = height_10;
    }
    return height_9;
}

__device__ ViewRayEnd_0 search_down_0(uint _S677, ViewRay_0 * _S678, StepControl_0 * _S679, bool _S680)
{
    Fabric_0 * _S681 = (&(globalParams_0->fabrics_0)[_S677]);
    float _S682 = __ldg(&_S681->height_low_0);
    float _S683 = __ldg(&_S681->height_high_0);
    float _S684 = _S682 - (_S683 - _S682);
    ViewRayEnd_0 end_1;
    float _S685 = first_sample_height_0(_S677, _S678, _S679, _S680);
    (&end_1)->height_8 = _S685;
    (&end_1)->last_step_3 = _S679->epsilon_0;
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
        float2  _S686 = ViewRay_at_0(_S678, (&end_1)->height_8);
        Probe_0 _S687 = probe_0(_S677, _S686.x, _S686.y, _S680, _S679->right_1, _S679->up_0);
        float _S688 = (&end_1)->height_8 - _S687.height_4;
        Probe_0 _S689 = _S687;
        float _S690 = ViewRay_rate_0(_S678, &_S689);
        (&end_1)->depth_1 = - _S688;
        (&end_1)->rate_4 = _S690;
        bool _S691;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S691 = !_S687.hole_4;
        }
        else
        {
            _S691 = false;
        }
        bool _S692;
        if(_S691)
        {
            _S692 = ((&(&end_1)->previous_4)->yarn_0) == (_S687.yarn_1);
        }
        else
        {
            _S692 = false;
        }
        (&end_1)->smooth_0 = _S692;
        bool _S693;
        if(!_S687.hole_4)
        {
            _S693 = _S688 <= 0.0f;
        }
        else
        {
            _S693 = false;
        }
        bool _S694;
        if(_S693)
        {
            _S694 = true;
        }
        else
        {
            _S694 = ((&end_1)->height_8) <= _S684;
        }
        if(_S694)
        {
            break;
        }
        PreviousSample_0 _S695 = (&end_1)->previous_4;
        Probe_0 _S696 = _S687;
        float _S697 = way_back_to_dip_0(&_S695, _S688, _S690, (&end_1)->last_step_3, &_S696);
        if(_S697 >= 0.0f)
        {
            (&end_1)->height_8 = (&end_1)->height_8 + _S697;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S697;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S698 = StepControl_to_cell_exit_0(_S679, _S687.side_x_0, _S687.side_y_0);
        float _S699 = (F32_min((_S698), ((&end_1)->height_8 - _S687.cell_max_0)));
        Probe_0 _S700 = _S687;
        float _S701 = StepControl_to_next_sample_0(_S679, &_S700, _S688, _S690);
        bool _S702 = _S699 > _S701;
        Probe_0 _S703 = _S687;
        PreviousSample_0 _S704 = after_sample_0(_S688, _S690, &_S703, _S702);
        (&end_1)->previous_4 = _S704;
        float _S705 = (F32_max((_S699), (_S701)));
        (&end_1)->last_step_3 = _S705;
        (&end_1)->height_8 = (&end_1)->height_8 - _S705;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S706, ViewRay_0 * _S707, StepControl_0 * _S708, bool _S709, ViewRayEnd_0 * _S710, uint _S711)
{
    Fabric_0 * _S712 = (&(globalParams_0->fabrics_0)[_S706]);
    float _S713 = __ldg(&_S712->height_high_0);
    float _S714 = __ldg(&_S712->height_low_0);
    float _S715 = _S713 - _S714;
    float _S716 = _S710->height_8;
    float _S717 = _S710->last_step_3;
    float above_2 = _S710->height_8 + _S710->last_step_3;
    float above_gap_1 = clamp_1((&_S710->previous_4)->clearance_0, 0.0f, _S715);
    float under_gap_1 = clamp_1(_S710->depth_1, 0.0f, _S715);
    float _S718 = cubic_root_0(above_gap_1, - under_gap_1, (&_S710->previous_4)->rate_0 * _S710->last_step_3, _S710->rate_4 * _S710->last_step_3);
    bool _S719 = _S710->smooth_0;
    float middle_0;
    if(_S710->smooth_0)
    {
        middle_0 = above_2 - _S718 * _S717;
    }
    else
    {
        middle_0 = between_0(above_2, _S716, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S716;
    float above_3 = above_2;
    uint i_10 = 0U;
    for(;;)
    {
        if(i_10 < _S711)
        {
        }
        else
        {
            break;
        }
        float2  _S720 = ViewRay_at_0(_S707, middle_0);
        Probe_0 _S721 = probe_0(_S706, _S720.x, _S720.y, _S709, _S708->right_1, _S708->up_0);
        float _S722;
        if(_S721.hole_4)
        {
            _S722 = -1.0e+09f;
        }
        else
        {
            _S722 = _S721.height_4;
        }
        float _S723 = clamp_1(middle_0 - _S722, - _S715, _S715);
        float _S724;
        if(_S723 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S724 = 0.5f * above_gap_2;
            }
            else
            {
                _S724 = above_gap_2;
            }
            float _S725 = - _S723;
            under_1 = middle_0;
            above_gap_2 = _S724;
            under_gap_2 = _S725;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S724 = 0.5f * under_gap_2;
            }
            else
            {
                _S724 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S723;
            under_gap_2 = _S724;
            side_1 = -1.0f;
        }
        if(_S719)
        {
            Probe_0 _S726 = _S721;
            float _S727 = ViewRay_rate_0(_S707, &_S726);
            middle_0 = clamp_1(middle_0 + _S723 / (F32_min((_S727), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_10 = i_10 + 1U;
    }
    if(_S719)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S728, SearchQuality_0 * _S729, float _S730, float _S731, float3  _S732, bool _S733)
{
    float _S734 = (F32_max((_S732.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S730, _S731);
    float2  _S735 = float2 {_S732.x, _S732.y} / make_float2 (_S734);
    (&ray_0)->slope_1 = _S735;
    float2  _S736 = - _S735;
    float _S737 = steps_per_length_0(_S728, _S729, _S732);
    StepControl_0 _S738 = step_control_0(_S736, 1.0f / (F32_max((_S737 / _S734), (9.99999971718068537e-10f))));
    ViewRay_0 _S739 = ray_0;
    StepControl_0 _S740 = _S738;
    ViewRayEnd_0 _S741 = search_down_0(_S728, &_S739, &_S740, _S733);
    Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    ViewRay_0 _S742 = ray_0;
    StepControl_0 _S743 = _S738;
    ViewRayEnd_0 _S744 = _S741;
    float _S745 = refined_height_0(_S728, &_S742, &_S743, _S733, &_S744, _S729->refinements_0);
    (&hit_0)->height_6 = _S745;
    ViewRay_0 _S746 = ray_0;
    float2  _S747 = ViewRay_at_0(&_S746, _S745);
    (&hit_0)->x_32 = _S747.x;
    (&hit_0)->y_17 = _S747.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S748, SearchQuality_0 * _S749, float _S750, float _S751, float3  _S752, bool _S753)
{
    bool _S754 = passes_through_0(_S748, _S749, _S750, _S751, _S752, _S753);
    if(!_S754)
    {
        Hit_0 _S755 = first_hit_of_yarn_0(_S748, _S749, _S750, _S751, _S752, _S753);
        return _S755;
    }
    Hit_0 hit_1;
    (&hit_1)->x_32 = _S750;
    (&hit_1)->y_17 = _S751;
    (&hit_1)->height_6 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S756, float _S757, float _S758, bool _S759)
{
    Fabric_0 * _S760 = (&(globalParams_0->fabrics_0)[_S756]);
    Sample_0 _S761 = sample_at_0(_S756, _S757, _S758, _S759);
    float _S762;
    if(_S761.shown_3.is_warp_2)
    {
        _S762 = _S761.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S762 = _S761.crossing_2.weft_2.half_width_1;
    }
    uint _S763;
    if(_S761.shown_3.is_warp_2)
    {
        uint _S764 = __ldg(&_S760->warp_0);
        _S763 = _S764;
    }
    else
    {
        uint _S765 = __ldg(&_S760->weft_0);
        _S763 = _S765;
    }
    float _S766 = __ldg(&(&(globalParams_0->families_0)[_S763])->twist_sine_0);
    float _S767;
    if(_S759)
    {
        _S767 = -1.0f;
    }
    else
    {
        _S767 = 1.0f;
    }
    float _S768 = _S766 * _S767;
    float _S769 = __ldg(&(&(globalParams_0->families_0)[_S763])->twist_cosine_0);
    if(_S761.shown_3.is_warp_2)
    {
        _S767 = 1.0f;
    }
    else
    {
        _S767 = -1.0f;
    }
    float2  _S770 = fibre_direction_0(_S761.slope_across_0, _S767 * _S761.slope_along_0, _S768, _S769);
    float _S771;
    if(_S761.shown_3.is_warp_2)
    {
        _S771 = _S761.slope_x_1;
    }
    else
    {
        _S771 = _S761.slope_y_1;
    }
    float _S772;
    if(_S761.shown_3.is_warp_2)
    {
        _S772 = _S761.slope_y_1;
    }
    else
    {
        _S772 = _S761.slope_x_1;
    }
    float _S773 = _S770.x;
    float _S774 = _S770.y;
    float _S775 = _S771 * _S773 + _S767 * _S772 * _S774;
    float _S776 = _S762 * 1.0154266357421875f;
    float _S777 = _S776 * arc_sine_0(clamp_1(_S761.section_1.across_3 / _S776, -1.0f, 1.0f));
    if(_S761.shown_3.is_warp_2)
    {
        _S762 = _S758;
    }
    else
    {
        _S762 = - _S757;
    }
    SurfacePoint_0 point_1;
    (&point_1)->hole_0 = _S761.shown_3.hole_3;
    (&point_1)->is_warp_0 = _S761.shown_3.is_warp_2;
    (&point_1)->warp_thread_0 = _S761.crossing_2.warp_2.thread_0;
    (&point_1)->weft_thread_0 = _S761.crossing_2.weft_2.thread_0;
    (&point_1)->height_2 = _S761.height_7;
    (&point_1)->normal_0 = normalize_0(make_float3 (- _S761.slope_x_1, - _S761.slope_y_1, 1.0f));
    float3  _S778;
    if(_S761.shown_3.is_warp_2)
    {
        _S778 = make_float3 (_S773, _S774, _S775);
    }
    else
    {
        _S778 = make_float3 (- _S774, _S773, _S775);
    }
    (&point_1)->tangent_0 = normalize_0(_S778);
    (&point_1)->across_0 = _S761.section_1.across_3;
    (&point_1)->fibre_across_0 = _S777 * _S769 + _S762 * _S768;
    (&point_1)->fibre_along_0 = _S762 * _S769 - _S777 * _S768;
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

__device__ bool has_hairs_0(uint _S779)
{
    Fabric_0 * _S780 = (&(globalParams_0->fabrics_0)[_S779]);
    uint _S781 = __ldg(&_S780->warp_0);
    float _S782 = __ldg(&(&(globalParams_0->families_0)[_S781])->hairiness_0);
    bool _S783;
    if(_S782 > 0.0f)
    {
        _S783 = true;
    }
    else
    {
        uint _S784 = __ldg(&_S780->weft_0);
        float _S785 = __ldg(&(&(globalParams_0->families_0)[_S784])->hairiness_0);
        _S783 = _S785 > 0.0f;
    }
    return _S783;
}

__device__ Hair_0 hair_at_0(uint _S786, float2  _S787, bool _S788, float _S789)
{
    Fabric_0 * _S790 = (&(globalParams_0->fabrics_0)[_S786]);
    float _S791 = __ldg(&_S790->fibre_size_0);
    float _S792 = 17.0f * _S791;
    float _S793 = fade_0(_S789, _S792);
    float2  _S794 = _S787 / make_float2 (_S792);
    uint number_1;
    if(_S788)
    {
        number_1 = 1U;
    }
    else
    {
        number_1 = 0U;
    }
    uint _S795 = __ldg(&_S790->seed_0);
    uint _S796 = hash_key_0(number_1, _S795 ^ 1013904242U);
    float _S797 = 1.0f / (F32_max((_S789), (0.07999999821186066f * _S791)));
    float _S798 = (F32_min((0.63999998569488525f * _S791 * _S797), (1.0f)));
    float2  _S799 = make_float2 (0.0f, 1.0f);
    float cover_2 = 0.0f;
    float hair_away_0 = 0.0f;
    float2  hair_across_0 = _S799;
    number_1 = 0U;
    for(;;)
    {
        bool _S800;
        if(_S793 > 0.0f)
        {
            _S800 = number_1 < 18U;
        }
        else
        {
            _S800 = false;
        }
        if(_S800)
        {
        }
        else
        {
            break;
        }
        uint _S801 = number_1 / 9U;
        uint _S802 = number_1 / 3U - 3U * _S801;
        float2  _S803 = floor_0(_S794) + make_float2 (float(number_1 - 3U * _S802 - 9U * _S801), float(_S802)) - make_float2 (1.0f);
        uint _S804 = hash_bits_0(_S796 + _S801, uint(int(_S803.x)) * 65536U + uint(int(_S803.y)));
        uint _S805 = hash_bits_0(_S796, _S804);
        float2  _S806 = _S794 - _S803 - make_float2 (share_of_0(_S804), share_of_0(_S804 >> int(10)));
        float2  _S807 = sine_cosine_0(3.14159274101257324f * share_of_0(_S804 >> int(20)));
        float _S808 = lerp_1(5.0f, 16.0f, share_of_0(_S805 >> int(10))) / 17.0f;
        float _S809 = _S806.x;
        float _S810 = _S807.y;
        float _S811 = _S806.y;
        float _S812 = _S807.x;
        float _S813 = (_S809 * _S810 + _S811 * _S812) / _S808;
        float _S814 = 0.69999998807907104f * (2.0f * share_of_0(_S805 >> int(20)) - 1.0f);
        float _S815 = 2.0f * _S814 * _S813;
        float _S816 = (F32_rsqrt((_S815 * _S815 + 1.0f)));
        float _S817 = (_S811 * _S810 - _S809 * _S812 - _S814 * _S808 * _S813 * _S813) * _S816 * 17.0f;
        float _S818 = clamp_1((0.31999999284744263f - (F32_abs((_S817)))) * _S791 * _S797 + 0.5f, 0.0f, _S798);
        uint _S819;
        if(((_S805 >> int(30)) & 1U) == 1U)
        {
            uint _S820 = __ldg(&_S790->warp_0);
            _S819 = _S820;
        }
        else
        {
            uint _S821 = __ldg(&_S790->weft_0);
            _S819 = _S821;
        }
        float _S822 = share_of_0(_S805);
        float _S823 = __ldg(&(&(globalParams_0->families_0)[_S819])->hairiness_0);
        bool _S824;
        if(_S822 < _S823)
        {
            _S824 = (F32_abs((_S813))) < 1.0f;
        }
        else
        {
            _S824 = false;
        }
        bool _S825;
        if(_S824)
        {
            _S825 = _S818 > cover_2;
        }
        else
        {
            _S825 = false;
        }
        if(_S825)
        {
            float2  _S826 = make_float2 (- _S812 - _S815 * _S810, _S810 - _S815 * _S812) * make_float2 (_S816);
            cover_2 = _S818;
            hair_away_0 = _S817;
            hair_across_0 = _S826;
        }
        number_1 = number_1 + 1U;
    }
    float _S827 = clamp_1(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    Hair_0 hair_1;
    (&hair_1)->cover_0 = _S793 * cover_2;
    (&hair_1)->normal_2 = make_float3 ((make_float2 (_S827) * hair_across_0).x, (make_float2 (_S827) * hair_across_0).y, (F32_sqrt((1.0f - _S827 * _S827))));
    (&hair_1)->tangent_2 = make_float3 (hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

__device__ uint thread_number_0(uint _S828, SurfacePoint_0 * _S829, float _S830, float _S831)
{
    Fabric_0 * _S832 = (&(globalParams_0->fabrics_0)[_S828]);
    bool _S833 = _S829->is_warp_0;
    float _S834;
    if(_S829->is_warp_0)
    {
        _S834 = _S830;
    }
    else
    {
        _S834 = _S831;
    }
    float _S835 = _S834 - _S829->across_0;
    uint _S836;
    if(_S833)
    {
        uint _S837 = __ldg(&_S832->warp_0);
        _S836 = _S837;
    }
    else
    {
        uint _S838 = __ldg(&_S832->weft_0);
        _S836 = _S838;
    }
    float _S839 = __ldg(&(&(globalParams_0->families_0)[_S836])->period_0);
    float _S840 = __ldg(&(&(globalParams_0->families_0)[_S836])->count_0);
    int _S841 = int(_S840);
    if(_S833)
    {
        _S836 = _S829->warp_thread_0;
    }
    else
    {
        _S836 = _S829->weft_thread_0;
    }
    uint _S842 = uint(int((F32_floor((_S835 / _S839)))) * _S841 + int(_S836)) * 2U;
    if(_S833)
    {
        _S836 = 1U;
    }
    else
    {
        _S836 = 0U;
    }
    return _S842 + _S836;
}

struct FibreNoise_0
{
    float2  bundle_0;
    float bundle_weight_0;
    float2  fibre_0;
    float fibre_weight_0;
    float offset_1;
    float slope_2;
};

__device__ FibreNoise_0 fibre_noise_at_0(uint _S843, uint _S844, SurfacePoint_0 * _S845, uint _S846, float _S847)
{
    Fabric_0 * _S848 = (&(globalParams_0->fabrics_0)[_S843]);
    float _S849 = __ldg(&_S848->fibre_size_0);
    float _S850 = 5.0f * _S849;
    uint _S851 = __ldg(&_S848->seed_0);
    float _S852 = _S845->fibre_along_0;
    float2  _S853 = wave_noise_0(hash_key_0(_S846, _S851 ^ 458671337U), _S845->fibre_along_0 / (25.0f * _S849));
    float _S854 = _S845->fibre_across_0;
    float _S855 = __ldg(&(&(globalParams_0->families_0)[_S844])->fibre_tilt_0);
    float _S856 = _S854 + _S855 * 0.5f * 25.0f * _S849 * _S853.x;
    float3  _S857 = fibre_cell_0(_S856, _S852, _S849);
    FibreNoise_0 noise_0;
    (&noise_0)->bundle_0 = cell_noise_0(hash_key_0(_S846, _S851 ^ 1757159915U), fibre_cell_0(_S856, _S852, _S850));
    (&noise_0)->bundle_weight_0 = fade_0(_S847, _S850);
    (&noise_0)->fibre_0 = cell_noise_0(hash_key_0(_S846, _S851 ^ 48610963U), _S857);
    (&noise_0)->fibre_weight_0 = fade_0(_S847, _S849);
    (&noise_0)->offset_1 = _S857.z;
    (&noise_0)->slope_2 = 0.5f * _S853.y;
    return noise_0;
}

__device__ float2  detail_gain_0(uint _S858, uint _S859, SurfacePoint_0 * _S860, float2  _S861, bool _S862, uint _S863, float _S864)
{
    Fabric_0 * _S865 = (&(globalParams_0->fabrics_0)[_S858]);
    float2  _S866 = make_float2 (0.0f);
    float _S867 = __ldg(&(&(globalParams_0->families_0)[_S859])->has_plies_0);
    float2  gain_2;
    if(_S867 > 0.0f)
    {
        float _S868 = __ldg(&(&(globalParams_0->families_0)[_S859])->plies_per_mm_0);
        float _S869 = 0.60000002384185791f * fade_0(_S864, 1.0f / _S868);
        float _S870 = ply_offset_0(_S859, _S860, _S862);
        gain_2 = make_float2 (_S869) * make_float2 (0.20000000298023224f - square_0(square_0(_S870)), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S866;
    }
    float _S871 = __ldg(&(&(globalParams_0->families_0)[_S859])->fibre_tone_0);
    if(_S871 > 0.0f)
    {
        FibreNoise_0 _S872 = fibre_noise_at_0(_S858, _S859, _S860, _S863, _S864);
        float _S873 = __ldg(&(&(globalParams_0->families_0)[_S859])->fibre_tone_0);
        gain_2 = gain_2 + make_float2 (_S873) * make_float2 (_S872.bundle_weight_0 * _S872.bundle_0.y + _S872.fibre_weight_0 * _S872.fibre_0.y, _S872.bundle_weight_0 + _S872.fibre_weight_0);
    }
    float _S874 = __ldg(&(&(globalParams_0->families_0)[_S859])->slub_0);
    if(_S874 > 0.0f)
    {
        float _S875 = __ldg(&(&(globalParams_0->families_0)[_S859])->slub_0);
        float _S876 = 0.25f * _S875;
        float _S877 = __ldg(&(&(globalParams_0->families_0)[_S859])->slubs_per_mm_0);
        float _S878 = _S876 * fade_0(_S864, 1.0f / _S877);
        float _S879;
        if(_S860->is_warp_0)
        {
            _S879 = _S861.y;
        }
        else
        {
            _S879 = - _S861.x;
        }
        uint _S880 = __ldg(&_S865->seed_0);
        uint _S881 = hash_key_0(_S863, _S880 ^ 1373058189U);
        float _S882 = __ldg(&(&(globalParams_0->families_0)[_S859])->slubs_per_mm_0);
        float2  _S883 = wave_noise_0(_S881, _S879 * _S882);
        float _S884 = _S860->across_0;
        float _S885 = __ldg(&(&(globalParams_0->families_0)[_S859])->per_half_width_0);
        gain_2 = gain_2 + make_float2 (_S878) * make_float2 (_S883.x * lerp_1(0.40000000596046448f, 1.0f, (F32_min((square_0(_S884 * _S885)), (1.0f)))), 1.0f);
    }
    return gain_2;
}

__device__ Albedos_0 vary_albedos_0(uint _S886, Albedos_0 * _S887, uint _S888, uint _S889, float2  _S890)
{
    Fabric_0 * _S891 = (&(globalParams_0->fabrics_0)[_S886]);
    float3  _S892 = _S887->specular_reflect_0;
    float3  _S893 = _S887->specular_transmit_0;
    float3  _S894 = max_0(_S887->specular_reflect_0, _S887->specular_transmit_0);
    float3  _S895 = _S887->diffuse_reflect_0;
    float3  _S896 = _S887->diffuse_transmit_0;
    float3  _S897 = _S887->diffuse_reflect_0 + _S887->diffuse_transmit_0;
    float _S898 = __ldg(&_S891->layer_bound_0);
    float3  _S899 = make_float3 (1.0f) - make_float3 (_S898) * _S894;
    float _S900 = __ldg(&_S891->colour_noise_0);
    uint _S901 = __ldg(&_S891->seed_0);
    float colour_0 = bounded_gain_0(thread_gain_0(_S888, _S900, _S901), _S897, _S899);
    float colour_1 = colour_0 * (1.0f + flattened_0(_S890.y, make_float3 (colour_0) * _S897, _S899) * _S890.x);
    float3  _S902 = min_0((make_float3 (1.0f) - make_float3 (colour_1) * _S897) / make_float3 (_S898), make_float3 (1.0f));
    float _S903 = __ldg(&_S891->fibre_noise_0);
    float _S904 = bounded_gain_0(fibre_gain_0(_S888, _S889, _S903, _S901), _S894, _S902);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (colour_1) * _S895;
    (&varied_0)->diffuse_transmit_0 = make_float3 (colour_1) * _S896;
    (&varied_0)->specular_reflect_0 = make_float3 (_S904) * _S892;
    (&varied_0)->specular_transmit_0 = make_float3 (_S904) * _S893;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S905, SurfacePoint_0 * _S906, Albedos_0 * _S907, float _S908, float _S909, bool _S910, float _S911, float _S912)
{
    Fabric_0 * _S913 = (&(globalParams_0->fabrics_0)[_S905]);
    uint _S914 = thread_number_0(_S905, _S906, _S908, _S909);
    float _S915 = _S906->fibre_across_0;
    float _S916 = _S906->fibre_along_0;
    float _S917 = __ldg(&_S913->fibre_size_0);
    float3  _S918 = fibre_cell_0(_S915, _S916, _S917);
    float2  _S919 = make_float2 (0.0f);
    uint _S920 = __ldg(&_S913->has_detail_0);
    bool _S921;
    if(_S920 != 0U)
    {
        _S921 = _S911 >= 0.0f;
    }
    else
    {
        _S921 = false;
    }
    float2  gain_3;
    if(_S921)
    {
        uint _S922;
        if(_S906->is_warp_0)
        {
            uint _S923 = __ldg(&_S913->warp_0);
            _S922 = _S923;
        }
        else
        {
            uint _S924 = __ldg(&_S913->weft_0);
            _S922 = _S924;
        }
        float2  _S925 = detail_gain_0(_S905, _S922, _S906, make_float2 (_S908, _S909), _S910, _S914, _S911);
        gain_3 = _S925 * make_float2 (1.0f - _S912, 1.0f);
    }
    else
    {
        gain_3 = _S919;
    }
    Albedos_0 _S926 = vary_albedos_0(_S905, _S907, _S914, uint(int(_S918.x)) * 65536U + uint(int((F32_floor((_S918.y))))), gain_3);
    return _S926;
}

__device__ YarnFrame_0 turned_frame_0(uint _S927, uint _S928, SurfacePoint_0 * _S929, bool _S930, uint _S931, float _S932)
{
    YarnFrame_0 frame_2;
    (&frame_2)->normal_4 = _S929->normal_0;
    (&frame_2)->tangent_4 = _S929->tangent_0;
    (&frame_2)->loss_0 = 0.0f;
    float _S933 = __ldg(&(&(globalParams_0->families_0)[_S928])->has_plies_0);
    if(_S933 > 0.0f)
    {
        float _S934 = __ldg(&(&(globalParams_0->families_0)[_S928])->plies_per_mm_0);
        float _S935 = fade_0(_S932, 1.0f / _S934);
        float _S936 = _S935 * 0.41999998688697815f;
        float _S937 = ply_offset_0(_S928, _S929, _S930);
        float _S938 = _S936 * _S937;
        float _S939 = (F32_sqrt((1.0f - _S938 * _S938)));
        float _S940;
        if(_S930)
        {
            float _S941 = __ldg(&(&(globalParams_0->families_0)[_S928])->ply_sine_0);
            _S940 = - _S941;
        }
        else
        {
            float _S942 = __ldg(&(&(globalParams_0->families_0)[_S928])->ply_sine_0);
            _S940 = _S942;
        }
        float _S943 = __ldg(&(&(globalParams_0->families_0)[_S928])->ply_cosine_0);
        float3  _S944 = cross_0((&frame_2)->tangent_4, (&frame_2)->normal_4);
        float3  _S945 = make_float3 (_S943) * _S944 + make_float3 (_S940) * (&frame_2)->tangent_4;
        (&frame_2)->tangent_4 = make_float3 (_S943) * (make_float3 (_S943) * (&frame_2)->tangent_4 - make_float3 (_S940) * _S944) + make_float3 (_S940) * (make_float3 (_S939) * _S945 - make_float3 (_S938) * (&frame_2)->normal_4);
        (&frame_2)->normal_4 = make_float3 (_S939) * (&frame_2)->normal_4 + make_float3 (_S938) * _S945;
        (&frame_2)->loss_0 = _S935 * _S935 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    float _S946 = __ldg(&(&(globalParams_0->families_0)[_S928])->fibre_tilt_0);
    if(_S946 > 0.0f)
    {
        FibreNoise_0 _S947 = fibre_noise_at_0(_S927, _S928, _S929, _S931, _S932);
        float _S948 = 1.09858846664428711f * _S946 * (_S947.bundle_weight_0 * _S947.bundle_0.x + _S947.fibre_weight_0 * (_S947.fibre_0.x + _S947.offset_1));
        float _S949 = _S946 * (1.42099642753601074f * (_S947.bundle_weight_0 * _S947.bundle_0.y + _S947.fibre_weight_0 * _S947.fibre_0.y) - _S947.bundle_weight_0 * _S947.slope_2);
        float _S950 = square_0(_S947.fibre_weight_0);
        (&frame_2)->loss_0 = (&frame_2)->loss_0 + 0.5f * _S946 * _S946 * ((0.24761904776096344f * (square_0(_S947.bundle_weight_0) + _S950) + _S950 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        float3  _S951 = cross_0((&frame_2)->tangent_4, (&frame_2)->normal_4);
        float2  _S952 = sine_cosine_0(_S948);
        float2  _S953 = sine_cosine_0(_S949);
        float _S954 = _S952.y;
        float _S955 = _S952.x;
        float3  _S956 = make_float3 (_S954) * _S951 - make_float3 (_S955) * (&frame_2)->normal_4;
        (&frame_2)->normal_4 = make_float3 (_S954) * (&frame_2)->normal_4 + make_float3 (_S955) * _S951;
        (&frame_2)->tangent_4 = make_float3 (_S953.y) * (&frame_2)->tangent_4 + make_float3 (_S953.x) * _S956;
    }
    return frame_2;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S957, SurfacePoint_0 * _S958, float _S959, float _S960, bool _S961, bool _S962, float _S963)
{
    Fabric_0 * _S964 = (&(globalParams_0->fabrics_0)[_S957]);
    bool _S965 = _S958->is_warp_0;
    uint _S966;
    if(_S958->is_warp_0)
    {
        uint _S967 = __ldg(&_S964->warp_0);
        _S966 = _S967;
    }
    else
    {
        uint _S968 = __ldg(&_S964->weft_0);
        _S966 = _S968;
    }
    uint _S969 = __ldg(&_S964->has_detail_0);
    bool _S970;
    if(_S969 != 0U)
    {
        _S970 = _S963 >= 0.0f;
    }
    else
    {
        _S970 = false;
    }
    float3  _S971 = make_float3 (0.0f);
    Hair_0 _S972 = Hair_x24init_0(0.0f, _S971, _S971);
    bool _S973;
    if(_S970)
    {
        bool _S974 = has_hairs_0(_S957);
        _S973 = _S974;
    }
    else
    {
        _S973 = false;
    }
    Hair_0 hair_2;
    if(_S973)
    {
        Hair_0 _S975 = hair_at_0(_S957, make_float2 (_S959, _S960), _S961, _S963);
        hair_2 = _S975;
    }
    else
    {
        hair_2 = _S972;
    }
    uint _S976;
    if(_S965)
    {
        _S976 = _S958->warp_thread_0;
    }
    else
    {
        _S976 = _S958->weft_thread_0;
    }
    Albedos_0 albedos_7 = albedos_of_0(_S966, _S976);
    bool _S977 = varies_at_0(_S957, _S963);
    Albedos_0 albedos_8;
    if(_S977)
    {
        Albedos_0 _S978 = albedos_7;
        Albedos_0 _S979 = varied_at_0(_S957, _S958, &_S978, _S959, _S960, _S961, _S963, hair_2.cover_0);
        albedos_8 = _S979;
    }
    else
    {
        albedos_8 = albedos_7;
    }
    YarnPoint_0 point_2;
    (&point_2)->back_7 = _S961;
    (&point_2)->hole_6 = _S962;
    (&point_2)->is_warp_3 = _S965;
    (&point_2)->x_33 = _S959;
    (&point_2)->y_18 = _S960;
    (&point_2)->height_11 = _S958->height_2;
    (&point_2)->normal_9 = _S958->normal_0;
    (&point_2)->tangent_10 = _S958->tangent_0;
    (&point_2)->surface_normal_0 = _S958->normal_0;
    (&point_2)->diffuse_gain_1 = 1.0f;
    if(_S970)
    {
        uint _S980 = thread_number_0(_S957, _S958, _S959, _S960);
        YarnFrame_0 _S981 = turned_frame_0(_S957, _S966, _S958, _S961, _S980, _S963);
        bool _S982 = has_hairs_0(_S957);
        YarnFrame_0 frame_3;
        if(_S982)
        {
            YarnFrame_0 _S983 = _S981;
            Hair_0 _S984 = hair_2;
            YarnFrame_0 _S985 = under_hair_0(&_S983, &_S984);
            frame_3 = _S985;
        }
        else
        {
            frame_3 = _S981;
        }
        (&point_2)->normal_9 = frame_3.normal_4;
        (&point_2)->tangent_10 = frame_3.tangent_4;
        float _S986 = __ldg(&_S964->diffuse_blend_0);
        YarnFrame_0 _S987 = frame_3;
        float _S988 = diffuse_gain_0(&_S987, _S986);
        (&point_2)->diffuse_gain_1 = _S988;
    }
    float _S989 = __ldg(&(&(globalParams_0->families_0)[_S966])->roughness_0);
    (&point_2)->roughness_10 = _S989;
    (&point_2)->albedos_6 = albedos_8;
    return point_2;
}

__device__ bool unoccluded_0(uint _S990, SearchQuality_0 * _S991, float _S992, float _S993, float _S994, float3  _S995, bool _S996)
{
    Fabric_0 * _S997 = (&(globalParams_0->fabrics_0)[_S990]);
    if((_S995.z) <= 0.0f)
    {
        return false;
    }
    float _S998 = max_height_along_0(_S990, _S992, _S993, _S994, _S995, _S996);
    float _S999 = __ldg(&_S997->lift_0);
    bool _S1000 = is_free_0(_S990, _S991, make_float3 (_S992, _S993, _S994 + _S999), _S995, _S996, _S998);
    return _S1000;
}

__device__ bool is_lit_0(uint _S1001, SearchQuality_0 * _S1002, YarnPoint_0 * _S1003, float3  _S1004)
{
    if(_S1003->hole_6)
    {
        return true;
    }
    bool _S1005 = _S1003->back_7;
    float3  _S1006 = to_face_frame_0(_S1004, _S1003->back_7);
    float _S1007 = _S1006.z;
    bool _S1008 = _S1007 < 0.0f;
    float3  _S1009 = _S1003->surface_normal_0;
    float _S1010 = _S1003->height_11;
    float3  normal_10;
    float height_12;
    if(_S1008)
    {
        SurfacePoint_0 _S1011 = surface_at_0(_S1001, _S1003->x_33, _S1003->y_18, !_S1005);
        normal_10 = _S1011.normal_0;
        height_12 = _S1011.height_2;
    }
    else
    {
        normal_10 = _S1009;
        height_12 = _S1010;
    }
    float3  _S1012 = make_float3 (float2 {_S1006.x, _S1006.y}.x, float2 {_S1006.x, _S1006.y}.y, (F32_abs((_S1007))));
    if((dot_0(normal_10, _S1012)) <= 0.0f)
    {
        return false;
    }
    bool _S1013 = unoccluded_0(_S1001, _S1002, _S1003->x_33, _S1003->y_18, height_12, _S1012, _S1005 != _S1008);
    return _S1013;
}

__device__ Components_0 components_of_point_0(uint _S1014, SearchQuality_0 * _S1015, YarnPoint_0 * _S1016, float3  _S1017, float3  _S1018)
{
    Fabric_0 * _S1019 = (&(globalParams_0->fabrics_0)[_S1014]);
    Components_0 result_15 = no_components_0();
    bool _S1020 = _S1016->hole_6;
    float _S1021;
    if(_S1016->hole_6)
    {
        _S1021 = 1.0f;
    }
    else
    {
        _S1021 = 0.0f;
    }
    (&result_15)->hole_2 = _S1021;
    bool _S1022;
    if(_S1020)
    {
        _S1022 = true;
    }
    else
    {
        bool _S1023 = is_lit_0(_S1014, _S1015, _S1016, _S1017);
        _S1022 = !_S1023;
    }
    if(_S1022)
    {
        return result_15;
    }
    float3  _S1024 = to_face_frame_0(_S1017, _S1016->back_7);
    float3  _S1025 = to_face_frame_0(_S1018, _S1016->back_7);
    float _S1026 = _S1016->diffuse_gain_1;
    bool _S1027 = (_S1024.z) < 0.0f;
    float3  _S1028;
    if(_S1027)
    {
        _S1028 = - _S1024;
    }
    else
    {
        _S1028 = _S1024;
    }
    float3  _S1029 = _S1016->normal_9;
    float _S1030 = __ldg(&_S1019->diffuse_blend_0);
    float _S1031 = _S1026 * diffuse_reflection_0(_S1028, _S1029, _S1030);
    if(_S1027)
    {
        float3  _S1032 = _S1016->tangent_10;
        float _S1033 = _S1016->roughness_10;
        float _S1034 = __ldg(&_S1019->optical_depth_0);
        _S1021 = transmission_1(_S1024, _S1025, _S1029, _S1032, _S1033, _S1034);
    }
    else
    {
        float3  _S1035 = _S1016->tangent_10;
        float _S1036 = _S1016->roughness_10;
        float _S1037 = __ldg(&_S1019->optical_depth_0);
        _S1021 = reflection_0(_S1024, _S1025, _S1029, _S1035, _S1036, _S1037);
    }
    bool _S1038 = _S1016->is_warp_3;
    float _S1039;
    if(_S1016->is_warp_3)
    {
        _S1039 = _S1031;
    }
    else
    {
        _S1039 = 0.0f;
    }
    (&result_15)->diffuse_warp_0 = _S1039;
    if(_S1038)
    {
        _S1039 = 0.0f;
    }
    else
    {
        _S1039 = _S1031;
    }
    (&result_15)->diffuse_weft_0 = _S1039;
    if(_S1038)
    {
        _S1039 = _S1021;
    }
    else
    {
        _S1039 = 0.0f;
    }
    (&result_15)->specular_warp_0 = _S1039;
    if(_S1038)
    {
        _S1021 = 0.0f;
    }
    (&result_15)->specular_weft_0 = _S1021;
    (&result_15)->light_visibility_1 = 1.0f;
    return result_15;
}

__device__ float openness_number_0(uint _S1040, uint _S1041)
{
    uint _S1042 = __ldg(&(&(globalParams_0->fabrics_0)[_S1040])->openness_0);
    return table_number_0(_S1042 + _S1041);
}

__device__ Blocked_0 blocked_of_terms_0(uint _S1043, uint _S1044, FixedArray<float, 6>  * _S1045, uint _S1046)
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
            if(term_0 < _S1046)
            {
            }
            else
            {
                break;
            }
            float _S1047 = openness_number_0(_S1043, _S1044 + share_4 * _S1046 + term_0);
            shares_0[share_4] = shares_0[share_4] + _S1047 * (*_S1045)[term_0];
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

__device__ Blocked_0 blocked_at_0(uint _S1048, bool _S1049, bool _S1050, float _S1051, float _S1052)
{
    float _S1053 = openness_number_0(_S1048, 158U);
    float _S1054 = _S1052 * _S1053;
    float _S1055 = _S1051 * _S1051;
    float _S1056 = _S1051 * _S1054;
    float _S1057 = _S1054 * _S1054;
    uint _S1058;
    if(_S1050)
    {
        _S1058 = 2U;
    }
    else
    {
        _S1058 = 0U;
    }
    uint _S1059;
    if(_S1049)
    {
        _S1059 = 0U;
    }
    else
    {
        _S1059 = 1U;
    }
    uint _S1060 = 60U + (_S1058 + _S1059) * 18U;
    FixedArray<float, 6>  _S1061;
    _S1061[int(0)] = 1.0f;
    _S1061[int(1)] = _S1051;
    _S1061[int(2)] = _S1054;
    _S1061[int(3)] = _S1055;
    _S1061[int(4)] = _S1056;
    _S1061[int(5)] = _S1057;
    Blocked_0 _S1062 = blocked_of_terms_0(_S1048, _S1060, &_S1061, 6U);
    return _S1062;
}

__device__ Blocked_0 with_blocked_0(uint _S1063, Blocked_0 * _S1064, YarnPoint_0 * _S1065, bool _S1066, float _S1067)
{
    bool _S1068;
    if(_S1065->hole_6)
    {
        _S1068 = true;
    }
    else
    {
        _S1068 = (_S1065->is_warp_3) != _S1066;
    }
    if(_S1068)
    {
        return *_S1064;
    }
    Blocked_0 _S1069 = blocked_at_0(_S1063, _S1066, _S1065->back_7, _S1065->normal_9.z, _S1065->height_11);
    Blocked_0 result_16;
    (&result_16)->by_warp_0 = _S1064->by_warp_0 + _S1067 * _S1069.by_warp_0;
    (&result_16)->by_weft_0 = _S1064->by_weft_0 + _S1067 * _S1069.by_weft_0;
    (&result_16)->far_0 = _S1064->far_0 + _S1067 * _S1069.far_0;
    return result_16;
}

struct CoverageTaps_0
{
    FixedArray<uint, 9>  nodes_1;
};

__device__ float3  pyramid_level_0(uint _S1070, float _S1071)
{
    Lobes_0 _S1072 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S1070])->lobes_0);
    uint _S1073 = _S1072.levels_0 + 4U * uint((F32_min((_S1071), (_S1072.last_level_0))));
    return make_float3 (table_number_0(_S1073), table_number_0(_S1073 + 1U), table_number_0(_S1073 + 2U));
}

__device__ CoverageTaps_0 coverage_taps_0(uint _S1074, Footprint_0 * _S1075, bool _S1076)
{
    Fabric_0 * _S1077 = (&(globalParams_0->fabrics_0)[_S1074]);
    float _S1078 = Footprint_spread_side_0(_S1075);
    Lobes_0 _S1079 = slang_ldg_1(&_S1077->lobes_0);
    float _S1080 = _S1078 * _S1079.inverse_base_size_0;
    float3  _S1081 = pyramid_level_0(_S1074, (F32_floor((binary_logarithm_0((F32_max((0.68000000715255737f * _S1080), (1.0f))))))));
    float _S1082 = 1.0f / (F32_max((_S1080), (9.99999997475242708e-07f)));
    float _S1083 = (F32_min(((F32_max(((F32_sqrt((clamp_1(1.29999995231628418f * (1.0f - _S1082 * _S1082), 0.0f, 1.0f))))), (0.3333333432674408f * _S1082)))), (1.0f)));
    uint _S1084 = __ldg(&_S1077->warp_0);
    float _S1085 = __ldg(&(&(globalParams_0->families_0)[_S1084])->inverse_period_0);
    uint _S1086 = __ldg(&_S1077->weft_0);
    float _S1087 = __ldg(&(&(globalParams_0->families_0)[_S1086])->inverse_period_0);
    float2  _S1088 = make_float2 (_S1085, _S1087);
    float2  _S1089 = _S1075->centre_0 * _S1088;
    float2  _S1090 = _S1075->dx_0 * _S1088 * make_float2 (_S1083);
    float2  _S1091 = _S1075->dy_0 * _S1088 * make_float2 (_S1083);
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
        float2  _S1092 = _S1089 + make_float2 (TAP_OFFSETS_0[number_2].x) * _S1090 + make_float2 (TAP_OFFSETS_0[number_2].y) * _S1091;
        float _S1093 = _S1081.y;
        float _S1094 = wrapped_cell_0(_S1092.x, _S1093);
        float _S1095 = wrapped_cell_0(_S1092.y, _S1081.z);
        uint _S1096;
        if(_S1076)
        {
            _S1096 = _S1079.face_nodes_0;
        }
        else
        {
            _S1096 = 0U;
        }
        (&taps_3)->nodes_1[number_2] = _S1096 + uint(_S1095 * _S1093 + _S1094 + _S1081.x);
        number_2 = number_2 + 1U;
    }
    return taps_3;
}

__device__ float4  coverage_of_pack_0(uint _S1097, CoverageTaps_0 * _S1098, uint _S1099)
{
    Fabric_0 * _S1100 = (&(globalParams_0->fabrics_0)[_S1097]);
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
        Lobes_0 _S1101 = slang_ldg_1(&_S1100->lobes_0);
        uint _S1102 = __ldg((&(globalParams_0->words_0)[_S1101.coverage_0 + _S1098->nodes_1[number_3] * _S1101.packs_0 + _S1099]));
        uint even_2 = even_1 + (_S1102 & 16711935U);
        uint odd_2 = odd_1 + ((_S1102 >> int(8)) & 16711935U);
        number_3 = number_3 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / make_float4 (9.0f);
}

__device__ float coverage_of_holes_0(uint _S1103, CoverageTaps_0 * _S1104)
{
    Fabric_0 * _S1105 = (&(globalParams_0->fabrics_0)[_S1103]);
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
        uint _S1106 = _S1104->nodes_1[number_4];
        Lobes_0 _S1107 = slang_ldg_1(&_S1105->lobes_0);
        uint _S1108 = __ldg((&(globalParams_0->words_0)[_S1107.coverage_holes_0 + _S1106 / 4U]));
        uint total_1 = total_0 + ((_S1108 >> (8U * (_S1106 % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

__device__ float prefiltered_hole_0(uint _S1109, CoverageTaps_0 * _S1110, NodeTaps_0 * _S1111, bool _S1112)
{
    Lobes_0 _S1113 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S1109])->lobes_0);
    float4  _S1114 = interpolate_table_0(_S1111, _S1113.projected_area_0 + _S1113.packs_0, _S1113.packs_0 + 1U);
    float _S1115 = _S1114.x;
    float _S1116;
    if(_S1112)
    {
        _S1116 = _S1113.back_hole_weight_0;
    }
    else
    {
        _S1116 = _S1113.front_hole_weight_0;
    }
    float _S1117 = coverage_of_holes_0(_S1109, _S1110);
    return (F32_min((_S1117 * _S1115 * _S1115 * _S1116), (1.0f)));
}

__device__ Components_0 prefiltered_components_0(uint _S1118, Footprint_0 * _S1119, float3  _S1120, float3  _S1121, bool _S1122)
{
    Fabric_0 * _S1123 = (&(globalParams_0->fabrics_0)[_S1118]);
    CoverageTaps_0 _S1124 = coverage_taps_0(_S1118, _S1119, _S1122);
    NodeTaps_0 _S1125 = node_taps_0(_S1121);
    NodeTaps_0 view_nodes_0 = _S1125;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S1120);
    NodeTaps_0 seen_nodes_0 = _S1125;
    uint _S1126;
    if(_S1122)
    {
        _S1126 = 1U;
    }
    else
    {
        _S1126 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + make_uint4 (_S1126 * 256U);
    uint _S1127 = 2U * _S1126;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + make_uint4 (_S1127 * 256U);
    uint _S1128;
    if((_S1120.z) < 0.0f)
    {
        _S1128 = 1U;
    }
    else
    {
        _S1128 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + make_uint4 ((_S1127 + _S1128) * 256U);
    float3  _S1129 = half_vector_0(_S1120, _S1121);
    float3  _S1130 = shadow_correlation_0(_S1120, _S1121);
    if(_S1122)
    {
        Lobes_0 _S1131 = slang_ldg_1(&_S1123->lobes_0);
        _S1128 = _S1131.back_warp_packs_0;
    }
    else
    {
        Lobes_0 _S1132 = slang_ldg_1(&_S1123->lobes_0);
        _S1128 = _S1132.front_warp_packs_0;
    }
    Components_0 sums_1;
    (&sums_1)->diffuse_warp_0 = 0.0f;
    (&sums_1)->diffuse_weft_0 = 0.0f;
    (&sums_1)->specular_warp_0 = 0.0f;
    (&sums_1)->specular_weft_0 = 0.0f;
    (&sums_1)->light_visibility_1 = 0.0f;
    uint pack_0 = 0U;
    float total_2 = 0.0f;
    for(;;)
    {
        Lobes_0 _S1133 = slang_ldg_1(&_S1123->lobes_0);
        if(pack_0 < (_S1133.packs_0))
        {
        }
        else
        {
            break;
        }
        CoverageTaps_0 _S1134 = _S1124;
        float4  _S1135 = coverage_of_pack_0(_S1118, &_S1134, pack_0);
        uint _S1136 = _S1133.projected_area_0 + pack_0;
        uint _S1137 = _S1133.packs_0 + 1U;
        NodeTaps_0 _S1138 = view_nodes_0;
        float4  _S1139 = interpolate_table_0(&_S1138, _S1136, _S1137);
        uint _S1140 = _S1133.light_visibility_0 + pack_0;
        NodeTaps_0 _S1141 = seen_nodes_0;
        float4  _S1142 = interpolate_table_0(&_S1141, _S1140, _S1133.packs_0);
        float4  _S1143 = _S1142 / make_float4 (255.0f);
        NodeTaps_0 _S1144 = light_nodes_0;
        float4  _S1145 = interpolate_table_0(&_S1144, _S1140, _S1133.packs_0);
        float4  _S1146 = _S1145 / make_float4 (255.0f);
        uint _S1147 = _S1133.irradiance_0 + pack_0;
        NodeTaps_0 _S1148 = light_nodes_0;
        float4  _S1149 = interpolate_table_0(&_S1148, _S1147, _S1133.packs_0);
        float4  _S1150 = _S1149 * make_float4 (0.00124827399849892f);
        bool _S1151 = pack_0 < _S1128;
        uint _S1152;
        if(_S1151)
        {
            uint _S1153 = __ldg(&_S1123->warp_0);
            _S1152 = _S1153;
        }
        else
        {
            uint _S1154 = __ldg(&_S1123->weft_0);
            _S1152 = _S1154;
        }
        float _S1155 = __ldg(&(&(globalParams_0->families_0)[_S1152])->roughness_0);
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
            Group_0 _S1156 = group_at_0(_S1133.moments_0 + 12U * (4U * (_S1126 * _S1133.packs_0 + pack_0) + number_5), _S1155);
            float _S1157 = _slang_vector_get_element(_S1135, number_5) * _slang_vector_get_element(_S1139, number_5) * _slang_vector_get_element(_S1139, number_5) * _S1156.weight_2;
            uint _S1158 = number_5;
            float2  _S1159 = visibility_gain_0(_S1130, _slang_vector_get_element(_S1146, number_5), _slang_vector_get_element(_S1143, number_5));
            float _S1160 = __ldg(&_S1123->optical_depth_0);
            Group_0 _S1161 = _S1156;
            float _S1162 = layer_value_0(&_S1161, _S1129, _S1120, _S1121, _S1160);
            float _S1163 = _S1159.x;
            float diffuse_1 = diffuse_0 + _S1157 * _slang_vector_get_element(_S1150, number_5) * _S1163;
            float specular_1 = specular_0 + _S1157 * _S1162 * _slang_vector_get_element(_S1146, _S1158) * _S1159.y;
            (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 + _S1157 * _slang_vector_get_element(_S1146, _S1158) * _S1163;
            float total_3 = total_2 + _S1157;
            number_5 = number_5 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S1164;
        if(_S1151)
        {
            _S1164 = diffuse_0;
        }
        else
        {
            _S1164 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S1164;
        float _S1165;
        if(_S1151)
        {
            _S1165 = 0.0f;
        }
        else
        {
            _S1165 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S1165;
        float _S1166;
        if(_S1151)
        {
            _S1166 = specular_0;
        }
        else
        {
            _S1166 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S1166;
        float _S1167;
        if(_S1151)
        {
            _S1167 = 0.0f;
        }
        else
        {
            _S1167 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S1167;
        pack_0 = pack_0 + 1U;
    }
    CoverageTaps_0 _S1168 = _S1124;
    NodeTaps_0 _S1169 = view_nodes_0;
    float _S1170 = prefiltered_hole_0(_S1118, &_S1168, &_S1169, _S1122);
    (&sums_1)->hole_2 = _S1170;
    float _S1171 = (1.0f - _S1170) / (F32_max((total_2), (9.999999960041972e-13f)));
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S1171;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S1171;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S1171;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S1171;
    (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 * _S1171;
    return sums_1;
}

__device__ FamilyAlbedos_0 albedos_over_0(uint _S1172, Footprint_0 * _S1173, bool _S1174)
{
    Fabric_0 * _S1175 = (&(globalParams_0->fabrics_0)[_S1172]);
    float2  _S1176 = sqrt_0(_S1173->dx_0 * _S1173->dx_0 + _S1173->dy_0 * _S1173->dy_0);
    uint _S1177 = __ldg(&_S1175->warp_0);
    float2  _S1178 = _S1173->centre_0;
    Stretch_0 _S1179 = stretch_of_0(_S1177, _S1173->centre_0.x, _S1176.x);
    uint _S1180 = __ldg(&_S1175->weft_0);
    Stretch_0 _S1181 = stretch_of_0(_S1180, _S1178.y, _S1176.y);
    FamilyAlbedos_0 albedos_9;
    Stretch_0 _S1182 = _S1179;
    Stretch_0 _S1183 = _S1181;
    Albedos_0 _S1184 = mean_albedos_0(_S1177, _S1180, &_S1182, &_S1183, _S1174);
    (&albedos_9)->warp_5 = _S1184;
    Stretch_0 _S1185 = _S1181;
    Stretch_0 _S1186 = _S1179;
    Albedos_0 _S1187 = mean_albedos_0(_S1180, _S1177, &_S1185, &_S1186, _S1174);
    (&albedos_9)->weft_5 = _S1187;
    return albedos_9;
}

__device__ Estimate_0 lobes_estimate_of_pass_0(uint _S1188, Footprint_0 * _S1189, float _S1190, float2  _S1191, float3  _S1192, float3  _S1193)
{
    float _S1194;
    float _S1195;
    Fabric_0 * _S1196 = (&(globalParams_0->fabrics_0)[_S1188]);
    Regime_0 _S1197 = regime_of_0(_S1188, _S1189, _S1190);
    bool _S1198 = (_S1193.z) < 0.0f;
    float3  _S1199 = to_face_frame_0(_S1193, _S1198);
    float _S1200 = Footprint_spread_side_0(_S1189);
    bool _S1201 = varies_at_0(_S1188, _S1200);
    uint _S1202 = __ldg(&_S1196->warp_0);
    uint _S1203 = __ldg(&(&(globalParams_0->families_0)[_S1202])->quantities_0);
    bool _S1204;
    if(_S1203 > 1U)
    {
        _S1204 = true;
    }
    else
    {
        uint _S1205 = __ldg(&_S1196->weft_0);
        uint _S1206 = __ldg(&(&(globalParams_0->families_0)[_S1205])->quantities_0);
        _S1204 = _S1206 > 1U;
    }
    float _S1207 = 1.0f - _S1197.prefiltered_0;
    if(_S1207 > 0.0f)
    {
        if(_S1201)
        {
            _S1204 = true;
        }
    }
    else
    {
        _S1204 = false;
    }
    Footprint_0 box_0 = *_S1189;
    float3  _S1208 = make_float3 (0.0f);
    SurfacePoint_0 _S1209 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S1208, _S1208, 0.0f, 0.0f, 0.0f);
    float2  _S1210 = _S1189->centre_0;
    Components_0 _S1211 = no_components_0();
    CloseUp_0 close_1 = no_close_up_0();
    int _S1212;
    if(_S1204)
    {
        _S1212 = int(0);
    }
    else
    {
        _S1212 = int(1);
    }
    uint _S1213 = uint(_S1212);
    Components_0 points_2 = _S1211;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S1209;
    float2  central_place_0 = _S1210;
    uint number_6 = _S1213;
    for(;;)
    {
        float _S1214 = float(number_6);
        _S1194 = _S1197.points_1;
        if(_S1214 < (_S1197.points_1 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S1215 = number_6 == 0U;
        uint _S1216;
        if(_S1215)
        {
            _S1216 = 0U;
        }
        else
        {
            _S1216 = number_6 - 1U;
        }
        float2  _S1217 = POINT_OFFSETS_0[_S1216] + _S1191;
        float2  _S1218;
        if(_S1215)
        {
            _S1218 = make_float2 (0.0f);
        }
        else
        {
            _S1218 = _S1217 - round_0(_S1217);
        }
        float2  _S1219 = _S1210 + make_float2 (_S1218.x) * _S1189->dx_0 + make_float2 (_S1218.y) * _S1189->dy_0;
        if(_S1215)
        {
            _S1195 = 0.0f;
        }
        else
        {
            _S1195 = _S1197.threads_1;
        }
        SearchQuality_0 _S1220 = quality_of_0(_S1195);
        float _S1221 = _S1219.x;
        float _S1222 = _S1219.y;
        SearchQuality_0 _S1223 = _S1220;
        Hit_0 _S1224 = first_hit_0(_S1188, &_S1223, _S1221, _S1222, _S1199, _S1198);
        SurfacePoint_0 _S1225 = surface_at_0(_S1188, _S1224.x_32, _S1224.y_17, _S1198);
        if(_S1215)
        {
            float central_weight_1;
            if(_S1224.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S1207;
            }
            float2  central_place_1 = make_float2 (_S1224.x_32, _S1224.y_17);
            (&box_0)->centre_0 = lerp_2(_S1210, central_place_1, make_float2 (central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S1225;
            central_place_0 = central_place_1;
            number_6 = number_6 + 1U;
            continue;
        }
        SurfacePoint_0 _S1226 = _S1225;
        YarnPoint_0 _S1227 = yarn_point_of_0(_S1188, &_S1226, _S1224.x_32, _S1224.y_17, _S1198, _S1224.hole_5, _S1200);
        SearchQuality_0 _S1228 = _S1220;
        YarnPoint_0 _S1229 = _S1227;
        Components_0 _S1230 = components_of_point_0(_S1188, &_S1228, &_S1229, _S1192, _S1193);
        float _S1231 = (F32_min((_S1197.points_1 - float(number_6 - 1U)), (1.0f)));
        Components_0 _S1232 = points_2;
        Components_0 _S1233 = _S1230;
        Components_0 _S1234 = with_added_0(&_S1232, &_S1233, _S1231);
        uint _S1235 = __ldg(&_S1196->openness_0);
        if(_S1235 != 4294967295U)
        {
            Blocked_0 _S1236 = (&close_1)->warp_1;
            YarnPoint_0 _S1237 = _S1227;
            Blocked_0 _S1238 = with_blocked_0(_S1188, &_S1236, &_S1237, true, _S1231);
            (&close_1)->warp_1 = _S1238;
            Blocked_0 _S1239 = (&close_1)->weft_1;
            YarnPoint_0 _S1240 = _S1227;
            Blocked_0 _S1241 = with_blocked_0(_S1188, &_S1239, &_S1240, false, _S1231);
            (&close_1)->weft_1 = _S1241;
        }
        points_2 = _S1234;
        number_6 = number_6 + 1U;
    }
    (&close_1)->weight_0 = _S1207;
    float _S1242 = (F32_max((_S1194), (1.0f)));
    float _S1243 = 1.0f / _S1242;
    Blocked_0 _S1244 = (&close_1)->warp_1;
    Blocked_0 _S1245 = scaled_0(&_S1244, _S1243);
    (&close_1)->warp_1 = _S1245;
    float _S1246 = 1.0f / _S1242;
    Blocked_0 _S1247 = (&close_1)->weft_1;
    Blocked_0 _S1248 = scaled_0(&_S1247, _S1246);
    (&close_1)->weft_1 = _S1248;
    Estimate_0 estimate_0;
    (&estimate_0)->close_0 = close_1;
    float _S1249 = _S1207 / _S1242;
    Components_0 _S1250 = _S1211;
    Components_0 _S1251 = points_2;
    Components_0 _S1252 = with_added_0(&_S1250, &_S1251, _S1249);
    (&estimate_0)->components_0 = _S1252;
    if((_S1197.prefiltered_0) > 0.0f)
    {
        Components_0 _S1253 = prefiltered_components_0(_S1188, _S1189, to_face_frame_0(_S1192, _S1198), _S1199, _S1198);
        Components_0 _S1254 = (&estimate_0)->components_0;
        Components_0 _S1255 = _S1253;
        Components_0 _S1256 = with_added_0(&_S1254, &_S1255, _S1197.prefiltered_0);
        (&estimate_0)->components_0 = _S1256;
    }
    Footprint_0 _S1257 = box_0;
    FamilyAlbedos_0 _S1258 = albedos_over_0(_S1188, &_S1257, _S1198);
    (&estimate_0)->albedos_5 = _S1258;
    if(_S1201)
    {
        _S1204 = central_weight_0 > 0.0f;
    }
    else
    {
        _S1204 = false;
    }
    if(_S1204)
    {
        SurfacePoint_0 _S1259 = central_0;
        Albedos_0 _S1260;
        if(central_0.is_warp_0)
        {
            _S1260 = (&(&estimate_0)->albedos_5)->warp_5;
        }
        else
        {
            _S1260 = (&(&estimate_0)->albedos_5)->weft_5;
        }
        uint _S1261 = __ldg(&_S1196->has_detail_0);
        if(_S1261 != 0U)
        {
            bool _S1262 = has_hairs_0(_S1188);
            _S1204 = _S1262;
        }
        else
        {
            _S1204 = false;
        }
        if(_S1204)
        {
            Hair_0 _S1263 = hair_at_0(_S1188, central_place_0, _S1198, _S1200);
            _S1195 = _S1263.cover_0;
        }
        else
        {
            _S1195 = 0.0f;
        }
        float _S1264 = central_place_0.x;
        float _S1265 = central_place_0.y;
        SurfacePoint_0 _S1266 = central_0;
        Albedos_0 _S1267 = _S1260;
        Albedos_0 _S1268 = varied_at_0(_S1188, &_S1266, &_S1267, _S1264, _S1265, _S1198, _S1200, _S1195);
        Albedos_0 _S1269 = _S1260;
        Albedos_0 _S1270 = _S1268;
        Albedos_0 _S1271 = lerp_albedos_0(&_S1269, &_S1270, central_weight_0);
        if(_S1259.is_warp_0)
        {
            (&(&estimate_0)->albedos_5)->warp_5 = _S1271;
        }
        else
        {
            (&(&estimate_0)->albedos_5)->weft_5 = _S1271;
        }
    }
    return estimate_0;
}

__device__ Estimate_0 lobes_estimate_0(uint _S1272, Footprint_0 * _S1273, float _S1274, float3  _S1275, float3  _S1276)
{
    Estimate_0 _S1277 = lobes_estimate_of_pass_0(_S1272, _S1273, _S1274, make_float2 (0.0f), _S1275, _S1276);
    return _S1277;
}

__device__ Scattered_0 scattered_by_0(uint _S1278, Albedos_0 * _S1279, uint _S1280, float3  _S1281)
{
    uint _S1282 = 159U + 2U * _S1280;
    Scattered_0 yarn_3;
    float3  _S1283 = _S1281 * _S1279->diffuse_reflect_0;
    float _S1284 = openness_number_0(_S1278, _S1282);
    (&yarn_3)->back_6 = _S1283 + make_float3 (_S1284) * _S1279->specular_reflect_0;
    float3  _S1285 = _S1281 * _S1279->diffuse_transmit_0;
    float _S1286 = openness_number_0(_S1278, _S1282 + 1U);
    (&yarn_3)->through_0 = _S1285 + make_float3 (_S1286) * _S1279->specular_transmit_0;
    return yarn_3;
}

__device__ void sent_0(uint _S1287, uint _S1288, float3  _S1289, float3  _S1290, float3  _S1291, float3  _S1292, float3  * _S1293, float3  * _S1294)
{
    uint _S1295 = 146U + 4U * _S1288;
    float _S1296 = openness_number_0(_S1287, _S1295);
    float _S1297 = openness_number_0(_S1287, _S1295 + 1U);
    float _S1298 = openness_number_0(_S1287, _S1295 + 2U);
    float _S1299 = openness_number_0(_S1287, _S1295 + 3U);
    float3  _S1300 = make_float3 (1.0f) - _S1291 * make_float3 (_S1296);
    float3  _S1301 = make_float3 (1.0f) - _S1292 * make_float3 (_S1299);
    float3  _S1302 = make_float3 (1.0f) / (_S1300 * _S1301 - _S1291 * _S1292 * make_float3 (_S1297 * _S1298));
    *_S1293 = (_S1289 * _S1301 + _S1291 * make_float3 (_S1297) * _S1290) * _S1302;
    *_S1294 = (_S1290 * _S1300 + _S1292 * make_float3 (_S1298) * _S1289) * _S1302;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S1303, uint _S1304, Scattered_0 * _S1305, Scattered_0 * _S1306)
{
    uint _S1307 = 2U * _S1304;
    uint _S1308 = 142U + _S1307;
    float _S1309 = openness_number_0(_S1303, _S1308);
    float _S1310 = openness_number_0(_S1303, _S1308 + 1U);
    float3  _S1311 = make_float3 (1.0f - _S1309) * _S1305->back_6;
    float3  _S1312 = make_float3 (1.0f - _S1310) * _S1306->back_6;
    FaceSends_0 sends_1;
    uint _S1313 = 154U + _S1307;
    float _S1314 = openness_number_0(_S1303, _S1313);
    (&sends_1)->blocks_warp_0 = _S1314;
    float _S1315 = openness_number_0(_S1303, _S1313 + 1U);
    (&sends_1)->blocks_weft_0 = _S1315;
    (&sends_1)->open_0 = _S1314 * _S1309 + _S1315 * _S1310;
    sent_0(_S1303, _S1304, make_float3 (_S1309) * _S1305->back_6, make_float3 (_S1310) * _S1306->back_6, _S1311, _S1312, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S1303, _S1304, _S1305->through_0, _S1306->through_0, _S1311, _S1312, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S1316, float3  _S1317, bool _S1318)
{
    Fabric_0 * _S1319 = (&(globalParams_0->fabrics_0)[_S1316]);
    uint _S1320 = __ldg(&_S1319->warp_0);
    uint _S1321 = __ldg(&(&(globalParams_0->families_0)[_S1320])->colour_mean_0);
    Albedos_0 _S1322 = table_albedos_0(_S1321);
    Scattered_0 _S1323 = scattered_by_0(_S1316, &_S1322, 0U, _S1317);
    uint _S1324 = __ldg(&_S1319->weft_0);
    uint _S1325 = __ldg(&(&(globalParams_0->families_0)[_S1324])->colour_mean_0);
    Albedos_0 _S1326 = table_albedos_0(_S1325);
    Scattered_0 _S1327 = scattered_by_0(_S1316, &_S1326, 1U, _S1317);
    uint _S1328;
    if(_S1318)
    {
        _S1328 = 1U;
    }
    else
    {
        _S1328 = 0U;
    }
    Scattered_0 _S1329 = _S1323;
    Scattered_0 _S1330 = _S1327;
    FaceSends_0 _S1331 = face_sends_0(_S1316, _S1328, &_S1329, &_S1330);
    if(_S1318)
    {
        _S1328 = 0U;
    }
    else
    {
        _S1328 = 1U;
    }
    Scattered_0 _S1332 = _S1323;
    Scattered_0 _S1333 = _S1327;
    FaceSends_0 _S1334 = face_sends_0(_S1316, _S1328, &_S1332, &_S1333);
    float3  _S1335 = make_float3 (_S1331.blocks_warp_0) * _S1331.crossing_warp_0 + make_float3 (_S1331.blocks_weft_0) * _S1331.crossing_weft_0;
    float3  _S1336 = make_float3 (_S1334.blocks_warp_0) * _S1334.crossing_warp_0 + make_float3 (_S1334.blocks_weft_0) * _S1334.crossing_weft_0;
    float _S1337 = 1.0f - _S1331.open_0;
    float _S1338 = 1.0f - _S1334.open_0;
    float3  _S1339 = make_float3 (1.0f) / (make_float3 (1.0f) - _S1335 * _S1336 * make_float3 (_S1337 * _S1338));
    float3  _S1340 = _S1336 * (make_float3 (_S1331.open_0) + make_float3 (_S1337) * (make_float3 (_S1331.blocks_warp_0) * _S1331.sky_warp_0 + make_float3 (_S1331.blocks_weft_0) * _S1331.sky_weft_0)) * _S1339;
    float3  _S1341 = _S1335 * (make_float3 (_S1334.open_0) + make_float3 (_S1338) * (make_float3 (_S1334.blocks_warp_0) * _S1334.sky_warp_0 + make_float3 (_S1334.blocks_weft_0) * _S1334.sky_weft_0)) * _S1339;
    FaceSends_0 _S1342 = _S1331;
    FaceRadiance_0 _S1343 = face_radiance_0(&_S1342, _S1334.open_0, _S1340, _S1341);
    FaceSends_0 _S1344 = _S1334;
    FaceRadiance_0 _S1345 = face_radiance_0(&_S1344, _S1331.open_0, _S1341, _S1340);
    Interior_0 interior_1;
    (&interior_1)->warp_4 = _S1343.warp_3;
    (&interior_1)->weft_4 = _S1343.weft_3;
    (&interior_1)->leaked_1 = _S1343.leaked_0;
    (&interior_1)->far_1 = _S1345.mean_0;
    (&interior_1)->far_leaked_0 = _S1345.leaked_0;
    return interior_1;
}

__device__ Blocked_0 blocked_from_0(uint _S1346, float3  _S1347, bool _S1348, bool _S1349)
{
    FixedArray<float, 6>  terms_1;
    view_terms_0(_S1347, &terms_1);
    uint _S1350;
    if(_S1349)
    {
        _S1350 = 2U;
    }
    else
    {
        _S1350 = 0U;
    }
    uint _S1351;
    if(_S1348)
    {
        _S1351 = 0U;
    }
    else
    {
        _S1351 = 1U;
    }
    uint _S1352 = (_S1350 + _S1351) * 15U;
    FixedArray<float, 6>  _S1353 = terms_1;
    Blocked_0 _S1354 = blocked_of_terms_0(_S1346, _S1352, &_S1353, 5U);
    return _S1354;
}

__device__ float warp_seen_from_0(uint _S1355, float3  _S1356, bool _S1357)
{
    FixedArray<float, 6>  terms_2;
    view_terms_0(_S1356, &terms_2);
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
        uint _S1358;
        if(_S1357)
        {
            _S1358 = 5U;
        }
        else
        {
            _S1358 = 0U;
        }
        float _S1359 = openness_number_0(_S1355, 132U + _S1358 + term_1);
        float share_6 = share_5 + _S1359 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_5 = share_6;
    }
    return saturate_1(share_5);
}

__device__ Bounced_0 bounced_of_families_0(uint _S1360, FamilyAlbedos_0 * _S1361, float3  _S1362, Interior_0 * _S1363, Blocked_0 * _S1364, Blocked_0 * _S1365)
{
    Scattered_0 _S1366 = scattered_by_0(_S1360, &_S1361->warp_5, 0U, _S1362);
    Scattered_0 _S1367 = _S1366;
    Bounced_0 _S1368 = bounced_by_0(_S1364, &_S1367, _S1363);
    Scattered_0 _S1369 = scattered_by_0(_S1360, &_S1361->weft_5, 1U, _S1362);
    Scattered_0 _S1370 = _S1369;
    Bounced_0 _S1371 = bounced_by_0(_S1365, &_S1370, _S1363);
    Bounced_0 _S1372 = _S1368;
    Bounced_0 _S1373 = _S1371;
    Bounced_0 _S1374 = sum_of_0(&_S1372, &_S1373);
    return _S1374;
}

__device__ Bounced_0 bounced_far_0(uint _S1375, FamilyAlbedos_0 * _S1376, float3  _S1377, Interior_0 * _S1378, float3  _S1379, bool _S1380, float _S1381, float _S1382, float _S1383)
{
    Blocked_0 _S1384 = blocked_from_0(_S1375, _S1379, true, _S1380);
    Blocked_0 _S1385 = blocked_from_0(_S1375, _S1379, false, _S1380);
    float _S1386 = _S1381 / (F32_max((1.0f - _S1384.by_warp_0 - _S1384.by_weft_0), (0.10000000149011612f)));
    float _S1387 = _S1382 / (F32_max((1.0f - _S1385.by_warp_0 - _S1385.by_weft_0), (0.10000000149011612f)));
    float _S1388 = warp_seen_from_0(_S1375, _S1379, _S1380);
    float _S1389 = (0.0020000000949949f * _S1388 + _S1386) / (_S1386 + _S1387 + 0.0020000000949949f);
    float _S1390 = 1.0f - _S1383;
    float _S1391 = _S1389 * _S1390;
    Blocked_0 _S1392 = _S1384;
    Blocked_0 _S1393 = scaled_0(&_S1392, _S1391);
    float _S1394 = (1.0f - _S1389) * _S1390;
    Blocked_0 _S1395 = _S1385;
    Blocked_0 _S1396 = scaled_0(&_S1395, _S1394);
    Blocked_0 _S1397 = _S1393;
    Blocked_0 _S1398 = _S1396;
    Bounced_0 _S1399 = bounced_of_families_0(_S1375, _S1376, _S1377, _S1378, &_S1397, &_S1398);
    return _S1399;
}

__device__ Bounced_0 bounced_over_0(uint _S1400, Components_0 * _S1401, CloseUp_0 * _S1402, FamilyAlbedos_0 * _S1403, float3  _S1404, float3  _S1405)
{
    bool _S1406 = (_S1405.z) < 0.0f;
    Interior_0 _S1407 = interior_of_0(_S1400, _S1404, _S1406);
    float3  _S1408 = to_face_frame_0(_S1405, _S1406);
    Interior_0 _S1409 = _S1407;
    Bounced_0 _S1410 = bounced_far_0(_S1400, _S1403, _S1404, &_S1409, _S1408, _S1406, _S1401->diffuse_warp_0, _S1401->diffuse_weft_0, _S1401->hole_2);
    Bounced_0 bounced_2 = _S1410;
    float _S1411 = _S1402->weight_0;
    if((_S1402->weight_0) > 0.0f)
    {
        Interior_0 _S1412 = _S1407;
        Bounced_0 _S1413 = bounced_of_families_0(_S1400, _S1403, _S1404, &_S1412, &_S1402->warp_1, &_S1402->weft_1);
        float3  _S1414 = make_float3 (_S1411);
        (&bounced_2)->reflected_0 = lerp_0((&bounced_2)->reflected_0, _S1413.reflected_0, _S1414);
        (&bounced_2)->transmitted_0 = lerp_0((&bounced_2)->transmitted_0, _S1413.transmitted_0, _S1414);
    }
    return bounced_2;
}

__device__ float3  composed_0(uint _S1415, Components_0 * _S1416, CloseUp_0 * _S1417, FamilyAlbedos_0 * _S1418, float3  _S1419, float3  _S1420, float3  _S1421)
{
    Fabric_0 * _S1422 = (&(globalParams_0->fabrics_0)[_S1415]);
    Albedos_0 _S1423 = tinted_0(&_S1418->warp_5, _S1419);
    Albedos_0 _S1424 = tinted_0(&_S1418->weft_5, _S1419);
    float _S1425 = _S1416->diffuse_warp_0;
    float _S1426 = _S1416->diffuse_weft_0;
    float _S1427 = _S1416->specular_warp_0;
    float _S1428 = _S1416->specular_weft_0;
    float3  _S1429 = _S1423.diffuse_reflect_0 * make_float3 (_S1416->diffuse_warp_0) + _S1424.diffuse_reflect_0 * make_float3 (_S1416->diffuse_weft_0) + _S1423.specular_reflect_0 * make_float3 (_S1416->specular_warp_0) + _S1424.specular_reflect_0 * make_float3 (_S1416->specular_weft_0);
    float _S1430 = _S1421.z;
    float3  body_0;
    if((_S1420.z * _S1430) < 0.0f)
    {
        body_0 = _S1423.diffuse_transmit_0 * make_float3 (_S1425) + _S1424.diffuse_transmit_0 * make_float3 (_S1426) + _S1423.specular_transmit_0 * make_float3 (_S1427) + _S1424.specular_transmit_0 * make_float3 (_S1428);
    }
    else
    {
        body_0 = _S1429;
    }
    uint _S1431 = __ldg(&_S1422->openness_0);
    if(_S1431 != 4294967295U)
    {
        Bounced_0 _S1432 = bounced_over_0(_S1415, _S1416, _S1417, _S1418, _S1419, _S1421);
        Bounced_0 _S1433 = _S1432;
        float3  _S1434 = bounced_value_0(&_S1433, _S1420, _S1421);
        body_0 = body_0 + _S1434;
    }
    float _S1435 = __ldg(&_S1422->sheen_strength_0);
    if(_S1435 <= 0.0f)
    {
        return body_0;
    }
    bool _S1436 = _S1430 < 0.0f;
    float3  _S1437 = to_face_frame_0(_S1420, _S1436);
    float3  _S1438 = to_face_frame_0(_S1421, _S1436);
    float _S1439 = __ldg(&_S1422->sheen_roughness_0);
    float2  _S1440 = sheen_with_transmittance_0(_S1437, _S1438, _S1435, _S1439);
    return make_float3 (_S1440.y) * body_0 + make_float3 ((_S1416->light_visibility_1 + _S1416->hole_2) * _S1440.x);
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_2, float2  dx_1, float2  dy_1, float3  light_10, float3  view_10)
{
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_2;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    Footprint_0 _S1441 = footprint_0;
    Estimate_0 _S1442 = lobes_estimate_0(fabric_2, &_S1441, 1.0f, light_10, view_10);
    float3  _S1443 = make_float3 (1.0f);
    Components_0 _S1444 = _S1442.components_0;
    CloseUp_0 _S1445 = _S1442.close_0;
    FamilyAlbedos_0 _S1446 = _S1442.albedos_5;
    float3  _S1447 = composed_0(fabric_2, &_S1444, &_S1445, &_S1446, _S1443, light_10, view_10);
    float _S1448 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
    float through_1;
    if(_S1448 > 0.0f)
    {
        float _S1449 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
        float _S1450 = (F32_abs((view_10.z)));
        float _S1451 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_roughness_0);
        through_1 = _S1442.components_0.hole_2 * (1.0f - _S1449 * sheen_lobe_0(_S1450, _S1451).z);
    }
    else
    {
        through_1 = _S1442.components_0.hole_2;
    }
    return make_float4 (_S1447.x, _S1447.y, _S1447.z, through_1);
}

extern "C" __global__ void lobes_queries()
{
    uint _S1452 = (blockIdx * blockDim + threadIdx).x;
    uint _S1453 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S1452 >= _S1453)
    {
        return;
    }
    Query_0 _S1454 = slang_ldg_0((&(globalParams_0->queries_0)[_S1452]));
    *(&(globalParams_0->answers_0)[_S1452]) = cloth_value_0(_S1454.fabric_1, make_float2 (_S1454.centre_x_0, _S1454.centre_y_0), make_float2 (_S1454.dx_x_0, _S1454.dx_y_0), make_float2 (_S1454.dy_x_0, _S1454.dy_y_0), make_float3 (_S1454.light_x_0, _S1454.light_y_0, _S1454.light_z_0), make_float3 (_S1454.view_x_0, _S1454.view_y_0, _S1454.view_z_0));
    return;
}

