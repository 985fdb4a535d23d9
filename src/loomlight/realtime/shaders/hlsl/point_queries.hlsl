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

static const float  PYRAMID_RADII_0[int(4)] = { 1.0f, 2.0f, 4.0f, 8.0f };
struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 default_quality_0()
{
    SearchQuality_0 quality_0;
    quality_0.steps_per_thread_0 = 5.0f;
    quality_0.steps_per_relief_0 = 8.0f;
    quality_0.shadow_share_0 = 1.0f;
    quality_0.refinements_0 = 2U;
    return quality_0;
}

float3 to_face_frame_0(float3 direction_0, bool back_2)
{
    float2 _S1 = direction_0.xy;
    float _S2;
    if(back_2)
    {
        _S2 = - direction_0.z;
    }
    else
    {
        _S2 = direction_0.z;
    }
    return float3(_S1, _S2);
}

float2 turns_and_remainder_0(uint family_0, float index_0)
{
    float _S3 = floor(mad(index_0, families_0.Load(family_0).inverse_count_0, families_0.Load(family_0).half_inverse_count_0));
    return float2(_S3, mad(- _S3, families_0.Load(family_0).count_0, index_0));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0)
{
    float _S4 = floor(position_0 * families_0.Load(family_1).inverse_size_0);
    Cell_0 cell_0;
    float _S5 = mad(- _S4, families_0.Load(family_1).size_0, position_0);
    cell_0.below_0 = _S5;
    cell_0.above_0 = families_0.Load(family_1).size_0 - _S5;
    cell_0.across_0 = _S5 - 0.5f * families_0.Load(family_1).size_0;
    cell_0.half_width_1 = families_0.Load(family_1).half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S4).y, 0.0f, families_0.Load(family_1).count_0 - 1.0f));
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
    float _S6 = turns_1 * families_0.Load(family_2).period_0;
    uint thread_1 = words_0.Load(families_0.Load(family_2).first_thread_table_0 + uint(clamp(turns_1 * families_0.Load(family_2).bins_0, 0.0f, families_0.Load(family_2).bins_0 - 1.0f)));
    uint _S7;
    if(_S6 >= (table_number_0(families_0.Load(family_2).place_table_0 + thread_1 * 4U + 1U)))
    {
        _S7 = 1U;
    }
    else
    {
        _S7 = 0U;
    }
    uint _S8 = min(thread_1 + _S7, uint(families_0.Load(family_2).count_0) - 1U);
    uint _S9 = families_0.Load(family_2).place_table_0 + _S8 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S8;
    cell_1.below_0 = _S6 - table_number_0(_S9);
    cell_1.above_0 = table_number_0(_S9 + 1U) - _S6;
    cell_1.across_0 = _S6 - table_number_0(_S9 + 2U);
    cell_1.half_width_1 = table_number_0(_S9 + 3U);
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
    bool is_warp_0;
    bool hole_0;
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

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_3)
{
    bool _S10 = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    bool _S11 = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S12;
    if(_S10)
    {
        if(!_S11)
        {
            _S12 = true;
        }
        else
        {
            _S12 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S12 = false;
    }
    shown_0.is_warp_0 = _S12;
    if(!_S10)
    {
        _S12 = !_S11;
    }
    else
    {
        _S12 = false;
    }
    shown_0.hole_0 = _S12;
    uint _S13;
    if(shown_0.is_warp_0)
    {
        _S13 = crossing_0.warp_word_0;
    }
    else
    {
        _S13 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S13;
    shown_0.on_top_0 = ((_S13 & 1U) == 1U) != back_3;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_0, Cell_0 second_0)
{
    Cell_0 cell_2;
    uint _S14;
    if(is_first_0)
    {
        _S14 = first_0.thread_0;
    }
    else
    {
        _S14 = second_0.thread_0;
    }
    cell_2.thread_0 = _S14;
    float _S15;
    if(is_first_0)
    {
        _S15 = first_0.across_0;
    }
    else
    {
        _S15 = second_0.across_0;
    }
    cell_2.across_0 = _S15;
    if(is_first_0)
    {
        _S15 = first_0.half_width_1;
    }
    else
    {
        _S15 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S15;
    if(is_first_0)
    {
        _S15 = first_0.below_0;
    }
    else
    {
        _S15 = second_0.below_0;
    }
    cell_2.below_0 = _S15;
    if(is_first_0)
    {
        _S15 = first_0.above_0;
    }
    else
    {
        _S15 = second_0.above_0;
    }
    cell_2.above_0 = _S15;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0)
{
    float2 _S16 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    return mad(_S16.x, families_0.Load(family_4).period_0, table_number_0(families_0.Load(family_4).place_table_0 + uint(_S16.y) * 4U));
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
    Family_0 _S17 = families_0.Load(family_6);
    uint _S18;
    if((families_0.Load(family_6).is_alike_0) != 0U)
    {
        _S18 = 0U;
    }
    else
    {
        _S18 = thread_4 * 4U;
    }
    uint _S19 = _S17.bend_table_0 + _S18;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S19);
    bend_0.half_tangent_0 = table_number_0(_S19 + 1U);
    bend_0.arc_0 = table_number_0(_S19 + 2U);
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
    int _S20 = int((word_1 >> int(1)) & 127U);
    int _S21 = int((word_1 >> int(8)) & 127U);
    int _S22 = int((word_1 >> int(15)) & 63U);
    int _S23 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    int _S24 = - _S20;
    float _S25 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S24, int(0));
    run_0.from_start_0 = _S25;
    int _S26 = _S21 + int(1);
    float _S27 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, int(1), _S26);
    run_0.to_end_0 = _S27;
    bool _S28 = _S25 < _S27;
    run_0.near_start_0 = _S28;
    int _S29;
    if(_S28)
    {
        _S29 = _S24 - _S22;
    }
    else
    {
        _S29 = _S26;
    }
    int _S30;
    if(run_0.near_start_0)
    {
        _S30 = _S24;
    }
    else
    {
        _S30 = _S26 + _S23;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    float _S31;
    if(run_0.straight_0)
    {
        _S31 = 1.0e+06f;
    }
    else
    {
        _S31 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S31;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S29, _S30), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S20 == int(0);
    run_0.last_crossing_0 = _S21 == int(0);
    return run_0;
}

float square_0(float x_0)
{
    return x_0 * x_0;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_3)
{
    float _S32 = cell_3.half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S33 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S33;
    float _S34 = _S32 * _S32 - square_0(_S33);
    float _S35 = rsqrt(_S34);
    section_0.drop_0 = _S32 - _S34 * _S35;
    section_0.slope_0 = - _S33 * _S35;
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
    bool _S36 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S37 = min(crossed_1.below_0, crossed_1.above_0);
    float _S38;
    if(_S36)
    {
        _S38 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S38 = crossed_1.above_0 + crossed_1.across_0;
    }
    float _S39 = _S38 - crossed_1.half_width_1;
    bool _S40;
    if(_S36)
    {
        _S40 = run_1.first_crossing_0;
    }
    else
    {
        _S40 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S38 = 0.0f;
    }
    else
    {
        _S38 = families_0.Load(other_1).height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, int(0));
    }
    float _S41;
    if((shown_1.on_top_0) != _S40)
    {
        _S41 = 0.0f;
    }
    else
    {
        Family_0 _S42 = families_0.Load(other_1);
        int _S43;
        if(_S36)
        {
            _S43 = int(-1);
        }
        else
        {
            _S43 = int(1);
        }
        _S41 = _S42.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S43);
    }
    float _S44 = 1.0f / max(2.0f * _S39, 9.999999960041972e-13f);
    float _S45 = clamp((_S39 - _S37) * _S44, 0.0f, 1.0f);
    float _S46 = _S38 + (_S41 - _S38) * (_S45 * _S45 * (3.0f - 2.0f * _S45));
    float _S47 = (_S38 - _S41) * (6.0f * _S45 * (1.0f - _S45) * _S44);
    if(_S36)
    {
        _S38 = 1.0f;
    }
    else
    {
        _S38 = -1.0f;
    }
    return float2(_S46, _S47 * _S38);
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
    float _S48 = direction_1.x;
    control_0.per_x_0 = 1.0f / max(abs(_S48), 9.99999971718068537e-10f);
    float _S49 = direction_1.y;
    control_0.per_y_0 = 1.0f / max(abs(_S49), 9.99999971718068537e-10f);
    control_0.right_0 = _S48 > 0.0f;
    control_0.up_0 = _S49 > 0.0f;
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
    float _S50;
    if(forwards_0)
    {
        _S50 = cell_4.across_0;
    }
    else
    {
        _S50 = - cell_4.across_0;
    }
    float _S51;
    if(forwards_0)
    {
        _S51 = cell_4.above_0;
    }
    else
    {
        _S51 = cell_4.below_0;
    }
    bool _S52;
    if(forwards_0)
    {
        _S52 = run_2.last_crossing_0;
    }
    else
    {
        _S52 = run_2.first_crossing_0;
    }
    bool _S53;
    if(forwards_0)
    {
        _S53 = run_2.first_crossing_0;
    }
    else
    {
        _S53 = run_2.last_crossing_0;
    }
    float _S54 = - cell_4.half_width_1;
    bool _S55 = _S50 < _S54;
    bool _S56 = _S50 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S52 = !_S52;
    }
    else
    {
        _S52 = false;
    }
    if(_S52)
    {
        _S52 = !shown_2.hole_0;
    }
    else
    {
        _S52 = false;
    }
    bool _S57;
    if(_S52)
    {
        _S57 = shown_2.on_top_0;
    }
    else
    {
        _S57 = false;
    }
    if(_S57)
    {
        if(_S53)
        {
            _S53 = _S55;
        }
        else
        {
            _S53 = false;
        }
        _S53 = !_S53;
    }
    else
    {
        _S53 = false;
    }
    if(shown_2.hole_0)
    {
        _S52 = true;
    }
    else
    {
        if(_S52)
        {
            _S52 = !shown_2.on_top_0;
        }
        else
        {
            _S52 = false;
        }
    }
    float _S58;
    if(_S55)
    {
        _S58 = _S54;
    }
    else
    {
        _S58 = cell_4.half_width_1;
    }
    float _S59 = _S58 - _S50;
    if(_S52)
    {
        _S50 = 2.0f * _S51 + _S50 - cell_4.half_width_1;
    }
    else
    {
        _S50 = _S51;
    }
    if(_S53)
    {
        if(forwards_0)
        {
            _S50 = run_2.to_end_0;
        }
        else
        {
            _S50 = run_2.from_start_0;
        }
        return _S50;
    }
    if(_S56)
    {
    }
    else
    {
        _S50 = _S59;
    }
    return _S50;
}

struct Probe_0
{
    float height_1;
    bool hole_1;
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
    float _S60 = previous_1.rate_0 * step_4;
    float _S61 = rate_1 * step_4;
    bool _S62;
    if(!previous_1.known_0)
    {
        _S62 = true;
    }
    else
    {
        _S62 = here_0.hole_1;
    }
    if(_S62)
    {
        _S62 = true;
    }
    else
    {
        _S62 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S62)
    {
        _S62 = true;
    }
    else
    {
        _S62 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S62)
    {
        _S62 = true;
    }
    else
    {
        _S62 = rate_1 <= 0.0f;
    }
    if(_S62)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S60) >= 0.0f)
    {
        _S62 = (3.0f * clearance_1 - _S61) >= 0.0f;
    }
    else
    {
        _S62 = false;
    }
    if(_S62)
    {
        return -1.0f;
    }
    float _S63 = clearance_1 - previous_1.clearance_0;
    float _S64 = 6.0f * _S63 - 4.0f * _S60 - 2.0f * _S61;
    float _S65 = -2.0f * _S60 / max(_S64 + sqrt(max(_S64 * _S64 - 4.0f * (3.0f * (_S60 + _S61 - 2.0f * _S63)) * _S60, 0.0f)), 9.99999968265522539e-21f);
    float _S66 = 1.0f - _S65;
    float _S67 = (previous_1.clearance_0 * (2.0f * _S65 + 1.0f) + _S60 * _S65) * _S66 * _S66;
    float _S68 = (clearance_1 * (2.0f * _S66 + 1.0f) - _S61 * _S66) * _S65 * _S65;
    if(_S65 > 0.01999999955296516f)
    {
        _S62 = _S66 > 0.01999999955296516f;
    }
    else
    {
        _S62 = false;
    }
    if(_S62)
    {
        _S62 = (_S67 + _S68) < 0.0f;
    }
    else
    {
        _S62 = false;
    }
    float _S69;
    if(_S62)
    {
        _S69 = _S66 * step_4;
    }
    else
    {
        _S69 = -1.0f;
    }
    return _S69;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S70;
    if(here_1.hole_1)
    {
        _S70 = 1.0e+09f;
    }
    else
    {
        _S70 = clearance_2;
    }
    previous_2.clearance_0 = _S70;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S71;
    if(!here_1.hole_1)
    {
        _S71 = !is_cell_exit_0;
    }
    else
    {
        _S71 = false;
    }
    previous_2.known_0 = _S71;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_0, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_1, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S72 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    bool _S73;
    if(!here_2.hole_1)
    {
        _S73 = (rate_3 * _S72 + clearance_3) < 0.0f;
    }
    else
    {
        _S73 = false;
    }
    if(_S73)
    {
        _S73 = _S72 > (2.0f * this_1.epsilon_0);
    }
    else
    {
        _S73 = false;
    }
    float _S74;
    if(_S73)
    {
        _S74 = _S72 - this_1.epsilon_0;
    }
    else
    {
        _S74 = max(_S72, 0.0f) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S74);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(ViewRay_0 this_2, float height_2)
{
    return this_2.origin_0 + this_2.slope_1 * height_2;
}

float ViewRay_rate_0(ViewRay_0 this_3, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_3.slope_1.x + here_3.slope_y_0 * this_3.slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S75 = end_0 - start_1;
    float _S76 = start_rate_0 + end_rate_0 - 2.0f * _S75;
    float _S77 = 3.0f * _S75 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S75, 9.99999968265522539e-21f);
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
        float _S78 = clamp(share_0 - (((_S76 * share_0 + _S77) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S76 * share_0 + 2.0f * _S77) * share_0 + start_rate_0, 0.10000000149011612f * _S75 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S79 = i_0 + int(1);
        share_0 = _S78;
        i_0 = _S79;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S80 = along_slope_0 * along_slope_0 + 1.0f;
    float _S81 = rsqrt(_S80);
    float _S82 = sine_1 * _S81 * rsqrt(_S80 + across_slope_0 * across_slope_0);
    return float2(- _S82 * _S80, _S82 * across_slope_0 * along_slope_0 + cosine_0 * _S81);
}

float arc_sine_0(float x_1)
{
    float _S83 = abs(x_1);
    bool _S84 = _S83 > 0.5f;
    float _S85;
    if(_S84)
    {
        _S85 = 0.5f * (1.0f - _S83);
    }
    else
    {
        _S85 = _S83 * _S83;
    }
    float _S86;
    if(_S84)
    {
        _S86 = sqrt(max(_S85, 0.0f));
    }
    else
    {
        _S86 = _S83;
    }
    float _S87 = ((((0.04216320067644119f * _S85 + 0.02418131195008755f) * _S85 + 0.04547002539038658f) * _S85 + 0.07495300471782684f) * _S85 + 0.16666752099990845f) * _S85 * _S86 + _S86;
    if(_S84)
    {
        _S85 = 1.57079637050628662f - 2.0f * _S87;
    }
    else
    {
        _S85 = _S87;
    }
    if(x_1 < 0.0f)
    {
        _S85 = - _S85;
    }
    return _S85;
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
    uint _S88 = value_0 * 747796405U + 2891336453U;
    uint _S89 = ((_S88 >> ((_S88 >> int(28)) + 4U)) ^ _S88) * 277803737U;
    return (_S89 >> int(22)) ^ _S89;
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
    float3 _S90 = room_0 / max(albedo_1, (float3)9.99999997475242708e-07f);
    return min(gain_0, max(min(min(_S90.x, _S90.y), _S90.z), 0.0f));
}

float natural_logarithm_0(float x_2)
{
    uint _S91 = asuint(x_2);
    float exponent_0 = float(int(_S91 >> int(23)) - int(126));
    float m_0 = asfloat((_S91 & 8388607U) | 1056964608U);
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
    float _S92 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S92 - exponent_1 * 0.00021219444170129f - 0.5f * _S92) + exponent_1 * 0.693359375f;
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

struct FaceRadiance_0
{
    float3 warp_2;
    float3 weft_2;
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
    float3 _S93 = (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3 _S94 = sends_0.sky_warp_0 + _S93 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S94;
    float3 _S95 = sends_0.sky_weft_0 + _S93 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S95;
    found_0.mean_0 = sends_0.blocks_warp_0 * _S94 + sends_0.blocks_weft_0 * _S95;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

struct Bounced_0
{
    float3 reflected_0;
    float3 transmitted_0;
};

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

struct Scattered_0
{
    float3 back_4;
    float3 through_0;
};

struct Interior_0
{
    float3 warp_3;
    float3 weft_3;
    float3 leaked_1;
    float3 far_1;
    float3 far_leaked_0;
};

Bounced_0 bounced_by_0(Blocked_0 blocked_0, Scattered_0 yarn_2, Interior_0 interior_0)
{
    float3 _S96 = (blocked_0.by_warp_0 + blocked_0.by_weft_0) * interior_0.leaked_1;
    float3 _S97 = blocked_0.far_0 * yarn_2.through_0;
    Bounced_0 bounced_0;
    bounced_0.reflected_0 = yarn_2.back_4 * (blocked_0.by_warp_0 * interior_0.warp_3 + blocked_0.by_weft_0 * interior_0.weft_3) + _S97 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S97 * interior_0.far_1 + yarn_2.back_4 * _S96;
    return bounced_0;
}

float diffuse_reflection_0(float3 light_0, float3 normal_0, float blend_0)
{
    float _S98 = light_0.z;
    if(_S98 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp(max(_S98, 0.0f), max(dot(light_0, normal_0), 0.0f), blend_0);
}

float projected_area_1(float3 direction_2, float3 tangent_0, float roughness_1)
{
    float _S99 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S99 * _S99 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_3)
{
    float _S100 = clamp(x_3, -87.0f, 88.0f);
    float _S101 = floor(_S100 * 1.4426950216293335f + 0.5f);
    float _S102 = _S100 - _S101 * 0.693359375f + _S101 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S102 + 0.00139819993637502f) * _S102 + 0.00833345204591751f) * _S102 + 0.04166579619050026f) * _S102 + 0.1666666567325592f) * _S102 + 0.5f;
    float _S103 = asfloat(uint(int(_S101) + int(127)) << int(23));
    float _S104;
    if(x_3 < -87.0f)
    {
        _S104 = 0.0f;
    }
    else
    {
        _S104 = (p_0 * _S102 * _S102 + _S102 + 1.0f) * _S103;
    }
    return _S104;
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
    float _S105 = roughness_2 * roughness_2;
    float _S106 = squared_along_0 * (1.0f - _S105) + _S105;
    return 0.31830987334251404f * _S105 * roughness_2 / (_S106 * _S106);
}

float density_between_0(float3 light_1, float3 view_0, float3 tangent_1, float roughness_3)
{
    float3 _S107 = light_1 + view_0;
    float _S108 = dot(_S107, tangent_1);
    return flake_density_0(min(_S108 * _S108 / max(square_1(_S107), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_2, float3 view_1, float3 normal_1, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S109 = dot(light_2, normal_1);
    bool _S110;
    if(_S109 <= 0.0f)
    {
        _S110 = true;
    }
    else
    {
        _S110 = (dot(view_1, normal_1)) <= 0.0f;
    }
    if(_S110)
    {
        return 0.0f;
    }
    float _S111 = max(_S109, 9.99999997475242708e-07f);
    float _S112 = max(dot(view_1, normal_1), 9.99999997475242708e-07f);
    float _S113 = projected_area_1(light_2, tangent_2, roughness_4) * _S112 + projected_area_1(view_1, tangent_2, roughness_4) * _S111;
    float _S114 = optical_depth_1 * _S113 / (_S111 * _S112);
    return 0.25f * density_between_0(light_2, view_1, tangent_2, roughness_4) * (_S114 * mean_attenuation_0(_S114)) * _S111 / _S113;
}

float transmission_1(float3 light_3, float3 view_2, float3 normal_2, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S115 = - dot(light_3, normal_2);
    float _S116 = dot(view_2, normal_2);
    bool _S117;
    if(_S115 <= 0.0f)
    {
        _S117 = true;
    }
    else
    {
        _S117 = _S116 <= 0.0f;
    }
    if(_S117)
    {
        return 0.0f;
    }
    float _S118 = 1.0f / max(_S116, 9.99999997475242708e-07f);
    float _S119 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S115, 9.99999997475242708e-07f);
    float _S120 = projected_area_1(view_2, tangent_3, roughness_5) * _S118;
    return density_between_0(light_3, view_2, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S119, _S120)) * mean_attenuation_0(optical_depth_2 * abs(_S119 - _S120)) * _S118;
}

float sheen_scale_0(float x_4, float y_0)
{
    return (((((0.0f * x_4 + (((((-1.1402510404586792f * y_0 + 0.40672621130943298f) * y_0 + 1.65398800373077393f) * y_0 + -1.29730904102325439f) * y_0 + 0.30570998787879944f) * y_0 + -0.0220868494361639f)) * x_4 + (((((-0.21142719686031342f * y_0 + 1.05947399139404297f) * y_0 + -0.41116121411323547f) * y_0 + -0.93859231472015381f) * y_0 + 0.51606941223144531f) * y_0 + 0.05409301072359085f)) * x_4 + (((((1.22944498062133789f * y_0 + -0.45962560176849365f) * y_0 + -1.63861405849456787f) * y_0 + 1.33565104007720947f) * y_0 + -0.45725581049919128f) * y_0 + 0.08243165910243988f)) * x_4 + (((((0.39779931306838989f * y_0 + -1.18879103660583496f) * y_0 + 0.28251591324806213f) * y_0 + 1.168984055519104f) * y_0 + -0.76864629983901978f) * y_0 + 0.0091691892594099f)) * x_4 + (((((-0.26563560962677002f * y_0 + -0.19379159808158875f) * y_0 + 0.2677634060382843f) * y_0 + 0.00270519289188087f) * y_0 + 0.14349560439586639f) * y_0 + 0.10290180146694183f)) * x_4 + (((((-0.20701569318771362f * y_0 + 0.24526430666446686f) * y_0 + 0.19551840424537659f) * y_0 + 0.07586126774549484f) * y_0 + 0.38894739747047424f) * y_0 + 0.15043120086193085f);
}

float sheen_shear_0(float x_5, float y_1)
{
    return ((((0.0f * x_5 + (((((-0.10608240216970444f * y_1 + 1.99214303493499756f) * y_1 + -1.42255294322967529f) * y_1 + -1.09495604038238525f) * y_1 + 0.59180057048797607f) * y_1 + 0.06902855634689331f)) * x_5 + (((((-0.46220690011978149f * y_1 + -0.29113379120826721f) * y_1 + 1.39025199413299561f) * y_1 + 0.35589990019798279f) * y_1 + -1.17120099067687988f) * y_1 + 0.15940259397029877f)) * x_5 + (((((2.26068711280822754f * y_1 + -3.64728999137878418f) * y_1 + -0.72173482179641724f) * y_1 + 3.07659196853637695f) * y_1 + -0.6827620267868042f) * y_1 + -0.3039557933807373f)) * x_5 + (((((0.81201767921447754f * y_1 + 0.36014080047607422f) * y_1 + -1.72646903991699219f) * y_1 + -0.22630110383033752f) * y_1 + 0.89514690637588501f) * y_1 + -0.10397960245609283f)) * x_5 + (((((-0.37648698687553406f * y_1 + 1.10974001884460449f) * y_1 + 0.17824520170688629f) * y_1 + -1.04968702793121338f) * y_1 + 0.1461234986782074f) * y_1 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_6, float y_2)
{
    return ((((0.0f * x_6 + (((((12.95646953582763672f * y_2 + -21.38032913208007812f) * y_2 + -7.37853097915649414f) * y_2 + 34.55607986450195312f) * y_2 + -23.61347007751464844f) * y_2 + 5.00126314163208008f)) * x_6 + (((((10.91487026214599609f * y_2 + -6.08202791213989258f) * y_2 + -38.2036285400390625f) * y_2 + 53.3440399169921875f) * y_2 + -21.91996002197265625f) * y_2 + 2.01606011390686035f)) * x_6 + (((((-14.52206039428710938f * y_2 + 36.803619384765625f) * y_2 + -22.94047927856445312f) * y_2 + -10.07973003387451172f) * y_2 + 15.77003955841064453f) * y_2 + -4.92722177505493164f)) * x_6 + (((((-7.62505722045898438f * y_2 + 1.27310299873352051f) * y_2 + 31.19523048400878906f) * y_2 + -44.39989852905273438f) * y_2 + 26.44947052001953125f) * y_2 + -8.73507976531982422f)) * x_6 + (((((5.65633487701416016f * y_2 + -17.66820907592773438f) * y_2 + 24.65356063842773438f) * y_2 + -19.38941001892089844f) * y_2 + 11.06159019470214844f) * y_2 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S121 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S122 = 2.0f * sqrt(_S121) - 1.0f;
    float _S123 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S122, _S123), 0.00999999977648258f, 1.0f), clamp((1.0f - _S121) * sheen_shear_0(_S122, _S123), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S122, _S123), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_4, float3 view_3, float scale_0, float shear_0)
{
    float _S124 = light_4.z;
    bool _S125;
    if(_S124 <= 0.0f)
    {
        _S125 = true;
    }
    else
    {
        _S125 = (view_3.z) <= 0.0f;
    }
    if(_S125)
    {
        return 0.0f;
    }
    float2 _S126 = view_3.xy;
    float _S127 = dot(_S126, _S126);
    float2 _S128;
    if(_S127 > 9.99999968265522539e-21f)
    {
        _S128 = _S126 * rsqrt(_S127);
    }
    else
    {
        _S128 = float2(1.0f, 0.0f);
    }
    float _S129 = scale_0 * dot(light_4.xy, _S128) + shear_0 * _S124;
    float _S130 = scale_0 * (light_4.y * _S128.x - light_4.x * _S128.y);
    float _S131 = _S129 * _S129 + _S130 * _S130 + _S124 * _S124;
    return 0.31830987334251404f * scale_0 * scale_0 * _S124 / max(_S131 * _S131, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_5, float3 view_4, float strength_0, float roughness_7)
{
    float3 _S132 = sheen_lobe_0(view_4.z, roughness_7);
    float _S133 = strength_0 * _S132.z;
    return float2(_S133 * transformed_cosine_0(light_5, view_4, _S132.x, _S132.y), 1.0f - _S133);
}

float3 bounced_value_0(Bounced_0 bounced_1, float3 light_6, float3 view_5)
{
    float _S134 = light_6.z;
    float3 _S135;
    if((_S134 * view_5.z) < 0.0f)
    {
        _S135 = bounced_1.transmitted_0;
    }
    else
    {
        _S135 = bounced_1.reflected_0;
    }
    return _S135 * (abs(_S134) * 0.31830987334251404f);
}

struct YarnPoint_0
{
    bool back_5;
    bool hole_2;
    bool is_warp_1;
    float x_7;
    float y_3;
    float height_3;
    float3 normal_3;
    float3 tangent_4;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_8;
    float y_4;
    bool hole_3;
    float height_4;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_5;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S136, float _S137, float _S138, bool _S139)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0[_S136].warp_0, _S137);
    crossing_2.weft_1 = locate_0(fabrics_0[_S136].weft_0, _S138);
    uint _S140 = fabrics_0[_S136].run_words_0 + 2U * (crossing_2.weft_1.thread_0 * fabrics_0[_S136].ends_1 + crossing_2.warp_1.thread_0);
    uint _S141 = words_0.Load(_S140);
    crossing_2.warp_word_0 = _S141;
    crossing_2.weft_word_0 = words_0.Load(_S140 + 1U);
    crossing_2.warp_above_0 = ((_S141 & 1U) == 1U) != _S139;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S142, float _S143, float _S144, bool _S145)
{
    Sample_0 sample_0;
    Crossing_0 _S146 = crossing_at_0(_S142, _S143, _S144, _S145);
    sample_0.crossing_1 = _S146;
    Shown_0 _S147 = shown_at_0(_S146, _S145);
    sample_0.shown_3 = _S147;
    uint _S148;
    if(_S147.is_warp_0)
    {
        _S148 = fabrics_0[_S142].warp_0;
    }
    else
    {
        _S148 = fabrics_0[_S142].weft_0;
    }
    uint _S149;
    if(_S147.is_warp_0)
    {
        _S149 = fabrics_0[_S142].weft_0;
    }
    else
    {
        _S149 = fabrics_0[_S142].warp_0;
    }
    Cell_0 _S150 = select_cell_0(_S147.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    Cell_0 _S151 = select_cell_0(_S147.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    Run_0 _S152 = unpack_0(_S148, _S149, _S150.thread_0, _S151, _S147.word_0);
    Section_0 _S153 = section_at_0(_S150);
    bool _S154;
    if(_S147.on_top_0)
    {
        _S154 = (_S152.distance_0) < (_S153.drop_0 * _S152.bend_1.sine_0);
    }
    else
    {
        _S154 = false;
    }
    bool _S155;
    if(_S147.on_top_0)
    {
        _S155 = !_S154;
    }
    else
    {
        _S155 = false;
    }
    float _S156;
    if(_S155)
    {
        _S156 = 1.0f;
    }
    else
    {
        _S156 = -1.0f;
    }
    float _S157;
    if(_S154)
    {
        _S157 = _S152.other_reach_0;
    }
    else
    {
        _S157 = _S152.reach_0;
    }
    float _S158;
    if(_S154)
    {
        _S158 = _S157 + _S152.distance_0;
    }
    else
    {
        _S158 = max(_S157 - _S152.distance_0, 0.0f);
    }
    float _S159 = _S157 / _S152.bend_1.sine_0 - _S156 * _S153.drop_0;
    float _S160 = _S158 * _S158;
    float _S161 = max(_S159 * _S159 - _S160, 9.99999968265522539e-21f);
    float _S162 = rsqrt(_S161);
    float _S163 = _S160 / (_S161 * _S162 + _S159);
    bool _S164 = _S158 > 0.0f;
    float _S165;
    if(_S147.on_top_0)
    {
        _S165 = 1.0f;
    }
    else
    {
        _S165 = -1.0f;
    }
    float _S166;
    if(_S152.near_start_0)
    {
        _S166 = 1.0f;
    }
    else
    {
        _S166 = -1.0f;
    }
    float _S167 = _S165 * _S166;
    if(_S164)
    {
        _S165 = _S159 * _S162;
    }
    else
    {
        _S165 = 1.0f;
    }
    sample_0.slope_across_0 = _S153.slope_0 * _S165;
    if(_S164)
    {
        _S158 = _S167 * _S158 * _S162;
    }
    else
    {
        _S158 = 0.0f;
    }
    sample_0.slope_along_0 = _S158;
    Family_0 _S168 = families_0.Load(_S148);
    float2 _S169 = dive_0(_S149, _S147, _S152, _S151);
    if(_S152.straight_0)
    {
        _S156 = 0.0f;
    }
    else
    {
        _S156 = _S168.height_scale_0 * _S156;
    }
    sample_0.height_5 = _S156 * (_S157 * _S152.bend_1.half_tangent_0 - _S163) - _S168.height_scale_0 * _S153.drop_0 - _S169.x;
    float _S170 = _S168.height_scale_0 * sample_0.slope_across_0;
    float _S171 = _S168.height_scale_0 * sample_0.slope_along_0 - _S169.y;
    if(_S147.is_warp_0)
    {
        _S156 = _S170;
    }
    else
    {
        _S156 = _S171;
    }
    sample_0.slope_x_1 = _S156;
    if(_S147.is_warp_0)
    {
        _S156 = _S171;
    }
    else
    {
        _S156 = _S170;
    }
    sample_0.slope_y_1 = _S156;
    sample_0.run_3 = _S152;
    sample_0.section_1 = _S153;
    return sample_0;
}

float steps_per_length_0(uint _S172, SearchQuality_0 _S173, float3 _S174)
{
    return max(max(abs(_S174.x) * fabrics_0[_S172].threads_per_x_0, abs(_S174.y) * fabrics_0[_S172].threads_per_y_0) * _S173.steps_per_thread_0, abs(_S174.z) * fabrics_0[_S172].per_relief_0 * _S173.steps_per_relief_0);
}

float cell_maximum_0(uint _S175, Crossing_0 _S176)
{
    uint _S177;
    if(_S176.warp_above_0)
    {
        _S177 = fabrics_0[_S175].warp_0;
    }
    else
    {
        _S177 = fabrics_0[_S175].weft_0;
    }
    uint _S178;
    if(_S176.warp_above_0)
    {
        _S178 = _S176.warp_word_0;
    }
    else
    {
        _S178 = _S176.weft_word_0;
    }
    return float(_S178 >> int(28)) * families_0.Load(_S177).height_scale_0 * families_0.Load(_S177).level_0;
}

Probe_0 probe_0(uint _S179, float _S180, float _S181, bool _S182, bool _S183, bool _S184)
{
    Sample_0 _S185 = sample_at_0(_S179, _S180, _S181, _S182);
    Probe_0 probe_1;
    probe_1.height_1 = _S185.height_5;
    probe_1.hole_1 = _S185.shown_3.hole_0;
    probe_1.slope_x_0 = _S185.slope_x_1;
    probe_1.slope_y_0 = _S185.slope_y_1;
    uint _S186;
    if(_S185.shown_3.is_warp_0)
    {
        _S186 = _S185.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S186 = _S185.crossing_1.weft_1.thread_0 * 2U;
    }
    probe_1.yarn_1 = _S186;
    probe_1.cell_max_0 = cell_maximum_0(_S179, _S185.crossing_1);
    float _S187;
    if(_S183)
    {
        _S187 = _S185.crossing_1.warp_1.above_0;
    }
    else
    {
        _S187 = _S185.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S187;
    if(_S184)
    {
        _S187 = _S185.crossing_1.weft_1.above_0;
    }
    else
    {
        _S187 = _S185.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S187;
    probe_1.edge_x_0 = outline_distance_0(_S185.crossing_1.warp_1, _S185.shown_3, _S185.run_3, !_S185.shown_3.is_warp_0, _S183);
    probe_1.edge_y_0 = outline_distance_0(_S185.crossing_1.weft_1, _S185.shown_3, _S185.run_3, _S185.shown_3.is_warp_0, _S184);
    return probe_1;
}

bool is_free_0(uint _S188, SearchQuality_0 _S189, float3 _S190, float3 _S191, bool _S192, float _S193)
{
    float _S194 = _S191.z;
    if(_S194 <= 0.0f)
    {
        return false;
    }
    float _S195 = 1.0f / max(_S189.shadow_share_0 * steps_per_length_0(_S188, _S189, _S191), 9.99999971718068537e-10f);
    StepControl_0 _S196 = step_control_0(_S191.xy, _S195);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S197;
        if(count_1 < 1024U)
        {
            _S197 = (_S190.z + _S194 * distance_1) < _S193;
        }
        else
        {
            _S197 = false;
        }
        if(_S197)
        {
        }
        else
        {
            break;
        }
        float3 _S198 = _S190 + _S191 * distance_1;
        Probe_0 _S199 = probe_0(_S188, _S198.x, _S198.y, _S192, _S196.right_0, _S196.up_0);
        float _S200 = _S198.z;
        float _S201 = _S200 - _S199.height_1;
        float _S202 = _S194 - _S199.slope_x_0 * _S191.x - _S199.slope_y_0 * _S191.y;
        bool _S203;
        if(!_S199.hole_1)
        {
            _S203 = _S201 < 0.0f;
        }
        else
        {
            _S203 = false;
        }
        if(_S203)
        {
            return false;
        }
        float _S204 = way_back_to_dip_0(previous_3, _S201, _S202, last_step_0, _S199);
        if(_S204 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S204;
            distance_1 = distance_1 - _S204;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S205 = _S200 > (_S199.cell_max_0);
        PreviousSample_0 _S206 = after_sample_0(_S201, _S202, _S199, _S205);
        float last_step_2;
        if(_S205)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S196, _S199.side_x_0, _S199.side_y_0), _S195);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S196, _S199, _S201, _S202);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S206;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S207, SearchQuality_0 _S208, float _S209, float _S210, float3 _S211, bool _S212)
{
    if(!sample_at_0(_S207, _S209, _S210, _S212).shown_3.hole_0)
    {
        return false;
    }
    float3 _S213 = float3(_S209, _S210, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S214;
        if(side_0 < 2U)
        {
            _S214 = passes_0;
        }
        else
        {
            _S214 = false;
        }
        if(_S214)
        {
        }
        else
        {
            break;
        }
        float3 _S215;
        if(side_0 == 0U)
        {
            _S215 = _S211;
        }
        else
        {
            _S215 = float3(- _S211.x, - _S211.y, _S211.z);
        }
        bool _S216 = is_free_0(_S207, _S208, _S213, _S215, _S212 != (side_0 == 1U), fabrics_0[_S207].height_high_0);
        uint _S217 = side_0 + 1U;
        passes_0 = _S216;
        side_0 = _S217;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_6;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

float max_height_along_0(uint _S218, float _S219, float _S220, float _S221, float3 _S222, bool _S223)
{
    uint _S224 = locate_0(fabrics_0[_S218].warp_0, _S219).thread_0 / 2U;
    uint _S225 = locate_0(fabrics_0[_S218].weft_0, _S220).thread_0 / 2U;
    float _S226 = _S222.x;
    uint _S227;
    if(_S226 > 0.0f)
    {
        _S227 = 1U;
    }
    else
    {
        _S227 = 0U;
    }
    float _S228 = _S222.y;
    uint _S229;
    if(_S228 > 0.0f)
    {
        _S229 = 2U;
    }
    else
    {
        _S229 = 0U;
    }
    uint _S230 = words_0.Load(fabrics_0[_S218].max_heights_0 + 4U * (_S225 * fabrics_0[_S218].max_height_columns_0 + _S224) + (_S227 + _S229));
    int number_0;
    if(_S223)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S231 = _S230 >> number_0;
    float _S232 = max(abs(_S226) * fabrics_0[_S218].threads_per_x_0, abs(_S228) * fabrics_0[_S218].threads_per_y_0) / _S222.z;
    float _S233 = fabrics_0[_S218].height_high_0;
    float max_height_0 = fabrics_0[_S218].height_high_0;
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
        if(((max_height_0 - _S221) * _S232) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S231 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S233);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S234, float _S235, float _S236, bool _S237, bool _S238, bool _S239)
{
    Crossing_0 _S240 = crossing_at_0(_S234, _S235, _S236, _S237);
    float _S241 = cell_maximum_0(_S234, _S240);
    float _S242;
    if(_S238)
    {
        _S242 = _S240.warp_1.above_0;
    }
    else
    {
        _S242 = _S240.warp_1.below_0;
    }
    float _S243;
    if(_S239)
    {
        _S243 = _S240.weft_1.above_0;
    }
    else
    {
        _S243 = _S240.weft_1.below_0;
    }
    return float3(_S241, _S242, _S243);
}

float first_sample_height_0(uint _S244, ViewRay_0 _S245, StepControl_0 _S246, bool _S247)
{
    float _S248 = max_height_along_0(_S244, _S245.origin_0.x, _S245.origin_0.y, 0.0f, float3(_S245.slope_1, 1.0f), _S247);
    uint count_2 = 0U;
    float height_7 = _S248;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S249 = ViewRay_at_0(_S245, height_7);
        float3 _S250 = cell_bounds_0(_S244, _S249.x, _S249.y, _S247, _S246.right_0, _S246.up_0);
        float _S251 = height_7 - _S250.x;
        float _S252 = StepControl_to_cell_exit_0(_S246, _S250.y, _S250.z);
        float height_8 = height_7 - clamp(_S251, 0.0f, _S252);
        if(_S251 <= _S252)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S253, ViewRay_0 _S254, StepControl_0 _S255, bool _S256)
{
    float _S257 = fabrics_0[_S253].height_low_0 - (fabrics_0[_S253].height_high_0 - fabrics_0[_S253].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_6 = first_sample_height_0(_S253, _S254, _S255, _S256);
    end_1.last_step_3 = _S255.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    uint count_3 = 0U;
    for(;;)
    {
        if(count_3 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S258 = ViewRay_at_0(_S254, end_1.height_6);
        Probe_0 _S259 = probe_0(_S253, _S258.x, _S258.y, _S256, _S255.right_0, _S255.up_0);
        float _S260 = end_1.height_6 - _S259.height_1;
        float _S261 = ViewRay_rate_0(_S254, _S259);
        end_1.depth_1 = - _S260;
        end_1.rate_4 = _S261;
        bool _S262;
        if(end_1.previous_4.known_0)
        {
            _S262 = !_S259.hole_1;
        }
        else
        {
            _S262 = false;
        }
        bool _S263;
        if(_S262)
        {
            _S263 = (end_1.previous_4.yarn_0) == (_S259.yarn_1);
        }
        else
        {
            _S263 = false;
        }
        end_1.smooth_0 = _S263;
        bool _S264;
        if(!_S259.hole_1)
        {
            _S264 = _S260 <= 0.0f;
        }
        else
        {
            _S264 = false;
        }
        bool _S265;
        if(_S264)
        {
            _S265 = true;
        }
        else
        {
            _S265 = (end_1.height_6) <= _S257;
        }
        if(_S265)
        {
            break;
        }
        float _S266 = way_back_to_dip_0(end_1.previous_4, _S260, _S261, end_1.last_step_3, _S259);
        if(_S266 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S266;
            end_1.last_step_3 = end_1.last_step_3 - _S266;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S267 = min(StepControl_to_cell_exit_0(_S255, _S259.side_x_0, _S259.side_y_0), end_1.height_6 - _S259.cell_max_0);
        float _S268 = StepControl_to_next_sample_0(_S255, _S259, _S260, _S261);
        end_1.previous_4 = after_sample_0(_S260, _S261, _S259, _S267 > _S268);
        float _S269 = max(_S267, _S268);
        end_1.last_step_3 = _S269;
        end_1.height_6 = end_1.height_6 - _S269;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S270, ViewRay_0 _S271, StepControl_0 _S272, bool _S273, ViewRayEnd_0 _S274, uint _S275)
{
    float _S276 = fabrics_0[_S270].height_high_0 - fabrics_0[_S270].height_low_0;
    float above_2 = _S274.height_6 + _S274.last_step_3;
    float above_gap_1 = clamp(_S274.previous_4.clearance_0, 0.0f, _S276);
    float under_gap_1 = clamp(_S274.depth_1, 0.0f, _S276);
    float _S277 = cubic_root_0(above_gap_1, - under_gap_1, _S274.previous_4.rate_0 * _S274.last_step_3, _S274.rate_4 * _S274.last_step_3);
    float middle_0;
    if(_S274.smooth_0)
    {
        middle_0 = above_2 - _S277 * _S274.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S274.height_6, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S274.height_6;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S275)
        {
        }
        else
        {
            break;
        }
        float2 _S278 = ViewRay_at_0(_S271, middle_0);
        Probe_0 _S279 = probe_0(_S270, _S278.x, _S278.y, _S273, _S272.right_0, _S272.up_0);
        float _S280;
        if(_S279.hole_1)
        {
            _S280 = -1.0e+09f;
        }
        else
        {
            _S280 = _S279.height_1;
        }
        float _S281 = clamp(middle_0 - _S280, - _S276, _S276);
        float _S282;
        if(_S281 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S282 = 0.5f * above_gap_2;
            }
            else
            {
                _S282 = above_gap_2;
            }
            float _S283 = - _S281;
            under_1 = middle_0;
            above_gap_2 = _S282;
            under_gap_2 = _S283;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S282 = 0.5f * under_gap_2;
            }
            else
            {
                _S282 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S281;
            under_gap_2 = _S282;
            side_1 = -1.0f;
        }
        if(_S274.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S281 / min(ViewRay_rate_0(_S271, _S279), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S274.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S284, SearchQuality_0 _S285, float _S286, float _S287, float3 _S288, bool _S289)
{
    float _S290 = max(_S288.z, 0.00009999999747379f);
    ViewRay_0 ray_0;
    ray_0.origin_0 = float2(_S286, _S287);
    float2 _S291 = _S288.xy / _S290;
    ray_0.slope_1 = _S291;
    StepControl_0 _S292 = step_control_0(- _S291, 1.0f / max(steps_per_length_0(_S284, _S285, _S288) / _S290, 9.99999971718068537e-10f));
    ViewRayEnd_0 _S293 = search_down_0(_S284, ray_0, _S292, _S289);
    Hit_0 hit_0;
    hit_0.hole_3 = false;
    float _S294 = refined_height_0(_S284, ray_0, _S292, _S289, _S293, _S285.refinements_0);
    hit_0.height_4 = _S294;
    float2 _S295 = ViewRay_at_0(ray_0, _S294);
    hit_0.x_8 = _S295.x;
    hit_0.y_4 = _S295.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S296, SearchQuality_0 _S297, float _S298, float _S299, float3 _S300, bool _S301)
{
    if(!passes_through_0(_S296, _S297, _S298, _S299, _S300, _S301))
    {
        return first_hit_of_yarn_0(_S296, _S297, _S298, _S299, _S300, _S301);
    }
    Hit_0 hit_1;
    hit_1.x_8 = _S298;
    hit_1.y_4 = _S299;
    hit_1.height_4 = 0.0f;
    hit_1.hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_2;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_9;
    float3 normal_4;
    float3 tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 surface_at_0(uint _S302, float _S303, float _S304, bool _S305)
{
    Sample_0 _S306 = sample_at_0(_S302, _S303, _S304, _S305);
    float _S307;
    if(_S306.shown_3.is_warp_0)
    {
        _S307 = _S306.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S307 = _S306.crossing_1.weft_1.half_width_1;
    }
    uint _S308;
    if(_S306.shown_3.is_warp_0)
    {
        _S308 = fabrics_0[_S302].warp_0;
    }
    else
    {
        _S308 = fabrics_0[_S302].weft_0;
    }
    Family_0 _S309 = families_0.Load(_S308);
    float _S310;
    if(_S305)
    {
        _S310 = -1.0f;
    }
    else
    {
        _S310 = 1.0f;
    }
    float _S311 = _S309.twist_sine_0 * _S310;
    Family_0 _S312 = families_0.Load(_S308);
    if(_S306.shown_3.is_warp_0)
    {
        _S310 = 1.0f;
    }
    else
    {
        _S310 = -1.0f;
    }
    float2 _S313 = fibre_direction_0(_S306.slope_across_0, _S310 * _S306.slope_along_0, _S311, _S312.twist_cosine_0);
    float _S314;
    if(_S306.shown_3.is_warp_0)
    {
        _S314 = _S306.slope_x_1;
    }
    else
    {
        _S314 = _S306.slope_y_1;
    }
    float _S315;
    if(_S306.shown_3.is_warp_0)
    {
        _S315 = _S306.slope_y_1;
    }
    else
    {
        _S315 = _S306.slope_x_1;
    }
    float _S316 = _S313.x;
    float _S317 = _S313.y;
    float _S318 = _S314 * _S316 + _S310 * _S315 * _S317;
    float _S319 = _S307 * 1.0154266357421875f;
    float _S320 = _S319 * arc_sine_0(clamp(_S306.section_1.across_1 / _S319, -1.0f, 1.0f));
    if(_S306.shown_3.is_warp_0)
    {
        _S307 = _S304;
    }
    else
    {
        _S307 = - _S303;
    }
    SurfacePoint_0 point_0;
    point_0.hole_4 = _S306.shown_3.hole_0;
    point_0.is_warp_2 = _S306.shown_3.is_warp_0;
    point_0.warp_thread_0 = _S306.crossing_1.warp_1.thread_0;
    point_0.weft_thread_0 = _S306.crossing_1.weft_1.thread_0;
    point_0.height_9 = _S306.height_5;
    point_0.normal_4 = normalize(float3(- _S306.slope_x_1, - _S306.slope_y_1, 1.0f));
    float3 _S321;
    if(_S306.shown_3.is_warp_0)
    {
        _S321 = float3(_S316, _S317, _S318);
    }
    else
    {
        _S321 = float3(- _S317, _S316, _S318);
    }
    point_0.tangent_5 = normalize(_S321);
    point_0.across_2 = _S306.section_1.across_1;
    point_0.fibre_across_0 = _S320 * _S312.twist_cosine_0 + _S307 * _S311;
    point_0.fibre_along_0 = _S307 * _S312.twist_cosine_0 - _S320 * _S311;
    return point_0;
}

Albedos_0 vary_albedos_0(uint _S322, Albedos_0 _S323, uint _S324, uint _S325)
{
    float3 _S326 = max(_S323.specular_reflect_0, _S323.specular_transmit_0);
    float3 _S327 = _S323.diffuse_reflect_0 + _S323.diffuse_transmit_0;
    float _S328 = bounded_gain_0(thread_gain_0(_S324, fabrics_0[_S322].colour_noise_0, fabrics_0[_S322].seed_0), _S327, 1.0f - fabrics_0[_S322].layer_bound_0 * _S326);
    float _S329 = bounded_gain_0(fibre_gain_0(_S324, _S325, fabrics_0[_S322].fibre_noise_0, fabrics_0[_S322].seed_0), _S326, min((1.0f - _S328 * _S327) / fabrics_0[_S322].layer_bound_0, (float3)1.0f));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S328 * _S323.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S328 * _S323.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S329 * _S323.specular_reflect_0;
    varied_0.specular_transmit_0 = _S329 * _S323.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S330, SurfacePoint_0 _S331, Albedos_0 _S332, float _S333, float _S334)
{
    float _S335;
    if(_S331.is_warp_2)
    {
        _S335 = _S333;
    }
    else
    {
        _S335 = _S334;
    }
    float _S336 = _S335 - _S331.across_2;
    uint _S337;
    if(_S331.is_warp_2)
    {
        _S337 = fabrics_0[_S330].warp_0;
    }
    else
    {
        _S337 = fabrics_0[_S330].weft_0;
    }
    Family_0 _S338 = families_0.Load(_S337);
    int _S339 = int(families_0.Load(_S337).count_0);
    if(_S331.is_warp_2)
    {
        _S337 = _S331.warp_thread_0;
    }
    else
    {
        _S337 = _S331.weft_thread_0;
    }
    uint _S340 = uint(int(floor(_S336 / _S338.period_0)) * _S339 + int(_S337)) * 2U;
    if(_S331.is_warp_2)
    {
        _S337 = 1U;
    }
    else
    {
        _S337 = 0U;
    }
    float _S341 = floor(_S331.fibre_across_0 / fabrics_0[_S330].fibre_size_0);
    return vary_albedos_0(_S330, _S332, _S340 + _S337, uint(int(_S341)) * 65536U + uint(int(floor(_S331.fibre_along_0 / (fabrics_0[_S330].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S341))));
}

YarnPoint_0 yarn_point_of_0(uint _S342, SurfacePoint_0 _S343, float _S344, float _S345, bool _S346, bool _S347)
{
    uint _S348;
    if(_S343.is_warp_2)
    {
        _S348 = fabrics_0[_S342].warp_0;
    }
    else
    {
        _S348 = fabrics_0[_S342].weft_0;
    }
    uint _S349;
    if(_S343.is_warp_2)
    {
        _S349 = _S343.warp_thread_0;
    }
    else
    {
        _S349 = _S343.weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S348, _S349);
    bool _S350;
    if((fabrics_0[_S342].fibre_noise_0) > 0.0f)
    {
        _S350 = true;
    }
    else
    {
        _S350 = (fabrics_0[_S342].colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_3;
    if(_S350)
    {
        albedos_3 = varied_at_0(_S342, _S343, albedos_2, _S344, _S345);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_1;
    point_1.back_5 = _S346;
    point_1.hole_2 = _S347;
    point_1.is_warp_1 = _S343.is_warp_2;
    point_1.x_7 = _S344;
    point_1.y_3 = _S345;
    point_1.height_3 = _S343.height_9;
    point_1.normal_3 = _S343.normal_4;
    point_1.tangent_4 = _S343.tangent_5;
    point_1.roughness_8 = families_0.Load(_S348).roughness_0;
    point_1.albedos_1 = albedos_3;
    return point_1;
}

YarnPoint_0 locate_yarn_0(uint _S351, SearchQuality_0 _S352, float _S353, float _S354, float3 _S355)
{
    bool _S356 = (_S355.z) < 0.0f;
    Hit_0 _S357 = first_hit_0(_S351, _S352, _S353, _S354, to_face_frame_0(_S355, _S356), _S356);
    return yarn_point_of_0(_S351, surface_at_0(_S351, _S357.x_8, _S357.y_4, _S356), _S357.x_8, _S357.y_4, _S356, _S357.hole_3);
}

float openness_number_0(uint _S358, uint _S359)
{
    return table_number_0(fabrics_0[_S358].openness_0 + _S359);
}

Blocked_0 blocked_of_terms_0(uint _S360, uint _S361, float  _S362[int(6)], uint _S363)
{
    float  shares_0[int(3)];
    uint share_1 = 0U;
    for(;;)
    {
        if(share_1 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_1] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S363)
            {
            }
            else
            {
                break;
            }
            shares_0[share_1] = shares_0[share_1] + openness_number_0(_S360, _S361 + share_1 * _S363 + term_0) * _S362[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_1] = saturate(shares_0[share_1]);
        share_1 = share_1 + 1U;
    }
    Blocked_0 blocked_1;
    blocked_1.by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    blocked_1.by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    blocked_1.far_0 = shares_0[int(1)];
    return blocked_1;
}

Blocked_0 blocked_at_0(uint _S364, bool _S365, bool _S366, float _S367, float _S368)
{
    float _S369 = _S368 * openness_number_0(_S364, 158U);
    float  terms_0[int(6)] = { 1.0f, _S367, _S369, _S367 * _S367, _S367 * _S369, _S369 * _S369 };
    uint _S370;
    if(_S366)
    {
        _S370 = 2U;
    }
    else
    {
        _S370 = 0U;
    }
    uint _S371;
    if(_S365)
    {
        _S371 = 0U;
    }
    else
    {
        _S371 = 1U;
    }
    return blocked_of_terms_0(_S364, 60U + (_S370 + _S371) * 18U, terms_0, 6U);
}

Scattered_0 scattered_by_0(uint _S372, Albedos_0 _S373, uint _S374, float3 _S375)
{
    uint _S376 = 159U + 2U * _S374;
    Scattered_0 yarn_3;
    yarn_3.back_4 = _S375 * _S373.diffuse_reflect_0 + openness_number_0(_S372, _S376) * _S373.specular_reflect_0;
    yarn_3.through_0 = _S375 * _S373.diffuse_transmit_0 + openness_number_0(_S372, _S376 + 1U) * _S373.specular_transmit_0;
    return yarn_3;
}

void sent_0(uint _S377, uint _S378, float3 _S379, float3 _S380, float3 _S381, float3 _S382, out float3 _S383, out float3 _S384)
{
    uint _S385 = 146U + 4U * _S378;
    float _S386 = openness_number_0(_S377, _S385 + 1U);
    float _S387 = openness_number_0(_S377, _S385 + 2U);
    float3 _S388 = 1.0f - _S381 * openness_number_0(_S377, _S385);
    float3 _S389 = 1.0f - _S382 * openness_number_0(_S377, _S385 + 3U);
    float3 _S390 = 1.0f / (_S388 * _S389 - _S381 * _S382 * (_S386 * _S387));
    _S383 = (_S379 * _S389 + _S381 * _S386 * _S380) * _S390;
    _S384 = (_S380 * _S388 + _S382 * _S387 * _S379) * _S390;
    return;
}

FaceSends_0 face_sends_0(uint _S391, uint _S392, Scattered_0 _S393, Scattered_0 _S394)
{
    uint _S395 = 2U * _S392;
    uint _S396 = 142U + _S395;
    float _S397 = openness_number_0(_S391, _S396);
    float _S398 = openness_number_0(_S391, _S396 + 1U);
    float3 _S399 = (1.0f - _S397) * _S393.back_4;
    float3 _S400 = (1.0f - _S398) * _S394.back_4;
    FaceSends_0 sends_1;
    uint _S401 = 154U + _S395;
    float _S402 = openness_number_0(_S391, _S401);
    sends_1.blocks_warp_0 = _S402;
    float _S403 = openness_number_0(_S391, _S401 + 1U);
    sends_1.blocks_weft_0 = _S403;
    sends_1.open_0 = _S402 * _S397 + _S403 * _S398;
    sent_0(_S391, _S392, _S397 * _S393.back_4, _S398 * _S394.back_4, _S399, _S400, sends_1.sky_warp_0, sends_1.sky_weft_0);
    sent_0(_S391, _S392, _S393.through_0, _S394.through_0, _S399, _S400, sends_1.crossing_warp_0, sends_1.crossing_weft_0);
    return sends_1;
}

Interior_0 interior_of_0(uint _S404, float3 _S405, bool _S406)
{
    Scattered_0 _S407 = scattered_by_0(_S404, table_albedos_0(families_0.Load(fabrics_0[_S404].warp_0).colour_mean_0), 0U, _S405);
    Scattered_0 _S408 = scattered_by_0(_S404, table_albedos_0(families_0.Load(fabrics_0[_S404].weft_0).colour_mean_0), 1U, _S405);
    uint _S409;
    if(_S406)
    {
        _S409 = 1U;
    }
    else
    {
        _S409 = 0U;
    }
    FaceSends_0 _S410 = face_sends_0(_S404, _S409, _S407, _S408);
    if(_S406)
    {
        _S409 = 0U;
    }
    else
    {
        _S409 = 1U;
    }
    FaceSends_0 _S411 = face_sends_0(_S404, _S409, _S407, _S408);
    float3 _S412 = _S410.blocks_warp_0 * _S410.crossing_warp_0 + _S410.blocks_weft_0 * _S410.crossing_weft_0;
    float3 _S413 = _S411.blocks_warp_0 * _S411.crossing_warp_0 + _S411.blocks_weft_0 * _S411.crossing_weft_0;
    float _S414 = 1.0f - _S410.open_0;
    float _S415 = 1.0f - _S411.open_0;
    float3 _S416 = 1.0f / (1.0f - _S412 * _S413 * (_S414 * _S415));
    float3 _S417 = _S413 * (_S410.open_0 + _S414 * (_S410.blocks_warp_0 * _S410.sky_warp_0 + _S410.blocks_weft_0 * _S410.sky_weft_0)) * _S416;
    float3 _S418 = _S412 * (_S411.open_0 + _S415 * (_S411.blocks_warp_0 * _S411.sky_warp_0 + _S411.blocks_weft_0 * _S411.sky_weft_0)) * _S416;
    FaceRadiance_0 _S419 = face_radiance_0(_S410, _S411.open_0, _S417, _S418);
    FaceRadiance_0 _S420 = face_radiance_0(_S411, _S410.open_0, _S418, _S417);
    Interior_0 interior_1;
    interior_1.warp_3 = _S419.warp_2;
    interior_1.weft_3 = _S419.weft_2;
    interior_1.leaked_1 = _S419.leaked_0;
    interior_1.far_1 = _S420.mean_0;
    interior_1.far_leaked_0 = _S420.leaked_0;
    return interior_1;
}

Bounced_0 bounced_at_0(uint _S421, YarnPoint_0 _S422, float3 _S423)
{
    Bounced_0 nothing_0;
    float3 _S424 = (float3)0.0f;
    nothing_0.reflected_0 = _S424;
    nothing_0.transmitted_0 = _S424;
    bool _S425;
    if((fabrics_0[_S421].openness_0) == 4294967295U)
    {
        _S425 = true;
    }
    else
    {
        _S425 = _S422.hole_2;
    }
    if(_S425)
    {
        return nothing_0;
    }
    Blocked_0 _S426 = blocked_at_0(_S421, _S422.is_warp_1, _S422.back_5, _S422.normal_3.z, _S422.height_3);
    uint _S427;
    if(_S422.is_warp_1)
    {
        _S427 = 0U;
    }
    else
    {
        _S427 = 1U;
    }
    return bounced_by_0(_S426, scattered_by_0(_S421, _S422.albedos_1, _S427, _S423), interior_of_0(_S421, _S423, _S422.back_5));
}

float3 scattered_0(uint _S428, YarnPoint_0 _S429, float3 _S430, float3 _S431)
{
    float3 _S432 = (float3)0.0f;
    bool _S433 = !_S429.hole_2;
    bool _S434;
    if(_S433)
    {
        _S434 = (_S430.z) > 0.0f;
    }
    else
    {
        _S434 = false;
    }
    float3 value_1;
    if(_S434)
    {
        value_1 = _S429.albedos_1.diffuse_reflect_0 * diffuse_reflection_0(_S430, _S429.normal_3, fabrics_0[_S428].diffuse_blend_0) + _S429.albedos_1.specular_reflect_0 * reflection_0(_S430, _S431, _S429.normal_3, _S429.tangent_4, _S429.roughness_8, fabrics_0[_S428].optical_depth_0);
    }
    else
    {
        if(_S433)
        {
            _S434 = (_S430.z) < 0.0f;
        }
        else
        {
            _S434 = false;
        }
        if(_S434)
        {
            value_1 = _S429.albedos_1.diffuse_transmit_0 * diffuse_reflection_0(- _S430, _S429.normal_3, fabrics_0[_S428].diffuse_blend_0) + _S429.albedos_1.specular_transmit_0 * transmission_1(_S430, _S431, _S429.normal_3, _S429.tangent_4, _S429.roughness_8, fabrics_0[_S428].optical_depth_0);
        }
        else
        {
            value_1 = _S432;
        }
    }
    float _S435 = fabrics_0[_S428].sheen_strength_0;
    if((fabrics_0[_S428].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S436 = sheen_with_transmittance_0(_S430, _S431, _S435, fabrics_0[_S428].sheen_roughness_0);
    return _S436.y * value_1 + _S436.x;
}

bool unoccluded_0(uint _S437, SearchQuality_0 _S438, float _S439, float _S440, float _S441, float3 _S442, bool _S443)
{
    if((_S442.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S437, _S438, float3(_S439, _S440, _S441 + fabrics_0[_S437].lift_0), _S442, _S443, max_height_along_0(_S437, _S439, _S440, _S441, _S442, _S443));
}

bool is_lit_0(uint _S444, SearchQuality_0 _S445, YarnPoint_0 _S446, float3 _S447)
{
    if(_S446.hole_2)
    {
        return true;
    }
    float3 _S448 = to_face_frame_0(_S447, _S446.back_5);
    float _S449 = _S448.z;
    bool _S450 = _S449 < 0.0f;
    float3 normal_5;
    float height_10;
    if(_S450)
    {
        SurfacePoint_0 _S451 = surface_at_0(_S444, _S446.x_7, _S446.y_3, !_S446.back_5);
        normal_5 = _S451.normal_4;
        height_10 = _S451.height_9;
    }
    else
    {
        normal_5 = _S446.normal_3;
        height_10 = _S446.height_3;
    }
    float3 _S452 = float3(_S448.xy, abs(_S449));
    if((dot(normal_5, _S452)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S444, _S445, _S446.x_7, _S446.y_3, height_10, _S452, (_S446.back_5) != _S450);
}

float3 evaluate_with_0(uint _S453, SearchQuality_0 _S454, YarnPoint_0 _S455, Bounced_0 _S456, float3 _S457, float3 _S458)
{
    float3 _S459 = to_face_frame_0(_S458, _S455.back_5);
    float3 _S460 = scattered_0(_S453, _S455, to_face_frame_0(_S457, _S455.back_5), _S459);
    bool _S461;
    if((max(_S460.x, max(_S460.y, _S460.z))) <= 0.0f)
    {
        _S461 = true;
    }
    else
    {
        _S461 = !is_lit_0(_S453, _S454, _S455, _S457);
    }
    float3 value_2;
    if(_S461)
    {
        value_2 = (float3)0.0f;
    }
    else
    {
        value_2 = _S460;
    }
    float3 between_1 = bounced_value_0(_S456, _S457, _S458);
    float _S462 = fabrics_0[_S453].sheen_strength_0;
    float3 between_2;
    if((fabrics_0[_S453].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * (1.0f - _S462 * sheen_lobe_0(abs(_S459.z), fabrics_0[_S453].sheen_roughness_0).z);
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

float3 evaluate_0(uint _S463, SearchQuality_0 _S464, YarnPoint_0 _S465, float3 _S466, float3 _S467)
{
    return evaluate_with_0(_S463, _S464, _S465, bounced_at_0(_S463, _S465, (float3)1.0f), _S466, _S467);
}

float straight_through_0(uint _S468, YarnPoint_0 _S469, float3 _S470)
{
    if(!_S469.hole_2)
    {
        return 0.0f;
    }
    float _S471 = fabrics_0[_S468].sheen_strength_0;
    if((fabrics_0[_S468].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S471 * sheen_lobe_0(abs(_S470.z), fabrics_0[_S468].sheen_roughness_0).z;
}

float4 cloth_value_0(uint fabric_1, float2 centre_0, float2 dx_0, float2 dy_0, float3 light_7, float3 view_6)
{
    SearchQuality_0 _S472 = default_quality_0();
    YarnPoint_0 _S473 = locate_yarn_0(fabric_1, _S472, centre_0.x, centre_0.y, view_6);
    return float4(evaluate_0(fabric_1, _S472, _S473, light_7, view_6), straight_through_0(fabric_1, _S473, view_6));
}

[numthreads(64, 1, 1)]
void point_queries(uint3 id_0 : SV_DispatchThreadID)
{
    if((id_0.x) >= query_count_0.Load(int(0)))
    {
        return;
    }
    Query_0 _S474 = queries_0.Load(id_0.x);
    answers_0[id_0.x] = cloth_value_0(_S474.fabric_0, float2(_S474.centre_x_0, _S474.centre_y_0), float2(_S474.dx_x_0, _S474.dx_y_0), float2(_S474.dy_x_0, _S474.dy_y_0), float3(_S474.light_x_0, _S474.light_y_0, _S474.light_z_0), float3(_S474.view_x_0, _S474.view_y_0, _S474.view_z_0));
    return;
}

