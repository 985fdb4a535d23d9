struct Frame_std430_0
{
    @align(4) width_0 : u32,
    @align(4) height_0 : u32,
    @align(4) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(4) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(4) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(4) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(4) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(4) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(4) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(4) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(4) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(4) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(4) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(4) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(4) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(4) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(4) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(4) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(4) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
};

@binding(4) @group(0) var<storage, read> frames_0 : array<Frame_std430_0>;

struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(12) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(7) @group(0) var<storage, read> face_fabrics_0 : array<u32>;

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
    @align(4) frames_1 : u32,
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
    @align(4) width_1 : f32,
    @align(4) height_1 : f32,
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
    @align(4) samples_1 : u32,
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

@binding(6) @group(0) var<storage, read> corners_0 : array<u32>;

struct Vertex_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) z_0 : f32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) u_0 : f32,
    @align(4) v_0 : f32,
};

@binding(5) @group(0) var<storage, read> vertices_0 : array<Vertex_std430_0>;

@binding(11) @group(0) var<storage, read> scene_words_0 : array<u32>;

@binding(10) @group(0) var<storage, read> packed_numbers_0 : array<vec4<u32>>;

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

@binding(13) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

struct Light_std430_0
{
    @align(4) is_point_0 : u32,
    @align(4) x_1 : f32,
    @align(4) y_1 : f32,
    @align(4) z_1 : f32,
    @align(4) red_0 : f32,
    @align(4) green_0 : f32,
    @align(4) blue_0 : f32,
};

@binding(3) @group(0) var<storage, read> lights_1 : array<Light_std430_0>;

@binding(8) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

struct FloatWeights_0
{
     first_0 : u32,
};

struct Eight_0
{
     low_0 : vec4<f32>,
     high_0 : vec4<f32>,
};

fn FloatWeights_eight_0( this_0 : FloatWeights_0,  element_0 : u32) -> Eight_0
{
    var numbers_0 : Eight_0;
    var _S1 : u32 = this_0.first_0 + u32(2) * element_0;
    numbers_0.low_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S1])));
    numbers_0.high_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S1 + u32(1)])));
    return numbers_0;
}

fn tile_product_0( weights_0 : FloatWeights_0,  row_0 : u32,  inputs_0 : ptr<function, array<f32, i32(96)>>) -> vec4<f32>
{
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
    var column_0 : u32 = u32(0);
    for(;;)
    {
        if(column_0 < u32(12))
        {
        }
        else
        {
            break;
        }
        var low_1 : vec4<f32>;
        var high_1 : vec4<f32>;
        var _S2 : i32 = i32(u32(8) * column_0);
        low_1[i32(0)] = (*inputs_0)[_S2];
        high_1[i32(0)] = (*inputs_0)[_S2 + i32(4)];
        var _S3 : i32 = _S2 + i32(1);
        low_1[i32(1)] = (*inputs_0)[_S3];
        high_1[i32(1)] = (*inputs_0)[_S3 + i32(4)];
        var _S4 : i32 = _S2 + i32(2);
        low_1[i32(2)] = (*inputs_0)[_S4];
        high_1[i32(2)] = (*inputs_0)[_S4 + i32(4)];
        var _S5 : i32 = _S2 + i32(3);
        low_1[i32(3)] = (*inputs_0)[_S5];
        high_1[i32(3)] = (*inputs_0)[_S5 + i32(4)];
        var _S6 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        sums_1[i32(0)] = sums_1[i32(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        var _S7 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(12) + column_0);
        sums_1[i32(1)] = sums_1[i32(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        var _S8 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(24) + column_0);
        sums_1[i32(2)] = sums_1[i32(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        var _S9 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(36) + column_0);
        sums_1[i32(3)] = sums_1[i32(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + u32(1);
    }
    return sums_1;
}

fn whole_parts_0( elements_0 : i32) -> i32
{
    return (elements_0 + i32(3)) / i32(4) * i32(4);
}

fn Identity_apply_0( x_2 : f32) -> f32
{
    return x_2;
}

fn dense_part_0( weights_1 : FloatWeights_0,  first_1 : u32,  adds_0 : bool,  inputs_1 : ptr<function, array<f32, i32(96)>>,  outputs_0 : ptr<function, array<f32, i32(50)>>)
{
    var _S10 : u32 = first_1 + u32(whole_parts_0(i32(7)));
    var output_0 : i32 = i32(0);
    for(;;)
    {
        var _S11 : bool = output_0 < i32(50);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        var _S12 : u32 = u32(output_0);
        var _S13 : Eight_0 = FloatWeights_eight_0(weights_1, first_1 + _S12 / u32(8));
        var _S14 : vec4<f32> = tile_product_0(weights_1, _S10 + _S12 * u32(12), &((*inputs_1)));
        var _S15 : vec4<f32>;
        if(((output_0 & (i32(4)))) != i32(0))
        {
            _S15 = _S13.high_0;
        }
        else
        {
            _S15 = _S13.low_0;
        }
        var _S16 : vec4<f32> = _S14 + _S15;
        var _S17 : f32;
        if(_S11)
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[output_0];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[output_0] = Identity_apply_0(_S16[i32(0)] + _S17);
        }
        var _S18 : i32 = output_0 + i32(1);
        if(_S18 < i32(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S18] = Identity_apply_0(_S16[i32(1)] + _S17);
        }
        var _S19 : i32 = output_0 + i32(2);
        if(_S19 < i32(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S19] = Identity_apply_0(_S16[i32(2)] + _S17);
        }
        var _S20 : i32 = output_0 + i32(3);
        if(_S20 < i32(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S20] = Identity_apply_0(_S16[i32(3)] + _S17);
        }
        output_0 = output_0 + i32(4);
    }
    return;
}

struct HalfWeights_0
{
     first_2 : u32,
};

fn eight_halves_0( packed_0 : vec4<u32>) -> Eight_0
{
    var numbers_1 : Eight_0;
    numbers_1.low_0 = vec4<f32>(unpack2x16float(packed_0.x), unpack2x16float(packed_0.y));
    numbers_1.high_0 = vec4<f32>(unpack2x16float(packed_0.z), unpack2x16float(packed_0.w));
    return numbers_1;
}

fn HalfWeights_eight_0( this_1 : HalfWeights_0,  element_1 : u32) -> Eight_0
{
    return eight_halves_0(packed_numbers_0[this_1.first_2 + element_1]);
}

fn tile_product_1( weights_2 : HalfWeights_0,  row_1 : u32,  inputs_2 : ptr<function, array<f32, i32(96)>>) -> vec4<f32>
{
    var sums_2 : vec4<f32> = vec4<f32>(0.0f);
    var column_1 : u32 = u32(0);
    for(;;)
    {
        if(column_1 < u32(12))
        {
        }
        else
        {
            break;
        }
        var low_2 : vec4<f32>;
        var high_2 : vec4<f32>;
        var _S21 : i32 = i32(u32(8) * column_1);
        low_2[i32(0)] = (*inputs_2)[_S21];
        high_2[i32(0)] = (*inputs_2)[_S21 + i32(4)];
        var _S22 : i32 = _S21 + i32(1);
        low_2[i32(1)] = (*inputs_2)[_S22];
        high_2[i32(1)] = (*inputs_2)[_S22 + i32(4)];
        var _S23 : i32 = _S21 + i32(2);
        low_2[i32(2)] = (*inputs_2)[_S23];
        high_2[i32(2)] = (*inputs_2)[_S23 + i32(4)];
        var _S24 : i32 = _S21 + i32(3);
        low_2[i32(3)] = (*inputs_2)[_S24];
        high_2[i32(3)] = (*inputs_2)[_S24 + i32(4)];
        var _S25 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + column_1);
        sums_2[i32(0)] = sums_2[i32(0)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        var _S26 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(12) + column_1);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        var _S27 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(24) + column_1);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        var _S28 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(36) + column_1);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_2;
}

fn dense_part_1( weights_3 : HalfWeights_0,  first_3 : u32,  adds_1 : bool,  inputs_3 : ptr<function, array<f32, i32(96)>>,  outputs_1 : ptr<function, array<f32, i32(52)>>)
{
    var _S29 : u32 = first_3 + u32(whole_parts_0(i32(7)));
    var output_1 : i32 = i32(0);
    for(;;)
    {
        var _S30 : bool = output_1 < i32(52);
        if(_S30)
        {
        }
        else
        {
            break;
        }
        var _S31 : u32 = u32(output_1);
        var _S32 : Eight_0 = HalfWeights_eight_0(weights_3, first_3 + _S31 / u32(8));
        var _S33 : vec4<f32> = tile_product_1(weights_3, _S29 + _S31 * u32(12), &((*inputs_3)));
        var _S34 : vec4<f32>;
        if(((output_1 & (i32(4)))) != i32(0))
        {
            _S34 = _S32.high_0;
        }
        else
        {
            _S34 = _S32.low_0;
        }
        var _S35 : vec4<f32> = _S33 + _S34;
        var _S36 : f32;
        if(_S30)
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[output_1];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S35[i32(0)] + _S36);
        }
        var _S37 : i32 = output_1 + i32(1);
        if(_S37 < i32(52))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S37];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S37] = Identity_apply_0(_S35[i32(1)] + _S36);
        }
        var _S38 : i32 = output_1 + i32(2);
        if(_S38 < i32(52))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S38];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S38] = Identity_apply_0(_S35[i32(2)] + _S36);
        }
        var _S39 : i32 = output_1 + i32(3);
        if(_S39 < i32(52))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S39];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S39] = Identity_apply_0(_S35[i32(3)] + _S36);
        }
        output_1 = output_1 + i32(4);
    }
    return;
}

fn tile_product_2( weights_4 : HalfWeights_0,  row_2 : u32,  inputs_4 : ptr<function, array<f32, i32(39)>>) -> vec4<f32>
{
    var sums_3 : vec4<f32> = vec4<f32>(0.0f);
    var column_2 : u32 = u32(0);
    for(;;)
    {
        if(column_2 < u32(5))
        {
        }
        else
        {
            break;
        }
        var low_3 : vec4<f32>;
        var high_3 : vec4<f32>;
        var _S40 : i32 = i32(u32(8) * column_2);
        low_3[i32(0)] = (*inputs_4)[min(_S40, i32(38))];
        high_3[i32(0)] = (*inputs_4)[min(_S40 + i32(4), i32(38))];
        var _S41 : i32 = _S40 + i32(1);
        low_3[i32(1)] = (*inputs_4)[min(_S41, i32(38))];
        high_3[i32(1)] = (*inputs_4)[min(_S41 + i32(4), i32(38))];
        var _S42 : i32 = _S40 + i32(2);
        low_3[i32(2)] = (*inputs_4)[min(_S42, i32(38))];
        high_3[i32(2)] = (*inputs_4)[min(_S42 + i32(4), i32(38))];
        var _S43 : i32 = _S40 + i32(3);
        low_3[i32(3)] = (*inputs_4)[min(_S43, i32(38))];
        high_3[i32(3)] = (*inputs_4)[min(_S43 + i32(4), i32(38))];
        var _S44 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + column_2);
        sums_3[i32(0)] = sums_3[i32(0)] + (dot(_S44.low_0, low_3) + dot(_S44.high_0, high_3));
        var _S45 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(5) + column_2);
        sums_3[i32(1)] = sums_3[i32(1)] + (dot(_S45.low_0, low_3) + dot(_S45.high_0, high_3));
        var _S46 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(10) + column_2);
        sums_3[i32(2)] = sums_3[i32(2)] + (dot(_S46.low_0, low_3) + dot(_S46.high_0, high_3));
        var _S47 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(15) + column_2);
        sums_3[i32(3)] = sums_3[i32(3)] + (dot(_S47.low_0, low_3) + dot(_S47.high_0, high_3));
        column_2 = column_2 + u32(1);
    }
    return sums_3;
}

fn dense_part_2( weights_5 : HalfWeights_0,  first_4 : u32,  adds_2 : bool,  inputs_5 : ptr<function, array<f32, i32(39)>>,  outputs_2 : ptr<function, array<f32, i32(96)>>)
{
    var _S48 : u32 = first_4 + u32(whole_parts_0(i32(12)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S49 : bool = output_2 < i32(96);
        if(_S49)
        {
        }
        else
        {
            break;
        }
        var _S50 : u32 = u32(output_2);
        var _S51 : Eight_0 = HalfWeights_eight_0(weights_5, first_4 + _S50 / u32(8));
        var _S52 : vec4<f32> = tile_product_2(weights_5, _S48 + _S50 * u32(5), &((*inputs_5)));
        var _S53 : vec4<f32>;
        if(((output_2 & (i32(4)))) != i32(0))
        {
            _S53 = _S51.high_0;
        }
        else
        {
            _S53 = _S51.low_0;
        }
        var _S54 : vec4<f32> = _S52 + _S53;
        var _S55 : f32;
        if(_S49)
        {
            if(adds_2)
            {
                _S55 = (*outputs_2)[output_2];
            }
            else
            {
                _S55 = 0.0f;
            }
            (*outputs_2)[output_2] = Identity_apply_0(_S54[i32(0)] + _S55);
        }
        var _S56 : i32 = output_2 + i32(1);
        if(_S56 < i32(96))
        {
            if(adds_2)
            {
                _S55 = (*outputs_2)[_S56];
            }
            else
            {
                _S55 = 0.0f;
            }
            (*outputs_2)[_S56] = Identity_apply_0(_S54[i32(1)] + _S55);
        }
        var _S57 : i32 = output_2 + i32(2);
        if(_S57 < i32(96))
        {
            if(adds_2)
            {
                _S55 = (*outputs_2)[_S57];
            }
            else
            {
                _S55 = 0.0f;
            }
            (*outputs_2)[_S57] = Identity_apply_0(_S54[i32(2)] + _S55);
        }
        var _S58 : i32 = output_2 + i32(3);
        if(_S58 < i32(96))
        {
            if(adds_2)
            {
                _S55 = (*outputs_2)[_S58];
            }
            else
            {
                _S55 = 0.0f;
            }
            (*outputs_2)[_S58] = Identity_apply_0(_S54[i32(3)] + _S55);
        }
        output_2 = output_2 + i32(4);
    }
    return;
}

fn tile_product_3( weights_6 : HalfWeights_0,  row_3 : u32,  inputs_6 : ptr<function, array<f32, i32(100)>>) -> vec4<f32>
{
    var sums_4 : vec4<f32> = vec4<f32>(0.0f);
    var column_3 : u32 = u32(0);
    for(;;)
    {
        if(column_3 < u32(13))
        {
        }
        else
        {
            break;
        }
        var low_4 : vec4<f32>;
        var high_4 : vec4<f32>;
        var _S59 : i32 = i32(u32(8) * column_3);
        low_4[i32(0)] = (*inputs_6)[min(_S59, i32(99))];
        high_4[i32(0)] = (*inputs_6)[min(_S59 + i32(4), i32(99))];
        var _S60 : i32 = _S59 + i32(1);
        low_4[i32(1)] = (*inputs_6)[min(_S60, i32(99))];
        high_4[i32(1)] = (*inputs_6)[min(_S60 + i32(4), i32(99))];
        var _S61 : i32 = _S59 + i32(2);
        low_4[i32(2)] = (*inputs_6)[min(_S61, i32(99))];
        high_4[i32(2)] = (*inputs_6)[min(_S61 + i32(4), i32(99))];
        var _S62 : i32 = _S59 + i32(3);
        low_4[i32(3)] = (*inputs_6)[min(_S62, i32(99))];
        high_4[i32(3)] = (*inputs_6)[min(_S62 + i32(4), i32(99))];
        var _S63 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        sums_4[i32(0)] = sums_4[i32(0)] + (dot(_S63.low_0, low_4) + dot(_S63.high_0, high_4));
        var _S64 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(13) + column_3);
        sums_4[i32(1)] = sums_4[i32(1)] + (dot(_S64.low_0, low_4) + dot(_S64.high_0, high_4));
        var _S65 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(26) + column_3);
        sums_4[i32(2)] = sums_4[i32(2)] + (dot(_S65.low_0, low_4) + dot(_S65.high_0, high_4));
        var _S66 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(39) + column_3);
        sums_4[i32(3)] = sums_4[i32(3)] + (dot(_S66.low_0, low_4) + dot(_S66.high_0, high_4));
        column_3 = column_3 + u32(1);
    }
    return sums_4;
}

fn dense_part_3( weights_7 : HalfWeights_0,  first_5 : u32,  adds_3 : bool,  inputs_7 : ptr<function, array<f32, i32(100)>>,  outputs_3 : ptr<function, array<f32, i32(96)>>)
{
    var _S67 : u32 = first_5 + u32(whole_parts_0(i32(12)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S68 : bool = output_3 < i32(96);
        if(_S68)
        {
        }
        else
        {
            break;
        }
        var _S69 : u32 = u32(output_3);
        var _S70 : Eight_0 = HalfWeights_eight_0(weights_7, first_5 + _S69 / u32(8));
        var _S71 : vec4<f32> = tile_product_3(weights_7, _S67 + _S69 * u32(13), &((*inputs_7)));
        var _S72 : vec4<f32>;
        if(((output_3 & (i32(4)))) != i32(0))
        {
            _S72 = _S70.high_0;
        }
        else
        {
            _S72 = _S70.low_0;
        }
        var _S73 : vec4<f32> = _S71 + _S72;
        var _S74 : f32;
        if(_S68)
        {
            if(adds_3)
            {
                _S74 = (*outputs_3)[output_3];
            }
            else
            {
                _S74 = 0.0f;
            }
            (*outputs_3)[output_3] = Identity_apply_0(_S73[i32(0)] + _S74);
        }
        var _S75 : i32 = output_3 + i32(1);
        if(_S75 < i32(96))
        {
            if(adds_3)
            {
                _S74 = (*outputs_3)[_S75];
            }
            else
            {
                _S74 = 0.0f;
            }
            (*outputs_3)[_S75] = Identity_apply_0(_S73[i32(1)] + _S74);
        }
        var _S76 : i32 = output_3 + i32(2);
        if(_S76 < i32(96))
        {
            if(adds_3)
            {
                _S74 = (*outputs_3)[_S76];
            }
            else
            {
                _S74 = 0.0f;
            }
            (*outputs_3)[_S76] = Identity_apply_0(_S73[i32(2)] + _S74);
        }
        var _S77 : i32 = output_3 + i32(3);
        if(_S77 < i32(96))
        {
            if(adds_3)
            {
                _S74 = (*outputs_3)[_S77];
            }
            else
            {
                _S74 = 0.0f;
            }
            (*outputs_3)[_S77] = Identity_apply_0(_S73[i32(3)] + _S74);
        }
        output_3 = output_3 + i32(4);
    }
    return;
}

fn tile_product_4( weights_8 : HalfWeights_0,  row_4 : u32,  inputs_8 : ptr<function, array<f32, i32(16)>>) -> vec4<f32>
{
    var sums_5 : vec4<f32> = vec4<f32>(0.0f);
    var column_4 : u32 = u32(0);
    for(;;)
    {
        if(column_4 < u32(2))
        {
        }
        else
        {
            break;
        }
        var low_5 : vec4<f32>;
        var high_5 : vec4<f32>;
        var _S78 : i32 = i32(u32(8) * column_4);
        low_5[i32(0)] = (*inputs_8)[_S78];
        high_5[i32(0)] = (*inputs_8)[_S78 + i32(4)];
        var _S79 : i32 = _S78 + i32(1);
        low_5[i32(1)] = (*inputs_8)[_S79];
        high_5[i32(1)] = (*inputs_8)[_S79 + i32(4)];
        var _S80 : i32 = _S78 + i32(2);
        low_5[i32(2)] = (*inputs_8)[_S80];
        high_5[i32(2)] = (*inputs_8)[_S80 + i32(4)];
        var _S81 : i32 = _S78 + i32(3);
        low_5[i32(3)] = (*inputs_8)[_S81];
        high_5[i32(3)] = (*inputs_8)[_S81 + i32(4)];
        var _S82 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + column_4);
        sums_5[i32(0)] = sums_5[i32(0)] + (dot(_S82.low_0, low_5) + dot(_S82.high_0, high_5));
        var _S83 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(2) + column_4);
        sums_5[i32(1)] = sums_5[i32(1)] + (dot(_S83.low_0, low_5) + dot(_S83.high_0, high_5));
        var _S84 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(4) + column_4);
        sums_5[i32(2)] = sums_5[i32(2)] + (dot(_S84.low_0, low_5) + dot(_S84.high_0, high_5));
        var _S85 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(6) + column_4);
        sums_5[i32(3)] = sums_5[i32(3)] + (dot(_S85.low_0, low_5) + dot(_S85.high_0, high_5));
        column_4 = column_4 + u32(1);
    }
    return sums_5;
}

fn dense_part_4( weights_9 : HalfWeights_0,  first_6 : u32,  adds_4 : bool,  inputs_9 : ptr<function, array<f32, i32(16)>>,  outputs_4 : ptr<function, array<f32, i32(1)>>)
{
    var _S86 : u32 = first_6 + u32(whole_parts_0(i32(1)));
    var output_4 : i32 = i32(0);
    for(;;)
    {
        var _S87 : bool = output_4 < i32(1);
        if(_S87)
        {
        }
        else
        {
            break;
        }
        var _S88 : u32 = u32(output_4);
        var _S89 : Eight_0 = HalfWeights_eight_0(weights_9, first_6 + _S88 / u32(8));
        var _S90 : vec4<f32> = tile_product_4(weights_9, _S86 + _S88 * u32(2), &((*inputs_9)));
        var _S91 : vec4<f32>;
        if(((output_4 & (i32(4)))) != i32(0))
        {
            _S91 = _S89.high_0;
        }
        else
        {
            _S91 = _S89.low_0;
        }
        var _S92 : vec4<f32> = _S90 + _S91;
        var _S93 : f32;
        if(_S87)
        {
            if(adds_4)
            {
                _S93 = (*outputs_4)[output_4];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_4)[output_4] = Identity_apply_0(_S92[i32(0)] + _S93);
        }
        var _S94 : i32 = output_4 + i32(1);
        if(_S94 < i32(1))
        {
            if(adds_4)
            {
                _S93 = (*outputs_4)[_S94];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_4)[_S94] = Identity_apply_0(_S92[i32(1)] + _S93);
        }
        var _S95 : i32 = output_4 + i32(2);
        if(_S95 < i32(1))
        {
            if(adds_4)
            {
                _S93 = (*outputs_4)[_S95];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_4)[_S95] = Identity_apply_0(_S92[i32(2)] + _S93);
        }
        var _S96 : i32 = output_4 + i32(3);
        if(_S96 < i32(1))
        {
            if(adds_4)
            {
                _S93 = (*outputs_4)[_S96];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_4)[_S96] = Identity_apply_0(_S92[i32(3)] + _S93);
        }
        output_4 = output_4 + i32(4);
    }
    return;
}

fn LeakyRelu_apply_0( x_3 : f32) -> f32
{
    return max(x_3, x_3 * 0.00999999977648258f);
}

fn dense_part_5( weights_10 : HalfWeights_0,  first_7 : u32,  adds_5 : bool,  inputs_10 : ptr<function, array<f32, i32(96)>>,  outputs_5 : ptr<function, array<f32, i32(96)>>)
{
    var _S97 : u32 = first_7 + u32(whole_parts_0(i32(12)));
    var output_5 : i32 = i32(0);
    for(;;)
    {
        var _S98 : bool = output_5 < i32(96);
        if(_S98)
        {
        }
        else
        {
            break;
        }
        var _S99 : u32 = u32(output_5);
        var _S100 : Eight_0 = HalfWeights_eight_0(weights_10, first_7 + _S99 / u32(8));
        var _S101 : vec4<f32> = tile_product_1(weights_10, _S97 + _S99 * u32(12), &((*inputs_10)));
        var _S102 : vec4<f32>;
        if(((output_5 & (i32(4)))) != i32(0))
        {
            _S102 = _S100.high_0;
        }
        else
        {
            _S102 = _S100.low_0;
        }
        var _S103 : vec4<f32> = _S101 + _S102;
        var _S104 : f32;
        if(_S98)
        {
            if(adds_5)
            {
                _S104 = (*outputs_5)[output_5];
            }
            else
            {
                _S104 = 0.0f;
            }
            (*outputs_5)[output_5] = LeakyRelu_apply_0(_S103[i32(0)] + _S104);
        }
        var _S105 : i32 = output_5 + i32(1);
        if(_S105 < i32(96))
        {
            if(adds_5)
            {
                _S104 = (*outputs_5)[_S105];
            }
            else
            {
                _S104 = 0.0f;
            }
            (*outputs_5)[_S105] = LeakyRelu_apply_0(_S103[i32(1)] + _S104);
        }
        var _S106 : i32 = output_5 + i32(2);
        if(_S106 < i32(96))
        {
            if(adds_5)
            {
                _S104 = (*outputs_5)[_S106];
            }
            else
            {
                _S104 = 0.0f;
            }
            (*outputs_5)[_S106] = LeakyRelu_apply_0(_S103[i32(2)] + _S104);
        }
        var _S107 : i32 = output_5 + i32(3);
        if(_S107 < i32(96))
        {
            if(adds_5)
            {
                _S104 = (*outputs_5)[_S107];
            }
            else
            {
                _S104 = 0.0f;
            }
            (*outputs_5)[_S107] = LeakyRelu_apply_0(_S103[i32(3)] + _S104);
        }
        output_5 = output_5 + i32(4);
    }
    return;
}

fn dense_part_6( weights_11 : HalfWeights_0,  first_8 : u32,  adds_6 : bool,  inputs_11 : ptr<function, array<f32, i32(100)>>,  outputs_6 : ptr<function, array<f32, i32(16)>>)
{
    var _S108 : u32 = first_8 + u32(whole_parts_0(i32(2)));
    var output_6 : i32 = i32(0);
    for(;;)
    {
        var _S109 : bool = output_6 < i32(16);
        if(_S109)
        {
        }
        else
        {
            break;
        }
        var _S110 : u32 = u32(output_6);
        var _S111 : Eight_0 = HalfWeights_eight_0(weights_11, first_8 + _S110 / u32(8));
        var _S112 : vec4<f32> = tile_product_3(weights_11, _S108 + _S110 * u32(13), &((*inputs_11)));
        var _S113 : vec4<f32>;
        if(((output_6 & (i32(4)))) != i32(0))
        {
            _S113 = _S111.high_0;
        }
        else
        {
            _S113 = _S111.low_0;
        }
        var _S114 : vec4<f32> = _S112 + _S113;
        var _S115 : f32;
        if(_S109)
        {
            if(adds_6)
            {
                _S115 = (*outputs_6)[output_6];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_6)[output_6] = LeakyRelu_apply_0(_S114[i32(0)] + _S115);
        }
        var _S116 : i32 = output_6 + i32(1);
        if(_S116 < i32(16))
        {
            if(adds_6)
            {
                _S115 = (*outputs_6)[_S116];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_6)[_S116] = LeakyRelu_apply_0(_S114[i32(1)] + _S115);
        }
        var _S117 : i32 = output_6 + i32(2);
        if(_S117 < i32(16))
        {
            if(adds_6)
            {
                _S115 = (*outputs_6)[_S117];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_6)[_S117] = LeakyRelu_apply_0(_S114[i32(2)] + _S115);
        }
        var _S118 : i32 = output_6 + i32(3);
        if(_S118 < i32(16))
        {
            if(adds_6)
            {
                _S115 = (*outputs_6)[_S118];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_6)[_S118] = LeakyRelu_apply_0(_S114[i32(3)] + _S115);
        }
        output_6 = output_6 + i32(4);
    }
    return;
}

fn tile_product_5( weights_12 : HalfWeights_0,  row_5 : u32,  inputs_12 : ptr<function, array<f32, i32(88)>>) -> vec4<f32>
{
    var sums_6 : vec4<f32> = vec4<f32>(0.0f);
    var column_5 : u32 = u32(0);
    for(;;)
    {
        if(column_5 < u32(11))
        {
        }
        else
        {
            break;
        }
        var low_6 : vec4<f32>;
        var high_6 : vec4<f32>;
        var _S119 : i32 = i32(u32(8) * column_5);
        low_6[i32(0)] = (*inputs_12)[_S119];
        high_6[i32(0)] = (*inputs_12)[_S119 + i32(4)];
        var _S120 : i32 = _S119 + i32(1);
        low_6[i32(1)] = (*inputs_12)[_S120];
        high_6[i32(1)] = (*inputs_12)[_S120 + i32(4)];
        var _S121 : i32 = _S119 + i32(2);
        low_6[i32(2)] = (*inputs_12)[_S121];
        high_6[i32(2)] = (*inputs_12)[_S121 + i32(4)];
        var _S122 : i32 = _S119 + i32(3);
        low_6[i32(3)] = (*inputs_12)[_S122];
        high_6[i32(3)] = (*inputs_12)[_S122 + i32(4)];
        var _S123 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + column_5);
        sums_6[i32(0)] = sums_6[i32(0)] + (dot(_S123.low_0, low_6) + dot(_S123.high_0, high_6));
        var _S124 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(11) + column_5);
        sums_6[i32(1)] = sums_6[i32(1)] + (dot(_S124.low_0, low_6) + dot(_S124.high_0, high_6));
        var _S125 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(22) + column_5);
        sums_6[i32(2)] = sums_6[i32(2)] + (dot(_S125.low_0, low_6) + dot(_S125.high_0, high_6));
        var _S126 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(33) + column_5);
        sums_6[i32(3)] = sums_6[i32(3)] + (dot(_S126.low_0, low_6) + dot(_S126.high_0, high_6));
        column_5 = column_5 + u32(1);
    }
    return sums_6;
}

fn dense_part_7( weights_13 : HalfWeights_0,  first_9 : u32,  adds_7 : bool,  inputs_13 : ptr<function, array<f32, i32(88)>>,  outputs_7 : ptr<function, array<f32, i32(96)>>)
{
    var _S127 : u32 = first_9 + u32(whole_parts_0(i32(12)));
    var output_7 : i32 = i32(0);
    for(;;)
    {
        var _S128 : bool = output_7 < i32(96);
        if(_S128)
        {
        }
        else
        {
            break;
        }
        var _S129 : u32 = u32(output_7);
        var _S130 : Eight_0 = HalfWeights_eight_0(weights_13, first_9 + _S129 / u32(8));
        var _S131 : vec4<f32> = tile_product_5(weights_13, _S127 + _S129 * u32(11), &((*inputs_13)));
        var _S132 : vec4<f32>;
        if(((output_7 & (i32(4)))) != i32(0))
        {
            _S132 = _S130.high_0;
        }
        else
        {
            _S132 = _S130.low_0;
        }
        var _S133 : vec4<f32> = _S131 + _S132;
        var _S134 : f32;
        if(_S128)
        {
            if(adds_7)
            {
                _S134 = (*outputs_7)[output_7];
            }
            else
            {
                _S134 = 0.0f;
            }
            (*outputs_7)[output_7] = LeakyRelu_apply_0(_S133[i32(0)] + _S134);
        }
        var _S135 : i32 = output_7 + i32(1);
        if(_S135 < i32(96))
        {
            if(adds_7)
            {
                _S134 = (*outputs_7)[_S135];
            }
            else
            {
                _S134 = 0.0f;
            }
            (*outputs_7)[_S135] = LeakyRelu_apply_0(_S133[i32(1)] + _S134);
        }
        var _S136 : i32 = output_7 + i32(2);
        if(_S136 < i32(96))
        {
            if(adds_7)
            {
                _S134 = (*outputs_7)[_S136];
            }
            else
            {
                _S134 = 0.0f;
            }
            (*outputs_7)[_S136] = LeakyRelu_apply_0(_S133[i32(2)] + _S134);
        }
        var _S137 : i32 = output_7 + i32(3);
        if(_S137 < i32(96))
        {
            if(adds_7)
            {
                _S134 = (*outputs_7)[_S137];
            }
            else
            {
                _S134 = 0.0f;
            }
            (*outputs_7)[_S137] = LeakyRelu_apply_0(_S133[i32(3)] + _S134);
        }
        output_7 = output_7 + i32(4);
    }
    return;
}

fn rsqrt_0( x_4 : f32) -> f32
{
    return 1.0f / sqrt(x_4);
}

fn dense_0( weights_14 : FloatWeights_0,  first_10 : u32,  adds_8 : bool,  inputs_14 : ptr<function, array<f32, i32(96)>>,  outputs_8 : ptr<function, array<f32, i32(50)>>)
{
    dense_part_0(weights_14, first_10, adds_8, &((*inputs_14)), &((*outputs_8)));
    return;
}

fn dense_1( weights_15 : HalfWeights_0,  first_11 : u32,  adds_9 : bool,  inputs_15 : ptr<function, array<f32, i32(96)>>,  outputs_9 : ptr<function, array<f32, i32(52)>>)
{
    dense_part_1(weights_15, first_11, adds_9, &((*inputs_15)), &((*outputs_9)));
    return;
}

fn dense_2( weights_16 : HalfWeights_0,  first_12 : u32,  adds_10 : bool,  inputs_16 : ptr<function, array<f32, i32(96)>>,  outputs_10 : ptr<function, array<f32, i32(96)>>)
{
    dense_part_5(weights_16, first_12, adds_10, &((*inputs_16)), &((*outputs_10)));
    return;
}

fn dense_3( weights_17 : HalfWeights_0,  first_13 : u32,  adds_11 : bool,  inputs_17 : ptr<function, array<f32, i32(39)>>,  outputs_11 : ptr<function, array<f32, i32(96)>>)
{
    dense_part_2(weights_17, first_13, adds_11, &((*inputs_17)), &((*outputs_11)));
    return;
}

fn dense_4( weights_18 : HalfWeights_0,  first_14 : u32,  adds_12 : bool,  inputs_18 : ptr<function, array<f32, i32(100)>>,  outputs_12 : ptr<function, array<f32, i32(96)>>)
{
    dense_part_3(weights_18, first_14, adds_12, &((*inputs_18)), &((*outputs_12)));
    return;
}

fn dense_5( weights_19 : HalfWeights_0,  first_15 : u32,  adds_13 : bool,  inputs_19 : ptr<function, array<f32, i32(16)>>,  outputs_13 : ptr<function, array<f32, i32(1)>>)
{
    dense_part_4(weights_19, first_15, adds_13, &((*inputs_19)), &((*outputs_13)));
    return;
}

fn dense_6( weights_20 : HalfWeights_0,  first_16 : u32,  adds_14 : bool,  inputs_20 : ptr<function, array<f32, i32(100)>>,  outputs_14 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_6(weights_20, first_16, adds_14, &((*inputs_20)), &((*outputs_14)));
    return;
}

fn dense_part_8( weights_21 : HalfWeights_0,  first_17 : u32,  adds_15 : bool,  inputs_21 : ptr<function, array<f32, i32(96)>>,  outputs_15 : ptr<function, array<f32, i32(100)>>)
{
    var _S138 : u32 = first_17 + u32(whole_parts_0(i32(12)));
    var output_8 : i32 = i32(0);
    for(;;)
    {
        var _S139 : bool = output_8 < i32(96);
        if(_S139)
        {
        }
        else
        {
            break;
        }
        var _S140 : u32 = u32(output_8);
        var _S141 : Eight_0 = HalfWeights_eight_0(weights_21, first_17 + _S140 / u32(8));
        var _S142 : vec4<f32> = tile_product_1(weights_21, _S138 + _S140 * u32(12), &((*inputs_21)));
        var _S143 : vec4<f32>;
        if(((output_8 & (i32(4)))) != i32(0))
        {
            _S143 = _S141.high_0;
        }
        else
        {
            _S143 = _S141.low_0;
        }
        var _S144 : vec4<f32> = _S142 + _S143;
        var _S145 : f32;
        if(_S139)
        {
            if(adds_15)
            {
                _S145 = (*outputs_15)[output_8];
            }
            else
            {
                _S145 = 0.0f;
            }
            (*outputs_15)[output_8] = LeakyRelu_apply_0(_S144[i32(0)] + _S145);
        }
        var _S146 : i32 = output_8 + i32(1);
        if(_S146 < i32(96))
        {
            if(adds_15)
            {
                _S145 = (*outputs_15)[_S146];
            }
            else
            {
                _S145 = 0.0f;
            }
            (*outputs_15)[_S146] = LeakyRelu_apply_0(_S144[i32(1)] + _S145);
        }
        var _S147 : i32 = output_8 + i32(2);
        if(_S147 < i32(96))
        {
            if(adds_15)
            {
                _S145 = (*outputs_15)[_S147];
            }
            else
            {
                _S145 = 0.0f;
            }
            (*outputs_15)[_S147] = LeakyRelu_apply_0(_S144[i32(2)] + _S145);
        }
        var _S148 : i32 = output_8 + i32(3);
        if(_S148 < i32(96))
        {
            if(adds_15)
            {
                _S145 = (*outputs_15)[_S148];
            }
            else
            {
                _S145 = 0.0f;
            }
            (*outputs_15)[_S148] = LeakyRelu_apply_0(_S144[i32(3)] + _S145);
        }
        output_8 = output_8 + i32(4);
    }
    return;
}

fn dense_7( weights_22 : HalfWeights_0,  first_18 : u32,  adds_16 : bool,  inputs_22 : ptr<function, array<f32, i32(88)>>,  outputs_16 : ptr<function, array<f32, i32(96)>>)
{
    dense_part_7(weights_22, first_18, adds_16, &((*inputs_22)), &((*outputs_16)));
    return;
}

fn position_of_0( vertex_0 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_0).x_0, (*vertex_0).y_0, (*vertex_0).z_0);
}

fn position_of_1( vertex_1 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_1).x_0, (*vertex_1).y_0, (*vertex_1).z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn normal_of_0( vertex_2 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_2).normal_x_0, (*vertex_2).normal_y_0, (*vertex_2).normal_z_0);
}

fn square_1( x_5 : f32) -> f32
{
    return x_5 * x_5;
}

fn natural_logarithm_0( x_6 : f32) -> f32
{
    var _S149 : u32 = (bitcast<u32>((x_6)));
    var exponent_0 : f32 = f32(i32((_S149 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S149 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var exponent_1 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var exponent_2 : f32 = exponent_0 - 1.0f;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var _S150 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S150 - exponent_1 * 0.00021219444170129f - 0.5f * _S150) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_7 : f32) -> f32
{
    return natural_logarithm_0(x_7) * 1.4426950216293335f;
}

fn exponential_0( x_8 : f32) -> f32
{
    var _S151 : f32 = clamp(x_8, -87.0f, 88.0f);
    var _S152 : f32 = floor(_S151 * 1.4426950216293335f + 0.5f);
    var _S153 : f32 = _S151 - _S152 * 0.693359375f + _S152 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S153 + 0.00139819993637502f) * _S153 + 0.00833345204591751f) * _S153 + 0.04166579619050026f) * _S153 + 0.1666666567325592f) * _S153 + 0.5f;
    var _S154 : f32 = (bitcast<f32>(((u32(i32(_S152) + i32(127)) << (u32(23))))));
    var _S155 : f32;
    if(x_8 < -87.0f)
    {
        _S155 = 0.0f;
    }
    else
    {
        _S155 = (p_0 * _S153 * _S153 + _S153 + 1.0f) * _S154;
    }
    return _S155;
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S156 : u32 = scene_words_0[index_0];
    var _S157 : vec3<f32> = vec3<f32>(f32((_S156 & (u32(1023)))), f32((((_S156 >> (u32(10)))) & (u32(1023)))), f32((_S156 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S157 * _S157;
}

fn map_level_0( first_19 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S158 : f32 = uv_0.x;
    var _S159 : f32 = f32(side_0);
    var _S160 : f32 = (_S158 - floor(_S158)) * _S159 - 0.5f;
    var _S161 : f32 = uv_0.y;
    var _S162 : f32 = (_S161 - floor(_S161)) * _S159 - 0.5f;
    var _S163 : f32 = floor(_S160);
    var _S164 : i32 = i32(side_0);
    var _S165 : u32 = side_0 - u32(1);
    var _S166 : u32 = (u32(i32(_S163) + _S164) & (_S165));
    var _S167 : f32 = floor(_S162);
    var _S168 : u32 = (u32(i32(_S167) + _S164) & (_S165));
    var _S169 : u32 = ((_S166 + u32(1)) & (_S165));
    var _S170 : u32 = first_19 + _S168 * side_0;
    var _S171 : vec3<f32> = vec3<f32>((_S160 - _S163));
    var _S172 : u32 = first_19 + (((_S168 + u32(1)) & (_S165))) * side_0;
    return mix(mix(map_texel_0(_S170 + _S166), map_texel_0(_S170 + _S169), _S171), mix(map_texel_0(_S172 + _S166), map_texel_0(_S172 + _S169), _S171), vec3<f32>((_S162 - _S167)));
}

struct VisiblePoint_0
{
     position_0 : vec3<f32>,
     view_1 : vec3<f32>,
     axis_x_0 : vec3<f32>,
     axis_y_0 : vec3<f32>,
     normal_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     uv_1 : vec2<f32>,
     draft_per_uv_0 : vec2<f32>,
     draft_0 : vec2<f32>,
     draft_dx_0 : vec2<f32>,
     draft_dy_0 : vec2<f32>,
};

fn to_local_0( point_0 : VisiblePoint_0,  direction_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn row_of_taps_0( footprint_0 : Footprint_0) -> vec3<f32>
{
    var _S173 : f32 = footprint_0.dx_0.x;
    var _S174 : f32 = footprint_0.dy_0.x;
    var _S175 : f32 = _S173 * _S173 + _S174 * _S174;
    var _S176 : f32 = footprint_0.dx_0.y;
    var _S177 : f32 = footprint_0.dy_0.y;
    var _S178 : f32 = _S176 * _S176 + _S177 * _S177;
    var _S179 : f32 = _S173 * _S176 + _S174 * _S177;
    var _S180 : f32 = 0.5f * (_S175 - _S178);
    var _S181 : f32 = 0.5f * (_S175 + _S178);
    var _S182 : f32 = sqrt(_S180 * _S180 + _S179 * _S179);
    var _S183 : f32 = _S181 + _S182;
    var _S184 : f32 = max(_S183 - 1.5f * max(_S181 - _S182, 0.0f), 0.0f);
    var _S185 : f32 = square_1(4.0f);
    var _S186 : f32 = max(_S181 - 0.5f * _S184, _S183 / _S185);
    var _S187 : f32 = sqrt(max(min(_S184, _S183 - _S186), 0.0f) / (_S185 - 1.0f));
    var _S188 : f32 = _S180 / max(_S182, 1.00000000317107685e-30f);
    var _S189 : f32 = sqrt(max(0.5f * (1.0f - _S188), 0.0f));
    var _S190 : f32 = sqrt(_S186);
    var _S191 : f32 = _S187 * sqrt(max(0.5f * (1.0f + _S188), 0.0f));
    var _S192 : f32;
    if(_S179 < 0.0f)
    {
        _S192 = - _S187 * _S189;
    }
    else
    {
        _S192 = _S187 * _S189;
    }
    return vec3<f32>(_S190, _S191, _S192);
}

struct AnisotropicTaps_0
{
     centre_1 : vec2<f32>,
     side_1 : f32,
     first_20 : vec2<f32>,
     second_0 : vec2<f32>,
};

fn AnisotropicTaps_size_0( this_2 : AnisotropicTaps_0) -> f32
{
    var _S193 : f32 = this_2.first_20.x;
    var _S194 : f32 = this_2.second_0.x;
    var _S195 : f32 = this_2.side_1;
    var _S196 : f32 = _S195 * _S195;
    var _S197 : f32 = this_2.first_20.y;
    var _S198 : f32 = this_2.second_0.y;
    var _S199 : f32 = 12.0f * (_S193 * _S197 + _S194 * _S198);
    return sqrt(sqrt(max((12.0f * (_S193 * _S193 + _S194 * _S194) + _S196) * (12.0f * (_S197 * _S197 + _S198 * _S198) + _S196) - _S199 * _S199, square_1(_S196))));
}

fn footprint_coordinates_0( taps_0 : AnisotropicTaps_0) -> vec3<f32>
{
    return vec3<f32>(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S200 : vec2<f32> = direction_1.xy;
    var _S201 : f32;
    if(back_2)
    {
        _S201 = - direction_1.z;
    }
    else
    {
        _S201 = direction_1.z;
    }
    return vec3<f32>(_S200, _S201);
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn wrapped_0( index_2 : f32,  count_1 : f32) -> f32
{
    var _S202 : f32;
    if(index_2 < 0.0f)
    {
        _S202 = index_2 + count_1;
    }
    else
    {
        if(index_2 >= count_1)
        {
            _S202 = index_2 - count_1;
        }
        else
        {
            _S202 = index_2;
        }
    }
    return _S202;
}

fn AnisotropicTaps_has_steps_0( this_3 : AnisotropicTaps_0) -> bool
{
    var _S203 : vec2<f32> = this_3.first_20;
    var _S204 : vec2<f32> = this_3.second_0;
    return (max(dot(_S203, _S203), dot(_S204, _S204))) > 0.0f;
}

fn AnisotropicTaps_place_0( this_4 : AnisotropicTaps_0,  number_0 : u32) -> vec2<f32>
{
    var _S205 : f32;
    if(number_0 >= u32(2))
    {
        _S205 = 1.0f;
    }
    else
    {
        _S205 = -1.0f;
    }
    var _S206 : f32;
    if(((number_0 & (u32(1)))) != u32(0))
    {
        _S206 = 1.0f;
    }
    else
    {
        _S206 = -1.0f;
    }
    return this_4.centre_1 + vec2<f32>(_S205) * this_4.first_20 + vec2<f32>(_S206) * this_4.second_0;
}

fn bump_0( distance_0 : f32) -> f32
{
    var _S207 : f32 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S207 * _S207;
}

fn correction_weight_of_0( coded_size_0 : f32) -> f32
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

fn turns_and_remainder_0( family_0 : u32,  index_3 : f32) -> vec2<f32>
{
    var _S208 : f32 = floor(fma(index_3, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S208, fma(- _S208, families_0[family_0].count_0, index_3));
}

struct Cell_0
{
     thread_0 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S209 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S210 : f32 = fma(- _S209, families_0[family_1].size_0, position_1);
    cell_0.below_0 = _S210;
    cell_0.above_0 = families_0[family_1].size_0 - _S210;
    cell_0.across_0 = _S210 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S209).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S211 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S212 : u32;
    if(_S211 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S212 = u32(1);
    }
    else
    {
        _S212 = u32(0);
    }
    var _S213 : u32 = min(thread_1 + _S212, u32(families_0[family_2].count_0) - u32(1));
    var _S214 : u32 = families_0[family_2].place_table_0 + _S213 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S213;
    cell_1.below_0 = _S211 - table_number_0(_S214);
    cell_1.above_0 = table_number_0(_S214 + u32(1)) - _S211;
    cell_1.across_0 = _S211 - table_number_0(_S214 + u32(2));
    cell_1.half_width_1 = table_number_0(_S214 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_3 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct Bound_0
{
     thread_2 : u32,
     turns_2 : f32,
     cell_2 : f32,
     visible_0 : f32,
     width_2 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_4 : u32,  position_4 : f32) -> Bound_0
{
    var _S215 : Cell_0 = locate_0(family_4, position_4);
    var _S216 : f32 = table_number_0(families_0[family_4].before_0 + u32(2) * _S215.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_2 = _S215.thread_0;
    bound_0.turns_2 = round((position_4 - families_0[family_4].start_0 - _S216 - _S215.below_0) * families_0[family_4].inverse_period_0);
    bound_0.cell_2 = _S215.below_0;
    var _S217 : f32 = 2.0f * _S215.half_width_1;
    bound_0.width_2 = _S217;
    bound_0.visible_0 = clamp((_S215.across_0 + _S215.half_width_1) / _S217, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S215.below_0, _S215.below_0 - _S215.across_0 - _S215.half_width_1) + max(_S215.across_0 - _S215.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_7 : Bound_0,
     high_7 : Bound_0,
};

fn stretch_of_0( family_5 : u32,  centre_2 : f32,  size_1 : f32) -> Stretch_0
{
    var _S218 : f32 = centre_2 - floor((centre_2 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    var _S219 : f32 = 0.5f * max(size_1, families_0[family_5].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_7 = bound_at_0(family_5, _S218 - _S219);
    stretch_0.high_7 = bound_at_0(family_5, _S218 + _S219);
    return stretch_0;
}

fn table_colour_0( index_4 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_4), table_number_0(index_4 + u32(1)), table_number_0(index_4 + u32(2)));
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn table_albedos_0( row_6 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_6);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_6 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_6 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_6 + u32(9));
    return albedos_0;
}

fn Stretch_turns_0( this_5 : Stretch_0) -> f32
{
    return this_5.high_7.turns_2 - this_5.low_7.turns_2;
}

fn lengths_0( family_6 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S220 : f32 = Stretch_turns_0(stretch_1);
    var _S221 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.low_7.thread_2;
    var _S222 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.high_7.thread_2;
    var _S223 : f32 = table_number_0(_S222) - table_number_0(_S221);
    var _S224 : f32 = table_number_0(_S222 + u32(1)) - table_number_0(_S221 + u32(1));
    return vec3<f32>(_S223 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_2 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_2 + _S220 * families_0[family_6].visible_total_0, _S224 - _S223 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S220 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S224 + stretch_1.high_7.cell_2 - stretch_1.low_7.cell_2 + _S220 * families_0[family_6].period_0);
}

fn integrals_along_0( family_7 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S225 : u32 = u32(3) * families_0[family_7].quantities_0;
    var _S226 : u32 = families_0[family_7].colour_threads_0 + _S225 * stretch_2.low_7.thread_2 + quantity_0;
    var _S227 : u32 = families_0[family_7].colour_threads_0 + _S225 * stretch_2.high_7.thread_2 + quantity_0;
    var _S228 : u32 = families_0[family_7].colour_threads_0 + _S225 * u32(families_0[family_7].count_0) + quantity_0;
    var _S229 : f32 = table_number_0(_S226);
    var _S230 : f32 = table_number_0(_S227);
    var _S231 : f32 = Stretch_turns_0(stretch_2);
    var _S232 : u32 = u32(2) * families_0[family_7].quantities_0;
    return vec2<f32>(table_number_0(_S227 + families_0[family_7].quantities_0) - table_number_0(_S226 + families_0[family_7].quantities_0) + _S230 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_2 - _S229 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_2 + _S231 * table_number_0(_S228 + families_0[family_7].quantities_0), table_number_0(_S227 + _S232) - table_number_0(_S226 + _S232) + _S230 * stretch_2.high_7.cell_2 - _S229 * stretch_2.low_7.cell_2 + _S231 * table_number_0(_S228 + _S232));
}

fn Stretch_wraps_0( this_6 : Stretch_0) -> bool
{
    return (this_6.high_7.thread_2) < (this_6.low_7.thread_2);
}

fn Stretch_differences_0( this_7 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S233 : u32 = entries_0.z;
    var _S234 : u32 = entries_0.x;
    var _S235 : u32 = _S233 - _S234;
    var _S236 : u32;
    if(Stretch_wraps_0(this_7))
    {
        _S236 = whole_0;
    }
    else
    {
        _S236 = u32(0);
    }
    return vec4<u32>(_S235 + _S236, entries_0.w - _S233, entries_0.y - _S234, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_7 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S237 : u32 = row_7 + across_1.low_7.thread_2 * quantities_1;
    var _S238 : u32 = row_7 + across_1.high_7.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S237], words_0[_S237 + quantities_1], words_0[_S238], words_0[_S238 + quantities_1]), words_0[row_7 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_8 : Stretch_0) -> vec4<f32>
{
    var _S239 : f32 = - this_8.low_7.visible_0;
    var _S240 : f32 = Stretch_turns_0(this_8);
    var _S241 : f32;
    if(Stretch_wraps_0(this_8))
    {
        _S241 = 1.0f;
    }
    else
    {
        _S241 = 0.0f;
    }
    return vec4<f32>(1.0f, this_8.high_7.visible_0, _S239, _S240 - _S241);
}

fn integral_on_top_0( family_8 : u32,  across_2 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S242 : u32 = u32(families_0[family_8].count_0);
    var _S243 : u32 = (_S242 + u32(1)) * families_0[family_8].quantities_0;
    var _S244 : u32 = families_0[family_8].colour_areas_0 + quantity_1;
    var _S245 : vec4<u32> = row_differences_0(across_2, _S244 + along_0.low_7.thread_2 * _S243, _S242, families_0[family_8].quantities_0);
    var _S246 : vec4<u32> = row_differences_0(across_2, _S244 + (along_0.low_7.thread_2 + u32(1)) * _S243, _S242, families_0[family_8].quantities_0);
    var _S247 : vec4<u32> = row_differences_0(across_2, _S244 + along_0.high_7.thread_2 * _S243, _S242, families_0[family_8].quantities_0);
    var _S248 : vec4<u32> = row_differences_0(across_2, _S244 + (along_0.high_7.thread_2 + u32(1)) * _S243, _S242, families_0[family_8].quantities_0);
    var _S249 : vec4<u32> = row_differences_0(across_2, _S244 + crossing_count_0 * _S243, _S242, families_0[family_8].quantities_0);
    var _S250 : vec4<u32> = _S247 - _S245;
    var _S251 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S251 = _S249;
    }
    else
    {
        _S251 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S252 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S250 + _S251)), _S252), dot(vec4<f32>(vec4<i32>(_S248 - _S247)), _S252), dot(vec4<f32>(vec4<i32>(_S246 - _S245)), _S252), dot(vec4<f32>(vec4<i32>(_S249)), _S252)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_8 : u32) -> Albedos_0
{
    var _S253 : Albedos_0 = table_albedos_0(row_8);
    var sum_0 : Albedos_0;
    var _S254 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S254 * _S253.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S254 * _S253.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S254 * _S253.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S254 * _S253.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_9 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S255 : vec3<f32> = lengths_0(crossing_0, other_0);
    var is_exposed_0 : bool = false;
    var weight_1 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_9].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S256 : vec2<f32> = integrals_along_0(family_9, own_0, quantity_2);
        var _S257 : f32 = integral_on_top_0(family_9, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S258 : f32 = _S256.x;
        var _S259 : f32 = _S258 * _S255.x;
        var _S260 : f32;
        if(back_3)
        {
            _S260 = _S259 - _S257;
        }
        else
        {
            _S260 = _S257;
        }
        var _S261 : bool = quantity_2 == u32(0);
        if(_S261)
        {
            is_exposed_0 = _S260 > (16.0f * families_0[family_9].area_unit_0 * min(_S259 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S259);
        }
        var _S262 : f32 = _S258 * _S255.y;
        var _S263 : f32;
        if(is_exposed_0)
        {
            _S263 = _S260;
        }
        else
        {
            _S263 = 0.0f;
        }
        var _S264 : f32 = _S262 + _S263 + 0.000244140625f * _S255.z * _S256.y;
        if(_S261)
        {
            weight_1 = 1.0f / max(_S264, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S264 * weight_1, families_0[family_9].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S265 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S266 : u32 = ((((_S265 >> ((((_S265 >> (u32(28)))) + u32(4))))) ^ (_S265))) * u32(277803737);
    return (((_S266 >> (u32(22)))) ^ (_S266));
}

fn hash_key_0( thread_3 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_3 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_3 : u32) -> u32
{
    return scramble_0(cell_3 + key_0);
}

fn uniform_hash_0( thread_4 : u32,  cell_4 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_4, stream_1), cell_4)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_5 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S267 : u32 = pixel_0.x;
    var _S268 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S267, _S268, stream_2), uniform_hash_0(_S267, _S268, stream_2 + u32(1))) + vec2<f32>(f32((index_5 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_6 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_6])));
}

struct Choice_0
{
     index_7 : u32,
     remainder_0 : f32,
};

fn choose_0( table_0 : u32,  count_3 : u32,  number_1 : f32) -> Choice_0
{
    var high_8 : u32 = count_3;
    var low_8 : u32 = u32(0);
    for(;;)
    {
        if((high_8 - low_8) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S269 : u32 = (low_8 + high_8) / u32(2);
        if((scene_number_0(table_0 + _S269)) <= number_1)
        {
            low_8 = _S269;
        }
        else
        {
            high_8 = _S269;
        }
    }
    var _S270 : u32 = table_0 + low_8;
    var _S271 : f32 = scene_number_0(_S270);
    var _S272 : f32 = scene_number_0(_S270 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_7 = low_8;
    choice_0.remainder_0 = saturate((number_1 - _S271) / max(_S272 - _S271, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_9 : f32) -> vec2<f32>
{
    var _S273 : f32 = floor(x_9 * 0.63661974668502808f + 0.5f);
    var _S274 : f32 = x_9 - _S273 * 1.5703125f - _S273 * 0.00048375129699707f - _S273 * 7.54979012640433211e-08f;
    var _S275 : f32 = _S274 * _S274;
    var _S276 : f32 = ((-0.00019515295571182f * _S275 + 0.00833216123282909f) * _S275 - 0.16666655242443085f) * _S275 * _S274 + _S274;
    var _S277 : f32 = ((0.00002443315679557f * _S275 - 0.00138873164542019f) * _S275 + 0.04166664555668831f) * _S275 * _S275 - 0.5f * _S275 + 1.0f;
    var _S278 : u32 = (u32(i32(_S273)) & (u32(3)));
    var _S279 : vec2<f32>;
    if(((_S278 & (u32(1)))) != u32(0))
    {
        _S279 = vec2<f32>(_S277, _S276);
    }
    else
    {
        _S279 = vec2<f32>(_S276, _S277);
    }
    var _S280 : f32;
    if(((_S278 & (u32(2)))) != u32(0))
    {
        _S280 = - _S279.x;
    }
    else
    {
        _S280 = _S279.x;
    }
    var _S281 : f32;
    if((((_S278 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S281 = - _S279.y;
    }
    else
    {
        _S281 = _S279.y;
    }
    return vec2<f32>(_S280, _S281);
}

fn unmapped_0( output_9 : f32,  scale_0 : f32) -> f32
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

fn mirrored_bundle_0( bundle_0 : u32) -> u32
{
    var _S282 : u32 = bundle_0 / u32(3);
    var _S283 : u32 = bundle_0 % u32(3);
    var _S284 : u32;
    if(bundle_0 == u32(24))
    {
        _S284 = bundle_0;
    }
    else
    {
        _S284 = _S282 * u32(3) + u32(3) - u32(1) - _S283;
    }
    return _S284;
}

fn light_visibility_of_0( diffuse_0 : f32,  light_1 : vec3<f32>,  view_2 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S285 : f32 = max(abs(light_1.z), 0.00100000004749745f);
    var _S286 : vec2<f32> = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S285, (0.59700000286102295f * _S285 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S286, view_2.xy) * rsqrt_0(max(dot(_S286, _S286), 9.99999997475242708e-07f))) + 1.0f), blend_0);
}

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

fn no_blocked_0() -> Blocked_0
{
    var nothing_0 : Blocked_0;
    nothing_0.by_warp_0 = 0.0f;
    nothing_0.by_weft_0 = 0.0f;
    nothing_0.far_0 = 0.0f;
    return nothing_0;
}

struct CloseUp_0
{
     weight_2 : f32,
     warp_1 : Blocked_0,
     weft_1 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_1 : CloseUp_0;
    nothing_1.weight_2 = 0.0f;
    var _S287 : Blocked_0 = no_blocked_0();
    nothing_1.warp_1 = _S287;
    nothing_1.weft_1 = _S287;
    return nothing_1;
}

fn tinted_0( albedos_3 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
     warp_2 : vec3<f32>,
     weft_2 : vec3<f32>,
     mean_1 : vec3<f32>,
     leaked_0 : vec3<f32>,
};

struct FaceSends_0
{
     sky_warp_0 : vec3<f32>,
     sky_weft_0 : vec3<f32>,
     crossing_warp_0 : vec3<f32>,
     crossing_weft_0 : vec3<f32>,
     open_0 : f32,
     blocks_warp_0 : f32,
     blocks_weft_0 : f32,
};

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_0 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S288 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S289 : vec3<f32> = sends_0.sky_warp_0 + _S288 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S289;
    var _S290 : vec3<f32> = sends_0.sky_weft_0 + _S288 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S290;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S289 + vec3<f32>(sends_0.blocks_weft_0) * _S290;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_3 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S291 : f32 = 1.0f - view_3.z;
    var _S292 : f32 = _S291 * _S291;
    (*terms_0)[i32(0)] = 1.0f;
    var _S293 : f32 = view_3.x;
    var _S294 : f32 = _S293 * _S293;
    var _S295 : f32 = view_3.y;
    var _S296 : f32 = _S295 * _S295;
    (*terms_0)[i32(1)] = sqrt(max(_S294 + _S296, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S292;
    (*terms_0)[i32(3)] = _S292 * _S292;
    (*terms_0)[i32(4)] = _S294 - _S296;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_4 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S297 : f32 = 1.0f - view_4.z;
    var _S298 : f32 = _S297 * _S297;
    (*terms_1)[i32(0)] = 1.0f;
    var _S299 : f32 = view_4.x;
    var _S300 : f32 = _S299 * _S299;
    var _S301 : f32 = view_4.y;
    var _S302 : f32 = _S301 * _S301;
    (*terms_1)[i32(1)] = sqrt(max(_S300 + _S302, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S298;
    (*terms_1)[i32(3)] = _S298 * _S298;
    (*terms_1)[i32(4)] = _S300 - _S302;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

fn scaled_0( blocked_0 : Blocked_0,  share_1 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_1 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_1 * blocked_0.by_weft_0;
    result_1.far_0 = share_1 * blocked_0.far_0;
    return result_1;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Scattered_0
{
     back_4 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_3 : vec3<f32>,
     weft_3 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S303 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S304 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_3) + _S304 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S304 * interior_0.far_1 + yarn_0.back_4 * _S303;
    return bounced_0;
}

fn sum_of_0( first_21 : Bounced_0,  second_1 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_21.reflected_0 + second_1.reflected_0;
    sum_1.transmitted_0 = first_21.transmitted_0 + second_1.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_2 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S305 : f32 = light_2.z;
    var _S306 : vec3<f32>;
    if((_S305 * view_5.z) < 0.0f)
    {
        _S306 = bounced_1.transmitted_0;
    }
    else
    {
        _S306 = bounced_1.reflected_0;
    }
    return _S306 * vec3<f32>((abs(_S305) * 0.31830987334251404f));
}

fn sheen_scale_0( x_10 : f32,  y_2 : f32) -> f32
{
    return (((((0.0f * x_10 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_10 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_10 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_10 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_10 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_10 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

fn sheen_shear_0( x_11 : f32,  y_3 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_11 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_11 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_11 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_11 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_12 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_12 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_12 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_12 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_12 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_12 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_1 : f32) -> vec3<f32>
{
    var _S307 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S308 : f32 = 2.0f * sqrt(_S307) - 1.0f;
    var _S309 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S308, _S309), 0.00999999977648258f, 1.0f), clamp((1.0f - _S307) * sheen_shear_0(_S308, _S309), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S308, _S309), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_6 : vec3<f32>,  scale_1 : f32,  shear_0 : f32) -> f32
{
    var _S310 : f32 = light_3.z;
    var _S311 : bool;
    if(_S310 <= 0.0f)
    {
        _S311 = true;
    }
    else
    {
        _S311 = (view_6.z) <= 0.0f;
    }
    if(_S311)
    {
        return 0.0f;
    }
    var _S312 : vec2<f32> = view_6.xy;
    var _S313 : f32 = dot(_S312, _S312);
    var _S314 : vec2<f32>;
    if(_S313 > 9.99999968265522539e-21f)
    {
        _S314 = _S312 * vec2<f32>(rsqrt_0(_S313));
    }
    else
    {
        _S314 = vec2<f32>(1.0f, 0.0f);
    }
    var _S315 : f32 = scale_1 * dot(light_3.xy, _S314) + shear_0 * _S310;
    var _S316 : f32 = scale_1 * (light_3.y * _S314.x - light_3.x * _S314.y);
    var _S317 : f32 = _S315 * _S315 + _S316 * _S316 + _S310 * _S310;
    return 0.31830987334251404f * scale_1 * scale_1 * _S310 / max(_S317 * _S317, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_2 : f32) -> vec2<f32>
{
    var _S318 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_2);
    var _S319 : f32 = strength_0 * _S318.z;
    return vec2<f32>(_S319 * transformed_cosine_0(light_4, view_7, _S318.x, _S318.y), 1.0f - _S319);
}

fn accumulate_0( index_8 : u32,  light_5 : vec4<f32>)
{
    var _S320 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_5;
    layers_0[index_8].share_0 = _S320 * (1.0f - light_5.w);
    return;
}

fn camera_right_0( _S321 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S321].right_x_0, frames_0[_S321].right_y_0, frames_0[_S321].right_z_0);
}

fn camera_up_0( _S322 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S322].up_x_0, frames_0[_S322].up_y_0, frames_0[_S322].up_z_0);
}

fn camera_forward_0( _S323 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S323].forward_x_0, frames_0[_S323].forward_y_0, frames_0[_S323].forward_z_0);
}

fn camera_origin_0( _S324 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S324].origin_x_0, frames_0[_S324].origin_y_0, frames_0[_S324].origin_z_0);
}

fn face_point_0( _S325 : u32,  _S326 : u32,  _S327 : f32,  _S328 : f32) -> VisiblePoint_0
{
    var _S329 : u32 = u32(3) * _S326;
    var _S330 : Vertex_std430_0 = vertices_0[corners_0[_S329]];
    var _S331 : Vertex_std430_0 = vertices_0[corners_0[_S329 + u32(1)]];
    var _S332 : Vertex_std430_0 = vertices_0[corners_0[_S329 + u32(2)]];
    var _S333 : vec3<f32> = position_of_0(&(_S331));
    var _S334 : vec3<f32> = position_of_0(&(_S330));
    var _S335 : vec3<f32> = _S333 - _S334;
    var _S336 : vec3<f32> = position_of_0(&(_S332));
    var _S337 : vec3<f32> = _S336 - _S334;
    var _S338 : f32 = _S330.u_0;
    var _S339 : f32 = _S331.u_0 - _S330.u_0;
    var _S340 : f32 = _S330.v_0;
    var _S341 : f32 = _S331.v_0 - _S330.v_0;
    var _S342 : vec2<f32> = vec2<f32>(_S339, _S341);
    var _S343 : f32 = _S332.u_0 - _S330.u_0;
    var _S344 : f32 = _S332.v_0 - _S330.v_0;
    var _S345 : vec2<f32> = vec2<f32>(_S343, _S344);
    var _S346 : f32;
    if((_S339 * _S344 - _S341 * _S343) < 0.0f)
    {
        _S346 = -1.0f;
    }
    else
    {
        _S346 = 1.0f;
    }
    var _S347 : vec3<f32> = vec3<f32>(_S346) * (vec3<f32>(_S344) * _S335 - vec3<f32>(_S341) * _S337);
    var _S348 : vec3<f32> = vec3<f32>(_S346) * (vec3<f32>(_S339) * _S337 - vec3<f32>(_S343) * _S335);
    var point_1 : VisiblePoint_0;
    var _S349 : f32 = 1.0f - _S327 - _S328;
    var _S350 : vec3<f32> = normal_of_0(&(_S330));
    var _S351 : vec3<f32> = vec3<f32>(_S349) * _S350;
    var _S352 : vec3<f32> = normal_of_0(&(_S331));
    var _S353 : vec3<f32> = vec3<f32>(_S327);
    var _S354 : vec3<f32> = _S351 + _S353 * _S352;
    var _S355 : vec3<f32> = normal_of_0(&(_S332));
    var _S356 : vec3<f32> = vec3<f32>(_S328);
    var _S357 : vec3<f32> = normalize(_S354 + _S356 * _S355);
    point_1.normal_0 = _S357;
    var _S358 : vec3<f32> = normalize(_S347 - _S357 * vec3<f32>(dot(_S357, _S347)));
    point_1.axis_x_0 = _S358;
    point_1.axis_y_0 = cross(_S357, _S358);
    var _S359 : vec3<f32> = normalize(cross(_S335, _S337));
    var _S360 : vec3<f32>;
    if((dot(_S359, _S357)) < 0.0f)
    {
        _S360 = (vec3<f32>(0) - _S359);
    }
    else
    {
        _S360 = _S359;
    }
    point_1.face_normal_0 = _S360;
    point_1.position_0 = _S334 + _S353 * _S335 + _S356 * _S337;
    point_1.view_1 = point_1.normal_0;
    point_1.uv_1 = vec2<f32>(_S338, _S340) + vec2<f32>(_S327) * _S342 + vec2<f32>(_S328) * _S345;
    var _S361 : bool = (dot(cross(_S347, _S348), point_1.normal_0)) < 0.0f;
    var _S362 : f32 = fabrics_0[_S325].uv_width_0;
    if(_S361)
    {
        _S346 = - fabrics_0[_S325].uv_height_0;
    }
    else
    {
        _S346 = fabrics_0[_S325].uv_height_0;
    }
    var _S363 : vec2<f32> = vec2<f32>(_S362, _S346);
    point_1.draft_per_uv_0 = _S363;
    var _S364 : vec2<f32> = point_1.uv_1 * _S363;
    if(_S361)
    {
        _S346 = fabrics_0[_S325].uv_height_0;
    }
    else
    {
        _S346 = 0.0f;
    }
    point_1.draft_0 = _S364 + vec2<f32>(0.0f, _S346);
    var _S365 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S365;
    point_1.draft_dy_0 = _S365;
    return point_1;
}

fn visible_point_0( _S366 : i32,  _S367 : u32,  _S368 : u32,  _S369 : vec2<u32>) -> VisiblePoint_0
{
    var _S370 : u32 = u32(3) * _S368;
    var _S371 : Vertex_std430_0 = vertices_0[corners_0[_S370]];
    var _S372 : Vertex_std430_0 = vertices_0[corners_0[_S370 + u32(1)]];
    var _S373 : Vertex_std430_0 = vertices_0[corners_0[_S370 + u32(2)]];
    var _S374 : vec3<f32> = position_of_1(&(_S372));
    var _S375 : vec3<f32> = position_of_1(&(_S371));
    var _S376 : vec3<f32> = _S374 - _S375;
    var _S377 : vec3<f32> = position_of_1(&(_S373));
    var _S378 : vec3<f32> = _S377 - _S375;
    var _S379 : vec3<f32> = cross(_S376, _S378);
    var _S380 : f32 = 1.0f / max(square_0(_S379), 1.00000000317107685e-30f);
    var _S381 : f32 = f32(frames_0[_S366].width_0);
    var _S382 : vec3<f32> = camera_right_0(_S366) * vec3<f32>((2.0f / _S381));
    var _S383 : f32 = f32(frames_0[_S366].height_0);
    var _S384 : vec3<f32> = camera_up_0(_S366) * vec3<f32>((-2.0f / _S383));
    var _S385 : vec3<f32> = camera_forward_0(_S366) + vec3<f32>((f32(_S369.x) + 0.5f - 0.5f * _S381)) * _S382 + vec3<f32>((f32(_S369.y) + 0.5f - 0.5f * _S383)) * _S384;
    var _S386 : f32 = dot(_S385, _S379);
    var _S387 : f32;
    if((abs(_S386)) > 1.00000000317107685e-30f)
    {
        _S387 = _S386;
    }
    else
    {
        _S387 = 1.00000000317107685e-30f;
    }
    var _S388 : f32 = 1.0f / _S387;
    var _S389 : vec3<f32> = _S375 - camera_origin_0(_S366);
    var _S390 : vec3<f32> = vec3<f32>((dot(_S389, _S379) * _S388));
    var _S391 : vec3<f32> = _S385 * _S390 - _S389;
    var _S392 : vec3<f32> = _S390 * (_S382 - _S385 * vec3<f32>((dot(_S382, _S379) * _S388)));
    var _S393 : vec3<f32> = _S390 * (_S384 - _S385 * vec3<f32>((dot(_S384, _S379) * _S388)));
    var _S394 : vec3<f32> = vec3<f32>(_S380);
    var _S395 : vec3<f32> = cross(_S378, _S379) * _S394;
    var _S396 : vec3<f32> = cross(_S379, _S376) * _S394;
    var _S397 : vec2<f32> = vec2<f32>(_S372.u_0 - _S371.u_0, _S372.v_0 - _S371.v_0);
    var _S398 : vec2<f32> = vec2<f32>(_S373.u_0 - _S371.u_0, _S373.v_0 - _S371.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S367, _S368, dot(_S391, _S395), dot(_S391, _S396));
    point_2.position_0 = _S375 + _S391;
    point_2.view_1 = (vec3<f32>(0) - normalize(_S385));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S392, _S395)) * _S397 + vec2<f32>(dot(_S392, _S396)) * _S398) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S393, _S395)) * _S397 + vec2<f32>(dot(_S393, _S396)) * _S398) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S399 : u32,  _S400 : VisiblePoint_0) -> vec3<f32>
{
    var _S401 : u32 = fabrics_0[_S399].albedo_map_levels_0;
    if((fabrics_0[_S399].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S402 : vec2<f32> = vec2<f32>(fabrics_0[_S399].uv_width_0, fabrics_0[_S399].uv_height_0);
    var _S403 : vec2<f32> = _S400.draft_dx_0 / _S402;
    var _S404 : vec2<f32> = _S400.draft_dy_0 / _S402;
    var _S405 : u32 = _S401 - u32(1);
    var _S406 : u32 = (u32(1) << (_S405));
    var _S407 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S403.x * _S404.y - _S403.y * _S404.x), 9.99999968265522539e-21f) * (square_1(f32(_S406)) / 3.0f)), 0.0f, f32(_S401) - 1.0f);
    var _S408 : u32 = min(u32(_S407), max(_S401, u32(2)) - u32(2));
    var _S409 : u32 = min(_S408 + u32(1), _S405);
    var _S410 : u32 = (u32(1) << ((u32(2) * _S401)));
    return mix(map_level_0(fabrics_0[_S399].albedo_map_0 + (_S410 - ((_S410 >> ((u32(2) * _S408))))) / u32(3), (_S406 >> (_S408)), _S400.uv_1), map_level_0(fabrics_0[_S399].albedo_map_0 + (_S410 - ((_S410 >> ((u32(2) * _S409))))) / u32(3), (_S406 >> (_S409)), _S400.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S407 - f32(_S408))) - 1.0f) / 3.0f)));
}

struct NeuralView_0
{
     sums_7 : array<f32, i32(96)>,
     hole_0 : f32,
     correction_weight_0 : f32,
     view_8 : vec3<f32>,
     back_5 : bool,
};

fn anisotropic_taps_0( _S411 : u32,  _S412 : Footprint_0) -> AnisotropicTaps_0
{
    var _S413 : vec3<f32> = row_of_taps_0(_S412);
    var _S414 : vec2<f32> = _S412.dx_0;
    var _S415 : vec2<f32> = _S412.dy_0;
    var _S416 : f32 = dot(_S414, _S414) + dot(_S415, _S415);
    var _S417 : f32 = _S412.dx_0.x * _S412.dy_0.y - _S412.dx_0.y * _S412.dy_0.x;
    var _S418 : f32 = 0.5f * (_S416 + sqrt(max(_S416 * _S416 - 4.0f * _S417 * _S417, 0.0f)));
    var _S419 : Neural_std430_0 = fabrics_0[_S411].neural_0;
    var _S420 : bool;
    if(_S418 < (5.5f * (_S416 - _S418)))
    {
        _S420 = _S416 > (8.0f * _S419.pitch_0 * _S419.pitch_0);
    }
    else
    {
        _S420 = false;
    }
    var _S421 : vec2<f32> = vec2<f32>(_S419.ends_per_mm_0, _S419.picks_per_mm_0);
    var taps_1 : AnisotropicTaps_0;
    taps_1.centre_1 = _S412.centre_0 * _S421;
    var _S422 : f32;
    if(_S420)
    {
        _S422 = sqrt(0.125f * _S416);
    }
    else
    {
        _S422 = _S413.x;
    }
    taps_1.side_1 = _S422 / _S419.pitch_0;
    var _S423 : vec2<f32>;
    if(_S420)
    {
        _S423 = vec2<f32>(0.25f) * _S412.dx_0;
    }
    else
    {
        _S423 = _S413.yz;
    }
    taps_1.first_20 = _S423 * _S421;
    if(_S420)
    {
        _S423 = vec2<f32>(0.25f) * _S412.dy_0;
    }
    else
    {
        _S423 = vec2<f32>(0.5f) * _S413.yz;
    }
    taps_1.second_0 = _S423 * _S421;
    return taps_1;
}

fn add_texel_0( _S424 : u32,  _S425 : u32,  _S426 : f32,  _S427 : ptr<function, array<f32, i32(88)>>)
{
    var _S428 : u32 = fabrics_0[_S424].neural_0.latents_0 + _S425 * u32(8);
    var part_0 : u32 = u32(0);
    for(;;)
    {
        if(part_0 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S429 : Eight_0 = eight_halves_0(packed_numbers_0[_S428 + part_0]);
        var _S430 : i32 = i32(u32(8) * part_0);
        (*_S427)[_S430] = (*_S427)[_S430] + _S426 * _S429.low_0[i32(0)];
        (*_S427)[_S430 + i32(4)] = (*_S427)[_S430 + i32(4)] + _S426 * _S429.high_0[i32(0)];
        var _S431 : i32 = _S430 + i32(1);
        (*_S427)[_S431] = (*_S427)[_S431] + _S426 * _S429.low_0[i32(1)];
        (*_S427)[_S431 + i32(4)] = (*_S427)[_S431 + i32(4)] + _S426 * _S429.high_0[i32(1)];
        var _S432 : i32 = _S430 + i32(2);
        (*_S427)[_S432] = (*_S427)[_S432] + _S426 * _S429.low_0[i32(2)];
        (*_S427)[_S432 + i32(4)] = (*_S427)[_S432 + i32(4)] + _S426 * _S429.high_0[i32(2)];
        var _S433 : i32 = _S430 + i32(3);
        (*_S427)[_S433] = (*_S427)[_S433] + _S426 * _S429.low_0[i32(3)];
        (*_S427)[_S433 + i32(4)] = (*_S427)[_S433 + i32(4)] + _S426 * _S429.high_0[i32(3)];
        part_0 = part_0 + u32(1);
    }
    return;
}

fn add_level_0( _S434 : u32,  _S435 : u32,  _S436 : bool,  _S437 : vec2<f32>,  _S438 : f32,  _S439 : ptr<function, array<f32, i32(88)>>)
{
    var _S440 : Neural_std430_0 = fabrics_0[_S434].neural_0;
    var _S441 : u32 = fabrics_0[_S434].neural_0.levels_1 + u32(4) * _S435;
    var _S442 : f32 = table_number_0(_S441);
    var _S443 : f32 = table_number_0(_S441 + u32(1));
    var _S444 : f32 = table_number_0(_S441 + u32(2));
    var _S445 : bool;
    if(_S435 > u32(3))
    {
        _S445 = _S435 < (_S440.top_level_0);
    }
    else
    {
        _S445 = false;
    }
    var _S446 : vec2<f32> = _S437 * vec2<f32>(table_number_0(_S441 + u32(3)));
    var _S447 : f32;
    if(_S445)
    {
        _S447 = 1.0f;
    }
    else
    {
        _S447 = 0.5f;
    }
    var _S448 : vec2<f32> = _S446 - vec2<f32>(_S447);
    var _S449 : vec2<f32> = floor(_S448);
    var _S450 : vec2<f32> = _S448 - _S449;
    var corner_0 : u32 = u32(0);
    for(;;)
    {
        if(corner_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S451 : f32 = f32((corner_0 & (u32(1))));
        var _S452 : f32 = f32((corner_0 >> (u32(1))));
        var _S453 : vec2<f32> = mix(vec2<f32>(1.0f) - _S450, _S450, vec2<f32>(_S451, _S452));
        var _S454 : u32 = u32(_S442 + wrapped_0(_S449.y + _S452, _S444) * _S443 + wrapped_0(_S449.x + _S451, _S443));
        var _S455 : u32;
        if(_S436)
        {
            _S455 = _S440.texels_0;
        }
        else
        {
            _S455 = u32(0);
        }
        add_texel_0(_S434, _S454 + _S455, _S438 * _S453.x * _S453.y, &((*_S439)));
        corner_0 = corner_0 + u32(1);
    }
    return;
}

fn code_footprint_0( _S456 : u32,  _S457 : AnisotropicTaps_0,  _S458 : vec3<f32>,  _S459 : bool,  _S460 : ptr<function, array<f32, i32(88)>>)
{
    var offset_2 : f32;
    var k_0 : i32 = i32(0);
    for(;;)
    {
        if(k_0 < i32(64))
        {
        }
        else
        {
            break;
        }
        (*_S460)[k_0] = 0.0f;
        k_0 = k_0 + i32(1);
    }
    var _S461 : vec2<f32> = vec2<f32>(fabrics_0[_S456].neural_0.ends_0, fabrics_0[_S456].neural_0.picks_0);
    var _S462 : f32 = f32(fabrics_0[_S456].neural_0.top_level_0);
    var _S463 : f32 = clamp(binary_logarithm_0(max(_S457.side_1, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S462);
    var _S464 : f32 = min(floor(_S463), _S462 - 1.0f);
    var _S465 : u32;
    if(AnisotropicTaps_has_steps_0(_S457))
    {
        _S465 = u32(4);
    }
    else
    {
        _S465 = u32(1);
    }
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(number_2 < (u32(2) * _S465))
        {
        }
        else
        {
            break;
        }
        var _S466 : vec2<f32> = AnisotropicTaps_place_0(_S457, (number_2 >> (u32(1))));
        var _S467 : vec2<f32> = clamp(_S466 - _S461 * floor(_S466 / _S461), vec2<f32>(0.0f), _S461);
        var _S468 : bool = ((number_2 & (u32(1)))) != u32(0);
        if(_S468)
        {
            offset_2 = _S463 - _S464;
        }
        else
        {
            offset_2 = 1.0f - (_S463 - _S464);
        }
        var _S469 : f32 = offset_2 / f32(_S465);
        var _S470 : u32 = u32(_S464);
        var _S471 : u32;
        if(_S468)
        {
            _S471 = u32(1);
        }
        else
        {
            _S471 = u32(0);
        }
        add_level_0(_S456, _S470 + _S471, _S459, _S467, _S469, &((*_S460)));
        number_2 = number_2 + u32(1);
    }
    var number_3 : i32 = i32(0);
    for(;;)
    {
        if(number_3 < i32(3))
        {
        }
        else
        {
            break;
        }
        var bin_0 : i32 = i32(0);
        for(;;)
        {
            if(bin_0 < i32(8))
            {
            }
            else
            {
                break;
            }
            var offset_3 : f32 = _S458[number_3] - (f32(bin_0) + 0.5f) / 8.0f;
            if(number_3 < i32(2))
            {
                offset_2 = offset_3 - round(offset_3);
            }
            else
            {
                offset_2 = offset_3;
            }
            (*_S460)[i32(64) + number_3 * i32(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + i32(1);
        }
        number_3 = number_3 + i32(1);
    }
    return;
}

fn crown_fibres_0( _S472 : u32,  _S473 : bool,  _S474 : bool) -> vec3<f32>
{
    var _S475 : f32;
    if(_S473)
    {
        if(_S474)
        {
            _S475 = - fabrics_0[_S472].neural_0.warp_x_0;
        }
        else
        {
            _S475 = fabrics_0[_S472].neural_0.warp_x_0;
        }
        return vec3<f32>(_S475, fabrics_0[_S472].neural_0.warp_y_0, fabrics_0[_S472].neural_0.warp_roughness_0);
    }
    var _S476 : Neural_std430_0 = fabrics_0[_S472].neural_0;
    if(_S474)
    {
        _S475 = - _S476.weft_y_0;
    }
    else
    {
        _S475 = _S476.weft_y_0;
    }
    return vec3<f32>(_S476.weft_x_0, _S475, _S476.weft_roughness_0);
}

fn neural_view_0( _S477 : u32,  _S478 : Footprint_0,  _S479 : vec3<f32>,  _S480 : ptr<function, NeuralView_0>)
{
    var _S481 : bool = (_S479.z) < 0.0f;
    var _S482 : AnisotropicTaps_0 = anisotropic_taps_0(_S477, _S478);
    var _S483 : vec3<f32> = footprint_coordinates_0(_S482);
    var _S484 : vec3<f32> = to_face_frame_0(_S479, _S481);
    var weights_23 : HalfWeights_0;
    weights_23.first_2 = fabrics_0[_S477].neural_0.network_0;
    var inputs_23 : array<f32, i32(88)>;
    code_footprint_0(_S477, _S482, _S483, _S481, &(inputs_23));
    var hidden_1 : array<f32, i32(96)>;
    dense_7(weights_23, u32(0), false, &(inputs_23), &(hidden_1));
    var fused_0 : array<f32, i32(100)>;
    dense_part_8(weights_23, u32(1068), false, &(hidden_1), &(fused_0));
    fused_0[i32(96)] = _S484.x;
    fused_0[i32(97)] = _S484.y;
    var _S485 : vec2<f32> = _S484.xy;
    fused_0[i32(98)] = dot(crown_fibres_0(_S477, true, _S481).xy, _S485);
    fused_0[i32(99)] = dot(crown_fibres_0(_S477, false, _S481).xy, _S485);
    var of_hole_0 : array<f32, i32(16)>;
    dense_6(weights_23, u32(2232), false, &(fused_0), &(of_hole_0));
    var hole_1 : array<f32, i32(1)>;
    dense_5(weights_23, u32(2444), false, &(of_hole_0), &(hole_1));
    var _S486 : array<f32, i32(96)> = (*_S480).sums_7;
    dense_4(weights_23, u32(2456), false, &(fused_0), &(_S486));
    (*_S480).sums_7 = _S486;
    (*_S480).hole_0 = clamp(hole_1[i32(0)], 0.0f, 1.0f);
    (*_S480).correction_weight_0 = correction_weight_of_0(_S483.z);
    (*_S480).view_8 = _S484;
    (*_S480).back_5 = _S481;
    return;
}

struct FamilyAlbedos_0
{
     warp_4 : Albedos_0,
     weft_4 : Albedos_0,
};

fn albedos_over_0( _S487 : u32,  _S488 : Footprint_0,  _S489 : bool) -> FamilyAlbedos_0
{
    var _S490 : vec2<f32> = _S488.dx_0;
    var _S491 : vec2<f32> = _S488.dy_0;
    var _S492 : vec2<f32> = sqrt(_S490 * _S490 + _S491 * _S491);
    var _S493 : Stretch_0 = stretch_of_0(fabrics_0[_S487].warp_0, _S488.centre_0.x, _S492.x);
    var _S494 : Stretch_0 = stretch_of_0(fabrics_0[_S487].weft_0, _S488.centre_0.y, _S492.y);
    var albedos_4 : FamilyAlbedos_0;
    albedos_4.warp_4 = mean_albedos_0(fabrics_0[_S487].warp_0, fabrics_0[_S487].weft_0, _S493, _S494, _S489);
    albedos_4.weft_4 = mean_albedos_0(fabrics_0[_S487].weft_0, fabrics_0[_S487].warp_0, _S494, _S493, _S489);
    return albedos_4;
}

fn light_sample_count_0( _S495 : i32) -> u32
{
    return frames_0[_S495].lights_0 + frames_0[_S495].environment_samples_0;
}

fn visibility_at_0( _S496 : i32,  _S497 : u32,  _S498 : vec2<u32>) -> f32
{
    if((frames_0[_S496].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S497 * frames_0[_S496].height_0 + _S498.y) * frames_0[_S496].width_0 + _S498.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S499 : i32,  _S500 : u32,  _S501 : u32) -> vec3<f32>
{
    var _S502 : u32 = frames_0[_S499].environment_table_0 + frames_0[_S499].environment_rows_0 + u32(1) + frames_0[_S499].environment_rows_0 * (frames_0[_S499].environment_columns_0 + u32(1)) + u32(3) * (_S500 * frames_0[_S499].environment_columns_0 + _S501);
    return vec3<f32>(scene_number_0(_S502), scene_number_0(_S502 + u32(1)), scene_number_0(_S502 + u32(2)));
}

fn sample_environment_0( _S503 : i32,  _S504 : vec2<f32>,  _S505 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S506 : u32 = frames_0[_S503].environment_rows_0;
    var _S507 : Choice_0 = choose_0(frames_0[_S503].environment_table_0, frames_0[_S503].environment_rows_0, _S504.y);
    var _S508 : u32 = frames_0[_S503].environment_columns_0;
    var _S509 : Choice_0 = choose_0(frames_0[_S503].environment_table_0 + frames_0[_S503].environment_rows_0 + u32(1) + _S507.index_7 * (frames_0[_S503].environment_columns_0 + u32(1)), frames_0[_S503].environment_columns_0, _S504.x);
    var _S510 : vec3<f32> = environment_texel_0(_S503, _S507.index_7, _S509.index_7);
    (*_S505) = _S510 * vec3<f32>((frames_0[_S503].environment_total_0 / max(mean_0(_S510), 9.99999968265522539e-21f)));
    var _S511 : f32 = 3.14159274101257324f / f32(_S506);
    var _S512 : f32 = mix(sine_cosine_0(f32(_S507.index_7) * _S511).y, sine_cosine_0(f32(_S507.index_7 + u32(1)) * _S511).y, _S507.remainder_0);
    var _S513 : f32 = sqrt(max(1.0f - _S512 * _S512, 0.0f));
    var _S514 : vec2<f32> = sine_cosine_0((f32(_S509.index_7) + _S509.remainder_0) * (6.28318548202514648f / f32(_S508)));
    var _S515 : f32 = _S513 * _S514.x;
    var _S516 : f32 = - _S513 * _S514.y;
    return vec3<f32>(frames_0[_S503].environment_cosine_0 * _S515 + frames_0[_S503].environment_sine_0 * _S516, _S512, frames_0[_S503].environment_cosine_0 * _S516 - frames_0[_S503].environment_sine_0 * _S515);
}

fn light_sample_0( _S517 : i32,  _S518 : u32,  _S519 : vec2<u32>,  _S520 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S521 : u32 = frames_0[_S517].lights_0;
    if(_S518 >= (frames_0[_S517].lights_0))
    {
        var weight_3 : vec3<f32>;
        var _S522 : vec3<f32> = sample_environment_0(_S517, pixel_sequence_0(_S519, frames_0[_S517].pass_number_0 * frames_0[_S517].environment_samples_0 + (_S518 - _S521), u32(3)), &(weight_3));
        sample_0.towards_0 = _S522;
        sample_0.irradiance_1 = weight_3 / vec3<f32>(f32(frames_0[_S517].environment_samples_0));
        return sample_0;
    }
    var _S523 : Light_std430_0 = lights_1[_S518];
    sample_0.irradiance_1 = vec3<f32>(_S523.red_0, _S523.green_0, _S523.blue_0);
    sample_0.towards_0 = vec3<f32>(_S523.x_1, _S523.y_1, _S523.z_1);
    if((_S523.is_point_0) != u32(0))
    {
        var _S524 : vec3<f32> = sample_0.towards_0 - _S520;
        var _S525 : f32 = max(square_0(_S524), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S525);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S525);
        sample_0.towards_0 = normalize(_S524);
    }
    return sample_0;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_2 : f32,
};

fn code_light_0( _S526 : u32,  _S527 : vec3<f32>,  _S528 : vec3<f32>,  _S529 : bool,  _S530 : ptr<function, array<f32, i32(39)>>)
{
    (*_S530)[i32(0)] = _S527.x;
    (*_S530)[i32(1)] = _S527.y;
    (*_S530)[i32(2)] = _S527.z;
    var _S531 : vec3<f32> = _S527 + _S528;
    var _S532 : f32 = _S531.z;
    var _S533 : f32 = _S532 * _S532 + 0.00009999999747379f;
    var _S534 : vec2<f32> = _S531.xy;
    var _S535 : f32 = 1.0f / (dot(_S534, _S534) + _S533);
    var family_10 : i32 = i32(0);
    for(;;)
    {
        if(family_10 < i32(2))
        {
        }
        else
        {
            break;
        }
        var _S536 : vec3<f32> = crown_fibres_0(_S526, family_10 == i32(0), _S529);
        var _S537 : vec2<f32> = _S536.xy;
        (*_S530)[i32(3) + family_10] = dot(_S537, _S527.xy);
        var _S538 : f32 = dot(_S537, _S534);
        var _S539 : f32 = _S538 * _S538;
        var _S540 : f32 = (0.75f * _S538 / (0.5f * sqrt(_S539 + _S533) + abs(_S538)) + 0.5f) * 8.0f;
        var bin_1 : i32 = i32(0);
        for(;;)
        {
            if(bin_1 < i32(16))
            {
            }
            else
            {
                break;
            }
            (*_S530)[i32(5) + family_10 * i32(16) + bin_1] = bump_0(_S540 - (f32(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + i32(1);
        }
        var _S541 : f32 = _S536.z;
        var _S542 : f32 = _S541 * _S541;
        var _S543 : f32 = _S539 * _S535 * (1.0f - _S542) + _S542;
        (*_S530)[i32(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S542 * _S541 / (_S543 * _S543));
        family_10 = family_10 + i32(1);
    }
    return;
}

fn mixed_bundles_0( _S544 : u32,  _S545 : u32,  _S546 : u32,  _S547 : vec3<f32>,  _S548 : vec3<f32>,  _S549 : bool,  _S550 : ptr<function, array<f32, i32(52)>>) -> f32
{
    var _S551 : vec3<f32> = _S547 + _S548;
    var _S552 : f32 = 1.0f / (square_0(_S551) + 0.00009999999747379f);
    var _S553 : bool;
    if(_S545 == u32(0))
    {
        _S553 = _S549;
    }
    else
    {
        _S553 = false;
    }
    var _S554 : f32;
    if(_S553)
    {
        _S554 = - _S551.x;
    }
    else
    {
        _S554 = _S551.x;
    }
    if(_S545 == u32(1))
    {
        _S553 = _S549;
    }
    else
    {
        _S553 = false;
    }
    var _S555 : f32;
    if(_S553)
    {
        _S555 = - _S551.y;
    }
    else
    {
        _S555 = _S551.y;
    }
    var bundle_1 : u32 = u32(0);
    var sum_2 : f32 = 0.0f;
    for(;;)
    {
        if(bundle_1 < u32(25))
        {
        }
        else
        {
            break;
        }
        var _S556 : u32 = _S545 * u32(25);
        var _S557 : u32 = fabrics_0[_S544].neural_0.bundles_0 + u32(4) * (_S556 + bundle_1);
        var _S558 : f32 = dot(vec3<f32>(table_number_0(_S557), table_number_0(_S557 + u32(1)), table_number_0(_S557 + u32(2))), vec3<f32>(_S554, _S555, _S551.z));
        var _S559 : f32 = _S558 * _S558 * _S552 + table_number_0(_S557 + u32(3));
        var _S560 : u32 = _S546 + _S556;
        var _S561 : u32;
        if(_S549)
        {
            _S561 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S561 = bundle_1;
        }
        var sum_3 : f32 = sum_2 + max((*_S550)[_S560 + _S561], (*_S550)[_S560 + _S561] * 0.00999999977648258f) / (_S559 * _S559);
        bundle_1 = bundle_1 + u32(1);
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

fn neural_components_0( _S562 : u32,  _S563 : ptr<function, NeuralView_0>,  _S564 : vec3<f32>) -> Components_0
{
    var _S565 : f32;
    var _S566 : bool = (*_S563).back_5;
    var _S567 : vec3<f32> = to_face_frame_0(_S564, (*_S563).back_5);
    var _S568 : vec3<f32> = (*_S563).view_8;
    var weights_24 : HalfWeights_0;
    var _S569 : Neural_std430_0 = fabrics_0[_S562].neural_0;
    weights_24.first_2 = fabrics_0[_S562].neural_0.network_0;
    var directions_0 : array<f32, i32(39)>;
    code_light_0(_S562, _S567, (*_S563).view_8, (*_S563).back_5, &(directions_0));
    var skip_0 : array<f32, i32(96)>;
    var k_1 : i32 = i32(0);
    for(;;)
    {
        if(k_1 < i32(96))
        {
        }
        else
        {
            break;
        }
        skip_0[k_1] = (*_S563).sums_7[k_1];
        k_1 = k_1 + i32(1);
    }
    dense_3(weights_24, u32(3716), true, &(directions_0), &(skip_0));
    var hidden_2 : array<f32, i32(96)>;
    var next_0 : array<f32, i32(96)>;
    k_1 = i32(0);
    for(;;)
    {
        if(k_1 < i32(96))
        {
        }
        else
        {
            break;
        }
        hidden_2[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
        k_1 = k_1 + i32(1);
    }
    var layer_0 : u32 = u32(0);
    for(;;)
    {
        if(layer_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        k_1 = i32(0);
        for(;;)
        {
            if(k_1 < i32(96))
            {
            }
            else
            {
                break;
            }
            if(layer_0 == u32(1))
            {
                _S565 = skip_0[k_1];
            }
            else
            {
                _S565 = 0.0f;
            }
            next_0[k_1] = _S565;
            k_1 = k_1 + i32(1);
        }
        dense_2(weights_24, u32(4208) + layer_0 * u32(1164), true, &(hidden_2), &(next_0));
        var k_2 : i32 = i32(0);
        for(;;)
        {
            if(k_2 < i32(96))
            {
            }
            else
            {
                break;
            }
            hidden_2[k_2] = next_0[k_2];
            k_2 = k_2 + i32(1);
        }
        layer_0 = layer_0 + u32(1);
    }
    var outputs_17 : array<f32, i32(52)>;
    dense_1(weights_24, u32(7700), false, &(hidden_2), &(outputs_17));
    var _S570 : bool;
    if((_S569.is_corrected_0) != u32(0))
    {
        _S570 = (_S567.z) > 0.0f;
    }
    else
    {
        _S570 = false;
    }
    if(_S570)
    {
        _S570 = ((*_S563).correction_weight_0) > 0.0f;
    }
    else
    {
        _S570 = false;
    }
    if(_S570)
    {
        var fitted_0 : FloatWeights_0;
        fitted_0.first_0 = _S569.correction_0;
        var change_0 : array<f32, i32(50)>;
        dense_0(fitted_0, u32(0), false, &(hidden_2), &(change_0));
        k_1 = i32(0);
        for(;;)
        {
            if(k_1 < i32(50))
            {
            }
            else
            {
                break;
            }
            outputs_17[k_1 + i32(2)] = outputs_17[k_1 + i32(2)] + (*_S563).correction_weight_0 * change_0[k_1];
            k_1 = k_1 + i32(1);
        }
    }
    if((_S567.z) > 0.0f)
    {
        _S565 = 0.00999999977648258f;
    }
    else
    {
        _S565 = 0.00100000004749745f;
    }
    var result_2 : Components_0;
    var _S571 : f32 = unmapped_0(outputs_17[i32(0)], _S565);
    result_2.diffuse_warp_0 = _S571;
    var _S572 : f32 = unmapped_0(outputs_17[i32(1)], _S565);
    result_2.diffuse_weft_0 = _S572;
    var _S573 : f32 = 2979.9580078125f * _S565;
    var _S574 : f32 = mixed_bundles_0(_S562, u32(0), u32(2), _S567, _S568, _S566, &(outputs_17));
    result_2.specular_warp_0 = clamp(_S574, 0.0f, _S573);
    var _S575 : f32 = mixed_bundles_0(_S562, u32(1), u32(2), _S567, _S568, _S566, &(outputs_17));
    result_2.specular_weft_0 = clamp(_S575, 0.0f, _S573);
    result_2.hole_2 = (*_S563).hole_0;
    result_2.light_visibility_1 = min(light_visibility_of_0(_S571 + _S572, _S567, _S568, fabrics_0[_S562].diffuse_blend_0), 1.0f - (*_S563).hole_0);
    return result_2;
}

fn openness_number_0( _S576 : u32,  _S577 : u32) -> f32
{
    return table_number_0(fabrics_0[_S576].openness_0 + _S577);
}

fn scattered_by_0( _S578 : u32,  _S579 : Albedos_0,  _S580 : u32,  _S581 : vec3<f32>) -> Scattered_0
{
    var _S582 : u32 = u32(159) + u32(2) * _S580;
    var yarn_1 : Scattered_0;
    yarn_1.back_4 = _S581 * _S579.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S578, _S582)) * _S579.specular_reflect_0;
    yarn_1.through_0 = _S581 * _S579.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S578, _S582 + u32(1))) * _S579.specular_transmit_0;
    return yarn_1;
}

fn sent_0( _S583 : u32,  _S584 : u32,  _S585 : vec3<f32>,  _S586 : vec3<f32>,  _S587 : vec3<f32>,  _S588 : vec3<f32>,  _S589 : ptr<function, vec3<f32>>,  _S590 : ptr<function, vec3<f32>>)
{
    var _S591 : u32 = u32(146) + u32(4) * _S584;
    var _S592 : f32 = openness_number_0(_S583, _S591 + u32(1));
    var _S593 : f32 = openness_number_0(_S583, _S591 + u32(2));
    var _S594 : vec3<f32> = vec3<f32>(1.0f);
    var _S595 : vec3<f32> = _S594 - _S587 * vec3<f32>(openness_number_0(_S583, _S591));
    var _S596 : vec3<f32> = _S594 - _S588 * vec3<f32>(openness_number_0(_S583, _S591 + u32(3)));
    var _S597 : vec3<f32> = _S594 / (_S595 * _S596 - _S587 * _S588 * vec3<f32>((_S592 * _S593)));
    (*_S589) = (_S585 * _S596 + _S587 * vec3<f32>(_S592) * _S586) * _S597;
    (*_S590) = (_S586 * _S595 + _S588 * vec3<f32>(_S593) * _S585) * _S597;
    return;
}

fn face_sends_0( _S598 : u32,  _S599 : u32,  _S600 : Scattered_0,  _S601 : Scattered_0) -> FaceSends_0
{
    var _S602 : u32 = u32(2) * _S599;
    var _S603 : u32 = u32(142) + _S602;
    var _S604 : f32 = openness_number_0(_S598, _S603);
    var _S605 : f32 = openness_number_0(_S598, _S603 + u32(1));
    var _S606 : vec3<f32> = vec3<f32>((1.0f - _S604)) * _S600.back_4;
    var _S607 : vec3<f32> = vec3<f32>((1.0f - _S605)) * _S601.back_4;
    var sends_1 : FaceSends_0;
    var _S608 : u32 = u32(154) + _S602;
    var _S609 : f32 = openness_number_0(_S598, _S608);
    sends_1.blocks_warp_0 = _S609;
    var _S610 : f32 = openness_number_0(_S598, _S608 + u32(1));
    sends_1.blocks_weft_0 = _S610;
    sends_1.open_0 = _S609 * _S604 + _S610 * _S605;
    var _S611 : vec3<f32> = vec3<f32>(_S604) * _S600.back_4;
    var _S612 : vec3<f32> = vec3<f32>(_S605) * _S601.back_4;
    var _S613 : vec3<f32> = sends_1.sky_warp_0;
    var _S614 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S598, _S599, _S611, _S612, _S606, _S607, &(_S613), &(_S614));
    sends_1.sky_warp_0 = _S613;
    sends_1.sky_weft_0 = _S614;
    var _S615 : vec3<f32> = sends_1.crossing_warp_0;
    var _S616 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S598, _S599, _S600.through_0, _S601.through_0, _S606, _S607, &(_S615), &(_S616));
    sends_1.crossing_warp_0 = _S615;
    sends_1.crossing_weft_0 = _S616;
    return sends_1;
}

fn interior_of_0( _S617 : u32,  _S618 : vec3<f32>,  _S619 : bool) -> Interior_0
{
    var _S620 : Scattered_0 = scattered_by_0(_S617, table_albedos_0(families_0[fabrics_0[_S617].warp_0].colour_mean_0), u32(0), _S618);
    var _S621 : Scattered_0 = scattered_by_0(_S617, table_albedos_0(families_0[fabrics_0[_S617].weft_0].colour_mean_0), u32(1), _S618);
    var _S622 : u32;
    if(_S619)
    {
        _S622 = u32(1);
    }
    else
    {
        _S622 = u32(0);
    }
    var _S623 : FaceSends_0 = face_sends_0(_S617, _S622, _S620, _S621);
    if(_S619)
    {
        _S622 = u32(0);
    }
    else
    {
        _S622 = u32(1);
    }
    var _S624 : FaceSends_0 = face_sends_0(_S617, _S622, _S620, _S621);
    var _S625 : vec3<f32> = vec3<f32>(_S623.blocks_warp_0);
    var _S626 : vec3<f32> = vec3<f32>(_S623.blocks_weft_0);
    var _S627 : vec3<f32> = _S625 * _S623.crossing_warp_0 + _S626 * _S623.crossing_weft_0;
    var _S628 : vec3<f32> = vec3<f32>(_S624.blocks_warp_0);
    var _S629 : vec3<f32> = vec3<f32>(_S624.blocks_weft_0);
    var _S630 : vec3<f32> = _S628 * _S624.crossing_warp_0 + _S629 * _S624.crossing_weft_0;
    var _S631 : f32 = 1.0f - _S623.open_0;
    var _S632 : f32 = 1.0f - _S624.open_0;
    var _S633 : vec3<f32> = vec3<f32>(1.0f);
    var _S634 : vec3<f32> = _S633 / (_S633 - _S627 * _S630 * vec3<f32>((_S631 * _S632)));
    var _S635 : vec3<f32> = _S630 * (vec3<f32>(_S623.open_0) + vec3<f32>(_S631) * (_S625 * _S623.sky_warp_0 + _S626 * _S623.sky_weft_0)) * _S634;
    var _S636 : vec3<f32> = _S627 * (vec3<f32>(_S624.open_0) + vec3<f32>(_S632) * (_S628 * _S624.sky_warp_0 + _S629 * _S624.sky_weft_0)) * _S634;
    var _S637 : FaceRadiance_0 = face_radiance_0(_S623, _S624.open_0, _S635, _S636);
    var _S638 : FaceRadiance_0 = face_radiance_0(_S624, _S623.open_0, _S636, _S635);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S637.warp_2;
    interior_1.weft_3 = _S637.weft_2;
    interior_1.leaked_1 = _S637.leaked_0;
    interior_1.far_1 = _S638.mean_1;
    interior_1.far_leaked_0 = _S638.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S639 : u32,  _S640 : u32,  _S641 : array<f32, i32(6)>,  _S642 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_2 : u32 = u32(0);
    for(;;)
    {
        if(share_2 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_2] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S642)
            {
            }
            else
            {
                break;
            }
            shares_0[share_2] = shares_0[share_2] + openness_number_0(_S639, _S640 + share_2 * _S642 + term_0) * _S641[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_2] = saturate(shares_0[share_2]);
        share_2 = share_2 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_from_0( _S643 : u32,  _S644 : vec3<f32>,  _S645 : bool,  _S646 : bool) -> Blocked_0
{
    var terms_2 : array<f32, i32(6)>;
    view_terms_0(_S644, &(terms_2));
    var _S647 : u32;
    if(_S646)
    {
        _S647 = u32(2);
    }
    else
    {
        _S647 = u32(0);
    }
    var _S648 : u32;
    if(_S645)
    {
        _S648 = u32(0);
    }
    else
    {
        _S648 = u32(1);
    }
    return blocked_of_terms_0(_S643, (_S647 + _S648) * u32(15), terms_2, u32(5));
}

fn warp_seen_from_0( _S649 : u32,  _S650 : vec3<f32>,  _S651 : bool) -> f32
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_1(_S650, &(terms_3));
    var term_1 : u32 = u32(0);
    var share_3 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var _S652 : u32;
        if(_S651)
        {
            _S652 = u32(5);
        }
        else
        {
            _S652 = u32(0);
        }
        var share_4 : f32 = share_3 + openness_number_0(_S649, u32(132) + _S652 + term_1) * terms_3[term_1];
        term_1 = term_1 + u32(1);
        share_3 = share_4;
    }
    return saturate(share_3);
}

fn bounced_of_families_0( _S653 : u32,  _S654 : FamilyAlbedos_0,  _S655 : vec3<f32>,  _S656 : Interior_0,  _S657 : Blocked_0,  _S658 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S657, scattered_by_0(_S653, _S654.warp_4, u32(0), _S655), _S656), bounced_by_0(_S658, scattered_by_0(_S653, _S654.weft_4, u32(1), _S655), _S656));
}

fn bounced_far_0( _S659 : u32,  _S660 : FamilyAlbedos_0,  _S661 : vec3<f32>,  _S662 : Interior_0,  _S663 : vec3<f32>,  _S664 : bool,  _S665 : f32,  _S666 : f32,  _S667 : f32) -> Bounced_0
{
    var _S668 : Blocked_0 = blocked_from_0(_S659, _S663, true, _S664);
    var _S669 : Blocked_0 = blocked_from_0(_S659, _S663, false, _S664);
    var _S670 : f32 = _S665 / max(1.0f - _S668.by_warp_0 - _S668.by_weft_0, 0.10000000149011612f);
    var _S671 : f32 = (0.0020000000949949f * warp_seen_from_0(_S659, _S663, _S664) + _S670) / (_S670 + _S666 / max(1.0f - _S669.by_warp_0 - _S669.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S672 : f32 = 1.0f - _S667;
    return bounced_of_families_0(_S659, _S660, _S661, _S662, scaled_0(_S668, _S671 * _S672), scaled_0(_S669, (1.0f - _S671) * _S672));
}

fn bounced_over_0( _S673 : u32,  _S674 : Components_0,  _S675 : CloseUp_0,  _S676 : FamilyAlbedos_0,  _S677 : vec3<f32>,  _S678 : vec3<f32>) -> Bounced_0
{
    var _S679 : bool = (_S678.z) < 0.0f;
    var _S680 : Interior_0 = interior_of_0(_S673, _S677, _S679);
    var bounced_2 : Bounced_0 = bounced_far_0(_S673, _S676, _S677, _S680, to_face_frame_0(_S678, _S679), _S679, _S674.diffuse_warp_0, _S674.diffuse_weft_0, _S674.hole_2);
    if((_S675.weight_2) > 0.0f)
    {
        var _S681 : Bounced_0 = bounced_of_families_0(_S673, _S676, _S677, _S680, _S675.warp_1, _S675.weft_1);
        var _S682 : vec3<f32> = vec3<f32>(_S675.weight_2);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S681.reflected_0, _S682);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S681.transmitted_0, _S682);
    }
    return bounced_2;
}

fn composed_0( _S683 : u32,  _S684 : Components_0,  _S685 : CloseUp_0,  _S686 : FamilyAlbedos_0,  _S687 : vec3<f32>,  _S688 : vec3<f32>,  _S689 : vec3<f32>) -> vec3<f32>
{
    var _S690 : Albedos_0 = tinted_0(_S686.warp_4, _S687);
    var _S691 : Albedos_0 = tinted_0(_S686.weft_4, _S687);
    var _S692 : vec3<f32> = vec3<f32>(_S684.diffuse_warp_0);
    var _S693 : vec3<f32> = vec3<f32>(_S684.diffuse_weft_0);
    var _S694 : vec3<f32> = vec3<f32>(_S684.specular_warp_0);
    var _S695 : vec3<f32> = vec3<f32>(_S684.specular_weft_0);
    var _S696 : vec3<f32> = _S690.diffuse_reflect_0 * _S692 + _S691.diffuse_reflect_0 * _S693 + _S690.specular_reflect_0 * _S694 + _S691.specular_reflect_0 * _S695;
    var _S697 : f32 = _S689.z;
    var body_0 : vec3<f32>;
    if((_S688.z * _S697) < 0.0f)
    {
        body_0 = _S690.diffuse_transmit_0 * _S692 + _S691.diffuse_transmit_0 * _S693 + _S690.specular_transmit_0 * _S694 + _S691.specular_transmit_0 * _S695;
    }
    else
    {
        body_0 = _S696;
    }
    if((fabrics_0[_S683].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S683, _S684, _S685, _S686, _S687, _S689), _S688, _S689);
    }
    var _S698 : f32 = fabrics_0[_S683].sheen_strength_0;
    if((fabrics_0[_S683].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S699 : bool = _S697 < 0.0f;
    var _S700 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S688, _S699), to_face_frame_0(_S689, _S699), _S698, fabrics_0[_S683].sheen_roughness_0);
    return vec3<f32>(_S700.y) * body_0 + vec3<f32>(((_S684.light_visibility_1 + _S684.hole_2) * _S700.x));
}

fn light_of_neural_0( _S701 : i32,  _S702 : u32,  _S703 : VisiblePoint_0,  _S704 : vec2<u32>,  _S705 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.centre_0 = _S703.draft_0;
    footprint_1.dx_0 = _S703.draft_dx_0;
    footprint_1.dy_0 = _S703.draft_dy_0;
    var _S706 : vec3<f32> = to_local_0(_S703, _S703.view_1);
    var activations_0 : NeuralView_0;
    neural_view_0(_S702, footprint_1, _S706, &(activations_0));
    var _S707 : f32 = _S706.z;
    var _S708 : FamilyAlbedos_0 = albedos_over_0(_S702, footprint_1, _S707 < 0.0f);
    var _S709 : vec3<f32> = vec3<f32>(0.0f);
    var number_4 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S709;
    for(;;)
    {
        if(number_4 < (light_sample_count_0(_S701)))
        {
        }
        else
        {
            break;
        }
        var _S710 : f32 = visibility_at_0(_S701, number_4, _S704);
        if(_S710 <= 0.0f)
        {
            number_4 = number_4 + u32(1);
            continue;
        }
        var _S711 : LightSample_0 = light_sample_0(_S701, number_4, _S704, _S703.position_0);
        var _S712 : vec3<f32> = to_local_0(_S703, _S711.towards_0);
        var _S713 : Components_0 = neural_components_0(_S702, &(activations_0), _S712);
        radiance_1 = radiance_1 + vec3<f32>(_S710) * _S711.irradiance_1 * composed_0(_S702, _S713, no_close_up_0(), _S708, _S705, _S712, _S706);
        number_4 = number_4 + u32(1);
    }
    var hole_3 : f32 = activations_0.hole_0;
    var _S714 : f32 = fabrics_0[_S702].sheen_strength_0;
    var hole_4 : f32;
    if((fabrics_0[_S702].sheen_strength_0) > 0.0f)
    {
        hole_4 = hole_3 * (1.0f - _S714 * sheen_lobe_0(abs(_S707), fabrics_0[_S702].sheen_roughness_0).z);
    }
    else
    {
        hole_4 = hole_3;
    }
    return vec4<f32>(radiance_1, 1.0f - hole_4);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_neural(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S715 : u32 = id_0.x;
    var _S716 : u32 = frames_0[i32(0)].width_0;
    var _S717 : bool;
    if(_S715 >= (frames_0[i32(0)].width_0))
    {
        _S717 = true;
    }
    else
    {
        _S717 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S717)
    {
        return;
    }
    var _S718 : u32 = id_0.y * _S716 + _S715;
    var _S719 : u32 = layers_0[_S718].face_0;
    if((layers_0[_S718].face_0) == u32(0))
    {
        return;
    }
    var _S720 : u32 = _S719 - u32(1);
    var _S721 : u32 = face_fabrics_0[_S720];
    var _S722 : vec2<u32> = id_0.xy;
    var _S723 : VisiblePoint_0 = visible_point_0(i32(0), _S721, _S720, _S722);
    accumulate_0(_S718, light_of_neural_0(i32(0), _S721, _S723, _S722, filtered_albedo_0(_S721, _S723)));
    return;
}

