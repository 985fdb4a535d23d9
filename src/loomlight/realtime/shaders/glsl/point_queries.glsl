#version 450
layout(row_major) uniform;
layout(row_major) buffer;
layout(std430, binding = 1, set = 1) readonly buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} query_count_0;
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

layout(std430, binding = 0, set = 1) readonly buffer StructuredBuffer_Query_t_0 {
    Query_0 _data[];
} queries_0;
layout(std430, binding = 2, set = 1) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} answers_0;
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

layout(std430, binding = 0) readonly buffer StructuredBuffer_Fabric_t_0 {
    Fabric_0 _data[];
} fabrics_0;
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

layout(std430, binding = 1) readonly buffer StructuredBuffer_Family_t_0 {
    Family_0 _data[];
} families_0;
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_1 {
    uint _data[];
} words_0;
const float  PYRAMID_RADII_0[4] = float[](1.0, 2.0, 4.0, 8.0);
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
    quality_0.steps_per_thread_0 = 5.0;
    quality_0.steps_per_relief_0 = 8.0;
    quality_0.shadow_share_0 = 1.0;
    quality_0.refinements_0 = 2U;
    return quality_0;
}

vec3 to_face_frame_0(vec3 direction_0, bool back_1)
{
    vec2 _S1 = direction_0.xy;
    float _S2;
    if(back_1)
    {
        _S2 = - direction_0.z;
    }
    else
    {
        _S2 = direction_0.z;
    }
    return vec3(_S1, _S2);
}

vec2 turns_and_remainder_0(uint family_0, float index_0)
{
    float _S3 = floor(fma(index_0, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S3, fma(- _S3, families_0._data[uint(family_0)].count_0, index_0));
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
    float _S4 = floor(position_0 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S5 = fma(- _S4, families_0._data[uint(family_1)].size_0, position_0);
    cell_0.below_0 = _S5;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S5;
    cell_0.across_0 = _S5 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S4).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_0;
}

float table_number_0(uint index_1)
{
    return uintBitsToFloat(words_0._data[uint(index_1)]);
}

Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float turns_0 = (position_1 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S6 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S7;
    if(_S6 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S7 = 1U;
    }
    else
    {
        _S7 = 0U;
    }
    uint _S8 = min(thread_1 + _S7, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S9 = families_0._data[uint(family_2)].place_table_0 + _S8 * 4U;
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
    if((families_0._data[uint(family_3)].is_alike_0) != 0U)
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

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_2)
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
    shown_0.on_top_0 = ((_S13 & 1U) == 1U) != back_2;
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
    vec2 _S16 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    return fma(_S16.x, families_0._data[uint(family_4)].period_0, table_number_0(families_0._data[uint(family_4)].place_table_0 + uint(_S16.y) * 4U));
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0)
{
    if((families_0._data[uint(family_5)].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * families_0._data[uint(family_5)].size_0;
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
    Family_0 _S17 = families_0._data[uint(family_6)];
    uint _S18;
    if((families_0._data[uint(family_6)].is_alike_0) != 0U)
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
    int _S20 = int((word_1 >> 1) & 127U);
    int _S21 = int((word_1 >> 8) & 127U);
    int _S22 = int((word_1 >> 15) & 63U);
    int _S23 = int((word_1 >> 21) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> 27) & 1U) == 1U;
    int _S24 = - _S20;
    float _S25 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S24, 0);
    run_0.from_start_0 = _S25;
    int _S26 = _S21 + 1;
    float _S27 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, 1, _S26);
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
        _S31 = 1.0e+06;
    }
    else
    {
        _S31 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S31;
    run_0.reach_0 = min(0.5 * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5 * span_0(other_0, crossed_0.thread_0, _S29, _S30), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S20 == 0;
    run_0.last_crossing_0 = _S21 == 0;
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
    float _S32 = cell_3.half_width_1 * 1.0154266357421875;
    Section_0 section_0;
    float _S33 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S33;
    float _S34 = _S32 * _S32 - square_0(_S33);
    float _S35 = (inversesqrt((_S34)));
    section_0.drop_0 = _S32 - _S34 * _S35;
    section_0.slope_0 = - _S33 * _S35;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_6, int step_1)
{
    if((families_0._data[uint(family_7)].is_alike_0) != 0U)
    {
        return table_number_0(families_0._data[uint(family_7)].bend_table_0 + 3U);
    }
    return table_number_0(families_0._data[uint(family_7)].bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

vec2 dive_0(uint other_1, Shown_0 shown_1, Run_0 run_1, Cell_0 crossed_1)
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
        _S38 = 0.0;
    }
    else
    {
        _S38 = families_0._data[uint(other_1)].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, 0);
    }
    float _S41;
    if((shown_1.on_top_0) != _S40)
    {
        _S41 = 0.0;
    }
    else
    {
        Family_0 _S42 = families_0._data[uint(other_1)];
        int _S43;
        if(_S36)
        {
            _S43 = -1;
        }
        else
        {
            _S43 = 1;
        }
        _S41 = _S42.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S43);
    }
    float _S44 = 1.0 / max(2.0 * _S39, 9.999999960041972e-13);
    float _S45 = clamp((_S39 - _S37) * _S44, 0.0, 1.0);
    float _S46 = _S38 + (_S41 - _S38) * (_S45 * _S45 * (3.0 - 2.0 * _S45));
    float _S47 = (_S38 - _S41) * (6.0 * _S45 * (1.0 - _S45) * _S44);
    if(_S36)
    {
        _S38 = 1.0;
    }
    else
    {
        _S38 = -1.0;
    }
    return vec2(_S46, _S47 * _S38);
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

StepControl_0 step_control_0(vec2 direction_1, float step_3)
{
    StepControl_0 control_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129 * step_3;
    float _S48 = direction_1.x;
    control_0.per_x_0 = 1.0 / max(abs(_S48), 9.99999971718068537e-10);
    float _S49 = direction_1.y;
    control_0.per_y_0 = 1.0 / max(abs(_S49), 9.99999971718068537e-10);
    control_0.right_0 = _S48 > 0.0;
    control_0.up_0 = _S49 > 0.0;
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
    previous_0.clearance_0 = 0.0;
    previous_0.rate_0 = 0.0;
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
        _S50 = 2.0 * _S51 + _S50 - cell_4.half_width_1;
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
    float height_0;
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
        _S62 = (previous_1.rate_0) >= 0.0;
    }
    if(_S62)
    {
        _S62 = true;
    }
    else
    {
        _S62 = rate_1 <= 0.0;
    }
    if(_S62)
    {
        return -1.0;
    }
    if((3.0 * previous_1.clearance_0 + _S60) >= 0.0)
    {
        _S62 = (3.0 * clearance_1 - _S61) >= 0.0;
    }
    else
    {
        _S62 = false;
    }
    if(_S62)
    {
        return -1.0;
    }
    float _S63 = clearance_1 - previous_1.clearance_0;
    float _S64 = 6.0 * _S63 - 4.0 * _S60 - 2.0 * _S61;
    float _S65 = -2.0 * _S60 / max(_S64 + sqrt(max(_S64 * _S64 - 4.0 * (3.0 * (_S60 + _S61 - 2.0 * _S63)) * _S60, 0.0)), 9.99999968265522539e-21);
    float _S66 = 1.0 - _S65;
    float _S67 = (previous_1.clearance_0 * (2.0 * _S65 + 1.0) + _S60 * _S65) * _S66 * _S66;
    float _S68 = (clearance_1 * (2.0 * _S66 + 1.0) - _S61 * _S66) * _S65 * _S65;
    if(_S65 > 0.01999999955296516)
    {
        _S62 = _S66 > 0.01999999955296516;
    }
    else
    {
        _S62 = false;
    }
    if(_S62)
    {
        _S62 = (_S67 + _S68) < 0.0;
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
        _S69 = -1.0;
    }
    return _S69;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S70;
    if(here_1.hole_1)
    {
        _S70 = 1.0e+09;
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
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0) + this_0.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_1, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S72 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    bool _S73;
    if(!here_2.hole_1)
    {
        _S73 = (rate_3 * _S72 + clearance_3) < 0.0;
    }
    else
    {
        _S73 = false;
    }
    if(_S73)
    {
        _S73 = _S72 > (2.0 * this_1.epsilon_0);
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
        _S74 = max(_S72, 0.0) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S74);
}

struct ViewRay_0
{
    vec2 origin_0;
    vec2 slope_1;
};

vec2 ViewRay_at_0(ViewRay_0 this_2, float height_1)
{
    return this_2.origin_0 + this_2.slope_1 * height_1;
}

float ViewRay_rate_0(ViewRay_0 this_3, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_3.slope_1.x + here_3.slope_y_0 * this_3.slope_1.y - 1.0;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S75 = end_0 - start_1;
    float _S76 = start_rate_0 + end_rate_0 - 2.0 * _S75;
    float _S77 = 3.0 * _S75 - 2.0 * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S75, 9.99999968265522539e-21);
    int i_0 = 0;
    for(;;)
    {
        if(uint(i_0) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S78 = clamp(share_0 - (((_S76 * share_0 + _S77) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0 * _S76 * share_0 + 2.0 * _S77) * share_0 + start_rate_0, 0.10000000149011612 * _S75 - 9.99999968265522539e-21), 0.0, 1.0);
        int _S79 = i_0 + 1;
        share_0 = _S78;
        i_0 = _S79;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21), 0.01999999955296516, 0.98000001907348633) * (under_0 - above_1) + above_1;
}

vec2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S80 = along_slope_0 * along_slope_0 + 1.0;
    float _S81 = (inversesqrt((_S80)));
    float _S82 = sine_1 * _S81 * (inversesqrt((_S80 + across_slope_0 * across_slope_0)));
    return vec2(- _S82 * _S80, _S82 * across_slope_0 * along_slope_0 + cosine_0 * _S81);
}

float arc_sine_0(float x_1)
{
    float _S83 = abs(x_1);
    bool _S84 = _S83 > 0.5;
    float _S85;
    if(_S84)
    {
        _S85 = 0.5 * (1.0 - _S83);
    }
    else
    {
        _S85 = _S83 * _S83;
    }
    float _S86;
    if(_S84)
    {
        _S86 = sqrt(max(_S85, 0.0));
    }
    else
    {
        _S86 = _S83;
    }
    float _S87 = ((((0.04216320067644119 * _S85 + 0.02418131195008755) * _S85 + 0.04547002539038658) * _S85 + 0.07495300471782684) * _S85 + 0.16666752099990845) * _S85 * _S86 + _S86;
    if(_S84)
    {
        _S85 = 1.57079637050628662 - 2.0 * _S87;
    }
    else
    {
        _S85 = _S87;
    }
    if(x_1 < 0.0)
    {
        _S85 = - _S85;
    }
    return _S85;
}

vec3 table_colour_0(uint index_2)
{
    return vec3(table_number_0(index_2), table_number_0(index_2 + 1U), table_number_0(index_2 + 2U));
}

struct Albedos_0
{
    vec3 diffuse_reflect_0;
    vec3 diffuse_transmit_0;
    vec3 specular_reflect_0;
    vec3 specular_transmit_0;
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
    return table_albedos_0(families_0._data[uint(family_8)].albedo_table_0 + families_0._data[uint(family_8)].albedo_stride_0 * thread_7);
}

uint scramble_0(uint value_0)
{
    uint _S88 = value_0 * 747796405U + 2891336453U;
    uint _S89 = ((_S88 >> ((_S88 >> 28) + 4U)) ^ _S88) * 277803737U;
    return (_S89 >> 22) ^ _S89;
}

float uniform_hash_0(uint thread_8, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> 9) + 0.5) * 1.1920928955078125e-07;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0 * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0) + 1.0;
}

float bounded_gain_0(float gain_0, vec3 albedo_0, vec3 room_0)
{
    vec3 _S90 = room_0 / max(albedo_0, vec3(9.99999997475242708e-07));
    return min(gain_0, max(min(min(_S90.x, _S90.y), _S90.z), 0.0));
}

float natural_logarithm_0(float x_2)
{
    uint _S91 = floatBitsToUint(x_2);
    float exponent_0 = float(int(_S91 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S91 & 8388607U) | 1056964608U);
    float m_1;
    float exponent_1;
    if(m_0 < 0.70710676908493042)
    {
        float exponent_2 = exponent_0 - 1.0;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    float m_2 = m_1 - 1.0;
    float _S92 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S92 - exponent_1 * 0.00021219444170129 - 0.5 * _S92) + exponent_1 * 0.693359375;
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0) - 1.0) + 1.0;
}

float diffuse_reflection_0(vec3 light_0, vec3 normal_0, float blend_0)
{
    float _S93 = light_0.z;
    if(_S93 <= 0.0)
    {
        return 0.0;
    }
    return 0.31830987334251404 * mix(max(_S93, 0.0), max(dot(light_0, normal_0), 0.0), blend_0);
}

float projected_area_1(vec3 direction_2, vec3 tangent_0, float roughness_1)
{
    float _S94 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0) * (roughness_1 - 1.0) * _S94 * _S94 + 1.0, roughness_1 * roughness_1));
}

float exponential_0(float x_3)
{
    float _S95 = clamp(x_3, -87.0, 88.0);
    float _S96 = floor(_S95 * 1.4426950216293335 + 0.5);
    float _S97 = _S95 - _S96 * 0.693359375 + _S96 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S97 + 0.00139819993637502) * _S97 + 0.00833345204591751) * _S97 + 0.04166579619050026) * _S97 + 0.1666666567325592) * _S97 + 0.5;
    float _S98 = uintBitsToFloat(uint(int(_S96) + 127) << 23);
    float _S99;
    if(x_3 < -87.0)
    {
        _S99 = 0.0;
    }
    else
    {
        _S99 = (p_0 * _S97 * _S97 + _S97 + 1.0) * _S98;
    }
    return _S99;
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612)
    {
        return (((depth_0 / 120.0 - 0.0416666679084301) * depth_0 + 0.1666666716337204) * depth_0 - 0.5) * depth_0 + 1.0;
    }
    return (1.0 - exponential_0(- depth_0)) / depth_0;
}

float square_1(vec3 v_0)
{
    return dot(v_0, v_0);
}

float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S100 = roughness_2 * roughness_2;
    float _S101 = squared_along_0 * (1.0 - _S100) + _S100;
    return 0.31830987334251404 * _S100 * roughness_2 / (_S101 * _S101);
}

float density_between_0(vec3 light_1, vec3 view_0, vec3 tangent_1, float roughness_3)
{
    vec3 _S102 = light_1 + view_0;
    float _S103 = dot(_S102, tangent_1);
    return flake_density_0(min(_S103 * _S103 / max(square_1(_S102), 9.999999960041972e-13), 1.0), roughness_3);
}

float reflection_0(vec3 light_2, vec3 view_1, vec3 normal_1, vec3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S104 = dot(light_2, normal_1);
    bool _S105;
    if(_S104 <= 0.0)
    {
        _S105 = true;
    }
    else
    {
        _S105 = (dot(view_1, normal_1)) <= 0.0;
    }
    if(_S105)
    {
        return 0.0;
    }
    float _S106 = max(_S104, 9.99999997475242708e-07);
    float _S107 = max(dot(view_1, normal_1), 9.99999997475242708e-07);
    float _S108 = projected_area_1(light_2, tangent_2, roughness_4) * _S107 + projected_area_1(view_1, tangent_2, roughness_4) * _S106;
    float _S109 = optical_depth_1 * _S108 / (_S106 * _S107);
    return 0.25 * density_between_0(light_2, view_1, tangent_2, roughness_4) * (_S109 * mean_attenuation_0(_S109)) * _S106 / _S108;
}

float transmission_0(vec3 light_3, vec3 view_2, vec3 normal_2, vec3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S110 = - dot(light_3, normal_2);
    float _S111 = dot(view_2, normal_2);
    bool _S112;
    if(_S110 <= 0.0)
    {
        _S112 = true;
    }
    else
    {
        _S112 = _S111 <= 0.0;
    }
    if(_S112)
    {
        return 0.0;
    }
    float _S113 = 1.0 / max(_S111, 9.99999997475242708e-07);
    float _S114 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S110, 9.99999997475242708e-07);
    float _S115 = projected_area_1(view_2, tangent_3, roughness_5) * _S113;
    return density_between_0(light_3, view_2, tangent_3, roughness_5) * 0.25 * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S114, _S115)) * mean_attenuation_0(optical_depth_2 * abs(_S114 - _S115)) * _S113;
}

float sheen_scale_0(float x_4, float y_0)
{
    return (((((0.0 * x_4 + (((((-1.1402510404586792 * y_0 + 0.40672621130943298) * y_0 + 1.65398800373077393) * y_0 + -1.29730904102325439) * y_0 + 0.30570998787879944) * y_0 + -0.0220868494361639)) * x_4 + (((((-0.21142719686031342 * y_0 + 1.05947399139404297) * y_0 + -0.41116121411323547) * y_0 + -0.93859231472015381) * y_0 + 0.51606941223144531) * y_0 + 0.05409301072359085)) * x_4 + (((((1.22944498062133789 * y_0 + -0.45962560176849365) * y_0 + -1.63861405849456787) * y_0 + 1.33565104007720947) * y_0 + -0.45725581049919128) * y_0 + 0.08243165910243988)) * x_4 + (((((0.39779931306838989 * y_0 + -1.18879103660583496) * y_0 + 0.28251591324806213) * y_0 + 1.168984055519104) * y_0 + -0.76864629983901978) * y_0 + 0.0091691892594099)) * x_4 + (((((-0.26563560962677002 * y_0 + -0.19379159808158875) * y_0 + 0.2677634060382843) * y_0 + 0.00270519289188087) * y_0 + 0.14349560439586639) * y_0 + 0.10290180146694183)) * x_4 + (((((-0.20701569318771362 * y_0 + 0.24526430666446686) * y_0 + 0.19551840424537659) * y_0 + 0.07586126774549484) * y_0 + 0.38894739747047424) * y_0 + 0.15043120086193085);
}

float sheen_shear_0(float x_5, float y_1)
{
    return ((((0.0 * x_5 + (((((-0.10608240216970444 * y_1 + 1.99214303493499756) * y_1 + -1.42255294322967529) * y_1 + -1.09495604038238525) * y_1 + 0.59180057048797607) * y_1 + 0.06902855634689331)) * x_5 + (((((-0.46220690011978149 * y_1 + -0.29113379120826721) * y_1 + 1.39025199413299561) * y_1 + 0.35589990019798279) * y_1 + -1.17120099067687988) * y_1 + 0.15940259397029877)) * x_5 + (((((2.26068711280822754 * y_1 + -3.64728999137878418) * y_1 + -0.72173482179641724) * y_1 + 3.07659196853637695) * y_1 + -0.6827620267868042) * y_1 + -0.3039557933807373)) * x_5 + (((((0.81201767921447754 * y_1 + 0.36014080047607422) * y_1 + -1.72646903991699219) * y_1 + -0.22630110383033752) * y_1 + 0.89514690637588501) * y_1 + -0.10397960245609283)) * x_5 + (((((-0.37648698687553406 * y_1 + 1.10974001884460449) * y_1 + 0.17824520170688629) * y_1 + -1.04968702793121338) * y_1 + 0.1461234986782074) * y_1 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_6, float y_2)
{
    return ((((0.0 * x_6 + (((((12.95646953582763672 * y_2 + -21.38032913208007812) * y_2 + -7.37853097915649414) * y_2 + 34.55607986450195312) * y_2 + -23.61347007751464844) * y_2 + 5.00126314163208008)) * x_6 + (((((10.91487026214599609 * y_2 + -6.08202791213989258) * y_2 + -38.2036285400390625) * y_2 + 53.3440399169921875) * y_2 + -21.91996002197265625) * y_2 + 2.01606011390686035)) * x_6 + (((((-14.52206039428710938 * y_2 + 36.803619384765625) * y_2 + -22.94047927856445312) * y_2 + -10.07973003387451172) * y_2 + 15.77003955841064453) * y_2 + -4.92722177505493164)) * x_6 + (((((-7.62505722045898438 * y_2 + 1.27310299873352051) * y_2 + 31.19523048400878906) * y_2 + -44.39989852905273438) * y_2 + 26.44947052001953125) * y_2 + -8.73507976531982422)) * x_6 + (((((5.65633487701416016 * y_2 + -17.66820907592773438) * y_2 + 24.65356063842773438) * y_2 + -19.38941001892089844) * y_2 + 11.06159019470214844) * y_2 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S116 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S117 = 2.0 * sqrt(_S116) - 1.0;
    float _S118 = 3.0 * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S117, _S118), 0.00999999977648258, 1.0), clamp((1.0 - _S116) * sheen_shear_0(_S117, _S118), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S117, _S118), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_4, vec3 view_3, float scale_0, float shear_0)
{
    float _S119 = light_4.z;
    bool _S120;
    if(_S119 <= 0.0)
    {
        _S120 = true;
    }
    else
    {
        _S120 = (view_3.z) <= 0.0;
    }
    if(_S120)
    {
        return 0.0;
    }
    vec2 _S121 = view_3.xy;
    float _S122 = dot(_S121, _S121);
    vec2 _S123;
    if(_S122 > 9.99999968265522539e-21)
    {
        _S123 = _S121 * (inversesqrt((_S122)));
    }
    else
    {
        _S123 = vec2(1.0, 0.0);
    }
    float _S124 = scale_0 * dot(light_4.xy, _S123) + shear_0 * _S119;
    float _S125 = scale_0 * (light_4.y * _S123.x - light_4.x * _S123.y);
    float _S126 = _S124 * _S124 + _S125 * _S125 + _S119 * _S119;
    return 0.31830987334251404 * scale_0 * scale_0 * _S119 / max(_S126 * _S126, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_5, vec3 view_4, float strength_0, float roughness_7)
{
    vec3 _S127 = sheen_lobe_0(view_4.z, roughness_7);
    float _S128 = strength_0 * _S127.z;
    return vec2(_S128 * transformed_cosine_0(light_5, view_4, _S127.x, _S127.y), 1.0 - _S128);
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_2;
    bool is_warp_1;
    float x_7;
    float y_3;
    float height_2;
    vec3 normal_3;
    vec3 tangent_4;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_8;
    float y_4;
    bool hole_3;
    float height_3;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_4;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S129, float _S130, float _S131, bool _S132)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0._data[uint(_S129)].warp_0, _S130);
    crossing_2.weft_1 = locate_0(fabrics_0._data[uint(_S129)].weft_0, _S131);
    uint _S133 = fabrics_0._data[uint(_S129)].run_words_0 + 2U * (crossing_2.weft_1.thread_0 * fabrics_0._data[uint(_S129)].ends_1 + crossing_2.warp_1.thread_0);
    uint _S134 = words_0._data[uint(_S133)];
    crossing_2.warp_word_0 = _S134;
    crossing_2.weft_word_0 = words_0._data[uint(_S133 + 1U)];
    crossing_2.warp_above_0 = ((_S134 & 1U) == 1U) != _S132;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S135, float _S136, float _S137, bool _S138)
{
    Sample_0 sample_0;
    Crossing_0 _S139 = crossing_at_0(_S135, _S136, _S137, _S138);
    sample_0.crossing_1 = _S139;
    Shown_0 _S140 = shown_at_0(_S139, _S138);
    sample_0.shown_3 = _S140;
    uint _S141;
    if(_S140.is_warp_0)
    {
        _S141 = fabrics_0._data[uint(_S135)].warp_0;
    }
    else
    {
        _S141 = fabrics_0._data[uint(_S135)].weft_0;
    }
    uint _S142;
    if(_S140.is_warp_0)
    {
        _S142 = fabrics_0._data[uint(_S135)].weft_0;
    }
    else
    {
        _S142 = fabrics_0._data[uint(_S135)].warp_0;
    }
    Cell_0 _S143 = select_cell_0(_S140.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    Cell_0 _S144 = select_cell_0(_S140.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    Run_0 _S145 = unpack_0(_S141, _S142, _S143.thread_0, _S144, _S140.word_0);
    Section_0 _S146 = section_at_0(_S143);
    bool _S147;
    if(_S140.on_top_0)
    {
        _S147 = (_S145.distance_0) < (_S146.drop_0 * _S145.bend_1.sine_0);
    }
    else
    {
        _S147 = false;
    }
    bool _S148;
    if(_S140.on_top_0)
    {
        _S148 = !_S147;
    }
    else
    {
        _S148 = false;
    }
    float _S149;
    if(_S148)
    {
        _S149 = 1.0;
    }
    else
    {
        _S149 = -1.0;
    }
    float _S150;
    if(_S147)
    {
        _S150 = _S145.other_reach_0;
    }
    else
    {
        _S150 = _S145.reach_0;
    }
    float _S151;
    if(_S147)
    {
        _S151 = _S150 + _S145.distance_0;
    }
    else
    {
        _S151 = max(_S150 - _S145.distance_0, 0.0);
    }
    float _S152 = _S150 / _S145.bend_1.sine_0 - _S149 * _S146.drop_0;
    float _S153 = _S151 * _S151;
    float _S154 = max(_S152 * _S152 - _S153, 9.99999968265522539e-21);
    float _S155 = (inversesqrt((_S154)));
    float _S156 = _S153 / (_S154 * _S155 + _S152);
    bool _S157 = _S151 > 0.0;
    float _S158;
    if(_S140.on_top_0)
    {
        _S158 = 1.0;
    }
    else
    {
        _S158 = -1.0;
    }
    float _S159;
    if(_S145.near_start_0)
    {
        _S159 = 1.0;
    }
    else
    {
        _S159 = -1.0;
    }
    float _S160 = _S158 * _S159;
    if(_S157)
    {
        _S158 = _S152 * _S155;
    }
    else
    {
        _S158 = 1.0;
    }
    sample_0.slope_across_0 = _S146.slope_0 * _S158;
    if(_S157)
    {
        _S151 = _S160 * _S151 * _S155;
    }
    else
    {
        _S151 = 0.0;
    }
    sample_0.slope_along_0 = _S151;
    Family_0 _S161 = families_0._data[uint(_S141)];
    vec2 _S162 = dive_0(_S142, _S140, _S145, _S144);
    if(_S145.straight_0)
    {
        _S149 = 0.0;
    }
    else
    {
        _S149 = _S161.height_scale_0 * _S149;
    }
    sample_0.height_4 = _S149 * (_S150 * _S145.bend_1.half_tangent_0 - _S156) - _S161.height_scale_0 * _S146.drop_0 - _S162.x;
    float _S163 = _S161.height_scale_0 * sample_0.slope_across_0;
    float _S164 = _S161.height_scale_0 * sample_0.slope_along_0 - _S162.y;
    if(_S140.is_warp_0)
    {
        _S149 = _S163;
    }
    else
    {
        _S149 = _S164;
    }
    sample_0.slope_x_1 = _S149;
    if(_S140.is_warp_0)
    {
        _S149 = _S164;
    }
    else
    {
        _S149 = _S163;
    }
    sample_0.slope_y_1 = _S149;
    sample_0.run_3 = _S145;
    sample_0.section_1 = _S146;
    return sample_0;
}

float steps_per_length_0(uint _S165, SearchQuality_0 _S166, vec3 _S167)
{
    return max(max(abs(_S167.x) * fabrics_0._data[uint(_S165)].threads_per_x_0, abs(_S167.y) * fabrics_0._data[uint(_S165)].threads_per_y_0) * _S166.steps_per_thread_0, abs(_S167.z) * fabrics_0._data[uint(_S165)].per_relief_0 * _S166.steps_per_relief_0);
}

float cell_maximum_0(uint _S168, Crossing_0 _S169)
{
    uint _S170;
    if(_S169.warp_above_0)
    {
        _S170 = fabrics_0._data[uint(_S168)].warp_0;
    }
    else
    {
        _S170 = fabrics_0._data[uint(_S168)].weft_0;
    }
    uint _S171;
    if(_S169.warp_above_0)
    {
        _S171 = _S169.warp_word_0;
    }
    else
    {
        _S171 = _S169.weft_word_0;
    }
    return float(_S171 >> 28) * families_0._data[uint(_S170)].height_scale_0 * families_0._data[uint(_S170)].level_0;
}

Probe_0 probe_0(uint _S172, float _S173, float _S174, bool _S175, bool _S176, bool _S177)
{
    Sample_0 _S178 = sample_at_0(_S172, _S173, _S174, _S175);
    Probe_0 probe_1;
    probe_1.height_0 = _S178.height_4;
    probe_1.hole_1 = _S178.shown_3.hole_0;
    probe_1.slope_x_0 = _S178.slope_x_1;
    probe_1.slope_y_0 = _S178.slope_y_1;
    uint _S179;
    if(_S178.shown_3.is_warp_0)
    {
        _S179 = _S178.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S179 = _S178.crossing_1.weft_1.thread_0 * 2U;
    }
    probe_1.yarn_1 = _S179;
    probe_1.cell_max_0 = cell_maximum_0(_S172, _S178.crossing_1);
    float _S180;
    if(_S176)
    {
        _S180 = _S178.crossing_1.warp_1.above_0;
    }
    else
    {
        _S180 = _S178.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S180;
    if(_S177)
    {
        _S180 = _S178.crossing_1.weft_1.above_0;
    }
    else
    {
        _S180 = _S178.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S180;
    probe_1.edge_x_0 = outline_distance_0(_S178.crossing_1.warp_1, _S178.shown_3, _S178.run_3, !_S178.shown_3.is_warp_0, _S176);
    probe_1.edge_y_0 = outline_distance_0(_S178.crossing_1.weft_1, _S178.shown_3, _S178.run_3, _S178.shown_3.is_warp_0, _S177);
    return probe_1;
}

bool is_free_0(uint _S181, SearchQuality_0 _S182, vec3 _S183, vec3 _S184, bool _S185, float _S186)
{
    float _S187 = _S184.z;
    if(_S187 <= 0.0)
    {
        return false;
    }
    float _S188 = 1.0 / max(_S182.shadow_share_0 * steps_per_length_0(_S181, _S182, _S184), 9.99999971718068537e-10);
    StepControl_0 _S189 = step_control_0(_S184.xy, _S188);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0;
    float last_step_0 = 0.0;
    for(;;)
    {
        bool _S190;
        if(count_1 < 1024U)
        {
            _S190 = (_S183.z + _S187 * distance_1) < _S186;
        }
        else
        {
            _S190 = false;
        }
        if(_S190)
        {
        }
        else
        {
            break;
        }
        vec3 _S191 = _S183 + _S184 * distance_1;
        Probe_0 _S192 = probe_0(_S181, _S191.x, _S191.y, _S185, _S189.right_0, _S189.up_0);
        float _S193 = _S191.z;
        float _S194 = _S193 - _S192.height_0;
        float _S195 = _S187 - _S192.slope_x_0 * _S184.x - _S192.slope_y_0 * _S184.y;
        bool _S196;
        if(!_S192.hole_1)
        {
            _S196 = _S194 < 0.0;
        }
        else
        {
            _S196 = false;
        }
        if(_S196)
        {
            return false;
        }
        float _S197 = way_back_to_dip_0(previous_3, _S194, _S195, last_step_0, _S192);
        if(_S197 >= 0.0)
        {
            float last_step_1 = last_step_0 - _S197;
            distance_1 = distance_1 - _S197;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S198 = _S193 > (_S192.cell_max_0);
        PreviousSample_0 _S199 = after_sample_0(_S194, _S195, _S192, _S198);
        float last_step_2;
        if(_S198)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S189, _S192.side_x_0, _S192.side_y_0), _S188);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S189, _S192, _S194, _S195);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S199;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S200, SearchQuality_0 _S201, float _S202, float _S203, vec3 _S204, bool _S205)
{
    if(!sample_at_0(_S200, _S202, _S203, _S205).shown_3.hole_0)
    {
        return false;
    }
    vec3 _S206 = vec3(_S202, _S203, 0.0);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S207;
        if(side_0 < 2U)
        {
            _S207 = passes_0;
        }
        else
        {
            _S207 = false;
        }
        if(_S207)
        {
        }
        else
        {
            break;
        }
        vec3 _S208;
        if(side_0 == 0U)
        {
            _S208 = _S204;
        }
        else
        {
            _S208 = vec3(- _S204.x, - _S204.y, _S204.z);
        }
        bool _S209 = is_free_0(_S200, _S201, _S206, _S208, _S205 != (side_0 == 1U), fabrics_0._data[uint(_S200)].height_high_0);
        uint _S210 = side_0 + 1U;
        passes_0 = _S209;
        side_0 = _S210;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_5;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

float max_height_along_0(uint _S211, float _S212, float _S213, float _S214, vec3 _S215, bool _S216)
{
    uint _S217 = locate_0(fabrics_0._data[uint(_S211)].warp_0, _S212).thread_0 / 2U;
    uint _S218 = locate_0(fabrics_0._data[uint(_S211)].weft_0, _S213).thread_0 / 2U;
    float _S219 = _S215.x;
    uint _S220;
    if(_S219 > 0.0)
    {
        _S220 = 1U;
    }
    else
    {
        _S220 = 0U;
    }
    float _S221 = _S215.y;
    uint _S222;
    if(_S221 > 0.0)
    {
        _S222 = 2U;
    }
    else
    {
        _S222 = 0U;
    }
    uint _S223 = words_0._data[uint(fabrics_0._data[uint(_S211)].max_heights_0 + 4U * (_S218 * fabrics_0._data[uint(_S211)].max_height_columns_0 + _S217) + (_S220 + _S222))];
    int number_0;
    if(_S216)
    {
        number_0 = 4;
    }
    else
    {
        number_0 = 0;
    }
    uint _S224 = _S223 >> number_0;
    float _S225 = max(abs(_S219) * fabrics_0._data[uint(_S211)].threads_per_x_0, abs(_S221) * fabrics_0._data[uint(_S211)].threads_per_y_0) / _S215.z;
    float _S226 = fabrics_0._data[uint(_S211)].height_high_0;
    float max_height_0 = fabrics_0._data[uint(_S211)].height_high_0;
    number_0 = 3;
    for(;;)
    {
        if(number_0 >= 0)
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S214) * _S225) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S224 >> uint(8 * number_0)) & 15U) * 0.06666667014360428 * _S226);
        }
        number_0 = number_0 - 1;
    }
    return max_height_0;
}

vec3 cell_bounds_0(uint _S227, float _S228, float _S229, bool _S230, bool _S231, bool _S232)
{
    Crossing_0 _S233 = crossing_at_0(_S227, _S228, _S229, _S230);
    float _S234 = cell_maximum_0(_S227, _S233);
    float _S235;
    if(_S231)
    {
        _S235 = _S233.warp_1.above_0;
    }
    else
    {
        _S235 = _S233.warp_1.below_0;
    }
    float _S236;
    if(_S232)
    {
        _S236 = _S233.weft_1.above_0;
    }
    else
    {
        _S236 = _S233.weft_1.below_0;
    }
    return vec3(_S234, _S235, _S236);
}

float first_sample_height_0(uint _S237, ViewRay_0 _S238, StepControl_0 _S239, bool _S240)
{
    float _S241 = max_height_along_0(_S237, _S238.origin_0.x, _S238.origin_0.y, 0.0, vec3(_S238.slope_1, 1.0), _S240);
    uint count_2 = 0U;
    float height_6 = _S241;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S242 = ViewRay_at_0(_S238, height_6);
        vec3 _S243 = cell_bounds_0(_S237, _S242.x, _S242.y, _S240, _S239.right_0, _S239.up_0);
        float _S244 = height_6 - _S243.x;
        float _S245 = StepControl_to_cell_exit_0(_S239, _S243.y, _S243.z);
        float height_7 = height_6 - clamp(_S244, 0.0, _S245);
        if(_S244 <= _S245)
        {
            height_6 = height_7;
            break;
        }
        count_2 = count_2 + 1U;
        height_6 = height_7;
    }
    return height_6;
}

ViewRayEnd_0 search_down_0(uint _S246, ViewRay_0 _S247, StepControl_0 _S248, bool _S249)
{
    float _S250 = fabrics_0._data[uint(_S246)].height_low_0 - (fabrics_0._data[uint(_S246)].height_high_0 - fabrics_0._data[uint(_S246)].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_5 = first_sample_height_0(_S246, _S247, _S248, _S249);
    end_1.last_step_3 = _S248.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0;
    end_1.rate_4 = 0.0;
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
        vec2 _S251 = ViewRay_at_0(_S247, end_1.height_5);
        Probe_0 _S252 = probe_0(_S246, _S251.x, _S251.y, _S249, _S248.right_0, _S248.up_0);
        float _S253 = end_1.height_5 - _S252.height_0;
        float _S254 = ViewRay_rate_0(_S247, _S252);
        end_1.depth_1 = - _S253;
        end_1.rate_4 = _S254;
        bool _S255;
        if(end_1.previous_4.known_0)
        {
            _S255 = !_S252.hole_1;
        }
        else
        {
            _S255 = false;
        }
        bool _S256;
        if(_S255)
        {
            _S256 = (end_1.previous_4.yarn_0) == (_S252.yarn_1);
        }
        else
        {
            _S256 = false;
        }
        end_1.smooth_0 = _S256;
        bool _S257;
        if(!_S252.hole_1)
        {
            _S257 = _S253 <= 0.0;
        }
        else
        {
            _S257 = false;
        }
        bool _S258;
        if(_S257)
        {
            _S258 = true;
        }
        else
        {
            _S258 = (end_1.height_5) <= _S250;
        }
        if(_S258)
        {
            break;
        }
        float _S259 = way_back_to_dip_0(end_1.previous_4, _S253, _S254, end_1.last_step_3, _S252);
        if(_S259 >= 0.0)
        {
            end_1.height_5 = end_1.height_5 + _S259;
            end_1.last_step_3 = end_1.last_step_3 - _S259;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S260 = min(StepControl_to_cell_exit_0(_S248, _S252.side_x_0, _S252.side_y_0), end_1.height_5 - _S252.cell_max_0);
        float _S261 = StepControl_to_next_sample_0(_S248, _S252, _S253, _S254);
        end_1.previous_4 = after_sample_0(_S253, _S254, _S252, _S260 > _S261);
        float _S262 = max(_S260, _S261);
        end_1.last_step_3 = _S262;
        end_1.height_5 = end_1.height_5 - _S262;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S263, ViewRay_0 _S264, StepControl_0 _S265, bool _S266, ViewRayEnd_0 _S267, uint _S268)
{
    float _S269 = fabrics_0._data[uint(_S263)].height_high_0 - fabrics_0._data[uint(_S263)].height_low_0;
    float above_2 = _S267.height_5 + _S267.last_step_3;
    float above_gap_1 = clamp(_S267.previous_4.clearance_0, 0.0, _S269);
    float under_gap_1 = clamp(_S267.depth_1, 0.0, _S269);
    float _S270 = cubic_root_0(above_gap_1, - under_gap_1, _S267.previous_4.rate_0 * _S267.last_step_3, _S267.rate_4 * _S267.last_step_3);
    float middle_0;
    if(_S267.smooth_0)
    {
        middle_0 = above_2 - _S270 * _S267.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S267.height_5, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S267.height_5;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S268)
        {
        }
        else
        {
            break;
        }
        vec2 _S271 = ViewRay_at_0(_S264, middle_0);
        Probe_0 _S272 = probe_0(_S263, _S271.x, _S271.y, _S266, _S265.right_0, _S265.up_0);
        float _S273;
        if(_S272.hole_1)
        {
            _S273 = -1.0e+09;
        }
        else
        {
            _S273 = _S272.height_0;
        }
        float _S274 = clamp(middle_0 - _S273, - _S269, _S269);
        float _S275;
        if(_S274 <= 0.0)
        {
            if(side_1 > 0.0)
            {
                _S275 = 0.5 * above_gap_2;
            }
            else
            {
                _S275 = above_gap_2;
            }
            float _S276 = - _S274;
            under_1 = middle_0;
            above_gap_2 = _S275;
            under_gap_2 = _S276;
            side_1 = 1.0;
        }
        else
        {
            if(side_1 < 0.0)
            {
                _S275 = 0.5 * under_gap_2;
            }
            else
            {
                _S275 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S274;
            under_gap_2 = _S275;
            side_1 = -1.0;
        }
        if(_S267.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S274 / min(ViewRay_rate_0(_S264, _S272), -9.99999997475242708e-07), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S267.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S277, SearchQuality_0 _S278, float _S279, float _S280, vec3 _S281, bool _S282)
{
    float _S283 = max(_S281.z, 0.00009999999747379);
    ViewRay_0 ray_0;
    ray_0.origin_0 = vec2(_S279, _S280);
    vec2 _S284 = _S281.xy / _S283;
    ray_0.slope_1 = _S284;
    StepControl_0 _S285 = step_control_0(- _S284, 1.0 / max(steps_per_length_0(_S277, _S278, _S281) / _S283, 9.99999971718068537e-10));
    ViewRayEnd_0 _S286 = search_down_0(_S277, ray_0, _S285, _S282);
    Hit_0 hit_0;
    hit_0.hole_3 = false;
    float _S287 = refined_height_0(_S277, ray_0, _S285, _S282, _S286, _S278.refinements_0);
    hit_0.height_3 = _S287;
    vec2 _S288 = ViewRay_at_0(ray_0, _S287);
    hit_0.x_8 = _S288.x;
    hit_0.y_4 = _S288.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S289, SearchQuality_0 _S290, float _S291, float _S292, vec3 _S293, bool _S294)
{
    if(!passes_through_0(_S289, _S290, _S291, _S292, _S293, _S294))
    {
        return first_hit_of_yarn_0(_S289, _S290, _S291, _S292, _S293, _S294);
    }
    Hit_0 hit_1;
    hit_1.x_8 = _S291;
    hit_1.y_4 = _S292;
    hit_1.height_3 = 0.0;
    hit_1.hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_2;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_8;
    vec3 normal_4;
    vec3 tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 surface_at_0(uint _S295, float _S296, float _S297, bool _S298)
{
    Sample_0 _S299 = sample_at_0(_S295, _S296, _S297, _S298);
    float _S300;
    if(_S299.shown_3.is_warp_0)
    {
        _S300 = _S299.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S300 = _S299.crossing_1.weft_1.half_width_1;
    }
    uint _S301;
    if(_S299.shown_3.is_warp_0)
    {
        _S301 = fabrics_0._data[uint(_S295)].warp_0;
    }
    else
    {
        _S301 = fabrics_0._data[uint(_S295)].weft_0;
    }
    Family_0 _S302 = families_0._data[uint(_S301)];
    float _S303;
    if(_S298)
    {
        _S303 = -1.0;
    }
    else
    {
        _S303 = 1.0;
    }
    float _S304 = _S302.twist_sine_0 * _S303;
    Family_0 _S305 = families_0._data[uint(_S301)];
    if(_S299.shown_3.is_warp_0)
    {
        _S303 = 1.0;
    }
    else
    {
        _S303 = -1.0;
    }
    vec2 _S306 = fibre_direction_0(_S299.slope_across_0, _S303 * _S299.slope_along_0, _S304, _S305.twist_cosine_0);
    float _S307;
    if(_S299.shown_3.is_warp_0)
    {
        _S307 = _S299.slope_x_1;
    }
    else
    {
        _S307 = _S299.slope_y_1;
    }
    float _S308;
    if(_S299.shown_3.is_warp_0)
    {
        _S308 = _S299.slope_y_1;
    }
    else
    {
        _S308 = _S299.slope_x_1;
    }
    float _S309 = _S306.x;
    float _S310 = _S306.y;
    float _S311 = _S307 * _S309 + _S303 * _S308 * _S310;
    float _S312 = _S300 * 1.0154266357421875;
    float _S313 = _S312 * arc_sine_0(clamp(_S299.section_1.across_1 / _S312, -1.0, 1.0));
    if(_S299.shown_3.is_warp_0)
    {
        _S300 = _S297;
    }
    else
    {
        _S300 = - _S296;
    }
    SurfacePoint_0 point_0;
    point_0.hole_4 = _S299.shown_3.hole_0;
    point_0.is_warp_2 = _S299.shown_3.is_warp_0;
    point_0.warp_thread_0 = _S299.crossing_1.warp_1.thread_0;
    point_0.weft_thread_0 = _S299.crossing_1.weft_1.thread_0;
    point_0.height_8 = _S299.height_4;
    point_0.normal_4 = normalize(vec3(- _S299.slope_x_1, - _S299.slope_y_1, 1.0));
    vec3 _S314;
    if(_S299.shown_3.is_warp_0)
    {
        _S314 = vec3(_S309, _S310, _S311);
    }
    else
    {
        _S314 = vec3(- _S310, _S309, _S311);
    }
    point_0.tangent_5 = normalize(_S314);
    point_0.across_2 = _S299.section_1.across_1;
    point_0.fibre_across_0 = _S313 * _S305.twist_cosine_0 + _S300 * _S304;
    point_0.fibre_along_0 = _S300 * _S305.twist_cosine_0 - _S313 * _S304;
    return point_0;
}

Albedos_0 vary_albedos_0(uint _S315, Albedos_0 _S316, uint _S317, uint _S318)
{
    vec3 _S319 = max(_S316.specular_reflect_0, _S316.specular_transmit_0);
    vec3 _S320 = _S316.diffuse_reflect_0 + _S316.diffuse_transmit_0;
    float _S321 = bounded_gain_0(thread_gain_0(_S317, fabrics_0._data[uint(_S315)].colour_noise_0, fabrics_0._data[uint(_S315)].seed_0), _S320, 1.0 - fabrics_0._data[uint(_S315)].layer_bound_0 * _S319);
    float _S322 = bounded_gain_0(fibre_gain_0(_S317, _S318, fabrics_0._data[uint(_S315)].fibre_noise_0, fabrics_0._data[uint(_S315)].seed_0), _S319, min((1.0 - _S321 * _S320) / fabrics_0._data[uint(_S315)].layer_bound_0, vec3(1.0)));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S321 * _S316.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S321 * _S316.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S322 * _S316.specular_reflect_0;
    varied_0.specular_transmit_0 = _S322 * _S316.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S323, SurfacePoint_0 _S324, Albedos_0 _S325, float _S326, float _S327)
{
    float _S328;
    if(_S324.is_warp_2)
    {
        _S328 = _S326;
    }
    else
    {
        _S328 = _S327;
    }
    float _S329 = _S328 - _S324.across_2;
    uint _S330;
    if(_S324.is_warp_2)
    {
        _S330 = fabrics_0._data[uint(_S323)].warp_0;
    }
    else
    {
        _S330 = fabrics_0._data[uint(_S323)].weft_0;
    }
    Family_0 _S331 = families_0._data[uint(_S330)];
    int _S332 = int(families_0._data[uint(_S330)].count_0);
    if(_S324.is_warp_2)
    {
        _S330 = _S324.warp_thread_0;
    }
    else
    {
        _S330 = _S324.weft_thread_0;
    }
    uint _S333 = uint(int(floor(_S329 / _S331.period_0)) * _S332 + int(_S330)) * 2U;
    if(_S324.is_warp_2)
    {
        _S330 = 1U;
    }
    else
    {
        _S330 = 0U;
    }
    float _S334 = floor(_S324.fibre_across_0 / fabrics_0._data[uint(_S323)].fibre_size_0);
    return vary_albedos_0(_S323, _S325, _S333 + _S330, uint(int(_S334)) * 65536U + uint(int(floor(_S324.fibre_along_0 / (fabrics_0._data[uint(_S323)].fibre_size_0 * 40.0) + 0.61799997091293335 * _S334))));
}

YarnPoint_0 yarn_point_of_0(uint _S335, SurfacePoint_0 _S336, float _S337, float _S338, bool _S339, bool _S340)
{
    uint _S341;
    if(_S336.is_warp_2)
    {
        _S341 = fabrics_0._data[uint(_S335)].warp_0;
    }
    else
    {
        _S341 = fabrics_0._data[uint(_S335)].weft_0;
    }
    uint _S342;
    if(_S336.is_warp_2)
    {
        _S342 = _S336.warp_thread_0;
    }
    else
    {
        _S342 = _S336.weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S341, _S342);
    bool _S343;
    if((fabrics_0._data[uint(_S335)].fibre_noise_0) > 0.0)
    {
        _S343 = true;
    }
    else
    {
        _S343 = (fabrics_0._data[uint(_S335)].colour_noise_0) > 0.0;
    }
    Albedos_0 albedos_3;
    if(_S343)
    {
        albedos_3 = varied_at_0(_S335, _S336, albedos_2, _S337, _S338);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_1;
    point_1.back_3 = _S339;
    point_1.hole_2 = _S340;
    point_1.is_warp_1 = _S336.is_warp_2;
    point_1.x_7 = _S337;
    point_1.y_3 = _S338;
    point_1.height_2 = _S336.height_8;
    point_1.normal_3 = _S336.normal_4;
    point_1.tangent_4 = _S336.tangent_5;
    point_1.roughness_8 = families_0._data[uint(_S341)].roughness_0;
    point_1.albedos_1 = albedos_3;
    return point_1;
}

YarnPoint_0 locate_yarn_0(uint _S344, SearchQuality_0 _S345, float _S346, float _S347, vec3 _S348)
{
    bool _S349 = (_S348.z) < 0.0;
    Hit_0 _S350 = first_hit_0(_S344, _S345, _S346, _S347, to_face_frame_0(_S348, _S349), _S349);
    return yarn_point_of_0(_S344, surface_at_0(_S344, _S350.x_8, _S350.y_4, _S349), _S350.x_8, _S350.y_4, _S349, _S350.hole_3);
}

vec3 scattered_0(uint _S351, YarnPoint_0 _S352, vec3 _S353, vec3 _S354)
{
    const vec3 _S355 = vec3(0.0);
    bool _S356 = !_S352.hole_2;
    bool _S357;
    if(_S356)
    {
        _S357 = (_S353.z) > 0.0;
    }
    else
    {
        _S357 = false;
    }
    vec3 value_1;
    if(_S357)
    {
        value_1 = _S352.albedos_1.diffuse_reflect_0 * diffuse_reflection_0(_S353, _S352.normal_3, fabrics_0._data[uint(_S351)].diffuse_blend_0) + _S352.albedos_1.specular_reflect_0 * reflection_0(_S353, _S354, _S352.normal_3, _S352.tangent_4, _S352.roughness_8, fabrics_0._data[uint(_S351)].optical_depth_0);
    }
    else
    {
        if(_S356)
        {
            _S357 = (_S353.z) < 0.0;
        }
        else
        {
            _S357 = false;
        }
        if(_S357)
        {
            value_1 = _S352.albedos_1.diffuse_transmit_0 * diffuse_reflection_0(- _S353, _S352.normal_3, fabrics_0._data[uint(_S351)].diffuse_blend_0) + _S352.albedos_1.specular_transmit_0 * transmission_0(_S353, _S354, _S352.normal_3, _S352.tangent_4, _S352.roughness_8, fabrics_0._data[uint(_S351)].optical_depth_0);
        }
        else
        {
            value_1 = _S355;
        }
    }
    float _S358 = fabrics_0._data[uint(_S351)].sheen_strength_0;
    if((fabrics_0._data[uint(_S351)].sheen_strength_0) <= 0.0)
    {
        return value_1;
    }
    vec2 _S359 = sheen_with_transmittance_0(_S353, _S354, _S358, fabrics_0._data[uint(_S351)].sheen_roughness_0);
    return _S359.y * value_1 + _S359.x;
}

bool unoccluded_0(uint _S360, SearchQuality_0 _S361, float _S362, float _S363, float _S364, vec3 _S365, bool _S366)
{
    if((_S365.z) <= 0.0)
    {
        return false;
    }
    return is_free_0(_S360, _S361, vec3(_S362, _S363, _S364 + fabrics_0._data[uint(_S360)].lift_0), _S365, _S366, max_height_along_0(_S360, _S362, _S363, _S364, _S365, _S366));
}

bool is_lit_0(uint _S367, SearchQuality_0 _S368, YarnPoint_0 _S369, vec3 _S370)
{
    if(_S369.hole_2)
    {
        return true;
    }
    vec3 _S371 = to_face_frame_0(_S370, _S369.back_3);
    float _S372 = _S371.z;
    bool _S373 = _S372 < 0.0;
    vec3 normal_5;
    float height_9;
    if(_S373)
    {
        SurfacePoint_0 _S374 = surface_at_0(_S367, _S369.x_7, _S369.y_3, !_S369.back_3);
        normal_5 = _S374.normal_4;
        height_9 = _S374.height_8;
    }
    else
    {
        normal_5 = _S369.normal_3;
        height_9 = _S369.height_2;
    }
    vec3 _S375 = vec3(_S371.xy, abs(_S372));
    if((dot(normal_5, _S375)) <= 0.0)
    {
        return false;
    }
    return unoccluded_0(_S367, _S368, _S369.x_7, _S369.y_3, height_9, _S375, (_S369.back_3) != _S373);
}

vec3 evaluate_0(uint _S376, SearchQuality_0 _S377, YarnPoint_0 _S378, vec3 _S379, vec3 _S380)
{
    vec3 _S381 = scattered_0(_S376, _S378, to_face_frame_0(_S379, _S378.back_3), to_face_frame_0(_S380, _S378.back_3));
    bool _S382;
    if((max(_S381.x, max(_S381.y, _S381.z))) <= 0.0)
    {
        _S382 = true;
    }
    else
    {
        _S382 = !is_lit_0(_S376, _S377, _S378, _S379);
    }
    if(_S382)
    {
        return vec3(0.0);
    }
    return _S381;
}

float straight_through_0(uint _S383, YarnPoint_0 _S384, vec3 _S385)
{
    if(!_S384.hole_2)
    {
        return 0.0;
    }
    float _S386 = fabrics_0._data[uint(_S383)].sheen_strength_0;
    if((fabrics_0._data[uint(_S383)].sheen_strength_0) <= 0.0)
    {
        return 1.0;
    }
    return 1.0 - _S386 * sheen_lobe_0(abs(_S385.z), fabrics_0._data[uint(_S383)].sheen_roughness_0).z;
}

vec4 cloth_value_0(uint fabric_1, vec2 centre_0, vec2 dx_0, vec2 dy_0, vec3 light_6, vec3 view_5)
{
    SearchQuality_0 _S387 = default_quality_0();
    YarnPoint_0 _S388 = locate_yarn_0(fabric_1, _S387, centre_0.x, centre_0.y, view_5);
    return vec4(evaluate_0(fabric_1, _S387, _S388, light_6, view_5), straight_through_0(fabric_1, _S388, view_5));
}

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
void main()
{
    if((gl_GlobalInvocationID.x) >= (query_count_0._data[uint(0)]))
    {
        return;
    }
    Query_0 _S389 = queries_0._data[uint(gl_GlobalInvocationID.x)];
    answers_0._data[uint(gl_GlobalInvocationID.x)] = cloth_value_0(_S389.fabric_0, vec2(_S389.centre_x_0, _S389.centre_y_0), vec2(_S389.dx_x_0, _S389.dx_y_0), vec2(_S389.dy_x_0, _S389.dy_y_0), vec3(_S389.light_x_0, _S389.light_y_0, _S389.light_z_0), vec3(_S389.view_x_0, _S389.view_y_0, _S389.view_z_0));
    return;
}

