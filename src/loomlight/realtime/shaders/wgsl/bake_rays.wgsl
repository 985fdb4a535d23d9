struct Bake_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) per_family_0 : u32,
    @align(4) packs_0 : u32,
    @align(4) max_clusters_0 : u32,
    @align(4) rays_0 : u32,
    @align(4) ends_0 : f32,
    @align(4) picks_0 : f32,
    @align(4) spacing_x_0 : f32,
    @align(4) spacing_y_0 : f32,
    @align(4) columns_0 : u32,
    @align(4) rows_0 : u32,
    @align(4) face_nodes_0 : u32,
    @align(4) texels_across_0 : u32,
    @align(4) texels_along_0 : u32,
    @align(4) texel_x_0 : f32,
    @align(4) texel_y_0 : f32,
    @align(4) far_weight_0 : f32,
    @align(4) moments_table_0 : u32,
    @align(4) record_warp_packs_0 : u32,
    @align(4) record_hole_weights_0 : u32,
    @align(4) facts_0 : u32,
    @align(4) gaps_0 : u32,
    @align(4) gap_nulls_0 : u32,
    @align(4) lit_0 : u32,
    @align(4) lists_0 : u32,
    @align(4) points_0 : u32,
    @align(4) clusters_0 : u32,
    @align(4) cluster_means_0 : u32,
    @align(4) cluster_errors_0 : u32,
    @align(4) centroids_0 : u32,
    @align(4) view_sums_0 : u32,
    @align(4) light_sums_0 : u32,
    @align(4) group_moments_0 : u32,
    @align(4) areas_0 : u32,
    @align(4) area_scales_0 : u32,
    @align(4) row_totals_0 : u32,
    @align(4) row_largest_0 : u32,
    @align(4) coverage_means_0 : u32,
    @align(4) coverage_scales_0 : u32,
    @align(4) hole_bytes_0 : u32,
};

@binding(11) @group(0) var<storage, read> bakes_0 : array<Bake_std430_0>;

struct Lobes_std430_0
{
    @align(4) is_baked_0 : u32,
    @align(4) inverse_base_size_0 : f32,
    @align(4) last_level_0 : f32,
    @align(4) levels_0 : u32,
    @align(4) face_nodes_1 : u32,
    @align(4) packs_1 : u32,
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
    @align(4) ends_1 : f32,
    @align(4) picks_1 : f32,
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
    @align(4) is_apart_0 : u32,
};

struct Clustered_std430_0
{
    @align(4) is_baked_1 : u32,
    @align(4) clusters_1 : u32,
    @align(4) rank_0 : u32,
    @align(4) channels_0 : u32,
    @align(4) columns_1 : u32,
    @align(4) rows_1 : u32,
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
    @align(4) ends_2 : u32,
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
    @align(4) seed_0 : u32,
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

struct SurfaceHit_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) flags_0 : u32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) tangent_x_0 : f32,
    @align(4) tangent_y_0 : f32,
    @align(4) tangent_z_0 : f32,
    @align(4) shown_share_0 : f32,
};

@binding(13) @group(0) var<storage, read_write> hits_0 : array<SurfaceHit_std430_0>;

@binding(14) @group(0) var<storage, read_write> scratch_0 : array<u32>;

@binding(15) @group(0) var<storage, read_write> texel_counters_0 : array<atomic<u32>>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec3<f32>,  no_0 : vec3<f32>) -> vec3<f32>
{
    var chosen_0 : vec3<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
    return chosen_0;
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

var<private> RING_COSINES_0 : array<f32, i32(8)> = array<f32, i32(8)>( 1.0f, 0.92756068706512451f, 0.81746435165405273f, 0.68657326698303223f, 0.54003900289535522f, 0.38065254688262939f, 0.21021415293216705f, 0.02999999932944775f );
fn rsqrt_0( x_1 : f32) -> f32
{
    return 1.0f / sqrt(x_1);
}

fn thread_index_0( id_0 : vec3<u32>) -> u32
{
    return id_0.y * u32(2097152) + id_0.x;
}

fn fraction_of_0( whole_0 : u32) -> f32
{
    return f32((whole_0 >> (u32(8)))) * 5.9604644775390625e-08f;
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

fn square_0( x_2 : f32) -> f32
{
    return x_2 * x_2;
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

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
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
    var _S35 : f32 = 1.0f / max(2.0f * _S31, 9.999999960041972e-13f);
    var _S36 : f32 = clamp((_S31 - _S30) * _S35, 0.0f, 1.0f);
    return vec2<f32>(_S33 + (_S34 - _S33) * (_S36 * _S36 * (3.0f - 2.0f * _S36)), (_S33 - _S34) * (6.0f * _S36 * (1.0f - _S36) * _S35) * select(-1.0f, 1.0f, _S29));
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S37 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S38 : f32 = rsqrt_0(_S37);
    var _S39 : f32 = sine_1 * _S38 * rsqrt_0(_S37 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S39 * _S37, _S39 * across_slope_0 * along_slope_0 + cosine_0 * _S38);
}

fn arc_sine_0( x_3 : f32) -> f32
{
    var _S40 : f32 = abs(x_3);
    var _S41 : bool = _S40 > 0.5f;
    var _S42 : f32 = select(_S40 * _S40, 0.5f * (1.0f - _S40), _S41);
    var _S43 : f32 = select(_S40, sqrt(max(_S42, 0.0f)), _S41);
    var _S44 : f32 = ((((0.04216320067644119f * _S42 + 0.02418131195008755f) * _S42 + 0.04547002539038658f) * _S42 + 0.07495300471782684f) * _S42 + 0.16666752099990845f) * _S42 * _S43 + _S43;
    var _S45 : f32 = select(_S44, 1.57079637050628662f - 2.0f * _S44, _S41);
    return select(_S45, - _S45, x_3 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S46 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S46 / (_S46 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

struct SurfaceHit_0
{
     x_0 : f32,
     y_0 : f32,
     flags_0 : u32,
     normal_x_0 : f32,
     normal_y_0 : f32,
     normal_z_0 : f32,
     tangent_x_0 : f32,
     tangent_y_0 : f32,
     tangent_z_0 : f32,
     shown_share_0 : f32,
};

struct SurfacePoint_0
{
     hole_1 : bool,
     is_warp_1 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_1 : f32,
     normal_0 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     shown_share_1 : f32,
};

fn hit_of_0( point_0 : SurfacePoint_0,  x_4 : f32,  y_1 : f32) -> SurfaceHit_0
{
    var hit_0 : SurfaceHit_0;
    hit_0.x_0 = x_4;
    hit_0.y_0 = y_1;
    hit_0.flags_0 = (select(u32(0), u32(1), point_0.is_warp_1) | (select(u32(0), u32(2), point_0.hole_1)));
    hit_0.normal_x_0 = point_0.normal_0.x;
    hit_0.normal_y_0 = point_0.normal_0.y;
    hit_0.normal_z_0 = point_0.normal_0.z;
    hit_0.tangent_x_0 = point_0.tangent_0.x;
    hit_0.tangent_y_0 = point_0.tangent_0.y;
    hit_0.tangent_z_0 = point_0.tangent_0.z;
    hit_0.shown_share_0 = point_0.shown_share_1;
    return hit_0;
}

fn sample_position_0( _S47 : i32,  _S48 : u32,  _S49 : u32) -> vec2<f32>
{
    return vec2<f32>((floor(fraction_of_0(_S48 * u32(2700274806) + u32(1350137403) + _S49 * u32(3152041523)) * bakes_0[_S47].ends_0) + fraction_of_0(_S48 * u32(3679390609) + u32(1839695304) + _S49 * u32(2313257605))) * bakes_0[_S47].spacing_x_0, (floor(fraction_of_0(_S48 * u32(2313257605) + u32(1156628802) + _S49 * u32(3679390609)) * bakes_0[_S47].picks_0) + fraction_of_0(_S48 * u32(3152041523) + u32(1576020761) + _S49 * u32(2700274806))) * bakes_0[_S47].spacing_y_0);
}

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_2 : Shown_0,
     run_2 : Run_0,
     section_1 : Section_0,
     height_2 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_0 : f32,
     slope_y_0 : f32,
};

fn crossing_at_0( _S50 : u32,  _S51 : f32,  _S52 : f32,  _S53 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S50].warp_0, _S51);
    crossing_2.weft_1 = locate_0(fabrics_0[_S50].weft_0, _S52);
    var _S54 : u32 = fabrics_0[_S50].run_words_0 + u32(2) * (crossing_2.weft_1.thread_0 * fabrics_0[_S50].ends_2 + crossing_2.warp_1.thread_0);
    var _S55 : u32 = words_0[_S54];
    crossing_2.warp_word_0 = _S55;
    crossing_2.weft_word_0 = words_0[_S54 + u32(1)];
    crossing_2.warp_above_0 = (((_S55 & (u32(1)))) == u32(1)) != _S53;
    return crossing_2;
}

fn sample_at_0( _S56 : u32,  _S57 : f32,  _S58 : f32,  _S59 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S60 : Crossing_0 = crossing_at_0(_S56, _S57, _S58, _S59);
    sample_0.crossing_1 = _S60;
    var _S61 : Shown_0 = shown_at_0(_S60, _S59);
    sample_0.shown_2 = _S61;
    var _S62 : u32 = select(fabrics_0[_S56].weft_0, fabrics_0[_S56].warp_0, _S61.is_warp_0);
    var _S63 : u32 = select(fabrics_0[_S56].warp_0, fabrics_0[_S56].weft_0, _S61.is_warp_0);
    var _S64 : Cell_0 = select_cell_0(_S61.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S65 : Cell_0 = select_cell_0(_S61.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S66 : Run_0 = unpack_0(_S62, _S63, _S64.thread_0, _S65, _S61.word_0);
    var _S67 : Section_0 = section_at_0(_S64);
    var _S68 : bool = ((_S61.on_top_0) & (((_S66.distance_0) < (_S67.drop_0 * _S66.bend_1.sine_0))));
    var _S69 : f32 = select(-1.0f, 1.0f, ((_S61.on_top_0) & ((!_S68))));
    var _S70 : f32 = select(_S66.reach_0, _S66.other_reach_0, _S68);
    var _S71 : f32 = select(max(_S70 - _S66.distance_0, 0.0f), _S70 + _S66.distance_0, _S68);
    var _S72 : f32 = _S70 / _S66.bend_1.sine_0 - _S69 * _S67.drop_0;
    var _S73 : f32 = _S71 * _S71;
    var _S74 : f32 = max(_S72 * _S72 - _S73, 9.99999968265522539e-21f);
    var _S75 : f32 = rsqrt_0(_S74);
    var _S76 : f32 = _S73 / (_S74 * _S75 + _S72);
    var _S77 : bool = _S71 > 0.0f;
    var _S78 : f32 = select(-1.0f, 1.0f, _S61.on_top_0) * select(-1.0f, 1.0f, _S66.near_start_0);
    var _S79 : f32 = _S67.slope_0 * select(1.0f, _S72 * _S75, _S77);
    sample_0.slope_across_0 = _S79;
    var _S80 : f32 = select(0.0f, _S78 * _S71 * _S75, _S77);
    sample_0.slope_along_0 = _S80;
    var _S81 : vec2<f32> = dive_0(_S63, _S61, _S66, _S65);
    sample_0.height_2 = select(families_0[_S62].height_scale_0 * _S69, 0.0f, _S66.straight_0) * (_S70 * _S66.bend_1.half_tangent_0 - _S76) - families_0[_S62].height_scale_0 * _S67.drop_0 - _S81.x;
    var _S82 : f32 = families_0[_S62].height_scale_0 * _S79;
    var _S83 : f32 = families_0[_S62].height_scale_0 * _S80 - _S81.y;
    sample_0.slope_x_0 = select(_S83, _S82, _S61.is_warp_0);
    sample_0.slope_y_0 = select(_S82, _S83, _S61.is_warp_0);
    sample_0.run_2 = _S66;
    sample_0.section_1 = _S67;
    return sample_0;
}

fn surface_at_0( _S84 : u32,  _S85 : f32,  _S86 : f32,  _S87 : bool) -> SurfacePoint_0
{
    var _S88 : Sample_0 = sample_at_0(_S84, _S85, _S86, _S87);
    var _S89 : u32 = select(fabrics_0[_S84].weft_0, fabrics_0[_S84].warp_0, _S88.shown_2.is_warp_0);
    var _S90 : f32 = families_0[_S89].twist_sine_0 * select(1.0f, -1.0f, _S87);
    var _S91 : f32 = select(-1.0f, 1.0f, _S88.shown_2.is_warp_0);
    var _S92 : vec2<f32> = fibre_direction_0(_S88.slope_across_0, _S91 * _S88.slope_along_0, _S90, families_0[_S89].twist_cosine_0);
    var _S93 : f32 = _S92.x;
    var _S94 : f32 = _S92.y;
    var _S95 : f32 = select(_S88.slope_y_0, _S88.slope_x_0, _S88.shown_2.is_warp_0) * _S93 + _S91 * select(_S88.slope_x_0, _S88.slope_y_0, _S88.shown_2.is_warp_0) * _S94;
    var _S96 : f32 = select(_S88.crossing_1.weft_1.half_width_1, _S88.crossing_1.warp_1.half_width_1, _S88.shown_2.is_warp_0) * 1.0154266357421875f;
    var _S97 : f32 = _S96 * arc_sine_0(clamp(_S88.section_1.across_1 / _S96, -1.0f, 1.0f));
    var _S98 : f32 = select(- _S85, _S86, _S88.shown_2.is_warp_0);
    var point_1 : SurfacePoint_0;
    point_1.hole_1 = _S88.shown_2.hole_0;
    point_1.is_warp_1 = _S88.shown_2.is_warp_0;
    point_1.warp_thread_0 = _S88.crossing_1.warp_1.thread_0;
    point_1.weft_thread_0 = _S88.crossing_1.weft_1.thread_0;
    point_1.height_1 = _S88.height_2;
    point_1.normal_0 = normalize(vec3<f32>(- _S88.slope_x_0, - _S88.slope_y_0, 1.0f));
    point_1.tangent_0 = normalize(select_vector_0(_S88.shown_2.is_warp_0, vec3<f32>(_S93, _S94, _S95), vec3<f32>(- _S94, _S93, _S95)));
    point_1.across_2 = _S88.section_1.across_1;
    point_1.fibre_across_0 = _S97 * families_0[_S89].twist_cosine_0 + _S98 * _S90;
    point_1.fibre_along_0 = _S98 * families_0[_S89].twist_cosine_0 - _S97 * _S90;
    var _S99 : f32 = run_share_0(_S88.shown_2.word_0);
    point_1.shown_share_1 = select(1.0f - _S99, _S99, _S88.shown_2.on_top_0);
    return point_1;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_top_down(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S100 : u32 = thread_index_0(id_1);
    if(_S100 >= u32(16384))
    {
        return;
    }
    var _S101 : vec2<f32> = sample_position_0(i32(0), (_S100 & (u32(8191))), u32(0));
    var _S102 : f32 = _S101.x;
    var _S103 : f32 = _S101.y;
    var _S104 : SurfaceHit_0 = hit_of_0(surface_at_0(bakes_0[i32(0)].fabric_0, _S102, _S103, _S100 >= u32(8192)), _S102, _S103);
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].x_0 = _S104.x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].y_0 = _S104.y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].flags_0 = _S104.flags_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].normal_x_0 = _S104.normal_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].normal_y_0 = _S104.normal_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].normal_z_0 = _S104.normal_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].tangent_x_0 = _S104.tangent_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].tangent_y_0 = _S104.tangent_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].tangent_z_0 = _S104.tangent_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S100].shown_share_0 = _S104.shown_share_0;
    return;
}

struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn bake_quality_0() -> SearchQuality_0
{
    var quality_0 : SearchQuality_0;
    quality_0.steps_per_thread_0 = 2.5f;
    quality_0.steps_per_relief_0 = 2.5f;
    quality_0.shadow_share_0 = 1.60000002384185791f;
    quality_0.refinements_0 = u32(1);
    return quality_0;
}

fn sine_cosine_0( x_5 : f32) -> vec2<f32>
{
    var _S105 : f32 = floor(x_5 * 0.63661974668502808f + 0.5f);
    var _S106 : f32 = x_5 - _S105 * 1.5703125f - _S105 * 0.00048375129699707f - _S105 * 7.54979012640433211e-08f;
    var _S107 : f32 = _S106 * _S106;
    var _S108 : f32 = ((-0.00019515295571182f * _S107 + 0.00833216123282909f) * _S107 - 0.16666655242443085f) * _S107 * _S106 + _S106;
    var _S109 : f32 = ((0.00002443315679557f * _S107 - 0.00138873164542019f) * _S107 + 0.04166664555668831f) * _S107 * _S107 - 0.5f * _S107 + 1.0f;
    var _S110 : u32 = (u32(i32(_S105)) & (u32(3)));
    var _S111 : vec2<f32> = select_vector_1(((_S110 & (u32(1)))) != u32(0), vec2<f32>(_S109, _S108), vec2<f32>(_S108, _S109));
    var _S112 : f32 = _S111.x;
    var _S113 : f32 = _S111.y;
    return vec2<f32>(select(_S112, - _S112, ((_S110 & (u32(2)))) != u32(0)), select(_S113, - _S113, (((_S110 + u32(1)) & (u32(2)))) != u32(0)));
}

fn node_direction_0( node_0 : u32) -> vec3<f32>
{
    var _S114 : u32 = node_0 % u32(8);
    var _S115 : vec2<f32> = sine_cosine_0(f32(node_0 / u32(8)) * 0.19634954631328583f);
    var _S116 : f32 = sqrt(1.0f - RING_COSINES_0[_S114] * RING_COSINES_0[_S114]);
    return vec3<f32>(_S116 * _S115.y, _S116 * _S115.x, RING_COSINES_0[_S114]);
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
    var _S117 : f32 = direction_0.x;
    control_0.per_x_0 = 1.0f / max(abs(_S117), 9.99999971718068537e-10f);
    var _S118 : f32 = direction_0.y;
    control_0.per_y_0 = 1.0f / max(abs(_S118), 9.99999971718068537e-10f);
    control_0.right_0 = _S117 > 0.0f;
    control_0.up_0 = _S118 > 0.0f;
    return control_0;
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_0 : ViewRay_0,  height_3 : f32) -> vec2<f32>
{
    return this_0.origin_0 + this_0.slope_1 * vec2<f32>(height_3);
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_0 : f32,  side_y_0 : f32) -> f32
{
    return max(min(side_x_0 * this_1.per_x_0, side_y_0 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
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

fn outline_distance_0( cell_4 : Cell_0,  shown_3 : Shown_0,  run_3 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S119 : f32 = select(- cell_4.across_0, cell_4.across_0, forwards_0);
    var _S120 : f32 = select(cell_4.below_0, cell_4.above_0, forwards_0);
    var _S121 : f32 = - cell_4.half_width_1;
    var _S122 : bool = _S119 < _S121;
    var _S123 : bool = _S119 >= (cell_4.half_width_1);
    var _S124 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_0))))) & ((!shown_3.hole_0)));
    var _S125 : f32 = select(cell_4.half_width_1, _S121, _S122) - _S119;
    var _S126 : f32 = select(_S120, 2.0f * _S120 + _S119 - cell_4.half_width_1, ((shown_3.hole_0) | (((_S124 & ((!shown_3.on_top_0)))))));
    if((((_S124 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_0) & (_S122)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_0);
    }
    return select(_S125, _S126, _S123);
}

struct Probe_0
{
     height_4 : f32,
     hole_2 : bool,
     slope_x_1 : f32,
     slope_y_1 : f32,
     yarn_1 : u32,
     cell_max_0 : f32,
     side_x_1 : f32,
     side_y_1 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
};

fn ViewRay_rate_0( this_2 : ViewRay_0,  here_0 : Probe_0) -> f32
{
    return here_0.slope_x_1 * this_2.slope_1.x + here_0.slope_y_1 * this_2.slope_1.y - 1.0f;
}

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_1 : Probe_0) -> f32
{
    var _S127 : f32 = previous_1.rate_0 * step_4;
    var _S128 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_1.hole_2)))) | (((previous_1.yarn_0) != (here_1.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S127) >= 0.0f) & (((3.0f * clearance_1 - _S128) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S129 : f32 = clearance_1 - previous_1.clearance_0;
    var _S130 : f32 = 6.0f * _S129 - 4.0f * _S127 - 2.0f * _S128;
    var _S131 : f32 = -2.0f * _S127 / max(_S130 + sqrt(max(_S130 * _S130 - 4.0f * (3.0f * (_S127 + _S128 - 2.0f * _S129)) * _S127, 0.0f)), 9.99999968265522539e-21f);
    var _S132 : f32 = 1.0f - _S131;
    return select(-1.0f, _S132 * step_4, ((((_S131 > 0.01999999955296516f) & ((_S132 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S131 + 1.0f) + _S127 * _S131) * _S132 * _S132 + (clearance_1 * (2.0f * _S132 + 1.0f) - _S128 * _S132) * _S131 * _S131) < 0.0f))));
}

fn StepControl_to_next_sample_0( this_3 : StepControl_0,  here_2 : Probe_0,  clearance_2 : f32,  rate_2 : f32) -> f32
{
    var _S133 : f32 = min(here_2.edge_x_0 * this_3.per_x_0, here_2.edge_y_0 * this_3.per_y_0);
    return min(this_3.step_2, select(max(_S133, 0.0f) + this_3.epsilon_0, _S133 - this_3.epsilon_0, ((((!here_2.hole_2) & (((rate_2 * _S133 + clearance_2) < 0.0f)))) & ((_S133 > (2.0f * this_3.epsilon_0))))));
}

fn after_sample_0( clearance_3 : f32,  rate_3 : f32,  here_3 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_3, 1.0e+09f, here_3.hole_2);
    previous_2.rate_0 = rate_3;
    previous_2.yarn_0 = here_3.yarn_1;
    previous_2.known_0 = ((!here_3.hole_2) & ((!is_cell_exit_0)));
    return previous_2;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S134 : f32 = end_0 - start_1;
    var _S135 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S134;
    var _S136 : f32 = 3.0f * _S134 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S134, 9.99999968265522539e-21f);
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
        var _S137 : f32 = clamp(share_0 - (((_S135 * share_0 + _S136) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S135 * share_0 + 2.0f * _S136) * share_0 + start_rate_0, 0.10000000149011612f * _S134 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S138 : i32 = i_0 + i32(1);
        share_0 = _S137;
        i_0 = _S138;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn lattice_position_0( _S139 : i32,  _S140 : u32,  _S141 : u32) -> vec2<f32>
{
    var _S142 : u32 = u32(4294967295) / bakes_0[_S139].rays_0;
    return vec2<f32>(fraction_of_0(_S140 * _S142 + _S141 * u32(3242174889)) * (bakes_0[_S139].ends_0 * bakes_0[_S139].spacing_x_0), fraction_of_0(_S140 * u32(2654435769) + _S141 * u32(3488053409)) * (bakes_0[_S139].picks_0 * bakes_0[_S139].spacing_y_0));
}

struct Hit_0
{
     x_6 : f32,
     y_2 : f32,
     hole_3 : bool,
     height_5 : f32,
};

fn steps_per_length_0( _S143 : u32,  _S144 : SearchQuality_0,  _S145 : vec3<f32>) -> f32
{
    return max(max(abs(_S145.x) * fabrics_0[_S143].threads_per_x_0, abs(_S145.y) * fabrics_0[_S143].threads_per_y_0) * _S144.steps_per_thread_0, abs(_S145.z) * fabrics_0[_S143].per_relief_0 * _S144.steps_per_relief_0);
}

struct ViewRayEnd_0
{
     height_6 : f32,
     last_step_0 : f32,
     depth_0 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_3 : PreviousSample_0,
};

fn max_height_along_0( _S146 : u32,  _S147 : f32,  _S148 : f32,  _S149 : f32,  _S150 : vec3<f32>,  _S151 : bool) -> f32
{
    var _S152 : f32 = _S150.x;
    var _S153 : f32 = _S150.y;
    var _S154 : u32 = (words_0[fabrics_0[_S146].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S146].weft_0, _S148).thread_0 / u32(2) * fabrics_0[_S146].max_height_columns_0 + locate_0(fabrics_0[_S146].warp_0, _S147).thread_0 / u32(2)) + (select(u32(0), u32(1), _S152 > 0.0f) + select(u32(0), u32(2), _S153 > 0.0f))] >> (u32(select(i32(0), i32(4), _S151))));
    var _S155 : f32 = max(abs(_S152) * fabrics_0[_S146].threads_per_x_0, abs(_S153) * fabrics_0[_S146].threads_per_y_0) / _S150.z;
    var _S156 : f32 = fabrics_0[_S146].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S146].height_high_0;
    var number_0 : i32 = i32(3);
    for(;;)
    {
        if(number_0 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S149) * _S155) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S154 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S156);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_maximum_0( _S157 : u32,  _S158 : Crossing_0) -> f32
{
    var _S159 : u32 = select(fabrics_0[_S157].weft_0, fabrics_0[_S157].warp_0, _S158.warp_above_0);
    return f32((select(_S158.weft_word_0, _S158.warp_word_0, _S158.warp_above_0) >> (u32(28)))) * families_0[_S159].height_scale_0 * families_0[_S159].level_0;
}

fn cell_bounds_0( _S160 : u32,  _S161 : f32,  _S162 : f32,  _S163 : bool,  _S164 : bool,  _S165 : bool) -> vec3<f32>
{
    var _S166 : Crossing_0 = crossing_at_0(_S160, _S161, _S162, _S163);
    return vec3<f32>(cell_maximum_0(_S160, _S166), select(_S166.warp_1.below_0, _S166.warp_1.above_0, _S164), select(_S166.weft_1.below_0, _S166.weft_1.above_0, _S165));
}

fn first_sample_height_0( _S167 : u32,  _S168 : ViewRay_0,  _S169 : StepControl_0,  _S170 : bool) -> f32
{
    var _S171 : f32 = max_height_along_0(_S167, _S168.origin_0.x, _S168.origin_0.y, 0.0f, vec3<f32>(_S168.slope_1, 1.0f), _S170);
    var count_1 : u32 = u32(0);
    var height_7 : f32 = _S171;
    for(;;)
    {
        if(count_1 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S172 : vec2<f32> = ViewRay_at_0(_S168, height_7);
        var _S173 : vec3<f32> = cell_bounds_0(_S167, _S172.x, _S172.y, _S170, _S169.right_0, _S169.up_0);
        var _S174 : f32 = height_7 - _S173.x;
        var _S175 : f32 = StepControl_to_cell_exit_0(_S169, _S173.y, _S173.z);
        var height_8 : f32 = height_7 - clamp(_S174, 0.0f, _S175);
        if(_S174 <= _S175)
        {
            height_7 = height_8;
            break;
        }
        count_1 = count_1 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn probe_0( _S176 : u32,  _S177 : f32,  _S178 : f32,  _S179 : bool,  _S180 : bool,  _S181 : bool) -> Probe_0
{
    var _S182 : Sample_0 = sample_at_0(_S176, _S177, _S178, _S179);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S182.height_2;
    probe_1.hole_2 = _S182.shown_2.hole_0;
    probe_1.slope_x_1 = _S182.slope_x_0;
    probe_1.slope_y_1 = _S182.slope_y_0;
    probe_1.yarn_1 = select(_S182.crossing_1.weft_1.thread_0 * u32(2), _S182.crossing_1.warp_1.thread_0 * u32(2) + u32(1), _S182.shown_2.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S176, _S182.crossing_1);
    probe_1.side_x_1 = select(_S182.crossing_1.warp_1.below_0, _S182.crossing_1.warp_1.above_0, _S180);
    probe_1.side_y_1 = select(_S182.crossing_1.weft_1.below_0, _S182.crossing_1.weft_1.above_0, _S181);
    probe_1.edge_x_0 = outline_distance_0(_S182.crossing_1.warp_1, _S182.shown_2, _S182.run_2, !_S182.shown_2.is_warp_0, _S180);
    probe_1.edge_y_0 = outline_distance_0(_S182.crossing_1.weft_1, _S182.shown_2, _S182.run_2, _S182.shown_2.is_warp_0, _S181);
    return probe_1;
}

fn search_down_0( _S183 : u32,  _S184 : ViewRay_0,  _S185 : StepControl_0,  _S186 : bool) -> ViewRayEnd_0
{
    var _S187 : f32 = fabrics_0[_S183].height_low_0 - (fabrics_0[_S183].height_high_0 - fabrics_0[_S183].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S183, _S184, _S185, _S186);
    end_1.last_step_0 = _S185.epsilon_0;
    end_1.previous_3 = no_previous_sample_0();
    end_1.depth_0 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_2 : u32 = u32(0);
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S188 : vec2<f32> = ViewRay_at_0(_S184, end_1.height_6);
        var _S189 : Probe_0 = probe_0(_S183, _S188.x, _S188.y, _S186, _S185.right_0, _S185.up_0);
        var _S190 : f32 = end_1.height_6 - _S189.height_4;
        var _S191 : f32 = ViewRay_rate_0(_S184, _S189);
        end_1.depth_0 = - _S190;
        end_1.rate_4 = _S191;
        var _S192 : bool = !_S189.hole_2;
        end_1.smooth_0 = ((((end_1.previous_3.known_0) & (_S192))) & (((end_1.previous_3.yarn_0) == (_S189.yarn_1))));
        if((((_S192 & ((_S190 <= 0.0f)))) | (((end_1.height_6) <= _S187))))
        {
            break;
        }
        var _S193 : f32 = way_back_to_dip_0(end_1.previous_3, _S190, _S191, end_1.last_step_0, _S189);
        if(_S193 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S193;
            end_1.last_step_0 = end_1.last_step_0 - _S193;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S194 : f32 = min(StepControl_to_cell_exit_0(_S185, _S189.side_x_1, _S189.side_y_1), end_1.height_6 - _S189.cell_max_0);
        var _S195 : f32 = StepControl_to_next_sample_0(_S185, _S189, _S190, _S191);
        end_1.previous_3 = after_sample_0(_S190, _S191, _S189, _S194 > _S195);
        var _S196 : f32 = max(_S194, _S195);
        end_1.last_step_0 = _S196;
        end_1.height_6 = end_1.height_6 - _S196;
        count_2 = count_2 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S197 : u32,  _S198 : ViewRay_0,  _S199 : StepControl_0,  _S200 : bool,  _S201 : ViewRayEnd_0,  _S202 : u32) -> f32
{
    var _S203 : f32 = fabrics_0[_S197].height_high_0 - fabrics_0[_S197].height_low_0;
    var above_2 : f32 = _S201.height_6 + _S201.last_step_0;
    var above_gap_1 : f32 = clamp(_S201.previous_3.clearance_0, 0.0f, _S203);
    var under_gap_1 : f32 = clamp(_S201.depth_0, 0.0f, _S203);
    var middle_0 : f32 = select(between_0(above_2, _S201.height_6, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S201.previous_3.rate_0 * _S201.last_step_0, _S201.rate_4 * _S201.last_step_0) * _S201.last_step_0, _S201.smooth_0);
    var side_0 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S201.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S202)
        {
        }
        else
        {
            break;
        }
        var _S204 : vec2<f32> = ViewRay_at_0(_S198, middle_0);
        var _S205 : Probe_0 = probe_0(_S197, _S204.x, _S204.y, _S200, _S199.right_0, _S199.up_0);
        var _S206 : f32 = clamp(middle_0 - select(_S205.height_4, -1.0e+09f, _S205.hole_2), - _S203, _S203);
        if(_S206 <= 0.0f)
        {
            var _S207 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_0 > 0.0f);
            var _S208 : f32 = - _S206;
            under_1 = middle_0;
            above_gap_2 = _S207;
            under_gap_2 = _S208;
            side_0 = 1.0f;
        }
        else
        {
            var _S209 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_0 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S206;
            under_gap_2 = _S209;
            side_0 = -1.0f;
        }
        var _S210 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S206 / min(ViewRay_rate_0(_S198, _S205), -9.99999997475242708e-07f), under_1, above_3), _S201.smooth_0);
        var _S211 : u32 = i_1 + u32(1);
        middle_0 = _S210;
        i_1 = _S211;
    }
    return select(under_1, middle_0, _S201.smooth_0);
}

fn first_hit_of_yarn_0( _S212 : u32,  _S213 : SearchQuality_0,  _S214 : f32,  _S215 : f32,  _S216 : vec3<f32>,  _S217 : bool) -> Hit_0
{
    var _S218 : f32 = max(_S216.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S214, _S215);
    var _S219 : vec2<f32> = _S216.xy / vec2<f32>(_S218);
    ray_0.slope_1 = _S219;
    var _S220 : StepControl_0 = step_control_0((vec2<f32>(0) - _S219), 1.0f / max(steps_per_length_0(_S212, _S213, _S216) / _S218, 9.99999971718068537e-10f));
    var _S221 : ViewRayEnd_0 = search_down_0(_S212, ray_0, _S220, _S217);
    var hit_1 : Hit_0;
    hit_1.hole_3 = false;
    var _S222 : f32 = refined_height_0(_S212, ray_0, _S220, _S217, _S221, _S213.refinements_0);
    hit_1.height_5 = _S222;
    var _S223 : vec2<f32> = ViewRay_at_0(ray_0, _S222);
    hit_1.x_6 = _S223.x;
    hit_1.y_2 = _S223.y;
    return hit_1;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_views(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    var _S224 : u32 = thread_index_0(id_2);
    var _S225 : u32 = bakes_0[i32(0)].rays_0;
    var _S226 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    if(_S224 >= (u32(2) * _S226))
    {
        return;
    }
    var _S227 : u32 = bakes_0[i32(0)].fabric_0;
    var _S228 : bool = _S224 >= _S226;
    var _S229 : u32 = select(_S224, _S224 - _S226, _S228);
    var _S230 : u32 = _S229 / _S225;
    var _S231 : u32 = _S229 % _S225;
    var _S232 : vec2<f32> = lattice_position_0(i32(0), _S231, _S230);
    var _S233 : Hit_0 = first_hit_of_yarn_0(_S227, bake_quality_0(), _S232.x, _S232.y, node_direction_0(_S230), _S228);
    var hit_2 : SurfaceHit_0 = hit_of_0(surface_at_0(_S227, _S233.x_6, _S233.y_2, _S228), _S233.x_6, _S233.y_2);
    hit_2.flags_0 = ((hit_2.flags_0) | (select(u32(0), u32(4), (_S233.height_5) <= 0.0f)));
    hits_0[_S224].x_0 = hit_2.x_0;
    hits_0[_S224].y_0 = hit_2.y_0;
    hits_0[_S224].flags_0 = hit_2.flags_0;
    hits_0[_S224].normal_x_0 = hit_2.normal_x_0;
    hits_0[_S224].normal_y_0 = hit_2.normal_y_0;
    hits_0[_S224].normal_z_0 = hit_2.normal_z_0;
    hits_0[_S224].tangent_x_0 = hit_2.tangent_x_0;
    hits_0[_S224].tangent_y_0 = hit_2.tangent_y_0;
    hits_0[_S224].tangent_z_0 = hit_2.tangent_z_0;
    hits_0[_S224].shown_share_0 = hit_2.shown_share_0;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_gap_starts(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    var _S234 : u32 = thread_index_0(id_3);
    var _S235 : u32 = bakes_0[i32(0)].rays_0;
    var _S236 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    var _S237 : bool;
    if(_S234 >= (u32(2) * _S236))
    {
        _S237 = true;
    }
    else
    {
        _S237 = (((hits_0[_S234].flags_0) & (u32(4)))) == u32(0);
    }
    if(_S237)
    {
        return;
    }
    var _S238 : u32 = bakes_0[i32(0)].fabric_0;
    var _S239 : bool = _S234 >= _S236;
    var _S240 : u32 = select(_S234, _S234 - _S236, _S239);
    var _S241 : u32 = _S240 % _S235;
    var _S242 : u32 = _S240 / _S235;
    var _S243 : vec2<f32> = lattice_position_0(i32(0), _S241, _S242);
    if(!shown_at_0(crossing_at_0(_S238, _S243.x, _S243.y, _S239), _S239).hole_0)
    {
        hits_0[_S234].flags_0 = ((hits_0[_S234].flags_0) & (u32(4294967291)));
    }
    return;
}

fn scratch_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((scratch_0[index_2])));
}

fn is_free_0( _S244 : u32,  _S245 : SearchQuality_0,  _S246 : vec3<f32>,  _S247 : vec3<f32>,  _S248 : bool,  _S249 : f32) -> bool
{
    var _S250 : f32 = _S247.z;
    if(_S250 <= 0.0f)
    {
        return false;
    }
    var _S251 : f32 = 1.0f / max(_S245.shadow_share_0 * steps_per_length_0(_S244, _S245, _S247), 9.99999971718068537e-10f);
    var _S252 : StepControl_0 = step_control_0(_S247.xy, _S251);
    var previous_4 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_1 : f32 = 0.0f;
    for(;;)
    {
        if(((count_3 < u32(1024)) & (((_S246.z + _S250 * distance_1) < _S249))))
        {
        }
        else
        {
            break;
        }
        var _S253 : vec3<f32> = _S246 + _S247 * vec3<f32>(distance_1);
        var _S254 : Probe_0 = probe_0(_S244, _S253.x, _S253.y, _S248, _S252.right_0, _S252.up_0);
        var _S255 : f32 = _S253.z;
        var _S256 : f32 = _S255 - _S254.height_4;
        var _S257 : f32 = _S250 - _S254.slope_x_1 * _S247.x - _S254.slope_y_1 * _S247.y;
        if(((!_S254.hole_2) & ((_S256 < 0.0f))))
        {
            return false;
        }
        var _S258 : f32 = way_back_to_dip_0(previous_4, _S256, _S257, last_step_1, _S254);
        if(_S258 >= 0.0f)
        {
            var last_step_2 : f32 = last_step_1 - _S258;
            distance_1 = distance_1 - _S258;
            last_step_1 = last_step_2;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S259 : bool = _S255 > (_S254.cell_max_0);
        var last_step_3 : f32 = select(StepControl_to_next_sample_0(_S252, _S254, _S256, _S257), max(StepControl_to_cell_exit_0(_S252, _S254.side_x_1, _S254.side_y_1), _S251), _S259);
        var distance_2 : f32 = distance_1 + last_step_3;
        previous_4 = after_sample_0(_S256, _S257, _S254, _S259);
        distance_1 = distance_2;
        last_step_1 = last_step_3;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S260 : u32,  _S261 : SearchQuality_0,  _S262 : f32,  _S263 : f32,  _S264 : vec3<f32>,  _S265 : bool) -> bool
{
    if(!sample_at_0(_S260, _S262, _S263, _S265).shown_2.hole_0)
    {
        return false;
    }
    var _S266 : vec3<f32> = vec3<f32>(_S262, _S263, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        if(((side_1 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S267 : bool = is_free_0(_S260, _S261, _S266, select_vector_0(side_1 == u32(0), _S264, vec3<f32>(- _S264.x, - _S264.y, _S264.z)), _S265 != (side_1 == u32(1)), fabrics_0[_S260].height_high_0);
        var _S268 : u32 = side_1 + u32(1);
        passes_0 = _S267;
        side_1 = _S268;
    }
    return passes_0;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_nulls(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    var _S269 : u32 = thread_index_0(id_4);
    var _S270 : u32 = bakes_0[i32(0)].rays_0;
    var _S271 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    var _S272 : u32 = u32(2) * _S271;
    var _S273 : bool = _S269 < _S272;
    var _S274 : u32 = select(_S269 - _S272, u32(0), _S273);
    var _S275 : u32 = _S274 % u32(128);
    var _S276 : bool = !_S273;
    var _S277 : bool;
    if(_S276)
    {
        if(_S274 >= u32(32768))
        {
            _S277 = true;
        }
        else
        {
            _S277 = _S275 >= scratch_0[bakes_0[i32(0)].facts_0 + u32(9)];
        }
    }
    else
    {
        _S277 = false;
    }
    if(_S277)
    {
        return;
    }
    if(_S273)
    {
        _S277 = (((hits_0[_S269].flags_0) & (u32(4)))) == u32(0);
    }
    else
    {
        _S277 = false;
    }
    if(_S277)
    {
        return;
    }
    var _S278 : u32 = bakes_0[i32(0)].fabric_0;
    if(_S273)
    {
        _S277 = _S269 >= _S271;
    }
    else
    {
        _S277 = false;
    }
    var _S279 : u32 = select(_S269, _S269 - _S271, _S277);
    var _S280 : u32 = _S279 / _S270;
    var _S281 : u32 = select(_S274 / u32(128), _S280, _S273);
    var _S282 : u32 = _S279 % _S270;
    var _S283 : vec2<f32> = lattice_position_0(i32(0), _S282, _S281);
    var place_0 : vec2<f32>;
    if(_S276)
    {
        var _S284 : u32 = bakes_0[i32(0)].gaps_0 + u32(2) * _S275;
        place_0 = vec2<f32>(scratch_number_0(_S284), scratch_number_0(_S284 + u32(1)));
    }
    else
    {
        place_0 = _S283;
    }
    var _S285 : bool = passes_through_0(_S278, bake_quality_0(), place_0.x, place_0.y, node_direction_0(_S281), _S277);
    if(_S273)
    {
        hits_0[_S269].flags_0 = ((hits_0[_S269].flags_0) | (select(u32(0), u32(8), _S285)));
    }
    else
    {
        scratch_0[bakes_0[i32(0)].gap_nulls_0 + _S274] = u32(_S285);
    }
    return;
}

fn start_of_shadow_ray_0( node_1 : u32,  ray_1 : u32,  rays_1 : u32) -> u32
{
    return (((node_1 * u32(37) + ray_1) & (u32(255)))) * rays_1 + ray_1;
}

fn unoccluded_0( _S286 : u32,  _S287 : SearchQuality_0,  _S288 : f32,  _S289 : f32,  _S290 : f32,  _S291 : vec3<f32>,  _S292 : bool) -> bool
{
    if((_S291.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S286, _S287, vec3<f32>(_S288, _S289, _S290 + fabrics_0[_S286].lift_0), _S291, _S292, max_height_along_0(_S286, _S288, _S289, _S290, _S291, _S292));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_shadows(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    var _S293 : u32 = thread_index_0(id_5);
    var _S294 : u32 = bakes_0[i32(0)].rays_0;
    var _S295 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    if(_S293 >= (u32(2) * _S295))
    {
        return;
    }
    var _S296 : u32 = bakes_0[i32(0)].fabric_0;
    var _S297 : bool = _S293 >= _S295;
    var _S298 : u32 = select(_S293, _S293 - _S295, _S297);
    var _S299 : u32 = _S298 / _S294;
    var _S300 : u32 = _S298 % _S294;
    var _S301 : u32 = start_of_shadow_ray_0(_S299, _S300, _S294) + select(u32(0), _S295, _S297);
    var _S302 : f32 = hits_0[_S301].x_0;
    var _S303 : f32 = hits_0[_S301].y_0;
    var _S304 : vec3<f32> = node_direction_0(_S299);
    var side_2 : u32 = u32(0);
    var lit_1 : u32 = u32(0);
    for(;;)
    {
        if(side_2 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S305 : bool = _S297 != (side_2 == u32(1));
        var _S306 : SurfacePoint_0 = surface_at_0(_S296, _S302, _S303, _S305);
        var _S307 : bool;
        if(!_S306.hole_1)
        {
            _S307 = (dot(_S306.normal_0, _S304)) > 0.0f;
        }
        else
        {
            _S307 = false;
        }
        var _S308 : bool;
        if(_S307)
        {
            _S308 = unoccluded_0(_S296, bake_quality_0(), _S302, _S303, _S306.height_1, _S304, _S305);
        }
        else
        {
            _S308 = false;
        }
        if(_S308)
        {
            lit_1 = (lit_1 | (((u32(1) << (side_2)))));
        }
        side_2 = side_2 + u32(1);
    }
    scratch_0[bakes_0[i32(0)].lit_0 + _S293] = lit_1;
    return;
}

fn nearest_group_0( _S309 : i32,  _S310 : bool,  _S311 : bool,  _S312 : vec3<f32>,  _S313 : vec3<f32>,  _S314 : f32) -> u32
{
    var _S315 : u32 = select(u32(0), u32(1), _S310);
    var _S316 : u32 = select(scratch_0[bakes_0[_S309].facts_0 + u32(14) + _S315], u32(0), _S311);
    var _S317 : u32 = bakes_0[_S309].per_family_0;
    var _S318 : u32 = select(u32(2) * bakes_0[_S309].per_family_0, scratch_0[bakes_0[_S309].facts_0 + u32(14) + _S315], _S311);
    var least_0 : f32 = 1000.0f;
    var nearest_0 : u32 = _S316;
    var group_0 : u32 = _S316;
    for(;;)
    {
        if(group_0 < _S318)
        {
        }
        else
        {
            break;
        }
        var _S319 : u32 = bakes_0[_S309].centroids_0 + (_S315 * u32(2) * _S317 + group_0) * u32(7);
        var _S320 : vec3<f32> = vec3<f32>(0.5f) * _S312 - vec3<f32>(scratch_number_0(_S319), scratch_number_0(_S319 + u32(1)), scratch_number_0(_S319 + u32(2)));
        var _S321 : vec3<f32> = _S313 - vec3<f32>(scratch_number_0(_S319 + u32(3)), scratch_number_0(_S319 + u32(4)), scratch_number_0(_S319 + u32(5)));
        var _S322 : f32 = dot(_S320, _S320) + dot(_S321, _S321) + square_0(2.0f * _S314 - scratch_number_0(_S319 + u32(6)));
        var _S323 : u32 = select(nearest_0, group_0, _S322 < least_0);
        var _S324 : f32 = min(least_0, _S322);
        var _S325 : u32 = group_0 + u32(1);
        least_0 = _S324;
        nearest_0 = _S323;
        group_0 = _S325;
    }
    return nearest_0;
}

fn byte_of_group_0( _S326 : i32,  _S327 : u32) -> u32
{
    return select(_S327 - bakes_0[_S326].per_family_0 + u32(2) * bakes_0[_S326].packs_0, _S327, _S327 < (bakes_0[_S326].per_family_0));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_texels(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    var _S328 : u32 = thread_index_0(id_6);
    var _S329 : u32 = bakes_0[i32(0)].columns_0;
    var _S330 : u32 = bakes_0[i32(0)].texels_across_0;
    var _S331 : u32 = bakes_0[i32(0)].columns_0 * bakes_0[i32(0)].texels_across_0;
    var _S332 : u32 = bakes_0[i32(0)].rows_0;
    var _S333 : u32 = bakes_0[i32(0)].texels_along_0;
    var _S334 : u32 = _S331 * bakes_0[i32(0)].rows_0 * bakes_0[i32(0)].texels_along_0;
    if(_S328 >= (u32(2) * _S334))
    {
        return;
    }
    var _S335 : u32 = bakes_0[i32(0)].fabric_0;
    var _S336 : bool = _S328 >= _S334;
    var _S337 : u32 = select(_S328, _S328 - _S334, _S336);
    var _S338 : u32 = _S337 / _S331;
    var _S339 : u32 = _S337 % _S331;
    var _S340 : SurfacePoint_0 = surface_at_0(_S335, (f32(_S339) + fraction_of_0(_S337 * u32(3242174889))) * bakes_0[i32(0)].texel_x_0, (f32(_S338) + fraction_of_0(_S337 * u32(2447445413))) * bakes_0[i32(0)].texel_y_0, _S336);
    var _S341 : u32 = bakes_0[i32(0)].packs_0;
    var _S342 : u32 = select(byte_of_group_0(i32(0), nearest_group_0(i32(0), _S336, _S340.is_warp_1, _S340.normal_0, _S340.tangent_0, _S340.shown_share_1)), u32(4) * bakes_0[i32(0)].packs_0, _S340.hole_1);
    var _S343 : u32 = _S338 / _S333;
    var _S344 : u32 = _S343 * _S329;
    var _S345 : u32 = _S339 / _S330;
    var _S346 : u32 = atomicAdd(&(texel_counters_0[(_S344 + _S345 + select(u32(0), _S329 * _S332, _S336)) * (_S341 + u32(1)) + _S342 / u32(4)]), (u32(1) << ((u32(8) * (_S342 % u32(4))))));
    return;
}

