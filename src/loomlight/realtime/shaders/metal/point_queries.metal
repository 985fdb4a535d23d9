#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
constant array<float, int(4)> PYRAMID_RADII_0 = { 1.0f, 2.0f, 4.0f, 8.0f };
struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 default_quality_0()
{
    thread SearchQuality_0 quality_0;
    (&quality_0)->steps_per_thread_0 = 5.0f;
    (&quality_0)->steps_per_relief_0 = 8.0f;
    (&quality_0)->shadow_share_0 = 1.0f;
    (&quality_0)->refinements_0 = 2U;
    return quality_0;
}

float3 to_face_frame_0(float3 direction_0, bool back_0)
{
    float2 _S1 = direction_0.xy;
    float _S2;
    if(back_0)
    {
        _S2 = - direction_0.z;
    }
    else
    {
        _S2 = direction_0.z;
    }
    return float3(_S1, _S2);
}

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
    uint back_1;
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

struct KernelContext_0
{
    uint device* query_count_0;
    Query_0 device* queries_0;
    packed_float4 device* answers_0;
    Fabric_0 device* fabrics_0;
    Family_0 device* families_0;
    uint device* words_0;
};

float2 turns_and_remainder_0(uint family_0, float index_0, KernelContext_0 thread* kernelContext_0)
{
    float _S3 = floor(fma(index_0, kernelContext_0->families_0[family_0].inverse_count_0, kernelContext_0->families_0[family_0].half_inverse_count_0));
    return float2(_S3, fma(- _S3, kernelContext_0->families_0[family_0].count_0, index_0));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0, KernelContext_0 thread* kernelContext_1)
{
    float _S4 = floor(position_0 * kernelContext_1->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_0;
    float _S5 = fma(- _S4, kernelContext_1->families_0[family_1].size_0, position_0);
    (&cell_0)->below_0 = _S5;
    (&cell_0)->above_0 = kernelContext_1->families_0[family_1].size_0 - _S5;
    (&cell_0)->across_0 = _S5 - 0.5f * kernelContext_1->families_0[family_1].size_0;
    (&cell_0)->half_width_1 = kernelContext_1->families_0[family_1].half_width_0;
    float2 _S6 = turns_and_remainder_0(family_1, _S4, kernelContext_1);
    (&cell_0)->thread_0 = uint(clamp(_S6.y, 0.0f, kernelContext_1->families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

float table_number_0(uint index_1, KernelContext_0 thread* kernelContext_2)
{
    return (as_type<float>((kernelContext_2->words_0[index_1])));
}

float table_number_1(uint index_2, KernelContext_0 thread* kernelContext_3)
{
    return (as_type<float>((kernelContext_3->words_0[index_2])));
}

Cell_0 locate_varied_0(uint family_2, float position_1, KernelContext_0 thread* kernelContext_4)
{
    float turns_0 = (position_1 - kernelContext_4->families_0[family_2].start_0) * kernelContext_4->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S7 = turns_1 * kernelContext_4->families_0[family_2].period_0;
    uint thread_1 = kernelContext_4->words_0[kernelContext_4->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_4->families_0[family_2].bins_0, 0.0f, kernelContext_4->families_0[family_2].bins_0 - 1.0f))];
    float _S8 = table_number_0(kernelContext_4->families_0[family_2].place_table_0 + thread_1 * 4U + 1U, kernelContext_4);
    uint _S9;
    if(_S7 >= _S8)
    {
        _S9 = 1U;
    }
    else
    {
        _S9 = 0U;
    }
    uint _S10 = min(thread_1 + _S9, uint(kernelContext_4->families_0[family_2].count_0) - 1U);
    uint _S11 = kernelContext_4->families_0[family_2].place_table_0 + _S10 * 4U;
    thread Cell_0 cell_1;
    (&cell_1)->thread_0 = _S10;
    float _S12 = table_number_0(_S11, kernelContext_4);
    (&cell_1)->below_0 = _S7 - _S12;
    float _S13 = table_number_0(_S11 + 1U, kernelContext_4);
    (&cell_1)->above_0 = _S13 - _S7;
    float _S14 = table_number_0(_S11 + 2U, kernelContext_4);
    (&cell_1)->across_0 = _S7 - _S14;
    float _S15 = table_number_0(_S11 + 3U, kernelContext_4);
    (&cell_1)->half_width_1 = _S15;
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2, KernelContext_0 thread* kernelContext_5)
{
    if((kernelContext_5->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S16 = locate_alike_0(family_3, position_2, kernelContext_5);
        return _S16;
    }
    Cell_0 _S17 = locate_varied_0(family_3, position_2, kernelContext_5);
    return _S17;
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

Shown_0 shown_at_0(const Crossing_0 thread* crossing_0, bool back_2)
{
    bool _S18 = (abs((&crossing_0->warp_1)->across_0)) < ((&crossing_0->warp_1)->half_width_1);
    bool _S19 = (abs((&crossing_0->weft_1)->across_0)) < ((&crossing_0->weft_1)->half_width_1);
    thread Shown_0 shown_0;
    bool _S20;
    if(_S18)
    {
        if(!_S19)
        {
            _S20 = true;
        }
        else
        {
            _S20 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S20 = false;
    }
    (&shown_0)->is_warp_0 = _S20;
    if(!_S18)
    {
        _S20 = !_S19;
    }
    else
    {
        _S20 = false;
    }
    (&shown_0)->hole_0 = _S20;
    uint _S21;
    if((&shown_0)->is_warp_0)
    {
        _S21 = crossing_0->warp_word_0;
    }
    else
    {
        _S21 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S21;
    (&shown_0)->on_top_0 = ((_S21 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_0, const Cell_0 thread* second_0)
{
    thread Cell_0 cell_2;
    uint _S22;
    if(is_first_0)
    {
        _S22 = first_0->thread_0;
    }
    else
    {
        _S22 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S22;
    float _S23;
    if(is_first_0)
    {
        _S23 = first_0->across_0;
    }
    else
    {
        _S23 = second_0->across_0;
    }
    (&cell_2)->across_0 = _S23;
    if(is_first_0)
    {
        _S23 = first_0->half_width_1;
    }
    else
    {
        _S23 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S23;
    if(is_first_0)
    {
        _S23 = first_0->below_0;
    }
    else
    {
        _S23 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S23;
    if(is_first_0)
    {
        _S23 = first_0->above_0;
    }
    else
    {
        _S23 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S23;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0, KernelContext_0 thread* kernelContext_6)
{
    float2 _S24 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0), kernelContext_6);
    float _S25 = _S24.x;
    Family_0 _S26 = kernelContext_6->families_0[family_4];
    float _S27 = table_number_0(kernelContext_6->families_0[family_4].place_table_0 + uint(_S24.y) * 4U, kernelContext_6);
    return fma(_S25, _S26.period_0, _S27);
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0, KernelContext_0 thread* kernelContext_7)
{
    if((kernelContext_7->families_0[family_5].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * kernelContext_7->families_0[family_5].size_0;
    }
    float _S28 = boundary_0(family_5, thread_3, last_0, kernelContext_7);
    float _S29 = boundary_0(family_5, thread_3, first_1, kernelContext_7);
    return _S28 - _S29;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_4, KernelContext_0 thread* kernelContext_8)
{
    Family_0 _S30 = kernelContext_8->families_0[family_6];
    uint _S31;
    if((kernelContext_8->families_0[family_6].is_alike_0) != 0U)
    {
        _S31 = 0U;
    }
    else
    {
        _S31 = thread_4 * 4U;
    }
    uint _S32 = _S30.bend_table_0 + _S31;
    thread Bend_0 bend_0;
    float _S33 = table_number_0(_S32, kernelContext_8);
    (&bend_0)->sine_0 = _S33;
    float _S34 = table_number_0(_S32 + 1U, kernelContext_8);
    (&bend_0)->half_tangent_0 = _S34;
    float _S35 = table_number_0(_S32 + 2U, kernelContext_8);
    (&bend_0)->arc_0 = _S35;
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_5, const Cell_0 thread* crossed_0, uint word_1, KernelContext_0 thread* kernelContext_9)
{
    int _S36 = int((word_1 >> 1U) & 127U);
    int _S37 = int((word_1 >> 8U) & 127U);
    int _S38 = int((word_1 >> 15U) & 63U);
    int _S39 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S40 = crossed_0->below_0;
    uint _S41 = crossed_0->thread_0;
    int _S42 = - _S36;
    float _S43 = span_0(other_0, crossed_0->thread_0, _S42, int(0), kernelContext_9);
    float _S44 = _S40 + _S43;
    (&run_0)->from_start_0 = _S44;
    float _S45 = crossed_0->above_0;
    int _S46 = _S37 + int(1);
    float _S47 = span_0(other_0, _S41, int(1), _S46, kernelContext_9);
    float _S48 = _S45 + _S47;
    (&run_0)->to_end_0 = _S48;
    bool _S49 = _S44 < _S48;
    (&run_0)->near_start_0 = _S49;
    int _S50;
    if(_S49)
    {
        _S50 = _S42 - _S38;
    }
    else
    {
        _S50 = _S46;
    }
    int _S51;
    if((&run_0)->near_start_0)
    {
        _S51 = _S42;
    }
    else
    {
        _S51 = _S46 + _S39;
    }
    Bend_0 _S52 = bend_of_0(own_0, thread_5, kernelContext_9);
    (&run_0)->bend_1 = _S52;
    float _S53;
    if((&run_0)->straight_0)
    {
        _S53 = 1.0e+06f;
    }
    else
    {
        _S53 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_0 = _S53;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S54 = span_0(other_0, _S41, _S50, _S51, kernelContext_9);
    (&run_0)->other_reach_0 = min(0.5f * _S54, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S36 == int(0);
    (&run_0)->last_crossing_0 = _S37 == int(0);
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

Section_0 section_at_0(const Cell_0 thread* cell_3)
{
    float _S55 = cell_3->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S56 = clamp(cell_3->across_0, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_1 = _S56;
    float _S57 = _S55 * _S55 - square_0(_S56);
    float _S58 = rsqrt(_S57);
    (&section_0)->drop_0 = _S55 - _S57 * _S58;
    (&section_0)->slope_0 = - _S56 * _S58;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_6, int step_1, KernelContext_0 thread* kernelContext_10)
{
    if((kernelContext_10->families_0[family_7].is_alike_0) != 0U)
    {
        float _S59 = table_number_0(kernelContext_10->families_0[family_7].bend_table_0 + 3U, kernelContext_10);
        return _S59;
    }
    Family_0 _S60 = kernelContext_10->families_0[family_7];
    float2 _S61 = turns_and_remainder_0(family_7, float(int(thread_6) + step_1), kernelContext_10);
    float _S62 = table_number_0(_S60.bend_table_0 + uint(_S61.y) * 4U + 3U, kernelContext_10);
    return _S62;
}

float2 dive_0(uint other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_11)
{
    float _S63 = crossed_1->below_0;
    float _S64 = crossed_1->above_0;
    bool _S65 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S66 = min(crossed_1->below_0, crossed_1->above_0);
    float _S67;
    if(_S65)
    {
        _S67 = _S63 - crossed_1->across_0;
    }
    else
    {
        _S67 = _S64 + crossed_1->across_0;
    }
    float _S68 = _S67 - crossed_1->half_width_1;
    bool _S69;
    if(_S65)
    {
        _S69 = run_1->first_crossing_0;
    }
    else
    {
        _S69 = run_1->last_crossing_0;
    }
    bool _S70 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S67 = 0.0f;
    }
    else
    {
        Family_0 _S71 = kernelContext_11->families_0[other_1];
        float _S72 = edge_drop_0(other_1, crossed_1->thread_0, int(0), kernelContext_11);
        _S67 = _S71.height_scale_0 * _S72;
    }
    float _S73;
    if(_S70 != _S69)
    {
        _S73 = 0.0f;
    }
    else
    {
        Family_0 _S74 = kernelContext_11->families_0[other_1];
        uint _S75 = crossed_1->thread_0;
        int _S76;
        if(_S65)
        {
            _S76 = int(-1);
        }
        else
        {
            _S76 = int(1);
        }
        float _S77 = edge_drop_0(other_1, _S75, _S76, kernelContext_11);
        _S73 = _S74.height_scale_0 * _S77;
    }
    float _S78 = 1.0f / max(2.0f * _S68, 9.999999960041972e-13f);
    float _S79 = clamp((_S68 - _S66) * _S78, 0.0f, 1.0f);
    float _S80 = _S67 + (_S73 - _S67) * (_S79 * _S79 * (3.0f - 2.0f * _S79));
    float _S81 = (_S67 - _S73) * (6.0f * _S79 * (1.0f - _S79) * _S78);
    if(_S65)
    {
        _S67 = 1.0f;
    }
    else
    {
        _S67 = -1.0f;
    }
    return float2(_S80, _S81 * _S67);
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
    thread StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S82 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S82), 9.99999971718068537e-10f);
    float _S83 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S83), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S82 > 0.0f;
    (&control_0)->up_0 = _S83 > 0.0f;
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
    thread PreviousSample_0 previous_0;
    (&previous_0)->clearance_0 = 0.0f;
    (&previous_0)->rate_0 = 0.0f;
    (&previous_0)->yarn_0 = 0U;
    (&previous_0)->known_0 = false;
    return previous_0;
}

float outline_distance_0(const Cell_0 thread* cell_4, const Shown_0 thread* shown_2, const Run_0 thread* run_2, bool lengthwise_0, bool forwards_0)
{
    float _S84;
    if(forwards_0)
    {
        _S84 = cell_4->across_0;
    }
    else
    {
        _S84 = - cell_4->across_0;
    }
    float _S85;
    if(forwards_0)
    {
        _S85 = cell_4->above_0;
    }
    else
    {
        _S85 = cell_4->below_0;
    }
    bool _S86;
    if(forwards_0)
    {
        _S86 = run_2->last_crossing_0;
    }
    else
    {
        _S86 = run_2->first_crossing_0;
    }
    bool _S87;
    if(forwards_0)
    {
        _S87 = run_2->first_crossing_0;
    }
    else
    {
        _S87 = run_2->last_crossing_0;
    }
    float _S88 = cell_4->half_width_1;
    float _S89 = - cell_4->half_width_1;
    bool _S90 = _S84 < _S89;
    bool _S91 = _S84 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S86 = !_S86;
    }
    else
    {
        _S86 = false;
    }
    if(_S86)
    {
        _S86 = !shown_2->hole_0;
    }
    else
    {
        _S86 = false;
    }
    bool _S92;
    if(_S86)
    {
        _S92 = shown_2->on_top_0;
    }
    else
    {
        _S92 = false;
    }
    if(_S92)
    {
        if(_S87)
        {
            _S87 = _S90;
        }
        else
        {
            _S87 = false;
        }
        _S87 = !_S87;
    }
    else
    {
        _S87 = false;
    }
    if(shown_2->hole_0)
    {
        _S86 = true;
    }
    else
    {
        if(_S86)
        {
            _S86 = !shown_2->on_top_0;
        }
        else
        {
            _S86 = false;
        }
    }
    float _S93;
    if(_S90)
    {
        _S93 = _S89;
    }
    else
    {
        _S93 = _S88;
    }
    float _S94 = _S93 - _S84;
    if(_S86)
    {
        _S84 = 2.0f * _S85 + _S84 - _S88;
    }
    else
    {
        _S84 = _S85;
    }
    if(_S87)
    {
        if(forwards_0)
        {
            _S84 = run_2->to_end_0;
        }
        else
        {
            _S84 = run_2->from_start_0;
        }
        return _S84;
    }
    if(_S91)
    {
    }
    else
    {
        _S84 = _S94;
    }
    return _S84;
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

float way_back_to_dip_0(const PreviousSample_0 thread* previous_1, float clearance_1, float rate_1, float step_4, const Probe_0 thread* here_0)
{
    float _S95 = previous_1->rate_0;
    float _S96 = previous_1->rate_0 * step_4;
    float _S97 = rate_1 * step_4;
    bool _S98;
    if(!previous_1->known_0)
    {
        _S98 = true;
    }
    else
    {
        _S98 = here_0->hole_1;
    }
    if(_S98)
    {
        _S98 = true;
    }
    else
    {
        _S98 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S98)
    {
        _S98 = true;
    }
    else
    {
        _S98 = _S95 >= 0.0f;
    }
    if(_S98)
    {
        _S98 = true;
    }
    else
    {
        _S98 = rate_1 <= 0.0f;
    }
    if(_S98)
    {
        return -1.0f;
    }
    float _S99 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S96) >= 0.0f)
    {
        _S98 = (3.0f * clearance_1 - _S97) >= 0.0f;
    }
    else
    {
        _S98 = false;
    }
    if(_S98)
    {
        return -1.0f;
    }
    float _S100 = clearance_1 - _S99;
    float _S101 = 6.0f * _S100 - 4.0f * _S96 - 2.0f * _S97;
    float _S102 = -2.0f * _S96 / max(_S101 + sqrt(max(_S101 * _S101 - 4.0f * (3.0f * (_S96 + _S97 - 2.0f * _S100)) * _S96, 0.0f)), 9.99999968265522539e-21f);
    float _S103 = 1.0f - _S102;
    float _S104 = (_S99 * (2.0f * _S102 + 1.0f) + _S96 * _S102) * _S103 * _S103;
    float _S105 = (clearance_1 * (2.0f * _S103 + 1.0f) - _S97 * _S103) * _S102 * _S102;
    if(_S102 > 0.01999999955296516f)
    {
        _S98 = _S103 > 0.01999999955296516f;
    }
    else
    {
        _S98 = false;
    }
    if(_S98)
    {
        _S98 = (_S104 + _S105) < 0.0f;
    }
    else
    {
        _S98 = false;
    }
    float _S106;
    if(_S98)
    {
        _S106 = _S103 * step_4;
    }
    else
    {
        _S106 = -1.0f;
    }
    return _S106;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S107 = here_1->hole_1;
    float _S108;
    if(here_1->hole_1)
    {
        _S108 = 1.0e+09f;
    }
    else
    {
        _S108 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S108;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S109;
    if(!_S107)
    {
        _S109 = !is_cell_exit_0;
    }
    else
    {
        _S109 = false;
    }
    (&previous_2)->known_0 = _S109;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_0, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_0->per_x_0, side_y_1 * this_0->per_y_0), 0.0f) + this_0->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_1, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S110 = min(here_2->edge_x_0 * this_1->per_x_0, here_2->edge_y_0 * this_1->per_y_0);
    bool _S111;
    if(!here_2->hole_1)
    {
        _S111 = (rate_3 * _S110 + clearance_3) < 0.0f;
    }
    else
    {
        _S111 = false;
    }
    if(_S111)
    {
        _S111 = _S110 > (2.0f * this_1->epsilon_0);
    }
    else
    {
        _S111 = false;
    }
    float _S112 = this_1->step_2;
    float _S113;
    if(_S111)
    {
        _S113 = _S110 - this_1->epsilon_0;
    }
    else
    {
        _S113 = max(_S110, 0.0f) + this_1->epsilon_0;
    }
    return min(_S112, _S113);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(const ViewRay_0 thread* this_2, float height_1)
{
    return this_2->origin_0 + this_2->slope_1 * float2(height_1) ;
}

float ViewRay_rate_0(const ViewRay_0 thread* this_3, const Probe_0 thread* here_3)
{
    return here_3->slope_x_0 * this_3->slope_1.x + here_3->slope_y_0 * this_3->slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S114 = end_0 - start_1;
    float _S115 = start_rate_0 + end_rate_0 - 2.0f * _S114;
    float _S116 = 3.0f * _S114 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S114, 9.99999968265522539e-21f);
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
        float _S117 = clamp(share_0 - (((_S115 * share_0 + _S116) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S115 * share_0 + 2.0f * _S116) * share_0 + start_rate_0, 0.10000000149011612f * _S114 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S118 = i_0 + int(1);
        share_0 = _S117;
        i_0 = _S118;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S119 = along_slope_0 * along_slope_0 + 1.0f;
    float _S120 = rsqrt(_S119);
    float _S121 = sine_1 * _S120 * rsqrt(_S119 + across_slope_0 * across_slope_0);
    return float2(- _S121 * _S119, _S121 * across_slope_0 * along_slope_0 + cosine_0 * _S120);
}

float arc_sine_0(float x_1)
{
    float _S122 = abs(x_1);
    bool _S123 = _S122 > 0.5f;
    float _S124;
    if(_S123)
    {
        _S124 = 0.5f * (1.0f - _S122);
    }
    else
    {
        _S124 = _S122 * _S122;
    }
    float _S125;
    if(_S123)
    {
        _S125 = sqrt(max(_S124, 0.0f));
    }
    else
    {
        _S125 = _S122;
    }
    float _S126 = ((((0.04216320067644119f * _S124 + 0.02418131195008755f) * _S124 + 0.04547002539038658f) * _S124 + 0.07495300471782684f) * _S124 + 0.16666752099990845f) * _S124 * _S125 + _S125;
    if(_S123)
    {
        _S124 = 1.57079637050628662f - 2.0f * _S126;
    }
    else
    {
        _S124 = _S126;
    }
    if(x_1 < 0.0f)
    {
        _S124 = - _S124;
    }
    return _S124;
}

float3 table_colour_0(uint index_3, KernelContext_0 thread* kernelContext_12)
{
    float _S127 = table_number_1(index_3, kernelContext_12);
    float _S128 = table_number_1(index_3 + 1U, kernelContext_12);
    float _S129 = table_number_1(index_3 + 2U, kernelContext_12);
    return float3(_S127, _S128, _S129);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_0, KernelContext_0 thread* kernelContext_13)
{
    thread Albedos_0 albedos_0;
    float3 _S130 = table_colour_0(row_0, kernelContext_13);
    (&albedos_0)->diffuse_reflect_0 = _S130;
    float3 _S131 = table_colour_0(row_0 + 3U, kernelContext_13);
    (&albedos_0)->diffuse_transmit_0 = _S131;
    float3 _S132 = table_colour_0(row_0 + 6U, kernelContext_13);
    (&albedos_0)->specular_reflect_0 = _S132;
    float3 _S133 = table_colour_0(row_0 + 9U, kernelContext_13);
    (&albedos_0)->specular_transmit_0 = _S133;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_7, KernelContext_0 thread* kernelContext_14)
{
    Albedos_0 _S134 = table_albedos_0(kernelContext_14->families_0[family_8].albedo_table_0 + kernelContext_14->families_0[family_8].albedo_stride_0 * thread_7, kernelContext_14);
    return _S134;
}

uint scramble_0(uint value_0)
{
    uint _S135 = value_0 * 747796405U + 2891336453U;
    uint _S136 = ((_S135 >> ((_S135 >> 28U) + 4U)) ^ _S135) * 277803737U;
    return (_S136 >> 22U) ^ _S136;
}

float uniform_hash_0(uint thread_8, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_0, float3 albedo_0, float3 room_0)
{
    float3 _S137 = room_0 / max(albedo_0, float3(9.99999997475242708e-07f) );
    return min(gain_0, max(min(min(_S137.x, _S137.y), _S137.z), 0.0f));
}

float natural_logarithm_0(float x_2)
{
    uint _S138 = (as_type<uint>((x_2)));
    float exponent_0 = float(int(_S138 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S138 & 8388607U) | 1056964608U)));
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
    float _S139 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S139 - exponent_1 * 0.00021219444170129f - 0.5f * _S139) + exponent_1 * 0.693359375f;
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float diffuse_reflection_0(float3 light_0, float3 normal_0, float blend_0)
{
    float _S140 = light_0.z;
    if(_S140 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S140, 0.0f), max(dot(light_0, normal_0), 0.0f), blend_0);
}

float projected_area_1(float3 direction_2, float3 tangent_0, float roughness_1)
{
    float _S141 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S141 * _S141 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_3)
{
    float _S142 = clamp(x_3, -87.0f, 88.0f);
    float _S143 = floor(_S142 * 1.4426950216293335f + 0.5f);
    float _S144 = _S142 - _S143 * 0.693359375f + _S143 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S144 + 0.00139819993637502f) * _S144 + 0.00833345204591751f) * _S144 + 0.04166579619050026f) * _S144 + 0.1666666567325592f) * _S144 + 0.5f;
    float _S145 = (as_type<float>((uint(int(_S143) + int(127)) << 23U)));
    float _S146;
    if(x_3 < -87.0f)
    {
        _S146 = 0.0f;
    }
    else
    {
        _S146 = (p_0 * _S144 * _S144 + _S144 + 1.0f) * _S145;
    }
    return _S146;
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
    float _S147 = roughness_2 * roughness_2;
    float _S148 = squared_along_0 * (1.0f - _S147) + _S147;
    return 0.31830987334251404f * _S147 * roughness_2 / (_S148 * _S148);
}

float density_between_0(float3 light_1, float3 view_0, float3 tangent_1, float roughness_3)
{
    float3 _S149 = light_1 + view_0;
    float _S150 = dot(_S149, tangent_1);
    return flake_density_0(min(_S150 * _S150 / max(square_1(_S149), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_2, float3 view_1, float3 normal_1, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S151 = dot(light_2, normal_1);
    bool _S152;
    if(_S151 <= 0.0f)
    {
        _S152 = true;
    }
    else
    {
        _S152 = (dot(view_1, normal_1)) <= 0.0f;
    }
    if(_S152)
    {
        return 0.0f;
    }
    float _S153 = max(_S151, 9.99999997475242708e-07f);
    float _S154 = max(dot(view_1, normal_1), 9.99999997475242708e-07f);
    float _S155 = projected_area_1(light_2, tangent_2, roughness_4) * _S154 + projected_area_1(view_1, tangent_2, roughness_4) * _S153;
    float _S156 = optical_depth_1 * _S155 / (_S153 * _S154);
    return 0.25f * density_between_0(light_2, view_1, tangent_2, roughness_4) * (_S156 * mean_attenuation_0(_S156)) * _S153 / _S155;
}

float transmission_0(float3 light_3, float3 view_2, float3 normal_2, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S157 = - dot(light_3, normal_2);
    float _S158 = dot(view_2, normal_2);
    bool _S159;
    if(_S157 <= 0.0f)
    {
        _S159 = true;
    }
    else
    {
        _S159 = _S158 <= 0.0f;
    }
    if(_S159)
    {
        return 0.0f;
    }
    float _S160 = 1.0f / max(_S158, 9.99999997475242708e-07f);
    float _S161 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S157, 9.99999997475242708e-07f);
    float _S162 = projected_area_1(view_2, tangent_3, roughness_5) * _S160;
    return density_between_0(light_3, view_2, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S161, _S162)) * mean_attenuation_0(optical_depth_2 * abs(_S161 - _S162)) * _S160;
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
    float _S163 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S164 = 2.0f * sqrt(_S163) - 1.0f;
    float _S165 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S164, _S165), 0.00999999977648258f, 1.0f), clamp((1.0f - _S163) * sheen_shear_0(_S164, _S165), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S164, _S165), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_4, float3 view_3, float scale_0, float shear_0)
{
    float _S166 = light_4.z;
    bool _S167;
    if(_S166 <= 0.0f)
    {
        _S167 = true;
    }
    else
    {
        _S167 = (view_3.z) <= 0.0f;
    }
    if(_S167)
    {
        return 0.0f;
    }
    float2 _S168 = view_3.xy;
    float _S169 = dot(_S168, _S168);
    float2 _S170;
    if(_S169 > 9.99999968265522539e-21f)
    {
        _S170 = _S168 * float2(rsqrt(_S169)) ;
    }
    else
    {
        _S170 = float2(1.0f, 0.0f);
    }
    float _S171 = scale_0 * dot(light_4.xy, _S170) + shear_0 * _S166;
    float _S172 = scale_0 * (light_4.y * _S170.x - light_4.x * _S170.y);
    float _S173 = _S171 * _S171 + _S172 * _S172 + _S166 * _S166;
    return 0.31830987334251404f * scale_0 * scale_0 * _S166 / max(_S173 * _S173, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_5, float3 view_4, float strength_0, float roughness_7)
{
    float3 _S174 = sheen_lobe_0(view_4.z, roughness_7);
    float _S175 = strength_0 * _S174.z;
    return float2(_S175 * transformed_cosine_0(light_5, view_4, _S174.x, _S174.y), 1.0f - _S175);
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_2;
    bool is_warp_1;
    float x_7;
    float y_3;
    float height_2;
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

Crossing_0 crossing_at_0(uint _S176, float _S177, float _S178, bool _S179, KernelContext_0 thread* kernelContext_15)
{
    Fabric_0 device* _S180 = kernelContext_15->fabrics_0+_S176;
    thread Crossing_0 crossing_2;
    Cell_0 _S181 = locate_0(_S180->warp_0, _S177, kernelContext_15);
    (&crossing_2)->warp_1 = _S181;
    Cell_0 _S182 = locate_0(_S180->weft_0, _S178, kernelContext_15);
    (&crossing_2)->weft_1 = _S182;
    uint _S183 = _S180->run_words_0 + 2U * ((&(&crossing_2)->weft_1)->thread_0 * _S180->ends_1 + (&(&crossing_2)->warp_1)->thread_0);
    uint _S184 = kernelContext_15->words_0[_S183];
    (&crossing_2)->warp_word_0 = _S184;
    (&crossing_2)->weft_word_0 = kernelContext_15->words_0[_S183 + 1U];
    (&crossing_2)->warp_above_0 = ((_S184 & 1U) == 1U) != _S179;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S185, float _S186, float _S187, bool _S188, KernelContext_0 thread* kernelContext_16)
{
    Fabric_0 device* _S189 = kernelContext_16->fabrics_0+_S185;
    thread Sample_0 sample_0;
    Crossing_0 _S190 = crossing_at_0(_S185, _S186, _S187, _S188, kernelContext_16);
    (&sample_0)->crossing_1 = _S190;
    thread Crossing_0 _S191 = _S190;
    Shown_0 _S192 = shown_at_0(&_S191, _S188);
    (&sample_0)->shown_3 = _S192;
    uint _S193;
    if(_S192.is_warp_0)
    {
        _S193 = _S189->warp_0;
    }
    else
    {
        _S193 = _S189->weft_0;
    }
    uint _S194;
    if(_S192.is_warp_0)
    {
        _S194 = _S189->weft_0;
    }
    else
    {
        _S194 = _S189->warp_0;
    }
    thread Cell_0 _S195 = (&(&sample_0)->crossing_1)->warp_1;
    thread Cell_0 _S196 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S197 = select_cell_0(_S192.is_warp_0, &_S195, &_S196);
    thread Cell_0 _S198 = (&(&sample_0)->crossing_1)->weft_1;
    thread Cell_0 _S199 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S200 = select_cell_0(_S192.is_warp_0, &_S198, &_S199);
    thread Cell_0 _S201 = _S200;
    Run_0 _S202 = unpack_0(_S193, _S194, _S197.thread_0, &_S201, _S192.word_0, kernelContext_16);
    thread Cell_0 _S203 = _S197;
    Section_0 _S204 = section_at_0(&_S203);
    bool _S205;
    if(_S192.on_top_0)
    {
        _S205 = (_S202.distance_0) < (_S204.drop_0 * _S202.bend_1.sine_0);
    }
    else
    {
        _S205 = false;
    }
    bool _S206;
    if(_S192.on_top_0)
    {
        _S206 = !_S205;
    }
    else
    {
        _S206 = false;
    }
    float _S207;
    if(_S206)
    {
        _S207 = 1.0f;
    }
    else
    {
        _S207 = -1.0f;
    }
    float _S208;
    if(_S205)
    {
        _S208 = _S202.other_reach_0;
    }
    else
    {
        _S208 = _S202.reach_0;
    }
    float _S209;
    if(_S205)
    {
        _S209 = _S208 + _S202.distance_0;
    }
    else
    {
        _S209 = max(_S208 - _S202.distance_0, 0.0f);
    }
    float _S210 = _S208 / _S202.bend_1.sine_0 - _S207 * _S204.drop_0;
    float _S211 = _S209 * _S209;
    float _S212 = max(_S210 * _S210 - _S211, 9.99999968265522539e-21f);
    float _S213 = rsqrt(_S212);
    float _S214 = _S211 / (_S212 * _S213 + _S210);
    bool _S215 = _S209 > 0.0f;
    float _S216;
    if(_S192.on_top_0)
    {
        _S216 = 1.0f;
    }
    else
    {
        _S216 = -1.0f;
    }
    float _S217;
    if(_S202.near_start_0)
    {
        _S217 = 1.0f;
    }
    else
    {
        _S217 = -1.0f;
    }
    float _S218 = _S216 * _S217;
    if(_S215)
    {
        _S216 = _S210 * _S213;
    }
    else
    {
        _S216 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S204.slope_0 * _S216;
    if(_S215)
    {
        _S209 = _S218 * _S209 * _S213;
    }
    else
    {
        _S209 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S209;
    Family_0 _S219 = kernelContext_16->families_0[_S193];
    thread Shown_0 _S220 = _S192;
    thread Run_0 _S221 = _S202;
    thread Cell_0 _S222 = _S200;
    float2 _S223 = dive_0(_S194, &_S220, &_S221, &_S222, kernelContext_16);
    if(_S202.straight_0)
    {
        _S207 = 0.0f;
    }
    else
    {
        _S207 = _S219.height_scale_0 * _S207;
    }
    (&sample_0)->height_4 = _S207 * (_S208 * _S202.bend_1.half_tangent_0 - _S214) - _S219.height_scale_0 * _S204.drop_0 - _S223.x;
    float _S224 = _S219.height_scale_0 * (&sample_0)->slope_across_0;
    float _S225 = _S219.height_scale_0 * (&sample_0)->slope_along_0 - _S223.y;
    if(_S192.is_warp_0)
    {
        _S207 = _S224;
    }
    else
    {
        _S207 = _S225;
    }
    (&sample_0)->slope_x_1 = _S207;
    if(_S192.is_warp_0)
    {
        _S207 = _S225;
    }
    else
    {
        _S207 = _S224;
    }
    (&sample_0)->slope_y_1 = _S207;
    (&sample_0)->run_3 = _S202;
    (&sample_0)->section_1 = _S204;
    return sample_0;
}

float steps_per_length_0(uint _S226, const SearchQuality_0 thread* _S227, float3 _S228, KernelContext_0 thread* kernelContext_17)
{
    Fabric_0 device* _S229 = kernelContext_17->fabrics_0+_S226;
    return max(max(abs(_S228.x) * _S229->threads_per_x_0, abs(_S228.y) * _S229->threads_per_y_0) * _S227->steps_per_thread_0, abs(_S228.z) * _S229->per_relief_0 * _S227->steps_per_relief_0);
}

float cell_maximum_0(uint _S230, const Crossing_0 thread* _S231, KernelContext_0 thread* kernelContext_18)
{
    Fabric_0 device* _S232 = kernelContext_18->fabrics_0+_S230;
    bool _S233 = _S231->warp_above_0;
    uint _S234;
    if(_S231->warp_above_0)
    {
        _S234 = _S232->warp_0;
    }
    else
    {
        _S234 = _S232->weft_0;
    }
    uint _S235;
    if(_S233)
    {
        _S235 = _S231->warp_word_0;
    }
    else
    {
        _S235 = _S231->weft_word_0;
    }
    return float(_S235 >> 28U) * kernelContext_18->families_0[_S234].height_scale_0 * kernelContext_18->families_0[_S234].level_0;
}

Probe_0 probe_0(uint _S236, float _S237, float _S238, bool _S239, bool _S240, bool _S241, KernelContext_0 thread* kernelContext_19)
{
    Sample_0 _S242 = sample_at_0(_S236, _S237, _S238, _S239, kernelContext_19);
    thread Probe_0 probe_1;
    (&probe_1)->height_0 = _S242.height_4;
    (&probe_1)->hole_1 = _S242.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S242.slope_x_1;
    (&probe_1)->slope_y_0 = _S242.slope_y_1;
    uint _S243;
    if(_S242.shown_3.is_warp_0)
    {
        _S243 = _S242.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S243 = _S242.crossing_1.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S243;
    thread Crossing_0 _S244 = _S242.crossing_1;
    float _S245 = cell_maximum_0(_S236, &_S244, kernelContext_19);
    (&probe_1)->cell_max_0 = _S245;
    float _S246;
    if(_S240)
    {
        _S246 = _S242.crossing_1.warp_1.above_0;
    }
    else
    {
        _S246 = _S242.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S246;
    if(_S241)
    {
        _S246 = _S242.crossing_1.weft_1.above_0;
    }
    else
    {
        _S246 = _S242.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S246;
    bool _S247 = !_S242.shown_3.is_warp_0;
    thread Cell_0 _S248 = _S242.crossing_1.warp_1;
    thread Shown_0 _S249 = _S242.shown_3;
    thread Run_0 _S250 = _S242.run_3;
    float _S251 = outline_distance_0(&_S248, &_S249, &_S250, _S247, _S240);
    (&probe_1)->edge_x_0 = _S251;
    thread Cell_0 _S252 = _S242.crossing_1.weft_1;
    thread Shown_0 _S253 = _S242.shown_3;
    thread Run_0 _S254 = _S242.run_3;
    float _S255 = outline_distance_0(&_S252, &_S253, &_S254, _S242.shown_3.is_warp_0, _S241);
    (&probe_1)->edge_y_0 = _S255;
    return probe_1;
}

bool is_free_0(uint _S256, const SearchQuality_0 thread* _S257, float3 _S258, float3 _S259, bool _S260, float _S261, KernelContext_0 thread* kernelContext_20)
{
    float _S262 = _S259.z;
    if(_S262 <= 0.0f)
    {
        return false;
    }
    float _S263 = _S257->shadow_share_0;
    float _S264 = steps_per_length_0(_S256, _S257, _S259, kernelContext_20);
    float _S265 = 1.0f / max(_S263 * _S264, 9.99999971718068537e-10f);
    StepControl_0 _S266 = step_control_0(_S259.xy, _S265);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S267;
        if(count_1 < 1024U)
        {
            _S267 = (_S258.z + _S262 * distance_1) < _S261;
        }
        else
        {
            _S267 = false;
        }
        if(_S267)
        {
        }
        else
        {
            break;
        }
        float3 _S268 = _S258 + _S259 * float3(distance_1) ;
        Probe_0 _S269 = probe_0(_S256, _S268.x, _S268.y, _S260, _S266.right_0, _S266.up_0, kernelContext_20);
        float _S270 = _S268.z;
        float _S271 = _S270 - _S269.height_0;
        float _S272 = _S262 - _S269.slope_x_0 * _S259.x - _S269.slope_y_0 * _S259.y;
        bool _S273;
        if(!_S269.hole_1)
        {
            _S273 = _S271 < 0.0f;
        }
        else
        {
            _S273 = false;
        }
        if(_S273)
        {
            return false;
        }
        thread PreviousSample_0 _S274 = previous_3;
        thread Probe_0 _S275 = _S269;
        float _S276 = way_back_to_dip_0(&_S274, _S271, _S272, last_step_0, &_S275);
        if(_S276 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S276;
            distance_1 = distance_1 - _S276;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S277 = _S270 > (_S269.cell_max_0);
        thread Probe_0 _S278 = _S269;
        PreviousSample_0 _S279 = after_sample_0(_S271, _S272, &_S278, _S277);
        float last_step_2;
        if(_S277)
        {
            thread StepControl_0 _S280 = _S266;
            float _S281 = StepControl_to_cell_exit_0(&_S280, _S269.side_x_0, _S269.side_y_0);
            last_step_2 = max(_S281, _S265);
        }
        else
        {
            thread StepControl_0 _S282 = _S266;
            thread Probe_0 _S283 = _S269;
            float _S284 = StepControl_to_next_sample_0(&_S282, &_S283, _S271, _S272);
            last_step_2 = _S284;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S279;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S285, const SearchQuality_0 thread* _S286, float _S287, float _S288, float3 _S289, bool _S290, KernelContext_0 thread* kernelContext_21)
{
    Fabric_0 device* _S291 = kernelContext_21->fabrics_0+_S285;
    Sample_0 _S292 = sample_at_0(_S285, _S287, _S288, _S290, kernelContext_21);
    if(!_S292.shown_3.hole_0)
    {
        return false;
    }
    float3 _S293 = float3(_S287, _S288, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S294;
        if(side_0 < 2U)
        {
            _S294 = passes_0;
        }
        else
        {
            _S294 = false;
        }
        if(_S294)
        {
        }
        else
        {
            break;
        }
        float3 _S295;
        if(side_0 == 0U)
        {
            _S295 = _S289;
        }
        else
        {
            _S295 = float3(- _S289.x, - _S289.y, _S289.z);
        }
        bool _S296 = is_free_0(_S285, _S286, _S293, _S295, _S290 != (side_0 == 1U), _S291->height_high_0, kernelContext_21);
        uint _S297 = side_0 + 1U;
        passes_0 = _S296;
        side_0 = _S297;
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

float max_height_along_0(uint _S298, float _S299, float _S300, float _S301, float3 _S302, bool _S303, KernelContext_0 thread* kernelContext_22)
{
    Fabric_0 device* _S304 = kernelContext_22->fabrics_0+_S298;
    Cell_0 _S305 = locate_0(_S304->warp_0, _S299, kernelContext_22);
    uint _S306 = _S305.thread_0 / 2U;
    Cell_0 _S307 = locate_0(_S304->weft_0, _S300, kernelContext_22);
    uint _S308 = _S307.thread_0 / 2U;
    float _S309 = _S302.x;
    uint _S310;
    if(_S309 > 0.0f)
    {
        _S310 = 1U;
    }
    else
    {
        _S310 = 0U;
    }
    float _S311 = _S302.y;
    uint _S312;
    if(_S311 > 0.0f)
    {
        _S312 = 2U;
    }
    else
    {
        _S312 = 0U;
    }
    uint _S313 = kernelContext_22->words_0[_S304->max_heights_0 + 4U * (_S308 * _S304->max_height_columns_0 + _S306) + (_S310 + _S312)];
    int number_0;
    if(_S303)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S314 = _S313 >> uint(number_0);
    float _S315 = max(abs(_S309) * _S304->threads_per_x_0, abs(_S311) * _S304->threads_per_y_0) / _S302.z;
    float _S316 = _S304->height_high_0;
    float max_height_0 = _S304->height_high_0;
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
        if(((max_height_0 - _S301) * _S315) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S314 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S316);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S317, float _S318, float _S319, bool _S320, bool _S321, bool _S322, KernelContext_0 thread* kernelContext_23)
{
    Crossing_0 _S323 = crossing_at_0(_S317, _S318, _S319, _S320, kernelContext_23);
    thread Crossing_0 _S324 = _S323;
    float _S325 = cell_maximum_0(_S317, &_S324, kernelContext_23);
    float _S326;
    if(_S321)
    {
        _S326 = _S323.warp_1.above_0;
    }
    else
    {
        _S326 = _S323.warp_1.below_0;
    }
    float _S327;
    if(_S322)
    {
        _S327 = _S323.weft_1.above_0;
    }
    else
    {
        _S327 = _S323.weft_1.below_0;
    }
    return float3(_S325, _S326, _S327);
}

float first_sample_height_0(uint _S328, const ViewRay_0 thread* _S329, const StepControl_0 thread* _S330, bool _S331, KernelContext_0 thread* kernelContext_24)
{
    float _S332 = max_height_along_0(_S328, _S329->origin_0.x, _S329->origin_0.y, 0.0f, float3(_S329->slope_1, 1.0f), _S331, kernelContext_24);
    uint count_2 = 0U;
    float height_6 = _S332;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S333 = ViewRay_at_0(_S329, height_6);
        float3 _S334 = cell_bounds_0(_S328, _S333.x, _S333.y, _S331, _S330->right_0, _S330->up_0, kernelContext_24);
        float _S335 = height_6 - _S334.x;
        float _S336 = StepControl_to_cell_exit_0(_S330, _S334.y, _S334.z);
        float height_7 = height_6 - clamp(_S335, 0.0f, _S336);
        if(_S335 <= _S336)
        {
            height_6 = height_7;
            break;
        }
        count_2 = count_2 + 1U;
        height_6 = height_7;
    }
    return height_6;
}

ViewRayEnd_0 search_down_0(uint _S337, const ViewRay_0 thread* _S338, const StepControl_0 thread* _S339, bool _S340, KernelContext_0 thread* kernelContext_25)
{
    Fabric_0 device* _S341 = kernelContext_25->fabrics_0+_S337;
    float _S342 = _S341->height_low_0 - (_S341->height_high_0 - _S341->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S343 = first_sample_height_0(_S337, _S338, _S339, _S340, kernelContext_25);
    (&end_1)->height_5 = _S343;
    (&end_1)->last_step_3 = _S339->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
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
        float2 _S344 = ViewRay_at_0(_S338, (&end_1)->height_5);
        Probe_0 _S345 = probe_0(_S337, _S344.x, _S344.y, _S340, _S339->right_0, _S339->up_0, kernelContext_25);
        float _S346 = (&end_1)->height_5 - _S345.height_0;
        thread Probe_0 _S347 = _S345;
        float _S348 = ViewRay_rate_0(_S338, &_S347);
        (&end_1)->depth_1 = - _S346;
        (&end_1)->rate_4 = _S348;
        bool _S349;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S349 = !_S345.hole_1;
        }
        else
        {
            _S349 = false;
        }
        bool _S350;
        if(_S349)
        {
            _S350 = ((&(&end_1)->previous_4)->yarn_0) == (_S345.yarn_1);
        }
        else
        {
            _S350 = false;
        }
        (&end_1)->smooth_0 = _S350;
        bool _S351;
        if(!_S345.hole_1)
        {
            _S351 = _S346 <= 0.0f;
        }
        else
        {
            _S351 = false;
        }
        bool _S352;
        if(_S351)
        {
            _S352 = true;
        }
        else
        {
            _S352 = ((&end_1)->height_5) <= _S342;
        }
        if(_S352)
        {
            break;
        }
        thread PreviousSample_0 _S353 = (&end_1)->previous_4;
        thread Probe_0 _S354 = _S345;
        float _S355 = way_back_to_dip_0(&_S353, _S346, _S348, (&end_1)->last_step_3, &_S354);
        if(_S355 >= 0.0f)
        {
            (&end_1)->height_5 = (&end_1)->height_5 + _S355;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S355;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S356 = StepControl_to_cell_exit_0(_S339, _S345.side_x_0, _S345.side_y_0);
        float _S357 = min(_S356, (&end_1)->height_5 - _S345.cell_max_0);
        thread Probe_0 _S358 = _S345;
        float _S359 = StepControl_to_next_sample_0(_S339, &_S358, _S346, _S348);
        bool _S360 = _S357 > _S359;
        thread Probe_0 _S361 = _S345;
        PreviousSample_0 _S362 = after_sample_0(_S346, _S348, &_S361, _S360);
        (&end_1)->previous_4 = _S362;
        float _S363 = max(_S357, _S359);
        (&end_1)->last_step_3 = _S363;
        (&end_1)->height_5 = (&end_1)->height_5 - _S363;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S364, const ViewRay_0 thread* _S365, const StepControl_0 thread* _S366, bool _S367, const ViewRayEnd_0 thread* _S368, uint _S369, KernelContext_0 thread* kernelContext_26)
{
    Fabric_0 device* _S370 = kernelContext_26->fabrics_0+_S364;
    float _S371 = _S370->height_high_0 - _S370->height_low_0;
    float _S372 = _S368->height_5;
    float _S373 = _S368->last_step_3;
    float above_2 = _S368->height_5 + _S368->last_step_3;
    float above_gap_1 = clamp((&_S368->previous_4)->clearance_0, 0.0f, _S371);
    float under_gap_1 = clamp(_S368->depth_1, 0.0f, _S371);
    float _S374 = cubic_root_0(above_gap_1, - under_gap_1, (&_S368->previous_4)->rate_0 * _S368->last_step_3, _S368->rate_4 * _S368->last_step_3);
    bool _S375 = _S368->smooth_0;
    float middle_0;
    if(_S368->smooth_0)
    {
        middle_0 = above_2 - _S374 * _S373;
    }
    else
    {
        middle_0 = between_0(above_2, _S372, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S372;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S369)
        {
        }
        else
        {
            break;
        }
        float2 _S376 = ViewRay_at_0(_S365, middle_0);
        Probe_0 _S377 = probe_0(_S364, _S376.x, _S376.y, _S367, _S366->right_0, _S366->up_0, kernelContext_26);
        float _S378;
        if(_S377.hole_1)
        {
            _S378 = -1.0e+09f;
        }
        else
        {
            _S378 = _S377.height_0;
        }
        float _S379 = clamp(middle_0 - _S378, - _S371, _S371);
        float _S380;
        if(_S379 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S380 = 0.5f * above_gap_2;
            }
            else
            {
                _S380 = above_gap_2;
            }
            float _S381 = - _S379;
            under_1 = middle_0;
            above_gap_2 = _S380;
            under_gap_2 = _S381;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S380 = 0.5f * under_gap_2;
            }
            else
            {
                _S380 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S379;
            under_gap_2 = _S380;
            side_1 = -1.0f;
        }
        if(_S375)
        {
            thread Probe_0 _S382 = _S377;
            float _S383 = ViewRay_rate_0(_S365, &_S382);
            middle_0 = clamp(middle_0 + _S379 / min(_S383, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S375)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S384, const SearchQuality_0 thread* _S385, float _S386, float _S387, float3 _S388, bool _S389, KernelContext_0 thread* kernelContext_27)
{
    float _S390 = max(_S388.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S386, _S387);
    float2 _S391 = _S388.xy / float2(_S390) ;
    (&ray_0)->slope_1 = _S391;
    float2 _S392 = - _S391;
    float _S393 = steps_per_length_0(_S384, _S385, _S388, kernelContext_27);
    StepControl_0 _S394 = step_control_0(_S392, 1.0f / max(_S393 / _S390, 9.99999971718068537e-10f));
    thread ViewRay_0 _S395 = ray_0;
    thread StepControl_0 _S396 = _S394;
    ViewRayEnd_0 _S397 = search_down_0(_S384, &_S395, &_S396, _S389, kernelContext_27);
    thread Hit_0 hit_0;
    (&hit_0)->hole_3 = false;
    thread ViewRay_0 _S398 = ray_0;
    thread StepControl_0 _S399 = _S394;
    thread ViewRayEnd_0 _S400 = _S397;
    float _S401 = refined_height_0(_S384, &_S398, &_S399, _S389, &_S400, _S385->refinements_0, kernelContext_27);
    (&hit_0)->height_3 = _S401;
    thread ViewRay_0 _S402 = ray_0;
    float2 _S403 = ViewRay_at_0(&_S402, _S401);
    (&hit_0)->x_8 = _S403.x;
    (&hit_0)->y_4 = _S403.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S404, const SearchQuality_0 thread* _S405, float _S406, float _S407, float3 _S408, bool _S409, KernelContext_0 thread* kernelContext_28)
{
    bool _S410 = passes_through_0(_S404, _S405, _S406, _S407, _S408, _S409, kernelContext_28);
    if(!_S410)
    {
        Hit_0 _S411 = first_hit_of_yarn_0(_S404, _S405, _S406, _S407, _S408, _S409, kernelContext_28);
        return _S411;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_8 = _S406;
    (&hit_1)->y_4 = _S407;
    (&hit_1)->height_3 = 0.0f;
    (&hit_1)->hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_2;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_8;
    float3 normal_4;
    float3 tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 surface_at_0(uint _S412, float _S413, float _S414, bool _S415, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S416 = kernelContext_29->fabrics_0+_S412;
    Sample_0 _S417 = sample_at_0(_S412, _S413, _S414, _S415, kernelContext_29);
    float _S418;
    if(_S417.shown_3.is_warp_0)
    {
        _S418 = _S417.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S418 = _S417.crossing_1.weft_1.half_width_1;
    }
    uint _S419;
    if(_S417.shown_3.is_warp_0)
    {
        _S419 = _S416->warp_0;
    }
    else
    {
        _S419 = _S416->weft_0;
    }
    Family_0 _S420 = kernelContext_29->families_0[_S419];
    float _S421;
    if(_S415)
    {
        _S421 = -1.0f;
    }
    else
    {
        _S421 = 1.0f;
    }
    float _S422 = _S420.twist_sine_0 * _S421;
    Family_0 _S423 = kernelContext_29->families_0[_S419];
    if(_S417.shown_3.is_warp_0)
    {
        _S421 = 1.0f;
    }
    else
    {
        _S421 = -1.0f;
    }
    float2 _S424 = fibre_direction_0(_S417.slope_across_0, _S421 * _S417.slope_along_0, _S422, _S423.twist_cosine_0);
    float _S425;
    if(_S417.shown_3.is_warp_0)
    {
        _S425 = _S417.slope_x_1;
    }
    else
    {
        _S425 = _S417.slope_y_1;
    }
    float _S426;
    if(_S417.shown_3.is_warp_0)
    {
        _S426 = _S417.slope_y_1;
    }
    else
    {
        _S426 = _S417.slope_x_1;
    }
    float _S427 = _S424.x;
    float _S428 = _S424.y;
    float _S429 = _S425 * _S427 + _S421 * _S426 * _S428;
    float _S430 = _S418 * 1.0154266357421875f;
    float _S431 = _S430 * arc_sine_0(clamp(_S417.section_1.across_1 / _S430, -1.0f, 1.0f));
    if(_S417.shown_3.is_warp_0)
    {
        _S418 = _S414;
    }
    else
    {
        _S418 = - _S413;
    }
    thread SurfacePoint_0 point_0;
    (&point_0)->hole_4 = _S417.shown_3.hole_0;
    (&point_0)->is_warp_2 = _S417.shown_3.is_warp_0;
    (&point_0)->warp_thread_0 = _S417.crossing_1.warp_1.thread_0;
    (&point_0)->weft_thread_0 = _S417.crossing_1.weft_1.thread_0;
    (&point_0)->height_8 = _S417.height_4;
    (&point_0)->normal_4 = normalize(float3(- _S417.slope_x_1, - _S417.slope_y_1, 1.0f));
    float3 _S432;
    if(_S417.shown_3.is_warp_0)
    {
        _S432 = float3(_S427, _S428, _S429);
    }
    else
    {
        _S432 = float3(- _S428, _S427, _S429);
    }
    (&point_0)->tangent_5 = normalize(_S432);
    (&point_0)->across_2 = _S417.section_1.across_1;
    (&point_0)->fibre_across_0 = _S431 * _S423.twist_cosine_0 + _S418 * _S422;
    (&point_0)->fibre_along_0 = _S418 * _S423.twist_cosine_0 - _S431 * _S422;
    return point_0;
}

Albedos_0 vary_albedos_0(uint _S433, const Albedos_0 thread* _S434, uint _S435, uint _S436, KernelContext_0 thread* kernelContext_30)
{
    Fabric_0 device* _S437 = kernelContext_30->fabrics_0+_S433;
    float3 _S438 = max(_S434->specular_reflect_0, _S434->specular_transmit_0);
    float3 _S439 = _S434->diffuse_reflect_0 + _S434->diffuse_transmit_0;
    float3 _S440 = float3(_S437->layer_bound_0) ;
    float3 _S441 = float3(1.0f) ;
    float3 _S442 = float3(bounded_gain_0(thread_gain_0(_S435, _S437->colour_noise_0, _S437->seed_0), _S439, _S441 - _S440 * _S438)) ;
    float _S443 = bounded_gain_0(fibre_gain_0(_S435, _S436, _S437->fibre_noise_0, _S437->seed_0), _S438, min((_S441 - _S442 * _S439) / _S440, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S442 * _S434->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S442 * _S434->diffuse_transmit_0;
    float3 _S444 = float3(_S443) ;
    (&varied_0)->specular_reflect_0 = _S444 * _S434->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S444 * _S434->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S445, const SurfacePoint_0 thread* _S446, const Albedos_0 thread* _S447, float _S448, float _S449, KernelContext_0 thread* kernelContext_31)
{
    Fabric_0 device* _S450 = kernelContext_31->fabrics_0+_S445;
    bool _S451 = _S446->is_warp_2;
    float _S452;
    if(_S446->is_warp_2)
    {
        _S452 = _S448;
    }
    else
    {
        _S452 = _S449;
    }
    float _S453 = _S452 - _S446->across_2;
    uint _S454;
    if(_S451)
    {
        _S454 = _S450->warp_0;
    }
    else
    {
        _S454 = _S450->weft_0;
    }
    Family_0 _S455 = kernelContext_31->families_0[_S454];
    int _S456 = int(kernelContext_31->families_0[_S454].count_0);
    if(_S451)
    {
        _S454 = _S446->warp_thread_0;
    }
    else
    {
        _S454 = _S446->weft_thread_0;
    }
    uint _S457 = uint(int(floor(_S453 / _S455.period_0)) * _S456 + int(_S454)) * 2U;
    if(_S451)
    {
        _S454 = 1U;
    }
    else
    {
        _S454 = 0U;
    }
    float _S458 = floor(_S446->fibre_across_0 / _S450->fibre_size_0);
    Albedos_0 _S459 = vary_albedos_0(_S445, _S447, _S457 + _S454, uint(int(_S458)) * 65536U + uint(int(floor(_S446->fibre_along_0 / (_S450->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S458))), kernelContext_31);
    return _S459;
}

YarnPoint_0 yarn_point_of_0(uint _S460, const SurfacePoint_0 thread* _S461, float _S462, float _S463, bool _S464, bool _S465, KernelContext_0 thread* kernelContext_32)
{
    Fabric_0 device* _S466 = kernelContext_32->fabrics_0+_S460;
    bool _S467 = _S461->is_warp_2;
    uint _S468;
    if(_S461->is_warp_2)
    {
        _S468 = _S466->warp_0;
    }
    else
    {
        _S468 = _S466->weft_0;
    }
    uint _S469;
    if(_S467)
    {
        _S469 = _S461->warp_thread_0;
    }
    else
    {
        _S469 = _S461->weft_thread_0;
    }
    Albedos_0 _S470 = albedos_of_0(_S468, _S469, kernelContext_32);
    bool _S471;
    if((_S466->fibre_noise_0) > 0.0f)
    {
        _S471 = true;
    }
    else
    {
        _S471 = (_S466->colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_2;
    if(_S471)
    {
        thread Albedos_0 _S472 = _S470;
        Albedos_0 _S473 = varied_at_0(_S460, _S461, &_S472, _S462, _S463, kernelContext_32);
        albedos_2 = _S473;
    }
    else
    {
        albedos_2 = _S470;
    }
    thread YarnPoint_0 point_1;
    (&point_1)->back_3 = _S464;
    (&point_1)->hole_2 = _S465;
    (&point_1)->is_warp_1 = _S467;
    (&point_1)->x_7 = _S462;
    (&point_1)->y_3 = _S463;
    (&point_1)->height_2 = _S461->height_8;
    (&point_1)->normal_3 = _S461->normal_4;
    (&point_1)->tangent_4 = _S461->tangent_5;
    (&point_1)->roughness_8 = kernelContext_32->families_0[_S468].roughness_0;
    (&point_1)->albedos_1 = albedos_2;
    return point_1;
}

YarnPoint_0 locate_yarn_0(uint _S474, const SearchQuality_0 thread* _S475, float _S476, float _S477, float3 _S478, KernelContext_0 thread* kernelContext_33)
{
    bool _S479 = (_S478.z) < 0.0f;
    Hit_0 _S480 = first_hit_0(_S474, _S475, _S476, _S477, to_face_frame_0(_S478, _S479), _S479, kernelContext_33);
    SurfacePoint_0 _S481 = surface_at_0(_S474, _S480.x_8, _S480.y_4, _S479, kernelContext_33);
    thread SurfacePoint_0 _S482 = _S481;
    YarnPoint_0 _S483 = yarn_point_of_0(_S474, &_S482, _S480.x_8, _S480.y_4, _S479, _S480.hole_3, kernelContext_33);
    return _S483;
}

float3 scattered_0(uint _S484, const YarnPoint_0 thread* _S485, float3 _S486, float3 _S487, KernelContext_0 thread* kernelContext_34)
{
    Fabric_0 device* _S488 = kernelContext_34->fabrics_0+_S484;
    float3 _S489 = float3(0.0f) ;
    bool _S490 = !_S485->hole_2;
    bool _S491;
    if(_S490)
    {
        _S491 = (_S486.z) > 0.0f;
    }
    else
    {
        _S491 = false;
    }
    float3 value_1;
    if(_S491)
    {
        value_1 = (&_S485->albedos_1)->diffuse_reflect_0 * float3(diffuse_reflection_0(_S486, _S485->normal_3, _S488->diffuse_blend_0))  + (&_S485->albedos_1)->specular_reflect_0 * float3(reflection_0(_S486, _S487, _S485->normal_3, _S485->tangent_4, _S485->roughness_8, _S488->optical_depth_0)) ;
    }
    else
    {
        if(_S490)
        {
            _S491 = (_S486.z) < 0.0f;
        }
        else
        {
            _S491 = false;
        }
        if(_S491)
        {
            value_1 = (&_S485->albedos_1)->diffuse_transmit_0 * float3(diffuse_reflection_0(- _S486, _S485->normal_3, _S488->diffuse_blend_0))  + (&_S485->albedos_1)->specular_transmit_0 * float3(transmission_0(_S486, _S487, _S485->normal_3, _S485->tangent_4, _S485->roughness_8, _S488->optical_depth_0)) ;
        }
        else
        {
            value_1 = _S489;
        }
    }
    float _S492 = _S488->sheen_strength_0;
    if((_S488->sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S493 = sheen_with_transmittance_0(_S486, _S487, _S492, _S488->sheen_roughness_0);
    return float3(_S493.y)  * value_1 + float3(_S493.x) ;
}

bool unoccluded_0(uint _S494, const SearchQuality_0 thread* _S495, float _S496, float _S497, float _S498, float3 _S499, bool _S500, KernelContext_0 thread* kernelContext_35)
{
    Fabric_0 device* _S501 = kernelContext_35->fabrics_0+_S494;
    if((_S499.z) <= 0.0f)
    {
        return false;
    }
    float _S502 = max_height_along_0(_S494, _S496, _S497, _S498, _S499, _S500, kernelContext_35);
    bool _S503 = is_free_0(_S494, _S495, float3(_S496, _S497, _S498 + _S501->lift_0), _S499, _S500, _S502, kernelContext_35);
    return _S503;
}

bool is_lit_0(uint _S504, const SearchQuality_0 thread* _S505, const YarnPoint_0 thread* _S506, float3 _S507, KernelContext_0 thread* kernelContext_36)
{
    if(_S506->hole_2)
    {
        return true;
    }
    bool _S508 = _S506->back_3;
    float3 _S509 = to_face_frame_0(_S507, _S506->back_3);
    float _S510 = _S509.z;
    bool _S511 = _S510 < 0.0f;
    float3 _S512 = _S506->normal_3;
    float _S513 = _S506->height_2;
    float3 normal_5;
    float height_9;
    if(_S511)
    {
        SurfacePoint_0 _S514 = surface_at_0(_S504, _S506->x_7, _S506->y_3, !_S508, kernelContext_36);
        normal_5 = _S514.normal_4;
        height_9 = _S514.height_8;
    }
    else
    {
        normal_5 = _S512;
        height_9 = _S513;
    }
    float3 _S515 = float3(_S509.xy, abs(_S510));
    if((dot(normal_5, _S515)) <= 0.0f)
    {
        return false;
    }
    bool _S516 = unoccluded_0(_S504, _S505, _S506->x_7, _S506->y_3, height_9, _S515, _S508 != _S511, kernelContext_36);
    return _S516;
}

float3 evaluate_0(uint _S517, const SearchQuality_0 thread* _S518, const YarnPoint_0 thread* _S519, float3 _S520, float3 _S521, KernelContext_0 thread* kernelContext_37)
{
    float3 _S522 = scattered_0(_S517, _S519, to_face_frame_0(_S520, _S519->back_3), to_face_frame_0(_S521, _S519->back_3), kernelContext_37);
    bool _S523;
    if((max(_S522.x, max(_S522.y, _S522.z))) <= 0.0f)
    {
        _S523 = true;
    }
    else
    {
        bool _S524 = is_lit_0(_S517, _S518, _S519, _S520, kernelContext_37);
        _S523 = !_S524;
    }
    if(_S523)
    {
        return float3(0.0f) ;
    }
    return _S522;
}

float straight_through_0(uint _S525, const YarnPoint_0 thread* _S526, float3 _S527, KernelContext_0 thread* kernelContext_38)
{
    Fabric_0 device* _S528 = kernelContext_38->fabrics_0+_S525;
    if(!_S526->hole_2)
    {
        return 0.0f;
    }
    float _S529 = _S528->sheen_strength_0;
    if((_S528->sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S529 * sheen_lobe_0(abs(_S527.z), _S528->sheen_roughness_0).z;
}

float4 cloth_value_0(uint fabric_1, float2 centre_0, float2 dx_0, float2 dy_0, float3 light_6, float3 view_5, KernelContext_0 thread* kernelContext_39)
{
    SearchQuality_0 _S530 = default_quality_0();
    float _S531 = centre_0.x;
    float _S532 = centre_0.y;
    thread SearchQuality_0 _S533 = _S530;
    YarnPoint_0 _S534 = locate_yarn_0(fabric_1, &_S533, _S531, _S532, view_5, kernelContext_39);
    thread SearchQuality_0 _S535 = _S530;
    thread YarnPoint_0 _S536 = _S534;
    float3 _S537 = evaluate_0(fabric_1, &_S535, &_S536, light_6, view_5, kernelContext_39);
    thread YarnPoint_0 _S538 = _S534;
    float _S539 = straight_through_0(fabric_1, &_S538, view_5, kernelContext_39);
    return float4(_S537, _S539);
}

[[kernel]] void point_queries(uint3 id_0 [[thread_position_in_grid]], uint device* query_count_1 [[buffer(24)]], Query_0 device* queries_1 [[buffer(23)]], packed_float4 device* answers_1 [[buffer(25)]], Fabric_0 device* fabrics_1 [[buffer(0)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]])
{
    thread KernelContext_0 kernelContext_40;
    (&kernelContext_40)->query_count_0 = query_count_1;
    (&kernelContext_40)->queries_0 = queries_1;
    (&kernelContext_40)->answers_0 = answers_1;
    (&kernelContext_40)->fabrics_0 = fabrics_1;
    (&kernelContext_40)->families_0 = families_1;
    (&kernelContext_40)->words_0 = words_1;
    uint _S540 = id_0.x;
    if(_S540 >= query_count_1[int(0)])
    {
        return;
    }
    Query_0 _S541 = (&kernelContext_40)->queries_0[_S540];
    packed_float4 device* _S542 = (&kernelContext_40)->answers_0+_S540;
    float4 _S543 = cloth_value_0(_S541.fabric_0, float2(_S541.centre_x_0, _S541.centre_y_0), float2(_S541.dx_x_0, _S541.dx_y_0), float2(_S541.dy_x_0, _S541.dy_y_0), float3(_S541.light_x_0, _S541.light_y_0, _S541.light_z_0), float3(_S541.view_x_0, _S541.view_y_0, _S541.view_z_0), &kernelContext_40);
    *_S542 = packed_float4(_S543) ;
    return;
}

