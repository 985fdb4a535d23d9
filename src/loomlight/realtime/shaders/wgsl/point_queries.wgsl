@binding(1) @group(1) var<storage, read> query_count_0 : array<u32>;

struct Query_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) centre_x_0 : f32,
    @align(4) centre_y_0 : f32,
    @align(4) dx_x_0 : f32,
    @align(4) dx_y_0 : f32,
    @align(4) dy_x_0 : f32,
    @align(4) dy_y_0 : f32,
    @align(4) light_x_0 : f32,
    @align(4) light_y_0 : f32,
    @align(4) light_z_0 : f32,
    @align(4) view_x_0 : f32,
    @align(4) view_y_0 : f32,
    @align(4) view_z_0 : f32,
    @align(4) seed_0 : u32,
};

@binding(0) @group(1) var<storage, read> queries_0 : array<Query_std430_0>;

@binding(2) @group(1) var<storage, read_write> answers_0 : array<vec4<f32>>;

struct Lobes_std430_0
{
    @align(4) is_baked_0 : u32,
    @align(4) inverse_base_size_0 : f32,
    @align(4) last_level_0 : f32,
    @align(4) levels_0 : u32,
    @align(4) face_nodes_0 : u32,
    @align(4) packs_0 : u32,
    @align(4) front_warp_packs_0 : u32,
    @align(4) back_warp_packs_0 : u32,
    @align(4) coverage_0 : u32,
    @align(4) coverage_holes_0 : u32,
    @align(4) projected_area_0 : u32,
    @align(4) light_visibility_0 : u32,
    @align(4) irradiance_0 : u32,
    @align(4) moments_0 : u32,
    @align(4) front_hole_weight_0 : f32,
    @align(4) back_hole_weight_0 : f32,
    @align(4) threads_per_mm_0 : f32,
    @align(4) unit_level_0 : f32,
};

struct Neural_std430_0
{
    @align(4) is_encoded_0 : u32,
    @align(4) network_0 : u32,
    @align(4) latents_0 : u32,
    @align(4) texels_0 : u32,
    @align(4) levels_1 : u32,
    @align(4) top_level_0 : u32,
    @align(4) ends_0 : f32,
    @align(4) picks_0 : f32,
    @align(4) ends_per_mm_0 : f32,
    @align(4) picks_per_mm_0 : f32,
    @align(4) pitch_0 : f32,
    @align(4) warp_x_0 : f32,
    @align(4) warp_y_0 : f32,
    @align(4) warp_roughness_0 : f32,
    @align(4) weft_x_0 : f32,
    @align(4) weft_y_0 : f32,
    @align(4) weft_roughness_0 : f32,
    @align(4) warp_lobe_roughness_0 : f32,
    @align(4) weft_lobe_roughness_0 : f32,
    @align(4) bundles_0 : u32,
    @align(4) is_corrected_0 : u32,
    @align(4) correction_0 : u32,
};

struct Neumip_std430_0
{
    @align(4) is_trained_0 : u32,
    @align(4) decoder_0 : u32,
    @align(4) has_offset_0 : u32,
    @align(4) offset_0 : u32,
    @align(4) offset_texels_0 : u32,
    @align(4) features_0 : u32,
    @align(4) texel_elements_0 : u32,
    @align(4) levels_2 : u32,
    @align(4) last_level_1 : f32,
    @align(4) face_texels_0 : u32,
    @align(4) back_0 : u32,
    @align(4) repeats_per_x_0 : f32,
    @align(4) repeats_per_y_0 : f32,
    @align(4) texels_per_mm_0 : f32,
    @align(4) unit_x_0 : f32,
    @align(4) unit_y_0 : f32,
    @align(4) transmits_0 : u32,
    @align(4) transmission_0 : u32,
    @align(4) has_holes_0 : u32,
    @align(4) opacity_0 : u32,
};

struct Latent_std430_0
{
    @align(4) is_trained_1 : u32,
    @align(4) decoder_1 : u32,
    @align(4) hidden_0 : u32,
    @align(4) frames_0 : u32,
    @align(4) sampler_0 : u32,
    @align(4) albedo_0 : u32,
    @align(4) texels_1 : u32,
    @align(4) texel_elements_1 : u32,
    @align(4) levels_3 : u32,
    @align(4) last_level_2 : f32,
    @align(4) face_texels_1 : u32,
    @align(4) back_1 : u32,
    @align(4) repeats_per_x_1 : f32,
    @align(4) repeats_per_y_1 : f32,
    @align(4) texels_per_mm_1 : f32,
    @align(4) width_0 : f32,
    @align(4) height_0 : f32,
    @align(4) is_trilinear_0 : u32,
};

struct Clustered_std430_0
{
    @align(4) is_baked_1 : u32,
    @align(4) clusters_0 : u32,
    @align(4) rank_0 : u32,
    @align(4) channels_0 : u32,
    @align(4) columns_0 : u32,
    @align(4) rows_0 : u32,
    @align(4) texel_width_0 : f32,
    @align(4) texel_height_0 : f32,
    @align(4) samples_0 : u32,
    @align(4) sums_0 : u32,
    @align(4) labels_0 : u32,
    @align(4) coefficients_0 : u32,
    @align(4) basis_0 : u32,
    @align(4) moments_1 : u32,
    @align(4) light_0 : u32,
    @align(4) view_0 : u32,
    @align(4) offset_1 : u32,
    @align(4) trust_0 : u32,
};

struct Fabric_std430_0
{
    @align(4) warp_0 : u32,
    @align(4) weft_0 : u32,
    @align(4) lobes_0 : Lobes_std430_0,
    @align(4) neural_0 : Neural_std430_0,
    @align(4) neumip_0 : Neumip_std430_0,
    @align(4) run_words_0 : u32,
    @align(4) ends_1 : u32,
    @align(4) max_heights_0 : u32,
    @align(4) max_height_columns_0 : u32,
    @align(4) height_low_0 : f32,
    @align(4) height_high_0 : f32,
    @align(4) lift_0 : f32,
    @align(4) threads_per_x_0 : f32,
    @align(4) threads_per_y_0 : f32,
    @align(4) per_relief_0 : f32,
    @align(4) diffuse_blend_0 : f32,
    @align(4) optical_depth_0 : f32,
    @align(4) sheen_strength_0 : f32,
    @align(4) sheen_roughness_0 : f32,
    @align(4) fibre_noise_0 : f32,
    @align(4) colour_noise_0 : f32,
    @align(4) seed_1 : u32,
    @align(4) layer_bound_0 : f32,
    @align(4) fibre_size_0 : f32,
    @align(4) has_detail_0 : u32,
    @align(4) uv_width_0 : f32,
    @align(4) uv_height_0 : f32,
    @align(4) is_open_0 : u32,
    @align(4) openness_0 : u32,
    @align(4) albedo_map_0 : u32,
    @align(4) albedo_map_levels_0 : u32,
    @align(4) has_yarns_0 : u32,
    @align(4) mean_hole_0 : f32,
    @align(4) latent_0 : Latent_std430_0,
    @align(4) clustered_0 : Clustered_std430_0,
};

@binding(0) @group(0) var<storage, read> fabrics_0 : array<Fabric_std430_0>;

struct Family_std430_0
{
    @align(4) is_alike_0 : u32,
    @align(4) count_0 : f32,
    @align(4) inverse_count_0 : f32,
    @align(4) half_inverse_count_0 : f32,
    @align(4) size_0 : f32,
    @align(4) inverse_size_0 : f32,
    @align(4) half_width_0 : f32,
    @align(4) start_0 : f32,
    @align(4) period_0 : f32,
    @align(4) inverse_period_0 : f32,
    @align(4) bins_0 : f32,
    @align(4) first_thread_table_0 : u32,
    @align(4) place_table_0 : u32,
    @align(4) bend_table_0 : u32,
    @align(4) height_scale_0 : f32,
    @align(4) twist_sine_0 : f32,
    @align(4) twist_cosine_0 : f32,
    @align(4) level_0 : f32,
    @align(4) roughness_0 : f32,
    @align(4) albedo_table_0 : u32,
    @align(4) albedo_stride_0 : u32,
    @align(4) before_0 : u32,
    @align(4) visible_total_0 : f32,
    @align(4) smallest_box_0 : f32,
    @align(4) quantities_0 : u32,
    @align(4) colour_mean_0 : u32,
    @align(4) colour_axes_0 : u32,
    @align(4) colour_threads_0 : u32,
    @align(4) colour_areas_0 : u32,
    @align(4) area_unit_0 : f32,
    @align(4) crossing_area_0 : f32,
    @align(4) has_plies_0 : f32,
    @align(4) plies_per_mm_0 : f32,
    @align(4) ply_sine_0 : f32,
    @align(4) ply_cosine_0 : f32,
    @align(4) fibre_tilt_0 : f32,
    @align(4) fibre_tone_0 : f32,
    @align(4) slub_0 : f32,
    @align(4) slubs_per_mm_0 : f32,
    @align(4) per_half_width_0 : f32,
    @align(4) hairiness_0 : f32,
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn default_quality_0() -> SearchQuality_0
{
    var quality_0 : SearchQuality_0;
    quality_0.steps_per_thread_0 = 5.0f;
    quality_0.steps_per_relief_0 = 8.0f;
    quality_0.shadow_share_0 = 1.0f;
    quality_0.refinements_0 = u32(2);
    return quality_0;
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S1 : vec2<f32> = this_0.dx_0;
    var _S2 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S1, _S1) + dot(_S2, _S2)));
}

fn to_face_frame_0( direction_0 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S3 : vec2<f32> = direction_0.xy;
    var _S4 : f32;
    if(back_2)
    {
        _S4 = - direction_0.z;
    }
    else
    {
        _S4 = direction_0.z;
    }
    return vec3<f32>(_S3, _S4);
}

fn turns_and_remainder_0( family_0 : u32,  index_0 : f32) -> vec2<f32>
{
    var _S5 : f32 = floor(fma(index_0, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S5, fma(- _S5, families_0[family_0].count_0, index_0));
}

struct Cell_0
{
     thread_0 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_0 : f32) -> Cell_0
{
    var _S6 : f32 = floor(position_0 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S7 : f32 = fma(- _S6, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S7;
    cell_0.above_0 = families_0[family_1].size_0 - _S7;
    cell_0.across_0 = _S7 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S6).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn locate_varied_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_1 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S8 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S9 : u32;
    if(_S8 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S9 = u32(1);
    }
    else
    {
        _S9 = u32(0);
    }
    var _S10 : u32 = min(thread_1 + _S9, u32(families_0[family_2].count_0) - u32(1));
    var _S11 : u32 = families_0[family_2].place_table_0 + _S10 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S10;
    cell_1.below_0 = _S8 - table_number_0(_S11);
    cell_1.above_0 = table_number_0(_S11 + u32(1)) - _S8;
    cell_1.across_0 = _S8 - table_number_0(_S11 + u32(2));
    cell_1.half_width_1 = table_number_0(_S11 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Shown_0
{
     is_warp_0 : bool,
     hole_0 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

struct Crossing_0
{
     warp_1 : Cell_0,
     weft_1 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_0 : Crossing_0,  back_3 : bool) -> Shown_0
{
    var _S12 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var _S13 : bool = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S14 : bool;
    if(_S12)
    {
        if(!_S13)
        {
            _S14 = true;
        }
        else
        {
            _S14 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S14 = false;
    }
    shown_0.is_warp_0 = _S14;
    if(!_S12)
    {
        _S14 = !_S13;
    }
    else
    {
        _S14 = false;
    }
    shown_0.hole_0 = _S14;
    var _S15 : u32;
    if(shown_0.is_warp_0)
    {
        _S15 = crossing_0.warp_word_0;
    }
    else
    {
        _S15 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S15;
    shown_0.on_top_0 = (((_S15 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_2 : Cell_0;
    var _S16 : u32;
    if(is_first_0)
    {
        _S16 = first_0.thread_0;
    }
    else
    {
        _S16 = second_0.thread_0;
    }
    cell_2.thread_0 = _S16;
    var _S17 : f32;
    if(is_first_0)
    {
        _S17 = first_0.across_0;
    }
    else
    {
        _S17 = second_0.across_0;
    }
    cell_2.across_0 = _S17;
    if(is_first_0)
    {
        _S17 = first_0.half_width_1;
    }
    else
    {
        _S17 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S17;
    if(is_first_0)
    {
        _S17 = first_0.below_0;
    }
    else
    {
        _S17 = second_0.below_0;
    }
    cell_2.below_0 = _S17;
    if(is_first_0)
    {
        _S17 = first_0.above_0;
    }
    else
    {
        _S17 = second_0.above_0;
    }
    cell_2.above_0 = _S17;
    return cell_2;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S18 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S18.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S18.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_3 : u32,  first_1 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_1) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_1);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_4 : u32) -> Bend_0
{
    var _S19 : u32 = families_0[family_6].bend_table_0;
    var _S20 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S20 = u32(0);
    }
    else
    {
        _S20 = thread_4 * u32(4);
    }
    var _S21 : u32 = _S19 + _S20;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S21);
    bend_0.half_tangent_0 = table_number_0(_S21 + u32(1));
    bend_0.arc_0 = table_number_0(_S21 + u32(2));
    return bend_0;
}

struct Run_0
{
     distance_0 : f32,
     near_start_0 : bool,
     from_start_0 : f32,
     to_end_0 : f32,
     reach_0 : f32,
     other_reach_0 : f32,
     bend_1 : Bend_0,
     straight_0 : bool,
     first_crossing_0 : bool,
     last_crossing_0 : bool,
};

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_5 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S22 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S23 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S24 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S25 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S26 : i32 = - _S22;
    var _S27 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S26, i32(0));
    run_0.from_start_0 = _S27;
    var _S28 : i32 = _S23 + i32(1);
    var _S29 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S28);
    run_0.to_end_0 = _S29;
    var _S30 : bool = _S27 < _S29;
    run_0.near_start_0 = _S30;
    var _S31 : i32;
    if(_S30)
    {
        _S31 = _S26 - _S24;
    }
    else
    {
        _S31 = _S28;
    }
    var _S32 : i32;
    if(run_0.near_start_0)
    {
        _S32 = _S26;
    }
    else
    {
        _S32 = _S28 + _S25;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    var _S33 : f32;
    if(run_0.straight_0)
    {
        _S33 = 1.0e+06f;
    }
    else
    {
        _S33 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S33;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S31, _S32), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S22 == i32(0);
    run_0.last_crossing_0 = _S23 == i32(0);
    return run_0;
}

fn square_0( x_1 : f32) -> f32
{
    return x_1 * x_1;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_3 : Cell_0) -> Section_0
{
    var _S34 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S35 : f32 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S35;
    var _S36 : f32 = _S34 * _S34 - square_0(_S35);
    var _S37 : f32 = rsqrt_0(_S36);
    section_0.drop_0 = _S34 - _S36 * _S37;
    section_0.slope_0 = - _S35 * _S37;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_6 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_7].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_7].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_7].bend_table_0 + u32(turns_and_remainder_0(family_7, f32(i32(thread_6) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S38 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S39 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S40 : f32;
    if(_S38)
    {
        _S40 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S40 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S41 : f32 = _S40 - crossed_1.half_width_1;
    var _S42 : bool;
    if(_S38)
    {
        _S42 = run_1.first_crossing_0;
    }
    else
    {
        _S42 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S40 = 0.0f;
    }
    else
    {
        _S40 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S43 : f32;
    if((shown_1.on_top_0) != _S42)
    {
        _S43 = 0.0f;
    }
    else
    {
        var _S44 : f32 = families_0[other_1].height_scale_0;
        var _S45 : i32;
        if(_S38)
        {
            _S45 = i32(-1);
        }
        else
        {
            _S45 = i32(1);
        }
        _S43 = _S44 * edge_drop_0(other_1, crossed_1.thread_0, _S45);
    }
    var _S46 : f32 = 1.0f / max(2.0f * _S41, 9.999999960041972e-13f);
    var _S47 : f32 = clamp((_S41 - _S39) * _S46, 0.0f, 1.0f);
    var _S48 : f32 = _S40 + (_S43 - _S40) * (_S47 * _S47 * (3.0f - 2.0f * _S47));
    var _S49 : f32 = (_S40 - _S43) * (6.0f * _S47 * (1.0f - _S47) * _S46);
    if(_S38)
    {
        _S40 = 1.0f;
    }
    else
    {
        _S40 = -1.0f;
    }
    return vec2<f32>(_S48, _S49 * _S40);
}

struct StepControl_0
{
     step_2 : f32,
     epsilon_0 : f32,
     per_x_0 : f32,
     per_y_0 : f32,
     right_0 : bool,
     up_0 : bool,
};

fn step_control_0( direction_1 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S50 : f32 = direction_1.x;
    control_0.per_x_0 = 1.0f / max(abs(_S50), 9.99999971718068537e-10f);
    var _S51 : f32 = direction_1.y;
    control_0.per_y_0 = 1.0f / max(abs(_S51), 9.99999971718068537e-10f);
    control_0.right_0 = _S50 > 0.0f;
    control_0.up_0 = _S51 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
     clearance_0 : f32,
     rate_0 : f32,
     yarn_0 : u32,
     known_0 : bool,
};

fn no_previous_sample_0() -> PreviousSample_0
{
    var previous_0 : PreviousSample_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_0 = u32(0);
    previous_0.known_0 = false;
    return previous_0;
}

fn outline_distance_0( cell_4 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S52 : f32;
    if(forwards_0)
    {
        _S52 = cell_4.across_0;
    }
    else
    {
        _S52 = - cell_4.across_0;
    }
    var _S53 : f32;
    if(forwards_0)
    {
        _S53 = cell_4.above_0;
    }
    else
    {
        _S53 = cell_4.below_0;
    }
    var _S54 : bool;
    if(forwards_0)
    {
        _S54 = run_2.last_crossing_0;
    }
    else
    {
        _S54 = run_2.first_crossing_0;
    }
    var _S55 : bool;
    if(forwards_0)
    {
        _S55 = run_2.first_crossing_0;
    }
    else
    {
        _S55 = run_2.last_crossing_0;
    }
    var _S56 : f32 = - cell_4.half_width_1;
    var _S57 : bool = _S52 < _S56;
    var _S58 : bool = _S52 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S54 = !_S54;
    }
    else
    {
        _S54 = false;
    }
    if(_S54)
    {
        _S54 = !shown_2.hole_0;
    }
    else
    {
        _S54 = false;
    }
    var _S59 : bool;
    if(_S54)
    {
        _S59 = shown_2.on_top_0;
    }
    else
    {
        _S59 = false;
    }
    if(_S59)
    {
        if(_S55)
        {
            _S55 = _S57;
        }
        else
        {
            _S55 = false;
        }
        _S55 = !_S55;
    }
    else
    {
        _S55 = false;
    }
    if(shown_2.hole_0)
    {
        _S54 = true;
    }
    else
    {
        if(_S54)
        {
            _S54 = !shown_2.on_top_0;
        }
        else
        {
            _S54 = false;
        }
    }
    var _S60 : f32;
    if(_S57)
    {
        _S60 = _S56;
    }
    else
    {
        _S60 = cell_4.half_width_1;
    }
    var _S61 : f32 = _S60 - _S52;
    if(_S54)
    {
        _S52 = 2.0f * _S53 + _S52 - cell_4.half_width_1;
    }
    else
    {
        _S52 = _S53;
    }
    if(_S55)
    {
        if(forwards_0)
        {
            _S52 = run_2.to_end_0;
        }
        else
        {
            _S52 = run_2.from_start_0;
        }
        return _S52;
    }
    if(_S58)
    {
    }
    else
    {
        _S52 = _S61;
    }
    return _S52;
}

struct Probe_0
{
     height_1 : f32,
     hole_1 : bool,
     slope_x_0 : f32,
     slope_y_0 : f32,
     yarn_1 : u32,
     cell_max_0 : f32,
     side_x_0 : f32,
     side_y_0 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
};

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_0 : Probe_0) -> f32
{
    var _S62 : f32 = previous_1.rate_0 * step_4;
    var _S63 : f32 = rate_1 * step_4;
    var _S64 : bool;
    if(!previous_1.known_0)
    {
        _S64 = true;
    }
    else
    {
        _S64 = here_0.hole_1;
    }
    if(_S64)
    {
        _S64 = true;
    }
    else
    {
        _S64 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S64)
    {
        _S64 = true;
    }
    else
    {
        _S64 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S64)
    {
        _S64 = true;
    }
    else
    {
        _S64 = rate_1 <= 0.0f;
    }
    if(_S64)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S62) >= 0.0f)
    {
        _S64 = (3.0f * clearance_1 - _S63) >= 0.0f;
    }
    else
    {
        _S64 = false;
    }
    if(_S64)
    {
        return -1.0f;
    }
    var _S65 : f32 = clearance_1 - previous_1.clearance_0;
    var _S66 : f32 = 6.0f * _S65 - 4.0f * _S62 - 2.0f * _S63;
    var _S67 : f32 = -2.0f * _S62 / max(_S66 + sqrt(max(_S66 * _S66 - 4.0f * (3.0f * (_S62 + _S63 - 2.0f * _S65)) * _S62, 0.0f)), 9.99999968265522539e-21f);
    var _S68 : f32 = 1.0f - _S67;
    var _S69 : f32 = (previous_1.clearance_0 * (2.0f * _S67 + 1.0f) + _S62 * _S67) * _S68 * _S68;
    var _S70 : f32 = (clearance_1 * (2.0f * _S68 + 1.0f) - _S63 * _S68) * _S67 * _S67;
    if(_S67 > 0.01999999955296516f)
    {
        _S64 = _S68 > 0.01999999955296516f;
    }
    else
    {
        _S64 = false;
    }
    if(_S64)
    {
        _S64 = (_S69 + _S70) < 0.0f;
    }
    else
    {
        _S64 = false;
    }
    var _S71 : f32;
    if(_S64)
    {
        _S71 = _S68 * step_4;
    }
    else
    {
        _S71 = -1.0f;
    }
    return _S71;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S72 : f32;
    if(here_1.hole_1)
    {
        _S72 = 1.0e+09f;
    }
    else
    {
        _S72 = clearance_2;
    }
    previous_2.clearance_0 = _S72;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S73 : bool;
    if(!here_1.hole_1)
    {
        _S73 = !is_cell_exit_0;
    }
    else
    {
        _S73 = false;
    }
    previous_2.known_0 = _S73;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S74 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S75 : bool;
    if(!here_2.hole_1)
    {
        _S75 = (rate_3 * _S74 + clearance_3) < 0.0f;
    }
    else
    {
        _S75 = false;
    }
    if(_S75)
    {
        _S75 = _S74 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S75 = false;
    }
    var _S76 : f32;
    if(_S75)
    {
        _S76 = _S74 - this_2.epsilon_0;
    }
    else
    {
        _S76 = max(_S74, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S76);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_2 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_2);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S77 : f32 = end_0 - start_1;
    var _S78 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S77;
    var _S79 : f32 = 3.0f * _S77 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S77, 9.99999968265522539e-21f);
    var i_0 : i32 = i32(0);
    for(;;)
    {
        if(u32(i_0) < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S80 : f32 = clamp(share_0 - (((_S78 * share_0 + _S79) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S78 * share_0 + 2.0f * _S79) * share_0 + start_rate_0, 0.10000000149011612f * _S77 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S81 : i32 = i_0 + i32(1);
        share_0 = _S80;
        i_0 = _S81;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S82 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S83 : f32 = rsqrt_0(_S82);
    var _S84 : f32 = sine_1 * _S83 * rsqrt_0(_S82 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S84 * _S82, _S84 * across_slope_0 * along_slope_0 + cosine_0 * _S83);
}

fn arc_sine_0( x_2 : f32) -> f32
{
    var _S85 : f32 = abs(x_2);
    var _S86 : bool = _S85 > 0.5f;
    var _S87 : f32;
    if(_S86)
    {
        _S87 = 0.5f * (1.0f - _S85);
    }
    else
    {
        _S87 = _S85 * _S85;
    }
    var _S88 : f32;
    if(_S86)
    {
        _S88 = sqrt(max(_S87, 0.0f));
    }
    else
    {
        _S88 = _S85;
    }
    var _S89 : f32 = ((((0.04216320067644119f * _S87 + 0.02418131195008755f) * _S87 + 0.04547002539038658f) * _S87 + 0.07495300471782684f) * _S87 + 0.16666752099990845f) * _S87 * _S88 + _S88;
    if(_S86)
    {
        _S87 = 1.57079637050628662f - 2.0f * _S89;
    }
    else
    {
        _S87 = _S89;
    }
    if(x_2 < 0.0f)
    {
        _S87 = - _S87;
    }
    return _S87;
}

struct Hair_0
{
     cover_0 : f32,
     normal_0 : vec3<f32>,
     tangent_0 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_1 : vec3<f32>,  tangent_1 : vec3<f32>) -> Hair_0
{
    var _S90 : Hair_0;
    _S90.cover_0 = cover_1;
    _S90.normal_0 = normal_1;
    _S90.tangent_0 = tangent_1;
    return _S90;
}

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S91 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S92 : u32 = ((((_S91 >> ((((_S91 >> (u32(28)))) + u32(4))))) ^ (_S91))) * u32(277803737);
    return (((_S92 >> (u32(22)))) ^ (_S92));
}

fn hash_key_0( thread_7 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_7 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_5 : u32) -> u32
{
    return scramble_0(cell_5 + key_0);
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_3 : f32) -> vec2<f32>
{
    var _S93 : f32 = floor(x_3 * 0.63661974668502808f + 0.5f);
    var _S94 : f32 = x_3 - _S93 * 1.5703125f - _S93 * 0.00048375129699707f - _S93 * 7.54979012640433211e-08f;
    var _S95 : f32 = _S94 * _S94;
    var _S96 : f32 = ((-0.00019515295571182f * _S95 + 0.00833216123282909f) * _S95 - 0.16666655242443085f) * _S95 * _S94 + _S94;
    var _S97 : f32 = ((0.00002443315679557f * _S95 - 0.00138873164542019f) * _S95 + 0.04166664555668831f) * _S95 * _S95 - 0.5f * _S95 + 1.0f;
    var _S98 : u32 = (u32(i32(_S93)) & (u32(3)));
    var _S99 : vec2<f32>;
    if(((_S98 & (u32(1)))) != u32(0))
    {
        _S99 = vec2<f32>(_S97, _S96);
    }
    else
    {
        _S99 = vec2<f32>(_S96, _S97);
    }
    var _S100 : f32;
    if(((_S98 & (u32(2)))) != u32(0))
    {
        _S100 = - _S99.x;
    }
    else
    {
        _S100 = _S99.x;
    }
    var _S101 : f32;
    if((((_S98 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S101 = - _S99.y;
    }
    else
    {
        _S101 = _S99.y;
    }
    return vec2<f32>(_S100, _S101);
}

fn table_colour_0( index_2 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_2), table_number_0(index_2 + u32(1)), table_number_0(index_2 + u32(2)));
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn table_albedos_0( row_0 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_0);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_0 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_0 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_0 + u32(9));
    return albedos_0;
}

fn albedos_of_0( family_8 : u32,  thread_8 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_8].albedo_table_0 + families_0[family_8].albedo_stride_0 * thread_8);
}

fn fibre_cell_0( across_2 : f32,  along_0 : f32,  width_1 : f32) -> vec3<f32>
{
    var _S102 : f32 = floor(across_2 / width_1);
    return vec3<f32>(_S102, along_0 / (width_1 * 40.0f) + 0.61799997091293335f * _S102, 2.0f * (across_2 / width_1 - _S102) - 1.0f);
}

struct SurfacePoint_0
{
     hole_2 : bool,
     is_warp_1 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_3 : f32,
     normal_2 : vec3<f32>,
     tangent_2 : vec3<f32>,
     across_3 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn ply_offset_0( family_9 : u32,  point_0 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S103 : f32;
    if(back_4)
    {
        _S103 = - families_0[family_9].ply_sine_0;
    }
    else
    {
        _S103 = families_0[family_9].ply_sine_0;
    }
    var _S104 : f32 = (point_0.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_0.fibre_along_0 * _S103) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S104 - floor(_S104)) - 1.0f;
}

fn signed_noise_0( bits_1 : u32) -> f32
{
    return (f32((bits_1 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_1 : f32) -> f32
{
    return share_1 * share_1 * (3.0f - 2.0f * share_1);
}

fn wave_noise_0( key_1 : u32,  position_3 : f32) -> vec2<f32>
{
    var _S105 : f32 = floor(position_3);
    var _S106 : f32 = position_3 - _S105;
    var _S107 : u32 = u32(i32(_S105));
    var _S108 : f32 = signed_noise_0(hash_bits_0(key_1, _S107));
    var _S109 : f32 = signed_noise_0(hash_bits_0(key_1, _S107 + u32(1)));
    return vec2<f32>(mix(_S108, _S109, smooth_share_0(_S106)), 6.0f * _S106 * (1.0f - _S106) * (_S109 - _S108));
}

fn cell_noise_0( key_2 : u32,  cell_6 : vec3<f32>) -> vec2<f32>
{
    var _S110 : f32 = cell_6.y;
    var _S111 : f32 = floor(_S110);
    var _S112 : u32 = u32(i32(cell_6.x)) * u32(65536) + u32(i32(_S111));
    var _S113 : u32 = hash_bits_0(key_2, _S112);
    var _S114 : u32 = hash_bits_0(key_2, _S112 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S113), signed_noise_0((_S113 >> (u32(16))))), vec2<f32>(signed_noise_0(_S114), signed_noise_0((_S114 >> (u32(16))))), vec2<f32>(smooth_share_0(_S110 - _S111)));
}

fn uniform_hash_0( thread_9 : u32,  cell_7 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_9, stream_1), cell_7)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_2 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_2 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_0 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S115 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_0, max(min(min(_S115.x, _S115.y), _S115.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S116 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S116.x, _S116.y), _S116.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn natural_logarithm_0( x_4 : f32) -> f32
{
    var _S117 : u32 = (bitcast<u32>((x_4)));
    var exponent_0 : f32 = f32(i32((_S117 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S117 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var exponent_1 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var exponent_2 : f32 = exponent_0 - 1.0f;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var _S118 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S118 - exponent_1 * 0.00021219444170129f - 0.5f * _S118) + exponent_1 * 0.693359375f;
}

fn fibre_gain_0( thread_11 : u32,  cell_8 : u32,  amount_1 : f32,  seed_3 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, (seed_3 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_3 : vec3<f32>,
     tangent_3 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S119 : vec3<f32>;
    if((dot(frame_0.tangent_3, hair_0.tangent_0)) < 0.0f)
    {
        _S119 = (vec3<f32>(0) - hair_0.tangent_0);
    }
    else
    {
        _S119 = hair_0.tangent_0;
    }
    var blended_0 : YarnFrame_0;
    var _S120 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S121 : vec3<f32> = normalize(mix(frame_0.normal_3, hair_0.normal_0, _S120));
    blended_0.normal_3 = _S121;
    var _S122 : vec3<f32> = mix(frame_0.tangent_3, _S119, _S120);
    var _S123 : vec3<f32> = _S122 - vec3<f32>(dot(_S122, _S121)) * _S121;
    blended_0.tangent_3 = _S123 * vec3<f32>(rsqrt_0(max(dot(_S123, _S123), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_3.z - 1.0f) + 1.0f));
}

struct FaceRadiance_0
{
     warp_2 : vec3<f32>,
     weft_2 : vec3<f32>,
     mean_0 : vec3<f32>,
     leaked_0 : vec3<f32>,
};

struct FaceSends_0
{
     sky_warp_0 : vec3<f32>,
     sky_weft_0 : vec3<f32>,
     crossing_warp_0 : vec3<f32>,
     crossing_weft_0 : vec3<f32>,
     open_0 : f32,
     blocks_warp_0 : f32,
     blocks_weft_0 : f32,
};

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_0 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S124 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S125 : vec3<f32> = sends_0.sky_warp_0 + _S124 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S125;
    var _S126 : vec3<f32> = sends_0.sky_weft_0 + _S124 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S126;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S125 + vec3<f32>(sends_0.blocks_weft_0) * _S126;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

struct Scattered_0
{
     back_5 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_3 : vec3<f32>,
     weft_3 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S127 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S128 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S128 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S128 * interior_0.far_1 + yarn_2.back_5 * _S127;
    return bounced_0;
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_4 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S129 : f32 = light_1.z;
    if(_S129 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S129, 0.0f), max(dot(light_1, normal_4), 0.0f), blend_1);
}

fn projected_area_1( direction_2 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S130 : f32 = dot(direction_2, tangent_4);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S130 * _S130 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S131 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S132 : f32 = floor(_S131 * 1.4426950216293335f + 0.5f);
    var _S133 : f32 = _S131 - _S132 * 0.693359375f + _S132 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S133 + 0.00139819993637502f) * _S133 + 0.00833345204591751f) * _S133 + 0.04166579619050026f) * _S133 + 0.1666666567325592f) * _S133 + 0.5f;
    var _S134 : f32 = (bitcast<f32>(((u32(i32(_S132) + i32(127)) << (u32(23))))));
    var _S135 : f32;
    if(x_5 < -87.0f)
    {
        _S135 = 0.0f;
    }
    else
    {
        _S135 = (p_0 * _S133 * _S133 + _S133 + 1.0f) * _S134;
    }
    return _S135;
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn square_1( v_0 : vec3<f32>) -> f32
{
    return dot(v_0, v_0);
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S136 : f32 = roughness_2 * roughness_2;
    var _S137 : f32 = squared_along_0 * (1.0f - _S136) + _S136;
    return 0.31830987334251404f * _S136 * roughness_2 / (_S137 * _S137);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S138 : vec3<f32> = light_2 + view_1;
    var _S139 : f32 = dot(_S138, tangent_5);
    return flake_density_0(min(_S139 * _S139 / max(square_1(_S138), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_5 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S140 : f32 = dot(light_3, normal_5);
    var _S141 : bool;
    if(_S140 <= 0.0f)
    {
        _S141 = true;
    }
    else
    {
        _S141 = (dot(view_2, normal_5)) <= 0.0f;
    }
    if(_S141)
    {
        return 0.0f;
    }
    var _S142 : f32 = max(_S140, 9.99999997475242708e-07f);
    var _S143 : f32 = max(dot(view_2, normal_5), 9.99999997475242708e-07f);
    var _S144 : f32 = projected_area_1(light_3, tangent_6, roughness_4) * _S143 + projected_area_1(view_2, tangent_6, roughness_4) * _S142;
    var _S145 : f32 = optical_depth_1 * _S144 / (_S142 * _S143);
    return 0.25f * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S145 * mean_attenuation_0(_S145)) * _S142 / _S144;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S146 : f32 = - dot(light_4, normal_6);
    var _S147 : f32 = dot(view_3, normal_6);
    var _S148 : bool;
    if(_S146 <= 0.0f)
    {
        _S148 = true;
    }
    else
    {
        _S148 = _S147 <= 0.0f;
    }
    if(_S148)
    {
        return 0.0f;
    }
    var _S149 : f32 = 1.0f / max(_S147, 9.99999997475242708e-07f);
    var _S150 : f32 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S146, 9.99999997475242708e-07f);
    var _S151 : f32 = projected_area_1(view_3, tangent_7, roughness_5) * _S149;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S150, _S151)) * mean_attenuation_0(optical_depth_2 * abs(_S150 - _S151)) * _S149;
}

fn sheen_scale_0( x_6 : f32,  y_0 : f32) -> f32
{
    return (((((0.0f * x_6 + (((((-1.1402510404586792f * y_0 + 0.40672621130943298f) * y_0 + 1.65398800373077393f) * y_0 + -1.29730904102325439f) * y_0 + 0.30570998787879944f) * y_0 + -0.0220868494361639f)) * x_6 + (((((-0.21142719686031342f * y_0 + 1.05947399139404297f) * y_0 + -0.41116121411323547f) * y_0 + -0.93859231472015381f) * y_0 + 0.51606941223144531f) * y_0 + 0.05409301072359085f)) * x_6 + (((((1.22944498062133789f * y_0 + -0.45962560176849365f) * y_0 + -1.63861405849456787f) * y_0 + 1.33565104007720947f) * y_0 + -0.45725581049919128f) * y_0 + 0.08243165910243988f)) * x_6 + (((((0.39779931306838989f * y_0 + -1.18879103660583496f) * y_0 + 0.28251591324806213f) * y_0 + 1.168984055519104f) * y_0 + -0.76864629983901978f) * y_0 + 0.0091691892594099f)) * x_6 + (((((-0.26563560962677002f * y_0 + -0.19379159808158875f) * y_0 + 0.2677634060382843f) * y_0 + 0.00270519289188087f) * y_0 + 0.14349560439586639f) * y_0 + 0.10290180146694183f)) * x_6 + (((((-0.20701569318771362f * y_0 + 0.24526430666446686f) * y_0 + 0.19551840424537659f) * y_0 + 0.07586126774549484f) * y_0 + 0.38894739747047424f) * y_0 + 0.15043120086193085f);
}

fn sheen_shear_0( x_7 : f32,  y_1 : f32) -> f32
{
    return ((((0.0f * x_7 + (((((-0.10608240216970444f * y_1 + 1.99214303493499756f) * y_1 + -1.42255294322967529f) * y_1 + -1.09495604038238525f) * y_1 + 0.59180057048797607f) * y_1 + 0.06902855634689331f)) * x_7 + (((((-0.46220690011978149f * y_1 + -0.29113379120826721f) * y_1 + 1.39025199413299561f) * y_1 + 0.35589990019798279f) * y_1 + -1.17120099067687988f) * y_1 + 0.15940259397029877f)) * x_7 + (((((2.26068711280822754f * y_1 + -3.64728999137878418f) * y_1 + -0.72173482179641724f) * y_1 + 3.07659196853637695f) * y_1 + -0.6827620267868042f) * y_1 + -0.3039557933807373f)) * x_7 + (((((0.81201767921447754f * y_1 + 0.36014080047607422f) * y_1 + -1.72646903991699219f) * y_1 + -0.22630110383033752f) * y_1 + 0.89514690637588501f) * y_1 + -0.10397960245609283f)) * x_7 + (((((-0.37648698687553406f * y_1 + 1.10974001884460449f) * y_1 + 0.17824520170688629f) * y_1 + -1.04968702793121338f) * y_1 + 0.1461234986782074f) * y_1 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_8 : f32,  y_2 : f32) -> f32
{
    return ((((0.0f * x_8 + (((((12.95646953582763672f * y_2 + -21.38032913208007812f) * y_2 + -7.37853097915649414f) * y_2 + 34.55607986450195312f) * y_2 + -23.61347007751464844f) * y_2 + 5.00126314163208008f)) * x_8 + (((((10.91487026214599609f * y_2 + -6.08202791213989258f) * y_2 + -38.2036285400390625f) * y_2 + 53.3440399169921875f) * y_2 + -21.91996002197265625f) * y_2 + 2.01606011390686035f)) * x_8 + (((((-14.52206039428710938f * y_2 + 36.803619384765625f) * y_2 + -22.94047927856445312f) * y_2 + -10.07973003387451172f) * y_2 + 15.77003955841064453f) * y_2 + -4.92722177505493164f)) * x_8 + (((((-7.62505722045898438f * y_2 + 1.27310299873352051f) * y_2 + 31.19523048400878906f) * y_2 + -44.39989852905273438f) * y_2 + 26.44947052001953125f) * y_2 + -8.73507976531982422f)) * x_8 + (((((5.65633487701416016f * y_2 + -17.66820907592773438f) * y_2 + 24.65356063842773438f) * y_2 + -19.38941001892089844f) * y_2 + 11.06159019470214844f) * y_2 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_6 : f32) -> vec3<f32>
{
    var _S152 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S153 : f32 = 2.0f * sqrt(_S152) - 1.0f;
    var _S154 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S153, _S154), 0.00999999977648258f, 1.0f), clamp((1.0f - _S152) * sheen_shear_0(_S153, _S154), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S153, _S154), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S155 : f32 = light_5.z;
    var _S156 : bool;
    if(_S155 <= 0.0f)
    {
        _S156 = true;
    }
    else
    {
        _S156 = (view_4.z) <= 0.0f;
    }
    if(_S156)
    {
        return 0.0f;
    }
    var _S157 : vec2<f32> = view_4.xy;
    var _S158 : f32 = dot(_S157, _S157);
    var _S159 : vec2<f32>;
    if(_S158 > 9.99999968265522539e-21f)
    {
        _S159 = _S157 * vec2<f32>(rsqrt_0(_S158));
    }
    else
    {
        _S159 = vec2<f32>(1.0f, 0.0f);
    }
    var _S160 : f32 = scale_0 * dot(light_5.xy, _S159) + shear_0 * _S155;
    var _S161 : f32 = scale_0 * (light_5.y * _S159.x - light_5.x * _S159.y);
    var _S162 : f32 = _S160 * _S160 + _S161 * _S161 + _S155 * _S155;
    return 0.31830987334251404f * scale_0 * scale_0 * _S155 / max(_S162 * _S162, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S163 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S164 : f32 = strength_0 * _S163.z;
    return vec2<f32>(_S164 * transformed_cosine_0(light_6, view_5, _S163.x, _S163.y), 1.0f - _S164);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S165 : f32 = light_7.z;
    var _S166 : vec3<f32>;
    if((_S165 * view_6.z) < 0.0f)
    {
        _S166 = bounced_1.transmitted_0;
    }
    else
    {
        _S166 = bounced_1.reflected_0;
    }
    return _S166 * vec3<f32>((abs(_S165) * 0.31830987334251404f));
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_3 : bool,
     is_warp_2 : bool,
     x_9 : f32,
     y_3 : f32,
     height_4 : f32,
     normal_7 : vec3<f32>,
     tangent_8 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_8 : f32,
     albedos_1 : Albedos_0,
};

struct Hit_0
{
     x_10 : f32,
     y_4 : f32,
     hole_4 : bool,
     height_5 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_6 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S167 : u32,  _S168 : f32,  _S169 : f32,  _S170 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S167].warp_0, _S168);
    crossing_2.weft_1 = locate_0(fabrics_0[_S167].weft_0, _S169);
    var _S171 : u32 = fabrics_0[_S167].run_words_0 + u32(2) * (crossing_2.weft_1.thread_0 * fabrics_0[_S167].ends_1 + crossing_2.warp_1.thread_0);
    var _S172 : u32 = words_0[_S171];
    crossing_2.warp_word_0 = _S172;
    crossing_2.weft_word_0 = words_0[_S171 + u32(1)];
    crossing_2.warp_above_0 = (((_S172 & (u32(1)))) == u32(1)) != _S170;
    return crossing_2;
}

fn sample_at_0( _S173 : u32,  _S174 : f32,  _S175 : f32,  _S176 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S177 : Crossing_0 = crossing_at_0(_S173, _S174, _S175, _S176);
    sample_0.crossing_1 = _S177;
    var _S178 : Shown_0 = shown_at_0(_S177, _S176);
    sample_0.shown_3 = _S178;
    var _S179 : u32;
    if(_S178.is_warp_0)
    {
        _S179 = fabrics_0[_S173].warp_0;
    }
    else
    {
        _S179 = fabrics_0[_S173].weft_0;
    }
    var _S180 : u32;
    if(_S178.is_warp_0)
    {
        _S180 = fabrics_0[_S173].weft_0;
    }
    else
    {
        _S180 = fabrics_0[_S173].warp_0;
    }
    var _S181 : Cell_0 = select_cell_0(_S178.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S182 : Cell_0 = select_cell_0(_S178.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S183 : Run_0 = unpack_0(_S179, _S180, _S181.thread_0, _S182, _S178.word_0);
    var _S184 : Section_0 = section_at_0(_S181);
    var _S185 : bool;
    if(_S178.on_top_0)
    {
        _S185 = (_S183.distance_0) < (_S184.drop_0 * _S183.bend_1.sine_0);
    }
    else
    {
        _S185 = false;
    }
    var _S186 : bool;
    if(_S178.on_top_0)
    {
        _S186 = !_S185;
    }
    else
    {
        _S186 = false;
    }
    var _S187 : f32;
    if(_S186)
    {
        _S187 = 1.0f;
    }
    else
    {
        _S187 = -1.0f;
    }
    var _S188 : f32;
    if(_S185)
    {
        _S188 = _S183.other_reach_0;
    }
    else
    {
        _S188 = _S183.reach_0;
    }
    var _S189 : f32;
    if(_S185)
    {
        _S189 = _S188 + _S183.distance_0;
    }
    else
    {
        _S189 = max(_S188 - _S183.distance_0, 0.0f);
    }
    var _S190 : f32 = _S188 / _S183.bend_1.sine_0 - _S187 * _S184.drop_0;
    var _S191 : f32 = _S189 * _S189;
    var _S192 : f32 = max(_S190 * _S190 - _S191, 9.99999968265522539e-21f);
    var _S193 : f32 = rsqrt_0(_S192);
    var _S194 : f32 = _S191 / (_S192 * _S193 + _S190);
    var _S195 : bool = _S189 > 0.0f;
    var _S196 : f32;
    if(_S178.on_top_0)
    {
        _S196 = 1.0f;
    }
    else
    {
        _S196 = -1.0f;
    }
    var _S197 : f32;
    if(_S183.near_start_0)
    {
        _S197 = 1.0f;
    }
    else
    {
        _S197 = -1.0f;
    }
    var _S198 : f32 = _S196 * _S197;
    if(_S195)
    {
        _S196 = _S190 * _S193;
    }
    else
    {
        _S196 = 1.0f;
    }
    sample_0.slope_across_0 = _S184.slope_0 * _S196;
    if(_S195)
    {
        _S189 = _S198 * _S189 * _S193;
    }
    else
    {
        _S189 = 0.0f;
    }
    sample_0.slope_along_0 = _S189;
    var _S199 : f32 = families_0[_S179].height_scale_0;
    var _S200 : vec2<f32> = dive_0(_S180, _S178, _S183, _S182);
    if(_S183.straight_0)
    {
        _S187 = 0.0f;
    }
    else
    {
        _S187 = _S199 * _S187;
    }
    sample_0.height_6 = _S187 * (_S188 * _S183.bend_1.half_tangent_0 - _S194) - _S199 * _S184.drop_0 - _S200.x;
    var _S201 : f32 = _S199 * sample_0.slope_across_0;
    var _S202 : f32 = _S199 * sample_0.slope_along_0 - _S200.y;
    if(_S178.is_warp_0)
    {
        _S187 = _S201;
    }
    else
    {
        _S187 = _S202;
    }
    sample_0.slope_x_1 = _S187;
    if(_S178.is_warp_0)
    {
        _S187 = _S202;
    }
    else
    {
        _S187 = _S201;
    }
    sample_0.slope_y_1 = _S187;
    sample_0.run_3 = _S183;
    sample_0.section_1 = _S184;
    return sample_0;
}

fn steps_per_length_0( _S203 : u32,  _S204 : SearchQuality_0,  _S205 : vec3<f32>) -> f32
{
    return max(max(abs(_S205.x) * fabrics_0[_S203].threads_per_x_0, abs(_S205.y) * fabrics_0[_S203].threads_per_y_0) * _S204.steps_per_thread_0, abs(_S205.z) * fabrics_0[_S203].per_relief_0 * _S204.steps_per_relief_0);
}

fn cell_maximum_0( _S206 : u32,  _S207 : Crossing_0) -> f32
{
    var _S208 : u32;
    if(_S207.warp_above_0)
    {
        _S208 = fabrics_0[_S206].warp_0;
    }
    else
    {
        _S208 = fabrics_0[_S206].weft_0;
    }
    var _S209 : u32;
    if(_S207.warp_above_0)
    {
        _S209 = _S207.warp_word_0;
    }
    else
    {
        _S209 = _S207.weft_word_0;
    }
    return f32((_S209 >> (u32(28)))) * families_0[_S208].height_scale_0 * families_0[_S208].level_0;
}

fn probe_0( _S210 : u32,  _S211 : f32,  _S212 : f32,  _S213 : bool,  _S214 : bool,  _S215 : bool) -> Probe_0
{
    var _S216 : Sample_0 = sample_at_0(_S210, _S211, _S212, _S213);
    var probe_1 : Probe_0;
    probe_1.height_1 = _S216.height_6;
    probe_1.hole_1 = _S216.shown_3.hole_0;
    probe_1.slope_x_0 = _S216.slope_x_1;
    probe_1.slope_y_0 = _S216.slope_y_1;
    var _S217 : u32;
    if(_S216.shown_3.is_warp_0)
    {
        _S217 = _S216.crossing_1.warp_1.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S217 = _S216.crossing_1.weft_1.thread_0 * u32(2);
    }
    probe_1.yarn_1 = _S217;
    probe_1.cell_max_0 = cell_maximum_0(_S210, _S216.crossing_1);
    var _S218 : f32;
    if(_S214)
    {
        _S218 = _S216.crossing_1.warp_1.above_0;
    }
    else
    {
        _S218 = _S216.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S218;
    if(_S215)
    {
        _S218 = _S216.crossing_1.weft_1.above_0;
    }
    else
    {
        _S218 = _S216.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S218;
    probe_1.edge_x_0 = outline_distance_0(_S216.crossing_1.warp_1, _S216.shown_3, _S216.run_3, !_S216.shown_3.is_warp_0, _S214);
    probe_1.edge_y_0 = outline_distance_0(_S216.crossing_1.weft_1, _S216.shown_3, _S216.run_3, _S216.shown_3.is_warp_0, _S215);
    return probe_1;
}

fn is_free_0( _S219 : u32,  _S220 : SearchQuality_0,  _S221 : vec3<f32>,  _S222 : vec3<f32>,  _S223 : bool,  _S224 : f32) -> bool
{
    var _S225 : f32 = _S222.z;
    if(_S225 <= 0.0f)
    {
        return false;
    }
    var _S226 : f32 = 1.0f / max(_S220.shadow_share_0 * steps_per_length_0(_S219, _S220, _S222), 9.99999971718068537e-10f);
    var _S227 : StepControl_0 = step_control_0(_S222.xy, _S226);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_1 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S228 : bool;
        if(count_1 < u32(1024))
        {
            _S228 = (_S221.z + _S225 * distance_1) < _S224;
        }
        else
        {
            _S228 = false;
        }
        if(_S228)
        {
        }
        else
        {
            break;
        }
        var _S229 : vec3<f32> = _S221 + _S222 * vec3<f32>(distance_1);
        var _S230 : Probe_0 = probe_0(_S219, _S229.x, _S229.y, _S223, _S227.right_0, _S227.up_0);
        var _S231 : f32 = _S229.z;
        var _S232 : f32 = _S231 - _S230.height_1;
        var _S233 : f32 = _S225 - _S230.slope_x_0 * _S222.x - _S230.slope_y_0 * _S222.y;
        var _S234 : bool;
        if(!_S230.hole_1)
        {
            _S234 = _S232 < 0.0f;
        }
        else
        {
            _S234 = false;
        }
        if(_S234)
        {
            return false;
        }
        var _S235 : f32 = way_back_to_dip_0(previous_3, _S232, _S233, last_step_0, _S230);
        if(_S235 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S235;
            distance_1 = distance_1 - _S235;
            last_step_0 = last_step_1;
            count_1 = count_1 + u32(1);
            continue;
        }
        var _S236 : bool = _S231 > (_S230.cell_max_0);
        var _S237 : PreviousSample_0 = after_sample_0(_S232, _S233, _S230, _S236);
        var last_step_2 : f32;
        if(_S236)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S227, _S230.side_x_0, _S230.side_y_0), _S226);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S227, _S230, _S232, _S233);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S237;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + u32(1);
    }
    return true;
}

fn passes_through_0( _S238 : u32,  _S239 : SearchQuality_0,  _S240 : f32,  _S241 : f32,  _S242 : vec3<f32>,  _S243 : bool) -> bool
{
    if(!sample_at_0(_S238, _S240, _S241, _S243).shown_3.hole_0)
    {
        return false;
    }
    var _S244 : vec3<f32> = vec3<f32>(_S240, _S241, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S245 : bool;
        if(side_0 < u32(2))
        {
            _S245 = passes_0;
        }
        else
        {
            _S245 = false;
        }
        if(_S245)
        {
        }
        else
        {
            break;
        }
        var _S246 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S246 = _S242;
        }
        else
        {
            _S246 = vec3<f32>(- _S242.x, - _S242.y, _S242.z);
        }
        var _S247 : bool = is_free_0(_S238, _S239, _S244, _S246, _S243 != (side_0 == u32(1)), fabrics_0[_S238].height_high_0);
        var _S248 : u32 = side_0 + u32(1);
        passes_0 = _S247;
        side_0 = _S248;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_7 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S249 : u32,  _S250 : f32,  _S251 : f32,  _S252 : f32,  _S253 : vec3<f32>,  _S254 : bool) -> f32
{
    var _S255 : u32 = locate_0(fabrics_0[_S249].warp_0, _S250).thread_0 / u32(2);
    var _S256 : u32 = locate_0(fabrics_0[_S249].weft_0, _S251).thread_0 / u32(2);
    var _S257 : f32 = _S253.x;
    var _S258 : u32;
    if(_S257 > 0.0f)
    {
        _S258 = u32(1);
    }
    else
    {
        _S258 = u32(0);
    }
    var _S259 : f32 = _S253.y;
    var _S260 : u32;
    if(_S259 > 0.0f)
    {
        _S260 = u32(2);
    }
    else
    {
        _S260 = u32(0);
    }
    var _S261 : u32 = words_0[fabrics_0[_S249].max_heights_0 + u32(4) * (_S256 * fabrics_0[_S249].max_height_columns_0 + _S255) + (_S258 + _S260)];
    var number_0 : i32;
    if(_S254)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S262 : u32 = (_S261 >> (u32(number_0)));
    var _S263 : f32 = max(abs(_S257) * fabrics_0[_S249].threads_per_x_0, abs(_S259) * fabrics_0[_S249].threads_per_y_0) / _S253.z;
    var _S264 : f32 = fabrics_0[_S249].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S249].height_high_0;
    number_0 = i32(3);
    for(;;)
    {
        if(number_0 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S252) * _S263) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S262 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S264);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S265 : u32,  _S266 : f32,  _S267 : f32,  _S268 : bool,  _S269 : bool,  _S270 : bool) -> vec3<f32>
{
    var _S271 : Crossing_0 = crossing_at_0(_S265, _S266, _S267, _S268);
    var _S272 : f32 = cell_maximum_0(_S265, _S271);
    var _S273 : f32;
    if(_S269)
    {
        _S273 = _S271.warp_1.above_0;
    }
    else
    {
        _S273 = _S271.warp_1.below_0;
    }
    var _S274 : f32;
    if(_S270)
    {
        _S274 = _S271.weft_1.above_0;
    }
    else
    {
        _S274 = _S271.weft_1.below_0;
    }
    return vec3<f32>(_S272, _S273, _S274);
}

fn first_sample_height_0( _S275 : u32,  _S276 : ViewRay_0,  _S277 : StepControl_0,  _S278 : bool) -> f32
{
    var _S279 : f32 = max_height_along_0(_S275, _S276.origin_0.x, _S276.origin_0.y, 0.0f, vec3<f32>(_S276.slope_1, 1.0f), _S278);
    var count_2 : u32 = u32(0);
    var height_8 : f32 = _S279;
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S280 : vec2<f32> = ViewRay_at_0(_S276, height_8);
        var _S281 : vec3<f32> = cell_bounds_0(_S275, _S280.x, _S280.y, _S278, _S277.right_0, _S277.up_0);
        var _S282 : f32 = height_8 - _S281.x;
        var _S283 : f32 = StepControl_to_cell_exit_0(_S277, _S281.y, _S281.z);
        var height_9 : f32 = height_8 - clamp(_S282, 0.0f, _S283);
        if(_S282 <= _S283)
        {
            height_8 = height_9;
            break;
        }
        count_2 = count_2 + u32(1);
        height_8 = height_9;
    }
    return height_8;
}

fn search_down_0( _S284 : u32,  _S285 : ViewRay_0,  _S286 : StepControl_0,  _S287 : bool) -> ViewRayEnd_0
{
    var _S288 : f32 = fabrics_0[_S284].height_low_0 - (fabrics_0[_S284].height_high_0 - fabrics_0[_S284].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_7 = first_sample_height_0(_S284, _S285, _S286, _S287);
    end_1.last_step_3 = _S286.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_3 : u32 = u32(0);
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S289 : vec2<f32> = ViewRay_at_0(_S285, end_1.height_7);
        var _S290 : Probe_0 = probe_0(_S284, _S289.x, _S289.y, _S287, _S286.right_0, _S286.up_0);
        var _S291 : f32 = end_1.height_7 - _S290.height_1;
        var _S292 : f32 = ViewRay_rate_0(_S285, _S290);
        end_1.depth_1 = - _S291;
        end_1.rate_4 = _S292;
        var _S293 : bool;
        if(end_1.previous_4.known_0)
        {
            _S293 = !_S290.hole_1;
        }
        else
        {
            _S293 = false;
        }
        var _S294 : bool;
        if(_S293)
        {
            _S294 = (end_1.previous_4.yarn_0) == (_S290.yarn_1);
        }
        else
        {
            _S294 = false;
        }
        end_1.smooth_0 = _S294;
        var _S295 : bool;
        if(!_S290.hole_1)
        {
            _S295 = _S291 <= 0.0f;
        }
        else
        {
            _S295 = false;
        }
        var _S296 : bool;
        if(_S295)
        {
            _S296 = true;
        }
        else
        {
            _S296 = (end_1.height_7) <= _S288;
        }
        if(_S296)
        {
            break;
        }
        var _S297 : f32 = way_back_to_dip_0(end_1.previous_4, _S291, _S292, end_1.last_step_3, _S290);
        if(_S297 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S297;
            end_1.last_step_3 = end_1.last_step_3 - _S297;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S298 : f32 = min(StepControl_to_cell_exit_0(_S286, _S290.side_x_0, _S290.side_y_0), end_1.height_7 - _S290.cell_max_0);
        var _S299 : f32 = StepControl_to_next_sample_0(_S286, _S290, _S291, _S292);
        end_1.previous_4 = after_sample_0(_S291, _S292, _S290, _S298 > _S299);
        var _S300 : f32 = max(_S298, _S299);
        end_1.last_step_3 = _S300;
        end_1.height_7 = end_1.height_7 - _S300;
        count_3 = count_3 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S301 : u32,  _S302 : ViewRay_0,  _S303 : StepControl_0,  _S304 : bool,  _S305 : ViewRayEnd_0,  _S306 : u32) -> f32
{
    var _S307 : f32 = fabrics_0[_S301].height_high_0 - fabrics_0[_S301].height_low_0;
    var above_2 : f32 = _S305.height_7 + _S305.last_step_3;
    var above_gap_1 : f32 = clamp(_S305.previous_4.clearance_0, 0.0f, _S307);
    var under_gap_1 : f32 = clamp(_S305.depth_1, 0.0f, _S307);
    var _S308 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S305.previous_4.rate_0 * _S305.last_step_3, _S305.rate_4 * _S305.last_step_3);
    var middle_0 : f32;
    if(_S305.smooth_0)
    {
        middle_0 = above_2 - _S308 * _S305.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S305.height_7, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S305.height_7;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S306)
        {
        }
        else
        {
            break;
        }
        var _S309 : vec2<f32> = ViewRay_at_0(_S302, middle_0);
        var _S310 : Probe_0 = probe_0(_S301, _S309.x, _S309.y, _S304, _S303.right_0, _S303.up_0);
        var _S311 : f32;
        if(_S310.hole_1)
        {
            _S311 = -1.0e+09f;
        }
        else
        {
            _S311 = _S310.height_1;
        }
        var _S312 : f32 = clamp(middle_0 - _S311, - _S307, _S307);
        var _S313 : f32;
        if(_S312 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S313 = 0.5f * above_gap_2;
            }
            else
            {
                _S313 = above_gap_2;
            }
            var _S314 : f32 = - _S312;
            under_1 = middle_0;
            above_gap_2 = _S313;
            under_gap_2 = _S314;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S313 = 0.5f * under_gap_2;
            }
            else
            {
                _S313 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S312;
            under_gap_2 = _S313;
            side_1 = -1.0f;
        }
        if(_S305.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S312 / min(ViewRay_rate_0(_S302, _S310), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S305.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S315 : u32,  _S316 : SearchQuality_0,  _S317 : f32,  _S318 : f32,  _S319 : vec3<f32>,  _S320 : bool) -> Hit_0
{
    var _S321 : f32 = max(_S319.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S317, _S318);
    var _S322 : vec2<f32> = _S319.xy / vec2<f32>(_S321);
    ray_0.slope_1 = _S322;
    var _S323 : StepControl_0 = step_control_0((vec2<f32>(0) - _S322), 1.0f / max(steps_per_length_0(_S315, _S316, _S319) / _S321, 9.99999971718068537e-10f));
    var _S324 : ViewRayEnd_0 = search_down_0(_S315, ray_0, _S323, _S320);
    var hit_0 : Hit_0;
    hit_0.hole_4 = false;
    var _S325 : f32 = refined_height_0(_S315, ray_0, _S323, _S320, _S324, _S316.refinements_0);
    hit_0.height_5 = _S325;
    var _S326 : vec2<f32> = ViewRay_at_0(ray_0, _S325);
    hit_0.x_10 = _S326.x;
    hit_0.y_4 = _S326.y;
    return hit_0;
}

fn first_hit_0( _S327 : u32,  _S328 : SearchQuality_0,  _S329 : f32,  _S330 : f32,  _S331 : vec3<f32>,  _S332 : bool) -> Hit_0
{
    if(!passes_through_0(_S327, _S328, _S329, _S330, _S331, _S332))
    {
        return first_hit_of_yarn_0(_S327, _S328, _S329, _S330, _S331, _S332);
    }
    var hit_1 : Hit_0;
    hit_1.x_10 = _S329;
    hit_1.y_4 = _S330;
    hit_1.height_5 = 0.0f;
    hit_1.hole_4 = true;
    return hit_1;
}

fn surface_at_0( _S333 : u32,  _S334 : f32,  _S335 : f32,  _S336 : bool) -> SurfacePoint_0
{
    var _S337 : Sample_0 = sample_at_0(_S333, _S334, _S335, _S336);
    var _S338 : f32;
    if(_S337.shown_3.is_warp_0)
    {
        _S338 = _S337.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S338 = _S337.crossing_1.weft_1.half_width_1;
    }
    var _S339 : u32;
    if(_S337.shown_3.is_warp_0)
    {
        _S339 = fabrics_0[_S333].warp_0;
    }
    else
    {
        _S339 = fabrics_0[_S333].weft_0;
    }
    var _S340 : f32 = families_0[_S339].twist_sine_0;
    var _S341 : f32;
    if(_S336)
    {
        _S341 = -1.0f;
    }
    else
    {
        _S341 = 1.0f;
    }
    var _S342 : f32 = _S340 * _S341;
    var _S343 : f32 = families_0[_S339].twist_cosine_0;
    if(_S337.shown_3.is_warp_0)
    {
        _S341 = 1.0f;
    }
    else
    {
        _S341 = -1.0f;
    }
    var _S344 : vec2<f32> = fibre_direction_0(_S337.slope_across_0, _S341 * _S337.slope_along_0, _S342, _S343);
    var _S345 : f32;
    if(_S337.shown_3.is_warp_0)
    {
        _S345 = _S337.slope_x_1;
    }
    else
    {
        _S345 = _S337.slope_y_1;
    }
    var _S346 : f32;
    if(_S337.shown_3.is_warp_0)
    {
        _S346 = _S337.slope_y_1;
    }
    else
    {
        _S346 = _S337.slope_x_1;
    }
    var _S347 : f32 = _S344.x;
    var _S348 : f32 = _S344.y;
    var _S349 : f32 = _S345 * _S347 + _S341 * _S346 * _S348;
    var _S350 : f32 = _S338 * 1.0154266357421875f;
    var _S351 : f32 = _S350 * arc_sine_0(clamp(_S337.section_1.across_1 / _S350, -1.0f, 1.0f));
    if(_S337.shown_3.is_warp_0)
    {
        _S338 = _S335;
    }
    else
    {
        _S338 = - _S334;
    }
    var point_1 : SurfacePoint_0;
    point_1.hole_2 = _S337.shown_3.hole_0;
    point_1.is_warp_1 = _S337.shown_3.is_warp_0;
    point_1.warp_thread_0 = _S337.crossing_1.warp_1.thread_0;
    point_1.weft_thread_0 = _S337.crossing_1.weft_1.thread_0;
    point_1.height_3 = _S337.height_6;
    point_1.normal_2 = normalize(vec3<f32>(- _S337.slope_x_1, - _S337.slope_y_1, 1.0f));
    var _S352 : vec3<f32>;
    if(_S337.shown_3.is_warp_0)
    {
        _S352 = vec3<f32>(_S347, _S348, _S349);
    }
    else
    {
        _S352 = vec3<f32>(- _S348, _S347, _S349);
    }
    point_1.tangent_2 = normalize(_S352);
    point_1.across_3 = _S337.section_1.across_1;
    point_1.fibre_across_0 = _S351 * _S343 + _S338 * _S342;
    point_1.fibre_along_0 = _S338 * _S343 - _S351 * _S342;
    return point_1;
}

fn has_hairs_0( _S353 : u32) -> bool
{
    var _S354 : bool;
    if((families_0[fabrics_0[_S353].warp_0].hairiness_0) > 0.0f)
    {
        _S354 = true;
    }
    else
    {
        _S354 = (families_0[fabrics_0[_S353].weft_0].hairiness_0) > 0.0f;
    }
    return _S354;
}

fn hair_at_0( _S355 : u32,  _S356 : vec2<f32>,  _S357 : bool,  _S358 : f32) -> Hair_0
{
    var _S359 : f32 = fabrics_0[_S355].fibre_size_0;
    var _S360 : f32 = 17.0f * fabrics_0[_S355].fibre_size_0;
    var _S361 : f32 = fade_0(_S358, _S360);
    var _S362 : vec2<f32> = _S356 / vec2<f32>(_S360);
    var number_1 : u32;
    if(_S357)
    {
        number_1 = u32(1);
    }
    else
    {
        number_1 = u32(0);
    }
    var _S363 : u32 = hash_key_0(number_1, ((fabrics_0[_S355].seed_1) ^ (u32(1013904242))));
    var _S364 : f32 = 1.0f / max(_S358, 0.07999999821186066f * _S359);
    var _S365 : f32 = min(0.63999998569488525f * _S359 * _S364, 1.0f);
    const _S366 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S366;
    number_1 = u32(0);
    for(;;)
    {
        var _S367 : bool;
        if(_S361 > 0.0f)
        {
            _S367 = number_1 < u32(18);
        }
        else
        {
            _S367 = false;
        }
        if(_S367)
        {
        }
        else
        {
            break;
        }
        var _S368 : u32 = number_1 / u32(9);
        var _S369 : u32 = number_1 / u32(3) - u32(3) * _S368;
        var _S370 : vec2<f32> = floor(_S362) + vec2<f32>(f32(number_1 - u32(3) * _S369 - u32(9) * _S368), f32(_S369)) - vec2<f32>(1.0f);
        var _S371 : u32 = hash_bits_0(_S363 + _S368, u32(i32(_S370.x)) * u32(65536) + u32(i32(_S370.y)));
        var _S372 : u32 = hash_bits_0(_S363, _S371);
        var _S373 : vec2<f32> = _S362 - _S370 - vec2<f32>(share_of_0(_S371), share_of_0((_S371 >> (u32(10)))));
        var _S374 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S371 >> (u32(20)))));
        var _S375 : f32 = mix(5.0f, 16.0f, share_of_0((_S372 >> (u32(10))))) / 17.0f;
        var _S376 : f32 = _S373.x;
        var _S377 : f32 = _S374.y;
        var _S378 : f32 = _S373.y;
        var _S379 : f32 = _S374.x;
        var _S380 : f32 = (_S376 * _S377 + _S378 * _S379) / _S375;
        var _S381 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S372 >> (u32(20)))) - 1.0f);
        var _S382 : f32 = 2.0f * _S381 * _S380;
        var _S383 : f32 = rsqrt_0(_S382 * _S382 + 1.0f);
        var _S384 : f32 = (_S378 * _S377 - _S376 * _S379 - _S381 * _S375 * _S380 * _S380) * _S383 * 17.0f;
        var _S385 : f32 = clamp((0.31999999284744263f - abs(_S384)) * _S359 * _S364 + 0.5f, 0.0f, _S365);
        var _S386 : u32;
        if(((((_S372 >> (u32(30)))) & (u32(1)))) == u32(1))
        {
            _S386 = fabrics_0[_S355].warp_0;
        }
        else
        {
            _S386 = fabrics_0[_S355].weft_0;
        }
        var _S387 : bool;
        if((share_of_0(_S372)) < (families_0[_S386].hairiness_0))
        {
            _S387 = (abs(_S380)) < 1.0f;
        }
        else
        {
            _S387 = false;
        }
        var _S388 : bool;
        if(_S387)
        {
            _S388 = _S385 > cover_2;
        }
        else
        {
            _S388 = false;
        }
        if(_S388)
        {
            var _S389 : vec2<f32> = vec2<f32>(- _S379 - _S382 * _S377, _S377 - _S382 * _S379) * vec2<f32>(_S383);
            cover_2 = _S385;
            hair_away_0 = _S384;
            hair_across_0 = _S389;
        }
        number_1 = number_1 + u32(1);
    }
    var _S390 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S361 * cover_2;
    hair_1.normal_0 = vec3<f32>(vec2<f32>(_S390) * hair_across_0, sqrt(1.0f - _S390 * _S390));
    hair_1.tangent_0 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S391 : u32,  _S392 : f32) -> bool
{
    var _S393 : bool;
    if((fabrics_0[_S391].fibre_noise_0) > 0.0f)
    {
        _S393 = true;
    }
    else
    {
        _S393 = (fabrics_0[_S391].colour_noise_0) > 0.0f;
    }
    if(_S393)
    {
        _S393 = true;
    }
    else
    {
        if((fabrics_0[_S391].has_detail_0) != u32(0))
        {
            _S393 = _S392 >= 0.0f;
        }
        else
        {
            _S393 = false;
        }
    }
    return _S393;
}

fn thread_number_0( _S394 : u32,  _S395 : SurfacePoint_0,  _S396 : f32,  _S397 : f32) -> u32
{
    var _S398 : f32;
    if(_S395.is_warp_1)
    {
        _S398 = _S396;
    }
    else
    {
        _S398 = _S397;
    }
    var _S399 : f32 = _S398 - _S395.across_3;
    var _S400 : u32;
    if(_S395.is_warp_1)
    {
        _S400 = fabrics_0[_S394].warp_0;
    }
    else
    {
        _S400 = fabrics_0[_S394].weft_0;
    }
    var _S401 : f32 = families_0[_S400].period_0;
    var _S402 : i32 = i32(families_0[_S400].count_0);
    if(_S395.is_warp_1)
    {
        _S400 = _S395.warp_thread_0;
    }
    else
    {
        _S400 = _S395.weft_thread_0;
    }
    var _S403 : u32 = u32(i32(floor(_S399 / _S401)) * _S402 + i32(_S400)) * u32(2);
    if(_S395.is_warp_1)
    {
        _S400 = u32(1);
    }
    else
    {
        _S400 = u32(0);
    }
    return _S403 + _S400;
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_2 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S404 : u32,  _S405 : u32,  _S406 : SurfacePoint_0,  _S407 : u32,  _S408 : f32) -> FibreNoise_0
{
    var _S409 : f32 = 5.0f * fabrics_0[_S404].fibre_size_0;
    var _S410 : vec2<f32> = wave_noise_0(hash_key_0(_S407, ((fabrics_0[_S404].seed_1) ^ (u32(458671337)))), _S406.fibre_along_0 / (25.0f * fabrics_0[_S404].fibre_size_0));
    var _S411 : f32 = _S406.fibre_across_0 + families_0[_S405].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S404].fibre_size_0 * _S410.x;
    var _S412 : vec3<f32> = fibre_cell_0(_S411, _S406.fibre_along_0, fabrics_0[_S404].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S407, ((fabrics_0[_S404].seed_1) ^ (u32(1757159915)))), fibre_cell_0(_S411, _S406.fibre_along_0, _S409));
    noise_0.bundle_weight_0 = fade_0(_S408, _S409);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S407, ((fabrics_0[_S404].seed_1) ^ (u32(48610963)))), _S412);
    noise_0.fibre_weight_0 = fade_0(_S408, fabrics_0[_S404].fibre_size_0);
    noise_0.offset_2 = _S412.z;
    noise_0.slope_2 = 0.5f * _S410.y;
    return noise_0;
}

fn detail_gain_0( _S413 : u32,  _S414 : u32,  _S415 : SurfacePoint_0,  _S416 : vec2<f32>,  _S417 : bool,  _S418 : u32,  _S419 : f32) -> vec2<f32>
{
    var _S420 : vec2<f32> = vec2<f32>(0.0f);
    var gain_1 : vec2<f32>;
    if((families_0[_S414].has_plies_0) > 0.0f)
    {
        gain_1 = vec2<f32>((0.60000002384185791f * fade_0(_S419, 1.0f / families_0[_S414].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_0(square_0(ply_offset_0(_S414, _S415, _S417))), 0.20000000298023224f);
    }
    else
    {
        gain_1 = _S420;
    }
    if((families_0[_S414].fibre_tone_0) > 0.0f)
    {
        var _S421 : FibreNoise_0 = fibre_noise_at_0(_S413, _S414, _S415, _S418, _S419);
        gain_1 = gain_1 + vec2<f32>(families_0[_S414].fibre_tone_0) * vec2<f32>(_S421.bundle_weight_0 * _S421.bundle_0.y + _S421.fibre_weight_0 * _S421.fibre_0.y, _S421.bundle_weight_0 + _S421.fibre_weight_0);
    }
    if((families_0[_S414].slub_0) > 0.0f)
    {
        var _S422 : f32 = 0.25f * families_0[_S414].slub_0 * fade_0(_S419, 1.0f / families_0[_S414].slubs_per_mm_0);
        var _S423 : f32;
        if(_S415.is_warp_1)
        {
            _S423 = _S416.y;
        }
        else
        {
            _S423 = - _S416.x;
        }
        gain_1 = gain_1 + vec2<f32>(_S422) * vec2<f32>(wave_noise_0(hash_key_0(_S418, ((fabrics_0[_S413].seed_1) ^ (u32(1373058189)))), _S423 * families_0[_S414].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_0(_S415.across_3 * families_0[_S414].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_1;
}

fn vary_albedos_0( _S424 : u32,  _S425 : Albedos_0,  _S426 : u32,  _S427 : u32,  _S428 : vec2<f32>) -> Albedos_0
{
    var _S429 : vec3<f32> = max(_S425.specular_reflect_0, _S425.specular_transmit_0);
    var _S430 : vec3<f32> = _S425.diffuse_reflect_0 + _S425.diffuse_transmit_0;
    var _S431 : vec3<f32> = vec3<f32>(fabrics_0[_S424].layer_bound_0);
    var _S432 : vec3<f32> = vec3<f32>(1.0f);
    var _S433 : vec3<f32> = _S432 - _S431 * _S429;
    var colour_0 : f32 = bounded_gain_0(thread_gain_0(_S426, fabrics_0[_S424].colour_noise_0, fabrics_0[_S424].seed_1), _S430, _S433);
    var _S434 : vec3<f32> = vec3<f32>((colour_0 * (1.0f + flattened_0(_S428.y, vec3<f32>(colour_0) * _S430, _S433) * _S428.x)));
    var _S435 : f32 = bounded_gain_0(fibre_gain_0(_S426, _S427, fabrics_0[_S424].fibre_noise_0, fabrics_0[_S424].seed_1), _S429, min((_S432 - _S434 * _S430) / _S431, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S434 * _S425.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S434 * _S425.diffuse_transmit_0;
    var _S436 : vec3<f32> = vec3<f32>(_S435);
    varied_0.specular_reflect_0 = _S436 * _S425.specular_reflect_0;
    varied_0.specular_transmit_0 = _S436 * _S425.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S437 : u32,  _S438 : SurfacePoint_0,  _S439 : Albedos_0,  _S440 : f32,  _S441 : f32,  _S442 : bool,  _S443 : f32,  _S444 : f32) -> Albedos_0
{
    var _S445 : u32 = thread_number_0(_S437, _S438, _S440, _S441);
    var _S446 : vec3<f32> = fibre_cell_0(_S438.fibre_across_0, _S438.fibre_along_0, fabrics_0[_S437].fibre_size_0);
    var _S447 : vec2<f32> = vec2<f32>(0.0f);
    var _S448 : bool;
    if((fabrics_0[_S437].has_detail_0) != u32(0))
    {
        _S448 = _S443 >= 0.0f;
    }
    else
    {
        _S448 = false;
    }
    var gain_2 : vec2<f32>;
    if(_S448)
    {
        var _S449 : u32;
        if(_S438.is_warp_1)
        {
            _S449 = fabrics_0[_S437].warp_0;
        }
        else
        {
            _S449 = fabrics_0[_S437].weft_0;
        }
        gain_2 = detail_gain_0(_S437, _S449, _S438, vec2<f32>(_S440, _S441), _S442, _S445, _S443) * vec2<f32>(1.0f - _S444, 1.0f);
    }
    else
    {
        gain_2 = _S447;
    }
    return vary_albedos_0(_S437, _S439, _S445, u32(i32(_S446.x)) * u32(65536) + u32(i32(floor(_S446.y))), gain_2);
}

fn turned_frame_0( _S450 : u32,  _S451 : u32,  _S452 : SurfacePoint_0,  _S453 : bool,  _S454 : u32,  _S455 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_3 = _S452.normal_2;
    frame_2.tangent_3 = _S452.tangent_2;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S451].has_plies_0) > 0.0f)
    {
        var _S456 : f32 = fade_0(_S455, 1.0f / families_0[_S451].plies_per_mm_0);
        var _S457 : f32 = _S456 * 0.41999998688697815f * ply_offset_0(_S451, _S452, _S453);
        var _S458 : f32 = sqrt(1.0f - _S457 * _S457);
        var _S459 : f32;
        if(_S453)
        {
            _S459 = - families_0[_S451].ply_sine_0;
        }
        else
        {
            _S459 = families_0[_S451].ply_sine_0;
        }
        var _S460 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_3);
        var _S461 : vec3<f32> = vec3<f32>(families_0[_S451].ply_cosine_0);
        var _S462 : vec3<f32> = _S461 * _S460 + vec3<f32>(_S459) * frame_2.tangent_3;
        var _S463 : vec3<f32> = vec3<f32>(_S458);
        var _S464 : vec3<f32> = vec3<f32>(_S457);
        frame_2.tangent_3 = _S461 * (_S461 * frame_2.tangent_3 - vec3<f32>(_S459) * _S460) + vec3<f32>(_S459) * (_S463 * _S462 - _S464 * frame_2.normal_3);
        frame_2.normal_3 = _S463 * frame_2.normal_3 + _S464 * _S462;
        frame_2.loss_0 = _S456 * _S456 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S465 : f32 = families_0[_S451].fibre_tilt_0;
    if((families_0[_S451].fibre_tilt_0) > 0.0f)
    {
        var _S466 : FibreNoise_0 = fibre_noise_at_0(_S450, _S451, _S452, _S454, _S455);
        var _S467 : f32 = 1.09858846664428711f * _S465 * (_S466.bundle_weight_0 * _S466.bundle_0.x + _S466.fibre_weight_0 * (_S466.fibre_0.x + _S466.offset_2));
        var _S468 : f32 = _S465 * (1.42099642753601074f * (_S466.bundle_weight_0 * _S466.bundle_0.y + _S466.fibre_weight_0 * _S466.fibre_0.y) - _S466.bundle_weight_0 * _S466.slope_2);
        var _S469 : f32 = square_0(_S466.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S465 * _S465 * ((0.24761904776096344f * (square_0(_S466.bundle_weight_0) + _S469) + _S469 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S470 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_3);
        var _S471 : vec2<f32> = sine_cosine_0(_S467);
        var _S472 : vec2<f32> = sine_cosine_0(_S468);
        var _S473 : vec3<f32> = vec3<f32>(_S471.y);
        var _S474 : vec3<f32> = vec3<f32>(_S471.x);
        var _S475 : vec3<f32> = _S473 * _S470 - _S474 * frame_2.normal_3;
        frame_2.normal_3 = _S473 * frame_2.normal_3 + _S474 * _S470;
        frame_2.tangent_3 = vec3<f32>(_S472.y) * frame_2.tangent_3 + vec3<f32>(_S472.x) * _S475;
    }
    return frame_2;
}

fn yarn_point_of_0( _S476 : u32,  _S477 : SurfacePoint_0,  _S478 : f32,  _S479 : f32,  _S480 : bool,  _S481 : bool,  _S482 : f32) -> YarnPoint_0
{
    var _S483 : u32;
    if(_S477.is_warp_1)
    {
        _S483 = fabrics_0[_S476].warp_0;
    }
    else
    {
        _S483 = fabrics_0[_S476].weft_0;
    }
    var _S484 : bool;
    if((fabrics_0[_S476].has_detail_0) != u32(0))
    {
        _S484 = _S482 >= 0.0f;
    }
    else
    {
        _S484 = false;
    }
    var _S485 : vec3<f32> = vec3<f32>(0.0f);
    var _S486 : Hair_0 = Hair_x24init_0(0.0f, _S485, _S485);
    var _S487 : bool;
    if(_S484)
    {
        _S487 = has_hairs_0(_S476);
    }
    else
    {
        _S487 = false;
    }
    var hair_2 : Hair_0;
    if(_S487)
    {
        hair_2 = hair_at_0(_S476, vec2<f32>(_S478, _S479), _S480, _S482);
    }
    else
    {
        hair_2 = _S486;
    }
    var _S488 : u32;
    if(_S477.is_warp_1)
    {
        _S488 = _S477.warp_thread_0;
    }
    else
    {
        _S488 = _S477.weft_thread_0;
    }
    var albedos_2 : Albedos_0 = albedos_of_0(_S483, _S488);
    var albedos_3 : Albedos_0;
    if(varies_at_0(_S476, _S482))
    {
        albedos_3 = varied_at_0(_S476, _S477, albedos_2, _S478, _S479, _S480, _S482, hair_2.cover_0);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    var point_2 : YarnPoint_0;
    point_2.back_6 = _S480;
    point_2.hole_3 = _S481;
    point_2.is_warp_2 = _S477.is_warp_1;
    point_2.x_9 = _S478;
    point_2.y_3 = _S479;
    point_2.height_4 = _S477.height_3;
    point_2.normal_7 = _S477.normal_2;
    point_2.tangent_8 = _S477.tangent_2;
    point_2.surface_normal_0 = _S477.normal_2;
    point_2.diffuse_gain_1 = 1.0f;
    if(_S484)
    {
        var _S489 : YarnFrame_0 = turned_frame_0(_S476, _S483, _S477, _S480, thread_number_0(_S476, _S477, _S478, _S479), _S482);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S476))
        {
            frame_3 = under_hair_0(_S489, hair_2);
        }
        else
        {
            frame_3 = _S489;
        }
        point_2.normal_7 = frame_3.normal_3;
        point_2.tangent_8 = frame_3.tangent_3;
        point_2.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S476].diffuse_blend_0);
    }
    point_2.roughness_8 = families_0[_S483].roughness_0;
    point_2.albedos_1 = albedos_3;
    return point_2;
}

fn locate_yarn_0( _S490 : u32,  _S491 : SearchQuality_0,  _S492 : f32,  _S493 : f32,  _S494 : vec3<f32>,  _S495 : f32) -> YarnPoint_0
{
    var _S496 : bool = (_S494.z) < 0.0f;
    var _S497 : Hit_0 = first_hit_0(_S490, _S491, _S492, _S493, to_face_frame_0(_S494, _S496), _S496);
    return yarn_point_of_0(_S490, surface_at_0(_S490, _S497.x_10, _S497.y_4, _S496), _S497.x_10, _S497.y_4, _S496, _S497.hole_4, _S495);
}

fn openness_number_0( _S498 : u32,  _S499 : u32) -> f32
{
    return table_number_0(fabrics_0[_S498].openness_0 + _S499);
}

fn blocked_of_terms_0( _S500 : u32,  _S501 : u32,  _S502 : array<f32, i32(6)>,  _S503 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_2 : u32 = u32(0);
    for(;;)
    {
        if(share_2 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_2] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S503)
            {
            }
            else
            {
                break;
            }
            shares_0[share_2] = shares_0[share_2] + openness_number_0(_S500, _S501 + share_2 * _S503 + term_0) * _S502[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_2] = saturate(shares_0[share_2]);
        share_2 = share_2 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_1.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_1.far_0 = shares_0[i32(1)];
    return blocked_1;
}

fn blocked_at_0( _S504 : u32,  _S505 : bool,  _S506 : bool,  _S507 : f32,  _S508 : f32) -> Blocked_0
{
    var _S509 : f32 = _S508 * openness_number_0(_S504, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S507, _S509, _S507 * _S507, _S507 * _S509, _S509 * _S509 );
    var _S510 : u32;
    if(_S506)
    {
        _S510 = u32(2);
    }
    else
    {
        _S510 = u32(0);
    }
    var _S511 : u32;
    if(_S505)
    {
        _S511 = u32(0);
    }
    else
    {
        _S511 = u32(1);
    }
    return blocked_of_terms_0(_S504, u32(60) + (_S510 + _S511) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S512 : u32,  _S513 : Albedos_0,  _S514 : u32,  _S515 : vec3<f32>) -> Scattered_0
{
    var _S516 : u32 = u32(159) + u32(2) * _S514;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S515 * _S513.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S512, _S516)) * _S513.specular_reflect_0;
    yarn_3.through_0 = _S515 * _S513.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S512, _S516 + u32(1))) * _S513.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S517 : u32,  _S518 : u32,  _S519 : vec3<f32>,  _S520 : vec3<f32>,  _S521 : vec3<f32>,  _S522 : vec3<f32>,  _S523 : ptr<function, vec3<f32>>,  _S524 : ptr<function, vec3<f32>>)
{
    var _S525 : u32 = u32(146) + u32(4) * _S518;
    var _S526 : f32 = openness_number_0(_S517, _S525 + u32(1));
    var _S527 : f32 = openness_number_0(_S517, _S525 + u32(2));
    var _S528 : vec3<f32> = vec3<f32>(1.0f);
    var _S529 : vec3<f32> = _S528 - _S521 * vec3<f32>(openness_number_0(_S517, _S525));
    var _S530 : vec3<f32> = _S528 - _S522 * vec3<f32>(openness_number_0(_S517, _S525 + u32(3)));
    var _S531 : vec3<f32> = _S528 / (_S529 * _S530 - _S521 * _S522 * vec3<f32>((_S526 * _S527)));
    (*_S523) = (_S519 * _S530 + _S521 * vec3<f32>(_S526) * _S520) * _S531;
    (*_S524) = (_S520 * _S529 + _S522 * vec3<f32>(_S527) * _S519) * _S531;
    return;
}

fn face_sends_0( _S532 : u32,  _S533 : u32,  _S534 : Scattered_0,  _S535 : Scattered_0) -> FaceSends_0
{
    var _S536 : u32 = u32(2) * _S533;
    var _S537 : u32 = u32(142) + _S536;
    var _S538 : f32 = openness_number_0(_S532, _S537);
    var _S539 : f32 = openness_number_0(_S532, _S537 + u32(1));
    var _S540 : vec3<f32> = vec3<f32>((1.0f - _S538)) * _S534.back_5;
    var _S541 : vec3<f32> = vec3<f32>((1.0f - _S539)) * _S535.back_5;
    var sends_1 : FaceSends_0;
    var _S542 : u32 = u32(154) + _S536;
    var _S543 : f32 = openness_number_0(_S532, _S542);
    sends_1.blocks_warp_0 = _S543;
    var _S544 : f32 = openness_number_0(_S532, _S542 + u32(1));
    sends_1.blocks_weft_0 = _S544;
    sends_1.open_0 = _S543 * _S538 + _S544 * _S539;
    var _S545 : vec3<f32> = vec3<f32>(_S538) * _S534.back_5;
    var _S546 : vec3<f32> = vec3<f32>(_S539) * _S535.back_5;
    var _S547 : vec3<f32> = sends_1.sky_warp_0;
    var _S548 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S532, _S533, _S545, _S546, _S540, _S541, &(_S547), &(_S548));
    sends_1.sky_warp_0 = _S547;
    sends_1.sky_weft_0 = _S548;
    var _S549 : vec3<f32> = sends_1.crossing_warp_0;
    var _S550 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S532, _S533, _S534.through_0, _S535.through_0, _S540, _S541, &(_S549), &(_S550));
    sends_1.crossing_warp_0 = _S549;
    sends_1.crossing_weft_0 = _S550;
    return sends_1;
}

fn interior_of_0( _S551 : u32,  _S552 : vec3<f32>,  _S553 : bool) -> Interior_0
{
    var _S554 : Scattered_0 = scattered_by_0(_S551, table_albedos_0(families_0[fabrics_0[_S551].warp_0].colour_mean_0), u32(0), _S552);
    var _S555 : Scattered_0 = scattered_by_0(_S551, table_albedos_0(families_0[fabrics_0[_S551].weft_0].colour_mean_0), u32(1), _S552);
    var _S556 : u32;
    if(_S553)
    {
        _S556 = u32(1);
    }
    else
    {
        _S556 = u32(0);
    }
    var _S557 : FaceSends_0 = face_sends_0(_S551, _S556, _S554, _S555);
    if(_S553)
    {
        _S556 = u32(0);
    }
    else
    {
        _S556 = u32(1);
    }
    var _S558 : FaceSends_0 = face_sends_0(_S551, _S556, _S554, _S555);
    var _S559 : vec3<f32> = vec3<f32>(_S557.blocks_warp_0);
    var _S560 : vec3<f32> = vec3<f32>(_S557.blocks_weft_0);
    var _S561 : vec3<f32> = _S559 * _S557.crossing_warp_0 + _S560 * _S557.crossing_weft_0;
    var _S562 : vec3<f32> = vec3<f32>(_S558.blocks_warp_0);
    var _S563 : vec3<f32> = vec3<f32>(_S558.blocks_weft_0);
    var _S564 : vec3<f32> = _S562 * _S558.crossing_warp_0 + _S563 * _S558.crossing_weft_0;
    var _S565 : f32 = 1.0f - _S557.open_0;
    var _S566 : f32 = 1.0f - _S558.open_0;
    var _S567 : vec3<f32> = vec3<f32>(1.0f);
    var _S568 : vec3<f32> = _S567 / (_S567 - _S561 * _S564 * vec3<f32>((_S565 * _S566)));
    var _S569 : vec3<f32> = _S564 * (vec3<f32>(_S557.open_0) + vec3<f32>(_S565) * (_S559 * _S557.sky_warp_0 + _S560 * _S557.sky_weft_0)) * _S568;
    var _S570 : vec3<f32> = _S561 * (vec3<f32>(_S558.open_0) + vec3<f32>(_S566) * (_S562 * _S558.sky_warp_0 + _S563 * _S558.sky_weft_0)) * _S568;
    var _S571 : FaceRadiance_0 = face_radiance_0(_S557, _S558.open_0, _S569, _S570);
    var _S572 : FaceRadiance_0 = face_radiance_0(_S558, _S557.open_0, _S570, _S569);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S571.warp_2;
    interior_1.weft_3 = _S571.weft_2;
    interior_1.leaked_1 = _S571.leaked_0;
    interior_1.far_1 = _S572.mean_0;
    interior_1.far_leaked_0 = _S572.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S573 : u32,  _S574 : YarnPoint_0,  _S575 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S576 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S576;
    nothing_0.transmitted_0 = _S576;
    var _S577 : bool;
    if((fabrics_0[_S573].openness_0) == u32(4294967295))
    {
        _S577 = true;
    }
    else
    {
        _S577 = _S574.hole_3;
    }
    if(_S577)
    {
        return nothing_0;
    }
    var _S578 : Blocked_0 = blocked_at_0(_S573, _S574.is_warp_2, _S574.back_6, _S574.surface_normal_0.z, _S574.height_4);
    var _S579 : u32;
    if(_S574.is_warp_2)
    {
        _S579 = u32(0);
    }
    else
    {
        _S579 = u32(1);
    }
    return bounced_by_0(_S578, scattered_by_0(_S573, _S574.albedos_1, _S579, _S575), interior_of_0(_S573, _S575, _S574.back_6));
}

fn scattered_0( _S580 : u32,  _S581 : YarnPoint_0,  _S582 : vec3<f32>,  _S583 : vec3<f32>) -> vec3<f32>
{
    var _S584 : vec3<f32> = vec3<f32>(0.0f);
    var _S585 : bool = !_S581.hole_3;
    var _S586 : bool;
    if(_S585)
    {
        _S586 = (_S582.z) > 0.0f;
    }
    else
    {
        _S586 = false;
    }
    var value_1 : vec3<f32>;
    if(_S586)
    {
        value_1 = _S581.albedos_1.diffuse_reflect_0 * vec3<f32>(_S581.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0(_S582, _S581.normal_7, fabrics_0[_S580].diffuse_blend_0)) + _S581.albedos_1.specular_reflect_0 * vec3<f32>(reflection_0(_S582, _S583, _S581.normal_7, _S581.tangent_8, _S581.roughness_8, fabrics_0[_S580].optical_depth_0));
    }
    else
    {
        if(_S585)
        {
            _S586 = (_S582.z) < 0.0f;
        }
        else
        {
            _S586 = false;
        }
        if(_S586)
        {
            value_1 = _S581.albedos_1.diffuse_transmit_0 * vec3<f32>(_S581.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S582), _S581.normal_7, fabrics_0[_S580].diffuse_blend_0)) + _S581.albedos_1.specular_transmit_0 * vec3<f32>(transmission_1(_S582, _S583, _S581.normal_7, _S581.tangent_8, _S581.roughness_8, fabrics_0[_S580].optical_depth_0));
        }
        else
        {
            value_1 = _S584;
        }
    }
    var _S587 : f32 = fabrics_0[_S580].sheen_strength_0;
    if((fabrics_0[_S580].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S588 : vec2<f32> = sheen_with_transmittance_0(_S582, _S583, _S587, fabrics_0[_S580].sheen_roughness_0);
    return vec3<f32>(_S588.y) * value_1 + vec3<f32>(_S588.x);
}

fn unoccluded_0( _S589 : u32,  _S590 : SearchQuality_0,  _S591 : f32,  _S592 : f32,  _S593 : f32,  _S594 : vec3<f32>,  _S595 : bool) -> bool
{
    if((_S594.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S589, _S590, vec3<f32>(_S591, _S592, _S593 + fabrics_0[_S589].lift_0), _S594, _S595, max_height_along_0(_S589, _S591, _S592, _S593, _S594, _S595));
}

fn is_lit_0( _S596 : u32,  _S597 : SearchQuality_0,  _S598 : YarnPoint_0,  _S599 : vec3<f32>) -> bool
{
    if(_S598.hole_3)
    {
        return true;
    }
    var _S600 : vec3<f32> = to_face_frame_0(_S599, _S598.back_6);
    var _S601 : f32 = _S600.z;
    var _S602 : bool = _S601 < 0.0f;
    var normal_8 : vec3<f32>;
    var height_10 : f32;
    if(_S602)
    {
        var _S603 : SurfacePoint_0 = surface_at_0(_S596, _S598.x_9, _S598.y_3, !_S598.back_6);
        normal_8 = _S603.normal_2;
        height_10 = _S603.height_3;
    }
    else
    {
        normal_8 = _S598.surface_normal_0;
        height_10 = _S598.height_4;
    }
    var _S604 : vec3<f32> = vec3<f32>(_S600.xy, abs(_S601));
    if((dot(normal_8, _S604)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S596, _S597, _S598.x_9, _S598.y_3, height_10, _S604, (_S598.back_6) != _S602);
}

fn evaluate_with_0( _S605 : u32,  _S606 : SearchQuality_0,  _S607 : YarnPoint_0,  _S608 : Bounced_0,  _S609 : vec3<f32>,  _S610 : vec3<f32>) -> vec3<f32>
{
    var _S611 : vec3<f32> = to_face_frame_0(_S610, _S607.back_6);
    var _S612 : vec3<f32> = scattered_0(_S605, _S607, to_face_frame_0(_S609, _S607.back_6), _S611);
    var _S613 : bool;
    if((max(_S612.x, max(_S612.y, _S612.z))) <= 0.0f)
    {
        _S613 = true;
    }
    else
    {
        _S613 = !is_lit_0(_S605, _S606, _S607, _S609);
    }
    var value_2 : vec3<f32>;
    if(_S613)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S612;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S608, _S609, _S610);
    var _S614 : f32 = fabrics_0[_S605].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S605].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S614 * sheen_lobe_0(abs(_S611.z), fabrics_0[_S605].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn evaluate_0( _S615 : u32,  _S616 : SearchQuality_0,  _S617 : YarnPoint_0,  _S618 : vec3<f32>,  _S619 : vec3<f32>) -> vec3<f32>
{
    return evaluate_with_0(_S615, _S616, _S617, bounced_at_0(_S615, _S617, vec3<f32>(1.0f)), _S618, _S619);
}

fn straight_through_0( _S620 : u32,  _S621 : YarnPoint_0,  _S622 : vec3<f32>) -> f32
{
    if(!_S621.hole_3)
    {
        return 0.0f;
    }
    var _S623 : f32 = fabrics_0[_S620].sheen_strength_0;
    if((fabrics_0[_S620].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S623 * sheen_lobe_0(abs(_S622.z), fabrics_0[_S620].sheen_roughness_0).z;
}

fn cloth_value_0( fabric_1 : u32,  centre_1 : vec2<f32>,  dx_1 : vec2<f32>,  dy_1 : vec2<f32>,  light_8 : vec3<f32>,  view_7 : vec3<f32>) -> vec4<f32>
{
    var _S624 : SearchQuality_0 = default_quality_0();
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = centre_1;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    var _S625 : YarnPoint_0 = locate_yarn_0(fabric_1, _S624, centre_1.x, centre_1.y, view_7, Footprint_spread_side_0(footprint_0));
    return vec4<f32>(evaluate_0(fabric_1, _S624, _S625, light_8, view_7), straight_through_0(fabric_1, _S625, view_7));
}

@compute
@workgroup_size(64, 1, 1)
fn point_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S626 : u32 = id_0.x;
    if(_S626 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S627 : Query_std430_0 = queries_0[_S626];
    answers_0[_S626] = cloth_value_0(_S627.fabric_0, vec2<f32>(_S627.centre_x_0, _S627.centre_y_0), vec2<f32>(_S627.dx_x_0, _S627.dx_y_0), vec2<f32>(_S627.dy_x_0, _S627.dy_y_0), vec3<f32>(_S627.light_x_0, _S627.light_y_0, _S627.light_z_0), vec3<f32>(_S627.view_x_0, _S627.view_y_0, _S627.view_z_0));
    return;
}

