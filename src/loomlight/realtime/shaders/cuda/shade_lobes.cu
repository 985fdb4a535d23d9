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
__device__ float saturate_1(float x_19)
{
    return clamp_1(x_19, 0.0f, 1.0f);
}

__device__ float2  frac_0(float2  x_20)
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
        *_slang_vector_get_element_ptr(&result_11, i_8) = (F32_frac((_slang_vector_get_element(x_20, i_8))));
        i_8 = i_8 + int(1);
    }
    return result_11;
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

__device__ Lobes_0 slang_ldg_0(Lobes_0 * ptr_0)
{
    uint _S7 = __ldg(&ptr_0->is_baked_0);
    float _S8 = __ldg(&ptr_0->inverse_base_size_0);
    float _S9 = __ldg(&ptr_0->last_level_0);
    uint _S10 = __ldg(&ptr_0->levels_0);
    uint _S11 = __ldg(&ptr_0->face_nodes_0);
    uint _S12 = __ldg(&ptr_0->packs_0);
    uint _S13 = __ldg(&ptr_0->front_warp_packs_0);
    uint _S14 = __ldg(&ptr_0->back_warp_packs_0);
    uint _S15 = __ldg(&ptr_0->coverage_0);
    uint _S16 = __ldg(&ptr_0->coverage_holes_0);
    uint _S17 = __ldg(&ptr_0->projected_area_0);
    uint _S18 = __ldg(&ptr_0->light_visibility_0);
    uint _S19 = __ldg(&ptr_0->irradiance_0);
    uint _S20 = __ldg(&ptr_0->moments_0);
    float _S21 = __ldg(&ptr_0->front_hole_weight_0);
    float _S22 = __ldg(&ptr_0->back_hole_weight_0);
    float _S23 = __ldg(&ptr_0->threads_per_mm_0);
    float _S24 = __ldg(&ptr_0->unit_level_0);
    Lobes_0 _S25 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19, _S20, _S21, _S22, _S23, _S24 };
    return _S25;
}

__device__ Vertex_0 slang_ldg_1(Vertex_0 * ptr_1)
{
    float _S26 = __ldg(&ptr_1->x_1);
    float _S27 = __ldg(&ptr_1->y_1);
    float _S28 = __ldg(&ptr_1->z_1);
    float _S29 = __ldg(&ptr_1->normal_x_0);
    float _S30 = __ldg(&ptr_1->normal_y_0);
    float _S31 = __ldg(&ptr_1->normal_z_0);
    float _S32 = __ldg(&ptr_1->u_0);
    float _S33 = __ldg(&ptr_1->v_0);
    Vertex_0 _S34 = { _S26, _S27, _S28, _S29, _S30, _S31, _S32, _S33 };
    return _S34;
}

__device__ float3  position_of_0(Vertex_0 * vertex_0)
{
    return make_float3 (vertex_0->x_1, vertex_0->y_1, vertex_0->z_1);
}

__device__ float square_0(float3  v_1)
{
    return dot_0(v_1, v_1);
}

__device__ float3  normal_of_0(Vertex_0 * vertex_1)
{
    return make_float3 (vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

__device__ float square_1(float x_21)
{
    return x_21 * x_21;
}

__device__ float natural_logarithm_0(float x_22)
{
    uint _S35 = (F32_asuint((x_22)));
    float exponent_0 = float(int(_S35 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S35 & 8388607U) | 1056964608U)));
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
    float _S36 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S36 - exponent_1 * 0.00021219444170129f - 0.5f * _S36) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_23)
{
    return natural_logarithm_0(x_23) * 1.4426950216293335f;
}

__device__ float exponential_0(float x_24)
{
    float _S37 = clamp_1(x_24, -87.0f, 88.0f);
    float _S38 = (F32_floor((_S37 * 1.4426950216293335f + 0.5f)));
    float _S39 = _S37 - _S38 * 0.693359375f + _S38 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S39 + 0.00139819993637502f) * _S39 + 0.00833345204591751f) * _S39 + 0.04166579619050026f) * _S39 + 0.1666666567325592f) * _S39 + 0.5f;
    float _S40 = (U32_asfloat((uint(int(_S38) + int(127)) << int(23))));
    float _S41;
    if(x_24 < -87.0f)
    {
        _S41 = 0.0f;
    }
    else
    {
        _S41 = (p_0 * _S39 * _S39 + _S39 + 1.0f) * _S40;
    }
    return _S41;
}

__device__ float3  map_texel_0(uint index_0)
{
    uint _S42 = __ldg((&(globalParams_0->scene_words_0)[index_0]));
    float3  _S43 = make_float3 (float(_S42 & 1023U), float((_S42 >> int(10)) & 1023U), float(_S42 >> int(20))) / make_float3 (1023.0f);
    return _S43 * _S43;
}

__device__ float3  map_level_0(uint first_0, uint side_0, float2  uv_0)
{
    float _S44 = uv_0.x;
    float _S45 = float(side_0);
    float _S46 = (_S44 - (F32_floor((_S44)))) * _S45 - 0.5f;
    float _S47 = uv_0.y;
    float _S48 = (_S47 - (F32_floor((_S47)))) * _S45 - 0.5f;
    float _S49 = (F32_floor((_S46)));
    int _S50 = int(side_0);
    uint _S51 = side_0 - 1U;
    uint _S52 = uint(int(_S49) + _S50) & _S51;
    float _S53 = (F32_floor((_S48)));
    uint _S54 = uint(int(_S53) + _S50) & _S51;
    uint _S55 = (_S52 + 1U) & _S51;
    uint _S56 = first_0 + _S54 * side_0;
    float3  _S57 = make_float3 (_S46 - _S49);
    uint _S58 = first_0 + ((_S54 + 1U) & _S51) * side_0;
    return lerp_0(lerp_0(map_texel_0(_S56 + _S52), map_texel_0(_S56 + _S55), _S57), lerp_0(map_texel_0(_S58 + _S52), map_texel_0(_S58 + _S55), _S57), make_float3 (_S48 - _S53));
}

struct VisiblePoint_0
{
    float3  position_0;
    float3  view_0;
    float3  axis_x_0;
    float3  axis_y_0;
    float3  normal_0;
    float3  face_normal_0;
    float2  uv_1;
    float2  draft_per_uv_0;
    float2  draft_0;
    float2  draft_dx_0;
    float2  draft_dy_0;
};

__device__ float3  to_local_0(VisiblePoint_0 * point_0, float3  direction_0)
{
    return make_float3 (dot_0(direction_0, point_0->axis_x_0), dot_0(direction_0, point_0->axis_y_0), dot_0(direction_0, point_0->normal_0));
}

__device__ uint scramble_0(uint value_0)
{
    uint _S59 = value_0 * 747796405U + 2891336453U;
    uint _S60 = ((_S59 >> ((_S59 >> int(28)) + 4U)) ^ _S59) * 277803737U;
    return (_S60 >> int(22)) ^ _S60;
}

__device__ float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float2  pixel_sequence_0(uint2  pixel_0, uint index_1, uint stream_1)
{
    uint _S61 = pixel_0.x;
    uint _S62 = pixel_0.y;
    return frac_0(make_float2 (uniform_hash_0(_S61, _S62, stream_1), uniform_hash_0(_S61, _S62, stream_1 + 1U)) + make_float2 (float(index_1 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f));
}

__device__ float scene_number_0(uint index_2)
{
    uint _S63 = __ldg((&(globalParams_0->scene_words_0)[index_2]));
    return (U32_asfloat((_S63)));
}

struct Choice_0
{
    uint index_3;
    float remainder_0;
};

__device__ Choice_0 choose_0(uint table_0, uint count_1, float number_0)
{
    uint high_0 = count_1;
    uint low_0 = 0U;
    for(;;)
    {
        if((high_0 - low_0) > 1U)
        {
        }
        else
        {
            break;
        }
        uint _S64 = (low_0 + high_0) / 2U;
        if((scene_number_0(table_0 + _S64)) <= number_0)
        {
            low_0 = _S64;
        }
        else
        {
            high_0 = _S64;
        }
    }
    uint _S65 = table_0 + low_0;
    float _S66 = scene_number_0(_S65);
    float _S67 = scene_number_0(_S65 + 1U);
    Choice_0 choice_0;
    (&choice_0)->index_3 = low_0;
    (&choice_0)->remainder_0 = saturate_1((number_0 - _S66) / (F32_max((_S67 - _S66), (9.999999960041972e-13f))));
    return choice_0;
}

__device__ float mean_0(float3  colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

__device__ float2  sine_cosine_0(float x_25)
{
    float _S68 = (F32_floor((x_25 * 0.63661974668502808f + 0.5f)));
    float _S69 = x_25 - _S68 * 1.5703125f - _S68 * 0.00048375129699707f - _S68 * 7.54979012640433211e-08f;
    float _S70 = _S69 * _S69;
    float _S71 = ((-0.00019515295571182f * _S70 + 0.00833216123282909f) * _S70 - 0.16666655242443085f) * _S70 * _S69 + _S69;
    float _S72 = ((0.00002443315679557f * _S70 - 0.00138873164542019f) * _S70 + 0.04166664555668831f) * _S70 * _S70 - 0.5f * _S70 + 1.0f;
    uint _S73 = uint(int(_S68)) & 3U;
    float2  _S74;
    if((_S73 & 1U) != 0U)
    {
        _S74 = make_float2 (_S72, _S71);
    }
    else
    {
        _S74 = make_float2 (_S71, _S72);
    }
    float _S75;
    if((_S73 & 2U) != 0U)
    {
        _S75 = - _S74.x;
    }
    else
    {
        _S75 = _S74.x;
    }
    float _S76;
    if(((_S73 + 1U) & 2U) != 0U)
    {
        _S76 = - _S74.y;
    }
    else
    {
        _S76 = _S74.y;
    }
    return make_float2 (_S75, _S76);
}

__device__ Light_0 slang_ldg_2(Light_0 * ptr_2)
{
    uint _S77 = __ldg(&ptr_2->is_point_0);
    float _S78 = __ldg(&ptr_2->x_0);
    float _S79 = __ldg(&ptr_2->y_0);
    float _S80 = __ldg(&ptr_2->z_0);
    float _S81 = __ldg(&ptr_2->red_0);
    float _S82 = __ldg(&ptr_2->green_0);
    float _S83 = __ldg(&ptr_2->blue_0);
    Light_0 _S84 = { _S77, _S78, _S79, _S80, _S81, _S82, _S83 };
    return _S84;
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

__device__ float3  to_face_frame_0(float3  direction_1, bool back_1)
{
    float2  _S85 = float2 {direction_1.x, direction_1.y};
    float _S86;
    if(back_1)
    {
        _S86 = - direction_1.z;
    }
    else
    {
        _S86 = direction_1.z;
    }
    return make_float3 (_S85.x, _S85.y, _S86);
}

__device__ Family_0 slang_ldg_3(Family_0 * ptr_3)
{
    uint _S87 = __ldg(&ptr_3->is_alike_0);
    float _S88 = __ldg(&ptr_3->count_0);
    float _S89 = __ldg(&ptr_3->inverse_count_0);
    float _S90 = __ldg(&ptr_3->half_inverse_count_0);
    float _S91 = __ldg(&ptr_3->size_0);
    float _S92 = __ldg(&ptr_3->inverse_size_0);
    float _S93 = __ldg(&ptr_3->half_width_0);
    float _S94 = __ldg(&ptr_3->start_0);
    float _S95 = __ldg(&ptr_3->period_0);
    float _S96 = __ldg(&ptr_3->inverse_period_0);
    float _S97 = __ldg(&ptr_3->bins_0);
    uint _S98 = __ldg(&ptr_3->first_thread_table_0);
    uint _S99 = __ldg(&ptr_3->place_table_0);
    uint _S100 = __ldg(&ptr_3->bend_table_0);
    float _S101 = __ldg(&ptr_3->height_scale_0);
    float _S102 = __ldg(&ptr_3->twist_sine_0);
    float _S103 = __ldg(&ptr_3->twist_cosine_0);
    float _S104 = __ldg(&ptr_3->level_0);
    float _S105 = __ldg(&ptr_3->roughness_0);
    uint _S106 = __ldg(&ptr_3->albedo_table_0);
    uint _S107 = __ldg(&ptr_3->albedo_stride_0);
    uint _S108 = __ldg(&ptr_3->before_0);
    float _S109 = __ldg(&ptr_3->visible_total_0);
    float _S110 = __ldg(&ptr_3->smallest_box_0);
    uint _S111 = __ldg(&ptr_3->quantities_0);
    uint _S112 = __ldg(&ptr_3->colour_mean_0);
    uint _S113 = __ldg(&ptr_3->colour_axes_0);
    uint _S114 = __ldg(&ptr_3->colour_threads_0);
    uint _S115 = __ldg(&ptr_3->colour_areas_0);
    float _S116 = __ldg(&ptr_3->area_unit_0);
    float _S117 = __ldg(&ptr_3->crossing_area_0);
    Family_0 _S118 = { _S87, _S88, _S89, _S90, _S91, _S92, _S93, _S94, _S95, _S96, _S97, _S98, _S99, _S100, _S101, _S102, _S103, _S104, _S105, _S106, _S107, _S108, _S109, _S110, _S111, _S112, _S113, _S114, _S115, _S116, _S117 };
    return _S118;
}

struct SurfacePoint_0
{
    bool hole_0;
    bool is_warp_0;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_1;
    float3  normal_1;
    float3  tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_2, float3  normal_2, float3  tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    SurfacePoint_0 _S119;
    (&_S119)->hole_0 = hole_1;
    (&_S119)->is_warp_0 = is_warp_1;
    (&_S119)->warp_thread_0 = warp_thread_1;
    (&_S119)->weft_thread_0 = weft_thread_1;
    (&_S119)->height_1 = height_2;
    (&_S119)->normal_1 = normal_2;
    (&_S119)->tangent_0 = tangent_1;
    (&_S119)->across_0 = across_1;
    (&_S119)->fibre_across_0 = fibre_across_1;
    (&_S119)->fibre_along_0 = fibre_along_1;
    return _S119;
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
    float _S120 = clamp_1((-3.0f - binary_logarithm_0((F32_max((threads_0), (9.99999971718068537e-10f))))) / 2.0f, 0.0f, 1.0f);
    SearchQuality_0 quality_0;
    float _S121 = lerp_1(2.5f, 5.0f, _S120);
    (&quality_0)->steps_per_thread_0 = _S121;
    (&quality_0)->steps_per_relief_0 = _S121;
    (&quality_0)->shadow_share_0 = lerp_1(1.60000002384185791f, 1.0f, _S120);
    (&quality_0)->refinements_0 = uint(lerp_1(1.0f, 2.0f, _S120) + 0.5f);
    return quality_0;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_4)
{
    Family_0 _S122 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    Family_0 _S123 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    float _S124 = (F32_floor(((F32_fma((index_4), (_S122.inverse_count_0), (_S123.half_inverse_count_0))))));
    float _S125 = - _S124;
    Family_0 _S126 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S124, (F32_fma((_S125), (_S126.count_0), (index_4))));
}

struct Cell_0
{
    uint thread_1;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_1)
{
    Family_0 _S127 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    float _S128 = (F32_floor((position_1 * _S127.inverse_size_0)));
    Cell_0 cell_1;
    float _S129 = - _S128;
    Family_0 _S130 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    float _S131 = (F32_fma((_S129), (_S130.size_0), (position_1)));
    (&cell_1)->below_0 = _S131;
    Family_0 _S132 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->above_0 = _S132.size_0 - _S131;
    Family_0 _S133 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->across_2 = _S131 - 0.5f * _S133.size_0;
    Family_0 _S134 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->half_width_1 = _S134.half_width_0;
    float _S135 = turns_and_remainder_0(family_1, _S128).y;
    Family_0 _S136 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->thread_1 = uint(clamp_1(_S135, 0.0f, _S136.count_0 - 1.0f));
    return cell_1;
}

__device__ float table_number_0(uint index_5)
{
    uint _S137 = __ldg((&(globalParams_0->words_0)[index_5]));
    return (U32_asfloat((_S137)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_2)
{
    Family_0 _S138 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S139 = position_2 - _S138.start_0;
    Family_0 _S140 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S139 * _S140.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S141 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S142 = turns_1 * _S141.period_0;
    Family_0 _S143 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S144 = turns_1 * _S143.bins_0;
    Family_0 _S145 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S146 = uint(clamp_1(_S144, 0.0f, _S145.bins_0 - 1.0f));
    Family_0 _S147 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S148 = __ldg((&(globalParams_0->words_0)[_S147.first_thread_table_0 + _S146]));
    Family_0 _S149 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S150;
    if(_S142 >= (table_number_0(_S149.place_table_0 + _S148 * 4U + 1U)))
    {
        _S150 = 1U;
    }
    else
    {
        _S150 = 0U;
    }
    uint _S151 = _S148 + _S150;
    Family_0 _S152 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S153 = (U32_min((_S151), (uint(_S152.count_0) - 1U)));
    Family_0 _S154 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S155 = _S154.place_table_0 + _S153 * 4U;
    Cell_0 cell_2;
    (&cell_2)->thread_1 = _S153;
    (&cell_2)->below_0 = _S142 - table_number_0(_S155);
    (&cell_2)->above_0 = table_number_0(_S155 + 1U) - _S142;
    (&cell_2)->across_2 = _S142 - table_number_0(_S155 + 2U);
    (&cell_2)->half_width_1 = table_number_0(_S155 + 3U);
    return cell_2;
}

__device__ Cell_0 locate_0(uint family_3, float position_3)
{
    Family_0 _S156 = slang_ldg_3((&(globalParams_0->families_0)[family_3]));
    if((_S156.is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
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
    bool _S157 = (F32_abs(((&crossing_0->warp_1)->across_2))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S158 = (F32_abs(((&crossing_0->weft_1)->across_2))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S159;
    if(_S157)
    {
        if(!_S158)
        {
            _S159 = true;
        }
        else
        {
            _S159 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S159 = false;
    }
    (&shown_0)->is_warp_2 = _S159;
    if(!_S157)
    {
        _S159 = !_S158;
    }
    else
    {
        _S159 = false;
    }
    (&shown_0)->hole_3 = _S159;
    uint _S160;
    if((&shown_0)->is_warp_2)
    {
        _S160 = crossing_0->warp_word_0;
    }
    else
    {
        _S160 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S160;
    (&shown_0)->on_top_0 = ((_S160 & 1U) == 1U) != back_2;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_1, Cell_0 * second_0)
{
    Cell_0 cell_3;
    uint _S161;
    if(is_first_0)
    {
        _S161 = first_1->thread_1;
    }
    else
    {
        _S161 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S161;
    float _S162;
    if(is_first_0)
    {
        _S162 = first_1->across_2;
    }
    else
    {
        _S162 = second_0->across_2;
    }
    (&cell_3)->across_2 = _S162;
    if(is_first_0)
    {
        _S162 = first_1->half_width_1;
    }
    else
    {
        _S162 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S162;
    if(is_first_0)
    {
        _S162 = first_1->below_0;
    }
    else
    {
        _S162 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S162;
    if(is_first_0)
    {
        _S162 = first_1->above_0;
    }
    else
    {
        _S162 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S162;
    return cell_3;
}

__device__ float boundary_0(uint family_4, uint thread_2, int step_0)
{
    float2  _S163 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    float _S164 = _S163.x;
    Family_0 _S165 = slang_ldg_3((&(globalParams_0->families_0)[family_4]));
    Family_0 _S166 = slang_ldg_3((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S164), (_S165.period_0), (table_number_0(_S166.place_table_0 + uint(_S163.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_3, int first_2, int last_0)
{
    Family_0 _S167 = slang_ldg_3((&(globalParams_0->families_0)[family_5]));
    if((_S167.is_alike_0) != 0U)
    {
        float _S168 = float(last_0 - first_2);
        Family_0 _S169 = slang_ldg_3((&(globalParams_0->families_0)[family_5]));
        return _S168 * _S169.size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_2);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

__device__ Bend_0 bend_of_0(uint family_6, uint thread_4)
{
    Family_0 _S170 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    Family_0 _S171 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    uint _S172;
    if((_S171.is_alike_0) != 0U)
    {
        _S172 = 0U;
    }
    else
    {
        _S172 = thread_4 * 4U;
    }
    uint _S173 = _S170.bend_table_0 + _S172;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S173);
    (&bend_0)->half_tangent_0 = table_number_0(_S173 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S173 + 2U);
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

__device__ Run_0 unpack_0(uint own_0, uint other_0, uint thread_5, Cell_0 * crossed_0, uint word_1)
{
    int _S174 = int((word_1 >> int(1)) & 127U);
    int _S175 = int((word_1 >> int(8)) & 127U);
    int _S176 = int((word_1 >> int(15)) & 63U);
    int _S177 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S178 = crossed_0->thread_1;
    int _S179 = - _S174;
    float _S180 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_1, _S179, int(0));
    (&run_0)->from_start_0 = _S180;
    int _S181 = _S175 + int(1);
    float _S182 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_1, int(1), _S181);
    (&run_0)->to_end_0 = _S182;
    bool _S183 = _S180 < _S182;
    (&run_0)->near_start_0 = _S183;
    int _S184;
    if(_S183)
    {
        _S184 = _S179 - _S176;
    }
    else
    {
        _S184 = _S181;
    }
    int _S185;
    if((&run_0)->near_start_0)
    {
        _S185 = _S179;
    }
    else
    {
        _S185 = _S181 + _S177;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_5);
    float _S186;
    if((&run_0)->straight_0)
    {
        _S186 = 1.0e+06f;
    }
    else
    {
        _S186 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S186;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S178, _S184, _S185)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S174 == int(0);
    (&run_0)->last_crossing_0 = _S175 == int(0);
    return run_0;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_4)
{
    float _S187 = cell_4->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S188 = clamp_1(cell_4->across_2, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_3 = _S188;
    float _S189 = _S187 * _S187 - square_1(_S188);
    float _S190 = (F32_rsqrt((_S189)));
    (&section_0)->drop_0 = _S187 - _S189 * _S190;
    (&section_0)->slope_0 = - _S188 * _S190;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_6, int step_1)
{
    Family_0 _S191 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    if((_S191.is_alike_0) != 0U)
    {
        Family_0 _S192 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S192.bend_table_0 + 3U);
    }
    Family_0 _S193 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S193.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S194 = crossed_1->below_0;
    float _S195 = crossed_1->above_0;
    bool _S196 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S197 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S198;
    if(_S196)
    {
        _S198 = _S194 - crossed_1->across_2;
    }
    else
    {
        _S198 = _S195 + crossed_1->across_2;
    }
    float _S199 = _S198 - crossed_1->half_width_1;
    bool _S200;
    if(_S196)
    {
        _S200 = run_1->first_crossing_0;
    }
    else
    {
        _S200 = run_1->last_crossing_0;
    }
    bool _S201 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S198 = 0.0f;
    }
    else
    {
        Family_0 _S202 = slang_ldg_3((&(globalParams_0->families_0)[other_1]));
        _S198 = _S202.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_1, int(0));
    }
    float _S203;
    if(_S201 != _S200)
    {
        _S203 = 0.0f;
    }
    else
    {
        Family_0 _S204 = slang_ldg_3((&(globalParams_0->families_0)[other_1]));
        uint _S205 = crossed_1->thread_1;
        int _S206;
        if(_S196)
        {
            _S206 = int(-1);
        }
        else
        {
            _S206 = int(1);
        }
        _S203 = _S204.height_scale_0 * edge_drop_0(other_1, _S205, _S206);
    }
    float _S207 = 1.0f / (F32_max((2.0f * _S199), (9.999999960041972e-13f)));
    float _S208 = clamp_1((_S199 - _S197) * _S207, 0.0f, 1.0f);
    float _S209 = _S198 + (_S203 - _S198) * (_S208 * _S208 * (3.0f - 2.0f * _S208));
    float _S210 = (_S198 - _S203) * (6.0f * _S208 * (1.0f - _S208) * _S207);
    if(_S196)
    {
        _S198 = 1.0f;
    }
    else
    {
        _S198 = -1.0f;
    }
    return make_float2 (_S209, _S210 * _S198);
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

__device__ StepControl_0 step_control_0(float2  direction_2, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S211 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S211)))), (9.99999971718068537e-10f)));
    float _S212 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S212)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S211 > 0.0f;
    (&control_0)->up_0 = _S212 > 0.0f;
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

__device__ float outline_distance_0(Cell_0 * cell_5, Shown_0 * shown_2, Run_0 * run_2, bool lengthwise_0, bool forwards_0)
{
    float _S213;
    if(forwards_0)
    {
        _S213 = cell_5->across_2;
    }
    else
    {
        _S213 = - cell_5->across_2;
    }
    float _S214;
    if(forwards_0)
    {
        _S214 = cell_5->above_0;
    }
    else
    {
        _S214 = cell_5->below_0;
    }
    bool _S215;
    if(forwards_0)
    {
        _S215 = run_2->last_crossing_0;
    }
    else
    {
        _S215 = run_2->first_crossing_0;
    }
    bool _S216;
    if(forwards_0)
    {
        _S216 = run_2->first_crossing_0;
    }
    else
    {
        _S216 = run_2->last_crossing_0;
    }
    float _S217 = cell_5->half_width_1;
    float _S218 = - cell_5->half_width_1;
    bool _S219 = _S213 < _S218;
    bool _S220 = _S213 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S215 = !_S215;
    }
    else
    {
        _S215 = false;
    }
    if(_S215)
    {
        _S215 = !shown_2->hole_3;
    }
    else
    {
        _S215 = false;
    }
    bool _S221;
    if(_S215)
    {
        _S221 = shown_2->on_top_0;
    }
    else
    {
        _S221 = false;
    }
    if(_S221)
    {
        if(_S216)
        {
            _S216 = _S219;
        }
        else
        {
            _S216 = false;
        }
        _S216 = !_S216;
    }
    else
    {
        _S216 = false;
    }
    if(shown_2->hole_3)
    {
        _S215 = true;
    }
    else
    {
        if(_S215)
        {
            _S215 = !shown_2->on_top_0;
        }
        else
        {
            _S215 = false;
        }
    }
    float _S222;
    if(_S219)
    {
        _S222 = _S218;
    }
    else
    {
        _S222 = _S217;
    }
    float _S223 = _S222 - _S213;
    if(_S215)
    {
        _S213 = 2.0f * _S214 + _S213 - _S217;
    }
    else
    {
        _S213 = _S214;
    }
    if(_S216)
    {
        if(forwards_0)
        {
            _S213 = run_2->to_end_0;
        }
        else
        {
            _S213 = run_2->from_start_0;
        }
        return _S213;
    }
    if(_S220)
    {
    }
    else
    {
        _S213 = _S223;
    }
    return _S213;
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
    float _S224 = previous_1->rate_0;
    float _S225 = previous_1->rate_0 * step_4;
    float _S226 = rate_1 * step_4;
    bool _S227;
    if(!previous_1->known_0)
    {
        _S227 = true;
    }
    else
    {
        _S227 = here_0->hole_4;
    }
    if(_S227)
    {
        _S227 = true;
    }
    else
    {
        _S227 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S227)
    {
        _S227 = true;
    }
    else
    {
        _S227 = _S224 >= 0.0f;
    }
    if(_S227)
    {
        _S227 = true;
    }
    else
    {
        _S227 = rate_1 <= 0.0f;
    }
    if(_S227)
    {
        return -1.0f;
    }
    float _S228 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S225) >= 0.0f)
    {
        _S227 = (3.0f * clearance_1 - _S226) >= 0.0f;
    }
    else
    {
        _S227 = false;
    }
    if(_S227)
    {
        return -1.0f;
    }
    float _S229 = clearance_1 - _S228;
    float _S230 = 6.0f * _S229 - 4.0f * _S225 - 2.0f * _S226;
    float _S231 = -2.0f * _S225 / (F32_max((_S230 + (F32_sqrt(((F32_max((_S230 * _S230 - 4.0f * (3.0f * (_S225 + _S226 - 2.0f * _S229)) * _S225), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S232 = 1.0f - _S231;
    float _S233 = (_S228 * (2.0f * _S231 + 1.0f) + _S225 * _S231) * _S232 * _S232;
    float _S234 = (clearance_1 * (2.0f * _S232 + 1.0f) - _S226 * _S232) * _S231 * _S231;
    if(_S231 > 0.01999999955296516f)
    {
        _S227 = _S232 > 0.01999999955296516f;
    }
    else
    {
        _S227 = false;
    }
    if(_S227)
    {
        _S227 = (_S233 + _S234) < 0.0f;
    }
    else
    {
        _S227 = false;
    }
    float _S235;
    if(_S227)
    {
        _S235 = _S232 * step_4;
    }
    else
    {
        _S235 = -1.0f;
    }
    return _S235;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S236 = here_1->hole_4;
    float _S237;
    if(here_1->hole_4)
    {
        _S237 = 1.0e+09f;
    }
    else
    {
        _S237 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S237;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S238;
    if(!_S236)
    {
        _S238 = !is_cell_exit_0;
    }
    else
    {
        _S238 = false;
    }
    (&previous_2)->known_0 = _S238;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S239 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S240;
    if(!here_2->hole_4)
    {
        _S240 = (rate_3 * _S239 + clearance_3) < 0.0f;
    }
    else
    {
        _S240 = false;
    }
    if(_S240)
    {
        _S240 = _S239 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S240 = false;
    }
    float _S241 = this_2->step_2;
    float _S242;
    if(_S240)
    {
        _S242 = _S239 - this_2->epsilon_0;
    }
    else
    {
        _S242 = (F32_max((_S239), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S241), (_S242)));
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
    float _S243 = end_0 - start_1;
    float _S244 = start_rate_0 + end_rate_0 - 2.0f * _S243;
    float _S245 = 3.0f * _S243 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S243), (9.99999968265522539e-21f)));
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
        float _S246 = clamp_1(share_1 - (((_S244 * share_1 + _S245) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S244 * share_1 + 2.0f * _S245) * share_1 + start_rate_0), (0.10000000149011612f * _S243 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S247 = i_9 + int(1);
        share_1 = _S246;
        i_9 = _S247;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_1(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S248 = along_slope_0 * along_slope_0 + 1.0f;
    float _S249 = (F32_rsqrt((_S248)));
    float _S250 = sine_1 * _S249 * (F32_rsqrt((_S248 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S250 * _S248, _S250 * across_slope_0 * along_slope_0 + cosine_0 * _S249);
}

__device__ float arc_sine_0(float x_26)
{
    float _S251 = (F32_abs((x_26)));
    bool _S252 = _S251 > 0.5f;
    float _S253;
    if(_S252)
    {
        _S253 = 0.5f * (1.0f - _S251);
    }
    else
    {
        _S253 = _S251 * _S251;
    }
    float _S254;
    if(_S252)
    {
        _S254 = (F32_sqrt(((F32_max((_S253), (0.0f))))));
    }
    else
    {
        _S254 = _S251;
    }
    float _S255 = ((((0.04216320067644119f * _S253 + 0.02418131195008755f) * _S253 + 0.04547002539038658f) * _S253 + 0.07495300471782684f) * _S253 + 0.16666752099990845f) * _S253 * _S254 + _S254;
    if(_S252)
    {
        _S253 = 1.57079637050628662f - 2.0f * _S255;
    }
    else
    {
        _S253 = _S255;
    }
    if(x_26 < 0.0f)
    {
        _S253 = - _S253;
    }
    return _S253;
}

__device__ float3  table_colour_0(uint index_6)
{
    return make_float3 (table_number_0(index_6), table_number_0(index_6 + 1U), table_number_0(index_6 + 2U));
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
    Family_0 _S256 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    Family_0 _S257 = slang_ldg_3((&(globalParams_0->families_0)[family_8]));
    return table_albedos_0(_S256.albedo_table_0 + _S257.albedo_stride_0 * thread_7);
}

__device__ float thread_gain_0(uint thread_8, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_8, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_0, float3  room_0)
{
    float3  _S258 = room_0 / max_0(albedo_0, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S258.x), (_S258.y)))), (_S258.z)))), (0.0f))))));
}

__device__ float fibre_gain_0(uint thread_9, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_6, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

__device__ float diffuse_reflection_0(float3  light_0, float3  normal_3, float blend_0)
{
    float _S259 = light_0.z;
    if(_S259 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_1((F32_max((_S259), (0.0f))), (F32_max((dot_0(light_0, normal_3)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_3, float3  tangent_2, float roughness_1)
{
    float _S260 = dot_0(direction_3, tangent_2);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S260 * _S260 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

__device__ float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S261 = roughness_2 * roughness_2;
    float _S262 = squared_along_0 * (1.0f - _S261) + _S261;
    return 0.31830987334251404f * _S261 * roughness_2 / (_S262 * _S262);
}

__device__ float density_between_0(float3  light_1, float3  view_1, float3  tangent_3, float roughness_3)
{
    float3  _S263 = light_1 + view_1;
    float _S264 = dot_0(_S263, tangent_3);
    return flake_density_0((F32_min((_S264 * _S264 / (F32_max((square_0(_S263)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float transmission_0(float3  light_2, float3  view_2, float3  normal_4, float3  tangent_4, float roughness_4, float optical_depth_1)
{
    float _S265 = - dot_0(light_2, normal_4);
    float _S266 = dot_0(view_2, normal_4);
    bool _S267;
    if(_S265 <= 0.0f)
    {
        _S267 = true;
    }
    else
    {
        _S267 = _S266 <= 0.0f;
    }
    if(_S267)
    {
        return 0.0f;
    }
    float _S268 = 1.0f / (F32_max((_S266), (9.99999997475242708e-07f)));
    float _S269 = projected_area_1(light_2, tangent_4, roughness_4) / (F32_max((_S265), (9.99999997475242708e-07f)));
    float _S270 = projected_area_1(view_2, tangent_4, roughness_4) * _S268;
    return density_between_0(light_2, view_2, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * (F32_min((_S269), (_S270)))) * mean_attenuation_0(optical_depth_1 * (F32_abs((_S269 - _S270)))) * _S268;
}

__device__ float reflection_0(float3  light_3, float3  view_3, float3  normal_5, float3  tangent_5, float roughness_5, float optical_depth_2)
{
    float _S271 = dot_0(light_3, normal_5);
    bool _S272;
    if(_S271 <= 0.0f)
    {
        _S272 = true;
    }
    else
    {
        _S272 = (dot_0(view_3, normal_5)) <= 0.0f;
    }
    if(_S272)
    {
        return 0.0f;
    }
    float _S273 = (F32_max((_S271), (9.99999997475242708e-07f)));
    float _S274 = (F32_max((dot_0(view_3, normal_5)), (9.99999997475242708e-07f)));
    float _S275 = projected_area_1(light_3, tangent_5, roughness_5) * _S274 + projected_area_1(view_3, tangent_5, roughness_5) * _S273;
    float _S276 = optical_depth_2 * _S275 / (_S273 * _S274);
    return 0.25f * density_between_0(light_3, view_3, tangent_5, roughness_5) * (_S276 * mean_attenuation_0(_S276)) * _S273 / _S275;
}

__device__ Components_0 with_added_0(Components_0 * sums_0, Components_0 * more_0, float weight_0)
{
    Components_0 result_12;
    (&result_12)->diffuse_warp_0 = sums_0->diffuse_warp_0 + weight_0 * more_0->diffuse_warp_0;
    (&result_12)->diffuse_weft_0 = sums_0->diffuse_weft_0 + weight_0 * more_0->diffuse_weft_0;
    (&result_12)->specular_warp_0 = sums_0->specular_warp_0 + weight_0 * more_0->specular_warp_0;
    (&result_12)->specular_weft_0 = sums_0->specular_weft_0 + weight_0 * more_0->specular_weft_0;
    (&result_12)->light_visibility_1 = sums_0->light_visibility_1 + weight_0 * more_0->light_visibility_1;
    (&result_12)->hole_2 = sums_0->hole_2 + weight_0 * more_0->hole_2;
    return result_12;
}

__device__ float wrapped_cell_0(float position_4, float count_2)
{
    return (F32_min(((F32_floor(((position_4 - (F32_floor((position_4)))) * count_2)))), (count_2 - 1.0f)));
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
    float _S277 = (F32_abs((x_28)));
    float _S278 = (F32_abs((y_13)));
    float angle_0 = arc_tangent_of_ratio_0((F32_min((_S277), (_S278))) / (F32_max(((F32_max((_S277), (_S278)))), (1.00000000317107685e-30f))));
    float angle_1;
    if(_S278 > _S277)
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

__device__ NodeTaps_0 node_taps_0(float3  direction_4)
{
    float _S279 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    float _S280 = (F32_floor((_S279)));
    float _S281 = _S279 - _S280;
    float _S282 = (F32_sqrt((clamp_1((1.0f - (F32_abs((direction_4.z)))) / 0.97000002861022949f, 0.0f, 1.0f))));
    float _S283 = 7.0f * _S282 * (F32_sqrt((_S282)));
    float _S284 = (F32_min(((F32_floor((_S283)))), (6.0f)));
    float _S285 = _S283 - _S284;
    uint _S286 = uint(int(_S280) + int(32)) % 32U;
    uint _S287 = uint(_S284);
    uint _S288 = _S286 * 8U + _S287;
    uint _S289 = (_S286 + 1U) % 32U * 8U + _S287;
    NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = make_uint4 (_S288, _S288 + 1U, _S289, _S289 + 1U);
    float _S290 = 1.0f - _S281;
    float _S291 = 1.0f - _S285;
    float4  _S292 = make_float4 (_S290 * _S291, _S290 * _S285, _S281 * _S291, _S281 * _S285) * make_float4 (252.0f) + make_float4 (0.5f);
    uint4  _S293 = make_uint4 ((uint)_S292.x, (uint)_S292.y, (uint)_S292.z, (uint)_S292.w);
    (&taps_0)->weights_0 = _S293;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S293.x + _S293.y + _S293.z + _S293.w);
    return taps_0;
}

__device__ float3  half_vector_0(float3  light_4, float3  view_4)
{
    float3  _S294 = light_4 + view_4;
    return _S294 * make_float3 ((F32_rsqrt(((F32_max((square_0(_S294)), (9.999999960041972e-13f)))))));
}

__device__ float3  shadow_correlation_0(float3  light_5, float3  view_5)
{
    float2  _S295 = float2 {light_5.x, light_5.y};
    float2  _S296 = float2 {view_5.x, view_5.y};
    float _S297 = dot_1(_S295, _S296) / (F32_max(((F32_sqrt((dot_1(_S295, _S295) * dot_1(_S296, _S296))))), (9.99999997475242708e-07f)));
    if((light_5.z) < 0.0f)
    {
        return make_float3 (make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S297).x, make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S297).y, 0.0f);
    }
    return make_float3 ((F32_min((0.62000000476837158f + 0.62999999523162842f * _S297), (1.20000004768371582f))), 0.62000000476837158f, 0.37000000476837158f);
}

__device__ float4  bytes_of_sums_0(uint even_0, uint odd_0)
{
    return make_float4 (float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

__device__ float4  interpolate_0(NodeTaps_0 * taps_1, uint4  packs_2)
{
    uint4  _S298 = (packs_2 & make_uint4 (16711935U)) * taps_1->weights_0;
    uint4  _S299 = ((packs_2 >> make_uint4 (int(8))) & make_uint4 (16711935U)) * taps_1->weights_0;
    return bytes_of_sums_0(_S298.x + _S298.y + _S298.z + _S298.w, _S299.x + _S299.y + _S299.z + _S299.w) * make_float4 (taps_1->inverse_sum_0);
}

__device__ float4  interpolate_table_0(NodeTaps_0 * taps_2, uint table_1, uint stride_0)
{
    uint4  _S300 = make_uint4 (table_1) + taps_2->nodes_0 * make_uint4 (stride_0);
    uint _S301 = __ldg((&(globalParams_0->words_0)[_S300.x]));
    uint _S302 = __ldg((&(globalParams_0->words_0)[_S300.y]));
    uint _S303 = __ldg((&(globalParams_0->words_0)[_S300.z]));
    uint _S304 = __ldg((&(globalParams_0->words_0)[_S300.w]));
    float4  _S305 = interpolate_0(taps_2, make_uint4 (_S301, _S302, _S303, _S304));
    return _S305;
}

struct Group_0
{
    float3  normal_6;
    float weight_1;
    float3  tangent_6;
    float3  variance_0;
    float3  covariance_0;
    float roughness_6;
};

__device__ Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    (&group_0)->normal_6 = make_float3 (table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    (&group_0)->weight_1 = table_number_0(row_1 + 3U);
    float3  _S306 = make_float3 (table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    (&group_0)->tangent_6 = _S306;
    float _S307 = table_number_0(row_1 + 7U);
    float _S308 = table_number_0(row_1 + 8U);
    (&group_0)->variance_0 = make_float3 (_S307, _S308, 1.0f - square_0(_S306) - _S307 - _S308);
    (&group_0)->covariance_0 = make_float3 (table_number_0(row_1 + 9U), table_number_0(row_1 + 10U), table_number_0(row_1 + 11U));
    (&group_0)->roughness_6 = roughness_7;
    return group_0;
}

__device__ float2  visibility_gain_0(float3  correlations_0, float from_light_0, float from_view_0)
{
    return max_1(float2 {correlations_0.x, correlations_0.y} * make_float2 (1.0f / (F32_max(((F32_max((from_light_0), (from_view_0)))), (0.00392156885936856f))) - 1.0f) + make_float2 (1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), make_float2 (0.0f));
}

__device__ float Group_variance_along_0(Group_0 * this_5, float3  direction_5)
{
    float _S309 = direction_5.x;
    float _S310 = direction_5.y;
    float _S311 = direction_5.z;
    return (F32_max((dot_0(this_5->variance_0, direction_5 * direction_5) + 2.0f * dot_0(this_5->covariance_0, make_float3 (_S309 * _S310, _S309 * _S311, _S310 * _S311))), (0.0f)));
}

__device__ float mean_area_0(Group_0 * group_1, float3  direction_6)
{
    float _S312 = dot_0(direction_6, group_1->tangent_6);
    float _S313 = _S312 * _S312;
    float _S314 = Group_variance_along_0(group_1, direction_6);
    float _S315 = group_1->roughness_6 * group_1->roughness_6;
    return (F32_sqrt(((F32_max(((_S315 - 1.0f) * (_S313 + _S314) + 1.0f), (_S315))))));
}

__device__ float mean_density_0(Group_0 * group_2, float3  half_0)
{
    float _S316 = group_2->roughness_6;
    float _S317 = (F32_max(((F32_sqrt(((F32_max((1.0f - group_2->roughness_6 * group_2->roughness_6), (0.0f)))))) / group_2->roughness_6), (0.00100000004749745f)));
    float _S318 = Group_variance_along_0(group_2, half_0);
    float _S319 = (F32_max(((F32_sqrt((3.0f * _S318)))), (_S316 * 0.01999999955296516f + 0.00009999999747379f)));
    float _S320 = dot_0(half_0, group_2->tangent_6);
    float _S321 = _S317 * (_S320 - _S319);
    float _S322 = _S317 * (_S320 + _S319);
    float _S323 = _S321 * _S322;
    float _S324 = 2.0f * _S319 * _S317;
    return 0.15915493667125702f / _S316 * ((1.0f - _S323) / ((_S321 * _S321 + 1.0f) * (_S322 * _S322 + 1.0f)) + arc_tangent_0(_S324, 1.0f + _S323) / _S324);
}

__device__ float layer_value_0(Group_0 * group_3, float3  half_1, float3  light_6, float3  view_6, float optical_depth_3)
{
    bool _S325 = (light_6.z) < 0.0f;
    float3  _S326 = group_3->normal_6;
    float _S327 = dot_0(light_6, group_3->normal_6);
    float _S328;
    if(_S325)
    {
        _S328 = - _S327;
    }
    else
    {
        _S328 = _S327;
    }
    float _S329 = (F32_max((_S328), (0.01999999955296516f)));
    float _S330 = (F32_max((dot_0(view_6, _S326)), (0.01999999955296516f)));
    float _S331 = mean_area_0(group_3, light_6);
    float _S332 = _S331 / _S329;
    float _S333 = mean_area_0(group_3, view_6);
    float _S334 = _S333 / _S330;
    if(_S325)
    {
        _S328 = (F32_abs((_S332 - _S334)));
    }
    else
    {
        _S328 = _S332 + _S334;
    }
    float _S335 = optical_depth_3 * (F32_max((_S328), (0.00100000004749745f)));
    if(_S325)
    {
        _S328 = exponential_0(- optical_depth_3 * (F32_min((_S332), (_S334))));
    }
    else
    {
        _S328 = 1.0f;
    }
    float _S336 = optical_depth_3 * _S328 * (1.0f - exponential_0(- _S335)) / _S335 / _S330;
    if(_S325)
    {
        _S328 = 1.0f;
    }
    else
    {
        _S328 = 1.0f - 0.34999999403953552f * (1.0f - square_0(_S326));
    }
    float _S337 = mean_density_0(group_3, half_1);
    return 0.25f * _S337 * _S328 * _S336;
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

__device__ Bound_0 bound_at_0(uint family_9, float position_5)
{
    Cell_0 _S338 = locate_0(family_9, position_5);
    Family_0 _S339 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
    float _S340 = table_number_0(_S339.before_0 + 2U * _S338.thread_1 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_10 = _S338.thread_1;
    Family_0 _S341 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
    float _S342 = position_5 - _S341.start_0 - _S340 - _S338.below_0;
    Family_0 _S343 = slang_ldg_3((&(globalParams_0->families_0)[family_9]));
    (&bound_0)->turns_2 = (F32_round((_S342 * _S343.inverse_period_0)));
    (&bound_0)->cell_7 = _S338.below_0;
    float _S344 = 2.0f * _S338.half_width_1;
    (&bound_0)->width_1 = _S344;
    (&bound_0)->visible_0 = clamp_1((_S338.across_2 + _S338.half_width_1) / _S344, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S338.below_0), (_S338.below_0 - _S338.across_2 - _S338.half_width_1))) + (F32_max((_S338.across_2 - _S338.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_1;
    Bound_0 high_1;
};

__device__ Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1)
{
    Family_0 _S345 = slang_ldg_3((&(globalParams_0->families_0)[family_10]));
    float _S346 = centre_1 - _S345.start_0;
    Family_0 _S347 = slang_ldg_3((&(globalParams_0->families_0)[family_10]));
    float _S348 = (F32_floor((_S346 * _S347.inverse_period_0)));
    Family_0 _S349 = slang_ldg_3((&(globalParams_0->families_0)[family_10]));
    float _S350 = centre_1 - _S348 * _S349.period_0;
    Family_0 _S351 = slang_ldg_3((&(globalParams_0->families_0)[family_10]));
    float _S352 = 0.5f * (F32_max((size_1), (_S351.smallest_box_0)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_1 = bound_at_0(family_10, _S350 - _S352);
    (&stretch_0)->high_1 = bound_at_0(family_10, _S350 + _S352);
    return stretch_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_6)
{
    return (&this_6->high_1)->turns_2 - (&this_6->low_1)->turns_2;
}

__device__ float3  lengths_0(uint family_11, Stretch_0 * stretch_1)
{
    float _S353 = Stretch_turns_0(stretch_1);
    Family_0 _S354 = slang_ldg_3((&(globalParams_0->families_0)[family_11]));
    uint _S355 = _S354.before_0 + 2U * (&stretch_1->low_1)->thread_10;
    Family_0 _S356 = slang_ldg_3((&(globalParams_0->families_0)[family_11]));
    uint _S357 = _S356.before_0 + 2U * (&stretch_1->high_1)->thread_10;
    float _S358 = table_number_0(_S357) - table_number_0(_S355);
    float _S359 = table_number_0(_S357 + 1U) - table_number_0(_S355 + 1U);
    float _S360 = _S358 + (&stretch_1->high_1)->visible_0 * (&stretch_1->high_1)->width_1 - (&stretch_1->low_1)->visible_0 * (&stretch_1->low_1)->width_1;
    Family_0 _S361 = slang_ldg_3((&(globalParams_0->families_0)[family_11]));
    float _S362 = _S360 + _S353 * _S361.visible_total_0;
    float _S363 = _S359 - _S358 + (&stretch_1->high_1)->gap_0 - (&stretch_1->low_1)->gap_0;
    Family_0 _S364 = slang_ldg_3((&(globalParams_0->families_0)[family_11]));
    Family_0 _S365 = slang_ldg_3((&(globalParams_0->families_0)[family_11]));
    float _S366 = _S363 + _S353 * (_S364.period_0 - _S365.visible_total_0);
    float _S367 = _S359 + (&stretch_1->high_1)->cell_7 - (&stretch_1->low_1)->cell_7;
    Family_0 _S368 = slang_ldg_3((&(globalParams_0->families_0)[family_11]));
    return make_float3 (_S362, _S366, _S367 + _S353 * _S368.period_0);
}

__device__ float2  integrals_along_0(uint family_12, Stretch_0 * stretch_2, uint quantity_0)
{
    Family_0 _S369 = slang_ldg_3((&(globalParams_0->families_0)[family_12]));
    Family_0 _S370 = slang_ldg_3((&(globalParams_0->families_0)[family_12]));
    uint _S371 = 3U * _S369.quantities_0;
    uint _S372 = _S370.colour_threads_0 + _S371 * (&stretch_2->low_1)->thread_10 + quantity_0;
    Family_0 _S373 = slang_ldg_3((&(globalParams_0->families_0)[family_12]));
    uint _S374 = _S373.colour_threads_0 + _S371 * (&stretch_2->high_1)->thread_10 + quantity_0;
    Family_0 _S375 = slang_ldg_3((&(globalParams_0->families_0)[family_12]));
    Family_0 _S376 = slang_ldg_3((&(globalParams_0->families_0)[family_12]));
    uint _S377 = _S375.colour_threads_0 + _S371 * uint(_S376.count_0) + quantity_0;
    float _S378 = table_number_0(_S372);
    float _S379 = table_number_0(_S374);
    float _S380 = Stretch_turns_0(stretch_2);
    uint _S381 = 2U * _S369.quantities_0;
    return make_float2 (table_number_0(_S374 + _S369.quantities_0) - table_number_0(_S372 + _S369.quantities_0) + _S379 * (&stretch_2->high_1)->visible_0 * (&stretch_2->high_1)->width_1 - _S378 * (&stretch_2->low_1)->visible_0 * (&stretch_2->low_1)->width_1 + _S380 * table_number_0(_S377 + _S369.quantities_0), table_number_0(_S374 + _S381) - table_number_0(_S372 + _S381) + _S379 * (&stretch_2->high_1)->cell_7 - _S378 * (&stretch_2->low_1)->cell_7 + _S380 * table_number_0(_S377 + _S381));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_7)
{
    return ((&this_7->high_1)->thread_10) < ((&this_7->low_1)->thread_10);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_8, uint4  entries_0, uint whole_0)
{
    uint _S382 = entries_0.z;
    uint _S383 = entries_0.x;
    uint _S384 = _S382 - _S383;
    bool _S385 = Stretch_wraps_0(this_8);
    uint _S386;
    if(_S385)
    {
        _S386 = whole_0;
    }
    else
    {
        _S386 = 0U;
    }
    return make_uint4 (_S384 + _S386, entries_0.w - _S382, entries_0.y - _S383, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_4, uint row_2, uint count_3, uint quantities_1)
{
    uint _S387 = row_2 + (&across_4->low_1)->thread_10 * quantities_1;
    uint _S388 = row_2 + (&across_4->high_1)->thread_10 * quantities_1;
    uint _S389 = __ldg((&(globalParams_0->words_0)[_S387]));
    uint _S390 = __ldg((&(globalParams_0->words_0)[_S387 + quantities_1]));
    uint _S391 = __ldg((&(globalParams_0->words_0)[_S388]));
    uint _S392 = __ldg((&(globalParams_0->words_0)[_S388 + quantities_1]));
    uint4  _S393 = make_uint4 (_S389, _S390, _S391, _S392);
    uint _S394 = __ldg((&(globalParams_0->words_0)[row_2 + count_3 * quantities_1]));
    uint4  _S395 = Stretch_differences_0(across_4, _S393, _S394);
    return _S395;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_9)
{
    float _S396 = (&this_9->high_1)->visible_0;
    float _S397 = - (&this_9->low_1)->visible_0;
    float _S398 = Stretch_turns_0(this_9);
    bool _S399 = Stretch_wraps_0(this_9);
    float _S400;
    if(_S399)
    {
        _S400 = 1.0f;
    }
    else
    {
        _S400 = 0.0f;
    }
    return make_float4 (1.0f, _S396, _S397, _S398 - _S400);
}

__device__ float integral_on_top_0(uint family_13, Stretch_0 * across_5, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    Family_0 _S401 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    uint _S402 = uint(_S401.count_0);
    uint _S403 = _S402 + 1U;
    Family_0 _S404 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    uint _S405 = _S403 * _S404.quantities_0;
    Family_0 _S406 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    uint _S407 = _S406.colour_areas_0 + quantity_1;
    uint _S408 = (&along_0->low_1)->thread_10;
    uint _S409 = _S407 + (&along_0->low_1)->thread_10 * _S405;
    Family_0 _S410 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    uint4  _S411 = row_differences_0(across_5, _S409, _S402, _S410.quantities_0);
    uint _S412 = _S407 + (_S408 + 1U) * _S405;
    Family_0 _S413 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    uint4  _S414 = row_differences_0(across_5, _S412, _S402, _S413.quantities_0);
    uint _S415 = (&along_0->high_1)->thread_10;
    uint _S416 = _S407 + (&along_0->high_1)->thread_10 * _S405;
    Family_0 _S417 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    uint4  _S418 = row_differences_0(across_5, _S416, _S402, _S417.quantities_0);
    uint _S419 = _S407 + (_S415 + 1U) * _S405;
    Family_0 _S420 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    uint4  _S421 = row_differences_0(across_5, _S419, _S402, _S420.quantities_0);
    uint _S422 = _S407 + crossing_count_0 * _S405;
    Family_0 _S423 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    uint4  _S424 = row_differences_0(across_5, _S422, _S402, _S423.quantities_0);
    uint4  _S425 = _S418 - _S411;
    bool _S426 = Stretch_wraps_0(along_0);
    uint4  _S427;
    if(_S426)
    {
        _S427 = _S424;
    }
    else
    {
        int4  _S428 = make_int4 (int(0));
        uint4  _S429 = make_uint4 ((uint)_S428.x, (uint)_S428.y, (uint)_S428.z, (uint)_S428.w);
        _S427 = _S429;
    }
    uint4  _S430 = _S425 + _S427;
    float4  _S431 = Stretch_weights_0(across_5);
    float4  _S432 = Stretch_weights_0(along_0);
    int4  _S433 = make_int4 ((int)_S430.x, (int)_S430.y, (int)_S430.z, (int)_S430.w);
    float4  _S434 = make_float4 ((float)_S433.x, (float)_S433.y, (float)_S433.z, (float)_S433.w);
    uint4  _S435 = _S421 - _S418;
    int4  _S436 = make_int4 ((int)_S435.x, (int)_S435.y, (int)_S435.z, (int)_S435.w);
    float4  _S437 = make_float4 ((float)_S436.x, (float)_S436.y, (float)_S436.z, (float)_S436.w);
    uint4  _S438 = _S414 - _S411;
    int4  _S439 = make_int4 ((int)_S438.x, (int)_S438.y, (int)_S438.z, (int)_S438.w);
    float4  _S440 = make_float4 ((float)_S439.x, (float)_S439.y, (float)_S439.z, (float)_S439.w);
    int4  _S441 = make_int4 ((int)_S424.x, (int)_S424.y, (int)_S424.z, (int)_S424.w);
    float4  _S442 = make_float4 ((float)_S441.x, (float)_S441.y, (float)_S441.z, (float)_S441.w);
    float _S443 = dot_2(make_float4 (dot_2(_S434, _S431), dot_2(_S437, _S431), dot_2(_S440, _S431), dot_2(_S442, _S431)), _S432);
    Family_0 _S444 = slang_ldg_3((&(globalParams_0->families_0)[family_13]));
    return _S443 * _S444.area_unit_0;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_2, uint row_3)
{
    Albedos_0 _S445 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_2) * _S445.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_2) * _S445.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_2) * _S445.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_2) * _S445.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, Stretch_0 * own_1, Stretch_0 * other_2, bool back_3)
{
    Family_0 _S446 = slang_ldg_3((&(globalParams_0->families_0)[family_14]));
    Albedos_0 albedos_2 = table_albedos_0(_S446.colour_mean_0);
    Family_0 _S447 = slang_ldg_3((&(globalParams_0->families_0)[family_14]));
    if((_S447.quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3  _S448 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_3 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        Family_0 _S449 = slang_ldg_3((&(globalParams_0->families_0)[family_14]));
        if(quantity_2 < (_S449.quantities_0))
        {
        }
        else
        {
            break;
        }
        float2  _S450 = integrals_along_0(family_14, own_1, quantity_2);
        Family_0 _S451 = slang_ldg_3((&(globalParams_0->families_0)[crossing_1]));
        float _S452 = integral_on_top_0(family_14, own_1, other_2, uint(_S451.count_0), quantity_2);
        float _S453 = _S450.x;
        float _S454 = _S453 * _S448.x;
        float _S455;
        if(back_3)
        {
            _S455 = _S454 - _S452;
        }
        else
        {
            _S455 = _S452;
        }
        bool _S456 = quantity_2 == 0U;
        if(_S456)
        {
            Family_0 _S457 = slang_ldg_3((&(globalParams_0->families_0)[family_14]));
            float _S458 = 16.0f * _S457.area_unit_0;
            Family_0 _S459 = slang_ldg_3((&(globalParams_0->families_0)[family_14]));
            is_exposed_0 = _S455 > (_S458 * (F32_min((_S454 / _S459.crossing_area_0), (1.0f))) + 0.00000999999974738f * _S454);
        }
        float _S460 = _S453 * _S448.y;
        float _S461;
        if(is_exposed_0)
        {
            _S461 = _S455;
        }
        else
        {
            _S461 = 0.0f;
        }
        float _S462 = _S460 + _S461 + 0.000244140625f * _S448.z * _S450.y;
        if(_S456)
        {
            weight_3 = 1.0f / (F32_max((_S462), (9.99999968265522539e-21f)));
        }
        else
        {
            float _S463 = _S462 * weight_3;
            Family_0 _S464 = slang_ldg_3((&(globalParams_0->families_0)[family_14]));
            uint _S465 = _S464.colour_axes_0 + 12U * (quantity_2 - 1U);
            Albedos_0 _S466 = albedos_2;
            Albedos_0 _S467 = with_added_albedos_0(&_S466, _S463, _S465);
            albedos_2 = _S467;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate_0((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate_0((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate_0((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate_0((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

__device__ Albedos_0 lerp_albedos_0(Albedos_0 * first_3, Albedos_0 * second_1, float weight_4)
{
    Albedos_0 albedos_3;
    float3  _S468 = make_float3 (weight_4);
    (&albedos_3)->diffuse_reflect_0 = lerp_0(first_3->diffuse_reflect_0, second_1->diffuse_reflect_0, _S468);
    (&albedos_3)->diffuse_transmit_0 = lerp_0(first_3->diffuse_transmit_0, second_1->diffuse_transmit_0, _S468);
    (&albedos_3)->specular_reflect_0 = lerp_0(first_3->specular_reflect_0, second_1->specular_reflect_0, _S468);
    (&albedos_3)->specular_transmit_0 = lerp_0(first_3->specular_transmit_0, second_1->specular_transmit_0, _S468);
    return albedos_3;
}

__device__ Albedos_0 tinted_0(Albedos_0 * albedos_4, float3  tint_0)
{
    Albedos_0 result_13 = *albedos_4;
    (&result_13)->diffuse_reflect_0 = (&result_13)->diffuse_reflect_0 * tint_0;
    (&result_13)->diffuse_transmit_0 = (&result_13)->diffuse_transmit_0 * tint_0;
    return result_13;
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
    float _S469 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S470 = 2.0f * (F32_sqrt((_S469))) - 1.0f;
    float _S471 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_8, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S470, _S471), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S469) * sheen_shear_0(_S470, _S471), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S470, _S471), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_7, float3  view_7, float scale_0, float shear_0)
{
    float _S472 = light_7.z;
    bool _S473;
    if(_S472 <= 0.0f)
    {
        _S473 = true;
    }
    else
    {
        _S473 = (view_7.z) <= 0.0f;
    }
    if(_S473)
    {
        return 0.0f;
    }
    float2  _S474 = float2 {view_7.x, view_7.y};
    float _S475 = dot_1(_S474, _S474);
    float2  _S476;
    if(_S475 > 9.99999968265522539e-21f)
    {
        _S476 = _S474 * make_float2 ((F32_rsqrt((_S475))));
    }
    else
    {
        _S476 = make_float2 (1.0f, 0.0f);
    }
    float _S477 = scale_0 * dot_1(float2 {light_7.x, light_7.y}, _S476) + shear_0 * _S472;
    float _S478 = scale_0 * (light_7.y * _S476.x - light_7.x * _S476.y);
    float _S479 = _S477 * _S477 + _S478 * _S478 + _S472 * _S472;
    return 0.31830987334251404f * scale_0 * scale_0 * _S472 / (F32_max((_S479 * _S479), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_8, float3  view_8, float strength_0, float roughness_9)
{
    float3  _S480 = sheen_lobe_0(view_8.z, roughness_9);
    float _S481 = strength_0 * _S480.z;
    return make_float2 (_S481 * transformed_cosine_0(light_8, view_8, _S480.x, _S480.y), 1.0f - _S481);
}

__device__ void accumulate_0(uint index_7, float4  light_9)
{
    float4  * _S482 = (&(globalParams_0->radiance_0)[index_7]);
    *_S482 = *_S482 + make_float4 ((&(globalParams_0->layers_0)[index_7])->share_0) * light_9;
    (&(globalParams_0->layers_0)[index_7])->share_0 = (&(globalParams_0->layers_0)[index_7])->share_0 * (1.0f - light_9.w);
    return;
}

__device__ float3  camera_right_0(int _S483)
{
    Frame_0 * _S484 = (&(globalParams_0->frames_0)[_S483]);
    float _S485 = __ldg(&_S484->right_x_0);
    float _S486 = __ldg(&_S484->right_y_0);
    float _S487 = __ldg(&_S484->right_z_0);
    return make_float3 (_S485, _S486, _S487);
}

__device__ float3  camera_up_0(int _S488)
{
    Frame_0 * _S489 = (&(globalParams_0->frames_0)[_S488]);
    float _S490 = __ldg(&_S489->up_x_0);
    float _S491 = __ldg(&_S489->up_y_0);
    float _S492 = __ldg(&_S489->up_z_0);
    return make_float3 (_S490, _S491, _S492);
}

__device__ float3  camera_forward_0(int _S493)
{
    Frame_0 * _S494 = (&(globalParams_0->frames_0)[_S493]);
    float _S495 = __ldg(&_S494->forward_x_0);
    float _S496 = __ldg(&_S494->forward_y_0);
    float _S497 = __ldg(&_S494->forward_z_0);
    return make_float3 (_S495, _S496, _S497);
}

__device__ float3  camera_origin_0(int _S498)
{
    Frame_0 * _S499 = (&(globalParams_0->frames_0)[_S498]);
    float _S500 = __ldg(&_S499->origin_x_0);
    float _S501 = __ldg(&_S499->origin_y_0);
    float _S502 = __ldg(&_S499->origin_z_0);
    return make_float3 (_S500, _S501, _S502);
}

__device__ VisiblePoint_0 face_point_0(uint _S503, uint _S504, float _S505, float _S506)
{
    Fabric_0 * _S507 = (&(globalParams_0->fabrics_0)[_S503]);
    uint _S508 = 3U * _S504;
    uint _S509 = __ldg((&(globalParams_0->corners_0)[_S508]));
    Vertex_0 _S510 = slang_ldg_1((&(globalParams_0->vertices_0)[_S509]));
    uint _S511 = __ldg((&(globalParams_0->corners_0)[_S508 + 1U]));
    Vertex_0 _S512 = slang_ldg_1((&(globalParams_0->vertices_0)[_S511]));
    uint _S513 = __ldg((&(globalParams_0->corners_0)[_S508 + 2U]));
    Vertex_0 _S514 = slang_ldg_1((&(globalParams_0->vertices_0)[_S513]));
    Vertex_0 _S515 = _S512;
    float3  _S516 = position_of_0(&_S515);
    Vertex_0 _S517 = _S510;
    float3  _S518 = position_of_0(&_S517);
    float3  _S519 = _S516 - _S518;
    Vertex_0 _S520 = _S514;
    float3  _S521 = position_of_0(&_S520);
    float3  _S522 = _S521 - _S518;
    float _S523 = _S512.u_0 - _S510.u_0;
    float _S524 = _S512.v_0 - _S510.v_0;
    float2  _S525 = make_float2 (_S523, _S524);
    float _S526 = _S514.u_0 - _S510.u_0;
    float _S527 = _S514.v_0 - _S510.v_0;
    float2  _S528 = make_float2 (_S526, _S527);
    float _S529;
    if((_S523 * _S527 - _S524 * _S526) < 0.0f)
    {
        _S529 = -1.0f;
    }
    else
    {
        _S529 = 1.0f;
    }
    float3  _S530 = make_float3 (_S529) * (make_float3 (_S527) * _S519 - make_float3 (_S524) * _S522);
    float3  _S531 = make_float3 (_S529) * (make_float3 (_S523) * _S522 - make_float3 (_S526) * _S519);
    VisiblePoint_0 point_1;
    float _S532 = 1.0f - _S505 - _S506;
    Vertex_0 _S533 = _S510;
    float3  _S534 = normal_of_0(&_S533);
    float3  _S535 = make_float3 (_S532) * _S534;
    Vertex_0 _S536 = _S512;
    float3  _S537 = normal_of_0(&_S536);
    float3  _S538 = _S535 + make_float3 (_S505) * _S537;
    Vertex_0 _S539 = _S514;
    float3  _S540 = normal_of_0(&_S539);
    float3  _S541 = normalize_0(_S538 + make_float3 (_S506) * _S540);
    (&point_1)->normal_0 = _S541;
    float3  _S542 = normalize_0(_S530 - _S541 * make_float3 (dot_0(_S541, _S530)));
    (&point_1)->axis_x_0 = _S542;
    (&point_1)->axis_y_0 = cross_0(_S541, _S542);
    float3  _S543 = normalize_0(cross_0(_S519, _S522));
    float3  _S544;
    if((dot_0(_S543, _S541)) < 0.0f)
    {
        _S544 = - _S543;
    }
    else
    {
        _S544 = _S543;
    }
    (&point_1)->face_normal_0 = _S544;
    (&point_1)->position_0 = _S518 + make_float3 (_S505) * _S519 + make_float3 (_S506) * _S522;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_1 = make_float2 (_S510.u_0, _S510.v_0) + make_float2 (_S505) * _S525 + make_float2 (_S506) * _S528;
    bool _S545 = (dot_0(cross_0(_S530, _S531), (&point_1)->normal_0)) < 0.0f;
    float _S546 = __ldg(&_S507->uv_width_0);
    if(_S545)
    {
        float _S547 = __ldg(&_S507->uv_height_0);
        _S529 = - _S547;
    }
    else
    {
        float _S548 = __ldg(&_S507->uv_height_0);
        _S529 = _S548;
    }
    float2  _S549 = make_float2 (_S546, _S529);
    (&point_1)->draft_per_uv_0 = _S549;
    float2  _S550 = (&point_1)->uv_1 * _S549;
    if(_S545)
    {
        float _S551 = __ldg(&_S507->uv_height_0);
        _S529 = _S551;
    }
    else
    {
        _S529 = 0.0f;
    }
    (&point_1)->draft_0 = _S550 + make_float2 (0.0f, _S529);
    float2  _S552 = make_float2 (0.0f);
    (&point_1)->draft_dx_0 = _S552;
    (&point_1)->draft_dy_0 = _S552;
    return point_1;
}

__device__ VisiblePoint_0 visible_point_0(int _S553, uint _S554, uint _S555, uint2  _S556)
{
    Frame_0 * _S557 = (&(globalParams_0->frames_0)[_S553]);
    uint _S558 = 3U * _S555;
    uint _S559 = __ldg((&(globalParams_0->corners_0)[_S558]));
    Vertex_0 _S560 = slang_ldg_1((&(globalParams_0->vertices_0)[_S559]));
    uint _S561 = __ldg((&(globalParams_0->corners_0)[_S558 + 1U]));
    Vertex_0 _S562 = slang_ldg_1((&(globalParams_0->vertices_0)[_S561]));
    uint _S563 = __ldg((&(globalParams_0->corners_0)[_S558 + 2U]));
    Vertex_0 _S564 = slang_ldg_1((&(globalParams_0->vertices_0)[_S563]));
    Vertex_0 _S565 = _S562;
    float3  _S566 = position_of_0(&_S565);
    Vertex_0 _S567 = _S560;
    float3  _S568 = position_of_0(&_S567);
    float3  _S569 = _S566 - _S568;
    Vertex_0 _S570 = _S564;
    float3  _S571 = position_of_0(&_S570);
    float3  _S572 = _S571 - _S568;
    float3  _S573 = cross_0(_S569, _S572);
    float _S574 = 1.0f / (F32_max((square_0(_S573)), (1.00000000317107685e-30f)));
    float3  _S575 = camera_right_0(_S553);
    uint _S576 = __ldg(&_S557->width_0);
    float _S577 = float(_S576);
    float3  _S578 = _S575 * make_float3 (2.0f / _S577);
    float3  _S579 = camera_up_0(_S553);
    uint _S580 = __ldg(&_S557->height_0);
    float _S581 = float(_S580);
    float3  _S582 = _S579 * make_float3 (-2.0f / _S581);
    float _S583 = float(_S556.x) + 0.5f - 0.5f * _S577;
    float _S584 = float(_S556.y) + 0.5f - 0.5f * _S581;
    float3  _S585 = camera_forward_0(_S553);
    float3  _S586 = _S585 + make_float3 (_S583) * _S578 + make_float3 (_S584) * _S582;
    float _S587 = dot_0(_S586, _S573);
    float _S588;
    if((F32_abs((_S587))) > 1.00000000317107685e-30f)
    {
        _S588 = _S587;
    }
    else
    {
        _S588 = 1.00000000317107685e-30f;
    }
    float _S589 = 1.0f / _S588;
    float3  _S590 = camera_origin_0(_S553);
    float3  _S591 = _S568 - _S590;
    float _S592 = dot_0(_S591, _S573) * _S589;
    float3  _S593 = _S586 * make_float3 (_S592) - _S591;
    float3  _S594 = make_float3 (_S592) * (_S578 - _S586 * make_float3 (dot_0(_S578, _S573) * _S589));
    float3  _S595 = make_float3 (_S592) * (_S582 - _S586 * make_float3 (dot_0(_S582, _S573) * _S589));
    float3  _S596 = cross_0(_S572, _S573) * make_float3 (_S574);
    float3  _S597 = cross_0(_S573, _S569) * make_float3 (_S574);
    float2  _S598 = make_float2 (_S562.u_0 - _S560.u_0, _S562.v_0 - _S560.v_0);
    float2  _S599 = make_float2 (_S564.u_0 - _S560.u_0, _S564.v_0 - _S560.v_0);
    VisiblePoint_0 _S600 = face_point_0(_S554, _S555, dot_0(_S593, _S596), dot_0(_S593, _S597));
    VisiblePoint_0 point_2 = _S600;
    (&point_2)->position_0 = _S568 + _S593;
    (&point_2)->view_0 = - normalize_0(_S586);
    (&point_2)->draft_dx_0 = (make_float2 (dot_0(_S594, _S596)) * _S598 + make_float2 (dot_0(_S594, _S597)) * _S599) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (make_float2 (dot_0(_S595, _S596)) * _S598 + make_float2 (dot_0(_S595, _S597)) * _S599) * (&point_2)->draft_per_uv_0;
    return point_2;
}

__device__ float3  filtered_albedo_0(uint _S601, VisiblePoint_0 * _S602)
{
    Fabric_0 * _S603 = (&(globalParams_0->fabrics_0)[_S601]);
    uint _S604 = __ldg(&_S603->albedo_map_levels_0);
    if(_S604 == 0U)
    {
        return make_float3 (1.0f);
    }
    float _S605 = __ldg(&_S603->uv_width_0);
    float _S606 = __ldg(&_S603->uv_height_0);
    float2  _S607 = make_float2 (_S605, _S606);
    float2  _S608 = _S602->draft_dx_0 / _S607;
    float2  _S609 = _S602->draft_dy_0 / _S607;
    uint _S610 = _S604 - 1U;
    uint _S611 = 1U << _S610;
    float _S612 = clamp_1(0.5f * binary_logarithm_0((F32_max(((F32_abs((_S608.x * _S609.y - _S608.y * _S609.x)))), (9.99999968265522539e-21f))) * (square_1(float(_S611)) / 3.0f)), 0.0f, float(_S604) - 1.0f);
    uint _S613 = (U32_min((uint(_S612)), ((U32_max((_S604), (2U))) - 2U)));
    uint _S614 = (U32_min((_S613 + 1U), (_S610)));
    uint _S615 = 1U << (2U * _S604);
    uint _S616 = __ldg(&_S603->albedo_map_0);
    return lerp_0(map_level_0(_S616 + (_S615 - (_S615 >> (2U * _S613))) / 3U, _S611 >> _S613, _S602->uv_1), map_level_0(_S616 + (_S615 - (_S615 >> (2U * _S614))) / 3U, _S611 >> _S614, _S602->uv_1), make_float3 ((exponential_0(1.38629436492919922f * (_S612 - float(_S613))) - 1.0f) / 3.0f));
}

__device__ uint light_sample_count_0(int _S617)
{
    Frame_0 * _S618 = (&(globalParams_0->frames_0)[_S617]);
    uint _S619 = __ldg(&_S618->lights_0);
    uint _S620 = __ldg(&_S618->environment_samples_0);
    return _S619 + _S620;
}

__device__ float visibility_at_0(int _S621, uint _S622, uint2  _S623)
{
    Frame_0 * _S624 = (&(globalParams_0->frames_0)[_S621]);
    uint _S625 = __ldg(&_S624->casts_shadows_0);
    if(_S625 == 0U)
    {
        return 1.0f;
    }
    uint _S626 = __ldg(&_S624->height_0);
    uint _S627 = _S622 * _S626 + _S623.y;
    uint _S628 = __ldg(&_S624->width_0);
    return *(&(globalParams_0->visibilities_0)[_S627 * _S628 + _S623.x]);
}

struct LightSample_0
{
    float3  towards_0;
    float3  irradiance_1;
    float distance_1;
};

__device__ float3  environment_texel_0(int _S629, uint _S630, uint _S631)
{
    Frame_0 * _S632 = (&(globalParams_0->frames_0)[_S629]);
    uint _S633 = __ldg(&_S632->environment_table_0);
    uint _S634 = __ldg(&_S632->environment_rows_0);
    uint _S635 = _S633 + _S634 + 1U;
    uint _S636 = __ldg(&_S632->environment_columns_0);
    uint _S637 = _S635 + _S634 * (_S636 + 1U) + 3U * (_S630 * _S636 + _S631);
    return make_float3 (scene_number_0(_S637), scene_number_0(_S637 + 1U), scene_number_0(_S637 + 2U));
}

__device__ float3  sample_environment_0(int _S638, float2  _S639, float3  * _S640)
{
    Frame_0 * _S641 = (&(globalParams_0->frames_0)[_S638]);
    uint _S642 = __ldg(&_S641->environment_table_0);
    uint _S643 = __ldg(&_S641->environment_rows_0);
    Choice_0 _S644 = choose_0(_S642, _S643, _S639.y);
    uint _S645 = _S642 + _S643 + 1U;
    uint _S646 = __ldg(&_S641->environment_columns_0);
    Choice_0 _S647 = choose_0(_S645 + _S644.index_3 * (_S646 + 1U), _S646, _S639.x);
    float3  _S648 = environment_texel_0(_S638, _S644.index_3, _S647.index_3);
    float _S649 = __ldg(&_S641->environment_total_0);
    *_S640 = _S648 * make_float3 (_S649 / (F32_max((mean_0(_S648)), (9.99999968265522539e-21f))));
    float _S650 = 3.14159274101257324f / float(_S643);
    float _S651 = lerp_1(sine_cosine_0(float(_S644.index_3) * _S650).y, sine_cosine_0(float(_S644.index_3 + 1U) * _S650).y, _S644.remainder_0);
    float _S652 = (F32_sqrt(((F32_max((1.0f - _S651 * _S651), (0.0f))))));
    float2  _S653 = sine_cosine_0((float(_S647.index_3) + _S647.remainder_0) * (6.28318548202514648f / float(_S646)));
    float _S654 = _S652 * _S653.x;
    float _S655 = - _S652 * _S653.y;
    float _S656 = __ldg(&_S641->environment_cosine_0);
    float _S657 = _S656 * _S654;
    float _S658 = __ldg(&_S641->environment_sine_0);
    return make_float3 (_S657 + _S658 * _S655, _S651, _S656 * _S655 - _S658 * _S654);
}

__device__ LightSample_0 light_sample_0(int _S659, uint _S660, uint2  _S661, float3  _S662)
{
    Frame_0 * _S663 = (&(globalParams_0->frames_0)[_S659]);
    LightSample_0 sample_0;
    (&sample_0)->distance_1 = 1.00000001504746622e+30f;
    uint _S664 = __ldg(&_S663->lights_0);
    if(_S660 >= _S664)
    {
        uint _S665 = __ldg(&_S663->pass_number_0);
        uint _S666 = __ldg(&_S663->environment_samples_0);
        float3  weight_5;
        float3  _S667 = sample_environment_0(_S659, pixel_sequence_0(_S661, _S665 * _S666 + (_S660 - _S664), 3U), &weight_5);
        (&sample_0)->towards_0 = _S667;
        (&sample_0)->irradiance_1 = weight_5 / make_float3 (float(_S666));
        return sample_0;
    }
    Light_0 _S668 = slang_ldg_2((&(globalParams_0->lights_1)[_S660]));
    (&sample_0)->irradiance_1 = make_float3 (_S668.red_0, _S668.green_0, _S668.blue_0);
    (&sample_0)->towards_0 = make_float3 (_S668.x_0, _S668.y_0, _S668.z_0);
    if((_S668.is_point_0) != 0U)
    {
        float3  _S669 = (&sample_0)->towards_0 - _S662;
        float _S670 = (F32_max((square_0(_S669)), (9.999999960041972e-13f)));
        (&sample_0)->distance_1 = (F32_sqrt((_S670)));
        (&sample_0)->irradiance_1 = (&sample_0)->irradiance_1 / make_float3 (_S670);
        (&sample_0)->towards_0 = normalize_0(_S669);
    }
    return sample_0;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_2;
    Albedos_0 weft_2;
};

struct Estimate_0
{
    Components_0 components_0;
    FamilyAlbedos_0 albedos_5;
};

struct Regime_0
{
    float prefiltered_0;
    float threads_1;
    float points_1;
};

__device__ Regime_0 regime_of_0(uint _S671, Footprint_0 * _S672, float _S673)
{
    Fabric_0 * _S674 = (&(globalParams_0->fabrics_0)[_S671]);
    float _S675 = Footprint_spread_side_0(_S672);
    float _S676 = binary_logarithm_0((F32_max((_S675), (9.99999971718068537e-10f))));
    Lobes_0 _S677 = slang_ldg_0(&_S674->lobes_0);
    float _S678 = clamp_1((_S676 - _S677.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S679 = _S678 * _S678 * (3.0f - 2.0f * _S678);
    (&regime_0)->prefiltered_0 = _S679;
    (&regime_0)->threads_1 = _S675 * _S677.threads_per_mm_0;
    float _S680 = lerp_1((F32_max((8.0f / _S673), (1.0f))), 1.0f, _S679);
    float _S681;
    if(_S679 < 1.0f)
    {
        _S681 = clamp_1((&regime_0)->threads_1 * 12.0f, 1.0f, _S680);
    }
    else
    {
        _S681 = 0.0f;
    }
    (&regime_0)->points_1 = _S681;
    return regime_0;
}

struct Hit_0
{
    float x_32;
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

__device__ Crossing_0 crossing_at_0(uint _S682, float _S683, float _S684, bool _S685)
{
    Fabric_0 * _S686 = (&(globalParams_0->fabrics_0)[_S682]);
    Crossing_0 crossing_3;
    uint _S687 = __ldg(&_S686->warp_0);
    (&crossing_3)->warp_1 = locate_0(_S687, _S683);
    uint _S688 = __ldg(&_S686->weft_0);
    (&crossing_3)->weft_1 = locate_0(_S688, _S684);
    uint _S689 = __ldg(&_S686->run_words_0);
    uint _S690 = (&(&crossing_3)->weft_1)->thread_1;
    uint _S691 = __ldg(&_S686->ends_1);
    uint _S692 = _S689 + 2U * (_S690 * _S691 + (&(&crossing_3)->warp_1)->thread_1);
    uint _S693 = __ldg((&(globalParams_0->words_0)[_S692]));
    (&crossing_3)->warp_word_0 = _S693;
    uint _S694 = __ldg((&(globalParams_0->words_0)[_S692 + 1U]));
    (&crossing_3)->weft_word_0 = _S694;
    (&crossing_3)->warp_above_0 = ((_S693 & 1U) == 1U) != _S685;
    return crossing_3;
}

__device__ Sample_0 sample_at_0(uint _S695, float _S696, float _S697, bool _S698)
{
    Fabric_0 * _S699 = (&(globalParams_0->fabrics_0)[_S695]);
    Sample_0 sample_1;
    Crossing_0 _S700 = crossing_at_0(_S695, _S696, _S697, _S698);
    (&sample_1)->crossing_2 = _S700;
    Crossing_0 _S701 = _S700;
    Shown_0 _S702 = shown_at_0(&_S701, _S698);
    (&sample_1)->shown_3 = _S702;
    uint _S703;
    if(_S702.is_warp_2)
    {
        uint _S704 = __ldg(&_S699->warp_0);
        _S703 = _S704;
    }
    else
    {
        uint _S705 = __ldg(&_S699->weft_0);
        _S703 = _S705;
    }
    uint _S706;
    if(_S702.is_warp_2)
    {
        uint _S707 = __ldg(&_S699->weft_0);
        _S706 = _S707;
    }
    else
    {
        uint _S708 = __ldg(&_S699->warp_0);
        _S706 = _S708;
    }
    Cell_0 _S709 = (&(&sample_1)->crossing_2)->warp_1;
    Cell_0 _S710 = (&(&sample_1)->crossing_2)->weft_1;
    Cell_0 _S711 = select_cell_0(_S702.is_warp_2, &_S709, &_S710);
    Cell_0 _S712 = (&(&sample_1)->crossing_2)->weft_1;
    Cell_0 _S713 = (&(&sample_1)->crossing_2)->warp_1;
    Cell_0 _S714 = select_cell_0(_S702.is_warp_2, &_S712, &_S713);
    Cell_0 _S715 = _S714;
    Run_0 _S716 = unpack_0(_S703, _S706, _S711.thread_1, &_S715, _S702.word_0);
    Cell_0 _S717 = _S711;
    Section_0 _S718 = section_at_0(&_S717);
    bool _S719;
    if(_S702.on_top_0)
    {
        _S719 = (_S716.distance_0) < (_S718.drop_0 * _S716.bend_1.sine_0);
    }
    else
    {
        _S719 = false;
    }
    bool _S720;
    if(_S702.on_top_0)
    {
        _S720 = !_S719;
    }
    else
    {
        _S720 = false;
    }
    float _S721;
    if(_S720)
    {
        _S721 = 1.0f;
    }
    else
    {
        _S721 = -1.0f;
    }
    float _S722;
    if(_S719)
    {
        _S722 = _S716.other_reach_0;
    }
    else
    {
        _S722 = _S716.reach_0;
    }
    float _S723;
    if(_S719)
    {
        _S723 = _S722 + _S716.distance_0;
    }
    else
    {
        _S723 = (F32_max((_S722 - _S716.distance_0), (0.0f)));
    }
    float _S724 = _S722 / _S716.bend_1.sine_0 - _S721 * _S718.drop_0;
    float _S725 = _S723 * _S723;
    float _S726 = (F32_max((_S724 * _S724 - _S725), (9.99999968265522539e-21f)));
    float _S727 = (F32_rsqrt((_S726)));
    float _S728 = _S725 / (_S726 * _S727 + _S724);
    bool _S729 = _S723 > 0.0f;
    float _S730;
    if(_S702.on_top_0)
    {
        _S730 = 1.0f;
    }
    else
    {
        _S730 = -1.0f;
    }
    float _S731;
    if(_S716.near_start_0)
    {
        _S731 = 1.0f;
    }
    else
    {
        _S731 = -1.0f;
    }
    float _S732 = _S730 * _S731;
    if(_S729)
    {
        _S730 = _S724 * _S727;
    }
    else
    {
        _S730 = 1.0f;
    }
    (&sample_1)->slope_across_0 = _S718.slope_0 * _S730;
    if(_S729)
    {
        _S723 = _S732 * _S723 * _S727;
    }
    else
    {
        _S723 = 0.0f;
    }
    (&sample_1)->slope_along_0 = _S723;
    Family_0 _S733 = slang_ldg_3((&(globalParams_0->families_0)[_S703]));
    Shown_0 _S734 = _S702;
    Run_0 _S735 = _S716;
    Cell_0 _S736 = _S714;
    float2  _S737 = dive_0(_S706, &_S734, &_S735, &_S736);
    if(_S716.straight_0)
    {
        _S721 = 0.0f;
    }
    else
    {
        _S721 = _S733.height_scale_0 * _S721;
    }
    (&sample_1)->height_6 = _S721 * (_S722 * _S716.bend_1.half_tangent_0 - _S728) - _S733.height_scale_0 * _S718.drop_0 - _S737.x;
    float _S738 = _S733.height_scale_0 * (&sample_1)->slope_across_0;
    float _S739 = _S733.height_scale_0 * (&sample_1)->slope_along_0 - _S737.y;
    if(_S702.is_warp_2)
    {
        _S721 = _S738;
    }
    else
    {
        _S721 = _S739;
    }
    (&sample_1)->slope_x_1 = _S721;
    if(_S702.is_warp_2)
    {
        _S721 = _S739;
    }
    else
    {
        _S721 = _S738;
    }
    (&sample_1)->slope_y_1 = _S721;
    (&sample_1)->run_3 = _S716;
    (&sample_1)->section_1 = _S718;
    return sample_1;
}

__device__ float steps_per_length_0(uint _S740, SearchQuality_0 * _S741, float3  _S742)
{
    Fabric_0 * _S743 = (&(globalParams_0->fabrics_0)[_S740]);
    float _S744 = (F32_abs((_S742.x)));
    float _S745 = __ldg(&_S743->threads_per_x_0);
    float _S746 = _S744 * _S745;
    float _S747 = (F32_abs((_S742.y)));
    float _S748 = __ldg(&_S743->threads_per_y_0);
    float _S749 = (F32_max((_S746), (_S747 * _S748))) * _S741->steps_per_thread_0;
    float _S750 = (F32_abs((_S742.z)));
    float _S751 = __ldg(&_S743->per_relief_0);
    return (F32_max((_S749), (_S750 * _S751 * _S741->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S752, Crossing_0 * _S753)
{
    Fabric_0 * _S754 = (&(globalParams_0->fabrics_0)[_S752]);
    bool _S755 = _S753->warp_above_0;
    uint _S756;
    if(_S753->warp_above_0)
    {
        uint _S757 = __ldg(&_S754->warp_0);
        _S756 = _S757;
    }
    else
    {
        uint _S758 = __ldg(&_S754->weft_0);
        _S756 = _S758;
    }
    uint _S759;
    if(_S755)
    {
        _S759 = _S753->warp_word_0;
    }
    else
    {
        _S759 = _S753->weft_word_0;
    }
    float _S760 = float(_S759 >> int(28));
    Family_0 _S761 = slang_ldg_3((&(globalParams_0->families_0)[_S756]));
    float _S762 = _S760 * _S761.height_scale_0;
    Family_0 _S763 = slang_ldg_3((&(globalParams_0->families_0)[_S756]));
    return _S762 * _S763.level_0;
}

__device__ Probe_0 probe_0(uint _S764, float _S765, float _S766, bool _S767, bool _S768, bool _S769)
{
    Sample_0 _S770 = sample_at_0(_S764, _S765, _S766, _S767);
    Probe_0 probe_1;
    (&probe_1)->height_3 = _S770.height_6;
    (&probe_1)->hole_4 = _S770.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S770.slope_x_1;
    (&probe_1)->slope_y_0 = _S770.slope_y_1;
    uint _S771;
    if(_S770.shown_3.is_warp_2)
    {
        _S771 = _S770.crossing_2.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S771 = _S770.crossing_2.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S771;
    Crossing_0 _S772 = _S770.crossing_2;
    float _S773 = cell_maximum_0(_S764, &_S772);
    (&probe_1)->cell_max_0 = _S773;
    float _S774;
    if(_S768)
    {
        _S774 = _S770.crossing_2.warp_1.above_0;
    }
    else
    {
        _S774 = _S770.crossing_2.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S774;
    if(_S769)
    {
        _S774 = _S770.crossing_2.weft_1.above_0;
    }
    else
    {
        _S774 = _S770.crossing_2.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S774;
    bool _S775 = !_S770.shown_3.is_warp_2;
    Cell_0 _S776 = _S770.crossing_2.warp_1;
    Shown_0 _S777 = _S770.shown_3;
    Run_0 _S778 = _S770.run_3;
    float _S779 = outline_distance_0(&_S776, &_S777, &_S778, _S775, _S768);
    (&probe_1)->edge_x_0 = _S779;
    Cell_0 _S780 = _S770.crossing_2.weft_1;
    Shown_0 _S781 = _S770.shown_3;
    Run_0 _S782 = _S770.run_3;
    float _S783 = outline_distance_0(&_S780, &_S781, &_S782, _S770.shown_3.is_warp_2, _S769);
    (&probe_1)->edge_y_0 = _S783;
    return probe_1;
}

__device__ bool is_free_0(uint _S784, SearchQuality_0 * _S785, float3  _S786, float3  _S787, bool _S788, float _S789)
{
    float _S790 = _S787.z;
    if(_S790 <= 0.0f)
    {
        return false;
    }
    float _S791 = _S785->shadow_share_0;
    float _S792 = steps_per_length_0(_S784, _S785, _S787);
    float _S793 = 1.0f / (F32_max((_S791 * _S792), (9.99999971718068537e-10f)));
    StepControl_0 _S794 = step_control_0(float2 {_S787.x, _S787.y}, _S793);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_4 = 0U;
    float distance_2 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S795;
        if(count_4 < 1024U)
        {
            _S795 = (_S786.z + _S790 * distance_2) < _S789;
        }
        else
        {
            _S795 = false;
        }
        if(_S795)
        {
        }
        else
        {
            break;
        }
        float3  _S796 = _S786 + _S787 * make_float3 (distance_2);
        Probe_0 _S797 = probe_0(_S784, _S796.x, _S796.y, _S788, _S794.right_1, _S794.up_0);
        float _S798 = _S796.z;
        float _S799 = _S798 - _S797.height_3;
        float _S800 = _S790 - _S797.slope_x_0 * _S787.x - _S797.slope_y_0 * _S787.y;
        bool _S801;
        if(!_S797.hole_4)
        {
            _S801 = _S799 < 0.0f;
        }
        else
        {
            _S801 = false;
        }
        if(_S801)
        {
            return false;
        }
        PreviousSample_0 _S802 = previous_3;
        Probe_0 _S803 = _S797;
        float _S804 = way_back_to_dip_0(&_S802, _S799, _S800, last_step_0, &_S803);
        if(_S804 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S804;
            distance_2 = distance_2 - _S804;
            last_step_0 = last_step_1;
            count_4 = count_4 + 1U;
            continue;
        }
        bool _S805 = _S798 > (_S797.cell_max_0);
        Probe_0 _S806 = _S797;
        PreviousSample_0 _S807 = after_sample_0(_S799, _S800, &_S806, _S805);
        float last_step_2;
        if(_S805)
        {
            StepControl_0 _S808 = _S794;
            float _S809 = StepControl_to_cell_exit_0(&_S808, _S797.side_x_0, _S797.side_y_0);
            last_step_2 = (F32_max((_S809), (_S793)));
        }
        else
        {
            StepControl_0 _S810 = _S794;
            Probe_0 _S811 = _S797;
            float _S812 = StepControl_to_next_sample_0(&_S810, &_S811, _S799, _S800);
            last_step_2 = _S812;
        }
        float distance_3 = distance_2 + last_step_2;
        previous_3 = _S807;
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S813, SearchQuality_0 * _S814, float _S815, float _S816, float3  _S817, bool _S818)
{
    Fabric_0 * _S819 = (&(globalParams_0->fabrics_0)[_S813]);
    Sample_0 _S820 = sample_at_0(_S813, _S815, _S816, _S818);
    if(!_S820.shown_3.hole_3)
    {
        return false;
    }
    float3  _S821 = make_float3 (_S815, _S816, 0.0f);
    bool passes_0 = true;
    uint side_1 = 0U;
    for(;;)
    {
        bool _S822;
        if(side_1 < 2U)
        {
            _S822 = passes_0;
        }
        else
        {
            _S822 = false;
        }
        if(_S822)
        {
        }
        else
        {
            break;
        }
        float3  _S823;
        if(side_1 == 0U)
        {
            _S823 = _S817;
        }
        else
        {
            _S823 = make_float3 (- _S817.x, - _S817.y, _S817.z);
        }
        bool _S824 = _S818 != (side_1 == 1U);
        float _S825 = __ldg(&_S819->height_high_0);
        bool _S826 = is_free_0(_S813, _S814, _S821, _S823, _S824, _S825);
        uint _S827 = side_1 + 1U;
        passes_0 = _S826;
        side_1 = _S827;
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

__device__ float max_height_along_0(uint _S828, float _S829, float _S830, float _S831, float3  _S832, bool _S833)
{
    Fabric_0 * _S834 = (&(globalParams_0->fabrics_0)[_S828]);
    uint _S835 = __ldg(&_S834->warp_0);
    uint _S836 = locate_0(_S835, _S829).thread_1 / 2U;
    uint _S837 = __ldg(&_S834->weft_0);
    uint _S838 = locate_0(_S837, _S830).thread_1 / 2U;
    float _S839 = _S832.x;
    uint _S840;
    if(_S839 > 0.0f)
    {
        _S840 = 1U;
    }
    else
    {
        _S840 = 0U;
    }
    float _S841 = _S832.y;
    uint _S842;
    if(_S841 > 0.0f)
    {
        _S842 = 2U;
    }
    else
    {
        _S842 = 0U;
    }
    uint _S843 = _S840 + _S842;
    uint _S844 = __ldg(&_S834->max_heights_0);
    uint _S845 = __ldg(&_S834->max_height_columns_0);
    uint _S846 = __ldg((&(globalParams_0->words_0)[_S844 + 4U * (_S838 * _S845 + _S836) + _S843]));
    int number_1;
    if(_S833)
    {
        number_1 = int(4);
    }
    else
    {
        number_1 = int(0);
    }
    uint _S847 = _S846 >> number_1;
    float _S848 = (F32_abs((_S839)));
    float _S849 = __ldg(&_S834->threads_per_x_0);
    float _S850 = _S848 * _S849;
    float _S851 = (F32_abs((_S841)));
    float _S852 = __ldg(&_S834->threads_per_y_0);
    float _S853 = (F32_max((_S850), (_S851 * _S852))) / _S832.z;
    float _S854 = __ldg(&_S834->height_high_0);
    float max_height_0 = _S854;
    number_1 = int(3);
    for(;;)
    {
        if(number_1 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S831) * _S853) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S847 >> uint(int(8) * number_1)) & 15U) * 0.06666667014360428f * _S854)));
        }
        number_1 = number_1 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S855, float _S856, float _S857, bool _S858, bool _S859, bool _S860)
{
    Crossing_0 _S861 = crossing_at_0(_S855, _S856, _S857, _S858);
    Crossing_0 _S862 = _S861;
    float _S863 = cell_maximum_0(_S855, &_S862);
    float _S864;
    if(_S859)
    {
        _S864 = _S861.warp_1.above_0;
    }
    else
    {
        _S864 = _S861.warp_1.below_0;
    }
    float _S865;
    if(_S860)
    {
        _S865 = _S861.weft_1.above_0;
    }
    else
    {
        _S865 = _S861.weft_1.below_0;
    }
    return make_float3 (_S863, _S864, _S865);
}

__device__ float first_sample_height_0(uint _S866, ViewRay_0 * _S867, StepControl_0 * _S868, bool _S869)
{
    float _S870 = max_height_along_0(_S866, _S867->origin_0.x, _S867->origin_0.y, 0.0f, make_float3 (_S867->slope_1.x, _S867->slope_1.y, 1.0f), _S869);
    uint count_5 = 0U;
    float height_8 = _S870;
    for(;;)
    {
        if(count_5 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S871 = ViewRay_at_0(_S867, height_8);
        float3  _S872 = cell_bounds_0(_S866, _S871.x, _S871.y, _S869, _S868->right_1, _S868->up_0);
        float _S873 = height_8 - _S872.x;
        float _S874 = StepControl_to_cell_exit_0(_S868, _S872.y, _S872.z);
        float height_9 = height_8 - clamp_1(_S873, 0.0f, _S874);
        if(_S873 <= _S874)
        {
            height_8 = height_9;
            break;
        }
        count_5 = count_5 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

__device__ ViewRayEnd_0 search_down_0(uint _S875, ViewRay_0 * _S876, StepControl_0 * _S877, bool _S878)
{
    Fabric_0 * _S879 = (&(globalParams_0->fabrics_0)[_S875]);
    float _S880 = __ldg(&_S879->height_low_0);
    float _S881 = __ldg(&_S879->height_high_0);
    float _S882 = _S880 - (_S881 - _S880);
    ViewRayEnd_0 end_1;
    float _S883 = first_sample_height_0(_S875, _S876, _S877, _S878);
    (&end_1)->height_7 = _S883;
    (&end_1)->last_step_3 = _S877->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
    uint count_6 = 0U;
    for(;;)
    {
        if(count_6 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S884 = ViewRay_at_0(_S876, (&end_1)->height_7);
        Probe_0 _S885 = probe_0(_S875, _S884.x, _S884.y, _S878, _S877->right_1, _S877->up_0);
        float _S886 = (&end_1)->height_7 - _S885.height_3;
        Probe_0 _S887 = _S885;
        float _S888 = ViewRay_rate_0(_S876, &_S887);
        (&end_1)->depth_1 = - _S886;
        (&end_1)->rate_4 = _S888;
        bool _S889;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S889 = !_S885.hole_4;
        }
        else
        {
            _S889 = false;
        }
        bool _S890;
        if(_S889)
        {
            _S890 = ((&(&end_1)->previous_4)->yarn_0) == (_S885.yarn_1);
        }
        else
        {
            _S890 = false;
        }
        (&end_1)->smooth_0 = _S890;
        bool _S891;
        if(!_S885.hole_4)
        {
            _S891 = _S886 <= 0.0f;
        }
        else
        {
            _S891 = false;
        }
        bool _S892;
        if(_S891)
        {
            _S892 = true;
        }
        else
        {
            _S892 = ((&end_1)->height_7) <= _S882;
        }
        if(_S892)
        {
            break;
        }
        PreviousSample_0 _S893 = (&end_1)->previous_4;
        Probe_0 _S894 = _S885;
        float _S895 = way_back_to_dip_0(&_S893, _S886, _S888, (&end_1)->last_step_3, &_S894);
        if(_S895 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S895;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S895;
            count_6 = count_6 + 1U;
            continue;
        }
        float _S896 = StepControl_to_cell_exit_0(_S877, _S885.side_x_0, _S885.side_y_0);
        float _S897 = (F32_min((_S896), ((&end_1)->height_7 - _S885.cell_max_0)));
        Probe_0 _S898 = _S885;
        float _S899 = StepControl_to_next_sample_0(_S877, &_S898, _S886, _S888);
        bool _S900 = _S897 > _S899;
        Probe_0 _S901 = _S885;
        PreviousSample_0 _S902 = after_sample_0(_S886, _S888, &_S901, _S900);
        (&end_1)->previous_4 = _S902;
        float _S903 = (F32_max((_S897), (_S899)));
        (&end_1)->last_step_3 = _S903;
        (&end_1)->height_7 = (&end_1)->height_7 - _S903;
        count_6 = count_6 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S904, ViewRay_0 * _S905, StepControl_0 * _S906, bool _S907, ViewRayEnd_0 * _S908, uint _S909)
{
    Fabric_0 * _S910 = (&(globalParams_0->fabrics_0)[_S904]);
    float _S911 = __ldg(&_S910->height_high_0);
    float _S912 = __ldg(&_S910->height_low_0);
    float _S913 = _S911 - _S912;
    float _S914 = _S908->height_7;
    float _S915 = _S908->last_step_3;
    float above_2 = _S908->height_7 + _S908->last_step_3;
    float above_gap_1 = clamp_1((&_S908->previous_4)->clearance_0, 0.0f, _S913);
    float under_gap_1 = clamp_1(_S908->depth_1, 0.0f, _S913);
    float _S916 = cubic_root_0(above_gap_1, - under_gap_1, (&_S908->previous_4)->rate_0 * _S908->last_step_3, _S908->rate_4 * _S908->last_step_3);
    bool _S917 = _S908->smooth_0;
    float middle_0;
    if(_S908->smooth_0)
    {
        middle_0 = above_2 - _S916 * _S915;
    }
    else
    {
        middle_0 = between_0(above_2, _S914, above_gap_1, under_gap_1);
    }
    float side_2 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S914;
    float above_3 = above_2;
    uint i_10 = 0U;
    for(;;)
    {
        if(i_10 < _S909)
        {
        }
        else
        {
            break;
        }
        float2  _S918 = ViewRay_at_0(_S905, middle_0);
        Probe_0 _S919 = probe_0(_S904, _S918.x, _S918.y, _S907, _S906->right_1, _S906->up_0);
        float _S920;
        if(_S919.hole_4)
        {
            _S920 = -1.0e+09f;
        }
        else
        {
            _S920 = _S919.height_3;
        }
        float _S921 = clamp_1(middle_0 - _S920, - _S913, _S913);
        float _S922;
        if(_S921 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S922 = 0.5f * above_gap_2;
            }
            else
            {
                _S922 = above_gap_2;
            }
            float _S923 = - _S921;
            under_1 = middle_0;
            above_gap_2 = _S922;
            under_gap_2 = _S923;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S922 = 0.5f * under_gap_2;
            }
            else
            {
                _S922 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S921;
            under_gap_2 = _S922;
            side_2 = -1.0f;
        }
        if(_S917)
        {
            Probe_0 _S924 = _S919;
            float _S925 = ViewRay_rate_0(_S905, &_S924);
            middle_0 = clamp_1(middle_0 + _S921 / (F32_min((_S925), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_10 = i_10 + 1U;
    }
    if(_S917)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S926, SearchQuality_0 * _S927, float _S928, float _S929, float3  _S930, bool _S931)
{
    float _S932 = (F32_max((_S930.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S928, _S929);
    float2  _S933 = float2 {_S930.x, _S930.y} / make_float2 (_S932);
    (&ray_0)->slope_1 = _S933;
    float2  _S934 = - _S933;
    float _S935 = steps_per_length_0(_S926, _S927, _S930);
    StepControl_0 _S936 = step_control_0(_S934, 1.0f / (F32_max((_S935 / _S932), (9.99999971718068537e-10f))));
    ViewRay_0 _S937 = ray_0;
    StepControl_0 _S938 = _S936;
    ViewRayEnd_0 _S939 = search_down_0(_S926, &_S937, &_S938, _S931);
    Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    ViewRay_0 _S940 = ray_0;
    StepControl_0 _S941 = _S936;
    ViewRayEnd_0 _S942 = _S939;
    float _S943 = refined_height_0(_S926, &_S940, &_S941, _S931, &_S942, _S927->refinements_0);
    (&hit_0)->height_5 = _S943;
    ViewRay_0 _S944 = ray_0;
    float2  _S945 = ViewRay_at_0(&_S944, _S943);
    (&hit_0)->x_32 = _S945.x;
    (&hit_0)->y_17 = _S945.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S946, SearchQuality_0 * _S947, float _S948, float _S949, float3  _S950, bool _S951)
{
    bool _S952 = passes_through_0(_S946, _S947, _S948, _S949, _S950, _S951);
    if(!_S952)
    {
        Hit_0 _S953 = first_hit_of_yarn_0(_S946, _S947, _S948, _S949, _S950, _S951);
        return _S953;
    }
    Hit_0 hit_1;
    (&hit_1)->x_32 = _S948;
    (&hit_1)->y_17 = _S949;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S954, float _S955, float _S956, bool _S957)
{
    Fabric_0 * _S958 = (&(globalParams_0->fabrics_0)[_S954]);
    Sample_0 _S959 = sample_at_0(_S954, _S955, _S956, _S957);
    float _S960;
    if(_S959.shown_3.is_warp_2)
    {
        _S960 = _S959.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S960 = _S959.crossing_2.weft_1.half_width_1;
    }
    uint _S961;
    if(_S959.shown_3.is_warp_2)
    {
        uint _S962 = __ldg(&_S958->warp_0);
        _S961 = _S962;
    }
    else
    {
        uint _S963 = __ldg(&_S958->weft_0);
        _S961 = _S963;
    }
    Family_0 _S964 = slang_ldg_3((&(globalParams_0->families_0)[_S961]));
    float _S965;
    if(_S957)
    {
        _S965 = -1.0f;
    }
    else
    {
        _S965 = 1.0f;
    }
    float _S966 = _S964.twist_sine_0 * _S965;
    Family_0 _S967 = slang_ldg_3((&(globalParams_0->families_0)[_S961]));
    if(_S959.shown_3.is_warp_2)
    {
        _S965 = 1.0f;
    }
    else
    {
        _S965 = -1.0f;
    }
    float2  _S968 = fibre_direction_0(_S959.slope_across_0, _S965 * _S959.slope_along_0, _S966, _S967.twist_cosine_0);
    float _S969;
    if(_S959.shown_3.is_warp_2)
    {
        _S969 = _S959.slope_x_1;
    }
    else
    {
        _S969 = _S959.slope_y_1;
    }
    float _S970;
    if(_S959.shown_3.is_warp_2)
    {
        _S970 = _S959.slope_y_1;
    }
    else
    {
        _S970 = _S959.slope_x_1;
    }
    float _S971 = _S968.x;
    float _S972 = _S968.y;
    float _S973 = _S969 * _S971 + _S965 * _S970 * _S972;
    float _S974 = _S960 * 1.0154266357421875f;
    float _S975 = _S974 * arc_sine_0(clamp_1(_S959.section_1.across_3 / _S974, -1.0f, 1.0f));
    if(_S959.shown_3.is_warp_2)
    {
        _S960 = _S956;
    }
    else
    {
        _S960 = - _S955;
    }
    SurfacePoint_0 point_3;
    (&point_3)->hole_0 = _S959.shown_3.hole_3;
    (&point_3)->is_warp_0 = _S959.shown_3.is_warp_2;
    (&point_3)->warp_thread_0 = _S959.crossing_2.warp_1.thread_1;
    (&point_3)->weft_thread_0 = _S959.crossing_2.weft_1.thread_1;
    (&point_3)->height_1 = _S959.height_6;
    (&point_3)->normal_1 = normalize_0(make_float3 (- _S959.slope_x_1, - _S959.slope_y_1, 1.0f));
    float3  _S976;
    if(_S959.shown_3.is_warp_2)
    {
        _S976 = make_float3 (_S971, _S972, _S973);
    }
    else
    {
        _S976 = make_float3 (- _S972, _S971, _S973);
    }
    (&point_3)->tangent_0 = normalize_0(_S976);
    (&point_3)->across_0 = _S959.section_1.across_3;
    (&point_3)->fibre_across_0 = _S975 * _S967.twist_cosine_0 + _S960 * _S966;
    (&point_3)->fibre_along_0 = _S960 * _S967.twist_cosine_0 - _S975 * _S966;
    return point_3;
}

struct YarnPoint_0
{
    bool back_4;
    bool hole_6;
    bool is_warp_3;
    float x_33;
    float y_18;
    float height_10;
    float3  normal_7;
    float3  tangent_7;
    float roughness_10;
    Albedos_0 albedos_6;
};

__device__ Albedos_0 vary_albedos_0(uint _S977, Albedos_0 * _S978, uint _S979, uint _S980)
{
    Fabric_0 * _S981 = (&(globalParams_0->fabrics_0)[_S977]);
    float3  _S982 = _S978->specular_reflect_0;
    float3  _S983 = _S978->specular_transmit_0;
    float3  _S984 = max_0(_S978->specular_reflect_0, _S978->specular_transmit_0);
    float3  _S985 = _S978->diffuse_reflect_0;
    float3  _S986 = _S978->diffuse_transmit_0;
    float3  _S987 = _S978->diffuse_reflect_0 + _S978->diffuse_transmit_0;
    float _S988 = __ldg(&_S981->colour_noise_0);
    uint _S989 = __ldg(&_S981->seed_0);
    float _S990 = thread_gain_0(_S979, _S988, _S989);
    float _S991 = __ldg(&_S981->layer_bound_0);
    float _S992 = bounded_gain_0(_S990, _S987, make_float3 (1.0f) - make_float3 (_S991) * _S984);
    float3  _S993 = min_0((make_float3 (1.0f) - make_float3 (_S992) * _S987) / make_float3 (_S991), make_float3 (1.0f));
    float _S994 = __ldg(&_S981->fibre_noise_0);
    float _S995 = bounded_gain_0(fibre_gain_0(_S979, _S980, _S994, _S989), _S984, _S993);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S992) * _S985;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S992) * _S986;
    (&varied_0)->specular_reflect_0 = make_float3 (_S995) * _S982;
    (&varied_0)->specular_transmit_0 = make_float3 (_S995) * _S983;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S996, SurfacePoint_0 * _S997, Albedos_0 * _S998, float _S999, float _S1000)
{
    Fabric_0 * _S1001 = (&(globalParams_0->fabrics_0)[_S996]);
    bool _S1002 = _S997->is_warp_0;
    float _S1003;
    if(_S997->is_warp_0)
    {
        _S1003 = _S999;
    }
    else
    {
        _S1003 = _S1000;
    }
    float _S1004 = _S1003 - _S997->across_0;
    uint _S1005;
    if(_S1002)
    {
        uint _S1006 = __ldg(&_S1001->warp_0);
        _S1005 = _S1006;
    }
    else
    {
        uint _S1007 = __ldg(&_S1001->weft_0);
        _S1005 = _S1007;
    }
    Family_0 _S1008 = slang_ldg_3((&(globalParams_0->families_0)[_S1005]));
    Family_0 _S1009 = slang_ldg_3((&(globalParams_0->families_0)[_S1005]));
    int _S1010 = int(_S1009.count_0);
    if(_S1002)
    {
        _S1005 = _S997->warp_thread_0;
    }
    else
    {
        _S1005 = _S997->weft_thread_0;
    }
    uint _S1011 = uint(int((F32_floor((_S1004 / _S1008.period_0)))) * _S1010 + int(_S1005)) * 2U;
    if(_S1002)
    {
        _S1005 = 1U;
    }
    else
    {
        _S1005 = 0U;
    }
    uint _S1012 = _S1011 + _S1005;
    float _S1013 = _S997->fibre_across_0;
    float _S1014 = __ldg(&_S1001->fibre_size_0);
    float _S1015 = (F32_floor((_S1013 / _S1014)));
    Albedos_0 _S1016 = vary_albedos_0(_S996, _S998, _S1012, uint(int(_S1015)) * 65536U + uint(int((F32_floor((_S997->fibre_along_0 / (_S1014 * 40.0f) + 0.61799997091293335f * _S1015))))));
    return _S1016;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S1017, SurfacePoint_0 * _S1018, float _S1019, float _S1020, bool _S1021, bool _S1022)
{
    Fabric_0 * _S1023 = (&(globalParams_0->fabrics_0)[_S1017]);
    bool _S1024 = _S1018->is_warp_0;
    uint _S1025;
    if(_S1018->is_warp_0)
    {
        uint _S1026 = __ldg(&_S1023->warp_0);
        _S1025 = _S1026;
    }
    else
    {
        uint _S1027 = __ldg(&_S1023->weft_0);
        _S1025 = _S1027;
    }
    uint _S1028;
    if(_S1024)
    {
        _S1028 = _S1018->warp_thread_0;
    }
    else
    {
        _S1028 = _S1018->weft_thread_0;
    }
    Albedos_0 albedos_7 = albedos_of_0(_S1025, _S1028);
    float _S1029 = __ldg(&_S1023->fibre_noise_0);
    bool _S1030;
    if(_S1029 > 0.0f)
    {
        _S1030 = true;
    }
    else
    {
        float _S1031 = __ldg(&_S1023->colour_noise_0);
        _S1030 = _S1031 > 0.0f;
    }
    Albedos_0 albedos_8;
    if(_S1030)
    {
        Albedos_0 _S1032 = albedos_7;
        Albedos_0 _S1033 = varied_at_0(_S1017, _S1018, &_S1032, _S1019, _S1020);
        albedos_8 = _S1033;
    }
    else
    {
        albedos_8 = albedos_7;
    }
    YarnPoint_0 point_4;
    (&point_4)->back_4 = _S1021;
    (&point_4)->hole_6 = _S1022;
    (&point_4)->is_warp_3 = _S1024;
    (&point_4)->x_33 = _S1019;
    (&point_4)->y_18 = _S1020;
    (&point_4)->height_10 = _S1018->height_1;
    (&point_4)->normal_7 = _S1018->normal_1;
    (&point_4)->tangent_7 = _S1018->tangent_0;
    Family_0 _S1034 = slang_ldg_3((&(globalParams_0->families_0)[_S1025]));
    (&point_4)->roughness_10 = _S1034.roughness_0;
    (&point_4)->albedos_6 = albedos_8;
    return point_4;
}

__device__ bool unoccluded_0(uint _S1035, SearchQuality_0 * _S1036, float _S1037, float _S1038, float _S1039, float3  _S1040, bool _S1041)
{
    Fabric_0 * _S1042 = (&(globalParams_0->fabrics_0)[_S1035]);
    if((_S1040.z) <= 0.0f)
    {
        return false;
    }
    float _S1043 = max_height_along_0(_S1035, _S1037, _S1038, _S1039, _S1040, _S1041);
    float _S1044 = __ldg(&_S1042->lift_0);
    bool _S1045 = is_free_0(_S1035, _S1036, make_float3 (_S1037, _S1038, _S1039 + _S1044), _S1040, _S1041, _S1043);
    return _S1045;
}

__device__ bool is_lit_0(uint _S1046, SearchQuality_0 * _S1047, YarnPoint_0 * _S1048, float3  _S1049)
{
    if(_S1048->hole_6)
    {
        return true;
    }
    bool _S1050 = _S1048->back_4;
    float3  _S1051 = to_face_frame_0(_S1049, _S1048->back_4);
    float _S1052 = _S1051.z;
    bool _S1053 = _S1052 < 0.0f;
    float3  _S1054 = _S1048->normal_7;
    float _S1055 = _S1048->height_10;
    float3  normal_8;
    float height_11;
    if(_S1053)
    {
        SurfacePoint_0 _S1056 = surface_at_0(_S1046, _S1048->x_33, _S1048->y_18, !_S1050);
        normal_8 = _S1056.normal_1;
        height_11 = _S1056.height_1;
    }
    else
    {
        normal_8 = _S1054;
        height_11 = _S1055;
    }
    float3  _S1057 = make_float3 (float2 {_S1051.x, _S1051.y}.x, float2 {_S1051.x, _S1051.y}.y, (F32_abs((_S1052))));
    if((dot_0(normal_8, _S1057)) <= 0.0f)
    {
        return false;
    }
    bool _S1058 = unoccluded_0(_S1046, _S1047, _S1048->x_33, _S1048->y_18, height_11, _S1057, _S1050 != _S1053);
    return _S1058;
}

__device__ Components_0 components_of_point_0(uint _S1059, SearchQuality_0 * _S1060, YarnPoint_0 * _S1061, float3  _S1062, float3  _S1063)
{
    Fabric_0 * _S1064 = (&(globalParams_0->fabrics_0)[_S1059]);
    Components_0 result_14 = no_components_0();
    bool _S1065 = _S1061->hole_6;
    float _S1066;
    if(_S1061->hole_6)
    {
        _S1066 = 1.0f;
    }
    else
    {
        _S1066 = 0.0f;
    }
    (&result_14)->hole_2 = _S1066;
    bool _S1067;
    if(_S1065)
    {
        _S1067 = true;
    }
    else
    {
        bool _S1068 = is_lit_0(_S1059, _S1060, _S1061, _S1062);
        _S1067 = !_S1068;
    }
    if(_S1067)
    {
        return result_14;
    }
    float3  _S1069 = to_face_frame_0(_S1062, _S1061->back_4);
    float3  _S1070 = to_face_frame_0(_S1063, _S1061->back_4);
    bool _S1071 = (_S1069.z) < 0.0f;
    float3  _S1072;
    if(_S1071)
    {
        _S1072 = - _S1069;
    }
    else
    {
        _S1072 = _S1069;
    }
    float3  _S1073 = _S1061->normal_7;
    float _S1074 = __ldg(&_S1064->diffuse_blend_0);
    float _S1075 = diffuse_reflection_0(_S1072, _S1073, _S1074);
    if(_S1071)
    {
        float3  _S1076 = _S1061->tangent_7;
        float _S1077 = _S1061->roughness_10;
        float _S1078 = __ldg(&_S1064->optical_depth_0);
        _S1066 = transmission_0(_S1069, _S1070, _S1073, _S1076, _S1077, _S1078);
    }
    else
    {
        float3  _S1079 = _S1061->tangent_7;
        float _S1080 = _S1061->roughness_10;
        float _S1081 = __ldg(&_S1064->optical_depth_0);
        _S1066 = reflection_0(_S1069, _S1070, _S1073, _S1079, _S1080, _S1081);
    }
    bool _S1082 = _S1061->is_warp_3;
    float _S1083;
    if(_S1061->is_warp_3)
    {
        _S1083 = _S1075;
    }
    else
    {
        _S1083 = 0.0f;
    }
    (&result_14)->diffuse_warp_0 = _S1083;
    if(_S1082)
    {
        _S1083 = 0.0f;
    }
    else
    {
        _S1083 = _S1075;
    }
    (&result_14)->diffuse_weft_0 = _S1083;
    if(_S1082)
    {
        _S1083 = _S1066;
    }
    else
    {
        _S1083 = 0.0f;
    }
    (&result_14)->specular_warp_0 = _S1083;
    if(_S1082)
    {
        _S1066 = 0.0f;
    }
    (&result_14)->specular_weft_0 = _S1066;
    (&result_14)->light_visibility_1 = 1.0f;
    return result_14;
}

struct CoverageTaps_0
{
    FixedArray<uint, 9>  nodes_1;
};

__device__ float3  pyramid_level_0(uint _S1084, float _S1085)
{
    Lobes_0 _S1086 = slang_ldg_0(&(&(globalParams_0->fabrics_0)[_S1084])->lobes_0);
    uint _S1087 = _S1086.levels_0 + 4U * uint((F32_min((_S1085), (_S1086.last_level_0))));
    return make_float3 (table_number_0(_S1087), table_number_0(_S1087 + 1U), table_number_0(_S1087 + 2U));
}

__device__ CoverageTaps_0 coverage_taps_0(uint _S1088, Footprint_0 * _S1089, bool _S1090)
{
    Fabric_0 * _S1091 = (&(globalParams_0->fabrics_0)[_S1088]);
    float _S1092 = Footprint_spread_side_0(_S1089);
    Lobes_0 _S1093 = slang_ldg_0(&_S1091->lobes_0);
    float _S1094 = _S1092 * _S1093.inverse_base_size_0;
    float3  _S1095 = pyramid_level_0(_S1088, (F32_floor((binary_logarithm_0((F32_max((0.68000000715255737f * _S1094), (1.0f))))))));
    float _S1096 = 1.0f / (F32_max((_S1094), (9.99999997475242708e-07f)));
    float _S1097 = (F32_min(((F32_max(((F32_sqrt((clamp_1(1.29999995231628418f * (1.0f - _S1096 * _S1096), 0.0f, 1.0f))))), (0.3333333432674408f * _S1096)))), (1.0f)));
    uint _S1098 = __ldg(&_S1091->warp_0);
    Family_0 _S1099 = slang_ldg_3((&(globalParams_0->families_0)[_S1098]));
    uint _S1100 = __ldg(&_S1091->weft_0);
    Family_0 _S1101 = slang_ldg_3((&(globalParams_0->families_0)[_S1100]));
    float2  _S1102 = make_float2 (_S1099.inverse_period_0, _S1101.inverse_period_0);
    float2  _S1103 = _S1089->centre_0 * _S1102;
    float2  _S1104 = _S1089->dx_0 * _S1102 * make_float2 (_S1097);
    float2  _S1105 = _S1089->dy_0 * _S1102 * make_float2 (_S1097);
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
        float2  _S1106 = _S1103 + make_float2 (TAP_OFFSETS_0[number_2].x) * _S1104 + make_float2 (TAP_OFFSETS_0[number_2].y) * _S1105;
        float _S1107 = _S1095.y;
        float _S1108 = wrapped_cell_0(_S1106.x, _S1107);
        float _S1109 = wrapped_cell_0(_S1106.y, _S1095.z);
        uint _S1110;
        if(_S1090)
        {
            _S1110 = _S1093.face_nodes_0;
        }
        else
        {
            _S1110 = 0U;
        }
        (&taps_3)->nodes_1[number_2] = _S1110 + uint(_S1109 * _S1107 + _S1108 + _S1095.x);
        number_2 = number_2 + 1U;
    }
    return taps_3;
}

__device__ float4  coverage_of_pack_0(uint _S1111, CoverageTaps_0 * _S1112, uint _S1113)
{
    Fabric_0 * _S1114 = (&(globalParams_0->fabrics_0)[_S1111]);
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
        Lobes_0 _S1115 = slang_ldg_0(&_S1114->lobes_0);
        uint _S1116 = __ldg((&(globalParams_0->words_0)[_S1115.coverage_0 + _S1112->nodes_1[number_3] * _S1115.packs_0 + _S1113]));
        uint even_2 = even_1 + (_S1116 & 16711935U);
        uint odd_2 = odd_1 + ((_S1116 >> int(8)) & 16711935U);
        number_3 = number_3 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / make_float4 (9.0f);
}

__device__ float coverage_of_holes_0(uint _S1117, CoverageTaps_0 * _S1118)
{
    Fabric_0 * _S1119 = (&(globalParams_0->fabrics_0)[_S1117]);
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
        uint _S1120 = _S1118->nodes_1[number_4];
        Lobes_0 _S1121 = slang_ldg_0(&_S1119->lobes_0);
        uint _S1122 = __ldg((&(globalParams_0->words_0)[_S1121.coverage_holes_0 + _S1120 / 4U]));
        uint total_1 = total_0 + ((_S1122 >> (8U * (_S1120 % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

__device__ float prefiltered_hole_0(uint _S1123, CoverageTaps_0 * _S1124, NodeTaps_0 * _S1125, bool _S1126)
{
    Lobes_0 _S1127 = slang_ldg_0(&(&(globalParams_0->fabrics_0)[_S1123])->lobes_0);
    float4  _S1128 = interpolate_table_0(_S1125, _S1127.projected_area_0 + _S1127.packs_0, _S1127.packs_0 + 1U);
    float _S1129 = _S1128.x;
    float _S1130;
    if(_S1126)
    {
        _S1130 = _S1127.back_hole_weight_0;
    }
    else
    {
        _S1130 = _S1127.front_hole_weight_0;
    }
    float _S1131 = coverage_of_holes_0(_S1123, _S1124);
    return (F32_min((_S1131 * _S1129 * _S1129 * _S1130), (1.0f)));
}

__device__ Components_0 prefiltered_components_0(uint _S1132, Footprint_0 * _S1133, float3  _S1134, float3  _S1135, bool _S1136)
{
    Fabric_0 * _S1137 = (&(globalParams_0->fabrics_0)[_S1132]);
    CoverageTaps_0 _S1138 = coverage_taps_0(_S1132, _S1133, _S1136);
    NodeTaps_0 _S1139 = node_taps_0(_S1135);
    NodeTaps_0 view_nodes_0 = _S1139;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S1134);
    NodeTaps_0 seen_nodes_0 = _S1139;
    uint _S1140;
    if(_S1136)
    {
        _S1140 = 1U;
    }
    else
    {
        _S1140 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + make_uint4 (_S1140 * 256U);
    uint _S1141 = 2U * _S1140;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + make_uint4 (_S1141 * 256U);
    uint _S1142;
    if((_S1134.z) < 0.0f)
    {
        _S1142 = 1U;
    }
    else
    {
        _S1142 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + make_uint4 ((_S1141 + _S1142) * 256U);
    float3  _S1143 = half_vector_0(_S1134, _S1135);
    float3  _S1144 = shadow_correlation_0(_S1134, _S1135);
    if(_S1136)
    {
        Lobes_0 _S1145 = slang_ldg_0(&_S1137->lobes_0);
        _S1142 = _S1145.back_warp_packs_0;
    }
    else
    {
        Lobes_0 _S1146 = slang_ldg_0(&_S1137->lobes_0);
        _S1142 = _S1146.front_warp_packs_0;
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
        Lobes_0 _S1147 = slang_ldg_0(&_S1137->lobes_0);
        if(pack_0 < (_S1147.packs_0))
        {
        }
        else
        {
            break;
        }
        CoverageTaps_0 _S1148 = _S1138;
        float4  _S1149 = coverage_of_pack_0(_S1132, &_S1148, pack_0);
        uint _S1150 = _S1147.projected_area_0 + pack_0;
        uint _S1151 = _S1147.packs_0 + 1U;
        NodeTaps_0 _S1152 = view_nodes_0;
        float4  _S1153 = interpolate_table_0(&_S1152, _S1150, _S1151);
        uint _S1154 = _S1147.light_visibility_0 + pack_0;
        NodeTaps_0 _S1155 = seen_nodes_0;
        float4  _S1156 = interpolate_table_0(&_S1155, _S1154, _S1147.packs_0);
        float4  _S1157 = _S1156 / make_float4 (255.0f);
        NodeTaps_0 _S1158 = light_nodes_0;
        float4  _S1159 = interpolate_table_0(&_S1158, _S1154, _S1147.packs_0);
        float4  _S1160 = _S1159 / make_float4 (255.0f);
        uint _S1161 = _S1147.irradiance_0 + pack_0;
        NodeTaps_0 _S1162 = light_nodes_0;
        float4  _S1163 = interpolate_table_0(&_S1162, _S1161, _S1147.packs_0);
        float4  _S1164 = _S1163 * make_float4 (0.00124827399849892f);
        bool _S1165 = pack_0 < _S1142;
        uint _S1166;
        if(_S1165)
        {
            uint _S1167 = __ldg(&_S1137->warp_0);
            _S1166 = _S1167;
        }
        else
        {
            uint _S1168 = __ldg(&_S1137->weft_0);
            _S1166 = _S1168;
        }
        Family_0 _S1169 = slang_ldg_3((&(globalParams_0->families_0)[_S1166]));
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
            Group_0 _S1170 = group_at_0(_S1147.moments_0 + 12U * (4U * (_S1140 * _S1147.packs_0 + pack_0) + number_5), _S1169.roughness_0);
            float _S1171 = _slang_vector_get_element(_S1149, number_5) * _slang_vector_get_element(_S1153, number_5) * _slang_vector_get_element(_S1153, number_5) * _S1170.weight_1;
            uint _S1172 = number_5;
            float2  _S1173 = visibility_gain_0(_S1144, _slang_vector_get_element(_S1160, number_5), _slang_vector_get_element(_S1157, number_5));
            float _S1174 = __ldg(&_S1137->optical_depth_0);
            Group_0 _S1175 = _S1170;
            float _S1176 = layer_value_0(&_S1175, _S1143, _S1134, _S1135, _S1174);
            float _S1177 = _S1173.x;
            float diffuse_1 = diffuse_0 + _S1171 * _slang_vector_get_element(_S1164, number_5) * _S1177;
            float specular_1 = specular_0 + _S1171 * _S1176 * _slang_vector_get_element(_S1160, _S1172) * _S1173.y;
            (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 + _S1171 * _slang_vector_get_element(_S1160, _S1172) * _S1177;
            float total_3 = total_2 + _S1171;
            number_5 = number_5 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S1178;
        if(_S1165)
        {
            _S1178 = diffuse_0;
        }
        else
        {
            _S1178 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S1178;
        float _S1179;
        if(_S1165)
        {
            _S1179 = 0.0f;
        }
        else
        {
            _S1179 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S1179;
        float _S1180;
        if(_S1165)
        {
            _S1180 = specular_0;
        }
        else
        {
            _S1180 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S1180;
        float _S1181;
        if(_S1165)
        {
            _S1181 = 0.0f;
        }
        else
        {
            _S1181 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S1181;
        pack_0 = pack_0 + 1U;
    }
    CoverageTaps_0 _S1182 = _S1138;
    NodeTaps_0 _S1183 = view_nodes_0;
    float _S1184 = prefiltered_hole_0(_S1132, &_S1182, &_S1183, _S1136);
    (&sums_1)->hole_2 = _S1184;
    float _S1185 = (1.0f - _S1184) / (F32_max((total_2), (9.999999960041972e-13f)));
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S1185;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S1185;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S1185;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S1185;
    (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 * _S1185;
    return sums_1;
}

__device__ FamilyAlbedos_0 albedos_over_0(uint _S1186, Footprint_0 * _S1187, bool _S1188)
{
    Fabric_0 * _S1189 = (&(globalParams_0->fabrics_0)[_S1186]);
    float2  _S1190 = sqrt_0(_S1187->dx_0 * _S1187->dx_0 + _S1187->dy_0 * _S1187->dy_0);
    uint _S1191 = __ldg(&_S1189->warp_0);
    float2  _S1192 = _S1187->centre_0;
    Stretch_0 _S1193 = stretch_of_0(_S1191, _S1187->centre_0.x, _S1190.x);
    uint _S1194 = __ldg(&_S1189->weft_0);
    Stretch_0 _S1195 = stretch_of_0(_S1194, _S1192.y, _S1190.y);
    FamilyAlbedos_0 albedos_9;
    Stretch_0 _S1196 = _S1193;
    Stretch_0 _S1197 = _S1195;
    Albedos_0 _S1198 = mean_albedos_0(_S1191, _S1194, &_S1196, &_S1197, _S1188);
    (&albedos_9)->warp_2 = _S1198;
    Stretch_0 _S1199 = _S1195;
    Stretch_0 _S1200 = _S1193;
    Albedos_0 _S1201 = mean_albedos_0(_S1194, _S1191, &_S1199, &_S1200, _S1188);
    (&albedos_9)->weft_2 = _S1201;
    return albedos_9;
}

__device__ Estimate_0 lobes_estimate_of_pass_0(uint _S1202, Footprint_0 * _S1203, float _S1204, float2  _S1205, float3  _S1206, float3  _S1207)
{
    float _S1208;
    Fabric_0 * _S1209 = (&(globalParams_0->fabrics_0)[_S1202]);
    Regime_0 _S1210 = regime_of_0(_S1202, _S1203, _S1204);
    bool _S1211 = (_S1207.z) < 0.0f;
    float3  _S1212 = to_face_frame_0(_S1207, _S1211);
    float _S1213 = __ldg(&_S1209->fibre_noise_0);
    bool _S1214;
    if(_S1213 > 0.0f)
    {
        _S1214 = true;
    }
    else
    {
        float _S1215 = __ldg(&_S1209->colour_noise_0);
        _S1214 = _S1215 > 0.0f;
    }
    uint _S1216 = __ldg(&_S1209->warp_0);
    Family_0 _S1217 = slang_ldg_3((&(globalParams_0->families_0)[_S1216]));
    bool _S1218;
    if((_S1217.quantities_0) > 1U)
    {
        _S1218 = true;
    }
    else
    {
        uint _S1219 = __ldg(&_S1209->weft_0);
        Family_0 _S1220 = slang_ldg_3((&(globalParams_0->families_0)[_S1219]));
        _S1218 = (_S1220.quantities_0) > 1U;
    }
    float _S1221 = 1.0f - _S1210.prefiltered_0;
    if(_S1221 > 0.0f)
    {
        if(_S1214)
        {
            _S1218 = true;
        }
    }
    else
    {
        _S1218 = false;
    }
    Footprint_0 box_0 = *_S1203;
    float3  _S1222 = make_float3 (0.0f);
    SurfacePoint_0 _S1223 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S1222, _S1222, 0.0f, 0.0f, 0.0f);
    float2  _S1224 = _S1203->centre_0;
    Components_0 _S1225 = no_components_0();
    int _S1226;
    if(_S1218)
    {
        _S1226 = int(0);
    }
    else
    {
        _S1226 = int(1);
    }
    uint _S1227 = uint(_S1226);
    Components_0 points_2 = _S1225;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S1223;
    float2  central_place_0 = _S1224;
    uint number_6 = _S1227;
    for(;;)
    {
        float _S1228 = float(number_6);
        _S1208 = _S1210.points_1;
        if(_S1228 < (_S1210.points_1 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S1229 = number_6 == 0U;
        uint _S1230;
        if(_S1229)
        {
            _S1230 = 0U;
        }
        else
        {
            _S1230 = number_6 - 1U;
        }
        float2  _S1231 = POINT_OFFSETS_0[_S1230] + _S1205;
        float2  _S1232;
        if(_S1229)
        {
            _S1232 = make_float2 (0.0f);
        }
        else
        {
            _S1232 = _S1231 - round_0(_S1231);
        }
        float2  _S1233 = _S1224 + make_float2 (_S1232.x) * _S1203->dx_0 + make_float2 (_S1232.y) * _S1203->dy_0;
        float _S1234;
        if(_S1229)
        {
            _S1234 = 0.0f;
        }
        else
        {
            _S1234 = _S1210.threads_1;
        }
        SearchQuality_0 _S1235 = quality_of_0(_S1234);
        float _S1236 = _S1233.x;
        float _S1237 = _S1233.y;
        SearchQuality_0 _S1238 = _S1235;
        Hit_0 _S1239 = first_hit_0(_S1202, &_S1238, _S1236, _S1237, _S1212, _S1211);
        SurfacePoint_0 _S1240 = surface_at_0(_S1202, _S1239.x_32, _S1239.y_17, _S1211);
        if(_S1229)
        {
            float central_weight_1;
            if(_S1239.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S1221;
            }
            float2  central_place_1 = make_float2 (_S1239.x_32, _S1239.y_17);
            (&box_0)->centre_0 = lerp_2(_S1224, central_place_1, make_float2 (central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S1240;
            central_place_0 = central_place_1;
            number_6 = number_6 + 1U;
            continue;
        }
        SurfacePoint_0 _S1241 = _S1240;
        YarnPoint_0 _S1242 = yarn_point_of_0(_S1202, &_S1241, _S1239.x_32, _S1239.y_17, _S1211, _S1239.hole_5);
        SearchQuality_0 _S1243 = _S1235;
        YarnPoint_0 _S1244 = _S1242;
        Components_0 _S1245 = components_of_point_0(_S1202, &_S1243, &_S1244, _S1206, _S1207);
        float _S1246 = (F32_min((_S1210.points_1 - float(number_6 - 1U)), (1.0f)));
        Components_0 _S1247 = points_2;
        Components_0 _S1248 = _S1245;
        Components_0 _S1249 = with_added_0(&_S1247, &_S1248, _S1246);
        points_2 = _S1249;
        number_6 = number_6 + 1U;
    }
    Estimate_0 estimate_0;
    float _S1250 = _S1221 / (F32_max((_S1208), (1.0f)));
    Components_0 _S1251 = _S1225;
    Components_0 _S1252 = points_2;
    Components_0 _S1253 = with_added_0(&_S1251, &_S1252, _S1250);
    (&estimate_0)->components_0 = _S1253;
    if((_S1210.prefiltered_0) > 0.0f)
    {
        Components_0 _S1254 = prefiltered_components_0(_S1202, _S1203, to_face_frame_0(_S1206, _S1211), _S1212, _S1211);
        Components_0 _S1255 = (&estimate_0)->components_0;
        Components_0 _S1256 = _S1254;
        Components_0 _S1257 = with_added_0(&_S1255, &_S1256, _S1210.prefiltered_0);
        (&estimate_0)->components_0 = _S1257;
    }
    Footprint_0 _S1258 = box_0;
    FamilyAlbedos_0 _S1259 = albedos_over_0(_S1202, &_S1258, _S1211);
    (&estimate_0)->albedos_5 = _S1259;
    if(_S1214)
    {
        _S1214 = central_weight_0 > 0.0f;
    }
    else
    {
        _S1214 = false;
    }
    if(_S1214)
    {
        SurfacePoint_0 _S1260 = central_0;
        Albedos_0 _S1261;
        if(central_0.is_warp_0)
        {
            _S1261 = (&(&estimate_0)->albedos_5)->warp_2;
        }
        else
        {
            _S1261 = (&(&estimate_0)->albedos_5)->weft_2;
        }
        float _S1262 = central_place_0.x;
        float _S1263 = central_place_0.y;
        SurfacePoint_0 _S1264 = central_0;
        Albedos_0 _S1265 = _S1261;
        Albedos_0 _S1266 = varied_at_0(_S1202, &_S1264, &_S1265, _S1262, _S1263);
        Albedos_0 _S1267 = _S1261;
        Albedos_0 _S1268 = _S1266;
        Albedos_0 _S1269 = lerp_albedos_0(&_S1267, &_S1268, central_weight_0);
        if(_S1260.is_warp_0)
        {
            (&(&estimate_0)->albedos_5)->warp_2 = _S1269;
        }
        else
        {
            (&(&estimate_0)->albedos_5)->weft_2 = _S1269;
        }
    }
    return estimate_0;
}

__device__ float3  composed_0(uint _S1270, Components_0 * _S1271, FamilyAlbedos_0 * _S1272, float3  _S1273, float3  _S1274)
{
    Fabric_0 * _S1275 = (&(globalParams_0->fabrics_0)[_S1270]);
    float _S1276 = _S1271->diffuse_warp_0;
    float _S1277 = _S1271->diffuse_weft_0;
    float _S1278 = _S1271->specular_warp_0;
    float _S1279 = _S1271->specular_weft_0;
    float3  _S1280 = (&_S1272->warp_2)->diffuse_reflect_0 * make_float3 (_S1271->diffuse_warp_0) + (&_S1272->weft_2)->diffuse_reflect_0 * make_float3 (_S1271->diffuse_weft_0) + (&_S1272->warp_2)->specular_reflect_0 * make_float3 (_S1271->specular_warp_0) + (&_S1272->weft_2)->specular_reflect_0 * make_float3 (_S1271->specular_weft_0);
    float _S1281 = _S1274.z;
    float3  body_0;
    if((_S1273.z * _S1281) < 0.0f)
    {
        body_0 = (&_S1272->warp_2)->diffuse_transmit_0 * make_float3 (_S1276) + (&_S1272->weft_2)->diffuse_transmit_0 * make_float3 (_S1277) + (&_S1272->warp_2)->specular_transmit_0 * make_float3 (_S1278) + (&_S1272->weft_2)->specular_transmit_0 * make_float3 (_S1279);
    }
    else
    {
        body_0 = _S1280;
    }
    float _S1282 = __ldg(&_S1275->sheen_strength_0);
    if(_S1282 <= 0.0f)
    {
        return body_0;
    }
    bool _S1283 = _S1281 < 0.0f;
    float3  _S1284 = to_face_frame_0(_S1273, _S1283);
    float3  _S1285 = to_face_frame_0(_S1274, _S1283);
    float _S1286 = __ldg(&_S1275->sheen_roughness_0);
    float2  _S1287 = sheen_with_transmittance_0(_S1284, _S1285, _S1282, _S1286);
    return make_float3 (_S1287.y) * body_0 + make_float3 ((_S1271->light_visibility_1 + _S1271->hole_2) * _S1287.x);
}

__device__ float4  light_of_footprint_0(int _S1288, uint _S1289, VisiblePoint_0 * _S1290, uint2  _S1291, float3  _S1292)
{
    Frame_0 * _S1293 = (&(globalParams_0->frames_0)[_S1288]);
    Fabric_0 * _S1294 = (&(globalParams_0->fabrics_0)[_S1289]);
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = _S1290->draft_0;
    (&footprint_0)->dx_0 = _S1290->draft_dx_0;
    (&footprint_0)->dy_0 = _S1290->draft_dy_0;
    uint _S1295 = __ldg(&_S1293->pass_number_0);
    float2  _S1296 = frac_0(make_float2 (float(_S1295 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f));
    float3  _S1297 = to_local_0(_S1290, _S1290->view_0);
    uint _S1298 = light_sample_count_0(_S1288);
    float3  _S1299 = make_float3 (0.0f);
    uint number_7 = 0U;
    float3  radiance_1 = _S1299;
    float hole_7 = 0.0f;
    for(;;)
    {
        if(number_7 < (U32_max((_S1298), (1U))))
        {
        }
        else
        {
            break;
        }
        float _S1300;
        if(number_7 < _S1298)
        {
            float _S1301 = visibility_at_0(_S1288, number_7, _S1291);
            _S1300 = _S1301;
        }
        else
        {
            _S1300 = 0.0f;
        }
        bool _S1302;
        if(_S1300 <= 0.0f)
        {
            _S1302 = number_7 > 0U;
        }
        else
        {
            _S1302 = false;
        }
        if(_S1302)
        {
            number_7 = number_7 + 1U;
            continue;
        }
        LightSample_0 _S1303 = light_sample_0(_S1288, number_7, _S1291, _S1290->position_0);
        float3  _S1304 = to_local_0(_S1290, _S1303.towards_0);
        Footprint_0 _S1305 = footprint_0;
        Estimate_0 _S1306 = lobes_estimate_of_pass_0(_S1289, &_S1305, 1.0f, _S1296, _S1304, _S1297);
        FamilyAlbedos_0 albedos_10;
        Albedos_0 _S1307 = _S1306.albedos_5.warp_2;
        Albedos_0 _S1308 = tinted_0(&_S1307, _S1292);
        (&albedos_10)->warp_2 = _S1308;
        Albedos_0 _S1309 = _S1306.albedos_5.weft_2;
        Albedos_0 _S1310 = tinted_0(&_S1309, _S1292);
        (&albedos_10)->weft_2 = _S1310;
        float3  _S1311 = make_float3 (_S1300) * _S1303.irradiance_1;
        Components_0 _S1312 = _S1306.components_0;
        FamilyAlbedos_0 _S1313 = albedos_10;
        float3  _S1314 = composed_0(_S1289, &_S1312, &_S1313, _S1304, _S1297);
        radiance_1 = radiance_1 + _S1311 * _S1314;
        hole_7 = _S1306.components_0.hole_2;
        number_7 = number_7 + 1U;
    }
    float _S1315 = __ldg(&_S1294->sheen_strength_0);
    if(_S1315 > 0.0f)
    {
        float _S1316 = (F32_abs((_S1297.z)));
        float _S1317 = __ldg(&_S1294->sheen_roughness_0);
        hole_7 = hole_7 * (1.0f - _S1315 * sheen_lobe_0(_S1316, _S1317).z);
    }
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f - hole_7);
}

extern "C" __global__ void shade_lobes()
{
    uint3  _S1318 = blockIdx * blockDim + threadIdx;
    Frame_0 * _S1319 = (&(globalParams_0->frames_0)[int(0)]);
    uint _S1320 = _S1318.x;
    uint _S1321 = __ldg(&_S1319->width_0);
    bool _S1322;
    if(_S1320 >= _S1321)
    {
        _S1322 = true;
    }
    else
    {
        uint _S1323 = _S1318.y;
        uint _S1324 = __ldg(&_S1319->height_0);
        _S1322 = _S1323 >= _S1324;
    }
    if(_S1322)
    {
        return;
    }
    uint _S1325 = _S1318.y * _S1321 + _S1320;
    uint _S1326 = (&(globalParams_0->layers_0)[_S1325])->face_0;
    if(((&(globalParams_0->layers_0)[_S1325])->face_0) == 0U)
    {
        return;
    }
    uint _S1327 = _S1326 - 1U;
    uint _S1328 = __ldg((&(globalParams_0->face_fabrics_0)[_S1327]));
    uint2  _S1329 = uint2 {_S1318.x, _S1318.y};
    VisiblePoint_0 _S1330 = visible_point_0(int(0), _S1328, _S1327, _S1329);
    VisiblePoint_0 _S1331 = _S1330;
    float3  _S1332 = filtered_albedo_0(_S1328, &_S1331);
    VisiblePoint_0 _S1333 = _S1330;
    float4  _S1334 = light_of_footprint_0(int(0), _S1328, &_S1333, _S1329, _S1332);
    accumulate_0(_S1325, _S1334);
    return;
}

