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

@binding(15) @group(0) var<storage, read> bakes_0 : array<Bake_std430_0>;

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
};

@binding(17) @group(0) var<storage, read_write> hits_0 : array<SurfaceHit_std430_0>;

@binding(18) @group(0) var<storage, read_write> scratch_0 : array<u32>;

@binding(19) @group(0) var<storage, read_write> texel_counters_0 : array<atomic<u32>>;

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
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
    var _S5 : u32;
    if(_S4 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S5 = u32(1);
    }
    else
    {
        _S5 = u32(0);
    }
    var _S6 : u32 = min(thread_1 + _S5, u32(families_0[family_2].count_0) - u32(1));
    var _S7 : u32 = families_0[family_2].place_table_0 + _S6 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S6;
    cell_1.below_0 = _S4 - table_number_0(_S7);
    cell_1.above_0 = table_number_0(_S7 + u32(1)) - _S4;
    cell_1.across_0 = _S4 - table_number_0(_S7 + u32(2));
    cell_1.half_width_1 = table_number_0(_S7 + u32(3));
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
    var _S8 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var _S9 : bool = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S10 : bool;
    if(_S8)
    {
        if(!_S9)
        {
            _S10 = true;
        }
        else
        {
            _S10 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S10 = false;
    }
    shown_0.is_warp_0 = _S10;
    if(!_S8)
    {
        _S10 = !_S9;
    }
    else
    {
        _S10 = false;
    }
    shown_0.hole_0 = _S10;
    var _S11 : u32;
    if(shown_0.is_warp_0)
    {
        _S11 = crossing_0.warp_word_0;
    }
    else
    {
        _S11 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S11;
    shown_0.on_top_0 = (((_S11 & (u32(1)))) == u32(1)) != back_2;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_2 : Cell_0;
    var _S12 : u32;
    if(is_first_0)
    {
        _S12 = first_0.thread_0;
    }
    else
    {
        _S12 = second_0.thread_0;
    }
    cell_2.thread_0 = _S12;
    var _S13 : f32;
    if(is_first_0)
    {
        _S13 = first_0.across_0;
    }
    else
    {
        _S13 = second_0.across_0;
    }
    cell_2.across_0 = _S13;
    if(is_first_0)
    {
        _S13 = first_0.half_width_1;
    }
    else
    {
        _S13 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S13;
    if(is_first_0)
    {
        _S13 = first_0.below_0;
    }
    else
    {
        _S13 = second_0.below_0;
    }
    cell_2.below_0 = _S13;
    if(is_first_0)
    {
        _S13 = first_0.above_0;
    }
    else
    {
        _S13 = second_0.above_0;
    }
    cell_2.above_0 = _S13;
    return cell_2;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S14 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S14.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S14.y) * u32(4)));
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
    var _S15 : u32 = families_0[family_6].bend_table_0;
    var _S16 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S16 = u32(0);
    }
    else
    {
        _S16 = thread_4 * u32(4);
    }
    var _S17 : u32 = _S15 + _S16;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S17);
    bend_0.half_tangent_0 = table_number_0(_S17 + u32(1));
    bend_0.arc_0 = table_number_0(_S17 + u32(2));
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
    var _S18 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S19 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S20 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S21 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S22 : i32 = - _S18;
    var _S23 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S22, i32(0));
    run_0.from_start_0 = _S23;
    var _S24 : i32 = _S19 + i32(1);
    var _S25 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S24);
    run_0.to_end_0 = _S25;
    var _S26 : bool = _S23 < _S25;
    run_0.near_start_0 = _S26;
    var _S27 : i32;
    if(_S26)
    {
        _S27 = _S22 - _S20;
    }
    else
    {
        _S27 = _S24;
    }
    var _S28 : i32;
    if(run_0.near_start_0)
    {
        _S28 = _S22;
    }
    else
    {
        _S28 = _S24 + _S21;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    var _S29 : f32;
    if(run_0.straight_0)
    {
        _S29 = 1.0e+06f;
    }
    else
    {
        _S29 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S29;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S27, _S28), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S18 == i32(0);
    run_0.last_crossing_0 = _S19 == i32(0);
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
    var _S30 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S31 : f32 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S31;
    var _S32 : f32 = _S30 * _S30 - square_0(_S31);
    var _S33 : f32 = rsqrt_0(_S32);
    section_0.drop_0 = _S30 - _S32 * _S33;
    section_0.slope_0 = - _S31 * _S33;
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
    var _S34 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S35 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S36 : f32;
    if(_S34)
    {
        _S36 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S36 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S37 : f32 = _S36 - crossed_1.half_width_1;
    var _S38 : bool;
    if(_S34)
    {
        _S38 = run_1.first_crossing_0;
    }
    else
    {
        _S38 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S36 = 0.0f;
    }
    else
    {
        _S36 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S39 : f32;
    if((shown_1.on_top_0) != _S38)
    {
        _S39 = 0.0f;
    }
    else
    {
        var _S40 : f32 = families_0[other_1].height_scale_0;
        var _S41 : i32;
        if(_S34)
        {
            _S41 = i32(-1);
        }
        else
        {
            _S41 = i32(1);
        }
        _S39 = _S40 * edge_drop_0(other_1, crossed_1.thread_0, _S41);
    }
    var _S42 : f32 = 1.0f / max(2.0f * _S37, 9.999999960041972e-13f);
    var _S43 : f32 = clamp((_S37 - _S35) * _S42, 0.0f, 1.0f);
    var _S44 : f32 = _S36 + (_S39 - _S36) * (_S43 * _S43 * (3.0f - 2.0f * _S43));
    var _S45 : f32 = (_S36 - _S39) * (6.0f * _S43 * (1.0f - _S43) * _S42);
    if(_S34)
    {
        _S36 = 1.0f;
    }
    else
    {
        _S36 = -1.0f;
    }
    return vec2<f32>(_S44, _S45 * _S36);
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S46 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S47 : f32 = rsqrt_0(_S46);
    var _S48 : f32 = sine_1 * _S47 * rsqrt_0(_S46 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S48 * _S46, _S48 * across_slope_0 * along_slope_0 + cosine_0 * _S47);
}

fn arc_sine_0( x_3 : f32) -> f32
{
    var _S49 : f32 = abs(x_3);
    var _S50 : bool = _S49 > 0.5f;
    var _S51 : f32;
    if(_S50)
    {
        _S51 = 0.5f * (1.0f - _S49);
    }
    else
    {
        _S51 = _S49 * _S49;
    }
    var _S52 : f32;
    if(_S50)
    {
        _S52 = sqrt(max(_S51, 0.0f));
    }
    else
    {
        _S52 = _S49;
    }
    var _S53 : f32 = ((((0.04216320067644119f * _S51 + 0.02418131195008755f) * _S51 + 0.04547002539038658f) * _S51 + 0.07495300471782684f) * _S51 + 0.16666752099990845f) * _S51 * _S52 + _S52;
    if(_S50)
    {
        _S51 = 1.57079637050628662f - 2.0f * _S53;
    }
    else
    {
        _S51 = _S53;
    }
    if(x_3 < 0.0f)
    {
        _S51 = - _S51;
    }
    return _S51;
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
};

fn hit_of_0( point_0 : SurfacePoint_0,  x_4 : f32,  y_1 : f32) -> SurfaceHit_0
{
    var hit_0 : SurfaceHit_0;
    hit_0.x_0 = x_4;
    hit_0.y_0 = y_1;
    var _S54 : u32;
    if(point_0.is_warp_1)
    {
        _S54 = u32(1);
    }
    else
    {
        _S54 = u32(0);
    }
    var _S55 : u32;
    if(point_0.hole_1)
    {
        _S55 = u32(2);
    }
    else
    {
        _S55 = u32(0);
    }
    hit_0.flags_0 = (_S54 | (_S55));
    hit_0.normal_x_0 = point_0.normal_0.x;
    hit_0.normal_y_0 = point_0.normal_0.y;
    hit_0.normal_z_0 = point_0.normal_0.z;
    hit_0.tangent_x_0 = point_0.tangent_0.x;
    hit_0.tangent_y_0 = point_0.tangent_0.y;
    hit_0.tangent_z_0 = point_0.tangent_0.z;
    return hit_0;
}

fn sample_position_0( _S56 : i32,  _S57 : u32,  _S58 : u32) -> vec2<f32>
{
    return vec2<f32>((floor(fraction_of_0(_S57 * u32(2700274806) + u32(1350137403) + _S58 * u32(3152041523)) * bakes_0[_S56].ends_0) + fraction_of_0(_S57 * u32(3679390609) + u32(1839695304) + _S58 * u32(2313257605))) * bakes_0[_S56].spacing_x_0, (floor(fraction_of_0(_S57 * u32(2313257605) + u32(1156628802) + _S58 * u32(3679390609)) * bakes_0[_S56].picks_0) + fraction_of_0(_S57 * u32(3152041523) + u32(1576020761) + _S58 * u32(2700274806))) * bakes_0[_S56].spacing_y_0);
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

fn crossing_at_0( _S59 : u32,  _S60 : f32,  _S61 : f32,  _S62 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S59].warp_0, _S60);
    crossing_2.weft_1 = locate_0(fabrics_0[_S59].weft_0, _S61);
    var _S63 : u32 = fabrics_0[_S59].run_words_0 + u32(2) * (crossing_2.weft_1.thread_0 * fabrics_0[_S59].ends_2 + crossing_2.warp_1.thread_0);
    var _S64 : u32 = words_0[_S63];
    crossing_2.warp_word_0 = _S64;
    crossing_2.weft_word_0 = words_0[_S63 + u32(1)];
    crossing_2.warp_above_0 = (((_S64 & (u32(1)))) == u32(1)) != _S62;
    return crossing_2;
}

fn sample_at_0( _S65 : u32,  _S66 : f32,  _S67 : f32,  _S68 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S69 : Crossing_0 = crossing_at_0(_S65, _S66, _S67, _S68);
    sample_0.crossing_1 = _S69;
    var _S70 : Shown_0 = shown_at_0(_S69, _S68);
    sample_0.shown_2 = _S70;
    var _S71 : u32;
    if(_S70.is_warp_0)
    {
        _S71 = fabrics_0[_S65].warp_0;
    }
    else
    {
        _S71 = fabrics_0[_S65].weft_0;
    }
    var _S72 : u32;
    if(_S70.is_warp_0)
    {
        _S72 = fabrics_0[_S65].weft_0;
    }
    else
    {
        _S72 = fabrics_0[_S65].warp_0;
    }
    var _S73 : Cell_0 = select_cell_0(_S70.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S74 : Cell_0 = select_cell_0(_S70.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S75 : Run_0 = unpack_0(_S71, _S72, _S73.thread_0, _S74, _S70.word_0);
    var _S76 : Section_0 = section_at_0(_S73);
    var _S77 : bool;
    if(_S70.on_top_0)
    {
        _S77 = (_S75.distance_0) < (_S76.drop_0 * _S75.bend_1.sine_0);
    }
    else
    {
        _S77 = false;
    }
    var _S78 : bool;
    if(_S70.on_top_0)
    {
        _S78 = !_S77;
    }
    else
    {
        _S78 = false;
    }
    var _S79 : f32;
    if(_S78)
    {
        _S79 = 1.0f;
    }
    else
    {
        _S79 = -1.0f;
    }
    var _S80 : f32;
    if(_S77)
    {
        _S80 = _S75.other_reach_0;
    }
    else
    {
        _S80 = _S75.reach_0;
    }
    var _S81 : f32;
    if(_S77)
    {
        _S81 = _S80 + _S75.distance_0;
    }
    else
    {
        _S81 = max(_S80 - _S75.distance_0, 0.0f);
    }
    var _S82 : f32 = _S80 / _S75.bend_1.sine_0 - _S79 * _S76.drop_0;
    var _S83 : f32 = _S81 * _S81;
    var _S84 : f32 = max(_S82 * _S82 - _S83, 9.99999968265522539e-21f);
    var _S85 : f32 = rsqrt_0(_S84);
    var _S86 : f32 = _S83 / (_S84 * _S85 + _S82);
    var _S87 : bool = _S81 > 0.0f;
    var _S88 : f32;
    if(_S70.on_top_0)
    {
        _S88 = 1.0f;
    }
    else
    {
        _S88 = -1.0f;
    }
    var _S89 : f32;
    if(_S75.near_start_0)
    {
        _S89 = 1.0f;
    }
    else
    {
        _S89 = -1.0f;
    }
    var _S90 : f32 = _S88 * _S89;
    if(_S87)
    {
        _S88 = _S82 * _S85;
    }
    else
    {
        _S88 = 1.0f;
    }
    sample_0.slope_across_0 = _S76.slope_0 * _S88;
    if(_S87)
    {
        _S81 = _S90 * _S81 * _S85;
    }
    else
    {
        _S81 = 0.0f;
    }
    sample_0.slope_along_0 = _S81;
    var _S91 : f32 = families_0[_S71].height_scale_0;
    var _S92 : vec2<f32> = dive_0(_S72, _S70, _S75, _S74);
    if(_S75.straight_0)
    {
        _S79 = 0.0f;
    }
    else
    {
        _S79 = _S91 * _S79;
    }
    sample_0.height_2 = _S79 * (_S80 * _S75.bend_1.half_tangent_0 - _S86) - _S91 * _S76.drop_0 - _S92.x;
    var _S93 : f32 = _S91 * sample_0.slope_across_0;
    var _S94 : f32 = _S91 * sample_0.slope_along_0 - _S92.y;
    if(_S70.is_warp_0)
    {
        _S79 = _S93;
    }
    else
    {
        _S79 = _S94;
    }
    sample_0.slope_x_0 = _S79;
    if(_S70.is_warp_0)
    {
        _S79 = _S94;
    }
    else
    {
        _S79 = _S93;
    }
    sample_0.slope_y_0 = _S79;
    sample_0.run_2 = _S75;
    sample_0.section_1 = _S76;
    return sample_0;
}

fn surface_at_0( _S95 : u32,  _S96 : f32,  _S97 : f32,  _S98 : bool) -> SurfacePoint_0
{
    var _S99 : Sample_0 = sample_at_0(_S95, _S96, _S97, _S98);
    var _S100 : f32;
    if(_S99.shown_2.is_warp_0)
    {
        _S100 = _S99.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S100 = _S99.crossing_1.weft_1.half_width_1;
    }
    var _S101 : u32;
    if(_S99.shown_2.is_warp_0)
    {
        _S101 = fabrics_0[_S95].warp_0;
    }
    else
    {
        _S101 = fabrics_0[_S95].weft_0;
    }
    var _S102 : f32 = families_0[_S101].twist_sine_0;
    var _S103 : f32;
    if(_S98)
    {
        _S103 = -1.0f;
    }
    else
    {
        _S103 = 1.0f;
    }
    var _S104 : f32 = _S102 * _S103;
    var _S105 : f32 = families_0[_S101].twist_cosine_0;
    if(_S99.shown_2.is_warp_0)
    {
        _S103 = 1.0f;
    }
    else
    {
        _S103 = -1.0f;
    }
    var _S106 : vec2<f32> = fibre_direction_0(_S99.slope_across_0, _S103 * _S99.slope_along_0, _S104, _S105);
    var _S107 : f32;
    if(_S99.shown_2.is_warp_0)
    {
        _S107 = _S99.slope_x_0;
    }
    else
    {
        _S107 = _S99.slope_y_0;
    }
    var _S108 : f32;
    if(_S99.shown_2.is_warp_0)
    {
        _S108 = _S99.slope_y_0;
    }
    else
    {
        _S108 = _S99.slope_x_0;
    }
    var _S109 : f32 = _S106.x;
    var _S110 : f32 = _S106.y;
    var _S111 : f32 = _S107 * _S109 + _S103 * _S108 * _S110;
    var _S112 : f32 = _S100 * 1.0154266357421875f;
    var _S113 : f32 = _S112 * arc_sine_0(clamp(_S99.section_1.across_1 / _S112, -1.0f, 1.0f));
    if(_S99.shown_2.is_warp_0)
    {
        _S100 = _S97;
    }
    else
    {
        _S100 = - _S96;
    }
    var point_1 : SurfacePoint_0;
    point_1.hole_1 = _S99.shown_2.hole_0;
    point_1.is_warp_1 = _S99.shown_2.is_warp_0;
    point_1.warp_thread_0 = _S99.crossing_1.warp_1.thread_0;
    point_1.weft_thread_0 = _S99.crossing_1.weft_1.thread_0;
    point_1.height_1 = _S99.height_2;
    point_1.normal_0 = normalize(vec3<f32>(- _S99.slope_x_0, - _S99.slope_y_0, 1.0f));
    var _S114 : vec3<f32>;
    if(_S99.shown_2.is_warp_0)
    {
        _S114 = vec3<f32>(_S109, _S110, _S111);
    }
    else
    {
        _S114 = vec3<f32>(- _S110, _S109, _S111);
    }
    point_1.tangent_0 = normalize(_S114);
    point_1.across_2 = _S99.section_1.across_1;
    point_1.fibre_across_0 = _S113 * _S105 + _S100 * _S104;
    point_1.fibre_along_0 = _S100 * _S105 - _S113 * _S104;
    return point_1;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_top_down(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S115 : u32 = thread_index_0(id_1);
    if(_S115 >= u32(16384))
    {
        return;
    }
    var _S116 : vec2<f32> = sample_position_0(i32(0), (_S115 & (u32(8191))), u32(0));
    var _S117 : f32 = _S116.x;
    var _S118 : f32 = _S116.y;
    var _S119 : SurfaceHit_0 = hit_of_0(surface_at_0(bakes_0[i32(0)].fabric_0, _S117, _S118, _S115 >= u32(8192)), _S117, _S118);
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].x_0 = _S119.x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].y_0 = _S119.y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].flags_0 = _S119.flags_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].normal_x_0 = _S119.normal_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].normal_y_0 = _S119.normal_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].normal_z_0 = _S119.normal_z_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].tangent_x_0 = _S119.tangent_x_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].tangent_y_0 = _S119.tangent_y_0;
    hits_0[u32(512) * bakes_0[i32(0)].rays_0 + _S115].tangent_z_0 = _S119.tangent_z_0;
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
    var _S120 : f32 = floor(x_5 * 0.63661974668502808f + 0.5f);
    var _S121 : f32 = x_5 - _S120 * 1.5703125f - _S120 * 0.00048375129699707f - _S120 * 7.54979012640433211e-08f;
    var _S122 : f32 = _S121 * _S121;
    var _S123 : f32 = ((-0.00019515295571182f * _S122 + 0.00833216123282909f) * _S122 - 0.16666655242443085f) * _S122 * _S121 + _S121;
    var _S124 : f32 = ((0.00002443315679557f * _S122 - 0.00138873164542019f) * _S122 + 0.04166664555668831f) * _S122 * _S122 - 0.5f * _S122 + 1.0f;
    var _S125 : u32 = (u32(i32(_S120)) & (u32(3)));
    var _S126 : vec2<f32>;
    if(((_S125 & (u32(1)))) != u32(0))
    {
        _S126 = vec2<f32>(_S124, _S123);
    }
    else
    {
        _S126 = vec2<f32>(_S123, _S124);
    }
    var _S127 : f32;
    if(((_S125 & (u32(2)))) != u32(0))
    {
        _S127 = - _S126.x;
    }
    else
    {
        _S127 = _S126.x;
    }
    var _S128 : f32;
    if((((_S125 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S128 = - _S126.y;
    }
    else
    {
        _S128 = _S126.y;
    }
    return vec2<f32>(_S127, _S128);
}

fn node_direction_0( node_0 : u32) -> vec3<f32>
{
    var _S129 : u32 = node_0 % u32(8);
    var _S130 : vec2<f32> = sine_cosine_0(f32(node_0 / u32(8)) * 0.19634954631328583f);
    var _S131 : f32 = sqrt(1.0f - RING_COSINES_0[_S129] * RING_COSINES_0[_S129]);
    return vec3<f32>(_S131 * _S130.y, _S131 * _S130.x, RING_COSINES_0[_S129]);
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
    var _S132 : f32 = direction_0.x;
    control_0.per_x_0 = 1.0f / max(abs(_S132), 9.99999971718068537e-10f);
    var _S133 : f32 = direction_0.y;
    control_0.per_y_0 = 1.0f / max(abs(_S133), 9.99999971718068537e-10f);
    control_0.right_0 = _S132 > 0.0f;
    control_0.up_0 = _S133 > 0.0f;
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
    var _S134 : f32;
    if(forwards_0)
    {
        _S134 = cell_4.across_0;
    }
    else
    {
        _S134 = - cell_4.across_0;
    }
    var _S135 : f32;
    if(forwards_0)
    {
        _S135 = cell_4.above_0;
    }
    else
    {
        _S135 = cell_4.below_0;
    }
    var _S136 : bool;
    if(forwards_0)
    {
        _S136 = run_3.last_crossing_0;
    }
    else
    {
        _S136 = run_3.first_crossing_0;
    }
    var _S137 : bool;
    if(forwards_0)
    {
        _S137 = run_3.first_crossing_0;
    }
    else
    {
        _S137 = run_3.last_crossing_0;
    }
    var _S138 : f32 = - cell_4.half_width_1;
    var _S139 : bool = _S134 < _S138;
    var _S140 : bool = _S134 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S136 = !_S136;
    }
    else
    {
        _S136 = false;
    }
    if(_S136)
    {
        _S136 = !shown_3.hole_0;
    }
    else
    {
        _S136 = false;
    }
    var _S141 : bool;
    if(_S136)
    {
        _S141 = shown_3.on_top_0;
    }
    else
    {
        _S141 = false;
    }
    if(_S141)
    {
        if(_S137)
        {
            _S137 = _S139;
        }
        else
        {
            _S137 = false;
        }
        _S137 = !_S137;
    }
    else
    {
        _S137 = false;
    }
    if(shown_3.hole_0)
    {
        _S136 = true;
    }
    else
    {
        if(_S136)
        {
            _S136 = !shown_3.on_top_0;
        }
        else
        {
            _S136 = false;
        }
    }
    var _S142 : f32;
    if(_S139)
    {
        _S142 = _S138;
    }
    else
    {
        _S142 = cell_4.half_width_1;
    }
    var _S143 : f32 = _S142 - _S134;
    if(_S136)
    {
        _S134 = 2.0f * _S135 + _S134 - cell_4.half_width_1;
    }
    else
    {
        _S134 = _S135;
    }
    if(_S137)
    {
        if(forwards_0)
        {
            _S134 = run_3.to_end_0;
        }
        else
        {
            _S134 = run_3.from_start_0;
        }
        return _S134;
    }
    if(_S140)
    {
    }
    else
    {
        _S134 = _S143;
    }
    return _S134;
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
    var _S144 : f32 = previous_1.rate_0 * step_4;
    var _S145 : f32 = rate_1 * step_4;
    var _S146 : bool;
    if(!previous_1.known_0)
    {
        _S146 = true;
    }
    else
    {
        _S146 = here_1.hole_2;
    }
    if(_S146)
    {
        _S146 = true;
    }
    else
    {
        _S146 = (previous_1.yarn_0) != (here_1.yarn_1);
    }
    if(_S146)
    {
        _S146 = true;
    }
    else
    {
        _S146 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S146)
    {
        _S146 = true;
    }
    else
    {
        _S146 = rate_1 <= 0.0f;
    }
    if(_S146)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S144) >= 0.0f)
    {
        _S146 = (3.0f * clearance_1 - _S145) >= 0.0f;
    }
    else
    {
        _S146 = false;
    }
    if(_S146)
    {
        return -1.0f;
    }
    var _S147 : f32 = clearance_1 - previous_1.clearance_0;
    var _S148 : f32 = 6.0f * _S147 - 4.0f * _S144 - 2.0f * _S145;
    var _S149 : f32 = -2.0f * _S144 / max(_S148 + sqrt(max(_S148 * _S148 - 4.0f * (3.0f * (_S144 + _S145 - 2.0f * _S147)) * _S144, 0.0f)), 9.99999968265522539e-21f);
    var _S150 : f32 = 1.0f - _S149;
    var _S151 : f32 = (previous_1.clearance_0 * (2.0f * _S149 + 1.0f) + _S144 * _S149) * _S150 * _S150;
    var _S152 : f32 = (clearance_1 * (2.0f * _S150 + 1.0f) - _S145 * _S150) * _S149 * _S149;
    if(_S149 > 0.01999999955296516f)
    {
        _S146 = _S150 > 0.01999999955296516f;
    }
    else
    {
        _S146 = false;
    }
    if(_S146)
    {
        _S146 = (_S151 + _S152) < 0.0f;
    }
    else
    {
        _S146 = false;
    }
    var _S153 : f32;
    if(_S146)
    {
        _S153 = _S150 * step_4;
    }
    else
    {
        _S153 = -1.0f;
    }
    return _S153;
}

fn StepControl_to_next_sample_0( this_3 : StepControl_0,  here_2 : Probe_0,  clearance_2 : f32,  rate_2 : f32) -> f32
{
    var _S154 : f32 = min(here_2.edge_x_0 * this_3.per_x_0, here_2.edge_y_0 * this_3.per_y_0);
    var _S155 : bool;
    if(!here_2.hole_2)
    {
        _S155 = (rate_2 * _S154 + clearance_2) < 0.0f;
    }
    else
    {
        _S155 = false;
    }
    if(_S155)
    {
        _S155 = _S154 > (2.0f * this_3.epsilon_0);
    }
    else
    {
        _S155 = false;
    }
    var _S156 : f32;
    if(_S155)
    {
        _S156 = _S154 - this_3.epsilon_0;
    }
    else
    {
        _S156 = max(_S154, 0.0f) + this_3.epsilon_0;
    }
    return min(this_3.step_2, _S156);
}

fn after_sample_0( clearance_3 : f32,  rate_3 : f32,  here_3 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S157 : f32;
    if(here_3.hole_2)
    {
        _S157 = 1.0e+09f;
    }
    else
    {
        _S157 = clearance_3;
    }
    previous_2.clearance_0 = _S157;
    previous_2.rate_0 = rate_3;
    previous_2.yarn_0 = here_3.yarn_1;
    var _S158 : bool;
    if(!here_3.hole_2)
    {
        _S158 = !is_cell_exit_0;
    }
    else
    {
        _S158 = false;
    }
    previous_2.known_0 = _S158;
    return previous_2;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S159 : f32 = end_0 - start_1;
    var _S160 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S159;
    var _S161 : f32 = 3.0f * _S159 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S159, 9.99999968265522539e-21f);
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
        var _S162 : f32 = clamp(share_0 - (((_S160 * share_0 + _S161) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S160 * share_0 + 2.0f * _S161) * share_0 + start_rate_0, 0.10000000149011612f * _S159 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S163 : i32 = i_0 + i32(1);
        share_0 = _S162;
        i_0 = _S163;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn lattice_position_0( _S164 : i32,  _S165 : u32,  _S166 : u32) -> vec2<f32>
{
    var _S167 : u32 = u32(4294967295) / bakes_0[_S164].rays_0;
    return vec2<f32>(fraction_of_0(_S165 * _S167 + _S166 * u32(3242174889)) * (bakes_0[_S164].ends_0 * bakes_0[_S164].spacing_x_0), fraction_of_0(_S165 * u32(2654435769) + _S166 * u32(3488053409)) * (bakes_0[_S164].picks_0 * bakes_0[_S164].spacing_y_0));
}

struct Hit_0
{
     x_6 : f32,
     y_2 : f32,
     hole_3 : bool,
     height_5 : f32,
};

fn steps_per_length_0( _S168 : u32,  _S169 : SearchQuality_0,  _S170 : vec3<f32>) -> f32
{
    return max(max(abs(_S170.x) * fabrics_0[_S168].threads_per_x_0, abs(_S170.y) * fabrics_0[_S168].threads_per_y_0) * _S169.steps_per_thread_0, abs(_S170.z) * fabrics_0[_S168].per_relief_0 * _S169.steps_per_relief_0);
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

fn max_height_along_0( _S171 : u32,  _S172 : f32,  _S173 : f32,  _S174 : f32,  _S175 : vec3<f32>,  _S176 : bool) -> f32
{
    var _S177 : u32 = locate_0(fabrics_0[_S171].warp_0, _S172).thread_0 / u32(2);
    var _S178 : u32 = locate_0(fabrics_0[_S171].weft_0, _S173).thread_0 / u32(2);
    var _S179 : f32 = _S175.x;
    var _S180 : u32;
    if(_S179 > 0.0f)
    {
        _S180 = u32(1);
    }
    else
    {
        _S180 = u32(0);
    }
    var _S181 : f32 = _S175.y;
    var _S182 : u32;
    if(_S181 > 0.0f)
    {
        _S182 = u32(2);
    }
    else
    {
        _S182 = u32(0);
    }
    var _S183 : u32 = words_0[fabrics_0[_S171].max_heights_0 + u32(4) * (_S178 * fabrics_0[_S171].max_height_columns_0 + _S177) + (_S180 + _S182)];
    var number_0 : i32;
    if(_S176)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S184 : u32 = (_S183 >> (u32(number_0)));
    var _S185 : f32 = max(abs(_S179) * fabrics_0[_S171].threads_per_x_0, abs(_S181) * fabrics_0[_S171].threads_per_y_0) / _S175.z;
    var _S186 : f32 = fabrics_0[_S171].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S171].height_high_0;
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
        if(((max_height_0 - _S174) * _S185) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S184 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S186);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_maximum_0( _S187 : u32,  _S188 : Crossing_0) -> f32
{
    var _S189 : u32;
    if(_S188.warp_above_0)
    {
        _S189 = fabrics_0[_S187].warp_0;
    }
    else
    {
        _S189 = fabrics_0[_S187].weft_0;
    }
    var _S190 : u32;
    if(_S188.warp_above_0)
    {
        _S190 = _S188.warp_word_0;
    }
    else
    {
        _S190 = _S188.weft_word_0;
    }
    return f32((_S190 >> (u32(28)))) * families_0[_S189].height_scale_0 * families_0[_S189].level_0;
}

fn cell_bounds_0( _S191 : u32,  _S192 : f32,  _S193 : f32,  _S194 : bool,  _S195 : bool,  _S196 : bool) -> vec3<f32>
{
    var _S197 : Crossing_0 = crossing_at_0(_S191, _S192, _S193, _S194);
    var _S198 : f32 = cell_maximum_0(_S191, _S197);
    var _S199 : f32;
    if(_S195)
    {
        _S199 = _S197.warp_1.above_0;
    }
    else
    {
        _S199 = _S197.warp_1.below_0;
    }
    var _S200 : f32;
    if(_S196)
    {
        _S200 = _S197.weft_1.above_0;
    }
    else
    {
        _S200 = _S197.weft_1.below_0;
    }
    return vec3<f32>(_S198, _S199, _S200);
}

fn first_sample_height_0( _S201 : u32,  _S202 : ViewRay_0,  _S203 : StepControl_0,  _S204 : bool) -> f32
{
    var _S205 : f32 = max_height_along_0(_S201, _S202.origin_0.x, _S202.origin_0.y, 0.0f, vec3<f32>(_S202.slope_1, 1.0f), _S204);
    var count_1 : u32 = u32(0);
    var height_7 : f32 = _S205;
    for(;;)
    {
        if(count_1 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S206 : vec2<f32> = ViewRay_at_0(_S202, height_7);
        var _S207 : vec3<f32> = cell_bounds_0(_S201, _S206.x, _S206.y, _S204, _S203.right_0, _S203.up_0);
        var _S208 : f32 = height_7 - _S207.x;
        var _S209 : f32 = StepControl_to_cell_exit_0(_S203, _S207.y, _S207.z);
        var height_8 : f32 = height_7 - clamp(_S208, 0.0f, _S209);
        if(_S208 <= _S209)
        {
            height_7 = height_8;
            break;
        }
        count_1 = count_1 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn probe_0( _S210 : u32,  _S211 : f32,  _S212 : f32,  _S213 : bool,  _S214 : bool,  _S215 : bool) -> Probe_0
{
    var _S216 : Sample_0 = sample_at_0(_S210, _S211, _S212, _S213);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S216.height_2;
    probe_1.hole_2 = _S216.shown_2.hole_0;
    probe_1.slope_x_1 = _S216.slope_x_0;
    probe_1.slope_y_1 = _S216.slope_y_0;
    var _S217 : u32;
    if(_S216.shown_2.is_warp_0)
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
    probe_1.side_x_1 = _S218;
    if(_S215)
    {
        _S218 = _S216.crossing_1.weft_1.above_0;
    }
    else
    {
        _S218 = _S216.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_1 = _S218;
    probe_1.edge_x_0 = outline_distance_0(_S216.crossing_1.warp_1, _S216.shown_2, _S216.run_2, !_S216.shown_2.is_warp_0, _S214);
    probe_1.edge_y_0 = outline_distance_0(_S216.crossing_1.weft_1, _S216.shown_2, _S216.run_2, _S216.shown_2.is_warp_0, _S215);
    return probe_1;
}

fn search_down_0( _S219 : u32,  _S220 : ViewRay_0,  _S221 : StepControl_0,  _S222 : bool) -> ViewRayEnd_0
{
    var _S223 : f32 = fabrics_0[_S219].height_low_0 - (fabrics_0[_S219].height_high_0 - fabrics_0[_S219].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S219, _S220, _S221, _S222);
    end_1.last_step_0 = _S221.epsilon_0;
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
        var _S224 : vec2<f32> = ViewRay_at_0(_S220, end_1.height_6);
        var _S225 : Probe_0 = probe_0(_S219, _S224.x, _S224.y, _S222, _S221.right_0, _S221.up_0);
        var _S226 : f32 = end_1.height_6 - _S225.height_4;
        var _S227 : f32 = ViewRay_rate_0(_S220, _S225);
        end_1.depth_0 = - _S226;
        end_1.rate_4 = _S227;
        var _S228 : bool;
        if(end_1.previous_3.known_0)
        {
            _S228 = !_S225.hole_2;
        }
        else
        {
            _S228 = false;
        }
        var _S229 : bool;
        if(_S228)
        {
            _S229 = (end_1.previous_3.yarn_0) == (_S225.yarn_1);
        }
        else
        {
            _S229 = false;
        }
        end_1.smooth_0 = _S229;
        var _S230 : bool;
        if(!_S225.hole_2)
        {
            _S230 = _S226 <= 0.0f;
        }
        else
        {
            _S230 = false;
        }
        var _S231 : bool;
        if(_S230)
        {
            _S231 = true;
        }
        else
        {
            _S231 = (end_1.height_6) <= _S223;
        }
        if(_S231)
        {
            break;
        }
        var _S232 : f32 = way_back_to_dip_0(end_1.previous_3, _S226, _S227, end_1.last_step_0, _S225);
        if(_S232 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S232;
            end_1.last_step_0 = end_1.last_step_0 - _S232;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S233 : f32 = min(StepControl_to_cell_exit_0(_S221, _S225.side_x_1, _S225.side_y_1), end_1.height_6 - _S225.cell_max_0);
        var _S234 : f32 = StepControl_to_next_sample_0(_S221, _S225, _S226, _S227);
        end_1.previous_3 = after_sample_0(_S226, _S227, _S225, _S233 > _S234);
        var _S235 : f32 = max(_S233, _S234);
        end_1.last_step_0 = _S235;
        end_1.height_6 = end_1.height_6 - _S235;
        count_2 = count_2 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S236 : u32,  _S237 : ViewRay_0,  _S238 : StepControl_0,  _S239 : bool,  _S240 : ViewRayEnd_0,  _S241 : u32) -> f32
{
    var _S242 : f32 = fabrics_0[_S236].height_high_0 - fabrics_0[_S236].height_low_0;
    var above_2 : f32 = _S240.height_6 + _S240.last_step_0;
    var above_gap_1 : f32 = clamp(_S240.previous_3.clearance_0, 0.0f, _S242);
    var under_gap_1 : f32 = clamp(_S240.depth_0, 0.0f, _S242);
    var _S243 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S240.previous_3.rate_0 * _S240.last_step_0, _S240.rate_4 * _S240.last_step_0);
    var middle_0 : f32;
    if(_S240.smooth_0)
    {
        middle_0 = above_2 - _S243 * _S240.last_step_0;
    }
    else
    {
        middle_0 = between_0(above_2, _S240.height_6, above_gap_1, under_gap_1);
    }
    var side_0 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S240.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S241)
        {
        }
        else
        {
            break;
        }
        var _S244 : vec2<f32> = ViewRay_at_0(_S237, middle_0);
        var _S245 : Probe_0 = probe_0(_S236, _S244.x, _S244.y, _S239, _S238.right_0, _S238.up_0);
        var _S246 : f32;
        if(_S245.hole_2)
        {
            _S246 = -1.0e+09f;
        }
        else
        {
            _S246 = _S245.height_4;
        }
        var _S247 : f32 = clamp(middle_0 - _S246, - _S242, _S242);
        var _S248 : f32;
        if(_S247 <= 0.0f)
        {
            if(side_0 > 0.0f)
            {
                _S248 = 0.5f * above_gap_2;
            }
            else
            {
                _S248 = above_gap_2;
            }
            var _S249 : f32 = - _S247;
            under_1 = middle_0;
            above_gap_2 = _S248;
            under_gap_2 = _S249;
            side_0 = 1.0f;
        }
        else
        {
            if(side_0 < 0.0f)
            {
                _S248 = 0.5f * under_gap_2;
            }
            else
            {
                _S248 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S247;
            under_gap_2 = _S248;
            side_0 = -1.0f;
        }
        if(_S240.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S247 / min(ViewRay_rate_0(_S237, _S245), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S240.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S250 : u32,  _S251 : SearchQuality_0,  _S252 : f32,  _S253 : f32,  _S254 : vec3<f32>,  _S255 : bool) -> Hit_0
{
    var _S256 : f32 = max(_S254.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S252, _S253);
    var _S257 : vec2<f32> = _S254.xy / vec2<f32>(_S256);
    ray_0.slope_1 = _S257;
    var _S258 : StepControl_0 = step_control_0((vec2<f32>(0) - _S257), 1.0f / max(steps_per_length_0(_S250, _S251, _S254) / _S256, 9.99999971718068537e-10f));
    var _S259 : ViewRayEnd_0 = search_down_0(_S250, ray_0, _S258, _S255);
    var hit_1 : Hit_0;
    hit_1.hole_3 = false;
    var _S260 : f32 = refined_height_0(_S250, ray_0, _S258, _S255, _S259, _S251.refinements_0);
    hit_1.height_5 = _S260;
    var _S261 : vec2<f32> = ViewRay_at_0(ray_0, _S260);
    hit_1.x_6 = _S261.x;
    hit_1.y_2 = _S261.y;
    return hit_1;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_views(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    var _S262 : u32 = thread_index_0(id_2);
    var _S263 : u32 = bakes_0[i32(0)].rays_0;
    var _S264 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    if(_S262 >= (u32(2) * _S264))
    {
        return;
    }
    var _S265 : u32 = bakes_0[i32(0)].fabric_0;
    var _S266 : bool = _S262 >= _S264;
    var _S267 : u32;
    if(_S266)
    {
        _S267 = _S262 - _S264;
    }
    else
    {
        _S267 = _S262;
    }
    var _S268 : u32 = _S267 / _S263;
    var _S269 : u32 = _S267 % _S263;
    var _S270 : vec2<f32> = lattice_position_0(i32(0), _S269, _S268);
    var _S271 : Hit_0 = first_hit_of_yarn_0(_S265, bake_quality_0(), _S270.x, _S270.y, node_direction_0(_S268), _S266);
    var hit_2 : SurfaceHit_0 = hit_of_0(surface_at_0(_S265, _S271.x_6, _S271.y_2, _S266), _S271.x_6, _S271.y_2);
    if((_S271.height_5) <= 0.0f)
    {
        _S267 = u32(4);
    }
    else
    {
        _S267 = u32(0);
    }
    hit_2.flags_0 = ((hit_2.flags_0) | (_S267));
    hits_0[_S262].x_0 = hit_2.x_0;
    hits_0[_S262].y_0 = hit_2.y_0;
    hits_0[_S262].flags_0 = hit_2.flags_0;
    hits_0[_S262].normal_x_0 = hit_2.normal_x_0;
    hits_0[_S262].normal_y_0 = hit_2.normal_y_0;
    hits_0[_S262].normal_z_0 = hit_2.normal_z_0;
    hits_0[_S262].tangent_x_0 = hit_2.tangent_x_0;
    hits_0[_S262].tangent_y_0 = hit_2.tangent_y_0;
    hits_0[_S262].tangent_z_0 = hit_2.tangent_z_0;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_gap_starts(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    var _S272 : u32 = thread_index_0(id_3);
    var _S273 : u32 = bakes_0[i32(0)].rays_0;
    var _S274 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    var _S275 : bool;
    if(_S272 >= (u32(2) * _S274))
    {
        _S275 = true;
    }
    else
    {
        _S275 = (((hits_0[_S272].flags_0) & (u32(4)))) == u32(0);
    }
    if(_S275)
    {
        return;
    }
    var _S276 : u32 = bakes_0[i32(0)].fabric_0;
    var _S277 : bool = _S272 >= _S274;
    var _S278 : u32;
    if(_S277)
    {
        _S278 = _S272 - _S274;
    }
    else
    {
        _S278 = _S272;
    }
    var _S279 : u32 = _S278 % _S273;
    var _S280 : u32 = _S278 / _S273;
    var _S281 : vec2<f32> = lattice_position_0(i32(0), _S279, _S280);
    if(!shown_at_0(crossing_at_0(_S276, _S281.x, _S281.y, _S277), _S277).hole_0)
    {
        hits_0[_S272].flags_0 = ((hits_0[_S272].flags_0) & (u32(4294967291)));
    }
    return;
}

fn scratch_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((scratch_0[index_2])));
}

fn is_free_0( _S282 : u32,  _S283 : SearchQuality_0,  _S284 : vec3<f32>,  _S285 : vec3<f32>,  _S286 : bool,  _S287 : f32) -> bool
{
    var _S288 : f32 = _S285.z;
    if(_S288 <= 0.0f)
    {
        return false;
    }
    var _S289 : f32 = 1.0f / max(_S283.shadow_share_0 * steps_per_length_0(_S282, _S283, _S285), 9.99999971718068537e-10f);
    var _S290 : StepControl_0 = step_control_0(_S285.xy, _S289);
    var previous_4 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_1 : f32 = 0.0f;
    for(;;)
    {
        var _S291 : bool;
        if(count_3 < u32(1024))
        {
            _S291 = (_S284.z + _S288 * distance_1) < _S287;
        }
        else
        {
            _S291 = false;
        }
        if(_S291)
        {
        }
        else
        {
            break;
        }
        var _S292 : vec3<f32> = _S284 + _S285 * vec3<f32>(distance_1);
        var _S293 : Probe_0 = probe_0(_S282, _S292.x, _S292.y, _S286, _S290.right_0, _S290.up_0);
        var _S294 : f32 = _S292.z;
        var _S295 : f32 = _S294 - _S293.height_4;
        var _S296 : f32 = _S288 - _S293.slope_x_1 * _S285.x - _S293.slope_y_1 * _S285.y;
        var _S297 : bool;
        if(!_S293.hole_2)
        {
            _S297 = _S295 < 0.0f;
        }
        else
        {
            _S297 = false;
        }
        if(_S297)
        {
            return false;
        }
        var _S298 : f32 = way_back_to_dip_0(previous_4, _S295, _S296, last_step_1, _S293);
        if(_S298 >= 0.0f)
        {
            var last_step_2 : f32 = last_step_1 - _S298;
            distance_1 = distance_1 - _S298;
            last_step_1 = last_step_2;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S299 : bool = _S294 > (_S293.cell_max_0);
        var _S300 : PreviousSample_0 = after_sample_0(_S295, _S296, _S293, _S299);
        var last_step_3 : f32;
        if(_S299)
        {
            last_step_3 = max(StepControl_to_cell_exit_0(_S290, _S293.side_x_1, _S293.side_y_1), _S289);
        }
        else
        {
            last_step_3 = StepControl_to_next_sample_0(_S290, _S293, _S295, _S296);
        }
        var distance_2 : f32 = distance_1 + last_step_3;
        previous_4 = _S300;
        distance_1 = distance_2;
        last_step_1 = last_step_3;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S301 : u32,  _S302 : SearchQuality_0,  _S303 : f32,  _S304 : f32,  _S305 : vec3<f32>,  _S306 : bool) -> bool
{
    if(!sample_at_0(_S301, _S303, _S304, _S306).shown_2.hole_0)
    {
        return false;
    }
    var _S307 : vec3<f32> = vec3<f32>(_S303, _S304, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        var _S308 : bool;
        if(side_1 < u32(2))
        {
            _S308 = passes_0;
        }
        else
        {
            _S308 = false;
        }
        if(_S308)
        {
        }
        else
        {
            break;
        }
        var _S309 : vec3<f32>;
        if(side_1 == u32(0))
        {
            _S309 = _S305;
        }
        else
        {
            _S309 = vec3<f32>(- _S305.x, - _S305.y, _S305.z);
        }
        var _S310 : bool = is_free_0(_S301, _S302, _S307, _S309, _S306 != (side_1 == u32(1)), fabrics_0[_S301].height_high_0);
        var _S311 : u32 = side_1 + u32(1);
        passes_0 = _S310;
        side_1 = _S311;
    }
    return passes_0;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_nulls(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    var _S312 : u32 = thread_index_0(id_4);
    var _S313 : u32 = bakes_0[i32(0)].rays_0;
    var _S314 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    var _S315 : u32 = u32(2) * _S314;
    var _S316 : bool = _S312 < _S315;
    var _S317 : u32;
    if(_S316)
    {
        _S317 = u32(0);
    }
    else
    {
        _S317 = _S312 - _S315;
    }
    var _S318 : u32 = _S317 % u32(128);
    var _S319 : bool = !_S316;
    var _S320 : bool;
    if(_S319)
    {
        if(_S317 >= u32(32768))
        {
            _S320 = true;
        }
        else
        {
            _S320 = _S318 >= scratch_0[bakes_0[i32(0)].facts_0 + u32(9)];
        }
    }
    else
    {
        _S320 = false;
    }
    if(_S320)
    {
        return;
    }
    if(_S316)
    {
        _S320 = (((hits_0[_S312].flags_0) & (u32(4)))) == u32(0);
    }
    else
    {
        _S320 = false;
    }
    if(_S320)
    {
        return;
    }
    var _S321 : u32 = bakes_0[i32(0)].fabric_0;
    if(_S316)
    {
        _S320 = _S312 >= _S314;
    }
    else
    {
        _S320 = false;
    }
    var _S322 : u32;
    if(_S320)
    {
        _S322 = _S312 - _S314;
    }
    else
    {
        _S322 = _S312;
    }
    var _S323 : u32;
    if(_S316)
    {
        var _S324 : u32 = _S322 / _S313;
        _S323 = _S324;
    }
    else
    {
        _S323 = _S317 / u32(128);
    }
    var _S325 : u32 = _S322 % _S313;
    var _S326 : vec2<f32> = lattice_position_0(i32(0), _S325, _S323);
    var place_0 : vec2<f32>;
    if(_S319)
    {
        var _S327 : u32 = bakes_0[i32(0)].gaps_0 + u32(2) * _S318;
        place_0 = vec2<f32>(scratch_number_0(_S327), scratch_number_0(_S327 + u32(1)));
    }
    else
    {
        place_0 = _S326;
    }
    var _S328 : bool = passes_through_0(_S321, bake_quality_0(), place_0.x, place_0.y, node_direction_0(_S323), _S320);
    if(_S316)
    {
        if(_S328)
        {
            _S317 = u32(8);
        }
        else
        {
            _S317 = u32(0);
        }
        hits_0[_S312].flags_0 = ((hits_0[_S312].flags_0) | (_S317));
    }
    else
    {
        scratch_0[bakes_0[i32(0)].gap_nulls_0 + _S317] = u32(_S328);
    }
    return;
}

fn start_of_shadow_ray_0( node_1 : u32,  ray_1 : u32,  rays_1 : u32) -> u32
{
    return (((node_1 * u32(37) + ray_1) & (u32(255)))) * rays_1 + ray_1;
}

fn unoccluded_0( _S329 : u32,  _S330 : SearchQuality_0,  _S331 : f32,  _S332 : f32,  _S333 : f32,  _S334 : vec3<f32>,  _S335 : bool) -> bool
{
    if((_S334.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S329, _S330, vec3<f32>(_S331, _S332, _S333 + fabrics_0[_S329].lift_0), _S334, _S335, max_height_along_0(_S329, _S331, _S332, _S333, _S334, _S335));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_shadows(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    var _S336 : u32 = thread_index_0(id_5);
    var _S337 : u32 = bakes_0[i32(0)].rays_0;
    var _S338 : u32 = u32(256) * bakes_0[i32(0)].rays_0;
    if(_S336 >= (u32(2) * _S338))
    {
        return;
    }
    var _S339 : u32 = bakes_0[i32(0)].fabric_0;
    var _S340 : bool = _S336 >= _S338;
    var side_2 : u32;
    if(_S340)
    {
        side_2 = _S336 - _S338;
    }
    else
    {
        side_2 = _S336;
    }
    var _S341 : u32 = side_2 / _S337;
    var _S342 : u32 = side_2 % _S337;
    var _S343 : u32 = start_of_shadow_ray_0(_S341, _S342, _S337);
    if(_S340)
    {
        side_2 = _S338;
    }
    else
    {
        side_2 = u32(0);
    }
    var _S344 : u32 = _S343 + side_2;
    var _S345 : f32 = hits_0[_S344].x_0;
    var _S346 : f32 = hits_0[_S344].y_0;
    var _S347 : vec3<f32> = node_direction_0(_S341);
    side_2 = u32(0);
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
        var _S348 : bool = _S340 != (side_2 == u32(1));
        var _S349 : SurfacePoint_0 = surface_at_0(_S339, _S345, _S346, _S348);
        var _S350 : bool;
        if(!_S349.hole_1)
        {
            _S350 = (dot(_S349.normal_0, _S347)) > 0.0f;
        }
        else
        {
            _S350 = false;
        }
        var _S351 : bool;
        if(_S350)
        {
            _S351 = unoccluded_0(_S339, bake_quality_0(), _S345, _S346, _S349.height_1, _S347, _S348);
        }
        else
        {
            _S351 = false;
        }
        if(_S351)
        {
            lit_1 = (lit_1 | (((u32(1) << (side_2)))));
        }
        side_2 = side_2 + u32(1);
    }
    scratch_0[bakes_0[i32(0)].lit_0 + _S336] = lit_1;
    return;
}

fn nearest_group_0( _S352 : i32,  _S353 : bool,  _S354 : bool,  _S355 : vec3<f32>,  _S356 : vec3<f32>) -> u32
{
    var _S357 : u32;
    if(_S353)
    {
        _S357 = u32(1);
    }
    else
    {
        _S357 = u32(0);
    }
    var _S358 : u32 = scratch_0[bakes_0[_S352].facts_0 + u32(14) + _S357];
    var nearest_0 : u32;
    if(_S354)
    {
        nearest_0 = u32(0);
    }
    else
    {
        nearest_0 = _S358;
    }
    var _S359 : u32;
    if(_S354)
    {
        _S359 = _S358;
    }
    else
    {
        _S359 = u32(2) * bakes_0[_S352].per_family_0;
    }
    var least_0 : f32 = 1000.0f;
    var group_0 : u32 = nearest_0;
    for(;;)
    {
        if(group_0 < _S359)
        {
        }
        else
        {
            break;
        }
        var _S360 : u32 = bakes_0[_S352].centroids_0 + (_S357 * u32(2) * bakes_0[_S352].per_family_0 + group_0) * u32(6);
        var _S361 : vec3<f32> = vec3<f32>(0.5f) * _S355 - vec3<f32>(scratch_number_0(_S360), scratch_number_0(_S360 + u32(1)), scratch_number_0(_S360 + u32(2)));
        var _S362 : vec3<f32> = _S356 - vec3<f32>(scratch_number_0(_S360 + u32(3)), scratch_number_0(_S360 + u32(4)), scratch_number_0(_S360 + u32(5)));
        var _S363 : f32 = dot(_S361, _S361) + dot(_S362, _S362);
        if(_S363 < least_0)
        {
            nearest_0 = group_0;
        }
        var _S364 : f32 = min(least_0, _S363);
        var _S365 : u32 = group_0 + u32(1);
        least_0 = _S364;
        group_0 = _S365;
    }
    return nearest_0;
}

fn byte_of_group_0( _S366 : i32,  _S367 : u32) -> u32
{
    var _S368 : u32 = bakes_0[_S366].per_family_0;
    var _S369 : u32;
    if(_S367 < (bakes_0[_S366].per_family_0))
    {
        _S369 = _S367;
    }
    else
    {
        _S369 = _S367 - _S368 + u32(2) * bakes_0[_S366].packs_0;
    }
    return _S369;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_texels(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    var _S370 : u32 = thread_index_0(id_6);
    var _S371 : u32 = bakes_0[i32(0)].columns_0;
    var _S372 : u32 = bakes_0[i32(0)].texels_across_0;
    var _S373 : u32 = bakes_0[i32(0)].columns_0 * bakes_0[i32(0)].texels_across_0;
    var _S374 : u32 = bakes_0[i32(0)].rows_0;
    var _S375 : u32 = bakes_0[i32(0)].texels_along_0;
    var _S376 : u32 = _S373 * bakes_0[i32(0)].rows_0 * bakes_0[i32(0)].texels_along_0;
    if(_S370 >= (u32(2) * _S376))
    {
        return;
    }
    var _S377 : u32 = bakes_0[i32(0)].fabric_0;
    var _S378 : bool = _S370 >= _S376;
    var _S379 : u32;
    if(_S378)
    {
        _S379 = _S370 - _S376;
    }
    else
    {
        _S379 = _S370;
    }
    var _S380 : u32 = _S379 / _S373;
    var _S381 : u32 = _S379 % _S373;
    var _S382 : SurfacePoint_0 = surface_at_0(_S377, (f32(_S381) + fraction_of_0(_S379 * u32(3242174889))) * bakes_0[i32(0)].texel_x_0, (f32(_S380) + fraction_of_0(_S379 * u32(2447445413))) * bakes_0[i32(0)].texel_y_0, _S378);
    var _S383 : u32 = nearest_group_0(i32(0), _S378, _S382.is_warp_1, _S382.normal_0, _S382.tangent_0);
    if(_S382.hole_1)
    {
        _S379 = u32(4) * bakes_0[i32(0)].packs_0;
    }
    else
    {
        _S379 = byte_of_group_0(i32(0), _S383);
    }
    var _S384 : u32 = _S380 / _S375;
    var _S385 : u32 = _S384 * _S371;
    var _S386 : u32 = _S381 / _S372;
    var _S387 : u32 = _S385 + _S386;
    var _S388 : u32;
    if(_S378)
    {
        _S388 = _S371 * _S374;
    }
    else
    {
        _S388 = u32(0);
    }
    var _S389 : u32 = atomicAdd(&(texel_counters_0[(_S387 + _S388) * (bakes_0[i32(0)].packs_0 + u32(1)) + _S379 / u32(4)]), (u32(1) << ((u32(8) * (_S379 % u32(4))))));
    return;
}

