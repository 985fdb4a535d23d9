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
__device__ float clamp_0(float x_3, float minBound_0, float maxBound_0)
{
    return (F32_min(((F32_max((x_3), (minBound_0)))), (maxBound_0)));
}

__device__ Frame_0 slang_ldg_0(Frame_0 * ptr_0)
{
    uint _S1 = __ldg(&ptr_0->width_0);
    uint _S2 = __ldg(&ptr_0->height_0);
    uint _S3 = __ldg(&ptr_0->lights_0);
    uint _S4 = __ldg(&ptr_0->samples_0);
    uint _S5 = __ldg(&ptr_0->pass_number_0);
    float _S6 = __ldg(&ptr_0->jitter_x_0);
    float _S7 = __ldg(&ptr_0->jitter_y_0);
    float _S8 = __ldg(&ptr_0->gain_0);
    float _S9 = __ldg(&ptr_0->origin_x_0);
    float _S10 = __ldg(&ptr_0->origin_y_0);
    float _S11 = __ldg(&ptr_0->origin_z_0);
    float _S12 = __ldg(&ptr_0->right_x_0);
    float _S13 = __ldg(&ptr_0->right_y_0);
    float _S14 = __ldg(&ptr_0->right_z_0);
    float _S15 = __ldg(&ptr_0->up_x_0);
    float _S16 = __ldg(&ptr_0->up_y_0);
    float _S17 = __ldg(&ptr_0->up_z_0);
    float _S18 = __ldg(&ptr_0->forward_x_0);
    float _S19 = __ldg(&ptr_0->forward_y_0);
    float _S20 = __ldg(&ptr_0->forward_z_0);
    float _S21 = __ldg(&ptr_0->near_0);
    float _S22 = __ldg(&ptr_0->background_red_0);
    float _S23 = __ldg(&ptr_0->background_green_0);
    float _S24 = __ldg(&ptr_0->background_blue_0);
    Frame_0 _S25 = { _S1, _S2, _S3, _S4, _S5, _S6, _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19, _S20, _S21, _S22, _S23, _S24 };
    return _S25;
}

__device__ float natural_logarithm_0(float x_4)
{
    uint _S26 = (F32_asuint((x_4)));
    float exponent_0 = float(int(_S26 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S26 & 8388607U) | 1056964608U)));
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
    float _S27 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S27 - exponent_1 * 0.00021219444170129f - 0.5f * _S27) + exponent_1 * 0.693359375f;
}

__device__ float exponential_0(float x_5)
{
    float _S28 = clamp_0(x_5, -87.0f, 88.0f);
    float _S29 = (F32_floor((_S28 * 1.4426950216293335f + 0.5f)));
    float _S30 = _S28 - _S29 * 0.693359375f + _S29 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S30 + 0.00139819993637502f) * _S30 + 0.00833345204591751f) * _S30 + 0.04166579619050026f) * _S30 + 0.1666666567325592f) * _S30 + 0.5f;
    float _S31 = (U32_asfloat((uint(int(_S29) + int(127)) << int(23))));
    float _S32;
    if(x_5 < -87.0f)
    {
        _S32 = 0.0f;
    }
    else
    {
        _S32 = (p_0 * _S30 * _S30 + _S30 + 1.0f) * _S31;
    }
    return _S32;
}

__device__ float power_0(float x_6, float exponent_3)
{
    return exponential_0(exponent_3 * natural_logarithm_0((F32_max((x_6), (1.00000000317107685e-30f)))));
}

__device__ uint encoded_0(float linear_0)
{
    float _S33 = clamp_0(linear_0, 0.0f, 1.0f);
    float _S34;
    if(_S33 <= 0.00313080009073019f)
    {
        _S34 = 12.92000007629394531f * _S33;
    }
    else
    {
        _S34 = 1.0549999475479126f * power_0(_S33, 0.4166666567325592f) - 0.05499999970197678f;
    }
    return uint(_S34 * 255.0f + 0.5f);
}

extern "C" __global__ void tone_map()
{
    uint3  _S35 = blockIdx * blockDim + threadIdx;
    Frame_0 _S36 = slang_ldg_0((&(globalParams_0->frames_0)[int(0)]));
    uint _S37 = _S35.x;
    if(_S37 >= (_S36.width_0 * _S36.height_0))
    {
        return;
    }
    float4  _S38 = *(&(globalParams_0->radiance_0)[_S37]);
    float3  _S39 = float3 {_S38.x, _S38.y, _S38.z} * make_float3 (_S36.gain_0);
    *(&(globalParams_0->pixels_0)[_S37]) = (((encoded_0(_S39.x)) | ((encoded_0(_S39.y)) << int(8))) | ((encoded_0(_S39.z)) << int(16))) | 4278190080U;
    return;
}

