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
    @align(4) stand_ins_0 : u32,
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

struct SurfaceHit_std430_0
{
    @align(4) place_x_0 : f32,
    @align(4) place_y_0 : f32,
    @align(4) place_z_0 : f32,
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

@binding(12) @group(0) var<storage, read> steps_0 : array<u32>;

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
fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
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

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S39 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S40 : f32 = rsqrt_0(_S39);
    var _S41 : f32 = sine_1 * _S40 * rsqrt_0(_S39 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S41 * _S39, _S41 * across_slope_0 * along_slope_0 + cosine_0 * _S40);
}

fn arc_sine_0( x_2 : f32) -> f32
{
    var _S42 : f32 = abs(x_2);
    var _S43 : bool = _S42 > 0.5f;
    var _S44 : f32 = select(_S42 * _S42, 0.5f * (1.0f - _S42), _S43);
    var _S45 : f32 = select(_S42, sqrt(max(_S44, 0.0f)), _S43);
    var _S46 : f32 = ((((0.04216320067644119f * _S44 + 0.02418131195008755f) * _S44 + 0.04547002539038658f) * _S44 + 0.07495300471782684f) * _S44 + 0.16666752099990845f) * _S44 * _S45 + _S45;
    var _S47 : f32 = select(_S46, 1.57079637050628662f - 2.0f * _S46, _S43);
    return select(_S47, - _S47, x_2 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S48 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S48 / (_S48 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

struct SurfaceHit_0
{
     place_x_0 : f32,
     place_y_0 : f32,
     place_z_0 : f32,
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
     x_3 : f32,
     y_0 : f32,
     shown_share_1 : f32,
};

fn hit_of_0( point_0 : SurfacePoint_0) -> SurfaceHit_0
{
    var hit_0 : SurfaceHit_0;
    hit_0.place_x_0 = point_0.x_3;
    hit_0.place_y_0 = point_0.y_0;
    hit_0.place_z_0 = point_0.height_1;
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

fn sample_position_0( _S49 : i32,  _S50 : u32,  _S51 : u32) -> vec2<f32>
{
    return vec2<f32>((floor(fraction_of_0(_S50 * u32(2700274806) + u32(1350137403) + _S51 * u32(3152041523)) * bakes_0[_S49].ends_0) + fraction_of_0(_S50 * u32(3679390609) + u32(1839695304) + _S51 * u32(2313257605))) * bakes_0[_S49].spacing_x_0, (floor(fraction_of_0(_S50 * u32(2313257605) + u32(1156628802) + _S51 * u32(3679390609)) * bakes_0[_S49].picks_0) + fraction_of_0(_S50 * u32(3152041523) + u32(1576020761) + _S51 * u32(2700274806))) * bakes_0[_S49].spacing_y_0);
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
     dive_1 : vec3<f32>,
     slope_x_0 : f32,
     slope_y_0 : f32,
};

fn crossing_at_0( _S52 : u32,  _S53 : f32,  _S54 : f32,  _S55 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S52].warp_0, _S53);
    crossing_2.weft_1 = locate_0(fabrics_0[_S52].weft_0, _S54);
    var _S56 : u32 = fabrics_0[_S52].run_words_0 + u32(2) * (crossing_2.weft_1.thread_0 * fabrics_0[_S52].ends_2 + crossing_2.warp_1.thread_0);
    var _S57 : u32 = words_0[_S56];
    crossing_2.warp_word_0 = _S57;
    crossing_2.weft_word_0 = words_0[_S56 + u32(1)];
    crossing_2.warp_above_0 = (((_S57 & (u32(1)))) == u32(1)) != _S55;
    return crossing_2;
}

fn sample_at_0( _S58 : u32,  _S59 : f32,  _S60 : f32,  _S61 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S62 : Crossing_0 = crossing_at_0(_S58, _S59, _S60, _S61);
    sample_0.crossing_1 = _S62;
    var _S63 : Shown_0 = shown_at_0(_S62, _S61);
    sample_0.shown_2 = _S63;
    var _S64 : u32 = select(fabrics_0[_S58].weft_0, fabrics_0[_S58].warp_0, _S63.is_warp_0);
    var _S65 : u32 = select(fabrics_0[_S58].warp_0, fabrics_0[_S58].weft_0, _S63.is_warp_0);
    var _S66 : Cell_0 = select_cell_0(_S63.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S67 : Cell_0 = select_cell_0(_S63.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S68 : Run_0 = unpack_0(_S64, _S65, _S66.thread_0, _S67, _S63.word_0);
    var _S69 : Section_0 = section_at_0(_S66);
    var _S70 : bool = ((_S63.on_top_0) & (((_S68.distance_0) < (_S69.drop_0 * _S68.bend_1.sine_0))));
    var _S71 : f32 = select(-1.0f, 1.0f, ((_S63.on_top_0) & ((!_S70))));
    var _S72 : f32 = select(_S68.reach_0, _S68.other_reach_0, _S70);
    var _S73 : f32 = select(max(_S72 - _S68.distance_0, 0.0f), _S72 + _S68.distance_0, _S70);
    var _S74 : f32 = _S72 / _S68.bend_1.sine_0 - _S71 * _S69.drop_0;
    var _S75 : f32 = _S73 * _S73;
    var _S76 : f32 = max(_S74 * _S74 - _S75, 9.99999968265522539e-21f);
    var _S77 : f32 = rsqrt_0(_S76);
    var _S78 : f32 = _S75 / (_S76 * _S77 + _S74);
    var _S79 : bool = _S73 > 0.0f;
    var _S80 : f32 = select(-1.0f, 1.0f, _S63.on_top_0) * select(-1.0f, 1.0f, _S68.near_start_0);
    var _S81 : f32 = _S69.slope_0 * select(1.0f, _S74 * _S77, _S79);
    sample_0.slope_across_0 = _S81;
    var _S82 : f32 = select(0.0f, _S80 * _S73 * _S77, _S79);
    sample_0.slope_along_0 = _S82;
    var _S83 : vec3<f32> = dive_0(_S65, _S63, _S68, _S67);
    sample_0.dive_1 = _S83;
    sample_0.height_2 = select(families_0[_S64].height_scale_0 * _S71, 0.0f, _S68.straight_0) * (_S72 * _S68.bend_1.half_tangent_0 - _S78) - families_0[_S64].height_scale_0 * _S69.drop_0 - _S83.x;
    var _S84 : f32 = families_0[_S64].height_scale_0 * _S81;
    var _S85 : f32 = families_0[_S64].height_scale_0 * _S82 - _S83.y;
    sample_0.slope_x_0 = select(_S85, _S84, _S63.is_warp_0);
    sample_0.slope_y_0 = select(_S84, _S85, _S63.is_warp_0);
    sample_0.run_2 = _S68;
    sample_0.section_1 = _S69;
    return sample_0;
}

fn surface_of_0( _S86 : u32,  _S87 : Sample_0,  _S88 : f32,  _S89 : f32,  _S90 : bool) -> SurfacePoint_0
{
    var _S91 : u32 = select(fabrics_0[_S86].weft_0, fabrics_0[_S86].warp_0, _S87.shown_2.is_warp_0);
    var _S92 : f32 = families_0[_S91].twist_sine_0 * select(1.0f, -1.0f, _S90);
    var _S93 : f32 = select(-1.0f, 1.0f, _S87.shown_2.is_warp_0);
    var _S94 : vec2<f32> = fibre_direction_0(_S87.slope_across_0, _S93 * _S87.slope_along_0, _S92, families_0[_S91].twist_cosine_0);
    var _S95 : f32 = _S94.x;
    var _S96 : f32 = _S94.y;
    var _S97 : f32 = select(_S87.slope_y_0, _S87.slope_x_0, _S87.shown_2.is_warp_0) * _S95 + _S93 * select(_S87.slope_x_0, _S87.slope_y_0, _S87.shown_2.is_warp_0) * _S96;
    var _S98 : f32 = select(_S87.crossing_1.weft_1.half_width_1, _S87.crossing_1.warp_1.half_width_1, _S87.shown_2.is_warp_0) * 1.0154266357421875f;
    var _S99 : f32 = _S98 * arc_sine_0(clamp(_S87.section_1.across_1 / _S98, -1.0f, 1.0f));
    var _S100 : f32 = select(- _S88, _S89, _S87.shown_2.is_warp_0);
    var point_1 : SurfacePoint_0;
    point_1.hole_1 = _S87.shown_2.hole_0;
    point_1.is_warp_1 = _S87.shown_2.is_warp_0;
    point_1.warp_thread_0 = _S87.crossing_1.warp_1.thread_0;
    point_1.weft_thread_0 = _S87.crossing_1.weft_1.thread_0;
    point_1.height_1 = _S87.height_2;
    point_1.normal_0 = normalize(vec3<f32>(- _S87.slope_x_0, - _S87.slope_y_0, 1.0f));
    point_1.tangent_0 = normalize(select_vector_0(_S87.shown_2.is_warp_0, vec3<f32>(_S95, _S96, _S97), vec3<f32>(- _S96, _S95, _S97)));
    point_1.across_2 = _S87.section_1.across_1;
    point_1.fibre_across_0 = _S99 * families_0[_S91].twist_cosine_0 + _S100 * _S92;
    point_1.fibre_along_0 = _S100 * families_0[_S91].twist_cosine_0 - _S99 * _S92;
    var _S101 : f32 = run_share_0(_S87.shown_2.word_0);
    point_1.shown_share_1 = select(1.0f - _S101, _S101, _S87.shown_2.on_top_0);
    point_1.x_3 = _S88;
    point_1.y_0 = _S89;
    return point_1;
}

fn surface_at_0( _S102 : u32,  _S103 : f32,  _S104 : f32,  _S105 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S102, sample_at_0(_S102, _S103, _S104, _S105), _S103, _S104, _S105);
}

@compute
@workgroup_size(64, 1, 1)
fn bake_top_down(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S106 : u32 = thread_index_0(id_1);
    if(_S106 >= u32(16384))
    {
        return;
    }
    var _S107 : vec2<f32> = sample_position_0(i32(0), (_S106 & (u32(8191))), u32(0));
    var _S108 : SurfaceHit_0 = hit_of_0(surface_at_0(bakes_0[i32(0)].fabric_0, _S107.x, _S107.y, _S106 >= u32(8192)));
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].place_x_0 = _S108.place_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].place_y_0 = _S108.place_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].place_z_0 = _S108.place_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].flags_0 = _S108.flags_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].normal_x_0 = _S108.normal_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].normal_y_0 = _S108.normal_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].normal_z_0 = _S108.normal_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].tangent_x_0 = _S108.tangent_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].tangent_y_0 = _S108.tangent_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].tangent_z_0 = _S108.tangent_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S106].shown_share_0 = _S108.shown_share_0;
    return;
}

fn sine_cosine_0( x_4 : f32) -> vec2<f32>
{
    var _S109 : f32 = floor(x_4 * 0.63661974668502808f + 0.5f);
    var _S110 : f32 = x_4 - _S109 * 1.5703125f - _S109 * 0.00048375129699707f - _S109 * 7.54979012640433211e-08f;
    var _S111 : f32 = _S110 * _S110;
    var _S112 : f32 = ((-0.00019515295571182f * _S111 + 0.00833216123282909f) * _S111 - 0.16666655242443085f) * _S111 * _S110 + _S110;
    var _S113 : f32 = ((0.00002443315679557f * _S111 - 0.00138873164542019f) * _S111 + 0.04166664555668831f) * _S111 * _S111 - 0.5f * _S111 + 1.0f;
    var _S114 : u32 = (u32(i32(_S109)) & (u32(3)));
    var _S115 : vec2<f32> = select_vector_1(((_S114 & (u32(1)))) != u32(0), vec2<f32>(_S113, _S112), vec2<f32>(_S112, _S113));
    var _S116 : f32 = _S115.x;
    var _S117 : f32 = _S115.y;
    return vec2<f32>(select(_S116, - _S116, ((_S114 & (u32(2)))) != u32(0)), select(_S117, - _S117, (((_S114 + u32(1)) & (u32(2)))) != u32(0)));
}

fn node_direction_0( node_0 : u32) -> vec3<f32>
{
    var _S118 : u32 = node_0 % u32(8);
    var _S119 : vec2<f32> = sine_cosine_0(f32(node_0 / u32(8)) * 0.19634954631328583f);
    var _S120 : f32 = sqrt(1.0f - RING_COSINES_0[_S118] * RING_COSINES_0[_S118]);
    return vec3<f32>(_S120 * _S119.y, _S120 * _S119.x, RING_COSINES_0[_S118]);
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
    var _S121 : f32 = direction_0.x;
    control_0.per_x_0 = 1.0f / max(abs(_S121), 9.99999971718068537e-10f);
    var _S122 : f32 = direction_0.y;
    control_0.per_y_0 = 1.0f / max(abs(_S122), 9.99999971718068537e-10f);
    control_0.right_0 = _S121 > 0.0f;
    control_0.up_0 = _S122 > 0.0f;
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
    var _S123 : f32 = select(- cell_4.across_0, cell_4.across_0, forwards_0);
    var _S124 : f32 = select(cell_4.below_0, cell_4.above_0, forwards_0);
    var _S125 : f32 = - cell_4.half_width_1;
    var _S126 : bool = _S123 < _S125;
    var _S127 : bool = _S123 >= (cell_4.half_width_1);
    var _S128 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_0))))) & ((!shown_3.hole_0)));
    var _S129 : f32 = select(cell_4.half_width_1, _S125, _S126) - _S123;
    var _S130 : f32 = select(_S124, 2.0f * _S124 + _S123 - cell_4.half_width_1, ((shown_3.hole_0) | (((_S128 & ((!shown_3.on_top_0)))))));
    if((((_S128 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_0) & (_S126)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_0);
    }
    return select(_S129, _S130, _S127);
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
    var _S131 : f32 = previous_1.rate_0 * step_4;
    var _S132 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_1.hole_2)))) | (((previous_1.yarn_0) != (here_1.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S131) >= 0.0f) & (((3.0f * clearance_1 - _S132) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S133 : f32 = clearance_1 - previous_1.clearance_0;
    var _S134 : f32 = 6.0f * _S133 - 4.0f * _S131 - 2.0f * _S132;
    var _S135 : f32 = -2.0f * _S131 / max(_S134 + sqrt(max(_S134 * _S134 - 4.0f * (3.0f * (_S131 + _S132 - 2.0f * _S133)) * _S131, 0.0f)), 9.99999968265522539e-21f);
    var _S136 : f32 = 1.0f - _S135;
    return select(-1.0f, _S136 * step_4, ((((_S135 > 0.01999999955296516f) & ((_S136 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S135 + 1.0f) + _S131 * _S135) * _S136 * _S136 + (clearance_1 * (2.0f * _S136 + 1.0f) - _S132 * _S136) * _S135 * _S135) < 0.0f))));
}

fn StepControl_to_next_sample_0( this_3 : StepControl_0,  here_2 : Probe_0,  clearance_2 : f32,  rate_2 : f32) -> f32
{
    var _S137 : f32 = min(here_2.edge_x_0 * this_3.per_x_0, here_2.edge_y_0 * this_3.per_y_0);
    return min(this_3.step_2, select(max(_S137, 0.0f) + this_3.epsilon_0, _S137 - this_3.epsilon_0, ((((!here_2.hole_2) & (((rate_2 * _S137 + clearance_2) < 0.0f)))) & ((_S137 > (2.0f * this_3.epsilon_0))))));
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
    var _S138 : f32 = end_0 - start_1;
    var _S139 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S138;
    var _S140 : f32 = 3.0f * _S138 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S138, 9.99999968265522539e-21f);
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
        var _S141 : f32 = clamp(share_0 - (((_S139 * share_0 + _S140) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S139 * share_0 + 2.0f * _S140) * share_0 + start_rate_0, 0.10000000149011612f * _S138 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S142 : i32 = i_0 + i32(1);
        share_0 = _S141;
        i_0 = _S142;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn angle_of_0( direction_1 : vec2<f32>) -> f32
{
    var _S143 : f32 = direction_1.x;
    var _S144 : f32 = arc_sine_0(_S143);
    var _S145 : bool = _S143 < 0.0f;
    var _S146 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S145);
    var _S147 : f32 = direction_1.y;
    return select(0.5f * _S146 - select(1.0f, -1.0f, _S145) * arc_sine_0(_S147), select(_S144, _S146 - _S144, _S147 < 0.0f), (abs(_S143)) < 0.69999998807907104f);
}

fn lattice_position_0( _S148 : i32,  _S149 : u32,  _S150 : u32) -> vec2<f32>
{
    var _S151 : u32 = u32(4294967295) / bakes_0[_S148].rays_0;
    return vec2<f32>(fraction_of_0(_S149 * _S151 + _S150 * u32(3242174889)) * (bakes_0[_S148].ends_0 * bakes_0[_S148].spacing_x_0), fraction_of_0(_S149 * u32(2654435769) + _S150 * u32(3488053409)) * (bakes_0[_S148].picks_0 * bakes_0[_S148].spacing_y_0));
}

struct Hit_0
{
     x_5 : f32,
     y_1 : f32,
     hole_3 : bool,
     height_5 : f32,
};

fn steps_per_length_0( _S152 : u32,  _S153 : SearchQuality_0,  _S154 : vec3<f32>) -> f32
{
    return max(max(abs(_S154.x) * fabrics_0[_S152].threads_per_x_0, abs(_S154.y) * fabrics_0[_S152].threads_per_y_0) * _S153.steps_per_thread_0, abs(_S154.z) * fabrics_0[_S152].per_relief_0 * _S153.steps_per_relief_0);
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

fn max_height_along_0( _S155 : u32,  _S156 : f32,  _S157 : f32,  _S158 : f32,  _S159 : vec3<f32>,  _S160 : bool) -> f32
{
    var _S161 : f32 = _S159.x;
    var _S162 : f32 = _S159.y;
    var _S163 : u32 = (words_0[fabrics_0[_S155].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S155].weft_0, _S157).thread_0 / u32(2) * fabrics_0[_S155].max_height_columns_0 + locate_0(fabrics_0[_S155].warp_0, _S156).thread_0 / u32(2)) + (select(u32(0), u32(1), _S161 > 0.0f) + select(u32(0), u32(2), _S162 > 0.0f))] >> (u32(select(i32(0), i32(4), _S160))));
    var _S164 : f32 = max(abs(_S161) * fabrics_0[_S155].threads_per_x_0, abs(_S162) * fabrics_0[_S155].threads_per_y_0) / _S159.z;
    var _S165 : f32 = fabrics_0[_S155].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S155].height_high_0;
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
        if(((max_height_0 - _S158) * _S164) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S163 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S165);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_maximum_0( _S166 : u32,  _S167 : Crossing_0) -> f32
{
    var _S168 : u32 = select(fabrics_0[_S166].weft_0, fabrics_0[_S166].warp_0, _S167.warp_above_0);
    return f32((select(_S167.weft_word_0, _S167.warp_word_0, _S167.warp_above_0) >> (u32(28)))) * families_0[_S168].height_scale_0 * families_0[_S168].level_0;
}

fn cell_bounds_0( _S169 : u32,  _S170 : f32,  _S171 : f32,  _S172 : bool,  _S173 : bool,  _S174 : bool) -> vec3<f32>
{
    var _S175 : Crossing_0 = crossing_at_0(_S169, _S170, _S171, _S172);
    return vec3<f32>(cell_maximum_0(_S169, _S175), select(_S175.warp_1.below_0, _S175.warp_1.above_0, _S173), select(_S175.weft_1.below_0, _S175.weft_1.above_0, _S174));
}

fn first_sample_height_0( _S176 : u32,  _S177 : ViewRay_0,  _S178 : StepControl_0,  _S179 : bool) -> f32
{
    var _S180 : f32 = max_height_along_0(_S176, _S177.origin_0.x, _S177.origin_0.y, 0.0f, vec3<f32>(_S177.slope_1, 1.0f), _S179);
    var count_1 : u32 = u32(0);
    var height_7 : f32 = _S180;
    for(;;)
    {
        if(count_1 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S181 : vec2<f32> = ViewRay_at_0(_S177, height_7);
        var _S182 : vec3<f32> = cell_bounds_0(_S176, _S181.x, _S181.y, _S179, _S178.right_0, _S178.up_0);
        var _S183 : f32 = height_7 - _S182.x;
        var _S184 : f32 = StepControl_to_cell_exit_0(_S178, _S182.y, _S182.z);
        var height_8 : f32 = height_7 - clamp(_S183, 0.0f, _S184);
        if(_S183 <= _S184)
        {
            height_7 = height_8;
            break;
        }
        count_1 = count_1 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn probe_0( _S185 : u32,  _S186 : f32,  _S187 : f32,  _S188 : bool,  _S189 : bool,  _S190 : bool) -> Probe_0
{
    var _S191 : Sample_0 = sample_at_0(_S185, _S186, _S187, _S188);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S191.height_2;
    probe_1.hole_2 = _S191.shown_2.hole_0;
    probe_1.slope_x_1 = _S191.slope_x_0;
    probe_1.slope_y_1 = _S191.slope_y_0;
    probe_1.yarn_1 = select(_S191.crossing_1.weft_1.thread_0 * u32(2), _S191.crossing_1.warp_1.thread_0 * u32(2) + u32(1), _S191.shown_2.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S185, _S191.crossing_1);
    probe_1.side_x_1 = select(_S191.crossing_1.warp_1.below_0, _S191.crossing_1.warp_1.above_0, _S189);
    probe_1.side_y_1 = select(_S191.crossing_1.weft_1.below_0, _S191.crossing_1.weft_1.above_0, _S190);
    probe_1.edge_x_0 = outline_distance_0(_S191.crossing_1.warp_1, _S191.shown_2, _S191.run_2, !_S191.shown_2.is_warp_0, _S189);
    probe_1.edge_y_0 = outline_distance_0(_S191.crossing_1.weft_1, _S191.shown_2, _S191.run_2, _S191.shown_2.is_warp_0, _S190);
    return probe_1;
}

fn search_down_0( _S192 : u32,  _S193 : ViewRay_0,  _S194 : StepControl_0,  _S195 : bool) -> ViewRayEnd_0
{
    var _S196 : f32 = fabrics_0[_S192].height_low_0 - (fabrics_0[_S192].height_high_0 - fabrics_0[_S192].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S192, _S193, _S194, _S195);
    end_1.last_step_0 = _S194.epsilon_0;
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
        var _S197 : vec2<f32> = ViewRay_at_0(_S193, end_1.height_6);
        var _S198 : Probe_0 = probe_0(_S192, _S197.x, _S197.y, _S195, _S194.right_0, _S194.up_0);
        var _S199 : f32 = end_1.height_6 - _S198.height_4;
        var _S200 : f32 = ViewRay_rate_0(_S193, _S198);
        end_1.depth_0 = - _S199;
        end_1.rate_4 = _S200;
        var _S201 : bool = !_S198.hole_2;
        end_1.smooth_0 = ((((end_1.previous_3.known_0) & (_S201))) & (((end_1.previous_3.yarn_0) == (_S198.yarn_1))));
        if((((_S201 & ((_S199 <= 0.0f)))) | (((end_1.height_6) <= _S196))))
        {
            break;
        }
        var _S202 : f32 = way_back_to_dip_0(end_1.previous_3, _S199, _S200, end_1.last_step_0, _S198);
        if(_S202 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S202;
            end_1.last_step_0 = end_1.last_step_0 - _S202;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S203 : f32 = min(StepControl_to_cell_exit_0(_S194, _S198.side_x_1, _S198.side_y_1), end_1.height_6 - _S198.cell_max_0);
        var _S204 : f32 = StepControl_to_next_sample_0(_S194, _S198, _S199, _S200);
        end_1.previous_3 = after_sample_0(_S199, _S200, _S198, _S203 > _S204);
        var _S205 : f32 = max(_S203, _S204);
        end_1.last_step_0 = _S205;
        end_1.height_6 = end_1.height_6 - _S205;
        count_2 = count_2 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S206 : u32,  _S207 : ViewRay_0,  _S208 : StepControl_0,  _S209 : bool,  _S210 : ViewRayEnd_0,  _S211 : u32) -> f32
{
    var _S212 : f32 = fabrics_0[_S206].height_high_0 - fabrics_0[_S206].height_low_0;
    var above_2 : f32 = _S210.height_6 + _S210.last_step_0;
    var above_gap_1 : f32 = clamp(_S210.previous_3.clearance_0, 0.0f, _S212);
    var under_gap_1 : f32 = clamp(_S210.depth_0, 0.0f, _S212);
    var middle_0 : f32 = select(between_0(above_2, _S210.height_6, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S210.previous_3.rate_0 * _S210.last_step_0, _S210.rate_4 * _S210.last_step_0) * _S210.last_step_0, _S210.smooth_0);
    var side_0 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S210.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S211)
        {
        }
        else
        {
            break;
        }
        var _S213 : vec2<f32> = ViewRay_at_0(_S207, middle_0);
        var _S214 : Probe_0 = probe_0(_S206, _S213.x, _S213.y, _S209, _S208.right_0, _S208.up_0);
        var _S215 : f32 = clamp(middle_0 - select(_S214.height_4, -1.0e+09f, _S214.hole_2), - _S212, _S212);
        if(_S215 <= 0.0f)
        {
            var _S216 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_0 > 0.0f);
            var _S217 : f32 = - _S215;
            under_1 = middle_0;
            above_gap_2 = _S216;
            under_gap_2 = _S217;
            side_0 = 1.0f;
        }
        else
        {
            var _S218 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_0 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S215;
            under_gap_2 = _S218;
            side_0 = -1.0f;
        }
        var _S219 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S215 / min(ViewRay_rate_0(_S207, _S214), -9.99999997475242708e-07f), under_1, above_3), _S210.smooth_0);
        var _S220 : u32 = i_1 + u32(1);
        middle_0 = _S219;
        i_1 = _S220;
    }
    return select(under_1, middle_0, _S210.smooth_0);
}

fn first_hit_of_yarn_0( _S221 : u32,  _S222 : SearchQuality_0,  _S223 : f32,  _S224 : f32,  _S225 : vec3<f32>,  _S226 : bool) -> Hit_0
{
    var _S227 : f32 = max(_S225.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S223, _S224);
    var _S228 : vec2<f32> = _S225.xy / vec2<f32>(_S227);
    ray_0.slope_1 = _S228;
    var _S229 : StepControl_0 = step_control_0((vec2<f32>(0) - _S228), 1.0f / max(steps_per_length_0(_S221, _S222, _S225) / _S227, 9.99999971718068537e-10f));
    var _S230 : ViewRayEnd_0 = search_down_0(_S221, ray_0, _S229, _S226);
    var hit_1 : Hit_0;
    hit_1.hole_3 = false;
    var _S231 : f32 = refined_height_0(_S221, ray_0, _S229, _S226, _S230, _S222.refinements_0);
    hit_1.height_5 = _S231;
    var _S232 : vec2<f32> = ViewRay_at_0(ray_0, _S231);
    hit_1.x_5 = _S232.x;
    hit_1.y_1 = _S232.y;
    return hit_1;
}

fn surface_met_0( _S233 : u32,  _S234 : f32,  _S235 : f32,  _S236 : f32,  _S237 : vec3<f32>,  _S238 : bool) -> SurfacePoint_0
{
    var _S239 : Sample_0 = sample_at_0(_S233, _S234, _S235, _S238);
    var point_2 : SurfacePoint_0 = surface_of_0(_S233, _S239, _S234, _S235, _S238);
    var _S240 : u32 = select(fabrics_0[_S233].weft_0, fabrics_0[_S233].warp_0, point_2.is_warp_1);
    var _S241 : f32 = select(_S239.crossing_1.weft_1.half_width_1, _S239.crossing_1.warp_1.half_width_1, point_2.is_warp_1) * 1.0154266357421875f;
    var _S242 : f32 = _S239.dive_1.z;
    var _S243 : f32 = _S239.slope_along_0 - (1.0f - _S242) * _S239.dive_1.y / families_0[_S240].height_scale_0;
    var _S244 : f32 = rsqrt_0(_S243 * _S243 + 1.0f);
    var _S245 : f32 = _S237.x;
    var _S246 : f32 = _S237.y;
    var _S247 : f32 = select(_S246, _S245, point_2.is_warp_1);
    var _S248 : f32 = _S237.z;
    var _S249 : f32 = (_S248 / families_0[_S240].height_scale_0 - _S243 * select(_S245, _S246, point_2.is_warp_1)) * _S244;
    var _S250 : f32 = square_0(_S241);
    var _S251 : f32 = sqrt(max(_S250 - square_0(point_2.across_2), 0.0f)) - (_S239.height_2 + _S242 * _S239.dive_1.x - _S236) / families_0[_S240].height_scale_0 * _S244;
    var _S252 : f32 = square_0(_S247) + square_0(_S249) + 9.999999960041972e-13f;
    var _S253 : f32 = point_2.across_2 * _S247 + _S251 * _S249;
    var _S254 : f32 = square_0(point_2.across_2) + square_0(_S251) - _S250;
    var _S255 : f32 = sqrt(max(square_0(_S253) - _S252 * _S254, 0.0f));
    var _S256 : f32 = clamp(select((_S255 - _S253) / _S252, - _S254 / max(_S253 + _S255, 9.999999960041972e-13f), _S253 > 0.0f), - _S241, _S241);
    var _S257 : f32 = point_2.across_2 + _S256 * _S247;
    point_2.across_2 = _S257;
    var _S258 : vec2<f32> = normalize(vec2<f32>(_S257, _S251 + _S256 * _S249));
    var _S259 : f32 = select(-1.0f, 1.0f, point_2.is_warp_1);
    var _S260 : f32 = families_0[_S240].twist_sine_0 * select(1.0f, -1.0f, _S238);
    var _S261 : f32 = _S258.x;
    var _S262 : f32 = _S260 * _S261 * _S244;
    var _S263 : f32 = _S258.y;
    var _S264 : f32 = - _S260 * _S263;
    var _S265 : f32 = families_0[_S240].twist_cosine_0 * _S244 - _S259 * _S243 * _S262;
    var _S266 : f32 = families_0[_S240].height_scale_0 * (families_0[_S240].twist_cosine_0 * _S259 * _S243 * _S244 + _S262);
    var _S267 : f32 = families_0[_S240].height_scale_0 * _S261;
    var _S268 : f32 = - families_0[_S240].height_scale_0 * _S243 * _S244 * _S263;
    point_2.normal_0 = normalize(vec3<f32>(select(_S268, _S267, point_2.is_warp_1), select(_S267, _S268, point_2.is_warp_1), _S244 * _S263));
    point_2.tangent_0 = normalize(vec3<f32>(select(- _S265, _S264, point_2.is_warp_1), select(_S264, _S265, point_2.is_warp_1), _S266));
    var _S269 : f32 = _S241 * angle_of_0(_S258);
    var _S270 : f32 = select(- _S234 - _S256 * _S245, _S235 + _S256 * _S246, point_2.is_warp_1);
    point_2.fibre_across_0 = _S269 * families_0[_S240].twist_cosine_0 + _S270 * _S260;
    point_2.fibre_along_0 = _S270 * families_0[_S240].twist_cosine_0 - _S269 * _S260;
    var _S271 : f32 = 0.00999999977648258f * _S241;
    var _S272 : f32 = - _S271;
    var _S273 : bool = _S256 < _S272;
    var _S274 : f32 = select(_S271, _S272, _S247 < 0.0f);
    var _S275 : f32 = max(_S256, 0.0f);
    point_2.x_3 = point_2.x_3 + select(_S275 * _S245, select(0.0f, _S274, point_2.is_warp_1), _S273);
    point_2.y_0 = point_2.y_0 + select(_S275 * _S246, select(_S274, 0.0f, point_2.is_warp_1), _S273);
    point_2.height_1 = select(_S236 + _S256 * _S248, _S236, _S273);
    return point_2;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_views(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    var _S276 : u32 = thread_index_0(id_2);
    var _S277 : u32 = bakes_0[i32(0)].rays_0;
    var _S278 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    if(_S276 >= (u32(2) * _S278))
    {
        return;
    }
    var _S279 : u32 = bakes_0[i32(0)].fabric_0;
    var _S280 : bool = _S276 >= _S278;
    var _S281 : u32 = select(_S276, _S276 - _S278, _S280);
    var _S282 : u32 = _S281 / _S277;
    var _S283 : u32 = _S281 % _S277;
    var _S284 : vec2<f32> = lattice_position_0(i32(0), _S283, _S282);
    var _S285 : vec3<f32> = node_direction_0(_S282);
    var _S286 : Hit_0 = first_hit_of_yarn_0(_S279, bake_quality_0(), _S284.x, _S284.y, _S285, _S280);
    var hit_2 : SurfaceHit_0 = hit_of_0(surface_met_0(_S279, _S286.x_5, _S286.y_1, _S286.height_5, _S285, _S280));
    hit_2.flags_0 = ((hit_2.flags_0) | (select(u32(0), u32(4), (_S286.height_5) <= 0.0f)));
    hits_0[_S276].place_x_0 = hit_2.place_x_0;
    hits_0[_S276].place_y_0 = hit_2.place_y_0;
    hits_0[_S276].place_z_0 = hit_2.place_z_0;
    hits_0[_S276].flags_0 = hit_2.flags_0;
    hits_0[_S276].normal_x_0 = hit_2.normal_x_0;
    hits_0[_S276].normal_y_0 = hit_2.normal_y_0;
    hits_0[_S276].normal_z_0 = hit_2.normal_z_0;
    hits_0[_S276].tangent_x_0 = hit_2.tangent_x_0;
    hits_0[_S276].tangent_y_0 = hit_2.tangent_y_0;
    hits_0[_S276].tangent_z_0 = hit_2.tangent_z_0;
    hits_0[_S276].shown_share_0 = hit_2.shown_share_0;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_gap_starts(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    var _S287 : u32 = thread_index_0(id_3);
    var _S288 : u32 = bakes_0[i32(0)].rays_0;
    var _S289 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    var _S290 : bool;
    if(_S287 >= (u32(2) * _S289))
    {
        _S290 = true;
    }
    else
    {
        _S290 = (((hits_0[_S287].flags_0) & (u32(4)))) == u32(0);
    }
    if(_S290)
    {
        return;
    }
    var _S291 : u32 = bakes_0[i32(0)].fabric_0;
    var _S292 : bool = _S287 >= _S289;
    var _S293 : u32 = select(_S287, _S287 - _S289, _S292);
    var _S294 : u32 = _S293 % _S288;
    var _S295 : u32 = _S293 / _S288;
    var _S296 : vec2<f32> = lattice_position_0(i32(0), _S294, _S295);
    if(!shown_at_0(crossing_at_0(_S291, _S296.x, _S296.y, _S292), _S292).hole_0)
    {
        hits_0[_S287].flags_0 = ((hits_0[_S287].flags_0) & (u32(4294967291)));
    }
    return;
}

fn scratch_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((scratch_0[index_2])));
}

fn is_free_0( _S297 : u32,  _S298 : SearchQuality_0,  _S299 : vec3<f32>,  _S300 : vec3<f32>,  _S301 : bool,  _S302 : f32) -> bool
{
    var _S303 : f32 = _S300.z;
    if(_S303 <= 0.0f)
    {
        return false;
    }
    var _S304 : f32 = 1.0f / max(_S298.shadow_share_0 * steps_per_length_0(_S297, _S298, _S300), 9.99999971718068537e-10f);
    var _S305 : StepControl_0 = step_control_0(_S300.xy, _S304);
    var previous_4 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_1 : f32 = 0.0f;
    for(;;)
    {
        if(((count_3 < u32(1024)) & (((_S299.z + _S303 * distance_1) < _S302))))
        {
        }
        else
        {
            break;
        }
        var _S306 : vec3<f32> = _S299 + _S300 * vec3<f32>(distance_1);
        var _S307 : Probe_0 = probe_0(_S297, _S306.x, _S306.y, _S301, _S305.right_0, _S305.up_0);
        var _S308 : f32 = _S306.z;
        var _S309 : f32 = _S308 - _S307.height_4;
        var _S310 : f32 = _S303 - _S307.slope_x_1 * _S300.x - _S307.slope_y_1 * _S300.y;
        if(((!_S307.hole_2) & ((_S309 < 0.0f))))
        {
            return false;
        }
        var _S311 : f32 = way_back_to_dip_0(previous_4, _S309, _S310, last_step_1, _S307);
        if(_S311 >= 0.0f)
        {
            var last_step_2 : f32 = last_step_1 - _S311;
            distance_1 = distance_1 - _S311;
            last_step_1 = last_step_2;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S312 : bool = _S308 > (_S307.cell_max_0);
        var last_step_3 : f32 = select(StepControl_to_next_sample_0(_S305, _S307, _S309, _S310), max(StepControl_to_cell_exit_0(_S305, _S307.side_x_1, _S307.side_y_1), _S304), _S312);
        var distance_2 : f32 = distance_1 + last_step_3;
        previous_4 = after_sample_0(_S309, _S310, _S307, _S312);
        distance_1 = distance_2;
        last_step_1 = last_step_3;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S313 : u32,  _S314 : SearchQuality_0,  _S315 : f32,  _S316 : f32,  _S317 : vec3<f32>,  _S318 : bool) -> bool
{
    if(!sample_at_0(_S313, _S315, _S316, _S318).shown_2.hole_0)
    {
        return false;
    }
    var _S319 : vec3<f32> = vec3<f32>(_S315, _S316, 0.0f);
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
        var _S320 : bool = is_free_0(_S313, _S314, _S319, select_vector_0(side_1 == u32(0), _S317, vec3<f32>(- _S317.x, - _S317.y, _S317.z)), _S318 != (side_1 == u32(1)), fabrics_0[_S313].height_high_0);
        var _S321 : u32 = side_1 + u32(1);
        passes_0 = _S320;
        side_1 = _S321;
    }
    return passes_0;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_nulls(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    var _S322 : u32 = thread_index_0(id_4);
    var _S323 : u32 = bakes_0[i32(0)].rays_0;
    var _S324 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    var _S325 : u32 = u32(2) * _S324;
    var _S326 : bool = _S322 < _S325;
    var _S327 : u32 = select(_S322 - _S325, u32(0), _S326);
    var _S328 : u32 = _S327 % u32(128);
    var _S329 : bool = !_S326;
    var _S330 : bool;
    if(_S329)
    {
        if(_S327 >= u32(32768))
        {
            _S330 = true;
        }
        else
        {
            _S330 = _S328 >= scratch_0[bakes_0[i32(0)].facts_0 + u32(9)];
        }
    }
    else
    {
        _S330 = false;
    }
    if(_S330)
    {
        return;
    }
    if(_S326)
    {
        _S330 = (((hits_0[_S322].flags_0) & (u32(4)))) == u32(0);
    }
    else
    {
        _S330 = false;
    }
    if(_S330)
    {
        return;
    }
    var _S331 : u32 = bakes_0[i32(0)].fabric_0;
    if(_S326)
    {
        _S330 = _S322 >= _S324;
    }
    else
    {
        _S330 = false;
    }
    var _S332 : u32 = select(_S322, _S322 - _S324, _S330);
    var _S333 : u32 = _S332 / _S323;
    var _S334 : u32 = select(_S327 / u32(128), _S333, _S326);
    var _S335 : u32 = _S332 % _S323;
    var _S336 : vec2<f32> = lattice_position_0(i32(0), _S335, _S334);
    var place_0 : vec2<f32>;
    if(_S329)
    {
        var _S337 : u32 = bakes_0[i32(0)].gaps_0 + u32(2) * _S328;
        place_0 = vec2<f32>(scratch_number_0(_S337), scratch_number_0(_S337 + u32(1)));
    }
    else
    {
        place_0 = _S336;
    }
    var _S338 : bool = passes_through_0(_S331, bake_quality_0(), place_0.x, place_0.y, node_direction_0(_S334), _S330);
    if(_S326)
    {
        hits_0[_S322].flags_0 = ((hits_0[_S322].flags_0) | (select(u32(0), u32(8), _S338)));
    }
    else
    {
        scratch_0[bakes_0[i32(0)].gap_nulls_0 + _S327] = u32(_S338);
    }
    return;
}

fn start_of_shadow_ray_0( node_1 : u32,  ray_1 : u32,  rays_1 : u32) -> u32
{
    return (((node_1 * u32(37) + ray_1) & (u32(255)))) * rays_1 + ray_1;
}

fn hit_normal_0( hit_3 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_3).normal_x_0, (*hit_3).normal_y_0, (*hit_3).normal_z_0);
}

fn unoccluded_0( _S339 : u32,  _S340 : SearchQuality_0,  _S341 : f32,  _S342 : f32,  _S343 : f32,  _S344 : vec3<f32>,  _S345 : bool) -> bool
{
    if((_S344.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S339, _S340, vec3<f32>(_S341, _S342, _S343 + fabrics_0[_S339].lift_0), _S344, _S345, max_height_along_0(_S339, _S341, _S342, _S343, _S344, _S345));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_shadows(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    var _S346 : u32 = thread_index_0(id_5);
    var _S347 : u32 = bakes_0[i32(0)].rays_0;
    var _S348 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    if(_S346 >= (u32(2) * _S348))
    {
        return;
    }
    var _S349 : u32 = bakes_0[i32(0)].fabric_0;
    var _S350 : bool = _S346 >= _S348;
    var _S351 : u32 = select(_S346, _S346 - _S348, _S350);
    var _S352 : u32 = _S351 / _S347;
    var _S353 : u32 = _S351 % _S347;
    var _S354 : SurfaceHit_std430_0 = hits_0[start_of_shadow_ray_0(_S352, _S353, _S347) + select(u32(0), _S348, _S350)];
    var _S355 : f32 = _S354.place_x_0;
    var _S356 : f32 = _S354.place_y_0;
    var _S357 : SurfacePoint_0 = surface_at_0(_S349, _S354.place_x_0, _S354.place_y_0, !_S350);
    var _S358 : vec3<f32> = node_direction_0(_S352);
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
        var _S359 : bool = side_2 == u32(1);
        var _S360 : vec3<f32> = hit_normal_0(&(_S354));
        var _S361 : vec3<f32> = select_vector_0(_S359, _S357.normal_0, _S360);
        var _S362 : f32 = select(_S354.place_z_0, _S357.height_1, _S359);
        var _S363 : bool;
        if(!((_S359 & ((_S357.hole_1)))))
        {
            _S363 = (dot(_S361, _S358)) > 0.0f;
        }
        else
        {
            _S363 = false;
        }
        var _S364 : bool;
        if(_S363)
        {
            _S364 = unoccluded_0(_S349, bake_quality_0(), _S355, _S356, _S362, _S358, _S350 != _S359);
        }
        else
        {
            _S364 = false;
        }
        if(_S364)
        {
            lit_1 = (lit_1 | (((u32(1) << (side_2)))));
        }
        side_2 = side_2 + u32(1);
    }
    scratch_0[bakes_0[i32(0)].lit_0 + _S346] = lit_1;
    return;
}

fn nearest_group_0( _S365 : i32,  _S366 : bool,  _S367 : bool,  _S368 : vec3<f32>,  _S369 : vec3<f32>,  _S370 : f32) -> u32
{
    var _S371 : u32 = select(u32(0), u32(1), _S366);
    var _S372 : u32 = select(scratch_0[bakes_0[_S365].facts_0 + u32(14) + _S371], u32(0), _S367);
    var _S373 : u32 = bakes_0[_S365].per_family_0;
    var _S374 : u32 = select(u32(2) * bakes_0[_S365].per_family_0, scratch_0[bakes_0[_S365].facts_0 + u32(14) + _S371], _S367);
    var least_0 : f32 = 1000.0f;
    var nearest_0 : u32 = _S372;
    var group_0 : u32 = _S372;
    for(;;)
    {
        if(group_0 < _S374)
        {
        }
        else
        {
            break;
        }
        var _S375 : u32 = bakes_0[_S365].centroids_0 + (_S371 * u32(2) * _S373 + group_0) * u32(7);
        var _S376 : vec3<f32> = vec3<f32>(0.5f) * _S368 - vec3<f32>(scratch_number_0(_S375), scratch_number_0(_S375 + u32(1)), scratch_number_0(_S375 + u32(2)));
        var _S377 : vec3<f32> = _S369 - vec3<f32>(scratch_number_0(_S375 + u32(3)), scratch_number_0(_S375 + u32(4)), scratch_number_0(_S375 + u32(5)));
        var _S378 : f32 = dot(_S376, _S376) + dot(_S377, _S377) + square_0(2.0f * _S370 - scratch_number_0(_S375 + u32(6)));
        var _S379 : u32 = select(nearest_0, group_0, _S378 < least_0);
        var _S380 : f32 = min(least_0, _S378);
        var _S381 : u32 = group_0 + u32(1);
        least_0 = _S380;
        nearest_0 = _S379;
        group_0 = _S381;
    }
    return nearest_0;
}

fn byte_of_group_0( _S382 : i32,  _S383 : u32) -> u32
{
    return select(_S383 - bakes_0[_S382].per_family_0 + u32(2) * bakes_0[_S382].packs_0, _S383, _S383 < (bakes_0[_S382].per_family_0));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_texels(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    var _S384 : u32 = thread_index_0(id_6);
    var _S385 : u32 = bakes_0[i32(0)].columns_0;
    var _S386 : u32 = bakes_0[i32(0)].texels_across_0;
    var _S387 : u32 = bakes_0[i32(0)].columns_0 * bakes_0[i32(0)].texels_across_0;
    var _S388 : u32 = bakes_0[i32(0)].rows_0;
    var _S389 : u32 = bakes_0[i32(0)].texels_along_0;
    var _S390 : u32 = _S387 * bakes_0[i32(0)].rows_0 * bakes_0[i32(0)].texels_along_0;
    if(_S384 >= (u32(2) * _S390))
    {
        return;
    }
    var _S391 : u32 = bakes_0[i32(0)].fabric_0;
    var _S392 : bool = _S384 >= _S390;
    var _S393 : u32 = select(_S384, _S384 - _S390, _S392);
    var _S394 : u32 = _S393 / _S387;
    var _S395 : u32 = _S393 % _S387;
    var _S396 : SurfacePoint_0 = surface_at_0(_S391, (f32(_S395) + fraction_of_0(_S393 * u32(3242174889))) * bakes_0[i32(0)].texel_x_0, (f32(_S394) + fraction_of_0(_S393 * u32(2447445413))) * bakes_0[i32(0)].texel_y_0, _S392);
    var _S397 : u32 = bakes_0[i32(0)].packs_0;
    var _S398 : u32 = select(byte_of_group_0(i32(0), nearest_group_0(i32(0), _S392, _S396.is_warp_1, _S396.normal_0, _S396.tangent_0, _S396.shown_share_1)), u32(4) * bakes_0[i32(0)].packs_0, _S396.hole_1);
    var _S399 : u32 = _S394 / _S389;
    var _S400 : u32 = _S399 * _S385;
    var _S401 : u32 = _S395 / _S386;
    var _S402 : u32 = atomicAdd(&(texel_counters_0[(_S400 + _S401 + select(u32(0), _S385 * _S388, _S392)) * (_S397 + u32(1)) + _S398 / u32(4)]), (u32(1) << ((u32(8) * (_S398 % u32(4))))));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_cover_hidden(@builtin(global_invocation_id) id_7 : vec3<u32>)
{
    var _S403 : u32 = thread_index_0(id_7);
    var _S404 : u32 = bakes_0[i32(0)].columns_0;
    var _S405 : u32 = bakes_0[i32(0)].rows_0;
    if(_S403 >= (bakes_0[i32(0)].columns_0 * bakes_0[i32(0)].rows_0))
    {
        return;
    }
    var _S406 : u32 = steps_0[i32(0)];
    var _S407 : u32 = bakes_0[i32(0)].packs_0;
    var _S408 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S409 : u32 = (_S406 * _S404 * _S405 + _S403) * _S408;
    var byte_0 : u32 = u32(0);
    for(;;)
    {
        if(byte_0 < (u32(4) * _S407))
        {
        }
        else
        {
            break;
        }
        var _S410 : u32 = scratch_0[bakes_0[i32(0)].stand_ins_0 + _S406 * u32(4) * _S408 + byte_0];
        if(scratch_0[bakes_0[i32(0)].stand_ins_0 + _S406 * u32(4) * _S408 + byte_0] != byte_0)
        {
            var _S411 : u32 = atomicLoad(&(texel_counters_0[_S409 + _S410 / u32(4)]));
            var _S412 : u32 = (((_S411 >> ((u32(8) * (_S410 % u32(4)))))) & (u32(255)));
            var _S413 : u32 = atomicLoad(&(texel_counters_0[_S409 + byte_0 / u32(4)]));
            var _S414 : u32 = u32(8) * (byte_0 % u32(4));
            atomicStore(&(texel_counters_0[_S409 + byte_0 / u32(4)]), (((_S413 & ((~((u32(255) << (_S414))))))) | (((_S412 << (_S414))))));
        }
        byte_0 = byte_0 + u32(1);
    }
    return;
}

