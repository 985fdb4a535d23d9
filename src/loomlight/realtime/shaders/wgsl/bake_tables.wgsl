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

@binding(19) @group(0) var<storage, read_write> record_words_0 : array<u32>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec2<f32>,  no_0 : vec2<f32>) -> vec2<f32>
{
    var chosen_0 : vec2<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    return chosen_0;
}

var<private> RING_COSINES_0 : array<f32, i32(8)> = array<f32, i32(8)>( 1.0f, 0.92756068706512451f, 0.81746435165405273f, 0.68657326698303223f, 0.54003900289535522f, 0.38065254688262939f, 0.21021415293216705f, 0.02999999932944775f );
fn thread_index_0( id_0 : vec3<u32>) -> u32
{
    return id_0.y * u32(2097152) + id_0.x;
}

fn hit_tangent_0( hit_0 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_0).tangent_x_0, (*hit_0).tangent_y_0, (*hit_0).tangent_z_0);
}

fn hit_normal_0( hit_1 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_1).normal_x_0, (*hit_1).normal_y_0, (*hit_1).normal_z_0);
}

@compute
@workgroup_size(64, 1, 1)
fn bake_view_sums(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S1 : u32 = thread_index_0(id_1);
    var _S2 : u32 = u32(2) * bakes_0[i32(0)].per_family_0;
    if(_S1 >= (u32(512) * _S2))
    {
        return;
    }
    var _S3 : u32 = _S1 / _S2;
    var _S4 : u32 = _S1 % _S2;
    const _S5 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 0.0f);
    var ray_0 : u32 = u32(0);
    var count_0 : f32 = 0.0f;
    var normal_0 : vec3<f32> = _S5;
    var tangent_0 : vec3<f32> = _S5;
    var from_x_0 : vec3<f32> = _S5;
    var others_0 : vec3<f32> = _S5;
    for(;;)
    {
        var _S6 : u32 = bakes_0[i32(0)].rays_0;
        if(ray_0 < (bakes_0[i32(0)].rays_0))
        {
        }
        else
        {
            break;
        }
        var _S7 : u32 = _S3 * _S6 + ray_0;
        if((((hits_0[_S7].flags_0) >> (u32(8)))) == (_S4 + u32(1)))
        {
            var _S8 : SurfaceHit_std430_0 = hits_0[_S7];
            var _S9 : vec3<f32> = hit_tangent_0(&(_S8));
            var count_1 : f32 = count_0 + 1.0f;
            var _S10 : SurfaceHit_std430_0 = hits_0[_S7];
            var _S11 : vec3<f32> = hit_normal_0(&(_S10));
            var normal_1 : vec3<f32> = normal_0 + _S11;
            var tangent_1 : vec3<f32> = tangent_0 + _S9;
            var from_x_1 : vec3<f32> = from_x_0 + vec3<f32>(_S9.x) * _S9;
            var _S12 : f32 = _S9.y;
            var _S13 : f32 = _S9.z;
            var others_1 : vec3<f32> = others_0 + vec3<f32>(_S12 * _S12, _S12 * _S13, _S13 * _S13);
            count_0 = count_1;
            normal_0 = normal_1;
            tangent_0 = tangent_1;
            from_x_0 = from_x_1;
            others_0 = others_1;
        }
        ray_0 = ray_0 + u32(1);
    }
    var _S14 : u32 = bakes_0[i32(0)].view_sums_0 + _S1 * u32(13);
    scratch_0[_S14] = (bitcast<u32>((count_0)));
    var k_0 : u32 = u32(0);
    for(;;)
    {
        if(k_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        scratch_0[_S14 + u32(1) + k_0] = (bitcast<u32>((normal_0[k_0])));
        scratch_0[_S14 + u32(4) + k_0] = (bitcast<u32>((tangent_0[k_0])));
        scratch_0[_S14 + u32(7) + k_0] = (bitcast<u32>((from_x_0[k_0])));
        scratch_0[_S14 + u32(10) + k_0] = (bitcast<u32>((others_0[k_0])));
        k_0 = k_0 + u32(1);
    }
    return;
}

fn sine_cosine_0( x_0 : f32) -> vec2<f32>
{
    var _S15 : f32 = floor(x_0 * 0.63661974668502808f + 0.5f);
    var _S16 : f32 = x_0 - _S15 * 1.5703125f - _S15 * 0.00048375129699707f - _S15 * 7.54979012640433211e-08f;
    var _S17 : f32 = _S16 * _S16;
    var _S18 : f32 = ((-0.00019515295571182f * _S17 + 0.00833216123282909f) * _S17 - 0.16666655242443085f) * _S17 * _S16 + _S16;
    var _S19 : f32 = ((0.00002443315679557f * _S17 - 0.00138873164542019f) * _S17 + 0.04166664555668831f) * _S17 * _S17 - 0.5f * _S17 + 1.0f;
    var _S20 : u32 = (u32(i32(_S15)) & (u32(3)));
    var _S21 : vec2<f32> = select_vector_0(((_S20 & (u32(1)))) != u32(0), vec2<f32>(_S19, _S18), vec2<f32>(_S18, _S19));
    var _S22 : f32 = _S21.x;
    var _S23 : f32 = _S21.y;
    return vec2<f32>(select(_S22, - _S22, ((_S20 & (u32(2)))) != u32(0)), select(_S23, - _S23, (((_S20 + u32(1)) & (u32(2)))) != u32(0)));
}

fn node_direction_0( node_0 : u32) -> vec3<f32>
{
    var _S24 : u32 = node_0 % u32(8);
    var _S25 : vec2<f32> = sine_cosine_0(f32(node_0 / u32(8)) * 0.19634954631328583f);
    var _S26 : f32 = sqrt(1.0f - RING_COSINES_0[_S24] * RING_COSINES_0[_S24]);
    return vec3<f32>(_S26 * _S25.y, _S26 * _S25.x, RING_COSINES_0[_S24]);
}

fn start_of_shadow_ray_0( node_1 : u32,  ray_1 : u32,  rays_1 : u32) -> u32
{
    return (((node_1 * u32(37) + ray_1) & (u32(255)))) * rays_1 + ray_1;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_light_sums(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    var _S27 : u32 = thread_index_0(id_2);
    var _S28 : u32 = u32(2) * bakes_0[i32(0)].per_family_0;
    if(_S27 >= (u32(512) * _S28))
    {
        return;
    }
    var _S29 : u32 = _S27 / _S28;
    var _S30 : u32 = _S27 % _S28;
    var _S31 : u32 = _S29 / u32(256);
    var _S32 : u32 = _S29 % u32(256);
    var _S33 : vec3<f32> = node_direction_0(_S32);
    var _S34 : f32 = fabrics_0[bakes_0[i32(0)].fabric_0].diffuse_blend_0;
    const _S35 : vec2<f32> = vec2<f32>(0.0f, 0.0f);
    var ray_2 : u32 = u32(0);
    var count_2 : f32 = 0.0f;
    var lit_1 : vec2<f32> = _S35;
    var diffuse_0 : vec2<f32> = _S35;
    for(;;)
    {
        var _S36 : u32 = bakes_0[i32(0)].rays_0;
        if(ray_2 < (bakes_0[i32(0)].rays_0))
        {
        }
        else
        {
            break;
        }
        var _S37 : SurfaceHit_std430_0 = hits_0[_S31 * u32(256) * _S36 + start_of_shadow_ray_0(_S32, ray_2, _S36)];
        if((((hits_0[_S31 * u32(256) * _S36 + start_of_shadow_ray_0(_S32, ray_2, _S36)].flags_0) >> (u32(8)))) == (_S30 + u32(1)))
        {
            var _S38 : vec2<f32> = vec2<f32>(f32((scratch_0[bakes_0[i32(0)].lit_0 + _S29 * _S36 + ray_2] & (u32(1)))), f32((scratch_0[bakes_0[i32(0)].lit_0 + _S29 * _S36 + ray_2] >> (u32(1)))));
            var _S39 : f32 = _S37.normal_x_0 * _S33.x + _S37.normal_y_0 * _S33.y;
            var _S40 : f32 = _S33.z;
            var _S41 : f32 = _S37.normal_z_0 * _S40;
            var lit_2 : vec2<f32> = lit_1 + _S38;
            var _S42 : vec2<f32> = vec2<f32>(_S40);
            var diffuse_1 : vec2<f32> = diffuse_0 + _S38 * (_S42 + vec2<f32>(_S34) * (max(vec2<f32>(_S41 + _S39, _S41 - _S39), _S35) - _S42));
            count_2 = count_2 + 1.0f;
            lit_1 = lit_2;
            diffuse_0 = diffuse_1;
        }
        ray_2 = ray_2 + u32(1);
    }
    var _S43 : u32 = bakes_0[i32(0)].light_sums_0 + _S27 * u32(5);
    scratch_0[_S43] = (bitcast<u32>((count_2)));
    var side_0 : u32 = u32(0);
    for(;;)
    {
        if(side_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        scratch_0[_S43 + u32(1) + side_0] = (bitcast<u32>((lit_1[side_0])));
        scratch_0[_S43 + u32(3) + side_0] = (bitcast<u32>((diffuse_0[side_0])));
        side_0 = side_0 + u32(1);
    }
    return;
}

fn scratch_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((scratch_0[index_0])));
}

fn sums_row_0( _S44 : i32,  _S45 : u32,  _S46 : u32,  _S47 : u32,  _S48 : u32,  _S49 : u32) -> u32
{
    return _S45 + ((_S47 * u32(256) + _S48) * u32(2) * bakes_0[_S44].per_family_0 + _S49) * _S46;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_zenith(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    var _S50 : u32 = thread_index_0(id_3);
    var _S51 : u32 = _S50 / u32(18);
    var _S52 : u32 = bakes_0[i32(0)].per_family_0;
    if(_S51 >= (u32(4) * bakes_0[i32(0)].per_family_0))
    {
        return;
    }
    var _S53 : u32 = _S50 % u32(18);
    var _S54 : bool = _S53 < u32(13);
    var _S55 : u32 = select(u32(5), u32(13), _S54);
    var _S56 : u32 = select(bakes_0[i32(0)].light_sums_0, bakes_0[i32(0)].view_sums_0, _S54);
    var _S57 : u32 = u32(2) * _S52;
    var _S58 : u32 = _S51 / _S57;
    var _S59 : u32 = _S51 % _S57;
    var _S60 : u32 = sums_row_0(i32(0), _S56, _S55, _S58, u32(0), _S59) + select(_S53 - u32(13), _S53, _S54);
    var _S61 : u32 = u32(16) * _S52 * _S55;
    var azimuth_0 : u32 = u32(0);
    var total_0 : f32 = 0.0f;
    for(;;)
    {
        if(azimuth_0 < u32(32))
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + scratch_number_0(_S60 + azimuth_0 * _S61);
        azimuth_0 = azimuth_0 + u32(1);
        total_0 = total_1;
    }
    azimuth_0 = u32(0);
    for(;;)
    {
        if(azimuth_0 < u32(32))
        {
        }
        else
        {
            break;
        }
        scratch_0[_S60 + azimuth_0 * _S61] = (bitcast<u32>((total_0 / 32.0f)));
        azimuth_0 = azimuth_0 + u32(1);
    }
    return;
}

fn square_0( v_0 : vec3<f32>) -> f32
{
    return dot(v_0, v_0);
}

@compute
@workgroup_size(64, 1, 1)
fn bake_moments(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    var azimuth_1 : u32;
    var _S62 : u32 = thread_index_0(id_4);
    var _S63 : u32 = bakes_0[i32(0)].per_family_0;
    if(_S62 >= (u32(4) * bakes_0[i32(0)].per_family_0))
    {
        return;
    }
    var _S64 : u32 = u32(2) * _S63;
    var _S65 : u32 = _S62 / _S64;
    var _S66 : u32 = _S62 % _S64;
    var sums_1 : array<f32, i32(13)>;
    var sum_0 : u32 = u32(0);
    for(;;)
    {
        if(sum_0 < u32(13))
        {
        }
        else
        {
            break;
        }
        sums_1[sum_0] = 0.0f;
        azimuth_1 = u32(0);
        for(;;)
        {
            if(azimuth_1 < u32(32))
            {
            }
            else
            {
                break;
            }
            var ring_0 : u32 = u32(0);
            var total_2 : f32 = 0.0f;
            for(;;)
            {
                if(ring_0 < u32(8))
                {
                }
                else
                {
                    break;
                }
                var total_3 : f32 = total_2 + scratch_number_0(sums_row_0(i32(0), bakes_0[i32(0)].view_sums_0, u32(13), _S65, azimuth_1 * u32(8) + ring_0, _S66) + sum_0);
                ring_0 = ring_0 + u32(1);
                total_2 = total_3;
            }
            sums_1[sum_0] = sums_1[sum_0] + total_2;
            azimuth_1 = azimuth_1 + u32(1);
        }
        sum_0 = sum_0 + u32(1);
    }
    var _S67 : f32 = max(sums_1[i32(0)], 1.0f);
    var _S68 : u32 = bakes_0[i32(0)].centroids_0 + _S62 * u32(7);
    var _S69 : vec3<f32> = vec3<f32>(_S67);
    var _S70 : vec3<f32> = vec3<f32>(sums_1[i32(1)], sums_1[i32(2)], sums_1[i32(3)]) / _S69;
    var t_0 : vec3<f32> = vec3<f32>(sums_1[i32(4)], sums_1[i32(5)], sums_1[i32(6)]) / _S69;
    var _S71 : vec2<f32> = t_0.xy;
    var _S72 : vec2<f32> = vec2<f32>(sums_1[i32(7)], sums_1[i32(10)]) / vec2<f32>(_S67) - _S71 * _S71;
    var _S73 : f32 = t_0.x;
    var _S74 : f32 = t_0.y;
    var _S75 : f32 = t_0.z;
    var _S76 : vec3<f32> = vec3<f32>(sums_1[i32(8)], sums_1[i32(9)], sums_1[i32(11)]) / _S69 - vec3<f32>(_S73 * _S74, _S73 * _S75, _S74 * _S75);
    var normal_2 : vec3<f32>;
    var t_1 : vec3<f32>;
    var mixed_0 : vec3<f32>;
    var variance_0 : vec2<f32>;
    if((sums_1[i32(0)]) < 8.0f)
    {
        var t_2 : vec3<f32> = vec3<f32>(scratch_number_0(_S68 + u32(3)), scratch_number_0(_S68 + u32(4)), scratch_number_0(_S68 + u32(5)));
        var _S77 : vec2<f32> = vec2<f32>((max(1.0f - square_0(t_2), 0.0f) / 3.0f));
        const _S78 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 0.0f);
        normal_2 = vec3<f32>(scratch_number_0(_S68), scratch_number_0(_S68 + u32(1)), scratch_number_0(_S68 + u32(2))) / vec3<f32>(0.5f);
        t_1 = t_2;
        mixed_0 = _S78;
        variance_0 = _S77;
    }
    else
    {
        normal_2 = _S70;
        t_1 = t_0;
        mixed_0 = _S76;
        variance_0 = _S72;
    }
    var _S79 : u32 = bakes_0[i32(0)].group_moments_0 + _S62 * u32(12);
    azimuth_1 = u32(0);
    for(;;)
    {
        if(azimuth_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        scratch_0[_S79 + azimuth_1] = (bitcast<u32>((normal_2[azimuth_1])));
        scratch_0[_S79 + u32(4) + azimuth_1] = (bitcast<u32>((t_1[azimuth_1])));
        scratch_0[_S79 + u32(9) + azimuth_1] = (bitcast<u32>((mixed_0[azimuth_1])));
        azimuth_1 = azimuth_1 + u32(1);
    }
    scratch_0[_S79 + u32(7)] = (bitcast<u32>((variance_0.x)));
    scratch_0[_S79 + u32(8)] = (bitcast<u32>((variance_0.y)));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_areas(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    var _S80 : u32 = thread_index_0(id_5);
    if(_S80 >= u32(512))
    {
        return;
    }
    var _S81 : u32 = u32(2) * bakes_0[i32(0)].per_family_0;
    var _S82 : u32 = (_S80 % u32(256) + _S80 / u32(256) * u32(16) * u32(8)) % u32(256);
    var _S83 : u32 = bakes_0[i32(0)].facts_0;
    var _S84 : u32 = scratch_0[bakes_0[i32(0)].facts_0 + u32(9)];
    var ray_3 : u32 = u32(0);
    var passed_0 : u32 = u32(0);
    for(;;)
    {
        if(ray_3 < _S84)
        {
        }
        else
        {
            break;
        }
        var passed_1 : u32 = passed_0 + scratch_0[bakes_0[i32(0)].gap_nulls_0 + _S82 * u32(128) + ray_3];
        ray_3 = ray_3 + u32(1);
        passed_0 = passed_1;
    }
    var _S85 : f32 = f32(scratch_0[_S83 + u32(8)]) / 8192.0f;
    var _S86 : f32 = f32(passed_0) / f32(max(_S84, u32(1)));
    var _S87 : u32 = bakes_0[i32(0)].view_sums_0 + _S80 * _S81 * u32(13);
    var group_0 : u32 = u32(0);
    var hit_2 : f32 = 0.0f;
    for(;;)
    {
        if(group_0 < _S81)
        {
        }
        else
        {
            break;
        }
        var hit_3 : f32 = hit_2 + scratch_number_0(_S87 + group_0 * u32(13));
        group_0 = group_0 + u32(1);
        hit_2 = hit_3;
    }
    var _S88 : f32 = select(1.0f, _S85 * _S86, hit_2 > 0.0f);
    group_0 = u32(0);
    for(;;)
    {
        if(group_0 < _S81)
        {
        }
        else
        {
            break;
        }
        scratch_0[bakes_0[i32(0)].areas_0 + _S80 * (_S81 + u32(1)) + group_0] = (bitcast<u32>((scratch_number_0(_S87 + group_0 * u32(13)) * ((1.0f - _S88) / max(hit_2, 1.0f)))));
        group_0 = group_0 + u32(1);
    }
    scratch_0[bakes_0[i32(0)].areas_0 + _S80 * (_S81 + u32(1)) + _S81] = (bitcast<u32>((_S88)));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_area_scales(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    var _S89 : u32 = thread_index_0(id_6);
    var _S90 : u32 = u32(2) * bakes_0[i32(0)].per_family_0 + u32(1);
    if(_S89 >= (u32(2) * _S90))
    {
        return;
    }
    var _S91 : u32 = bakes_0[i32(0)].areas_0;
    var _S92 : u32 = _S89 / _S90;
    var _S93 : u32 = _S91 + _S92 * u32(256) * _S90;
    var _S94 : u32 = _S89 % _S90;
    var _S95 : u32 = _S93 + _S94;
    var largest_0 : f32 = 9.99999971718068537e-10f;
    var node_2 : u32 = u32(0);
    for(;;)
    {
        if(node_2 < u32(256))
        {
        }
        else
        {
            break;
        }
        var _S96 : f32 = max(largest_0, scratch_number_0(_S95 + node_2 * _S90));
        var _S97 : u32 = node_2 + u32(1);
        largest_0 = _S96;
        node_2 = _S97;
    }
    scratch_0[bakes_0[i32(0)].area_scales_0 + _S89] = (bitcast<u32>((largest_0)));
    return;
}

fn group_of_byte_0( _S98 : i32,  _S99 : u32,  _S100 : u32) -> u32
{
    var _S101 : u32 = u32(2) * bakes_0[_S98].packs_0;
    var _S102 : u32 = select(u32(0), u32(1), _S99 >= _S101);
    var _S103 : u32 = _S99 - _S102 * _S101;
    return select(_S100, _S102 * bakes_0[_S98].per_family_0 + _S103, ((_S103 < (bakes_0[_S98].per_family_0)) & ((_S99 < (u32(2) * _S101)))));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_pack_areas(@builtin(global_invocation_id) id_7 : vec3<u32>)
{
    var _S104 : u32 = thread_index_0(id_7);
    var _S105 : u32 = bakes_0[i32(0)].packs_0;
    var _S106 : u32 = bakes_0[i32(0)].packs_0 + u32(1);
    if(_S104 >= (u32(512) * _S106))
    {
        return;
    }
    var _S107 : u32 = _S104 / _S106;
    var _S108 : u32 = u32(2) * bakes_0[i32(0)].per_family_0 + u32(1);
    var i_0 : u32 = u32(0);
    var word_0 : u32 = u32(0);
    for(;;)
    {
        if(i_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S109 : u32 = _S104 % _S106;
        var _S110 : u32 = _S109 * u32(4) + i_0;
        var _S111 : u32;
        if(_S110 == (u32(4) * _S105))
        {
            _S111 = _S108 - u32(1);
        }
        else
        {
            _S111 = group_of_byte_0(i32(0), _S110, _S108);
        }
        if(_S111 < _S108)
        {
            word_0 = (word_0 | (((u32(round(sqrt(scratch_number_0(bakes_0[i32(0)].areas_0 + _S107 * _S108 + _S111) / scratch_number_0(bakes_0[i32(0)].area_scales_0 + _S107 / u32(256) * _S108 + _S111)) * 255.0f)) << ((u32(8) * i_0))))));
        }
        i_0 = i_0 + u32(1);
    }
    tables_0[fabrics_0[bakes_0[i32(0)].fabric_0].lobes_0.projected_area_0 + _S104] = word_0;
    return;
}

fn unshadowed_term_0( _S112 : i32,  _S113 : u32,  _S114 : u32,  _S115 : u32,  _S116 : u32) -> f32
{
    var _S117 : vec3<f32> = node_direction_0(_S115);
    var _S118 : u32 = bakes_0[_S112].group_moments_0 + (_S113 * u32(2) * bakes_0[_S112].per_family_0 + _S116) * u32(12);
    var _S119 : f32 = _S117.x * scratch_number_0(_S118) + _S117.y * scratch_number_0(_S118 + u32(1));
    var _S120 : f32 = _S117.z;
    var _S121 : f32 = _S120 * scratch_number_0(_S118 + u32(2));
    return _S120 * (1.0f - fabrics_0[bakes_0[_S112].fabric_0].diffuse_blend_0) + fabrics_0[bakes_0[_S112].fabric_0].diffuse_blend_0 * max(select(_S121 - _S119, _S121 + _S119, _S114 == u32(0)), 0.0f) + 0.01999999955296516f;
}

fn smoothed_light_0( _S122 : i32,  _S123 : u32,  _S124 : u32,  _S125 : u32,  _S126 : u32) -> vec2<f32>
{
    const _S127 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 0.0f);
    var _S128 : i32 = i32(_S125 / u32(8));
    var _S129 : i32 = i32(_S125 % u32(8));
    var own_0 : vec3<f32> = _S127;
    var i_1 : i32 = i32(-1);
    var around_0 : vec3<f32> = _S127;
    for(;;)
    {
        if(i_1 <= i32(1))
        {
        }
        else
        {
            break;
        }
        var own_1 : vec3<f32> = own_0;
        var j_0 : i32 = i32(-1);
        for(;;)
        {
            if(j_0 <= i32(1))
            {
            }
            else
            {
                break;
            }
            var _S130 : u32 = u32(_S128 + i_1 + i32(32)) % u32(32) * u32(8) + u32(clamp(_S129 + j_0, i32(0), i32(7)));
            var _S131 : u32 = sums_row_0(_S122, bakes_0[_S122].light_sums_0, u32(5), _S123, _S130, _S126);
            var _S132 : vec3<f32> = vec3<f32>(scratch_number_0(_S131), scratch_number_0(_S131 + u32(1) + _S124), scratch_number_0(_S131 + u32(3) + _S124) / unshadowed_term_0(_S122, _S123, _S124, _S130, _S126));
            var around_1 : vec3<f32> = around_0 + vec3<f32>((f32((i32(2) - abs(i_1)) * (i32(2) - abs(j_0))) / 16.0f)) * _S132;
            var _S133 : bool;
            if(i_1 == i32(0))
            {
                _S133 = j_0 == i32(0);
            }
            else
            {
                _S133 = false;
            }
            if(_S133)
            {
                own_1 = _S132;
            }
            j_0 = j_0 + i32(1);
            around_0 = around_1;
        }
        var _S134 : i32 = i_1 + i32(1);
        own_0 = own_1;
        i_1 = _S134;
    }
    var _S135 : vec2<f32> = (own_0.yz + vec2<f32>(8.0f) * around_0.yz / vec2<f32>(max(around_0.x, 9.99999971718068537e-10f))) / vec2<f32>((own_0.x + 8.0f));
    var _S136 : f32 = _S135.x;
    return vec2<f32>(_S136, min(_S135.y * unshadowed_term_0(_S122, _S123, _S124, _S125, _S126), _S136));
}

@compute
@workgroup_size(64, 1, 1)
fn bake_pack_light(@builtin(global_invocation_id) id_8 : vec3<u32>)
{
    var _S137 : u32 = thread_index_0(id_8);
    var _S138 : u32 = bakes_0[i32(0)].packs_0;
    if(_S137 >= (u32(1024) * bakes_0[i32(0)].packs_0))
    {
        return;
    }
    var _S139 : u32 = _S137 / _S138;
    var _S140 : u32 = u32(2) * bakes_0[i32(0)].per_family_0;
    var i_2 : u32 = u32(0);
    var visibility_0 : u32 = u32(0);
    var irradiance_1 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S141 : u32 = _S137 % _S138;
        var _S142 : u32 = group_of_byte_0(i32(0), _S141 * u32(4) + i_2, _S140);
        if(_S142 < _S140)
        {
            var _S143 : vec2<f32> = round(clamp(smoothed_light_0(i32(0), _S139 / u32(512), _S139 / u32(256) % u32(2), _S139 % u32(256), _S142), vec2<f32>(0.0f, 0.0f), vec2<f32>(1.0f, 1.0f)) * vec2<f32>(255.0f));
            var _S144 : u32 = u32(8) * i_2;
            var irradiance_2 : u32 = (irradiance_1 | (((u32(_S143.y) << (_S144)))));
            visibility_0 = (visibility_0 | (((u32(_S143.x) << (_S144)))));
            irradiance_1 = irradiance_2;
        }
        i_2 = i_2 + u32(1);
    }
    var _S145 : u32 = bakes_0[i32(0)].fabric_0;
    tables_0[fabrics_0[bakes_0[i32(0)].fabric_0].lobes_0.light_visibility_0 + _S137] = visibility_0;
    tables_0[fabrics_0[_S145].lobes_0.irradiance_0 + _S137] = irradiance_1;
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_pack_moments(@builtin(global_invocation_id) id_9 : vec3<u32>)
{
    var _S146 : u32 = thread_index_0(id_9);
    var _S147 : u32 = bakes_0[i32(0)].packs_0;
    var _S148 : u32 = u32(4) * bakes_0[i32(0)].packs_0;
    var _S149 : u32 = _S148 + u32(1);
    if(_S146 >= (u32(2) * _S149))
    {
        return;
    }
    var _S150 : u32 = _S146 / _S149;
    var _S151 : u32 = _S146 % _S149;
    var _S152 : u32 = bakes_0[i32(0)].per_family_0;
    var _S153 : u32 = u32(2) * bakes_0[i32(0)].per_family_0;
    var _S154 : bool = _S151 == _S148;
    var _S155 : u32;
    if(_S154)
    {
        _S155 = _S153;
    }
    else
    {
        _S155 = group_of_byte_0(i32(0), _S151, _S153 + u32(1));
    }
    var _S156 : u32 = _S150 * u32(4) * (_S147 + u32(1));
    var _S157 : f32 = scratch_number_0(bakes_0[i32(0)].coverage_means_0 + _S156 + _S151);
    var _S158 : f32 = select(0.0f, scratch_number_0(bakes_0[i32(0)].coverage_scales_0 + _S156 + _S151) * scratch_number_0(bakes_0[i32(0)].area_scales_0 + _S150 * (_S153 + u32(1)) + min(_S155, _S153)) / max(_S157, 9.99999971718068537e-10f) / 1.6581375e+07f, _S157 > 0.0f);
    if(_S154)
    {
        record_words_0[bakes_0[i32(0)].record_warp_packs_0 + _S150] = select(scratch_0[bakes_0[i32(0)].facts_0 + u32(14) + _S150] / u32(4), _S147 / u32(2), scratch_0[bakes_0[i32(0)].facts_0 + u32(14) + _S150] == _S152);
        record_words_0[bakes_0[i32(0)].record_hole_weights_0 + _S150] = (bitcast<u32>((_S158)));
        return;
    }
    var _S159 : u32 = bakes_0[i32(0)].moments_table_0 + (_S150 * _S148 + _S151) * u32(12);
    var k_1 : u32 = u32(0);
    for(;;)
    {
        if(k_1 < u32(12))
        {
        }
        else
        {
            break;
        }
        var _S160 : u32 = (bitcast<u32>((select(0.0f, 1.0f, ((k_1 == u32(2)) | ((k_1 == u32(5))))))));
        var number_0 : u32;
        if(_S155 < _S153)
        {
            if(k_1 == u32(3))
            {
                number_0 = (bitcast<u32>((_S158)));
            }
            else
            {
                number_0 = scratch_0[bakes_0[i32(0)].group_moments_0 + (_S150 * _S153 + _S155) * u32(12) + k_1];
            }
        }
        else
        {
            number_0 = _S160;
        }
        tables_0[_S159 + k_1] = number_0;
        k_1 = k_1 + u32(1);
    }
    return;
}

