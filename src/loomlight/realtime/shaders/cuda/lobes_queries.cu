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
__device__ float lerp_1(float x_15, float y_10, float s_1)
{
    return x_15 + (y_10 - x_15) * s_1;
}

__device__ float2  lerp_2(float2  x_16, float2  y_11, float2  s_2)
{
    return x_16 + (y_11 - x_16) * s_2;
}

__device__ float3  normalize_0(float3  x_17)
{
    return x_17 / make_float3 (length_0(x_17));
}

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ float2  round_0(float2  x_18)
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
        *_slang_vector_get_element_ptr(&result_10, i_7) = (F32_round((_slang_vector_get_element(x_18, i_7))));
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

__device__ float natural_logarithm_0(float x_19)
{
    uint _S34 = (F32_asuint((x_19)));
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

__device__ float binary_logarithm_0(float x_20)
{
    return natural_logarithm_0(x_20) * 1.4426950216293335f;
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_1)
{
    float2  _S36 = float2 {direction_0.x, direction_0.y};
    float _S37;
    if(back_1)
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
    float height_1;
    float3  normal_0;
    float3  tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_2, float3  normal_1, float3  tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    SurfacePoint_0 _S70;
    (&_S70)->hole_0 = hole_1;
    (&_S70)->is_warp_0 = is_warp_1;
    (&_S70)->warp_thread_0 = warp_thread_1;
    (&_S70)->weft_thread_0 = weft_thread_1;
    (&_S70)->height_1 = height_2;
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

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

__device__ SearchQuality_0 quality_of_0(float threads_0)
{
    float _S71 = clamp_1((-3.0f - binary_logarithm_0((F32_max((threads_0), (9.99999971718068537e-10f))))) / 2.0f, 0.0f, 1.0f);
    SearchQuality_0 quality_0;
    float _S72 = lerp_1(2.5f, 5.0f, _S71);
    (&quality_0)->steps_per_thread_0 = _S72;
    (&quality_0)->steps_per_relief_0 = _S72;
    (&quality_0)->shadow_share_0 = lerp_1(1.60000002384185791f, 1.0f, _S71);
    (&quality_0)->refinements_0 = uint(lerp_1(1.0f, 2.0f, _S71) + 0.5f);
    return quality_0;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_0)
{
    Family_0 _S73 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    Family_0 _S74 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    float _S75 = (F32_floor(((F32_fma((index_0), (_S73.inverse_count_0), (_S74.half_inverse_count_0))))));
    float _S76 = - _S75;
    Family_0 _S77 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S75, (F32_fma((_S76), (_S77.count_0), (index_0))));
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
    Family_0 _S78 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S79 = (F32_floor((position_0 * _S78.inverse_size_0)));
    Cell_0 cell_0;
    float _S80 = - _S79;
    Family_0 _S81 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S82 = (F32_fma((_S80), (_S81.size_0), (position_0)));
    (&cell_0)->below_0 = _S82;
    Family_0 _S83 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->above_0 = _S83.size_0 - _S82;
    Family_0 _S84 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->across_2 = _S82 - 0.5f * _S84.size_0;
    Family_0 _S85 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->half_width_1 = _S85.half_width_0;
    float _S86 = turns_and_remainder_0(family_1, _S79).y;
    Family_0 _S87 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->thread_0 = uint(clamp_1(_S86, 0.0f, _S87.count_0 - 1.0f));
    return cell_0;
}

__device__ float table_number_0(uint index_1)
{
    uint _S88 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S88)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    Family_0 _S89 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S90 = position_1 - _S89.start_0;
    Family_0 _S91 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S90 * _S91.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S92 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S93 = turns_1 * _S92.period_0;
    Family_0 _S94 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S95 = turns_1 * _S94.bins_0;
    Family_0 _S96 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S97 = uint(clamp_1(_S95, 0.0f, _S96.bins_0 - 1.0f));
    Family_0 _S98 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S99 = __ldg((&(globalParams_0->words_0)[_S98.first_thread_table_0 + _S97]));
    Family_0 _S100 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S101;
    if(_S93 >= (table_number_0(_S100.place_table_0 + _S99 * 4U + 1U)))
    {
        _S101 = 1U;
    }
    else
    {
        _S101 = 0U;
    }
    uint _S102 = _S99 + _S101;
    Family_0 _S103 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S104 = (U32_min((_S102), (uint(_S103.count_0) - 1U)));
    Family_0 _S105 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S106 = _S105.place_table_0 + _S104 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S104;
    (&cell_1)->below_0 = _S93 - table_number_0(_S106);
    (&cell_1)->above_0 = table_number_0(_S106 + 1U) - _S93;
    (&cell_1)->across_2 = _S93 - table_number_0(_S106 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S106 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    Family_0 _S107 = slang_ldg_2((&(globalParams_0->families_0)[family_3]));
    if((_S107.is_alike_0) != 0U)
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
    Cell_0 warp_1;
    Cell_0 weft_1;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_2)
{
    bool _S108 = (F32_abs(((&crossing_0->warp_1)->across_2))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S109 = (F32_abs(((&crossing_0->weft_1)->across_2))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S110;
    if(_S108)
    {
        if(!_S109)
        {
            _S110 = true;
        }
        else
        {
            _S110 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S110 = false;
    }
    (&shown_0)->is_warp_2 = _S110;
    if(!_S108)
    {
        _S110 = !_S109;
    }
    else
    {
        _S110 = false;
    }
    (&shown_0)->hole_3 = _S110;
    uint _S111;
    if((&shown_0)->is_warp_2)
    {
        _S111 = crossing_0->warp_word_0;
    }
    else
    {
        _S111 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S111;
    (&shown_0)->on_top_0 = ((_S111 & 1U) == 1U) != back_2;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_2;
    uint _S112;
    if(is_first_0)
    {
        _S112 = first_0->thread_0;
    }
    else
    {
        _S112 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S112;
    float _S113;
    if(is_first_0)
    {
        _S113 = first_0->across_2;
    }
    else
    {
        _S113 = second_0->across_2;
    }
    (&cell_2)->across_2 = _S113;
    if(is_first_0)
    {
        _S113 = first_0->half_width_1;
    }
    else
    {
        _S113 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S113;
    if(is_first_0)
    {
        _S113 = first_0->below_0;
    }
    else
    {
        _S113 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S113;
    if(is_first_0)
    {
        _S113 = first_0->above_0;
    }
    else
    {
        _S113 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S113;
    return cell_2;
}

__device__ float boundary_0(uint family_4, uint thread_1, int step_0)
{
    float2  _S114 = turns_and_remainder_0(family_4, float(int(thread_1) + step_0));
    float _S115 = _S114.x;
    Family_0 _S116 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    Family_0 _S117 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S115), (_S116.period_0), (table_number_0(_S117.place_table_0 + uint(_S114.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_2, int first_1, int last_0)
{
    Family_0 _S118 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
    if((_S118.is_alike_0) != 0U)
    {
        float _S119 = float(last_0 - first_1);
        Family_0 _S120 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
        return _S119 * _S120.size_0;
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
    Family_0 _S121 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    Family_0 _S122 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    uint _S123;
    if((_S122.is_alike_0) != 0U)
    {
        _S123 = 0U;
    }
    else
    {
        _S123 = thread_3 * 4U;
    }
    uint _S124 = _S121.bend_table_0 + _S123;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S124);
    (&bend_0)->half_tangent_0 = table_number_0(_S124 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S124 + 2U);
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
    int _S125 = int((word_1 >> int(1)) & 127U);
    int _S126 = int((word_1 >> int(8)) & 127U);
    int _S127 = int((word_1 >> int(15)) & 63U);
    int _S128 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S129 = crossed_0->thread_0;
    int _S130 = - _S125;
    float _S131 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_0, _S130, int(0));
    (&run_0)->from_start_0 = _S131;
    int _S132 = _S126 + int(1);
    float _S133 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_0, int(1), _S132);
    (&run_0)->to_end_0 = _S133;
    bool _S134 = _S131 < _S133;
    (&run_0)->near_start_0 = _S134;
    int _S135;
    if(_S134)
    {
        _S135 = _S130 - _S127;
    }
    else
    {
        _S135 = _S132;
    }
    int _S136;
    if((&run_0)->near_start_0)
    {
        _S136 = _S130;
    }
    else
    {
        _S136 = _S132 + _S128;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_4);
    float _S137;
    if((&run_0)->straight_0)
    {
        _S137 = 1.0e+06f;
    }
    else
    {
        _S137 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S137;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S129, _S135, _S136)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S125 == int(0);
    (&run_0)->last_crossing_0 = _S126 == int(0);
    return run_0;
}

__device__ float square_0(float x_21)
{
    return x_21 * x_21;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_3)
{
    float _S138 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S139 = clamp_1(cell_3->across_2, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_3 = _S139;
    float _S140 = _S138 * _S138 - square_0(_S139);
    float _S141 = (F32_rsqrt((_S140)));
    (&section_0)->drop_0 = _S138 - _S140 * _S141;
    (&section_0)->slope_0 = - _S139 * _S141;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_5, int step_1)
{
    Family_0 _S142 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    if((_S142.is_alike_0) != 0U)
    {
        Family_0 _S143 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S143.bend_table_0 + 3U);
    }
    Family_0 _S144 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S144.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_5) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S145 = crossed_1->below_0;
    float _S146 = crossed_1->above_0;
    bool _S147 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S148 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S149;
    if(_S147)
    {
        _S149 = _S145 - crossed_1->across_2;
    }
    else
    {
        _S149 = _S146 + crossed_1->across_2;
    }
    float _S150 = _S149 - crossed_1->half_width_1;
    bool _S151;
    if(_S147)
    {
        _S151 = run_1->first_crossing_0;
    }
    else
    {
        _S151 = run_1->last_crossing_0;
    }
    bool _S152 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S149 = 0.0f;
    }
    else
    {
        Family_0 _S153 = slang_ldg_2((&(globalParams_0->families_0)[other_1]));
        _S149 = _S153.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_0, int(0));
    }
    float _S154;
    if(_S152 != _S151)
    {
        _S154 = 0.0f;
    }
    else
    {
        Family_0 _S155 = slang_ldg_2((&(globalParams_0->families_0)[other_1]));
        uint _S156 = crossed_1->thread_0;
        int _S157;
        if(_S147)
        {
            _S157 = int(-1);
        }
        else
        {
            _S157 = int(1);
        }
        _S154 = _S155.height_scale_0 * edge_drop_0(other_1, _S156, _S157);
    }
    float _S158 = 1.0f / (F32_max((2.0f * _S150), (9.999999960041972e-13f)));
    float _S159 = clamp_1((_S150 - _S148) * _S158, 0.0f, 1.0f);
    float _S160 = _S149 + (_S154 - _S149) * (_S159 * _S159 * (3.0f - 2.0f * _S159));
    float _S161 = (_S149 - _S154) * (6.0f * _S159 * (1.0f - _S159) * _S158);
    if(_S147)
    {
        _S149 = 1.0f;
    }
    else
    {
        _S149 = -1.0f;
    }
    return make_float2 (_S160, _S161 * _S149);
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
    float _S162 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S162)))), (9.99999971718068537e-10f)));
    float _S163 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S163)))), (9.99999971718068537e-10f)));
    (&control_0)->right_0 = _S162 > 0.0f;
    (&control_0)->up_0 = _S163 > 0.0f;
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
    float _S164;
    if(forwards_0)
    {
        _S164 = cell_4->across_2;
    }
    else
    {
        _S164 = - cell_4->across_2;
    }
    float _S165;
    if(forwards_0)
    {
        _S165 = cell_4->above_0;
    }
    else
    {
        _S165 = cell_4->below_0;
    }
    bool _S166;
    if(forwards_0)
    {
        _S166 = run_2->last_crossing_0;
    }
    else
    {
        _S166 = run_2->first_crossing_0;
    }
    bool _S167;
    if(forwards_0)
    {
        _S167 = run_2->first_crossing_0;
    }
    else
    {
        _S167 = run_2->last_crossing_0;
    }
    float _S168 = cell_4->half_width_1;
    float _S169 = - cell_4->half_width_1;
    bool _S170 = _S164 < _S169;
    bool _S171 = _S164 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S166 = !_S166;
    }
    else
    {
        _S166 = false;
    }
    if(_S166)
    {
        _S166 = !shown_2->hole_3;
    }
    else
    {
        _S166 = false;
    }
    bool _S172;
    if(_S166)
    {
        _S172 = shown_2->on_top_0;
    }
    else
    {
        _S172 = false;
    }
    if(_S172)
    {
        if(_S167)
        {
            _S167 = _S170;
        }
        else
        {
            _S167 = false;
        }
        _S167 = !_S167;
    }
    else
    {
        _S167 = false;
    }
    if(shown_2->hole_3)
    {
        _S166 = true;
    }
    else
    {
        if(_S166)
        {
            _S166 = !shown_2->on_top_0;
        }
        else
        {
            _S166 = false;
        }
    }
    float _S173;
    if(_S170)
    {
        _S173 = _S169;
    }
    else
    {
        _S173 = _S168;
    }
    float _S174 = _S173 - _S164;
    if(_S166)
    {
        _S164 = 2.0f * _S165 + _S164 - _S168;
    }
    else
    {
        _S164 = _S165;
    }
    if(_S167)
    {
        if(forwards_0)
        {
            _S164 = run_2->to_end_0;
        }
        else
        {
            _S164 = run_2->from_start_0;
        }
        return _S164;
    }
    if(_S171)
    {
    }
    else
    {
        _S164 = _S174;
    }
    return _S164;
}

struct Probe_0
{
    float height_3;
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
    float _S175 = previous_1->rate_0;
    float _S176 = previous_1->rate_0 * step_4;
    float _S177 = rate_1 * step_4;
    bool _S178;
    if(!previous_1->known_0)
    {
        _S178 = true;
    }
    else
    {
        _S178 = here_0->hole_4;
    }
    if(_S178)
    {
        _S178 = true;
    }
    else
    {
        _S178 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S178)
    {
        _S178 = true;
    }
    else
    {
        _S178 = _S175 >= 0.0f;
    }
    if(_S178)
    {
        _S178 = true;
    }
    else
    {
        _S178 = rate_1 <= 0.0f;
    }
    if(_S178)
    {
        return -1.0f;
    }
    float _S179 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S176) >= 0.0f)
    {
        _S178 = (3.0f * clearance_1 - _S177) >= 0.0f;
    }
    else
    {
        _S178 = false;
    }
    if(_S178)
    {
        return -1.0f;
    }
    float _S180 = clearance_1 - _S179;
    float _S181 = 6.0f * _S180 - 4.0f * _S176 - 2.0f * _S177;
    float _S182 = -2.0f * _S176 / (F32_max((_S181 + (F32_sqrt(((F32_max((_S181 * _S181 - 4.0f * (3.0f * (_S176 + _S177 - 2.0f * _S180)) * _S176), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S183 = 1.0f - _S182;
    float _S184 = (_S179 * (2.0f * _S182 + 1.0f) + _S176 * _S182) * _S183 * _S183;
    float _S185 = (clearance_1 * (2.0f * _S183 + 1.0f) - _S177 * _S183) * _S182 * _S182;
    if(_S182 > 0.01999999955296516f)
    {
        _S178 = _S183 > 0.01999999955296516f;
    }
    else
    {
        _S178 = false;
    }
    if(_S178)
    {
        _S178 = (_S184 + _S185) < 0.0f;
    }
    else
    {
        _S178 = false;
    }
    float _S186;
    if(_S178)
    {
        _S186 = _S183 * step_4;
    }
    else
    {
        _S186 = -1.0f;
    }
    return _S186;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S187 = here_1->hole_4;
    float _S188;
    if(here_1->hole_4)
    {
        _S188 = 1.0e+09f;
    }
    else
    {
        _S188 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S188;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S189;
    if(!_S187)
    {
        _S189 = !is_cell_exit_0;
    }
    else
    {
        _S189 = false;
    }
    (&previous_2)->known_0 = _S189;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S190 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S191;
    if(!here_2->hole_4)
    {
        _S191 = (rate_3 * _S190 + clearance_3) < 0.0f;
    }
    else
    {
        _S191 = false;
    }
    if(_S191)
    {
        _S191 = _S190 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S191 = false;
    }
    float _S192 = this_2->step_2;
    float _S193;
    if(_S191)
    {
        _S193 = _S190 - this_2->epsilon_0;
    }
    else
    {
        _S193 = (F32_max((_S190), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S192), (_S193)));
}

struct ViewRay_0
{
    float2  origin_0;
    float2  slope_1;
};

__device__ float2  ViewRay_at_0(ViewRay_0 * this_3, float height_4)
{
    return this_3->origin_0 + this_3->slope_1 * make_float2 (height_4);
}

__device__ float ViewRay_rate_0(ViewRay_0 * this_4, Probe_0 * here_3)
{
    return here_3->slope_x_0 * this_4->slope_1.x + here_3->slope_y_0 * this_4->slope_1.y - 1.0f;
}

__device__ float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S194 = end_0 - start_1;
    float _S195 = start_rate_0 + end_rate_0 - 2.0f * _S194;
    float _S196 = 3.0f * _S194 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S194), (9.99999968265522539e-21f)));
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
        float _S197 = clamp_1(share_1 - (((_S195 * share_1 + _S196) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S195 * share_1 + 2.0f * _S196) * share_1 + start_rate_0), (0.10000000149011612f * _S194 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S198 = i_8 + int(1);
        share_1 = _S197;
        i_8 = _S198;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_1(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S199 = along_slope_0 * along_slope_0 + 1.0f;
    float _S200 = (F32_rsqrt((_S199)));
    float _S201 = sine_1 * _S200 * (F32_rsqrt((_S199 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S201 * _S199, _S201 * across_slope_0 * along_slope_0 + cosine_0 * _S200);
}

__device__ float arc_sine_0(float x_22)
{
    float _S202 = (F32_abs((x_22)));
    bool _S203 = _S202 > 0.5f;
    float _S204;
    if(_S203)
    {
        _S204 = 0.5f * (1.0f - _S202);
    }
    else
    {
        _S204 = _S202 * _S202;
    }
    float _S205;
    if(_S203)
    {
        _S205 = (F32_sqrt(((F32_max((_S204), (0.0f))))));
    }
    else
    {
        _S205 = _S202;
    }
    float _S206 = ((((0.04216320067644119f * _S204 + 0.02418131195008755f) * _S204 + 0.04547002539038658f) * _S204 + 0.07495300471782684f) * _S204 + 0.16666752099990845f) * _S204 * _S205 + _S205;
    if(_S203)
    {
        _S204 = 1.57079637050628662f - 2.0f * _S206;
    }
    else
    {
        _S204 = _S206;
    }
    if(x_22 < 0.0f)
    {
        _S204 = - _S204;
    }
    return _S204;
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
    Family_0 _S207 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    Family_0 _S208 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    return table_albedos_0(_S207.albedo_table_0 + _S208.albedo_stride_0 * thread_6);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S209 = value_0 * 747796405U + 2891336453U;
    uint _S210 = ((_S209 >> ((_S209 >> int(28)) + 4U)) ^ _S209) * 277803737U;
    return (_S210 >> int(22)) ^ _S210;
}

__device__ float uniform_hash_0(uint thread_7, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_7 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float thread_gain_0(uint thread_8, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_8, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_0, float3  room_0)
{
    float3  _S211 = room_0 / max_0(albedo_0, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S211.x), (_S211.y)))), (_S211.z)))), (0.0f))))));
}

__device__ float fibre_gain_0(uint thread_9, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_6, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

__device__ float diffuse_reflection_0(float3  light_0, float3  normal_2, float blend_0)
{
    float _S212 = light_0.z;
    if(_S212 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_1((F32_max((_S212), (0.0f))), (F32_max((dot_0(light_0, normal_2)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_2, float roughness_1)
{
    float _S213 = dot_0(direction_2, tangent_2);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S213 * _S213 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_23)
{
    float _S214 = clamp_1(x_23, -87.0f, 88.0f);
    float _S215 = (F32_floor((_S214 * 1.4426950216293335f + 0.5f)));
    float _S216 = _S214 - _S215 * 0.693359375f + _S215 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S216 + 0.00139819993637502f) * _S216 + 0.00833345204591751f) * _S216 + 0.04166579619050026f) * _S216 + 0.1666666567325592f) * _S216 + 0.5f;
    float _S217 = (U32_asfloat((uint(int(_S215) + int(127)) << int(23))));
    float _S218;
    if(x_23 < -87.0f)
    {
        _S218 = 0.0f;
    }
    else
    {
        _S218 = (p_0 * _S216 * _S216 + _S216 + 1.0f) * _S217;
    }
    return _S218;
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
    float _S219 = roughness_2 * roughness_2;
    float _S220 = squared_along_0 * (1.0f - _S219) + _S219;
    return 0.31830987334251404f * _S219 * roughness_2 / (_S220 * _S220);
}

__device__ float density_between_0(float3  light_1, float3  view_0, float3  tangent_3, float roughness_3)
{
    float3  _S221 = light_1 + view_0;
    float _S222 = dot_0(_S221, tangent_3);
    return flake_density_0((F32_min((_S222 * _S222 / (F32_max((square_1(_S221)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float transmission_0(float3  light_2, float3  view_1, float3  normal_3, float3  tangent_4, float roughness_4, float optical_depth_1)
{
    float _S223 = - dot_0(light_2, normal_3);
    float _S224 = dot_0(view_1, normal_3);
    bool _S225;
    if(_S223 <= 0.0f)
    {
        _S225 = true;
    }
    else
    {
        _S225 = _S224 <= 0.0f;
    }
    if(_S225)
    {
        return 0.0f;
    }
    float _S226 = 1.0f / (F32_max((_S224), (9.99999997475242708e-07f)));
    float _S227 = projected_area_1(light_2, tangent_4, roughness_4) / (F32_max((_S223), (9.99999997475242708e-07f)));
    float _S228 = projected_area_1(view_1, tangent_4, roughness_4) * _S226;
    return density_between_0(light_2, view_1, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * (F32_min((_S227), (_S228)))) * mean_attenuation_0(optical_depth_1 * (F32_abs((_S227 - _S228)))) * _S226;
}

__device__ float reflection_0(float3  light_3, float3  view_2, float3  normal_4, float3  tangent_5, float roughness_5, float optical_depth_2)
{
    float _S229 = dot_0(light_3, normal_4);
    bool _S230;
    if(_S229 <= 0.0f)
    {
        _S230 = true;
    }
    else
    {
        _S230 = (dot_0(view_2, normal_4)) <= 0.0f;
    }
    if(_S230)
    {
        return 0.0f;
    }
    float _S231 = (F32_max((_S229), (9.99999997475242708e-07f)));
    float _S232 = (F32_max((dot_0(view_2, normal_4)), (9.99999997475242708e-07f)));
    float _S233 = projected_area_1(light_3, tangent_5, roughness_5) * _S232 + projected_area_1(view_2, tangent_5, roughness_5) * _S231;
    float _S234 = optical_depth_2 * _S233 / (_S231 * _S232);
    return 0.25f * density_between_0(light_3, view_2, tangent_5, roughness_5) * (_S234 * mean_attenuation_0(_S234)) * _S231 / _S233;
}

__device__ Components_0 with_added_0(Components_0 * sums_0, Components_0 * more_0, float weight_0)
{
    Components_0 result_11;
    (&result_11)->diffuse_warp_0 = sums_0->diffuse_warp_0 + weight_0 * more_0->diffuse_warp_0;
    (&result_11)->diffuse_weft_0 = sums_0->diffuse_weft_0 + weight_0 * more_0->diffuse_weft_0;
    (&result_11)->specular_warp_0 = sums_0->specular_warp_0 + weight_0 * more_0->specular_warp_0;
    (&result_11)->specular_weft_0 = sums_0->specular_weft_0 + weight_0 * more_0->specular_weft_0;
    (&result_11)->light_visibility_1 = sums_0->light_visibility_1 + weight_0 * more_0->light_visibility_1;
    (&result_11)->hole_2 = sums_0->hole_2 + weight_0 * more_0->hole_2;
    return result_11;
}

__device__ float wrapped_cell_0(float position_3, float count_1)
{
    return (F32_min(((F32_floor(((position_3 - (F32_floor((position_3)))) * count_1)))), (count_1 - 1.0f)));
}

__device__ float arc_tangent_quotient_0(float x_24, float y_12)
{
    return ((((((0.0f * x_24 + 0.00809729471802711f) * x_24 + -0.0377517081797123f) * x_24 + 0.08475969731807709f) * x_24 + -0.13537675142288208f) * x_24 + 0.19895026087760925f) * x_24 + -0.33327975869178772f) * x_24 + 0.99999970197677612f;
}

__device__ float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

__device__ float arc_tangent_0(float y_13, float x_25)
{
    float _S235 = (F32_abs((x_25)));
    float _S236 = (F32_abs((y_13)));
    float angle_0 = arc_tangent_of_ratio_0((F32_min((_S235), (_S236))) / (F32_max(((F32_max((_S235), (_S236)))), (1.00000000317107685e-30f))));
    float angle_1;
    if(_S236 > _S235)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_25 < 0.0f)
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
    float _S237 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    float _S238 = (F32_floor((_S237)));
    float _S239 = _S237 - _S238;
    float _S240 = (F32_sqrt((clamp_1((1.0f - (F32_abs((direction_3.z)))) / 0.97000002861022949f, 0.0f, 1.0f))));
    float _S241 = 7.0f * _S240 * (F32_sqrt((_S240)));
    float _S242 = (F32_min(((F32_floor((_S241)))), (6.0f)));
    float _S243 = _S241 - _S242;
    uint _S244 = uint(int(_S238) + int(32)) % 32U;
    uint _S245 = uint(_S242);
    uint _S246 = _S244 * 8U + _S245;
    uint _S247 = (_S244 + 1U) % 32U * 8U + _S245;
    NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = make_uint4 (_S246, _S246 + 1U, _S247, _S247 + 1U);
    float _S248 = 1.0f - _S239;
    float _S249 = 1.0f - _S243;
    float4  _S250 = make_float4 (_S248 * _S249, _S248 * _S243, _S239 * _S249, _S239 * _S243) * make_float4 (252.0f) + make_float4 (0.5f);
    uint4  _S251 = make_uint4 ((uint)_S250.x, (uint)_S250.y, (uint)_S250.z, (uint)_S250.w);
    (&taps_0)->weights_0 = _S251;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S251.x + _S251.y + _S251.z + _S251.w);
    return taps_0;
}

__device__ float3  half_vector_0(float3  light_4, float3  view_3)
{
    float3  _S252 = light_4 + view_3;
    return _S252 * make_float3 ((F32_rsqrt(((F32_max((square_1(_S252)), (9.999999960041972e-13f)))))));
}

__device__ float3  shadow_correlation_0(float3  light_5, float3  view_4)
{
    float2  _S253 = float2 {light_5.x, light_5.y};
    float2  _S254 = float2 {view_4.x, view_4.y};
    float _S255 = dot_1(_S253, _S254) / (F32_max(((F32_sqrt((dot_1(_S253, _S253) * dot_1(_S254, _S254))))), (9.99999997475242708e-07f)));
    if((light_5.z) < 0.0f)
    {
        return make_float3 (make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S255).x, make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S255).y, 0.0f);
    }
    return make_float3 ((F32_min((0.62000000476837158f + 0.62999999523162842f * _S255), (1.20000004768371582f))), 0.62000000476837158f, 0.37000000476837158f);
}

__device__ float4  bytes_of_sums_0(uint even_0, uint odd_0)
{
    return make_float4 (float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

__device__ float4  interpolate_0(NodeTaps_0 * taps_1, uint4  packs_2)
{
    uint4  _S256 = (packs_2 & make_uint4 (16711935U)) * taps_1->weights_0;
    uint4  _S257 = ((packs_2 >> make_uint4 (int(8))) & make_uint4 (16711935U)) * taps_1->weights_0;
    return bytes_of_sums_0(_S256.x + _S256.y + _S256.z + _S256.w, _S257.x + _S257.y + _S257.z + _S257.w) * make_float4 (taps_1->inverse_sum_0);
}

__device__ float4  interpolate_table_0(NodeTaps_0 * taps_2, uint table_0, uint stride_0)
{
    uint4  _S258 = make_uint4 (table_0) + taps_2->nodes_0 * make_uint4 (stride_0);
    uint _S259 = __ldg((&(globalParams_0->words_0)[_S258.x]));
    uint _S260 = __ldg((&(globalParams_0->words_0)[_S258.y]));
    uint _S261 = __ldg((&(globalParams_0->words_0)[_S258.z]));
    uint _S262 = __ldg((&(globalParams_0->words_0)[_S258.w]));
    float4  _S263 = interpolate_0(taps_2, make_uint4 (_S259, _S260, _S261, _S262));
    return _S263;
}

struct Group_0
{
    float3  normal_5;
    float weight_1;
    float3  tangent_6;
    float3  variance_0;
    float3  covariance_0;
    float roughness_6;
};

__device__ Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    (&group_0)->normal_5 = make_float3 (table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    (&group_0)->weight_1 = table_number_0(row_1 + 3U);
    float3  _S264 = make_float3 (table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    (&group_0)->tangent_6 = _S264;
    float _S265 = table_number_0(row_1 + 7U);
    float _S266 = table_number_0(row_1 + 8U);
    (&group_0)->variance_0 = make_float3 (_S265, _S266, 1.0f - square_1(_S264) - _S265 - _S266);
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
    float _S267 = direction_4.x;
    float _S268 = direction_4.y;
    float _S269 = direction_4.z;
    return (F32_max((dot_0(this_5->variance_0, direction_4 * direction_4) + 2.0f * dot_0(this_5->covariance_0, make_float3 (_S267 * _S268, _S267 * _S269, _S268 * _S269))), (0.0f)));
}

__device__ float mean_area_0(Group_0 * group_1, float3  direction_5)
{
    float _S270 = dot_0(direction_5, group_1->tangent_6);
    float _S271 = _S270 * _S270;
    float _S272 = Group_variance_along_0(group_1, direction_5);
    float _S273 = group_1->roughness_6 * group_1->roughness_6;
    return (F32_sqrt(((F32_max(((_S273 - 1.0f) * (_S271 + _S272) + 1.0f), (_S273))))));
}

__device__ float mean_density_0(Group_0 * group_2, float3  half_0)
{
    float _S274 = group_2->roughness_6;
    float _S275 = (F32_max(((F32_sqrt(((F32_max((1.0f - group_2->roughness_6 * group_2->roughness_6), (0.0f)))))) / group_2->roughness_6), (0.00100000004749745f)));
    float _S276 = Group_variance_along_0(group_2, half_0);
    float _S277 = (F32_max(((F32_sqrt((3.0f * _S276)))), (_S274 * 0.01999999955296516f + 0.00009999999747379f)));
    float _S278 = dot_0(half_0, group_2->tangent_6);
    float _S279 = _S275 * (_S278 - _S277);
    float _S280 = _S275 * (_S278 + _S277);
    float _S281 = _S279 * _S280;
    float _S282 = 2.0f * _S277 * _S275;
    return 0.15915493667125702f / _S274 * ((1.0f - _S281) / ((_S279 * _S279 + 1.0f) * (_S280 * _S280 + 1.0f)) + arc_tangent_0(_S282, 1.0f + _S281) / _S282);
}

__device__ float layer_value_0(Group_0 * group_3, float3  half_1, float3  light_6, float3  view_5, float optical_depth_3)
{
    bool _S283 = (light_6.z) < 0.0f;
    float3  _S284 = group_3->normal_5;
    float _S285 = dot_0(light_6, group_3->normal_5);
    float _S286;
    if(_S283)
    {
        _S286 = - _S285;
    }
    else
    {
        _S286 = _S285;
    }
    float _S287 = (F32_max((_S286), (0.01999999955296516f)));
    float _S288 = (F32_max((dot_0(view_5, _S284)), (0.01999999955296516f)));
    float _S289 = mean_area_0(group_3, light_6);
    float _S290 = _S289 / _S287;
    float _S291 = mean_area_0(group_3, view_5);
    float _S292 = _S291 / _S288;
    if(_S283)
    {
        _S286 = (F32_abs((_S290 - _S292)));
    }
    else
    {
        _S286 = _S290 + _S292;
    }
    float _S293 = optical_depth_3 * (F32_max((_S286), (0.00100000004749745f)));
    if(_S283)
    {
        _S286 = exponential_0(- optical_depth_3 * (F32_min((_S290), (_S292))));
    }
    else
    {
        _S286 = 1.0f;
    }
    float _S294 = optical_depth_3 * _S286 * (1.0f - exponential_0(- _S293)) / _S293 / _S288;
    if(_S283)
    {
        _S286 = 1.0f;
    }
    else
    {
        _S286 = 1.0f - 0.34999999403953552f * (1.0f - square_1(_S284));
    }
    float _S295 = mean_density_0(group_3, half_1);
    return 0.25f * _S295 * _S286 * _S294;
}

struct Bound_0
{
    uint thread_10;
    float turns_2;
    float cell_7;
    float visible_0;
    float width_1;
    float gap_0;
};

__device__ Bound_0 bound_at_0(uint family_9, float position_4)
{
    Cell_0 _S296 = locate_0(family_9, position_4);
    Family_0 _S297 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
    float _S298 = table_number_0(_S297.before_0 + 2U * _S296.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_10 = _S296.thread_0;
    Family_0 _S299 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
    float _S300 = position_4 - _S299.start_0 - _S298 - _S296.below_0;
    Family_0 _S301 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
    (&bound_0)->turns_2 = (F32_round((_S300 * _S301.inverse_period_0)));
    (&bound_0)->cell_7 = _S296.below_0;
    float _S302 = 2.0f * _S296.half_width_1;
    (&bound_0)->width_1 = _S302;
    (&bound_0)->visible_0 = clamp_1((_S296.across_2 + _S296.half_width_1) / _S302, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S296.below_0), (_S296.below_0 - _S296.across_2 - _S296.half_width_1))) + (F32_max((_S296.across_2 - _S296.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

__device__ Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1)
{
    Family_0 _S303 = slang_ldg_2((&(globalParams_0->families_0)[family_10]));
    float _S304 = centre_1 - _S303.start_0;
    Family_0 _S305 = slang_ldg_2((&(globalParams_0->families_0)[family_10]));
    float _S306 = (F32_floor((_S304 * _S305.inverse_period_0)));
    Family_0 _S307 = slang_ldg_2((&(globalParams_0->families_0)[family_10]));
    float _S308 = centre_1 - _S306 * _S307.period_0;
    Family_0 _S309 = slang_ldg_2((&(globalParams_0->families_0)[family_10]));
    float _S310 = 0.5f * (F32_max((size_1), (_S309.smallest_box_0)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_0 = bound_at_0(family_10, _S308 - _S310);
    (&stretch_0)->high_0 = bound_at_0(family_10, _S308 + _S310);
    return stretch_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

__device__ float3  lengths_0(uint family_11, Stretch_0 * stretch_1)
{
    float _S311 = Stretch_turns_0(stretch_1);
    Family_0 _S312 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    uint _S313 = _S312.before_0 + 2U * (&stretch_1->low_0)->thread_10;
    Family_0 _S314 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    uint _S315 = _S314.before_0 + 2U * (&stretch_1->high_0)->thread_10;
    float _S316 = table_number_0(_S315) - table_number_0(_S313);
    float _S317 = table_number_0(_S315 + 1U) - table_number_0(_S313 + 1U);
    float _S318 = _S316 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_1 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_1;
    Family_0 _S319 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    float _S320 = _S318 + _S311 * _S319.visible_total_0;
    float _S321 = _S317 - _S316 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0;
    Family_0 _S322 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    Family_0 _S323 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    float _S324 = _S321 + _S311 * (_S322.period_0 - _S323.visible_total_0);
    float _S325 = _S317 + (&stretch_1->high_0)->cell_7 - (&stretch_1->low_0)->cell_7;
    Family_0 _S326 = slang_ldg_2((&(globalParams_0->families_0)[family_11]));
    return make_float3 (_S320, _S324, _S325 + _S311 * _S326.period_0);
}

__device__ float2  integrals_along_0(uint family_12, Stretch_0 * stretch_2, uint quantity_0)
{
    Family_0 _S327 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    Family_0 _S328 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    uint _S329 = 3U * _S327.quantities_0;
    uint _S330 = _S328.colour_threads_0 + _S329 * (&stretch_2->low_0)->thread_10 + quantity_0;
    Family_0 _S331 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    uint _S332 = _S331.colour_threads_0 + _S329 * (&stretch_2->high_0)->thread_10 + quantity_0;
    Family_0 _S333 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    Family_0 _S334 = slang_ldg_2((&(globalParams_0->families_0)[family_12]));
    uint _S335 = _S333.colour_threads_0 + _S329 * uint(_S334.count_0) + quantity_0;
    float _S336 = table_number_0(_S330);
    float _S337 = table_number_0(_S332);
    float _S338 = Stretch_turns_0(stretch_2);
    uint _S339 = 2U * _S327.quantities_0;
    return make_float2 (table_number_0(_S332 + _S327.quantities_0) - table_number_0(_S330 + _S327.quantities_0) + _S337 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_1 - _S336 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_1 + _S338 * table_number_0(_S335 + _S327.quantities_0), table_number_0(_S332 + _S339) - table_number_0(_S330 + _S339) + _S337 * (&stretch_2->high_0)->cell_7 - _S336 * (&stretch_2->low_0)->cell_7 + _S338 * table_number_0(_S335 + _S339));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_7)
{
    return ((&this_7->high_0)->thread_10) < ((&this_7->low_0)->thread_10);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_8, uint4  entries_0, uint whole_0)
{
    uint _S340 = entries_0.z;
    uint _S341 = entries_0.x;
    uint _S342 = _S340 - _S341;
    bool _S343 = Stretch_wraps_0(this_8);
    uint _S344;
    if(_S343)
    {
        _S344 = whole_0;
    }
    else
    {
        _S344 = 0U;
    }
    return make_uint4 (_S342 + _S344, entries_0.w - _S340, entries_0.y - _S341, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_4, uint row_2, uint count_2, uint quantities_1)
{
    uint _S345 = row_2 + (&across_4->low_0)->thread_10 * quantities_1;
    uint _S346 = row_2 + (&across_4->high_0)->thread_10 * quantities_1;
    uint _S347 = __ldg((&(globalParams_0->words_0)[_S345]));
    uint _S348 = __ldg((&(globalParams_0->words_0)[_S345 + quantities_1]));
    uint _S349 = __ldg((&(globalParams_0->words_0)[_S346]));
    uint _S350 = __ldg((&(globalParams_0->words_0)[_S346 + quantities_1]));
    uint4  _S351 = make_uint4 (_S347, _S348, _S349, _S350);
    uint _S352 = __ldg((&(globalParams_0->words_0)[row_2 + count_2 * quantities_1]));
    uint4  _S353 = Stretch_differences_0(across_4, _S351, _S352);
    return _S353;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_9)
{
    float _S354 = (&this_9->high_0)->visible_0;
    float _S355 = - (&this_9->low_0)->visible_0;
    float _S356 = Stretch_turns_0(this_9);
    bool _S357 = Stretch_wraps_0(this_9);
    float _S358;
    if(_S357)
    {
        _S358 = 1.0f;
    }
    else
    {
        _S358 = 0.0f;
    }
    return make_float4 (1.0f, _S354, _S355, _S356 - _S358);
}

__device__ float integral_on_top_0(uint family_13, Stretch_0 * across_5, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    Family_0 _S359 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint _S360 = uint(_S359.count_0);
    uint _S361 = _S360 + 1U;
    Family_0 _S362 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint _S363 = _S361 * _S362.quantities_0;
    Family_0 _S364 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint _S365 = _S364.colour_areas_0 + quantity_1;
    uint _S366 = (&along_0->low_0)->thread_10;
    uint _S367 = _S365 + (&along_0->low_0)->thread_10 * _S363;
    Family_0 _S368 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S369 = row_differences_0(across_5, _S367, _S360, _S368.quantities_0);
    uint _S370 = _S365 + (_S366 + 1U) * _S363;
    Family_0 _S371 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S372 = row_differences_0(across_5, _S370, _S360, _S371.quantities_0);
    uint _S373 = (&along_0->high_0)->thread_10;
    uint _S374 = _S365 + (&along_0->high_0)->thread_10 * _S363;
    Family_0 _S375 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S376 = row_differences_0(across_5, _S374, _S360, _S375.quantities_0);
    uint _S377 = _S365 + (_S373 + 1U) * _S363;
    Family_0 _S378 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S379 = row_differences_0(across_5, _S377, _S360, _S378.quantities_0);
    uint _S380 = _S365 + crossing_count_0 * _S363;
    Family_0 _S381 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    uint4  _S382 = row_differences_0(across_5, _S380, _S360, _S381.quantities_0);
    uint4  _S383 = _S376 - _S369;
    bool _S384 = Stretch_wraps_0(along_0);
    uint4  _S385;
    if(_S384)
    {
        _S385 = _S382;
    }
    else
    {
        int4  _S386 = make_int4 (int(0));
        uint4  _S387 = make_uint4 ((uint)_S386.x, (uint)_S386.y, (uint)_S386.z, (uint)_S386.w);
        _S385 = _S387;
    }
    uint4  _S388 = _S383 + _S385;
    float4  _S389 = Stretch_weights_0(across_5);
    float4  _S390 = Stretch_weights_0(along_0);
    int4  _S391 = make_int4 ((int)_S388.x, (int)_S388.y, (int)_S388.z, (int)_S388.w);
    float4  _S392 = make_float4 ((float)_S391.x, (float)_S391.y, (float)_S391.z, (float)_S391.w);
    uint4  _S393 = _S379 - _S376;
    int4  _S394 = make_int4 ((int)_S393.x, (int)_S393.y, (int)_S393.z, (int)_S393.w);
    float4  _S395 = make_float4 ((float)_S394.x, (float)_S394.y, (float)_S394.z, (float)_S394.w);
    uint4  _S396 = _S372 - _S369;
    int4  _S397 = make_int4 ((int)_S396.x, (int)_S396.y, (int)_S396.z, (int)_S396.w);
    float4  _S398 = make_float4 ((float)_S397.x, (float)_S397.y, (float)_S397.z, (float)_S397.w);
    int4  _S399 = make_int4 ((int)_S382.x, (int)_S382.y, (int)_S382.z, (int)_S382.w);
    float4  _S400 = make_float4 ((float)_S399.x, (float)_S399.y, (float)_S399.z, (float)_S399.w);
    float _S401 = dot_2(make_float4 (dot_2(_S392, _S389), dot_2(_S395, _S389), dot_2(_S398, _S389), dot_2(_S400, _S389)), _S390);
    Family_0 _S402 = slang_ldg_2((&(globalParams_0->families_0)[family_13]));
    return _S401 * _S402.area_unit_0;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_2, uint row_3)
{
    Albedos_0 _S403 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_2) * _S403.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_2) * _S403.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_2) * _S403.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_2) * _S403.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, Stretch_0 * own_1, Stretch_0 * other_2, bool back_3)
{
    Family_0 _S404 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
    Albedos_0 albedos_2 = table_albedos_0(_S404.colour_mean_0);
    Family_0 _S405 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
    if((_S405.quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3  _S406 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_3 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        Family_0 _S407 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
        if(quantity_2 < (_S407.quantities_0))
        {
        }
        else
        {
            break;
        }
        float2  _S408 = integrals_along_0(family_14, own_1, quantity_2);
        Family_0 _S409 = slang_ldg_2((&(globalParams_0->families_0)[crossing_1]));
        float _S410 = integral_on_top_0(family_14, own_1, other_2, uint(_S409.count_0), quantity_2);
        float _S411 = _S408.x;
        float _S412 = _S411 * _S406.x;
        float _S413;
        if(back_3)
        {
            _S413 = _S412 - _S410;
        }
        else
        {
            _S413 = _S410;
        }
        bool _S414 = quantity_2 == 0U;
        if(_S414)
        {
            Family_0 _S415 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
            float _S416 = 16.0f * _S415.area_unit_0;
            Family_0 _S417 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
            is_exposed_0 = _S413 > (_S416 * (F32_min((_S412 / _S417.crossing_area_0), (1.0f))) + 0.00000999999974738f * _S412);
        }
        float _S418 = _S411 * _S406.y;
        float _S419;
        if(is_exposed_0)
        {
            _S419 = _S413;
        }
        else
        {
            _S419 = 0.0f;
        }
        float _S420 = _S418 + _S419 + 0.000244140625f * _S406.z * _S408.y;
        if(_S414)
        {
            weight_3 = 1.0f / (F32_max((_S420), (9.99999968265522539e-21f)));
        }
        else
        {
            float _S421 = _S420 * weight_3;
            Family_0 _S422 = slang_ldg_2((&(globalParams_0->families_0)[family_14]));
            uint _S423 = _S422.colour_axes_0 + 12U * (quantity_2 - 1U);
            Albedos_0 _S424 = albedos_2;
            Albedos_0 _S425 = with_added_albedos_0(&_S424, _S421, _S423);
            albedos_2 = _S425;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate_0((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate_0((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate_0((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate_0((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

__device__ Albedos_0 lerp_albedos_0(Albedos_0 * first_2, Albedos_0 * second_1, float weight_4)
{
    Albedos_0 albedos_3;
    float3  _S426 = make_float3 (weight_4);
    (&albedos_3)->diffuse_reflect_0 = lerp_0(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S426);
    (&albedos_3)->diffuse_transmit_0 = lerp_0(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S426);
    (&albedos_3)->specular_reflect_0 = lerp_0(first_2->specular_reflect_0, second_1->specular_reflect_0, _S426);
    (&albedos_3)->specular_transmit_0 = lerp_0(first_2->specular_transmit_0, second_1->specular_transmit_0, _S426);
    return albedos_3;
}

__device__ float sheen_scale_0(float x_26, float y_14)
{
    return (((((0.0f * x_26 + (((((-1.1402510404586792f * y_14 + 0.40672621130943298f) * y_14 + 1.65398800373077393f) * y_14 + -1.29730904102325439f) * y_14 + 0.30570998787879944f) * y_14 + -0.0220868494361639f)) * x_26 + (((((-0.21142719686031342f * y_14 + 1.05947399139404297f) * y_14 + -0.41116121411323547f) * y_14 + -0.93859231472015381f) * y_14 + 0.51606941223144531f) * y_14 + 0.05409301072359085f)) * x_26 + (((((1.22944498062133789f * y_14 + -0.45962560176849365f) * y_14 + -1.63861405849456787f) * y_14 + 1.33565104007720947f) * y_14 + -0.45725581049919128f) * y_14 + 0.08243165910243988f)) * x_26 + (((((0.39779931306838989f * y_14 + -1.18879103660583496f) * y_14 + 0.28251591324806213f) * y_14 + 1.168984055519104f) * y_14 + -0.76864629983901978f) * y_14 + 0.0091691892594099f)) * x_26 + (((((-0.26563560962677002f * y_14 + -0.19379159808158875f) * y_14 + 0.2677634060382843f) * y_14 + 0.00270519289188087f) * y_14 + 0.14349560439586639f) * y_14 + 0.10290180146694183f)) * x_26 + (((((-0.20701569318771362f * y_14 + 0.24526430666446686f) * y_14 + 0.19551840424537659f) * y_14 + 0.07586126774549484f) * y_14 + 0.38894739747047424f) * y_14 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_27, float y_15)
{
    return ((((0.0f * x_27 + (((((-0.10608240216970444f * y_15 + 1.99214303493499756f) * y_15 + -1.42255294322967529f) * y_15 + -1.09495604038238525f) * y_15 + 0.59180057048797607f) * y_15 + 0.06902855634689331f)) * x_27 + (((((-0.46220690011978149f * y_15 + -0.29113379120826721f) * y_15 + 1.39025199413299561f) * y_15 + 0.35589990019798279f) * y_15 + -1.17120099067687988f) * y_15 + 0.15940259397029877f)) * x_27 + (((((2.26068711280822754f * y_15 + -3.64728999137878418f) * y_15 + -0.72173482179641724f) * y_15 + 3.07659196853637695f) * y_15 + -0.6827620267868042f) * y_15 + -0.3039557933807373f)) * x_27 + (((((0.81201767921447754f * y_15 + 0.36014080047607422f) * y_15 + -1.72646903991699219f) * y_15 + -0.22630110383033752f) * y_15 + 0.89514690637588501f) * y_15 + -0.10397960245609283f)) * x_27 + (((((-0.37648698687553406f * y_15 + 1.10974001884460449f) * y_15 + 0.17824520170688629f) * y_15 + -1.04968702793121338f) * y_15 + 0.1461234986782074f) * y_15 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_28, float y_16)
{
    return ((((0.0f * x_28 + (((((12.95646953582763672f * y_16 + -21.38032913208007812f) * y_16 + -7.37853097915649414f) * y_16 + 34.55607986450195312f) * y_16 + -23.61347007751464844f) * y_16 + 5.00126314163208008f)) * x_28 + (((((10.91487026214599609f * y_16 + -6.08202791213989258f) * y_16 + -38.2036285400390625f) * y_16 + 53.3440399169921875f) * y_16 + -21.91996002197265625f) * y_16 + 2.01606011390686035f)) * x_28 + (((((-14.52206039428710938f * y_16 + 36.803619384765625f) * y_16 + -22.94047927856445312f) * y_16 + -10.07973003387451172f) * y_16 + 15.77003955841064453f) * y_16 + -4.92722177505493164f)) * x_28 + (((((-7.62505722045898438f * y_16 + 1.27310299873352051f) * y_16 + 31.19523048400878906f) * y_16 + -44.39989852905273438f) * y_16 + 26.44947052001953125f) * y_16 + -8.73507976531982422f)) * x_28 + (((((5.65633487701416016f * y_16 + -17.66820907592773438f) * y_16 + 24.65356063842773438f) * y_16 + -19.38941001892089844f) * y_16 + 11.06159019470214844f) * y_16 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S427 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S428 = 2.0f * (F32_sqrt((_S427))) - 1.0f;
    float _S429 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_8, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S428, _S429), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S427) * sheen_shear_0(_S428, _S429), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S428, _S429), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_7, float3  view_6, float scale_0, float shear_0)
{
    float _S430 = light_7.z;
    bool _S431;
    if(_S430 <= 0.0f)
    {
        _S431 = true;
    }
    else
    {
        _S431 = (view_6.z) <= 0.0f;
    }
    if(_S431)
    {
        return 0.0f;
    }
    float2  _S432 = float2 {view_6.x, view_6.y};
    float _S433 = dot_1(_S432, _S432);
    float2  _S434;
    if(_S433 > 9.99999968265522539e-21f)
    {
        _S434 = _S432 * make_float2 ((F32_rsqrt((_S433))));
    }
    else
    {
        _S434 = make_float2 (1.0f, 0.0f);
    }
    float _S435 = scale_0 * dot_1(float2 {light_7.x, light_7.y}, _S434) + shear_0 * _S430;
    float _S436 = scale_0 * (light_7.y * _S434.x - light_7.x * _S434.y);
    float _S437 = _S435 * _S435 + _S436 * _S436 + _S430 * _S430;
    return 0.31830987334251404f * scale_0 * scale_0 * _S430 / (F32_max((_S437 * _S437), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_8, float3  view_7, float strength_0, float roughness_9)
{
    float3  _S438 = sheen_lobe_0(view_7.z, roughness_9);
    float _S439 = strength_0 * _S438.z;
    return make_float2 (_S439 * transformed_cosine_0(light_8, view_7, _S438.x, _S438.y), 1.0f - _S439);
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_2;
    Albedos_0 weft_2;
};

struct Estimate_0
{
    Components_0 components_0;
    FamilyAlbedos_0 albedos_4;
};

struct Regime_0
{
    float prefiltered_0;
    float threads_1;
    float points_1;
};

__device__ Regime_0 regime_of_0(uint _S440, Footprint_0 * _S441, float _S442)
{
    Fabric_0 * _S443 = (&(globalParams_0->fabrics_0)[_S440]);
    float _S444 = Footprint_spread_side_0(_S441);
    float _S445 = binary_logarithm_0((F32_max((_S444), (9.99999971718068537e-10f))));
    Lobes_0 _S446 = slang_ldg_1(&_S443->lobes_0);
    float _S447 = clamp_1((_S445 - _S446.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S448 = _S447 * _S447 * (3.0f - 2.0f * _S447);
    (&regime_0)->prefiltered_0 = _S448;
    (&regime_0)->threads_1 = _S444 * _S446.threads_per_mm_0;
    float _S449 = lerp_1((F32_max((8.0f / _S442), (1.0f))), 1.0f, _S448);
    float _S450;
    if(_S448 < 1.0f)
    {
        _S450 = clamp_1((&regime_0)->threads_1 * 12.0f, 1.0f, _S449);
    }
    else
    {
        _S450 = 0.0f;
    }
    (&regime_0)->points_1 = _S450;
    return regime_0;
}

struct Hit_0
{
    float x_29;
    float y_17;
    bool hole_5;
    float height_5;
};

struct Sample_0
{
    Crossing_0 crossing_2;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_6;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

__device__ Crossing_0 crossing_at_0(uint _S451, float _S452, float _S453, bool _S454)
{
    Fabric_0 * _S455 = (&(globalParams_0->fabrics_0)[_S451]);
    Crossing_0 crossing_3;
    uint _S456 = __ldg(&_S455->warp_0);
    (&crossing_3)->warp_1 = locate_0(_S456, _S452);
    uint _S457 = __ldg(&_S455->weft_0);
    (&crossing_3)->weft_1 = locate_0(_S457, _S453);
    uint _S458 = __ldg(&_S455->run_words_0);
    uint _S459 = (&(&crossing_3)->weft_1)->thread_0;
    uint _S460 = __ldg(&_S455->ends_1);
    uint _S461 = _S458 + 2U * (_S459 * _S460 + (&(&crossing_3)->warp_1)->thread_0);
    uint _S462 = __ldg((&(globalParams_0->words_0)[_S461]));
    (&crossing_3)->warp_word_0 = _S462;
    uint _S463 = __ldg((&(globalParams_0->words_0)[_S461 + 1U]));
    (&crossing_3)->weft_word_0 = _S463;
    (&crossing_3)->warp_above_0 = ((_S462 & 1U) == 1U) != _S454;
    return crossing_3;
}

__device__ Sample_0 sample_at_0(uint _S464, float _S465, float _S466, bool _S467)
{
    Fabric_0 * _S468 = (&(globalParams_0->fabrics_0)[_S464]);
    Sample_0 sample_0;
    Crossing_0 _S469 = crossing_at_0(_S464, _S465, _S466, _S467);
    (&sample_0)->crossing_2 = _S469;
    Crossing_0 _S470 = _S469;
    Shown_0 _S471 = shown_at_0(&_S470, _S467);
    (&sample_0)->shown_3 = _S471;
    uint _S472;
    if(_S471.is_warp_2)
    {
        uint _S473 = __ldg(&_S468->warp_0);
        _S472 = _S473;
    }
    else
    {
        uint _S474 = __ldg(&_S468->weft_0);
        _S472 = _S474;
    }
    uint _S475;
    if(_S471.is_warp_2)
    {
        uint _S476 = __ldg(&_S468->weft_0);
        _S475 = _S476;
    }
    else
    {
        uint _S477 = __ldg(&_S468->warp_0);
        _S475 = _S477;
    }
    Cell_0 _S478 = (&(&sample_0)->crossing_2)->warp_1;
    Cell_0 _S479 = (&(&sample_0)->crossing_2)->weft_1;
    Cell_0 _S480 = select_cell_0(_S471.is_warp_2, &_S478, &_S479);
    Cell_0 _S481 = (&(&sample_0)->crossing_2)->weft_1;
    Cell_0 _S482 = (&(&sample_0)->crossing_2)->warp_1;
    Cell_0 _S483 = select_cell_0(_S471.is_warp_2, &_S481, &_S482);
    Cell_0 _S484 = _S483;
    Run_0 _S485 = unpack_0(_S472, _S475, _S480.thread_0, &_S484, _S471.word_0);
    Cell_0 _S486 = _S480;
    Section_0 _S487 = section_at_0(&_S486);
    bool _S488;
    if(_S471.on_top_0)
    {
        _S488 = (_S485.distance_0) < (_S487.drop_0 * _S485.bend_1.sine_0);
    }
    else
    {
        _S488 = false;
    }
    bool _S489;
    if(_S471.on_top_0)
    {
        _S489 = !_S488;
    }
    else
    {
        _S489 = false;
    }
    float _S490;
    if(_S489)
    {
        _S490 = 1.0f;
    }
    else
    {
        _S490 = -1.0f;
    }
    float _S491;
    if(_S488)
    {
        _S491 = _S485.other_reach_0;
    }
    else
    {
        _S491 = _S485.reach_0;
    }
    float _S492;
    if(_S488)
    {
        _S492 = _S491 + _S485.distance_0;
    }
    else
    {
        _S492 = (F32_max((_S491 - _S485.distance_0), (0.0f)));
    }
    float _S493 = _S491 / _S485.bend_1.sine_0 - _S490 * _S487.drop_0;
    float _S494 = _S492 * _S492;
    float _S495 = (F32_max((_S493 * _S493 - _S494), (9.99999968265522539e-21f)));
    float _S496 = (F32_rsqrt((_S495)));
    float _S497 = _S494 / (_S495 * _S496 + _S493);
    bool _S498 = _S492 > 0.0f;
    float _S499;
    if(_S471.on_top_0)
    {
        _S499 = 1.0f;
    }
    else
    {
        _S499 = -1.0f;
    }
    float _S500;
    if(_S485.near_start_0)
    {
        _S500 = 1.0f;
    }
    else
    {
        _S500 = -1.0f;
    }
    float _S501 = _S499 * _S500;
    if(_S498)
    {
        _S499 = _S493 * _S496;
    }
    else
    {
        _S499 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S487.slope_0 * _S499;
    if(_S498)
    {
        _S492 = _S501 * _S492 * _S496;
    }
    else
    {
        _S492 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S492;
    Family_0 _S502 = slang_ldg_2((&(globalParams_0->families_0)[_S472]));
    Shown_0 _S503 = _S471;
    Run_0 _S504 = _S485;
    Cell_0 _S505 = _S483;
    float2  _S506 = dive_0(_S475, &_S503, &_S504, &_S505);
    if(_S485.straight_0)
    {
        _S490 = 0.0f;
    }
    else
    {
        _S490 = _S502.height_scale_0 * _S490;
    }
    (&sample_0)->height_6 = _S490 * (_S491 * _S485.bend_1.half_tangent_0 - _S497) - _S502.height_scale_0 * _S487.drop_0 - _S506.x;
    float _S507 = _S502.height_scale_0 * (&sample_0)->slope_across_0;
    float _S508 = _S502.height_scale_0 * (&sample_0)->slope_along_0 - _S506.y;
    if(_S471.is_warp_2)
    {
        _S490 = _S507;
    }
    else
    {
        _S490 = _S508;
    }
    (&sample_0)->slope_x_1 = _S490;
    if(_S471.is_warp_2)
    {
        _S490 = _S508;
    }
    else
    {
        _S490 = _S507;
    }
    (&sample_0)->slope_y_1 = _S490;
    (&sample_0)->run_3 = _S485;
    (&sample_0)->section_1 = _S487;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S509, SearchQuality_0 * _S510, float3  _S511)
{
    Fabric_0 * _S512 = (&(globalParams_0->fabrics_0)[_S509]);
    float _S513 = (F32_abs((_S511.x)));
    float _S514 = __ldg(&_S512->threads_per_x_0);
    float _S515 = _S513 * _S514;
    float _S516 = (F32_abs((_S511.y)));
    float _S517 = __ldg(&_S512->threads_per_y_0);
    float _S518 = (F32_max((_S515), (_S516 * _S517))) * _S510->steps_per_thread_0;
    float _S519 = (F32_abs((_S511.z)));
    float _S520 = __ldg(&_S512->per_relief_0);
    return (F32_max((_S518), (_S519 * _S520 * _S510->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S521, Crossing_0 * _S522)
{
    Fabric_0 * _S523 = (&(globalParams_0->fabrics_0)[_S521]);
    bool _S524 = _S522->warp_above_0;
    uint _S525;
    if(_S522->warp_above_0)
    {
        uint _S526 = __ldg(&_S523->warp_0);
        _S525 = _S526;
    }
    else
    {
        uint _S527 = __ldg(&_S523->weft_0);
        _S525 = _S527;
    }
    uint _S528;
    if(_S524)
    {
        _S528 = _S522->warp_word_0;
    }
    else
    {
        _S528 = _S522->weft_word_0;
    }
    float _S529 = float(_S528 >> int(28));
    Family_0 _S530 = slang_ldg_2((&(globalParams_0->families_0)[_S525]));
    float _S531 = _S529 * _S530.height_scale_0;
    Family_0 _S532 = slang_ldg_2((&(globalParams_0->families_0)[_S525]));
    return _S531 * _S532.level_0;
}

__device__ Probe_0 probe_0(uint _S533, float _S534, float _S535, bool _S536, bool _S537, bool _S538)
{
    Sample_0 _S539 = sample_at_0(_S533, _S534, _S535, _S536);
    Probe_0 probe_1;
    (&probe_1)->height_3 = _S539.height_6;
    (&probe_1)->hole_4 = _S539.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S539.slope_x_1;
    (&probe_1)->slope_y_0 = _S539.slope_y_1;
    uint _S540;
    if(_S539.shown_3.is_warp_2)
    {
        _S540 = _S539.crossing_2.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S540 = _S539.crossing_2.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S540;
    Crossing_0 _S541 = _S539.crossing_2;
    float _S542 = cell_maximum_0(_S533, &_S541);
    (&probe_1)->cell_max_0 = _S542;
    float _S543;
    if(_S537)
    {
        _S543 = _S539.crossing_2.warp_1.above_0;
    }
    else
    {
        _S543 = _S539.crossing_2.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S543;
    if(_S538)
    {
        _S543 = _S539.crossing_2.weft_1.above_0;
    }
    else
    {
        _S543 = _S539.crossing_2.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S543;
    bool _S544 = !_S539.shown_3.is_warp_2;
    Cell_0 _S545 = _S539.crossing_2.warp_1;
    Shown_0 _S546 = _S539.shown_3;
    Run_0 _S547 = _S539.run_3;
    float _S548 = outline_distance_0(&_S545, &_S546, &_S547, _S544, _S537);
    (&probe_1)->edge_x_0 = _S548;
    Cell_0 _S549 = _S539.crossing_2.weft_1;
    Shown_0 _S550 = _S539.shown_3;
    Run_0 _S551 = _S539.run_3;
    float _S552 = outline_distance_0(&_S549, &_S550, &_S551, _S539.shown_3.is_warp_2, _S538);
    (&probe_1)->edge_y_0 = _S552;
    return probe_1;
}

__device__ bool is_free_0(uint _S553, SearchQuality_0 * _S554, float3  _S555, float3  _S556, bool _S557, float _S558)
{
    float _S559 = _S556.z;
    if(_S559 <= 0.0f)
    {
        return false;
    }
    float _S560 = _S554->shadow_share_0;
    float _S561 = steps_per_length_0(_S553, _S554, _S556);
    float _S562 = 1.0f / (F32_max((_S560 * _S561), (9.99999971718068537e-10f)));
    StepControl_0 _S563 = step_control_0(float2 {_S556.x, _S556.y}, _S562);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S564;
        if(count_3 < 1024U)
        {
            _S564 = (_S555.z + _S559 * distance_1) < _S558;
        }
        else
        {
            _S564 = false;
        }
        if(_S564)
        {
        }
        else
        {
            break;
        }
        float3  _S565 = _S555 + _S556 * make_float3 (distance_1);
        Probe_0 _S566 = probe_0(_S553, _S565.x, _S565.y, _S557, _S563.right_0, _S563.up_0);
        float _S567 = _S565.z;
        float _S568 = _S567 - _S566.height_3;
        float _S569 = _S559 - _S566.slope_x_0 * _S556.x - _S566.slope_y_0 * _S556.y;
        bool _S570;
        if(!_S566.hole_4)
        {
            _S570 = _S568 < 0.0f;
        }
        else
        {
            _S570 = false;
        }
        if(_S570)
        {
            return false;
        }
        PreviousSample_0 _S571 = previous_3;
        Probe_0 _S572 = _S566;
        float _S573 = way_back_to_dip_0(&_S571, _S568, _S569, last_step_0, &_S572);
        if(_S573 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S573;
            distance_1 = distance_1 - _S573;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S574 = _S567 > (_S566.cell_max_0);
        Probe_0 _S575 = _S566;
        PreviousSample_0 _S576 = after_sample_0(_S568, _S569, &_S575, _S574);
        float last_step_2;
        if(_S574)
        {
            StepControl_0 _S577 = _S563;
            float _S578 = StepControl_to_cell_exit_0(&_S577, _S566.side_x_0, _S566.side_y_0);
            last_step_2 = (F32_max((_S578), (_S562)));
        }
        else
        {
            StepControl_0 _S579 = _S563;
            Probe_0 _S580 = _S566;
            float _S581 = StepControl_to_next_sample_0(&_S579, &_S580, _S568, _S569);
            last_step_2 = _S581;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S576;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S582, SearchQuality_0 * _S583, float _S584, float _S585, float3  _S586, bool _S587)
{
    Fabric_0 * _S588 = (&(globalParams_0->fabrics_0)[_S582]);
    Sample_0 _S589 = sample_at_0(_S582, _S584, _S585, _S587);
    if(!_S589.shown_3.hole_3)
    {
        return false;
    }
    float3  _S590 = make_float3 (_S584, _S585, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S591;
        if(side_0 < 2U)
        {
            _S591 = passes_0;
        }
        else
        {
            _S591 = false;
        }
        if(_S591)
        {
        }
        else
        {
            break;
        }
        float3  _S592;
        if(side_0 == 0U)
        {
            _S592 = _S586;
        }
        else
        {
            _S592 = make_float3 (- _S586.x, - _S586.y, _S586.z);
        }
        bool _S593 = _S587 != (side_0 == 1U);
        float _S594 = __ldg(&_S588->height_high_0);
        bool _S595 = is_free_0(_S582, _S583, _S590, _S592, _S593, _S594);
        uint _S596 = side_0 + 1U;
        passes_0 = _S595;
        side_0 = _S596;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_7;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

__device__ float max_height_along_0(uint _S597, float _S598, float _S599, float _S600, float3  _S601, bool _S602)
{
    Fabric_0 * _S603 = (&(globalParams_0->fabrics_0)[_S597]);
    uint _S604 = __ldg(&_S603->warp_0);
    uint _S605 = locate_0(_S604, _S598).thread_0 / 2U;
    uint _S606 = __ldg(&_S603->weft_0);
    uint _S607 = locate_0(_S606, _S599).thread_0 / 2U;
    float _S608 = _S601.x;
    uint _S609;
    if(_S608 > 0.0f)
    {
        _S609 = 1U;
    }
    else
    {
        _S609 = 0U;
    }
    float _S610 = _S601.y;
    uint _S611;
    if(_S610 > 0.0f)
    {
        _S611 = 2U;
    }
    else
    {
        _S611 = 0U;
    }
    uint _S612 = _S609 + _S611;
    uint _S613 = __ldg(&_S603->max_heights_0);
    uint _S614 = __ldg(&_S603->max_height_columns_0);
    uint _S615 = __ldg((&(globalParams_0->words_0)[_S613 + 4U * (_S607 * _S614 + _S605) + _S612]));
    int number_0;
    if(_S602)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S616 = _S615 >> number_0;
    float _S617 = (F32_abs((_S608)));
    float _S618 = __ldg(&_S603->threads_per_x_0);
    float _S619 = _S617 * _S618;
    float _S620 = (F32_abs((_S610)));
    float _S621 = __ldg(&_S603->threads_per_y_0);
    float _S622 = (F32_max((_S619), (_S620 * _S621))) / _S601.z;
    float _S623 = __ldg(&_S603->height_high_0);
    float max_height_0 = _S623;
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
        if(((max_height_0 - _S600) * _S622) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S616 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S623)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S624, float _S625, float _S626, bool _S627, bool _S628, bool _S629)
{
    Crossing_0 _S630 = crossing_at_0(_S624, _S625, _S626, _S627);
    Crossing_0 _S631 = _S630;
    float _S632 = cell_maximum_0(_S624, &_S631);
    float _S633;
    if(_S628)
    {
        _S633 = _S630.warp_1.above_0;
    }
    else
    {
        _S633 = _S630.warp_1.below_0;
    }
    float _S634;
    if(_S629)
    {
        _S634 = _S630.weft_1.above_0;
    }
    else
    {
        _S634 = _S630.weft_1.below_0;
    }
    return make_float3 (_S632, _S633, _S634);
}

__device__ float first_sample_height_0(uint _S635, ViewRay_0 * _S636, StepControl_0 * _S637, bool _S638)
{
    float _S639 = max_height_along_0(_S635, _S636->origin_0.x, _S636->origin_0.y, 0.0f, make_float3 (_S636->slope_1.x, _S636->slope_1.y, 1.0f), _S638);
    uint count_4 = 0U;
    float height_8 = _S639;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S640 = ViewRay_at_0(_S636, height_8);
        float3  _S641 = cell_bounds_0(_S635, _S640.x, _S640.y, _S638, _S637->right_0, _S637->up_0);
        float _S642 = height_8 - _S641.x;
        float _S643 = StepControl_to_cell_exit_0(_S637, _S641.y, _S641.z);
        float height_9 = height_8 - clamp_1(_S642, 0.0f, _S643);
        if(_S642 <= _S643)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

__device__ ViewRayEnd_0 search_down_0(uint _S644, ViewRay_0 * _S645, StepControl_0 * _S646, bool _S647)
{
    Fabric_0 * _S648 = (&(globalParams_0->fabrics_0)[_S644]);
    float _S649 = __ldg(&_S648->height_low_0);
    float _S650 = __ldg(&_S648->height_high_0);
    float _S651 = _S649 - (_S650 - _S649);
    ViewRayEnd_0 end_1;
    float _S652 = first_sample_height_0(_S644, _S645, _S646, _S647);
    (&end_1)->height_7 = _S652;
    (&end_1)->last_step_3 = _S646->epsilon_0;
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
        float2  _S653 = ViewRay_at_0(_S645, (&end_1)->height_7);
        Probe_0 _S654 = probe_0(_S644, _S653.x, _S653.y, _S647, _S646->right_0, _S646->up_0);
        float _S655 = (&end_1)->height_7 - _S654.height_3;
        Probe_0 _S656 = _S654;
        float _S657 = ViewRay_rate_0(_S645, &_S656);
        (&end_1)->depth_1 = - _S655;
        (&end_1)->rate_4 = _S657;
        bool _S658;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S658 = !_S654.hole_4;
        }
        else
        {
            _S658 = false;
        }
        bool _S659;
        if(_S658)
        {
            _S659 = ((&(&end_1)->previous_4)->yarn_0) == (_S654.yarn_1);
        }
        else
        {
            _S659 = false;
        }
        (&end_1)->smooth_0 = _S659;
        bool _S660;
        if(!_S654.hole_4)
        {
            _S660 = _S655 <= 0.0f;
        }
        else
        {
            _S660 = false;
        }
        bool _S661;
        if(_S660)
        {
            _S661 = true;
        }
        else
        {
            _S661 = ((&end_1)->height_7) <= _S651;
        }
        if(_S661)
        {
            break;
        }
        PreviousSample_0 _S662 = (&end_1)->previous_4;
        Probe_0 _S663 = _S654;
        float _S664 = way_back_to_dip_0(&_S662, _S655, _S657, (&end_1)->last_step_3, &_S663);
        if(_S664 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S664;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S664;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S665 = StepControl_to_cell_exit_0(_S646, _S654.side_x_0, _S654.side_y_0);
        float _S666 = (F32_min((_S665), ((&end_1)->height_7 - _S654.cell_max_0)));
        Probe_0 _S667 = _S654;
        float _S668 = StepControl_to_next_sample_0(_S646, &_S667, _S655, _S657);
        bool _S669 = _S666 > _S668;
        Probe_0 _S670 = _S654;
        PreviousSample_0 _S671 = after_sample_0(_S655, _S657, &_S670, _S669);
        (&end_1)->previous_4 = _S671;
        float _S672 = (F32_max((_S666), (_S668)));
        (&end_1)->last_step_3 = _S672;
        (&end_1)->height_7 = (&end_1)->height_7 - _S672;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S673, ViewRay_0 * _S674, StepControl_0 * _S675, bool _S676, ViewRayEnd_0 * _S677, uint _S678)
{
    Fabric_0 * _S679 = (&(globalParams_0->fabrics_0)[_S673]);
    float _S680 = __ldg(&_S679->height_high_0);
    float _S681 = __ldg(&_S679->height_low_0);
    float _S682 = _S680 - _S681;
    float _S683 = _S677->height_7;
    float _S684 = _S677->last_step_3;
    float above_2 = _S677->height_7 + _S677->last_step_3;
    float above_gap_1 = clamp_1((&_S677->previous_4)->clearance_0, 0.0f, _S682);
    float under_gap_1 = clamp_1(_S677->depth_1, 0.0f, _S682);
    float _S685 = cubic_root_0(above_gap_1, - under_gap_1, (&_S677->previous_4)->rate_0 * _S677->last_step_3, _S677->rate_4 * _S677->last_step_3);
    bool _S686 = _S677->smooth_0;
    float middle_0;
    if(_S677->smooth_0)
    {
        middle_0 = above_2 - _S685 * _S684;
    }
    else
    {
        middle_0 = between_0(above_2, _S683, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S683;
    float above_3 = above_2;
    uint i_9 = 0U;
    for(;;)
    {
        if(i_9 < _S678)
        {
        }
        else
        {
            break;
        }
        float2  _S687 = ViewRay_at_0(_S674, middle_0);
        Probe_0 _S688 = probe_0(_S673, _S687.x, _S687.y, _S676, _S675->right_0, _S675->up_0);
        float _S689;
        if(_S688.hole_4)
        {
            _S689 = -1.0e+09f;
        }
        else
        {
            _S689 = _S688.height_3;
        }
        float _S690 = clamp_1(middle_0 - _S689, - _S682, _S682);
        float _S691;
        if(_S690 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S691 = 0.5f * above_gap_2;
            }
            else
            {
                _S691 = above_gap_2;
            }
            float _S692 = - _S690;
            under_1 = middle_0;
            above_gap_2 = _S691;
            under_gap_2 = _S692;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S691 = 0.5f * under_gap_2;
            }
            else
            {
                _S691 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S690;
            under_gap_2 = _S691;
            side_1 = -1.0f;
        }
        if(_S686)
        {
            Probe_0 _S693 = _S688;
            float _S694 = ViewRay_rate_0(_S674, &_S693);
            middle_0 = clamp_1(middle_0 + _S690 / (F32_min((_S694), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_9 = i_9 + 1U;
    }
    if(_S686)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S695, SearchQuality_0 * _S696, float _S697, float _S698, float3  _S699, bool _S700)
{
    float _S701 = (F32_max((_S699.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S697, _S698);
    float2  _S702 = float2 {_S699.x, _S699.y} / make_float2 (_S701);
    (&ray_0)->slope_1 = _S702;
    float2  _S703 = - _S702;
    float _S704 = steps_per_length_0(_S695, _S696, _S699);
    StepControl_0 _S705 = step_control_0(_S703, 1.0f / (F32_max((_S704 / _S701), (9.99999971718068537e-10f))));
    ViewRay_0 _S706 = ray_0;
    StepControl_0 _S707 = _S705;
    ViewRayEnd_0 _S708 = search_down_0(_S695, &_S706, &_S707, _S700);
    Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    ViewRay_0 _S709 = ray_0;
    StepControl_0 _S710 = _S705;
    ViewRayEnd_0 _S711 = _S708;
    float _S712 = refined_height_0(_S695, &_S709, &_S710, _S700, &_S711, _S696->refinements_0);
    (&hit_0)->height_5 = _S712;
    ViewRay_0 _S713 = ray_0;
    float2  _S714 = ViewRay_at_0(&_S713, _S712);
    (&hit_0)->x_29 = _S714.x;
    (&hit_0)->y_17 = _S714.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S715, SearchQuality_0 * _S716, float _S717, float _S718, float3  _S719, bool _S720)
{
    bool _S721 = passes_through_0(_S715, _S716, _S717, _S718, _S719, _S720);
    if(!_S721)
    {
        Hit_0 _S722 = first_hit_of_yarn_0(_S715, _S716, _S717, _S718, _S719, _S720);
        return _S722;
    }
    Hit_0 hit_1;
    (&hit_1)->x_29 = _S717;
    (&hit_1)->y_17 = _S718;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S723, float _S724, float _S725, bool _S726)
{
    Fabric_0 * _S727 = (&(globalParams_0->fabrics_0)[_S723]);
    Sample_0 _S728 = sample_at_0(_S723, _S724, _S725, _S726);
    float _S729;
    if(_S728.shown_3.is_warp_2)
    {
        _S729 = _S728.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S729 = _S728.crossing_2.weft_1.half_width_1;
    }
    uint _S730;
    if(_S728.shown_3.is_warp_2)
    {
        uint _S731 = __ldg(&_S727->warp_0);
        _S730 = _S731;
    }
    else
    {
        uint _S732 = __ldg(&_S727->weft_0);
        _S730 = _S732;
    }
    Family_0 _S733 = slang_ldg_2((&(globalParams_0->families_0)[_S730]));
    float _S734;
    if(_S726)
    {
        _S734 = -1.0f;
    }
    else
    {
        _S734 = 1.0f;
    }
    float _S735 = _S733.twist_sine_0 * _S734;
    Family_0 _S736 = slang_ldg_2((&(globalParams_0->families_0)[_S730]));
    if(_S728.shown_3.is_warp_2)
    {
        _S734 = 1.0f;
    }
    else
    {
        _S734 = -1.0f;
    }
    float2  _S737 = fibre_direction_0(_S728.slope_across_0, _S734 * _S728.slope_along_0, _S735, _S736.twist_cosine_0);
    float _S738;
    if(_S728.shown_3.is_warp_2)
    {
        _S738 = _S728.slope_x_1;
    }
    else
    {
        _S738 = _S728.slope_y_1;
    }
    float _S739;
    if(_S728.shown_3.is_warp_2)
    {
        _S739 = _S728.slope_y_1;
    }
    else
    {
        _S739 = _S728.slope_x_1;
    }
    float _S740 = _S737.x;
    float _S741 = _S737.y;
    float _S742 = _S738 * _S740 + _S734 * _S739 * _S741;
    float _S743 = _S729 * 1.0154266357421875f;
    float _S744 = _S743 * arc_sine_0(clamp_1(_S728.section_1.across_3 / _S743, -1.0f, 1.0f));
    if(_S728.shown_3.is_warp_2)
    {
        _S729 = _S725;
    }
    else
    {
        _S729 = - _S724;
    }
    SurfacePoint_0 point_0;
    (&point_0)->hole_0 = _S728.shown_3.hole_3;
    (&point_0)->is_warp_0 = _S728.shown_3.is_warp_2;
    (&point_0)->warp_thread_0 = _S728.crossing_2.warp_1.thread_0;
    (&point_0)->weft_thread_0 = _S728.crossing_2.weft_1.thread_0;
    (&point_0)->height_1 = _S728.height_6;
    (&point_0)->normal_0 = normalize_0(make_float3 (- _S728.slope_x_1, - _S728.slope_y_1, 1.0f));
    float3  _S745;
    if(_S728.shown_3.is_warp_2)
    {
        _S745 = make_float3 (_S740, _S741, _S742);
    }
    else
    {
        _S745 = make_float3 (- _S741, _S740, _S742);
    }
    (&point_0)->tangent_0 = normalize_0(_S745);
    (&point_0)->across_0 = _S728.section_1.across_3;
    (&point_0)->fibre_across_0 = _S744 * _S736.twist_cosine_0 + _S729 * _S735;
    (&point_0)->fibre_along_0 = _S729 * _S736.twist_cosine_0 - _S744 * _S735;
    return point_0;
}

struct YarnPoint_0
{
    bool back_4;
    bool hole_6;
    bool is_warp_3;
    float x_30;
    float y_18;
    float height_10;
    float3  normal_6;
    float3  tangent_7;
    float roughness_10;
    Albedos_0 albedos_5;
};

__device__ Albedos_0 vary_albedos_0(uint _S746, Albedos_0 * _S747, uint _S748, uint _S749)
{
    Fabric_0 * _S750 = (&(globalParams_0->fabrics_0)[_S746]);
    float3  _S751 = _S747->specular_reflect_0;
    float3  _S752 = _S747->specular_transmit_0;
    float3  _S753 = max_0(_S747->specular_reflect_0, _S747->specular_transmit_0);
    float3  _S754 = _S747->diffuse_reflect_0;
    float3  _S755 = _S747->diffuse_transmit_0;
    float3  _S756 = _S747->diffuse_reflect_0 + _S747->diffuse_transmit_0;
    float _S757 = __ldg(&_S750->colour_noise_0);
    uint _S758 = __ldg(&_S750->seed_0);
    float _S759 = thread_gain_0(_S748, _S757, _S758);
    float _S760 = __ldg(&_S750->layer_bound_0);
    float _S761 = bounded_gain_0(_S759, _S756, make_float3 (1.0f) - make_float3 (_S760) * _S753);
    float3  _S762 = min_0((make_float3 (1.0f) - make_float3 (_S761) * _S756) / make_float3 (_S760), make_float3 (1.0f));
    float _S763 = __ldg(&_S750->fibre_noise_0);
    float _S764 = bounded_gain_0(fibre_gain_0(_S748, _S749, _S763, _S758), _S753, _S762);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S761) * _S754;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S761) * _S755;
    (&varied_0)->specular_reflect_0 = make_float3 (_S764) * _S751;
    (&varied_0)->specular_transmit_0 = make_float3 (_S764) * _S752;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S765, SurfacePoint_0 * _S766, Albedos_0 * _S767, float _S768, float _S769)
{
    Fabric_0 * _S770 = (&(globalParams_0->fabrics_0)[_S765]);
    bool _S771 = _S766->is_warp_0;
    float _S772;
    if(_S766->is_warp_0)
    {
        _S772 = _S768;
    }
    else
    {
        _S772 = _S769;
    }
    float _S773 = _S772 - _S766->across_0;
    uint _S774;
    if(_S771)
    {
        uint _S775 = __ldg(&_S770->warp_0);
        _S774 = _S775;
    }
    else
    {
        uint _S776 = __ldg(&_S770->weft_0);
        _S774 = _S776;
    }
    Family_0 _S777 = slang_ldg_2((&(globalParams_0->families_0)[_S774]));
    Family_0 _S778 = slang_ldg_2((&(globalParams_0->families_0)[_S774]));
    int _S779 = int(_S778.count_0);
    if(_S771)
    {
        _S774 = _S766->warp_thread_0;
    }
    else
    {
        _S774 = _S766->weft_thread_0;
    }
    uint _S780 = uint(int((F32_floor((_S773 / _S777.period_0)))) * _S779 + int(_S774)) * 2U;
    if(_S771)
    {
        _S774 = 1U;
    }
    else
    {
        _S774 = 0U;
    }
    uint _S781 = _S780 + _S774;
    float _S782 = _S766->fibre_across_0;
    float _S783 = __ldg(&_S770->fibre_size_0);
    float _S784 = (F32_floor((_S782 / _S783)));
    Albedos_0 _S785 = vary_albedos_0(_S765, _S767, _S781, uint(int(_S784)) * 65536U + uint(int((F32_floor((_S766->fibre_along_0 / (_S783 * 40.0f) + 0.61799997091293335f * _S784))))));
    return _S785;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S786, SurfacePoint_0 * _S787, float _S788, float _S789, bool _S790, bool _S791)
{
    Fabric_0 * _S792 = (&(globalParams_0->fabrics_0)[_S786]);
    bool _S793 = _S787->is_warp_0;
    uint _S794;
    if(_S787->is_warp_0)
    {
        uint _S795 = __ldg(&_S792->warp_0);
        _S794 = _S795;
    }
    else
    {
        uint _S796 = __ldg(&_S792->weft_0);
        _S794 = _S796;
    }
    uint _S797;
    if(_S793)
    {
        _S797 = _S787->warp_thread_0;
    }
    else
    {
        _S797 = _S787->weft_thread_0;
    }
    Albedos_0 albedos_6 = albedos_of_0(_S794, _S797);
    float _S798 = __ldg(&_S792->fibre_noise_0);
    bool _S799;
    if(_S798 > 0.0f)
    {
        _S799 = true;
    }
    else
    {
        float _S800 = __ldg(&_S792->colour_noise_0);
        _S799 = _S800 > 0.0f;
    }
    Albedos_0 albedos_7;
    if(_S799)
    {
        Albedos_0 _S801 = albedos_6;
        Albedos_0 _S802 = varied_at_0(_S786, _S787, &_S801, _S788, _S789);
        albedos_7 = _S802;
    }
    else
    {
        albedos_7 = albedos_6;
    }
    YarnPoint_0 point_1;
    (&point_1)->back_4 = _S790;
    (&point_1)->hole_6 = _S791;
    (&point_1)->is_warp_3 = _S793;
    (&point_1)->x_30 = _S788;
    (&point_1)->y_18 = _S789;
    (&point_1)->height_10 = _S787->height_1;
    (&point_1)->normal_6 = _S787->normal_0;
    (&point_1)->tangent_7 = _S787->tangent_0;
    Family_0 _S803 = slang_ldg_2((&(globalParams_0->families_0)[_S794]));
    (&point_1)->roughness_10 = _S803.roughness_0;
    (&point_1)->albedos_5 = albedos_7;
    return point_1;
}

__device__ bool unoccluded_0(uint _S804, SearchQuality_0 * _S805, float _S806, float _S807, float _S808, float3  _S809, bool _S810)
{
    Fabric_0 * _S811 = (&(globalParams_0->fabrics_0)[_S804]);
    if((_S809.z) <= 0.0f)
    {
        return false;
    }
    float _S812 = max_height_along_0(_S804, _S806, _S807, _S808, _S809, _S810);
    float _S813 = __ldg(&_S811->lift_0);
    bool _S814 = is_free_0(_S804, _S805, make_float3 (_S806, _S807, _S808 + _S813), _S809, _S810, _S812);
    return _S814;
}

__device__ bool is_lit_0(uint _S815, SearchQuality_0 * _S816, YarnPoint_0 * _S817, float3  _S818)
{
    if(_S817->hole_6)
    {
        return true;
    }
    bool _S819 = _S817->back_4;
    float3  _S820 = to_face_frame_0(_S818, _S817->back_4);
    float _S821 = _S820.z;
    bool _S822 = _S821 < 0.0f;
    float3  _S823 = _S817->normal_6;
    float _S824 = _S817->height_10;
    float3  normal_7;
    float height_11;
    if(_S822)
    {
        SurfacePoint_0 _S825 = surface_at_0(_S815, _S817->x_30, _S817->y_18, !_S819);
        normal_7 = _S825.normal_0;
        height_11 = _S825.height_1;
    }
    else
    {
        normal_7 = _S823;
        height_11 = _S824;
    }
    float3  _S826 = make_float3 (float2 {_S820.x, _S820.y}.x, float2 {_S820.x, _S820.y}.y, (F32_abs((_S821))));
    if((dot_0(normal_7, _S826)) <= 0.0f)
    {
        return false;
    }
    bool _S827 = unoccluded_0(_S815, _S816, _S817->x_30, _S817->y_18, height_11, _S826, _S819 != _S822);
    return _S827;
}

__device__ Components_0 components_of_point_0(uint _S828, SearchQuality_0 * _S829, YarnPoint_0 * _S830, float3  _S831, float3  _S832)
{
    Fabric_0 * _S833 = (&(globalParams_0->fabrics_0)[_S828]);
    Components_0 result_12 = no_components_0();
    bool _S834 = _S830->hole_6;
    float _S835;
    if(_S830->hole_6)
    {
        _S835 = 1.0f;
    }
    else
    {
        _S835 = 0.0f;
    }
    (&result_12)->hole_2 = _S835;
    bool _S836;
    if(_S834)
    {
        _S836 = true;
    }
    else
    {
        bool _S837 = is_lit_0(_S828, _S829, _S830, _S831);
        _S836 = !_S837;
    }
    if(_S836)
    {
        return result_12;
    }
    float3  _S838 = to_face_frame_0(_S831, _S830->back_4);
    float3  _S839 = to_face_frame_0(_S832, _S830->back_4);
    bool _S840 = (_S838.z) < 0.0f;
    float3  _S841;
    if(_S840)
    {
        _S841 = - _S838;
    }
    else
    {
        _S841 = _S838;
    }
    float3  _S842 = _S830->normal_6;
    float _S843 = __ldg(&_S833->diffuse_blend_0);
    float _S844 = diffuse_reflection_0(_S841, _S842, _S843);
    if(_S840)
    {
        float3  _S845 = _S830->tangent_7;
        float _S846 = _S830->roughness_10;
        float _S847 = __ldg(&_S833->optical_depth_0);
        _S835 = transmission_0(_S838, _S839, _S842, _S845, _S846, _S847);
    }
    else
    {
        float3  _S848 = _S830->tangent_7;
        float _S849 = _S830->roughness_10;
        float _S850 = __ldg(&_S833->optical_depth_0);
        _S835 = reflection_0(_S838, _S839, _S842, _S848, _S849, _S850);
    }
    bool _S851 = _S830->is_warp_3;
    float _S852;
    if(_S830->is_warp_3)
    {
        _S852 = _S844;
    }
    else
    {
        _S852 = 0.0f;
    }
    (&result_12)->diffuse_warp_0 = _S852;
    if(_S851)
    {
        _S852 = 0.0f;
    }
    else
    {
        _S852 = _S844;
    }
    (&result_12)->diffuse_weft_0 = _S852;
    if(_S851)
    {
        _S852 = _S835;
    }
    else
    {
        _S852 = 0.0f;
    }
    (&result_12)->specular_warp_0 = _S852;
    if(_S851)
    {
        _S835 = 0.0f;
    }
    (&result_12)->specular_weft_0 = _S835;
    (&result_12)->light_visibility_1 = 1.0f;
    return result_12;
}

struct CoverageTaps_0
{
    FixedArray<uint, 9>  nodes_1;
};

__device__ float3  pyramid_level_0(uint _S853, float _S854)
{
    Lobes_0 _S855 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S853])->lobes_0);
    uint _S856 = _S855.levels_0 + 4U * uint((F32_min((_S854), (_S855.last_level_0))));
    return make_float3 (table_number_0(_S856), table_number_0(_S856 + 1U), table_number_0(_S856 + 2U));
}

__device__ CoverageTaps_0 coverage_taps_0(uint _S857, Footprint_0 * _S858, bool _S859)
{
    Fabric_0 * _S860 = (&(globalParams_0->fabrics_0)[_S857]);
    float _S861 = Footprint_spread_side_0(_S858);
    Lobes_0 _S862 = slang_ldg_1(&_S860->lobes_0);
    float _S863 = _S861 * _S862.inverse_base_size_0;
    float3  _S864 = pyramid_level_0(_S857, (F32_floor((binary_logarithm_0((F32_max((0.68000000715255737f * _S863), (1.0f))))))));
    float _S865 = 1.0f / (F32_max((_S863), (9.99999997475242708e-07f)));
    float _S866 = (F32_min(((F32_max(((F32_sqrt((clamp_1(1.29999995231628418f * (1.0f - _S865 * _S865), 0.0f, 1.0f))))), (0.3333333432674408f * _S865)))), (1.0f)));
    uint _S867 = __ldg(&_S860->warp_0);
    Family_0 _S868 = slang_ldg_2((&(globalParams_0->families_0)[_S867]));
    uint _S869 = __ldg(&_S860->weft_0);
    Family_0 _S870 = slang_ldg_2((&(globalParams_0->families_0)[_S869]));
    float2  _S871 = make_float2 (_S868.inverse_period_0, _S870.inverse_period_0);
    float2  _S872 = _S858->centre_0 * _S871;
    float2  _S873 = _S858->dx_0 * _S871 * make_float2 (_S866);
    float2  _S874 = _S858->dy_0 * _S871 * make_float2 (_S866);
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
        float2  _S875 = _S872 + make_float2 (TAP_OFFSETS_0[number_1].x) * _S873 + make_float2 (TAP_OFFSETS_0[number_1].y) * _S874;
        float _S876 = _S864.y;
        float _S877 = wrapped_cell_0(_S875.x, _S876);
        float _S878 = wrapped_cell_0(_S875.y, _S864.z);
        uint _S879;
        if(_S859)
        {
            _S879 = _S862.face_nodes_0;
        }
        else
        {
            _S879 = 0U;
        }
        (&taps_3)->nodes_1[number_1] = _S879 + uint(_S878 * _S876 + _S877 + _S864.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

__device__ float4  coverage_of_pack_0(uint _S880, CoverageTaps_0 * _S881, uint _S882)
{
    Fabric_0 * _S883 = (&(globalParams_0->fabrics_0)[_S880]);
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
        Lobes_0 _S884 = slang_ldg_1(&_S883->lobes_0);
        uint _S885 = __ldg((&(globalParams_0->words_0)[_S884.coverage_0 + _S881->nodes_1[number_2] * _S884.packs_0 + _S882]));
        uint even_2 = even_1 + (_S885 & 16711935U);
        uint odd_2 = odd_1 + ((_S885 >> int(8)) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / make_float4 (9.0f);
}

__device__ float coverage_of_holes_0(uint _S886, CoverageTaps_0 * _S887)
{
    Fabric_0 * _S888 = (&(globalParams_0->fabrics_0)[_S886]);
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
        uint _S889 = _S887->nodes_1[number_3];
        Lobes_0 _S890 = slang_ldg_1(&_S888->lobes_0);
        uint _S891 = __ldg((&(globalParams_0->words_0)[_S890.coverage_holes_0 + _S889 / 4U]));
        uint total_1 = total_0 + ((_S891 >> (8U * (_S889 % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

__device__ float prefiltered_hole_0(uint _S892, CoverageTaps_0 * _S893, NodeTaps_0 * _S894, bool _S895)
{
    Lobes_0 _S896 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S892])->lobes_0);
    float4  _S897 = interpolate_table_0(_S894, _S896.projected_area_0 + _S896.packs_0, _S896.packs_0 + 1U);
    float _S898 = _S897.x;
    float _S899;
    if(_S895)
    {
        _S899 = _S896.back_hole_weight_0;
    }
    else
    {
        _S899 = _S896.front_hole_weight_0;
    }
    float _S900 = coverage_of_holes_0(_S892, _S893);
    return (F32_min((_S900 * _S898 * _S898 * _S899), (1.0f)));
}

__device__ Components_0 prefiltered_components_0(uint _S901, Footprint_0 * _S902, float3  _S903, float3  _S904, bool _S905)
{
    Fabric_0 * _S906 = (&(globalParams_0->fabrics_0)[_S901]);
    CoverageTaps_0 _S907 = coverage_taps_0(_S901, _S902, _S905);
    NodeTaps_0 _S908 = node_taps_0(_S904);
    NodeTaps_0 view_nodes_0 = _S908;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S903);
    NodeTaps_0 seen_nodes_0 = _S908;
    uint _S909;
    if(_S905)
    {
        _S909 = 1U;
    }
    else
    {
        _S909 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + make_uint4 (_S909 * 256U);
    uint _S910 = 2U * _S909;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + make_uint4 (_S910 * 256U);
    uint _S911;
    if((_S903.z) < 0.0f)
    {
        _S911 = 1U;
    }
    else
    {
        _S911 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + make_uint4 ((_S910 + _S911) * 256U);
    float3  _S912 = half_vector_0(_S903, _S904);
    float3  _S913 = shadow_correlation_0(_S903, _S904);
    if(_S905)
    {
        Lobes_0 _S914 = slang_ldg_1(&_S906->lobes_0);
        _S911 = _S914.back_warp_packs_0;
    }
    else
    {
        Lobes_0 _S915 = slang_ldg_1(&_S906->lobes_0);
        _S911 = _S915.front_warp_packs_0;
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
        Lobes_0 _S916 = slang_ldg_1(&_S906->lobes_0);
        if(pack_0 < (_S916.packs_0))
        {
        }
        else
        {
            break;
        }
        CoverageTaps_0 _S917 = _S907;
        float4  _S918 = coverage_of_pack_0(_S901, &_S917, pack_0);
        uint _S919 = _S916.projected_area_0 + pack_0;
        uint _S920 = _S916.packs_0 + 1U;
        NodeTaps_0 _S921 = view_nodes_0;
        float4  _S922 = interpolate_table_0(&_S921, _S919, _S920);
        uint _S923 = _S916.light_visibility_0 + pack_0;
        NodeTaps_0 _S924 = seen_nodes_0;
        float4  _S925 = interpolate_table_0(&_S924, _S923, _S916.packs_0);
        float4  _S926 = _S925 / make_float4 (255.0f);
        NodeTaps_0 _S927 = light_nodes_0;
        float4  _S928 = interpolate_table_0(&_S927, _S923, _S916.packs_0);
        float4  _S929 = _S928 / make_float4 (255.0f);
        uint _S930 = _S916.irradiance_0 + pack_0;
        NodeTaps_0 _S931 = light_nodes_0;
        float4  _S932 = interpolate_table_0(&_S931, _S930, _S916.packs_0);
        float4  _S933 = _S932 * make_float4 (0.00124827399849892f);
        bool _S934 = pack_0 < _S911;
        uint _S935;
        if(_S934)
        {
            uint _S936 = __ldg(&_S906->warp_0);
            _S935 = _S936;
        }
        else
        {
            uint _S937 = __ldg(&_S906->weft_0);
            _S935 = _S937;
        }
        Family_0 _S938 = slang_ldg_2((&(globalParams_0->families_0)[_S935]));
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
            Group_0 _S939 = group_at_0(_S916.moments_0 + 12U * (4U * (_S909 * _S916.packs_0 + pack_0) + number_4), _S938.roughness_0);
            float _S940 = _slang_vector_get_element(_S918, number_4) * _slang_vector_get_element(_S922, number_4) * _slang_vector_get_element(_S922, number_4) * _S939.weight_1;
            uint _S941 = number_4;
            float2  _S942 = visibility_gain_0(_S913, _slang_vector_get_element(_S929, number_4), _slang_vector_get_element(_S926, number_4));
            float _S943 = __ldg(&_S906->optical_depth_0);
            Group_0 _S944 = _S939;
            float _S945 = layer_value_0(&_S944, _S912, _S903, _S904, _S943);
            float _S946 = _S942.x;
            float diffuse_1 = diffuse_0 + _S940 * _slang_vector_get_element(_S933, number_4) * _S946;
            float specular_1 = specular_0 + _S940 * _S945 * _slang_vector_get_element(_S929, _S941) * _S942.y;
            (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 + _S940 * _slang_vector_get_element(_S929, _S941) * _S946;
            float total_3 = total_2 + _S940;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S947;
        if(_S934)
        {
            _S947 = diffuse_0;
        }
        else
        {
            _S947 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S947;
        float _S948;
        if(_S934)
        {
            _S948 = 0.0f;
        }
        else
        {
            _S948 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S948;
        float _S949;
        if(_S934)
        {
            _S949 = specular_0;
        }
        else
        {
            _S949 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S949;
        float _S950;
        if(_S934)
        {
            _S950 = 0.0f;
        }
        else
        {
            _S950 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S950;
        pack_0 = pack_0 + 1U;
    }
    CoverageTaps_0 _S951 = _S907;
    NodeTaps_0 _S952 = view_nodes_0;
    float _S953 = prefiltered_hole_0(_S901, &_S951, &_S952, _S905);
    (&sums_1)->hole_2 = _S953;
    float _S954 = (1.0f - _S953) / (F32_max((total_2), (9.999999960041972e-13f)));
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S954;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S954;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S954;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S954;
    (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 * _S954;
    return sums_1;
}

__device__ FamilyAlbedos_0 albedos_over_0(uint _S955, Footprint_0 * _S956, bool _S957)
{
    Fabric_0 * _S958 = (&(globalParams_0->fabrics_0)[_S955]);
    float2  _S959 = sqrt_0(_S956->dx_0 * _S956->dx_0 + _S956->dy_0 * _S956->dy_0);
    uint _S960 = __ldg(&_S958->warp_0);
    float2  _S961 = _S956->centre_0;
    Stretch_0 _S962 = stretch_of_0(_S960, _S956->centre_0.x, _S959.x);
    uint _S963 = __ldg(&_S958->weft_0);
    Stretch_0 _S964 = stretch_of_0(_S963, _S961.y, _S959.y);
    FamilyAlbedos_0 albedos_8;
    Stretch_0 _S965 = _S962;
    Stretch_0 _S966 = _S964;
    Albedos_0 _S967 = mean_albedos_0(_S960, _S963, &_S965, &_S966, _S957);
    (&albedos_8)->warp_2 = _S967;
    Stretch_0 _S968 = _S964;
    Stretch_0 _S969 = _S962;
    Albedos_0 _S970 = mean_albedos_0(_S963, _S960, &_S968, &_S969, _S957);
    (&albedos_8)->weft_2 = _S970;
    return albedos_8;
}

__device__ Estimate_0 lobes_estimate_of_pass_0(uint _S971, Footprint_0 * _S972, float _S973, float2  _S974, float3  _S975, float3  _S976)
{
    float _S977;
    Fabric_0 * _S978 = (&(globalParams_0->fabrics_0)[_S971]);
    Regime_0 _S979 = regime_of_0(_S971, _S972, _S973);
    bool _S980 = (_S976.z) < 0.0f;
    float3  _S981 = to_face_frame_0(_S976, _S980);
    float _S982 = __ldg(&_S978->fibre_noise_0);
    bool _S983;
    if(_S982 > 0.0f)
    {
        _S983 = true;
    }
    else
    {
        float _S984 = __ldg(&_S978->colour_noise_0);
        _S983 = _S984 > 0.0f;
    }
    uint _S985 = __ldg(&_S978->warp_0);
    Family_0 _S986 = slang_ldg_2((&(globalParams_0->families_0)[_S985]));
    bool _S987;
    if((_S986.quantities_0) > 1U)
    {
        _S987 = true;
    }
    else
    {
        uint _S988 = __ldg(&_S978->weft_0);
        Family_0 _S989 = slang_ldg_2((&(globalParams_0->families_0)[_S988]));
        _S987 = (_S989.quantities_0) > 1U;
    }
    float _S990 = 1.0f - _S979.prefiltered_0;
    if(_S990 > 0.0f)
    {
        if(_S983)
        {
            _S987 = true;
        }
    }
    else
    {
        _S987 = false;
    }
    Footprint_0 box_0 = *_S972;
    float3  _S991 = make_float3 (0.0f);
    SurfacePoint_0 _S992 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S991, _S991, 0.0f, 0.0f, 0.0f);
    float2  _S993 = _S972->centre_0;
    Components_0 _S994 = no_components_0();
    int _S995;
    if(_S987)
    {
        _S995 = int(0);
    }
    else
    {
        _S995 = int(1);
    }
    uint _S996 = uint(_S995);
    Components_0 points_2 = _S994;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S992;
    float2  central_place_0 = _S993;
    uint number_5 = _S996;
    for(;;)
    {
        float _S997 = float(number_5);
        _S977 = _S979.points_1;
        if(_S997 < (_S979.points_1 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S998 = number_5 == 0U;
        uint _S999;
        if(_S998)
        {
            _S999 = 0U;
        }
        else
        {
            _S999 = number_5 - 1U;
        }
        float2  _S1000 = POINT_OFFSETS_0[_S999] + _S974;
        float2  _S1001;
        if(_S998)
        {
            _S1001 = make_float2 (0.0f);
        }
        else
        {
            _S1001 = _S1000 - round_0(_S1000);
        }
        float2  _S1002 = _S993 + make_float2 (_S1001.x) * _S972->dx_0 + make_float2 (_S1001.y) * _S972->dy_0;
        float _S1003;
        if(_S998)
        {
            _S1003 = 0.0f;
        }
        else
        {
            _S1003 = _S979.threads_1;
        }
        SearchQuality_0 _S1004 = quality_of_0(_S1003);
        float _S1005 = _S1002.x;
        float _S1006 = _S1002.y;
        SearchQuality_0 _S1007 = _S1004;
        Hit_0 _S1008 = first_hit_0(_S971, &_S1007, _S1005, _S1006, _S981, _S980);
        SurfacePoint_0 _S1009 = surface_at_0(_S971, _S1008.x_29, _S1008.y_17, _S980);
        if(_S998)
        {
            float central_weight_1;
            if(_S1008.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S990;
            }
            float2  central_place_1 = make_float2 (_S1008.x_29, _S1008.y_17);
            (&box_0)->centre_0 = lerp_2(_S993, central_place_1, make_float2 (central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S1009;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        SurfacePoint_0 _S1010 = _S1009;
        YarnPoint_0 _S1011 = yarn_point_of_0(_S971, &_S1010, _S1008.x_29, _S1008.y_17, _S980, _S1008.hole_5);
        SearchQuality_0 _S1012 = _S1004;
        YarnPoint_0 _S1013 = _S1011;
        Components_0 _S1014 = components_of_point_0(_S971, &_S1012, &_S1013, _S975, _S976);
        float _S1015 = (F32_min((_S979.points_1 - float(number_5 - 1U)), (1.0f)));
        Components_0 _S1016 = points_2;
        Components_0 _S1017 = _S1014;
        Components_0 _S1018 = with_added_0(&_S1016, &_S1017, _S1015);
        points_2 = _S1018;
        number_5 = number_5 + 1U;
    }
    Estimate_0 estimate_0;
    float _S1019 = _S990 / (F32_max((_S977), (1.0f)));
    Components_0 _S1020 = _S994;
    Components_0 _S1021 = points_2;
    Components_0 _S1022 = with_added_0(&_S1020, &_S1021, _S1019);
    (&estimate_0)->components_0 = _S1022;
    if((_S979.prefiltered_0) > 0.0f)
    {
        Components_0 _S1023 = prefiltered_components_0(_S971, _S972, to_face_frame_0(_S975, _S980), _S981, _S980);
        Components_0 _S1024 = (&estimate_0)->components_0;
        Components_0 _S1025 = _S1023;
        Components_0 _S1026 = with_added_0(&_S1024, &_S1025, _S979.prefiltered_0);
        (&estimate_0)->components_0 = _S1026;
    }
    Footprint_0 _S1027 = box_0;
    FamilyAlbedos_0 _S1028 = albedos_over_0(_S971, &_S1027, _S980);
    (&estimate_0)->albedos_4 = _S1028;
    if(_S983)
    {
        _S983 = central_weight_0 > 0.0f;
    }
    else
    {
        _S983 = false;
    }
    if(_S983)
    {
        SurfacePoint_0 _S1029 = central_0;
        Albedos_0 _S1030;
        if(central_0.is_warp_0)
        {
            _S1030 = (&(&estimate_0)->albedos_4)->warp_2;
        }
        else
        {
            _S1030 = (&(&estimate_0)->albedos_4)->weft_2;
        }
        float _S1031 = central_place_0.x;
        float _S1032 = central_place_0.y;
        SurfacePoint_0 _S1033 = central_0;
        Albedos_0 _S1034 = _S1030;
        Albedos_0 _S1035 = varied_at_0(_S971, &_S1033, &_S1034, _S1031, _S1032);
        Albedos_0 _S1036 = _S1030;
        Albedos_0 _S1037 = _S1035;
        Albedos_0 _S1038 = lerp_albedos_0(&_S1036, &_S1037, central_weight_0);
        if(_S1029.is_warp_0)
        {
            (&(&estimate_0)->albedos_4)->warp_2 = _S1038;
        }
        else
        {
            (&(&estimate_0)->albedos_4)->weft_2 = _S1038;
        }
    }
    return estimate_0;
}

__device__ Estimate_0 lobes_estimate_0(uint _S1039, Footprint_0 * _S1040, float _S1041, float3  _S1042, float3  _S1043)
{
    Estimate_0 _S1044 = lobes_estimate_of_pass_0(_S1039, _S1040, _S1041, make_float2 (0.0f), _S1042, _S1043);
    return _S1044;
}

__device__ float3  composed_0(uint _S1045, Components_0 * _S1046, FamilyAlbedos_0 * _S1047, float3  _S1048, float3  _S1049)
{
    Fabric_0 * _S1050 = (&(globalParams_0->fabrics_0)[_S1045]);
    float _S1051 = _S1046->diffuse_warp_0;
    float _S1052 = _S1046->diffuse_weft_0;
    float _S1053 = _S1046->specular_warp_0;
    float _S1054 = _S1046->specular_weft_0;
    float3  _S1055 = (&_S1047->warp_2)->diffuse_reflect_0 * make_float3 (_S1046->diffuse_warp_0) + (&_S1047->weft_2)->diffuse_reflect_0 * make_float3 (_S1046->diffuse_weft_0) + (&_S1047->warp_2)->specular_reflect_0 * make_float3 (_S1046->specular_warp_0) + (&_S1047->weft_2)->specular_reflect_0 * make_float3 (_S1046->specular_weft_0);
    float _S1056 = _S1049.z;
    float3  body_0;
    if((_S1048.z * _S1056) < 0.0f)
    {
        body_0 = (&_S1047->warp_2)->diffuse_transmit_0 * make_float3 (_S1051) + (&_S1047->weft_2)->diffuse_transmit_0 * make_float3 (_S1052) + (&_S1047->warp_2)->specular_transmit_0 * make_float3 (_S1053) + (&_S1047->weft_2)->specular_transmit_0 * make_float3 (_S1054);
    }
    else
    {
        body_0 = _S1055;
    }
    float _S1057 = __ldg(&_S1050->sheen_strength_0);
    if(_S1057 <= 0.0f)
    {
        return body_0;
    }
    bool _S1058 = _S1056 < 0.0f;
    float3  _S1059 = to_face_frame_0(_S1048, _S1058);
    float3  _S1060 = to_face_frame_0(_S1049, _S1058);
    float _S1061 = __ldg(&_S1050->sheen_roughness_0);
    float2  _S1062 = sheen_with_transmittance_0(_S1059, _S1060, _S1057, _S1061);
    return make_float3 (_S1062.y) * body_0 + make_float3 ((_S1046->light_visibility_1 + _S1046->hole_2) * _S1062.x);
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_2, float2  dx_1, float2  dy_1, float3  light_9, float3  view_8)
{
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_2;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    Footprint_0 _S1063 = footprint_0;
    Estimate_0 _S1064 = lobes_estimate_0(fabric_2, &_S1063, 1.0f, light_9, view_8);
    Components_0 _S1065 = _S1064.components_0;
    FamilyAlbedos_0 _S1066 = _S1064.albedos_4;
    float3  _S1067 = composed_0(fabric_2, &_S1065, &_S1066, light_9, view_8);
    float _S1068 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
    float through_0;
    if(_S1068 > 0.0f)
    {
        float _S1069 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
        float _S1070 = (F32_abs((view_8.z)));
        float _S1071 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_roughness_0);
        through_0 = _S1064.components_0.hole_2 * (1.0f - _S1069 * sheen_lobe_0(_S1070, _S1071).z);
    }
    else
    {
        through_0 = _S1064.components_0.hole_2;
    }
    return make_float4 (_S1067.x, _S1067.y, _S1067.z, through_0);
}

extern "C" __global__ void lobes_queries()
{
    uint _S1072 = (blockIdx * blockDim + threadIdx).x;
    uint _S1073 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S1072 >= _S1073)
    {
        return;
    }
    Query_0 _S1074 = slang_ldg_0((&(globalParams_0->queries_0)[_S1072]));
    *(&(globalParams_0->answers_0)[_S1072]) = cloth_value_0(_S1074.fabric_1, make_float2 (_S1074.centre_x_0, _S1074.centre_y_0), make_float2 (_S1074.dx_x_0, _S1074.dx_y_0), make_float2 (_S1074.dy_x_0, _S1074.dy_y_0), make_float3 (_S1074.light_x_0, _S1074.light_y_0, _S1074.light_z_0), make_float3 (_S1074.view_x_0, _S1074.view_y_0, _S1074.view_z_0));
    return;
}

