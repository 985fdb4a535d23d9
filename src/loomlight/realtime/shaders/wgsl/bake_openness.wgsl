@binding(12) @group(0) var<storage, read> steps_0 : array<u32>;

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
    @align(4) joint_0 : u32,
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
    @align(4) auxiliary_0 : u32,
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
    @align(4) is_apart_0 : u32,
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
    @align(4) texels_2 : u32,
    @align(4) light_0 : u32,
    @align(4) heights_0 : u32,
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
    @align(4) grazing_gain_0 : f32,
    @align(4) grazing_loss_0 : f32,
    @align(4) sheen_strength_0 : f32,
    @align(4) sheen_roughness_0 : f32,
    @align(4) fibre_noise_0 : f32,
    @align(4) colour_noise_0 : f32,
    @align(4) seed_0 : u32,
    @align(4) layer_bound_0 : f32,
    @align(4) fibre_size_0 : f32,
    @align(4) is_irregular_0 : u32,
    @align(4) warp_on_top_0 : f32,
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
    @align(4) irregular_table_0 : u32,
    @align(4) irregular_thickness_0 : f32,
    @align(4) irregular_cover_0 : f32,
    @align(4) irregular_tone_0 : f32,
    @align(4) irregular_nep_0 : f32,
    @align(4) cover_0 : f32,
    @align(4) nep_red_0 : f32,
    @align(4) nep_green_0 : f32,
    @align(4) nep_blue_0 : f32,
    @align(4) has_plies_0 : f32,
    @align(4) plies_per_mm_0 : f32,
    @align(4) ply_sine_0 : f32,
    @align(4) ply_cosine_0 : f32,
    @align(4) fibre_tilt_0 : f32,
    @align(4) fibre_tone_0 : f32,
    @align(4) slub_0 : f32,
    @align(4) slubs_per_mm_0 : f32,
    @align(4) hairiness_0 : f32,
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

@binding(14) @group(0) var<storage, read_write> scratch_0 : array<u32>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec2<f32>,  no_0 : vec2<f32>) -> vec2<f32>
{
    var chosen_0 : vec2<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    return chosen_0;
}

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec3<f32>,  no_1 : vec3<f32>) -> vec3<f32>
{
    var chosen_1 : vec3<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    chosen_1[i32(2)] = select(no_1[i32(2)], yes_1[i32(2)], condition_1);
    return chosen_1;
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
fn thread_index_0( id_0 : vec3<u32>) -> u32
{
    return id_0.y * u32(2097152) + id_0.x;
}

fn ray_number_0( ray_0 : u32,  number_0 : u32) -> f32
{
    return (bitcast<f32>((steps_0[u32(2) + ray_0 * u32(5) + number_0])));
}

struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn openness_quality_0() -> SearchQuality_0
{
    var quality_0 : SearchQuality_0;
    quality_0.steps_per_thread_0 = 4.0f;
    quality_0.steps_per_relief_0 = 4.0f;
    quality_0.shadow_share_0 = 1.29999995231628418f;
    quality_0.refinements_0 = u32(1);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_0 : f32) -> vec2<f32>
{
    var _S1 : f32 = floor(fma(index_0, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S1, fma(- _S1, families_0[family_0].count_0, index_0));
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
    var _S2 : f32 = floor(position_0 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S3 : f32 = fma(- _S2, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S3;
    cell_0.above_0 = families_0[family_1].size_0 - _S3;
    cell_0.across_0 = _S3 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S2).y, 0.0f, families_0[family_1].count_0 - 1.0f));
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
    var _S4 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S5 : u32 = min(thread_1 + select(u32(0), u32(1), _S4 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S6 : u32 = families_0[family_2].place_table_0 + _S5 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S5;
    cell_1.below_0 = _S4 - table_number_0(_S6);
    cell_1.above_0 = table_number_0(_S6 + u32(1)) - _S4;
    cell_1.across_0 = _S4 - table_number_0(_S6 + u32(2));
    cell_1.half_width_1 = table_number_0(_S6 + u32(3));
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

fn shown_at_0( crossing_0 : Crossing_0,  back_2 : bool) -> Shown_0
{
    var _S7 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var shown_0 : Shown_0;
    var _S8 : bool = !((abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1));
    var _S9 : bool = (_S7 & (((_S8 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_0 = _S9;
    shown_0.hole_0 = ((!_S7) & (_S8));
    var _S10 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S9);
    shown_0.word_0 = _S10;
    shown_0.on_top_0 = (((_S10 & (u32(1)))) == u32(1)) != back_2;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_2 : Cell_0;
    cell_2.thread_0 = select(second_0.thread_0, first_0.thread_0, is_first_0);
    cell_2.across_0 = select(second_0.across_0, first_0.across_0, is_first_0);
    cell_2.half_width_1 = select(second_0.half_width_1, first_0.half_width_1, is_first_0);
    cell_2.below_0 = select(second_0.below_0, first_0.below_0, is_first_0);
    cell_2.above_0 = select(second_0.above_0, first_0.above_0, is_first_0);
    return cell_2;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S11 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S11.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S11.y) * u32(4)));
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
    var _S12 : u32 = families_0[family_6].bend_table_0 + select(thread_4 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S12);
    bend_0.half_tangent_0 = table_number_0(_S12 + u32(1));
    bend_0.arc_0 = table_number_0(_S12 + u32(2));
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
    var _S13 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S14 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S15 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S16 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S17 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S17;
    var _S18 : i32 = - _S13;
    var _S19 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S18, i32(0));
    run_0.from_start_0 = _S19;
    var _S20 : i32 = _S14 + i32(1);
    var _S21 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S20);
    run_0.to_end_0 = _S21;
    var _S22 : bool = _S19 < _S21;
    run_0.near_start_0 = _S22;
    var _S23 : i32 = select(_S20, _S18 - _S15, _S22);
    var _S24 : i32 = select(_S20 + _S16, _S18, _S22);
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    run_0.distance_0 = select(min(_S19, _S21), 1.0e+06f, _S17);
    run_0.reach_0 = min(0.5f * (_S19 + _S21), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S23, _S24), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S13 == i32(0);
    run_0.last_crossing_0 = _S14 == i32(0);
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
    var _S25 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S26 : f32 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S26;
    var _S27 : f32 = _S25 * _S25 - square_0(_S26);
    var _S28 : f32 = rsqrt_0(_S27);
    section_0.drop_0 = _S25 - _S27 * _S28;
    section_0.slope_0 = - _S26 * _S28;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_6 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_6) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S29 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S30 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S31 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S29) - crossed_1.half_width_1;
    var _S32 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S29);
    var _S33 : f32;
    if(shown_1.on_top_0)
    {
        _S33 = 0.0f;
    }
    else
    {
        _S33 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S34 : f32;
    if((shown_1.on_top_0) != _S32)
    {
        _S34 = 0.0f;
    }
    else
    {
        _S34 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, select(i32(1), i32(-1), _S29));
    }
    var _S35 : f32 = 2.0f * _S31;
    var _S36 : f32 = 1.0f / max(_S35, 9.999999960041972e-13f);
    var _S37 : f32 = clamp((_S31 - _S30) * _S36, 0.0f, 1.0f);
    var _S38 : f32 = clamp((0.44999998807907104f - _S35 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S33 + (_S34 - _S33) * (_S37 * _S37 * (3.0f - 2.0f * _S37)), (_S33 - _S34) * (6.0f * _S37 * (1.0f - _S37) * _S36) * select(-1.0f, 1.0f, _S29), _S38 * _S38 * (3.0f - 2.0f * _S38));
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

fn step_control_0( direction_0 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S39 : f32 = direction_0.x;
    control_0.per_x_0 = 1.0f / max(abs(_S39), 9.99999971718068537e-10f);
    var _S40 : f32 = direction_0.y;
    control_0.per_y_0 = 1.0f / max(abs(_S40), 9.99999971718068537e-10f);
    control_0.right_0 = _S39 > 0.0f;
    control_0.up_0 = _S40 > 0.0f;
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
    var _S41 : f32 = select(- cell_4.across_0, cell_4.across_0, forwards_0);
    var _S42 : f32 = select(cell_4.below_0, cell_4.above_0, forwards_0);
    var _S43 : f32 = - cell_4.half_width_1;
    var _S44 : bool = _S41 < _S43;
    var _S45 : bool = _S41 >= (cell_4.half_width_1);
    var _S46 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_0)));
    var _S47 : f32 = select(cell_4.half_width_1, _S43, _S44) - _S41;
    var _S48 : f32 = select(_S42, 2.0f * _S42 + _S41 - cell_4.half_width_1, ((shown_2.hole_0) | (((_S46 & ((!shown_2.on_top_0)))))));
    if((((_S46 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S44)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S47, _S48, _S45);
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
    var _S49 : f32 = previous_1.rate_0 * step_4;
    var _S50 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_1)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S49) >= 0.0f) & (((3.0f * clearance_1 - _S50) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S51 : f32 = clearance_1 - previous_1.clearance_0;
    var _S52 : f32 = 6.0f * _S51 - 4.0f * _S49 - 2.0f * _S50;
    var _S53 : f32 = -2.0f * _S49 / max(_S52 + sqrt(max(_S52 * _S52 - 4.0f * (3.0f * (_S49 + _S50 - 2.0f * _S51)) * _S49, 0.0f)), 9.99999968265522539e-21f);
    var _S54 : f32 = 1.0f - _S53;
    return select(-1.0f, _S54 * step_4, ((((_S53 > 0.01999999955296516f) & ((_S54 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S53 + 1.0f) + _S49 * _S53) * _S54 * _S54 + (clearance_1 * (2.0f * _S54 + 1.0f) - _S50 * _S54) * _S53 * _S53) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_1.hole_1);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    previous_2.known_0 = ((!here_1.hole_1) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_0 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

fn StepControl_to_next_sample_0( this_1 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S55 : f32 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    return min(this_1.step_2, select(max(_S55, 0.0f) + this_1.epsilon_0, _S55 - this_1.epsilon_0, ((((!here_2.hole_1) & (((rate_3 * _S55 + clearance_3) < 0.0f)))) & ((_S55 > (2.0f * this_1.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_2 : ViewRay_0,  height_2 : f32) -> vec2<f32>
{
    return this_2.origin_0 + this_2.slope_1 * vec2<f32>(height_2);
}

fn ViewRay_rate_0( this_3 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_3.slope_1.x + here_3.slope_y_0 * this_3.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S56 : f32 = end_0 - start_1;
    var _S57 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S56;
    var _S58 : f32 = 3.0f * _S56 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S56, 9.99999968265522539e-21f);
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
        var _S59 : f32 = clamp(share_0 - (((_S57 * share_0 + _S58) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S57 * share_0 + 2.0f * _S58) * share_0 + start_rate_0, 0.10000000149011612f * _S56 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S60 : i32 = i_0 + i32(1);
        share_0 = _S59;
        i_0 = _S60;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S61 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S62 : f32 = rsqrt_0(_S61);
    var _S63 : f32 = sine_1 * _S62 * rsqrt_0(_S61 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S63 * _S61, _S63 * across_slope_0 * along_slope_0 + cosine_0 * _S62);
}

fn arc_sine_0( x_2 : f32) -> f32
{
    var _S64 : f32 = abs(x_2);
    var _S65 : bool = _S64 > 0.5f;
    var _S66 : f32 = select(_S64 * _S64, 0.5f * (1.0f - _S64), _S65);
    var _S67 : f32 = select(_S64, sqrt(max(_S66, 0.0f)), _S65);
    var _S68 : f32 = ((((0.04216320067644119f * _S66 + 0.02418131195008755f) * _S66 + 0.04547002539038658f) * _S66 + 0.07495300471782684f) * _S66 + 0.16666752099990845f) * _S66 * _S67 + _S67;
    var _S69 : f32 = select(_S68, 1.57079637050628662f - 2.0f * _S68, _S65);
    return select(_S69, - _S69, x_2 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S70 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S70 / (_S70 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_1 : vec2<f32>) -> f32
{
    var _S71 : f32 = direction_1.x;
    var _S72 : f32 = arc_sine_0(_S71);
    var _S73 : bool = _S71 < 0.0f;
    var _S74 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S73);
    var _S75 : f32 = direction_1.y;
    return select(0.5f * _S74 - select(1.0f, -1.0f, _S73) * arc_sine_0(_S75), select(_S72, _S74 - _S72, _S75 < 0.0f), (abs(_S71)) < 0.69999998807907104f);
}

fn fract_of_0( number_1 : f32) -> f32
{
    return number_1 - floor(number_1);
}

fn sine_cosine_0( x_3 : f32) -> vec2<f32>
{
    var _S76 : f32 = floor(x_3 * 0.63661974668502808f + 0.5f);
    var _S77 : f32 = x_3 - _S76 * 1.5703125f - _S76 * 0.00048375129699707f - _S76 * 7.54979012640433211e-08f;
    var _S78 : f32 = _S77 * _S77;
    var _S79 : f32 = ((-0.00019515295571182f * _S78 + 0.00833216123282909f) * _S78 - 0.16666655242443085f) * _S78 * _S77 + _S77;
    var _S80 : f32 = ((0.00002443315679557f * _S78 - 0.00138873164542019f) * _S78 + 0.04166664555668831f) * _S78 * _S78 - 0.5f * _S78 + 1.0f;
    var _S81 : u32 = (u32(i32(_S76)) & (u32(3)));
    var _S82 : vec2<f32> = select_vector_0(((_S81 & (u32(1)))) != u32(0), vec2<f32>(_S80, _S79), vec2<f32>(_S79, _S80));
    var _S83 : f32 = _S82.x;
    var _S84 : f32 = _S82.y;
    return vec2<f32>(select(_S83, - _S83, ((_S81 & (u32(2)))) != u32(0)), select(_S84, - _S84, (((_S81 + u32(1)) & (u32(2)))) != u32(0)));
}

fn uniform_on_sphere_0( u_0 : vec2<f32>) -> vec3<f32>
{
    var _S85 : f32 = u_0.x;
    var _S86 : f32 = 2.0f * sqrt(max(_S85 * (1.0f - _S85), 0.0f));
    var _S87 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_0.y);
    return vec3<f32>(_S86 * _S87.y, _S86 * _S87.x, 1.0f - 2.0f * _S85);
}

fn square_1( v_0 : vec3<f32>) -> f32
{
    return dot(v_0, v_0);
}

fn unit_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0 * vec3<f32>(rsqrt_0(max(square_1(vector_0), 9.99999968265522539e-21f)));
}

fn cosine_about_0( axis_0 : vec3<f32>,  u_1 : vec2<f32>) -> vec3<f32>
{
    return unit_0(axis_0 + uniform_on_sphere_0(u_1));
}

fn sample_diffuse_0( normal_0 : vec3<f32>,  blend_0 : f32,  u_2 : vec2<f32>) -> vec3<f32>
{
    var _S88 : f32 = u_2.x;
    var _S89 : bool = _S88 < blend_0;
    return cosine_about_0(select_vector_1(_S89, normal_0, vec3<f32>(0.0f, 0.0f, 1.0f)), vec2<f32>(min((_S88 - select(blend_0, 0.0f, _S89)) / max(select(1.0f - blend_0, blend_0, _S89), 1.00000001168609742e-07f), 0.99999994039535522f), u_2.y));
}

fn diffuse_pdf_0( light_1 : vec3<f32>,  normal_1 : vec3<f32>,  blend_1 : f32) -> f32
{
    return 0.31830987334251404f * mix(max(light_1.z, 0.0f), max(dot(light_1, normal_1), 0.0f), blend_1);
}

fn projected_area_1( direction_2 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S90 : f32 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S90 * _S90 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_4 : f32) -> f32
{
    var _S91 : f32 = clamp(x_4, -87.0f, 88.0f);
    var _S92 : f32 = floor(_S91 * 1.4426950216293335f + 0.5f);
    var _S93 : f32 = _S91 - _S92 * 0.693359375f + _S92 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S93 + 0.00139819993637502f) * _S93 + 0.00833345204591751f) * _S93 + 0.04166579619050026f) * _S93 + 0.1666666567325592f) * _S93 + 0.5f) * _S93 * _S93 + _S93 + 1.0f) * (bitcast<f32>(((u32(i32(_S92) + i32(127)) << (u32(23)))))), 0.0f, x_4 < -87.0f);
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S94 : f32 = roughness_2 * roughness_2;
    var _S95 : f32 = squared_along_0 * (1.0f - _S94) + _S94;
    return 0.31830987334251404f * _S94 * roughness_2 / (_S95 * _S95);
}

fn density_between_0( light_2 : vec3<f32>,  view_0 : vec3<f32>,  tangent_1 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S96 : vec3<f32> = light_2 + view_0;
    var _S97 : f32 = dot(_S96, tangent_1);
    return flake_density_0(min(_S97 * _S97 / max(square_1(_S96), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_1 : vec3<f32>,  normal_2 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S98 : f32 = dot(light_3, normal_2);
    var _S99 : f32 = dot(view_1, normal_2);
    if(((_S98 <= 0.0f) | ((_S99 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S100 : f32 = max(_S98, 9.99999997475242708e-07f);
    var _S101 : f32 = max(_S99, 9.99999997475242708e-07f);
    var _S102 : f32 = projected_area_1(light_3, tangent_2, roughness_4) * _S101 + projected_area_1(view_1, tangent_2, roughness_4) * _S100;
    var _S103 : f32 = optical_depth_1 * _S102 / (_S100 * _S101);
    return 0.25f * density_between_0(light_3, view_1, tangent_2, roughness_4) * (_S103 * mean_attenuation_0(_S103)) * _S100 / _S102;
}

fn transmission_1( light_4 : vec3<f32>,  view_2 : vec3<f32>,  normal_3 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S104 : f32 = - dot(light_4, normal_3);
    var _S105 : f32 = dot(view_2, normal_3);
    if(((_S104 <= 0.0f) | ((_S105 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S106 : f32 = 1.0f / max(_S105, 9.99999997475242708e-07f);
    var _S107 : f32 = projected_area_1(light_4, tangent_3, roughness_5) / max(_S104, 9.99999997475242708e-07f);
    var _S108 : f32 = projected_area_1(view_2, tangent_3, roughness_5) * _S106;
    return density_between_0(light_4, view_2, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S107, _S108)) * mean_attenuation_0(optical_depth_2 * abs(_S107 - _S108)) * _S106;
}

struct Hit_0
{
     x_5 : f32,
     y_0 : f32,
     hole_2 : bool,
     height_3 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_4 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S109 : u32,  _S110 : f32,  _S111 : f32,  _S112 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S109].warp_0, _S110);
    crossing_2.weft_1 = locate_0(fabrics_0[_S109].weft_0, _S111);
    var _S113 : u32 = fabrics_0[_S109].run_words_0 + u32(2) * (crossing_2.weft_1.thread_0 * fabrics_0[_S109].ends_1 + crossing_2.warp_1.thread_0);
    var _S114 : u32 = words_0[_S113];
    crossing_2.warp_word_0 = _S114;
    crossing_2.weft_word_0 = words_0[_S113 + u32(1)];
    crossing_2.warp_above_0 = (((_S114 & (u32(1)))) == u32(1)) != _S112;
    return crossing_2;
}

fn sample_at_0( _S115 : u32,  _S116 : f32,  _S117 : f32,  _S118 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S119 : Crossing_0 = crossing_at_0(_S115, _S116, _S117, _S118);
    sample_0.crossing_1 = _S119;
    var _S120 : Shown_0 = shown_at_0(_S119, _S118);
    sample_0.shown_3 = _S120;
    var _S121 : u32 = select(fabrics_0[_S115].weft_0, fabrics_0[_S115].warp_0, _S120.is_warp_0);
    var _S122 : u32 = select(fabrics_0[_S115].warp_0, fabrics_0[_S115].weft_0, _S120.is_warp_0);
    var _S123 : Cell_0 = select_cell_0(_S120.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S124 : Cell_0 = select_cell_0(_S120.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S125 : Run_0 = unpack_0(_S121, _S122, _S123.thread_0, _S124, _S120.word_0);
    var _S126 : Section_0 = section_at_0(_S123);
    var _S127 : bool = ((_S120.on_top_0) & (((_S125.distance_0) < (_S126.drop_0 * _S125.bend_1.sine_0))));
    var _S128 : f32 = select(-1.0f, 1.0f, ((_S120.on_top_0) & ((!_S127))));
    var _S129 : f32 = select(_S125.reach_0, _S125.other_reach_0, _S127);
    var _S130 : f32 = select(max(_S129 - _S125.distance_0, 0.0f), _S129 + _S125.distance_0, _S127);
    var _S131 : f32 = _S129 / _S125.bend_1.sine_0 - _S128 * _S126.drop_0;
    var _S132 : f32 = _S130 * _S130;
    var _S133 : f32 = max(_S131 * _S131 - _S132, 9.99999968265522539e-21f);
    var _S134 : f32 = rsqrt_0(_S133);
    var _S135 : f32 = _S132 / (_S133 * _S134 + _S131);
    var _S136 : bool = _S130 > 0.0f;
    var _S137 : f32 = select(-1.0f, 1.0f, _S120.on_top_0) * select(-1.0f, 1.0f, _S125.near_start_0);
    var _S138 : f32 = _S126.slope_0 * select(1.0f, _S131 * _S134, _S136);
    sample_0.slope_across_0 = _S138;
    var _S139 : f32 = select(0.0f, _S137 * _S130 * _S134, _S136);
    sample_0.slope_along_0 = _S139;
    var _S140 : vec3<f32> = dive_0(_S122, _S120, _S125, _S124);
    sample_0.dive_1 = _S140;
    sample_0.height_4 = select(families_0[_S121].height_scale_0 * _S128, 0.0f, _S125.straight_0) * (_S129 * _S125.bend_1.half_tangent_0 - _S135) - families_0[_S121].height_scale_0 * _S126.drop_0 - _S140.x;
    var _S141 : f32 = families_0[_S121].height_scale_0 * _S138;
    var _S142 : f32 = families_0[_S121].height_scale_0 * _S139 - _S140.y;
    sample_0.slope_x_1 = select(_S142, _S141, _S120.is_warp_0);
    sample_0.slope_y_1 = select(_S141, _S142, _S120.is_warp_0);
    sample_0.run_3 = _S125;
    sample_0.section_1 = _S126;
    return sample_0;
}

fn steps_per_length_0( _S143 : u32,  _S144 : SearchQuality_0,  _S145 : vec3<f32>) -> f32
{
    return max(max(abs(_S145.x) * fabrics_0[_S143].threads_per_x_0, abs(_S145.y) * fabrics_0[_S143].threads_per_y_0) * _S144.steps_per_thread_0, abs(_S145.z) * fabrics_0[_S143].per_relief_0 * _S144.steps_per_relief_0);
}

fn cell_maximum_0( _S146 : u32,  _S147 : Crossing_0) -> f32
{
    var _S148 : u32 = select(fabrics_0[_S146].weft_0, fabrics_0[_S146].warp_0, _S147.warp_above_0);
    return f32((select(_S147.weft_word_0, _S147.warp_word_0, _S147.warp_above_0) >> (u32(28)))) * families_0[_S148].height_scale_0 * families_0[_S148].level_0;
}

fn probe_0( _S149 : u32,  _S150 : f32,  _S151 : f32,  _S152 : bool,  _S153 : bool,  _S154 : bool) -> Probe_0
{
    var _S155 : Sample_0 = sample_at_0(_S149, _S150, _S151, _S152);
    var probe_1 : Probe_0;
    probe_1.height_1 = _S155.height_4;
    probe_1.hole_1 = _S155.shown_3.hole_0;
    probe_1.slope_x_0 = _S155.slope_x_1;
    probe_1.slope_y_0 = _S155.slope_y_1;
    probe_1.yarn_1 = select(_S155.crossing_1.weft_1.thread_0 * u32(2), _S155.crossing_1.warp_1.thread_0 * u32(2) + u32(1), _S155.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S149, _S155.crossing_1);
    probe_1.side_x_0 = select(_S155.crossing_1.warp_1.below_0, _S155.crossing_1.warp_1.above_0, _S153);
    probe_1.side_y_0 = select(_S155.crossing_1.weft_1.below_0, _S155.crossing_1.weft_1.above_0, _S154);
    probe_1.edge_x_0 = outline_distance_0(_S155.crossing_1.warp_1, _S155.shown_3, _S155.run_3, !_S155.shown_3.is_warp_0, _S153);
    probe_1.edge_y_0 = outline_distance_0(_S155.crossing_1.weft_1, _S155.shown_3, _S155.run_3, _S155.shown_3.is_warp_0, _S154);
    return probe_1;
}

fn is_free_0( _S156 : u32,  _S157 : SearchQuality_0,  _S158 : vec3<f32>,  _S159 : vec3<f32>,  _S160 : bool,  _S161 : f32) -> bool
{
    var _S162 : f32 = _S159.z;
    if(_S162 <= 0.0f)
    {
        return false;
    }
    var _S163 : f32 = 1.0f / max(_S157.shadow_share_0 * steps_per_length_0(_S156, _S157, _S159), 9.99999971718068537e-10f);
    var _S164 : StepControl_0 = step_control_0(_S159.xy, _S163);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_1 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_1 < u32(1024)) & (((_S158.z + _S162 * distance_1) < _S161))))
        {
        }
        else
        {
            break;
        }
        var _S165 : vec3<f32> = _S158 + _S159 * vec3<f32>(distance_1);
        var _S166 : Probe_0 = probe_0(_S156, _S165.x, _S165.y, _S160, _S164.right_0, _S164.up_0);
        var _S167 : f32 = _S165.z;
        var _S168 : f32 = _S167 - _S166.height_1;
        var _S169 : f32 = _S162 - _S166.slope_x_0 * _S159.x - _S166.slope_y_0 * _S159.y;
        if(((!_S166.hole_1) & ((_S168 < 0.0f))))
        {
            return false;
        }
        var _S170 : f32 = way_back_to_dip_0(previous_3, _S168, _S169, last_step_0, _S166);
        if(_S170 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S170;
            distance_1 = distance_1 - _S170;
            last_step_0 = last_step_1;
            count_1 = count_1 + u32(1);
            continue;
        }
        var _S171 : bool = _S167 > (_S166.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S164, _S166, _S168, _S169), max(StepControl_to_cell_exit_0(_S164, _S166.side_x_0, _S166.side_y_0), _S163), _S171);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S168, _S169, _S166, _S171);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + u32(1);
    }
    return true;
}

fn passes_through_0( _S172 : u32,  _S173 : SearchQuality_0,  _S174 : f32,  _S175 : f32,  _S176 : vec3<f32>,  _S177 : bool) -> bool
{
    if(!sample_at_0(_S172, _S174, _S175, _S177).shown_3.hole_0)
    {
        return false;
    }
    var _S178 : vec3<f32> = vec3<f32>(_S174, _S175, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        if(((side_0 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S179 : bool = is_free_0(_S172, _S173, _S178, select_vector_1(side_0 == u32(0), _S176, vec3<f32>(- _S176.x, - _S176.y, _S176.z)), _S177 != (side_0 == u32(1)), fabrics_0[_S172].height_high_0);
        var _S180 : u32 = side_0 + u32(1);
        passes_0 = _S179;
        side_0 = _S180;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_5 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S181 : u32,  _S182 : f32,  _S183 : f32,  _S184 : f32,  _S185 : vec3<f32>,  _S186 : bool) -> f32
{
    var _S187 : f32 = _S185.x;
    var _S188 : f32 = _S185.y;
    var _S189 : u32 = (words_0[fabrics_0[_S181].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S181].weft_0, _S183).thread_0 / u32(2) * fabrics_0[_S181].max_height_columns_0 + locate_0(fabrics_0[_S181].warp_0, _S182).thread_0 / u32(2)) + (select(u32(0), u32(1), _S187 > 0.0f) + select(u32(0), u32(2), _S188 > 0.0f))] >> (u32(select(i32(0), i32(4), _S186))));
    var _S190 : f32 = max(abs(_S187) * fabrics_0[_S181].threads_per_x_0, abs(_S188) * fabrics_0[_S181].threads_per_y_0) / _S185.z;
    var _S191 : f32 = fabrics_0[_S181].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S181].height_high_0;
    var number_2 : i32 = i32(3);
    for(;;)
    {
        if(number_2 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S184) * _S190) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, f32((((_S189 >> (u32(i32(8) * number_2)))) & (u32(15)))) * 0.06666667014360428f * _S191);
        }
        number_2 = number_2 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S192 : u32,  _S193 : f32,  _S194 : f32,  _S195 : bool,  _S196 : bool,  _S197 : bool) -> vec3<f32>
{
    var _S198 : Crossing_0 = crossing_at_0(_S192, _S193, _S194, _S195);
    return vec3<f32>(cell_maximum_0(_S192, _S198), select(_S198.warp_1.below_0, _S198.warp_1.above_0, _S196), select(_S198.weft_1.below_0, _S198.weft_1.above_0, _S197));
}

fn first_sample_height_0( _S199 : u32,  _S200 : ViewRay_0,  _S201 : StepControl_0,  _S202 : bool) -> f32
{
    var _S203 : f32 = max_height_along_0(_S199, _S200.origin_0.x, _S200.origin_0.y, 0.0f, vec3<f32>(_S200.slope_1, 1.0f), _S202);
    var count_2 : u32 = u32(0);
    var height_6 : f32 = _S203;
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S204 : vec2<f32> = ViewRay_at_0(_S200, height_6);
        var _S205 : vec3<f32> = cell_bounds_0(_S199, _S204.x, _S204.y, _S202, _S201.right_0, _S201.up_0);
        var _S206 : f32 = height_6 - _S205.x;
        var _S207 : f32 = StepControl_to_cell_exit_0(_S201, _S205.y, _S205.z);
        var height_7 : f32 = height_6 - clamp(_S206, 0.0f, _S207);
        if(_S206 <= _S207)
        {
            height_6 = height_7;
            break;
        }
        count_2 = count_2 + u32(1);
        height_6 = height_7;
    }
    return height_6;
}

fn search_down_0( _S208 : u32,  _S209 : ViewRay_0,  _S210 : StepControl_0,  _S211 : bool) -> ViewRayEnd_0
{
    var _S212 : f32 = fabrics_0[_S208].height_low_0 - (fabrics_0[_S208].height_high_0 - fabrics_0[_S208].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_5 = first_sample_height_0(_S208, _S209, _S210, _S211);
    end_1.last_step_3 = _S210.epsilon_0;
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
        var _S213 : vec2<f32> = ViewRay_at_0(_S209, end_1.height_5);
        var _S214 : Probe_0 = probe_0(_S208, _S213.x, _S213.y, _S211, _S210.right_0, _S210.up_0);
        var _S215 : f32 = end_1.height_5 - _S214.height_1;
        var _S216 : f32 = ViewRay_rate_0(_S209, _S214);
        end_1.depth_1 = - _S215;
        end_1.rate_4 = _S216;
        var _S217 : bool = !_S214.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S217))) & (((end_1.previous_4.yarn_0) == (_S214.yarn_1))));
        if((((_S217 & ((_S215 <= 0.0f)))) | (((end_1.height_5) <= _S212))))
        {
            break;
        }
        var _S218 : f32 = way_back_to_dip_0(end_1.previous_4, _S215, _S216, end_1.last_step_3, _S214);
        if(_S218 >= 0.0f)
        {
            end_1.height_5 = end_1.height_5 + _S218;
            end_1.last_step_3 = end_1.last_step_3 - _S218;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S219 : f32 = min(StepControl_to_cell_exit_0(_S210, _S214.side_x_0, _S214.side_y_0), end_1.height_5 - _S214.cell_max_0);
        var _S220 : f32 = StepControl_to_next_sample_0(_S210, _S214, _S215, _S216);
        end_1.previous_4 = after_sample_0(_S215, _S216, _S214, _S219 > _S220);
        var _S221 : f32 = max(_S219, _S220);
        end_1.last_step_3 = _S221;
        end_1.height_5 = end_1.height_5 - _S221;
        count_3 = count_3 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S222 : u32,  _S223 : ViewRay_0,  _S224 : StepControl_0,  _S225 : bool,  _S226 : ViewRayEnd_0,  _S227 : u32) -> f32
{
    var _S228 : f32 = fabrics_0[_S222].height_high_0 - fabrics_0[_S222].height_low_0;
    var above_2 : f32 = _S226.height_5 + _S226.last_step_3;
    var above_gap_1 : f32 = clamp(_S226.previous_4.clearance_0, 0.0f, _S228);
    var under_gap_1 : f32 = clamp(_S226.depth_1, 0.0f, _S228);
    var middle_0 : f32 = select(between_0(above_2, _S226.height_5, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S226.previous_4.rate_0 * _S226.last_step_3, _S226.rate_4 * _S226.last_step_3) * _S226.last_step_3, _S226.smooth_0);
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S226.height_5;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S227)
        {
        }
        else
        {
            break;
        }
        var _S229 : vec2<f32> = ViewRay_at_0(_S223, middle_0);
        var _S230 : Probe_0 = probe_0(_S222, _S229.x, _S229.y, _S225, _S224.right_0, _S224.up_0);
        var _S231 : f32 = clamp(middle_0 - select(_S230.height_1, -1.0e+09f, _S230.hole_1), - _S228, _S228);
        if(_S231 <= 0.0f)
        {
            var _S232 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_1 > 0.0f);
            var _S233 : f32 = - _S231;
            under_1 = middle_0;
            above_gap_2 = _S232;
            under_gap_2 = _S233;
            side_1 = 1.0f;
        }
        else
        {
            var _S234 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_1 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S231;
            under_gap_2 = _S234;
            side_1 = -1.0f;
        }
        var _S235 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S231 / min(ViewRay_rate_0(_S223, _S230), -9.99999997475242708e-07f), under_1, above_3), _S226.smooth_0);
        var _S236 : u32 = i_1 + u32(1);
        middle_0 = _S235;
        i_1 = _S236;
    }
    return select(under_1, middle_0, _S226.smooth_0);
}

fn first_hit_of_yarn_0( _S237 : u32,  _S238 : SearchQuality_0,  _S239 : f32,  _S240 : f32,  _S241 : vec3<f32>,  _S242 : bool) -> Hit_0
{
    var _S243 : f32 = max(_S241.z, 0.00009999999747379f);
    var ray_1 : ViewRay_0;
    ray_1.origin_0 = vec2<f32>(_S239, _S240);
    var _S244 : vec2<f32> = _S241.xy / vec2<f32>(_S243);
    ray_1.slope_1 = _S244;
    var _S245 : StepControl_0 = step_control_0((vec2<f32>(0) - _S244), 1.0f / max(steps_per_length_0(_S237, _S238, _S241) / _S243, 9.99999971718068537e-10f));
    var _S246 : ViewRayEnd_0 = search_down_0(_S237, ray_1, _S245, _S242);
    var hit_0 : Hit_0;
    hit_0.hole_2 = false;
    var _S247 : f32 = refined_height_0(_S237, ray_1, _S245, _S242, _S246, _S238.refinements_0);
    hit_0.height_3 = _S247;
    var _S248 : vec2<f32> = ViewRay_at_0(ray_1, _S247);
    hit_0.x_5 = _S248.x;
    hit_0.y_0 = _S248.y;
    return hit_0;
}

fn first_hit_0( _S249 : u32,  _S250 : SearchQuality_0,  _S251 : f32,  _S252 : f32,  _S253 : vec3<f32>,  _S254 : bool) -> Hit_0
{
    if(!passes_through_0(_S249, _S250, _S251, _S252, _S253, _S254))
    {
        return first_hit_of_yarn_0(_S249, _S250, _S251, _S252, _S253, _S254);
    }
    var hit_1 : Hit_0;
    hit_1.x_5 = _S251;
    hit_1.y_0 = _S252;
    hit_1.height_3 = 0.0f;
    hit_1.hole_2 = true;
    return hit_1;
}

struct SurfacePoint_0
{
     hole_3 : bool,
     is_warp_1 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_8 : f32,
     normal_4 : vec3<f32>,
     tangent_4 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     x_6 : f32,
     y_1 : f32,
     shown_share_0 : f32,
};

fn surface_of_0( _S255 : u32,  _S256 : Sample_0,  _S257 : f32,  _S258 : f32,  _S259 : bool) -> SurfacePoint_0
{
    var _S260 : u32 = select(fabrics_0[_S255].weft_0, fabrics_0[_S255].warp_0, _S256.shown_3.is_warp_0);
    var _S261 : f32 = families_0[_S260].twist_sine_0 * select(1.0f, -1.0f, _S259);
    var _S262 : f32 = select(-1.0f, 1.0f, _S256.shown_3.is_warp_0);
    var _S263 : vec2<f32> = fibre_direction_0(_S256.slope_across_0, _S262 * _S256.slope_along_0, _S261, families_0[_S260].twist_cosine_0);
    var _S264 : f32 = _S263.x;
    var _S265 : f32 = _S263.y;
    var _S266 : f32 = select(_S256.slope_y_1, _S256.slope_x_1, _S256.shown_3.is_warp_0) * _S264 + _S262 * select(_S256.slope_x_1, _S256.slope_y_1, _S256.shown_3.is_warp_0) * _S265;
    var _S267 : f32 = select(_S256.crossing_1.weft_1.half_width_1, _S256.crossing_1.warp_1.half_width_1, _S256.shown_3.is_warp_0) * 1.0154266357421875f;
    var _S268 : f32 = _S267 * arc_sine_0(clamp(_S256.section_1.across_1 / _S267, -1.0f, 1.0f));
    var _S269 : f32 = select(- _S257, _S258, _S256.shown_3.is_warp_0);
    var point_0 : SurfacePoint_0;
    point_0.hole_3 = _S256.shown_3.hole_0;
    point_0.is_warp_1 = _S256.shown_3.is_warp_0;
    point_0.warp_thread_0 = _S256.crossing_1.warp_1.thread_0;
    point_0.weft_thread_0 = _S256.crossing_1.weft_1.thread_0;
    point_0.height_8 = _S256.height_4;
    point_0.normal_4 = normalize(vec3<f32>(- _S256.slope_x_1, - _S256.slope_y_1, 1.0f));
    point_0.tangent_4 = normalize(select_vector_1(_S256.shown_3.is_warp_0, vec3<f32>(_S264, _S265, _S266), vec3<f32>(- _S265, _S264, _S266)));
    point_0.across_2 = _S256.section_1.across_1;
    point_0.fibre_across_0 = _S268 * families_0[_S260].twist_cosine_0 + _S269 * _S261;
    point_0.fibre_along_0 = _S269 * families_0[_S260].twist_cosine_0 - _S268 * _S261;
    var _S270 : f32 = run_share_0(_S256.shown_3.word_0);
    point_0.shown_share_0 = select(1.0f - _S270, _S270, _S256.shown_3.on_top_0);
    point_0.x_6 = _S257;
    point_0.y_1 = _S258;
    return point_0;
}

fn surface_met_0( _S271 : u32,  _S272 : f32,  _S273 : f32,  _S274 : f32,  _S275 : vec3<f32>,  _S276 : bool) -> SurfacePoint_0
{
    var _S277 : Sample_0 = sample_at_0(_S271, _S272, _S273, _S276);
    var point_1 : SurfacePoint_0 = surface_of_0(_S271, _S277, _S272, _S273, _S276);
    var _S278 : u32 = select(fabrics_0[_S271].weft_0, fabrics_0[_S271].warp_0, point_1.is_warp_1);
    var _S279 : f32 = select(_S277.crossing_1.weft_1.half_width_1, _S277.crossing_1.warp_1.half_width_1, point_1.is_warp_1) * 1.0154266357421875f;
    var _S280 : f32 = _S277.dive_1.z;
    var _S281 : f32 = _S277.slope_along_0 - (1.0f - _S280) * _S277.dive_1.y / families_0[_S278].height_scale_0;
    var _S282 : f32 = rsqrt_0(_S281 * _S281 + 1.0f);
    var _S283 : f32 = _S275.x;
    var _S284 : f32 = _S275.y;
    var _S285 : f32 = select(_S284, _S283, point_1.is_warp_1);
    var _S286 : f32 = _S275.z;
    var _S287 : f32 = (_S286 / families_0[_S278].height_scale_0 - _S281 * select(_S283, _S284, point_1.is_warp_1)) * _S282;
    var _S288 : f32 = square_0(_S279);
    var _S289 : f32 = sqrt(max(_S288 - square_0(point_1.across_2), 0.0f)) - (_S277.height_4 + _S280 * _S277.dive_1.x - _S274) / families_0[_S278].height_scale_0 * _S282;
    var _S290 : f32 = square_0(_S285) + square_0(_S287) + 9.999999960041972e-13f;
    var _S291 : f32 = point_1.across_2 * _S285 + _S289 * _S287;
    var _S292 : f32 = square_0(point_1.across_2) + square_0(_S289) - _S288;
    var _S293 : f32 = sqrt(max(square_0(_S291) - _S290 * _S292, 0.0f));
    var _S294 : f32 = clamp(select((_S293 - _S291) / _S290, - _S292 / max(_S291 + _S293, 9.999999960041972e-13f), _S291 > 0.0f), - _S279, _S279);
    var _S295 : f32 = point_1.across_2 + _S294 * _S285;
    point_1.across_2 = _S295;
    var _S296 : vec2<f32> = normalize(vec2<f32>(_S295, _S289 + _S294 * _S287));
    var _S297 : f32 = select(-1.0f, 1.0f, point_1.is_warp_1);
    var _S298 : f32 = families_0[_S278].twist_sine_0 * select(1.0f, -1.0f, _S276);
    var _S299 : f32 = _S296.x;
    var _S300 : f32 = _S298 * _S299 * _S282;
    var _S301 : f32 = _S296.y;
    var _S302 : f32 = - _S298 * _S301;
    var _S303 : f32 = families_0[_S278].twist_cosine_0 * _S282 - _S297 * _S281 * _S300;
    var _S304 : f32 = families_0[_S278].height_scale_0 * (families_0[_S278].twist_cosine_0 * _S297 * _S281 * _S282 + _S300);
    var _S305 : f32 = families_0[_S278].height_scale_0 * _S299;
    var _S306 : f32 = - families_0[_S278].height_scale_0 * _S281 * _S282 * _S301;
    point_1.normal_4 = normalize(vec3<f32>(select(_S306, _S305, point_1.is_warp_1), select(_S305, _S306, point_1.is_warp_1), _S282 * _S301));
    point_1.tangent_4 = normalize(vec3<f32>(select(- _S303, _S302, point_1.is_warp_1), select(_S302, _S303, point_1.is_warp_1), _S304));
    var _S307 : f32 = _S279 * angle_of_0(_S296);
    var _S308 : f32 = select(- _S272 - _S294 * _S283, _S273 + _S294 * _S284, point_1.is_warp_1);
    point_1.fibre_across_0 = _S307 * families_0[_S278].twist_cosine_0 + _S308 * _S298;
    point_1.fibre_along_0 = _S308 * families_0[_S278].twist_cosine_0 - _S307 * _S298;
    var _S309 : f32 = 0.00999999977648258f * _S279;
    var _S310 : f32 = - _S309;
    var _S311 : bool = _S294 < _S310;
    var _S312 : f32 = select(_S309, _S310, _S285 < 0.0f);
    var _S313 : f32 = max(_S294, 0.0f);
    point_1.x_6 = point_1.x_6 + select(_S313 * _S283, select(0.0f, _S312, point_1.is_warp_1), _S311);
    point_1.y_1 = point_1.y_1 + select(_S313 * _S284, select(_S312, 0.0f, point_1.is_warp_1), _S311);
    point_1.height_8 = select(_S274 + _S294 * _S286, _S274, _S311);
    return point_1;
}

fn surface_at_0( _S314 : u32,  _S315 : f32,  _S316 : f32,  _S317 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S314, sample_at_0(_S314, _S315, _S316, _S317), _S315, _S316, _S317);
}

fn met_from_0( _S318 : u32,  _S319 : f32,  _S320 : f32,  _S321 : f32,  _S322 : vec3<f32>,  _S323 : bool) -> u32
{
    var _S324 : f32 = fabrics_0[_S318].height_high_0;
    var _S325 : f32 = fabrics_0[_S318].height_low_0;
    var _S326 : f32 = max(fabrics_0[_S318].height_high_0 - fabrics_0[_S318].height_low_0, 9.99999997475242708e-07f);
    var _S327 : f32 = _S322.x;
    var _S328 : f32 = _S322.y;
    var _S329 : f32 = min(min(1.0f / fabrics_0[_S318].threads_per_x_0, 1.0f / fabrics_0[_S318].threads_per_y_0) / 16.0f / max(sqrt(_S327 * _S327 + _S328 * _S328), 9.99999997475242708e-07f), _S326 / 16.0f / max(abs(_S322.z), 9.99999997475242708e-07f));
    var _S330 : vec3<f32> = vec3<f32>(_S319, _S320, _S321 + fabrics_0[_S318].lift_0);
    var count_4 : u32 = u32(0);
    var place_0 : vec3<f32> = _S330;
    for(;;)
    {
        if(count_4 < u32(2048))
        {
        }
        else
        {
            break;
        }
        var place_1 : vec3<f32> = place_0 + _S322 * vec3<f32>(_S329);
        var _S331 : Sample_0 = sample_at_0(_S318, place_1.x, place_1.y, _S323);
        var _S332 : f32 = place_1.z;
        if(((!_S331.shown_3.hole_0) & ((_S332 < (_S331.height_4)))))
        {
            return (u32(4) | (select(u32(0), u32(8), _S331.shown_3.is_warp_0)));
        }
        if(((_S332 > _S324) | ((_S332 < (_S325 - _S326)))))
        {
            break;
        }
        count_4 = count_4 + u32(1);
        place_0 = place_1;
    }
    return u32(0);
}

fn unoccluded_0( _S333 : u32,  _S334 : SearchQuality_0,  _S335 : f32,  _S336 : f32,  _S337 : f32,  _S338 : vec3<f32>,  _S339 : bool) -> bool
{
    if((_S338.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S333, _S334, vec3<f32>(_S335, _S336, _S337 + fabrics_0[_S333].lift_0), _S338, _S339, max_height_along_0(_S333, _S335, _S336, _S337, _S338, _S339));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_openness(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S340 : u32 = thread_index_0(id_1);
    var _S341 : u32 = steps_0[i32(1)];
    if(_S340 >= (u32(2) * _S341))
    {
        return;
    }
    var _S342 : u32 = steps_0[i32(0)];
    var _S343 : bool = _S340 >= _S341;
    var _S344 : u32 = select(_S340, _S340 - _S341, _S343);
    var _S345 : vec3<f32> = vec3<f32>(ray_number_0(_S344, u32(2)), ray_number_0(_S344, u32(3)), ray_number_0(_S344, u32(4)));
    var _S346 : SearchQuality_0 = openness_quality_0();
    var _S347 : Hit_0 = first_hit_0(_S342, _S346, ray_number_0(_S344, u32(0)), ray_number_0(_S344, u32(1)), _S345, _S343);
    var _S348 : u32 = _S340 * u32(10);
    var k_0 : u32 = u32(0);
    for(;;)
    {
        if(k_0 < u32(10))
        {
        }
        else
        {
            break;
        }
        scratch_0[_S348 + k_0] = u32(0);
        k_0 = k_0 + u32(1);
    }
    if(_S347.hole_2)
    {
        scratch_0[_S348] = u32(2);
        return;
    }
    var _S349 : SurfacePoint_0 = surface_met_0(_S342, _S347.x_5, _S347.y_0, _S347.height_3, _S345, _S343);
    var _S350 : bool = !_S343;
    var _S351 : SurfacePoint_0 = surface_at_0(_S342, _S349.x_6, _S349.y_1, _S350);
    var _S352 : f32 = fabrics_0[_S342].diffuse_blend_0;
    var _S353 : f32 = f32(_S340);
    var _S354 : f32 = _S353 * 0.75487768650054932f;
    var _S355 : vec3<f32> = sample_diffuse_0(_S349.normal_4, fabrics_0[_S342].diffuse_blend_0, vec2<f32>(fract_of_0(_S354), fract_of_0(_S353 * 0.56984031200408936f)));
    var bits_0 : u32 = select(u32(0), u32(1), _S349.is_warp_1);
    var bits_1 : u32;
    if((dot(_S355, _S349.normal_4)) <= 0.0f)
    {
        bits_1 = (bits_0 | (((u32(4) | (select(u32(0), u32(8), _S349.is_warp_1))))));
    }
    else
    {
        bits_1 = (bits_0 | ((met_from_0(_S342, _S349.x_6, _S349.y_1, _S349.height_8, _S355, _S343))));
    }
    var _S356 : vec2<f32> = vec2<f32>(0.0f);
    var layers_0 : vec4<f32> = vec4<f32>(0.0f);
    var _S357 : f32 = families_0[fabrics_0[_S342].warp_0].roughness_0;
    var _S358 : f32 = families_0[fabrics_0[_S342].weft_0].roughness_0;
    var light_5 : u32 = u32(0);
    var halves_0 : vec2<f32> = _S356;
    var beyond_0 : f32 = 0.0f;
    for(;;)
    {
        if(light_5 < u32(16))
        {
        }
        else
        {
            break;
        }
        var _S359 : f32 = f32(light_5);
        var _S360 : f32 = (_S359 + 0.5f) / 16.0f;
        var _S361 : vec2<f32> = sine_cosine_0(6.28318548202514648f * fract_of_0(_S359 * 0.6180340051651001f + _S354));
        var _S362 : f32 = sqrt(_S360);
        var _S363 : f32 = _S362 * _S361.y;
        var _S364 : f32 = _S362 * _S361.x;
        var _S365 : f32 = sqrt(1.0f - _S360);
        var _S366 : vec3<f32> = vec3<f32>(_S363, _S364, _S365);
        var _S367 : f32 = 3.14159274101257324f / (_S365 * 16.0f);
        var _S368 : bool;
        if((dot(_S349.normal_4, _S366)) > 0.0f)
        {
            _S368 = unoccluded_0(_S342, _S346, _S349.x_6, _S349.y_1, _S349.height_8, _S366, _S343);
        }
        else
        {
            _S368 = false;
        }
        if(_S368)
        {
            var _S369 : f32 = 2.0f * _S367 * diffuse_pdf_0(_S366, _S349.normal_4, _S352);
            var halves_1 : vec2<f32> = halves_0 + select_vector_0(((light_5 & (u32(1)))) == u32(0), vec2<f32>(_S369, 0.0f), vec2<f32>(0.0f, _S369));
            layers_0[i32(0)] = layers_0[i32(0)] + _S367 * reflection_0(_S366, _S345, _S349.normal_4, _S349.tangent_4, _S357, fabrics_0[_S342].optical_depth_0);
            layers_0[i32(2)] = layers_0[i32(2)] + _S367 * reflection_0(_S366, _S345, _S349.normal_4, _S349.tangent_4, _S358, fabrics_0[_S342].optical_depth_0);
            halves_0 = halves_1;
        }
        var _S370 : bool;
        if((dot(_S351.normal_4, _S366)) > 0.0f)
        {
            _S370 = unoccluded_0(_S342, _S346, _S349.x_6, _S349.y_1, _S351.height_8, _S366, _S350);
        }
        else
        {
            _S370 = false;
        }
        if(_S370)
        {
            var _S371 : vec3<f32> = vec3<f32>(_S363, _S364, - _S365);
            var beyond_1 : f32 = beyond_0 + _S367 * diffuse_pdf_0((vec3<f32>(0) - _S371), _S349.normal_4, _S352);
            layers_0[i32(1)] = layers_0[i32(1)] + _S367 * transmission_1(_S371, _S345, _S349.normal_4, _S349.tangent_4, _S357, fabrics_0[_S342].optical_depth_0);
            layers_0[i32(3)] = layers_0[i32(3)] + _S367 * transmission_1(_S371, _S345, _S349.normal_4, _S349.tangent_4, _S358, fabrics_0[_S342].optical_depth_0);
            beyond_0 = beyond_1;
        }
        light_5 = light_5 + u32(1);
    }
    scratch_0[_S348] = bits_1;
    scratch_0[_S348 + u32(1)] = (bitcast<u32>((_S349.normal_4.z)));
    scratch_0[_S348 + u32(2)] = (bitcast<u32>((_S349.height_8)));
    scratch_0[_S348 + u32(3)] = (bitcast<u32>((halves_0.x)));
    scratch_0[_S348 + u32(4)] = (bitcast<u32>((halves_0.y)));
    scratch_0[_S348 + u32(5)] = (bitcast<u32>((beyond_0)));
    k_0 = u32(0);
    for(;;)
    {
        if(k_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        scratch_0[_S348 + u32(6) + k_0] = (bitcast<u32>((layers_0[k_0])));
        k_0 = k_0 + u32(1);
    }
    return;
}

