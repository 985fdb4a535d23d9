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

@binding(3) @group(0) var<storage, read> packed_numbers_0 : array<vec4<u32>>;

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

fn square_1( x_4 : f32) -> f32
{
    return x_4 * x_4;
}

fn natural_logarithm_0( x_5 : f32) -> f32
{
    var _S140 : u32 = (bitcast<u32>((x_5)));
    var m_0 : f32 = (bitcast<f32>(((((_S140 & (u32(8388607)))) | (u32(1056964608))))));
    var _S141 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S140 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S141);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S141) - 1.0f;
    var _S142 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S142 - exponent_0 * 0.00021219444170129f - 0.5f * _S142) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_6 : f32) -> f32
{
    return natural_logarithm_0(x_6) * 1.4426950216293335f;
}

fn exponential_0( x_7 : f32) -> f32
{
    var _S143 : f32 = clamp(x_7, -87.0f, 88.0f);
    var _S144 : f32 = floor(_S143 * 1.4426950216293335f + 0.5f);
    var _S145 : f32 = _S143 - _S144 * 0.693359375f + _S144 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S145 + 0.00139819993637502f) * _S145 + 0.00833345204591751f) * _S145 + 0.04166579619050026f) * _S145 + 0.1666666567325592f) * _S145 + 0.5f) * _S145 * _S145 + _S145 + 1.0f) * (bitcast<f32>(((u32(i32(_S144) + i32(127)) << (u32(23)))))), 0.0f, x_7 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S146 : u32 = scene_words_0[index_0];
    var _S147 : vec3<f32> = vec3<f32>(f32((_S146 & (u32(1023)))), f32((((_S146 >> (u32(10)))) & (u32(1023)))), f32((_S146 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S147 * _S147;
}

fn map_level_0( first_20 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S148 : f32 = uv_0.x;
    var _S149 : f32 = f32(side_0);
    var _S150 : f32 = (_S148 - floor(_S148)) * _S149 - 0.5f;
    var _S151 : f32 = uv_0.y;
    var _S152 : f32 = (_S151 - floor(_S151)) * _S149 - 0.5f;
    var _S153 : f32 = floor(_S150);
    var _S154 : i32 = i32(side_0);
    var _S155 : u32 = side_0 - u32(1);
    var _S156 : u32 = (u32(i32(_S153) + _S154) & (_S155));
    var _S157 : f32 = floor(_S152);
    var _S158 : u32 = (u32(i32(_S157) + _S154) & (_S155));
    var _S159 : u32 = ((_S156 + u32(1)) & (_S155));
    var _S160 : u32 = first_20 + _S158 * side_0;
    var _S161 : vec3<f32> = vec3<f32>((_S150 - _S153));
    var _S162 : u32 = first_20 + (((_S158 + u32(1)) & (_S155))) * side_0;
    return mix(mix(map_texel_0(_S160 + _S156), map_texel_0(_S160 + _S159), _S161), mix(map_texel_0(_S162 + _S156), map_texel_0(_S162 + _S159), _S161), vec3<f32>((_S152 - _S157)));
}

struct VisiblePoint_0
{
     position_0 : vec3<f32>,
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

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn row_of_taps_0( footprint_0 : Footprint_0) -> vec3<f32>
{
    var _S163 : f32 = footprint_0.dx_0.x;
    var _S164 : f32 = footprint_0.dy_0.x;
    var _S165 : f32 = _S163 * _S163 + _S164 * _S164;
    var _S166 : f32 = footprint_0.dx_0.y;
    var _S167 : f32 = footprint_0.dy_0.y;
    var _S168 : f32 = _S166 * _S166 + _S167 * _S167;
    var _S169 : f32 = _S163 * _S166 + _S164 * _S167;
    var _S170 : f32 = 0.5f * (_S165 - _S168);
    var _S171 : f32 = 0.5f * (_S165 + _S168);
    var _S172 : f32 = sqrt(_S170 * _S170 + _S169 * _S169);
    var _S173 : f32 = _S171 + _S172;
    var _S174 : f32 = max(_S173 - 1.5f * max(_S171 - _S172, 0.0f), 0.0f);
    var _S175 : f32 = square_1(4.0f);
    var _S176 : f32 = max(_S171 - 0.5f * _S174, _S173 / _S175);
    var _S177 : f32 = sqrt(max(min(_S174, _S173 - _S176), 0.0f) / (_S175 - 1.0f));
    var _S178 : f32 = _S170 / max(_S172, 1.00000000317107685e-30f);
    var _S179 : f32 = sqrt(max(0.5f * (1.0f - _S178), 0.0f));
    return vec3<f32>(sqrt(_S176), _S177 * sqrt(max(0.5f * (1.0f + _S178), 0.0f)), select(_S177 * _S179, - _S177 * _S179, _S169 < 0.0f));
}

struct AnisotropicTaps_0
{
     centre_1 : vec2<f32>,
     side_1 : f32,
     first_21 : vec2<f32>,
     second_0 : vec2<f32>,
};

fn AnisotropicTaps_size_0( this_2 : AnisotropicTaps_0) -> f32
{
    var _S180 : f32 = this_2.first_21.x;
    var _S181 : f32 = this_2.second_0.x;
    var _S182 : f32 = this_2.side_1;
    var _S183 : f32 = _S182 * _S182;
    var _S184 : f32 = this_2.first_21.y;
    var _S185 : f32 = this_2.second_0.y;
    var _S186 : f32 = 12.0f * (_S180 * _S184 + _S181 * _S185);
    return sqrt(sqrt(max((12.0f * (_S180 * _S180 + _S181 * _S181) + _S183) * (12.0f * (_S184 * _S184 + _S185 * _S185) + _S183) - _S186 * _S186, square_1(_S183))));
}

fn footprint_coordinates_0( taps_0 : AnisotropicTaps_0) -> vec3<f32>
{
    return vec3<f32>(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S187 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S187, - _S187, back_2));
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn wrapped_0( index_2 : f32,  count_1 : f32) -> f32
{
    return select(select(index_2, index_2 - count_1, index_2 >= count_1), index_2 + count_1, index_2 < 0.0f);
}

fn AnisotropicTaps_has_steps_0( this_3 : AnisotropicTaps_0) -> bool
{
    var _S188 : vec2<f32> = this_3.first_21;
    var _S189 : vec2<f32> = this_3.second_0;
    return (max(dot(_S188, _S188), dot(_S189, _S189))) > 0.0f;
}

fn AnisotropicTaps_place_0( this_4 : AnisotropicTaps_0,  number_0 : u32) -> vec2<f32>
{
    return this_4.centre_1 + vec2<f32>(select(-1.0f, 1.0f, number_0 >= u32(2))) * this_4.first_21 + vec2<f32>(select(-1.0f, 1.0f, ((number_0 & (u32(1)))) != u32(0))) * this_4.second_0;
}

fn bump_0( distance_0 : f32) -> f32
{
    var _S190 : f32 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S190 * _S190;
}

fn correction_weight_of_0( coded_size_0 : f32) -> f32
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

fn turns_and_remainder_0( family_0 : u32,  index_3 : f32) -> vec2<f32>
{
    var _S191 : f32 = floor(fma(index_3, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S191, fma(- _S191, families_0[family_0].count_0, index_3));
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
    var _S192 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S193 : f32 = fma(- _S192, families_0[family_1].size_0, position_1);
    cell_0.below_0 = _S193;
    cell_0.above_0 = families_0[family_1].size_0 - _S193;
    cell_0.across_0 = _S193 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S192).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S194 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S195 : u32 = min(thread_1 + select(u32(0), u32(1), _S194 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S196 : u32 = families_0[family_2].place_table_0 + _S195 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S195;
    cell_1.below_0 = _S194 - table_number_0(_S196);
    cell_1.above_0 = table_number_0(_S196 + u32(1)) - _S194;
    cell_1.across_0 = _S194 - table_number_0(_S196 + u32(2));
    cell_1.half_width_1 = table_number_0(_S196 + u32(3));
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
    var _S197 : Cell_0 = locate_0(family_4, position_4);
    var _S198 : f32 = table_number_0(families_0[family_4].before_0 + u32(2) * _S197.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_2 = _S197.thread_0;
    bound_0.turns_2 = round((position_4 - families_0[family_4].start_0 - _S198 - _S197.below_0) * families_0[family_4].inverse_period_0);
    bound_0.cell_2 = _S197.below_0;
    var _S199 : f32 = 2.0f * _S197.half_width_1;
    bound_0.width_2 = _S199;
    bound_0.visible_0 = clamp((_S197.across_0 + _S197.half_width_1) / _S199, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S197.below_0, _S197.below_0 - _S197.across_0 - _S197.half_width_1) + max(_S197.across_0 - _S197.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_7 : Bound_0,
     high_7 : Bound_0,
};

fn stretch_of_0( family_5 : u32,  centre_2 : f32,  size_1 : f32) -> Stretch_0
{
    var _S200 : f32 = centre_2 - floor((centre_2 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    var _S201 : f32 = 0.5f * max(size_1, families_0[family_5].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_7 = bound_at_0(family_5, _S200 - _S201);
    stretch_0.high_7 = bound_at_0(family_5, _S200 + _S201);
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
    var _S202 : f32 = Stretch_turns_0(stretch_1);
    var _S203 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.low_7.thread_2;
    var _S204 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.high_7.thread_2;
    var _S205 : f32 = table_number_0(_S204) - table_number_0(_S203);
    var _S206 : f32 = table_number_0(_S204 + u32(1)) - table_number_0(_S203 + u32(1));
    return vec3<f32>(_S205 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_2 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_2 + _S202 * families_0[family_6].visible_total_0, _S206 - _S205 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S202 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S206 + stretch_1.high_7.cell_2 - stretch_1.low_7.cell_2 + _S202 * families_0[family_6].period_0);
}

fn integrals_along_0( family_7 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S207 : u32 = u32(3) * families_0[family_7].quantities_0;
    var _S208 : u32 = families_0[family_7].colour_threads_0 + _S207 * stretch_2.low_7.thread_2 + quantity_0;
    var _S209 : u32 = families_0[family_7].colour_threads_0 + _S207 * stretch_2.high_7.thread_2 + quantity_0;
    var _S210 : u32 = families_0[family_7].colour_threads_0 + _S207 * u32(families_0[family_7].count_0) + quantity_0;
    var _S211 : f32 = table_number_0(_S208);
    var _S212 : f32 = table_number_0(_S209);
    var _S213 : f32 = Stretch_turns_0(stretch_2);
    var _S214 : u32 = u32(2) * families_0[family_7].quantities_0;
    return vec2<f32>(table_number_0(_S209 + families_0[family_7].quantities_0) - table_number_0(_S208 + families_0[family_7].quantities_0) + _S212 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_2 - _S211 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_2 + _S213 * table_number_0(_S210 + families_0[family_7].quantities_0), table_number_0(_S209 + _S214) - table_number_0(_S208 + _S214) + _S212 * stretch_2.high_7.cell_2 - _S211 * stretch_2.low_7.cell_2 + _S213 * table_number_0(_S210 + _S214));
}

fn Stretch_wraps_0( this_6 : Stretch_0) -> bool
{
    return (this_6.high_7.thread_2) < (this_6.low_7.thread_2);
}

fn Stretch_differences_0( this_7 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S215 : u32 = entries_0.z;
    var _S216 : u32 = entries_0.x;
    return vec4<u32>(_S215 - _S216 + select(u32(0), whole_0, Stretch_wraps_0(this_7)), entries_0.w - _S215, entries_0.y - _S216, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_7 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S217 : u32 = row_7 + across_1.low_7.thread_2 * quantities_1;
    var _S218 : u32 = row_7 + across_1.high_7.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S217], words_0[_S217 + quantities_1], words_0[_S218], words_0[_S218 + quantities_1]), words_0[row_7 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_8 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_8.high_7.visible_0, - this_8.low_7.visible_0, Stretch_turns_0(this_8) - select(0.0f, 1.0f, Stretch_wraps_0(this_8)));
}

fn integral_on_top_0( family_8 : u32,  across_2 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S219 : u32 = u32(families_0[family_8].count_0);
    var _S220 : u32 = (_S219 + u32(1)) * families_0[family_8].quantities_0;
    var _S221 : u32 = families_0[family_8].colour_areas_0 + quantity_1;
    var _S222 : vec4<u32> = row_differences_0(across_2, _S221 + along_0.low_7.thread_2 * _S220, _S219, families_0[family_8].quantities_0);
    var _S223 : vec4<u32> = row_differences_0(across_2, _S221 + along_0.high_7.thread_2 * _S220, _S219, families_0[family_8].quantities_0);
    var _S224 : vec4<u32> = row_differences_0(across_2, _S221 + crossing_count_0 * _S220, _S219, families_0[family_8].quantities_0);
    var _S225 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S223 - _S222 + select_vector_3(Stretch_wraps_0(along_0), _S224, vec4<u32>(vec4<i32>(i32(0)))))), _S225), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S221 + (along_0.high_7.thread_2 + u32(1)) * _S220, _S219, families_0[family_8].quantities_0) - _S223)), _S225), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S221 + (along_0.low_7.thread_2 + u32(1)) * _S220, _S219, families_0[family_8].quantities_0) - _S222)), _S225), dot(vec4<f32>(vec4<i32>(_S224)), _S225)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_8 : u32) -> Albedos_0
{
    var _S226 : Albedos_0 = table_albedos_0(row_8);
    var sum_0 : Albedos_0;
    var _S227 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S227 * _S226.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S227 * _S226.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S227 * _S226.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S227 * _S226.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_9 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S228 : vec3<f32> = lengths_0(crossing_0, other_0);
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
        var _S229 : vec2<f32> = integrals_along_0(family_9, own_0, quantity_2);
        var _S230 : f32 = integral_on_top_0(family_9, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S231 : f32 = _S229.x;
        var _S232 : f32 = _S231 * _S228.x;
        var _S233 : f32 = select(_S230, _S232 - _S230, back_3);
        var _S234 : bool = quantity_2 == u32(0);
        if(_S234)
        {
            is_exposed_0 = _S233 > (16.0f * families_0[family_9].area_unit_0 * min(_S232 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S232);
        }
        var _S235 : f32 = _S231 * _S228.y + select(0.0f, _S233, is_exposed_0) + 0.000244140625f * _S228.z * _S229.y;
        if(_S234)
        {
            weight_1 = 1.0f / max(_S235, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S235 * weight_1, families_0[family_9].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
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
    var _S236 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S237 : u32 = ((((_S236 >> ((((_S236 >> (u32(28)))) + u32(4))))) ^ (_S236))) * u32(277803737);
    return (((_S237 >> (u32(22)))) ^ (_S237));
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
    var _S238 : u32 = pixel_0.x;
    var _S239 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S238, _S239, stream_2), uniform_hash_0(_S238, _S239, stream_2 + u32(1))) + vec2<f32>(f32((index_5 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
        var _S240 : u32 = (low_8 + high_8) / u32(2);
        if((scene_number_0(table_0 + _S240)) <= number_1)
        {
            low_8 = _S240;
        }
        else
        {
            high_8 = _S240;
        }
    }
    var _S241 : u32 = table_0 + low_8;
    var _S242 : f32 = scene_number_0(_S241);
    var _S243 : f32 = scene_number_0(_S241 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_7 = low_8;
    choice_0.remainder_0 = saturate((number_1 - _S242) / max(_S243 - _S242, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_8 : f32) -> vec2<f32>
{
    var _S244 : f32 = floor(x_8 * 0.63661974668502808f + 0.5f);
    var _S245 : f32 = x_8 - _S244 * 1.5703125f - _S244 * 0.00048375129699707f - _S244 * 7.54979012640433211e-08f;
    var _S246 : f32 = _S245 * _S245;
    var _S247 : f32 = ((-0.00019515295571182f * _S246 + 0.00833216123282909f) * _S246 - 0.16666655242443085f) * _S246 * _S245 + _S245;
    var _S248 : f32 = ((0.00002443315679557f * _S246 - 0.00138873164542019f) * _S246 + 0.04166664555668831f) * _S246 * _S246 - 0.5f * _S246 + 1.0f;
    var _S249 : u32 = (u32(i32(_S244)) & (u32(3)));
    var _S250 : vec2<f32> = select_vector_1(((_S249 & (u32(1)))) != u32(0), vec2<f32>(_S248, _S247), vec2<f32>(_S247, _S248));
    var _S251 : f32 = _S250.x;
    var _S252 : f32 = _S250.y;
    return vec2<f32>(select(_S251, - _S251, ((_S249 & (u32(2)))) != u32(0)), select(_S252, - _S252, (((_S249 + u32(1)) & (u32(2)))) != u32(0)));
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
    var _S253 : f32 = max(abs(light_1.z), 0.00100000004749745f);
    var _S254 : vec2<f32> = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S253, (0.59700000286102295f * _S253 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S254, view_1.xy) * rsqrt_0(max(dot(_S254, _S254), 9.99999997475242708e-07f))) + 1.0f), blend_0);
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
    var _S255 : Blocked_0 = no_blocked_0();
    nothing_1.warp_1 = _S255;
    nothing_1.weft_1 = _S255;
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
    var _S256 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S257 : vec3<f32> = sends_0.sky_warp_0 + _S256 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S257;
    var _S258 : vec3<f32> = sends_0.sky_weft_0 + _S256 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S258;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S257 + vec3<f32>(sends_0.blocks_weft_0) * _S258;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S259 : f32 = 1.0f - view_2.z;
    var _S260 : f32 = _S259 * _S259;
    (*terms_0)[i32(0)] = 1.0f;
    var _S261 : f32 = view_2.x;
    var _S262 : f32 = _S261 * _S261;
    var _S263 : f32 = view_2.y;
    var _S264 : f32 = _S263 * _S263;
    (*terms_0)[i32(1)] = sqrt(max(_S262 + _S264, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S260;
    (*terms_0)[i32(3)] = _S260 * _S260;
    (*terms_0)[i32(4)] = _S262 - _S264;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_3 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S265 : f32 = 1.0f - view_3.z;
    var _S266 : f32 = _S265 * _S265;
    (*terms_1)[i32(0)] = 1.0f;
    var _S267 : f32 = view_3.x;
    var _S268 : f32 = _S267 * _S267;
    var _S269 : f32 = view_3.y;
    var _S270 : f32 = _S269 * _S269;
    (*terms_1)[i32(1)] = sqrt(max(_S268 + _S270, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S266;
    (*terms_1)[i32(3)] = _S266 * _S266;
    (*terms_1)[i32(4)] = _S268 - _S270;
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
    var _S271 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S272 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_3) + _S272 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S272 * interior_0.far_1 + yarn_0.back_4 * _S271;
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
    var _S273 : f32 = light_2.z;
    return select_vector_2((_S273 * view_4.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S273) * 0.31830987334251404f));
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
    var _S274 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S275 : f32 = 2.0f * sqrt(_S274) - 1.0f;
    var _S276 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S275, _S276), 0.00999999977648258f, 1.0f), clamp((1.0f - _S274) * sheen_shear_0(_S275, _S276), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S275, _S276), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_5 : vec3<f32>,  scale_1 : f32,  shear_0 : f32) -> f32
{
    var _S277 : f32 = light_3.z;
    if(((_S277 <= 0.0f) | (((view_5.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S278 : vec2<f32> = view_5.xy;
    var _S279 : f32 = dot(_S278, _S278);
    var _S280 : vec2<f32> = select_vector_1(_S279 > 9.99999968265522539e-21f, _S278 * vec2<f32>(rsqrt_0(max(_S279, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S281 : f32 = scale_1 * dot(light_3.xy, _S280) + shear_0 * _S277;
    var _S282 : f32 = scale_1 * (light_3.y * _S280.x - light_3.x * _S280.y);
    var _S283 : f32 = _S281 * _S281 + _S282 * _S282 + _S277 * _S277;
    return 0.31830987334251404f * scale_1 * scale_1 * _S277 / max(_S283 * _S283, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  strength_0 : f32,  roughness_2 : f32) -> vec2<f32>
{
    var _S284 : vec3<f32> = sheen_lobe_0(view_6.z, roughness_2);
    var _S285 : f32 = strength_0 * _S284.z;
    return vec2<f32>(_S285 * transformed_cosine_0(light_4, view_6, _S284.x, _S284.y), 1.0f - _S285);
}

fn accumulate_0( index_8 : u32,  light_5 : vec4<f32>)
{
    var _S286 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_5;
    layers_0[index_8].share_0 = _S286 * (1.0f - light_5.w);
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

fn face_point_0( _S287 : u32,  _S288 : u32,  _S289 : f32,  _S290 : f32) -> VisiblePoint_0
{
    var _S291 : u32 = u32(3) * _S288;
    var _S292 : Vertex_0 = vertex_at_0(_S291);
    var _S293 : Vertex_0 = vertex_at_0(_S291 + u32(1));
    var _S294 : Vertex_0 = vertex_at_0(_S291 + u32(2));
    var _S295 : vec3<f32> = position_of_0(_S292);
    var _S296 : vec3<f32> = position_of_0(_S293) - _S295;
    var _S297 : vec3<f32> = position_of_0(_S294) - _S295;
    var _S298 : f32 = _S293.u_0 - _S292.u_0;
    var _S299 : f32 = _S293.v_0 - _S292.v_0;
    var _S300 : vec2<f32> = vec2<f32>(_S298, _S299);
    var _S301 : f32 = _S294.u_0 - _S292.u_0;
    var _S302 : f32 = _S294.v_0 - _S292.v_0;
    var _S303 : vec2<f32> = vec2<f32>(_S301, _S302);
    var _S304 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S298 * _S302 - _S299 * _S301) < 0.0f));
    var _S305 : vec3<f32> = _S304 * (vec3<f32>(_S302) * _S296 - vec3<f32>(_S299) * _S297);
    var _S306 : vec3<f32> = _S304 * (vec3<f32>(_S298) * _S297 - vec3<f32>(_S301) * _S296);
    var point_1 : VisiblePoint_0;
    var _S307 : vec3<f32> = vec3<f32>(_S289);
    var _S308 : vec3<f32> = vec3<f32>(_S290);
    var _S309 : vec3<f32> = normalize(vec3<f32>((1.0f - _S289 - _S290)) * normal_of_0(_S292) + _S307 * normal_of_0(_S293) + _S308 * normal_of_0(_S294));
    point_1.normal_0 = _S309;
    var _S310 : vec3<f32> = normalize(_S305 - _S309 * vec3<f32>(dot(_S309, _S305)));
    point_1.axis_x_0 = _S310;
    point_1.axis_y_0 = cross(_S309, _S310);
    var _S311 : vec3<f32> = normalize(cross(_S296, _S297));
    point_1.face_normal_0 = select_vector_2((dot(_S311, _S309)) < 0.0f, (vec3<f32>(0) - _S311), _S311);
    point_1.position_0 = _S295 + _S307 * _S296 + _S308 * _S297;
    point_1.view_0 = _S309;
    var _S312 : vec2<f32> = vec2<f32>(_S292.u_0, _S292.v_0) + vec2<f32>(_S289) * _S300 + vec2<f32>(_S290) * _S303;
    point_1.uv_1 = _S312;
    var _S313 : bool = (dot(cross(_S305, _S306), _S309)) < 0.0f;
    var _S314 : vec2<f32> = vec2<f32>(fabrics_0[_S287].uv_width_0, select(fabrics_0[_S287].uv_height_0, - fabrics_0[_S287].uv_height_0, _S313));
    point_1.draft_per_uv_0 = _S314;
    point_1.draft_0 = _S312 * _S314 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S287].uv_height_0, _S313));
    var _S315 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S315;
    point_1.draft_dy_0 = _S315;
    return point_1;
}

fn visible_point_0( _S316 : u32,  _S317 : u32,  _S318 : vec2<u32>) -> VisiblePoint_0
{
    var _S319 : u32 = u32(3) * _S317;
    var _S320 : Vertex_0 = vertex_at_0(_S319);
    var _S321 : Vertex_0 = vertex_at_0(_S319 + u32(1));
    var _S322 : Vertex_0 = vertex_at_0(_S319 + u32(2));
    var _S323 : vec3<f32> = position_of_0(_S320);
    var _S324 : vec3<f32> = position_of_0(_S321) - _S323;
    var _S325 : vec3<f32> = position_of_0(_S322) - _S323;
    var _S326 : vec3<f32> = cross(_S324, _S325);
    var _S327 : f32 = f32(frame_record_0.width_0);
    var _S328 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S327));
    var _S329 : f32 = f32(frame_record_0.height_0);
    var _S330 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S329));
    var _S331 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S318.x) + 0.5f - 0.5f * _S327)) * _S328 + vec3<f32>((f32(_S318.y) + 0.5f - 0.5f * _S329)) * _S330;
    var _S332 : f32 = dot(_S331, _S326);
    var _S333 : f32 = 1.0f / select(1.00000000317107685e-30f, _S332, (abs(_S332)) > 1.00000000317107685e-30f);
    var _S334 : vec3<f32> = _S323 - camera_origin_0();
    var _S335 : vec3<f32> = vec3<f32>((dot(_S334, _S326) * _S333));
    var _S336 : vec3<f32> = _S331 * _S335 - _S334;
    var _S337 : vec3<f32> = _S335 * (_S328 - _S331 * vec3<f32>((dot(_S328, _S326) * _S333)));
    var _S338 : vec3<f32> = _S335 * (_S330 - _S331 * vec3<f32>((dot(_S330, _S326) * _S333)));
    var _S339 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S326), 1.00000000317107685e-30f)));
    var _S340 : vec3<f32> = cross(_S325, _S326) * _S339;
    var _S341 : vec3<f32> = cross(_S326, _S324) * _S339;
    var _S342 : vec2<f32> = vec2<f32>(_S321.u_0 - _S320.u_0, _S321.v_0 - _S320.v_0);
    var _S343 : vec2<f32> = vec2<f32>(_S322.u_0 - _S320.u_0, _S322.v_0 - _S320.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S316, _S317, dot(_S336, _S340), dot(_S336, _S341));
    point_2.position_0 = _S323 + _S336;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S331));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S337, _S340)) * _S342 + vec2<f32>(dot(_S337, _S341)) * _S343) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S338, _S340)) * _S342 + vec2<f32>(dot(_S338, _S341)) * _S343) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S344 : u32,  _S345 : VisiblePoint_0) -> vec3<f32>
{
    var _S346 : u32 = fabrics_0[_S344].albedo_map_levels_0;
    if((fabrics_0[_S344].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S347 : vec2<f32> = vec2<f32>(fabrics_0[_S344].uv_width_0, fabrics_0[_S344].uv_height_0);
    var _S348 : vec2<f32> = _S345.draft_dx_0 / _S347;
    var _S349 : vec2<f32> = _S345.draft_dy_0 / _S347;
    var _S350 : u32 = _S346 - u32(1);
    var _S351 : u32 = (u32(1) << (_S350));
    var _S352 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S348.x * _S349.y - _S348.y * _S349.x), 9.99999968265522539e-21f) * (square_1(f32(_S351)) / 3.0f)), 0.0f, f32(_S346) - 1.0f);
    var _S353 : u32 = min(u32(_S352), max(_S346, u32(2)) - u32(2));
    var _S354 : u32 = min(_S353 + u32(1), _S350);
    var _S355 : u32 = (u32(1) << ((u32(2) * _S346)));
    return mix(map_level_0(fabrics_0[_S344].albedo_map_0 + (_S355 - ((_S355 >> ((u32(2) * _S353))))) / u32(3), (_S351 >> (_S353)), _S345.uv_1), map_level_0(fabrics_0[_S344].albedo_map_0 + (_S355 - ((_S355 >> ((u32(2) * _S354))))) / u32(3), (_S351 >> (_S354)), _S345.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S352 - f32(_S353))) - 1.0f) / 3.0f)));
}

struct NeuralView_0
{
     sums_7 : array<f32, i32(96)>,
     hole_0 : f32,
     correction_weight_0 : f32,
     view_7 : vec3<f32>,
     back_5 : bool,
};

fn anisotropic_taps_0( _S356 : u32,  _S357 : Footprint_0) -> AnisotropicTaps_0
{
    var _S358 : vec3<f32> = row_of_taps_0(_S357);
    var _S359 : vec2<f32> = _S357.dx_0;
    var _S360 : vec2<f32> = _S357.dy_0;
    var _S361 : f32 = dot(_S359, _S359) + dot(_S360, _S360);
    var _S362 : f32 = _S357.dx_0.x * _S357.dy_0.y - _S357.dx_0.y * _S357.dy_0.x;
    var _S363 : f32 = 0.5f * (_S361 + sqrt(max(_S361 * _S361 - 4.0f * _S362 * _S362, 0.0f)));
    var _S364 : bool = ((_S363 < (5.5f * (_S361 - _S363))) & ((_S361 > (8.0f * fabrics_0[_S356].neural_0.pitch_0 * fabrics_0[_S356].neural_0.pitch_0))));
    var _S365 : vec2<f32> = vec2<f32>(fabrics_0[_S356].neural_0.ends_per_mm_0, fabrics_0[_S356].neural_0.picks_per_mm_0);
    var taps_1 : AnisotropicTaps_0;
    taps_1.centre_1 = _S357.centre_0 * _S365;
    taps_1.side_1 = select(_S358.x, sqrt(0.125f * _S361), _S364) / fabrics_0[_S356].neural_0.pitch_0;
    var _S366 : vec2<f32> = vec2<f32>(0.25f);
    var _S367 : vec2<f32> = _S358.yz;
    taps_1.first_21 = select_vector_1(_S364, _S366 * _S357.dx_0, _S367) * _S365;
    taps_1.second_0 = select_vector_1(_S364, _S366 * _S357.dy_0, vec2<f32>(0.5f) * _S367) * _S365;
    return taps_1;
}

fn add_texel_0( _S368 : u32,  _S369 : u32,  _S370 : f32,  _S371 : ptr<function, array<f32, i32(88)>>)
{
    var _S372 : u32 = fabrics_0[_S368].neural_0.latents_0 + _S369 * u32(8);
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
        var _S373 : Eight_0 = eight_halves_0(packed_numbers_0[_S372 + part_0]);
        var _S374 : i32 = i32(u32(8) * part_0);
        (*_S371)[_S374] = (*_S371)[_S374] + _S370 * _S373.low_0[i32(0)];
        (*_S371)[_S374 + i32(4)] = (*_S371)[_S374 + i32(4)] + _S370 * _S373.high_0[i32(0)];
        var _S375 : i32 = _S374 + i32(1);
        (*_S371)[_S375] = (*_S371)[_S375] + _S370 * _S373.low_0[i32(1)];
        (*_S371)[_S375 + i32(4)] = (*_S371)[_S375 + i32(4)] + _S370 * _S373.high_0[i32(1)];
        var _S376 : i32 = _S374 + i32(2);
        (*_S371)[_S376] = (*_S371)[_S376] + _S370 * _S373.low_0[i32(2)];
        (*_S371)[_S376 + i32(4)] = (*_S371)[_S376 + i32(4)] + _S370 * _S373.high_0[i32(2)];
        var _S377 : i32 = _S374 + i32(3);
        (*_S371)[_S377] = (*_S371)[_S377] + _S370 * _S373.low_0[i32(3)];
        (*_S371)[_S377 + i32(4)] = (*_S371)[_S377 + i32(4)] + _S370 * _S373.high_0[i32(3)];
        part_0 = part_0 + u32(1);
    }
    return;
}

fn add_level_0( _S378 : u32,  _S379 : u32,  _S380 : bool,  _S381 : vec2<f32>,  _S382 : f32,  _S383 : ptr<function, array<f32, i32(88)>>)
{
    var _S384 : Neural_std430_0 = fabrics_0[_S378].neural_0;
    var _S385 : u32 = fabrics_0[_S378].neural_0.levels_1 + u32(4) * _S379;
    var _S386 : f32 = table_number_0(_S385);
    var _S387 : f32 = table_number_0(_S385 + u32(1));
    var _S388 : f32 = table_number_0(_S385 + u32(2));
    var _S389 : vec2<f32> = _S381 * vec2<f32>(table_number_0(_S385 + u32(3))) - vec2<f32>(select(0.5f, 1.0f, ((_S379 > u32(3)) & ((_S379 < (fabrics_0[_S378].neural_0.top_level_0))))));
    var _S390 : vec2<f32> = floor(_S389);
    var _S391 : vec2<f32> = _S389 - _S390;
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
        var _S392 : f32 = f32((corner_1 & (u32(1))));
        var _S393 : f32 = f32((corner_1 >> (u32(1))));
        var _S394 : vec2<f32> = mix(vec2<f32>(1.0f) - _S391, _S391, vec2<f32>(_S392, _S393));
        add_texel_0(_S378, u32(_S386 + wrapped_0(_S390.y + _S393, _S388) * _S387 + wrapped_0(_S390.x + _S392, _S387)) + select(u32(0), _S384.texels_0, _S380), _S382 * _S394.x * _S394.y, &((*_S383)));
        corner_1 = corner_1 + u32(1);
    }
    return;
}

fn code_footprint_0( _S395 : u32,  _S396 : AnisotropicTaps_0,  _S397 : vec3<f32>,  _S398 : bool,  _S399 : ptr<function, array<f32, i32(88)>>)
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
        (*_S399)[k_0] = 0.0f;
        k_0 = k_0 + i32(1);
    }
    var _S400 : vec2<f32> = vec2<f32>(fabrics_0[_S395].neural_0.ends_0, fabrics_0[_S395].neural_0.picks_0);
    var _S401 : f32 = f32(fabrics_0[_S395].neural_0.top_level_0);
    var _S402 : f32 = clamp(binary_logarithm_0(max(_S396.side_1, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S401);
    var _S403 : f32 = min(floor(_S402), _S401 - 1.0f);
    var _S404 : u32 = select(u32(1), u32(4), AnisotropicTaps_has_steps_0(_S396));
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(number_2 < (u32(2) * _S404))
        {
        }
        else
        {
            break;
        }
        var _S405 : vec2<f32> = AnisotropicTaps_place_0(_S396, (number_2 >> (u32(1))));
        var _S406 : bool = ((number_2 & (u32(1)))) != u32(0);
        var _S407 : f32 = _S402 - _S403;
        add_level_0(_S395, u32(_S403) + select(u32(0), u32(1), _S406), _S398, clamp(_S405 - _S400 * floor(_S405 / _S400), vec2<f32>(0.0f), _S400), select(1.0f - _S407, _S407, _S406) / f32(_S404), &((*_S399)));
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
            var offset_1 : f32 = _S397[number_3] - (f32(bin_0) + 0.5f) / 8.0f;
            var offset_2 : f32;
            if(number_3 < i32(2))
            {
                offset_2 = offset_1 - round(offset_1);
            }
            else
            {
                offset_2 = offset_1;
            }
            (*_S399)[i32(64) + number_3 * i32(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + i32(1);
        }
        number_3 = number_3 + i32(1);
    }
    return;
}

fn crown_fibres_0( _S408 : u32,  _S409 : bool,  _S410 : bool) -> vec3<f32>
{
    if(_S409)
    {
        return vec3<f32>(select(1.0f, -1.0f, _S410) * fabrics_0[_S408].neural_0.warp_x_0, fabrics_0[_S408].neural_0.warp_y_0, fabrics_0[_S408].neural_0.warp_roughness_0);
    }
    return vec3<f32>(fabrics_0[_S408].neural_0.weft_x_0, select(1.0f, -1.0f, _S410) * fabrics_0[_S408].neural_0.weft_y_0, fabrics_0[_S408].neural_0.weft_roughness_0);
}

fn neural_view_0( _S411 : u32,  _S412 : Footprint_0,  _S413 : vec3<f32>,  _S414 : ptr<function, NeuralView_0>)
{
    var _S415 : bool = (_S413.z) < 0.0f;
    var _S416 : AnisotropicTaps_0 = anisotropic_taps_0(_S411, _S412);
    var _S417 : vec3<f32> = footprint_coordinates_0(_S416);
    var _S418 : vec3<f32> = to_face_frame_0(_S413, _S415);
    var weights_23 : HalfWeights_0;
    weights_23.first_2 = fabrics_0[_S411].neural_0.network_0;
    var inputs_23 : array<f32, i32(88)>;
    code_footprint_0(_S411, _S416, _S417, _S415, &(inputs_23));
    var hidden_1 : array<f32, i32(96)>;
    dense_7(weights_23, u32(0), false, &(inputs_23), &(hidden_1));
    var fused_0 : array<f32, i32(100)>;
    dense_part_8(weights_23, u32(1068), false, &(hidden_1), &(fused_0));
    fused_0[i32(96)] = _S418.x;
    fused_0[i32(97)] = _S418.y;
    var _S419 : vec2<f32> = _S418.xy;
    fused_0[i32(98)] = dot(crown_fibres_0(_S411, true, _S415).xy, _S419);
    fused_0[i32(99)] = dot(crown_fibres_0(_S411, false, _S415).xy, _S419);
    var of_hole_0 : array<f32, i32(16)>;
    dense_6(weights_23, u32(2232), false, &(fused_0), &(of_hole_0));
    var hole_1 : array<f32, i32(1)>;
    dense_5(weights_23, u32(2444), false, &(of_hole_0), &(hole_1));
    var _S420 : array<f32, i32(96)> = (*_S414).sums_7;
    dense_4(weights_23, u32(2456), false, &(fused_0), &(_S420));
    (*_S414).sums_7 = _S420;
    (*_S414).hole_0 = clamp(hole_1[i32(0)], 0.0f, 1.0f);
    (*_S414).correction_weight_0 = correction_weight_of_0(_S417.z);
    (*_S414).view_7 = _S418;
    (*_S414).back_5 = _S415;
    return;
}

struct FamilyAlbedos_0
{
     warp_4 : Albedos_0,
     weft_4 : Albedos_0,
};

fn albedos_over_0( _S421 : u32,  _S422 : Footprint_0,  _S423 : bool) -> FamilyAlbedos_0
{
    var _S424 : vec2<f32> = _S422.dx_0;
    var _S425 : vec2<f32> = _S422.dy_0;
    var _S426 : vec2<f32> = sqrt(_S424 * _S424 + _S425 * _S425);
    var _S427 : Stretch_0 = stretch_of_0(fabrics_0[_S421].warp_0, _S422.centre_0.x, _S426.x);
    var _S428 : Stretch_0 = stretch_of_0(fabrics_0[_S421].weft_0, _S422.centre_0.y, _S426.y);
    var albedos_4 : FamilyAlbedos_0;
    albedos_4.warp_4 = mean_albedos_0(fabrics_0[_S421].warp_0, fabrics_0[_S421].weft_0, _S427, _S428, _S423);
    albedos_4.weft_4 = mean_albedos_0(fabrics_0[_S421].weft_0, fabrics_0[_S421].warp_0, _S428, _S427, _S423);
    return albedos_4;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S429 : u32,  _S430 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S429 * frame_record_0.height_0 + _S430.y) * frame_record_0.width_0 + _S430.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S431 : u32,  _S432 : u32) -> vec3<f32>
{
    var _S433 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S431 * frame_record_0.environment_columns_0 + _S432);
    return vec3<f32>(scene_number_0(_S433), scene_number_0(_S433 + u32(1)), scene_number_0(_S433 + u32(2)));
}

fn sample_environment_0( _S434 : vec2<f32>,  _S435 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S436 : u32 = frame_record_0.environment_rows_0;
    var _S437 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S434.y);
    var _S438 : u32 = frame_record_0.environment_columns_0;
    var _S439 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S437.index_7 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S434.x);
    var _S440 : vec3<f32> = environment_texel_0(_S437.index_7, _S439.index_7);
    (*_S435) = _S440 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S440), 9.99999968265522539e-21f)));
    var _S441 : f32 = 3.14159274101257324f / f32(_S436);
    var _S442 : f32 = mix(sine_cosine_0(f32(_S437.index_7) * _S441).y, sine_cosine_0(f32(_S437.index_7 + u32(1)) * _S441).y, _S437.remainder_0);
    var _S443 : f32 = sqrt(max(1.0f - _S442 * _S442, 0.0f));
    var _S444 : vec2<f32> = sine_cosine_0((f32(_S439.index_7) + _S439.remainder_0) * (6.28318548202514648f / f32(_S438)));
    var _S445 : f32 = _S443 * _S444.x;
    var _S446 : f32 = - _S443 * _S444.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S445 + frame_record_0.environment_sine_0 * _S446, _S442, frame_record_0.environment_cosine_0 * _S446 - frame_record_0.environment_sine_0 * _S445);
}

fn light_sample_0( _S447 : u32,  _S448 : vec2<u32>,  _S449 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S450 : u32 = frame_record_0.lights_0;
    if(_S447 >= (frame_record_0.lights_0))
    {
        var weight_3 : vec3<f32>;
        var _S451 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S448, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S447 - _S450), u32(3)), &(weight_3));
        sample_0.towards_0 = _S451;
        sample_0.irradiance_1 = weight_3 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S452 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S447);
    sample_0.irradiance_1 = vec3<f32>(_S452.red_0, _S452.green_0, _S452.blue_0);
    sample_0.towards_0 = vec3<f32>(_S452.x_9, _S452.y_1, _S452.z_1);
    if((_S452.is_point_0) != u32(0))
    {
        var _S453 : vec3<f32> = sample_0.towards_0 - _S449;
        var _S454 : f32 = max(square_0(_S453), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S454);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S454);
        sample_0.towards_0 = normalize(_S453);
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

fn code_light_0( _S455 : u32,  _S456 : vec3<f32>,  _S457 : vec3<f32>,  _S458 : bool,  _S459 : ptr<function, array<f32, i32(39)>>)
{
    (*_S459)[i32(0)] = _S456.x;
    (*_S459)[i32(1)] = _S456.y;
    (*_S459)[i32(2)] = _S456.z;
    var _S460 : vec3<f32> = _S456 + _S457;
    var _S461 : f32 = _S460.z;
    var _S462 : f32 = _S461 * _S461 + 0.00009999999747379f;
    var _S463 : vec2<f32> = _S460.xy;
    var _S464 : f32 = 1.0f / (dot(_S463, _S463) + _S462);
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
        var _S465 : vec3<f32> = crown_fibres_0(_S455, family_10 == i32(0), _S458);
        var _S466 : vec2<f32> = _S465.xy;
        (*_S459)[i32(3) + family_10] = dot(_S466, _S456.xy);
        var _S467 : f32 = dot(_S466, _S463);
        var _S468 : f32 = _S467 * _S467;
        var _S469 : f32 = (0.75f * _S467 / (0.5f * sqrt(_S468 + _S462) + abs(_S467)) + 0.5f) * 8.0f;
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
            (*_S459)[i32(5) + family_10 * i32(16) + bin_1] = bump_0(_S469 - (f32(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + i32(1);
        }
        var _S470 : f32 = _S465.z;
        var _S471 : f32 = _S470 * _S470;
        var _S472 : f32 = _S468 * _S464 * (1.0f - _S471) + _S471;
        (*_S459)[i32(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S471 * _S470 / (_S472 * _S472));
        family_10 = family_10 + i32(1);
    }
    return;
}

fn mixed_bundles_0( _S473 : u32,  _S474 : u32,  _S475 : u32,  _S476 : vec3<f32>,  _S477 : vec3<f32>,  _S478 : bool,  _S479 : ptr<function, array<f32, i32(52)>>) -> f32
{
    var _S480 : vec3<f32> = _S476 + _S477;
    var _S481 : f32 = 1.0f / (square_0(_S480) + 0.00009999999747379f);
    var _S482 : f32 = _S480.x;
    var _S483 : f32 = select(_S482, - _S482, ((_S474 == u32(0)) & (_S478)));
    var _S484 : f32 = _S480.y;
    var _S485 : f32 = select(_S484, - _S484, ((_S474 == u32(1)) & (_S478)));
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
        var _S486 : u32 = _S474 * u32(25);
        var _S487 : u32 = fabrics_0[_S473].neural_0.bundles_0 + u32(4) * (_S486 + bundle_1);
        var _S488 : f32 = dot(vec3<f32>(table_number_0(_S487), table_number_0(_S487 + u32(1)), table_number_0(_S487 + u32(2))), vec3<f32>(_S483, _S485, _S480.z));
        var _S489 : f32 = _S488 * _S488 * _S481 + table_number_0(_S487 + u32(3));
        var sum_3 : f32 = sum_2 + max((*_S479)[_S475 + _S486 + select(bundle_1, mirrored_bundle_0(bundle_1), _S478)], (*_S479)[_S475 + _S486 + select(bundle_1, mirrored_bundle_0(bundle_1), _S478)] * 0.00999999977648258f) / (_S489 * _S489);
        bundle_1 = bundle_1 + u32(1);
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

fn neural_components_0( _S490 : u32,  _S491 : ptr<function, NeuralView_0>,  _S492 : vec3<f32>) -> Components_0
{
    var _S493 : bool = (*_S491).back_5;
    var _S494 : vec3<f32> = to_face_frame_0(_S492, (*_S491).back_5);
    var _S495 : vec3<f32> = (*_S491).view_7;
    var weights_24 : HalfWeights_0;
    var _S496 : Neural_std430_0 = fabrics_0[_S490].neural_0;
    weights_24.first_2 = fabrics_0[_S490].neural_0.network_0;
    var directions_0 : array<f32, i32(39)>;
    code_light_0(_S490, _S494, (*_S491).view_7, (*_S491).back_5, &(directions_0));
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
        skip_0[k_1] = (*_S491).sums_7[k_1];
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
    var _S497 : bool;
    if((_S496.is_corrected_0) != u32(0))
    {
        _S497 = (_S494.z) > 0.0f;
    }
    else
    {
        _S497 = false;
    }
    if(_S497)
    {
        _S497 = ((*_S491).correction_weight_0) > 0.0f;
    }
    else
    {
        _S497 = false;
    }
    if(_S497)
    {
        var fitted_0 : FloatWeights_0;
        fitted_0.first_0 = _S496.correction_0;
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
            outputs_17[k_1 + i32(2)] = outputs_17[k_1 + i32(2)] + (*_S491).correction_weight_0 * change_0[k_1];
            k_1 = k_1 + i32(1);
        }
    }
    var _S498 : f32 = select(0.00100000004749745f, 0.00999999977648258f, (_S494.z) > 0.0f);
    var result_2 : Components_0;
    var _S499 : f32 = unmapped_0(outputs_17[i32(0)], _S498);
    result_2.diffuse_warp_0 = _S499;
    var _S500 : f32 = unmapped_0(outputs_17[i32(1)], _S498);
    result_2.diffuse_weft_0 = _S500;
    var _S501 : f32 = 2979.9580078125f * _S498;
    var _S502 : f32 = mixed_bundles_0(_S490, u32(0), u32(2), _S494, _S495, _S493, &(outputs_17));
    result_2.specular_warp_0 = clamp(_S502, 0.0f, _S501);
    var _S503 : f32 = mixed_bundles_0(_S490, u32(1), u32(2), _S494, _S495, _S493, &(outputs_17));
    result_2.specular_weft_0 = clamp(_S503, 0.0f, _S501);
    result_2.hole_2 = (*_S491).hole_0;
    result_2.light_visibility_1 = min(light_visibility_of_0(_S499 + _S500, _S494, _S495, fabrics_0[_S490].diffuse_blend_0), 1.0f - (*_S491).hole_0);
    return result_2;
}

fn openness_number_0( _S504 : u32,  _S505 : u32) -> f32
{
    return table_number_0(fabrics_0[_S504].openness_0 + _S505);
}

fn scattered_by_0( _S506 : u32,  _S507 : Albedos_0,  _S508 : u32,  _S509 : vec3<f32>) -> Scattered_0
{
    var _S510 : u32 = u32(159) + u32(2) * _S508;
    var yarn_1 : Scattered_0;
    yarn_1.back_4 = _S509 * _S507.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S506, _S510)) * _S507.specular_reflect_0;
    yarn_1.through_0 = _S509 * _S507.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S506, _S510 + u32(1))) * _S507.specular_transmit_0;
    return yarn_1;
}

fn sent_0( _S511 : u32,  _S512 : u32,  _S513 : vec3<f32>,  _S514 : vec3<f32>,  _S515 : vec3<f32>,  _S516 : vec3<f32>,  _S517 : ptr<function, vec3<f32>>,  _S518 : ptr<function, vec3<f32>>)
{
    var _S519 : u32 = u32(146) + u32(4) * _S512;
    var _S520 : f32 = openness_number_0(_S511, _S519 + u32(1));
    var _S521 : f32 = openness_number_0(_S511, _S519 + u32(2));
    var _S522 : vec3<f32> = vec3<f32>(1.0f);
    var _S523 : vec3<f32> = _S522 - _S515 * vec3<f32>(openness_number_0(_S511, _S519));
    var _S524 : vec3<f32> = _S522 - _S516 * vec3<f32>(openness_number_0(_S511, _S519 + u32(3)));
    var _S525 : vec3<f32> = _S522 / (_S523 * _S524 - _S515 * _S516 * vec3<f32>((_S520 * _S521)));
    (*_S517) = (_S513 * _S524 + _S515 * vec3<f32>(_S520) * _S514) * _S525;
    (*_S518) = (_S514 * _S523 + _S516 * vec3<f32>(_S521) * _S513) * _S525;
    return;
}

fn face_sends_0( _S526 : u32,  _S527 : u32,  _S528 : Scattered_0,  _S529 : Scattered_0) -> FaceSends_0
{
    var _S530 : u32 = u32(2) * _S527;
    var _S531 : u32 = u32(142) + _S530;
    var _S532 : f32 = openness_number_0(_S526, _S531);
    var _S533 : f32 = openness_number_0(_S526, _S531 + u32(1));
    var _S534 : vec3<f32> = vec3<f32>((1.0f - _S532)) * _S528.back_4;
    var _S535 : vec3<f32> = vec3<f32>((1.0f - _S533)) * _S529.back_4;
    var sends_1 : FaceSends_0;
    var _S536 : u32 = u32(154) + _S530;
    var _S537 : f32 = openness_number_0(_S526, _S536);
    sends_1.blocks_warp_0 = _S537;
    var _S538 : f32 = openness_number_0(_S526, _S536 + u32(1));
    sends_1.blocks_weft_0 = _S538;
    sends_1.open_0 = _S537 * _S532 + _S538 * _S533;
    var _S539 : vec3<f32> = vec3<f32>(_S532) * _S528.back_4;
    var _S540 : vec3<f32> = vec3<f32>(_S533) * _S529.back_4;
    var _S541 : vec3<f32> = sends_1.sky_warp_0;
    var _S542 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S526, _S527, _S539, _S540, _S534, _S535, &(_S541), &(_S542));
    sends_1.sky_warp_0 = _S541;
    sends_1.sky_weft_0 = _S542;
    var _S543 : vec3<f32> = sends_1.crossing_warp_0;
    var _S544 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S526, _S527, _S528.through_0, _S529.through_0, _S534, _S535, &(_S543), &(_S544));
    sends_1.crossing_warp_0 = _S543;
    sends_1.crossing_weft_0 = _S544;
    return sends_1;
}

fn interior_of_0( _S545 : u32,  _S546 : vec3<f32>,  _S547 : bool) -> Interior_0
{
    var _S548 : Scattered_0 = scattered_by_0(_S545, table_albedos_0(families_0[fabrics_0[_S545].warp_0].colour_mean_0), u32(0), _S546);
    var _S549 : Scattered_0 = scattered_by_0(_S545, table_albedos_0(families_0[fabrics_0[_S545].weft_0].colour_mean_0), u32(1), _S546);
    var _S550 : FaceSends_0 = face_sends_0(_S545, select(u32(0), u32(1), _S547), _S548, _S549);
    var _S551 : FaceSends_0 = face_sends_0(_S545, select(u32(1), u32(0), _S547), _S548, _S549);
    var _S552 : vec3<f32> = vec3<f32>(_S550.blocks_warp_0);
    var _S553 : vec3<f32> = vec3<f32>(_S550.blocks_weft_0);
    var _S554 : vec3<f32> = _S552 * _S550.crossing_warp_0 + _S553 * _S550.crossing_weft_0;
    var _S555 : vec3<f32> = vec3<f32>(_S551.blocks_warp_0);
    var _S556 : vec3<f32> = vec3<f32>(_S551.blocks_weft_0);
    var _S557 : vec3<f32> = _S555 * _S551.crossing_warp_0 + _S556 * _S551.crossing_weft_0;
    var _S558 : f32 = 1.0f - _S550.open_0;
    var _S559 : f32 = 1.0f - _S551.open_0;
    var _S560 : vec3<f32> = vec3<f32>(1.0f);
    var _S561 : vec3<f32> = _S560 / (_S560 - _S554 * _S557 * vec3<f32>((_S558 * _S559)));
    var _S562 : vec3<f32> = _S557 * (vec3<f32>(_S550.open_0) + vec3<f32>(_S558) * (_S552 * _S550.sky_warp_0 + _S553 * _S550.sky_weft_0)) * _S561;
    var _S563 : vec3<f32> = _S554 * (vec3<f32>(_S551.open_0) + vec3<f32>(_S559) * (_S555 * _S551.sky_warp_0 + _S556 * _S551.sky_weft_0)) * _S561;
    var _S564 : FaceRadiance_0 = face_radiance_0(_S550, _S551.open_0, _S562, _S563);
    var _S565 : FaceRadiance_0 = face_radiance_0(_S551, _S550.open_0, _S563, _S562);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S564.warp_2;
    interior_1.weft_3 = _S564.weft_2;
    interior_1.leaked_1 = _S564.leaked_0;
    interior_1.far_1 = _S565.mean_1;
    interior_1.far_leaked_0 = _S565.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S566 : u32,  _S567 : u32,  _S568 : array<f32, i32(6)>,  _S569 : u32) -> Blocked_0
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
            if(term_0 < _S569)
            {
            }
            else
            {
                break;
            }
            shares_0[share_2] = shares_0[share_2] + openness_number_0(_S566, _S567 + share_2 * _S569 + term_0) * _S568[term_0];
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

fn blocked_from_0( _S570 : u32,  _S571 : vec3<f32>,  _S572 : bool,  _S573 : bool) -> Blocked_0
{
    var terms_2 : array<f32, i32(6)>;
    view_terms_0(_S571, &(terms_2));
    return blocked_of_terms_0(_S570, (select(u32(0), u32(2), _S573) + select(u32(1), u32(0), _S572)) * u32(15), terms_2, u32(5));
}

fn warp_seen_from_0( _S574 : u32,  _S575 : vec3<f32>,  _S576 : bool) -> f32
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_1(_S575, &(terms_3));
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
        var share_4 : f32 = share_3 + openness_number_0(_S574, u32(132) + select(u32(0), u32(5), _S576) + term_1) * terms_3[term_1];
        term_1 = term_1 + u32(1);
        share_3 = share_4;
    }
    return saturate(share_3);
}

fn bounced_of_families_0( _S577 : u32,  _S578 : FamilyAlbedos_0,  _S579 : vec3<f32>,  _S580 : Interior_0,  _S581 : Blocked_0,  _S582 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S581, scattered_by_0(_S577, _S578.warp_4, u32(0), _S579), _S580), bounced_by_0(_S582, scattered_by_0(_S577, _S578.weft_4, u32(1), _S579), _S580));
}

fn bounced_far_0( _S583 : u32,  _S584 : FamilyAlbedos_0,  _S585 : vec3<f32>,  _S586 : Interior_0,  _S587 : vec3<f32>,  _S588 : bool,  _S589 : f32,  _S590 : f32,  _S591 : f32) -> Bounced_0
{
    var _S592 : Blocked_0 = blocked_from_0(_S583, _S587, true, _S588);
    var _S593 : Blocked_0 = blocked_from_0(_S583, _S587, false, _S588);
    var _S594 : f32 = _S589 / max(1.0f - _S592.by_warp_0 - _S592.by_weft_0, 0.10000000149011612f);
    var _S595 : f32 = (0.0020000000949949f * warp_seen_from_0(_S583, _S587, _S588) + _S594) / (_S594 + _S590 / max(1.0f - _S593.by_warp_0 - _S593.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S596 : f32 = 1.0f - _S591;
    return bounced_of_families_0(_S583, _S584, _S585, _S586, scaled_0(_S592, _S595 * _S596), scaled_0(_S593, (1.0f - _S595) * _S596));
}

fn bounced_over_0( _S597 : u32,  _S598 : Components_0,  _S599 : CloseUp_0,  _S600 : FamilyAlbedos_0,  _S601 : vec3<f32>,  _S602 : vec3<f32>) -> Bounced_0
{
    var _S603 : bool = (_S602.z) < 0.0f;
    var _S604 : Interior_0 = interior_of_0(_S597, _S601, _S603);
    var bounced_2 : Bounced_0 = bounced_far_0(_S597, _S600, _S601, _S604, to_face_frame_0(_S602, _S603), _S603, _S598.diffuse_warp_0, _S598.diffuse_weft_0, _S598.hole_2);
    if((_S599.weight_2) > 0.0f)
    {
        var _S605 : Bounced_0 = bounced_of_families_0(_S597, _S600, _S601, _S604, _S599.warp_1, _S599.weft_1);
        var _S606 : vec3<f32> = vec3<f32>(_S599.weight_2);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S605.reflected_0, _S606);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S605.transmitted_0, _S606);
    }
    return bounced_2;
}

fn composed_0( _S607 : u32,  _S608 : Components_0,  _S609 : CloseUp_0,  _S610 : FamilyAlbedos_0,  _S611 : vec3<f32>,  _S612 : vec3<f32>,  _S613 : vec3<f32>) -> vec3<f32>
{
    var _S614 : Albedos_0 = tinted_0(_S610.warp_4, _S611);
    var _S615 : Albedos_0 = tinted_0(_S610.weft_4, _S611);
    var _S616 : vec3<f32> = vec3<f32>(_S608.diffuse_warp_0);
    var _S617 : vec3<f32> = vec3<f32>(_S608.diffuse_weft_0);
    var _S618 : vec3<f32> = vec3<f32>(_S608.specular_warp_0);
    var _S619 : vec3<f32> = vec3<f32>(_S608.specular_weft_0);
    var _S620 : vec3<f32> = _S614.diffuse_reflect_0 * _S616 + _S615.diffuse_reflect_0 * _S617 + _S614.specular_reflect_0 * _S618 + _S615.specular_reflect_0 * _S619;
    var _S621 : f32 = _S613.z;
    var body_0 : vec3<f32>;
    if((_S612.z * _S621) < 0.0f)
    {
        body_0 = _S614.diffuse_transmit_0 * _S616 + _S615.diffuse_transmit_0 * _S617 + _S614.specular_transmit_0 * _S618 + _S615.specular_transmit_0 * _S619;
    }
    else
    {
        body_0 = _S620;
    }
    if((fabrics_0[_S607].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S607, _S608, _S609, _S610, _S611, _S613), _S612, _S613);
    }
    var _S622 : f32 = fabrics_0[_S607].sheen_strength_0;
    if((fabrics_0[_S607].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S623 : bool = _S621 < 0.0f;
    var _S624 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S612, _S623), to_face_frame_0(_S613, _S623), _S622, fabrics_0[_S607].sheen_roughness_0);
    return vec3<f32>(_S624.y) * body_0 + vec3<f32>(((_S608.light_visibility_1 + _S608.hole_2) * _S624.x));
}

fn light_of_neural_0( _S625 : u32,  _S626 : VisiblePoint_0,  _S627 : vec2<u32>,  _S628 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.centre_0 = _S626.draft_0;
    footprint_1.dx_0 = _S626.draft_dx_0;
    footprint_1.dy_0 = _S626.draft_dy_0;
    var _S629 : vec3<f32> = to_local_0(_S626, _S626.view_0);
    var activations_0 : NeuralView_0;
    neural_view_0(_S625, footprint_1, _S629, &(activations_0));
    var _S630 : f32 = _S629.z;
    var _S631 : FamilyAlbedos_0 = albedos_over_0(_S625, footprint_1, _S630 < 0.0f);
    var _S632 : vec3<f32> = vec3<f32>(0.0f);
    var number_4 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S632;
    for(;;)
    {
        if(number_4 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S633 : f32 = visibility_at_0(number_4, _S627);
        if(_S633 <= 0.0f)
        {
            number_4 = number_4 + u32(1);
            continue;
        }
        var _S634 : LightSample_0 = light_sample_0(number_4, _S627, _S626.position_0);
        var _S635 : vec3<f32> = to_local_0(_S626, _S634.towards_0);
        var _S636 : Components_0 = neural_components_0(_S625, &(activations_0), _S635);
        radiance_1 = radiance_1 + vec3<f32>(_S633) * _S634.irradiance_1 * composed_0(_S625, _S636, no_close_up_0(), _S631, _S628, _S635, _S629);
        number_4 = number_4 + u32(1);
    }
    var hole_3 : f32 = activations_0.hole_0;
    var _S637 : f32 = fabrics_0[_S625].sheen_strength_0;
    var hole_4 : f32;
    if((fabrics_0[_S625].sheen_strength_0) > 0.0f)
    {
        hole_4 = hole_3 * (1.0f - _S637 * sheen_lobe_0(abs(_S630), fabrics_0[_S625].sheen_roughness_0).z);
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
    var _S638 : u32 = id_0.x;
    var _S639 : bool;
    if(_S638 >= (frame_record_0.width_0))
    {
        _S639 = true;
    }
    else
    {
        _S639 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S639)
    {
        return;
    }
    var _S640 : u32 = id_0.y * frame_record_0.width_0 + _S638;
    var _S641 : u32 = layers_0[_S640].face_0;
    if((layers_0[_S640].face_0) == u32(0))
    {
        return;
    }
    var _S642 : u32 = _S641 - u32(1);
    var _S643 : u32 = fabric_of_0(_S642);
    var _S644 : vec2<u32> = id_0.xy;
    var _S645 : VisiblePoint_0 = visible_point_0(_S643, _S642, _S644);
    accumulate_0(_S640, light_of_neural_0(_S643, _S645, _S644, filtered_albedo_0(_S643, _S645)));
    return;
}

