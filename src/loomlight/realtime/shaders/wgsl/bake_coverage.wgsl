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

@binding(12) @group(0) var<storage, read> steps_0 : array<u32>;

@binding(16) @group(0) var<storage, read> texel_counts_0 : array<u32>;

@binding(17) @group(0) var<storage, read_write> coverage_pyramid_0 : array<vec4<f32>>;

@binding(14) @group(0) var<storage, read_write> scratch_0 : array<u32>;

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

@binding(18) @group(0) var<storage, read_write> tables_0 : array<u32>;

fn thread_index_0( id_0 : vec3<u32>) -> u32
{
    return id_0.y * u32(2097152) + id_0.x;
}

struct Level_0
{
     face_0 : u32,
     first_0 : u32,
     columns_2 : u32,
     rows_2 : u32,
     below_first_0 : u32,
     below_columns_0 : u32,
     below_rows_0 : u32,
};

fn this_level_0() -> Level_0
{
    var level_0 : Level_0;
    level_0.face_0 = steps_0[i32(0)];
    level_0.first_0 = steps_0[i32(1)];
    level_0.columns_2 = steps_0[i32(2)];
    level_0.rows_2 = steps_0[i32(3)];
    level_0.below_first_0 = steps_0[i32(4)];
    level_0.below_columns_0 = steps_0[i32(5)];
    level_0.below_rows_0 = steps_0[i32(6)];
    return level_0;
}

fn bytes_of_0( word_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((word_0 & (u32(255)))), f32((((word_0 >> (u32(8)))) & (u32(255)))), f32((((word_0 >> (u32(16)))) & (u32(255)))), f32((word_0 >> (u32(24)))));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_row_totals(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S1 : u32 = thread_index_0(id_1);
    var _S2 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S3 : Level_0 = this_level_0();
    if(_S1 >= (_S3.rows_2 * _S2))
    {
        return;
    }
    var _S4 : u32 = _S1 / _S2;
    const _S5 : vec4<u32> = vec4<u32>(u32(0), u32(0), u32(0), u32(0));
    var largest_0 : vec4<f32> = vec4<f32>(0.0f, 0.0f, 0.0f, 0.0f);
    var column_0 : u32 = u32(0);
    var total_0 : vec4<u32> = _S5;
    for(;;)
    {
        if(column_0 < (_S3.columns_2))
        {
        }
        else
        {
            break;
        }
        var _S6 : u32 = (_S4 * _S3.columns_2 + column_0) * _S2;
        var _S7 : u32 = _S1 % _S2;
        var _S8 : u32 = _S6 + _S7;
        var total_1 : vec4<u32> = total_0 + vec4<u32>(bytes_of_0(texel_counts_0[_S3.face_0 * _S3.columns_2 * _S3.rows_2 * _S2 + _S8]));
        var _S9 : vec4<f32> = max(largest_0, coverage_pyramid_0[_S8]);
        var _S10 : u32 = column_0 + u32(1);
        largest_0 = _S9;
        column_0 = _S10;
        total_0 = total_1;
    }
    var i_0 : u32 = u32(0);
    for(;;)
    {
        if(i_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S11 : u32 = _S1 * u32(4);
        scratch_0[bakes_0[i32(0)].row_totals_0 + _S11 + i_0] = total_0[i_0];
        scratch_0[bakes_0[i32(0)].row_largest_0 + _S11 + i_0] = (bitcast<u32>((largest_0[i_0])));
        i_0 = i_0 + u32(1);
    }
    return;
}

fn scratch_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((scratch_0[index_0])));
}

fn square_0( x_0 : f32) -> f32
{
    return x_0 * x_0;
}

fn group_of_byte_0( _S12 : i32,  _S13 : u32,  _S14 : u32) -> u32
{
    var _S15 : u32 = u32(2) * bakes_0[_S12].packs_0;
    var _S16 : u32 = select(u32(0), u32(1), _S13 >= _S15);
    var _S17 : u32 = _S13 - _S16 * _S15;
    return select(_S14, _S16 * bakes_0[_S12].per_family_0 + _S17, ((_S17 < (bakes_0[_S12].per_family_0)) & ((_S13 < (u32(2) * _S15)))));
}

fn byte_of_group_0( _S18 : i32,  _S19 : u32) -> u32
{
    return select(_S19 - bakes_0[_S18].per_family_0 + u32(2) * bakes_0[_S18].packs_0, _S19, _S19 < (bakes_0[_S18].per_family_0));
}

fn share_of_byte_0( _S20 : i32,  _S21 : Level_0,  _S22 : u32) -> f32
{
    var _S23 : u32;
    var row_0 : u32 = u32(0);
    var total_2 : u32 = u32(0);
    for(;;)
    {
        _S23 = _S21.rows_2;
        if(row_0 < (_S21.rows_2))
        {
        }
        else
        {
            break;
        }
        var total_3 : u32 = total_2 + scratch_0[bakes_0[_S20].row_totals_0 + row_0 * u32(4) * (bakes_0[_S20].packs_0 + u32(1)) + _S22];
        row_0 = row_0 + u32(1);
        total_2 = total_3;
    }
    return f32(total_2) / (f32(_S21.columns_2 * _S23) * f32(bakes_0[_S20].texels_across_0 * bakes_0[_S20].texels_along_0));
}

fn is_hidden_0( _S24 : i32,  _S25 : Level_0,  _S26 : u32) -> bool
{
    return (share_of_byte_0(_S24, _S25, byte_of_group_0(_S24, _S26))) < (0.015625f * scratch_number_0(bakes_0[_S24].area_scales_0 + _S25.face_0 * (u32(2) * bakes_0[_S24].per_family_0 + u32(1)) + _S26));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_stand_ins(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    var _S27 : u32 = thread_index_0(id_2);
    var _S28 : Level_0 = this_level_0();
    var _S29 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    if(_S27 >= (u32(4) * _S29))
    {
        return;
    }
    var _S30 : u32 = u32(2) * bakes_0[i32(0)].per_family_0;
    var _S31 : u32 = group_of_byte_0(i32(0), _S27, _S30);
    var _S32 : u32 = _S30 - u32(1);
    var _S33 : u32 = min(_S31, _S32);
    var _S34 : u32 = scratch_0[bakes_0[i32(0)].facts_0 + u32(14) + _S28.face_0];
    var _S35 : u32 = bakes_0[i32(0)].centroids_0 + _S28.face_0 * _S30 * u32(7);
    var least_0 : f32 = select(0.0f, 1.0e+09f, is_hidden_0(i32(0), _S28, _S33));
    var nearest_0 : u32 = _S31;
    var other_0 : u32 = u32(0);
    for(;;)
    {
        if(other_0 < _S30)
        {
        }
        else
        {
            break;
        }
        var k_0 : u32 = u32(0);
        var distance_0 : f32 = 0.0f;
        for(;;)
        {
            if(k_0 < u32(7))
            {
            }
            else
            {
                break;
            }
            var distance_1 : f32 = distance_0 + square_0(scratch_number_0(_S35 + other_0 * u32(7) + k_0) - scratch_number_0(_S35 + _S33 * u32(7) + k_0));
            k_0 = k_0 + u32(1);
            distance_0 = distance_1;
        }
        var _S36 : bool = (((((other_0 < _S34) == (_S33 < _S34)) & ((distance_0 < least_0)))) & ((!is_hidden_0(i32(0), _S28, other_0))));
        var _S37 : u32 = select(nearest_0, other_0, _S36);
        var _S38 : f32 = select(least_0, distance_0, _S36);
        var _S39 : u32 = other_0 + u32(1);
        least_0 = _S38;
        nearest_0 = _S37;
        other_0 = _S39;
    }
    scratch_0[bakes_0[i32(0)].stand_ins_0 + _S28.face_0 * u32(4) * _S29 + _S27] = select(_S27, byte_of_group_0(i32(0), min(nearest_0, _S32)), _S31 < _S30);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_first_level(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    var _S40 : u32 = thread_index_0(id_3);
    var _S41 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S42 : Level_0 = this_level_0();
    if(_S40 >= (_S42.columns_2 * _S42.rows_2 * _S41))
    {
        return;
    }
    var _S43 : u32 = _S40 % _S41;
    var _S44 : u32 = _S40 / _S41;
    var _S45 : u32 = _S44 % _S42.columns_2;
    var _S46 : i32 = i32(_S45);
    var _S47 : u32 = _S40 / _S41;
    var _S48 : u32 = _S47 / _S42.columns_2;
    var _S49 : i32 = i32(_S48);
    var _S50 : i32 = i32(steps_0[i32(7)]);
    var _S51 : i32 = i32(steps_0[i32(8)]);
    var _S52 : u32 = _S42.face_0 * _S42.columns_2 * _S42.rows_2;
    const _S53 : vec4<f32> = vec4<f32>(0.0f, 0.0f, 0.0f, 0.0f);
    var j_0 : i32 = - _S51;
    var mean_0 : vec4<f32> = _S53;
    for(;;)
    {
        if(j_0 <= _S51)
        {
        }
        else
        {
            break;
        }
        var _S54 : u32 = u32(_S49 + j_0 + i32(u32(16) * _S42.rows_2)) % _S42.rows_2;
        var _S55 : u32 = _S52 + _S54 * _S42.columns_2;
        var i_1 : i32 = - _S50;
        var part_0 : vec4<f32> = _S53;
        for(;;)
        {
            if(i_1 <= _S50)
            {
            }
            else
            {
                break;
            }
            var _S56 : u32 = u32(_S46 + i_1 + i32(u32(16) * _S42.columns_2)) % _S42.columns_2;
            var part_1 : vec4<f32> = part_0 + vec4<f32>((bitcast<f32>((steps_0[u32(16) + u32(abs(i_1))])))) * bytes_of_0(texel_counts_0[(_S55 + _S56) * _S41 + _S43]);
            i_1 = i_1 + i32(1);
            part_0 = part_1;
        }
        var mean_1 : vec4<f32> = mean_0 + vec4<f32>((bitcast<f32>((steps_0[u32(32) + u32(abs(j_0))])))) * part_0;
        j_0 = j_0 + i32(1);
        mean_0 = mean_1;
    }
    coverage_pyramid_0[_S40] = mean_0 / vec4<f32>(f32(bakes_0[i32(0)].texels_across_0 * bakes_0[i32(0)].texels_along_0));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_coverage_scales(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    var _S57 : u32 = thread_index_0(id_4);
    var _S58 : u32 = u32(4) * (bakes_0[i32(0)].packs_0 + u32(1));
    var _S59 : Level_0 = this_level_0();
    if(_S57 >= _S58)
    {
        return;
    }
    var largest_1 : f32 = 9.99999971718068537e-10f;
    var row_1 : u32 = u32(0);
    for(;;)
    {
        if(row_1 < (_S59.rows_2))
        {
        }
        else
        {
            break;
        }
        var _S60 : f32 = max(largest_1, scratch_number_0(bakes_0[i32(0)].row_largest_0 + row_1 * _S58 + _S57));
        var _S61 : u32 = row_1 + u32(1);
        largest_1 = _S60;
        row_1 = _S61;
    }
    var _S62 : u32 = _S59.face_0 * _S58;
    scratch_0[bakes_0[i32(0)].coverage_means_0 + _S62 + _S57] = (bitcast<u32>((share_of_byte_0(i32(0), _S59, _S57))));
    scratch_0[bakes_0[i32(0)].coverage_scales_0 + _S62 + _S57] = (bitcast<u32>((largest_1)));
    return;
}

struct Taps_0
{
     nodes_0 : array<u32, i32(8)>,
     weights_0 : array<f32, i32(8)>,
};

fn taps_of_0( node_0 : u32,  count_0 : u32,  below_0 : u32,  far_weight_1 : f32) -> Taps_0
{
    var _S63 : f32 = (f32(node_0) + 0.5f) * (f32(below_0) / f32(count_0)) - 0.5f;
    var taps_0 : Taps_0;
    var tap_0 : u32 = u32(0);
    for(;;)
    {
        if(tap_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S64 : f32 = _S63 + f32(tap_0) - 1.5f;
        var _S65 : f32 = floor(_S64 + 0.00000999999974738f);
        var _S66 : f32 = max(_S64 - _S65, 0.0f);
        var _S67 : f32 = 0.5f * select(1.0f - far_weight_1, far_weight_1, ((tap_0 == u32(0)) | ((tap_0 == u32(3)))));
        var _S68 : u32 = u32(2) * tap_0;
        var _S69 : i32 = i32(_S65);
        var _S70 : i32 = i32(4) * i32(below_0);
        var _S71 : u32 = u32(_S69 + _S70) % below_0;
        taps_0.nodes_0[_S68] = _S71;
        var _S72 : u32 = _S68 + u32(1);
        var _S73 : u32 = u32(_S69 + i32(1) + _S70) % below_0;
        taps_0.nodes_0[_S72] = _S73;
        taps_0.weights_0[_S68] = _S67 * (1.0f - _S66);
        taps_0.weights_0[_S72] = _S67 * _S66;
        tap_0 = tap_0 + u32(1);
    }
    return taps_0;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_downsample(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    var _S74 : u32 = thread_index_0(id_5);
    var _S75 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S76 : Level_0 = this_level_0();
    if(_S74 >= (_S76.columns_2 * _S76.rows_2 * _S75))
    {
        return;
    }
    var _S77 : u32 = _S74 / _S75;
    var _S78 : u32 = _S77 % _S76.columns_2;
    var _S79 : f32 = bakes_0[i32(0)].far_weight_0;
    var _S80 : Taps_0 = taps_of_0(_S78, _S76.columns_2, _S76.below_columns_0, bakes_0[i32(0)].far_weight_0);
    var _S81 : u32 = _S74 / _S75;
    var _S82 : u32 = _S81 / _S76.columns_2;
    var _S83 : Taps_0 = taps_of_0(_S82, _S76.rows_2, _S76.below_rows_0, _S79);
    const _S84 : vec4<f32> = vec4<f32>(0.0f, 0.0f, 0.0f, 0.0f);
    var j_1 : u32 = u32(0);
    var mean_2 : vec4<f32> = _S84;
    for(;;)
    {
        if(j_1 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S85 : u32 = j_1;
        var mean_3 : vec4<f32>;
        if((_S83.weights_0[j_1]) == 0.0f)
        {
            mean_3 = mean_2;
            j_1 = j_1 + u32(1);
            mean_2 = mean_3;
            continue;
        }
        var _S86 : u32 = _S76.below_first_0 + _S83.nodes_0[j_1] * _S76.below_columns_0;
        var i_2 : u32 = u32(0);
        mean_3 = mean_2;
        for(;;)
        {
            if(i_2 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S87 : u32 = i_2;
            if((_S80.weights_0[i_2]) != 0.0f)
            {
                var _S88 : f32 = _S83.weights_0[_S85] * _S80.weights_0[_S87];
                var _S89 : u32 = (_S86 + _S80.nodes_0[i_2]) * _S75;
                var _S90 : u32 = _S74 % _S75;
                mean_3 = mean_3 + vec4<f32>(_S88) * coverage_pyramid_0[_S89 + _S90];
            }
            i_2 = i_2 + u32(1);
        }
        j_1 = j_1 + u32(1);
        mean_2 = mean_3;
    }
    coverage_pyramid_0[_S76.first_0 * _S75 + _S74] = mean_2;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_pack_coverage(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    var _S91 : u32 = thread_index_0(id_6);
    var _S92 : u32 = bakes_0[i32(0)].packs_0;
    var _S93 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S94 : u32 = bakes_0[i32(0)].face_nodes_0;
    if(_S91 >= (bakes_0[i32(0)].face_nodes_0 * _S93))
    {
        return;
    }
    var _S95 : u32 = steps_0[i32(0)];
    var _S96 : u32 = _S91 % _S93;
    var _S97 : vec4<f32> = coverage_pyramid_0[_S91];
    var i_3 : u32 = u32(0);
    var word_1 : u32 = u32(0);
    for(;;)
    {
        if(i_3 < u32(4))
        {
        }
        else
        {
            break;
        }
        var word_2 : u32 = (word_1 | (((u32(min(_S97[i_3] * (255.0f / scratch_number_0(bakes_0[i32(0)].coverage_scales_0 + (_S95 * _S93 + _S96) * u32(4) + i_3)) + 0.5f, 255.0f)) << ((u32(8) * i_3))))));
        i_3 = i_3 + u32(1);
        word_1 = word_2;
    }
    var _S98 : u32 = _S95 * _S94;
    var _S99 : u32 = _S91 / _S93;
    var _S100 : u32 = _S98 + _S99;
    if(_S96 == _S92)
    {
        scratch_0[bakes_0[i32(0)].hole_bytes_0 + _S100] = (word_1 & (u32(255)));
    }
    else
    {
        tables_0[fabrics_0[bakes_0[i32(0)].fabric_0].lobes_0.coverage_0 + _S100 * _S92 + _S96] = word_1;
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_pack_holes(@builtin(global_invocation_id) id_7 : vec3<u32>)
{
    var _S101 : u32 = thread_index_0(id_7);
    var _S102 : u32 = u32(4) * _S101;
    var _S103 : u32 = u32(2) * bakes_0[i32(0)].face_nodes_0;
    if(_S102 >= _S103)
    {
        return;
    }
    var i_4 : u32 = u32(0);
    var word_3 : u32 = u32(0);
    for(;;)
    {
        if(i_4 < u32(4))
        {
        }
        else
        {
            break;
        }
        if((_S102 + i_4) < _S103)
        {
            word_3 = (word_3 | (((scratch_0[bakes_0[i32(0)].hole_bytes_0 + _S102 + i_4] << ((u32(8) * i_4))))));
        }
        i_4 = i_4 + u32(1);
    }
    tables_0[fabrics_0[bakes_0[i32(0)].fabric_0].lobes_0.coverage_holes_0 + _S101] = word_3;
    return;
}

