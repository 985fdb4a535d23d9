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
    uint back_2;
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

Shown_0 shown_at_0(const Crossing_0 thread* crossing_0, bool back_3)
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
    (&shown_0)->on_top_0 = ((_S21 & 1U) == 1U) != back_3;
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

float2 ViewRay_at_0(const ViewRay_0 thread* this_2, float height_2)
{
    return this_2->origin_0 + this_2->slope_1 * float2(height_2) ;
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

float bounded_gain_0(float gain_0, float3 albedo_1, float3 room_0)
{
    float3 _S137 = room_0 / max(albedo_1, float3(9.99999997475242708e-07f) );
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

FaceRadiance_0 face_radiance_0(const FaceSends_0 thread* sends_0, float open_of_other_0, float3 passed_0, float3 from_other_0)
{
    float3 _S140 = float3((1.0f - open_of_other_0))  * passed_0;
    thread FaceRadiance_0 found_0;
    float3 _S141 = sends_0->sky_warp_0 + _S140 * sends_0->crossing_warp_0;
    (&found_0)->warp_2 = _S141;
    float3 _S142 = sends_0->sky_weft_0 + _S140 * sends_0->crossing_weft_0;
    (&found_0)->weft_2 = _S142;
    (&found_0)->mean_0 = float3(sends_0->blocks_warp_0)  * _S141 + float3(sends_0->blocks_weft_0)  * _S142;
    (&found_0)->leaked_0 = from_other_0;
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

Bounced_0 bounced_by_0(const Blocked_0 thread* blocked_0, const Scattered_0 thread* yarn_2, const Interior_0 thread* interior_0)
{
    float3 _S143 = float3((blocked_0->by_warp_0 + blocked_0->by_weft_0))  * interior_0->leaked_1;
    float3 _S144 = float3(blocked_0->far_0)  * yarn_2->through_0;
    thread Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_4 * (float3(blocked_0->by_warp_0)  * interior_0->warp_3 + float3(blocked_0->by_weft_0)  * interior_0->weft_3) + _S144 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S144 * interior_0->far_1 + yarn_2->back_4 * _S143;
    return bounced_0;
}

float diffuse_reflection_0(float3 light_0, float3 normal_0, float blend_0)
{
    float _S145 = light_0.z;
    if(_S145 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S145, 0.0f), max(dot(light_0, normal_0), 0.0f), blend_0);
}

float projected_area_1(float3 direction_2, float3 tangent_0, float roughness_1)
{
    float _S146 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S146 * _S146 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_3)
{
    float _S147 = clamp(x_3, -87.0f, 88.0f);
    float _S148 = floor(_S147 * 1.4426950216293335f + 0.5f);
    float _S149 = _S147 - _S148 * 0.693359375f + _S148 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S149 + 0.00139819993637502f) * _S149 + 0.00833345204591751f) * _S149 + 0.04166579619050026f) * _S149 + 0.1666666567325592f) * _S149 + 0.5f;
    float _S150 = (as_type<float>((uint(int(_S148) + int(127)) << 23U)));
    float _S151;
    if(x_3 < -87.0f)
    {
        _S151 = 0.0f;
    }
    else
    {
        _S151 = (p_0 * _S149 * _S149 + _S149 + 1.0f) * _S150;
    }
    return _S151;
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
    float _S152 = roughness_2 * roughness_2;
    float _S153 = squared_along_0 * (1.0f - _S152) + _S152;
    return 0.31830987334251404f * _S152 * roughness_2 / (_S153 * _S153);
}

float density_between_0(float3 light_1, float3 view_0, float3 tangent_1, float roughness_3)
{
    float3 _S154 = light_1 + view_0;
    float _S155 = dot(_S154, tangent_1);
    return flake_density_0(min(_S155 * _S155 / max(square_1(_S154), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_2, float3 view_1, float3 normal_1, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S156 = dot(light_2, normal_1);
    bool _S157;
    if(_S156 <= 0.0f)
    {
        _S157 = true;
    }
    else
    {
        _S157 = (dot(view_1, normal_1)) <= 0.0f;
    }
    if(_S157)
    {
        return 0.0f;
    }
    float _S158 = max(_S156, 9.99999997475242708e-07f);
    float _S159 = max(dot(view_1, normal_1), 9.99999997475242708e-07f);
    float _S160 = projected_area_1(light_2, tangent_2, roughness_4) * _S159 + projected_area_1(view_1, tangent_2, roughness_4) * _S158;
    float _S161 = optical_depth_1 * _S160 / (_S158 * _S159);
    return 0.25f * density_between_0(light_2, view_1, tangent_2, roughness_4) * (_S161 * mean_attenuation_0(_S161)) * _S158 / _S160;
}

float transmission_1(float3 light_3, float3 view_2, float3 normal_2, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S162 = - dot(light_3, normal_2);
    float _S163 = dot(view_2, normal_2);
    bool _S164;
    if(_S162 <= 0.0f)
    {
        _S164 = true;
    }
    else
    {
        _S164 = _S163 <= 0.0f;
    }
    if(_S164)
    {
        return 0.0f;
    }
    float _S165 = 1.0f / max(_S163, 9.99999997475242708e-07f);
    float _S166 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S162, 9.99999997475242708e-07f);
    float _S167 = projected_area_1(view_2, tangent_3, roughness_5) * _S165;
    return density_between_0(light_3, view_2, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S166, _S167)) * mean_attenuation_0(optical_depth_2 * abs(_S166 - _S167)) * _S165;
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
    float _S168 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S169 = 2.0f * sqrt(_S168) - 1.0f;
    float _S170 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S169, _S170), 0.00999999977648258f, 1.0f), clamp((1.0f - _S168) * sheen_shear_0(_S169, _S170), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S169, _S170), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_4, float3 view_3, float scale_0, float shear_0)
{
    float _S171 = light_4.z;
    bool _S172;
    if(_S171 <= 0.0f)
    {
        _S172 = true;
    }
    else
    {
        _S172 = (view_3.z) <= 0.0f;
    }
    if(_S172)
    {
        return 0.0f;
    }
    float2 _S173 = view_3.xy;
    float _S174 = dot(_S173, _S173);
    float2 _S175;
    if(_S174 > 9.99999968265522539e-21f)
    {
        _S175 = _S173 * float2(rsqrt(_S174)) ;
    }
    else
    {
        _S175 = float2(1.0f, 0.0f);
    }
    float _S176 = scale_0 * dot(light_4.xy, _S175) + shear_0 * _S171;
    float _S177 = scale_0 * (light_4.y * _S175.x - light_4.x * _S175.y);
    float _S178 = _S176 * _S176 + _S177 * _S177 + _S171 * _S171;
    return 0.31830987334251404f * scale_0 * scale_0 * _S171 / max(_S178 * _S178, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_5, float3 view_4, float strength_0, float roughness_7)
{
    float3 _S179 = sheen_lobe_0(view_4.z, roughness_7);
    float _S180 = strength_0 * _S179.z;
    return float2(_S180 * transformed_cosine_0(light_5, view_4, _S179.x, _S179.y), 1.0f - _S180);
}

float3 bounced_value_0(const Bounced_0 thread* bounced_1, float3 light_6, float3 view_5)
{
    float _S181 = light_6.z;
    float3 _S182;
    if((_S181 * view_5.z) < 0.0f)
    {
        _S182 = bounced_1->transmitted_0;
    }
    else
    {
        _S182 = bounced_1->reflected_0;
    }
    return _S182 * float3((abs(_S181) * 0.31830987334251404f)) ;
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

Crossing_0 crossing_at_0(uint _S183, float _S184, float _S185, bool _S186, KernelContext_0 thread* kernelContext_15)
{
    Fabric_0 device* _S187 = kernelContext_15->fabrics_0+_S183;
    thread Crossing_0 crossing_2;
    Cell_0 _S188 = locate_0(_S187->warp_0, _S184, kernelContext_15);
    (&crossing_2)->warp_1 = _S188;
    Cell_0 _S189 = locate_0(_S187->weft_0, _S185, kernelContext_15);
    (&crossing_2)->weft_1 = _S189;
    uint _S190 = _S187->run_words_0 + 2U * ((&(&crossing_2)->weft_1)->thread_0 * _S187->ends_1 + (&(&crossing_2)->warp_1)->thread_0);
    uint _S191 = kernelContext_15->words_0[_S190];
    (&crossing_2)->warp_word_0 = _S191;
    (&crossing_2)->weft_word_0 = kernelContext_15->words_0[_S190 + 1U];
    (&crossing_2)->warp_above_0 = ((_S191 & 1U) == 1U) != _S186;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S192, float _S193, float _S194, bool _S195, KernelContext_0 thread* kernelContext_16)
{
    Fabric_0 device* _S196 = kernelContext_16->fabrics_0+_S192;
    thread Sample_0 sample_0;
    Crossing_0 _S197 = crossing_at_0(_S192, _S193, _S194, _S195, kernelContext_16);
    (&sample_0)->crossing_1 = _S197;
    thread Crossing_0 _S198 = _S197;
    Shown_0 _S199 = shown_at_0(&_S198, _S195);
    (&sample_0)->shown_3 = _S199;
    uint _S200;
    if(_S199.is_warp_0)
    {
        _S200 = _S196->warp_0;
    }
    else
    {
        _S200 = _S196->weft_0;
    }
    uint _S201;
    if(_S199.is_warp_0)
    {
        _S201 = _S196->weft_0;
    }
    else
    {
        _S201 = _S196->warp_0;
    }
    thread Cell_0 _S202 = (&(&sample_0)->crossing_1)->warp_1;
    thread Cell_0 _S203 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S204 = select_cell_0(_S199.is_warp_0, &_S202, &_S203);
    thread Cell_0 _S205 = (&(&sample_0)->crossing_1)->weft_1;
    thread Cell_0 _S206 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S207 = select_cell_0(_S199.is_warp_0, &_S205, &_S206);
    thread Cell_0 _S208 = _S207;
    Run_0 _S209 = unpack_0(_S200, _S201, _S204.thread_0, &_S208, _S199.word_0, kernelContext_16);
    thread Cell_0 _S210 = _S204;
    Section_0 _S211 = section_at_0(&_S210);
    bool _S212;
    if(_S199.on_top_0)
    {
        _S212 = (_S209.distance_0) < (_S211.drop_0 * _S209.bend_1.sine_0);
    }
    else
    {
        _S212 = false;
    }
    bool _S213;
    if(_S199.on_top_0)
    {
        _S213 = !_S212;
    }
    else
    {
        _S213 = false;
    }
    float _S214;
    if(_S213)
    {
        _S214 = 1.0f;
    }
    else
    {
        _S214 = -1.0f;
    }
    float _S215;
    if(_S212)
    {
        _S215 = _S209.other_reach_0;
    }
    else
    {
        _S215 = _S209.reach_0;
    }
    float _S216;
    if(_S212)
    {
        _S216 = _S215 + _S209.distance_0;
    }
    else
    {
        _S216 = max(_S215 - _S209.distance_0, 0.0f);
    }
    float _S217 = _S215 / _S209.bend_1.sine_0 - _S214 * _S211.drop_0;
    float _S218 = _S216 * _S216;
    float _S219 = max(_S217 * _S217 - _S218, 9.99999968265522539e-21f);
    float _S220 = rsqrt(_S219);
    float _S221 = _S218 / (_S219 * _S220 + _S217);
    bool _S222 = _S216 > 0.0f;
    float _S223;
    if(_S199.on_top_0)
    {
        _S223 = 1.0f;
    }
    else
    {
        _S223 = -1.0f;
    }
    float _S224;
    if(_S209.near_start_0)
    {
        _S224 = 1.0f;
    }
    else
    {
        _S224 = -1.0f;
    }
    float _S225 = _S223 * _S224;
    if(_S222)
    {
        _S223 = _S217 * _S220;
    }
    else
    {
        _S223 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S211.slope_0 * _S223;
    if(_S222)
    {
        _S216 = _S225 * _S216 * _S220;
    }
    else
    {
        _S216 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S216;
    Family_0 _S226 = kernelContext_16->families_0[_S200];
    thread Shown_0 _S227 = _S199;
    thread Run_0 _S228 = _S209;
    thread Cell_0 _S229 = _S207;
    float2 _S230 = dive_0(_S201, &_S227, &_S228, &_S229, kernelContext_16);
    if(_S209.straight_0)
    {
        _S214 = 0.0f;
    }
    else
    {
        _S214 = _S226.height_scale_0 * _S214;
    }
    (&sample_0)->height_5 = _S214 * (_S215 * _S209.bend_1.half_tangent_0 - _S221) - _S226.height_scale_0 * _S211.drop_0 - _S230.x;
    float _S231 = _S226.height_scale_0 * (&sample_0)->slope_across_0;
    float _S232 = _S226.height_scale_0 * (&sample_0)->slope_along_0 - _S230.y;
    if(_S199.is_warp_0)
    {
        _S214 = _S231;
    }
    else
    {
        _S214 = _S232;
    }
    (&sample_0)->slope_x_1 = _S214;
    if(_S199.is_warp_0)
    {
        _S214 = _S232;
    }
    else
    {
        _S214 = _S231;
    }
    (&sample_0)->slope_y_1 = _S214;
    (&sample_0)->run_3 = _S209;
    (&sample_0)->section_1 = _S211;
    return sample_0;
}

float steps_per_length_0(uint _S233, const SearchQuality_0 thread* _S234, float3 _S235, KernelContext_0 thread* kernelContext_17)
{
    Fabric_0 device* _S236 = kernelContext_17->fabrics_0+_S233;
    return max(max(abs(_S235.x) * _S236->threads_per_x_0, abs(_S235.y) * _S236->threads_per_y_0) * _S234->steps_per_thread_0, abs(_S235.z) * _S236->per_relief_0 * _S234->steps_per_relief_0);
}

float cell_maximum_0(uint _S237, const Crossing_0 thread* _S238, KernelContext_0 thread* kernelContext_18)
{
    Fabric_0 device* _S239 = kernelContext_18->fabrics_0+_S237;
    bool _S240 = _S238->warp_above_0;
    uint _S241;
    if(_S238->warp_above_0)
    {
        _S241 = _S239->warp_0;
    }
    else
    {
        _S241 = _S239->weft_0;
    }
    uint _S242;
    if(_S240)
    {
        _S242 = _S238->warp_word_0;
    }
    else
    {
        _S242 = _S238->weft_word_0;
    }
    return float(_S242 >> 28U) * kernelContext_18->families_0[_S241].height_scale_0 * kernelContext_18->families_0[_S241].level_0;
}

Probe_0 probe_0(uint _S243, float _S244, float _S245, bool _S246, bool _S247, bool _S248, KernelContext_0 thread* kernelContext_19)
{
    Sample_0 _S249 = sample_at_0(_S243, _S244, _S245, _S246, kernelContext_19);
    thread Probe_0 probe_1;
    (&probe_1)->height_1 = _S249.height_5;
    (&probe_1)->hole_1 = _S249.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S249.slope_x_1;
    (&probe_1)->slope_y_0 = _S249.slope_y_1;
    uint _S250;
    if(_S249.shown_3.is_warp_0)
    {
        _S250 = _S249.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S250 = _S249.crossing_1.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S250;
    thread Crossing_0 _S251 = _S249.crossing_1;
    float _S252 = cell_maximum_0(_S243, &_S251, kernelContext_19);
    (&probe_1)->cell_max_0 = _S252;
    float _S253;
    if(_S247)
    {
        _S253 = _S249.crossing_1.warp_1.above_0;
    }
    else
    {
        _S253 = _S249.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S253;
    if(_S248)
    {
        _S253 = _S249.crossing_1.weft_1.above_0;
    }
    else
    {
        _S253 = _S249.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S253;
    bool _S254 = !_S249.shown_3.is_warp_0;
    thread Cell_0 _S255 = _S249.crossing_1.warp_1;
    thread Shown_0 _S256 = _S249.shown_3;
    thread Run_0 _S257 = _S249.run_3;
    float _S258 = outline_distance_0(&_S255, &_S256, &_S257, _S254, _S247);
    (&probe_1)->edge_x_0 = _S258;
    thread Cell_0 _S259 = _S249.crossing_1.weft_1;
    thread Shown_0 _S260 = _S249.shown_3;
    thread Run_0 _S261 = _S249.run_3;
    float _S262 = outline_distance_0(&_S259, &_S260, &_S261, _S249.shown_3.is_warp_0, _S248);
    (&probe_1)->edge_y_0 = _S262;
    return probe_1;
}

bool is_free_0(uint _S263, const SearchQuality_0 thread* _S264, float3 _S265, float3 _S266, bool _S267, float _S268, KernelContext_0 thread* kernelContext_20)
{
    float _S269 = _S266.z;
    if(_S269 <= 0.0f)
    {
        return false;
    }
    float _S270 = _S264->shadow_share_0;
    float _S271 = steps_per_length_0(_S263, _S264, _S266, kernelContext_20);
    float _S272 = 1.0f / max(_S270 * _S271, 9.99999971718068537e-10f);
    StepControl_0 _S273 = step_control_0(_S266.xy, _S272);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S274;
        if(count_1 < 1024U)
        {
            _S274 = (_S265.z + _S269 * distance_1) < _S268;
        }
        else
        {
            _S274 = false;
        }
        if(_S274)
        {
        }
        else
        {
            break;
        }
        float3 _S275 = _S265 + _S266 * float3(distance_1) ;
        Probe_0 _S276 = probe_0(_S263, _S275.x, _S275.y, _S267, _S273.right_0, _S273.up_0, kernelContext_20);
        float _S277 = _S275.z;
        float _S278 = _S277 - _S276.height_1;
        float _S279 = _S269 - _S276.slope_x_0 * _S266.x - _S276.slope_y_0 * _S266.y;
        bool _S280;
        if(!_S276.hole_1)
        {
            _S280 = _S278 < 0.0f;
        }
        else
        {
            _S280 = false;
        }
        if(_S280)
        {
            return false;
        }
        thread PreviousSample_0 _S281 = previous_3;
        thread Probe_0 _S282 = _S276;
        float _S283 = way_back_to_dip_0(&_S281, _S278, _S279, last_step_0, &_S282);
        if(_S283 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S283;
            distance_1 = distance_1 - _S283;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S284 = _S277 > (_S276.cell_max_0);
        thread Probe_0 _S285 = _S276;
        PreviousSample_0 _S286 = after_sample_0(_S278, _S279, &_S285, _S284);
        float last_step_2;
        if(_S284)
        {
            thread StepControl_0 _S287 = _S273;
            float _S288 = StepControl_to_cell_exit_0(&_S287, _S276.side_x_0, _S276.side_y_0);
            last_step_2 = max(_S288, _S272);
        }
        else
        {
            thread StepControl_0 _S289 = _S273;
            thread Probe_0 _S290 = _S276;
            float _S291 = StepControl_to_next_sample_0(&_S289, &_S290, _S278, _S279);
            last_step_2 = _S291;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S286;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S292, const SearchQuality_0 thread* _S293, float _S294, float _S295, float3 _S296, bool _S297, KernelContext_0 thread* kernelContext_21)
{
    Fabric_0 device* _S298 = kernelContext_21->fabrics_0+_S292;
    Sample_0 _S299 = sample_at_0(_S292, _S294, _S295, _S297, kernelContext_21);
    if(!_S299.shown_3.hole_0)
    {
        return false;
    }
    float3 _S300 = float3(_S294, _S295, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S301;
        if(side_0 < 2U)
        {
            _S301 = passes_0;
        }
        else
        {
            _S301 = false;
        }
        if(_S301)
        {
        }
        else
        {
            break;
        }
        float3 _S302;
        if(side_0 == 0U)
        {
            _S302 = _S296;
        }
        else
        {
            _S302 = float3(- _S296.x, - _S296.y, _S296.z);
        }
        bool _S303 = is_free_0(_S292, _S293, _S300, _S302, _S297 != (side_0 == 1U), _S298->height_high_0, kernelContext_21);
        uint _S304 = side_0 + 1U;
        passes_0 = _S303;
        side_0 = _S304;
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

float max_height_along_0(uint _S305, float _S306, float _S307, float _S308, float3 _S309, bool _S310, KernelContext_0 thread* kernelContext_22)
{
    Fabric_0 device* _S311 = kernelContext_22->fabrics_0+_S305;
    Cell_0 _S312 = locate_0(_S311->warp_0, _S306, kernelContext_22);
    uint _S313 = _S312.thread_0 / 2U;
    Cell_0 _S314 = locate_0(_S311->weft_0, _S307, kernelContext_22);
    uint _S315 = _S314.thread_0 / 2U;
    float _S316 = _S309.x;
    uint _S317;
    if(_S316 > 0.0f)
    {
        _S317 = 1U;
    }
    else
    {
        _S317 = 0U;
    }
    float _S318 = _S309.y;
    uint _S319;
    if(_S318 > 0.0f)
    {
        _S319 = 2U;
    }
    else
    {
        _S319 = 0U;
    }
    uint _S320 = kernelContext_22->words_0[_S311->max_heights_0 + 4U * (_S315 * _S311->max_height_columns_0 + _S313) + (_S317 + _S319)];
    int number_0;
    if(_S310)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S321 = _S320 >> uint(number_0);
    float _S322 = max(abs(_S316) * _S311->threads_per_x_0, abs(_S318) * _S311->threads_per_y_0) / _S309.z;
    float _S323 = _S311->height_high_0;
    float max_height_0 = _S311->height_high_0;
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
        if(((max_height_0 - _S308) * _S322) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S321 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S323);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S324, float _S325, float _S326, bool _S327, bool _S328, bool _S329, KernelContext_0 thread* kernelContext_23)
{
    Crossing_0 _S330 = crossing_at_0(_S324, _S325, _S326, _S327, kernelContext_23);
    thread Crossing_0 _S331 = _S330;
    float _S332 = cell_maximum_0(_S324, &_S331, kernelContext_23);
    float _S333;
    if(_S328)
    {
        _S333 = _S330.warp_1.above_0;
    }
    else
    {
        _S333 = _S330.warp_1.below_0;
    }
    float _S334;
    if(_S329)
    {
        _S334 = _S330.weft_1.above_0;
    }
    else
    {
        _S334 = _S330.weft_1.below_0;
    }
    return float3(_S332, _S333, _S334);
}

float first_sample_height_0(uint _S335, const ViewRay_0 thread* _S336, const StepControl_0 thread* _S337, bool _S338, KernelContext_0 thread* kernelContext_24)
{
    float _S339 = max_height_along_0(_S335, _S336->origin_0.x, _S336->origin_0.y, 0.0f, float3(_S336->slope_1, 1.0f), _S338, kernelContext_24);
    uint count_2 = 0U;
    float height_7 = _S339;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S340 = ViewRay_at_0(_S336, height_7);
        float3 _S341 = cell_bounds_0(_S335, _S340.x, _S340.y, _S338, _S337->right_0, _S337->up_0, kernelContext_24);
        float _S342 = height_7 - _S341.x;
        float _S343 = StepControl_to_cell_exit_0(_S337, _S341.y, _S341.z);
        float height_8 = height_7 - clamp(_S342, 0.0f, _S343);
        if(_S342 <= _S343)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S344, const ViewRay_0 thread* _S345, const StepControl_0 thread* _S346, bool _S347, KernelContext_0 thread* kernelContext_25)
{
    Fabric_0 device* _S348 = kernelContext_25->fabrics_0+_S344;
    float _S349 = _S348->height_low_0 - (_S348->height_high_0 - _S348->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S350 = first_sample_height_0(_S344, _S345, _S346, _S347, kernelContext_25);
    (&end_1)->height_6 = _S350;
    (&end_1)->last_step_3 = _S346->epsilon_0;
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
        float2 _S351 = ViewRay_at_0(_S345, (&end_1)->height_6);
        Probe_0 _S352 = probe_0(_S344, _S351.x, _S351.y, _S347, _S346->right_0, _S346->up_0, kernelContext_25);
        float _S353 = (&end_1)->height_6 - _S352.height_1;
        thread Probe_0 _S354 = _S352;
        float _S355 = ViewRay_rate_0(_S345, &_S354);
        (&end_1)->depth_1 = - _S353;
        (&end_1)->rate_4 = _S355;
        bool _S356;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S356 = !_S352.hole_1;
        }
        else
        {
            _S356 = false;
        }
        bool _S357;
        if(_S356)
        {
            _S357 = ((&(&end_1)->previous_4)->yarn_0) == (_S352.yarn_1);
        }
        else
        {
            _S357 = false;
        }
        (&end_1)->smooth_0 = _S357;
        bool _S358;
        if(!_S352.hole_1)
        {
            _S358 = _S353 <= 0.0f;
        }
        else
        {
            _S358 = false;
        }
        bool _S359;
        if(_S358)
        {
            _S359 = true;
        }
        else
        {
            _S359 = ((&end_1)->height_6) <= _S349;
        }
        if(_S359)
        {
            break;
        }
        thread PreviousSample_0 _S360 = (&end_1)->previous_4;
        thread Probe_0 _S361 = _S352;
        float _S362 = way_back_to_dip_0(&_S360, _S353, _S355, (&end_1)->last_step_3, &_S361);
        if(_S362 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S362;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S362;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S363 = StepControl_to_cell_exit_0(_S346, _S352.side_x_0, _S352.side_y_0);
        float _S364 = min(_S363, (&end_1)->height_6 - _S352.cell_max_0);
        thread Probe_0 _S365 = _S352;
        float _S366 = StepControl_to_next_sample_0(_S346, &_S365, _S353, _S355);
        bool _S367 = _S364 > _S366;
        thread Probe_0 _S368 = _S352;
        PreviousSample_0 _S369 = after_sample_0(_S353, _S355, &_S368, _S367);
        (&end_1)->previous_4 = _S369;
        float _S370 = max(_S364, _S366);
        (&end_1)->last_step_3 = _S370;
        (&end_1)->height_6 = (&end_1)->height_6 - _S370;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S371, const ViewRay_0 thread* _S372, const StepControl_0 thread* _S373, bool _S374, const ViewRayEnd_0 thread* _S375, uint _S376, KernelContext_0 thread* kernelContext_26)
{
    Fabric_0 device* _S377 = kernelContext_26->fabrics_0+_S371;
    float _S378 = _S377->height_high_0 - _S377->height_low_0;
    float _S379 = _S375->height_6;
    float _S380 = _S375->last_step_3;
    float above_2 = _S375->height_6 + _S375->last_step_3;
    float above_gap_1 = clamp((&_S375->previous_4)->clearance_0, 0.0f, _S378);
    float under_gap_1 = clamp(_S375->depth_1, 0.0f, _S378);
    float _S381 = cubic_root_0(above_gap_1, - under_gap_1, (&_S375->previous_4)->rate_0 * _S375->last_step_3, _S375->rate_4 * _S375->last_step_3);
    bool _S382 = _S375->smooth_0;
    float middle_0;
    if(_S375->smooth_0)
    {
        middle_0 = above_2 - _S381 * _S380;
    }
    else
    {
        middle_0 = between_0(above_2, _S379, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S379;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S376)
        {
        }
        else
        {
            break;
        }
        float2 _S383 = ViewRay_at_0(_S372, middle_0);
        Probe_0 _S384 = probe_0(_S371, _S383.x, _S383.y, _S374, _S373->right_0, _S373->up_0, kernelContext_26);
        float _S385;
        if(_S384.hole_1)
        {
            _S385 = -1.0e+09f;
        }
        else
        {
            _S385 = _S384.height_1;
        }
        float _S386 = clamp(middle_0 - _S385, - _S378, _S378);
        float _S387;
        if(_S386 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S387 = 0.5f * above_gap_2;
            }
            else
            {
                _S387 = above_gap_2;
            }
            float _S388 = - _S386;
            under_1 = middle_0;
            above_gap_2 = _S387;
            under_gap_2 = _S388;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S387 = 0.5f * under_gap_2;
            }
            else
            {
                _S387 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S386;
            under_gap_2 = _S387;
            side_1 = -1.0f;
        }
        if(_S382)
        {
            thread Probe_0 _S389 = _S384;
            float _S390 = ViewRay_rate_0(_S372, &_S389);
            middle_0 = clamp(middle_0 + _S386 / min(_S390, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S382)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S391, const SearchQuality_0 thread* _S392, float _S393, float _S394, float3 _S395, bool _S396, KernelContext_0 thread* kernelContext_27)
{
    float _S397 = max(_S395.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S393, _S394);
    float2 _S398 = _S395.xy / float2(_S397) ;
    (&ray_0)->slope_1 = _S398;
    float2 _S399 = - _S398;
    float _S400 = steps_per_length_0(_S391, _S392, _S395, kernelContext_27);
    StepControl_0 _S401 = step_control_0(_S399, 1.0f / max(_S400 / _S397, 9.99999971718068537e-10f));
    thread ViewRay_0 _S402 = ray_0;
    thread StepControl_0 _S403 = _S401;
    ViewRayEnd_0 _S404 = search_down_0(_S391, &_S402, &_S403, _S396, kernelContext_27);
    thread Hit_0 hit_0;
    (&hit_0)->hole_3 = false;
    thread ViewRay_0 _S405 = ray_0;
    thread StepControl_0 _S406 = _S401;
    thread ViewRayEnd_0 _S407 = _S404;
    float _S408 = refined_height_0(_S391, &_S405, &_S406, _S396, &_S407, _S392->refinements_0, kernelContext_27);
    (&hit_0)->height_4 = _S408;
    thread ViewRay_0 _S409 = ray_0;
    float2 _S410 = ViewRay_at_0(&_S409, _S408);
    (&hit_0)->x_8 = _S410.x;
    (&hit_0)->y_4 = _S410.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S411, const SearchQuality_0 thread* _S412, float _S413, float _S414, float3 _S415, bool _S416, KernelContext_0 thread* kernelContext_28)
{
    bool _S417 = passes_through_0(_S411, _S412, _S413, _S414, _S415, _S416, kernelContext_28);
    if(!_S417)
    {
        Hit_0 _S418 = first_hit_of_yarn_0(_S411, _S412, _S413, _S414, _S415, _S416, kernelContext_28);
        return _S418;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_8 = _S413;
    (&hit_1)->y_4 = _S414;
    (&hit_1)->height_4 = 0.0f;
    (&hit_1)->hole_3 = true;
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

SurfacePoint_0 surface_at_0(uint _S419, float _S420, float _S421, bool _S422, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S423 = kernelContext_29->fabrics_0+_S419;
    Sample_0 _S424 = sample_at_0(_S419, _S420, _S421, _S422, kernelContext_29);
    float _S425;
    if(_S424.shown_3.is_warp_0)
    {
        _S425 = _S424.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S425 = _S424.crossing_1.weft_1.half_width_1;
    }
    uint _S426;
    if(_S424.shown_3.is_warp_0)
    {
        _S426 = _S423->warp_0;
    }
    else
    {
        _S426 = _S423->weft_0;
    }
    Family_0 _S427 = kernelContext_29->families_0[_S426];
    float _S428;
    if(_S422)
    {
        _S428 = -1.0f;
    }
    else
    {
        _S428 = 1.0f;
    }
    float _S429 = _S427.twist_sine_0 * _S428;
    Family_0 _S430 = kernelContext_29->families_0[_S426];
    if(_S424.shown_3.is_warp_0)
    {
        _S428 = 1.0f;
    }
    else
    {
        _S428 = -1.0f;
    }
    float2 _S431 = fibre_direction_0(_S424.slope_across_0, _S428 * _S424.slope_along_0, _S429, _S430.twist_cosine_0);
    float _S432;
    if(_S424.shown_3.is_warp_0)
    {
        _S432 = _S424.slope_x_1;
    }
    else
    {
        _S432 = _S424.slope_y_1;
    }
    float _S433;
    if(_S424.shown_3.is_warp_0)
    {
        _S433 = _S424.slope_y_1;
    }
    else
    {
        _S433 = _S424.slope_x_1;
    }
    float _S434 = _S431.x;
    float _S435 = _S431.y;
    float _S436 = _S432 * _S434 + _S428 * _S433 * _S435;
    float _S437 = _S425 * 1.0154266357421875f;
    float _S438 = _S437 * arc_sine_0(clamp(_S424.section_1.across_1 / _S437, -1.0f, 1.0f));
    if(_S424.shown_3.is_warp_0)
    {
        _S425 = _S421;
    }
    else
    {
        _S425 = - _S420;
    }
    thread SurfacePoint_0 point_0;
    (&point_0)->hole_4 = _S424.shown_3.hole_0;
    (&point_0)->is_warp_2 = _S424.shown_3.is_warp_0;
    (&point_0)->warp_thread_0 = _S424.crossing_1.warp_1.thread_0;
    (&point_0)->weft_thread_0 = _S424.crossing_1.weft_1.thread_0;
    (&point_0)->height_9 = _S424.height_5;
    (&point_0)->normal_4 = normalize(float3(- _S424.slope_x_1, - _S424.slope_y_1, 1.0f));
    float3 _S439;
    if(_S424.shown_3.is_warp_0)
    {
        _S439 = float3(_S434, _S435, _S436);
    }
    else
    {
        _S439 = float3(- _S435, _S434, _S436);
    }
    (&point_0)->tangent_5 = normalize(_S439);
    (&point_0)->across_2 = _S424.section_1.across_1;
    (&point_0)->fibre_across_0 = _S438 * _S430.twist_cosine_0 + _S425 * _S429;
    (&point_0)->fibre_along_0 = _S425 * _S430.twist_cosine_0 - _S438 * _S429;
    return point_0;
}

Albedos_0 vary_albedos_0(uint _S440, const Albedos_0 thread* _S441, uint _S442, uint _S443, KernelContext_0 thread* kernelContext_30)
{
    Fabric_0 device* _S444 = kernelContext_30->fabrics_0+_S440;
    float3 _S445 = max(_S441->specular_reflect_0, _S441->specular_transmit_0);
    float3 _S446 = _S441->diffuse_reflect_0 + _S441->diffuse_transmit_0;
    float3 _S447 = float3(_S444->layer_bound_0) ;
    float3 _S448 = float3(1.0f) ;
    float3 _S449 = float3(bounded_gain_0(thread_gain_0(_S442, _S444->colour_noise_0, _S444->seed_0), _S446, _S448 - _S447 * _S445)) ;
    float _S450 = bounded_gain_0(fibre_gain_0(_S442, _S443, _S444->fibre_noise_0, _S444->seed_0), _S445, min((_S448 - _S449 * _S446) / _S447, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S449 * _S441->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S449 * _S441->diffuse_transmit_0;
    float3 _S451 = float3(_S450) ;
    (&varied_0)->specular_reflect_0 = _S451 * _S441->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S451 * _S441->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S452, const SurfacePoint_0 thread* _S453, const Albedos_0 thread* _S454, float _S455, float _S456, KernelContext_0 thread* kernelContext_31)
{
    Fabric_0 device* _S457 = kernelContext_31->fabrics_0+_S452;
    bool _S458 = _S453->is_warp_2;
    float _S459;
    if(_S453->is_warp_2)
    {
        _S459 = _S455;
    }
    else
    {
        _S459 = _S456;
    }
    float _S460 = _S459 - _S453->across_2;
    uint _S461;
    if(_S458)
    {
        _S461 = _S457->warp_0;
    }
    else
    {
        _S461 = _S457->weft_0;
    }
    Family_0 _S462 = kernelContext_31->families_0[_S461];
    int _S463 = int(kernelContext_31->families_0[_S461].count_0);
    if(_S458)
    {
        _S461 = _S453->warp_thread_0;
    }
    else
    {
        _S461 = _S453->weft_thread_0;
    }
    uint _S464 = uint(int(floor(_S460 / _S462.period_0)) * _S463 + int(_S461)) * 2U;
    if(_S458)
    {
        _S461 = 1U;
    }
    else
    {
        _S461 = 0U;
    }
    float _S465 = floor(_S453->fibre_across_0 / _S457->fibre_size_0);
    Albedos_0 _S466 = vary_albedos_0(_S452, _S454, _S464 + _S461, uint(int(_S465)) * 65536U + uint(int(floor(_S453->fibre_along_0 / (_S457->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S465))), kernelContext_31);
    return _S466;
}

YarnPoint_0 yarn_point_of_0(uint _S467, const SurfacePoint_0 thread* _S468, float _S469, float _S470, bool _S471, bool _S472, KernelContext_0 thread* kernelContext_32)
{
    Fabric_0 device* _S473 = kernelContext_32->fabrics_0+_S467;
    bool _S474 = _S468->is_warp_2;
    uint _S475;
    if(_S468->is_warp_2)
    {
        _S475 = _S473->warp_0;
    }
    else
    {
        _S475 = _S473->weft_0;
    }
    uint _S476;
    if(_S474)
    {
        _S476 = _S468->warp_thread_0;
    }
    else
    {
        _S476 = _S468->weft_thread_0;
    }
    Albedos_0 _S477 = albedos_of_0(_S475, _S476, kernelContext_32);
    bool _S478;
    if((_S473->fibre_noise_0) > 0.0f)
    {
        _S478 = true;
    }
    else
    {
        _S478 = (_S473->colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_2;
    if(_S478)
    {
        thread Albedos_0 _S479 = _S477;
        Albedos_0 _S480 = varied_at_0(_S467, _S468, &_S479, _S469, _S470, kernelContext_32);
        albedos_2 = _S480;
    }
    else
    {
        albedos_2 = _S477;
    }
    thread YarnPoint_0 point_1;
    (&point_1)->back_5 = _S471;
    (&point_1)->hole_2 = _S472;
    (&point_1)->is_warp_1 = _S474;
    (&point_1)->x_7 = _S469;
    (&point_1)->y_3 = _S470;
    (&point_1)->height_3 = _S468->height_9;
    (&point_1)->normal_3 = _S468->normal_4;
    (&point_1)->tangent_4 = _S468->tangent_5;
    (&point_1)->roughness_8 = kernelContext_32->families_0[_S475].roughness_0;
    (&point_1)->albedos_1 = albedos_2;
    return point_1;
}

YarnPoint_0 locate_yarn_0(uint _S481, const SearchQuality_0 thread* _S482, float _S483, float _S484, float3 _S485, KernelContext_0 thread* kernelContext_33)
{
    bool _S486 = (_S485.z) < 0.0f;
    Hit_0 _S487 = first_hit_0(_S481, _S482, _S483, _S484, to_face_frame_0(_S485, _S486), _S486, kernelContext_33);
    SurfacePoint_0 _S488 = surface_at_0(_S481, _S487.x_8, _S487.y_4, _S486, kernelContext_33);
    thread SurfacePoint_0 _S489 = _S488;
    YarnPoint_0 _S490 = yarn_point_of_0(_S481, &_S489, _S487.x_8, _S487.y_4, _S486, _S487.hole_3, kernelContext_33);
    return _S490;
}

float openness_number_0(uint _S491, uint _S492, KernelContext_0 thread* kernelContext_34)
{
    float _S493 = table_number_0((kernelContext_34->fabrics_0+_S491)->openness_0 + _S492, kernelContext_34);
    return _S493;
}

Blocked_0 blocked_of_terms_0(uint _S494, uint _S495, const array<float, int(6)> thread* _S496, uint _S497, KernelContext_0 thread* kernelContext_35)
{
    thread array<float, int(3)> shares_0;
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
            if(term_0 < _S497)
            {
            }
            else
            {
                break;
            }
            float _S498 = openness_number_0(_S494, _S495 + share_1 * _S497 + term_0, kernelContext_35);
            shares_0[share_1] = shares_0[share_1] + _S498 * (*_S496)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_1] = saturate(shares_0[share_1]);
        share_1 = share_1 + 1U;
    }
    thread Blocked_0 blocked_1;
    (&blocked_1)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_1)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_1)->far_0 = shares_0[int(1)];
    return blocked_1;
}

Blocked_0 blocked_at_0(uint _S499, bool _S500, bool _S501, float _S502, float _S503, KernelContext_0 thread* kernelContext_36)
{
    float _S504 = openness_number_0(_S499, 158U, kernelContext_36);
    float _S505 = _S503 * _S504;
    float _S506 = _S502 * _S502;
    float _S507 = _S502 * _S505;
    float _S508 = _S505 * _S505;
    uint _S509;
    if(_S501)
    {
        _S509 = 2U;
    }
    else
    {
        _S509 = 0U;
    }
    uint _S510;
    if(_S500)
    {
        _S510 = 0U;
    }
    else
    {
        _S510 = 1U;
    }
    uint _S511 = 60U + (_S509 + _S510) * 18U;
    thread array<float, int(6)> _S512;
    _S512[int(0)] = 1.0f;
    _S512[int(1)] = _S502;
    _S512[int(2)] = _S505;
    _S512[int(3)] = _S506;
    _S512[int(4)] = _S507;
    _S512[int(5)] = _S508;
    Blocked_0 _S513 = blocked_of_terms_0(_S499, _S511, &_S512, 6U, kernelContext_36);
    return _S513;
}

Scattered_0 scattered_by_0(uint _S514, const Albedos_0 thread* _S515, uint _S516, float3 _S517, KernelContext_0 thread* kernelContext_37)
{
    uint _S518 = 159U + 2U * _S516;
    thread Scattered_0 yarn_3;
    float3 _S519 = _S517 * _S515->diffuse_reflect_0;
    float _S520 = openness_number_0(_S514, _S518, kernelContext_37);
    (&yarn_3)->back_4 = _S519 + float3(_S520)  * _S515->specular_reflect_0;
    float3 _S521 = _S517 * _S515->diffuse_transmit_0;
    float _S522 = openness_number_0(_S514, _S518 + 1U, kernelContext_37);
    (&yarn_3)->through_0 = _S521 + float3(_S522)  * _S515->specular_transmit_0;
    return yarn_3;
}

float openness_number_1(uint _S523, uint _S524, KernelContext_0 thread* kernelContext_38)
{
    float _S525 = table_number_0((kernelContext_38->fabrics_0+_S523)->openness_0 + _S524, kernelContext_38);
    return _S525;
}

void sent_0(uint _S526, uint _S527, float3 _S528, float3 _S529, float3 _S530, float3 _S531, float3 thread* _S532, float3 thread* _S533, KernelContext_0 thread* kernelContext_39)
{
    uint _S534 = 146U + 4U * _S527;
    float _S535 = openness_number_1(_S526, _S534, kernelContext_39);
    float _S536 = openness_number_1(_S526, _S534 + 1U, kernelContext_39);
    float _S537 = openness_number_1(_S526, _S534 + 2U, kernelContext_39);
    float _S538 = openness_number_1(_S526, _S534 + 3U, kernelContext_39);
    float3 _S539 = float3(1.0f) ;
    float3 _S540 = _S539 - _S530 * float3(_S535) ;
    float3 _S541 = _S539 - _S531 * float3(_S538) ;
    float3 _S542 = _S539 / (_S540 * _S541 - _S530 * _S531 * float3((_S536 * _S537)) );
    *_S532 = (_S528 * _S541 + _S530 * float3(_S536)  * _S529) * _S542;
    *_S533 = (_S529 * _S540 + _S531 * float3(_S537)  * _S528) * _S542;
    return;
}

FaceSends_0 face_sends_0(uint _S543, uint _S544, const Scattered_0 thread* _S545, const Scattered_0 thread* _S546, KernelContext_0 thread* kernelContext_40)
{
    uint _S547 = 2U * _S544;
    uint _S548 = 142U + _S547;
    float _S549 = openness_number_0(_S543, _S548, kernelContext_40);
    float _S550 = openness_number_0(_S543, _S548 + 1U, kernelContext_40);
    float3 _S551 = _S545->back_4;
    float3 _S552 = float3((1.0f - _S549))  * _S545->back_4;
    float3 _S553 = _S546->back_4;
    float3 _S554 = float3((1.0f - _S550))  * _S546->back_4;
    thread FaceSends_0 sends_1;
    uint _S555 = 154U + _S547;
    float _S556 = openness_number_0(_S543, _S555, kernelContext_40);
    (&sends_1)->blocks_warp_0 = _S556;
    float _S557 = openness_number_0(_S543, _S555 + 1U, kernelContext_40);
    (&sends_1)->blocks_weft_0 = _S557;
    (&sends_1)->open_0 = _S556 * _S549 + _S557 * _S550;
    sent_0(_S543, _S544, float3(_S549)  * _S551, float3(_S550)  * _S553, _S552, _S554, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0, kernelContext_40);
    sent_0(_S543, _S544, _S545->through_0, _S546->through_0, _S552, _S554, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0, kernelContext_40);
    return sends_1;
}

Interior_0 interior_of_0(uint _S558, float3 _S559, bool _S560, KernelContext_0 thread* kernelContext_41)
{
    Fabric_0 device* _S561 = kernelContext_41->fabrics_0+_S558;
    Albedos_0 _S562 = table_albedos_0(kernelContext_41->families_0[_S561->warp_0].colour_mean_0, kernelContext_41);
    thread Albedos_0 _S563 = _S562;
    Scattered_0 _S564 = scattered_by_0(_S558, &_S563, 0U, _S559, kernelContext_41);
    Albedos_0 _S565 = table_albedos_0(kernelContext_41->families_0[_S561->weft_0].colour_mean_0, kernelContext_41);
    thread Albedos_0 _S566 = _S565;
    Scattered_0 _S567 = scattered_by_0(_S558, &_S566, 1U, _S559, kernelContext_41);
    uint _S568;
    if(_S560)
    {
        _S568 = 1U;
    }
    else
    {
        _S568 = 0U;
    }
    thread Scattered_0 _S569 = _S564;
    thread Scattered_0 _S570 = _S567;
    FaceSends_0 _S571 = face_sends_0(_S558, _S568, &_S569, &_S570, kernelContext_41);
    if(_S560)
    {
        _S568 = 0U;
    }
    else
    {
        _S568 = 1U;
    }
    thread Scattered_0 _S572 = _S564;
    thread Scattered_0 _S573 = _S567;
    FaceSends_0 _S574 = face_sends_0(_S558, _S568, &_S572, &_S573, kernelContext_41);
    float3 _S575 = float3(_S571.blocks_warp_0) ;
    float3 _S576 = float3(_S571.blocks_weft_0) ;
    float3 _S577 = _S575 * _S571.crossing_warp_0 + _S576 * _S571.crossing_weft_0;
    float3 _S578 = float3(_S574.blocks_warp_0) ;
    float3 _S579 = float3(_S574.blocks_weft_0) ;
    float3 _S580 = _S578 * _S574.crossing_warp_0 + _S579 * _S574.crossing_weft_0;
    float _S581 = 1.0f - _S571.open_0;
    float _S582 = 1.0f - _S574.open_0;
    float3 _S583 = float3(1.0f) ;
    float3 _S584 = _S583 / (_S583 - _S577 * _S580 * float3((_S581 * _S582)) );
    float3 _S585 = _S580 * (float3(_S571.open_0)  + float3(_S581)  * (_S575 * _S571.sky_warp_0 + _S576 * _S571.sky_weft_0)) * _S584;
    float3 _S586 = _S577 * (float3(_S574.open_0)  + float3(_S582)  * (_S578 * _S574.sky_warp_0 + _S579 * _S574.sky_weft_0)) * _S584;
    thread FaceSends_0 _S587 = _S571;
    FaceRadiance_0 _S588 = face_radiance_0(&_S587, _S574.open_0, _S585, _S586);
    thread FaceSends_0 _S589 = _S574;
    FaceRadiance_0 _S590 = face_radiance_0(&_S589, _S571.open_0, _S586, _S585);
    thread Interior_0 interior_1;
    (&interior_1)->warp_3 = _S588.warp_2;
    (&interior_1)->weft_3 = _S588.weft_2;
    (&interior_1)->leaked_1 = _S588.leaked_0;
    (&interior_1)->far_1 = _S590.mean_0;
    (&interior_1)->far_leaked_0 = _S590.leaked_0;
    return interior_1;
}

Bounced_0 bounced_at_0(uint _S591, const YarnPoint_0 thread* _S592, float3 _S593, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S594 = kernelContext_42->fabrics_0+_S591;
    thread Bounced_0 nothing_0;
    float3 _S595 = float3(0.0f) ;
    (&nothing_0)->reflected_0 = _S595;
    (&nothing_0)->transmitted_0 = _S595;
    bool _S596;
    if((_S594->openness_0) == 4294967295U)
    {
        _S596 = true;
    }
    else
    {
        _S596 = _S592->hole_2;
    }
    if(_S596)
    {
        return nothing_0;
    }
    bool _S597 = _S592->is_warp_1;
    bool _S598 = _S592->back_5;
    Blocked_0 _S599 = blocked_at_0(_S591, _S592->is_warp_1, _S592->back_5, _S592->normal_3.z, _S592->height_3, kernelContext_42);
    uint _S600;
    if(_S597)
    {
        _S600 = 0U;
    }
    else
    {
        _S600 = 1U;
    }
    Scattered_0 _S601 = scattered_by_0(_S591, &_S592->albedos_1, _S600, _S593, kernelContext_42);
    Interior_0 _S602 = interior_of_0(_S591, _S593, _S598, kernelContext_42);
    thread Blocked_0 _S603 = _S599;
    thread Scattered_0 _S604 = _S601;
    thread Interior_0 _S605 = _S602;
    Bounced_0 _S606 = bounced_by_0(&_S603, &_S604, &_S605);
    return _S606;
}

float3 scattered_0(uint _S607, const YarnPoint_0 thread* _S608, float3 _S609, float3 _S610, KernelContext_0 thread* kernelContext_43)
{
    Fabric_0 device* _S611 = kernelContext_43->fabrics_0+_S607;
    float3 _S612 = float3(0.0f) ;
    bool _S613 = !_S608->hole_2;
    bool _S614;
    if(_S613)
    {
        _S614 = (_S609.z) > 0.0f;
    }
    else
    {
        _S614 = false;
    }
    float3 value_1;
    if(_S614)
    {
        value_1 = (&_S608->albedos_1)->diffuse_reflect_0 * float3(diffuse_reflection_0(_S609, _S608->normal_3, _S611->diffuse_blend_0))  + (&_S608->albedos_1)->specular_reflect_0 * float3(reflection_0(_S609, _S610, _S608->normal_3, _S608->tangent_4, _S608->roughness_8, _S611->optical_depth_0)) ;
    }
    else
    {
        if(_S613)
        {
            _S614 = (_S609.z) < 0.0f;
        }
        else
        {
            _S614 = false;
        }
        if(_S614)
        {
            value_1 = (&_S608->albedos_1)->diffuse_transmit_0 * float3(diffuse_reflection_0(- _S609, _S608->normal_3, _S611->diffuse_blend_0))  + (&_S608->albedos_1)->specular_transmit_0 * float3(transmission_1(_S609, _S610, _S608->normal_3, _S608->tangent_4, _S608->roughness_8, _S611->optical_depth_0)) ;
        }
        else
        {
            value_1 = _S612;
        }
    }
    float _S615 = _S611->sheen_strength_0;
    if((_S611->sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S616 = sheen_with_transmittance_0(_S609, _S610, _S615, _S611->sheen_roughness_0);
    return float3(_S616.y)  * value_1 + float3(_S616.x) ;
}

bool unoccluded_0(uint _S617, const SearchQuality_0 thread* _S618, float _S619, float _S620, float _S621, float3 _S622, bool _S623, KernelContext_0 thread* kernelContext_44)
{
    Fabric_0 device* _S624 = kernelContext_44->fabrics_0+_S617;
    if((_S622.z) <= 0.0f)
    {
        return false;
    }
    float _S625 = max_height_along_0(_S617, _S619, _S620, _S621, _S622, _S623, kernelContext_44);
    bool _S626 = is_free_0(_S617, _S618, float3(_S619, _S620, _S621 + _S624->lift_0), _S622, _S623, _S625, kernelContext_44);
    return _S626;
}

bool is_lit_0(uint _S627, const SearchQuality_0 thread* _S628, const YarnPoint_0 thread* _S629, float3 _S630, KernelContext_0 thread* kernelContext_45)
{
    if(_S629->hole_2)
    {
        return true;
    }
    bool _S631 = _S629->back_5;
    float3 _S632 = to_face_frame_0(_S630, _S629->back_5);
    float _S633 = _S632.z;
    bool _S634 = _S633 < 0.0f;
    float3 _S635 = _S629->normal_3;
    float _S636 = _S629->height_3;
    float3 normal_5;
    float height_10;
    if(_S634)
    {
        SurfacePoint_0 _S637 = surface_at_0(_S627, _S629->x_7, _S629->y_3, !_S631, kernelContext_45);
        normal_5 = _S637.normal_4;
        height_10 = _S637.height_9;
    }
    else
    {
        normal_5 = _S635;
        height_10 = _S636;
    }
    float3 _S638 = float3(_S632.xy, abs(_S633));
    if((dot(normal_5, _S638)) <= 0.0f)
    {
        return false;
    }
    bool _S639 = unoccluded_0(_S627, _S628, _S629->x_7, _S629->y_3, height_10, _S638, _S631 != _S634, kernelContext_45);
    return _S639;
}

float3 evaluate_with_0(uint _S640, const SearchQuality_0 thread* _S641, const YarnPoint_0 thread* _S642, const Bounced_0 thread* _S643, float3 _S644, float3 _S645, KernelContext_0 thread* kernelContext_46)
{
    Fabric_0 device* _S646 = kernelContext_46->fabrics_0+_S640;
    float3 _S647 = to_face_frame_0(_S645, _S642->back_5);
    float3 _S648 = scattered_0(_S640, _S642, to_face_frame_0(_S644, _S642->back_5), _S647, kernelContext_46);
    bool _S649;
    if((max(_S648.x, max(_S648.y, _S648.z))) <= 0.0f)
    {
        _S649 = true;
    }
    else
    {
        bool _S650 = is_lit_0(_S640, _S641, _S642, _S644, kernelContext_46);
        _S649 = !_S650;
    }
    float3 value_2;
    if(_S649)
    {
        value_2 = float3(0.0f) ;
    }
    else
    {
        value_2 = _S648;
    }
    float3 _S651 = bounced_value_0(_S643, _S644, _S645);
    float _S652 = _S646->sheen_strength_0;
    float3 between_1;
    if((_S646->sheen_strength_0) > 0.0f)
    {
        between_1 = _S651 * float3((1.0f - _S652 * sheen_lobe_0(abs(_S647.z), _S646->sheen_roughness_0).z)) ;
    }
    else
    {
        between_1 = _S651;
    }
    return value_2 + between_1;
}

float3 evaluate_0(uint _S653, const SearchQuality_0 thread* _S654, const YarnPoint_0 thread* _S655, float3 _S656, float3 _S657, KernelContext_0 thread* kernelContext_47)
{
    Bounced_0 _S658 = bounced_at_0(_S653, _S655, float3(1.0f) , kernelContext_47);
    thread Bounced_0 _S659 = _S658;
    float3 _S660 = evaluate_with_0(_S653, _S654, _S655, &_S659, _S656, _S657, kernelContext_47);
    return _S660;
}

float straight_through_0(uint _S661, const YarnPoint_0 thread* _S662, float3 _S663, KernelContext_0 thread* kernelContext_48)
{
    Fabric_0 device* _S664 = kernelContext_48->fabrics_0+_S661;
    if(!_S662->hole_2)
    {
        return 0.0f;
    }
    float _S665 = _S664->sheen_strength_0;
    if((_S664->sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S665 * sheen_lobe_0(abs(_S663.z), _S664->sheen_roughness_0).z;
}

float4 cloth_value_0(uint fabric_1, float2 centre_0, float2 dx_0, float2 dy_0, float3 light_7, float3 view_6, KernelContext_0 thread* kernelContext_49)
{
    SearchQuality_0 _S666 = default_quality_0();
    float _S667 = centre_0.x;
    float _S668 = centre_0.y;
    thread SearchQuality_0 _S669 = _S666;
    YarnPoint_0 _S670 = locate_yarn_0(fabric_1, &_S669, _S667, _S668, view_6, kernelContext_49);
    thread SearchQuality_0 _S671 = _S666;
    thread YarnPoint_0 _S672 = _S670;
    float3 _S673 = evaluate_0(fabric_1, &_S671, &_S672, light_7, view_6, kernelContext_49);
    thread YarnPoint_0 _S674 = _S670;
    float _S675 = straight_through_0(fabric_1, &_S674, view_6, kernelContext_49);
    return float4(_S673, _S675);
}

[[kernel]] void point_queries(uint3 id_0 [[thread_position_in_grid]], uint device* query_count_1 [[buffer(24)]], Query_0 device* queries_1 [[buffer(23)]], packed_float4 device* answers_1 [[buffer(25)]], Fabric_0 device* fabrics_1 [[buffer(0)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]])
{
    thread KernelContext_0 kernelContext_50;
    (&kernelContext_50)->query_count_0 = query_count_1;
    (&kernelContext_50)->queries_0 = queries_1;
    (&kernelContext_50)->answers_0 = answers_1;
    (&kernelContext_50)->fabrics_0 = fabrics_1;
    (&kernelContext_50)->families_0 = families_1;
    (&kernelContext_50)->words_0 = words_1;
    uint _S676 = id_0.x;
    if(_S676 >= query_count_1[int(0)])
    {
        return;
    }
    Query_0 _S677 = (&kernelContext_50)->queries_0[_S676];
    packed_float4 device* _S678 = (&kernelContext_50)->answers_0+_S676;
    float4 _S679 = cloth_value_0(_S677.fabric_0, float2(_S677.centre_x_0, _S677.centre_y_0), float2(_S677.dx_x_0, _S677.dx_y_0), float2(_S677.dy_x_0, _S677.dy_y_0), float3(_S677.light_x_0, _S677.light_y_0, _S677.light_z_0), float3(_S677.view_x_0, _S677.view_y_0, _S677.view_z_0), &kernelContext_50);
    *_S678 = packed_float4(_S679) ;
    return;
}

