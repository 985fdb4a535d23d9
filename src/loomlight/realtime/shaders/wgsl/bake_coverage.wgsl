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
fn bake_first_level(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S1 : u32 = thread_index_0(id_1);
    var _S2 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S3 : Level_0 = this_level_0();
    if(_S1 >= (_S3.columns_2 * _S3.rows_2 * _S2))
    {
        return;
    }
    var _S4 : u32 = _S1 % _S2;
    var _S5 : u32 = _S1 / _S2;
    var _S6 : u32 = _S5 % _S3.columns_2;
    var _S7 : i32 = i32(_S6);
    var _S8 : u32 = _S1 / _S2;
    var _S9 : u32 = _S8 / _S3.columns_2;
    var _S10 : i32 = i32(_S9);
    var _S11 : i32 = i32(steps_0[i32(7)]);
    var _S12 : i32 = i32(steps_0[i32(8)]);
    var _S13 : u32 = _S3.face_0 * _S3.columns_2 * _S3.rows_2;
    const _S14 : vec4<f32> = vec4<f32>(0.0f, 0.0f, 0.0f, 0.0f);
    var j_0 : i32 = - _S12;
    var mean_0 : vec4<f32> = _S14;
    for(;;)
    {
        if(j_0 <= _S12)
        {
        }
        else
        {
            break;
        }
        var _S15 : u32 = u32(_S10 + j_0 + i32(u32(16) * _S3.rows_2)) % _S3.rows_2;
        var _S16 : u32 = _S13 + _S15 * _S3.columns_2;
        var i_0 : i32 = - _S11;
        var part_0 : vec4<f32> = _S14;
        for(;;)
        {
            if(i_0 <= _S11)
            {
            }
            else
            {
                break;
            }
            var _S17 : u32 = u32(_S7 + i_0 + i32(u32(16) * _S3.columns_2)) % _S3.columns_2;
            var part_1 : vec4<f32> = part_0 + vec4<f32>((bitcast<f32>((steps_0[u32(16) + u32(abs(i_0))])))) * bytes_of_0(texel_counts_0[(_S16 + _S17) * _S2 + _S4]);
            i_0 = i_0 + i32(1);
            part_0 = part_1;
        }
        var mean_1 : vec4<f32> = mean_0 + vec4<f32>((bitcast<f32>((steps_0[u32(32) + u32(abs(j_0))])))) * part_0;
        j_0 = j_0 + i32(1);
        mean_0 = mean_1;
    }
    coverage_pyramid_0[_S1] = mean_0 / vec4<f32>(f32(bakes_0[i32(0)].texels_across_0 * bakes_0[i32(0)].texels_along_0));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_row_totals(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    var _S18 : u32 = thread_index_0(id_2);
    var _S19 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S20 : Level_0 = this_level_0();
    if(_S18 >= (_S20.rows_2 * _S19))
    {
        return;
    }
    var _S21 : u32 = _S18 / _S19;
    const _S22 : vec4<u32> = vec4<u32>(u32(0), u32(0), u32(0), u32(0));
    var largest_0 : vec4<f32> = vec4<f32>(0.0f, 0.0f, 0.0f, 0.0f);
    var column_0 : u32 = u32(0);
    var total_0 : vec4<u32> = _S22;
    for(;;)
    {
        if(column_0 < (_S20.columns_2))
        {
        }
        else
        {
            break;
        }
        var _S23 : u32 = (_S21 * _S20.columns_2 + column_0) * _S19;
        var _S24 : u32 = _S18 % _S19;
        var _S25 : u32 = _S23 + _S24;
        var total_1 : vec4<u32> = total_0 + vec4<u32>(bytes_of_0(texel_counts_0[_S20.face_0 * _S20.columns_2 * _S20.rows_2 * _S19 + _S25]));
        var _S26 : vec4<f32> = max(largest_0, coverage_pyramid_0[_S25]);
        var _S27 : u32 = column_0 + u32(1);
        largest_0 = _S26;
        column_0 = _S27;
        total_0 = total_1;
    }
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S28 : u32 = _S18 * u32(4);
        scratch_0[bakes_0[i32(0)].row_totals_0 + _S28 + i_1] = total_0[i_1];
        scratch_0[bakes_0[i32(0)].row_largest_0 + _S28 + i_1] = (bitcast<u32>((largest_0[i_1])));
        i_1 = i_1 + u32(1);
    }
    return;
}

fn scratch_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((scratch_0[index_0])));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_coverage_scales(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    var _S29 : u32;
    var _S30 : u32 = thread_index_0(id_3);
    var _S31 : u32 = u32(4) * (bakes_0[i32(0)].packs_0 + u32(1));
    var _S32 : Level_0 = this_level_0();
    if(_S30 >= _S31)
    {
        return;
    }
    var largest_1 : f32 = 9.99999971718068537e-10f;
    var row_0 : u32 = u32(0);
    var total_2 : u32 = u32(0);
    for(;;)
    {
        _S29 = _S32.rows_2;
        if(row_0 < (_S32.rows_2))
        {
        }
        else
        {
            break;
        }
        var _S33 : u32 = row_0 * _S31;
        var total_3 : u32 = total_2 + scratch_0[bakes_0[i32(0)].row_totals_0 + _S33 + _S30];
        var _S34 : f32 = max(largest_1, scratch_number_0(bakes_0[i32(0)].row_largest_0 + _S33 + _S30));
        var _S35 : u32 = row_0 + u32(1);
        largest_1 = _S34;
        row_0 = _S35;
        total_2 = total_3;
    }
    var _S36 : u32 = _S32.face_0 * _S31;
    scratch_0[bakes_0[i32(0)].coverage_means_0 + _S36 + _S30] = (bitcast<u32>((f32(total_2) / (f32(_S32.columns_2 * _S29) * f32(bakes_0[i32(0)].texels_across_0 * bakes_0[i32(0)].texels_along_0)))));
    scratch_0[bakes_0[i32(0)].coverage_scales_0 + _S36 + _S30] = (bitcast<u32>((largest_1)));
    return;
}

struct Taps_0
{
     nodes_0 : array<u32, i32(8)>,
     weights_0 : array<f32, i32(8)>,
};

fn taps_of_0( node_0 : u32,  count_0 : u32,  below_0 : u32,  far_weight_1 : f32) -> Taps_0
{
    var _S37 : f32 = (f32(node_0) + 0.5f) * (f32(below_0) / f32(count_0)) - 0.5f;
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
        var _S38 : f32 = _S37 + f32(tap_0) - 1.5f;
        var _S39 : f32 = floor(_S38 + 0.00000999999974738f);
        var _S40 : f32 = max(_S38 - _S39, 0.0f);
        var _S41 : f32 = 0.5f * select(1.0f - far_weight_1, far_weight_1, ((tap_0 == u32(0)) | ((tap_0 == u32(3)))));
        var _S42 : u32 = u32(2) * tap_0;
        var _S43 : i32 = i32(_S39);
        var _S44 : i32 = i32(4) * i32(below_0);
        var _S45 : u32 = u32(_S43 + _S44) % below_0;
        taps_0.nodes_0[_S42] = _S45;
        var _S46 : u32 = _S42 + u32(1);
        var _S47 : u32 = u32(_S43 + i32(1) + _S44) % below_0;
        taps_0.nodes_0[_S46] = _S47;
        taps_0.weights_0[_S42] = _S41 * (1.0f - _S40);
        taps_0.weights_0[_S46] = _S41 * _S40;
        tap_0 = tap_0 + u32(1);
    }
    return taps_0;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_downsample(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    var _S48 : u32 = thread_index_0(id_4);
    var _S49 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S50 : Level_0 = this_level_0();
    if(_S48 >= (_S50.columns_2 * _S50.rows_2 * _S49))
    {
        return;
    }
    var _S51 : u32 = _S48 / _S49;
    var _S52 : u32 = _S51 % _S50.columns_2;
    var _S53 : f32 = bakes_0[i32(0)].far_weight_0;
    var _S54 : Taps_0 = taps_of_0(_S52, _S50.columns_2, _S50.below_columns_0, bakes_0[i32(0)].far_weight_0);
    var _S55 : u32 = _S48 / _S49;
    var _S56 : u32 = _S55 / _S50.columns_2;
    var _S57 : Taps_0 = taps_of_0(_S56, _S50.rows_2, _S50.below_rows_0, _S53);
    const _S58 : vec4<f32> = vec4<f32>(0.0f, 0.0f, 0.0f, 0.0f);
    var j_1 : u32 = u32(0);
    var mean_2 : vec4<f32> = _S58;
    for(;;)
    {
        if(j_1 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S59 : u32 = j_1;
        var mean_3 : vec4<f32>;
        if((_S57.weights_0[j_1]) == 0.0f)
        {
            mean_3 = mean_2;
            j_1 = j_1 + u32(1);
            mean_2 = mean_3;
            continue;
        }
        var _S60 : u32 = _S50.below_first_0 + _S57.nodes_0[j_1] * _S50.below_columns_0;
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
            var _S61 : u32 = i_2;
            if((_S54.weights_0[i_2]) != 0.0f)
            {
                var _S62 : f32 = _S57.weights_0[_S59] * _S54.weights_0[_S61];
                var _S63 : u32 = (_S60 + _S54.nodes_0[i_2]) * _S49;
                var _S64 : u32 = _S48 % _S49;
                mean_3 = mean_3 + vec4<f32>(_S62) * coverage_pyramid_0[_S63 + _S64];
            }
            i_2 = i_2 + u32(1);
        }
        j_1 = j_1 + u32(1);
        mean_2 = mean_3;
    }
    coverage_pyramid_0[_S50.first_0 * _S49 + _S48] = mean_2;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_pack_coverage(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    var _S65 : u32 = thread_index_0(id_5);
    var _S66 : u32 = bakes_0[i32(0)].packs_0;
    var _S67 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    var _S68 : u32 = bakes_0[i32(0)].face_nodes_0;
    if(_S65 >= (bakes_0[i32(0)].face_nodes_0 * _S67))
    {
        return;
    }
    var _S69 : u32 = steps_0[i32(0)];
    var _S70 : u32 = _S65 % _S67;
    var _S71 : vec4<f32> = coverage_pyramid_0[_S65];
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
        var word_2 : u32 = (word_1 | (((u32(min(_S71[i_3] * (255.0f / scratch_number_0(bakes_0[i32(0)].coverage_scales_0 + (_S69 * _S67 + _S70) * u32(4) + i_3)) + 0.5f, 255.0f)) << ((u32(8) * i_3))))));
        i_3 = i_3 + u32(1);
        word_1 = word_2;
    }
    var _S72 : u32 = _S69 * _S68;
    var _S73 : u32 = _S65 / _S67;
    var _S74 : u32 = _S72 + _S73;
    if(_S70 == _S66)
    {
        scratch_0[bakes_0[i32(0)].hole_bytes_0 + _S74] = (word_1 & (u32(255)));
    }
    else
    {
        tables_0[fabrics_0[bakes_0[i32(0)].fabric_0].lobes_0.coverage_0 + _S74 * _S66 + _S70] = word_1;
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_pack_holes(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    var _S75 : u32 = thread_index_0(id_6);
    var _S76 : u32 = u32(4) * _S75;
    var _S77 : u32 = u32(2) * bakes_0[i32(0)].face_nodes_0;
    if(_S76 >= _S77)
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
        if((_S76 + i_4) < _S77)
        {
            word_3 = (word_3 | (((scratch_0[bakes_0[i32(0)].hole_bytes_0 + _S76 + i_4] << ((u32(8) * i_4))))));
        }
        i_4 = i_4 + u32(1);
    }
    tables_0[fabrics_0[bakes_0[i32(0)].fabric_0].lobes_0.coverage_holes_0 + _S75] = word_3;
    return;
}

