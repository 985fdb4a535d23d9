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

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

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

@id(0) override HAS_LAYERS_0 : bool = true;

struct Lobes_0
{
     is_baked_0 : u32,
     inverse_base_size_0 : f32,
     last_level_0 : f32,
     levels_0 : u32,
     face_nodes_0 : u32,
     packs_0 : u32,
     front_warp_packs_0 : u32,
     back_warp_packs_0 : u32,
     coverage_0 : u32,
     coverage_holes_0 : u32,
     projected_area_0 : u32,
     light_visibility_0 : u32,
     irradiance_0 : u32,
     moments_0 : u32,
     joint_0 : u32,
     front_hole_weight_0 : f32,
     back_hole_weight_0 : f32,
     threads_per_mm_0 : f32,
     unit_level_0 : f32,
};

struct Neural_0
{
     is_encoded_0 : u32,
     network_0 : u32,
     latents_0 : u32,
     texels_0 : u32,
     levels_1 : u32,
     top_level_0 : u32,
     ends_0 : f32,
     picks_0 : f32,
     ends_per_mm_0 : f32,
     picks_per_mm_0 : f32,
     pitch_0 : f32,
     warp_x_0 : f32,
     warp_y_0 : f32,
     warp_roughness_0 : f32,
     weft_x_0 : f32,
     weft_y_0 : f32,
     weft_roughness_0 : f32,
     warp_lobe_roughness_0 : f32,
     weft_lobe_roughness_0 : f32,
     bundles_0 : u32,
     is_corrected_0 : u32,
     correction_0 : u32,
};

struct Neumip_0
{
     is_trained_0 : u32,
     decoder_0 : u32,
     has_offset_0 : u32,
     offset_0 : u32,
     offset_texels_0 : u32,
     features_0 : u32,
     texel_elements_0 : u32,
     levels_2 : u32,
     last_level_1 : f32,
     face_texels_0 : u32,
     back_0 : u32,
     repeats_per_x_0 : f32,
     repeats_per_y_0 : f32,
     texels_per_mm_0 : f32,
     unit_x_0 : f32,
     unit_y_0 : f32,
     transmits_0 : u32,
     transmission_0 : u32,
     has_holes_0 : u32,
     opacity_0 : u32,
};

struct Latent_0
{
     is_trained_1 : u32,
     decoder_1 : u32,
     hidden_0 : u32,
     frames_0 : u32,
     sampler_0 : u32,
     albedo_0 : u32,
     auxiliary_0 : u32,
     texels_1 : u32,
     texel_elements_1 : u32,
     levels_3 : u32,
     last_level_2 : f32,
     face_texels_1 : u32,
     back_1 : u32,
     repeats_per_x_1 : f32,
     repeats_per_y_1 : f32,
     texels_per_mm_1 : f32,
     width_0 : f32,
     height_0 : f32,
     is_trilinear_0 : u32,
     is_apart_0 : u32,
};

struct Clustered_0
{
     is_baked_1 : u32,
     clusters_0 : u32,
     rank_0 : u32,
     channels_0 : u32,
     columns_0 : u32,
     rows_0 : u32,
     texel_width_0 : f32,
     texel_height_0 : f32,
     samples_0 : u32,
     sums_0 : u32,
     labels_0 : u32,
     coefficients_0 : u32,
     basis_0 : u32,
     moments_1 : u32,
     texels_2 : u32,
     light_0 : u32,
     heights_0 : u32,
};

struct Fabric_0
{
     warp_0 : u32,
     weft_0 : u32,
     lobes_0 : Lobes_0,
     neural_0 : Neural_0,
     neumip_0 : Neumip_0,
     run_words_0 : u32,
     ends_1 : u32,
     max_heights_0 : u32,
     max_height_columns_0 : u32,
     height_low_0 : f32,
     height_high_0 : f32,
     lift_0 : f32,
     threads_per_x_0 : f32,
     threads_per_y_0 : f32,
     per_relief_0 : f32,
     diffuse_blend_0 : f32,
     optical_depth_0 : f32,
     grazing_gain_0 : f32,
     grazing_loss_0 : f32,
     sheen_strength_0 : f32,
     sheen_roughness_0 : f32,
     fibre_noise_0 : f32,
     colour_noise_0 : f32,
     seed_0 : u32,
     layer_bound_0 : f32,
     fibre_size_0 : f32,
     is_irregular_0 : u32,
     warp_on_top_0 : f32,
     has_detail_0 : u32,
     uv_width_0 : f32,
     uv_height_0 : f32,
     is_open_0 : u32,
     openness_0 : u32,
     albedo_map_0 : u32,
     albedo_map_levels_0 : u32,
     has_yarns_0 : u32,
     mean_hole_0 : f32,
     latent_0 : Latent_0,
     clustered_0 : Clustered_0,
     planes_0 : u32,
     plane_records_0 : u32,
     plane_axes_0 : u32,
     stacks_0 : u32,
     plane_orders_0 : u32,
     regions_0 : u32,
     plane_shares_0 : u32,
     is_coloured_0 : u32,
};

fn is_layered_0( fabric_0 : Fabric_0) -> bool
{
    return (HAS_LAYERS_0 & (((fabric_0.planes_0) != u32(0))));
}

struct Plane_0
{
     warp_1 : u32,
     weft_1 : u32,
     run_words_1 : u32,
     ends_2 : u32,
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

fn whole_plane_0( fabric_1 : Fabric_0) -> Plane_0
{
    var plane_0 : Plane_0;
    plane_0.warp_1 = fabric_1.warp_0;
    plane_0.weft_1 = fabric_1.weft_0;
    plane_0.run_words_1 = fabric_1.run_words_0;
    plane_0.ends_2 = fabric_1.ends_1;
    plane_0.end_numbers_0 = u32(0);
    plane_0.pick_numbers_0 = u32(0);
    plane_0.max_heights_1 = fabric_1.max_heights_0;
    plane_0.max_height_columns_1 = fabric_1.max_height_columns_0;
    plane_0.height_low_1 = fabric_1.height_low_0;
    plane_0.height_high_1 = fabric_1.height_high_0;
    plane_0.front_level_0 = 0.0f;
    plane_0.back_level_0 = 0.0f;
    plane_0.start_x_0 = 0.0f;
    plane_0.start_y_0 = 0.0f;
    plane_0.fine_x_0 = 0.0f;
    plane_0.fine_y_0 = 0.0f;
    return plane_0;
}

fn plane_at_0( first_0 : u32) -> Plane_0
{
    var record_0 : Plane_0;
    record_0.warp_1 = words_0[first_0];
    record_0.weft_1 = words_0[first_0 + u32(1)];
    record_0.run_words_1 = words_0[first_0 + u32(2)];
    record_0.ends_2 = words_0[first_0 + u32(3)];
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

fn plane_of_0( fabric_2 : Fabric_0,  number_0 : u32) -> Plane_0
{
    if(!is_layered_0(fabric_2))
    {
        return whole_plane_0(fabric_2);
    }
    return plane_at_0(fabric_2.plane_records_0 + number_0 * u32(16));
}

fn ray_number_0( ray_0 : u32,  number_1 : u32) -> f32
{
    return (bitcast<f32>((steps_0[u32(2) + ray_0 * u32(5) + number_1])));
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

fn plane_order_0( fabric_3 : Fabric_0,  x_1 : f32,  y_0 : f32,  back_2 : bool) -> u32
{
    var _S4 : u32 = select(u32(0), locate_varied_0(fabric_3.plane_axes_0 + u32(1), y_0).thread_0 * fabric_3.ends_1 + locate_varied_0(fabric_3.plane_axes_0, x_1).thread_0, (fabric_3.stacks_0) > u32(1));
    return fabric_3.plane_orders_0 + u32(2) * fabric_3.planes_0 * (u32(2) * ((((words_0[fabric_3.regions_0 + _S4 / u32(4)] >> ((u32(8) * (_S4 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), back_2));
}

fn turns_and_remainder_0( family_1 : u32,  index_1 : f32) -> vec2<f32>
{
    var _S5 : f32 = floor(fma(index_1, families_0[family_1].inverse_count_0, families_0[family_1].half_inverse_count_0));
    return vec2<f32>(_S5, fma(- _S5, families_0[family_1].count_0, index_1));
}

fn locate_alike_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var _S6 : f32 = floor(position_1 * families_0[family_2].inverse_size_0);
    var cell_1 : Cell_0;
    var _S7 : f32 = fma(- _S6, families_0[family_2].size_0, position_1);
    cell_1.below_0 = _S7;
    cell_1.above_0 = families_0[family_2].size_0 - _S7;
    cell_1.across_0 = _S7 - 0.5f * families_0[family_2].size_0;
    cell_1.half_width_1 = families_0[family_2].half_width_0;
    cell_1.thread_0 = u32(clamp(turns_and_remainder_0(family_2, _S6).y, 0.0f, families_0[family_2].count_0 - 1.0f));
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

fn crossing_at_0( plane_1 : Plane_0,  x_2 : f32,  y_1 : f32,  back_3 : bool) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.warp_2 = locate_0(plane_1.warp_1, x_2 - plane_1.start_x_0);
    crossing_0.weft_2 = locate_0(plane_1.weft_1, y_1 - plane_1.start_y_0);
    var _S8 : u32 = plane_1.run_words_1 + u32(2) * (crossing_0.weft_2.thread_0 * plane_1.ends_2 + crossing_0.warp_2.thread_0);
    var _S9 : u32 = words_0[_S8];
    crossing_0.warp_word_0 = _S9;
    crossing_0.weft_word_0 = words_0[_S8 + u32(1)];
    crossing_0.warp_above_0 = (((_S9 & (u32(1)))) == u32(1)) != back_3;
    return crossing_0;
}

fn cell_maximum_0( plane_2 : Plane_0,  crossing_1 : Crossing_0) -> f32
{
    var _S10 : u32 = select(plane_2.weft_1, plane_2.warp_1, crossing_1.warp_above_0);
    return f32((select(crossing_1.weft_word_0, crossing_1.warp_word_0, crossing_1.warp_above_0) >> (u32(28)))) * families_0[_S10].height_scale_0 * families_0[_S10].level_0;
}

fn bounds_in_0( plane_3 : Plane_0,  x_3 : f32,  y_2 : f32,  back_4 : bool,  right_0 : bool,  up_0 : bool) -> vec3<f32>
{
    var _S11 : Crossing_0 = crossing_at_0(plane_3, x_3, y_2, back_4);
    return vec3<f32>(cell_maximum_0(plane_3, _S11), select(_S11.warp_2.below_0, _S11.warp_2.above_0, right_0), select(_S11.weft_2.below_0, _S11.weft_2.above_0, up_0));
}

fn first_bounds_0( fabric_4 : Fabric_0,  order_0 : u32,  x_4 : f32,  y_3 : f32,  back_5 : bool,  right_1 : bool,  up_1 : bool) -> vec3<f32>
{
    var _S12 : vec3<f32> = bounds_in_0(plane_at_0(fabric_4.plane_records_0 + words_0[order_0] * u32(16)), x_4, y_3, back_5, right_1, up_1);
    var _S13 : Cell_0 = locate_varied_0(fabric_4.plane_axes_0, x_4);
    var _S14 : Cell_0 = locate_varied_0(fabric_4.plane_axes_0 + u32(1), y_3);
    var _S15 : bool = (fabric_4.stacks_0) == u32(1);
    return vec3<f32>(_S12.x + table_number_0(order_0 + u32(1)), min(_S12.y, select(select(_S13.below_0, _S13.above_0, right_1), 1.0e+06f, _S15)), min(_S12.z, select(select(_S14.below_0, _S14.above_0, up_1), 1.0e+06f, _S15)));
}

fn hole_edge_0( cell_2 : Cell_0,  forwards_0 : bool) -> f32
{
    var _S16 : f32 = select(- cell_2.across_0, cell_2.across_0, forwards_0);
    var _S17 : f32 = - cell_2.half_width_1;
    return select(select(cell_2.half_width_1, _S17, _S16 < _S17) - _S16, 2.0f * select(cell_2.below_0, cell_2.above_0, forwards_0) + _S16 - cell_2.half_width_1, _S16 >= (cell_2.half_width_1));
}

struct PlaneHere_0
{
     plane_4 : Plane_0,
     number_2 : u32,
     level_1 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
     bounds_0 : vec3<f32>,
};

fn plane_shown_0( fabric_5 : Fabric_0,  x_5 : f32,  y_4 : f32,  back_6 : bool,  right_2 : bool,  up_2 : bool) -> PlaneHere_0
{
    var here_0 : PlaneHere_0;
    here_0.plane_4 = whole_plane_0(fabric_5);
    here_0.number_2 = u32(0);
    here_0.level_1 = 0.0f;
    here_0.edge_x_0 = 1.0e+06f;
    here_0.edge_y_0 = 1.0e+06f;
    here_0.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(fabric_5))
    {
        return here_0;
    }
    var _S18 : u32 = plane_order_0(fabric_5, x_5, y_4, back_6);
    var _S19 : vec3<f32> = first_bounds_0(fabric_5, _S18, x_5, y_4, back_6, right_2, up_2);
    here_0.bounds_0 = _S19;
    var _S20 : bool = (fabric_5.stacks_0) == u32(1);
    here_0.edge_x_0 = select(_S19.y, 1.0e+06f, _S20);
    here_0.edge_y_0 = select(_S19.z, 1.0e+06f, _S20);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabric_5.planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S21 : u32 = _S18 + u32(2) * rank_1;
        var _S22 : u32 = words_0[_S21];
        here_0.number_2 = _S22;
        here_0.level_1 = table_number_0(_S21 + u32(1));
        here_0.plane_4 = plane_at_0(fabric_5.plane_records_0 + _S22 * u32(16));
        var _S23 : Cell_0 = locate_varied_0(here_0.plane_4.warp_1, x_5 - here_0.plane_4.start_x_0);
        var _S24 : Cell_0 = locate_varied_0(here_0.plane_4.weft_1, y_4 - here_0.plane_4.start_y_0);
        var is_hole_1 : bool = !((((abs(_S23.across_0)) < (_S23.half_width_1)) | (((abs(_S24.across_0)) < (_S24.half_width_1)))));
        here_0.edge_x_0 = min(here_0.edge_x_0, select(1.0e+06f, hole_edge_0(_S23, right_2), is_hole_1));
        here_0.edge_y_0 = min(here_0.edge_y_0, select(1.0e+06f, hole_edge_0(_S24, up_2), is_hole_1));
        var _S25 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S25;
    }
    return here_0;
}

struct Shown_0
{
     is_warp_0 : bool,
     hole_0 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

fn shown_at_0( crossing_2 : Crossing_0,  back_7 : bool) -> Shown_0
{
    var _S26 : bool = (abs(crossing_2.warp_2.across_0)) < (crossing_2.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S27 : bool = !((abs(crossing_2.weft_2.across_0)) < (crossing_2.weft_2.half_width_1));
    var _S28 : bool = (_S26 & (((_S27 | ((crossing_2.warp_above_0))))));
    shown_0.is_warp_0 = _S28;
    shown_0.hole_0 = ((!_S26) & (_S27));
    var _S29 : u32 = select(crossing_2.weft_word_0, crossing_2.warp_word_0, _S28);
    shown_0.word_0 = _S29;
    shown_0.on_top_0 = (((_S29 & (u32(1)))) == u32(1)) != back_7;
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
    var _S30 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S30.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S30.y) * u32(4)));
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
    var _S31 : u32 = families_0[family_6].bend_table_0 + select(thread_4 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S31);
    bend_0.half_tangent_0 = table_number_0(_S31 + u32(1));
    bend_0.arc_0 = table_number_0(_S31 + u32(2));
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
    var _S32 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S33 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S34 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S35 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S36 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S36;
    var _S37 : i32 = - _S32;
    var _S38 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S37, i32(0));
    run_0.from_start_0 = _S38;
    var _S39 : i32 = _S33 + i32(1);
    var _S40 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S39);
    run_0.to_end_0 = _S40;
    var _S41 : bool = _S38 < _S40;
    run_0.near_start_0 = _S41;
    var _S42 : i32 = select(_S39, _S37 - _S34, _S41);
    var _S43 : i32 = select(_S39 + _S35, _S37, _S41);
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    run_0.distance_0 = select(min(_S38, _S40), 1.0e+06f, _S36);
    run_0.reach_0 = min(0.5f * (_S38 + _S40), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S42, _S43), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S32 == i32(0);
    run_0.last_crossing_0 = _S33 == i32(0);
    return run_0;
}

fn square_0( x_6 : f32) -> f32
{
    return x_6 * x_6;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_4 : Cell_0) -> Section_0
{
    var _S44 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S45 : f32 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S45;
    var _S46 : f32 = _S44 * _S44 - square_0(_S45);
    var _S47 : f32 = rsqrt_0(_S46);
    section_0.drop_0 = _S44 - _S46 * _S47;
    section_0.slope_0 = - _S45 * _S47;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_6 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_6) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S48 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S49 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S50 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S48) - crossed_1.half_width_1;
    var _S51 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S48);
    var _S52 : f32;
    if(shown_1.on_top_0)
    {
        _S52 = 0.0f;
    }
    else
    {
        _S52 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S53 : f32;
    if((shown_1.on_top_0) != _S51)
    {
        _S53 = 0.0f;
    }
    else
    {
        _S53 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, select(i32(1), i32(-1), _S48));
    }
    var _S54 : f32 = 2.0f * _S50;
    var _S55 : f32 = 1.0f / max(_S54, 9.999999960041972e-13f);
    var _S56 : f32 = clamp((_S50 - _S49) * _S55, 0.0f, 1.0f);
    var _S57 : f32 = clamp((0.44999998807907104f - _S54 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S52 + (_S53 - _S52) * (_S56 * _S56 * (3.0f - 2.0f * _S56)), (_S52 - _S53) * (6.0f * _S56 * (1.0f - _S56) * _S55) * select(-1.0f, 1.0f, _S48), _S57 * _S57 * (3.0f - 2.0f * _S57));
}

struct Sample_0
{
     here_1 : PlaneHere_0,
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

fn sample_in_0( here_2 : PlaneHere_0,  x_7 : f32,  y_5 : f32,  back_8 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    sample_0.here_1 = here_2;
    var _S58 : Crossing_0 = crossing_at_0(here_2.plane_4, x_7, y_5, back_8);
    sample_0.crossing_3 = _S58;
    var _S59 : Shown_0 = shown_at_0(_S58, back_8);
    sample_0.shown_2 = _S59;
    var _S60 : u32 = select(here_2.plane_4.weft_1, here_2.plane_4.warp_1, _S59.is_warp_0);
    var _S61 : u32 = select(here_2.plane_4.warp_1, here_2.plane_4.weft_1, _S59.is_warp_0);
    var _S62 : Cell_0 = select_cell_0(_S59.is_warp_0, sample_0.crossing_3.warp_2, sample_0.crossing_3.weft_2);
    var _S63 : Cell_0 = select_cell_0(_S59.is_warp_0, sample_0.crossing_3.weft_2, sample_0.crossing_3.warp_2);
    var _S64 : Run_0 = unpack_0(_S60, _S61, _S62.thread_0, _S63, _S59.word_0);
    var _S65 : Section_0 = section_at_0(_S62);
    var _S66 : bool = ((_S59.on_top_0) & (((_S64.distance_0) < (_S65.drop_0 * _S64.bend_1.sine_0))));
    var _S67 : f32 = select(-1.0f, 1.0f, ((_S59.on_top_0) & ((!_S66))));
    var _S68 : f32 = select(_S64.reach_0, _S64.other_reach_0, _S66);
    var _S69 : f32 = select(max(_S68 - _S64.distance_0, 0.0f), _S68 + _S64.distance_0, _S66);
    var _S70 : f32 = _S68 / _S64.bend_1.sine_0 - _S67 * _S65.drop_0;
    var _S71 : f32 = _S69 * _S69;
    var _S72 : f32 = max(_S70 * _S70 - _S71, 9.99999968265522539e-21f);
    var _S73 : f32 = rsqrt_0(_S72);
    var _S74 : f32 = _S71 / (_S72 * _S73 + _S70);
    var _S75 : bool = _S69 > 0.0f;
    var _S76 : f32 = select(-1.0f, 1.0f, _S59.on_top_0) * select(-1.0f, 1.0f, _S64.near_start_0);
    var _S77 : f32 = _S65.slope_0 * select(1.0f, _S70 * _S73, _S75);
    sample_0.slope_across_0 = _S77;
    var _S78 : f32 = select(0.0f, _S76 * _S69 * _S73, _S75);
    sample_0.slope_along_0 = _S78;
    var _S79 : vec3<f32> = dive_0(_S61, _S59, _S64, _S63);
    sample_0.dive_1 = _S79;
    sample_0.height_1 = select(families_0[_S60].height_scale_0 * _S67, 0.0f, _S64.straight_0) * (_S68 * _S64.bend_1.half_tangent_0 - _S74) - families_0[_S60].height_scale_0 * _S65.drop_0 - _S79.x + here_2.level_1;
    var _S80 : f32 = families_0[_S60].height_scale_0 * _S77;
    var _S81 : f32 = families_0[_S60].height_scale_0 * _S78 - _S79.y;
    sample_0.slope_x_0 = select(_S81, _S80, _S59.is_warp_0);
    sample_0.slope_y_0 = select(_S80, _S81, _S59.is_warp_0);
    sample_0.run_2 = _S64;
    sample_0.section_1 = _S65;
    return sample_0;
}

fn sample_at_0( fabric_6 : Fabric_0,  x_8 : f32,  y_6 : f32,  back_9 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(fabric_6, x_8, y_6, back_9, true, true), x_8, y_6, back_9);
}

fn steps_per_length_0( fabric_7 : Fabric_0,  quality_1 : SearchQuality_0,  direction_0 : vec3<f32>) -> f32
{
    return max(max(abs(direction_0.x) * fabric_7.threads_per_x_0, abs(direction_0.y) * fabric_7.threads_per_y_0) * quality_1.steps_per_thread_0, abs(direction_0.z) * fabric_7.per_relief_0 * quality_1.steps_per_relief_0);
}

struct StepControl_0
{
     step_2 : f32,
     epsilon_0 : f32,
     per_x_0 : f32,
     per_y_0 : f32,
     right_3 : bool,
     up_3 : bool,
};

fn step_control_0( direction_1 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S82 : f32 = direction_1.x;
    control_0.per_x_0 = 1.0f / max(abs(_S82), 9.99999971718068537e-10f);
    var _S83 : f32 = direction_1.y;
    control_0.per_y_0 = 1.0f / max(abs(_S83), 9.99999971718068537e-10f);
    control_0.right_3 = _S82 > 0.0f;
    control_0.up_3 = _S83 > 0.0f;
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

fn plane_count_0( fabric_8 : Fabric_0) -> u32
{
    return select(u32(1), fabric_8.planes_0, is_layered_0(fabric_8));
}

fn outline_distance_0( cell_5 : Cell_0,  shown_3 : Shown_0,  run_3 : Run_0,  lengthwise_0 : bool,  forwards_1 : bool) -> f32
{
    var _S84 : f32 = select(- cell_5.across_0, cell_5.across_0, forwards_1);
    var _S85 : f32 = select(cell_5.below_0, cell_5.above_0, forwards_1);
    var _S86 : f32 = - cell_5.half_width_1;
    var _S87 : bool = _S84 < _S86;
    var _S88 : bool = _S84 >= (cell_5.half_width_1);
    var _S89 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_1))))) & ((!shown_3.hole_0)));
    var _S90 : f32 = select(cell_5.half_width_1, _S86, _S87) - _S84;
    var _S91 : f32 = select(_S85, 2.0f * _S85 + _S84 - cell_5.half_width_1, ((shown_3.hole_0) | (((_S89 & ((!shown_3.on_top_0)))))));
    if((((_S89 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_1) & (_S87)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_1);
    }
    return select(_S90, _S91, _S88);
}

struct Probe_0
{
     height_2 : f32,
     hole_1 : bool,
     slope_x_1 : f32,
     slope_y_1 : f32,
     yarn_1 : u32,
     cell_max_0 : f32,
     side_x_0 : f32,
     side_y_0 : f32,
     edge_x_1 : f32,
     edge_y_1 : f32,
};

fn probe_0( fabric_9 : Fabric_0,  x_9 : f32,  y_7 : f32,  back_10 : bool,  right_4 : bool,  up_4 : bool) -> Probe_0
{
    var _S92 : PlaneHere_0 = plane_shown_0(fabric_9, x_9, y_7, back_10, right_4, up_4);
    var _S93 : Sample_0 = sample_in_0(_S92, x_9, y_7, back_10);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S93.height_1;
    probe_1.hole_1 = _S93.shown_2.hole_0;
    probe_1.slope_x_1 = _S93.slope_x_0;
    probe_1.slope_y_1 = _S93.slope_y_0;
    var _S94 : bool = !is_layered_0(fabric_9);
    probe_1.yarn_1 = select(_S93.crossing_3.weft_2.thread_0 * u32(2), _S93.crossing_3.warp_2.thread_0 * u32(2) + u32(1), _S93.shown_2.is_warp_0) * plane_count_0(fabric_9) + _S92.number_2;
    probe_1.cell_max_0 = select(_S92.bounds_0.x, cell_maximum_0(_S92.plane_4, _S93.crossing_3), _S94);
    probe_1.side_x_0 = select(_S92.bounds_0.y, select(_S93.crossing_3.warp_2.below_0, _S93.crossing_3.warp_2.above_0, right_4), _S94);
    probe_1.side_y_0 = select(_S92.bounds_0.z, select(_S93.crossing_3.weft_2.below_0, _S93.crossing_3.weft_2.above_0, up_4), _S94);
    probe_1.edge_x_1 = min(_S92.edge_x_0, outline_distance_0(_S93.crossing_3.warp_2, _S93.shown_2, _S93.run_2, !_S93.shown_2.is_warp_0, right_4));
    probe_1.edge_y_1 = min(_S92.edge_y_0, outline_distance_0(_S93.crossing_3.weft_2, _S93.shown_2, _S93.run_2, _S93.shown_2.is_warp_0, up_4));
    return probe_1;
}

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_3 : Probe_0) -> f32
{
    var _S95 : f32 = previous_1.rate_0 * step_4;
    var _S96 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_3.hole_1)))) | (((previous_1.yarn_0) != (here_3.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S95) >= 0.0f) & (((3.0f * clearance_1 - _S96) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S97 : f32 = clearance_1 - previous_1.clearance_0;
    var _S98 : f32 = 6.0f * _S97 - 4.0f * _S95 - 2.0f * _S96;
    var _S99 : f32 = -2.0f * _S95 / max(_S98 + sqrt(max(_S98 * _S98 - 4.0f * (3.0f * (_S95 + _S96 - 2.0f * _S97)) * _S95, 0.0f)), 9.99999968265522539e-21f);
    var _S100 : f32 = 1.0f - _S99;
    return select(-1.0f, _S100 * step_4, ((((_S99 > 0.01999999955296516f) & ((_S100 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S99 + 1.0f) + _S95 * _S99) * _S100 * _S100 + (clearance_1 * (2.0f * _S100 + 1.0f) - _S96 * _S100) * _S99 * _S99) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_4 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_4.hole_1);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_4.yarn_1;
    previous_2.known_0 = ((!here_4.hole_1) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_0 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

fn StepControl_to_next_sample_0( this_1 : StepControl_0,  here_5 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S101 : f32 = min(here_5.edge_x_1 * this_1.per_x_0, here_5.edge_y_1 * this_1.per_y_0);
    return min(this_1.step_2, select(max(_S101, 0.0f) + this_1.epsilon_0, _S101 - this_1.epsilon_0, ((((!here_5.hole_1) & (((rate_3 * _S101 + clearance_3) < 0.0f)))) & ((_S101 > (2.0f * this_1.epsilon_0))))));
}

fn is_free_0( fabric_10 : Fabric_0,  quality_2 : SearchQuality_0,  start_1 : vec3<f32>,  direction_2 : vec3<f32>,  back_11 : bool,  max_height_0 : f32) -> bool
{
    var _S102 : f32 = direction_2.z;
    if(_S102 <= 0.0f)
    {
        return false;
    }
    var _S103 : f32 = 1.0f / max(quality_2.shadow_share_0 * steps_per_length_0(fabric_10, quality_2, direction_2), 9.99999971718068537e-10f);
    var _S104 : StepControl_0 = step_control_0(direction_2.xy, _S103);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_1 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_1 < u32(1024)) & (((start_1.z + _S102 * distance_1) < max_height_0))))
        {
        }
        else
        {
            break;
        }
        var _S105 : vec3<f32> = start_1 + direction_2 * vec3<f32>(distance_1);
        var _S106 : Probe_0 = probe_0(fabric_10, _S105.x, _S105.y, back_11, _S104.right_3, _S104.up_3);
        var _S107 : f32 = _S105.z;
        var _S108 : f32 = _S107 - _S106.height_2;
        var _S109 : f32 = _S102 - _S106.slope_x_1 * direction_2.x - _S106.slope_y_1 * direction_2.y;
        if(((!_S106.hole_1) & ((_S108 < 0.0f))))
        {
            return false;
        }
        var _S110 : f32 = way_back_to_dip_0(previous_3, _S108, _S109, last_step_0, _S106);
        if(_S110 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S110;
            distance_1 = distance_1 - _S110;
            last_step_0 = last_step_1;
            count_1 = count_1 + u32(1);
            continue;
        }
        var _S111 : bool = _S107 > (_S106.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S104, _S106, _S108, _S109), max(StepControl_to_cell_exit_0(_S104, _S106.side_x_0, _S106.side_y_0), _S103), _S111);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S108, _S109, _S106, _S111);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + u32(1);
    }
    return true;
}

fn passes_through_0( fabric_11 : Fabric_0,  quality_3 : SearchQuality_0,  x_10 : f32,  y_8 : f32,  view_0 : vec3<f32>,  back_12 : bool) -> bool
{
    if(!sample_at_0(fabric_11, x_10, y_8, back_12).shown_2.hole_0)
    {
        return false;
    }
    var _S112 : vec3<f32> = vec3<f32>(x_10, y_8, 0.0f);
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
        var _S113 : bool = is_free_0(fabric_11, quality_3, _S112, select_vector_1(side_0 == u32(0), view_0, vec3<f32>(- view_0.x, - view_0.y, view_0.z)), back_12 != (side_0 == u32(1)), fabric_11.height_high_0);
        var _S114 : u32 = side_0 + u32(1);
        passes_0 = _S113;
        side_0 = _S114;
    }
    return passes_0;
}

fn max_height_along_0( fabric_12 : Fabric_0,  x_11 : f32,  y_9 : f32,  height_3 : f32,  direction_3 : vec3<f32>,  back_13 : bool) -> f32
{
    var _S115 : f32 = direction_3.x;
    var _S116 : f32 = direction_3.y;
    var _S117 : u32 = select(u32(0), u32(1), _S115 > 0.0f) + select(u32(0), u32(2), _S116 > 0.0f);
    var _S118 : f32 = max(abs(_S115) * fabric_12.threads_per_x_0, abs(_S116) * fabric_12.threads_per_y_0) / direction_3.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_3 : u32 = u32(0);
    for(;;)
    {
        if(number_3 < (plane_count_0(fabric_12)))
        {
        }
        else
        {
            break;
        }
        var _S119 : Plane_0 = plane_of_0(fabric_12, number_3);
        var _S120 : u32 = (words_0[_S119.max_heights_1 + u32(4) * (locate_0(_S119.weft_1, y_9 - _S119.start_y_0).thread_0 / u32(2) * _S119.max_height_columns_1 + locate_0(_S119.warp_1, x_11 - _S119.start_x_0).thread_0 / u32(2)) + _S117] >> (u32(select(i32(0), i32(4), back_13))));
        var _S121 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S120 & (u32(15)))), f32((((_S120 >> (u32(8)))) & (u32(15)))), f32((((_S120 >> (u32(16)))) & (u32(15)))), f32((((_S120 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S119.height_high_1) + vec4<f32>(select(_S119.front_level_0, _S119.back_level_0, back_13)));
        var _S122 : u32 = number_3 + u32(1);
        levels_4 = _S121;
        number_3 = _S122;
    }
    var max_height_1 : f32 = fabric_12.height_high_0;
    var number_4 : i32 = i32(3);
    for(;;)
    {
        if(number_4 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_1 - height_3) * _S118) <= (PYRAMID_RADII_0[number_4]))
        {
            max_height_1 = min(max_height_1, levels_4[number_4]);
        }
        number_4 = number_4 - i32(1);
    }
    return max_height_1;
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_2 : ViewRay_0,  height_4 : f32) -> vec2<f32>
{
    return this_2.origin_0 + this_2.slope_1 * vec2<f32>(height_4);
}

fn cell_bounds_0( fabric_13 : Fabric_0,  x_12 : f32,  y_10 : f32,  back_14 : bool,  right_5 : bool,  up_5 : bool) -> vec3<f32>
{
    if(is_layered_0(fabric_13))
    {
        return first_bounds_0(fabric_13, plane_order_0(fabric_13, x_12, y_10, back_14), x_12, y_10, back_14, right_5, up_5);
    }
    return bounds_in_0(whole_plane_0(fabric_13), x_12, y_10, back_14, right_5, up_5);
}

fn first_sample_height_0( fabric_14 : Fabric_0,  ray_1 : ViewRay_0,  steps_1 : StepControl_0,  back_15 : bool) -> f32
{
    var _S123 : f32 = max_height_along_0(fabric_14, ray_1.origin_0.x, ray_1.origin_0.y, 0.0f, vec3<f32>(ray_1.slope_1, 1.0f), back_15);
    var count_2 : u32 = u32(0);
    var height_5 : f32 = _S123;
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S124 : vec2<f32> = ViewRay_at_0(ray_1, height_5);
        var _S125 : vec3<f32> = cell_bounds_0(fabric_14, _S124.x, _S124.y, back_15, steps_1.right_3, steps_1.up_3);
        var _S126 : f32 = height_5 - _S125.x;
        var _S127 : f32 = StepControl_to_cell_exit_0(steps_1, _S125.y, _S125.z);
        var height_6 : f32 = height_5 - clamp(_S126, 0.0f, _S127);
        if(_S126 <= _S127)
        {
            height_5 = height_6;
            break;
        }
        count_2 = count_2 + u32(1);
        height_5 = height_6;
    }
    return height_5;
}

fn ViewRay_rate_0( this_3 : ViewRay_0,  here_6 : Probe_0) -> f32
{
    return here_6.slope_x_1 * this_3.slope_1.x + here_6.slope_y_1 * this_3.slope_1.y - 1.0f;
}

struct ViewRayEnd_0
{
     height_7 : f32,
     last_step_3 : f32,
     depth_0 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn search_down_0( fabric_15 : Fabric_0,  ray_2 : ViewRay_0,  steps_2 : StepControl_0,  back_16 : bool) -> ViewRayEnd_0
{
    var _S128 : f32 = fabric_15.height_low_0 - (fabric_15.height_high_0 - fabric_15.height_low_0);
    var end_0 : ViewRayEnd_0;
    end_0.height_7 = first_sample_height_0(fabric_15, ray_2, steps_2, back_16);
    end_0.last_step_3 = steps_2.epsilon_0;
    end_0.previous_4 = no_previous_sample_0();
    end_0.depth_0 = 0.0f;
    end_0.rate_4 = 0.0f;
    end_0.smooth_0 = false;
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
        var _S129 : vec2<f32> = ViewRay_at_0(ray_2, end_0.height_7);
        var _S130 : Probe_0 = probe_0(fabric_15, _S129.x, _S129.y, back_16, steps_2.right_3, steps_2.up_3);
        var _S131 : f32 = end_0.height_7 - _S130.height_2;
        var _S132 : f32 = ViewRay_rate_0(ray_2, _S130);
        end_0.depth_0 = - _S131;
        end_0.rate_4 = _S132;
        var _S133 : bool = !_S130.hole_1;
        end_0.smooth_0 = ((((end_0.previous_4.known_0) & (_S133))) & (((end_0.previous_4.yarn_0) == (_S130.yarn_1))));
        if((((_S133 & ((_S131 <= 0.0f)))) | (((end_0.height_7) <= _S128))))
        {
            break;
        }
        var _S134 : f32 = way_back_to_dip_0(end_0.previous_4, _S131, _S132, end_0.last_step_3, _S130);
        if(_S134 >= 0.0f)
        {
            end_0.height_7 = end_0.height_7 + _S134;
            end_0.last_step_3 = end_0.last_step_3 - _S134;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S135 : f32 = min(StepControl_to_cell_exit_0(steps_2, _S130.side_x_0, _S130.side_y_0), end_0.height_7 - _S130.cell_max_0);
        var _S136 : f32 = StepControl_to_next_sample_0(steps_2, _S130, _S131, _S132);
        end_0.previous_4 = after_sample_0(_S131, _S132, _S130, _S135 > _S136);
        var _S137 : f32 = max(_S135, _S136);
        end_0.last_step_3 = _S137;
        end_0.height_7 = end_0.height_7 - _S137;
        count_3 = count_3 + u32(1);
    }
    return end_0;
}

fn cubic_root_0( start_2 : f32,  end_1 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S138 : f32 = end_1 - start_2;
    var _S139 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S138;
    var _S140 : f32 = 3.0f * _S138 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_2 / max(- _S138, 9.99999968265522539e-21f);
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
        var _S141 : f32 = clamp(share_0 - (((_S139 * share_0 + _S140) * share_0 + start_rate_0) * share_0 + start_2) / min((3.0f * _S139 * share_0 + 2.0f * _S140) * share_0 + start_rate_0, 0.10000000149011612f * _S138 - 9.99999968265522539e-21f), 0.0f, 1.0f);
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

fn refined_height_0( fabric_16 : Fabric_0,  ray_3 : ViewRay_0,  steps_3 : StepControl_0,  back_17 : bool,  end_2 : ViewRayEnd_0,  refinements_1 : u32) -> f32
{
    var _S143 : f32 = fabric_16.height_high_0 - fabric_16.height_low_0;
    var above_2 : f32 = end_2.height_7 + end_2.last_step_3;
    var above_gap_1 : f32 = clamp(end_2.previous_4.clearance_0, 0.0f, _S143);
    var under_gap_1 : f32 = clamp(end_2.depth_0, 0.0f, _S143);
    var middle_0 : f32 = select(between_0(above_2, end_2.height_7, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, end_2.previous_4.rate_0 * end_2.last_step_3, end_2.rate_4 * end_2.last_step_3) * end_2.last_step_3, end_2.smooth_0);
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = end_2.height_7;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < refinements_1)
        {
        }
        else
        {
            break;
        }
        var _S144 : vec2<f32> = ViewRay_at_0(ray_3, middle_0);
        var _S145 : Probe_0 = probe_0(fabric_16, _S144.x, _S144.y, back_17, steps_3.right_3, steps_3.up_3);
        var _S146 : f32 = clamp(middle_0 - select(_S145.height_2, -1.0e+09f, _S145.hole_1), - _S143, _S143);
        if(_S146 <= 0.0f)
        {
            var _S147 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_1 > 0.0f);
            var _S148 : f32 = - _S146;
            under_1 = middle_0;
            above_gap_2 = _S147;
            under_gap_2 = _S148;
            side_1 = 1.0f;
        }
        else
        {
            var _S149 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_1 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S146;
            under_gap_2 = _S149;
            side_1 = -1.0f;
        }
        var _S150 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S146 / min(ViewRay_rate_0(ray_3, _S145), -9.99999997475242708e-07f), under_1, above_3), end_2.smooth_0);
        var _S151 : u32 = i_1 + u32(1);
        middle_0 = _S150;
        i_1 = _S151;
    }
    return select(under_1, middle_0, end_2.smooth_0);
}

struct Hit_0
{
     x_13 : f32,
     y_11 : f32,
     hole_2 : bool,
     height_8 : f32,
};

fn first_hit_of_yarn_0( fabric_17 : Fabric_0,  quality_4 : SearchQuality_0,  x_14 : f32,  y_12 : f32,  view_1 : vec3<f32>,  back_18 : bool) -> Hit_0
{
    var _S152 : f32 = max(view_1.z, 0.00009999999747379f);
    var ray_4 : ViewRay_0;
    ray_4.origin_0 = vec2<f32>(x_14, y_12);
    var _S153 : vec2<f32> = view_1.xy / vec2<f32>(_S152);
    ray_4.slope_1 = _S153;
    var _S154 : StepControl_0 = step_control_0((vec2<f32>(0) - _S153), 1.0f / max(steps_per_length_0(fabric_17, quality_4, view_1) / _S152, 9.99999971718068537e-10f));
    var _S155 : ViewRayEnd_0 = search_down_0(fabric_17, ray_4, _S154, back_18);
    var hit_0 : Hit_0;
    hit_0.hole_2 = false;
    var _S156 : f32 = refined_height_0(fabric_17, ray_4, _S154, back_18, _S155, quality_4.refinements_0);
    hit_0.height_8 = _S156;
    var _S157 : vec2<f32> = ViewRay_at_0(ray_4, _S156);
    hit_0.x_13 = _S157.x;
    hit_0.y_11 = _S157.y;
    return hit_0;
}

fn first_hit_0( fabric_18 : Fabric_0,  quality_5 : SearchQuality_0,  x_15 : f32,  y_13 : f32,  view_2 : vec3<f32>,  back_19 : bool) -> Hit_0
{
    if(!passes_through_0(fabric_18, quality_5, x_15, y_13, view_2, back_19))
    {
        return first_hit_of_yarn_0(fabric_18, quality_5, x_15, y_13, view_2, back_19);
    }
    var hit_1 : Hit_0;
    hit_1.x_13 = x_15;
    hit_1.y_11 = y_13;
    hit_1.height_8 = 0.0f;
    hit_1.hole_2 = true;
    return hit_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S158 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S159 : f32 = rsqrt_0(_S158);
    var _S160 : f32 = sine_1 * _S159 * rsqrt_0(_S158 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S160 * _S158, _S160 * across_slope_0 * along_slope_0 + cosine_0 * _S159);
}

fn arc_sine_0( x_16 : f32) -> f32
{
    var _S161 : f32 = abs(x_16);
    var _S162 : bool = _S161 > 0.5f;
    var _S163 : f32 = select(_S161 * _S161, 0.5f * (1.0f - _S161), _S162);
    var _S164 : f32 = select(_S161, sqrt(max(_S163, 0.0f)), _S162);
    var _S165 : f32 = ((((0.04216320067644119f * _S163 + 0.02418131195008755f) * _S163 + 0.04547002539038658f) * _S163 + 0.07495300471782684f) * _S163 + 0.16666752099990845f) * _S163 * _S164 + _S164;
    var _S166 : f32 = select(_S165, 1.57079637050628662f - 2.0f * _S165, _S162);
    return select(_S166, - _S166, x_16 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S167 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S167 / (_S167 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

struct SurfacePoint_0
{
     hole_3 : bool,
     is_warp_1 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_9 : f32,
     normal_0 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     x_17 : f32,
     y_14 : f32,
     shown_share_0 : f32,
     plane_5 : f32,
     layer_0 : u32,
};

fn surface_of_0( fabric_19 : Fabric_0,  sample_1 : Sample_0,  x_18 : f32,  y_15 : f32,  back_20 : bool) -> SurfacePoint_0
{
    var _S168 : u32 = select(fabric_19.weft_0, fabric_19.warp_0, sample_1.shown_2.is_warp_0);
    var _S169 : f32 = families_0[_S168].twist_sine_0 * select(1.0f, -1.0f, back_20);
    var _S170 : f32 = families_0[_S168].twist_cosine_0;
    var _S171 : f32 = select(-1.0f, 1.0f, sample_1.shown_2.is_warp_0);
    var _S172 : vec2<f32> = fibre_direction_0(sample_1.slope_across_0, _S171 * sample_1.slope_along_0, _S169, families_0[_S168].twist_cosine_0);
    var _S173 : f32 = _S172.x;
    var _S174 : f32 = _S172.y;
    var _S175 : f32 = select(sample_1.slope_y_0, sample_1.slope_x_0, sample_1.shown_2.is_warp_0) * _S173 + _S171 * select(sample_1.slope_x_0, sample_1.slope_y_0, sample_1.shown_2.is_warp_0) * _S174;
    var _S176 : f32 = select(sample_1.crossing_3.weft_2.half_width_1, sample_1.crossing_3.warp_2.half_width_1, sample_1.shown_2.is_warp_0) * 1.0154266357421875f;
    var _S177 : f32 = _S176 * arc_sine_0(clamp(sample_1.section_1.across_1 / _S176, -1.0f, 1.0f));
    var _S178 : f32 = select(sample_1.here_1.plane_4.start_x_0 - x_18, y_15 - sample_1.here_1.plane_4.start_y_0, sample_1.shown_2.is_warp_0);
    var point_0 : SurfacePoint_0;
    point_0.hole_3 = sample_1.shown_2.hole_0;
    point_0.is_warp_1 = sample_1.shown_2.is_warp_0;
    point_0.warp_thread_0 = sample_1.crossing_3.warp_2.thread_0;
    point_0.weft_thread_0 = sample_1.crossing_3.weft_2.thread_0;
    if(is_layered_0(fabric_19))
    {
        point_0.warp_thread_0 = words_0[sample_1.here_1.plane_4.end_numbers_0 + point_0.warp_thread_0];
        point_0.weft_thread_0 = words_0[sample_1.here_1.plane_4.pick_numbers_0 + point_0.weft_thread_0];
    }
    point_0.height_9 = sample_1.height_1;
    point_0.plane_5 = sample_1.here_1.level_1;
    point_0.layer_0 = sample_1.here_1.number_2;
    point_0.normal_0 = normalize(vec3<f32>(- sample_1.slope_x_0, - sample_1.slope_y_0, 1.0f));
    point_0.tangent_0 = normalize(select_vector_1(sample_1.shown_2.is_warp_0, vec3<f32>(_S173, _S174, _S175), vec3<f32>(- _S174, _S173, _S175)));
    point_0.across_2 = sample_1.section_1.across_1;
    point_0.fibre_across_0 = _S177 * _S170 + _S178 * _S169;
    point_0.fibre_along_0 = _S178 * _S170 - _S177 * _S169;
    var _S179 : f32 = run_share_0(sample_1.shown_2.word_0);
    point_0.shown_share_0 = select(1.0f - _S179, _S179, sample_1.shown_2.on_top_0);
    point_0.x_17 = x_18;
    point_0.y_14 = y_15;
    return point_0;
}

fn angle_of_0( direction_4 : vec2<f32>) -> f32
{
    var _S180 : f32 = direction_4.x;
    var _S181 : f32 = arc_sine_0(_S180);
    var _S182 : bool = _S180 < 0.0f;
    var _S183 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S182);
    var _S184 : f32 = direction_4.y;
    return select(0.5f * _S183 - select(1.0f, -1.0f, _S182) * arc_sine_0(_S184), select(_S181, _S183 - _S181, _S184 < 0.0f), (abs(_S180)) < 0.69999998807907104f);
}

fn surface_met_0( fabric_20 : Fabric_0,  x_19 : f32,  y_16 : f32,  height_10 : f32,  view_3 : vec3<f32>,  back_21 : bool) -> SurfacePoint_0
{
    var _S185 : Sample_0 = sample_at_0(fabric_20, x_19, y_16, back_21);
    var point_1 : SurfacePoint_0 = surface_of_0(fabric_20, _S185, x_19, y_16, back_21);
    var _S186 : u32 = select(fabric_20.weft_0, fabric_20.warp_0, point_1.is_warp_1);
    var _S187 : f32 = select(_S185.crossing_3.weft_2.half_width_1, _S185.crossing_3.warp_2.half_width_1, point_1.is_warp_1) * 1.0154266357421875f;
    var _S188 : f32 = _S185.dive_1.z;
    var _S189 : f32 = _S185.slope_along_0 - (1.0f - _S188) * _S185.dive_1.y / families_0[_S186].height_scale_0;
    var _S190 : f32 = rsqrt_0(_S189 * _S189 + 1.0f);
    var _S191 : f32 = view_3.x;
    var _S192 : f32 = view_3.y;
    var _S193 : f32 = select(_S192, _S191, point_1.is_warp_1);
    var _S194 : f32 = view_3.z;
    var _S195 : f32 = (_S194 / families_0[_S186].height_scale_0 - _S189 * select(_S191, _S192, point_1.is_warp_1)) * _S190;
    var _S196 : f32 = square_0(_S187);
    var _S197 : f32 = sqrt(max(_S196 - square_0(point_1.across_2), 0.0f)) - (_S185.height_1 + _S188 * _S185.dive_1.x - height_10) / families_0[_S186].height_scale_0 * _S190;
    var _S198 : f32 = square_0(_S193) + square_0(_S195) + 9.999999960041972e-13f;
    var _S199 : f32 = point_1.across_2 * _S193 + _S197 * _S195;
    var _S200 : f32 = square_0(point_1.across_2) + square_0(_S197) - _S196;
    var _S201 : f32 = sqrt(max(square_0(_S199) - _S198 * _S200, 0.0f));
    var _S202 : f32 = clamp(select((_S201 - _S199) / _S198, - _S200 / max(_S199 + _S201, 9.999999960041972e-13f), _S199 > 0.0f), - _S187, _S187);
    var _S203 : f32 = point_1.across_2 + _S202 * _S193;
    point_1.across_2 = _S203;
    var _S204 : vec2<f32> = normalize(vec2<f32>(_S203, _S197 + _S202 * _S195));
    var _S205 : f32 = select(-1.0f, 1.0f, point_1.is_warp_1);
    var _S206 : f32 = families_0[_S186].twist_sine_0 * select(1.0f, -1.0f, back_21);
    var _S207 : f32 = _S204.x;
    var _S208 : f32 = _S206 * _S207 * _S190;
    var _S209 : f32 = _S204.y;
    var _S210 : f32 = - _S206 * _S209;
    var _S211 : f32 = families_0[_S186].twist_cosine_0 * _S190 - _S205 * _S189 * _S208;
    var _S212 : f32 = families_0[_S186].height_scale_0 * (families_0[_S186].twist_cosine_0 * _S205 * _S189 * _S190 + _S208);
    var _S213 : f32 = families_0[_S186].height_scale_0 * _S207;
    var _S214 : f32 = - families_0[_S186].height_scale_0 * _S189 * _S190 * _S209;
    point_1.normal_0 = normalize(vec3<f32>(select(_S214, _S213, point_1.is_warp_1), select(_S213, _S214, point_1.is_warp_1), _S190 * _S209));
    point_1.tangent_0 = normalize(vec3<f32>(select(- _S211, _S210, point_1.is_warp_1), select(_S210, _S211, point_1.is_warp_1), _S212));
    var _S215 : f32 = _S187 * angle_of_0(_S204);
    var _S216 : f32 = select(- x_19 - _S202 * _S191, y_16 + _S202 * _S192, point_1.is_warp_1);
    point_1.fibre_across_0 = _S215 * families_0[_S186].twist_cosine_0 + _S216 * _S206;
    point_1.fibre_along_0 = _S216 * families_0[_S186].twist_cosine_0 - _S215 * _S206;
    var _S217 : f32 = 0.00999999977648258f * _S187;
    var _S218 : f32 = - _S217;
    var _S219 : bool = _S202 < _S218;
    var _S220 : f32 = select(_S217, _S218, _S193 < 0.0f);
    var _S221 : f32 = max(_S202, 0.0f);
    point_1.x_17 = point_1.x_17 + select(_S221 * _S191, select(0.0f, _S220, point_1.is_warp_1), _S219);
    point_1.y_14 = point_1.y_14 + select(_S221 * _S192, select(_S220, 0.0f, point_1.is_warp_1), _S219);
    point_1.height_9 = select(height_10 + _S202 * _S194, height_10, _S219);
    return point_1;
}

fn surface_at_0( fabric_21 : Fabric_0,  x_20 : f32,  y_17 : f32,  back_22 : bool) -> SurfacePoint_0
{
    return surface_of_0(fabric_21, sample_at_0(fabric_21, x_20, y_17, back_22), x_20, y_17, back_22);
}

fn fract_of_0( number_5 : f32) -> f32
{
    return number_5 - floor(number_5);
}

fn sine_cosine_0( x_21 : f32) -> vec2<f32>
{
    var _S222 : f32 = floor(x_21 * 0.63661974668502808f + 0.5f);
    var _S223 : f32 = x_21 - _S222 * 1.5703125f - _S222 * 0.00048375129699707f - _S222 * 7.54979012640433211e-08f;
    var _S224 : f32 = _S223 * _S223;
    var _S225 : f32 = ((-0.00019515295571182f * _S224 + 0.00833216123282909f) * _S224 - 0.16666655242443085f) * _S224 * _S223 + _S223;
    var _S226 : f32 = ((0.00002443315679557f * _S224 - 0.00138873164542019f) * _S224 + 0.04166664555668831f) * _S224 * _S224 - 0.5f * _S224 + 1.0f;
    var _S227 : u32 = (u32(i32(_S222)) & (u32(3)));
    var _S228 : vec2<f32> = select_vector_0(((_S227 & (u32(1)))) != u32(0), vec2<f32>(_S226, _S225), vec2<f32>(_S225, _S226));
    var _S229 : f32 = _S228.x;
    var _S230 : f32 = _S228.y;
    return vec2<f32>(select(_S229, - _S229, ((_S227 & (u32(2)))) != u32(0)), select(_S230, - _S230, (((_S227 + u32(1)) & (u32(2)))) != u32(0)));
}

fn uniform_on_sphere_0( u_0 : vec2<f32>) -> vec3<f32>
{
    var _S231 : f32 = u_0.x;
    var _S232 : f32 = 2.0f * sqrt(max(_S231 * (1.0f - _S231), 0.0f));
    var _S233 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_0.y);
    return vec3<f32>(_S232 * _S233.y, _S232 * _S233.x, 1.0f - 2.0f * _S231);
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

fn sample_diffuse_0( normal_1 : vec3<f32>,  blend_0 : f32,  u_2 : vec2<f32>) -> vec3<f32>
{
    var _S234 : f32 = u_2.x;
    var _S235 : bool = _S234 < blend_0;
    return cosine_about_0(select_vector_1(_S235, normal_1, vec3<f32>(0.0f, 0.0f, 1.0f)), vec2<f32>(min((_S234 - select(blend_0, 0.0f, _S235)) / max(select(1.0f - blend_0, blend_0, _S235), 1.00000001168609742e-07f), 0.99999994039535522f), u_2.y));
}

fn met_from_0( fabric_22 : Fabric_0,  x_22 : f32,  y_18 : f32,  height_11 : f32,  direction_5 : vec3<f32>,  back_23 : bool) -> u32
{
    var _S236 : f32 = max(fabric_22.height_high_0 - fabric_22.height_low_0, 9.99999997475242708e-07f);
    var _S237 : f32 = direction_5.x;
    var _S238 : f32 = direction_5.y;
    var _S239 : f32 = min(min(1.0f / fabric_22.threads_per_x_0, 1.0f / fabric_22.threads_per_y_0) / 16.0f / max(sqrt(_S237 * _S237 + _S238 * _S238), 9.99999997475242708e-07f), _S236 / 16.0f / max(abs(direction_5.z), 9.99999997475242708e-07f));
    var _S240 : vec3<f32> = vec3<f32>(x_22, y_18, height_11 + fabric_22.lift_0);
    var count_4 : u32 = u32(0);
    var place_0 : vec3<f32> = _S240;
    for(;;)
    {
        if(count_4 < u32(2048))
        {
        }
        else
        {
            break;
        }
        var place_1 : vec3<f32> = place_0 + direction_5 * vec3<f32>(_S239);
        var _S241 : Sample_0 = sample_at_0(fabric_22, place_1.x, place_1.y, back_23);
        var _S242 : f32 = place_1.z;
        if(((!_S241.shown_2.hole_0) & ((_S242 < (_S241.height_1)))))
        {
            return (u32(4) | (select(u32(0), u32(8), _S241.shown_2.is_warp_0)));
        }
        if(((_S242 > (fabric_22.height_high_0)) | ((_S242 < (fabric_22.height_low_0 - _S236)))))
        {
            break;
        }
        count_4 = count_4 + u32(1);
        place_0 = place_1;
    }
    return u32(0);
}

fn unoccluded_0( fabric_23 : Fabric_0,  quality_6 : SearchQuality_0,  x_23 : f32,  y_19 : f32,  height_12 : f32,  direction_6 : vec3<f32>,  back_24 : bool) -> bool
{
    if((direction_6.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(fabric_23, quality_6, vec3<f32>(x_23, y_19, height_12 + fabric_23.lift_0), direction_6, back_24, max_height_along_0(fabric_23, x_23, y_19, height_12, direction_6, back_24));
}

fn diffuse_pdf_0( light_1 : vec3<f32>,  normal_2 : vec3<f32>,  blend_1 : f32) -> f32
{
    return 0.31830987334251404f * mix(max(light_1.z, 0.0f), max(dot(light_1, normal_2), 0.0f), blend_1);
}

fn projected_area_1( direction_7 : vec3<f32>,  tangent_1 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S243 : f32 = dot(direction_7, tangent_1);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S243 * _S243 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_24 : f32) -> f32
{
    var _S244 : f32 = clamp(x_24, -87.0f, 88.0f);
    var _S245 : f32 = floor(_S244 * 1.4426950216293335f + 0.5f);
    var _S246 : f32 = _S244 - _S245 * 0.693359375f + _S245 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S246 + 0.00139819993637502f) * _S246 + 0.00833345204591751f) * _S246 + 0.04166579619050026f) * _S246 + 0.1666666567325592f) * _S246 + 0.5f) * _S246 * _S246 + _S246 + 1.0f) * (bitcast<f32>(((u32(i32(_S245) + i32(127)) << (u32(23)))))), 0.0f, x_24 < -87.0f);
}

fn mean_attenuation_0( depth_1 : f32) -> f32
{
    if(depth_1 < 0.10000000149011612f)
    {
        return (((depth_1 / 120.0f - 0.0416666679084301f) * depth_1 + 0.1666666716337204f) * depth_1 - 0.5f) * depth_1 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_1)) / depth_1;
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S247 : f32 = roughness_2 * roughness_2;
    var _S248 : f32 = squared_along_0 * (1.0f - _S247) + _S247;
    return 0.31830987334251404f * _S247 * roughness_2 / (_S248 * _S248);
}

fn density_between_0( light_2 : vec3<f32>,  view_4 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S249 : vec3<f32> = light_2 + view_4;
    var _S250 : f32 = dot(_S249, tangent_2);
    return flake_density_0(min(_S250 * _S250 / max(square_1(_S249), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_5 : vec3<f32>,  normal_3 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S251 : f32 = dot(light_3, normal_3);
    var _S252 : f32 = dot(view_5, normal_3);
    if(((_S251 <= 0.0f) | ((_S252 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S253 : f32 = max(_S251, 9.99999997475242708e-07f);
    var _S254 : f32 = max(_S252, 9.99999997475242708e-07f);
    var _S255 : f32 = projected_area_1(light_3, tangent_3, roughness_4) * _S254 + projected_area_1(view_5, tangent_3, roughness_4) * _S253;
    var _S256 : f32 = optical_depth_1 * _S255 / (_S253 * _S254);
    return 0.25f * density_between_0(light_3, view_5, tangent_3, roughness_4) * (_S256 * mean_attenuation_0(_S256)) * _S253 / _S255;
}

fn transmission_1( light_4 : vec3<f32>,  view_6 : vec3<f32>,  normal_4 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S257 : f32 = - dot(light_4, normal_4);
    var _S258 : f32 = dot(view_6, normal_4);
    if(((_S257 <= 0.0f) | ((_S258 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S259 : f32 = 1.0f / max(_S258, 9.99999997475242708e-07f);
    var _S260 : f32 = projected_area_1(light_4, tangent_4, roughness_5) / max(_S257, 9.99999997475242708e-07f);
    var _S261 : f32 = projected_area_1(view_6, tangent_4, roughness_5) * _S259;
    return density_between_0(light_4, view_6, tangent_4, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S260, _S261)) * mean_attenuation_0(optical_depth_2 * abs(_S260 - _S261)) * _S259;
}

fn is_layered_1( _S262 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S262].planes_0) != u32(0))));
}

fn whole_plane_1( _S263 : u32) -> Plane_0
{
    var plane_6 : Plane_0;
    plane_6.warp_1 = fabrics_0[_S263].warp_0;
    plane_6.weft_1 = fabrics_0[_S263].weft_0;
    plane_6.run_words_1 = fabrics_0[_S263].run_words_0;
    plane_6.ends_2 = fabrics_0[_S263].ends_1;
    plane_6.end_numbers_0 = u32(0);
    plane_6.pick_numbers_0 = u32(0);
    plane_6.max_heights_1 = fabrics_0[_S263].max_heights_0;
    plane_6.max_height_columns_1 = fabrics_0[_S263].max_height_columns_0;
    plane_6.height_low_1 = fabrics_0[_S263].height_low_0;
    plane_6.height_high_1 = fabrics_0[_S263].height_high_0;
    plane_6.front_level_0 = 0.0f;
    plane_6.back_level_0 = 0.0f;
    plane_6.start_x_0 = 0.0f;
    plane_6.start_y_0 = 0.0f;
    plane_6.fine_x_0 = 0.0f;
    plane_6.fine_y_0 = 0.0f;
    return plane_6;
}

fn plane_of_1( _S264 : u32,  _S265 : u32) -> Plane_0
{
    if(!is_layered_1(_S264))
    {
        return whole_plane_1(_S264);
    }
    return plane_at_0(fabrics_0[_S264].plane_records_0 + _S265 * u32(16));
}

fn front_layer_0( _S266 : u32) -> Fabric_0
{
    var _S267 : Fabric_std430_0 = fabrics_0[_S266];
    var _S268 : Lobes_0 = Lobes_0( _S267.lobes_0.is_baked_0, _S267.lobes_0.inverse_base_size_0, _S267.lobes_0.last_level_0, _S267.lobes_0.levels_0, _S267.lobes_0.face_nodes_0, _S267.lobes_0.packs_0, _S267.lobes_0.front_warp_packs_0, _S267.lobes_0.back_warp_packs_0, _S267.lobes_0.coverage_0, _S267.lobes_0.coverage_holes_0, _S267.lobes_0.projected_area_0, _S267.lobes_0.light_visibility_0, _S267.lobes_0.irradiance_0, _S267.lobes_0.moments_0, _S267.lobes_0.joint_0, _S267.lobes_0.front_hole_weight_0, _S267.lobes_0.back_hole_weight_0, _S267.lobes_0.threads_per_mm_0, _S267.lobes_0.unit_level_0 );
    var _S269 : Neural_0 = Neural_0( _S267.neural_0.is_encoded_0, _S267.neural_0.network_0, _S267.neural_0.latents_0, _S267.neural_0.texels_0, _S267.neural_0.levels_1, _S267.neural_0.top_level_0, _S267.neural_0.ends_0, _S267.neural_0.picks_0, _S267.neural_0.ends_per_mm_0, _S267.neural_0.picks_per_mm_0, _S267.neural_0.pitch_0, _S267.neural_0.warp_x_0, _S267.neural_0.warp_y_0, _S267.neural_0.warp_roughness_0, _S267.neural_0.weft_x_0, _S267.neural_0.weft_y_0, _S267.neural_0.weft_roughness_0, _S267.neural_0.warp_lobe_roughness_0, _S267.neural_0.weft_lobe_roughness_0, _S267.neural_0.bundles_0, _S267.neural_0.is_corrected_0, _S267.neural_0.correction_0 );
    var _S270 : Neumip_0 = Neumip_0( _S267.neumip_0.is_trained_0, _S267.neumip_0.decoder_0, _S267.neumip_0.has_offset_0, _S267.neumip_0.offset_0, _S267.neumip_0.offset_texels_0, _S267.neumip_0.features_0, _S267.neumip_0.texel_elements_0, _S267.neumip_0.levels_2, _S267.neumip_0.last_level_1, _S267.neumip_0.face_texels_0, _S267.neumip_0.back_0, _S267.neumip_0.repeats_per_x_0, _S267.neumip_0.repeats_per_y_0, _S267.neumip_0.texels_per_mm_0, _S267.neumip_0.unit_x_0, _S267.neumip_0.unit_y_0, _S267.neumip_0.transmits_0, _S267.neumip_0.transmission_0, _S267.neumip_0.has_holes_0, _S267.neumip_0.opacity_0 );
    var _S271 : Latent_0 = Latent_0( _S267.latent_0.is_trained_1, _S267.latent_0.decoder_1, _S267.latent_0.hidden_0, _S267.latent_0.frames_0, _S267.latent_0.sampler_0, _S267.latent_0.albedo_0, _S267.latent_0.auxiliary_0, _S267.latent_0.texels_1, _S267.latent_0.texel_elements_1, _S267.latent_0.levels_3, _S267.latent_0.last_level_2, _S267.latent_0.face_texels_1, _S267.latent_0.back_1, _S267.latent_0.repeats_per_x_1, _S267.latent_0.repeats_per_y_1, _S267.latent_0.texels_per_mm_1, _S267.latent_0.width_0, _S267.latent_0.height_0, _S267.latent_0.is_trilinear_0, _S267.latent_0.is_apart_0 );
    var _S272 : Clustered_0 = Clustered_0( _S267.clustered_0.is_baked_1, _S267.clustered_0.clusters_0, _S267.clustered_0.rank_0, _S267.clustered_0.channels_0, _S267.clustered_0.columns_0, _S267.clustered_0.rows_0, _S267.clustered_0.texel_width_0, _S267.clustered_0.texel_height_0, _S267.clustered_0.samples_0, _S267.clustered_0.sums_0, _S267.clustered_0.labels_0, _S267.clustered_0.coefficients_0, _S267.clustered_0.basis_0, _S267.clustered_0.moments_1, _S267.clustered_0.texels_2, _S267.clustered_0.light_0, _S267.clustered_0.heights_0 );
    var _S273 : Fabric_0 = Fabric_0( _S267.warp_0, _S267.weft_0, _S268, _S269, _S270, _S267.run_words_0, _S267.ends_1, _S267.max_heights_0, _S267.max_height_columns_0, _S267.height_low_0, _S267.height_high_0, _S267.lift_0, _S267.threads_per_x_0, _S267.threads_per_y_0, _S267.per_relief_0, _S267.diffuse_blend_0, _S267.optical_depth_0, _S267.grazing_gain_0, _S267.grazing_loss_0, _S267.sheen_strength_0, _S267.sheen_roughness_0, _S267.fibre_noise_0, _S267.colour_noise_0, _S267.seed_0, _S267.layer_bound_0, _S267.fibre_size_0, _S267.is_irregular_0, _S267.warp_on_top_0, _S267.has_detail_0, _S267.uv_width_0, _S267.uv_height_0, _S267.is_open_0, _S267.openness_0, _S267.albedo_map_0, _S267.albedo_map_levels_0, _S267.has_yarns_0, _S267.mean_hole_0, _S271, _S272, _S267.planes_0, _S267.plane_records_0, _S267.plane_axes_0, _S267.stacks_0, _S267.plane_orders_0, _S267.regions_0, _S267.plane_shares_0, _S267.is_coloured_0 );
    if(!is_layered_1(_S266))
    {
        return _S273;
    }
    var _S274 : Plane_0 = plane_of_1(_S266, u32(0));
    var front_0 : Fabric_0;
    front_0.warp_0 = _S267.warp_0;
    front_0.weft_0 = _S267.weft_0;
    front_0.lobes_0 = _S268;
    front_0.neural_0 = _S269;
    front_0.neumip_0 = _S270;
    front_0.run_words_0 = _S267.run_words_0;
    front_0.ends_1 = _S267.ends_1;
    front_0.max_heights_0 = _S267.max_heights_0;
    front_0.max_height_columns_0 = _S267.max_height_columns_0;
    front_0.height_low_0 = _S267.height_low_0;
    front_0.height_high_0 = _S267.height_high_0;
    front_0.lift_0 = _S267.lift_0;
    front_0.threads_per_x_0 = _S267.threads_per_x_0;
    front_0.threads_per_y_0 = _S267.threads_per_y_0;
    front_0.per_relief_0 = _S267.per_relief_0;
    front_0.diffuse_blend_0 = _S267.diffuse_blend_0;
    front_0.optical_depth_0 = _S267.optical_depth_0;
    front_0.grazing_gain_0 = _S267.grazing_gain_0;
    front_0.grazing_loss_0 = _S267.grazing_loss_0;
    front_0.sheen_strength_0 = _S267.sheen_strength_0;
    front_0.sheen_roughness_0 = _S267.sheen_roughness_0;
    front_0.fibre_noise_0 = _S267.fibre_noise_0;
    front_0.colour_noise_0 = _S267.colour_noise_0;
    front_0.seed_0 = _S267.seed_0;
    front_0.layer_bound_0 = _S267.layer_bound_0;
    front_0.fibre_size_0 = _S267.fibre_size_0;
    front_0.is_irregular_0 = _S267.is_irregular_0;
    front_0.warp_on_top_0 = _S267.warp_on_top_0;
    front_0.has_detail_0 = _S267.has_detail_0;
    front_0.uv_width_0 = _S267.uv_width_0;
    front_0.uv_height_0 = _S267.uv_height_0;
    front_0.is_open_0 = _S267.is_open_0;
    front_0.openness_0 = _S267.openness_0;
    front_0.albedo_map_0 = _S267.albedo_map_0;
    front_0.albedo_map_levels_0 = _S267.albedo_map_levels_0;
    front_0.has_yarns_0 = _S267.has_yarns_0;
    front_0.mean_hole_0 = _S267.mean_hole_0;
    front_0.latent_0 = _S271;
    front_0.clustered_0 = _S272;
    front_0.planes_0 = _S267.planes_0;
    front_0.plane_records_0 = _S267.plane_records_0;
    front_0.plane_axes_0 = _S267.plane_axes_0;
    front_0.stacks_0 = _S267.stacks_0;
    front_0.plane_orders_0 = _S267.plane_orders_0;
    front_0.regions_0 = _S267.regions_0;
    front_0.plane_shares_0 = _S267.plane_shares_0;
    front_0.is_coloured_0 = _S267.is_coloured_0;
    front_0.planes_0 = u32(0);
    front_0.warp_0 = _S274.warp_1;
    front_0.weft_0 = _S274.weft_1;
    front_0.run_words_0 = _S274.run_words_1;
    front_0.ends_1 = _S274.ends_2;
    front_0.max_heights_0 = _S274.max_heights_1;
    front_0.max_height_columns_0 = _S274.max_height_columns_1;
    front_0.height_low_0 = _S274.height_low_1;
    front_0.height_high_0 = _S274.height_high_1;
    front_0.lift_0 = 0.0020000000949949f * min(_S274.fine_x_0, _S274.fine_y_0);
    front_0.threads_per_x_0 = 1.0f / _S274.fine_x_0;
    front_0.threads_per_y_0 = 1.0f / _S274.fine_y_0;
    front_0.per_relief_0 = 1.0f / max(_S274.height_high_1 - _S274.height_low_1, 9.99999997475242708e-07f);
    return front_0;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_openness(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S275 : u32 = thread_index_0(id_1);
    var _S276 : u32 = steps_0[i32(1)];
    if(_S275 >= (u32(2) * _S276))
    {
        return;
    }
    var _S277 : Fabric_0 = front_layer_0(steps_0[i32(0)]);
    var _S278 : bool = _S275 >= _S276;
    var _S279 : u32 = select(_S275, _S275 - _S276, _S278);
    var _S280 : vec3<f32> = vec3<f32>(ray_number_0(_S279, u32(2)), ray_number_0(_S279, u32(3)), ray_number_0(_S279, u32(4)));
    var _S281 : SearchQuality_0 = openness_quality_0();
    var _S282 : Hit_0 = first_hit_0(_S277, _S281, ray_number_0(_S279, u32(0)), ray_number_0(_S279, u32(1)), _S280, _S278);
    var _S283 : u32 = _S275 * u32(10);
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
        scratch_0[_S283 + k_0] = u32(0);
        k_0 = k_0 + u32(1);
    }
    if(_S282.hole_2)
    {
        scratch_0[_S283] = u32(2);
        return;
    }
    var _S284 : SurfacePoint_0 = surface_met_0(_S277, _S282.x_13, _S282.y_11, _S282.height_8, _S280, _S278);
    var _S285 : bool = !_S278;
    var _S286 : SurfacePoint_0 = surface_at_0(_S277, _S284.x_17, _S284.y_14, _S285);
    var _S287 : f32 = f32(_S275);
    var _S288 : f32 = _S287 * 0.75487768650054932f;
    var _S289 : vec3<f32> = sample_diffuse_0(_S284.normal_0, _S277.diffuse_blend_0, vec2<f32>(fract_of_0(_S288), fract_of_0(_S287 * 0.56984031200408936f)));
    var bits_0 : u32 = select(u32(0), u32(1), _S284.is_warp_1);
    var bits_1 : u32;
    if((dot(_S289, _S284.normal_0)) <= 0.0f)
    {
        bits_1 = (bits_0 | (((u32(4) | (select(u32(0), u32(8), _S284.is_warp_1))))));
    }
    else
    {
        bits_1 = (bits_0 | ((met_from_0(_S277, _S284.x_17, _S284.y_14, _S284.height_9, _S289, _S278))));
    }
    var _S290 : vec2<f32> = vec2<f32>(0.0f);
    var layers_0 : vec4<f32> = vec4<f32>(0.0f);
    var _S291 : f32 = families_0[_S277.warp_0].roughness_0;
    var _S292 : f32 = families_0[_S277.weft_0].roughness_0;
    var light_5 : u32 = u32(0);
    var halves_0 : vec2<f32> = _S290;
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
        var _S293 : f32 = f32(light_5);
        var _S294 : f32 = (_S293 + 0.5f) / 16.0f;
        var _S295 : vec2<f32> = sine_cosine_0(6.28318548202514648f * fract_of_0(_S293 * 0.6180340051651001f + _S288));
        var _S296 : f32 = sqrt(_S294);
        var _S297 : f32 = _S296 * _S295.y;
        var _S298 : f32 = _S296 * _S295.x;
        var _S299 : f32 = sqrt(1.0f - _S294);
        var _S300 : vec3<f32> = vec3<f32>(_S297, _S298, _S299);
        var _S301 : f32 = 3.14159274101257324f / (_S299 * 16.0f);
        var _S302 : bool;
        if((dot(_S284.normal_0, _S300)) > 0.0f)
        {
            _S302 = unoccluded_0(_S277, _S281, _S284.x_17, _S284.y_14, _S284.height_9, _S300, _S278);
        }
        else
        {
            _S302 = false;
        }
        if(_S302)
        {
            var _S303 : f32 = 2.0f * _S301 * diffuse_pdf_0(_S300, _S284.normal_0, _S277.diffuse_blend_0);
            var halves_1 : vec2<f32> = halves_0 + select_vector_0(((light_5 & (u32(1)))) == u32(0), vec2<f32>(_S303, 0.0f), vec2<f32>(0.0f, _S303));
            layers_0[i32(0)] = layers_0[i32(0)] + _S301 * reflection_0(_S300, _S280, _S284.normal_0, _S284.tangent_0, _S291, _S277.optical_depth_0);
            layers_0[i32(2)] = layers_0[i32(2)] + _S301 * reflection_0(_S300, _S280, _S284.normal_0, _S284.tangent_0, _S292, _S277.optical_depth_0);
            halves_0 = halves_1;
        }
        var _S304 : bool;
        if((dot(_S286.normal_0, _S300)) > 0.0f)
        {
            _S304 = unoccluded_0(_S277, _S281, _S284.x_17, _S284.y_14, _S286.height_9, _S300, _S285);
        }
        else
        {
            _S304 = false;
        }
        if(_S304)
        {
            var _S305 : vec3<f32> = vec3<f32>(_S297, _S298, - _S299);
            var beyond_1 : f32 = beyond_0 + _S301 * diffuse_pdf_0((vec3<f32>(0) - _S305), _S284.normal_0, _S277.diffuse_blend_0);
            layers_0[i32(1)] = layers_0[i32(1)] + _S301 * transmission_1(_S305, _S280, _S284.normal_0, _S284.tangent_0, _S291, _S277.optical_depth_0);
            layers_0[i32(3)] = layers_0[i32(3)] + _S301 * transmission_1(_S305, _S280, _S284.normal_0, _S284.tangent_0, _S292, _S277.optical_depth_0);
            beyond_0 = beyond_1;
        }
        light_5 = light_5 + u32(1);
    }
    scratch_0[_S283] = bits_1;
    scratch_0[_S283 + u32(1)] = (bitcast<u32>((_S284.normal_0.z)));
    scratch_0[_S283 + u32(2)] = (bitcast<u32>((_S284.height_9)));
    scratch_0[_S283 + u32(3)] = (bitcast<u32>((halves_0.x)));
    scratch_0[_S283 + u32(4)] = (bitcast<u32>((halves_0.y)));
    scratch_0[_S283 + u32(5)] = (bitcast<u32>((beyond_0)));
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
        scratch_0[_S283 + u32(6) + k_0] = (bitcast<u32>((layers_0[k_0])));
        k_0 = k_0 + u32(1);
    }
    return;
}

