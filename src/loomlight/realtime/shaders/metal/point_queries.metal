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

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float Footprint_spread_side_0(const Footprint_0 thread* this_0)
{
    return sqrt(0.5f * (dot(this_0->dx_0, this_0->dx_0) + dot(this_0->dy_0, this_0->dy_0)));
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
    uint seed_0;
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

struct Neural_0
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

struct Clustered_0
{
    uint is_baked_1;
    uint clusters_0;
    uint rank_0;
    uint channels_0;
    uint columns_0;
    uint rows_0;
    float texel_width_0;
    float texel_height_0;
    uint samples_0;
    uint sums_0;
    uint labels_0;
    uint coefficients_0;
    uint basis_0;
    uint moments_1;
    uint light_0;
    uint view_0;
    uint offset_1;
    uint trust_0;
};

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Neural_0 neural_0;
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
    uint seed_1;
    float layer_bound_0;
    float fibre_size_0;
    uint has_detail_0;
    float uv_width_0;
    float uv_height_0;
    uint is_open_0;
    uint openness_0;
    uint albedo_map_0;
    uint albedo_map_levels_0;
    uint has_yarns_0;
    float mean_hole_0;
    Latent_0 latent_0;
    Clustered_0 clustered_0;
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
    float has_plies_0;
    float plies_per_mm_0;
    float ply_sine_0;
    float ply_cosine_0;
    float fibre_tilt_0;
    float fibre_tone_0;
    float slub_0;
    float slubs_per_mm_0;
    float per_half_width_0;
    float hairiness_0;
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
    float _S3 = floor(fma(index_0, (kernelContext_0->families_0+family_0)->inverse_count_0, (kernelContext_0->families_0+family_0)->half_inverse_count_0));
    return float2(_S3, fma(- _S3, (kernelContext_0->families_0+family_0)->count_0, index_0));
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
    float _S4 = floor(position_0 * (kernelContext_1->families_0+family_1)->inverse_size_0);
    thread Cell_0 cell_0;
    float _S5 = fma(- _S4, (kernelContext_1->families_0+family_1)->size_0, position_0);
    (&cell_0)->below_0 = _S5;
    (&cell_0)->above_0 = (kernelContext_1->families_0+family_1)->size_0 - _S5;
    (&cell_0)->across_0 = _S5 - 0.5f * (kernelContext_1->families_0+family_1)->size_0;
    (&cell_0)->half_width_1 = (kernelContext_1->families_0+family_1)->half_width_0;
    float2 _S6 = turns_and_remainder_0(family_1, _S4, kernelContext_1);
    (&cell_0)->thread_0 = uint(clamp(_S6.y, 0.0f, (kernelContext_1->families_0+family_1)->count_0 - 1.0f));
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
    float turns_0 = (position_1 - (kernelContext_4->families_0+family_2)->start_0) * (kernelContext_4->families_0+family_2)->inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S7 = turns_1 * (kernelContext_4->families_0+family_2)->period_0;
    uint thread_1 = kernelContext_4->words_0[(kernelContext_4->families_0+family_2)->first_thread_table_0 + uint(clamp(turns_1 * (kernelContext_4->families_0+family_2)->bins_0, 0.0f, (kernelContext_4->families_0+family_2)->bins_0 - 1.0f))];
    float _S8 = table_number_0((kernelContext_4->families_0+family_2)->place_table_0 + thread_1 * 4U + 1U, kernelContext_4);
    uint _S9;
    if(_S7 >= _S8)
    {
        _S9 = 1U;
    }
    else
    {
        _S9 = 0U;
    }
    uint _S10 = min(thread_1 + _S9, uint((kernelContext_4->families_0+family_2)->count_0) - 1U);
    uint _S11 = (kernelContext_4->families_0+family_2)->place_table_0 + _S10 * 4U;
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
    if(((kernelContext_5->families_0+family_3)->is_alike_0) != 0U)
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
    float _S26 = (kernelContext_6->families_0+family_4)->period_0;
    float _S27 = table_number_0((kernelContext_6->families_0+family_4)->place_table_0 + uint(_S24.y) * 4U, kernelContext_6);
    return fma(_S25, _S26, _S27);
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0, KernelContext_0 thread* kernelContext_7)
{
    if(((kernelContext_7->families_0+family_5)->is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * (kernelContext_7->families_0+family_5)->size_0;
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
    uint _S30 = (kernelContext_8->families_0+family_6)->bend_table_0;
    uint _S31;
    if(((kernelContext_8->families_0+family_6)->is_alike_0) != 0U)
    {
        _S31 = 0U;
    }
    else
    {
        _S31 = thread_4 * 4U;
    }
    uint _S32 = _S30 + _S31;
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
    if(((kernelContext_10->families_0+family_7)->is_alike_0) != 0U)
    {
        float _S59 = table_number_0((kernelContext_10->families_0+family_7)->bend_table_0 + 3U, kernelContext_10);
        return _S59;
    }
    uint _S60 = (kernelContext_10->families_0+family_7)->bend_table_0;
    float2 _S61 = turns_and_remainder_0(family_7, float(int(thread_6) + step_1), kernelContext_10);
    float _S62 = table_number_0(_S60 + uint(_S61.y) * 4U + 3U, kernelContext_10);
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
        float _S71 = (kernelContext_11->families_0+other_1)->height_scale_0;
        float _S72 = edge_drop_0(other_1, crossed_1->thread_0, int(0), kernelContext_11);
        _S67 = _S71 * _S72;
    }
    float _S73;
    if(_S70 != _S69)
    {
        _S73 = 0.0f;
    }
    else
    {
        float _S74 = (kernelContext_11->families_0+other_1)->height_scale_0;
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
        _S73 = _S74 * _S77;
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

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1->per_x_0, side_y_1 * this_1->per_y_0), 0.0f) + this_1->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_2, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S110 = min(here_2->edge_x_0 * this_2->per_x_0, here_2->edge_y_0 * this_2->per_y_0);
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
        _S111 = _S110 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S111 = false;
    }
    float _S112 = this_2->step_2;
    float _S113;
    if(_S111)
    {
        _S113 = _S110 - this_2->epsilon_0;
    }
    else
    {
        _S113 = max(_S110, 0.0f) + this_2->epsilon_0;
    }
    return min(_S112, _S113);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(const ViewRay_0 thread* this_3, float height_2)
{
    return this_3->origin_0 + this_3->slope_1 * float2(height_2) ;
}

float ViewRay_rate_0(const ViewRay_0 thread* this_4, const Probe_0 thread* here_3)
{
    return here_3->slope_x_0 * this_4->slope_1.x + here_3->slope_y_0 * this_4->slope_1.y - 1.0f;
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

struct Hair_0
{
    float cover_0;
    float3 normal_0;
    float3 tangent_0;
};

Hair_0 Hair_x24init_0(float cover_1, float3 normal_1, float3 tangent_1)
{
    thread Hair_0 _S127;
    (&_S127)->cover_0 = cover_1;
    (&_S127)->normal_0 = normal_1;
    (&_S127)->tangent_0 = tangent_1;
    return _S127;
}

float fade_0(float size_1, float period_1)
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

uint scramble_0(uint value_0)
{
    uint _S128 = value_0 * 747796405U + 2891336453U;
    uint _S129 = ((_S128 >> ((_S128 >> 28U) + 4U)) ^ _S128) * 277803737U;
    return (_S129 >> 22U) ^ _S129;
}

uint hash_key_0(uint thread_7, uint stream_0)
{
    return scramble_0(thread_7 + scramble_0(stream_0));
}

uint hash_bits_0(uint key_0, uint cell_5)
{
    return scramble_0(cell_5 + key_0);
}

float share_of_0(uint bits_0)
{
    return (float(bits_0 & 1023U) + 0.5f) * 0.0009765625f;
}

float2 sine_cosine_0(float x_2)
{
    float _S130 = floor(x_2 * 0.63661974668502808f + 0.5f);
    float _S131 = x_2 - _S130 * 1.5703125f - _S130 * 0.00048375129699707f - _S130 * 7.54979012640433211e-08f;
    float _S132 = _S131 * _S131;
    float _S133 = ((-0.00019515295571182f * _S132 + 0.00833216123282909f) * _S132 - 0.16666655242443085f) * _S132 * _S131 + _S131;
    float _S134 = ((0.00002443315679557f * _S132 - 0.00138873164542019f) * _S132 + 0.04166664555668831f) * _S132 * _S132 - 0.5f * _S132 + 1.0f;
    uint _S135 = uint(int(_S130)) & 3U;
    float2 _S136;
    if((_S135 & 1U) != 0U)
    {
        _S136 = float2(_S134, _S133);
    }
    else
    {
        _S136 = float2(_S133, _S134);
    }
    float _S137;
    if((_S135 & 2U) != 0U)
    {
        _S137 = - _S136.x;
    }
    else
    {
        _S137 = _S136.x;
    }
    float _S138;
    if(((_S135 + 1U) & 2U) != 0U)
    {
        _S138 = - _S136.y;
    }
    else
    {
        _S138 = _S136.y;
    }
    return float2(_S137, _S138);
}

float3 table_colour_0(uint index_3, KernelContext_0 thread* kernelContext_12)
{
    float _S139 = table_number_1(index_3, kernelContext_12);
    float _S140 = table_number_1(index_3 + 1U, kernelContext_12);
    float _S141 = table_number_1(index_3 + 2U, kernelContext_12);
    return float3(_S139, _S140, _S141);
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
    float3 _S142 = table_colour_0(row_0, kernelContext_13);
    (&albedos_0)->diffuse_reflect_0 = _S142;
    float3 _S143 = table_colour_0(row_0 + 3U, kernelContext_13);
    (&albedos_0)->diffuse_transmit_0 = _S143;
    float3 _S144 = table_colour_0(row_0 + 6U, kernelContext_13);
    (&albedos_0)->specular_reflect_0 = _S144;
    float3 _S145 = table_colour_0(row_0 + 9U, kernelContext_13);
    (&albedos_0)->specular_transmit_0 = _S145;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_8, KernelContext_0 thread* kernelContext_14)
{
    Albedos_0 _S146 = table_albedos_0((kernelContext_14->families_0+family_8)->albedo_table_0 + (kernelContext_14->families_0+family_8)->albedo_stride_0 * thread_8, kernelContext_14);
    return _S146;
}

float3 fibre_cell_0(float across_2, float along_0, float width_1)
{
    float _S147 = floor(across_2 / width_1);
    return float3(_S147, along_0 / (width_1 * 40.0f) + 0.61799997091293335f * _S147, 2.0f * (across_2 / width_1 - _S147) - 1.0f);
}

struct SurfacePoint_0
{
    bool hole_2;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_3;
    float3 normal_2;
    float3 tangent_2;
    float across_3;
    float fibre_across_0;
    float fibre_along_0;
};

float ply_offset_0(uint family_9, const SurfacePoint_0 thread* point_0, bool back_4, KernelContext_0 thread* kernelContext_15)
{
    float _S148;
    if(back_4)
    {
        _S148 = - (kernelContext_15->families_0+family_9)->ply_sine_0;
    }
    else
    {
        _S148 = (kernelContext_15->families_0+family_9)->ply_sine_0;
    }
    float _S149 = (point_0->fibre_across_0 * (kernelContext_15->families_0+family_9)->ply_cosine_0 + point_0->fibre_along_0 * _S148) * (kernelContext_15->families_0+family_9)->plies_per_mm_0;
    return 2.0f * (_S149 - floor(_S149)) - 1.0f;
}

float signed_noise_0(uint bits_1)
{
    return (float(bits_1 & 65535U) + 0.5f) * 0.000030517578125f - 1.0f;
}

float smooth_share_0(float share_1)
{
    return share_1 * share_1 * (3.0f - 2.0f * share_1);
}

float2 wave_noise_0(uint key_1, float position_3)
{
    float _S150 = floor(position_3);
    float _S151 = position_3 - _S150;
    uint _S152 = uint(int(_S150));
    float _S153 = signed_noise_0(hash_bits_0(key_1, _S152));
    float _S154 = signed_noise_0(hash_bits_0(key_1, _S152 + 1U));
    return float2(mix(_S153, _S154, smooth_share_0(_S151)), 6.0f * _S151 * (1.0f - _S151) * (_S154 - _S153));
}

float2 cell_noise_0(uint key_2, float3 cell_6)
{
    float _S155 = cell_6.y;
    float _S156 = floor(_S155);
    uint _S157 = uint(int(cell_6.x)) * 65536U + uint(int(_S156));
    uint _S158 = hash_bits_0(key_2, _S157);
    uint _S159 = hash_bits_0(key_2, _S157 + 1U);
    return mix(float2(signed_noise_0(_S158), signed_noise_0(_S158 >> 16U)), float2(signed_noise_0(_S159), signed_noise_0(_S159 >> 16U)), float2(smooth_share_0(_S155 - _S156)) );
}

float uniform_hash_0(uint thread_9, uint cell_7, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_9, stream_1), cell_7)) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float thread_gain_0(uint thread_10, float amount_0, uint seed_2)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, 0U, seed_2 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_0, float3 albedo_1, float3 room_0)
{
    float3 _S160 = room_0 / max(albedo_1, float3(9.99999997475242708e-07f) );
    return min(gain_0, max(min(min(_S160.x, _S160.y), _S160.z), 0.0f));
}

float flattened_0(float largest_0, float3 albedo_2, float3 room_1)
{
    float3 _S161 = room_1 / max(albedo_2, float3(9.99999997475242708e-07f) ) - float3(1.0f) ;
    return min(max(min(min(_S161.x, _S161.y), _S161.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

float natural_logarithm_0(float x_3)
{
    uint _S162 = (as_type<uint>((x_3)));
    float exponent_0 = float(int(_S162 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S162 & 8388607U) | 1056964608U)));
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
    float _S163 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S163 - exponent_1 * 0.00021219444170129f - 0.5f * _S163) + exponent_1 * 0.693359375f;
}

float fibre_gain_0(uint thread_11, uint cell_8, float amount_1, uint seed_3)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, seed_3 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
    float3 normal_3;
    float3 tangent_3;
    float loss_0;
};

YarnFrame_0 under_hair_0(const YarnFrame_0 thread* frame_0, const Hair_0 thread* hair_0)
{
    float3 _S164 = frame_0->tangent_3;
    float3 _S165 = hair_0->tangent_0;
    float3 _S166;
    if((dot(frame_0->tangent_3, hair_0->tangent_0)) < 0.0f)
    {
        _S166 = - _S165;
    }
    else
    {
        _S166 = _S165;
    }
    thread YarnFrame_0 blended_0;
    float3 _S167 = float3(hair_0->cover_0) ;
    float3 _S168 = normalize(mix(frame_0->normal_3, hair_0->normal_0, _S167));
    (&blended_0)->normal_3 = _S168;
    float3 _S169 = mix(_S164, _S166, _S167);
    float3 _S170 = _S169 - float3(dot(_S169, _S168))  * _S168;
    (&blended_0)->tangent_3 = _S170 * float3(rsqrt(max(dot(_S170, _S170), 9.999999960041972e-13f))) ;
    (&blended_0)->loss_0 = frame_0->loss_0 * (1.0f - hair_0->cover_0);
    return blended_0;
}

float diffuse_gain_0(const YarnFrame_0 thread* frame_1, float blend_0)
{
    return min(0.85000002384185791f * blend_0 * frame_1->loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1->normal_3.z - 1.0f) + 1.0f));
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
    float3 _S171 = float3((1.0f - open_of_other_0))  * passed_0;
    thread FaceRadiance_0 found_0;
    float3 _S172 = sends_0->sky_warp_0 + _S171 * sends_0->crossing_warp_0;
    (&found_0)->warp_2 = _S172;
    float3 _S173 = sends_0->sky_weft_0 + _S171 * sends_0->crossing_weft_0;
    (&found_0)->weft_2 = _S173;
    (&found_0)->mean_0 = float3(sends_0->blocks_warp_0)  * _S172 + float3(sends_0->blocks_weft_0)  * _S173;
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
    float3 back_5;
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
    float3 _S174 = float3((blocked_0->by_warp_0 + blocked_0->by_weft_0))  * interior_0->leaked_1;
    float3 _S175 = float3(blocked_0->far_0)  * yarn_2->through_0;
    thread Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_5 * (float3(blocked_0->by_warp_0)  * interior_0->warp_3 + float3(blocked_0->by_weft_0)  * interior_0->weft_3) + _S175 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S175 * interior_0->far_1 + yarn_2->back_5 * _S174;
    return bounced_0;
}

float diffuse_reflection_0(float3 light_1, float3 normal_4, float blend_1)
{
    float _S176 = light_1.z;
    if(_S176 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S176, 0.0f), max(dot(light_1, normal_4), 0.0f), blend_1);
}

float projected_area_1(float3 direction_2, float3 tangent_4, float roughness_1)
{
    float _S177 = dot(direction_2, tangent_4);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S177 * _S177 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_4)
{
    float _S178 = clamp(x_4, -87.0f, 88.0f);
    float _S179 = floor(_S178 * 1.4426950216293335f + 0.5f);
    float _S180 = _S178 - _S179 * 0.693359375f + _S179 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S180 + 0.00139819993637502f) * _S180 + 0.00833345204591751f) * _S180 + 0.04166579619050026f) * _S180 + 0.1666666567325592f) * _S180 + 0.5f;
    float _S181 = (as_type<float>((uint(int(_S179) + int(127)) << 23U)));
    float _S182;
    if(x_4 < -87.0f)
    {
        _S182 = 0.0f;
    }
    else
    {
        _S182 = (p_0 * _S180 * _S180 + _S180 + 1.0f) * _S181;
    }
    return _S182;
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
    float _S183 = roughness_2 * roughness_2;
    float _S184 = squared_along_0 * (1.0f - _S183) + _S183;
    return 0.31830987334251404f * _S183 * roughness_2 / (_S184 * _S184);
}

float density_between_0(float3 light_2, float3 view_1, float3 tangent_5, float roughness_3)
{
    float3 _S185 = light_2 + view_1;
    float _S186 = dot(_S185, tangent_5);
    return flake_density_0(min(_S186 * _S186 / max(square_1(_S185), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_3, float3 view_2, float3 normal_5, float3 tangent_6, float roughness_4, float optical_depth_1)
{
    float _S187 = dot(light_3, normal_5);
    bool _S188;
    if(_S187 <= 0.0f)
    {
        _S188 = true;
    }
    else
    {
        _S188 = (dot(view_2, normal_5)) <= 0.0f;
    }
    if(_S188)
    {
        return 0.0f;
    }
    float _S189 = max(_S187, 9.99999997475242708e-07f);
    float _S190 = max(dot(view_2, normal_5), 9.99999997475242708e-07f);
    float _S191 = projected_area_1(light_3, tangent_6, roughness_4) * _S190 + projected_area_1(view_2, tangent_6, roughness_4) * _S189;
    float _S192 = optical_depth_1 * _S191 / (_S189 * _S190);
    return 0.25f * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S192 * mean_attenuation_0(_S192)) * _S189 / _S191;
}

float transmission_1(float3 light_4, float3 view_3, float3 normal_6, float3 tangent_7, float roughness_5, float optical_depth_2)
{
    float _S193 = - dot(light_4, normal_6);
    float _S194 = dot(view_3, normal_6);
    bool _S195;
    if(_S193 <= 0.0f)
    {
        _S195 = true;
    }
    else
    {
        _S195 = _S194 <= 0.0f;
    }
    if(_S195)
    {
        return 0.0f;
    }
    float _S196 = 1.0f / max(_S194, 9.99999997475242708e-07f);
    float _S197 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S193, 9.99999997475242708e-07f);
    float _S198 = projected_area_1(view_3, tangent_7, roughness_5) * _S196;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S197, _S198)) * mean_attenuation_0(optical_depth_2 * abs(_S197 - _S198)) * _S196;
}

float sheen_scale_0(float x_5, float y_0)
{
    return (((((0.0f * x_5 + (((((-1.1402510404586792f * y_0 + 0.40672621130943298f) * y_0 + 1.65398800373077393f) * y_0 + -1.29730904102325439f) * y_0 + 0.30570998787879944f) * y_0 + -0.0220868494361639f)) * x_5 + (((((-0.21142719686031342f * y_0 + 1.05947399139404297f) * y_0 + -0.41116121411323547f) * y_0 + -0.93859231472015381f) * y_0 + 0.51606941223144531f) * y_0 + 0.05409301072359085f)) * x_5 + (((((1.22944498062133789f * y_0 + -0.45962560176849365f) * y_0 + -1.63861405849456787f) * y_0 + 1.33565104007720947f) * y_0 + -0.45725581049919128f) * y_0 + 0.08243165910243988f)) * x_5 + (((((0.39779931306838989f * y_0 + -1.18879103660583496f) * y_0 + 0.28251591324806213f) * y_0 + 1.168984055519104f) * y_0 + -0.76864629983901978f) * y_0 + 0.0091691892594099f)) * x_5 + (((((-0.26563560962677002f * y_0 + -0.19379159808158875f) * y_0 + 0.2677634060382843f) * y_0 + 0.00270519289188087f) * y_0 + 0.14349560439586639f) * y_0 + 0.10290180146694183f)) * x_5 + (((((-0.20701569318771362f * y_0 + 0.24526430666446686f) * y_0 + 0.19551840424537659f) * y_0 + 0.07586126774549484f) * y_0 + 0.38894739747047424f) * y_0 + 0.15043120086193085f);
}

float sheen_shear_0(float x_6, float y_1)
{
    return ((((0.0f * x_6 + (((((-0.10608240216970444f * y_1 + 1.99214303493499756f) * y_1 + -1.42255294322967529f) * y_1 + -1.09495604038238525f) * y_1 + 0.59180057048797607f) * y_1 + 0.06902855634689331f)) * x_6 + (((((-0.46220690011978149f * y_1 + -0.29113379120826721f) * y_1 + 1.39025199413299561f) * y_1 + 0.35589990019798279f) * y_1 + -1.17120099067687988f) * y_1 + 0.15940259397029877f)) * x_6 + (((((2.26068711280822754f * y_1 + -3.64728999137878418f) * y_1 + -0.72173482179641724f) * y_1 + 3.07659196853637695f) * y_1 + -0.6827620267868042f) * y_1 + -0.3039557933807373f)) * x_6 + (((((0.81201767921447754f * y_1 + 0.36014080047607422f) * y_1 + -1.72646903991699219f) * y_1 + -0.22630110383033752f) * y_1 + 0.89514690637588501f) * y_1 + -0.10397960245609283f)) * x_6 + (((((-0.37648698687553406f * y_1 + 1.10974001884460449f) * y_1 + 0.17824520170688629f) * y_1 + -1.04968702793121338f) * y_1 + 0.1461234986782074f) * y_1 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_7, float y_2)
{
    return ((((0.0f * x_7 + (((((12.95646953582763672f * y_2 + -21.38032913208007812f) * y_2 + -7.37853097915649414f) * y_2 + 34.55607986450195312f) * y_2 + -23.61347007751464844f) * y_2 + 5.00126314163208008f)) * x_7 + (((((10.91487026214599609f * y_2 + -6.08202791213989258f) * y_2 + -38.2036285400390625f) * y_2 + 53.3440399169921875f) * y_2 + -21.91996002197265625f) * y_2 + 2.01606011390686035f)) * x_7 + (((((-14.52206039428710938f * y_2 + 36.803619384765625f) * y_2 + -22.94047927856445312f) * y_2 + -10.07973003387451172f) * y_2 + 15.77003955841064453f) * y_2 + -4.92722177505493164f)) * x_7 + (((((-7.62505722045898438f * y_2 + 1.27310299873352051f) * y_2 + 31.19523048400878906f) * y_2 + -44.39989852905273438f) * y_2 + 26.44947052001953125f) * y_2 + -8.73507976531982422f)) * x_7 + (((((5.65633487701416016f * y_2 + -17.66820907592773438f) * y_2 + 24.65356063842773438f) * y_2 + -19.38941001892089844f) * y_2 + 11.06159019470214844f) * y_2 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S199 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S200 = 2.0f * sqrt(_S199) - 1.0f;
    float _S201 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S200, _S201), 0.00999999977648258f, 1.0f), clamp((1.0f - _S199) * sheen_shear_0(_S200, _S201), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S200, _S201), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_5, float3 view_4, float scale_0, float shear_0)
{
    float _S202 = light_5.z;
    bool _S203;
    if(_S202 <= 0.0f)
    {
        _S203 = true;
    }
    else
    {
        _S203 = (view_4.z) <= 0.0f;
    }
    if(_S203)
    {
        return 0.0f;
    }
    float2 _S204 = view_4.xy;
    float _S205 = dot(_S204, _S204);
    float2 _S206;
    if(_S205 > 9.99999968265522539e-21f)
    {
        _S206 = _S204 * float2(rsqrt(_S205)) ;
    }
    else
    {
        _S206 = float2(1.0f, 0.0f);
    }
    float _S207 = scale_0 * dot(light_5.xy, _S206) + shear_0 * _S202;
    float _S208 = scale_0 * (light_5.y * _S206.x - light_5.x * _S206.y);
    float _S209 = _S207 * _S207 + _S208 * _S208 + _S202 * _S202;
    return 0.31830987334251404f * scale_0 * scale_0 * _S202 / max(_S209 * _S209, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_6, float3 view_5, float strength_0, float roughness_7)
{
    float3 _S210 = sheen_lobe_0(view_5.z, roughness_7);
    float _S211 = strength_0 * _S210.z;
    return float2(_S211 * transformed_cosine_0(light_6, view_5, _S210.x, _S210.y), 1.0f - _S211);
}

float3 bounced_value_0(const Bounced_0 thread* bounced_1, float3 light_7, float3 view_6)
{
    float _S212 = light_7.z;
    float3 _S213;
    if((_S212 * view_6.z) < 0.0f)
    {
        _S213 = bounced_1->transmitted_0;
    }
    else
    {
        _S213 = bounced_1->reflected_0;
    }
    return _S213 * float3((abs(_S212) * 0.31830987334251404f)) ;
}

struct YarnPoint_0
{
    bool back_6;
    bool hole_3;
    bool is_warp_2;
    float x_8;
    float y_3;
    float height_4;
    float3 normal_7;
    float3 tangent_8;
    float3 surface_normal_0;
    float diffuse_gain_1;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_9;
    float y_4;
    bool hole_4;
    float height_5;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_6;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S214, float _S215, float _S216, bool _S217, KernelContext_0 thread* kernelContext_16)
{
    Fabric_0 device* _S218 = kernelContext_16->fabrics_0+_S214;
    thread Crossing_0 crossing_2;
    Cell_0 _S219 = locate_0(_S218->warp_0, _S215, kernelContext_16);
    (&crossing_2)->warp_1 = _S219;
    Cell_0 _S220 = locate_0(_S218->weft_0, _S216, kernelContext_16);
    (&crossing_2)->weft_1 = _S220;
    uint _S221 = _S218->run_words_0 + 2U * ((&(&crossing_2)->weft_1)->thread_0 * _S218->ends_1 + (&(&crossing_2)->warp_1)->thread_0);
    uint _S222 = kernelContext_16->words_0[_S221];
    (&crossing_2)->warp_word_0 = _S222;
    (&crossing_2)->weft_word_0 = kernelContext_16->words_0[_S221 + 1U];
    (&crossing_2)->warp_above_0 = ((_S222 & 1U) == 1U) != _S217;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S223, float _S224, float _S225, bool _S226, KernelContext_0 thread* kernelContext_17)
{
    Fabric_0 device* _S227 = kernelContext_17->fabrics_0+_S223;
    thread Sample_0 sample_0;
    Crossing_0 _S228 = crossing_at_0(_S223, _S224, _S225, _S226, kernelContext_17);
    (&sample_0)->crossing_1 = _S228;
    thread Crossing_0 _S229 = _S228;
    Shown_0 _S230 = shown_at_0(&_S229, _S226);
    (&sample_0)->shown_3 = _S230;
    uint _S231;
    if(_S230.is_warp_0)
    {
        _S231 = _S227->warp_0;
    }
    else
    {
        _S231 = _S227->weft_0;
    }
    uint _S232;
    if(_S230.is_warp_0)
    {
        _S232 = _S227->weft_0;
    }
    else
    {
        _S232 = _S227->warp_0;
    }
    thread Cell_0 _S233 = (&(&sample_0)->crossing_1)->warp_1;
    thread Cell_0 _S234 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S235 = select_cell_0(_S230.is_warp_0, &_S233, &_S234);
    thread Cell_0 _S236 = (&(&sample_0)->crossing_1)->weft_1;
    thread Cell_0 _S237 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S238 = select_cell_0(_S230.is_warp_0, &_S236, &_S237);
    thread Cell_0 _S239 = _S238;
    Run_0 _S240 = unpack_0(_S231, _S232, _S235.thread_0, &_S239, _S230.word_0, kernelContext_17);
    thread Cell_0 _S241 = _S235;
    Section_0 _S242 = section_at_0(&_S241);
    bool _S243;
    if(_S230.on_top_0)
    {
        _S243 = (_S240.distance_0) < (_S242.drop_0 * _S240.bend_1.sine_0);
    }
    else
    {
        _S243 = false;
    }
    bool _S244;
    if(_S230.on_top_0)
    {
        _S244 = !_S243;
    }
    else
    {
        _S244 = false;
    }
    float _S245;
    if(_S244)
    {
        _S245 = 1.0f;
    }
    else
    {
        _S245 = -1.0f;
    }
    float _S246;
    if(_S243)
    {
        _S246 = _S240.other_reach_0;
    }
    else
    {
        _S246 = _S240.reach_0;
    }
    float _S247;
    if(_S243)
    {
        _S247 = _S246 + _S240.distance_0;
    }
    else
    {
        _S247 = max(_S246 - _S240.distance_0, 0.0f);
    }
    float _S248 = _S246 / _S240.bend_1.sine_0 - _S245 * _S242.drop_0;
    float _S249 = _S247 * _S247;
    float _S250 = max(_S248 * _S248 - _S249, 9.99999968265522539e-21f);
    float _S251 = rsqrt(_S250);
    float _S252 = _S249 / (_S250 * _S251 + _S248);
    bool _S253 = _S247 > 0.0f;
    float _S254;
    if(_S230.on_top_0)
    {
        _S254 = 1.0f;
    }
    else
    {
        _S254 = -1.0f;
    }
    float _S255;
    if(_S240.near_start_0)
    {
        _S255 = 1.0f;
    }
    else
    {
        _S255 = -1.0f;
    }
    float _S256 = _S254 * _S255;
    if(_S253)
    {
        _S254 = _S248 * _S251;
    }
    else
    {
        _S254 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S242.slope_0 * _S254;
    if(_S253)
    {
        _S247 = _S256 * _S247 * _S251;
    }
    else
    {
        _S247 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S247;
    float _S257 = (kernelContext_17->families_0+_S231)->height_scale_0;
    thread Shown_0 _S258 = _S230;
    thread Run_0 _S259 = _S240;
    thread Cell_0 _S260 = _S238;
    float2 _S261 = dive_0(_S232, &_S258, &_S259, &_S260, kernelContext_17);
    if(_S240.straight_0)
    {
        _S245 = 0.0f;
    }
    else
    {
        _S245 = _S257 * _S245;
    }
    (&sample_0)->height_6 = _S245 * (_S246 * _S240.bend_1.half_tangent_0 - _S252) - _S257 * _S242.drop_0 - _S261.x;
    float _S262 = _S257 * (&sample_0)->slope_across_0;
    float _S263 = _S257 * (&sample_0)->slope_along_0 - _S261.y;
    if(_S230.is_warp_0)
    {
        _S245 = _S262;
    }
    else
    {
        _S245 = _S263;
    }
    (&sample_0)->slope_x_1 = _S245;
    if(_S230.is_warp_0)
    {
        _S245 = _S263;
    }
    else
    {
        _S245 = _S262;
    }
    (&sample_0)->slope_y_1 = _S245;
    (&sample_0)->run_3 = _S240;
    (&sample_0)->section_1 = _S242;
    return sample_0;
}

float steps_per_length_0(uint _S264, const SearchQuality_0 thread* _S265, float3 _S266, KernelContext_0 thread* kernelContext_18)
{
    Fabric_0 device* _S267 = kernelContext_18->fabrics_0+_S264;
    return max(max(abs(_S266.x) * _S267->threads_per_x_0, abs(_S266.y) * _S267->threads_per_y_0) * _S265->steps_per_thread_0, abs(_S266.z) * _S267->per_relief_0 * _S265->steps_per_relief_0);
}

float cell_maximum_0(uint _S268, const Crossing_0 thread* _S269, KernelContext_0 thread* kernelContext_19)
{
    Fabric_0 device* _S270 = kernelContext_19->fabrics_0+_S268;
    bool _S271 = _S269->warp_above_0;
    uint _S272;
    if(_S269->warp_above_0)
    {
        _S272 = _S270->warp_0;
    }
    else
    {
        _S272 = _S270->weft_0;
    }
    uint _S273;
    if(_S271)
    {
        _S273 = _S269->warp_word_0;
    }
    else
    {
        _S273 = _S269->weft_word_0;
    }
    return float(_S273 >> 28U) * (kernelContext_19->families_0+_S272)->height_scale_0 * (kernelContext_19->families_0+_S272)->level_0;
}

Probe_0 probe_0(uint _S274, float _S275, float _S276, bool _S277, bool _S278, bool _S279, KernelContext_0 thread* kernelContext_20)
{
    Sample_0 _S280 = sample_at_0(_S274, _S275, _S276, _S277, kernelContext_20);
    thread Probe_0 probe_1;
    (&probe_1)->height_1 = _S280.height_6;
    (&probe_1)->hole_1 = _S280.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S280.slope_x_1;
    (&probe_1)->slope_y_0 = _S280.slope_y_1;
    uint _S281;
    if(_S280.shown_3.is_warp_0)
    {
        _S281 = _S280.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S281 = _S280.crossing_1.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S281;
    thread Crossing_0 _S282 = _S280.crossing_1;
    float _S283 = cell_maximum_0(_S274, &_S282, kernelContext_20);
    (&probe_1)->cell_max_0 = _S283;
    float _S284;
    if(_S278)
    {
        _S284 = _S280.crossing_1.warp_1.above_0;
    }
    else
    {
        _S284 = _S280.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S284;
    if(_S279)
    {
        _S284 = _S280.crossing_1.weft_1.above_0;
    }
    else
    {
        _S284 = _S280.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S284;
    bool _S285 = !_S280.shown_3.is_warp_0;
    thread Cell_0 _S286 = _S280.crossing_1.warp_1;
    thread Shown_0 _S287 = _S280.shown_3;
    thread Run_0 _S288 = _S280.run_3;
    float _S289 = outline_distance_0(&_S286, &_S287, &_S288, _S285, _S278);
    (&probe_1)->edge_x_0 = _S289;
    thread Cell_0 _S290 = _S280.crossing_1.weft_1;
    thread Shown_0 _S291 = _S280.shown_3;
    thread Run_0 _S292 = _S280.run_3;
    float _S293 = outline_distance_0(&_S290, &_S291, &_S292, _S280.shown_3.is_warp_0, _S279);
    (&probe_1)->edge_y_0 = _S293;
    return probe_1;
}

bool is_free_0(uint _S294, const SearchQuality_0 thread* _S295, float3 _S296, float3 _S297, bool _S298, float _S299, KernelContext_0 thread* kernelContext_21)
{
    float _S300 = _S297.z;
    if(_S300 <= 0.0f)
    {
        return false;
    }
    float _S301 = _S295->shadow_share_0;
    float _S302 = steps_per_length_0(_S294, _S295, _S297, kernelContext_21);
    float _S303 = 1.0f / max(_S301 * _S302, 9.99999971718068537e-10f);
    StepControl_0 _S304 = step_control_0(_S297.xy, _S303);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S305;
        if(count_1 < 1024U)
        {
            _S305 = (_S296.z + _S300 * distance_1) < _S299;
        }
        else
        {
            _S305 = false;
        }
        if(_S305)
        {
        }
        else
        {
            break;
        }
        float3 _S306 = _S296 + _S297 * float3(distance_1) ;
        Probe_0 _S307 = probe_0(_S294, _S306.x, _S306.y, _S298, _S304.right_0, _S304.up_0, kernelContext_21);
        float _S308 = _S306.z;
        float _S309 = _S308 - _S307.height_1;
        float _S310 = _S300 - _S307.slope_x_0 * _S297.x - _S307.slope_y_0 * _S297.y;
        bool _S311;
        if(!_S307.hole_1)
        {
            _S311 = _S309 < 0.0f;
        }
        else
        {
            _S311 = false;
        }
        if(_S311)
        {
            return false;
        }
        thread PreviousSample_0 _S312 = previous_3;
        thread Probe_0 _S313 = _S307;
        float _S314 = way_back_to_dip_0(&_S312, _S309, _S310, last_step_0, &_S313);
        if(_S314 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S314;
            distance_1 = distance_1 - _S314;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S315 = _S308 > (_S307.cell_max_0);
        thread Probe_0 _S316 = _S307;
        PreviousSample_0 _S317 = after_sample_0(_S309, _S310, &_S316, _S315);
        float last_step_2;
        if(_S315)
        {
            thread StepControl_0 _S318 = _S304;
            float _S319 = StepControl_to_cell_exit_0(&_S318, _S307.side_x_0, _S307.side_y_0);
            last_step_2 = max(_S319, _S303);
        }
        else
        {
            thread StepControl_0 _S320 = _S304;
            thread Probe_0 _S321 = _S307;
            float _S322 = StepControl_to_next_sample_0(&_S320, &_S321, _S309, _S310);
            last_step_2 = _S322;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S317;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S323, const SearchQuality_0 thread* _S324, float _S325, float _S326, float3 _S327, bool _S328, KernelContext_0 thread* kernelContext_22)
{
    Fabric_0 device* _S329 = kernelContext_22->fabrics_0+_S323;
    Sample_0 _S330 = sample_at_0(_S323, _S325, _S326, _S328, kernelContext_22);
    if(!_S330.shown_3.hole_0)
    {
        return false;
    }
    float3 _S331 = float3(_S325, _S326, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S332;
        if(side_0 < 2U)
        {
            _S332 = passes_0;
        }
        else
        {
            _S332 = false;
        }
        if(_S332)
        {
        }
        else
        {
            break;
        }
        float3 _S333;
        if(side_0 == 0U)
        {
            _S333 = _S327;
        }
        else
        {
            _S333 = float3(- _S327.x, - _S327.y, _S327.z);
        }
        bool _S334 = is_free_0(_S323, _S324, _S331, _S333, _S328 != (side_0 == 1U), _S329->height_high_0, kernelContext_22);
        uint _S335 = side_0 + 1U;
        passes_0 = _S334;
        side_0 = _S335;
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

float max_height_along_0(uint _S336, float _S337, float _S338, float _S339, float3 _S340, bool _S341, KernelContext_0 thread* kernelContext_23)
{
    Fabric_0 device* _S342 = kernelContext_23->fabrics_0+_S336;
    Cell_0 _S343 = locate_0(_S342->warp_0, _S337, kernelContext_23);
    uint _S344 = _S343.thread_0 / 2U;
    Cell_0 _S345 = locate_0(_S342->weft_0, _S338, kernelContext_23);
    uint _S346 = _S345.thread_0 / 2U;
    float _S347 = _S340.x;
    uint _S348;
    if(_S347 > 0.0f)
    {
        _S348 = 1U;
    }
    else
    {
        _S348 = 0U;
    }
    float _S349 = _S340.y;
    uint _S350;
    if(_S349 > 0.0f)
    {
        _S350 = 2U;
    }
    else
    {
        _S350 = 0U;
    }
    uint _S351 = kernelContext_23->words_0[_S342->max_heights_0 + 4U * (_S346 * _S342->max_height_columns_0 + _S344) + (_S348 + _S350)];
    int number_0;
    if(_S341)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S352 = _S351 >> uint(number_0);
    float _S353 = max(abs(_S347) * _S342->threads_per_x_0, abs(_S349) * _S342->threads_per_y_0) / _S340.z;
    float _S354 = _S342->height_high_0;
    float max_height_0 = _S342->height_high_0;
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
        if(((max_height_0 - _S339) * _S353) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S352 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S354);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S355, float _S356, float _S357, bool _S358, bool _S359, bool _S360, KernelContext_0 thread* kernelContext_24)
{
    Crossing_0 _S361 = crossing_at_0(_S355, _S356, _S357, _S358, kernelContext_24);
    thread Crossing_0 _S362 = _S361;
    float _S363 = cell_maximum_0(_S355, &_S362, kernelContext_24);
    float _S364;
    if(_S359)
    {
        _S364 = _S361.warp_1.above_0;
    }
    else
    {
        _S364 = _S361.warp_1.below_0;
    }
    float _S365;
    if(_S360)
    {
        _S365 = _S361.weft_1.above_0;
    }
    else
    {
        _S365 = _S361.weft_1.below_0;
    }
    return float3(_S363, _S364, _S365);
}

float first_sample_height_0(uint _S366, const ViewRay_0 thread* _S367, const StepControl_0 thread* _S368, bool _S369, KernelContext_0 thread* kernelContext_25)
{
    float _S370 = max_height_along_0(_S366, _S367->origin_0.x, _S367->origin_0.y, 0.0f, float3(_S367->slope_1, 1.0f), _S369, kernelContext_25);
    uint count_2 = 0U;
    float height_8 = _S370;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S371 = ViewRay_at_0(_S367, height_8);
        float3 _S372 = cell_bounds_0(_S366, _S371.x, _S371.y, _S369, _S368->right_0, _S368->up_0, kernelContext_25);
        float _S373 = height_8 - _S372.x;
        float _S374 = StepControl_to_cell_exit_0(_S368, _S372.y, _S372.z);
        float height_9 = height_8 - clamp(_S373, 0.0f, _S374);
        if(_S373 <= _S374)
        {
            height_8 = height_9;
            break;
        }
        count_2 = count_2 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S375, const ViewRay_0 thread* _S376, const StepControl_0 thread* _S377, bool _S378, KernelContext_0 thread* kernelContext_26)
{
    Fabric_0 device* _S379 = kernelContext_26->fabrics_0+_S375;
    float _S380 = _S379->height_low_0 - (_S379->height_high_0 - _S379->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S381 = first_sample_height_0(_S375, _S376, _S377, _S378, kernelContext_26);
    (&end_1)->height_7 = _S381;
    (&end_1)->last_step_3 = _S377->epsilon_0;
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
        float2 _S382 = ViewRay_at_0(_S376, (&end_1)->height_7);
        Probe_0 _S383 = probe_0(_S375, _S382.x, _S382.y, _S378, _S377->right_0, _S377->up_0, kernelContext_26);
        float _S384 = (&end_1)->height_7 - _S383.height_1;
        thread Probe_0 _S385 = _S383;
        float _S386 = ViewRay_rate_0(_S376, &_S385);
        (&end_1)->depth_1 = - _S384;
        (&end_1)->rate_4 = _S386;
        bool _S387;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S387 = !_S383.hole_1;
        }
        else
        {
            _S387 = false;
        }
        bool _S388;
        if(_S387)
        {
            _S388 = ((&(&end_1)->previous_4)->yarn_0) == (_S383.yarn_1);
        }
        else
        {
            _S388 = false;
        }
        (&end_1)->smooth_0 = _S388;
        bool _S389;
        if(!_S383.hole_1)
        {
            _S389 = _S384 <= 0.0f;
        }
        else
        {
            _S389 = false;
        }
        bool _S390;
        if(_S389)
        {
            _S390 = true;
        }
        else
        {
            _S390 = ((&end_1)->height_7) <= _S380;
        }
        if(_S390)
        {
            break;
        }
        thread PreviousSample_0 _S391 = (&end_1)->previous_4;
        thread Probe_0 _S392 = _S383;
        float _S393 = way_back_to_dip_0(&_S391, _S384, _S386, (&end_1)->last_step_3, &_S392);
        if(_S393 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S393;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S393;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S394 = StepControl_to_cell_exit_0(_S377, _S383.side_x_0, _S383.side_y_0);
        float _S395 = min(_S394, (&end_1)->height_7 - _S383.cell_max_0);
        thread Probe_0 _S396 = _S383;
        float _S397 = StepControl_to_next_sample_0(_S377, &_S396, _S384, _S386);
        bool _S398 = _S395 > _S397;
        thread Probe_0 _S399 = _S383;
        PreviousSample_0 _S400 = after_sample_0(_S384, _S386, &_S399, _S398);
        (&end_1)->previous_4 = _S400;
        float _S401 = max(_S395, _S397);
        (&end_1)->last_step_3 = _S401;
        (&end_1)->height_7 = (&end_1)->height_7 - _S401;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S402, const ViewRay_0 thread* _S403, const StepControl_0 thread* _S404, bool _S405, const ViewRayEnd_0 thread* _S406, uint _S407, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S408 = kernelContext_27->fabrics_0+_S402;
    float _S409 = _S408->height_high_0 - _S408->height_low_0;
    float _S410 = _S406->height_7;
    float _S411 = _S406->last_step_3;
    float above_2 = _S406->height_7 + _S406->last_step_3;
    float above_gap_1 = clamp((&_S406->previous_4)->clearance_0, 0.0f, _S409);
    float under_gap_1 = clamp(_S406->depth_1, 0.0f, _S409);
    float _S412 = cubic_root_0(above_gap_1, - under_gap_1, (&_S406->previous_4)->rate_0 * _S406->last_step_3, _S406->rate_4 * _S406->last_step_3);
    bool _S413 = _S406->smooth_0;
    float middle_0;
    if(_S406->smooth_0)
    {
        middle_0 = above_2 - _S412 * _S411;
    }
    else
    {
        middle_0 = between_0(above_2, _S410, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S410;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S407)
        {
        }
        else
        {
            break;
        }
        float2 _S414 = ViewRay_at_0(_S403, middle_0);
        Probe_0 _S415 = probe_0(_S402, _S414.x, _S414.y, _S405, _S404->right_0, _S404->up_0, kernelContext_27);
        float _S416;
        if(_S415.hole_1)
        {
            _S416 = -1.0e+09f;
        }
        else
        {
            _S416 = _S415.height_1;
        }
        float _S417 = clamp(middle_0 - _S416, - _S409, _S409);
        float _S418;
        if(_S417 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S418 = 0.5f * above_gap_2;
            }
            else
            {
                _S418 = above_gap_2;
            }
            float _S419 = - _S417;
            under_1 = middle_0;
            above_gap_2 = _S418;
            under_gap_2 = _S419;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S418 = 0.5f * under_gap_2;
            }
            else
            {
                _S418 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S417;
            under_gap_2 = _S418;
            side_1 = -1.0f;
        }
        if(_S413)
        {
            thread Probe_0 _S420 = _S415;
            float _S421 = ViewRay_rate_0(_S403, &_S420);
            middle_0 = clamp(middle_0 + _S417 / min(_S421, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S413)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S422, const SearchQuality_0 thread* _S423, float _S424, float _S425, float3 _S426, bool _S427, KernelContext_0 thread* kernelContext_28)
{
    float _S428 = max(_S426.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S424, _S425);
    float2 _S429 = _S426.xy / float2(_S428) ;
    (&ray_0)->slope_1 = _S429;
    float2 _S430 = - _S429;
    float _S431 = steps_per_length_0(_S422, _S423, _S426, kernelContext_28);
    StepControl_0 _S432 = step_control_0(_S430, 1.0f / max(_S431 / _S428, 9.99999971718068537e-10f));
    thread ViewRay_0 _S433 = ray_0;
    thread StepControl_0 _S434 = _S432;
    ViewRayEnd_0 _S435 = search_down_0(_S422, &_S433, &_S434, _S427, kernelContext_28);
    thread Hit_0 hit_0;
    (&hit_0)->hole_4 = false;
    thread ViewRay_0 _S436 = ray_0;
    thread StepControl_0 _S437 = _S432;
    thread ViewRayEnd_0 _S438 = _S435;
    float _S439 = refined_height_0(_S422, &_S436, &_S437, _S427, &_S438, _S423->refinements_0, kernelContext_28);
    (&hit_0)->height_5 = _S439;
    thread ViewRay_0 _S440 = ray_0;
    float2 _S441 = ViewRay_at_0(&_S440, _S439);
    (&hit_0)->x_9 = _S441.x;
    (&hit_0)->y_4 = _S441.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S442, const SearchQuality_0 thread* _S443, float _S444, float _S445, float3 _S446, bool _S447, KernelContext_0 thread* kernelContext_29)
{
    bool _S448 = passes_through_0(_S442, _S443, _S444, _S445, _S446, _S447, kernelContext_29);
    if(!_S448)
    {
        Hit_0 _S449 = first_hit_of_yarn_0(_S442, _S443, _S444, _S445, _S446, _S447, kernelContext_29);
        return _S449;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_9 = _S444;
    (&hit_1)->y_4 = _S445;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_4 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S450, float _S451, float _S452, bool _S453, KernelContext_0 thread* kernelContext_30)
{
    Fabric_0 device* _S454 = kernelContext_30->fabrics_0+_S450;
    Sample_0 _S455 = sample_at_0(_S450, _S451, _S452, _S453, kernelContext_30);
    float _S456;
    if(_S455.shown_3.is_warp_0)
    {
        _S456 = _S455.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S456 = _S455.crossing_1.weft_1.half_width_1;
    }
    uint _S457;
    if(_S455.shown_3.is_warp_0)
    {
        _S457 = _S454->warp_0;
    }
    else
    {
        _S457 = _S454->weft_0;
    }
    float _S458 = (kernelContext_30->families_0+_S457)->twist_sine_0;
    float _S459;
    if(_S453)
    {
        _S459 = -1.0f;
    }
    else
    {
        _S459 = 1.0f;
    }
    float _S460 = _S458 * _S459;
    float _S461 = (kernelContext_30->families_0+_S457)->twist_cosine_0;
    if(_S455.shown_3.is_warp_0)
    {
        _S459 = 1.0f;
    }
    else
    {
        _S459 = -1.0f;
    }
    float2 _S462 = fibre_direction_0(_S455.slope_across_0, _S459 * _S455.slope_along_0, _S460, _S461);
    float _S463;
    if(_S455.shown_3.is_warp_0)
    {
        _S463 = _S455.slope_x_1;
    }
    else
    {
        _S463 = _S455.slope_y_1;
    }
    float _S464;
    if(_S455.shown_3.is_warp_0)
    {
        _S464 = _S455.slope_y_1;
    }
    else
    {
        _S464 = _S455.slope_x_1;
    }
    float _S465 = _S462.x;
    float _S466 = _S462.y;
    float _S467 = _S463 * _S465 + _S459 * _S464 * _S466;
    float _S468 = _S456 * 1.0154266357421875f;
    float _S469 = _S468 * arc_sine_0(clamp(_S455.section_1.across_1 / _S468, -1.0f, 1.0f));
    if(_S455.shown_3.is_warp_0)
    {
        _S456 = _S452;
    }
    else
    {
        _S456 = - _S451;
    }
    thread SurfacePoint_0 point_1;
    (&point_1)->hole_2 = _S455.shown_3.hole_0;
    (&point_1)->is_warp_1 = _S455.shown_3.is_warp_0;
    (&point_1)->warp_thread_0 = _S455.crossing_1.warp_1.thread_0;
    (&point_1)->weft_thread_0 = _S455.crossing_1.weft_1.thread_0;
    (&point_1)->height_3 = _S455.height_6;
    (&point_1)->normal_2 = normalize(float3(- _S455.slope_x_1, - _S455.slope_y_1, 1.0f));
    float3 _S470;
    if(_S455.shown_3.is_warp_0)
    {
        _S470 = float3(_S465, _S466, _S467);
    }
    else
    {
        _S470 = float3(- _S466, _S465, _S467);
    }
    (&point_1)->tangent_2 = normalize(_S470);
    (&point_1)->across_3 = _S455.section_1.across_1;
    (&point_1)->fibre_across_0 = _S469 * _S461 + _S456 * _S460;
    (&point_1)->fibre_along_0 = _S456 * _S461 - _S469 * _S460;
    return point_1;
}

bool has_hairs_0(uint _S471, KernelContext_0 thread* kernelContext_31)
{
    Fabric_0 device* _S472 = kernelContext_31->fabrics_0+_S471;
    bool _S473;
    if(((kernelContext_31->families_0+_S472->warp_0)->hairiness_0) > 0.0f)
    {
        _S473 = true;
    }
    else
    {
        _S473 = ((kernelContext_31->families_0+_S472->weft_0)->hairiness_0) > 0.0f;
    }
    return _S473;
}

Hair_0 hair_at_0(uint _S474, float2 _S475, bool _S476, float _S477, KernelContext_0 thread* kernelContext_32)
{
    Fabric_0 device* _S478 = kernelContext_32->fabrics_0+_S474;
    float _S479 = _S478->fibre_size_0;
    float _S480 = 17.0f * _S478->fibre_size_0;
    float _S481 = fade_0(_S477, _S480);
    float2 _S482 = _S475 / float2(_S480) ;
    uint number_1;
    if(_S476)
    {
        number_1 = 1U;
    }
    else
    {
        number_1 = 0U;
    }
    uint _S483 = hash_key_0(number_1, (_S478->seed_1) ^ 1013904242U);
    float _S484 = 1.0f / max(_S477, 0.07999999821186066f * _S479);
    float _S485 = min(0.63999998569488525f * _S479 * _S484, 1.0f);
    float2 _S486 = float2(0.0f, 1.0f);
    float cover_2 = 0.0f;
    float hair_away_0 = 0.0f;
    float2 hair_across_0 = _S486;
    number_1 = 0U;
    for(;;)
    {
        bool _S487;
        if(_S481 > 0.0f)
        {
            _S487 = number_1 < 18U;
        }
        else
        {
            _S487 = false;
        }
        if(_S487)
        {
        }
        else
        {
            break;
        }
        uint _S488 = number_1 / 9U;
        uint _S489 = number_1 / 3U - 3U * _S488;
        float2 _S490 = floor(_S482) + float2(float(number_1 - 3U * _S489 - 9U * _S488), float(_S489)) - float2(1.0f) ;
        uint _S491 = hash_bits_0(_S483 + _S488, uint(int(_S490.x)) * 65536U + uint(int(_S490.y)));
        uint _S492 = hash_bits_0(_S483, _S491);
        float2 _S493 = _S482 - _S490 - float2(share_of_0(_S491), share_of_0(_S491 >> 10U));
        float2 _S494 = sine_cosine_0(3.14159274101257324f * share_of_0(_S491 >> 20U));
        float _S495 = mix(5.0f, 16.0f, share_of_0(_S492 >> 10U)) / 17.0f;
        float _S496 = _S493.x;
        float _S497 = _S494.y;
        float _S498 = _S493.y;
        float _S499 = _S494.x;
        float _S500 = (_S496 * _S497 + _S498 * _S499) / _S495;
        float _S501 = 0.69999998807907104f * (2.0f * share_of_0(_S492 >> 20U) - 1.0f);
        float _S502 = 2.0f * _S501 * _S500;
        float _S503 = rsqrt(_S502 * _S502 + 1.0f);
        float _S504 = (_S498 * _S497 - _S496 * _S499 - _S501 * _S495 * _S500 * _S500) * _S503 * 17.0f;
        float _S505 = clamp((0.31999999284744263f - abs(_S504)) * _S479 * _S484 + 0.5f, 0.0f, _S485);
        uint _S506;
        if(((_S492 >> 30U) & 1U) == 1U)
        {
            _S506 = _S478->warp_0;
        }
        else
        {
            _S506 = _S478->weft_0;
        }
        bool _S507;
        if((share_of_0(_S492)) < ((kernelContext_32->families_0+_S506)->hairiness_0))
        {
            _S507 = (abs(_S500)) < 1.0f;
        }
        else
        {
            _S507 = false;
        }
        bool _S508;
        if(_S507)
        {
            _S508 = _S505 > cover_2;
        }
        else
        {
            _S508 = false;
        }
        if(_S508)
        {
            float2 _S509 = float2(- _S499 - _S502 * _S497, _S497 - _S502 * _S499) * float2(_S503) ;
            cover_2 = _S505;
            hair_away_0 = _S504;
            hair_across_0 = _S509;
        }
        number_1 = number_1 + 1U;
    }
    float _S510 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    thread Hair_0 hair_1;
    (&hair_1)->cover_0 = _S481 * cover_2;
    (&hair_1)->normal_0 = float3(float2(_S510)  * hair_across_0, sqrt(1.0f - _S510 * _S510));
    (&hair_1)->tangent_0 = float3(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

bool varies_at_0(uint _S511, float _S512, KernelContext_0 thread* kernelContext_33)
{
    Fabric_0 device* _S513 = kernelContext_33->fabrics_0+_S511;
    bool _S514;
    if((_S513->fibre_noise_0) > 0.0f)
    {
        _S514 = true;
    }
    else
    {
        _S514 = (_S513->colour_noise_0) > 0.0f;
    }
    if(_S514)
    {
        _S514 = true;
    }
    else
    {
        if((_S513->has_detail_0) != 0U)
        {
            _S514 = _S512 >= 0.0f;
        }
        else
        {
            _S514 = false;
        }
    }
    return _S514;
}

uint thread_number_0(uint _S515, const SurfacePoint_0 thread* _S516, float _S517, float _S518, KernelContext_0 thread* kernelContext_34)
{
    Fabric_0 device* _S519 = kernelContext_34->fabrics_0+_S515;
    bool _S520 = _S516->is_warp_1;
    float _S521;
    if(_S516->is_warp_1)
    {
        _S521 = _S517;
    }
    else
    {
        _S521 = _S518;
    }
    float _S522 = _S521 - _S516->across_3;
    uint _S523;
    if(_S520)
    {
        _S523 = _S519->warp_0;
    }
    else
    {
        _S523 = _S519->weft_0;
    }
    float _S524 = (kernelContext_34->families_0+_S523)->period_0;
    int _S525 = int((kernelContext_34->families_0+_S523)->count_0);
    if(_S520)
    {
        _S523 = _S516->warp_thread_0;
    }
    else
    {
        _S523 = _S516->weft_thread_0;
    }
    uint _S526 = uint(int(floor(_S522 / _S524)) * _S525 + int(_S523)) * 2U;
    if(_S520)
    {
        _S523 = 1U;
    }
    else
    {
        _S523 = 0U;
    }
    return _S526 + _S523;
}

struct FibreNoise_0
{
    float2 bundle_0;
    float bundle_weight_0;
    float2 fibre_0;
    float fibre_weight_0;
    float offset_2;
    float slope_2;
};

FibreNoise_0 fibre_noise_at_0(uint _S527, uint _S528, const SurfacePoint_0 thread* _S529, uint _S530, float _S531, KernelContext_0 thread* kernelContext_35)
{
    Fabric_0 device* _S532 = kernelContext_35->fabrics_0+_S527;
    float _S533 = 5.0f * _S532->fibre_size_0;
    float2 _S534 = wave_noise_0(hash_key_0(_S530, (_S532->seed_1) ^ 458671337U), _S529->fibre_along_0 / (25.0f * _S532->fibre_size_0));
    float _S535 = _S529->fibre_across_0 + (kernelContext_35->families_0+_S528)->fibre_tilt_0 * 0.5f * 25.0f * _S532->fibre_size_0 * _S534.x;
    float3 _S536 = fibre_cell_0(_S535, _S529->fibre_along_0, _S532->fibre_size_0);
    thread FibreNoise_0 noise_0;
    (&noise_0)->bundle_0 = cell_noise_0(hash_key_0(_S530, (_S532->seed_1) ^ 1757159915U), fibre_cell_0(_S535, _S529->fibre_along_0, _S533));
    (&noise_0)->bundle_weight_0 = fade_0(_S531, _S533);
    (&noise_0)->fibre_0 = cell_noise_0(hash_key_0(_S530, (_S532->seed_1) ^ 48610963U), _S536);
    (&noise_0)->fibre_weight_0 = fade_0(_S531, _S532->fibre_size_0);
    (&noise_0)->offset_2 = _S536.z;
    (&noise_0)->slope_2 = 0.5f * _S534.y;
    return noise_0;
}

float2 detail_gain_0(uint _S537, uint _S538, const SurfacePoint_0 thread* _S539, float2 _S540, bool _S541, uint _S542, float _S543, KernelContext_0 thread* kernelContext_36)
{
    Fabric_0 device* _S544 = kernelContext_36->fabrics_0+_S537;
    float2 _S545 = float2(0.0f) ;
    float2 gain_1;
    if(((kernelContext_36->families_0+_S538)->has_plies_0) > 0.0f)
    {
        float _S546 = 0.60000002384185791f * fade_0(_S543, 1.0f / (kernelContext_36->families_0+_S538)->plies_per_mm_0);
        float _S547 = ply_offset_0(_S538, _S539, _S541, kernelContext_36);
        gain_1 = float2(_S546)  * float2(0.20000000298023224f - square_0(square_0(_S547)), 0.20000000298023224f);
    }
    else
    {
        gain_1 = _S545;
    }
    if(((kernelContext_36->families_0+_S538)->fibre_tone_0) > 0.0f)
    {
        FibreNoise_0 _S548 = fibre_noise_at_0(_S537, _S538, _S539, _S542, _S543, kernelContext_36);
        gain_1 = gain_1 + float2((kernelContext_36->families_0+_S538)->fibre_tone_0)  * float2(_S548.bundle_weight_0 * _S548.bundle_0.y + _S548.fibre_weight_0 * _S548.fibre_0.y, _S548.bundle_weight_0 + _S548.fibre_weight_0);
    }
    if(((kernelContext_36->families_0+_S538)->slub_0) > 0.0f)
    {
        float _S549 = 0.25f * (kernelContext_36->families_0+_S538)->slub_0 * fade_0(_S543, 1.0f / (kernelContext_36->families_0+_S538)->slubs_per_mm_0);
        float _S550;
        if(_S539->is_warp_1)
        {
            _S550 = _S540.y;
        }
        else
        {
            _S550 = - _S540.x;
        }
        gain_1 = gain_1 + float2(_S549)  * float2(wave_noise_0(hash_key_0(_S542, (_S544->seed_1) ^ 1373058189U), _S550 * (kernelContext_36->families_0+_S538)->slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_0(_S539->across_3 * (kernelContext_36->families_0+_S538)->per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_1;
}

Albedos_0 vary_albedos_0(uint _S551, const Albedos_0 thread* _S552, uint _S553, uint _S554, float2 _S555, KernelContext_0 thread* kernelContext_37)
{
    Fabric_0 device* _S556 = kernelContext_37->fabrics_0+_S551;
    float3 _S557 = max(_S552->specular_reflect_0, _S552->specular_transmit_0);
    float3 _S558 = _S552->diffuse_reflect_0 + _S552->diffuse_transmit_0;
    float3 _S559 = float3(_S556->layer_bound_0) ;
    float3 _S560 = float3(1.0f) ;
    float3 _S561 = _S560 - _S559 * _S557;
    float colour_0 = bounded_gain_0(thread_gain_0(_S553, _S556->colour_noise_0, _S556->seed_1), _S558, _S561);
    float3 _S562 = float3((colour_0 * (1.0f + flattened_0(_S555.y, float3(colour_0)  * _S558, _S561) * _S555.x))) ;
    float _S563 = bounded_gain_0(fibre_gain_0(_S553, _S554, _S556->fibre_noise_0, _S556->seed_1), _S557, min((_S560 - _S562 * _S558) / _S559, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S562 * _S552->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S562 * _S552->diffuse_transmit_0;
    float3 _S564 = float3(_S563) ;
    (&varied_0)->specular_reflect_0 = _S564 * _S552->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S564 * _S552->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S565, const SurfacePoint_0 thread* _S566, const Albedos_0 thread* _S567, float _S568, float _S569, bool _S570, float _S571, float _S572, KernelContext_0 thread* kernelContext_38)
{
    Fabric_0 device* _S573 = kernelContext_38->fabrics_0+_S565;
    uint _S574 = thread_number_0(_S565, _S566, _S568, _S569, kernelContext_38);
    float3 _S575 = fibre_cell_0(_S566->fibre_across_0, _S566->fibre_along_0, _S573->fibre_size_0);
    float2 _S576 = float2(0.0f) ;
    bool _S577;
    if((_S573->has_detail_0) != 0U)
    {
        _S577 = _S571 >= 0.0f;
    }
    else
    {
        _S577 = false;
    }
    float2 gain_2;
    if(_S577)
    {
        uint _S578;
        if(_S566->is_warp_1)
        {
            _S578 = _S573->warp_0;
        }
        else
        {
            _S578 = _S573->weft_0;
        }
        float2 _S579 = detail_gain_0(_S565, _S578, _S566, float2(_S568, _S569), _S570, _S574, _S571, kernelContext_38);
        gain_2 = _S579 * float2(1.0f - _S572, 1.0f);
    }
    else
    {
        gain_2 = _S576;
    }
    Albedos_0 _S580 = vary_albedos_0(_S565, _S567, _S574, uint(int(_S575.x)) * 65536U + uint(int(floor(_S575.y))), gain_2, kernelContext_38);
    return _S580;
}

YarnFrame_0 turned_frame_0(uint _S581, uint _S582, const SurfacePoint_0 thread* _S583, bool _S584, uint _S585, float _S586, KernelContext_0 thread* kernelContext_39)
{
    thread YarnFrame_0 frame_2;
    (&frame_2)->normal_3 = _S583->normal_2;
    (&frame_2)->tangent_3 = _S583->tangent_2;
    (&frame_2)->loss_0 = 0.0f;
    if(((kernelContext_39->families_0+_S582)->has_plies_0) > 0.0f)
    {
        float _S587 = fade_0(_S586, 1.0f / (kernelContext_39->families_0+_S582)->plies_per_mm_0);
        float _S588 = _S587 * 0.41999998688697815f;
        float _S589 = ply_offset_0(_S582, _S583, _S584, kernelContext_39);
        float _S590 = _S588 * _S589;
        float _S591 = sqrt(1.0f - _S590 * _S590);
        float _S592;
        if(_S584)
        {
            _S592 = - (kernelContext_39->families_0+_S582)->ply_sine_0;
        }
        else
        {
            _S592 = (kernelContext_39->families_0+_S582)->ply_sine_0;
        }
        float3 _S593 = cross((&frame_2)->tangent_3, (&frame_2)->normal_3);
        float3 _S594 = float3((kernelContext_39->families_0+_S582)->ply_cosine_0) ;
        float3 _S595 = _S594 * _S593 + float3(_S592)  * (&frame_2)->tangent_3;
        float3 _S596 = float3(_S591) ;
        float3 _S597 = float3(_S590) ;
        (&frame_2)->tangent_3 = _S594 * (_S594 * (&frame_2)->tangent_3 - float3(_S592)  * _S593) + float3(_S592)  * (_S596 * _S595 - _S597 * (&frame_2)->normal_3);
        (&frame_2)->normal_3 = _S596 * (&frame_2)->normal_3 + _S597 * _S595;
        (&frame_2)->loss_0 = _S587 * _S587 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    float _S598 = (kernelContext_39->families_0+_S582)->fibre_tilt_0;
    if(((kernelContext_39->families_0+_S582)->fibre_tilt_0) > 0.0f)
    {
        FibreNoise_0 _S599 = fibre_noise_at_0(_S581, _S582, _S583, _S585, _S586, kernelContext_39);
        float _S600 = 1.09858846664428711f * _S598 * (_S599.bundle_weight_0 * _S599.bundle_0.x + _S599.fibre_weight_0 * (_S599.fibre_0.x + _S599.offset_2));
        float _S601 = _S598 * (1.42099642753601074f * (_S599.bundle_weight_0 * _S599.bundle_0.y + _S599.fibre_weight_0 * _S599.fibre_0.y) - _S599.bundle_weight_0 * _S599.slope_2);
        float _S602 = square_0(_S599.fibre_weight_0);
        (&frame_2)->loss_0 = (&frame_2)->loss_0 + 0.5f * _S598 * _S598 * ((0.24761904776096344f * (square_0(_S599.bundle_weight_0) + _S602) + _S602 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        float3 _S603 = cross((&frame_2)->tangent_3, (&frame_2)->normal_3);
        float2 _S604 = sine_cosine_0(_S600);
        float2 _S605 = sine_cosine_0(_S601);
        float3 _S606 = float3(_S604.y) ;
        float3 _S607 = float3(_S604.x) ;
        float3 _S608 = _S606 * _S603 - _S607 * (&frame_2)->normal_3;
        (&frame_2)->normal_3 = _S606 * (&frame_2)->normal_3 + _S607 * _S603;
        (&frame_2)->tangent_3 = float3(_S605.y)  * (&frame_2)->tangent_3 + float3(_S605.x)  * _S608;
    }
    return frame_2;
}

YarnPoint_0 yarn_point_of_0(uint _S609, const SurfacePoint_0 thread* _S610, float _S611, float _S612, bool _S613, bool _S614, float _S615, KernelContext_0 thread* kernelContext_40)
{
    Fabric_0 device* _S616 = kernelContext_40->fabrics_0+_S609;
    bool _S617 = _S610->is_warp_1;
    uint _S618;
    if(_S610->is_warp_1)
    {
        _S618 = _S616->warp_0;
    }
    else
    {
        _S618 = _S616->weft_0;
    }
    bool _S619;
    if((_S616->has_detail_0) != 0U)
    {
        _S619 = _S615 >= 0.0f;
    }
    else
    {
        _S619 = false;
    }
    float3 _S620 = float3(0.0f) ;
    Hair_0 _S621 = Hair_x24init_0(0.0f, _S620, _S620);
    bool _S622;
    if(_S619)
    {
        bool _S623 = has_hairs_0(_S609, kernelContext_40);
        _S622 = _S623;
    }
    else
    {
        _S622 = false;
    }
    Hair_0 hair_2;
    if(_S622)
    {
        Hair_0 _S624 = hair_at_0(_S609, float2(_S611, _S612), _S613, _S615, kernelContext_40);
        hair_2 = _S624;
    }
    else
    {
        hair_2 = _S621;
    }
    uint _S625;
    if(_S617)
    {
        _S625 = _S610->warp_thread_0;
    }
    else
    {
        _S625 = _S610->weft_thread_0;
    }
    Albedos_0 _S626 = albedos_of_0(_S618, _S625, kernelContext_40);
    bool _S627 = varies_at_0(_S609, _S615, kernelContext_40);
    Albedos_0 albedos_2;
    if(_S627)
    {
        thread Albedos_0 _S628 = _S626;
        Albedos_0 _S629 = varied_at_0(_S609, _S610, &_S628, _S611, _S612, _S613, _S615, hair_2.cover_0, kernelContext_40);
        albedos_2 = _S629;
    }
    else
    {
        albedos_2 = _S626;
    }
    thread YarnPoint_0 point_2;
    (&point_2)->back_6 = _S613;
    (&point_2)->hole_3 = _S614;
    (&point_2)->is_warp_2 = _S617;
    (&point_2)->x_8 = _S611;
    (&point_2)->y_3 = _S612;
    (&point_2)->height_4 = _S610->height_3;
    (&point_2)->normal_7 = _S610->normal_2;
    (&point_2)->tangent_8 = _S610->tangent_2;
    (&point_2)->surface_normal_0 = _S610->normal_2;
    (&point_2)->diffuse_gain_1 = 1.0f;
    if(_S619)
    {
        uint _S630 = thread_number_0(_S609, _S610, _S611, _S612, kernelContext_40);
        YarnFrame_0 _S631 = turned_frame_0(_S609, _S618, _S610, _S613, _S630, _S615, kernelContext_40);
        bool _S632 = has_hairs_0(_S609, kernelContext_40);
        YarnFrame_0 frame_3;
        if(_S632)
        {
            thread YarnFrame_0 _S633 = _S631;
            thread Hair_0 _S634 = hair_2;
            YarnFrame_0 _S635 = under_hair_0(&_S633, &_S634);
            frame_3 = _S635;
        }
        else
        {
            frame_3 = _S631;
        }
        (&point_2)->normal_7 = frame_3.normal_3;
        (&point_2)->tangent_8 = frame_3.tangent_3;
        thread YarnFrame_0 _S636 = frame_3;
        float _S637 = diffuse_gain_0(&_S636, _S616->diffuse_blend_0);
        (&point_2)->diffuse_gain_1 = _S637;
    }
    (&point_2)->roughness_8 = (kernelContext_40->families_0+_S618)->roughness_0;
    (&point_2)->albedos_1 = albedos_2;
    return point_2;
}

YarnPoint_0 locate_yarn_0(uint _S638, const SearchQuality_0 thread* _S639, float _S640, float _S641, float3 _S642, float _S643, KernelContext_0 thread* kernelContext_41)
{
    bool _S644 = (_S642.z) < 0.0f;
    Hit_0 _S645 = first_hit_0(_S638, _S639, _S640, _S641, to_face_frame_0(_S642, _S644), _S644, kernelContext_41);
    SurfacePoint_0 _S646 = surface_at_0(_S638, _S645.x_9, _S645.y_4, _S644, kernelContext_41);
    thread SurfacePoint_0 _S647 = _S646;
    YarnPoint_0 _S648 = yarn_point_of_0(_S638, &_S647, _S645.x_9, _S645.y_4, _S644, _S645.hole_4, _S643, kernelContext_41);
    return _S648;
}

float openness_number_0(uint _S649, uint _S650, KernelContext_0 thread* kernelContext_42)
{
    float _S651 = table_number_0((kernelContext_42->fabrics_0+_S649)->openness_0 + _S650, kernelContext_42);
    return _S651;
}

Blocked_0 blocked_of_terms_0(uint _S652, uint _S653, const array<float, int(6)> thread* _S654, uint _S655, KernelContext_0 thread* kernelContext_43)
{
    thread array<float, int(3)> shares_0;
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
            if(term_0 < _S655)
            {
            }
            else
            {
                break;
            }
            float _S656 = openness_number_0(_S652, _S653 + share_2 * _S655 + term_0, kernelContext_43);
            shares_0[share_2] = shares_0[share_2] + _S656 * (*_S654)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_2] = saturate(shares_0[share_2]);
        share_2 = share_2 + 1U;
    }
    thread Blocked_0 blocked_1;
    (&blocked_1)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_1)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_1)->far_0 = shares_0[int(1)];
    return blocked_1;
}

Blocked_0 blocked_at_0(uint _S657, bool _S658, bool _S659, float _S660, float _S661, KernelContext_0 thread* kernelContext_44)
{
    float _S662 = openness_number_0(_S657, 158U, kernelContext_44);
    float _S663 = _S661 * _S662;
    float _S664 = _S660 * _S660;
    float _S665 = _S660 * _S663;
    float _S666 = _S663 * _S663;
    uint _S667;
    if(_S659)
    {
        _S667 = 2U;
    }
    else
    {
        _S667 = 0U;
    }
    uint _S668;
    if(_S658)
    {
        _S668 = 0U;
    }
    else
    {
        _S668 = 1U;
    }
    uint _S669 = 60U + (_S667 + _S668) * 18U;
    thread array<float, int(6)> _S670;
    _S670[int(0)] = 1.0f;
    _S670[int(1)] = _S660;
    _S670[int(2)] = _S663;
    _S670[int(3)] = _S664;
    _S670[int(4)] = _S665;
    _S670[int(5)] = _S666;
    Blocked_0 _S671 = blocked_of_terms_0(_S657, _S669, &_S670, 6U, kernelContext_44);
    return _S671;
}

Scattered_0 scattered_by_0(uint _S672, const Albedos_0 thread* _S673, uint _S674, float3 _S675, KernelContext_0 thread* kernelContext_45)
{
    uint _S676 = 159U + 2U * _S674;
    thread Scattered_0 yarn_3;
    float3 _S677 = _S675 * _S673->diffuse_reflect_0;
    float _S678 = openness_number_0(_S672, _S676, kernelContext_45);
    (&yarn_3)->back_5 = _S677 + float3(_S678)  * _S673->specular_reflect_0;
    float3 _S679 = _S675 * _S673->diffuse_transmit_0;
    float _S680 = openness_number_0(_S672, _S676 + 1U, kernelContext_45);
    (&yarn_3)->through_0 = _S679 + float3(_S680)  * _S673->specular_transmit_0;
    return yarn_3;
}

float openness_number_1(uint _S681, uint _S682, KernelContext_0 thread* kernelContext_46)
{
    float _S683 = table_number_0((kernelContext_46->fabrics_0+_S681)->openness_0 + _S682, kernelContext_46);
    return _S683;
}

void sent_0(uint _S684, uint _S685, float3 _S686, float3 _S687, float3 _S688, float3 _S689, float3 thread* _S690, float3 thread* _S691, KernelContext_0 thread* kernelContext_47)
{
    uint _S692 = 146U + 4U * _S685;
    float _S693 = openness_number_1(_S684, _S692, kernelContext_47);
    float _S694 = openness_number_1(_S684, _S692 + 1U, kernelContext_47);
    float _S695 = openness_number_1(_S684, _S692 + 2U, kernelContext_47);
    float _S696 = openness_number_1(_S684, _S692 + 3U, kernelContext_47);
    float3 _S697 = float3(1.0f) ;
    float3 _S698 = _S697 - _S688 * float3(_S693) ;
    float3 _S699 = _S697 - _S689 * float3(_S696) ;
    float3 _S700 = _S697 / (_S698 * _S699 - _S688 * _S689 * float3((_S694 * _S695)) );
    *_S690 = (_S686 * _S699 + _S688 * float3(_S694)  * _S687) * _S700;
    *_S691 = (_S687 * _S698 + _S689 * float3(_S695)  * _S686) * _S700;
    return;
}

FaceSends_0 face_sends_0(uint _S701, uint _S702, const Scattered_0 thread* _S703, const Scattered_0 thread* _S704, KernelContext_0 thread* kernelContext_48)
{
    uint _S705 = 2U * _S702;
    uint _S706 = 142U + _S705;
    float _S707 = openness_number_0(_S701, _S706, kernelContext_48);
    float _S708 = openness_number_0(_S701, _S706 + 1U, kernelContext_48);
    float3 _S709 = _S703->back_5;
    float3 _S710 = float3((1.0f - _S707))  * _S703->back_5;
    float3 _S711 = _S704->back_5;
    float3 _S712 = float3((1.0f - _S708))  * _S704->back_5;
    thread FaceSends_0 sends_1;
    uint _S713 = 154U + _S705;
    float _S714 = openness_number_0(_S701, _S713, kernelContext_48);
    (&sends_1)->blocks_warp_0 = _S714;
    float _S715 = openness_number_0(_S701, _S713 + 1U, kernelContext_48);
    (&sends_1)->blocks_weft_0 = _S715;
    (&sends_1)->open_0 = _S714 * _S707 + _S715 * _S708;
    sent_0(_S701, _S702, float3(_S707)  * _S709, float3(_S708)  * _S711, _S710, _S712, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0, kernelContext_48);
    sent_0(_S701, _S702, _S703->through_0, _S704->through_0, _S710, _S712, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0, kernelContext_48);
    return sends_1;
}

Interior_0 interior_of_0(uint _S716, float3 _S717, bool _S718, KernelContext_0 thread* kernelContext_49)
{
    Fabric_0 device* _S719 = kernelContext_49->fabrics_0+_S716;
    Albedos_0 _S720 = table_albedos_0((kernelContext_49->families_0+_S719->warp_0)->colour_mean_0, kernelContext_49);
    thread Albedos_0 _S721 = _S720;
    Scattered_0 _S722 = scattered_by_0(_S716, &_S721, 0U, _S717, kernelContext_49);
    Albedos_0 _S723 = table_albedos_0((kernelContext_49->families_0+_S719->weft_0)->colour_mean_0, kernelContext_49);
    thread Albedos_0 _S724 = _S723;
    Scattered_0 _S725 = scattered_by_0(_S716, &_S724, 1U, _S717, kernelContext_49);
    uint _S726;
    if(_S718)
    {
        _S726 = 1U;
    }
    else
    {
        _S726 = 0U;
    }
    thread Scattered_0 _S727 = _S722;
    thread Scattered_0 _S728 = _S725;
    FaceSends_0 _S729 = face_sends_0(_S716, _S726, &_S727, &_S728, kernelContext_49);
    if(_S718)
    {
        _S726 = 0U;
    }
    else
    {
        _S726 = 1U;
    }
    thread Scattered_0 _S730 = _S722;
    thread Scattered_0 _S731 = _S725;
    FaceSends_0 _S732 = face_sends_0(_S716, _S726, &_S730, &_S731, kernelContext_49);
    float3 _S733 = float3(_S729.blocks_warp_0) ;
    float3 _S734 = float3(_S729.blocks_weft_0) ;
    float3 _S735 = _S733 * _S729.crossing_warp_0 + _S734 * _S729.crossing_weft_0;
    float3 _S736 = float3(_S732.blocks_warp_0) ;
    float3 _S737 = float3(_S732.blocks_weft_0) ;
    float3 _S738 = _S736 * _S732.crossing_warp_0 + _S737 * _S732.crossing_weft_0;
    float _S739 = 1.0f - _S729.open_0;
    float _S740 = 1.0f - _S732.open_0;
    float3 _S741 = float3(1.0f) ;
    float3 _S742 = _S741 / (_S741 - _S735 * _S738 * float3((_S739 * _S740)) );
    float3 _S743 = _S738 * (float3(_S729.open_0)  + float3(_S739)  * (_S733 * _S729.sky_warp_0 + _S734 * _S729.sky_weft_0)) * _S742;
    float3 _S744 = _S735 * (float3(_S732.open_0)  + float3(_S740)  * (_S736 * _S732.sky_warp_0 + _S737 * _S732.sky_weft_0)) * _S742;
    thread FaceSends_0 _S745 = _S729;
    FaceRadiance_0 _S746 = face_radiance_0(&_S745, _S732.open_0, _S743, _S744);
    thread FaceSends_0 _S747 = _S732;
    FaceRadiance_0 _S748 = face_radiance_0(&_S747, _S729.open_0, _S744, _S743);
    thread Interior_0 interior_1;
    (&interior_1)->warp_3 = _S746.warp_2;
    (&interior_1)->weft_3 = _S746.weft_2;
    (&interior_1)->leaked_1 = _S746.leaked_0;
    (&interior_1)->far_1 = _S748.mean_0;
    (&interior_1)->far_leaked_0 = _S748.leaked_0;
    return interior_1;
}

Bounced_0 bounced_at_0(uint _S749, const YarnPoint_0 thread* _S750, float3 _S751, KernelContext_0 thread* kernelContext_50)
{
    Fabric_0 device* _S752 = kernelContext_50->fabrics_0+_S749;
    thread Bounced_0 nothing_0;
    float3 _S753 = float3(0.0f) ;
    (&nothing_0)->reflected_0 = _S753;
    (&nothing_0)->transmitted_0 = _S753;
    bool _S754;
    if((_S752->openness_0) == 4294967295U)
    {
        _S754 = true;
    }
    else
    {
        _S754 = _S750->hole_3;
    }
    if(_S754)
    {
        return nothing_0;
    }
    bool _S755 = _S750->is_warp_2;
    bool _S756 = _S750->back_6;
    Blocked_0 _S757 = blocked_at_0(_S749, _S750->is_warp_2, _S750->back_6, _S750->surface_normal_0.z, _S750->height_4, kernelContext_50);
    uint _S758;
    if(_S755)
    {
        _S758 = 0U;
    }
    else
    {
        _S758 = 1U;
    }
    Scattered_0 _S759 = scattered_by_0(_S749, &_S750->albedos_1, _S758, _S751, kernelContext_50);
    Interior_0 _S760 = interior_of_0(_S749, _S751, _S756, kernelContext_50);
    thread Blocked_0 _S761 = _S757;
    thread Scattered_0 _S762 = _S759;
    thread Interior_0 _S763 = _S760;
    Bounced_0 _S764 = bounced_by_0(&_S761, &_S762, &_S763);
    return _S764;
}

float3 scattered_0(uint _S765, const YarnPoint_0 thread* _S766, float3 _S767, float3 _S768, KernelContext_0 thread* kernelContext_51)
{
    Fabric_0 device* _S769 = kernelContext_51->fabrics_0+_S765;
    float3 _S770 = float3(0.0f) ;
    bool _S771 = !_S766->hole_3;
    bool _S772;
    if(_S771)
    {
        _S772 = (_S767.z) > 0.0f;
    }
    else
    {
        _S772 = false;
    }
    float3 value_1;
    if(_S772)
    {
        value_1 = (&_S766->albedos_1)->diffuse_reflect_0 * float3(_S766->diffuse_gain_1)  * float3(diffuse_reflection_0(_S767, _S766->normal_7, _S769->diffuse_blend_0))  + (&_S766->albedos_1)->specular_reflect_0 * float3(reflection_0(_S767, _S768, _S766->normal_7, _S766->tangent_8, _S766->roughness_8, _S769->optical_depth_0)) ;
    }
    else
    {
        if(_S771)
        {
            _S772 = (_S767.z) < 0.0f;
        }
        else
        {
            _S772 = false;
        }
        if(_S772)
        {
            value_1 = (&_S766->albedos_1)->diffuse_transmit_0 * float3(_S766->diffuse_gain_1)  * float3(diffuse_reflection_0(- _S767, _S766->normal_7, _S769->diffuse_blend_0))  + (&_S766->albedos_1)->specular_transmit_0 * float3(transmission_1(_S767, _S768, _S766->normal_7, _S766->tangent_8, _S766->roughness_8, _S769->optical_depth_0)) ;
        }
        else
        {
            value_1 = _S770;
        }
    }
    float _S773 = _S769->sheen_strength_0;
    if((_S769->sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S774 = sheen_with_transmittance_0(_S767, _S768, _S773, _S769->sheen_roughness_0);
    return float3(_S774.y)  * value_1 + float3(_S774.x) ;
}

bool unoccluded_0(uint _S775, const SearchQuality_0 thread* _S776, float _S777, float _S778, float _S779, float3 _S780, bool _S781, KernelContext_0 thread* kernelContext_52)
{
    Fabric_0 device* _S782 = kernelContext_52->fabrics_0+_S775;
    if((_S780.z) <= 0.0f)
    {
        return false;
    }
    float _S783 = max_height_along_0(_S775, _S777, _S778, _S779, _S780, _S781, kernelContext_52);
    bool _S784 = is_free_0(_S775, _S776, float3(_S777, _S778, _S779 + _S782->lift_0), _S780, _S781, _S783, kernelContext_52);
    return _S784;
}

bool is_lit_0(uint _S785, const SearchQuality_0 thread* _S786, const YarnPoint_0 thread* _S787, float3 _S788, KernelContext_0 thread* kernelContext_53)
{
    if(_S787->hole_3)
    {
        return true;
    }
    bool _S789 = _S787->back_6;
    float3 _S790 = to_face_frame_0(_S788, _S787->back_6);
    float _S791 = _S790.z;
    bool _S792 = _S791 < 0.0f;
    float3 _S793 = _S787->surface_normal_0;
    float _S794 = _S787->height_4;
    float3 normal_8;
    float height_10;
    if(_S792)
    {
        SurfacePoint_0 _S795 = surface_at_0(_S785, _S787->x_8, _S787->y_3, !_S789, kernelContext_53);
        normal_8 = _S795.normal_2;
        height_10 = _S795.height_3;
    }
    else
    {
        normal_8 = _S793;
        height_10 = _S794;
    }
    float3 _S796 = float3(_S790.xy, abs(_S791));
    if((dot(normal_8, _S796)) <= 0.0f)
    {
        return false;
    }
    bool _S797 = unoccluded_0(_S785, _S786, _S787->x_8, _S787->y_3, height_10, _S796, _S789 != _S792, kernelContext_53);
    return _S797;
}

float3 evaluate_with_0(uint _S798, const SearchQuality_0 thread* _S799, const YarnPoint_0 thread* _S800, const Bounced_0 thread* _S801, float3 _S802, float3 _S803, KernelContext_0 thread* kernelContext_54)
{
    Fabric_0 device* _S804 = kernelContext_54->fabrics_0+_S798;
    float3 _S805 = to_face_frame_0(_S803, _S800->back_6);
    float3 _S806 = scattered_0(_S798, _S800, to_face_frame_0(_S802, _S800->back_6), _S805, kernelContext_54);
    bool _S807;
    if((max(_S806.x, max(_S806.y, _S806.z))) <= 0.0f)
    {
        _S807 = true;
    }
    else
    {
        bool _S808 = is_lit_0(_S798, _S799, _S800, _S802, kernelContext_54);
        _S807 = !_S808;
    }
    float3 value_2;
    if(_S807)
    {
        value_2 = float3(0.0f) ;
    }
    else
    {
        value_2 = _S806;
    }
    float3 _S809 = bounced_value_0(_S801, _S802, _S803);
    float _S810 = _S804->sheen_strength_0;
    float3 between_1;
    if((_S804->sheen_strength_0) > 0.0f)
    {
        between_1 = _S809 * float3((1.0f - _S810 * sheen_lobe_0(abs(_S805.z), _S804->sheen_roughness_0).z)) ;
    }
    else
    {
        between_1 = _S809;
    }
    return value_2 + between_1;
}

float3 evaluate_0(uint _S811, const SearchQuality_0 thread* _S812, const YarnPoint_0 thread* _S813, float3 _S814, float3 _S815, KernelContext_0 thread* kernelContext_55)
{
    Bounced_0 _S816 = bounced_at_0(_S811, _S813, float3(1.0f) , kernelContext_55);
    thread Bounced_0 _S817 = _S816;
    float3 _S818 = evaluate_with_0(_S811, _S812, _S813, &_S817, _S814, _S815, kernelContext_55);
    return _S818;
}

float straight_through_0(uint _S819, const YarnPoint_0 thread* _S820, float3 _S821, KernelContext_0 thread* kernelContext_56)
{
    Fabric_0 device* _S822 = kernelContext_56->fabrics_0+_S819;
    if(!_S820->hole_3)
    {
        return 0.0f;
    }
    float _S823 = _S822->sheen_strength_0;
    if((_S822->sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S823 * sheen_lobe_0(abs(_S821.z), _S822->sheen_roughness_0).z;
}

float4 cloth_value_0(uint fabric_1, float2 centre_1, float2 dx_1, float2 dy_1, float3 light_8, float3 view_7, KernelContext_0 thread* kernelContext_57)
{
    SearchQuality_0 _S824 = default_quality_0();
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_1;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    float _S825 = centre_1.x;
    float _S826 = centre_1.y;
    thread Footprint_0 _S827 = footprint_0;
    float _S828 = Footprint_spread_side_0(&_S827);
    thread SearchQuality_0 _S829 = _S824;
    YarnPoint_0 _S830 = locate_yarn_0(fabric_1, &_S829, _S825, _S826, view_7, _S828, kernelContext_57);
    thread SearchQuality_0 _S831 = _S824;
    thread YarnPoint_0 _S832 = _S830;
    float3 _S833 = evaluate_0(fabric_1, &_S831, &_S832, light_8, view_7, kernelContext_57);
    thread YarnPoint_0 _S834 = _S830;
    float _S835 = straight_through_0(fabric_1, &_S834, view_7, kernelContext_57);
    return float4(_S833, _S835);
}

[[kernel]] void point_queries(uint3 id_0 [[thread_position_in_grid]], uint device* query_count_1 [[buffer(24)]], Query_0 device* queries_1 [[buffer(23)]], packed_float4 device* answers_1 [[buffer(25)]], Fabric_0 device* fabrics_1 [[buffer(0)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]])
{
    thread KernelContext_0 kernelContext_58;
    (&kernelContext_58)->query_count_0 = query_count_1;
    (&kernelContext_58)->queries_0 = queries_1;
    (&kernelContext_58)->answers_0 = answers_1;
    (&kernelContext_58)->fabrics_0 = fabrics_1;
    (&kernelContext_58)->families_0 = families_1;
    (&kernelContext_58)->words_0 = words_1;
    uint _S836 = id_0.x;
    if(_S836 >= query_count_1[int(0)])
    {
        return;
    }
    Query_0 _S837 = (&kernelContext_58)->queries_0[_S836];
    packed_float4 device* _S838 = (&kernelContext_58)->answers_0+_S836;
    float4 _S839 = cloth_value_0(_S837.fabric_0, float2(_S837.centre_x_0, _S837.centre_y_0), float2(_S837.dx_x_0, _S837.dx_y_0), float2(_S837.dy_x_0, _S837.dy_y_0), float3(_S837.light_x_0, _S837.light_y_0, _S837.light_z_0), float3(_S837.view_x_0, _S837.view_y_0, _S837.view_z_0), &kernelContext_58);
    *_S838 = packed_float4(_S839) ;
    return;
}

