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

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    uint run_words_0;
    uint ends_0;
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

struct Bake_0
{
    uint fabric_0;
    uint per_family_0;
    uint packs_1;
    uint max_clusters_0;
    uint rays_0;
    float ends_1;
    float picks_0;
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

__device__ Frame_0 slang_ldg_0(Frame_0 * ptr_0)
{
    uint _S7 = __ldg(&ptr_0->width_0);
    uint _S8 = __ldg(&ptr_0->height_0);
    uint _S9 = __ldg(&ptr_0->lights_0);
    uint _S10 = __ldg(&ptr_0->samples_0);
    uint _S11 = __ldg(&ptr_0->pass_number_0);
    float _S12 = __ldg(&ptr_0->jitter_x_0);
    float _S13 = __ldg(&ptr_0->jitter_y_0);
    float _S14 = __ldg(&ptr_0->gain_0);
    float _S15 = __ldg(&ptr_0->origin_x_0);
    float _S16 = __ldg(&ptr_0->origin_y_0);
    float _S17 = __ldg(&ptr_0->origin_z_0);
    float _S18 = __ldg(&ptr_0->right_x_0);
    float _S19 = __ldg(&ptr_0->right_y_0);
    float _S20 = __ldg(&ptr_0->right_z_0);
    float _S21 = __ldg(&ptr_0->up_x_0);
    float _S22 = __ldg(&ptr_0->up_y_0);
    float _S23 = __ldg(&ptr_0->up_z_0);
    float _S24 = __ldg(&ptr_0->forward_x_0);
    float _S25 = __ldg(&ptr_0->forward_y_0);
    float _S26 = __ldg(&ptr_0->forward_z_0);
    float _S27 = __ldg(&ptr_0->near_0);
    float _S28 = __ldg(&ptr_0->background_red_0);
    float _S29 = __ldg(&ptr_0->background_green_0);
    float _S30 = __ldg(&ptr_0->background_blue_0);
    Frame_0 _S31 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19, _S20, _S21, _S22, _S23, _S24, _S25, _S26, _S27, _S28, _S29, _S30 };
    return _S31;
}

__device__ Lobes_0 slang_ldg_1(Lobes_0 * ptr_1)
{
    uint _S32 = __ldg(&ptr_1->is_baked_0);
    float _S33 = __ldg(&ptr_1->inverse_base_size_0);
    float _S34 = __ldg(&ptr_1->last_level_0);
    uint _S35 = __ldg(&ptr_1->levels_0);
    uint _S36 = __ldg(&ptr_1->face_nodes_0);
    uint _S37 = __ldg(&ptr_1->packs_0);
    uint _S38 = __ldg(&ptr_1->front_warp_packs_0);
    uint _S39 = __ldg(&ptr_1->back_warp_packs_0);
    uint _S40 = __ldg(&ptr_1->coverage_0);
    uint _S41 = __ldg(&ptr_1->coverage_holes_0);
    uint _S42 = __ldg(&ptr_1->projected_area_0);
    uint _S43 = __ldg(&ptr_1->light_visibility_0);
    uint _S44 = __ldg(&ptr_1->irradiance_0);
    uint _S45 = __ldg(&ptr_1->moments_0);
    float _S46 = __ldg(&ptr_1->front_hole_weight_0);
    float _S47 = __ldg(&ptr_1->back_hole_weight_0);
    float _S48 = __ldg(&ptr_1->threads_per_mm_0);
    float _S49 = __ldg(&ptr_1->unit_level_0);
    Lobes_0 _S50 = { _S32, _S33, _S34, _S35, _S36, _S37, _S38, _S39, _S40, _S41, _S42, _S43, _S44, _S45, _S46, _S47, _S48, _S49 };
    return _S50;
}

__device__ Vertex_0 slang_ldg_2(Vertex_0 * ptr_2)
{
    float _S51 = __ldg(&ptr_2->x_1);
    float _S52 = __ldg(&ptr_2->y_1);
    float _S53 = __ldg(&ptr_2->z_1);
    float _S54 = __ldg(&ptr_2->normal_x_0);
    float _S55 = __ldg(&ptr_2->normal_y_0);
    float _S56 = __ldg(&ptr_2->normal_z_0);
    float _S57 = __ldg(&ptr_2->u_0);
    float _S58 = __ldg(&ptr_2->v_0);
    Vertex_0 _S59 = { _S51, _S52, _S53, _S54, _S55, _S56, _S57, _S58 };
    return _S59;
}

__device__ float3  position_of_0(Vertex_0 * vertex_0)
{
    return make_float3 (vertex_0->x_1, vertex_0->y_1, vertex_0->z_1);
}

__device__ float square_0(float3  v_1)
{
    return dot_0(v_1, v_1);
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
    return make_float3 (dot_0(direction_0, point_0->axis_x_0), dot_0(direction_0, point_0->axis_y_0), dot_0(direction_0, point_0->normal_0));
}

__device__ Light_0 slang_ldg_3(Light_0 * ptr_3)
{
    uint _S60 = __ldg(&ptr_3->is_point_0);
    float _S61 = __ldg(&ptr_3->x_0);
    float _S62 = __ldg(&ptr_3->y_0);
    float _S63 = __ldg(&ptr_3->z_0);
    float _S64 = __ldg(&ptr_3->red_0);
    float _S65 = __ldg(&ptr_3->green_0);
    float _S66 = __ldg(&ptr_3->blue_0);
    Light_0 _S67 = { _S60, _S61, _S62, _S63, _S64, _S65, _S66 };
    return _S67;
}

__device__ float3  towards_light_0(Light_0 * light_0, float3  position_1, float3  * irradiance_1)
{
    *irradiance_1 = make_float3 (light_0->red_0, light_0->green_0, light_0->blue_0);
    float3  _S68 = make_float3 (light_0->x_0, light_0->y_0, light_0->z_0);
    if((light_0->is_point_0) == 0U)
    {
        return _S68;
    }
    float3  _S69 = _S68 - position_1;
    *irradiance_1 = *irradiance_1 / make_float3 ((F32_max((square_0(_S69)), (9.999999960041972e-13f))));
    return normalize_0(_S69);
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

__device__ float natural_logarithm_0(float x_18)
{
    uint _S70 = (F32_asuint((x_18)));
    float exponent_0 = float(int(_S70 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S70 & 8388607U) | 1056964608U)));
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
    float _S71 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S71 - exponent_1 * 0.00021219444170129f - 0.5f * _S71) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_19)
{
    return natural_logarithm_0(x_19) * 1.4426950216293335f;
}

__device__ float3  to_face_frame_0(float3  direction_1, bool back_0)
{
    float2  _S72 = float2 {direction_1.x, direction_1.y};
    float _S73;
    if(back_0)
    {
        _S73 = - direction_1.z;
    }
    else
    {
        _S73 = direction_1.z;
    }
    return make_float3 (_S72.x, _S72.y, _S73);
}

__device__ Family_0 slang_ldg_4(Family_0 * ptr_4)
{
    uint _S74 = __ldg(&ptr_4->is_alike_0);
    float _S75 = __ldg(&ptr_4->count_0);
    float _S76 = __ldg(&ptr_4->inverse_count_0);
    float _S77 = __ldg(&ptr_4->half_inverse_count_0);
    float _S78 = __ldg(&ptr_4->size_0);
    float _S79 = __ldg(&ptr_4->inverse_size_0);
    float _S80 = __ldg(&ptr_4->half_width_0);
    float _S81 = __ldg(&ptr_4->start_0);
    float _S82 = __ldg(&ptr_4->period_0);
    float _S83 = __ldg(&ptr_4->inverse_period_0);
    float _S84 = __ldg(&ptr_4->bins_0);
    uint _S85 = __ldg(&ptr_4->first_thread_table_0);
    uint _S86 = __ldg(&ptr_4->place_table_0);
    uint _S87 = __ldg(&ptr_4->bend_table_0);
    float _S88 = __ldg(&ptr_4->height_scale_0);
    float _S89 = __ldg(&ptr_4->twist_sine_0);
    float _S90 = __ldg(&ptr_4->twist_cosine_0);
    float _S91 = __ldg(&ptr_4->level_0);
    float _S92 = __ldg(&ptr_4->roughness_0);
    uint _S93 = __ldg(&ptr_4->albedo_table_0);
    uint _S94 = __ldg(&ptr_4->albedo_stride_0);
    uint _S95 = __ldg(&ptr_4->before_0);
    float _S96 = __ldg(&ptr_4->visible_total_0);
    float _S97 = __ldg(&ptr_4->smallest_box_0);
    uint _S98 = __ldg(&ptr_4->quantities_0);
    uint _S99 = __ldg(&ptr_4->colour_mean_0);
    uint _S100 = __ldg(&ptr_4->colour_axes_0);
    uint _S101 = __ldg(&ptr_4->colour_threads_0);
    uint _S102 = __ldg(&ptr_4->colour_areas_0);
    float _S103 = __ldg(&ptr_4->area_unit_0);
    float _S104 = __ldg(&ptr_4->crossing_area_0);
    Family_0 _S105 = { _S74, _S75, _S76, _S77, _S78, _S79, _S80, _S81, _S82, _S83, _S84, _S85, _S86, _S87, _S88, _S89, _S90, _S91, _S92, _S93, _S94, _S95, _S96, _S97, _S98, _S99, _S100, _S101, _S102, _S103, _S104 };
    return _S105;
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
    SurfacePoint_0 _S106;
    (&_S106)->hole_0 = hole_1;
    (&_S106)->is_warp_0 = is_warp_1;
    (&_S106)->warp_thread_0 = warp_thread_1;
    (&_S106)->weft_thread_0 = weft_thread_1;
    (&_S106)->height_1 = height_2;
    (&_S106)->normal_1 = normal_2;
    (&_S106)->tangent_0 = tangent_1;
    (&_S106)->across_0 = across_1;
    (&_S106)->fibre_across_0 = fibre_across_1;
    (&_S106)->fibre_along_0 = fibre_along_1;
    return _S106;
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
    float _S107 = clamp_1((-3.0f - binary_logarithm_0((F32_max((threads_0), (9.99999971718068537e-10f))))) / 2.0f, 0.0f, 1.0f);
    SearchQuality_0 quality_0;
    float _S108 = lerp_1(2.5f, 5.0f, _S107);
    (&quality_0)->steps_per_thread_0 = _S108;
    (&quality_0)->steps_per_relief_0 = _S108;
    (&quality_0)->shadow_share_0 = lerp_1(1.60000002384185791f, 1.0f, _S107);
    (&quality_0)->refinements_0 = uint(lerp_1(1.0f, 2.0f, _S107) + 0.5f);
    return quality_0;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_0)
{
    Family_0 _S109 = slang_ldg_4((&(globalParams_0->families_0)[family_0]));
    Family_0 _S110 = slang_ldg_4((&(globalParams_0->families_0)[family_0]));
    float _S111 = (F32_floor(((F32_fma((index_0), (_S109.inverse_count_0), (_S110.half_inverse_count_0))))));
    float _S112 = - _S111;
    Family_0 _S113 = slang_ldg_4((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S111, (F32_fma((_S112), (_S113.count_0), (index_0))));
}

struct Cell_0
{
    uint thread_0;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_2)
{
    Family_0 _S114 = slang_ldg_4((&(globalParams_0->families_0)[family_1]));
    float _S115 = (F32_floor((position_2 * _S114.inverse_size_0)));
    Cell_0 cell_0;
    float _S116 = - _S115;
    Family_0 _S117 = slang_ldg_4((&(globalParams_0->families_0)[family_1]));
    float _S118 = (F32_fma((_S116), (_S117.size_0), (position_2)));
    (&cell_0)->below_0 = _S118;
    Family_0 _S119 = slang_ldg_4((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->above_0 = _S119.size_0 - _S118;
    Family_0 _S120 = slang_ldg_4((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->across_2 = _S118 - 0.5f * _S120.size_0;
    Family_0 _S121 = slang_ldg_4((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->half_width_1 = _S121.half_width_0;
    float _S122 = turns_and_remainder_0(family_1, _S115).y;
    Family_0 _S123 = slang_ldg_4((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->thread_0 = uint(clamp_1(_S122, 0.0f, _S123.count_0 - 1.0f));
    return cell_0;
}

__device__ float table_number_0(uint index_1)
{
    uint _S124 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S124)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_3)
{
    Family_0 _S125 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    float _S126 = position_3 - _S125.start_0;
    Family_0 _S127 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S126 * _S127.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S128 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    float _S129 = turns_1 * _S128.period_0;
    Family_0 _S130 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    float _S131 = turns_1 * _S130.bins_0;
    Family_0 _S132 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    uint _S133 = uint(clamp_1(_S131, 0.0f, _S132.bins_0 - 1.0f));
    Family_0 _S134 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    uint _S135 = __ldg((&(globalParams_0->words_0)[_S134.first_thread_table_0 + _S133]));
    Family_0 _S136 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    uint _S137;
    if(_S129 >= (table_number_0(_S136.place_table_0 + _S135 * 4U + 1U)))
    {
        _S137 = 1U;
    }
    else
    {
        _S137 = 0U;
    }
    uint _S138 = _S135 + _S137;
    Family_0 _S139 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    uint _S140 = (U32_min((_S138), (uint(_S139.count_0) - 1U)));
    Family_0 _S141 = slang_ldg_4((&(globalParams_0->families_0)[family_2]));
    uint _S142 = _S141.place_table_0 + _S140 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S140;
    (&cell_1)->below_0 = _S129 - table_number_0(_S142);
    (&cell_1)->above_0 = table_number_0(_S142 + 1U) - _S129;
    (&cell_1)->across_2 = _S129 - table_number_0(_S142 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S142 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_4)
{
    Family_0 _S143 = slang_ldg_4((&(globalParams_0->families_0)[family_3]));
    if((_S143.is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_4);
    }
    return locate_varied_0(family_3, position_4);
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

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_1)
{
    bool _S144 = (F32_abs(((&crossing_0->warp_1)->across_2))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S145 = (F32_abs(((&crossing_0->weft_1)->across_2))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S146;
    if(_S144)
    {
        if(!_S145)
        {
            _S146 = true;
        }
        else
        {
            _S146 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S146 = false;
    }
    (&shown_0)->is_warp_2 = _S146;
    if(!_S144)
    {
        _S146 = !_S145;
    }
    else
    {
        _S146 = false;
    }
    (&shown_0)->hole_3 = _S146;
    uint _S147;
    if((&shown_0)->is_warp_2)
    {
        _S147 = crossing_0->warp_word_0;
    }
    else
    {
        _S147 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S147;
    (&shown_0)->on_top_0 = ((_S147 & 1U) == 1U) != back_1;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_2;
    uint _S148;
    if(is_first_0)
    {
        _S148 = first_0->thread_0;
    }
    else
    {
        _S148 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S148;
    float _S149;
    if(is_first_0)
    {
        _S149 = first_0->across_2;
    }
    else
    {
        _S149 = second_0->across_2;
    }
    (&cell_2)->across_2 = _S149;
    if(is_first_0)
    {
        _S149 = first_0->half_width_1;
    }
    else
    {
        _S149 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S149;
    if(is_first_0)
    {
        _S149 = first_0->below_0;
    }
    else
    {
        _S149 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S149;
    if(is_first_0)
    {
        _S149 = first_0->above_0;
    }
    else
    {
        _S149 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S149;
    return cell_2;
}

__device__ float boundary_0(uint family_4, uint thread_1, int step_0)
{
    float2  _S150 = turns_and_remainder_0(family_4, float(int(thread_1) + step_0));
    float _S151 = _S150.x;
    Family_0 _S152 = slang_ldg_4((&(globalParams_0->families_0)[family_4]));
    Family_0 _S153 = slang_ldg_4((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S151), (_S152.period_0), (table_number_0(_S153.place_table_0 + uint(_S150.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_2, int first_1, int last_0)
{
    Family_0 _S154 = slang_ldg_4((&(globalParams_0->families_0)[family_5]));
    if((_S154.is_alike_0) != 0U)
    {
        float _S155 = float(last_0 - first_1);
        Family_0 _S156 = slang_ldg_4((&(globalParams_0->families_0)[family_5]));
        return _S155 * _S156.size_0;
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
    Family_0 _S157 = slang_ldg_4((&(globalParams_0->families_0)[family_6]));
    Family_0 _S158 = slang_ldg_4((&(globalParams_0->families_0)[family_6]));
    uint _S159;
    if((_S158.is_alike_0) != 0U)
    {
        _S159 = 0U;
    }
    else
    {
        _S159 = thread_3 * 4U;
    }
    uint _S160 = _S157.bend_table_0 + _S159;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S160);
    (&bend_0)->half_tangent_0 = table_number_0(_S160 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S160 + 2U);
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
    int _S161 = int((word_1 >> int(1)) & 127U);
    int _S162 = int((word_1 >> int(8)) & 127U);
    int _S163 = int((word_1 >> int(15)) & 63U);
    int _S164 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S165 = crossed_0->thread_0;
    int _S166 = - _S161;
    float _S167 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_0, _S166, int(0));
    (&run_0)->from_start_0 = _S167;
    int _S168 = _S162 + int(1);
    float _S169 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_0, int(1), _S168);
    (&run_0)->to_end_0 = _S169;
    bool _S170 = _S167 < _S169;
    (&run_0)->near_start_0 = _S170;
    int _S171;
    if(_S170)
    {
        _S171 = _S166 - _S163;
    }
    else
    {
        _S171 = _S168;
    }
    int _S172;
    if((&run_0)->near_start_0)
    {
        _S172 = _S166;
    }
    else
    {
        _S172 = _S168 + _S164;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_4);
    float _S173;
    if((&run_0)->straight_0)
    {
        _S173 = 1.0e+06f;
    }
    else
    {
        _S173 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S173;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S165, _S171, _S172)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S161 == int(0);
    (&run_0)->last_crossing_0 = _S162 == int(0);
    return run_0;
}

__device__ float square_1(float x_20)
{
    return x_20 * x_20;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_3)
{
    float _S174 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S175 = clamp_1(cell_3->across_2, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_3 = _S175;
    float _S176 = _S174 * _S174 - square_1(_S175);
    float _S177 = (F32_rsqrt((_S176)));
    (&section_0)->drop_0 = _S174 - _S176 * _S177;
    (&section_0)->slope_0 = - _S175 * _S177;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_5, int step_1)
{
    Family_0 _S178 = slang_ldg_4((&(globalParams_0->families_0)[family_7]));
    if((_S178.is_alike_0) != 0U)
    {
        Family_0 _S179 = slang_ldg_4((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S179.bend_table_0 + 3U);
    }
    Family_0 _S180 = slang_ldg_4((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S180.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_5) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S181 = crossed_1->below_0;
    float _S182 = crossed_1->above_0;
    bool _S183 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S184 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S185;
    if(_S183)
    {
        _S185 = _S181 - crossed_1->across_2;
    }
    else
    {
        _S185 = _S182 + crossed_1->across_2;
    }
    float _S186 = _S185 - crossed_1->half_width_1;
    bool _S187;
    if(_S183)
    {
        _S187 = run_1->first_crossing_0;
    }
    else
    {
        _S187 = run_1->last_crossing_0;
    }
    bool _S188 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S185 = 0.0f;
    }
    else
    {
        Family_0 _S189 = slang_ldg_4((&(globalParams_0->families_0)[other_1]));
        _S185 = _S189.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_0, int(0));
    }
    float _S190;
    if(_S188 != _S187)
    {
        _S190 = 0.0f;
    }
    else
    {
        Family_0 _S191 = slang_ldg_4((&(globalParams_0->families_0)[other_1]));
        uint _S192 = crossed_1->thread_0;
        int _S193;
        if(_S183)
        {
            _S193 = int(-1);
        }
        else
        {
            _S193 = int(1);
        }
        _S190 = _S191.height_scale_0 * edge_drop_0(other_1, _S192, _S193);
    }
    float _S194 = 1.0f / (F32_max((2.0f * _S186), (9.999999960041972e-13f)));
    float _S195 = clamp_1((_S186 - _S184) * _S194, 0.0f, 1.0f);
    float _S196 = _S185 + (_S190 - _S185) * (_S195 * _S195 * (3.0f - 2.0f * _S195));
    float _S197 = (_S185 - _S190) * (6.0f * _S195 * (1.0f - _S195) * _S194);
    if(_S183)
    {
        _S185 = 1.0f;
    }
    else
    {
        _S185 = -1.0f;
    }
    return make_float2 (_S196, _S197 * _S185);
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
    float _S198 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S198)))), (9.99999971718068537e-10f)));
    float _S199 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S199)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S198 > 0.0f;
    (&control_0)->up_0 = _S199 > 0.0f;
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
    float _S200;
    if(forwards_0)
    {
        _S200 = cell_4->across_2;
    }
    else
    {
        _S200 = - cell_4->across_2;
    }
    float _S201;
    if(forwards_0)
    {
        _S201 = cell_4->above_0;
    }
    else
    {
        _S201 = cell_4->below_0;
    }
    bool _S202;
    if(forwards_0)
    {
        _S202 = run_2->last_crossing_0;
    }
    else
    {
        _S202 = run_2->first_crossing_0;
    }
    bool _S203;
    if(forwards_0)
    {
        _S203 = run_2->first_crossing_0;
    }
    else
    {
        _S203 = run_2->last_crossing_0;
    }
    float _S204 = cell_4->half_width_1;
    float _S205 = - cell_4->half_width_1;
    bool _S206 = _S200 < _S205;
    bool _S207 = _S200 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S202 = !_S202;
    }
    else
    {
        _S202 = false;
    }
    if(_S202)
    {
        _S202 = !shown_2->hole_3;
    }
    else
    {
        _S202 = false;
    }
    bool _S208;
    if(_S202)
    {
        _S208 = shown_2->on_top_0;
    }
    else
    {
        _S208 = false;
    }
    if(_S208)
    {
        if(_S203)
        {
            _S203 = _S206;
        }
        else
        {
            _S203 = false;
        }
        _S203 = !_S203;
    }
    else
    {
        _S203 = false;
    }
    if(shown_2->hole_3)
    {
        _S202 = true;
    }
    else
    {
        if(_S202)
        {
            _S202 = !shown_2->on_top_0;
        }
        else
        {
            _S202 = false;
        }
    }
    float _S209;
    if(_S206)
    {
        _S209 = _S205;
    }
    else
    {
        _S209 = _S204;
    }
    float _S210 = _S209 - _S200;
    if(_S202)
    {
        _S200 = 2.0f * _S201 + _S200 - _S204;
    }
    else
    {
        _S200 = _S201;
    }
    if(_S203)
    {
        if(forwards_0)
        {
            _S200 = run_2->to_end_0;
        }
        else
        {
            _S200 = run_2->from_start_0;
        }
        return _S200;
    }
    if(_S207)
    {
    }
    else
    {
        _S200 = _S210;
    }
    return _S200;
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
    float _S211 = previous_1->rate_0;
    float _S212 = previous_1->rate_0 * step_4;
    float _S213 = rate_1 * step_4;
    bool _S214;
    if(!previous_1->known_0)
    {
        _S214 = true;
    }
    else
    {
        _S214 = here_0->hole_4;
    }
    if(_S214)
    {
        _S214 = true;
    }
    else
    {
        _S214 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S214)
    {
        _S214 = true;
    }
    else
    {
        _S214 = _S211 >= 0.0f;
    }
    if(_S214)
    {
        _S214 = true;
    }
    else
    {
        _S214 = rate_1 <= 0.0f;
    }
    if(_S214)
    {
        return -1.0f;
    }
    float _S215 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S212) >= 0.0f)
    {
        _S214 = (3.0f * clearance_1 - _S213) >= 0.0f;
    }
    else
    {
        _S214 = false;
    }
    if(_S214)
    {
        return -1.0f;
    }
    float _S216 = clearance_1 - _S215;
    float _S217 = 6.0f * _S216 - 4.0f * _S212 - 2.0f * _S213;
    float _S218 = -2.0f * _S212 / (F32_max((_S217 + (F32_sqrt(((F32_max((_S217 * _S217 - 4.0f * (3.0f * (_S212 + _S213 - 2.0f * _S216)) * _S212), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S219 = 1.0f - _S218;
    float _S220 = (_S215 * (2.0f * _S218 + 1.0f) + _S212 * _S218) * _S219 * _S219;
    float _S221 = (clearance_1 * (2.0f * _S219 + 1.0f) - _S213 * _S219) * _S218 * _S218;
    if(_S218 > 0.01999999955296516f)
    {
        _S214 = _S219 > 0.01999999955296516f;
    }
    else
    {
        _S214 = false;
    }
    if(_S214)
    {
        _S214 = (_S220 + _S221) < 0.0f;
    }
    else
    {
        _S214 = false;
    }
    float _S222;
    if(_S214)
    {
        _S222 = _S219 * step_4;
    }
    else
    {
        _S222 = -1.0f;
    }
    return _S222;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S223 = here_1->hole_4;
    float _S224;
    if(here_1->hole_4)
    {
        _S224 = 1.0e+09f;
    }
    else
    {
        _S224 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S224;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S225;
    if(!_S223)
    {
        _S225 = !is_cell_exit_0;
    }
    else
    {
        _S225 = false;
    }
    (&previous_2)->known_0 = _S225;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S226 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S227;
    if(!here_2->hole_4)
    {
        _S227 = (rate_3 * _S226 + clearance_3) < 0.0f;
    }
    else
    {
        _S227 = false;
    }
    if(_S227)
    {
        _S227 = _S226 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S227 = false;
    }
    float _S228 = this_2->step_2;
    float _S229;
    if(_S227)
    {
        _S229 = _S226 - this_2->epsilon_0;
    }
    else
    {
        _S229 = (F32_max((_S226), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S228), (_S229)));
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
    float _S230 = end_0 - start_1;
    float _S231 = start_rate_0 + end_rate_0 - 2.0f * _S230;
    float _S232 = 3.0f * _S230 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / (F32_max((- _S230), (9.99999968265522539e-21f)));
    int i_7 = int(0);
    for(;;)
    {
        if(uint(i_7) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S233 = clamp_1(share_0 - (((_S231 * share_0 + _S232) * share_0 + start_rate_0) * share_0 + start_1) / (F32_min(((3.0f * _S231 * share_0 + 2.0f * _S232) * share_0 + start_rate_0), (0.10000000149011612f * _S230 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S234 = i_7 + int(1);
        share_0 = _S233;
        i_7 = _S234;
    }
    return share_0;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_1(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S235 = along_slope_0 * along_slope_0 + 1.0f;
    float _S236 = (F32_rsqrt((_S235)));
    float _S237 = sine_1 * _S236 * (F32_rsqrt((_S235 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S237 * _S235, _S237 * across_slope_0 * along_slope_0 + cosine_0 * _S236);
}

__device__ float arc_sine_0(float x_21)
{
    float _S238 = (F32_abs((x_21)));
    bool _S239 = _S238 > 0.5f;
    float _S240;
    if(_S239)
    {
        _S240 = 0.5f * (1.0f - _S238);
    }
    else
    {
        _S240 = _S238 * _S238;
    }
    float _S241;
    if(_S239)
    {
        _S241 = (F32_sqrt(((F32_max((_S240), (0.0f))))));
    }
    else
    {
        _S241 = _S238;
    }
    float _S242 = ((((0.04216320067644119f * _S240 + 0.02418131195008755f) * _S240 + 0.04547002539038658f) * _S240 + 0.07495300471782684f) * _S240 + 0.16666752099990845f) * _S240 * _S241 + _S241;
    if(_S239)
    {
        _S240 = 1.57079637050628662f - 2.0f * _S242;
    }
    else
    {
        _S240 = _S242;
    }
    if(x_21 < 0.0f)
    {
        _S240 = - _S240;
    }
    return _S240;
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
    Family_0 _S243 = slang_ldg_4((&(globalParams_0->families_0)[family_8]));
    Family_0 _S244 = slang_ldg_4((&(globalParams_0->families_0)[family_8]));
    return table_albedos_0(_S243.albedo_table_0 + _S244.albedo_stride_0 * thread_6);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S245 = value_0 * 747796405U + 2891336453U;
    uint _S246 = ((_S245 >> ((_S245 >> int(28)) + 4U)) ^ _S245) * 277803737U;
    return (_S246 >> int(22)) ^ _S246;
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
    float3  _S247 = room_0 / max_0(albedo_0, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S247.x), (_S247.y)))), (_S247.z)))), (0.0f))))));
}

__device__ float fibre_gain_0(uint thread_9, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_6, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

__device__ float diffuse_reflection_0(float3  light_1, float3  normal_3, float blend_0)
{
    float _S248 = light_1.z;
    if(_S248 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_1((F32_max((_S248), (0.0f))), (F32_max((dot_0(light_1, normal_3)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_3, float3  tangent_2, float roughness_1)
{
    float _S249 = dot_0(direction_3, tangent_2);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S249 * _S249 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_22)
{
    float _S250 = clamp_1(x_22, -87.0f, 88.0f);
    float _S251 = (F32_floor((_S250 * 1.4426950216293335f + 0.5f)));
    float _S252 = _S250 - _S251 * 0.693359375f + _S251 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S252 + 0.00139819993637502f) * _S252 + 0.00833345204591751f) * _S252 + 0.04166579619050026f) * _S252 + 0.1666666567325592f) * _S252 + 0.5f;
    float _S253 = (U32_asfloat((uint(int(_S251) + int(127)) << int(23))));
    float _S254;
    if(x_22 < -87.0f)
    {
        _S254 = 0.0f;
    }
    else
    {
        _S254 = (p_0 * _S252 * _S252 + _S252 + 1.0f) * _S253;
    }
    return _S254;
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
    float _S255 = roughness_2 * roughness_2;
    float _S256 = squared_along_0 * (1.0f - _S255) + _S255;
    return 0.31830987334251404f * _S255 * roughness_2 / (_S256 * _S256);
}

__device__ float density_between_0(float3  light_2, float3  view_1, float3  tangent_3, float roughness_3)
{
    float3  _S257 = light_2 + view_1;
    float _S258 = dot_0(_S257, tangent_3);
    return flake_density_0((F32_min((_S258 * _S258 / (F32_max((square_0(_S257)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float transmission_0(float3  light_3, float3  view_2, float3  normal_4, float3  tangent_4, float roughness_4, float optical_depth_1)
{
    float _S259 = - dot_0(light_3, normal_4);
    float _S260 = dot_0(view_2, normal_4);
    bool _S261;
    if(_S259 <= 0.0f)
    {
        _S261 = true;
    }
    else
    {
        _S261 = _S260 <= 0.0f;
    }
    if(_S261)
    {
        return 0.0f;
    }
    float _S262 = 1.0f / (F32_max((_S260), (9.99999997475242708e-07f)));
    float _S263 = projected_area_1(light_3, tangent_4, roughness_4) / (F32_max((_S259), (9.99999997475242708e-07f)));
    float _S264 = projected_area_1(view_2, tangent_4, roughness_4) * _S262;
    return density_between_0(light_3, view_2, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * (F32_min((_S263), (_S264)))) * mean_attenuation_0(optical_depth_1 * (F32_abs((_S263 - _S264)))) * _S262;
}

__device__ float reflection_0(float3  light_4, float3  view_3, float3  normal_5, float3  tangent_5, float roughness_5, float optical_depth_2)
{
    float _S265 = dot_0(light_4, normal_5);
    bool _S266;
    if(_S265 <= 0.0f)
    {
        _S266 = true;
    }
    else
    {
        _S266 = (dot_0(view_3, normal_5)) <= 0.0f;
    }
    if(_S266)
    {
        return 0.0f;
    }
    float _S267 = (F32_max((_S265), (9.99999997475242708e-07f)));
    float _S268 = (F32_max((dot_0(view_3, normal_5)), (9.99999997475242708e-07f)));
    float _S269 = projected_area_1(light_4, tangent_5, roughness_5) * _S268 + projected_area_1(view_3, tangent_5, roughness_5) * _S267;
    float _S270 = optical_depth_2 * _S269 / (_S267 * _S268);
    return 0.25f * density_between_0(light_4, view_3, tangent_5, roughness_5) * (_S270 * mean_attenuation_0(_S270)) * _S267 / _S269;
}

__device__ Components_0 with_added_0(Components_0 * sums_0, Components_0 * more_0, float weight_0)
{
    Components_0 result_10;
    (&result_10)->diffuse_warp_0 = sums_0->diffuse_warp_0 + weight_0 * more_0->diffuse_warp_0;
    (&result_10)->diffuse_weft_0 = sums_0->diffuse_weft_0 + weight_0 * more_0->diffuse_weft_0;
    (&result_10)->specular_warp_0 = sums_0->specular_warp_0 + weight_0 * more_0->specular_warp_0;
    (&result_10)->specular_weft_0 = sums_0->specular_weft_0 + weight_0 * more_0->specular_weft_0;
    (&result_10)->light_visibility_1 = sums_0->light_visibility_1 + weight_0 * more_0->light_visibility_1;
    (&result_10)->hole_2 = sums_0->hole_2 + weight_0 * more_0->hole_2;
    return result_10;
}

__device__ float wrapped_cell_0(float position_5, float count_1)
{
    return (F32_min(((F32_floor(((position_5 - (F32_floor((position_5)))) * count_1)))), (count_1 - 1.0f)));
}

__device__ float arc_tangent_quotient_0(float x_23, float y_12)
{
    return ((((((0.0f * x_23 + 0.00809729471802711f) * x_23 + -0.0377517081797123f) * x_23 + 0.08475969731807709f) * x_23 + -0.13537675142288208f) * x_23 + 0.19895026087760925f) * x_23 + -0.33327975869178772f) * x_23 + 0.99999970197677612f;
}

__device__ float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

__device__ float arc_tangent_0(float y_13, float x_24)
{
    float _S271 = (F32_abs((x_24)));
    float _S272 = (F32_abs((y_13)));
    float angle_0 = arc_tangent_of_ratio_0((F32_min((_S271), (_S272))) / (F32_max(((F32_max((_S271), (_S272)))), (1.00000000317107685e-30f))));
    float angle_1;
    if(_S272 > _S271)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_24 < 0.0f)
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
    float _S273 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    float _S274 = (F32_floor((_S273)));
    float _S275 = _S273 - _S274;
    float _S276 = (F32_sqrt((clamp_1((1.0f - (F32_abs((direction_4.z)))) / 0.97000002861022949f, 0.0f, 1.0f))));
    float _S277 = 7.0f * _S276 * (F32_sqrt((_S276)));
    float _S278 = (F32_min(((F32_floor((_S277)))), (6.0f)));
    float _S279 = _S277 - _S278;
    uint _S280 = uint(int(_S274) + int(32)) % 32U;
    uint _S281 = uint(_S278);
    uint _S282 = _S280 * 8U + _S281;
    uint _S283 = (_S280 + 1U) % 32U * 8U + _S281;
    NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = make_uint4 (_S282, _S282 + 1U, _S283, _S283 + 1U);
    float _S284 = 1.0f - _S275;
    float _S285 = 1.0f - _S279;
    float4  _S286 = make_float4 (_S284 * _S285, _S284 * _S279, _S275 * _S285, _S275 * _S279) * make_float4 (252.0f) + make_float4 (0.5f);
    uint4  _S287 = make_uint4 ((uint)_S286.x, (uint)_S286.y, (uint)_S286.z, (uint)_S286.w);
    (&taps_0)->weights_0 = _S287;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S287.x + _S287.y + _S287.z + _S287.w);
    return taps_0;
}

__device__ float3  half_vector_0(float3  light_5, float3  view_4)
{
    float3  _S288 = light_5 + view_4;
    return _S288 * make_float3 ((F32_rsqrt(((F32_max((square_0(_S288)), (9.999999960041972e-13f)))))));
}

__device__ float3  shadow_correlation_0(float3  light_6, float3  view_5)
{
    float2  _S289 = float2 {light_6.x, light_6.y};
    float2  _S290 = float2 {view_5.x, view_5.y};
    float _S291 = dot_1(_S289, _S290) / (F32_max(((F32_sqrt((dot_1(_S289, _S289) * dot_1(_S290, _S290))))), (9.99999997475242708e-07f)));
    if((light_6.z) < 0.0f)
    {
        return make_float3 (make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S291).x, make_float2 (-0.09000000357627869f + -0.07999999821186066f * _S291).y, 0.0f);
    }
    return make_float3 ((F32_min((0.62000000476837158f + 0.62999999523162842f * _S291), (1.20000004768371582f))), 0.62000000476837158f, 0.37000000476837158f);
}

__device__ float4  bytes_of_sums_0(uint even_0, uint odd_0)
{
    return make_float4 (float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

__device__ float4  interpolate_0(NodeTaps_0 * taps_1, uint4  packs_2)
{
    uint4  _S292 = (packs_2 & make_uint4 (16711935U)) * taps_1->weights_0;
    uint4  _S293 = ((packs_2 >> make_uint4 (int(8))) & make_uint4 (16711935U)) * taps_1->weights_0;
    return bytes_of_sums_0(_S292.x + _S292.y + _S292.z + _S292.w, _S293.x + _S293.y + _S293.z + _S293.w) * make_float4 (taps_1->inverse_sum_0);
}

__device__ float4  interpolate_table_0(NodeTaps_0 * taps_2, uint table_0, uint stride_0)
{
    uint4  _S294 = make_uint4 (table_0) + taps_2->nodes_0 * make_uint4 (stride_0);
    uint _S295 = __ldg((&(globalParams_0->words_0)[_S294.x]));
    uint _S296 = __ldg((&(globalParams_0->words_0)[_S294.y]));
    uint _S297 = __ldg((&(globalParams_0->words_0)[_S294.z]));
    uint _S298 = __ldg((&(globalParams_0->words_0)[_S294.w]));
    float4  _S299 = interpolate_0(taps_2, make_uint4 (_S295, _S296, _S297, _S298));
    return _S299;
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
    float3  _S300 = make_float3 (table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    (&group_0)->tangent_6 = _S300;
    float _S301 = table_number_0(row_1 + 7U);
    float _S302 = table_number_0(row_1 + 8U);
    (&group_0)->variance_0 = make_float3 (_S301, _S302, 1.0f - square_0(_S300) - _S301 - _S302);
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
    float _S303 = direction_5.x;
    float _S304 = direction_5.y;
    float _S305 = direction_5.z;
    return (F32_max((dot_0(this_5->variance_0, direction_5 * direction_5) + 2.0f * dot_0(this_5->covariance_0, make_float3 (_S303 * _S304, _S303 * _S305, _S304 * _S305))), (0.0f)));
}

__device__ float mean_area_0(Group_0 * group_1, float3  direction_6)
{
    float _S306 = dot_0(direction_6, group_1->tangent_6);
    float _S307 = _S306 * _S306;
    float _S308 = Group_variance_along_0(group_1, direction_6);
    float _S309 = group_1->roughness_6 * group_1->roughness_6;
    return (F32_sqrt(((F32_max(((_S309 - 1.0f) * (_S307 + _S308) + 1.0f), (_S309))))));
}

__device__ float mean_density_0(Group_0 * group_2, float3  half_0)
{
    float _S310 = group_2->roughness_6;
    float _S311 = (F32_max(((F32_sqrt(((F32_max((1.0f - group_2->roughness_6 * group_2->roughness_6), (0.0f)))))) / group_2->roughness_6), (0.00100000004749745f)));
    float _S312 = Group_variance_along_0(group_2, half_0);
    float _S313 = (F32_max(((F32_sqrt((3.0f * _S312)))), (_S310 * 0.01999999955296516f + 0.00009999999747379f)));
    float _S314 = dot_0(half_0, group_2->tangent_6);
    float _S315 = _S311 * (_S314 - _S313);
    float _S316 = _S311 * (_S314 + _S313);
    float _S317 = _S315 * _S316;
    float _S318 = 2.0f * _S313 * _S311;
    return 0.15915493667125702f / _S310 * ((1.0f - _S317) / ((_S315 * _S315 + 1.0f) * (_S316 * _S316 + 1.0f)) + arc_tangent_0(_S318, 1.0f + _S317) / _S318);
}

__device__ float layer_value_0(Group_0 * group_3, float3  half_1, float3  light_7, float3  view_6, float optical_depth_3)
{
    bool _S319 = (light_7.z) < 0.0f;
    float3  _S320 = group_3->normal_6;
    float _S321 = dot_0(light_7, group_3->normal_6);
    float _S322;
    if(_S319)
    {
        _S322 = - _S321;
    }
    else
    {
        _S322 = _S321;
    }
    float _S323 = (F32_max((_S322), (0.01999999955296516f)));
    float _S324 = (F32_max((dot_0(view_6, _S320)), (0.01999999955296516f)));
    float _S325 = mean_area_0(group_3, light_7);
    float _S326 = _S325 / _S323;
    float _S327 = mean_area_0(group_3, view_6);
    float _S328 = _S327 / _S324;
    if(_S319)
    {
        _S322 = (F32_abs((_S326 - _S328)));
    }
    else
    {
        _S322 = _S326 + _S328;
    }
    float _S329 = optical_depth_3 * (F32_max((_S322), (0.00100000004749745f)));
    if(_S319)
    {
        _S322 = exponential_0(- optical_depth_3 * (F32_min((_S326), (_S328))));
    }
    else
    {
        _S322 = 1.0f;
    }
    float _S330 = optical_depth_3 * _S322 * (1.0f - exponential_0(- _S329)) / _S329 / _S324;
    if(_S319)
    {
        _S322 = 1.0f;
    }
    else
    {
        _S322 = 1.0f - 0.34999999403953552f * (1.0f - square_0(_S320));
    }
    float _S331 = mean_density_0(group_3, half_1);
    return 0.25f * _S331 * _S322 * _S330;
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

__device__ Bound_0 bound_at_0(uint family_9, float position_6)
{
    Cell_0 _S332 = locate_0(family_9, position_6);
    Family_0 _S333 = slang_ldg_4((&(globalParams_0->families_0)[family_9]));
    float _S334 = table_number_0(_S333.before_0 + 2U * _S332.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_10 = _S332.thread_0;
    Family_0 _S335 = slang_ldg_4((&(globalParams_0->families_0)[family_9]));
    float _S336 = position_6 - _S335.start_0 - _S334 - _S332.below_0;
    Family_0 _S337 = slang_ldg_4((&(globalParams_0->families_0)[family_9]));
    (&bound_0)->turns_2 = (F32_round((_S336 * _S337.inverse_period_0)));
    (&bound_0)->cell_7 = _S332.below_0;
    float _S338 = 2.0f * _S332.half_width_1;
    (&bound_0)->width_1 = _S338;
    (&bound_0)->visible_0 = clamp_1((_S332.across_2 + _S332.half_width_1) / _S338, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S332.below_0), (_S332.below_0 - _S332.across_2 - _S332.half_width_1))) + (F32_max((_S332.across_2 - _S332.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

__device__ Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1)
{
    Family_0 _S339 = slang_ldg_4((&(globalParams_0->families_0)[family_10]));
    float _S340 = centre_1 - _S339.start_0;
    Family_0 _S341 = slang_ldg_4((&(globalParams_0->families_0)[family_10]));
    float _S342 = (F32_floor((_S340 * _S341.inverse_period_0)));
    Family_0 _S343 = slang_ldg_4((&(globalParams_0->families_0)[family_10]));
    float _S344 = centre_1 - _S342 * _S343.period_0;
    Family_0 _S345 = slang_ldg_4((&(globalParams_0->families_0)[family_10]));
    float _S346 = 0.5f * (F32_max((size_1), (_S345.smallest_box_0)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_0 = bound_at_0(family_10, _S344 - _S346);
    (&stretch_0)->high_0 = bound_at_0(family_10, _S344 + _S346);
    return stretch_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

__device__ float3  lengths_0(uint family_11, Stretch_0 * stretch_1)
{
    float _S347 = Stretch_turns_0(stretch_1);
    Family_0 _S348 = slang_ldg_4((&(globalParams_0->families_0)[family_11]));
    uint _S349 = _S348.before_0 + 2U * (&stretch_1->low_0)->thread_10;
    Family_0 _S350 = slang_ldg_4((&(globalParams_0->families_0)[family_11]));
    uint _S351 = _S350.before_0 + 2U * (&stretch_1->high_0)->thread_10;
    float _S352 = table_number_0(_S351) - table_number_0(_S349);
    float _S353 = table_number_0(_S351 + 1U) - table_number_0(_S349 + 1U);
    float _S354 = _S352 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_1 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_1;
    Family_0 _S355 = slang_ldg_4((&(globalParams_0->families_0)[family_11]));
    float _S356 = _S354 + _S347 * _S355.visible_total_0;
    float _S357 = _S353 - _S352 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0;
    Family_0 _S358 = slang_ldg_4((&(globalParams_0->families_0)[family_11]));
    Family_0 _S359 = slang_ldg_4((&(globalParams_0->families_0)[family_11]));
    float _S360 = _S357 + _S347 * (_S358.period_0 - _S359.visible_total_0);
    float _S361 = _S353 + (&stretch_1->high_0)->cell_7 - (&stretch_1->low_0)->cell_7;
    Family_0 _S362 = slang_ldg_4((&(globalParams_0->families_0)[family_11]));
    return make_float3 (_S356, _S360, _S361 + _S347 * _S362.period_0);
}

__device__ float2  integrals_along_0(uint family_12, Stretch_0 * stretch_2, uint quantity_0)
{
    Family_0 _S363 = slang_ldg_4((&(globalParams_0->families_0)[family_12]));
    Family_0 _S364 = slang_ldg_4((&(globalParams_0->families_0)[family_12]));
    uint _S365 = 3U * _S363.quantities_0;
    uint _S366 = _S364.colour_threads_0 + _S365 * (&stretch_2->low_0)->thread_10 + quantity_0;
    Family_0 _S367 = slang_ldg_4((&(globalParams_0->families_0)[family_12]));
    uint _S368 = _S367.colour_threads_0 + _S365 * (&stretch_2->high_0)->thread_10 + quantity_0;
    Family_0 _S369 = slang_ldg_4((&(globalParams_0->families_0)[family_12]));
    Family_0 _S370 = slang_ldg_4((&(globalParams_0->families_0)[family_12]));
    uint _S371 = _S369.colour_threads_0 + _S365 * uint(_S370.count_0) + quantity_0;
    float _S372 = table_number_0(_S366);
    float _S373 = table_number_0(_S368);
    float _S374 = Stretch_turns_0(stretch_2);
    uint _S375 = 2U * _S363.quantities_0;
    return make_float2 (table_number_0(_S368 + _S363.quantities_0) - table_number_0(_S366 + _S363.quantities_0) + _S373 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_1 - _S372 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_1 + _S374 * table_number_0(_S371 + _S363.quantities_0), table_number_0(_S368 + _S375) - table_number_0(_S366 + _S375) + _S373 * (&stretch_2->high_0)->cell_7 - _S372 * (&stretch_2->low_0)->cell_7 + _S374 * table_number_0(_S371 + _S375));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_7)
{
    return ((&this_7->high_0)->thread_10) < ((&this_7->low_0)->thread_10);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_8, uint4  entries_0, uint whole_0)
{
    uint _S376 = entries_0.z;
    uint _S377 = entries_0.x;
    uint _S378 = _S376 - _S377;
    bool _S379 = Stretch_wraps_0(this_8);
    uint _S380;
    if(_S379)
    {
        _S380 = whole_0;
    }
    else
    {
        _S380 = 0U;
    }
    return make_uint4 (_S378 + _S380, entries_0.w - _S376, entries_0.y - _S377, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_4, uint row_2, uint count_2, uint quantities_1)
{
    uint _S381 = row_2 + (&across_4->low_0)->thread_10 * quantities_1;
    uint _S382 = row_2 + (&across_4->high_0)->thread_10 * quantities_1;
    uint _S383 = __ldg((&(globalParams_0->words_0)[_S381]));
    uint _S384 = __ldg((&(globalParams_0->words_0)[_S381 + quantities_1]));
    uint _S385 = __ldg((&(globalParams_0->words_0)[_S382]));
    uint _S386 = __ldg((&(globalParams_0->words_0)[_S382 + quantities_1]));
    uint4  _S387 = make_uint4 (_S383, _S384, _S385, _S386);
    uint _S388 = __ldg((&(globalParams_0->words_0)[row_2 + count_2 * quantities_1]));
    uint4  _S389 = Stretch_differences_0(across_4, _S387, _S388);
    return _S389;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_9)
{
    float _S390 = (&this_9->high_0)->visible_0;
    float _S391 = - (&this_9->low_0)->visible_0;
    float _S392 = Stretch_turns_0(this_9);
    bool _S393 = Stretch_wraps_0(this_9);
    float _S394;
    if(_S393)
    {
        _S394 = 1.0f;
    }
    else
    {
        _S394 = 0.0f;
    }
    return make_float4 (1.0f, _S390, _S391, _S392 - _S394);
}

__device__ float integral_on_top_0(uint family_13, Stretch_0 * across_5, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    Family_0 _S395 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    uint _S396 = uint(_S395.count_0);
    uint _S397 = _S396 + 1U;
    Family_0 _S398 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    uint _S399 = _S397 * _S398.quantities_0;
    Family_0 _S400 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    uint _S401 = _S400.colour_areas_0 + quantity_1;
    uint _S402 = (&along_0->low_0)->thread_10;
    uint _S403 = _S401 + (&along_0->low_0)->thread_10 * _S399;
    Family_0 _S404 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    uint4  _S405 = row_differences_0(across_5, _S403, _S396, _S404.quantities_0);
    uint _S406 = _S401 + (_S402 + 1U) * _S399;
    Family_0 _S407 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    uint4  _S408 = row_differences_0(across_5, _S406, _S396, _S407.quantities_0);
    uint _S409 = (&along_0->high_0)->thread_10;
    uint _S410 = _S401 + (&along_0->high_0)->thread_10 * _S399;
    Family_0 _S411 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    uint4  _S412 = row_differences_0(across_5, _S410, _S396, _S411.quantities_0);
    uint _S413 = _S401 + (_S409 + 1U) * _S399;
    Family_0 _S414 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    uint4  _S415 = row_differences_0(across_5, _S413, _S396, _S414.quantities_0);
    uint _S416 = _S401 + crossing_count_0 * _S399;
    Family_0 _S417 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    uint4  _S418 = row_differences_0(across_5, _S416, _S396, _S417.quantities_0);
    uint4  _S419 = _S412 - _S405;
    bool _S420 = Stretch_wraps_0(along_0);
    uint4  _S421;
    if(_S420)
    {
        _S421 = _S418;
    }
    else
    {
        int4  _S422 = make_int4 (int(0));
        uint4  _S423 = make_uint4 ((uint)_S422.x, (uint)_S422.y, (uint)_S422.z, (uint)_S422.w);
        _S421 = _S423;
    }
    uint4  _S424 = _S419 + _S421;
    float4  _S425 = Stretch_weights_0(across_5);
    float4  _S426 = Stretch_weights_0(along_0);
    int4  _S427 = make_int4 ((int)_S424.x, (int)_S424.y, (int)_S424.z, (int)_S424.w);
    float4  _S428 = make_float4 ((float)_S427.x, (float)_S427.y, (float)_S427.z, (float)_S427.w);
    uint4  _S429 = _S415 - _S412;
    int4  _S430 = make_int4 ((int)_S429.x, (int)_S429.y, (int)_S429.z, (int)_S429.w);
    float4  _S431 = make_float4 ((float)_S430.x, (float)_S430.y, (float)_S430.z, (float)_S430.w);
    uint4  _S432 = _S408 - _S405;
    int4  _S433 = make_int4 ((int)_S432.x, (int)_S432.y, (int)_S432.z, (int)_S432.w);
    float4  _S434 = make_float4 ((float)_S433.x, (float)_S433.y, (float)_S433.z, (float)_S433.w);
    int4  _S435 = make_int4 ((int)_S418.x, (int)_S418.y, (int)_S418.z, (int)_S418.w);
    float4  _S436 = make_float4 ((float)_S435.x, (float)_S435.y, (float)_S435.z, (float)_S435.w);
    float _S437 = dot_2(make_float4 (dot_2(_S428, _S425), dot_2(_S431, _S425), dot_2(_S434, _S425), dot_2(_S436, _S425)), _S426);
    Family_0 _S438 = slang_ldg_4((&(globalParams_0->families_0)[family_13]));
    return _S437 * _S438.area_unit_0;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_2, uint row_3)
{
    Albedos_0 _S439 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_2) * _S439.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_2) * _S439.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_2) * _S439.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_2) * _S439.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, Stretch_0 * own_1, Stretch_0 * other_2, bool back_2)
{
    Family_0 _S440 = slang_ldg_4((&(globalParams_0->families_0)[family_14]));
    Albedos_0 albedos_2 = table_albedos_0(_S440.colour_mean_0);
    Family_0 _S441 = slang_ldg_4((&(globalParams_0->families_0)[family_14]));
    if((_S441.quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3  _S442 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_3 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        Family_0 _S443 = slang_ldg_4((&(globalParams_0->families_0)[family_14]));
        if(quantity_2 < (_S443.quantities_0))
        {
        }
        else
        {
            break;
        }
        float2  _S444 = integrals_along_0(family_14, own_1, quantity_2);
        Family_0 _S445 = slang_ldg_4((&(globalParams_0->families_0)[crossing_1]));
        float _S446 = integral_on_top_0(family_14, own_1, other_2, uint(_S445.count_0), quantity_2);
        float _S447 = _S444.x;
        float _S448 = _S447 * _S442.x;
        float _S449;
        if(back_2)
        {
            _S449 = _S448 - _S446;
        }
        else
        {
            _S449 = _S446;
        }
        bool _S450 = quantity_2 == 0U;
        if(_S450)
        {
            Family_0 _S451 = slang_ldg_4((&(globalParams_0->families_0)[family_14]));
            float _S452 = 16.0f * _S451.area_unit_0;
            Family_0 _S453 = slang_ldg_4((&(globalParams_0->families_0)[family_14]));
            is_exposed_0 = _S449 > (_S452 * (F32_min((_S448 / _S453.crossing_area_0), (1.0f))) + 0.00000999999974738f * _S448);
        }
        float _S454 = _S447 * _S442.y;
        float _S455;
        if(is_exposed_0)
        {
            _S455 = _S449;
        }
        else
        {
            _S455 = 0.0f;
        }
        float _S456 = _S454 + _S455 + 0.000244140625f * _S442.z * _S444.y;
        if(_S450)
        {
            weight_3 = 1.0f / (F32_max((_S456), (9.99999968265522539e-21f)));
        }
        else
        {
            float _S457 = _S456 * weight_3;
            Family_0 _S458 = slang_ldg_4((&(globalParams_0->families_0)[family_14]));
            uint _S459 = _S458.colour_axes_0 + 12U * (quantity_2 - 1U);
            Albedos_0 _S460 = albedos_2;
            Albedos_0 _S461 = with_added_albedos_0(&_S460, _S457, _S459);
            albedos_2 = _S461;
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
    float3  _S462 = make_float3 (weight_4);
    (&albedos_3)->diffuse_reflect_0 = lerp_0(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S462);
    (&albedos_3)->diffuse_transmit_0 = lerp_0(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S462);
    (&albedos_3)->specular_reflect_0 = lerp_0(first_2->specular_reflect_0, second_1->specular_reflect_0, _S462);
    (&albedos_3)->specular_transmit_0 = lerp_0(first_2->specular_transmit_0, second_1->specular_transmit_0, _S462);
    return albedos_3;
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

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S463 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S464 = 2.0f * (F32_sqrt((_S463))) - 1.0f;
    float _S465 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_8, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S464, _S465), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S463) * sheen_shear_0(_S464, _S465), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S464, _S465), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_8, float3  view_7, float scale_0, float shear_0)
{
    float _S466 = light_8.z;
    bool _S467;
    if(_S466 <= 0.0f)
    {
        _S467 = true;
    }
    else
    {
        _S467 = (view_7.z) <= 0.0f;
    }
    if(_S467)
    {
        return 0.0f;
    }
    float2  _S468 = float2 {view_7.x, view_7.y};
    float _S469 = dot_1(_S468, _S468);
    float2  _S470;
    if(_S469 > 9.99999968265522539e-21f)
    {
        _S470 = _S468 * make_float2 ((F32_rsqrt((_S469))));
    }
    else
    {
        _S470 = make_float2 (1.0f, 0.0f);
    }
    float _S471 = scale_0 * dot_1(float2 {light_8.x, light_8.y}, _S470) + shear_0 * _S466;
    float _S472 = scale_0 * (light_8.y * _S470.x - light_8.x * _S470.y);
    float _S473 = _S471 * _S471 + _S472 * _S472 + _S466 * _S466;
    return 0.31830987334251404f * scale_0 * scale_0 * _S466 / (F32_max((_S473 * _S473), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_9, float3  view_8, float strength_0, float roughness_9)
{
    float3  _S474 = sheen_lobe_0(view_8.z, roughness_9);
    float _S475 = strength_0 * _S474.z;
    return make_float2 (_S475 * transformed_cosine_0(light_9, view_8, _S474.x, _S474.y), 1.0f - _S475);
}

__device__ void accumulate_0(Frame_0 * frame_4, uint2  pixel_0, float4  light_10)
{
    uint _S476 = pixel_0.y * frame_4->width_0 + pixel_0.x;
    float _S477 = light_10.w;
    float4  _S478 = make_float4 ((float3 {light_10.x, light_10.y, light_10.z} + make_float3 (1.0f - _S477) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).x, (float3 {light_10.x, light_10.y, light_10.z} + make_float3 (1.0f - _S477) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).y, (float3 {light_10.x, light_10.y, light_10.z} + make_float3 (1.0f - _S477) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).z, _S477);
    float4  * _S479 = (&(globalParams_0->radiance_0)[_S476]);
    float4  _S480;
    if((frame_4->pass_number_0) == 0U)
    {
        _S480 = _S478;
    }
    else
    {
        _S480 = *(&(globalParams_0->radiance_0)[_S476]) + _S478;
    }
    *_S479 = _S480;
    return;
}

__device__ VisiblePoint_0 visible_point_0(Frame_0 * _S481, uint _S482, uint _S483, uint2  _S484)
{
    Fabric_0 * _S485 = (&(globalParams_0->fabrics_0)[_S482]);
    uint _S486 = 3U * _S483;
    uint _S487 = __ldg((&(globalParams_0->corners_0)[_S486]));
    Vertex_0 _S488 = slang_ldg_2((&(globalParams_0->vertices_0)[_S487]));
    uint _S489 = __ldg((&(globalParams_0->corners_0)[_S486 + 1U]));
    Vertex_0 _S490 = slang_ldg_2((&(globalParams_0->vertices_0)[_S489]));
    uint _S491 = __ldg((&(globalParams_0->corners_0)[_S486 + 2U]));
    Vertex_0 _S492 = slang_ldg_2((&(globalParams_0->vertices_0)[_S491]));
    Vertex_0 _S493 = _S490;
    float3  _S494 = position_of_0(&_S493);
    Vertex_0 _S495 = _S488;
    float3  _S496 = position_of_0(&_S495);
    float3  _S497 = _S494 - _S496;
    Vertex_0 _S498 = _S492;
    float3  _S499 = position_of_0(&_S498);
    float3  _S500 = _S499 - _S496;
    float3  _S501 = cross_0(_S497, _S500);
    float _S502 = 1.0f / (F32_max((square_0(_S501)), (1.00000000317107685e-30f)));
    float3  _S503 = camera_right_0(_S481);
    float _S504 = float(_S481->width_0);
    float3  _S505 = _S503 * make_float3 (2.0f / _S504);
    float3  _S506 = camera_up_0(_S481);
    float _S507 = float(_S481->height_0);
    float3  _S508 = _S506 * make_float3 (-2.0f / _S507);
    float _S509 = float(_S484.x) + 0.5f - 0.5f * _S504;
    float _S510 = float(_S484.y) + 0.5f - 0.5f * _S507;
    float3  _S511 = camera_forward_0(_S481);
    float3  _S512 = _S511 + make_float3 (_S509) * _S505 + make_float3 (_S510) * _S508;
    float _S513 = dot_0(_S512, _S501);
    float _S514;
    if((F32_abs((_S513))) > 1.00000000317107685e-30f)
    {
        _S514 = _S513;
    }
    else
    {
        _S514 = 1.00000000317107685e-30f;
    }
    float _S515 = 1.0f / _S514;
    float3  _S516 = camera_origin_0(_S481);
    float3  _S517 = _S496 - _S516;
    float _S518 = dot_0(_S517, _S501) * _S515;
    float3  _S519 = _S512 * make_float3 (_S518) - _S517;
    float3  _S520 = make_float3 (_S518) * (_S505 - _S512 * make_float3 (dot_0(_S505, _S501) * _S515));
    float3  _S521 = make_float3 (_S518) * (_S508 - _S512 * make_float3 (dot_0(_S508, _S501) * _S515));
    float3  _S522 = cross_0(_S500, _S501) * make_float3 (_S502);
    float3  _S523 = cross_0(_S501, _S497) * make_float3 (_S502);
    float _S524 = dot_0(_S519, _S522);
    float _S525 = dot_0(_S519, _S523);
    float _S526 = _S490.u_0 - _S488.u_0;
    float _S527 = _S490.v_0 - _S488.v_0;
    float2  _S528 = make_float2 (_S526, _S527);
    float _S529 = _S492.u_0 - _S488.u_0;
    float _S530 = _S492.v_0 - _S488.v_0;
    float2  _S531 = make_float2 (_S529, _S530);
    float2  _S532 = make_float2 (_S488.u_0, _S488.v_0) + make_float2 (_S524) * _S528 + make_float2 (_S525) * _S531;
    float2  _S533 = make_float2 (dot_0(_S520, _S522)) * _S528 + make_float2 (dot_0(_S520, _S523)) * _S531;
    float2  _S534 = make_float2 (dot_0(_S521, _S522)) * _S528 + make_float2 (dot_0(_S521, _S523)) * _S531;
    if((_S526 * _S530 - _S527 * _S529) < 0.0f)
    {
        _S514 = -1.0f;
    }
    else
    {
        _S514 = 1.0f;
    }
    float3  _S535 = make_float3 (_S514) * (make_float3 (_S530) * _S497 - make_float3 (_S527) * _S500);
    float3  _S536 = make_float3 (_S514) * (make_float3 (_S526) * _S500 - make_float3 (_S529) * _S497);
    VisiblePoint_0 point_1;
    float _S537 = 1.0f - _S524 - _S525;
    Vertex_0 _S538 = _S488;
    float3  _S539 = normal_of_0(&_S538);
    float3  _S540 = make_float3 (_S537) * _S539;
    Vertex_0 _S541 = _S490;
    float3  _S542 = normal_of_0(&_S541);
    float3  _S543 = _S540 + make_float3 (_S524) * _S542;
    Vertex_0 _S544 = _S492;
    float3  _S545 = normal_of_0(&_S544);
    float3  _S546 = normalize_0(_S543 + make_float3 (_S525) * _S545);
    (&point_1)->normal_0 = _S546;
    float3  _S547 = normalize_0(_S535 - _S546 * make_float3 (dot_0(_S546, _S535)));
    (&point_1)->axis_x_0 = _S547;
    (&point_1)->axis_y_0 = cross_0(_S546, _S547);
    (&point_1)->position_0 = _S496 + _S519;
    (&point_1)->view_0 = - normalize_0(_S512);
    bool _S548 = (dot_0(cross_0(_S535, _S536), _S546)) < 0.0f;
    float _S549 = __ldg(&_S485->uv_width_0);
    if(_S548)
    {
        float _S550 = __ldg(&_S485->uv_height_0);
        _S514 = - _S550;
    }
    else
    {
        float _S551 = __ldg(&_S485->uv_height_0);
        _S514 = _S551;
    }
    float2  _S552 = make_float2 (_S549, _S514);
    float2  _S553 = _S532 * _S552;
    if(_S548)
    {
        float _S554 = __ldg(&_S485->uv_height_0);
        _S514 = _S554;
    }
    else
    {
        _S514 = 0.0f;
    }
    (&point_1)->draft_0 = _S553 + make_float2 (0.0f, _S514);
    (&point_1)->draft_dx_0 = _S533 * _S552;
    (&point_1)->draft_dy_0 = _S534 * _S552;
    return point_1;
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

__device__ Regime_0 regime_of_0(uint _S555, Footprint_0 * _S556, float _S557)
{
    Fabric_0 * _S558 = (&(globalParams_0->fabrics_0)[_S555]);
    float _S559 = Footprint_spread_side_0(_S556);
    float _S560 = binary_logarithm_0((F32_max((_S559), (9.99999971718068537e-10f))));
    Lobes_0 _S561 = slang_ldg_1(&_S558->lobes_0);
    float _S562 = clamp_1((_S560 - _S561.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S563 = _S562 * _S562 * (3.0f - 2.0f * _S562);
    (&regime_0)->prefiltered_0 = _S563;
    (&regime_0)->threads_1 = _S559 * _S561.threads_per_mm_0;
    float _S564 = lerp_1((F32_max((8.0f / _S557), (1.0f))), 1.0f, _S563);
    float _S565;
    if(_S563 < 1.0f)
    {
        _S565 = clamp_1((&regime_0)->threads_1 * 12.0f, 1.0f, _S564);
    }
    else
    {
        _S565 = 0.0f;
    }
    (&regime_0)->points_1 = _S565;
    return regime_0;
}

struct Hit_0
{
    float x_28;
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

__device__ Crossing_0 crossing_at_0(uint _S566, float _S567, float _S568, bool _S569)
{
    Fabric_0 * _S570 = (&(globalParams_0->fabrics_0)[_S566]);
    Crossing_0 crossing_3;
    uint _S571 = __ldg(&_S570->warp_0);
    (&crossing_3)->warp_1 = locate_0(_S571, _S567);
    uint _S572 = __ldg(&_S570->weft_0);
    (&crossing_3)->weft_1 = locate_0(_S572, _S568);
    uint _S573 = __ldg(&_S570->run_words_0);
    uint _S574 = (&(&crossing_3)->weft_1)->thread_0;
    uint _S575 = __ldg(&_S570->ends_0);
    uint _S576 = _S573 + 2U * (_S574 * _S575 + (&(&crossing_3)->warp_1)->thread_0);
    uint _S577 = __ldg((&(globalParams_0->words_0)[_S576]));
    (&crossing_3)->warp_word_0 = _S577;
    uint _S578 = __ldg((&(globalParams_0->words_0)[_S576 + 1U]));
    (&crossing_3)->weft_word_0 = _S578;
    (&crossing_3)->warp_above_0 = ((_S577 & 1U) == 1U) != _S569;
    return crossing_3;
}

__device__ Sample_0 sample_at_0(uint _S579, float _S580, float _S581, bool _S582)
{
    Fabric_0 * _S583 = (&(globalParams_0->fabrics_0)[_S579]);
    Sample_0 sample_0;
    Crossing_0 _S584 = crossing_at_0(_S579, _S580, _S581, _S582);
    (&sample_0)->crossing_2 = _S584;
    Crossing_0 _S585 = _S584;
    Shown_0 _S586 = shown_at_0(&_S585, _S582);
    (&sample_0)->shown_3 = _S586;
    uint _S587;
    if(_S586.is_warp_2)
    {
        uint _S588 = __ldg(&_S583->warp_0);
        _S587 = _S588;
    }
    else
    {
        uint _S589 = __ldg(&_S583->weft_0);
        _S587 = _S589;
    }
    uint _S590;
    if(_S586.is_warp_2)
    {
        uint _S591 = __ldg(&_S583->weft_0);
        _S590 = _S591;
    }
    else
    {
        uint _S592 = __ldg(&_S583->warp_0);
        _S590 = _S592;
    }
    Cell_0 _S593 = (&(&sample_0)->crossing_2)->warp_1;
    Cell_0 _S594 = (&(&sample_0)->crossing_2)->weft_1;
    Cell_0 _S595 = select_cell_0(_S586.is_warp_2, &_S593, &_S594);
    Cell_0 _S596 = (&(&sample_0)->crossing_2)->weft_1;
    Cell_0 _S597 = (&(&sample_0)->crossing_2)->warp_1;
    Cell_0 _S598 = select_cell_0(_S586.is_warp_2, &_S596, &_S597);
    Cell_0 _S599 = _S598;
    Run_0 _S600 = unpack_0(_S587, _S590, _S595.thread_0, &_S599, _S586.word_0);
    Cell_0 _S601 = _S595;
    Section_0 _S602 = section_at_0(&_S601);
    bool _S603;
    if(_S586.on_top_0)
    {
        _S603 = (_S600.distance_0) < (_S602.drop_0 * _S600.bend_1.sine_0);
    }
    else
    {
        _S603 = false;
    }
    bool _S604;
    if(_S586.on_top_0)
    {
        _S604 = !_S603;
    }
    else
    {
        _S604 = false;
    }
    float _S605;
    if(_S604)
    {
        _S605 = 1.0f;
    }
    else
    {
        _S605 = -1.0f;
    }
    float _S606;
    if(_S603)
    {
        _S606 = _S600.other_reach_0;
    }
    else
    {
        _S606 = _S600.reach_0;
    }
    float _S607;
    if(_S603)
    {
        _S607 = _S606 + _S600.distance_0;
    }
    else
    {
        _S607 = (F32_max((_S606 - _S600.distance_0), (0.0f)));
    }
    float _S608 = _S606 / _S600.bend_1.sine_0 - _S605 * _S602.drop_0;
    float _S609 = _S607 * _S607;
    float _S610 = (F32_max((_S608 * _S608 - _S609), (9.99999968265522539e-21f)));
    float _S611 = (F32_rsqrt((_S610)));
    float _S612 = _S609 / (_S610 * _S611 + _S608);
    bool _S613 = _S607 > 0.0f;
    float _S614;
    if(_S586.on_top_0)
    {
        _S614 = 1.0f;
    }
    else
    {
        _S614 = -1.0f;
    }
    float _S615;
    if(_S600.near_start_0)
    {
        _S615 = 1.0f;
    }
    else
    {
        _S615 = -1.0f;
    }
    float _S616 = _S614 * _S615;
    if(_S613)
    {
        _S614 = _S608 * _S611;
    }
    else
    {
        _S614 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S602.slope_0 * _S614;
    if(_S613)
    {
        _S607 = _S616 * _S607 * _S611;
    }
    else
    {
        _S607 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S607;
    Family_0 _S617 = slang_ldg_4((&(globalParams_0->families_0)[_S587]));
    Shown_0 _S618 = _S586;
    Run_0 _S619 = _S600;
    Cell_0 _S620 = _S598;
    float2  _S621 = dive_0(_S590, &_S618, &_S619, &_S620);
    if(_S600.straight_0)
    {
        _S605 = 0.0f;
    }
    else
    {
        _S605 = _S617.height_scale_0 * _S605;
    }
    (&sample_0)->height_6 = _S605 * (_S606 * _S600.bend_1.half_tangent_0 - _S612) - _S617.height_scale_0 * _S602.drop_0 - _S621.x;
    float _S622 = _S617.height_scale_0 * (&sample_0)->slope_across_0;
    float _S623 = _S617.height_scale_0 * (&sample_0)->slope_along_0 - _S621.y;
    if(_S586.is_warp_2)
    {
        _S605 = _S622;
    }
    else
    {
        _S605 = _S623;
    }
    (&sample_0)->slope_x_1 = _S605;
    if(_S586.is_warp_2)
    {
        _S605 = _S623;
    }
    else
    {
        _S605 = _S622;
    }
    (&sample_0)->slope_y_1 = _S605;
    (&sample_0)->run_3 = _S600;
    (&sample_0)->section_1 = _S602;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S624, SearchQuality_0 * _S625, float3  _S626)
{
    Fabric_0 * _S627 = (&(globalParams_0->fabrics_0)[_S624]);
    float _S628 = (F32_abs((_S626.x)));
    float _S629 = __ldg(&_S627->threads_per_x_0);
    float _S630 = _S628 * _S629;
    float _S631 = (F32_abs((_S626.y)));
    float _S632 = __ldg(&_S627->threads_per_y_0);
    float _S633 = (F32_max((_S630), (_S631 * _S632))) * _S625->steps_per_thread_0;
    float _S634 = (F32_abs((_S626.z)));
    float _S635 = __ldg(&_S627->per_relief_0);
    return (F32_max((_S633), (_S634 * _S635 * _S625->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S636, Crossing_0 * _S637)
{
    Fabric_0 * _S638 = (&(globalParams_0->fabrics_0)[_S636]);
    bool _S639 = _S637->warp_above_0;
    uint _S640;
    if(_S637->warp_above_0)
    {
        uint _S641 = __ldg(&_S638->warp_0);
        _S640 = _S641;
    }
    else
    {
        uint _S642 = __ldg(&_S638->weft_0);
        _S640 = _S642;
    }
    uint _S643;
    if(_S639)
    {
        _S643 = _S637->warp_word_0;
    }
    else
    {
        _S643 = _S637->weft_word_0;
    }
    float _S644 = float(_S643 >> int(28));
    Family_0 _S645 = slang_ldg_4((&(globalParams_0->families_0)[_S640]));
    float _S646 = _S644 * _S645.height_scale_0;
    Family_0 _S647 = slang_ldg_4((&(globalParams_0->families_0)[_S640]));
    return _S646 * _S647.level_0;
}

__device__ Probe_0 probe_0(uint _S648, float _S649, float _S650, bool _S651, bool _S652, bool _S653)
{
    Sample_0 _S654 = sample_at_0(_S648, _S649, _S650, _S651);
    Probe_0 probe_1;
    (&probe_1)->height_3 = _S654.height_6;
    (&probe_1)->hole_4 = _S654.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S654.slope_x_1;
    (&probe_1)->slope_y_0 = _S654.slope_y_1;
    uint _S655;
    if(_S654.shown_3.is_warp_2)
    {
        _S655 = _S654.crossing_2.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S655 = _S654.crossing_2.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S655;
    Crossing_0 _S656 = _S654.crossing_2;
    float _S657 = cell_maximum_0(_S648, &_S656);
    (&probe_1)->cell_max_0 = _S657;
    float _S658;
    if(_S652)
    {
        _S658 = _S654.crossing_2.warp_1.above_0;
    }
    else
    {
        _S658 = _S654.crossing_2.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S658;
    if(_S653)
    {
        _S658 = _S654.crossing_2.weft_1.above_0;
    }
    else
    {
        _S658 = _S654.crossing_2.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S658;
    bool _S659 = !_S654.shown_3.is_warp_2;
    Cell_0 _S660 = _S654.crossing_2.warp_1;
    Shown_0 _S661 = _S654.shown_3;
    Run_0 _S662 = _S654.run_3;
    float _S663 = outline_distance_0(&_S660, &_S661, &_S662, _S659, _S652);
    (&probe_1)->edge_x_0 = _S663;
    Cell_0 _S664 = _S654.crossing_2.weft_1;
    Shown_0 _S665 = _S654.shown_3;
    Run_0 _S666 = _S654.run_3;
    float _S667 = outline_distance_0(&_S664, &_S665, &_S666, _S654.shown_3.is_warp_2, _S653);
    (&probe_1)->edge_y_0 = _S667;
    return probe_1;
}

__device__ bool is_free_0(uint _S668, SearchQuality_0 * _S669, float3  _S670, float3  _S671, bool _S672, float _S673)
{
    float _S674 = _S671.z;
    if(_S674 <= 0.0f)
    {
        return false;
    }
    float _S675 = _S669->shadow_share_0;
    float _S676 = steps_per_length_0(_S668, _S669, _S671);
    float _S677 = 1.0f / (F32_max((_S675 * _S676), (9.99999971718068537e-10f)));
    StepControl_0 _S678 = step_control_0(float2 {_S671.x, _S671.y}, _S677);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S679;
        if(count_3 < 1024U)
        {
            _S679 = (_S670.z + _S674 * distance_1) < _S673;
        }
        else
        {
            _S679 = false;
        }
        if(_S679)
        {
        }
        else
        {
            break;
        }
        float3  _S680 = _S670 + _S671 * make_float3 (distance_1);
        Probe_0 _S681 = probe_0(_S668, _S680.x, _S680.y, _S672, _S678.right_1, _S678.up_0);
        float _S682 = _S680.z;
        float _S683 = _S682 - _S681.height_3;
        float _S684 = _S674 - _S681.slope_x_0 * _S671.x - _S681.slope_y_0 * _S671.y;
        bool _S685;
        if(!_S681.hole_4)
        {
            _S685 = _S683 < 0.0f;
        }
        else
        {
            _S685 = false;
        }
        if(_S685)
        {
            return false;
        }
        PreviousSample_0 _S686 = previous_3;
        Probe_0 _S687 = _S681;
        float _S688 = way_back_to_dip_0(&_S686, _S683, _S684, last_step_0, &_S687);
        if(_S688 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S688;
            distance_1 = distance_1 - _S688;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S689 = _S682 > (_S681.cell_max_0);
        Probe_0 _S690 = _S681;
        PreviousSample_0 _S691 = after_sample_0(_S683, _S684, &_S690, _S689);
        float last_step_2;
        if(_S689)
        {
            StepControl_0 _S692 = _S678;
            float _S693 = StepControl_to_cell_exit_0(&_S692, _S681.side_x_0, _S681.side_y_0);
            last_step_2 = (F32_max((_S693), (_S677)));
        }
        else
        {
            StepControl_0 _S694 = _S678;
            Probe_0 _S695 = _S681;
            float _S696 = StepControl_to_next_sample_0(&_S694, &_S695, _S683, _S684);
            last_step_2 = _S696;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S691;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S697, SearchQuality_0 * _S698, float _S699, float _S700, float3  _S701, bool _S702)
{
    Fabric_0 * _S703 = (&(globalParams_0->fabrics_0)[_S697]);
    Sample_0 _S704 = sample_at_0(_S697, _S699, _S700, _S702);
    if(!_S704.shown_3.hole_3)
    {
        return false;
    }
    float3  _S705 = make_float3 (_S699, _S700, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S706;
        if(side_0 < 2U)
        {
            _S706 = passes_0;
        }
        else
        {
            _S706 = false;
        }
        if(_S706)
        {
        }
        else
        {
            break;
        }
        float3  _S707;
        if(side_0 == 0U)
        {
            _S707 = _S701;
        }
        else
        {
            _S707 = make_float3 (- _S701.x, - _S701.y, _S701.z);
        }
        bool _S708 = _S702 != (side_0 == 1U);
        float _S709 = __ldg(&_S703->height_high_0);
        bool _S710 = is_free_0(_S697, _S698, _S705, _S707, _S708, _S709);
        uint _S711 = side_0 + 1U;
        passes_0 = _S710;
        side_0 = _S711;
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

__device__ float max_height_along_0(uint _S712, float _S713, float _S714, float _S715, float3  _S716, bool _S717)
{
    Fabric_0 * _S718 = (&(globalParams_0->fabrics_0)[_S712]);
    uint _S719 = __ldg(&_S718->warp_0);
    uint _S720 = locate_0(_S719, _S713).thread_0 / 2U;
    uint _S721 = __ldg(&_S718->weft_0);
    uint _S722 = locate_0(_S721, _S714).thread_0 / 2U;
    float _S723 = _S716.x;
    uint _S724;
    if(_S723 > 0.0f)
    {
        _S724 = 1U;
    }
    else
    {
        _S724 = 0U;
    }
    float _S725 = _S716.y;
    uint _S726;
    if(_S725 > 0.0f)
    {
        _S726 = 2U;
    }
    else
    {
        _S726 = 0U;
    }
    uint _S727 = _S724 + _S726;
    uint _S728 = __ldg(&_S718->max_heights_0);
    uint _S729 = __ldg(&_S718->max_height_columns_0);
    uint _S730 = __ldg((&(globalParams_0->words_0)[_S728 + 4U * (_S722 * _S729 + _S720) + _S727]));
    int number_0;
    if(_S717)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S731 = _S730 >> number_0;
    float _S732 = (F32_abs((_S723)));
    float _S733 = __ldg(&_S718->threads_per_x_0);
    float _S734 = _S732 * _S733;
    float _S735 = (F32_abs((_S725)));
    float _S736 = __ldg(&_S718->threads_per_y_0);
    float _S737 = (F32_max((_S734), (_S735 * _S736))) / _S716.z;
    float _S738 = __ldg(&_S718->height_high_0);
    float max_height_0 = _S738;
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
        if(((max_height_0 - _S715) * _S737) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S731 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S738)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S739, float _S740, float _S741, bool _S742, bool _S743, bool _S744)
{
    Crossing_0 _S745 = crossing_at_0(_S739, _S740, _S741, _S742);
    Crossing_0 _S746 = _S745;
    float _S747 = cell_maximum_0(_S739, &_S746);
    float _S748;
    if(_S743)
    {
        _S748 = _S745.warp_1.above_0;
    }
    else
    {
        _S748 = _S745.warp_1.below_0;
    }
    float _S749;
    if(_S744)
    {
        _S749 = _S745.weft_1.above_0;
    }
    else
    {
        _S749 = _S745.weft_1.below_0;
    }
    return make_float3 (_S747, _S748, _S749);
}

__device__ float first_sample_height_0(uint _S750, ViewRay_0 * _S751, StepControl_0 * _S752, bool _S753)
{
    float _S754 = max_height_along_0(_S750, _S751->origin_0.x, _S751->origin_0.y, 0.0f, make_float3 (_S751->slope_1.x, _S751->slope_1.y, 1.0f), _S753);
    uint count_4 = 0U;
    float height_8 = _S754;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S755 = ViewRay_at_0(_S751, height_8);
        float3  _S756 = cell_bounds_0(_S750, _S755.x, _S755.y, _S753, _S752->right_1, _S752->up_0);
        float _S757 = height_8 - _S756.x;
        float _S758 = StepControl_to_cell_exit_0(_S752, _S756.y, _S756.z);
        float height_9 = height_8 - clamp_1(_S757, 0.0f, _S758);
        if(_S757 <= _S758)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

__device__ ViewRayEnd_0 search_down_0(uint _S759, ViewRay_0 * _S760, StepControl_0 * _S761, bool _S762)
{
    Fabric_0 * _S763 = (&(globalParams_0->fabrics_0)[_S759]);
    float _S764 = __ldg(&_S763->height_low_0);
    float _S765 = __ldg(&_S763->height_high_0);
    float _S766 = _S764 - (_S765 - _S764);
    ViewRayEnd_0 end_1;
    float _S767 = first_sample_height_0(_S759, _S760, _S761, _S762);
    (&end_1)->height_7 = _S767;
    (&end_1)->last_step_3 = _S761->epsilon_0;
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
        float2  _S768 = ViewRay_at_0(_S760, (&end_1)->height_7);
        Probe_0 _S769 = probe_0(_S759, _S768.x, _S768.y, _S762, _S761->right_1, _S761->up_0);
        float _S770 = (&end_1)->height_7 - _S769.height_3;
        Probe_0 _S771 = _S769;
        float _S772 = ViewRay_rate_0(_S760, &_S771);
        (&end_1)->depth_1 = - _S770;
        (&end_1)->rate_4 = _S772;
        bool _S773;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S773 = !_S769.hole_4;
        }
        else
        {
            _S773 = false;
        }
        bool _S774;
        if(_S773)
        {
            _S774 = ((&(&end_1)->previous_4)->yarn_0) == (_S769.yarn_1);
        }
        else
        {
            _S774 = false;
        }
        (&end_1)->smooth_0 = _S774;
        bool _S775;
        if(!_S769.hole_4)
        {
            _S775 = _S770 <= 0.0f;
        }
        else
        {
            _S775 = false;
        }
        bool _S776;
        if(_S775)
        {
            _S776 = true;
        }
        else
        {
            _S776 = ((&end_1)->height_7) <= _S766;
        }
        if(_S776)
        {
            break;
        }
        PreviousSample_0 _S777 = (&end_1)->previous_4;
        Probe_0 _S778 = _S769;
        float _S779 = way_back_to_dip_0(&_S777, _S770, _S772, (&end_1)->last_step_3, &_S778);
        if(_S779 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S779;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S779;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S780 = StepControl_to_cell_exit_0(_S761, _S769.side_x_0, _S769.side_y_0);
        float _S781 = (F32_min((_S780), ((&end_1)->height_7 - _S769.cell_max_0)));
        Probe_0 _S782 = _S769;
        float _S783 = StepControl_to_next_sample_0(_S761, &_S782, _S770, _S772);
        bool _S784 = _S781 > _S783;
        Probe_0 _S785 = _S769;
        PreviousSample_0 _S786 = after_sample_0(_S770, _S772, &_S785, _S784);
        (&end_1)->previous_4 = _S786;
        float _S787 = (F32_max((_S781), (_S783)));
        (&end_1)->last_step_3 = _S787;
        (&end_1)->height_7 = (&end_1)->height_7 - _S787;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S788, ViewRay_0 * _S789, StepControl_0 * _S790, bool _S791, ViewRayEnd_0 * _S792, uint _S793)
{
    Fabric_0 * _S794 = (&(globalParams_0->fabrics_0)[_S788]);
    float _S795 = __ldg(&_S794->height_high_0);
    float _S796 = __ldg(&_S794->height_low_0);
    float _S797 = _S795 - _S796;
    float _S798 = _S792->height_7;
    float _S799 = _S792->last_step_3;
    float above_2 = _S792->height_7 + _S792->last_step_3;
    float above_gap_1 = clamp_1((&_S792->previous_4)->clearance_0, 0.0f, _S797);
    float under_gap_1 = clamp_1(_S792->depth_1, 0.0f, _S797);
    float _S800 = cubic_root_0(above_gap_1, - under_gap_1, (&_S792->previous_4)->rate_0 * _S792->last_step_3, _S792->rate_4 * _S792->last_step_3);
    bool _S801 = _S792->smooth_0;
    float middle_0;
    if(_S792->smooth_0)
    {
        middle_0 = above_2 - _S800 * _S799;
    }
    else
    {
        middle_0 = between_0(above_2, _S798, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S798;
    float above_3 = above_2;
    uint i_8 = 0U;
    for(;;)
    {
        if(i_8 < _S793)
        {
        }
        else
        {
            break;
        }
        float2  _S802 = ViewRay_at_0(_S789, middle_0);
        Probe_0 _S803 = probe_0(_S788, _S802.x, _S802.y, _S791, _S790->right_1, _S790->up_0);
        float _S804;
        if(_S803.hole_4)
        {
            _S804 = -1.0e+09f;
        }
        else
        {
            _S804 = _S803.height_3;
        }
        float _S805 = clamp_1(middle_0 - _S804, - _S797, _S797);
        float _S806;
        if(_S805 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S806 = 0.5f * above_gap_2;
            }
            else
            {
                _S806 = above_gap_2;
            }
            float _S807 = - _S805;
            under_1 = middle_0;
            above_gap_2 = _S806;
            under_gap_2 = _S807;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S806 = 0.5f * under_gap_2;
            }
            else
            {
                _S806 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S805;
            under_gap_2 = _S806;
            side_1 = -1.0f;
        }
        if(_S801)
        {
            Probe_0 _S808 = _S803;
            float _S809 = ViewRay_rate_0(_S789, &_S808);
            middle_0 = clamp_1(middle_0 + _S805 / (F32_min((_S809), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_8 = i_8 + 1U;
    }
    if(_S801)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S810, SearchQuality_0 * _S811, float _S812, float _S813, float3  _S814, bool _S815)
{
    float _S816 = (F32_max((_S814.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S812, _S813);
    float2  _S817 = float2 {_S814.x, _S814.y} / make_float2 (_S816);
    (&ray_0)->slope_1 = _S817;
    float2  _S818 = - _S817;
    float _S819 = steps_per_length_0(_S810, _S811, _S814);
    StepControl_0 _S820 = step_control_0(_S818, 1.0f / (F32_max((_S819 / _S816), (9.99999971718068537e-10f))));
    ViewRay_0 _S821 = ray_0;
    StepControl_0 _S822 = _S820;
    ViewRayEnd_0 _S823 = search_down_0(_S810, &_S821, &_S822, _S815);
    Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    ViewRay_0 _S824 = ray_0;
    StepControl_0 _S825 = _S820;
    ViewRayEnd_0 _S826 = _S823;
    float _S827 = refined_height_0(_S810, &_S824, &_S825, _S815, &_S826, _S811->refinements_0);
    (&hit_0)->height_5 = _S827;
    ViewRay_0 _S828 = ray_0;
    float2  _S829 = ViewRay_at_0(&_S828, _S827);
    (&hit_0)->x_28 = _S829.x;
    (&hit_0)->y_17 = _S829.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S830, SearchQuality_0 * _S831, float _S832, float _S833, float3  _S834, bool _S835)
{
    bool _S836 = passes_through_0(_S830, _S831, _S832, _S833, _S834, _S835);
    if(!_S836)
    {
        Hit_0 _S837 = first_hit_of_yarn_0(_S830, _S831, _S832, _S833, _S834, _S835);
        return _S837;
    }
    Hit_0 hit_1;
    (&hit_1)->x_28 = _S832;
    (&hit_1)->y_17 = _S833;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S838, float _S839, float _S840, bool _S841)
{
    Fabric_0 * _S842 = (&(globalParams_0->fabrics_0)[_S838]);
    Sample_0 _S843 = sample_at_0(_S838, _S839, _S840, _S841);
    float _S844;
    if(_S843.shown_3.is_warp_2)
    {
        _S844 = _S843.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S844 = _S843.crossing_2.weft_1.half_width_1;
    }
    uint _S845;
    if(_S843.shown_3.is_warp_2)
    {
        uint _S846 = __ldg(&_S842->warp_0);
        _S845 = _S846;
    }
    else
    {
        uint _S847 = __ldg(&_S842->weft_0);
        _S845 = _S847;
    }
    Family_0 _S848 = slang_ldg_4((&(globalParams_0->families_0)[_S845]));
    float _S849;
    if(_S841)
    {
        _S849 = -1.0f;
    }
    else
    {
        _S849 = 1.0f;
    }
    float _S850 = _S848.twist_sine_0 * _S849;
    Family_0 _S851 = slang_ldg_4((&(globalParams_0->families_0)[_S845]));
    if(_S843.shown_3.is_warp_2)
    {
        _S849 = 1.0f;
    }
    else
    {
        _S849 = -1.0f;
    }
    float2  _S852 = fibre_direction_0(_S843.slope_across_0, _S849 * _S843.slope_along_0, _S850, _S851.twist_cosine_0);
    float _S853;
    if(_S843.shown_3.is_warp_2)
    {
        _S853 = _S843.slope_x_1;
    }
    else
    {
        _S853 = _S843.slope_y_1;
    }
    float _S854;
    if(_S843.shown_3.is_warp_2)
    {
        _S854 = _S843.slope_y_1;
    }
    else
    {
        _S854 = _S843.slope_x_1;
    }
    float _S855 = _S852.x;
    float _S856 = _S852.y;
    float _S857 = _S853 * _S855 + _S849 * _S854 * _S856;
    float _S858 = _S844 * 1.0154266357421875f;
    float _S859 = _S858 * arc_sine_0(clamp_1(_S843.section_1.across_3 / _S858, -1.0f, 1.0f));
    if(_S843.shown_3.is_warp_2)
    {
        _S844 = _S840;
    }
    else
    {
        _S844 = - _S839;
    }
    SurfacePoint_0 point_2;
    (&point_2)->hole_0 = _S843.shown_3.hole_3;
    (&point_2)->is_warp_0 = _S843.shown_3.is_warp_2;
    (&point_2)->warp_thread_0 = _S843.crossing_2.warp_1.thread_0;
    (&point_2)->weft_thread_0 = _S843.crossing_2.weft_1.thread_0;
    (&point_2)->height_1 = _S843.height_6;
    (&point_2)->normal_1 = normalize_0(make_float3 (- _S843.slope_x_1, - _S843.slope_y_1, 1.0f));
    float3  _S860;
    if(_S843.shown_3.is_warp_2)
    {
        _S860 = make_float3 (_S855, _S856, _S857);
    }
    else
    {
        _S860 = make_float3 (- _S856, _S855, _S857);
    }
    (&point_2)->tangent_0 = normalize_0(_S860);
    (&point_2)->across_0 = _S843.section_1.across_3;
    (&point_2)->fibre_across_0 = _S859 * _S851.twist_cosine_0 + _S844 * _S850;
    (&point_2)->fibre_along_0 = _S844 * _S851.twist_cosine_0 - _S859 * _S850;
    return point_2;
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_6;
    bool is_warp_3;
    float x_29;
    float y_18;
    float height_10;
    float3  normal_7;
    float3  tangent_7;
    float roughness_10;
    Albedos_0 albedos_5;
};

__device__ Albedos_0 vary_albedos_0(uint _S861, Albedos_0 * _S862, uint _S863, uint _S864)
{
    Fabric_0 * _S865 = (&(globalParams_0->fabrics_0)[_S861]);
    float3  _S866 = _S862->specular_reflect_0;
    float3  _S867 = _S862->specular_transmit_0;
    float3  _S868 = max_0(_S862->specular_reflect_0, _S862->specular_transmit_0);
    float3  _S869 = _S862->diffuse_reflect_0;
    float3  _S870 = _S862->diffuse_transmit_0;
    float3  _S871 = _S862->diffuse_reflect_0 + _S862->diffuse_transmit_0;
    float _S872 = __ldg(&_S865->colour_noise_0);
    uint _S873 = __ldg(&_S865->seed_0);
    float _S874 = thread_gain_0(_S863, _S872, _S873);
    float _S875 = __ldg(&_S865->layer_bound_0);
    float _S876 = bounded_gain_0(_S874, _S871, make_float3 (1.0f) - make_float3 (_S875) * _S868);
    float3  _S877 = min_0((make_float3 (1.0f) - make_float3 (_S876) * _S871) / make_float3 (_S875), make_float3 (1.0f));
    float _S878 = __ldg(&_S865->fibre_noise_0);
    float _S879 = bounded_gain_0(fibre_gain_0(_S863, _S864, _S878, _S873), _S868, _S877);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S876) * _S869;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S876) * _S870;
    (&varied_0)->specular_reflect_0 = make_float3 (_S879) * _S866;
    (&varied_0)->specular_transmit_0 = make_float3 (_S879) * _S867;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S880, SurfacePoint_0 * _S881, Albedos_0 * _S882, float _S883, float _S884)
{
    Fabric_0 * _S885 = (&(globalParams_0->fabrics_0)[_S880]);
    bool _S886 = _S881->is_warp_0;
    float _S887;
    if(_S881->is_warp_0)
    {
        _S887 = _S883;
    }
    else
    {
        _S887 = _S884;
    }
    float _S888 = _S887 - _S881->across_0;
    uint _S889;
    if(_S886)
    {
        uint _S890 = __ldg(&_S885->warp_0);
        _S889 = _S890;
    }
    else
    {
        uint _S891 = __ldg(&_S885->weft_0);
        _S889 = _S891;
    }
    Family_0 _S892 = slang_ldg_4((&(globalParams_0->families_0)[_S889]));
    Family_0 _S893 = slang_ldg_4((&(globalParams_0->families_0)[_S889]));
    int _S894 = int(_S893.count_0);
    if(_S886)
    {
        _S889 = _S881->warp_thread_0;
    }
    else
    {
        _S889 = _S881->weft_thread_0;
    }
    uint _S895 = uint(int((F32_floor((_S888 / _S892.period_0)))) * _S894 + int(_S889)) * 2U;
    if(_S886)
    {
        _S889 = 1U;
    }
    else
    {
        _S889 = 0U;
    }
    uint _S896 = _S895 + _S889;
    float _S897 = _S881->fibre_across_0;
    float _S898 = __ldg(&_S885->fibre_size_0);
    float _S899 = (F32_floor((_S897 / _S898)));
    Albedos_0 _S900 = vary_albedos_0(_S880, _S882, _S896, uint(int(_S899)) * 65536U + uint(int((F32_floor((_S881->fibre_along_0 / (_S898 * 40.0f) + 0.61799997091293335f * _S899))))));
    return _S900;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S901, SurfacePoint_0 * _S902, float _S903, float _S904, bool _S905, bool _S906)
{
    Fabric_0 * _S907 = (&(globalParams_0->fabrics_0)[_S901]);
    bool _S908 = _S902->is_warp_0;
    uint _S909;
    if(_S902->is_warp_0)
    {
        uint _S910 = __ldg(&_S907->warp_0);
        _S909 = _S910;
    }
    else
    {
        uint _S911 = __ldg(&_S907->weft_0);
        _S909 = _S911;
    }
    uint _S912;
    if(_S908)
    {
        _S912 = _S902->warp_thread_0;
    }
    else
    {
        _S912 = _S902->weft_thread_0;
    }
    Albedos_0 albedos_6 = albedos_of_0(_S909, _S912);
    float _S913 = __ldg(&_S907->fibre_noise_0);
    bool _S914;
    if(_S913 > 0.0f)
    {
        _S914 = true;
    }
    else
    {
        float _S915 = __ldg(&_S907->colour_noise_0);
        _S914 = _S915 > 0.0f;
    }
    Albedos_0 albedos_7;
    if(_S914)
    {
        Albedos_0 _S916 = albedos_6;
        Albedos_0 _S917 = varied_at_0(_S901, _S902, &_S916, _S903, _S904);
        albedos_7 = _S917;
    }
    else
    {
        albedos_7 = albedos_6;
    }
    YarnPoint_0 point_3;
    (&point_3)->back_3 = _S905;
    (&point_3)->hole_6 = _S906;
    (&point_3)->is_warp_3 = _S908;
    (&point_3)->x_29 = _S903;
    (&point_3)->y_18 = _S904;
    (&point_3)->height_10 = _S902->height_1;
    (&point_3)->normal_7 = _S902->normal_1;
    (&point_3)->tangent_7 = _S902->tangent_0;
    Family_0 _S918 = slang_ldg_4((&(globalParams_0->families_0)[_S909]));
    (&point_3)->roughness_10 = _S918.roughness_0;
    (&point_3)->albedos_5 = albedos_7;
    return point_3;
}

__device__ bool unoccluded_0(uint _S919, SearchQuality_0 * _S920, float _S921, float _S922, float _S923, float3  _S924, bool _S925)
{
    Fabric_0 * _S926 = (&(globalParams_0->fabrics_0)[_S919]);
    if((_S924.z) <= 0.0f)
    {
        return false;
    }
    float _S927 = max_height_along_0(_S919, _S921, _S922, _S923, _S924, _S925);
    float _S928 = __ldg(&_S926->lift_0);
    bool _S929 = is_free_0(_S919, _S920, make_float3 (_S921, _S922, _S923 + _S928), _S924, _S925, _S927);
    return _S929;
}

__device__ bool is_lit_0(uint _S930, SearchQuality_0 * _S931, YarnPoint_0 * _S932, float3  _S933)
{
    if(_S932->hole_6)
    {
        return true;
    }
    bool _S934 = _S932->back_3;
    float3  _S935 = to_face_frame_0(_S933, _S932->back_3);
    float _S936 = _S935.z;
    bool _S937 = _S936 < 0.0f;
    float3  _S938 = _S932->normal_7;
    float _S939 = _S932->height_10;
    float3  normal_8;
    float height_11;
    if(_S937)
    {
        SurfacePoint_0 _S940 = surface_at_0(_S930, _S932->x_29, _S932->y_18, !_S934);
        normal_8 = _S940.normal_1;
        height_11 = _S940.height_1;
    }
    else
    {
        normal_8 = _S938;
        height_11 = _S939;
    }
    float3  _S941 = make_float3 (float2 {_S935.x, _S935.y}.x, float2 {_S935.x, _S935.y}.y, (F32_abs((_S936))));
    if((dot_0(normal_8, _S941)) <= 0.0f)
    {
        return false;
    }
    bool _S942 = unoccluded_0(_S930, _S931, _S932->x_29, _S932->y_18, height_11, _S941, _S934 != _S937);
    return _S942;
}

__device__ Components_0 components_of_point_0(uint _S943, SearchQuality_0 * _S944, YarnPoint_0 * _S945, float3  _S946, float3  _S947)
{
    Fabric_0 * _S948 = (&(globalParams_0->fabrics_0)[_S943]);
    Components_0 result_11 = no_components_0();
    bool _S949 = _S945->hole_6;
    float _S950;
    if(_S945->hole_6)
    {
        _S950 = 1.0f;
    }
    else
    {
        _S950 = 0.0f;
    }
    (&result_11)->hole_2 = _S950;
    bool _S951;
    if(_S949)
    {
        _S951 = true;
    }
    else
    {
        bool _S952 = is_lit_0(_S943, _S944, _S945, _S946);
        _S951 = !_S952;
    }
    if(_S951)
    {
        return result_11;
    }
    float3  _S953 = to_face_frame_0(_S946, _S945->back_3);
    float3  _S954 = to_face_frame_0(_S947, _S945->back_3);
    bool _S955 = (_S953.z) < 0.0f;
    float3  _S956;
    if(_S955)
    {
        _S956 = - _S953;
    }
    else
    {
        _S956 = _S953;
    }
    float3  _S957 = _S945->normal_7;
    float _S958 = __ldg(&_S948->diffuse_blend_0);
    float _S959 = diffuse_reflection_0(_S956, _S957, _S958);
    if(_S955)
    {
        float3  _S960 = _S945->tangent_7;
        float _S961 = _S945->roughness_10;
        float _S962 = __ldg(&_S948->optical_depth_0);
        _S950 = transmission_0(_S953, _S954, _S957, _S960, _S961, _S962);
    }
    else
    {
        float3  _S963 = _S945->tangent_7;
        float _S964 = _S945->roughness_10;
        float _S965 = __ldg(&_S948->optical_depth_0);
        _S950 = reflection_0(_S953, _S954, _S957, _S963, _S964, _S965);
    }
    bool _S966 = _S945->is_warp_3;
    float _S967;
    if(_S945->is_warp_3)
    {
        _S967 = _S959;
    }
    else
    {
        _S967 = 0.0f;
    }
    (&result_11)->diffuse_warp_0 = _S967;
    if(_S966)
    {
        _S967 = 0.0f;
    }
    else
    {
        _S967 = _S959;
    }
    (&result_11)->diffuse_weft_0 = _S967;
    if(_S966)
    {
        _S967 = _S950;
    }
    else
    {
        _S967 = 0.0f;
    }
    (&result_11)->specular_warp_0 = _S967;
    if(_S966)
    {
        _S950 = 0.0f;
    }
    (&result_11)->specular_weft_0 = _S950;
    (&result_11)->light_visibility_1 = 1.0f;
    return result_11;
}

struct CoverageTaps_0
{
    FixedArray<uint, 9>  nodes_1;
};

__device__ float3  pyramid_level_0(uint _S968, float _S969)
{
    Lobes_0 _S970 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S968])->lobes_0);
    uint _S971 = _S970.levels_0 + 4U * uint((F32_min((_S969), (_S970.last_level_0))));
    return make_float3 (table_number_0(_S971), table_number_0(_S971 + 1U), table_number_0(_S971 + 2U));
}

__device__ CoverageTaps_0 coverage_taps_0(uint _S972, Footprint_0 * _S973, bool _S974)
{
    Fabric_0 * _S975 = (&(globalParams_0->fabrics_0)[_S972]);
    float _S976 = Footprint_spread_side_0(_S973);
    Lobes_0 _S977 = slang_ldg_1(&_S975->lobes_0);
    float _S978 = _S976 * _S977.inverse_base_size_0;
    float3  _S979 = pyramid_level_0(_S972, (F32_floor((binary_logarithm_0((F32_max((0.68000000715255737f * _S978), (1.0f))))))));
    float _S980 = 1.0f / (F32_max((_S978), (9.99999997475242708e-07f)));
    float _S981 = (F32_min(((F32_max(((F32_sqrt((clamp_1(1.29999995231628418f * (1.0f - _S980 * _S980), 0.0f, 1.0f))))), (0.3333333432674408f * _S980)))), (1.0f)));
    uint _S982 = __ldg(&_S975->warp_0);
    Family_0 _S983 = slang_ldg_4((&(globalParams_0->families_0)[_S982]));
    uint _S984 = __ldg(&_S975->weft_0);
    Family_0 _S985 = slang_ldg_4((&(globalParams_0->families_0)[_S984]));
    float2  _S986 = make_float2 (_S983.inverse_period_0, _S985.inverse_period_0);
    float2  _S987 = _S973->centre_0 * _S986;
    float2  _S988 = _S973->dx_0 * _S986 * make_float2 (_S981);
    float2  _S989 = _S973->dy_0 * _S986 * make_float2 (_S981);
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
        float2  _S990 = _S987 + make_float2 (TAP_OFFSETS_0[number_1].x) * _S988 + make_float2 (TAP_OFFSETS_0[number_1].y) * _S989;
        float _S991 = _S979.y;
        float _S992 = wrapped_cell_0(_S990.x, _S991);
        float _S993 = wrapped_cell_0(_S990.y, _S979.z);
        uint _S994;
        if(_S974)
        {
            _S994 = _S977.face_nodes_0;
        }
        else
        {
            _S994 = 0U;
        }
        (&taps_3)->nodes_1[number_1] = _S994 + uint(_S993 * _S991 + _S992 + _S979.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

__device__ float4  coverage_of_pack_0(uint _S995, CoverageTaps_0 * _S996, uint _S997)
{
    Fabric_0 * _S998 = (&(globalParams_0->fabrics_0)[_S995]);
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
        Lobes_0 _S999 = slang_ldg_1(&_S998->lobes_0);
        uint _S1000 = __ldg((&(globalParams_0->words_0)[_S999.coverage_0 + _S996->nodes_1[number_2] * _S999.packs_0 + _S997]));
        uint even_2 = even_1 + (_S1000 & 16711935U);
        uint odd_2 = odd_1 + ((_S1000 >> int(8)) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / make_float4 (9.0f);
}

__device__ float coverage_of_holes_0(uint _S1001, CoverageTaps_0 * _S1002)
{
    Fabric_0 * _S1003 = (&(globalParams_0->fabrics_0)[_S1001]);
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
        uint _S1004 = _S1002->nodes_1[number_3];
        Lobes_0 _S1005 = slang_ldg_1(&_S1003->lobes_0);
        uint _S1006 = __ldg((&(globalParams_0->words_0)[_S1005.coverage_holes_0 + _S1004 / 4U]));
        uint total_1 = total_0 + ((_S1006 >> (8U * (_S1004 % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

__device__ float prefiltered_hole_0(uint _S1007, CoverageTaps_0 * _S1008, NodeTaps_0 * _S1009, bool _S1010)
{
    Lobes_0 _S1011 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S1007])->lobes_0);
    float4  _S1012 = interpolate_table_0(_S1009, _S1011.projected_area_0 + _S1011.packs_0, _S1011.packs_0 + 1U);
    float _S1013 = _S1012.x;
    float _S1014;
    if(_S1010)
    {
        _S1014 = _S1011.back_hole_weight_0;
    }
    else
    {
        _S1014 = _S1011.front_hole_weight_0;
    }
    float _S1015 = coverage_of_holes_0(_S1007, _S1008);
    return (F32_min((_S1015 * _S1013 * _S1013 * _S1014), (1.0f)));
}

__device__ Components_0 prefiltered_components_0(uint _S1016, Footprint_0 * _S1017, float3  _S1018, float3  _S1019, bool _S1020)
{
    Fabric_0 * _S1021 = (&(globalParams_0->fabrics_0)[_S1016]);
    CoverageTaps_0 _S1022 = coverage_taps_0(_S1016, _S1017, _S1020);
    NodeTaps_0 _S1023 = node_taps_0(_S1019);
    NodeTaps_0 view_nodes_0 = _S1023;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S1018);
    NodeTaps_0 seen_nodes_0 = _S1023;
    uint _S1024;
    if(_S1020)
    {
        _S1024 = 1U;
    }
    else
    {
        _S1024 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + make_uint4 (_S1024 * 256U);
    uint _S1025 = 2U * _S1024;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + make_uint4 (_S1025 * 256U);
    uint _S1026;
    if((_S1018.z) < 0.0f)
    {
        _S1026 = 1U;
    }
    else
    {
        _S1026 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + make_uint4 ((_S1025 + _S1026) * 256U);
    float3  _S1027 = half_vector_0(_S1018, _S1019);
    float3  _S1028 = shadow_correlation_0(_S1018, _S1019);
    if(_S1020)
    {
        Lobes_0 _S1029 = slang_ldg_1(&_S1021->lobes_0);
        _S1026 = _S1029.back_warp_packs_0;
    }
    else
    {
        Lobes_0 _S1030 = slang_ldg_1(&_S1021->lobes_0);
        _S1026 = _S1030.front_warp_packs_0;
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
        Lobes_0 _S1031 = slang_ldg_1(&_S1021->lobes_0);
        if(pack_0 < (_S1031.packs_0))
        {
        }
        else
        {
            break;
        }
        CoverageTaps_0 _S1032 = _S1022;
        float4  _S1033 = coverage_of_pack_0(_S1016, &_S1032, pack_0);
        uint _S1034 = _S1031.projected_area_0 + pack_0;
        uint _S1035 = _S1031.packs_0 + 1U;
        NodeTaps_0 _S1036 = view_nodes_0;
        float4  _S1037 = interpolate_table_0(&_S1036, _S1034, _S1035);
        uint _S1038 = _S1031.light_visibility_0 + pack_0;
        NodeTaps_0 _S1039 = seen_nodes_0;
        float4  _S1040 = interpolate_table_0(&_S1039, _S1038, _S1031.packs_0);
        float4  _S1041 = _S1040 / make_float4 (255.0f);
        NodeTaps_0 _S1042 = light_nodes_0;
        float4  _S1043 = interpolate_table_0(&_S1042, _S1038, _S1031.packs_0);
        float4  _S1044 = _S1043 / make_float4 (255.0f);
        uint _S1045 = _S1031.irradiance_0 + pack_0;
        NodeTaps_0 _S1046 = light_nodes_0;
        float4  _S1047 = interpolate_table_0(&_S1046, _S1045, _S1031.packs_0);
        float4  _S1048 = _S1047 * make_float4 (0.00124827399849892f);
        bool _S1049 = pack_0 < _S1026;
        uint _S1050;
        if(_S1049)
        {
            uint _S1051 = __ldg(&_S1021->warp_0);
            _S1050 = _S1051;
        }
        else
        {
            uint _S1052 = __ldg(&_S1021->weft_0);
            _S1050 = _S1052;
        }
        Family_0 _S1053 = slang_ldg_4((&(globalParams_0->families_0)[_S1050]));
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
            Group_0 _S1054 = group_at_0(_S1031.moments_0 + 12U * (4U * (_S1024 * _S1031.packs_0 + pack_0) + number_4), _S1053.roughness_0);
            float _S1055 = _slang_vector_get_element(_S1033, number_4) * _slang_vector_get_element(_S1037, number_4) * _slang_vector_get_element(_S1037, number_4) * _S1054.weight_1;
            uint _S1056 = number_4;
            float2  _S1057 = visibility_gain_0(_S1028, _slang_vector_get_element(_S1044, number_4), _slang_vector_get_element(_S1041, number_4));
            float _S1058 = __ldg(&_S1021->optical_depth_0);
            Group_0 _S1059 = _S1054;
            float _S1060 = layer_value_0(&_S1059, _S1027, _S1018, _S1019, _S1058);
            float _S1061 = _S1057.x;
            float diffuse_1 = diffuse_0 + _S1055 * _slang_vector_get_element(_S1048, number_4) * _S1061;
            float specular_1 = specular_0 + _S1055 * _S1060 * _slang_vector_get_element(_S1044, _S1056) * _S1057.y;
            (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 + _S1055 * _slang_vector_get_element(_S1044, _S1056) * _S1061;
            float total_3 = total_2 + _S1055;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S1062;
        if(_S1049)
        {
            _S1062 = diffuse_0;
        }
        else
        {
            _S1062 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S1062;
        float _S1063;
        if(_S1049)
        {
            _S1063 = 0.0f;
        }
        else
        {
            _S1063 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S1063;
        float _S1064;
        if(_S1049)
        {
            _S1064 = specular_0;
        }
        else
        {
            _S1064 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S1064;
        float _S1065;
        if(_S1049)
        {
            _S1065 = 0.0f;
        }
        else
        {
            _S1065 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S1065;
        pack_0 = pack_0 + 1U;
    }
    CoverageTaps_0 _S1066 = _S1022;
    NodeTaps_0 _S1067 = view_nodes_0;
    float _S1068 = prefiltered_hole_0(_S1016, &_S1066, &_S1067, _S1020);
    (&sums_1)->hole_2 = _S1068;
    float _S1069 = (1.0f - _S1068) / (F32_max((total_2), (9.999999960041972e-13f)));
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S1069;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S1069;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S1069;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S1069;
    (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 * _S1069;
    return sums_1;
}

__device__ FamilyAlbedos_0 albedos_over_0(uint _S1070, Footprint_0 * _S1071, bool _S1072)
{
    Fabric_0 * _S1073 = (&(globalParams_0->fabrics_0)[_S1070]);
    float2  _S1074 = sqrt_0(_S1071->dx_0 * _S1071->dx_0 + _S1071->dy_0 * _S1071->dy_0);
    uint _S1075 = __ldg(&_S1073->warp_0);
    float2  _S1076 = _S1071->centre_0;
    Stretch_0 _S1077 = stretch_of_0(_S1075, _S1071->centre_0.x, _S1074.x);
    uint _S1078 = __ldg(&_S1073->weft_0);
    Stretch_0 _S1079 = stretch_of_0(_S1078, _S1076.y, _S1074.y);
    FamilyAlbedos_0 albedos_8;
    Stretch_0 _S1080 = _S1077;
    Stretch_0 _S1081 = _S1079;
    Albedos_0 _S1082 = mean_albedos_0(_S1075, _S1078, &_S1080, &_S1081, _S1072);
    (&albedos_8)->warp_2 = _S1082;
    Stretch_0 _S1083 = _S1079;
    Stretch_0 _S1084 = _S1077;
    Albedos_0 _S1085 = mean_albedos_0(_S1078, _S1075, &_S1083, &_S1084, _S1072);
    (&albedos_8)->weft_2 = _S1085;
    return albedos_8;
}

__device__ Estimate_0 lobes_estimate_0(uint _S1086, Footprint_0 * _S1087, float _S1088, float3  _S1089, float3  _S1090)
{
    float _S1091;
    Fabric_0 * _S1092 = (&(globalParams_0->fabrics_0)[_S1086]);
    Regime_0 _S1093 = regime_of_0(_S1086, _S1087, _S1088);
    bool _S1094 = (_S1090.z) < 0.0f;
    float3  _S1095 = to_face_frame_0(_S1090, _S1094);
    float _S1096 = __ldg(&_S1092->fibre_noise_0);
    bool _S1097;
    if(_S1096 > 0.0f)
    {
        _S1097 = true;
    }
    else
    {
        float _S1098 = __ldg(&_S1092->colour_noise_0);
        _S1097 = _S1098 > 0.0f;
    }
    uint _S1099 = __ldg(&_S1092->warp_0);
    Family_0 _S1100 = slang_ldg_4((&(globalParams_0->families_0)[_S1099]));
    bool _S1101;
    if((_S1100.quantities_0) > 1U)
    {
        _S1101 = true;
    }
    else
    {
        uint _S1102 = __ldg(&_S1092->weft_0);
        Family_0 _S1103 = slang_ldg_4((&(globalParams_0->families_0)[_S1102]));
        _S1101 = (_S1103.quantities_0) > 1U;
    }
    float _S1104 = 1.0f - _S1093.prefiltered_0;
    if(_S1104 > 0.0f)
    {
        if(_S1097)
        {
            _S1101 = true;
        }
    }
    else
    {
        _S1101 = false;
    }
    Footprint_0 box_0 = *_S1087;
    float3  _S1105 = make_float3 (0.0f);
    SurfacePoint_0 _S1106 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S1105, _S1105, 0.0f, 0.0f, 0.0f);
    float2  _S1107 = _S1087->centre_0;
    Components_0 _S1108 = no_components_0();
    int _S1109;
    if(_S1101)
    {
        _S1109 = int(0);
    }
    else
    {
        _S1109 = int(1);
    }
    uint _S1110 = uint(_S1109);
    Components_0 points_2 = _S1108;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S1106;
    float2  central_place_0 = _S1107;
    uint number_5 = _S1110;
    for(;;)
    {
        float _S1111 = float(number_5);
        _S1091 = _S1093.points_1;
        if(_S1111 < (_S1093.points_1 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S1112 = number_5 == 0U;
        float2  _S1113;
        if(_S1112)
        {
            _S1113 = make_float2 (0.0f);
        }
        else
        {
            _S1113 = POINT_OFFSETS_0[number_5 - 1U];
        }
        float2  _S1114 = _S1107 + make_float2 (_S1113.x) * _S1087->dx_0 + make_float2 (_S1113.y) * _S1087->dy_0;
        float _S1115;
        if(_S1112)
        {
            _S1115 = 0.0f;
        }
        else
        {
            _S1115 = _S1093.threads_1;
        }
        SearchQuality_0 _S1116 = quality_of_0(_S1115);
        float _S1117 = _S1114.x;
        float _S1118 = _S1114.y;
        SearchQuality_0 _S1119 = _S1116;
        Hit_0 _S1120 = first_hit_0(_S1086, &_S1119, _S1117, _S1118, _S1095, _S1094);
        SurfacePoint_0 _S1121 = surface_at_0(_S1086, _S1120.x_28, _S1120.y_17, _S1094);
        if(_S1112)
        {
            float central_weight_1;
            if(_S1120.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S1104;
            }
            float2  central_place_1 = make_float2 (_S1120.x_28, _S1120.y_17);
            (&box_0)->centre_0 = lerp_2(_S1107, central_place_1, make_float2 (central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S1121;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        SurfacePoint_0 _S1122 = _S1121;
        YarnPoint_0 _S1123 = yarn_point_of_0(_S1086, &_S1122, _S1120.x_28, _S1120.y_17, _S1094, _S1120.hole_5);
        SearchQuality_0 _S1124 = _S1116;
        YarnPoint_0 _S1125 = _S1123;
        Components_0 _S1126 = components_of_point_0(_S1086, &_S1124, &_S1125, _S1089, _S1090);
        float _S1127 = (F32_min((_S1093.points_1 - float(number_5 - 1U)), (1.0f)));
        Components_0 _S1128 = points_2;
        Components_0 _S1129 = _S1126;
        Components_0 _S1130 = with_added_0(&_S1128, &_S1129, _S1127);
        points_2 = _S1130;
        number_5 = number_5 + 1U;
    }
    Estimate_0 estimate_0;
    float _S1131 = _S1104 / (F32_max((_S1091), (1.0f)));
    Components_0 _S1132 = _S1108;
    Components_0 _S1133 = points_2;
    Components_0 _S1134 = with_added_0(&_S1132, &_S1133, _S1131);
    (&estimate_0)->components_0 = _S1134;
    if((_S1093.prefiltered_0) > 0.0f)
    {
        Components_0 _S1135 = prefiltered_components_0(_S1086, _S1087, to_face_frame_0(_S1089, _S1094), _S1095, _S1094);
        Components_0 _S1136 = (&estimate_0)->components_0;
        Components_0 _S1137 = _S1135;
        Components_0 _S1138 = with_added_0(&_S1136, &_S1137, _S1093.prefiltered_0);
        (&estimate_0)->components_0 = _S1138;
    }
    Footprint_0 _S1139 = box_0;
    FamilyAlbedos_0 _S1140 = albedos_over_0(_S1086, &_S1139, _S1094);
    (&estimate_0)->albedos_4 = _S1140;
    if(_S1097)
    {
        _S1097 = central_weight_0 > 0.0f;
    }
    else
    {
        _S1097 = false;
    }
    if(_S1097)
    {
        SurfacePoint_0 _S1141 = central_0;
        Albedos_0 _S1142;
        if(central_0.is_warp_0)
        {
            _S1142 = (&(&estimate_0)->albedos_4)->warp_2;
        }
        else
        {
            _S1142 = (&(&estimate_0)->albedos_4)->weft_2;
        }
        float _S1143 = central_place_0.x;
        float _S1144 = central_place_0.y;
        SurfacePoint_0 _S1145 = central_0;
        Albedos_0 _S1146 = _S1142;
        Albedos_0 _S1147 = varied_at_0(_S1086, &_S1145, &_S1146, _S1143, _S1144);
        Albedos_0 _S1148 = _S1142;
        Albedos_0 _S1149 = _S1147;
        Albedos_0 _S1150 = lerp_albedos_0(&_S1148, &_S1149, central_weight_0);
        if(_S1141.is_warp_0)
        {
            (&(&estimate_0)->albedos_4)->warp_2 = _S1150;
        }
        else
        {
            (&(&estimate_0)->albedos_4)->weft_2 = _S1150;
        }
    }
    return estimate_0;
}

__device__ float3  composed_0(uint _S1151, Components_0 * _S1152, FamilyAlbedos_0 * _S1153, float3  _S1154, float3  _S1155)
{
    Fabric_0 * _S1156 = (&(globalParams_0->fabrics_0)[_S1151]);
    float _S1157 = _S1152->diffuse_warp_0;
    float _S1158 = _S1152->diffuse_weft_0;
    float _S1159 = _S1152->specular_warp_0;
    float _S1160 = _S1152->specular_weft_0;
    float3  _S1161 = (&_S1153->warp_2)->diffuse_reflect_0 * make_float3 (_S1152->diffuse_warp_0) + (&_S1153->weft_2)->diffuse_reflect_0 * make_float3 (_S1152->diffuse_weft_0) + (&_S1153->warp_2)->specular_reflect_0 * make_float3 (_S1152->specular_warp_0) + (&_S1153->weft_2)->specular_reflect_0 * make_float3 (_S1152->specular_weft_0);
    float _S1162 = _S1155.z;
    float3  body_0;
    if((_S1154.z * _S1162) < 0.0f)
    {
        body_0 = (&_S1153->warp_2)->diffuse_transmit_0 * make_float3 (_S1157) + (&_S1153->weft_2)->diffuse_transmit_0 * make_float3 (_S1158) + (&_S1153->warp_2)->specular_transmit_0 * make_float3 (_S1159) + (&_S1153->weft_2)->specular_transmit_0 * make_float3 (_S1160);
    }
    else
    {
        body_0 = _S1161;
    }
    float _S1163 = __ldg(&_S1156->sheen_strength_0);
    if(_S1163 <= 0.0f)
    {
        return body_0;
    }
    bool _S1164 = _S1162 < 0.0f;
    float3  _S1165 = to_face_frame_0(_S1154, _S1164);
    float3  _S1166 = to_face_frame_0(_S1155, _S1164);
    float _S1167 = __ldg(&_S1156->sheen_roughness_0);
    float2  _S1168 = sheen_with_transmittance_0(_S1165, _S1166, _S1163, _S1167);
    return make_float3 (_S1168.y) * body_0 + make_float3 ((_S1152->light_visibility_1 + _S1152->hole_2) * _S1168.x);
}

__device__ float4  light_of_footprint_0(Frame_0 * _S1169, uint _S1170, VisiblePoint_0 * _S1171)
{
    Fabric_0 * _S1172 = (&(globalParams_0->fabrics_0)[_S1170]);
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = _S1171->draft_0;
    (&footprint_0)->dx_0 = _S1171->draft_dx_0;
    (&footprint_0)->dy_0 = _S1171->draft_dy_0;
    float3  _S1173 = to_local_0(_S1171, _S1171->view_0);
    float3  _S1174 = make_float3 (0.0f);
    uint number_6 = 0U;
    float3  radiance_1 = _S1174;
    float hole_7 = 0.0f;
    for(;;)
    {
        uint _S1175 = _S1169->lights_0;
        if(number_6 < (U32_max((_S1169->lights_0), (1U))))
        {
        }
        else
        {
            break;
        }
        Light_0 _S1176 = slang_ldg_3((&(globalParams_0->lights_1)[number_6]));
        Light_0 _S1177 = _S1176;
        float3  irradiance_2;
        float3  _S1178 = towards_light_0(&_S1177, _S1171->position_0, &irradiance_2);
        float3  _S1179 = to_local_0(_S1171, _S1178);
        Footprint_0 _S1180 = footprint_0;
        Estimate_0 _S1181 = lobes_estimate_0(_S1170, &_S1180, 1.0f, _S1179, _S1173);
        if(number_6 < _S1175)
        {
            Components_0 _S1182 = _S1181.components_0;
            FamilyAlbedos_0 _S1183 = _S1181.albedos_4;
            float3  _S1184 = composed_0(_S1170, &_S1182, &_S1183, _S1179, _S1173);
            radiance_1 = radiance_1 + irradiance_2 * _S1184;
        }
        number_6 = number_6 + 1U;
        hole_7 = _S1181.components_0.hole_2;
    }
    float _S1185 = __ldg(&_S1172->sheen_strength_0);
    if(_S1185 > 0.0f)
    {
        float _S1186 = (F32_abs((_S1173.z)));
        float _S1187 = __ldg(&_S1172->sheen_roughness_0);
        hole_7 = hole_7 * (1.0f - _S1185 * sheen_lobe_0(_S1186, _S1187).z);
    }
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f - hole_7);
}

extern "C" __global__ void shade_lobes()
{
    uint3  _S1188 = blockIdx * blockDim + threadIdx;
    Frame_0 _S1189 = slang_ldg_0((&(globalParams_0->frames_0)[int(0)]));
    bool _S1190;
    if((_S1188.x) >= (_S1189.width_0))
    {
        _S1190 = true;
    }
    else
    {
        _S1190 = (_S1188.y) >= (_S1189.height_0);
    }
    if(_S1190)
    {
        return;
    }
    uint2  _S1191 = uint2 {_S1188.x, _S1188.y};
    int2  _S1192 = make_int2 ((int)_S1191.x, (int)_S1191.y);
    int3  _S1193 = make_int3 (_S1192.x, _S1192.y, int(0));
    uint _S1194 = (tex2Dfetch_int<uint>((globalParams_0->visible_faces_0), ((_S1193)).x, ((_S1193)).y, ((_S1193)).z));
    float4  _S1195 = make_float4 (0.0f);
    float4  sum_1;
    if(_S1194 > 0U)
    {
        uint _S1196 = _S1194 - 1U;
        uint _S1197 = __ldg((&(globalParams_0->face_fabrics_0)[_S1196]));
        Frame_0 _S1198 = _S1189;
        VisiblePoint_0 _S1199 = visible_point_0(&_S1198, _S1197, _S1196, _S1191);
        Frame_0 _S1200 = _S1189;
        VisiblePoint_0 _S1201 = _S1199;
        float4  _S1202 = light_of_footprint_0(&_S1200, _S1197, &_S1201);
        sum_1 = _S1202;
    }
    else
    {
        sum_1 = _S1195;
    }
    Frame_0 _S1203 = _S1189;
    accumulate_0(&_S1203, _S1191, sum_1);
    return;
}

