struct Frame_std140_0
{
    @align(16) width_0 : u32,
    @align(4) height_0 : u32,
    @align(8) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(16) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(8) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(16) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(8) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(16) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(8) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(16) corners_0 : u32,
    @align(4) face_fabrics_0 : u32,
    @align(8) vertices_0 : u32,
    @align(4) light_records_0 : u32,
    @align(16) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(8) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(16) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(8) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(16) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(8) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(16) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(8) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(16) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(8) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
    @align(16) ground_x_0 : f32,
    @align(4) ground_y_0 : f32,
    @align(8) ground_z_0 : f32,
    @align(4) ground_offset_0 : f32,
    @align(16) ground_lamp_0 : f32,
};

@binding(10) @group(0) var<uniform> frame_record_0 : Frame_std140_0;
struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(5) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(4) @group(0) var<storage, read> scene_words_0 : array<u32>;

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
    @align(4) samples_1 : u32,
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

@binding(3) @group(0) var<storage, read> packed_numbers_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

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

fn select_vector_0( condition_0 : bool,  yes_0 : vec4<f32>,  no_0 : vec4<f32>) -> vec4<f32>
{
    var chosen_0 : vec4<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
    chosen_0[i32(3)] = select(no_0[i32(3)], yes_0[i32(3)], condition_0);
    return chosen_0;
}

fn Identity_apply_0( x_0 : f32) -> f32
{
    return x_0;
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
        var _S15 : vec4<f32> = _S14 + select_vector_0(((output_0 & (i32(4)))) != i32(0), _S13.high_0, _S13.low_0);
        var _S16 : f32;
        if(_S11)
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[output_0];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[output_0] = Identity_apply_0(_S15[i32(0)] + _S16);
        }
        var _S17 : i32 = output_0 + i32(1);
        if(_S17 < i32(50))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S17];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S17] = Identity_apply_0(_S15[i32(1)] + _S16);
        }
        var _S18 : i32 = output_0 + i32(2);
        if(_S18 < i32(50))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S18];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S18] = Identity_apply_0(_S15[i32(2)] + _S16);
        }
        var _S19 : i32 = output_0 + i32(3);
        if(_S19 < i32(50))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S19];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S19] = Identity_apply_0(_S15[i32(3)] + _S16);
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
        var _S20 : i32 = i32(u32(8) * column_1);
        low_2[i32(0)] = (*inputs_2)[_S20];
        high_2[i32(0)] = (*inputs_2)[_S20 + i32(4)];
        var _S21 : i32 = _S20 + i32(1);
        low_2[i32(1)] = (*inputs_2)[_S21];
        high_2[i32(1)] = (*inputs_2)[_S21 + i32(4)];
        var _S22 : i32 = _S20 + i32(2);
        low_2[i32(2)] = (*inputs_2)[_S22];
        high_2[i32(2)] = (*inputs_2)[_S22 + i32(4)];
        var _S23 : i32 = _S20 + i32(3);
        low_2[i32(3)] = (*inputs_2)[_S23];
        high_2[i32(3)] = (*inputs_2)[_S23 + i32(4)];
        var _S24 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + column_1);
        sums_2[i32(0)] = sums_2[i32(0)] + (dot(_S24.low_0, low_2) + dot(_S24.high_0, high_2));
        var _S25 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(12) + column_1);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        var _S26 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(24) + column_1);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        var _S27 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(36) + column_1);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_2;
}

fn dense_part_1( weights_3 : HalfWeights_0,  first_3 : u32,  adds_1 : bool,  inputs_3 : ptr<function, array<f32, i32(96)>>,  outputs_1 : ptr<function, array<f32, i32(52)>>)
{
    var _S28 : u32 = first_3 + u32(whole_parts_0(i32(7)));
    var output_1 : i32 = i32(0);
    for(;;)
    {
        var _S29 : bool = output_1 < i32(52);
        if(_S29)
        {
        }
        else
        {
            break;
        }
        var _S30 : u32 = u32(output_1);
        var _S31 : Eight_0 = HalfWeights_eight_0(weights_3, first_3 + _S30 / u32(8));
        var _S32 : vec4<f32> = tile_product_1(weights_3, _S28 + _S30 * u32(12), &((*inputs_3)));
        var _S33 : vec4<f32> = _S32 + select_vector_0(((output_1 & (i32(4)))) != i32(0), _S31.high_0, _S31.low_0);
        var _S34 : f32;
        if(_S29)
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[output_1];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S33[i32(0)] + _S34);
        }
        var _S35 : i32 = output_1 + i32(1);
        if(_S35 < i32(52))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S35];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S35] = Identity_apply_0(_S33[i32(1)] + _S34);
        }
        var _S36 : i32 = output_1 + i32(2);
        if(_S36 < i32(52))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S36];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S36] = Identity_apply_0(_S33[i32(2)] + _S34);
        }
        var _S37 : i32 = output_1 + i32(3);
        if(_S37 < i32(52))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S37];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S37] = Identity_apply_0(_S33[i32(3)] + _S34);
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
        var _S38 : i32 = i32(u32(8) * column_2);
        low_3[i32(0)] = (*inputs_4)[min(_S38, i32(38))];
        high_3[i32(0)] = (*inputs_4)[min(_S38 + i32(4), i32(38))];
        var _S39 : i32 = _S38 + i32(1);
        low_3[i32(1)] = (*inputs_4)[min(_S39, i32(38))];
        high_3[i32(1)] = (*inputs_4)[min(_S39 + i32(4), i32(38))];
        var _S40 : i32 = _S38 + i32(2);
        low_3[i32(2)] = (*inputs_4)[min(_S40, i32(38))];
        high_3[i32(2)] = (*inputs_4)[min(_S40 + i32(4), i32(38))];
        var _S41 : i32 = _S38 + i32(3);
        low_3[i32(3)] = (*inputs_4)[min(_S41, i32(38))];
        high_3[i32(3)] = (*inputs_4)[min(_S41 + i32(4), i32(38))];
        var _S42 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + column_2);
        sums_3[i32(0)] = sums_3[i32(0)] + (dot(_S42.low_0, low_3) + dot(_S42.high_0, high_3));
        var _S43 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(5) + column_2);
        sums_3[i32(1)] = sums_3[i32(1)] + (dot(_S43.low_0, low_3) + dot(_S43.high_0, high_3));
        var _S44 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(10) + column_2);
        sums_3[i32(2)] = sums_3[i32(2)] + (dot(_S44.low_0, low_3) + dot(_S44.high_0, high_3));
        var _S45 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(15) + column_2);
        sums_3[i32(3)] = sums_3[i32(3)] + (dot(_S45.low_0, low_3) + dot(_S45.high_0, high_3));
        column_2 = column_2 + u32(1);
    }
    return sums_3;
}

fn dense_part_2( weights_5 : HalfWeights_0,  first_4 : u32,  adds_2 : bool,  inputs_5 : ptr<function, array<f32, i32(39)>>,  outputs_2 : ptr<function, array<f32, i32(96)>>)
{
    var _S46 : u32 = first_4 + u32(whole_parts_0(i32(12)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S47 : bool = output_2 < i32(96);
        if(_S47)
        {
        }
        else
        {
            break;
        }
        var _S48 : u32 = u32(output_2);
        var _S49 : Eight_0 = HalfWeights_eight_0(weights_5, first_4 + _S48 / u32(8));
        var _S50 : vec4<f32> = tile_product_2(weights_5, _S46 + _S48 * u32(5), &((*inputs_5)));
        var _S51 : vec4<f32> = _S50 + select_vector_0(((output_2 & (i32(4)))) != i32(0), _S49.high_0, _S49.low_0);
        var _S52 : f32;
        if(_S47)
        {
            if(adds_2)
            {
                _S52 = (*outputs_2)[output_2];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_2)[output_2] = Identity_apply_0(_S51[i32(0)] + _S52);
        }
        var _S53 : i32 = output_2 + i32(1);
        if(_S53 < i32(96))
        {
            if(adds_2)
            {
                _S52 = (*outputs_2)[_S53];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_2)[_S53] = Identity_apply_0(_S51[i32(1)] + _S52);
        }
        var _S54 : i32 = output_2 + i32(2);
        if(_S54 < i32(96))
        {
            if(adds_2)
            {
                _S52 = (*outputs_2)[_S54];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_2)[_S54] = Identity_apply_0(_S51[i32(2)] + _S52);
        }
        var _S55 : i32 = output_2 + i32(3);
        if(_S55 < i32(96))
        {
            if(adds_2)
            {
                _S52 = (*outputs_2)[_S55];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_2)[_S55] = Identity_apply_0(_S51[i32(3)] + _S52);
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
        var _S56 : i32 = i32(u32(8) * column_3);
        low_4[i32(0)] = (*inputs_6)[min(_S56, i32(99))];
        high_4[i32(0)] = (*inputs_6)[min(_S56 + i32(4), i32(99))];
        var _S57 : i32 = _S56 + i32(1);
        low_4[i32(1)] = (*inputs_6)[min(_S57, i32(99))];
        high_4[i32(1)] = (*inputs_6)[min(_S57 + i32(4), i32(99))];
        var _S58 : i32 = _S56 + i32(2);
        low_4[i32(2)] = (*inputs_6)[min(_S58, i32(99))];
        high_4[i32(2)] = (*inputs_6)[min(_S58 + i32(4), i32(99))];
        var _S59 : i32 = _S56 + i32(3);
        low_4[i32(3)] = (*inputs_6)[min(_S59, i32(99))];
        high_4[i32(3)] = (*inputs_6)[min(_S59 + i32(4), i32(99))];
        var _S60 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        sums_4[i32(0)] = sums_4[i32(0)] + (dot(_S60.low_0, low_4) + dot(_S60.high_0, high_4));
        var _S61 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(13) + column_3);
        sums_4[i32(1)] = sums_4[i32(1)] + (dot(_S61.low_0, low_4) + dot(_S61.high_0, high_4));
        var _S62 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(26) + column_3);
        sums_4[i32(2)] = sums_4[i32(2)] + (dot(_S62.low_0, low_4) + dot(_S62.high_0, high_4));
        var _S63 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(39) + column_3);
        sums_4[i32(3)] = sums_4[i32(3)] + (dot(_S63.low_0, low_4) + dot(_S63.high_0, high_4));
        column_3 = column_3 + u32(1);
    }
    return sums_4;
}

fn dense_part_3( weights_7 : HalfWeights_0,  first_5 : u32,  adds_3 : bool,  inputs_7 : ptr<function, array<f32, i32(100)>>,  outputs_3 : ptr<function, array<f32, i32(96)>>)
{
    var _S64 : u32 = first_5 + u32(whole_parts_0(i32(12)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S65 : bool = output_3 < i32(96);
        if(_S65)
        {
        }
        else
        {
            break;
        }
        var _S66 : u32 = u32(output_3);
        var _S67 : Eight_0 = HalfWeights_eight_0(weights_7, first_5 + _S66 / u32(8));
        var _S68 : vec4<f32> = tile_product_3(weights_7, _S64 + _S66 * u32(13), &((*inputs_7)));
        var _S69 : vec4<f32> = _S68 + select_vector_0(((output_3 & (i32(4)))) != i32(0), _S67.high_0, _S67.low_0);
        var _S70 : f32;
        if(_S65)
        {
            if(adds_3)
            {
                _S70 = (*outputs_3)[output_3];
            }
            else
            {
                _S70 = 0.0f;
            }
            (*outputs_3)[output_3] = Identity_apply_0(_S69[i32(0)] + _S70);
        }
        var _S71 : i32 = output_3 + i32(1);
        if(_S71 < i32(96))
        {
            if(adds_3)
            {
                _S70 = (*outputs_3)[_S71];
            }
            else
            {
                _S70 = 0.0f;
            }
            (*outputs_3)[_S71] = Identity_apply_0(_S69[i32(1)] + _S70);
        }
        var _S72 : i32 = output_3 + i32(2);
        if(_S72 < i32(96))
        {
            if(adds_3)
            {
                _S70 = (*outputs_3)[_S72];
            }
            else
            {
                _S70 = 0.0f;
            }
            (*outputs_3)[_S72] = Identity_apply_0(_S69[i32(2)] + _S70);
        }
        var _S73 : i32 = output_3 + i32(3);
        if(_S73 < i32(96))
        {
            if(adds_3)
            {
                _S70 = (*outputs_3)[_S73];
            }
            else
            {
                _S70 = 0.0f;
            }
            (*outputs_3)[_S73] = Identity_apply_0(_S69[i32(3)] + _S70);
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
        var _S74 : i32 = i32(u32(8) * column_4);
        low_5[i32(0)] = (*inputs_8)[_S74];
        high_5[i32(0)] = (*inputs_8)[_S74 + i32(4)];
        var _S75 : i32 = _S74 + i32(1);
        low_5[i32(1)] = (*inputs_8)[_S75];
        high_5[i32(1)] = (*inputs_8)[_S75 + i32(4)];
        var _S76 : i32 = _S74 + i32(2);
        low_5[i32(2)] = (*inputs_8)[_S76];
        high_5[i32(2)] = (*inputs_8)[_S76 + i32(4)];
        var _S77 : i32 = _S74 + i32(3);
        low_5[i32(3)] = (*inputs_8)[_S77];
        high_5[i32(3)] = (*inputs_8)[_S77 + i32(4)];
        var _S78 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + column_4);
        sums_5[i32(0)] = sums_5[i32(0)] + (dot(_S78.low_0, low_5) + dot(_S78.high_0, high_5));
        var _S79 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(2) + column_4);
        sums_5[i32(1)] = sums_5[i32(1)] + (dot(_S79.low_0, low_5) + dot(_S79.high_0, high_5));
        var _S80 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(4) + column_4);
        sums_5[i32(2)] = sums_5[i32(2)] + (dot(_S80.low_0, low_5) + dot(_S80.high_0, high_5));
        var _S81 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(6) + column_4);
        sums_5[i32(3)] = sums_5[i32(3)] + (dot(_S81.low_0, low_5) + dot(_S81.high_0, high_5));
        column_4 = column_4 + u32(1);
    }
    return sums_5;
}

fn dense_part_4( weights_9 : HalfWeights_0,  first_6 : u32,  adds_4 : bool,  inputs_9 : ptr<function, array<f32, i32(16)>>,  outputs_4 : ptr<function, array<f32, i32(1)>>)
{
    var _S82 : u32 = first_6 + u32(whole_parts_0(i32(1)));
    var output_4 : i32 = i32(0);
    for(;;)
    {
        var _S83 : bool = output_4 < i32(1);
        if(_S83)
        {
        }
        else
        {
            break;
        }
        var _S84 : u32 = u32(output_4);
        var _S85 : Eight_0 = HalfWeights_eight_0(weights_9, first_6 + _S84 / u32(8));
        var _S86 : vec4<f32> = tile_product_4(weights_9, _S82 + _S84 * u32(2), &((*inputs_9)));
        var _S87 : vec4<f32> = _S86 + select_vector_0(((output_4 & (i32(4)))) != i32(0), _S85.high_0, _S85.low_0);
        var _S88 : f32;
        if(_S83)
        {
            if(adds_4)
            {
                _S88 = (*outputs_4)[output_4];
            }
            else
            {
                _S88 = 0.0f;
            }
            (*outputs_4)[output_4] = Identity_apply_0(_S87[i32(0)] + _S88);
        }
        var _S89 : i32 = output_4 + i32(1);
        if(_S89 < i32(1))
        {
            if(adds_4)
            {
                _S88 = (*outputs_4)[_S89];
            }
            else
            {
                _S88 = 0.0f;
            }
            (*outputs_4)[_S89] = Identity_apply_0(_S87[i32(1)] + _S88);
        }
        var _S90 : i32 = output_4 + i32(2);
        if(_S90 < i32(1))
        {
            if(adds_4)
            {
                _S88 = (*outputs_4)[_S90];
            }
            else
            {
                _S88 = 0.0f;
            }
            (*outputs_4)[_S90] = Identity_apply_0(_S87[i32(2)] + _S88);
        }
        var _S91 : i32 = output_4 + i32(3);
        if(_S91 < i32(1))
        {
            if(adds_4)
            {
                _S88 = (*outputs_4)[_S91];
            }
            else
            {
                _S88 = 0.0f;
            }
            (*outputs_4)[_S91] = Identity_apply_0(_S87[i32(3)] + _S88);
        }
        output_4 = output_4 + i32(4);
    }
    return;
}

fn LeakyRelu_apply_0( x_1 : f32) -> f32
{
    return max(x_1, x_1 * 0.00999999977648258f);
}

fn dense_part_5( weights_10 : HalfWeights_0,  first_7 : u32,  adds_5 : bool,  inputs_10 : ptr<function, array<f32, i32(96)>>,  outputs_5 : ptr<function, array<f32, i32(96)>>)
{
    var _S92 : u32 = first_7 + u32(whole_parts_0(i32(12)));
    var output_5 : i32 = i32(0);
    for(;;)
    {
        var _S93 : bool = output_5 < i32(96);
        if(_S93)
        {
        }
        else
        {
            break;
        }
        var _S94 : u32 = u32(output_5);
        var _S95 : Eight_0 = HalfWeights_eight_0(weights_10, first_7 + _S94 / u32(8));
        var _S96 : vec4<f32> = tile_product_1(weights_10, _S92 + _S94 * u32(12), &((*inputs_10)));
        var _S97 : vec4<f32> = _S96 + select_vector_0(((output_5 & (i32(4)))) != i32(0), _S95.high_0, _S95.low_0);
        var _S98 : f32;
        if(_S93)
        {
            if(adds_5)
            {
                _S98 = (*outputs_5)[output_5];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_5)[output_5] = LeakyRelu_apply_0(_S97[i32(0)] + _S98);
        }
        var _S99 : i32 = output_5 + i32(1);
        if(_S99 < i32(96))
        {
            if(adds_5)
            {
                _S98 = (*outputs_5)[_S99];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_5)[_S99] = LeakyRelu_apply_0(_S97[i32(1)] + _S98);
        }
        var _S100 : i32 = output_5 + i32(2);
        if(_S100 < i32(96))
        {
            if(adds_5)
            {
                _S98 = (*outputs_5)[_S100];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_5)[_S100] = LeakyRelu_apply_0(_S97[i32(2)] + _S98);
        }
        var _S101 : i32 = output_5 + i32(3);
        if(_S101 < i32(96))
        {
            if(adds_5)
            {
                _S98 = (*outputs_5)[_S101];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_5)[_S101] = LeakyRelu_apply_0(_S97[i32(3)] + _S98);
        }
        output_5 = output_5 + i32(4);
    }
    return;
}

fn dense_part_6( weights_11 : HalfWeights_0,  first_8 : u32,  adds_6 : bool,  inputs_11 : ptr<function, array<f32, i32(100)>>,  outputs_6 : ptr<function, array<f32, i32(16)>>)
{
    var _S102 : u32 = first_8 + u32(whole_parts_0(i32(2)));
    var output_6 : i32 = i32(0);
    for(;;)
    {
        var _S103 : bool = output_6 < i32(16);
        if(_S103)
        {
        }
        else
        {
            break;
        }
        var _S104 : u32 = u32(output_6);
        var _S105 : Eight_0 = HalfWeights_eight_0(weights_11, first_8 + _S104 / u32(8));
        var _S106 : vec4<f32> = tile_product_3(weights_11, _S102 + _S104 * u32(13), &((*inputs_11)));
        var _S107 : vec4<f32> = _S106 + select_vector_0(((output_6 & (i32(4)))) != i32(0), _S105.high_0, _S105.low_0);
        var _S108 : f32;
        if(_S103)
        {
            if(adds_6)
            {
                _S108 = (*outputs_6)[output_6];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_6)[output_6] = LeakyRelu_apply_0(_S107[i32(0)] + _S108);
        }
        var _S109 : i32 = output_6 + i32(1);
        if(_S109 < i32(16))
        {
            if(adds_6)
            {
                _S108 = (*outputs_6)[_S109];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_6)[_S109] = LeakyRelu_apply_0(_S107[i32(1)] + _S108);
        }
        var _S110 : i32 = output_6 + i32(2);
        if(_S110 < i32(16))
        {
            if(adds_6)
            {
                _S108 = (*outputs_6)[_S110];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_6)[_S110] = LeakyRelu_apply_0(_S107[i32(2)] + _S108);
        }
        var _S111 : i32 = output_6 + i32(3);
        if(_S111 < i32(16))
        {
            if(adds_6)
            {
                _S108 = (*outputs_6)[_S111];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_6)[_S111] = LeakyRelu_apply_0(_S107[i32(3)] + _S108);
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
        var _S112 : i32 = i32(u32(8) * column_5);
        low_6[i32(0)] = (*inputs_12)[_S112];
        high_6[i32(0)] = (*inputs_12)[_S112 + i32(4)];
        var _S113 : i32 = _S112 + i32(1);
        low_6[i32(1)] = (*inputs_12)[_S113];
        high_6[i32(1)] = (*inputs_12)[_S113 + i32(4)];
        var _S114 : i32 = _S112 + i32(2);
        low_6[i32(2)] = (*inputs_12)[_S114];
        high_6[i32(2)] = (*inputs_12)[_S114 + i32(4)];
        var _S115 : i32 = _S112 + i32(3);
        low_6[i32(3)] = (*inputs_12)[_S115];
        high_6[i32(3)] = (*inputs_12)[_S115 + i32(4)];
        var _S116 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + column_5);
        sums_6[i32(0)] = sums_6[i32(0)] + (dot(_S116.low_0, low_6) + dot(_S116.high_0, high_6));
        var _S117 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(11) + column_5);
        sums_6[i32(1)] = sums_6[i32(1)] + (dot(_S117.low_0, low_6) + dot(_S117.high_0, high_6));
        var _S118 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(22) + column_5);
        sums_6[i32(2)] = sums_6[i32(2)] + (dot(_S118.low_0, low_6) + dot(_S118.high_0, high_6));
        var _S119 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(33) + column_5);
        sums_6[i32(3)] = sums_6[i32(3)] + (dot(_S119.low_0, low_6) + dot(_S119.high_0, high_6));
        column_5 = column_5 + u32(1);
    }
    return sums_6;
}

fn dense_part_7( weights_13 : HalfWeights_0,  first_9 : u32,  adds_7 : bool,  inputs_13 : ptr<function, array<f32, i32(88)>>,  outputs_7 : ptr<function, array<f32, i32(96)>>)
{
    var _S120 : u32 = first_9 + u32(whole_parts_0(i32(12)));
    var output_7 : i32 = i32(0);
    for(;;)
    {
        var _S121 : bool = output_7 < i32(96);
        if(_S121)
        {
        }
        else
        {
            break;
        }
        var _S122 : u32 = u32(output_7);
        var _S123 : Eight_0 = HalfWeights_eight_0(weights_13, first_9 + _S122 / u32(8));
        var _S124 : vec4<f32> = tile_product_5(weights_13, _S120 + _S122 * u32(11), &((*inputs_13)));
        var _S125 : vec4<f32> = _S124 + select_vector_0(((output_7 & (i32(4)))) != i32(0), _S123.high_0, _S123.low_0);
        var _S126 : f32;
        if(_S121)
        {
            if(adds_7)
            {
                _S126 = (*outputs_7)[output_7];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_7)[output_7] = LeakyRelu_apply_0(_S125[i32(0)] + _S126);
        }
        var _S127 : i32 = output_7 + i32(1);
        if(_S127 < i32(96))
        {
            if(adds_7)
            {
                _S126 = (*outputs_7)[_S127];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_7)[_S127] = LeakyRelu_apply_0(_S125[i32(1)] + _S126);
        }
        var _S128 : i32 = output_7 + i32(2);
        if(_S128 < i32(96))
        {
            if(adds_7)
            {
                _S126 = (*outputs_7)[_S128];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_7)[_S128] = LeakyRelu_apply_0(_S125[i32(2)] + _S126);
        }
        var _S129 : i32 = output_7 + i32(3);
        if(_S129 < i32(96))
        {
            if(adds_7)
            {
                _S126 = (*outputs_7)[_S129];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_7)[_S129] = LeakyRelu_apply_0(_S125[i32(3)] + _S126);
        }
        output_7 = output_7 + i32(4);
    }
    return;
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

fn rsqrt_0( x_2 : f32) -> f32
{
    return 1.0f / sqrt(x_2);
}

fn select_vector_2( condition_2 : bool,  yes_2 : vec3<f32>,  no_2 : vec3<f32>) -> vec3<f32>
{
    var chosen_2 : vec3<f32>;
    chosen_2[i32(0)] = select(no_2[i32(0)], yes_2[i32(0)], condition_2);
    chosen_2[i32(1)] = select(no_2[i32(1)], yes_2[i32(1)], condition_2);
    chosen_2[i32(2)] = select(no_2[i32(2)], yes_2[i32(2)], condition_2);
    return chosen_2;
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

fn select_vector_3( condition_3 : bool,  yes_3 : vec4<u32>,  no_3 : vec4<u32>) -> vec4<u32>
{
    var chosen_3 : vec4<u32>;
    chosen_3[i32(0)] = select(no_3[i32(0)], yes_3[i32(0)], condition_3);
    chosen_3[i32(1)] = select(no_3[i32(1)], yes_3[i32(1)], condition_3);
    chosen_3[i32(2)] = select(no_3[i32(2)], yes_3[i32(2)], condition_3);
    chosen_3[i32(3)] = select(no_3[i32(3)], yes_3[i32(3)], condition_3);
    return chosen_3;
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
    var _S130 : u32 = first_17 + u32(whole_parts_0(i32(12)));
    var output_8 : i32 = i32(0);
    for(;;)
    {
        var _S131 : bool = output_8 < i32(96);
        if(_S131)
        {
        }
        else
        {
            break;
        }
        var _S132 : u32 = u32(output_8);
        var _S133 : Eight_0 = HalfWeights_eight_0(weights_21, first_17 + _S132 / u32(8));
        var _S134 : vec4<f32> = tile_product_1(weights_21, _S130 + _S132 * u32(12), &((*inputs_21)));
        var _S135 : vec4<f32> = _S134 + select_vector_0(((output_8 & (i32(4)))) != i32(0), _S133.high_0, _S133.low_0);
        var _S136 : f32;
        if(_S131)
        {
            if(adds_15)
            {
                _S136 = (*outputs_15)[output_8];
            }
            else
            {
                _S136 = 0.0f;
            }
            (*outputs_15)[output_8] = LeakyRelu_apply_0(_S135[i32(0)] + _S136);
        }
        var _S137 : i32 = output_8 + i32(1);
        if(_S137 < i32(96))
        {
            if(adds_15)
            {
                _S136 = (*outputs_15)[_S137];
            }
            else
            {
                _S136 = 0.0f;
            }
            (*outputs_15)[_S137] = LeakyRelu_apply_0(_S135[i32(1)] + _S136);
        }
        var _S138 : i32 = output_8 + i32(2);
        if(_S138 < i32(96))
        {
            if(adds_15)
            {
                _S136 = (*outputs_15)[_S138];
            }
            else
            {
                _S136 = 0.0f;
            }
            (*outputs_15)[_S138] = LeakyRelu_apply_0(_S135[i32(2)] + _S136);
        }
        var _S139 : i32 = output_8 + i32(3);
        if(_S139 < i32(96))
        {
            if(adds_15)
            {
                _S136 = (*outputs_15)[_S139];
            }
            else
            {
                _S136 = 0.0f;
            }
            (*outputs_15)[_S139] = LeakyRelu_apply_0(_S135[i32(3)] + _S136);
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

fn fabric_of_0( face_1 : u32) -> u32
{
    return scene_words_0[frame_record_0.face_fabrics_0 + face_1];
}

struct Vertex_0
{
     x_3 : f32,
     y_0 : f32,
     z_0 : f32,
     normal_x_0 : f32,
     normal_y_0 : f32,
     normal_z_0 : f32,
     u_0 : f32,
     v_0 : f32,
};

fn scene_vertex_0( first_19 : u32) -> Vertex_0
{
    var record_0 : Vertex_0;
    record_0.x_3 = (bitcast<f32>((scene_words_0[first_19])));
    record_0.y_0 = (bitcast<f32>((scene_words_0[first_19 + u32(1)])));
    record_0.z_0 = (bitcast<f32>((scene_words_0[first_19 + u32(2)])));
    record_0.normal_x_0 = (bitcast<f32>((scene_words_0[first_19 + u32(3)])));
    record_0.normal_y_0 = (bitcast<f32>((scene_words_0[first_19 + u32(4)])));
    record_0.normal_z_0 = (bitcast<f32>((scene_words_0[first_19 + u32(5)])));
    record_0.u_0 = (bitcast<f32>((scene_words_0[first_19 + u32(6)])));
    record_0.v_0 = (bitcast<f32>((scene_words_0[first_19 + u32(7)])));
    return record_0;
}

fn vertex_at_0( corner_0 : u32) -> Vertex_0
{
    return scene_vertex_0(frame_record_0.vertices_0 + u32(8) * scene_words_0[frame_record_0.corners_0 + corner_0]);
}

fn position_of_0( vertex_0 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_0.x_3, vertex_0.y_0, vertex_0.z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn normal_of_0( vertex_1 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S140 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S141 : u32 = ((((_S140 >> ((((_S140 >> (u32(28)))) + u32(4))))) ^ (_S140))) * u32(277803737);
    return (((_S141 >> (u32(22)))) ^ (_S141));
}

fn hash_key_0( thread_0 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_0 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_0 : u32) -> u32
{
    return scramble_0(cell_0 + key_0);
}

fn uneven_corner_0( key_1 : u32,  cell_1 : u32) -> f32
{
    return f32(((hash_bits_0(key_1, cell_1)) >> (u32(9)))) * 2.384185791015625e-07f - 1.0f;
}

fn uneven_octave_0( key_2 : u32,  place_0 : vec2<f32>) -> f32
{
    var _S142 : vec2<f32> = floor(place_0);
    var _S143 : vec2<f32> = place_0 - _S142;
    var _S144 : vec2<f32> = _S143 * _S143 * (vec2<f32>(3.0f) - vec2<f32>(2.0f) * _S143);
    var _S145 : u32 = u32(i32(_S142.x)) * u32(65536) + u32(i32(_S142.y));
    var _S146 : f32 = _S144.x;
    return mix(mix(uneven_corner_0(key_2, _S145), uneven_corner_0(key_2, _S145 + u32(65536)), _S146), mix(uneven_corner_0(key_2, _S145 + u32(1)), uneven_corner_0(key_2, _S145 + u32(65537)), _S146), _S144.y);
}

fn square_1( x_4 : f32) -> f32
{
    return x_4 * x_4;
}

fn natural_logarithm_0( x_5 : f32) -> f32
{
    var _S147 : u32 = (bitcast<u32>((x_5)));
    var m_0 : f32 = (bitcast<f32>(((((_S147 & (u32(8388607)))) | (u32(1056964608))))));
    var _S148 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S147 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S148);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S148) - 1.0f;
    var _S149 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S149 - exponent_0 * 0.00021219444170129f - 0.5f * _S149) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_6 : f32) -> f32
{
    return natural_logarithm_0(x_6) * 1.4426950216293335f;
}

fn exponential_0( x_7 : f32) -> f32
{
    var _S150 : f32 = clamp(x_7, -87.0f, 88.0f);
    var _S151 : f32 = floor(_S150 * 1.4426950216293335f + 0.5f);
    var _S152 : f32 = _S150 - _S151 * 0.693359375f + _S151 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S152 + 0.00139819993637502f) * _S152 + 0.00833345204591751f) * _S152 + 0.04166579619050026f) * _S152 + 0.1666666567325592f) * _S152 + 0.5f) * _S152 * _S152 + _S152 + 1.0f) * (bitcast<f32>(((u32(i32(_S151) + i32(127)) << (u32(23)))))), 0.0f, x_7 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S153 : u32 = scene_words_0[index_0];
    var _S154 : vec3<f32> = vec3<f32>(f32((_S153 & (u32(1023)))), f32((((_S153 >> (u32(10)))) & (u32(1023)))), f32((_S153 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S154 * _S154;
}

fn map_level_0( first_20 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S155 : f32 = uv_0.x;
    var _S156 : f32 = f32(side_0);
    var _S157 : f32 = (_S155 - floor(_S155)) * _S156 - 0.5f;
    var _S158 : f32 = uv_0.y;
    var _S159 : f32 = (_S158 - floor(_S158)) * _S156 - 0.5f;
    var _S160 : f32 = floor(_S157);
    var _S161 : i32 = i32(side_0);
    var _S162 : u32 = side_0 - u32(1);
    var _S163 : u32 = (u32(i32(_S160) + _S161) & (_S162));
    var _S164 : f32 = floor(_S159);
    var _S165 : u32 = (u32(i32(_S164) + _S161) & (_S162));
    var _S166 : u32 = ((_S163 + u32(1)) & (_S162));
    var _S167 : u32 = first_20 + _S165 * side_0;
    var _S168 : vec3<f32> = vec3<f32>((_S157 - _S160));
    var _S169 : u32 = first_20 + (((_S165 + u32(1)) & (_S162))) * side_0;
    return mix(mix(map_texel_0(_S167 + _S163), map_texel_0(_S167 + _S166), _S168), mix(map_texel_0(_S169 + _S163), map_texel_0(_S169 + _S166), _S168), vec3<f32>((_S159 - _S164)));
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_2 : Footprint_0) -> f32
{
    var _S170 : vec2<f32> = this_2.dx_0;
    var _S171 : vec2<f32> = this_2.dy_0;
    return sqrt(0.5f * (dot(_S170, _S170) + dot(_S171, _S171)));
}

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn moved_share_0( family_0 : u32,  size_2 : f32) -> f32
{
    return fade_0(size_2, families_0[family_0].period_0 / families_0[family_0].count_0);
}

fn turns_and_remainder_0( family_1 : u32,  index_1 : f32) -> vec2<f32>
{
    var _S172 : f32 = floor(fma(index_1, families_0[family_1].inverse_count_0, families_0[family_1].half_inverse_count_0));
    return vec2<f32>(_S172, fma(- _S172, families_0[family_1].count_0, index_1));
}

struct Cell_0
{
     thread_1 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_2 : u32,  position_0 : f32) -> Cell_0
{
    var _S173 : f32 = floor(position_0 * families_0[family_2].inverse_size_0);
    var cell_2 : Cell_0;
    var _S174 : f32 = fma(- _S173, families_0[family_2].size_0, position_0);
    cell_2.below_0 = _S174;
    cell_2.above_0 = families_0[family_2].size_0 - _S174;
    cell_2.across_0 = _S174 - 0.5f * families_0[family_2].size_0;
    cell_2.half_width_1 = families_0[family_2].half_width_0;
    cell_2.thread_1 = u32(clamp(turns_and_remainder_0(family_2, _S173).y, 0.0f, families_0[family_2].count_0 - 1.0f));
    return cell_2;
}

fn table_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_2])));
}

fn locate_varied_0( family_3 : u32,  position_1 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_1 - families_0[family_3].start_0) * families_0[family_3].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S175 : f32 = turns_1 * families_0[family_3].period_0;
    var thread_2 : u32 = words_0[families_0[family_3].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_3].bins_0, 0.0f, families_0[family_3].bins_0 - 1.0f))];
    var _S176 : u32 = min(thread_2 + select(u32(0), u32(1), _S175 >= (table_number_0(families_0[family_3].place_table_0 + thread_2 * u32(4) + u32(1)))), u32(families_0[family_3].count_0) - u32(1));
    var _S177 : u32 = families_0[family_3].place_table_0 + _S176 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_1 = _S176;
    cell_3.below_0 = _S175 - table_number_0(_S177);
    cell_3.above_0 = table_number_0(_S177 + u32(1)) - _S175;
    cell_3.across_0 = _S175 - table_number_0(_S177 + u32(2));
    cell_3.half_width_1 = table_number_0(_S177 + u32(3));
    return cell_3;
}

fn locate_0( family_4 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_4].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_4, position_2);
    }
    return locate_varied_0(family_4, position_2);
}

fn irregular_thread_0( family_5 : u32,  position_3 : f32,  cell_4 : Cell_0) -> f32
{
    return floor((position_3 - cell_4.across_0) / families_0[family_5].period_0) * families_0[family_5].count_0 + f32(cell_4.thread_1);
}

fn irregular_entry_0( row_6 : u32,  column_6 : f32) -> vec4<u32>
{
    var _S178 : u32 = row_6 + u32(4) * ((u32(i32(column_6)) & (u32(1023))));
    return vec4<u32>(words_0[_S178], words_0[_S178 + u32(1)], words_0[_S178 + u32(2)], words_0[_S178 + u32(3)]);
}

fn irregular_integral_0( family_6 : u32,  threads_0 : u32,  begin_0 : f32,  steps_0 : f32) -> vec4<f32>
{
    var _S179 : u32 = families_0[family_6].irregular_table_0 + threads_0 * u32(4096);
    var _S180 : f32 = begin_0 + steps_0;
    var _S181 : f32 = floor(begin_0);
    var _S182 : vec4<u32> = irregular_entry_0(_S179, _S181);
    var _S183 : f32 = floor(_S180);
    var _S184 : vec4<u32> = irregular_entry_0(_S179, _S183);
    return vec4<f32>(vec4<i32>(_S184 - _S182)) + (vec4<f32>(vec4<i32>(irregular_entry_0(_S179, _S183 + 1.0f) - _S184)) * vec4<f32>((_S180 - _S183)) - vec4<f32>(vec4<i32>(irregular_entry_0(_S179, _S181 + 1.0f) - _S182)) * vec4<f32>((begin_0 - _S181)));
}

fn irregular_units_0( family_7 : u32) -> vec4<f32>
{
    return vec4<f32>(families_0[family_7].irregular_thickness_0, families_0[family_7].irregular_cover_0, families_0[family_7].irregular_tone_0, families_0[family_7].irregular_nep_0);
}

fn irregular_at_0( family_8 : u32,  key_3 : u32,  number_0 : f32,  along_0 : f32) -> vec4<f32>
{
    var _S185 : f32 = floor(number_0 / 64.0f);
    var _S186 : u32 = hash_bits_0(key_3, u32(i32(_S185)));
    var _S187 : u32 = ((_S186 & (u32(127)))) + u32(number_0 - 64.0f * _S185);
    var _S188 : f32 = along_0 / 2.0f - 0.5f + f32((_S186 >> (u32(22))));
    var sums_7 : vec4<f32> = vec4<f32>(0.0f);
    var side_1 : u32 = u32(0);
    for(;;)
    {
        if(side_1 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S189 : vec4<f32> = irregular_integral_0(family_8, _S187 + side_1, _S188, 1.0f) - sums_7;
        var _S190 : u32 = side_1 + u32(1);
        sums_7 = _S189;
        side_1 = _S190;
    }
    return sums_7 * irregular_units_0(family_8);
}

struct VisiblePoint_0
{
     position_4 : vec3<f32>,
     view_0 : vec3<f32>,
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

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S191 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S191, - _S191, back_2));
}

fn row_of_taps_0( footprint_0 : Footprint_0) -> vec3<f32>
{
    var _S192 : f32 = footprint_0.dx_0.x;
    var _S193 : f32 = footprint_0.dy_0.x;
    var _S194 : f32 = _S192 * _S192 + _S193 * _S193;
    var _S195 : f32 = footprint_0.dx_0.y;
    var _S196 : f32 = footprint_0.dy_0.y;
    var _S197 : f32 = _S195 * _S195 + _S196 * _S196;
    var _S198 : f32 = _S192 * _S195 + _S193 * _S196;
    var _S199 : f32 = 0.5f * (_S194 - _S197);
    var _S200 : f32 = 0.5f * (_S194 + _S197);
    var _S201 : f32 = sqrt(_S199 * _S199 + _S198 * _S198);
    var _S202 : f32 = _S200 + _S201;
    var _S203 : f32 = max(_S202 - 1.5f * max(_S200 - _S201, 0.0f), 0.0f);
    var _S204 : f32 = square_1(4.0f);
    var _S205 : f32 = max(_S200 - 0.5f * _S203, _S202 / _S204);
    var _S206 : f32 = sqrt(max(min(_S203, _S202 - _S205), 0.0f) / (_S204 - 1.0f));
    var _S207 : f32 = _S199 / max(_S201, 1.00000000317107685e-30f);
    var _S208 : f32 = sqrt(max(0.5f * (1.0f - _S207), 0.0f));
    return vec3<f32>(sqrt(_S205), _S206 * sqrt(max(0.5f * (1.0f + _S207), 0.0f)), select(_S206 * _S208, - _S206 * _S208, _S198 < 0.0f));
}

struct AnisotropicTaps_0
{
     centre_1 : vec2<f32>,
     side_2 : f32,
     first_21 : vec2<f32>,
     second_0 : vec2<f32>,
};

fn AnisotropicTaps_size_0( this_3 : AnisotropicTaps_0) -> f32
{
    var _S209 : f32 = this_3.first_21.x;
    var _S210 : f32 = this_3.second_0.x;
    var _S211 : f32 = this_3.side_2;
    var _S212 : f32 = _S211 * _S211;
    var _S213 : f32 = this_3.first_21.y;
    var _S214 : f32 = this_3.second_0.y;
    var _S215 : f32 = 12.0f * (_S209 * _S213 + _S210 * _S214);
    return sqrt(sqrt(max((12.0f * (_S209 * _S209 + _S210 * _S210) + _S212) * (12.0f * (_S213 * _S213 + _S214 * _S214) + _S212) - _S215 * _S215, square_1(_S212))));
}

fn footprint_coordinates_0( taps_0 : AnisotropicTaps_0) -> vec3<f32>
{
    return vec3<f32>(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

fn wrapped_0( index_3 : f32,  count_1 : f32) -> f32
{
    return select(select(index_3, index_3 - count_1, index_3 >= count_1), index_3 + count_1, index_3 < 0.0f);
}

fn AnisotropicTaps_has_steps_0( this_4 : AnisotropicTaps_0) -> bool
{
    var _S216 : vec2<f32> = this_4.first_21;
    var _S217 : vec2<f32> = this_4.second_0;
    return (max(dot(_S216, _S216), dot(_S217, _S217))) > 0.0f;
}

fn AnisotropicTaps_place_0( this_5 : AnisotropicTaps_0,  number_1 : u32) -> vec2<f32>
{
    return this_5.centre_1 + vec2<f32>(select(-1.0f, 1.0f, number_1 >= u32(2))) * this_5.first_21 + vec2<f32>(select(-1.0f, 1.0f, ((number_1 & (u32(1)))) != u32(0))) * this_5.second_0;
}

fn bump_0( distance_0 : f32) -> f32
{
    var _S218 : f32 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S218 * _S218;
}

struct Yarns_0
{
     warp_1 : vec4<f32>,
     weft_1 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_2 : vec4<f32>,  weft_2 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S219 : Yarns_0;
    _S219.warp_1 = warp_2;
    _S219.weft_1 = weft_2;
    _S219.shares_0 = shares_1;
    return _S219;
}

fn irregular_over_0( family_9 : u32,  key_4 : u32,  place_1 : f32,  width_2 : f32,  along_1 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S220 : f32 = max(width_2, 0.0625f);
    var _S221 : f32 = min(_S220, 64.0f);
    var _S222 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S223 : f32 = along_1 / 2.0f - 0.5f * _S222;
    var _S224 : f32 = 0.5f * _S221;
    var _S225 : vec2<f32> = floor(vec2<f32>(place_1 - _S224, place_1 + _S224) / vec2<f32>(64.0f));
    var _S226 : vec4<f32> = vec4<f32>(0.0f);
    var number_2 : u32 = u32(0);
    var sums_8 : vec4<f32> = _S226;
    for(;;)
    {
        if(number_2 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S227 : bool = number_2 >= u32(3);
        var _S228 : u32 = select(number_2, number_2 - u32(3), _S227);
        var _S229 : f32 = select(-1.0f, 1.0f, _S227);
        var _S230 : f32 = _S225.y;
        var _S231 : f32 = _S225.x;
        var _S232 : f32 = select(_S231, _S230, _S227);
        var _S233 : f32 = place_1 + _S229 * 0.5f * _S221 - 64.0f * _S232;
        var _S234 : f32 = clamp(floor(_S233), 0.0f, 63.0f);
        var _S235 : f32 = _S233 - _S234;
        var _S236 : f32 = select(select(64.0f, 0.0f, _S227), _S234 + f32(_S228), _S228 < u32(2));
        var _S237 : f32 = _S229 * select(select(select(0.0f, -1.0f, _S231 != _S230), _S235, _S228 == u32(1)), 1.0f - _S235, _S228 == u32(0));
        if(_S237 == 0.0f)
        {
            number_2 = number_2 + u32(1);
            continue;
        }
        var _S238 : u32 = hash_bits_0(key_4, u32(i32(_S232)));
        sums_8 = sums_8 + vec4<f32>(_S237) * irregular_integral_0(family_9, ((_S238 & (u32(127)))) + u32(_S236), _S223 + f32((_S238 >> (u32(22)))), _S222);
        number_2 = number_2 + u32(1);
    }
    return sums_8 * irregular_units_0(family_9) * vec4<f32>((sqrt(_S221 / _S220) / (_S221 * _S222)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S239 : f32 = covers_0.x;
    var _S240 : f32 = covers_0.y;
    return vec3<f32>(_S239 * (1.0f - _S240 * (1.0f - warp_on_top_1)), _S240 * (1.0f - _S239 * warp_on_top_1), (1.0f - _S239) * (1.0f - _S240));
}

fn correction_weight_of_0( coded_size_0 : f32) -> f32
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

struct Bound_0
{
     thread_3 : u32,
     turns_2 : f32,
     cell_5 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_10 : u32,  position_5 : f32) -> Bound_0
{
    var _S241 : Cell_0 = locate_0(family_10, position_5);
    var _S242 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S241.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_3 = _S241.thread_1;
    bound_0.turns_2 = round((position_5 - families_0[family_10].start_0 - _S242 - _S241.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_5 = _S241.below_0;
    var _S243 : f32 = 2.0f * _S241.half_width_1;
    bound_0.width_3 = _S243;
    bound_0.visible_0 = clamp((_S241.across_0 + _S241.half_width_1) / _S243, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S241.below_0, _S241.below_0 - _S241.across_0 - _S241.half_width_1) + max(_S241.across_0 - _S241.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_7 : Bound_0,
     high_7 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_2 : f32,  size_3 : f32) -> Stretch_0
{
    var _S244 : f32 = centre_2 - floor((centre_2 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S245 : f32 = 0.5f * max(size_3, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_7 = bound_at_0(family_11, _S244 - _S245);
    stretch_0.high_7 = bound_at_0(family_11, _S244 + _S245);
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

fn table_albedos_0( row_7 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_7);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_7 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_7 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_7 + u32(9));
    return albedos_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_7.turns_2 - this_6.low_7.turns_2;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S246 : f32 = Stretch_turns_0(stretch_1);
    var _S247 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_7.thread_3;
    var _S248 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_7.thread_3;
    var _S249 : f32 = table_number_0(_S248) - table_number_0(_S247);
    var _S250 : f32 = table_number_0(_S248 + u32(1)) - table_number_0(_S247 + u32(1));
    return vec3<f32>(_S249 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_3 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_3 + _S246 * families_0[family_12].visible_total_0, _S250 - _S249 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S246 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S250 + stretch_1.high_7.cell_5 - stretch_1.low_7.cell_5 + _S246 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S251 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S252 : u32 = families_0[family_13].colour_threads_0 + _S251 * stretch_2.low_7.thread_3 + quantity_0;
    var _S253 : u32 = families_0[family_13].colour_threads_0 + _S251 * stretch_2.high_7.thread_3 + quantity_0;
    var _S254 : u32 = families_0[family_13].colour_threads_0 + _S251 * u32(families_0[family_13].count_0) + quantity_0;
    var _S255 : f32 = table_number_0(_S252);
    var _S256 : f32 = table_number_0(_S253);
    var _S257 : f32 = Stretch_turns_0(stretch_2);
    var _S258 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S253 + families_0[family_13].quantities_0) - table_number_0(_S252 + families_0[family_13].quantities_0) + _S256 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_3 - _S255 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_3 + _S257 * table_number_0(_S254 + families_0[family_13].quantities_0), table_number_0(_S253 + _S258) - table_number_0(_S252 + _S258) + _S256 * stretch_2.high_7.cell_5 - _S255 * stretch_2.low_7.cell_5 + _S257 * table_number_0(_S254 + _S258));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_7.thread_3) < (this_7.low_7.thread_3);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S259 : u32 = entries_0.z;
    var _S260 : u32 = entries_0.x;
    return vec4<u32>(_S259 - _S260 + select(u32(0), whole_0, Stretch_wraps_0(this_8)), entries_0.w - _S259, entries_0.y - _S260, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_8 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S261 : u32 = row_8 + across_1.low_7.thread_3 * quantities_1;
    var _S262 : u32 = row_8 + across_1.high_7.thread_3 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S261], words_0[_S261 + quantities_1], words_0[_S262], words_0[_S262 + quantities_1]), words_0[row_8 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_9.high_7.visible_0, - this_9.low_7.visible_0, Stretch_turns_0(this_9) - select(0.0f, 1.0f, Stretch_wraps_0(this_9)));
}

fn integral_on_top_0( family_14 : u32,  across_2 : Stretch_0,  along_2 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S263 : u32 = u32(families_0[family_14].count_0);
    var _S264 : u32 = (_S263 + u32(1)) * families_0[family_14].quantities_0;
    var _S265 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S266 : vec4<u32> = row_differences_0(across_2, _S265 + along_2.low_7.thread_3 * _S264, _S263, families_0[family_14].quantities_0);
    var _S267 : vec4<u32> = row_differences_0(across_2, _S265 + along_2.high_7.thread_3 * _S264, _S263, families_0[family_14].quantities_0);
    var _S268 : vec4<u32> = row_differences_0(across_2, _S265 + crossing_count_0 * _S264, _S263, families_0[family_14].quantities_0);
    var _S269 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S267 - _S266 + select_vector_3(Stretch_wraps_0(along_2), _S268, vec4<u32>(vec4<i32>(i32(0)))))), _S269), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S265 + (along_2.high_7.thread_3 + u32(1)) * _S264, _S263, families_0[family_14].quantities_0) - _S267)), _S269), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S265 + (along_2.low_7.thread_3 + u32(1)) * _S264, _S263, families_0[family_14].quantities_0) - _S266)), _S269), dot(vec4<f32>(vec4<i32>(_S268)), _S269)), Stretch_weights_0(along_2)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_9 : u32) -> Albedos_0
{
    var _S270 : Albedos_0 = table_albedos_0(row_9);
    var sum_0 : Albedos_0;
    var _S271 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S271 * _S270.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S271 * _S270.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S271 * _S270.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S271 * _S270.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S272 : vec3<f32> = lengths_0(crossing_0, other_0);
    var is_exposed_0 : bool = false;
    var weight_1 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_15].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S273 : vec2<f32> = integrals_along_0(family_15, own_0, quantity_2);
        var _S274 : f32 = integral_on_top_0(family_15, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S275 : f32 = _S273.x;
        var _S276 : f32 = _S275 * _S272.x;
        var _S277 : f32 = select(_S274, _S276 - _S274, back_3);
        var _S278 : bool = quantity_2 == u32(0);
        if(_S278)
        {
            is_exposed_0 = _S277 > (16.0f * families_0[family_15].area_unit_0 * min(_S276 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S276);
        }
        var _S279 : f32 = _S275 * _S272.y + select(0.0f, _S277, is_exposed_0) + 0.000244140625f * _S272.z * _S273.y;
        if(_S278)
        {
            weight_1 = 1.0f / max(_S279, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S279 * weight_1, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn uniform_hash_0( thread_4 : u32,  cell_6 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_4, stream_1), cell_6)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_5 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S280 : u32 = pixel_0.x;
    var _S281 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S280, _S281, stream_2), uniform_hash_0(_S280, _S281, stream_2 + u32(1))) + vec2<f32>(f32((index_5 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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

fn choose_0( table_0 : u32,  count_3 : u32,  number_3 : f32) -> Choice_0
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
        var _S282 : u32 = (low_8 + high_8) / u32(2);
        if((scene_number_0(table_0 + _S282)) <= number_3)
        {
            low_8 = _S282;
        }
        else
        {
            high_8 = _S282;
        }
    }
    var _S283 : u32 = table_0 + low_8;
    var _S284 : f32 = scene_number_0(_S283);
    var _S285 : f32 = scene_number_0(_S283 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_7 = low_8;
    choice_0.remainder_0 = saturate((number_3 - _S284) / max(_S285 - _S284, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_8 : f32) -> vec2<f32>
{
    var _S286 : f32 = floor(x_8 * 0.63661974668502808f + 0.5f);
    var _S287 : f32 = x_8 - _S286 * 1.5703125f - _S286 * 0.00048375129699707f - _S286 * 7.54979012640433211e-08f;
    var _S288 : f32 = _S287 * _S287;
    var _S289 : f32 = ((-0.00019515295571182f * _S288 + 0.00833216123282909f) * _S288 - 0.16666655242443085f) * _S288 * _S287 + _S287;
    var _S290 : f32 = ((0.00002443315679557f * _S288 - 0.00138873164542019f) * _S288 + 0.04166664555668831f) * _S288 * _S288 - 0.5f * _S288 + 1.0f;
    var _S291 : u32 = (u32(i32(_S286)) & (u32(3)));
    var _S292 : vec2<f32> = select_vector_1(((_S291 & (u32(1)))) != u32(0), vec2<f32>(_S290, _S289), vec2<f32>(_S289, _S290));
    var _S293 : f32 = _S292.x;
    var _S294 : f32 = _S292.y;
    return vec2<f32>(select(_S293, - _S293, ((_S291 & (u32(2)))) != u32(0)), select(_S294, - _S294, (((_S291 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_9 : f32,
     y_1 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_22 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_22];
    record_1.x_9 = (bitcast<f32>((scene_words_0[first_22 + u32(1)])));
    record_1.y_1 = (bitcast<f32>((scene_words_0[first_22 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_22 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_22 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_22 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_22 + u32(6)])));
    return record_1;
}

fn unmapped_0( output_9 : f32,  scale_0 : f32) -> f32
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

fn mirrored_bundle_0( bundle_0 : u32) -> u32
{
    return select(bundle_0 / u32(3) * u32(3) + u32(3) - u32(1) - bundle_0 % u32(3), bundle_0, bundle_0 == u32(24));
}

fn light_visibility_of_0( diffuse_0 : f32,  light_1 : vec3<f32>,  view_1 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S295 : f32 = max(abs(light_1.z), 0.00100000004749745f);
    var _S296 : vec2<f32> = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S295, (0.59700000286102295f * _S295 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S296, view_1.xy) * rsqrt_0(max(dot(_S296, _S296), 9.99999997475242708e-07f))) + 1.0f), blend_0);
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
     warp_3 : Blocked_0,
     weft_3 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_1 : CloseUp_0;
    nothing_1.weight_2 = 0.0f;
    var _S297 : Blocked_0 = no_blocked_0();
    nothing_1.warp_3 = _S297;
    nothing_1.weft_3 = _S297;
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
     warp_4 : vec3<f32>,
     weft_4 : vec3<f32>,
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
    var _S298 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S299 : vec3<f32> = sends_0.sky_warp_0 + _S298 * sends_0.crossing_warp_0;
    found_0.warp_4 = _S299;
    var _S300 : vec3<f32> = sends_0.sky_weft_0 + _S298 * sends_0.crossing_weft_0;
    found_0.weft_4 = _S300;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S299 + vec3<f32>(sends_0.blocks_weft_0) * _S300;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S301 : f32 = 1.0f - view_2.z;
    var _S302 : f32 = _S301 * _S301;
    (*terms_0)[i32(0)] = 1.0f;
    var _S303 : f32 = view_2.x;
    var _S304 : f32 = _S303 * _S303;
    var _S305 : f32 = view_2.y;
    var _S306 : f32 = _S305 * _S305;
    (*terms_0)[i32(1)] = sqrt(max(_S304 + _S306, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S302;
    (*terms_0)[i32(3)] = _S302 * _S302;
    (*terms_0)[i32(4)] = _S304 - _S306;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_3 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S307 : f32 = 1.0f - view_3.z;
    var _S308 : f32 = _S307 * _S307;
    (*terms_1)[i32(0)] = 1.0f;
    var _S309 : f32 = view_3.x;
    var _S310 : f32 = _S309 * _S309;
    var _S311 : f32 = view_3.y;
    var _S312 : f32 = _S311 * _S311;
    (*terms_1)[i32(1)] = sqrt(max(_S310 + _S312, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S308;
    (*terms_1)[i32(3)] = _S308 * _S308;
    (*terms_1)[i32(4)] = _S310 - _S312;
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
     warp_5 : vec3<f32>,
     weft_5 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S313 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S314 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_5 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_5) + _S314 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S314 * interior_0.far_1 + yarn_0.back_4 * _S313;
    return bounced_0;
}

fn sum_of_0( first_23 : Bounced_0,  second_1 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_23.reflected_0 + second_1.reflected_0;
    sum_1.transmitted_0 = first_23.transmitted_0 + second_1.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_2 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S315 : f32 = light_2.z;
    return select_vector_2((_S315 * view_4.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S315) * 0.31830987334251404f));
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
    var _S316 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S317 : f32 = 2.0f * sqrt(_S316) - 1.0f;
    var _S318 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S317, _S318), 0.00999999977648258f, 1.0f), clamp((1.0f - _S316) * sheen_shear_0(_S317, _S318), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S317, _S318), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_5 : vec3<f32>,  scale_1 : f32,  shear_0 : f32) -> f32
{
    var _S319 : f32 = light_3.z;
    if(((_S319 <= 0.0f) | (((view_5.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S320 : vec2<f32> = view_5.xy;
    var _S321 : f32 = dot(_S320, _S320);
    var _S322 : vec2<f32> = select_vector_1(_S321 > 9.99999968265522539e-21f, _S320 * vec2<f32>(rsqrt_0(max(_S321, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S323 : f32 = scale_1 * dot(light_3.xy, _S322) + shear_0 * _S319;
    var _S324 : f32 = scale_1 * (light_3.y * _S322.x - light_3.x * _S322.y);
    var _S325 : f32 = _S323 * _S323 + _S324 * _S324 + _S319 * _S319;
    return 0.31830987334251404f * scale_1 * scale_1 * _S319 / max(_S325 * _S325, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  strength_0 : f32,  roughness_2 : f32) -> vec2<f32>
{
    var _S326 : vec3<f32> = sheen_lobe_0(view_6.z, roughness_2);
    var _S327 : f32 = strength_0 * _S326.z;
    return vec2<f32>(_S327 * transformed_cosine_0(light_4, view_6, _S326.x, _S326.y), 1.0f - _S327);
}

fn accumulate_0( index_8 : u32,  light_5 : vec4<f32>)
{
    var _S328 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_5;
    layers_0[index_8].share_0 = _S328 * (1.0f - light_5.w);
    return;
}

fn camera_right_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.right_x_0, frame_record_0.right_y_0, frame_record_0.right_z_0);
}

fn camera_up_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.up_x_0, frame_record_0.up_y_0, frame_record_0.up_z_0);
}

fn camera_forward_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.forward_x_0, frame_record_0.forward_y_0, frame_record_0.forward_z_0);
}

fn camera_origin_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.origin_x_0, frame_record_0.origin_y_0, frame_record_0.origin_z_0);
}

fn uneven_shift_0( _S329 : u32,  _S330 : u32,  _S331 : u32,  _S332 : vec2<f32>) -> f32
{
    var _S333 : f32 = families_0[_S331].period_0 / families_0[_S331].count_0;
    var _S334 : u32 = hash_key_0(_S330, ((fabrics_0[_S329].seed_0) ^ (u32(625341585))));
    var _S335 : vec2<f32> = vec2<f32>(_S332.x, _S332.y / 4.0f) / vec2<f32>(_S333);
    return 0.20000000298023224f * sqrt(families_0[_S331].slub_0) * _S333 * (uneven_octave_0(_S334, _S335) * 0.66666668653488159f + uneven_octave_0(_S334 + u32(1), vec2<f32>(2.0f) * _S335 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S336 : u32,  _S337 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S336].has_detail_0) == u32(0), _S337, _S337 + vec2<f32>(uneven_shift_0(_S336, u32(0), fabrics_0[_S336].warp_0, _S337), uneven_shift_0(_S336, u32(1), fabrics_0[_S336].weft_0, _S337.yx)));
}

fn face_point_0( _S338 : u32,  _S339 : u32,  _S340 : f32,  _S341 : f32) -> VisiblePoint_0
{
    var _S342 : u32 = u32(3) * _S339;
    var _S343 : Vertex_0 = vertex_at_0(_S342);
    var _S344 : Vertex_0 = vertex_at_0(_S342 + u32(1));
    var _S345 : Vertex_0 = vertex_at_0(_S342 + u32(2));
    var _S346 : vec3<f32> = position_of_0(_S343);
    var _S347 : vec3<f32> = position_of_0(_S344) - _S346;
    var _S348 : vec3<f32> = position_of_0(_S345) - _S346;
    var _S349 : f32 = _S344.u_0 - _S343.u_0;
    var _S350 : f32 = _S344.v_0 - _S343.v_0;
    var _S351 : vec2<f32> = vec2<f32>(_S349, _S350);
    var _S352 : f32 = _S345.u_0 - _S343.u_0;
    var _S353 : f32 = _S345.v_0 - _S343.v_0;
    var _S354 : vec2<f32> = vec2<f32>(_S352, _S353);
    var _S355 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S349 * _S353 - _S350 * _S352) < 0.0f));
    var _S356 : vec3<f32> = _S355 * (vec3<f32>(_S353) * _S347 - vec3<f32>(_S350) * _S348);
    var _S357 : vec3<f32> = _S355 * (vec3<f32>(_S349) * _S348 - vec3<f32>(_S352) * _S347);
    var point_1 : VisiblePoint_0;
    var _S358 : vec3<f32> = vec3<f32>(_S340);
    var _S359 : vec3<f32> = vec3<f32>(_S341);
    var _S360 : vec3<f32> = normalize(vec3<f32>((1.0f - _S340 - _S341)) * normal_of_0(_S343) + _S358 * normal_of_0(_S344) + _S359 * normal_of_0(_S345));
    point_1.normal_0 = _S360;
    var _S361 : vec3<f32> = normalize(_S356 - _S360 * vec3<f32>(dot(_S360, _S356)));
    point_1.axis_x_0 = _S361;
    point_1.axis_y_0 = cross(_S360, _S361);
    var _S362 : vec3<f32> = normalize(cross(_S347, _S348));
    point_1.face_normal_0 = select_vector_2((dot(_S362, _S360)) < 0.0f, (vec3<f32>(0) - _S362), _S362);
    point_1.position_4 = _S346 + _S358 * _S347 + _S359 * _S348;
    point_1.view_0 = _S360;
    var _S363 : vec2<f32> = vec2<f32>(_S343.u_0, _S343.v_0) + vec2<f32>(_S340) * _S351 + vec2<f32>(_S341) * _S354;
    point_1.uv_1 = _S363;
    var _S364 : bool = (dot(cross(_S356, _S357), _S360)) < 0.0f;
    var _S365 : vec2<f32> = vec2<f32>(fabrics_0[_S338].uv_width_0, select(fabrics_0[_S338].uv_height_0, - fabrics_0[_S338].uv_height_0, _S364));
    point_1.draft_per_uv_0 = _S365;
    point_1.draft_0 = uneven_place_0(_S338, _S363 * _S365 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S338].uv_height_0, _S364)));
    var _S366 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S366;
    point_1.draft_dy_0 = _S366;
    return point_1;
}

fn visible_point_0( _S367 : u32,  _S368 : u32,  _S369 : vec2<u32>) -> VisiblePoint_0
{
    var _S370 : u32 = u32(3) * _S368;
    var _S371 : Vertex_0 = vertex_at_0(_S370);
    var _S372 : Vertex_0 = vertex_at_0(_S370 + u32(1));
    var _S373 : Vertex_0 = vertex_at_0(_S370 + u32(2));
    var _S374 : vec3<f32> = position_of_0(_S371);
    var _S375 : vec3<f32> = position_of_0(_S372) - _S374;
    var _S376 : vec3<f32> = position_of_0(_S373) - _S374;
    var _S377 : vec3<f32> = cross(_S375, _S376);
    var _S378 : f32 = f32(frame_record_0.width_0);
    var _S379 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S378));
    var _S380 : f32 = f32(frame_record_0.height_0);
    var _S381 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S380));
    var _S382 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S369.x) + 0.5f - 0.5f * _S378)) * _S379 + vec3<f32>((f32(_S369.y) + 0.5f - 0.5f * _S380)) * _S381;
    var _S383 : f32 = dot(_S382, _S377);
    var _S384 : f32 = 1.0f / select(1.00000000317107685e-30f, _S383, (abs(_S383)) > 1.00000000317107685e-30f);
    var _S385 : vec3<f32> = _S374 - camera_origin_0();
    var _S386 : vec3<f32> = vec3<f32>((dot(_S385, _S377) * _S384));
    var _S387 : vec3<f32> = _S382 * _S386 - _S385;
    var _S388 : vec3<f32> = _S386 * (_S379 - _S382 * vec3<f32>((dot(_S379, _S377) * _S384)));
    var _S389 : vec3<f32> = _S386 * (_S381 - _S382 * vec3<f32>((dot(_S381, _S377) * _S384)));
    var _S390 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S377), 1.00000000317107685e-30f)));
    var _S391 : vec3<f32> = cross(_S376, _S377) * _S390;
    var _S392 : vec3<f32> = cross(_S377, _S375) * _S390;
    var _S393 : vec2<f32> = vec2<f32>(_S372.u_0 - _S371.u_0, _S372.v_0 - _S371.v_0);
    var _S394 : vec2<f32> = vec2<f32>(_S373.u_0 - _S371.u_0, _S373.v_0 - _S371.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S367, _S368, dot(_S387, _S391), dot(_S387, _S392));
    point_2.position_4 = _S374 + _S387;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S382));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S388, _S391)) * _S393 + vec2<f32>(dot(_S388, _S392)) * _S394) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S389, _S391)) * _S393 + vec2<f32>(dot(_S389, _S392)) * _S394) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S395 : u32,  _S396 : VisiblePoint_0) -> vec3<f32>
{
    var _S397 : u32 = fabrics_0[_S395].albedo_map_levels_0;
    if((fabrics_0[_S395].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S398 : vec2<f32> = vec2<f32>(fabrics_0[_S395].uv_width_0, fabrics_0[_S395].uv_height_0);
    var _S399 : vec2<f32> = _S396.draft_dx_0 / _S398;
    var _S400 : vec2<f32> = _S396.draft_dy_0 / _S398;
    var _S401 : u32 = _S397 - u32(1);
    var _S402 : u32 = (u32(1) << (_S401));
    var _S403 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S399.x * _S400.y - _S399.y * _S400.x), 9.99999968265522539e-21f) * (square_1(f32(_S402)) / 3.0f)), 0.0f, f32(_S397) - 1.0f);
    var _S404 : u32 = min(u32(_S403), max(_S397, u32(2)) - u32(2));
    var _S405 : u32 = min(_S404 + u32(1), _S401);
    var _S406 : u32 = (u32(1) << ((u32(2) * _S397)));
    return mix(map_level_0(fabrics_0[_S395].albedo_map_0 + (_S406 - ((_S406 >> ((u32(2) * _S404))))) / u32(3), (_S402 >> (_S404)), _S396.uv_1), map_level_0(fabrics_0[_S395].albedo_map_0 + (_S406 - ((_S406 >> ((u32(2) * _S405))))) / u32(3), (_S402 >> (_S405)), _S396.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S403 - f32(_S404))) - 1.0f) / 3.0f)));
}

fn irregular_key_0( _S407 : u32,  _S408 : u32) -> u32
{
    return hash_key_0(_S408, ((fabrics_0[_S407].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S409 : u32,  _S410 : vec2<f32>,  _S411 : f32) -> vec2<f32>
{
    var _S412 : u32 = fabrics_0[_S409].warp_0;
    var _S413 : u32 = fabrics_0[_S409].weft_0;
    var _S414 : bool = (((fabrics_0[_S409].is_irregular_0) != u32(0)) & (((max(moved_share_0(fabrics_0[_S409].warp_0, _S411), moved_share_0(fabrics_0[_S409].weft_0, _S411))) > 0.0f)));
    var number_4 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S410;
    for(;;)
    {
        if(number_4 < select(u32(0), u32(2), _S414))
        {
        }
        else
        {
            break;
        }
        var _S415 : bool = number_4 == u32(0);
        var _S416 : u32 = select(_S413, _S412, _S415);
        var _S417 : vec2<f32> = select_vector_1(_S415, _S410, _S410.yx);
        var _S418 : u32 = irregular_key_0(_S409, number_4);
        var _S419 : f32 = _S417.x;
        var _S420 : Cell_0 = locate_0(_S416, _S419);
        var _S421 : f32 = irregular_thread_0(_S416, _S419, _S420);
        var _S422 : f32 = select(1.0f, -1.0f, (_S420.across_0) < 0.0f);
        var _S423 : vec2<f32> = vec2<f32>(0.0f);
        var other_1 : vec2<f32> = _S423;
        var own_1 : vec2<f32> = _S423;
        var neighbour_0 : u32 = u32(0);
        for(;;)
        {
            if(neighbour_0 < u32(2))
            {
            }
            else
            {
                break;
            }
            var _S424 : vec2<f32> = irregular_at_0(_S416, _S418, _S421 + _S422 * f32(neighbour_0), _S417.y).xy;
            var _S425 : u32 = neighbour_0 + u32(1);
            own_1 = other_1;
            other_1 = _S424;
            neighbour_0 = _S425;
        }
        var _S426 : f32 = _S420.below_0 + _S420.above_0;
        var _S427 : f32 = min(_S420.half_width_1 / _S426, 0.5f);
        var _S428 : f32 = min(_S427 * (2.0f + own_1.y + other_1.y), 1.0f);
        var _S429 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_1.x, other_1.x), vec2<f32>(0.25f)));
        var _S430 : f32 = _S429.x;
        var _S431 : f32 = _S428 * _S430 / (_S430 + _S429.y);
        var _S432 : f32 = abs(_S420.across_0) / _S426;
        var _S433 : f32 = 1.0f - _S428;
        var _S434 : f32 = _S432 - _S431;
        var _S435 : f32 = moved_share_0(_S416, _S411) * _S422 * _S426 * (select(select((_S434 - _S433) / max(_S428 - _S431, 9.99999997475242708e-07f) * _S427 + (1.0f - _S427), _S434 / max(_S433, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S427) + _S427, _S434 < _S433), _S432 * _S427 / _S431, _S434 < 0.0f) - _S432);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S415, vec2<f32>(_S435, 0.0f), vec2<f32>(0.0f, _S435));
        number_4 = number_4 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct NeuralView_0
{
     sums_9 : array<f32, i32(96)>,
     even_hole_0 : f32,
     hole_0 : f32,
     yarns_0 : Yarns_0,
     correction_weight_0 : f32,
     view_7 : vec3<f32>,
     back_5 : bool,
};

fn anisotropic_taps_0( _S436 : u32,  _S437 : Footprint_0) -> AnisotropicTaps_0
{
    var _S438 : vec3<f32> = row_of_taps_0(_S437);
    var _S439 : vec2<f32> = _S437.dx_0;
    var _S440 : vec2<f32> = _S437.dy_0;
    var _S441 : f32 = dot(_S439, _S439) + dot(_S440, _S440);
    var _S442 : f32 = _S437.dx_0.x * _S437.dy_0.y - _S437.dx_0.y * _S437.dy_0.x;
    var _S443 : f32 = 0.5f * (_S441 + sqrt(max(_S441 * _S441 - 4.0f * _S442 * _S442, 0.0f)));
    var _S444 : bool = ((_S443 < (5.5f * (_S441 - _S443))) & ((_S441 > (8.0f * fabrics_0[_S436].neural_0.pitch_0 * fabrics_0[_S436].neural_0.pitch_0))));
    var _S445 : vec2<f32> = vec2<f32>(fabrics_0[_S436].neural_0.ends_per_mm_0, fabrics_0[_S436].neural_0.picks_per_mm_0);
    var taps_1 : AnisotropicTaps_0;
    taps_1.centre_1 = _S437.centre_0 * _S445;
    taps_1.side_2 = select(_S438.x, sqrt(0.125f * _S441), _S444) / fabrics_0[_S436].neural_0.pitch_0;
    var _S446 : vec2<f32> = vec2<f32>(0.25f);
    var _S447 : vec2<f32> = _S438.yz;
    taps_1.first_21 = select_vector_1(_S444, _S446 * _S437.dx_0, _S447) * _S445;
    taps_1.second_0 = select_vector_1(_S444, _S446 * _S437.dy_0, vec2<f32>(0.5f) * _S447) * _S445;
    return taps_1;
}

fn taps_at_yarns_0( _S448 : u32,  _S449 : Footprint_0,  _S450 : AnisotropicTaps_0,  _S451 : vec3<f32>,  _S452 : bool) -> AnisotropicTaps_0
{
    return _S450;
}

fn add_texel_0( _S453 : u32,  _S454 : u32,  _S455 : f32,  _S456 : ptr<function, array<f32, i32(88)>>)
{
    var _S457 : u32 = fabrics_0[_S453].neural_0.latents_0 + _S454 * u32(8);
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
        var _S458 : Eight_0 = eight_halves_0(packed_numbers_0[_S457 + part_0]);
        var _S459 : i32 = i32(u32(8) * part_0);
        (*_S456)[_S459] = (*_S456)[_S459] + _S455 * _S458.low_0[i32(0)];
        (*_S456)[_S459 + i32(4)] = (*_S456)[_S459 + i32(4)] + _S455 * _S458.high_0[i32(0)];
        var _S460 : i32 = _S459 + i32(1);
        (*_S456)[_S460] = (*_S456)[_S460] + _S455 * _S458.low_0[i32(1)];
        (*_S456)[_S460 + i32(4)] = (*_S456)[_S460 + i32(4)] + _S455 * _S458.high_0[i32(1)];
        var _S461 : i32 = _S459 + i32(2);
        (*_S456)[_S461] = (*_S456)[_S461] + _S455 * _S458.low_0[i32(2)];
        (*_S456)[_S461 + i32(4)] = (*_S456)[_S461 + i32(4)] + _S455 * _S458.high_0[i32(2)];
        var _S462 : i32 = _S459 + i32(3);
        (*_S456)[_S462] = (*_S456)[_S462] + _S455 * _S458.low_0[i32(3)];
        (*_S456)[_S462 + i32(4)] = (*_S456)[_S462 + i32(4)] + _S455 * _S458.high_0[i32(3)];
        part_0 = part_0 + u32(1);
    }
    return;
}

fn add_level_0( _S463 : u32,  _S464 : u32,  _S465 : bool,  _S466 : vec2<f32>,  _S467 : f32,  _S468 : ptr<function, array<f32, i32(88)>>)
{
    var _S469 : Neural_std430_0 = fabrics_0[_S463].neural_0;
    var _S470 : u32 = fabrics_0[_S463].neural_0.levels_1 + u32(4) * _S464;
    var _S471 : f32 = table_number_0(_S470);
    var _S472 : f32 = table_number_0(_S470 + u32(1));
    var _S473 : f32 = table_number_0(_S470 + u32(2));
    var _S474 : vec2<f32> = _S466 * vec2<f32>(table_number_0(_S470 + u32(3))) - vec2<f32>(select(0.5f, 1.0f, ((_S464 > u32(3)) & ((_S464 < (fabrics_0[_S463].neural_0.top_level_0))))));
    var _S475 : vec2<f32> = floor(_S474);
    var _S476 : vec2<f32> = _S474 - _S475;
    var corner_1 : u32 = u32(0);
    for(;;)
    {
        if(corner_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S477 : f32 = f32((corner_1 & (u32(1))));
        var _S478 : f32 = f32((corner_1 >> (u32(1))));
        var _S479 : vec2<f32> = mix(vec2<f32>(1.0f) - _S476, _S476, vec2<f32>(_S477, _S478));
        add_texel_0(_S463, u32(_S471 + wrapped_0(_S475.y + _S478, _S473) * _S472 + wrapped_0(_S475.x + _S477, _S472)) + select(u32(0), _S469.texels_0, _S465), _S467 * _S479.x * _S479.y, &((*_S468)));
        corner_1 = corner_1 + u32(1);
    }
    return;
}

fn code_footprint_0( _S480 : u32,  _S481 : AnisotropicTaps_0,  _S482 : vec3<f32>,  _S483 : bool,  _S484 : ptr<function, array<f32, i32(88)>>)
{
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
        (*_S484)[k_0] = 0.0f;
        k_0 = k_0 + i32(1);
    }
    var _S485 : vec2<f32> = vec2<f32>(fabrics_0[_S480].neural_0.ends_0, fabrics_0[_S480].neural_0.picks_0);
    var _S486 : f32 = f32(fabrics_0[_S480].neural_0.top_level_0);
    var _S487 : f32 = clamp(binary_logarithm_0(max(_S481.side_2, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S486);
    var _S488 : f32 = min(floor(_S487), _S486 - 1.0f);
    var _S489 : u32 = select(u32(1), u32(4), AnisotropicTaps_has_steps_0(_S481));
    var number_5 : u32 = u32(0);
    for(;;)
    {
        if(number_5 < (u32(2) * _S489))
        {
        }
        else
        {
            break;
        }
        var _S490 : vec2<f32> = AnisotropicTaps_place_0(_S481, (number_5 >> (u32(1))));
        var _S491 : bool = ((number_5 & (u32(1)))) != u32(0);
        var _S492 : f32 = _S487 - _S488;
        add_level_0(_S480, u32(_S488) + select(u32(0), u32(1), _S491), _S483, clamp(_S490 - _S485 * floor(_S490 / _S485), vec2<f32>(0.0f), _S485), select(1.0f - _S492, _S492, _S491) / f32(_S489), &((*_S484)));
        number_5 = number_5 + u32(1);
    }
    var number_6 : i32 = i32(0);
    for(;;)
    {
        if(number_6 < i32(3))
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
            var offset_1 : f32 = _S482[number_6] - (f32(bin_0) + 0.5f) / 8.0f;
            var offset_2 : f32;
            if(number_6 < i32(2))
            {
                offset_2 = offset_1 - round(offset_1);
            }
            else
            {
                offset_2 = offset_1;
            }
            (*_S484)[i32(64) + number_6 * i32(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + i32(1);
        }
        number_6 = number_6 + i32(1);
    }
    return;
}

fn crown_fibres_0( _S493 : u32,  _S494 : bool,  _S495 : bool) -> vec3<f32>
{
    if(_S494)
    {
        return vec3<f32>(select(1.0f, -1.0f, _S495) * fabrics_0[_S493].neural_0.warp_x_0, fabrics_0[_S493].neural_0.warp_y_0, fabrics_0[_S493].neural_0.warp_roughness_0);
    }
    return vec3<f32>(fabrics_0[_S493].neural_0.weft_x_0, select(1.0f, -1.0f, _S495) * fabrics_0[_S493].neural_0.weft_y_0, fabrics_0[_S493].neural_0.weft_roughness_0);
}

fn yarns_over_0( _S496 : u32,  _S497 : Footprint_0,  _S498 : bool) -> Yarns_0
{
    var _S499 : vec2<f32> = _S497.dx_0;
    var _S500 : vec2<f32> = _S497.dy_0;
    var _S501 : vec2<f32> = sqrt(_S499 * _S499 + _S500 * _S500);
    var _S502 : f32 = Footprint_spread_side_0(_S497);
    var _S503 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_1 : Yarns_0 = Yarns_x24init_0(_S503, _S503, vec3<f32>(0.0f));
    var _S504 : bool = (fabrics_0[_S496].is_irregular_0) != u32(0);
    var number_7 : u32 = u32(0);
    for(;;)
    {
        if(number_7 < select(u32(0), u32(2), _S504))
        {
        }
        else
        {
            break;
        }
        var _S505 : bool = number_7 == u32(0);
        var _S506 : u32 = select(fabrics_0[_S496].weft_0, fabrics_0[_S496].warp_0, _S505);
        var _S507 : vec2<f32> = select_vector_1(_S505, _S497.centre_0, _S497.centre_0.yx);
        var _S508 : vec2<f32> = select_vector_1(_S505, _S501, _S501.yx);
        var _S509 : f32 = _S507.x;
        var _S510 : Cell_0 = locate_0(_S506, _S509);
        var yarn_1 : vec4<f32> = irregular_over_0(_S506, irregular_key_0(_S496, number_7), irregular_thread_0(_S506, _S509, _S510) + _S510.below_0 / (_S510.below_0 + _S510.above_0), _S508.x * (families_0[_S506].count_0 / families_0[_S506].period_0), _S507.y, _S508.y);
        yarn_1[i32(1)] = yarn_1[i32(1)] * (1.0f - moved_share_0(_S506, _S502));
        yarns_1.warp_1 = yarns_1.weft_1;
        yarns_1.weft_1 = yarn_1;
        number_7 = number_7 + u32(1);
    }
    var _S511 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S496].warp_0].cover_0, families_0[fabrics_0[_S496].weft_0].cover_0);
    var _S512 : f32 = select(fabrics_0[_S496].warp_on_top_0, 1.0f - fabrics_0[_S496].warp_on_top_0, _S498);
    var _S513 : vec3<f32> = shown_of_covers_0(_S511, _S512);
    var _S514 : vec3<f32> = select_vector_2(_S504, shown_of_covers_0(saturate(_S511 + _S511 * vec2<f32>(yarns_1.warp_1.y, yarns_1.weft_1.y)), _S512) / max(_S513, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_1.shares_0 = _S514;
    yarns_1.shares_0[i32(2)] = select(1.0f, _S514.z, (_S513.z) > 0.00009999999747379f);
    return yarns_1;
}

fn neural_view_0( _S515 : u32,  _S516 : Footprint_0,  _S517 : vec3<f32>,  _S518 : ptr<function, NeuralView_0>)
{
    var _S519 : bool = (_S517.z) < 0.0f;
    var _S520 : vec3<f32> = to_face_frame_0(_S517, _S519);
    var _S521 : AnisotropicTaps_0 = taps_at_yarns_0(_S515, _S516, anisotropic_taps_0(_S515, _S516), _S520, _S519);
    var _S522 : vec3<f32> = footprint_coordinates_0(_S521);
    var weights_23 : HalfWeights_0;
    weights_23.first_2 = fabrics_0[_S515].neural_0.network_0;
    var inputs_23 : array<f32, i32(88)>;
    code_footprint_0(_S515, _S521, _S522, _S519, &(inputs_23));
    var hidden_1 : array<f32, i32(96)>;
    dense_7(weights_23, u32(0), false, &(inputs_23), &(hidden_1));
    var fused_0 : array<f32, i32(100)>;
    dense_part_8(weights_23, u32(1068), false, &(hidden_1), &(fused_0));
    fused_0[i32(96)] = _S520.x;
    fused_0[i32(97)] = _S520.y;
    var _S523 : vec2<f32> = _S520.xy;
    fused_0[i32(98)] = dot(crown_fibres_0(_S515, true, _S519).xy, _S523);
    fused_0[i32(99)] = dot(crown_fibres_0(_S515, false, _S519).xy, _S523);
    var of_hole_0 : array<f32, i32(16)>;
    dense_6(weights_23, u32(2232), false, &(fused_0), &(of_hole_0));
    var hole_1 : array<f32, i32(1)>;
    dense_5(weights_23, u32(2444), false, &(of_hole_0), &(hole_1));
    var _S524 : array<f32, i32(96)> = (*_S518).sums_9;
    dense_4(weights_23, u32(2456), false, &(fused_0), &(_S524));
    (*_S518).sums_9 = _S524;
    var _S525 : f32 = clamp(hole_1[i32(0)], 0.0f, 1.0f);
    (*_S518).even_hole_0 = _S525;
    (*_S518).yarns_0 = yarns_over_0(_S515, _S516, _S519);
    (*_S518).hole_0 = min(_S525 * (*_S518).yarns_0.shares_0.z, 1.0f);
    (*_S518).correction_weight_0 = correction_weight_of_0(_S522.z);
    (*_S518).view_7 = _S520;
    (*_S518).back_5 = _S519;
    return;
}

struct FamilyAlbedos_0
{
     warp_6 : Albedos_0,
     weft_6 : Albedos_0,
};

fn albedos_over_0( _S526 : u32,  _S527 : Footprint_0,  _S528 : bool) -> FamilyAlbedos_0
{
    var _S529 : vec2<f32> = _S527.dx_0;
    var _S530 : vec2<f32> = _S527.dy_0;
    var _S531 : vec2<f32> = sqrt(_S529 * _S529 + _S530 * _S530);
    var _S532 : Stretch_0 = stretch_of_0(fabrics_0[_S526].warp_0, _S527.centre_0.x, _S531.x);
    var _S533 : Stretch_0 = stretch_of_0(fabrics_0[_S526].weft_0, _S527.centre_0.y, _S531.y);
    var albedos_4 : FamilyAlbedos_0;
    albedos_4.warp_6 = mean_albedos_0(fabrics_0[_S526].warp_0, fabrics_0[_S526].weft_0, _S532, _S533, _S528);
    albedos_4.weft_6 = mean_albedos_0(fabrics_0[_S526].weft_0, fabrics_0[_S526].warp_0, _S533, _S532, _S528);
    return albedos_4;
}

fn toned_0( _S534 : u32,  _S535 : u32,  _S536 : Albedos_0,  _S537 : vec4<f32>) -> Albedos_0
{
    var _S538 : vec3<f32> = _S536.diffuse_reflect_0 + _S536.diffuse_transmit_0;
    var _S539 : vec3<f32> = vec3<f32>(1.0f);
    var _S540 : vec3<f32> = _S539 - vec3<f32>(fabrics_0[_S534].layer_bound_0) * max(_S536.specular_reflect_0, _S536.specular_transmit_0);
    var _S541 : vec3<f32> = vec3<f32>(0.0f);
    var _S542 : vec3<f32> = max(_S539 - _S538, _S541) / (_S539 + _S538);
    var _S543 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S544 : vec3<f32> = (_S540 / max(_S538, _S543) - _S539) / max(vec3<f32>(0.89999997615814209f) * _S542, _S543);
    var _S545 : vec3<f32> = _S539 - vec3<f32>((saturate(min(min(_S544.x, _S544.y), _S544.z)) * _S537.z)) * _S542;
    var _S546 : vec3<f32> = min(vec3<f32>(families_0[_S535].nep_red_0, families_0[_S535].nep_green_0, families_0[_S535].nep_blue_0), _S540);
    var found_1 : Albedos_0 = _S536;
    var _S547 : f32 = _S537.w;
    var _S548 : vec3<f32> = _S545 * _S536.diffuse_transmit_0 * vec3<f32>((1.0f - _S547));
    found_1.diffuse_transmit_0 = _S548;
    found_1.diffuse_reflect_0 = clamp(mix(_S545 * _S536.diffuse_reflect_0, _S546, vec3<f32>(_S547)), _S541, max(_S540 - _S548, _S541));
    return found_1;
}

fn with_tones_0( _S549 : u32,  _S550 : FamilyAlbedos_0,  _S551 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S549].is_irregular_0) == u32(0))
    {
        return _S550;
    }
    var result_2 : FamilyAlbedos_0;
    result_2.warp_6 = toned_0(_S549, fabrics_0[_S549].warp_0, _S550.warp_6, _S551.warp_1);
    result_2.weft_6 = toned_0(_S549, fabrics_0[_S549].weft_0, _S550.weft_6, _S551.weft_1);
    return result_2;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S552 : u32,  _S553 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S552 * frame_record_0.height_0 + _S553.y) * frame_record_0.width_0 + _S553.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S554 : u32,  _S555 : u32) -> vec3<f32>
{
    var _S556 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S554 * frame_record_0.environment_columns_0 + _S555);
    return vec3<f32>(scene_number_0(_S556), scene_number_0(_S556 + u32(1)), scene_number_0(_S556 + u32(2)));
}

fn sample_environment_0( _S557 : vec2<f32>,  _S558 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S559 : u32 = frame_record_0.environment_rows_0;
    var _S560 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S557.y);
    var _S561 : u32 = frame_record_0.environment_columns_0;
    var _S562 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S560.index_7 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S557.x);
    var _S563 : vec3<f32> = environment_texel_0(_S560.index_7, _S562.index_7);
    (*_S558) = _S563 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S563), 9.99999968265522539e-21f)));
    var _S564 : f32 = 3.14159274101257324f / f32(_S559);
    var _S565 : f32 = mix(sine_cosine_0(f32(_S560.index_7) * _S564).y, sine_cosine_0(f32(_S560.index_7 + u32(1)) * _S564).y, _S560.remainder_0);
    var _S566 : f32 = sqrt(max(1.0f - _S565 * _S565, 0.0f));
    var _S567 : vec2<f32> = sine_cosine_0((f32(_S562.index_7) + _S562.remainder_0) * (6.28318548202514648f / f32(_S561)));
    var _S568 : f32 = _S566 * _S567.x;
    var _S569 : f32 = - _S566 * _S567.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S568 + frame_record_0.environment_sine_0 * _S569, _S565, frame_record_0.environment_cosine_0 * _S569 - frame_record_0.environment_sine_0 * _S568);
}

fn light_sample_0( _S570 : u32,  _S571 : vec2<u32>,  _S572 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S573 : u32 = frame_record_0.lights_0;
    if(_S570 >= (frame_record_0.lights_0))
    {
        var weight_3 : vec3<f32>;
        var _S574 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S571, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S570 - _S573), u32(3)), &(weight_3));
        sample_0.towards_0 = _S574;
        sample_0.irradiance_1 = weight_3 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S575 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S570);
    sample_0.irradiance_1 = vec3<f32>(_S575.red_0, _S575.green_0, _S575.blue_0);
    sample_0.towards_0 = vec3<f32>(_S575.x_9, _S575.y_1, _S575.z_1);
    if((_S575.is_point_0) != u32(0))
    {
        var _S576 : vec3<f32> = sample_0.towards_0 - _S572;
        var _S577 : f32 = max(square_0(_S576), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S577);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S577);
        sample_0.towards_0 = normalize(_S576);
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

fn code_light_0( _S578 : u32,  _S579 : vec3<f32>,  _S580 : vec3<f32>,  _S581 : bool,  _S582 : ptr<function, array<f32, i32(39)>>)
{
    (*_S582)[i32(0)] = _S579.x;
    (*_S582)[i32(1)] = _S579.y;
    (*_S582)[i32(2)] = _S579.z;
    var _S583 : vec3<f32> = _S579 + _S580;
    var _S584 : f32 = _S583.z;
    var _S585 : f32 = _S584 * _S584 + 0.00009999999747379f;
    var _S586 : vec2<f32> = _S583.xy;
    var _S587 : f32 = 1.0f / (dot(_S586, _S586) + _S585);
    var family_16 : i32 = i32(0);
    for(;;)
    {
        if(family_16 < i32(2))
        {
        }
        else
        {
            break;
        }
        var _S588 : vec3<f32> = crown_fibres_0(_S578, family_16 == i32(0), _S581);
        var _S589 : vec2<f32> = _S588.xy;
        (*_S582)[i32(3) + family_16] = dot(_S589, _S579.xy);
        var _S590 : f32 = dot(_S589, _S586);
        var _S591 : f32 = _S590 * _S590;
        var _S592 : f32 = (0.75f * _S590 / (0.5f * sqrt(_S591 + _S585) + abs(_S590)) + 0.5f) * 8.0f;
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
            (*_S582)[i32(5) + family_16 * i32(16) + bin_1] = bump_0(_S592 - (f32(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + i32(1);
        }
        var _S593 : f32 = _S588.z;
        var _S594 : f32 = _S593 * _S593;
        var _S595 : f32 = _S591 * _S587 * (1.0f - _S594) + _S594;
        (*_S582)[i32(37) + family_16] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S594 * _S593 / (_S595 * _S595));
        family_16 = family_16 + i32(1);
    }
    return;
}

fn mixed_bundles_0( _S596 : u32,  _S597 : u32,  _S598 : u32,  _S599 : vec3<f32>,  _S600 : vec3<f32>,  _S601 : bool,  _S602 : ptr<function, array<f32, i32(52)>>) -> f32
{
    var _S603 : vec3<f32> = _S599 + _S600;
    var _S604 : f32 = 1.0f / (square_0(_S603) + 0.00009999999747379f);
    var _S605 : f32 = _S603.x;
    var _S606 : f32 = select(_S605, - _S605, ((_S597 == u32(0)) & (_S601)));
    var _S607 : f32 = _S603.y;
    var _S608 : f32 = select(_S607, - _S607, ((_S597 == u32(1)) & (_S601)));
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
        var _S609 : u32 = _S597 * u32(25);
        var _S610 : u32 = fabrics_0[_S596].neural_0.bundles_0 + u32(4) * (_S609 + bundle_1);
        var _S611 : f32 = dot(vec3<f32>(table_number_0(_S610), table_number_0(_S610 + u32(1)), table_number_0(_S610 + u32(2))), vec3<f32>(_S606, _S608, _S603.z));
        var _S612 : f32 = _S611 * _S611 * _S604 + table_number_0(_S610 + u32(3));
        var sum_3 : f32 = sum_2 + max((*_S602)[_S598 + _S609 + select(bundle_1, mirrored_bundle_0(bundle_1), _S601)], (*_S602)[_S598 + _S609 + select(bundle_1, mirrored_bundle_0(bundle_1), _S601)] * 0.00999999977648258f) / (_S612 * _S612);
        bundle_1 = bundle_1 + u32(1);
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

fn with_shares_0( _S613 : u32,  _S614 : Components_0,  _S615 : Yarns_0) -> Components_0
{
    var result_3 : Components_0;
    var _S616 : f32 = min(_S614.hole_2 * _S615.shares_0.z, 1.0f);
    result_3.hole_2 = _S616;
    var _S617 : f32 = _S615.shares_0.x;
    result_3.diffuse_warp_0 = _S614.diffuse_warp_0 * _S617;
    var _S618 : f32 = _S615.shares_0.y;
    result_3.diffuse_weft_0 = _S614.diffuse_weft_0 * _S618;
    result_3.specular_warp_0 = _S614.specular_warp_0 * _S617;
    result_3.specular_weft_0 = _S614.specular_weft_0 * _S618;
    result_3.light_visibility_1 = _S614.light_visibility_1 * select(1.0f, (1.0f - _S616) / max(1.0f - _S614.hole_2, 9.99999997475242708e-07f), (fabrics_0[_S613].is_irregular_0) != u32(0));
    return result_3;
}

fn neural_components_0( _S619 : u32,  _S620 : ptr<function, NeuralView_0>,  _S621 : vec3<f32>) -> Components_0
{
    var _S622 : bool = (*_S620).back_5;
    var _S623 : vec3<f32> = to_face_frame_0(_S621, (*_S620).back_5);
    var _S624 : vec3<f32> = (*_S620).view_7;
    var weights_24 : HalfWeights_0;
    var _S625 : Neural_std430_0 = fabrics_0[_S619].neural_0;
    weights_24.first_2 = fabrics_0[_S619].neural_0.network_0;
    var directions_0 : array<f32, i32(39)>;
    code_light_0(_S619, _S623, (*_S620).view_7, (*_S620).back_5, &(directions_0));
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
        skip_0[k_1] = (*_S620).sums_9[k_1];
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
            next_0[k_1] = select(0.0f, skip_0[k_1], layer_0 == u32(1));
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
    var _S626 : bool;
    if((_S625.is_corrected_0) != u32(0))
    {
        _S626 = (_S623.z) > 0.0f;
    }
    else
    {
        _S626 = false;
    }
    if(_S626)
    {
        _S626 = ((*_S620).correction_weight_0) > 0.0f;
    }
    else
    {
        _S626 = false;
    }
    if(_S626)
    {
        var fitted_0 : FloatWeights_0;
        fitted_0.first_0 = _S625.correction_0;
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
            outputs_17[k_1 + i32(2)] = outputs_17[k_1 + i32(2)] + (*_S620).correction_weight_0 * change_0[k_1];
            k_1 = k_1 + i32(1);
        }
    }
    var _S627 : f32 = select(0.00100000004749745f, 0.00999999977648258f, (_S623.z) > 0.0f);
    var result_4 : Components_0;
    var _S628 : f32 = unmapped_0(outputs_17[i32(0)], _S627);
    result_4.diffuse_warp_0 = _S628;
    var _S629 : f32 = unmapped_0(outputs_17[i32(1)], _S627);
    result_4.diffuse_weft_0 = _S629;
    var _S630 : f32 = 2979.9580078125f * _S627;
    var _S631 : f32 = mixed_bundles_0(_S619, u32(0), u32(2), _S623, _S624, _S622, &(outputs_17));
    result_4.specular_warp_0 = clamp(_S631, 0.0f, _S630);
    var _S632 : f32 = mixed_bundles_0(_S619, u32(1), u32(2), _S623, _S624, _S622, &(outputs_17));
    result_4.specular_weft_0 = clamp(_S632, 0.0f, _S630);
    result_4.hole_2 = (*_S620).even_hole_0;
    result_4.light_visibility_1 = min(light_visibility_of_0(_S628 + _S629, _S623, _S624, fabrics_0[_S619].diffuse_blend_0), 1.0f - (*_S620).even_hole_0);
    return with_shares_0(_S619, result_4, (*_S620).yarns_0);
}

fn openness_number_0( _S633 : u32,  _S634 : u32) -> f32
{
    return table_number_0(fabrics_0[_S633].openness_0 + _S634);
}

fn scattered_by_0( _S635 : u32,  _S636 : Albedos_0,  _S637 : u32,  _S638 : vec3<f32>) -> Scattered_0
{
    var _S639 : u32 = u32(159) + u32(2) * _S637;
    var yarn_2 : Scattered_0;
    yarn_2.back_4 = _S638 * _S636.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S635, _S639)) * _S636.specular_reflect_0;
    yarn_2.through_0 = _S638 * _S636.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S635, _S639 + u32(1))) * _S636.specular_transmit_0;
    return yarn_2;
}

fn sent_0( _S640 : u32,  _S641 : u32,  _S642 : vec3<f32>,  _S643 : vec3<f32>,  _S644 : vec3<f32>,  _S645 : vec3<f32>,  _S646 : ptr<function, vec3<f32>>,  _S647 : ptr<function, vec3<f32>>)
{
    var _S648 : u32 = u32(146) + u32(4) * _S641;
    var _S649 : f32 = openness_number_0(_S640, _S648 + u32(1));
    var _S650 : f32 = openness_number_0(_S640, _S648 + u32(2));
    var _S651 : vec3<f32> = vec3<f32>(1.0f);
    var _S652 : vec3<f32> = _S651 - _S644 * vec3<f32>(openness_number_0(_S640, _S648));
    var _S653 : vec3<f32> = _S651 - _S645 * vec3<f32>(openness_number_0(_S640, _S648 + u32(3)));
    var _S654 : vec3<f32> = _S651 / (_S652 * _S653 - _S644 * _S645 * vec3<f32>((_S649 * _S650)));
    (*_S646) = (_S642 * _S653 + _S644 * vec3<f32>(_S649) * _S643) * _S654;
    (*_S647) = (_S643 * _S652 + _S645 * vec3<f32>(_S650) * _S642) * _S654;
    return;
}

fn face_sends_0( _S655 : u32,  _S656 : u32,  _S657 : Scattered_0,  _S658 : Scattered_0) -> FaceSends_0
{
    var _S659 : u32 = u32(2) * _S656;
    var _S660 : u32 = u32(142) + _S659;
    var _S661 : f32 = openness_number_0(_S655, _S660);
    var _S662 : f32 = openness_number_0(_S655, _S660 + u32(1));
    var _S663 : vec3<f32> = vec3<f32>((1.0f - _S661)) * _S657.back_4;
    var _S664 : vec3<f32> = vec3<f32>((1.0f - _S662)) * _S658.back_4;
    var sends_1 : FaceSends_0;
    var _S665 : u32 = u32(154) + _S659;
    var _S666 : f32 = openness_number_0(_S655, _S665);
    sends_1.blocks_warp_0 = _S666;
    var _S667 : f32 = openness_number_0(_S655, _S665 + u32(1));
    sends_1.blocks_weft_0 = _S667;
    sends_1.open_0 = _S666 * _S661 + _S667 * _S662;
    var _S668 : vec3<f32> = vec3<f32>(_S661) * _S657.back_4;
    var _S669 : vec3<f32> = vec3<f32>(_S662) * _S658.back_4;
    var _S670 : vec3<f32> = sends_1.sky_warp_0;
    var _S671 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S655, _S656, _S668, _S669, _S663, _S664, &(_S670), &(_S671));
    sends_1.sky_warp_0 = _S670;
    sends_1.sky_weft_0 = _S671;
    var _S672 : vec3<f32> = sends_1.crossing_warp_0;
    var _S673 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S655, _S656, _S657.through_0, _S658.through_0, _S663, _S664, &(_S672), &(_S673));
    sends_1.crossing_warp_0 = _S672;
    sends_1.crossing_weft_0 = _S673;
    return sends_1;
}

fn interior_of_0( _S674 : u32,  _S675 : vec3<f32>,  _S676 : bool) -> Interior_0
{
    var _S677 : Scattered_0 = scattered_by_0(_S674, table_albedos_0(families_0[fabrics_0[_S674].warp_0].colour_mean_0), u32(0), _S675);
    var _S678 : Scattered_0 = scattered_by_0(_S674, table_albedos_0(families_0[fabrics_0[_S674].weft_0].colour_mean_0), u32(1), _S675);
    var _S679 : FaceSends_0 = face_sends_0(_S674, select(u32(0), u32(1), _S676), _S677, _S678);
    var _S680 : FaceSends_0 = face_sends_0(_S674, select(u32(1), u32(0), _S676), _S677, _S678);
    var _S681 : vec3<f32> = vec3<f32>(_S679.blocks_warp_0);
    var _S682 : vec3<f32> = vec3<f32>(_S679.blocks_weft_0);
    var _S683 : vec3<f32> = _S681 * _S679.crossing_warp_0 + _S682 * _S679.crossing_weft_0;
    var _S684 : vec3<f32> = vec3<f32>(_S680.blocks_warp_0);
    var _S685 : vec3<f32> = vec3<f32>(_S680.blocks_weft_0);
    var _S686 : vec3<f32> = _S684 * _S680.crossing_warp_0 + _S685 * _S680.crossing_weft_0;
    var _S687 : f32 = 1.0f - _S679.open_0;
    var _S688 : f32 = 1.0f - _S680.open_0;
    var _S689 : vec3<f32> = vec3<f32>(1.0f);
    var _S690 : vec3<f32> = _S689 / (_S689 - _S683 * _S686 * vec3<f32>((_S687 * _S688)));
    var _S691 : vec3<f32> = _S686 * (vec3<f32>(_S679.open_0) + vec3<f32>(_S687) * (_S681 * _S679.sky_warp_0 + _S682 * _S679.sky_weft_0)) * _S690;
    var _S692 : vec3<f32> = _S683 * (vec3<f32>(_S680.open_0) + vec3<f32>(_S688) * (_S684 * _S680.sky_warp_0 + _S685 * _S680.sky_weft_0)) * _S690;
    var _S693 : FaceRadiance_0 = face_radiance_0(_S679, _S680.open_0, _S691, _S692);
    var _S694 : FaceRadiance_0 = face_radiance_0(_S680, _S679.open_0, _S692, _S691);
    var interior_1 : Interior_0;
    interior_1.warp_5 = _S693.warp_4;
    interior_1.weft_5 = _S693.weft_4;
    interior_1.leaked_1 = _S693.leaked_0;
    interior_1.far_1 = _S694.mean_1;
    interior_1.far_leaked_0 = _S694.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S695 : u32,  _S696 : u32,  _S697 : array<f32, i32(6)>,  _S698 : u32) -> Blocked_0
{
    var shares_2 : array<f32, i32(3)>;
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
        shares_2[share_2] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S698)
            {
            }
            else
            {
                break;
            }
            shares_2[share_2] = shares_2[share_2] + openness_number_0(_S695, _S696 + share_2 * _S698 + term_0) * _S697[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_2[share_2] = saturate(shares_2[share_2]);
        share_2 = share_2 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_2[i32(0)] * shares_2[i32(2)];
    blocked_2.by_weft_0 = shares_2[i32(0)] * (1.0f - shares_2[i32(2)]);
    blocked_2.far_0 = shares_2[i32(1)];
    return blocked_2;
}

fn blocked_from_0( _S699 : u32,  _S700 : vec3<f32>,  _S701 : bool,  _S702 : bool) -> Blocked_0
{
    var terms_2 : array<f32, i32(6)>;
    view_terms_0(_S700, &(terms_2));
    return blocked_of_terms_0(_S699, (select(u32(0), u32(2), _S702) + select(u32(1), u32(0), _S701)) * u32(15), terms_2, u32(5));
}

fn warp_seen_from_0( _S703 : u32,  _S704 : vec3<f32>,  _S705 : bool) -> f32
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_1(_S704, &(terms_3));
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
        var share_4 : f32 = share_3 + openness_number_0(_S703, u32(132) + select(u32(0), u32(5), _S705) + term_1) * terms_3[term_1];
        term_1 = term_1 + u32(1);
        share_3 = share_4;
    }
    return saturate(share_3);
}

fn bounced_of_families_0( _S706 : u32,  _S707 : FamilyAlbedos_0,  _S708 : vec3<f32>,  _S709 : Interior_0,  _S710 : Blocked_0,  _S711 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S710, scattered_by_0(_S706, _S707.warp_6, u32(0), _S708), _S709), bounced_by_0(_S711, scattered_by_0(_S706, _S707.weft_6, u32(1), _S708), _S709));
}

fn bounced_far_0( _S712 : u32,  _S713 : FamilyAlbedos_0,  _S714 : vec3<f32>,  _S715 : Interior_0,  _S716 : vec3<f32>,  _S717 : bool,  _S718 : f32,  _S719 : f32,  _S720 : f32) -> Bounced_0
{
    var _S721 : Blocked_0 = blocked_from_0(_S712, _S716, true, _S717);
    var _S722 : Blocked_0 = blocked_from_0(_S712, _S716, false, _S717);
    var _S723 : f32 = _S718 / max(1.0f - _S721.by_warp_0 - _S721.by_weft_0, 0.10000000149011612f);
    var _S724 : f32 = (0.0020000000949949f * warp_seen_from_0(_S712, _S716, _S717) + _S723) / (_S723 + _S719 / max(1.0f - _S722.by_warp_0 - _S722.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S725 : f32 = 1.0f - _S720;
    return bounced_of_families_0(_S712, _S713, _S714, _S715, scaled_0(_S721, _S724 * _S725), scaled_0(_S722, (1.0f - _S724) * _S725));
}

fn bounced_over_0( _S726 : u32,  _S727 : Components_0,  _S728 : CloseUp_0,  _S729 : FamilyAlbedos_0,  _S730 : vec3<f32>,  _S731 : vec3<f32>) -> Bounced_0
{
    var _S732 : bool = (_S731.z) < 0.0f;
    var _S733 : Interior_0 = interior_of_0(_S726, _S730, _S732);
    var bounced_2 : Bounced_0 = bounced_far_0(_S726, _S729, _S730, _S733, to_face_frame_0(_S731, _S732), _S732, _S727.diffuse_warp_0, _S727.diffuse_weft_0, _S727.hole_2);
    if((_S728.weight_2) > 0.0f)
    {
        var _S734 : Bounced_0 = bounced_of_families_0(_S726, _S729, _S730, _S733, _S728.warp_3, _S728.weft_3);
        var _S735 : vec3<f32> = vec3<f32>(_S728.weight_2);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S734.reflected_0, _S735);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S734.transmitted_0, _S735);
    }
    return bounced_2;
}

fn composed_0( _S736 : u32,  _S737 : Components_0,  _S738 : CloseUp_0,  _S739 : FamilyAlbedos_0,  _S740 : vec3<f32>,  _S741 : vec3<f32>,  _S742 : vec3<f32>) -> vec3<f32>
{
    var _S743 : Albedos_0 = tinted_0(_S739.warp_6, _S740);
    var _S744 : Albedos_0 = tinted_0(_S739.weft_6, _S740);
    var _S745 : vec3<f32> = vec3<f32>(_S737.diffuse_warp_0);
    var _S746 : vec3<f32> = vec3<f32>(_S737.diffuse_weft_0);
    var _S747 : vec3<f32> = vec3<f32>(_S737.specular_warp_0);
    var _S748 : vec3<f32> = vec3<f32>(_S737.specular_weft_0);
    var _S749 : vec3<f32> = _S743.diffuse_reflect_0 * _S745 + _S744.diffuse_reflect_0 * _S746 + _S743.specular_reflect_0 * _S747 + _S744.specular_reflect_0 * _S748;
    var _S750 : f32 = _S742.z;
    var body_0 : vec3<f32>;
    if((_S741.z * _S750) < 0.0f)
    {
        body_0 = _S743.diffuse_transmit_0 * _S745 + _S744.diffuse_transmit_0 * _S746 + _S743.specular_transmit_0 * _S747 + _S744.specular_transmit_0 * _S748;
    }
    else
    {
        body_0 = _S749;
    }
    if((fabrics_0[_S736].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S736, _S737, _S738, _S739, _S740, _S742), _S741, _S742);
    }
    var _S751 : f32 = fabrics_0[_S736].sheen_strength_0;
    if((fabrics_0[_S736].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S752 : bool = _S750 < 0.0f;
    var _S753 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S741, _S752), to_face_frame_0(_S742, _S752), _S751, fabrics_0[_S736].sheen_roughness_0);
    return vec3<f32>(_S753.y) * body_0 + vec3<f32>(((_S737.light_visibility_1 + _S737.hole_2) * _S753.x));
}

fn light_of_neural_0( _S754 : u32,  _S755 : VisiblePoint_0,  _S756 : vec2<u32>,  _S757 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.dx_0 = _S755.draft_dx_0;
    footprint_1.dy_0 = _S755.draft_dy_0;
    footprint_1.centre_0 = irregular_place_0(_S754, _S755.draft_0, Footprint_spread_side_0(footprint_1));
    var _S758 : vec3<f32> = to_local_0(_S755, _S755.view_0);
    var activations_0 : NeuralView_0;
    neural_view_0(_S754, footprint_1, _S758, &(activations_0));
    var _S759 : f32 = _S758.z;
    var _S760 : FamilyAlbedos_0 = with_tones_0(_S754, albedos_over_0(_S754, footprint_1, _S759 < 0.0f), activations_0.yarns_0);
    var _S761 : vec3<f32> = vec3<f32>(0.0f);
    var number_8 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S761;
    for(;;)
    {
        if(number_8 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S762 : f32 = visibility_at_0(number_8, _S756);
        if(_S762 <= 0.0f)
        {
            number_8 = number_8 + u32(1);
            continue;
        }
        var _S763 : LightSample_0 = light_sample_0(number_8, _S756, _S755.position_4);
        var _S764 : vec3<f32> = to_local_0(_S755, _S763.towards_0);
        var _S765 : Components_0 = neural_components_0(_S754, &(activations_0), _S764);
        radiance_1 = radiance_1 + vec3<f32>(_S762) * _S763.irradiance_1 * composed_0(_S754, _S765, no_close_up_0(), _S760, _S757, _S764, _S758);
        number_8 = number_8 + u32(1);
    }
    var hole_3 : f32 = activations_0.hole_0;
    var _S766 : f32 = fabrics_0[_S754].sheen_strength_0;
    var hole_4 : f32;
    if((fabrics_0[_S754].sheen_strength_0) > 0.0f)
    {
        hole_4 = hole_3 * (1.0f - _S766 * sheen_lobe_0(abs(_S759), fabrics_0[_S754].sheen_roughness_0).z);
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
    var _S767 : u32 = id_0.x;
    var _S768 : bool;
    if(_S767 >= (frame_record_0.width_0))
    {
        _S768 = true;
    }
    else
    {
        _S768 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S768)
    {
        return;
    }
    var _S769 : u32 = id_0.y * frame_record_0.width_0 + _S767;
    var _S770 : u32 = layers_0[_S769].face_0;
    if((layers_0[_S769].face_0) == u32(0))
    {
        return;
    }
    var _S771 : u32 = _S770 - u32(1);
    var _S772 : u32 = fabric_of_0(_S771);
    var _S773 : vec2<u32> = id_0.xy;
    var _S774 : VisiblePoint_0 = visible_point_0(_S772, _S771, _S773);
    accumulate_0(_S769, light_of_neural_0(_S772, _S774, _S773, filtered_albedo_0(_S772, _S774)));
    return;
}

