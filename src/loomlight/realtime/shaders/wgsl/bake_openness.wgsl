@binding(16) @group(0) var<storage, read> steps_0 : array<u32>;

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

@binding(18) @group(0) var<storage, read_write> scratch_0 : array<u32>;

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
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
    var _S46 : f32 = direction_0.x;
    control_0.per_x_0 = 1.0f / max(abs(_S46), 9.99999971718068537e-10f);
    var _S47 : f32 = direction_0.y;
    control_0.per_y_0 = 1.0f / max(abs(_S47), 9.99999971718068537e-10f);
    control_0.right_0 = _S46 > 0.0f;
    control_0.up_0 = _S47 > 0.0f;
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
    var _S48 : f32;
    if(forwards_0)
    {
        _S48 = cell_4.across_0;
    }
    else
    {
        _S48 = - cell_4.across_0;
    }
    var _S49 : f32;
    if(forwards_0)
    {
        _S49 = cell_4.above_0;
    }
    else
    {
        _S49 = cell_4.below_0;
    }
    var _S50 : bool;
    if(forwards_0)
    {
        _S50 = run_2.last_crossing_0;
    }
    else
    {
        _S50 = run_2.first_crossing_0;
    }
    var _S51 : bool;
    if(forwards_0)
    {
        _S51 = run_2.first_crossing_0;
    }
    else
    {
        _S51 = run_2.last_crossing_0;
    }
    var _S52 : f32 = - cell_4.half_width_1;
    var _S53 : bool = _S48 < _S52;
    var _S54 : bool = _S48 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S50 = !_S50;
    }
    else
    {
        _S50 = false;
    }
    if(_S50)
    {
        _S50 = !shown_2.hole_0;
    }
    else
    {
        _S50 = false;
    }
    var _S55 : bool;
    if(_S50)
    {
        _S55 = shown_2.on_top_0;
    }
    else
    {
        _S55 = false;
    }
    if(_S55)
    {
        if(_S51)
        {
            _S51 = _S53;
        }
        else
        {
            _S51 = false;
        }
        _S51 = !_S51;
    }
    else
    {
        _S51 = false;
    }
    if(shown_2.hole_0)
    {
        _S50 = true;
    }
    else
    {
        if(_S50)
        {
            _S50 = !shown_2.on_top_0;
        }
        else
        {
            _S50 = false;
        }
    }
    var _S56 : f32;
    if(_S53)
    {
        _S56 = _S52;
    }
    else
    {
        _S56 = cell_4.half_width_1;
    }
    var _S57 : f32 = _S56 - _S48;
    if(_S50)
    {
        _S48 = 2.0f * _S49 + _S48 - cell_4.half_width_1;
    }
    else
    {
        _S48 = _S49;
    }
    if(_S51)
    {
        if(forwards_0)
        {
            _S48 = run_2.to_end_0;
        }
        else
        {
            _S48 = run_2.from_start_0;
        }
        return _S48;
    }
    if(_S54)
    {
    }
    else
    {
        _S48 = _S57;
    }
    return _S48;
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
    var _S58 : f32 = previous_1.rate_0 * step_4;
    var _S59 : f32 = rate_1 * step_4;
    var _S60 : bool;
    if(!previous_1.known_0)
    {
        _S60 = true;
    }
    else
    {
        _S60 = here_0.hole_1;
    }
    if(_S60)
    {
        _S60 = true;
    }
    else
    {
        _S60 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S60)
    {
        _S60 = true;
    }
    else
    {
        _S60 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S60)
    {
        _S60 = true;
    }
    else
    {
        _S60 = rate_1 <= 0.0f;
    }
    if(_S60)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S58) >= 0.0f)
    {
        _S60 = (3.0f * clearance_1 - _S59) >= 0.0f;
    }
    else
    {
        _S60 = false;
    }
    if(_S60)
    {
        return -1.0f;
    }
    var _S61 : f32 = clearance_1 - previous_1.clearance_0;
    var _S62 : f32 = 6.0f * _S61 - 4.0f * _S58 - 2.0f * _S59;
    var _S63 : f32 = -2.0f * _S58 / max(_S62 + sqrt(max(_S62 * _S62 - 4.0f * (3.0f * (_S58 + _S59 - 2.0f * _S61)) * _S58, 0.0f)), 9.99999968265522539e-21f);
    var _S64 : f32 = 1.0f - _S63;
    var _S65 : f32 = (previous_1.clearance_0 * (2.0f * _S63 + 1.0f) + _S58 * _S63) * _S64 * _S64;
    var _S66 : f32 = (clearance_1 * (2.0f * _S64 + 1.0f) - _S59 * _S64) * _S63 * _S63;
    if(_S63 > 0.01999999955296516f)
    {
        _S60 = _S64 > 0.01999999955296516f;
    }
    else
    {
        _S60 = false;
    }
    if(_S60)
    {
        _S60 = (_S65 + _S66) < 0.0f;
    }
    else
    {
        _S60 = false;
    }
    var _S67 : f32;
    if(_S60)
    {
        _S67 = _S64 * step_4;
    }
    else
    {
        _S67 = -1.0f;
    }
    return _S67;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S68 : f32;
    if(here_1.hole_1)
    {
        _S68 = 1.0e+09f;
    }
    else
    {
        _S68 = clearance_2;
    }
    previous_2.clearance_0 = _S68;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S69 : bool;
    if(!here_1.hole_1)
    {
        _S69 = !is_cell_exit_0;
    }
    else
    {
        _S69 = false;
    }
    previous_2.known_0 = _S69;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_0 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

fn StepControl_to_next_sample_0( this_1 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S70 : f32 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    var _S71 : bool;
    if(!here_2.hole_1)
    {
        _S71 = (rate_3 * _S70 + clearance_3) < 0.0f;
    }
    else
    {
        _S71 = false;
    }
    if(_S71)
    {
        _S71 = _S70 > (2.0f * this_1.epsilon_0);
    }
    else
    {
        _S71 = false;
    }
    var _S72 : f32;
    if(_S71)
    {
        _S72 = _S70 - this_1.epsilon_0;
    }
    else
    {
        _S72 = max(_S70, 0.0f) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S72);
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
    var _S73 : f32 = end_0 - start_1;
    var _S74 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S73;
    var _S75 : f32 = 3.0f * _S73 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S73, 9.99999968265522539e-21f);
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
        var _S76 : f32 = clamp(share_0 - (((_S74 * share_0 + _S75) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S74 * share_0 + 2.0f * _S75) * share_0 + start_rate_0, 0.10000000149011612f * _S73 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S77 : i32 = i_0 + i32(1);
        share_0 = _S76;
        i_0 = _S77;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S78 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S79 : f32 = rsqrt_0(_S78);
    var _S80 : f32 = sine_1 * _S79 * rsqrt_0(_S78 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S80 * _S78, _S80 * across_slope_0 * along_slope_0 + cosine_0 * _S79);
}

fn arc_sine_0( x_2 : f32) -> f32
{
    var _S81 : f32 = abs(x_2);
    var _S82 : bool = _S81 > 0.5f;
    var _S83 : f32;
    if(_S82)
    {
        _S83 = 0.5f * (1.0f - _S81);
    }
    else
    {
        _S83 = _S81 * _S81;
    }
    var _S84 : f32;
    if(_S82)
    {
        _S84 = sqrt(max(_S83, 0.0f));
    }
    else
    {
        _S84 = _S81;
    }
    var _S85 : f32 = ((((0.04216320067644119f * _S83 + 0.02418131195008755f) * _S83 + 0.04547002539038658f) * _S83 + 0.07495300471782684f) * _S83 + 0.16666752099990845f) * _S83 * _S84 + _S84;
    if(_S82)
    {
        _S83 = 1.57079637050628662f - 2.0f * _S85;
    }
    else
    {
        _S83 = _S85;
    }
    if(x_2 < 0.0f)
    {
        _S83 = - _S83;
    }
    return _S83;
}

fn fract_of_0( number_1 : f32) -> f32
{
    return number_1 - floor(number_1);
}

fn sine_cosine_0( x_3 : f32) -> vec2<f32>
{
    var _S86 : f32 = floor(x_3 * 0.63661974668502808f + 0.5f);
    var _S87 : f32 = x_3 - _S86 * 1.5703125f - _S86 * 0.00048375129699707f - _S86 * 7.54979012640433211e-08f;
    var _S88 : f32 = _S87 * _S87;
    var _S89 : f32 = ((-0.00019515295571182f * _S88 + 0.00833216123282909f) * _S88 - 0.16666655242443085f) * _S88 * _S87 + _S87;
    var _S90 : f32 = ((0.00002443315679557f * _S88 - 0.00138873164542019f) * _S88 + 0.04166664555668831f) * _S88 * _S88 - 0.5f * _S88 + 1.0f;
    var _S91 : u32 = (u32(i32(_S86)) & (u32(3)));
    var _S92 : vec2<f32>;
    if(((_S91 & (u32(1)))) != u32(0))
    {
        _S92 = vec2<f32>(_S90, _S89);
    }
    else
    {
        _S92 = vec2<f32>(_S89, _S90);
    }
    var _S93 : f32;
    if(((_S91 & (u32(2)))) != u32(0))
    {
        _S93 = - _S92.x;
    }
    else
    {
        _S93 = _S92.x;
    }
    var _S94 : f32;
    if((((_S91 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S94 = - _S92.y;
    }
    else
    {
        _S94 = _S92.y;
    }
    return vec2<f32>(_S93, _S94);
}

fn uniform_on_sphere_0( u_0 : vec2<f32>) -> vec3<f32>
{
    var _S95 : f32 = u_0.x;
    var _S96 : f32 = 2.0f * sqrt(max(_S95 * (1.0f - _S95), 0.0f));
    var _S97 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_0.y);
    return vec3<f32>(_S96 * _S97.y, _S96 * _S97.x, 1.0f - 2.0f * _S95);
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
    var _S98 : f32 = u_2.x;
    var _S99 : bool = _S98 < blend_0;
    var _S100 : f32;
    if(_S99)
    {
        _S100 = 0.0f;
    }
    else
    {
        _S100 = blend_0;
    }
    var _S101 : f32;
    if(_S99)
    {
        _S101 = blend_0;
    }
    else
    {
        _S101 = 1.0f - blend_0;
    }
    var _S102 : f32 = min((_S98 - _S100) / max(_S101, 1.00000001168609742e-07f), 0.99999994039535522f);
    var _S103 : vec3<f32>;
    if(_S99)
    {
        _S103 = normal_0;
    }
    else
    {
        _S103 = vec3<f32>(0.0f, 0.0f, 1.0f);
    }
    return cosine_about_0(_S103, vec2<f32>(_S102, u_2.y));
}

fn diffuse_pdf_0( light_1 : vec3<f32>,  normal_1 : vec3<f32>,  blend_1 : f32) -> f32
{
    return 0.31830987334251404f * mix(max(light_1.z, 0.0f), max(dot(light_1, normal_1), 0.0f), blend_1);
}

fn projected_area_1( direction_1 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S104 : f32 = dot(direction_1, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S104 * _S104 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_4 : f32) -> f32
{
    var _S105 : f32 = clamp(x_4, -87.0f, 88.0f);
    var _S106 : f32 = floor(_S105 * 1.4426950216293335f + 0.5f);
    var _S107 : f32 = _S105 - _S106 * 0.693359375f + _S106 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S107 + 0.00139819993637502f) * _S107 + 0.00833345204591751f) * _S107 + 0.04166579619050026f) * _S107 + 0.1666666567325592f) * _S107 + 0.5f;
    var _S108 : f32 = (bitcast<f32>(((u32(i32(_S106) + i32(127)) << (u32(23))))));
    var _S109 : f32;
    if(x_4 < -87.0f)
    {
        _S109 = 0.0f;
    }
    else
    {
        _S109 = (p_0 * _S107 * _S107 + _S107 + 1.0f) * _S108;
    }
    return _S109;
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
    var _S110 : f32 = roughness_2 * roughness_2;
    var _S111 : f32 = squared_along_0 * (1.0f - _S110) + _S110;
    return 0.31830987334251404f * _S110 * roughness_2 / (_S111 * _S111);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_1 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S112 : vec3<f32> = light_2 + view_1;
    var _S113 : f32 = dot(_S112, tangent_1);
    return flake_density_0(min(_S113 * _S113 / max(square_1(_S112), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_2 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S114 : f32 = dot(light_3, normal_2);
    var _S115 : bool;
    if(_S114 <= 0.0f)
    {
        _S115 = true;
    }
    else
    {
        _S115 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S115)
    {
        return 0.0f;
    }
    var _S116 : f32 = max(_S114, 9.99999997475242708e-07f);
    var _S117 : f32 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    var _S118 : f32 = projected_area_1(light_3, tangent_2, roughness_4) * _S117 + projected_area_1(view_2, tangent_2, roughness_4) * _S116;
    var _S119 : f32 = optical_depth_1 * _S118 / (_S116 * _S117);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S119 * mean_attenuation_0(_S119)) * _S116 / _S118;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_3 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S120 : f32 = - dot(light_4, normal_3);
    var _S121 : f32 = dot(view_3, normal_3);
    var _S122 : bool;
    if(_S120 <= 0.0f)
    {
        _S122 = true;
    }
    else
    {
        _S122 = _S121 <= 0.0f;
    }
    if(_S122)
    {
        return 0.0f;
    }
    var _S123 : f32 = 1.0f / max(_S121, 9.99999997475242708e-07f);
    var _S124 : f32 = projected_area_1(light_4, tangent_3, roughness_5) / max(_S120, 9.99999997475242708e-07f);
    var _S125 : f32 = projected_area_1(view_3, tangent_3, roughness_5) * _S123;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S124, _S125)) * mean_attenuation_0(optical_depth_2 * abs(_S124 - _S125)) * _S123;
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
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S126 : u32,  _S127 : f32,  _S128 : f32,  _S129 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S126].warp_0, _S127);
    crossing_2.weft_1 = locate_0(fabrics_0[_S126].weft_0, _S128);
    var _S130 : u32 = fabrics_0[_S126].run_words_0 + u32(2) * (crossing_2.weft_1.thread_0 * fabrics_0[_S126].ends_1 + crossing_2.warp_1.thread_0);
    var _S131 : u32 = words_0[_S130];
    crossing_2.warp_word_0 = _S131;
    crossing_2.weft_word_0 = words_0[_S130 + u32(1)];
    crossing_2.warp_above_0 = (((_S131 & (u32(1)))) == u32(1)) != _S129;
    return crossing_2;
}

fn sample_at_0( _S132 : u32,  _S133 : f32,  _S134 : f32,  _S135 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S136 : Crossing_0 = crossing_at_0(_S132, _S133, _S134, _S135);
    sample_0.crossing_1 = _S136;
    var _S137 : Shown_0 = shown_at_0(_S136, _S135);
    sample_0.shown_3 = _S137;
    var _S138 : u32;
    if(_S137.is_warp_0)
    {
        _S138 = fabrics_0[_S132].warp_0;
    }
    else
    {
        _S138 = fabrics_0[_S132].weft_0;
    }
    var _S139 : u32;
    if(_S137.is_warp_0)
    {
        _S139 = fabrics_0[_S132].weft_0;
    }
    else
    {
        _S139 = fabrics_0[_S132].warp_0;
    }
    var _S140 : Cell_0 = select_cell_0(_S137.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S141 : Cell_0 = select_cell_0(_S137.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S142 : Run_0 = unpack_0(_S138, _S139, _S140.thread_0, _S141, _S137.word_0);
    var _S143 : Section_0 = section_at_0(_S140);
    var _S144 : bool;
    if(_S137.on_top_0)
    {
        _S144 = (_S142.distance_0) < (_S143.drop_0 * _S142.bend_1.sine_0);
    }
    else
    {
        _S144 = false;
    }
    var _S145 : bool;
    if(_S137.on_top_0)
    {
        _S145 = !_S144;
    }
    else
    {
        _S145 = false;
    }
    var _S146 : f32;
    if(_S145)
    {
        _S146 = 1.0f;
    }
    else
    {
        _S146 = -1.0f;
    }
    var _S147 : f32;
    if(_S144)
    {
        _S147 = _S142.other_reach_0;
    }
    else
    {
        _S147 = _S142.reach_0;
    }
    var _S148 : f32;
    if(_S144)
    {
        _S148 = _S147 + _S142.distance_0;
    }
    else
    {
        _S148 = max(_S147 - _S142.distance_0, 0.0f);
    }
    var _S149 : f32 = _S147 / _S142.bend_1.sine_0 - _S146 * _S143.drop_0;
    var _S150 : f32 = _S148 * _S148;
    var _S151 : f32 = max(_S149 * _S149 - _S150, 9.99999968265522539e-21f);
    var _S152 : f32 = rsqrt_0(_S151);
    var _S153 : f32 = _S150 / (_S151 * _S152 + _S149);
    var _S154 : bool = _S148 > 0.0f;
    var _S155 : f32;
    if(_S137.on_top_0)
    {
        _S155 = 1.0f;
    }
    else
    {
        _S155 = -1.0f;
    }
    var _S156 : f32;
    if(_S142.near_start_0)
    {
        _S156 = 1.0f;
    }
    else
    {
        _S156 = -1.0f;
    }
    var _S157 : f32 = _S155 * _S156;
    if(_S154)
    {
        _S155 = _S149 * _S152;
    }
    else
    {
        _S155 = 1.0f;
    }
    sample_0.slope_across_0 = _S143.slope_0 * _S155;
    if(_S154)
    {
        _S148 = _S157 * _S148 * _S152;
    }
    else
    {
        _S148 = 0.0f;
    }
    sample_0.slope_along_0 = _S148;
    var _S158 : f32 = families_0[_S138].height_scale_0;
    var _S159 : vec2<f32> = dive_0(_S139, _S137, _S142, _S141);
    if(_S142.straight_0)
    {
        _S146 = 0.0f;
    }
    else
    {
        _S146 = _S158 * _S146;
    }
    sample_0.height_4 = _S146 * (_S147 * _S142.bend_1.half_tangent_0 - _S153) - _S158 * _S143.drop_0 - _S159.x;
    var _S160 : f32 = _S158 * sample_0.slope_across_0;
    var _S161 : f32 = _S158 * sample_0.slope_along_0 - _S159.y;
    if(_S137.is_warp_0)
    {
        _S146 = _S160;
    }
    else
    {
        _S146 = _S161;
    }
    sample_0.slope_x_1 = _S146;
    if(_S137.is_warp_0)
    {
        _S146 = _S161;
    }
    else
    {
        _S146 = _S160;
    }
    sample_0.slope_y_1 = _S146;
    sample_0.run_3 = _S142;
    sample_0.section_1 = _S143;
    return sample_0;
}

fn steps_per_length_0( _S162 : u32,  _S163 : SearchQuality_0,  _S164 : vec3<f32>) -> f32
{
    return max(max(abs(_S164.x) * fabrics_0[_S162].threads_per_x_0, abs(_S164.y) * fabrics_0[_S162].threads_per_y_0) * _S163.steps_per_thread_0, abs(_S164.z) * fabrics_0[_S162].per_relief_0 * _S163.steps_per_relief_0);
}

fn cell_maximum_0( _S165 : u32,  _S166 : Crossing_0) -> f32
{
    var _S167 : u32;
    if(_S166.warp_above_0)
    {
        _S167 = fabrics_0[_S165].warp_0;
    }
    else
    {
        _S167 = fabrics_0[_S165].weft_0;
    }
    var _S168 : u32;
    if(_S166.warp_above_0)
    {
        _S168 = _S166.warp_word_0;
    }
    else
    {
        _S168 = _S166.weft_word_0;
    }
    return f32((_S168 >> (u32(28)))) * families_0[_S167].height_scale_0 * families_0[_S167].level_0;
}

fn probe_0( _S169 : u32,  _S170 : f32,  _S171 : f32,  _S172 : bool,  _S173 : bool,  _S174 : bool) -> Probe_0
{
    var _S175 : Sample_0 = sample_at_0(_S169, _S170, _S171, _S172);
    var probe_1 : Probe_0;
    probe_1.height_1 = _S175.height_4;
    probe_1.hole_1 = _S175.shown_3.hole_0;
    probe_1.slope_x_0 = _S175.slope_x_1;
    probe_1.slope_y_0 = _S175.slope_y_1;
    var _S176 : u32;
    if(_S175.shown_3.is_warp_0)
    {
        _S176 = _S175.crossing_1.warp_1.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S176 = _S175.crossing_1.weft_1.thread_0 * u32(2);
    }
    probe_1.yarn_1 = _S176;
    probe_1.cell_max_0 = cell_maximum_0(_S169, _S175.crossing_1);
    var _S177 : f32;
    if(_S173)
    {
        _S177 = _S175.crossing_1.warp_1.above_0;
    }
    else
    {
        _S177 = _S175.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S177;
    if(_S174)
    {
        _S177 = _S175.crossing_1.weft_1.above_0;
    }
    else
    {
        _S177 = _S175.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S177;
    probe_1.edge_x_0 = outline_distance_0(_S175.crossing_1.warp_1, _S175.shown_3, _S175.run_3, !_S175.shown_3.is_warp_0, _S173);
    probe_1.edge_y_0 = outline_distance_0(_S175.crossing_1.weft_1, _S175.shown_3, _S175.run_3, _S175.shown_3.is_warp_0, _S174);
    return probe_1;
}

fn is_free_0( _S178 : u32,  _S179 : SearchQuality_0,  _S180 : vec3<f32>,  _S181 : vec3<f32>,  _S182 : bool,  _S183 : f32) -> bool
{
    var _S184 : f32 = _S181.z;
    if(_S184 <= 0.0f)
    {
        return false;
    }
    var _S185 : f32 = 1.0f / max(_S179.shadow_share_0 * steps_per_length_0(_S178, _S179, _S181), 9.99999971718068537e-10f);
    var _S186 : StepControl_0 = step_control_0(_S181.xy, _S185);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_1 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S187 : bool;
        if(count_1 < u32(1024))
        {
            _S187 = (_S180.z + _S184 * distance_1) < _S183;
        }
        else
        {
            _S187 = false;
        }
        if(_S187)
        {
        }
        else
        {
            break;
        }
        var _S188 : vec3<f32> = _S180 + _S181 * vec3<f32>(distance_1);
        var _S189 : Probe_0 = probe_0(_S178, _S188.x, _S188.y, _S182, _S186.right_0, _S186.up_0);
        var _S190 : f32 = _S188.z;
        var _S191 : f32 = _S190 - _S189.height_1;
        var _S192 : f32 = _S184 - _S189.slope_x_0 * _S181.x - _S189.slope_y_0 * _S181.y;
        var _S193 : bool;
        if(!_S189.hole_1)
        {
            _S193 = _S191 < 0.0f;
        }
        else
        {
            _S193 = false;
        }
        if(_S193)
        {
            return false;
        }
        var _S194 : f32 = way_back_to_dip_0(previous_3, _S191, _S192, last_step_0, _S189);
        if(_S194 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S194;
            distance_1 = distance_1 - _S194;
            last_step_0 = last_step_1;
            count_1 = count_1 + u32(1);
            continue;
        }
        var _S195 : bool = _S190 > (_S189.cell_max_0);
        var _S196 : PreviousSample_0 = after_sample_0(_S191, _S192, _S189, _S195);
        var last_step_2 : f32;
        if(_S195)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S186, _S189.side_x_0, _S189.side_y_0), _S185);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S186, _S189, _S191, _S192);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S196;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + u32(1);
    }
    return true;
}

fn passes_through_0( _S197 : u32,  _S198 : SearchQuality_0,  _S199 : f32,  _S200 : f32,  _S201 : vec3<f32>,  _S202 : bool) -> bool
{
    if(!sample_at_0(_S197, _S199, _S200, _S202).shown_3.hole_0)
    {
        return false;
    }
    var _S203 : vec3<f32> = vec3<f32>(_S199, _S200, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S204 : bool;
        if(side_0 < u32(2))
        {
            _S204 = passes_0;
        }
        else
        {
            _S204 = false;
        }
        if(_S204)
        {
        }
        else
        {
            break;
        }
        var _S205 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S205 = _S201;
        }
        else
        {
            _S205 = vec3<f32>(- _S201.x, - _S201.y, _S201.z);
        }
        var _S206 : bool = is_free_0(_S197, _S198, _S203, _S205, _S202 != (side_0 == u32(1)), fabrics_0[_S197].height_high_0);
        var _S207 : u32 = side_0 + u32(1);
        passes_0 = _S206;
        side_0 = _S207;
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

fn max_height_along_0( _S208 : u32,  _S209 : f32,  _S210 : f32,  _S211 : f32,  _S212 : vec3<f32>,  _S213 : bool) -> f32
{
    var _S214 : u32 = locate_0(fabrics_0[_S208].warp_0, _S209).thread_0 / u32(2);
    var _S215 : u32 = locate_0(fabrics_0[_S208].weft_0, _S210).thread_0 / u32(2);
    var _S216 : f32 = _S212.x;
    var _S217 : u32;
    if(_S216 > 0.0f)
    {
        _S217 = u32(1);
    }
    else
    {
        _S217 = u32(0);
    }
    var _S218 : f32 = _S212.y;
    var _S219 : u32;
    if(_S218 > 0.0f)
    {
        _S219 = u32(2);
    }
    else
    {
        _S219 = u32(0);
    }
    var _S220 : u32 = words_0[fabrics_0[_S208].max_heights_0 + u32(4) * (_S215 * fabrics_0[_S208].max_height_columns_0 + _S214) + (_S217 + _S219)];
    var number_2 : i32;
    if(_S213)
    {
        number_2 = i32(4);
    }
    else
    {
        number_2 = i32(0);
    }
    var _S221 : u32 = (_S220 >> (u32(number_2)));
    var _S222 : f32 = max(abs(_S216) * fabrics_0[_S208].threads_per_x_0, abs(_S218) * fabrics_0[_S208].threads_per_y_0) / _S212.z;
    var _S223 : f32 = fabrics_0[_S208].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S208].height_high_0;
    number_2 = i32(3);
    for(;;)
    {
        if(number_2 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S211) * _S222) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, f32((((_S221 >> (u32(i32(8) * number_2)))) & (u32(15)))) * 0.06666667014360428f * _S223);
        }
        number_2 = number_2 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S224 : u32,  _S225 : f32,  _S226 : f32,  _S227 : bool,  _S228 : bool,  _S229 : bool) -> vec3<f32>
{
    var _S230 : Crossing_0 = crossing_at_0(_S224, _S225, _S226, _S227);
    var _S231 : f32 = cell_maximum_0(_S224, _S230);
    var _S232 : f32;
    if(_S228)
    {
        _S232 = _S230.warp_1.above_0;
    }
    else
    {
        _S232 = _S230.warp_1.below_0;
    }
    var _S233 : f32;
    if(_S229)
    {
        _S233 = _S230.weft_1.above_0;
    }
    else
    {
        _S233 = _S230.weft_1.below_0;
    }
    return vec3<f32>(_S231, _S232, _S233);
}

fn first_sample_height_0( _S234 : u32,  _S235 : ViewRay_0,  _S236 : StepControl_0,  _S237 : bool) -> f32
{
    var _S238 : f32 = max_height_along_0(_S234, _S235.origin_0.x, _S235.origin_0.y, 0.0f, vec3<f32>(_S235.slope_1, 1.0f), _S237);
    var count_2 : u32 = u32(0);
    var height_6 : f32 = _S238;
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S239 : vec2<f32> = ViewRay_at_0(_S235, height_6);
        var _S240 : vec3<f32> = cell_bounds_0(_S234, _S239.x, _S239.y, _S237, _S236.right_0, _S236.up_0);
        var _S241 : f32 = height_6 - _S240.x;
        var _S242 : f32 = StepControl_to_cell_exit_0(_S236, _S240.y, _S240.z);
        var height_7 : f32 = height_6 - clamp(_S241, 0.0f, _S242);
        if(_S241 <= _S242)
        {
            height_6 = height_7;
            break;
        }
        count_2 = count_2 + u32(1);
        height_6 = height_7;
    }
    return height_6;
}

fn search_down_0( _S243 : u32,  _S244 : ViewRay_0,  _S245 : StepControl_0,  _S246 : bool) -> ViewRayEnd_0
{
    var _S247 : f32 = fabrics_0[_S243].height_low_0 - (fabrics_0[_S243].height_high_0 - fabrics_0[_S243].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_5 = first_sample_height_0(_S243, _S244, _S245, _S246);
    end_1.last_step_3 = _S245.epsilon_0;
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
        var _S248 : vec2<f32> = ViewRay_at_0(_S244, end_1.height_5);
        var _S249 : Probe_0 = probe_0(_S243, _S248.x, _S248.y, _S246, _S245.right_0, _S245.up_0);
        var _S250 : f32 = end_1.height_5 - _S249.height_1;
        var _S251 : f32 = ViewRay_rate_0(_S244, _S249);
        end_1.depth_1 = - _S250;
        end_1.rate_4 = _S251;
        var _S252 : bool;
        if(end_1.previous_4.known_0)
        {
            _S252 = !_S249.hole_1;
        }
        else
        {
            _S252 = false;
        }
        var _S253 : bool;
        if(_S252)
        {
            _S253 = (end_1.previous_4.yarn_0) == (_S249.yarn_1);
        }
        else
        {
            _S253 = false;
        }
        end_1.smooth_0 = _S253;
        var _S254 : bool;
        if(!_S249.hole_1)
        {
            _S254 = _S250 <= 0.0f;
        }
        else
        {
            _S254 = false;
        }
        var _S255 : bool;
        if(_S254)
        {
            _S255 = true;
        }
        else
        {
            _S255 = (end_1.height_5) <= _S247;
        }
        if(_S255)
        {
            break;
        }
        var _S256 : f32 = way_back_to_dip_0(end_1.previous_4, _S250, _S251, end_1.last_step_3, _S249);
        if(_S256 >= 0.0f)
        {
            end_1.height_5 = end_1.height_5 + _S256;
            end_1.last_step_3 = end_1.last_step_3 - _S256;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S257 : f32 = min(StepControl_to_cell_exit_0(_S245, _S249.side_x_0, _S249.side_y_0), end_1.height_5 - _S249.cell_max_0);
        var _S258 : f32 = StepControl_to_next_sample_0(_S245, _S249, _S250, _S251);
        end_1.previous_4 = after_sample_0(_S250, _S251, _S249, _S257 > _S258);
        var _S259 : f32 = max(_S257, _S258);
        end_1.last_step_3 = _S259;
        end_1.height_5 = end_1.height_5 - _S259;
        count_3 = count_3 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S260 : u32,  _S261 : ViewRay_0,  _S262 : StepControl_0,  _S263 : bool,  _S264 : ViewRayEnd_0,  _S265 : u32) -> f32
{
    var _S266 : f32 = fabrics_0[_S260].height_high_0 - fabrics_0[_S260].height_low_0;
    var above_2 : f32 = _S264.height_5 + _S264.last_step_3;
    var above_gap_1 : f32 = clamp(_S264.previous_4.clearance_0, 0.0f, _S266);
    var under_gap_1 : f32 = clamp(_S264.depth_1, 0.0f, _S266);
    var _S267 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S264.previous_4.rate_0 * _S264.last_step_3, _S264.rate_4 * _S264.last_step_3);
    var middle_0 : f32;
    if(_S264.smooth_0)
    {
        middle_0 = above_2 - _S267 * _S264.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S264.height_5, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S264.height_5;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S265)
        {
        }
        else
        {
            break;
        }
        var _S268 : vec2<f32> = ViewRay_at_0(_S261, middle_0);
        var _S269 : Probe_0 = probe_0(_S260, _S268.x, _S268.y, _S263, _S262.right_0, _S262.up_0);
        var _S270 : f32;
        if(_S269.hole_1)
        {
            _S270 = -1.0e+09f;
        }
        else
        {
            _S270 = _S269.height_1;
        }
        var _S271 : f32 = clamp(middle_0 - _S270, - _S266, _S266);
        var _S272 : f32;
        if(_S271 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S272 = 0.5f * above_gap_2;
            }
            else
            {
                _S272 = above_gap_2;
            }
            var _S273 : f32 = - _S271;
            under_1 = middle_0;
            above_gap_2 = _S272;
            under_gap_2 = _S273;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S272 = 0.5f * under_gap_2;
            }
            else
            {
                _S272 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S271;
            under_gap_2 = _S272;
            side_1 = -1.0f;
        }
        if(_S264.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S271 / min(ViewRay_rate_0(_S261, _S269), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S264.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S274 : u32,  _S275 : SearchQuality_0,  _S276 : f32,  _S277 : f32,  _S278 : vec3<f32>,  _S279 : bool) -> Hit_0
{
    var _S280 : f32 = max(_S278.z, 0.00009999999747379f);
    var ray_1 : ViewRay_0;
    ray_1.origin_0 = vec2<f32>(_S276, _S277);
    var _S281 : vec2<f32> = _S278.xy / vec2<f32>(_S280);
    ray_1.slope_1 = _S281;
    var _S282 : StepControl_0 = step_control_0((vec2<f32>(0) - _S281), 1.0f / max(steps_per_length_0(_S274, _S275, _S278) / _S280, 9.99999971718068537e-10f));
    var _S283 : ViewRayEnd_0 = search_down_0(_S274, ray_1, _S282, _S279);
    var hit_0 : Hit_0;
    hit_0.hole_2 = false;
    var _S284 : f32 = refined_height_0(_S274, ray_1, _S282, _S279, _S283, _S275.refinements_0);
    hit_0.height_3 = _S284;
    var _S285 : vec2<f32> = ViewRay_at_0(ray_1, _S284);
    hit_0.x_5 = _S285.x;
    hit_0.y_0 = _S285.y;
    return hit_0;
}

fn first_hit_0( _S286 : u32,  _S287 : SearchQuality_0,  _S288 : f32,  _S289 : f32,  _S290 : vec3<f32>,  _S291 : bool) -> Hit_0
{
    if(!passes_through_0(_S286, _S287, _S288, _S289, _S290, _S291))
    {
        return first_hit_of_yarn_0(_S286, _S287, _S288, _S289, _S290, _S291);
    }
    var hit_1 : Hit_0;
    hit_1.x_5 = _S288;
    hit_1.y_0 = _S289;
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
};

fn surface_at_0( _S292 : u32,  _S293 : f32,  _S294 : f32,  _S295 : bool) -> SurfacePoint_0
{
    var _S296 : Sample_0 = sample_at_0(_S292, _S293, _S294, _S295);
    var _S297 : f32;
    if(_S296.shown_3.is_warp_0)
    {
        _S297 = _S296.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S297 = _S296.crossing_1.weft_1.half_width_1;
    }
    var _S298 : u32;
    if(_S296.shown_3.is_warp_0)
    {
        _S298 = fabrics_0[_S292].warp_0;
    }
    else
    {
        _S298 = fabrics_0[_S292].weft_0;
    }
    var _S299 : f32 = families_0[_S298].twist_sine_0;
    var _S300 : f32;
    if(_S295)
    {
        _S300 = -1.0f;
    }
    else
    {
        _S300 = 1.0f;
    }
    var _S301 : f32 = _S299 * _S300;
    var _S302 : f32 = families_0[_S298].twist_cosine_0;
    if(_S296.shown_3.is_warp_0)
    {
        _S300 = 1.0f;
    }
    else
    {
        _S300 = -1.0f;
    }
    var _S303 : vec2<f32> = fibre_direction_0(_S296.slope_across_0, _S300 * _S296.slope_along_0, _S301, _S302);
    var _S304 : f32;
    if(_S296.shown_3.is_warp_0)
    {
        _S304 = _S296.slope_x_1;
    }
    else
    {
        _S304 = _S296.slope_y_1;
    }
    var _S305 : f32;
    if(_S296.shown_3.is_warp_0)
    {
        _S305 = _S296.slope_y_1;
    }
    else
    {
        _S305 = _S296.slope_x_1;
    }
    var _S306 : f32 = _S303.x;
    var _S307 : f32 = _S303.y;
    var _S308 : f32 = _S304 * _S306 + _S300 * _S305 * _S307;
    var _S309 : f32 = _S297 * 1.0154266357421875f;
    var _S310 : f32 = _S309 * arc_sine_0(clamp(_S296.section_1.across_1 / _S309, -1.0f, 1.0f));
    if(_S296.shown_3.is_warp_0)
    {
        _S297 = _S294;
    }
    else
    {
        _S297 = - _S293;
    }
    var point_0 : SurfacePoint_0;
    point_0.hole_3 = _S296.shown_3.hole_0;
    point_0.is_warp_1 = _S296.shown_3.is_warp_0;
    point_0.warp_thread_0 = _S296.crossing_1.warp_1.thread_0;
    point_0.weft_thread_0 = _S296.crossing_1.weft_1.thread_0;
    point_0.height_8 = _S296.height_4;
    point_0.normal_4 = normalize(vec3<f32>(- _S296.slope_x_1, - _S296.slope_y_1, 1.0f));
    var _S311 : vec3<f32>;
    if(_S296.shown_3.is_warp_0)
    {
        _S311 = vec3<f32>(_S306, _S307, _S308);
    }
    else
    {
        _S311 = vec3<f32>(- _S307, _S306, _S308);
    }
    point_0.tangent_4 = normalize(_S311);
    point_0.across_2 = _S296.section_1.across_1;
    point_0.fibre_across_0 = _S310 * _S302 + _S297 * _S301;
    point_0.fibre_along_0 = _S297 * _S302 - _S310 * _S301;
    return point_0;
}

fn met_from_0( _S312 : u32,  _S313 : f32,  _S314 : f32,  _S315 : f32,  _S316 : vec3<f32>,  _S317 : bool) -> u32
{
    var _S318 : f32 = fabrics_0[_S312].height_high_0;
    var _S319 : f32 = fabrics_0[_S312].height_low_0;
    var _S320 : f32 = max(fabrics_0[_S312].height_high_0 - fabrics_0[_S312].height_low_0, 9.99999997475242708e-07f);
    var _S321 : f32 = _S316.x;
    var _S322 : f32 = _S316.y;
    var _S323 : f32 = min(min(1.0f / fabrics_0[_S312].threads_per_x_0, 1.0f / fabrics_0[_S312].threads_per_y_0) / 16.0f / max(sqrt(_S321 * _S321 + _S322 * _S322), 9.99999997475242708e-07f), _S320 / 16.0f / max(abs(_S316.z), 9.99999997475242708e-07f));
    var _S324 : vec3<f32> = vec3<f32>(_S313, _S314, _S315 + fabrics_0[_S312].lift_0);
    var count_4 : u32 = u32(0);
    var place_0 : vec3<f32> = _S324;
    for(;;)
    {
        if(count_4 < u32(2048))
        {
        }
        else
        {
            break;
        }
        var place_1 : vec3<f32> = place_0 + _S316 * vec3<f32>(_S323);
        var _S325 : Sample_0 = sample_at_0(_S312, place_1.x, place_1.y, _S317);
        var _S326 : bool;
        if(!_S325.shown_3.hole_0)
        {
            _S326 = (place_1.z) < (_S325.height_4);
        }
        else
        {
            _S326 = false;
        }
        if(_S326)
        {
            if(_S325.shown_3.is_warp_0)
            {
                count_4 = u32(8);
            }
            else
            {
                count_4 = u32(0);
            }
            return (u32(4) | (count_4));
        }
        var _S327 : f32 = place_1.z;
        var _S328 : bool;
        if(_S327 > _S318)
        {
            _S328 = true;
        }
        else
        {
            _S328 = _S327 < (_S319 - _S320);
        }
        if(_S328)
        {
            break;
        }
        count_4 = count_4 + u32(1);
        place_0 = place_1;
    }
    return u32(0);
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
fn bake_openness(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S336 : u32 = thread_index_0(id_1);
    var _S337 : u32 = steps_0[i32(1)];
    if(_S336 >= (u32(2) * _S337))
    {
        return;
    }
    var _S338 : u32 = steps_0[i32(0)];
    var _S339 : bool = _S336 >= _S337;
    var k_0 : u32;
    if(_S339)
    {
        k_0 = _S336 - _S337;
    }
    else
    {
        k_0 = _S336;
    }
    var _S340 : vec3<f32> = vec3<f32>(ray_number_0(k_0, u32(2)), ray_number_0(k_0, u32(3)), ray_number_0(k_0, u32(4)));
    var _S341 : SearchQuality_0 = openness_quality_0();
    var _S342 : Hit_0 = first_hit_0(_S338, _S341, ray_number_0(k_0, u32(0)), ray_number_0(k_0, u32(1)), _S340, _S339);
    var _S343 : u32 = _S336 * u32(10);
    k_0 = u32(0);
    for(;;)
    {
        if(k_0 < u32(10))
        {
        }
        else
        {
            break;
        }
        scratch_0[_S343 + k_0] = u32(0);
        k_0 = k_0 + u32(1);
    }
    if(_S342.hole_2)
    {
        scratch_0[_S343] = u32(2);
        return;
    }
    var _S344 : SurfacePoint_0 = surface_at_0(_S338, _S342.x_5, _S342.y_0, _S339);
    var _S345 : bool = !_S339;
    var _S346 : SurfacePoint_0 = surface_at_0(_S338, _S342.x_5, _S342.y_0, _S345);
    var _S347 : f32 = fabrics_0[_S338].diffuse_blend_0;
    var _S348 : f32 = f32(_S336);
    var _S349 : f32 = _S348 * 0.75487768650054932f;
    var _S350 : vec3<f32> = sample_diffuse_0(_S344.normal_4, fabrics_0[_S338].diffuse_blend_0, vec2<f32>(fract_of_0(_S349), fract_of_0(_S348 * 0.56984031200408936f)));
    var bits_0 : u32;
    if(_S344.is_warp_1)
    {
        bits_0 = u32(1);
    }
    else
    {
        bits_0 = u32(0);
    }
    if((dot(_S350, _S344.normal_4)) <= 0.0f)
    {
        if(_S344.is_warp_1)
        {
            k_0 = u32(8);
        }
        else
        {
            k_0 = u32(0);
        }
        bits_0 = (bits_0 | (((u32(4) | (k_0)))));
    }
    else
    {
        bits_0 = (bits_0 | ((met_from_0(_S338, _S342.x_5, _S342.y_0, _S344.height_8, _S350, _S339))));
    }
    var _S351 : vec2<f32> = vec2<f32>(0.0f);
    var layers_0 : vec4<f32> = vec4<f32>(0.0f);
    var _S352 : f32 = families_0[fabrics_0[_S338].warp_0].roughness_0;
    var _S353 : f32 = families_0[fabrics_0[_S338].weft_0].roughness_0;
    var light_5 : u32 = u32(0);
    var halves_0 : vec2<f32> = _S351;
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
        var _S354 : f32 = f32(light_5);
        var _S355 : f32 = (_S354 + 0.5f) / 16.0f;
        var _S356 : vec2<f32> = sine_cosine_0(6.28318548202514648f * fract_of_0(_S354 * 0.6180340051651001f + _S349));
        var _S357 : f32 = sqrt(_S355);
        var _S358 : f32 = _S357 * _S356.y;
        var _S359 : f32 = _S357 * _S356.x;
        var _S360 : f32 = sqrt(1.0f - _S355);
        var _S361 : vec3<f32> = vec3<f32>(_S358, _S359, _S360);
        var _S362 : f32 = 3.14159274101257324f / (_S360 * 16.0f);
        var _S363 : bool;
        if((dot(_S344.normal_4, _S361)) > 0.0f)
        {
            _S363 = unoccluded_0(_S338, _S341, _S342.x_5, _S342.y_0, _S344.height_8, _S361, _S339);
        }
        else
        {
            _S363 = false;
        }
        if(_S363)
        {
            var _S364 : f32 = 2.0f * _S362 * diffuse_pdf_0(_S361, _S344.normal_4, _S347);
            var _S365 : vec2<f32>;
            if(((light_5 & (u32(1)))) == u32(0))
            {
                _S365 = vec2<f32>(_S364, 0.0f);
            }
            else
            {
                _S365 = vec2<f32>(0.0f, _S364);
            }
            var halves_1 : vec2<f32> = halves_0 + _S365;
            layers_0[i32(0)] = layers_0[i32(0)] + _S362 * reflection_0(_S361, _S340, _S344.normal_4, _S344.tangent_4, _S352, fabrics_0[_S338].optical_depth_0);
            layers_0[i32(2)] = layers_0[i32(2)] + _S362 * reflection_0(_S361, _S340, _S344.normal_4, _S344.tangent_4, _S353, fabrics_0[_S338].optical_depth_0);
            halves_0 = halves_1;
        }
        var _S366 : bool;
        if((dot(_S346.normal_4, _S361)) > 0.0f)
        {
            _S366 = unoccluded_0(_S338, _S341, _S342.x_5, _S342.y_0, _S346.height_8, _S361, _S345);
        }
        else
        {
            _S366 = false;
        }
        if(_S366)
        {
            var _S367 : vec3<f32> = vec3<f32>(_S358, _S359, - _S360);
            var beyond_1 : f32 = beyond_0 + _S362 * diffuse_pdf_0((vec3<f32>(0) - _S367), _S344.normal_4, _S347);
            layers_0[i32(1)] = layers_0[i32(1)] + _S362 * transmission_1(_S367, _S340, _S344.normal_4, _S344.tangent_4, _S352, fabrics_0[_S338].optical_depth_0);
            layers_0[i32(3)] = layers_0[i32(3)] + _S362 * transmission_1(_S367, _S340, _S344.normal_4, _S344.tangent_4, _S353, fabrics_0[_S338].optical_depth_0);
            beyond_0 = beyond_1;
        }
        light_5 = light_5 + u32(1);
    }
    scratch_0[_S343] = bits_0;
    scratch_0[_S343 + u32(1)] = (bitcast<u32>((_S344.normal_4.z)));
    scratch_0[_S343 + u32(2)] = (bitcast<u32>((_S344.height_8)));
    scratch_0[_S343 + u32(3)] = (bitcast<u32>((halves_0.x)));
    scratch_0[_S343 + u32(4)] = (bitcast<u32>((halves_0.y)));
    scratch_0[_S343 + u32(5)] = (bitcast<u32>((beyond_0)));
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
        scratch_0[_S343 + u32(6) + k_0] = (bitcast<u32>((layers_0[k_0])));
        k_0 = k_0 + u32(1);
    }
    return;
}

