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
    @align(4) planes_0 : u32,
    @align(4) plane_records_0 : u32,
    @align(4) plane_axes_0 : u32,
    @align(4) stacks_0 : u32,
    @align(4) plane_orders_0 : u32,
    @align(4) regions_0 : u32,
    @align(4) plane_shares_0 : u32,
    @align(4) is_coloured_0 : u32,
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
    @align(4) layer_turned_0 : f32,
    @align(4) layer_through_0 : f32,
    @align(4) albedo_table_0 : u32,
    @align(4) albedo_stride_0 : u32,
    @align(4) before_0 : u32,
    @align(4) visible_total_0 : f32,
    @align(4) smallest_box_0 : f32,
    @align(4) quantities_0 : u32,
    @align(4) colour_mean_0 : u32,
    @align(4) cloth_mean_0 : u32,
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

@id(0) override HAS_LAYERS_0 : bool = true;

fn table_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_0])));
}

struct Cell_0
{
     thread_0 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_varied_0( family_0 : u32,  position_0 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_0 - families_0[family_0].start_0) * families_0[family_0].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S1 : f32 = turns_1 * families_0[family_0].period_0;
    var thread_1 : u32 = words_0[families_0[family_0].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_0].bins_0, 0.0f, families_0[family_0].bins_0 - 1.0f))];
    var _S2 : u32 = min(thread_1 + select(u32(0), u32(1), _S1 >= (table_number_0(families_0[family_0].place_table_0 + thread_1 * u32(4) + u32(1)))), u32(families_0[family_0].count_0) - u32(1));
    var _S3 : u32 = families_0[family_0].place_table_0 + _S2 * u32(4);
    var cell_0 : Cell_0;
    cell_0.thread_0 = _S2;
    cell_0.below_0 = _S1 - table_number_0(_S3);
    cell_0.above_0 = table_number_0(_S3 + u32(1)) - _S1;
    cell_0.across_0 = _S1 - table_number_0(_S3 + u32(2));
    cell_0.half_width_1 = table_number_0(_S3 + u32(3));
    return cell_0;
}

struct Plane_0
{
     warp_1 : u32,
     weft_1 : u32,
     run_words_1 : u32,
     ends_3 : u32,
     end_numbers_0 : u32,
     pick_numbers_0 : u32,
     max_heights_1 : u32,
     max_height_columns_1 : u32,
     height_low_1 : f32,
     height_high_1 : f32,
     front_level_0 : f32,
     back_level_0 : f32,
     start_x_0 : f32,
     start_y_0 : f32,
     fine_x_0 : f32,
     fine_y_0 : f32,
};

fn plane_at_0( first_0 : u32) -> Plane_0
{
    var record_0 : Plane_0;
    record_0.warp_1 = words_0[first_0];
    record_0.weft_1 = words_0[first_0 + u32(1)];
    record_0.run_words_1 = words_0[first_0 + u32(2)];
    record_0.ends_3 = words_0[first_0 + u32(3)];
    record_0.end_numbers_0 = words_0[first_0 + u32(4)];
    record_0.pick_numbers_0 = words_0[first_0 + u32(5)];
    record_0.max_heights_1 = words_0[first_0 + u32(6)];
    record_0.max_height_columns_1 = words_0[first_0 + u32(7)];
    record_0.height_low_1 = (bitcast<f32>((words_0[first_0 + u32(8)])));
    record_0.height_high_1 = (bitcast<f32>((words_0[first_0 + u32(9)])));
    record_0.front_level_0 = (bitcast<f32>((words_0[first_0 + u32(10)])));
    record_0.back_level_0 = (bitcast<f32>((words_0[first_0 + u32(11)])));
    record_0.start_x_0 = (bitcast<f32>((words_0[first_0 + u32(12)])));
    record_0.start_y_0 = (bitcast<f32>((words_0[first_0 + u32(13)])));
    record_0.fine_x_0 = (bitcast<f32>((words_0[first_0 + u32(14)])));
    record_0.fine_y_0 = (bitcast<f32>((words_0[first_0 + u32(15)])));
    return record_0;
}

fn turns_and_remainder_0( family_1 : u32,  index_1 : f32) -> vec2<f32>
{
    var _S4 : f32 = floor(fma(index_1, families_0[family_1].inverse_count_0, families_0[family_1].half_inverse_count_0));
    return vec2<f32>(_S4, fma(- _S4, families_0[family_1].count_0, index_1));
}

fn locate_alike_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var _S5 : f32 = floor(position_1 * families_0[family_2].inverse_size_0);
    var cell_1 : Cell_0;
    var _S6 : f32 = fma(- _S5, families_0[family_2].size_0, position_1);
    cell_1.below_0 = _S6;
    cell_1.above_0 = families_0[family_2].size_0 - _S6;
    cell_1.across_0 = _S6 - 0.5f * families_0[family_2].size_0;
    cell_1.half_width_1 = families_0[family_2].half_width_0;
    cell_1.thread_0 = u32(clamp(turns_and_remainder_0(family_2, _S5).y, 0.0f, families_0[family_2].count_0 - 1.0f));
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

struct Crossing_0
{
     warp_2 : Cell_0,
     weft_2 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn crossing_at_0( plane_0 : Plane_0,  x_1 : f32,  y_0 : f32,  back_2 : bool) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.warp_2 = locate_0(plane_0.warp_1, x_1 - plane_0.start_x_0);
    crossing_0.weft_2 = locate_0(plane_0.weft_1, y_0 - plane_0.start_y_0);
    var _S7 : u32 = plane_0.run_words_1 + u32(2) * (crossing_0.weft_2.thread_0 * plane_0.ends_3 + crossing_0.warp_2.thread_0);
    var _S8 : u32 = words_0[_S7];
    crossing_0.warp_word_0 = _S8;
    crossing_0.weft_word_0 = words_0[_S7 + u32(1)];
    crossing_0.warp_above_0 = (((_S8 & (u32(1)))) == u32(1)) != back_2;
    return crossing_0;
}

fn cell_maximum_0( plane_1 : Plane_0,  crossing_1 : Crossing_0) -> f32
{
    var _S9 : u32 = select(plane_1.weft_1, plane_1.warp_1, crossing_1.warp_above_0);
    return f32((select(crossing_1.weft_word_0, crossing_1.warp_word_0, crossing_1.warp_above_0) >> (u32(28)))) * families_0[_S9].height_scale_0 * families_0[_S9].level_0;
}

fn bounds_in_0( plane_2 : Plane_0,  x_2 : f32,  y_1 : f32,  back_3 : bool,  right_0 : bool,  up_0 : bool) -> vec3<f32>
{
    var _S10 : Crossing_0 = crossing_at_0(plane_2, x_2, y_1, back_3);
    return vec3<f32>(cell_maximum_0(plane_2, _S10), select(_S10.warp_2.below_0, _S10.warp_2.above_0, right_0), select(_S10.weft_2.below_0, _S10.weft_2.above_0, up_0));
}

fn hole_edge_0( cell_2 : Cell_0,  forwards_0 : bool) -> f32
{
    var _S11 : f32 = select(- cell_2.across_0, cell_2.across_0, forwards_0);
    var _S12 : f32 = - cell_2.half_width_1;
    return select(select(cell_2.half_width_1, _S12, _S11 < _S12) - _S11, 2.0f * select(cell_2.below_0, cell_2.above_0, forwards_0) + _S11 - cell_2.half_width_1, _S11 >= (cell_2.half_width_1));
}

struct Shown_0
{
     is_warp_0 : bool,
     hole_0 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

fn shown_at_0( crossing_2 : Crossing_0,  back_4 : bool) -> Shown_0
{
    var _S13 : bool = (abs(crossing_2.warp_2.across_0)) < (crossing_2.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S14 : bool = !((abs(crossing_2.weft_2.across_0)) < (crossing_2.weft_2.half_width_1));
    var _S15 : bool = (_S13 & (((_S14 | ((crossing_2.warp_above_0))))));
    shown_0.is_warp_0 = _S15;
    shown_0.hole_0 = ((!_S13) & (_S14));
    var _S16 : u32 = select(crossing_2.weft_word_0, crossing_2.warp_word_0, _S15);
    shown_0.word_0 = _S16;
    shown_0.on_top_0 = (((_S16 & (u32(1)))) == u32(1)) != back_4;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_1 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    cell_3.thread_0 = select(second_0.thread_0, first_1.thread_0, is_first_0);
    cell_3.across_0 = select(second_0.across_0, first_1.across_0, is_first_0);
    cell_3.half_width_1 = select(second_0.half_width_1, first_1.half_width_1, is_first_0);
    cell_3.below_0 = select(second_0.below_0, first_1.below_0, is_first_0);
    cell_3.above_0 = select(second_0.above_0, first_1.above_0, is_first_0);
    return cell_3;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S17 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S17.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S17.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_3 : u32,  first_2 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_2) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_2);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_4 : u32) -> Bend_0
{
    var _S18 : u32 = families_0[family_6].bend_table_0 + select(thread_4 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S18);
    bend_0.half_tangent_0 = table_number_0(_S18 + u32(1));
    bend_0.arc_0 = table_number_0(_S18 + u32(2));
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
    var _S19 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S20 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S21 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S22 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S23 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S23;
    var _S24 : i32 = - _S19;
    var _S25 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S24, i32(0));
    run_0.from_start_0 = _S25;
    var _S26 : i32 = _S20 + i32(1);
    var _S27 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S26);
    run_0.to_end_0 = _S27;
    var _S28 : bool = _S25 < _S27;
    run_0.near_start_0 = _S28;
    var _S29 : i32 = select(_S26, _S24 - _S21, _S28);
    var _S30 : i32 = select(_S26 + _S22, _S24, _S28);
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    run_0.distance_0 = select(min(_S25, _S27), 1.0e+06f, _S23);
    run_0.reach_0 = min(0.5f * (_S25 + _S27), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S29, _S30), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S19 == i32(0);
    run_0.last_crossing_0 = _S20 == i32(0);
    return run_0;
}

fn square_0( x_3 : f32) -> f32
{
    return x_3 * x_3;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_4 : Cell_0) -> Section_0
{
    var _S31 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S32 : f32 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S32;
    var _S33 : f32 = _S31 * _S31 - square_0(_S32);
    var _S34 : f32 = rsqrt_0(_S33);
    section_0.drop_0 = _S31 - _S33 * _S34;
    section_0.slope_0 = - _S32 * _S34;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_6 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_6) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S35 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S36 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S37 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S35) - crossed_1.half_width_1;
    var _S38 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S35);
    var _S39 : f32;
    if(shown_1.on_top_0)
    {
        _S39 = 0.0f;
    }
    else
    {
        _S39 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S40 : f32;
    if((shown_1.on_top_0) != _S38)
    {
        _S40 = 0.0f;
    }
    else
    {
        _S40 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, select(i32(1), i32(-1), _S35));
    }
    var _S41 : f32 = 2.0f * _S37;
    var _S42 : f32 = 1.0f / max(_S41, 9.999999960041972e-13f);
    var _S43 : f32 = clamp((_S37 - _S36) * _S42, 0.0f, 1.0f);
    var _S44 : f32 = clamp((0.44999998807907104f - _S41 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S39 + (_S40 - _S39) * (_S43 * _S43 * (3.0f - 2.0f * _S43)), (_S39 - _S40) * (6.0f * _S43 * (1.0f - _S43) * _S42) * select(-1.0f, 1.0f, _S35), _S44 * _S44 * (3.0f - 2.0f * _S44));
}

struct PlaneHere_0
{
     plane_3 : Plane_0,
     number_0 : u32,
     level_1 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
     bounds_0 : vec3<f32>,
};

struct Sample_0
{
     here_0 : PlaneHere_0,
     crossing_3 : Crossing_0,
     shown_2 : Shown_0,
     run_2 : Run_0,
     section_1 : Section_0,
     height_1 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_0 : f32,
     slope_y_0 : f32,
};

fn sample_in_0( here_1 : PlaneHere_0,  x_4 : f32,  y_2 : f32,  back_5 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    sample_0.here_0 = here_1;
    var _S45 : Crossing_0 = crossing_at_0(here_1.plane_3, x_4, y_2, back_5);
    sample_0.crossing_3 = _S45;
    var _S46 : Shown_0 = shown_at_0(_S45, back_5);
    sample_0.shown_2 = _S46;
    var _S47 : u32 = select(here_1.plane_3.weft_1, here_1.plane_3.warp_1, _S46.is_warp_0);
    var _S48 : u32 = select(here_1.plane_3.warp_1, here_1.plane_3.weft_1, _S46.is_warp_0);
    var _S49 : Cell_0 = select_cell_0(_S46.is_warp_0, sample_0.crossing_3.warp_2, sample_0.crossing_3.weft_2);
    var _S50 : Cell_0 = select_cell_0(_S46.is_warp_0, sample_0.crossing_3.weft_2, sample_0.crossing_3.warp_2);
    var _S51 : Run_0 = unpack_0(_S47, _S48, _S49.thread_0, _S50, _S46.word_0);
    var _S52 : Section_0 = section_at_0(_S49);
    var _S53 : bool = ((_S46.on_top_0) & (((_S51.distance_0) < (_S52.drop_0 * _S51.bend_1.sine_0))));
    var _S54 : f32 = select(-1.0f, 1.0f, ((_S46.on_top_0) & ((!_S53))));
    var _S55 : f32 = select(_S51.reach_0, _S51.other_reach_0, _S53);
    var _S56 : f32 = select(max(_S55 - _S51.distance_0, 0.0f), _S55 + _S51.distance_0, _S53);
    var _S57 : f32 = _S55 / _S51.bend_1.sine_0 - _S54 * _S52.drop_0;
    var _S58 : f32 = _S56 * _S56;
    var _S59 : f32 = max(_S57 * _S57 - _S58, 9.99999968265522539e-21f);
    var _S60 : f32 = rsqrt_0(_S59);
    var _S61 : f32 = _S58 / (_S59 * _S60 + _S57);
    var _S62 : bool = _S56 > 0.0f;
    var _S63 : f32 = select(-1.0f, 1.0f, _S46.on_top_0) * select(-1.0f, 1.0f, _S51.near_start_0);
    var _S64 : f32 = _S52.slope_0 * select(1.0f, _S57 * _S60, _S62);
    sample_0.slope_across_0 = _S64;
    var _S65 : f32 = select(0.0f, _S63 * _S56 * _S60, _S62);
    sample_0.slope_along_0 = _S65;
    var _S66 : vec3<f32> = dive_0(_S48, _S46, _S51, _S50);
    sample_0.dive_1 = _S66;
    sample_0.height_1 = select(families_0[_S47].height_scale_0 * _S54, 0.0f, _S51.straight_0) * (_S55 * _S51.bend_1.half_tangent_0 - _S61) - families_0[_S47].height_scale_0 * _S52.drop_0 - _S66.x + here_1.level_1;
    var _S67 : f32 = families_0[_S47].height_scale_0 * _S64;
    var _S68 : f32 = families_0[_S47].height_scale_0 * _S65 - _S66.y;
    sample_0.slope_x_0 = select(_S68, _S67, _S46.is_warp_0);
    sample_0.slope_y_0 = select(_S67, _S68, _S46.is_warp_0);
    sample_0.run_2 = _S51;
    sample_0.section_1 = _S52;
    return sample_0;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S69 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S70 : f32 = rsqrt_0(_S69);
    var _S71 : f32 = sine_1 * _S70 * rsqrt_0(_S69 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S71 * _S69, _S71 * across_slope_0 * along_slope_0 + cosine_0 * _S70);
}

fn arc_sine_0( x_5 : f32) -> f32
{
    var _S72 : f32 = abs(x_5);
    var _S73 : bool = _S72 > 0.5f;
    var _S74 : f32 = select(_S72 * _S72, 0.5f * (1.0f - _S72), _S73);
    var _S75 : f32 = select(_S72, sqrt(max(_S74, 0.0f)), _S73);
    var _S76 : f32 = ((((0.04216320067644119f * _S74 + 0.02418131195008755f) * _S74 + 0.04547002539038658f) * _S74 + 0.07495300471782684f) * _S74 + 0.16666752099990845f) * _S74 * _S75 + _S75;
    var _S77 : f32 = select(_S76, 1.57079637050628662f - 2.0f * _S76, _S73);
    return select(_S77, - _S77, x_5 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S78 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S78 / (_S78 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
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
     height_2 : f32,
     normal_0 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     x_6 : f32,
     y_3 : f32,
     shown_share_1 : f32,
     plane_4 : f32,
     layer_0 : u32,
};

fn hit_of_0( point_0 : SurfacePoint_0) -> SurfaceHit_0
{
    var hit_0 : SurfaceHit_0;
    hit_0.place_x_0 = point_0.x_6;
    hit_0.place_y_0 = point_0.y_3;
    hit_0.place_z_0 = point_0.height_2;
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

fn sample_position_0( _S79 : i32,  _S80 : u32,  _S81 : u32) -> vec2<f32>
{
    return vec2<f32>((floor(fraction_of_0(_S80 * u32(2700274806) + u32(1350137403) + _S81 * u32(3152041523)) * bakes_0[_S79].ends_0) + fraction_of_0(_S80 * u32(3679390609) + u32(1839695304) + _S81 * u32(2313257605))) * bakes_0[_S79].spacing_x_0, (floor(fraction_of_0(_S80 * u32(2313257605) + u32(1156628802) + _S81 * u32(3679390609)) * bakes_0[_S79].picks_0) + fraction_of_0(_S80 * u32(3152041523) + u32(1576020761) + _S81 * u32(2700274806))) * bakes_0[_S79].spacing_y_0);
}

fn whole_plane_0( _S82 : u32) -> Plane_0
{
    var plane_5 : Plane_0;
    plane_5.warp_1 = fabrics_0[_S82].warp_0;
    plane_5.weft_1 = fabrics_0[_S82].weft_0;
    plane_5.run_words_1 = fabrics_0[_S82].run_words_0;
    plane_5.ends_3 = fabrics_0[_S82].ends_2;
    plane_5.end_numbers_0 = u32(0);
    plane_5.pick_numbers_0 = u32(0);
    plane_5.max_heights_1 = fabrics_0[_S82].max_heights_0;
    plane_5.max_height_columns_1 = fabrics_0[_S82].max_height_columns_0;
    plane_5.height_low_1 = fabrics_0[_S82].height_low_0;
    plane_5.height_high_1 = fabrics_0[_S82].height_high_0;
    plane_5.front_level_0 = 0.0f;
    plane_5.back_level_0 = 0.0f;
    plane_5.start_x_0 = 0.0f;
    plane_5.start_y_0 = 0.0f;
    plane_5.fine_x_0 = 0.0f;
    plane_5.fine_y_0 = 0.0f;
    return plane_5;
}

fn is_layered_0( _S83 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S83].planes_0) != u32(0))));
}

fn plane_order_0( _S84 : u32,  _S85 : f32,  _S86 : f32,  _S87 : bool) -> u32
{
    var _S88 : u32 = select(u32(0), locate_varied_0(fabrics_0[_S84].plane_axes_0 + u32(1), _S86).thread_0 * fabrics_0[_S84].ends_2 + locate_varied_0(fabrics_0[_S84].plane_axes_0, _S85).thread_0, (fabrics_0[_S84].stacks_0) > u32(1));
    return fabrics_0[_S84].plane_orders_0 + u32(2) * fabrics_0[_S84].planes_0 * (u32(2) * ((((words_0[fabrics_0[_S84].regions_0 + _S88 / u32(4)] >> ((u32(8) * (_S88 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), _S87));
}

fn first_bounds_0( _S89 : u32,  _S90 : u32,  _S91 : f32,  _S92 : f32,  _S93 : bool,  _S94 : bool,  _S95 : bool) -> vec3<f32>
{
    var _S96 : vec3<f32> = bounds_in_0(plane_at_0(fabrics_0[_S89].plane_records_0 + words_0[_S90] * u32(16)), _S91, _S92, _S93, _S94, _S95);
    var _S97 : Cell_0 = locate_varied_0(fabrics_0[_S89].plane_axes_0, _S91);
    var _S98 : Cell_0 = locate_varied_0(fabrics_0[_S89].plane_axes_0 + u32(1), _S92);
    var _S99 : bool = (fabrics_0[_S89].stacks_0) == u32(1);
    return vec3<f32>(_S96.x + table_number_0(_S90 + u32(1)), min(_S96.y, select(select(_S97.below_0, _S97.above_0, _S94), 1.0e+06f, _S99)), min(_S96.z, select(select(_S98.below_0, _S98.above_0, _S95), 1.0e+06f, _S99)));
}

fn plane_shown_0( _S100 : u32,  _S101 : f32,  _S102 : f32,  _S103 : bool,  _S104 : bool,  _S105 : bool) -> PlaneHere_0
{
    var here_2 : PlaneHere_0;
    here_2.plane_3 = whole_plane_0(_S100);
    here_2.number_0 = u32(0);
    here_2.level_1 = 0.0f;
    here_2.edge_x_0 = 1.0e+06f;
    here_2.edge_y_0 = 1.0e+06f;
    here_2.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(_S100))
    {
        return here_2;
    }
    var _S106 : u32 = plane_order_0(_S100, _S101, _S102, _S103);
    var _S107 : vec3<f32> = first_bounds_0(_S100, _S106, _S101, _S102, _S103, _S104, _S105);
    here_2.bounds_0 = _S107;
    var _S108 : bool = (fabrics_0[_S100].stacks_0) == u32(1);
    here_2.edge_x_0 = select(_S107.y, 1.0e+06f, _S108);
    here_2.edge_y_0 = select(_S107.z, 1.0e+06f, _S108);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabrics_0[_S100].planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S109 : u32 = _S106 + u32(2) * rank_1;
        var _S110 : u32 = words_0[_S109];
        here_2.number_0 = _S110;
        here_2.level_1 = table_number_0(_S109 + u32(1));
        here_2.plane_3 = plane_at_0(fabrics_0[_S100].plane_records_0 + _S110 * u32(16));
        var _S111 : Cell_0 = locate_varied_0(here_2.plane_3.warp_1, _S101 - here_2.plane_3.start_x_0);
        var _S112 : Cell_0 = locate_varied_0(here_2.plane_3.weft_1, _S102 - here_2.plane_3.start_y_0);
        var is_hole_1 : bool = !((((abs(_S111.across_0)) < (_S111.half_width_1)) | (((abs(_S112.across_0)) < (_S112.half_width_1)))));
        here_2.edge_x_0 = min(here_2.edge_x_0, select(1.0e+06f, hole_edge_0(_S111, _S104), is_hole_1));
        here_2.edge_y_0 = min(here_2.edge_y_0, select(1.0e+06f, hole_edge_0(_S112, _S105), is_hole_1));
        var _S113 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S113;
    }
    return here_2;
}

fn sample_at_0( _S114 : u32,  _S115 : f32,  _S116 : f32,  _S117 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(_S114, _S115, _S116, _S117, true, true), _S115, _S116, _S117);
}

fn surface_of_0( _S118 : u32,  _S119 : Sample_0,  _S120 : f32,  _S121 : f32,  _S122 : bool) -> SurfacePoint_0
{
    var _S123 : u32 = select(fabrics_0[_S118].weft_0, fabrics_0[_S118].warp_0, _S119.shown_2.is_warp_0);
    var _S124 : f32 = families_0[_S123].twist_sine_0 * select(1.0f, -1.0f, _S122);
    var _S125 : f32 = families_0[_S123].twist_cosine_0;
    var _S126 : f32 = select(-1.0f, 1.0f, _S119.shown_2.is_warp_0);
    var _S127 : vec2<f32> = fibre_direction_0(_S119.slope_across_0, _S126 * _S119.slope_along_0, _S124, families_0[_S123].twist_cosine_0);
    var _S128 : f32 = _S127.x;
    var _S129 : f32 = _S127.y;
    var _S130 : f32 = select(_S119.slope_y_0, _S119.slope_x_0, _S119.shown_2.is_warp_0) * _S128 + _S126 * select(_S119.slope_x_0, _S119.slope_y_0, _S119.shown_2.is_warp_0) * _S129;
    var _S131 : f32 = select(_S119.crossing_3.weft_2.half_width_1, _S119.crossing_3.warp_2.half_width_1, _S119.shown_2.is_warp_0) * 1.0154266357421875f;
    var _S132 : f32 = _S131 * arc_sine_0(clamp(_S119.section_1.across_1 / _S131, -1.0f, 1.0f));
    var _S133 : f32 = select(_S119.here_0.plane_3.start_x_0 - _S120, _S121 - _S119.here_0.plane_3.start_y_0, _S119.shown_2.is_warp_0);
    var point_1 : SurfacePoint_0;
    point_1.hole_1 = _S119.shown_2.hole_0;
    point_1.is_warp_1 = _S119.shown_2.is_warp_0;
    point_1.warp_thread_0 = _S119.crossing_3.warp_2.thread_0;
    point_1.weft_thread_0 = _S119.crossing_3.weft_2.thread_0;
    if(is_layered_0(_S118))
    {
        point_1.warp_thread_0 = words_0[_S119.here_0.plane_3.end_numbers_0 + point_1.warp_thread_0];
        point_1.weft_thread_0 = words_0[_S119.here_0.plane_3.pick_numbers_0 + point_1.weft_thread_0];
    }
    point_1.height_2 = _S119.height_1;
    point_1.plane_4 = _S119.here_0.level_1;
    point_1.layer_0 = _S119.here_0.number_0;
    point_1.normal_0 = normalize(vec3<f32>(- _S119.slope_x_0, - _S119.slope_y_0, 1.0f));
    point_1.tangent_0 = normalize(select_vector_0(_S119.shown_2.is_warp_0, vec3<f32>(_S128, _S129, _S130), vec3<f32>(- _S129, _S128, _S130)));
    point_1.across_2 = _S119.section_1.across_1;
    point_1.fibre_across_0 = _S132 * _S125 + _S133 * _S124;
    point_1.fibre_along_0 = _S133 * _S125 - _S132 * _S124;
    var _S134 : f32 = run_share_0(_S119.shown_2.word_0);
    point_1.shown_share_1 = select(1.0f - _S134, _S134, _S119.shown_2.on_top_0);
    point_1.x_6 = _S120;
    point_1.y_3 = _S121;
    return point_1;
}

fn surface_at_0( _S135 : u32,  _S136 : f32,  _S137 : f32,  _S138 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S135, sample_at_0(_S135, _S136, _S137, _S138), _S136, _S137, _S138);
}

@compute
@workgroup_size(64, 1, 1)
fn bake_top_down(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S139 : u32 = thread_index_0(id_1);
    if(_S139 >= u32(16384))
    {
        return;
    }
    var _S140 : vec2<f32> = sample_position_0(i32(0), (_S139 & (u32(8191))), u32(0));
    var _S141 : SurfaceHit_0 = hit_of_0(surface_at_0(bakes_0[i32(0)].fabric_0, _S140.x, _S140.y, _S139 >= u32(8192)));
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].place_x_0 = _S141.place_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].place_y_0 = _S141.place_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].place_z_0 = _S141.place_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].flags_0 = _S141.flags_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].normal_x_0 = _S141.normal_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].normal_y_0 = _S141.normal_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].normal_z_0 = _S141.normal_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].tangent_x_0 = _S141.tangent_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].tangent_y_0 = _S141.tangent_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].tangent_z_0 = _S141.tangent_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S139].shown_share_0 = _S141.shown_share_0;
    return;
}

fn sine_cosine_0( x_7 : f32) -> vec2<f32>
{
    var _S142 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S143 : f32 = x_7 - _S142 * 1.5703125f - _S142 * 0.00048375129699707f - _S142 * 7.54979012640433211e-08f;
    var _S144 : f32 = _S143 * _S143;
    var _S145 : f32 = ((-0.00019515295571182f * _S144 + 0.00833216123282909f) * _S144 - 0.16666655242443085f) * _S144 * _S143 + _S143;
    var _S146 : f32 = ((0.00002443315679557f * _S144 - 0.00138873164542019f) * _S144 + 0.04166664555668831f) * _S144 * _S144 - 0.5f * _S144 + 1.0f;
    var _S147 : u32 = (u32(i32(_S142)) & (u32(3)));
    var _S148 : vec2<f32> = select_vector_1(((_S147 & (u32(1)))) != u32(0), vec2<f32>(_S146, _S145), vec2<f32>(_S145, _S146));
    var _S149 : f32 = _S148.x;
    var _S150 : f32 = _S148.y;
    return vec2<f32>(select(_S149, - _S149, ((_S147 & (u32(2)))) != u32(0)), select(_S150, - _S150, (((_S147 + u32(1)) & (u32(2)))) != u32(0)));
}

fn node_direction_0( node_0 : u32) -> vec3<f32>
{
    var _S151 : u32 = node_0 % u32(8);
    var _S152 : vec2<f32> = sine_cosine_0(f32(node_0 / u32(8)) * 0.19634954631328583f);
    var _S153 : f32 = sqrt(1.0f - RING_COSINES_0[_S151] * RING_COSINES_0[_S151]);
    return vec3<f32>(_S153 * _S152.y, _S153 * _S152.x, RING_COSINES_0[_S151]);
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
     right_1 : bool,
     up_1 : bool,
};

fn step_control_0( direction_0 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S154 : f32 = direction_0.x;
    control_0.per_x_0 = 1.0f / max(abs(_S154), 9.99999971718068537e-10f);
    var _S155 : f32 = direction_0.y;
    control_0.per_y_0 = 1.0f / max(abs(_S155), 9.99999971718068537e-10f);
    control_0.right_1 = _S154 > 0.0f;
    control_0.up_1 = _S155 > 0.0f;
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

fn outline_distance_0( cell_5 : Cell_0,  shown_3 : Shown_0,  run_3 : Run_0,  lengthwise_0 : bool,  forwards_1 : bool) -> f32
{
    var _S156 : f32 = select(- cell_5.across_0, cell_5.across_0, forwards_1);
    var _S157 : f32 = select(cell_5.below_0, cell_5.above_0, forwards_1);
    var _S158 : f32 = - cell_5.half_width_1;
    var _S159 : bool = _S156 < _S158;
    var _S160 : bool = _S156 >= (cell_5.half_width_1);
    var _S161 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_1))))) & ((!shown_3.hole_0)));
    var _S162 : f32 = select(cell_5.half_width_1, _S158, _S159) - _S156;
    var _S163 : f32 = select(_S157, 2.0f * _S157 + _S156 - cell_5.half_width_1, ((shown_3.hole_0) | (((_S161 & ((!shown_3.on_top_0)))))));
    if((((_S161 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_1) & (_S159)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_1);
    }
    return select(_S162, _S163, _S160);
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
     edge_x_1 : f32,
     edge_y_1 : f32,
};

fn ViewRay_rate_0( this_2 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_1 * this_2.slope_1.x + here_3.slope_y_1 * this_2.slope_1.y - 1.0f;
}

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_4 : Probe_0) -> f32
{
    var _S164 : f32 = previous_1.rate_0 * step_4;
    var _S165 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_4.hole_2)))) | (((previous_1.yarn_0) != (here_4.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S164) >= 0.0f) & (((3.0f * clearance_1 - _S165) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S166 : f32 = clearance_1 - previous_1.clearance_0;
    var _S167 : f32 = 6.0f * _S166 - 4.0f * _S164 - 2.0f * _S165;
    var _S168 : f32 = -2.0f * _S164 / max(_S167 + sqrt(max(_S167 * _S167 - 4.0f * (3.0f * (_S164 + _S165 - 2.0f * _S166)) * _S164, 0.0f)), 9.99999968265522539e-21f);
    var _S169 : f32 = 1.0f - _S168;
    return select(-1.0f, _S169 * step_4, ((((_S168 > 0.01999999955296516f) & ((_S169 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S168 + 1.0f) + _S164 * _S168) * _S169 * _S169 + (clearance_1 * (2.0f * _S169 + 1.0f) - _S165 * _S169) * _S168 * _S168) < 0.0f))));
}

fn StepControl_to_next_sample_0( this_3 : StepControl_0,  here_5 : Probe_0,  clearance_2 : f32,  rate_2 : f32) -> f32
{
    var _S170 : f32 = min(here_5.edge_x_1 * this_3.per_x_0, here_5.edge_y_1 * this_3.per_y_0);
    return min(this_3.step_2, select(max(_S170, 0.0f) + this_3.epsilon_0, _S170 - this_3.epsilon_0, ((((!here_5.hole_2) & (((rate_2 * _S170 + clearance_2) < 0.0f)))) & ((_S170 > (2.0f * this_3.epsilon_0))))));
}

fn after_sample_0( clearance_3 : f32,  rate_3 : f32,  here_6 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_3, 1.0e+09f, here_6.hole_2);
    previous_2.rate_0 = rate_3;
    previous_2.yarn_0 = here_6.yarn_1;
    previous_2.known_0 = ((!here_6.hole_2) & ((!is_cell_exit_0)));
    return previous_2;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S171 : f32 = end_0 - start_1;
    var _S172 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S171;
    var _S173 : f32 = 3.0f * _S171 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S171, 9.99999968265522539e-21f);
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
        var _S174 : f32 = clamp(share_0 - (((_S172 * share_0 + _S173) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S172 * share_0 + 2.0f * _S173) * share_0 + start_rate_0, 0.10000000149011612f * _S171 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S175 : i32 = i_0 + i32(1);
        share_0 = _S174;
        i_0 = _S175;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn angle_of_0( direction_1 : vec2<f32>) -> f32
{
    var _S176 : f32 = direction_1.x;
    var _S177 : f32 = arc_sine_0(_S176);
    var _S178 : bool = _S176 < 0.0f;
    var _S179 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S178);
    var _S180 : f32 = direction_1.y;
    return select(0.5f * _S179 - select(1.0f, -1.0f, _S178) * arc_sine_0(_S180), select(_S177, _S179 - _S177, _S180 < 0.0f), (abs(_S176)) < 0.69999998807907104f);
}

fn lattice_position_0( _S181 : i32,  _S182 : u32,  _S183 : u32) -> vec2<f32>
{
    var _S184 : u32 = u32(4294967295) / bakes_0[_S181].rays_0;
    return vec2<f32>(fraction_of_0(_S182 * _S184 + _S183 * u32(3242174889)) * (bakes_0[_S181].ends_0 * bakes_0[_S181].spacing_x_0), fraction_of_0(_S182 * u32(2654435769) + _S183 * u32(3488053409)) * (bakes_0[_S181].picks_0 * bakes_0[_S181].spacing_y_0));
}

struct Hit_0
{
     x_8 : f32,
     y_4 : f32,
     hole_3 : bool,
     height_5 : f32,
};

fn steps_per_length_0( _S185 : u32,  _S186 : SearchQuality_0,  _S187 : vec3<f32>) -> f32
{
    return max(max(abs(_S187.x) * fabrics_0[_S185].threads_per_x_0, abs(_S187.y) * fabrics_0[_S185].threads_per_y_0) * _S186.steps_per_thread_0, abs(_S187.z) * fabrics_0[_S185].per_relief_0 * _S186.steps_per_relief_0);
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

fn plane_count_0( _S188 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S188].planes_0, is_layered_0(_S188));
}

fn plane_of_0( _S189 : u32,  _S190 : u32) -> Plane_0
{
    if(!is_layered_0(_S189))
    {
        return whole_plane_0(_S189);
    }
    return plane_at_0(fabrics_0[_S189].plane_records_0 + _S190 * u32(16));
}

fn max_height_along_0( _S191 : u32,  _S192 : f32,  _S193 : f32,  _S194 : f32,  _S195 : vec3<f32>,  _S196 : bool) -> f32
{
    var _S197 : f32 = _S195.x;
    var _S198 : f32 = _S195.y;
    var _S199 : u32 = select(u32(0), u32(1), _S197 > 0.0f) + select(u32(0), u32(2), _S198 > 0.0f);
    var _S200 : f32 = max(abs(_S197) * fabrics_0[_S191].threads_per_x_0, abs(_S198) * fabrics_0[_S191].threads_per_y_0) / _S195.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_1 : u32 = u32(0);
    for(;;)
    {
        if(number_1 < (plane_count_0(_S191)))
        {
        }
        else
        {
            break;
        }
        var _S201 : Plane_0 = plane_of_0(_S191, number_1);
        var _S202 : u32 = (words_0[_S201.max_heights_1 + u32(4) * (locate_0(_S201.weft_1, _S193 - _S201.start_y_0).thread_0 / u32(2) * _S201.max_height_columns_1 + locate_0(_S201.warp_1, _S192 - _S201.start_x_0).thread_0 / u32(2)) + _S199] >> (u32(select(i32(0), i32(4), _S196))));
        var _S203 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S202 & (u32(15)))), f32((((_S202 >> (u32(8)))) & (u32(15)))), f32((((_S202 >> (u32(16)))) & (u32(15)))), f32((((_S202 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S201.height_high_1) + vec4<f32>(select(_S201.front_level_0, _S201.back_level_0, _S196)));
        var _S204 : u32 = number_1 + u32(1);
        levels_4 = _S203;
        number_1 = _S204;
    }
    var max_height_0 : f32 = fabrics_0[_S191].height_high_0;
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
        if(((max_height_0 - _S194) * _S200) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, levels_4[number_2]);
        }
        number_2 = number_2 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S205 : u32,  _S206 : f32,  _S207 : f32,  _S208 : bool,  _S209 : bool,  _S210 : bool) -> vec3<f32>
{
    if(is_layered_0(_S205))
    {
        return first_bounds_0(_S205, plane_order_0(_S205, _S206, _S207, _S208), _S206, _S207, _S208, _S209, _S210);
    }
    return bounds_in_0(whole_plane_0(_S205), _S206, _S207, _S208, _S209, _S210);
}

fn first_sample_height_0( _S211 : u32,  _S212 : ViewRay_0,  _S213 : StepControl_0,  _S214 : bool) -> f32
{
    var _S215 : f32 = max_height_along_0(_S211, _S212.origin_0.x, _S212.origin_0.y, 0.0f, vec3<f32>(_S212.slope_1, 1.0f), _S214);
    var count_1 : u32 = u32(0);
    var height_7 : f32 = _S215;
    for(;;)
    {
        if(count_1 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S216 : vec2<f32> = ViewRay_at_0(_S212, height_7);
        var _S217 : vec3<f32> = cell_bounds_0(_S211, _S216.x, _S216.y, _S214, _S213.right_1, _S213.up_1);
        var _S218 : f32 = height_7 - _S217.x;
        var _S219 : f32 = StepControl_to_cell_exit_0(_S213, _S217.y, _S217.z);
        var height_8 : f32 = height_7 - clamp(_S218, 0.0f, _S219);
        if(_S218 <= _S219)
        {
            height_7 = height_8;
            break;
        }
        count_1 = count_1 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn probe_0( _S220 : u32,  _S221 : f32,  _S222 : f32,  _S223 : bool,  _S224 : bool,  _S225 : bool) -> Probe_0
{
    var _S226 : PlaneHere_0 = plane_shown_0(_S220, _S221, _S222, _S223, _S224, _S225);
    var _S227 : Sample_0 = sample_in_0(_S226, _S221, _S222, _S223);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S227.height_1;
    probe_1.hole_2 = _S227.shown_2.hole_0;
    probe_1.slope_x_1 = _S227.slope_x_0;
    probe_1.slope_y_1 = _S227.slope_y_0;
    var _S228 : bool = !is_layered_0(_S220);
    probe_1.yarn_1 = select(_S227.crossing_3.weft_2.thread_0 * u32(2), _S227.crossing_3.warp_2.thread_0 * u32(2) + u32(1), _S227.shown_2.is_warp_0) * plane_count_0(_S220) + _S226.number_0;
    probe_1.cell_max_0 = select(_S226.bounds_0.x, cell_maximum_0(_S226.plane_3, _S227.crossing_3), _S228);
    probe_1.side_x_1 = select(_S226.bounds_0.y, select(_S227.crossing_3.warp_2.below_0, _S227.crossing_3.warp_2.above_0, _S224), _S228);
    probe_1.side_y_1 = select(_S226.bounds_0.z, select(_S227.crossing_3.weft_2.below_0, _S227.crossing_3.weft_2.above_0, _S225), _S228);
    probe_1.edge_x_1 = min(_S226.edge_x_0, outline_distance_0(_S227.crossing_3.warp_2, _S227.shown_2, _S227.run_2, !_S227.shown_2.is_warp_0, _S224));
    probe_1.edge_y_1 = min(_S226.edge_y_0, outline_distance_0(_S227.crossing_3.weft_2, _S227.shown_2, _S227.run_2, _S227.shown_2.is_warp_0, _S225));
    return probe_1;
}

fn search_down_0( _S229 : u32,  _S230 : ViewRay_0,  _S231 : StepControl_0,  _S232 : bool) -> ViewRayEnd_0
{
    var _S233 : f32 = fabrics_0[_S229].height_low_0 - (fabrics_0[_S229].height_high_0 - fabrics_0[_S229].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S229, _S230, _S231, _S232);
    end_1.last_step_0 = _S231.epsilon_0;
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
        var _S234 : vec2<f32> = ViewRay_at_0(_S230, end_1.height_6);
        var _S235 : Probe_0 = probe_0(_S229, _S234.x, _S234.y, _S232, _S231.right_1, _S231.up_1);
        var _S236 : f32 = end_1.height_6 - _S235.height_4;
        var _S237 : f32 = ViewRay_rate_0(_S230, _S235);
        end_1.depth_0 = - _S236;
        end_1.rate_4 = _S237;
        var _S238 : bool = !_S235.hole_2;
        end_1.smooth_0 = ((((end_1.previous_3.known_0) & (_S238))) & (((end_1.previous_3.yarn_0) == (_S235.yarn_1))));
        if((((_S238 & ((_S236 <= 0.0f)))) | (((end_1.height_6) <= _S233))))
        {
            break;
        }
        var _S239 : f32 = way_back_to_dip_0(end_1.previous_3, _S236, _S237, end_1.last_step_0, _S235);
        if(_S239 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S239;
            end_1.last_step_0 = end_1.last_step_0 - _S239;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S240 : f32 = min(StepControl_to_cell_exit_0(_S231, _S235.side_x_1, _S235.side_y_1), end_1.height_6 - _S235.cell_max_0);
        var _S241 : f32 = StepControl_to_next_sample_0(_S231, _S235, _S236, _S237);
        end_1.previous_3 = after_sample_0(_S236, _S237, _S235, _S240 > _S241);
        var _S242 : f32 = max(_S240, _S241);
        end_1.last_step_0 = _S242;
        end_1.height_6 = end_1.height_6 - _S242;
        count_2 = count_2 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S243 : u32,  _S244 : ViewRay_0,  _S245 : StepControl_0,  _S246 : bool,  _S247 : ViewRayEnd_0,  _S248 : u32) -> f32
{
    var _S249 : f32 = fabrics_0[_S243].height_high_0 - fabrics_0[_S243].height_low_0;
    var above_2 : f32 = _S247.height_6 + _S247.last_step_0;
    var above_gap_1 : f32 = clamp(_S247.previous_3.clearance_0, 0.0f, _S249);
    var under_gap_1 : f32 = clamp(_S247.depth_0, 0.0f, _S249);
    var middle_0 : f32 = select(between_0(above_2, _S247.height_6, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S247.previous_3.rate_0 * _S247.last_step_0, _S247.rate_4 * _S247.last_step_0) * _S247.last_step_0, _S247.smooth_0);
    var side_0 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S247.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S248)
        {
        }
        else
        {
            break;
        }
        var _S250 : vec2<f32> = ViewRay_at_0(_S244, middle_0);
        var _S251 : Probe_0 = probe_0(_S243, _S250.x, _S250.y, _S246, _S245.right_1, _S245.up_1);
        var _S252 : f32 = clamp(middle_0 - select(_S251.height_4, -1.0e+09f, _S251.hole_2), - _S249, _S249);
        if(_S252 <= 0.0f)
        {
            var _S253 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_0 > 0.0f);
            var _S254 : f32 = - _S252;
            under_1 = middle_0;
            above_gap_2 = _S253;
            under_gap_2 = _S254;
            side_0 = 1.0f;
        }
        else
        {
            var _S255 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_0 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S252;
            under_gap_2 = _S255;
            side_0 = -1.0f;
        }
        var _S256 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S252 / min(ViewRay_rate_0(_S244, _S251), -9.99999997475242708e-07f), under_1, above_3), _S247.smooth_0);
        var _S257 : u32 = i_1 + u32(1);
        middle_0 = _S256;
        i_1 = _S257;
    }
    return select(under_1, middle_0, _S247.smooth_0);
}

fn first_hit_of_yarn_0( _S258 : u32,  _S259 : SearchQuality_0,  _S260 : f32,  _S261 : f32,  _S262 : vec3<f32>,  _S263 : bool) -> Hit_0
{
    var _S264 : f32 = max(_S262.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S260, _S261);
    var _S265 : vec2<f32> = _S262.xy / vec2<f32>(_S264);
    ray_0.slope_1 = _S265;
    var _S266 : StepControl_0 = step_control_0((vec2<f32>(0) - _S265), 1.0f / max(steps_per_length_0(_S258, _S259, _S262) / _S264, 9.99999971718068537e-10f));
    var _S267 : ViewRayEnd_0 = search_down_0(_S258, ray_0, _S266, _S263);
    var hit_1 : Hit_0;
    hit_1.hole_3 = false;
    var _S268 : f32 = refined_height_0(_S258, ray_0, _S266, _S263, _S267, _S259.refinements_0);
    hit_1.height_5 = _S268;
    var _S269 : vec2<f32> = ViewRay_at_0(ray_0, _S268);
    hit_1.x_8 = _S269.x;
    hit_1.y_4 = _S269.y;
    return hit_1;
}

fn surface_met_0( _S270 : u32,  _S271 : f32,  _S272 : f32,  _S273 : f32,  _S274 : vec3<f32>,  _S275 : bool) -> SurfacePoint_0
{
    var _S276 : Sample_0 = sample_at_0(_S270, _S271, _S272, _S275);
    var point_2 : SurfacePoint_0 = surface_of_0(_S270, _S276, _S271, _S272, _S275);
    var _S277 : u32 = select(fabrics_0[_S270].weft_0, fabrics_0[_S270].warp_0, point_2.is_warp_1);
    var _S278 : f32 = select(_S276.crossing_3.weft_2.half_width_1, _S276.crossing_3.warp_2.half_width_1, point_2.is_warp_1) * 1.0154266357421875f;
    var _S279 : f32 = _S276.dive_1.z;
    var _S280 : f32 = _S276.slope_along_0 - (1.0f - _S279) * _S276.dive_1.y / families_0[_S277].height_scale_0;
    var _S281 : f32 = rsqrt_0(_S280 * _S280 + 1.0f);
    var _S282 : f32 = _S274.x;
    var _S283 : f32 = _S274.y;
    var _S284 : f32 = select(_S283, _S282, point_2.is_warp_1);
    var _S285 : f32 = _S274.z;
    var _S286 : f32 = (_S285 / families_0[_S277].height_scale_0 - _S280 * select(_S282, _S283, point_2.is_warp_1)) * _S281;
    var _S287 : f32 = square_0(_S278);
    var _S288 : f32 = sqrt(max(_S287 - square_0(point_2.across_2), 0.0f)) - (_S276.height_1 + _S279 * _S276.dive_1.x - _S273) / families_0[_S277].height_scale_0 * _S281;
    var _S289 : f32 = square_0(_S284) + square_0(_S286) + 9.999999960041972e-13f;
    var _S290 : f32 = point_2.across_2 * _S284 + _S288 * _S286;
    var _S291 : f32 = square_0(point_2.across_2) + square_0(_S288) - _S287;
    var _S292 : f32 = sqrt(max(square_0(_S290) - _S289 * _S291, 0.0f));
    var _S293 : f32 = clamp(select((_S292 - _S290) / _S289, - _S291 / max(_S290 + _S292, 9.999999960041972e-13f), _S290 > 0.0f), - _S278, _S278);
    var _S294 : f32 = point_2.across_2 + _S293 * _S284;
    point_2.across_2 = _S294;
    var _S295 : vec2<f32> = normalize(vec2<f32>(_S294, _S288 + _S293 * _S286));
    var _S296 : f32 = select(-1.0f, 1.0f, point_2.is_warp_1);
    var _S297 : f32 = families_0[_S277].twist_sine_0 * select(1.0f, -1.0f, _S275);
    var _S298 : f32 = _S295.x;
    var _S299 : f32 = _S297 * _S298 * _S281;
    var _S300 : f32 = _S295.y;
    var _S301 : f32 = - _S297 * _S300;
    var _S302 : f32 = families_0[_S277].twist_cosine_0 * _S281 - _S296 * _S280 * _S299;
    var _S303 : f32 = families_0[_S277].height_scale_0 * (families_0[_S277].twist_cosine_0 * _S296 * _S280 * _S281 + _S299);
    var _S304 : f32 = families_0[_S277].height_scale_0 * _S298;
    var _S305 : f32 = - families_0[_S277].height_scale_0 * _S280 * _S281 * _S300;
    point_2.normal_0 = normalize(vec3<f32>(select(_S305, _S304, point_2.is_warp_1), select(_S304, _S305, point_2.is_warp_1), _S281 * _S300));
    point_2.tangent_0 = normalize(vec3<f32>(select(- _S302, _S301, point_2.is_warp_1), select(_S301, _S302, point_2.is_warp_1), _S303));
    var _S306 : f32 = _S278 * angle_of_0(_S295);
    var _S307 : f32 = select(- _S271 - _S293 * _S282, _S272 + _S293 * _S283, point_2.is_warp_1);
    point_2.fibre_across_0 = _S306 * families_0[_S277].twist_cosine_0 + _S307 * _S297;
    point_2.fibre_along_0 = _S307 * families_0[_S277].twist_cosine_0 - _S306 * _S297;
    var _S308 : f32 = 0.00999999977648258f * _S278;
    var _S309 : f32 = - _S308;
    var _S310 : bool = _S293 < _S309;
    var _S311 : f32 = select(_S308, _S309, _S284 < 0.0f);
    var _S312 : f32 = max(_S293, 0.0f);
    point_2.x_6 = point_2.x_6 + select(_S312 * _S282, select(0.0f, _S311, point_2.is_warp_1), _S310);
    point_2.y_3 = point_2.y_3 + select(_S312 * _S283, select(_S311, 0.0f, point_2.is_warp_1), _S310);
    point_2.height_2 = select(_S273 + _S293 * _S285, _S273, _S310);
    return point_2;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_views(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    var _S313 : u32 = thread_index_0(id_2);
    var _S314 : u32 = bakes_0[i32(0)].rays_0;
    var _S315 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    if(_S313 >= (u32(2) * _S315))
    {
        return;
    }
    var _S316 : u32 = bakes_0[i32(0)].fabric_0;
    var _S317 : bool = _S313 >= _S315;
    var _S318 : u32 = select(_S313, _S313 - _S315, _S317);
    var _S319 : u32 = _S318 / _S314;
    var _S320 : u32 = _S318 % _S314;
    var _S321 : vec2<f32> = lattice_position_0(i32(0), _S320, _S319);
    var _S322 : vec3<f32> = node_direction_0(_S319);
    var _S323 : Hit_0 = first_hit_of_yarn_0(_S316, bake_quality_0(), _S321.x, _S321.y, _S322, _S317);
    var hit_2 : SurfaceHit_0 = hit_of_0(surface_met_0(_S316, _S323.x_8, _S323.y_4, _S323.height_5, _S322, _S317));
    hit_2.flags_0 = ((hit_2.flags_0) | (select(u32(0), u32(4), (_S323.height_5) <= 0.0f)));
    hits_0[_S313].place_x_0 = hit_2.place_x_0;
    hits_0[_S313].place_y_0 = hit_2.place_y_0;
    hits_0[_S313].place_z_0 = hit_2.place_z_0;
    hits_0[_S313].flags_0 = hit_2.flags_0;
    hits_0[_S313].normal_x_0 = hit_2.normal_x_0;
    hits_0[_S313].normal_y_0 = hit_2.normal_y_0;
    hits_0[_S313].normal_z_0 = hit_2.normal_z_0;
    hits_0[_S313].tangent_x_0 = hit_2.tangent_x_0;
    hits_0[_S313].tangent_y_0 = hit_2.tangent_y_0;
    hits_0[_S313].tangent_z_0 = hit_2.tangent_z_0;
    hits_0[_S313].shown_share_0 = hit_2.shown_share_0;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_gap_starts(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    var _S324 : u32 = thread_index_0(id_3);
    var _S325 : u32 = bakes_0[i32(0)].rays_0;
    var _S326 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    var _S327 : bool;
    if(_S324 >= (u32(2) * _S326))
    {
        _S327 = true;
    }
    else
    {
        _S327 = (((hits_0[_S324].flags_0) & (u32(4)))) == u32(0);
    }
    if(_S327)
    {
        return;
    }
    var _S328 : u32 = bakes_0[i32(0)].fabric_0;
    var _S329 : bool = _S324 >= _S326;
    var _S330 : u32 = select(_S324, _S324 - _S326, _S329);
    var _S331 : u32 = _S330 % _S325;
    var _S332 : u32 = _S330 / _S325;
    var _S333 : vec2<f32> = lattice_position_0(i32(0), _S331, _S332);
    var _S334 : f32 = _S333.x;
    var _S335 : f32 = _S333.y;
    if(!shown_at_0(crossing_at_0(plane_shown_0(_S328, _S334, _S335, _S329, true, true).plane_3, _S334, _S335, _S329), _S329).hole_0)
    {
        hits_0[_S324].flags_0 = ((hits_0[_S324].flags_0) & (u32(4294967291)));
    }
    return;
}

fn scratch_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((scratch_0[index_2])));
}

fn is_free_0( _S336 : u32,  _S337 : SearchQuality_0,  _S338 : vec3<f32>,  _S339 : vec3<f32>,  _S340 : bool,  _S341 : f32) -> bool
{
    var _S342 : f32 = _S339.z;
    if(_S342 <= 0.0f)
    {
        return false;
    }
    var _S343 : f32 = 1.0f / max(_S337.shadow_share_0 * steps_per_length_0(_S336, _S337, _S339), 9.99999971718068537e-10f);
    var _S344 : StepControl_0 = step_control_0(_S339.xy, _S343);
    var previous_4 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_1 : f32 = 0.0f;
    for(;;)
    {
        if(((count_3 < u32(1024)) & (((_S338.z + _S342 * distance_1) < _S341))))
        {
        }
        else
        {
            break;
        }
        var _S345 : vec3<f32> = _S338 + _S339 * vec3<f32>(distance_1);
        var _S346 : Probe_0 = probe_0(_S336, _S345.x, _S345.y, _S340, _S344.right_1, _S344.up_1);
        var _S347 : f32 = _S345.z;
        var _S348 : f32 = _S347 - _S346.height_4;
        var _S349 : f32 = _S342 - _S346.slope_x_1 * _S339.x - _S346.slope_y_1 * _S339.y;
        if(((!_S346.hole_2) & ((_S348 < 0.0f))))
        {
            return false;
        }
        var _S350 : f32 = way_back_to_dip_0(previous_4, _S348, _S349, last_step_1, _S346);
        if(_S350 >= 0.0f)
        {
            var last_step_2 : f32 = last_step_1 - _S350;
            distance_1 = distance_1 - _S350;
            last_step_1 = last_step_2;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S351 : bool = _S347 > (_S346.cell_max_0);
        var last_step_3 : f32 = select(StepControl_to_next_sample_0(_S344, _S346, _S348, _S349), max(StepControl_to_cell_exit_0(_S344, _S346.side_x_1, _S346.side_y_1), _S343), _S351);
        var distance_2 : f32 = distance_1 + last_step_3;
        previous_4 = after_sample_0(_S348, _S349, _S346, _S351);
        distance_1 = distance_2;
        last_step_1 = last_step_3;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S352 : u32,  _S353 : SearchQuality_0,  _S354 : f32,  _S355 : f32,  _S356 : vec3<f32>,  _S357 : bool) -> bool
{
    if(!sample_at_0(_S352, _S354, _S355, _S357).shown_2.hole_0)
    {
        return false;
    }
    var _S358 : vec3<f32> = vec3<f32>(_S354, _S355, 0.0f);
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
        var _S359 : bool = is_free_0(_S352, _S353, _S358, select_vector_0(side_1 == u32(0), _S356, vec3<f32>(- _S356.x, - _S356.y, _S356.z)), _S357 != (side_1 == u32(1)), fabrics_0[_S352].height_high_0);
        var _S360 : u32 = side_1 + u32(1);
        passes_0 = _S359;
        side_1 = _S360;
    }
    return passes_0;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_nulls(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    var _S361 : u32 = thread_index_0(id_4);
    var _S362 : u32 = bakes_0[i32(0)].rays_0;
    var _S363 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    var _S364 : u32 = u32(2) * _S363;
    var _S365 : bool = _S361 < _S364;
    var _S366 : u32 = select(_S361 - _S364, u32(0), _S365);
    var _S367 : u32 = _S366 % u32(128);
    var _S368 : bool = !_S365;
    var _S369 : bool;
    if(_S368)
    {
        if(_S366 >= u32(32768))
        {
            _S369 = true;
        }
        else
        {
            _S369 = _S367 >= scratch_0[bakes_0[i32(0)].facts_0 + u32(9)];
        }
    }
    else
    {
        _S369 = false;
    }
    if(_S369)
    {
        return;
    }
    if(_S365)
    {
        _S369 = (((hits_0[_S361].flags_0) & (u32(4)))) == u32(0);
    }
    else
    {
        _S369 = false;
    }
    if(_S369)
    {
        return;
    }
    var _S370 : u32 = bakes_0[i32(0)].fabric_0;
    if(_S365)
    {
        _S369 = _S361 >= _S363;
    }
    else
    {
        _S369 = false;
    }
    var _S371 : u32 = select(_S361, _S361 - _S363, _S369);
    var _S372 : u32 = _S371 / _S362;
    var _S373 : u32 = select(_S366 / u32(128), _S372, _S365);
    var _S374 : u32 = _S371 % _S362;
    var _S375 : vec2<f32> = lattice_position_0(i32(0), _S374, _S373);
    var place_0 : vec2<f32>;
    if(_S368)
    {
        var _S376 : u32 = bakes_0[i32(0)].gaps_0 + u32(2) * _S367;
        place_0 = vec2<f32>(scratch_number_0(_S376), scratch_number_0(_S376 + u32(1)));
    }
    else
    {
        place_0 = _S375;
    }
    var _S377 : bool = passes_through_0(_S370, bake_quality_0(), place_0.x, place_0.y, node_direction_0(_S373), _S369);
    if(_S365)
    {
        hits_0[_S361].flags_0 = ((hits_0[_S361].flags_0) | (select(u32(0), u32(8), _S377)));
    }
    else
    {
        scratch_0[bakes_0[i32(0)].gap_nulls_0 + _S366] = u32(_S377);
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

fn unoccluded_0( _S378 : u32,  _S379 : SearchQuality_0,  _S380 : f32,  _S381 : f32,  _S382 : f32,  _S383 : vec3<f32>,  _S384 : bool) -> bool
{
    if((_S383.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S378, _S379, vec3<f32>(_S380, _S381, _S382 + fabrics_0[_S378].lift_0), _S383, _S384, max_height_along_0(_S378, _S380, _S381, _S382, _S383, _S384));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_shadows(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    var _S385 : u32 = thread_index_0(id_5);
    var _S386 : u32 = bakes_0[i32(0)].rays_0;
    var _S387 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    if(_S385 >= (u32(2) * _S387))
    {
        return;
    }
    var _S388 : u32 = bakes_0[i32(0)].fabric_0;
    var _S389 : bool = _S385 >= _S387;
    var _S390 : u32 = select(_S385, _S385 - _S387, _S389);
    var _S391 : u32 = _S390 / _S386;
    var _S392 : u32 = _S390 % _S386;
    var _S393 : SurfaceHit_std430_0 = hits_0[start_of_shadow_ray_0(_S391, _S392, _S386) + select(u32(0), _S387, _S389)];
    var _S394 : f32 = _S393.place_x_0;
    var _S395 : f32 = _S393.place_y_0;
    var _S396 : SurfacePoint_0 = surface_at_0(_S388, _S393.place_x_0, _S393.place_y_0, !_S389);
    var _S397 : vec3<f32> = node_direction_0(_S391);
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
        var _S398 : bool = side_2 == u32(1);
        var _S399 : vec3<f32> = hit_normal_0(&(_S393));
        var _S400 : vec3<f32> = select_vector_0(_S398, _S396.normal_0, _S399);
        var _S401 : f32 = select(_S393.place_z_0, _S396.height_2, _S398);
        var _S402 : bool;
        if(!((_S398 & ((_S396.hole_1)))))
        {
            _S402 = (dot(_S400, _S397)) > 0.0f;
        }
        else
        {
            _S402 = false;
        }
        var _S403 : bool;
        if(_S402)
        {
            _S403 = unoccluded_0(_S388, bake_quality_0(), _S394, _S395, _S401, _S397, _S389 != _S398);
        }
        else
        {
            _S403 = false;
        }
        if(_S403)
        {
            lit_1 = (lit_1 | (((u32(1) << (side_2)))));
        }
        side_2 = side_2 + u32(1);
    }
    scratch_0[bakes_0[i32(0)].lit_0 + _S385] = lit_1;
    return;
}

fn nearest_group_0( _S404 : i32,  _S405 : bool,  _S406 : bool,  _S407 : vec3<f32>,  _S408 : vec3<f32>,  _S409 : f32) -> u32
{
    var _S410 : u32 = select(u32(0), u32(1), _S405);
    var _S411 : u32 = select(scratch_0[bakes_0[_S404].facts_0 + u32(14) + _S410], u32(0), _S406);
    var _S412 : u32 = bakes_0[_S404].per_family_0;
    var _S413 : u32 = select(u32(2) * bakes_0[_S404].per_family_0, scratch_0[bakes_0[_S404].facts_0 + u32(14) + _S410], _S406);
    var least_0 : f32 = 1000.0f;
    var nearest_0 : u32 = _S411;
    var group_0 : u32 = _S411;
    for(;;)
    {
        if(group_0 < _S413)
        {
        }
        else
        {
            break;
        }
        var _S414 : u32 = bakes_0[_S404].centroids_0 + (_S410 * u32(2) * _S412 + group_0) * u32(7);
        var _S415 : vec3<f32> = vec3<f32>(0.5f) * _S407 - vec3<f32>(scratch_number_0(_S414), scratch_number_0(_S414 + u32(1)), scratch_number_0(_S414 + u32(2)));
        var _S416 : vec3<f32> = _S408 - vec3<f32>(scratch_number_0(_S414 + u32(3)), scratch_number_0(_S414 + u32(4)), scratch_number_0(_S414 + u32(5)));
        var _S417 : f32 = dot(_S415, _S415) + dot(_S416, _S416) + square_0(2.0f * _S409 - scratch_number_0(_S414 + u32(6)));
        var _S418 : u32 = select(nearest_0, group_0, _S417 < least_0);
        var _S419 : f32 = min(least_0, _S417);
        var _S420 : u32 = group_0 + u32(1);
        least_0 = _S419;
        nearest_0 = _S418;
        group_0 = _S420;
    }
    return nearest_0;
}

fn byte_of_group_0( _S421 : i32,  _S422 : u32) -> u32
{
    return select(_S422 - bakes_0[_S421].per_family_0 + u32(2) * bakes_0[_S421].packs_0, _S422, _S422 < (bakes_0[_S421].per_family_0));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_texels(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    var _S423 : u32 = thread_index_0(id_6);
    var _S424 : u32 = bakes_0[i32(0)].columns_0;
    var _S425 : u32 = bakes_0[i32(0)].texels_across_0;
    var _S426 : u32 = bakes_0[i32(0)].columns_0 * bakes_0[i32(0)].texels_across_0;
    var _S427 : u32 = bakes_0[i32(0)].rows_0;
    var _S428 : u32 = bakes_0[i32(0)].texels_along_0;
    var _S429 : u32 = _S426 * bakes_0[i32(0)].rows_0 * bakes_0[i32(0)].texels_along_0;
    if(_S423 >= (u32(2) * _S429))
    {
        return;
    }
    var _S430 : u32 = bakes_0[i32(0)].fabric_0;
    var _S431 : bool = _S423 >= _S429;
    var _S432 : u32 = select(_S423, _S423 - _S429, _S431);
    var _S433 : u32 = _S432 / _S426;
    var _S434 : u32 = _S432 % _S426;
    var _S435 : SurfacePoint_0 = surface_at_0(_S430, (f32(_S434) + fraction_of_0(_S432 * u32(3242174889))) * bakes_0[i32(0)].texel_x_0, (f32(_S433) + fraction_of_0(_S432 * u32(2447445413))) * bakes_0[i32(0)].texel_y_0, _S431);
    var _S436 : u32 = bakes_0[i32(0)].packs_0;
    var _S437 : u32 = select(byte_of_group_0(i32(0), nearest_group_0(i32(0), _S431, _S435.is_warp_1, _S435.normal_0, _S435.tangent_0, _S435.shown_share_1)), u32(4) * bakes_0[i32(0)].packs_0, _S435.hole_1);
    var _S438 : u32 = _S433 / _S428;
    var _S439 : u32 = _S438 * _S424;
    var _S440 : u32 = _S434 / _S425;
    var _S441 : u32 = atomicAdd(&(texel_counters_0[(_S439 + _S440 + select(u32(0), _S424 * _S427, _S431)) * (_S436 + u32(1)) + _S437 / u32(4)]), (u32(1) << ((u32(8) * (_S437 % u32(4))))));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_cover_hidden(@builtin(global_invocation_id) id_7 : vec3<u32>)
{
    var _S442 : u32 = thread_index_0(id_7);
    var _S443 : u32 = bakes_0[i32(0)].columns_0;
    var _S444 : u32 = bakes_0[i32(0)].rows_0;
    if(_S442 >= (bakes_0[i32(0)].columns_0 * bakes_0[i32(0)].rows_0))
    {
        return;
    }
    var _S445 : u32 = steps_0[i32(0)];
    var _S446 : u32 = bakes_0[i32(0)].packs_0;
    var _S447 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S448 : u32 = (_S445 * _S443 * _S444 + _S442) * _S447;
    var byte_0 : u32 = u32(0);
    for(;;)
    {
        if(byte_0 < (u32(4) * _S446))
        {
        }
        else
        {
            break;
        }
        var _S449 : u32 = scratch_0[bakes_0[i32(0)].stand_ins_0 + _S445 * u32(4) * _S447 + byte_0];
        if(scratch_0[bakes_0[i32(0)].stand_ins_0 + _S445 * u32(4) * _S447 + byte_0] != byte_0)
        {
            var _S450 : u32 = atomicLoad(&(texel_counters_0[_S448 + _S449 / u32(4)]));
            var _S451 : u32 = (((_S450 >> ((u32(8) * (_S449 % u32(4)))))) & (u32(255)));
            var _S452 : u32 = atomicLoad(&(texel_counters_0[_S448 + byte_0 / u32(4)]));
            var _S453 : u32 = u32(8) * (byte_0 % u32(4));
            atomicStore(&(texel_counters_0[_S448 + byte_0 / u32(4)]), (((_S452 & ((~((u32(255) << (_S453))))))) | (((_S451 << (_S453))))));
        }
        byte_0 = byte_0 + u32(1);
    }
    return;
}

