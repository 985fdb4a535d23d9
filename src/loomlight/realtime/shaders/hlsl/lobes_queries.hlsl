#pragma pack_matrix(column_major)
#ifdef SLANG_HLSL_ENABLE_NVAPI
#include "nvHLSLExtns.h"
#endif

#ifndef __DXC_VERSION_MAJOR
// warning X3557: loop doesn't seem to do anything, forcing loop to unroll
#pragma warning(disable : 3557)
#endif

StructuredBuffer<uint > query_count_0 : register(t15);

struct Query_0
{
    uint fabric_0;
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

StructuredBuffer<Query_0 > queries_0 : register(t14);

RWStructuredBuffer<float4 > answers_0 : register(u10);

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

StructuredBuffer<Fabric_0 > fabrics_0 : register(t0);

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

StructuredBuffer<Family_0 > families_0 : register(t1);

StructuredBuffer<uint > words_0 : register(t2);

static const float2  TAP_OFFSETS_0[int(9)] = { float2(-0.3333333432674408f, -0.3333333432674408f), float2(-0.3333333432674408f, 0.0f), float2(-0.3333333432674408f, 0.3333333432674408f), float2(0.0f, -0.3333333432674408f), float2(0.0f, 0.0f), float2(0.0f, 0.3333333432674408f), float2(0.3333333432674408f, -0.3333333432674408f), float2(0.3333333432674408f, 0.0f), float2(0.3333333432674408f, 0.3333333432674408f) };
static const float  PYRAMID_RADII_0[int(4)] = { 1.0f, 2.0f, 4.0f, 8.0f };
static const float2  POINT_OFFSETS_0[int(8)] = { float2(0.0f, 0.0f), float2(-0.23010000586509705f, 0.35670000314712524f), float2(0.36809998750686646f, -0.22939999401569366f), float2(-0.28040000796318054f, -0.34400001168251038f), float2(0.3465999960899353f, 0.28859999775886536f), float2(-0.36349999904632568f, 0.0511000007390976f), float2(0.09929999709129333f, -0.35699999332427979f), float2(0.10710000246763229f, 0.32879999279975891f) };
struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float Footprint_spread_side_0(Footprint_0 this_0)
{
    float2 _S1 = this_0.dx_0;
    float2 _S2 = this_0.dy_0;
    return sqrt(0.5f * (dot(_S1, _S1) + dot(_S2, _S2)));
}

float natural_logarithm_0(float x_0)
{
    uint _S3 = asuint(x_0);
    float exponent_0 = float(int(_S3 >> int(23)) - int(126));
    float m_0 = asfloat((_S3 & 8388607U) | 1056964608U);
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
    float _S4 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S4 - exponent_1 * 0.00021219444170129f - 0.5f * _S4) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_1)
{
    return natural_logarithm_0(x_1) * 1.4426950216293335f;
}

float3 to_face_frame_0(float3 direction_0, bool back_2)
{
    float2 _S5 = direction_0.xy;
    float _S6;
    if(back_2)
    {
        _S6 = - direction_0.z;
    }
    else
    {
        _S6 = direction_0.z;
    }
    return float3(_S5, _S6);
}

struct SurfacePoint_0
{
    bool hole_0;
    bool is_warp_0;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_1;
    float3 normal_0;
    float3 tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_2, float3 normal_1, float3 tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    SurfacePoint_0 _S7;
    _S7.hole_0 = hole_1;
    _S7.is_warp_0 = is_warp_1;
    _S7.warp_thread_0 = warp_thread_1;
    _S7.weft_thread_0 = weft_thread_1;
    _S7.height_1 = height_2;
    _S7.normal_0 = normal_1;
    _S7.tangent_0 = tangent_1;
    _S7.across_0 = across_1;
    _S7.fibre_across_0 = fibre_across_1;
    _S7.fibre_along_0 = fibre_along_1;
    return _S7;
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

Components_0 no_components_0()
{
    Components_0 nothing_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_2 = 0.0f;
    return nothing_0;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

Blocked_0 no_blocked_0()
{
    Blocked_0 nothing_1;
    nothing_1.by_warp_0 = 0.0f;
    nothing_1.by_weft_0 = 0.0f;
    nothing_1.far_0 = 0.0f;
    return nothing_1;
}

struct CloseUp_0
{
    float weight_0;
    Blocked_0 warp_1;
    Blocked_0 weft_1;
};

CloseUp_0 no_close_up_0()
{
    CloseUp_0 nothing_2;
    nothing_2.weight_0 = 0.0f;
    Blocked_0 _S8 = no_blocked_0();
    nothing_2.warp_1 = _S8;
    nothing_2.weft_1 = _S8;
    return nothing_2;
}

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 quality_of_0(float threads_0)
{
    float _S9 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    SearchQuality_0 quality_0;
    float _S10 = lerp(2.5f, 5.0f, _S9);
    quality_0.steps_per_thread_0 = _S10;
    quality_0.steps_per_relief_0 = _S10;
    quality_0.shadow_share_0 = lerp(1.60000002384185791f, 1.0f, _S9);
    quality_0.refinements_0 = uint(lerp(1.0f, 2.0f, _S9) + 0.5f);
    return quality_0;
}

float2 turns_and_remainder_0(uint family_0, float index_0)
{
    float _S11 = floor(mad(index_0, families_0.Load(family_0).inverse_count_0, families_0.Load(family_0).half_inverse_count_0));
    return float2(_S11, mad(- _S11, families_0.Load(family_0).count_0, index_0));
}

struct Cell_0
{
    uint thread_0;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0)
{
    float _S12 = floor(position_0 * families_0.Load(family_1).inverse_size_0);
    Cell_0 cell_0;
    float _S13 = mad(- _S12, families_0.Load(family_1).size_0, position_0);
    cell_0.below_0 = _S13;
    cell_0.above_0 = families_0.Load(family_1).size_0 - _S13;
    cell_0.across_2 = _S13 - 0.5f * families_0.Load(family_1).size_0;
    cell_0.half_width_1 = families_0.Load(family_1).half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S12).y, 0.0f, families_0.Load(family_1).count_0 - 1.0f));
    return cell_0;
}

float table_number_0(uint index_1)
{
    return asfloat(words_0.Load(index_1));
}

Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float turns_0 = (position_1 - families_0.Load(family_2).start_0) * families_0.Load(family_2).inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S14 = turns_1 * families_0.Load(family_2).period_0;
    uint thread_1 = words_0.Load(families_0.Load(family_2).first_thread_table_0 + uint(clamp(turns_1 * families_0.Load(family_2).bins_0, 0.0f, families_0.Load(family_2).bins_0 - 1.0f)));
    uint _S15;
    if(_S14 >= (table_number_0(families_0.Load(family_2).place_table_0 + thread_1 * 4U + 1U)))
    {
        _S15 = 1U;
    }
    else
    {
        _S15 = 0U;
    }
    uint _S16 = min(thread_1 + _S15, uint(families_0.Load(family_2).count_0) - 1U);
    uint _S17 = families_0.Load(family_2).place_table_0 + _S16 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S16;
    cell_1.below_0 = _S14 - table_number_0(_S17);
    cell_1.above_0 = table_number_0(_S17 + 1U) - _S14;
    cell_1.across_2 = _S14 - table_number_0(_S17 + 2U);
    cell_1.half_width_1 = table_number_0(_S17 + 3U);
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2)
{
    if((families_0.Load(family_3).is_alike_0) != 0U)
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

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_3)
{
    bool _S18 = (abs(crossing_0.warp_2.across_2)) < (crossing_0.warp_2.half_width_1);
    bool _S19 = (abs(crossing_0.weft_2.across_2)) < (crossing_0.weft_2.half_width_1);
    Shown_0 shown_0;
    bool _S20;
    if(_S18)
    {
        if(!_S19)
        {
            _S20 = true;
        }
        else
        {
            _S20 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S20 = false;
    }
    shown_0.is_warp_2 = _S20;
    if(!_S18)
    {
        _S20 = !_S19;
    }
    else
    {
        _S20 = false;
    }
    shown_0.hole_3 = _S20;
    uint _S21;
    if(shown_0.is_warp_2)
    {
        _S21 = crossing_0.warp_word_0;
    }
    else
    {
        _S21 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S21;
    shown_0.on_top_0 = ((_S21 & 1U) == 1U) != back_3;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_0, Cell_0 second_0)
{
    Cell_0 cell_2;
    uint _S22;
    if(is_first_0)
    {
        _S22 = first_0.thread_0;
    }
    else
    {
        _S22 = second_0.thread_0;
    }
    cell_2.thread_0 = _S22;
    float _S23;
    if(is_first_0)
    {
        _S23 = first_0.across_2;
    }
    else
    {
        _S23 = second_0.across_2;
    }
    cell_2.across_2 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.half_width_1;
    }
    else
    {
        _S23 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.below_0;
    }
    else
    {
        _S23 = second_0.below_0;
    }
    cell_2.below_0 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.above_0;
    }
    else
    {
        _S23 = second_0.above_0;
    }
    cell_2.above_0 = _S23;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0)
{
    float2 _S24 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    return mad(_S24.x, families_0.Load(family_4).period_0, table_number_0(families_0.Load(family_4).place_table_0 + uint(_S24.y) * 4U));
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0)
{
    if((families_0.Load(family_5).is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * families_0.Load(family_5).size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_1);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_4)
{
    Family_0 _S25 = families_0.Load(family_6);
    uint _S26;
    if((families_0.Load(family_6).is_alike_0) != 0U)
    {
        _S26 = 0U;
    }
    else
    {
        _S26 = thread_4 * 4U;
    }
    uint _S27 = _S25.bend_table_0 + _S26;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S27);
    bend_0.half_tangent_0 = table_number_0(_S27 + 1U);
    bend_0.arc_0 = table_number_0(_S27 + 2U);
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_5, Cell_0 crossed_0, uint word_1)
{
    int _S28 = int((word_1 >> int(1)) & 127U);
    int _S29 = int((word_1 >> int(8)) & 127U);
    int _S30 = int((word_1 >> int(15)) & 63U);
    int _S31 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    int _S32 = - _S28;
    float _S33 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S32, int(0));
    run_0.from_start_0 = _S33;
    int _S34 = _S29 + int(1);
    float _S35 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, int(1), _S34);
    run_0.to_end_0 = _S35;
    bool _S36 = _S33 < _S35;
    run_0.near_start_0 = _S36;
    int _S37;
    if(_S36)
    {
        _S37 = _S32 - _S30;
    }
    else
    {
        _S37 = _S34;
    }
    int _S38;
    if(run_0.near_start_0)
    {
        _S38 = _S32;
    }
    else
    {
        _S38 = _S34 + _S31;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    float _S39;
    if(run_0.straight_0)
    {
        _S39 = 1.0e+06f;
    }
    else
    {
        _S39 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S39;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S37, _S38), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S28 == int(0);
    run_0.last_crossing_0 = _S29 == int(0);
    return run_0;
}

float square_0(float x_2)
{
    return x_2 * x_2;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_3)
{
    float _S40 = cell_3.half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S41 = clamp(cell_3.across_2, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_3 = _S41;
    float _S42 = _S40 * _S40 - square_0(_S41);
    float _S43 = rsqrt(_S42);
    section_0.drop_0 = _S40 - _S42 * _S43;
    section_0.slope_0 = - _S41 * _S43;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_6, int step_1)
{
    if((families_0.Load(family_7).is_alike_0) != 0U)
    {
        return table_number_0(families_0.Load(family_7).bend_table_0 + 3U);
    }
    return table_number_0(families_0.Load(family_7).bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

float2 dive_0(uint other_1, Shown_0 shown_1, Run_0 run_1, Cell_0 crossed_1)
{
    bool _S44 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S45 = min(crossed_1.below_0, crossed_1.above_0);
    float _S46;
    if(_S44)
    {
        _S46 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S46 = crossed_1.above_0 + crossed_1.across_2;
    }
    float _S47 = _S46 - crossed_1.half_width_1;
    bool _S48;
    if(_S44)
    {
        _S48 = run_1.first_crossing_0;
    }
    else
    {
        _S48 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S46 = 0.0f;
    }
    else
    {
        _S46 = families_0.Load(other_1).height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, int(0));
    }
    float _S49;
    if((shown_1.on_top_0) != _S48)
    {
        _S49 = 0.0f;
    }
    else
    {
        Family_0 _S50 = families_0.Load(other_1);
        int _S51;
        if(_S44)
        {
            _S51 = int(-1);
        }
        else
        {
            _S51 = int(1);
        }
        _S49 = _S50.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S51);
    }
    float _S52 = 1.0f / max(2.0f * _S47, 9.999999960041972e-13f);
    float _S53 = clamp((_S47 - _S45) * _S52, 0.0f, 1.0f);
    float _S54 = _S46 + (_S49 - _S46) * (_S53 * _S53 * (3.0f - 2.0f * _S53));
    float _S55 = (_S46 - _S49) * (6.0f * _S53 * (1.0f - _S53) * _S52);
    if(_S44)
    {
        _S46 = 1.0f;
    }
    else
    {
        _S46 = -1.0f;
    }
    return float2(_S54, _S55 * _S46);
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

StepControl_0 step_control_0(float2 direction_1, float step_3)
{
    StepControl_0 control_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    float _S56 = direction_1.x;
    control_0.per_x_0 = 1.0f / max(abs(_S56), 9.99999971718068537e-10f);
    float _S57 = direction_1.y;
    control_0.per_y_0 = 1.0f / max(abs(_S57), 9.99999971718068537e-10f);
    control_0.right_0 = _S56 > 0.0f;
    control_0.up_0 = _S57 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
    float clearance_0;
    float rate_0;
    uint yarn_0;
    bool known_0;
};

PreviousSample_0 no_previous_sample_0()
{
    PreviousSample_0 previous_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_0 = 0U;
    previous_0.known_0 = false;
    return previous_0;
}

float outline_distance_0(Cell_0 cell_4, Shown_0 shown_2, Run_0 run_2, bool lengthwise_0, bool forwards_0)
{
    float _S58;
    if(forwards_0)
    {
        _S58 = cell_4.across_2;
    }
    else
    {
        _S58 = - cell_4.across_2;
    }
    float _S59;
    if(forwards_0)
    {
        _S59 = cell_4.above_0;
    }
    else
    {
        _S59 = cell_4.below_0;
    }
    bool _S60;
    if(forwards_0)
    {
        _S60 = run_2.last_crossing_0;
    }
    else
    {
        _S60 = run_2.first_crossing_0;
    }
    bool _S61;
    if(forwards_0)
    {
        _S61 = run_2.first_crossing_0;
    }
    else
    {
        _S61 = run_2.last_crossing_0;
    }
    float _S62 = - cell_4.half_width_1;
    bool _S63 = _S58 < _S62;
    bool _S64 = _S58 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S60 = !_S60;
    }
    else
    {
        _S60 = false;
    }
    if(_S60)
    {
        _S60 = !shown_2.hole_3;
    }
    else
    {
        _S60 = false;
    }
    bool _S65;
    if(_S60)
    {
        _S65 = shown_2.on_top_0;
    }
    else
    {
        _S65 = false;
    }
    if(_S65)
    {
        if(_S61)
        {
            _S61 = _S63;
        }
        else
        {
            _S61 = false;
        }
        _S61 = !_S61;
    }
    else
    {
        _S61 = false;
    }
    if(shown_2.hole_3)
    {
        _S60 = true;
    }
    else
    {
        if(_S60)
        {
            _S60 = !shown_2.on_top_0;
        }
        else
        {
            _S60 = false;
        }
    }
    float _S66;
    if(_S63)
    {
        _S66 = _S62;
    }
    else
    {
        _S66 = cell_4.half_width_1;
    }
    float _S67 = _S66 - _S58;
    if(_S60)
    {
        _S58 = 2.0f * _S59 + _S58 - cell_4.half_width_1;
    }
    else
    {
        _S58 = _S59;
    }
    if(_S61)
    {
        if(forwards_0)
        {
            _S58 = run_2.to_end_0;
        }
        else
        {
            _S58 = run_2.from_start_0;
        }
        return _S58;
    }
    if(_S64)
    {
    }
    else
    {
        _S58 = _S67;
    }
    return _S58;
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

float way_back_to_dip_0(PreviousSample_0 previous_1, float clearance_1, float rate_1, float step_4, Probe_0 here_0)
{
    float _S68 = previous_1.rate_0 * step_4;
    float _S69 = rate_1 * step_4;
    bool _S70;
    if(!previous_1.known_0)
    {
        _S70 = true;
    }
    else
    {
        _S70 = here_0.hole_4;
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = rate_1 <= 0.0f;
    }
    if(_S70)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S68) >= 0.0f)
    {
        _S70 = (3.0f * clearance_1 - _S69) >= 0.0f;
    }
    else
    {
        _S70 = false;
    }
    if(_S70)
    {
        return -1.0f;
    }
    float _S71 = clearance_1 - previous_1.clearance_0;
    float _S72 = 6.0f * _S71 - 4.0f * _S68 - 2.0f * _S69;
    float _S73 = -2.0f * _S68 / max(_S72 + sqrt(max(_S72 * _S72 - 4.0f * (3.0f * (_S68 + _S69 - 2.0f * _S71)) * _S68, 0.0f)), 9.99999968265522539e-21f);
    float _S74 = 1.0f - _S73;
    float _S75 = (previous_1.clearance_0 * (2.0f * _S73 + 1.0f) + _S68 * _S73) * _S74 * _S74;
    float _S76 = (clearance_1 * (2.0f * _S74 + 1.0f) - _S69 * _S74) * _S73 * _S73;
    if(_S73 > 0.01999999955296516f)
    {
        _S70 = _S74 > 0.01999999955296516f;
    }
    else
    {
        _S70 = false;
    }
    if(_S70)
    {
        _S70 = (_S75 + _S76) < 0.0f;
    }
    else
    {
        _S70 = false;
    }
    float _S77;
    if(_S70)
    {
        _S77 = _S74 * step_4;
    }
    else
    {
        _S77 = -1.0f;
    }
    return _S77;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S78;
    if(here_1.hole_4)
    {
        _S78 = 1.0e+09f;
    }
    else
    {
        _S78 = clearance_2;
    }
    previous_2.clearance_0 = _S78;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S79;
    if(!here_1.hole_4)
    {
        _S79 = !is_cell_exit_0;
    }
    else
    {
        _S79 = false;
    }
    previous_2.known_0 = _S79;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_2, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S80 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    bool _S81;
    if(!here_2.hole_4)
    {
        _S81 = (rate_3 * _S80 + clearance_3) < 0.0f;
    }
    else
    {
        _S81 = false;
    }
    if(_S81)
    {
        _S81 = _S80 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S81 = false;
    }
    float _S82;
    if(_S81)
    {
        _S82 = _S80 - this_2.epsilon_0;
    }
    else
    {
        _S82 = max(_S80, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S82);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(ViewRay_0 this_3, float height_4)
{
    return this_3.origin_0 + this_3.slope_1 * height_4;
}

float ViewRay_rate_0(ViewRay_0 this_4, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S83 = end_0 - start_1;
    float _S84 = start_rate_0 + end_rate_0 - 2.0f * _S83;
    float _S85 = 3.0f * _S83 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S83, 9.99999968265522539e-21f);
    int i_0 = int(0);
    for(;;)
    {
        if(uint(i_0) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S86 = clamp(share_0 - (((_S84 * share_0 + _S85) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S84 * share_0 + 2.0f * _S85) * share_0 + start_rate_0, 0.10000000149011612f * _S83 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S87 = i_0 + int(1);
        share_0 = _S86;
        i_0 = _S87;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S88 = along_slope_0 * along_slope_0 + 1.0f;
    float _S89 = rsqrt(_S88);
    float _S90 = sine_1 * _S89 * rsqrt(_S88 + across_slope_0 * across_slope_0);
    return float2(- _S90 * _S88, _S90 * across_slope_0 * along_slope_0 + cosine_0 * _S89);
}

float arc_sine_0(float x_3)
{
    float _S91 = abs(x_3);
    bool _S92 = _S91 > 0.5f;
    float _S93;
    if(_S92)
    {
        _S93 = 0.5f * (1.0f - _S91);
    }
    else
    {
        _S93 = _S91 * _S91;
    }
    float _S94;
    if(_S92)
    {
        _S94 = sqrt(max(_S93, 0.0f));
    }
    else
    {
        _S94 = _S91;
    }
    float _S95 = ((((0.04216320067644119f * _S93 + 0.02418131195008755f) * _S93 + 0.04547002539038658f) * _S93 + 0.07495300471782684f) * _S93 + 0.16666752099990845f) * _S93 * _S94 + _S94;
    if(_S92)
    {
        _S93 = 1.57079637050628662f - 2.0f * _S95;
    }
    else
    {
        _S93 = _S95;
    }
    if(x_3 < 0.0f)
    {
        _S93 = - _S93;
    }
    return _S93;
}

float3 table_colour_0(uint index_2)
{
    return float3(table_number_0(index_2), table_number_0(index_2 + 1U), table_number_0(index_2 + 2U));
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_0)
{
    Albedos_0 albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_0);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_0 + 3U);
    albedos_0.specular_reflect_0 = table_colour_0(row_0 + 6U);
    albedos_0.specular_transmit_0 = table_colour_0(row_0 + 9U);
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_7)
{
    return table_albedos_0(families_0.Load(family_8).albedo_table_0 + families_0.Load(family_8).albedo_stride_0 * thread_7);
}

uint scramble_0(uint value_0)
{
    uint _S96 = value_0 * 747796405U + 2891336453U;
    uint _S97 = ((_S96 >> ((_S96 >> int(28)) + 4U)) ^ _S96) * 277803737U;
    return (_S97 >> int(22)) ^ _S97;
}

float uniform_hash_0(uint thread_8, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_0, float3 albedo_1, float3 room_0)
{
    float3 _S98 = room_0 / max(albedo_1, (float3)9.99999997475242708e-07f);
    return min(gain_0, max(min(min(_S98.x, _S98.y), _S98.z), 0.0f));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float diffuse_reflection_0(float3 light_0, float3 normal_2, float blend_0)
{
    float _S99 = light_0.z;
    if(_S99 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp(max(_S99, 0.0f), max(dot(light_0, normal_2), 0.0f), blend_0);
}

float projected_area_1(float3 direction_2, float3 tangent_2, float roughness_1)
{
    float _S100 = dot(direction_2, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S100 * _S100 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_4)
{
    float _S101 = clamp(x_4, -87.0f, 88.0f);
    float _S102 = floor(_S101 * 1.4426950216293335f + 0.5f);
    float _S103 = _S101 - _S102 * 0.693359375f + _S102 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S103 + 0.00139819993637502f) * _S103 + 0.00833345204591751f) * _S103 + 0.04166579619050026f) * _S103 + 0.1666666567325592f) * _S103 + 0.5f;
    float _S104 = asfloat(uint(int(_S102) + int(127)) << int(23));
    float _S105;
    if(x_4 < -87.0f)
    {
        _S105 = 0.0f;
    }
    else
    {
        _S105 = (p_0 * _S103 * _S103 + _S103 + 1.0f) * _S104;
    }
    return _S105;
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

float square_1(float3 v_0)
{
    return dot(v_0, v_0);
}

float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S106 = roughness_2 * roughness_2;
    float _S107 = squared_along_0 * (1.0f - _S106) + _S106;
    return 0.31830987334251404f * _S106 * roughness_2 / (_S107 * _S107);
}

float density_between_0(float3 light_1, float3 view_0, float3 tangent_3, float roughness_3)
{
    float3 _S108 = light_1 + view_0;
    float _S109 = dot(_S108, tangent_3);
    return flake_density_0(min(_S109 * _S109 / max(square_1(_S108), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float transmission_1(float3 light_2, float3 view_1, float3 normal_3, float3 tangent_4, float roughness_4, float optical_depth_1)
{
    float _S110 = - dot(light_2, normal_3);
    float _S111 = dot(view_1, normal_3);
    bool _S112;
    if(_S110 <= 0.0f)
    {
        _S112 = true;
    }
    else
    {
        _S112 = _S111 <= 0.0f;
    }
    if(_S112)
    {
        return 0.0f;
    }
    float _S113 = 1.0f / max(_S111, 9.99999997475242708e-07f);
    float _S114 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S110, 9.99999997475242708e-07f);
    float _S115 = projected_area_1(view_1, tangent_4, roughness_4) * _S113;
    return density_between_0(light_2, view_1, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S114, _S115)) * mean_attenuation_0(optical_depth_1 * abs(_S114 - _S115)) * _S113;
}

float reflection_0(float3 light_3, float3 view_2, float3 normal_4, float3 tangent_5, float roughness_5, float optical_depth_2)
{
    float _S116 = dot(light_3, normal_4);
    bool _S117;
    if(_S116 <= 0.0f)
    {
        _S117 = true;
    }
    else
    {
        _S117 = (dot(view_2, normal_4)) <= 0.0f;
    }
    if(_S117)
    {
        return 0.0f;
    }
    float _S118 = max(_S116, 9.99999997475242708e-07f);
    float _S119 = max(dot(view_2, normal_4), 9.99999997475242708e-07f);
    float _S120 = projected_area_1(light_3, tangent_5, roughness_5) * _S119 + projected_area_1(view_2, tangent_5, roughness_5) * _S118;
    float _S121 = optical_depth_2 * _S120 / (_S118 * _S119);
    return 0.25f * density_between_0(light_3, view_2, tangent_5, roughness_5) * (_S121 * mean_attenuation_0(_S121)) * _S118 / _S120;
}

Components_0 with_added_0(Components_0 sums_0, Components_0 more_0, float weight_1)
{
    Components_0 result_0;
    result_0.diffuse_warp_0 = sums_0.diffuse_warp_0 + weight_1 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_0.diffuse_weft_0 + weight_1 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_0.specular_warp_0 + weight_1 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_0.specular_weft_0 + weight_1 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_0.light_visibility_1 + weight_1 * more_0.light_visibility_1;
    result_0.hole_2 = sums_0.hole_2 + weight_1 * more_0.hole_2;
    return result_0;
}

Blocked_0 scaled_0(Blocked_0 blocked_0, float share_1)
{
    Blocked_0 result_1;
    result_1.by_warp_0 = share_1 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_1 * blocked_0.by_weft_0;
    result_1.far_0 = share_1 * blocked_0.far_0;
    return result_1;
}

float wrapped_cell_0(float position_3, float count_1)
{
    return min(floor((position_3 - floor(position_3)) * count_1), count_1 - 1.0f);
}

float arc_tangent_quotient_0(float x_5, float y_0)
{
    return ((((((0.0f * x_5 + 0.00809729471802711f) * x_5 + -0.0377517081797123f) * x_5 + 0.08475969731807709f) * x_5 + -0.13537675142288208f) * x_5 + 0.19895026087760925f) * x_5 + -0.33327975869178772f) * x_5 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

float arc_tangent_0(float y_1, float x_6)
{
    float _S122 = abs(x_6);
    float _S123 = abs(y_1);
    float angle_0 = arc_tangent_of_ratio_0(min(_S122, _S123) / max(max(_S122, _S123), 1.00000000317107685e-30f));
    float angle_1;
    if(_S123 > _S122)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_6 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_1 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
    uint4 nodes_0;
    uint4 weights_0;
    float inverse_sum_0;
};

NodeTaps_0 node_taps_0(float3 direction_3)
{
    float _S124 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    float _S125 = floor(_S124);
    float _S126 = _S124 - _S125;
    float _S127 = sqrt(clamp((1.0f - abs(direction_3.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S128 = 7.0f * _S127 * sqrt(_S127);
    float _S129 = min(floor(_S128), 6.0f);
    float _S130 = _S128 - _S129;
    uint _S131 = uint(int(_S125) + int(32)) % 32U;
    uint _S132 = uint(_S129);
    uint _S133 = _S131 * 8U + _S132;
    uint _S134 = (_S131 + 1U) % 32U * 8U + _S132;
    NodeTaps_0 taps_0;
    taps_0.nodes_0 = uint4(_S133, _S133 + 1U, _S134, _S134 + 1U);
    float _S135 = 1.0f - _S126;
    float _S136 = 1.0f - _S130;
    uint4 _S137 = uint4(float4(_S135 * _S136, _S135 * _S130, _S126 * _S136, _S126 * _S130) * 252.0f + 0.5f);
    taps_0.weights_0 = _S137;
    taps_0.inverse_sum_0 = 1.0f / float(_S137.x + _S137.y + _S137.z + _S137.w);
    return taps_0;
}

float3 half_vector_0(float3 light_4, float3 view_3)
{
    float3 _S138 = light_4 + view_3;
    return _S138 * rsqrt(max(square_1(_S138), 9.999999960041972e-13f));
}

float3 shadow_correlation_0(float3 light_5, float3 view_4)
{
    float2 _S139 = light_5.xy;
    float2 _S140 = view_4.xy;
    float _S141 = dot(_S139, _S140) / max(sqrt(dot(_S139, _S139) * dot(_S140, _S140)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return float3((float2)(-0.09000000357627869f + -0.07999999821186066f * _S141), 0.0f);
    }
    return float3(min(0.62000000476837158f + 0.62999999523162842f * _S141, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

float4 interpolate_0(NodeTaps_0 taps_1, uint4 packs_1)
{
    uint4 _S142 = (packs_1 & 16711935U) * taps_1.weights_0;
    uint4 _S143 = ((packs_1 >> int(8)) & 16711935U) * taps_1.weights_0;
    return bytes_of_sums_0(_S142.x + _S142.y + _S142.z + _S142.w, _S143.x + _S143.y + _S143.z + _S143.w) * taps_1.inverse_sum_0;
}

float4 interpolate_table_0(NodeTaps_0 taps_2, uint table_0, uint stride_0)
{
    uint4 _S144 = table_0 + taps_2.nodes_0 * stride_0;
    return interpolate_0(taps_2, uint4(words_0.Load(_S144.x), words_0.Load(_S144.y), words_0.Load(_S144.z), words_0.Load(_S144.w)));
}

struct Group_0
{
    float3 normal_5;
    float weight_2;
    float3 tangent_6;
    float3 variance_0;
    float3 covariance_0;
    float roughness_6;
};

Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    group_0.normal_5 = float3(table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    group_0.weight_2 = table_number_0(row_1 + 3U);
    float3 _S145 = float3(table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    group_0.tangent_6 = _S145;
    float _S146 = table_number_0(row_1 + 7U);
    float _S147 = table_number_0(row_1 + 8U);
    group_0.variance_0 = float3(_S146, _S147, 1.0f - square_1(_S145) - _S146 - _S147);
    group_0.covariance_0 = float3(table_number_0(row_1 + 9U), table_number_0(row_1 + 10U), table_number_0(row_1 + 11U));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

float2 visibility_gain_0(float3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * (1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f) + float2(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), (float2)0.0f);
}

float Group_variance_along_0(Group_0 this_5, float3 direction_4)
{
    float _S148 = direction_4.x;
    float _S149 = direction_4.y;
    float _S150 = direction_4.z;
    return max(dot(this_5.variance_0, direction_4 * direction_4) + 2.0f * dot(this_5.covariance_0, float3(_S148 * _S149, _S148 * _S150, _S149 * _S150)), 0.0f);
}

float mean_area_0(Group_0 group_1, float3 direction_5)
{
    float _S151 = dot(direction_5, group_1.tangent_6);
    float _S152 = group_1.roughness_6;
    float _S153 = _S152 * _S152;
    return sqrt(max((_S153 - 1.0f) * (_S151 * _S151 + Group_variance_along_0(group_1, direction_5)) + 1.0f, _S153));
}

float mean_density_0(Group_0 group_2, float3 half_0)
{
    float _S154 = group_2.roughness_6;
    float _S155 = max(sqrt(max(1.0f - _S154 * _S154, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    float _S156 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    float _S157 = dot(half_0, group_2.tangent_6);
    float _S158 = _S155 * (_S157 - _S156);
    float _S159 = _S155 * (_S157 + _S156);
    float _S160 = _S158 * _S159;
    float _S161 = 2.0f * _S156 * _S155;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S160) / ((_S158 * _S158 + 1.0f) * (_S159 * _S159 + 1.0f)) + arc_tangent_0(_S161, 1.0f + _S160) / _S161);
}

float layer_value_0(Group_0 group_3, float3 half_1, float3 light_6, float3 view_5, float optical_depth_3)
{
    bool _S162 = (light_6.z) < 0.0f;
    float _S163 = dot(light_6, group_3.normal_5);
    float _S164;
    if(_S162)
    {
        _S164 = - _S163;
    }
    else
    {
        _S164 = _S163;
    }
    float _S165 = max(dot(view_5, group_3.normal_5), 0.01999999955296516f);
    float _S166 = mean_area_0(group_3, light_6) / max(_S164, 0.01999999955296516f);
    float _S167 = mean_area_0(group_3, view_5) / _S165;
    if(_S162)
    {
        _S164 = abs(_S166 - _S167);
    }
    else
    {
        _S164 = _S166 + _S167;
    }
    float _S168 = optical_depth_3 * max(_S164, 0.00100000004749745f);
    if(_S162)
    {
        _S164 = exponential_0(- optical_depth_3 * min(_S166, _S167));
    }
    else
    {
        _S164 = 1.0f;
    }
    float _S169 = optical_depth_3 * _S164 * (1.0f - exponential_0(- _S168)) / _S168 / _S165;
    if(_S162)
    {
        _S164 = 1.0f;
    }
    else
    {
        _S164 = 1.0f - 0.34999999403953552f * (1.0f - square_1(group_3.normal_5));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S164 * _S169;
}

struct Bound_0
{
    uint thread_11;
    float turns_2;
    float cell_7;
    float visible_0;
    float width_1;
    float gap_0;
};

Bound_0 bound_at_0(uint family_9, float position_4)
{
    Cell_0 _S170 = locate_0(family_9, position_4);
    float _S171 = table_number_0(families_0.Load(family_9).before_0 + 2U * _S170.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_11 = _S170.thread_0;
    bound_0.turns_2 = round((position_4 - families_0.Load(family_9).start_0 - _S171 - _S170.below_0) * families_0.Load(family_9).inverse_period_0);
    bound_0.cell_7 = _S170.below_0;
    float _S172 = 2.0f * _S170.half_width_1;
    bound_0.width_1 = _S172;
    bound_0.visible_0 = clamp((_S170.across_2 + _S170.half_width_1) / _S172, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S170.below_0, _S170.below_0 - _S170.across_2 - _S170.half_width_1) + max(_S170.across_2 - _S170.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1)
{
    float _S173 = centre_1 - floor((centre_1 - families_0.Load(family_10).start_0) * families_0.Load(family_10).inverse_period_0) * families_0.Load(family_10).period_0;
    float _S174 = 0.5f * max(size_1, families_0.Load(family_10).smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_0 = bound_at_0(family_10, _S173 - _S174);
    stretch_0.high_0 = bound_at_0(family_10, _S173 + _S174);
    return stretch_0;
}

float Stretch_turns_0(Stretch_0 this_6)
{
    return this_6.high_0.turns_2 - this_6.low_0.turns_2;
}

float3 lengths_0(uint family_11, Stretch_0 stretch_1)
{
    float _S175 = Stretch_turns_0(stretch_1);
    uint _S176 = families_0.Load(family_11).before_0 + 2U * stretch_1.low_0.thread_11;
    uint _S177 = families_0.Load(family_11).before_0 + 2U * stretch_1.high_0.thread_11;
    float _S178 = table_number_0(_S177) - table_number_0(_S176);
    float _S179 = table_number_0(_S177 + 1U) - table_number_0(_S176 + 1U);
    return float3(_S178 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_1 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_1 + _S175 * families_0.Load(family_11).visible_total_0, _S179 - _S178 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S175 * (families_0.Load(family_11).period_0 - families_0.Load(family_11).visible_total_0), _S179 + stretch_1.high_0.cell_7 - stretch_1.low_0.cell_7 + _S175 * families_0.Load(family_11).period_0);
}

float2 integrals_along_0(uint family_12, Stretch_0 stretch_2, uint quantity_0)
{
    Family_0 _S180 = families_0.Load(family_12);
    uint _S181 = 3U * _S180.quantities_0;
    uint _S182 = families_0.Load(family_12).colour_threads_0 + _S181 * stretch_2.low_0.thread_11 + quantity_0;
    uint _S183 = families_0.Load(family_12).colour_threads_0 + _S181 * stretch_2.high_0.thread_11 + quantity_0;
    uint _S184 = families_0.Load(family_12).colour_threads_0 + _S181 * uint(families_0.Load(family_12).count_0) + quantity_0;
    float _S185 = table_number_0(_S182);
    float _S186 = table_number_0(_S183);
    float _S187 = Stretch_turns_0(stretch_2);
    uint _S188 = 2U * _S180.quantities_0;
    return float2(table_number_0(_S183 + _S180.quantities_0) - table_number_0(_S182 + _S180.quantities_0) + _S186 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_1 - _S185 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_1 + _S187 * table_number_0(_S184 + _S180.quantities_0), table_number_0(_S183 + _S188) - table_number_0(_S182 + _S188) + _S186 * stretch_2.high_0.cell_7 - _S185 * stretch_2.low_0.cell_7 + _S187 * table_number_0(_S184 + _S188));
}

bool Stretch_wraps_0(Stretch_0 this_7)
{
    return (this_7.high_0.thread_11) < (this_7.low_0.thread_11);
}

uint4 Stretch_differences_0(Stretch_0 this_8, uint4 entries_0, uint whole_0)
{
    uint _S189 = entries_0.z;
    uint _S190 = entries_0.x;
    uint _S191 = _S189 - _S190;
    uint _S192;
    if(Stretch_wraps_0(this_8))
    {
        _S192 = whole_0;
    }
    else
    {
        _S192 = 0U;
    }
    return uint4(_S191 + _S192, entries_0.w - _S189, entries_0.y - _S190, whole_0);
}

uint4 row_differences_0(Stretch_0 across_4, uint row_2, uint count_2, uint quantities_1)
{
    uint _S193 = row_2 + across_4.low_0.thread_11 * quantities_1;
    uint _S194 = row_2 + across_4.high_0.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, uint4(words_0.Load(_S193), words_0.Load(_S193 + quantities_1), words_0.Load(_S194), words_0.Load(_S194 + quantities_1)), words_0.Load(row_2 + count_2 * quantities_1));
}

float4 Stretch_weights_0(Stretch_0 this_9)
{
    float _S195 = - this_9.low_0.visible_0;
    float _S196 = Stretch_turns_0(this_9);
    float _S197;
    if(Stretch_wraps_0(this_9))
    {
        _S197 = 1.0f;
    }
    else
    {
        _S197 = 0.0f;
    }
    return float4(1.0f, this_9.high_0.visible_0, _S195, _S196 - _S197);
}

float integral_on_top_0(uint family_13, Stretch_0 across_5, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S198 = uint(families_0.Load(family_13).count_0);
    uint _S199 = (_S198 + 1U) * families_0.Load(family_13).quantities_0;
    uint _S200 = families_0.Load(family_13).colour_areas_0 + quantity_1;
    uint4 _S201 = row_differences_0(across_5, _S200 + along_0.low_0.thread_11 * _S199, _S198, families_0.Load(family_13).quantities_0);
    uint4 _S202 = row_differences_0(across_5, _S200 + (along_0.low_0.thread_11 + 1U) * _S199, _S198, families_0.Load(family_13).quantities_0);
    uint4 _S203 = row_differences_0(across_5, _S200 + along_0.high_0.thread_11 * _S199, _S198, families_0.Load(family_13).quantities_0);
    uint4 _S204 = row_differences_0(across_5, _S200 + (along_0.high_0.thread_11 + 1U) * _S199, _S198, families_0.Load(family_13).quantities_0);
    uint4 _S205 = row_differences_0(across_5, _S200 + crossing_count_0 * _S199, _S198, families_0.Load(family_13).quantities_0);
    uint4 _S206 = _S203 - _S201;
    uint4 _S207;
    if(Stretch_wraps_0(along_0))
    {
        _S207 = _S205;
    }
    else
    {
        _S207 = uint4((int4)int(0));
    }
    float4 _S208 = Stretch_weights_0(across_5);
    return dot(float4(dot(float4(int4(_S206 + _S207)), _S208), dot(float4(int4(_S204 - _S203)), _S208), dot(float4(int4(_S202 - _S201)), _S208), dot(float4(int4(_S205)), _S208)), Stretch_weights_0(along_0)) * families_0.Load(family_13).area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_3, uint row_3)
{
    Albedos_0 _S209 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_3 * _S209.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_3 * _S209.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_3 * _S209.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_3 * _S209.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, Stretch_0 own_1, Stretch_0 other_2, bool back_4)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0.Load(family_14).colour_mean_0);
    if((families_0.Load(family_14).quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S210 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_4 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0.Load(family_14).quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S211 = integrals_along_0(family_14, own_1, quantity_2);
        float _S212 = integral_on_top_0(family_14, own_1, other_2, uint(families_0.Load(crossing_1).count_0), quantity_2);
        float _S213 = _S211.x;
        float _S214 = _S213 * _S210.x;
        float _S215;
        if(back_4)
        {
            _S215 = _S214 - _S212;
        }
        else
        {
            _S215 = _S212;
        }
        bool _S216 = quantity_2 == 0U;
        if(_S216)
        {
            is_exposed_0 = _S215 > (16.0f * families_0.Load(family_14).area_unit_0 * min(_S214 / families_0.Load(family_14).crossing_area_0, 1.0f) + 0.00000999999974738f * _S214);
        }
        float _S217 = _S213 * _S210.y;
        float _S218;
        if(is_exposed_0)
        {
            _S218 = _S215;
        }
        else
        {
            _S218 = 0.0f;
        }
        float _S219 = _S217 + _S218 + 0.000244140625f * _S210.z * _S211.y;
        if(_S216)
        {
            weight_4 = 1.0f / max(_S219, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S219 * weight_4, families_0.Load(family_14).colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

Albedos_0 lerp_albedos_0(Albedos_0 first_2, Albedos_0 second_1, float weight_5)
{
    Albedos_0 albedos_3;
    float3 _S220 = (float3)weight_5;
    albedos_3.diffuse_reflect_0 = lerp(first_2.diffuse_reflect_0, second_1.diffuse_reflect_0, _S220);
    albedos_3.diffuse_transmit_0 = lerp(first_2.diffuse_transmit_0, second_1.diffuse_transmit_0, _S220);
    albedos_3.specular_reflect_0 = lerp(first_2.specular_reflect_0, second_1.specular_reflect_0, _S220);
    albedos_3.specular_transmit_0 = lerp(first_2.specular_transmit_0, second_1.specular_transmit_0, _S220);
    return albedos_3;
}

Albedos_0 tinted_0(Albedos_0 albedos_4, float3 tint_0)
{
    Albedos_0 result_2 = albedos_4;
    result_2.diffuse_reflect_0 = result_2.diffuse_reflect_0 * tint_0;
    result_2.diffuse_transmit_0 = result_2.diffuse_transmit_0 * tint_0;
    return result_2;
}

struct FaceRadiance_0
{
    float3 warp_3;
    float3 weft_3;
    float3 mean_0;
    float3 leaked_0;
};

struct FaceSends_0
{
    float3 sky_warp_0;
    float3 sky_weft_0;
    float3 crossing_warp_0;
    float3 crossing_weft_0;
    float open_0;
    float blocks_warp_0;
    float blocks_weft_0;
};

FaceRadiance_0 face_radiance_0(FaceSends_0 sends_0, float open_of_other_0, float3 passed_0, float3 from_other_0)
{
    float3 _S221 = (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3 _S222 = sends_0.sky_warp_0 + _S221 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S222;
    float3 _S223 = sends_0.sky_weft_0 + _S221 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S223;
    found_0.mean_0 = sends_0.blocks_warp_0 * _S222 + sends_0.blocks_weft_0 * _S223;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(float3 view_6, out float  terms_0[int(6)])
{
    float _S224 = 1.0f - view_6.z;
    float _S225 = _S224 * _S224;
    terms_0[int(0)] = 1.0f;
    float _S226 = view_6.x;
    float _S227 = _S226 * _S226;
    float _S228 = view_6.y;
    float _S229 = _S228 * _S228;
    terms_0[int(1)] = sqrt(max(_S227 + _S229, 9.999999960041972e-13f));
    terms_0[int(2)] = _S225;
    terms_0[int(3)] = _S225 * _S225;
    terms_0[int(4)] = _S227 - _S229;
    terms_0[int(5)] = 0.0f;
    return;
}

struct Bounced_0
{
    float3 reflected_0;
    float3 transmitted_0;
};

struct Scattered_0
{
    float3 back_5;
    float3 through_0;
};

struct Interior_0
{
    float3 warp_4;
    float3 weft_4;
    float3 leaked_1;
    float3 far_1;
    float3 far_leaked_0;
};

Bounced_0 bounced_by_0(Blocked_0 blocked_1, Scattered_0 yarn_2, Interior_0 interior_0)
{
    float3 _S230 = (blocked_1.by_warp_0 + blocked_1.by_weft_0) * interior_0.leaked_1;
    float3 _S231 = blocked_1.far_0 * yarn_2.through_0;
    Bounced_0 bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (blocked_1.by_warp_0 * interior_0.warp_4 + blocked_1.by_weft_0 * interior_0.weft_4) + _S231 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S231 * interior_0.far_1 + yarn_2.back_5 * _S230;
    return bounced_0;
}

Bounced_0 sum_of_0(Bounced_0 first_3, Bounced_0 second_2)
{
    Bounced_0 sum_1;
    sum_1.reflected_0 = first_3.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_3.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

float3 bounced_value_0(Bounced_0 bounced_1, float3 light_7, float3 view_7)
{
    float _S232 = light_7.z;
    float3 _S233;
    if((_S232 * view_7.z) < 0.0f)
    {
        _S233 = bounced_1.transmitted_0;
    }
    else
    {
        _S233 = bounced_1.reflected_0;
    }
    return _S233 * (abs(_S232) * 0.31830987334251404f);
}

float sheen_scale_0(float x_7, float y_2)
{
    return (((((0.0f * x_7 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_7 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_7 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_7 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_7 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_7 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_8, float y_3)
{
    return ((((0.0f * x_8 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_8 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_8 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_8 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_8 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_9, float y_4)
{
    return ((((0.0f * x_9 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_9 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_9 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_9 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_9 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S234 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S235 = 2.0f * sqrt(_S234) - 1.0f;
    float _S236 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S235, _S236), 0.00999999977648258f, 1.0f), clamp((1.0f - _S234) * sheen_shear_0(_S235, _S236), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S235, _S236), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_8, float3 view_8, float scale_0, float shear_0)
{
    float _S237 = light_8.z;
    bool _S238;
    if(_S237 <= 0.0f)
    {
        _S238 = true;
    }
    else
    {
        _S238 = (view_8.z) <= 0.0f;
    }
    if(_S238)
    {
        return 0.0f;
    }
    float2 _S239 = view_8.xy;
    float _S240 = dot(_S239, _S239);
    float2 _S241;
    if(_S240 > 9.99999968265522539e-21f)
    {
        _S241 = _S239 * rsqrt(_S240);
    }
    else
    {
        _S241 = float2(1.0f, 0.0f);
    }
    float _S242 = scale_0 * dot(light_8.xy, _S241) + shear_0 * _S237;
    float _S243 = scale_0 * (light_8.y * _S241.x - light_8.x * _S241.y);
    float _S244 = _S242 * _S242 + _S243 * _S243 + _S237 * _S237;
    return 0.31830987334251404f * scale_0 * scale_0 * _S237 / max(_S244 * _S244, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_9, float3 view_9, float strength_0, float roughness_9)
{
    float3 _S245 = sheen_lobe_0(view_9.z, roughness_9);
    float _S246 = strength_0 * _S245.z;
    return float2(_S246 * transformed_cosine_0(light_9, view_9, _S245.x, _S245.y), 1.0f - _S246);
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
    float points_0;
};

Regime_0 regime_of_0(uint _S247, Footprint_0 _S248, float _S249)
{
    float _S250 = Footprint_spread_side_0(_S248);
    float _S251 = clamp((binary_logarithm_0(max(_S250, 9.99999971718068537e-10f)) - fabrics_0[_S247].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S252 = _S251 * _S251 * (3.0f - 2.0f * _S251);
    regime_0.prefiltered_0 = _S252;
    regime_0.threads_1 = _S250 * fabrics_0[_S247].lobes_0.threads_per_mm_0;
    float _S253 = lerp(max(8.0f / _S249, 1.0f), 1.0f, _S252);
    float _S254;
    if(_S252 < 1.0f)
    {
        _S254 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S253);
    }
    else
    {
        _S254 = 0.0f;
    }
    regime_0.points_0 = _S254;
    return regime_0;
}

struct Hit_0
{
    float x_10;
    float y_5;
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

Crossing_0 crossing_at_0(uint _S255, float _S256, float _S257, bool _S258)
{
    Crossing_0 crossing_3;
    crossing_3.warp_2 = locate_0(fabrics_0[_S255].warp_0, _S256);
    crossing_3.weft_2 = locate_0(fabrics_0[_S255].weft_0, _S257);
    uint _S259 = fabrics_0[_S255].run_words_0 + 2U * (crossing_3.weft_2.thread_0 * fabrics_0[_S255].ends_1 + crossing_3.warp_2.thread_0);
    uint _S260 = words_0.Load(_S259);
    crossing_3.warp_word_0 = _S260;
    crossing_3.weft_word_0 = words_0.Load(_S259 + 1U);
    crossing_3.warp_above_0 = ((_S260 & 1U) == 1U) != _S258;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S261, float _S262, float _S263, bool _S264)
{
    Sample_0 sample_0;
    Crossing_0 _S265 = crossing_at_0(_S261, _S262, _S263, _S264);
    sample_0.crossing_2 = _S265;
    Shown_0 _S266 = shown_at_0(_S265, _S264);
    sample_0.shown_3 = _S266;
    uint _S267;
    if(_S266.is_warp_2)
    {
        _S267 = fabrics_0[_S261].warp_0;
    }
    else
    {
        _S267 = fabrics_0[_S261].weft_0;
    }
    uint _S268;
    if(_S266.is_warp_2)
    {
        _S268 = fabrics_0[_S261].weft_0;
    }
    else
    {
        _S268 = fabrics_0[_S261].warp_0;
    }
    Cell_0 _S269 = select_cell_0(_S266.is_warp_2, sample_0.crossing_2.warp_2, sample_0.crossing_2.weft_2);
    Cell_0 _S270 = select_cell_0(_S266.is_warp_2, sample_0.crossing_2.weft_2, sample_0.crossing_2.warp_2);
    Run_0 _S271 = unpack_0(_S267, _S268, _S269.thread_0, _S270, _S266.word_0);
    Section_0 _S272 = section_at_0(_S269);
    bool _S273;
    if(_S266.on_top_0)
    {
        _S273 = (_S271.distance_0) < (_S272.drop_0 * _S271.bend_1.sine_0);
    }
    else
    {
        _S273 = false;
    }
    bool _S274;
    if(_S266.on_top_0)
    {
        _S274 = !_S273;
    }
    else
    {
        _S274 = false;
    }
    float _S275;
    if(_S274)
    {
        _S275 = 1.0f;
    }
    else
    {
        _S275 = -1.0f;
    }
    float _S276;
    if(_S273)
    {
        _S276 = _S271.other_reach_0;
    }
    else
    {
        _S276 = _S271.reach_0;
    }
    float _S277;
    if(_S273)
    {
        _S277 = _S276 + _S271.distance_0;
    }
    else
    {
        _S277 = max(_S276 - _S271.distance_0, 0.0f);
    }
    float _S278 = _S276 / _S271.bend_1.sine_0 - _S275 * _S272.drop_0;
    float _S279 = _S277 * _S277;
    float _S280 = max(_S278 * _S278 - _S279, 9.99999968265522539e-21f);
    float _S281 = rsqrt(_S280);
    float _S282 = _S279 / (_S280 * _S281 + _S278);
    bool _S283 = _S277 > 0.0f;
    float _S284;
    if(_S266.on_top_0)
    {
        _S284 = 1.0f;
    }
    else
    {
        _S284 = -1.0f;
    }
    float _S285;
    if(_S271.near_start_0)
    {
        _S285 = 1.0f;
    }
    else
    {
        _S285 = -1.0f;
    }
    float _S286 = _S284 * _S285;
    if(_S283)
    {
        _S284 = _S278 * _S281;
    }
    else
    {
        _S284 = 1.0f;
    }
    sample_0.slope_across_0 = _S272.slope_0 * _S284;
    if(_S283)
    {
        _S277 = _S286 * _S277 * _S281;
    }
    else
    {
        _S277 = 0.0f;
    }
    sample_0.slope_along_0 = _S277;
    Family_0 _S287 = families_0.Load(_S267);
    float2 _S288 = dive_0(_S268, _S266, _S271, _S270);
    if(_S271.straight_0)
    {
        _S275 = 0.0f;
    }
    else
    {
        _S275 = _S287.height_scale_0 * _S275;
    }
    sample_0.height_6 = _S275 * (_S276 * _S271.bend_1.half_tangent_0 - _S282) - _S287.height_scale_0 * _S272.drop_0 - _S288.x;
    float _S289 = _S287.height_scale_0 * sample_0.slope_across_0;
    float _S290 = _S287.height_scale_0 * sample_0.slope_along_0 - _S288.y;
    if(_S266.is_warp_2)
    {
        _S275 = _S289;
    }
    else
    {
        _S275 = _S290;
    }
    sample_0.slope_x_1 = _S275;
    if(_S266.is_warp_2)
    {
        _S275 = _S290;
    }
    else
    {
        _S275 = _S289;
    }
    sample_0.slope_y_1 = _S275;
    sample_0.run_3 = _S271;
    sample_0.section_1 = _S272;
    return sample_0;
}

float steps_per_length_0(uint _S291, SearchQuality_0 _S292, float3 _S293)
{
    return max(max(abs(_S293.x) * fabrics_0[_S291].threads_per_x_0, abs(_S293.y) * fabrics_0[_S291].threads_per_y_0) * _S292.steps_per_thread_0, abs(_S293.z) * fabrics_0[_S291].per_relief_0 * _S292.steps_per_relief_0);
}

float cell_maximum_0(uint _S294, Crossing_0 _S295)
{
    uint _S296;
    if(_S295.warp_above_0)
    {
        _S296 = fabrics_0[_S294].warp_0;
    }
    else
    {
        _S296 = fabrics_0[_S294].weft_0;
    }
    uint _S297;
    if(_S295.warp_above_0)
    {
        _S297 = _S295.warp_word_0;
    }
    else
    {
        _S297 = _S295.weft_word_0;
    }
    return float(_S297 >> int(28)) * families_0.Load(_S296).height_scale_0 * families_0.Load(_S296).level_0;
}

Probe_0 probe_0(uint _S298, float _S299, float _S300, bool _S301, bool _S302, bool _S303)
{
    Sample_0 _S304 = sample_at_0(_S298, _S299, _S300, _S301);
    Probe_0 probe_1;
    probe_1.height_3 = _S304.height_6;
    probe_1.hole_4 = _S304.shown_3.hole_3;
    probe_1.slope_x_0 = _S304.slope_x_1;
    probe_1.slope_y_0 = _S304.slope_y_1;
    uint _S305;
    if(_S304.shown_3.is_warp_2)
    {
        _S305 = _S304.crossing_2.warp_2.thread_0 * 2U + 1U;
    }
    else
    {
        _S305 = _S304.crossing_2.weft_2.thread_0 * 2U;
    }
    probe_1.yarn_1 = _S305;
    probe_1.cell_max_0 = cell_maximum_0(_S298, _S304.crossing_2);
    float _S306;
    if(_S302)
    {
        _S306 = _S304.crossing_2.warp_2.above_0;
    }
    else
    {
        _S306 = _S304.crossing_2.warp_2.below_0;
    }
    probe_1.side_x_0 = _S306;
    if(_S303)
    {
        _S306 = _S304.crossing_2.weft_2.above_0;
    }
    else
    {
        _S306 = _S304.crossing_2.weft_2.below_0;
    }
    probe_1.side_y_0 = _S306;
    probe_1.edge_x_0 = outline_distance_0(_S304.crossing_2.warp_2, _S304.shown_3, _S304.run_3, !_S304.shown_3.is_warp_2, _S302);
    probe_1.edge_y_0 = outline_distance_0(_S304.crossing_2.weft_2, _S304.shown_3, _S304.run_3, _S304.shown_3.is_warp_2, _S303);
    return probe_1;
}

bool is_free_0(uint _S307, SearchQuality_0 _S308, float3 _S309, float3 _S310, bool _S311, float _S312)
{
    float _S313 = _S310.z;
    if(_S313 <= 0.0f)
    {
        return false;
    }
    float _S314 = 1.0f / max(_S308.shadow_share_0 * steps_per_length_0(_S307, _S308, _S310), 9.99999971718068537e-10f);
    StepControl_0 _S315 = step_control_0(_S310.xy, _S314);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S316;
        if(count_3 < 1024U)
        {
            _S316 = (_S309.z + _S313 * distance_1) < _S312;
        }
        else
        {
            _S316 = false;
        }
        if(_S316)
        {
        }
        else
        {
            break;
        }
        float3 _S317 = _S309 + _S310 * distance_1;
        Probe_0 _S318 = probe_0(_S307, _S317.x, _S317.y, _S311, _S315.right_0, _S315.up_0);
        float _S319 = _S317.z;
        float _S320 = _S319 - _S318.height_3;
        float _S321 = _S313 - _S318.slope_x_0 * _S310.x - _S318.slope_y_0 * _S310.y;
        bool _S322;
        if(!_S318.hole_4)
        {
            _S322 = _S320 < 0.0f;
        }
        else
        {
            _S322 = false;
        }
        if(_S322)
        {
            return false;
        }
        float _S323 = way_back_to_dip_0(previous_3, _S320, _S321, last_step_0, _S318);
        if(_S323 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S323;
            distance_1 = distance_1 - _S323;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S324 = _S319 > (_S318.cell_max_0);
        PreviousSample_0 _S325 = after_sample_0(_S320, _S321, _S318, _S324);
        float last_step_2;
        if(_S324)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S315, _S318.side_x_0, _S318.side_y_0), _S314);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S315, _S318, _S320, _S321);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S325;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S326, SearchQuality_0 _S327, float _S328, float _S329, float3 _S330, bool _S331)
{
    if(!sample_at_0(_S326, _S328, _S329, _S331).shown_3.hole_3)
    {
        return false;
    }
    float3 _S332 = float3(_S328, _S329, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S333;
        if(side_0 < 2U)
        {
            _S333 = passes_0;
        }
        else
        {
            _S333 = false;
        }
        if(_S333)
        {
        }
        else
        {
            break;
        }
        float3 _S334;
        if(side_0 == 0U)
        {
            _S334 = _S330;
        }
        else
        {
            _S334 = float3(- _S330.x, - _S330.y, _S330.z);
        }
        bool _S335 = is_free_0(_S326, _S327, _S332, _S334, _S331 != (side_0 == 1U), fabrics_0[_S326].height_high_0);
        uint _S336 = side_0 + 1U;
        passes_0 = _S335;
        side_0 = _S336;
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

float max_height_along_0(uint _S337, float _S338, float _S339, float _S340, float3 _S341, bool _S342)
{
    uint _S343 = locate_0(fabrics_0[_S337].warp_0, _S338).thread_0 / 2U;
    uint _S344 = locate_0(fabrics_0[_S337].weft_0, _S339).thread_0 / 2U;
    float _S345 = _S341.x;
    uint _S346;
    if(_S345 > 0.0f)
    {
        _S346 = 1U;
    }
    else
    {
        _S346 = 0U;
    }
    float _S347 = _S341.y;
    uint _S348;
    if(_S347 > 0.0f)
    {
        _S348 = 2U;
    }
    else
    {
        _S348 = 0U;
    }
    uint _S349 = words_0.Load(fabrics_0[_S337].max_heights_0 + 4U * (_S344 * fabrics_0[_S337].max_height_columns_0 + _S343) + (_S346 + _S348));
    int number_0;
    if(_S342)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S350 = _S349 >> number_0;
    float _S351 = max(abs(_S345) * fabrics_0[_S337].threads_per_x_0, abs(_S347) * fabrics_0[_S337].threads_per_y_0) / _S341.z;
    float _S352 = fabrics_0[_S337].height_high_0;
    float max_height_0 = fabrics_0[_S337].height_high_0;
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
        if(((max_height_0 - _S340) * _S351) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S350 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S352);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S353, float _S354, float _S355, bool _S356, bool _S357, bool _S358)
{
    Crossing_0 _S359 = crossing_at_0(_S353, _S354, _S355, _S356);
    float _S360 = cell_maximum_0(_S353, _S359);
    float _S361;
    if(_S357)
    {
        _S361 = _S359.warp_2.above_0;
    }
    else
    {
        _S361 = _S359.warp_2.below_0;
    }
    float _S362;
    if(_S358)
    {
        _S362 = _S359.weft_2.above_0;
    }
    else
    {
        _S362 = _S359.weft_2.below_0;
    }
    return float3(_S360, _S361, _S362);
}

float first_sample_height_0(uint _S363, ViewRay_0 _S364, StepControl_0 _S365, bool _S366)
{
    float _S367 = max_height_along_0(_S363, _S364.origin_0.x, _S364.origin_0.y, 0.0f, float3(_S364.slope_1, 1.0f), _S366);
    uint count_4 = 0U;
    float height_8 = _S367;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S368 = ViewRay_at_0(_S364, height_8);
        float3 _S369 = cell_bounds_0(_S363, _S368.x, _S368.y, _S366, _S365.right_0, _S365.up_0);
        float _S370 = height_8 - _S369.x;
        float _S371 = StepControl_to_cell_exit_0(_S365, _S369.y, _S369.z);
        float height_9 = height_8 - clamp(_S370, 0.0f, _S371);
        if(_S370 <= _S371)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S372, ViewRay_0 _S373, StepControl_0 _S374, bool _S375)
{
    float _S376 = fabrics_0[_S372].height_low_0 - (fabrics_0[_S372].height_high_0 - fabrics_0[_S372].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_7 = first_sample_height_0(_S372, _S373, _S374, _S375);
    end_1.last_step_3 = _S374.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
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
        float2 _S377 = ViewRay_at_0(_S373, end_1.height_7);
        Probe_0 _S378 = probe_0(_S372, _S377.x, _S377.y, _S375, _S374.right_0, _S374.up_0);
        float _S379 = end_1.height_7 - _S378.height_3;
        float _S380 = ViewRay_rate_0(_S373, _S378);
        end_1.depth_1 = - _S379;
        end_1.rate_4 = _S380;
        bool _S381;
        if(end_1.previous_4.known_0)
        {
            _S381 = !_S378.hole_4;
        }
        else
        {
            _S381 = false;
        }
        bool _S382;
        if(_S381)
        {
            _S382 = (end_1.previous_4.yarn_0) == (_S378.yarn_1);
        }
        else
        {
            _S382 = false;
        }
        end_1.smooth_0 = _S382;
        bool _S383;
        if(!_S378.hole_4)
        {
            _S383 = _S379 <= 0.0f;
        }
        else
        {
            _S383 = false;
        }
        bool _S384;
        if(_S383)
        {
            _S384 = true;
        }
        else
        {
            _S384 = (end_1.height_7) <= _S376;
        }
        if(_S384)
        {
            break;
        }
        float _S385 = way_back_to_dip_0(end_1.previous_4, _S379, _S380, end_1.last_step_3, _S378);
        if(_S385 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S385;
            end_1.last_step_3 = end_1.last_step_3 - _S385;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S386 = min(StepControl_to_cell_exit_0(_S374, _S378.side_x_0, _S378.side_y_0), end_1.height_7 - _S378.cell_max_0);
        float _S387 = StepControl_to_next_sample_0(_S374, _S378, _S379, _S380);
        end_1.previous_4 = after_sample_0(_S379, _S380, _S378, _S386 > _S387);
        float _S388 = max(_S386, _S387);
        end_1.last_step_3 = _S388;
        end_1.height_7 = end_1.height_7 - _S388;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S389, ViewRay_0 _S390, StepControl_0 _S391, bool _S392, ViewRayEnd_0 _S393, uint _S394)
{
    float _S395 = fabrics_0[_S389].height_high_0 - fabrics_0[_S389].height_low_0;
    float above_2 = _S393.height_7 + _S393.last_step_3;
    float above_gap_1 = clamp(_S393.previous_4.clearance_0, 0.0f, _S395);
    float under_gap_1 = clamp(_S393.depth_1, 0.0f, _S395);
    float _S396 = cubic_root_0(above_gap_1, - under_gap_1, _S393.previous_4.rate_0 * _S393.last_step_3, _S393.rate_4 * _S393.last_step_3);
    float middle_0;
    if(_S393.smooth_0)
    {
        middle_0 = above_2 - _S396 * _S393.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S393.height_7, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S393.height_7;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S394)
        {
        }
        else
        {
            break;
        }
        float2 _S397 = ViewRay_at_0(_S390, middle_0);
        Probe_0 _S398 = probe_0(_S389, _S397.x, _S397.y, _S392, _S391.right_0, _S391.up_0);
        float _S399;
        if(_S398.hole_4)
        {
            _S399 = -1.0e+09f;
        }
        else
        {
            _S399 = _S398.height_3;
        }
        float _S400 = clamp(middle_0 - _S399, - _S395, _S395);
        float _S401;
        if(_S400 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S401 = 0.5f * above_gap_2;
            }
            else
            {
                _S401 = above_gap_2;
            }
            float _S402 = - _S400;
            under_1 = middle_0;
            above_gap_2 = _S401;
            under_gap_2 = _S402;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S401 = 0.5f * under_gap_2;
            }
            else
            {
                _S401 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S400;
            under_gap_2 = _S401;
            side_1 = -1.0f;
        }
        if(_S393.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S400 / min(ViewRay_rate_0(_S390, _S398), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S393.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S403, SearchQuality_0 _S404, float _S405, float _S406, float3 _S407, bool _S408)
{
    float _S409 = max(_S407.z, 0.00009999999747379f);
    ViewRay_0 ray_0;
    ray_0.origin_0 = float2(_S405, _S406);
    float2 _S410 = _S407.xy / _S409;
    ray_0.slope_1 = _S410;
    StepControl_0 _S411 = step_control_0(- _S410, 1.0f / max(steps_per_length_0(_S403, _S404, _S407) / _S409, 9.99999971718068537e-10f));
    ViewRayEnd_0 _S412 = search_down_0(_S403, ray_0, _S411, _S408);
    Hit_0 hit_0;
    hit_0.hole_5 = false;
    float _S413 = refined_height_0(_S403, ray_0, _S411, _S408, _S412, _S404.refinements_0);
    hit_0.height_5 = _S413;
    float2 _S414 = ViewRay_at_0(ray_0, _S413);
    hit_0.x_10 = _S414.x;
    hit_0.y_5 = _S414.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S415, SearchQuality_0 _S416, float _S417, float _S418, float3 _S419, bool _S420)
{
    if(!passes_through_0(_S415, _S416, _S417, _S418, _S419, _S420))
    {
        return first_hit_of_yarn_0(_S415, _S416, _S417, _S418, _S419, _S420);
    }
    Hit_0 hit_1;
    hit_1.x_10 = _S417;
    hit_1.y_5 = _S418;
    hit_1.height_5 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S421, float _S422, float _S423, bool _S424)
{
    Sample_0 _S425 = sample_at_0(_S421, _S422, _S423, _S424);
    float _S426;
    if(_S425.shown_3.is_warp_2)
    {
        _S426 = _S425.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S426 = _S425.crossing_2.weft_2.half_width_1;
    }
    uint _S427;
    if(_S425.shown_3.is_warp_2)
    {
        _S427 = fabrics_0[_S421].warp_0;
    }
    else
    {
        _S427 = fabrics_0[_S421].weft_0;
    }
    Family_0 _S428 = families_0.Load(_S427);
    float _S429;
    if(_S424)
    {
        _S429 = -1.0f;
    }
    else
    {
        _S429 = 1.0f;
    }
    float _S430 = _S428.twist_sine_0 * _S429;
    Family_0 _S431 = families_0.Load(_S427);
    if(_S425.shown_3.is_warp_2)
    {
        _S429 = 1.0f;
    }
    else
    {
        _S429 = -1.0f;
    }
    float2 _S432 = fibre_direction_0(_S425.slope_across_0, _S429 * _S425.slope_along_0, _S430, _S431.twist_cosine_0);
    float _S433;
    if(_S425.shown_3.is_warp_2)
    {
        _S433 = _S425.slope_x_1;
    }
    else
    {
        _S433 = _S425.slope_y_1;
    }
    float _S434;
    if(_S425.shown_3.is_warp_2)
    {
        _S434 = _S425.slope_y_1;
    }
    else
    {
        _S434 = _S425.slope_x_1;
    }
    float _S435 = _S432.x;
    float _S436 = _S432.y;
    float _S437 = _S433 * _S435 + _S429 * _S434 * _S436;
    float _S438 = _S426 * 1.0154266357421875f;
    float _S439 = _S438 * arc_sine_0(clamp(_S425.section_1.across_3 / _S438, -1.0f, 1.0f));
    if(_S425.shown_3.is_warp_2)
    {
        _S426 = _S423;
    }
    else
    {
        _S426 = - _S422;
    }
    SurfacePoint_0 point_0;
    point_0.hole_0 = _S425.shown_3.hole_3;
    point_0.is_warp_0 = _S425.shown_3.is_warp_2;
    point_0.warp_thread_0 = _S425.crossing_2.warp_2.thread_0;
    point_0.weft_thread_0 = _S425.crossing_2.weft_2.thread_0;
    point_0.height_1 = _S425.height_6;
    point_0.normal_0 = normalize(float3(- _S425.slope_x_1, - _S425.slope_y_1, 1.0f));
    float3 _S440;
    if(_S425.shown_3.is_warp_2)
    {
        _S440 = float3(_S435, _S436, _S437);
    }
    else
    {
        _S440 = float3(- _S436, _S435, _S437);
    }
    point_0.tangent_0 = normalize(_S440);
    point_0.across_0 = _S425.section_1.across_3;
    point_0.fibre_across_0 = _S439 * _S431.twist_cosine_0 + _S426 * _S430;
    point_0.fibre_along_0 = _S426 * _S431.twist_cosine_0 - _S439 * _S430;
    return point_0;
}

struct YarnPoint_0
{
    bool back_6;
    bool hole_6;
    bool is_warp_3;
    float x_11;
    float y_6;
    float height_10;
    float3 normal_6;
    float3 tangent_7;
    float roughness_10;
    Albedos_0 albedos_6;
};

Albedos_0 vary_albedos_0(uint _S441, Albedos_0 _S442, uint _S443, uint _S444)
{
    float3 _S445 = max(_S442.specular_reflect_0, _S442.specular_transmit_0);
    float3 _S446 = _S442.diffuse_reflect_0 + _S442.diffuse_transmit_0;
    float _S447 = bounded_gain_0(thread_gain_0(_S443, fabrics_0[_S441].colour_noise_0, fabrics_0[_S441].seed_0), _S446, 1.0f - fabrics_0[_S441].layer_bound_0 * _S445);
    float _S448 = bounded_gain_0(fibre_gain_0(_S443, _S444, fabrics_0[_S441].fibre_noise_0, fabrics_0[_S441].seed_0), _S445, min((1.0f - _S447 * _S446) / fabrics_0[_S441].layer_bound_0, (float3)1.0f));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S447 * _S442.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S447 * _S442.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S448 * _S442.specular_reflect_0;
    varied_0.specular_transmit_0 = _S448 * _S442.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S449, SurfacePoint_0 _S450, Albedos_0 _S451, float _S452, float _S453)
{
    float _S454;
    if(_S450.is_warp_0)
    {
        _S454 = _S452;
    }
    else
    {
        _S454 = _S453;
    }
    float _S455 = _S454 - _S450.across_0;
    uint _S456;
    if(_S450.is_warp_0)
    {
        _S456 = fabrics_0[_S449].warp_0;
    }
    else
    {
        _S456 = fabrics_0[_S449].weft_0;
    }
    Family_0 _S457 = families_0.Load(_S456);
    int _S458 = int(families_0.Load(_S456).count_0);
    if(_S450.is_warp_0)
    {
        _S456 = _S450.warp_thread_0;
    }
    else
    {
        _S456 = _S450.weft_thread_0;
    }
    uint _S459 = uint(int(floor(_S455 / _S457.period_0)) * _S458 + int(_S456)) * 2U;
    if(_S450.is_warp_0)
    {
        _S456 = 1U;
    }
    else
    {
        _S456 = 0U;
    }
    float _S460 = floor(_S450.fibre_across_0 / fabrics_0[_S449].fibre_size_0);
    return vary_albedos_0(_S449, _S451, _S459 + _S456, uint(int(_S460)) * 65536U + uint(int(floor(_S450.fibre_along_0 / (fabrics_0[_S449].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S460))));
}

YarnPoint_0 yarn_point_of_0(uint _S461, SurfacePoint_0 _S462, float _S463, float _S464, bool _S465, bool _S466)
{
    uint _S467;
    if(_S462.is_warp_0)
    {
        _S467 = fabrics_0[_S461].warp_0;
    }
    else
    {
        _S467 = fabrics_0[_S461].weft_0;
    }
    uint _S468;
    if(_S462.is_warp_0)
    {
        _S468 = _S462.warp_thread_0;
    }
    else
    {
        _S468 = _S462.weft_thread_0;
    }
    Albedos_0 albedos_7 = albedos_of_0(_S467, _S468);
    bool _S469;
    if((fabrics_0[_S461].fibre_noise_0) > 0.0f)
    {
        _S469 = true;
    }
    else
    {
        _S469 = (fabrics_0[_S461].colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_8;
    if(_S469)
    {
        albedos_8 = varied_at_0(_S461, _S462, albedos_7, _S463, _S464);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    YarnPoint_0 point_1;
    point_1.back_6 = _S465;
    point_1.hole_6 = _S466;
    point_1.is_warp_3 = _S462.is_warp_0;
    point_1.x_11 = _S463;
    point_1.y_6 = _S464;
    point_1.height_10 = _S462.height_1;
    point_1.normal_6 = _S462.normal_0;
    point_1.tangent_7 = _S462.tangent_0;
    point_1.roughness_10 = families_0.Load(_S467).roughness_0;
    point_1.albedos_6 = albedos_8;
    return point_1;
}

bool unoccluded_0(uint _S470, SearchQuality_0 _S471, float _S472, float _S473, float _S474, float3 _S475, bool _S476)
{
    if((_S475.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S470, _S471, float3(_S472, _S473, _S474 + fabrics_0[_S470].lift_0), _S475, _S476, max_height_along_0(_S470, _S472, _S473, _S474, _S475, _S476));
}

bool is_lit_0(uint _S477, SearchQuality_0 _S478, YarnPoint_0 _S479, float3 _S480)
{
    if(_S479.hole_6)
    {
        return true;
    }
    float3 _S481 = to_face_frame_0(_S480, _S479.back_6);
    float _S482 = _S481.z;
    bool _S483 = _S482 < 0.0f;
    float3 normal_7;
    float height_11;
    if(_S483)
    {
        SurfacePoint_0 _S484 = surface_at_0(_S477, _S479.x_11, _S479.y_6, !_S479.back_6);
        normal_7 = _S484.normal_0;
        height_11 = _S484.height_1;
    }
    else
    {
        normal_7 = _S479.normal_6;
        height_11 = _S479.height_10;
    }
    float3 _S485 = float3(_S481.xy, abs(_S482));
    if((dot(normal_7, _S485)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S477, _S478, _S479.x_11, _S479.y_6, height_11, _S485, (_S479.back_6) != _S483);
}

Components_0 components_of_point_0(uint _S486, SearchQuality_0 _S487, YarnPoint_0 _S488, float3 _S489, float3 _S490)
{
    Components_0 result_3 = no_components_0();
    float _S491;
    if(_S488.hole_6)
    {
        _S491 = 1.0f;
    }
    else
    {
        _S491 = 0.0f;
    }
    result_3.hole_2 = _S491;
    bool _S492;
    if(_S488.hole_6)
    {
        _S492 = true;
    }
    else
    {
        _S492 = !is_lit_0(_S486, _S487, _S488, _S489);
    }
    if(_S492)
    {
        return result_3;
    }
    float3 _S493 = to_face_frame_0(_S489, _S488.back_6);
    float3 _S494 = to_face_frame_0(_S490, _S488.back_6);
    bool _S495 = (_S493.z) < 0.0f;
    float3 _S496;
    if(_S495)
    {
        _S496 = - _S493;
    }
    else
    {
        _S496 = _S493;
    }
    float _S497 = diffuse_reflection_0(_S496, _S488.normal_6, fabrics_0[_S486].diffuse_blend_0);
    if(_S495)
    {
        _S491 = transmission_1(_S493, _S494, _S488.normal_6, _S488.tangent_7, _S488.roughness_10, fabrics_0[_S486].optical_depth_0);
    }
    else
    {
        _S491 = reflection_0(_S493, _S494, _S488.normal_6, _S488.tangent_7, _S488.roughness_10, fabrics_0[_S486].optical_depth_0);
    }
    float _S498;
    if(_S488.is_warp_3)
    {
        _S498 = _S497;
    }
    else
    {
        _S498 = 0.0f;
    }
    result_3.diffuse_warp_0 = _S498;
    if(_S488.is_warp_3)
    {
        _S498 = 0.0f;
    }
    else
    {
        _S498 = _S497;
    }
    result_3.diffuse_weft_0 = _S498;
    if(_S488.is_warp_3)
    {
        _S498 = _S491;
    }
    else
    {
        _S498 = 0.0f;
    }
    result_3.specular_warp_0 = _S498;
    if(_S488.is_warp_3)
    {
        _S491 = 0.0f;
    }
    result_3.specular_weft_0 = _S491;
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

float openness_number_0(uint _S499, uint _S500)
{
    return table_number_0(fabrics_0[_S499].openness_0 + _S500);
}

Blocked_0 blocked_of_terms_0(uint _S501, uint _S502, float  _S503[int(6)], uint _S504)
{
    float  shares_0[int(3)];
    uint share_2 = 0U;
    for(;;)
    {
        if(share_2 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_2] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S504)
            {
            }
            else
            {
                break;
            }
            shares_0[share_2] = shares_0[share_2] + openness_number_0(_S501, _S502 + share_2 * _S504 + term_0) * _S503[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_2] = saturate(shares_0[share_2]);
        share_2 = share_2 + 1U;
    }
    Blocked_0 blocked_2;
    blocked_2.by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    blocked_2.by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    blocked_2.far_0 = shares_0[int(1)];
    return blocked_2;
}

Blocked_0 blocked_at_0(uint _S505, bool _S506, bool _S507, float _S508, float _S509)
{
    float _S510 = _S509 * openness_number_0(_S505, 158U);
    float  terms_1[int(6)] = { 1.0f, _S508, _S510, _S508 * _S508, _S508 * _S510, _S510 * _S510 };
    uint _S511;
    if(_S507)
    {
        _S511 = 2U;
    }
    else
    {
        _S511 = 0U;
    }
    uint _S512;
    if(_S506)
    {
        _S512 = 0U;
    }
    else
    {
        _S512 = 1U;
    }
    return blocked_of_terms_0(_S505, 60U + (_S511 + _S512) * 18U, terms_1, 6U);
}

Blocked_0 with_blocked_0(uint _S513, Blocked_0 _S514, YarnPoint_0 _S515, bool _S516, float _S517)
{
    bool _S518;
    if(_S515.hole_6)
    {
        _S518 = true;
    }
    else
    {
        _S518 = (_S515.is_warp_3) != _S516;
    }
    if(_S518)
    {
        return _S514;
    }
    Blocked_0 _S519 = blocked_at_0(_S513, _S516, _S515.back_6, _S515.normal_6.z, _S515.height_10);
    Blocked_0 result_4;
    result_4.by_warp_0 = _S514.by_warp_0 + _S517 * _S519.by_warp_0;
    result_4.by_weft_0 = _S514.by_weft_0 + _S517 * _S519.by_weft_0;
    result_4.far_0 = _S514.far_0 + _S517 * _S519.far_0;
    return result_4;
}

struct CoverageTaps_0
{
    uint  nodes_1[int(9)];
};

float3 pyramid_level_0(uint _S520, float _S521)
{
    uint _S522 = fabrics_0[_S520].lobes_0.levels_0 + 4U * uint(min(_S521, fabrics_0[_S520].lobes_0.last_level_0));
    return float3(table_number_0(_S522), table_number_0(_S522 + 1U), table_number_0(_S522 + 2U));
}

CoverageTaps_0 coverage_taps_0(uint _S523, Footprint_0 _S524, bool _S525)
{
    Lobes_0 _S526 = fabrics_0[_S523].lobes_0;
    float _S527 = Footprint_spread_side_0(_S524) * fabrics_0[_S523].lobes_0.inverse_base_size_0;
    float3 _S528 = pyramid_level_0(_S523, floor(binary_logarithm_0(max(0.68000000715255737f * _S527, 1.0f))));
    float _S529 = 1.0f / max(_S527, 9.99999997475242708e-07f);
    float _S530 = min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S529 * _S529), 0.0f, 1.0f)), 0.3333333432674408f * _S529), 1.0f);
    float2 _S531 = float2(families_0.Load(fabrics_0[_S523].warp_0).inverse_period_0, families_0.Load(fabrics_0[_S523].weft_0).inverse_period_0);
    float2 _S532 = _S524.centre_0 * _S531;
    float2 _S533 = _S524.dx_0 * _S531 * _S530;
    float2 _S534 = _S524.dy_0 * _S531 * _S530;
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
        float2 _S535 = _S532 + TAP_OFFSETS_0[number_1].x * _S533 + TAP_OFFSETS_0[number_1].y * _S534;
        float _S536 = _S528.y;
        float _S537 = wrapped_cell_0(_S535.x, _S536);
        float _S538 = wrapped_cell_0(_S535.y, _S528.z);
        uint _S539;
        if(_S525)
        {
            _S539 = _S526.face_nodes_0;
        }
        else
        {
            _S539 = 0U;
        }
        taps_3.nodes_1[number_1] = _S539 + uint(_S538 * _S536 + _S537 + _S528.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

float4 coverage_of_pack_0(uint _S540, CoverageTaps_0 _S541, uint _S542)
{
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
        uint _S543 = words_0.Load(fabrics_0[_S540].lobes_0.coverage_0 + _S541.nodes_1[number_2] * fabrics_0[_S540].lobes_0.packs_0 + _S542);
        uint even_2 = even_1 + (_S543 & 16711935U);
        uint odd_2 = odd_1 + ((_S543 >> int(8)) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / 9.0f;
}

float coverage_of_holes_0(uint _S544, CoverageTaps_0 _S545)
{
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
        uint total_1 = total_0 + ((words_0.Load(fabrics_0[_S544].lobes_0.coverage_holes_0 + _S545.nodes_1[number_3] / 4U) >> (8U * (_S545.nodes_1[number_3] % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S546, CoverageTaps_0 _S547, NodeTaps_0 _S548, bool _S549)
{
    Lobes_0 _S550 = fabrics_0[_S546].lobes_0;
    float _S551 = interpolate_table_0(_S548, fabrics_0[_S546].lobes_0.projected_area_0 + fabrics_0[_S546].lobes_0.packs_0, fabrics_0[_S546].lobes_0.packs_0 + 1U).x;
    float _S552;
    if(_S549)
    {
        _S552 = _S550.back_hole_weight_0;
    }
    else
    {
        _S552 = _S550.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S546, _S547) * _S551 * _S551 * _S552, 1.0f);
}

Components_0 prefiltered_components_0(uint _S553, Footprint_0 _S554, float3 _S555, float3 _S556, bool _S557)
{
    CoverageTaps_0 _S558 = coverage_taps_0(_S553, _S554, _S557);
    NodeTaps_0 _S559 = node_taps_0(_S556);
    NodeTaps_0 view_nodes_0 = _S559;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S555);
    NodeTaps_0 seen_nodes_0 = _S559;
    uint _S560;
    if(_S557)
    {
        _S560 = 1U;
    }
    else
    {
        _S560 = 0U;
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + _S560 * 256U;
    uint _S561 = 2U * _S560;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + _S561 * 256U;
    uint _S562;
    if((_S555.z) < 0.0f)
    {
        _S562 = 1U;
    }
    else
    {
        _S562 = 0U;
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + (_S561 + _S562) * 256U;
    float3 _S563 = half_vector_0(_S555, _S556);
    float3 _S564 = shadow_correlation_0(_S555, _S556);
    if(_S557)
    {
        _S562 = fabrics_0[_S553].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S562 = fabrics_0[_S553].lobes_0.front_warp_packs_0;
    }
    Components_0 sums_1;
    sums_1.diffuse_warp_0 = 0.0f;
    sums_1.diffuse_weft_0 = 0.0f;
    sums_1.specular_warp_0 = 0.0f;
    sums_1.specular_weft_0 = 0.0f;
    sums_1.light_visibility_1 = 0.0f;
    uint pack_0 = 0U;
    float total_2 = 0.0f;
    for(;;)
    {
        Lobes_0 _S565 = fabrics_0[_S553].lobes_0;
        if(pack_0 < (fabrics_0[_S553].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        float4 _S566 = coverage_of_pack_0(_S553, _S558, pack_0);
        float4 _S567 = interpolate_table_0(view_nodes_0, _S565.projected_area_0 + pack_0, _S565.packs_0 + 1U);
        uint _S568 = _S565.light_visibility_0 + pack_0;
        float4 _S569 = interpolate_table_0(seen_nodes_0, _S568, _S565.packs_0) / 255.0f;
        float4 _S570 = interpolate_table_0(light_nodes_0, _S568, _S565.packs_0) / 255.0f;
        float4 _S571 = interpolate_table_0(light_nodes_0, _S565.irradiance_0 + pack_0, _S565.packs_0) * 0.00124827399849892f;
        bool _S572 = pack_0 < _S562;
        uint _S573;
        if(_S572)
        {
            _S573 = fabrics_0[_S553].warp_0;
        }
        else
        {
            _S573 = fabrics_0[_S553].weft_0;
        }
        Family_0 _S574 = families_0.Load(_S573);
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
            Group_0 _S575 = group_at_0(_S565.moments_0 + 12U * (4U * (_S560 * _S565.packs_0 + pack_0) + number_4), _S574.roughness_0);
            float _S576 = _S566[number_4] * _S567[number_4] * _S567[number_4] * _S575.weight_2;
            float2 _S577 = visibility_gain_0(_S564, _S570[number_4], _S569[number_4]);
            float _S578 = _S577.x;
            float diffuse_1 = diffuse_0 + _S576 * _S571[number_4] * _S578;
            float specular_1 = specular_0 + _S576 * layer_value_0(_S575, _S563, _S555, _S556, fabrics_0[_S553].optical_depth_0) * _S570[number_4] * _S577.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S576 * _S570[number_4] * _S578;
            float total_3 = total_2 + _S576;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S579;
        if(_S572)
        {
            _S579 = diffuse_0;
        }
        else
        {
            _S579 = 0.0f;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S579;
        float _S580;
        if(_S572)
        {
            _S580 = 0.0f;
        }
        else
        {
            _S580 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S580;
        float _S581;
        if(_S572)
        {
            _S581 = specular_0;
        }
        else
        {
            _S581 = 0.0f;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S581;
        float _S582;
        if(_S572)
        {
            _S582 = 0.0f;
        }
        else
        {
            _S582 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S582;
        pack_0 = pack_0 + 1U;
    }
    float _S583 = prefiltered_hole_0(_S553, _S558, view_nodes_0, _S557);
    sums_1.hole_2 = _S583;
    float _S584 = (1.0f - _S583) / max(total_2, 9.999999960041972e-13f);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S584;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S584;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S584;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S584;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S584;
    return sums_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S585, Footprint_0 _S586, bool _S587)
{
    float2 _S588 = _S586.dx_0;
    float2 _S589 = _S586.dy_0;
    float2 _S590 = sqrt(_S588 * _S588 + _S589 * _S589);
    Stretch_0 _S591 = stretch_of_0(fabrics_0[_S585].warp_0, _S586.centre_0.x, _S590.x);
    Stretch_0 _S592 = stretch_of_0(fabrics_0[_S585].weft_0, _S586.centre_0.y, _S590.y);
    FamilyAlbedos_0 albedos_9;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S585].warp_0, fabrics_0[_S585].weft_0, _S591, _S592, _S587);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S585].weft_0, fabrics_0[_S585].warp_0, _S592, _S591, _S587);
    return albedos_9;
}

Estimate_0 lobes_estimate_of_pass_0(uint _S593, Footprint_0 _S594, float _S595, float2 _S596, float3 _S597, float3 _S598)
{
    float _S599;
    Regime_0 _S600 = regime_of_0(_S593, _S594, _S595);
    bool _S601 = (_S598.z) < 0.0f;
    float3 _S602 = to_face_frame_0(_S598, _S601);
    bool _S603;
    if((fabrics_0[_S593].fibre_noise_0) > 0.0f)
    {
        _S603 = true;
    }
    else
    {
        _S603 = (fabrics_0[_S593].colour_noise_0) > 0.0f;
    }
    bool _S604;
    if((families_0.Load(fabrics_0[_S593].warp_0).quantities_0) > 1U)
    {
        _S604 = true;
    }
    else
    {
        _S604 = (families_0.Load(fabrics_0[_S593].weft_0).quantities_0) > 1U;
    }
    float _S605 = 1.0f - _S600.prefiltered_0;
    if(_S605 > 0.0f)
    {
        if(_S603)
        {
            _S604 = true;
        }
    }
    else
    {
        _S604 = false;
    }
    Footprint_0 box_0 = _S594;
    float3 _S606 = (float3)0.0f;
    SurfacePoint_0 _S607 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S606, _S606, 0.0f, 0.0f, 0.0f);
    Components_0 _S608 = no_components_0();
    CloseUp_0 close_1 = no_close_up_0();
    int _S609;
    if(_S604)
    {
        _S609 = int(0);
    }
    else
    {
        _S609 = int(1);
    }
    uint _S610 = uint(_S609);
    Components_0 points_1 = _S608;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S607;
    float2 central_place_0 = _S594.centre_0;
    uint number_5 = _S610;
    for(;;)
    {
        float _S611 = float(number_5);
        _S599 = _S600.points_0;
        if(_S611 < (_S600.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S612 = number_5 == 0U;
        uint _S613;
        if(_S612)
        {
            _S613 = 0U;
        }
        else
        {
            _S613 = number_5 - 1U;
        }
        float2 _S614 = POINT_OFFSETS_0[_S613] + _S596;
        float2 _S615;
        if(_S612)
        {
            _S615 = (float2)0.0f;
        }
        else
        {
            _S615 = _S614 - round(_S614);
        }
        float2 _S616 = _S594.centre_0 + _S615.x * _S594.dx_0 + _S615.y * _S594.dy_0;
        float _S617;
        if(_S612)
        {
            _S617 = 0.0f;
        }
        else
        {
            _S617 = _S600.threads_1;
        }
        SearchQuality_0 _S618 = quality_of_0(_S617);
        Hit_0 _S619 = first_hit_0(_S593, _S618, _S616.x, _S616.y, _S602, _S601);
        SurfacePoint_0 _S620 = surface_at_0(_S593, _S619.x_10, _S619.y_5, _S601);
        if(_S612)
        {
            float central_weight_1;
            if(_S619.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S605;
            }
            float2 central_place_1 = float2(_S619.x_10, _S619.y_5);
            box_0.centre_0 = lerp(_S594.centre_0, central_place_1, (float2)central_weight_1);
            central_weight_0 = central_weight_1;
            central_0 = _S620;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        YarnPoint_0 _S621 = yarn_point_of_0(_S593, _S620, _S619.x_10, _S619.y_5, _S601, _S619.hole_5);
        float _S622 = min(_S600.points_0 - float(number_5 - 1U), 1.0f);
        Components_0 _S623 = with_added_0(points_1, components_of_point_0(_S593, _S618, _S621, _S597, _S598), _S622);
        if((fabrics_0[_S593].openness_0) != 4294967295U)
        {
            close_1.warp_1 = with_blocked_0(_S593, close_1.warp_1, _S621, true, _S622);
            close_1.weft_1 = with_blocked_0(_S593, close_1.weft_1, _S621, false, _S622);
        }
        points_1 = _S623;
        number_5 = number_5 + 1U;
    }
    close_1.weight_0 = _S605;
    float _S624 = max(_S599, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S624);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S624);
    Estimate_0 estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S608, points_1, _S605 / _S624);
    if((_S600.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S593, _S594, to_face_frame_0(_S597, _S601), _S602, _S601), _S600.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S593, box_0, _S601);
    if(_S603)
    {
        _S603 = central_weight_0 > 0.0f;
    }
    else
    {
        _S603 = false;
    }
    if(_S603)
    {
        SurfacePoint_0 _S625 = central_0;
        Albedos_0 _S626;
        if(central_0.is_warp_0)
        {
            _S626 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S626 = estimate_0.albedos_5.weft_5;
        }
        Albedos_0 _S627 = lerp_albedos_0(_S626, varied_at_0(_S593, central_0, _S626, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S625.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S627;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S627;
        }
    }
    return estimate_0;
}

Estimate_0 lobes_estimate_0(uint _S628, Footprint_0 _S629, float _S630, float3 _S631, float3 _S632)
{
    return lobes_estimate_of_pass_0(_S628, _S629, _S630, (float2)0.0f, _S631, _S632);
}

Scattered_0 scattered_by_0(uint _S633, Albedos_0 _S634, uint _S635, float3 _S636)
{
    uint _S637 = 159U + 2U * _S635;
    Scattered_0 yarn_3;
    yarn_3.back_5 = _S636 * _S634.diffuse_reflect_0 + openness_number_0(_S633, _S637) * _S634.specular_reflect_0;
    yarn_3.through_0 = _S636 * _S634.diffuse_transmit_0 + openness_number_0(_S633, _S637 + 1U) * _S634.specular_transmit_0;
    return yarn_3;
}

void sent_0(uint _S638, uint _S639, float3 _S640, float3 _S641, float3 _S642, float3 _S643, out float3 _S644, out float3 _S645)
{
    uint _S646 = 146U + 4U * _S639;
    float _S647 = openness_number_0(_S638, _S646 + 1U);
    float _S648 = openness_number_0(_S638, _S646 + 2U);
    float3 _S649 = 1.0f - _S642 * openness_number_0(_S638, _S646);
    float3 _S650 = 1.0f - _S643 * openness_number_0(_S638, _S646 + 3U);
    float3 _S651 = 1.0f / (_S649 * _S650 - _S642 * _S643 * (_S647 * _S648));
    _S644 = (_S640 * _S650 + _S642 * _S647 * _S641) * _S651;
    _S645 = (_S641 * _S649 + _S643 * _S648 * _S640) * _S651;
    return;
}

FaceSends_0 face_sends_0(uint _S652, uint _S653, Scattered_0 _S654, Scattered_0 _S655)
{
    uint _S656 = 2U * _S653;
    uint _S657 = 142U + _S656;
    float _S658 = openness_number_0(_S652, _S657);
    float _S659 = openness_number_0(_S652, _S657 + 1U);
    float3 _S660 = (1.0f - _S658) * _S654.back_5;
    float3 _S661 = (1.0f - _S659) * _S655.back_5;
    FaceSends_0 sends_1;
    uint _S662 = 154U + _S656;
    float _S663 = openness_number_0(_S652, _S662);
    sends_1.blocks_warp_0 = _S663;
    float _S664 = openness_number_0(_S652, _S662 + 1U);
    sends_1.blocks_weft_0 = _S664;
    sends_1.open_0 = _S663 * _S658 + _S664 * _S659;
    sent_0(_S652, _S653, _S658 * _S654.back_5, _S659 * _S655.back_5, _S660, _S661, sends_1.sky_warp_0, sends_1.sky_weft_0);
    sent_0(_S652, _S653, _S654.through_0, _S655.through_0, _S660, _S661, sends_1.crossing_warp_0, sends_1.crossing_weft_0);
    return sends_1;
}

Interior_0 interior_of_0(uint _S665, float3 _S666, bool _S667)
{
    Scattered_0 _S668 = scattered_by_0(_S665, table_albedos_0(families_0.Load(fabrics_0[_S665].warp_0).colour_mean_0), 0U, _S666);
    Scattered_0 _S669 = scattered_by_0(_S665, table_albedos_0(families_0.Load(fabrics_0[_S665].weft_0).colour_mean_0), 1U, _S666);
    uint _S670;
    if(_S667)
    {
        _S670 = 1U;
    }
    else
    {
        _S670 = 0U;
    }
    FaceSends_0 _S671 = face_sends_0(_S665, _S670, _S668, _S669);
    if(_S667)
    {
        _S670 = 0U;
    }
    else
    {
        _S670 = 1U;
    }
    FaceSends_0 _S672 = face_sends_0(_S665, _S670, _S668, _S669);
    float3 _S673 = _S671.blocks_warp_0 * _S671.crossing_warp_0 + _S671.blocks_weft_0 * _S671.crossing_weft_0;
    float3 _S674 = _S672.blocks_warp_0 * _S672.crossing_warp_0 + _S672.blocks_weft_0 * _S672.crossing_weft_0;
    float _S675 = 1.0f - _S671.open_0;
    float _S676 = 1.0f - _S672.open_0;
    float3 _S677 = 1.0f / (1.0f - _S673 * _S674 * (_S675 * _S676));
    float3 _S678 = _S674 * (_S671.open_0 + _S675 * (_S671.blocks_warp_0 * _S671.sky_warp_0 + _S671.blocks_weft_0 * _S671.sky_weft_0)) * _S677;
    float3 _S679 = _S673 * (_S672.open_0 + _S676 * (_S672.blocks_warp_0 * _S672.sky_warp_0 + _S672.blocks_weft_0 * _S672.sky_weft_0)) * _S677;
    FaceRadiance_0 _S680 = face_radiance_0(_S671, _S672.open_0, _S678, _S679);
    FaceRadiance_0 _S681 = face_radiance_0(_S672, _S671.open_0, _S679, _S678);
    Interior_0 interior_1;
    interior_1.warp_4 = _S680.warp_3;
    interior_1.weft_4 = _S680.weft_3;
    interior_1.leaked_1 = _S680.leaked_0;
    interior_1.far_1 = _S681.mean_0;
    interior_1.far_leaked_0 = _S681.leaked_0;
    return interior_1;
}

Blocked_0 blocked_from_0(uint _S682, float3 _S683, bool _S684, bool _S685)
{
    float  terms_2[int(6)];
    view_terms_0(_S683, terms_2);
    uint _S686;
    if(_S685)
    {
        _S686 = 2U;
    }
    else
    {
        _S686 = 0U;
    }
    uint _S687;
    if(_S684)
    {
        _S687 = 0U;
    }
    else
    {
        _S687 = 1U;
    }
    return blocked_of_terms_0(_S682, (_S686 + _S687) * 15U, terms_2, 5U);
}

float warp_seen_from_0(uint _S688, float3 _S689, bool _S690)
{
    float  terms_3[int(6)];
    view_terms_0(_S689, terms_3);
    uint term_1 = 0U;
    float share_3 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S691;
        if(_S690)
        {
            _S691 = 5U;
        }
        else
        {
            _S691 = 0U;
        }
        float share_4 = share_3 + openness_number_0(_S688, 132U + _S691 + term_1) * terms_3[term_1];
        term_1 = term_1 + 1U;
        share_3 = share_4;
    }
    return saturate(share_3);
}

Bounced_0 bounced_of_families_0(uint _S692, FamilyAlbedos_0 _S693, float3 _S694, Interior_0 _S695, Blocked_0 _S696, Blocked_0 _S697)
{
    return sum_of_0(bounced_by_0(_S696, scattered_by_0(_S692, _S693.warp_5, 0U, _S694), _S695), bounced_by_0(_S697, scattered_by_0(_S692, _S693.weft_5, 1U, _S694), _S695));
}

Bounced_0 bounced_far_0(uint _S698, FamilyAlbedos_0 _S699, float3 _S700, Interior_0 _S701, float3 _S702, bool _S703, float _S704, float _S705, float _S706)
{
    Blocked_0 _S707 = blocked_from_0(_S698, _S702, true, _S703);
    Blocked_0 _S708 = blocked_from_0(_S698, _S702, false, _S703);
    float _S709 = _S704 / max(1.0f - _S707.by_warp_0 - _S707.by_weft_0, 0.10000000149011612f);
    float _S710 = (0.0020000000949949f * warp_seen_from_0(_S698, _S702, _S703) + _S709) / (_S709 + _S705 / max(1.0f - _S708.by_warp_0 - _S708.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    float _S711 = 1.0f - _S706;
    return bounced_of_families_0(_S698, _S699, _S700, _S701, scaled_0(_S707, _S710 * _S711), scaled_0(_S708, (1.0f - _S710) * _S711));
}

Bounced_0 bounced_over_0(uint _S712, Components_0 _S713, CloseUp_0 _S714, FamilyAlbedos_0 _S715, float3 _S716, float3 _S717)
{
    bool _S718 = (_S717.z) < 0.0f;
    Interior_0 _S719 = interior_of_0(_S712, _S716, _S718);
    Bounced_0 bounced_2 = bounced_far_0(_S712, _S715, _S716, _S719, to_face_frame_0(_S717, _S718), _S718, _S713.diffuse_warp_0, _S713.diffuse_weft_0, _S713.hole_2);
    if((_S714.weight_0) > 0.0f)
    {
        Bounced_0 _S720 = bounced_of_families_0(_S712, _S715, _S716, _S719, _S714.warp_1, _S714.weft_1);
        float3 _S721 = (float3)_S714.weight_0;
        bounced_2.reflected_0 = lerp(bounced_2.reflected_0, _S720.reflected_0, _S721);
        bounced_2.transmitted_0 = lerp(bounced_2.transmitted_0, _S720.transmitted_0, _S721);
    }
    return bounced_2;
}

float3 composed_0(uint _S722, Components_0 _S723, CloseUp_0 _S724, FamilyAlbedos_0 _S725, float3 _S726, float3 _S727, float3 _S728)
{
    Albedos_0 _S729 = tinted_0(_S725.warp_5, _S726);
    Albedos_0 _S730 = tinted_0(_S725.weft_5, _S726);
    float3 _S731 = _S729.diffuse_reflect_0 * _S723.diffuse_warp_0 + _S730.diffuse_reflect_0 * _S723.diffuse_weft_0 + _S729.specular_reflect_0 * _S723.specular_warp_0 + _S730.specular_reflect_0 * _S723.specular_weft_0;
    float _S732 = _S728.z;
    float3 body_0;
    if((_S727.z * _S732) < 0.0f)
    {
        body_0 = _S729.diffuse_transmit_0 * _S723.diffuse_warp_0 + _S730.diffuse_transmit_0 * _S723.diffuse_weft_0 + _S729.specular_transmit_0 * _S723.specular_warp_0 + _S730.specular_transmit_0 * _S723.specular_weft_0;
    }
    else
    {
        body_0 = _S731;
    }
    if((fabrics_0[_S722].openness_0) != 4294967295U)
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S722, _S723, _S724, _S725, _S726, _S728), _S727, _S728);
    }
    float _S733 = fabrics_0[_S722].sheen_strength_0;
    if((fabrics_0[_S722].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S734 = _S732 < 0.0f;
    float2 _S735 = sheen_with_transmittance_0(to_face_frame_0(_S727, _S734), to_face_frame_0(_S728, _S734), _S733, fabrics_0[_S722].sheen_roughness_0);
    return _S735.y * body_0 + (_S723.light_visibility_1 + _S723.hole_2) * _S735.x;
}

float4 cloth_value_0(uint fabric_1, float2 centre_2, float2 dx_1, float2 dy_1, float3 light_10, float3 view_10)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = centre_2;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    Estimate_0 _S736 = lobes_estimate_0(fabric_1, footprint_0, 1.0f, light_10, view_10);
    float3 _S737 = composed_0(fabric_1, _S736.components_0, _S736.close_0, _S736.albedos_5, (float3)1.0f, light_10, view_10);
    float through_1;
    if((fabrics_0[fabric_1].sheen_strength_0) > 0.0f)
    {
        through_1 = _S736.components_0.hole_2 * (1.0f - fabrics_0[fabric_1].sheen_strength_0 * sheen_lobe_0(abs(view_10.z), fabrics_0[fabric_1].sheen_roughness_0).z);
    }
    else
    {
        through_1 = _S736.components_0.hole_2;
    }
    return float4(_S737, through_1);
}

[numthreads(64, 1, 1)]
void lobes_queries(uint3 id_0 : SV_DispatchThreadID)
{
    if((id_0.x) >= query_count_0.Load(int(0)))
    {
        return;
    }
    Query_0 _S738 = queries_0.Load(id_0.x);
    answers_0[id_0.x] = cloth_value_0(_S738.fabric_0, float2(_S738.centre_x_0, _S738.centre_y_0), float2(_S738.dx_x_0, _S738.dx_y_0), float2(_S738.dy_x_0, _S738.dy_y_0), float3(_S738.light_x_0, _S738.light_y_0, _S738.light_z_0), float3(_S738.view_x_0, _S738.view_y_0, _S738.view_z_0));
    return;
}

