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

__device__ float2  lerp_2(float2  x_17, float2  y_11, float2  s_2)
{
    return x_17 + (y_11 - x_17) * s_2;
}

__device__ float3  normalize_0(float3  x_18)
{
    return x_18 / make_float3 (length_0(x_18));
}

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ float2  round_0(float2  x_19)
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
        *_slang_vector_get_element_ptr(&result_10, i_7) = (F32_round((_slang_vector_get_element(x_19, i_7))));
        i_7 = i_7 + int(1);
    }
    return result_10;
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
    uint _S1 = __ldg(&ptr_0->fabric_1);
    float _S2 = __ldg(&ptr_0->centre_x_0);
    float _S3 = __ldg(&ptr_0->centre_y_0);
    float _S4 = __ldg(&ptr_0->dx_x_0);
    float _S5 = __ldg(&ptr_0->dx_y_0);
    float _S6 = __ldg(&ptr_0->dy_x_0);
    float _S7 = __ldg(&ptr_0->dy_y_0);
    float _S8 = __ldg(&ptr_0->light_x_0);
    float _S9 = __ldg(&ptr_0->light_y_0);
    float _S10 = __ldg(&ptr_0->light_z_0);
    float _S11 = __ldg(&ptr_0->view_x_0);
    float _S12 = __ldg(&ptr_0->view_y_0);
    float _S13 = __ldg(&ptr_0->view_z_0);
    Query_0 _S14 = { _S1, _S2, _S3, _S4, _S5, _S6, _S7, _S8, _S9, _S10, _S11, _S12, _S13 };
    return _S14;
}

__device__ Lobes_0 slang_ldg_1(Lobes_0 * ptr_1)
{
    uint _S15 = __ldg(&ptr_1->is_baked_0);
    float _S16 = __ldg(&ptr_1->inverse_base_size_0);
    float _S17 = __ldg(&ptr_1->last_level_0);
    uint _S18 = __ldg(&ptr_1->levels_0);
    uint _S19 = __ldg(&ptr_1->face_nodes_0);
    uint _S20 = __ldg(&ptr_1->packs_0);
    uint _S21 = __ldg(&ptr_1->front_warp_packs_0);
    uint _S22 = __ldg(&ptr_1->back_warp_packs_0);
    uint _S23 = __ldg(&ptr_1->coverage_0);
    uint _S24 = __ldg(&ptr_1->coverage_holes_0);
    uint _S25 = __ldg(&ptr_1->projected_area_0);
    uint _S26 = __ldg(&ptr_1->light_visibility_0);
    uint _S27 = __ldg(&ptr_1->irradiance_0);
    uint _S28 = __ldg(&ptr_1->moments_0);
    float _S29 = __ldg(&ptr_1->front_hole_weight_0);
    float _S30 = __ldg(&ptr_1->back_hole_weight_0);
    float _S31 = __ldg(&ptr_1->threads_per_mm_0);
    float _S32 = __ldg(&ptr_1->unit_level_0);
    Lobes_0 _S33 = { _S15, _S16, _S17, _S18, _S19, _S20, _S21, _S22, _S23, _S24, _S25, _S26, _S27, _S28, _S29, _S30, _S31, _S32 };
    return _S33;
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

__device__ float natural_logarithm_0(float x_20)
{
    uint _S34 = (F32_asuint((x_20)));
    float exponent_0 = float(int(_S34 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S34 & 8388607U) | 1056964608U)));
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
    float _S35 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S35 - exponent_1 * 0.00021219444170129f - 0.5f * _S35) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_21)
{
    return natural_logarithm_0(x_21) * 1.4426950216293335f;
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S36 = float2 {direction_0.x, direction_0.y};
    float _S37;
    if(back_2)
    {
        _S37 = - direction_0.z;
    }
    else
    {
        _S37 = direction_0.z;
    }
    return make_float3 (_S36.x, _S36.y, _S37);
}

__device__ Family_0 slang_ldg_2(Family_0 * ptr_2)
{
    uint _S38 = __ldg(&ptr_2->is_alike_0);
    float _S39 = __ldg(&ptr_2->count_0);
    float _S40 = __ldg(&ptr_2->inverse_count_0);
    float _S41 = __ldg(&ptr_2->half_inverse_count_0);
    float _S42 = __ldg(&ptr_2->size_0);
    float _S43 = __ldg(&ptr_2->inverse_size_0);
    float _S44 = __ldg(&ptr_2->half_width_0);
    float _S45 = __ldg(&ptr_2->start_0);
    float _S46 = __ldg(&ptr_2->period_0);
    float _S47 = __ldg(&ptr_2->inverse_period_0);
    float _S48 = __ldg(&ptr_2->bins_0);
    uint _S49 = __ldg(&ptr_2->first_thread_table_0);
    uint _S50 = __ldg(&ptr_2->place_table_0);
    uint _S51 = __ldg(&ptr_2->bend_table_0);
    float _S52 = __ldg(&ptr_2->height_scale_0);
    float _S53 = __ldg(&ptr_2->twist_sine_0);
    float _S54 = __ldg(&ptr_2->twist_cosine_0);
    float _S55 = __ldg(&ptr_2->level_0);
    float _S56 = __ldg(&ptr_2->roughness_0);
    uint _S57 = __ldg(&ptr_2->albedo_table_0);
    uint _S58 = __ldg(&ptr_2->albedo_stride_0);
    uint _S59 = __ldg(&ptr_2->before_0);
    float _S60 = __ldg(&ptr_2->visible_total_0);
    float _S61 = __ldg(&ptr_2->smallest_box_0);
    uint _S62 = __ldg(&ptr_2->quantities_0);
    uint _S63 = __ldg(&ptr_2->colour_mean_0);
    uint _S64 = __ldg(&ptr_2->colour_axes_0);
    uint _S65 = __ldg(&ptr_2->colour_threads_0);
    uint _S66 = __ldg(&ptr_2->colour_areas_0);
    float _S67 = __ldg(&ptr_2->area_unit_0);
    float _S68 = __ldg(&ptr_2->crossing_area_0);
    Family_0 _S69 = { _S38, _S39, _S40, _S41, _S42, _S43, _S44, _S45, _S46, _S47, _S48, _S49, _S50, _S51, _S52, _S53, _S54, _S55, _S56, _S57, _S58, _S59, _S60, _S61, _S62, _S63, _S64, _S65, _S66, _S67, _S68 };
    return _S69;
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
    SurfacePoint_0 _S70;
    (&_S70)->hole_0 = hole_1;
    (&_S70)->is_warp_0 = is_warp_1;
    (&_S70)->warp_thread_0 = warp_thread_1;
    (&_S70)->weft_thread_0 = weft_thread_1;
    (&_S70)->height_2 = height_3;
    (&_S70)->normal_0 = normal_1;
    (&_S70)->tangent_0 = tangent_1;
    (&_S70)->across_0 = across_1;
    (&_S70)->fibre_across_0 = fibre_across_1;
    (&_S70)->fibre_along_0 = fibre_along_1;
    return _S70;
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
    Blocked_0 _S71 = no_blocked_0();
    (&nothing_2)->warp_1 = _S71;
    (&nothing_2)->weft_1 = _S71;
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
    float _S72 = clamp_1((-3.0f - binary_logarithm_0((F32_max((threads_0), (9.99999971718068537e-10f))))) / 2.0f, 0.0f, 1.0f);
    SearchQuality_0 quality_0;
    float _S73 = lerp_1(2.5f, 5.0f, _S72);
    (&quality_0)->steps_per_thread_0 = _S73;
    (&quality_0)->steps_per_relief_0 = _S73;
    (&quality_0)->shadow_share_0 = lerp_1(1.60000002384185791f, 1.0f, _S72);
    (&quality_0)->refinements_0 = uint(lerp_1(1.0f, 2.0f, _S72) + 0.5f);
    return quality_0;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_0)
{
    Family_0 _S74 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    Family_0 _S75 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    float _S76 = (F32_floor(((F32_fma((index_0), (_S74.inverse_count_0), (_S75.half_inverse_count_0))))));
    float _S77 = - _S76;
    Family_0 _S78 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S76, (F32_fma((_S77), (_S78.count_0), (index_0))));
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
    Family_0 _S79 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S80 = (F32_floor((position_0 * _S79.inverse_size_0)));
    Cell_0 cell_0;
    float _S81 = - _S80;
    Family_0 _S82 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S83 = (F32_fma((_S81), (_S82.size_0), (position_0)));
    (&cell_0)->below_0 = _S83;
    Family_0 _S84 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->above_0 = _S84.size_0 - _S83;
    Family_0 _S85 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->across_2 = _S83 - 0.5f * _S85.size_0;
    Family_0 _S86 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->half_width_1 = _S86.half_width_0;
    float _S87 = turns_and_remainder_0(family_1, _S80).y;
    Family_0 _S88 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->thread_0 = uint(clamp_1(_S87, 0.0f, _S88.count_0 - 1.0f));
    return cell_0;
}

__device__ float table_number_0(uint index_1)
{
    uint _S89 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S89)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    Family_0 _S90 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S91 = position_1 - _S90.start_0;
    Family_0 _S92 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S91 * _S92.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S93 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S94 = turns_1 * _S93.period_0;
    Family_0 _S95 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S96 = turns_1 * _S95.bins_0;
    Family_0 _S97 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S98 = uint(clamp_1(_S96, 0.0f, _S97.bins_0 - 1.0f));
    Family_0 _S99 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S100 = __ldg((&(globalParams_0->words_0)[_S99.first_thread_table_0 + _S98]));
    Family_0 _S101 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S102;
    if(_S94 >= (table_number_0(_S101.place_table_0 + _S100 * 4U + 1U)))
    {
        _S102 = 1U;
    }
    else
    {
        _S102 = 0U;
    }
    uint _S103 = _S100 + _S102;
    Family_0 _S104 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S105 = (U32_min((_S103), (uint(_S104.count_0) - 1U)));
    Family_0 _S106 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S107 = _S106.place_table_0 + _S105 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S105;
    (&cell_1)->below_0 = _S94 - table_number_0(_S107);
    (&cell_1)->above_0 = table_number_0(_S107 + 1U) - _S94;
    (&cell_1)->across_2 = _S94 - table_number_0(_S107 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S107 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    Family_0 _S108 = slang_ldg_2((&(globalParams_0->families_0)[family_3]));
    if((_S108.is_alike_0) != 0U)
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
    bool _S109 = (F32_abs(((&crossing_0->warp_2)->across_2))) < ((&crossing_0->warp_2)->half_width_1);
    bool _S110 = (F32_abs(((&crossing_0->weft_2)->across_2))) < ((&crossing_0->weft_2)->half_width_1);
    Shown_0 shown_0;
    bool _S111;
    if(_S109)
    {
        if(!_S110)
        {
            _S111 = true;
        }
        else
        {
            _S111 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S111 = false;
    }
    (&shown_0)->is_warp_2 = _S111;
    if(!_S109)
    {
        _S111 = !_S110;
    }
    else
    {
        _S111 = false;
    }
    (&shown_0)->hole_3 = _S111;
    uint _S112;
    if((&shown_0)->is_warp_2)
    {
        _S112 = crossing_0->warp_word_0;
    }
    else
    {
        _S112 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S112;
    (&shown_0)->on_top_0 = ((_S112 & 1U) == 1U) != back_3;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_2;
    uint _S113;
    if(is_first_0)
    {
        _S113 = first_0->thread_0;
    }
    else
    {
        _S113 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S113;
    float _S114;
    if(is_first_0)
    {
        _S114 = first_0->across_2;
    }
    else
    {
        _S114 = second_0->across_2;
    }
    (&cell_2)->across_2 = _S114;
    if(is_first_0)
    {
        _S114 = first_0->half_width_1;
    }
    else
    {
        _S114 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S114;
    if(is_first_0)
    {
        _S114 = first_0->below_0;
    }
    else
    {
        _S114 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S114;
    if(is_first_0)
    {
        _S114 = first_0->above_0;
    }
    else
    {
        _S114 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S114;
    return cell_2;
}

__device__ float boundary_0(uint family_4, uint thread_1, int step_0)
{
    float2  _S115 = turns_and_remainder_0(family_4, float(int(thread_1) + step_0));
    float _S116 = _S115.x;
    Family_0 _S117 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    Family_0 _S118 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S116), (_S117.period_0), (table_number_0(_S118.place_table_0 + uint(_S115.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_2, int first_1, int last_0)
{
    Family_0 _S119 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
    if((_S119.is_alike_0) != 0U)
    {
        float _S120 = float(last_0 - first_1);
        Family_0 _S121 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
        return _S120 * _S121.size_0;
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
    Family_0 _S122 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    Family_0 _S123 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    uint _S124;
    if((_S123.is_alike_0) != 0U)
    {
        _S124 = 0U;
    }
    else
    {
        _S124 = thread_3 * 4U;
    }
    uint _S125 = _S122.bend_table_0 + _S124;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S125);
    (&bend_0)->half_tangent_0 = table_number_0(_S125 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S125 + 2U);
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
    int _S126 = int((word_1 >> int(1)) & 127U);
    int _S127 = int((word_1 >> int(8)) & 127U);
    int _S128 = int((word_1 >> int(15)) & 63U);
    int _S129 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S130 = crossed_0->thread_0;
    int _S131 = - _S126;
    float _S132 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_0, _S131, int(0));
    (&run_0)->from_start_0 = _S132;
    int _S133 = _S127 + int(1);
    float _S134 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_0, int(1), _S133);
    (&run_0)->to_end_0 = _S134;
    bool _S135 = _S132 < _S134;
    (&run_0)->near_start_0 = _S135;
    int _S136;
    if(_S135)
    {
        _S136 = _S131 - _S128;
    }
    else
    {
        _S136 = _S133;
    }
    int _S137;
    if((&run_0)->near_start_0)
    {
        _S137 = _S131;
    }
    else
    {
        _S137 = _S133 + _S129;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_4);
    float _S138;
    if((&run_0)->straight_0)
    {
        _S138 = 1.0e+06f;
    }
    else
    {
        _S138 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S138;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S130, _S136, _S137)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S126 == int(0);
    (&run_0)->last_crossing_0 = _S127 == int(0);
    return run_0;
}

__device__ float square_0(float x_22)
{
    return x_22 * x_22;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_3)
{
    float _S139 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S140 = clamp_1(cell_3->across_2, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_3 = _S140;
    float _S141 = _S139 * _S139 - square_0(_S140);
    float _S142 = (F32_rsqrt((_S141)));
    (&section_0)->drop_0 = _S139 - _S141 * _S142;
    (&section_0)->slope_0 = - _S140 * _S142;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_5, int step_1)
{
    Family_0 _S143 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    if((_S143.is_alike_0) != 0U)
    {
        Family_0 _S144 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S144.bend_table_0 + 3U);
    }
    Family_0 _S145 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S145.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_5) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S146 = crossed_1->below_0;
    float _S147 = crossed_1->above_0;
    bool _S148 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S149 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S150;
    if(_S148)
    {
        _S150 = _S146 - crossed_1->across_2;
    }
    else
    {
        _S150 = _S147 + crossed_1->across_2;
    }
    float _S151 = _S150 - crossed_1->half_width_1;
    bool _S152;
    if(_S148)
    {
        _S152 = run_1->first_crossing_0;
    }
    else
    {
        _S152 = run_1->last_crossing_0;
    }
    bool _S153 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S150 = 0.0f;
    }
    else
    {
        Family_0 _S154 = slang_ldg_2((&(globalParams_0->families_0)[other_1]));
        _S150 = _S154.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_0, int(0));
    }
    float _S155;
    if(_S153 != _S152)
    {
        _S155 = 0.0f;
    }
    else
    {
        Family_0 _S156 = slang_ldg_2((&(globalParams_0->families_0)[other_1]));
        uint _S157 = crossed_1->thread_0;
        int _S158;
        if(_S148)
        {
            _S158 = int(-1);
        }
        else
        {
            _S158 = int(1);
        }
        _S155 = _S156.height_scale_0 * edge_drop_0(other_1, _S157, _S158);
    }
    float _S159 = 1.0f / (F32_max((2.0f * _S151), (9.999999960041972e-13f)));
    float _S160 = clamp_1((_S151 - _S149) * _S159, 0.0f, 1.0f);
    float _S161 = _S150 + (_S155 - _S150) * (_S160 * _S160 * (3.0f - 2.0f * _S160));
    float _S162 = (_S150 - _S155) * (6.0f * _S160 * (1.0f - _S160) * _S159);
    if(_S148)
    {
        _S150 = 1.0f;
    }
    else
    {
        _S150 = -1.0f;
    }
    return make_float2 (_S161, _S162 * _S150);
}

struct StepControl_0
{
    float step_2;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_0;
    bool up_0;
};

__device__ StepControl_0 step_control_0(float2  direction_1, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S163 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S163)))), (9.99999971718068537e-10f)));
    float _S164 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S164)))), (9.99999971718068537e-10f)));
    (&control_0)->right_0 = _S163 > 0.0f;
    (&control_0)->up_0 = _S164 > 0.0f;
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
    float _S165;
    if(forwards_0)
    {
        _S165 = cell_4->across_2;
    }
    else
    {
        _S165 = - cell_4->across_2;
    }
    float _S166;
    if(forwards_0)
    {
        _S166 = cell_4->above_0;
    }
    else
    {
        _S166 = cell_4->below_0;
    }
    bool _S167;
    if(forwards_0)
    {
        _S167 = run_2->last_crossing_0;
    }
    else
    {
        _S167 = run_2->first_crossing_0;
    }
    bool _S168;
    if(forwards_0)
    {
        _S168 = run_2->first_crossing_0;
    }
    else
    {
        _S168 = run_2->last_crossing_0;
    }
    float _S169 = cell_4->half_width_1;
    float _S170 = - cell_4->half_width_1;
    bool _S171 = _S165 < _S170;
    bool _S172 = _S165 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S167 = !_S167;
    }
    else
    {
        _S167 = false;
    }
    if(_S167)
    {
        _S167 = !shown_2->hole_3;
    }
    else
    {
        _S167 = false;
    }
    bool _S173;
    if(_S167)
    {
        _S173 = shown_2->on_top_0;
    }
    else
    {
        _S173 = false;
    }
    if(_S173)
    {
        if(_S168)
        {
            _S168 = _S171;
        }
        else
        {
            _S168 = false;
        }
        _S168 = !_S168;
    }
    else
    {
        _S168 = false;
    }
    if(shown_2->hole_3)
    {
        _S167 = true;
    }
    else
    {
        if(_S167)
        {
            _S167 = !shown_2->on_top_0;
        }
        else
        {
            _S167 = false;
        }
    }
    float _S174;
    if(_S171)
    {
        _S174 = _S170;
    }
    else
    {
        _S174 = _S169;
    }
    float _S175 = _S174 - _S165;
    if(_S167)
    {
        _S165 = 2.0f * _S166 + _S165 - _S169;
    }
    else
    {
        _S165 = _S166;
    }
    if(_S168)
    {
        if(forwards_0)
        {
            _S165 = run_2->to_end_0;
        }
        else
        {
            _S165 = run_2->from_start_0;
        }
        return _S165;
    }
    if(_S172)
    {
    }
    else
    {
        _S165 = _S175;
    }
    return _S165;
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
    float _S176 = previous_1->rate_0;
    float _S177 = previous_1->rate_0 * step_4;
    float _S178 = rate_1 * step_4;
    bool _S179;
    if(!previous_1->known_0)
    {
        _S179 = true;
    }
    else
    {
        _S179 = here_0->hole_4;
    }
    if(_S179)
    {
        _S179 = true;
    }
    else
    {
        _S179 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S179)
    {
        _S179 = true;
    }
    else
    {
        _S179 = _S176 >= 0.0f;
    }
    if(_S179)
    {
        _S179 = true;
    }
    else
    {
        _S179 = rate_1 <= 0.0f;
    }
    if(_S179)
    {
        return -1.0f;
    }
    float _S180 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S177) >= 0.0f)
    {
        _S179 = (3.0f * clearance_1 - _S178) >= 0.0f;
    }
    else
    {
        _S179 = false;
    }
    if(_S179)
    {
        return -1.0f;
    }
    float _S181 = clearance_1 - _S180;
    float _S182 = 6.0f * _S181 - 4.0f * _S177 - 2.0f * _S178;
    float _S183 = -2.0f * _S177 / (F32_max((_S182 + (F32_sqrt(((F32_max((_S182 * _S182 - 4.0f * (3.0f * (_S177 + _S178 - 2.0f * _S181)) * _S177), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S184 = 1.0f - _S183;
    float _S185 = (_S180 * (2.0f * _S183 + 1.0f) + _S177 * _S183) * _S184 * _S184;
    float _S186 = (clearance_1 * (2.0f * _S184 + 1.0f) - _S178 * _S184) * _S183 * _S183;
    if(_S183 > 0.01999999955296516f)
    {
        _S179 = _S184 > 0.01999999955296516f;
    }
    else
    {
        _S179 = false;
    }
    if(_S179)
    {
        _S179 = (_S185 + _S186) < 0.0f;
    }
    else
    {
        _S179 = false;
    }
    float _S187;
    if(_S179)
    {
        _S187 = _S184 * step_4;
    }
    else
    {
        _S187 = -1.0f;
    }
    return _S187;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S188 = here_1->hole_4;
    float _S189;
    if(here_1->hole_4)
    {
        _S189 = 1.0e+09f;
    }
    else
    {
        _S189 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S189;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S190;
    if(!_S188)
    {
        _S190 = !is_cell_exit_0;
    }
    else
    {
        _S190 = false;
    }
    (&previous_2)->known_0 = _S190;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S191 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S192;
    if(!here_2->hole_4)
    {
        _S192 = (rate_3 * _S191 + clearance_3) < 0.0f;
    }
    else
    {
        _S192 = false;
    }
    if(_S192)
    {
        _S192 = _S191 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S192 = false;
    }
    float _S193 = this_2->step_2;
    float _S194;
    if(_S192)
    {
        _S194 = _S191 - this_2->epsilon_0;
    }
    else
    {
        _S194 = (F32_max((_S191), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S193), (_S194)));
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
    float _S195 = end_0 - start_1;
    float _S196 = start_rate_0 + end_rate_0 - 2.0f * _S195;
    float _S197 = 3.0f * _S195 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S195), (9.99999968265522539e-21f)));
    int i_8 = int(0);
    for(;;)
    {
        if(uint(i_8) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S198 = clamp_1(share_1 - (((_S196 * share_1 + _S197) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S196 * share_1 + 2.0f * _S197) * share_1 + start_rate_0), (0.10000000149011612f * _S195 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S199 = i_8 + int(1);
        share_1 = _S198;
        i_8 = _S199;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_1(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S200 = along_slope_0 * along_slope_0 + 1.0f;
    float _S201 = (F32_rsqrt((_S200)));
    float _S202 = sine_1 * _S201 * (F32_rsqrt((_S200 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S202 * _S200, _S202 * across_slope_0 * along_slope_0 + cosine_0 * _S201);
}

__device__ float arc_sine_0(float x_23)
{
    float _S203 = (F32_abs((x_23)));
    bool _S204 = _S203 > 0.5f;
    float _S205;
    if(_S204)
    {
        _S205 = 0.5f * (1.0f - _S203);
    }
    else
    {
        _S205 = _S203 * _S203;
    }
    float _S206;
    if(_S204)
    {
        _S206 = (F32_sqrt(((F32_max((_S205), (0.0f))))));
    }
    else
    {
        _S206 = _S203;
    }
    float _S207 = ((((0.04216320067644119f * _S205 + 0.02418131195008755f) * _S205 + 0.04547002539038658f) * _S205 + 0.07495300471782684f) * _S205 + 0.16666752099990845f) * _S205 * _S206 + _S206;
    if(_S204)
    {
        _S205 = 1.57079637050628662f - 2.0f * _S207;
    }
    else
    {
        _S205 = _S207;
    }
    if(x_23 < 0.0f)
    {
        _S205 = - _S205;
    }
    return _S205;
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

__device__ Albedos_0 albedos_of_0(uint family_8, uint thread_6)
{
    Family_0 _S208 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    Family_0 _S209 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    return table_albedos_0(_S208.albedo_table_0 + _S209.albedo_stride_0 * thread_6);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S210 = value_0 * 747796405U + 2891336453U;
    uint _S211 = ((_S210 >> ((_S210 >> int(28)) + 4U)) ^ _S210) * 277803737U;
    return (_S211 >> int(22)) ^ _S211;
}

__device__ float uniform_hash_0(uint thread_7, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_7 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float thread_gain_0(uint thread_8, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_8, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_1, float3  room_0)
{
    float3  _S212 = room_0 / max_0(albedo_1, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S212.x), (_S212.y)))), (_S212.z)))), (0.0f))))));
}

__device__ float fibre_gain_0(uint thread_9, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_6, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

__device__ float diffuse_reflection_0(float3  light_0, float3  normal_2, float blend_0)
{
    float _S213 = light_0.z;
    if(_S213 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_1((F32_max((_S213), (0.0f))), (F32_max((dot_0(light_0, normal_2)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_2, float roughness_1)
{
    float _S214 = dot_0(direction_2, tangent_2);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S214 * _S214 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_24)
{
    float _S215 = clamp_1(x_24, -87.0f, 88.0f);
    float _S216 = (F32_floor((_S215 * 1.4426950216293335f + 0.5f)));
    float _S217 = _S215 - _S216 * 0.693359375f + _S216 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S217 + 0.00139819993637502f) * _S217 + 0.00833345204591751f) * _S217 + 0.04166579619050026f) * _S217 + 0.1666666567325592f) * _S217 + 0.5f;
    float _S218 = (U32_asfloat((uint(int(_S216) + int(127)) << int(23))));
    float _S219;
    if(x_24 < -87.0f)
    {
        _S219 = 0.0f;
    }
    else
    {
        _S219 = (p_0 * _S217 * _S217 + _S217 + 1.0f) * _S218;
    }
    return _S219;
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
    float _S220 = roughness_2 * roughness_2;
    float _S221 = squared_along_0 * (1.0f - _S220) + _S220;
    return 0.31830987334251404f * _S220 * roughness_2 / (_S221 * _S221);
}

__device__ float density_between_0(float3  light_1, float3  view_0, float3  tangent_3, float roughness_3)
{
    float3  _S222 = light_1 + view_0;
    float _S223 = dot_0(_S222, tangent_3);
    return flake_density_0((F32_min((_S223 * _S223 / (F32_max((square_1(_S222)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float transmission_1(float3  light_2, float3  view_1, float3  normal_3, float3  tangent_4, float roughness_4, float optical_depth_1)
{
    float _S224 = - dot_0(light_2, normal_3);
    float _S225 = dot_0(view_1, normal_3);
    bool _S226;
    if(_S224 <= 0.0f)
    {
        _S226 = true;
    }
    else
    {
        _S226 = _S225 <= 0.0f;
    }
    if(_S226)
    {
        return 0.0f;
    }
    float _S227 = 1.0f / (F32_max((_S225), (9.99999997475242708e-07f)));
    float _S228 = projected_area_1(light_2, tangent_4, roughness_4) / (F32_max((_S224), (9.99999997475242708e-07f)));
    float _S229 = projected_area_1(view_1, tangent_4, roughness_4) * _S227;
    return density_between_0(light_2, view_1, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * (F32_min((_S228), (_S229)))) * mean_attenuation_0(optical_depth_1 * (F32_abs((_S228 - _S229)))) * _S227;
}

__device__ float reflection_0(float3  light_3, float3  view_2, float3  normal_4, float3  tangent_5, float roughness_5, float optical_depth_2)
{
    float _S230 = dot_0(light_3, normal_4);
    bool _S231;
    if(_S230 <= 0.0f)
    {
        _S231 = true;
    }
    else
    {
        _S231 = (dot_0(view_2, normal_4)) <= 0.0f;
    }
    if(_S231)
    {
        return 0.0f;
    }
    float _S232 = (F32_max((_S230), (9.99999997475242708e-07f)));
    float _S233 = (F32_max((dot_0(view_2, normal_4)), (9.99999997475242708e-07f)));
    float _S234 = projected_area_1(light_3, tangent_5, roughness_5) * _S233 + projected_area_1(view_2, tangent_5, roughness_5) * _S232;
    float _S235 = optical_depth_2 * _S234 / (_S232 * _S233);
    return 0.25f * density_between_0(light_3, view_2, tangent_5, roughness_5) * (_S235 * mean_attenuation_0(_S235)) * _S232 / _S234;
}

__device__ Components_0 with_added_0(Components_0 * sums_0, Components_0 * more_0, float weight_1)
{
    Components_0 result_11;
    (&result_11)->diffuse_warp_0 = sums_0->diffuse_warp_0 + weight_1 * more_0->diffuse_warp_0;
    (&result_11)->diffuse_weft_0 = sums_0->diffuse_weft_0 + weight_1 * more_0->diffuse_weft_0;
    (&result_11)->specular_warp_0 = sums_0->specular_warp_0 + weight_1 * more_0->specular_warp_0;
    (&result_11)->specular_weft_0 = sums_0->specular_weft_0 + weight_1 * more_0->specular_weft_0;
    (&result_11)->light_visibility_1 = sums_0->light_visibility_1 + weight_1 * more_0->light_visibility_1;
    (&result_11)->hole_2 = sums_0->hole_2 + weight_1 * more_0->hole_2;
    return result_11;
}

__device__ Blocked_0 scaled_0(Blocked_0 * blocked_0, float share_2)
{
    Blocked_0 result_12;
    (&result_12)->by_warp_0 = share_2 * blocked_0->by_warp_0;
    (&result_12)->by_weft_0 = share_2 * blocked_0->by_weft_0;
    (&result_12)->far_0 = share_2 * blocked_0->far_0;
    return result_12;
}

__device__ float wrapped_cell_0(float position_3, float count_1)
{
    return (F32_min(((F32_floor(((position_3 - (F32_floor((position_3)))) * count_1)))), (count_1 - 1.0f)));
}

__device__ float arc_tangent_quotient_0(float x_25, float y_12)
{
    return ((((((0.0f * x_25 + 0.00809729471802711f) * x_25 + -0.0377517081797123f) * x_25 + 0.08475969731807709f) * x_25 + -0.13537675142288208f) * x_25 + 0.19895026087760925f) * x_25 + -0.33327975869178772f) * x_25 + 0.99999970197677612f;
}

__device__ float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

__device__ float arc_tangent_0(float y_13, float x_26)
{
    float _S236 = (F32_abs((x_26)));
    float _S237 = (F32_abs((y_13)));
    float angle_0 = arc_tangent_of_ratio_0((F32_min((_S236), (_S237))) / (F32_max(((F32_max((_S236), (_S237)))), (1.00000000317107685e-30f))));
    float angle_1;
    if(_S237 > _S236)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_26 < 0.0f)
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
    float _S238 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    float _S239 = (F32_floor((_S238)));
    float _S240 = _S238 - _S239;
    float _S241 = (F32_sqrt((clamp_1((1.0f - (F32_abs((direction_3.z)))) / 0.97000002861022949f, 0.0f, 1.0f))));
    float _S242 = 7.0f * _S241 * (F32_sqrt((_S241)));
    float _S243 = (F32_min(((F32_floor((_S242)))), (6.0f)));
    float _S244 = _S242 - _S243;
    uint _S245 = uint(int(_S239) + int(32)) % 32U;
    uint _S246 = uint(_S243);
    uint _S247 = _S245 * 8U + _S246;
    uint _S248 = (_S245 + 1U) % 32U * 8U + _S246;
    NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = make_uint4 (_S247, _S247 + 1U, _S248, _S248 + 1U);
    float _S249 = 1.0f - _S240;
    float _S250 = 1.0f - _S244;
    float4  _S251 = make_float4 (_S249 * _S250, _S249 * _S244, _S240 * _S250, _S240 * _S244) * make_float4 (252.0f) + make_float4 (0.5f);
    uint4  _S252 = make_uint4 ((uint)_S251.x, (uint)_S251.y, (uint)_S251.z, (uint)_S251.w);
    (&taps_0)->weights_0 = _S252;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S252.x + _S252.y + _S252.z + _S252.w);
    return taps_0;
}

__device__ float3  half_vector_0(float3  light_4, float3  view_3)
{
    float3  _S253 = light_4 + view_3;
    return _S253 * make_float3 ((F32_rsqrt(((F32_max((square_1(_S253)), (9.999999960041972e-13f)))))));
}

__device__ float3  shadow_correlation_0(float3  light_5, float3  view_4)
{
    float2  _S254 = float2 {light_5.x, light_5.y};
    float2  _S255 = float2 {view_4.x, view_4.y};
    float _S256 = dot_1(_S254, _S255) / (F32_max(((F32_sqrt((dot_1(_S254, _S254) * dot_1(_S255, _S255))))), (9.99999997475242708e-07f)));
    if((light_5.z) < 0.0f)
    {
        return make_float3 (make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S256).x, make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S256).y, 0.0f);
    }
    return make_float3 ((F32_min((0.62000000476837158f + 0.62999999523162842f * _S256), (1.20000004768371582f))), 0.62000000476837158f, 0.37000000476837158f);
}

__device__ float4  bytes_of_sums_0(uint even_0, uint odd_0)
{
    return make_float4 (float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

__device__ float4  interpolate_0(NodeTaps_0 * taps_1, uint4  packs_2)
{
    uint4  _S257 = (packs_2 & make_uint4 (16711935U)) * taps_1->weights_0;
    uint4  _S258 = ((packs_2 >> make_uint4 (int(8))) & make_uint4 (16711935U)) * taps_1->weights_0;
    return bytes_of_sums_0(_S257.x + _S257.y + _S257.z + _S257.w, _S258.x + _S258.y + _S258.z + _S258.w) * make_float4 (taps_1->inverse_sum_0);
}

__device__ float4  interpolate_table_0(NodeTaps_0 * taps_2, uint table_0, uint stride_0)
{
    uint4  _S259 = make_uint4 (table_0) + taps_2->nodes_0 * make_uint4 (stride_0);
    uint _S260 = __ldg((&(globalParams_0->words_0)[_S259.x]));
    uint _S261 = __ldg((&(globalParams_0->words_0)[_S259.y]));
    uint _S262 = __ldg((&(globalParams_0->words_0)[_S259.z]));
    uint _S263 = __ldg((&(globalParams_0->words_0)[_S259.w]));
    float4  _S264 = interpolate_0(taps_2, make_uint4 (_S260, _S261, _S262, _S263));
    return _S264;
}

struct Group_0
{
    float3  normal_5;
    float weight_2;
    float3  tangent_6;
    float3  variance_0;
    float3  covariance_0;
    float roughness_6;
};

__device__ Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    (&group_0)->normal_5 = make_float3 (table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    (&group_0)->weight_2 = table_number_0(row_1 + 3U);
    float3  _S265 = make_float3 (table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    (&group_0)->tangent_6 = _S265;
    float _S266 = table_number_0(row_1 + 7U);
    float _S267 = table_number_0(row_1 + 8U);
    (&group_0)->variance_0 = make_float3 (_S266, _S267, 1.0f - square_1(_S265) - _S266 - _S267);
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
    float _S268 = direction_4.x;
    float _S269 = direction_4.y;
    float _S270 = direction_4.z;
    return (F32_max((dot_0(this_5->variance_0, direction_4 * direction_4) + 2.0f * dot_0(this_5->covariance_0, make_float3 (_S268 * _S269, _S268 * _S270, _S269 * _S270))), (0.0f)));
}

__device__ float mean_area_0(Group_0 * group_1, float3  direction_5)
{
    float _S271 = dot_0(direction_5, group_1->tangent_6);
    float _S272 = _S271 * _S271;
    float _S273 = Group_variance_along_0(group_1, direction_5);
    float _S274 = group_1->roughness_6 * group_1->roughness_6;
    return (F32_sqrt(((F32_max(((_S274 - 1.0f) * (_S272 + _S273) + 1.0f), (_S274))))));
}

__device__ float mean_density_0(Group_0 * group_2, float3  half_0)
{
    float _S275 = group_2->roughness_6;
    float _S276 = (F32_max(((F32_sqrt(((F32_max((1.0f - group_2->roughness_6 * group_2->roughness_6), (0.0f)))))) / group_2->roughness_6), (0.00100000004749745f)));
    float _S277 = Group_variance_along_0(group_2, half_0);
    float _S278 = (F32_max(((F32_sqrt((3.0f * _S277)))), (_S275 * 0.01999999955296516f + 0.00009999999747379f)));
    float _S279 = dot_0(half_0, group_2->tangent_6);
    float _S280 = _S276 * (_S279 - _S278);
    float _S281 = _S276 * (_S279 + _S278);
    float _S282 = _S280 * _S281;
    float _S283 = 2.0f * _S278 * _S276;
    return 0.15915493667125702f / _S275 * ((1.0f - _S282) / ((_S280 * _S280 + 1.0f) * (_S281 * _S281 + 1.0f)) + arc_tangent_0(_S283, 1.0f + _S282) / _S283);
}

__device__ float layer_value_0(Group_0 * group_3, float3  half_1, float3  light_6, float3  view_5, float optical_depth_3)
{
    bool _S284 = (light_6.z) < 0.0f;
    float3  _S285 = group_3->normal_5;
    float _S286 = dot_0(light_6, group_3->normal_5);
    float _S287;
    if(_S284)
    {
        _S287 = - _S286;
    }
    else
    {
        _S287 = _S286;
    }
    float _S288 = (F32_max((_S287), (0.01999999955296516f)));
    float _S289 = (F32_max((dot_0(view_5, _S285)), (0.01999999955296516f)));
    float _S290 = mean_area_0(group_3, light_6);
    float _S291 = _S290 / _S288;
    float _S292 = mean_area_0(group_3, view_5);
    float _S293 = _S292 / _S289;
    if(_S284)
    {
        _S287 = (F32_abs((_S291 - _S293)));
    }
    else
    {
        _S287 = _S291 + _S293;
    }
    float _S294 = optical_depth_3 * (F32_max((_S287), (0.00100000004749745f)));
    if(_S284)
    {
        _S287 = exponential_0(- optical_depth_3 * (F32_min((_S291), (_S293))));
    }
    else
    {
        _S287 = 1.0f;
    }
    float _S295 = optical_depth_3 * _S287 * (1.0f - exponential_0(- _S294)) / _S294 / _S289;
    if(_S284)
    {
        _S287 = 1.0f;
    }
    else
    {
        _S287 = 1.0f - 0.34999999403953552f * (1.0f - square_1(_S285));
    }
    float _S296 = mean_density_0(group_3, half_1);
    return 0.25f * _S296 * _S287 * _S295;
}

struct Bound_0
{
    uint thread_10;
    float turns_2;
    float cell_7;
    float visible_0;
    float width_2;
    float gap_0;
};

__device__ Bound_0 bound_at_0(uint family_9, float position_4)
{
    Cell_0 _S297 = locate_0(family_9, position_4);
    Family_0 _S298 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
    float _S299 = table_number_0(_S298.before_0 + 2U * _S297.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_10 = _S297.thread_0;
    Family_0 _S300 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
    float _S301 = position_4 - _S300.start_0 - _S299 - _S297.below_0;
    Family_0 _S302 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
    (&bound_0)->turns_2 = (F32_round((_S301 * _S302.inverse_period_0)));
    (&bound_0)->cell_7 = _S297.below_0;
    float _S303 = 2.0f * _S297.half_width_1;
    (&bound_0)->width_2 = _S303;
    (&bound_0)->visible_0 = clamp_1((_S297.across_2 + _S297.half_width_1) / _S303, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S297.below_0), (_S297.below_0 - _S297.across_2 - _S297.half_width_1))) + (F32_max((_S297.across_2 - _S297.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

__device__ Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1)
{
    Family_0 _S304 = slang_ldg_2((&(globalParams_0->families_0)[family_10]));
    float _S305 = centre_1 - _S304.start_0;
    Family_0 _S306 = slang_ldg_2((&(globalParams_0->families_0)[family_10]));
    float _S307 = (F32_floor((_S305 * _S306.inverse_period_0)));
    Family_0 _S308 = slang_ldg_2((&(globalParams_0->families_0)[family_10]));
    float _S309 = centre_1 - _S307 * _S308.period_0;
    Family_0 _S310 = slang_ldg_2((&(globalParams_0->families_0)[family_10]));
    float _S311 = 0.5f * (F32_max((size_1), (_S310.smallest_box_0)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_0 = bound_at_0(family_10, _S309 - _S311);
    (&stretch_0)->high_0 = bound_at_0(family_10, _S309 + _S311);
    return stretch_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

__device__ float3  lengths_0(uint family_11, Stretch_0 * stretch_1)
{
    float _S312 = Stretch_turns_0(stretch_1);
    Family_0 _S313 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    uint _S314 = _S313.before_0 + 2U * (&stretch_1->low_0)->thread_10;
    Family_0 _S315 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    uint _S316 = _S315.before_0 + 2U * (&stretch_1->high_0)->thread_10;
    float _S317 = table_number_0(_S316) - table_number_0(_S314);
    float _S318 = table_number_0(_S316 + 1U) - table_number_0(_S314 + 1U);
    float _S319 = _S317 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_2 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_2;
    Family_0 _S320 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    float _S321 = _S319 + _S312 * _S320.visible_total_0;
    float _S322 = _S318 - _S317 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0;
    Family_0 _S323 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    Family_0 _S324 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    float _S325 = _S322 + _S312 * (_S323.period_0 - _S324.visible_total_0);
    float _S326 = _S318 + (&stretch_1->high_0)->cell_7 - (&stretch_1->low_0)->cell_7;
    Family_0 _S327 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    return make_float3 (_S321, _S325, _S326 + _S312 * _S327.period_0);
}

__device__ float2  integrals_along_0(uint family_12, Stretch_0 * stretch_2, uint quantity_0)
{
    Family_0 _S328 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    Family_0 _S329 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    uint _S330 = 3U * _S328.quantities_0;
    uint _S331 = _S329.colour_threads_0 + _S330 * (&stretch_2->low_0)->thread_10 + quantity_0;
    Family_0 _S332 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    uint _S333 = _S332.colour_threads_0 + _S330 * (&stretch_2->high_0)->thread_10 + quantity_0;
    Family_0 _S334 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    Family_0 _S335 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    uint _S336 = _S334.colour_threads_0 + _S330 * uint(_S335.count_0) + quantity_0;
    float _S337 = table_number_0(_S331);
    float _S338 = table_number_0(_S333);
    float _S339 = Stretch_turns_0(stretch_2);
    uint _S340 = 2U * _S328.quantities_0;
    return make_float2 (table_number_0(_S333 + _S328.quantities_0) - table_number_0(_S331 + _S328.quantities_0) + _S338 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_2 - _S337 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_2 + _S339 * table_number_0(_S336 + _S328.quantities_0), table_number_0(_S333 + _S340) - table_number_0(_S331 + _S340) + _S338 * (&stretch_2->high_0)->cell_7 - _S337 * (&stretch_2->low_0)->cell_7 + _S339 * table_number_0(_S336 + _S340));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_7)
{
    return ((&this_7->high_0)->thread_10) < ((&this_7->low_0)->thread_10);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_8, uint4  entries_0, uint whole_0)
{
    uint _S341 = entries_0.z;
    uint _S342 = entries_0.x;
    uint _S343 = _S341 - _S342;
    bool _S344 = Stretch_wraps_0(this_8);
    uint _S345;
    if(_S344)
    {
        _S345 = whole_0;
    }
    else
    {
        _S345 = 0U;
    }
    return make_uint4 (_S343 + _S345, entries_0.w - _S341, entries_0.y - _S342, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_4, uint row_2, uint count_2, uint quantities_1)
{
    uint _S346 = row_2 + (&across_4->low_0)->thread_10 * quantities_1;
    uint _S347 = row_2 + (&across_4->high_0)->thread_10 * quantities_1;
    uint _S348 = __ldg((&(globalParams_0->words_0)[_S346]));
    uint _S349 = __ldg((&(globalParams_0->words_0)[_S346 + quantities_1]));
    uint _S350 = __ldg((&(globalParams_0->words_0)[_S347]));
    uint _S351 = __ldg((&(globalParams_0->words_0)[_S347 + quantities_1]));
    uint4  _S352 = make_uint4 (_S348, _S349, _S350, _S351);
    uint _S353 = __ldg((&(globalParams_0->words_0)[row_2 + count_2 * quantities_1]));
    uint4  _S354 = Stretch_differences_0(across_4, _S352, _S353);
    return _S354;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_9)
{
    float _S355 = (&this_9->high_0)->visible_0;
    float _S356 = - (&this_9->low_0)->visible_0;
    float _S357 = Stretch_turns_0(this_9);
    bool _S358 = Stretch_wraps_0(this_9);
    float _S359;
    if(_S358)
    {
        _S359 = 1.0f;
    }
    else
    {
        _S359 = 0.0f;
    }
    return make_float4 (1.0f, _S355, _S356, _S357 - _S359);
}

__device__ float integral_on_top_0(uint family_13, Stretch_0 * across_5, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    Family_0 _S360 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint _S361 = uint(_S360.count_0);
    uint _S362 = _S361 + 1U;
    Family_0 _S363 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint _S364 = _S362 * _S363.quantities_0;
    Family_0 _S365 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint _S366 = _S365.colour_areas_0 + quantity_1;
    uint _S367 = (&along_0->low_0)->thread_10;
    uint _S368 = _S366 + (&along_0->low_0)->thread_10 * _S364;
    Family_0 _S369 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S370 = row_differences_0(across_5, _S368, _S361, _S369.quantities_0);
    uint _S371 = _S366 + (_S367 + 1U) * _S364;
    Family_0 _S372 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S373 = row_differences_0(across_5, _S371, _S361, _S372.quantities_0);
    uint _S374 = (&along_0->high_0)->thread_10;
    uint _S375 = _S366 + (&along_0->high_0)->thread_10 * _S364;
    Family_0 _S376 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S377 = row_differences_0(across_5, _S375, _S361, _S376.quantities_0);
    uint _S378 = _S366 + (_S374 + 1U) * _S364;
    Family_0 _S379 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S380 = row_differences_0(across_5, _S378, _S361, _S379.quantities_0);
    uint _S381 = _S366 + crossing_count_0 * _S364;
    Family_0 _S382 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S383 = row_differences_0(across_5, _S381, _S361, _S382.quantities_0);
    uint4  _S384 = _S377 - _S370;
    bool _S385 = Stretch_wraps_0(along_0);
    uint4  _S386;
    if(_S385)
    {
        _S386 = _S383;
    }
    else
    {
        int4  _S387 = make_int4 (int(0));
        uint4  _S388 = make_uint4 ((uint)_S387.x, (uint)_S387.y, (uint)_S387.z, (uint)_S387.w);
        _S386 = _S388;
    }
    uint4  _S389 = _S384 + _S386;
    float4  _S390 = Stretch_weights_0(across_5);
    float4  _S391 = Stretch_weights_0(along_0);
    int4  _S392 = make_int4 ((int)_S389.x, (int)_S389.y, (int)_S389.z, (int)_S389.w);
    float4  _S393 = make_float4 ((float)_S392.x, (float)_S392.y, (float)_S392.z, (float)_S392.w);
    uint4  _S394 = _S380 - _S377;
    int4  _S395 = make_int4 ((int)_S394.x, (int)_S394.y, (int)_S394.z, (int)_S394.w);
    float4  _S396 = make_float4 ((float)_S395.x, (float)_S395.y, (float)_S395.z, (float)_S395.w);
    uint4  _S397 = _S373 - _S370;
    int4  _S398 = make_int4 ((int)_S397.x, (int)_S397.y, (int)_S397.z, (int)_S397.w);
    float4  _S399 = make_float4 ((float)_S398.x, (float)_S398.y, (float)_S398.z, (float)_S398.w);
    int4  _S400 = make_int4 ((int)_S383.x, (int)_S383.y, (int)_S383.z, (int)_S383.w);
    float4  _S401 = make_float4 ((float)_S400.x, (float)_S400.y, (float)_S400.z, (float)_S400.w);
    float _S402 = dot_2(make_float4 (dot_2(_S393, _S390), dot_2(_S396, _S390), dot_2(_S399, _S390), dot_2(_S401, _S390)), _S391);
    Family_0 _S403 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    return _S402 * _S403.area_unit_0;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_3, uint row_3)
{
    Albedos_0 _S404 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_3) * _S404.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_3) * _S404.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_3) * _S404.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_3) * _S404.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, Stretch_0 * own_1, Stretch_0 * other_2, bool back_4)
{
    Family_0 _S405 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
    Albedos_0 albedos_2 = table_albedos_0(_S405.colour_mean_0);
    Family_0 _S406 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
    if((_S406.quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3  _S407 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_4 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        Family_0 _S408 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
        if(quantity_2 < (_S408.quantities_0))
        {
        }
        else
        {
            break;
        }
        float2  _S409 = integrals_along_0(family_14, own_1, quantity_2);
        Family_0 _S410 = slang_ldg_2((&(globalParams_0->families_0)[crossing_1]));
        float _S411 = integral_on_top_0(family_14, own_1, other_2, uint(_S410.count_0), quantity_2);
        float _S412 = _S409.x;
        float _S413 = _S412 * _S407.x;
        float _S414;
        if(back_4)
        {
            _S414 = _S413 - _S411;
        }
        else
        {
            _S414 = _S411;
        }
        bool _S415 = quantity_2 == 0U;
        if(_S415)
        {
            Family_0 _S416 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
            float _S417 = 16.0f * _S416.area_unit_0;
            Family_0 _S418 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
            is_exposed_0 = _S414 > (_S417 * (F32_min((_S413 / _S418.crossing_area_0), (1.0f))) + 0.00000999999974738f * _S413);
        }
        float _S419 = _S412 * _S407.y;
        float _S420;
        if(is_exposed_0)
        {
            _S420 = _S414;
        }
        else
        {
            _S420 = 0.0f;
        }
        float _S421 = _S419 + _S420 + 0.000244140625f * _S407.z * _S409.y;
        if(_S415)
        {
            weight_4 = 1.0f / (F32_max((_S421), (9.99999968265522539e-21f)));
        }
        else
        {
            float _S422 = _S421 * weight_4;
            Family_0 _S423 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
            uint _S424 = _S423.colour_axes_0 + 12U * (quantity_2 - 1U);
            Albedos_0 _S425 = albedos_2;
            Albedos_0 _S426 = with_added_albedos_0(&_S425, _S422, _S424);
            albedos_2 = _S426;
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
    float3  _S427 = make_float3 (weight_5);
    (&albedos_3)->diffuse_reflect_0 = lerp_0(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S427);
    (&albedos_3)->diffuse_transmit_0 = lerp_0(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S427);
    (&albedos_3)->specular_reflect_0 = lerp_0(first_2->specular_reflect_0, second_1->specular_reflect_0, _S427);
    (&albedos_3)->specular_transmit_0 = lerp_0(first_2->specular_transmit_0, second_1->specular_transmit_0, _S427);
    return albedos_3;
}

__device__ Albedos_0 tinted_0(Albedos_0 * albedos_4, float3  tint_0)
{
    Albedos_0 result_13 = *albedos_4;
    (&result_13)->diffuse_reflect_0 = (&result_13)->diffuse_reflect_0 * tint_0;
    (&result_13)->diffuse_transmit_0 = (&result_13)->diffuse_transmit_0 * tint_0;
    return result_13;
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
    float3  _S428 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S429 = sends_0->sky_warp_0 + _S428 * sends_0->crossing_warp_0;
    (&found_0)->warp_3 = _S429;
    float3  _S430 = sends_0->sky_weft_0 + _S428 * sends_0->crossing_weft_0;
    (&found_0)->weft_3 = _S430;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S429 + make_float3 (sends_0->blocks_weft_0) * _S430;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

__device__ void view_terms_0(float3  view_6, FixedArray<float, 6>  * terms_0)
{
    float _S431 = 1.0f - view_6.z;
    float _S432 = _S431 * _S431;
    (*terms_0)[int(0)] = 1.0f;
    float _S433 = view_6.x;
    float _S434 = _S433 * _S433;
    float _S435 = view_6.y;
    float _S436 = _S435 * _S435;
    (*terms_0)[int(1)] = (F32_sqrt(((F32_max((_S434 + _S436), (9.999999960041972e-13f))))));
    (*terms_0)[int(2)] = _S432;
    (*terms_0)[int(3)] = _S432 * _S432;
    (*terms_0)[int(4)] = _S434 - _S436;
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
    float3  back_5;
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
    float3  _S437 = make_float3 (blocked_1->by_warp_0 + blocked_1->by_weft_0) * interior_0->leaked_1;
    float3  _S438 = make_float3 (blocked_1->far_0) * yarn_2->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_5 * (make_float3 (blocked_1->by_warp_0) * interior_0->warp_4 + make_float3 (blocked_1->by_weft_0) * interior_0->weft_4) + _S438 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S438 * interior_0->far_1 + yarn_2->back_5 * _S437;
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
    float _S439 = light_7.z;
    float3  _S440;
    if((_S439 * view_7.z) < 0.0f)
    {
        _S440 = bounced_1->transmitted_0;
    }
    else
    {
        _S440 = bounced_1->reflected_0;
    }
    return _S440 * make_float3 ((F32_abs((_S439))) * 0.31830987334251404f);
}

__device__ float sheen_scale_0(float x_27, float y_14)
{
    return (((((0.0f * x_27 + (((((-1.1402510404586792f * y_14 + 0.40672621130943298f) * y_14 + 1.65398800373077393f) * y_14 + -1.29730904102325439f) * y_14 + 0.30570998787879944f) * y_14 + -0.0220868494361639f)) * x_27 + (((((-0.21142719686031342f * y_14 + 1.05947399139404297f) * y_14 + -0.41116121411323547f) * y_14 + -0.93859231472015381f) * y_14 + 0.51606941223144531f) * y_14 + 0.05409301072359085f)) * x_27 + (((((1.22944498062133789f * y_14 + -0.45962560176849365f) * y_14 + -1.63861405849456787f) * y_14 + 1.33565104007720947f) * y_14 + -0.45725581049919128f) * y_14 + 0.08243165910243988f)) * x_27 + (((((0.39779931306838989f * y_14 + -1.18879103660583496f) * y_14 + 0.28251591324806213f) * y_14 + 1.168984055519104f) * y_14 + -0.76864629983901978f) * y_14 + 0.0091691892594099f)) * x_27 + (((((-0.26563560962677002f * y_14 + -0.19379159808158875f) * y_14 + 0.2677634060382843f) * y_14 + 0.00270519289188087f) * y_14 + 0.14349560439586639f) * y_14 + 0.10290180146694183f)) * x_27 + (((((-0.20701569318771362f * y_14 + 0.24526430666446686f) * y_14 + 0.19551840424537659f) * y_14 + 0.07586126774549484f) * y_14 + 0.38894739747047424f) * y_14 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_28, float y_15)
{
    return ((((0.0f * x_28 + (((((-0.10608240216970444f * y_15 + 1.99214303493499756f) * y_15 + -1.42255294322967529f) * y_15 + -1.09495604038238525f) * y_15 + 0.59180057048797607f) * y_15 + 0.06902855634689331f)) * x_28 + (((((-0.46220690011978149f * y_15 + -0.29113379120826721f) * y_15 + 1.39025199413299561f) * y_15 + 0.35589990019798279f) * y_15 + -1.17120099067687988f) * y_15 + 0.15940259397029877f)) * x_28 + (((((2.26068711280822754f * y_15 + -3.64728999137878418f) * y_15 + -0.72173482179641724f) * y_15 + 3.07659196853637695f) * y_15 + -0.6827620267868042f) * y_15 + -0.3039557933807373f)) * x_28 + (((((0.81201767921447754f * y_15 + 0.36014080047607422f) * y_15 + -1.72646903991699219f) * y_15 + -0.22630110383033752f) * y_15 + 0.89514690637588501f) * y_15 + -0.10397960245609283f)) * x_28 + (((((-0.37648698687553406f * y_15 + 1.10974001884460449f) * y_15 + 0.17824520170688629f) * y_15 + -1.04968702793121338f) * y_15 + 0.1461234986782074f) * y_15 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_29, float y_16)
{
    return ((((0.0f * x_29 + (((((12.95646953582763672f * y_16 + -21.38032913208007812f) * y_16 + -7.37853097915649414f) * y_16 + 34.55607986450195312f) * y_16 + -23.61347007751464844f) * y_16 + 5.00126314163208008f)) * x_29 + (((((10.91487026214599609f * y_16 + -6.08202791213989258f) * y_16 + -38.2036285400390625f) * y_16 + 53.3440399169921875f) * y_16 + -21.91996002197265625f) * y_16 + 2.01606011390686035f)) * x_29 + (((((-14.52206039428710938f * y_16 + 36.803619384765625f) * y_16 + -22.94047927856445312f) * y_16 + -10.07973003387451172f) * y_16 + 15.77003955841064453f) * y_16 + -4.92722177505493164f)) * x_29 + (((((-7.62505722045898438f * y_16 + 1.27310299873352051f) * y_16 + 31.19523048400878906f) * y_16 + -44.39989852905273438f) * y_16 + 26.44947052001953125f) * y_16 + -8.73507976531982422f)) * x_29 + (((((5.65633487701416016f * y_16 + -17.66820907592773438f) * y_16 + 24.65356063842773438f) * y_16 + -19.38941001892089844f) * y_16 + 11.06159019470214844f) * y_16 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S441 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S442 = 2.0f * (F32_sqrt((_S441))) - 1.0f;
    float _S443 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_8, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S442, _S443), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S441) * sheen_shear_0(_S442, _S443), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S442, _S443), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_8, float3  view_8, float scale_0, float shear_0)
{
    float _S444 = light_8.z;
    bool _S445;
    if(_S444 <= 0.0f)
    {
        _S445 = true;
    }
    else
    {
        _S445 = (view_8.z) <= 0.0f;
    }
    if(_S445)
    {
        return 0.0f;
    }
    float2  _S446 = float2 {view_8.x, view_8.y};
    float _S447 = dot_1(_S446, _S446);
    float2  _S448;
    if(_S447 > 9.99999968265522539e-21f)
    {
        _S448 = _S446 * make_float2 ((F32_rsqrt((_S447))));
    }
    else
    {
        _S448 = make_float2 (1.0f, 0.0f);
    }
    float _S449 = scale_0 * dot_1(float2 {light_8.x, light_8.y}, _S448) + shear_0 * _S444;
    float _S450 = scale_0 * (light_8.y * _S448.x - light_8.x * _S448.y);
    float _S451 = _S449 * _S449 + _S450 * _S450 + _S444 * _S444;
    return 0.31830987334251404f * scale_0 * scale_0 * _S444 / (F32_max((_S451 * _S451), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_9, float3  view_9, float strength_0, float roughness_9)
{
    float3  _S452 = sheen_lobe_0(view_9.z, roughness_9);
    float _S453 = strength_0 * _S452.z;
    return make_float2 (_S453 * transformed_cosine_0(light_9, view_9, _S452.x, _S452.y), 1.0f - _S453);
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

__device__ Regime_0 regime_of_0(uint _S454, Footprint_0 * _S455, float _S456)
{
    Fabric_0 * _S457 = (&(globalParams_0->fabrics_0)[_S454]);
    float _S458 = Footprint_spread_side_0(_S455);
    float _S459 = binary_logarithm_0((F32_max((_S458), (9.99999971718068537e-10f))));
    Lobes_0 _S460 = slang_ldg_1(&_S457->lobes_0);
    float _S461 = clamp_1((_S459 - _S460.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S462 = _S461 * _S461 * (3.0f - 2.0f * _S461);
    (&regime_0)->prefiltered_0 = _S462;
    (&regime_0)->threads_1 = _S458 * _S460.threads_per_mm_0;
    float _S463 = lerp_1((F32_max((8.0f / _S456), (1.0f))), 1.0f, _S462);
    float _S464;
    if(_S462 < 1.0f)
    {
        _S464 = clamp_1((&regime_0)->threads_1 * 12.0f, 1.0f, _S463);
    }
    else
    {
        _S464 = 0.0f;
    }
    (&regime_0)->points_1 = _S464;
    return regime_0;
}

struct Hit_0
{
    float x_30;
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

__device__ Crossing_0 crossing_at_0(uint _S465, float _S466, float _S467, bool _S468)
{
    Fabric_0 * _S469 = (&(globalParams_0->fabrics_0)[_S465]);
    Crossing_0 crossing_3;
    uint _S470 = __ldg(&_S469->warp_0);
    (&crossing_3)->warp_2 = locate_0(_S470, _S466);
    uint _S471 = __ldg(&_S469->weft_0);
    (&crossing_3)->weft_2 = locate_0(_S471, _S467);
    uint _S472 = __ldg(&_S469->run_words_0);
    uint _S473 = (&(&crossing_3)->weft_2)->thread_0;
    uint _S474 = __ldg(&_S469->ends_1);
    uint _S475 = _S472 + 2U * (_S473 * _S474 + (&(&crossing_3)->warp_2)->thread_0);
    uint _S476 = __ldg((&(globalParams_0->words_0)[_S475]));
    (&crossing_3)->warp_word_0 = _S476;
    uint _S477 = __ldg((&(globalParams_0->words_0)[_S475 + 1U]));
    (&crossing_3)->weft_word_0 = _S477;
    (&crossing_3)->warp_above_0 = ((_S476 & 1U) == 1U) != _S468;
    return crossing_3;
}

__device__ Sample_0 sample_at_0(uint _S478, float _S479, float _S480, bool _S481)
{
    Fabric_0 * _S482 = (&(globalParams_0->fabrics_0)[_S478]);
    Sample_0 sample_0;
    Crossing_0 _S483 = crossing_at_0(_S478, _S479, _S480, _S481);
    (&sample_0)->crossing_2 = _S483;
    Crossing_0 _S484 = _S483;
    Shown_0 _S485 = shown_at_0(&_S484, _S481);
    (&sample_0)->shown_3 = _S485;
    uint _S486;
    if(_S485.is_warp_2)
    {
        uint _S487 = __ldg(&_S482->warp_0);
        _S486 = _S487;
    }
    else
    {
        uint _S488 = __ldg(&_S482->weft_0);
        _S486 = _S488;
    }
    uint _S489;
    if(_S485.is_warp_2)
    {
        uint _S490 = __ldg(&_S482->weft_0);
        _S489 = _S490;
    }
    else
    {
        uint _S491 = __ldg(&_S482->warp_0);
        _S489 = _S491;
    }
    Cell_0 _S492 = (&(&sample_0)->crossing_2)->warp_2;
    Cell_0 _S493 = (&(&sample_0)->crossing_2)->weft_2;
    Cell_0 _S494 = select_cell_0(_S485.is_warp_2, &_S492, &_S493);
    Cell_0 _S495 = (&(&sample_0)->crossing_2)->weft_2;
    Cell_0 _S496 = (&(&sample_0)->crossing_2)->warp_2;
    Cell_0 _S497 = select_cell_0(_S485.is_warp_2, &_S495, &_S496);
    Cell_0 _S498 = _S497;
    Run_0 _S499 = unpack_0(_S486, _S489, _S494.thread_0, &_S498, _S485.word_0);
    Cell_0 _S500 = _S494;
    Section_0 _S501 = section_at_0(&_S500);
    bool _S502;
    if(_S485.on_top_0)
    {
        _S502 = (_S499.distance_0) < (_S501.drop_0 * _S499.bend_1.sine_0);
    }
    else
    {
        _S502 = false;
    }
    bool _S503;
    if(_S485.on_top_0)
    {
        _S503 = !_S502;
    }
    else
    {
        _S503 = false;
    }
    float _S504;
    if(_S503)
    {
        _S504 = 1.0f;
    }
    else
    {
        _S504 = -1.0f;
    }
    float _S505;
    if(_S502)
    {
        _S505 = _S499.other_reach_0;
    }
    else
    {
        _S505 = _S499.reach_0;
    }
    float _S506;
    if(_S502)
    {
        _S506 = _S505 + _S499.distance_0;
    }
    else
    {
        _S506 = (F32_max((_S505 - _S499.distance_0), (0.0f)));
    }
    float _S507 = _S505 / _S499.bend_1.sine_0 - _S504 * _S501.drop_0;
    float _S508 = _S506 * _S506;
    float _S509 = (F32_max((_S507 * _S507 - _S508), (9.99999968265522539e-21f)));
    float _S510 = (F32_rsqrt((_S509)));
    float _S511 = _S508 / (_S509 * _S510 + _S507);
    bool _S512 = _S506 > 0.0f;
    float _S513;
    if(_S485.on_top_0)
    {
        _S513 = 1.0f;
    }
    else
    {
        _S513 = -1.0f;
    }
    float _S514;
    if(_S499.near_start_0)
    {
        _S514 = 1.0f;
    }
    else
    {
        _S514 = -1.0f;
    }
    float _S515 = _S513 * _S514;
    if(_S512)
    {
        _S513 = _S507 * _S510;
    }
    else
    {
        _S513 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S501.slope_0 * _S513;
    if(_S512)
    {
        _S506 = _S515 * _S506 * _S510;
    }
    else
    {
        _S506 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S506;
    Family_0 _S516 = slang_ldg_2((&(globalParams_0->families_0)[_S486]));
    Shown_0 _S517 = _S485;
    Run_0 _S518 = _S499;
    Cell_0 _S519 = _S497;
    float2  _S520 = dive_0(_S489, &_S517, &_S518, &_S519);
    if(_S499.straight_0)
    {
        _S504 = 0.0f;
    }
    else
    {
        _S504 = _S516.height_scale_0 * _S504;
    }
    (&sample_0)->height_7 = _S504 * (_S505 * _S499.bend_1.half_tangent_0 - _S511) - _S516.height_scale_0 * _S501.drop_0 - _S520.x;
    float _S521 = _S516.height_scale_0 * (&sample_0)->slope_across_0;
    float _S522 = _S516.height_scale_0 * (&sample_0)->slope_along_0 - _S520.y;
    if(_S485.is_warp_2)
    {
        _S504 = _S521;
    }
    else
    {
        _S504 = _S522;
    }
    (&sample_0)->slope_x_1 = _S504;
    if(_S485.is_warp_2)
    {
        _S504 = _S522;
    }
    else
    {
        _S504 = _S521;
    }
    (&sample_0)->slope_y_1 = _S504;
    (&sample_0)->run_3 = _S499;
    (&sample_0)->section_1 = _S501;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S523, SearchQuality_0 * _S524, float3  _S525)
{
    Fabric_0 * _S526 = (&(globalParams_0->fabrics_0)[_S523]);
    float _S527 = (F32_abs((_S525.x)));
    float _S528 = __ldg(&_S526->threads_per_x_0);
    float _S529 = _S527 * _S528;
    float _S530 = (F32_abs((_S525.y)));
    float _S531 = __ldg(&_S526->threads_per_y_0);
    float _S532 = (F32_max((_S529), (_S530 * _S531))) * _S524->steps_per_thread_0;
    float _S533 = (F32_abs((_S525.z)));
    float _S534 = __ldg(&_S526->per_relief_0);
    return (F32_max((_S532), (_S533 * _S534 * _S524->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S535, Crossing_0 * _S536)
{
    Fabric_0 * _S537 = (&(globalParams_0->fabrics_0)[_S535]);
    bool _S538 = _S536->warp_above_0;
    uint _S539;
    if(_S536->warp_above_0)
    {
        uint _S540 = __ldg(&_S537->warp_0);
        _S539 = _S540;
    }
    else
    {
        uint _S541 = __ldg(&_S537->weft_0);
        _S539 = _S541;
    }
    uint _S542;
    if(_S538)
    {
        _S542 = _S536->warp_word_0;
    }
    else
    {
        _S542 = _S536->weft_word_0;
    }
    float _S543 = float(_S542 >> int(28));
    Family_0 _S544 = slang_ldg_2((&(globalParams_0->families_0)[_S539]));
    float _S545 = _S543 * _S544.height_scale_0;
    Family_0 _S546 = slang_ldg_2((&(globalParams_0->families_0)[_S539]));
    return _S545 * _S546.level_0;
}

__device__ Probe_0 probe_0(uint _S547, float _S548, float _S549, bool _S550, bool _S551, bool _S552)
{
    Sample_0 _S553 = sample_at_0(_S547, _S548, _S549, _S550);
    Probe_0 probe_1;
    (&probe_1)->height_4 = _S553.height_7;
    (&probe_1)->hole_4 = _S553.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S553.slope_x_1;
    (&probe_1)->slope_y_0 = _S553.slope_y_1;
    uint _S554;
    if(_S553.shown_3.is_warp_2)
    {
        _S554 = _S553.crossing_2.warp_2.thread_0 * 2U + 1U;
    }
    else
    {
        _S554 = _S553.crossing_2.weft_2.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S554;
    Crossing_0 _S555 = _S553.crossing_2;
    float _S556 = cell_maximum_0(_S547, &_S555);
    (&probe_1)->cell_max_0 = _S556;
    float _S557;
    if(_S551)
    {
        _S557 = _S553.crossing_2.warp_2.above_0;
    }
    else
    {
        _S557 = _S553.crossing_2.warp_2.below_0;
    }
    (&probe_1)->side_x_0 = _S557;
    if(_S552)
    {
        _S557 = _S553.crossing_2.weft_2.above_0;
    }
    else
    {
        _S557 = _S553.crossing_2.weft_2.below_0;
    }
    (&probe_1)->side_y_0 = _S557;
    bool _S558 = !_S553.shown_3.is_warp_2;
    Cell_0 _S559 = _S553.crossing_2.warp_2;
    Shown_0 _S560 = _S553.shown_3;
    Run_0 _S561 = _S553.run_3;
    float _S562 = outline_distance_0(&_S559, &_S560, &_S561, _S558, _S551);
    (&probe_1)->edge_x_0 = _S562;
    Cell_0 _S563 = _S553.crossing_2.weft_2;
    Shown_0 _S564 = _S553.shown_3;
    Run_0 _S565 = _S553.run_3;
    float _S566 = outline_distance_0(&_S563, &_S564, &_S565, _S553.shown_3.is_warp_2, _S552);
    (&probe_1)->edge_y_0 = _S566;
    return probe_1;
}

__device__ bool is_free_0(uint _S567, SearchQuality_0 * _S568, float3  _S569, float3  _S570, bool _S571, float _S572)
{
    float _S573 = _S570.z;
    if(_S573 <= 0.0f)
    {
        return false;
    }
    float _S574 = _S568->shadow_share_0;
    float _S575 = steps_per_length_0(_S567, _S568, _S570);
    float _S576 = 1.0f / (F32_max((_S574 * _S575), (9.99999971718068537e-10f)));
    StepControl_0 _S577 = step_control_0(float2 {_S570.x, _S570.y}, _S576);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S578;
        if(count_3 < 1024U)
        {
            _S578 = (_S569.z + _S573 * distance_1) < _S572;
        }
        else
        {
            _S578 = false;
        }
        if(_S578)
        {
        }
        else
        {
            break;
        }
        float3  _S579 = _S569 + _S570 * make_float3 (distance_1);
        Probe_0 _S580 = probe_0(_S567, _S579.x, _S579.y, _S571, _S577.right_0, _S577.up_0);
        float _S581 = _S579.z;
        float _S582 = _S581 - _S580.height_4;
        float _S583 = _S573 - _S580.slope_x_0 * _S570.x - _S580.slope_y_0 * _S570.y;
        bool _S584;
        if(!_S580.hole_4)
        {
            _S584 = _S582 < 0.0f;
        }
        else
        {
            _S584 = false;
        }
        if(_S584)
        {
            return false;
        }
        PreviousSample_0 _S585 = previous_3;
        Probe_0 _S586 = _S580;
        float _S587 = way_back_to_dip_0(&_S585, _S582, _S583, last_step_0, &_S586);
        if(_S587 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S587;
            distance_1 = distance_1 - _S587;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S588 = _S581 > (_S580.cell_max_0);
        Probe_0 _S589 = _S580;
        PreviousSample_0 _S590 = after_sample_0(_S582, _S583, &_S589, _S588);
        float last_step_2;
        if(_S588)
        {
            StepControl_0 _S591 = _S577;
            float _S592 = StepControl_to_cell_exit_0(&_S591, _S580.side_x_0, _S580.side_y_0);
            last_step_2 = (F32_max((_S592), (_S576)));
        }
        else
        {
            StepControl_0 _S593 = _S577;
            Probe_0 _S594 = _S580;
            float _S595 = StepControl_to_next_sample_0(&_S593, &_S594, _S582, _S583);
            last_step_2 = _S595;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S590;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S596, SearchQuality_0 * _S597, float _S598, float _S599, float3  _S600, bool _S601)
{
    Fabric_0 * _S602 = (&(globalParams_0->fabrics_0)[_S596]);
    Sample_0 _S603 = sample_at_0(_S596, _S598, _S599, _S601);
    if(!_S603.shown_3.hole_3)
    {
        return false;
    }
    float3  _S604 = make_float3 (_S598, _S599, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S605;
        if(side_0 < 2U)
        {
            _S605 = passes_0;
        }
        else
        {
            _S605 = false;
        }
        if(_S605)
        {
        }
        else
        {
            break;
        }
        float3  _S606;
        if(side_0 == 0U)
        {
            _S606 = _S600;
        }
        else
        {
            _S606 = make_float3 (- _S600.x, - _S600.y, _S600.z);
        }
        bool _S607 = _S601 != (side_0 == 1U);
        float _S608 = __ldg(&_S602->height_high_0);
        bool _S609 = is_free_0(_S596, _S597, _S604, _S606, _S607, _S608);
        uint _S610 = side_0 + 1U;
        passes_0 = _S609;
        side_0 = _S610;
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

__device__ float max_height_along_0(uint _S611, float _S612, float _S613, float _S614, float3  _S615, bool _S616)
{
    Fabric_0 * _S617 = (&(globalParams_0->fabrics_0)[_S611]);
    uint _S618 = __ldg(&_S617->warp_0);
    uint _S619 = locate_0(_S618, _S612).thread_0 / 2U;
    uint _S620 = __ldg(&_S617->weft_0);
    uint _S621 = locate_0(_S620, _S613).thread_0 / 2U;
    float _S622 = _S615.x;
    uint _S623;
    if(_S622 > 0.0f)
    {
        _S623 = 1U;
    }
    else
    {
        _S623 = 0U;
    }
    float _S624 = _S615.y;
    uint _S625;
    if(_S624 > 0.0f)
    {
        _S625 = 2U;
    }
    else
    {
        _S625 = 0U;
    }
    uint _S626 = _S623 + _S625;
    uint _S627 = __ldg(&_S617->max_heights_0);
    uint _S628 = __ldg(&_S617->max_height_columns_0);
    uint _S629 = __ldg((&(globalParams_0->words_0)[_S627 + 4U * (_S621 * _S628 + _S619) + _S626]));
    int number_0;
    if(_S616)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S630 = _S629 >> number_0;
    float _S631 = (F32_abs((_S622)));
    float _S632 = __ldg(&_S617->threads_per_x_0);
    float _S633 = _S631 * _S632;
    float _S634 = (F32_abs((_S624)));
    float _S635 = __ldg(&_S617->threads_per_y_0);
    float _S636 = (F32_max((_S633), (_S634 * _S635))) / _S615.z;
    float _S637 = __ldg(&_S617->height_high_0);
    float max_height_0 = _S637;
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
        if(((max_height_0 - _S614) * _S636) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S630 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S637)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S638, float _S639, float _S640, bool _S641, bool _S642, bool _S643)
{
    Crossing_0 _S644 = crossing_at_0(_S638, _S639, _S640, _S641);
    Crossing_0 _S645 = _S644;
    float _S646 = cell_maximum_0(_S638, &_S645);
    float _S647;
    if(_S642)
    {
        _S647 = _S644.warp_2.above_0;
    }
    else
    {
        _S647 = _S644.warp_2.below_0;
    }
    float _S648;
    if(_S643)
    {
        _S648 = _S644.weft_2.above_0;
    }
    else
    {
        _S648 = _S644.weft_2.below_0;
    }
    return make_float3 (_S646, _S647, _S648);
}

__device__ float first_sample_height_0(uint _S649, ViewRay_0 * _S650, StepControl_0 * _S651, bool _S652)
{
    float _S653 = max_height_along_0(_S649, _S650->origin_0.x, _S650->origin_0.y, 0.0f, make_float3 (_S650->slope_1.x, _S650->slope_1.y, 1.0f), _S652);
    uint count_4 = 0U;
    float height_9 = _S653;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S654 = ViewRay_at_0(_S650, height_9);
        float3  _S655 = cell_bounds_0(_S649, _S654.x, _S654.y, _S652, _S651->right_0, _S651->up_0);
        float _S656 = height_9 - _S655.x;
        float _S657 = StepControl_to_cell_exit_0(_S651, _S655.y, _S655.z);
        float height_10 = height_9 - clamp_1(_S656, 0.0f, _S657);
        if(_S656 <= _S657)
        {
            height_9 = height_10;
            break;
        }
        count_4 = count_4 + 1U;
        height_9 = height_10;
    }
    return height_9;
}

__device__ ViewRayEnd_0 search_down_0(uint _S658, ViewRay_0 * _S659, StepControl_0 * _S660, bool _S661)
{
    Fabric_0 * _S662 = (&(globalParams_0->fabrics_0)[_S658]);
    float _S663 = __ldg(&_S662->height_low_0);
    float _S664 = __ldg(&_S662->height_high_0);
    float _S665 = _S663 - (_S664 - _S663);
    ViewRayEnd_0 end_1;
    float _S666 = first_sample_height_0(_S658, _S659, _S660, _S661);
    (&end_1)->height_8 = _S666;
    (&end_1)->last_step_3 = _S660->epsilon_0;
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
        float2  _S667 = ViewRay_at_0(_S659, (&end_1)->height_8);
        Probe_0 _S668 = probe_0(_S658, _S667.x, _S667.y, _S661, _S660->right_0, _S660->up_0);
        float _S669 = (&end_1)->height_8 - _S668.height_4;
        Probe_0 _S670 = _S668;
        float _S671 = ViewRay_rate_0(_S659, &_S670);
        (&end_1)->depth_1 = - _S669;
        (&end_1)->rate_4 = _S671;
        bool _S672;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S672 = !_S668.hole_4;
        }
        else
        {
            _S672 = false;
        }
        bool _S673;
        if(_S672)
        {
            _S673 = ((&(&end_1)->previous_4)->yarn_0) == (_S668.yarn_1);
        }
        else
        {
            _S673 = false;
        }
        (&end_1)->smooth_0 = _S673;
        bool _S674;
        if(!_S668.hole_4)
        {
            _S674 = _S669 <= 0.0f;
        }
        else
        {
            _S674 = false;
        }
        bool _S675;
        if(_S674)
        {
            _S675 = true;
        }
        else
        {
            _S675 = ((&end_1)->height_8) <= _S665;
        }
        if(_S675)
        {
            break;
        }
        PreviousSample_0 _S676 = (&end_1)->previous_4;
        Probe_0 _S677 = _S668;
        float _S678 = way_back_to_dip_0(&_S676, _S669, _S671, (&end_1)->last_step_3, &_S677);
        if(_S678 >= 0.0f)
        {
            (&end_1)->height_8 = (&end_1)->height_8 + _S678;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S678;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S679 = StepControl_to_cell_exit_0(_S660, _S668.side_x_0, _S668.side_y_0);
        float _S680 = (F32_min((_S679), ((&end_1)->height_8 - _S668.cell_max_0)));
        Probe_0 _S681 = _S668;
        float _S682 = StepControl_to_next_sample_0(_S660, &_S681, _S669, _S671);
        bool _S683 = _S680 > _S682;
        Probe_0 _S684 = _S668;
        PreviousSample_0 _S685 = after_sample_0(_S669, _S671, &_S684, _S683);
        (&end_1)->previous_4 = _S685;
        float _S686 = (F32_max((_S680), (_S682)));
        (&end_1)->last_step_3 = _S686;
        (&end_1)->height_8 = (&end_1)->height_8 - _S686;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S687, ViewRay_0 * _S688, StepControl_0 * _S689, bool _S690, ViewRayEnd_0 * _S691, uint _S692)
{
    Fabric_0 * _S693 = (&(globalParams_0->fabrics_0)[_S687]);
    float _S694 = __ldg(&_S693->height_high_0);
    float _S695 = __ldg(&_S693->height_low_0);
    float _S696 = _S694 - _S695;
    float _S697 = _S691->height_8;
    float _S698 = _S691->last_step_3;
    float above_2 = _S691->height_8 + _S691->last_step_3;
    float above_gap_1 = clamp_1((&_S691->previous_4)->clearance_0, 0.0f, _S696);
    float under_gap_1 = clamp_1(_S691->depth_1, 0.0f, _S696);
    float _S699 = cubic_root_0(above_gap_1, - under_gap_1, (&_S691->previous_4)->rate_0 * _S691->last_step_3, _S691->rate_4 * _S691->last_step_3);
    bool _S700 = _S691->smooth_0;
    float middle_0;
    if(_S691->smooth_0)
    {
        middle_0 = above_2 - _S699 * _S698;
    }
    else
    {
        middle_0 = between_0(above_2, _S697, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S697;
    float above_3 = above_2;
    uint i_9 = 0U;
    for(;;)
    {
        if(i_9 < _S692)
        {
        }
        else
        {
            break;
        }
        float2  _S701 = ViewRay_at_0(_S688, middle_0);
        Probe_0 _S702 = probe_0(_S687, _S701.x, _S701.y, _S690, _S689->right_0, _S689->up_0);
        float _S703;
        if(_S702.hole_4)
        {
            _S703 = -1.0e+09f;
        }
        else
        {
            _S703 = _S702.height_4;
        }
        float _S704 = clamp_1(middle_0 - _S703, - _S696, _S696);
        float _S705;
        if(_S704 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S705 = 0.5f * above_gap_2;
            }
            else
            {
                _S705 = above_gap_2;
            }
            float _S706 = - _S704;
            under_1 = middle_0;
            above_gap_2 = _S705;
            under_gap_2 = _S706;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S705 = 0.5f * under_gap_2;
            }
            else
            {
                _S705 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S704;
            under_gap_2 = _S705;
            side_1 = -1.0f;
        }
        if(_S700)
        {
            Probe_0 _S707 = _S702;
            float _S708 = ViewRay_rate_0(_S688, &_S707);
            middle_0 = clamp_1(middle_0 + _S704 / (F32_min((_S708), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_9 = i_9 + 1U;
    }
    if(_S700)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S709, SearchQuality_0 * _S710, float _S711, float _S712, float3  _S713, bool _S714)
{
    float _S715 = (F32_max((_S713.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S711, _S712);
    float2  _S716 = float2 {_S713.x, _S713.y} / make_float2 (_S715);
    (&ray_0)->slope_1 = _S716;
    float2  _S717 = - _S716;
    float _S718 = steps_per_length_0(_S709, _S710, _S713);
    StepControl_0 _S719 = step_control_0(_S717, 1.0f / (F32_max((_S718 / _S715), (9.99999971718068537e-10f))));
    ViewRay_0 _S720 = ray_0;
    StepControl_0 _S721 = _S719;
    ViewRayEnd_0 _S722 = search_down_0(_S709, &_S720, &_S721, _S714);
    Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    ViewRay_0 _S723 = ray_0;
    StepControl_0 _S724 = _S719;
    ViewRayEnd_0 _S725 = _S722;
    float _S726 = refined_height_0(_S709, &_S723, &_S724, _S714, &_S725, _S710->refinements_0);
    (&hit_0)->height_6 = _S726;
    ViewRay_0 _S727 = ray_0;
    float2  _S728 = ViewRay_at_0(&_S727, _S726);
    (&hit_0)->x_30 = _S728.x;
    (&hit_0)->y_17 = _S728.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S729, SearchQuality_0 * _S730, float _S731, float _S732, float3  _S733, bool _S734)
{
    bool _S735 = passes_through_0(_S729, _S730, _S731, _S732, _S733, _S734);
    if(!_S735)
    {
        Hit_0 _S736 = first_hit_of_yarn_0(_S729, _S730, _S731, _S732, _S733, _S734);
        return _S736;
    }
    Hit_0 hit_1;
    (&hit_1)->x_30 = _S731;
    (&hit_1)->y_17 = _S732;
    (&hit_1)->height_6 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S737, float _S738, float _S739, bool _S740)
{
    Fabric_0 * _S741 = (&(globalParams_0->fabrics_0)[_S737]);
    Sample_0 _S742 = sample_at_0(_S737, _S738, _S739, _S740);
    float _S743;
    if(_S742.shown_3.is_warp_2)
    {
        _S743 = _S742.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S743 = _S742.crossing_2.weft_2.half_width_1;
    }
    uint _S744;
    if(_S742.shown_3.is_warp_2)
    {
        uint _S745 = __ldg(&_S741->warp_0);
        _S744 = _S745;
    }
    else
    {
        uint _S746 = __ldg(&_S741->weft_0);
        _S744 = _S746;
    }
    Family_0 _S747 = slang_ldg_2((&(globalParams_0->families_0)[_S744]));
    float _S748;
    if(_S740)
    {
        _S748 = -1.0f;
    }
    else
    {
        _S748 = 1.0f;
    }
    float _S749 = _S747.twist_sine_0 * _S748;
    Family_0 _S750 = slang_ldg_2((&(globalParams_0->families_0)[_S744]));
    if(_S742.shown_3.is_warp_2)
    {
        _S748 = 1.0f;
    }
    else
    {
        _S748 = -1.0f;
    }
    float2  _S751 = fibre_direction_0(_S742.slope_across_0, _S748 * _S742.slope_along_0, _S749, _S750.twist_cosine_0);
    float _S752;
    if(_S742.shown_3.is_warp_2)
    {
        _S752 = _S742.slope_x_1;
    }
    else
    {
        _S752 = _S742.slope_y_1;
    }
    float _S753;
    if(_S742.shown_3.is_warp_2)
    {
        _S753 = _S742.slope_y_1;
    }
    else
    {
        _S753 = _S742.slope_x_1;
    }
    float _S754 = _S751.x;
    float _S755 = _S751.y;
    float _S756 = _S752 * _S754 + _S748 * _S753 * _S755;
    float _S757 = _S743 * 1.0154266357421875f;
    float _S758 = _S757 * arc_sine_0(clamp_1(_S742.section_1.across_3 / _S757, -1.0f, 1.0f));
    if(_S742.shown_3.is_warp_2)
    {
        _S743 = _S739;
    }
    else
    {
        _S743 = - _S738;
    }
    SurfacePoint_0 point_0;
    (&point_0)->hole_0 = _S742.shown_3.hole_3;
    (&point_0)->is_warp_0 = _S742.shown_3.is_warp_2;
    (&point_0)->warp_thread_0 = _S742.crossing_2.warp_2.thread_0;
    (&point_0)->weft_thread_0 = _S742.crossing_2.weft_2.thread_0;
    (&point_0)->height_2 = _S742.height_7;
    (&point_0)->normal_0 = normalize_0(make_float3 (- _S742.slope_x_1, - _S742.slope_y_1, 1.0f));
    float3  _S759;
    if(_S742.shown_3.is_warp_2)
    {
        _S759 = make_float3 (_S754, _S755, _S756);
    }
    else
    {
        _S759 = make_float3 (- _S755, _S754, _S756);
    }
    (&point_0)->tangent_0 = normalize_0(_S759);
    (&point_0)->across_0 = _S742.section_1.across_3;
    (&point_0)->fibre_across_0 = _S758 * _S750.twist_cosine_0 + _S743 * _S749;
    (&point_0)->fibre_along_0 = _S743 * _S750.twist_cosine_0 - _S758 * _S749;
    return point_0;
}

struct YarnPoint_0
{
    bool back_6;
    bool hole_6;
    bool is_warp_3;
    float x_31;
    float y_18;
    float height_11;
    float3  normal_6;
    float3  tangent_7;
    float roughness_10;
    Albedos_0 albedos_6;
};

__device__ Albedos_0 vary_albedos_0(uint _S760, Albedos_0 * _S761, uint _S762, uint _S763)
{
    Fabric_0 * _S764 = (&(globalParams_0->fabrics_0)[_S760]);
    float3  _S765 = _S761->specular_reflect_0;
    float3  _S766 = _S761->specular_transmit_0;
    float3  _S767 = max_0(_S761->specular_reflect_0, _S761->specular_transmit_0);
    float3  _S768 = _S761->diffuse_reflect_0;
    float3  _S769 = _S761->diffuse_transmit_0;
    float3  _S770 = _S761->diffuse_reflect_0 + _S761->diffuse_transmit_0;
    float _S771 = __ldg(&_S764->colour_noise_0);
    uint _S772 = __ldg(&_S764->seed_0);
    float _S773 = thread_gain_0(_S762, _S771, _S772);
    float _S774 = __ldg(&_S764->layer_bound_0);
    float _S775 = bounded_gain_0(_S773, _S770, make_float3 (1.0f) - make_float3 (_S774) * _S767);
    float3  _S776 = min_0((make_float3 (1.0f) - make_float3 (_S775) * _S770) / make_float3 (_S774), make_float3 (1.0f));
    float _S777 = __ldg(&_S764->fibre_noise_0);
    float _S778 = bounded_gain_0(fibre_gain_0(_S762, _S763, _S777, _S772), _S767, _S776);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S775) * _S768;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S775) * _S769;
    (&varied_0)->specular_reflect_0 = make_float3 (_S778) * _S765;
    (&varied_0)->specular_transmit_0 = make_float3 (_S778) * _S766;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S779, SurfacePoint_0 * _S780, Albedos_0 * _S781, float _S782, float _S783)
{
    Fabric_0 * _S784 = (&(globalParams_0->fabrics_0)[_S779]);
    bool _S785 = _S780->is_warp_0;
    float _S786;
    if(_S780->is_warp_0)
    {
        _S786 = _S782;
    }
    else
    {
        _S786 = _S783;
    }
    float _S787 = _S786 - _S780->across_0;
    uint _S788;
    if(_S785)
    {
        uint _S789 = __ldg(&_S784->warp_0);
        _S788 = _S789;
    }
    else
    {
        uint _S790 = __ldg(&_S784->weft_0);
        _S788 = _S790;
    }
    Family_0 _S791 = slang_ldg_2((&(globalParams_0->families_0)[_S788]));
    Family_0 _S792 = slang_ldg_2((&(globalParams_0->families_0)[_S788]));
    int _S793 = int(_S792.count_0);
    if(_S785)
    {
        _S788 = _S780->warp_thread_0;
    }
    else
    {
        _S788 = _S780->weft_thread_0;
    }
    uint _S794 = uint(int((F32_floor((_S787 / _S791.period_0)))) * _S793 + int(_S788)) * 2U;
    if(_S785)
    {
        _S788 = 1U;
    }
    else
    {
        _S788 = 0U;
    }
    uint _S795 = _S794 + _S788;
    float _S796 = _S780->fibre_across_0;
    float _S797 = __ldg(&_S784->fibre_size_0);
    float _S798 = (F32_floor((_S796 / _S797)));
    Albedos_0 _S799 = vary_albedos_0(_S779, _S781, _S795, uint(int(_S798)) * 65536U + uint(int((F32_floor((_S780->fibre_along_0 / (_S797 * 40.0f) + 0.61799997091293335f * _S798))))));
    return _S799;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S800, SurfacePoint_0 * _S801, float _S802, float _S803, bool _S804, bool _S805)
{
    Fabric_0 * _S806 = (&(globalParams_0->fabrics_0)[_S800]);
    bool _S807 = _S801->is_warp_0;
    uint _S808;
    if(_S801->is_warp_0)
    {
        uint _S809 = __ldg(&_S806->warp_0);
        _S808 = _S809;
    }
    else
    {
        uint _S810 = __ldg(&_S806->weft_0);
        _S808 = _S810;
    }
    uint _S811;
    if(_S807)
    {
        _S811 = _S801->warp_thread_0;
    }
    else
    {
        _S811 = _S801->weft_thread_0;
    }
    Albedos_0 albedos_7 = albedos_of_0(_S808, _S811);
    float _S812 = __ldg(&_S806->fibre_noise_0);
    bool _S813;
    if(_S812 > 0.0f)
    {
        _S813 = true;
    }
    else
    {
        float _S814 = __ldg(&_S806->colour_noise_0);
        _S813 = _S814 > 0.0f;
    }
    Albedos_0 albedos_8;
    if(_S813)
    {
        Albedos_0 _S815 = albedos_7;
        Albedos_0 _S816 = varied_at_0(_S800, _S801, &_S815, _S802, _S803);
        albedos_8 = _S816;
    }
    else
    {
        albedos_8 = albedos_7;
    }
    YarnPoint_0 point_1;
    (&point_1)->back_6 = _S804;
    (&point_1)->hole_6 = _S805;
    (&point_1)->is_warp_3 = _S807;
    (&point_1)->x_31 = _S802;
    (&point_1)->y_18 = _S803;
    (&point_1)->height_11 = _S801->height_2;
    (&point_1)->normal_6 = _S801->normal_0;
    (&point_1)->tangent_7 = _S801->tangent_0;
    Family_0 _S817 = slang_ldg_2((&(globalParams_0->families_0)[_S808]));
    (&point_1)->roughness_10 = _S817.roughness_0;
    (&point_1)->albedos_6 = albedos_8;
    return point_1;
}

__device__ bool unoccluded_0(uint _S818, SearchQuality_0 * _S819, float _S820, float _S821, float _S822, float3  _S823, bool _S824)
{
    Fabric_0 * _S825 = (&(globalParams_0->fabrics_0)[_S818]);
    if((_S823.z) <= 0.0f)
    {
        return false;
    }
    float _S826 = max_height_along_0(_S818, _S820, _S821, _S822, _S823, _S824);
    float _S827 = __ldg(&_S825->lift_0);
    bool _S828 = is_free_0(_S818, _S819, make_float3 (_S820, _S821, _S822 + _S827), _S823, _S824, _S826);
    return _S828;
}

__device__ bool is_lit_0(uint _S829, SearchQuality_0 * _S830, YarnPoint_0 * _S831, float3  _S832)
{
    if(_S831->hole_6)
    {
        return true;
    }
    bool _S833 = _S831->back_6;
    float3  _S834 = to_face_frame_0(_S832, _S831->back_6);
    float _S835 = _S834.z;
    bool _S836 = _S835 < 0.0f;
    float3  _S837 = _S831->normal_6;
    float _S838 = _S831->height_11;
    float3  normal_7;
    float height_12;
    if(_S836)
    {
        SurfacePoint_0 _S839 = surface_at_0(_S829, _S831->x_31, _S831->y_18, !_S833);
        normal_7 = _S839.normal_0;
        height_12 = _S839.height_2;
    }
    else
    {
        normal_7 = _S837;
        height_12 = _S838;
    }
    float3  _S840 = make_float3 (float2 {_S834.x, _S834.y}.x, float2 {_S834.x, _S834.y}.y, (F32_abs((_S835))));
    if((dot_0(normal_7, _S840)) <= 0.0f)
    {
        return false;
    }
    bool _S841 = unoccluded_0(_S829, _S830, _S831->x_31, _S831->y_18, height_12, _S840, _S833 != _S836);
    return _S841;
}

__device__ Components_0 components_of_point_0(uint _S842, SearchQuality_0 * _S843, YarnPoint_0 * _S844, float3  _S845, float3  _S846)
{
    Fabric_0 * _S847 = (&(globalParams_0->fabrics_0)[_S842]);
    Components_0 result_14 = no_components_0();
    bool _S848 = _S844->hole_6;
    float _S849;
    if(_S844->hole_6)
    {
        _S849 = 1.0f;
    }
    else
    {
        _S849 = 0.0f;
    }
    (&result_14)->hole_2 = _S849;
    bool _S850;
    if(_S848)
    {
        _S850 = true;
    }
    else
    {
        bool _S851 = is_lit_0(_S842, _S843, _S844, _S845);
        _S850 = !_S851;
    }
    if(_S850)
    {
        return result_14;
    }
    float3  _S852 = to_face_frame_0(_S845, _S844->back_6);
    float3  _S853 = to_face_frame_0(_S846, _S844->back_6);
    bool _S854 = (_S852.z) < 0.0f;
    float3  _S855;
    if(_S854)
    {
        _S855 = - _S852;
    }
    else
    {
        _S855 = _S852;
    }
    float3  _S856 = _S844->normal_6;
    float _S857 = __ldg(&_S847->diffuse_blend_0);
    float _S858 = diffuse_reflection_0(_S855, _S856, _S857);
    if(_S854)
    {
        float3  _S859 = _S844->tangent_7;
        float _S860 = _S844->roughness_10;
        float _S861 = __ldg(&_S847->optical_depth_0);
        _S849 = transmission_1(_S852, _S853, _S856, _S859, _S860, _S861);
    }
    else
    {
        float3  _S862 = _S844->tangent_7;
        float _S863 = _S844->roughness_10;
        float _S864 = __ldg(&_S847->optical_depth_0);
        _S849 = reflection_0(_S852, _S853, _S856, _S862, _S863, _S864);
    }
    bool _S865 = _S844->is_warp_3;
    float _S866;
    if(_S844->is_warp_3)
    {
        _S866 = _S858;
    }
    else
    {
        _S866 = 0.0f;
    }
    (&result_14)->diffuse_warp_0 = _S866;
    if(_S865)
    {
        _S866 = 0.0f;
    }
    else
    {
        _S866 = _S858;
    }
    (&result_14)->diffuse_weft_0 = _S866;
    if(_S865)
    {
        _S866 = _S849;
    }
    else
    {
        _S866 = 0.0f;
    }
    (&result_14)->specular_warp_0 = _S866;
    if(_S865)
    {
        _S849 = 0.0f;
    }
    (&result_14)->specular_weft_0 = _S849;
    (&result_14)->light_visibility_1 = 1.0f;
    return result_14;
}

__device__ float openness_number_0(uint _S867, uint _S868)
{
    uint _S869 = __ldg(&(&(globalParams_0->fabrics_0)[_S867])->openness_0);
    return table_number_0(_S869 + _S868);
}

__device__ Blocked_0 blocked_of_terms_0(uint _S870, uint _S871, FixedArray<float, 6>  * _S872, uint _S873)
{
    FixedArray<float, 3>  shares_0;
    uint share_3 = 0U;
    for(;;)
    {
        if(share_3 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_3] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S873)
            {
            }
            else
            {
                break;
            }
            float _S874 = openness_number_0(_S870, _S871 + share_3 * _S873 + term_0);
            shares_0[share_3] = shares_0[share_3] + _S874 * (*_S872)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_3] = saturate_1(shares_0[share_3]);
        share_3 = share_3 + 1U;
    }
    Blocked_0 blocked_2;
    (&blocked_2)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_2)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_2)->far_0 = shares_0[int(1)];
    return blocked_2;
}

__device__ Blocked_0 blocked_at_0(uint _S875, bool _S876, bool _S877, float _S878, float _S879)
{
    float _S880 = openness_number_0(_S875, 158U);
    float _S881 = _S879 * _S880;
    float _S882 = _S878 * _S878;
    float _S883 = _S878 * _S881;
    float _S884 = _S881 * _S881;
    uint _S885;
    if(_S877)
    {
        _S885 = 2U;
    }
    else
    {
        _S885 = 0U;
    }
    uint _S886;
    if(_S876)
    {
        _S886 = 0U;
    }
    else
    {
        _S886 = 1U;
    }
    uint _S887 = 60U + (_S885 + _S886) * 18U;
    FixedArray<float, 6>  _S888;
    _S888[int(0)] = 1.0f;
    _S888[int(1)] = _S878;
    _S888[int(2)] = _S881;
    _S888[int(3)] = _S882;
    _S888[int(4)] = _S883;
    _S888[int(5)] = _S884;
    Blocked_0 _S889 = blocked_of_terms_0(_S875, _S887, &_S888, 6U);
    return _S889;
}

__device__ Blocked_0 with_blocked_0(uint _S890, Blocked_0 * _S891, YarnPoint_0 * _S892, bool _S893, float _S894)
{
    bool _S895;
    if(_S892->hole_6)
    {
        _S895 = true;
    }
    else
    {
        _S895 = (_S892->is_warp_3) != _S893;
    }
    if(_S895)
    {
        return *_S891;
    }
    Blocked_0 _S896 = blocked_at_0(_S890, _S893, _S892->back_6, _S892->normal_6.z, _S892->height_11);
    Blocked_0 result_15;
    (&result_15)->by_warp_0 = _S891->by_warp_0 + _S894 * _S896.by_warp_0;
    (&result_15)->by_weft_0 = _S891->by_weft_0 + _S894 * _S896.by_weft_0;
    (&result_15)->far_0 = _S891->far_0 + _S894 * _S896.far_0;
    return result_15;
}

struct CoverageTaps_0
{
    FixedArray<uint, 9>  nodes_1;
};

__device__ float3  pyramid_level_0(uint _S897, float _S898)
{
    Lobes_0 _S899 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S897])->lobes_0);
    uint _S900 = _S899.levels_0 + 4U * uint((F32_min((_S898), (_S899.last_level_0))));
    return make_float3 (table_number_0(_S900), table_number_0(_S900 + 1U), table_number_0(_S900 + 2U));
}

__device__ CoverageTaps_0 coverage_taps_0(uint _S901, Footprint_0 * _S902, bool _S903)
{
    Fabric_0 * _S904 = (&(globalParams_0->fabrics_0)[_S901]);
    float _S905 = Footprint_spread_side_0(_S902);
    Lobes_0 _S906 = slang_ldg_1(&_S904->lobes_0);
    float _S907 = _S905 * _S906.inverse_base_size_0;
    float3  _S908 = pyramid_level_0(_S901, (F32_floor((binary_logarithm_0((F32_max((0.68000000715255737f * _S907), (1.0f))))))));
    float _S909 = 1.0f / (F32_max((_S907), (9.99999997475242708e-07f)));
    float _S910 = (F32_min(((F32_max(((F32_sqrt((clamp_1(1.29999995231628418f * (1.0f - _S909 * _S909), 0.0f, 1.0f))))), (0.3333333432674408f * _S909)))), (1.0f)));
    uint _S911 = __ldg(&_S904->warp_0);
    Family_0 _S912 = slang_ldg_2((&(globalParams_0->families_0)[_S911]));
    uint _S913 = __ldg(&_S904->weft_0);
    Family_0 _S914 = slang_ldg_2((&(globalParams_0->families_0)[_S913]));
    float2  _S915 = make_float2 (_S912.inverse_period_0, _S914.inverse_period_0);
    float2  _S916 = _S902->centre_0 * _S915;
    float2  _S917 = _S902->dx_0 * _S915 * make_float2 (_S910);
    float2  _S918 = _S902->dy_0 * _S915 * make_float2 (_S910);
    CoverageTaps_0 taps_3;
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < 9U)
        {
        }
        else
        {
            break;
        }
        float2  _S919 = _S916 + make_float2 (TAP_OFFSETS_0[number_1].x) * _S917 + make_float2 (TAP_OFFSETS_0[number_1].y) * _S918;
        float _S920 = _S908.y;
        float _S921 = wrapped_cell_0(_S919.x, _S920);
        float _S922 = wrapped_cell_0(_S919.y, _S908.z);
        uint _S923;
        if(_S903)
        {
            _S923 = _S906.face_nodes_0;
        }
        else
        {
            _S923 = 0U;
        }
        (&taps_3)->nodes_1[number_1] = _S923 + uint(_S922 * _S920 + _S921 + _S908.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

__device__ float4  coverage_of_pack_0(uint _S924, CoverageTaps_0 * _S925, uint _S926)
{
    Fabric_0 * _S927 = (&(globalParams_0->fabrics_0)[_S924]);
    uint number_2 = 0U;
    uint even_1 = 0U;
    uint odd_1 = 0U;
    for(;;)
    {
        if(number_2 < 9U)
        {
        }
        else
        {
            break;
        }
        Lobes_0 _S928 = slang_ldg_1(&_S927->lobes_0);
        uint _S929 = __ldg((&(globalParams_0->words_0)[_S928.coverage_0 + _S925->nodes_1[number_2] * _S928.packs_0 + _S926]));
        uint even_2 = even_1 + (_S929 & 16711935U);
        uint odd_2 = odd_1 + ((_S929 >> int(8)) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / make_float4 (9.0f);
}

__device__ float coverage_of_holes_0(uint _S930, CoverageTaps_0 * _S931)
{
    Fabric_0 * _S932 = (&(globalParams_0->fabrics_0)[_S930]);
    uint number_3 = 0U;
    uint total_0 = 0U;
    for(;;)
    {
        if(number_3 < 9U)
        {
        }
        else
        {
            break;
        }
        uint _S933 = _S931->nodes_1[number_3];
        Lobes_0 _S934 = slang_ldg_1(&_S932->lobes_0);
        uint _S935 = __ldg((&(globalParams_0->words_0)[_S934.coverage_holes_0 + _S933 / 4U]));
        uint total_1 = total_0 + ((_S935 >> (8U * (_S933 % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

__device__ float prefiltered_hole_0(uint _S936, CoverageTaps_0 * _S937, NodeTaps_0 * _S938, bool _S939)
{
    Lobes_0 _S940 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S936])->lobes_0);
    float4  _S941 = interpolate_table_0(_S938, _S940.projected_area_0 + _S940.packs_0, _S940.packs_0 + 1U);
    float _S942 = _S941.x;
    float _S943;
    if(_S939)
    {
        _S943 = _S940.back_hole_weight_0;
    }
    else
    {
        _S943 = _S940.front_hole_weight_0;
    }
    float _S944 = coverage_of_holes_0(_S936, _S937);
    return (F32_min((_S944 * _S942 * _S942 * _S943), (1.0f)));
}

__device__ Components_0 prefiltered_components_0(uint _S945, Footprint_0 * _S946, float3  _S947, float3  _S948, bool _S949)
{
    Fabric_0 * _S950 = (&(globalParams_0->fabrics_0)[_S945]);
    CoverageTaps_0 _S951 = coverage_taps_0(_S945, _S946, _S949);
    NodeTaps_0 _S952 = node_taps_0(_S948);
    NodeTaps_0 view_nodes_0 = _S952;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S947);
    NodeTaps_0 seen_nodes_0 = _S952;
    uint _S953;
    if(_S949)
    {
        _S953 = 1U;
    }
    else
    {
        _S953 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + make_uint4 (_S953 * 256U);
    uint _S954 = 2U * _S953;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + make_uint4 (_S954 * 256U);
    uint _S955;
    if((_S947.z) < 0.0f)
    {
        _S955 = 1U;
    }
    else
    {
        _S955 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + make_uint4 ((_S954 + _S955) * 256U);
    float3  _S956 = half_vector_0(_S947, _S948);
    float3  _S957 = shadow_correlation_0(_S947, _S948);
    if(_S949)
    {
        Lobes_0 _S958 = slang_ldg_1(&_S950->lobes_0);
        _S955 = _S958.back_warp_packs_0;
    }
    else
    {
        Lobes_0 _S959 = slang_ldg_1(&_S950->lobes_0);
        _S955 = _S959.front_warp_packs_0;
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
        Lobes_0 _S960 = slang_ldg_1(&_S950->lobes_0);
        if(pack_0 < (_S960.packs_0))
        {
        }
        else
        {
            break;
        }
        CoverageTaps_0 _S961 = _S951;
        float4  _S962 = coverage_of_pack_0(_S945, &_S961, pack_0);
        uint _S963 = _S960.projected_area_0 + pack_0;
        uint _S964 = _S960.packs_0 + 1U;
        NodeTaps_0 _S965 = view_nodes_0;
        float4  _S966 = interpolate_table_0(&_S965, _S963, _S964);
        uint _S967 = _S960.light_visibility_0 + pack_0;
        NodeTaps_0 _S968 = seen_nodes_0;
        float4  _S969 = interpolate_table_0(&_S968, _S967, _S960.packs_0);
        float4  _S970 = _S969 / make_float4 (255.0f);
        NodeTaps_0 _S971 = light_nodes_0;
        float4  _S972 = interpolate_table_0(&_S971, _S967, _S960.packs_0);
        float4  _S973 = _S972 / make_float4 (255.0f);
        uint _S974 = _S960.irradiance_0 + pack_0;
        NodeTaps_0 _S975 = light_nodes_0;
        float4  _S976 = interpolate_table_0(&_S975, _S974, _S960.packs_0);
        float4  _S977 = _S976 * make_float4 (0.00124827399849892f);
        bool _S978 = pack_0 < _S955;
        uint _S979;
        if(_S978)
        {
            uint _S980 = __ldg(&_S950->warp_0);
            _S979 = _S980;
        }
        else
        {
            uint _S981 = __ldg(&_S950->weft_0);
            _S979 = _S981;
        }
        Family_0 _S982 = slang_ldg_2((&(globalParams_0->families_0)[_S979]));
        uint number_4 = 0U;
        float diffuse_0 = 0.0f;
        float specular_0 = 0.0f;
        for(;;)
        {
            if(number_4 < 4U)
            {
            }
            else
            {
                break;
            }
            Group_0 _S983 = group_at_0(_S960.moments_0 + 12U * (4U * (_S953 * _S960.packs_0 + pack_0) + number_4), _S982.roughness_0);
            float _S984 = _slang_vector_get_element(_S962, number_4) * _slang_vector_get_element(_S966, number_4) * _slang_vector_get_element(_S966, number_4) * _S983.weight_2;
            uint _S985 = number_4;
            float2  _S986 = visibility_gain_0(_S957, _slang_vector_get_element(_S973, number_4), _slang_vector_get_element(_S970, number_4));
            float _S987 = __ldg(&_S950->optical_depth_0);
            Group_0 _S988 = _S983;
            float _S989 = layer_value_0(&_S988, _S956, _S947, _S948, _S987);
            float _S990 = _S986.x;
            float diffuse_1 = diffuse_0 + _S984 * _slang_vector_get_element(_S977, number_4) * _S990;
            float specular_1 = specular_0 + _S984 * _S989 * _slang_vector_get_element(_S973, _S985) * _S986.y;
            (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 + _S984 * _slang_vector_get_element(_S973, _S985) * _S990;
            float total_3 = total_2 + _S984;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S991;
        if(_S978)
        {
            _S991 = diffuse_0;
        }
        else
        {
            _S991 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S991;
        float _S992;
        if(_S978)
        {
            _S992 = 0.0f;
        }
        else
        {
            _S992 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S992;
        float _S993;
        if(_S978)
        {
            _S993 = specular_0;
        }
        else
        {
            _S993 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S993;
        float _S994;
        if(_S978)
        {
            _S994 = 0.0f;
        }
        else
        {
            _S994 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S994;
        pack_0 = pack_0 + 1U;
    }
    CoverageTaps_0 _S995 = _S951;
    NodeTaps_0 _S996 = view_nodes_0;
    float _S997 = prefiltered_hole_0(_S945, &_S995, &_S996, _S949);
    (&sums_1)->hole_2 = _S997;
    float _S998 = (1.0f - _S997) / (F32_max((total_2), (9.999999960041972e-13f)));
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S998;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S998;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S998;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S998;
    (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 * _S998;
    return sums_1;
}

__device__ FamilyAlbedos_0 albedos_over_0(uint _S999, Footprint_0 * _S1000, bool _S1001)
{
    Fabric_0 * _S1002 = (&(globalParams_0->fabrics_0)[_S999]);
    float2  _S1003 = sqrt_0(_S1000->dx_0 * _S1000->dx_0 + _S1000->dy_0 * _S1000->dy_0);
    uint _S1004 = __ldg(&_S1002->warp_0);
    float2  _S1005 = _S1000->centre_0;
    Stretch_0 _S1006 = stretch_of_0(_S1004, _S1000->centre_0.x, _S1003.x);
    uint _S1007 = __ldg(&_S1002->weft_0);
    Stretch_0 _S1008 = stretch_of_0(_S1007, _S1005.y, _S1003.y);
    FamilyAlbedos_0 albedos_9;
    Stretch_0 _S1009 = _S1006;
    Stretch_0 _S1010 = _S1008;
    Albedos_0 _S1011 = mean_albedos_0(_S1004, _S1007, &_S1009, &_S1010, _S1001);
    (&albedos_9)->warp_5 = _S1011;
    Stretch_0 _S1012 = _S1008;
    Stretch_0 _S1013 = _S1006;
    Albedos_0 _S1014 = mean_albedos_0(_S1007, _S1004, &_S1012, &_S1013, _S1001);
    (&albedos_9)->weft_5 = _S1014;
    return albedos_9;
}

__device__ Estimate_0 lobes_estimate_of_pass_0(uint _S1015, Footprint_0 * _S1016, float _S1017, float2  _S1018, float3  _S1019, float3  _S1020)
{
    float _S1021;
    Fabric_0 * _S1022 = (&(globalParams_0->fabrics_0)[_S1015]);
    Regime_0 _S1023 = regime_of_0(_S1015, _S1016, _S1017);
    bool _S1024 = (_S1020.z) < 0.0f;
    float3  _S1025 = to_face_frame_0(_S1020, _S1024);
    float _S1026 = __ldg(&_S1022->fibre_noise_0);
    bool _S1027;
    if(_S1026 > 0.0f)
    {
        _S1027 = true;
    }
    else
    {
        float _S1028 = __ldg(&_S1022->colour_noise_0);
        _S1027 = _S1028 > 0.0f;
    }
    uint _S1029 = __ldg(&_S1022->warp_0);
    Family_0 _S1030 = slang_ldg_2((&(globalParams_0->families_0)[_S1029]));
    bool _S1031;
    if((_S1030.quantities_0) > 1U)
    {
        _S1031 = true;
    }
    else
    {
        uint _S1032 = __ldg(&_S1022->weft_0);
        Family_0 _S1033 = slang_ldg_2((&(globalParams_0->families_0)[_S1032]));
        _S1031 = (_S1033.quantities_0) > 1U;
    }
    float _S1034 = 1.0f - _S1023.prefiltered_0;
    if(_S1034 > 0.0f)
    {
        if(_S1027)
        {
            _S1031 = true;
        }
    }
    else
    {
        _S1031 = false;
    }
    Footprint_0 box_0 = *_S1016;
    float3  _S1035 = make_float3 (0.0f);
    SurfacePoint_0 _S1036 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S1035, _S1035, 0.0f, 0.0f, 0.0f);
    float2  _S1037 = _S1016->centre_0;
    Components_0 _S1038 = no_components_0();
    CloseUp_0 close_1 = no_close_up_0();
    int _S1039;
    if(_S1031)
    {
        _S1039 = int(0);
    }
    else
    {
        _S1039 = int(1);
    }
    uint _S1040 = uint(_S1039);
    Components_0 points_2 = _S1038;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S1036;
    float2  central_place_0 = _S1037;
    uint number_5 = _S1040;
    for(;;)
    {
        float _S1041 = float(number_5);
        _S1021 = _S1023.points_1;
        if(_S1041 < (_S1023.points_1 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S1042 = number_5 == 0U;
        uint _S1043;
        if(_S1042)
        {
            _S1043 = 0U;
        }
        else
        {
            _S1043 = number_5 - 1U;
        }
        float2  _S1044 = POINT_OFFSETS_0[_S1043] + _S1018;
        float2  _S1045;
        if(_S1042)
        {
            _S1045 = make_float2 (0.0f);
        }
        else
        {
            _S1045 = _S1044 - round_0(_S1044);
        }
        float2  _S1046 = _S1037 + make_float2 (_S1045.x) * _S1016->dx_0 + make_float2 (_S1045.y) * _S1016->dy_0;
        float _S1047;
        if(_S1042)
        {
            _S1047 = 0.0f;
        }
        else
        {
            _S1047 = _S1023.threads_1;
        }
        SearchQuality_0 _S1048 = quality_of_0(_S1047);
        float _S1049 = _S1046.x;
        float _S1050 = _S1046.y;
        SearchQuality_0 _S1051 = _S1048;
        Hit_0 _S1052 = first_hit_0(_S1015, &_S1051, _S1049, _S1050, _S1025, _S1024);
        SurfacePoint_0 _S1053 = surface_at_0(_S1015, _S1052.x_30, _S1052.y_17, _S1024);
        if(_S1042)
        {
            float central_weight_1;
            if(_S1052.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S1034;
            }
            float2  central_place_1 = make_float2 (_S1052.x_30, _S1052.y_17);
            (&box_0)->centre_0 = lerp_2(_S1037, central_place_1, make_float2 (central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S1053;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        SurfacePoint_0 _S1054 = _S1053;
        YarnPoint_0 _S1055 = yarn_point_of_0(_S1015, &_S1054, _S1052.x_30, _S1052.y_17, _S1024, _S1052.hole_5);
        SearchQuality_0 _S1056 = _S1048;
        YarnPoint_0 _S1057 = _S1055;
        Components_0 _S1058 = components_of_point_0(_S1015, &_S1056, &_S1057, _S1019, _S1020);
        float _S1059 = (F32_min((_S1023.points_1 - float(number_5 - 1U)), (1.0f)));
        Components_0 _S1060 = points_2;
        Components_0 _S1061 = _S1058;
        Components_0 _S1062 = with_added_0(&_S1060, &_S1061, _S1059);
        uint _S1063 = __ldg(&_S1022->openness_0);
        if(_S1063 != 4294967295U)
        {
            Blocked_0 _S1064 = (&close_1)->warp_1;
            YarnPoint_0 _S1065 = _S1055;
            Blocked_0 _S1066 = with_blocked_0(_S1015, &_S1064, &_S1065, true, _S1059);
            (&close_1)->warp_1 = _S1066;
            Blocked_0 _S1067 = (&close_1)->weft_1;
            YarnPoint_0 _S1068 = _S1055;
            Blocked_0 _S1069 = with_blocked_0(_S1015, &_S1067, &_S1068, false, _S1059);
            (&close_1)->weft_1 = _S1069;
        }
        points_2 = _S1062;
        number_5 = number_5 + 1U;
    }
    (&close_1)->weight_0 = _S1034;
    float _S1070 = (F32_max((_S1021), (1.0f)));
    float _S1071 = 1.0f / _S1070;
    Blocked_0 _S1072 = (&close_1)->warp_1;
    Blocked_0 _S1073 = scaled_0(&_S1072, _S1071);
    (&close_1)->warp_1 = _S1073;
    float _S1074 = 1.0f / _S1070;
    Blocked_0 _S1075 = (&close_1)->weft_1;
    Blocked_0 _S1076 = scaled_0(&_S1075, _S1074);
    (&close_1)->weft_1 = _S1076;
    Estimate_0 estimate_0;
    (&estimate_0)->close_0 = close_1;
    float _S1077 = _S1034 / _S1070;
    Components_0 _S1078 = _S1038;
    Components_0 _S1079 = points_2;
    Components_0 _S1080 = with_added_0(&_S1078, &_S1079, _S1077);
    (&estimate_0)->components_0 = _S1080;
    if((_S1023.prefiltered_0) > 0.0f)
    {
        Components_0 _S1081 = prefiltered_components_0(_S1015, _S1016, to_face_frame_0(_S1019, _S1024), _S1025, _S1024);
        Components_0 _S1082 = (&estimate_0)->components_0;
        Components_0 _S1083 = _S1081;
        Components_0 _S1084 = with_added_0(&_S1082, &_S1083, _S1023.prefiltered_0);
        (&estimate_0)->components_0 = _S1084;
    }
    Footprint_0 _S1085 = box_0;
    FamilyAlbedos_0 _S1086 = albedos_over_0(_S1015, &_S1085, _S1024);
    (&estimate_0)->albedos_5 = _S1086;
    if(_S1027)
    {
        _S1027 = central_weight_0 > 0.0f;
    }
    else
    {
        _S1027 = false;
    }
    if(_S1027)
    {
        SurfacePoint_0 _S1087 = central_0;
        Albedos_0 _S1088;
        if(central_0.is_warp_0)
        {
            _S1088 = (&(&estimate_0)->albedos_5)->warp_5;
        }
        else
        {
            _S1088 = (&(&estimate_0)->albedos_5)->weft_5;
        }
        float _S1089 = central_place_0.x;
        float _S1090 = central_place_0.y;
        SurfacePoint_0 _S1091 = central_0;
        Albedos_0 _S1092 = _S1088;
        Albedos_0 _S1093 = varied_at_0(_S1015, &_S1091, &_S1092, _S1089, _S1090);
        Albedos_0 _S1094 = _S1088;
        Albedos_0 _S1095 = _S1093;
        Albedos_0 _S1096 = lerp_albedos_0(&_S1094, &_S1095, central_weight_0);
        if(_S1087.is_warp_0)
        {
            (&(&estimate_0)->albedos_5)->warp_5 = _S1096;
        }
        else
        {
            (&(&estimate_0)->albedos_5)->weft_5 = _S1096;
        }
    }
    return estimate_0;
}

__device__ Estimate_0 lobes_estimate_0(uint _S1097, Footprint_0 * _S1098, float _S1099, float3  _S1100, float3  _S1101)
{
    Estimate_0 _S1102 = lobes_estimate_of_pass_0(_S1097, _S1098, _S1099, make_float2 (0.0f), _S1100, _S1101);
    return _S1102;
}

__device__ Scattered_0 scattered_by_0(uint _S1103, Albedos_0 * _S1104, uint _S1105, float3  _S1106)
{
    uint _S1107 = 159U + 2U * _S1105;
    Scattered_0 yarn_3;
    float3  _S1108 = _S1106 * _S1104->diffuse_reflect_0;
    float _S1109 = openness_number_0(_S1103, _S1107);
    (&yarn_3)->back_5 = _S1108 + make_float3 (_S1109) * _S1104->specular_reflect_0;
    float3  _S1110 = _S1106 * _S1104->diffuse_transmit_0;
    float _S1111 = openness_number_0(_S1103, _S1107 + 1U);
    (&yarn_3)->through_0 = _S1110 + make_float3 (_S1111) * _S1104->specular_transmit_0;
    return yarn_3;
}

__device__ void sent_0(uint _S1112, uint _S1113, float3  _S1114, float3  _S1115, float3  _S1116, float3  _S1117, float3  * _S1118, float3  * _S1119)
{
    uint _S1120 = 146U + 4U * _S1113;
    float _S1121 = openness_number_0(_S1112, _S1120);
    float _S1122 = openness_number_0(_S1112, _S1120 + 1U);
    float _S1123 = openness_number_0(_S1112, _S1120 + 2U);
    float _S1124 = openness_number_0(_S1112, _S1120 + 3U);
    float3  _S1125 = make_float3 (1.0f) - _S1116 * make_float3 (_S1121);
    float3  _S1126 = make_float3 (1.0f) - _S1117 * make_float3 (_S1124);
    float3  _S1127 = make_float3 (1.0f) / (_S1125 * _S1126 - _S1116 * _S1117 * make_float3 (_S1122 * _S1123));
    *_S1118 = (_S1114 * _S1126 + _S1116 * make_float3 (_S1122) * _S1115) * _S1127;
    *_S1119 = (_S1115 * _S1125 + _S1117 * make_float3 (_S1123) * _S1114) * _S1127;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S1128, uint _S1129, Scattered_0 * _S1130, Scattered_0 * _S1131)
{
    uint _S1132 = 2U * _S1129;
    uint _S1133 = 142U + _S1132;
    float _S1134 = openness_number_0(_S1128, _S1133);
    float _S1135 = openness_number_0(_S1128, _S1133 + 1U);
    float3  _S1136 = make_float3 (1.0f - _S1134) * _S1130->back_5;
    float3  _S1137 = make_float3 (1.0f - _S1135) * _S1131->back_5;
    FaceSends_0 sends_1;
    uint _S1138 = 154U + _S1132;
    float _S1139 = openness_number_0(_S1128, _S1138);
    (&sends_1)->blocks_warp_0 = _S1139;
    float _S1140 = openness_number_0(_S1128, _S1138 + 1U);
    (&sends_1)->blocks_weft_0 = _S1140;
    (&sends_1)->open_0 = _S1139 * _S1134 + _S1140 * _S1135;
    sent_0(_S1128, _S1129, make_float3 (_S1134) * _S1130->back_5, make_float3 (_S1135) * _S1131->back_5, _S1136, _S1137, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S1128, _S1129, _S1130->through_0, _S1131->through_0, _S1136, _S1137, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S1141, float3  _S1142, bool _S1143)
{
    Fabric_0 * _S1144 = (&(globalParams_0->fabrics_0)[_S1141]);
    uint _S1145 = __ldg(&_S1144->warp_0);
    Family_0 _S1146 = slang_ldg_2((&(globalParams_0->families_0)[_S1145]));
    Albedos_0 _S1147 = table_albedos_0(_S1146.colour_mean_0);
    Scattered_0 _S1148 = scattered_by_0(_S1141, &_S1147, 0U, _S1142);
    uint _S1149 = __ldg(&_S1144->weft_0);
    Family_0 _S1150 = slang_ldg_2((&(globalParams_0->families_0)[_S1149]));
    Albedos_0 _S1151 = table_albedos_0(_S1150.colour_mean_0);
    Scattered_0 _S1152 = scattered_by_0(_S1141, &_S1151, 1U, _S1142);
    uint _S1153;
    if(_S1143)
    {
        _S1153 = 1U;
    }
    else
    {
        _S1153 = 0U;
    }
    Scattered_0 _S1154 = _S1148;
    Scattered_0 _S1155 = _S1152;
    FaceSends_0 _S1156 = face_sends_0(_S1141, _S1153, &_S1154, &_S1155);
    if(_S1143)
    {
        _S1153 = 0U;
    }
    else
    {
        _S1153 = 1U;
    }
    Scattered_0 _S1157 = _S1148;
    Scattered_0 _S1158 = _S1152;
    FaceSends_0 _S1159 = face_sends_0(_S1141, _S1153, &_S1157, &_S1158);
    float3  _S1160 = make_float3 (_S1156.blocks_warp_0) * _S1156.crossing_warp_0 + make_float3 (_S1156.blocks_weft_0) * _S1156.crossing_weft_0;
    float3  _S1161 = make_float3 (_S1159.blocks_warp_0) * _S1159.crossing_warp_0 + make_float3 (_S1159.blocks_weft_0) * _S1159.crossing_weft_0;
    float _S1162 = 1.0f - _S1156.open_0;
    float _S1163 = 1.0f - _S1159.open_0;
    float3  _S1164 = make_float3 (1.0f) / (make_float3 (1.0f) - _S1160 * _S1161 * make_float3 (_S1162 * _S1163));
    float3  _S1165 = _S1161 * (make_float3 (_S1156.open_0) + make_float3 (_S1162) * (make_float3 (_S1156.blocks_warp_0) * _S1156.sky_warp_0 + make_float3 (_S1156.blocks_weft_0) * _S1156.sky_weft_0)) * _S1164;
    float3  _S1166 = _S1160 * (make_float3 (_S1159.open_0) + make_float3 (_S1163) * (make_float3 (_S1159.blocks_warp_0) * _S1159.sky_warp_0 + make_float3 (_S1159.blocks_weft_0) * _S1159.sky_weft_0)) * _S1164;
    FaceSends_0 _S1167 = _S1156;
    FaceRadiance_0 _S1168 = face_radiance_0(&_S1167, _S1159.open_0, _S1165, _S1166);
    FaceSends_0 _S1169 = _S1159;
    FaceRadiance_0 _S1170 = face_radiance_0(&_S1169, _S1156.open_0, _S1166, _S1165);
    Interior_0 interior_1;
    (&interior_1)->warp_4 = _S1168.warp_3;
    (&interior_1)->weft_4 = _S1168.weft_3;
    (&interior_1)->leaked_1 = _S1168.leaked_0;
    (&interior_1)->far_1 = _S1170.mean_0;
    (&interior_1)->far_leaked_0 = _S1170.leaked_0;
    return interior_1;
}

__device__ Blocked_0 blocked_from_0(uint _S1171, float3  _S1172, bool _S1173, bool _S1174)
{
    FixedArray<float, 6>  terms_1;
    view_terms_0(_S1172, &terms_1);
    uint _S1175;
    if(_S1174)
    {
        _S1175 = 2U;
    }
    else
    {
        _S1175 = 0U;
    }
    uint _S1176;
    if(_S1173)
    {
        _S1176 = 0U;
    }
    else
    {
        _S1176 = 1U;
    }
    uint _S1177 = (_S1175 + _S1176) * 15U;
    FixedArray<float, 6>  _S1178 = terms_1;
    Blocked_0 _S1179 = blocked_of_terms_0(_S1171, _S1177, &_S1178, 5U);
    return _S1179;
}

__device__ float warp_seen_from_0(uint _S1180, float3  _S1181, bool _S1182)
{
    FixedArray<float, 6>  terms_2;
    view_terms_0(_S1181, &terms_2);
    uint term_1 = 0U;
    float share_4 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S1183;
        if(_S1182)
        {
            _S1183 = 5U;
        }
        else
        {
            _S1183 = 0U;
        }
        float _S1184 = openness_number_0(_S1180, 132U + _S1183 + term_1);
        float share_5 = share_4 + _S1184 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_4 = share_5;
    }
    return saturate_1(share_4);
}

__device__ Bounced_0 bounced_of_families_0(uint _S1185, FamilyAlbedos_0 * _S1186, float3  _S1187, Interior_0 * _S1188, Blocked_0 * _S1189, Blocked_0 * _S1190)
{
    Scattered_0 _S1191 = scattered_by_0(_S1185, &_S1186->warp_5, 0U, _S1187);
    Scattered_0 _S1192 = _S1191;
    Bounced_0 _S1193 = bounced_by_0(_S1189, &_S1192, _S1188);
    Scattered_0 _S1194 = scattered_by_0(_S1185, &_S1186->weft_5, 1U, _S1187);
    Scattered_0 _S1195 = _S1194;
    Bounced_0 _S1196 = bounced_by_0(_S1190, &_S1195, _S1188);
    Bounced_0 _S1197 = _S1193;
    Bounced_0 _S1198 = _S1196;
    Bounced_0 _S1199 = sum_of_0(&_S1197, &_S1198);
    return _S1199;
}

__device__ Bounced_0 bounced_far_0(uint _S1200, FamilyAlbedos_0 * _S1201, float3  _S1202, Interior_0 * _S1203, float3  _S1204, bool _S1205, float _S1206, float _S1207, float _S1208)
{
    Blocked_0 _S1209 = blocked_from_0(_S1200, _S1204, true, _S1205);
    Blocked_0 _S1210 = blocked_from_0(_S1200, _S1204, false, _S1205);
    float _S1211 = _S1206 / (F32_max((1.0f - _S1209.by_warp_0 - _S1209.by_weft_0), (0.10000000149011612f)));
    float _S1212 = _S1207 / (F32_max((1.0f - _S1210.by_warp_0 - _S1210.by_weft_0), (0.10000000149011612f)));
    float _S1213 = warp_seen_from_0(_S1200, _S1204, _S1205);
    float _S1214 = (0.0020000000949949f * _S1213 + _S1211) / (_S1211 + _S1212 + 0.0020000000949949f);
    float _S1215 = 1.0f - _S1208;
    float _S1216 = _S1214 * _S1215;
    Blocked_0 _S1217 = _S1209;
    Blocked_0 _S1218 = scaled_0(&_S1217, _S1216);
    float _S1219 = (1.0f - _S1214) * _S1215;
    Blocked_0 _S1220 = _S1210;
    Blocked_0 _S1221 = scaled_0(&_S1220, _S1219);
    Blocked_0 _S1222 = _S1218;
    Blocked_0 _S1223 = _S1221;
    Bounced_0 _S1224 = bounced_of_families_0(_S1200, _S1201, _S1202, _S1203, &_S1222, &_S1223);
    return _S1224;
}

__device__ Bounced_0 bounced_over_0(uint _S1225, Components_0 * _S1226, CloseUp_0 * _S1227, FamilyAlbedos_0 * _S1228, float3  _S1229, float3  _S1230)
{
    bool _S1231 = (_S1230.z) < 0.0f;
    Interior_0 _S1232 = interior_of_0(_S1225, _S1229, _S1231);
    float3  _S1233 = to_face_frame_0(_S1230, _S1231);
    Interior_0 _S1234 = _S1232;
    Bounced_0 _S1235 = bounced_far_0(_S1225, _S1228, _S1229, &_S1234, _S1233, _S1231, _S1226->diffuse_warp_0, _S1226->diffuse_weft_0, _S1226->hole_2);
    Bounced_0 bounced_2 = _S1235;
    float _S1236 = _S1227->weight_0;
    if((_S1227->weight_0) > 0.0f)
    {
        Interior_0 _S1237 = _S1232;
        Bounced_0 _S1238 = bounced_of_families_0(_S1225, _S1228, _S1229, &_S1237, &_S1227->warp_1, &_S1227->weft_1);
        float3  _S1239 = make_float3 (_S1236);
        (&bounced_2)->reflected_0 = lerp_0((&bounced_2)->reflected_0, _S1238.reflected_0, _S1239);
        (&bounced_2)->transmitted_0 = lerp_0((&bounced_2)->transmitted_0, _S1238.transmitted_0, _S1239);
    }
    return bounced_2;
}

__device__ float3  composed_0(uint _S1240, Components_0 * _S1241, CloseUp_0 * _S1242, FamilyAlbedos_0 * _S1243, float3  _S1244, float3  _S1245, float3  _S1246)
{
    Fabric_0 * _S1247 = (&(globalParams_0->fabrics_0)[_S1240]);
    Albedos_0 _S1248 = tinted_0(&_S1243->warp_5, _S1244);
    Albedos_0 _S1249 = tinted_0(&_S1243->weft_5, _S1244);
    float _S1250 = _S1241->diffuse_warp_0;
    float _S1251 = _S1241->diffuse_weft_0;
    float _S1252 = _S1241->specular_warp_0;
    float _S1253 = _S1241->specular_weft_0;
    float3  _S1254 = _S1248.diffuse_reflect_0 * make_float3 (_S1241->diffuse_warp_0) + _S1249.diffuse_reflect_0 * make_float3 (_S1241->diffuse_weft_0) + _S1248.specular_reflect_0 * make_float3 (_S1241->specular_warp_0) + _S1249.specular_reflect_0 * make_float3 (_S1241->specular_weft_0);
    float _S1255 = _S1246.z;
    float3  body_0;
    if((_S1245.z * _S1255) < 0.0f)
    {
        body_0 = _S1248.diffuse_transmit_0 * make_float3 (_S1250) + _S1249.diffuse_transmit_0 * make_float3 (_S1251) + _S1248.specular_transmit_0 * make_float3 (_S1252) + _S1249.specular_transmit_0 * make_float3 (_S1253);
    }
    else
    {
        body_0 = _S1254;
    }
    uint _S1256 = __ldg(&_S1247->openness_0);
    if(_S1256 != 4294967295U)
    {
        Bounced_0 _S1257 = bounced_over_0(_S1240, _S1241, _S1242, _S1243, _S1244, _S1246);
        Bounced_0 _S1258 = _S1257;
        float3  _S1259 = bounced_value_0(&_S1258, _S1245, _S1246);
        body_0 = body_0 + _S1259;
    }
    float _S1260 = __ldg(&_S1247->sheen_strength_0);
    if(_S1260 <= 0.0f)
    {
        return body_0;
    }
    bool _S1261 = _S1255 < 0.0f;
    float3  _S1262 = to_face_frame_0(_S1245, _S1261);
    float3  _S1263 = to_face_frame_0(_S1246, _S1261);
    float _S1264 = __ldg(&_S1247->sheen_roughness_0);
    float2  _S1265 = sheen_with_transmittance_0(_S1262, _S1263, _S1260, _S1264);
    return make_float3 (_S1265.y) * body_0 + make_float3 ((_S1241->light_visibility_1 + _S1241->hole_2) * _S1265.x);
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_2, float2  dx_1, float2  dy_1, float3  light_10, float3  view_10)
{
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_2;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    Footprint_0 _S1266 = footprint_0;
    Estimate_0 _S1267 = lobes_estimate_0(fabric_2, &_S1266, 1.0f, light_10, view_10);
    float3  _S1268 = make_float3 (1.0f);
    Components_0 _S1269 = _S1267.components_0;
    CloseUp_0 _S1270 = _S1267.close_0;
    FamilyAlbedos_0 _S1271 = _S1267.albedos_5;
    float3  _S1272 = composed_0(fabric_2, &_S1269, &_S1270, &_S1271, _S1268, light_10, view_10);
    float _S1273 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
    float through_1;
    if(_S1273 > 0.0f)
    {
        float _S1274 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
        float _S1275 = (F32_abs((view_10.z)));
        float _S1276 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_roughness_0);
        through_1 = _S1267.components_0.hole_2 * (1.0f - _S1274 * sheen_lobe_0(_S1275, _S1276).z);
    }
    else
    {
        through_1 = _S1267.components_0.hole_2;
    }
    return make_float4 (_S1272.x, _S1272.y, _S1272.z, through_1);
}

extern "C" __global__ void lobes_queries()
{
    uint _S1277 = (blockIdx * blockDim + threadIdx).x;
    uint _S1278 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S1277 >= _S1278)
    {
        return;
    }
    Query_0 _S1279 = slang_ldg_0((&(globalParams_0->queries_0)[_S1277]));
    *(&(globalParams_0->answers_0)[_S1277]) = cloth_value_0(_S1279.fabric_1, make_float2 (_S1279.centre_x_0, _S1279.centre_y_0), make_float2 (_S1279.dx_x_0, _S1279.dx_y_0), make_float2 (_S1279.dy_x_0, _S1279.dy_y_0), make_float3 (_S1279.light_x_0, _S1279.light_y_0, _S1279.light_z_0), make_float3 (_S1279.view_x_0, _S1279.view_y_0, _S1279.view_z_0));
    return;
}

